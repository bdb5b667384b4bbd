//! Decoding a window of the raster: only the chunks that it needs, row by row.

use super::GeoTiff;
use super::codec::Codec;
use super::input::Input;
use super::predictor::RowShape;
use crate::error::DecodeError;
use crate::progress::Progress;
use crate::target::Target;
use std::ops::Range;
use std::path::Path;
use surface::{ByteOrder, Grid, GridLayout};

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

/// Columns of the file, and the column of the target that the first of them becomes.
struct Span {
    file: Range<u32>,
    target: u32,
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
        Work::new(self, &layout, window, progress).run(&mut target)?;
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

/// One decoding.
struct Work<'a> {
    tiff: &'a GeoTiff,
    progress: &'a Progress,
    south_up: bool,
    rows: Range<u32>,
    spans: Vec<Span>,
    shape: RowShape,
    fill: Vec<u8>,
    to: ByteOrder,
    input: Input<'a>,
    row: Vec<u8>,
    spare: Vec<u8>,
    done: u64,
    all: u64,
}

impl<'a> Work<'a> {
    fn new(
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
        let mut work = Self {
            tiff,
            progress,
            south_up: window.south_up,
            rows,
            spans,
            shape,
            fill: tiff.stored().decoded_value(window.fill, layout.byte_order()),
            to: layout.byte_order(),
            input: Input::new(&tiff.source, Codec::of(tiff.compression())),
            row: Vec::new(),
            spare: Vec::new(),
            done: 0,
            all: 0,
        };
        let across = (0..tiff.chunks.across()).filter(|&across| work.needs(across)).count();
        work.all = across as u64 * u64::from(layout.rows());
        work
    }

    fn run(&mut self, target: &mut Target) -> Result<(), DecodeError> {
        let chunk_rows = self.tiff.chunks.size().1;
        let last = (self.rows.end - 1) / chunk_rows;
        for down in u64::from(self.rows.start / chunk_rows)..=u64::from(last) {
            for across in 0..self.tiff.chunks.across() {
                if self.needs(across) {
                    self.chunk(down, across, target)?;
                }
            }
        }
        self.progress.step(self.all, self.all)
    }

    fn needs(&self, across: u64) -> bool {
        let columns = self.tiff.chunks.columns_of(across);
        self.spans.iter().any(|span| !overlap(&span.file, &columns).is_empty())
    }

    fn chunk(&mut self, down: u64, across: u64, target: &mut Target) -> Result<(), DecodeError> {
        let chunks = &self.tiff.chunks;
        let index = (down * chunks.across() + across) as usize;
        let held = chunks.rows_of(down);
        let wanted = overlap(&self.rows, &held);
        let place = chunks.places()[index];
        if place.is_absent() {
            for row in wanted {
                self.fill_row(across, row, target);
                self.tell()?;
            }
            return Ok(());
        }
        let trouble = |trouble: super::input::Trouble| {
            trouble.into_error(chunks.name(index), self.tiff.compression().name())
        };
        let row_bytes = chunks.row_bytes() as usize;
        self.input.begin(place.offset, place.length);
        let no_room = |_| {
            DecodeError::wrong(
                "memory",
                format!("no room for {row_bytes} bytes"),
                "enough for a row",
            )
        };
        self.row.try_reserve_exact(row_bytes.saturating_sub(self.row.len())).map_err(no_room)?;
        self.row.resize(row_bytes, 0);
        for _ in held.start..wanted.start {
            self.input.skip(row_bytes as u64, &mut self.row).map_err(trouble)?;
            self.progress.step(self.done, self.all)?;
        }
        for row in wanted.clone() {
            self.input.fill(&mut self.row).map_err(trouble)?;
            let predictor = self.tiff.predictor();
            let from = predictor.undo(&mut self.row, &mut self.spare, self.shape);
            self.write_row(across, row, from, target);
            self.tell()?;
        }
        let was_all = u64::from(wanted.end - held.start) == chunks.stored_rows(down);
        if was_all {
            self.input.verify().map_err(trouble)?;
        }
        Ok(())
    }

    fn tell(&mut self) -> Result<(), DecodeError> {
        self.done += 1;
        self.progress.step(self.done, self.all)
    }

    fn write_row(&self, across: u64, row: u32, from: ByteOrder, target: &mut Target) {
        let step = self.shape.bands * self.shape.stored.bytes();
        self.places(across, row, target, |stored_from, place| {
            let stored = &self.row[stored_from as usize * step..];
            self.shape.stored.convert(stored, step, from, place, self.to);
        });
    }

    fn fill_row(&self, across: u64, row: u32, target: &mut Target) {
        self.places(across, row, target, |_, place| {
            for sample in place.chunks_exact_mut(self.fill.len()) {
                sample.copy_from_slice(&self.fill);
            }
        });
    }

    /// Gives each run of a row's samples in the target, with the column in the chunk of its first.
    fn places(&self, across: u64, row: u32, target: &mut Target, write: impl Fn(u32, &mut [u8])) {
        let row = if self.south_up { self.rows.end - 1 - row } else { row - self.rows.start };
        let columns = self.tiff.chunks.columns_of(across);
        let size = self.fill.len();
        for span in &self.spans {
            let run = overlap(&span.file, &columns);
            if run.is_empty() {
                continue;
            }
            let first = (span.target + run.start - span.file.start) as usize * size;
            let length = (run.end - run.start) as usize * size;
            write(run.start - columns.start, &mut target.row(row)[first..][..length]);
        }
    }
}

fn overlap(one: &Range<u32>, other: &Range<u32>) -> Range<u32> {
    one.start.max(other.start)..one.end.min(other.end)
}
