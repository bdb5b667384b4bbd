//! From the hand to the grid and back, through the window.

use devices::{ParameterError, check};
use surface::{GridLayout, GridPoint, Metric};

use crate::Window;

/// A window on a grid, for a workspace of one width: what turns hands into goals.
///
/// The grid point under the workspace's origin is kept as a whole cell and a fraction, and the hand
/// is added to the fraction: a goal is as fine as the hand's own numbers, however far from column 0
/// the window lies.
///
/// Contact works in the grid's own directions: a turn about the vertical changes no distance, so it
/// is only the hand that is turned on its way in, and the force on its way out.
#[derive(Clone, Copy, Debug)]
pub struct Frame {
    window: Window,
    layout: GridLayout,
    /// Metres.
    workspace_width: f64,
    metric: Metric,
    origin: GridPoint,
    /// Cosine and sine of the window's turn.
    turn: [f64; 2],
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
        let metric = metric(&window, workspace_width, layout);
        check::positive("workspace metres per column", metric.column)?;
        check::positive("workspace metres per row", metric.row)?;
        check::positive("workspace metres per metre of height", metric.up)?;

        let origin = layout.grid_point([window.east(), window.north(), window.up()]);
        check::finite("column under the window", origin.columns())?;
        check::finite("row under the window", origin.rows())?;
        let turn = cosine_and_sine(window.turn());
        Ok(Frame { window, layout: *layout, workspace_width, metric, origin, turn })
    }

    /// The window that this frame was made from, or moved to.
    pub fn window(&self) -> Window {
        self.window
    }

    /// Workspace metres per column, per row, and per metre of elevation.
    pub fn metric(&self) -> &Metric {
        &self.metric
    }

    /// The grid that it lies on.
    pub(crate) fn layout(&self) -> &GridLayout {
        &self.layout
    }

    /// The grid point under the workspace's origin.
    pub(crate) fn origin(&self) -> GridPoint {
        self.origin
    }

    /// The goal: where on the grid the hand is (workspace metres).
    pub fn goal(&self, hand: [f64; 3]) -> GridPoint {
        let [east, north] = self.compass([hand[0], hand[1]]);
        GridPoint::from_sample(
            self.origin.column,
            self.origin.row,
            self.origin.u + east / self.metric.column,
            // Rows count southward.
            self.origin.v - north / self.metric.row,
            self.origin.elevation + hand[2] / self.metric.up,
        )
    }

    /// The way from one grid point to another in the workspace, metres.
    pub fn displacement(&self, from: &GridPoint, to: &GridPoint) -> [f64; 3] {
        let [columns, rows] = ground_way(from, to);
        // "0.0 -" instead of a sign: no way north is 0, not -0.
        let (east, north) = (columns * self.metric.column, 0.0 - rows * self.metric.row);
        self.turned([east, north, (to.elevation - from.elevation) * self.metric.up])
    }

    /// The workspace's own directions (right, away, up) for a way to the east, to the north and up.
    pub(crate) fn turned(&self, [east, north, up]: [f64; 3]) -> [f64; 3] {
        let [cosine, sine] = self.turn;
        [east * cosine + north * sine, north * cosine - east * sine, up]
    }

    /// Where in the workspace a grid point lies, metres.
    pub(crate) fn workspace(&self, point: &GridPoint) -> [f64; 3] {
        self.displacement(&self.origin, point)
    }

    /// The frame of `width` metres and `turn` radians in which the grid point `point` lies at `at` in
    /// the workspace. `None` where there is none that doubles can hold.
    pub(crate) fn pinned(
        &self,
        point: &GridPoint,
        at: [f64; 3],
        width: f64,
        turn: f64,
    ) -> Option<Frame> {
        let window = self.window.moved([0.0; 3], width, turn);
        let metric = metric(&window, self.workspace_width, &self.layout);
        let mut frame = Frame { window, metric, turn: cosine_and_sine(turn), ..*self };
        let [east, north] = frame.compass([at[0], at[1]]);
        frame.origin = GridPoint::from_sample(
            point.column,
            point.row,
            point.u - east / metric.column,
            point.v + north / metric.row,
            point.elevation - at[2] / metric.up,
        );
        let place = self.layout.terrain_place(&frame.origin);
        frame.window = window.moved(place, width, turn);
        let is_usable = metric.is_valid()
            && width > 0.0
            && width.is_finite()
            && frame.origin.is_finite()
            && place.iter().all(|metres| metres.is_finite());
        is_usable.then_some(frame)
    }

    /// The same frame with its origin at another grid point.
    pub(crate) fn at(&self, origin: &GridPoint) -> Option<Frame> {
        self.pinned(origin, [0.0; 3], self.window.width(), self.window.turn())
    }

    /// Metres east and north for metres right and away.
    fn compass(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let [cosine, sine] = self.turn;
        [x * cosine - y * sine, x * sine + y * cosine]
    }

    /// A grid point in the terrain frame: metres east, north and up.
    pub fn terrain(&self, point: &GridPoint) -> [f64; 3] {
        self.layout.terrain_place(point)
    }
}

