//! What a take's file begins with.

use std::io::{self, Read};

use crate::read::Reason;
use crate::tick;

/// Bytes of the text about a take, at most.
pub const LONGEST_ABOUT: usize = 1 << 20;

/// A byte that no text has, the name, and a line end that a transfer as text would change.
const MAGIC: [u8; 8] = *b"\x89TOUCH\r\n";

const VERSION: u32 = 1;

/// Before the text.
const FIXED: usize = 52;

/// What was known when a take began.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Header {
    /// For whoever recorded it to say.
    pub about: String,
    /// Width, depth and height of the device's workspace, metres.
    pub workspace: [f64; 3],
    /// How many ticks, from the first one on, were felt before recording was asked for.
    pub pre_roll: u64,
}

impl Header {
    /// The bytes that a file begins with; `None` where the text is too long.
    pub(crate) fn bytes(&self) -> Option<Vec<u8>> {
        if self.about.len() > LONGEST_ABOUT {
            return None;
        }
        let mut bytes = MAGIC.to_vec();
        bytes.extend(VERSION.to_le_bytes());
        bytes.extend((tick::BYTES as u32).to_le_bytes());
        bytes.extend(self.workspace.iter().flat_map(|metres| metres.to_le_bytes()));
        bytes.extend(self.pre_roll.to_le_bytes());
        bytes.extend((self.about.len() as u32).to_le_bytes());
        bytes.extend(self.about.as_bytes());
        bytes.extend(crc32fast::hash(&bytes).to_le_bytes());
        Some(bytes)
    }

    /// Reads it, and says how many bytes it has.
    pub(crate) fn read(source: &mut impl Read) -> Result<(Header, u64), Reason> {
        let mut bytes = vec![0; FIXED];
        let found = fill(source, &mut bytes)?;
        let begun = found.min(MAGIC.len());
        if found == 0 || bytes[..begun] != MAGIC[..begun] {
            return Err(Reason::NotATake);
        }
        if found < 12 {
            return Err(Reason::CutInHeader);
        }
        let version = u32_at(&bytes, 8);
        if version != VERSION {
            return Err(Reason::Version(version));
        }
        if found < FIXED {
            return Err(Reason::CutInHeader);
        }
        let (tick_bytes, about_bytes) = (u32_at(&bytes, 12), u32_at(&bytes, 48) as usize);
        if tick_bytes as usize != tick::BYTES {
            return Err(Reason::Header("the size of a tick"));
        }
        if about_bytes > LONGEST_ABOUT {
            return Err(Reason::Header("the length of its text"));
        }
        bytes.resize(FIXED + about_bytes + 4, 0);
        if fill(source, &mut bytes[FIXED..])? < about_bytes + 4 {
            return Err(Reason::CutInHeader);
        }
        let (told, checksum) = bytes.split_at(FIXED + about_bytes);
        if crc32fast::hash(told).to_le_bytes() != *checksum {
            return Err(Reason::Header("its checksum"));
        }
        let header = Header {
            about: String::from_utf8(told[FIXED..].to_vec())
                .map_err(|_| Reason::Header("its text"))?,
            workspace: std::array::from_fn(|axis| f64::from_bits(u64_at(told, 16 + 8 * axis))),
            pre_roll: u64_at(told, 40),
        };
        Ok((header, bytes.len() as u64))
    }
}

/// Reads until the bytes are full or the source ends; says how many there are.
pub(crate) fn fill(source: &mut impl Read, bytes: &mut [u8]) -> io::Result<usize> {
    let mut found = 0;
    while found < bytes.len() {
        match source.read(&mut bytes[found..]) {
            Ok(0) => break,
            Ok(more) => found += more,
            Err(error) if error.kind() == io::ErrorKind::Interrupted => {}
            Err(error) => return Err(error),
        }
    }
    Ok(found)
}

pub(crate) fn u32_at(bytes: &[u8], place: usize) -> u32 {
    u32::from_le_bytes(bytes[place..place + 4].try_into().expect("four bytes are four"))
}

pub(crate) fn u64_at(bytes: &[u8], place: usize) -> u64 {
    u64::from_le_bytes(bytes[place..place + 8].try_into().expect("eight bytes are eight"))
}
