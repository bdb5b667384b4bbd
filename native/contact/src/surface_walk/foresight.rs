//! Asking for samples an update before they are needed.
//!
//! A hand goes on as it went: where it comes to in the next update is known in this one, a
//! millisecond early. So the samples under its next way are asked for now, and have come when they are
//! needed. Only where the hand did what was not foreseen are they waited for, all together.

use super::search::Search;
use surface::{GridPoint, Sample};

/// Rows beside what was foreseen that the samples asked for still cover: those of the cells around.
const COVERED: f64 = 1.0;

/// Rows in an update up to which the hand is slow: it meets a new cache line or two, and those an
/// update later.
const SLOW: f64 = 2.0;

/// What the hand did in the update before.
#[derive(Clone, Copy, Default)]
pub(super) struct Foresight {
    /// Rows that it went south.
    rows: f64,
}

impl Foresight {
    /// Asks for what the next update needs, and for what this one needs where it was not foreseen:
    /// the samples from `proxy` to the goal, which came from `before`.
    #[inline(always)]
    pub(super) fn look<S: Sample>(
        &mut self,
        search: &Search<S>,
        proxy: &GridPoint,
        before: &GridPoint,
    ) {
        let motion = search.way_from(before);
        let surprise = motion[1] - std::mem::replace(&mut self.rows, motion[1]);
        if motion[1].abs() < SLOW && surprise.abs() < SLOW {
            return search.field.prefetch_beside(&search.target, motion.map(|cells| 2.0 * cells));
        }
        self.look_far(search, proxy, motion, surprise);
    }

    #[inline(never)]
    fn look_far<S: Sample>(
        &self,
        search: &Search<S>,
        proxy: &GridPoint,
        motion: [f64; 2],
        surprise: f64,
    ) {
        if surprise.abs() > COVERED {
            search.field.prefetch_way(proxy, search.way_from(proxy));
        }
        search.field.prefetch_way(&search.target, motion);
    }
}
