//! Contact models without a servo.

use crate::choice::{Choice, DEFAULT, Knobs};
use crate::contacts::{Contacts, Found};
use crate::errors::value_error;
use crate::grid::Grid;
use crate::numbers::Whole;
use contact::Feature;
use pyo3::buffer::PyBuffer;
use pyo3::prelude::*;
use pyo3::types::PyMemoryView;
use std::sync::{Arc, Mutex, PoisonError};
use surface::Metric;

/// A contact model and the grid that it touches.
#[pyclass(module = "proxygraph")]
pub struct ContactModel {
    grid: Arc<surface::Grid>,
    metric: Metric,
    /// Never contended: it makes the model one that threads may share, as Python's objects are.
    model: Mutex<Box<dyn contact::ContactModel>>,
    name: &'static str,
    step_budget: u32,
    radius: Option<f64>,
}

#[pymethods]
impl ContactModel {
    #[new]
    #[pyo3(signature = (grid, model=DEFAULT, *, scale=1.0, exaggeration=1.0, step_budget=None,
        sub_step=None, radius=None),
        text_signature = "(grid, model='surface_walk', *, scale=1.0, exaggeration=1.0, \
        step_budget=None, sub_step=None, radius=None)")]
    fn new(
        grid: &Grid,
        model: &str,
        scale: f64,
        exaggeration: f64,
        step_budget: Option<Whole>,
        sub_step: Option<f64>,
        radius: Option<f64>,
    ) -> PyResult<Self> {
        let grid = grid.shared();
        let metric = Metric {
            column: grid.layout().cell_width() * scale,
            row: grid.layout().cell_height() * scale,
            up: scale * exaggeration,
        };
        if !metric.is_valid() {
            return Err(value_error(format!(
                "scale is {scale} and exaggeration is {exaggeration}; expected positive numbers"
            )));
        }
        let knobs = Knobs { step_budget, sub_step, radius };
        let choice = Choice::new(model, &knobs, 0.5 * metric.column)?;
        let model = choice.build();
        let (name, step_budget) = (model.name(), choice.step_budget);
        let radius = choice.radius(&metric);
        Ok(Self { grid, metric, model: Mutex::new(model), name, step_budget, radius })
    }

    #[getter]
    fn name(&self) -> &'static str {
        self.name
    }

    #[getter]
    fn step_budget(&self) -> u32 {
        self.step_budget
    }

    #[getter]
    fn radius(&self) -> Option<f64> {
        self.radius
    }

    fn place(&mut self, east: f64, north: f64, up: f64) {
        owned(&mut self.model).place(self.grid.layout().grid_point([east, north, up]));
    }

    fn update(&mut self, east: f64, north: f64, up: f64) -> Contact {
        let goal = self.grid.layout().grid_point([east, north, up]);
        let contact = owned(&mut self.model).update(&self.grid, &self.metric, &goal);
        Contact { proxy: self.grid.layout().terrain_place(&contact.proxy).into(), contact }
    }

    fn follow(&mut self, py: Python<'_>, goals: &Bound<'_, PyAny>) -> PyResult<Contacts> {
        // A copy: what a buffer holds may change while nobody holds the GIL.
        let goals = doubles(py, goals)?;
        let (goals, rest) = goals.as_chunks::<3>();
        if !rest.is_empty() {
            return Err(value_error(format!(
                "goals has {} numbers; expected three for each: east, north and up",
                3 * goals.len() + rest.len()
            )));
        }
        let (grid, metric, model) = (&self.grid, &self.metric, owned(&mut self.model));
        let follow = |goal: &[f64; 3]| {
            let contact = model.update(grid, metric, &grid.layout().grid_point(*goal));
            Found { proxy: grid.layout().terrain_place(&contact.proxy), contact }
        };
        Ok(Contacts::new(py.detach(|| goals.iter().map(follow).collect())))
    }
}

/// The doubles of a buffer.
fn doubles(py: Python<'_>, buffer: &Bound<'_, PyAny>) -> PyResult<Vec<f64>> {
    let expected = "goals is not what was expected: a C-contiguous buffer of doubles";
    if is_empty(buffer) {
        return Ok(Vec::new());
    }
    let buffer = PyBuffer::<f64>::get(buffer).map_err(|_| value_error(expected))?;
    if !buffer.is_c_contiguous() {
        return Err(value_error(expected));
    }
    buffer.to_vec(py)
}

/// Whether a buffer is one of no doubles. In Python 3.11 that of an empty array is nowhere in memory, which
/// no typed buffer may be.
fn is_empty(buffer: &Bound<'_, PyAny>) -> bool {
    let told = || -> PyResult<bool> {
        let view = PyMemoryView::from(buffer)?;
        let count: usize = view.getattr("nbytes")?.extract()?;
        let format: String = view.getattr("format")?.extract()?;
        Ok(count == 0 && format == "d")
    };
    told().unwrap_or(false)
}

fn owned<T: ?Sized>(model: &mut Mutex<Box<T>>) -> &mut T {
    model.get_mut().unwrap_or_else(PoisonError::into_inner)
}

/// What one update found.
#[pyclass(frozen, module = "proxygraph")]
pub struct Contact {
    proxy: (f64, f64, f64),
    contact: contact::Contact,
}

#[pymethods]
impl Contact {
    #[getter]
    fn proxy(&self) -> (f64, f64, f64) {
        self.proxy
    }

    #[getter]
    fn feature(&self) -> &'static str {
        feature_name(self.contact.feature)
    }

    #[getter]
    fn in_contact(&self) -> bool {
        self.contact.feature != Feature::Free
    }

    #[getter]
    fn normal(&self) -> (f64, f64, f64) {
        self.contact.normal().into()
    }

    #[getter]
    fn distance(&self) -> f64 {
        self.contact.distance()
    }

    #[getter]
    fn vertices(&self) -> u32 {
        self.contact.counters.vertices
    }

    #[getter]
    fn faces(&self) -> u32 {
        self.contact.counters.faces
    }

    #[getter]
    fn collision_tests(&self) -> u32 {
        self.contact.counters.collision_tests
    }

    #[getter]
    fn cells(&self) -> u32 {
        self.contact.counters.cells
    }

    #[getter]
    fn far_edge_crossings(&self) -> u32 {
        self.contact.counters.far_edge_crossings
    }

    #[getter]
    fn far_edge_loops(&self) -> u32 {
        self.contact.counters.far_edge_loops
    }

    #[getter]
    fn cycles_ended(&self) -> u32 {
        self.contact.counters.cycles_ended
    }

    #[getter]
    fn steps_left(&self) -> u32 {
        self.contact.counters.steps_left
    }

    fn __repr__(&self) -> String {
        let (east, north, up) = self.proxy;
        let feature = self.feature();
        format!("Contact(proxy=({east}, {north}, {up}), feature='{feature}')")
    }
}

/// A feature as the contract names it.
pub fn feature_name(feature: Feature) -> &'static str {
    match feature {
        Feature::Free => "free",
        Feature::Face => "face",
        Feature::Edge => "edge",
        Feature::Vertex => "vertex",
    }
}
