//! A model on trial: it is driven through its trait, and after every update all that it promises is
//! held against it.

use super::models::{fewest_steps, is_exact, is_point, may_float};
use contact::{Contact, ContactModel, Feature, Model, Place, Proxy};
use std::fmt;
use surface::lattice::{EAST, SOUTH};
use surface::{Grid, GridPoint, Half, Metric};

/// A proxy may be under the surface by this part of the relief around it.
pub const MOST_DEPTH: f64 = 1e-12;

/// Cells, the highest ground that is asked for (both ways from 0). On higher ground a crease may be a
/// minimum whose depth is below all rounding, and whether the walk or the oracle stops in it is chance.
const MOST_RELIEF: f64 = 2e9;

/// The distance may grow by this part of itself (and of the goal's motion) more than the goal moves.
pub const MOST_GROWTH: f64 = 1e-12;

/// And by so many steps of the last place of the heights and of a cell.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// A promise that was not kept.
pub type Broken = String;

/// How often a model did what only the exact ones promise not to do.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Tally {
    pub updates: u32,
    pub in_contact: u32,
    /// Of those that ended.
    pub not_minimal: u32,
    /// The distance grew faster than the goal moved.
    pub grew: u32,
    /// The goal was where it had been, and the proxy was not.
    pub still_moved: u32,
    pub still: u32,
}

/// A model, a twin that must do the same, and what was seen of them.
pub struct Trial<'a> {
    pub grid: &'a Grid,
    pub tally: Tally,
    metric: Metric,
    budget: u32,
    model: Box<dyn ContactModel>,
    twin: Box<dyn ContactModel>,
    last: Option<Last>,
    /// Whether the update before was one of a still hand, with nothing left to walk.
    was_still: bool,
    /// Metres; of all samples, the farthest from 0.
    highest: f64,
    is_solid: bool,
    /// The hand was where it can come under the ground without touching it: in a hole, off the map.
    may_be_under: bool,
}

/// The update before.
#[derive(Clone, Copy)]
struct Last {
    goal: GridPoint,
    contact: Contact,
    proxy: Proxy,
}

impl<'a> Trial<'a> {
    /// Of a proxy in space, above the ground.
    pub fn new(grid: &'a Grid, metric: Metric, model: &Model, budget: u32, at: GridPoint) -> Self {
        Self::of(grid, metric, [model.build(budget), model.build(budget)], budget, at)
    }

    /// Of two that must do the same, whoever made them.
    pub fn of(
        grid: &'a Grid,
        metric: Metric,
        [mut one, mut twin]: [Box<dyn ContactModel>; 2],
        budget: u32,
        at: GridPoint,
    ) -> Self {
        let range = grid.range();
        one.place(at);
        twin.place(at);
        Self {
            grid,
            tally: Tally::default(),
            metric,
            budget,
            model: one,
            twin,
            last: None,
            was_still: false,
            highest: range.map_or(0.0, |range| range.maximum.abs().max(range.minimum.abs())),
            is_solid: range.is_some_and(|range| range.voids == 0),
            may_be_under: !is_on_map(grid, &at),
        }
    }

    /// Of a proxy high over the middle of the map.
    pub fn over_the_middle(grid: &'a Grid, metric: Metric, model: &Model, budget: u32) -> Self {
        let (columns, rows) = (f64::from(grid.layout().columns()), f64::from(grid.layout().rows()));
        let top = grid.range().map_or(0.0, |range| range.maximum);
        let over = top + top.abs() + metric.column / metric.up;
        let middle = GridPoint::new((columns - 1.0) / 2.0, (rows - 1.0) / 2.0, over);
        Self::new(grid, metric, model, budget, middle)
    }

    pub fn proxy(&self) -> Proxy {
        self.model.proxy()
    }

    pub fn metric(&self) -> Metric {
        self.metric
    }

    /// Zooms, or exaggerates.
    pub fn change_metric(&mut self, metric: Metric) {
        self.metric = metric;
        self.last = None;
    }

    /// Goes on with another model where this one is.
    pub fn switch(&mut self, model: &Model, budget: u32) -> Result<(), Broken> {
        let proxy = self.model.proxy();
        for side in [&mut self.model, &mut self.twin] {
            *side = model.build(budget);
            side.take_over(proxy);
        }
        self.budget = budget;
        self.last = None;
        let taken = self.model.proxy();
        demand(taken == proxy, || format!("took over {taken:?} for {proxy:?}"))
    }

