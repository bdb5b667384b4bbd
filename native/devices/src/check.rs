//! Checks of numbers that people and drivers give.

/// A number that cannot be used, with its name.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{name} is {value}, expected {expected}")]
pub struct ParameterError {
    /// Which number.
    pub name: &'static str,
    /// What was given.
    pub value: f64,
    /// What can be used, in words.
    pub expected: &'static str,
}

/// The value must be finite and above zero.
pub fn positive(name: &'static str, value: f64) -> Result<(), ParameterError> {
    let usable = value > 0.0 && value.is_finite();
    require(usable, name, value, "a finite number above zero")
}

/// The value must be zero or more; infinity says that nothing limits it.
pub fn limit(name: &'static str, value: f64) -> Result<(), ParameterError> {
    require(value >= 0.0, name, value, "zero or more")
}

/// The value must be above zero; infinity says that nothing limits it.
pub fn positive_or_infinite(name: &'static str, value: f64) -> Result<(), ParameterError> {
    require(value > 0.0, name, value, "a number above zero")
}

/// The value must be finite, and zero or more.
pub fn not_negative(name: &'static str, value: f64) -> Result<(), ParameterError> {
    let usable = value >= 0.0 && value.is_finite();
    require(usable, name, value, "a finite number, zero or more")
}

/// The value must be finite.
pub fn finite(name: &'static str, value: f64) -> Result<(), ParameterError> {
    require(value.is_finite(), name, value, "a finite number")
}

/// Width, depth and height of a workspace must each be finite and above zero.
pub fn workspace(metres: [f64; 3]) -> Result<(), ParameterError> {
    positive("workspace width", metres[0])?;
    positive("workspace depth", metres[1])?;
    positive("workspace height", metres[2])
}

fn require(
    usable: bool,
    name: &'static str,
    value: f64,
    expected: &'static str,
) -> Result<(), ParameterError> {
    if usable { Ok(()) } else { Err(ParameterError { name, value, expected }) }
}
