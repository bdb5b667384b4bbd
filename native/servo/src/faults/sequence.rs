//! One random sequence: a hand goes in and out of the ground, and things go wrong.

use contact::{ContactModel, Model};
use devices::{Capabilities, DeviceError, NOMINAL_PERIOD};

use super::ground::Ground;
use super::judge::{HOST_TICKS, Judge, Known, LATE_TICKS, Promised};
use super::kind::Kind;
use super::puppet::{Order, Puppet, Strings};
use super::random::Random;
use super::witness::{Shared, Witness};
use crate::{Interaction, STALE_AFTER, Session, SessionError, Settings, Stage, Trips};

/// What became of a fault, or (without a kind) of the ticks without one.
pub(super) struct Outcome {
    pub(super) kind: Option<Kind>,
    pub(super) broken: Vec<String>,
    /// N.
    pub(super) force_after_fault: f64,
}

/// Ticks after a fault within which the hand goes out of the ground and in again, and the slowest
/// ramp has ended.
const RECOVERY: u64 = 2500;

/// Ticks between two calls of the host, as 60 times a second.
const HOST_EVERY: u64 = 16;

/// Ticks of punctual or slow life for which a fault is known to hold the force down.
const LATE_CALM: u64 = 9;
const SPEED_CALM: u64 = 49;

/// Plays one to three faults in a session, and a last one that ends touch or the drop of the session.
pub(super) fn play(random: &mut Random, off: Option<Stage>) -> Vec<Outcome> {
    let mut outcomes = Vec::new();
    let last = random.one_of(&Kind::ALL);
    let mut stage = Play::new(random, off, last == Kind::FileCut);
    stage.go(random.whole(80, 1500), &mut Known::default);
    outcomes.push(stage.outcome(None));
    for _ in 0..random.whole(0, 3) {
        if random.coin() {
            stage.change_something(random);
            outcomes.push(stage.outcome(None));
        }
        let kind = random.one_of(&Kind::ALL);
        if kind.ends_touch_with().is_none() {
            outcomes.push(stage.inject(random, kind));
        }
    }
    // How the session ends, and whether the next one starts, belongs to what happened to it last.
    let mut end = stage.inject(random, last);
    end.broken.append(&mut stage.drop_session());
    if last.ends_touch_with().is_some() {
        end.broken.append(&mut next_start(random, off));
    }
    outcomes.push(end);
    outcomes
}

/// After a fault that ended touch, another session is as good as the first.
fn next_start(random: &mut Random, off: Option<Stage>) -> Vec<String> {
    let mut play = Play::new(random, off, false);
    play.go(RECOVERY, &mut Known::default);
    let largest = play.judge.largest;
    play.judge.demand(largest > 0.0, || "the next start feels nothing".to_owned());
    play.judge.broken
}

/// A hand that swings through the ground, slower than 1 m/s.
struct Swing {
    /// Radians a second.
    rates: [f64; 3],
    phase: f64,
}

impl Swing {
    /// Workspace metres.
    fn position(&self, time: f64) -> [f64; 3] {
        let [x, y, z] = self.rates.map(|rate| (rate * time + self.phase).sin());
        [0.04 * x, 0.03 * y, 0.012 * z - 0.002]
    }
}

struct Play {
    session: Session,
    ground: Ground,
    device: Shared,
    strings: Strings,
    judge: Judge,
    swing: Swing,
    /// Seconds for the hand; what a stall skips, it skips too.
    time: f64,
    tick: u64,
    /// Added to the hand's position.
    offset: [f64; 3],
    /// Whether nothing was lifted out of the ground since the proxy was placed in it.
    began_inside: bool,
    host_calls: bool,
    ended: Option<SessionError>,
}

