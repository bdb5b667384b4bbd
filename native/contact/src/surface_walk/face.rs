//! A triangle as the walk sees it: where the goal's foot lies on its plane.
//!
//! The lattice looks the same turned by half a turn, and the turn takes a north-east half of a cell
//! to a south-west one. So both are one right triangle in a frame of their own, turned for the
//! second: corner A at (0, 0), B at (1, 0), C at (1, 1). Edge 0 lies opposite A, edge 1 opposite B
//! (the cell's diagonal), edge 2 opposite C. Half a turn about an edge's middle leads into the
//! triangle across it, where the edge keeps its number and runs the other way.
//!
//! Everything here depends on the triangle and the goal only, never on the way the walk came: a
//! walk that asks twice is answered the same twice.

use super::search::Search;
use surface::lattice::face;
use surface::{GridPoint, Half, Sample, Triangle};

/// A triangle, and the goal seen from it.
#[derive(Clone, Copy)]
pub(super) struct Face {
    /// Column and row of corner A.
    column: i64,
    row: i64,
    /// 1 for a north-east half, -1 for a south-west one.
    turn: i64,
    /// Of the corners A, B and C, metres.
    elevations: [f64; 3],
    /// The goal's columns and rows in the triangle's frame.
    goal: [f64; 2],
    /// Metres from the plane up to the goal; NaN where the triangle is absent.
    pub(super) goal_height: f64,
    /// Barycentric coordinates of the goal's foot on the plane, times `norm`: of A, B and C. Positive
    /// on the triangle's side of the edge opposite.
    pub(super) foot: [f64; 3],
    /// The squared length of the plane's normal whose upward part is 1: at least 1.
    pub(super) norm: f64,
}

/// An edge of the lattice by its vertex and its number there: 0 east, 1 south-east, 2 south.
#[derive(Clone, Copy, Debug)]
pub(super) struct LatticeEdge {
    pub(super) column: i64,
    pub(super) row: i64,
    pub(super) k: usize,
}

impl Face {
    #[inline(always)]
    pub(super) fn new<S: Sample>(search: &Search<S>, triangle: &Triangle) -> Self {
        let [north_west, second, third] = search.field.corner_elevations(triangle);
        let Triangle { column, row, half } = *triangle;
        match half {
            Half::NorthEast => Self::seen(search, column, row, 1, [north_west, second, third]),
            Half::SouthWest => {
                Self::seen(search, column + 1, row + 1, -1, [second, third, north_west])
            }
        }
    }

    /// The triangle across an edge: two corners are known, one is read.
    #[inline(always)]
    pub(super) fn across<S: Sample>(&self, edge: usize, search: &Search<S>) -> Self {
        let [a, b, c] = self.elevations;
        let read = |columns: i64, rows: i64| {
            search.field.elevation(self.column + self.turn * columns, self.row + self.turn * rows)
        };
        let ((columns, rows), elevations) = match edge {
            0 => ((2, 1), [read(2, 1), c, b]),
            1 => ((1, 1), [c, read(0, 1), a]),
            _ => ((1, 0), [b, a, read(0, -1)]),
        };
        let (column, row) = (self.column + self.turn * columns, self.row + self.turn * rows);
        Self::seen(search, column, row, -self.turn, elevations)
    }

    /// Equation 2 of the paper in this frame: the foot of the goal on the plane. Products that
    /// cancel are taken out beforehand, so that steep planes cost no digits.
    #[inline(always)]
    fn seen<S: Sample>(
        search: &Search<S>,
        column: i64,
        row: i64,
        turn: i64,
        elevations: [f64; 3],
    ) -> Self {
        let [columns, rows, height] = search.target.relative_to(column, row, elevations[0]);
        let (x, y) = (turn as f64 * columns, turn as f64 * rows);
        let (p, q) = (elevations[1] - elevations[0], elevations[2] - elevations[1]);
        let (up_p, up_q) = (search.up * p, search.up_over_row * q);
        let (steep_p, steep_q) = (up_p * p, up_q * q);
        let norm = 1.0 + steep_p + steep_q;
        let foot_x = x * (1.0 + steep_q) + up_p * (height - q * y);
        let foot_y = y * (1.0 + steep_p) + up_q * (height - p * x);
        Self {
            column,
            row,
            turn,
            elevations,
            goal: [x, y],
            goal_height: height - p * x - q * y,
            foot: [norm - foot_x, foot_x - foot_y, foot_y],
            norm,
        }
    }

