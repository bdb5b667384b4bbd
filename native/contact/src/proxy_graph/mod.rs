//! The proxy graph: the contact model of the paper (section 3), on a heightfield.
//!
//! An update alternates between two searches (figure 7): *free-space minimisation* moves the proxy
//! straight to the goal until it meets a triangle, and *constrained minimisation* steps from vertex
//! to vertex along the edge that shortens the distance fastest, until a minimum is found on a
//! vertex, an edge or a face, or the way to the goal is free again.
//!
//! Where the paper leaves something open, or does not end:
//!
//! * A proxy that rests on a feature starts its free-space test from that feature: whether the goal
//!   is above the triangle ahead decides, never a distance from it (paper 3.5 takes the proxy "to be
//!   slightly above the surface").
//! * On rough ground the published graph can run in circles through free space. Free space
//!   re-entered from a vertex that was left before in the same update ends at the point that its
//!   ray hits.
//! * The border of the map is a wall for a proxy on the map: it slides along it and is not lost
//!   beyond it. A hole (void samples) can be fallen into, and is left again only upwards.
//! * A step budget bounds every update; what is left is walked in the next ones, which remember for
//!   as long as the goal stays what was visited: a circle may be longer than a budget.

mod ring;
mod visited;

use crate::contact::{Contact, ContactModel, Counters, MIN_STEP_BUDGET};
use crate::distance::Distance;
use crate::proxy::{Place, Proxy};
use crate::way::{ahead, cells_between, target};
use crate::weights::Weights;
use ring::{Minimum, Ring};
use surface::lattice::{clockwise, face};
use surface::ray::{RayEnd, Side, Start, cast};
use surface::{Grid, GridPoint, Heightfield, Metric, Sample, Triangle, on_heightfield};
use visited::{Visit, VisitedVertices};

/// The paper's contact model.
pub struct ProxyGraph {
    step_budget: u32,
    position: GridPoint,
    place: Place,
    /// Where the update before was to lead, if its budget did not reach so far.
    unfinished: Option<GridPoint>,
    /// Vertices from which updates toward this goal went into free space.
    left: VisitedVertices,
    /// Vertices from which they stepped over a far edge (paper 3.3).
    far_steps: VisitedVertices,
    /// How near the proxy was when one of the lists was full last.
    full_at: Option<Distance>,
}

/// How free-space minimisation went on.
enum FreeSpace {
    /// The proxy met this triangle, or rests on it.
    Blocked(Triangle),
    /// The update ends here.
    Ended,
}

/// How constrained minimisation went on.
enum Constrained {
    /// The way to the goal is free.
    Unobstructed,
    /// The update ends here.
    Ended,
}

/// What stays the same during one update.
struct Search<'a, S> {
    field: &'a Heightfield<'a, S>,
    weights: Weights,
    /// Where the hand is.
    goal: GridPoint,
}

impl ProxyGraph {
    /// A proxy at sample (0, 0), out of contact, that may visit `step_budget` vertices and
    /// free-space cells in one update (at least [`MIN_STEP_BUDGET`]).
    pub fn new(step_budget: u32) -> Self {
        Self {
            step_budget: step_budget.max(MIN_STEP_BUDGET),
            position: GridPoint::new(0.0, 0.0, 0.0),
            place: Place::Space(Side::Unknown),
            unfinished: None,
            left: VisitedVertices::new(),
            far_steps: VisitedVertices::new(),
            full_at: None,
        }
    }

    /// The same that stops after so many steps, also below the floor: for tools that trace its way. Such
    /// a proxy need not come to an end.
    pub fn stopping_after(steps: u32) -> Self {
        Self { step_budget: steps.max(1), ..Self::new(steps) }
    }

    fn minimise<S: Sample>(&mut self, search: &Search<S>, counters: &mut Counters) {
        self.recall(&search.goal);
        loop {
            let triangle = match self.free_space(search, counters) {
                FreeSpace::Blocked(triangle) => triangle,
                FreeSpace::Ended => return,
            };
            let nearest = search.nearest_corner(&triangle);
            match self.constrained(search, nearest, counters) {
                Constrained::Unobstructed => {}
                Constrained::Ended => return,
            }
        }
    }

