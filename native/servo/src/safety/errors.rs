//! Errors of the device: which ones touch survives.

use devices::DeviceError;

use crate::Fault;

/// Ticks in a row that a device may fail before touch ends.
///
/// Ours: a packet that is late or garbled is an accident, two in a row happen on a busy bus, and
/// after three milliseconds without a hand there is nothing left to go on from.
const IN_A_ROW: u32 = 3;

/// Failures within [`SPAN`] that end touch: with every hundredth packet lost the force would never
/// be whole, for each loss takes it away and it comes back over 50 ms.
pub(crate) const TOO_MANY: usize = 10;

/// Seconds.
const SPAN: f64 = 1.0;

/// Counts failures.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Tolerance {
    in_a_row: u32,
    failed_in_this_tick: bool,
    /// When the device failed the last times, seconds; a ring.
    times: [f64; TOO_MANY],
    oldest: usize,
}

impl Default for Tolerance {
    fn default() -> Tolerance {
        Tolerance {
            in_a_row: 0,
            failed_in_this_tick: false,
            times: [f64::NEG_INFINITY; TOO_MANY],
            oldest: 0,
        }
    }
}

impl Tolerance {
    pub(crate) fn begin_tick(&mut self) {
        if !self.failed_in_this_tick {
            self.in_a_row = 0;
        }
        self.failed_in_this_tick = false;
    }

    /// Forgives an error at `time` seconds, or says that it was one too many.
    ///
    /// A device that is gone or denied is not waited for. A tick fails once, whether in its read,
    /// its write or both.
    pub(crate) fn forgive(&mut self, error: DeviceError, time: f64) -> Result<(), Fault> {
        if matches!(error, DeviceError::Gone(_) | DeviceError::Denied(_)) {
            return Err(Fault::Device(error));
        }
        if self.failed_in_this_tick {
            return Ok(());
        }
        self.failed_in_this_tick = true;
        self.in_a_row += 1;
        if self.in_a_row >= IN_A_ROW {
            return Err(Fault::Device(error));
        }
        self.times[self.oldest] = time;
        self.oldest = (self.oldest + 1) % TOO_MANY;
        // What is the oldest now is the first of the last ten.
        if time - self.times[self.oldest] <= SPAN {
            return Err(Fault::Unreliable(error));
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn timeout() -> DeviceError {
        DeviceError::Timeout("no packet".into())
    }

    /// Ticks of a millisecond in which the device fails where it is told, until touch ends.
    fn end(fails: impl Fn(u32) -> bool) -> Option<(u32, Fault)> {
        let mut tolerance = Tolerance::default();
        (1..100_000).find_map(|tick| {
            tolerance.begin_tick();
            let time = f64::from(tick) / 1000.0;
            let fault = fails(tick).then(|| tolerance.forgive(timeout(), time))?.err()?;
            Some((tick, fault))
        })
    }

    #[test]
    fn one_failure_and_two_in_a_row_are_forgiven_and_three_are_not() {
        assert_eq!(end(|tick| tick == 50), None);
        assert_eq!(end(|tick| (50..52).contains(&tick)), None);
        assert_eq!(end(|tick| tick >= 50), Some((52, Fault::Device(timeout()))));
    }

    #[test]
    fn ten_failures_within_a_second_are_too_many() {
        assert_eq!(end(|tick| tick % 10 == 0), Some((100, Fault::Unreliable(timeout()))));
        assert_eq!(end(|tick| tick % 112 == 0), None, "ten of them last longer than a second");
    }

    #[test]
    fn a_device_that_is_gone_is_not_waited_for() {
        for error in [DeviceError::Gone("unplugged".into()), DeviceError::Denied("no".into())] {
            let mut tolerance = Tolerance::default();
            assert_eq!(tolerance.forgive(error.clone(), 0.0), Err(Fault::Device(error)));
        }
    }

    #[test]
    fn a_tick_whose_read_and_write_fail_has_failed_once() {
        let mut tolerance = Tolerance::default();
        for tick in 0..2 {
            tolerance.begin_tick();
            for _ in 0..5 {
                assert_eq!(tolerance.forgive(timeout(), f64::from(tick)), Ok(()));
            }
        }
        tolerance.begin_tick();
        assert!(tolerance.forgive(timeout(), 2.0).is_err());
    }
}
