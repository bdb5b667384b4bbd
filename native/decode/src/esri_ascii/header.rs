//! The header: a word and a number a line, in any order and letter case.
//!
//! Source: Esri, "ArcGIS Pro: Esri ASCII raster format"; DX and DY in place of CELLSIZE as GDAL and SURFER
//! write them.

use super::number::number;
use super::words::Words;
use crate::error::DecodeError;
use crate::source::Source;

/// What a corner's coordinates mean.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Corner {
    /// The outer corner of the lower left cell.
    Corner,
    /// The centre of the lower left cell.
    Center,
}

/// The header.
#[derive(Clone, Debug, PartialEq)]
pub struct Header {
    /// Columns, at least 2.
    pub columns: u32,
    /// Rows, at least 2.
    pub rows: u32,
    /// XLLCORNER or XLLCENTER.
    pub x: (f64, Corner),
    /// YLLCORNER or YLLCENTER.
    pub y: (f64, Corner),
    /// Between columns and between rows, above 0.
    pub step: (f64, f64),
    /// The value that means "no data"; may be NaN.
    pub nodata: f64,
    /// Place of the first height in the file.
    pub heights: u64,
}

/// What NODATA_VALUE is where it is left out.
const NODATA: f64 = -9999.0;

const KNOWN: [&str; 11] = [
    "NCOLS",
    "NROWS",
    "XLLCORNER",
    "XLLCENTER",
    "YLLCORNER",
    "YLLCENTER",
    "CELLSIZE",
    "DX",
    "DY",
    "NODATA_VALUE",
    "NODATA",
];

/// Letters of a word that an error repeats.
const SHOWN: usize = 40;

impl Header {
    /// Reads the header.
    pub fn read(source: &Source) -> Result<Self, DecodeError> {
        let mut words = Words::new(source, byte_order_mark(source)?);
        let mut found: [Option<f64>; KNOWN.len()] = [None; KNOWN.len()];
        let heights = loop {
            let place = words.place();
            let Some(word) = words.next()? else { break place };
            if number(word).is_some() {
                break place;
            }
            let name = String::from_utf8_lossy(word).to_ascii_uppercase();
            let Some(index) = KNOWN.iter().position(|known| *known == name) else {
                return Err(DecodeError::wrong(
                    "header",
                    format!("\"{}\"", shown(word)),
                    "NCOLS, NROWS, XLLCORNER or XLLCENTER, YLLCORNER or YLLCENTER, CELLSIZE, NODATA_VALUE",
                ));
            };
            let value = words.next()?.unwrap_or_default();
            let read = number(value).ok_or_else(|| no_number(KNOWN[index], value))?;
            let before = found[index].replace(read);
            if before.is_some_and(|before| before != read) {
                let both = format!("{} and {read}", before.unwrap_or_default());
                return Err(DecodeError::wrong(KNOWN[index], both, "one value"));
            }
        };
        Fields(found).header(heights, source.length())
    }
}

/// The number of each of [`KNOWN`], where the header has it.
struct Fields([Option<f64>; KNOWN.len()]);

impl Fields {
    fn header(&self, heights: u64, length: u64) -> Result<Header, DecodeError> {
        let (columns, rows) = (self.count("NCOLS")?, self.count("NROWS")?);
        // A digit and what parts it from the next.
        let most = length.saturating_sub(heights).div_ceil(2);
        if u64::from(columns) * u64::from(rows) > most {
            return Err(DecodeError::wrong(
                "NCOLS and NROWS",
                format!("{columns} x {rows} heights in {} bytes", length.saturating_sub(heights)),
                format!(
                    "at most {most} heights in a file of this length: it is cut short, or they are wrong"
                ),
            ));
        }
        Ok(Header {
            columns,
            rows,
            x: self.corner("XLLCORNER", "XLLCENTER")?,
            y: self.corner("YLLCORNER", "YLLCENTER")?,
            step: self.step()?,
            nodata: match (self.of("NODATA_VALUE"), self.of("NODATA")) {
                (Some(one), Some(other)) if one != other => {
                    return Err(DecodeError::wrong(
                        "NODATA_VALUE",
                        format!("{one}, and {other} as NODATA"),
                        "one of them",
                    ));
                }
                (one, other) => one.or(other).unwrap_or(NODATA),
            },
            heights,
        })
    }

    fn of(&self, name: &str) -> Option<f64> {
        KNOWN.iter().position(|known| *known == name).and_then(|index| self.0[index])
    }

    fn count(&self, name: &str) -> Result<u32, DecodeError> {
        let found = self.of(name).ok_or_else(|| missing(name))?;
        if (2.0..=f64::from(1 << 30)).contains(&found) && found == found.trunc() {
            return Ok(found as u32);
        }
        Err(DecodeError::wrong(name, found, "a whole number from 2 on"))
    }

    fn corner(&self, corner: &str, center: &str) -> Result<(f64, Corner), DecodeError> {
        match (self.of(corner), self.of(center)) {
            (Some(_), Some(_)) => {
                Err(DecodeError::wrong(corner, format!("{center} as well"), "one of them"))
            }
            (Some(place), None) if place.is_finite() => Ok((place, Corner::Corner)),
            (None, Some(place)) if place.is_finite() => Ok((place, Corner::Center)),
            (None, None) => Err(missing(&format!("{corner} or {center}"))),
            (one, other) => Err(DecodeError::wrong(
                corner,
                one.or(other).unwrap_or_default(),
                "a finite number",
            )),
        }
    }

    fn step(&self) -> Result<(f64, f64), DecodeError> {
        let (both, across, down) = (self.of("CELLSIZE"), self.of("DX"), self.of("DY"));
        let (Some(x), Some(y)) = (across.or(both), down.or(both)) else {
            return Err(missing("CELLSIZE"));
        };
        for (name, step) in [("DX", x), ("DY", y)] {
            let name = if both.is_some() { "CELLSIZE" } else { name };
            if !(step > 0.0 && step.is_finite()) {
                return Err(DecodeError::wrong(name, step, "a number above 0"));
            }
            if both.is_some_and(|both| both != step) {
                let found = format!("{} beside a step of {step}", both.unwrap_or_default());
                return Err(DecodeError::wrong(name, found, "either CELLSIZE or DX and DY"));
            }
        }
        Ok((x, y))
    }
}

/// What a word should have been.
pub fn no_number(field: &str, word: &[u8]) -> DecodeError {
    let expected = if word.contains(&b',') {
        "a number with a decimal point, not a comma"
    } else {
        "a number"
    };
    let found = if word.is_empty() { "nothing".into() } else { format!("\"{}\"", shown(word)) };
    DecodeError::wrong(field, found, expected)
}

fn missing(field: &str) -> DecodeError {
    DecodeError::wrong(field, "nothing", "it in the header of an Esri ASCII grid")
}

fn shown(word: &[u8]) -> String {
    let text: String = String::from_utf8_lossy(word).chars().take(SHOWN).collect();
    text.escape_debug().to_string()
}

/// Bytes that some editors put in front of a text.
fn byte_order_mark(source: &Source) -> Result<u64, DecodeError> {
    let mut mark = [0; 3];
    if source.length() < 3 {
        return Ok(0);
    }
    source.fill(&mut mark, 0)?;
    Ok(if mark == [0xef, 0xbb, 0xbf] { 3 } else { 0 })
}
