//! The hand's path: the same goals for every model.
//!
//! A hand wanders; its height follows a smoothed surface (by half the difference in each update,
//! for a hand cannot follow every bump), and how deep it presses changes slowly, even in the
//! logarithm. How the height is scripted moves the counts of the models more than the models do,
//! so it is said here and nowhere else.

use crate::random::Random;
use crate::scene::{Field, Mode, Scene, proxy_at};
use contact::Proxy;
use std::f64::consts::{PI, TAU};
use surface::GridPoint;

/// How deep the hand presses, widths of a cell.
const DEPTH: (f64, f64) = (0.3, 2.0);

/// Share of the way to the surface's height that the hand goes in an update.
const FOLLOWS: f64 = 0.5;

/// Updates in a leg.
const LEG: usize = 256;

/// Radians by which a poking hand goes on in an update, at the most.
const POKES: f64 = 0.03;

/// Height at which a proxy begins over all samples around, widths of a cell: room for a sphere of
/// half a cell beside a cliff too.
const START: f64 = 0.6;
const AROUND: std::ops::RangeInclusive<i64> = -2..=3;

/// A hand's path over a scene, in legs that each begin somewhere else: a slow hand would else stay
/// at one place.
pub struct Course {
    /// Where the hand is at each update.
    pub goals: Vec<GridPoint>,
    /// Updates in a leg.
    pub leg: usize,
    /// Where the proxy begins each leg, out of contact.
    pub starts: Vec<Proxy>,
}

impl Course {
    /// Where the proxy is set down before an update, if a leg begins with it.
    pub fn start_at(&self, update: usize) -> Option<Proxy> {
        update.is_multiple_of(self.leg).then(|| self.starts[update / self.leg])
    }

    /// Where the hand was before an update.
    pub fn goal_before(&self, update: usize) -> GridPoint {
        match self.start_at(update) {
            Some(start) => start.position,
            None => self.goals[update - 1],
        }
    }
}

/// How a path is to be.
#[derive(Clone, Copy)]
pub struct Hand {
    /// Cells over the ground in each update.
    pub speed: f64,
    /// Share of the way to the surface's height that the hand goes in an update.
    pub follows: f64,
    /// Least and most depth, widths of a cell.
    pub depth: (f64, f64),
    /// Updates in a leg; a whole number of blocks.
    pub leg: usize,
    /// Which of all such paths.
    pub seed: u64,
}

impl Hand {
    /// As in most of the bench.
    pub fn new(speed: f64, seed: u64) -> Self {
        Self { speed, follows: FOLLOWS, depth: DEPTH, leg: LEG, seed }
    }

    /// A path of `updates` goals, from one random place to another.
    pub fn over(&self, scene: &Scene, updates: usize) -> Course {
        let surface = |place: &GridPoint| {
            scene.grid.surface_elevation(place).expect("the hand stays on the map")
        };
        let mut course = self.no_course(updates);
        let mut random = self.random();
        while course.goals.len() < updates {
            let way = Way::begin(&scene.field, &mut random);
            let left = updates - course.goals.len();
            self.add_leg(&mut course, scene, &surface, way, left.min(self.leg), &mut random);
        }
        course
    }

    /// A path with a leg from each of these samples, over ground of which only `surface` is asked.
    pub fn starting_at(
        &self,
        scene: &Scene,
        surface: &dyn Fn(&GridPoint) -> f64,
        places: &[(i64, i64)],
    ) -> Course {
        let mut course = self.no_course(places.len() * self.leg);
        let mut random = self.random();
        for &(column, row) in places {
            let way = Way::at(column as f64, row as f64, &mut random);
            self.add_leg(&mut course, scene, surface, way, self.leg, &mut random);
        }
        course
    }

    fn no_course(&self, updates: usize) -> Course {
        Course { goals: Vec::with_capacity(updates), leg: self.leg, starts: Vec::new() }
    }

    fn random(&self) -> Random {
        Random::new(self.seed ^ self.speed.to_bits())
    }

    fn add_leg(
        &self,
        course: &mut Course,
        scene: &Scene,
        surface: &dyn Fn(&GridPoint) -> f64,
        mut way: Way,
        updates: usize,
        random: &mut Random,
    ) {
        let up = scene.metres_for_a_cell();
        let height = |way: &Way| surface(&GridPoint::new(way.column, way.row, 0.0)) / up;
        let (least, most) = self.depth;
        let mut smoothed = height(&way);
        let here = GridPoint::new(way.column, way.row, 0.0);
        let sample = |east: i64, south: i64| {
            surface(&GridPoint::from_sample(here.column + east, here.row + south, 0.0, 0.0, 0.0))
                / up
        };
        let around = AROUND.flat_map(|east| AROUND.map(move |south| (east, south)));
        let highest = around.map(|(east, south)| sample(east, south)).fold(smoothed, f64::max);
        let start = GridPoint::new(way.column, way.row, (highest + START) * up);
        course.starts.push(proxy_at(start, false));
        let mut pressed = random.unit();
        let phase = random.between(0.0, TAU);
        for update in 0..updates {
            way.advance(self.speed, &scene.field, random);
            // A slow hand is slow in pressing too.
            pressed += 0.03 * self.speed.min(1.0) * random.normal();
            pressed = pressed.clamp(0.0, 1.0);
            let depth = least * (most / least).powf(pressed);
            let surface = height(&way);
            smoothed += self.follows * (surface - smoothed);
            let turned = phase + update as f64 * self.speed.min(POKES);
            let goal = match scene.mode {
                Mode::Swipe => smoothed - depth,
                Mode::Poke => surface - 2.0 * depth * turned.sin(),
            };
            course.goals.push(GridPoint::new(way.column, way.row, goal * up));
        }
    }
}

