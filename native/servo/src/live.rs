//! The loop on the clock, on a thread of its own.

use std::io;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, OnceLock, mpsc};
use std::thread::{Builder, JoinHandle};

use crate::Fault;
use crate::clock::Clock;
use crate::deadlines::{after_tick, at_wake_up, moment_of};
use crate::engine::Engine;

/// The thread's name, as debuggers and task lists show it (Linux shows 15 letters).
const THREAD_NAME: &str = "haptic-servo";

/// An engine running on its thread.
pub(crate) struct Live {
    /// The process that has the thread: a fork leaves threads behind.
    process: u32,
    stop: Arc<AtomicBool>,
    thread: JoinHandle<Box<Engine>>,
}

impl Live {
    /// Sets the engine going. Where there is no thread to be had, the engine comes back.
    ///
    /// A fault that ends the loop is left in `fault` after the last zero force.
    pub(crate) fn start(
        engine: Box<Engine>,
        fault: Arc<OnceLock<Fault>>,
    ) -> Result<Live, (io::Error, Box<Engine>)> {
        let stop = Arc::new(AtomicBool::new(false));
        let stop_seen = Arc::clone(&stop);
        // The engine follows the thread, so that a thread that cannot be made does not lose it.
        let (hand_over, engine_to_come) = mpsc::sync_channel::<Box<Engine>>(1);
        let spawned = Builder::new().name(THREAD_NAME.to_owned()).spawn(move || {
            let engine = engine_to_come.recv().expect("the engine is sent once the thread exists");
            run_guarded(engine, &stop_seen, &fault)
        });
        match spawned {
            Ok(thread) => {
                hand_over.send(engine).expect("the thread waits for the engine");
                Ok(Live { process: std::process::id(), stop, thread })
            }
            Err(error) => Err((error, engine)),
        }
    }

    /// Whether the loop has not ended by itself.
    pub(crate) fn is_running(&self) -> bool {
        !self.thread.is_finished()
    }

    /// Ends the loop and takes the engine back. `None` where the thread broke down with it.
    pub(crate) fn stop(self) -> Option<Box<Engine>> {
        self.stop.store(true, Ordering::Release);
        if self.process != std::process::id() {
            // There is nothing to join in this process, and the device belongs to the other.
            std::mem::forget(self.thread);
            return None;
        }
        self.thread.join().ok()
    }
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

        engine.tick();

        let next = after_tick(due.deadline, clock.now());
        engine.miss(next.missed);
        deadline = next.deadline;
    }
}
