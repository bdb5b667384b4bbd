//! The host's watchdog: no force while nobody looks at what the hand does.

use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

/// Seconds of silence after which a host that draws the scene counts as stalled.
///
/// A timer that runs 60 times a second has missed six turns by then, and what the person sees is
/// no longer what they feel.
pub const STALE_AFTER: f64 = 0.1;

/// Seconds after the host is back before the force begins to come back.
pub(crate) const CALM: f64 = 0.01;

/// Counts the host's calls.
#[derive(Debug, Default)]
pub struct Heartbeat(AtomicU64);

impl Heartbeat {
    /// The host is alive.
    pub fn beat(&self) {
        // Relaxed: the count stands for itself, nothing else is read through it.
        self.0.fetch_add(1, Ordering::Relaxed);
    }

    fn beats(&self) -> u64 {
        self.0.load(Ordering::Relaxed)
    }
}

/// Watches a heartbeat, or nothing.
#[derive(Debug, Default)]
pub(crate) struct HostWatch {
    watched: Option<Watched>,
}

#[derive(Debug)]
struct Watched {
    heartbeat: Arc<Heartbeat>,
    /// Seconds.
    stale_after: f64,
    /// Beats at the last tick.
    seen: u64,
    /// Seconds since the last new one.
    silent: f64,
}

impl HostWatch {
    /// Watches a heartbeat that may stand still for so many seconds.
    pub(crate) fn new(heartbeat: Option<(Arc<Heartbeat>, f64)>) -> HostWatch {
        let watched = heartbeat.map(|(heartbeat, stale_after)| {
            let seen = heartbeat.beats();
            Watched { heartbeat, stale_after, seen, silent: 0.0 }
        });
        HostWatch { watched }
    }

    /// Begins to count anew.
    pub(crate) fn begin(&mut self) {
        if let Some(watched) = &mut self.watched {
            watched.silent = 0.0;
        }
    }

    /// Whether the host has been silent for too long, `dt` seconds after it was asked last.
    pub(crate) fn is_stale(&mut self, dt: f64) -> bool {
        let Some(watched) = &mut self.watched else { return false };
        let beats = watched.heartbeat.beats();
        watched.silent = if beats == watched.seen { watched.silent + dt } else { 0.0 };
        watched.seen = beats;
        watched.silent > watched.stale_after
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_host_is_stale_when_it_was_silent_for_longer_than_allowed() {
        let heartbeat = Arc::new(Heartbeat::default());
        let mut watch = HostWatch::new(Some((Arc::clone(&heartbeat), 0.5)));
        assert!(!watch.is_stale(0.25) && !watch.is_stale(0.25) && watch.is_stale(0.25));
        heartbeat.beat();
        assert!(!watch.is_stale(0.25));
        assert!(watch.is_stale(10.0));
        watch.begin();
        assert!(!watch.is_stale(0.25));
    }

    #[test]
    fn without_a_heartbeat_to_watch_nothing_is_stale() {
        assert!(!HostWatch::default().is_stale(1e9));
    }
}
