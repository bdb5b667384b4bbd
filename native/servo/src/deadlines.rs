//! Which deadline a tick belongs to, and which ones are missed.
//!
//! Deadline n lies n periods after the loop began. A tick that is late does not make the next ones
//! hurry: deadlines that have passed are skipped, so the hand never gets a burst of ticks.

/// Nanoseconds between two deadlines.
pub(crate) const PERIOD_NS: u64 = 1_000_000;

/// What to do about a deadline.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Next {
    /// The deadline that the tick belongs to.
    pub(crate) deadline: u64,
    /// How many before it passed without a tick.
    pub(crate) missed: u64,
}

/// Nanoseconds from the beginning of the loop to a deadline.
pub(crate) fn moment_of(deadline: u64) -> u64 {
    deadline.saturating_mul(PERIOD_NS)
}

/// The thread slept until `deadline` and woke at `now` nanoseconds: the tick belongs to the newest
/// deadline that has come, those before it are missed.
pub(crate) fn at_wake_up(deadline: u64, now: u64) -> Next {
    let newest = (now / PERIOD_NS).max(deadline);
    Next { deadline: newest, missed: newest - deadline }
}

/// The tick of `deadline` ended at `now` nanoseconds: the next tick waits for the first deadline
/// still to come, those between are missed.
pub(crate) fn after_tick(deadline: u64, now: u64) -> Next {
    let coming = (now / PERIOD_NS).max(deadline) + 1;
    Next { deadline: coming, missed: coming - deadline - 1 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn a_punctual_tick_misses_nothing() {
        assert_eq!(at_wake_up(7, 7_000_050), Next { deadline: 7, missed: 0 });
        assert_eq!(after_tick(7, 7_400_000), Next { deadline: 8, missed: 0 });
    }

    #[test]
    fn a_wake_up_before_its_deadline_is_taken_as_on_time() {
        assert_eq!(at_wake_up(7, 6_999_999), Next { deadline: 7, missed: 0 });
        assert_eq!(after_tick(7, 6_999_999), Next { deadline: 8, missed: 0 });
    }

    #[test]
    fn a_tick_of_five_milliseconds_misses_five_deadlines() {
        assert_eq!(after_tick(10, 15_020_000), Next { deadline: 16, missed: 5 });
    }

    #[test]
    fn a_late_wake_up_serves_the_newest_deadline() {
        assert_eq!(at_wake_up(10, 10_900_000), Next { deadline: 10, missed: 0 });
        assert_eq!(at_wake_up(10, 12_300_000), Next { deadline: 12, missed: 2 });
    }

    proptest! {
        #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

        #[test]
        fn every_deadline_is_served_or_missed_and_none_twice(
            delays in prop::collection::vec((0u64..4_000_000, 0u64..6_000_000), 1..200),
        ) {
            let (mut deadline, mut now) = (1, 0u64);
            let (mut served, mut missed) = (Vec::new(), 0);
            for (late, update) in delays {
                now = now.max(moment_of(deadline)) + late;
                let due = at_wake_up(deadline, now);
                served.push(due.deadline);
                now += update;
                let next = after_tick(due.deadline, now);
                missed += due.missed + next.missed;
                deadline = next.deadline;
                // The next deadline has not come yet: the thread sleeps, so there is no burst.
                prop_assert!(moment_of(deadline) > now);
            }
            prop_assert!(served.windows(2).all(|pair| pair[0] < pair[1]));
            prop_assert_eq!(served.len() as u64 + missed, deadline - 1);
        }
    }
}
