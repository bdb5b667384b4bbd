//! Sub-steps: the goal led over its way in parts.

use surface::GridPoint;

/// The straight way of a goal, in equal parts.
pub(super) struct SubSteps {
    from: GridPoint,
    to: GridPoint,
    /// Columns, rows and metres.
    way: [f64; 3],
    /// Of the parts; at least 1.
    count: f64,
}

impl SubSteps {
    /// Parts no longer than `longest` cells over the ground.
    pub(super) fn new(from: &GridPoint, to: &GridPoint, longest: f64) -> Self {
        let [columns, rows, up] = to.relative_to(from.column, from.row, from.elevation);
        let (east, south) = (columns - from.u, rows - from.v);
        let count = (east.hypot(south) / longest).ceil().max(1.0);
        Self { from: *from, to: *to, way: [east, south, up], count }
    }

    /// The share of the way that a point on it has behind it.
    pub(super) fn share_at(&self, point: &GridPoint) -> f64 {
        let [columns, rows, _] = point.relative_to(self.from.column, self.from.row, 0.0);
        let [east, south, _] = self.way;
        let (length, passed) = if east.abs() > south.abs() {
            (east, columns - self.from.u)
        } else {
            (south, rows - self.from.v)
        };
        // A way straight down is not divided at all.
        let share = passed / length;
        if share > 0.0 && share < 1.0 { share } else { 0.0 }
    }

    /// The end of the part that begins at a share of the way or holds it, and that end's share. The
    /// last end is the goal itself.
    pub(super) fn after(&self, share: f64) -> (GridPoint, f64) {
        // A little more, so that the end of a part is not taken for a place before it.
        let number = (share * self.count * (1.0 + 4.0 * f64::EPSILON)).floor() + 1.0;
        if !(number < self.count) {
            return (self.to, 1.0);
        }
        let share = number / self.count;
        let [east, south, up] = self.way.map(|part| share * part);
        let (u, v) = (self.from.u + east, self.from.v + south);
        let elevation = self.from.elevation + up;
        (GridPoint::from_sample(self.from.column, self.from.row, u, v, elevation), share)
    }
}
