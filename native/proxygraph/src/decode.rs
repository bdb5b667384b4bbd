//! Decoders: what they share.

mod esri_ascii;
mod geotiff;
mod raw_samples;
mod usgs_dem;

pub use esri_ascii::EsriAscii;
pub use geotiff::GeoTiff;
pub use raw_samples::RawSamples;
pub use usgs_dem::UsgsDem;

use crate::errors::{grid_error, os_error, value_error};
use crate::grid::{Grid, GridLayout};
use crate::numbers::Whole;
use pyo3::create_exception;
use pyo3::exceptions::PyException;
use pyo3::prelude::*;
use std::sync::Arc;

create_exception!(
    proxygraph,
    DecodeError,
    crate::errors::GridError,
    "A file cannot be decoded; its arguments are the field, what was found and what was expected."
);
create_exception!(
    proxygraph,
    CancelledError,
    PyException,
    "A long work was asked to end, and did."
);

/// How far a long work has come.
#[pyclass(frozen, module = "proxygraph")]
#[derive(Clone, Default)]
pub struct Progress {
    progress: Arc<decode::Progress>,
}

impl Progress {
    pub fn shared(&self) -> &decode::Progress {
        &self.progress
    }
}

#[pymethods]
impl Progress {
    #[new]
    fn new() -> Self {
        Self::default()
    }

    #[getter]
    fn share(&self) -> f64 {
        self.progress.share()
    }

    #[getter]
    fn cancelled(&self) -> bool {
        self.progress.is_cancelled()
    }

    fn cancel(&self) {
        self.progress.cancel();
    }

    fn step(&self, done: u64, all: u64) -> PyResult<()> {
        self.progress.step(done, all).map_err(decode_refusal)
    }
}

/// Decodes a region of the layout's size without the interpreter; `decode` takes the layout, the region's
/// first column and row, and the progress.
fn decoded(
    py: Python<'_>,
    layout: &GridLayout,
    (first_column, first_row): (Whole, Whole),
    progress: Option<&Progress>,
    decode: impl FnOnce(
        surface::GridLayout,
        u32,
        u32,
        &decode::Progress,
    ) -> Result<surface::Grid, decode::DecodeError>
    + Send,
) -> PyResult<Grid> {
    let column = first_column.unsigned("first_column").map_err(value_error)?;
    let row = first_row.unsigned("first_row").map_err(value_error)?;
    let unseen = Progress::default();
    let (layout, progress) = (layout.plain(), progress.unwrap_or(&unseen).shared());
    let grid = py.detach(|| decode(layout, column, row, progress)).map_err(decode_refusal)?;
    Ok(Grid::of(grid))
}

/// What a decoder says, as the contract's exceptions.
pub fn decode_refusal(error: decode::DecodeError) -> PyErr {
    match error {
        decode::DecodeError::Wrong { field, found, expected } => {
            DecodeError::new_err((field, found, expected))
        }
        decode::DecodeError::File(error) => os_error(error, None),
        decode::DecodeError::Grid(error) => grid_error(error),
        decode::DecodeError::Cancelled => CancelledError::new_err("cancelled"),
    }
}
