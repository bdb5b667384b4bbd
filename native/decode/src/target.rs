//! Where decoded samples go: memory, or a file that is mapped like any other grid.

use crate::error::DecodeError;
use memmap2::MmapMut;
use std::alloc::{self, Layout};
use std::fs::{self, File, OpenOptions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};
use surface::{Grid, GridLayout};

/// The bytes of a grid in the making, as its layout has them.
pub struct Target {
    layout: GridLayout,
    bytes: Bytes,
}

enum Bytes {
    Memory(Vec<u8>),
    File { mapping: MmapMut, unfinished: Unfinished, path: PathBuf },
}

/// A file that is removed unless it is finished: a cache that is half written would be believed.
struct Unfinished(PathBuf);

impl Drop for Unfinished {
    fn drop(&mut self) {
        // Nothing is lost where it cannot be removed: only a finished file has the name that is read.
        let _ = fs::remove_file(&self.0);
    }
}

impl Target {
    /// Room in a file at `cache` where one is named, else in memory.
    pub fn new(layout: GridLayout, cache: Option<&Path>) -> Result<Self, DecodeError> {
        match cache {
            Some(path) => Self::file(layout, path),
            None => Self::memory(layout),
        }
    }

    /// Room in memory.
    pub fn memory(layout: GridLayout) -> Result<Self, DecodeError> {
        let length = layout.byte_length() as usize;
        let bytes = zeros(length).ok_or_else(|| {
            DecodeError::wrong(
                "memory",
                format!("no room for {length} bytes"),
                "enough free memory",
            )
        })?;
        Ok(Self { layout, bytes: Bytes::Memory(bytes) })
    }

    /// Room on the disk: `path` appears when everything is written, or not at all.
    ///
    /// The room is taken from the disk here and now: a full disk is an error here, and no signal
    /// (SIGBUS) when a sample is written to the mapped file.
    pub fn file(layout: GridLayout, path: &Path) -> Result<Self, DecodeError> {
        let (file, unfinished) = unfinished_file(path)?;
        reserve(&file, layout.byte_length())?;
        // SAFETY: `unfinished_file` made the file, under a name that no other target has: none of them
        // cuts it. Who removes it takes its name away, and leaves the bytes to this mapping.
        let mapping = unsafe { MmapMut::map_mut(&file)? };
        Ok(Self { layout, bytes: Bytes::File { mapping, unfinished, path: path.to_owned() } })
    }

    /// The layout that the bytes follow.
    pub fn layout(&self) -> &GridLayout {
        &self.layout
    }

    /// The bytes of a row, from its first sample to its last.
    ///
    /// # Panics
    /// Where the layout has no such row.
    pub fn row(&mut self, row: u32) -> &mut [u8] {
        assert!(row < self.layout.rows(), "no row {row}");
        let first = self.layout.offset() + u64::from(row) * self.layout.row_stride();
        let length = self.row_length();
        &mut self.bytes_mut()[first as usize..][..length]
    }

    /// Bands of so many rows each, from the first row on, for threads that write side by side.
    ///
    /// # Panics
    /// Where the layout has not so many rows.
    pub fn bands(&mut self, heights: impl IntoIterator<Item = u32>) -> Vec<Band<'_>> {
        let (offset, stride) = (self.layout.offset() as usize, self.layout.row_stride() as usize);
        let (rows, length) = (self.layout.rows(), self.row_length());
        let mut rest = &mut self.bytes_mut()[offset..];
        let mut left = rows;
        let band = |height| {
            left = left.checked_sub(height).expect("as many rows as the layout has");
            // The last row has no bytes between it and the next.
            let end = (height as usize * stride).min(rest.len());
            let (bytes, others) = std::mem::take(&mut rest).split_at_mut(end);
            rest = others;
            Band { bytes, stride, length }
        };
        heights.into_iter().map(band).collect()
    }

    /// The finished grid.
    pub fn finish(self) -> Result<Grid, DecodeError> {
        match self.bytes {
            Bytes::Memory(bytes) => Ok(Grid::from_vec(bytes, self.layout)?),
            Bytes::File { mapping, unfinished, path } => {
                mapping.flush()?;
                drop(mapping);
                fs::rename(&unfinished.0, &path)?;
                Ok(Grid::open(&path, self.layout)?)
            }
        }
    }

    fn row_length(&self) -> usize {
        self.layout.columns() as usize * self.layout.sample().bytes()
    }

    fn bytes_mut(&mut self) -> &mut [u8] {
        match &mut self.bytes {
            Bytes::Memory(bytes) => bytes,
            Bytes::File { mapping, .. } => mapping,
        }
    }
}

