use super::*;
use devices::{Device, Force, Grip, Hand, Mechanism, SimulatedDevice};
use proptest::prelude::*;

/// A hand on a device, pressed against a wall at z = 0 that is a plain spring.
struct Loop {
    device: SimulatedDevice,
    passivity: Passivity,
    stiffness: f64,
    /// Seconds.
    period: f64,
}

/// Metres in one count of the encoder, where there is one.
const COUNT: f64 = 1e-5;

impl Loop {
    fn new(grip: Grip, mechanism: Mechanism, share_of_bound: f64, period: f64) -> Loop {
        let hand = Hand { target: [0.0, 0.0, 0.02], ..grip.hand() };
        let mut device = SimulatedDevice::held(hand, mechanism).unwrap();
        device.set_target([0.0, 0.0, -0.02]);
        let delay = 1.0 + 2.0 * f64::from(mechanism.delay_ticks);
        Loop {
            device,
            passivity: Passivity::new(mechanism.damping, mechanism.delay_ticks),
            stiffness: share_of_bound * 2.0 * mechanism.damping / (delay * period),
            period,
        }
    }

    /// Ticks; where the hand really was after each.
    fn run(&mut self, ticks: usize) -> Vec<f64> {
        (0..ticks)
            .map(|_| {
                let hand = self.device.read(0.0).unwrap().position;
                let stretch = (-hand[2]).max(0.0);
                let force = self.passivity.tick(&Coupling {
                    hand,
                    force: [0.0, 0.0, self.stiffness * stretch],
                    stretch,
                    stiffness: self.stiffness,
                    dt: self.period,
                });
                self.passivity.sent(force);
                self.device.write(Force { newtons: force }, self.period).unwrap();
                self.device.position()[2]
            })
            .collect()
    }
}

fn mechanism(damping: f64, delay_ticks: u32, metres_per_count: f64) -> Mechanism {
    Mechanism { mass: 0.1, damping, metres_per_count, delay_ticks, max_stiffness: None }
}

/// A hand that is hardly one: what presses is a weight, and nothing but the device brakes.
fn weight() -> Hand {
    Hand { mass: 1e-3, muscle_stiffness: 20.0, damping: 0.0, ..Hand::default() }
}

fn unbraked(mechanism: Mechanism, share_of_bound: f64) -> Loop {
    let mut pressed = Loop::new(Grip::Relaxed, mechanism, share_of_bound, 1e-3);
    let hand = Hand { target: [0.0, 0.0, 0.02], ..weight() };
    pressed.device = SimulatedDevice::held(hand, mechanism).unwrap();
    pressed.device.set_target([0.0, 0.0, -0.1]);
    pressed
}

fn swing(positions: &[f64]) -> f64 {
    let highest = positions.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let lowest = positions.iter().copied().fold(f64::INFINITY, f64::min);
    highest - lowest
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn a_spring_below_the_bound_is_never_found_active(
        grip in prop::sample::select(Grip::ALL.to_vec()), damping in 0.5f64..20.0,
        delay in 0u32..4, count in prop::sample::select(vec![0.0, COUNT, 1e-4]),
        share in 0.01f64..0.999, period in prop::sample::select(vec![4e-3, 1e-3, 2.5e-4]),
    ) {
        let mut pressed = Loop::new(grip, mechanism(damping, delay, count), share, period);
        pressed.run(4000);
        prop_assert_eq!(pressed.passivity.active_ticks(), 0);
    }

    #[test]
    fn beyond_the_bound_a_bouncing_spring_is_found_active(
        damping in 0.5f64..5.0, delay in 0u32..3, count in prop::sample::select(vec![0.0, COUNT]),
        share in 1.3f64..3.0,
    ) {
        let mut pressed = unbraked(mechanism(damping, delay, count), share);
        pressed.run(4000);
        prop_assert!(pressed.passivity.active_ticks() > 0);
    }
}

#[test]
fn with_damping_added_a_limit_cycle_shrinks() {
    for delay in 0..2 {
        let swing_with = |controls| {
            let mut pressed = unbraked(mechanism(2.0, delay, COUNT), 1.3);
            pressed.passivity.set_control(controls);
            let positions = pressed.run(20_000);
            swing(&positions[15_000..])
        };
        let (without, with) = (swing_with(false), swing_with(true));
        assert!(without > 1e-3, "there is a cycle to shrink: {without}");
        assert!(with < 0.6 * without, "{delay} ticks late: {with} m of {without} m");
    }
}

