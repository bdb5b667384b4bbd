//! Takes: every tick, in memory and on the disk, live and stepped.

mod common;

use std::fs;
use std::path::PathBuf;
use std::sync::atomic::{AtomicU32, Ordering};

use common::handheld::Play;
use common::*;
use devices::{DeviceError, Hand, SimulatedDevice};
use servo::{Mode, Session, SessionError, Settings};
use takes::{Take, Tick};

/// A file of a test's own, removed in the end.
struct Scratch(PathBuf);

impl Scratch {
    fn new() -> Scratch {
        static NUMBER: AtomicU32 = AtomicU32::new(0);
        let number = NUMBER.fetch_add(1, Ordering::Relaxed);
        let name = format!("recording-{}-{number}.touch", std::process::id());
        Scratch(std::env::temp_dir().join(name))
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        let _ = fs::remove_file(&self.0);
    }
}

fn rough(column: u32, row: u32) -> f64 {
    // Any deterministic roughness will do.
    f64::from((column * 7919 + row * 104_729) % 17) * 0.05
}

/// A hand that goes down into rough ground, on a ring of so many seconds.
fn stepped(ring_seconds: f64) -> Session {
    let device =
        scripted(&[(0.0, -0.05, 0.0, 0.02), (0.1, -0.05, 0.0, -0.01), (3.0, 0.05, 0.03, -0.01)]);
    let settings = Settings { ring_seconds, ..Settings::default() };
    Session::new(ground(rough), Box::new(device), proxy_graph(), window(), settings).unwrap()
}

fn live(ring_seconds: f64) -> Session {
    let device = SimulatedDevice::new(Hand::default()).unwrap();
    let settings = Settings { ring_seconds, ..Settings::default() };
    Session::new(ground(rough), Box::new(device), proxy_graph(), window(), settings).unwrap()
}

fn numbers(take: &Take) -> Vec<u64> {
    take.ticks.iter().map(|tick| tick.number).collect()
}

#[test]
fn a_stepped_take_has_every_tick_however_small_the_ring_and_the_steps() {
    let mut plain = stepped(10.0);
    plain.step(5000).unwrap();
    let felt: Vec<Tick> = plain.drain().iter().map(Tick::from).collect();
    for (ring_seconds, step) in [(10.0, 5000), (0.01, 5000), (10.0, 1), (0.003, 7)] {
        let mut session = stepped(ring_seconds);
        session.start_recording("{}".into(), None).unwrap();
        for done in (0..5000).step_by(step as usize) {
            session.step(step.min(5000 - done)).unwrap();
        }
        let recorded = session.stop_recording().unwrap();
        assert_eq!(recorded.take.dropped, 0);
        assert!(recorded.take.ticks.iter().eq(&felt));
        assert_eq!(session.statistics().totals.dropped, 0);
    }
}

#[test]
fn a_take_begins_and_ends_where_it_was_asked_to() {
    let mut session = stepped(10.0);
    session.step(100).unwrap();
    session.start_recording("about".into(), None).unwrap();
    session.step(50).unwrap();
    assert_eq!(numbers(&session.recorded().unwrap()), (101..=150).collect::<Vec<_>>());
    session.step(50).unwrap();
    let take = session.stop_recording().unwrap().take;
    session.step(50).unwrap();
    assert_eq!(numbers(&take), (101..=200).collect::<Vec<_>>());
    assert_eq!((take.header.about.as_str(), take.header.pre_roll), ("about", 0));
    assert_eq!(take.header.workspace, [0.16, 0.12, 0.12]);
}

#[test]
fn what_was_lost_before_a_take_is_none_of_its_business() {
    let mut session = stepped(0.05);
    session.step(200).unwrap();
    assert_eq!(session.statistics().totals.dropped, 150);
    session.start_recording(String::new(), None).unwrap();
    session.step(100).unwrap();
    let take = session.stop_recording().unwrap().take;
    assert_eq!((numbers(&take), take.dropped), ((201..=300).collect(), 0));
}

