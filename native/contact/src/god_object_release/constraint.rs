//! The constraint planes of triangles that touch: projections of the goal on one of them, or on the
//! line in which two neighbours meet.

use crate::proxy::Place;
use crate::way::face_of_first;
use crate::weights::Weights;
use surface::lattice::{EAST, SOUTH, along_edges, counterclockwise, face, gradient};
use surface::{GridPoint, Half, Heightfield, Sample, Triangle};

/// A triangle's plane, in columns, rows and metres from the triangle's first (north-west) corner.
pub(super) struct Constraint {
    triangle: Triangle,
    /// Metres, of the first corner.
    elevation: f64,
    /// Rise of the plane for a column eastward and for a row southward, metres.
    slope: (f64, f64),
}

/// A way in a constraint plane, from the proxy toward the goal's projection.
pub(super) struct Slide {
    /// Shares of the triangle's corners in the proxy, and in the projection (barycentric
    /// coordinates: a share below 0 lies beyond the opposite edge).
    from: [f64; 3],
    to: [f64; 3],
    /// The projection, columns and rows from the triangle's first corner.
    foot: (f64, f64),
}

/// Where a slide leaves its triangle, if it does.
pub(super) enum Exit {
    /// The projection is inside.
    None,
    /// At this share of edge `k` of a vertex.
    Edge { vertex: (i64, i64), k: usize, share: f64 },
    /// At a vertex.
    Vertex(i64, i64),
}

/// An edge of a vertex as the line in which the planes beside it meet.
pub(super) struct Line {
    vertex: (i64, i64),
    k: usize,
    elevation: f64,
    vector: [f64; 3],
}

impl Constraint {
    /// `None` where the triangle is absent.
    #[inline(always)]
    pub(super) fn new<S: Sample>(field: &Heightfield<S>, triangle: Triangle) -> Option<Self> {
        Self::through(triangle, field.corner_elevations(&triangle))
    }

    /// Through corners at these elevations; `None` where one of them is NaN.
    #[inline(always)]
    pub(super) fn through(triangle: Triangle, corners: [f64; 3]) -> Option<Self> {
        let [first, second, third] = corners;
        let slope = gradient(face_of_first(triangle.half), second - first, third - first);
        let is_present = !(slope.0 + slope.1).is_nan();
        is_present.then_some(Self { triangle, elevation: first, slope })
    }

    /// From a proxy on the triangle to the goal's orthogonal projection on the plane (paper
    /// equation 2): what one Lagrange multiplier gives.
    #[inline(always)]
    pub(super) fn slide(&self, from: &GridPoint, goal: &GridPoint, weights: &Weights) -> Slide {
        let Triangle { column, row, .. } = self.triangle;
        let (east, south) = self.slope;
        let [u, v, _] = goal.relative_to(column, row, self.elevation);
        // The plane's normal, raised by the inverse metric.
        let normal = [-east, -south / weights.row];
        let squared = east * east + south * south / weights.row + 1.0 / weights.up;
        let multiplier = self.height_of(goal) / squared;
        let (u, v) = (u - multiplier * normal[0], v - multiplier * normal[1]);
        let [from_u, from_v, _] = from.relative_to(column, row, 0.0);
        Slide {
            from: self.shares(from_u, from_v).map(|share| share.max(0.0)),
            to: self.shares(u, v),
            foot: (u, v),
        }
    }

    /// Where a slide leads: the goal's projection.
    #[inline(always)]
    pub(super) fn foot(&self, slide: &Slide) -> GridPoint {
        let (u, v) = slide.foot;
        let elevation = self.elevation + (self.slope.0 * u + self.slope.1 * v);
        GridPoint::from_sample(self.triangle.column, self.triangle.row, u, v, elevation)
    }

    /// Squared length of a slide, cell widths.
    pub(super) fn gain(&self, slide: &Slide, from: &GridPoint, weights: &Weights) -> f64 {
        let foot = self.foot(slide);
        let [u, v, up] = foot.relative_to(from.column, from.row, from.elevation);
        weights.squared([u - from.u, v - from.v, up])
    }

    /// Where a slide leaves the triangle.
    #[inline(always)]
    pub(super) fn exit(&self, slide: &Slide) -> Exit {
        let Slide { from, to, .. } = slide;
        let (mut first, mut corner) = (f64::INFINITY, None);
        for opposite in 0..3 {
            if to[opposite] < 0.0 {
                let at = from[opposite] / (from[opposite] - to[opposite]);
                if at < first {
                    (first, corner) = (at, Some(opposite));
                }
            }
        }
        let Some(opposite) = corner else {
            return Exit::None;
        };
        let share = |corner: usize| from[corner] + first * (to[corner] - from[corner]);
        let (start, end, k) = edge_opposite(self.triangle.half, opposite);
        let (at_start, at_end) = (share(start).max(0.0), share(end).max(0.0));
        let corners = self.triangle.corners();
        if at_end <= 0.0 {
            return Exit::Vertex(corners[start].0, corners[start].1);
        }
        if at_start <= 0.0 {
            return Exit::Vertex(corners[end].0, corners[end].1);
        }
        Exit::Edge { vertex: corners[start], k, share: at_end / (at_start + at_end) }
    }

