//! What the baseline tags say of the raster: its size, and how its samples were written.

use super::compression::Compression;
use super::directory::{Directory, name};
use super::predictor::Predictor;
use super::sample::StoredSample;
use crate::error::DecodeError;
use crate::source::Source;

/// The raster, without the places of its samples.
#[derive(Debug)]
pub struct Picture {
    /// At least 1.
    pub rows: u32,
    /// At least 1.
    pub columns: u32,
    /// Values for each place, at least 1.
    pub bands: u16,
    /// Whether each band lies by itself.
    pub is_planar: bool,
    /// The number format of every band.
    pub stored: StoredSample,
    /// How chunks were packed.
    pub compression: Compression,
    /// What was done to samples before; of no meaning where nothing is compressed (as in libtiff).
    pub predictor: Predictor,
    /// What the values mean as colours.
    pub photometric: Option<u16>,
}

impl Picture {
    /// Reads and checks the tags.
    pub fn read(source: &Source, directory: &Directory) -> Result<Self, DecodeError> {
        let tags = Tags { source, directory };
        let columns = tags.size(256)?;
        let rows = tags.size(257)?;
        let bands = tags.of_16_bits(277, 1)?;
        if bands == 0 {
            return Err(DecodeError::wrong(name(277), 0, "at least 1"));
        }
        let compression = Compression::of(tags.number(259, 1)?)?;
        let fill_order = tags.number(266, 1)?;
        if fill_order != 1 {
            return Err(DecodeError::wrong(name(266), fill_order, "1 (highest bit first)"));
        }
        let is_planar = match tags.number(284, 1)? {
            1 => false,
            2 => bands > 1,
            other => return Err(DecodeError::wrong(name(284), other, "1 (chunky) or 2 (planar)")),
        };
        let stored =
            StoredSample::of(tags.of_all_bands(339, bands, 1)?, tags.of_all_bands(258, bands, 1)?)?;
        let predictor = match compression {
            Compression::Lzw | Compression::Deflate => Predictor::of(tags.number(317, 1)?, stored)?,
            Compression::None | Compression::PackBits => Predictor::None,
        };
        let photometric = tags.number(262, 0)?;
        let photometric = directory.has(262).then_some(photometric.min(u64::from(u16::MAX)) as u16);
        Ok(Self { rows, columns, bands, is_planar, stored, compression, predictor, photometric })
    }

    /// Values for each place that lie side by side in a chunk.
    pub fn bands_in_chunk(&self) -> u64 {
        if self.is_planar { 1 } else { u64::from(self.bands) }
    }

    /// Bytes from one sample of the band to the next in a chunk's row.
    pub fn sample_step(&self) -> u64 {
        self.bands_in_chunk() * self.stored.bytes() as u64
    }
}

struct Tags<'a> {
    source: &'a Source,
    directory: &'a Directory,
}

impl Tags<'_> {
    fn number(&self, tag: u16, default: u64) -> Result<u64, DecodeError> {
        Ok(self.directory.number(self.source, tag)?.unwrap_or(default))
    }

    fn size(&self, tag: u16) -> Result<u32, DecodeError> {
        let found = self.directory.number(self.source, tag)?;
        let size = found.and_then(|size| u32::try_from(size).ok()).filter(|&size| size > 0);
        size.ok_or_else(|| {
            let found = found.map_or_else(|| "nothing".to_owned(), |size| size.to_string());
            DecodeError::wrong(name(tag), found, format!("from 1 to {}", u32::MAX))
        })
    }

    fn of_16_bits(&self, tag: u16, default: u64) -> Result<u16, DecodeError> {
        let found = self.number(tag, default)?;
        u16::try_from(found)
            .map_err(|_| DecodeError::wrong(name(tag), found, format!("at most {}", u16::MAX)))
    }

    /// A value that the format has for each band, and that must be the same for all.
    fn of_all_bands(&self, tag: u16, bands: u16, default: u64) -> Result<u64, DecodeError> {
        let values = self.directory.whole_numbers(self.source, tag, u64::from(bands))?;
        let values = values.unwrap_or_else(|| vec![default]);
        match values.as_slice() {
            [] => Err(DecodeError::wrong(name(tag), "no value", "a whole number")),
            [first, others @ ..] if others.iter().all(|other| other == first) => Ok(*first),
            _ => {
                let shown: Vec<_> = values.iter().take(8).map(u64::to_string).collect();
                Err(DecodeError::wrong(name(tag), shown.join(", "), "the same for every band"))
            }
        }
    }
}
