//! Contact models switched in touch: the hand feels no jolt, and nothing is lost.

mod common;

use std::sync::mpsc::{Sender, channel};
use std::thread::ThreadId;

use common::*;
use contact::{Contact, ContactModel, Feature, Model, Proxy};
use devices::{Device, DeviceError, NOMINAL_PERIOD};
use servo::{Fault, Session, SessionError, Settings, TickRecord, Window};
use surface::{Grid, GridPoint, Metric};

const MODELS: [Model; 6] = [
    Model::SurfaceWalk { sub_step: None },
    Model::SurfaceWalk { sub_step: Some(0.25) },
    Model::ProxyGraph,
    Model::GodObject,
    Model::GodObjectRelease,
    Model::VirtualProxy { radius: 0.002 },
];

/// Ticks of a path, and the one that another model answers first.
const TICKS: u64 = 600;
const SWITCH: u64 = 300;

/// No force of these paths is cut: what is judged is the slew limit alone.
fn settings() -> Settings {
    Settings { stiffness: 100.0, ..Settings::default() }
}

/// Of a force up to 8 N that may swing fully in 50 ms, in a tick.
const SLEW: f64 = 8.0 / 0.05 * NOMINAL_PERIOD;

/// Of a few units in the last place, on forces of some newtons.
const ROUNDING: f64 = 1e-12;

fn build(model: &Model) -> Box<dyn ContactModel> {
    model.build(model.default_step_budget())
}

/// Steps between neighbours up to the length of a cell.
fn rough(column: u32, row: u32) -> f64 {
    f64::from((column * 7919 + row * 104_729) % 17) / 17.0
}

/// Down to a cell under the lowest ground, then over five cells or so.
fn sliding() -> impl Device {
    scripted(&[(0.0, -0.021, -0.013, 0.03), (0.1, -0.02, -0.01, -0.01), (0.6, 0.031, 0.017, -0.01)])
}

fn sliding_with(model: Box<dyn ContactModel>) -> Session {
    Session::new(ground(rough), Box::new(sliding()), model, window(), settings()).unwrap()
}

fn unswitched(model: Box<dyn ContactModel>) -> Vec<TickRecord> {
    let mut session = sliding_with(model);
    session.step(TICKS).unwrap();
    session.drain()
}

fn switched(from: Box<dyn ContactModel>, to: Box<dyn ContactModel>) -> Vec<TickRecord> {
    let mut session = sliding_with(from);
    session.step(SWITCH - 1).unwrap();
    session.set_model(to).unwrap();
    session.step(TICKS - SWITCH + 1).unwrap();
    session.drain()
}

/// Changes of the force from tick to tick, from the first given one on.
fn steps(records: &[TickRecord], first: u64) -> Vec<f64> {
    let changes = records.windows(2).filter(|pair| pair[1].tick >= first);
    changes.map(|pair| way(pair[0].force, pair[1].force)).collect()
}

fn largest(steps: &[f64]) -> f64 {
    steps.iter().copied().fold(0.0, f64::max)
}

fn way(from: [f64; 3], to: [f64; 3]) -> f64 {
    (to[0] - from[0]).hypot(to[1] - from[1]).hypot(to[2] - from[2])
}

/// A proxy graph whose proxy is said to be higher than it is.
struct Offset {
    graph: Box<dyn ContactModel>,
    /// Metres of terrain.
    up: f64,
}

fn offset(up: f64) -> Box<dyn ContactModel> {
    Box::new(Offset { graph: proxy_graph(), up })
}

impl ContactModel for Offset {
    fn name(&self) -> &'static str {
        "offset"
    }

    fn proxy(&self) -> Proxy {
        self.graph.proxy()
    }

    fn take_over(&mut self, proxy: Proxy) {
        self.graph.take_over(proxy);
    }

    fn update(&mut self, grid: &Grid, metric: &Metric, goal: &GridPoint) -> Contact {
        let mut contact = self.graph.update(grid, metric, goal);
        contact.proxy.elevation += self.up;
        contact
    }
}

#[test]
fn between_any_two_models_the_force_makes_no_jump() {
    let bumps = |model: &Model| largest(&steps(&unswitched(build(model)), SWITCH / 2));
    for from in &MODELS {
        for to in &MODELS {
            let records = switched(build(from), build(to));
            let steps = steps(&records, SWITCH);
            assert!(steps[0] <= SLEW + ROUNDING, "{from:?} to {to:?}: {} N", steps[0]);
            let ordinary = bumps(from).max(bumps(to));
            assert!(largest(&steps) <= SLEW + ordinary, "{from:?} to {to:?}: {}", largest(&steps));
        }
    }
}

