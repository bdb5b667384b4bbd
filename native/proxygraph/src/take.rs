//! Takes as Python sees them: by column.

use crate::columns::{self, Column};
use crate::errors::{os_error, value_error};
use pyo3::create_exception;
use pyo3::prelude::*;
use pyo3::types::PyTuple;
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use takes::{ReadError, Reason, Spool, Tick, WriteError};

create_exception!(
    proxygraph,
    TakeError,
    pyo3::exceptions::PyValueError,
    "A file cannot be read as a take; the text says what was found and expected."
);

create_exception!(
    proxygraph,
    TakeInUseError,
    TakeError,
    "A take's file is being written, or was claimed, by a program that runs."
);

const COLUMNS: [Column<Tick>; 27] = [
    ("tick", |tick| tick.number as f64),
    ("time", |tick| tick.time),
    ("hand_x", |tick| tick.hand[0]),
    ("hand_y", |tick| tick.hand[1]),
    ("hand_z", |tick| tick.hand[2]),
    ("goal_east", |tick| tick.goal[0]),
    ("goal_north", |tick| tick.goal[1]),
    ("goal_up", |tick| tick.goal[2]),
    ("proxy_east", |tick| tick.proxy[0]),
    ("proxy_north", |tick| tick.proxy[1]),
    ("proxy_up", |tick| tick.proxy[2]),
    ("force_x", |tick| tick.force[0]),
    ("force_y", |tick| tick.force[1]),
    ("force_z", |tick| tick.force[2]),
    ("feature", |tick| f64::from(tick.feature)),
    ("mode", |tick| f64::from(tick.mode)),
    ("window_east", |tick| tick.window[0]),
    ("window_north", |tick| tick.window[1]),
    ("window_up", |tick| tick.window[2]),
    ("window_width", |tick| tick.window[3]),
    ("window_exaggeration", |tick| tick.window[4]),
    ("window_turn", |tick| tick.window[5]),
    ("normal_x", |tick| f64::from(tick.normal[0])),
    ("normal_y", |tick| f64::from(tick.normal[1])),
    ("normal_z", |tick| f64::from(tick.normal[2])),
    ("buttons", |tick| f64::from(tick.buttons)),
    ("twist", |tick| tick.twist),
];

/// Recorded touch.
#[pyclass(frozen, module = "proxygraph")]
pub struct Take {
    take: takes::Take,
    finished: bool,
    lost: Option<String>,
    /// Its file, which is nobody else's meanwhile.
    spool: Mutex<Option<Spool>>,
    /// Why its file is not whole.
    spool_failure: Option<String>,
}

impl Take {
    /// What a session has recorded so far.
    pub fn so_far(take: takes::Take) -> Self {
        Self { take, finished: false, lost: None, spool: Mutex::new(None), spool_failure: None }
    }

    /// What a session has recorded.
    pub fn recorded(recorded: servo::Recorded) -> Self {
        let servo::Recorded { take, spool, failure } = recorded;
        let spool = Mutex::new(spool);
        Self { take, finished: true, lost: None, spool, spool_failure: failure }
    }

    fn saved(saved: takes::Saved, spool: Option<Spool>) -> Self {
        let takes::Saved { take, finished, lost } = saved;
        let lost = lost.map(|loss| loss.to_string());
        Self { take, finished, lost, spool: Mutex::new(spool), spool_failure: None }
    }

    fn take_spool(&self) -> Option<Spool> {
        self.spool.lock().unwrap_or_else(|poisoned| poisoned.into_inner()).take()
    }

    pub fn native(&self) -> &takes::Take {
        &self.take
    }
}

#[pymethods]
impl Take {
    #[classattr]
    fn columns(py: Python<'_>) -> PyResult<Py<PyTuple>> {
        columns::names(py, &COLUMNS)
    }

    fn __len__(&self) -> usize {
        self.take.ticks.len()
    }

    fn column<'py>(&self, py: Python<'py>, name: &str) -> PyResult<Bound<'py, PyAny>> {
        columns::column(py, "Take", &COLUMNS, self.take.ticks.iter(), name)
    }

    #[getter]
    fn seconds(&self) -> f64 {
        self.take.seconds()
    }

    #[getter]
    fn about(&self) -> &str {
        &self.take.header.about
    }

    #[getter]
    fn workspace(&self) -> (f64, f64, f64) {
        self.take.header.workspace.into()
    }

    #[getter]
    fn pre_roll(&self) -> u64 {
        self.take.header.pre_roll
    }

    #[getter]
    fn dropped(&self) -> u64 {
        self.take.dropped
    }

    #[getter]
    fn finished(&self) -> bool {
        self.finished
    }

    #[getter]
    fn lost(&self) -> Option<&str> {
        self.lost.as_deref()
    }

    #[getter]
    fn spool_failure(&self) -> Option<&str> {
        self.spool_failure.as_deref()
    }

    fn save(&self, py: Python<'_>, path: PathBuf) -> PyResult<()> {
        let written = py.detach(|| takes::write(&path, &self.take));
        written.map_err(|error| write_refusal(error, &path))
    }

    fn release_spool(&self) {
        drop(self.take_spool());
    }

    fn discard_spool(&self) -> PyResult<()> {
        let Some(spool) = self.take_spool() else { return Ok(()) };
        let path = spool.path().to_owned();
        spool.remove().map_err(|error| os_error(error, Some(&path)))
    }
}

/// Reads a take's file as far as it is whole.
#[pyfunction]
pub fn read_take(py: Python<'_>, path: PathBuf) -> PyResult<Take> {
    let saved = py.detach(|| takes::read(&path)).map_err(read_refusal)?;
    Ok(Take::saved(saved, None))
}

/// Reads a take's file that nobody writes any more, and has it alone.
#[pyfunction]
pub fn claim_take(py: Python<'_>, path: PathBuf) -> PyResult<Take> {
    let (saved, spool) = py.detach(|| takes::claim(&path)).map_err(read_refusal)?;
    Ok(Take::saved(saved, Some(spool)))
}

fn read_refusal(error: ReadError) -> PyErr {
    let text = error.to_string();
    match error.reason {
        Reason::System(system) => os_error(system, Some(&error.path)),
        Reason::InUse => TakeInUseError::new_err(text),
        _ => TakeError::new_err(text),
    }
}

/// What is said of a file that cannot be written.
pub fn write_refusal(error: WriteError, path: &Path) -> PyErr {
    match error {
        WriteError::System(error) => os_error(error, Some(path)),
        about @ WriteError::About(_) => value_error(about),
    }
}
