//! Sessions on the clock. Nothing here depends on how fast the machine is.

mod common;

use std::time::Duration;

use common::*;
use contact::Feature;
use devices::DeviceError;
use servo::{Session, SessionError, Settings};
use surface::GridPoint;

fn wait_for_reads(log: &Log, reads: usize) {
    wait_until(|| log.reads() >= reads);
}

#[test]
fn a_live_session_ticks_by_itself_and_records_every_tick() {
    let log = Log::default();
    let mut session = session(Watched::pressing(&log), proxy_graph());
    session.start().unwrap();
    // On a busy machine missed ticks may hold the force back for a while.
    wait_until(|| log.reads() >= 20 && log.pushes());
    assert!(session.running());
    session.stop();
    assert!(!session.running());

    let statistics = session.statistics();
    let records = session.drain();
    assert!(statistics.totals.ticks >= 20);
    assert_eq!(records.len() as u64, statistics.totals.ticks);
    assert!(records.windows(2).all(|pair| pair[1].tick == pair[0].tick + 1));
    assert!(records.windows(2).all(|pair| pair[1].time > pair[0].time));
    assert_eq!(statistics.update_times.count(), statistics.totals.ticks);
    assert_eq!(statistics.lateness.count(), statistics.totals.ticks);
    assert!(records.iter().any(|record| record.force[2] > 0.0));
    assert_eq!(session.state().force, [0.0; 3], "a session that stands gives no force");
}

#[test]
fn steps_and_deadlines_together_make_the_time() {
    let log = Log::default();
    let mut session = session(Watched::pressing(&log), proxy_graph());
    session.step(10).unwrap();
    session.start().unwrap();
    wait_for_reads(&log, 20);
    session.stop();
    session.start().unwrap();
    wait_for_reads(&log, log.reads() + 5);
    session.stop();
    let paused = session.statistics().totals;
    session.step(3).unwrap();

    let records = session.drain();
    assert!(records.windows(2).all(|pair| pair[1].time > pair[0].time), "time never jumps back");
    let last = records.last().unwrap();
    assert_eq!(last.tick, paused.ticks + 3);
    // A millisecond for each tick done or missed: pauses between runs do not count.
    assert_eq!(last.time, (last.tick + paused.missed_ticks) as f64 / 1000.0);
}

#[test]
fn the_force_acts_for_as_long_as_its_tick_lasted() {
    let log = Log::default();
    let device = Watched::new(&log, |read| {
        if read % 4 == 3 {
            std::thread::sleep(Duration::from_micros(2500));
        }
        Ok([0.0; 3])
    });
    let mut session = session(device, proxy_graph());
    session.start().unwrap();
    wait_for_reads(&log, 20);
    session.stop();
    let records = session.drain();
    let seconds: f64 =
        log.all().iter().map(|seen| if let Seen::Write(_, dt) = seen { *dt } else { 0.0 }).sum();
    assert!((seconds - records.last().unwrap().time).abs() < 1e-9, "no time is lost or doubled");
}

#[test]
fn starting_twice_and_stepping_live_are_refused() {
    let mut session = session(Watched::pressing(&Log::default()), proxy_graph());
    session.stop();
    session.start().unwrap();
    assert!(matches!(session.start(), Err(SessionError::AlreadyRunning)));
    assert!(matches!(session.step(1), Err(SessionError::Live)));
    assert!(session.running(), "a refused call changes nothing");
    session.stop();
    session.stop();
    session.step(1).unwrap();
}

#[test]
fn stop_leaves_zero_force() {
    let log = Log::default();
    let mut session = session(Watched::pressing(&log), proxy_graph());
    session.start().unwrap();
    wait_until(|| log.pushes());
    session.stop();
    assert_eq!(log.last_force(), [0.0; 3]);
    let reads = log.reads();
    std::thread::sleep(Duration::from_millis(5));
    assert_eq!(log.reads(), reads, "the thread has ended");
}

#[test]
fn a_dropped_session_leaves_zero_force_and_frees_its_device() {
    let log = Log::default();
    let mut session = session(Watched::pressing(&log), proxy_graph());
    session.start().unwrap();
    wait_until(|| log.pushes());
    drop(session);
    assert_eq!(log.last_force(), [0.0; 3]);
    assert!(log.dropped(), "nothing happens to a device after its end");
}

#[test]
fn a_restarted_session_begins_with_the_proxy_at_the_hand() {
    let log = Log::default();
    let mut session = session(Watched::pressing(&log), proxy_graph());
    session.start().unwrap();
    wait_until(|| log.pushes());
    session.stop();
    session.drain();
    session.start().unwrap();
    wait_for_reads(&log, log.reads() + 5);
    session.stop();
    // The hand is still in the ground: it must not be kicked out of it.
    assert!(session.drain().iter().all(|record| record.force == [0.0; 3]));
}