#[test]
fn between_any_two_models_contact_is_kept_above_the_ground() {
    let terrain = ground(rough);
    for from in &MODELS {
        for to in &MODELS {
            for record in &switched(build(from), build(to))[SWITCH as usize - 2..] {
                assert_ne!(record.feature, Feature::Free, "{from:?} to {to:?} at {}", record.tick);
                let place = terrain.layout().grid_point(record.proxy);
                let depth = terrain.surface_elevation(&place).unwrap() - place.elevation;
                // Heights are about a metre; a few units in their last place are far below this.
                assert!(depth <= 1e-12, "{from:?} to {to:?}: {depth} m under the surface");
            }
        }
    }
}

#[test]
fn a_force_that_would_jump_is_led_to_its_new_place() {
    // 3 m of terrain are 3 cm of workspace: 3 N more or less.
    for (from, to) in [(0.0, 3.0), (3.0, 0.0)] {
        let records = switched(offset(from), offset(to));
        let steps = steps(&records, SWITCH);
        let bumps = largest(&crate::steps(&unswitched(offset(0.0)), SWITCH / 2));
        assert!((steps[0] - SLEW).abs() < ROUNDING, "as fast as the limit lets it: {}", steps[0]);
        assert!(largest(&steps) <= SLEW + bumps);
        let there = unswitched(offset(to));
        assert!(way(records[SWITCH as usize - 1].force, there[SWITCH as usize - 1].force) > 2.0);
        // In 3 N / 160 N/s, and as long again for what the ground does meanwhile.
        let late = SWITCH as usize + 40;
        for (found, wanted) in records[late..].iter().zip(&there[late..]) {
            assert_eq!(found.force, wanted.force, "tick {}", found.tick);
        }
    }
}

#[test]
fn a_switch_to_the_same_model_changes_no_bit() {
    let forces = |records: Vec<TickRecord>| -> Vec<[f64; 3]> {
        records.iter().map(|record| record.force).collect()
    };
    assert_eq!(
        forces(switched(proxy_graph(), proxy_graph())),
        forces(unswitched(proxy_graph())),
        "the proxy is handed over whole, and this ground asks for less than the slew limit"
    );
}

#[test]
fn a_switch_in_the_middle_of_another_one_goes_on_from_the_force_that_acts() {
    let mut session = sliding_with(offset(0.0));
    session.step(SWITCH - 1).unwrap();
    for turn in 0..40 {
        session.set_model(offset(if turn % 2 == 0 { 3.0 } else { 0.0 })).unwrap();
        session.step(3).unwrap();
    }
    let steps = steps(&session.drain(), SWITCH);
    assert!(largest(&steps) <= SLEW + ROUNDING);
    assert!(largest(&steps) > 0.9 * SLEW);
}

#[test]
fn the_model_in_charge_is_named() {
    let mut session = sliding_with(proxy_graph());
    assert_eq!((session.model(), session.state().model), ("proxy_graph", "proxy_graph"));
    session.set_model(offset(1.0)).unwrap();
    assert_eq!(session.model(), "offset");
    session.step(1).unwrap();
    assert_eq!(session.state().model, "offset");
}

#[test]
fn a_new_window_ends_the_smoothing() {
    for window_first in [false, true] {
        let mut session = sliding_with(offset(0.0));
        session.step(SWITCH).unwrap();
        assert!(session.state().force[2] > 1.0);
        let elsewhere = Window::new(20.0, -40.0, 0.5, 8.0, 2.0).unwrap();
        if window_first {
            session.set_window(elsewhere).unwrap();
        }
        session.set_model(offset(0.0)).unwrap();
        if !window_first {
            session.set_window(elsewhere).unwrap();
        }
        session.step(1).unwrap();
        assert_eq!(session.state().force, [0.0; 3], "the proxy begins at the hand, at once");
    }
}

#[test]
fn a_switch_while_the_session_stands_holds_when_it_goes_on() {
    let log = Log::default();
    let mut session = session(Watched::pressing(&log), proxy_graph());
    session.start().unwrap();
    wait_until(|| log.pushes());
    session.stop();
    session.set_model(build(&Model::ProxyGraph)).unwrap();
    session.step(3).unwrap();
    assert_eq!(session.state().force, [0.0; 3], "the hand is in the ground and is not kicked out");
}

