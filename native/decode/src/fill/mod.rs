//! Filling holes: heights made up from what surrounds them.
//!
//! A hole gets the surface of least slope that its rim holds (Laplace's equation), worked out from
//! coarse grids to fine ones, a few rounds on each: the cost is in proportion to the grid's samples,
//! whatever the holes are. No made-up height is above or below the rim of its own hole.
//! The cascade: Bornemann and Deuflhard, "The cascadic multigrid method for elliptic problems" (1996).

mod holes;
mod level;

use crate::error::DecodeError;
use crate::pen::Pen;
use crate::progress::Progress;
use crate::target::Target;
use holes::Holes;
use level::Level;
use surface::{Grid, GridLayout, SampleType};

/// Rounds on each grid of the cascade.
const ROUNDS: u32 = 8;

/// Makes a grid whose voids are filled, in the same sample type; known samples keep their very bits.
///
/// A grid without any height stays as it is. The same grid always gives the same heights. A mapped file that
/// is cut meanwhile is refused: its lost samples read as zeros, and those are no heights.
pub fn fill(grid: &Grid, progress: &Progress) -> Result<Grid, DecodeError> {
    let layout = packed(grid.layout())?;
    let mut target = Target::memory(layout)?;
    for row in 0..layout.rows() {
        grid.copy_row(row, target.row(row));
    }
    let mut finest = Level::of(grid, progress)?;
    // Nothing is read from the grid after this.
    refuse_cut(grid)?;
    let holes = Holes::of(&finest)?;
    if !holes.are_there() || !finest.has_heights() {
        progress.step(1, 1)?;
        return target.finish();
    }
    smooth(&mut finest, progress)?;
    let pen = Pen::of(&layout);
    holes.each(|row, columns, rim| {
        let samples = target.row(row);
        for column in columns {
            let height = finest.height(column, row).clamp(rim.0, rim.1);
            pen.put(samples, column as usize, sample_of(&layout, height, rim));
        }
    });
    progress.step(1, 1)?;
    target.finish()
}

/// Fails where the grid's file was cut while it was read.
fn refuse_cut(grid: &Grid) -> Result<(), DecodeError> {
    grid.look_at_file();
    if grid.damaged() {
        let expected = "a file that stays whole while it is read";
        return Err(DecodeError::wrong("samples", "a file that was cut meanwhile", expected));
    }
    Ok(())
}

/// Works the heights of the holes out, from the coarsest grid to the finest.
fn smooth(finest: &mut Level, progress: &Progress) -> Result<(), DecodeError> {
    let mut levels = Vec::new();
    let mut next = finest.coarser()?;
    while let Some(level) = next {
        next = level.coarser()?;
        levels.push(level);
    }
    let cells = |level: &Level| level.cells();
    let all: u64 = levels.iter().map(cells).sum::<u64>() + finest.cells();
    let mut done = 0;
    let mut coarser: Option<Level> = None;
    for mut level in levels.into_iter().rev() {
        level.settle(coarser.as_ref(), ROUNDS, progress)?;
        done += level.cells();
        progress.step(all + done, 2 * all)?;
        coarser = Some(level);
    }
    finest.settle(coarser.as_ref(), ROUNDS, progress)
}

/// The same samples row after row from byte 0.
fn packed(layout: &GridLayout) -> Result<GridLayout, DecodeError> {
    let row = u64::from(layout.columns()) * layout.sample().bytes() as u64;
    let packed = layout.with_offset(0).and_then(|layout| layout.with_row_stride(row));
    packed.map_err(|error| DecodeError::Grid(error.into()))
}

/// The sample for a height; never one that is void, and never beyond the rim by rounding.
fn sample_of(layout: &GridLayout, height: f64, rim: (f64, f64)) -> f64 {
    let stored = |height: f64| (height - layout.value_offset()) / layout.scale();
    let (a, b) = (stored(rim.0), stored(rim.1));
    let (least, most) = (a.min(b), a.max(b));
    let is_whole = !matches!(layout.sample(), SampleType::F32 | SampleType::F64);
    let sample = match layout.sample() {
        // The rim's own samples are whole: what they come to in metres and back may miss that a little.
        _ if is_whole => stored(height).round().clamp(least.round(), most.round()),
        SampleType::F32 => f64::from((stored(height) as f32).clamp(least as f32, most as f32)),
        _ => stored(height).clamp(least, most),
    };
    if Some(sample) != layout.void() {
        return sample;
    }
    // A sample of the rim is not.
    if is_whole { a.round() } else { a }
}

#[cfg(all(test, target_os = "linux"))]
mod tests {
    use super::*;
    use std::fs::{self, OpenOptions};
    use surface::ByteOrder;

    #[test]
    fn a_file_that_was_cut_is_refused_and_not_filled_with_zeros() {
        let path = std::env::temp_dir().join(format!("fill-cut-{}", std::process::id()));
        fs::write(&path, vec![1; 1 << 16]).unwrap();
        let layout =
            GridLayout::packed(128, 256, 1.0, 1.0, SampleType::I16, ByteOrder::Little).unwrap();
        let grid = Grid::open(&path, layout).unwrap();
        assert!(fill(&grid, &Progress::new()).is_ok());
        OpenOptions::new().write(true).open(&path).unwrap().set_len(1 << 14).unwrap();
        let refused = fill(&grid, &Progress::new());
        fs::remove_file(&path).unwrap();
        assert!(matches!(refused, Err(DecodeError::Wrong { .. })));
    }
}
