//! The servo with its ways in and out: what is run on the clock and stepped alike.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;
use std::time::Instant;

use devices::NOMINAL_PERIOD;
use rtrb::{Consumer, Producer};
use triple_buffer::Input;

use crate::command::Command;
use crate::{Fault, Histogram, Servo, State, TickRecord, Totals};

/// Ticks in a second; dividing by it gives the double nearest to the decimal time.
pub(crate) const TICKS_PER_SECOND: f64 = 1000.0;

/// How many commands may wait for the next tick.
pub(crate) const COMMANDS: usize = 256;

/// What the outside sees of the newest tick.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Snapshot {
    pub(crate) state: State,
    pub(crate) totals: Totals,
}

/// The ends of the queues that belong to the loop.
pub(crate) struct Ports {
    pub(crate) commands: Consumer<Command>,
    pub(crate) records: Producer<TickRecord>,
    pub(crate) snapshots: Input<Snapshot>,
    pub(crate) update_times: Arc<Histogram>,
    pub(crate) lateness: Arc<Histogram>,
}

pub(crate) struct Engine {
    servo: Servo,
    ports: Ports,
    /// Periods since the session was made in which it ran, skipped ones included.
    periods: u64,
    /// `periods` at the last tick.
    periods_at_tick: u64,
    missed: u64,
    dropped: u64,
}

impl Engine {
    pub(crate) fn new(servo: Servo, ports: Ports) -> Engine {
        Engine { servo, ports, periods: 0, periods_at_tick: 0, missed: 0, dropped: 0 }
    }

    /// Does what was asked, then one tick, and publishes it.
    pub(crate) fn tick(&mut self) {
        self.apply_commands();
        self.periods += 1;
        let time = self.periods as f64 / TICKS_PER_SECOND;
        let dt = (self.periods - self.periods_at_tick) as f64 * NOMINAL_PERIOD;
        self.periods_at_tick = self.periods;

        let begin = Instant::now();
        let record = self.servo.tick(time, dt);
        self.ports.update_times.record(nanoseconds_since(begin));

        if self.ports.records.push(record).is_err() {
            self.dropped += 1;
        }
        self.publish();
    }

    /// Deadlines passed without a tick.
    pub(crate) fn miss(&mut self, ticks: u64) {
        self.periods += ticks;
        self.missed += ticks;
    }

    /// A live tick begins that much after its deadline.
    pub(crate) fn note_lateness(&self, nanoseconds: u64) {
        self.ports.lateness.record(nanoseconds);
    }

    pub(crate) fn apply_commands(&mut self) {
        // Counted, so that no sender can keep a tick from beginning.
        for _ in 0..COMMANDS {
            match self.ports.commands.pop() {
                Ok(command) => self.apply(command),
                Err(_) => return,
            }
        }
    }

    pub(crate) fn apply(&mut self, command: Command) {
        match command {
            Command::SetWindow(frame) => self.servo.set_frame(frame),
            Command::SetTarget(target) => self.servo.set_target(target),
        }
    }

    /// Runs `ticks` so that neither a fault nor a panic leaves a force behind.
    pub(crate) fn guard(&mut self, ticks: impl FnOnce(&mut Engine)) {
        // After a panic the engine ticks no more, so it does not matter what state it was left in.
        if let Err(payload) = catch_unwind(AssertUnwindSafe(|| ticks(self))) {
            let fault = Fault::from_panic(payload.as_ref());
            // The device itself may be what panics.
            let _ = catch_unwind(AssertUnwindSafe(|| self.servo.fail(fault)));
        }
    }

    /// Sends zero force. The next tick places the proxy at the hand, which may have moved meanwhile.
    pub(crate) fn release(&mut self) {
        self.guard(|engine| {
            engine.servo.release();
            engine.apply_commands();
        });
        self.periods_at_tick = self.periods;
        self.publish();
    }

    fn publish(&mut self) {
        let totals =
            Totals { missed_ticks: self.missed, dropped: self.dropped, ..*self.servo.totals() };
        let state = State::from(self.servo.latest());
        self.ports.snapshots.write(Snapshot { state, totals });
    }

    pub(crate) fn fault(&self) -> Option<&Fault> {
        self.servo.fault()
    }
}

/// A time that no u64 holds is longer than all that is counted anyway.
fn nanoseconds_since(begin: Instant) -> u64 {
    u64::try_from(begin.elapsed().as_nanos()).unwrap_or(u64::MAX)
}
