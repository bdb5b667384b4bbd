//! Sections: the surface cut by a vertical plane.
//!
//! The cut is a chain of straight pieces. Where its joints lie over the ground does not depend on
//! any height: they are the places where one straight line crosses the lattice. So no height has to
//! wait for another, which costs a fraction of going from triangle to triangle.
//!
//! The lattice looks the same turned by half a turn, and with rows and columns exchanged. So a
//! section has a frame of its own, in which it leads eastward, and at least as far east as north or
//! south.

use crate::heightfield::Heightfield;
use crate::point::GridPoint;
use crate::sample::Sample;

/// The section of a surface over a straight line on the ground, from one point to another.
pub struct Section<'a, S> {
    field: &'a Heightfield<'a, S>,
    /// The grid's sample at the frame's origin.
    column: i64,
    row: i64,
    /// 1, or -1 where the frame is turned by half a turn.
    turn: i64,
    /// Rows and columns are exchanged.
    is_exchanged: bool,
    /// The samples all around lie side by side in memory: no border and no seam is near.
    is_inside: bool,
    /// Bytes from the first sample to the frame's origin, and on to the next column and row.
    origin: i64,
    column_stride: i64,
    row_stride: i64,
    /// Bytes from the north-west sample of a cell to the first and the last sample that its column
    /// may need.
    reach: (i64, i64),
    /// Where it begins: columns and rows of the frame.
    start: [f64; 2],
    /// Rows for a column, from -1 to 1.
    slope: f64,
    /// Columns for a row along the line, and away from the diagonals.
    per_row: f64,
    per_diagonal: f64,
    /// Columns from start to end.
    length: f64,
}

/// A joint by its column of cells and its number there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Joint {
    column: i64,
    /// 0 on the western line of the cells, then on the way east.
    number: usize,
}

/// A place on an edge of the lattice.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EdgePlace {
    /// Of the edge's vertex.
    pub column: i64,
    /// Of the edge's vertex.
    pub row: i64,
    /// The edge's number there, from 0 to 2 (see [`crate::lattice`]).
    pub k: usize,
    /// The share of the edge from the vertex to the place.
    pub along: f64,
}

/// How far a column was followed.
#[derive(Clone, Copy)]
struct Passed<State> {
    state: State,
    joints: usize,
    /// Columns from the start to the last joint passed.
    at: f64,
    goes_on: bool,
}

impl<State> Passed<State> {
    /// The last joint passed, of this column.
    #[inline(always)]
    fn last(&self, column: i64) -> Option<Joint> {
        (self.joints > 0).then(|| Joint { column, number: self.joints - 1 })
    }
}

/// Where a line crosses a column of cells.
struct Crossing {
    /// The cell's row.
    row: i64,
    /// Rows from the cell's north-west sample to the line, on the column's western line: 0 to 1. On
    /// a sample it may be either cell's.
    share: f64,
}

impl<'a, S: Sample> Section<'a, S> {
    /// The section from `from`, a point of the surface, toward `to`; both on the map and at different places.
    #[inline(always)]
    pub fn new(field: &'a Heightfield<'a, S>, from: &GridPoint, to: &GridPoint) -> Self {
        let [columns, rows, _] = to.relative_to(from.column, from.row, 0.0);
        let (east, south) = (columns - from.u, rows - from.v);
        let is_exchanged = south.abs() > east.abs();
        let (length, aside) = if is_exchanged { (south, east) } else { (east, south) };
        let turn = if length > 0.0 { 1 } else { -1 };
        let sign = turn as f64;
        let start = if is_exchanged { [from.v, from.u] } else { [from.u, from.v] };
        let (eastward, southward) = (S::BYTES as i64, field.row_stride());
        let (along, across) =
            if is_exchanged { (southward, eastward) } else { (eastward, southward) };
        let (column_stride, row_stride) = (turn * along, turn * across);
        let slope = sign * aside / length.abs();
        // A cell's corners, and across the diagonals the sample to the north.
        let corners = [column_stride, row_stride, column_stride + row_stride, -row_stride];
        let reach = corners
            .iter()
            .fold((0, 0), |(low, high), offset| (low.min(*offset), high.max(*offset)));
        Self {
            field,
            column: from.column,
            row: from.row,
            turn,
            is_exchanged,
            is_inside: is_inside(field, from, to),
            origin: from.row * southward + field.period_column(from.column) * eastward,
            column_stride,
            row_stride,
            reach,
            start: start.map(|part| sign * part),
            slope,
            per_row: 1.0 / slope.abs(),
            per_diagonal: 1.0 / (1.0 - slope),
            length: length.abs(),
        }
    }

