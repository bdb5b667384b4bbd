//! What lies on a point proxy's way, known from the feature that it lies on.

use crate::proxy::{Place, Proxy};
use surface::lattice::{along_edges, counterclockwise, face, sector};
use surface::{GridPoint, Half, Heightfield, Sample, Triangle};

/// What a proxy at `position` moves toward: on the map, the nearest place on the map to the goal,
/// so that the map's border is a wall.
pub(crate) fn target<S: Sample>(
    field: &Heightfield<S>,
    position: &GridPoint,
    goal: &GridPoint,
) -> GridPoint {
    if field.is_on_map(position) { field.nearest_on_map(goal) } else { *goal }
}

/// For a proxy on the surface: the triangle that the way to `target` leads over, and whether that
/// triangle blocks it (paper 3.5: only one can). `None` in space.
#[inline(always)]
pub(crate) fn ahead<S: Sample>(
    field: &Heightfield<S>,
    proxy: &Proxy,
    target: &GridPoint,
) -> Option<(Triangle, bool)> {
    let triangle = match proxy.place {
        Place::Space(_) => return None,
        Place::Face(triangle) => triangle,
        Place::Edge { column, row, k } => {
            let from = proxy.position.relative_to(column, row, 0.0);
            let to = target.relative_to(column, row, 0.0);
            beside_edge(field, (column, row), k, to[0] - from[0], to[1] - from[1])
        }
        Place::Vertex { column, row } => {
            let [u, v, _] = target.relative_to(column, row, 0.0);
            around_vertex(field, (column, row), u, v)
        }
    };
    // Not blocked where the height is NaN: the triangle is absent.
    Some((triangle, height_over(field, &triangle, target) <= 0.0))
}

/// Which face of its first corner a triangle is (see [`surface::lattice`]).
pub(crate) fn face_of_first(half: Half) -> usize {
    match half {
        Half::NorthEast => 0,
        Half::SouthWest => 1,
    }
}

/// Metres from the plane of `triangle` up to `point`; NaN where the triangle is absent.
#[inline(always)]
fn height_over<S: Sample>(field: &Heightfield<S>, triangle: &Triangle, point: &GridPoint) -> f64 {
    let [u, v, _] = point.relative_to(triangle.column, triangle.row, 0.0);
    point.elevation - field.plane_elevation(triangle, u, v)
}

/// Cells over the ground from one point to the other along the longer axis, rounded up, at least 1.
pub(crate) fn cells_between(from: &GridPoint, to: &GridPoint) -> u32 {
    let [columns, rows, _] = to.relative_to(from.column, from.row, 0.0);
    let longer = (columns - from.u).abs().max((rows - from.v).abs());
    (longer.ceil() as u32).max(1)
}

/// The triangle beside an edge toward (`u`, `v`); along the edge, one that exists if either does.
fn beside_edge<S: Sample>(
    field: &Heightfield<S>,
    (column, row): (i64, i64),
    k: usize,
    u: f64,
    v: f64,
) -> Triangle {
    let (_, across) = along_edges(k, u, v);
    let clockwise_of = face(column, row, k);
    let is_along = across == 0.0;
    if across > 0.0 || (is_along && field.is_present(&clockwise_of)) {
        clockwise_of
    } else {
        face(column, row, counterclockwise(k))
    }
}

/// The triangle of a vertex toward (`u`, `v`); along an edge, one that exists if either does.
fn around_vertex<S: Sample>(
    field: &Heightfield<S>,
    (column, row): (i64, i64),
    u: f64,
    v: f64,
) -> Triangle {
    let first = face(column, row, sector(u, v));
    if field.is_present(&first) {
        return first;
    }
    let leads_over = |&k: &usize| {
        let (first, second) = along_edges(k, u, v);
        first >= 0.0 && second >= 0.0 && field.is_present(&face(column, row, k))
    };
    (0..6).find(leads_over).map_or(first, |k| face(column, row, k))
}
