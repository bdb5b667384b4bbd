//! Sessions and the window they look through.

use crate::choice::{Choice, DEFAULT, Knobs, RADIUS_IN_HAND};
use crate::devices::AnyDevice;
use crate::errors::{session_refusal, value_error};
use crate::grid::Grid;
use crate::numbers::Whole;
use crate::recording::Recording;
use crate::state::{State, Statistics};
use crate::take::{Take, write_refusal};
use crate::ticks::Ticks;
use pyo3::prelude::*;
use pyo3::sync::MutexExt;
use servo::{Frame, Interaction, Mode, SessionError, Settings};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard};

/// After so many ticks a person's Ctrl-C is looked for; some milliseconds.
const TICKS_BETWEEN_SIGNALS: u64 = 10_000;

/// The workspace frame laid over the terrain.
#[pyclass(frozen, module = "proxygraph")]
pub struct Window {
    window: servo::Window,
}

impl Window {
    pub fn of(window: servo::Window) -> Self {
        Self { window }
    }
}

#[pymethods]
impl Window {
    #[new]
    #[pyo3(signature = (east, north, up, *, width, exaggeration=1.0, turn=0.0))]
    fn new(
        east: f64,
        north: f64,
        up: f64,
        width: f64,
        exaggeration: f64,
        turn: f64,
    ) -> PyResult<Self> {
        let window = servo::Window::new(east, north, up, width, exaggeration);
        let turned = window.and_then(|window| window.turned(turn));
        Ok(Self { window: turned.map_err(value_error)? })
    }

    #[getter]
    fn east(&self) -> f64 {
        self.window.east()
    }

    #[getter]
    fn north(&self) -> f64 {
        self.window.north()
    }

    #[getter]
    fn up(&self) -> f64 {
        self.window.up()
    }

    #[getter]
    fn width(&self) -> f64 {
        self.window.width()
    }

    #[getter]
    fn exaggeration(&self) -> f64 {
        self.window.exaggeration()
    }

    #[getter]
    fn turn(&self) -> f64 {
        self.window.turn()
    }

    fn __repr__(&self) -> String {
        let (east, north, up) = (self.east(), self.north(), self.up());
        let (width, exaggeration, turn) = (self.width(), self.exaggeration(), self.turn());
        format!(
            "Window({east}, {north}, {up}, width={width}, exaggeration={exaggeration}, turn={turn})"
        )
    }
}

/// A grid, a device and a contact model in one loop.
#[pyclass(frozen, module = "proxygraph")]
pub struct Session {
    session: Mutex<servo::Session>,
}