#[test]
fn a_fault_ends_the_thread_by_itself() {
    let log = Log::default();
    let device = Watched::new(&log, |read| match read {
        0 => Ok([0.0, 0.0, 0.01]),
        1..10 => Ok([0.0, 0.0, -0.01]),
        _ => Err(DeviceError::Timeout("no packet".into())),
    });
    let mut session = session(device, proxy_graph());
    session.start().unwrap();
    wait_until(|| !session.running());
    let words = "touch ended because the device did not answer in time: no packet";
    assert_eq!(session.fault().unwrap().to_string(), words);
    assert_eq!(log.last_force(), [0.0; 3]);
    assert_eq!(session.state().force, [0.0; 3]);
    assert_eq!(session.start().unwrap_err().to_string(), words);
    assert_eq!(session.step(1).unwrap_err().to_string(), words);
    // What a timer still asks for after the end is not an error of its own.
    session.set_target([0.0; 3]).unwrap();
    session.set_window(window()).unwrap();
    session.stop();
    assert!(session.start().is_err(), "nor is it started after it was stopped");
    assert_eq!(log.reads(), 13, "two failures in a row are forgiven, the third is not");
}

#[test]
fn a_panic_on_the_thread_leaves_zero_force_and_words() {
    let mut updates = 0;
    let breaks = move |goal: &GridPoint| {
        updates += 1;
        assert!(updates < 5, "the fifth update breaks");
        (GridPoint { elevation: 0.0, ..*goal }, Feature::Face)
    };
    let log = Log::default();
    let mut session = session(Watched::pressing(&log), Box::new(Told(breaks)));
    session.start().unwrap();
    wait_until(|| !session.running());
    let words = session.fault().unwrap().to_string();
    assert!(words.contains("the fifth update breaks"), "{words}");
    assert_eq!(log.last_force(), [0.0; 3]);
    session.stop();
}

#[test]
fn a_device_that_panics_whenever_it_is_touched_does_no_more_harm() {
    struct Broken;
    impl devices::Device for Broken {
        fn capabilities(&self) -> devices::Capabilities {
            Watched::pressing(&Log::default()).capabilities
        }
        fn read(&mut self, _time: f64) -> Result<devices::Pose, DeviceError> {
            panic!("broken read")
        }
        fn write(&mut self, _force: devices::Force, _dt: f64) -> Result<(), DeviceError> {
            panic!("broken write")
        }
    }
    let mut session = session(Broken, proxy_graph());
    session.start().unwrap();
    wait_until(|| !session.running());
    assert!(session.fault().unwrap().to_string().contains("broken"));
    drop(session);
}

#[test]
fn slow_ticks_miss_deadlines_and_are_not_caught_up() {
    let log = Log::default();
    let device = Watched::new(&log, |read| {
        if read == 2 {
            std::thread::sleep(Duration::from_millis(5));
        }
        Ok([0.0, 0.0, 0.01])
    });
    let mut session = session(device, proxy_graph());
    session.start().unwrap();
    wait_for_reads(&log, 6);
    session.stop();
    let totals = session.statistics().totals;
    let records = session.drain();
    assert!(totals.missed_ticks >= 4, "{} missed", totals.missed_ticks);
    // The tick after the slow one belongs to a later deadline, at least five on.
    assert!(records[3].time - records[2].time > 0.0049);
    // Each deadline is served once at most, so the ticks after it cannot come in a burst.
    assert!(records.windows(2).all(|pair| pair[1].time - pair[0].time > 0.0009));
}

#[test]
fn commands_reach_a_running_loop() {
    let log = Log::default();
    let mut session = session(Watched::pressing(&log), proxy_graph());
    session.start().unwrap();
    session.set_target([0.1, 0.0, 0.0]).unwrap();
    session.set_target([0.2, 0.0, 0.0]).unwrap();
    let elsewhere = servo::Window::new(20.0, -40.0, 0.0, 8.0, 1.0).unwrap();
    session.set_window(elsewhere).unwrap();
    wait_until(|| session.state().goal[..2] == [20.0, -40.0]);
    session.stop();
    let targets: Vec<Seen> =
        log.all().into_iter().filter(|seen| matches!(seen, Seen::Target(_))).collect();
    assert_eq!(targets, [Seen::Target([0.1, 0.0, 0.0]), Seen::Target([0.2, 0.0, 0.0])]);
}

#[test]
fn commands_that_nobody_takes_are_refused_and_not_lost_silently() {
    let (let_go, held) = std::sync::mpsc::channel::<()>();
    let log = Log::default();
    let device = Watched::new(&log, move |read| {
        if read == 0 {
            // A device that stalls, until the test lets go.
            let _ = held.recv();
        }
        Ok([0.0; 3])
    });
    let mut session = session(device, proxy_graph());
    session.start().unwrap();
    wait_for_reads(&log, 1);
    let refused = (0..1000).find_map(|_| session.set_target([0.0; 3]).err());
    drop(let_go);
    assert!(matches!(refused, Some(SessionError::CommandsFull)));
    session.stop();
    session.set_target([0.0; 3]).unwrap();
}

#[test]
fn a_session_may_move_to_another_thread() {
    fn may_move<T: Send>() {}
    may_move::<Session>();
}

#[test]
fn a_full_ring_never_holds_up_the_loop() {
    let log = Log::default();
    let settings = Settings { ring_seconds: 0.004, ..Settings::default() };
    let device = Box::new(Watched::pressing(&log));
    let mut session =
        Session::new(flat_ground(), device, proxy_graph(), window(), settings).unwrap();
    session.start().unwrap();
    wait_for_reads(&log, 20);
    session.stop();
    let totals = session.statistics().totals;
    assert_eq!(session.drain().len(), 4);
    assert_eq!(totals.dropped, totals.ticks - 4);
}
