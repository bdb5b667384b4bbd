//! A take in the making, and a take that was made, as a session tells of them.

use std::path::PathBuf;

use takes::{Spool, Take};

/// How far a take has come.
#[derive(Clone, Debug, PartialEq)]
pub struct Recording {
    /// In memory.
    pub ticks: usize,
    /// From the first tick to the last.
    pub seconds: f64,
    /// Ticks that were lost to the take.
    pub dropped: u64,
    /// Where it is spooled to; `None` where it is in memory only.
    pub spool: Option<PathBuf>,
    /// How many ticks the spool has, which the end of this program does not take from it.
    pub spooled: usize,
    /// Why the spool gets no more, in the system's words; memory goes on.
    pub failure: Option<String>,
}

/// A take that has come to its end.
#[derive(Debug)]
pub struct Recorded {
    /// The take.
    pub take: Take,
    /// Its file; `None` where it is in memory only.
    pub spool: Option<Spool>,
    /// Why the file is not whole, in the system's words; `None` where it is.
    pub failure: Option<String>,
}
