//! A take in the making, as Python sees it.

use pyo3::prelude::*;
use std::path::PathBuf;

/// How far a take has come.
#[pyclass(frozen, module = "proxygraph")]
pub struct Recording {
    recording: servo::Recording,
}

impl Recording {
    pub fn new(recording: servo::Recording) -> Self {
        Self { recording }
    }
}

#[pymethods]
impl Recording {
    #[getter]
    fn ticks(&self) -> usize {
        self.recording.ticks
    }

    #[getter]
    fn seconds(&self) -> f64 {
        self.recording.seconds
    }

    #[getter]
    fn dropped(&self) -> u64 {
        self.recording.dropped
    }

    #[getter]
    fn spool(&self) -> Option<PathBuf> {
        self.recording.spool.clone()
    }

    #[getter]
    fn spooled(&self) -> usize {
        self.recording.spooled
    }

    #[getter]
    fn spool_failure(&self) -> Option<&str> {
        self.recording.failure.as_deref()
    }
}
