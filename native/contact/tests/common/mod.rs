//! Terrains, goals and an oracle for the tests of contact models.
//!
//! The oracle shares no code with the models beyond reading a sample: it works in plain workspace
//! coordinates, by brute force over the triangles around the proxy.
#![allow(dead_code, reason = "each test program uses a part of this")]

use contact::{Contact, Feature};
use surface::{ByteOrder, Grid, GridLayout, GridPoint, Metric, SampleType};

/// A small generator of random numbers (xorshift64*), so that failures repeat.
pub struct Random(u64);

impl Random {
    pub fn new(seed: u64) -> Self {
        let mut random = Self(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1);
        for _ in 0..8 {
            random.unit();
        }
        random
    }

    /// From 0 to 1.
    pub fn unit(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0.wrapping_mul(0x2545_F491_4F6C_DD1D) >> 11) as f64 / (1u64 << 53) as f64
    }

    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }
}

/// A grid of doubles with square cells of one metre.
pub fn grid(
    rows: usize,
    columns: usize,
    wraps: bool,
    height: impl Fn(usize, usize) -> f64,
) -> Grid {
    grid_with_cells(rows, columns, [1.0, 1.0], wraps, height)
}

pub fn grid_with_cells(
    rows: usize,
    columns: usize,
    [cell_width, cell_height]: [f64; 2],
    wraps: bool,
    height: impl Fn(usize, usize) -> f64,
) -> Grid {
    let mut bytes = Vec::with_capacity(rows * columns * 8);
    for row in 0..rows {
        for column in 0..columns {
            bytes.extend(height(column, row).to_le_bytes());
        }
    }
    let (rows, columns) = (rows as u64, columns as u64);
    let (sample, order) = (SampleType::F64, ByteOrder::Little);
    let layout = GridLayout::packed(rows, columns, cell_width, cell_height, sample, order);
    Grid::from_vec(bytes, layout.unwrap().with_wrap(wraps)).unwrap()
}

/// Independent random heights from 0 to `slope` cells.
pub fn white_noise(size: usize, slope: f64, seed: u64) -> Grid {
    let mut random = Random::new(seed);
    let heights: Vec<f64> = (0..size * size).map(|_| random.between(0.0, slope)).collect();
    grid(size, size, false, |column, row| heights[row * size + column])
}

/// Rolling hills: a few sines, slopes up to about `slope`.
pub fn hills(size: usize, slope: f64, seed: u64) -> Grid {
    let mut random = Random::new(seed);
    let waves: Vec<[f64; 4]> = (0..12)
        .map(|_| {
            let length = random.between(5.0, 40.0);
            let angle = random.between(0.0, std::f64::consts::TAU);
            let turn = std::f64::consts::TAU / length;
            [turn * angle.cos(), turn * angle.sin(), angle * 7.0, slope / turn / 6.0]
        })
        .collect();
    grid(size, size, false, |column, row| {
        let at = |[x, y, phase, height]: &[f64; 4]| {
            height * (x * column as f64 + y * row as f64 + phase).sin()
        };
        waves.iter().map(at).sum()
    })
}

/// A hand wandering over a square map of `size` samples at `speed` cells an update, from above the
/// surface to `depth` cells under it.
pub struct WanderingHand {
    random: Random,
    x: f64,
    y: f64,
    heading: f64,
    depth: f64,
    size: f64,
    speed: f64,
    deepest: f64,
}

impl WanderingHand {
    pub fn new(size: usize, speed: f64, deepest: f64, seed: u64) -> Self {
        let mut random = Random::new(seed);
        let size = size as f64;
        let (x, y) = (random.between(0.2, 0.8) * size, random.between(0.2, 0.8) * size);
        let heading = random.between(0.0, std::f64::consts::TAU);
        Self { random, x, y, heading, depth: -1.0, size, speed, deepest }
    }

    pub fn next(&mut self, grid: &Grid) -> GridPoint {
        self.heading += self.random.between(-0.2, 0.2);
        self.x += self.speed * self.heading.cos();
        self.y += self.speed * self.heading.sin();
        let most = self.size - 1.0;
        if !(0.0..=most).contains(&self.x) || !(0.0..=most).contains(&self.y) {
            self.x = self.x.clamp(0.0, most);
            self.y = self.y.clamp(0.0, most);
            self.heading += 2.0;
        }
        self.depth += self.random.between(-0.1, 0.1) * self.deepest;
        self.depth = self.depth.clamp(-0.3 * self.deepest, self.deepest);
        let under = GridPoint::new(self.x, self.y, 0.0);
        let surface = grid.surface_elevation(&under).unwrap_or(0.0);
        GridPoint { elevation: surface - self.depth, ..under }
    }
}

pub const SQUARE: Metric = Metric { column: 1.0, row: 1.0, up: 1.0 };

/// Between two points, with cells of one metre.
pub fn distance(from: &GridPoint, to: &GridPoint) -> f64 {
    let [columns, rows, up] = to.relative_to(from.column, from.row, from.elevation);
    length([columns - from.u, rows - from.v, up])
}

/// How far below the true surface the proxy is, in parts of the relief around it (rounding only).
pub fn depth_below_surface(grid: &Grid, contact: &Contact) -> f64 {
    let proxy = &contact.proxy;
    let Some(surface) = grid.surface_elevation(proxy) else {
        return 0.0;
    };
    let (mut low, mut high) = (proxy.elevation, proxy.elevation);
    for column in -1..=2 {
        for row in -1..=2 {
            if let Some(z) = grid.elevation(proxy.column + column, proxy.row + row) {
                (low, high) = (low.min(z), high.max(z));
            }
        }
    }
    let size = (high - low).max(high.abs()).max(low.abs()).max(f64::MIN_POSITIVE);
    (surface - proxy.elevation) / size
}

