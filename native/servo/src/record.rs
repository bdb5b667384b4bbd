//! What one tick leaves behind for recordings.

use contact::Feature;

use crate::{Mode, Window};

/// One tick. Every tick goes into the ring that [`Session::drain`](crate::Session::drain) empties.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TickRecord {
    /// Ticks done since the session was made, this one included.
    pub tick: u64,
    /// Seconds on the session's clock, skipped ticks included.
    pub time: f64,
    /// Workspace frame, metres. Where the pose was not finite: the last one that was.
    pub hand: [f64; 3],
    /// The hand in the terrain frame, metres east, north and up.
    pub goal: [f64; 3],
    /// Terrain frame, metres.
    pub proxy: [f64; 3],
    /// Newtons, workspace frame, as sent to the device.
    pub force: [f64; 3],
    /// What the proxy lies on; in pan mode, what the point that is held lies on.
    pub feature: Feature,
    /// Vertices visited by constrained minimisation.
    pub vertices: u32,
    /// Triangles that the surface walk looked at.
    pub faces: u32,
    /// Free-space minimisations begun.
    pub collision_tests: u32,
    /// Grid cells that the collision tests went through.
    pub cells: u32,
    /// What the hand's motion does.
    pub mode: Mode,
    /// Where the workspace lies.
    pub window: Window,
}

impl TickRecord {
    /// Before the first tick: hand, goal and proxy at the workspace's origin, which lies at
    /// `terrain`.
    pub(crate) fn at_rest(terrain: [f64; 3], window: Window) -> TickRecord {
        TickRecord {
            tick: 0,
            time: 0.0,
            hand: [0.0; 3],
            goal: terrain,
            proxy: terrain,
            force: [0.0; 3],
            feature: Feature::Free,
            vertices: 0,
            faces: 0,
            collision_tests: 0,
            cells: 0,
            mode: Mode::Normal,
            window,
        }
    }
}
