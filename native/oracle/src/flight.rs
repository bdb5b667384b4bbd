//! The straight way through the air, and the first triangle that it meets from above.

use crate::patch::{Patch, leads_into, patches_at};
use crate::workspace::step_between;
use surface::{Grid, GridPoint};

/// A hit within this part of a cell of a side or corner is on it.
const ON_SIDE: f64 = 8.0 * f64::EPSILON;

/// Where a point in space is, seen from the surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Side {
    Above,
    Below,
    /// In a hole or off the map: the next triangle on the way decides.
    Unknown,
}

/// How a flight ends.
pub(crate) enum Flight {
    /// On the surface.
    Met(GridPoint),
    /// At the target, on this side.
    Reached(Side),
}

/// Flies from a place in space to `target`.
pub(crate) fn fly(grid: &Grid, from: &GridPoint, side: Side, target: &GridPoint) -> Flight {
    Path::new(from, target).follow(grid, side, false)
}

/// Flies from a place on the surface, over whose first triangle the way to `target` is open.
pub(crate) fn take_off(grid: &Grid, from: &GridPoint, target: &GridPoint) -> Flight {
    Path::new(from, target).follow(grid, Side::Above, true)
}

/// A straight way; `t` runs from 0 to 1.
struct Path {
    from: GridPoint,
    /// Columns, rows and metres.
    step: [f64; 3],
}

impl Path {
    fn new(from: &GridPoint, to: &GridPoint) -> Self {
        Self { from: *from, step: step_between(from, to) }
    }

    /// Between two crossings of lines of the lattice the way is over one triangle, and how high it
    /// is over that changes evenly.
    fn follow(&self, grid: &Grid, mut side: Side, on_surface: bool) -> Flight {
        let mut leads_away = on_surface;
        let mut entered = 0.0;
        for left in self.crossings(grid) {
            if left <= entered {
                continue;
            }
            let patch = self.patch_between(grid, entered, left, leads_away);
            side = match patch {
                None => Side::Unknown,
                Some(_) if leads_away => Side::Above,
                Some(patch) => match self.over(&patch, side, entered, left) {
                    Ok(side) => side,
                    Err(met) => return Flight::Met(met),
                },
            };
            (entered, leads_away) = (left, false);
        }
        Flight::Reached(side)
    }

    /// The triangle under a piece of the way. A way that leaves the surface was found open over the
    /// triangles that it leads into ([`leads_into`]): no other one may be asked, also where rounding
    /// puts the middle of the piece on it, as along the rim of a hole.
    fn patch_between(&self, grid: &Grid, entered: f64, left: f64, leaves: bool) -> Option<Patch> {
        let [u, v, _] = self.step;
        patches_at(grid, &self.at((entered + left) / 2.0))
            .into_iter()
            .find(|patch| !leaves || leads_into(patch, &self.from, [u, v]))
    }

    /// Follows the way over one triangle: the side it is on afterwards, or where it meets it.
    fn over(&self, patch: &Patch, side: Side, entered: f64, left: f64) -> Result<Side, GridPoint> {
        let (before, after) = (self.height_over(patch, entered), self.height_over(patch, left));
        let side = match side {
            Side::Unknown if before >= 0.0 => Side::Above,
            Side::Unknown => Side::Below,
            known => known,
        };
        match side {
            Side::Above if after < 0.0 => {
                let before = before.max(0.0);
                let t = entered + (left - entered) * (before / (before - after));
                let (u, v) = patch.place_of(&self.at(t));
                Err(patch.point(u, v, ON_SIDE))
            }
            Side::Below if after > 0.0 => Ok(Side::Above),
            side => Ok(side),
        }
    }

    /// Where the way crosses columns, rows and diagonals of the map, in order, and its end.
    fn crossings(&self, grid: &Grid) -> Vec<f64> {
        let layout = grid.layout();
        let (east, south) = (f64::from(layout.columns()), f64::from(layout.rows()));
        let (column, row) = (self.from.column as f64, self.from.row as f64);
        let (west, east) = if layout.wraps() {
            (f64::NEG_INFINITY, f64::INFINITY)
        } else {
            (-column, east - column)
        };
        let (north, south) = (-row, south - row);
        let (u, v, [u_step, v_step, _]) = (self.from.u, self.from.v, self.step);

        let mut crossings = vec![1.0];
        cross(&mut crossings, u, u_step, west, east);
        cross(&mut crossings, v, v_step, north, south);
        cross(&mut crossings, u - v, u_step - v_step, west - south, east - north);
        crossings.sort_by(f64::total_cmp);
        crossings
    }

    fn at(&self, t: f64) -> GridPoint {
        let [u, v, up] = self.step.map(|part| t * part);
        let from = &self.from;
        let (u, v) = (from.u + u, from.v + v);
        GridPoint::from_sample(from.column, from.row, u, v, from.elevation + up)
    }

    /// Metres from a triangle's plane up to the way at `t`.
    fn height_over(&self, patch: &Patch, t: f64) -> f64 {
        let point = self.at(t);
        let (u, v) = patch.place_of(&point);
        point.elevation - patch.elevation(u, v)
    }
}

/// Adds where a coordinate that goes from `start` by `step` is a whole number from `lowest` to
/// `highest`.
fn cross(crossings: &mut Vec<f64>, start: f64, step: f64, lowest: f64, highest: f64) {
    let (low, high) = (start.min(start + step).max(lowest), start.max(start + step).min(highest));
    let mut line = low.ceil();
    while line <= high {
        let t = (line - start) / step;
        if t > 0.0 && t < 1.0 {
            crossings.push(t);
        }
        line += 1.0;
    }
}
