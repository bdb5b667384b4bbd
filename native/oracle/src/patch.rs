//! Single triangles of the surface.

use crate::workspace::normalized;
use surface::{Grid, GridPoint};

/// Columns and rows of a triangle's corners from its cell's north-west sample: the half north-east
/// of the diagonal, and the half south-west of it.
const CORNERS: [[[f64; 2]; 3]; 2] =
    [[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0]], [[0.0, 0.0], [1.0, 1.0], [0.0, 1.0]]];

/// A triangle that is there: none of its corners is void or off the map.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Patch {
    pub(crate) column: i64,
    pub(crate) row: i64,
    south_west: bool,
    /// Metres, in the order of [`CORNERS`].
    elevations: [f64; 3],
}

/// All triangles that hold the point, seen from above: one, two on an edge, six on a vertex, less
/// those that are absent. Exact: fractions are compared with 0 and with each other.
pub(crate) fn patches_at(grid: &Grid, point: &GridPoint) -> Vec<Patch> {
    let point = normalized(point);
    let mut patches = Vec::with_capacity(6);
    for west in 0..=i64::from(point.u == 0.0) {
        for north in 0..=i64::from(point.v == 0.0) {
            for patch in patches_of_cell(grid, point.column - west, point.row - north) {
                let (u, v) = patch.place_of(&point);
                if patch.shares(u, v).iter().all(|share| *share >= 0.0) {
                    patches.push(patch);
                }
            }
        }
    }
    patches
}

/// The triangles of a cell that are there.
pub(crate) fn patches_of_cell(grid: &Grid, column: i64, row: i64) -> impl Iterator<Item = Patch> {
    [false, true].into_iter().filter_map(move |south_west| {
        let [a, b, c] = CORNERS[usize::from(south_west)];
        let elevation = |[u, v]: [f64; 2]| grid.elevation(column + u as i64, row + v as i64);
        let elevations = [elevation(a)?, elevation(b)?, elevation(c)?];
        Some(Patch { column, row, south_west, elevations })
    })
}

/// Whether a step (columns and rows) from a point of the triangle begins in it, not out of it over a
/// side that the point lies on.
pub(crate) fn leads_into(patch: &Patch, here: &GridPoint, [u, v]: [f64; 2]) -> bool {
    let (here_u, here_v) = patch.place_of(here);
    let (shares, changes) = (patch.shares(here_u, here_v), patch.share_changes(u, v));
    (0..3).all(|corner| shares[corner] > 0.0 || changes[corner] >= 0.0)
}

impl Patch {
    /// Columns and rows from the cell's north-west sample.
    pub(crate) fn place_of(&self, point: &GridPoint) -> (f64, f64) {
        let [u, v, _] = point.relative_to(self.column, self.row, 0.0);
        (u, v)
    }

    /// The shares of the three corners in a place of the plane (barycentric coordinates): all from
    /// 0 to 1 in the triangle; 0 on the side opposite the corner.
    pub(crate) fn shares(&self, u: f64, v: f64) -> [f64; 3] {
        if self.south_west { [1.0 - v, u, v - u] } else { [1.0 - u, u - v, v] }
    }

    /// By how much a step changes the shares of the corners.
    pub(crate) fn share_changes(&self, u: f64, v: f64) -> [f64; 3] {
        if self.south_west { [-v, u, v - u] } else { [-u, u - v, v] }
    }

    /// Of the plane, also beyond the triangle; metres.
    pub(crate) fn elevation(&self, u: f64, v: f64) -> f64 {
        let shares = self.shares(u, v);
        (0..3).map(|corner| shares[corner] * self.elevations[corner]).sum()
    }

    /// Metres that the plane rises for a column eastward and for a row southward.
    pub(crate) fn gradient(&self) -> [f64; 2] {
        let [a, b, c] = self.elevations;
        if self.south_west { [b - c, c - a] } else { [b - a, c - b] }
    }

    /// From one end to the other of the side opposite a corner: columns, rows and metres.
    pub(crate) fn side(&self, corner: usize) -> [f64; 3] {
        let corners = CORNERS[usize::from(self.south_west)];
        let (from, to) = ((corner + 1) % 3, (corner + 2) % 3);
        let [u, v] = [0, 1].map(|axis| corners[to][axis] - corners[from][axis]);
        [u, v, self.elevations[to] - self.elevations[from]]
    }

    /// The corners as columns, rows and metres from the cell's north-west sample.
    pub(crate) fn corners(&self) -> [[f64; 3]; 3] {
        let corners = CORNERS[usize::from(self.south_west)];
        [0, 1, 2].map(|k| [corners[k][0], corners[k][1], self.elevations[k]])
    }

    /// The point of the triangle over a place in it. Within `rounding` (cells) of a side or corner, or
    /// beyond one, it is brought exactly there.
    pub(crate) fn point(&self, u: f64, v: f64, rounding: f64) -> GridPoint {
        let (mut u, mut v) = (u.clamp(0.0, 1.0), v.clamp(0.0, 1.0));
        let is_near_side = self.shares(u, v).map(|share| share <= rounding);
        match is_near_side.iter().filter(|is_near| **is_near).count() {
            0 => {}
            1 => {
                let corner = is_near_side.iter().position(|is_near| *is_near).unwrap_or(0);
                (u, v) = self.brought_to_side(corner, u, v);
            }
            _ => {
                let corner = is_near_side.iter().position(|is_near| !is_near).unwrap_or(0);
                [u, v] = CORNERS[usize::from(self.south_west)][corner];
            }
        }
        GridPoint::from_sample(self.column, self.row, u, v, self.elevation(u, v))
    }

    /// The place brought exactly to the side opposite a corner.
    pub(crate) fn brought_to_side(&self, corner: usize, u: f64, v: f64) -> (f64, f64) {
        match (self.south_west, corner) {
            (false, 0) => (1.0, v),
            (false, 1) | (true, 2) => (u, u),
            (false, _) => (u, 0.0),
            (true, 0) => (u, 1.0),
            (true, _) => (0.0, v),
        }
    }
}
