//! Where the samples of a grid lie, and what they mean.

use crate::point::GridPoint;
use crate::sample::{ByteOrder, SampleType};

/// Rows or columns that a grid may have at the most: cell numbers then stay far inside `i64`, and
/// byte offsets inside `usize`, whatever is added to them.
const MOST_LINES: u64 = 1 << 31;

/// A layout that no grid can have; the text names the field, what was found and what was expected.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum LayoutError {
    /// Fewer than two rows or columns, or more than 2^31.
    #[error("{field} is {found}; a surface needs from 2 to 2147483648")]
    Size {
        /// `rows` or `columns`.
        field: &'static str,
        /// What was given.
        found: u64,
    },
    /// A length that is not a positive finite number.
    #[error("{field} is {found}; expected a positive number of metres")]
    Length {
        /// `cell_width` or `cell_height`.
        field: &'static str,
        /// What was given.
        found: f64,
    },
    /// A conversion to metres that is not finite, or a scale of zero.
    #[error("{field} is {found}; expected a finite number{}", if *.field == "scale" { " other than 0" } else { "" })]
    Conversion {
        /// `scale` or `value_offset`.
        field: &'static str,
        /// What was given.
        found: f64,
    },
    /// Rows that overlap.
    #[error("row_stride is {found} bytes; a row of {columns} samples takes {expected}")]
    RowStride {
        /// What was given, bytes.
        found: u64,
        /// Bytes that a row takes.
        expected: u64,
        /// Samples in a row.
        columns: u32,
    },
    /// More bytes than an address can name.
    #[error("the grid would end after {found} bytes, which no address of this machine can reach")]
    TooLarge {
        /// Bytes, `offset` included.
        found: u128,
    },
}

/// A row-major grid of samples at a fixed offset and stride. Sample (0, 0) is the first in the file;
/// columns run east, rows run south.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GridLayout {
    rows: u32,
    columns: u32,
    cell_width: f64,
    cell_height: f64,
    sample: SampleType,
    byte_order: ByteOrder,
    offset: u64,
    row_stride: u64,
    scale: f64,
    value_offset: f64,
    void: Option<f64>,
    wraps: bool,
}

impl GridLayout {
    /// Packed rows from byte 0, elevation = sample in metres, no void value, no wrap.
    ///
    /// `cell_width` and `cell_height` are metres between neighbouring columns and rows.
    pub fn packed(
        rows: u64,
        columns: u64,
        cell_width: f64,
        cell_height: f64,
        sample: SampleType,
        byte_order: ByteOrder,
    ) -> Result<Self, LayoutError> {
        let layout = Self {
            rows: checked_lines("rows", rows)?,
            columns: checked_lines("columns", columns)?,
            cell_width: checked_length("cell_width", cell_width)?,
            cell_height: checked_length("cell_height", cell_height)?,
            sample,
            byte_order,
            offset: 0,
            row_stride: columns * sample.bytes() as u64,
            scale: 1.0,
            value_offset: 0.0,
            void: None,
            wraps: false,
        };
        layout.checked()
    }

    /// The same with the first sample at this byte.
    pub fn with_offset(self, offset: u64) -> Result<Self, LayoutError> {
        Self { offset, ..self }.checked()
    }

    /// The same with this many bytes from one row to the next.
    pub fn with_row_stride(self, row_stride: u64) -> Result<Self, LayoutError> {
        Self { row_stride, ..self }.checked()
    }

    /// The same with elevation (metres) = sample x `scale` + `value_offset`.
    pub fn with_values(self, scale: f64, value_offset: f64) -> Result<Self, LayoutError> {
        if !scale.is_finite() || scale == 0.0 {
            return Err(LayoutError::Conversion { field: "scale", found: scale });
        }
        if !value_offset.is_finite() {
            return Err(LayoutError::Conversion { field: "value_offset", found: value_offset });
        }
        Ok(Self { scale, value_offset, ..self })
    }

    /// The same with this sample value meaning "no data".
    pub fn with_void(self, void: Option<f64>) -> Self {
        Self { void, ..self }
    }

    /// The same with column `columns` being column 0 again, or not.
    pub fn with_wrap(self, wraps: bool) -> Self {
        Self { wraps, ..self }
    }

    /// Number of samples from north to south.
    pub fn rows(&self) -> u32 {
        self.rows
    }

    /// Number of samples from west to east.
    pub fn columns(&self) -> u32 {
        self.columns
    }

    /// Metres from one column to the next.
    pub fn cell_width(&self) -> f64 {
        self.cell_width
    }

    /// Metres from one row to the next.
    pub fn cell_height(&self) -> f64 {
        self.cell_height
    }

    /// The type of one sample.
    pub fn sample(&self) -> SampleType {
        self.sample
    }

