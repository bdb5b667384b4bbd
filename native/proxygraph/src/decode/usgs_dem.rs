//! USGS digital elevation models as text.

use super::{Progress, decode_refusal, decoded};
use crate::grid::{Grid, GridLayout, sample_name};
use crate::numbers::Whole;
use ::decode::usgs_dem::{self, System, Unit};
use pyo3::prelude::*;
use std::path::PathBuf;

/// A USGS DEM whose header was read and whose heights were looked at.
#[pyclass(frozen, module = "proxygraph")]
pub struct UsgsDem {
    dem: usgs_dem::UsgsDem,
}

#[pymethods]
impl UsgsDem {
    #[staticmethod]
    #[pyo3(signature = (path, progress=None))]
    fn open(py: Python<'_>, path: PathBuf, progress: Option<&Progress>) -> PyResult<Self> {
        let unseen = Progress::default();
        let progress = progress.unwrap_or(&unseen).shared();
        let dem = py.detach(|| usgs_dem::UsgsDem::open(&path, progress)).map_err(decode_refusal)?;
        Ok(Self { dem })
    }

    #[getter]
    fn name(&self) -> &str {
        &self.dem.header().name
    }

    #[getter]
    fn system(&self) -> &'static str {
        match self.dem.header().system {
            System::Geographic => "geographic",
            System::Utm => "UTM",
            System::StatePlane => "state plane",
            System::Other(_) => "other",
        }
    }

    #[getter]
    fn zone(&self) -> i32 {
        self.dem.header().zone
    }

    #[getter]
    fn ground_unit(&self) -> &'static str {
        unit_name(self.dem.header().ground_unit)
    }

    #[getter]
    fn elevation_unit(&self) -> &'static str {
        unit_name(self.dem.header().elevation_unit)
    }

    #[getter]
    fn corners(&self) -> Option<Vec<(f64, f64)>> {
        self.dem.header().corners.map(Vec::from)
    }

    #[getter]
    fn horizontal_datum(&self) -> Option<i32> {
        self.dem.header().horizontal_datum
    }

    #[getter]
    fn vertical_datum(&self) -> Option<i32> {
        self.dem.header().vertical_datum
    }

    #[getter]
    fn step(&self) -> (f64, f64) {
        self.dem.header().step
    }

    #[getter]
    fn rows(&self) -> u32 {
        self.dem.rows()
    }

    #[getter]
    fn columns(&self) -> u32 {
        self.dem.columns()
    }

    #[getter]
    fn first(&self) -> (f64, f64) {
        self.dem.first()
    }

    #[getter]
    fn profiles(&self) -> u32 {
        self.dem.profiles()
    }

    #[getter]
    fn heights(&self) -> u64 {
        self.dem.heights()
    }

    #[getter]
    fn range(&self) -> Option<(f64, f64)> {
        self.dem.range()
    }

    #[getter]
    fn sample(&self) -> &'static str {
        sample_name(self.dem.stored().sample)
    }

    #[getter]
    fn scale(&self) -> f64 {
        self.dem.stored().scale
    }

    #[getter]
    fn value_offset(&self) -> f64 {
        self.dem.stored().value_offset
    }

    #[getter]
    fn void(&self) -> f64 {
        self.dem.stored().void
    }

    #[getter]
    fn notes(&self) -> Vec<String> {
        self.dem.notes().to_vec()
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
            self.dem.decode(layout, column, row, progress, cache.as_deref())
        })
    }
}

fn unit_name(unit: Unit) -> &'static str {
    match unit {
        Unit::Radians => "radian",
        Unit::Feet => "foot",
        Unit::Metres => "metre",
        Unit::ArcSeconds => "arc-second",
    }
}
