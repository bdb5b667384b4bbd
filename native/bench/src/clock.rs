//! A clock fine enough for one update of tens of nanoseconds.
//!
//! On x86-64 the processor's time-stamp counter, fenced so that nothing before or after leaks into
//! the measured time; elsewhere the system's monotonic clock.

use std::time::{Duration, Instant};

/// What [`start`] and [`stop`] read.
pub const NAME: &str = if cfg!(target_arch = "x86_64") { "rdtscp" } else { "monotonic clock" };

/// Ticks at the beginning of a measured stretch.
#[inline(always)]
pub fn start() -> u64 {
    #[cfg(target_arch = "x86_64")]
    {
        use std::arch::x86_64::{_mm_lfence, _rdtsc};
        // SAFETY: every x86-64 processor has both instructions; they touch no memory.
        unsafe {
            _mm_lfence();
            let ticks = _rdtsc();
            _mm_lfence();
            ticks
        }
    }
    #[cfg(not(target_arch = "x86_64"))]
    monotonic()
}

/// Ticks at its end.
#[inline(always)]
pub fn stop() -> u64 {
    #[cfg(target_arch = "x86_64")]
    {
        use std::arch::x86_64::{__rdtscp, _mm_lfence};
        let mut processor = 0;
        // SAFETY: as above; the processor's number goes into a variable of our own.
        unsafe {
            let ticks = __rdtscp(&mut processor);
            _mm_lfence();
            ticks
        }
    }
    #[cfg(not(target_arch = "x86_64"))]
    monotonic()
}

/// Ticks in a nanosecond, measured against the system's clock.
pub fn ticks_per_nanosecond() -> f64 {
    let (began, first) = (Instant::now(), start());
    while began.elapsed() < Duration::from_millis(100) {
        std::hint::spin_loop();
    }
    let ticks = stop() - first;
    ticks as f64 / began.elapsed().as_nanos() as f64
}

#[cfg(not(target_arch = "x86_64"))]
fn monotonic() -> u64 {
    use std::sync::LazyLock;
    static BEGAN: LazyLock<Instant> = LazyLock::new(Instant::now);
    BEGAN.elapsed().as_nanos() as u64
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_runs_forward_at_a_known_rate() {
        let rate = ticks_per_nanosecond();
        assert!(rate.is_finite() && rate > 0.0);
        let first = start();
        assert!(stop() >= first);
    }
}
