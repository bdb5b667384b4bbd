//! Numbers as text.

/// Powers of ten that doubles have exactly.
const POWERS: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16,
    1e17, 1e18, 1e19, 1e20, 1e21, 1e22,
];

/// Digits that 64 bits take, whatever they are.
const MOST_DIGITS: usize = 19;

/// Whole numbers up to it are doubles exactly.
const EXACT: u64 = 1 << 53;

/// Reads the number of a word: of the whole word, or it is none (`None`). `nan` and `inf` are numbers here,
/// as other programs write them for "no data".
///
/// The standard library's conversion is exact.
pub fn number(word: &[u8]) -> Option<f64> {
    std::str::from_utf8(word).ok()?.parse().ok()
}

/// The quick way for what grids hold: a sign, digits, a decimal point, digits. Gives the number at the
/// beginning of `bytes` and its length; `None` where the long way must be gone.
///
/// Digits that a double has exactly, divided by a power of ten that it has exactly, are rounded once,
/// and so rightly: W. D. Clinger, "How to read floating point numbers accurately" (1990).
#[inline(always)]
pub fn plain_number(bytes: &[u8]) -> Option<(f64, usize)> {
    let is_negative = *bytes.first()? == b'-';
    let start = usize::from(is_negative);
    let (whole, mut end) = digits(bytes, start, 0);
    let (mut value, mut count, mut power) = (whole, end - start, 0);
    if bytes.get(end) == Some(&b'.') {
        let first = end + 1;
        (value, end) = digits(bytes, first, value);
        power = end - first;
        count += power;
    }
    let is_over = bytes.get(end).is_none_or(|byte| *byte <= b' ');
    if !is_over || count == 0 || count > MOST_DIGITS || value > EXACT {
        return None;
    }
    let number = value as f64 / POWERS[power];
    Some((if is_negative { -number } else { number }, end))
}

/// Takes digits from `place` on behind those of `value`: the value, and where they end. More than
/// [`MOST_DIGITS`] of them make a value that means nothing.
#[inline(always)]
fn digits(bytes: &[u8], mut place: usize, mut value: u64) -> (u64, usize) {
    while let Some(byte) = bytes.get(place)
        && byte.is_ascii_digit()
    {
        value = value.wrapping_mul(10).wrapping_add(u64::from(byte - b'0'));
        place += 1;
    }
    (value, place)
}

#[cfg(test)]
mod tests {
    use super::{number, plain_number};

    #[test]
    fn numbers_of_every_kind() {
        for (word, value) in [
            ("0", 0.0),
            ("-9999", -9999.0),
            ("+12", 12.0),
            ("12.5", 12.5),
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

    #[test]
    fn the_quick_way_agrees_with_the_exact_one_to_the_last_bit() {
        let mut state = 1_u64;
        for round in 0..200_000 {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            let (decimals, places) = ((state >> 60) as usize, (state >> 55) % 18);
            let whole = (state >> 11) / 10_u64.pow(places as u32);
            let sign = if round % 2 == 0 { "-" } else { "" };
            let word =
                format!("{sign}{}.{:0decimals$}", whole / 7, state % 10_u64.pow(decimals as u32));
            if let Some((value, length)) = plain_number(word.as_bytes()) {
                assert_eq!(length, word.len(), "{word}");
                assert_eq!(value.to_bits(), number(word.as_bytes()).unwrap().to_bits(), "{word}");
            }
        }
    }

    #[test]
    fn the_quick_way_leaves_all_else_to_the_other() {
        assert_eq!(plain_number(b"-12.25 7"), Some((-12.25, 6)));
        assert_eq!(plain_number(b"7\n"), Some((7.0, 1)));
        assert_eq!(plain_number(b".5"), Some((0.5, 2)));
        for word in [
            "",
            "-",
            ".",
            "-.",
            "+1",
            "1e5",
            "nan",
            "1,5",
            "1.2.3",
            "12345678901234567890",
            "9007199254740993",
        ] {
            assert_eq!(plain_number(word.as_bytes()), None, "{word}");
        }
    }
}
