//! What a tick does, seen in stepped sessions.

mod common;

use common::*;
use contact::Feature;
use devices::{DeviceError, Hand, SimulatedDevice};
use servo::{Fault, Held, Session, SessionError, Settings, TickRecord, Window};
use surface::GridPoint;

fn rolling_hills(column: u32, row: u32) -> f64 {
    (f64::from(column) * 0.7).sin() + (f64::from(row) * 0.9).cos()
}

fn touch_hills() -> Session {
    let device = SimulatedDevice::new(Hand::default()).unwrap();
    let ground = ground(rolling_hills);
    let mut session =
        Session::new(ground, Box::new(device), proxy_graph(), window(), Settings::default())
            .unwrap();
    session.set_target([0.03, -0.02, -0.02]).unwrap();
    session
}

/// All numbers of all ticks, bit by bit.
fn bits(records: &[TickRecord]) -> Vec<u64> {
    let mut bits = Vec::new();
    for record in records {
        bits.extend([record.tick, record.time.to_bits(), record.feature as u64]);
        for vector in [record.hand, record.goal, record.proxy, record.force] {
            bits.extend(vector.map(f64::to_bits));
        }
        bits.extend(
            [record.vertices, record.faces, record.collision_tests, record.cells].map(u64::from),
        );
    }
    bits
}

#[test]
fn stepping_twice_gives_the_same_bits() {
    let (mut one, mut other) = (touch_hills(), touch_hills());
    one.step(1000).unwrap();
    for _ in 0..100 {
        other.step(10).unwrap();
    }
    let records = one.drain();
    assert_eq!(records.len(), 1000);
    assert!(records.iter().any(|record| record.feature != Feature::Free));
    assert_eq!(bits(&records), bits(&other.drain()));
}

#[test]
fn time_is_ticks_over_a_thousand() {
    let mut session = touch_hills();
    session.step(1234).unwrap();
    let state = session.state();
    assert_eq!((state.tick, state.time), (1234, 1.234));
    assert_eq!(session.drain()[0].time, 0.001);
}

#[test]
fn before_the_first_tick_everything_rests_at_the_window() {
    let state = touch_hills().state();
    assert_eq!((state.tick, state.time, state.force), (0, 0.0, [0.0; 3]));
    assert_eq!(state.goal, [32.0, -32.0, 0.0]);
    assert!(!state.in_contact());
}

#[test]
fn the_spring_pushes_the_hand_out_of_the_ground() {
    let device = scripted(&[(0.0, 0.0, 0.0, 0.02), (0.03, 0.0, 0.0, -0.01)]);
    let mut session = session(device, proxy_graph());
    session.step(50).unwrap();
    let state = session.state();
    assert!(state.in_contact());
    // 1 cm at 500 N/m, straight up: the ground is flat.
    let [x, y, z] = state.force;
    assert!(x.abs() < 1e-9 && y.abs() < 1e-9 && (z - 5.0).abs() < 1e-9, "{:?}", state.force);
    assert!((state.goal[2] + 1.0).abs() < 1e-9, "1 cm of workspace is 1 m of terrain");
    assert!(state.proxy[2].abs() < 1e-9);
}

#[test]
fn a_simulated_hand_is_held_up_by_the_ground() {
    let device = SimulatedDevice::new(Hand::default()).unwrap();
    let mut session = session(device, proxy_graph());
    session.set_target([0.0, 0.0, -0.02]).unwrap();
    session.step(3000).unwrap();
    // Muscle 300 N/m and ground 500 N/m share the 2 cm.
    let depth = session.state().hand[2];
    assert!((depth + 0.02 * 300.0 / 800.0).abs() < 1e-6, "{depth}");
}

#[test]
fn in_the_air_the_force_is_exactly_zero() {
    let device = scripted(&[(0.0, -0.05, 0.0, 0.03), (1.0, 0.05, 0.01, 0.02)]);
    let mut session = session(device, proxy_graph());
    session.step(1000).unwrap();
    for record in session.drain() {
        assert_eq!((record.feature, record.force), (Feature::Free, [0.0; 3]));
        assert_eq!(record.proxy, record.goal);
    }
    assert_eq!(session.statistics().totals.contact_ticks, 0);
}

#[test]
fn a_free_proxy_gives_no_force_even_where_it_lags() {
    let behind =
        |goal: &GridPoint| (GridPoint { elevation: goal.elevation + 3.0, ..*goal }, Feature::Free);
    let mut session = session(Watched::pressing(&Log::default()), Box::new(Told(behind)));
    session.step(3).unwrap();
    assert_eq!(session.state().force, [0.0; 3]);
}

