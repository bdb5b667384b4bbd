//! What was done to a row of samples before it was packed, and how it is undone.

use super::sample::StoredSample;
use crate::error::DecodeError;
use surface::ByteOrder;

/// By the numbers of the Predictor tag.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Predictor {
    /// 1: nothing.
    None,
    /// 2: each sample became its difference from the one before (TIFF 6.0, section 14).
    Horizontal,
    /// 3: the bytes of floating point samples were sorted by their weight, the highest first, and then
    /// each became its difference from the one before (Technical Note 3).
    FloatingPoint,
}

impl Predictor {
    /// The predictor of a number in the file, for samples of that format.
    pub fn of(code: u64, stored: StoredSample) -> Result<Self, DecodeError> {
        match code {
            1 => Ok(Self::None),
            2 => Ok(Self::Horizontal),
            3 if stored.is_float() => Ok(Self::FloatingPoint),
            3 => Err(DecodeError::wrong(
                "Predictor",
                format!("3 (floating point) for samples of type {}", stored.name()),
                "1 or 2 for whole numbers",
            )),
            _ => Err(DecodeError::wrong("Predictor", code, "1, 2 or 3")),
        }
    }

    /// The number in the file.
    pub fn code(self) -> u8 {
        match self {
            Self::None => 1,
            Self::Horizontal => 2,
            Self::FloatingPoint => 3,
        }
    }

    /// Brings a row back; other bands than the first may stay as they are.
    ///
    /// Gives the order of the bytes in the samples that `row` holds then.
    pub fn undo(self, row: &mut Vec<u8>, spare: &mut Vec<u8>, shape: RowShape) -> ByteOrder {
        match self {
            Self::None => shape.byte_order,
            Self::Horizontal => {
                add_up(row, shape);
                shape.byte_order
            }
            Self::FloatingPoint => {
                bring_together(row, spare, shape);
                std::mem::swap(row, spare);
                ByteOrder::Big
            }
        }
    }
}

/// How the samples lie in a row.
#[derive(Clone, Copy, Debug)]
pub struct RowShape {
    /// The number format.
    pub stored: StoredSample,
    /// Values side by side for each place.
    pub bands: usize,
    /// Of each sample in the file.
    pub byte_order: ByteOrder,
}

fn add_up(row: &mut [u8], shape: RowShape) {
    let step = shape.bands * shape.stored.bytes();
    match (shape.stored.bytes(), shape.byte_order) {
        (1, _) => sum(row, step, |[byte]| byte.into(), |sum| [sum as u8]),
        (2, ByteOrder::Little) => sum(
            row,
            step,
            |bytes| u16::from_le_bytes(bytes).into(),
            |sum| (sum as u16).to_le_bytes(),
        ),
        (2, ByteOrder::Big) => sum(
            row,
            step,
            |bytes| u16::from_be_bytes(bytes).into(),
            |sum| (sum as u16).to_be_bytes(),
        ),
        (4, ByteOrder::Little) => sum(
            row,
            step,
            |bytes| u32::from_le_bytes(bytes).into(),
            |sum| (sum as u32).to_le_bytes(),
        ),
        (4, ByteOrder::Big) => sum(
            row,
            step,
            |bytes| u32::from_be_bytes(bytes).into(),
            |sum| (sum as u32).to_be_bytes(),
        ),
        (_, ByteOrder::Little) => sum(row, step, u64::from_le_bytes, u64::to_le_bytes),
        (_, ByteOrder::Big) => sum(row, step, u64::from_be_bytes, u64::to_be_bytes),
    }
}

/// Replaces the first band's samples by their running sum; only the sum's lowest bits are kept.
fn sum<const SIZE: usize>(
    row: &mut [u8],
    step: usize,
    number: impl Fn([u8; SIZE]) -> u64,
    bytes: impl Fn(u64) -> [u8; SIZE],
) {
    let mut sum = 0_u64;
    for place in row.chunks_exact_mut(step) {
        let mut sample = [0; SIZE];
        sample.copy_from_slice(&place[..SIZE]);
        sum = sum.wrapping_add(number(sample));
        place[..SIZE].copy_from_slice(&bytes(sum));
    }
}

/// Writes the samples of all bands to `samples`, each with its highest byte first.
fn bring_together(row: &mut [u8], samples: &mut Vec<u8>, shape: RowShape) {
    for index in shape.bands..row.len() {
        row[index] = row[index].wrapping_add(row[index - shape.bands]);
    }
    let size = shape.stored.bytes();
    samples.resize(row.len(), 0);
    let count = row.len() / size;
    for (weight, bytes) in row.chunks_exact(count).enumerate() {
        for (sample, &byte) in samples.chunks_exact_mut(size).zip(bytes) {
            sample[weight] = byte;
        }
    }
}