    /// Puts the proxy somewhere in space.
    pub fn place(&mut self, at: GridPoint) {
        self.model.place(at);
        self.twin.place(at);
        self.last = None;
        let is_above = oracle::depth_below_surface(self.grid, &at) <= 0.0;
        // A sphere may reach into the ground though its centre does not.
        let is_clear = is_above && is_point(&*self.model);
        self.may_be_under = !(is_clear && self.is_solid && is_on_map(self.grid, &at));
    }

    /// One update, after which everything is looked at.
    pub fn update(&mut self, goal: &GridPoint) -> Result<Contact, Broken> {
        let before = self.model.proxy();
        let contact = self.model.update(self.grid, &self.metric, goal);
        let now = Last { goal: *goal, contact, proxy: self.model.proxy() };
        self.tally.updates += 1;
        self.tally.in_contact += u32::from(contact.feature != Feature::Free);
        let looks = [
            self.look_at_numbers(&now),
            self.look_at_twin(&now),
            self.look_at_budget(&now),
            self.look_at_depth(&now),
            self.look_at_place(&now),
            self.look_at_growth(&before, &now),
            self.look_at_stillness(&now),
            self.look_at_minimum(&now),
        ];
        let metric = self.metric;
        self.last = Some(now);
        looks.into_iter().collect::<Result<(), Broken>>().map_err(|broken| {
            let name = self.model.name();
            format!("{name}: {broken}\nfrom {before:?}\nto {goal:?}\n{metric:?}\n{contact:?}")
        })?;
        Ok(contact)
    }

    /// Updates with the same goal until nothing is left to walk.
    pub fn settle(&mut self, goal: &GridPoint) -> Result<Contact, Broken> {
        for _ in 0..MOST_UPDATES {
            let contact = self.update(goal)?;
            if contact.counters.steps_left == 0 {
                return Ok(contact);
            }
        }
        Err(format!("{} never came to an end at {goal:?}", self.model.name()))
    }

    /// A goal that is not finite: nothing may happen.
    pub fn endure(&mut self, goal: &GridPoint) -> Result<(), Broken> {
        let before = self.model.proxy();
        let contact = self.model.update(self.grid, &self.metric, goal);
        self.twin.update(self.grid, &self.metric, goal);
        let now = self.model.proxy();
        let is_same = now == before && contact.proxy == before.position;
        demand(is_same, || format!("moved by {goal:?} from {before:?} to {now:?}"))?;
        let is_finite = contact.normal().iter().all(|part| part.is_finite());
        demand(is_finite && contact.distance().is_finite(), || format!("not finite: {contact:?}"))
    }

    /// Settles, and rests: twice more with a still hand.
    pub fn rest(&mut self, goal: &GridPoint) -> Result<Contact, Broken> {
        self.settle(goal)?;
        self.update(goal)?;
        self.update(goal)
    }

    fn look_at_numbers(&self, now: &Last) -> Result<(), Broken> {
        let contact = &now.contact;
        let (proxy, normal, distance) = (contact.proxy, contact.normal(), contact.distance());
        demand(proxy.is_finite(), || "the proxy is not finite".into())?;
        let fractions = [proxy.u, proxy.v];
        demand(fractions.iter().all(|part| (0.0..=1.0).contains(part)), || {
            "not in its cell".into()
        })?;
        demand(now.proxy.position == proxy, || format!("two places: {:?}", now.proxy))?;
        demand(distance.is_finite() && distance >= 0.0, || "the distance is not finite".into())?;
        let length = normal[0].hypot(normal[1]).hypot(normal[2]);
        demand((length - 1.0).abs() < 1e-9, || format!("a normal of length {length}"))
    }

    fn look_at_twin(&mut self, now: &Last) -> Result<(), Broken> {
        let twin = self.twin.update(self.grid, &self.metric, &now.goal);
        demand(twin == now.contact, || format!("a twin came to {twin:?}"))
    }

    fn look_at_budget(&self, now: &Last) -> Result<(), Broken> {
        let counters = now.contact.counters;
        let steps = counters.vertices + counters.faces + counters.cells;
        let most = self.budget.max(fewest_steps(&*self.model));
        demand(steps <= most, || format!("{steps} steps of {most}"))?;
        // Off the map a test goes through no cell; but there are no more of them than steps allowed.
        let tests = counters.collision_tests;
        demand(tests <= most + 1, || format!("{tests} collision tests of {most} steps"))
    }

