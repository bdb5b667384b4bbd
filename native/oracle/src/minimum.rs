//! Whether a proxy is at a local minimum of the distance to the goal.

use crate::descent::Plane;
use crate::patch::{Patch, patches_at, patches_of_cell};
use crate::workspace::{
    Vector, dot, in_workspace, is_on_map, length, nearest_on_map, normalized, subtract, way,
};
use surface::{Grid, GridPoint, Metric};

/// A way nearer counts from this part of the distance and of a cell on: what any model's rounding
/// stays far below, and no hand could feel.
const RELATIVE: f64 = 1e-9;

/// A proxy is on a triangle to within this part of a cell for every cell of distance, and at most so
/// much of a cell.
const BESIDE: f64 = 2.0 * f64::EPSILON;
const MOST_BESIDE: f64 = 1e-6;

/// The way to the goal begins with so many times that: one that leads less aside from an edge than
/// the inverse leads along it.
const BEGINNING: f64 = 2.0;

/// Steps of the last place that heights are off, where all there is is high or steep.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// Why a proxy is not at a local minimum of the distance to the goal.
#[derive(Debug, PartialEq, Eq, Clone, Copy)]
pub enum Fault {
    /// A triangle that holds the proxy has a point closer to the goal.
    CloserOnSurface,
    /// The straight way to the goal is open.
    WayIsFree,
    /// It is out of contact and yet not at the goal.
    NotAtGoal,
}

/// Why (`proxy`, `touches`) is not a local minimum of the distance to `goal`; `None` where it is, to
/// within a billionth of the distance and of a cell (and the rounding of the heights around).
///
/// For a proxy on the map the goal is the nearest place on the map: the border is a wall.
pub fn fault_of_minimum(
    grid: &Grid,
    metric: &Metric,
    proxy: &GridPoint,
    touches: bool,
    goal: &GridPoint,
) -> Option<Fault> {
    let (proxy, goal) = (normalized(proxy), normalized(goal));
    if !touches {
        return (proxy != goal).then_some(Fault::NotAtGoal);
    }
    let goal = if is_on_map(grid, &proxy) { nearest_on_map(grid, &goal) } else { goal };
    let seen = Surroundings::new(grid, metric, &proxy, &goal);
    let patches = seen.patches_that_hold_it(grid);
    if patches.is_empty() || seen.way_is_free(grid) {
        return Some(Fault::WayIsFree);
    }
    let is_closer = patches.iter().any(|patch| seen.gain_over(patch) > seen.tolerance);
    is_closer.then_some(Fault::CloserOnSurface)
}

/// A proxy, where it is pulled to, and what counts as rounding there.
struct Surroundings<'a> {
    metric: &'a Metric,
    proxy: GridPoint,
    /// From the proxy to the goal.
    toward: Vector,
    /// Metres in the workspace.
    tolerance: f64,
    /// Cells over the ground.
    beside: f64,
}

impl<'a> Surroundings<'a> {
    fn new(grid: &Grid, metric: &'a Metric, proxy: &GridPoint, goal: &GridPoint) -> Self {
        let toward = way(metric, proxy, goal);
        let distance = length(toward);
        let cell = metric.column.min(metric.row);
        let heights = (-1..=2).flat_map(|row| (-1..=2).map(move |column| (column, row)));
        let highest = heights
            .filter_map(|(column, row)| grid.elevation(proxy.column + column, proxy.row + row))
            .fold(0.0, |highest: f64, elevation| highest.max(elevation.abs()));
        Self {
            metric,
            proxy: *proxy,
            toward,
            tolerance: RELATIVE * (distance + cell) + ROUNDING * highest * metric.up,
            beside: (BESIDE * (1.0 + distance / cell)).min(MOST_BESIDE),
        }
    }

