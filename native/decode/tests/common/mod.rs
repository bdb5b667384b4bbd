//! What the tests and the fuzzing share.

pub mod random;
pub mod tiff_bytes;