    /// The byte order of one sample.
    pub fn byte_order(&self) -> ByteOrder {
        self.byte_order
    }

    /// Bytes before sample (0, 0).
    pub fn offset(&self) -> u64 {
        self.offset
    }

    /// Bytes from one row to the next.
    pub fn row_stride(&self) -> u64 {
        self.row_stride
    }

    /// Metres for a unit of the sample.
    pub fn scale(&self) -> f64 {
        self.scale
    }

    /// Metres at sample value 0.
    pub fn value_offset(&self) -> f64 {
        self.value_offset
    }

    /// The sample value that means "no data".
    pub fn void(&self) -> Option<f64> {
        self.void
    }

    /// Whether the eastern neighbour of the last column is the first.
    pub fn wraps(&self) -> bool {
        self.wraps
    }

    /// Number of samples.
    pub fn samples(&self) -> u64 {
        u64::from(self.rows) * u64::from(self.columns)
    }

    /// Number of triangles, those with a void corner included.
    pub fn triangles(&self) -> u64 {
        let cell_columns = u64::from(self.columns) - u64::from(!self.wraps);
        2 * cell_columns * (u64::from(self.rows) - 1)
    }

    /// Bytes that a file or buffer must hold at the least.
    pub fn byte_length(&self) -> u64 {
        let last_row = u64::from(self.rows - 1) * self.row_stride;
        self.offset + last_row + self.row_bytes()
    }

    /// The grid point at a place in the terrain frame: metres east and north of sample (0, 0), and
    /// metres of elevation.
    pub fn grid_point(&self, [east, north, up]: [f64; 3]) -> GridPoint {
        GridPoint::new(east / self.cell_width, -north / self.cell_height, up)
    }

    /// A grid point's place in the terrain frame, metres east, north and up.
    pub fn terrain_place(&self, point: &GridPoint) -> [f64; 3] {
        let east = point.columns() * self.cell_width;
        // Subtracted from zero: row 0 is at 0 m north, not at -0.
        [east, 0.0 - point.rows() * self.cell_height, point.elevation]
    }

    fn row_bytes(&self) -> u64 {
        u64::from(self.columns) * self.sample.bytes() as u64
    }

    fn checked(self) -> Result<Self, LayoutError> {
        if self.row_stride < self.row_bytes() {
            return Err(LayoutError::RowStride {
                found: self.row_stride,
                expected: self.row_bytes(),
                columns: self.columns,
            });
        }
        let end = u128::from(self.offset)
            + u128::from(self.rows - 1) * u128::from(self.row_stride)
            + u128::from(self.row_bytes());
        if end > isize::MAX as u128 {
            return Err(LayoutError::TooLarge { found: end });
        }
        Ok(self)
    }
}

fn checked_lines(field: &'static str, found: u64) -> Result<u32, LayoutError> {
    if (2..=MOST_LINES).contains(&found) {
        Ok(found as u32)
    } else {
        Err(LayoutError::Size { field, found })
    }
}

fn checked_length(field: &'static str, found: f64) -> Result<f64, LayoutError> {
    if found.is_finite() && found > 0.0 {
        Ok(found)
    } else {
        Err(LayoutError::Length { field, found })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn mars() -> GridLayout {
        GridLayout::packed(720, 1440, 14818.0, 14818.0, SampleType::I16, ByteOrder::Big).unwrap()
    }

    #[test]
    fn whole_planet_has_a_column_of_cells_more() {
        assert_eq!(mars().samples(), 1_036_800);
        assert_eq!(mars().triangles(), 2 * 1439 * 719);
        assert_eq!(mars().with_wrap(true).triangles(), 2_070_720);
    }

    #[test]
    fn byte_length_counts_offset_and_stride_but_no_padding_after_the_last_row() {
        let layout = mars().with_row_stride(3000).unwrap().with_offset(2880).unwrap();
        assert_eq!(layout.byte_length(), 2880 + 719 * 3000 + 2880);
    }

    #[test]
    fn errors_name_the_field_and_what_was_found() {
        let one_row = GridLayout::packed(1, 9, 1.0, 1.0, SampleType::I16, ByteOrder::Big);
        assert!(one_row.unwrap_err().to_string().starts_with("rows is 1;"));
        let flat = GridLayout::packed(2, 2, 1.0, f64::NAN, SampleType::I16, ByteOrder::Big);
        assert!(flat.unwrap_err().to_string().starts_with("cell_height is NaN;"));
        assert!(mars().with_row_stride(2879).unwrap_err().to_string().contains("takes 2880"));
        assert!(mars().with_values(0.0, 0.0).unwrap_err().to_string().contains("other than 0"));
        assert!(mars().with_offset(u64::MAX).is_err());
        assert!(mars().with_row_stride(u64::MAX).is_err());
    }
}
