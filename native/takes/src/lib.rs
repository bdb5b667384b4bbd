//! Takes: recorded touch, in memory and in a file.
//!
//! A crate of its own below the servo: a take is read, written and looked at without a device, a
//! grid, a thread or a clock. Who collects ticks, and when, is for the servo's session to say.
//!
//! # The file
//!
//! All numbers are little-endian. First the header:
//!
//! | bytes | what |
//! | --- | --- |
//! | 8 | `89 54 4F 55 43 48 0D 0A`: a byte that is no text, `TOUCH`, a line end |
//! | 4 | version of the format, 1 |
//! | 4 | bytes of a tick, 188 |
//! | 24 | width, depth and height of the device's workspace, metres (doubles) |
//! | 8 | how many ticks, from the first one on, were felt before recording was asked for |
//! | 4 | bytes of the text, at most 1 MiB |
//! | ... | the text, UTF-8: about the take, for whoever recorded it to say (JSON) |
//! | 4 | CRC-32 (as in zlib) of all of this from the first byte on |
//!
//! Then blocks, one after the other, until the file ends or a closing block says that it is whole:
//!
//! | bytes | what |
//! | --- | --- |
//! | 4 | `TICK`; `DONE` in the closing block, which has no ticks |
//! | 4 | number of ticks in the block, at most 8192 |
//! | 8 | number of ticks in the file up to the end of this block |
//! | 8 | number of ticks that were lost to the take so far |
//! | ... | the ticks |
//! | 4 | CRC-32 of the block |
//!
//! A tick is 188 bytes:
//!
//! | bytes | what |
//! | --- | --- |
//! | 8 | its number in the session |
//! | 8 | seconds on the session's clock (double, as all below to the window) |
//! | 24 | the hand, workspace metres |
//! | 24 | the goal, terrain metres east, north, up |
//! | 24 | the proxy, terrain metres east, north, up |
//! | 24 | the force, newtons, workspace frame |
//! | 8 | turn of the handle, radians; 0 where the device does not tell |
//! | 48 | the window: east, north, up, width (metres), exaggeration, turn (radians) |
//! | 12 | the normal (floats), workspace frame; zero in free space |
//! | 4 | buttons, a bit each |
//! | 2 | what the proxy lies on: 0 nothing, 1 face, 2 edge, 3 vertex |
//! | 2 | mode: 0 normal, 1 pan, 2 zoom |
//!
//! A file that was cut, or is damaged, is read up to the last block before that; what is not read is
//! told. No number in the file is believed before it is checked.

mod block;
mod header;
mod lock;
mod read;
mod spool;
mod take;
mod tick;
mod ticks;
mod write;

pub use block::MOST_IN_BLOCK;
pub use header::{Header, LONGEST_ABOUT};
pub use read::{Loss, ReadError, Reason, Saved, claim, read};
pub use spool::Spool;
pub use take::Take;
pub use tick::Tick;
pub use ticks::Ticks;
pub use write::{WriteError, write};

/// Bytes of a tick in a file.
pub const TICK_BYTES: usize = tick::BYTES;
