//! How heights are stored: in the smallest type that keeps every one as it is written.
//!
//! Whole numbers take 16 or 32 bits. Others take single precision only where all of them have it exactly
//! (halves, quarters, ...): 123.456 has not, and a height that reads 123.45600128 where the file says
//! 123.456 has lost something. Whether it would come back as text, by the shortest way of writing it,
//! would have to be asked of each, and takes longer than reading it; so they take double precision.

use crate::error::DecodeError;
use surface::{GridLayout, SampleType};

/// Beyond it a void value may have been rounded on its way into text.
const NEAR_LARGEST: f64 = 1e38;

/// Which values mean "no data".
#[derive(Clone, Copy, Debug)]
pub struct Nodata(pub f64);

impl Nodata {
    /// Whether this value does. The largest numbers of single precision are written with few digits, by
    /// one program in the header and by another in the grid: all such are the void value where it is one.
    #[inline]
    pub fn is(&self, value: f64) -> bool {
        value == self.0 || value.is_nan() || value.abs() >= NEAR_LARGEST && self.reaches(value)
    }

    fn reaches(&self, value: f64) -> bool {
        value.is_infinite() || self.0.abs() >= NEAR_LARGEST
    }
}

/// What the heights turned out to be.
#[derive(Clone, Copy, Debug)]
pub struct Found {
    /// How many, voids left out.
    pub heights: u64,
    /// Voids.
    pub voids: u64,
    /// The lowest height.
    pub lowest: f64,
    /// The highest height.
    pub highest: f64,
    are_whole: bool,
    are_single: bool,
}

impl Default for Found {
    fn default() -> Self {
        Self {
            heights: 0,
            voids: 0,
            lowest: f64::INFINITY,
            highest: f64::NEG_INFINITY,
            are_whole: true,
            are_single: true,
        }
    }
}

impl Found {
    /// Another height.
    #[inline]
    pub fn add(&mut self, height: f64) {
        self.heights += 1;
        self.lowest = self.lowest.min(height);
        self.highest = self.highest.max(height);
        self.are_whole &= height == height.trunc();
        self.are_single &= height == f64::from(height as f32);
    }
}

/// How the heights are stored.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stored {
    /// Sample type.
    pub sample: SampleType,
    /// The sample that means "no data".
    pub void: f64,
}

impl Stored {
    /// The smallest type that keeps them all, and a void that none of them is.
    pub fn of(found: &Found, nodata: Nodata) -> Self {
        let fits = |least: f64, most: f64| {
            found.heights == 0 || (found.lowest > least && found.highest <= most)
        };
        let (short, long) = (f64::from(i16::MIN), f64::from(i32::MIN));
        if found.are_whole && fits(short, f64::from(i16::MAX)) {
            let is_short = nodata.0 == nodata.0.trunc() && nodata.0.abs() <= f64::from(i16::MAX);
            return Self { sample: SampleType::I16, void: if is_short { nodata.0 } else { short } };
        }
        if found.are_whole && fits(long, f64::from(i32::MAX)) {
            return Self { sample: SampleType::I32, void: long };
        }
        let sample = if found.are_single { SampleType::F32 } else { SampleType::F64 };
        Self { sample, void: f64::NAN }
    }

    /// Refuses a layout in another sample type.
    pub fn check(&self, layout: &GridLayout) -> Result<(), DecodeError> {
        if layout.sample() == self.sample {
            return Ok(());
        }
        Err(DecodeError::wrong(
            "sample type",
            format!("{:?}", layout.sample()),
            format!("{:?}", self.sample),
        ))
    }
}
