//! Writing numbers as samples.

use surface::{ByteOrder, GridLayout, SampleType};

/// Writes numbers in a layout's sample type and byte order.
#[derive(Clone, Copy)]
pub struct Pen {
    sample: SampleType,
    order: ByteOrder,
}

impl Pen {
    /// For samples of this layout.
    pub fn of(layout: &GridLayout) -> Self {
        Self { sample: layout.sample(), order: layout.byte_order() }
    }

    /// Bytes of a sample.
    pub fn bytes(&self) -> usize {
        self.sample.bytes()
    }

    /// Writes sample `index` of a row; a number that the type has not becomes the nearest that it has.
    #[inline(always)]
    pub fn put(&self, row: &mut [u8], index: usize, number: f64) {
        let place = &mut row[index * self.bytes()..][..self.bytes()];
        match (self.sample, self.order) {
            (SampleType::I16, ByteOrder::Big) => {
                place.copy_from_slice(&(number as i16).to_be_bytes());
            }
            (SampleType::I16, ByteOrder::Little) => {
                place.copy_from_slice(&(number as i16).to_le_bytes());
            }
            (SampleType::U16, ByteOrder::Big) => {
                place.copy_from_slice(&(number as u16).to_be_bytes());
            }
            (SampleType::U16, ByteOrder::Little) => {
                place.copy_from_slice(&(number as u16).to_le_bytes());
            }
            (SampleType::I32, ByteOrder::Big) => {
                place.copy_from_slice(&(number as i32).to_be_bytes());
            }
            (SampleType::I32, ByteOrder::Little) => {
                place.copy_from_slice(&(number as i32).to_le_bytes());
            }
            (SampleType::F32, ByteOrder::Big) => {
                place.copy_from_slice(&(number as f32).to_be_bytes());
            }
            (SampleType::F32, ByteOrder::Little) => {
                place.copy_from_slice(&(number as f32).to_le_bytes());
            }
            (SampleType::F64, ByteOrder::Big) => place.copy_from_slice(&number.to_be_bytes()),
            (SampleType::F64, ByteOrder::Little) => place.copy_from_slice(&number.to_le_bytes()),
        }
    }

    /// Writes sample `index` of a row; quicker where it is of 16 bits, whose number must fit.
    #[inline(always)]
    pub fn put_whole(&self, row: &mut [u8], index: usize, number: i32) {
        let bytes = match (self.sample, self.order) {
            (SampleType::I16, ByteOrder::Big) => (number as i16).to_be_bytes(),
            (SampleType::I16, ByteOrder::Little) => (number as i16).to_le_bytes(),
            _ => return self.put(row, index, number.into()),
        };
        row[2 * index..][..2].copy_from_slice(&bytes);
    }

    /// Writes the same number into every sample of a row.
    pub fn fill(&self, row: &mut [u8], number: f64) {
        if row.is_empty() {
            return;
        }
        let size = self.bytes();
        self.put(row, 0, number);
        let (first, others) = row.split_at_mut(size);
        for place in others.chunks_exact_mut(size) {
            place.copy_from_slice(first);
        }
    }
}
