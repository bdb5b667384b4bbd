//! The mechanics of a simulated device: what stands between a hand and the servo.

use crate::{ParameterError, check};

/// The longest delay that a simulated device can have, ticks.
pub const LONGEST_DELAY: u32 = 1000;

/// What a simulated device adds to the hand that holds it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mechanism {
    /// Of the moving parts, kilograms; they move with the hand.
    pub mass: f64,
    /// Viscous friction of the bearings and motors, N s/m: the b of K < 2b/T.
    pub damping: f64,
    /// One count of the encoder, metres; 0 where positions are read as they are.
    pub metres_per_count: f64,
    /// Ticks from a write to the moment when its force acts.
    pub delay_ticks: u32,
    /// What it says of the stiffest spring it can show, N/m (see
    /// [`Capabilities::max_stiffness`](crate::Capabilities::max_stiffness)); `None` for half of
    /// what is stable with all of its damping and the hand's.
    pub max_stiffness: Option<f64>,
}

impl Default for Mechanism {
    /// Nothing but the hand: no mass, no friction, perfect encoders, no delay.
    fn default() -> Self {
        Mechanism {
            mass: 0.0,
            damping: 0.0,
            metres_per_count: 0.0,
            delay_ticks: 0,
            max_stiffness: None,
        }
    }
}

impl Mechanism {
    /// Checks every number.
    pub fn validate(&self) -> Result<(), ParameterError> {
        check::not_negative("device mass", self.mass)?;
        check::not_negative("device damping", self.damping)?;
        check::not_negative("metres_per_count", self.metres_per_count)?;
        check::limit("max_stiffness", self.max_stiffness.unwrap_or(0.0))?;
        if self.delay_ticks > LONGEST_DELAY {
            return Err(ParameterError {
                name: "delay_ticks",
                value: f64::from(self.delay_ticks),
                expected: "at most 1000",
            });
        }
        Ok(())
    }

    /// The position that the encoder tells: the nearest whole count.
    pub(crate) fn counted(&self, metres: f64) -> f64 {
        let counted = (metres / self.metres_per_count).round() * self.metres_per_count;
        // No encoder, or counts too fine for a double to number.
        if counted.is_finite() { counted } else { metres }
    }
}
