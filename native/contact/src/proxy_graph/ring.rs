//! The six edges and faces around a vertex, and the minima that lie on them.
//!
//! Places are given in columns, rows and metres relative to the vertex. Planes and insides do not
//! depend on how these are measured; only scalar products do, and they take the [`Weights`].

use crate::weights::Weights;
use std::array;
use surface::lattice::{EAST, SOUTH, along_edges, clockwise, counterclockwise, gradient, sector};
use surface::{GridPoint, Heightfield, Sample};

/// A vertex and its neighbours.
pub(super) struct Ring {
    column: i64,
    row: i64,
    elevation: f64,
    /// Rise along each edge, metres; NaN where the neighbour is void or off the map.
    rises: [f64; 6],
}

/// An edge that leads toward the goal.
pub(super) struct Edge {
    pub(super) k: usize,
    /// Whether its end is closer to the goal than the vertex.
    pub(super) end_is_closer: bool,
    vector: [f64; 3],
    /// Scalar product with the way to the goal.
    product: f64,
    squared_length: f64,
}

/// The closest point to the goal on an edge and the two faces beside it.
pub(super) enum Minimum {
    /// On edge `k`, at this share of it.
    OnEdge { k: usize, share: f64 },
    /// On face `k`, this many columns east and rows south of the vertex.
    OnFace { k: usize, u: f64, v: f64 },
    /// On the edge of face `k` opposite the vertex, at this share from the end of edge `k`; of its
    /// two ends, that of edge `nearest` is closer to the goal (paper 3.3).
    BeyondFarEdge { k: usize, share: f64, nearest: usize },
}

impl Ring {
    #[inline(always)]
    pub(super) fn new<S: Sample>(field: &Heightfield<S>, column: i64, row: i64) -> Self {
        const STEPS: [(i64, i64); 7] = [(0, 0), (1, 0), (1, 1), (0, 1), (-1, 0), (-1, -1), (0, -1)];
        let [elevation, neighbours @ ..] = field.elevations_near(column, row, STEPS);
        let rises = neighbours.map(|neighbour| neighbour - elevation);
        Self { column, row, elevation, rises }
    }

    pub(super) fn vertex(&self) -> (i64, i64) {
        (self.column, self.row)
    }

    /// Metres.
    pub(super) fn elevation(&self) -> f64 {
        self.elevation
    }

    pub(super) fn neighbour(&self, k: usize) -> (i64, i64) {
        (self.column + EAST[k], self.row + SOUTH[k])
    }

    /// The face over which the direction (`u`, `v`) leads. Along an edge, one that exists if either does.
    #[inline(always)]
    pub(super) fn face_toward(&self, u: f64, v: f64) -> usize {
        let k = sector(u, v);
        if self.is_present(k) { k } else { self.other_face_toward(k, u, v) }
    }

    /// Whether the goal is on or under the plane of face `k`: then that face obstructs the way to
    /// it (paper 3.5). An absent face obstructs nothing.
    #[inline(always)]
    pub(super) fn blocks(&self, k: usize, goal: [f64; 3]) -> bool {
        self.height_over_face(k, goal) <= 0.0
    }

    /// The edge with the most negative edge gradient (paper figure 8), if any is negative.
    #[inline(always)]
    pub(super) fn steepest_edge(&self, goal: [f64; 3], weights: &Weights) -> Option<Edge> {
        let products = self.products(goal, weights);
        let squared_lengths = self.squared_lengths(weights);
        let (mut steepest, mut best_gain) = (None, 0.0);
        for k in 0..6 {
            // Edge gradients are compared by their squares, and without the factor that all share:
            // the distance to the goal. With a branch for each: the processor guesses the way, and
            // has the next samples on theirs. To take the greatest without a branch costs more.
            if products[k] > 0.0 {
                let gain = products[k] * products[k] / squared_lengths[k];
                if gain > best_gain && self.has_face(k) {
                    (steepest, best_gain) = (Some((k, products[k], squared_lengths[k])), gain);
                }
            }
        }
        let (k, product, squared_length) = steepest?;
        Some(self.edge_toward(k, product, squared_length, goal, weights))
    }

    /// Scalar products of the edges with the way to the goal: [`Weights::product`] without the terms
    /// that are zero.
    #[inline(always)]
    fn products(&self, goal: [f64; 3], weights: &Weights) -> [f64; 6] {
        let (east, south) = (goal[0], weights.row * goal[1]);
        let along_ground = [east, east + south, south, -east, -(east + south), -south];
        array::from_fn(|k| along_ground[k] + weights.up * (self.rises[k] * goal[2]))
    }

    /// [`Weights::squared`] of the edges, without the terms that are zero.
    #[inline(always)]
    fn squared_lengths(&self, weights: &Weights) -> [f64; 6] {
        let diagonal = 1.0 + weights.row;
        let on_ground = [1.0, diagonal, weights.row, 1.0, diagonal, weights.row];
        array::from_fn(|k| on_ground[k] + weights.up * (self.rises[k] * self.rises[k]))
    }

