//! The synthetic planet that the bench touches: like Mars in relief, made up in every detail.
//!
//! Large forms (plains, volcanoes, a canyon) are the same in metres on a grid of any size; the small
//! relief is the same in cells (see [`crate::tile`]), so that a hand that crosses 13 cells meets
//! the same ground whether the planet has 33 million triangles or 10 thousand million.

use crate::random::Random;
use crate::tile::{PERIOD, Tile};
use std::f64::consts::TAU;
use std::fs::File;
use std::io::{self, BufWriter, Read, Seek, SeekFrom, Write};
use std::path::Path;
use surface::{ByteOrder, GridLayout, GridPoint, SampleType};

/// Metres around Mars at the equator.
const CIRCUMFERENCE: f64 = 21_344_000.0;

/// The canyon: metres from its middle to the foot of a wall, from foot to edge, and down.
const CANYON_HALF: f64 = 40_000.0;
const CANYON_WALL: f64 = 13_000.0;
const CANYON_DEPTH: f64 = 7_000.0;

/// Places of the large relief around the planet, and from pole to pole.
const NODES: [usize; 2] = [512, 256];

/// Metres from the lowest to the highest plain, and of the lowest.
const PLAINS: f64 = 9_000.0;
const LOWEST_PLAIN: f64 = -5_500.0;

/// Volcanoes: place, metres, and standard deviation, in nodes of the large relief.
const VOLCANOES: [[f64; 4]; 4] = [
    [130.0, 70.0, 20_500.0, 9.0],
    [170.0, 88.0, 14_000.0, 7.0],
    [178.0, 80.0, 13_000.0, 7.0],
    [188.0, 70.0, 14_000.0, 7.0],
];

/// The canyon's middle winds about this share of the way from pole to pole, by at most that.
const CANYON_PLACE: f64 = 0.65;
const CANYON_WINDING: [f64; 2] = [0.03, 0.008];

/// There is no canyon in this northern share of the map.
pub const NORTH_OF_CANYON: f64 = 0.6;

/// The parts that planets of all sizes share.
pub struct Relief {
    tile: Tile,
    /// Metres at the nodes, row by row.
    plains: Vec<f64>,
}

/// A planet of one size.
pub struct Terrain<'a> {
    relief: &'a Relief,
    layout: GridLayout,
    /// Row of the canyon's middle at each column.
    canyon: Vec<f64>,
}

impl Default for Relief {
    fn default() -> Self {
        Self::new()
    }
}

impl Relief {
    /// The same always.
    pub fn new() -> Self {
        Self { tile: Tile::new(), plains: plains() }
    }
}

impl<'a> Terrain<'a> {
    /// A planet of `columns` (a multiple of [`PERIOD`]) by `rows` samples.
    pub fn new(relief: &'a Relief, columns: usize, rows: usize) -> Self {
        assert!(columns.is_multiple_of(PERIOD), "whole tiles, else there is a seam");
        let cell = CIRCUMFERENCE / columns as f64;
        let layout = GridLayout::packed(
            rows as u64,
            columns as u64,
            cell,
            cell,
            SampleType::I16,
            ByteOrder::Big,
        );
        let layout = layout.expect("sizes of planets are possible").with_wrap(true);
        let middle = |column: usize| canyon_middle(column as f64 / columns as f64) * rows as f64;
        Self { relief, layout, canyon: (0..columns).map(middle).collect() }
    }

    /// Of the file: 16-bit big-endian, packed, columns wrap.
    pub fn layout(&self) -> GridLayout {
        self.layout
    }

    /// Row of the middle of the canyon's southern wall at `column`, and half of the wall's breadth, cells.
    pub fn canyon_wall(&self, column: f64) -> (f64, f64) {
        let cell = self.layout.cell_width();
        let half_wall = 0.5 * CANYON_WALL / cell;
        let middle = self.canyon[column.rem_euclid(self.canyon.len() as f64) as usize];
        (middle + CANYON_HALF / cell + half_wall, half_wall)
    }