#[test]
fn a_force_that_is_cut_owes_what_it_took() {
    // 1 cm at 1000 N/m, cut to 2 N: 2 mm as a spring, 8 mm under the constant force.
    let coupling = Coupling {
        hand: [0.0; 3],
        force: [0.0, 0.0, 2.0],
        stretch: 0.01,
        stiffness: 1000.0,
        dt: 1e-3,
    };
    assert!((stored(&coupling) - (0.5 * 2.0 * 0.002 + 2.0 * 0.008)).abs() < 1e-15);
    assert_eq!(stored(&Coupling { force: [0.0; 3], ..coupling }), 0.0);
}

#[test]
fn a_force_from_nowhere_is_found_active_and_left_alone() {
    let mut passivity = Passivity::new(1.0, 0);
    for tick in 0..100 {
        // Pushed along by 1 N at 0.1 m/s: more than the damping takes.
        let hand = [1e-4 * f64::from(tick), 0.0, 0.0];
        let force = [1.0, 0.0, 0.0];
        let coupling = Coupling { hand, force, stretch: 0.0, stiffness: 500.0, dt: 1e-3 };
        assert_eq!(passivity.tick(&coupling), force);
        passivity.sent(force);
    }
    assert_eq!(passivity.active_ticks(), 99);
    passivity.begin();
    assert_eq!(passivity.active_ticks(), 99, "counts stay");
}

#[test]
fn a_device_without_a_limit_is_not_judged() {
    let mut passivity = Passivity::new(f64::INFINITY, 0);
    for tick in 0..10 {
        let hand = [f64::from(tick), 0.0, 0.0];
        let coupling = Coupling { hand, force: [9.0; 3], stretch: 0.0, stiffness: 500.0, dt: 1e-3 };
        passivity.tick(&coupling);
        passivity.sent([9.0; 3]);
    }
    assert_eq!(passivity.active_ticks(), 0);
}

#[test]
fn a_spring_that_is_ramped_in_is_not_blamed() {
    let mut passivity = Passivity::new(1.0, 0);
    for tick in 0..200u32 {
        // Rises into the wall, and out of it again with the whole force.
        let depth = 0.001 * (0.02 * f64::from(tick)).sin().max(0.0);
        let force = [0.0, 0.0, 500.0 * depth];
        let hand = [0.0, 0.0, -depth];
        let coupling = Coupling { hand, force, stretch: depth, stiffness: 500.0, dt: 1e-3 };
        passivity.tick(&coupling);
        let open = (f64::from(tick) / 60.0).min(1.0);
        passivity.sent(force.map(|newtons| newtons * open));
    }
    assert_eq!(passivity.active_ticks(), 0);
}

#[test]
fn a_hand_at_rest_is_given_nothing() {
    let mut passivity = Passivity::new(1.0, 0);
    let mut push = |x: f64| {
        let coupling = Coupling {
            hand: [x, 0.0, 0.0],
            force: [1.0, 0.0, 0.0],
            stretch: 0.0,
            stiffness: 500.0,
            dt: 1e-3,
        };
        let force = passivity.tick(&coupling);
        passivity.sent(force);
        passivity.active_ticks()
    };
    push(0.0);
    assert_eq!(push(1e-4), 1);
    assert_eq!(push(1e-4), 1);
}

#[test]
fn a_way_beyond_all_numbers_does_not_blind_the_observer() {
    let mut passivity = Passivity::new(1.0, 0);
    let mut tick = |x: f64| {
        let (hand, force) = ([x, 0.0, 0.0], [1.0, 0.0, 0.0]);
        let coupling = Coupling { hand, force, stretch: 0.0, stiffness: 500.0, dt: 1e-3 };
        passivity.tick(&coupling);
        passivity.sent(force);
        passivity.active_ticks()
    };
    tick(0.0);
    tick(1e200);
    tick(0.0);
    let before = tick(0.0);
    // Pushed along, as above.
    let after = (1..100).map(|step| tick(1e-4 * f64::from(step))).last();
    assert!(after > Some(before + 90), "{after:?}");
}