    /// On or above the surface; where there are no holes and the hand stays on the map, also when it
    /// is out of contact: contact cannot be lost.
    fn look_at_depth(&mut self, now: &Last) -> Result<(), Broken> {
        let touches = now.contact.feature != Feature::Free;
        // A hand led in sub-steps may have left a border's wall on its way in from outside.
        let was_on_map = self.last.is_none_or(|last| is_on_map(self.grid, &last.goal));
        let hand_is_on_map = is_on_map(self.grid, &now.goal) && was_on_map;
        let depth = oracle::depth_below_surface(self.grid, &now.contact.proxy);
        let is_above = depth <= MOST_DEPTH;
        // A sphere beside the map may touch its rim from the side, and come in under it.
        let is_over_map = self.is_solid && is_on_map(self.grid, &now.contact.proxy);
        if !(touches || self.is_solid && hand_is_on_map) {
            self.may_be_under = true;
        } else if is_over_map && (touches || depth < -MOST_DEPTH) {
            self.may_be_under = false;
        }
        let is_excused = !touches && self.may_be_under;
        demand(is_above || is_excused, || format!("{depth} of the relief under the surface"))
    }

    /// A point in contact, unless it may float, is on ground, and on the triangle, edge or sample that
    /// it says.
    fn look_at_place(&self, now: &Last) -> Result<(), Broken> {
        let Proxy { position, place } = &now.proxy;
        let touches = now.contact.feature != Feature::Free;
        if !touches || !is_point(&*self.model) || may_float(&*self.model) {
            return Ok(());
        }
        demand(has_ground_at(self.grid, position), || "touches where there is no ground".into())?;
        let depth = oracle::depth_below_surface(self.grid, position);
        demand(depth.abs() <= MOST_DEPTH, || format!("{} of the relief in the air", -depth))?;
        demand(is_at(place, position), || format!("is not on {place:?}"))
    }

    fn look_at_growth(&mut self, before: &Proxy, now: &Last) -> Result<(), Broken> {
        let Some(last) = self.last else { return Ok(()) };
        if !(is_on_map(self.grid, &last.goal) && is_on_map(self.grid, &now.goal)) {
            return Ok(());
        }
        // With steps left, a proxy led in sub-steps is still on the goal's way, and not near its end.
        if last.contact.counters.steps_left > 0 || now.contact.counters.steps_left > 0 {
            return Ok(());
        }
        let moved = self.distance(&last.goal, &now.goal);
        let (was, is) = (
            self.distance(&before.position, &last.goal),
            self.distance(&now.proxy.position, &now.goal),
        );
        let grew = is > was + moved + MOST_GROWTH * (was + moved) + self.rounding();
        self.tally.grew += u32::from(grew);
        demand(!(grew && is_exact(&*self.model)), || {
            format!("the distance grew from {was} to {is}, but the goal moved by {moved}")
        })
    }

    /// From the update after the one that left nothing to walk, every bit is the same. (That one may
    /// be a rounding error beside a goal that is on the very surface, and out of contact at it next.)
    fn look_at_stillness(&mut self, now: &Last) -> Result<(), Broken> {
        let Some(last) = self.last else { return Ok(()) };
        let is_still = last.goal == now.goal && last.contact.counters.steps_left == 0;
        let was_still = std::mem::replace(&mut self.was_still, is_still);
        if !(is_still && was_still) {
            return Ok(());
        }
        let seen = |contact: &Contact| (contact.proxy, contact.feature, contact.displacement);
        let moved = seen(&last.contact) != seen(&now.contact);
        self.tally.still += 1;
        self.tally.still_moved += u32::from(moved);
        demand(!(moved && is_exact(&*self.model)), || {
            format!("moved by a still hand from {:?}", last.proxy)
        })
    }

