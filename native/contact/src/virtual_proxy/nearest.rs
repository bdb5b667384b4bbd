//! The closest point of a triangle to the sphere's centre.

use crate::contact::Feature;
use crate::planes::{dot, plus};

/// The closest point of a triangle to the origin.
#[derive(Clone, Copy, Debug)]
pub(super) struct Nearest {
    pub(super) point: [f64; 3],
    /// Whether it is inside the triangle, on an edge of it or at a corner.
    pub(super) feature: Feature,
}

/// The closest point of the triangle with these `corners` to the origin. `normal` is the triangle's
/// unit normal.
pub(super) fn nearest(corners: &[[f64; 3]; 3], normal: [f64; 3]) -> Nearest {
    let foot = normal.map(|part| part * dot(normal, corners[0]));
    let mut best = Nearest { point: foot, feature: Feature::Face };
    let (mut least, mut is_inside) = (f64::INFINITY, true);
    for i in 0..3 {
        let (start, end) = (corners[i], corners[(i + 1) % 3]);
        let edge = plus(end, -1.0, start);
        // Corners go clockwise as the map is seen, the normal points up: outward is to the left.
        let inward = cross(edge, normal);
        if dot(inward, start) <= 0.0 {
            continue;
        }
        is_inside = false;
        let found = nearest_of_edge(start, edge);
        let squared = dot(found.point, found.point);
        if squared < least {
            (best, least) = (found, squared);
        }
    }
    if is_inside { Nearest { point: foot, feature: Feature::Face } } else { best }
}

fn nearest_of_edge(start: [f64; 3], edge: [f64; 3]) -> Nearest {
    let share = -dot(start, edge) / dot(edge, edge);
    if share <= 0.0 {
        return Nearest { point: start, feature: Feature::Vertex };
    }
    if share >= 1.0 {
        return Nearest { point: plus(start, 1.0, edge), feature: Feature::Vertex };
    }
    Nearest { point: plus(start, share, edge), feature: Feature::Edge }
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::planes::{length, unit};
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig { cases: 2000, failure_persistence: None, ..ProptestConfig::default() })]

        #[test]
        fn no_point_of_the_triangle_is_nearer(
            heights in prop::array::uniform3(-5.0f64..5.0),
            from in prop::array::uniform3(-5.0f64..5.0),
            shares in prop::collection::vec((0.0f64..1.0, 0.0f64..1.0), 100),
        ) {
            // Clockwise as the map is seen from above: north-west, north-east, south-east.
            let places = [[0.0, 0.0], [1.0, 0.0], [1.0, -1.0]];
            let corners = [0, 1, 2].map(|i| {
                [places[i][0] - from[0], places[i][1] - from[1], heights[i] - from[2]]
            });
            let (to_second, to_third) =
                (plus(corners[1], -1.0, corners[0]), plus(corners[2], -1.0, corners[0]));
            let normal = unit(cross(to_third, to_second));
            prop_assert!(normal[2] > 0.0);
            let found = nearest(&corners, normal);
            let distance = length(found.point);
            let mut least = f64::INFINITY;
            for (first, second) in shares {
                let (a, b) = if first + second > 1.0 { (1.0 - first, 1.0 - second) } else { (first, second) };
                let place = plus(plus(corners[0], a, to_second), b, to_third);
                prop_assert!(distance <= length(place) + 1e-12);
                least = least.min(length(place));
            }
            // The random places come near it: it is on the triangle, not beyond.
            prop_assert!(least - distance < 4.0);
        }
    }
}