    /// Metres at every sample of a row, before they are rounded to what the file holds.
    pub fn row(&self, row: usize, heights: &mut [f64]) {
        let columns = self.layout.columns() as usize;
        let cell = self.layout.cell_width();
        let plains = self.plains_along(row);
        for (column, height) in heights.iter_mut().enumerate() {
            *height = along_nodes(&plains, column, columns);
        }
        for tile in heights.chunks_exact_mut(PERIOD) {
            for (height, relief) in tile.iter_mut().zip(self.relief.tile.row(row)) {
                *height += cell * f64::from(*relief);
            }
        }
        self.cut_canyon(row, heights, 0);
    }

    /// Metres of the triangulated surface under or over a point, as the file has it, without
    /// reading the file.
    pub fn surface(&self, point: &GridPoint) -> f64 {
        let height = |east: i64, south: i64| self.elevation(point.column + east, point.row + south);
        let (u, v) = (point.u, point.v);
        let (corner, opposite) = (height(0, 0), height(1, 1));
        if u >= v {
            let beside = height(1, 0);
            corner + u * (beside - corner) + v * (opposite - beside)
        } else {
            let below = height(0, 1);
            corner + v * (below - corner) + u * (opposite - below)
        }
    }

    /// The sample that the file holds for a height.
    pub fn sample(height: f64) -> i16 {
        height.round() as i16
    }

    /// Metres at one sample of the file.
    fn elevation(&self, column: i64, row: i64) -> f64 {
        let columns = self.layout.columns() as usize;
        let (column, row) = (column.rem_euclid(columns as i64) as usize, row as usize);
        let plain = along_nodes(&self.plains_along(row), column, columns);
        let relief = f64::from(self.relief.tile.row(row)[column % PERIOD]);
        let mut height = [plain + self.layout.cell_width() * relief];
        self.cut_canyon(row, &mut height, column);
        f64::from(Self::sample(height[0]))
    }

    /// Writes the file row by row, unless it is there and holds this very planet.
    pub fn write(&self, path: &Path) -> io::Result<()> {
        if self.is_written(path).unwrap_or(false) {
            return Ok(());
        }
        let mut file = BufWriter::with_capacity(8 << 20, File::create(path)?);
        let mut bytes = self.empty_row();
        for row in 0..self.layout.rows() as usize {
            self.row_bytes(row, &mut bytes);
            file.write_all(&bytes.1)?;
        }
        file.flush()
    }

    /// Whether a file is as long as this planet and agrees with it in rows here and there.
    fn is_written(&self, path: &Path) -> io::Result<bool> {
        let mut file = File::open(path)?;
        if file.metadata()?.len() != self.layout.byte_length() {
            return Ok(false);
        }
        let last = self.layout.rows() as usize - 1;
        let mut expected = self.empty_row();
        let mut found = expected.1.clone();
        for eighth in 0..=8 {
            let row = last * eighth / 8;
            self.row_bytes(row, &mut expected);
            file.seek(SeekFrom::Start(row as u64 * self.layout.row_stride()))?;
            file.read_exact(&mut found)?;
            if found != expected.1 {
                return Ok(false);
            }
        }
        Ok(true)
    }

    fn empty_row(&self) -> (Vec<f64>, Vec<u8>) {
        let columns = self.layout.columns() as usize;
        (vec![0.0; columns], vec![0; columns * 2])
    }

    fn row_bytes(&self, row: usize, (heights, bytes): &mut (Vec<f64>, Vec<u8>)) {
        self.row(row, heights);
        for (bytes, height) in bytes.chunks_exact_mut(2).zip(heights) {
            bytes.copy_from_slice(&Self::sample(*height).to_be_bytes());
        }
    }

