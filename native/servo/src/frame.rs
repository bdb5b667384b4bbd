//! From the hand to the grid and back, through the window.

use devices::{ParameterError, check};
use surface::{GridLayout, GridPoint, Metric};

use crate::Window;

/// A window on a grid, for a workspace of one width: what turns hands into goals.
///
/// The grid point under the workspace's origin is kept as a whole cell and a fraction, and the hand
/// is added to the fraction: a goal is as fine as the hand's own numbers, however far from column 0
/// the window lies.
#[derive(Clone, Copy, Debug)]
pub struct Frame {
    window: Window,
    layout: GridLayout,
    metric: Metric,
    origin: GridPoint,
}

impl Frame {
    /// Lays `window` over a grid so that its width spans `workspace_width` metres of workspace.
    ///
    /// Fails where the sizes of the three are so far apart that no double holds their ratio.
    pub fn new(
        window: Window,
        workspace_width: f64,
        layout: &GridLayout,
    ) -> Result<Frame, ParameterError> {
        let scale = workspace_width / window.width();
        let metric = Metric {
            column: layout.cell_width() * scale,
            row: layout.cell_height() * scale,
            up: scale * window.exaggeration(),
        };
        check::positive("workspace metres per column", metric.column)?;
        check::positive("workspace metres per row", metric.row)?;
        check::positive("workspace metres per metre of height", metric.up)?;

        let origin = layout.grid_point([window.east(), window.north(), window.up()]);
        check::finite("column under the window", origin.columns())?;
        check::finite("row under the window", origin.rows())?;
        Ok(Frame { window, layout: *layout, metric, origin })
    }

    /// The window that this frame was made from.
    pub fn window(&self) -> Window {
        self.window
    }

    /// Workspace metres per column, per row, and per metre of elevation.
    pub fn metric(&self) -> &Metric {
        &self.metric
    }

    /// The goal: where on the grid the hand is (workspace metres).
    pub fn goal(&self, hand: [f64; 3]) -> GridPoint {
        GridPoint::from_sample(
            self.origin.column,
            self.origin.row,
            self.origin.u + hand[0] / self.metric.column,
            // Rows count southward, y points north.
            self.origin.v - hand[1] / self.metric.row,
            self.origin.elevation + hand[2] / self.metric.up,
        )
    }

    /// The way from one grid point to another in the workspace, metres.
    pub fn displacement(&self, from: &GridPoint, to: &GridPoint) -> [f64; 3] {
        let [columns, rows] = ground_way(from, to);
        [
            columns * self.metric.column,
            // "0.0 -" instead of a sign: no way north is 0, not -0.
            0.0 - rows * self.metric.row,
            (to.elevation - from.elevation) * self.metric.up,
        ]
    }

    /// A grid point in the terrain frame: metres east, north and up.
    pub fn terrain(&self, point: &GridPoint) -> [f64; 3] {
        self.layout.terrain_place(point)
    }
}

/// Cells over the ground from one grid point to another, in a straight line.
pub(crate) fn ground_cells(from: &GridPoint, to: &GridPoint) -> f64 {
    let [columns, rows] = ground_way(from, to);
    columns.hypot(rows)
}

/// Columns and rows from one grid point to another. Fractions are subtracted apart from cells, so
/// that two near points far from column 0 lose nothing.
fn ground_way(from: &GridPoint, to: &GridPoint) -> [f64; 2] {
    [
        (to.column - from.column) as f64 + (to.u - from.u),
        (to.row - from.row) as f64 + (to.v - from.v),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use surface::{ByteOrder, SampleType};

    /// A global grid at 128 samples a degree, in metres at the equator of Mars.
    fn layout() -> GridLayout {
        GridLayout::packed(23040, 46080, 463.1, 463.1, SampleType::F64, ByteOrder::Little).unwrap()
    }

    fn frame(east: f64, north: f64, up: f64, width: f64, exaggeration: f64) -> Frame {
        let window = Window::new(east, north, up, width, exaggeration).unwrap();
        Frame::new(window, 0.16, &layout()).unwrap()
    }

    #[test]
    fn x_is_east_y_is_north_z_is_up() {
        let frame = frame(4631.0, -4631.0, 100.0, 1600.0, 2.0);
        assert_eq!(frame.terrain(&frame.goal([0.0; 3])), [4631.0, -4631.0, 100.0]);
        let [east, north, up] = frame.terrain(&frame.goal([0.01, 0.02, 0.002]));
        assert!((east - 4731.0).abs() < 1e-9);
        assert!((north + 4431.0).abs() < 1e-9);
        assert!((up - 110.0).abs() < 1e-9, "2 mm are 20 m, exaggerated twice 10 m, not {up}");
    }

    #[test]
    fn the_metric_holds_scale_and_exaggeration() {
        let metric = *frame(0.0, 0.0, 0.0, 1600.0, 5.0).metric();
        assert!((metric.column - 463.1e-4).abs() < 1e-15);
        assert_eq!(metric.row, metric.column);
        assert!((metric.up - 5e-4).abs() < 1e-18);
    }

    #[test]
    fn sizes_out_of_all_proportion_are_refused() {
        let tiny = Window::new(0.0, 0.0, 0.0, 1e-320, 1.0).unwrap();
        assert!(Frame::new(tiny, 0.16, &layout()).is_err());
        let vast = Window::new(0.0, 0.0, 0.0, f64::MAX, 1e-300).unwrap();
        assert!(Frame::new(vast, 0.16, &layout()).is_err());
    }

    #[test]
    fn a_broken_pose_makes_a_goal_that_can_be_told() {
        let frame = frame(0.0, 0.0, 0.0, 1600.0, 1.0);
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            for axis in 0..3 {
                let mut hand = [0.0; 3];
                hand[axis] = bad;
                assert!(!frame.goal(hand).is_finite());
            }
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

        #[test]
        fn hand_to_grid_and_back_loses_a_few_bits_of_the_hand_only(
            east in 0.0f64..2e7, north in -1e7f64..0.0, width in 1.0f64..1e6,
            exaggeration in 0.1f64..20.0, hand in prop::array::uniform3(-0.1f64..0.1),
        ) {
            let frame = frame(east, north, 0.0, width, exaggeration);
            let back = frame.displacement(&frame.goal([0.0; 3]), &frame.goal(hand));
            // The rounding of a fraction of a cell, or of as many cells as the hand moves, felt in
            // the workspace.
            let cells = 1.0 + 0.1 / frame.metric().column;
            let rounding = 4.0 * f64::EPSILON * cells * frame.metric().column;
            for (metres, wanted) in back.iter().zip(hand) {
                prop_assert!((metres - wanted).abs() <= rounding, "{metres} instead of {wanted}");
            }
        }

        #[test]
        fn the_terrain_frame_agrees_with_the_window(
            east in 0.0f64..2e7, north in -1e7f64..0.0, up in -8000.0f64..21000.0,
            width in 1.0f64..1e6, hand in prop::array::uniform3(-0.1f64..0.1),
        ) {
            let frame = frame(east, north, up, width, 4.0);
            let scale = 0.16 / width;
            let found = frame.terrain(&frame.goal(hand));
            let wanted = [east + hand[0] / scale, north + hand[1] / scale, up + hand[2] / (scale * 4.0)];
            for (metres, wanted) in found.iter().zip(wanted) {
                prop_assert!((metres - wanted).abs() <= 1e-14 * 3e7);
            }
        }
    }
}