#[test]
fn a_hand_that_begins_in_the_ground_is_not_pushed() {
    let device = scripted(&[(0.0, 0.0, 0.0, -0.02)]);
    let mut session = session(device, proxy_graph());
    session.step(20).unwrap();
    assert!(session.drain().iter().all(|record| record.force == [0.0; 3]));
}

#[test]
fn forces_are_cut_to_the_lower_limit() {
    for (persons, devices, expected) in [(2.0, 8.0, 2.0), (8.0, 3.0, 3.0)] {
        let log = Log::default();
        let mut device = Watched::pressing(&log);
        device.capabilities.max_force = devices;
        let settings = Settings { stiffness: 1000.0, max_force: persons, ..Settings::default() };
        let mut session =
            Session::new(flat_ground(), Box::new(device), proxy_graph(), window(), settings)
                .unwrap();
        assert_eq!(session.limits().max_force, expected);
        session.step(60).unwrap();
        assert_eq!(session.statistics().totals.trips.clamped, 59, "all but the tick in the air");
        assert!((log.last_force()[2] - expected).abs() < 1e-12);
    }
}

#[test]
fn the_stiffness_is_cut_to_what_the_device_can_show() {
    let log = Log::default();
    let mut device = Watched::pressing(&log);
    device.capabilities.max_stiffness = 300.0;
    device.capabilities.delay_ticks = 1;
    let mut session = session(device, proxy_graph());
    assert_eq!(session.limits().stiffness, 100.0);
    session.step(60).unwrap();
    assert!((log.last_force()[2] - 1.0).abs() < 1e-9, "1 cm at 100 N/m");
    let told: Vec<String> = session.warnings().iter().map(ToString::to_string).collect();
    assert!(told[0].contains("from 500 to 100 N/m"), "{told:?}");
}

#[test]
fn a_pose_that_is_not_a_number_gives_zero_force_and_is_counted() {
    let log = Log::default();
    let device = Watched::new(&log, |read| {
        Ok(match read {
            0 => [0.0, 0.0, 0.01],
            5 => [f64::NAN, 0.0, -0.01],
            6 => [0.0, f64::INFINITY, -0.01],
            _ => [0.0, 0.0, -0.01],
        })
    });
    let mut session = session(device, proxy_graph());
    session.step(10).unwrap();
    let records = session.drain();
    for (read, record) in records.iter().enumerate() {
        let touching = !matches!(read, 0 | 5 | 6);
        assert_eq!(record.force[2] > 0.0, touching, "tick {read}");
        assert!(record.hand.iter().chain(&record.goal).all(|number| number.is_finite()));
    }
    assert_eq!(session.statistics().totals.trips.not_finite, 2);
    assert_eq!(session.fault(), None);
}

#[test]
fn a_proxy_that_is_not_a_number_gives_zero_force_and_is_counted() {
    let mut updates = 0;
    let lost_once = move |goal: &GridPoint| {
        updates += 1;
        let elevation = if updates == 2 { f64::NAN } else { 0.0 };
        (GridPoint { elevation, ..*goal }, Feature::Face)
    };
    let log = Log::default();
    let mut session = session(Watched::pressing(&log), Box::new(Told(lost_once)));
    session.step(3).unwrap();
    assert_eq!(session.statistics().totals.trips.not_finite, 1);
    assert_eq!(log.forces()[1], [0.0; 3]);
    assert!(log.forces()[2][2] > 0.0);
    assert!(session.drain()[1].proxy.iter().all(|metres| metres.is_finite()));
}

#[test]
fn a_force_beyond_all_numbers_is_zero() {
    let far = |goal: &GridPoint| (GridPoint { elevation: f64::MAX, ..*goal }, Feature::Vertex);
    let log = Log::default();
    let settings = Settings { stiffness: 1e9, ..Settings::default() };
    let mut session = Session::new(
        flat_ground(),
        Box::new(Watched::pressing(&log)),
        Box::new(Told(far)),
        window(),
        settings,
    )
    .unwrap();
    session.step(2).unwrap();
    assert_eq!(log.last_force(), [0.0; 3]);
    assert_eq!(session.statistics().totals.trips.not_finite, 2);
}