impl Play {
    fn new(random: &mut Random, off: Option<Stage>, is_mapped: bool) -> Play {
        let unlimited = Capabilities::unlimited([0.16, 0.12, 0.12]);
        let capabilities = Capabilities {
            max_force: random.between(4.0, 12.0),
            max_stiffness: random.one_of(&[f64::INFINITY, 300.0, 900.0]),
            delay_ticks: random.whole(0, 2) as u32,
            max_slew: random.one_of(&[f64::INFINITY, 700.0]),
            max_speed: random.between(2.0, 4.0),
            ..unlimited
        };
        let settings = Settings {
            stiffness: random.between(200.0, 1500.0),
            max_force: random.between(4.0, 12.0),
            ring_seconds: random.one_of(&[0.01, 1.0]),
            stale_after: Some(STALE_AFTER),
            interaction: Some(Interaction::default()),
            ..Settings::default()
        };
        let ground = Ground::new(random.coin(), is_mapped);
        let strings = Strings::default();
        let puppet = Puppet::on(build(random), strings.clone());
        let (witness, device) = Witness::new(capabilities);
        let mut session = Session::new(
            ground.grid.clone(),
            Box::new(witness),
            Box::new(puppet),
            Ground::window([0.0; 2]),
            settings,
        )
        .expect("settings that can be");
        session.watch_host_in_steps();
        if let Some(stage) = off {
            session.switch_off(stage);
        }
        let rates = std::array::from_fn(|_| random.between(6.0, 12.0));
        Play {
            session,
            ground,
            device,
            strings,
            judge: Judge::new(Promised::new(&settings, &capabilities)),
            swing: Swing { rates, phase: random.between(0.0, 6.3) },
            time: 0.0,
            tick: 0,
            offset: [0.0; 3],
            began_inside: true,
            host_calls: true,
            ended: None,
        }
    }

    /// Does ticks, each judged by what `known` says of it.
    fn go(&mut self, ticks: u64, known: &mut dyn FnMut() -> Known) {
        for _ in 0..ticks {
            self.one(known());
        }
    }

    /// One tick with the hand where it swings.
    fn one(&mut self, mut known: Known) {
        self.time += NOMINAL_PERIOD;
        let swing = self.swing.position(self.time);
        let position: [f64; 3] = std::array::from_fn(|axis| swing[axis] + self.offset[axis]);
        let is_number = position.iter().all(|metres| metres.is_finite());
        if self.ground.is_flat && is_number && known.depth.is_none() {
            known.depth = Some(-position[2]);
        }
        // Grounds are never higher than 20 cm, or 2 mm of workspace.
        if is_number {
            self.began_inside &= position[2] < if self.ground.is_flat { 0.0 } else { -0.0021 };
        }
        known.began_inside |= self.began_inside;
        self.device.lock().position = position;
        self.tick += 1;
        if self.host_calls && self.tick.is_multiple_of(HOST_EVERY) {
            self.session.state();
        }
        if self.ended.is_none() {
            self.ended = self.session.step(1).err();
        } else {
            let refused = self.session.step(1);
            self.judge.demand(refused.is_err(), || "touch went on after its end".to_owned());
        }
        let writes = std::mem::take(&mut self.device.lock().writes);
        if self.ended.is_none() || !writes.is_empty() {
            self.judge.tick(&writes, &known);
        }
    }

    /// The hand must feel nothing in ticks of that number.
    fn feel_nothing(&mut self, ticks: u64) {
        self.go(ticks, &mut || Known { no_force: true, ..Known::default() });
    }

    /// What only must keep the general promises.
    fn feel_anything(&mut self, ticks: u64) {
        self.go(ticks, &mut Known::default);
    }

    /// The proxy is placed at the hand in the next tick.
    fn begin_anew(&mut self) {
        self.began_inside = true;
    }

    /// What people do in mid-touch: choose another model, or lay the window elsewhere.
    fn change_something(&mut self, random: &mut Random) {
        if random.coin() {
            let puppet = Puppet::on(build(random), self.strings.clone());
            self.session.set_model(Box::new(puppet)).expect("nobody else asks for anything");
            // While it takes over, the force may follow the hand more slowly than a spring.
            self.go(100, &mut || Known { depth: Some(f64::INFINITY), ..Known::default() });
        } else {
            let aside = [random.between(-8.0, 8.0), random.between(-8.0, 8.0)];
            self.session.set_window(Ground::window(aside)).expect("a window over the ground");
            self.begin_anew();
            self.one(Known { no_force: true, begins: true, ..Known::default() });
        }
        self.feel_anything(random.whole(0, 500));
    }

    fn inject(&mut self, random: &mut Random, kind: Kind) -> Outcome {
        let before = self.session.statistics().totals.trips;
        self.fail(random, kind);
        let trips = self.session.statistics().totals.trips;
        self.judge_count(kind, &before, &trips);
        self.judge_end(kind);
        if self.ended.is_none() {
            self.judge.largest = 0.0;
            self.feel_anything(RECOVERY);
            let largest = self.judge.largest;
            self.judge.demand(largest > 0.0, || "nothing is felt any more".to_owned());
        }
        self.outcome(Some(kind))
    }

