//! The simulated hand obeys physics for all parameters and steps.

use devices::{Device, Force, Hand, SimulatedDevice};
use proptest::prelude::*;

/// Rounding of a few thousand exact steps, relative to what is compared.
const ROUNDING: f64 = 1e-9;

fn position(device: &mut SimulatedDevice) -> [f64; 3] {
    device.read(0.0).expect("a simulated hand never fails").position
}

fn push(device: &mut SimulatedDevice, newtons: [f64; 3], dt: f64) {
    device.write(Force { newtons }, dt).expect("a simulated hand never fails");
}

fn hand(mass: f64, muscle_stiffness: f64, damping: f64) -> SimulatedDevice {
    SimulatedDevice::new(Hand {
        mass,
        muscle_stiffness,
        damping,
        target: [0.0; 3],
        ..Hand::default()
    })
    .expect("positive parameters")
}

/// Powers of ten from 1e-6 to 1e6.
fn any_scale() -> impl Strategy<Value = f64> {
    (-6.0f64..6.0).prop_map(|exponent| 10f64.powf(exponent))
}

/// Seconds from 1e-6 to 0.1.
fn any_step() -> impl Strategy<Value = f64> {
    (-6.0f64..-1.0).prop_map(|exponent| 10f64.powf(exponent))
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn energy_never_grows_without_force(
        mass in any_scale(), stiffness in any_scale(), damping in any_scale(), dt in any_step(),
        kick in -8.0f64..8.0,
    ) {
        let mut device = hand(mass, stiffness, damping);
        push(&mut device, [kick, -kick, 0.5 * kick], dt);
        let mut before = device.energy();
        for _ in 0..200 {
            push(&mut device, [0.0; 3], dt);
            let after = device.energy();
            prop_assert!(after <= before * (1.0 + ROUNDING), "{before} J became {after} J");
            before = after;
            // Where numbers run out of bits, rounding is no longer relative.
            if before < f64::MIN_POSITIVE / ROUNDING {
                break;
            }
        }
    }

    #[test]
    fn the_hand_comes_to_rest_at_its_target(
        mass in any_scale(), stiffness in any_scale(), damping in any_scale(),
        target in prop::array::uniform3(-1.0f64..1.0),
    ) {
        let mut device = hand(mass, stiffness, damping);
        device.set_target(target);
        // Forty times the slowest time constant, in a hundred steps.
        let slowest = (2.0 * mass / damping).max(damping / stiffness);
        for _ in 0..100 {
            push(&mut device, [0.0; 3], 0.4 * slowest);
        }
        for (metres, wanted) in position(&mut device).iter().zip(target) {
            prop_assert!((metres - wanted).abs() < ROUNDING);
        }
    }

    #[test]
    fn a_held_force_displaces_by_force_over_stiffness(
        mass in any_scale(), stiffness in any_scale(), damping in any_scale(),
        force in -8.0f64..8.0,
    ) {
        let mut device = hand(mass, stiffness, damping);
        let slowest = (2.0 * mass / damping).max(damping / stiffness);
        for _ in 0..100 {
            push(&mut device, [0.0, force, 0.0], 0.4 * slowest);
        }
        let displacement = force / stiffness;
        let found = position(&mut device);
        prop_assert!((found[1] - displacement).abs() <= displacement.abs() * ROUNDING);
        prop_assert_eq!(found[0], 0.0);
    }

    #[test]
    fn many_small_steps_are_one_large_step(
        mass in 0.01f64..1.0, stiffness in 10.0f64..2000.0, damping in 0.1f64..50.0,
    ) {
        let mut fine = hand(mass, stiffness, damping);
        let mut coarse = fine.clone();
        for _ in 0..64 {
            push(&mut fine, [1.0, 2.0, 3.0], 1.0 / 1024.0);
        }
        push(&mut coarse, [1.0, 2.0, 3.0], 64.0 / 1024.0);
        let scale = 3.0 / stiffness;
        for (one, other) in position(&mut fine).iter().zip(position(&mut coarse)) {
            prop_assert!((one - other).abs() < scale * ROUNDING);
        }
    }

    #[test]
    fn nothing_becomes_infinite_or_nan(
        mass in any_scale(), stiffness in any_scale(), damping in any_scale(),
        dt in prop::sample::select(vec![1e-6, 1e-3, 0.1, 10.0, 1e9, 1e300, f64::MAX]),
        forces in prop::collection::vec(prop::num::f64::ANY, 30),
    ) {
        let mut device = hand(mass, stiffness, damping);
        for force in forces {
            push(&mut device, [force, 1.0, -force], dt);
            prop_assert!(position(&mut device).iter().all(|metres| metres.is_finite()));
            prop_assert!(device.velocity().iter().all(|speed| speed.is_finite()));
        }
    }

    #[test]
    fn even_absurd_parameters_stay_finite(
        mass in prop::num::f64::POSITIVE, stiffness in prop::num::f64::POSITIVE,
        damping in prop::num::f64::POSITIVE, dt in prop::num::f64::POSITIVE,
        force in prop::num::f64::NORMAL,
    ) {
        prop_assume!([mass, stiffness, damping].iter().all(|value| value.is_finite() && *value > 0.0));
        let mut device = hand(mass, stiffness, damping);
        for _ in 0..5 {
            push(&mut device, [force, -force, 0.0], dt);
            prop_assert!(position(&mut device).iter().all(|metres| metres.is_finite()));
        }
    }
}

#[test]
fn a_hand_starts_at_rest_at_its_target() {
    let mut device = SimulatedDevice::new(Hand::default()).unwrap();
    push(&mut device, [0.0; 3], 0.001);
    assert_eq!(position(&mut device), Hand::default().target);
    assert_eq!(device.energy(), 0.0);
}

#[test]
fn no_time_no_motion() {
    let mut device = SimulatedDevice::new(Hand::default()).unwrap();
    for dt in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        push(&mut device, [5.0; 3], dt);
        assert_eq!(position(&mut device), Hand::default().target);
    }
}

#[test]
fn bad_numbers_do_not_reach_the_hand() {
    let mut device = SimulatedDevice::new(Hand::default()).unwrap();
    push(&mut device, [f64::NAN, f64::INFINITY, 1.0], 0.001);
    device.set_target([f64::NAN, 0.0, 0.0]);
    push(&mut device, [0.0; 3], 0.001);
    assert_eq!(position(&mut device), Hand::default().target);
}

#[test]
fn bad_parameters_are_refused_by_name() {
    let good = Hand::default();
    let bad = [
        (Hand { mass: 0.0, ..good }, "mass"),
        (Hand { muscle_stiffness: -1.0, ..good }, "muscle_stiffness"),
        (Hand { damping: f64::NAN, ..good }, "damping"),
        (Hand { max_force: f64::INFINITY, ..good }, "max_force"),
        (Hand { target: [0.0, f64::NAN, 0.0], ..good }, "target y"),
        (Hand { workspace: [0.1, 0.1, 0.0], ..good }, "workspace height"),
    ];
    for (hand, name) in bad {
        assert_eq!(SimulatedDevice::new(hand).unwrap_err().name, name);
    }
}