    /// The closest point to the goal on an edge that has a minimum, and on the two faces beside it
    /// (paper equations 1 and 2). Where the goal's projection on a face lies between the lines of
    /// the vertex's edges but beyond the third, the closest point is on that far edge (paper 3.3).
    pub(super) fn minimum_beside(&self, edge: &Edge, goal: [f64; 3], weights: &Weights) -> Minimum {
        let share = (edge.product / edge.squared_length).min(1.0);
        let mut minimum = Minimum::OnEdge { k: edge.k, share };
        let mut squared_distance = weights.squared(beyond(goal, edge.vector, share));
        for k in [edge.k, counterclockwise(edge.k)] {
            if !self.is_present(k) {
                continue;
            }
            let (found, distance) = match self.face_minimum(k, goal, weights) {
                Some(found) => found,
                None => continue,
            };
            if distance < squared_distance {
                (minimum, squared_distance) = (found, distance);
            }
        }
        minimum
    }

    pub(super) fn point_on_edge(&self, k: usize, share: f64) -> GridPoint {
        let [u, v, rise] = self.edge_vector(k).map(|part| share * part);
        GridPoint::from_sample(self.column, self.row, u, v, self.elevation + rise)
    }

    pub(super) fn point_on_face(&self, k: usize, u: f64, v: f64) -> GridPoint {
        let elevation = self.elevation + self.plane_rise(k, u, v);
        GridPoint::from_sample(self.column, self.row, u, v, elevation)
    }

    #[inline(always)]
    fn is_present(&self, k: usize) -> bool {
        !(self.rises[k] + self.rises[clockwise(k)]).is_nan()
    }

    /// Whether edge `k` bounds at least one face.
    fn has_face(&self, k: usize) -> bool {
        self.is_present(k) || self.is_present(counterclockwise(k))
    }

    #[cold]
    fn other_face_toward(&self, absent: usize, u: f64, v: f64) -> usize {
        let leads_over = |&k: &usize| {
            let (first, second) = along_edges(k, u, v);
            first >= 0.0 && second >= 0.0 && self.is_present(k)
        };
        (0..6).find(leads_over).unwrap_or(absent)
    }

    #[inline(always)]
    fn edge_vector(&self, k: usize) -> [f64; 3] {
        [EAST[k] as f64, SOUTH[k] as f64, self.rises[k]]
    }

    #[inline(always)]
    fn plane_rise(&self, k: usize, u: f64, v: f64) -> f64 {
        let (first, second) = along_edges(k, u, v);
        first * self.rises[k] + second * self.rises[clockwise(k)]
    }

    #[inline(always)]
    fn height_over_face(&self, k: usize, goal: [f64; 3]) -> f64 {
        goal[2] - self.plane_rise(k, goal[0], goal[1])
    }

    #[inline(always)]
    fn edge_toward(
        &self,
        k: usize,
        product: f64,
        squared_length: f64,
        goal: [f64; 3],
        weights: &Weights,
    ) -> Edge {
        let vector = self.edge_vector(k);
        // The end is closer by more than rounding can feign, so that a chain of steps never comes
        // round to where it began.
        let gained = 2.0 * product - squared_length;
        let rounding =
            8.0 * f64::EPSILON * (2.0 * weights.magnitude(vector, goal) + squared_length);
        Edge { k, end_is_closer: gained > rounding, vector, product, squared_length }
    }

    /// The goal's projection on face `k` where it is inside the face, or the closest point of the
    /// far edge where it is beyond that, and the squared distance; `None` where it is elsewhere.
    fn face_minimum(&self, k: usize, goal: [f64; 3], weights: &Weights) -> Option<(Minimum, f64)> {
        let (east, south) = gradient(k, self.rises[k], self.rises[clockwise(k)]);
        // The plane's normal, raised by the inverse metric: equation 2 in these coordinates.
        let normal = [-east, -south / weights.row, 1.0 / weights.up];
        let squared_normal = east * east + south * south / weights.row + 1.0 / weights.up;
        let height = self.height_over_face(k, goal);
        let shift = height / squared_normal;
        let (u, v) = (goal[0] - shift * normal[0], goal[1] - shift * normal[1]);

        let (first, second) = along_edges(k, u, v);
        if !(first >= 0.0 && second >= 0.0) {
            return None;
        }
        if first + second <= 1.0 {
            return Some((Minimum::OnFace { k, u, v }, height * shift));
        }
        Some(self.far_edge_minimum(k, goal, weights))
    }

    fn far_edge_minimum(&self, k: usize, goal: [f64; 3], weights: &Weights) -> (Minimum, f64) {
        let next = clockwise(k);
        let (start, end) = (self.edge_vector(k), self.edge_vector(next));
        let far_edge = beyond(end, start, 1.0);
        let from_start = beyond(goal, start, 1.0);
        let from_end = beyond(goal, end, 1.0);
        let share = weights.product(from_start, far_edge) / weights.squared(far_edge);
        let share = share.clamp(0.0, 1.0);
        let starts_nearer = weights.squared(from_start) < weights.squared(from_end);
        let nearest = if starts_nearer { k } else { next };
        let squared_distance = weights.squared(beyond(from_start, far_edge, share));
        (Minimum::BeyondFarEdge { k, share, nearest }, squared_distance)
    }
}

