//! Rays: the free-space collision test against a heightfield.
//!
//! Paper 3.5: the path is projected on the horizontal plane, a digital differential analyser visits
//! the cells under it in order, cells whose highest corner is below the path are culled, and in the
//! others each triangle is tested where the path enters and leaves it.
//!
//! Triangles are one-sided (paper 3.1): a ray meets them from above only. Which side the ray is on
//! is carried from triangle to triangle rather than computed anew, so that no rounding lets a ray
//! slip through between two of them.
//!
//! Most rays are as short as a triangle. Everything is compiled into its caller, so that what the
//! caller knows of the ray's beginning and does not ask of its end costs nothing.

use crate::heightfield::{Heightfield, plane_through};
use crate::lattice::{Half, Triangle};
use crate::point::GridPoint;
use crate::sample::Sample;

/// Where a point is, seen from the surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// Over it.
    Above,
    /// Under it: inside the ground.
    Below,
    /// In a hole, off the map, or not looked at yet: the next triangle on the way decides.
    Unknown,
}

/// Where a ray begins.
#[derive(Clone, Copy, Debug)]
pub enum Start {
    /// In space, on this side of the surface.
    Space(Side),
    /// On the surface, leading away over (or under) this triangle, which cannot be hit: the caller
    /// knows that the ray does not enter it. An absent triangle stands for the hole it leaves.
    Surface(Triangle),
}

/// How a ray ended.
#[derive(Clone, Copy, Debug)]
pub enum RayEnd {
    /// It met this triangle from above, at this point.
    Hit(Triangle, GridPoint),
    /// It reached its end on this side of the surface.
    Clear(Side),
    /// It went through as many cells as it was allowed, and stopped at this point.
    OutOfSteps(GridPoint, Side),
}

/// What a ray met, and what it cost.
#[derive(Clone, Copy, Debug)]
pub struct Cast {
    /// How it ended.
    pub end: RayEnd,
    /// Cells it went through.
    pub cells: u32,
}

/// Casts the straight segment from `from` to `to`, through `most_cells` cells at the most. All
/// numbers in both points must be finite.
#[inline(always)]
pub fn cast<S: Sample>(
    field: &Heightfield<S>,
    from: &GridPoint,
    start: Start,
    to: &GridPoint,
    most_cells: u32,
) -> Cast {
    let start_triangle = match start {
        Start::Surface(triangle) => triangle,
        Start::Space(_) => field.triangle_at(from),
    };
    let path = Path::new(from, to, start_triangle.column, start_triangle.row);
    let side = match start {
        Start::Space(side) => side,
        Start::Surface(triangle) if field.is_present(&triangle) => Side::Above,
        Start::Surface(_) => Side::Unknown,
    };
    let Some((entry, leave)) = path.over_map(field, from, to) else {
        return Cast { end: RayEnd::Clear(Side::Unknown), cells: 0 };
    };
    let mut walk = CellWalk::new(&path, entry, leave);
    let mut ray = Ray { field, path: &path, side: if entry > 0.0 { Side::Unknown } else { side } };

    // On the surface, only what lies behind the first triangle can be hit in the first cell.
    let mut skipped = match start {
        Start::Surface(triangle) => Some(triangle.half),
        Start::Space(_) => None,
    };
    for cells in 1..=most_cells {
        let (t0, t1) = (walk.entered, walk.leaves());
        if let Some((triangle, point)) = ray.through_cell(walk.column, walk.row, t0, t1, skipped) {
            return Cast { end: RayEnd::Hit(triangle, point), cells };
        }
        if !walk.advance() {
            let side = if leave < 1.0 { Side::Unknown } else { ray.side };
            return Cast { end: RayEnd::Clear(side), cells };
        }
        skipped = None;
    }
    let point = path.point(walk.column, walk.row, walk.entered);
    Cast { end: RayEnd::OutOfSteps(point, ray.side), cells: most_cells }
}

/// The segment in cells, relative to the north-west sample of its first cell; `t` runs from 0 to 1.
struct Path {
    column: i64,
    row: i64,
    /// Columns, rows and metres at t = 0.
    start: [f64; 3],
    /// Columns, rows and metres from t = 0 to t = 1.
    step: [f64; 3],
    /// Column and row of the cell that the path ends in. Whole numbers, so that rounding cannot
    /// carry a path that ends on a border beyond it.
    last_cell: [i64; 2],
}

impl Path {
    fn new(from: &GridPoint, to: &GridPoint, column: i64, row: i64) -> Self {
        let start = from.relative_to(column, row, 0.0);
        let end = to.relative_to(from.column, from.row, from.elevation);
        let step = [end[0] - from.u, end[1] - from.v, end[2]];
        let last_cell = [last_cell(to.column, to.u, step[0]), last_cell(to.row, to.v, step[1])];
        Self { column, row, start, step, last_cell }
    }

