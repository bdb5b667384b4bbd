//! A device that plays a path.

use crate::check;
use crate::{Capabilities, Device, DeviceError, Force, ParameterError, Pose};

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

/// A moment of a script.
trait Moment {
    /// Seconds.
    fn time(&self) -> f64;

    /// Whether every number in it is finite.
    fn is_finite(&self) -> bool;
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

/// Why a path cannot be played.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum PathError {
    /// There is nowhere to be.
    #[error("a path needs at least one point")]
    Empty,
    /// A time or coordinate is NaN or infinite.
    #[error("point {index} of the path has a number that is not finite")]
    NotFinite {
        /// Which point, from 0.
        index: usize,
    },
    /// A point does not lie after the one before it.
    #[error("point {index} of the path is at {time} s, expected a time after {previous} s")]
    NotRising {
        /// Which point, from 0.
        index: usize,
        /// Its time, seconds.
        time: f64,
        /// The time of the point before it, seconds.
        previous: f64,
    },
    /// The workspace has no extent.
    #[error(transparent)]
    Workspace(#[from] ParameterError),
}

/// Moments in order.
#[derive(Clone, Debug)]
struct Track<P> {
    points: Vec<P>,
    /// The point that was last passed; only a hint where to look first.
    passed: usize,
}

impl<P: Moment> Track<P> {
    fn new(points: Vec<P>) -> Result<Self, PathError> {
        if let Some(index) = points.iter().position(|point| !point.is_finite()) {
            return Err(PathError::NotFinite { index });
        }
        for (before, pair) in points.windows(2).enumerate() {
            let (previous, time) = (pair[0].time(), pair[1].time());
            if time <= previous {
                return Err(PathError::NotRising { index: before + 1, time, previous });
            }
        }
        Ok(Track { points, passed: 0 })
    }

    /// The last point at or before `time`, and the one after it; the first one twice before that.
    fn around(&mut self, time: f64) -> Option<(&P, Option<&P>)> {
        let first = self.points.first()?;
        if time.is_nan() || time < first.time() {
            return Some((first, None));
        }
        self.passed = self.last_point_passed(time);
        Some((&self.points[self.passed], self.points.get(self.passed + 1)))
    }

    /// The last point at or before `time`, which is not before the first point. Time usually moves
    /// on by a tick, so the point found last and the one after it are tried before searching.
    fn last_point_passed(&self, time: f64) -> usize {
        for guess in [self.passed, self.passed + 1] {
            if self.is_last_passed(guess, time) {
                return guess;
            }
        }
        self.points.partition_point(|point| point.time() <= time) - 1
    }

    fn is_last_passed(&self, index: usize, time: f64) -> bool {
        let passed = self.points.get(index).is_some_and(|point| point.time() <= time);
        passed && self.points.get(index + 1).is_none_or(|next| time < next.time())
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

/// Of the way from one moment to another.
fn share(from: f64, to: f64, time: f64) -> f64 {
    let share = (time - from) / (to - from);
    // Times near the largest number overflow to infinity over infinity.
    if share.is_nan() { 0.0 } else { share }
}

/// That share of the way from `start` to `end`.
fn between(start: f64, end: f64, share: f64) -> f64 {
    if start == end {
        // A hand that is held still is still to the last bit.
        return start;
    }
    // Unlike start + (end - start) * share this cannot overflow.
    start * (1.0 - share) + end * share
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
