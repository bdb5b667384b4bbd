//! Where a region that was asked for goes, and whether the file has it.

use crate::error::DecodeError;
use crate::target::Target;
use std::path::Path;
use surface::GridLayout;

/// Room in a file at `cache` where one is named, else in memory.
pub fn room(layout: GridLayout, cache: Option<&Path>) -> Result<Target, DecodeError> {
    match cache {
        Some(path) => Target::file(layout, path),
        None => Target::memory(layout),
    }
}

/// Refuses a region that the file does not have.
pub fn check_region(
    layout: &GridLayout,
    (first_column, first_row): (u32, u32),
    (columns, rows): (u32, u32),
) -> Result<(), DecodeError> {
    let fits = |first: u32, count: u32, all: u32| u64::from(first) + u64::from(count) <= all.into();
    if fits(first_column, layout.columns(), columns) && fits(first_row, layout.rows(), rows) {
        return Ok(());
    }
    let found = format!(
        "{} columns from {first_column} and {} rows from {first_row}",
        layout.columns(),
        layout.rows()
    );
    Err(DecodeError::wrong("region", found, format!("a region of {columns} x {rows} samples")))
}
