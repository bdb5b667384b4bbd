//! The god-object without constraint release (paper 2.3; Zilles and Salisbury 1995).
//!
//! In each update the god-object moves straight toward the goal. Each triangle that it meets adds its
//! plane to the constraints, and from then on the goal is the hand's closest point on the
//! intersection of these planes, by Lagrange multipliers. Three planes leave a single point.
//!
//! A plane goes on beyond its triangle, and stays a constraint until the update ends. So the proxy
//! *floats* where the surface falls away from the plane, and *sticks* where it rises toward it (paper
//! figure 4): on ground of many small triangles the hand feels a viscosity that is not there. Both are
//! kept on purpose, to be felt and measured; [`GodObjectRelease`](crate::GodObjectRelease) has
//! neither. The next update begins with no constraints, wherever the proxy is, unless it finishes one
//! that the step budget cut short.
//!
//! Where the paper leaves something open:
//!
//! * A ray from a proxy on the surface starts from the feature that it rests on, never from an
//!   epsilon; a floating proxy is in space above.
//! * Planes that are singular together fix no more than the newest of them (parallel ones are the
//!   same constraint): older ones give way to it. In a cleft so steep that its sides are parallel to
//!   rounding they would give way to each other for ever: a proxy that is stopped again and again in
//!   one place, and comes no nearer, stays there.
//! * The border of the map is a wall for a proxy on the map, and one of the three constraints. Over
//!   a hole no plane holds: what slides out over it is out of contact, and goes on freely.
//! * Of a floating proxy [`Feature`] tells how many planes hold it: a face one, an edge two, a vertex
//!   three. It is not on what the plane belongs to any more, but it is not free.

mod constraints;

use crate::contact::{Contact, ContactModel, Counters, Feature, MIN_STEP_BUDGET};
use crate::distance::Distance;
use crate::planes::{Scale, project};
use crate::proxy::{Place, Proxy};
use crate::way::{ahead, cells_between, target};
use crate::weights::Weights;
use constraints::{Constraints, Wall};
use surface::ray::{RayEnd, Side, Start, cast};
use surface::{Grid, GridPoint, Heightfield, Metric, Sample, on_heightfield};

/// Stops in one place. What can stop a proxy there is six triangles around a vertex and, in a corner
/// of the map, two walls: one that is stopped more often goes in circles.
const MOST_STOPS: u32 = 8;

/// The god-object without constraint release.
pub struct GodObject {
    step_budget: u32,
    proxy: Proxy,
    /// What held it last.
    feature: Feature,
    unfinished: Option<Unfinished>,
}

/// An update whose budget ended before it did: the next one with the same goal goes on with it.
#[derive(Clone, Copy)]
struct Unfinished {
    goal: GridPoint,
    metric: Metric,
    progress: Progress,
}

/// How far an update is.
#[derive(Clone, Copy)]
struct Progress {
    constraints: Constraints,
    /// Since the proxy last came nearer.
    stops: u32,
}

/// What stays the same during one update.
struct Search<'a, S> {
    field: &'a Heightfield<'a, S>,
    scale: Scale,
    weights: Weights,
    /// Where the hand is.
    goal: GridPoint,
    /// What the proxy moves toward: as near to the hand as the map goes.
    target: GridPoint,
}

/// How a move ended.
enum Move {
    /// A triangle or a wall stopped it: there is a constraint more.
    Stopped,
    /// It slid out over a hole, where no constraint is left.
    Released,
    /// The update ends here.
    Ended,
}

impl GodObject {
    /// A proxy at sample (0, 0), out of contact, that may take `step_budget` steps in one update (at
    /// least [`MIN_STEP_BUDGET`]): projections, and cells of collision tests.
    pub fn new(step_budget: u32) -> Self {
        let proxy = Proxy::in_space(GridPoint::new(0.0, 0.0, 0.0));
        let step_budget = step_budget.max(MIN_STEP_BUDGET);
        Self { step_budget, proxy, feature: Feature::Free, unfinished: None }
    }