#[test]
fn a_pre_roll_is_what_a_take_begins_with() {
    let mut session = stepped(10.0);
    session.step(10).unwrap();
    session.set_pre_roll(0.1).unwrap();
    session.step(40).unwrap();
    session.start_recording(String::new(), None).unwrap();
    session.step(5).unwrap();
    let short = session.stop_recording().unwrap().take;
    assert_eq!((numbers(&short), short.header.pre_roll), ((1..=55).collect(), 50));
    session.step(3000).unwrap();
    session.start_recording(String::new(), None).unwrap();
    session.step(5).unwrap();
    let long = session.stop_recording().unwrap().take;
    assert_eq!((numbers(&long), long.header.pre_roll), ((2956..=3060).collect(), 100));
    assert_eq!((short.dropped, long.dropped), (0, 0));
    session.set_pre_roll(0.0).unwrap();
    session.start_recording(String::new(), None).unwrap();
    assert_eq!(session.stop_recording().unwrap().take.ticks.len(), 0);
    for seconds in [-1.0, f64::NAN, 3601.0] {
        let refused = session.set_pre_roll(seconds).unwrap_err().to_string();
        assert!(refused.contains("pre_roll"), "{refused}");
    }
}

#[test]
fn drains_go_on_while_a_take_is_recorded() {
    let mut session = stepped(0.1);
    session.set_pre_roll(0.02).unwrap();
    session.start_recording(String::new(), None).unwrap();
    session.step(60).unwrap();
    let first: Vec<u64> = session.drain().iter().map(|record| record.tick).collect();
    session.step(30).unwrap();
    let second: Vec<u64> = session.drain().iter().map(|record| record.tick).collect();
    session.step(500).unwrap();
    let third: Vec<u64> = session.drain().iter().map(|record| record.tick).collect();
    assert_eq!(first, (1..=60).collect::<Vec<_>>());
    assert_eq!(second, (61..=90).collect::<Vec<_>>());
    assert_eq!(third, (491..=590).collect::<Vec<_>>(), "the newest, as many as the ring takes");
    assert_eq!(session.drain(), []);
    assert_eq!(session.stop_recording().unwrap().take.ticks.len(), 590);
}

#[test]
fn a_stepped_spool_is_a_second_behind_at_most_and_whole_in_the_end() {
    let scratch = Scratch::new();
    let mut session = stepped(10.0);
    session.start_recording("about".into(), Some(&scratch.0)).unwrap();
    for _ in 0..2500 {
        session.step(1).unwrap();
        let recording = session.recording().unwrap();
        assert!(recording.ticks - recording.spooled < 1000);
    }
    let spooled = session.recording().unwrap().spooled;
    let left = takes::read(&scratch.0).unwrap();
    assert_eq!((left.take.ticks.len(), left.finished), (spooled, false));
    let recorded = session.stop_recording().unwrap();
    let saved = takes::read(&scratch.0).unwrap();
    assert!(saved.finished && saved.lost.is_none() && recorded.failure.is_none());
    assert_eq!(saved.take.header, recorded.take.header);
    assert!(saved.take.ticks.iter().eq(recorded.take.ticks.iter()));
    assert!(takes::claim(&scratch.0).is_err(), "its maker has it still");
    recorded.spool.unwrap().remove().unwrap();
    assert!(!scratch.0.exists());
}

#[test]
fn a_session_that_is_dropped_leaves_what_it_had() {
    let scratch = Scratch::new();
    let mut session = live(60.0);
    session.start_recording(String::new(), Some(&scratch.0)).unwrap();
    session.start().unwrap();
    wait_until(|| session.state().tick > 20);
    session.stop();
    let ticks = session.state().tick as usize;
    drop(session);
    let (left, spool) = takes::claim(&scratch.0).unwrap();
    assert_eq!((left.take.ticks.len(), left.finished), (ticks, false));
    spool.remove().unwrap();
}

#[test]
fn a_live_take_is_collected_and_spooled_while_nobody_looks() {
    let scratch = Scratch::new();
    let mut session = live(60.0);
    session.start().unwrap();
    wait_until(|| session.state().tick > 10);
    session.start_recording(String::new(), Some(&scratch.0)).unwrap();
    wait_until(|| session.recording().unwrap().spooled > 150);
    let recorded = session.stop_recording().unwrap();
    session.stop();
    let found = numbers(&recorded.take);
    assert!(found.windows(2).all(|pair| pair[1] == pair[0] + 1));
    assert!(found[0] > 10 && recorded.take.dropped == 0 && found.len() > 150);
    assert_eq!(numbers(&takes::read(&scratch.0).unwrap().take), found);
}

#[test]
fn a_live_take_and_its_file_are_the_same_whenever_it_ends() {
    let mut session = live(60.0);
    session.set_pre_roll(0.01).unwrap();
    session.start().unwrap();
    for round in 0..30 {
        let scratch = Scratch::new();
        session.start_recording(String::new(), Some(&scratch.0)).unwrap();
        std::thread::sleep(std::time::Duration::from_millis(3 * round));
        let recorded = session.stop_recording().unwrap();
        let saved = takes::read(&scratch.0).unwrap();
        assert!(saved.finished && saved.lost.is_none() && recorded.failure.is_none());
        assert!(saved.take.ticks.iter().eq(recorded.take.ticks.iter()));
        assert_eq!(saved.take.dropped, recorded.take.dropped);
    }
}

