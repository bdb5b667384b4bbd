//! Numbers in columns of fixed width, as FORTRAN writes them.

/// What a field of whole numbers (`I6`) holds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Whole {
    /// Nothing but blanks, or the line ended before.
    Blank,
    /// A number.
    Number(i32),
    /// Something else.
    Wrong,
}

/// Reads a field of whole numbers; what follows a line end in it does not belong to it.
#[inline]
pub fn whole(field: &[u8]) -> Whole {
    match <[u8; 6]>::try_from(field).ok().and_then(six_columns) {
        Some(number) => Whole::Number(number),
        None => any_whole(field),
    }
}

/// The quick way for nearly every height: blanks, then digits to the last of six columns. Works on all
/// columns at once, as bytes of one word; `None` for everything else.
#[inline]
fn six_columns([a, b, c, d, e, f]: [u8; 6]) -> Option<i32> {
    const EACH: u64 = 0x0101_0101_0101_0101;
    // Two columns of zeros in front; the first column is in the lowest byte.
    let (first_four, last_two) = (u32::from_le_bytes([a, b, c, d]), u16::from_le_bytes([e, f]));
    let zeros = u64::from(u16::from_le_bytes([b'0', b'0']));
    let columns = zeros | u64::from(first_four) << 16 | u64::from(last_two) << 48;
    // Of the letters that count, only blanks lack this bit.
    let is_blank = (!columns >> 4) & EACH;
    let blanks = is_blank * 0xff;
    let digits = columns | (is_blank << 4);
    // A byte above '9' or below '0' carries into, or borrows, its highest bit.
    let odd = (digits.wrapping_add(EACH * 0x46) | digits.wrapping_sub(EACH * 0x30)) & (EACH * 0x80);
    let are_true_blanks = (columns ^ (EACH * 0x20)) & blanks == 0;
    // With the zeros in front taken for blanks, no blank may follow a digit, and a digit comes last.
    let leading = blanks | 0xffff;
    if odd != 0 || !are_true_blanks || leading & leading.wrapping_add(1) != 0 || leading == u64::MAX
    {
        return None;
    }
    // Pairs of digits, then pairs of pairs, then both halves.
    let pairs = (digits & (EACH * 0x0f)).wrapping_mul(10 * 256 + 1) >> 8;
    let fours = (pairs & 0x00ff_00ff_00ff_00ff).wrapping_mul(100 * 65_536 + 1) >> 16;
    let eight = (fours & 0x0000_ffff_0000_ffff).wrapping_mul(10_000 * (1 << 32) + 1) >> 32;
    Some(eight as i32)
}

/// Digits anywhere in the field, with a sign or none.
fn any_whole(field: &[u8]) -> Whole {
    let mut place = 0;
    while place < field.len() && field[place] == b' ' {
        place += 1;
    }
    let sign = field.get(place).copied();
    if matches!(sign, None | Some(b'\r' | b'\n')) {
        return Whole::Blank;
    }
    place += usize::from(matches!(sign, Some(b'-' | b'+')));
    let first = place;
    let mut number = 0_i32;
    while place < field.len() && field[place].is_ascii_digit() {
        number = number.wrapping_mul(10).wrapping_add(i32::from(field[place] - b'0'));
        place += 1;
    }
    if place == first || !is_blank(&field[place..]) {
        return Whole::Wrong;
    }
    Whole::Number(signed(number, sign == Some(b'-')))
}

/// Whether nothing stands there, before the line ends.
#[inline]
fn is_blank(rest: &[u8]) -> bool {
    let line = rest.iter().take_while(|byte| !matches!(byte, b'\r' | b'\n'));
    line.copied().all(|byte| byte == b' ')
}

fn signed(number: i32, is_negative: bool) -> i32 {
    if is_negative { -number } else { number }
}

/// Reads a field of real numbers; the exponent is written with D or E. `None` where it is blank, the
/// field's text where it is no finite number.
pub fn real(field: &[u8]) -> Result<Option<f64>, String> {
    let text = field.trim_ascii();
    if text.is_empty() {
        return Ok(None);
    }
    let mut written = [0; LONGEST_REAL];
    let written = match written.get_mut(..text.len()) {
        Some(place) => place,
        None => return Err(String::from_utf8_lossy(text).into_owned()),
    };
    for (place, byte) in written.iter_mut().zip(text) {
        *place = if matches!(byte, b'D' | b'd') { b'E' } else { *byte };
    }
    match std::str::from_utf8(written).ok().and_then(|text| text.parse::<f64>().ok()) {
        // Rust reads words for infinity and NaN too.
        Some(number) if number.is_finite() => Ok(Some(number)),
        _ => Err(String::from_utf8_lossy(text).into_owned()),
    }
}

/// Columns of a real number at the most.
const LONGEST_REAL: usize = 24;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn whole_numbers_fill_their_columns_or_not() {
        assert_eq!(whole(b"   682"), Whole::Number(682));
        assert_eq!(whole(b"-32767"), Whole::Number(-32767));
        assert_eq!(whole(b"+12   "), Whole::Number(12));
        assert_eq!(whole(b"999999"), Whole::Number(999_999));
        assert_eq!(whole(b"      "), Whole::Blank);
        assert_eq!(whole(b""), Whole::Blank);
        assert_eq!(whole(b"  \n 12"), Whole::Blank);
        assert_eq!(whole(b"  12\r\n"), Whole::Number(12));
        for wrong in [&b" 12 4 "[..], b"  1.5 ", b"   abc", b"     -", b"-\n    ", b"******"] {
            assert_eq!(whole(wrong), Whole::Wrong, "{wrong:?}");
        }
    }

    #[test]
    fn the_quick_way_agrees_with_the_slow_one() {
        let letters = b" 019-+\n\rA!/:\x00\xff";
        let mut index = [0_usize; 6];
        loop {
            let field = index.map(|index| letters[index]);
            match six_columns(field) {
                Some(number) => assert_eq!(any_whole(&field), Whole::Number(number), "{field:?}"),
                None => {
                    let text = field.trim_ascii_start();
                    let are_digits = !text.is_empty() && text.iter().all(u8::is_ascii_digit);
                    assert!(
                        !are_digits || field.contains(&b'\n') || field.contains(&b'\r'),
                        "{field:?}"
                    );
                }
            }
            let Some(place) = index.iter().position(|index| index + 1 < letters.len()) else {
                break;
            };
            index[place] += 1;
            index[..place].fill(0);
        }
        for number in [0, 7, 123, 99_999, 123_456, 999_999] {
            let text = format!("{number:6}");
            assert_eq!(six_columns(text.as_bytes().try_into().unwrap()), Some(number));
        }
    }

    #[test]
    fn exponents_are_written_with_d_or_e() {
        assert_eq!(real(b"   0.557820000000000D+06"), Ok(Some(557_820.0)));
        assert_eq!(real(b"0.300000E+02"), Ok(Some(30.0)));
        assert_eq!(real(b"  -0.439200000000000d+06"), Ok(Some(-439_200.0)));
        assert_eq!(real(b"            "), Ok(None));
        for wrong in ["NaN", "inf", "1D999", "1 2", "x"] {
            assert_eq!(real(wrong.as_bytes()), Err(wrong.to_owned()));
        }
    }
}
