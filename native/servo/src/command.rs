//! What the outside asks of a running loop.

use contact::ContactModel;

use crate::Frame;

/// Asked from outside, done at the beginning of the next tick.
pub(crate) enum Command {
    /// Lay the workspace elsewhere.
    Window(Frame),
    /// Pull a simulated hand elsewhere (workspace metres).
    Target([f64; 3]),
    /// Let another contact model go on from where the proxy is.
    Model(Box<dyn ContactModel>),
    /// Whether the passivity observer may add damping.
    PassivityControl(bool),
}
