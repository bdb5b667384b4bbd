//! What starting, stopping and forking leave behind. One test alone in its process: threads,
//! descriptors and memory are counted for all of it.

#![cfg(target_os = "linux")]

mod common;

use std::alloc::{GlobalAlloc, Layout, System};
use std::sync::atomic::{AtomicI64, Ordering};

use common::*;
use devices::{Hand, SimulatedDevice};
use servo::Session;

/// Bytes asked for and not given back.
static HELD: AtomicI64 = AtomicI64::new(0);

struct Counting;

// SAFETY: every call is passed on to the system's allocator as it came.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        HELD.fetch_add(layout.size() as i64, Ordering::Relaxed);
        // SAFETY: the caller keeps the contract of `alloc`.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, block: *mut u8, layout: Layout) {
        HELD.fetch_sub(layout.size() as i64, Ordering::Relaxed);
        // SAFETY: the caller keeps the contract of `dealloc`.
        unsafe { System.dealloc(block, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

fn entries(folder: &str) -> usize {
    std::fs::read_dir(folder).unwrap().count()
}

/// Threads, descriptors and bytes of this process.
fn held() -> (usize, usize, i64) {
    let (threads, descriptors) = (entries("/proc/self/task"), entries("/proc/self/fd"));
    (threads, descriptors, HELD.load(Ordering::Relaxed))
}

fn hand() -> Session {
    session(SimulatedDevice::new(Hand::default()).unwrap(), proxy_graph())
}

/// A thread that was joined may stay in the kernel's list for a moment.
fn wait_for(threads: usize) {
    wait_until(|| entries("/proc/self/task") <= threads);
}

fn a_thousand_starts_leave_nothing() {
    let threads = entries("/proc/self/task");
    let mut session = hand();
    let round = |session: &mut Session| {
        session.start().unwrap();
        session.stop();
    };
    round(&mut session);
    wait_for(threads);
    let before = held();
    for _ in 0..1000 {
        round(&mut session);
    }
    wait_for(threads);
    assert_eq!(held(), before);
    session.step(1).unwrap();
}

fn a_thousand_sessions_leave_nothing() {
    drop(hand());
    let before = held();
    for round in 0..1000 {
        let mut session = hand();
        match round % 3 {
            0 => session.start().unwrap(),
            1 => session.step(3).unwrap(),
            _ => {}
        }
    }
    wait_for(before.0);
    assert_eq!(held(), before);
}

fn a_fork_leaves_the_session_to_the_parent() {
    let log = Log::default();
    let mut session = session(Watched::pressing(&log), proxy_graph());
    session.start().unwrap();
    wait_until(|| log.pushes());
    // SAFETY: the child only drops the session and ends; glibc makes its allocator usable there.
    let child = unsafe { libc::fork() };
    if child == 0 {
        let is_right = std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| {
            assert!(!session.running());
            assert_eq!(session.fault(), Some(&servo::Fault::Forked));
            assert!(session.start().is_err() && session.step(1).is_err());
            session.stop();
            drop(session);
        }))
        .is_ok();
        // SAFETY: ends this process and runs none of the parent's handlers.
        unsafe { libc::_exit(i32::from(!is_right)) }
    }
    let mut status = -1;
    // SAFETY: `status` is a valid place to write to.
    let ended = unsafe { libc::waitpid(child, &mut status, 0) };
    assert_eq!((ended, status), (child, 0), "the child neither hangs nor breaks down");
    let before = log.reads();
    wait_until(|| log.reads() > before + 20);
    assert!(session.running());
    session.stop();
    assert_eq!(log.last_force(), [0.0; 3]);
}

#[test]
fn nothing_is_left_over() {
    a_thousand_starts_leave_nothing();
    a_thousand_sessions_leave_nothing();
    a_fork_leaves_the_session_to_the_parent();
}
