//! The B records: profiles of heights from south to north.
//!
//! Source: "Standards for Digital Elevation Models", Part 2 (1998), table 2-2. A profile is one record of
//! 1024 bytes or several: 144 bytes of its own facts and 146 heights in the first, 170 in each later one,
//! the rest of each blank. Files that went through text tools have line ends after the records, whose
//! blanks may be gone.

use super::field::{Whole, real, whole};
use crate::error::DecodeError;
use crate::window::Window;

/// Bytes of a record without a line end.
const RECORD: usize = 1024;
/// Bytes of a profile's own facts.
pub const HEAD: usize = 144;
/// Columns of a height.
const FIELD: usize = 6;
/// Heights in the first record of a profile, and in each later one.
const HEIGHTS: (usize, usize) = (146, 170);
/// Bytes that a record may take at the most, with its line end.
const LONGEST: usize = RECORD + 8;

/// What the beginning of a B record says.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Head {
    /// Heights in the profile.
    pub heights: u32,
    /// East of the first, southernmost height.
    pub x: f64,
    /// North of it.
    pub y: f64,
    /// Added to every height of the profile, in the unit of heights.
    pub local_datum: f64,
}

impl Head {
    /// Reads the beginning of a record; `None` where there is no profile.
    ///
    /// Strict, for it also tells where profiles begin: every field ends in its last column.
    pub fn read(bytes: &[u8]) -> Option<Self> {
        if bytes.len() < HEAD {
            return None;
        }
        let count = |index: usize| {
            let field = &bytes[index * FIELD..][..FIELD];
            match whole(field) {
                Whole::Number(number) if field[FIELD - 1].is_ascii_digit() => Some(number),
                _ => None,
            }
        };
        let double = |index: usize| real(&bytes[24 + index * 24..][..24]).ok().flatten();
        let (_, _) = (count(0).filter(|row| *row >= 1)?, count(1).filter(|column| *column >= 1)?);
        let heights = count(2).filter(|heights| *heights >= 1)?;
        count(3).filter(|columns| *columns == 1)?;
        Some(Self {
            heights: heights as u32,
            x: double(0)?,
            y: double(1)?,
            local_datum: real(&bytes[72..96]).ok()?.unwrap_or(0.0),
        })
    }
}

/// Where the first profile begins: behind an A record of 864, 893, 918, 1024 or as many bytes, and
/// behind its line end.
pub fn first_profile(bytes: &[u8], shortest: usize) -> Option<usize> {
    (shortest..=RECORD + 2)
        .find(|start| bytes.get(*start..).is_some_and(|rest| Head::read(rest).is_some()))
}

/// Hands every height of the profile at `start` to `take` (its number from the south; `None` where
/// the field is blank), as many as the file has.
///
/// Gives how many those were, and the place behind the profile's last record.
pub fn heights(
    window: &mut Window<'_>,
    start: u64,
    count: u32,
    mut take: impl FnMut(u32, Option<i32>),
) -> Result<(u32, u64), Wrong> {
    let (mut done, mut record, mut skipped, mut room) = (0, start, HEAD, HEIGHTS.0);
    loop {
        let here = (count - done).min(room as u32) as usize;
        let bytes = window.at(record, LONGEST)?;
        let after_head = bytes.get(skipped..).unwrap_or_default();
        let fields = skipped + if done == 0 { line_end(after_head) } else { 0 };
        let behind = fields + here * FIELD;
        let line = bytes.iter().position(|byte| matches!(byte, b'\n' | b'\r'));
        // Blanks at the end of a line may be gone, and blank heights with them.
        let line = line.filter(|end| *end >= fields);
        let end = line.map_or(bytes.len(), |end| end.min(behind)).max(fields.min(bytes.len()));
        for (index, field) in bytes[fields.min(end)..end].chunks(FIELD).enumerate() {
            let is_cut = field.len() < FIELD && line.is_none();
            match whole(field) {
                _ if is_cut => return Ok((done + index as u32, record + bytes.len() as u64)),
                Whole::Number(number) => take(done + index as u32, Some(number)),
                Whole::Blank => take(done + index as u32, None),
                Whole::Wrong => {
                    let found = String::from_utf8_lossy(field).into_owned();
                    return Err(Wrong::Height { number: done + index as u32 + 1, found });
                }
            }
        }
        let read = (end - fields.min(end)).div_ceil(FIELD) as u32;
        let is_over = read < here as u32 && line.is_none();
        if is_over || read == 0 {
            return Ok((done + read, record + bytes.len() as u64));
        }
        for number in read..here as u32 {
            take(done + number, None);
        }
        done += here as u32;
        record += next_record(bytes, behind, line) as u64;
        if done == count {
            return Ok((done, record));
        }
        (skipped, room) = (0, HEIGHTS.1);
    }
}

/// What went wrong in a profile.
pub enum Wrong {
    /// A field that is no whole number.
    Height {
        /// Of the height, from 1.
        number: u32,
        /// The field.
        found: String,
    },
    /// Not the profile's fault.
    Other(DecodeError),
}

impl From<DecodeError> for Wrong {
    fn from(error: DecodeError) -> Self {
        Self::Other(error)
    }
}

/// Where the next record begins after one whose last height ends at `behind`: behind the line end,
/// else after 1024 bytes, else where something stands in what should be blank.
fn next_record(bytes: &[u8], behind: usize, line: Option<usize>) -> usize {
    let padding = bytes.get(behind..line.unwrap_or(RECORD).min(bytes.len())).unwrap_or_default();
    if padding.iter().any(|byte| *byte != b' ') {
        return behind;
    }
    match line {
        Some(end) => end + line_end(&bytes[end..]),
        None => RECORD.max(behind),
    }
}

/// Bytes of the line end at the beginning of these.
fn line_end(bytes: &[u8]) -> usize {
    match bytes {
        [b'\r', b'\n', ..] => 2,
        [b'\r' | b'\n', ..] => 1,
        _ => 0,
    }
}
