//! A file that is read at places, by several threads at once, and never beyond its end.

use crate::error::DecodeError;
use std::fs::File;
use std::io;
use std::path::Path;

/// A file and its length.
#[derive(Debug)]
pub struct Source {
    file: File,
    length: u64,
}

impl Source {
    /// Opens a file.
    pub fn open(path: &Path) -> Result<Self, DecodeError> {
        let file = File::open(path)?;
        let metadata = file.metadata()?;
        if !metadata.is_file() {
            return Err(DecodeError::wrong("file", "a folder or a device", "a file"));
        }
        Ok(Self { file, length: metadata.len() })
    }

    /// Bytes in the file when it was opened.
    pub fn length(&self) -> u64 {
        self.length
    }

    /// Reads `length` bytes at `offset`; `field` names them where the file has no such place.
    ///
    /// Nothing is allocated for bytes that the file does not have.
    pub fn bytes(&self, field: &str, offset: u64, length: u64) -> Result<Vec<u8>, DecodeError> {
        if offset.checked_add(length).is_none_or(|end| end > self.length) {
            return Err(DecodeError::wrong(
                field,
                format!("{length} bytes from byte {offset} in a file of {} bytes", self.length),
                "a place within the file",
            ));
        }
        let mut bytes = vec![0; length as usize];
        self.fill(&mut bytes, offset)?;
        Ok(bytes)
    }

    /// Fills all of `bytes` from `offset` on.
    pub fn fill(&self, bytes: &mut [u8], offset: u64) -> io::Result<()> {
        let mut done = 0;
        while done < bytes.len() {
            match read_at(&self.file, &mut bytes[done..], offset + done as u64) {
                Ok(0) => return Err(io::ErrorKind::UnexpectedEof.into()),
                Ok(read) => done += read,
                Err(error) if error.kind() == io::ErrorKind::Interrupted => {}
                Err(error) => return Err(error),
            }
        }
        Ok(())
    }
}

#[cfg(unix)]
fn read_at(file: &File, bytes: &mut [u8], offset: u64) -> io::Result<usize> {
    std::os::unix::fs::FileExt::read_at(file, bytes, offset)
}

#[cfg(windows)]
fn read_at(file: &File, bytes: &mut [u8], offset: u64) -> io::Result<usize> {
    std::os::windows::fs::FileExt::seek_read(file, bytes, offset)
}
