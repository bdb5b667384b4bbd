//! Every tick of a session, by column.

use crate::columns::{self, Column};
use contact::Feature;
use pyo3::prelude::*;
use pyo3::types::PyTuple;
use servo::{Mode, TickRecord};

const COLUMNS: [Column<TickRecord>; 31] = [
    ("tick", |tick| tick.tick as f64),
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
    ("feature", |tick| feature_number(tick.feature)),
    ("vertices", |tick| f64::from(tick.vertices)),
    ("faces", |tick| f64::from(tick.faces)),
    ("collision_tests", |tick| f64::from(tick.collision_tests)),
    ("cells", |tick| f64::from(tick.cells)),
    ("mode", |tick| mode_number(tick.mode)),
    ("window_east", |tick| tick.window.east()),
    ("window_north", |tick| tick.window.north()),
    ("window_up", |tick| tick.window.up()),
    ("window_width", |tick| tick.window.width()),
    ("window_exaggeration", |tick| tick.window.exaggeration()),
    ("window_turn", |tick| tick.window.turn()),
    ("normal_x", |tick| tick.normal[0]),
    ("normal_y", |tick| tick.normal[1]),
    ("normal_z", |tick| tick.normal[2]),
    ("buttons", |tick| f64::from(tick.buttons)),
    ("twist", |tick| tick.twist.unwrap_or(0.0)),
];

/// Every tick since the last drain.
#[pyclass(frozen, module = "proxygraph")]
pub struct Ticks {
    ticks: Vec<TickRecord>,
}

impl Ticks {
    pub fn new(ticks: Vec<TickRecord>) -> Self {
        Self { ticks }
    }
}

#[pymethods]
impl Ticks {
    #[classattr]
    fn columns(py: Python<'_>) -> PyResult<Py<PyTuple>> {
        columns::names(py, &COLUMNS)
    }

    fn __len__(&self) -> usize {
        self.ticks.len()
    }

    fn column<'py>(&self, py: Python<'py>, name: &str) -> PyResult<Bound<'py, PyAny>> {
        columns::column(py, "Ticks", &COLUMNS, self.ticks.iter(), name)
    }
}

/// A feature as the columns of doubles have it.
pub fn feature_number(feature: Feature) -> f64 {
    match feature {
        Feature::Free => 0.0,
        Feature::Face => 1.0,
        Feature::Edge => 2.0,
        Feature::Vertex => 3.0,
    }
}

fn mode_number(mode: Mode) -> f64 {
    match mode {
        Mode::Normal => 0.0,
        Mode::Pan => 1.0,
        Mode::Zoom => 2.0,
    }
}
