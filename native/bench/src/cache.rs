//! What is in the processor's caches before a block of updates: all that it needs, or nothing.

use crate::path::Course;
use crate::scene::Scene;
use contact::Contact;
use std::hint::black_box;
use surface::GridPoint;

/// Whether lines can be taken out of the caches.
pub const CAN_FLUSH: bool = cfg!(target_arch = "x86_64");

/// Bytes of a cache line.
const LINE: usize = 64;

/// Bytes of a page.
const PAGE: usize = 4096;

/// Pages swept: more than the translation caches of today's processors hold.
const PAGES: usize = 6000;

/// Samples beside a way that may be read.
const BESIDE: i64 = 2;

/// The state of the caches in which a block of updates begins.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Warmth {
    /// Every line of the block was read twice.
    Hot,
    /// Every line of the block was flushed, and the translation cache swept.
    Cold,
    /// As the updates before have left it.
    Untouched,
}

impl Warmth {
    /// In tables and figures.
    pub fn name(self) -> &'static str {
        match self {
            Self::Hot => "hot",
            Self::Cold => "cold",
            Self::Untouched => "untouched",
        }
    }
}

/// The cache lines of a grid that blocks of updates may read.
pub struct Lines {
    /// For each block, an address in each of its lines.
    blocks: Vec<Vec<usize>>,
    updates: usize,
}

impl Lines {
    /// The lines around the ways of all `traces` over a course, and around `vertices` for each update.
    pub fn around(
        scene: &Scene,
        course: &Course,
        traces: &[Vec<Contact>],
        vertices: &[Vec<(i64, i64)>],
        updates_in_block: usize,
    ) -> Self {
        let updates = course.goals.len();
        let mut blocks = Vec::new();
        for first in (0..updates).step_by(updates_in_block) {
            let mut lines = Vec::new();
            for update in first..(first + updates_in_block).min(updates) {
                let goal = course.goals[update];
                add_way(&mut lines, scene, &course.goal_before(update), &goal);
                for trace in traces {
                    let from = match course.start_at(update) {
                        Some(start) => start.position,
                        None => trace[update - 1].proxy,
                    };
                    add_way(&mut lines, scene, &from, &trace[update].proxy);
                    add_way(&mut lines, scene, &trace[update].proxy, &goal);
                }
                for &(column, row) in vertices.get(update).into_iter().flatten() {
                    add_around(&mut lines, scene, column, row);
                }
            }
            lines.sort_unstable();
            lines.dedup_by_key(|address| *address / LINE);
            blocks.push(lines);
        }
        Self { blocks, updates }
    }

    /// Lines in an update, mean.
    pub fn mean(&self) -> f64 {
        self.blocks.iter().map(Vec::len).sum::<usize>() as f64 / self.updates.max(1) as f64
    }

    /// Reads every line of a block twice.
    ///
    /// # Safety
    /// The grid that the lines belong to must still be there.
    pub unsafe fn warm(&self, block: usize) {
        let mut seen = 0;
        for _ in 0..2 {
            for line in &self.blocks[block] {
                // SAFETY: a byte of the grid, which the caller keeps.
                seen ^= unsafe { (*line as *const u8).read_volatile() };
            }
        }
        black_box(seen);
    }

    /// Takes every line of a block out of the caches.
    ///
    /// # Safety
    /// The grid that the lines belong to must still be there.
    pub unsafe fn flush(&self, block: usize) {
        #[cfg(target_arch = "x86_64")]
        {
            use std::arch::x86_64::{_mm_clflush, _mm_mfence};
            for line in &self.blocks[block] {
                // SAFETY: an address in the grid, which the caller keeps; nothing is changed.
                unsafe { _mm_clflush(*line as *const u8) };
            }
            // SAFETY: every x86-64 processor has it.
            unsafe { _mm_mfence() };
        }
        #[cfg(not(target_arch = "x86_64"))]
        let _ = block;
    }
}

/// Adds the lines around the straight way from one point to another.
fn add_way(lines: &mut Vec<usize>, scene: &Scene, from: &GridPoint, to: &GridPoint) {
    let [columns, rows, _] = to.relative_to(from.column, from.row, 0.0);
    let (east, south) = (columns - from.u, rows - from.v);
    let pieces = east.abs().max(south.abs()).ceil().max(1.0);
    for piece in 0..=pieces as u32 {
        let share = f64::from(piece) / pieces;
        let column = from.column + (from.u + share * east).floor() as i64;
        let row = from.row + (from.v + share * south).floor() as i64;
        add_around(lines, scene, column, row);
    }
}

/// Adds the lines of the samples around a cell.
fn add_around(lines: &mut Vec<usize>, scene: &Scene, column: i64, row: i64) {
    for row in row - BESIDE..=row + 1 + BESIDE {
        for column in [column - BESIDE, column + 1 + BESIDE] {
            if let Some(address) = scene.grid.sample_address(column, row) {
                lines.push(address as usize);
            }
        }
    }
}

/// Pages that nobody else reads: reading them takes all others out of the translation cache.
pub struct Sweep {
    pages: memmap2::MmapMut,
}

impl Sweep {
    /// Small pages, each written once so that it exists.
    pub fn new() -> std::io::Result<Self> {
        let mut pages = memmap2::MmapMut::map_anon(PAGES * PAGE)?;
        // Large pages would be far fewer; where none are to be had the advice fails, rightly.
        #[cfg(target_os = "linux")]
        let _ = pages.advise(memmap2::Advice::NoHugePage);
        pages.iter_mut().step_by(PAGE).for_each(|byte| *byte = 1);
        Ok(Self { pages })
    }

    /// Reads one byte of every page, each in another line of its page.
    pub fn run(&self) {
        let bytes = (0..PAGES).map(|page| self.pages[page * PAGE + page * LINE % PAGE]);
        black_box(bytes.fold(0u8, |all, byte| all ^ byte));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::path::Hand;
    use crate::scene::{Field, Mode};
    use surface::{ByteOrder, Grid, GridLayout, SampleType};

    #[test]
    fn the_lines_of_a_block_hold_every_sample_beside_its_ways_and_each_once() {
        let layout = GridLayout::packed(300, 300, 1.0, 1.0, SampleType::I16, ByteOrder::Big);
        let grid = Grid::from_vec(vec![0; 300 * 300 * 2], layout.unwrap()).unwrap();
        let scene = Scene {
            key: "flat",
            title: String::new(),
            grid: &grid,
            exaggeration: 1.0,
            mode: Mode::Swipe,
            field: Field::Part(20.0, 280.0, 20.0, 280.0),
        };
        let course = Hand::new(5.0, 1).over(&scene, 64);
        let lines = Lines::around(&scene, &course, &[], &[], 16);
        assert_eq!(lines.blocks.len(), 4);
        for (update, goal) in course.goals.iter().enumerate() {
            let block = &lines.blocks[update / 16];
            for (east, south) in (-2..=3).flat_map(|east| [-2, 0, 3].map(|south| (east, south))) {
                let address = grid.sample_address(goal.column + east, goal.row + south);
                let line = address.unwrap() as usize / LINE;
                let held = block.iter().filter(|held| *held / LINE == line).count();
                assert_eq!(held, 1, "update {update}");
            }
        }
    }
}
