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
use crate::room::{check_region, room};
use crate::source::Source;
use header::no_number;
use number::number;
use std::path::Path;
use stored::{Found, Nodata};
use surface::{Grid, GridLayout};
use words::{LONGEST, Words};

/// An Esri ASCII grid whose header was read and whose heights were all looked at once.
pub struct EsriAscii {
    source: Source,
    header: Header,
    found: Found,
    stored: Stored,
}

impl EsriAscii {
    /// Reads the header, and every height: what they are decides how they are stored, and a word that
    /// is no number, a height too few or too many is found here.
    pub fn open(path: &Path, progress: &Progress) -> Result<Self, DecodeError> {
        let source = Source::open(path)?;
        let header = Header::read(&source)?;
        let nodata = Nodata(header.nodata);
        let mut found = Found::default();
        let mut words = Words::new(&source, header.heights);
        for row in 0..header.rows {
            progress.step(words.place(), source.length())?;
            for column in 0..header.columns {
                let height = height(&mut words, &header, column, row)?;
                if nodata.is(height) {
                    found.voids += 1;
                } else {
                    found.add(height);
                }
            }
        }
        if let Some(word) = words.next()? {
            let found = format!("more, \"{}\"", String::from_utf8_lossy(word).escape_debug());
            let expected = format!("{} for NCOLS and NROWS", count(&header));
            return Err(DecodeError::wrong("number of heights", found, expected));
        }
        let stored = Stored::of(&found, nodata);
        Ok(Self { source, header, found, stored })
    }

    /// The header.
    pub fn header(&self) -> &Header {
        &self.header
    }

    /// How the heights are stored once they are decoded.
    pub fn stored(&self) -> &Stored {
        &self.stored
    }

    /// Lowest and highest height; `None` where every height is void.
    pub fn range(&self) -> Option<(f64, f64)> {
        (self.found.heights > 0).then_some((self.found.lowest, self.found.highest))
    }

    /// How many heights are void.
    pub fn voids(&self) -> u64 {
        self.found.voids
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
        let header = &self.header;
        check_region(&layout, (first_column, first_row), (header.columns, header.rows))?;
        self.stored.check(&layout)?;
        let mut target = room(layout, cache)?;
        let (pen, nodata) = (Pen::of(&layout), Nodata(header.nodata));
        let mut words = Words::new(&self.source, header.heights);
        for _ in 0..u64::from(first_row) * u64::from(header.columns) {
            words.next()?;
        }
        for row in 0..layout.rows() {
            progress.step(row.into(), layout.rows().into())?;
            let samples = target.row(row);
            for column in 0..header.columns {
                // What lies east of the region wraps around to far beyond it.
                let index = column.wrapping_sub(first_column);
                if index < layout.columns() {
                    let height = height(&mut words, header, column, first_row + row)?;
                    let sample = if nodata.is(height) { self.stored.void } else { height };
                    pen.put(samples, index as usize, sample);
                } else {
                    words.next()?;
                }
            }
        }
        progress.step(1, 1)?;
        target.finish()
    }
}

/// The next height, which is that of this column and row.
#[inline]
fn height(
    words: &mut Words<'_>,
    header: &Header,
    column: u32,
    row: u32,
) -> Result<f64, DecodeError> {
    let Some(word) = words.next()? else {
        let found = u64::from(row) * u64::from(header.columns) + u64::from(column);
        let expected = format!("{} for NCOLS and NROWS: the file is cut short", count(header));
        return Err(DecodeError::wrong("number of heights", found, expected));
    };
    match number(word) {
        Some(height) if word.len() < LONGEST => Ok(height),
        _ => Err(no_number(&format!("height in row {}, column {}", row + 1, column + 1), word)),
    }
}

fn count(header: &Header) -> u64 {
    u64::from(header.rows) * u64::from(header.columns)
}
