//! Where a model's proxy ends, against the exact one.

use crate::conduct::force;
use crate::contenders::{Contender, RADIUS, SPHERE};
use crate::path::Course;
use crate::scene::{CELL, Scene, between, length, proxy_at};
use crate::statistics::{Spread, share};
use crate::trace::trace;
use contact::{Contact, ContactModel, Feature, Model, Proxy};
use oracle::{Oracle, fault_of_minimum};
use surface::{GridPoint, Metric};

/// Steps in which the oracle follows the goal through one update.
const SUB_STEPS: u32 = 100;

/// A proxy farther than this from the oracle's is elsewhere, widths of a cell.
pub const ELSEWHERE: f64 = 0.5;

/// Every so many updates are followed in the oracle's steps too.
const STRIDE: usize = 8;

/// Updates that what is left over is waited for.
const LONGEST_REST: u32 = 100;

/// Forces weaker than this have no direction worth comparing, widths of a cell in a spring of 1.
const WEAK: f64 = 1e-3;

/// The exact proxy along a course.
pub struct Reference(Vec<Exact>);

#[derive(Clone, Copy)]
struct Exact {
    position: GridPoint,
    touches: bool,
}

/// How far a model is from the oracle along a course.
#[derive(Clone, Debug, Default)]
pub struct Errors {
    /// Share over half a cell away, the model going on from where it was.
    pub missed: f64,
    /// Share over half a cell away, every update started from where the oracle was.
    pub missed_from_oracle: f64,
    /// The same where the goal moves in as many steps as the oracle's: what is left is no matter of
    /// the goal's speed, but another motion.
    pub missed_in_steps: f64,
    /// Distance to the goal beyond the oracle's, widths of a cell, free-running.
    pub excess: Spread,
    /// Angle between its force and the oracle's, degrees, free-running.
    pub direction: Spread,
    /// Share that did not end at a local minimum, free-running; `None` where that has no meaning.
    pub not_minimal: Option<f64>,
}

impl Reference {
    /// Follows a course.
    pub fn along(scene: &Scene, course: &Course) -> Self {
        let metric = scene.metric();
        let mut oracle = Oracle::in_space(course.starts[0].position);
        let exact = |(update, goal): (usize, &GridPoint)| {
            if let Some(start) = course.start_at(update) {
                oracle = Oracle::in_space(start.position);
            }
            let before = course.goal_before(update);
            oracle.follow(scene.grid, &metric, &before, goal, SUB_STEPS);
            Exact { position: oracle.position(), touches: oracle.touches() }
        };
        Self(course.goals.iter().enumerate().map(exact).collect())
    }

    /// Share of updates in which the oracle itself is not at a local minimum: nothing may be.
    pub fn not_minimal(&self, scene: &Scene, course: &Course) -> f64 {
        let metric = scene.metric();
        let is_faulty = |(exact, goal): &(&Exact, &GridPoint)| {
            fault_of_minimum(scene.grid, &metric, &exact.position, exact.touches, goal).is_some()
        };
        let faults = self.0.iter().zip(&course.goals).filter(is_faulty).count();
        share(faults as u64, self.0.len() as u64)
    }
}

impl Exact {
    fn proxy(&self) -> Proxy {
        proxy_at(self.position, self.touches)
    }

    /// Whether a point is so far away that it is another place.
    fn is_elsewhere(&self, point: &GridPoint, metric: &Metric) -> bool {
        length(between(&self.position, point, metric)) > ELSEWHERE
    }
}

impl Errors {
    /// Follows a course freely, and once more from the oracle's proxy in each update.
    pub fn measure(
        contender: &Contender,
        scene: &Scene,
        course: &Course,
        reference: &Reference,
    ) -> Self {
        let metric = scene.metric();
        let free = trace(&mut *contender.build(), scene, course);
        let compared = free.len() as u64;
        let mut errors = Self::default();
        let (mut missed, mut faults) = (0, 0);
        let (mut excess, mut direction) = (Vec::new(), Vec::new());
        for ((contact, exact), goal) in free.iter().zip(&reference.0).zip(&course.goals) {
            let touch = touch_point(contender, contact, &metric);
            missed += u64::from(exact.is_elsewhere(&touch, &metric));
            let best = length(between(goal, &exact.position, &metric));
            excess.push(length(between(goal, &touch, &metric)) - best);
            direction
                .extend(angle(force(contact, &metric), between(goal, &exact.position, &metric)));
            let touches = contact.feature != Feature::Free;
            faults += u64::from(
                fault_of_minimum(scene.grid, &metric, &contact.proxy, touches, goal).is_some(),
            );
        }
        errors.missed = share(missed, compared);
        errors.excess = Spread::of(excess);
        errors.direction = Spread::of(direction);
        // A sphere's middle is beside the surface everywhere.
        errors.not_minimal = (contender.key != SPHERE).then(|| share(faults, compared));
        errors.missed_from_oracle = from_oracle(contender, scene, course, reference, (1, 1));
        errors.missed_in_steps =
            from_oracle(contender, scene, course, reference, (SUB_STEPS, STRIDE));
        errors
    }
}

