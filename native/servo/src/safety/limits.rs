//! The limits that hold in a session: the lower of the person's and the device's.

use devices::{Capabilities, Force};

use crate::Settings;

/// Seconds in which the force may swing from nothing to the largest one, where neither the device
/// nor the person wants it slower.
///
/// Ours, from two sides. A spring of K N/m met at v m/s asks for K v newtons a second: a tap with
/// 0.5 m/s on 3000 N/m, the stiffest that desktop devices show, asks for 1500 N/s, and how fast the
/// force rises is what makes it feel hard (rate-hardness: Lawrence and others, "Rate-hardness: a
/// new performance metric for haptic interfaces", 2000). 8 N in 5 ms are 1600 N/s, so such a tap
/// stays as crisp as it was. And a single wrong tick changes the force by a fifth of the largest
/// one at most, instead of by twice the largest one.
pub(crate) const FULL_SWING: f64 = 0.005;

/// What holds in a session, after the device's limits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// The largest force, N.
    pub max_force: f64,
    /// The fastest change of the force, N/s.
    pub max_slew: f64,
    /// The fastest hand that is still a hand's, m/s; infinite where nothing limits it.
    pub max_speed: f64,
    /// Of the spring, N/m.
    pub stiffness: f64,
    /// Of the spring that was asked for, N/m.
    pub asked_stiffness: f64,
}

impl Limits {
    pub(crate) fn new(settings: &Settings, capabilities: &Capabilities) -> Limits {
        let max_force = settings.max_force.min(capabilities.max_force);
        let slowest = settings.max_slew.min(capabilities.max_slew);
        Limits {
            max_force,
            max_slew: slowest.min(max_force / FULL_SWING),
            max_speed: settings.max_speed.min(capabilities.max_speed),
            stiffness: stable_stiffness(settings.stiffness, capabilities),
            asked_stiffness: settings.stiffness,
        }
    }
}

/// The stiffest spring that the device can show, up to `wanted`.
///
/// A delay of d ticks divides the stable stiffness by 1 + 2 d (Colgate and Schenkel's condition
/// with a delay).
fn stable_stiffness(wanted: f64, capabilities: &Capabilities) -> f64 {
    let delay = 1.0 + 2.0 * f64::from(capabilities.delay_ticks);
    wanted.min(capabilities.max_stiffness / delay)
}

/// The force cut to `limit` newtons with its direction kept, and whether it was cut. The force must
/// be finite.
pub(crate) fn clamped(force: Force, limit: f64) -> (Force, bool) {
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
        let mut device =
            Capabilities { max_stiffness: 3000.0, ..Capabilities::unlimited([0.1; 3]) };
        assert_eq!(stable_stiffness(500.0, &device), 500.0);
        assert_eq!(stable_stiffness(5000.0, &device), 3000.0);
        device.delay_ticks = 1;
        assert_eq!(stable_stiffness(5000.0, &device), 1000.0);
    }

    #[test]
    fn the_lower_of_two_limits_holds() {
        let unlimited = Capabilities::unlimited([0.1; 3]);
        let device = Capabilities { max_force: 4.0, max_slew: 100.0, max_speed: 2.0, ..unlimited };
        let persons =
            Settings { max_force: 2.0, max_slew: 50.0, max_speed: 1.0, ..Settings::default() };
        for (settings, capabilities, expected) in [
            (Settings::default(), device, (4.0, 100.0, 2.0)),
            (persons, device, (2.0, 50.0, 1.0)),
            (persons, unlimited, (2.0, 50.0, 1.0)),
            (Settings::default(), unlimited, (8.0, 8.0 / FULL_SWING, f64::INFINITY)),
        ] {
            let limits = Limits::new(&settings, &capabilities);
            assert_eq!((limits.max_force, limits.max_slew, limits.max_speed), expected);
        }
    }

    #[test]
    fn a_limit_of_zero_gives_no_force() {
        assert_eq!(
            clamped(Force { newtons: [1.0, -2.0, 3.0] }, 0.0),
            (Force { newtons: [0.0, -0.0, 0.0] }, true)
        );
        assert_eq!(clamped(Force::ZERO, 0.0), (Force::ZERO, false));
    }

    #[test]
    fn the_limit_is_of_the_whole_force_and_not_of_its_components() {
        let (cut, was_cut) = clamped(Force { newtons: [7.0, -7.0, 7.0] }, 8.0);
        assert!(was_cut);
        assert!((magnitude(cut) - 8.0).abs() < 1e-12, "{cut:?}");
        // 2, 3 and 6 are 7 together: a force at its limit passes as it is.
        let whole = Force { newtons: [2.0, -3.0, 6.0] };
        assert_eq!(clamped(whole, 7.0), (whole, false));
    }

    proptest! {
        #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

        #[test]
        fn the_limit_holds_for_every_finite_force(
            newtons in prop::array::uniform3(prop::num::f64::NORMAL | prop::num::f64::ZERO),
            limit in 0.0f64..100.0,
        ) {
            let (cut, was_cut) = clamped(Force { newtons }, limit);
            let rounding = 1.0 + 8.0 * f64::EPSILON;
            prop_assert!(magnitude(cut) <= limit * rounding);
            prop_assert!(was_cut || cut.newtons == newtons);
        }

        #[test]
        fn the_direction_is_kept(
            newtons in prop::array::uniform3(1.0f64..100.0), limit in 0.001f64..1.0,
        ) {
            let force = Force { newtons };
            let (cut, was_cut) = clamped(force, limit);
            prop_assert!(was_cut);
            let ratio = magnitude(cut) / magnitude(force);
            for (component, original) in cut.newtons.iter().zip(newtons) {
                prop_assert!((component / original / ratio - 1.0).abs() < 1e-12);
            }
        }
    }
}
