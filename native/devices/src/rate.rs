//! A hand steered by velocity, for devices that cannot be pushed: a puck that springs back.

use crate::check;
use crate::{Capabilities, Device, DeviceError, Force, NOMINAL_PERIOD, ParameterError, Pose};

/// How a puck steers a hand.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RateControl {
    /// Metres that the puck can be pushed from its middle along each axis. What it is pushed further
    /// counts as this.
    pub reach: f64,
    /// Share of `reach` within which the puck rests: pucks do not spring back to the last count
    /// (some per cent of full scale on SpaceMice).
    pub dead_zone: f64,
    /// Metres a second of the hand where the puck is pushed as far as it goes.
    pub speed: f64,
    /// Radians a second that the handle turns for a radian that the puck is twisted.
    pub turning: f64,
    /// N s/m: the hand gives way to a force of 1 N with 1/drag metres a second. That lets the ground
    /// push a hand back that nobody can push: it sinks in until the ground's force is drag times
    /// speed, and comes back to the surface when the puck does.
    pub drag: f64,
}

impl Default for RateControl {
    /// Ours: through a workspace of 0.16 m in two seconds, which a hand can still aim with. At
    /// 500 N/m and full speed it sinks 0.8 mm into the ground, and comes back within 10 ms.
    fn default() -> Self {
        RateControl { reach: 1.0, dead_zone: 0.05, speed: 0.08, turning: 3.0, drag: 5.0 }
    }
}

/// A hand that a puck moves on: the puck's position is the hand's velocity.
///
/// The hand stays in the workspace. It begins at its middle, at the height where the workspace ends.
#[derive(Clone, Debug)]
pub struct RateDevice<D> {
    puck: D,
    control: RateControl,
    workspace: [f64; 3],
    /// Metres.
    hand: [f64; 3],
    /// Metres a second that the puck asks for.
    velocity: [f64; 3],
    /// Radians; `None` where the puck cannot be twisted.
    twist: Option<f64>,
    /// Radians a second.
    spin: f64,
}

impl<D: Device> RateDevice<D> {
    /// A hand in a workspace of that size (metres), moved by `puck`, whose positions count from its
    /// middle.
    pub fn new(puck: D, control: RateControl, workspace: [f64; 3]) -> Result<Self, ParameterError> {
        check::workspace(workspace)?;
        check::positive("reach of the puck", control.reach)?;
        check::not_negative("dead_zone", control.dead_zone)?;
        check::not_negative("speed of the hand", control.speed)?;
        check::not_negative("turning", control.turning)?;
        check::positive("drag", control.drag)?;
        let hand = [0.0, 0.0, 0.5 * workspace[2]];
        let velocity = [0.0; 3];
        Ok(RateDevice { puck, control, workspace, hand, velocity, twist: None, spin: 0.0 })
    }

    /// Where the hand is, metres; [`read`](Device::read) tells it while the puck is seen.
    pub fn hand(&self) -> [f64; 3] {
        self.hand
    }

    /// Metres a second for a push of the puck: none in the dead zone, and no step where it ends.
    fn velocity(&self, push: f64) -> f64 {
        let (share, dead) = ((push / self.control.reach).clamp(-1.0, 1.0), self.control.dead_zone);
        let beyond = (share.abs() - dead).max(0.0) / (1.0 - dead).max(f64::MIN_POSITIVE);
        self.control.speed * beyond.min(1.0).copysign(share)
    }

    /// Moves the hand on by `dt` seconds, pushed by `force`.
    fn advance(&mut self, force: Force, dt: f64) {
        for axis in 0..3 {
            let speed = self.velocity[axis] + force.newtons[axis] / self.control.drag;
            let half = 0.5 * self.workspace[axis];
            let moved = (self.hand[axis] + speed * dt).clamp(-half, half);
            if moved.is_finite() {
                self.hand[axis] = moved;
            }
        }
        if let Some(twist) = &mut self.twist {
            let turned = *twist + self.spin * dt;
            if turned.is_finite() {
                *twist = turned;
            }
        }
    }
}

impl<D: Device> Device for RateDevice<D> {
    fn capabilities(&self) -> Capabilities {
        Capabilities {
            // A spring that pushes a drag b every T seconds is stable up to 2 b / T; half of it.
            max_stiffness: self.control.drag / NOMINAL_PERIOD,
            ..Capabilities::unlimited(self.workspace)
        }
    }

    fn read(&mut self, time: f64) -> Result<Pose, DeviceError> {
        let puck = match self.puck.read(time) {
            Ok(puck) => puck,
            Err(error) => {
                // A puck that is not seen steers nothing.
                (self.velocity, self.spin) = ([0.0; 3], 0.0);
                return Err(error);
            }
        };
        if !puck.is_finite() {
            (self.velocity, self.spin) = ([0.0; 3], 0.0);
            return Ok(Pose { position: puck.position, buttons: 0, twist: puck.twist });
        }
        self.velocity = puck.position.map(|push| self.velocity(push));
        if let Some(twist) = puck.twist {
            self.twist.get_or_insert(0.0);
            self.spin = self.control.turning * twist;
        }
        Ok(Pose { position: self.hand, buttons: puck.buttons, twist: self.twist })
    }

    fn write(&mut self, force: Force, dt: f64) -> Result<(), DeviceError> {
        if dt > 0.0 && dt.is_finite() && force.is_finite() {
            self.advance(force, dt);
        }
        self.puck.write(force, dt)
    }
}
