//! The metric in which distances over a grid are measured.

/// Workspace metres for a step in each direction of the grid.
///
/// Contact minimises distances as the hand feels them (paper 4.2, 4.4): zoom changes all three
/// lengths, vertical exaggeration the last, and cells need not be square.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Metric {
    /// Workspace metres from one column to the next.
    pub column: f64,
    /// Workspace metres from one row to the next.
    pub row: f64,
    /// Workspace metres for a metre of elevation, exaggeration included.
    pub up: f64,
}

impl Metric {
    /// Whether all three lengths are positive and finite.
    pub fn is_valid(&self) -> bool {
        [self.column, self.row, self.up].iter().all(|length| length.is_finite() && *length > 0.0)
    }
}