/// Where the hand is over the ground, and where it is heading.
struct Way {
    column: f64,
    row: f64,
    /// Radians from east, southward.
    heading: f64,
    turn: f64,
}

impl Way {
    fn begin(field: &Field, random: &mut Random) -> Self {
        let (column, row) = match field {
            Field::Rows(north, south) => {
                (random.between(0.0, *south), random.between(*north, *south))
            }
            Field::Part(west, east, north, south) => {
                (random.between(*west, *east), random.between(*north, *south))
            }
            Field::Along(line, _) => {
                let column = random.between(0.0, 1000.0);
                (column, line(column))
            }
        };
        Self::at(column, row, random)
    }

    fn at(column: f64, row: f64, random: &mut Random) -> Self {
        Self { column, row, heading: random.between(0.0, TAU), turn: 0.0 }
    }

    fn advance(&mut self, speed: f64, field: &Field, random: &mut Random) {
        self.turn = 0.98 * self.turn + 0.004 * random.normal();
        self.heading += self.turn;
        if let Field::Along(line, reach) = field {
            self.steer(line(self.column) - self.row, *reach);
        }
        self.column += speed * self.heading.cos();
        self.row += speed * self.heading.sin();
        let (west, east, north, south) = match field {
            Field::Rows(north, south) => (f64::NEG_INFINITY, f64::INFINITY, *north, *south),
            Field::Part(west, east, north, south) => (*west, *east, *north, *south),
            Field::Along(..) => return,
        };
        if !(west..=east).contains(&self.column) {
            self.column = reflect(self.column, west, east);
            self.heading = PI - self.heading;
        }
        if !(north..=south).contains(&self.row) {
            self.row = reflect(self.row, north, south);
            self.heading = -self.heading;
        }
    }

    /// Turns back to a line that is `south` rows away where that is more than `reach`.
    fn steer(&mut self, south: f64, reach: f64) {
        if south.abs() <= reach {
            return;
        }
        let eastward = self.heading.cos() >= 0.0;
        let inward = 1.2f64.copysign(south);
        let wanted = if eastward { inward } else { PI - inward };
        let aside = (wanted - self.heading + PI).rem_euclid(TAU) - PI;
        self.heading += 0.1 * aside;
    }
}

/// A place thrown back at both ends.
fn reflect(place: f64, low: f64, high: f64) -> f64 {
    let along = (place - low).rem_euclid(2.0 * (high - low));
    low + along.min(2.0 * (high - low) - along)
}

#[cfg(test)]
mod tests {
    use super::*;
    use surface::{ByteOrder, Grid, GridLayout, SampleType};

    fn hills() -> Grid {
        let layout = GridLayout::packed(400, 400, 100.0, 100.0, SampleType::I16, ByteOrder::Big);
        let mut random = Random::new(9);
        let bytes = (0..400 * 400).flat_map(|_| (random.below(300) as i16).to_be_bytes());
        Grid::from_vec(bytes.collect(), layout.unwrap().with_wrap(true)).unwrap()
    }

    fn scene<'a>(grid: &'a Grid, field: Field<'a>) -> Scene<'a> {
        Scene {
            key: "hills",
            title: String::new(),
            grid,
            exaggeration: 2.0,
            mode: Mode::Swipe,
            field,
        }
    }

    #[test]
    fn the_hand_keeps_its_speed_its_field_and_its_depth() {
        let grid = hills();
        let scene = scene(&grid, Field::Part(50.0, 150.0, 60.0, 200.0));
        for speed in [0.01, 13.4] {
            let course = Hand::new(speed, 1).over(&scene, 5000);
            for goal in &course.goals {
                assert!((50.0..=150.0).contains(&goal.columns()), "{goal:?}");
                assert!((60.0..=200.0).contains(&goal.rows()), "{goal:?}");
            }
            let ways = course.goals.windows(2).map(|pair| {
                (pair[1].columns() - pair[0].columns()).hypot(pair[1].rows() - pair[0].rows())
            });
            let at_speed = ways.filter(|way| (way - speed).abs() < 1e-9).count();
            assert!(at_speed > 4000, "all but where it is thrown back or begins again: {at_speed}");
            let pressed =
                |goal: &&GridPoint| grid.surface_elevation(goal).unwrap() > goal.elevation;
            assert!(course.goals.iter().filter(pressed).count() > 3500);
            assert_eq!(course.goals, Hand::new(speed, 1).over(&scene, 5000).goals);
        }
    }

    #[test]
    fn a_hand_along_a_line_stays_near_it() {
        let grid = hills();
        let line = |column: f64| 200.0 + 30.0 * (column / 40.0).sin();
        let scene = scene(&grid, Field::Along(&line, 10.0));
        for speed in [0.3, 1.0] {
            for goal in Hand::new(speed, 3).over(&scene, 5000).goals {
                let aside = (goal.rows() - line(goal.columns())).abs();
                assert!(aside < 60.0, "{aside} at {goal:?}");
            }
        }
    }
}
