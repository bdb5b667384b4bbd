//! Copies out of raw samples that cannot be used where they lie: a type or an order that touch does not
//! know, one band among others, rows from south to north, a region across the seam of a whole planet.

use crate::error::DecodeError;
use crate::pen::Pen;
use crate::progress::Progress;
use crate::source::Source;
use crate::target::Target;
use std::path::Path;
use surface::{ByteOrder, Grid, GridLayout, SampleType};

/// A number in a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RawSample {
    /// Signed 8 bit.
    I8,
    /// Unsigned 8 bit.
    U8,
    /// Signed 16 bit.
    I16,
    /// Unsigned 16 bit.
    U16,
    /// Signed 32 bit.
    I32,
    /// Unsigned 32 bit.
    U32,
    /// Signed 64 bit.
    I64,
    /// Unsigned 64 bit.
    U64,
    /// Single precision.
    F32,
    /// Double precision.
    F64,
}

impl RawSample {
    /// Size of one.
    pub fn bytes(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::I32 | Self::U32 | Self::F32 => 4,
            Self::I64 | Self::U64 | Self::F64 => 8,
        }
    }

    /// What it becomes: the smallest type that loses nothing (whole numbers beyond 2^53 are rounded).
    pub fn decoded(self) -> SampleType {
        match self {
            Self::I8 | Self::U8 | Self::I16 => SampleType::I16,
            Self::U16 => SampleType::U16,
            Self::I32 => SampleType::I32,
            Self::F32 => SampleType::F32,
            Self::U32 | Self::I64 | Self::U64 | Self::F64 => SampleType::F64,
        }
    }

    /// Reads one; `bytes` are as many as it has.
    fn read(self, bytes: &[u8], order: ByteOrder) -> f64 {
        let mut most_first = [0; 8];
        let most_first = &mut most_first[..bytes.len()];
        most_first.copy_from_slice(bytes);
        if order == ByteOrder::Little {
            most_first.reverse();
        }
        let unsigned = most_first.iter().fold(0, |all, byte| all << 8 | u64::from(*byte));
        match self {
            Self::I8 => f64::from(unsigned as i8),
            Self::I16 => f64::from(unsigned as i16),
            Self::I32 => f64::from(unsigned as i32),
            Self::I64 => unsigned as i64 as f64,
            Self::U8 | Self::U16 | Self::U32 | Self::U64 => unsigned as f64,
            Self::F32 => f64::from(f32::from_bits(unsigned as u32)),
            Self::F64 => f64::from_bits(unsigned),
        }
    }
}

/// Where the samples of one band lie in a file.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RawSamples {
    /// Rows, at least 1.
    pub rows: u32,
    /// Columns, at least 1.
    pub columns: u32,
    /// Type of one.
    pub sample: RawSample,
    /// Byte order of one.
    pub byte_order: ByteOrder,
    /// Bytes before the first.
    pub offset: u64,
    /// Bytes from one column to the next.
    pub pixel_stride: u64,
    /// Bytes from one row to the next.
    pub row_stride: u64,
    /// Whether the file's first row is the southernmost.
    pub south_first: bool,
    /// Whether column `columns` is column 0 again.
    pub wraps: bool,
}

impl RawSamples {
    /// Copies a region of a file: `layout` has its size, in the sample type that this one becomes.
    ///
    /// Only the region's own rows and columns are read.
    pub fn decode(
        &self,
        path: &Path,
        layout: GridLayout,
        first_column: u32,
        first_row: u32,
        progress: &Progress,
        cache: Option<&Path>,
    ) -> Result<Grid, DecodeError> {
        let source = Source::open(path)?;
        self.check(source.length())?;
        self.check_region(&layout, first_column, first_row)?;
        let mut target = Target::new(layout, cache)?;
        let copy = Copy::new(self, &layout);
        let mut bytes = Vec::new();
        for row in 0..layout.rows() {
            progress.step(row.into(), layout.rows().into())?;
            let (mut done, mut column) = (0, first_column % self.columns);
            while done < layout.columns() {
                let count = (layout.columns() - done).min(self.columns - column).min(copy.at_once);
                let length = u64::from(count - 1) * self.pixel_stride + self.sample.bytes() as u64;
                bytes.resize(length as usize, 0);
                source.fill(&mut bytes, self.place(column, first_row + row))?;
                copy.samples(&bytes, target.row(row), done as usize, count as usize);
                done += count;
                column = (column + count) % self.columns;
            }
        }
        progress.step(1, 1)?;
        target.finish()
    }

    /// Where a sample lies in the file.
    fn place(&self, column: u32, row: u32) -> u64 {
        let row = if self.south_first { self.rows - 1 - row } else { row };
        self.offset + u64::from(row) * self.row_stride + u64::from(column) * self.pixel_stride
    }

