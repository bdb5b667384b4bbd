//! Elevations of a grid, for one sample type.

use crate::grid::Grid;
use crate::lattice::{Half, Triangle};
use crate::point::{FARTHEST_ELEVATION, GridPoint};
use crate::sample::Sample;
use std::marker::PhantomData;

/// Reads the samples of a grid one by one, converting as it reads. A small copyable view.
///
/// "No elevation" (void samples, samples that are not finite or beyond 1e100 m, places off the map) is NaN, which
/// makes every comparison false: code that asks "is the ray below this triangle?" need not ask
/// first whether the triangle exists.
pub struct Heightfield<'grid, S> {
    first: *const u8,
    row_stride: usize,
    /// Bytes from the first sample to the last one.
    last_offset: usize,
    rows: i64,
    columns: i64,
    wraps: bool,
    scale: f64,
    value_offset: f64,
    /// NaN, which equals nothing, where the grid has no void value.
    void: f64,
    /// Every sample is its elevation: whole numbers of metres without a void value.
    is_plain: bool,
    grid: PhantomData<(&'grid Grid, S)>,
}

impl<S> Clone for Heightfield<'_, S> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<S> Copy for Heightfield<'_, S> {}

impl<'grid, S: Sample> Heightfield<'grid, S> {
    /// A view on `grid`, whose samples must be of type `S` (see [`on_heightfield!`](crate::on_heightfield)).
    #[inline(always)]
    pub fn new(grid: &'grid Grid) -> Self {
        let layout = grid.layout();
        assert_eq!(S::BYTES, layout.sample().bytes(), "the reader must fit the layout");
        Self {
            // The layout was held against the bytes when the grid was made.
            first: grid.storage().address().wrapping_add(layout.offset() as usize),
            row_stride: layout.row_stride() as usize,
            last_offset: (layout.rows() - 1) as usize * layout.row_stride() as usize
                + (layout.columns() - 1) as usize * S::BYTES,
            rows: i64::from(layout.rows()),
            columns: i64::from(layout.columns()),
            wraps: layout.wraps(),
            scale: layout.scale(),
            value_offset: layout.value_offset(),
            void: layout.void().unwrap_or(f64::NAN),
            is_plain: S::IS_INTEGER
                && layout.void().is_none()
                && (layout.scale(), layout.value_offset()) == (1.0, 0.0),
            grid: PhantomData,
        }
    }

    /// Metres; NaN where there is no elevation.
    #[inline(always)]
    pub fn elevation(&self, column: i64, row: i64) -> f64 {
        let Some(column) = self.stored_column(column) else {
            return f64::NAN;
        };
        if row as u64 >= self.rows as u64 {
            return f64::NAN;
        }
        let offset = row as usize * self.row_stride + column as usize * S::BYTES;
        // SAFETY: column and row are inside the layout, which was held against the length of the
        // bytes; a mapped page that vanishes is replaced by the guard.
        self.converted(unsafe { S::read(self.first.add(offset)) })
    }

    /// Elevations at fixed `steps` (columns east, rows south) from a sample, metres; NaN where there
    /// is none. Faster than one by one: the map's edges are looked for once.
    #[inline(always)]
    pub fn elevations_near<const N: usize>(
        &self,
        column: i64,
        row: i64,
        steps: [(i64, i64); N],
    ) -> [f64; N] {
        let reach = |step: fn(&(i64, i64)) -> i64| {
            let all = steps.iter().map(step);
            all.fold((0, 0), |(low, high), step| (low.min(step), high.max(step)))
        };
        let ((west, east), (north, south)) = (reach(|step| step.0), reach(|step| step.1));
        let is_inside = column + west >= 0
            && column + east < self.columns
            && row + north >= 0
            && row + south < self.rows;
        if !is_inside {
            return self.elevations_one_by_one(column, row, steps);
        }
        let here = row as usize * self.row_stride + column as usize * S::BYTES;
        let row_stride = self.row_stride as i64;
        let mut elevations = [0.0; N];
        for (elevation, (columns, rows)) in elevations.iter_mut().zip(steps) {
            let offset = rows * row_stride + columns * S::BYTES as i64;
            // SAFETY: as above; the farthest of the steps have been held against the layout.
            let sample = unsafe { S::read(self.first.add(here).offset(offset as isize)) };
            *elevation = self.converted(sample);
        }
        elevations
    }

