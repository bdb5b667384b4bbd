//! The watchdogs of a live session. Nothing here depends on how fast the machine is: what is
//! waited for comes at any speed, and no time is measured.

mod common;

use std::time::Duration;

use common::*;
use devices::DeviceError;
use servo::{Frame, STALE_AFTER, Servo, Session, Settings, Window};

/// A hand that stays a centimetre in the ground, and a session that a host must look at.
fn watched(log: &Log, stale_after: Option<f64>) -> Session {
    let settings = Settings { stale_after, ..Settings::default() };
    let device = Box::new(Watched::pressing(log));
    Session::new(flat_ground(), device, proxy_graph(), window(), settings).unwrap()
}

#[test]
fn a_host_that_does_not_look_takes_the_force_away_until_it_looks_again() {
    let log = Log::default();
    let mut session = watched(&log, Some(STALE_AFTER));
    session.start().unwrap();
    for round in 1..3 {
        wait_until(|| {
            session.heartbeat();
            log.pushes()
        });
        // Now nobody looks: statistics are for reports, not for drawing.
        wait_until(|| session.statistics().totals.trips.host_cuts >= round);
        wait_until(|| log.rests());
    }
    wait_until(|| session.state().force[2] > 0.0);
    session.stop();
    let told: Vec<String> = session.warnings().iter().map(ToString::to_string).collect();
    assert!(told.iter().any(|line| line.contains("did not answer for a while")), "{told:?}");
    assert!(session.statistics().totals.trips.host_cuts >= 2);
}

#[test]
fn a_session_that_nobody_needs_to_look_at_is_not_waited_for() {
    let log = Log::default();
    let mut session = watched(&log, None);
    session.start().unwrap();
    wait_until(|| log.reads() > 300);
    wait_until(|| log.pushes());
    session.stop();
    assert_eq!(session.statistics().totals.trips.host_cuts, 0);
}

#[test]
fn steps_wait_for_nobody() {
    let log = Log::default();
    let mut session = watched(&log, Some(STALE_AFTER));
    session.step(1000).unwrap();
    assert!(log.pushes());
    session.start().unwrap();
    session.stop();
    session.step(1).unwrap();
    session.step(1000).unwrap();
    assert_eq!(session.statistics().totals.trips.host_cuts, 0);
}

#[test]
fn a_device_that_stalls_for_a_tenth_of_a_second_comes_back_to_no_force() {
    let log = Log::default();
    let device = Watched::new(&log, |read| {
        if read == 200 {
            std::thread::sleep(Duration::from_millis(100));
        }
        Ok([0.0, 0.0, if read == 0 { 0.01 } else { -0.01 }])
    });
    let mut session = session(device, proxy_graph());
    session.start().unwrap();
    wait_until(|| log.reads() > 210);
    session.stop();
    // The force that answers the read which stalled.
    let writes = log.all();
    let after_reads = |count: usize| {
        let mut reads = 0;
        writes.iter().find_map(|seen| match seen {
            Seen::Read(_) => {
                reads += 1;
                None
            }
            Seen::Write(force, _) if reads == count => Some(*force),
            _ => None,
        })
    };
    // The stall falls into the tick that it makes late, so the one after it sees it.
    assert_eq!(after_reads(202), Some([0.0; 3]));
    assert!(session.statistics().totals.trips.late_cuts >= 1);
    assert!(session.fault().is_none());
}

#[test]
fn two_sessions_at_once_do_not_disturb_each_other() {
    let (log, other_log) = (Log::default(), Log::default());
    let mut session = watched(&log, None);
    let broken = Watched::new(&other_log, |read| match read {
        0 => Ok([0.0, 0.0, 0.01]),
        1..100 => Ok([0.0, 0.0, -0.01]),
        _ => Err(DeviceError::Gone("unplugged".into())),
    });
    let mut other = common::session(broken, proxy_graph());
    session.start().unwrap();
    other.start().unwrap();
    wait_until(|| !other.running());
    assert_eq!(other_log.last_force(), [0.0; 3]);
    let before = log.reads();
    wait_until(|| log.reads() > before + 100 && log.pushes());
    assert!(session.running() && session.fault().is_none());
    let mut third = watched(&other_log, None);
    third.start().unwrap();
    wait_until(|| other_log.pushes());
    drop((session, third));
    assert_eq!((log.last_force(), other_log.last_force()), ([0.0; 3], [0.0; 3]));
}

#[test]
fn full_queues_hold_up_neither_the_force_nor_its_end() {
    let log = Log::default();
    let settings = Settings { ring_seconds: 0.01, ..Settings::default() };
    let device = Box::new(Watched::pressing(&log));
    let mut session =
        Session::new(flat_ground(), device, proxy_graph(), window(), settings).unwrap();
    session.start().unwrap();
    wait_until(|| log.pushes());
    // More than the loop takes between two looks; whether one is refused is up to the machine.
    let elsewhere = Window::new(20.0, -40.0, 0.0, 8.0, 1.0).unwrap();
    let refused: Vec<String> = (0..2000)
        .filter_map(|_| session.set_window(elsewhere).err())
        .map(|error| error.to_string())
        .collect();
    assert!(refused.iter().all(|words| words.contains("commands wait for the servo already")));
    let before = log.reads();
    wait_until(|| log.reads() > before + 50);
    session.stop();
    assert_eq!(log.last_force(), [0.0; 3]);
    assert!(session.statistics().totals.dropped > 0);
    let told = |session: &mut Session| -> Vec<String> {
        session.warnings().iter().map(ToString::to_string).collect()
    };
    let tells = |lines: &[String]| lines.iter().any(|line| line.contains("nobody drained them"));
    assert!(!tells(&told(&mut session)), "nobody wants them so far");
    session.drain();
    assert!(tells(&told(&mut session)));
}

#[test]
fn what_a_device_failed_at_before_a_pause_is_not_held_against_it() {
    let log = Log::default();
    // Every third read fails: nine times in the 27 ticks before the pause, and again after it.
    let device = Watched::new(&log, |read| {
        if read % 3 == 2 { Err(DeviceError::Timeout("late".into())) } else { Ok([0.0; 3]) }
    });
    let ground = flat_ground();
    let frame = Frame::new(window(), 0.16, ground.layout()).unwrap();
    let mut servo =
        Servo::new(Box::new(device), proxy_graph(), ground, frame, &Settings::default()).unwrap();
    let mut time = 0.0;
    let mut run = |servo: &mut Servo, ticks: u32| {
        for _ in 0..ticks {
            time += 1e-3;
            servo.tick(time, 1e-3);
        }
    };
    run(&mut servo, 27);
    servo.release();
    run(&mut servo, 27);
    assert_eq!(servo.fault(), None);
    run(&mut servo, 3);
    assert!(servo.fault().is_some(), "the tenth without a pause between");
}
