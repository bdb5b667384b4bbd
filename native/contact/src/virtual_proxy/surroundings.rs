//! What lies around the sphere: for each triangle near it a plane, between the triangle and the
//! sphere, behind which the sphere's centre may not go.

use super::nearest::{Nearest, nearest};
use crate::contact::Feature;
use crate::planes::{Plane, Scale, dot, length, unit};
use crate::way::face_of_first;
use surface::lattice::gradient;
use surface::{GridPoint, Half, Heightfield, Sample};

/// Touching triangles of which those behind them are left out: a sphere rests on three.
const MOST_SHIELDS: usize = 4;

/// The borders of a map.
pub(super) const MOST_WALLS: usize = 4;

/// So much nearer than the radius counts as a touch, for finding what lies behind: a matter of speed
/// alone.
const TOUCH: f64 = 1.001;

/// So much nearer than the radius counts as a touch, for telling what is touched in the midst of a
/// move.
const NEARLY: f64 = 1.0 + 1e-5;

/// The sphere, in cell widths.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sphere {
    pub(super) radius: f64,
    /// By how much it may be nearer than its radius to the surface: what rounding makes of a touch.
    pub(super) tolerance: f64,
}

/// Which of the planes between a triangle and the sphere.
#[derive(Clone, Copy, Debug)]
pub(super) enum Between {
    /// The triangle's own, where the sphere is above it: it leaves the most room to glide along the
    /// ground, but stops a sphere over the plane far from the triangle (paper figure 4).
    Glide,
    /// The plane across the shortest way to the triangle: the tangent plane of the configuration
    /// space obstacle, which stops a sphere only where it touches.
    Shortest,
}

/// Cells around a sphere's centre.
#[derive(Clone, Copy, Debug)]
pub(super) struct Shadow {
    column: i64,
    row: i64,
    columns: usize,
    rows: usize,
}

/// What was found around the sphere.
#[derive(Clone, Copy, Debug)]
pub(super) struct Survey {
    /// From the centre to the closest place of the surface, cell widths; infinite where there is none.
    pub(super) distance: f64,
    /// What that place is.
    pub(super) feature: Feature,
    /// Height of the centre over the surface, cell widths; `None` over a hole and off the map.
    pub(super) height: Option<f64>,
    /// Whether the sphere reaches through a triangle from behind: from within a hole.
    pub(super) is_behind: bool,
    /// Height of the highest sample around over the centre, cell widths.
    pub(super) highest: f64,
    /// How far the samples around reach from the centre, up or down, at least 1; cell widths.
    pub(super) extent: f64,
}

/// A triangle near the sphere, relative to its centre.
#[derive(Clone, Copy, Debug)]
struct Obstacle {
    corners: [[f64; 3]; 3],
    /// Planes that the centre may not go behind.
    glide: Plane,
    shortest: Plane,
    /// Whether the sphere touches it, or nearly.
    touches: bool,
}

/// Room for the surroundings of one sphere, allocated once.
pub(super) struct Surroundings {
    /// Of the samples over the centre, cell widths.
    heights: Vec<f64>,
    /// Triangles that touch: what lies wholly behind the plane of one need not be looked at.
    shields: Vec<Obstacle>,
    /// The others.
    obstacles: Vec<Obstacle>,
    planes: Vec<Plane>,
}

/// A look around a sphere.
struct Look<'a> {
    surroundings: &'a mut Surroundings,
    scale: &'a Scale,
    centre: &'a GridPoint,
    sphere: &'a Sphere,
    shadow: &'a Shadow,
    survey: Survey,
}

impl Shadow {
    /// The cells within `radius`, and one cell more on each side: so far a sphere may move at once.
    pub(super) fn new(centre: &GridPoint, radius: f64, scale: &Scale) -> Self {
        let (first, columns) = cells_within(centre.column, centre.u, radius + 1.0);
        let (first_row, rows) = cells_within(centre.row, centre.v, radius / scale.row + 1.0);
        Self { column: first, row: first_row, columns, rows }
    }

    pub(super) fn cells(&self) -> u32 {
        (self.columns * self.rows) as u32
    }

    /// The largest radius with which no shadow has more than `most_cells` cells.
    pub(super) fn largest_radius(most_cells: u32, scale: &Scale) -> f64 {
        // (2 r + 4) (2 r / row + 4) = most_cells, solved without cancellation.
        let row = scale.row;
        let rest = row * (f64::from(most_cells) - 16.0) / 4.0;
        rest / ((1.0 + row) + ((1.0 + row) * (1.0 + row) + rest).sqrt())
    }
}