    /// Forgets which vertices were visited, unless this update goes on with one that was not finished:
    /// a circle may be longer than a budget. A full list is from a long way, and begins anew.
    fn recall(&mut self, goal: &GridPoint) {
        let goes_on = self.unfinished.take() == Some(*goal);
        for visited in [&mut self.left, &mut self.far_steps] {
            if !goes_on || visited.is_full() {
                visited.clear();
            }
        }
        if !goes_on {
            self.full_at = None;
        }
    }

    /// Whether a vertex, where the proxy is, was visited before. Where a list has no room for it, the
    /// way there was long, and `None` leaves the rest of it to the next update; if it came no nearer since
    /// that happened last, it is a circle longer than the list.
    fn was_before<S: Sample>(
        &mut self,
        search: &Search<S>,
        target: &GridPoint,
        visit: Visit,
        counters: &mut Counters,
    ) -> Option<bool> {
        if visit != Visit::NoRoom {
            return Some(visit == Visit::Again);
        }
        let distance = Distance::new(&self.position, target, &search.weights);
        let before = self.full_at.replace(distance);
        if before.is_some_and(|before| !distance.is_less_than(&before)) {
            return Some(true);
        }
        counters.steps_left = cells_between(&self.position, target);
        None
    }

    /// Moves the proxy straight toward the goal until it meets a triangle (paper 3.2).
    fn free_space<S: Sample>(&mut self, search: &Search<S>, counters: &mut Counters) -> FreeSpace {
        let target = target(search.field, &self.position, &search.goal);
        if counters.steps() >= self.step_budget {
            counters.steps_left = cells_between(&self.position, &target);
            return FreeSpace::Ended;
        }
        counters.collision_tests += 1;
        let start = match self.ahead(search, &target) {
            Some((triangle, true)) => return FreeSpace::Blocked(triangle),
            Some((triangle, false)) => Start::Surface(triangle),
            None => match self.place {
                Place::Space(side) => Start::Space(side),
                _ => Start::Space(Side::Unknown),
            },
        };
        let visit = match self.place {
            Place::Vertex { column, row } => self.left.visit(column, row),
            _ => Visit::First,
        };
        let Some(is_second_time) = self.was_before(search, &target, visit, counters) else {
            return FreeSpace::Ended;
        };

        let most_cells = self.step_budget - counters.steps();
        let ray = cast(search.field, &self.position, start, &target, most_cells);
        counters.cells += ray.cells;
        match ray.end {
            RayEnd::Hit(triangle, point) => {
                (self.position, self.place) = (point, Place::Face(triangle));
                if is_second_time {
                    counters.cycles_ended += 1;
                    return FreeSpace::Ended;
                }
                FreeSpace::Blocked(triangle)
            }
            RayEnd::Clear(side) => {
                (self.position, self.place) = (search.goal, Place::Space(side));
                FreeSpace::Ended
            }
            RayEnd::OutOfSteps(point, side) => {
                (self.position, self.place) = (point, Place::Space(side));
                counters.steps_left = cells_between(&point, &target);
                FreeSpace::Ended
            }
        }
    }

    /// For a proxy on the surface: the triangle that the way to `target` leads over, and whether
    /// that triangle blocks it. At a vertex its ring is asked, as constrained minimisation asks it:
    /// two answers that differ by rounding would send the proxy to and fro.
    fn ahead<S: Sample>(&self, search: &Search<S>, target: &GridPoint) -> Option<(Triangle, bool)> {
        let Place::Vertex { column, row } = self.place else {
            return ahead(search.field, &self.proxy(), target);
        };
        let ring = Ring::new(search.field, column, row);
        let goal = target.relative_to(column, row, ring.elevation());
        let k = ring.face_toward(goal[0], goal[1]);
        Some((face(column, row, k), ring.blocks(k, goal)))
    }

