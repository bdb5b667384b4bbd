//! The god-object with constraint release (paper 2.3): exact in the end, at one collision test for
//! each triangle crossed.
//!
//! The god-object slides in the planes of the triangles that it touches toward the goal's
//! orthogonal projection on them. A collision test (a ray, paper 3.5) looks along each slide that
//! leaves its triangle. If it meets another triangle, that adds its plane, and the two are
//! held together; else the plane is released with its triangle, and the god-object comes down on
//! what lies beyond. Of the planes that touch, those are held whose Lagrange multipliers push, and
//! not pull (Zilles and Salisbury 1995): on an edge one plane or the line in which two meet, on a
//! vertex one, two, or the point in which three meet. Where several sets of planes could be held, the
//! one along which the distance falls fastest is.
//!
//! Where the paper leaves something open, or does not end:
//!
//! * "Released once the proxy is no longer in contact" runs in circles at creases and vertices, where
//!   planes take turns at holding and being released with no way gone. The squared distance to the
//!   goal has to fall by more than its rounding error within [`IDLE_STEPS`] steps, or the update ends
//!   where it last fell. So an update is passive, and a still hand gives the same proxy bit for bit.
//! * The planes that touch are named by the feature that the proxy rests on, never by a distance.
//! * Beside a hole and at the map's border the edge itself holds the proxy, as long as the triangle
//!   is in its straight way to the goal: as in the proxy graph.
//!
//! The collision test knows nothing of neighbours, as in the paper. On a heightfield the plane of the
//! one triangle behind the edge would tell the same; a model that walks by neighbours alone needs
//! no collision test in contact at all. The difference in time is what this model is here to show.

mod constraint;

use crate::contact::{Contact, ContactModel, Counters, MIN_STEP_BUDGET};
use crate::distance::Distance;
use crate::proxy::{Place, Proxy};
use crate::way::{ahead, cells_between, target};
use crate::weights::Weights;
use constraint::{Constraint, Exit, Line, Slide};
use surface::lattice::{clockwise, counterclockwise, face};
use surface::ray::{RayEnd, Side, Start, cast};
use surface::{Grid, GridPoint, Heightfield, Metric, Sample, on_heightfield};

/// Steps in a row that may bring the proxy no nearer: to a hit, to the hit triangle's edge, onto its
/// neighbour, and once around a vertex's six faces would be more.
const IDLE_STEPS: u32 = 6;

/// Cells that a collision test along a slide looks at: the triangle behind an edge is in the same
/// cell as the one before it, or in the next.
const CELLS_AHEAD: u32 = 2;

/// A vertex and the ends of its six edges, columns and rows from it.
const AROUND: [(i64, i64); 7] = [(0, 0), (1, 0), (1, 1), (0, 1), (-1, 0), (-1, -1), (0, -1)];

/// The god-object with constraint release.
pub struct GodObjectRelease {
    step_budget: u32,
    proxy: Proxy,
}

/// What stays the same during one update.
struct Search<'a, S> {
    field: &'a Heightfield<'a, S>,
    weights: Weights,
    /// Where the hand is.
    goal: GridPoint,
}

/// What holds the proxy.
enum Held {
    /// Nothing: the way to the goal is free, and begins so.
    Free(Start),
    /// The plane of a triangle, and the way in it.
    Face(Constraint, Slide),
    /// The line in which the planes beside an edge meet.
    Edge(Line),
    /// The planes of a vertex: a minimum.
    Vertex,
}

/// How a step went.
enum Step {
    /// There may be more to gain.
    GoOn,
    /// The update ends here.
    Ended,
}

impl GodObjectRelease {
    /// A proxy at sample (0, 0), out of contact, that may take `step_budget` steps in one update (at
    /// least [`MIN_STEP_BUDGET`]): planes looked at for what holds it, and cells of collision tests.
    pub fn new(step_budget: u32) -> Self {
        let proxy = Proxy::in_space(GridPoint::new(0.0, 0.0, 0.0));
        Self { step_budget: step_budget.max(MIN_STEP_BUDGET), proxy }
    }

    fn minimise<S: Sample>(&mut self, search: &Search<S>, counters: &mut Counters) {
        let target = target(search.field, &self.proxy.position, &search.goal);
        let mut nearest =
            (self.proxy, Distance::new(&self.proxy.position, &target, &search.weights));
        let mut idle_steps = 0;
        loop {
            if counters.steps() + self.proxy.place.planes() > self.step_budget {
                // Where it came nearest, so that every update gains: an idle tail may lead away.
                self.proxy = nearest.0;
                counters.steps_left = cells_between(&self.proxy.position, &target);
                return;
            }
            let before = self.proxy;
            if let Step::Ended = self.step(search, &target, counters) {
                return;
            }
            let distance = Distance::new(&self.proxy.position, &target, &search.weights);
            if distance.is_less_than(&nearest.1) {
                (nearest, idle_steps) = ((self.proxy, distance), 0);
                continue;
            }
            idle_steps += 1;
            if self.proxy == before || idle_steps == IDLE_STEPS {
                counters.cycles_ended += u32::from(self.proxy != before);
                self.proxy = nearest.0;
                return;
            }
        }
    }

