//! A session: one device touching one grid, live or stepped.

use std::io;
use std::path::Path;
use std::sync::{Arc, OnceLock};

use contact::ContactModel;
use devices::{Device, ParameterError, check};
use rtrb::{Consumer, Producer, RingBuffer};
use surface::Grid;
use takes::{Header, Take, WriteError};
use triple_buffer::{Output, triple_buffer};

use crate::collector::Collector;
use crate::command::Command;
use crate::engine::{COMMANDS, Engine, Ports, RETIRED, Snapshot, TICKS_PER_SECOND};
use crate::helper::Helper;
use crate::live::{Granted, Live};
use crate::safety::Heartbeat;
use crate::{
    Fault, Frame, Held, Histogram, Interaction, Limits, LockedMemory, Mode, Priority, Recorded,
    Recording, Servo, State, Statistics, TickRecord, Totals, Warning, Window,
};

/// The longest ring, and the longest pre-roll: an hour of ticks takes about a gigabyte.
const LONGEST_SECONDS: f64 = 3600.0;

/// The numbers of a session.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// Of the spring from hand to proxy, N/m; cut to what the device can show.
    pub stiffness: f64,
    /// The largest force, N; the device's own limit holds too.
    pub max_force: f64,
    /// Seconds of ticks kept for [`Session::drain`], up to an hour.
    pub ring_seconds: f64,
    /// The fastest change of the force, N/s. The device's own limit holds too, and at any rate the
    /// force takes 5 ms from nothing to the largest one.
    pub max_slew: f64,
    /// The fastest hand, m/s, beyond which the handle counts as slipped; the device's own limit
    /// holds too.
    pub max_speed: f64,
    /// Seconds without a [`Session::heartbeat`] (or a look at its state) after which a live session
    /// gives no force; `None` where nobody needs to look. [`STALE_AFTER`](crate::STALE_AFTER) for
    /// hosts that draw.
    pub stale_after: Option<f64>,
    /// Whether a live session asks the system for real-time priority. A refusal is no error: see
    /// [`Session::priority`].
    pub real_time: bool,
    /// Whether four walls keep the hand in the device's workspace (paper, section 4.2). On for
    /// whoever holds a device; off at first, for a script's hand goes where the script wants.
    pub walls: bool,
    /// Whether the stylus button changes the mode, and how pan and zoom feel; `None` where buttons
    /// change nothing. On for whoever holds a device.
    pub interaction: Option<Interaction>,
}

impl Default for Settings {
    /// Stable on every device known so far, and gentle.
    fn default() -> Self {
        Settings {
            stiffness: 500.0,
            max_force: 8.0,
            ring_seconds: 60.0,
            max_slew: f64::INFINITY,
            max_speed: f64::INFINITY,
            stale_after: None,
            real_time: true,
            walls: false,
            interaction: None,
        }
    }
}

impl Settings {
    /// Checks them before a device is given away for them.
    pub fn validate(&self) -> Result<(), ParameterError> {
        check::finite("stiffness", self.stiffness)?;
        check::limit("stiffness", self.stiffness)?;
        check::finite("max_force", self.max_force)?;
        check::limit("max_force", self.max_force)?;
        check::limit("max_slew", self.max_slew)?;
        check::positive_or_infinite("max_speed", self.max_speed)?;
        if let Some(seconds) = self.stale_after {
            check::positive("stale_after", seconds)?;
        }
        if let Some(interaction) = &self.interaction {
            interaction.validate()?;
        }
        ring_capacity(self.ring_seconds).map(|_| ())
    }
}

