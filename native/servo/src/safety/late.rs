//! The servo's own watchdog: no force while ticks are missed.

use devices::NOMINAL_PERIOD;

/// Ticks missed in a row that take the force away. One is an everyday jitter; with two the force
/// that acts answers where the hand was three milliseconds ago, which costs six sevenths of the
/// stable stiffness (see `stable_stiffness` in `limits`).
const MISSED: f64 = 2.0;

/// Seconds of punctual ticks before the force begins to come back.
pub(crate) const CALM: f64 = 0.01;

/// Whether a tick `dt` seconds after the last one has missed too many before it.
pub(crate) fn is_late(dt: f64) -> bool {
    // Half a tick of room for rounding.
    dt > (MISSED + 0.5) * NOMINAL_PERIOD
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_missed_tick_is_let_pass_and_two_are_not() {
        assert!(!is_late(NOMINAL_PERIOD));
        assert!(!is_late(2.0 * NOMINAL_PERIOD));
        assert!(is_late(3.0 * NOMINAL_PERIOD));
        assert!(is_late(10.0));
    }
}
