//! Numbers from Python: whole ones, which may be larger than any of Rust's, and many doubles.

use pyo3::buffer::PyBuffer;
use pyo3::exceptions::PyOverflowError;
use pyo3::prelude::*;
use std::fmt::Display;

/// A whole number of any size; beyond 128 bits only its sign is kept.
#[derive(Clone, Copy)]
pub struct Whole(pub i128);

impl FromPyObject<'_, '_> for Whole {
    type Error = PyErr;

    fn extract(number: Borrowed<'_, '_, PyAny>) -> PyResult<Self> {
        match number.extract::<i128>() {
            Ok(number) => Ok(Self(number)),
            Err(error) if error.is_instance_of::<PyOverflowError>(number.py()) => {
                Ok(Self(if number.lt(0)? { i128::MIN } else { i128::MAX }))
            }
            Err(error) => Err(error),
        }
    }
}

impl Whole {
    /// The number as one of Rust's types, if it fits.
    pub fn fitting<T: TryFrom<i128>>(self) -> Option<T> {
        T::try_from(self.0).ok()
    }

    /// The number as an unsigned type, or words that name the field.
    pub fn unsigned<T: TryFrom<i128> + Bounded>(self, field: &str) -> Result<T, String> {
        self.fitting().ok_or_else(|| {
            format!("{field} is {self}; expected a whole number from 0 to {}", T::LARGEST)
        })
    }
}

impl Whole {
    /// The number as `u32`, at least `least`, or words that name the field.
    pub fn at_least(self, least: u32, field: &str) -> Result<u32, String> {
        let number = self.fitting().filter(|number| *number >= least);
        number.ok_or_else(|| {
            format!("{field} is {self}; expected a whole number from {least} to {}", u32::LARGEST)
        })
    }
}

impl Display for Whole {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self.0 {
            i128::MIN => f.write_str("a number below -2^127"),
            i128::MAX => f.write_str("a number above 2^127"),
            number => number.fmt(f),
        }
    }
}

/// A type with a largest number to name.
pub trait Bounded {
    /// Its largest number.
    const LARGEST: u64;
}

impl Bounded for u32 {
    const LARGEST: u64 = u32::MAX as u64;
}

impl Bounded for u64 {
    const LARGEST: u64 = u64::MAX;
}

/// Many doubles: a buffer of them (an array, a memoryview, numpy's), or any sequence of numbers.
pub struct Doubles(pub Vec<f64>);

impl FromPyObject<'_, '_> for Doubles {
    type Error = PyErr;

    fn extract(object: Borrowed<'_, '_, PyAny>) -> PyResult<Self> {
        match PyBuffer::<f64>::get(&object) {
            Ok(buffer) => Ok(Self(buffer.to_vec(object.py())?)),
            // No buffer, or one of other numbers.
            Err(_) => Ok(Self(object.extract()?)),
        }
    }
}
