//! A piece of a file in memory that moves along with the reader.

use crate::error::DecodeError;
use crate::source::Source;

/// Bytes read at a time: few calls of the system, and no more than the processor keeps near.
const WINDOW: usize = 1 << 18;

/// Reads a file from place to place; forward it costs one call of the system a quarter of a mebibyte.
pub struct Window<'source> {
    source: &'source Source,
    first: u64,
    bytes: Vec<u8>,
}

impl<'source> Window<'source> {
    /// Nothing read yet.
    pub fn new(source: &'source Source) -> Self {
        Self { source, first: 0, bytes: Vec::new() }
    }

    /// Bytes of the whole file.
    pub fn length(&self) -> u64 {
        self.source.length()
    }

    /// The bytes from `offset` on, `length` of them; fewer where the file ends before.
    pub fn at(&mut self, offset: u64, length: usize) -> Result<&[u8], DecodeError> {
        let left = self.source.length().saturating_sub(offset);
        let length = left.min(length as u64) as usize;
        let is_held =
            offset >= self.first && offset + length as u64 <= self.first + self.bytes.len() as u64;
        if !is_held {
            let wanted = left.min(WINDOW.max(length) as u64) as usize;
            self.bytes.resize(wanted, 0);
            self.first = offset;
            self.source.fill(&mut self.bytes, offset)?;
        }
        let start = (offset - self.first) as usize;
        Ok(&self.bytes[start..][..length])
    }
}
