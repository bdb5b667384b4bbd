//! How the sphere moves toward the goal along what it touches: look around, step, look around anew.

use super::search::{Search, Step, Way};
use super::stride::LEAST_STRETCH;
use super::surroundings::{Between, Survey};
use super::{CELLS_OF_A_STEP, State, VirtualProxy};
use crate::contact::{Counters, Feature};
use crate::planes::length;
use crate::way::cells_between;
use surface::ray::{RayEnd, Side, Start, cast};
use surface::{GridPoint, Sample};

/// Steps from where a stretched one led, before it is given up.
const STEPS_BACK: u32 = 2;

/// What a step belongs to.
#[derive(Clone, Copy)]
enum Leg {
    /// To a nearer place, by this vector (cell widths).
    Plain([f64; 3]),
    /// Along the planes, farther than is nearer.
    Stretched,
    /// From there to the ground again: so many steps.
    Back(u32),
}

/// What a look around says of where a leg has led.
enum Arrival {
    /// Free, and nearer than all places before.
    Settled,
    /// Free, but farther away, after a stretched step.
    Away,
    /// A stretched step led astray, from here.
    Strayed(GridPoint),
    /// It was in the ground when the update began.
    Reaching,
    /// Rounding let it into the ground, from here.
    Blocked(GridPoint),
    /// Into a hole, and under the ground beside it.
    Fallen,
}

/// Where it goes from a free place.
enum Departure {
    On(Leg),
    /// It is at the goal, and nothing holds it.
    AtGoal,
    /// No place is nearer.
    Nowhere,
}

impl VirtualProxy {
    /// Moves the sphere toward the goal, along what it touches.
    pub(super) fn advance<S: Sample>(&mut self, search: &Search<S>, counters: &mut Counters) {
        // The nearest place that is known to be free.
        let mut settled = None;
        let mut leg = None;
        loop {
            let Some(survey) = self.survey(search, counters) else {
                return self.stop_short(search, settled, leg, counters);
            };
            let arrival = self.arrival(search, &survey, settled, leg);
            match arrival {
                Arrival::Settled => {
                    self.settle(search, &survey, leg);
                    settled = Some(self.centre);
                    leg = None;
                }
                Arrival::Away => {}
                Arrival::Strayed(before) => {
                    leg = self.go_back(before);
                    continue;
                }
                Arrival::Reaching => {
                    self.move_out(search, survey, counters);
                    settled = Some(self.centre);
                    continue;
                }
                Arrival::Blocked(before) => {
                    self.centre = before;
                    return;
                }
                Arrival::Fallen => return self.follow_inside(search, counters),
            }
            match (self.depart(search, &survey, leg, counters), arrival, settled) {
                (Departure::On(next), ..) => leg = Some(next),
                (Departure::AtGoal, ..) => return,
                (Departure::Nowhere, Arrival::Away, Some(before)) => leg = self.go_back(before),
                (Departure::Nowhere, ..) => {
                    self.feature = survey.feature;
                    return;
                }
            }
        }
    }

    /// Ends where the budget does: what has not been looked at is not known to be free.
    fn stop_short<S: Sample>(
        &mut self,
        search: &Search<S>,
        settled: Option<GridPoint>,
        leg: Option<Leg>,
        counters: &mut Counters,
    ) {
        self.centre = settled.unwrap_or(self.centre);
        if leg.is_some_and(|leg| leg.is_of_stretch()) {
            self.stride.fail();
        }
        counters.steps_left = cells_between(&self.centre, &search.target);
    }

    fn arrival<S: Sample>(
        &self,
        search: &Search<S>,
        survey: &Survey,
        settled: Option<GridPoint>,
        leg: Option<Leg>,
    ) -> Arrival {
        let is_clear = survey.is_clear(&search.sphere_at(&self.centre));
        let came_over_ground = self.state == State::Outside { is_over_ground: true };
        match (settled, leg) {
            (Some(before), Some(leg)) if leg.is_of_stretch() => {
                let is_over_same = came_over_ground == survey.height.is_some();
                self.arrival_of_stretch(search, leg, before, is_clear && is_over_same)
            }
            _ if is_clear => Arrival::Settled,
            (None, _) if !survey.is_behind => Arrival::Reaching,
            (Some(before), _) if came_over_ground => Arrival::Blocked(before),
            _ => Arrival::Fallen,
        }
    }

