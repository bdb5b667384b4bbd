//! A short list of vertices, kept within one update, or over those that it takes to finish one.

/// How many vertices the list holds. On Mars at twenty times its relief an update met at most a
/// handful (paper 4.4: far-edge crossings in 3.5% of updates); the list exists to end the rest.
const CAPACITY: usize = 64;

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

    /// Adds a vertex; false where it was there already, or where the list is full and a circle has
    /// to be assumed.
    pub(super) fn insert(&mut self, column: i64, row: i64) -> bool {
        let is_new = !self.is_full() && !self.vertices.contains(&(column, row));
        if is_new {
            self.vertices.push((column, row));
        }
        is_new
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_vertex_is_new_once_and_a_full_list_takes_none() {
        let mut visited = VisitedVertices::new();
        assert!(visited.insert(1, 2));
        assert!(!visited.insert(1, 2));
        for column in 1..CAPACITY as i64 {
            assert!(visited.insert(column, 9));
        }
        assert!(!visited.insert(0, 0));
        visited.clear();
        assert!(visited.insert(0, 0));
    }
}
