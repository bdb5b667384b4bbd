//! Copies out of raw samples that cannot be used where they lie.

use super::{Progress, decoded};
use crate::errors::value_error;
use crate::grid::{Grid, GridLayout, byte_order_named};
use crate::numbers::Whole;
use ::decode::RawSample;
use pyo3::prelude::*;
use std::path::PathBuf;

/// Where the samples of one band lie in a file.
#[pyclass(frozen, module = "proxygraph")]
pub struct RawSamples {
    samples: ::decode::RawSamples,
}

const TYPES: [(&str, RawSample); 10] = [
    ("i8", RawSample::I8),
    ("u8", RawSample::U8),
    ("i16", RawSample::I16),
    ("u16", RawSample::U16),
    ("i32", RawSample::I32),
    ("u32", RawSample::U32),
    ("i64", RawSample::I64),
    ("u64", RawSample::U64),
    ("f32", RawSample::F32),
    ("f64", RawSample::F64),
];

#[pymethods]
impl RawSamples {
    #[new]
    #[pyo3(signature = (rows, columns, *, sample, byte_order, offset, pixel_stride, row_stride,
        south_first=false, wraps=false))]
    #[expect(clippy::too_many_arguments, reason = "keyword arguments of the Python contract")]
    fn new(
        rows: Whole,
        columns: Whole,
        sample: &str,
        byte_order: &str,
        offset: Whole,
        pixel_stride: Whole,
        row_stride: Whole,
        south_first: bool,
        wraps: bool,
    ) -> PyResult<Self> {
        let found = TYPES.iter().find(|(name, _)| *name == sample);
        let (_, sample) = found.ok_or_else(|| {
            let names: Vec<_> = TYPES.iter().map(|(name, _)| *name).collect();
            value_error(format!("sample is '{sample}'; expected one of {}", names.join(", ")))
        })?;
        let samples = ::decode::RawSamples {
            rows: rows.unsigned("rows").map_err(value_error)?,
            columns: columns.unsigned("columns").map_err(value_error)?,
            sample: *sample,
            byte_order: byte_order_named(byte_order)?,
            offset: offset.unsigned("offset").map_err(value_error)?,
            pixel_stride: pixel_stride.unsigned("pixel_stride").map_err(value_error)?,
            row_stride: row_stride.unsigned("row_stride").map_err(value_error)?,
            south_first,
            wraps,
        };
        Ok(Self { samples })
    }

    #[pyo3(signature = (path, layout, first_column=Whole(0), first_row=Whole(0), *, progress=None,
        cache=None),
        text_signature = "(self, path, layout, first_column=0, first_row=0, *, progress=None, \
        cache=None)")]
    #[expect(clippy::too_many_arguments, reason = "keyword arguments of the Python contract")]
    fn decode(
        &self,
        py: Python<'_>,
        path: PathBuf,
        layout: &GridLayout,
        first_column: Whole,
        first_row: Whole,
        progress: Option<&Progress>,
        cache: Option<PathBuf>,
    ) -> PyResult<Grid> {
        decoded(py, layout, (first_column, first_row), progress, |layout, column, row, progress| {
            self.samples.decode(&path, layout, column, row, progress, cache.as_deref())
        })
    }
}
