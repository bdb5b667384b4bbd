//! A device whose hand, handle and errors a test holds.

use std::sync::{Arc, Mutex, MutexGuard};

use devices::{Capabilities, Device, DeviceError, Force, Pose};
use servo::{Interaction, Session, Settings, Window};
use surface::Grid;

use super::{flat_ground, proxy_graph, window};

pub const TICK: f64 = 1e-3;

/// N/m.
pub const STIFFNESS: f64 = 500.0;

/// Ticks after which the force of a new touch is whole, and after which a mode's force has been led
/// to its place.
pub const RAMPED: u64 = 60;

/// What the device says next, and what it was told.
pub struct Script {
    pub pose: Pose,
    pub error: Option<DeviceError>,
    /// Newtons, the last ones.
    pub force: [f64; 3],
}

#[derive(Clone)]
pub struct Shared(Arc<Mutex<Script>>);

impl Shared {
    pub fn lock(&self) -> MutexGuard<'_, Script> {
        self.0.lock().unwrap_or_else(|poisoned| poisoned.into_inner())
    }
}

pub struct Handheld {
    shared: Shared,
    capabilities: Capabilities,
}

impl Device for Handheld {
    fn capabilities(&self) -> Capabilities {
        self.capabilities
    }

    fn read(&mut self, _time: f64) -> Result<Pose, DeviceError> {
        let script = self.shared.lock();
        match &script.error {
            Some(error) => Err(error.clone()),
            None => Ok(script.pose),
        }
    }

    fn write(&mut self, force: Force, _dt: f64) -> Result<(), DeviceError> {
        self.shared.lock().force = force.newtons;
        Ok(())
    }
}

/// A hand, and the session that it is in.
pub struct Play {
    pub session: Session,
    pub device: Shared,
}

pub fn settings() -> Settings {
    let interaction = Some(Interaction::default());
    Settings { stiffness: STIFFNESS, walls: true, interaction, ..Settings::default() }
}

impl Play {
    /// A hand 2 cm over the middle of flat ground.
    pub fn new() -> Play {
        Play::on(flat_ground(), window(), settings())
    }

    pub fn on(grid: Arc<Grid>, window: Window, settings: Settings) -> Play {
        let pose = Pose { twist: Some(0.0), ..Pose::at([0.0, 0.0, 0.02]) };
        let shared = Shared(Arc::new(Mutex::new(Script { pose, error: None, force: [0.0; 3] })));
        let capabilities =
            Capabilities { max_force: 8.0, ..Capabilities::unlimited([0.16, 0.12, 0.12]) };
        let device = Box::new(Handheld { shared: shared.clone(), capabilities });
        let session = Session::new(grid, device, proxy_graph(), window, settings).unwrap();
        let mut play = Play { session, device: shared };
        play.rest(RAMPED);
        play
    }

    /// Ticks with the hand where it is.
    pub fn rest(&mut self, ticks: u64) {
        self.session.step(ticks).unwrap();
    }

    pub fn hand(&self) -> [f64; 3] {
        self.device.lock().pose.position
    }

    /// Goes straight and evenly.
    pub fn go(&mut self, to: [f64; 3], ticks: u64) {
        let from = self.hand();
        for tick in 1..=ticks {
            let share = tick as f64 / ticks as f64;
            let position = std::array::from_fn(|axis| from[axis] + share * (to[axis] - from[axis]));
            self.device.lock().pose.position = position;
            self.rest(1);
        }
    }

    pub fn twist(&mut self, to: f64, ticks: u64) {
        let from = self.device.lock().pose.twist.unwrap();
        for tick in 1..=ticks {
            let share = tick as f64 / ticks as f64;
            self.device.lock().pose.twist = Some(from + share * (to - from));
            self.rest(1);
        }
    }

    pub fn button(&mut self, is_down: bool) {
        self.device.lock().pose.buttons = u32::from(is_down);
        self.rest(1);
    }

    pub fn force(&self) -> [f64; 3] {
        self.device.lock().force
    }

    /// 5 mm in the ground, which holds with 2.5 N.
    pub fn touching() -> Play {
        let mut play = Play::new();
        play.go([0.0, 0.0, -0.005], 100);
        assert!(play.session.state().in_contact());
        play
    }
}
