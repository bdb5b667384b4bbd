//! Steepest descent of the distance to the goal, over faces, edges and vertices.

use super::Walk;
use super::face::{Face, LatticeEdge, share};
use crate::contact::Counters;
use crate::proxy::Place;
use surface::lattice::{EAST, SOUTH, along_edges, counterclockwise, face, sector};
use surface::{GridPoint, Sample, Triangle};

/// How a descent ended.
pub(super) enum Descent {
    /// At a local minimum of the distance.
    AtRest,
    /// The straight way to the goal is open, over (or under) this triangle.
    Open(Triangle),
    /// The step budget is used up.
    OutOfSteps,
    /// It came to a place from which the next look decides.
    GoesOn,
}

/// A rest on an edge is one on its vertex within so many steps of the last place of the way to the goal.
const BESIDE_VERTEX: f64 = 4.0 * f64::EPSILON;

/// No rest farther from a vertex, as a share of the edge, is asked whether it is one on it.
const FARTHEST_BESIDE: f64 = 1e-6;

/// For each face k of a vertex, which corner of the face the vertex is (see [`Face`]).
const CORNER: [usize; 6] = [0, 2, 1, 0, 2, 1];

/// The other two edges of a face: the ones that lead to and from the corner opposite.
const OTHERS: [(usize, usize); 3] = [(1, 2), (0, 2), (0, 1)];

impl<S: Sample> Walk<'_, '_, S> {
    /// One look from where the proxy lies, and the walk over faces that follows from it.
    #[inline(always)]
    pub(super) fn descend(&mut self, has_landed: bool, counters: &mut Counters) -> Descent {
        match self.proxy.place {
            Place::Face(triangle) => self.descend_from_face(&triangle, has_landed, counters),
            Place::Edge { column, row, k } => {
                self.descend_from_edge(LatticeEdge::of_vertex(column, row, k), counters)
            }
            Place::Vertex { column, row } => self.descend_from_vertex(column, row, counters),
            Place::Space(_) => Descent::AtRest,
        }
    }

    /// A proxy that has just landed on the face is not sent away again by rounding.
    #[inline(always)]
    fn descend_from_face(
        &mut self,
        triangle: &Triangle,
        has_landed: bool,
        counters: &mut Counters,
    ) -> Descent {
        counters.faces += 1;
        let face = Face::new(self.search, triangle);
        let shares = face.shares_at(&self.proxy.position);
        if !(face.goal_height <= 0.0) && !(has_landed && face.holds_within_rounding()) {
            if face.norm.is_finite() {
                self.proxy.position = face.point(shares[1], shares[2]);
            }
            return Descent::Open(*triangle);
        }
        match face.exit(&shares) {
            None => self.rest_on_face(&face, None, counters),
            Some((edge, along)) => self.cross(&face, edge, along, counters),
        }
    }

    /// Walks on across an edge of a face, where the budget allows.
    #[inline(always)]
    fn cross(&mut self, from: &Face, edge: usize, along: f64, counters: &mut Counters) -> Descent {
        let face = from.across(edge, self.search);
        if counters.steps() >= self.step_budget {
            let (edge, at) = face.lattice_edge(edge, along);
            self.stand_on_edge(edge, at);
            return Descent::OutOfSteps;
        }
        counters.faces += 1;
        self.walk(face, edge, along, counters)
    }

    #[inline(always)]
    fn descend_from_edge(&mut self, edge: LatticeEdge, counters: &mut Counters) -> Descent {
        // Both faces beside it are looked at.
        counters.faces += 2;
        let (triangle, side) = edge.north_eastern();
        let first = Face::new(self.search, &triangle);
        let second = first.across(side, self.search);
        let along = edge.along(&self.proxy.position);

        let inward = first.goal_inward(side);
        let leads_over_first = inward > 0.0 || (inward == 0.0 && !first.goal_height.is_nan());
        let ahead = if leads_over_first { &first } else { &second };
        if !(ahead.goal_height <= 0.0) {
            self.proxy.position = self.point_on_edge(edge, along);
            return Descent::Open(ahead.triangle());
        }
        match (first.draws(side), second.draws(side)) {
            // A ridge: down the side on which the plane is nearer to the goal.
            (true, true) if second.is_nearer_than(&first) => {
                self.walk(second, side, 1.0 - along, counters)
            }
            (true, _) => self.walk(first, side, along, counters),
            (false, true) => self.walk(second, side, 1.0 - along, counters),
            (false, false) => self.slide(edge),
        }
    }