/// A session was used in a state that does not allow the call.
#[derive(Debug, thiserror::Error)]
pub enum SessionError {
    /// Started twice.
    #[error("the session already runs")]
    AlreadyRunning,
    /// Stepped on the clock.
    #[error("the session runs live: stop it before stepping")]
    Live,
    /// Touch ended by itself, and such a session is not started again.
    #[error(transparent)]
    Faulted(#[from] Fault),
    /// A mode was asked for where there are none.
    #[error("the session was made without modes of interaction")]
    WithoutModes,
    /// The system gave no thread.
    #[error("the servo's thread could not be made: {0}")]
    Thread(#[source] io::Error),
    /// The loop has not taken up what was asked before.
    #[error(
        "{COMMANDS} commands wait for the servo already: it stalls, or too much is asked of it"
    )]
    CommandsFull,
    /// One take at a time.
    #[error("a take is being recorded already")]
    AlreadyRecording,
    /// A take was asked for where there is none.
    #[error("no take is being recorded")]
    NotRecording,
    /// The file for a take cannot be made.
    #[error(transparent)]
    Spool(#[from] WriteError),
    /// A target that is nowhere, or a window that cannot be laid over this grid.
    #[error(transparent)]
    Parameter(#[from] ParameterError),
}

/// Where the engine is.
enum Place {
    Here(Box<Engine>),
    Live(Live),
    /// Its thread broke down with it; the fault says so.
    Lost,
}

/// A grid, a device and a contact model in one loop: 1 kHz live, or stepped.
///
/// Dropping it stops the thread after a last zero force.
pub struct Session {
    place: Place,
    grid: Arc<Grid>,
    /// What was asked for last.
    window: Window,
    /// How many windows were asked for.
    windows: u64,
    has_modes: bool,
    /// The name of the contact model that was chosen last.
    model: &'static str,
    /// Metres.
    workspace: [f64; 3],
    limits: Limits,
    /// Seconds.
    stale_after: Option<f64>,
    heartbeat: Arc<Heartbeat>,
    commands: Producer<Command>,
    retired: Consumer<Box<dyn ContactModel>>,
    collector: Arc<Collector>,
    /// While a live session records, or keeps a pre-roll.
    helper: Option<Helper>,
    snapshots: Output<Snapshot>,
    update_times: Arc<Histogram>,
    lateness: Arc<Histogram>,
    busy_times: Arc<Histogram>,
    real_time: bool,
    /// To the thread that ran last.
    granted: Granted,
    fault: Arc<OnceLock<Fault>>,
}

impl Session {
    /// Joins them; nothing moves before [`start`](Self::start) or [`step`](Self::step).
    pub fn new(
        grid: Arc<Grid>,
        device: Box<dyn Device>,
        model: Box<dyn ContactModel>,
        window: Window,
        settings: Settings,
    ) -> Result<Session, ParameterError> {
        settings.validate()?;
        let capacity = ring_capacity(settings.ring_seconds)?;
        let capabilities = device.capabilities();
        capabilities.validate()?;
        let frame = Frame::new(window, capabilities.workspace[0], grid.layout())?;
        let name = model.name();
        let servo = Servo::new(device, model, Arc::clone(&grid), frame, &settings)?;

        let limits = *servo.limits();
        let before_the_first_tick = Snapshot {
            state: State::new(servo.latest(), name, None),
            totals: Totals::default(),
            windows: 0,
        };
        let (commands, commands_taken) = RingBuffer::new(COMMANDS);
        let (retired_given, retired) = RingBuffer::new(RETIRED);
        let (records_given, records) = RingBuffer::new(capacity);
        let (snapshots_given, snapshots) = triple_buffer(&before_the_first_tick);
        let update_times = Arc::new(Histogram::new());
        let lateness = Arc::new(Histogram::new());
        let busy_times = Arc::new(Histogram::new());
        let ports = Ports {
            commands: commands_taken,
            retired: retired_given,
            records: records_given,
            snapshots: snapshots_given,
            update_times: Arc::clone(&update_times),
            lateness: Arc::clone(&lateness),
            busy_times: Arc::clone(&busy_times),
        };
        Ok(Session {
            place: Place::Here(Box::new(Engine::new(servo, ports))),
            grid,
            window,
            windows: 0,
            has_modes: settings.interaction.is_some(),
            model: name,
            workspace: capabilities.workspace,
            limits,
            stale_after: settings.stale_after,
            heartbeat: Arc::default(),
            commands,
            retired,
            collector: Arc::new(Collector::new(records, capacity)),
            helper: None,
            snapshots,
            update_times,
            lateness,
            busy_times,
            real_time: settings.real_time,
            granted: Granted::default(),
            fault: Arc::new(OnceLock::new()),
        })
    }

    /// Runs at 1 kHz on a thread of its own. The proxy begins at the hand.
    pub fn start(&mut self) -> Result<(), SessionError> {
        self.refuse_after_fault()?;
        self.help(self.collector.is_busy())?;
        match std::mem::replace(&mut self.place, Place::Lost) {
            Place::Here(mut engine) => {
                engine.servo().watch_host(self.watched_heartbeat());
                match Live::start(engine, self.real_time, Arc::clone(&self.fault)) {
                    Ok(live) => {
                        self.granted = live.granted().clone();
                        self.place = Place::Live(live);
                        Ok(())
                    }
                    Err((error, mut engine)) => {
                        engine.servo().watch_host(None);
                        self.place = Place::Here(engine);
                        self.helper = None;
                        Err(SessionError::Thread(error))
                    }
                }
            }
            elsewhere => {
                self.place = elsewhere;
                Err(SessionError::AlreadyRunning)
            }
        }
    }

    /// Sends zero force and joins the thread; harmless when it does not run.
    pub fn stop(&mut self) {
        match std::mem::replace(&mut self.place, Place::Lost) {
            Place::Live(live) => match live.stop() {
                Some(mut engine) => {
                    // What a full ring kept waiting is done before what is asked from now on.
                    self.free_retired();
                    engine.guard(Engine::apply_commands);
                    if let Some(fault) = engine.fault() {
                        self.fault.get_or_init(|| fault.clone());
                    }
                    // Steps are done at the host's own pace, so there is no host to wait for.
                    engine.servo().watch_host(None);
                    self.place = Place::Here(engine);
                }
                None => {
                    let words = "the servo's thread broke down".to_owned();
                    self.fault.get_or_init(|| Fault::Panic(words));
                }
            },
            elsewhere => self.place = elsewhere,
        }
        let is_helped = self.helper.as_ref().is_some_and(Helper::is_here);
        self.helper = None;
        if is_helped {
            // What it had not got yet.
            self.collector.collect();
            self.collector.spool_all();
        }
    }

    /// Does `count` ticks of 1 ms here and now, deterministically; fewer where a fault ends touch.
    pub fn step(&mut self, count: u64) -> Result<(), SessionError> {
        self.refuse_after_fault()?;
        let Place::Here(engine) = &mut self.place else {
            return Err(SessionError::Live);
        };
        if self.collector.is_busy() {
            // The ring never overflows between two looks at it.
            let most = self.collector.ring_capacity() as u64;
            let mut left = count;
            while left > 0 && engine.fault().is_none() {
                step(engine, left.min(most));
                left -= left.min(most);
                self.collector.collect();
                self.collector.spool_steps();
            }
        } else {
            step(engine, count);
        }
        if let Some(fault) = engine.fault() {
            self.fault.get_or_init(|| fault.clone());
        }
        self.refuse_after_fault()
    }

    /// How the system schedules the thread that runs live, or ran last.
    pub fn priority(&self) -> &Priority {
        &self.granted.priority
    }

    /// What the system keeps, or last kept, in memory for that thread: what was there when it was
    /// started.
    pub fn locked_memory(&self) -> LockedMemory {
        self.granted.memory
    }

    /// Whether it runs live; false as soon as a fault has ended touch.
    pub fn running(&self) -> bool {
        match &self.place {
            Place::Live(live) => self.fault.get().is_none() && live.is_running(),
            Place::Here(_) | Place::Lost => false,
        }
    }

    /// Why touch ended by itself, if it did. The device has had its zero force by then.
    pub fn fault(&self) -> Option<&Fault> {
        self.notice_fork();
        self.fault.get()
    }

    /// Where the workspace lies: where pan and zoom have moved it, or where it was last asked to be
    /// and will be from the next tick on.
    pub fn window(&mut self) -> Window {
        let newest = self.snapshots.read();
        if newest.windows == self.windows { newest.state.window } else { self.window }
    }

    /// Lays the workspace elsewhere, from the next tick on. The proxy then begins anew at the hand,
    /// in normal mode, over a surface at rest.
    pub fn set_window(&mut self, window: Window) -> Result<(), SessionError> {
        let frame = Frame::new(window, self.workspace[0], self.grid.layout())?;
        self.command(Command::Window { frame, number: self.windows + 1 })?;
        self.windows += 1;
        self.window = window;
        Ok(())
    }

    /// Presses the stylus button, as a key does for every device, from the next tick on.
    pub fn press(&mut self) -> Result<(), SessionError> {
        self.mode_command(Command::Press(true))
    }

    /// Releases the stylus button that [`press`](Self::press) pressed.
    pub fn release(&mut self) -> Result<(), SessionError> {
        self.mode_command(Command::Press(false))
    }

    /// Changes the mode from the next tick on, whatever the button says, until normal mode is asked
    /// for or touch begins anew. Pan in the air holds the point at the hand.
    pub fn set_mode(&mut self, mode: Mode) -> Result<(), SessionError> {
        self.mode_command(Command::Mode(mode))
    }

    /// Turns a simulated handle about the vertical, radians counter-clockwise seen from above, from
    /// the next tick on.
    pub fn set_twist(&mut self, radians: f64) -> Result<(), SessionError> {
        check::finite("twist", radians)?;
        self.command(Command::Twist(radians))
    }

    fn mode_command(&mut self, command: Command) -> Result<(), SessionError> {
        if !self.has_modes {
            return Err(SessionError::WithoutModes);
        }
        self.command(command)
    }

    /// Lets `model` answer from the next tick on, also in mid-touch: it goes on from where the
    /// proxy is, and the force changes no faster than its slew limit.
    pub fn set_model(&mut self, model: Box<dyn ContactModel>) -> Result<(), SessionError> {
        let name = model.name();
        self.command(Command::Model(model))?;
        self.model = name;
        Ok(())
    }

    /// The name of the contact model that was chosen last.
    pub fn model(&self) -> &'static str {
        self.model
    }

    /// Where a simulated hand shall go (workspace metres), from the next tick on.
    pub fn set_target(&mut self, target: [f64; 3]) -> Result<(), SessionError> {
        check::finite("target x", target[0])?;
        check::finite("target y", target[1])?;
        check::finite("target z", target[2])?;
        self.command(Command::Target(target))
    }

    /// Whether damping is added, from the next tick on, when the passivity observer finds that the
    /// spring gives more energy than it took. Off at first.
    pub fn set_passivity_control(&mut self, controls: bool) -> Result<(), SessionError> {
        self.command(Command::PassivityControl(controls))
    }

    /// The newest tick. Also looks whether the grid's file has been cut, which the servo cannot.
    pub fn state(&mut self) -> State {
        self.free_retired();
        self.heartbeat.beat();
        self.grid.look_at_file();
        let mut state = self.snapshots.read().state;
        if state.held.is_none() && self.is_below_ground(&state) {
            state.held = Some(Held::Below);
        }
        state
    }

    /// Counts and times since the session was made.
    pub fn statistics(&mut self) -> Statistics {
        Statistics {
            totals: self.snapshots.read().totals,
            update_times: self.update_times.distribution(),
            lateness: self.lateness.distribution(),
            busy_times: self.busy_times.distribution(),
        }
    }

    /// Every tick since the last drain that found room in the ring, oldest first. While a take is
    /// recorded, or a pre-roll kept, there is always room: then the newest ones, as many as the ring
    /// takes.
    pub fn drain(&mut self) -> Vec<TickRecord> {
        self.collector.drain()
    }

    /// From now on that many seconds of ticks are kept, up to an hour, for a take to begin with; 0
    /// ends that. Half an hour of them takes half a gigabyte.
    pub fn set_pre_roll(&mut self, seconds: f64) -> Result<(), SessionError> {
        if !(0.0..=LONGEST_SECONDS).contains(&seconds) {
            let expected = "from 0 to 3600 seconds";
            let name = "pre_roll";
            return Err(ParameterError { name, value: seconds, expected }.into());
        }
        self.collector.set_pre_roll((seconds * TICKS_PER_SECOND).ceil() as usize);
        self.help_if_live()
    }

    /// Keeps every tick from the next one on, and those of the pre-roll, in memory and, where `spool`
    /// is given, in a new file there (see [`takes`]). `about` is a text for the take, as JSON.
    pub fn start_recording(
        &mut self,
        about: String,
        spool: Option<&Path>,
    ) -> Result<(), SessionError> {
        let done = self.snapshots.read().state.tick;
        let header = Header { about, workspace: self.workspace, pre_roll: 0 };
        if !self.collector.begin(header, spool, done)? {
            return Err(SessionError::AlreadyRecording);
        }
        // Without its helper a live take would not be what was asked for.
        self.help_if_live().inspect_err(|_| {
            let recorded = self.collector.end(done);
            recorded.and_then(|recorded| recorded.spool).map(takes::Spool::remove);
        })
    }

    /// How far the take has come; `None` where none is recorded.
    pub fn recording(&self) -> Option<Recording> {
        self.collector.recording()
    }

    /// The take as far as it has come.
    pub fn recorded(&self) -> Result<Take, SessionError> {
        self.collector.so_far().ok_or(SessionError::NotRecording)
    }

    /// Ends the take, also after a fault, and marks its file as whole.
    pub fn stop_recording(&mut self) -> Result<Recorded, SessionError> {
        // The last tick of the take is one that was done by now; what the ring lost before is told.
        let done = self.snapshots.read().state.tick;
        let recorded = self.collector.end(done).ok_or(SessionError::NotRecording)?;
        // Only ends the helper, which cannot fail.
        self.help_if_live()?;
        Ok(recorded)
    }

    fn help_if_live(&mut self) -> Result<(), SessionError> {
        let is_live = matches!(self.place, Place::Live(_));
        self.help(is_live && self.collector.is_busy())
    }

    /// Has the helper there, or not.
    fn help(&mut self, is_wanted: bool) -> Result<(), SessionError> {
        if !is_wanted {
            self.helper = None;
        } else if self.helper.is_none() {
            let helper = Helper::start(Arc::clone(&self.collector));
            self.helper = Some(helper.map_err(SessionError::Thread)?);
        }
        Ok(())
    }

    /// What holds, after the device's limits.
    pub fn limits(&self) -> &Limits {
        &self.limits
    }

    /// What the safety chain did so far, in words for the person, the gravest first.
    pub fn warnings(&mut self) -> Vec<Warning> {
        let Snapshot { state, mut totals, .. } = *self.snapshots.read();
        if !self.collector.is_drained() {
            // Nobody wanted them but a recording, which counts what it lost.
            totals.dropped = 0;
        }
        let below = self.is_below_ground(&state).then_some(Warning::Below);
        let of_recording = self.recording().into_iter().flat_map(Warning::of_recording);
        let others = Warning::all(&self.limits, &totals);
        below.into_iter().chain(of_recording).chain(others).collect()
    }

    /// Whoever needs to look at a live session is still there: see [`Settings::stale_after`].
    pub fn heartbeat(&self) {
        self.heartbeat.beat();
    }

    fn watched_heartbeat(&self) -> Option<(Arc<Heartbeat>, f64)> {
        self.stale_after.map(|seconds| (Arc::clone(&self.heartbeat), seconds))
    }

    /// A child has no servo: what it inherits of a live session is a session that has ended.
    fn notice_fork(&self) {
        if let Place::Live(live) = &self.place
            && live.is_elsewhere()
        {
            self.fault.get_or_init(|| Fault::Forked);
        }
    }

    /// Whether the hand is where the ground should hold it, and does not: a proxy that begins under
    /// the ground is free until it has been above.
    fn is_below_ground(&self, state: &State) -> bool {
        let goal = self.grid.layout().grid_point(state.goal);
        let ground = goal.is_finite().then(|| self.grid.surface_elevation(&goal)).flatten();
        let seeks_touch = state.tick > 0 && state.mode == Mode::Normal && !state.in_contact();
        seeks_touch && ground.is_some_and(|ground| state.goal[2] < ground)
    }

    fn refuse_after_fault(&self) -> Result<(), SessionError> {
        self.notice_fork();
        match self.fault.get() {
            Some(fault) => Err(SessionError::Faulted(fault.clone())),
            None => Ok(()),
        }
    }

    /// Frees the contact models that the loop has put away.
    fn free_retired(&mut self) {
        while self.retired.pop().is_ok() {}
    }

    fn command(&mut self, command: Command) -> Result<(), SessionError> {
        self.free_retired();
        match &mut self.place {
            // Nothing empties the queue between steps, so it is not used.
            Place::Here(engine) => {
                engine.apply(command);
                Ok(())
            }
            // A thread that ended by itself takes nothing any more, and that is no mistake of
            // whoever moves the window meanwhile.
            Place::Live(live) => match self.commands.push(command) {
                Err(_) if live.is_running() && self.fault.get().is_none() => {
                    Err(SessionError::CommandsFull)
                }
                _ => Ok(()),
            },
            Place::Lost => Ok(()),
        }
    }
}

/// For tests that make devices and hosts fail in steps. None of it does anything to a live session.
#[cfg(feature = "test-hooks")]
impl Session {
    /// Takes a stage out of the safety chain.
    pub fn switch_off(&mut self, stage: crate::Stage) {
        if let Place::Here(engine) = &mut self.place {
            engine.servo().switch_off(stage);
        }
    }

    /// Lets deadlines pass without a tick, as a device or a machine that stalls does.
    pub fn stall(&mut self, ticks: u64) {
        if let Place::Here(engine) = &mut self.place {
            engine.miss(ticks);
        }
    }

    /// Has steps watch for the host's heartbeat as a live session does.
    pub fn watch_host_in_steps(&mut self) {
        let heartbeat = self.watched_heartbeat();
        if let Place::Here(engine) = &mut self.place {
            engine.servo().watch_host(heartbeat);
        }
    }
}

impl Drop for Session {
    fn drop(&mut self) {
        self.stop();
    }
}

/// Fewer where a fault ends touch.
fn step(engine: &mut Engine, count: u64) {
    engine.guard(|engine| {
        for _ in 0..count {
            engine.step();
            if engine.fault().is_some() {
                return;
            }
        }
    });
}

/// Ticks in that many seconds, at least one.
fn ring_capacity(seconds: f64) -> Result<usize, ParameterError> {
    if !(seconds > 0.0 && seconds <= LONGEST_SECONDS) {
        let expected = "above zero and at most 3600 seconds";
        return Err(ParameterError { name: "ring_seconds", value: seconds, expected });
    }
    Ok((seconds * TICKS_PER_SECOND).ceil() as usize)
}
