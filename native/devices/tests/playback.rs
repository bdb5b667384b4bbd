//! The device that plays a recorded hand.

use std::sync::atomic::Ordering;

use devices::{Device, HandMoment, ParameterError, PathError, PlaybackDevice, Pose};

const WORKSPACE: [f64; 3] = [0.16, 0.12, 0.12];

fn moment(time: f64, x: f64, buttons: u32) -> HandMoment {
    HandMoment { time, position: [x, -x, 0.01], twist: Some(10.0 * x), buttons }
}

fn device(hand: &[HandMoment], speed: f64) -> Result<PlaybackDevice, PathError> {
    PlaybackDevice::new(hand.to_vec(), speed, WORKSPACE)
}

/// Ticks from a tenth of a second to the end of the third: as they are numbered in a session.
fn ticks() -> Vec<HandMoment> {
    (100..3000)
        .map(|tick| moment(f64::from(tick) / 1000.0, 0.1 / f64::from(tick), tick % 4))
        .collect()
}

#[test]
fn ticks_are_read_to_the_bit_whenever_the_session_began() {
    for first in [1_u32, 7, 123_456_789] {
        let mut device = device(&ticks(), 1.0).unwrap();
        for (number, moment) in (first..).zip(ticks()) {
            let pose = device.read(f64::from(number) / 1000.0).unwrap();
            let expected =
                Pose { position: moment.position, buttons: moment.buttons, twist: moment.twist };
            assert_eq!(pose, expected);
        }
        assert!(!device.is_finished());
    }
}

#[test]
fn between_moments_the_hand_goes_straight_and_buttons_stay() {
    let mut device = device(&[moment(5.0, 0.0, 1), moment(6.0, 0.1, 2)], 0.5).unwrap();
    assert_eq!(device.seconds(), 2.0);
    assert_eq!(device.read(40.0).unwrap().buttons, 1);
    let pose = device.read(40.5).unwrap();
    assert!((pose.position[0] - 0.025).abs() < 1e-12 && (pose.position[1] + 0.025).abs() < 1e-12);
    assert!((pose.twist.unwrap() - 0.25).abs() < 1e-12);
    assert_eq!(pose.buttons, 1);
    assert_eq!(device.read(42.0).unwrap().buttons, 2);
}

#[test]
fn past_the_last_moment_it_rests_and_is_finished() {
    let mut device = device(&[moment(0.0, 0.0, 0), moment(0.5, 0.1, 0)], 100.0).unwrap();
    let finished = device.finished();
    device.read(1.0).unwrap();
    let last = device.read(1.005).unwrap();
    assert!(!device.is_finished());
    assert_eq!(last.position[0], 0.1);
    for time in [1.006, 2.0, 1e9] {
        assert_eq!(device.read(time).unwrap(), last);
        assert!(device.is_finished() && finished.load(Ordering::Relaxed));
    }
}

#[test]
fn a_single_moment_is_a_hand_at_rest() {
    let mut device = device(&[moment(3.0, 0.05, 1)], 1.0).unwrap();
    assert_eq!(device.read(0.0).unwrap().position[0], 0.05);
    assert!(!device.is_finished());
    device.read(0.001).unwrap();
    assert!(device.is_finished());
}

#[test]
fn a_handle_that_does_not_tell_its_turn_tells_none() {
    let silent = |time| HandMoment { twist: None, ..moment(time, 0.0, 0) };
    let mut device = device(&[silent(0.0), silent(1.0)], 1.0).unwrap();
    device.read(0.0).unwrap();
    assert_eq!(device.read(0.5).unwrap().twist, None);
}

#[test]
fn what_cannot_be_played_is_refused() {
    assert_eq!(device(&[], 1.0).unwrap_err(), PathError::Empty);
    let times = [moment(1.0, 0.0, 0), moment(1.0, 0.0, 0)];
    let error = device(&times, 1.0).unwrap_err();
    assert_eq!(error, PathError::NotRising { index: 1, time: 1.0, previous: 1.0 });
    for wrong in [
        moment(f64::NAN, 0.0, 0),
        moment(2.0, f64::INFINITY, 0),
        HandMoment { twist: Some(f64::NAN), ..moment(2.0, 0.0, 0) },
    ] {
        let error = device(&[moment(1.0, 0.0, 0), wrong], 1.0).unwrap_err();
        assert_eq!(error, PathError::NotFinite { index: 1 });
    }
    for speed in [0.0, 0.099, 100.1, -1.0, f64::NAN] {
        let error = device(&[moment(1.0, 0.0, 0)], speed).unwrap_err();
        assert!(matches!(error, PathError::Workspace(ParameterError { name: "speed", .. })));
    }
    assert!(PlaybackDevice::new(ticks(), 1.0, [0.0; 3]).is_err());
}
