//! The triangulation: which vertices, edges and faces meet where.
//!
//! Every cell is split by the diagonal from its north-west to its south-east corner (paper 3.5: one
//! fixed diagonal). So every vertex has six edges, numbered clockwise as the map is seen, from the
//! east: E, SE, S, W, NW, N; face `k` lies between the edges `k` and `k + 1`.

/// One of the two triangles of a cell.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Half {
    /// Corners north-west, north-east, south-east.
    NorthEast,
    /// Corners north-west, south-east, south-west.
    SouthWest,
}

impl Half {
    /// The cell's other triangle.
    pub fn other(self) -> Self {
        match self {
            Self::NorthEast => Self::SouthWest,
            Self::SouthWest => Self::NorthEast,
        }
    }
}

/// A triangle, by its cell's north-west sample and its half.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Triangle {
    /// Column of the cell's north-west sample.
    pub column: i64,
    /// Row of the cell's north-west sample.
    pub row: i64,
    /// Which half of the cell.
    pub half: Half,
}

impl Triangle {
    /// Column and row of the three corners, north-west first, then clockwise.
    pub fn corners(&self) -> [(i64, i64); 3] {
        let (column, row) = (self.column, self.row);
        match self.half {
            Half::NorthEast => [(column, row), (column + 1, row), (column + 1, row + 1)],
            Half::SouthWest => [(column, row), (column + 1, row + 1), (column, row + 1)],
        }
    }
}

/// Columns eastward that edge `k` leads.
pub const EAST: [i64; 6] = [1, 1, 0, -1, -1, 0];

/// Rows southward that edge `k` leads.
pub const SOUTH: [i64; 6] = [0, 1, 1, 0, -1, -1];

/// The edge clockwise of `k`.
#[inline(always)]
pub fn clockwise(k: usize) -> usize {
    if k == 5 { 0 } else { k + 1 }
}

/// The edge counterclockwise of `k`.
#[inline(always)]
pub fn counterclockwise(k: usize) -> usize {
    if k == 0 { 5 } else { k - 1 }
}

/// Face `k` of the vertex (`column`, `row`).
pub fn face(column: i64, row: i64, k: usize) -> Triangle {
    let (column, row, half) = match k {
        0 => (column, row, Half::NorthEast),
        1 => (column, row, Half::SouthWest),
        2 => (column - 1, row, Half::NorthEast),
        3 => (column - 1, row - 1, Half::SouthWest),
        4 => (column - 1, row - 1, Half::NorthEast),
        _ => (column, row - 1, Half::SouthWest),
    };
    Triangle { column, row, half }
}

/// The face of a vertex over which the direction (`u` columns east, `v` rows south) leads. A
/// direction along an edge belongs to both of its faces; either may be given.
#[inline(always)]
pub fn sector(u: f64, v: f64) -> usize {
    if u >= 0.0 {
        if v < 0.0 {
            5
        } else if u >= v {
            0
        } else {
            1
        }
    } else if v > 0.0 {
        2
    } else if u <= v {
        3
    } else {
        4
    }
}

/// The direction (`u`, `v`) as multiples of the edges `k` and `k + 1`: the plane over face `k`
/// rises by these multiples of the edges' rises, and a point lies in face `k` where both are at
/// least 0 and their sum at most 1.
#[inline(always)]
pub fn along_edges(k: usize, u: f64, v: f64) -> (f64, f64) {
    match k {
        0 => (u - v, v),
        1 => (u, v - u),
        2 => (v, -u),
        3 => (v - u, -v),
        4 => (-u, u - v),
        _ => (-v, u),
    }
}

/// Rise of the plane over face `k` for a column eastward and for a row southward, from the rises of
/// the edges `k` and `k + 1`.
#[inline(always)]
pub fn gradient(k: usize, rise: f64, next_rise: f64) -> (f64, f64) {
    match k {
        0 => (rise, next_rise - rise),
        1 => (rise - next_rise, next_rise),
        2 => (-next_rise, rise),
        3 => (-rise, rise - next_rise),
        4 => (next_rise - rise, -next_rise),
        _ => (next_rise, -rise),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn faces_have_the_vertex_and_both_edges_as_corners() {
        for k in 0..6 {
            let next = clockwise(k);
            let corners = face(10, 20, k).corners();
            for (east, south) in [(0, 0), (EAST[k], SOUTH[k]), (EAST[next], SOUTH[next])] {
                assert!(corners.contains(&(10 + east, 20 + south)), "face {k}");
            }
            assert_eq!(counterclockwise(next), k);
        }
    }

    #[test]
    fn every_direction_lies_between_the_edges_of_its_sector() {
        for step in 0..3600 {
            let angle = f64::from(step) * std::f64::consts::TAU / 3600.0;
            let (u, v) = (angle.cos(), angle.sin());
            let (first, second) = along_edges(sector(u, v), u, v);
            assert!(first >= 0.0 && second >= 0.0, "angle {angle}");
        }
    }

    #[test]
    fn edge_multiples_and_gradients_agree() {
        for k in 0..6 {
            let next = clockwise(k);
            let (rise, next_rise) = (3.0, -7.0);
            let (east, south) = gradient(k, rise, next_rise);
            assert_eq!(east * EAST[k] as f64 + south * SOUTH[k] as f64, rise);
            assert_eq!(east * EAST[next] as f64 + south * SOUTH[next] as f64, next_rise);
            let (first, second) = along_edges(k, 0.3, 0.8);
            let planned = first * rise + second * next_rise;
            assert!((planned - (east * 0.3 + south * 0.8)).abs() < 1e-12);
        }
    }
}
