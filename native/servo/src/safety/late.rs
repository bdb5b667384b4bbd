//! The servo's own watchdog: no force while ticks are missed.

/// Ticks missed in a row that take the force away. One is an everyday jitter; with two the force
/// that acts answers where the hand was three milliseconds ago, which costs six sevenths of the
/// stable stiffness (see `stable_stiffness` in `limits`).
const MISSED: u64 = 2;

/// Seconds of punctual ticks before the force begins to come back.
pub(crate) const CALM: f64 = 0.01;

/// Deadlines that passed without a tick since the last one.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct LateWatch {
    missed: u64,
}

impl LateWatch {
    /// So many more passed.
    pub(crate) fn miss(&mut self, ticks: u64) {
        self.missed = self.missed.saturating_add(ticks);
    }

    /// Whether the tick that begins now has missed too many before it.
    pub(crate) fn is_late(&mut self) -> bool {
        std::mem::take(&mut self.missed) >= MISSED
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_missed_tick_is_let_pass_and_two_in_a_row_are_not() {
        let mut watch = LateWatch::default();
        assert!(!watch.is_late());
        watch.miss(1);
        assert!(!watch.is_late());
        watch.miss(1);
        watch.miss(1);
        assert!(watch.is_late(), "both between the same two ticks");
        assert!(!watch.is_late());
    }
}
