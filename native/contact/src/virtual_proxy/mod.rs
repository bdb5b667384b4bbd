//! The virtual proxy (paper 2.2; Ruspini, Kolarov and Khatib 1997): a sphere.
//!
//! The proxy is the centre of a sphere, moved toward the goal in *configuration space*, where the
//! sphere is a point and the ground is grown by its radius. As in Ruspini's model the constraints are
//! tangent planes of the grown obstacles: each triangle around gives one plane, between itself and
//! the sphere, behind which the centre may not go. The place closest to the goal on the free sides of
//! all of them (a quadratic program; at most three planes hold it) is where the centre moves; there
//! it looks around anew, until it comes no nearer. A triangle is convex and lies behind its plane, so
//! the straight way there is free as well: the sphere cannot sink into the ground or jump through
//! it, and its distance to the goal only falls.
//!
//! The force is from the goal to the centre, as in the paper; in the air the centre is at the goal.
//!
//! Where the paper leaves something open:
//!
//! * Distances are relative to the centre, in cell widths; nothing depends on where on the planet
//!   it is. The centre may be nearer to the surface than the radius by a ten-millionth of it and
//!   the rounding of its coordinates, no more; a step that would be is not taken.
//! * A move ends where the squared distance to the goal falls by less than 1e-12 of the squared
//!   radius: from there a still hand gives the same proxy bit for bit. Tangent planes alone would
//!   bring it there too slowly where the goal is close to an edge or a corner: see `stride.rs`.
//! * As for a point, the centre decides whether a sphere that is put somewhere is inside the ground;
//!   there nothing touches until the centre has come out. Outside, a sphere that reaches into the
//!   ground (after a switch of model or scale, or where it was put) moves out of it along the
//!   shortest way, or straight up where that leads nowhere.
//! * Over a hole only triangles that the centre is above count: the rim carries a sphere that does not
//!   fit, and what has fallen in comes out only upwards. The border of the map is a wall for a centre
//!   on the map. One beside the map may touch its rim from the side, and come in under the ground: only
//!   what comes in above it is held (it is so for a point, which does not touch there at all).
//! * All cells in the sphere's shadow, and one more on each side, are looked at in each step of at
//!   most one cell: the cost grows with the square of the radius in cells. Even a small sphere costs
//!   about twenty vertices of the proxy graph for each cell that it crosses. A sphere
//!   whose shadow has more cells than a quarter of the step budget is as large as fits
//!   ([`VirtualProxy::radius`] tells how large).

mod advance;
mod nearest;
mod polyhedron;
mod search;
mod stride;
mod surroundings;

use crate::contact::{Contact, ContactModel, Counters, Feature};
use crate::planes::Scale;
use crate::proxy::{Place, Proxy};
use crate::way::target;
use crate::weights::Weights;
use polyhedron::closest;
use search::Search;
use stride::Stride;
use surface::ray::Side;
use surface::{Grid, GridPoint, Metric, Sample, on_heightfield};
use surroundings::{Between, Shadow, Surroundings, Survey};

/// Cell widths; a smaller sphere is a point to the rounding of the coordinates.
const SMALLEST_RADIUS: f64 = 1e-9;

/// An update looks around at least four times.
const SURVEYS: u32 = 4;

/// Cells in a shadow, at the most: the memory for a look around stays below a megabyte.
const MOST_CELLS: u32 = 4096;

/// Cells under a step of at most a column and a row, and one to spare.
const CELLS_OF_A_STEP: u32 = 4;

/// Cells under what is looked along after one look around: a step, and the whole way that it begins.
const CELLS_AHEAD: u32 = 2 * CELLS_OF_A_STEP;

/// Looks around on the way out of the ground, before the sphere is lifted straight up.
const SURVEYS_ON_THE_WAY_OUT: u32 = 16;

/// The sphere.
pub struct VirtualProxy {
    radius: f64,
    step_budget: u32,
    centre: GridPoint,
    state: State,
    /// What it touches.
    feature: Feature,
    stride: Stride,
    surroundings: Surroundings,
}

/// Where the sphere is.
#[derive(Clone, Copy, Debug, PartialEq)]
enum State {
    /// Outside the ground: it can touch. The centre is over ground or not.
    Outside { is_over_ground: bool },
    /// Inside the ground: nothing touches.
    Inside,
    /// Where another model, or a person, put it: to be seen in the next update.
    Arriving(Place),
}

impl VirtualProxy {
    /// The least step budget of a sphere, more than that of a point: the smallest shadow has 16 cells; with
    /// the cells of a step, four looks around take no more.
    pub const MIN_STEP_BUDGET: u32 = 100;

    /// A sphere of `radius` workspace metres at sample (0, 0), out of contact, that may look at
    /// `step_budget` cells in one update (at least [`Self::MIN_STEP_BUDGET`]).
    ///
    /// # Panics
    /// Where `radius` is not positive and finite.
    pub fn new(radius: f64, step_budget: u32) -> Self {
        assert!(radius > 0.0 && radius.is_finite(), "a sphere's radius is positive: {radius}");
        let step_budget = step_budget.max(Self::MIN_STEP_BUDGET);
        Self {
            radius,
            step_budget,
            centre: GridPoint::new(0.0, 0.0, 0.0),
            state: State::Arriving(Place::Space(Side::Unknown)),
            feature: Feature::Free,
            stride: Stride::new(),
            surroundings: Surroundings::with_room_for(most_cells(step_budget)),
        }
    }