    /// Elevations of the samples that begin `steps` bytes from `offset`, which is itself counted from
    /// the first sample; NaN unless all from `reach.0` to `reach.1` bytes from there lie inside the
    /// bytes of the grid.
    ///
    /// # Safety
    /// Every step must be within the reach.
    #[inline(always)]
    pub(crate) unsafe fn elevations_at<const N: usize>(
        &self,
        offset: i64,
        steps: [i64; N],
        reach: (i64, i64),
    ) -> [f64; N] {
        let mut elevations = [f64::NAN; N];
        let (lowest, highest) = (offset + reach.0, offset + reach.1);
        if lowest >= 0 && highest <= self.last_offset as i64 {
            for (elevation, step) in elevations.iter_mut().zip(steps) {
                debug_assert!((reach.0..=reach.1).contains(&step));
                // SAFETY: within the reach, the sample begins between the first and the last one's
                // offset, which were held against the length of the bytes.
                let sample = unsafe { S::read(self.first.offset((offset + step) as isize)) };
                *elevation = self.converted(sample);
            }
        }
        elevations
    }

    /// Bytes from the first sample to another, or to where it would be; far beyond the grid, any.
    #[inline(always)]
    pub(crate) fn offset(&self, column: i64, row: i64) -> i64 {
        row.wrapping_mul(self.row_stride as i64).wrapping_add(column * S::BYTES as i64)
    }

    /// Asks for the cache line that lies so many bytes from the first sample.
    #[inline(always)]
    pub(crate) fn prefetch(&self, offset: i64) {
        let address = self.first.wrapping_offset(offset as isize);
        #[cfg(target_arch = "x86_64")]
        // SAFETY: asking for a line reads nothing and never faults, wherever the address leads.
        unsafe {
            use std::arch::x86_64::{_MM_HINT_T0, _mm_prefetch};
            _mm_prefetch::<_MM_HINT_T0>(address.cast());
        }
        #[cfg(not(target_arch = "x86_64"))]
        let _ = address;
    }

    /// Bytes from one row to the next.
    pub(crate) fn row_stride(&self) -> i64 {
        self.row_stride as i64
    }

    /// The stored column of the same place.
    #[inline(always)]
    pub(crate) fn period_column(&self, column: i64) -> i64 {
        self.stored_column(column).unwrap_or(column)
    }

    #[cold]
    #[inline(never)]
    fn elevations_one_by_one<const N: usize>(
        &self,
        column: i64,
        row: i64,
        steps: [(i64, i64); N],
    ) -> [f64; N] {
        steps.map(|(columns, rows)| self.elevation(column + columns, row + rows))
    }

    #[inline(always)]
    fn converted(&self, sample: f64) -> f64 {
        if self.is_plain {
            return sample;
        }
        let elevation = sample * self.scale + self.value_offset;
        // The comparison is false for NaN too.
        let is_height = elevation.abs() <= FARTHEST_ELEVATION;
        if is_height && sample != self.void { elevation } else { f64::NAN }
    }

    /// Elevations of a triangle's corners, in the order of [`Triangle::corners`], metres.
    #[inline(always)]
    pub fn corner_elevations(&self, triangle: &Triangle) -> [f64; 3] {
        let Triangle { column, row, half } = *triangle;
        match half {
            Half::NorthEast => self.elevations_near(column, row, [(0, 0), (1, 0), (1, 1)]),
            Half::SouthWest => self.elevations_near(column, row, [(0, 0), (1, 1), (0, 1)]),
        }
    }

    /// Whether none of a triangle's corners is void or off the map.
    #[inline(always)]
    pub fn is_present(&self, triangle: &Triangle) -> bool {
        self.corner_elevations(triangle).iter().all(|elevation| !elevation.is_nan())
    }

    /// Elevation of the plane through a triangle at `u` cells east and `v` cells south of its
    /// cell's north-west sample; also beyond the triangle. NaN where the triangle is absent.
    #[inline(always)]
    pub fn plane_elevation(&self, triangle: &Triangle, u: f64, v: f64) -> f64 {
        plane_through(triangle.half, self.corner_elevations(triangle), u, v)
    }

    /// The triangle over or under `point`. On a shared edge it is one of the two, and one that is
    /// on the map if any is.
    pub fn triangle_at(&self, point: &GridPoint) -> Triangle {
        let (mut column, mut row, mut u, mut v) = (point.column, point.row, point.u, point.v);
        if !self.wraps && column == self.columns - 1 && u == 0.0 {
            (column, u) = (column - 1, 1.0);
        }
        if row == self.rows - 1 && v == 0.0 {
            (row, v) = (row - 1, 1.0);
        }
        let half = if u >= v { Half::NorthEast } else { Half::SouthWest };
        Triangle { column, row, half }
    }

