//! What a live session leaves behind for the ticks after it. Nothing here depends on how fast the
//! machine is: a session that is stopped too late passes, and no time is measured.

mod common;

use std::sync::mpsc::{Sender, channel};
use std::thread;
use std::time::Duration;

use common::*;
use devices::{DeviceError, NOMINAL_PERIOD};
use servo::Session;

/// A session whose loop stands in its first live read until told to go on.
fn stalled(log: &Log) -> (Session, Sender<()>) {
    let (let_go, held) = channel();
    let device = Watched::new(log, move |read| {
        if read == 0 {
            let _ = held.recv();
        }
        Ok([0.0; 3])
    });
    let mut session = session(device, proxy_graph());
    session.start().unwrap();
    wait_until(|| log.reads() == 1);
    (session, let_go)
}

/// Stops it with the loop still standing, so that the loop does no other tick.
fn stop_in_the_same_tick(session: &mut Session, let_go: Sender<()>) {
    let later = thread::spawn(move || {
        thread::sleep(Duration::from_millis(20));
        let _ = let_go.send(());
    });
    session.stop();
    later.join().unwrap();
}

#[test]
fn what_was_asked_before_a_stop_is_done_before_what_is_asked_after_it() {
    let log = Log::default();
    let (mut session, let_go) = stalled(&log);
    session.set_target([0.1, 0.0, 0.0]).unwrap();
    stop_in_the_same_tick(&mut session, let_go);
    session.set_target([0.2, 0.0, 0.0]).unwrap();
    session.step(1).unwrap();
    let targets: Vec<Seen> =
        log.all().into_iter().filter(|seen| matches!(seen, Seen::Target(_))).collect();
    assert_eq!(targets, [Seen::Target([0.1, 0.0, 0.0]), Seen::Target([0.2, 0.0, 0.0])]);
}

#[test]
fn deadlines_missed_before_a_stop_are_no_time_for_the_tick_after_it() {
    let log = Log::default();
    let (mut session, let_go) = stalled(&log);
    stop_in_the_same_tick(&mut session, let_go);
    session.step(1).unwrap();
    let Some(Seen::Write(_, dt)) = log.all().pop() else { panic!("a tick ends with a force") };
    assert_eq!(dt, NOMINAL_PERIOD);
}

/// Asked while the thread is still about to end.
#[test]
fn a_session_with_a_fault_does_not_run() {
    for _ in 0..200 {
        let device = Watched::new(&Log::default(), |_| Err(DeviceError::Gone("unplugged".into())));
        let mut session = session(device, proxy_graph());
        session.start().unwrap();
        wait_until(|| session.fault().is_some());
        assert!(!session.running());
    }
}
