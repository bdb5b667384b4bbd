//! The closest point to a goal on the free side of many planes: the sphere's next place.

use crate::planes::{Plane, dot, length, plus, project};

/// Planes tried in one search. Each one leads farther from the goal, so a search ends; on measured
/// terrain it took at most a handful.
const MOST_PLANES: usize = 64;

/// Up to three planes that hold a point.
#[derive(Clone, Copy, Debug)]
struct Basis {
    planes: [Plane; 3],
    count: usize,
}

/// The point closest to `goal` on the free sides of all `planes`, and whether any holds it off the
/// goal; `None` where there is no such point, or rounding hides it.
///
/// Each round takes the plane that is violated most and holds the point by it and by those of the
/// (at most three) planes before that still push: the points so found lie farther and farther from
/// the goal, until no plane is violated.
pub(super) fn closest(goal: [f64; 3], planes: &[Plane]) -> Option<([f64; 3], bool)> {
    let mut basis = Basis { planes: [Plane { normal: [0.0; 3], offset: 0.0 }; 3], count: 0 };
    let mut point = goal;
    for _ in 0..MOST_PLANES {
        let Some(violated) = most_violated(point, goal, planes) else {
            return Some((point, basis.count > 0));
        };
        (basis, point) = basis.with(violated, goal)?;
    }
    None
}

fn most_violated(point: [f64; 3], goal: [f64; 3], planes: &[Plane]) -> Option<Plane> {
    let (mut worst, mut found) = (0.0, None);
    for plane in planes {
        let depth = depth_behind(plane, point);
        if depth > worst && is_violated(plane, point, goal) {
            (worst, found) = (depth, Some(*plane));
        }
    }
    found
}

/// Whether a point is behind a plane by more than rounding may leave one that was projected on it.
fn is_violated(plane: &Plane, point: [f64; 3], goal: [f64; 3]) -> bool {
    let size = length(point) + length(goal) + plane.offset.abs();
    depth_behind(plane, point) > 16.0 * f64::EPSILON * size
}

fn depth_behind(plane: &Plane, point: [f64; 3]) -> f64 {
    plane.offset - dot(plane.normal, point)
}

impl Basis {
    fn planes(&self) -> &[Plane] {
        &self.planes[..self.count]
    }

    /// Held by `newest`, and by those of the others that push; the point closest to `goal` so held.
    fn with(&self, newest: Plane, goal: [f64; 3]) -> Option<(Self, [f64; 3])> {
        let mut best: Option<(Self, [f64; 3], f64)> = None;
        // Every choice of at most two of the others.
        for chosen in 0u32..1 << self.count {
            if chosen.count_ones() > 2 {
                continue;
            }
            let held = self.chosen(chosen, newest);
            let Some(point) = project(goal, held.planes()) else { continue };
            let mut others =
                (0..self.count).filter(|index| chosen & (1 << index) == 0).map(|i| self.planes[i]);
            if others.any(|plane| is_violated(&plane, point, goal)) {
                continue;
            }
            // Of points free of all, the closest has only planes that push: others hold it farther
            // away than need be.
            let distance = length(plus(point, -1.0, goal));
            if best.is_none_or(|(_, _, nearest)| distance < nearest) {
                best = Some((held, point, distance));
            }
        }
        best.map(|(held, point, _)| (held, point))
    }

    fn chosen(&self, chosen: u32, newest: Plane) -> Self {
        let mut held = Self { planes: [newest; 3], count: 1 };
        for (index, plane) in self.planes().iter().enumerate() {
            if chosen & (1 << index) != 0 {
                held.planes[held.count] = *plane;
                held.count += 1;
            }
        }
        held
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::planes::unit;
    use proptest::prelude::*;

    fn any_planes() -> impl Strategy<Value = Vec<Plane>> {
        let plane = (prop::array::uniform3(-1.0f64..1.0), 0.0f64..2.0)
            .prop_filter("a direction", |(normal, _)| length(*normal) > 0.1)
            // Free at the origin, as around a sphere that touches nothing.
            .prop_map(|(normal, depth)| Plane { normal: unit(normal), offset: -depth });
        prop::collection::vec(plane, 1..40)
    }

    proptest! {
        #![proptest_config(ProptestConfig { cases: 2000, failure_persistence: None, ..ProptestConfig::default() })]

        #[test]
        fn no_free_place_is_closer_than_the_closest(
            planes in any_planes(),
            goal in prop::array::uniform3(-5.0f64..5.0),
            others in prop::collection::vec(prop::array::uniform3(-5.0f64..5.0), 50),
        ) {
            let (point, is_held) = closest(goal, &planes).expect("the origin is free");
            let is_free = |place: [f64; 3], slack: f64| {
                planes.iter().all(|plane| dot(plane.normal, place) >= plane.offset - slack)
            };
            prop_assert!(is_free(point, 1e-9));
            prop_assert_eq!(is_held, !is_free(goal, 1e-12));
            let distance = length(plus(point, -1.0, goal));
            for other in others {
                // On the way from the origin, which is free, to anywhere.
                for share in [1.0, 0.5, 0.1] {
                    let place = other.map(|part| share * part);
                    if is_free(place, 0.0) {
                        prop_assert!(distance <= length(plus(place, -1.0, goal)) + 1e-9);
                    }
                }
            }
        }
    }

    #[test]
    fn planes_that_leave_no_room_have_no_closest_point() {
        let above = Plane { normal: [0.0, 0.0, 1.0], offset: 1.0 };
        let below = Plane { normal: [0.0, 0.0, -1.0], offset: 1.0 };
        assert!(closest([0.0; 3], &[above, below]).is_none());
    }
}
