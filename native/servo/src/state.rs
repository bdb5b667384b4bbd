//! The newest tick, for what is shown.

use contact::Feature;

use crate::{Held, TickRecord, Window};

/// What the hand's motion does.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Mode {
    /// It touches the surface.
    #[default]
    Normal,
    /// It pushes the surface along, held at its height.
    Pan,
    /// It brings the surface nearer or away, and turns it, held in its place.
    Zoom,
}

impl Mode {
    /// All of them.
    pub const ALL: [Mode; 3] = [Mode::Normal, Mode::Pan, Mode::Zoom];

    /// In small letters.
    pub fn name(self) -> &'static str {
        match self {
            Mode::Normal => "normal",
            Mode::Pan => "pan",
            Mode::Zoom => "zoom",
        }
    }
}

/// The newest tick of a session.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct State {
    /// Ticks done since the session was made.
    pub tick: u64,
    /// Seconds on the session's clock.
    pub time: f64,
    /// Workspace frame, metres.
    pub hand: [f64; 3],
    /// The hand in the terrain frame, metres.
    pub goal: [f64; 3],
    /// Terrain frame, metres.
    pub proxy: [f64; 3],
    /// Newtons, workspace frame, as sent to the device.
    pub force: [f64; 3],
    /// What the proxy lies on; in pan mode, what the point that is held lies on.
    pub feature: Feature,
    /// What the hand's motion does.
    pub mode: Mode,
    /// Where the workspace lies: pan and zoom move it.
    pub window: Window,
    /// The name of the contact model in charge.
    pub model: &'static str,
    /// Why the force is away, or not yet wholly back.
    pub held: Option<Held>,
}

impl State {
    pub(crate) fn new(record: &TickRecord, model: &'static str, held: Option<Held>) -> State {
        State {
            tick: record.tick,
            time: record.time,
            hand: record.hand,
            goal: record.goal,
            proxy: record.proxy,
            force: record.force,
            feature: record.feature,
            mode: record.mode,
            window: record.window,
            model,
            held,
        }
    }

    /// Whether the proxy lies on the surface.
    pub fn in_contact(&self) -> bool {
        self.feature != Feature::Free
    }
}
