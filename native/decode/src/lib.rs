//! Elevation files that cannot be mapped, decoded once to raw samples that touch reads like any others.
//!
//! Every decoder looks at the file's own account of itself first, without its samples, and then brings
//! a region of them into a [`Target`]: memory, or a file on the disk where they are many. It tells how
//! far it has come, and ends when it is asked to ([`Progress`]).

#![deny(missing_docs, unsafe_op_in_unsafe_fn)]

mod error;
pub mod esri_ascii;
mod fill;
pub mod geotiff;
mod pen;
mod progress;
mod raw;
mod region;
mod source;
mod target;
pub mod usgs_dem;
mod window;

pub use error::DecodeError;
pub use fill::fill;
pub use progress::Progress;
pub use raw::{RawSample, RawSamples};
pub use target::{Band, Target};
