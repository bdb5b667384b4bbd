//! The triangles that a straight line over the ground goes through.

use surface::GridPoint;

/// For every triangle that the line from one point to another enters: its corner that the triangle
/// before does not have, as column and row, in order.
pub fn corners_entered(from: &GridPoint, to: &GridPoint) -> Vec<(i64, i64)> {
    let line = Line::new(from, to);
    let mut entered: Vec<(f64, (i64, i64))> = Vec::new();
    for family in [Family::Columns, Family::Rows, Family::Diagonals] {
        let (start, end) = (family.position(line.at(0.0)), family.position(line.at(1.0)));
        let forward = end > start;
        // Lines strictly between start and end: a line that only ends on a border enters nothing.
        let (low, high) = (start.min(end).floor() as i64 + 1, start.max(end).ceil() as i64 - 1);
        for border in low..=high {
            let t = (border as f64 - start) / (end - start);
            entered.push((t, family.corner_beyond(border, line.at(t), forward)));
        }
    }
    entered.sort_by(|a, b| a.0.total_cmp(&b.0));
    let absolute = |(_, (column, row))| (from.column + column, from.row + row);
    entered.into_iter().map(absolute).collect()
}

/// A line in columns and rows relative to the sample that it begins at.
struct Line {
    start: [f64; 2],
    step: [f64; 2],
}

impl Line {
    fn new(from: &GridPoint, to: &GridPoint) -> Self {
        let [column, row, _] = to.relative_to(from.column, from.row, 0.0);
        Self { start: [from.u, from.v], step: [column - from.u, row - from.v] }
    }

    fn at(&self, t: f64) -> [f64; 2] {
        [0, 1].map(|axis| self.start[axis] + t * self.step[axis])
    }
}

/// The three kinds of borders between triangles.
#[derive(Clone, Copy)]
enum Family {
    Columns,
    Rows,
    Diagonals,
}

impl Family {
    /// Whole numbers are on borders.
    fn position(self, [column, row]: [f64; 2]) -> f64 {
        match self {
            Self::Columns => column,
            Self::Rows => row,
            Self::Diagonals => column - row,
        }
    }

    /// The corner opposite the border in the triangle behind it, where a line crosses at `place`
    /// to larger positions (`forward`) or to smaller ones.
    fn corner_beyond(self, border: i64, place: [f64; 2], forward: bool) -> (i64, i64) {
        let [column, row] = place.map(|number| number.floor() as i64);
        match (self, forward) {
            (Self::Columns, true) => (border + 1, row + 1),
            (Self::Columns, false) => (border - 1, row),
            (Self::Rows, true) => (column + 1, border + 1),
            (Self::Rows, false) => (column, border - 1),
            (Self::Diagonals, true) => (column + 1, row),
            (Self::Diagonals, false) => (column, row + 1),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Random;
    use surface::{Half, Triangle};

    fn triangle_at(line: &Line, from: &GridPoint, t: f64) -> Triangle {
        let [column, row] = line.at(t);
        let (u, v) = (column - column.floor(), row - row.floor());
        let half = if u >= v { Half::NorthEast } else { Half::SouthWest };
        let column = from.column + column.floor() as i64;
        Triangle { column, row: from.row + row.floor() as i64, half }
    }

    /// By looking at very many places along the line; `None` where it passes too near a corner.
    fn by_brute_force(from: &GridPoint, to: &GridPoint) -> Option<Vec<(i64, i64)>> {
        let line = Line::new(from, to);
        let mut before = triangle_at(&line, from, 0.0);
        let mut entered = Vec::new();
        for part in 1..=40_000 {
            let triangle = triangle_at(&line, from, f64::from(part) / 40_000.0);
            if triangle == before {
                continue;
            }
            let known = before.corners();
            let new: Vec<_> =
                triangle.corners().into_iter().filter(|corner| !known.contains(corner)).collect();
            let [corner] = new[..] else { return None };
            entered.push(corner);
            before = triangle;
        }
        Some(entered)
    }

    #[test]
    fn the_corners_are_those_that_a_very_fine_walk_meets() {
        let mut random = Random::new(4);
        let mut checked = 0;
        for _ in 0..300 {
            let mut place = |reach: f64| random.between(-reach, reach);
            let from = GridPoint::new(100.0 + place(3.0), -7.0 + place(3.0), 0.0);
            let to = GridPoint::new(from.columns() + place(9.0), from.rows() + place(9.0), 0.0);
            if let Some(expected) = by_brute_force(&from, &to) {
                assert_eq!(corners_entered(&from, &to), expected, "{from:?} {to:?}");
                checked += 1;
            }
        }
        assert!(checked > 250, "{checked}");
    }

    #[test]
    fn a_line_inside_a_triangle_or_along_its_border_enters_nothing() {
        let point = GridPoint::new;
        assert!(corners_entered(&point(0.5, 0.2, 0.0), &point(0.6, 0.3, 0.0)).is_empty());
        assert!(corners_entered(&point(0.2, 0.2, 0.0), &point(0.8, 0.8, 0.0)).is_empty());
        assert!(corners_entered(&point(0.2, 0.1, 0.0), &point(0.2, 0.1, 0.0)).is_empty());
    }
}
