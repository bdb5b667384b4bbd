//! Modes of interaction (paper, section 4.2): what the hand's motion does.
//!
//! | mode | begins | the hand | file |
//! | --- | --- | --- | --- |
//! | normal | button released | touches the surface, which may drift on | `drift` |
//! | pan | button pressed in contact | pushes the surface along, held at its height | `pan` |
//! | zoom | button pressed in the air | ratchets the surface nearer and away, and turns it | `zoom` |
//!
//! The terrain never moves. What moves is the window: a mode pins a point of the grid to a place of
//! the workspace, and the frame follows from that, so that nothing adds up to an error.
//!
//! Forces stay stable together as the paper has it. Horizontal and vertical ones are independent.
//! What is left are walls: pan lets its mass go to zero at them, zoom holds the hand at a point
//! between them, and in normal mode surface and walls meet in the mixing room.
//!
//! A change of mode makes no step: grabbing takes over the spring that acts as it is, and what the
//! next mode asks for instead is led to its place by the safety chain's slow slew, as after a switch
//! of contact models.

mod bounds;
mod button;
mod detents;
mod drift;
mod interaction;
mod pan;
mod zoom;

use devices::{Capabilities, NOMINAL_PERIOD, Pose};
use surface::{Grid, GridPoint};

use crate::{Frame, Limits, Mode};

pub(crate) use bounds::Bounds;
use button::Button;
pub(crate) use button::STYLUS;
use drift::Drift;
pub use interaction::Interaction;
use pan::Pan;
use zoom::Zoom;

/// Where the hand is, for a mode.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Hand<'a> {
    pub(crate) pose: &'a Pose,
    /// The nearest point between the walls, workspace metres.
    pub(crate) inside: [f64; 3],
    /// Whether it touches a wall.
    pub(crate) is_at_wall: bool,
    /// Seconds since it was seen last.
    pub(crate) dt: f64,
}

/// What a mode wants to be felt, and of what it is paid.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Hold {
    /// Metres that the servo's spring is stretched, walls not included.
    pub(crate) stretch: [f64; 3],
    /// Newtons beside the spring.
    pub(crate) beside: [f64; 3],
    /// Joules that are kept beside the spring and may come back.
    pub(crate) kept: f64,
    /// Whether walls push as well.
    pub(crate) has_walls: bool,
}

/// What cannot change while a session lasts.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Knobs {
    pub(crate) interaction: Interaction,
    /// Of pan's coupling, N s/m.
    pub(crate) pan_damping: f64,
    /// Half of the workspace's height, metres.
    pub(crate) half_height: f64,
    /// The width of the window at zoom level 0: the whole map's, metres of terrain.
    pub(crate) whole_map: f64,
    /// Metres of terrain, from the narrowest window to the widest.
    pub(crate) widths: [f64; 2],
}

/// What the hand's motion does now.
#[derive(Clone, Copy, Debug)]
enum Motion {
    Normal(Drift),
    Pan(Pan),
    Zoom(Zoom),
}

/// The mode, and what changes it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Modes {
    knobs: Knobs,
    button: Button,
    motion: Motion,
    changes: u64,
}

/// What a new mode asks of the contact model.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Changed {
    /// Nothing: it goes on from where the proxy is.
    GoesOn,
    /// The hand is elsewhere over the terrain: the proxy begins at it.
    BeginsAtHand,
}

impl Modes {
    /// In normal mode, for a device and a grid under `frame`.
    pub(crate) fn new(
        interaction: Interaction,
        capabilities: &Capabilities,
        limits: &Limits,
        frame: &Frame,
    ) -> Modes {
        let [width, depth, height] = capabilities.workspace;
        let layout = frame.layout();
        let across = f64::from(layout.columns()) * layout.cell_width();
        let down = f64::from(layout.rows()) * layout.cell_height();
        let knobs = Knobs {
            interaction,
            pan_damping: pan::damping(&interaction, capabilities, limits),
            half_height: 0.5 * height,
            whole_map: across,
            widths: interaction.zoom_widths.unwrap_or_else(|| {
                let coarsest = layout.cell_width().max(layout.cell_height());
                zoom::widths(coarsest, across.max(down * width / depth))
            }),
        };
        let motion = Motion::Normal(Drift::default());
        Modes { knobs, button: Button::default(), motion, changes: 0 }
    }