    fn fail(&mut self, random: &mut Random, kind: Kind) {
        match kind {
            Kind::ReadFails => self.fail_reads(&timeout("no packet"), random.whole(1, 3)),
            Kind::ReadFailsForGood => self.fail_reads(&timeout("no packet"), 5),
            Kind::ShortRead => self.fail_reads(&DeviceError::Protocol("5 bytes of 16".into()), 1),
            Kind::Gone => self.fail_reads(&DeviceError::Gone("unplugged".into()), 2),
            Kind::EveryTenthReadFails => {
                for _ in 0..10 {
                    self.fail_reads(&timeout("no packet"), 1);
                    self.feel_anything(if self.ended.is_some() { 1 } else { 9 });
                }
            }
            Kind::WriteFails => {
                self.device.lock().writes_to_fail = 1;
                self.feel_nothing(1);
            }
            Kind::WriteFailsForGood => {
                self.device.lock().writes_to_fail = u64::MAX;
                self.feel_nothing(5);
            }
            Kind::Jump => {
                let axis = random.whole(0, 3) as usize;
                self.offset[axis] = random.one_of(&[-1.0, 1.0]);
                self.begin_anew();
                self.feel_nothing(SPEED_CALM);
                self.feel_anything(random.whole(0, 400));
                self.offset = [0.0; 3];
                self.begin_anew();
                self.feel_nothing(SPEED_CALM);
            }
            Kind::JumpAndBack => {
                self.offset[random.whole(0, 3) as usize] = random.one_of(&[-1.0, 1.0]);
                self.feel_nothing(1);
                self.offset = [0.0; 3];
                self.begin_anew();
                self.feel_nothing(SPEED_CALM);
            }
            Kind::NotANumber | Kind::Infinite => {
                let number = match kind {
                    Kind::NotANumber => f64::NAN,
                    _ => random.one_of(&[f64::INFINITY, f64::NEG_INFINITY]),
                };
                self.offset[random.whole(0, 3) as usize] = number;
                self.feel_nothing(random.whole(1, 20));
                self.offset = [0.0; 3];
            }
            Kind::Buttons => self.play_with_buttons(random),
            Kind::MissedTicks => self.stall(random.whole(2, 21)),
            Kind::Stall100Ms => self.stall(100),
            Kind::Stall1S => self.stall(1000),
            Kind::Stall10S => self.stall(10_000),
            Kind::SilentHost => {
                self.host_calls = false;
                self.feel_anything(HOST_TICKS);
                self.feel_nothing(10_000 - HOST_TICKS);
                self.host_calls = true;
            }
            Kind::ModelPanics => self.order(Order::Panic, 2),
            Kind::ModelNotANumber => {
                self.order(Order::LoseProxy, 1);
                self.begin_anew();
            }
            Kind::ModelJumps => {
                self.strings.pull(Order::Jump);
                // The spring is as long as the model says.
                let far = || Known { depth: Some(f64::INFINITY), ..Known::default() };
                self.began_inside = false;
                self.go(50, &mut { far });
                self.strings.pull(Order::Behave);
                // Some ticks on the way back.
                self.go(40, &mut { far });
            }
            Kind::FileCut => {
                self.ground.cut();
                // The next sample that is read tells, or the next look of the host.
                self.feel_anything(HOST_EVERY);
                self.feel_nothing(2);
            }
        }
    }

    /// Modes change at random, and move the ground under the hand: what is known of it is no more than
    /// what is always promised. Then the window is laid anew.
    fn play_with_buttons(&mut self, random: &mut Random) {
        let unknown = || Known { depth: Some(f64::INFINITY), ..Known::default() };
        for _ in 0..200 {
            self.began_inside = false;
            self.device.lock().buttons = random.whole(0, 16) as u32;
            self.one(unknown());
        }
        self.device.lock().buttons = 0;
        let aside = [random.between(-8.0, 8.0), random.between(-8.0, 8.0)];
        self.session.set_window(Ground::window(aside)).expect("a window over the ground");
        self.begin_anew();
        self.one(Known { no_force: true, begins: true, ..Known::default() });
    }

