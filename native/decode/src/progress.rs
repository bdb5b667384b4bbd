//! How far a long work has come, and whether anybody still wants it.

use crate::error::DecodeError;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};

/// Shared between the thread that works and the one that shows; all calls may come from any thread.
#[derive(Debug, Default)]
pub struct Progress {
    share: AtomicU64,
    cancelled: AtomicBool,
}

impl Progress {
    /// Nothing done yet.
    pub fn new() -> Self {
        Self::default()
    }

    /// The share that is done, from 0 to 1.
    pub fn share(&self) -> f64 {
        f64::from_bits(self.share.load(Ordering::Relaxed))
    }

    /// Asks the work to end as soon as it can.
    pub fn cancel(&self) {
        self.cancelled.store(true, Ordering::Relaxed);
    }

    /// Whether it was asked to end.
    pub fn is_cancelled(&self) -> bool {
        self.cancelled.load(Ordering::Relaxed)
    }

    /// Fails when the work was asked to end; tells nothing.
    pub fn check(&self) -> Result<(), DecodeError> {
        if self.is_cancelled() { Err(DecodeError::Cancelled) } else { Ok(()) }
    }

    /// Tells that `done` of `all` steps are done; fails when the work was asked to end.
    pub fn step(&self, done: u64, all: u64) -> Result<(), DecodeError> {
        self.check()?;
        let share = if all == 0 { 1.0 } else { (done as f64 / all as f64).min(1.0) };
        self.share.store(share.to_bits(), Ordering::Relaxed);
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn share_is_told_and_a_cancelled_work_ends() {
        let progress = Progress::new();
        assert_eq!(progress.share(), 0.0);
        progress.step(1, 4).unwrap();
        assert_eq!(progress.share(), 0.25);
        progress.step(0, 0).unwrap();
        assert_eq!(progress.share(), 1.0);
        progress.cancel();
        assert!(matches!(progress.step(1, 4), Err(DecodeError::Cancelled)));
    }
}
