//! The force of the spring, and its limits.

use devices::{Capabilities, Force, NOMINAL_PERIOD};

/// A spring of `stiffness` N/m stretched by `displacement` metres.
pub(crate) fn spring(stiffness: f64, displacement: [f64; 3]) -> Force {
    Force { newtons: displacement.map(|metres| stiffness * metres) }
}

/// The stiffest spring that the device can show, up to `wanted`.
///
/// A delay of d ticks divides the stable stiffness by 1 + 2 d (Colgate and Schenkel's condition
/// with a delay).
pub(crate) fn stable_stiffness(wanted: f64, capabilities: &Capabilities) -> f64 {
    let delay = 1.0 + 2.0 * f64::from(capabilities.delay_ticks);
    wanted.min(capabilities.max_stiffness / delay)
}

/// The damping, N s/m, that a device must have at least to show the stiffness that it declares:
/// K < 2b/T (Colgate and Schenkel, 1997).
pub(crate) fn declared_damping(capabilities: &Capabilities) -> f64 {
    0.5 * capabilities.max_stiffness * NOMINAL_PERIOD
}

/// The force cut to `limit` newtons with its direction kept, and whether it was cut. The force must
/// be finite.
pub(crate) fn limited(force: Force, limit: f64) -> (Force, bool) {
    let largest = force.newtons.iter().fold(0.0f64, |most, component| most.max(component.abs()));
    if largest == 0.0 {
        return (force, false);
    }
    // Divided by the largest component first, so that squares neither overflow nor vanish.
    let direction = force.newtons.map(|component| component / largest);
    let length = direction.iter().map(|component| component * component).sum::<f64>().sqrt();
    if largest <= limit / length {
        return (force, false);
    }
    (Force { newtons: direction.map(|component| component * (limit / length)) }, true)
}

/// Seconds in which a force under a [`SlewLimit`] may rise from nothing to the largest one.
///
/// Ours: what the hand feels as a knock is what shakes it at tens to hundreds of hertz, where the
/// Pacinian corpuscles answer (best near 250 Hz); a ramp of 50 ms has little there. And it is over
/// before a person could react: at 8 N it is 160 N/s, or 0.16 N a tick.
const FULL_SWING: f64 = 0.05;

/// Lets the force change only so fast, from when it is engaged until the wanted force is reached.
///
/// Where the wanted force may jump although the hand did not (another contact model answers), the
/// limit is engaged with the force that acts. Otherwise it lets every force through as it is.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SlewLimit {
    /// Newtons a second.
    rate: f64,
    /// The force that acts, while the limit is engaged.
    acting: Option<Force>,
}

impl SlewLimit {
    /// Not engaged, for forces up to `max_force` newtons.
    pub(crate) fn new(max_force: f64) -> SlewLimit {
        SlewLimit { rate: max_force / FULL_SWING, acting: None }
    }

    /// Limits the changes from `acting` on, which must be finite.
    pub(crate) fn engage(&mut self, acting: Force) {
        self.acting = Some(acting);
    }

    /// Lets every force through: for what must act at once, such as no force at all.
    pub(crate) fn disengage(&mut self) {
        self.acting = None;
    }

    /// The force on the way to `wanted`, which must be finite, `dt` seconds after the last one.
    pub(crate) fn limited(&mut self, wanted: Force, dt: f64) -> Force {
        let Some(acting) = self.acting else { return wanted };
        let change = combined(wanted, acting, |wanted, acting| wanted - acting);
        let (change, was_cut) = limited(change, self.rate * dt);
        let force = if was_cut {
            combined(acting, change, |acting, change| acting + change)
        } else {
            wanted
        };
        self.acting = was_cut.then_some(force);
        force
    }
}

