//! Contact models by name, with their knobs.

use crate::errors::value_error;
use crate::numbers::Whole;
use contact::{ContactModel, MIN_STEP_BUDGET, MIN_SUB_STEP, Model};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use surface::Metric;

/// Workspace metres: the default radius of a session's sphere. The tip of a stylus is as blunt.
pub const RADIUS_IN_HAND: f64 = 0.001;

/// Every model as it is without knobs, with a line for those who choose.
const MODELS: [(Model, &str); 5] = [
    (
        Model::SurfaceWalk { sub_step: None },
        "Exact and fast: walks down the distance to the hand over faces, edges and vertices. The default",
    ),
    (
        Model::ProxyGraph,
        "The model of the 2003 paper: from vertex to vertex. On rough ground it can end beside the \
         nearest point",
    ),
    (
        Model::GodObject,
        "A point held by up to three planes that are never released: floats and sticks. For comparison",
    ),
    (
        Model::GodObjectRelease,
        "The god object with planes released in time: exact for slow hands, one collision test for \
         each triangle",
    ),
    (
        Model::VirtualProxy { radius: RADIUS_IN_HAND },
        "A sphere instead of a point: rounds off what is smaller than its radius",
    ),
];

/// The model's name where nothing else is chosen.
pub const DEFAULT: &str = "surface_walk";

/// All names, the default first.
pub fn names() -> [&'static str; MODELS.len()] {
    MODELS.map(|(model, _)| model.name())
}

/// A line on each model for those who choose, by name.
#[pyfunction]
pub fn model_descriptions(py: Python<'_>) -> PyResult<Bound<'_, PyDict>> {
    let described = PyDict::new(py);
    for (model, description) in MODELS {
        described.set_item(model.name(), description)?;
    }
    Ok(described)
}

/// What a model can be asked for, as Python gives it.
pub struct Knobs {
    pub step_budget: Option<Whole>,
    pub sub_step: Option<f64>,
    pub radius: Option<f64>,
}

/// A model that can be built.
pub struct Choice {
    model: Model,
    /// Of an update: as asked for, or the model's floor.
    pub step_budget: u32,
}

impl Choice {
    /// A model by its name. A sphere without a radius gets `default_radius` (workspace metres).
    pub fn new(name: &str, knobs: &Knobs, default_radius: f64) -> PyResult<Self> {
        let model = named(name)?;
        let sub_step = checked("sub_step", "cells", knobs.sub_step)?;
        if let Some(cells) = sub_step.filter(|cells| *cells < MIN_SUB_STEP) {
            return Err(value_error(format!(
                "sub_step is {cells}; expected at least {MIN_SUB_STEP} cells: in shorter ones a budget of \
                 steps leads nowhere"
            )));
        }
        let radius = checked("radius", "workspace metres", knobs.radius)?;
        let model = match model {
            Model::SurfaceWalk { .. } => Model::SurfaceWalk { sub_step },
            Model::VirtualProxy { .. } => {
                Model::VirtualProxy { radius: radius.unwrap_or(default_radius) }
            }
            other => other,
        };
        if !matches!(model, Model::SurfaceWalk { .. }) {
            refuse("sub_step", sub_step, model, DEFAULT)?;
        }
        if !matches!(model, Model::VirtualProxy { .. }) {
            refuse("radius", radius, model, "virtual_proxy")?;
        }
        let step_budget = match knobs.step_budget {
            Some(steps) => steps.at_least(MIN_STEP_BUDGET, "step_budget").map_err(value_error)?,
            None => model.default_step_budget(),
        };
        Ok(Self { model, step_budget: step_budget.max(model.min_step_budget()) })
    }

    /// The sphere's radius under this metric, workspace metres, as the budget allows it; `None` for points.
    pub fn radius(&self, metric: &Metric) -> Option<f64> {
        self.model.radius_in_force(self.step_budget, metric)
    }

    pub fn build(&self) -> Box<dyn ContactModel> {
        self.model.build(self.step_budget)
    }
}

fn named(name: &str) -> PyResult<Model> {
    let known = MODELS.iter().find(|(model, _)| model.name() == name);
    known.map(|(model, _)| *model).ok_or_else(|| {
        value_error(format!("model is '{name}'; expected one of {}", names().join(", ")))
    })
}

fn checked(knob: &str, unit: &str, value: Option<f64>) -> PyResult<Option<f64>> {
    match value {
        Some(number) if !(number.is_finite() && number > 0.0) => Err(value_error(format!(
            "{knob} is {number}; expected a finite number of {unit} above zero"
        ))),
        usable => Ok(usable),
    }
}

/// A knob that another model has.
fn refuse(knob: &str, value: Option<f64>, model: Model, owner: &str) -> PyResult<()> {
    match value {
        Some(number) => Err(value_error(format!(
            "{knob} is {number} with model '{}'; expected None: only {owner} has it",
            model.name()
        ))),
        None => Ok(()),
    }
}
