//! The servo with its ways in and out: what is run on the clock and stepped alike.

use std::mem::MaybeUninit;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;
use std::time::Instant;

use contact::ContactModel;
use devices::NOMINAL_PERIOD;
use rtrb::{Consumer, Producer};
use triple_buffer::Input;

use crate::command::Command;
use crate::memory::Piece;
use crate::{Fault, Histogram, Servo, State, TickRecord, Totals};

/// Ticks in a second; dividing by it gives the double nearest to the decimal time.
pub(crate) const TICKS_PER_SECOND: f64 = 1000.0;

/// How many commands may wait for the next tick.
pub(crate) const COMMANDS: usize = 256;

/// How many retired contact models may wait to be freed: all that one tick can retire.
pub(crate) const RETIRED: usize = COMMANDS;

/// What the outside sees of the newest tick.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Snapshot {
    pub(crate) state: State,
    pub(crate) totals: Totals,
    /// How many of the windows that were asked for have been laid.
    pub(crate) windows: u64,
}

/// The ends of the queues that belong to the loop.
pub(crate) struct Ports {
    pub(crate) commands: Consumer<Command>,
    /// Contact models out of use: freeing memory is not for a tick.
    pub(crate) retired: Producer<Box<dyn ContactModel>>,
    pub(crate) records: Producer<TickRecord>,
    pub(crate) snapshots: Input<Snapshot>,
    pub(crate) update_times: Arc<Histogram>,
    pub(crate) lateness: Arc<Histogram>,
    pub(crate) busy_times: Arc<Histogram>,
}

pub(crate) struct Engine {
    servo: Servo,
    ports: Ports,
    /// Periods since the session was made in which it ran, skipped ones included.
    periods: u64,
    /// Seconds on the session's clock at the last tick.
    time_at_tick: f64,
    missed: u64,
    dropped: u64,
    windows: u64,
}

impl Engine {
    pub(crate) fn new(servo: Servo, ports: Ports) -> Engine {
        Engine { servo, ports, periods: 0, time_at_tick: 0.0, missed: 0, dropped: 0, windows: 0 }
    }

    /// Seconds that the session has run, to the last deadline.
    pub(crate) fn time(&self) -> f64 {
        self.periods as f64 / TICKS_PER_SECOND
    }

    /// The tick of the next deadline, exactly at it.
    pub(crate) fn step(&mut self) {
        let time = (self.periods + 1) as f64 / TICKS_PER_SECOND;
        // The last tick was at a deadline too: whole periods lie between.
        let periods = ((time - self.time_at_tick) * TICKS_PER_SECOND).round();
        self.tick(time, periods * NOMINAL_PERIOD);
    }

    /// The tick of the next deadline, which began at `time` on the session's clock.
    pub(crate) fn tick_at(&mut self, time: f64) {
        self.tick(time, time - self.time_at_tick);
    }

    /// Does what was asked, then the next deadline's tick, and publishes it.
    fn tick(&mut self, time: f64, dt: f64) {
        self.apply_commands();
        self.periods += 1;
        self.time_at_tick = time;

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
        self.servo.miss(ticks);
    }

    /// A live tick begins that much after its deadline.
    pub(crate) fn note_lateness(&self, nanoseconds: u64) {
        self.ports.lateness.record(nanoseconds);
    }

    /// A live tick kept its thread busy that long.
    pub(crate) fn note_busy(&self, nanoseconds: u64) {
        self.ports.busy_times.record(nanoseconds);
    }

    /// What every tick needs, the smallest first.
    pub(crate) fn memory(&mut self) -> Vec<Piece> {
        let mut pieces = vec![Piece::of(self)];
        pieces.extend(self.servo.memory());
        for histogram in [&self.ports.update_times, &self.ports.lateness, &self.ports.busy_times] {
            pieces.push(Piece::of(&**histogram));
        }
        pieces.extend(ring_memory(&mut self.ports.records));
        pieces
    }

    /// The servo, for what is set while the engine stands.
    pub(crate) fn servo(&mut self) -> &mut Servo {
        &mut self.servo
    }

    /// Does what was asked, in order. While no model can be retired, commands wait.
    pub(crate) fn apply_commands(&mut self) {
        // Counted, so that no sender can keep a tick from beginning.
        for _ in 0..COMMANDS {
            if self.ports.retired.is_full() {
                return;
            }
            match self.ports.commands.pop() {
                Ok(command) => self.apply(command),
                Err(_) => return,
            }
        }
    }

