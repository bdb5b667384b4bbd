//! Esri ASCII grids: a short header, then heights as text, row after row from the north.
//!
//! Source: Esri, "ArcGIS Pro: Esri ASCII raster format". Lines mean nothing: a row may be broken over
//! several.

mod header;
mod number;
mod stored;
mod words;

pub use header::{Corner, Header};
pub use stored::Stored;

use crate::error::DecodeError;
use crate::pen::Pen;
use crate::progress::Progress;
use crate::region::{check_region, column_in_region};
use crate::source::Source;
use crate::target::Target;
use header::no_number;
use std::path::Path;
use stored::{Found, Nodata};
use surface::{Grid, GridLayout};
use words::{Read, Words};

/// An Esri ASCII grid whose header was read.
pub struct EsriAscii {
    source: Source,
    header: Header,
}

/// What the heights of a grid are.
#[derive(Clone, Copy, Debug)]
pub struct Heights {
    /// How they are stored once they are decoded.
    pub stored: Stored,
    /// Lowest and highest; `None` where every height is void.
    pub range: Option<(f64, f64)>,
    /// How many are void.
    pub voids: u64,
}

impl EsriAscii {
    /// Reads the header.
    pub fn open(path: &Path) -> Result<Self, DecodeError> {
        let source = Source::open(path)?;
        let header = Header::read(&source)?;
        Ok(Self { source, header })
    }

    /// The header.
    pub fn header(&self) -> &Header {
        &self.header
    }

    /// Looks at every height: what they are decides how they are stored, and a word that is no number, a
    /// height too few or too many is found here.
    pub fn heights(&self, progress: &Progress) -> Result<Heights, DecodeError> {
        let header = &self.header;
        let nodata = Nodata(header.nodata);
        let mut found = Found::default();
        let mut words = Words::new(&self.source, header.heights);
        for row in 0..header.rows {
            progress.step(words.place(), self.source.length())?;
            for column in 0..header.columns {
                let height = height(&mut words, header, column, row)?;
                if nodata.is(height) {
                    found.voids += 1;
                } else {
                    found.add(height);
                }
            }
        }
        if let Some(word) = words.next()? {
            let found = format!("more, \"{}\"", String::from_utf8_lossy(word).escape_debug());
            let expected = format!("{} for NCOLS and NROWS", count(header));
            return Err(DecodeError::wrong("number of heights", found, expected));
        }
        Ok(Heights {
            stored: Stored::of(&found, nodata),
            range: (found.heights > 0).then_some((found.lowest, found.highest)),
            voids: found.voids,
        })
    }

    /// Decodes a region: `layout` has its size, and type and void of [`Heights::stored`] (no void for NaN).
    pub fn decode(
        &self,
        layout: GridLayout,
        first_column: u32,
        first_row: u32,
        progress: &Progress,
        cache: Option<&Path>,
    ) -> Result<Grid, DecodeError> {
        let header = &self.header;
        check_region(&layout, (first_column, first_row), (header.columns, header.rows))?;
        let mut target = Target::new(layout, cache)?;
        let (pen, nodata) = (Pen::of(&layout), Nodata(header.nodata));
        let void = layout.void().unwrap_or(f64::NAN);
        let mut words = Words::new(&self.source, header.heights);
        for row in 0..first_row {
            progress.step(row.into(), u64::from(first_row) + u64::from(layout.rows()))?;
            for column in 0..header.columns {
                height(&mut words, header, column, row)?;
            }
        }
        for row in first_row..first_row + layout.rows() {
            progress.step(row.into(), u64::from(first_row) + u64::from(layout.rows()))?;
            let samples = target.row(row - first_row);
            for column in 0..header.columns {
                let height = height(&mut words, header, column, row)?;
                let index = column_in_region(column, first_column, header.columns);
                if index >= layout.columns() {
                    continue;
                }
                if nodata.is(height) {
                    pen.put(samples, index as usize, void);
                } else if stored::fits(layout.sample(), height) {
                    pen.put(samples, index as usize, height);
                } else {
                    let expected = format!("one that {:?} holds", layout.sample());
                    return Err(DecodeError::wrong(place(column, row), height, expected));
                }
            }
        }
        progress.step(1, 1)?;
        target.finish()
    }
}

/// The next height, which is that of this column and row.
#[inline(always)]
fn height(
    words: &mut Words<'_>,
    header: &Header,
    column: u32,
    row: u32,
) -> Result<f64, DecodeError> {
    match words.number()? {
        Read::Number(height) => Ok(height),
        Read::Other(word) => Err(no_number(&place(column, row), word)),
        Read::End => {
            let found = u64::from(row) * u64::from(header.columns) + u64::from(column);
            let expected = format!("{} for NCOLS and NROWS: the file is cut short", count(header));
            Err(DecodeError::wrong("number of heights", found, expected))
        }
    }
}

fn place(column: u32, row: u32) -> String {
    format!("height in row {}, column {}", row + 1, column + 1)
}

fn count(header: &Header) -> u64 {
    u64::from(header.rows) * u64::from(header.columns)
}
