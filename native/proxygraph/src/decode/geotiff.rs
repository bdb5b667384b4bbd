//! GeoTIFF files.

use super::{Progress, decode_refusal, decoded};
use crate::grid::{Grid, GridLayout, byte_order_name, sample_name};
use crate::numbers::Whole;
use ::decode::geotiff;
use pyo3::prelude::*;
use std::path::PathBuf;

/// A TIFF file whose first directory was read; its samples were not.
#[pyclass(frozen, module = "proxygraph")]
pub struct GeoTiff {
    tiff: geotiff::GeoTiff,
}

#[pymethods]
impl GeoTiff {
    #[staticmethod]
    fn open(py: Python<'_>, path: PathBuf) -> PyResult<Self> {
        let tiff = py.detach(|| geotiff::GeoTiff::open(&path)).map_err(decode_refusal)?;
        Ok(Self { tiff })
    }

    #[getter]
    fn rows(&self) -> u32 {
        self.tiff.rows()
    }

    #[getter]
    fn columns(&self) -> u32 {
        self.tiff.columns()
    }

    #[getter]
    fn bands(&self) -> u16 {
        self.tiff.bands()
    }

    #[getter]
    fn planar(&self) -> bool {
        self.tiff.is_planar()
    }

    #[getter]
    fn stored(&self) -> &'static str {
        self.tiff.stored().name()
    }

    #[getter]
    fn sample(&self) -> &'static str {
        sample_name(self.tiff.stored().decoded())
    }

    #[getter]
    fn byte_order(&self) -> &'static str {
        byte_order_name(self.tiff.byte_order())
    }

    #[getter]
    fn big(&self) -> bool {
        self.tiff.is_big()
    }

    #[getter]
    fn compression(&self) -> &'static str {
        self.tiff.compression().name()
    }

    #[getter]
    fn predictor(&self) -> u8 {
        self.tiff.predictor().code()
    }

    #[getter]
    fn tiled(&self) -> bool {
        self.tiff.is_tiled()
    }

    #[getter]
    fn chunk(&self) -> (u32, u32) {
        self.tiff.chunk_size()
    }

    #[getter]
    fn photometric(&self) -> Option<u16> {
        self.tiff.photometric()
    }

    #[getter]
    fn in_place(&self) -> Option<(u64, u64)> {
        self.tiff.in_place().map(|place| (place.offset, place.row_stride))
    }

    fn numbers(&self, tag: u16) -> PyResult<Option<Vec<f64>>> {
        self.tiff.numbers(tag).map_err(decode_refusal)
    }

    fn text(&self, tag: u16) -> PyResult<Option<String>> {
        self.tiff.text(tag).map_err(decode_refusal)
    }

    #[pyo3(signature = (layout, first_column=Whole(0), first_row=Whole(0), *, south_up=false, fill=0.0,
        progress=None, cache=None),
        text_signature = "(self, layout, first_column=0, first_row=0, *, south_up=False, fill=0.0, \
        progress=None, cache=None)")]
    #[expect(clippy::too_many_arguments, reason = "keyword arguments of the Python contract")]
    fn decode(
        &self,
        py: Python<'_>,
        layout: &GridLayout,
        first_column: Whole,
        first_row: Whole,
        south_up: bool,
        fill: f64,
        progress: Option<&Progress>,
        cache: Option<PathBuf>,
    ) -> PyResult<Grid> {
        decoded(py, layout, (first_column, first_row), progress, |layout, column, row, progress| {
            let window = geotiff::Window { first_column: column, first_row: row, south_up, fill };
            self.tiff.decode(layout, &window, cache.as_deref(), progress)
        })
    }
}
