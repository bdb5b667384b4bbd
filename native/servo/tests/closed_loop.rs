//! The servo with a hand in the loop: walls beside the surface, and the energy of the spring.

mod common;

use common::*;
use contact::Feature;
use devices::{Device, Hand, Mechanism, PathPoint, ScriptedDevice, SimulatedDevice};
use servo::{Frame, Servo, Settings, Walls};

const STIFFNESS: f64 = 500.0;

/// Ticks after which the force of a new touch is whole.
const RAMPED: u32 = 60;

/// Metres from the origin to each wall.
const WALL: f64 = 0.02;

fn servo(elevation: impl Fn(u32, u32) -> f64, device: impl Device + 'static) -> Servo {
    let ground = ground(elevation);
    let frame = Frame::new(window(), 0.16, ground.layout()).unwrap();
    Servo::new(Box::new(device), proxy_graph(), ground, frame, &stiff(STIFFNESS)).unwrap()
}

/// A spring of any stiffness, whose force nothing limits.
fn stiff(stiffness: f64) -> Settings {
    Settings { stiffness, max_force: f64::MAX, ..Settings::default() }
}

fn between_walls(elevation: impl Fn(u32, u32) -> f64, device: impl Device + 'static) -> Servo {
    let mut servo = servo(elevation, device);
    servo.set_walls(Some(Walls::new(WALL, WALL).unwrap()));
    servo
}

/// Metres up for each metre to the left, through the middle of the ground.
fn slope(rise: f64) -> impl Fn(u32, u32) -> f64 {
    move |column, _| rise * (32.0 - f64::from(column))
}

fn forces(servo: &mut Servo, ticks: u32) -> Vec<[f64; 3]> {
    (1..=ticks).map(|tick| servo.tick(f64::from(tick) * 1e-3, 1e-3).force).collect()
}

#[test]
fn a_wall_pushes_in_the_air_and_leaves_the_proxy_inside() {
    let path = scripted(&[(0.0, 0.0, 0.0, 0.05), (0.05, WALL + 0.004, 0.0, 0.05)]);
    let mut servo = between_walls(|_, _| 0.0, path);
    let force = forces(&mut servo, 100)[99];
    assert!((force[0] + 0.004 * STIFFNESS).abs() < 1e-9 && force[1..] == [0.0, 0.0], "{force:?}");
    assert_eq!(servo.latest().feature, Feature::Free);
    // 1 cm of workspace is 1 m of terrain.
    assert!((servo.latest().proxy[0] - (32.0 + 100.0 * WALL)).abs() < 1e-9);
    assert!((servo.latest().hand[0] - (WALL + 0.004)).abs() < 1e-12);
}

#[test]
fn between_the_walls_the_surface_feels_to_the_last_bit_as_without_walls() {
    let path = || {
        scripted(&[(0.0, -0.01, 0.0, 0.03), (0.1, 0.0, 0.002, -0.002), (1.0, 0.01, 0.0, -0.004)])
    };
    let hills = |column: u32, row: u32| 0.2 * f64::from((column * 7 + row * 5) % 3);
    let without = forces(&mut servo(hills, path()), 1000);
    assert_eq!(forces(&mut between_walls(hills, path()), 1000), without);
    assert!(without[999][2] > 0.0);
}

