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
const HEIGHTS: (u32, u32) = (146, 170);
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
    let (mut done, mut record) = (0, start);
    while done < count {
        let bytes = window.at(record, LONGEST)?;
        let (first, most) = if done == 0 { first_fields(bytes) } else { (0, HEIGHTS.1) };
        let here = (count - done).min(most);
        let behind = first + here as usize * FIELD;
        let line = line_end_from(bytes, first);
        // Blanks at the end of a line may be gone, and blank heights with them.
        let fields = bytes.get(first..line.unwrap_or(bytes.len()).min(behind)).unwrap_or_default();
        let mut read = 0;
        for field in fields.chunks(FIELD) {
            let is_cut = field.len() < FIELD && line.is_none();
            let height = match whole(field) {
                _ if is_cut => break,
                Whole::Number(number) => Some(number),
                Whole::Blank => None,
                Whole::Wrong => {
                    let found = String::from_utf8_lossy(field).into_owned();
                    return Err(Wrong::Height { number: done + read + 1, found });
                }
            };
            take(done + read, height);
            read += 1;
        }
        if read == 0 || read < here && line.is_none() {
            return Ok((done + read, record + bytes.len() as u64));
        }
        (read..here).for_each(|number| take(done + number, None));
        done += here;
        record += next_record(bytes, behind, line) as u64;
    }
    Ok((done, record))
}

/// Where the heights of a profile's first record begin, and how many it has at the most.
fn first_fields(bytes: &[u8]) -> (usize, u32) {
    (HEAD + line_end(bytes.get(HEAD..).unwrap_or_default()), HEIGHTS.0)
}

/// The place of the first line end from `first` on. Most files have none, which is quickly seen.
fn line_end_from(bytes: &[u8], first: usize) -> Option<usize> {
    if !bytes.contains(&b'\n') && !bytes.contains(&b'\r') {
        return None;
    }
    let rest = bytes.get(first..)?;
    rest.iter().position(|byte| matches!(byte, b'\n' | b'\r')).map(|place| first + place)
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
