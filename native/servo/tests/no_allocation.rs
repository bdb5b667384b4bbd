//! A tick allocates nothing: the allocator could lock, wait for another thread, or ask the system.

mod common;

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use common::*;
use contact::Feature;
use devices::{
    Capabilities, Device, DeviceError, Force, Hand, HandlePoint, Mechanism, PathPoint, Pose,
    ScriptedDevice, SimulatedDevice,
};
use servo::{Frame, Interaction, Mode, STALE_AFTER, Servo, Session, Settings, Walls, Window};
use surface::GridPoint;

thread_local! {
    /// Blocks asked for or given back by this thread.
    static CALLS: Cell<u64> = const { Cell::new(0) };
}

struct Counting;

// SAFETY: every call is passed on to the system's allocator as it came.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        CALLS.set(CALLS.get() + 1);
        // SAFETY: the caller keeps the contract of `alloc`.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, block: *mut u8, layout: Layout) {
        CALLS.set(CALLS.get() + 1);
        // SAFETY: the caller keeps the contract of `dealloc`.
        unsafe { System.dealloc(block, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

fn calls_during(work: impl FnOnce()) -> u64 {
    let before = CALLS.get();
    work();
    CALLS.get() - before
}

fn rough(column: u32, row: u32) -> f64 {
    // Any deterministic roughness will do.
    f64::from((column * 7919 + row * 104_729) % 17) * 0.3
}

fn session_with(device: impl Device + 'static, ring_seconds: f64) -> Session {
    let settings = Settings { ring_seconds, ..Settings::default() };
    Session::new(ground(rough), Box::new(device), proxy_graph(), window(), settings).unwrap()
}

/// Swipes through the ground, out of it, and off the map.
fn swipes() -> ScriptedDevice {
    let path = (0..200)
        .map(|turn| {
            let side = if turn % 2 == 0 { 1.0 } else { -1.0 };
            let height = 0.03 * f64::from(turn % 7 - 4);
            PathPoint { time: f64::from(turn) * 0.02, position: [0.5 * side, 0.1 * side, height] }
        })
        .collect();
    ScriptedDevice::new(path, [0.16, 0.12, 0.12]).unwrap()
}

#[test]
fn the_allocator_is_watched() {
    assert_eq!(calls_during(|| drop(std::hint::black_box(Box::new(1)))), 2);
}

#[test]
fn ticks_through_rough_ground_allocate_nothing() {
    let mut session = session_with(swipes(), 60.0);
    let calls = calls_during(|| session.step(4000).unwrap());
    assert_eq!(calls, 0);
    let features: Vec<Feature> = session.drain().iter().map(|record| record.feature).collect();
    assert!(features.contains(&Feature::Free) && features.contains(&Feature::Vertex));
}

#[test]
fn walls_and_passivity_control_allocate_nothing() {
    // On a device that pushes late and can show nearly nothing, so that the controller has work.
    let mechanism =
        Mechanism { delay_ticks: 3, max_stiffness: Some(5000.0), ..Mechanism::default() };
    let hand = Hand { damping: 0.2, target: [0.0, 0.0, 0.03], ..Hand::default() };
    let device = Box::new(SimulatedDevice::held(hand, mechanism).unwrap());
    let ground = ground(rough);
    let frame = Frame::new(window(), 0.16, ground.layout()).unwrap();
    let mut servo = Servo::new(device, proxy_graph(), ground, frame, &Settings::default()).unwrap();
    servo.set_walls(Some(Walls::new(0.01, 0.01).unwrap()));
    servo.set_passivity_control(true);
    servo.set_device_damping(0.1);
    servo.set_target([0.02, 0.02, -0.03]);
    let calls = calls_during(|| {
        for tick in 1..=4000 {
            servo.tick(f64::from(tick) * 1e-3, 1e-3);
        }
    });
    assert_eq!(calls, 0);
    assert!(servo.totals().contact_ticks > 0 && servo.totals().active_ticks > 0);
}

#[test]
fn modes_and_their_changes_allocate_nothing() {
    let path = (0..400).map(|turn| {
        let side = f64::from(turn % 5 - 2);
        let height = 0.01 * f64::from(turn % 7) - 0.04;
        PathPoint { time: f64::from(turn) * 0.05, position: [0.04 * side, 0.01, height] }
    });
    let handle = (0..80).map(|turn| HandlePoint {
        time: f64::from(turn) * 0.25,
        twist: f64::from(turn % 3),
        buttons: u32::from(turn % 2 == 1),
    });
    let device = ScriptedDevice::new(path.collect(), [0.16, 0.12, 0.12]).unwrap();
    let device = device.with_handle(handle.collect()).unwrap();
    let interaction = Some(Interaction::default());
    let settings = Settings { walls: true, interaction, ..Settings::default() };
    let ground = ground(rough);
    let mut session =
        Session::new(ground, Box::new(device), proxy_graph(), window(), settings).unwrap();
    let calls = calls_during(|| {
        session.step(10_000).unwrap();
        for mode in Mode::ALL {
            session.set_mode(mode).unwrap();
            session.press().unwrap();
            session.set_twist(1.0).unwrap();
            session.step(1000).unwrap();
            session.window();
        }
        session.step(7000).unwrap();
    });
    assert_eq!(calls, 0);
    let modes: Vec<Mode> = session.drain().iter().map(|record| record.mode).collect();
    assert!(Mode::ALL.iter().all(|mode| modes.contains(mode)));
    assert!(session.statistics().totals.mode_changes > 20);
}

#[test]
fn a_full_ring_and_commands_allocate_nothing() {
    let device = SimulatedDevice::new(Hand::default()).unwrap();
    let mut session = session_with(device, 0.01);
    let elsewhere = Window::new(20.0, -20.0, 2.0, 4.0, 3.0).unwrap();
    let calls = calls_during(|| {
        for turn in 0..100 {
            session.set_target([0.0, 0.01, -0.03]).unwrap();
            session.set_window(if turn % 2 == 0 { elsewhere } else { window() }).unwrap();
            session.step(10).unwrap();
            session.state();
        }
    });
    assert_eq!(calls, 0);
    assert!(session.statistics().totals.dropped > 0);
}

#[test]
fn no_stage_of_the_safety_chain_allocates() {
    let log = Log::default();
    let device = {
        let mut device = Watched::new(&log, |read| match read {
            0 => Ok([0.0, 0.0, 0.01]),
            500 | 700 | 701 => Err(DeviceError::Timeout("no packet".into())),
            900 => Ok([f64::NAN, 0.0, 0.0]),
            1000 => Ok([1.0, 0.0, 0.0]),
            _ => Ok([0.0, 0.0, -0.02 * f64::from(u8::from(read / 100 % 2 == 1))]),
        });
        device.capabilities.max_speed = 25.0;
        device
    };
    let settings = Settings {
        max_force: 5.0,
        stale_after: Some(STALE_AFTER),
        ring_seconds: 0.5,
        ..Settings::default()
    };
    let mut session =
        Session::new(flat_ground(), Box::new(device), proxy_graph(), window(), settings).unwrap();
    session.watch_host_in_steps();
    log.make_room(10_000);
    let calls = calls_during(|| {
        for turn in 0..150 {
            session.step(10).unwrap();
            session.heartbeat();
            if turn == 120 {
                session.stall(7);
            }
        }
        session.step(300).unwrap();
    });
    assert_eq!(calls, 0);
    let trips = session.statistics().totals.trips;
    assert_eq!((trips.device_errors, trips.not_finite, trips.speed_cuts), (3, 1, 1));
    assert_eq!((trips.late_cuts, trips.host_cuts), (1, 1));
    assert!(trips.clamped > 0 && trips.ramped > 0 && trips.slew_limited > 0);
    assert!(trips.engaged > 1 && session.statistics().totals.dropped > 0);
}

/// A hand in the ground that tells how often its thread has called the allocator.
struct Telltale {
    reads: Arc<AtomicU64>,
    calls: Arc<AtomicU64>,
}

impl Device for Telltale {
    fn capabilities(&self) -> Capabilities {
        Watched::pressing(&Log::default()).capabilities
    }

    fn read(&mut self, _time: f64) -> Result<Pose, DeviceError> {
        self.calls.store(CALLS.get(), Ordering::Release);
        let read = self.reads.fetch_add(1, Ordering::AcqRel);
        Ok(Pose::at([0.0, 0.0, if read == 0 { 0.01 } else { -0.01 }]))
    }

    fn write(&mut self, _force: Force, _dt: f64) -> Result<(), DeviceError> {
        Ok(())
    }
}

#[test]
fn a_tick_that_switches_models_allocates_and_frees_nothing() {
    let (reads, calls) = (Arc::new(AtomicU64::new(0)), Arc::new(AtomicU64::new(0)));
    let device = Telltale { reads: Arc::clone(&reads), calls: Arc::clone(&calls) };
    let mut session = session_with(device, 60.0);
    session.start().unwrap();
    let read_on = || {
        let before = reads.load(Ordering::Acquire);
        wait_until(|| reads.load(Ordering::Acquire) > before + 2);
        calls.load(Ordering::Acquire)
    };
    let before = read_on();
    for _ in 0..20 {
        session.set_model(Box::new(Told(|goal: &GridPoint| (*goal, Feature::Free)))).unwrap();
        wait_until(|| session.state().model == "told");
        session.set_model(proxy_graph()).unwrap();
        wait_until(|| session.state().model == "proxy_graph");
    }
    assert_eq!(read_on(), before);
    session.stop();
}

#[test]
fn a_servo_whose_ticks_are_recorded_allocates_nothing() {
    let (reads, calls) = (Arc::new(AtomicU64::new(0)), Arc::new(AtomicU64::new(0)));
    let device = Telltale { reads: Arc::clone(&reads), calls: Arc::clone(&calls) };
    let mut session = session_with(device, 60.0);
    session.set_pre_roll(0.05).unwrap();
    session.start().unwrap();
    wait_until(|| reads.load(Ordering::Acquire) > 100);
    let before = calls.load(Ordering::Acquire);
    let path = std::env::temp_dir().join(format!("no-allocation-{}.touch", std::process::id()));
    session.start_recording(String::new(), Some(&path)).unwrap();
    wait_until(|| session.recording().unwrap().spooled > 200);
    let recorded = session.stop_recording().unwrap();
    let read = reads.load(Ordering::Acquire);
    wait_until(|| reads.load(Ordering::Acquire) > read + 2);
    assert_eq!(calls.load(Ordering::Acquire), before);
    session.stop();
    recorded.spool.unwrap().remove().unwrap();
}
