//! What every device can do, and how it fails.

use std::borrow::Cow;

use crate::{ParameterError, check};

/// Seconds between two ticks for which [`Capabilities::max_stiffness`] is meant (1 kHz).
pub const NOMINAL_PERIOD: f64 = 0.001;

/// Where the hand is, in the workspace frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose {
    /// Metres.
    pub position: [f64; 3],
    /// Which buttons are down, a bit each; the first is the stylus button.
    pub buttons: u32,
    /// How far the handle is turned about the vertical, radians, counter-clockwise seen from above;
    /// any number of full turns may be in it. `None` where the device does not tell.
    pub twist: Option<f64>,
}

impl Pose {
    /// A hand there, with no button down, on a handle that cannot be turned.
    pub fn at(position: [f64; 3]) -> Pose {
        Pose { position, buttons: 0, twist: None }
    }

    /// Whether every number in it is finite.
    pub fn is_finite(&self) -> bool {
        let numbers = self.position.iter().chain(&self.twist);
        numbers.into_iter().all(|number| number.is_finite())
    }
}

/// A force on the hand, in the workspace frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Force {
    /// Newtons.
    pub newtons: [f64; 3],
}

impl Force {
    /// No force.
    pub const ZERO: Force = Force { newtons: [0.0; 3] };

    /// Whether every number in it is finite.
    pub fn is_finite(&self) -> bool {
        self.newtons.iter().all(|component| component.is_finite())
    }
}

/// What a device can do. It does not change while the device is open.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Capabilities {
    /// Width (x), depth (y) and height (z) that the hand can reach, metres.
    pub workspace: [f64; 3],
    /// The largest force that may be asked for continuously, newtons; infinite where nothing limits it.
    pub max_force: f64,
    /// The stiffest spring, in N/m, that the device can show at [`NOMINAL_PERIOD`] if the force
    /// acts in the tick in which the pose was read; infinite where nothing limits it.
    pub max_stiffness: f64,
    /// Whole ticks from reading a pose to the moment when the force answering it acts. 0 where a
    /// device is read and written in the same tick.
    pub delay_ticks: u32,
    /// The fastest change of the force that may be asked for, N/s; infinite where nothing limits it.
    pub max_slew: f64,
    /// The fastest hand, m/s, beyond which the handle must have slipped from it; infinite where it
    /// cannot.
    ///
    /// For desktop devices about 3 m/s: hands on them move with up to 1 or 2 m/s, and a handle of
    /// 0.1 kg let go under 8 N is past 3 m/s after 6 cm.
    pub max_speed: f64,
}

impl Capabilities {
    /// Of a device that sets no limits.
    pub const fn unlimited(workspace: [f64; 3]) -> Capabilities {
        Capabilities {
            workspace,
            max_force: f64::INFINITY,
            max_stiffness: f64::INFINITY,
            delay_ticks: 0,
            max_slew: f64::INFINITY,
            max_speed: f64::INFINITY,
        }
    }

    /// Checks what a driver says of its device before forces are computed from it.
    pub fn validate(&self) -> Result<(), ParameterError> {
        check::workspace(self.workspace)?;
        check::limit("max_force", self.max_force)?;
        check::limit("max_stiffness", self.max_stiffness)?;
        check::limit("max_slew", self.max_slew)?;
        check::positive_or_infinite("max_speed", self.max_speed)
    }
}

/// Why a device did not answer. The text in each names the device or the cause.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum DeviceError {
    /// It was unplugged or switched off.
    #[error("the device is gone: {0}")]
    Gone(Cow<'static, str>),
    /// The system does not let this person use it, or another program holds it.
    #[error("access to the device was denied: {0}")]
    Denied(Cow<'static, str>),
    /// It is there and did not answer in time.
    #[error("the device did not answer in time: {0}")]
    Timeout(Cow<'static, str>),
    /// It answered something that cannot be understood.
    #[error("the device answered something unexpected: {0}")]
    Protocol(Cow<'static, str>),
}

/// A haptic device. In every tick the servo reads once, then writes once.
///
/// `read` and `write` are called from a thread that must not wait: an implementation does not
/// allocate, lock or log in them, and gives up after its own short timeout: while it waits, the
/// motors keep the force that they were told last.
///
/// An error gives no force in that tick. [`DeviceError::Timeout`] and [`DeviceError::Protocol`] are
/// forgiven twice in a row and nine times a second; the others end touch.
pub trait Device: Send {
    /// What the device can do.
    fn capabilities(&self) -> Capabilities;

    /// Where the hand is now. `time` is in seconds on the session's clock, for devices that follow
    /// a script: what missed ticks skip, the script skips too.
    fn read(&mut self, time: f64) -> Result<Pose, DeviceError>;

    /// Pushes the hand with `force` until the next write. `dt` is the length of the tick in seconds,
    /// the ticks missed before it included: what a simulated hand moves on by. A `dt` of zero means
    /// that no time passes; the last write of a session is of that kind.
    fn write(&mut self, force: Force, dt: f64) -> Result<(), DeviceError>;

    /// Whether a device that plays has played all that it had: there is no force from then on. A hand
    /// never is.
    fn is_finished(&self) -> bool {
        false
    }

    /// Where a simulated hand shall go (workspace metres). Real hands go where they want.
    fn set_target(&mut self, _target: [f64; 3]) {}

    /// How far a simulated handle shall be turned about the vertical, radians. Real hands turn it.
    fn set_twist(&mut self, _radians: f64) {}
}