    /// Whether it leads along the diagonals of the cells: every column then has 2 joints.
    #[inline(always)]
    fn leads_along_diagonals(&self) -> bool {
        self.slope >= 0.0
    }

    /// Columns of cells from its start to its end, of the longer axis.
    pub fn length(&self) -> f64 {
        self.length
    }

    /// Follows its joints, through `most_columns` (at least 1) columns of cells at the most, as long as `pass`
    /// gives a new state for the next one: from the state, columns from the start, and metres (NaN
    /// where there is no surface). Gives the last joint passed with its state, and how many joints
    /// were looked at.
    #[inline(always)]
    pub fn follow<State: Copy>(
        &self,
        most_columns: u32,
        state: State,
        pass: impl Fn(State, f64, f64) -> Option<State>,
    ) -> (Option<(Joint, State)>, u32) {
        let first = floor(self.start[0]).0;
        let last = floor(self.start[0] + self.length).0;
        let most = first + i64::from(most_columns);
        // In the first column some joints lie behind the start, in the last some beyond the end.
        let pass_at_ends = |state: State, columns: f64, height: f64| {
            if columns <= 0.0 {
                Some(state)
            } else if columns < self.length {
                pass(state, columns, height)
            } else {
                None
            }
        };
        let mut column = first;
        let mut before = None;
        let mut passed = self.through_column(first, state, pass_at_ends);
        let mut seen = passed.joints;
        if passed.at <= 0.0 {
            // None of them is ahead of the start.
            passed.joints = 0;
        }
        while passed.goes_on && column < last && column + 1 < most {
            before = passed.last(column).or(before);
            column += 1;
            passed = if column < last {
                self.through_column(column, passed.state, &pass)
            } else {
                self.through_column(column, passed.state, pass_at_ends)
            };
            seen += passed.joints;
        }
        let reached = passed.last(column).or(before).map(|joint| (joint, passed.state));
        (reached, seen as u32 + u32::from(!passed.goes_on))
    }

    /// Follows the joints of a column.
    #[inline(always)]
    fn through_column<State: Copy>(
        &self,
        column: i64,
        state: State,
        pass: impl Fn(State, f64, f64) -> Option<State>,
    ) -> Passed<State> {
        let Crossing { row, share } = self.crossing(column);
        let [north, south, south_east] = self.heights(column, row, [(0, 0), (0, 1), (1, 1)]);
        let columns = column as f64 - self.start[0];
        let Some(state) = pass(state, columns, north + share * (south - north)) else {
            return Passed { state, joints: 0, at: 0.0, goes_on: false };
        };
        if self.leads_along_diagonals() {
            let (is_diagonal, along) = self.inner_joint(share);
            let corner = if is_diagonal { north } else { south };
            let height = corner + along * (south_east - corner);
            return match pass(state, columns + along, height) {
                Some(state) => Passed { state, joints: 2, at: columns + along, goes_on: true },
                None => Passed { state, joints: 1, at: columns, goes_on: false },
            };
        }
        let [diagonal, line, far_diagonal] = self.inner_joints(share);
        let height = north + diagonal * (south_east - north);
        let Some(state) = pass(state, columns + diagonal, height) else {
            return Passed { state, joints: 1, at: columns, goes_on: false };
        };
        let at = columns + diagonal;
        if !self.leaves_northward(share) {
            return Passed { state, joints: 2, at, goes_on: true };
        }
        let [north_east, far_north] = self.heights(column, row, [(1, 0), (0, -1)]);
        let height = north + line * (north_east - north);
        let Some(state) = pass(state, columns + line, height) else {
            return Passed { state, joints: 2, at, goes_on: false };
        };
        let height = far_north + far_diagonal * (north_east - far_north);
        match pass(state, columns + far_diagonal, height) {
            Some(state) => Passed { state, joints: 4, at: columns + far_diagonal, goes_on: true },
            None => Passed { state, joints: 3, at: columns + line, goes_on: false },
        }
    }

    /// The edge that a joint lies on.
    pub fn place(&self, joint: Joint) -> EdgePlace {
        let Joint { column, number } = joint;
        let Crossing { row, share } = self.crossing(column);
        // Column and row of the edge's vertex, its number, and the place on it, in the frame.
        let (column, row, k, along) = if number == 0 {
            (column, row, 2, share)
        } else if self.leads_along_diagonals() {
            let (is_diagonal, along) = self.inner_joint(share);
            if is_diagonal { (column, row, 1, along) } else { (column, row + 1, 0, along) }
        } else {
            let [diagonal, line, far_diagonal] = self.inner_joints(share);
            match (number, self.leaves_northward(share)) {
                (2, true) => (column, row, 0, line),
                (3, true) => (column, row - 1, 1, far_diagonal),
                _ => (column, row, 1, diagonal),
            }
        };
        self.in_grid(column, row, k, along.clamp(0.0, 1.0))
    }