    fn arrival_of_stretch<S: Sample>(
        &self,
        search: &Search<S>,
        leg: Leg,
        before: GridPoint,
        is_free: bool,
    ) -> Arrival {
        let is_last = matches!(leg, Leg::Back(STEPS_BACK));
        if !is_free {
            Arrival::Strayed(before)
        } else if search.is_nearer(&self.centre, &before) {
            Arrival::Settled
        } else if is_last {
            Arrival::Strayed(before)
        } else {
            Arrival::Away
        }
    }

    /// Takes note of a free place, and of how it was come by.
    fn settle<S: Sample>(&mut self, search: &Search<S>, survey: &Survey, leg: Option<Leg>) {
        self.state = State::Outside { is_over_ground: survey.height.is_some() };
        self.feature = survey.touched(&search.sphere_at(&self.centre));
        match leg {
            Some(Leg::Plain(step)) => self.stride.follow(step),
            Some(Leg::Stretched | Leg::Back(_)) => self.stride.succeed(),
            None => {}
        }
    }

    /// Gives up a stretched step.
    fn go_back(&mut self, before: GridPoint) -> Option<Leg> {
        self.stride.fail();
        self.centre = before;
        None
    }

    fn depart<S: Sample>(
        &mut self,
        search: &Search<S>,
        survey: &Survey,
        leg: Option<Leg>,
        counters: &mut Counters,
    ) -> Departure {
        match search.step(&mut self.surroundings, &self.centre, survey) {
            Some(Step::ToGoal) => match self.side_after(search, &search.goal, counters) {
                Some(side) => {
                    self.reach_goal(search, side);
                    Departure::AtGoal
                }
                None => Departure::Nowhere,
            },
            Some(Step::To(way, between)) => match self.side_after(search, &way.to, counters) {
                Some(_) => Departure::On(self.step_along(search, way, between, leg, counters)),
                None => Departure::Nowhere,
            },
            None => Departure::Nowhere,
        }
    }

    /// Takes a step, or the whole way that it is the beginning of.
    fn step_along<S: Sample>(
        &mut self,
        search: &Search<S>,
        way: Way,
        between: Between,
        leg: Option<Leg>,
        counters: &mut Counters,
    ) -> Leg {
        let (to, leg) = match leg {
            Some(Leg::Stretched) => (way.to, Leg::Back(1)),
            Some(Leg::Back(steps)) => (way.to, Leg::Back(steps + 1)),
            _ => match self.whole_way(search, way, between, counters) {
                Some(whole) => (whole.to, Leg::Stretched),
                None => (way.to, Leg::Plain(way.vector)),
            },
        };
        self.centre = to;
        leg
    }

    /// The whole way that a step is the beginning of, if that is much longer, and free.
    fn whole_way<S: Sample>(
        &mut self,
        search: &Search<S>,
        way: Way,
        between: Between,
        counters: &mut Counters,
    ) -> Option<Way> {
        let aim = self.stride.whole_way(way.vector, search.radius)?;
        let whole = search.way_toward(&mut self.surroundings, between, &self.centre, aim)?;
        let is_longer = length(whole.vector) >= LEAST_STRETCH * length(way.vector);
        (is_longer && self.side_after(search, &whole.to, counters).is_some()).then_some(whole)
    }

    /// The side of the surface that the centre is on after a step; `None` where the centre itself
    /// would go through the surface: rounding hid it, as it may where heights dwarf cells.
    fn side_after<S: Sample>(
        &self,
        search: &Search<S>,
        to: &GridPoint,
        counters: &mut Counters,
    ) -> Option<Side> {
        let start = Start::Space(self.side());
        let ray = cast(search.field, &self.centre, start, to, CELLS_OF_A_STEP);
        counters.cells += ray.cells;
        match ray.end {
            RayEnd::Hit(..) => None,
            RayEnd::Clear(side) | RayEnd::OutOfSteps(_, side) => Some(side),
        }
    }

    fn reach_goal<S: Sample>(&mut self, search: &Search<S>, side: Side) {
        self.centre = search.goal;
        self.feature = Feature::Free;
        self.state = match side {
            Side::Below => State::Inside,
            _ => State::Outside { is_over_ground: side == Side::Above },
        };
    }
}

impl Leg {
    /// Whether it is a stretched step, or on the way back from one.
    fn is_of_stretch(self) -> bool {
        !matches!(self, Self::Plain(_))
    }
}
