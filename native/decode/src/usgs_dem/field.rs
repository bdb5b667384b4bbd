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
    let mut bytes = field.iter().copied();
    let mut next = bytes.next();
    while next == Some(b' ') {
        next = bytes.next();
    }
    let is_negative = next == Some(b'-');
    if is_negative || next == Some(b'+') {
        next = bytes.next();
    }
    let mut number = match next {
        Some(digit @ b'0'..=b'9') => i32::from(digit - b'0'),
        None | Some(b'\r' | b'\n') if !is_negative => return Whole::Blank,
        _ => return Whole::Wrong,
    };
    for byte in bytes.by_ref() {
        match byte {
            b'0'..=b'9' => {
                number = number.wrapping_mul(10).wrapping_add(i32::from(byte - b'0'));
            }
            b'\r' | b'\n' => break,
            b' ' => {
                let rest_is_blank =
                    bytes.all(|byte| byte == b' ' || byte == b'\r' || byte == b'\n');
                return if rest_is_blank {
                    Whole::Number(signed(number, is_negative))
                } else {
                    Whole::Wrong
                };
            }
            _ => return Whole::Wrong,
        }
    }
    Whole::Number(signed(number, is_negative))
}

fn signed(number: i32, is_negative: bool) -> i32 {
    if is_negative { -number } else { number }
}

/// Reads a field of real numbers; the exponent is written with D or E. `None` where it is blank, the
/// field's text where it is no finite number.
pub fn real(field: &[u8]) -> Result<Option<f64>, String> {
    let text = String::from_utf8_lossy(field);
    let text = text.trim();
    if text.is_empty() {
        return Ok(None);
    }
    let written = text.replace(['D', 'd'], "E");
    match written.parse::<f64>() {
        // Rust's own words for infinity and NaN are finite in no header.
        Ok(number) if number.is_finite() => Ok(Some(number)),
        _ => Err(text.to_owned()),
    }
}

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