    pub(crate) fn mode(&self) -> Mode {
        match self.motion {
            Motion::Normal(_) => Mode::Normal,
            Motion::Pan(_) => Mode::Pan,
            Motion::Zoom(_) => Mode::Zoom,
        }
    }

    /// Changes of mode since it was made.
    pub(crate) fn changes(&self) -> u64 {
        self.changes
    }

    /// The keyboard's stylus button.
    pub(crate) fn press(&mut self, is_down: bool) {
        self.button.press(is_down);
    }

    /// Whether a key is down for the stylus button.
    pub(crate) fn is_key_down(&self) -> bool {
        self.button.is_key_down()
    }

    /// A script's wish.
    pub(crate) fn force(&mut self, mode: Mode) {
        self.button.force(mode);
    }

    /// Touch begins anew: in normal mode, with the surface at rest, and a button that is down must be
    /// released before it does something again.
    pub(crate) fn begin(&mut self) {
        let was_on = self.mode() != Mode::Normal;
        self.changes += u64::from(was_on);
        self.button.begin(was_on);
        self.motion = Motion::Normal(Drift::default());
    }

    /// Looks at the button, and changes the mode where it wants that. `proxy` is where the surface is
    /// touched, or the goal in the air.
    pub(crate) fn look(
        &mut self,
        hand: &Hand<'_>,
        frame: &Frame,
        grid: &Grid,
        proxy: Option<GridPoint>,
    ) -> Option<Changed> {
        let asked = self.button.asked(hand.pose.buttons, self.mode(), proxy.is_some());
        if asked == self.mode() {
            return None;
        }
        self.changes += 1;
        let was_zooming = matches!(self.motion, Motion::Zoom(_));
        self.motion = match asked {
            Mode::Normal => Motion::Normal(self.drift(frame)),
            Mode::Pan => {
                let goal = frame.goal(hand.inside);
                // After zooming the proxy lies where it lay before.
                let held = proxy.filter(|_| !was_zooming).unwrap_or(goal);
                Motion::Pan(Pan::grab(held, hand, frame, self.velocity()))
            }
            Mode::Zoom => Motion::Zoom(Zoom::grab(&self.knobs, hand, frame, grid)),
        };
        Some(if was_zooming { Changed::BeginsAtHand } else { Changed::GoesOn })
    }

    /// What the surface does when it is let go.
    fn drift(&self, frame: &Frame) -> Drift {
        match self.motion {
            Motion::Normal(drift) => drift,
            Motion::Pan(pan) => Drift::new(pan.velocity(), Bounds::around(frame)),
            Motion::Zoom(_) => Drift::default(),
        }
    }

    /// Of the surface, workspace metres a second.
    fn velocity(&self) -> [f64; 2] {
        match self.motion {
            Motion::Normal(drift) => drift.velocity(),
            Motion::Pan(pan) => pan.velocity(),
            Motion::Zoom(_) => [0.0; 2],
        }
    }

    /// Moves the window on by a tick. `None` in normal mode, where contact is felt.
    pub(crate) fn step(
        &mut self,
        hand: &Hand<'_>,
        frame: &mut Frame,
        stiffness: f64,
    ) -> Option<Hold> {
        match &mut self.motion {
            Motion::Normal(drift) => {
                drift.step(&self.knobs, hand, frame);
                None
            }
            Motion::Pan(pan) => Some(pan.step(&self.knobs, hand, frame, stiffness)),
            Motion::Zoom(zoom) => Some(zoom.step(&self.knobs, hand, frame, stiffness)),
        }
    }

    /// The force of the surface on the hand, newtons: while it drifts, its momentum pays for what
    /// that does. Gives the joules that were paid, or below zero those that came back.
    pub(crate) fn pay(&mut self, force: [f64; 3]) -> f64 {
        match &mut self.motion {
            Motion::Normal(drift) => drift.pay(force, self.knobs.interaction.pan_mass),
            Motion::Pan(_) | Motion::Zoom(_) => 0.0,
        }
    }
}

/// A tick's seconds as modes count them: finite, and not backwards.
fn seconds(dt: f64) -> f64 {
    if dt.is_finite() { dt.max(0.0) } else { NOMINAL_PERIOD }
}

#[cfg(test)]
mod tests;