    /// Refuses what overlaps, and what the file does not have.
    fn check(&self, found: u64) -> Result<(), DecodeError> {
        let size = self.sample.bytes() as u64;
        if self.rows == 0 || self.columns == 0 {
            let found = format!("{} x {}", self.columns, self.rows);
            return Err(DecodeError::wrong("columns and rows", found, "at least 1 of each"));
        }
        if self.pixel_stride < size {
            let expected = format!("at least {size} for a sample");
            return Err(DecodeError::wrong("pixel_stride", self.pixel_stride, expected));
        }
        let across =
            u128::from(self.columns - 1) * u128::from(self.pixel_stride) + u128::from(size);
        if u128::from(self.row_stride) < across {
            let expected = format!("at least {across} for {} samples", self.columns);
            return Err(DecodeError::wrong("row_stride", self.row_stride, expected));
        }
        let down = u128::from(self.rows - 1) * u128::from(self.row_stride);
        let expected = u128::from(self.offset) + down + across;
        if u128::from(found) < expected {
            let expected = format!("{expected} bytes for {} x {}", self.columns, self.rows);
            return Err(DecodeError::wrong("length", format!("{found} bytes"), expected));
        }
        Ok(())
    }

    fn check_region(
        &self,
        layout: &GridLayout,
        first_column: u32,
        first_row: u32,
    ) -> Result<(), DecodeError> {
        if layout.sample() != self.sample.decoded() {
            return Err(DecodeError::wrong(
                "sample type",
                format!("{:?} from {:?}", layout.sample(), self.sample),
                format!("{:?}", self.sample.decoded()),
            ));
        }
        let (columns, rows) = (u64::from(self.columns), u64::from(self.rows));
        let behind = u64::from(first_column) + u64::from(layout.columns());
        let fits_across =
            u64::from(layout.columns()) <= columns && (self.wraps || behind <= columns);
        if fits_across && u64::from(first_row) + u64::from(layout.rows()) <= rows {
            return Ok(());
        }
        Err(DecodeError::wrong(
            "region",
            format!(
                "{} columns from {first_column} and {} rows from {first_row}",
                layout.columns(),
                layout.rows()
            ),
            format!("a region of {columns} x {rows} samples"),
        ))
    }
}

/// Bytes that are read at a time, at the most, unless one sample takes more.
const PIECE: u64 = 1 << 20;

/// How samples get from the file's bytes into a row.
struct Copy {
    sample: RawSample,
    order: ByteOrder,
    pixel_stride: usize,
    pen: Pen,
    /// Columns that one read takes at the most.
    at_once: u32,
    how: How,
}

#[derive(Clone, Copy, PartialEq)]
enum How {
    /// The bytes as they are.
    Same,
    /// The bytes of each in the other order.
    Turned,
    /// The numbers.
    Numbers,
}

impl Copy {
    fn new(samples: &RawSamples, layout: &GridLayout) -> Self {
        let is_same = samples.sample.bytes() == layout.sample().bytes()
            && !matches!(samples.sample, RawSample::I64 | RawSample::U64);
        Self {
            sample: samples.sample,
            order: samples.byte_order,
            // Strides beyond what a machine can address belong to samples that stand alone.
            pixel_stride: usize::try_from(samples.pixel_stride).unwrap_or(usize::MAX),
            pen: Pen::of(layout),
            at_once: (PIECE / samples.pixel_stride).clamp(1, u64::from(u32::MAX)) as u32,
            how: match is_same {
                true if samples.byte_order == layout.byte_order() => How::Same,
                true => How::Turned,
                false => How::Numbers,
            },
        }
    }

    /// Copies `count` samples to `first` and on in a row.
    fn samples(&self, bytes: &[u8], row: &mut [u8], first: usize, count: usize) {
        let (size, into) = (self.sample.bytes(), self.pen.bytes());
        let places = &mut row[first * into..(first + count) * into];
        match self.how {
            How::Same if self.pixel_stride == size => places.copy_from_slice(bytes),
            How::Numbers => {
                for (index, pixel) in bytes.chunks(self.pixel_stride).enumerate() {
                    self.pen.put(places, index, self.sample.read(&pixel[..size], self.order));
                }
            }
            How::Same | How::Turned => {
                let pixels = bytes.chunks(self.pixel_stride);
                for (place, pixel) in places.chunks_exact_mut(into).zip(pixels) {
                    place.copy_from_slice(&pixel[..size]);
                    if self.how == How::Turned {
                        place.reverse();
                    }
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_type_reads_its_extremes_in_both_orders() {
        let cases: [(RawSample, &[u8], f64); 12] = [
            (RawSample::I8, &[0x80], -128.0),
            (RawSample::U8, &[0xff], 255.0),
            (RawSample::I16, &[0x80, 0x00], -32768.0),
            (RawSample::U16, &[0xff, 0xfe], 65534.0),
            (RawSample::I32, &[0x80, 0, 0, 0], -2_147_483_648.0),
            (RawSample::U32, &[0xff; 4], 4_294_967_295.0),
            (RawSample::I64, &[0xff; 8], -1.0),
            (RawSample::U64, &[0, 0, 0, 1, 0, 0, 0, 0], 4_294_967_296.0),
            (RawSample::F32, &[0x3f, 0xc0, 0, 0], 1.5),
            (RawSample::F64, &[0x3f, 0xf8, 0, 0, 0, 0, 0, 0], 1.5),
            (RawSample::I16, &[0x00, 0x7f], 127.0),
            (RawSample::I32, &[0, 0, 1, 0], 256.0),
        ];
        for (sample, bytes, number) in cases {
            assert_eq!(bytes.len(), sample.bytes());
            assert_eq!(sample.read(bytes, ByteOrder::Big), number);
            let turned: Vec<u8> = bytes.iter().rev().copied().collect();
            assert_eq!(sample.read(&turned, ByteOrder::Little), number);
        }
    }
}
