//! Safety: what stands between the wanted force and the device, and cannot be passed by.
//!
//! [`Safety`] is the only holder of the device, so no force reaches a hand but through its stages,
//! a file each:
//!
//! | stage | file | what it does |
//! | --- | --- | --- |
//! | device | `errors` | zero force for an error; too many end touch |
//! | finite | here | zero force for a hand or a force that is no number |
//! | speed | `speed` | zero force while the handle has slipped |
//! | host | `host` | no force while nobody looks at the session |
//! | late | `late` | no force while ticks are missed |
//! | end | here | no force once a device has played all that it had |
//! | clamp, stiffness | `limits` | the lower of the person's limit and the device's |
//! | ramp | `gate` | takes the force away and brings it back slowly, for all of the above |
//! | slew | `slew` | lets the force change only so fast |
//! | last zero | here | zero force is the last thing sent |
//!
//! One more is the servo's: it places the proxy at the hand whenever [`Safety`] says that the hand
//! was not followed (`engage`), so that nothing is felt where a hand already is inside the surface.

mod errors;
mod gate;
mod host;
mod late;
mod limits;
mod slew;
mod speed;
mod stages;
mod trips;
mod words;

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;

use devices::{Capabilities, Device, Force, ParameterError, Pose};

use crate::memory::Piece;
use crate::{Fault, Settings};

use errors::Tolerance;
use gate::Gate;
use host::HostWatch;
use late::LateWatch;
use slew::Slew;
use speed::SpeedWatch;
use stages::Stages;

pub(crate) use errors::TOO_MANY;
pub use host::{Heartbeat, STALE_AFTER};
pub use limits::Limits;
pub use stages::Stage;
use trips::Reasons;
pub use trips::{Held, Trips};
pub use words::Warning;

/// Seconds without a pose after which the hand may be anywhere, and the proxy begins anew at it.
///
/// Ours: a hand moves by several centimetres in a tenth of a second, which is no way that a proxy
/// has followed; and it is the time after which a host counts as stalled, too.
const LOST_AFTER: f64 = 0.1;

/// How often the last zero force is tried on a device that refuses it: a motor keeps the force that
/// it was told last.
const LAST_ZERO_TRIES: u32 = 3;

/// What a device said in a tick.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Reading {
    /// Where the hand is.
    Hand {
        pose: Pose,
        /// Whether the hand was followed here. Otherwise the proxy must begin anew at it.
        followed: bool,
    },
    /// Nothing that can be used; there will be no force.
    Nothing,
}

/// The device, behind all stages.
pub(crate) struct Safety {
    device: Box<dyn Device>,
    limits: Limits,
    errors: Tolerance,
    speed: SpeedWatch,
    host: HostWatch,
    late: LateWatch,
    gate: Gate,
    slew: Slew,
    trips: Trips,
    /// Why the gate is not open.
    held: Option<Held>,
    reasons: Reasons,
    stages: Stages,
}

impl Safety {
    /// Takes a device over; limits are the lower of `settings` and what the device can do.
    pub(crate) fn new(
        device: Box<dyn Device>,
        settings: &Settings,
    ) -> Result<Safety, ParameterError> {
        let capabilities = device.capabilities();
        capabilities.validate()?;
        let limits = Limits::new(settings, &capabilities);
        Ok(Safety {
            device,
            limits,
            errors: Tolerance::default(),
            speed: SpeedWatch::new(limits.max_speed),
            host: HostWatch::default(),
            late: LateWatch::default(),
            gate: Gate::default(),
            slew: Slew::new(limits.max_slew, limits.max_force),
            trips: Trips::default(),
            held: None,
            reasons: Reasons::default(),
            stages: Stages::default(),
        })
    }

    /// Deadlines passed without a tick.
    pub(crate) fn miss(&mut self, ticks: u64) {
        self.late.miss(ticks);
    }

    /// The device's state.
    pub(crate) fn memory(&self) -> Piece {
        Piece::of(&*self.device)
    }

