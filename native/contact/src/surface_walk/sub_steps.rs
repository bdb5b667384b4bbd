//! Sub-steps: the goal led over its way in parts.

use surface::GridPoint;

/// The ends of equal parts of a straight way, the last of them the goal itself.
pub(super) struct SubSteps {
    from: GridPoint,
    to: GridPoint,
    /// Columns, rows and metres.
    way: [f64; 3],
    /// Of the parts; at least 1.
    count: f64,
    /// Of the part that ends next.
    next: f64,
}

impl SubSteps {
    /// Parts no longer than `longest` cells over the ground.
    pub(super) fn new(from: &GridPoint, to: &GridPoint, longest: f64) -> Self {
        let [columns, rows, up] = to.relative_to(from.column, from.row, from.elevation);
        let (east, south) = (columns - from.u, rows - from.v);
        let count = (east.hypot(south) / longest).ceil().max(1.0);
        Self { from: *from, to: *to, way: [east, south, up], count, next: 1.0 }
    }
}

impl Iterator for SubSteps {
    type Item = GridPoint;

    fn next(&mut self) -> Option<GridPoint> {
        let number = self.next;
        self.next += 1.0;
        if number >= self.count {
            return (number == self.count).then_some(self.to);
        }
        let [east, south, up] = self.way.map(|part| number / self.count * part);
        let (u, v) = (self.from.u + east, self.from.v + south);
        let elevation = self.from.elevation + up;
        Some(GridPoint::from_sample(self.from.column, self.from.row, u, v, elevation))
    }
}
