//! USGS digital elevation models as text: 7.5' and 15' quadrangles in UTM, 1 degree in arc-seconds.
//!
//! Source: U.S. Geological Survey, "Standards for Digital Elevation Models", Part 2: Specifications (1998).
//! A file is an A record (facts), a B record for each profile, and a C record (accuracy, not read). The
//! profiles run from south to north, one beside the other from west to east, and begin and end where the
//! edge of the quadrangle does: the grid here is the smallest that holds them all, void outside of them.

mod field;
mod header;
mod profile;
mod spread;
mod stored;

pub use header::{Header, System, Unit};
pub use stored::Stored;

use crate::error::DecodeError;
use crate::pen::Pen;
use crate::progress::Progress;
use crate::region::{check_region, column_in_region};
use crate::source::Source;
use crate::target::Target;
use crate::window::Window;
use profile::{Head, Wrong, first_profile, heights};
use spread::Spread;
use std::path::Path;
use stored::{Found, Seen};
use surface::{Grid, GridLayout};

/// Heights that mean "no data".
const VOIDS: [i32; 2] = [-32767, -32000];

/// Bytes at the beginning of a file in which the first profile begins.
const BEGINNING: usize = 2048;

/// Bytes behind a record in which the next profile is looked for where it is not at its place.
const NEARBY: usize = 2200;

/// A USGS DEM whose A record was read and whose profiles were found and checked.
pub struct UsgsDem {
    source: Source,
    header: Header,
    profiles: Vec<Profile>,
    spread: Spread,
    stored: Stored,
    found: Found,
    notes: Vec<String>,
}

/// A profile's place in the file and what it says.
#[derive(Clone, Copy, Debug)]
struct Profile {
    start: u64,
    head: Head,
    /// Heights that the file really has.
    whole: u32,
}

impl UsgsDem {
    /// Reads the A record, finds every profile, and looks at every height once: their range decides
    /// how they are stored. What the file does not have is told in [`notes`](Self::notes).
    pub fn open(path: &Path, progress: &Progress) -> Result<Self, DecodeError> {
        let source = Source::open(path)?;
        let mut window = Window::new(&source);
        let beginning = window.at(0, BEGINNING)?;
        if beginning.len() < header::SHORTEST {
            return Err(DecodeError::wrong(
                "length",
                format!("{} bytes", beginning.len()),
                "an A record of at least 864 bytes",
            ));
        }
        let first = first_profile(beginning, header::SHORTEST);
        let header = Header::read(beginning, first.unwrap_or(BEGINNING))?;
        let first = first.ok_or_else(|| {
            DecodeError::wrong(
                "first profile",
                "no B record behind the A record",
                "one after 864 to 1024 bytes",
            )
        })?;
        let mut notes = Vec::new();
        let (profiles, found) = find(&mut window, &header, first as u64, &mut notes, progress)?;
        let spread = Spread::of(&header, &profiles, &found, &mut notes)?;
        let stored = Stored::of(&header, &found)?;
        if found.blanks > 0 {
            notes.push(format!("{} heights are blank: they are voids.", found.blanks));
        }
        Ok(Self { source, header, profiles, spread, stored, found, notes })
    }

    /// The A record.
    pub fn header(&self) -> &Header {
        &self.header
    }

    /// Columns of the grid that holds every profile.
    pub fn columns(&self) -> u32 {
        self.spread.columns
    }

    /// Rows of it.
    pub fn rows(&self) -> u32 {
        self.spread.rows
    }

    /// East and north of its north-west sample, in the file's unit.
    pub fn first(&self) -> (f64, f64) {
        (self.spread.west, self.spread.north())
    }

    /// How the heights are stored once they are decoded.
    pub fn stored(&self) -> &Stored {
        &self.stored
    }

    /// Profiles that the file has.
    pub fn profiles(&self) -> u32 {
        self.profiles.len() as u32
    }

    /// Heights that the file has, voids left out.
    pub fn heights(&self) -> u64 {
        self.found.heights
    }

    /// Lowest and highest height, in the file's unit of heights; `None` where every height is void.
    pub fn range(&self) -> Option<(f64, f64)> {
        (self.found.heights > 0).then_some((self.found.lowest, self.found.highest))
    }

    /// What a person should know: what is missing, what is odd.
    pub fn notes(&self) -> &[String] {
        &self.notes
    }

