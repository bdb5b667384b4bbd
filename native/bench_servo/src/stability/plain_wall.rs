//! A wall whose force is simply added, as in the paper's early work: what the mixing room is for.

use devices::{Capabilities, Device, DeviceError, Force, Pose};

/// A device that pushes the hand back from `x = at` on its own, beside what the servo sends.
pub struct PlainWall<D> {
    /// What is held.
    pub device: D,
    /// Metres to the right.
    pub at: f64,
    /// N/m.
    pub stiffness: f64,
    /// Newtons, for the pose read last.
    force: f64,
}

impl<D> PlainWall<D> {
    /// In front of `device`.
    pub fn new(device: D, at: f64, stiffness: f64) -> Self {
        Self { device, at, stiffness, force: 0.0 }
    }
}

impl<D: Device> Device for PlainWall<D> {
    fn capabilities(&self) -> Capabilities {
        self.device.capabilities()
    }

    fn read(&mut self, time: f64) -> Result<Pose, DeviceError> {
        let pose = self.device.read(time)?;
        self.force = -self.stiffness * (pose.position[0] - self.at).max(0.0);
        Ok(pose)
    }

    fn write(&mut self, force: Force, dt: f64) -> Result<(), DeviceError> {
        let [x, y, z] = force.newtons;
        self.device.write(Force { newtons: [x + self.force, y, z] }, dt)
    }

    fn set_target(&mut self, target: [f64; 3]) {
        self.device.set_target(target);
    }
}
