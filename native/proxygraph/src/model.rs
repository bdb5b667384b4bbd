//! Contact models without a servo.

use crate::errors::value_error;
use crate::grid::Grid;
use crate::numbers::Whole;
use contact::{ContactModel, Feature};
use pyo3::prelude::*;
use std::sync::Arc;
use surface::Metric;

/// The contact model of the paper.
#[pyclass(module = "proxygraph")]
pub struct ProxyGraph {
    grid: Arc<surface::Grid>,
    metric: Metric,
    model: contact::ProxyGraph,
}

#[pymethods]
impl ProxyGraph {
    #[new]
    #[pyo3(signature = (grid, *, scale=1.0, exaggeration=1.0, step_budget=Whole(4096)),
        text_signature = "(grid, *, scale=1.0, exaggeration=1.0, step_budget=4096)")]
    fn new(grid: &Grid, scale: f64, exaggeration: f64, step_budget: Whole) -> PyResult<Self> {
        let step_budget = step_budget.positive("step_budget").map_err(value_error)?;
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
        Ok(Self { grid, metric, model: contact::ProxyGraph::new(step_budget) })
    }

    fn place(&mut self, east: f64, north: f64, up: f64) {
        self.model.place(self.grid.layout().grid_point([east, north, up]));
    }

    fn update(&mut self, east: f64, north: f64, up: f64) -> Contact {
        let goal = self.grid.layout().grid_point([east, north, up]);
        let contact = self.model.update(&self.grid, &self.metric, &goal);
        Contact { proxy: self.grid.layout().terrain_place(&contact.proxy).into(), contact }
    }
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
