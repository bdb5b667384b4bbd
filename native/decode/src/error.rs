//! What may be wrong with a file.

use std::io;

/// A file that cannot be decoded. The caller knows its name.
#[derive(Debug, thiserror::Error)]
pub enum DecodeError {
    /// Something in the file is not as it should be.
    #[error("{field}: found {found}, expected {expected}")]
    Wrong {
        /// The part of the file, in the words of its format.
        field: String,
        /// What is there.
        found: String,
        /// What should be there.
        expected: String,
    },
    /// The system refused to read the file, or to write the decoded one.
    #[error(transparent)]
    File(#[from] io::Error),
    /// The decoded samples make no grid.
    #[error(transparent)]
    Grid(#[from] surface::GridError),
    /// The person asked to stop.
    #[error("cancelled")]
    Cancelled,
}

impl DecodeError {
    /// Names a field, what was found and what was expected.
    pub fn wrong(
        field: impl Into<String>,
        found: impl ToString,
        expected: impl Into<String>,
    ) -> Self {
        Self::Wrong { field: field.into(), found: found.to_string(), expected: expected.into() }
    }
}
