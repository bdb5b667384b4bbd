//! The promises, checked force by force. Nothing here is shared with the safety chain but numbers
//! that are promised to people.

use crate::STALE_AFTER;

/// Seconds in which the force rises from nothing to its whole at the soonest.
const RAMP: f64 = 0.05;

/// Seconds in which a watchdog takes the force away.
const FALL: f64 = 0.005;

/// Seconds in which the force changes from nothing to its whole at the soonest.
const FULL_SWING: f64 = 0.005;

/// Ticks from the host's last call to zero force.
pub(super) const HOST_TICKS: u64 = ((STALE_AFTER + FALL) * 1000.0) as u64 + 1;

/// Ticks from a tick that comes too late to zero force.
pub(super) const LATE_TICKS: u64 = (FALL * 1000.0) as u64;

/// Of some units in the last place.
const ROUNDING: f64 = 1e-9;

/// The limits that were promised to a session.
#[derive(Clone, Copy, Debug)]
pub(super) struct Promised {
    /// N.
    pub(super) force: f64,
    /// N/s.
    pub(super) slew: f64,
    /// N/m.
    pub(super) stiffness: f64,
}

impl Promised {
    pub(super) fn new(settings: &crate::Settings, device: &devices::Capabilities) -> Promised {
        let force = settings.max_force.min(device.max_force);
        let slew = settings.max_slew.min(device.max_slew).min(force / FULL_SWING);
        let delays = 1.0 + 2.0 * f64::from(device.delay_ticks);
        let stiffness = settings.stiffness.min(device.max_stiffness / delays);
        Promised { force, slew, stiffness }
    }
}

/// What is known about a tick when its force is judged.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Known {
    /// There must be no force at all.
    pub(super) no_force: bool,
    /// And this tick is the first of the ramp: touch begins anew.
    pub(super) begins: bool,
    /// Metres of workspace under flat ground; `None` where nothing can be told.
    pub(super) depth: Option<f64>,
    /// The hand has been in the ground since the proxy was placed.
    pub(super) began_inside: bool,
}

/// Holds a session to its promises.
pub(super) struct Judge {
    promised: Promised,
    last: [f64; 3],
    /// Seconds since there had to be no force.
    since_none: f64,
    pub(super) broken: Vec<String>,
    /// N.
    pub(super) force_after_fault: f64,
    /// N, since it was taken.
    pub(super) largest: f64,
}

impl Judge {
    pub(super) fn new(promised: Promised) -> Judge {
        Judge {
            promised,
            last: [0.0; 3],
            since_none: 0.0,
            broken: Vec::new(),
            force_after_fault: 0.0,
            largest: 0.0,
        }
    }

    /// Judges what the device was told in a tick; the last of it is what acts.
    pub(super) fn tick(&mut self, writes: &[([f64; 3], f64)], known: &Known) {
        for (force, dt) in writes {
            self.judge_force(*force, *dt);
        }
        let Some((acting, dt)) = writes.last() else {
            self.breaks("a tick ended without a force".to_owned());
            return;
        };
        let acting = size(*acting);
        self.largest = self.largest.max(acting);
        if known.no_force {
            self.since_none = if known.begins { *dt } else { 0.0 };
            // A force that is no number is no zero either.
            self.force_after_fault =
                if acting.is_finite() { self.force_after_fault.max(acting) } else { f64::INFINITY };
            self.demand(acting == 0.0, || format!("{acting} N instead of none"));
        }
        if known.began_inside {
            self.demand(acting == 0.0, || format!("{acting} N for a hand that began inside"));
        }
        if let Some(depth) = known.depth {
            let most = self.promised.stiffness * depth.max(0.0) * (1.0 + ROUNDING) + ROUNDING;
            self.demand(acting <= most, || format!("{acting} N at {depth} m: too stiff"));
        }
    }

    fn judge_force(&mut self, force: [f64; 3], dt: f64) {
        let newtons = size(force);
        self.demand(newtons.is_finite(), || format!("{force:?} was sent"));
        let room = 1.0 + ROUNDING;
        let limit = self.promised.force * room;
        self.demand(newtons <= limit, || format!("{newtons} N above the limit of {limit}"));
        let step = size(std::array::from_fn(|axis| force[axis] - self.last[axis]));
        let slew = self.promised.slew * dt * room + ROUNDING;
        let is_slow = newtons == 0.0 || step <= slew;
        self.demand(is_slow, || format!("a step of {step} N, at most {slew}"));
        self.since_none += dt;
        let ramp = limit * self.since_none / RAMP + ROUNDING;
        self.demand(newtons <= ramp, || format!("{newtons} N so soon, at most {ramp}"));
        self.last = force;
    }

    pub(super) fn demand(&mut self, is_kept: bool, words: impl FnOnce() -> String) {
        if !is_kept {
            self.breaks(words());
        }
    }

    pub(super) fn breaks(&mut self, words: String) {
        // The first ones say it all.
        if self.broken.len() < 3 {
            self.broken.push(words);
        }
    }
}

fn size([x, y, z]: [f64; 3]) -> f64 {
    x.hypot(y).hypot(z)
}
