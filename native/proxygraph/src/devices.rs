//! Devices as Python sees them: made here, then taken over by one session.

use crate::errors::{session_error, value_error};
use crate::numbers::Doubles;
use crate::session::Window;
use crate::take::Take;
use devices::{Device, Hand, HandMoment, HandlePoint, PathPoint, RateControl, RateDevice};
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex};

type Point = (f64, f64, f64);

/// A device until a session takes it.
struct Waiting {
    device: Mutex<Option<Box<dyn Device>>>,
    workspace: [f64; 3],
}

impl Waiting {
    fn new(device: impl Device + 'static) -> Self {
        let workspace = device.capabilities().workspace;
        Self { device: Mutex::new(Some(Box::new(device))), workspace }
    }

    fn take(&self) -> PyResult<Box<dyn Device>> {
        let mut device = self.device.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
        device
            .take()
            .ok_or_else(|| session_error("this device already serves a session; make another one"))
    }
}

/// Plays a path.
#[pyclass(frozen, module = "proxygraph")]
pub struct ScriptedDevice {
    waiting: Waiting,
}

#[pymethods]
impl ScriptedDevice {
    #[new]
    #[pyo3(signature = (path, *, workspace=(0.16, 0.12, 0.12), handle=Vec::new(), by_velocity=false),
        text_signature = "(path, *, workspace=(0.16, 0.12, 0.12), handle=(), by_velocity=False)")]
    fn new(
        path: Vec<(f64, f64, f64, f64)>,
        workspace: Point,
        handle: Vec<(f64, f64, u32)>,
        by_velocity: bool,
    ) -> PyResult<Self> {
        let path = path.into_iter().map(PathPoint::from).collect();
        let handle = handle.into_iter().map(HandlePoint::from).collect();
        let device = devices::ScriptedDevice::new(path, workspace.into())
            .and_then(|device| device.with_handle(handle))
            .map_err(value_error)?;
        if !by_velocity {
            return Ok(Self { waiting: Waiting::new(device) });
        }
        let device = RateDevice::new(device, RateControl::default(), workspace.into());
        Ok(Self { waiting: Waiting::new(device.map_err(value_error)?) })
    }

    #[getter]
    fn workspace(&self) -> Point {
        self.waiting.workspace.into()
    }
}

/// A hand on a muscle spring.
#[pyclass(frozen, module = "proxygraph")]
pub struct SimulatedDevice {
    waiting: Waiting,
}

#[pymethods]
impl SimulatedDevice {
    #[new]
    #[pyo3(signature = (*, target=(0.0, 0.0, 0.05), mass=0.1, muscle_stiffness=300.0, damping=8.0,
        max_force=8.0, workspace=(0.16, 0.12, 0.12)),
        text_signature = "(*, target=(0.0, 0.0, 0.05), mass=0.1, muscle_stiffness=300.0, \
        damping=8.0, max_force=8.0, workspace=(0.16, 0.12, 0.12))")]
    fn new(
        target: Point,
        mass: f64,
        muscle_stiffness: f64,
        damping: f64,
        max_force: f64,
        workspace: Point,
    ) -> PyResult<Self> {
        let (target, workspace) = (target.into(), workspace.into());
        let hand = Hand { target, mass, muscle_stiffness, damping, max_force, workspace };
        let device = devices::SimulatedDevice::new(hand).map_err(value_error)?;
        Ok(Self { waiting: Waiting::new(device) })
    }

    #[getter]
    fn workspace(&self) -> Point {
        self.waiting.workspace.into()
    }
}

/// Plays a hand that was recorded.
#[pyclass(frozen, module = "proxygraph")]
pub struct PlaybackDevice {
    waiting: Waiting,
    seconds: f64,
    finished: Arc<AtomicBool>,
    window: Option<servo::Window>,
}

impl PlaybackDevice {
    fn playing(
        hand: Vec<HandMoment>,
        speed: f64,
        workspace: [f64; 3],
        window: Option<servo::Window>,
    ) -> PyResult<Self> {
        let device = devices::PlaybackDevice::new(hand, speed, workspace).map_err(value_error)?;
        let (seconds, finished) = (device.seconds(), device.finished());
        Ok(Self { waiting: Waiting::new(device), seconds, finished, window })
    }
}

