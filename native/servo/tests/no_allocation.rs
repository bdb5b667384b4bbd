//! A tick allocates nothing: the allocator could lock, wait for another thread, or ask the system.

mod common;

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;

use common::*;
use contact::Feature;
use devices::{Device, Hand, PathPoint, ScriptedDevice, SimulatedDevice};
use servo::{Session, Settings, Window};

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