/// Some rows of a target.
pub struct Band<'a> {
    bytes: &'a mut [u8],
    stride: usize,
    length: usize,
}

impl Band<'_> {
    /// The bytes of a row, from its first sample to its last; row 0 is the band's first.
    ///
    /// # Panics
    /// Where the band has no such row.
    pub fn row(&mut self, row: u32) -> &mut [u8] {
        &mut self.bytes[row as usize * self.stride..][..self.length]
    }
}

/// Makes a file beside `path` that is nobody else's: `path.PROCESS.NUMBER.part`.
///
/// Several imports may decode the same file at once, in one process or in two. The process is named so that
/// what a dead one left is told from what a living one writes.
fn unfinished_file(path: &Path) -> io::Result<(File, Unfinished)> {
    static NUMBER: AtomicU64 = AtomicU64::new(0);
    loop {
        let number = NUMBER.fetch_add(1, Ordering::Relaxed);
        let mut part = path.as_os_str().to_owned();
        part.push(format!(".{}.{number}.part", std::process::id()));
        match OpenOptions::new().read(true).write(true).create_new(true).open(&part) {
            Ok(file) => return Ok((file, Unfinished(PathBuf::from(part)))),
            // A process that had this number before left it.
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {}
            Err(error) => return Err(error),
        }
    }
}

/// Zeros that cost nothing until they are used; `None` where there is no room for them.
fn zeros(length: usize) -> Option<Vec<u8>> {
    let layout = Layout::array::<u8>(length).ok()?;
    if length == 0 {
        return Some(Vec::new());
    }
    // SAFETY: the layout is of more than 0 bytes.
    let address = unsafe { alloc::alloc_zeroed(layout) };
    // SAFETY: the allocator of vectors gave the address, for so many bytes, all of which are set.
    (!address.is_null()).then(|| unsafe { Vec::from_raw_parts(address, length, length) })
}

/// Takes the blocks of a file from the disk, as far as the file system can promise them.
#[cfg(target_os = "linux")]
fn reserve(file: &File, length: u64) -> io::Result<()> {
    use std::os::fd::AsRawFd;
    let too_long = |_| io::Error::from(io::ErrorKind::FileTooLarge);
    let length_there = length.try_into().map_err(too_long)?;
    // SAFETY: the descriptor is open as long as `file` is borrowed; no memory is handed over.
    match unsafe { libc::posix_fallocate(file.as_raw_fd(), 0, length_there) } {
        0 => Ok(()),
        // Some file systems cannot; some C libraries then write the file themselves, and others do not.
        libc::EOPNOTSUPP | libc::EINVAL => write_zeros(file, length),
        error => Err(io::Error::from_raw_os_error(error)),
    }
}

/// Takes the blocks of a file from the disk.
#[cfg(not(target_os = "linux"))]
fn reserve(file: &File, length: u64) -> io::Result<()> {
    write_zeros(file, length)
}

