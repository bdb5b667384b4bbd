//! The A record: what the file says of itself.
//!
//! Source: U.S. Geological Survey, "Standards for Digital Elevation Models", Part 2: Specifications
//! (1998), table 2-1. Bytes are counted from 1 there and in the field names of errors.

use super::field::{Whole, real, whole};
use crate::error::DecodeError;

/// Bytes of the oldest A record, which has nothing after the number of profiles.
pub const SHORTEST: usize = 864;

/// Of what the coordinates are counted (element 5).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum System {
    /// Longitude and latitude.
    Geographic,
    /// Universal Transverse Mercator.
    Utm,
    /// A state plane.
    StatePlane,
    /// Another code of the standard, which has up to 20.
    Other(i32),
}

/// Unit of coordinates and of heights (elements 8 and 9).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unit {
    /// Radians.
    Radians,
    /// Feet.
    Feet,
    /// Metres.
    Metres,
    /// Seconds of arc.
    ArcSeconds,
}

/// The A record.
#[derive(Clone, Debug, PartialEq)]
pub struct Header {
    /// Name of the quadrangle and whatever else the first 40 bytes have.
    pub name: String,
    /// Of the coordinates.
    pub system: System,
    /// Of UTM or state plane; 0 where there is none.
    pub zone: i32,
    /// Of the coordinates.
    pub ground_unit: Unit,
    /// Of the heights.
    pub elevation_unit: Unit,
    /// South-west, north-west, north-east and south-east, (east, north); `None` where one is blank.
    pub corners: Option<[(f64, f64); 4]>,
    /// Lowest and highest height as the file says.
    pub range: Option<(f64, f64)>,
    /// Between columns and between rows, in the unit of the coordinates; above 0.
    pub step: (f64, f64),
    /// What a height's whole number counts, in the unit of heights; above 0.
    pub resolution: f64,
    /// Number of profiles; `None` where it is blank.
    pub profiles: Option<u32>,
    /// Code of the vertical datum; `None` where it is blank, as in all old files.
    pub vertical_datum: Option<i32>,
    /// Code of the horizontal datum; `None` where it is blank.
    pub horizontal_datum: Option<i32>,
}

impl Header {
    /// Reads the A record.
    ///
    /// `length` is how many of these bytes belong to it: what follows is the first profile.
    pub fn read(bytes: &[u8], length: usize) -> Result<Self, DecodeError> {
        let record = Record(&bytes[..length.min(bytes.len())]);
        let system = match record.whole("coordinate system (bytes 157-162)", 157, 6)?.unwrap_or(-1)
        {
            0 => System::Geographic,
            1 => System::Utm,
            2 => System::StatePlane,
            code @ 3..=20 => System::Other(code),
            code => {
                return Err(DecodeError::wrong(
                    "coordinate system (bytes 157-162)",
                    if code == -1 { "nothing".to_owned() } else { code.to_string() },
                    "0 geographic, 1 UTM or 2 state plane",
                ));
            }
        };
        let ground_unit = record
            .unit("ground unit (bytes 529-534)", 529)?
            .unwrap_or(if system == System::Geographic { Unit::ArcSeconds } else { Unit::Metres });
        let elevation_unit =
            record.unit("elevation unit (bytes 535-540)", 535)?.unwrap_or(Unit::Metres);
        if !matches!(elevation_unit, Unit::Feet | Unit::Metres) {
            return Err(DecodeError::wrong(
                "elevation unit (bytes 535-540)",
                if elevation_unit == Unit::Radians { 0 } else { 3 },
                "1 feet or 2 metres",
            ));
        }
        let is_angle = matches!(ground_unit, Unit::Radians | Unit::ArcSeconds);
        if is_angle != (system == System::Geographic) {
            return Err(DecodeError::wrong(
                "ground unit (bytes 529-534)",
                format!("{ground_unit:?} in the coordinate system {system:?}"),
                "an angle in geographic coordinates, a length in others",
            ));
        }
        let usual_step = match ground_unit {
            Unit::ArcSeconds => 3.0,
            Unit::Radians => (3.0_f64 / 3600.0).to_radians(),
            Unit::Metres | Unit::Feet => 30.0,
        };
        Ok(Self {
            name: record.text(1, 40),
            system,
            zone: record.whole("zone (bytes 163-168)", 163, 6)?.unwrap_or(0),
            ground_unit,
            elevation_unit,
            corners: record.corners()?,
            range: match (record.real("minimum", 739, 24)?, record.real("maximum", 763, 24)?) {
                (Some(minimum), Some(maximum)) => Some((minimum, maximum)),
                _ => None,
            },
            step: (
                record.positive("DX (bytes 817-828)", 817)?.unwrap_or(usual_step),
                record.positive("DY (bytes 829-840)", 829)?.unwrap_or(usual_step),
            ),
            resolution: record.positive("DZ (bytes 841-852)", 841)?.unwrap_or(1.0),
            profiles: match record.whole("number of profiles (bytes 859-864)", 859, 6)? {
                Some(count) if count < 1 => {
                    return Err(DecodeError::wrong(
                        "number of profiles (bytes 859-864)",
                        count,
                        "at least 1",
                    ));
                }
                count => count.map(|count| count as u32),
            },
            // In old files other things, or nothing, stand there.
            vertical_datum: record.whole("", 889, 2).unwrap_or(None),
            horizontal_datum: record.whole("", 891, 2).unwrap_or(None),
        })
    }
}

