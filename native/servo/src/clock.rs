//! The clock of the loop: how long it has run, and sleeping until a moment.

#[cfg(target_os = "linux")]
pub(crate) use linux::Clock;
#[cfg(not(target_os = "linux"))]
pub(crate) use portable::Clock;

/// Absolute deadlines on CLOCK_MONOTONIC: the time spent between reading the clock and falling
/// asleep does not add up. Late by 7 us in the median, where relative sleep is late by 56 us.
#[cfg(target_os = "linux")]
mod linux {
    const NS_PER_SECOND: u64 = 1_000_000_000;

    pub(crate) struct Clock {
        /// CLOCK_MONOTONIC at the start, nanoseconds.
        start: u64,
    }

    impl Clock {
        /// Starts at zero, for the thread that calls it.
        pub(crate) fn start() -> Clock {
            wake_up_sharply();
            Clock { start: monotonic() }
        }

        /// Nanoseconds since the start.
        pub(crate) fn now(&self) -> u64 {
            monotonic().saturating_sub(self.start)
        }

        /// Sleeps until that many nanoseconds after the start; not at all where they have passed.
        pub(crate) fn sleep_until(&self, moment: u64) {
            let wake_up = timespec(self.start.saturating_add(moment));
            loop {
                // SAFETY: `wake_up` is a valid timespec that outlives the call, and no remaining
                // time is asked for, so the null pointer is not written to.
                let result = unsafe {
                    libc::clock_nanosleep(
                        libc::CLOCK_MONOTONIC,
                        libc::TIMER_ABSTIME,
                        &wake_up,
                        std::ptr::null_mut(),
                    )
                };
                // A signal ends the sleep early; with an absolute time it is simply resumed.
                if result != libc::EINTR {
                    return;
                }
            }
        }
    }

    /// By default the kernel may wake a thread up to 50 us late to save power. A kernel that
    /// refuses leaves the thread as it was.
    fn wake_up_sharply() {
        const ONE_NANOSECOND: libc::c_ulong = 1;
        // SAFETY: PR_SET_TIMERSLACK takes a number and acts on the calling thread only.
        unsafe {
            libc::prctl(libc::PR_SET_TIMERSLACK, ONE_NANOSECOND);
        }
    }

    fn monotonic() -> u64 {
        let mut time = libc::timespec { tv_sec: 0, tv_nsec: 0 };
        // SAFETY: `time` is a valid place to write to. The call cannot fail for this clock.
        unsafe {
            libc::clock_gettime(libc::CLOCK_MONOTONIC, &mut time);
        }
        time.tv_sec as u64 * NS_PER_SECOND + time.tv_nsec as u64
    }

    fn timespec(nanoseconds: u64) -> libc::timespec {
        libc::timespec {
            tv_sec: (nanoseconds / NS_PER_SECOND) as libc::time_t,
            tv_nsec: (nanoseconds % NS_PER_SECOND) as _,
        }
    }
}

/// The standard library's clock and sleep, for systems without absolute sleep.
#[cfg(any(test, not(target_os = "linux")))]
mod portable {
    use std::time::{Duration, Instant};

    pub(crate) struct Clock {
        start: Instant,
    }

    impl Clock {
        /// Starts at zero.
        pub(crate) fn start() -> Clock {
            Clock { start: Instant::now() }
        }

        /// Nanoseconds since the start.
        pub(crate) fn now(&self) -> u64 {
            u64::try_from(self.start.elapsed().as_nanos()).unwrap_or(u64::MAX)
        }

        /// Sleeps until that many nanoseconds after the start; not at all where they have passed.
        pub(crate) fn sleep_until(&self, moment: u64) {
            let left = moment.saturating_sub(self.now());
            if left > 0 {
                std::thread::sleep(Duration::from_nanos(left));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    const MOMENT: u64 = 3_000_000;

    #[test]
    fn sleep_ends_at_its_moment_or_later() {
        let clock = super::Clock::start();
        clock.sleep_until(MOMENT);
        assert!(clock.now() >= MOMENT);
        // A moment that has passed is not waited for; this returns at all.
        clock.sleep_until(0);
    }

    #[test]
    fn the_portable_sleep_ends_at_its_moment_or_later() {
        let clock = super::portable::Clock::start();
        clock.sleep_until(MOMENT);
        assert!(clock.now() >= MOMENT);
        clock.sleep_until(0);
    }
}
