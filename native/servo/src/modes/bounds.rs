//! How far the window can be pushed: to the map's edges.

use surface::GridPoint;

use crate::Frame;

/// Columns and rows between which the window's middle stays.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Bounds {
    /// `None` on a map that goes round.
    columns: Option<[f64; 2]>,
    rows: [f64; 2],
}

impl Bounds {
    /// The map, or as far as the window lies beside it already.
    pub(crate) fn around(frame: &Frame) -> Bounds {
        let (layout, origin) = (frame.layout(), frame.origin());
        let or_as_it_is = |samples: u32, at: f64| [0.0f64.min(at), f64::from(samples - 1).max(at)];
        Bounds {
            columns: (!layout.wraps()).then(|| or_as_it_is(layout.columns(), origin.columns())),
            rows: or_as_it_is(layout.rows(), origin.rows()),
        }
    }

    /// The frame pushed back to the bounds, the way over the ground being the shortest; `None` where
    /// it is within them.
    pub(crate) fn push_back(&self, frame: &Frame) -> Option<Frame> {
        let origin = frame.origin();
        let (column, row) = (origin.columns(), origin.rows());
        let columns = self.columns.map_or(column, |[west, east]| column.clamp(west, east));
        let rows = row.clamp(self.rows[0], self.rows[1]);
        if columns == column && rows == row {
            return None;
        }
        frame.at(&GridPoint::new(columns, rows, origin.elevation))
    }
}
