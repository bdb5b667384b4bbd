//! One face for every compression: bytes in, bytes out, as far as both reach.

use super::compression::Compression;
use super::packbits::PackBits;
use flate2::{Decompress, FlushDecompress};
use weezl::BitOrder;
use weezl::decode::{Configuration, Decoder};

/// Undoes one compression; made once, and begun anew for each chunk.
pub enum Codec {
    /// Copies.
    Plain,
    /// Lempel, Ziv and Welch's.
    Lzw(Box<Decoder>),
    /// A zlib stream.
    Inflate(Box<Decompress>),
    /// Runs of bytes.
    PackBits(PackBits),
}

/// How far one call came; nothing of both means that the data have ended.
#[derive(Debug)]
pub struct Step {
    /// Bytes of the input that are done with.
    pub consumed: usize,
    /// Bytes of the output that are written.
    pub produced: usize,
}

/// The data are no such data; the text says why.
#[derive(Debug)]
pub struct Damaged(pub String);

impl Codec {
    /// The decoder of a compression.
    pub fn of(compression: Compression) -> Self {
        match compression {
            Compression::None => Self::Plain,
            // Files of GDAL's end without an end code where the chunk is full: what follows is not read.
            Compression::Lzw => Self::Lzw(Box::new(
                Configuration::with_tiff_size_switch(BitOrder::Msb, 8)
                    .with_yield_on_full_buffer(true)
                    .build(),
            )),
            Compression::Deflate => Self::Inflate(Box::new(Decompress::new(true))),
            Compression::PackBits => Self::PackBits(PackBits::default()),
        }
    }

    /// Forgets the chunk before.
    pub fn begin(&mut self) {
        match self {
            Self::Plain => {}
            Self::Lzw(decoder) => decoder.reset(),
            Self::Inflate(decoder) => decoder.reset(true),
            Self::PackBits(decoder) => *decoder = PackBits::default(),
        }
    }

    /// Undoes as much as there is input and room for.
    pub fn step(&mut self, input: &[u8], output: &mut [u8]) -> Result<Step, Damaged> {
        match self {
            Self::Plain => {
                let count = input.len().min(output.len());
                output[..count].copy_from_slice(&input[..count]);
                Ok(Step { consumed: count, produced: count })
            }
            Self::Lzw(decoder) => {
                let result = decoder.decode_bytes(input, output);
                // What was decoded before a code that cannot be may be all that the chunk needs.
                match result.status {
                    Err(error) if result.consumed_out == 0 => Err(Damaged(error.to_string())),
                    _ => Ok(Step { consumed: result.consumed_in, produced: result.consumed_out }),
                }
            }
            Self::Inflate(decoder) => {
                let (before_in, before_out) = (decoder.total_in(), decoder.total_out());
                decoder
                    .decompress(input, output, FlushDecompress::None)
                    .map_err(|error| Damaged(error.to_string()))?;
                Ok(Step {
                    consumed: (decoder.total_in() - before_in) as usize,
                    produced: (decoder.total_out() - before_out) as usize,
                })
            }
            Self::PackBits(decoder) => Ok(decoder.step(input, output)),
        }
    }

    /// Whether data carry a sum of their own, which shows damage once the chunk is full.
    pub fn has_checksum(&self) -> bool {
        matches!(self, Self::Inflate(_))
    }
}
