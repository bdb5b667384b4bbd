//! Asking for memory before it is needed.
//!
//! Rows of a grid lie far apart: a way across them meets another cache line at every row, and on a
//! large grid another page. Asked for one after the other, as the way comes to them, each is waited
//! for; asked for beforehand, they are waited for together.

use crate::heightfield::Heightfield;
use crate::point::GridPoint;
use crate::sample::Sample;

/// Bytes that come into the cache together, as on every processor that we know. A guess that is
/// wrong costs time only.
const LINE: f64 = 64.0;

/// Lines that are asked for at once, at the most: more would wait for a place. It is also more than
/// a hand on a planet crosses in an update.
const MOST_LINES: f64 = 64.0;

impl<S: Sample> Heightfield<'_, S> {
    /// Asks for the samples under a straight way over the ground, from a point on the map so many
    /// columns east and rows south; of a long way, for the first 64 cache lines. Changes nothing but
    /// what is in the caches.
    #[inline(always)]
    pub fn prefetch_way(&self, from: &GridPoint, [east, south]: [f64; 2]) {
        let lines = south.abs().max(east.abs() * (S::BYTES as f64 / LINE)).max(1.0);
        let (column_step, row_step) = (fixed(east / lines), fixed(south / lines));
        let (mut column, mut row) = (fixed(from.u), fixed(from.v));
        let first = self.offset(self.period_column(from.column), from.row);
        for _ in 0..=lines.min(MOST_LINES) as u32 {
            self.prefetch(first.wrapping_add(self.offset(column >> 32, row >> 32)));
            (column, row) = (column + column_step, row + row_step);
        }
    }

    /// Asks for the sample that lies so many columns east and rows south of a point on the map.
    #[inline(always)]
    pub fn prefetch_beside(&self, point: &GridPoint, [east, south]: [f64; 2]) {
        let (column, row) = (fixed(point.u + east) >> 32, fixed(point.v + south) >> 32);
        let first = self.offset(self.period_column(point.column), point.row);
        self.prefetch(first.wrapping_add(self.offset(column, row)));
    }
}

/// Cells in fixed point: 32 bits of them are parts of a cell. What is farther than 2^24 cells is
/// as good as that far: memory that nobody needs.
#[inline(always)]
fn fixed(cells: f64) -> i64 {
    const PARTS: f64 = (1u64 << 32) as f64;
    const FARTHEST: f64 = (1u64 << 24) as f64;
    (cells.clamp(-FARTHEST, FARTHEST) * PARTS) as i64
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{ByteOrder, Grid, GridLayout, SampleType, readers::I16Big};

    #[test]
    fn ways_that_lead_off_the_map_do_no_harm() {
        let layout = GridLayout::packed(2, 2, 1.0, 1.0, SampleType::I16, ByteOrder::Big).unwrap();
        let grid = Grid::from_vec(vec![0; 8], layout).unwrap();
        let field = Heightfield::<I16Big>::new(&grid);
        let (corner, nowhere) = (GridPoint::new(0.0, 0.0, 0.0), GridPoint::new(-1e300, 1e300, 0.0));
        for cells in [0.0, -0.0, 0.5, -1.0, 1e3, -1e9, 1e300, f64::INFINITY, f64::NAN] {
            for way in [[cells, 0.0], [0.0, cells], [cells, -cells]] {
                for from in [&corner, &nowhere] {
                    field.prefetch_way(from, way);
                    field.prefetch_beside(from, way);
                }
            }
        }
    }

    #[test]
    fn fixed_point_rounds_down_on_both_sides_of_zero() {
        assert_eq!([0.0, 0.75, 1.0, 7.5].map(|cells| fixed(cells) >> 32), [0, 0, 1, 7]);
        assert_eq!([-0.25, -1.0, -7.5].map(|cells| fixed(cells) >> 32), [-1, -1, -8]);
    }
}
