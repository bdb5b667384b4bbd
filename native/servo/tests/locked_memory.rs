//! What a live session keeps in memory. A program of its own, for locked memory is counted by process.

#![cfg(target_os = "linux")]

mod common;

use common::*;
use servo::LockedMemory;

#[test]
fn a_live_session_keeps_what_its_ticks_need_in_memory_and_lets_it_go() {
    let log = Log::default();
    let mut session = session(Watched::pressing(&log), proxy_graph());
    assert_eq!(session.locked_memory(), LockedMemory::default());
    let before = locked_kilobytes();
    session.start().unwrap();
    let memory = session.locked_memory();
    let during = locked_kilobytes();
    session.stop();
    // Systems that grant nothing say so; nothing else may differ.
    assert_eq!(during > before, memory.locked > 0, "{memory:?}");
    assert!(memory.locked + memory.refused > 64 * 1024, "stack, state and rings: {memory:?}");
    assert_eq!(locked_kilobytes(), before);
}

fn locked_kilobytes() -> u64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap();
    let line = status.lines().find(|line| line.starts_with("VmLck")).unwrap();
    line.split_whitespace().nth(1).unwrap().parse().unwrap()
}
