//! A device that does what the sequence wants, and keeps what it was told.

use std::sync::{Arc, Mutex, MutexGuard};

use devices::{Capabilities, Device, DeviceError, Force, Pose};

/// What the device is told, and what it answers in the next tick.
#[derive(Default)]
pub(super) struct Script {
    pub(super) position: [f64; 3],
    pub(super) buttons: u32,
    /// Of the read; taken by it.
    pub(super) read_error: Option<DeviceError>,
    /// How many writes fail from now on.
    pub(super) writes_to_fail: u64,
    /// Newtons and seconds, in order, since they were taken.
    pub(super) writes: Vec<([f64; 3], f64)>,
}

/// Both ends' hold on the script.
#[derive(Clone, Default)]
pub(super) struct Shared(Arc<Mutex<Script>>);

impl Shared {
    pub(super) fn lock(&self) -> MutexGuard<'_, Script> {
        self.0.lock().unwrap_or_else(|poisoned| poisoned.into_inner())
    }
}

/// The device itself.
pub(super) struct Witness {
    shared: Shared,
    capabilities: Capabilities,
}

impl Witness {
    pub(super) fn new(capabilities: Capabilities) -> (Witness, Shared) {
        let shared = Shared::default();
        (Witness { shared: shared.clone(), capabilities }, shared)
    }
}

impl Device for Witness {
    fn capabilities(&self) -> Capabilities {
        self.capabilities
    }

    fn read(&mut self, _time: f64) -> Result<Pose, DeviceError> {
        let mut script = self.shared.lock();
        match script.read_error.take() {
            Some(error) => Err(error),
            None => Ok(Pose { buttons: script.buttons, ..Pose::at(script.position) }),
        }
    }

    fn write(&mut self, force: Force, dt: f64) -> Result<(), DeviceError> {
        let mut script = self.shared.lock();
        script.writes.push((force.newtons, dt));
        if script.writes_to_fail > 0 {
            script.writes_to_fail -= 1;
            return Err(DeviceError::Timeout("not sent".into()));
        }
        Ok(())
    }
}
