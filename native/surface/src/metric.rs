//! The metric in which distances over a grid are measured.

/// Workspace metres for a step in each direction of the grid.
///
/// Contact minimises distances as the hand feels them (paper 4.2, 4.4): zoom changes all three
/// lengths, vertical exaggeration the last, and cells need not be square.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Metric {
    /// Workspace metres from one column to the next.
    pub column: f64,
    /// Workspace metres from one row to the next.
    pub row: f64,
    /// Workspace metres for a metre of elevation, exaggeration included.
    pub up: f64,
}

impl Metric {
    /// Whether distances can be measured by it: all three lengths are positive, finite and not denormal,
    /// and so are the squares of their ratios, by which they are weighed against each other.
    pub fn is_valid(&self) -> bool {
        // Sign and exponent: every update asks, and ratios would be divisions.
        let powers = [self.column, self.row, self.up].map(|length| length.to_bits() >> 52);
        let (least, most) = powers
            .iter()
            .fold((u64::MAX, 0), |(least, most), power| (least.min(*power), most.max(*power)));
        least >= 1 && most <= LARGEST_POWER && most - least <= WIDEST
    }
}

/// The exponent of the largest numbers, as it is stored; beyond it are infinity, NaN, and negative numbers.
const LARGEST_POWER: u64 = 2046;

/// Powers of two between lengths; the square of a ratio is at most 2^1002.
const WIDEST: u64 = 500;

#[cfg(test)]
mod tests {
    use super::*;

    fn is_valid(column: f64, row: f64, up: f64) -> bool {
        Metric { column, row, up }.is_valid()
    }

    #[test]
    fn lengths_are_positive_and_finite() {
        assert!(is_valid(1.0, 2.0, 0.1) && is_valid(1e300, 1e300, 1e300));
        assert!(is_valid(1e-300, 1e-298, 1e-306) && is_valid(1e6, 1e8, 1e-9));
        for broken in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert!(!is_valid(broken, 1.0, 1.0));
            assert!(!is_valid(1.0, broken, 1.0));
            assert!(!is_valid(1.0, 1.0, broken));
        }
    }

    /// Each of the lengths can be held, but not what one is to another.
    #[test]
    fn lengths_that_cannot_be_weighed_against_each_other_measure_nothing() {
        assert!(!is_valid(5e36, 5e36, 2e-299));
        assert!(!is_valid(1e-300, 1e-300, 1e300));
        assert!(!is_valid(1.0, 1e-200, 1.0) && !is_valid(1.0, 1e200, 1.0));
        assert!(!is_valid(1e-100, 1e100, 1.0));
    }
}