    /// Decodes a region: `layout` has its size, in the sample type of [`stored`](Self::stored).
    pub fn decode(
        &self,
        layout: GridLayout,
        first_column: u32,
        first_row: u32,
        progress: &Progress,
        cache: Option<&Path>,
    ) -> Result<Grid, DecodeError> {
        check_region(&layout, (first_column, first_row), (self.columns(), self.rows()))?;
        self.stored.check(&layout)?;
        let mut target = Target::new(layout, cache)?;
        let pen = Pen::of(&layout);
        pen.fill(target.row(0), self.stored.void);
        let voids = target.row(0).to_vec();
        (1..layout.rows()).for_each(|row| target.row(row).copy_from_slice(&voids));
        let mut window = Window::new(&self.source);
        let all = self.profiles.len() as u64;
        for (index, profile) in self.profiles.iter().enumerate() {
            progress.step(index as u64, all)?;
            let column = self.spread.column(&profile.head);
            let column = column_in_region(column, first_column, self.columns());
            if column >= layout.columns() {
                continue;
            }
            let southernmost = i64::from(self.spread.row(&profile.head)) - i64::from(first_row);
            let take = |number: u32, height: Option<i32>| {
                let row = southernmost - i64::from(number);
                if let Some(height) = height.filter(|height| !VOIDS.contains(height))
                    && (0..i64::from(layout.rows())).contains(&row)
                {
                    let (samples, column) = (target.row(row as u32), column as usize);
                    match self.stored.adds_datum(height, profile.head.local_datum) {
                        Some(sample) => pen.put(samples, column, sample),
                        None => pen.put_whole(samples, column, height),
                    }
                }
            };
            heights(&mut window, profile.start, profile.whole, take)
                .map_err(|wrong| refusal(wrong, index))?;
        }
        progress.step(all, all)?;
        target.finish()
    }
}

/// Goes from profile to profile until the file, or what it says of them, ends.
fn find(
    window: &mut Window<'_>,
    header: &Header,
    first: u64,
    notes: &mut Vec<String>,
    progress: &Progress,
) -> Result<(Vec<Profile>, Found), DecodeError> {
    let told = header.profiles.unwrap_or(u32::MAX);
    let mut profiles: Vec<Profile> = Vec::new();
    let mut found = Found::default();
    let mut next = Some(first);
    while let Some(start) = next
        && profiles.len() < told as usize
        && let Some(head) = Head::read(window.at(start, profile::HEAD)?)
    {
        let index = profiles.len();
        progress.step(start, window.length())?;
        let mut seen = Seen::default();
        let take = |_, height: Option<i32>| match height {
            Some(height) if VOIDS.contains(&height) => {}
            Some(height) => seen.add(height),
            None => seen.blanks += 1,
        };
        let (whole, behind) =
            heights(window, start, head.heights, take).map_err(|wrong| refusal(wrong, index))?;
        found.add(&seen, &head, header.resolution);
        if whole < head.heights {
            notes.push(format!(
                "The file ends in profile {}: {whole} of its {} heights are there.",
                index + 1,
                head.heights
            ));
        }
        if whole > 0 {
            profiles.push(Profile { start, head, whole });
        }
        next = (whole == head.heights).then_some(behind);
        if let Some(place) = next
            && profiles.len() < told as usize
        {
            next = nearby(window, place)?;
        }
    }
    if let Some(told) = header.profiles
        && profiles.len() < told as usize
    {
        let count = profiles.len();
        let missing = told as usize - count;
        notes.push(format!(
            "{missing} of {told} profiles are missing at the end of the file; {count} were read."
        ));
    }
    Ok((profiles, found))
}

/// The profile at a place, or shortly behind it.
fn nearby(window: &mut Window<'_>, place: u64) -> Result<Option<u64>, DecodeError> {
    let bytes = window.at(place, NEARBY)?;
    let shift = (0..bytes.len()).find(|shift| Head::read(&bytes[*shift..]).is_some());
    Ok(shift.map(|shift| place + shift as u64))
}

fn refusal(wrong: Wrong, profile: usize) -> DecodeError {
    match wrong {
        Wrong::Height { number, found } => DecodeError::wrong(
            format!("height {number} of profile {}", profile + 1),
            format!("\"{}\"", found.escape_default()),
            "a whole number in 6 columns",
        ),
        Wrong::Other(error) => error,
    }
}
