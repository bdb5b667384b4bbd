//! Reading a take's file, whole or not.

use std::fmt;
use std::fs::File;
use std::io::{self, BufReader, Read};
use std::path::{Path, PathBuf};

use crate::block::{Found, Standing};
use crate::lock;
use crate::{Header, Spool, Take, Ticks};

/// Why a file is not read as a take.
#[derive(Debug, thiserror::Error)]
#[error("{}: {reason}", .path.display())]
pub struct ReadError {
    /// The file.
    pub path: PathBuf,
    /// What is wrong.
    #[source]
    pub reason: Reason,
}

/// What is wrong with a file.
#[derive(Debug, thiserror::Error)]
pub enum Reason {
    /// It begins otherwise.
    #[error("this is no take: expected a file that begins as takes do (.touch)")]
    NotATake,
    /// Another version of the format.
    #[error(
        "this take is of version {0} of the format, expected 1: open it with the release of Haptic \
         Terrain that recorded it, or a newer one"
    )]
    Version(u32),
    /// Nothing was recorded by then.
    #[error("this take was cut within its header: there is nothing in it to recover")]
    CutInHeader,
    /// Checksum, or numbers that cannot be.
    #[error("the header of this take is damaged: {0} is wrong")]
    Header(&'static str),
    /// Another program, or this one, still writes it.
    #[error("this take is being recorded, or recovered, by a program that runs: close it first")]
    InUse,
    /// The system.
    #[error("{0}")]
    System(#[from] io::Error),
}

/// What was not read of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Loss {
    /// The file ends within a block, after so many bytes of it.
    Cut(u64),
    /// So many bytes at the end of the file begin with what is no block, or not the next one.
    Damaged(u64),
}

impl fmt::Display for Loss {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let ticks = |bytes: &u64| bytes.div_ceil(crate::TICK_BYTES as u64);
        match self {
            Loss::Cut(bytes) => write!(
                f,
                "the file was cut short: its last {bytes} bytes (up to {} ticks) are no whole block, \
                 and were left out",
                ticks(bytes)
            ),
            Loss::Damaged(bytes) => write!(
                f,
                "the file is damaged: its last {bytes} bytes (up to {} ticks) were left out",
                ticks(bytes)
            ),
        }
    }
}

/// A take from a file.
#[derive(Clone, Debug)]
pub struct Saved {
    /// All that is whole.
    pub take: Take,
    /// Whether recording came to its end: not where the program that recorded it ended before.
    pub finished: bool,
    /// What was not read; `None` where all was.
    pub lost: Option<Loss>,
}

/// Reads a take up to its last whole block.
pub fn read(path: &Path) -> Result<Saved, ReadError> {
    File::open(path)
        .map_err(Reason::from)
        .and_then(|file| read_from(&mut BufReader::new(file)))
        .map_err(|reason| ReadError { path: path.to_owned(), reason })
}

/// Reads a take that nobody writes any more, and keeps others from doing the same until the spool is
/// removed or dropped.
pub fn claim(path: &Path) -> Result<(Saved, Spool), ReadError> {
    let claimed = || {
        let file = lock::open(path)?;
        if !lock::lock(&file)? {
            return Err(Reason::InUse);
        }
        let saved = read_from(&mut BufReader::new(&file))?;
        Ok((saved, Spool::left_over(path.to_owned(), file)))
    };
    claimed().map_err(|reason| ReadError { path: path.to_owned(), reason })
}

/// Reads a take from anything.
pub(crate) fn read_from(source: &mut impl Read) -> Result<Saved, Reason> {
    let (header, _) = Header::read(source)?;
    let (mut ticks, mut standing) = (Ticks::default(), Standing::default());
    let mut finished = false;
    let lost = loop {
        let (found, bytes) = Found::read(source)?;
        let loss = match found {
            Found::Ticks(more, now) if !finished && follows(&ticks, more.len(), now) => {
                standing = now;
                for tick in more {
                    let pushed = ticks.push(tick);
                    pushed.map_err(|_| io::Error::from(io::ErrorKind::OutOfMemory))?;
                }
                continue;
            }
            Found::Closing(now) if !finished && follows(&ticks, 0, now) => {
                (standing, finished) = (now, true);
                continue;
            }
            Found::End => break None,
            Found::Cut => Loss::Cut,
            Found::Ticks(..) | Found::Closing(_) | Found::Damaged => Loss::Damaged,
        };
        break Some(loss(bytes + io::copy(source, &mut io::sink())?));
    };
    Ok(Saved { take: Take::of(header, ticks, standing.dropped), finished, lost })
}

/// Whether a block of so many ticks is the next one: none is missing before it.
fn follows(ticks: &Ticks, more: usize, standing: Standing) -> bool {
    standing.ticks == (ticks.len() + more) as u64
}
