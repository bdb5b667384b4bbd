//! Times counted in buckets whose width grows with the time.

use std::sync::atomic::{AtomicU64, Ordering};

/// The longest time told from longer ones: 10 s.
const LONGEST_NS: u64 = 10_000_000_000;

/// Each power of two is split into 2^4 buckets: a bucket is at most 1/16 (6.25%) as wide as the
/// times in it.
const SPLIT_BITS: u32 = 4;
const SPLIT: u64 = 1 << SPLIT_BITS;

const BUCKETS: usize = bucket_of(LONGEST_NS) + 1;

/// The bucket of a time. Times below 2 * `SPLIT` nanoseconds have a bucket each.
const fn bucket_of(nanoseconds: u64) -> usize {
    if nanoseconds < SPLIT {
        return nanoseconds as usize;
    }
    let shift = nanoseconds.ilog2() - SPLIT_BITS;
    (shift as u64 * SPLIT + (nanoseconds >> shift)) as usize
}

/// The longest time in a bucket.
fn longest_in(bucket: usize) -> u64 {
    let bucket = bucket as u64;
    if bucket < SPLIT {
        return bucket;
    }
    let shift = bucket / SPLIT - 1;
    let leading = bucket - shift * SPLIT;
    (((leading + 1) << shift) - 1).min(LONGEST_NS)
}

/// Counts of times from 1 ns to 10 s, written by one thread while others read.
pub struct Histogram {
    counts: [AtomicU64; BUCKETS],
    /// Nanoseconds; at a millisecond each it holds 500 years.
    sum: AtomicU64,
}

impl Default for Histogram {
    fn default() -> Self {
        Histogram::new()
    }
}

impl Histogram {
    /// An empty one.
    pub fn new() -> Histogram {
        let counts = std::array::from_fn(|_| AtomicU64::new(0));
        Histogram { counts, sum: AtomicU64::new(0) }
    }

    /// Counts one time. Wait-free.
    pub fn record(&self, nanoseconds: u64) {
        let nanoseconds = nanoseconds.min(LONGEST_NS);
        // Relaxed: each count stands for itself, nothing else is read through it.
        self.counts[bucket_of(nanoseconds)].fetch_add(1, Ordering::Relaxed);
        self.sum.fetch_add(nanoseconds, Ordering::Relaxed);
    }

    /// The counts of now.
    pub fn distribution(&self) -> Distribution {
        let counts = self.counts.iter().map(|count| count.load(Ordering::Relaxed)).collect();
        Distribution { counts, sum: self.sum.load(Ordering::Relaxed) }
    }
}

/// A copy of a histogram at one moment.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Distribution {
    /// Empty where nothing was ever counted.
    counts: Box<[u64]>,
    /// Nanoseconds.
    sum: u64,
}

impl std::ops::AddAssign for Distribution {
    fn add_assign(&mut self, other: Distribution) {
        if self.counts.is_empty() {
            self.counts = other.counts;
        } else {
            for (count, more) in self.counts.iter_mut().zip(&other.counts) {
                *count += more;
            }
        }
        self.sum += other.sum;
    }
}

impl Distribution {
    /// How many times were counted.
    pub fn count(&self) -> u64 {
        self.counts.iter().sum()
    }

    /// The mean time, nanoseconds. `None` where nothing was counted. While times are being counted it
    /// may be off by one of them.
    pub fn mean(&self) -> Option<f64> {
        let count = self.count();
        (count > 0).then(|| self.sum as f64 / count as f64)
    }

    /// The time, in nanoseconds, that a share of `quantile` (0 to 1) of the times does not exceed.
    /// It is rounded up within its bucket, by less than 7%, so it never flatters. `None` where
    /// nothing was counted.
    pub fn quantile(&self, quantile: f64) -> Option<u64> {
        let count = self.count();
        if count == 0 {
            return None;
        }
        // Nearest rank, from 1 to the count; a NaN becomes rank 1.
        let rank = ((quantile * count as f64).ceil() as u64).clamp(1, count);
        let mut counted = 0;
        for (bucket, count) in self.counts.iter().enumerate() {
            counted += count;
            if counted >= rank {
                return Some(longest_in(bucket));
            }
        }
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn buckets_follow_each_other_without_gap() {
        let mut first = 0;
        for bucket in 0..BUCKETS {
            let last = longest_in(bucket);
            assert_eq!(bucket_of(first), bucket);
            assert_eq!(bucket_of(last), bucket);
            assert!((last - first) as f64 <= first as f64 / SPLIT as f64);
            first = last + 1;
        }
        assert_eq!(first, LONGEST_NS + 1);
    }

    #[test]
    fn nothing_counted_has_no_quantile_and_no_mean() {
        assert_eq!(Histogram::new().distribution().quantile(0.5), None);
        assert_eq!(Histogram::new().distribution().mean(), None);
    }

    #[test]
    fn the_mean_is_exact() {
        let histogram = Histogram::new();
        [1, 1000, 1_000_001].into_iter().for_each(|time| histogram.record(time));
        assert_eq!(histogram.distribution().mean(), Some(1_001_002.0 / 3.0));
    }

    #[test]
    fn times_beyond_the_longest_count_as_the_longest() {
        let histogram = Histogram::new();
        histogram.record(u64::MAX);
        assert_eq!(histogram.distribution().quantile(1.0), Some(LONGEST_NS));
    }

    #[test]
    fn quantiles_out_of_range_are_the_ends() {
        let histogram = Histogram::new();
        histogram.record(3);
        histogram.record(30);
        assert_eq!(histogram.distribution().quantile(-1.0), Some(3));
        assert_eq!(histogram.distribution().quantile(f64::NAN), Some(3));
        assert_eq!(histogram.distribution().quantile(7.0), Some(30));
    }

    proptest! {
        #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

        #[test]
        fn quantiles_agree_with_sorted_times(
            mut times in prop::collection::vec((0.0f64..10.0).prop_map(|e| 10f64.powf(e) as u64), 1..300),
            quantile in 0.0f64..=1.0,
        ) {
            let histogram = Histogram::new();
            for &time in &times {
                histogram.record(time);
            }
            times.sort_unstable();
            let rank = ((quantile * times.len() as f64).ceil() as usize).max(1);
            let exact = times[rank - 1];
            let found = histogram.distribution().quantile(quantile).unwrap();
            prop_assert!(found >= exact);
            prop_assert!((found - exact) as f64 <= 0.07 * exact as f64);
        }
    }
}