/// The vector to `goal` from the place at `share` of `edge`.
#[inline(always)]
fn beyond(goal: [f64; 3], edge: [f64; 3], share: f64) -> [f64; 3] {
    [goal[0] - share * edge[0], goal[1] - share * edge[1], goal[2] - share * edge[2]]
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use surface::Metric;

    fn ring(rises: [f64; 6]) -> Ring {
        Ring { column: 0, row: 0, elevation: 0.0, rises }
    }

    /// Cells as wide as long, or up to ten times longer or shorter, and relief up to ten times more or less.
    fn any_weights() -> impl Strategy<Value = Weights> {
        (-1.0f64..1.0, -1.0f64..1.0).prop_map(|(row, up)| {
            Weights::new(&Metric { column: 1.0, row: 10f64.powf(row), up: 10f64.powf(up) })
        })
    }

    /// Whether the end of edge `k` is taken for closer to `goal` than the vertex.
    fn end_is_closer(rises: [f64; 6], k: usize, goal: [f64; 3], weights: &Weights) -> bool {
        let ring = ring(rises);
        let product = ring.products(goal, weights)[k];
        let squared_length = ring.squared_lengths(weights)[k];
        ring.edge_toward(k, product, squared_length, goal, weights).end_is_closer
    }

    proptest! {
        #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

        #[test]
        fn the_minimum_of_a_far_edge_is_its_closest_point_and_names_its_closer_end(
            rises in prop::array::uniform6(-20.0f64..20.0),
            goal in prop::array::uniform3(-10.0f64..10.0),
            weights in any_weights(),
        ) {
            let ring = ring(rises);
            for k in 0..6 {
                let next = clockwise(k);
                let (start, end) = (ring.edge_vector(k), ring.edge_vector(next));
                let squared_distance = |share: f64| {
                    let at = [0, 1, 2].map(|axis| start[axis] + share * (end[axis] - start[axis]));
                    weights.squared(beyond(goal, at, 1.0))
                };
                let (Minimum::BeyondFarEdge { k: found, share, nearest }, squared) =
                    ring.far_edge_minimum(k, goal, &weights)
                else {
                    panic!("a far edge's minimum lies on the far edge");
                };
                prop_assert_eq!(found, k);
                let rounding = 1e-12 * (squared_distance(0.0) + squared_distance(1.0));
                prop_assert!((0.0..=1.0).contains(&share));
                prop_assert!((squared - squared_distance(share)).abs() <= rounding);
                for part in 0..=64 {
                    prop_assert!(squared <= squared_distance(f64::from(part) / 64.0) + rounding);
                }
                let closer = if squared_distance(0.0) <= squared_distance(1.0) { k } else { next };
                prop_assert_eq!(nearest, closer);
            }
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig { cases: 20_000, failure_persistence: None, ..ProptestConfig::default() })]

        /// Else a hand held still at equal distances would send the proxy to and fro for ever.
        #[test]
        fn of_two_vertices_at_equal_distance_at_most_one_is_taken_for_closer(
            k in 0usize..6,
            elevations in prop::array::uniform2(-1e7f64..1e7),
            aside in prop::array::uniform3(-1e3f64..1e3),
        ) {
            let weights = Weights::new(&Metric { column: 1.0, row: 1.0, up: 1.0 });
            let [here, there] = elevations;
            let edge = [EAST[k] as f64, SOUTH[k] as f64, there - here];
            // Halfway, and then aside at right angles.
            let share = 0.5 - weights.product(aside, edge) / weights.squared(edge);
            let goal = [0, 1, 2].map(|axis| aside[axis] + share * edge[axis]);
            let elevation = goal[2] + here;

            let opposite = (k + 3) % 6;
            let (mut rises, mut rises_there) = ([f64::NAN; 6], [f64::NAN; 6]);
            (rises[k], rises_there[opposite]) = (there - here, here - there);
            let from_here = [goal[0], goal[1], elevation - here];
            let from_there = [goal[0] - edge[0], goal[1] - edge[1], elevation - there];
            prop_assert!(
                !(end_is_closer(rises, k, from_here, &weights)
                    && end_is_closer(rises_there, opposite, from_there, &weights))
            );
        }
    }

    #[test]
    fn an_edge_between_two_holes_is_no_way() {
        // East is deep and close to the goal, but there is no ground beside the way to it.
        let mut rises = [-100.0, f64::NAN, 0.0, 0.0, 0.0, f64::NAN];
        let weights = Weights::new(&Metric { column: 1.0, row: 1.0, up: 1.0 });
        let goal = [-0.1, 0.0, -50.0];
        let taken = ring(rises).steepest_edge(goal, &weights).map(|edge| edge.k);
        assert_eq!(taken, Some(3), "west, where ground is");
        rises[1] = 0.0;
        let taken = ring(rises).steepest_edge(goal, &weights).map(|edge| edge.k);
        assert_eq!(taken, Some(0), "one face is enough");
    }
}