    /// Columns and rows from a cell's north-west sample at `t`.
    #[inline(always)]
    fn in_cell(&self, column: i64, row: i64, t: f64) -> (f64, f64) {
        let u = self.start[0] + t * self.step[0] - (column - self.column) as f64;
        let v = self.start[1] + t * self.step[1] - (row - self.row) as f64;
        (u, v)
    }

    fn elevation(&self, t: f64) -> f64 {
        self.start[2] + t * self.step[2]
    }

    /// The point at `t`, which lies in this cell but for rounding.
    fn point(&self, column: i64, row: i64, t: f64) -> GridPoint {
        let (u, v) = self.in_cell(column, row, t);
        let (u, v) = (u.clamp(0.0, 1.0), v.clamp(0.0, 1.0));
        GridPoint { column, row, u, v, elevation: self.elevation(t) }
    }

    /// The part of the path over the map, as (t of entry, t of exit); `None` where it misses.
    #[inline(always)]
    fn over_map<S: Sample>(
        &self,
        field: &Heightfield<S>,
        from: &GridPoint,
        to: &GridPoint,
    ) -> Option<(f64, f64)> {
        let (starts_on_map, ends_on_map) = (field.is_on_map(from), field.is_on_map(to));
        if starts_on_map && ends_on_map {
            return Some((0.0, 1.0));
        }
        let mut part = (0.0, 1.0);
        clip(&mut part, self.start[1], self.step[1], self.row, field.rows());
        if !field.wraps() {
            clip(&mut part, self.start[0], self.step[0], self.column, field.columns());
        }
        // An end on the very border is on the map, whatever the divisions above rounded to.
        let leave = if ends_on_map { 1.0 } else { part.1 };
        (part.0 <= leave).then_some((part.0, leave))
    }
}

/// The cell that a coordinate going by `step` ends in; a border belongs to the cell it comes from.
fn last_cell(cell: i64, fraction: f64, step: f64) -> i64 {
    if fraction == 0.0 && step > 0.0 {
        cell - 1
    } else if fraction == 1.0 && step < 0.0 {
        cell + 1
    } else {
        cell
    }
}

/// Clips a part of the path to `samples` lines of the grid, on one axis.
fn clip(part: &mut (f64, f64), start: f64, step: f64, first: i64, samples: i64) {
    let low = -first as f64 - start;
    let high = (samples - 1 - first) as f64 - start;
    if step == 0.0 {
        if low > 0.0 || high < 0.0 {
            *part = (1.0, 0.0);
        }
        return;
    }
    let (at_low, at_high) = (low / step, high / step);
    part.0 = part.0.max(at_low.min(at_high));
    part.1 = part.1.min(at_low.max(at_high));
}

/// The digital differential analyser: the cells under the path, in order.
struct CellWalk<'path> {
    path: &'path Path,
    column: i64,
    row: i64,
    /// t at which the path enters the cell.
    entered: f64,
    /// t at which the path ends, or leaves the map.
    ends: f64,
}

impl<'path> CellWalk<'path> {
    #[inline(always)]
    fn new(path: &'path Path, entry: f64, ends: f64) -> Self {
        let (mut column, mut row) = (path.column, path.row);
        if entry > 0.0 {
            // The path begins off the map: its first cell is where it enters. A border belongs to
            // the cell that the path goes into.
            let (u, v) = path.in_cell(column, row, entry);
            column += cell_entered(u, path.step[0]);
            row += cell_entered(v, path.step[1]);
        }
        Self { path, column, row, entered: entry, ends }
    }

    /// t at which the path leaves the cell, or ends.
    #[inline(always)]
    fn leaves(&self) -> f64 {
        self.leaves_column().min(self.leaves_row()).clamp(self.entered, self.ends)
    }

    /// Goes on to the next cell; false at the path's end.
    #[inline(always)]
    fn advance(&mut self) -> bool {
        let (by_column, by_row) = (self.leaves_column(), self.leaves_row());
        let next = by_column.min(by_row);
        if next >= self.ends {
            return false;
        }
        self.entered = next.max(self.entered);
        if by_column <= by_row {
            self.column += if self.path.step[0] > 0.0 { 1 } else { -1 };
        } else {
            self.row += if self.path.step[1] > 0.0 { 1 } else { -1 };
        }
        true
    }

    fn leaves_column(&self) -> f64 {
        self.boundary(0, self.column, self.path.column)
    }

    fn leaves_row(&self) -> f64 {
        self.boundary(1, self.row, self.path.row)
    }

    /// t at which the path leaves `cell` on one axis; infinite where it never does.
    #[inline(always)]
    fn boundary(&self, axis: usize, cell: i64, first: i64) -> f64 {
        let (start, step) = (self.path.start[axis], self.path.step[axis]);
        let last = self.path.last_cell[axis];
        if step > 0.0 && cell < last {
            ((cell + 1 - first) as f64 - start) / step
        } else if step < 0.0 && cell > last {
            ((cell - first) as f64 - start) / step
        } else {
            f64::INFINITY
        }
    }
}

