//! The header and the first directory: which tags there are, and what their values are.

use crate::error::DecodeError;
use crate::source::Source;
use surface::ByteOrder;

/// Entries that a directory may have: tags are numbers of 16 bits, each at most once.
const MOST_ENTRIES: u64 = 1 << 16;

/// Numbers that a tag may have where they are handed out: a georeference has a few.
const MOST_NUMBERS: u64 = 1 << 16;

/// Bytes of a text that is handed out: metadata in XML have a few thousand.
const MOST_TEXT: u64 = 1 << 24;

/// The tags of the first directory, in the order of the file.
#[derive(Debug)]
pub struct Directory {
    byte_order: ByteOrder,
    is_big: bool,
    entries: Vec<Entry>,
}

#[derive(Debug)]
struct Entry {
    tag: u16,
    kind: u16,
    count: u64,
    /// The value itself where it fits, else its place in the file.
    field: [u8; 8],
}

impl Directory {
    /// Reads the header of the file, and the directory that it points to.
    pub fn read(source: &Source) -> Result<Self, DecodeError> {
        let (byte_order, is_big) = signature(source)?;
        let mut directory = Self { byte_order, is_big, entries: Vec::new() };
        let header = source.bytes("TIFF header", 0, if is_big { 16 } else { 8 })?;
        let place = if is_big {
            // Bytes 4 to 7 say how long an offset is (8), and are 0.
            let (size, zero) = (directory.whole(&header[4..6]), directory.whole(&header[6..8]));
            if (size, zero) != (8, 0) {
                return Err(DecodeError::wrong(
                    "BigTIFF header",
                    format!("offsets of {size} bytes, then {zero}"),
                    "offsets of 8 bytes, then 0",
                ));
            }
            directory.whole(&header[8..])
        } else {
            directory.whole(&header[4..])
        };
        directory.read_entries(source, place)?;
        Ok(directory)
    }

    /// Of every number in the file.
    pub fn byte_order(&self) -> ByteOrder {
        self.byte_order
    }

    /// Whether places have 64 bits.
    pub fn is_big(&self) -> bool {
        self.is_big
    }

    /// Whether the file has the tag.
    pub fn has(&self, tag: u16) -> bool {
        self.entry(tag).is_some()
    }

    /// The first value of a tag that is a whole number.
    pub fn number(&self, source: &Source, tag: u16) -> Result<Option<u64>, DecodeError> {
        match self.whole_numbers(source, tag, 1)? {
            Some(numbers) if numbers.is_empty() => {
                Err(DecodeError::wrong(name(tag), "no value", "a whole number"))
            }
            numbers => Ok(numbers.map(|numbers| numbers[0])),
        }
    }

    /// The first `most` whole numbers of a tag, or as many as it has.
    pub fn whole_numbers(
        &self,
        source: &Source,
        tag: u16,
        most: u64,
    ) -> Result<Option<Vec<u64>>, DecodeError> {
        let Some(entry) = self.entry(tag) else { return Ok(None) };
        let size = match entry.kind {
            1 => 1,
            3 => 2,
            4 | 13 => 4,
            16 | 18 => 8,
            kind => {
                return Err(DecodeError::wrong(
                    name(tag),
                    format!("values of type {kind}"),
                    "unsigned whole numbers",
                ));
            }
        };
        let bytes = self.value(source, entry, size, entry.count.min(most))?;
        Ok(Some(bytes.chunks_exact(size as usize).map(|bytes| self.whole(bytes)).collect()))
    }

    /// All numbers of a tag as doubles.
    pub fn numbers(&self, source: &Source, tag: u16) -> Result<Option<Vec<f64>>, DecodeError> {
        let Some(entry) = self.entry(tag) else { return Ok(None) };
        if entry.count > MOST_NUMBERS {
            return Err(DecodeError::wrong(
                name(tag),
                format!("{} values", entry.count),
                format!("at most {MOST_NUMBERS}"),
            ));
        }
        let size: u64 = match entry.kind {
            1 | 6 | 7 => 1,
            3 | 8 => 2,
            4 | 9 | 11 | 13 => 4,
            5 | 10 | 12 | 16 | 17 | 18 => 8,
            kind => {
                return Err(DecodeError::wrong(
                    name(tag),
                    format!("values of type {kind}"),
                    "numbers",
                ));
            }
        };
        let bytes = self.value(source, entry, size, entry.count)?;
        let values = bytes.chunks_exact(size as usize);
        Ok(Some(values.map(|bytes| self.double(entry.kind, bytes)).collect()))
    }

    /// The text of a tag.
    pub fn text(&self, source: &Source, tag: u16) -> Result<Option<String>, DecodeError> {
        let Some(entry) = self.entry(tag) else { return Ok(None) };
        if !matches!(entry.kind, 1 | 2 | 7) || entry.count > MOST_TEXT {
            return Err(DecodeError::wrong(
                name(tag),
                format!("{} values of type {}", entry.count, entry.kind),
                format!("a text of at most {MOST_TEXT} bytes"),
            ));
        }
        let mut bytes = self.value(source, entry, 1, entry.count)?;
        bytes.truncate(bytes.iter().rposition(|&byte| byte != 0).map_or(0, |last| last + 1));
        Ok(Some(String::from_utf8(bytes).unwrap_or_else(|error| {
            error.into_bytes().iter().map(|&byte| char::from(byte)).collect()
        })))
    }