fn combined(one: Force, other: Force, combine: impl Fn(f64, f64) -> f64) -> Force {
    Force { newtons: std::array::from_fn(|axis| combine(one.newtons[axis], other.newtons[axis])) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn magnitude(force: Force) -> f64 {
        let [x, y, z] = force.newtons;
        x.hypot(y).hypot(z)
    }

    #[test]
    fn a_delay_of_one_tick_costs_two_thirds_of_the_stiffness() {
        let mut device = Capabilities {
            workspace: [0.1; 3],
            max_force: 8.0,
            max_stiffness: 3000.0,
            delay_ticks: 0,
        };
        assert_eq!(stable_stiffness(500.0, &device), 500.0);
        assert_eq!(stable_stiffness(5000.0, &device), 3000.0);
        device.delay_ticks = 1;
        assert_eq!(stable_stiffness(5000.0, &device), 1000.0);
    }

    #[test]
    fn a_limit_of_zero_gives_no_force() {
        assert_eq!(
            limited(Force { newtons: [1.0, -2.0, 3.0] }, 0.0),
            (Force { newtons: [0.0, -0.0, 0.0] }, true)
        );
        assert_eq!(limited(Force::ZERO, 0.0), (Force::ZERO, false));
    }

    #[test]
    fn the_limit_is_of_the_whole_force_and_not_of_its_components() {
        let (cut, was_cut) = limited(Force { newtons: [7.0, -7.0, 7.0] }, 8.0);
        assert!(was_cut);
        assert!((magnitude(cut) - 8.0).abs() < 1e-12, "{cut:?}");
        // 2, 3 and 6 are 7 together: a force at its limit passes as it is.
        let whole = Force { newtons: [2.0, -3.0, 6.0] };
        assert_eq!(limited(whole, 7.0), (whole, false));
    }

    const TICK: f64 = 0.001;

    fn upward(newtons: f64) -> Force {
        Force { newtons: [0.0, 0.0, newtons] }
    }

    fn between(one: Force, other: Force) -> f64 {
        magnitude(combined(one, other, |one, other| one - other))
    }

    #[test]
    fn a_slew_limit_that_is_not_engaged_lets_every_force_through() {
        let mut limit = SlewLimit::new(8.0);
        assert_eq!(limit.limited(upward(8.0), TICK), upward(8.0));
        limit.engage(Force::ZERO);
        limit.disengage();
        assert_eq!(limit.limited(upward(8.0), TICK), upward(8.0));
    }

    #[test]
    fn the_largest_force_is_reached_in_fifty_milliseconds() {
        let mut limit = SlewLimit::new(8.0);
        limit.engage(Force::ZERO);
        for tick in 1..50 {
            let force = limit.limited(upward(8.0), TICK);
            assert!((force.newtons[2] - 0.16 * f64::from(tick)).abs() < 1e-12, "tick {tick}");
        }
        // Rounding may leave a hair to the last tick.
        limit.limited(upward(8.0), TICK);
        assert_eq!(limit.limited(upward(8.0), TICK), upward(8.0));
        assert_eq!(limit.limited(upward(-8.0), TICK), upward(-8.0), "it has let go by itself");
    }

    #[test]
    fn missed_ticks_are_time_to_change_in() {
        let mut limit = SlewLimit::new(8.0);
        limit.engage(upward(1.0));
        assert!((limit.limited(upward(8.0), 10.0 * TICK).newtons[2] - 2.6).abs() < 1e-12);
        assert_eq!(limit.limited(upward(8.0), 1.0), upward(8.0));
    }

    #[test]
    fn no_time_is_no_change_and_a_limit_of_zero_stays_at_zero() {
        let mut limit = SlewLimit::new(8.0);
        limit.engage(upward(1.0));
        assert_eq!(limit.limited(upward(8.0), 0.0), upward(1.0));
        let mut none = SlewLimit::new(0.0);
        none.engage(Force::ZERO);
        assert_eq!(none.limited(Force::ZERO, TICK), Force::ZERO);
    }

    #[test]
    fn the_way_to_another_force_is_straight() {
        let mut limit = SlewLimit::new(5.0);
        limit.engage(Force { newtons: [3.0, 0.0, 0.0] });
        let force = limit.limited(Force { newtons: [0.0, 4.0, 0.0] }, 0.01);
        let [x, y, z] = force.newtons;
        assert!((x - 2.4).abs() < 1e-12 && (y - 0.8).abs() < 1e-12 && z == 0.0, "{force:?}");
    }

    proptest! {
        #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

        #[test]
        fn the_limit_holds_for_every_finite_force(
            newtons in prop::array::uniform3(prop::num::f64::NORMAL | prop::num::f64::ZERO),
            limit in 0.0f64..100.0,
        ) {
            let (cut, was_cut) = limited(Force { newtons }, limit);
            let rounding = 1.0 + 8.0 * f64::EPSILON;
            prop_assert!(magnitude(cut) <= limit * rounding);
            prop_assert!(was_cut || cut.newtons == newtons);
        }

        #[test]
        fn a_slew_limit_is_never_exceeded_and_the_wanted_force_is_reached(
            max_force in 0.001f64..100.0,
            from in prop::array::uniform3(-1.0f64..1.0),
            wanted in prop::collection::vec(prop::array::uniform3(-1.0f64..1.0), 1..20),
            ticks in prop::collection::vec(1u32..5, 20),
        ) {
            let force = |direction: [f64; 3]| {
                limited(Force { newtons: direction.map(|share| max_force * share) }, max_force).0
            };
            let rounding = 8.0 * f64::EPSILON * max_force;
            let mut limit = SlewLimit::new(max_force);
            let mut acting = force(from);
            limit.engage(acting);
            for (direction, ticks) in wanted.iter().zip(&ticks) {
                let dt = f64::from(*ticks) * TICK;
                let next = limit.limited(force(*direction), dt);
                prop_assert!(next.is_finite());
                prop_assert!(magnitude(next) <= max_force + rounding);
                let change = between(acting, next);
                prop_assert!(change <= max_force / FULL_SWING * dt + rounding);
                if change < max_force / FULL_SWING * dt - rounding {
                    prop_assert_eq!(next, force(*direction));
                    // It has let go: what comes after it is not limited any more.
                    return Ok(());
                }
                acting = next;
            }
            let last = force(*wanted.last().unwrap());
            // Two full swings, for the force may have to turn round, and a tick for rounding.
            for _ in 0..101 {
                acting = limit.limited(last, TICK);
            }
            prop_assert_eq!(acting, last);
        }

        #[test]
        fn the_direction_is_kept(
            newtons in prop::array::uniform3(1.0f64..100.0), limit in 0.001f64..1.0,
        ) {
            let force = Force { newtons };
            let (cut, was_cut) = limited(force, limit);
            prop_assert!(was_cut);
            let ratio = magnitude(cut) / magnitude(force);
            for (component, original) in cut.newtons.iter().zip(newtons) {
                prop_assert!((component / original / ratio - 1.0).abs() < 1e-12);
            }
        }
    }
}
