//! A take.

use crate::{Header, Tick, Ticks};

/// Recorded touch.
#[derive(Clone, Debug, Default)]
pub struct Take {
    /// What was known when it began.
    pub header: Header,
    /// What was felt.
    pub ticks: Ticks,
    /// Ticks that the servo did meanwhile, and that were lost to the take.
    pub dropped: u64,
    /// The number of the tick that is to come.
    expected: Option<u64>,
}

impl Take {
    /// A take without ticks. `expected` is the number of the first one; where it is not known, none
    /// can be missing before the first.
    pub fn new(header: Header, expected: Option<u64>) -> Take {
        Take { header, ticks: Ticks::default(), dropped: 0, expected }
    }

    /// Of ticks that were recorded before.
    pub(crate) fn of(header: Header, ticks: Ticks, dropped: u64) -> Take {
        Take { header, ticks, dropped, expected: None }
    }

    /// Appends a tick. Those that are missing before it are counted as lost; so is this one where
    /// there is no memory left.
    pub fn push(&mut self, tick: Tick) {
        self.miss_until(tick.number);
        self.dropped += u64::from(self.ticks.push(tick).is_err());
        self.expected = Some(tick.number + 1);
    }

    /// All ticks before `number` were done: those that have not come are lost.
    pub fn miss_until(&mut self, number: u64) {
        if let Some(expected) = self.expected {
            self.dropped += number.saturating_sub(expected);
            self.expected = Some(expected.max(number));
        }
    }

    /// Seconds from the first tick to the last; 0 where there are none.
    pub fn seconds(&self) -> f64 {
        match (self.ticks.first(), self.ticks.last()) {
            (Some(first), Some(last)) => last.time - first.time,
            _ => 0.0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn tick(number: u64) -> Tick {
        Tick { number, time: number as f64 / 1000.0, ..Tick::default() }
    }

    #[test]
    fn ticks_that_are_missing_are_counted() {
        let mut take = Take::new(Header::default(), Some(5));
        for number in [5, 6, 9, 10] {
            take.push(tick(number));
        }
        assert_eq!((take.ticks.len(), take.dropped), (4, 2));
        take.miss_until(11);
        assert_eq!(take.dropped, 2);
        take.miss_until(14);
        take.miss_until(12);
        take.push(tick(14));
        assert_eq!(take.dropped, 5);
        assert!((take.seconds() - 0.009).abs() < 1e-12);
    }

    #[test]
    fn nothing_is_missing_before_a_first_tick_of_unknown_number() {
        let mut take = Take::new(Header::default(), None);
        take.miss_until(50);
        take.push(tick(99));
        assert_eq!((take.dropped, take.seconds()), (0, 0.0));
    }
}