    /// Elevation of the triangulated surface under or over `point`; NaN in a hole or off the map.
    pub fn surface_elevation(&self, point: &GridPoint) -> f64 {
        let triangle = self.triangle_at(point);
        let [u, v, _] = point.relative_to(triangle.column, triangle.row, 0.0);
        let elevation = self.plane_elevation(&triangle, u, v);
        if elevation.is_nan() && u == v {
            // On the diagonal of a cell whose one half is absent.
            let other = Triangle { half: triangle.half.other(), ..triangle };
            return self.plane_elevation(&other, u, v);
        }
        elevation
    }

    /// The nearest place on the map to `point`, at the same elevation. Only the horizontal edges of
    /// the map count; holes do not. On a grid that wraps there is no edge in the east and west.
    pub fn nearest_on_map(&self, point: &GridPoint) -> GridPoint {
        let mut near = *point;
        (near.row, near.v) = clamp_cell(near.row, near.v, self.rows);
        if !self.wraps {
            (near.column, near.u) = clamp_cell(near.column, near.u, self.columns);
        }
        near
    }

    /// Whether `point` is over or under the map (holes included).
    pub fn is_on_map(&self, point: &GridPoint) -> bool {
        self.nearest_on_map(point) == *point
    }

    pub(crate) fn rows(&self) -> i64 {
        self.rows
    }

    pub(crate) fn columns(&self) -> i64 {
        self.columns
    }

    pub(crate) fn wraps(&self) -> bool {
        self.wraps
    }

    #[inline(always)]
    fn stored_column(&self, column: i64) -> Option<i64> {
        if (column as u64) < self.columns as u64 {
            Some(column)
        } else if self.wraps {
            Some(column.rem_euclid(self.columns))
        } else {
            None
        }
    }
}

/// Elevation of the plane through a triangle's corners (in the order of [`Triangle::corners`]) at `u`
/// cells east and `v` cells south of the first one.
#[inline(always)]
pub(crate) fn plane_through(half: Half, corners: [f64; 3], u: f64, v: f64) -> f64 {
    let [first, second, third] = corners;
    match half {
        Half::NorthEast => first + u * (second - first) + v * (third - second),
        Half::SouthWest => first + u * (second - third) + v * (third - first),
    }
}

fn clamp_cell(cell: i64, fraction: f64, samples: i64) -> (i64, f64) {
    if cell < 0 {
        (0, 0.0)
    } else if cell >= samples - 1 {
        (samples - 1, 0.0)
    } else {
        (cell, fraction)
    }
}

/// Runs an expression with `$field` as the [`Heightfield`] of a grid's own sample type: one
/// compiled copy for each type, one choice for each call.
#[macro_export]
macro_rules! on_heightfield {
    ($grid:expr, $field:ident => $body:expr) => {{
        use $crate::{ByteOrder::*, Heightfield, SampleType::*, readers::*};
        let grid: &$crate::Grid = $grid;
        macro_rules! with {
            ($reader:ty) => {{
                let $field = Heightfield::<$reader>::new(grid);
                $body
            }};
        }
        match (grid.layout().sample(), grid.layout().byte_order()) {
            (I16, Big) => with!(I16Big),
            (I16, Little) => with!(I16Little),
            (U16, Big) => with!(U16Big),
            (U16, Little) => with!(U16Little),
            (I32, Big) => with!(I32Big),
            (I32, Little) => with!(I32Little),
            (F32, Big) => with!(F32Big),
            (F32, Little) => with!(F32Little),
            (F64, Big) => with!(F64Big),
            (F64, Little) => with!(F64Little),
        }
    }};
}

impl Grid {
    /// The sample in metres; `None` where it is void or off the map.
    pub fn elevation(&self, column: i64, row: i64) -> Option<f64> {
        let elevation = on_heightfield!(self, field => field.elevation(column, row));
        (!elevation.is_nan()).then_some(elevation)
    }

    /// The triangulated surface over or under `point`, metres; `None` in a hole or off the map.
    pub fn surface_elevation(&self, point: &GridPoint) -> Option<f64> {
        let elevation = on_heightfield!(self, field => field.surface_elevation(point));
        (!elevation.is_nan()).then_some(elevation)
    }
}
