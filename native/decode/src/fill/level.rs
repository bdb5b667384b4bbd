//! A grid of the cascade: heights, some of them known.

use crate::error::DecodeError;
use crate::progress::Progress;
use surface::{ByteOrder, Grid, Heightfield, Sample, SampleType, readers};

/// Heights in metres; where they are not known they are made up.
pub struct Level {
    columns: usize,
    rows: usize,
    wraps: bool,
    heights: Vec<f64>,
    is_known: Vec<bool>,
}

impl Level {
    /// A grid's samples.
    pub fn of(grid: &Grid, progress: &Progress) -> Result<Self, DecodeError> {
        use readers::*;
        let layout = grid.layout();
        match (layout.sample(), layout.byte_order()) {
            (SampleType::I16, ByteOrder::Big) => Self::read::<I16Big>(grid, progress),
            (SampleType::I16, ByteOrder::Little) => Self::read::<I16Little>(grid, progress),
            (SampleType::U16, ByteOrder::Big) => Self::read::<U16Big>(grid, progress),
            (SampleType::U16, ByteOrder::Little) => Self::read::<U16Little>(grid, progress),
            (SampleType::I32, ByteOrder::Big) => Self::read::<I32Big>(grid, progress),
            (SampleType::I32, ByteOrder::Little) => Self::read::<I32Little>(grid, progress),
            (SampleType::F32, ByteOrder::Big) => Self::read::<F32Big>(grid, progress),
            (SampleType::F32, ByteOrder::Little) => Self::read::<F32Little>(grid, progress),
            (SampleType::F64, ByteOrder::Big) => Self::read::<F64Big>(grid, progress),
            (SampleType::F64, ByteOrder::Little) => Self::read::<F64Little>(grid, progress),
        }
    }

    fn read<S: Sample>(grid: &Grid, progress: &Progress) -> Result<Self, DecodeError> {
        let layout = grid.layout();
        let (columns, rows) = (layout.columns() as usize, layout.rows() as usize);
        let mut level = Self::unknown(columns, rows, layout.wraps())?;
        let field = Heightfield::<S>::new(grid);
        for row in 0..rows {
            // Half of the way; the rest is told when the holes are filled.
            progress.step(row as u64, 2 * rows as u64)?;
            for column in 0..columns {
                level.heights[row * columns + column] = field.elevation(column as i64, row as i64);
            }
        }
        for (is_known, height) in level.is_known.iter_mut().zip(&level.heights) {
            *is_known = !height.is_nan();
        }
        Ok(level)
    }

    fn unknown(columns: usize, rows: usize, wraps: bool) -> Result<Self, DecodeError> {
        let cells = columns * rows;
        Ok(Self {
            columns,
            rows,
            wraps,
            heights: reserved(cells, f64::NAN)?,
            is_known: reserved(cells, false)?,
        })
    }

    /// Number of columns.
    pub fn columns(&self) -> usize {
        self.columns
    }

    /// Number of rows.
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// Whether the last column's neighbour is the first.
    pub fn wraps(&self) -> bool {
        self.wraps
    }

    /// Number of cells.
    pub fn cells(&self) -> u64 {
        self.heights.len() as u64
    }

    /// Whether any height is known.
    pub fn has_heights(&self) -> bool {
        self.is_known.contains(&true)
    }

    /// Whether the height of a cell is known.
    pub fn knows(&self, column: u32, row: u32) -> bool {
        self.is_known[row as usize * self.columns + column as usize]
    }

    /// The height of a cell.
    pub fn height(&self, column: u32, row: u32) -> f64 {
        self.heights[row as usize * self.columns + column as usize]
    }

    /// A grid of half as many columns and rows, each cell the mean of what is known in four of these;
    /// `None` where everything is known already.
    pub fn coarser(&self) -> Result<Option<Self>, DecodeError> {
        if !self.is_known.contains(&false) || (self.columns == 1 && self.rows == 1) {
            return Ok(None);
        }
        let (columns, rows) = (self.columns.div_ceil(2), self.rows.div_ceil(2));
        let mut coarser = Self::unknown(columns, rows, self.wraps)?;
        for row in 0..rows {
            for column in 0..columns {
                let (mut sum, mut count) = (0.0, 0.0);
                for below in [2 * row, 2 * row + 1] {
                    for beside in [2 * column, 2 * column + 1] {
                        if below < self.rows && beside < self.columns {
                            let cell = below * self.columns + beside;
                            if self.is_known[cell] {
                                sum += self.heights[cell];
                                count += 1.0;
                            }
                        }
                    }
                }
                if count > 0.0 {
                    let cell = row * columns + column;
                    coarser.heights[cell] = sum / count;
                    coarser.is_known[cell] = true;
                }
            }
        }
        Ok(Some(coarser))
    }

    /// Makes up the unknown heights: at first those of the coarser grid, then again and again the mean
    /// of the four neighbours.
    pub fn settle(
        &mut self,
        coarser: Option<&Self>,
        rounds: u32,
        progress: &Progress,
    ) -> Result<(), DecodeError> {
        let Some(coarser) = coarser else { return Ok(()) };
        for row in 0..self.rows {
            for column in 0..self.columns {
                let cell = row * self.columns + column;
                if !self.is_known[cell] {
                    self.heights[cell] = coarser.between(column, row);
                }
            }
        }
        for _ in 0..rounds {
            progress.check()?;
            for row in 0..self.rows {
                for column in 0..self.columns {
                    if !self.is_known[row * self.columns + column] {
                        self.heights[row * self.columns + column] = self.mean_around(column, row);
                    }
                }
            }
        }
        Ok(())
    }

    /// The height at a cell of the finer grid, between this grid's four nearest.
    fn between(&self, column: usize, row: usize) -> f64 {
        let ends = |fine: usize, cells: usize, wraps: bool| {
            let near = fine / 2;
            let far = match (fine % 2, wraps) {
                (0, true) if near == 0 => cells - 1,
                (0, _) => near.saturating_sub(1),
                (_, true) if near + 1 == cells => 0,
                _ => (near + 1).min(cells - 1),
            };
            (near, far)
        };
        let (near, far) = ends(column, self.columns, self.wraps);
        let (near_row, far_row) = ends(row, self.rows, false);
        let across = |row: usize| {
            let heights = &self.heights[row * self.columns..];
            0.75 * heights[near] + 0.25 * heights[far]
        };
        0.75 * across(near_row) + 0.25 * across(far_row)
    }

    fn mean_around(&self, column: usize, row: usize) -> f64 {
        let cell = row * self.columns + column;
        let (mut sum, mut count) = (0.0, 0.0);
        let mut take = |cell: usize| {
            sum += self.heights[cell];
            count += 1.0;
        };
        if row > 0 {
            take(cell - self.columns);
        }
        if row + 1 < self.rows {
            take(cell + self.columns);
        }
        if column > 0 {
            take(cell - 1);
        } else if self.wraps {
            take(cell + self.columns - 1);
        }
        if column + 1 < self.columns {
            take(cell + 1);
        } else if self.wraps {
            take(cell + 1 - self.columns);
        }
        if count == 0.0 { self.heights[cell] } else { sum / count }
    }
}

/// A vector of the same value, or an error where there is no memory for it.
pub fn reserved<T: Clone>(count: usize, value: T) -> Result<Vec<T>, DecodeError> {
    let mut vector = Vec::new();
    vector.try_reserve_exact(count).map_err(|_| {
        let bytes = count as u128 * size_of::<T>() as u128;
        DecodeError::wrong("memory", format!("no room for {bytes} bytes"), "enough free memory")
    })?;
    vector.resize(count, value);
    Ok(vector)
}
