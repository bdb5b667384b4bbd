//! Grounds to touch, in memory and in mapped files.

use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use surface::{ByteOrder, Grid, GridLayout, SampleType};

use crate::Window;

/// Samples along each side.
const SIDE: u32 = 64;

/// A ground and, where it is mapped, its file, which is removed in the end.
pub(super) struct Ground {
    pub(super) grid: Arc<Grid>,
    pub(super) is_flat: bool,
    file: Option<PathBuf>,
}

impl Ground {
    /// Cells of 1 m, flat or with steps of up to 20 cm.
    pub(super) fn new(is_flat: bool, is_mapped: bool) -> Ground {
        let side = u64::from(SIDE);
        let layout = GridLayout::packed(side, side, 1.0, 1.0, SampleType::F64, ByteOrder::Little)
            .expect("a layout that can be");
        let height = |index: u32| f64::from((index * 7919) % 17) / 85.0;
        let samples = (0..SIDE * SIDE).map(|index| if is_flat { 0.0 } else { height(index) });
        let bytes: Vec<u8> = samples.flat_map(f64::to_le_bytes).collect();
        let file = is_mapped.then(|| write(&bytes));
        let grid = match &file {
            Some(path) => Grid::open(path, layout),
            None => Grid::from_vec(bytes, layout),
        };
        Ground { grid: Arc::new(grid.expect("a grid that can be opened")), is_flat, file }
    }

    /// The middle, or so many metres east and north of it, 1 m of ground being 1 cm of workspace.
    pub(super) fn window([east, north]: [f64; 2]) -> Window {
        let middle = f64::from(SIDE) / 2.0;
        let window = Window::new(middle + east, north - middle, 0.0, 16.0, 1.0);
        window.expect("a window that can be")
    }

    /// Cuts the mapped file.
    pub(super) fn cut(&self) {
        let path = self.file.as_ref().expect("a mapped ground");
        let file = std::fs::File::options().write(true).open(path).expect("a file to cut");
        file.set_len(0).expect("a file that can be cut");
    }
}

impl Drop for Ground {
    fn drop(&mut self) {
        if let Some(path) = &self.file {
            let _ = std::fs::remove_file(path);
        }
    }
}

fn write(bytes: &[u8]) -> PathBuf {
    static FILES: AtomicU64 = AtomicU64::new(0);
    let number = FILES.fetch_add(1, Ordering::Relaxed);
    let name = format!("servo-faults-{}-{number}.f64", std::process::id());
    let path = std::env::temp_dir().join(name);
    std::fs::write(&path, bytes).expect("room for a file of 32 KB");
    path
}