/// The first cell within `reach` cells of a coordinate, and how many there are.
fn cells_within(cell: i64, fraction: f64, reach: f64) -> (i64, usize) {
    let (first, last) = ((fraction - reach).floor(), (fraction + reach).floor());
    (cell + first as i64, (last - first) as usize + 1)
}

impl Survey {
    /// Whether the sphere is wholly outside the ground.
    pub(super) fn is_clear(&self, sphere: &Sphere) -> bool {
        let is_deep = self.distance < sphere.radius - sphere.tolerance;
        !(is_deep || self.is_behind || self.is_underground(sphere))
    }

    /// Whether the centre itself is under the surface.
    pub(super) fn is_underground(&self, sphere: &Sphere) -> bool {
        self.height.is_some_and(|height| height < -sphere.tolerance)
    }

    /// What the sphere touches.
    pub(super) fn touched(&self, sphere: &Sphere) -> Feature {
        let touches = self.distance <= sphere.radius * NEARLY + sphere.tolerance;
        if touches { self.feature } else { Feature::Free }
    }
}

impl Surroundings {
    /// For shadows of at most so many cells.
    pub(super) fn with_room_for(cells: u32) -> Self {
        let cells = cells as usize;
        Self {
            // Of cells in any shape, there are at most so many corners.
            heights: Vec::with_capacity(2 * cells + 2),
            shields: Vec::with_capacity(MOST_SHIELDS),
            obstacles: Vec::with_capacity(2 * cells),
            planes: Vec::with_capacity(2 * cells + MOST_SHIELDS + MOST_WALLS),
        }
    }

    /// The planes around the sphere that was looked at last, and the walls, relative to its centre.
    pub(super) fn planes(
        &mut self,
        between: Between,
        walls: &[Option<Plane>; MOST_WALLS],
    ) -> &[Plane] {
        let Self { shields, obstacles, planes, .. } = self;
        let plane = |obstacle: &Obstacle| match between {
            Between::Glide => obstacle.glide,
            Between::Shortest => obstacle.shortest,
        };
        planes.clear();
        planes.extend(walls.iter().flatten());
        // These stand for what they cover as well, which is behind this plane of theirs.
        planes.extend(shields.iter().map(|shield| shield.shortest));
        planes.extend(obstacles.iter().map(plane));
        planes
    }

    /// Looks around a sphere at `centre`.
    pub(super) fn survey<S: Sample>(
        &mut self,
        field: &Heightfield<S>,
        scale: &Scale,
        centre: &GridPoint,
        sphere: &Sphere,
        shadow: &Shadow,
    ) -> Survey {
        self.read_heights(field, scale, centre, shadow);
        self.shields.clear();
        self.obstacles.clear();
        let height = (centre.elevation - ground_under(field, centre)) * scale.up;
        let survey = Survey {
            distance: f64::INFINITY,
            feature: Feature::Free,
            height: (!height.is_nan()).then_some(height),
            is_behind: false,
            // Void samples are NaN, which no maximum is.
            highest: self.heights.iter().copied().fold(f64::NEG_INFINITY, f64::max),
            extent: self.heights.iter().map(|height| height.abs()).fold(1.0, f64::max),
        };
        let mut look = Look { surroundings: self, scale, centre, sphere, shadow, survey };
        look.around();
        let survey = look.survey;
        self.leave_out_covered(sphere);
        survey
    }

    fn read_heights<S: Sample>(
        &mut self,
        field: &Heightfield<S>,
        scale: &Scale,
        centre: &GridPoint,
        shadow: &Shadow,
    ) {
        self.heights.clear();
        for row in 0..=shadow.rows as i64 {
            for column in 0..=shadow.columns as i64 {
                let sample = field.elevation(shadow.column + column, shadow.row + row);
                self.heights.push((sample - centre.elevation) * scale.up);
            }
        }
    }

    /// Leaves out the triangles behind those that touch.
    fn leave_out_covered(&mut self, sphere: &Sphere) {
        let Self { shields, obstacles, .. } = self;
        obstacles.retain(|obstacle| !is_covered(shields, &obstacle.corners, sphere));
    }
}

