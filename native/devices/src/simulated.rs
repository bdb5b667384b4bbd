//! A simulated hand on a simulated device, so that touch can be tried and tested without either.

use std::collections::VecDeque;

use crate::motion::Motion;
use crate::{Capabilities, Device, DeviceError, Force, NOMINAL_PERIOD, ParameterError, Pose};
use crate::{Mechanism, check};

/// The numbers of a simulated hand.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hand {
    /// Where the muscle pulls at first, and where the hand starts, workspace metres.
    pub target: [f64; 3],
    /// Of hand and handle, kilograms.
    pub mass: f64,
    /// Of the muscle pulling the hand to its target, N/m.
    pub muscle_stiffness: f64,
    /// Of arm and device, N s/m.
    pub damping: f64,
    /// The largest force that the device gives, N.
    pub max_force: f64,
    /// Width, depth and height that the hand can reach, metres.
    pub workspace: [f64; 3],
}

impl Default for Hand {
    /// A relaxed hand (about 0.1 kg and 300 N/m at the fingers) on a desktop device.
    fn default() -> Self {
        Hand {
            target: [0.0, 0.0, 0.05],
            mass: 0.1,
            muscle_stiffness: 300.0,
            damping: 8.0,
            max_force: 8.0,
            workspace: [0.16, 0.12, 0.12],
        }
    }
}

/// A mass on a muscle spring and a damper, following a target, pushed by the force.
///
/// Force and target are held between two writes, and the motion under them is computed exactly,
/// so it is stable for every mass, spring, damper and step. On a [`Mechanism`] it is a rig for the
/// closed loop: a continuous hand, sampled, quantised and answered late.
#[derive(Clone, Debug)]
pub struct SimulatedDevice {
    hand: Hand,
    mechanism: Mechanism,
    /// Forces that were written and do not act yet, the oldest first.
    under_way: VecDeque<Force>,
    target: [f64; 3],
    position: [f64; 3],
    velocity: [f64; 3],
    /// Radians; `None` until somebody turns the handle.
    twist: Option<f64>,
}

impl SimulatedDevice {
    /// A hand resting at its target, on a device that adds nothing.
    pub fn new(hand: Hand) -> Result<Self, ParameterError> {
        // Where nothing else brakes, no spring at all would be stable without it.
        check::positive("damping", hand.damping)?;
        SimulatedDevice::held(hand, Mechanism::default())
    }

    /// A hand resting at its target, holding a device.
    pub fn held(hand: Hand, mechanism: Mechanism) -> Result<Self, ParameterError> {
        check::finite("target x", hand.target[0])?;
        check::finite("target y", hand.target[1])?;
        check::finite("target z", hand.target[2])?;
        check::positive("mass", hand.mass)?;
        check::positive("muscle_stiffness", hand.muscle_stiffness)?;
        check::not_negative("damping", hand.damping)?;
        check::positive("max_force", hand.max_force)?;
        check::workspace(hand.workspace)?;
        mechanism.validate()?;
        let mut device = SimulatedDevice {
            hand,
            mechanism,
            // Room for one more than wait, so that a write never allocates.
            under_way: VecDeque::with_capacity(mechanism.delay_ticks as usize + 1),
            target: hand.target,
            position: hand.target,
            velocity: [0.0; 3],
            twist: None,
        };
        device.empty_line(Force::ZERO);
        Ok(device)
    }

    /// Where the hand is, metres; [`read`](Device::read) tells what the encoder says of it.
    pub fn position(&self) -> [f64; 3] {
        self.position
    }

    /// Metres a second.
    pub fn velocity(&self) -> [f64; 3] {
        self.velocity
    }

    /// Joules of motion and of the muscle spring, without an outer force.
    pub fn energy(&self) -> f64 {
        let mut energy = 0.0;
        for axis in 0..3 {
            let stretch = self.position[axis] - self.target[axis];
            energy += 0.5 * self.mass() * self.velocity[axis].powi(2);
            energy += 0.5 * self.hand.muscle_stiffness * stretch.powi(2);
        }
        energy
    }

    fn mass(&self) -> f64 {
        self.hand.mass + self.mechanism.mass
    }

    fn damping(&self) -> f64 {
        self.hand.damping + self.mechanism.damping
    }

    /// Nothing else is under way than `force`.
    fn empty_line(&mut self, force: Force) {
        self.under_way.clear();
        self.under_way.resize(self.mechanism.delay_ticks as usize, force);
    }

    /// Sends `force` on its way, and gives the one that arrives.
    fn delayed(&mut self, force: Force) -> Force {
        self.under_way.push_back(force);
        self.under_way.pop_front().unwrap_or(force)
    }

    fn advance(&mut self, force: Force, dt: f64) {
        let motion = Motion::over(self.mass(), self.hand.muscle_stiffness, self.damping(), dt);
        for axis in 0..3 {
            // Where the hand would come to rest under this force.
            let rest = self.target[axis] + force.newtons[axis] / self.hand.muscle_stiffness;
            if !rest.is_finite() {
                continue;
            }
            let offset = self.position[axis] - rest;
            let (offset, velocity) = motion.apply(offset, self.velocity[axis]);
            let position = rest + offset;
            // Numbers beyond the range of a double: such a spring has come to rest long ago.
            let settled = !(position.is_finite() && velocity.is_finite());
            self.position[axis] = if settled { rest } else { position };
            self.velocity[axis] = if settled { 0.0 } else { velocity };
        }
    }
}

impl Device for SimulatedDevice {
    fn capabilities(&self) -> Capabilities {
        Capabilities {
            max_force: self.hand.max_force,
            // A sampled spring K adds energy unless K < 2 b / T (Colgate and Schenkel, "Passivity
            // of a class of sampled-data systems", 1994); half of that leaves room for missed ticks.
            max_stiffness: self.mechanism.max_stiffness.unwrap_or(self.damping() / NOMINAL_PERIOD),
            delay_ticks: self.mechanism.delay_ticks,
            // A muscle never lets go, so there is no speed at which the handle has slipped.
            ..Capabilities::unlimited(self.hand.workspace)
        }
    }

    fn read(&mut self, _time: f64) -> Result<Pose, DeviceError> {
        let position = self.position.map(|metres| self.mechanism.counted(metres));
        Ok(Pose { twist: self.twist, ..Pose::at(position) })
    }

    fn write(&mut self, force: Force, dt: f64) -> Result<(), DeviceError> {
        let force = if force.is_finite() { force } else { Force::ZERO };
        if dt > 0.0 && dt.is_finite() {
            let acting = self.delayed(force);
            self.advance(acting, dt);
        } else {
            // A session's last write: until the next one, whatever was under way has arrived.
            self.empty_line(force);
        }
        Ok(())
    }

    fn set_target(&mut self, target: [f64; 3]) {
        if target.iter().all(|metres| metres.is_finite()) {
            self.target = target;
        }
    }

    fn set_twist(&mut self, radians: f64) {
        if radians.is_finite() {
            self.twist = Some(radians);
        }
    }
}