#[test]
fn a_full_ring_counts_what_it_drops() {
    let settings = Settings { ring_seconds: 0.1, ..Settings::default() };
    let device = SimulatedDevice::new(Hand::default()).unwrap();
    let mut session =
        Session::new(flat_ground(), Box::new(device), proxy_graph(), window(), settings).unwrap();
    session.step(150).unwrap();
    assert_eq!(session.statistics().totals.dropped, 50);
    let kept = session.drain();
    assert_eq!(kept.len(), 100);
    assert_eq!((kept[0].tick, kept[99].tick), (1, 100));
    session.step(10).unwrap();
    assert_eq!(session.statistics().totals.dropped, 50, "there is room again");
    assert_eq!(session.drain()[0].tick, 151);
    assert_eq!(session.drain(), []);
}

#[test]
fn a_device_error_ends_touch_with_words_and_zero_force() {
    let log = Log::default();
    let device = Watched::new(&log, |read| match read {
        0 => Ok([0.0, 0.0, 0.01]),
        1..5 => Ok([0.0, 0.0, -0.01]),
        _ => Err(DeviceError::Gone("unplugged".into())),
    });
    let mut session = session(device, proxy_graph());
    let error = session.step(100).unwrap_err();
    assert!(matches!(error, SessionError::Faulted(Fault::Device(DeviceError::Gone(_)))));
    assert_eq!(error.to_string(), "touch ended because the device is gone: unplugged");
    assert_eq!(log.reads(), 6, "nothing is read after the fault");
    assert_eq!(log.last_force(), [0.0; 3]);
    assert_eq!(session.state().force, [0.0; 3]);
    assert!(session.step(1).is_err());
    assert!(session.start().is_err());
    assert_eq!(log.reads(), 6);
    session.stop();
    assert_eq!(session.fault().unwrap().to_string(), error.to_string());
}

#[test]
fn a_panic_in_a_model_ends_touch_with_words_and_zero_force() {
    let mut updates = 0;
    let breaks = move |goal: &GridPoint| {
        updates += 1;
        assert!(updates < 3, "the third update breaks");
        (GridPoint { elevation: 0.0, ..*goal }, Feature::Face)
    };
    let log = Log::default();
    let mut session = session(Watched::pressing(&log), Box::new(Told(breaks)));
    let error = session.step(100).unwrap_err();
    assert!(error.to_string().contains("the third update breaks"), "{error}");
    assert_eq!(log.last_force(), [0.0; 3]);
}

#[test]
fn a_new_window_holds_from_the_next_tick_without_a_jolt() {
    let log = Log::default();
    let mut session = session(Watched::pressing(&log), proxy_graph());
    session.step(5).unwrap();
    assert!(session.state().in_contact());
    let elsewhere = Window::new(20.0, -40.0, 0.5, 8.0, 2.0).unwrap();
    session.set_window(elsewhere).unwrap();
    assert_eq!(session.window(), elsewhere);
    session.step(1).unwrap();
    let state = session.state();
    assert_eq!(&state.goal[..2], &[20.0, -40.0]);
    assert_eq!(state.force, [0.0; 3], "the proxy begins at the hand");
    // The way to other ground is not a way of the hand: it has only gone down so far.
    assert_eq!(session.statistics().totals.goal_cells, 0.0);
}

#[test]
fn the_same_window_again_changes_nothing() {
    let mut session = session(Watched::pressing(&Log::default()), proxy_graph());
    session.step(5).unwrap();
    session.set_window(window()).unwrap();
    session.step(1).unwrap();
    assert!(session.state().in_contact());
}

#[test]
fn a_new_target_reaches_the_device_before_the_next_read() {
    let log = Log::default();
    let mut session = session(Watched::pressing(&log), proxy_graph());
    session.set_target([0.1, 0.2, 0.3]).unwrap();
    session.step(1).unwrap();
    assert_eq!(log.all()[..2], [Seen::Target([0.1, 0.2, 0.3]), Seen::Read(0.001)]);
}

#[test]
fn the_ground_covered_is_counted_in_cells() {
    // 3 cells east and 4 south in a straight line.
    let device = scripted(&[(0.001, 0.0, 0.0, 0.05), (0.101, 0.03, -0.04, 0.01)]);
    let mut session = session(device, proxy_graph());
    session.step(200).unwrap();
    let travelled = session.statistics().totals.goal_cells;
    assert!((travelled - 5.0).abs() < 1e-9, "{travelled}");
}

