//! Constraint planes, and the projection of a goal on up to three of them: what Lagrange multipliers
//! give (Zilles and Salisbury 1995), found by orthogonal axes, which loses less to rounding.
//!
//! Places are vectors in a space like the workspace, its unit of length the width of a cell: right,
//! away, up. Normals have length 1, so nothing overflows whatever the relief.

use surface::{GridPoint, Metric};

/// Planes whose normals differ by less than this angle, or three whose normals lie as near to one
/// plane, do not fix another point together: the rounding of unit normals (2^-53) would grow to more
/// than a thousandth in what they fix.
const SINGULAR: f64 = 1.0 / (1u64 << 40) as f64;

/// A plane, and the side of it that is free: all x with `normal` . x >= `offset`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Plane {
    /// Of length 1, toward the free side.
    pub(crate) normal: [f64; 3],
    pub(crate) offset: f64,
}

/// Lengths of the grid in the width of a cell.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Scale {
    pub(crate) row: f64,
    pub(crate) up: f64,
}

impl Scale {
    pub(crate) fn new(metric: &Metric) -> Self {
        Self { row: metric.row / metric.column, up: metric.up / metric.column }
    }

    /// From columns, rows and metres.
    #[inline(always)]
    pub(crate) fn vector(&self, [columns, rows, metres]: [f64; 3]) -> [f64; 3] {
        // Rows run south; the second axis points away from the hand, north.
        [columns, -rows * self.row, metres * self.up]
    }

    /// To columns, rows and metres.
    pub(crate) fn on_grid(&self, [right, away, up]: [f64; 3]) -> [f64; 3] {
        [right, -away / self.row, up / self.up]
    }

    /// The vector from one point to another.
    pub(crate) fn between(&self, from: &GridPoint, to: &GridPoint) -> [f64; 3] {
        let [u, v, up] = to.relative_to(from.column, from.row, from.elevation);
        self.vector([u - from.u, v - from.v, up])
    }

    /// The upward unit normal of a plane that rises by these metres for a column eastward and for a
    /// row southward.
    pub(crate) fn normal(&self, (east, south): (f64, f64)) -> [f64; 3] {
        unit([-east * self.up, south * self.up / self.row, 1.0])
    }
}

/// The point of the intersection of `planes` (at most three) that is closest to `goal`; `None` where
/// the planes are singular: parallel, or all along one line.
pub(crate) fn project(goal: [f64; 3], planes: &[Plane]) -> Option<[f64; 3]> {
    // Once more: where planes meet at a sharp angle, the first time leaves a rest of rounding.
    project_once(project_once(goal, planes)?, planes)
}

fn project_once(goal: [f64; 3], planes: &[Plane]) -> Option<[f64; 3]> {
    // Gram and Schmidt: an axis of its own for each plane, at right angles to those before it.
    let mut axes = [[0.0; 3]; 3];
    let mut steps = [0.0; 3];
    for (i, plane) in planes.iter().enumerate() {
        let mut rest = plane.normal;
        let mut missing = plane.offset - dot(plane.normal, goal);
        for j in 0..i {
            let along = dot(rest, axes[j]);
            rest = plus(rest, -along, axes[j]);
            missing -= along * steps[j];
        }
        let length = length(rest);
        // False for NaN too.
        let is_regular = length > SINGULAR;
        if !is_regular {
            return None;
        }
        axes[i] = rest.map(|part| part / length);
        steps[i] = missing / length;
    }
    Some((0..planes.len()).fold(goal, |point, i| plus(point, steps[i], axes[i])))
}

#[inline(always)]
pub(crate) fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// `a` and `times` b.
#[inline(always)]
pub(crate) fn plus(a: [f64; 3], times: f64, b: [f64; 3]) -> [f64; 3] {
    [a[0] + times * b[0], a[1] + times * b[1], a[2] + times * b[2]]
}

#[inline(always)]
pub(crate) fn length(a: [f64; 3]) -> f64 {
    dot(a, a).sqrt()
}

/// The vector of length 1 in this direction.
pub(crate) fn unit(a: [f64; 3]) -> [f64; 3] {
    // First by the largest part: no square overflows or vanishes.
    let largest = a[0].abs().max(a[1].abs()).max(a[2].abs());
    let a = a.map(|part| part / largest);
    let length = length(a);
    a.map(|part| part / length)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn any_plane() -> impl Strategy<Value = Plane> {
        (prop::array::uniform3(-1.0f64..1.0), -10.0f64..10.0)
            .prop_filter("a direction", |(normal, _)| length(*normal) > 0.1)
            .prop_map(|(normal, offset)| Plane { normal: unit(normal), offset })
    }

    proptest! {
        #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

        #[test]
        fn a_projection_lies_on_all_planes_and_no_point_of_them_is_closer(
            planes in prop::collection::vec(any_plane(), 1..=3),
            goal in prop::array::uniform3(-10.0f64..10.0),
            other in prop::array::uniform3(-10.0f64..10.0),
        ) {
            let (Some(point), Some(other)) = (project(goal, &planes), project(other, &planes)) else {
                return Err(TestCaseError::reject("singular"));
            };
            let size = 1.0 + length(point) + length(other);
            for plane in &planes {
                prop_assert!((dot(plane.normal, point) - plane.offset).abs() < 1e-9 * size);
            }
            let distance = |place| length(plus(place, -1.0, goal));
            prop_assert!(distance(point) <= distance(other) + 1e-9 * size);
        }
    }

    #[test]
    fn planes_that_fix_no_point_together_are_singular() {
        let plane = |normal: [f64; 3]| Plane { normal: unit(normal), offset: 0.0 };
        let (a, b) = (plane([0.1, 0.0, 1.0]), plane([0.0, 0.2, 1.0]));
        assert!(project([1.0; 3], &[a, a]).is_none());
        assert!(project([1.0; 3], &[a, b, plane([0.1, 0.2, 2.0])]).is_none());
        assert!(project([1.0; 3], &[a, b, plane([0.1, 0.2, 1.0])]).is_some());
    }

    #[test]
    fn directions_at_the_ends_of_the_number_range_have_length_one() {
        for size in [1e-300, 1.0, 1e300] {
            let found = unit([3.0 * size, 0.0, 4.0 * size]);
            assert!((found[0] - 0.6).abs() < 1e-15 && (found[2] - 0.8).abs() < 1e-15);
        }
    }
}