/// Over slopes that lean to the wall and from it, into the wall and out of it, in and out of the ground.
#[test]
fn through_wall_and_slope_the_force_makes_no_step() {
    for rise in [-5.0, -1.0, -0.2, 0.2, 1.0, 5.0] {
        let points = (0..80).map(|turn| {
            // It begins where nothing pushes, so that the first force is not one of a beginning.
            let (aside, height) = match turn {
                0..3 => (-1.0, 3.0),
                _ => ((f64::from(turn) * 2.4).sin(), f64::from(turn % 7) - 3.0),
            };
            let x = WALL + 0.004 * aside;
            let surface = -rise * x;
            PathPoint {
                time: 0.05 * f64::from(turn),
                position: [x, 0.01, surface + 0.003 * height],
            }
        });
        let path = ScriptedDevice::new(points.collect(), [0.16, 0.12, 0.12]).unwrap();
        let mut servo = between_walls(slope(rise), path);
        // While the force is ramped in, it changes though the hand does not.
        for tick in 0..RAMPED {
            servo.tick(f64::from(tick) * 1e-3, 1e-3);
        }
        let mut before = *servo.latest();
        let mut touched = [false; 2];
        for tick in RAMPED..4000 {
            let now = servo.tick(f64::from(tick) * 1e-3, 1e-3);
            let (moved, change) = (way(before.hand, now.hand), way(before.force, now.force));
            assert!(
                change <= STIFFNESS * moved * (1.0 + 1e-4) + 1e-6,
                "x{rise}: {change} N for {moved} m"
            );
            let is_beyond = now.hand[0] > WALL;
            touched[usize::from(is_beyond)] |= now.feature != Feature::Free;
            before = now;
        }
        assert_eq!(touched, [true, true], "the path goes through all of it");
    }
}

fn way(from: [f64; 3], to: [f64; 3]) -> f64 {
    (to[0] - from[0]).hypot(to[1] - from[1]).hypot(to[2] - from[2])
}

/// A spring of 1000 N/m under a hand of which `damping` N s/m brakes, and the servo knows it.
fn pressed(damping: f64, delay_ticks: u32) -> Servo {
    let mechanism =
        Mechanism { delay_ticks, max_stiffness: Some(f64::INFINITY), ..Mechanism::default() };
    let hand = Hand { damping, target: [0.0, 0.0, 0.01], max_force: 1e9, ..Hand::default() };
    let device = SimulatedDevice::held(hand, mechanism).unwrap();
    let ground = flat_ground();
    let frame = Frame::new(window(), 0.16, ground.layout()).unwrap();
    let settings = stiff(1000.0);
    let mut servo = Servo::new(Box::new(device), proxy_graph(), ground, frame, &settings).unwrap();
    servo.set_device_damping(damping);
    servo.set_target([0.0, 0.0, -0.02]);
    servo
}

/// Metres from end to end, in the last second of ten.
fn swing(servo: &mut Servo) -> f64 {
    let heights = (1..=10_000).map(|tick| servo.tick(f64::from(tick) * 1e-3, 1e-3).hand[2]);
    let (low, high) =
        heights.skip(9000).fold((f64::MAX, f64::MIN), |(low, high), z| (low.min(z), high.max(z)));
    high - low
}

#[test]
fn a_stable_spring_is_never_active_and_an_unstable_one_is() {
    let (mut calm, mut wild) = (pressed(8.0, 0), pressed(0.1, 0));
    assert!(swing(&mut calm) < 1e-9);
    assert_eq!(calm.totals().active_ticks, 0);
    assert!(swing(&mut wild) > 1e-3);
    assert!(wild.totals().active_ticks > 0);
}

#[test]
fn control_makes_an_unstable_spring_swing_less() {
    for delay in [0, 1] {
        let (mut without, mut with) = (pressed(0.3, delay), pressed(0.3, delay));
        with.set_passivity_control(true);
        let (without, with) = (swing(&mut without), swing(&mut with));
        assert!(without > 1e-3, "{without}");
        assert!(with < 0.8 * without, "{delay} ticks late: {with} m of {without} m");
    }
}

/// A device that declares what it can show says by that how much it brakes.
#[test]
fn a_stepped_session_counts_and_controls_without_being_told_more() {
    let device = SimulatedDevice::new(Hand::default()).unwrap();
    let mut session = session(device, proxy_graph());
    session.set_passivity_control(true).unwrap();
    session.set_target([0.0, 0.0, -0.02]).unwrap();
    session.step(3000).unwrap();
    let totals = session.statistics().totals;
    assert!(totals.contact_ticks > 2000);
    assert_eq!(totals.active_ticks, 0);
}
