//! Plain vectors in the workspace, metres: columns, rows and up.

use surface::{Grid, GridPoint, Metric};

pub(crate) type Vector = [f64; 3];

/// The vector from one point to another.
pub(crate) fn way(metric: &Metric, from: &GridPoint, to: &GridPoint) -> Vector {
    in_workspace(metric, step_between(from, to))
}

/// Columns, rows and metres from one point to another.
pub(crate) fn step_between(from: &GridPoint, to: &GridPoint) -> [f64; 3] {
    let [columns, rows, up] = to.relative_to(from.column, from.row, from.elevation);
    [columns - from.u, rows - from.v, up]
}

pub(crate) fn in_workspace(metric: &Metric, [columns, rows, up]: Vector) -> Vector {
    [columns * metric.column, rows * metric.row, up * metric.up]
}

pub(crate) fn subtract(a: Vector, b: Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

pub(crate) fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(crate) fn length(a: Vector) -> f64 {
    dot(a, a).sqrt()
}

/// The point with both fractions from 0 to less than 1.
pub(crate) fn normalized(point: &GridPoint) -> GridPoint {
    GridPoint::from_sample(point.column, point.row, point.u, point.v, point.elevation)
}

/// The nearest place on the map at the same elevation: what a proxy on the map moves toward.
pub(crate) fn nearest_on_map(grid: &Grid, point: &GridPoint) -> GridPoint {
    let layout = grid.layout();
    let mut near = normalized(point);
    (near.row, near.v) = within(near.row, near.v, layout.rows());
    if !layout.wraps() {
        (near.column, near.u) = within(near.column, near.u, layout.columns());
    }
    near
}

pub(crate) fn is_on_map(grid: &Grid, point: &GridPoint) -> bool {
    nearest_on_map(grid, point) == normalized(point)
}

fn within(cell: i64, fraction: f64, samples: u32) -> (i64, f64) {
    let last = i64::from(samples) - 1;
    match cell {
        _ if cell < 0 => (0, 0.0),
        _ if cell >= last => (last, 0.0),
        _ => (cell, fraction),
    }
}
