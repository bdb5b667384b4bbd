//! What many updates of a contact model found, by column.

use crate::columns::{self, Column};
use crate::ticks::feature_number;
use pyo3::prelude::*;
use pyo3::types::PyTuple;

/// What one of the updates found.
pub struct Found {
    /// Terrain frame.
    pub proxy: [f64; 3],
    pub contact: contact::Contact,
}

const COLUMNS: [Column<Found>; 13] = [
    ("proxy_east", |found| found.proxy[0]),
    ("proxy_north", |found| found.proxy[1]),
    ("proxy_up", |found| found.proxy[2]),
    ("spring_x", |found| found.contact.displacement[0]),
    ("spring_y", |found| found.contact.displacement[1]),
    ("spring_z", |found| found.contact.displacement[2]),
    ("feature", |found| feature_number(found.contact.feature)),
    ("vertices", |found| f64::from(found.contact.counters.vertices)),
    ("faces", |found| f64::from(found.contact.counters.faces)),
    ("collision_tests", |found| f64::from(found.contact.counters.collision_tests)),
    ("cells", |found| f64::from(found.contact.counters.cells)),
    ("far_edge_crossings", |found| f64::from(found.contact.counters.far_edge_crossings)),
    ("steps_left", |found| f64::from(found.contact.counters.steps_left)),
];

/// What the updates of `ContactModel.follow` found, in their order.
#[pyclass(frozen, module = "proxygraph")]
pub struct Contacts {
    found: Vec<Found>,
}

impl Contacts {
    pub fn new(found: Vec<Found>) -> Self {
        Self { found }
    }
}

#[pymethods]
impl Contacts {
    #[classattr]
    fn columns(py: Python<'_>) -> PyResult<Py<PyTuple>> {
        columns::names(py, &COLUMNS)
    }

    fn __len__(&self) -> usize {
        self.found.len()
    }

    fn column<'py>(&self, py: Python<'py>, name: &str) -> PyResult<Bound<'py, PyAny>> {
        columns::column(py, "Contacts", &COLUMNS, self.found.iter(), name)
    }
}
