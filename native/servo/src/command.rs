//! What the outside asks of a running loop.

use contact::ContactModel;

use crate::Frame;

/// Asked from outside, done at the beginning of the next tick.
pub(crate) enum Command {
    /// Lay the workspace elsewhere.
    SetWindow(Frame),
    /// Pull a simulated hand elsewhere (workspace metres).
    SetTarget([f64; 3]),
    /// Let another contact model go on from where the proxy is.
    SetModel(Box<dyn ContactModel>),
}