    fn look_at_minimum(&mut self, now: &Last) -> Result<(), Broken> {
        let Last { goal, contact, .. } = now;
        if contact.counters.steps_left > 0 {
            return Ok(());
        }
        let touches = contact.feature != Feature::Free;
        let fault =
            oracle::fault_of_minimum(self.grid, &self.metric, &contact.proxy, touches, goal);
        self.tally.not_minimal += u32::from(fault.is_some());
        let is_strict = is_exact(&*self.model) && self.relief_in_cells() <= MOST_RELIEF;
        demand(!(fault.is_some() && is_strict), || format!("no minimum: {fault:?}"))
    }

    /// How many times as high as the shorter side of a cell the ground is, as the hand feels it.
    fn relief_in_cells(&self) -> f64 {
        2.0 * self.highest * self.metric.up / self.metric.column.min(self.metric.row)
    }

    /// Workspace metres.
    fn distance(&self, from: &GridPoint, to: &GridPoint) -> f64 {
        let Metric { column, row, up } = self.metric;
        let [columns, rows, rise] = to.relative_to(from.column, from.row, from.elevation);
        ((columns - from.u) * column).hypot((rows - from.v) * row).hypot(rise * up)
    }

    /// Workspace metres that are rounding, wherever on the map.
    fn rounding(&self) -> f64 {
        ROUNDING * (self.metric.column.max(self.metric.row) + self.highest * self.metric.up)
    }
}

/// Updates with a still hand before a model is taken not to end.
const MOST_UPDATES: u32 = 10_000;

fn demand(holds: bool, otherwise: impl FnOnce() -> Broken) -> Result<(), Broken> {
    if holds { Ok(()) } else { Err(otherwise()) }
}

/// Whether a point is over or under the map, holes included.
pub fn is_on_map(grid: &Grid, point: &GridPoint) -> bool {
    let layout = grid.layout();
    let on = |place: f64, samples: u32| (0.0..=f64::from(samples) - 1.0).contains(&place);
    on(point.rows(), layout.rows()) && (layout.wraps() || on(point.columns(), layout.columns()))
}

/// Of a cell; what rounding may put a place beside.
const BESIDE: f64 = 1e-12;

/// Whether a point is over or under a triangle that is there, sides and corners included.
fn has_ground_at(grid: &Grid, point: &GridPoint) -> bool {
    let beside = [-BESIDE, 0.0, BESIDE];
    beside.iter().any(|u| {
        beside.iter().any(|v| {
            let (u, v) = (point.u + u, point.v + v);
            let beside = GridPoint::from_sample(point.column, point.row, u, v, 0.0);
            grid.surface_elevation(&beside).is_some()
        })
    })
}

/// Whether a point lies on what a place names, as the map is seen.
fn is_at(place: &Place, point: &GridPoint) -> bool {
    let is_whole = |place: f64| place.abs() <= BESIDE;
    match *place {
        Place::Space(_) => true,
        Place::Face(triangle) => {
            let [u, v, _] = point.relative_to(triangle.column, triangle.row, 0.0);
            let (near, far) = if triangle.half == Half::NorthEast { (v, u) } else { (u, v) };
            near >= -BESIDE && far >= near - BESIDE && far <= 1.0 + BESIDE
        }
        Place::Edge { column, row, k } => {
            let [u, v, _] = point.relative_to(column, row, 0.0);
            let along = if EAST[k] == 0 { v * SOUTH[k] as f64 } else { u * EAST[k] as f64 };
            let aside = [u - along * EAST[k] as f64, v - along * SOUTH[k] as f64];
            aside.into_iter().all(is_whole) && (-BESIDE..=1.0 + BESIDE).contains(&along)
        }
        Place::Vertex { column, row } => {
            let [u, v, _] = point.relative_to(column, row, 0.0);
            is_whole(u) && is_whole(v)
        }
    }
}

impl std::ops::AddAssign for Tally {
    fn add_assign(&mut self, other: Self) {
        self.updates += other.updates;
        self.in_contact += other.in_contact;
        self.not_minimal += other.not_minimal;
        self.grew += other.grew;
        self.still_moved += other.still_moved;
        self.still += other.still;
    }
}

impl fmt::Display for Tally {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let share = |part: u32, of: u32| f64::from(part) / f64::from(of.max(1));
        write!(
            f,
            "{} updates, {} in contact, not minimal {:.5}, grew {:.5}, moved by a still hand {:.5} of {}",
            self.updates,
            self.in_contact,
            share(self.not_minimal, self.in_contact),
            share(self.grew, self.updates),
            share(self.still_moved, self.still),
            self.still,
        )
    }
}
