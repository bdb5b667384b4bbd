//! Why touch ended by itself.

use devices::DeviceError;

use crate::safety::TOO_MANY;

/// Why touch ended by itself, in words for the person. After a fault a session gives no force.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Fault {
    /// The device did not answer as it should.
    #[error("touch ended because {0}")]
    Device(DeviceError),
    /// The device failed again and again.
    #[error(
        "touch ended because the device failed {TOO_MANY} times within a second (check its cable, \
         and use no hub between); the last time, {0}"
    )]
    Unreliable(DeviceError),
    /// The grid's file became shorter than it was.
    #[error("touch ended because the terrain's file was cut while in use: import it again")]
    GridDamaged,
    /// The process forked, and this is the child.
    #[error("touch ended because the process forked: the session stays with its parent")]
    Forked,
    /// A mistake in this program, caught.
    #[error("touch ended because of a mistake in the program: {0}")]
    Panic(String),
}

impl Fault {
    /// From what `catch_unwind` caught.
    pub(crate) fn from_panic(payload: &(dyn std::any::Any + Send)) -> Fault {
        let text = if let Some(text) = payload.downcast_ref::<&str>() {
            (*text).to_owned()
        } else if let Some(text) = payload.downcast_ref::<String>() {
            text.clone()
        } else {
            "no further words".to_owned()
        };
        Fault::Panic(text)
    }
}
