//! Random terrains and hands, made to meet what is rare: ties, cliffs, holes, rims and jumps.

use super::trial::is_on_map;
use oracle::terrain::{Random, grid_with_cells};
use surface::{ByteOrder, Grid, GridLayout, GridPoint, Metric, SampleType};

/// What a random ground is made of.
#[derive(Clone, Copy, Debug)]
pub struct Ground {
    pub columns: usize,
    pub rows: usize,
    /// Metres from the lowest to the highest sample.
    pub relief: f64,
    /// How many different heights there are; 0 for as many as there are numbers.
    pub levels: usize,
    /// Rather than random, a plane: metres for a column and for a row.
    pub plane: Option<[f64; 2]>,
    /// Share of the samples that are void.
    pub voids: f64,
    pub wraps: bool,
}

impl Ground {
    /// Of independent heights.
    pub fn noise(columns: usize, rows: usize, relief: f64) -> Self {
        Self { columns, rows, relief, levels: 0, plane: None, voids: 0.0, wraps: false }
    }

    pub fn grid(&self, random: &mut Random) -> Grid {
        let heights: Vec<f64> = (0..self.columns * self.rows)
            .map(|sample| {
                let height = self.height(random, sample % self.columns, sample / self.columns);
                if random.unit() < self.voids { f64::NAN } else { height }
            })
            .collect();
        let columns = self.columns;
        grid_with_cells(self.rows, columns, [1.0, 1.0], self.wraps, |column, row| {
            heights[row * columns + column]
        })
    }

    fn height(&self, random: &mut Random, column: usize, row: usize) -> f64 {
        if let Some([east, south]) = self.plane {
            return east * column as f64 + south * row as f64;
        }
        let height = if self.levels > 1 {
            random.below(self.levels) as f64 / (self.levels - 1) as f64
        } else {
            random.unit()
        };
        self.relief * height
    }
}

/// A ground of 16-bit samples at both ends of their range, side by side.
pub fn cliffs(columns: usize, rows: usize, random: &mut Random) -> Grid {
    let samples = (0..columns * rows).map(|_| [i16::MIN, i16::MAX, 0, -1][random.below(4)]);
    let bytes = samples.flat_map(i16::to_be_bytes).collect();
    let (sample, order) = (SampleType::I16, ByteOrder::Big);
    let layout = GridLayout::packed(rows as u64, columns as u64, 1.0, 1.0, sample, order).unwrap();
    Grid::from_vec(bytes, layout).unwrap()
}

/// A hand that drifts, jumps, rests, and likes exact places.
pub struct RandomHand {
    pub random: Random,
    /// Cells an update.
    pub speed: f64,
    /// How deep under the surface it goes, and how high over it, cells.
    pub reach: f64,
    goal: GridPoint,
    heading: f64,
}

impl RandomHand {
    pub fn new(grid: &Grid, speed: f64, reach: f64, seed: u64) -> Self {
        let mut random = Random::new(seed);
        let layout = grid.layout();
        let column = random.between(0.0, f64::from(layout.columns() - 1));
        let row = random.between(0.0, f64::from(layout.rows() - 1));
        let heading = random.between(0.0, std::f64::consts::TAU);
        Self { random, speed, reach, goal: GridPoint::new(column, row, 0.0), heading }
    }

    /// The next goal, over or under the map.
    pub fn next(&mut self, grid: &Grid, metric: &Metric) -> GridPoint {
        let dice = self.random.unit();
        if dice < 0.1 {
            return self.goal;
        }
        let place = if dice < 0.2 { self.jump(grid) } else { self.drift(grid) };
        let place = if dice > 0.7 { self.tie(place) } else { place };
        self.goal = GridPoint { elevation: self.elevation(grid, metric, &place), ..place };
        self.goal
    }

    fn jump(&mut self, grid: &Grid) -> GridPoint {
        let layout = grid.layout();
        let column = self.random.between(0.0, f64::from(layout.columns() - 1));
        let row = self.random.between(0.0, f64::from(layout.rows() - 1));
        GridPoint::new(column, row, 0.0)
    }

    fn drift(&mut self, grid: &Grid) -> GridPoint {
        self.heading += self.random.between(-0.3, 0.3);
        let (east, south) = (self.speed * self.heading.cos(), self.speed * self.heading.sin());
        let GridPoint { column, row, u, v, .. } = self.goal;
        let place = GridPoint::from_sample(column, row, u + east, v + south, 0.0);
        if is_on_map(grid, &place) {
            return place;
        }
        self.heading += 2.0;
        self.jump(grid)
    }

    /// On a sample, or halfway to the next: on an edge, a diagonal, at equal distances.
    fn tie(&mut self, place: GridPoint) -> GridPoint {
        let steps = [1.0, 2.0, 4.0][self.random.below(3)];
        let (u, v) = ((place.u * steps).floor() / steps, (place.v * steps).floor() / steps);
        let (u, v) = [(u, v), (u, place.v), (place.u, v), (u, u)][self.random.below(4)];
        GridPoint { u, v, ..place }
    }

    /// Metres: under the surface, over it or on it; near or far, in cells or in parts of the relief.
    fn elevation(&mut self, grid: &Grid, metric: &Metric, place: &GridPoint) -> f64 {
        let surface = grid.surface_elevation(place).unwrap_or(0.0);
        let cell = metric.column / metric.up;
        let dice = self.random.unit();
        let nearness = 10f64.powf(self.random.between(-4.0, 0.0));
        if dice < 0.05 {
            surface
        } else if dice < 0.6 {
            surface - self.reach * cell * nearness
        } else if dice < 0.75 {
            surface + self.reach * cell * nearness
        } else if dice < 0.85 {
            // As a number without many digits: exactly between, or as high as, samples.
            (surface / cell * 2.0).round() / 2.0 * cell
        } else {
            let around = [(0, 0), (1, 0), (0, 1), (1, 1)][self.random.below(4)];
            let sample = grid.elevation(place.column + around.0, place.row + around.1);
            let toward = sample.unwrap_or(surface);
            surface + self.random.between(-1.0, 1.0) * (toward - surface)
        }
    }
}