    fn step<S: Sample>(
        &mut self,
        search: &Search<S>,
        target: &GridPoint,
        counters: &mut Counters,
    ) -> Step {
        let held = search.held(&self.proxy, target);
        if !matches!(held, Held::Free(_)) {
            counters.faces += self.proxy.place.planes();
        }
        match held {
            Held::Free(start) => self.free_move(search, target, start, counters),
            Held::Face(constraint, slide) => self.slide(search, &constraint, &slide, counters),
            Held::Edge(line) => {
                self.slide_along(search, target, &line);
                Step::GoOn
            }
            Held::Vertex => Step::GoOn,
        }
    }

    /// Moves the proxy straight toward the goal until it meets a triangle.
    fn free_move<S: Sample>(
        &mut self,
        search: &Search<S>,
        target: &GridPoint,
        start: Start,
        counters: &mut Counters,
    ) -> Step {
        counters.collision_tests += 1;
        let most_cells = self.step_budget - counters.steps();
        let ray = cast(search.field, &self.proxy.position, start, target, most_cells);
        counters.cells += ray.cells;
        match ray.end {
            RayEnd::Hit(triangle, position) => {
                self.proxy = Proxy { position, place: Place::Face(triangle) };
                Step::GoOn
            }
            RayEnd::Clear(side) => {
                self.proxy = Proxy { position: search.goal, place: Place::Space(side) };
                Step::Ended
            }
            RayEnd::OutOfSteps(position, side) => {
                self.proxy = Proxy { position, place: Place::Space(side) };
                counters.steps_left = cells_between(&position, target);
                Step::Ended
            }
        }
    }

    /// Slides in the plane of a triangle to the goal's projection, or to the triangle's edge.
    fn slide<S: Sample>(
        &mut self,
        search: &Search<S>,
        constraint: &Constraint,
        slide: &Slide,
        counters: &mut Counters,
    ) -> Step {
        let foot = constraint.foot(slide);
        if !foot.is_finite() {
            return Step::GoOn;
        }
        match constraint.exit(slide) {
            Exit::None => {
                let place = Place::Face(constraint.triangle());
                self.proxy = Proxy { position: foot, place };
            }
            Exit::Vertex(column, row) => self.stand_on(search.field, (column, row)),
            Exit::Edge { vertex, k, share } => {
                let Some(line) = Line::new(search.field, vertex, k) else {
                    return Step::Ended;
                };
                let is_met = self.meets_another(search, constraint, &foot, counters);
                self.rest_on(&line, share);
                let beyond = line.other_side(&constraint.triangle());
                if !is_met && search.field.is_present(&beyond) {
                    // Released, and come down behind the edge.
                    self.proxy.place = Place::Face(beyond);
                }
            }
        }
        Step::GoOn
    }

    /// The collision test of a slide: whether a triangle behind the edge is in its way.
    fn meets_another<S: Sample>(
        &self,
        search: &Search<S>,
        constraint: &Constraint,
        foot: &GridPoint,
        counters: &mut Counters,
    ) -> bool {
        counters.collision_tests += 1;
        let most_cells = CELLS_AHEAD.min(self.step_budget.saturating_sub(counters.steps()));
        let start = Start::Surface(constraint.triangle());
        let ray = cast(search.field, &self.proxy.position, start, foot, most_cells);
        counters.cells += ray.cells;
        matches!(ray.end, RayEnd::Hit(..))
    }

    /// Slides along the line in which two planes meet, as far as their edge goes.
    fn slide_along<S: Sample>(&mut self, search: &Search<S>, target: &GridPoint, line: &Line) {
        let share = line.closest_share(target, &search.weights);
        if share <= 0.0 {
            self.stand_on(search.field, line.start());
        } else if share >= 1.0 {
            self.stand_on(search.field, line.end());
        } else {
            self.rest_on(line, share);
        }
    }

    fn rest_on(&mut self, line: &Line, share: f64) {
        self.proxy = Proxy { position: line.point(share), place: line.place() };
    }

    fn stand_on<S: Sample>(&mut self, field: &Heightfield<S>, (column, row): (i64, i64)) {
        let elevation = field.elevation(column, row);
        let position = GridPoint { column, row, u: 0.0, v: 0.0, elevation };
        self.proxy = Proxy { position, place: Place::Vertex { column, row } };
    }
}