    /// The triangles that the proxy lies on to within rounding.
    fn patches_that_hold_it(&self, grid: &Grid) -> Vec<Patch> {
        let cells = (-1..=1).flat_map(|row| (-1..=1).map(move |column| (column, row)));
        cells
            .flat_map(|(column, row)| {
                patches_of_cell(grid, self.proxy.column + column, self.proxy.row + row)
            })
            .filter(|patch| self.is_on(patch))
            .collect()
    }

    fn is_on(&self, patch: &Patch) -> bool {
        let (u, v) = patch.place_of(&self.proxy);
        let [rise, fall] = patch.gradient().map(f64::abs);
        let off = (patch.elevation(u, v) - self.proxy.elevation).abs() * self.metric.up;
        let steepness = (rise + fall) * self.metric.up * self.beside;
        patch.shares(u, v).iter().all(|share| *share >= -self.beside)
            && off <= self.tolerance + steepness
    }

    /// By how much the closest point of a triangle is closer to the goal than the proxy.
    fn gain_over(&self, patch: &Patch) -> f64 {
        let (u, v) = patch.place_of(&self.proxy);
        let foot = Plane::new(patch, self.metric).foot_of(self.toward);
        let (at_u, at_v) = (u + foot[0] / self.metric.column, v + foot[1] / self.metric.row);
        if patch.shares(at_u, at_v).iter().all(|share| *share >= 0.0) {
            return self.gain_of(foot);
        }
        let here = [u, v, self.proxy.elevation];
        let corners =
            patch.corners().map(|corner| in_workspace(self.metric, subtract(corner, here)));
        (0..3)
            .map(|k| self.gain_of(self.closest_on(corners[k], corners[(k + 1) % 3])))
            .fold(f64::NEG_INFINITY, f64::max)
    }

    fn closest_on(&self, from: Vector, to: Vector) -> Vector {
        let side = subtract(to, from);
        let share = dot(subtract(self.toward, from), side) / dot(side, side);
        [0, 1, 2].map(|axis| from[axis] + share.clamp(0.0, 1.0) * side[axis])
    }

    /// By how much a step brings the proxy closer. Not as the difference of two distances, which
    /// would drown a small gain in the rounding of a large distance.
    fn gain_of(&self, step: Vector) -> f64 {
        let left = subtract(self.toward, step);
        let both = [0, 1, 2].map(|axis| self.toward[axis] + left[axis]);
        let sum = length(self.toward) + length(left);
        if sum > 0.0 { dot(step, both) / sum } else { 0.0 }
    }

    /// Whether the straight way to the goal begins over no triangle, or over the planes of all that
    /// it begins over. One that leads along an edge begins over both of its triangles.
    fn way_is_free(&self, grid: &Grid) -> bool {
        let beside = self.beside;
        let [u, v] = [self.toward[0] / self.metric.column, self.toward[1] / self.metric.row];
        let across = u.abs().max(v.abs()).max(f64::MIN_POSITIVE);
        let share = (BEGINNING * beside / across).min(1.0);
        let ahead = |beside_u: f64, beside_v: f64| {
            let (u, v) = (self.proxy.u + share * u, self.proxy.v + share * v);
            let (u, v) = (u + beside_u, v + beside_v);
            GridPoint::from_sample(self.proxy.column, self.proxy.row, u, v, 0.0)
        };
        [-beside, 0.0, beside]
            .iter()
            .flat_map(|u| [-beside, 0.0, beside].map(|v| ahead(*u, v)))
            .flat_map(|point| patches_at(grid, &point))
            .all(|patch| self.leads_above(&patch))
    }

    /// Whether the goal is over a triangle's plane, by more than rounding.
    fn leads_above(&self, patch: &Patch) -> bool {
        let [rise, fall] = patch.gradient().map(|rise| rise.abs() * self.metric.up);
        let steepness = rise / self.metric.column + fall / self.metric.row;
        let over = Plane::new(patch, self.metric).height_of(self.toward);
        over > self.tolerance * (1.0 + steepness)
    }
}
