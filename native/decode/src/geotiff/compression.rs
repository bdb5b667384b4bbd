//! How samples were packed, by the numbers of the Compression tag.

use crate::error::DecodeError;

/// A compression that can be undone here.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Compression {
    /// The samples lie as they are.
    None,
    /// Lempel, Ziv and Welch's, as TIFF 6.0 has it (section 13).
    Lzw,
    /// A zlib stream.
    Deflate,
    /// Runs of bytes (TIFF 6.0, section 9).
    PackBits,
}

impl Compression {
    /// The compression of a number in the file.
    pub fn of(code: u64) -> Result<Self, DecodeError> {
        match code {
            1 => Ok(Self::None),
            5 => Ok(Self::Lzw),
            // The second is what was written before the first was agreed on.
            8 | 32946 => Ok(Self::Deflate),
            32773 => Ok(Self::PackBits),
            _ => Err(DecodeError::wrong(
                "Compression",
                other(code).map_or_else(|| code.to_string(), |name| format!("{name} ({code})")),
                "none, LZW, deflate or PackBits",
            )),
        }
    }

    /// As people know it.
    pub fn name(self) -> &'static str {
        match self {
            Self::None => "none",
            Self::Lzw => "LZW",
            Self::Deflate => "deflate",
            Self::PackBits => "PackBits",
        }
    }

    /// How many bytes a packed one can become at the most: what claims more than that is no honest file.
    ///
    /// Deflate: 258 bytes from 2 bits. LZW: between two clear codes the table grows to 4096 strings,
    /// the longest of 3839 bytes, at 12 bits each. PackBits: 128 bytes from 2.
    pub fn most_growth(self) -> u64 {
        match self {
            Self::None => 1,
            Self::Lzw => 2560,
            Self::Deflate => 1032,
            Self::PackBits => 64,
        }
    }
}

/// Names of what is not undone here, for those who must convert their file.
fn other(code: u64) -> Option<&'static str> {
    Some(match code {
        2..=4 => "CCITT fax",
        6 | 7 => "JPEG",
        34661 => "JBIG",
        34712 | 33003 | 33004 | 33005 => "JPEG 2000",
        34887 => "LERC",
        34925 => "LZMA",
        50000 => "ZSTD",
        50001 => "WebP",
        50002 | 52546 => "JPEG XL",
        _ => return None,
    })
}
