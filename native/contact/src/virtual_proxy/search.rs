//! Where the sphere goes next, from what lies around it.

use super::polyhedron::closest;
use super::surroundings::{Between, MOST_WALLS, Sphere, Surroundings, Survey};
use crate::distance::Distance;
use crate::planes::{Plane, Scale, dot, length, plus, unit};
use crate::weights::Weights;
use surface::{GridPoint, Heightfield, Sample};

/// Share of the radius by which rounding may let the sphere into the ground.
const TOLERANCE: f64 = 1e-7;

/// Share of the squared radius by which the squared distance to the goal has to fall in a step.
const LEAST_GAIN: f64 = 1e-12;

/// Cell widths, of the terrain's relief around or of a cell: a goal farther away pulls as one there
/// does. Beyond, the rounding of its coordinates would move the sphere.
const FARTHEST_PULL: f64 = 1e7;

/// What stays the same during one update.
pub(super) struct Search<'a, S> {
    pub(super) field: &'a Heightfield<'a, S>,
    pub(super) scale: Scale,
    pub(super) weights: Weights,
    /// Of the sphere, cell widths.
    pub(super) radius: f64,
    /// Where the hand is.
    pub(super) goal: GridPoint,
    /// What the centre moves toward: as near to the hand as the map goes.
    pub(super) target: GridPoint,
}

/// What a look around leads to.
#[derive(Clone, Copy)]
pub(super) enum Step {
    /// To the goal, and nothing is touched.
    ToGoal,
    /// As far as these planes, and what is known of the ground, allow.
    To(Way, Between),
}

/// A step from one place to another.
#[derive(Clone, Copy)]
pub(super) struct Way {
    pub(super) to: GridPoint,
    /// Cell widths.
    pub(super) vector: [f64; 3],
}

impl<S: Sample> Search<'_, S> {
    /// The sphere around a centre.
    pub(super) fn sphere_at(&self, centre: &GridPoint) -> Sphere {
        // Of the coordinates of what it can touch.
        let size = 2.0 + self.scale.row + self.radius + centre.elevation.abs() * self.scale.up;
        let rounding = 16.0 * f64::EPSILON * size;
        Sphere { radius: self.radius, tolerance: TOLERANCE * self.radius + rounding }
    }

    /// The next step of a sphere that has looked around; `None` where it comes no nearer.
    pub(super) fn step(
        &self,
        surroundings: &mut Surroundings,
        centre: &GridPoint,
        survey: &Survey,
    ) -> Option<Step> {
        let walls = self.walls(centre);
        let way = self.scale.between(centre, &self.target);
        let distance = length(way);
        if !distance.is_finite() {
            return None;
        }
        // Where nothing is around, nothing can be rounded into: it flies all the way.
        let is_alone = survey.distance == f64::INFINITY;
        let reach = if is_alone { f64::INFINITY } else { FARTHEST_PULL * survey.extent };
        let share = reach / distance;
        let pull = if share < 1.0 { way.map(|part| share * part) } else { way };
        let mut step = |between| {
            let planes = surroundings.planes(between, &walls);
            self.step_between(planes, between, centre, pull)
        };
        match step(Between::Glide).or_else(|| step(Between::Shortest))? {
            // The goal was pulled nearer: it is not there yet.
            Step::ToGoal if share < 1.0 => Some(Step::To(self.way(centre, pull), Between::Glide)),
            step => Some(step),
        }
    }

    /// The step to the place closest to the goal, which is `pull` away, on the free side of all planes.
    fn step_between(
        &self,
        planes: &[Plane],
        between: Between,
        centre: &GridPoint,
        pull: [f64; 3],
    ) -> Option<Step> {
        let (step, is_held) = closest(pull, planes)?;
        let way = self.way(centre, step);
        if !is_held && way.vector == step {
            return Some(Step::ToGoal);
        }
        let gain = dot(way.vector, plus(plus(pull, 1.0, pull), -1.0, way.vector));
        // False for NaN too.
        let comes_nearer = gain > LEAST_GAIN * self.radius * self.radius
            // As far as the coordinates tell: at a sharp corner rounding may promise more.
            && self.is_nearer(&way.to, centre);
        comes_nearer.then_some(Step::To(way, between))
    }

    /// The way toward `aim`, as far as it is free; it may lead away from the goal.
    pub(super) fn way_toward(
        &self,
        surroundings: &mut Surroundings,
        between: Between,
        centre: &GridPoint,
        aim: [f64; 3],
    ) -> Option<Way> {
        let (step, _) = closest(aim, surroundings.planes(between, &self.walls(centre)))?;
        Some(self.way(centre, step))
    }

    fn way(&self, centre: &GridPoint, step: [f64; 3]) -> Way {
        let vector = self.limited(step);
        Way { to: self.moved(centre, vector), vector }
    }

    /// Whether one place is nearer to the target than another, by more than rounding.
    pub(super) fn is_nearer(&self, place: &GridPoint, other: &GridPoint) -> bool {
        let distance = |centre| Distance::new(centre, &self.target, &self.weights);
        distance(place).is_less_than(&distance(other))
    }

    /// A step, as far as was looked: a column and a row.
    pub(super) fn limited(&self, step: [f64; 3]) -> [f64; 3] {
        let cells = step[0].abs().max(step[1].abs() / self.scale.row);
        if cells > 1.0 { step.map(|part| part / cells) } else { step }
    }

    /// The place that a step leads to; on the map, where it began there.
    pub(super) fn moved(&self, from: &GridPoint, step: [f64; 3]) -> GridPoint {
        let [columns, rows, up] = self.scale.on_grid(step);
        let (u, v, elevation) = (from.u + columns, from.v + rows, from.elevation + up);
        let point = GridPoint::from_sample(from.column, from.row, u, v, elevation);
        if self.field.is_on_map(from) { self.field.nearest_on_map(&point) } else { point }
    }

    /// The borders of the map within reach, for a centre on the map.
    pub(super) fn walls(&self, centre: &GridPoint) -> [Option<Plane>; MOST_WALLS] {
        let is_on_map = self.field.is_on_map(centre);
        [(2.0, 0.0), (-2.0, 0.0), (0.0, 2.0), (0.0, -2.0)].map(|(columns, rows)| {
            let (u, v) = (centre.u + columns, centre.v + rows);
            let out = GridPoint::from_sample(centre.column, centre.row, u, v, centre.elevation);
            let border = self.field.nearest_on_map(&out);
            (is_on_map && border != out).then(|| {
                let normal = unit(self.scale.vector([-columns, -rows, 0.0]));
                Plane { normal, offset: dot(normal, self.scale.between(centre, &border)) }
            })
        })
    }
}