    /// Goes on from `progress`, and gives what is reached of it.
    fn minimise<S: Sample>(
        &mut self,
        search: &Search<S>,
        progress: Progress,
        counters: &mut Counters,
    ) -> Progress {
        let Progress { mut constraints, mut stops } = progress;
        while constraints.count < 3 && stops <= MOST_STOPS {
            if counters.steps() >= self.step_budget {
                counters.steps_left = cells_between(&self.proxy.position, &search.target);
                break;
            }
            let Some(goal) = search.constrained_goal(&constraints) else { break };
            if constraints.count > 0 {
                counters.faces += 1;
                if !search.is_nearer(&goal, &self.proxy.position) {
                    break;
                }
            }
            let before = self.proxy.position;
            match self.move_toward(search, goal, &mut constraints, counters) {
                Move::Ended => break,
                Move::Released => constraints = Constraints::none(),
                Move::Stopped => {}
            }
            stops = if search.is_nearer(&self.proxy.position, &before) { 0 } else { stops + 1 };
        }
        Progress { constraints, stops }
    }

    /// Where to go on: with what held the proxy when the budget ended, or with nothing.
    fn progress(&self, goal: &GridPoint, metric: &Metric) -> Progress {
        match self.unfinished {
            Some(last) if last.goal == *goal && last.metric == *metric => last.progress,
            _ => Progress { constraints: Constraints::none(), stops: 0 },
        }
    }

    /// Moves the proxy straight toward its constrained goal, until it meets a triangle or a wall.
    fn move_toward<S: Sample>(
        &mut self,
        search: &Search<S>,
        goal: GridPoint,
        constraints: &mut Constraints,
        counters: &mut Counters,
    ) -> Move {
        let wall = search.wall_before(&self.proxy.position, &goal);
        let end = wall.map_or(goal, |wall| wall.point);
        counters.collision_tests += 1;
        let start = match (ahead(search.field, &self.proxy, &end), self.proxy.place) {
            (Some((triangle, true)), _) if !constraints.hold(&triangle) => {
                constraints.add_triangle(search.field, &search.scale, triangle);
                return Move::Stopped;
            }
            (Some((triangle, _)), _) => Start::Surface(triangle),
            (None, Place::Space(side)) => Start::Space(side),
            (None, _) => Start::Space(Side::Unknown),
        };
        let most_cells = self.step_budget - counters.steps();
        let ray = cast(search.field, &self.proxy.position, start, &end, most_cells);
        counters.cells += ray.cells;
        match ray.end {
            RayEnd::Hit(triangle, position) => {
                let came_nearer = search.is_nearer(&position, &self.proxy.position);
                self.proxy = Proxy { position, place: Place::Face(triangle) };
                if !constraints.hold(&triangle) {
                    constraints.add_triangle(search.field, &search.scale, triangle);
                } else if !came_nearer {
                    return Move::Ended;
                }
                // One met again by rounding is where the next ray starts.
                Move::Stopped
            }
            RayEnd::OutOfSteps(position, side) => {
                self.proxy = Proxy { position, place: Place::Space(side) };
                counters.steps_left = cells_between(&position, &end);
                // Over a hole, or under the ground behind it, it is held no more.
                if side != Side::Above {
                    *constraints = Constraints::none();
                }
                Move::Ended
            }
            RayEnd::Clear(side) if constraints.count == 0 => {
                self.proxy = Proxy { position: search.goal, place: Place::Space(side) };
                Move::Ended
            }
            RayEnd::Clear(Side::Above) => {
                let place = constraints.place_at(search.field, &end);
                self.proxy = Proxy { position: end, place };
                let Some(wall) = wall else { return Move::Ended };
                constraints.add_wall(&search.scale, &wall);
                Move::Stopped
            }
            RayEnd::Clear(side) => {
                self.proxy = Proxy { position: end, place: Place::Space(side) };
                Move::Released
            }
        }
    }
}

