//! Writing a take's file at once.

use std::ffi::OsString;
use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::Path;

use crate::block::{self, Standing};
use crate::{LONGEST_ABOUT, MOST_IN_BLOCK, Take};

/// Why a take is not written.
#[derive(Debug, thiserror::Error)]
pub enum WriteError {
    /// The text about it is too long.
    #[error("the text about the take has {0} bytes, expected at most {LONGEST_ABOUT}")]
    About(usize),
    /// The system.
    #[error(transparent)]
    System(#[from] io::Error),
}

/// Writes a take to `path`, over what was there, once all of it is on the disk: a failure leaves what
/// was there.
pub fn write(path: &Path, take: &Take) -> Result<(), WriteError> {
    let about = take.header.about.len();
    let header = take.header.bytes().ok_or(WriteError::About(about))?;
    let mut part = OsString::from(path);
    part.push(format!(".{}.part", std::process::id()));
    let part = Path::new(&part);
    let written = write_new(part, &header, take).and_then(|()| fs::rename(part, path));
    if written.is_err() {
        // What went wrong first is what is told.
        let _ = fs::remove_file(part);
    }
    Ok(written?)
}

fn write_new(path: &Path, header: &[u8], take: &Take) -> io::Result<()> {
    let mut file = BufWriter::new(File::create(path)?);
    file.write_all(header)?;
    let mut ticks = 0;
    while ticks < take.ticks.len() {
        let more = take.ticks.part(ticks, MOST_IN_BLOCK);
        ticks += more.len();
        let standing = Standing { ticks: ticks as u64, dropped: take.dropped };
        file.write_all(&block::of_ticks(&more, standing))?;
    }
    let standing = Standing { ticks: ticks as u64, dropped: take.dropped };
    file.write_all(&block::closing(standing))?;
    file.into_inner()?.sync_all()
}