/// Why a contact is not a local minimum of the distance to the goal.
#[derive(Debug, PartialEq, Eq, Clone, Copy)]
pub enum Fault {
    /// A triangle that holds the proxy has a point closer to the goal.
    CloserOnSurface,
    /// The straight way to the goal is open.
    WayIsFree,
    /// It is out of contact and yet not at the goal.
    NotAtGoal,
}

/// Looks by brute force for a way to bring the proxy closer to `goal`. `None` where it is at a
/// local minimum, to within a billionth of a cell.
pub fn fault_of_minimum(
    grid: &Grid,
    metric: &Metric,
    contact: &Contact,
    goal: &GridPoint,
) -> Option<Fault> {
    let proxy = &contact.proxy;
    if contact.feature == Feature::Free {
        return (proxy != goal).then_some(Fault::NotAtGoal);
    }
    let place = |columns: f64, rows: f64, elevation: f64| {
        [columns * metric.column, rows * metric.row, (elevation - proxy.elevation) * metric.up]
    };
    let here = place(proxy.u, proxy.v, proxy.elevation);
    let [columns, rows, _] = goal.relative_to(proxy.column, proxy.row, 0.0);
    let goal = place(columns, rows, goal.elevation);
    let distance = length(subtract(goal, here));
    let cell = metric.column.min(metric.row);
    let tolerance = 1e-9 * (distance + cell);

    for triangle in triangles_around(grid, proxy, &place) {
        let touching = closest_on_triangle(here, &triangle);
        let relief =
            triangle.iter().map(|corner| length(subtract(*corner, here))).fold(0.0, f64::max);
        if length(subtract(touching, here)) > 1e-9 * (cell + relief) {
            continue;
        }
        let closest = closest_on_triangle(goal, &triangle);
        if length(subtract(goal, closest)) < distance - tolerance {
            return Some(Fault::CloserOnSurface);
        }
    }
    way_is_free(grid, proxy, &place, here, goal, tolerance).then_some(Fault::WayIsFree)
}

/// Whether a short step straight toward the goal stays above every plane it passes over.
fn way_is_free(
    grid: &Grid,
    proxy: &GridPoint,
    place: &impl Fn(f64, f64, f64) -> [f64; 3],
    here: [f64; 3],
    goal: [f64; 3],
    tolerance: f64,
) -> bool {
    let cell = place(1.0, 1.0, proxy.elevation);
    let way = subtract(goal, here);
    let across = (way[0] / cell[0]).abs().max((way[1] / cell[1]).abs()).max(f64::MIN_POSITIVE);
    let share = (1e-3 / across).min(1.0);
    let ahead = [0, 1, 2].map(|axis| here[axis] + share * way[axis]);
    let (columns, rows) = (ahead[0] / cell[0], ahead[1] / cell[1]);
    let under = GridPoint::from_sample(proxy.column, proxy.row, columns, rows, 0.0);
    match grid.surface_elevation(&under) {
        Some(surface) => {
            ahead[2] > place(columns, rows, surface)[2] + tolerance.max(1e-7 * share * length(way))
        }
        None => true,
    }
}

/// The triangles of the cells around the proxy, as corners in the workspace.
fn triangles_around(
    grid: &Grid,
    proxy: &GridPoint,
    place: &impl Fn(f64, f64, f64) -> [f64; 3],
) -> Vec<[[f64; 3]; 3]> {
    let corner = |column: i64, row: i64| {
        let elevation = grid.elevation(proxy.column + column, proxy.row + row)?;
        Some(place(column as f64, row as f64, elevation))
    };
    let mut triangles = Vec::new();
    for column in -2..=2 {
        for row in -2..=2 {
            let north_west = corner(column, row);
            let north_east = corner(column + 1, row);
            let south_west = corner(column, row + 1);
            let south_east = corner(column + 1, row + 1);
            for third in [north_east, south_west] {
                if let (Some(a), Some(b), Some(c)) = (north_west, south_east, third) {
                    triangles.push([a, b, c]);
                }
            }
        }
    }
    triangles
}

/// The closest point of a triangle: its plane's foot where that is inside, else the closest of the
/// three edges' closest points.
pub fn closest_on_triangle(point: [f64; 3], [a, b, c]: &[[f64; 3]; 3]) -> [f64; 3] {
    let (ab, ac, ap) = (subtract(*b, *a), subtract(*c, *a), subtract(point, *a));
    let (bb, bc, cc) = (dot(ab, ab), dot(ab, ac), dot(ac, ac));
    let (pb, pc) = (dot(ap, ab), dot(ap, ac));
    let determinant = bb * cc - bc * bc;
    let (s, t) = ((pb * cc - pc * bc) / determinant, (pc * bb - pb * bc) / determinant);
    if s >= 0.0 && t >= 0.0 && s + t <= 1.0 {
        return [0, 1, 2].map(|axis| a[axis] + s * ab[axis] + t * ac[axis]);
    }
    let candidates = [(a, b), (b, c), (c, a)].map(|(from, to)| {
        let edge = subtract(*to, *from);
        let share = (dot(subtract(point, *from), edge) / dot(edge, edge)).clamp(0.0, 1.0);
        [0, 1, 2].map(|axis| from[axis] + share * edge[axis])
    });
    let distance = |candidate: &[f64; 3]| length(subtract(point, *candidate));
    *candidates.iter().min_by(|a, b| distance(a).total_cmp(&distance(b))).unwrap()
}

fn subtract(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn length(a: [f64; 3]) -> f64 {
    dot(a, a).sqrt()
}
