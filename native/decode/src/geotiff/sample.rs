//! The number formats in files, and how each becomes one that touch reads.

use crate::error::DecodeError;
use surface::{ByteOrder, SampleType};

/// A number format in a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StoredSample {
    /// Unsigned 8 bit.
    U8,
    /// Signed 8 bit.
    I8,
    /// Unsigned 16 bit.
    U16,
    /// Signed 16 bit.
    I16,
    /// Unsigned 32 bit.
    U32,
    /// Signed 32 bit.
    I32,
    /// IEEE single precision.
    F32,
    /// IEEE double precision.
    F64,
}

impl StoredSample {
    /// The format of the tags SampleFormat (1 unsigned, 2 signed, 3 IEEE, 4 not stated) and BitsPerSample.
    pub fn of(format: u64, bits: u64) -> Result<Self, DecodeError> {
        Ok(match (format, bits) {
            (1 | 4, 8) => Self::U8,
            (1 | 4, 16) => Self::U16,
            (1 | 4, 32) => Self::U32,
            (2, 8) => Self::I8,
            (2, 16) => Self::I16,
            (2, 32) => Self::I32,
            (3, 32) => Self::F32,
            (3, 64) => Self::F64,
            _ => {
                let kind = match format {
                    1 | 4 => "unsigned whole numbers".to_owned(),
                    2 => "signed whole numbers".to_owned(),
                    3 => "floating point numbers".to_owned(),
                    5 | 6 => "complex numbers".to_owned(),
                    _ => format!("numbers of SampleFormat {format}"),
                };
                return Err(DecodeError::wrong(
                    "BitsPerSample",
                    format!("{kind} of {bits} bits"),
                    "whole numbers of 8, 16 or 32 bits, or floating point numbers of 32 or 64",
                ));
            }
        })
    }

    /// As the contract calls it.
    pub fn name(self) -> &'static str {
        match self {
            Self::U8 => "u8",
            Self::I8 => "i8",
            Self::U16 => "u16",
            Self::I16 => "i16",
            Self::U32 => "u32",
            Self::I32 => "i32",
            Self::F32 => "f32",
            Self::F64 => "f64",
        }
    }

    /// Bytes of one sample in the file.
    pub fn bytes(self) -> usize {
        match self {
            Self::U8 | Self::I8 => 1,
            Self::U16 | Self::I16 => 2,
            Self::U32 | Self::I32 | Self::F32 => 4,
            Self::F64 => 8,
        }
    }

    /// Whether it is a floating point format.
    pub fn is_float(self) -> bool {
        matches!(self, Self::F32 | Self::F64)
    }

    /// The format that touch reads, and that holds every value of this one.
    pub fn decoded(self) -> SampleType {
        match self {
            Self::U8 | Self::I8 | Self::I16 => SampleType::I16,
            Self::U16 => SampleType::U16,
            Self::I32 => SampleType::I32,
            Self::F32 => SampleType::F32,
            Self::U32 | Self::F64 => SampleType::F64,
        }
    }

    /// Whether touch reads it as it lies.
    pub fn is_read_in_place(self) -> bool {
        !matches!(self, Self::U8 | Self::I8 | Self::U32)
    }

    /// Converts samples that lie `step` bytes apart, the first at byte 0, until `decoded` is full.
    ///
    /// # Panics
    /// Where `stored` is too short.
    pub fn convert(
        self,
        stored: &[u8],
        step: usize,
        from: ByteOrder,
        decoded: &mut [u8],
        to: ByteOrder,
    ) {
        let size = self.bytes();
        match self {
            Self::U8 => {
                each(stored, step, decoded, |[byte]| ordered(i16::from(byte).to_be_bytes(), to))
            }
            Self::I8 => each(stored, step, decoded, |[byte]| {
                ordered(i16::from(byte as i8).to_be_bytes(), to)
            }),
            Self::U32 => each(stored, step, decoded, |bytes| {
                ordered(f64::from(u32::from_be_bytes(ordered(bytes, from))).to_be_bytes(), to)
            }),
            _ if from == to && step == size => {
                let length = decoded.len();
                decoded.copy_from_slice(&stored[..length]);
            }
            _ if size == 2 => {
                each(stored, step, decoded, |bytes: [u8; 2]| turned(bytes, from != to))
            }
            _ if size == 4 => {
                each(stored, step, decoded, |bytes: [u8; 4]| turned(bytes, from != to))
            }
            _ => each(stored, step, decoded, |bytes: [u8; 8]| turned(bytes, from != to)),
        }
    }

    /// One value as a sample of [`Self::decoded`]; what the format does not hold becomes its nearest.
    pub fn decoded_value(self, value: f64, to: ByteOrder) -> Vec<u8> {
        match self.decoded() {
            SampleType::I16 => ordered((value as i16).to_be_bytes(), to).to_vec(),
            SampleType::U16 => ordered((value as u16).to_be_bytes(), to).to_vec(),
            SampleType::I32 => ordered((value as i32).to_be_bytes(), to).to_vec(),
            SampleType::F32 => ordered((value as f32).to_be_bytes(), to).to_vec(),
            SampleType::F64 => ordered(value.to_be_bytes(), to).to_vec(),
        }
    }
}

fn each<const FROM: usize, const TO: usize>(
    stored: &[u8],
    step: usize,
    decoded: &mut [u8],
    convert: impl Fn([u8; FROM]) -> [u8; TO],
) {
    for (index, place) in decoded.chunks_exact_mut(TO).enumerate() {
        let mut bytes = [0; FROM];
        bytes.copy_from_slice(&stored[index * step..][..FROM]);
        place.copy_from_slice(&convert(bytes));
    }
}

/// Bytes between big-endian and another order, which is the same both ways.
fn ordered<const SIZE: usize>(bytes: [u8; SIZE], order: ByteOrder) -> [u8; SIZE] {
    turned(bytes, order == ByteOrder::Little)
}

fn turned<const SIZE: usize>(mut bytes: [u8; SIZE], turn: bool) -> [u8; SIZE] {
    if turn {
        bytes.reverse();
    }
    bytes
}
