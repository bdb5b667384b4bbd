//! A take on its way to the disk.

use std::fs::{self, File};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use crate::block::{self, Standing};
use crate::lock;
use crate::{Header, MOST_IN_BLOCK, Tick, WriteError};

/// The longest time in which what was written may be in the system's memory only, from where a failure
/// of power takes it; a program that ends takes nothing from there.
const SYNC: Duration = Duration::from_millis(500);

/// A take's file in the making, or left over, which no other program touches meanwhile.
///
/// Nothing is buffered here: what [`write`](Self::write) has written survives the program.
#[derive(Debug)]
pub struct Spool {
    path: PathBuf,
    file: File,
    /// A fork leaves the file to its parent.
    process: u32,
    ticks: u64,
    synced: Instant,
    is_synced: bool,
}

impl Spool {
    /// Makes a new file for a take that begins.
    pub fn create(path: &Path, header: &Header) -> Result<Spool, WriteError> {
        let bytes = header.bytes().ok_or(WriteError::About(header.about.len()))?;
        let file = lock::create(path)?;
        let spool = Spool::left_over(path.to_owned(), file);
        let begun = lock::lock(&spool.file).and_then(|_| (&spool.file).write_all(&bytes));
        match begun {
            Ok(()) => Ok(spool),
            Err(error) => {
                // What went wrong first is what is told.
                let _ = spool.remove();
                Err(error.into())
            }
        }
    }

    /// A file that was locked.
    pub(crate) fn left_over(path: PathBuf, file: File) -> Spool {
        let process = std::process::id();
        Spool { path, file, process, ticks: 0, synced: Instant::now(), is_synced: false }
    }

    /// Where it is.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// How many ticks were written.
    pub fn ticks(&self) -> u64 {
        self.ticks
    }

    /// Appends ticks; `dropped` were lost to the take so far.
    ///
    /// After an error the file may end within a block, and nothing more may be written.
    pub fn write(&mut self, ticks: &[Tick], dropped: u64) -> io::Result<()> {
        self.refuse_in_fork()?;
        for some in ticks.chunks(MOST_IN_BLOCK) {
            let standing = Standing { ticks: self.ticks + some.len() as u64, dropped };
            self.file.write_all(&block::of_ticks(some, standing))?;
            self.ticks = standing.ticks;
            self.is_synced = false;
        }
        Ok(())
    }

    /// Has the disk keep what was written, if that has not been done for half a second.
    pub fn sync_in_time(&mut self) -> io::Result<()> {
        if !self.is_synced && self.synced.elapsed() >= SYNC {
            self.file.sync_data()?;
            self.is_synced = true;
            self.synced = Instant::now();
        }
        Ok(())
    }

    /// Marks the file as whole, and has the disk keep it.
    pub fn finish(&mut self, dropped: u64) -> io::Result<()> {
        self.refuse_in_fork()?;
        self.file.write_all(&block::closing(Standing { ticks: self.ticks, dropped }))?;
        self.file.sync_all()
    }

    /// Removes the file.
    pub fn remove(self) -> io::Result<()> {
        self.refuse_in_fork()?;
        let Spool { path, file, .. } = self;
        // Not every system removes a file that is open.
        drop(file);
        fs::remove_file(path)
    }

    fn refuse_in_fork(&self) -> io::Result<()> {
        if self.process == std::process::id() {
            return Ok(());
        }
        Err(io::Error::other("the process forked: the take's file stays with its parent"))
    }
}
