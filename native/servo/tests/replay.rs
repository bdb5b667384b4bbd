//! Takes that are played again.

mod common;

use std::sync::Arc;
use std::sync::atomic::Ordering;

use common::handheld::{Play, settings};
use common::*;
use contact::{ContactModel, Model};
use devices::{PathError, PlaybackDevice};
use servo::{Held, Mode, Replay, Session, Settings};
use surface::Grid;
use takes::{Header, Take};

const WORKSPACE: [f64; 3] = [0.16, 0.12, 0.12];

fn rough(column: u32, row: u32) -> f64 {
    // Any deterministic roughness will do.
    f64::from((column * 7919 + row * 104_729) % 17) * 0.05
}

fn model() -> Box<dyn ContactModel> {
    Model::default().build(STEP_BUDGET)
}

/// A hand that wanders through the ground and out of it.
fn recorded(grid: Arc<Grid>) -> Take {
    let path: Vec<_> = (0..40)
        .map(|turn| {
            let (at, side) = (f64::from(turn), if turn % 2 == 0 { 1.0 } else { -1.0 });
            (at * 0.1, 0.06 * side, 0.001 * at, if turn % 5 == 0 { 0.03 } else { -0.006 })
        })
        .collect();
    let device = Box::new(scripted(&path));
    let mut session = Session::new(grid, device, model(), window(), Settings::default()).unwrap();
    session.start_recording(String::new(), None).unwrap();
    session.step(4000).unwrap();
    session.stop_recording().unwrap().take
}

fn played(take: &Take, grid: Arc<Grid>, settings: Settings, speed: f64) -> (Session, Take) {
    let replay = Replay::of(take).unwrap();
    let device = PlaybackDevice::new(replay.hand, speed, WORKSPACE).unwrap();
    let ticks = (device.seconds() * 1000.0).round() as u64 + 1;
    let mut session =
        Session::new(grid, Box::new(device), model(), replay.window, settings).unwrap();
    session.start_recording(String::new(), None).unwrap();
    session.step(ticks).unwrap();
    let take = session.recorded().unwrap();
    (session, take)
}

fn bits(take: &Take) -> Vec<[u64; 9]> {
    let bits = |tick: &takes::Tick| {
        let numbers = [tick.hand, tick.goal, tick.proxy].concat();
        std::array::from_fn(|number| numbers[number].to_bits())
    };
    take.ticks.iter().map(bits).collect()
}

#[test]
fn a_take_played_at_its_own_speed_is_the_same_to_the_bit() {
    let grid = ground(rough);
    let take = recorded(Arc::clone(&grid));
    let (_, again) = played(&take, grid, Settings::default(), 1.0);
    assert!(take.ticks.iter().any(|tick| tick.feature != 0));
    assert_eq!(bits(&again), bits(&take));
    assert_eq!(again.ticks.last().unwrap().force, take.ticks.last().unwrap().force);
}

#[test]
fn a_take_played_slowly_passes_every_place_between() {
    let grid = ground(rough);
    let take = recorded(Arc::clone(&grid));
    let (_, slow) = played(&take, Arc::clone(&grid), Settings::default(), 0.25);
    assert_eq!(slow.ticks.len(), 4 * (take.ticks.len() - 1) + 1);
    let hands: Vec<_> = slow.ticks.iter().map(|tick| tick.hand).collect();
    for (number, tick) in take.ticks.iter().enumerate() {
        assert_eq!(hands[4 * number], tick.hand, "{number}");
    }
    let (_, fast) = played(&take, grid, Settings::default(), 10.0);
    assert_eq!(fast.ticks.len(), 401);
    assert_eq!(fast.ticks.last().unwrap().hand, take.ticks.last().unwrap().hand);
}

#[test]
fn past_its_end_the_hand_rests_and_feels_nothing() {
    let grid = ground(rough);
    // It ends in the ground.
    let mut take = Take::new(Header { workspace: WORKSPACE, ..Header::default() }, None);
    recorded(Arc::clone(&grid)).ticks.iter().take(1850).for_each(|tick| take.push(*tick));
    let replay = Replay::of(&take).unwrap();
    let device = PlaybackDevice::new(replay.hand, 1.0, WORKSPACE).unwrap();
    let finished = device.finished();
    let mut session =
        Session::new(grid, Box::new(device), model(), replay.window, Settings::default()).unwrap();
    session.step(1850).unwrap();
    assert!(session.state().force != [0.0; 3] && session.state().held.is_none());
    assert!(!finished.load(Ordering::Relaxed));
    session.step(10).unwrap();
    let state = session.state();
    assert_eq!((state.force, state.held), ([0.0; 3], Some(Held::Finished)));
    assert_eq!(state.hand, take.ticks.last().unwrap().hand);
    assert!(finished.load(Ordering::Relaxed));
    session.step(1000).unwrap();
    assert_eq!(session.state().held, Some(Held::Finished));
    assert_eq!(session.fault(), None);
}

/// The window pans, zooms and turns meanwhile.
fn recorded_with_modes() -> Take {
    let mut play = Play::on(ground(rough), window(), settings());
    play.session.start_recording(String::new(), None).unwrap();
    play.rest(1);
    play.go([0.0, 0.0, -0.006], 200);
    play.button(true);
    play.go([0.03, 0.01, -0.006], 300);
    assert_eq!(play.session.state().mode, Mode::Pan);
    play.button(false);
    play.go([0.0, 0.0, 0.03], 300);
    play.button(true);
    play.go([0.0, 0.0, 0.045], 300);
    play.twist(0.7, 200);
    assert_eq!(play.session.state().mode, Mode::Zoom);
    play.button(false);
    play.go([-0.01, 0.02, -0.02], 400);
    play.go([0.2, 0.02, 0.02], 400); // through the wall
    play.session.stop_recording().unwrap().take
}

#[test]
fn a_take_whose_window_moved_leads_the_same_goal_over_the_same_ground() {
    let take = recorded_with_modes();
    let moved = |tick: &&takes::Tick| tick.window != take.ticks.first().unwrap().window;
    assert!(take.ticks.iter().filter(moved).count() > 500);
    let (_, again) = played(&take, ground(rough), Settings::default(), 1.0);
    assert_eq!(again.ticks.len(), take.ticks.len());
    for (then, now) in take.ticks.iter().zip(again.ticks.iter()) {
        for axis in 0..3 {
            // A millionth of the window, 16 m.
            assert!((then.goal[axis] - now.goal[axis]).abs() < 16e-6);
        }
    }
}

#[test]
fn an_empty_take_is_refused() {
    let empty = Take::new(Header::default(), None);
    assert_eq!(Replay::of(&empty).unwrap_err(), PathError::Empty);
}
