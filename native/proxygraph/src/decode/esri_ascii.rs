//! Esri ASCII grids.

use super::{Progress, decode_refusal};
use crate::errors::value_error;
use crate::grid::{Grid, GridLayout, sample_name};
use crate::numbers::Whole;
use ::decode::esri_ascii::{self, Corner};
use pyo3::prelude::*;
use std::path::PathBuf;

/// An Esri ASCII grid whose header was read and whose heights were looked at.
#[pyclass(frozen, module = "proxygraph")]
pub struct EsriAscii {
    grid: esri_ascii::EsriAscii,
}

#[pymethods]
impl EsriAscii {
    #[staticmethod]
    #[pyo3(signature = (path, progress=None))]
    fn open(py: Python<'_>, path: PathBuf, progress: Option<&Progress>) -> PyResult<Self> {
        let unseen = Progress::default();
        let progress = progress.unwrap_or(&unseen).shared();
        let grid =
            py.detach(|| esri_ascii::EsriAscii::open(&path, progress)).map_err(decode_refusal)?;
        Ok(Self { grid })
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
        self.grid.range()
    }

    #[getter]
    fn voids(&self) -> u64 {
        self.grid.voids()
    }

    #[getter]
    fn sample(&self) -> &'static str {
        sample_name(self.grid.stored().sample)
    }

    #[getter]
    fn void(&self) -> f64 {
        self.grid.stored().void
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
        let column = first_column.unsigned("first_column").map_err(value_error)?;
        let row = first_row.unsigned("first_row").map_err(value_error)?;
        let unseen = Progress::default();
        let progress = progress.unwrap_or(&unseen).shared();
        let grid = py
            .detach(|| self.grid.decode(layout.plain(), column, row, progress, cache.as_deref()))
            .map_err(decode_refusal)?;
        Ok(Grid::of(grid))
    }
}
