//! Whether the samples can be touched where they lie.

use super::chunks::Chunks;
use super::compression::Compression;
use super::picture::Picture;
use surface::{ByteOrder, SampleType};

/// Rows of raw samples at a fixed distance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InPlace {
    /// Bytes before the first sample.
    pub offset: u64,
    /// Bytes from one row to the next.
    pub row_stride: u64,
    /// The number format.
    pub sample: SampleType,
    /// Of one sample.
    pub byte_order: ByteOrder,
}

impl InPlace {
    /// Where the first band lies: not packed, by itself, and every chunk right behind the one before.
    pub fn of(picture: &Picture, chunks: &Chunks, byte_order: ByteOrder) -> Option<Self> {
        let is_plain = picture.compression == Compression::None
            && picture.bands_in_chunk() == 1
            && picture.stored.is_read_in_place()
            && chunks.across() == 1;
        let places = chunks.places();
        let mut pairs = places.windows(2);
        let is_in_one_piece = places.iter().all(|place| !place.is_absent())
            && pairs.all(|pair| pair[0].offset + pair[0].length == pair[1].offset);
        (is_plain && is_in_one_piece).then(|| Self {
            offset: places[0].offset,
            row_stride: chunks.row_bytes(),
            sample: picture.stored.decoded(),
            byte_order,
        })
    }
}
