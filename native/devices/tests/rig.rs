//! The rig, a simulated hand on a simulated device: physics against closed solutions, encoder and
//! delay exact, and finite whatever the numbers.

use devices::{Device, Force, Grip, Hand, LONGEST_DELAY, Mechanism, NOMINAL_PERIOD};
use devices::{Pose, SimulatedDevice};
use proptest::prelude::*;

/// Rounding of a few thousand exact steps, relative to what is compared.
const ROUNDING: f64 = 1e-9;

fn read(device: &mut SimulatedDevice) -> Pose {
    device.read(0.0).expect("a simulated device never fails")
}

fn push(device: &mut SimulatedDevice, newtons: f64, dt: f64) {
    device
        .write(Force { newtons: [newtons, 0.0, 0.0] }, dt)
        .expect("a simulated device never fails");
}

fn rig(hand: Hand, mechanism: Mechanism) -> SimulatedDevice {
    SimulatedDevice::held(Hand { target: [0.0; 3], ..hand }, mechanism).expect("usable numbers")
}

fn delayed(delay_ticks: u32) -> SimulatedDevice {
    rig(Hand::default(), Mechanism { delay_ticks, ..Mechanism::default() })
}

/// Powers of ten from 1e-6 to 1e6.
fn any_scale() -> impl Strategy<Value = f64> {
    (-6.0f64..6.0).prop_map(|exponent| 10f64.powf(exponent))
}

/// Where a mass lies after a force of 1 N for a time, from the textbook's three formulas.
fn step_response(mass: f64, stiffness: f64, damping: f64, time: f64) -> f64 {
    let natural = (stiffness / mass).sqrt();
    let ratio = damping / (2.0 * (stiffness * mass).sqrt());
    let left = if ratio < 1.0 {
        let frequency = natural * (1.0 - ratio * ratio).sqrt();
        let (sine, cosine) = (frequency * time).sin_cos();
        (-ratio * natural * time).exp() * (cosine + ratio * natural / frequency * sine)
    } else {
        let root = (ratio * ratio - 1.0).sqrt();
        let (fast, slow) = (natural * (ratio + root), natural * (ratio - root));
        (fast * (-slow * time).exp() - slow * (-fast * time).exp()) / (fast - slow)
    };
    (1.0 - left) / stiffness
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn a_held_force_moves_the_hand_as_the_closed_solution_says(
        hand_mass in 0.01f64..1.0, device_mass in 0.0f64..1.0, stiffness in 10.0f64..5000.0,
        hand_damping in 0.0f64..20.0, device_damping in 0.0f64..20.0,
        rate in prop::sample::select(vec![250.0, 500.0, 1000.0, 2000.0, 4000.0]),
    ) {
        let (mass, damping) = (hand_mass + device_mass, hand_damping + device_damping);
        let ratio = damping / (2.0 * (stiffness * mass).sqrt());
        prop_assume!((ratio - 1.0).abs() > 0.01);
        let hand = Hand {
            mass: hand_mass, muscle_stiffness: stiffness, damping: hand_damping, ..Hand::default()
        };
        let mechanism = Mechanism { mass: device_mass, damping: device_damping, ..Mechanism::default() };
        let mut device = rig(hand, mechanism);
        for tick in 1..=200 {
            push(&mut device, 1.0, 1.0 / rate);
            let expected = step_response(mass, stiffness, damping, f64::from(tick) / rate);
            let found = read(&mut device).position[0];
            prop_assert!((found - expected).abs() <= 1e-8 / stiffness, "{found} for {expected}");
        }
    }

    #[test]
    fn without_damping_no_energy_is_lost(
        mass in any_scale(), device_mass in any_scale(), stiffness in any_scale(), dt in 1e-6f64..0.1,
    ) {
        let hand = Hand { mass, muscle_stiffness: stiffness, damping: 0.0, ..Hand::default() };
        let mut device = rig(hand, Mechanism { mass: device_mass, ..Mechanism::default() });
        push(&mut device, 1.0, dt);
        let before = device.energy();
        for _ in 0..1000 {
            push(&mut device, 0.0, dt);
        }
        let change = (device.energy() - before).abs();
        prop_assert!(change <= ROUNDING * before, "{before} J changed by {change} J");
    }

    #[test]
    fn what_is_read_is_the_nearest_whole_count(
        count in prop::sample::select(vec![1e-6, 1e-5, 5.5e-5, 1e-3, 0.1]), forces in
        prop::collection::vec(-8.0f64..8.0, 50),
    ) {
        let mechanism = Mechanism { metres_per_count: count, ..Mechanism::default() };
        let mut device = rig(Hand::default(), mechanism);
        for force in forces {
            push(&mut device, force, 0.01);
            for (read, hand) in read(&mut device).position.into_iter().zip(device.position()) {
                let counts = (hand / count).round();
                prop_assert_eq!(read, counts * count);
                prop_assert!((read - hand).abs() <= 0.5 * count * (1.0 + ROUNDING));
            }
        }
    }

    #[test]
    fn a_force_acts_exactly_so_many_ticks_after_it_was_written(
        delay in 0u32..20, forces in prop::collection::vec(-8.0f64..8.0, 60),
    ) {
        let (mut late, mut prompt) = (delayed(delay), delayed(0));
        for _ in 0..delay {
            push(&mut prompt, 0.0, NOMINAL_PERIOD);
        }
        for (tick, force) in forces.iter().enumerate() {
            push(&mut late, *force, NOMINAL_PERIOD);
            if tick < delay as usize {
                prop_assert_eq!(late.position(), [0.0; 3]);
            } else {
                push(&mut prompt, forces[tick - delay as usize], NOMINAL_PERIOD);
                prop_assert_eq!(late.position(), prompt.position());
            }
        }
        prop_assert_eq!(late.capabilities().delay_ticks, delay);
    }

    #[test]
    fn nothing_becomes_infinite_or_nan(
        mass in any_scale(), device_mass in any_scale(), stiffness in any_scale(),
        damping in any_scale(), device_damping in any_scale(), count in any_scale(),
        delay_ticks in 0u32..4,
        dt in prop::sample::select(vec![1e-6, 1e-3, 0.1, 10.0, 1e9, 1e300, f64::MAX]),
        forces in prop::collection::vec(prop::num::f64::ANY, 30),
    ) {
        let hand = Hand { mass, muscle_stiffness: stiffness, damping, ..Hand::default() };
        let mechanism = Mechanism {
            mass: device_mass,
            damping: device_damping,
            metres_per_count: count,
            delay_ticks,
            max_stiffness: None,
        };
        let mut device = rig(hand, mechanism);
        for force in forces {
            push(&mut device, force, dt);
            prop_assert!(read(&mut device).is_finite());
            prop_assert!(device.velocity().iter().all(|speed| speed.is_finite()));
        }
    }
}

