//! Counts and times of a session.

use crate::deadlines::PERIOD_NS;
use crate::{Distribution, Trips};

/// Counts since the session was made.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Totals {
    /// Ticks done.
    pub ticks: u64,
    /// Deadlines that passed while the thread was late; they are skipped, never caught up.
    pub missed_ticks: u64,
    /// Ticks with the proxy on the surface.
    pub contact_ticks: u64,
    /// Vertices visited by constrained minimisation.
    pub vertices: u64,
    /// Triangles that the surface walk looked at.
    pub faces: u64,
    /// Free-space minimisations begun.
    pub collision_tests: u64,
    /// Grid cells that the collision tests went through.
    pub cells: u64,
    /// Far edges crossed.
    pub far_edge_crossings: u64,
    /// Far edges met again.
    pub far_edge_loops: u64,
    /// Cycles that the contact model ended.
    pub cycles_ended: u64,
    /// Updates that ended with steps left over.
    pub unfinished: u64,
    /// Ticks in which the spring had given the hand more energy than it took, as the passivity
    /// observer counts it.
    pub active_ticks: u64,
    /// Ticks that found the ring full; they are lost to drains.
    pub dropped: u64,
    /// Cells that the goal travelled over the ground, summed over the ticks.
    pub goal_cells: f64,
    /// Changes of mode.
    pub mode_changes: u64,
    /// How often each stage of the safety chain has acted.
    pub trips: Trips,
}

/// Counts and times since the session was made.
#[derive(Clone, Debug)]
pub struct Statistics {
    /// The counts, all of the same tick.
    pub totals: Totals,
    /// Nanoseconds from the device's read to its write.
    pub update_times: Distribution,
    /// Nanoseconds from deadline to wake-up, live ticks only.
    pub lateness: Distribution,
    /// Nanoseconds from wake-up to sleep, live ticks only: everything that a tick takes.
    pub busy_times: Distribution,
}

impl Statistics {
    /// Microseconds from the device's read to its write; 0 before the first tick.
    pub fn update_us(&self, quantile: f64) -> f64 {
        microseconds(&self.update_times, quantile)
    }

    /// The share of a millisecond that live ticks take, mean: the servo's load (the paper's HLOAD
    /// measures it on its device's servo). 0 before the first live tick.
    pub fn mean_load(&self) -> f64 {
        self.busy_times.mean().unwrap_or(0.0) / PERIOD_NS as f64
    }

    /// The share of a millisecond that a share of `quantile` of the live ticks does not exceed.
    pub fn load(&self, quantile: f64) -> f64 {
        self.busy_times.quantile(quantile).unwrap_or(0) as f64 / PERIOD_NS as f64
    }

    /// Microseconds from deadline to wake-up; 0 before the first live tick.
    pub fn late_us(&self, quantile: f64) -> f64 {
        microseconds(&self.lateness, quantile)
    }
}

fn microseconds(distribution: &Distribution, quantile: f64) -> f64 {
    let nanoseconds = distribution.quantile(quantile).unwrap_or(0);
    nanoseconds as f64 / 1000.0
}