/// Takes the blocks of a file from the disk by writing all of it.
fn write_zeros(mut file: &File, length: u64) -> io::Result<()> {
    let zeros = [0; 1 << 16];
    let mut left = length;
    while left > 0 {
        let count = left.min(zeros.len() as u64);
        file.write_all(&zeros[..count as usize])?;
        left -= count;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use surface::{ByteOrder, SampleType};

    fn layout() -> GridLayout {
        GridLayout::packed(2, 3, 1.0, 1.0, SampleType::I16, ByteOrder::Little).unwrap()
    }

    fn fill(mut target: Target) -> Grid {
        target.row(0).copy_from_slice(&[1, 0, 2, 0, 3, 0]);
        target.row(1).copy_from_slice(&[4, 0, 5, 0, 6, 0]);
        target.finish().unwrap()
    }

    #[test]
    fn bands_are_the_rows_one_after_the_other() {
        for offset in [0, 5] {
            let layout = layout().with_offset(offset).unwrap().with_row_stride(9).unwrap();
            let mut target = Target::memory(layout).unwrap();
            let mut bands = target.bands([1, 1]);
            bands[1].row(0).copy_from_slice(&[4, 0, 5, 0, 6, 0]);
            bands[0].row(0).copy_from_slice(&[1, 0, 2, 0, 3, 0]);
            assert_eq!(target.row(1), [4, 0, 5, 0, 6, 0]);
            let grid = target.finish().unwrap();
            assert_eq!((grid.elevation(2, 0), grid.elevation(2, 1)), (Some(3.0), Some(6.0)));
        }
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn a_file_has_its_blocks_before_it_is_written() {
        use std::os::unix::fs::MetadataExt;
        let folder = std::env::temp_dir().join(format!("decode-blocks-{}", std::process::id()));
        fs::create_dir_all(&folder).unwrap();
        let layout =
            GridLayout::packed(1000, 1000, 1.0, 1.0, SampleType::I16, ByteOrder::Little).unwrap();
        let target = Target::file(layout, &folder.join("grid")).unwrap();
        let part = fs::read_dir(&folder).unwrap().next().unwrap().unwrap();
        assert!(part.metadata().unwrap().blocks() * 512 >= 2_000_000);
        drop(target);
        fs::remove_dir_all(&folder).unwrap();
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn a_file_larger_than_the_disk_is_an_error_and_leaves_nothing() {
        let folder = std::env::temp_dir().join(format!("decode-full-{}", std::process::id()));
        fs::create_dir_all(&folder).unwrap();
        let layout =
            GridLayout::packed(1 << 30, 1 << 30, 1.0, 1.0, SampleType::I16, ByteOrder::Little)
                .unwrap();
        let path = folder.join("grid");
        assert!(matches!(Target::file(layout, &path), Err(DecodeError::File(_))));
        assert_eq!(fs::read_dir(&folder).unwrap().count(), 0);
        fs::remove_dir_all(&folder).unwrap();
    }

    #[test]
    fn two_decodings_of_one_file_at_once_both_end_whole() {
        let folder = std::env::temp_dir().join(format!("decode-twice-{}", std::process::id()));
        fs::create_dir_all(&folder).unwrap();
        let path = folder.join("grid");
        let mut first = Target::file(layout(), &path).unwrap();
        first.row(0).copy_from_slice(&[9, 0, 8, 0, 7, 0]);
        first.row(1).copy_from_slice(&[6, 0, 5, 0, 4, 0]);
        let second = Target::file(layout(), &path).unwrap();
        assert_eq!(first.row(0), [9, 0, 8, 0, 7, 0], "the second does not write over it");
        let first = first.finish().unwrap();
        let second = fill(second);
        assert_eq!((first.elevation(0, 0), first.elevation(2, 1)), (Some(9.0), Some(4.0)));
        assert_eq!((second.elevation(0, 0), second.elevation(2, 1)), (Some(1.0), Some(6.0)));
        let left: Vec<_> =
            fs::read_dir(&folder).unwrap().map(|entry| entry.unwrap().file_name()).collect();
        assert_eq!(left, ["grid"]);
        fs::remove_dir_all(&folder).unwrap();
    }

    #[test]
    fn memory_and_file_give_the_same_grid() {
        let folder = std::env::temp_dir().join(format!("decode-target-{}", std::process::id()));
        fs::create_dir_all(&folder).unwrap();
        let path = folder.join("grid");
        for target in [Target::memory(layout()).unwrap(), Target::file(layout(), &path).unwrap()] {
            let grid = fill(target);
            assert_eq!(grid.elevation(2, 0), Some(3.0));
            assert_eq!(grid.elevation(0, 1), Some(4.0));
        }
        drop(Target::file(layout(), &folder.join("unfinished")).unwrap());
        let left: Vec<_> =
            fs::read_dir(&folder).unwrap().map(|entry| entry.unwrap().file_name()).collect();
        assert_eq!(left, ["grid"]);
        fs::remove_dir_all(&folder).unwrap();
    }
}