    #[inline(never)]
    fn descend_from_vertex(&mut self, column: i64, row: i64, counters: &mut Counters) -> Descent {
        // All faces around it are looked at.
        counters.faces += 6;
        self.stand_on_vertex(column, row);
        let elevation = self.proxy.position.elevation;
        let goal = self.search.target.relative_to(column, row, elevation);
        let faces = [0, 1, 2, 3, 4, 5].map(|k| Face::new(self.search, &face(column, row, k)));
        let ahead = face_ahead(&faces, goal);
        if !(faces[ahead].goal_height <= 0.0) {
            return Descent::Open(faces[ahead].triangle());
        }
        let distance = self.search.weights.squared(goal);
        if !self.progress.comes_nearer(distance) {
            return Descent::AtRest;
        }

        let beside = self.beside_vertex(goal);
        let mut best = (0.0, None);
        for (k, face) in faces.iter().enumerate() {
            if face.goal_height <= 0.0 && face.foot_is_ahead_of(CORNER[k]) {
                let gain = distance - face.squared_plane_distance(self.search.up);
                if gain > best.0 {
                    best = (gain, Some((k, true)));
                }
            }
            let is_way = faces[counterclockwise(k)].norm.is_finite() || face.norm.is_finite();
            let gain = if is_way { self.gain_along(column, row, k, goal, beside) } else { 0.0 };
            if gain > best.0 {
                best = (gain, Some((k, false)));
            }
        }
        match best.1 {
            None => Descent::AtRest,
            Some((k, false)) => match self.slide(LatticeEdge::of_vertex(column, row, k)) {
                // From there the way may be open that was not from here.
                Descent::AtRest => Descent::GoesOn,
                other => other,
            },
            Some((k, true)) => {
                let mut shares = [0.0; 3];
                shares[CORNER[k]] = 1.0;
                match faces[k].exit(&shares) {
                    None => self.rest_on_face(&faces[k], None, counters),
                    Some((edge, along)) => self.cross(&faces[k], edge, along, counters),
                }
            }
        }
    }

    /// Walks from face to face, entering `face` through its edge `edge` at `along` from the edge's
    /// first corner.
    #[inline(always)]
    fn walk(
        &mut self,
        mut face: Face,
        mut edge: usize,
        mut along: f64,
        counters: &mut Counters,
    ) -> Descent {
        loop {
            if !(face.goal_height <= 0.0) {
                let (edge_of_lattice, at) = face.lattice_edge(edge, along);
                if !face.goal_is_within(edge) {
                    return self.slide(edge_of_lattice);
                }
                self.stand_on_edge(edge_of_lattice, at);
                // From a corner the way may lead over another face.
                let is_corner = matches!(self.proxy.place, Place::Vertex { .. });
                return if is_corner { Descent::GoesOn } else { Descent::Open(face.triangle()) };
            }
            if !(face.foot[edge] > 0.0) {
                return self.slide(face.lattice_edge(edge, along).0);
            }
            let Some((next_edge, next_along)) = face.exit_from_edge(edge, along) else {
                return self.rest_on_face(&face, Some(edge), counters);
            };
            (edge, along) = (next_edge, next_along);
            face = face.across(edge, self.search);
            if counters.steps() >= self.step_budget {
                let (edge, at) = face.lattice_edge(edge, along);
                self.stand_on_edge(edge, at);
                return Descent::OutOfSteps;
            }
            counters.faces += 1;
        }
    }

    /// Goes along an edge that neither face draws away from, to the point nearest to the goal.
    #[inline(always)]
    fn slide(&mut self, edge: LatticeEdge) -> Descent {
        let LatticeEdge { column, row, k } = edge;
        let field = self.search.field;
        let start = field.elevation(column, row);
        let rise = field.elevation(column + EAST[k], row + SOUTH[k]) - start;
        let goal = self.search.target.relative_to(column, row, start);
        let vector = [EAST[k] as f64, SOUTH[k] as f64, rise];
        let along = self.search.weights.product(goal, vector) / self.search.weights.squared(vector);
        if along.min(1.0 - along) < FARTHEST_BESIDE {
            return self.rest_beside_vertex(edge, along, goal);
        }
        self.stand_on_edge(edge, along);
        match self.proxy.place {
            Place::Vertex { .. } => Descent::GoesOn,
            _ => Descent::AtRest,
        }
    }

