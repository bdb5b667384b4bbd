//! One thread of a decoding: chunk by chunk, row by row.

use super::GeoTiff;
use super::codec::Codec;
use super::decode::Window;
use super::input::{Input, Trouble};
use super::predictor::RowShape;
use crate::error::DecodeError;
use crate::progress::Progress;
use crate::target::Band;
use std::ops::Range;
use std::sync::atomic::{AtomicU64, Ordering};
use surface::{ByteOrder, GridLayout};

/// What all threads know.
pub struct Plan<'a> {
    tiff: &'a GeoTiff,
    progress: &'a Progress,
    /// Whether the file's rows are turned over.
    pub south_up: bool,
    rows: Range<u32>,
    spans: Vec<Span>,
    shape: RowShape,
    fill: Vec<u8>,
    to: ByteOrder,
    done: AtomicU64,
    all: u64,
}

/// Columns of the file, and the column of the target that the first of them becomes.
struct Span {
    file: Range<u32>,
    target: u32,
}

impl<'a> Plan<'a> {
    /// For a window that was checked.
    pub fn new(
        tiff: &'a GeoTiff,
        layout: &GridLayout,
        window: &Window,
        progress: &'a Progress,
    ) -> Self {
        let rows = if window.south_up {
            let end = tiff.rows() - window.first_row;
            end - layout.rows()..end
        } else {
            window.first_row..window.first_row + layout.rows()
        };
        let until_last = layout.columns().min(tiff.columns() - window.first_column);
        let spans = vec![
            Span { file: window.first_column..window.first_column + until_last, target: 0 },
            Span { file: 0..layout.columns() - until_last, target: until_last },
        ];
        let shape = RowShape {
            stored: tiff.stored(),
            bands: tiff.picture.bands_in_chunk() as usize,
            byte_order: tiff.byte_order(),
        };
        let mut plan = Self {
            tiff,
            progress,
            south_up: window.south_up,
            rows,
            spans,
            shape,
            fill: tiff.stored().decoded_value(window.fill, layout.byte_order()),
            to: layout.byte_order(),
            done: AtomicU64::new(0),
            all: 0,
        };
        let across = (0..tiff.chunks.across()).filter(|&across| plan.needs(across)).count();
        plan.all = across as u64 * u64::from(layout.rows());
        plan
    }

    /// The places down that hold wanted rows, and which these are.
    pub fn rows_of_chunks(&self) -> impl Iterator<Item = (u64, Range<u32>)> {
        let height = self.tiff.chunks.size().1;
        let (first, last) = (self.rows.start / height, (self.rows.end - 1) / height);
        (u64::from(first)..=u64::from(last))
            .map(|down| (down, overlap(&self.rows, &self.tiff.chunks.rows_of(down))))
    }

    fn needs(&self, across: u64) -> bool {
        let columns = self.tiff.chunks.columns_of(across);
        self.spans.iter().any(|span| !overlap(&span.file, &columns).is_empty())
    }

    /// Tells that so many more rows of chunks are done; fails when nobody wants them any more.
    fn tell(&self, rows: u64) -> Result<(), DecodeError> {
        let done = self.done.fetch_add(rows, Ordering::Relaxed) + rows;
        self.progress.step(done, self.all)
    }
}

/// A thread's own buffers.
pub struct Worker<'a> {
    plan: &'a Plan<'a>,
    input: Input<'a>,
    row: Vec<u8>,
    spare: Vec<u8>,
}

impl<'a> Worker<'a> {
    /// For a plan.
    pub fn new(plan: &'a Plan<'a>) -> Self {
        let codec = Codec::of(plan.tiff.compression());
        let input = Input::new(&plan.tiff.source, codec);
        Self { plan, input, row: Vec::new(), spare: Vec::new() }
    }

    /// Decodes rows of the file, all from the chunks at one place down.
    pub fn decode(
        &mut self,
        down: u64,
        rows: Range<u32>,
        band: &mut Band<'_>,
    ) -> Result<(), DecodeError> {
        for across in 0..self.plan.tiff.chunks.across() {
            if self.plan.needs(across) {
                self.chunk(down, across, &rows, band)?;
            }
        }
        Ok(())
    }

    fn chunk(
        &mut self,
        down: u64,
        across: u64,
        rows: &Range<u32>,
        band: &mut Band<'_>,
    ) -> Result<(), DecodeError> {
        let (plan, chunks) = (self.plan, &self.plan.tiff.chunks);
        let index = (down * chunks.across() + across) as usize;
        let place = chunks.places()[index];
        if place.is_absent() {
            for row in rows.clone() {
                self.fill_row(across, rows, row, band);
            }
            return plan.tell(u64::from(rows.end - rows.start));
        }
        let trouble = |trouble: Trouble| {
            trouble.into_error(chunks.name(index), plan.tiff.compression().name())
        };
        let first = chunks.rows_of(down).start;
        self.make_room(chunks.row_bytes() as usize)?;
        self.input.begin(place.offset, place.length);
        for _ in first..rows.start {
            self.input.skip(chunks.row_bytes(), &mut self.row).map_err(trouble)?;
            plan.tell(0)?;
        }
        for row in rows.clone() {
            self.input.fill(&mut self.row).map_err(trouble)?;
            let predictor = plan.tiff.predictor();
            let from = predictor.undo(&mut self.row, &mut self.spare, plan.shape);
            self.write_row(across, rows, row, from, band);
            plan.tell(1)?;
        }
        if u64::from(rows.end - first) == chunks.stored_rows(down) {
            self.input.verify().map_err(trouble)?;
        }
        Ok(())
    }

    fn make_room(&mut self, length: usize) -> Result<(), DecodeError> {
        let more = length.saturating_sub(self.row.len());
        self.row.try_reserve_exact(more).map_err(|_| {
            DecodeError::wrong("memory", format!("no room for {length} bytes"), "enough for a row")
        })?;
        self.row.resize(length, 0);
        Ok(())
    }

    fn write_row(
        &self,
        across: u64,
        rows: &Range<u32>,
        row: u32,
        from: ByteOrder,
        band: &mut Band<'_>,
    ) {
        let shape = self.plan.shape;
        let step = shape.bands * shape.stored.bytes();
        self.places(across, rows, row, band, |column, place| {
            let stored = &self.row[column as usize * step..];
            shape.stored.convert(stored, step, from, place, self.plan.to);
        });
    }

    fn fill_row(&self, across: u64, rows: &Range<u32>, row: u32, band: &mut Band<'_>) {
        let fill = &self.plan.fill;
        self.places(across, rows, row, band, |_, place| {
            for sample in place.chunks_exact_mut(fill.len()) {
                sample.copy_from_slice(fill);
            }
        });
    }

    /// Gives each run of a row's samples in the target, with the column in the chunk of its first.
    fn places(
        &self,
        across: u64,
        rows: &Range<u32>,
        row: u32,
        band: &mut Band<'_>,
        write: impl Fn(u32, &mut [u8]),
    ) {
        let row = if self.plan.south_up { rows.end - 1 - row } else { row - rows.start };
        let columns = self.plan.tiff.chunks.columns_of(across);
        let size = self.plan.fill.len();
        for span in &self.plan.spans {
            let run = overlap(&span.file, &columns);
            if run.is_empty() {
                continue;
            }
            let first = (span.target + run.start - span.file.start) as usize * size;
            let length = (run.end - run.start) as usize * size;
            write(run.start - columns.start, &mut band.row(row)[first..][..length]);
        }
    }
}

fn overlap(one: &Range<u32>, other: &Range<u32>) -> Range<u32> {
    one.start.max(other.start)..one.end.min(other.end)
}