    /// The plains' heights at the nodes along a row of samples; the first node again at the end.
    fn plains_along(&self, row: usize) -> Vec<f64> {
        let last = NODES[1] - 2;
        let place = row as f64 * (NODES[1] - 1) as f64 / f64::from(self.layout.rows());
        let first = (place as usize).min(last);
        let share = smooth(place - first as f64);
        let nodes = |row: usize| &self.relief.plains[row * NODES[0]..(row + 1) * NODES[0]];
        let between = |(north, south): (&f64, &f64)| north + share * (south - north);
        let mut along: Vec<f64> = nodes(first).iter().zip(nodes(first + 1)).map(between).collect();
        along.push(along[0]);
        along
    }

    /// Lowers the heights of a row from `column` on.
    fn cut_canyon(&self, row: usize, heights: &mut [f64], column: usize) {
        let (cell, rows) = (self.layout.cell_width(), f64::from(self.layout.rows()));
        let middle = CANYON_PLACE * rows;
        let reach = CANYON_WINDING.iter().sum::<f64>() * rows + (CANYON_HALF + CANYON_WALL) / cell;
        if (row as f64 - middle).abs() > reach {
            return;
        }
        for (height, middle) in heights.iter_mut().zip(&self.canyon[column..]) {
            let distance = cell * (row as f64 - middle).abs();
            let inside = (CANYON_HALF + CANYON_WALL - distance) / CANYON_WALL;
            *height -= CANYON_DEPTH * inside.clamp(0.0, 1.0);
        }
    }
}

/// Share of the way from pole to pole at which the canyon's middle is, at a share of the way around
/// the planet. It winds, and comes round to where it began.
fn canyon_middle(around: f64) -> f64 {
    let [long, short] = CANYON_WINDING;
    CANYON_PLACE + long * (4.0 * TAU * around).sin() + short * (13.0 * TAU * around).sin()
}

/// Highlands, lowlands and volcanoes at the nodes, metres.
fn plains() -> Vec<f64> {
    let mut random = Random::new(0x5468_6172);
    let waves: Vec<[f64; 4]> = (0..24)
        .map(|_| {
            let around = random.below(7) as f64;
            let down = random.between(0.5, 6.0);
            let amplitude = random.normal() / (1.0 + around.hypot(down));
            [around, down, random.unit(), amplitude]
        })
        .collect();
    let mut heights = Vec::with_capacity(NODES[0] * NODES[1]);
    for row in 0..NODES[1] {
        for column in 0..NODES[0] {
            let (u, v) = (column as f64 / NODES[0] as f64, row as f64 / NODES[1] as f64);
            let wave = |[around, down, phase, amplitude]: &[f64; 4]| {
                amplitude * (TAU * (around * u + down * v + phase)).sin()
            };
            heights.push(waves.iter().map(wave).sum::<f64>());
        }
    }
    let lowest = heights.iter().copied().fold(f64::INFINITY, f64::min);
    let highest = heights.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    for (node, height) in heights.iter_mut().enumerate() {
        *height = LOWEST_PLAIN + PLAINS * (*height - lowest) / (highest - lowest);
        let (column, row) = ((node % NODES[0]) as f64, (node / NODES[0]) as f64);
        for [east, south, metres, breadth] in VOLCANOES {
            let distance = (column - east).hypot(row - south) / breadth;
            *height += metres * (-0.5 * distance * distance).exp();
        }
    }
    heights
}

/// The height at a sample between the nodes of its row.
#[inline(always)]
fn along_nodes(plains: &[f64], column: usize, columns: usize) -> f64 {
    let place = column as f64 * (NODES[0] as f64 / columns as f64);
    let first = place as usize;
    plains[first] + smooth(place - first as f64) * (plains[first + 1] - plains[first])
}

