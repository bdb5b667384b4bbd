//! The hand's speed: a handle that slipped, or a position that jumped.

use devices::NOMINAL_PERIOD;

/// Seconds below the limit before the force begins to come back.
pub(crate) const CALM: f64 = 0.05;

/// How a hand moved since it was seen last.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Step {
    /// Since it was seen last.
    pub(crate) seconds: f64,
    pub(crate) too_fast: bool,
}

/// Where the hand was.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SpeedWatch {
    /// Metres a second; infinite where nothing limits it.
    max_speed: f64,
    last: Option<[f64; 3]>,
    /// Seconds before this tick in which the hand was not seen.
    unseen: f64,
}

impl SpeedWatch {
    pub(crate) fn new(max_speed: f64) -> SpeedWatch {
        SpeedWatch { max_speed, last: None, unseen: 0.0 }
    }

    /// The hand is at `position`, `dt` seconds after the last tick.
    pub(crate) fn see(&mut self, position: [f64; 3], dt: f64) -> Step {
        // A tick that follows a late one closely has less time than its device's motion may have had.
        let seconds = (self.unseen + dt).max(NOMINAL_PERIOD);
        self.unseen = 0.0;
        let Some(last) = self.last.replace(position) else {
            return Step { seconds: dt, too_fast: false };
        };
        let [x, y, z] = std::array::from_fn(|axis| position[axis] - last[axis]);
        let metres: f64 = f64::hypot(f64::hypot(x, y), z);
        Step { seconds, too_fast: metres > self.max_speed * seconds }
    }

    /// The hand was not seen in this tick.
    pub(crate) fn lose(&mut self, dt: f64) {
        self.unseen += dt;
    }

    /// The next hand may be anywhere.
    pub(crate) fn forget(&mut self) {
        self.last = None;
        self.unseen = 0.0;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TICK: f64 = 0.001;

    #[test]
    fn a_hand_is_too_fast_when_it_moves_further_than_its_limit_lets_it() {
        let mut watch = SpeedWatch::new(3.0);
        assert!(!watch.see([5.0; 3], TICK).too_fast, "it was nowhere before");
        assert!(!watch.see([5.0, 5.0, 5.0029], TICK).too_fast);
        assert!(watch.see([5.0, 5.0, 5.006], TICK).too_fast);
        assert!(!watch.see([5.0, 5.0, 5.008], TICK).too_fast);
    }

    #[test]
    fn time_in_which_it_was_not_seen_is_time_to_move_in() {
        let mut watch = SpeedWatch::new(3.0);
        watch.see([0.0; 3], TICK);
        watch.lose(TICK);
        let step = watch.see([0.005, 0.0, 0.0], TICK);
        assert!(!step.too_fast);
        assert_eq!(step.seconds, 2.0 * TICK);
    }

    #[test]
    fn where_nothing_limits_it_no_jump_is_too_far() {
        let mut watch = SpeedWatch::new(f64::INFINITY);
        watch.see([-f64::MAX; 3], TICK);
        assert!(!watch.see([f64::MAX; 3], TICK).too_fast);
    }
}
