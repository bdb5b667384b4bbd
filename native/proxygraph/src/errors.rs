//! The module's exceptions.

use pyo3::create_exception;
use pyo3::exceptions::{PyOSError, PyRuntimeError, PyValueError};
use pyo3::prelude::*;
use std::path::Path;

create_exception!(
    proxygraph,
    GridError,
    PyValueError,
    "A layout, a file or a buffer cannot be used as a grid; the text says what was found and expected."
);
create_exception!(
    proxygraph,
    SessionError,
    PyRuntimeError,
    "A session was used in a state that does not allow the call."
);

/// A grid error from anything that explains itself.
pub fn grid_error(error: impl std::fmt::Display) -> PyErr {
    GridError::new_err(error.to_string())
}

/// What a session says, as the contract's exceptions: numbers that cannot be used are `ValueError`s.
pub fn session_refusal(error: servo::SessionError) -> PyErr {
    match error {
        servo::SessionError::Parameter(parameter) => value_error(parameter),
        other => session_error(other),
    }
}

/// A session error from anything that explains itself.
pub fn session_error(error: impl std::fmt::Display) -> PyErr {
    SessionError::new_err(error.to_string())
}

/// A `ValueError` from anything that explains itself.
pub fn value_error(error: impl std::fmt::Display) -> PyErr {
    PyValueError::new_err(error.to_string())
}

/// What the system says, as Python's own `OSError` with its number and the file: callers tell a full
/// disk from the rest.
pub fn os_error(error: std::io::Error, path: Option<&Path>) -> PyErr {
    match (error.raw_os_error(), path) {
        // Windows counts its errors otherwise.
        (Some(number), Some(path)) if cfg!(unix) => {
            PyOSError::new_err((number, plain_text(&error), path.as_os_str().to_owned()))
        }
        (Some(number), None) if cfg!(unix) => PyOSError::new_err((number, plain_text(&error))),
        _ => error.into(),
    }
}

/// The system's words without the number that Rust puts behind them.
fn plain_text(error: &std::io::Error) -> String {
    let text = error.to_string();
    text.split(" (os error").next().unwrap_or_default().to_owned()
}