/// The cell, counted from the one that the path begins in, that a coordinate going by `step` is in
/// or enters at `position`, where rounding may have left the position a little beside a border.
fn cell_entered(position: f64, step: f64) -> i64 {
    if step == 0.0 {
        // It stays in the cell that it begins in, also along the map's very border.
        return 0;
    }
    let nearest = position.round();
    let on_border = (position - nearest).abs() <= 4.0 * f64::EPSILON * position.abs().max(1.0);
    if !on_border {
        return position.floor() as i64;
    }
    nearest as i64 - i64::from(step < 0.0)
}

struct Ray<'a, S> {
    field: &'a Heightfield<'a, S>,
    path: &'a Path,
    side: Side,
}

impl<S: Sample> Ray<'_, S> {
    /// Follows the path through a cell from t0 to t1, and keeps the side it is on.
    #[inline(always)]
    fn through_cell(
        &mut self,
        column: i64,
        row: i64,
        t0: f64,
        t1: f64,
        skipped: Option<Half>,
    ) -> Option<(Triangle, GridPoint)> {
        if skipped.is_none() && self.is_culled(column, row, t0, t1) {
            self.side = Side::Above;
            return None;
        }
        let triangle = |half| Triangle { column, row, half };
        let (u0, v0) = self.path.in_cell(column, row, t0);
        let (u1, v1) = self.path.in_cell(column, row, t1);
        // Positive in the north-east half, negative in the south-west one.
        let (before, after) = (u0 - v0, u1 - v1);
        if let Some(half) = skipped {
            let crosses = match half {
                Half::NorthEast => after < 0.0,
                Half::SouthWest => after > 0.0,
            };
            let at_diagonal = (before / (before - after)).clamp(0.0, 1.0);
            let middle = if crosses { t0 + (t1 - t0) * at_diagonal } else { t1 };
            return crosses.then(|| self.over(triangle(half.other()), middle, t1)).flatten();
        }
        let half = if before > 0.0 || (before == 0.0 && after > 0.0) {
            Half::NorthEast
        } else if before < 0.0 || after < 0.0 {
            Half::SouthWest
        } else {
            // Along the diagonal both halves agree; ask the one that exists.
            let present = self.field.is_present(&triangle(Half::NorthEast));
            if present { Half::NorthEast } else { Half::SouthWest }
        };
        let crosses = (before > 0.0 && after < 0.0) || (before < 0.0 && after > 0.0);
        if !crosses {
            return self.over(triangle(half), t0, t1);
        }
        let middle = t0 + (t1 - t0) * (before / (before - after));
        self.over(triangle(half), t0, middle)
            .or_else(|| self.over(triangle(half.other()), middle, t1))
    }

    /// Paper 3.5, figure 11b: whether the path is above all four corners. Void corners do not
    /// count: where the path is that high, it is above whatever is there.
    #[inline(always)]
    fn is_culled(&self, column: i64, row: i64, t0: f64, t1: f64) -> bool {
        let (field, path) = (self.field, self.path);
        let [a, b, c, d] = field.elevations_near(column, row, [(0, 0), (1, 0), (0, 1), (1, 1)]);
        path.elevation(t0).min(path.elevation(t1)) > a.max(b).max(c.max(d))
    }

    /// Follows the path over one triangle from t0 to t1.
    #[inline(always)]
    fn over(&mut self, triangle: Triangle, t0: f64, t1: f64) -> Option<(Triangle, GridPoint)> {
        let corners = self.field.corner_elevations(&triangle);
        let entered_at = self.height_above(&triangle, corners, t0);
        let left_at = self.height_above(&triangle, corners, t1);
        if left_at.is_nan() {
            self.side = Side::Unknown;
            return None;
        }
        if self.side == Side::Unknown {
            self.side = if entered_at >= 0.0 { Side::Above } else { Side::Below };
        }
        match self.side {
            Side::Above if left_at < 0.0 => {
                let entered_at = entered_at.max(0.0);
                let t = t0 + (t1 - t0) * (entered_at / (entered_at - left_at));
                Some((triangle, self.point_on(&triangle, corners, t)))
            }
            Side::Below if left_at > 0.0 => {
                self.side = Side::Above;
                None
            }
            _ => None,
        }
    }

    /// Metres from the plane through a triangle's `corners` up to the path at `t`.
    #[inline(always)]
    fn height_above(&self, triangle: &Triangle, corners: [f64; 3], t: f64) -> f64 {
        let (u, v) = self.path.in_cell(triangle.column, triangle.row, t);
        self.path.elevation(t) - plane_through(triangle.half, corners, u, v)
    }

    /// The point of a triangle under the path at `t`.
    fn point_on(&self, triangle: &Triangle, corners: [f64; 3], t: f64) -> GridPoint {
        let point = self.path.point(triangle.column, triangle.row, t);
        let elevation = plane_through(triangle.half, corners, point.u, point.v);
        GridPoint { elevation, ..point }
    }
}