    /// A rest so near to the end of an edge that rounding makes no difference is on the vertex: there the
    /// other faces and edges have a say, and on steep ground most of all. It is the edge's own closest
    /// point, so that the distance is the same there to the second order.
    #[cold]
    #[inline(never)]
    fn rest_beside_vertex(&mut self, edge: LatticeEdge, along: f64, goal: [f64; 3]) -> Descent {
        let LatticeEdge { k, .. } = edge;
        let from_end = [goal[0] - EAST[k] as f64, goal[1] - SOUTH[k] as f64, goal[2]];
        let along = if along <= self.beside_vertex(goal) {
            0.0
        } else if 1.0 - along <= self.beside_vertex(from_end) {
            1.0
        } else {
            along
        };
        self.stand_on_edge(edge, along);
        match self.proxy.place {
            Place::Vertex { .. } => Descent::GoesOn,
            _ => Descent::AtRest,
        }
    }

    /// The share of an edge that rounding makes of a goal so far from its vertex over the ground.
    fn beside_vertex(&self, goal: [f64; 3]) -> f64 {
        let cells = self.search.weights.aspect * (goal[0].abs() + goal[1].abs());
        (BESIDE_VERTEX * (1.0 + cells)).min(FARTHEST_BESIDE)
    }

    /// Rests at the goal's foot. Where rounding cannot tell it from a place on an edge, the face across
    /// is asked, unless the walk came from there.
    #[inline(always)]
    fn rest_on_face(
        &mut self,
        face: &Face,
        entered: Option<usize>,
        counters: &mut Counters,
    ) -> Descent {
        let scale = 1.0 / face.norm;
        let share_c = share(face.foot[2] * scale);
        let share_b = share(face.foot[1] * scale).min(1.0 - share_c);
        self.proxy.position = face.point(share_b, share_c);
        self.proxy.place = Place::Face(face.triangle());
        let rounding = face.rounding(self.search);
        let is_on = |edge: &usize| face.foot[*edge] <= rounding && entered != Some(*edge);
        match (0..3).find(is_on) {
            None => Descent::AtRest,
            Some(edge) => self.ask_across(face, edge, counters),
        }
    }

    #[cold]
    #[inline(never)]
    fn ask_across(&mut self, face: &Face, edge: usize, counters: &mut Counters) -> Descent {
        let distance = self.search.squared_distance(&self.proxy.position);
        if !self.progress.comes_nearer(distance) || counters.steps() >= self.step_budget {
            return Descent::AtRest;
        }
        let start = if edge == 0 { 1 } else { 0 };
        let along = share(face.foot[start] / face.norm);
        let (edge, along) = face.across(edge, self.search).lattice_edge(edge, along);
        counters.faces += 1;
        self.stand_on_edge(edge, along);
        Descent::GoesOn
    }

    /// Puts the proxy on an edge, or on its vertex where it is that to within rounding: there, the
    /// faces and edges all around have a say.
    pub(super) fn stand_on_edge(&mut self, edge: LatticeEdge, along: f64) {
        let LatticeEdge { column, row, k } = edge;
        if !(along > f64::EPSILON) {
            return self.stand_on_vertex(column, row);
        }
        if along >= 1.0 {
            return self.stand_on_vertex(column + EAST[k], row + SOUTH[k]);
        }
        self.proxy.position = self.point_on_edge(edge, along);
        self.proxy.place = Place::Edge { column, row, k };
    }

    #[cold]
    fn stand_on_vertex(&mut self, column: i64, row: i64) {
        let elevation = self.search.field.elevation(column, row);
        self.proxy.position = GridPoint { column, row, u: 0.0, v: 0.0, elevation };
        self.proxy.place = Place::Vertex { column, row };
    }

    #[inline(always)]
    fn point_on_edge(&self, edge: LatticeEdge, along: f64) -> GridPoint {
        let LatticeEdge { column, row, k } = edge;
        let start = self.search.field.elevation(column, row);
        let end = self.search.field.elevation(column + EAST[k], row + SOUTH[k]);
        let u = if k == 2 { 0.0 } else { along };
        let v = if k == 0 { 0.0 } else { along };
        GridPoint { column, row, u, v, elevation: start + along * (end - start) }
    }

    /// The squared distance saved by going along edge `k` of a vertex to the point nearest to the
    /// goal on its line; none where that is the vertex, to within the share `beside`.
    fn gain_along(&self, column: i64, row: i64, k: usize, goal: [f64; 3], beside: f64) -> f64 {
        let field = self.search.field;
        let rise = field.elevation(column + EAST[k], row + SOUTH[k]) - field.elevation(column, row);
        let vector = [EAST[k] as f64, SOUTH[k] as f64, rise];
        let product = self.search.weights.product(vector, goal);
        let along = product / self.search.weights.squared(vector);
        if along > beside { product * along } else { 0.0 }
    }
}