impl ContactModel for GodObjectRelease {
    fn name(&self) -> &'static str {
        "god_object_release"
    }

    fn proxy(&self) -> Proxy {
        self.proxy
    }

    fn take_over(&mut self, proxy: Proxy) {
        self.proxy = proxy;
    }

    fn update(&mut self, grid: &Grid, metric: &Metric, goal: &GridPoint) -> Contact {
        let mut counters = Counters::default();
        if goal.is_finite() && metric.is_valid() {
            let weights = Weights::new(metric);
            on_heightfield!(grid, field => {
                self.minimise(&Search { field: &field, weights, goal: *goal }, &mut counters)
            });
        }
        let Proxy { position, place } = self.proxy;
        Contact::new(position, place.feature(), goal, metric, counters)
    }
}

impl<S: Sample> Search<'_, S> {
    /// The planes that hold a proxy off its target.
    fn held(&self, proxy: &Proxy, target: &GridPoint) -> Held {
        if let Place::Face(triangle) = proxy.place {
            return match Constraint::new(self.field, triangle) {
                Some(plane) if plane.height_of(target) <= 0.0 => {
                    let slide = plane.slide(&proxy.position, target, &self.weights);
                    Held::Face(plane, slide)
                }
                _ => Held::Free(Start::Surface(triangle)),
            };
        }
        match (ahead(self.field, proxy, target), proxy.place) {
            (Some((_, true)), Place::Edge { column, row, k }) => {
                self.held_on_edge(proxy, target, (column, row), k)
            }
            (Some((_, true)), Place::Vertex { column, row }) => {
                self.held_on_vertex(proxy, target, (column, row))
            }
            (Some((triangle, _)), _) => Held::Free(Start::Surface(triangle)),
            (None, Place::Space(side)) => Held::Free(Start::Space(side)),
            (None, _) => Held::Free(Start::Space(Side::Unknown)),
        }
    }

    fn held_on_edge(
        &self,
        proxy: &Proxy,
        target: &GridPoint,
        (column, row): (i64, i64),
        k: usize,
    ) -> Held {
        let mut best = Best::default();
        for k in [k, counterclockwise(k)] {
            best.try_plane(self, proxy, target, Constraint::new(self.field, face(column, row, k)));
        }
        match (best.held, Line::new(self.field, (column, row), k)) {
            (Some((plane, slide)), _) => Held::Face(plane, slide),
            (None, Some(line)) => Held::Edge(line),
            (None, None) => Held::Vertex,
        }
    }

    fn held_on_vertex(&self, proxy: &Proxy, target: &GridPoint, vertex: (i64, i64)) -> Held {
        let (column, row) = vertex;
        // The samples around are read once for all six planes and lines.
        let [here, around @ ..] = self.field.elevations_near(column, row, AROUND);
        let mut best = Best::default();
        for k in 0..6 {
            let corners = corners_of_face(k, here, around);
            let plane = Constraint::through(face(column, row, k), corners);
            best.try_plane(self, proxy, target, plane);
        }
        let on_face = |(plane, slide)| Held::Face(plane, slide);
        let mut held = best.held.map_or(Held::Vertex, on_face);
        for (k, end) in around.into_iter().enumerate() {
            let Some(line) = Line::between(vertex, k, here, end) else { continue };
            let share = line.closest_share(target, &self.weights);
            let gain = share * share * line.squared_length(&self.weights);
            if share > 0.0 && gain > best.gain && line.has_face(self.field) {
                best.gain = gain;
                held = Held::Edge(line);
            }
        }
        held
    }
}

/// Elevations of the corners of a vertex's face `k`, in the order of `Triangle::corners`: `here` is
/// the vertex's own, `around` those of its neighbours.
#[inline(always)]
fn corners_of_face(k: usize, here: f64, around: [f64; 6]) -> [f64; 3] {
    let (first, second) = (around[k], around[clockwise(k)]);
    match k {
        0 | 1 => [here, first, second],
        2 | 3 => [second, here, first],
        _ => [first, second, here],
    }
}

/// Of several planes, the one along which the distance falls fastest.
#[derive(Default)]
struct Best {
    held: Option<(Constraint, Slide)>,
    /// Squared length of the slide, cell widths: of all ways from one place, the longest one to a
    /// projection of the goal is the steepest.
    gain: f64,
}

impl Best {
    #[inline(always)]
    fn try_plane<S: Sample>(
        &mut self,
        search: &Search<S>,
        proxy: &Proxy,
        target: &GridPoint,
        plane: Option<Constraint>,
    ) {
        let Some(plane) = plane else { return };
        let slide = plane.slide(&proxy.position, target, &search.weights);
        if !slide.leads_inside() {
            return;
        }
        let gain = plane.gain(&slide, &proxy.position, &search.weights);
        if gain > self.gain {
            *self = Self { held: Some((plane, slide)), gain };
        }
    }
}
