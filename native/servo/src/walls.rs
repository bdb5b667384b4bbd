//! Walls around the workspace, and how they meet the surface.

use devices::{ParameterError, check};

use crate::mix::{Contributor, Mix};

/// Share of the workspace between its walls. Ours: 8 N on a wall of 500 N/m push the hand 16 mm in, of
/// which half is to lie before the stops of a desktop device, 0.16 m wide.
const INSET: f64 = 0.9;

/// Four upright walls that keep the hand inside the workspace (paper, section 4.2).
///
/// The contact model is asked where the proxy of the hand *inside* the walls is; wall and surface
/// then push together as the mixing room lets them. As the point inside does not move while the hand
/// is pressed further into a wall, the surface's plane does not either, and there is no step where
/// surface contact begins or ends behind a wall.
///
/// The paper fades the surface's force to zero faster than the wall's grows, so that the two are
/// independent or only one is there. The mixing room keeps that promise where it is about stability,
/// and no further: what of the surface's push is at right angles to the wall is independent and
/// stays, and along the wall's direction the two are never added: the larger one holds. A fade was
/// tried: it can be an eighth stiffer than one spring, and has no potential.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Walls {
    /// Metres from the origin to the walls on the right and left, and to those far and near.
    half: [f64; 2],
}

impl Walls {
    /// Walls at plus and minus `half_width` and `half_depth` metres, workspace frame.
    pub fn new(half_width: f64, half_depth: f64) -> Result<Walls, ParameterError> {
        check::positive("half width between walls", half_width)?;
        check::positive("half depth between walls", half_depth)?;
        Ok(Walls { half: [half_width, half_depth] })
    }

    /// Walls that keep the hand in a workspace of that width and depth (metres), a little before it
    /// ends: where a device's own stop holds the hand, no wall would be felt.
    pub(crate) fn of_workspace([width, depth, _]: [f64; 3]) -> Walls {
        Walls { half: [width, depth].map(|side| 0.5 * INSET * side) }
    }

    /// The nearest point between the walls.
    pub(crate) fn inside(&self, hand: [f64; 3]) -> [f64; 3] {
        let [x, y, z] = hand;
        let [width, depth] = self.half;
        [x.clamp(-width, width), y.clamp(-depth, depth), z]
    }

    /// Metres that the spring on the hand is stretched: by walls and, where there is contact, by the
    /// surface, whose proxy lies `surface` metres from the point inside.
    pub(crate) fn push(&self, hand: [f64; 3], surface: Option<[f64; 3]>) -> [f64; 3] {
        if let Some(way) = surface
            && self.hold(hand)
            && self.hold(std::array::from_fn(|axis| hand[axis] + way[axis]))
        {
            return way;
        }
        let mut mix = Mix::new();
        for axis in 0..2 {
            let mut direction = [0.0; 3];
            direction[axis] = -hand[axis].signum();
            mix.add(Contributor { direction, push: hand[axis].abs() - self.half[axis] });
        }
        if let Some(contributor) = surface.and_then(|way| self.of_surface(hand, way)) {
            mix.add(contributor);
        }
        mix.push()
    }

    /// Whether no wall has anything against a point.
    pub(crate) fn hold(&self, point: [f64; 3]) -> bool {
        (0..2).all(|axis| point[axis].abs() <= self.half[axis])
    }

    /// The surface as a plane through its proxy, seen from the hand. There is none where the proxy
    /// lies at the point inside: it asks for nothing there.
    fn of_surface(&self, hand: [f64; 3], way: [f64; 3]) -> Option<Contributor> {
        let length = way[0].hypot(way[1]).hypot(way[2]);
        let direction = way.map(|metres| metres / length);
        if !direction.iter().all(|part| part.is_finite()) {
            return None;
        }
        let inside = self.inside(hand);
        let of_walls: f64 = (0..3).map(|axis| direction[axis] * (inside[axis] - hand[axis])).sum();
        Some(Contributor { direction, push: length + of_walls })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const HALF: f64 = 0.05;

    fn walls() -> Walls {
        Walls::new(HALF, HALF).unwrap()
    }

    /// The nearest point of a plane through the origin of `direction`, from the point inside.
    fn way_to_plane(direction: [f64; 3], inside: [f64; 3]) -> Option<[f64; 3]> {
        let depth = -(0..3).map(|axis| direction[axis] * inside[axis]).sum::<f64>();
        (depth > 0.0).then(|| direction.map(|part| part * depth))
    }

    fn unit(vector: [f64; 3]) -> [f64; 3] {
        let length = vector[0].hypot(vector[1]).hypot(vector[2]);
        vector.map(|part| part / length)
    }

    #[test]
    fn without_contact_a_wall_pushes_alone_and_inside_nothing_does() {
        let pushed = walls().push([HALF + 0.002, 0.01, 0.0], None);
        assert!((pushed[0] + 0.002).abs() < 1e-15 && pushed[1..] == [0.0, 0.0], "{pushed:?}");
        assert_eq!(walls().push([HALF, -HALF, 7.0], None), [0.0; 3]);
    }

    #[test]
    fn away_from_walls_the_surface_is_as_it_is_without_them() {
        let way = [1e-4, -2e-4, 3e-3];
        assert_eq!(walls().push([0.01, 0.0, -0.003], Some(way)), way);
    }

    #[test]
    fn flat_ground_and_a_wall_push_both() {
        let pushed = walls().push([HALF + 0.002, 0.0, -0.003], Some([0.0, 0.0, 0.003]));
        for (part, expected) in pushed.into_iter().zip([-0.002, 0.0, 0.003]) {
            assert!((part - expected).abs() < 1e-8);
        }
    }

    #[test]
    fn a_surface_that_asks_for_nothing_changes_nothing() {
        let hand = [HALF + 0.001, 0.0, 0.0];
        assert_eq!(walls().push(hand, Some([0.0; 3])), walls().push(hand, None));
    }

    proptest! {
        #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

        /// Over slopes of every direction, on both sides of walls and of the ground.
        #[test]
        fn the_push_makes_no_step_and_is_no_stiffer_than_one_spring(
            slope in (-1.0f64..1.0, -1.0f64..1.0, 0.05f64..1.0),
            hand in (-0.07f64..0.07, -0.07f64..0.07, -0.05f64..0.05),
            way in (-1.0f64..1.0, -1.0f64..1.0, -1.0f64..1.0), exponent in -6.0f64..-2.0,
        ) {
            let direction = unit([slope.0, slope.1, slope.2]);
            let push = |hand: [f64; 3]| {
                let way = way_to_plane(direction, walls().inside(hand));
                walls().push(hand, way)
            };
            let metres = 10f64.powf(exponent);
            let way = unit([way.0, way.1, way.2 + 2.0]);
            let hand = [hand.0, hand.1, hand.2];
            let moved = std::array::from_fn(|axis| hand[axis] + metres * way[axis]);
            let (before, after) = (push(hand), push(moved));
            let change: [f64; 3] = std::array::from_fn(|axis| (after[axis] - before[axis]) / metres);
            let along: f64 = (0..3).map(|axis| change[axis] * way[axis]).sum();
            let size = change[0].hypot(change[1]).hypot(change[2]);
            prop_assert!((-1.0 - 1e-5..=1e-5).contains(&along), "{along} of the spring");
            prop_assert!(size * size <= 1e-5 - along, "{size} of the spring");
        }
    }
}
