//! The surface walk: steepest descent of the distance to the goal, exactly, over faces, edges and
//! vertices by adjacency alone.
//!
//! Free space is the paper's (3.2, 3.5): a straight move, stopped by the first triangle it meets.
//! On the surface the proxy then goes downhill in the distance to the goal, continuously: straight
//! across a face toward the goal's foot on its plane, along an edge where both faces draw toward it,
//! from a vertex along the steepest of the ways around it. It ends at a local minimum of the
//! distance, or where the straight way to the goal is open.
//!
//! Because the distance falls on every part of the way, it never grows by more than the goal moves:
//! the proxy gives the hand no energy that the hand did not bring (paper 3.4 claims this of the
//! proxy graph, where it does not hold). A goal that is still is answered with the same proxy, bit
//! for bit, from the update on that has no steps left.
//!
//! "Local minimum" is meant to within rounding: on ground up to a thousand million cells high no test
//! finds a nearer place around the proxy. Higher ground has minima whose depth is below all rounding, and
//! whether the walk stops in one of them is chance.
//!
//! * [`section`]: the long way, along the straight section toward the goal while that descends gently.
//! * [`sub_steps`]: the goal led over its way in parts.
//! * [`descent`]: steepest descent from face to face.
//! * [`face`]: a triangle and the goal's foot on its plane.
//! * [`foresight`]: samples asked for an update before they are needed.

#![allow(
    clippy::neg_cmp_op_on_partial_ord,
    clippy::nonminimal_bool,
    reason = "an absent triangle is NaN, and what is not held to be true of it is the point"
)]

mod descent;
mod face;
mod foresight;
mod search;
mod section;
mod sub_steps;

use crate::contact::{Contact, ContactModel, Counters, MIN_STEP_BUDGET};
use crate::proxy::{Place, Proxy};
use crate::way::cells_between;
use crate::weights::Weights;
use descent::Descent;
use foresight::Foresight;
use search::Search;
use sub_steps::SubSteps;
use surface::ray::{RayEnd, Start, cast};
use surface::{Grid, GridPoint, Metric, Sample, on_heightfield};

/// The exact walk over the surface.
pub struct SurfaceWalk {
    step_budget: u32,
    /// Cells.
    sub_step: Option<f64>,
    proxy: Proxy,
    metric: Metric,
    /// Of the metric; `None` where that is none.
    weights: Option<Weights>,
    /// The goal that the proxy follows.
    followed: Option<GridPoint>,
    foresight: Foresight,
    /// It is at rest with the goal that it follows.
    is_at_rest: bool,
    /// How the descent toward that goal went on, where the budget ended before it did.
    unfinished: Option<Progress>,
}

/// Whether a descent still comes nearer.
#[derive(Clone, Copy)]
struct Progress {
    /// The smallest squared distance at which it came by a vertex.
    nearest: f64,
    /// Vertices since then.
    stalls: u32,
}

/// A circle around a vertex has six neighbours; where heights drown what is level, more than one may be
/// level in turn.
const MOST_STALLS: u32 = 12;

/// Cells; a sub-step is not shorter. A budget of steps would not take a hand anywhere in shorter ones, and
/// touch nothing in doing so.
pub const MIN_SUB_STEP: f64 = 0.01;

const UNIT: Metric = Metric { column: 1.0, row: 1.0, up: 1.0 };

impl SurfaceWalk {
    /// A proxy at sample (0, 0), out of contact, that may look at `step_budget` places of the surface
    /// and free-space cells in one update (at least [`MIN_STEP_BUDGET`]). With `sub_step`, the goal moves no
    /// further than that many cells over the ground at a time, which follows a fast hand more faithfully.
    ///
    /// # Panics
    /// Where `sub_step` is not finite, or shorter than [`MIN_SUB_STEP`].
    pub fn new(step_budget: u32, sub_step: Option<f64>) -> Self {
        let is_usable = |longest: f64| longest.is_finite() && longest >= MIN_SUB_STEP;
        assert!(sub_step.is_none_or(is_usable), "a sub-step is not too short: {sub_step:?}");
        Self {
            step_budget: step_budget.max(MIN_STEP_BUDGET),
            sub_step,
            proxy: Proxy::in_space(GridPoint::new(0.0, 0.0, 0.0)),
            metric: UNIT,
            weights: Some(Weights::new(&UNIT)),
            followed: None,
            foresight: Foresight::default(),
            is_at_rest: false,
            unfinished: None,
        }
    }

