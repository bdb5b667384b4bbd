//! The loop on the clock, on a thread of its own.

use std::io;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, OnceLock, mpsc};
use std::thread::{Builder, JoinHandle};

use crate::Fault;
use crate::clock::Clock;
use crate::deadlines::{after_tick, at_wake_up, moment_of};
use crate::engine::Engine;
use crate::memory::{LockedMemory, MemoryLock, stack_below};
use crate::priority::{Priority, Promotion};

/// In a second.
const NANOSECONDS: f64 = 1e9;

/// The thread's name, as debuggers and task lists show it (Linux shows 15 letters).
const THREAD_NAME: &str = "haptic-servo";

/// What the system granted to the thread.
#[derive(Clone, Debug, Default)]
pub(crate) struct Granted {
    pub(crate) priority: Priority,
    pub(crate) memory: LockedMemory,
}

/// An engine running on its thread.
pub(crate) struct Live {
    /// The process that has the thread: a fork leaves threads behind.
    process: u32,
    stop: Arc<AtomicBool>,
    thread: JoinHandle<Box<Engine>>,
    granted: Granted,
}

impl Live {
    /// Sets the engine going, with real-time priority if that is wished and granted. Where there is
    /// no thread to be had, the engine comes back.
    ///
    /// A fault that ends the loop is left in `fault` after the last zero force.
    pub(crate) fn start(
        engine: Box<Engine>,
        wants_real_time: bool,
        fault: Arc<OnceLock<Fault>>,
    ) -> Result<Live, (io::Error, Box<Engine>)> {
        let stop = Arc::new(AtomicBool::new(false));
        let stop_seen = Arc::clone(&stop);
        // The engine follows the thread, so that a thread that cannot be made does not lose it.
        let (hand_over, engine_to_come) = mpsc::sync_channel::<Box<Engine>>(1);
        let (granted_given, granted) = mpsc::sync_channel(1);
        let spawned = Builder::new().name(THREAD_NAME.to_owned()).spawn(move || {
            let engine = engine_to_come.recv().expect("the engine is sent once the thread exists");
            run_prepared(engine, wants_real_time, &granted_given, &stop_seen, &fault)
        });
        match spawned {
            Ok(thread) => {
                hand_over.send(engine).expect("the thread waits for the engine");
                // A thread that breaks down before has nothing granted.
                let granted = granted.recv().unwrap_or_default();
                Ok(Live { process: std::process::id(), stop, thread, granted })
            }
            Err(error) => Err((error, engine)),
        }
    }

    /// What the system granted to the thread.
    pub(crate) fn granted(&self) -> &Granted {
        &self.granted
    }

    /// Whether the loop has not ended by itself, and is this process's.
    pub(crate) fn is_running(&self) -> bool {
        !self.is_elsewhere() && !self.thread.is_finished()
    }

    /// Whether the thread is another process's: this one is its child.
    pub(crate) fn is_elsewhere(&self) -> bool {
        self.process != std::process::id()
    }

    /// Ends the loop and takes the engine back. `None` where the thread broke down with it.
    pub(crate) fn stop(self) -> Option<Box<Engine>> {
        self.stop.store(true, Ordering::Release);
        if self.is_elsewhere() {
            // There is nothing to join in this process, and the device belongs to the other.
            std::mem::forget(self.thread);
            return None;
        }
        self.thread.join().ok()
    }
}

/// Readies the thread, says what was granted, and runs the loop until its end.
fn run_prepared(
    mut engine: Box<Engine>,
    wants_real_time: bool,
    granted: &mpsc::SyncSender<Granted>,
    stop: &AtomicBool,
    fault: &OnceLock<Fault>,
) -> Box<Engine> {
    // What goes wrong here is a fault too, with which the loop ends before its first tick.
    let mut readied = None;
    engine.guard(|engine| readied = Some(ready(engine, wants_real_time)));
    let given = readied.as_ref().map_or_else(Granted::default, |(_, _, given)| given.clone());
    // Whoever starts the thread may have gone; the loop then sees that it shall stop.
    let _ = granted.send(given);
    let engine = run_guarded(engine, stop, fault);
    drop(readied);
    engine
}

/// Locks memory, and asks for priority last: from then on nothing of the thread may take long.
fn ready(engine: &mut Engine, wants_real_time: bool) -> (MemoryLock, Promotion, Granted) {
    let lock = MemoryLock::of([stack_below()].into_iter().chain(engine.memory()));
    let (promotion, priority) = if wants_real_time { Promotion::ask() } else { Promotion::none() };
    let granted = Granted { priority, memory: lock.memory() };
    (lock, promotion, granted)
}

/// Whatever happens in the loop, zero force is what the device gets last.
fn run_guarded(mut engine: Box<Engine>, stop: &AtomicBool, fault: &OnceLock<Fault>) -> Box<Engine> {
    engine.release();
    engine.guard(|engine| run(engine, stop));
    engine.release();
    if let Some(reason) = engine.fault() {
        fault.get_or_init(|| reason.clone());
    }
    engine
}

fn run(engine: &mut Engine, stop: &AtomicBool) {
    let clock = Clock::start();
    let began = engine.time();
    let mut deadline = 1;
    while engine.fault().is_none() {
        clock.sleep_until(moment_of(deadline));
        if stop.load(Ordering::Acquire) {
            return;
        }
        let now = clock.now();
        engine.note_lateness(now.saturating_sub(moment_of(deadline)));
        let due = at_wake_up(deadline, now);
        engine.miss(due.missed);

        engine.tick_at(began + now as f64 / NANOSECONDS);

        let end = clock.now();
        engine.note_busy(end.saturating_sub(now));
        let next = after_tick(due.deadline, end);
        engine.miss(next.missed);
        deadline = next.deadline;
    }
}