fn smooth(share: f64) -> f64 {
    share * share * (3.0 - 2.0 * share)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_same_planet_is_written_every_time_and_another_is_replaced() {
        let path = std::env::temp_dir().join(format!("terrain-{}.img", std::process::id()));
        let relief = Relief::new();
        let terrain = Terrain::new(&relief, PERIOD, 64);
        terrain.write(&path).unwrap();
        let bytes = std::fs::read(&path).unwrap();
        assert_eq!(bytes.len() as u64, terrain.layout().byte_length());
        assert!(terrain.is_written(&path).unwrap());
        std::fs::write(&path, vec![0; bytes.len()]).unwrap();
        assert!(!terrain.is_written(&path).unwrap());
        Terrain::new(&Relief::new(), PERIOD, 64).write(&path).unwrap();
        assert_eq!(std::fs::read(&path).unwrap(), bytes);
        std::fs::remove_file(&path).unwrap();
    }

    #[test]
    fn the_surface_told_is_the_surface_of_the_file() {
        let relief = Relief::new();
        let terrain = Terrain::new(&relief, PERIOD, 256);
        let mut rows = terrain.empty_row();
        let mut bytes = Vec::new();
        for row in 0..256 {
            terrain.row_bytes(row, &mut rows);
            bytes.extend_from_slice(&rows.1);
        }
        let grid = surface::Grid::from_vec(bytes, terrain.layout()).unwrap();
        let mut random = Random::new(2);
        for _ in 0..2000 {
            let (column, row) = (random.between(-50.0, 4000.0), random.between(0.0, 254.0));
            let point = GridPoint::new(column, row, 0.0);
            let off = grid.surface_elevation(&point).unwrap() - terrain.surface(&point);
            assert!(off.abs() < 1e-9, "{off} at {point:?}");
        }
    }

    #[test]
    fn the_ground_is_as_rough_from_cell_to_cell_on_every_size() {
        let relief = Relief::new();
        let roughness = |columns: usize| {
            let terrain = Terrain::new(&relief, columns, columns / 2);
            let mut heights = vec![0.0; columns];
            let mut squares = 0.0;
            for row in 200..300 {
                terrain.row(row, &mut heights);
                squares += heights.windows(2).map(|pair| (pair[1] - pair[0]).powi(2)).sum::<f64>();
            }
            (squares / (100 * columns) as f64).sqrt() / terrain.layout().cell_width()
        };
        let (small, large) = (roughness(2 * PERIOD), roughness(4 * PERIOD));
        assert!((small / large - 1.0).abs() < 0.05, "{small} {large}");
        assert!((small / crate::tile::SLOPE - 1.0).abs() < 0.3, "{small}");
    }

    #[test]
    fn the_planet_has_no_seam() {
        let relief = Relief::new();
        let terrain = Terrain::new(&relief, PERIOD, PERIOD / 2);
        let mut heights = vec![0.0; PERIOD];
        let (mut at_seam, mut elsewhere) = (0.0, 0.0);
        for row in 0..PERIOD / 2 {
            terrain.row(row, &mut heights);
            at_seam += (heights[0] - heights[PERIOD - 1]).abs();
            elsewhere += (heights[PERIOD / 2] - heights[PERIOD / 2 - 1]).abs();
        }
        assert!(at_seam < 2.0 * elsewhere, "{at_seam} {elsewhere}");
    }

    #[test]
    fn the_canyon_is_as_deep_as_said_between_its_walls() {
        let relief = Relief::new();
        let terrain = Terrain::new(&relief, 3 * PERIOD, 3 * PERIOD / 2);
        let (wall, half) = terrain.canyon_wall(0.0);
        let cut_at = |row: usize| {
            let mut heights = vec![0.0; 3 * PERIOD];
            terrain.cut_canyon(row, &mut heights, 0);
            -heights[0]
        };
        assert_eq!(cut_at((wall - half).floor() as usize), CANYON_DEPTH);
        assert_eq!(cut_at((wall + half).ceil() as usize), 0.0);
        let middle = cut_at(wall.round() as usize);
        assert!((middle / CANYON_DEPTH - 0.5).abs() < 0.2, "{middle}");
    }
}