    /// Whether rounding alone may have put the goal over the plane; not where the triangle is absent.
    #[inline(always)]
    pub(super) fn holds_within_rounding(&self) -> bool {
        let [a, b, c] = self.elevations;
        let [x, y] = self.goal;
        let size = a.abs() + ((b - a) * x).abs() + ((c - b) * y).abs();
        self.goal_height <= 16.0 * f64::EPSILON * size
    }

    /// What rounding can make of a foot that lies on an edge.
    #[inline(always)]
    pub(super) fn rounding<S>(&self, search: &Search<S>) -> f64 {
        let [x, y] = self.goal;
        let cells = search.weights.aspect * (x.abs() + y.abs());
        8.0 * f64::EPSILON * self.norm * (1.0 + cells)
    }

    #[inline(always)]
    pub(super) fn triangle(&self) -> Triangle {
        if self.turn > 0 { face(self.column, self.row, 0) } else { face(self.column, self.row, 3) }
    }

    /// Whether the goal, seen from above, lies beyond an edge on the triangle's side.
    pub(super) fn goal_is_within(&self, edge: usize) -> bool {
        self.goal_inward(edge) > 0.0
    }

    /// How far within the edge's line the goal lies, seen from above, in cells.
    #[inline(always)]
    pub(super) fn goal_inward(&self, edge: usize) -> f64 {
        let [x, y] = self.goal;
        match edge {
            0 => 1.0 - x,
            1 => x - y,
            _ => y,
        }
    }

    /// Barycentric coordinates of a point of the grid over the triangle.
    #[inline(always)]
    pub(super) fn shares_at(&self, point: &GridPoint) -> [f64; 3] {
        let [columns, rows, _] = point.relative_to(self.column, self.row, 0.0);
        let (x, y) = (self.turn as f64 * columns, self.turn as f64 * rows);
        [share(1.0 - x), share(x - y), share(y)]
    }

    /// The point of the plane at these barycentric coordinates, of which that of A is implied.
    #[inline(always)]
    pub(super) fn point(&self, share_b: f64, share_c: f64) -> GridPoint {
        let [a, b, c] = self.elevations;
        let (x, y) = (share_b + share_c, share_c);
        let (u, v) = if self.turn > 0 { (x, y) } else { (1.0 - x, 1.0 - y) };
        let Triangle { column, row, .. } = self.triangle();
        GridPoint { column, row, u, v, elevation: a + x * (b - a) + y * (c - b) }
    }

    /// The lattice's name of an edge, and the place on it that lies at `along` from the edge's first
    /// corner (A before B before C) to its second.
    #[inline(always)]
    pub(super) fn lattice_edge(&self, edge: usize, along: f64) -> (LatticeEdge, f64) {
        let (column, row) = (self.column, self.row);
        if self.turn > 0 {
            let (column, k) = match edge {
                0 => (column + 1, 2),
                1 => (column, 1),
                _ => (column, 0),
            };
            return (LatticeEdge { column, row, k }, along);
        }
        let (column, row, k) = match edge {
            0 => (column - 1, row - 1, 2),
            1 => (column - 1, row - 1, 1),
            _ => (column - 1, row, 0),
        };
        (LatticeEdge { column, row, k }, 1.0 - along)
    }
}

impl LatticeEdge {
    /// The north-eastern triangle beside the edge, and which of its edges this is. Along both, the
    /// way is counted from the same end.
    pub(super) fn north_eastern(&self) -> (Triangle, usize) {
        let Self { column, row, k } = *self;
        match k {
            0 => (face(column, row, 0), 2),
            1 => (face(column, row, 0), 1),
            _ => (face(column - 1, row, 0), 0),
        }
    }
}

/// A share of a whole, freed of rounding; 0 for NaN.
#[inline(always)]
#[allow(clippy::manual_clamp, reason = "clamp would pass NaN on")]
pub(super) fn share(number: f64) -> f64 {
    number.max(0.0).min(1.0)
}