    /// Metres from the plane up to `point`.
    pub(super) fn height_of(&self, point: &GridPoint) -> f64 {
        let Triangle { column, row, .. } = self.triangle;
        let [u, v, up] = point.relative_to(column, row, self.elevation);
        up - (self.slope.0 * u + self.slope.1 * v)
    }

    /// The triangle.
    pub(super) fn triangle(&self) -> Triangle {
        self.triangle
    }

    fn shares(&self, u: f64, v: f64) -> [f64; 3] {
        let (second, third) = along_edges(face_of_first(self.triangle.half), u, v);
        // Not 1 - second - third: exactly 0 on the edge opposite the first corner.
        let first = match self.triangle.half {
            Half::NorthEast => 1.0 - u,
            Half::SouthWest => 1.0 - v,
        };
        [first, second, third]
    }
}

impl Slide {
    /// Whether it leads into the triangle from wherever it begins: on an edge, on a vertex.
    pub(super) fn leads_inside(&self) -> bool {
        (0..3).all(|corner| self.from[corner] > 0.0 || self.to[corner] >= 0.0)
    }
}

impl Line {
    /// `None` where an end is void or off the map.
    #[inline(always)]
    pub(super) fn new<S: Sample>(
        field: &Heightfield<S>,
        (column, row): (i64, i64),
        k: usize,
    ) -> Option<Self> {
        let elevation = field.elevation(column, row);
        let end = field.elevation(column + EAST[k], row + SOUTH[k]);
        Self::between((column, row), k, elevation, end)
    }

    /// Between ends at these elevations; `None` where one of them is NaN.
    #[inline(always)]
    pub(super) fn between(vertex: (i64, i64), k: usize, elevation: f64, end: f64) -> Option<Self> {
        let rise = end - elevation;
        let vector = [EAST[k] as f64, SOUTH[k] as f64, rise];
        (!rise.is_nan()).then_some(Self { vertex, k, elevation, vector })
    }

    /// The share of the edge at which it is closest to the goal, on its whole line (paper equation
    /// 1): what two Lagrange multipliers give.
    pub(super) fn closest_share(&self, goal: &GridPoint, weights: &Weights) -> f64 {
        let from_vertex = goal.relative_to(self.vertex.0, self.vertex.1, self.elevation);
        weights.product(from_vertex, self.vector) / weights.squared(self.vector)
    }

    /// Squared length of the whole edge, cell widths.
    pub(super) fn squared_length(&self, weights: &Weights) -> f64 {
        weights.squared(self.vector)
    }

    /// The point at `share`, between the ends.
    #[inline(always)]
    pub(super) fn point(&self, share: f64) -> GridPoint {
        let [u, v, rise] = self.vector.map(|part| share * part);
        let (column, row) = self.vertex;
        GridPoint::from_sample(column, row, u, v, self.elevation + rise)
    }

    /// The edge by name.
    pub(super) fn place(&self) -> Place {
        let (column, row) = self.vertex;
        Place::Edge { column, row, k: self.k }
    }

    /// Of the two triangles beside the edge, the one that is not this.
    pub(super) fn other_side(&self, triangle: &Triangle) -> Triangle {
        let [first, second] = self.sides();
        if *triangle == first { second } else { first }
    }

    /// Whether there is a triangle beside the edge.
    pub(super) fn has_face<S: Sample>(&self, field: &Heightfield<S>) -> bool {
        self.sides().iter().any(|side| field.is_present(side))
    }

    fn sides(&self) -> [Triangle; 2] {
        let (column, row) = self.vertex;
        [self.k, counterclockwise(self.k)].map(|k| face(column, row, k))
    }

    /// The vertex that it is an edge of.
    pub(super) fn start(&self) -> (i64, i64) {
        self.vertex
    }

    /// The vertex at the other end.
    pub(super) fn end(&self) -> (i64, i64) {
        (self.vertex.0 + EAST[self.k], self.vertex.1 + SOUTH[self.k])
    }
}

/// The edge opposite a triangle's corner: the corners that it leads from and to, and which edge it is
/// of the first.
fn edge_opposite(half: Half, corner: usize) -> (usize, usize, usize) {
    match (half, corner) {
        (Half::NorthEast, 0) => (1, 2, 2),
        (Half::NorthEast, 1) => (0, 2, 1),
        (Half::NorthEast, _) => (0, 1, 0),
        (Half::SouthWest, 0) => (2, 1, 0),
        (Half::SouthWest, 1) => (0, 2, 2),
        (Half::SouthWest, _) => (0, 1, 1),
    }
}
