//! A bare loop: the servo's clock, deadlines and priority with nothing in its ticks. What it is late
//! by is the system's doing; what a servo is late by beyond that is its own.

use crate::clock::Clock;
use crate::deadlines::{after_tick, at_wake_up, moment_of};
use crate::priority::Promotion;
use crate::{Distribution, Histogram};

/// What a bare loop met.
#[derive(Clone, Debug, Default)]
pub struct Bare {
    /// Nanoseconds from deadline to wake-up.
    pub lateness: Distribution,
    /// Deadlines that passed without a tick.
    pub missed: u64,
}

impl Bare {
    /// Ticks done.
    pub fn ticks(&self) -> u64 {
        self.lateness.count()
    }
}

impl std::ops::AddAssign for Bare {
    fn add_assign(&mut self, other: Bare) {
        self.lateness += other.lateness;
        self.missed += other.missed;
    }
}

/// Runs until so many deadlines have passed, on a thread of its own.
///
/// # Panics
/// Where the system gives no thread.
pub fn bare_loop(deadlines: u64, wants_real_time: bool) -> Bare {
    let loop_ = move || {
        let (promotion, _) = if wants_real_time { Promotion::ask() } else { Promotion::none() };
        let lateness = Histogram::new();
        let missed = run(deadlines, &lateness);
        drop(promotion);
        Bare { lateness: lateness.distribution(), missed }
    };
    std::thread::spawn(loop_).join().expect("a bare loop does not panic")
}

fn run(deadlines: u64, lateness: &Histogram) -> u64 {
    let clock = Clock::start();
    let (mut deadline, mut missed) = (1, 0);
    while deadline <= deadlines {
        clock.sleep_until(moment_of(deadline));
        let now = clock.now();
        lateness.record(now.saturating_sub(moment_of(deadline)));
        let due = at_wake_up(deadline, now);
        let next = after_tick(due.deadline, clock.now());
        missed += due.missed + next.missed;
        deadline = next.deadline;
    }
    missed
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_deadline_is_met_or_missed() {
        let mut bare = bare_loop(20, false);
        assert!(bare.ticks() + bare.missed >= 20);
        let ticks = bare.ticks();
        bare += bare.clone();
        assert_eq!(bare.ticks(), 2 * ticks);
    }
}
