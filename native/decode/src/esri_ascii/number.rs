//! Numbers as text.

/// Reads a number; `None` where the word is none. `nan` and `inf` are numbers here, as other programs
/// write them for "no data"; so are hexadecimal floats to none of them.
#[inline]
pub fn number(word: &[u8]) -> Option<f64> {
    short_whole(word).or_else(|| any(word))
}

/// The quick way for what most grids hold: whole numbers of up to nine digits.
#[inline]
fn short_whole(word: &[u8]) -> Option<f64> {
    let (is_negative, digits) = match word {
        [b'-', digits @ ..] => (true, digits),
        digits => (false, digits),
    };
    if digits.is_empty() || digits.len() > 9 {
        return None;
    }
    let mut number = 0_u32;
    for byte in digits {
        let digit = byte.wrapping_sub(b'0');
        if digit > 9 {
            return None;
        }
        number = number * 10 + u32::from(digit);
    }
    let number = f64::from(number);
    Some(if is_negative { 0.0 - number } else { number })
}

/// Every other number. The standard library's conversion is exact and quick (Lemire, "Number parsing at
/// a gigabyte per second", 2021).
fn any(word: &[u8]) -> Option<f64> {
    std::str::from_utf8(word).ok()?.parse().ok()
}

#[cfg(test)]
mod tests {
    use super::number;

    #[test]
    fn numbers_of_every_kind() {
        for (word, value) in [
            ("0", 0.0),
            ("-9999", -9999.0),
            ("+12", 12.0),
            ("123456789", 123_456_789.0),
            ("1234567890123", 1_234_567_890_123.0),
            ("12.5", 12.5),
            ("-0.1", -0.1),
            (".5", 0.5),
            ("5.", 5.0),
            ("1e3", 1000.0),
            ("-3.4028234663852886e+38", f64::from(f32::MIN)),
        ] {
            assert_eq!(number(word.as_bytes()), Some(value), "{word}");
        }
        assert!(number(b"nan").unwrap().is_nan());
        assert!(number(b"-NaN").unwrap().is_nan());
        assert_eq!(number(b"inf"), Some(f64::INFINITY));
        for word in ["", "-", "12,5", "0x10", "1 2", "--1", "1e", "abc", "1_000"] {
            assert_eq!(number(word.as_bytes()), None, "{word}");
        }
        assert_eq!(number(b"\xff"), None);
    }
}
