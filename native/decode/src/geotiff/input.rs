//! The bytes of one chunk, undone as they are asked for: no chunk is ever in memory as a whole.

use super::codec::{Codec, Damaged};
use crate::error::DecodeError;
use crate::source::Source;
use std::io;

/// Packed bytes read at once.
const PIECE: usize = 256 << 10;

/// Reads chunks one after the other.
pub struct Input<'a> {
    source: &'a Source,
    codec: Codec,
    piece: Vec<u8>,
    used: usize,
    next: u64,
    end: u64,
}

/// Why bytes did not come.
#[derive(Debug)]
pub enum Trouble {
    /// The chunk's data ended so many bytes too early.
    Ended(usize),
    /// The chunk's data are damaged.
    Damaged(String),
    /// The file cannot be read any more.
    File(io::Error),
}

impl From<Damaged> for Trouble {
    fn from(Damaged(why): Damaged) -> Self {
        Self::Damaged(why)
    }
}

impl Trouble {
    /// The error for a chunk.
    pub fn into_error(self, chunk: String, compression: &str) -> DecodeError {
        match self {
            Self::Ended(missing) => DecodeError::wrong(
                chunk,
                format!("data that end {missing} bytes too early ({compression})"),
                "all samples of its size",
            ),
            Self::Damaged(why) => DecodeError::wrong(
                chunk,
                format!("damaged data ({why})"),
                format!("{compression} data"),
            ),
            Self::File(error) => error.into(),
        }
    }
}

impl<'a> Input<'a> {
    /// Reads from `source` with a codec.
    pub fn new(source: &'a Source, codec: Codec) -> Self {
        Self { source, codec, piece: Vec::new(), used: 0, next: 0, end: 0 }
    }

    /// Goes to the chunk whose packed bytes lie there.
    pub fn begin(&mut self, offset: u64, length: u64) {
        self.codec.begin();
        self.piece.clear();
        self.used = 0;
        self.next = offset;
        self.end = offset + length;
    }

    /// Fills all of `output` with the chunk's next bytes.
    pub fn fill(&mut self, output: &mut [u8]) -> Result<(), Trouble> {
        let mut done = 0;
        while done < output.len() {
            let came = self.step(&mut output[done..])?;
            if came.is_none() {
                return Err(Trouble::Ended(output.len() - done));
            }
            done += came.unwrap_or(0);
        }
        Ok(())
    }

    /// Steps over bytes of the chunk, with `spare` for what must be undone on the way.
    pub fn skip(&mut self, bytes: u64, spare: &mut [u8]) -> Result<(), Trouble> {
        if matches!(self.codec, Codec::Plain) {
            self.begin(self.next + bytes, self.end.saturating_sub(self.next + bytes));
            return Ok(());
        }
        let mut left = bytes;
        while left > 0 {
            let count = left.min(spare.len() as u64) as usize;
            self.fill(&mut spare[..count])?;
            left -= count as u64;
        }
        Ok(())
    }

    /// Looks at the sum behind the data, once all of them came. Data that go on, or end without a sum, pass.
    pub fn verify(&mut self) -> Result<(), Trouble> {
        if self.codec.has_checksum() {
            self.step(&mut [0])?;
        }
        Ok(())
    }

    /// Undoes some bytes; `None` where the data have ended.
    fn step(&mut self, output: &mut [u8]) -> Result<Option<usize>, Trouble> {
        if self.used == self.piece.len() {
            self.read_piece().map_err(Trouble::File)?;
        }
        let step = self.codec.step(&self.piece[self.used..], output)?;
        self.used += step.consumed;
        let stuck = step.consumed == 0 && step.produced == 0;
        Ok(if stuck { None } else { Some(step.produced) })
    }

    fn read_piece(&mut self) -> io::Result<()> {
        let length = (self.end - self.next).min(PIECE as u64) as usize;
        self.piece.resize(length, 0);
        self.used = 0;
        self.source.fill(&mut self.piece, self.next)?;
        self.next += length as u64;
        Ok(())
    }
}
