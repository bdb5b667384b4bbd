//! A short list of vertices, kept within one update, or over those that it takes to finish one.

/// How many vertices the list holds. On Mars at twenty times its relief an update met at most a
/// handful (paper 4.4: far-edge crossings in 3.5% of updates); the list exists to end the rest.
const CAPACITY: usize = 64;

/// What a list knew of a vertex.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Visit {
    /// Nothing.
    First,
    /// It was there before: a circle.
    Again,
    /// Nothing, and there is no room for it: a long way.
    NoRoom,
}

/// Vertices met so far; memory is allocated once.
pub(super) struct VisitedVertices {
    vertices: Vec<(i64, i64)>,
}

impl VisitedVertices {
    pub(super) fn new() -> Self {
        Self { vertices: Vec::with_capacity(CAPACITY) }
    }

    pub(super) fn clear(&mut self) {
        self.vertices.clear();
    }

    pub(super) fn is_full(&self) -> bool {
        self.vertices.len() >= CAPACITY
    }

    /// Adds a vertex, where it was not there and there is room.
    pub(super) fn visit(&mut self, column: i64, row: i64) -> Visit {
        if self.vertices.contains(&(column, row)) {
            return Visit::Again;
        }
        if self.is_full() {
            return Visit::NoRoom;
        }
        self.vertices.push((column, row));
        Visit::First
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_vertex_is_new_once_and_a_full_list_tells_a_circle_from_a_long_way() {
        let mut visited = VisitedVertices::new();
        assert_eq!(visited.visit(1, 2), Visit::First);
        assert_eq!(visited.visit(1, 2), Visit::Again);
        for column in 1..CAPACITY as i64 {
            assert_eq!(visited.visit(column, 9), Visit::First);
        }
        assert_eq!(visited.visit(0, 0), Visit::NoRoom);
        assert_eq!(visited.visit(1, 2), Visit::Again);
        visited.clear();
        assert_eq!(visited.visit(0, 0), Visit::First);
    }
}
