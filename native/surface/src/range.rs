//! The lowest and highest sample of a grid.

use crate::grid::Grid;
use crate::heightfield::Heightfield;
use crate::on_heightfield;
use crate::sample::Sample;

/// Extremes of a grid; of equal samples, the first in file order.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GridRange {
    /// Metres.
    pub minimum: f64,
    /// Column and row of the minimum.
    pub minimum_cell: (u32, u32),
    /// Metres.
    pub maximum: f64,
    /// Column and row of the maximum.
    pub maximum_cell: (u32, u32),
    /// How many samples have no elevation.
    pub voids: u64,
}

impl Grid {
    /// Scans every sample once, in file order; `None` where all are void.
    pub fn range(&self) -> Option<GridRange> {
        self.storage().expect_sequential_reads(true);
        let range = on_heightfield!(self, field => scan(&field));
        self.storage().expect_sequential_reads(false);
        range
    }
}

fn scan<S: Sample>(field: &Heightfield<S>) -> Option<GridRange> {
    let mut range = GridRange {
        minimum: f64::INFINITY,
        minimum_cell: (0, 0),
        maximum: f64::NEG_INFINITY,
        maximum_cell: (0, 0),
        voids: 0,
    };
    for row in 0..field.rows() {
        for column in 0..field.columns() {
            let elevation = field.elevation(column, row);
            let cell = (column as u32, row as u32);
            if elevation < range.minimum {
                (range.minimum, range.minimum_cell) = (elevation, cell);
            }
            if elevation > range.maximum {
                (range.maximum, range.maximum_cell) = (elevation, cell);
            }
            range.voids += u64::from(elevation.is_nan());
        }
    }
    (range.minimum <= range.maximum).then_some(range)
}
