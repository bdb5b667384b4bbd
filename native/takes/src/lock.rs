//! A file that belongs to one program as long as that program lives: the system itself lets it go,
//! however the program ends, so no number of a process has to be believed.

use std::fs::{File, OpenOptions};
use std::io;
use std::path::Path;

/// Opens a file that there is, to be locked.
pub(crate) fn open(path: &Path) -> io::Result<File> {
    options().open(path)
}

/// Makes a new file, to be locked.
pub(crate) fn create(path: &Path) -> io::Result<File> {
    options().create_new(true).open(path)
}

#[cfg(not(windows))]
fn options() -> OpenOptions {
    let mut options = OpenOptions::new();
    options.read(true).write(true);
    options
}

/// Whoever opens it to write has it alone; others may read.
#[cfg(windows)]
fn options() -> OpenOptions {
    use std::os::windows::fs::OpenOptionsExt;
    const FILE_SHARE_READ: u32 = 1;
    let mut options = OpenOptions::new();
    options.read(true).write(true).share_mode(FILE_SHARE_READ);
    options
}

/// Takes the lock, which is let go when the file is closed; false where somebody has it.
#[cfg(unix)]
pub(crate) fn lock(file: &File) -> io::Result<bool> {
    use std::os::fd::AsRawFd;
    // SAFETY: the descriptor is that of an open file; the call takes no memory.
    let result = unsafe { libc::flock(file.as_raw_fd(), libc::LOCK_EX | libc::LOCK_NB) };
    if result == 0 {
        return Ok(true);
    }
    let error = io::Error::last_os_error();
    if error.kind() == io::ErrorKind::WouldBlock { Ok(false) } else { Err(error) }
}

/// Opening it was taking it.
#[cfg(not(unix))]
pub(crate) fn lock(_file: &File) -> io::Result<bool> {
    Ok(true)
}
