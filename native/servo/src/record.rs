//! What one tick leaves behind for recordings.

use contact::Feature;
use takes::Tick;

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
    /// Unit vector from the hand to the proxy in the workspace frame, heights exaggerated: the
    /// normal of a surface without friction. Zero in free space; in pan mode, as when the surface was
    /// grabbed.
    pub normal: [f64; 3],
    /// Which buttons are down, a bit each; the first is the stylus button, also where a key was
    /// pressed for it.
    pub buttons: u32,
    /// How far the handle is turned about the vertical, radians; `None` where the device does not
    /// tell.
    pub twist: Option<f64>,
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
            normal: [0.0; 3],
            buttons: 0,
            twist: None,
        }
    }
}

impl From<&TickRecord> for Tick {
    /// What a take keeps of it.
    fn from(record: &TickRecord) -> Tick {
        let window = &record.window;
        Tick {
            number: record.tick,
            time: record.time,
            hand: record.hand,
            goal: record.goal,
            proxy: record.proxy,
            force: record.force,
            twist: record.twist.unwrap_or(0.0),
            window: [
                window.east(),
                window.north(),
                window.up(),
                window.width(),
                window.exaggeration(),
                window.turn(),
            ],
            normal: record.normal.map(|part| part as f32),
            buttons: record.buttons,
            feature: match record.feature {
                Feature::Free => 0,
                Feature::Face => 1,
                Feature::Edge => 2,
                Feature::Vertex => 3,
            },
            mode: match record.mode {
                Mode::Normal => 0,
                Mode::Pan => 1,
                Mode::Zoom => 2,
            },
        }
    }
}
