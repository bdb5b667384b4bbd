//! What the outside asks of a running loop.

use crate::Frame;

/// Asked from outside, done at the beginning of the next tick.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Command {
    /// Lay the workspace elsewhere.
    SetWindow(Frame),
    /// Pull a simulated hand elsewhere (workspace metres).
    SetTarget([f64; 3]),
}
