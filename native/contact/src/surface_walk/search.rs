//! What stays the same while one goal is followed.

use crate::weights::Weights;
use surface::{GridPoint, Heightfield, Sample};

pub(super) struct Search<'a, S> {
    pub(super) field: &'a Heightfield<'a, S>,
    pub(super) weights: Weights,
    /// Where the hand is.
    pub(super) goal: GridPoint,
    /// What a proxy on the map moves toward: the nearest place on the map to the hand.
    pub(super) target: GridPoint,
    /// Squared workspace length of a metre of height, in cell widths.
    pub(super) up: f64,
    /// The same over the squared length of a row.
    pub(super) up_over_row: f64,
}

impl<'a, S: Sample> Search<'a, S> {
    #[inline(always)]
    pub(super) fn new(field: &'a Heightfield<'a, S>, weights: Weights, goal: &GridPoint) -> Self {
        Self {
            field,
            weights,
            goal: *goal,
            target: field.nearest_on_map(goal),
            up: weights.up,
            up_over_row: weights.up_over_row,
        }
    }

    /// Columns and rows from a point to the target.
    #[inline(always)]
    pub(super) fn way_from(&self, point: &GridPoint) -> [f64; 2] {
        let [columns, rows, _] = self.target.relative_to(point.column, point.row, 0.0);
        [columns - point.u, rows - point.v]
    }

    /// From a point to the target, in cell widths.
    pub(super) fn squared_distance(&self, point: &GridPoint) -> f64 {
        let [columns, rows, up] = self.target.relative_to(point.column, point.row, point.elevation);
        self.weights.squared([columns - point.u, rows - point.v, up])
    }

    /// What rounding can feign in a squared distance: coordinates are exact to a unit in the last
    /// place of a cell and of the elevation.
    pub(super) fn rounding(&self, squared_distance: f64) -> f64 {
        let elevation = self.target.elevation;
        let size = squared_distance + 1.0 + self.weights.row + self.up * elevation * elevation;
        16.0 * f64::EPSILON * size
    }
}
