//! Small terrains and random numbers for tests and benches, the same in every run.

use surface::{ByteOrder, Grid, GridLayout, SampleType};

/// A small generator of random numbers (xorshift64*), so that failures repeat.
#[derive(Clone, Debug)]
pub struct Random(u64);

impl Random {
    /// The same numbers for the same seed.
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

    /// From `low` to `high`.
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// One of 0 to `count` - 1.
    pub fn below(&mut self, count: usize) -> usize {
        ((self.unit() * count as f64) as usize).min(count - 1)
    }
}

/// A grid of doubles with square cells of one metre; NaN is void.
pub fn grid(
    rows: usize,
    columns: usize,
    wraps: bool,
    height: impl Fn(usize, usize) -> f64,
) -> Grid {
    grid_with_cells(rows, columns, [1.0, 1.0], wraps, height)
}

/// A grid of doubles whose cells are this many metres wide and high; NaN is void. `height` takes
/// column and row.
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
    let layout = GridLayout::packed(rows, columns, cell_width, cell_height, sample, order)
        .expect("a test's layout is possible");
    Grid::from_vec(bytes, layout.with_wrap(wraps)).expect("the bytes were made for the layout")
}

/// A square of independent random heights from 0 to `slope` cells.
pub fn white_noise(size: usize, slope: f64, seed: u64) -> Grid {
    let mut random = Random::new(seed);
    let heights: Vec<f64> = (0..size * size).map(|_| random.between(0.0, slope)).collect();
    grid(size, size, false, |column, row| heights[row * size + column])
}

/// A square of rolling hills: a few sines, slopes up to about `slope`.
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