/// Elevation of the surface under a centre, of the rim of a hole as well; NaN over a hole and off the
/// map.
fn ground_under<S: Sample>(field: &Heightfield<S>, centre: &GridPoint) -> f64 {
    // A place on the line between two cells belongs to both, and one of them may be void.
    let cells = |cell: i64, part: f64| {
        let beyond = match part {
            0.0 => (cell - 1, 1.0),
            1.0 => (cell + 1, 0.0),
            _ => (cell, part),
        };
        [(cell, part), beyond]
    };
    for (column, u) in cells(centre.column, centre.u) {
        for (row, v) in cells(centre.row, centre.v) {
            let elevation = field.surface_elevation(&GridPoint { column, row, u, v, ..*centre });
            if !elevation.is_nan() {
                return elevation;
            }
        }
    }
    f64::NAN
}

/// Whether a triangle lies wholly behind the plane of one that touches: what keeps the sphere off
/// that one keeps it off both. So flat and convex ground around a touch is a single constraint, and
/// the sphere glides from triangle to triangle.
fn is_covered(shields: &[Obstacle], corners: &[[f64; 3]; 3], sphere: &Sphere) -> bool {
    shields.iter().any(|shield| {
        let Plane { normal, offset } = shield.shortest;
        let behind = offset - sphere.radius + sphere.tolerance / 4.0;
        corners.iter().all(|corner| dot(normal, *corner) <= behind)
    })
}

impl Look<'_> {
    fn around(&mut self) {
        for row in 0..self.shadow.rows {
            for column in 0..self.shadow.columns {
                self.at_cell(column, row);
            }
        }
    }

    fn at_cell(&mut self, column: usize, row: usize) {
        let corner = |east, south| self.corner(column + east, row + south);
        let (north_west, south_east) = (corner(0, 0), corner(1, 1));
        let (north_east, south_west) = (corner(1, 0), corner(0, 1));
        self.at_triangle(Half::NorthEast, [north_west, north_east, south_east]);
        self.at_triangle(Half::SouthWest, [north_west, south_east, south_west]);
    }

    /// A sample of the shadow, relative to the centre.
    fn corner(&self, column: usize, row: usize) -> [f64; 3] {
        let Self { shadow, centre, .. } = self;
        let columns = (shadow.column - centre.column + column as i64) as f64 - centre.u;
        let rows = (shadow.row - centre.row + row as i64) as f64 - centre.v;
        let height = self.surroundings.heights[row * (shadow.columns + 1) + column];
        [columns, -rows * self.scale.row, height]
    }

    fn at_triangle(&mut self, half: Half, corners: [[f64; 3]; 3]) {
        let rises = [1, 2].map(|corner| corners[corner][2] - corners[0][2]);
        let is_absent = (rises[0] + rises[1]).is_nan();
        if is_absent || is_covered(&self.surroundings.shields, &corners, self.sphere) {
            return;
        }
        let (east, south) = gradient(face_of_first(half), rises[0], rises[1]);
        let normal = unit([-east, south / self.scale.row, 1.0]);
        let nearest = nearest(&corners, normal);
        let distance = length(nearest.point);
        let height = -dot(normal, corners[0]);
        // Over ground all of it counts; over a hole, what the centre is above.
        let counts = self.survey.height.is_some() || height >= 0.0 || nearest.point[2] <= 0.0;
        if !counts {
            self.survey.is_behind |= distance < self.sphere.radius - self.sphere.tolerance;
            return;
        }
        if distance < self.survey.distance {
            (self.survey.distance, self.survey.feature) = (distance, nearest.feature);
        }
        self.keep(Obstacle::new(corners, normal, height, &nearest, self.sphere));
    }

    fn keep(&mut self, obstacle: Obstacle) {
        let Surroundings { shields, obstacles, .. } = &mut *self.surroundings;
        if obstacle.touches && shields.len() < MOST_SHIELDS {
            shields.push(obstacle);
        } else {
            obstacles.push(obstacle);
        }
    }
}

impl Obstacle {
    /// Of a triangle with this unit normal, and the centre at this height over its plane.
    fn new(
        corners: [[f64; 3]; 3],
        normal: [f64; 3],
        height: f64,
        nearest: &Nearest,
        sphere: &Sphere,
    ) -> Self {
        let Sphere { radius, tolerance } = *sphere;
        let distance = length(nearest.point);
        let own = Plane { normal, offset: radius - height };
        let is_over_it = nearest.feature == Feature::Face && height > 0.0;
        let shortest = if is_over_it || distance <= tolerance {
            own
        } else {
            let normal = nearest.point.map(|part| -part / distance);
            Plane { normal, offset: radius - distance }
        };
        let glide = if height >= radius { own } else { shortest };
        Self { corners, glide, shortest, touches: distance <= TOUCH * radius + tolerance }
    }
}