    /// Reads the hand in a tick that ends `dt` seconds after the last one, and looks at everything
    /// that could forbid a force in it.
    pub(crate) fn read(&mut self, time: f64, dt: f64) -> Result<Reading, Fault> {
        self.errors.begin_tick();
        self.reasons.begin_tick();
        self.watch_clock(dt);
        let pose = match self.device.read(time) {
            Ok(pose) => pose,
            Err(error) => {
                self.speed.lose(dt);
                if !self.stages.are_on(Stage::Device) {
                    return Ok(Reading::Nothing);
                }
                self.forgive(error, time)?;
                return Ok(Reading::Nothing);
            }
        };
        if self.stages.are_on(Stage::Finite) && !pose.is_finite() {
            self.speed.lose(dt);
            self.distrust();
            return Ok(Reading::Nothing);
        }
        if self.device.is_finished() {
            self.close(Held::Finished, 0.0);
        }
        Ok(Reading::Hand { pose, followed: self.follow(&pose, dt) })
    }

    /// The host's and the servo's own lateness.
    fn watch_clock(&mut self, dt: f64) {
        if self.late.is_late() && self.stages.are_on(Stage::Late) {
            self.close(Held::Late, late::CALM);
        }
        if self.host.is_stale(dt) && self.stages.are_on(Stage::Host) {
            self.close(Held::Host, host::CALM);
        }
    }

    /// Whether the hand moved as hands do since it was seen last.
    fn follow(&mut self, pose: &Pose, dt: f64) -> bool {
        let step = self.speed.see(pose.position, dt);
        if step.too_fast && self.stages.are_on(Stage::Speed) {
            self.shut(Held::Speed, speed::CALM);
            return false;
        }
        step.seconds < LOST_AFTER
    }

    /// Sends the force on the way to `wanted`, which acts for `dt` seconds, and says which one.
    pub(crate) fn send(&mut self, wanted: Force, time: f64, dt: f64) -> Result<Force, Fault> {
        let force = self.gated(wanted, dt);
        match self.device.write(force, dt) {
            Ok(()) => Ok(force),
            Err(_) if !self.stages.are_on(Stage::Device) => Ok(force),
            Err(error) => {
                self.forgive(error, time)?;
                // The device may still be doing what it was told before.
                let _ = self.device.write(Force::ZERO, 0.0);
                Ok(Force::ZERO)
            }
        }
    }

    /// The wanted force through clamp, gate and slew limit.
    fn gated(&mut self, wanted: Force, dt: f64) -> Force {
        if self.stages.are_on(Stage::Finite) && !wanted.is_finite() {
            self.distrust();
        }
        let open = self.gate.pass(dt, self.stages);
        if open == 1.0 {
            self.held = None;
        }
        if open == 0.0 {
            self.slew.cut();
            return Force::ZERO;
        }
        let force = self.clamped(wanted);
        self.trips.clamped += u64::from(force != wanted);
        self.trips.ramped += u64::from(open < 1.0 && force != Force::ZERO);
        let force = Force { newtons: force.newtons.map(|component| component * open) };
        if !self.stages.are_on(Stage::Slew) {
            return force;
        }
        let (force, was_cut) = self.slew.limited(force, dt);
        self.trips.slew_limited += u64::from(was_cut);
        force
    }

    /// What of a finite force is not beyond its limit: all that is sent while nothing holds it back.
    pub(crate) fn clamped(&self, wanted: Force) -> Force {
        match self.stages.are_on(Stage::Clamp) {
            true => limits::clamped(wanted, self.limits.max_force).0,
            false => wanted,
        }
    }

    /// Something was not a number: no force in this tick.
    pub(crate) fn distrust(&mut self) {
        if self.stages.are_on(Stage::Finite) {
            self.trips.not_finite += 1;
            self.shut(Held::NotFinite, 0.0);
        }
    }

    /// An error of the device: no force in this tick, or the end.
    fn forgive(&mut self, error: devices::DeviceError, time: f64) -> Result<(), Fault> {
        self.trips.device_errors += 1;
        self.shut(Held::Device, 0.0);
        self.slew.cut();
        self.errors.forgive(error, time)
    }

