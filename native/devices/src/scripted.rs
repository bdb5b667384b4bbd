//! A device that plays a path.

use crate::check;
use crate::track::{Moment, PathError, Track, between, share};
use crate::{Capabilities, Device, DeviceError, Force, Pose};

/// The hand at one moment of a script.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PathPoint {
    /// Seconds on the session's clock.
    pub time: f64,
    /// Workspace metres.
    pub position: [f64; 3],
}

impl From<(f64, f64, f64, f64)> for PathPoint {
    /// From (seconds, x, y, z).
    fn from((time, x, y, z): (f64, f64, f64, f64)) -> Self {
        PathPoint { time, position: [x, y, z] }
    }
}

/// The handle at one moment of a script.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HandlePoint {
    /// Seconds on the session's clock.
    pub time: f64,
    /// Radians about the vertical; turned evenly from point to point.
    pub twist: f64,
    /// A bit each; as they are until the next point.
    pub buttons: u32,
}

impl From<(f64, f64, u32)> for HandlePoint {
    /// From (seconds, radians, buttons).
    fn from((time, twist, buttons): (f64, f64, u32)) -> Self {
        HandlePoint { time, twist, buttons }
    }
}

impl Moment for PathPoint {
    fn time(&self) -> f64 {
        self.time
    }

    fn is_finite(&self) -> bool {
        self.time.is_finite() && self.position.iter().all(|metres| metres.is_finite())
    }
}

impl Moment for HandlePoint {
    fn time(&self) -> f64 {
        self.time
    }

    fn is_finite(&self) -> bool {
        self.time.is_finite() && self.twist.is_finite()
    }
}

/// Plays a path with straight lines between its points, and stays at its ends before and after.
/// It takes every force and does not move by it.
#[derive(Clone, Debug)]
pub struct ScriptedDevice {
    path: Track<PathPoint>,
    /// Empty where the handle has neither buttons nor twist.
    handle: Track<HandlePoint>,
    workspace: [f64; 3],
}

impl ScriptedDevice {
    /// A device playing `path`, whose times must rise, in a workspace of that size (metres).
    pub fn new(path: Vec<PathPoint>, workspace: [f64; 3]) -> Result<Self, PathError> {
        check::workspace(workspace)?;
        if path.is_empty() {
            return Err(PathError::Empty);
        }
        Ok(ScriptedDevice { path: Track::new(path)?, handle: Track::new(Vec::new())?, workspace })
    }

    /// The same hand, which also turns its handle and presses buttons; times must rise. Before the
    /// first point no button is down.
    pub fn with_handle(self, handle: Vec<HandlePoint>) -> Result<Self, PathError> {
        Ok(ScriptedDevice { handle: Track::new(handle)?, ..self })
    }

    /// Where the script is at `time` seconds.
    fn position(&mut self, time: f64) -> [f64; 3] {
        match self.path.around(time) {
            Some((from, Some(to))) => {
                let share = share(from.time, to.time, time);
                std::array::from_fn(|axis| between(from.position[axis], to.position[axis], share))
            }
            Some((from, None)) => from.position,
            // A path has points.
            None => [0.0; 3],
        }
    }

    /// Radians, if the handle tells, and buttons at `time` seconds.
    fn handle(&mut self, time: f64) -> (Option<f64>, u32) {
        match self.handle.around(time) {
            Some((from, Some(to))) => {
                let share = share(from.time, to.time, time);
                (Some(between(from.twist, to.twist, share)), from.buttons)
            }
            Some((only, None)) => {
                (Some(only.twist), if time >= only.time { only.buttons } else { 0 })
            }
            None => (None, 0),
        }
    }
}

impl Device for ScriptedDevice {
    fn capabilities(&self) -> Capabilities {
        Capabilities::unlimited(self.workspace)
    }

    fn read(&mut self, time: f64) -> Result<Pose, DeviceError> {
        let (twist, buttons) = self.handle(time);
        Ok(Pose { position: self.position(time), buttons, twist })
    }

    fn write(&mut self, _force: Force, _dt: f64) -> Result<(), DeviceError> {
        Ok(())
    }
}
