//! Haptic devices behind one trait: a pose comes in, a force goes out.
//!
//! A device knows nothing of terrain, threads or clocks; the servo calls it once a tick. All
//! quantities are in the device's workspace frame: metres and newtons, x to the right, y away from
//! the person, z up, the origin where the device rests.

pub mod check;
mod device;
mod grip;
mod mechanism;
mod motion;
mod playback;
mod rate;
mod scripted;
mod simulated;
mod track;

pub use check::ParameterError;
pub use device::{Capabilities, Device, DeviceError, Force, NOMINAL_PERIOD, Pose};
pub use grip::Grip;
pub use mechanism::{LONGEST_DELAY, Mechanism};
pub use playback::{HandMoment, PlaybackDevice};
pub use rate::{RateControl, RateDevice};
pub use scripted::{HandlePoint, PathPoint, ScriptedDevice};
pub use simulated::{Hand, SimulatedDevice};
pub use track::PathError;
