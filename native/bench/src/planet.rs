//! Synthetic planets of several sizes, as files mapped like any other grid.

use crate::path::Course;
use crate::terrain::{Relief, Terrain};
use std::fs::File;
use std::hint::black_box;
use std::io::{self, Read};
use std::path::{Path, PathBuf};
use surface::{Grid, GridError, GridPoint};

/// Bytes of a page.
const PAGE: usize = 4096;

/// Cells beside a path whose pages are touched before.
const ASIDE: i64 = 64;

/// A size: its name in figures and tables, columns and rows.
#[derive(Clone, Copy, Debug)]
pub struct Size {
    /// Triangles, roughly.
    pub key: &'static str,
    columns: usize,
    rows: usize,
}

/// The paper's data set, 16 samples in a degree.
pub const SIZE_33M: Size = Size { key: "33M", columns: 5760, rows: 2880 };
/// 32 in a degree.
pub const SIZE_133M: Size = Size { key: "133M", columns: 11_520, rows: 5760 };
/// 128 in a degree from 88 degrees south to 88 north, the finest of MOLA's cylindrical maps.
pub const SIZE_2G: Size = Size { key: "2G", columns: 46_080, rows: 22_528 };
/// As many as fit a ten thousand million triangles, whole tiles around.
pub const SIZE_10G: Size = Size { key: "10G", columns: 99_840, rows: 49_920 };

/// A planet that cannot be made.
#[derive(Debug, thiserror::Error)]
pub enum PlanetError {
    /// Too little room on the disk.
    #[error(
        "{}: {needed:.1} GB are needed for synthetic grids, and {free:.1} GB are free; \
         make room, or put the folder elsewhere",
        folder.display()
    )]
    NoRoom {
        /// Where the files go.
        folder: PathBuf,
        /// Thousand million bytes.
        needed: f64,
        /// Thousand million bytes.
        free: f64,
    },
    /// A file cannot be written.
    #[error("{}: {source}", path.display())]
    File {
        /// The file.
        path: PathBuf,
        /// What the system said.
        source: io::Error,
    },
    /// A file cannot be mapped.
    #[error(transparent)]
    Grid(#[from] GridError),
}

/// A planet to touch.
pub struct Planet<'a> {
    /// How large it is.
    pub size: Size,
    /// What it is made of.
    pub terrain: Terrain<'a>,
    /// Its file, mapped.
    pub grid: Grid,
    path: PathBuf,
}

impl Size {
    /// Bytes of the file.
    pub fn bytes(&self) -> u64 {
        2 * self.columns as u64 * self.rows as u64
    }

    fn path(&self, folder: &Path) -> PathBuf {
        folder.join(format!("planet-{}.img", self.key))
    }
}

impl<'a> Planet<'a> {
    /// Writes the file, unless it is there, and maps it.
    pub fn make(size: Size, relief: &'a Relief, folder: &Path) -> Result<Self, PlanetError> {
        let terrain = Terrain::new(relief, size.columns, size.rows);
        let path = size.path(folder);
        terrain.write(&path).map_err(|source| PlanetError::File { path: path.clone(), source })?;
        let grid = Grid::open(&path, terrain.layout())?;
        Ok(Self { size, terrain, grid, path })
    }

    /// Reads the file once in order, so that it is in the system's page cache as far as it fits.
    pub fn read_through(&self) -> io::Result<()> {
        let mut file = File::open(&self.path)?;
        let mut buffer = vec![0; 8 << 20];
        while file.read(&mut buffer)? > 0 {}
        Ok(())
    }

    /// Touches each page around each leg of a course, in one line of its 64, so that the system (and
    /// a virtual machine's host) has it mapped: a page's first touch is another story.
    pub fn touch_pages(&self, course: &Course) {
        for leg in course.goals.chunks(course.leg) {
            let bounds = |line: fn(&GridPoint) -> i64| {
                let lines = leg.iter().map(line);
                lines
                    .fold((i64::MAX, i64::MIN), |(low, high), line| (low.min(line), high.max(line)))
            };
            let (west, east) = bounds(|goal| goal.column);
            let (north, south) = bounds(|goal| goal.row);
            for row in north - ASIDE..=south + ASIDE {
                let columns = (west - ASIDE..=east + ASIDE).step_by(PAGE / 2);
                for column in columns.chain([east + ASIDE]) {
                    self.touch_page(column, row);
                }
            }
        }
    }

    fn touch_page(&self, column: i64, row: i64) {
        if let Some(address) = self.grid.sample_address(column, row) {
            let page = address as usize / PAGE * PAGE;
            // SAFETY: a mapping begins with a page, so this byte is of the grid's own mapping.
            black_box(unsafe { (page as *const u8).read_volatile() });
        }
    }

    /// Removes the file.
    pub fn remove(self) -> io::Result<()> {
        drop(self.grid);
        std::fs::remove_file(&self.path)
    }
}

/// Fails where the files that are still missing would not fit on the disk.
pub fn require_room(sizes: &[Size], folder: &Path) -> Result<(), PlanetError> {
    let is_missing = |size: &&Size| {
        let found = std::fs::metadata(size.path(folder)).map_or(0, |metadata| metadata.len());
        found != size.bytes()
    };
    let needed: u64 = sizes.iter().filter(is_missing).map(Size::bytes).sum();
    let free = free_bytes(folder)
        .map_err(|source| PlanetError::File { path: folder.to_owned(), source })?;
    if free >= needed + needed / 20 {
        return Ok(());
    }
    let folder = folder.to_owned();
    Err(PlanetError::NoRoom { folder, needed: needed as f64 / 1e9, free: free as f64 / 1e9 })
}

#[cfg(unix)]
fn free_bytes(folder: &Path) -> io::Result<u64> {
    use std::os::unix::ffi::OsStrExt;
    let path = std::ffi::CString::new(folder.as_os_str().as_bytes())?;
    let mut found = std::mem::MaybeUninit::<libc::statvfs>::uninit();
    // SAFETY: the path ends with a zero, and `found` is ours to be filled.
    if unsafe { libc::statvfs(path.as_ptr(), found.as_mut_ptr()) } != 0 {
        return Err(io::Error::last_os_error());
    }
    // SAFETY: filled, as the call succeeded.
    let found = unsafe { found.assume_init() };
    #[allow(clippy::unnecessary_cast, reason = "the types differ from system to system")]
    Ok(found.f_bavail as u64 * found.f_frsize as u64)
}

#[cfg(not(unix))]
fn free_bytes(_folder: &Path) -> io::Result<u64> {
    Ok(u64::MAX)
}
