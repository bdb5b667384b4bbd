//! Which voids hang together, and what stands around them.

use super::level::Level;
use crate::error::DecodeError;
use std::ops::Range;

/// Lowest and highest height around a hole, metres.
pub type Rim = (f64, f64);

/// Voids that lie beside one another in a row.
struct Run {
    row: u32,
    columns: Range<u32>,
    /// Another run of the same hole, nearer to its first; its own number where it is the first.
    parent: u32,
    /// Of the whole hole, at its first run.
    rim: Rim,
}

/// Every hole of a grid: voids that share an edge or a corner.
pub struct Holes {
    runs: Vec<Run>,
}

impl Holes {
    /// Finds them.
    pub fn of(level: &Level) -> Result<Self, DecodeError> {
        let mut holes = Self { runs: Vec::new() };
        let (mut above, columns) = (0..0, level.columns() as u32);
        for row in 0..level.rows() as u32 {
            let first = holes.runs.len();
            holes.find(level, row)?;
            let here = first..holes.runs.len();
            holes.join_rows(&above, &here);
            if level.wraps() {
                holes.join_over_the_seam(&above, &here, columns);
            }
            above = here;
        }
        holes.measure_rims(level);
        Ok(holes)
    }

    /// Whether there is any.
    pub fn are_there(&self) -> bool {
        !self.runs.is_empty()
    }

    /// Hands out row, columns and rim of every piece of every hole.
    pub fn each(&self, mut take: impl FnMut(u32, Range<u32>, Rim)) {
        for (index, run) in self.runs.iter().enumerate() {
            take(run.row, run.columns.clone(), self.runs[self.first_of(index)].rim);
        }
    }

    fn find(&mut self, level: &Level, row: u32) -> Result<(), DecodeError> {
        let columns = level.columns() as u32;
        let mut column = 0;
        while column < columns {
            let first = column;
            while column < columns && !level.knows(column, row) {
                column += 1;
            }
            if column > first {
                self.push(Run {
                    row,
                    columns: first..column,
                    parent: self.runs.len() as u32,
                    rim: (f64::INFINITY, f64::NEG_INFINITY),
                })?;
            }
            column += 1;
        }
        Ok(())
    }

    fn push(&mut self, run: Run) -> Result<(), DecodeError> {
        let is_room = self.runs.len() < u32::MAX as usize && self.runs.try_reserve(1).is_ok();
        if !is_room {
            let found = format!("no room for more than {} pieces of holes", self.runs.len());
            return Err(DecodeError::wrong("memory", found, "enough free memory"));
        }
        self.runs.push(run);
        Ok(())
    }

    /// Joins runs of a row with those of the row above that they touch.
    fn join_rows(&mut self, above: &Range<usize>, here: &Range<usize>) {
        let (mut upper, mut lower) = (above.start, here.start);
        while upper < above.end && lower < here.end {
            let (one, other) = (self.runs[upper].columns.clone(), self.runs[lower].columns.clone());
            if one.start <= other.end && other.start <= one.end {
                self.join(upper, lower);
            }
            if one.end < other.end { upper += 1 } else { lower += 1 }
        }
    }

    /// Joins a run at one end of a row with those at the other end that touch it around the planet.
    fn join_over_the_seam(&mut self, above: &Range<usize>, here: &Range<usize>, columns: u32) {
        let western = |runs: &[Run], of: &Range<usize>| {
            of.clone().next().filter(|first| runs[*first].columns.start == 0)
        };
        let eastern = |runs: &[Run], of: &Range<usize>| {
            of.clone().next_back().filter(|last| runs[*last].columns.end == columns)
        };
        for (one, other) in [
            (western(&self.runs, here), eastern(&self.runs, here)),
            (western(&self.runs, here), eastern(&self.runs, above)),
            (western(&self.runs, above), eastern(&self.runs, here)),
        ] {
            if let (Some(one), Some(other)) = (one, other) {
                self.join(one, other);
            }
        }
    }

    fn join(&mut self, one: usize, other: usize) {
        let (one, other) = (self.shortened(one), self.shortened(other));
        let (first, later) = (one.min(other), one.max(other));
        self.runs[later].parent = first as u32;
    }

    fn first_of(&self, mut run: usize) -> usize {
        while self.runs[run].parent as usize != run {
            run = self.runs[run].parent as usize;
        }
        run
    }

    /// The first run of the same hole; halves the way to it, so that ways never grow long.
    fn shortened(&mut self, mut run: usize) -> usize {
        while self.runs[run].parent as usize != run {
            let parent = self.runs[run].parent as usize;
            self.runs[run].parent = self.runs[parent].parent;
            run = parent;
        }
        run
    }

    /// Looks at the known neighbours of every void. Makes the ways to the first runs short as well.
    fn measure_rims(&mut self, level: &Level) {
        for index in 0..self.runs.len() {
            let first = self.first_of(index);
            self.runs[index].parent = first as u32;
            let (row, columns) = (self.runs[index].row, self.runs[index].columns.clone());
            let (mut least, mut most) = self.runs[first].rim;
            let mut look = |column: u32, row: u32| {
                if level.knows(column, row) {
                    let height = level.height(column, row);
                    (least, most) = (least.min(height), most.max(height));
                }
            };
            let (all, rows) = (level.columns() as u32, level.rows() as u32);
            let west = columns.start.checked_sub(1).or(level.wraps().then_some(all - 1));
            let east =
                if columns.end < all { Some(columns.end) } else { level.wraps().then_some(0) };
            let beside = west.into_iter().chain(columns).chain(east);
            for column in beside {
                for row in row.saturating_sub(1)..(row + 2).min(rows) {
                    look(column, row);
                }
            }
            self.runs[first].rim = (least, most);
        }
    }
}
