//! Ticks with a checksum: what a file has, or has not, as a whole.

use std::io::{self, Read};

use crate::header::{fill, u32_at, u64_at};
use crate::tick;
use crate::{TICK_BYTES, Tick};

/// Ticks in a block, at most: eight seconds. A reader needs no more memory than that for a block.
pub const MOST_IN_BLOCK: usize = 8192;

const TICKS: [u8; 4] = *b"TICK";
const CLOSING: [u8; 4] = *b"DONE";

/// Before the ticks.
const FIXED: usize = 24;

/// Where a file stands at the end of a block.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Standing {
    /// Ticks in the file so far.
    pub(crate) ticks: u64,
    /// Ticks lost to the take so far.
    pub(crate) dropped: u64,
}

/// The bytes of a block of at most [`MOST_IN_BLOCK`] ticks.
pub(crate) fn of_ticks(ticks: &[Tick], standing: Standing) -> Vec<u8> {
    debug_assert!(ticks.len() <= MOST_IN_BLOCK);
    block(TICKS, ticks, standing)
}

/// The bytes of the closing block.
pub(crate) fn closing(standing: Standing) -> Vec<u8> {
    block(CLOSING, &[], standing)
}

fn block(kind: [u8; 4], ticks: &[Tick], standing: Standing) -> Vec<u8> {
    let mut bytes = Vec::with_capacity(FIXED + ticks.len() * TICK_BYTES + 4);
    bytes.extend(kind);
    bytes.extend((ticks.len() as u32).to_le_bytes());
    bytes.extend(standing.ticks.to_le_bytes());
    bytes.extend(standing.dropped.to_le_bytes());
    for tick in ticks {
        tick.write(&mut bytes);
    }
    bytes.extend(crc32fast::hash(&bytes).to_le_bytes());
    bytes
}

/// What comes next in a file.
pub(crate) enum Found {
    Ticks(Vec<Tick>, Standing),
    Closing(Standing),
    /// The file ends where a block does.
    End,
    /// It ends within a block.
    Cut,
    /// What is there is no block.
    Damaged,
}

impl Found {
    /// Reads a block; says how many bytes it has.
    pub(crate) fn read(source: &mut impl Read) -> io::Result<(Found, u64)> {
        let mut bytes = vec![0; FIXED];
        let found = fill(source, &mut bytes)?;
        if found == 0 {
            return Ok((Found::End, 0));
        }
        let begun = found.min(4);
        if ![TICKS, CLOSING].iter().any(|kind| kind[..begun] == bytes[..begun]) {
            return Ok((Found::Damaged, found as u64));
        }
        if found < FIXED {
            return Ok((Found::Cut, found as u64));
        }
        let (closes, count) = (bytes[..4] == CLOSING, u32_at(&bytes, 4) as usize);
        if count > MOST_IN_BLOCK || closes != (count == 0) {
            return Ok((Found::Damaged, found as u64));
        }
        let length = FIXED + count * TICK_BYTES;
        bytes.resize(length + 4, 0);
        let found = FIXED + fill(source, &mut bytes[FIXED..])?;
        if found < bytes.len() {
            return Ok((Found::Cut, found as u64));
        }
        let (told, checksum) = bytes.split_at(length);
        if crc32fast::hash(told).to_le_bytes() != *checksum {
            return Ok((Found::Damaged, found as u64));
        }
        let standing = Standing { ticks: u64_at(told, 8), dropped: u64_at(told, 16) };
        if closes {
            return Ok((Found::Closing(standing), found as u64));
        }
        let (ticks, _) = told[FIXED..].as_chunks::<{ tick::BYTES }>();
        let ticks: Option<Vec<Tick>> = ticks.iter().map(Tick::read).collect();
        let block = ticks.map_or(Found::Damaged, |ticks| Found::Ticks(ticks, standing));
        Ok((block, found as u64))
    }
}
