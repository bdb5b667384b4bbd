//! How heights are stored: in the smallest type that keeps every one as the file has it.

use super::header::Header;
use super::profile::Head;
use crate::error::DecodeError;
use surface::{GridLayout, SampleType};

/// What the heights turned out to be.
#[derive(Clone, Copy, Debug)]
pub struct Found {
    /// How many, voids left out.
    pub heights: u64,
    /// Voids that are written as blanks.
    pub blanks: u64,
    /// In the file's unit of heights.
    pub lowest: f64,
    /// In the file's unit of heights.
    pub highest: f64,
    /// The whole numbers in the file.
    numbers: (i32, i32),
    datums: Option<(f64, f64)>,
    datums_are_whole: bool,
}

impl Default for Found {
    fn default() -> Self {
        Self {
            heights: 0,
            blanks: 0,
            lowest: f64::INFINITY,
            highest: f64::NEG_INFINITY,
            numbers: (i32::MAX, i32::MIN),
            datums: None,
            datums_are_whole: true,
        }
    }
}

impl Found {
    /// Another profile.
    pub fn add(&mut self, seen: &Seen, head: &Head, resolution: f64) {
        let datum = head.local_datum;
        let (least, most) = self.datums.unwrap_or((datum, datum));
        self.datums = Some((least.min(datum), most.max(datum)));
        self.datums_are_whole &= datum == datum.trunc();
        self.blanks += seen.blanks;
        self.heights += seen.heights;
        if seen.heights > 0 {
            let height = |number: i32| f64::from(number) * resolution + datum;
            self.lowest = self.lowest.min(height(seen.lowest));
            self.highest = self.highest.max(height(seen.highest));
            self.numbers = (self.numbers.0.min(seen.lowest), self.numbers.1.max(seen.highest));
        }
    }
}

/// What the numbers of a profile turned out to be.
#[derive(Clone, Copy, Debug)]
pub struct Seen {
    heights: u64,
    /// Blank fields.
    pub blanks: u64,
    lowest: i32,
    highest: i32,
}

impl Default for Seen {
    fn default() -> Self {
        Self { heights: 0, blanks: 0, lowest: i32::MAX, highest: i32::MIN }
    }
}

impl Seen {
    /// Another number that is no void.
    #[inline]
    pub fn add(&mut self, number: i32) {
        self.heights += 1;
        self.lowest = self.lowest.min(number);
        self.highest = self.highest.max(number);
    }
}

/// How the heights are stored; a height in the file's unit = sample x `scale` + `value_offset`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stored {
    /// Sample type.
    pub sample: SampleType,
    /// Unit of heights for a unit of the sample.
    pub scale: f64,
    /// Height of sample 0.
    pub value_offset: f64,
    /// The sample that means "no data".
    pub void: f64,
    adds: Option<f64>,
}

impl Stored {
    /// The numbers of the file themselves where one datum serves all profiles. Else datums are added:
    /// to whole metres or feet in whole numbers, to others in double precision.
    pub fn of(header: &Header, found: &Found) -> Result<Self, DecodeError> {
        let (least, most) = found.datums.unwrap_or((0.0, 0.0));
        if found.heights > 0 && (found.lowest.abs().max(found.highest.abs()) > 1e6) {
            return Err(DecodeError::wrong(
                "heights",
                format!("{:e} to {:e}", found.lowest, found.highest),
                "heights within 1,000,000 of a datum",
            ));
        }
        let (lowest, highest) = (f64::from(found.numbers.0), f64::from(found.numbers.1));
        if least == most {
            let plain = Self::whole(lowest, highest);
            return Ok(Self { scale: header.resolution, value_offset: least, ..plain });
        }
        if header.resolution == 1.0 && found.datums_are_whole {
            return Ok(Self { adds: Some(1.0), ..Self::whole(found.lowest, found.highest) });
        }
        Ok(Self {
            sample: SampleType::F64,
            scale: 1.0,
            value_offset: 0.0,
            void: f64::NAN,
            adds: Some(header.resolution),
        })
    }

    fn whole(lowest: f64, highest: f64) -> Self {
        // A grid of voids alone fits too: there the lowest is above the highest.
        let is_short = lowest > f64::from(i16::MIN) + 1.0 && highest <= f64::from(i16::MAX);
        Self {
            sample: if is_short { SampleType::I16 } else { SampleType::I32 },
            scale: 1.0,
            value_offset: 0.0,
            void: if is_short { -32767.0 } else { f64::from(i32::MIN) },
            adds: None,
        }
    }

    /// The sample for a number of the file in a profile with this datum; `None`: the number itself.
    #[inline]
    pub fn adds_datum(&self, number: i32, local_datum: f64) -> Option<f64> {
        self.adds.map(|resolution| f64::from(number) * resolution + local_datum)
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