    /// Steps from vertex to vertex, nearer and nearer to the goal (paper 3.2, figure 8).
    fn constrained<S: Sample>(
        &mut self,
        search: &Search<S>,
        (mut column, mut row): (i64, i64),
        counters: &mut Counters,
    ) -> Constrained {
        let target = search.field.nearest_on_map(&search.goal);
        loop {
            let ring = Ring::new(search.field, column, row);
            if counters.steps() >= self.step_budget {
                self.stand_on(&ring);
                counters.steps_left = cells_between(&self.position, &target);
                return Constrained::Ended;
            }
            counters.vertices += 1;

            let goal = target.relative_to(column, row, ring.elevation());
            if !ring.blocks(ring.face_toward(goal[0], goal[1]), goal) {
                self.stand_on(&ring);
                return Constrained::Unobstructed;
            }
            let Some(edge) = ring.steepest_edge(goal, &search.weights) else {
                self.stand_on(&ring);
                return Constrained::Ended;
            };
            if edge.end_is_closer {
                (column, row) = ring.neighbour(edge.k);
                continue;
            }
            match ring.minimum_beside(&edge, goal, &search.weights) {
                Minimum::OnEdge { k, share } => {
                    self.rest_on_edge(&ring, k, share);
                    return Constrained::Ended;
                }
                Minimum::OnFace { k, u, v } => {
                    self.rest_on_face(&ring, k, u, v);
                    return Constrained::Ended;
                }
                Minimum::BeyondFarEdge { k, share, nearest } => {
                    let visit = self.far_steps.visit(column, row);
                    if visit == Visit::NoRoom {
                        self.stand_on(&ring);
                    }
                    let Some(is_loop) = self.was_before(search, &target, visit, counters) else {
                        return Constrained::Ended;
                    };
                    counters.far_edge_crossings += 1;
                    if is_loop {
                        counters.far_edge_loops += 1;
                        self.rest_on_far_edge(search.field, &ring, k, share);
                        return Constrained::Ended;
                    }
                    (column, row) = ring.neighbour(nearest);
                }
            }
        }
    }

    /// Rests at the ring's vertex.
    fn stand_on(&mut self, ring: &Ring) {
        let ((column, row), elevation) = (ring.vertex(), ring.elevation());
        self.position = GridPoint { column, row, u: 0.0, v: 0.0, elevation };
        self.place = Place::Vertex { column, row };
    }

    /// Rests at `share` of edge `k`.
    fn rest_on_edge(&mut self, ring: &Ring, k: usize, share: f64) {
        let (column, row) = ring.vertex();
        self.position = ring.point_on_edge(k, share);
        self.place = Place::Edge { column, row, k };
    }

    /// Rests on face `k`, `u` columns east and `v` rows south of the ring's vertex.
    fn rest_on_face(&mut self, ring: &Ring, k: usize, u: f64, v: f64) {
        let (column, row) = ring.vertex();
        self.position = ring.point_on_face(k, u, v);
        self.place = Place::Face(face(column, row, k));
    }

    /// Rests on the edge of face `k` that does not touch the ring's vertex, at `share` from the end
    /// of edge `k` to the end of edge `k + 1`.
    fn rest_on_far_edge<S: Sample>(
        &mut self,
        field: &Heightfield<S>,
        ring: &Ring,
        k: usize,
        share: f64,
    ) {
        let (column, row) = ring.neighbour(k);
        // From the end of edge k to the end of edge k + 1 it is one step along edge k + 2.
        let along = clockwise(clockwise(k));
        self.rest_on_edge(&Ring::new(field, column, row), along, share);
    }
}

impl ContactModel for ProxyGraph {
    fn name(&self) -> &'static str {
        "proxy_graph"
    }

    fn proxy(&self) -> Proxy {
        Proxy { position: self.position, place: self.place }
    }

    fn take_over(&mut self, proxy: Proxy) {
        (self.position, self.place) = (proxy.position, proxy.place);
        self.unfinished = None;
    }

    fn update(&mut self, grid: &Grid, metric: &Metric, goal: &GridPoint) -> Contact {
        let mut counters = Counters::default();
        if goal.is_finite() && metric.is_valid() {
            let weights = Weights::new(metric);
            on_heightfield!(grid, field => {
                self.minimise(&Search { field: &field, weights, goal: *goal }, &mut counters)
            });
            self.unfinished = (counters.steps_left > 0).then_some(*goal);
        }
        Contact::new(self.position, self.place.feature(), goal, metric, counters)
    }
}

impl<S: Sample> Search<'_, S> {
    /// The corner of a triangle that is closest to the goal (paper 3.2).
    fn nearest_corner(&self, triangle: &Triangle) -> (i64, i64) {
        let target = self.field.nearest_on_map(&self.goal);
        let squared_distance = |&(column, row): &(i64, i64)| {
            let elevation = self.field.elevation(column, row);
            self.weights.squared(target.relative_to(column, row, elevation))
        };
        let corners = triangle.corners();
        let mut nearest = (corners[0], squared_distance(&corners[0]));
        for corner in &corners[1..] {
            let distance = squared_distance(corner);
            if distance < nearest.1 {
                nearest = (*corner, distance);
            }
        }
        nearest.0
    }
}
