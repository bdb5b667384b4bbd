//! The words of a text file of any length, one after the other.

use crate::error::DecodeError;
use crate::source::Source;

/// Bytes read at a time.
const PIECE: usize = 1 << 18;

/// Bytes of a word beyond which it is no number, however many zeros it has.
pub const LONGEST: usize = 512;

/// Hands out words; the file's own lines mean nothing to it.
pub struct Words<'source> {
    source: &'source Source,
    bytes: Vec<u8>,
    /// Place in the file of the first of `bytes`.
    first: u64,
    /// Place in `bytes` where the next word is looked for.
    next: usize,
}

impl<'source> Words<'source> {
    /// From this place in the file on.
    pub fn new(source: &'source Source, first: u64) -> Self {
        Self { source, bytes: Vec::new(), first, next: 0 }
    }

    /// Place in the file of what was not handed out yet.
    pub fn place(&self) -> u64 {
        self.first + self.next as u64
    }

    /// The next word, or `None` at the end. Of a word that no number is as long as, a beginning.
    #[inline]
    pub fn next(&mut self) -> Result<Option<&[u8]>, DecodeError> {
        // Enough for the blanks between two words and the second of them, nearly always.
        if self.bytes.len() - self.next < 2 * LONGEST {
            self.read_on()?;
        }
        while self.next < self.bytes.len() && self.bytes[self.next] <= b' ' {
            self.next += 1;
            if self.next == self.bytes.len() {
                self.read_on()?;
            }
        }
        if self.bytes.len() - self.next < LONGEST {
            self.read_on()?;
        }
        let rest = &self.bytes[self.next..];
        let rest = &rest[..rest.len().min(LONGEST)];
        let length = rest.iter().position(|byte| *byte <= b' ').unwrap_or(rest.len());
        if length == 0 {
            return Ok(None);
        }
        let start = self.next;
        self.next += length;
        Ok(Some(&self.bytes[start..self.next]))
    }

    /// Puts what is left in front of as much as one piece more.
    fn read_on(&mut self) -> Result<(), DecodeError> {
        let left = self.bytes.len() - self.next;
        let unread = self.first + self.bytes.len() as u64;
        let more = self.source.length().saturating_sub(unread).min(PIECE as u64) as usize;
        if more == 0 {
            return Ok(());
        }
        self.bytes.copy_within(self.next.., 0);
        self.first += self.next as u64;
        self.next = 0;
        self.bytes.resize(left + more, 0);
        self.source.fill(&mut self.bytes[left..], unread)?;
        Ok(())
    }
}