    /// Does one thing. There must be room to retire a model.
    pub(crate) fn apply(&mut self, command: Command) {
        match command {
            Command::Window { frame, number } => {
                self.servo.set_frame(frame);
                self.windows = number;
            }
            Command::Press(is_down) => self.servo.press(is_down),
            Command::Mode(mode) => self.servo.set_mode(mode),
            Command::Twist(radians) => self.servo.set_twist(radians),
            Command::Target(target) => self.servo.set_target(target),
            Command::PassivityControl(controls) => self.servo.set_passivity_control(controls),
            Command::Model(model) => {
                let retired = self.servo.set_model(model);
                // Room was made before, so that nothing is freed here.
                let _ = self.ports.retired.push(retired);
            }
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
        self.time_at_tick = self.time();
        self.publish();
    }

    fn publish(&mut self) {
        let totals =
            Totals { missed_ticks: self.missed, dropped: self.dropped, ..self.servo.totals() };
        let state = State::new(self.servo.latest(), self.servo.model(), self.servo.held());
        self.ports.snapshots.write(Snapshot { state, totals, windows: self.windows });
    }

    pub(crate) fn fault(&self) -> Option<&Fault> {
        self.servo.fault()
    }
}

/// What is free of a ring, every page of it touched once.
fn ring_memory<T>(ring: &mut Producer<T>) -> [Piece; 2] {
    let free = ring.slots();
    let mut chunk = ring.write_chunk_uninit(free).expect("as many slots as there are");
    let (first, second) = chunk.as_mut_slices();
    [first, second].map(|part| {
        let piece = Piece::of(part);
        touch(part);
        piece
    })
}

/// A page that is written to is there from then on.
fn touch<T>(part: &mut [MaybeUninit<T>]) {
    const PAGE: usize = 4096;
    let stride = (PAGE / size_of::<T>().max(1)).max(1);
    for slot in part.iter_mut().step_by(stride) {
        // All zeros are as good as what was never written.
        std::hint::black_box(std::mem::replace(slot, MaybeUninit::zeroed()));
    }
}

/// A time that no u64 holds is longer than all that is counted anyway.
fn nanoseconds_since(begin: Instant) -> u64 {
    u64::try_from(begin.elapsed().as_nanos()).unwrap_or(u64::MAX)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Frame, Settings, Window};
    use contact::{Model, ProxyGraph};
    use devices::{Hand, SimulatedDevice};
    use rtrb::RingBuffer;
    use surface::{ByteOrder, Grid, GridLayout, SampleType};
    use triple_buffer::triple_buffer;

    fn servo() -> Servo {
        let layout =
            GridLayout::packed(2, 2, 1.0, 1.0, SampleType::F64, ByteOrder::Little).unwrap();
        let window = Window::new(0.0, 0.0, 0.0, 1.0, 1.0).unwrap();
        let frame = Frame::new(window, 0.16, &layout).unwrap();
        let grid = Arc::new(Grid::from_vec(vec![0; 32], layout).unwrap());
        let device = Box::new(SimulatedDevice::new(Hand::default()).unwrap());
        Servo::new(device, Box::new(ProxyGraph::new(1)), grid, frame, &Settings::default()).unwrap()
    }

    #[test]
    fn where_no_model_can_be_retired_commands_wait_in_their_order() {
        let servo = servo();
        let state = State::new(servo.latest(), servo.model(), None);
        let (mut commands, commands_taken) = RingBuffer::new(8);
        let (retired_given, mut retired) = RingBuffer::new(1);
        let ports = Ports {
            commands: commands_taken,
            retired: retired_given,
            records: RingBuffer::new(8).0,
            snapshots: triple_buffer(&Snapshot { state, totals: Totals::default(), windows: 0 }).0,
            update_times: Arc::new(Histogram::new()),
            lateness: Arc::new(Histogram::new()),
            busy_times: Arc::new(Histogram::new()),
        };
        let mut engine = Engine::new(servo, ports);
        for _ in 0..2 {
            let model = Model::default().build(1);
            assert!(commands.push(Command::Model(model)).is_ok());
        }
        assert!(commands.push(Command::Target([0.0; 3])).is_ok());
        engine.step();
        assert_eq!((commands.slots(), retired.slots()), (6, 1));
        engine.step();
        assert_eq!((commands.slots(), retired.slots()), (6, 1), "nothing is freed, nothing lost");
        assert!(retired.pop().is_ok());
        engine.step();
        assert_eq!((commands.slots(), retired.slots()), (7, 1), "the target waits behind it");
        assert!(retired.pop().is_ok());
        engine.step();
        assert_eq!((commands.slots(), retired.slots()), (8, 0));
    }
}
