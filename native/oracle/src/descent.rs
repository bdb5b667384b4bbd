//! The steepest descent of the distance to a target over the surface.

use crate::patch::{Patch, leads_into};
use crate::workspace::{Vector, dot, in_workspace, length, step_between, way};
use surface::{GridPoint, Metric};

/// Where less than this part of the way to the target lies in the surface, there is no telling
/// whether it leads anywhere; nor where that is less than so many steps of the last place of the
/// numbers that a point of the triangle is made of.
const LEAST_PART: f64 = 1e-13;
const LEAST_STEPS: f64 = 8.0 * f64::EPSILON;

/// Rounding of a place, in parts of a cell for every cell of distance to the target; and the most of
/// a cell that rounding is taken for.
const POSITION_STEPS: f64 = 8.0 * f64::EPSILON;
const MOST_BESIDE: f64 = 1e-6;

/// Where the steepest straight piece of the descent from `here` ends, in any of the triangles that
/// hold it: at the nearest point of that triangle or side, or at its end. `None` where no triangle
/// leads nearer to `target`.
pub(crate) fn steepest(
    patches: &[Patch],
    metric: &Metric,
    here: &GridPoint,
    target: &GridPoint,
) -> Option<GridPoint> {
    let toward = way(metric, here, target);
    let (mut best_rate, mut best) = (0.0f64, None);
    for patch in patches {
        let least = LEAST_PART * length(toward) + LEAST_STEPS * size(patch, metric);
        for (rate, step) in ways_down(patch, metric, here, toward) {
            if rate > best_rate.max(least) {
                (best_rate, best) = (rate, Some((patch, step)));
            }
        }
    }
    let rounding = POSITION_STEPS * (1.0 + length(toward) / metric.column.min(metric.row));
    best.map(|(patch, step)| end_inside(patch, here, step, rounding.min(MOST_BESIDE)))
}

/// Whether the straight way from `here` is open: it leads over no triangle, or over the plane of
/// the one that it leads over. Over an edge both of its triangles decide, where both are there.
pub(crate) fn is_open(
    patches: &[Patch],
    metric: &Metric,
    here: &GridPoint,
    target: &GridPoint,
) -> bool {
    let toward = way(metric, here, target);
    let [u, v, _] = step_between(here, target);
    patches
        .iter()
        .filter(|patch| leads_into(patch, here, [u, v]))
        .all(|patch| Plane::new(patch, metric).height_of(toward) > 0.0)
}

/// The ways over one triangle that may lead nearer: how fast (metres of distance for a metre of way,
/// times the distance to the target, which all share), and the step to the nearest point, columns
/// and rows. Into the triangle where that leads nearest, else along its sides.
fn ways_down(
    patch: &Patch,
    metric: &Metric,
    here: &GridPoint,
    toward: Vector,
) -> Vec<(f64, [f64; 2])> {
    let foot = Plane::new(patch, metric).foot_of(toward);
    let step = [foot[0] / metric.column, foot[1] / metric.row];
    let mut ways = Vec::with_capacity(2);
    if leads_into(patch, here, step) {
        ways.push((length(foot), step));
    } else {
        let (u, v) = patch.place_of(here);
        let on_sides = patch.shares(u, v);
        for corner in (0..3).filter(|corner| on_sides[*corner] == 0.0) {
            let side = patch.side(corner);
            let side_in_workspace = in_workspace(metric, side);
            let share = dot(toward, side_in_workspace) / dot(side_in_workspace, side_in_workspace);
            let step = [share * side[0], share * side[1]];
            if leads_into(patch, here, step) {
                ways.push((share.abs() * length(side_in_workspace), step));
            }
        }
    }
    ways
}

/// Where a step over a triangle ends, or where it leaves the triangle. An end within `rounding`
/// (cells) of a side is on it: what lies beyond the side counts there.
fn end_inside(
    patch: &Patch,
    here: &GridPoint,
    [step_u, step_v]: [f64; 2],
    rounding: f64,
) -> GridPoint {
    let (u, v) = patch.place_of(here);
    let (shares, changes) = (patch.shares(u, v), patch.share_changes(step_u, step_v));
    let mut inside = 1.0;
    let mut leaves_over = None;
    for corner in 0..3 {
        if shares[corner] < -changes[corner] * inside {
            inside = shares[corner] / -changes[corner];
            leaves_over = Some(corner);
        }
    }
    let (u, v) = (u + inside * step_u, v + inside * step_v);
    let (u, v) = leaves_over.map_or((u, v), |corner| patch.brought_to_side(corner, u, v));
    patch.point(u, v, rounding)
}

/// The greatest of the numbers that a point of a triangle is made of, metres.
fn size(patch: &Patch, metric: &Metric) -> f64 {
    let highest = patch.corners().iter().fold(0.0, |high: f64, corner| high.max(corner[2].abs()));
    metric.column.max(metric.row).max(highest * metric.up)
}

/// The plane of a triangle, through a point of it, in the workspace.
pub(crate) struct Plane {
    /// Metres up for a metre along the columns, and along the rows.
    rise: [f64; 2],
}

impl Plane {
    pub(crate) fn new(patch: &Patch, metric: &Metric) -> Self {
        let [column, row] = patch.gradient();
        Self { rise: [column * metric.up / metric.column, row * metric.up / metric.row] }
    }

    /// How high a vector from the plane leads over the plane, measured straight up.
    pub(crate) fn height_of(&self, way: Vector) -> f64 {
        way[2] - self.rise[0] * way[0] - self.rise[1] * way[1]
    }

    /// The part of a vector that lies in the plane. It is put together from its parts level with
    /// the ground and straight uphill, so that it stays exact on planes that are nearly upright.
    pub(crate) fn foot_of(&self, way: Vector) -> Vector {
        let [x, y] = self.rise;
        let slope = x.hypot(y);
        if slope == 0.0 {
            return [way[0], way[1], 0.0];
        }
        let level = [-y / slope, x / slope, 0.0];
        let uphill_length = slope.hypot(1.0);
        let uphill = [x / slope / uphill_length, y / slope / uphill_length, slope / uphill_length];
        let (along_level, along_uphill) = (dot(way, level), dot(way, uphill));
        [0, 1, 2].map(|axis| along_level * level[axis] + along_uphill * uphill[axis])
    }
}
