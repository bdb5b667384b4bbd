//! Decoding a window of the raster: only the chunks that it needs, by several threads.

use super::GeoTiff;
use super::worker::{Plan, Worker};
use crate::error::DecodeError;
use crate::progress::Progress;
use crate::target::{Band, Target};
use std::ops::Range;
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, PoisonError};
use surface::{Grid, GridLayout};

/// Which samples are wanted; the layout says how many, and how they are written.
#[derive(Clone, Copy, Debug)]
pub struct Window {
    /// Columns beyond the raster's last go on at its first.
    pub first_column: u32,
    /// Counted from the north: from the file's last row on where it is `south_up`.
    pub first_row: u32,
    /// Whether the file's first row is the southernmost: rows are then turned over.
    pub south_up: bool,
    /// The value of samples in chunks that the file leaves out.
    pub fill: f64,
}

impl GeoTiff {
    /// Decodes the first band into memory, or into a file at `cache` that is then mapped.
    ///
    /// The layout's sample type must be the one that [`super::StoredSample::decoded`] gives.
    pub fn decode(
        &self,
        layout: GridLayout,
        window: &Window,
        cache: Option<&Path>,
        progress: &Progress,
    ) -> Result<Grid, DecodeError> {
        self.check(&layout, window)?;
        let mut target = Target::new(layout, cache)?;
        run(&Plan::new(self, &layout, window, progress), &mut target)?;
        progress.step(1, 1)?;
        target.finish()
    }

    fn check(&self, layout: &GridLayout, window: &Window) -> Result<(), DecodeError> {
        let (rows, columns) = (layout.rows(), layout.columns());
        let fits = window.first_column < self.columns()
            && columns <= self.columns()
            && u64::from(window.first_row) + u64::from(rows) <= u64::from(self.rows());
        if !fits {
            return Err(DecodeError::wrong(
                "region",
                format!(
                    "{columns} columns from {} and {rows} rows from {}",
                    window.first_column, window.first_row
                ),
                format!("a part of {} columns and {} rows", self.columns(), self.rows()),
            ));
        }
        let stored = self.stored();
        if layout.sample() != stored.decoded() {
            return Err(DecodeError::wrong(
                "layout",
                format!("samples of type {:?}", layout.sample()),
                format!("{:?} for {} in the file", stored.decoded(), stored.name()),
            ));
        }
        // Chunks that lie over each other, or are left out, must not make more than a file could hold.
        let most = self.source.length().saturating_mul(MOST_GROWTH);
        if layout.byte_length() > most {
            return Err(DecodeError::wrong(
                "ImageLength and ImageWidth",
                format!("{} bytes of samples", layout.byte_length()),
                format!("at most {most} from a file of {} bytes", self.source.length()),
            ));
        }
        Ok(())
    }
}

/// Times that a raster may be larger than its file. Compression gives up to 2560 (see `Compression`); a raster
/// with most chunks left out costs 16 bytes for each, and GDAL's tiles have 65,536 samples.
const MOST_GROWTH: u64 = 1 << 15;

/// Threads that decode at the most: beyond, the disk and the memory are what takes time.
const MOST_THREADS: usize = 8;

/// Chunks side by side, or one above the other: what one thread does at a time.
struct Job<'a> {
    down: u64,
    rows: Range<u32>,
    band: Band<'a>,
}

/// Decodes all rows of chunks, each by whichever thread is free.
fn run(plan: &Plan<'_>, target: &mut Target) -> Result<(), DecodeError> {
    let mut rows: Vec<_> = plan.rows_of_chunks().collect();
    if plan.south_up {
        rows.reverse();
    }
    let bands = target.bands(rows.iter().map(|(_, rows)| rows.end - rows.start));
    let jobs = rows.into_iter().zip(bands);
    let jobs: Vec<_> = jobs.map(|((down, rows), band)| Job { down, rows, band }).collect();
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    let threads = threads.min(MOST_THREADS).min(jobs.len());
    let jobs = Mutex::new(jobs.into_iter());
    let ended = AtomicBool::new(false);
    let work = || {
        let mut worker = Worker::new(plan);
        while !ended.load(Ordering::Relaxed) {
            let next = jobs.lock().unwrap_or_else(PoisonError::into_inner).next();
            let Some(mut job) = next else { break };
            worker.decode(job.down, job.rows, &mut job.band).inspect_err(|_| {
                ended.store(true, Ordering::Relaxed);
            })?;
        }
        Ok(())
    };
    if threads < 2 {
        return work();
    }
    std::thread::scope(|scope| {
        let others: Vec<_> = (1..threads).map(|_| scope.spawn(work)).collect();
        let mine = work();
        // A thread that panicked ends this one too: nothing half done is taken for a grid.
        others.into_iter().map(|thread| thread.join().expect("no panic")).fold(mine, Result::and)
    })
}
