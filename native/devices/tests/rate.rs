//! A hand steered by velocity: a puck that springs back, and a hand that the ground pushes back.

use devices::{
    Device, DeviceError, Force, NOMINAL_PERIOD, PathPoint, Pose, RateControl, RateDevice,
    ScriptedDevice,
};
use proptest::prelude::*;

const WORKSPACE: [f64; 3] = [0.16, 0.12, 0.12];

/// A puck that is pushed as (seconds, x, y, z) say.
fn steered(path: &[(f64, f64, f64, f64)]) -> RateDevice<ScriptedDevice> {
    let path = path.iter().copied().map(PathPoint::from).collect();
    let puck = ScriptedDevice::new(path, WORKSPACE).unwrap();
    RateDevice::new(puck, RateControl::default(), WORKSPACE).unwrap()
}

/// Where the hand is after so many ticks under a force that depends on where it is.
fn run(
    device: &mut impl Device,
    ticks: std::ops::Range<u32>,
    force: impl Fn([f64; 3]) -> [f64; 3],
) -> [f64; 3] {
    for tick in ticks.clone() {
        let hand = device.read(f64::from(tick) * NOMINAL_PERIOD).unwrap().position;
        device.write(Force { newtons: force(hand) }, NOMINAL_PERIOD).unwrap();
    }
    device.read(f64::from(ticks.end) * NOMINAL_PERIOD).unwrap().position
}

#[test]
fn a_pushed_puck_is_a_velocity_and_a_puck_let_go_stands() {
    let mut device =
        steered(&[(0.0, 1.0, 0.0, -0.525), (0.5, 1.0, 0.0, -0.525), (0.5001, 0.0, 0.02, 0.04)]);
    let begin = run(&mut device, 0..0, |_| [0.0; 3]);
    assert_eq!(begin, [0.0, 0.0, 0.06]);
    let moved = run(&mut device, 0..500, |_| [0.0; 3]);
    // Half of the way beyond the dead zone is half of the speed.
    for (metres, wanted) in moved.into_iter().zip([0.04, 0.0, 0.06 - 0.02]) {
        assert!((metres - wanted).abs() < 1e-4, "{moved:?}");
    }
    let rested = run(&mut device, 501..1000, |_| [0.0; 3]);
    let stands = run(&mut device, 1000..2000, |_| [0.0; 3]);
    assert_eq!(rested, stands, "within the dead zone");
}

#[test]
fn the_hand_stays_in_the_workspace() {
    let mut device = steered(&[(0.0, 1.0, -1.0, 5.0)]);
    assert_eq!(run(&mut device, 0..5000, |_| [0.0; 3]), [0.08, -0.06, 0.06]);
}

/// Pressed into ground at the stiffest spring that the device says it can show.
#[test]
fn the_ground_holds_the_hand_and_brings_it_back_when_the_puck_springs_back() {
    for share in [0.1, 1.0] {
        let mut device =
            steered(&[(0.0, 0.0, 0.0, -1.0), (2.0, 0.0, 0.0, -1.0), (2.001, 0.0, 0.0, 0.0)]);
        let stiffness = share * device.capabilities().max_stiffness;
        let ground = |hand: [f64; 3]| [0.0, 0.0, -stiffness * hand[2].min(0.0)];
        let pressed = run(&mut device, 0..2000, ground)[2];
        // Speed times drag is what the ground must push.
        let deep = 0.08 * 5.0 / stiffness;
        assert!((pressed + deep).abs() < 1e-6, "{pressed} m, not {deep}");
        let back = run(&mut device, 2001..2100, ground)[2];
        assert!(back.abs() < 1e-5, "{back} m");
    }
}

