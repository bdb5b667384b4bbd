//! A take as a hand that can be played again.

use devices::{HandMoment, ParameterError, PathError};
use takes::{Take, Tick};

use crate::Window;

/// Share of the workspace's width: a hand that leads to the recorded goal within this is the recorded
/// one. Rounding in terrain metres is far below it, also at the far side of a planet.
const SAME_HAND: f64 = 1e-6;

/// What a device has to play, and the window in which it has to, so that the goal goes the way that
/// it went.
///
/// The window is that of the first tick, and stays: whatever contact model answers touches the same
/// ground, although it may grab the surface, or not, where another one did not. A hand is the recorded
/// one, to the bit, wherever that leads to the recorded goal through this window. Elsewhere, after a
/// pan or a zoom and behind walls, it is the hand that does.
///
/// Distances on the ground are compared in the proportions of the window, which neither pan nor zoom
/// changes; what they change is how large the hand's motion is, and with it the force. A window that was
/// laid elsewhere in mid-take is a hand that goes there within a tick.
#[derive(Clone, Debug)]
pub struct Replay {
    /// Where the session's workspace must lie.
    pub window: Window,
    /// What the device plays.
    pub hand: Vec<HandMoment>,
}

impl Replay {
    /// Of a take.
    pub fn of(take: &Take) -> Result<Replay, PathError> {
        let first = take.ticks.first().ok_or(PathError::Empty)?;
        let window = window_of(first)?;
        let width = take.header.workspace[0];
        let hand = take.ticks.iter().map(|tick| moment(tick, &window, width)).collect();
        Ok(Replay { window, hand })
    }
}

fn window_of(tick: &Tick) -> Result<Window, ParameterError> {
    let [east, north, up, width, exaggeration, turn] = tick.window;
    Window::new(east, north, up, width, exaggeration)?.turned(turn)
}

fn moment(tick: &Tick, window: &Window, width: f64) -> HandMoment {
    let led = hand_at(tick.goal, window, width);
    let is_same = (0..3).all(|axis| (led[axis] - tick.hand[axis]).abs() <= SAME_HAND * width);
    HandMoment {
        time: tick.time,
        position: if is_same { tick.hand } else { led },
        twist: Some(tick.twist),
        buttons: tick.buttons,
    }
}

/// Where in a workspace of that width (metres) a place of the terrain lies.
fn hand_at([east, north, up]: [f64; 3], window: &Window, width: f64) -> [f64; 3] {
    let scale = width / window.width();
    let (east, north) = ((east - window.east()) * scale, (north - window.north()) * scale);
    let (sine, cosine) = window.turn().sin_cos();
    [
        east * cosine + north * sine,
        north * cosine - east * sine,
        (up - window.up()) * scale * window.exaggeration(),
    ]
}