    /// The proxy begins at the hand: the force is ramped in from nothing.
    pub(crate) fn engage(&mut self) {
        self.trips.engaged += 1;
        self.gate.engage();
        self.slew.cut();
    }

    /// Something else answers from now on, as another contact model or mode: the force goes over
    /// slowly.
    pub(crate) fn hand_over(&mut self) {
        self.slew.hand_over();
    }

    /// Sends zero force, at once and whatever happened before.
    pub(crate) fn release(&mut self) {
        self.gate = Gate::default();
        self.held = None;
        self.slew.cut();
        self.speed.forget();
        self.host.begin();
        // The clock stands until the next tick, and what was plugged may be another device by then.
        self.late = LateWatch::default();
        self.errors = Tolerance::default();
        if !self.stages.are_on(Stage::LastZero) {
            return;
        }
        for _ in 0..LAST_ZERO_TRIES {
            // When all are in vain there is no more that could be done for the hand.
            if self.device.write(Force::ZERO, 0.0).is_ok() {
                return;
            }
        }
    }

    /// Takes the force away at once, until `calm` seconds after the last such call.
    fn shut(&mut self, why: Held, calm: f64) {
        self.count(why);
        self.gate.shut(calm);
    }

    /// Takes the force away in a few milliseconds, until `calm` seconds after the last such call.
    fn close(&mut self, why: Held, calm: f64) {
        self.count(why);
        self.gate.close(calm);
    }

    /// A reason that goes on from tick to tick is one trip.
    fn count(&mut self, why: Held) {
        self.held = Some(why);
        if self.reasons.is_new(why) {
            match why {
                Held::Speed => self.trips.speed_cuts += 1,
                Held::Host => self.trips.host_cuts += 1,
                Held::Late => self.trips.late_cuts += 1,
                // Counted by ticks where they are noticed; an end is no trip; and no stage acts below
                // the ground.
                Held::Device | Held::NotFinite | Held::Finished | Held::Below => {}
            }
        }
    }

    /// From now on there shall be no force while `heartbeat` stands still; `None` ends that.
    pub(crate) fn watch_host(&mut self, heartbeat: Option<(Arc<Heartbeat>, f64)>) {
        self.host = HostWatch::new(heartbeat);
    }

    /// Where a simulated hand shall go (workspace metres).
    pub(crate) fn set_target(&mut self, target: [f64; 3]) {
        self.device.set_target(target);
    }

    /// How far a simulated handle shall be turned, radians.
    pub(crate) fn set_twist(&mut self, radians: f64) {
        self.device.set_twist(radians);
    }

    /// What the device can do.
    pub(crate) fn capabilities(&self) -> Capabilities {
        self.device.capabilities()
    }

    /// Of the spring, N/m.
    pub(crate) fn stiffness(&self) -> f64 {
        match self.stages.are_on(Stage::Stiffness) {
            true => self.limits.stiffness,
            false => self.limits.asked_stiffness,
        }
    }

    /// What holds.
    pub(crate) fn limits(&self) -> &Limits {
        &self.limits
    }

    /// How often each stage has acted.
    pub(crate) fn trips(&self) -> &Trips {
        &self.trips
    }

    /// Why the force is away, or not yet wholly back.
    pub(crate) fn held(&self) -> Option<Held> {
        self.held
    }

    /// Whether a stage does its work.
    pub(crate) fn is_on(&self, stage: Stage) -> bool {
        self.stages.are_on(stage)
    }

    /// Takes a stage out, to show that the tests notice.
    #[cfg(feature = "test-hooks")]
    pub(crate) fn switch_off(&mut self, stage: Stage) {
        self.stages.switch_off(stage);
    }
}

impl Drop for Safety {
    fn drop(&mut self) {
        // A driver that panics here would abort the process if another panic brought us here.
        let _ = catch_unwind(AssertUnwindSafe(|| self.release()));
    }
}
