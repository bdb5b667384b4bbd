//! Devices as Python sees them: made here, then taken over by one session.

use crate::errors::{session_error, value_error};
use devices::{Device, Hand, HandlePoint, PathPoint, RateControl, RateDevice};
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use std::sync::Mutex;

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

/// Any of the devices above, as an argument.
pub enum AnyDevice<'py> {
    Scripted(PyRef<'py, ScriptedDevice>),
    Simulated(PyRef<'py, SimulatedDevice>),
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
        let found = object.get_type().name()?;
        Err(PyTypeError::new_err(format!(
            "device is a {found}; expected a ScriptedDevice or a SimulatedDevice"
        )))
    }
}

impl AnyDevice<'_> {
    /// Metres.
    pub fn workspace_width(&self) -> f64 {
        match self {
            Self::Scripted(device) => device.waiting.workspace[0],
            Self::Simulated(device) => device.waiting.workspace[0],
        }
    }

    /// The device itself, for a session to keep.
    pub fn take(&self) -> PyResult<Box<dyn Device>> {
        match self {
            Self::Scripted(device) => device.waiting.take(),
            Self::Simulated(device) => device.waiting.take(),
        }
    }
}
