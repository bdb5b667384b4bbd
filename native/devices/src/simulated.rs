//! A simulated hand, so that touch can be tried and tested without a device.

use crate::check;
use crate::{Capabilities, Device, DeviceError, Force, NOMINAL_PERIOD, ParameterError, Pose};

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
/// so it is stable for every mass, spring, damper and step.
#[derive(Clone, Debug)]
pub struct SimulatedDevice {
    hand: Hand,
    target: [f64; 3],
    position: [f64; 3],
    velocity: [f64; 3],
}

impl SimulatedDevice {
    /// A hand resting at its target.
    pub fn new(hand: Hand) -> Result<Self, ParameterError> {
        check::finite("target x", hand.target[0])?;
        check::finite("target y", hand.target[1])?;
        check::finite("target z", hand.target[2])?;
        check::positive("mass", hand.mass)?;
        check::positive("muscle_stiffness", hand.muscle_stiffness)?;
        check::positive("damping", hand.damping)?;
        check::positive("max_force", hand.max_force)?;
        check::workspace(hand.workspace)?;
        Ok(SimulatedDevice { hand, target: hand.target, position: hand.target, velocity: [0.0; 3] })
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
            energy += 0.5 * self.hand.mass * self.velocity[axis].powi(2);
            energy += 0.5 * self.hand.muscle_stiffness * stretch.powi(2);
        }
        energy
    }

    fn advance(&mut self, force: Force, dt: f64) {
        let motion = Motion::over(&self.hand, dt);
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

/// The exact motion of a damped spring over one step, as a linear map of offset and velocity:
/// the exponential of [[0, 1], [-stiffness / mass, -damping / mass]] times the step.
#[derive(Clone, Copy, Debug)]
struct Motion {
    offset_from_offset: f64,
    offset_from_velocity: f64,
    velocity_from_offset: f64,
    velocity_from_velocity: f64,
}

impl Motion {
    fn over(hand: &Hand, dt: f64) -> Motion {
        let decay = hand.damping / (2.0 * hand.mass); // 1/s
        let spring = hand.muscle_stiffness / hand.mass; // 1/s^2
        let discriminant = decay * decay - spring;
        // `even` and `odd` are exp(-decay dt) times cosh(s dt) and sinh(s dt) / s, with s the root
        // of the discriminant; for an imaginary s these are cos and sin.
        let (even, odd) = if discriminant > 0.0 {
            let root = discriminant.sqrt();
            // decay - root, without the cancellation in a strongly damped hand.
            let slow = spring / (decay + root);
            let slow_part = (-slow * dt).exp();
            let fast_part = (-(decay + root) * dt).exp();
            let odd = -slow_part * (-2.0 * root * dt).exp_m1() / (2.0 * root);
            (0.5 * (slow_part + fast_part), odd)
        } else if discriminant < 0.0 {
            let frequency = (-discriminant).sqrt();
            let envelope = (-decay * dt).exp();
            let (sine, cosine) = (frequency * dt).sin_cos();
            (envelope * cosine, envelope * sine / frequency)
        } else {
            let envelope = (-decay * dt).exp();
            (envelope, envelope * dt)
        };
        Motion {
            offset_from_offset: even + decay * odd,
            offset_from_velocity: odd,
            velocity_from_offset: -spring * odd,
            velocity_from_velocity: even - decay * odd,
        }
    }

    fn apply(&self, offset: f64, velocity: f64) -> (f64, f64) {
        (
            self.offset_from_offset * offset + self.offset_from_velocity * velocity,
            self.velocity_from_offset * offset + self.velocity_from_velocity * velocity,
        )
    }
}

impl Device for SimulatedDevice {
    fn capabilities(&self) -> Capabilities {
        Capabilities {
            max_force: self.hand.max_force,
            // A sampled spring K adds energy unless K < 2 b / T (Colgate and Schenkel, "Passivity
            // of a class of sampled-data systems", 1994); half of that leaves room for missed ticks.
            max_stiffness: self.hand.damping / NOMINAL_PERIOD,
            // A muscle never lets go, so there is no speed at which the handle has slipped.
            ..Capabilities::unlimited(self.hand.workspace)
        }
    }

    fn read(&mut self, _time: f64) -> Result<Pose, DeviceError> {
        Ok(Pose::at(self.position))
    }

    fn write(&mut self, force: Force, dt: f64) -> Result<(), DeviceError> {
        let force = if force.is_finite() { force } else { Force::ZERO };
        if dt > 0.0 && dt.is_finite() {
            self.advance(force, dt);
        }
        Ok(())
    }

    fn set_target(&mut self, target: [f64; 3]) {
        if target.iter().all(|metres| metres.is_finite()) {
            self.target = target;
        }
    }
}