impl ContactModel for GodObject {
    fn name(&self) -> &'static str {
        "god_object"
    }

    fn proxy(&self) -> Proxy {
        self.proxy
    }

    fn take_over(&mut self, proxy: Proxy) {
        self.proxy = proxy;
        self.feature = proxy.place.feature();
        self.unfinished = None;
    }

    fn update(&mut self, grid: &Grid, metric: &Metric, goal: &GridPoint) -> Contact {
        let mut counters = Counters::default();
        if goal.is_finite() && metric.is_valid() {
            let progress = self.progress(goal, metric);
            let progress = on_heightfield!(grid, field => {
                let target = target(&field, &self.proxy.position, goal);
                let search = Search {
                    field: &field,
                    scale: Scale::new(metric),
                    weights: Weights::new(metric),
                    goal: *goal,
                    target,
                };
                self.minimise(&search, progress, &mut counters)
            });
            self.feature = progress.constraints.feature();
            let is_unfinished = counters.steps_left > 0;
            self.unfinished =
                is_unfinished.then_some(Unfinished { goal: *goal, metric: *metric, progress });
        }
        Contact::new(self.proxy.position, self.feature, goal, metric, counters)
    }
}

impl<S: Sample> Search<'_, S> {
    /// The hand's closest point under the constraints.
    fn constrained_goal(&self, constraints: &Constraints) -> Option<GridPoint> {
        if constraints.count == 0 {
            return Some(self.target);
        }
        let pivot = &constraints.pivot;
        let goal = self.scale.between(pivot, &self.target);
        let [columns, rows, up] = self.scale.on_grid(project(goal, constraints.planes())?);
        let elevation = pivot.elevation + up;
        let point = GridPoint::from_sample(pivot.column, pivot.row, columns, rows, elevation);
        let point =
            if constraints.hold_a_wall() { self.field.nearest_on_map(&point) } else { point };
        let point = GridPoint { elevation: constraints.elevation_at(self.field, &point), ..point };
        point.is_finite().then_some(point)
    }

    /// Whether `place` is nearer to the target than `other`, by more than rounding.
    fn is_nearer(&self, place: &GridPoint, other: &GridPoint) -> bool {
        let distance = |place| Distance::new(place, &self.target, &self.weights);
        distance(place).is_less_than(&distance(other))
    }

    /// Where a way from a place on the map leaves the map, if it does.
    fn wall_before(&self, from: &GridPoint, to: &GridPoint) -> Option<Wall> {
        let border = self.field.nearest_on_map(to);
        if border == *to || !self.field.is_on_map(from) {
            return None;
        }
        let [columns, rows, up] = to.relative_to(from.column, from.row, from.elevation);
        let way = [columns - from.u, rows - from.v];
        let on_map = border.relative_to(from.column, from.row, 0.0);
        let share = |axis: usize, start: f64, end: f64| {
            let leaves = end != on_map[axis];
            if leaves { (on_map[axis] - start) / way[axis] } else { f64::INFINITY }
        };
        let by_column = share(0, from.u, columns);
        let by_row = share(1, from.v, rows);
        let at = by_column.min(by_row).clamp(0.0, 1.0);
        let (u, v) = (from.u + at * way[0], from.v + at * way[1]);
        let elevation = from.elevation + at * up;
        let point = GridPoint::from_sample(from.column, from.row, u, v, elevation);
        let mut point = self.field.nearest_on_map(&point);
        // Exactly on the border that stops it.
        let normal = if by_column <= by_row {
            (point.column, point.u) = (border.column, border.u);
            [-way[0].signum(), 0.0, 0.0]
        } else {
            (point.row, point.v) = (border.row, border.v);
            [0.0, way[1].signum(), 0.0]
        };
        Some(Wall { point, normal })
    }
}
