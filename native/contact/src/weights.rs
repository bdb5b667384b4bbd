//! The metric of the workspace, as contact models use it.

use surface::Metric;

/// The metric of the workspace as weights of a scalar product over columns, rows and metres.
///
/// All are relative to the width of a cell: which point is nearest does not depend on the unit of
/// length, so nothing overflows or vanishes however small or large the workspace is.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Weights {
    pub(crate) row: f64,
    pub(crate) up: f64,
    /// `up` over `row`.
    pub(crate) up_over_row: f64,
    /// The longer side of a cell in its shorter ones: at least 1.
    pub(crate) aspect: f64,
}

impl Weights {
    pub(crate) fn new(metric: &Metric) -> Self {
        let (row, up) = (metric.row / metric.column, metric.up / metric.column);
        let up_over_row = metric.up / metric.row;
        let aspect = row.max(metric.column / metric.row);
        Self { row: row * row, up: up * up, up_over_row: up_over_row * up_over_row, aspect }
    }

    #[inline(always)]
    pub(crate) fn product(&self, a: [f64; 3], b: [f64; 3]) -> f64 {
        a[0] * b[0] + self.row * (a[1] * b[1]) + self.up * (a[2] * b[2])
    }

    #[inline(always)]
    pub(crate) fn squared(&self, a: [f64; 3]) -> f64 {
        self.product(a, a)
    }

    /// The scalar product with every term positive: its rounding error is a few units in the last
    /// place of this.
    pub(crate) fn magnitude(&self, a: [f64; 3], b: [f64; 3]) -> f64 {
        self.product(a.map(f64::abs), b.map(f64::abs))
    }
}
