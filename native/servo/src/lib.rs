//! The servo: once a millisecond it reads the hand, moves the proxy and answers with a force.
//!
//! From the inside out: the safety chain alone has the device; a [`Servo`] does one tick; an engine
//! around it takes commands and gives records; [`Session`] runs the engine, either on a thread of its
//! own at 1 kHz or step by step. Both ways run the same code, and nothing in a tick waits, allocates, locks or logs.
//! What becomes of the records, takes and their files among it, is done on other threads (`collector`).

#[cfg(feature = "test-hooks")]
pub mod bare;
mod clock;
mod collector;
mod command;
mod deadlines;
mod engine;
mod fault;
#[cfg(feature = "test-hooks")]
pub mod faults;
mod force;
mod frame;
mod helper;
mod histogram;
mod live;
mod memory;
mod mix;
mod modes;
mod passivity;
mod priority;
mod record;
mod recording;
mod replay;
mod safety;
mod servo;
mod session;
mod state;
mod statistics;
mod walls;
mod window;

pub use fault::Fault;
pub use frame::Frame;
pub use histogram::{Distribution, Histogram};
pub use memory::LockedMemory;
pub use modes::Interaction;
pub use priority::Priority;
pub use record::TickRecord;
pub use recording::{Recorded, Recording};
pub use replay::Replay;
#[cfg(feature = "test-hooks")]
pub use safety::Stage;
pub use safety::{Held, Limits, STALE_AFTER, Trips, Warning};
pub use servo::Servo;
pub use session::{Session, SessionError, Settings};
pub use state::{Mode, State};
pub use statistics::{Statistics, Totals};
pub use walls::Walls;
pub use window::Window;

/// Whether a stage of the safety chain can be switched off, for tests: never in what is shipped.
pub const HAS_TEST_HOOKS: bool = cfg!(feature = "test-hooks");