/// The share of updates that end elsewhere though they begin where the oracle was, of every `stride`-th
/// update; the goal moves in `steps` equal steps.
fn from_oracle(
    contender: &Contender,
    scene: &Scene,
    course: &Course,
    reference: &Reference,
    (steps, stride): (u32, usize),
) -> f64 {
    let metric = scene.metric();
    let mut model = contender.build();
    let (mut missed, mut compared) = (0, 0);
    for update in (0..course.goals.len()).step_by(stride) {
        let (before, goal) = (course.goal_before(update), course.goals[update]);
        model.take_over(match course.start_at(update) {
            Some(start) => start,
            None => reference.0[update - 1].proxy(),
        });
        if steps > 1 || matches!(contender.model, Model::SurfaceWalk { sub_step: Some(_) }) {
            // From where the goal comes.
            finish(&mut *model, scene, &metric, &before);
        }
        for step in 1..steps {
            let goal = part_of_way(&before, &goal, f64::from(step) / f64::from(steps));
            finish(&mut *model, scene, &metric, &goal);
        }
        let contact = if steps > 1 {
            finish(&mut *model, scene, &metric, &goal)
        } else {
            model.update(scene.grid, &metric, &goal)
        };
        let touch = touch_point(contender, &contact, &metric);
        missed += u64::from(reference.0[update].is_elsewhere(&touch, &metric));
        compared += 1;
    }
    share(missed, compared)
}

/// Updates a model until no steps are left.
fn finish(
    model: &mut dyn ContactModel,
    scene: &Scene,
    metric: &Metric,
    goal: &GridPoint,
) -> Contact {
    let mut contact = model.update(scene.grid, metric, goal);
    for _ in 0..LONGEST_REST {
        if contact.counters.steps_left == 0 {
            break;
        }
        contact = model.update(scene.grid, metric, goal);
    }
    contact
}

fn part_of_way(from: &GridPoint, to: &GridPoint, share: f64) -> GridPoint {
    let [columns, rows, up] = to.relative_to(from.column, from.row, from.elevation);
    let (u, v) = (from.u + share * (columns - from.u), from.v + share * (rows - from.v));
    GridPoint::from_sample(from.column, from.row, u, v, from.elevation + share * up)
}

/// What of a proxy touches the surface: the proxy, and of a sphere the point nearest to the goal.
fn touch_point(contender: &Contender, contact: &Contact, metric: &Metric) -> GridPoint {
    if contender.key != SPHERE || contact.distance() <= RADIUS * CELL {
        return contact.proxy;
    }
    let GridPoint { column, row, u, v, elevation } = contact.proxy;
    let [right, away, up] = contact.normal().map(|part| part * RADIUS * CELL);
    let (u, v) = (u - right / metric.column, v + away / metric.row);
    GridPoint::from_sample(column, row, u, v, elevation - up / metric.up)
}

/// Degrees between a force and the way from goal to proxy, where both are strong enough.
fn angle(force: [f64; 3], exact: [f64; 3]) -> Option<f64> {
    // Rows run south, the workspace's second axis north.
    let exact = [exact[0], -exact[1], exact[2]];
    let lengths = length(force) * length(exact);
    if length(force) < WEAK || length(exact) < WEAK {
        return None;
    }
    let product: f64 = (0..3).map(|axis| force[axis] * exact[axis]).sum();
    let cross = [0, 1, 2].map(|axis| {
        let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
        force[next] * exact[last] - force[last] * exact[next]
    });
    (lengths > 0.0).then(|| length(cross).atan2(product).to_degrees())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn angles_are_in_degrees_and_small_ones_are_not_lost() {
        let close = |found: Option<f64>, expected: f64| {
            assert!((found.unwrap() / expected - 1.0).abs() < 1e-6, "{found:?} {expected}");
        };
        close(angle([1.0, 0.0, 0.0], [0.0, 0.0, 3.0]), 90.0);
        close(angle([1.0, 1.0, 0.0], [1.0, 1.0, 0.0]), 90.0);
        close(angle([0.0, 1e-9, 1.0], [0.0, 0.0, 1.0]), 1e-9f64.to_degrees());
        assert_eq!(angle([0.0; 3], [0.0, 0.0, 1.0]), None);
    }
}
