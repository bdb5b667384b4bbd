//! The stiffest spring that comes to rest, by bisection.

use crate::stability::trial::Trial;
use std::error::Error;

/// Halvings: of a factor of 8, to a thousandth.
const HALVINGS: u32 = 12;

/// What was found, beside what theory says, N/m.
#[derive(Clone, Copy, Debug)]
pub struct Boundary {
    /// Measured.
    pub measured: f64,
    /// K < 2b/((1 + 2d)T).
    pub passive: f64,
    /// Of this plant, exactly.
    pub exact: f64,
    /// Ticks with springs that were no stiffer than the passive bound.
    pub passive_ticks: u64,
    /// Those in which the observer found such a spring active.
    pub false_alarms: u64,
}

impl Boundary {
    /// The stiffness at which `trial` begins to swing, between a quarter of the passive bound and
    /// eight times as much.
    pub fn of(trial: &Trial) -> Result<Self, Box<dyn Error>> {
        let plant = trial.plant();
        let passive = plant.passive_bound();
        let (mut stable, mut unstable) = (0.25 * passive, 8.0 * passive);
        let (mut false_alarms, mut passive_ticks) = (0, 0);
        for _ in 0..HALVINGS {
            let middle = (stable * unstable).sqrt();
            let outcome = trial.run(middle)?;
            if middle <= passive {
                passive_ticks += outcome.ticks;
                false_alarms += outcome.active_ticks;
            }
            if outcome.is_stable { stable = middle } else { unstable = middle }
        }
        let exact = plant.exact_boundary();
        Ok(Self { measured: stable, passive, exact, passive_ticks, false_alarms })
    }

    /// Measured over the passive bound.
    pub fn ratio(&self) -> f64 {
        self.measured / self.passive
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::stability::ground::Ground;
    use crate::stability::trial::{mechanism, weight};
    use crate::stability::{NO_SWING, pressed};

    #[test]
    fn without_an_encoder_the_servo_meets_the_exact_boundary() {
        let flat = Ground::flat().unwrap();
        for delay in [0, 1, 2] {
            let pressed = pressed(&flat, weight(), 2.0, delay);
            let smooth = Trial { rest: NO_SWING, mechanism: mechanism(2.0, delay, 0.0), ..pressed };
            let found = Boundary::of(&smooth).unwrap();
            let ratio = found.measured / found.exact;
            assert!((ratio - 1.0).abs() < 2e-3, "{delay} ticks late: {ratio}");
            assert_eq!(found.false_alarms, 0);
        }
    }
}
