//! Whether a file has the region that was asked for.

use crate::error::DecodeError;
use surface::GridLayout;

/// Refuses a region that the file does not have. Columns may run on beyond the last one, which only grids
/// of a whole planet are asked for: column 0 follows there.
pub fn check_region(
    layout: &GridLayout,
    (first_column, first_row): (u32, u32),
    (columns, rows): (u32, u32),
) -> Result<(), DecodeError> {
    let fits_down = u64::from(first_row) + u64::from(layout.rows()) <= rows.into();
    if fits_down && first_column < columns && layout.columns() <= columns {
        return Ok(());
    }
    let found = format!(
        "{} columns from {first_column} and {} rows from {first_row}",
        layout.columns(),
        layout.rows()
    );
    Err(DecodeError::wrong("region", found, format!("a region of {columns} x {rows} samples")))
}

/// The column of a region that begins at `first`, for one of the file's `all` columns; it may lie beyond
/// the region.
#[inline]
pub fn column_in_region(column: u32, first: u32, all: u32) -> u32 {
    if column >= first { column - first } else { column + (all - first) }
}