    /// Heights of samples by columns and rows from one, all in the frame.
    #[inline(always)]
    fn heights<const N: usize>(&self, column: i64, row: i64, steps: [(i64, i64); N]) -> [f64; N] {
        if !self.is_inside {
            return self.heights_anywhere(column, row, steps);
        }
        let offset = self.origin + column * self.column_stride + row * self.row_stride;
        let mut offsets = [0; N];
        for (offset, (columns, rows)) in offsets.iter_mut().zip(steps) {
            *offset = columns * self.column_stride + rows * self.row_stride;
        }
        // SAFETY: the steps are those that the reach was made of.
        unsafe { self.field.elevations_at(offset, offsets, self.reach) }
    }

    #[cold]
    #[inline(never)]
    fn heights_anywhere<const N: usize>(
        &self,
        column: i64,
        row: i64,
        steps: [(i64, i64); N],
    ) -> [f64; N] {
        steps.map(|(columns, rows)| {
            let (column, row) = (self.turn * (column + columns), self.turn * (row + rows));
            let (column, row) = if self.is_exchanged { (row, column) } else { (column, row) };
            self.field.elevation(self.column + column, self.row + row)
        })
    }

    #[inline(always)]
    fn crossing(&self, column: i64) -> Crossing {
        let line = self.start[1] + (column as f64 - self.start[0]) * self.slope;
        let (row, whole) = floor(line);
        Crossing { row, share: line - whole }
    }

    /// Along the diagonals, the one joint inside a column: whether it lies on the cell's diagonal,
    /// or else on its southern line, and where.
    #[inline(always)]
    fn inner_joint(&self, share: f64) -> (bool, f64) {
        let is_diagonal = share + self.slope <= 1.0;
        let along =
            if is_diagonal { share * self.per_diagonal } else { (1.0 - share) * self.per_row };
        // Where the line runs along the diagonal itself this is NaN, and the joint goes to its end.
        (is_diagonal, if along < 1.0 { along } else { 1.0 })
    }

    /// Across the diagonals, the joints inside a column: on the cell's diagonal, on its northern line
    /// and on the diagonal of the cell beyond.
    #[inline(always)]
    fn inner_joints(&self, share: f64) -> [f64; 3] {
        [share * self.per_diagonal, share * self.per_row, (1.0 + share) * self.per_diagonal]
    }

    /// Across the diagonals, whether the line leaves the cell to the north.
    #[inline(always)]
    fn leaves_northward(&self, share: f64) -> bool {
        share < -self.slope
    }

    /// A place on an edge of the frame as one of the grid.
    fn in_grid(&self, column: i64, row: i64, k: usize, along: f64) -> EdgePlace {
        // Half a turn exchanges the ends of the edge.
        let (columns, rows) = ((k < 2) as i64, (k > 0) as i64);
        let (column, row, along) = if self.turn > 0 {
            (column, row, along)
        } else {
            (-(column + columns), -(row + rows), 1.0 - along)
        };
        let (column, row, k) =
            if self.is_exchanged { (row, column, 2 - k) } else { (column, row, k) };
        EdgePlace { column: self.column + column, row: self.row + row, k, along }
    }
}

/// Whether the samples around two points and between them lie side by side in memory.
fn is_inside<S: Sample>(field: &Heightfield<S>, from: &GridPoint, to: &GridPoint) -> bool {
    // A section looks at two rows or columns beyond its ends.
    const MARGIN: i64 = 3;
    let stored = field.period_column(from.column);
    let (columns, rows) = (stored + to.column - from.column, to.row);
    let is_within = |a: i64, b: i64, lines: i64| a.min(b) >= MARGIN && a.max(b) + MARGIN < lines;
    is_within(stored, columns, field.columns()) && is_within(from.row, rows, field.rows())
}

/// The whole number below, as an integer and as a double; for a whole number itself either that
/// or the one before. Numbers must be smaller than 2^50.
///
/// A double this large has no fraction left, so adding it rounds; a conversion to an integer that
/// takes care of every double would cost several times as much.
#[inline(always)]
fn floor(number: f64) -> (i64, f64) {
    const MAGIC: f64 = 6_755_399_441_055_744.0; // 1.5 x 2^52
    let shifted = (number - 0.5) + MAGIC;
    (shifted.to_bits() as i64 - MAGIC.to_bits() as i64, shifted - MAGIC)
}
