//! Strips and tiles: which part of the raster each holds, and where in the file it lies.

use super::compression::Compression;
use super::directory::{Directory, name};
use super::picture::Picture;
use crate::error::DecodeError;
use crate::source::Source;
use std::ops::Range;

/// Bytes of a row that every thread may hold, whatever the file: 16 million samples of 32 bits.
const MOST_ROW: u64 = 1 << 26;

/// Times that a row may be longer than its file where it is longer than that.
const MOST_ROW_GROWTH: u64 = 16;

/// The chunks of the first band, or of all bands where they lie side by side.
#[derive(Debug)]
pub struct Chunks {
    is_tiled: bool,
    columns: u32,
    rows: u32,
    across: u64,
    picture_columns: u32,
    picture_rows: u32,
    row_bytes: u64,
    places: Vec<Place>,
}

/// Where a chunk's packed bytes lie; no bytes mean that it was left out, as GDAL does with voids.
#[derive(Clone, Copy, Debug)]
pub struct Place {
    /// From the start of the file.
    pub offset: u64,
    /// Number of bytes.
    pub length: u64,
}

impl Place {
    /// Whether the chunk was left out.
    pub fn is_absent(self) -> bool {
        self.length == 0
    }
}

impl Chunks {
    /// Reads the tags, and checks that every chunk lies in the file and may hold what it should.
    pub fn read(
        source: &Source,
        directory: &Directory,
        picture: &Picture,
    ) -> Result<Self, DecodeError> {
        let is_tiled = directory.has(322) || directory.has(323);
        let (columns, rows) = if is_tiled {
            (tile_side(source, directory, 322)?, tile_side(source, directory, 323)?)
        } else {
            (picture.columns, strip_rows(source, directory, picture)?)
        };
        let across = u64::from(picture.columns.div_ceil(columns));
        let mut chunks = Self {
            is_tiled,
            columns,
            rows,
            across,
            picture_columns: picture.columns,
            picture_rows: picture.rows,
            // 2^32 samples of 2^16 bands of 2^3 bytes are what 64 bits hold.
            row_bytes: u64::from(columns) * picture.sample_step(),
            places: Vec::new(),
        };
        let most_row = source.length().saturating_mul(MOST_ROW_GROWTH).max(MOST_ROW);
        if chunks.row_bytes > most_row {
            return Err(DecodeError::wrong(
                "row of samples",
                format!("{} bytes", chunks.row_bytes),
                format!("at most {most_row} in a file of {} bytes", source.length()),
            ));
        }
        let count = across * u64::from(picture.rows.div_ceil(rows));
        chunks.places = chunks.read_places(source, directory, picture, count)?;
        for index in 0..chunks.places.len() {
            chunks.check(index, source.length(), picture.compression)?;
        }
        Ok(chunks)
    }

    /// Whether they are tiles.
    pub fn is_tiled(&self) -> bool {
        self.is_tiled
    }

    /// Columns and rows of a chunk, the last strip's apart.
    pub fn size(&self) -> (u32, u32) {
        (self.columns, self.rows)
    }

    /// Chunks side by side.
    pub fn across(&self) -> u64 {
        self.across
    }

    /// Bytes of a chunk's row, unpacked.
    pub fn row_bytes(&self) -> u64 {
        self.row_bytes
    }

    /// The places of all chunks, from west to east and then from top to bottom.
    pub fn places(&self) -> &[Place] {
        &self.places
    }

    /// The raster's columns in the chunks at a place across.
    pub fn columns_of(&self, across: u64) -> Range<u32> {
        let first = across * u64::from(self.columns);
        let end = (first + u64::from(self.columns)).min(u64::from(self.picture_columns));
        first as u32..end as u32
    }

    /// The raster's rows in the chunks at a place down.
    pub fn rows_of(&self, down: u64) -> Range<u32> {
        let first = down * u64::from(self.rows);
        let end = (first + u64::from(self.rows)).min(u64::from(self.picture_rows));
        first as u32..end as u32
    }

    /// Rows that a chunk holds, those beyond the raster's last included.
    pub fn stored_rows(&self, down: u64) -> u64 {
        if self.is_tiled {
            u64::from(self.rows)
        } else {
            let rows = self.rows_of(down);
            u64::from(rows.end - rows.start)
        }
    }

