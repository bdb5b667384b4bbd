//! Zoom: the hand holds empty space and ratchets the surface nearer or away.

use surface::{Grid, GridPoint};

use super::detents::detent;
use super::{Hand, Hold, Knobs};
use crate::Frame;

/// Metres above the ground below which a hand that comes down pushes the surface down before it. Ours:
/// so that a hand let go is in the air, and the ground is where it can be touched at once.
const CLEARANCE: f64 = 0.005;

/// Of the workspace's half height: what lies lower is beyond reach.
const FLOOR: f64 = 0.9;

/// Cells across the narrowest window: at a desktop device's 16 cm a cell is as wide as a thumb is long.
const FEWEST_CELLS: f64 = 4.0;

/// Times the whole map, the widest window.
const WIDEST: f64 = 2.0;

/// The narrowest and the widest window over a map whose cells and whole are that wide, metres.
pub(super) fn widths(cell: f64, whole_map: f64) -> [f64; 2] {
    let narrowest = FEWEST_CELLS * cell;
    [narrowest, (WIDEST * whole_map).max(narrowest)]
}

/// The point that is held in place, and what follows from the hand's height.
#[derive(Clone, Copy, Debug)]
pub(super) struct Zoom {
    /// On the vertical through the cursor, where the ground is, if it can be reached.
    held: GridPoint,
    /// How high that is in the workspace, metres.
    height: f64,
    /// Metres that the hand is kept above it.
    clearance: f64,
    /// Where the hand is held, right and away, metres.
    anchor: [f64; 2],
    /// Of the hand when it began, metres.
    began_at: f64,
    /// How wide the window was then: factors of 2 of the whole map.
    level: f64,
    /// From the widest to the narrowest.
    levels: [f64; 2],
    /// Of the handle in the last tick, radians.
    twist: Option<f64>,
    /// Of the window, radians.
    turn: f64,
}

impl Zoom {
    pub(super) fn grab(knobs: &Knobs, hand: &Hand<'_>, frame: &Frame, grid: &Grid) -> Zoom {
        let [x, y, z] = hand.inside;
        let goal = frame.goal(hand.inside);
        let ground = grid.surface_elevation(&goal).map(|elevation| {
            let ground = GridPoint { elevation, ..goal };
            frame.workspace(&ground)[2]
        });
        // Beside the map the middle of the workspace is as good a place as any. Ground out of reach
        // below comes nearer when the floor is held.
        let height = ground.unwrap_or(0.0).max(-FLOOR * knobs.half_height);
        let window = frame.window();
        let level = |width: f64| (width / knobs.whole_map).log2();
        let now = level(window.width());
        let [narrowest, widest] = knobs.widths.map(level);
        Zoom {
            held: GridPoint { elevation: frame.goal([x, y, height]).elevation, ..goal },
            height,
            clearance: (z - height).min(CLEARANCE),
            anchor: [x, y],
            began_at: z,
            level: now,
            // A window beyond the limits is no reason to jump.
            levels: [narrowest.min(now), widest.max(now)],
            twist: hand.pose.twist,
            turn: window.turn(),
        }
    }

    /// Moves the window on by a tick. Beyond a limit the width stays and a spring pushes back, as a
    /// wall does.
    pub(super) fn step(
        &mut self,
        knobs: &Knobs,
        hand: &Hand<'_>,
        frame: &mut Frame,
        stiffness: f64,
    ) -> Hold {
        let [x, y, z] = hand.inside;
        let pitch = knobs.interaction.zoom_travel;
        let wanted = self.level - (z - self.began_at) / pitch;
        let level = wanted.clamp(self.levels[0], self.levels[1]);
        // No hand is believed to have gone below the workspace.
        let reached = z.max(-knobs.half_height);
        self.height = self.height.min(reached - self.clearance);
        self.turn_with(hand);
        let width = knobs.whole_map * level.exp2();
        if let Some(pinned) = frame.pinned(&self.held, [x, y, self.height], width, self.turn) {
            *frame = pinned;
        }
        // No detent is steeper than the spring.
        let force = knobs.interaction.detent_force.min(0.25 * pitch * stiffness);
        let (pull, kept) = detent(level, pitch, force);
        let [hand_x, hand_y, _] = hand.pose.position;
        Hold {
            stretch: [self.anchor[0] - hand_x, self.anchor[1] - hand_y, (wanted - level) * pitch],
            // A higher level is a lower hand.
            beside: [0.0, 0.0, -pull],
            kept,
            has_walls: false,
        }
    }

    /// The surface turns with the handle, and the window the other way.
    fn turn_with(&mut self, hand: &Hand<'_>) {
        let Some(twist) = hand.pose.twist else {
            return;
        };
        let before = self.twist.replace(twist).unwrap_or(twist);
        let turned = self.turn - nearest(twist - before);
        self.turn = nearest(turned);
    }
}

/// The same angle, from half a turn right to half a turn left; 0 for what is no angle.
fn nearest(radians: f64) -> f64 {
    let whole = std::f64::consts::TAU;
    let nearest = radians - whole * (radians / whole).round();
    if nearest.is_finite() { nearest } else { 0.0 }
}