#[test]
fn a_live_pre_roll_is_kept_while_nobody_looks() {
    let mut session = live(0.5);
    session.set_pre_roll(0.2).unwrap();
    session.start().unwrap();
    wait_until(|| session.state().tick > 1000);
    session.start_recording(String::new(), None).unwrap();
    wait_until(|| session.recording().unwrap().ticks > 250);
    let take = session.stop_recording().unwrap().take;
    assert_eq!((take.header.pre_roll, take.dropped), (200, 0));
    assert!(numbers(&take).windows(2).all(|pair| pair[1] == pair[0] + 1));
}

#[test]
fn what_a_full_ring_loses_is_counted_and_told() {
    let mut session = live(0.004);
    session.start_recording(String::new(), None).unwrap();
    session.start().unwrap();
    wait_until(|| session.recording().unwrap().dropped > 0);
    let told: Vec<String> = session.warnings().iter().map(ToString::to_string).collect();
    assert!(told.iter().any(|line| line.contains("take has lost")), "{told:?}");
    session.stop();
    let ticks = session.statistics().totals.ticks;
    let take = session.stop_recording().unwrap().take;
    assert_eq!(take.ticks.len() as u64 + take.dropped, ticks);
}

#[test]
fn a_take_outlives_starts_stops_and_faults() {
    let mut session = live(60.0);
    session.start_recording(String::new(), None).unwrap();
    for _ in 0..3 {
        session.start().unwrap();
        let before = session.state().tick;
        wait_until(|| session.state().tick > before + 5);
        session.stop();
        session.step(5).unwrap();
    }
    let done = session.statistics().totals.ticks;
    let take = session.stop_recording().unwrap().take;
    assert_eq!(numbers(&take), (1..=done).collect::<Vec<_>>());

    let mut play = Play::new();
    play.session.start_recording(String::new(), None).unwrap();
    play.rest(10);
    play.device.lock().error = Some(DeviceError::Gone("unplugged".into()));
    assert!(play.session.step(10).is_err());
    assert_eq!(play.session.stop_recording().unwrap().take.ticks.len(), 11);
}

#[test]
fn one_take_at_a_time() {
    let scratch = Scratch::new();
    let mut session = stepped(1.0);
    assert!(matches!(session.stop_recording(), Err(SessionError::NotRecording)));
    assert!(matches!(session.recorded(), Err(SessionError::NotRecording)));
    assert_eq!(session.recording(), None);
    session.start_recording(String::new(), None).unwrap();
    let twice = session.start_recording(String::new(), Some(&scratch.0));
    assert!(matches!(twice, Err(SessionError::AlreadyRecording)));
    assert!(!scratch.0.exists());
}

#[test]
fn where_there_can_be_no_spool_there_is_no_take() {
    let mut session = stepped(1.0);
    let nowhere = std::env::temp_dir().join("missing").join("take.touch");
    let refused = session.start_recording(String::new(), Some(&nowhere));
    assert!(matches!(refused, Err(SessionError::Spool(_))));
    assert_eq!(session.recording(), None);
    session.start_recording(String::new(), None).unwrap();
}

#[test]
fn a_take_knows_the_normal_and_the_buttons() {
    let mut play = Play::new();
    play.session.start_recording(String::new(), None).unwrap();
    play.rest(1);
    play.go([0.01, 0.0, -0.005], 100);
    play.device.lock().pose.buttons = 0b100;
    play.rest(1);
    play.session.press().unwrap();
    play.rest(1);
    let take = play.session.stop_recording().unwrap().take;
    let ticks: Vec<Tick> = take.ticks.iter().copied().collect();
    assert_eq!((ticks[0].feature, ticks[0].normal), (0, [0.0; 3]));
    let [.., pressed, grabbed] = ticks[..] else { panic!("there are as many") };
    assert_ne!(pressed.feature, 0);
    assert_eq!(pressed.normal, [0.0, 0.0, 1.0], "flat ground");
    assert_eq!((pressed.buttons, pressed.twist), (0b100, 0.0));
    assert_eq!((grabbed.buttons, grabbed.mode), (0b101, 1), "a key is the stylus button");
    assert_eq!(grabbed.normal, [0.0, 0.0, 1.0]);
    assert_eq!(play.session.state().mode, Mode::Pan);
}
