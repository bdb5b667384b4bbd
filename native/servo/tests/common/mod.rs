//! A flat ground, devices that can be watched, and models that can be told what to do.

// Every test file uses its own part of this.
#![allow(dead_code)]

pub mod handheld;

use std::ops::Range;
use std::sync::{Arc, Mutex};

use contact::{Contact, ContactModel, Counters, Feature, Proxy, ProxyGraph};
use devices::{Capabilities, Device, DeviceError, Force, PathPoint, Pose, ScriptedDevice};
use servo::{Session, Settings, Window};
use surface::{ByteOrder, Grid, GridLayout, GridPoint, Metric, SampleType};

/// Samples along each side of the ground.
pub const SIDE: u32 = 64;

/// Steps that a contact model may take, as by default.
pub const STEP_BUDGET: u32 = 4096;

/// A ground of 1 m cells whose elevations are given by column and row.
pub fn ground(elevation: impl Fn(u32, u32) -> f64) -> Arc<Grid> {
    let layout =
        GridLayout::packed(SIDE.into(), SIDE.into(), 1.0, 1.0, SampleType::F64, ByteOrder::Little)
            .unwrap();
    let samples = (0..SIDE).flat_map(|row| (0..SIDE).map(move |column| (column, row)));
    let bytes = samples.flat_map(|(column, row)| elevation(column, row).to_le_bytes()).collect();
    Arc::new(Grid::from_vec(bytes, layout).unwrap())
}

pub fn flat_ground() -> Arc<Grid> {
    ground(|_, _| 0.0)
}

/// The middle of the ground, 1 m of terrain being 1 cm of workspace.
pub fn window() -> Window {
    Window::new(32.0, -32.0, 0.0, 16.0, 1.0).unwrap()
}

pub fn proxy_graph() -> Box<dyn ContactModel> {
    Box::new(ProxyGraph::new(STEP_BUDGET))
}

pub fn session(device: impl Device + 'static, model: Box<dyn ContactModel>) -> Session {
    Session::new(flat_ground(), Box::new(device), model, window(), Settings::default()).unwrap()
}

/// A hand on a path of (seconds, x, y, z).
pub fn scripted(path: &[(f64, f64, f64, f64)]) -> ScriptedDevice {
    let path = path.iter().copied().map(PathPoint::from).collect();
    ScriptedDevice::new(path, [0.16, 0.12, 0.12]).unwrap()
}

/// What a watched device saw, in order.
#[derive(Clone, Debug, PartialEq)]
pub enum Seen {
    Read(f64),
    Write([f64; 3], f64),
    Target([f64; 3]),
    Dropped,
}

/// What a watched device saw, for the test to look at.
#[derive(Clone, Default)]
pub struct Log(Arc<Mutex<Vec<Seen>>>);

impl Log {
    fn add(&self, seen: Seen) {
        self.0.lock().unwrap().push(seen);
    }

    /// So that nothing is allocated for so many entries.
    pub fn make_room(&self, entries: usize) {
        self.0.lock().unwrap().reserve(entries);
    }

    pub fn all(&self) -> Vec<Seen> {
        self.0.lock().unwrap().clone()
    }

    pub fn forces(&self) -> Vec<[f64; 3]> {
        let force_of = |seen| match seen {
            Seen::Write(force, _) => Some(force),
            _ => None,
        };
        self.all().into_iter().filter_map(force_of).collect()
    }

    /// Newtons; nothing is copied, so that a loop that logs need not wait long for who looks.
    fn newest_force(&self) -> Option<[f64; 3]> {
        self.0.lock().unwrap().iter().rev().find_map(|seen| match seen {
            Seen::Write(force, _) => Some(*force),
            _ => None,
        })
    }

    /// Whether the hand is pushed up now.
    pub fn pushes(&self) -> bool {
        self.newest_force().is_some_and(|force| force[2] > 0.0)
    }

    /// Whether the hand feels nothing now.
    pub fn rests(&self) -> bool {
        self.newest_force() == Some([0.0; 3])
    }

    pub fn last_force(&self) -> [f64; 3] {
        *self.forces().last().expect("something was written")
    }

    pub fn reads(&self) -> usize {
        self.0.lock().unwrap().iter().filter(|seen| matches!(seen, Seen::Read(_))).count()
    }

    pub fn dropped(&self) -> bool {
        self.all().last() == Some(&Seen::Dropped)
    }
}

type Answer = Box<dyn FnMut(usize) -> Result<[f64; 3], DeviceError> + Send>;

/// A device that answers what the test wants, read by read, and logs everything.
pub struct Watched {
    log: Log,
    answer: Answer,
    reads: usize,
    writes: usize,
    /// By number, from 0.
    pub refused_writes: Range<usize>,
    pub capabilities: Capabilities,
}

impl Watched {
    /// `answer` is given the number of the read, from 0.
    pub fn new(
        log: &Log,
        answer: impl FnMut(usize) -> Result<[f64; 3], DeviceError> + Send + 'static,
    ) -> Watched {
        Watched {
            log: log.clone(),
            answer: Box::new(answer),
            reads: 0,
            writes: 0,
            refused_writes: 0..0,
            capabilities: Capabilities {
                max_force: 8.0,
                ..Capabilities::unlimited([0.16, 0.12, 0.12])
            },
        }
    }

    /// Comes from above and then stays a centimetre in the ground.
    pub fn pressing(log: &Log) -> Watched {
        Watched::new(log, |read| Ok([0.0, 0.0, if read == 0 { 0.01 } else { -0.01 }]))
    }
}

impl Device for Watched {
    fn capabilities(&self) -> Capabilities {
        self.capabilities
    }

    fn read(&mut self, time: f64) -> Result<Pose, DeviceError> {
        self.log.add(Seen::Read(time));
        let read = self.reads;
        self.reads += 1;
        (self.answer)(read).map(Pose::at)
    }

    fn write(&mut self, force: Force, dt: f64) -> Result<(), DeviceError> {
        self.log.add(Seen::Write(force.newtons, dt));
        self.writes += 1;
        match self.refused_writes.contains(&(self.writes - 1)) {
            true => Err(DeviceError::Timeout("not sent".into())),
            false => Ok(()),
        }
    }

    fn set_target(&mut self, target: [f64; 3]) {
        self.log.add(Seen::Target(target));
    }
}

impl Drop for Watched {
    fn drop(&mut self) {
        self.log.add(Seen::Dropped);
    }
}

/// A model whose proxy is where the test says.
pub struct Told<F>(pub F);

impl<F: FnMut(&GridPoint) -> (GridPoint, Feature) + Send> ContactModel for Told<F> {
    fn name(&self) -> &'static str {
        "told"
    }

    fn proxy(&self) -> Proxy {
        Proxy::in_space(GridPoint::new(0.0, 0.0, 0.0))
    }

    fn take_over(&mut self, _proxy: Proxy) {}

    fn update(&mut self, _grid: &Grid, _metric: &Metric, goal: &GridPoint) -> Contact {
        let (proxy, feature) = (self.0)(goal);
        let counters =
            Counters { vertices: 2, faces: 3, collision_tests: 1, ..Counters::default() };
        Contact { proxy, feature, displacement: [0.0; 3], counters }
    }
}

/// Waits until something is so; a test that hangs here is ended by whoever runs the tests.
///
/// It sleeps meanwhile: on a busy machine a test that went round and round would take the time that
/// the loop needs to be punctual, without which there is no force to wait for.
pub fn wait_until(mut so: impl FnMut() -> bool) {
    while !so() {
        std::thread::sleep(std::time::Duration::from_millis(1));
    }
}
