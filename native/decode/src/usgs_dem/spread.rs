//! How far the profiles spread: the smallest grid that holds them all.

use super::Profile;
use super::header::Header;
use super::profile::Head;
use super::stored::Found;
use crate::error::DecodeError;

/// Samples that a grid may have for every height in the file: quadrangles lie askew in their grids, but
/// a profile beyond all others is a mistake, and would take memory that no file of this size needs.
const MOST_FOR_A_HEIGHT: u64 = 64;

/// Samples that any file may ask for.
const ALWAYS: u64 = 1 << 20;

/// Of a cell, by which profiles may miss their column or row before it is told.
const ASKEW: f64 = 0.01;

/// A grid in the file's unit.
#[derive(Clone, Copy, Debug)]
pub struct Spread {
    /// Columns.
    pub columns: u32,
    /// Rows.
    pub rows: u32,
    /// East of column 0.
    pub west: f64,
    south: f64,
    step: (f64, f64),
}

impl Spread {
    /// Of these profiles.
    pub fn of(
        header: &Header,
        profiles: &[Profile],
        found: &Found,
        notes: &mut Vec<String>,
    ) -> Result<Self, DecodeError> {
        let least = |of: fn(&Profile) -> f64| profiles.iter().map(of).fold(f64::INFINITY, f64::min);
        let (west, south) = (least(|profile| profile.head.x), least(|profile| profile.head.y));
        let mut spread = Self { columns: 0, rows: 0, west, south, step: header.step };
        let cells = |of: &dyn Fn(&Profile) -> f64| profiles.iter().map(of).fold(0.0, f64::max);
        let columns = cells(&|profile| spread.across(&profile.head).round()) + 1.0;
        let rows =
            cells(&|profile| spread.up(&profile.head).round() + f64::from(profile.whole - 1)) + 1.0;
        let most = ALWAYS.max(MOST_FOR_A_HEIGHT.saturating_mul(found.heights)) as f64;
        if !(columns >= 2.0 && rows >= 2.0) {
            return Err(DecodeError::wrong(
                "profiles",
                format!("{columns} columns and {rows} rows"),
                "at least 2 of each",
            ));
        }
        if columns * rows > most || columns.max(rows) > f64::from(i32::MAX) {
            return Err(DecodeError::wrong(
                "places of the profiles",
                format!("{} heights spread over {columns:e} x {rows:e} cells", found.heights),
                "profiles side by side, DX and DY apart",
            ));
        }
        (spread.columns, spread.rows) = (columns as u32, rows as u32);
        spread.check_columns(profiles)?;
        spread.tell_askew(profiles, notes);
        Ok(spread)
    }

    /// North of row 0.
    pub fn north(&self) -> f64 {
        self.south + f64::from(self.rows - 1) * self.step.1
    }

    /// Column of a profile.
    pub fn column(&self, head: &Head) -> u32 {
        self.across(head).round() as u32
    }

    /// Row of a profile's southernmost height.
    pub fn row(&self, head: &Head) -> u32 {
        self.rows - 1 - self.up(head).round() as u32
    }

    fn across(&self, head: &Head) -> f64 {
        (head.x - self.west) / self.step.0
    }

    fn up(&self, head: &Head) -> f64 {
        (head.y - self.south) / self.step.1
    }

    /// Two profiles in one column: the distance that the file speaks of is not theirs.
    fn check_columns(&self, profiles: &[Profile]) -> Result<(), DecodeError> {
        let mut is_taken = vec![false; self.columns as usize];
        for (index, profile) in profiles.iter().enumerate() {
            let column = self.column(&profile.head) as usize;
            if std::mem::replace(&mut is_taken[column], true) {
                return Err(DecodeError::wrong(
                    "DX (bytes 817-828)",
                    format!("{} with profile {} in the column of another", self.step.0, index + 1),
                    "the distance between profiles",
                ));
            }
        }
        Ok(())
    }

    fn tell_askew(&self, profiles: &[Profile], notes: &mut Vec<String>) {
        let off = |cells: f64| (cells - cells.round()).abs();
        let worst = profiles
            .iter()
            .map(|profile| off(self.across(&profile.head)).max(off(self.up(&profile.head))))
            .fold(0.0, f64::max);
        if worst > ASKEW {
            notes.push(format!(
                "Profiles lie up to {worst:.2} cells beside the grid's columns and rows: they are moved to the nearest."
            ));
        }
    }
}
