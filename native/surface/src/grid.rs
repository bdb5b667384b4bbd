//! A grid: a layout over bytes.

use crate::layout::{GridLayout, LayoutError};
use crate::storage::{KeepAlive, Storage};
use std::fs::File;
use std::io;
use std::path::{Path, PathBuf};

/// A file or buffer that cannot be used as a grid.
#[derive(Debug, thiserror::Error)]
pub enum GridError {
    /// The layout itself is impossible.
    #[error(transparent)]
    Layout(#[from] LayoutError),
    /// The file cannot be opened or mapped.
    #[error("{}: cannot be opened as a grid: {source}", path.display())]
    File {
        /// The file.
        path: PathBuf,
        /// What the system said.
        source: io::Error,
    },
    /// There are fewer bytes than the layout needs.
    #[error(
        "{what} holds {found} bytes, but {rows} rows of {columns} samples need {expected}; \
         it is cut short, or its label belongs to another file"
    )]
    TooShort {
        /// The file's path, or `the buffer`.
        what: String,
        /// Bytes there.
        found: u64,
        /// Bytes needed.
        expected: u64,
        /// Rows of the layout.
        rows: u32,
        /// Columns of the layout.
        columns: u32,
    },
}

/// An elevation grid whose samples stay where they lie. Cheap to share behind an `Arc`.
pub struct Grid {
    layout: GridLayout,
    storage: Storage,
}

impl Grid {
    /// Maps a file read-only. Nothing is read before it is touched.
    pub fn open(path: &Path, layout: GridLayout) -> Result<Self, GridError> {
        let failed = |source| GridError::File { path: path.to_owned(), source };
        let file = File::open(path).map_err(failed)?;
        let metadata = file.metadata().map_err(failed)?;
        if !metadata.is_file() {
            return Err(failed(io::Error::other("it is not a file")));
        }
        require_bytes(path.display().to_string(), metadata.len(), &layout)?;
        let storage = Storage::map(file).map_err(failed)?;
        // Again on what was mapped: the file may have been cut in between.
        require_bytes(path.display().to_string(), storage.length() as u64, &layout)?;
        Ok(Self { layout, storage })
    }

    /// Uses bytes in memory.
    pub fn from_vec(bytes: Vec<u8>, layout: GridLayout) -> Result<Self, GridError> {
        let (address, length) = (bytes.as_ptr(), bytes.len());
        // SAFETY: a moved Vec keeps its heap block, and it is dropped with the grid.
        unsafe { Self::from_foreign(address, length, Box::new(bytes), layout) }
    }

    /// Uses bytes that somebody else keeps, without copying them.
    ///
    /// # Safety
    /// `address` must stay readable for `length` bytes until `kept` is dropped. The bytes may
    /// change meanwhile.
    pub unsafe fn from_foreign(
        address: *const u8,
        length: usize,
        kept: KeepAlive,
        layout: GridLayout,
    ) -> Result<Self, GridError> {
        require_bytes("the buffer".to_owned(), length as u64, &layout)?;
        // SAFETY: passed on to the caller.
        let storage = unsafe { Storage::foreign(address, length, kept) };
        Ok(Self { layout, storage })
    }

    /// Where the samples lie.
    pub fn layout(&self) -> &GridLayout {
        &self.layout
    }

    /// Whether the mapped file was cut short while in use; what is lost reads as bytes of zero.
    ///
    /// Known once a read has met the cut, or [`look_at_file`](Self::look_at_file) has seen it.
    pub fn damaged(&self) -> bool {
        self.storage.damaged()
    }

    /// Asks the system whether the mapped file has been cut. Not for the servo: it is a system call.
    pub fn look_at_file(&self) {
        self.storage.look_at_file();
    }

    /// Where a sample's bytes lie, for tools that look at caches and pages; `None` off the map. On a
    /// grid that wraps, columns run on beyond the last one.
    pub fn sample_address(&self, column: i64, row: i64) -> Option<*const u8> {
        let layout = &self.layout;
        let columns = i64::from(layout.columns());
        let column = if layout.wraps() { column.rem_euclid(columns) } else { column };
        if !(0..columns).contains(&column) || !(0..i64::from(layout.rows())).contains(&row) {
            return None;
        }
        let in_row = column as u64 * layout.sample().bytes() as u64;
        let offset = layout.offset() + row as u64 * layout.row_stride() + in_row;
        Some(self.storage.address().wrapping_add(offset as usize))
    }

    /// Copies the bytes of a row's samples, from the first to the last, as they lie.
    ///
    /// # Panics
    /// Where there is no such row, or `bytes` are not as many as its samples have.
    pub fn copy_row(&self, row: u32, bytes: &mut [u8]) {
        let layout = &self.layout;
        let length = layout.columns() as usize * layout.sample().bytes();
        assert!(row < layout.rows(), "no row {row}");
        assert_eq!(bytes.len(), length, "bytes of a row");
        let offset = layout.offset() + u64::from(row) * layout.row_stride();
        let first = self.storage.address().wrapping_add(offset as usize);
        // SAFETY: the layout lies within the storage, which stays readable while the grid lives; what
        // is read may change meanwhile, and any bytes are samples.
        unsafe { std::ptr::copy_nonoverlapping(first, bytes.as_mut_ptr(), length) };
    }

    pub(crate) fn storage(&self) -> &Storage {
        &self.storage
    }
}

impl std::fmt::Debug for Grid {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Grid").field("layout", &self.layout).finish_non_exhaustive()
    }
}

fn require_bytes(what: String, found: u64, layout: &GridLayout) -> Result<(), GridError> {
    let expected = layout.byte_length();
    if found >= expected {
        return Ok(());
    }
    let (rows, columns) = (layout.rows(), layout.columns());
    Err(GridError::TooShort { what, found, expected, rows, columns })
}
