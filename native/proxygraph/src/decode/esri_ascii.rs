//! Esri ASCII grids.

use super::{Progress, decode_refusal, decoded};
use crate::grid::{Grid, GridLayout, sample_name};
use crate::numbers::Whole;
use ::decode::esri_ascii::{self, Corner, Heights};
use pyo3::prelude::*;
use std::path::PathBuf;

/// An Esri ASCII grid whose header was read, and its heights where that was asked for.
#[pyclass(frozen, module = "proxygraph")]
pub struct EsriAscii {
    grid: esri_ascii::EsriAscii,
    heights: Option<Heights>,
}

#[pymethods]
impl EsriAscii {
    #[staticmethod]
    #[pyo3(signature = (path, progress=None, *, heights=true))]
    fn open(
        py: Python<'_>,
        path: PathBuf,
        progress: Option<&Progress>,
        heights: bool,
    ) -> PyResult<Self> {
        let unseen = Progress::default();
        let progress = progress.unwrap_or(&unseen).shared();
        py.detach(|| {
            let grid = esri_ascii::EsriAscii::open(&path)?;
            let heights = heights.then(|| grid.heights(progress)).transpose()?;
            Ok(Self { grid, heights })
        })
        .map_err(decode_refusal)
    }

    #[getter]
    fn rows(&self) -> u32 {
        self.grid.header().rows
    }

    #[getter]
    fn columns(&self) -> u32 {
        self.grid.header().columns
    }

    #[getter]
    fn step(&self) -> (f64, f64) {
        self.grid.header().step
    }

    #[getter]
    fn corner(&self) -> (f64, f64) {
        let header = self.grid.header();
        (header.x.0, header.y.0)
    }

    #[getter]
    fn corner_is_center(&self) -> (bool, bool) {
        let header = self.grid.header();
        (header.x.1 == Corner::Center, header.y.1 == Corner::Center)
    }

    #[getter]
    fn nodata(&self) -> f64 {
        self.grid.header().nodata
    }

    #[getter]
    fn range(&self) -> Option<(f64, f64)> {
        self.heights?.range
    }

    #[getter]
    fn voids(&self) -> Option<u64> {
        Some(self.heights?.voids)
    }

    #[getter]
    fn sample(&self) -> Option<&'static str> {
        Some(sample_name(self.heights?.stored.sample))
    }

    #[getter]
    fn void(&self) -> Option<f64> {
        Some(self.heights?.stored.void)
    }

    #[pyo3(signature = (layout, first_column=Whole(0), first_row=Whole(0), *, progress=None, cache=None),
        text_signature = "(self, layout, first_column=0, first_row=0, *, progress=None, cache=None)")]
    fn decode(
        &self,
        py: Python<'_>,
        layout: &GridLayout,
        first_column: Whole,
        first_row: Whole,
        progress: Option<&Progress>,
        cache: Option<PathBuf>,
    ) -> PyResult<Grid> {
        decoded(py, layout, (first_column, first_row), progress, |layout, column, row, progress| {
            self.grid.decode(layout, column, row, progress, cache.as_deref())
        })
    }
}
