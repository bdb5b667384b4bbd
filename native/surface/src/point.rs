//! Points over a grid.

/// Cell numbers are kept within this many cells of sample (0, 0): differences of two cannot
/// overflow, and a double still holds each of them exactly.
const FARTHEST_CELL: f64 = (1u64 << 40) as f64;

/// Metres; heights are kept within this, so that neither a difference nor the square of one, under
/// any metric, is more than a double can hold.
pub(crate) const FARTHEST_ELEVATION: f64 = 1e100;

/// A point over (or under) a grid: integer cell and fraction, so that its precision does not depend
/// on where on the planet it is. On a grid that wraps, columns run on beyond the last one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GridPoint {
    /// The cell's column.
    pub column: i64,
    /// The cell's row.
    pub row: i64,
    /// Fraction of the cell eastward, from 0 to 1.
    pub u: f64,
    /// Fraction of the cell southward, from 0 to 1.
    pub v: f64,
    /// Metres.
    pub elevation: f64,
}

impl GridPoint {
    /// The point at fractional `columns` and `rows`. Beyond 2^40 cells, or 1e100 m of elevation, it
    /// is brought back to that.
    pub fn new(columns: f64, rows: f64, elevation: f64) -> Self {
        Self { column: 0, row: 0, u: columns, v: rows, elevation }.normalized()
    }

    /// The point `u` cells east and `v` cells south of sample (`column`, `row`); `u` and `v` may be
    /// any numbers.
    #[inline(always)]
    pub fn from_sample(column: i64, row: i64, u: f64, v: f64, elevation: f64) -> Self {
        Self { column, row, u, v, elevation }.normalized()
    }

    /// Fractional columns east of sample (0, 0).
    pub fn columns(&self) -> f64 {
        self.column as f64 + self.u
    }

    /// Fractional rows south of sample (0, 0).
    pub fn rows(&self) -> f64 {
        self.row as f64 + self.v
    }

    /// Whether every number in it is finite.
    pub fn is_finite(&self) -> bool {
        self.u.is_finite() && self.v.is_finite() && self.elevation.is_finite()
    }

    /// Columns, rows and metres from sample (`column`, `row`) at height `elevation` to here.
    #[inline(always)]
    pub fn relative_to(&self, column: i64, row: i64, elevation: f64) -> [f64; 3] {
        [
            (self.column - column) as f64 + self.u,
            (self.row - row) as f64 + self.v,
            self.elevation - elevation,
        ]
    }

    #[inline(always)]
    fn normalized(self) -> Self {
        let (column, u) = split(self.column, self.u);
        let (row, v) = split(self.row, self.v);
        let elevation = if self.elevation.is_finite() {
            self.elevation.clamp(-FARTHEST_ELEVATION, FARTHEST_ELEVATION)
        } else {
            self.elevation
        };
        Self { column, row, u, v, elevation }
    }
}

/// Moves the whole cells of `fraction` into `cell`. A number that is not finite stays a fraction,
/// where [`GridPoint::is_finite`] sees it.
#[inline(always)]
fn split(cell: i64, fraction: f64) -> (i64, f64) {
    // Most often nothing is to be moved, and rounding down may be a call to a library.
    let is_split = (0.0..1.0).contains(&fraction) && fraction.is_sign_positive();
    if is_split && cell.unsigned_abs() < FARTHEST_CELL as u64 {
        return (cell, fraction);
    }
    if !fraction.is_finite() {
        return (cell, fraction);
    }
    let whole = fraction.floor();
    let moved = cell as f64 + whole;
    if moved.abs() >= FARTHEST_CELL {
        return (FARTHEST_CELL.copysign(moved) as i64, 0.0);
    }
    (moved as i64, fraction - whole)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_and_fractions_are_split_below_zero_too() {
        let point = GridPoint::new(-0.25, 7.5, 1.0);
        assert_eq!((point.column, point.u, point.row, point.v), (-1, 0.75, 7, 0.5));
        assert_eq!(point.relative_to(-2, 7, 0.0), [1.75, 0.5, 1.0]);
    }

    #[test]
    fn huge_and_broken_numbers_do_no_harm() {
        let far = GridPoint::new(f64::MAX, -f64::MAX, 0.0);
        assert!(far.is_finite());
        assert_eq!((far.column, far.row), (1 << 40, -(1 << 40)));
        assert_eq!(GridPoint::new(0.0, 0.0, -f64::MAX).elevation, -FARTHEST_ELEVATION);
        assert!(!GridPoint::new(f64::NAN, 0.0, 0.0).is_finite());
        assert!(!GridPoint::new(0.0, f64::INFINITY, 0.0).is_finite());
    }
}