    /// Follows a finite goal, in sub-steps where they are wanted.
    #[inline(always)]
    fn follow(&mut self, grid: &Grid, weights: Weights, goal: &GridPoint, counters: &mut Counters) {
        let followed = self.followed;
        let is_same = followed == Some(*goal);
        let is_still = self.is_at_rest && is_same;
        if !is_same {
            self.unfinished = None;
        }
        on_heightfield!(grid, field => {
            let search = Search::new(&field, weights, goal);
            self.followed = Some(*goal);
            if let Some(before) = &followed {
                self.foresight.look(&search, &self.proxy.position, before);
            }
            match (self.sub_step, followed) {
                _ if is_still => self.stay_or_follow(&search, counters),
                (Some(longest), Some(from)) => {
                    self.follow_in_sub_steps(&search, &from, longest, counters)
                }
                _ => self.follow_one(&search, counters),
            }
        });
        self.is_at_rest = counters.steps_left == 0;
    }

    /// Lets the goal go no further than `longest` cells at a time. Once it is in the air, the proxy
    /// follows the goal itself: the way there is straight, and a landing is one update.
    #[inline(never)]
    fn follow_in_sub_steps<S: Sample>(
        &mut self,
        search: &Search<S>,
        from: &GridPoint,
        longest: f64,
        counters: &mut Counters,
    ) {
        // A hand that comes in from outside is led along the map's border.
        let from = search.field.nearest_on_map(from);
        for goal in SubSteps::new(&from, &search.goal, longest) {
            if !self.proxy.place.is_on_surface() {
                break;
            }
            self.followed = Some(goal);
            self.follow_one(&Search::new(search.field, search.weights, &goal), counters);
            if counters.steps_left > 0 {
                // Of the goal's way, not only of the part that was begun.
                counters.steps_left = cells_between(&self.proxy.position, &search.target);
                return;
            }
        }
        if !self.proxy.place.is_on_surface() {
            self.followed = Some(search.goal);
            self.follow_one(search, counters);
        }
    }

    /// For a goal that has not moved: what rounding alone would change stays as it is.
    #[cold]
    #[inline(never)]
    fn stay_or_follow<S: Sample>(&mut self, search: &Search<S>, counters: &mut Counters) {
        if !self.proxy.place.is_on_surface() {
            return;
        }
        let before = self.proxy;
        let distance = search.squared_distance(&before.position);
        self.follow_one(search, counters);
        let gain = distance - search.squared_distance(&self.proxy.position);
        if !(gain > search.rounding(distance)) {
            self.proxy = before;
        }
    }

    #[inline(always)]
    fn follow_one<S: Sample>(&mut self, search: &Search<S>, counters: &mut Counters) {
        let before = self.proxy;
        let mut walk = self.walk(search);
        walk.follow(counters);
        let progress = walk.progress;
        // A circle may be longer than a budget: the next update has to know of it.
        self.unfinished = (counters.steps_left > 0).then_some(progress);
        if !self.proxy.position.is_finite() {
            self.proxy = before;
        }
    }

    #[inline(always)]
    fn walk<'walk, 'field, S>(
        &'walk mut self,
        search: &'walk Search<'field, S>,
    ) -> Walk<'walk, 'field, S> {
        let step_budget = self.step_budget;
        let progress = self.unfinished.unwrap_or(Progress::NONE);
        Walk { search, proxy: &mut self.proxy, step_budget, progress }
    }
}

impl ContactModel for SurfaceWalk {
    fn name(&self) -> &'static str {
        "surface_walk"
    }

    fn proxy(&self) -> Proxy {
        self.proxy
    }

    fn take_over(&mut self, proxy: Proxy) {
        self.proxy = proxy;
        self.followed = None;
        self.is_at_rest = false;
        self.unfinished = None;
    }

    fn update(&mut self, grid: &Grid, metric: &Metric, goal: &GridPoint) -> Contact {
        let mut counters = Counters::default();
        if *metric != self.metric {
            self.metric = *metric;
            self.weights = metric.is_valid().then(|| Weights::new(metric));
            self.is_at_rest = false;
            self.unfinished = None;
        }
        if let Some(weights) = self.weights
            && goal.is_finite()
        {
            self.follow(grid, weights, goal, &mut counters);
        }
        Contact::new(self.proxy.position, self.proxy.place.feature(), goal, metric, counters)
    }
}

