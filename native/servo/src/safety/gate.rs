//! The gate that every force goes through: shut or closed by the watchdogs, opened slowly.

use super::stages::{Stage, Stages};

/// Seconds in which the force rises from nothing to its whole.
///
/// Ours: what the hand feels as a knock is what shakes it at tens to hundreds of hertz, where the
/// Pacinian corpuscles answer (best near 250 Hz); a ramp of 50 ms has little there. At 8 N it is
/// 160 N/s, or 0.16 N a tick.
pub(crate) const RAMP: f64 = 0.05;

/// Seconds of the slowest ramp: a force that was away for long comes back over as long as it was
/// away, up to this. Ours: a person reacts to a touch in about 0.15 to 0.2 s, so a hand that sank
/// meanwhile can yield to the force before it is whole.
pub(crate) const LONGEST_RAMP: f64 = 0.5;

/// Seconds in which a watchdog takes the force away: "a few milliseconds", as fast as the slew limit
/// lets the whole force change.
pub(crate) const FALL: f64 = 0.005;

/// What rounding leaves of a gate that has closed in equal steps.
const CRACK: f64 = 1e-9;

/// How far the way is open for the force.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Gate {
    /// From 0, no force, to 1, all of it.
    open: f64,
    /// Someone wants it closed in this tick.
    closing: bool,
    /// Someone wants no force at all in this tick.
    shut: bool,
    /// Seconds without a reason to close it before it opens.
    calm: f64,
    /// Seconds since it was open last, engaging not counted.
    away: f64,
}

impl Gate {
    /// No force to begin with; it opens from this tick on, if nobody wants it closed.
    pub(crate) fn engage(&mut self) {
        self.open = 0.0;
    }

    /// No force from this tick on, until `calm` seconds after the last call.
    pub(crate) fn shut(&mut self, calm: f64) {
        self.shut = true;
        self.calm = self.calm.max(calm);
    }

    /// Less force from this tick on, and soon none, until `calm` seconds after the last call.
    pub(crate) fn close(&mut self, calm: f64) {
        self.closing = true;
        self.calm = self.calm.max(calm);
    }

    /// The share of the force that may pass in a tick, `dt` seconds after the last one.
    pub(crate) fn pass(&mut self, dt: f64, stages: Stages) -> f64 {
        if self.shut {
            self.open = 0.0;
            self.away += dt;
        } else if self.closing {
            self.fall(dt);
        } else if self.calm > 0.0 {
            self.calm -= dt;
            self.fall(dt);
        } else if stages.are_on(Stage::Ramp) {
            self.open = (self.open + dt / self.away.clamp(RAMP, LONGEST_RAMP)).min(1.0);
        } else {
            self.open = 1.0;
        }
        if self.open == 1.0 {
            self.away = 0.0;
        }
        (self.shut, self.closing) = (false, false);
        self.open
    }

    fn fall(&mut self, dt: f64) {
        self.open -= dt / FALL;
        if self.open < CRACK {
            self.open = 0.0;
        }
        self.away += dt;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TICK: f64 = 0.001;

    fn opened() -> Gate {
        let mut gate = Gate::default();
        pass(&mut gate, 60);
        gate
    }

    fn pass(gate: &mut Gate, ticks: u32) -> f64 {
        (0..ticks).fold(f64::NAN, |_, _| gate.pass(TICK, Stages::default()))
    }

    #[test]
    fn it_opens_in_fifty_milliseconds() {
        let mut gate = Gate::default();
        assert!((pass(&mut gate, 1) - 0.02).abs() < 1e-12);
        assert!((pass(&mut gate, 24) - 0.5).abs() < 1e-12);
        // Rounding may leave a hair to the last tick.
        assert!((pass(&mut gate, 25) - 1.0).abs() < 1e-12);
        assert_eq!(pass(&mut gate, 1), 1.0);
    }

    #[test]
    fn it_shuts_at_once_and_opens_again_from_the_next_tick() {
        let mut gate = opened();
        gate.shut(0.0);
        assert_eq!(pass(&mut gate, 1), 0.0);
        assert!((pass(&mut gate, 1) - 0.02).abs() < 1e-12);
    }

    #[test]
    fn it_closes_in_five_milliseconds_and_waits_for_calm() {
        let mut gate = opened();
        gate.close(0.01);
        assert!((pass(&mut gate, 1) - 0.8).abs() < 1e-12);
        assert!(pass(&mut gate, 3) > 0.0);
        assert_eq!(pass(&mut gate, 1), 0.0);
        assert_eq!(pass(&mut gate, 6), 0.0, "ten milliseconds of calm, five of them closing");
        assert!(pass(&mut gate, 2) > 0.0);
    }

    #[test]
    fn a_long_tick_closes_it_as_much_as_many_short_ones() {
        let mut gate = opened();
        gate.close(0.01);
        assert_eq!(gate.pass(0.1, Stages::default()), 0.0);
    }

    #[test]
    fn a_force_that_was_away_for_long_comes_back_as_slowly() {
        for (away, ramp) in [(100, 100), (400, 400), (10_000, 500)] {
            let mut gate = opened();
            for _ in 0..away {
                gate.shut(0.0);
                assert_eq!(pass(&mut gate, 1), 0.0);
            }
            assert!((pass(&mut gate, ramp / 2) - 0.5).abs() < 1e-9);
        }
    }
}