/// Workspace metres for a step in each direction of the grid.
fn metric(window: &Window, workspace_width: f64, layout: &GridLayout) -> Metric {
    let scale = workspace_width / window.width();
    Metric {
        column: layout.cell_width() * scale,
        row: layout.cell_height() * scale,
        up: scale * window.exaggeration(),
    }
}

/// Of an angle; no turn is none to the last bit.
fn cosine_and_sine(radians: f64) -> [f64; 2] {
    let (sine, cosine) = radians.sin_cos();
    [cosine, sine]
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
    fn a_turned_window_has_its_x_north_of_east() {
        let quarter = std::f64::consts::FRAC_PI_2;
        let window = Window::new(4631.0, -4631.0, 100.0, 1600.0, 2.0).unwrap();
        let frame = Frame::new(window.turned(quarter).unwrap(), 0.16, &layout()).unwrap();
        let [east, north, up] = frame.terrain(&frame.goal([0.01, 0.02, 0.002]));
        assert!((east - (4631.0 - 200.0)).abs() < 1e-9, "away is west: {east}");
        assert!((north - (-4631.0 + 100.0)).abs() < 1e-9, "right is north: {north}");
        assert!((up - 110.0).abs() < 1e-9);
        assert!(window.turned(f64::NAN).is_err());
    }

    #[test]
    fn a_frame_that_no_double_holds_is_not_pinned() {
        let frame = frame(4631.0, -4631.0, 0.0, 1600.0, 1.0);
        let origin = frame.origin();
        for (width, turn, at) in [
            (0.0, 0.0, 0.0),
            (f64::INFINITY, 0.0, 0.0),
            (1e-320, 0.0, 0.0),
            (1600.0, f64::NAN, 0.0),
            (1600.0, 0.0, f64::INFINITY),
        ] {
            assert!(frame.pinned(&origin, [at, 0.0, 0.0], width, turn).is_none());
        }
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

        /// Over all turns: distances stay, the way back is the way there.
        #[test]
        fn a_turn_changes_no_distance_and_a_pinned_point_lies_where_it_was_pinned(
            east in 0.0f64..2e7, north in -1e7f64..0.0, width in 10.0f64..1e6, turn in -7.0f64..7.0,
            zoomed in 10.0f64..1e6, hand in prop::array::uniform3(-0.1f64..0.1),
            at in prop::array::uniform3(-0.1f64..0.1), other in -7.0f64..7.0,
        ) {
            let window = Window::new(east, north, 0.0, width, 3.0).unwrap().turned(turn).unwrap();
            let frame = Frame::new(window, 0.16, &layout()).unwrap();
            let point = frame.goal(hand);
            let rounding = 1e-12;
            for (metres, wanted) in frame.workspace(&point).into_iter().zip(hand) {
                prop_assert!((metres - wanted).abs() <= rounding, "{metres} instead of {wanted}");
            }
            let pinned = frame.pinned(&point, at, zoomed, other).unwrap();
            for (metres, wanted) in pinned.workspace(&point).into_iter().zip(at) {
                prop_assert!((metres - wanted).abs() <= rounding, "{metres} instead of {wanted}");
            }
            prop_assert_eq!((pinned.window().width(), pinned.window().turn()), (zoomed, other));
            // The window it tells makes the same frame.
            let again = Frame::new(pinned.window(), 0.16, &layout()).unwrap();
            let apart = pinned.displacement(&again.goal(at), &point);
            // A window's own numbers are metres of a planet, 4e-9 m fine.
            let coarse = 1e-8 * 0.16 / zoomed + rounding;
            prop_assert!(apart.iter().all(|metres| metres.abs() <= coarse), "{apart:?}");
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
