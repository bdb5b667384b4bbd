//! How fast the force may change.

use devices::Force;

use super::gate::RAMP;
use super::limits::clamped;

/// Lets the force change only so fast, and slower while another contact model takes over.
///
/// No force at all is never late: a [`cut`](Self::cut) goes past it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Slew {
    /// Newtons a second.
    rate: f64,
    /// Newtons a second while a model takes over: where the wanted force jumps although the hand
    /// did not move, the hand shall not feel it. As slow as the force is ramped in, and for the
    /// same reason.
    slow_rate: f64,
    /// Until the wanted force is reached.
    handing_over: bool,
    /// The force that acts.
    acting: Force,
}

impl Slew {
    /// For forces up to `max_force` newtons that change by up to `rate` newtons a second.
    pub(crate) fn new(rate: f64, max_force: f64) -> Slew {
        Slew {
            rate,
            slow_rate: rate_at_switch(rate, max_force),
            handing_over: false,
            acting: Force::ZERO,
        }
    }

    /// Another model answers from now on.
    pub(crate) fn hand_over(&mut self) {
        self.handing_over = true;
    }

    /// No force acts any more.
    pub(crate) fn cut(&mut self) {
        self.acting = Force::ZERO;
        self.handing_over = false;
    }

    /// The force on the way to `wanted`, which must be finite, `dt` seconds after the last one, and
    /// whether it is still on the way.
    pub(crate) fn limited(&mut self, wanted: Force, dt: f64) -> (Force, bool) {
        let rate = if self.handing_over { self.slow_rate } else { self.rate };
        let change = combined(wanted, self.acting, |wanted, acting| wanted - acting);
        let (change, was_cut) = clamped(change, rate * dt);
        self.acting = match was_cut {
            true => combined(self.acting, change, |acting, change| acting + change),
            false => wanted,
        };
        self.handing_over &= was_cut;
        (self.acting, was_cut)
    }
}

/// Newtons a second while another contact model takes over.
pub(crate) fn rate_at_switch(rate: f64, max_force: f64) -> f64 {
    rate.min(max_force / RAMP)
}

fn combined(one: Force, other: Force, combine: impl Fn(f64, f64) -> f64) -> Force {
    Force { newtons: std::array::from_fn(|axis| combine(one.newtons[axis], other.newtons[axis])) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const TICK: f64 = 0.001;

    fn upward(newtons: f64) -> Force {
        Force { newtons: [0.0, 0.0, newtons] }
    }

    fn magnitude(force: Force) -> f64 {
        let [x, y, z] = force.newtons;
        x.hypot(y).hypot(z)
    }

    fn between(one: Force, other: Force) -> f64 {
        magnitude(combined(one, other, |one, other| one - other))
    }

    /// Changes by up to 1.6 N a tick; while a model takes over by 0.16 N.
    fn slew() -> Slew {
        Slew::new(1600.0, 8.0)
    }

    #[test]
    fn the_largest_force_is_reached_in_five_milliseconds() {
        let mut slew = slew();
        for tick in 1..5 {
            let (force, was_cut) = slew.limited(upward(8.0), TICK);
            assert!(was_cut);
            assert!((force.newtons[2] - 1.6 * f64::from(tick)).abs() < 1e-12, "tick {tick}");
        }
        // Rounding may leave a hair to the last tick.
        slew.limited(upward(8.0), TICK);
        assert_eq!(slew.limited(upward(8.0), TICK), (upward(8.0), false));
    }

    #[test]
    fn another_model_takes_over_in_fifty_milliseconds_and_then_it_is_fast_again() {
        let mut slew = slew();
        slew.limited(upward(1.0), TICK);
        slew.hand_over();
        for tick in 1..40 {
            let force = slew.limited(upward(7.4), TICK).0;
            assert!((force.newtons[2] - 1.0 - 0.16 * f64::from(tick)).abs() < 1e-12, "tick {tick}");
        }
        slew.limited(upward(7.4), TICK);
        assert_eq!(slew.limited(upward(7.4), TICK), (upward(7.4), false));
        assert_eq!(slew.limited(upward(6.0), TICK), (upward(6.0), false));
    }

    #[test]
    fn after_a_cut_it_begins_at_nothing() {
        let mut slew = slew();
        slew.limited(upward(1.6), TICK);
        slew.limited(upward(3.2), TICK);
        slew.cut();
        assert_eq!(slew.limited(upward(3.2), TICK), (upward(1.6), true));
    }

    #[test]
    fn missed_ticks_are_time_to_change_in() {
        let mut slew = slew();
        assert_eq!(slew.limited(upward(8.0), 4.0 * TICK).0, upward(6.4));
        assert_eq!(slew.limited(upward(-8.0), 1.0), (upward(-8.0), false));
    }

    #[test]
    fn no_time_is_no_change_and_a_limit_of_zero_stays_at_zero() {
        let mut slew = slew();
        slew.limited(upward(1.0), TICK);
        assert_eq!(slew.limited(upward(8.0), 0.0), (upward(1.0), true));
        assert_eq!(Slew::new(0.0, 8.0).limited(upward(8.0), TICK), (upward(0.0), true));
        assert_eq!(Slew::new(0.0, 0.0).limited(Force::ZERO, TICK), (Force::ZERO, false));
    }

    #[test]
    fn the_way_to_another_force_is_straight() {
        let mut slew = Slew::new(100.0, 5.0);
        slew.limited(Force { newtons: [3.0, 0.0, 0.0] }, 1.0);
        let force = slew.limited(Force { newtons: [0.0, 4.0, 0.0] }, 0.01).0;
        let [x, y, z] = force.newtons;
        assert!((x - 2.4).abs() < 1e-12 && (y - 0.8).abs() < 1e-12 && z == 0.0, "{force:?}");
    }

    proptest! {
        #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

        #[test]
        fn the_limit_is_never_exceeded_and_the_wanted_force_is_reached(
            max_force in 0.001f64..100.0,
            wanted in prop::collection::vec(prop::array::uniform3(-1.0f64..1.0), 1..20),
            ticks in prop::collection::vec(1u32..5, 20),
            hands_over in prop::collection::vec(any::<bool>(), 20),
        ) {
            let force = |direction: [f64; 3]| {
                clamped(Force { newtons: direction.map(|share| max_force * share) }, max_force).0
            };
            let rounding = 8.0 * f64::EPSILON * max_force;
            let (rate, slow_rate) = (max_force / 0.005, max_force / RAMP);
            let mut slew = Slew::new(rate, max_force);
            let (mut acting, mut handing_over) = (Force::ZERO, false);
            for ((direction, ticks), hands_over) in wanted.iter().zip(&ticks).zip(&hands_over) {
                if *hands_over {
                    slew.hand_over();
                }
                handing_over |= *hands_over;
                let dt = f64::from(*ticks) * TICK;
                let (next, was_cut) = slew.limited(force(*direction), dt);
                prop_assert!(next.is_finite());
                prop_assert!(magnitude(next) <= max_force + rounding);
                let most = if handing_over { slow_rate } else { rate } * dt;
                prop_assert!(between(acting, next) <= most + rounding);
                prop_assert!(was_cut || next == force(*direction));
                handing_over &= was_cut;
                acting = next;
            }
            let last = force(*wanted.last().unwrap());
            // Two full swings, for the force may have to turn round, and a tick for rounding.
            for _ in 0..101 {
                acting = slew.limited(last, TICK).0;
            }
            prop_assert_eq!(acting, last);
        }
    }
}