/// The face of a vertex that the way to `goal` leads over: along an edge, one that exists if either does.
fn face_ahead(faces: &[Face; 6], goal: [f64; 3]) -> usize {
    let k = sector(goal[0], goal[1]);
    if !faces[k].goal_height.is_nan() {
        return k;
    }
    let leads_over = |&k: &usize| {
        let (first, second) = along_edges(k, goal[0], goal[1]);
        first >= 0.0 && second >= 0.0 && !faces[k].goal_height.is_nan()
    };
    (0..6).find(leads_over).unwrap_or(k)
}

impl Face {
    /// Whether a point on the edge is drawn into this face: the goal lies under its plane, and the
    /// foot on its side of the edge.
    #[inline(always)]
    fn draws(&self, edge: usize) -> bool {
        self.goal_height <= 0.0 && self.foot[edge] > 0.0
    }

    /// Whether the goal is nearer to this plane than to the other's.
    fn is_nearer_than(&self, other: &Self) -> bool {
        self.goal_height * self.goal_height * other.norm
            < other.goal_height * other.goal_height * self.norm
    }

    fn squared_plane_distance(&self, up: f64) -> f64 {
        up * (self.goal_height * self.goal_height / self.norm)
    }

    /// Whether the straight way from a corner to the foot begins inside the face.
    fn foot_is_ahead_of(&self, corner: usize) -> bool {
        let (first, second) = OTHERS[corner];
        self.foot[first] >= 0.0 && self.foot[second] >= 0.0
    }

    /// Where the straight way from a point of the face (barycentric coordinates) to the foot leaves
    /// it: through which edge, and how far along it, as counted from the face across. `None` where
    /// the foot lies inside the face; on an edge, the face across has a say too.
    #[inline(always)]
    fn exit(&self, shares: &[f64; 3]) -> Option<(usize, f64)> {
        let mut first: Option<(usize, f64)> = None;
        for (edge, (share, foot)) in shares.iter().zip(self.foot).enumerate() {
            if !(foot > 0.0) {
                let length = share * self.norm - foot;
                // A way along the edge leaves at its end.
                let time = if length > 0.0 { share * self.norm / length } else { 1.0 };
                if first.is_none_or(|(_, earliest)| time < earliest) {
                    first = Some((edge, time));
                }
            }
        }
        let (edge, time) = first?;
        // From the face across, the edge begins at what is its second corner here.
        let start = if edge == 0 { 1 } else { 0 };
        let along = shares[start] + time * (self.foot[start] / self.norm - shares[start]);
        Some((edge, share(along)))
    }

    /// The same for a way that begins on an edge and leads into the face.
    #[inline(always)]
    fn exit_from_edge(&self, edge: usize, along: f64) -> Option<(usize, f64)> {
        let (first, second) = ENDS[edge];
        let back = 1.0 - along;
        let (at_first, at_second) = (self.foot[first], self.foot[second]);
        if at_first > 0.0 && at_second > 0.0 {
            return None;
        }
        let through_first =
            at_second > 0.0 || (at_first <= 0.0 && along * at_first < back * at_second);
        let exit = if through_first { first } else { second };
        let crossed = if through_first { at_first } else { at_second };
        let crossed_start = if through_first { back } else { along };
        let corner = ENDS[exit].0;
        let other_start = if through_first { along } else { back };
        let start = if corner == edge { 0.0 } else { other_start };
        let foot = self.foot[corner];
        Some((exit, exit_share(crossed, crossed_start, foot, start, self.norm)))
    }
}

/// The corners that the edge opposite a corner leads from and to.
const ENDS: [(usize, usize); 3] = [(1, 2), (0, 2), (0, 1)];

/// The share of a corner at the point where a way leaves a face: `crossed` and `crossed_start` are
/// foot and start within the edge that is crossed, `foot` and `start` those of the corner.
#[inline(always)]
fn exit_share(crossed: f64, crossed_start: f64, foot: f64, start: f64, norm: f64) -> f64 {
    let length = crossed_start * norm - crossed;
    // A way along the edge leaves at its end.
    share(if length > 0.0 {
        (crossed_start * foot - crossed * start) / length
    } else {
        foot / norm
    })
}

impl LatticeEdge {
    /// Edge `k` (0 to 5) of a vertex, by the name that both its ends have for it.
    #[inline(always)]
    fn of_vertex(column: i64, row: i64, k: usize) -> Self {
        if k < 3 {
            Self { column, row, k }
        } else {
            Self { column: column + EAST[k], row: row + SOUTH[k], k: k - 3 }
        }
    }

    /// How far along the edge a point on it lies.
    #[inline(always)]
    fn along(&self, point: &GridPoint) -> f64 {
        let [u, v, _] = point.relative_to(self.column, self.row, 0.0);
        let along = if self.k == 2 { v } else { u };
        share(along)
    }
}
