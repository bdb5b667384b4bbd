//! The number formats a sample may have, and how each is read from raw bytes.

/// The type of one sample.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SampleType {
    /// Signed 16 bit, as in MOLA MEGDR, GTOPO30 and SRTM.
    I16,
    /// Unsigned 16 bit.
    U16,
    /// Signed 32 bit.
    I32,
    /// IEEE single precision.
    F32,
    /// IEEE double precision.
    F64,
}

impl SampleType {
    /// Bytes of one sample.
    pub fn bytes(self) -> usize {
        match self {
            Self::I16 | Self::U16 => 2,
            Self::I32 | Self::F32 => 4,
            Self::F64 => 8,
        }
    }
}

/// The order of the bytes in a sample.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ByteOrder {
    /// Most significant byte first.
    Big,
    /// Least significant byte first.
    Little,
}

/// Reads one sample; a type for each format, so that the reading is compiled into the contact
/// models' inner loops.
pub trait Sample: Copy + Send + Sync + 'static {
    /// Bytes of one sample.
    const BYTES: usize;

    /// Whether every sample is a whole number: then none is NaN or infinite.
    const IS_INTEGER: bool;

    /// The sample at `address` as a double (exact for every format).
    ///
    /// # Safety
    /// `address` must be readable for [`Self::BYTES`] bytes; it need not be aligned. The bytes may
    /// change meanwhile: any bit pattern is a valid sample.
    unsafe fn read(address: *const u8) -> f64;
}

/// The readers, one for each sample type and byte order.
pub mod readers {
    use super::Sample;

    macro_rules! reader {
        ($name:ident, $number:ty, $from_bytes:ident, $is_integer:literal, $what:literal) => {
            #[doc = $what]
            #[derive(Clone, Copy, Debug)]
            pub struct $name;

            impl Sample for $name {
                const BYTES: usize = size_of::<$number>();
                const IS_INTEGER: bool = $is_integer;

                #[inline(always)]
                unsafe fn read(address: *const u8) -> f64 {
                    // SAFETY: the caller promises that the bytes are readable; byte arrays have
                    // no alignment and no invalid patterns.
                    let bytes = unsafe { address.cast::<[u8; Self::BYTES]>().read() };
                    <$number>::$from_bytes(bytes) as f64
                }
            }
        };
    }

    reader!(I16Big, i16, from_be_bytes, true, "Signed 16 bit, big-endian.");
    reader!(I16Little, i16, from_le_bytes, true, "Signed 16 bit, little-endian.");
    reader!(U16Big, u16, from_be_bytes, true, "Unsigned 16 bit, big-endian.");
    reader!(U16Little, u16, from_le_bytes, true, "Unsigned 16 bit, little-endian.");
    reader!(I32Big, i32, from_be_bytes, true, "Signed 32 bit, big-endian.");
    reader!(I32Little, i32, from_le_bytes, true, "Signed 32 bit, little-endian.");
    reader!(F32Big, f32, from_be_bytes, false, "Single precision, big-endian.");
    reader!(F32Little, f32, from_le_bytes, false, "Single precision, little-endian.");
    reader!(F64Big, f64, from_be_bytes, false, "Double precision, big-endian.");
    reader!(F64Little, f64, from_le_bytes, false, "Double precision, little-endian.");
}

#[cfg(test)]
mod tests {
    use super::{Sample, readers::*};

    fn read<S: Sample>(bytes: &[u8]) -> f64 {
        assert_eq!(bytes.len(), S::BYTES);
        // SAFETY: the slice is as long as the sample.
        unsafe { S::read(bytes.as_ptr()) }
    }

    #[test]
    fn every_format_reads_its_extremes() {
        assert_eq!(read::<I16Big>(&[0x80, 0x00]), -32768.0);
        assert_eq!(read::<I16Little>(&[0x00, 0x80]), -32768.0);
        assert_eq!(read::<U16Big>(&[0xff, 0xfe]), 65534.0);
        assert_eq!(read::<U16Little>(&[0xff, 0xfe]), 65279.0);
        assert_eq!(read::<I32Big>(&i32::MIN.to_be_bytes()), -2147483648.0);
        assert_eq!(read::<I32Little>(&i32::MAX.to_le_bytes()), 2147483647.0);
        assert_eq!(read::<F32Big>(&1.5f32.to_be_bytes()), 1.5);
        assert_eq!(read::<F32Little>(&(-1e30f32).to_le_bytes()), f64::from(-1e30f32));
        assert_eq!(read::<F64Big>(&1e300f64.to_be_bytes()), 1e300);
        assert!(read::<F64Little>(&f64::NAN.to_le_bytes()).is_nan());
    }
}