    /// What people should look for when a chunk is wrong.
    pub fn name(&self, index: usize) -> String {
        let (down, across) = (index as u64 / self.across, index as u64 % self.across);
        if self.is_tiled {
            format!("tile {index} (row {down}, column {across})")
        } else {
            let rows = self.rows_of(down);
            format!("strip {index} (rows {} to {})", rows.start, rows.end - 1)
        }
    }

    fn read_places(
        &self,
        source: &Source,
        directory: &Directory,
        picture: &Picture,
        count: u64,
    ) -> Result<Vec<Place>, DecodeError> {
        let (offsets_tag, lengths_tag) = if self.is_tiled && directory.has(324) {
            (324, 325)
        } else {
            (273, 279) // libtiff takes them for tiles too
        };
        let values = |tag| directory.whole_numbers(source, tag, count);
        let enough = |tag, values: Vec<u64>| {
            if values.len() as u64 == count {
                return Ok(values);
            }
            Err(DecodeError::wrong(
                name(tag),
                format!("{} values", values.len()),
                format!("{count}"),
            ))
        };
        let offsets = values(offsets_tag)?.ok_or_else(|| {
            DecodeError::wrong(name(offsets_tag), "nothing", "the places of the samples")
        })?;
        let offsets = enough(offsets_tag, offsets)?;
        let lengths = match values(lengths_tag)? {
            Some(lengths) => enough(lengths_tag, lengths)?,
            None if picture.compression == Compression::None => vec![1; offsets.len()],
            // Old writers left them out where there is but one strip.
            None if count == 1 => vec![source.length().saturating_sub(offsets[0])],
            None => {
                return Err(DecodeError::wrong(
                    name(lengths_tag),
                    "nothing",
                    "the lengths of the chunks",
                ));
            }
        };
        let places = offsets.into_iter().zip(lengths).enumerate();
        Ok(places.map(|(index, place)| self.place(index, place, picture.compression)).collect())
    }

    /// Uncompressed chunks are as long as they must be, whatever the file says.
    fn place(&self, index: usize, (offset, length): (u64, u64), compression: Compression) -> Place {
        let is_absent = offset == 0 || length == 0;
        let length = match compression {
            _ if is_absent => 0,
            Compression::None => self.unpacked_length(index),
            _ => length,
        };
        Place { offset, length }
    }

    fn unpacked_length(&self, index: usize) -> u64 {
        self.row_bytes.saturating_mul(self.stored_rows(index as u64 / self.across))
    }

    fn check(&self, index: usize, file: u64, compression: Compression) -> Result<(), DecodeError> {
        let place = self.places[index];
        if place.is_absent() {
            return Ok(());
        }
        if place.offset.checked_add(place.length).is_none_or(|end| end > file) {
            return Err(DecodeError::wrong(
                self.name(index),
                format!("{} bytes from byte {} in a file of {file}", place.length, place.offset),
                "a place within the file: it is cut short, or damaged",
            ));
        }
        let most = place.length.saturating_mul(compression.most_growth());
        let unpacked = self.unpacked_length(index);
        if unpacked > most {
            return Err(DecodeError::wrong(
                self.name(index),
                format!(
                    "{} bytes ({}) for {unpacked} bytes of samples",
                    place.length,
                    compression.name()
                ),
                format!("at most {most} bytes from so few"),
            ));
        }
        Ok(())
    }
}

fn tile_side(source: &Source, directory: &Directory, tag: u16) -> Result<u32, DecodeError> {
    let found = directory.number(source, tag)?;
    let side = found.and_then(|side| u32::try_from(side).ok()).filter(|&side| side > 0);
    side.ok_or_else(|| {
        let found = found.map_or_else(|| "nothing".to_owned(), |side| side.to_string());
        DecodeError::wrong(name(tag), found, format!("from 1 to {}", u32::MAX))
    })
}

/// Rows of a strip; the whole raster is one where the file does not say.
fn strip_rows(
    source: &Source,
    directory: &Directory,
    picture: &Picture,
) -> Result<u32, DecodeError> {
    let rows = directory.number(source, 278)?.unwrap_or(u64::from(picture.rows));
    if rows == 0 {
        return Err(DecodeError::wrong(name(278), 0, "at least 1"));
    }
    Ok(rows.min(u64::from(picture.rows)) as u32)
}