impl Session {
    /// Whoever else holds the session may be waiting for the interpreter, so it is let go meanwhile.
    fn lock(&self, py: Python<'_>) -> MutexGuard<'_, servo::Session> {
        self.session.lock_py_attached(py).unwrap_or_else(|poisoned| poisoned.into_inner())
    }

    /// Runs something that may take long without the interpreter.
    fn detached<T: Send>(
        &self,
        py: Python<'_>,
        long: impl FnOnce(&mut servo::Session) -> T + Send,
    ) -> T {
        py.detach(|| {
            let mut session = self.session.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
            long(&mut session)
        })
    }
}

#[pymethods]
impl Session {
    #[new]
    #[pyo3(signature = (grid, device, window, *, stiffness=500.0, max_force=8.0, ring_seconds=60.0,
        max_slew=None, max_speed=None, stale_after=None, real_time=true,
        walls=false, modes=false, pan_mass=0.2, drift_time=0.5, zoom_travel=0.02, detent_force=0.4,
        zoom_widths=None, model=DEFAULT, step_budget=None, sub_step=None, radius=None),
        text_signature = "(grid, device, window, *, stiffness=500.0, max_force=8.0, \
        ring_seconds=60.0, max_slew=None, max_speed=None, stale_after=None, \
        real_time=True, walls=False, modes=False, pan_mass=0.2, drift_time=0.5, zoom_travel=0.02, \
        detent_force=0.4, zoom_widths=None, model='surface_walk', step_budget=None, sub_step=None, radius=None)")]
    #[expect(clippy::too_many_arguments, reason = "Python's keywords")]
    fn new(
        grid: &Grid,
        device: AnyDevice<'_>,
        window: &Window,
        stiffness: f64,
        max_force: f64,
        ring_seconds: f64,
        max_slew: Option<f64>,
        max_speed: Option<f64>,
        stale_after: Option<f64>,
        real_time: bool,
        walls: bool,
        modes: bool,
        pan_mass: f64,
        drift_time: f64,
        zoom_travel: f64,
        detent_force: f64,
        zoom_widths: Option<(f64, f64)>,
        model: &str,
        step_budget: Option<Whole>,
        sub_step: Option<f64>,
        radius: Option<f64>,
    ) -> PyResult<Self> {
        let knobs = Knobs { step_budget, sub_step, radius };
        let choice = Choice::new(model, &knobs, RADIUS_IN_HAND)?;
        let (grid, window) = (grid.shared(), window.window);
        let interaction = Interaction {
            pan_mass,
            drift_time,
            zoom_travel,
            detent_force,
            zoom_widths: zoom_widths.map(|(narrowest, widest)| [narrowest, widest]),
        };
        let settings = Settings {
            stiffness,
            max_force,
            ring_seconds,
            max_slew: max_slew.unwrap_or(f64::INFINITY),
            max_speed: max_speed.unwrap_or(f64::INFINITY),
            stale_after,
            real_time,
            walls,
            interaction: modes.then_some(interaction),
        };
        // Also where there are no modes: a wrong number is told when it is given.
        interaction.validate().map_err(value_error)?;
        // Everything that can be refused is refused before the device is taken.
        settings.validate().map_err(value_error)?;
        Frame::new(window, device.workspace_width(), grid.layout()).map_err(value_error)?;
        let session = servo::Session::new(grid, device.take()?, choice.build(), window, settings);
        Ok(Self { session: Mutex::new(session.map_err(value_error)?) })
    }

    fn start(&self, py: Python<'_>) -> PyResult<()> {
        self.detached(py, |session| session.start()).map_err(session_refusal)
    }

    fn stop(&self, py: Python<'_>) {
        self.detached(py, |session| session.stop());
    }

    fn step(&self, py: Python<'_>, count: Whole) -> PyResult<()> {
        let mut left: u64 = count.unsigned("count").map_err(value_error)?;
        loop {
            let ticks = left.min(TICKS_BETWEEN_SIGNALS);
            self.detached(py, |session| session.step(ticks)).map_err(session_refusal)?;
            left -= ticks;
            if left == 0 {
                return Ok(());
            }
            py.check_signals()?;
        }
    }

    #[getter]
    fn running(&self, py: Python<'_>) -> bool {
        self.lock(py).running()
    }

    #[getter]
    fn fault(&self, py: Python<'_>) -> Option<String> {
        self.lock(py).fault().map(ToString::to_string)
    }

    #[getter]
    fn stiffness(&self, py: Python<'_>) -> f64 {
        self.lock(py).limits().stiffness
    }

    #[getter]
    fn max_force(&self, py: Python<'_>) -> f64 {
        self.lock(py).limits().max_force
    }

    #[getter]
    fn max_slew(&self, py: Python<'_>) -> f64 {
        self.lock(py).limits().max_slew
    }

    #[getter]
    fn max_speed(&self, py: Python<'_>) -> f64 {
        self.lock(py).limits().max_speed
    }

    #[getter]
    fn priority(&self, py: Python<'_>) -> String {
        self.lock(py).priority().to_string()
    }

    #[getter]
    fn locked_memory(&self, py: Python<'_>) -> (usize, usize) {
        let memory = self.lock(py).locked_memory();
        (memory.locked, memory.refused)
    }

    fn warnings(&self, py: Python<'_>) -> Vec<String> {
        self.lock(py).warnings().iter().map(ToString::to_string).collect()
    }

    fn heartbeat(&self, py: Python<'_>) {
        self.lock(py).heartbeat();
    }

    #[getter]
    fn window(&self, py: Python<'_>) -> Window {
        Window::of(self.lock(py).window())
    }

    fn set_window(&self, py: Python<'_>, window: &Window) -> PyResult<()> {
        self.lock(py).set_window(window.window).map_err(session_refusal)
    }

    #[getter]
    fn model(&self, py: Python<'_>) -> &'static str {
        self.lock(py).model()
    }

    #[pyo3(signature = (model, *, step_budget=None, sub_step=None, radius=None))]
    fn set_model(
        &self,
        py: Python<'_>,
        model: &str,
        step_budget: Option<Whole>,
        sub_step: Option<f64>,
        radius: Option<f64>,
    ) -> PyResult<()> {
        let knobs = Knobs { step_budget, sub_step, radius };
        let choice = Choice::new(model, &knobs, RADIUS_IN_HAND)?;
        self.lock(py).set_model(choice.build()).map_err(session_refusal)
    }

    fn set_passivity_control(&self, py: Python<'_>, controls: bool) -> PyResult<()> {
        self.lock(py).set_passivity_control(controls).map_err(session_refusal)
    }

    fn press(&self, py: Python<'_>) -> PyResult<()> {
        self.lock(py).press().map_err(session_refusal)
    }

    fn release(&self, py: Python<'_>) -> PyResult<()> {
        self.lock(py).release().map_err(session_refusal)
    }

    fn set_mode(&self, py: Python<'_>, mode: &str) -> PyResult<()> {
        let named = Mode::ALL.into_iter().find(|known| known.name() == mode);
        let Some(named) = named else {
            return Err(value_error(format!("mode is '{mode}'; expected normal, pan or zoom")));
        };
        self.lock(py).set_mode(named).map_err(session_refusal)
    }

    fn set_twist(&self, py: Python<'_>, radians: f64) -> PyResult<()> {
        self.lock(py).set_twist(radians).map_err(session_refusal)
    }

    fn set_target(&self, py: Python<'_>, x: f64, y: f64, z: f64) -> PyResult<()> {
        self.lock(py).set_target([x, y, z]).map_err(session_refusal)
    }

    fn state(&self, py: Python<'_>) -> State {
        State::new(self.lock(py).state())
    }

    fn statistics(&self, py: Python<'_>) -> Statistics {
        Statistics::new(self.lock(py).statistics())
    }

    fn drain(&self, py: Python<'_>) -> Ticks {
        Ticks::new(self.detached(py, |session| session.drain()))
    }

    fn set_pre_roll(&self, py: Python<'_>, seconds: f64) -> PyResult<()> {
        self.detached(py, |session| session.set_pre_roll(seconds)).map_err(session_refusal)
    }

    #[pyo3(signature = (about="", *, spool=None))]
    fn start_recording(&self, py: Python<'_>, about: &str, spool: Option<PathBuf>) -> PyResult<()> {
        let (about, spool) = (about.to_owned(), spool.as_deref());
        self.detached(py, |session| session.start_recording(about, spool)).map_err(|error| {
            match error {
                SessionError::Spool(error) => {
                    write_refusal(error, spool.unwrap_or_else(|| Path::new("")))
                }
                error => session_refusal(error),
            }
        })
    }

    #[getter]
    fn recording(&self, py: Python<'_>) -> Option<Recording> {
        self.lock(py).recording().map(Recording::new)
    }

    fn recorded(&self, py: Python<'_>) -> PyResult<Take> {
        let take = self.detached(py, |session| session.recorded()).map_err(session_refusal)?;
        Ok(Take::so_far(take))
    }

    fn stop_recording(&self, py: Python<'_>) -> PyResult<Take> {
        let recorded = self.detached(py, |session| session.stop_recording());
        Ok(Take::recorded(recorded.map_err(session_refusal)?))
    }
}

impl Drop for Session {
    fn drop(&mut self) {
        // Stopping joins the servo's thread; other Python threads need not wait for that.
        let session = self.session.get_mut().unwrap_or_else(|poisoned| poisoned.into_inner());
        Python::attach(|py| py.detach(|| session.stop()));
    }
}
