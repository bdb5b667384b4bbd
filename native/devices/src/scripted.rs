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

/// Plays a path with straight lines between its points, and stays at its ends before and after.
/// It takes every force and does not move by it.
#[derive(Clone, Debug)]
pub struct ScriptedDevice {
    path: Vec<PathPoint>,
    workspace: [f64; 3],
    /// The point that was last passed; only a hint where to look first.
    passed: usize,
}

impl ScriptedDevice {
    /// A device playing `path`, whose times must rise, in a workspace of that size (metres).
    pub fn new(path: Vec<PathPoint>, workspace: [f64; 3]) -> Result<Self, PathError> {
        check::workspace(workspace)?;
        if path.is_empty() {
            return Err(PathError::Empty);
        }
        for (index, point) in path.iter().enumerate() {
            if !point.time.is_finite() || point.position.iter().any(|metres| !metres.is_finite()) {
                return Err(PathError::NotFinite { index });
            }
        }
        for (before, pair) in path.windows(2).enumerate() {
            if pair[1].time <= pair[0].time {
                return Err(PathError::NotRising {
                    index: before + 1,
                    time: pair[1].time,
                    previous: pair[0].time,
                });
            }
        }
        Ok(ScriptedDevice { path, workspace, passed: 0 })
    }

    /// Where the script is at `time` seconds.
    fn position(&mut self, time: f64) -> [f64; 3] {
        let first = self.path[0];
        if time.is_nan() || time < first.time {
            return first.position;
        }
        self.passed = self.last_point_passed(time);
        let from = self.path[self.passed];
        match self.path.get(self.passed + 1) {
            Some(to) => between(&from, to, time),
            None => from.position,
        }
    }

    /// The last point at or before `time`, which is not before the first point. Time usually moves
    /// on by a tick, so the point found last and the one after it are tried before searching.
    fn last_point_passed(&self, time: f64) -> usize {
        for guess in [self.passed, self.passed + 1] {
            if self.is_last_passed(guess, time) {
                return guess;
            }
        }
        self.path.partition_point(|point| point.time <= time) - 1
    }

    fn is_last_passed(&self, index: usize, time: f64) -> bool {
        let passed = self.path.get(index).is_some_and(|point| point.time <= time);
        passed && self.path.get(index + 1).is_none_or(|next| time < next.time)
    }
}

/// The point on the straight line from `from` to `to` at `time`.
fn between(from: &PathPoint, to: &PathPoint, time: f64) -> [f64; 3] {
    let share = (time - from.time) / (to.time - from.time);
    // Times near the largest number overflow to infinity over infinity.
    let share = if share.is_nan() { 0.0 } else { share };
    std::array::from_fn(|axis| {
        let (start, end) = (from.position[axis], to.position[axis]);
        if start == end {
            // A hand that is held still is still to the last bit.
            return start;
        }
        // Unlike start + (end - start) * share this cannot overflow.
        start * (1.0 - share) + end * share
    })
}

impl Device for ScriptedDevice {
    fn capabilities(&self) -> Capabilities {
        Capabilities::unlimited(self.workspace)
    }

    fn read(&mut self, time: f64) -> Result<Pose, DeviceError> {
        Ok(Pose::at(self.position(time)))
    }

    fn write(&mut self, _force: Force, _dt: f64) -> Result<(), DeviceError> {
        Ok(())
    }
}
