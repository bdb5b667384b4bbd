//! Distances that are compared to see whether a proxy has come nearer.

use crate::weights::Weights;
use surface::GridPoint;

/// The squared distance from a place to a proxy's target, cell widths.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Distance {
    squared: f64,
    /// How much of it rounding can feign.
    rounding: f64,
}

impl Distance {
    pub(crate) fn new(place: &GridPoint, target: &GridPoint, weights: &Weights) -> Self {
        let [u, v, up] = target.relative_to(place.column, place.row, place.elevation);
        let way = [u - place.u, v - place.v, up];
        let heights = target.elevation.abs() + place.elevation.abs();
        let sizes = [u.abs() + 1.0, v.abs() + 1.0, heights];
        let squared = weights.squared(way);
        let rounding = 4.0 * f64::EPSILON * (squared + weights.magnitude(way, sizes));
        Self { squared, rounding }
    }

    /// Less by more than the rounding error of both.
    pub(crate) fn is_less_than(&self, other: &Self) -> bool {
        self.squared + self.rounding + other.rounding < other.squared
    }
}