#[test]
fn zero_force_is_never_late() {
    let log = Log::default();
    let device = Watched::new(&log, |read| match read {
        0 => Ok([0.0, 0.0, 0.01]),
        72 => Ok([f64::NAN, 0.0, -0.01]),
        80.. => Err(DeviceError::Gone("unplugged".into())),
        _ => Ok([0.0, 0.0, -0.01]),
    });
    let mut session = session(device, offset(0.0));
    session.step(70).unwrap();
    session.set_model(offset(3.0)).unwrap();
    session.step(2).unwrap();
    let before = log.last_force()[2];
    assert!(before > 5.0 && before < 6.0, "on the way up: {before}");
    session.step(1).unwrap();
    assert_eq!(log.last_force(), [0.0; 3], "a hand that is nowhere");
    session.step(1).unwrap();
    session.set_model(offset(0.0)).unwrap();
    assert!(session.step(100).is_err());
    assert_eq!(log.last_force(), [0.0; 3], "a fault");
}

#[test]
fn after_a_fault_a_switch_is_no_error_of_its_own() {
    let log = Log::default();
    let gone = |_| Err(DeviceError::Gone("unplugged".into()));
    let mut stepped = session(Watched::new(&log, gone), proxy_graph());
    assert!(stepped.step(1).is_err());
    stepped.set_model(offset(1.0)).unwrap();
    assert_eq!(stepped.model(), "offset");
    assert!(matches!(stepped.fault(), Some(Fault::Device(_))));

    let mut live = session(Watched::new(&log, gone), proxy_graph());
    live.start().unwrap();
    wait_until(|| !live.running());
    for _ in 0..1000 {
        live.set_model(offset(1.0)).unwrap();
    }
    live.stop();
    live.set_model(offset(1.0)).unwrap();
}

/// A proxy graph that tells where it is freed.
struct Mortal {
    graph: Box<dyn ContactModel>,
    freed: Sender<ThreadId>,
}

impl ContactModel for Mortal {
    fn name(&self) -> &'static str {
        "mortal"
    }

    fn proxy(&self) -> Proxy {
        self.graph.proxy()
    }

    fn take_over(&mut self, proxy: Proxy) {
        self.graph.take_over(proxy);
    }

    fn update(&mut self, grid: &Grid, metric: &Metric, goal: &GridPoint) -> Contact {
        self.graph.update(grid, metric, goal)
    }
}

impl Drop for Mortal {
    fn drop(&mut self) {
        let _ = self.freed.send(std::thread::current().id());
    }
}

#[test]
fn a_running_loop_switches_and_leaves_the_freeing_to_others() {
    let (freed, told) = channel();
    let mortal = || Box::new(Mortal { graph: proxy_graph(), freed: freed.clone() });
    let mut session = session(Watched::pressing(&Log::default()), mortal());
    session.start().unwrap();
    wait_until(|| session.state().in_contact());
    let mut expected = 0;
    for _ in 0..5 {
        session.set_model(proxy_graph()).unwrap();
        wait_until(|| session.state().model == "proxy_graph");
        assert!(session.state().in_contact());
        session.set_model(mortal()).unwrap();
        wait_until(|| session.state().model == "mortal");
        expected += 1;
    }
    let freed_by: Vec<ThreadId> = told.try_iter().collect();
    assert_eq!(freed_by, vec![std::thread::current().id(); expected], "no model is kept");
    drop(session);
    assert_eq!(told.try_iter().count(), 1, "nor is the last one lost");
}

#[test]
fn a_switch_that_nobody_takes_is_refused_and_keeps_its_name_back() {
    let (let_go, held) = channel::<()>();
    let log = Log::default();
    let device = Watched::new(&log, move |read| {
        if read == 0 {
            let _ = held.recv();
        }
        Ok([0.0; 3])
    });
    let mut session = session(device, proxy_graph());
    session.start().unwrap();
    wait_until(|| log.reads() == 1);
    while session.set_model(offset(1.0)).is_ok() {}
    let refused = session.set_model(proxy_graph());
    drop(let_go);
    assert!(matches!(refused, Err(SessionError::CommandsFull)));
    assert_eq!(session.model(), "offset");
    wait_until(|| session.state().model == "offset");
    session.stop();
}