#[test]
fn a_twisted_puck_turns_the_handle_and_buttons_pass() {
    let puck = ScriptedDevice::new(vec![(0.0, 0.0, 0.0, 0.0).into()], WORKSPACE).unwrap();
    let puck = puck.with_handle(vec![(0.0, 0.5, 1).into()]).unwrap();
    let mut device = RateDevice::new(puck, RateControl::default(), WORKSPACE).unwrap();
    run(&mut device, 0..1000, |_| [0.0; 3]);
    let pose = device.read(1.0).unwrap();
    assert!((pose.twist.unwrap() - 1.5).abs() < 1e-9 && pose.buttons == 1, "{pose:?}");
    let mut plain = steered(&[(0.0, 0.0, 0.0, 0.0)]);
    assert_eq!(plain.read(0.0).unwrap().twist, None);
}

/// Gone, or not a number.
struct Broken(bool);

impl Device for Broken {
    fn capabilities(&self) -> devices::Capabilities {
        devices::Capabilities::unlimited(WORKSPACE)
    }

    fn read(&mut self, time: f64) -> Result<Pose, DeviceError> {
        match (time > 0.1, self.0) {
            (false, _) => Ok(Pose::at([1.0, 0.0, 0.0])),
            (true, true) => Err(DeviceError::Timeout("no packet".into())),
            (true, false) => Ok(Pose::at([f64::NAN, 0.0, 0.0])),
        }
    }

    fn write(&mut self, _force: Force, _dt: f64) -> Result<(), DeviceError> {
        Ok(())
    }
}

#[test]
fn a_puck_that_is_not_seen_steers_nothing_and_is_no_hand() {
    for fails in [true, false] {
        let mut device = RateDevice::new(Broken(fails), RateControl::default(), WORKSPACE).unwrap();
        for tick in 0..300 {
            let read = device.read(f64::from(tick) * NOMINAL_PERIOD);
            let is_broken = read.map_or(true, |pose| !pose.is_finite());
            assert_eq!(is_broken, tick > 100, "{tick}");
            device.write(Force::ZERO, NOMINAL_PERIOD).unwrap();
        }
        let hand = device.hand()[0];
        assert!((hand - 0.1 * 0.08).abs() < 2e-4, "{hand} m");
    }
}

#[test]
fn bad_numbers_are_refused_by_name() {
    let good = RateControl::default();
    for (control, name) in [
        (RateControl { reach: 0.0, ..good }, "reach of the puck"),
        (RateControl { dead_zone: -1.0, ..good }, "dead_zone"),
        (RateControl { speed: f64::NAN, ..good }, "speed of the hand"),
        (RateControl { turning: -1.0, ..good }, "turning"),
        (RateControl { drag: 0.0, ..good }, "drag"),
    ] {
        let refused = RateDevice::new(Broken(true), control, WORKSPACE);
        assert_eq!(refused.err().unwrap().name, name);
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn no_push_and_no_force_takes_the_hand_out_or_makes_it_no_number(
        pushes in prop::collection::vec(prop::array::uniform3(prop::num::f64::ANY), 20),
        newtons in prop::array::uniform3(prop::num::f64::ANY),
        dt in prop::sample::select(vec![0.0, 1e-6, 1e-3, 10.0, 1e300, f64::NAN]),
        dead_zone in prop::sample::select(vec![0.0, 0.05, 1.0, 3.0]),
    ) {
        struct Pushed(Vec<[f64; 3]>);
        impl Device for Pushed {
            fn capabilities(&self) -> devices::Capabilities {
                devices::Capabilities::unlimited(WORKSPACE)
            }
            fn read(&mut self, _time: f64) -> Result<Pose, DeviceError> {
                Ok(Pose::at(self.0.pop().unwrap_or([0.0; 3])))
            }
            fn write(&mut self, _force: Force, _dt: f64) -> Result<(), DeviceError> {
                Ok(())
            }
        }
        let control = RateControl { dead_zone, ..RateControl::default() };
        let mut device = RateDevice::new(Pushed(pushes), control, WORKSPACE).unwrap();
        for _ in 0..20 {
            device.read(0.0).unwrap();
            device.write(Force { newtons }, dt).unwrap();
        }
        let hand = device.read(0.0).unwrap().position;
        for (metres, side) in hand.into_iter().zip(WORKSPACE) {
            prop_assert!(metres.abs() <= 0.5 * side, "{hand:?}");
        }
    }
}