/// One goal being followed.
struct Walk<'walk, 'field, S> {
    search: &'walk Search<'field, S>,
    proxy: &'walk mut Proxy,
    step_budget: u32,
    progress: Progress,
}

impl Progress {
    const NONE: Self = Self { nearest: f64::INFINITY, stalls: 0 };

    /// Notes a squared distance on the way; false where it has not fallen for so many places that
    /// rounding must be leading the walk in a circle.
    fn comes_nearer(&mut self, distance: f64) -> bool {
        if distance < self.nearest {
            *self = Self { nearest: distance, stalls: 0 };
        } else {
            self.stalls += 1;
        }
        self.stalls <= MOST_STALLS
    }
}

impl<S: Sample> Walk<'_, '_, S> {
    #[inline(always)]
    fn follow(&mut self, counters: &mut Counters) {
        let mut has_landed = false;
        if !self.proxy.place.is_on_surface() {
            if !self.fly_in(counters) {
                return;
            }
            has_landed = self.goal_is_on_map();
        } else {
            self.follow_section(counters);
        }
        loop {
            if !self.can_afford(self.proxy.place.planes(), counters) {
                return;
            }
            match self.descend(has_landed, counters) {
                Descent::AtRest => return,
                Descent::GoesOn => has_landed = false,
                Descent::OutOfSteps => {
                    counters.steps_left = self.cells_left();
                    return;
                }
                Descent::Open(triangle) => {
                    self.progress.nearest = f64::INFINITY;
                    if !self.fly(Start::Surface(triangle), counters) {
                        return;
                    }
                    has_landed = self.goal_is_on_map();
                }
            }
        }
    }

    /// Moves a proxy in space toward the goal; whether it has landed on a triangle.
    #[inline(always)]
    fn fly_in(&mut self, counters: &mut Counters) -> bool {
        match self.proxy.place {
            Place::Space(_) if self.proxy.position == self.search.goal => false,
            Place::Space(side) => self.fly(Start::Space(side), counters),
            _ => true,
        }
    }

    /// Moves the proxy straight toward the goal (paper 3.2); whether it met a triangle.
    #[inline(always)]
    fn fly(&mut self, start: Start, counters: &mut Counters) -> bool {
        if !self.can_afford(1, counters) {
            return false;
        }
        counters.collision_tests += 1;
        let position = self.proxy.position;
        let is_on_map = self.search.field.is_on_map(&position);
        let target = if is_on_map { self.search.target } else { self.search.goal };
        let most_cells = self.step_budget - counters.steps();
        let ray = cast(self.search.field, &position, start, &target, most_cells);
        counters.cells += ray.cells;
        let (position, place) = match ray.end {
            RayEnd::Hit(triangle, position) => (position, Place::Face(triangle)),
            RayEnd::Clear(side) => (self.search.goal, Place::Space(side)),
            RayEnd::OutOfSteps(position, side) => (position, Place::Space(side)),
        };
        *self.proxy = Proxy { position, place };
        if let RayEnd::OutOfSteps(..) = ray.end {
            counters.steps_left = self.cells_left();
        }
        place.is_on_surface()
    }

    /// Whether a proxy that flew to the goal would have flown to the same place on the map.
    fn goal_is_on_map(&self) -> bool {
        self.search.goal == self.search.target
    }

    /// Whether the budget has so many steps left; if not, what is left to walk is noted.
    #[inline(always)]
    fn can_afford(&self, steps: u32, counters: &mut Counters) -> bool {
        let can = counters.steps() + steps <= self.step_budget;
        if !can {
            counters.steps_left = self.cells_left();
        }
        can
    }

    #[cold]
    fn cells_left(&self) -> u32 {
        cells_between(&self.proxy.position, &self.search.target)
    }
}
