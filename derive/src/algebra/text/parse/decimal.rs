//! Parsing of decimal numbers: `12`, `0.5`, `1.5e-3`.

use super::error::{ParseError, error};
use crate::algebra::Rational;

/// Largest number of digits, with the decimal point, of a written number.
const MAX_DIGITS: usize = 4000;

/// Reads the decimal number that begins at byte `start`. Returns its exact value and the byte where
/// it ends. Error if it is not a number or is too long.
pub(super) fn decimal(text: &str, start: usize) -> Result<(Rational, usize), ParseError> {
    let bytes = text.as_bytes();
    let digits = |mut at: usize| {
        while bytes.get(at).is_some_and(|b| b.is_ascii_digit() || *b == b'.') {
            at += 1;
        }
        at
    };
    let mut end = digits(start);
    if end - start > MAX_DIGITS {
        let message = format!("a number of more than {MAX_DIGITS} digits");
        return Err(error(start..end, message, Some("round it")));
    }
    if matches!(bytes.get(end), Some(b'e' | b'E')) {
        let sign = usize::from(matches!(bytes.get(end + 1), Some(b'+' | b'-')));
        let exponent = digits(end + 1 + sign);
        if exponent > end + 1 + sign {
            end = exponent;
        }
    }
    let value = Rational::parse_decimal(&text[start..end]).ok_or_else(|| {
        let message = format!("`{}` is not a number", &text[start..end.min(start + 60)]);
        error(start..end, message, Some("write 12, 0.5 or 1.5e-3; exponents reach to ±4000"))
    })?;
    Ok((value, end))
}