    /// The sphere's radius under this metric, workspace metres: as it was given, or the largest whose
    /// shadow the step budget can look at.
    pub fn radius(&self, metric: &Metric) -> f64 {
        self.radius_in_cells(metric) * metric.column
    }

    fn radius_in_cells(&self, metric: &Metric) -> f64 {
        let largest = Shadow::largest_radius(most_cells(self.step_budget), &Scale::new(metric));
        (self.radius / metric.column).max(SMALLEST_RADIUS).min(largest)
    }

    fn minimise<S: Sample>(&mut self, search: &Search<S>, counters: &mut Counters) {
        if let State::Arriving(place) = self.state {
            self.arrive(search, place, counters);
        }
        match self.state {
            State::Outside { .. } => self.advance(search, counters),
            _ => self.follow_inside(search, counters),
        }
    }

    /// Finds out whether a sphere that was put somewhere is in the ground.
    fn arrive<S: Sample>(&mut self, search: &Search<S>, place: Place, counters: &mut Counters) {
        self.state = State::Inside;
        let Some(survey) = self.survey(search, counters) else { return };
        if !matches!(place, Place::Space(_)) {
            // On the surface, also where rounding says that it is under it.
            self.state = State::Outside { is_over_ground: survey.height.is_some() };
        } else if place != Place::Space(Side::Below) {
            self.come_out(search, &survey);
        }
    }

    /// A sphere whose centre is not in the ground is outside.
    fn come_out<S: Sample>(&mut self, search: &Search<S>, survey: &Survey) {
        if !(survey.is_behind || survey.is_underground(&search.sphere_at(&self.centre))) {
            self.state = State::Outside { is_over_ground: survey.height.is_some() };
        }
    }

    /// Of the surface, as far as the state tells.
    fn side(&self) -> Side {
        match self.state {
            State::Outside { is_over_ground: true } => Side::Above,
            _ => Side::Unknown,
        }
    }

    /// Follows the goal where nothing holds the sphere, until it has come out.
    fn follow_inside<S: Sample>(&mut self, search: &Search<S>, counters: &mut Counters) {
        self.centre = search.goal;
        self.feature = Feature::Free;
        self.state = State::Inside;
        match self.survey(search, counters) {
            Some(survey) => self.come_out(search, &survey),
            // It may have come out here: the next update looks before it goes on.
            None => self.state = State::Arriving(Place::Space(Side::Unknown)),
        }
    }

    /// Moves a sphere that reaches into the ground out of it: the shortest way, or up.
    fn move_out<S: Sample>(
        &mut self,
        search: &Search<S>,
        mut survey: Survey,
        counters: &mut Counters,
    ) {
        let sphere = &search.sphere_at(&self.centre);
        for _ in 0..SURVEYS_ON_THE_WAY_OUT {
            if survey.is_underground(sphere) {
                break;
            }
            let walls = search.walls(&self.centre);
            let planes = self.surroundings.planes(Between::Shortest, &walls);
            let Some((way, _)) = closest([0.0; 3], planes) else { break };
            let before = self.centre;
            self.centre = search.moved(&before, search.limited(way));
            let Some(next) = self.survey(search, counters) else {
                self.centre = before;
                break;
            };
            if next.is_clear(sphere) {
                return;
            }
            survey = next;
        }
        let rise = (survey.highest + sphere.radius + sphere.tolerance).max(0.0);
        self.centre = search.moved(&self.centre, [0.0, 0.0, rise]);
    }

    /// Looks around the sphere; `None` where the step budget does not reach so far.
    fn survey<S: Sample>(&mut self, search: &Search<S>, counters: &mut Counters) -> Option<Survey> {
        let Search { field, scale, radius, .. } = search;
        let shadow = Shadow::new(&self.centre, *radius, scale);
        if counters.steps() + shadow.cells() + CELLS_AHEAD > self.step_budget {
            return None;
        }
        counters.cells += shadow.cells();
        counters.collision_tests += 1;
        let sphere = search.sphere_at(&self.centre);
        Some(self.surroundings.survey(field, scale, &self.centre, &sphere, &shadow))
    }
}

impl ContactModel for VirtualProxy {
    fn name(&self) -> &'static str {
        "virtual_proxy"
    }

    fn proxy(&self) -> Proxy {
        let place = match self.state {
            State::Arriving(place) => place,
            _ => Place::Space(self.side()),
        };
        Proxy { position: self.centre, place }
    }

    fn take_over(&mut self, proxy: Proxy) {
        self.centre = proxy.position;
        self.state = State::Arriving(proxy.place);
        self.feature = proxy.place.feature();
        self.stride = Stride::new();
    }

    fn update(&mut self, grid: &Grid, metric: &Metric, goal: &GridPoint) -> Contact {
        let mut counters = Counters::default();
        if goal.is_finite() && metric.is_valid() {
            let radius = self.radius_in_cells(metric);
            let (scale, weights) = (Scale::new(metric), Weights::new(metric));
            on_heightfield!(grid, field => {
                let target = target(&field, &self.centre, goal);
                let search = Search { field: &field, scale, weights, radius, goal: *goal, target };
                self.minimise(&search, &mut counters)
            });
        }
        Contact::new(self.centre, self.feature, goal, metric, counters)
    }
}

/// Cells that one look around may take.
fn most_cells(step_budget: u32) -> u32 {
    (step_budget / SURVEYS - CELLS_AHEAD).min(MOST_CELLS)
}