    fn fail_reads(&mut self, error: &DeviceError, ticks: u64) {
        for _ in 0..ticks {
            self.device.lock().read_error = Some(error.clone());
            self.feel_nothing(1);
        }
    }

    fn order(&mut self, order: Order, ticks: u64) {
        self.strings.pull(order);
        self.feel_nothing(ticks);
        self.strings.pull(Order::Behave);
    }

    fn stall(&mut self, ticks: u64) {
        self.session.stall(ticks);
        self.time += ticks as f64 * NOMINAL_PERIOD;
        // The host is there all the while.
        self.session.heartbeat();
        if ticks >= 100 {
            self.begin_anew();
        }
        // A stall of 5 ms or longer is more than the time that the force has to go.
        let falling = if ticks >= LATE_TICKS { 0 } else { LATE_TICKS - 1 };
        // Its own way down follows no hand.
        self.go(falling, &mut || Known { depth: Some(f64::INFINITY), ..Known::default() });
        self.feel_nothing(LATE_CALM - falling);
    }

    /// Every fault is counted where it belongs.
    fn judge_count(&mut self, kind: Kind, before: &Trips, after: &Trips) {
        let (name, counted, least) = match kind {
            Kind::ReadFails | Kind::ShortRead | Kind::WriteFails | Kind::Gone => {
                ("device_errors", after.device_errors - before.device_errors, 1)
            }
            Kind::ReadFailsForGood | Kind::WriteFailsForGood => {
                ("device_errors", after.device_errors - before.device_errors, 3)
            }
            Kind::EveryTenthReadFails => {
                ("device_errors", after.device_errors - before.device_errors, 10)
            }
            Kind::Jump => ("speed_cuts", after.speed_cuts - before.speed_cuts, 2),
            Kind::JumpAndBack => ("speed_cuts", after.speed_cuts - before.speed_cuts, 1),
            Kind::NotANumber | Kind::Infinite | Kind::ModelNotANumber => {
                ("not_finite", after.not_finite - before.not_finite, 1)
            }
            Kind::MissedTicks | Kind::Stall100Ms | Kind::Stall1S | Kind::Stall10S => {
                ("late_cuts", after.late_cuts - before.late_cuts, 1)
            }
            Kind::SilentHost => ("host_cuts", after.host_cuts - before.host_cuts, 1),
            Kind::Buttons => {
                let cuts = |trips: &Trips| trips.speed_cuts + trips.device_errors + trips.late_cuts;
                let more = cuts(after) - cuts(before);
                self.judge.demand(more == 0, || "buttons took the force away".to_owned());
                return;
            }
            // A force at its limit already has nowhere to jump.
            Kind::ModelJumps | Kind::ModelPanics | Kind::FileCut => return,
        };
        self.judge.demand(counted >= least, || format!("{name} rose by {counted}"));
    }

    /// A fault that ends touch says why; one that does not is no end.
    fn judge_end(&mut self, kind: Kind) {
        let said = self.ended.as_ref().map(ToString::to_string);
        let is_right = match kind.ends_touch_with() {
            Some(words) => said.as_ref().is_some_and(|said| said.contains(words)),
            None => said.is_none(),
        };
        self.judge.demand(is_right, || format!("the message was {said:?}"));
    }

    /// What was found since the last outcome.
    fn outcome(&mut self, kind: Option<Kind>) -> Outcome {
        Outcome {
            kind,
            broken: std::mem::take(&mut self.judge.broken),
            force_after_fault: std::mem::take(&mut self.judge.force_after_fault),
        }
    }

    /// Drops the session where it is, and sees what the device was told last.
    fn drop_session(self) -> Vec<String> {
        let Play { session, device, mut judge, .. } = self;
        drop(session);
        let last = device.lock().writes.last().copied();
        let is_kept = last == Some(([0.0; 3], 0.0));
        judge.demand(is_kept, || format!("{last:?} was the last thing sent"));
        judge.broken
    }
}

fn build(random: &mut Random) -> Box<dyn ContactModel> {
    let model = random.one_of(&[Model::default(), Model::ProxyGraph]);
    model.build(model.default_step_budget())
}

fn timeout(words: &'static str) -> DeviceError {
    DeviceError::Timeout(words.into())
}
