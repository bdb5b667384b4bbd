//! Medians and tails.

use std::cmp::Ordering;

/// Where the bulk of a measure lies, and its tail.
#[derive(Clone, Copy, Debug, Default)]
pub struct Spread {
    /// Half of all are at most this.
    pub median: f64,
    /// 99 of 100 are at most this.
    pub p99: f64,
    /// 999 of 1000 are at most this.
    pub p999: f64,
    /// None is more than this.
    pub worst: f64,
    /// The mean.
    pub mean: f64,
}

impl Spread {
    /// Of any numbers, in any order; of none, zero.
    pub fn of(mut numbers: Vec<f64>) -> Self {
        if numbers.is_empty() {
            return Self::default();
        }
        numbers.sort_unstable_by(|a, b| a.partial_cmp(b).unwrap_or(Ordering::Equal));
        Self {
            median: quantile(&numbers, 0.5),
            p99: quantile(&numbers, 0.99),
            p999: quantile(&numbers, 0.999),
            worst: numbers[numbers.len() - 1],
            mean: numbers.iter().sum::<f64>() / numbers.len() as f64,
        }
    }
}

/// The smallest of `sorted` (not empty) that at least `share` of them do not exceed (nearest rank).
pub fn quantile(sorted: &[f64], share: f64) -> f64 {
    let rank = (share * sorted.len() as f64).ceil() as usize;
    sorted[rank.clamp(1, sorted.len()) - 1]
}

/// `part` of `whole`; of nothing, nothing.
pub fn share(part: u64, whole: u64) -> f64 {
    if whole == 0 { 0.0 } else { part as f64 / whole as f64 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantiles_are_nearest_ranks() {
        let numbers: Vec<f64> = (1..=1000).rev().map(f64::from).collect();
        let spread = Spread::of(numbers);
        assert_eq!((spread.median, spread.p99, spread.p999), (500.0, 990.0, 999.0));
        assert_eq!((spread.worst, spread.mean), (1000.0, 500.5));
        assert_eq!(quantile(&[7.0], 0.001), 7.0);
        assert_eq!(quantile(&[1.0, 2.0, 3.0], 0.5), 2.0);
    }

    #[test]
    fn of_nothing_there_is_nothing() {
        assert_eq!(Spread::of(Vec::new()).worst, 0.0);
        assert_eq!(share(0, 0), 0.0);
    }
}
