//! What a session shows of itself.

use crate::errors::value_error;
use crate::model::feature_name;
use crate::session::Window;
use pyo3::prelude::*;

type Vector = (f64, f64, f64);

/// The newest tick of a session.
#[pyclass(frozen, module = "proxygraph")]
pub struct State {
    state: servo::State,
}

impl State {
    pub fn new(state: servo::State) -> Self {
        Self { state }
    }
}

#[pymethods]
impl State {
    #[getter]
    fn tick(&self) -> u64 {
        self.state.tick
    }

    #[getter]
    fn time(&self) -> f64 {
        self.state.time
    }

    #[getter]
    fn hand(&self) -> Vector {
        self.state.hand.into()
    }

    #[getter]
    fn goal(&self) -> Vector {
        self.state.goal.into()
    }

    #[getter]
    fn proxy(&self) -> Vector {
        self.state.proxy.into()
    }

    #[getter]
    fn feature(&self) -> &'static str {
        feature_name(self.state.feature)
    }

    #[getter]
    fn in_contact(&self) -> bool {
        self.state.in_contact()
    }

    #[getter]
    fn force(&self) -> Vector {
        self.state.force.into()
    }

    #[getter]
    fn model(&self) -> &'static str {
        self.state.model
    }

    #[getter]
    fn held(&self) -> Option<&'static str> {
        self.state.held.map(servo::Held::name)
    }

    #[getter]
    fn mode(&self) -> &'static str {
        self.state.mode.name()
    }

    #[getter]
    fn window(&self) -> Window {
        Window::of(self.state.window)
    }
}

/// Counts since the session was made.
#[pyclass(frozen, module = "proxygraph")]
pub struct Statistics {
    statistics: servo::Statistics,
}

impl Statistics {
    pub fn new(statistics: servo::Statistics) -> Self {
        Self { statistics }
    }
}

#[pymethods]
impl Statistics {
    #[getter]
    fn ticks(&self) -> u64 {
        self.statistics.totals.ticks
    }

    #[getter]
    fn missed_ticks(&self) -> u64 {
        self.statistics.totals.missed_ticks
    }

    #[getter]
    fn contact_ticks(&self) -> u64 {
        self.statistics.totals.contact_ticks
    }

    #[getter]
    fn vertices(&self) -> u64 {
        self.statistics.totals.vertices
    }

    #[getter]
    fn faces(&self) -> u64 {
        self.statistics.totals.faces
    }

    #[getter]
    fn collision_tests(&self) -> u64 {
        self.statistics.totals.collision_tests
    }

    #[getter]
    fn cells(&self) -> u64 {
        self.statistics.totals.cells
    }

    #[getter]
    fn far_edge_crossings(&self) -> u64 {
        self.statistics.totals.far_edge_crossings
    }

    #[getter]
    fn far_edge_loops(&self) -> u64 {
        self.statistics.totals.far_edge_loops
    }

    #[getter]
    fn cycles_ended(&self) -> u64 {
        self.statistics.totals.cycles_ended
    }

    #[getter]
    fn unfinished(&self) -> u64 {
        self.statistics.totals.unfinished
    }

    #[getter]
    fn not_finite(&self) -> u64 {
        self.statistics.totals.trips.not_finite
    }

    #[getter]
    fn device_errors(&self) -> u64 {
        self.statistics.totals.trips.device_errors
    }

    #[getter]
    fn speed_cuts(&self) -> u64 {
        self.statistics.totals.trips.speed_cuts
    }

    #[getter]
    fn host_cuts(&self) -> u64 {
        self.statistics.totals.trips.host_cuts
    }

    #[getter]
    fn late_cuts(&self) -> u64 {
        self.statistics.totals.trips.late_cuts
    }

    #[getter]
    fn clamped(&self) -> u64 {
        self.statistics.totals.trips.clamped
    }

    #[getter]
    fn ramped(&self) -> u64 {
        self.statistics.totals.trips.ramped
    }

    #[getter]
    fn slew_limited(&self) -> u64 {
        self.statistics.totals.trips.slew_limited
    }

    #[getter]
    fn engaged(&self) -> u64 {
        self.statistics.totals.trips.engaged
    }

    #[getter]
    fn active_ticks(&self) -> u64 {
        self.statistics.totals.active_ticks
    }

    #[getter]
    fn mode_changes(&self) -> u64 {
        self.statistics.totals.mode_changes
    }

    #[getter]
    fn dropped(&self) -> u64 {
        self.statistics.totals.dropped
    }

    #[getter]
    fn goal_cells(&self) -> f64 {
        self.statistics.totals.goal_cells
    }

    fn update_us(&self, quantile: f64) -> PyResult<f64> {
        Ok(self.statistics.update_us(checked(quantile)?))
    }

    #[getter]
    fn mean_load(&self) -> f64 {
        self.statistics.mean_load()
    }

    fn load(&self, quantile: f64) -> PyResult<f64> {
        Ok(self.statistics.load(checked(quantile)?))
    }

    fn late_us(&self, quantile: f64) -> PyResult<f64> {
        Ok(self.statistics.late_us(checked(quantile)?))
    }
}

fn checked(quantile: f64) -> PyResult<f64> {
    if (0.0..=1.0).contains(&quantile) {
        return Ok(quantile);
    }
    Err(value_error(format!("quantile is {quantile}; expected a number from 0 to 1")))
}
