//! The constraints of a god-object: planes of triangles and walls, at most three.

use crate::contact::Feature;
use crate::planes::{Plane, Scale, dot, project};
use crate::proxy::Place;
use crate::way::face_of_first;
use surface::lattice::{along_edges, gradient};
use surface::ray::Side;
use surface::{GridPoint, Heightfield, Sample, Triangle};

/// The constraints met so far in one update, in order.
#[derive(Clone, Copy)]
pub(super) struct Constraints {
    /// What the planes are relative to: the first triangle's first corner.
    pub(super) pivot: GridPoint,
    planes: [Plane; 3],
    /// The triangles that the planes belong to; none of a wall.
    triangles: [Option<Triangle>; 3],
    pub(super) count: usize,
}

/// Where a way leaves the map.
#[derive(Clone, Copy)]
pub(super) struct Wall {
    pub(super) point: GridPoint,
    /// Of the wall, into the map, in the workspace.
    pub(super) normal: [f64; 3],
}

impl Constraints {
    pub(super) fn none() -> Self {
        let plane = Plane { normal: [0.0, 0.0, 1.0], offset: 0.0 };
        let pivot = GridPoint::new(0.0, 0.0, 0.0);
        Self { pivot, planes: [plane; 3], triangles: [None; 3], count: 0 }
    }

    pub(super) fn planes(&self) -> &[Plane] {
        &self.planes[..self.count]
    }

    fn triangles(&self) -> impl DoubleEndedIterator<Item = &Triangle> {
        self.triangles[..self.count].iter().flatten()
    }

    /// Whether the plane of this triangle is one.
    pub(super) fn hold(&self, triangle: &Triangle) -> bool {
        self.triangles().any(|held| held == triangle)
    }

    /// Whether a border of the map is one.
    pub(super) fn hold_a_wall(&self) -> bool {
        self.triangles[..self.count].iter().any(Option::is_none)
    }

    /// How many hold, as the feature that so many planes meet in.
    pub(super) fn feature(&self) -> Feature {
        match self.count {
            0 => Feature::Free,
            1 => Feature::Face,
            2 => Feature::Edge,
            _ => Feature::Vertex,
        }
    }

    /// Adds the plane of a triangle.
    pub(super) fn add_triangle<S: Sample>(
        &mut self,
        field: &Heightfield<S>,
        scale: &Scale,
        triangle: Triangle,
    ) {
        let [first, second, third] = field.corner_elevations(&triangle);
        let slope = gradient(face_of_first(triangle.half), second - first, third - first);
        let (column, row) = (triangle.column, triangle.row);
        let corner = GridPoint { column, row, u: 0.0, v: 0.0, elevation: first };
        if self.count == 0 {
            self.pivot = corner;
        }
        self.add(scale, scale.normal(slope), &corner, Some(triangle));
    }

    /// Adds a border of the map.
    pub(super) fn add_wall(&mut self, scale: &Scale, wall: &Wall) {
        self.add(scale, wall.normal, &wall.point, None);
    }

    fn add(
        &mut self,
        scale: &Scale,
        normal: [f64; 3],
        point: &GridPoint,
        triangle: Option<Triangle>,
    ) {
        let offset = dot(normal, scale.between(&self.pivot, point));
        self.planes[self.count] = Plane { normal, offset };
        self.triangles[self.count] = triangle;
        self.count += 1;
        self.keep_regular();
    }

    /// Lets go of the older planes that are singular with the newest, of one if that will do.
    fn keep_regular(&mut self) {
        if self.is_regular() {
            return;
        }
        let all = *self;
        for older in 0..all.count - 1 {
            *self = all.without(older);
            if self.is_regular() {
                return;
            }
        }
        *self = all;
        while self.count > 1 {
            *self = self.without(0);
        }
    }

    fn is_regular(&self) -> bool {
        project([0.0; 3], self.planes()).is_some()
    }

    fn without(&self, index: usize) -> Self {
        let mut fewer = *self;
        fewer.planes.copy_within(index + 1.., index);
        fewer.triangles.copy_within(index + 1.., index);
        fewer.count -= 1;
        fewer
    }

    /// The height of the planes at a place on all of them; of what rounding makes of it, the highest,
    /// so that no way there leads under one.
    pub(super) fn elevation_at<S: Sample>(&self, field: &Heightfield<S>, point: &GridPoint) -> f64 {
        let heights = self.triangles().map(|triangle| {
            let [u, v, _] = point.relative_to(triangle.column, triangle.row, 0.0);
            field.plane_elevation(triangle, u, v)
        });
        heights.fold(f64::NEG_INFINITY, f64::max)
    }

    /// What a proxy at `point` lies on: the newest of the triangles that reach so far, or nothing, and
    /// it floats.
    pub(super) fn place_at<S: Sample>(&self, field: &Heightfield<S>, point: &GridPoint) -> Place {
        let is_under = |triangle: &&Triangle| {
            let [u, v, _] = point.relative_to(triangle.column, triangle.row, 0.0);
            let (second, third) = along_edges(face_of_first(triangle.half), u, v);
            second >= 0.0 && third >= 0.0 && second + third <= 1.0 && field.is_present(triangle)
        };
        let under = self.triangles().rev().find(is_under);
        under.map_or(Place::Space(Side::Above), |triangle| Place::Face(*triangle))
    }
}
