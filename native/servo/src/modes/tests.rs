//! Energy of the modes, held against every hand.

use devices::Capabilities;
use proptest::prelude::*;
use surface::{ByteOrder, GridLayout, SampleType};

use super::pan::Pan;
use super::*;
use crate::{Settings, Window};

/// N/m.
const STIFFNESS: f64 = 500.0;

/// Metres between the walls, halved.
const WALL: f64 = 0.072;

fn frame(wraps: bool, east: f64, width: f64, turn: f64) -> Frame {
    let layout = GridLayout::packed(512, 1024, 3.0, 5.0, SampleType::I16, ByteOrder::Big).unwrap();
    let window = Window::new(east, -700.0, 10.0, width, 2.0).unwrap().turned(turn).unwrap();
    Frame::new(window, 0.16, &layout.with_wrap(wraps)).unwrap()
}

fn knobs(frame: &Frame, max_stiffness: f64) -> Knobs {
    let capabilities =
        Capabilities { max_stiffness, ..Capabilities::unlimited([0.16, 0.12, 0.12]) };
    let limits = Limits::new(&Settings::default(), &capabilities);
    Modes::new(Interaction::default(), &capabilities, &limits, frame).knobs
}

fn hand<'a>(pose: &'a Pose, dt: f64) -> Hand<'a> {
    let [x, y, z] = pose.position;
    let inside = [x.clamp(-WALL, WALL), y.clamp(-WALL, WALL), z];
    Hand { pose, inside, is_at_wall: inside != pose.position, dt }
}

/// Where a hand goes, and how long it takes.
fn any_motion() -> impl Strategy<Value = (f64, f64, f64)> {
    let seconds = prop::sample::select(vec![1e-3, 1e-3, 1e-3, 2e-4, 5e-3, 0.1, 10.0]);
    (-0.1f64..0.1, -0.1f64..0.1, seconds)
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    /// Mass and spring gain no more than the hand's work on them, jumping hands, walls, map edges and
    /// ticks of every length included.
    #[test]
    fn a_pan_makes_no_energy(
        wraps in any::<bool>(), east in prop::sample::select(vec![3.0, 2500.0, 5114.0]),
        width in 50.0f64..5000.0, turn in -4.0f64..4.0,
        max_stiffness in prop::sample::select(vec![500.0, 800.0, 3000.0, f64::INFINITY]),
        start in (-0.01f64..0.01, -0.01f64..0.01),
        motions in prop::collection::vec(any_motion(), 1..60), smoothed in any::<bool>(),
    ) {
        let mut frame = frame(wraps, east, width, turn);
        let knobs = knobs(&frame, max_stiffness);
        let pose = Pose::at([0.0, 0.0, -0.003]);
        let held = frame.goal([start.0, start.1, 0.0]);
        let mut pan = Pan::grab(held, &hand(&pose, 1e-3), &frame, [0.0; 2]);
        let energy = |stretch: [f64; 3], kept: f64| {
            kept + 0.5 * STIFFNESS * (stretch[0] * stretch[0] + stretch[1] * stretch[1])
        };
        let mut before = energy([start.0, start.1, 0.0], 0.0);
        let mut last = pose.position;
        let mut biggest = before;
        for (x, y, dt) in motions {
            // Also hands as slow as hands are.
            let share = if smoothed { 0.01 } else { 1.0 };
            let pose = Pose::at([last[0] + share * (x - last[0]), last[1] + share * (y - last[1]), 0.0]);
            let now = hand(&pose, dt);
            let inside_before = hand(&Pose::at(last), dt).inside;
            let hold = pan.step(&knobs, &now, &mut frame, STIFFNESS);
            let after = energy(hold.stretch, hold.kept);
            let work: f64 = (0..2)
                .map(|axis| {
                    let newtons = STIFFNESS * hold.stretch[axis] + hold.beside[axis];
                    -newtons * (now.inside[axis] - inside_before[axis])
                })
                .sum();
            // With a slack spring the force is what it was before it went slack.
            biggest = f64::max(biggest, after + work.abs());
            if !now.is_at_wall {
                prop_assert!(after - before <= work + 1e-9 * biggest, "{after} of {before} and {work}");
            } else {
                prop_assert_eq!(hold.kept, 0.0);
            }
            before = after;
            last = pose.position;
        }
    }

    /// The kinetic energy of a drifting surface is never more than it was let go with.
    #[test]
    fn a_drift_gains_no_energy(
        wraps in any::<bool>(), east in prop::sample::select(vec![3.0, 2500.0, 5114.0]),
        turn in -4.0f64..4.0, velocity in (-0.5f64..0.5, -0.5f64..0.5),
        ticks in prop::collection::vec((any_motion(), -8.0f64..8.0, -8.0f64..8.0), 1..60),
    ) {
        let mut frame = frame(wraps, east, 300.0, turn);
        let knobs = knobs(&frame, f64::INFINITY);
        let mut drift = Drift::new([velocity.0, velocity.1], Bounds::around(&frame));
        let mass = knobs.interaction.pan_mass;
        let energy = |drift: &Drift| {
            let [right, away] = drift.velocity();
            0.5 * mass * (right * right + away * away)
        };
        let (mut before, mut paid) = (energy(&drift), 0.0);
        for ((_, _, dt), x, y) in ticks {
            let pose = Pose::at([0.0; 3]);
            drift.step(&knobs, &hand(&pose, dt), &mut frame);
            paid += drift.pay([x, y, 0.0], mass);
            prop_assert!(paid >= -1e-12);
            let after = energy(&drift);
            prop_assert!(after + paid <= before + 1e-12, "{after} and {paid} of {before}");
            before = after + paid;
        }
    }
}

#[test]
fn the_damper_of_a_pan_is_what_the_device_can_show() {
    let frame = frame(false, 2500.0, 300.0, 0.0);
    assert_eq!(knobs(&frame, 500.0).pan_damping, 0.0, "its spring takes all of it");
    assert!((knobs(&frame, 2500.0).pan_damping - 0.5).abs() < 1e-12);
    assert!((knobs(&frame, f64::INFINITY).pan_damping - 8.0).abs() < 1e-12);
}