/// Bytes of an A record; what lies beyond them is blank.
struct Record<'bytes>(&'bytes [u8]);

impl Record<'_> {
    /// `length` bytes from byte `first` on, counted from 1.
    fn field(&self, first: usize, length: usize) -> &[u8] {
        let end = (first - 1 + length).min(self.0.len());
        &self.0[(first - 1).min(end)..end]
    }

    fn text(&self, first: usize, length: usize) -> String {
        let text = String::from_utf8_lossy(self.field(first, length));
        let shown: String = text.chars().map(|c| if c.is_control() { ' ' } else { c }).collect();
        shown.trim().to_owned()
    }

    fn whole(&self, name: &str, first: usize, length: usize) -> Result<Option<i32>, DecodeError> {
        match whole(self.field(first, length)) {
            Whole::Blank => Ok(None),
            Whole::Number(number) => Ok(Some(number)),
            Whole::Wrong => {
                let found = format!("\"{}\"", self.text(first, length));
                Err(DecodeError::wrong(name, found, "a whole number"))
            }
        }
    }

    fn real(&self, name: &str, first: usize, length: usize) -> Result<Option<f64>, DecodeError> {
        real(self.field(first, length)).map_err(|_| {
            let found = format!("\"{}\"", self.text(first, length));
            DecodeError::wrong(
                format!("{name} (bytes {first}-{})", first + length - 1),
                found,
                "a finite number",
            )
        })
    }

    fn positive(&self, name: &str, first: usize) -> Result<Option<f64>, DecodeError> {
        match real(self.field(first, 12)) {
            Ok(None) => Ok(None),
            Ok(Some(number)) if number > 0.0 => Ok(Some(number)),
            _ => {
                let found = format!("\"{}\"", self.text(first, 12));
                Err(DecodeError::wrong(name, found, "a number above 0"))
            }
        }
    }

    fn unit(&self, name: &str, first: usize) -> Result<Option<Unit>, DecodeError> {
        match self.whole(name, first, 6)? {
            None => Ok(None),
            Some(0) => Ok(Some(Unit::Radians)),
            Some(1) => Ok(Some(Unit::Feet)),
            Some(2) => Ok(Some(Unit::Metres)),
            Some(3) => Ok(Some(Unit::ArcSeconds)),
            Some(code) => Err(DecodeError::wrong(
                name,
                code,
                "0 radians, 1 feet, 2 metres or 3 seconds of arc",
            )),
        }
    }

    fn corners(&self) -> Result<Option<[(f64, f64); 4]>, DecodeError> {
        let mut corners = [(0.0, 0.0); 4];
        for (index, corner) in corners.iter_mut().enumerate() {
            let first = 547 + 48 * index;
            match (self.real("corner", first, 24)?, self.real("corner", first + 24, 24)?) {
                (Some(x), Some(y)) => *corner = (x, y),
                _ => return Ok(None),
            }
        }
        Ok(Some(corners))
    }
}