#[test]
fn counts_of_the_model_add_up() {
    let floor = |goal: &GridPoint| (GridPoint { elevation: 0.0, ..*goal }, Feature::Edge);
    let mut session = session(Watched::pressing(&Log::default()), Box::new(Told(floor)));
    session.step(7).unwrap();
    let statistics = session.statistics();
    let totals = statistics.totals;
    assert_eq!((totals.ticks, totals.contact_ticks), (7, 7));
    assert_eq!((totals.vertices, totals.faces, totals.collision_tests), (14, 21, 7));
    assert_eq!(totals.missed_ticks, 0);
    assert_eq!(statistics.update_times.count(), 7);
    assert_eq!(statistics.lateness.count(), 0, "stepped ticks have no deadline");
    assert_eq!(statistics.late_us(0.5), 0.0);
}

#[test]
fn dropping_a_stepped_session_leaves_no_force() {
    let log = Log::default();
    let mut session = session(Watched::pressing(&log), proxy_graph());
    session.step(5).unwrap();
    assert!(log.last_force()[2] > 0.0);
    drop(session);
    assert_eq!(log.last_force(), [0.0; 3]);
    assert!(log.dropped());
}

#[test]
fn the_last_zero_force_is_tried_again_where_the_device_refuses_it() {
    let log = Log::default();
    let mut device = Watched::pressing(&log);
    // The hundredth force and the next one are refused: they are the first two tries of the end.
    device.refused_writes = 100..102;
    let mut session = session(device, proxy_graph());
    session.step(100).unwrap();
    assert!(log.last_force()[2] > 0.0);
    drop(session);
    assert_eq!(log.forces().len(), 103);
    assert_eq!(log.last_force(), [0.0; 3]);
    assert!(log.dropped());
}

#[test]
fn a_write_that_fails_is_made_good_in_the_same_tick() {
    let log = Log::default();
    let mut device = Watched::pressing(&log);
    device.refused_writes = 80..81;
    let mut session = session(device, proxy_graph());
    session.step(81).unwrap();
    assert_eq!(session.state().force, [0.0; 3]);
    assert!(log.forces()[80][2] > 0.0 && log.forces()[81] == [0.0; 3]);
    assert_eq!(session.state().held, Some(Held::Device));
    session.step(200).unwrap();
    assert_eq!(session.state().held, None);
    assert!((log.last_force()[2] - 5.0).abs() < 1e-9);
}

#[test]
fn bad_settings_are_refused_by_name() {
    let good = Settings::default();
    let bad = [
        (Settings { stiffness: f64::NAN, ..good }, "stiffness"),
        (Settings { stiffness: -1.0, ..good }, "stiffness"),
        (Settings { max_force: f64::INFINITY, ..good }, "max_force"),
        (Settings { ring_seconds: 0.0, ..good }, "ring_seconds"),
        (Settings { ring_seconds: 1e12, ..good }, "ring_seconds"),
        (Settings { ring_seconds: f64::NAN, ..good }, "ring_seconds"),
        (Settings { max_slew: -1.0, ..good }, "max_slew"),
        (Settings { max_speed: 0.0, ..good }, "max_speed"),
        (Settings { stale_after: Some(0.0), ..good }, "stale_after"),
        (Settings { stale_after: Some(f64::INFINITY), ..good }, "stale_after"),
    ];
    for (settings, name) in bad {
        let device = SimulatedDevice::new(Hand::default()).unwrap();
        let refused =
            Session::new(flat_ground(), Box::new(device), proxy_graph(), window(), settings);
        assert_eq!(refused.err().expect("refused").name, name);
    }
}

#[test]
fn a_device_that_lies_about_itself_is_refused() {
    let mut device = Watched::pressing(&Log::default());
    device.capabilities.max_force = f64::NAN;
    let refused =
        Session::new(flat_ground(), Box::new(device), proxy_graph(), window(), Settings::default());
    assert_eq!(refused.err().expect("refused").name, "max_force");
}

#[test]
fn bad_windows_are_refused_by_name() {
    assert_eq!(Window::new(f64::NAN, 0.0, 0.0, 1.0, 1.0).unwrap_err().name, "window east");
    assert_eq!(Window::new(0.0, 0.0, 0.0, 0.0, 1.0).unwrap_err().name, "window width");
    assert_eq!(Window::new(0.0, 0.0, 0.0, 1.0, -2.0).unwrap_err().name, "exaggeration");
    let mut session = session(Watched::pressing(&Log::default()), proxy_graph());
    let absurd = Window::new(0.0, 0.0, 0.0, 1e-320, 1.0).unwrap();
    assert!(matches!(session.set_window(absurd), Err(SessionError::Parameter(_))));
    assert_eq!(session.window(), window(), "the old one stays");
}
