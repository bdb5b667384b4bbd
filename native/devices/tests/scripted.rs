//! The scripted device is where its path says, however time moves.

use devices::{Device, Force, HandlePoint, PathError, PathPoint, ScriptedDevice};
use proptest::prelude::*;

const WORKSPACE: [f64; 3] = [0.16, 0.12, 0.12];

fn device(path: &[(f64, f64, f64, f64)]) -> Result<ScriptedDevice, PathError> {
    ScriptedDevice::new(path.iter().copied().map(PathPoint::from).collect(), WORKSPACE)
}

fn position(device: &mut ScriptedDevice, time: f64) -> [f64; 3] {
    device.read(time).expect("a script never fails").position
}

#[test]
fn lines_between_points_and_stillness_at_the_ends() {
    let mut script =
        device(&[(1.0, 0.0, 0.0, 2.0), (2.0, 1.0, -1.0, 2.0), (4.0, 3.0, 0.0, 2.0)]).unwrap();
    assert_eq!(position(&mut script, -5.0), [0.0, 0.0, 2.0]);
    assert_eq!(position(&mut script, 1.5), [0.5, -0.5, 2.0]);
    assert_eq!(position(&mut script, 2.0), [1.0, -1.0, 2.0]);
    assert_eq!(position(&mut script, 3.0), [2.0, -0.5, 2.0]);
    assert_eq!(position(&mut script, 9.0), [3.0, 0.0, 2.0]);
    assert_eq!(position(&mut script, 1.5), [0.5, -0.5, 2.0], "time may go back");
}

#[test]
fn one_point_is_a_hand_held_still() {
    let mut script = device(&[(0.0, 0.1, 0.2, 0.3)]).unwrap();
    for time in [f64::NEG_INFINITY, -1.0, 0.0, 1.0, f64::INFINITY, f64::NAN] {
        assert_eq!(position(&mut script, time), [0.1, 0.2, 0.3]);
    }
}

#[test]
fn forces_change_nothing() {
    let mut script = device(&[(0.0, 0.0, 0.0, 0.0), (1.0, 1.0, 0.0, 0.0)]).unwrap();
    script.write(Force { newtons: [100.0, f64::NAN, 0.0] }, 0.001).unwrap();
    assert_eq!(position(&mut script, 0.5), [0.5, 0.0, 0.0]);
}

#[test]
fn bad_paths_are_refused_by_index() {
    let still = (0.0, 0.0, 0.0, 0.0);
    assert_eq!(device(&[]).unwrap_err(), PathError::Empty);
    assert_eq!(
        device(&[still, (f64::NAN, 0.0, 0.0, 0.0)]).unwrap_err(),
        PathError::NotFinite { index: 1 }
    );
    assert_eq!(
        device(&[(0.0, 0.0, f64::INFINITY, 0.0)]).unwrap_err(),
        PathError::NotFinite { index: 0 }
    );
    let twice = device(&[still, (1.0, 0.0, 0.0, 0.0), (1.0, 0.0, 0.0, 0.0)]).unwrap_err();
    assert_eq!(twice, PathError::NotRising { index: 2, time: 1.0, previous: 1.0 });
    assert!(twice.to_string().contains("point 2"));
    let flat = ScriptedDevice::new(vec![PathPoint::from(still)], [0.16, 0.0, 0.12]).unwrap_err();
    assert!(flat.to_string().contains("workspace depth"));
}

#[test]
fn the_largest_numbers_do_not_overflow() {
    let huge = f64::MAX;
    let mut script = device(&[(-huge, -huge, huge, 0.0), (huge, huge, -huge, 0.0)]).unwrap();
    for time in [-huge, -1.0, 0.0, 1.0, huge / 2.0, huge] {
        assert!(position(&mut script, time).iter().all(|metres| metres.is_finite()));
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn the_position_depends_on_time_alone(
        steps in prop::collection::vec((1e-6f64..2.0, -1.0f64..1.0), 1..40),
        times in prop::collection::vec(-1.0f64..50.0, 1..60),
    ) {
        let mut clock = 0.0;
        let mut path = Vec::new();
        for (step, x) in steps {
            clock += step;
            path.push((clock, x, -x, 0.5 * x));
        }
        let mut used = device(&path).unwrap();
        for time in times {
            let mut fresh = device(&path).unwrap();
            prop_assert_eq!(position(&mut used, time), position(&mut fresh, time));
        }
    }

    #[test]
    fn the_hand_stays_between_the_points_around_it(
        from in -1.0f64..1.0, to in -1.0f64..1.0, time in 0.0f64..1.0,
    ) {
        let mut script = device(&[(0.0, from, 0.0, 0.0), (1.0, to, 0.0, 0.0)]).unwrap();
        let x = position(&mut script, time)[0];
        let rounding = f64::EPSILON * from.abs().max(to.abs());
        prop_assert!(x >= from.min(to) - rounding && x <= from.max(to) + rounding);
    }
}

#[test]
fn the_handle_turns_evenly_and_buttons_are_as_they_were_pressed_last() {
    let device = ScriptedDevice::new(vec![(0.0, 1.0, 2.0, 3.0).into()], WORKSPACE).unwrap();
    assert_eq!(device.clone().read(0.5).unwrap().twist, None, "it has no handle");
    let handle = [(0.1, 0.0, 1), (0.2, 2.0, 0), (0.3, -1.0, 5)].map(HandlePoint::from);
    let mut device = device.with_handle(handle.to_vec()).unwrap();
    for (time, twist, buttons) in [
        (0.0, 0.0, 0),
        (0.1, 0.0, 1),
        (0.15, 1.0, 1),
        (0.25, 0.5, 0),
        (9.0, -1.0, 5),
        (0.05, 0.0, 0),
    ] {
        let pose = device.read(time).unwrap();
        let turned = pose.twist.unwrap();
        assert!((turned - twist).abs() < 1e-12 && pose.buttons == buttons, "{pose:?} at {time}");
        assert_eq!(pose.position, [1.0, 2.0, 3.0]);
    }
}

#[test]
fn handles_that_cannot_be_turned_are_refused() {
    let device = ScriptedDevice::new(vec![(0.0, 0.0, 0.0, 0.0).into()], WORKSPACE).unwrap();
    let with = |handle: &[(f64, f64, u32)]| {
        device.clone().with_handle(handle.iter().copied().map(HandlePoint::from).collect())
    };
    assert_eq!(with(&[(0.0, f64::NAN, 0)]).unwrap_err(), PathError::NotFinite { index: 0 });
    let falls = with(&[(0.2, 0.0, 0), (0.1, 0.0, 0)]).unwrap_err();
    assert_eq!(falls, PathError::NotRising { index: 1, time: 0.1, previous: 0.2 });
}
