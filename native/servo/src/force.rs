//! The force of the spring, and its limit.

use devices::{Capabilities, Force};

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
