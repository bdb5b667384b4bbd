//! What the outside asks of a running loop.

use contact::ContactModel;

use crate::{Frame, Mode};

/// Asked from outside, done at the beginning of the next tick.
pub(crate) enum Command {
    /// Lay the workspace elsewhere.
    Window {
        /// With the window on the grid.
        frame: Frame,
        /// How many windows were asked for, this one included.
        number: u64,
    },
    /// Whether the stylus button of the keyboard is down.
    Press(bool),
    /// Change the mode, whatever the button says.
    Mode(Mode),
    /// Turn a simulated handle (radians).
    Twist(f64),
    /// Pull a simulated hand elsewhere (workspace metres).
    Target([f64; 3]),
    /// Let another contact model go on from where the proxy is.
    Model(Box<dyn ContactModel>),
    /// Whether the passivity observer may add damping.
    PassivityControl(bool),
}