#[pymethods]
impl PlaybackDevice {
    #[new]
    #[pyo3(signature = (times, hand_x, hand_y, hand_z, *, buttons=None, twist=None, speed=1.0,
        workspace=(0.16, 0.12, 0.12)),
        text_signature = "(times, hand_x, hand_y, hand_z, *, buttons=None, twist=None, speed=1.0, \
        workspace=(0.16, 0.12, 0.12))")]
    #[expect(clippy::too_many_arguments, reason = "Python's keywords")]
    fn new(
        times: Doubles,
        hand_x: Doubles,
        hand_y: Doubles,
        hand_z: Doubles,
        buttons: Option<Doubles>,
        twist: Option<Doubles>,
        speed: f64,
        workspace: Point,
    ) -> PyResult<Self> {
        let count = times.0.len();
        let columns =
            [("hand_x", Some(&hand_x)), ("hand_y", Some(&hand_y)), ("hand_z", Some(&hand_z))];
        let others = [("buttons", buttons.as_ref()), ("twist", twist.as_ref())];
        for (name, column) in columns.into_iter().chain(others) {
            let found = column.map_or(count, |column| column.0.len());
            if found != count {
                let words = format!("{name} has {found} values; expected {count}, as times has");
                return Err(value_error(words));
            }
        }
        let mut hand = Vec::with_capacity(count);
        for index in 0..count {
            let pressed = buttons.as_ref().map_or(0.0, |buttons| buttons.0[index]);
            // Whole numbers only, as a column of doubles has them.
            if pressed != f64::from(pressed as u32) {
                let words = format!(
                    "buttons[{index}] is {pressed}; expected a whole number from 0 to {}, a bit for each",
                    u32::MAX
                );
                return Err(value_error(words));
            }
            hand.push(HandMoment {
                time: times.0[index],
                position: [hand_x.0[index], hand_y.0[index], hand_z.0[index]],
                twist: twist.as_ref().map(|twist| twist.0[index]),
                buttons: pressed as u32,
            });
        }
        Self::playing(hand, speed, workspace.into(), None)
    }

    #[staticmethod]
    #[pyo3(signature = (take, *, speed=1.0))]
    fn of_take(py: Python<'_>, take: &Take, speed: f64) -> PyResult<Self> {
        let replay = py.detach(|| servo::Replay::of(take.native())).map_err(value_error)?;
        let workspace = take.native().header.workspace;
        Self::playing(replay.hand, speed, workspace, Some(replay.window))
    }

    #[getter]
    fn workspace(&self) -> Point {
        self.waiting.workspace.into()
    }

    #[getter]
    fn seconds(&self) -> f64 {
        self.seconds
    }

    #[getter]
    fn finished(&self) -> bool {
        self.finished.load(Ordering::Acquire)
    }

    #[getter]
    fn window(&self) -> Option<Window> {
        self.window.map(Window::of)
    }
}

/// Any of the devices above, as an argument.
pub enum AnyDevice<'py> {
    Scripted(PyRef<'py, ScriptedDevice>),
    Simulated(PyRef<'py, SimulatedDevice>),
    Playback(PyRef<'py, PlaybackDevice>),
}

impl<'py> FromPyObject<'_, 'py> for AnyDevice<'py> {
    type Error = PyErr;

    fn extract(object: Borrowed<'_, 'py, PyAny>) -> PyResult<Self> {
        if let Ok(device) = object.extract() {
            return Ok(Self::Scripted(device));
        }
        if let Ok(device) = object.extract() {
            return Ok(Self::Simulated(device));
        }
        if let Ok(device) = object.extract() {
            return Ok(Self::Playback(device));
        }
        let found = object.get_type().name()?;
        Err(PyTypeError::new_err(format!(
            "device is a {found}; expected a ScriptedDevice, a SimulatedDevice or a PlaybackDevice"
        )))
    }
}

impl AnyDevice<'_> {
    fn waiting(&self) -> &Waiting {
        match self {
            Self::Scripted(device) => &device.waiting,
            Self::Simulated(device) => &device.waiting,
            Self::Playback(device) => &device.waiting,
        }
    }

    /// Metres.
    pub fn workspace_width(&self) -> f64 {
        self.waiting().workspace[0]
    }

    /// The device itself, for a session to keep.
    pub fn take(&self) -> PyResult<Box<dyn Device>> {
        self.waiting().take()
    }
}