#[test]
fn a_last_write_leaves_nothing_under_way() {
    let mut device = delayed(3);
    for _ in 0..3 {
        push(&mut device, 5.0, NOMINAL_PERIOD);
    }
    push(&mut device, 0.0, 0.0);
    for _ in 0..10 {
        push(&mut device, 0.0, NOMINAL_PERIOD);
    }
    assert_eq!(device.position(), [0.0; 3]);
}

#[test]
fn counts_too_fine_for_a_double_are_no_counts() {
    let mechanism = Mechanism { metres_per_count: f64::MIN_POSITIVE, ..Mechanism::default() };
    let mut device = rig(Hand::default(), mechanism);
    push(&mut device, 1.0, 0.1);
    assert_eq!(read(&mut device).position, device.position());
}

#[test]
fn the_declared_stiffness_is_its_own_or_half_of_what_all_damping_allows() {
    let mechanism = Mechanism { damping: 2.0, ..Mechanism::default() };
    assert_eq!(rig(Hand::default(), mechanism).capabilities().max_stiffness, 10_000.0);
    let said = Mechanism { max_stiffness: Some(3000.0), ..mechanism };
    assert_eq!(rig(Hand::default(), said).capabilities().max_stiffness, 3000.0);
}

#[test]
fn every_grip_is_a_hand_and_a_stiff_one_is_stiffer_than_a_relaxed_one() {
    for grip in Grip::ALL {
        assert!(SimulatedDevice::new(grip.hand()).is_ok(), "{}", grip.name());
    }
    let [relaxed, stiff] = [Grip::Relaxed, Grip::Stiff].map(Grip::hand);
    assert_eq!(relaxed, Hand::default());
    assert!(stiff.muscle_stiffness > relaxed.muscle_stiffness && stiff.damping > relaxed.damping);
}

#[test]
fn bad_mechanisms_are_refused_by_name() {
    let good = Mechanism::default();
    let bad = [
        (Mechanism { mass: -1.0, ..good }, "device mass"),
        (Mechanism { damping: f64::INFINITY, ..good }, "device damping"),
        (Mechanism { metres_per_count: f64::NAN, ..good }, "metres_per_count"),
        (Mechanism { delay_ticks: LONGEST_DELAY + 1, ..good }, "delay_ticks"),
        (Mechanism { max_stiffness: Some(-1.0), ..good }, "max_stiffness"),
    ];
    for (mechanism, name) in bad {
        let refused = SimulatedDevice::held(Hand::default(), mechanism);
        assert_eq!(refused.unwrap_err().name, name);
    }
}