    fn entry(&self, tag: u16) -> Option<&Entry> {
        self.entries.iter().find(|entry| entry.tag == tag)
    }

    /// The bytes of a tag's first `count` values, from the entry itself or from where it points to.
    fn value(
        &self,
        source: &Source,
        entry: &Entry,
        size: u64,
        count: u64,
    ) -> Result<Vec<u8>, DecodeError> {
        let field = name(entry.tag);
        let room = if self.is_big { 8 } else { 4 };
        let too_long = || {
            DecodeError::wrong(&field, format!("{} values", entry.count), "what a file can hold")
        };
        let whole_length = size.checked_mul(entry.count).ok_or_else(too_long)?;
        let length = size * count;
        if whole_length <= room {
            return Ok(entry.field[..length as usize].to_vec());
        }
        source.bytes(&field, self.whole(&entry.field[..room as usize]), length)
    }

    fn read_entries(&mut self, source: &Source, place: u64) -> Result<(), DecodeError> {
        let (count_size, entry_size) = if self.is_big { (8, 20) } else { (2, 12) };
        let count = self.whole(&source.bytes("TIFF directory", place, count_size)?);
        if count == 0 || count > MOST_ENTRIES {
            return Err(DecodeError::wrong(
                "TIFF directory",
                format!("{count} entries"),
                format!("from 1 to {MOST_ENTRIES}"),
            ));
        }
        let bytes = source.bytes("TIFF directory", place + count_size, count * entry_size)?;
        let entries = bytes.chunks_exact(entry_size as usize).map(|bytes| {
            let (count, value) = bytes[4..].split_at(if self.is_big { 8 } else { 4 });
            let mut field = [0; 8];
            field[..value.len()].copy_from_slice(value);
            Entry {
                tag: self.whole(&bytes[..2]) as u16,
                kind: self.whole(&bytes[2..4]) as u16,
                count: self.whole(count),
                field,
            }
        });
        self.entries = entries.collect();
        Ok(())
    }

    /// A whole number of 1 to 8 bytes in the order of the file.
    fn whole(&self, bytes: &[u8]) -> u64 {
        let add = |number: u64, &byte: &u8| number << 8 | u64::from(byte);
        match self.byte_order {
            ByteOrder::Big => bytes.iter().fold(0, add),
            ByteOrder::Little => bytes.iter().rev().fold(0, add),
        }
    }

    fn double(&self, kind: u16, bytes: &[u8]) -> f64 {
        let whole = self.whole(bytes);
        match kind {
            5 => self.whole(&bytes[..4]) as f64 / self.whole(&bytes[4..]) as f64,
            6 => f64::from(whole as i8),
            8 => f64::from(whole as i16),
            9 => f64::from(whole as i32),
            10 => {
                let part = |bytes| f64::from(self.whole(bytes) as i32);
                part(&bytes[..4]) / part(&bytes[4..])
            }
            11 => f64::from(f32::from_bits(whole as u32)),
            12 => f64::from_bits(whole),
            17 => whole as i64 as f64,
            _ => whole as f64,
        }
    }
}

/// Looks at the first bytes: "II" or "MM", and 42, or 43 for a BigTIFF.
fn signature(source: &Source) -> Result<(ByteOrder, bool), DecodeError> {
    let found = source.bytes("TIFF header", 0, source.length().min(4))?;
    match found.as_slice() {
        b"II\x2a\0" => Ok((ByteOrder::Little, false)),
        b"MM\0\x2a" => Ok((ByteOrder::Big, false)),
        b"II\x2b\0" => Ok((ByteOrder::Little, true)),
        b"MM\0\x2b" => Ok((ByteOrder::Big, true)),
        [] => Err(DecodeError::wrong("TIFF header", "an empty file", SIGNATURES)),
        other => Err(DecodeError::wrong(
            "TIFF header",
            format!("\"{}\"", other.escape_ascii()),
            SIGNATURES,
        )),
    }
}

const SIGNATURES: &str = "\"II*\" or \"MM\" and what follows it in a TIFF file";

/// What the format calls a tag.
pub fn name(tag: u16) -> String {
    let known = match tag {
        256 => "ImageWidth",
        257 => "ImageLength",
        258 => "BitsPerSample",
        259 => "Compression",
        262 => "PhotometricInterpretation",
        266 => "FillOrder",
        273 => "StripOffsets",
        277 => "SamplesPerPixel",
        278 => "RowsPerStrip",
        279 => "StripByteCounts",
        284 => "PlanarConfiguration",
        317 => "Predictor",
        322 => "TileWidth",
        323 => "TileLength",
        324 => "TileOffsets",
        325 => "TileByteCounts",
        339 => "SampleFormat",
        33550 => "ModelPixelScale",
        33922 => "ModelTiepoint",
        34264 => "ModelTransformation",
        34735 => "GeoKeyDirectory",
        34736 => "GeoDoubleParams",
        34737 => "GeoAsciiParams",
        42112 => "GDAL_METADATA",
        42113 => "GDAL_NODATA",
        _ => return format!("tag {tag}"),
    };
    known.to_owned()
}
