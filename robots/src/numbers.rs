//! Numbers and angles as a person writes them.

use std::f64::consts::PI;

/// Part of the largest number of a group below which a number is rounding of the reader's own arithmetic.
const ROUNDING: f64 = 1e-15;

/// Bound of the whole numbers of TOML, 2^63.
const LARGEST_WHOLE: f64 = 9_223_372_036_854_775_808.0;

/// Number with as few digits as identify it, or with fifteen if these differ from it by rounding alone.
pub fn number_text(value: f64) -> String {
    let value = if value == 0.0 { 0.0 } else { value };
    let short: f64 = format!("{value:.14e}").parse().unwrap_or(value);
    let value = if (short - value).abs() <= 2.0 * f64::EPSILON * value.abs() { short } else { value };
    exact_number_text(value)
}

/// Number with as few digits as identify it, as plain decimals or with an exponent, whichever is shorter.
pub fn exact_number_text(value: f64) -> String {
    let value = if value == 0.0 { 0.0 } else { value };
    let (plain, short) = (format!("{value}"), format!("{value:e}"));
    // TOML has no whole number from 2^63 on.
    let is_whole = value.abs() >= LARGEST_WHOLE;
    if plain.len() <= short.len() + 4 && !is_whole { plain } else { short }
}

/// Numbers of a group; those that rounding alone leaves are exactly 0.
pub fn without_rounding<const N: usize>(values: [f64; N], scale: f64) -> [f64; N] {
    let size = values.iter().fold(scale, |size, value| size.max(value.abs()));
    values.map(|value| if value.abs() <= ROUNDING * size { 0.0 } else { value })
}

/// Multiple of a twelfth of π whose printed digits, at least four after the point, are those of an angle in rad, with
/// its formula. `None` if there is none, or if it is 0.
pub fn rounded_multiple(angle: f64) -> Option<(f64, String)> {
    let digits = format!("{angle}").split_once('.').map_or(0, |(_, decimals)| decimals.len());
    let last_digit = 10_f64.powi(-i32::try_from(digits.min(300)).unwrap_or(300));
    multiple_within(angle, last_digit).filter(|_| digits >= 4)
}

/// Formula for an angle in rad that is a multiple of a twelfth of π but for rounding. `None` for other angles.
pub fn angle_text(angle: f64) -> Option<String> {
    multiple_within(angle, 1e-15).map(|(_, text)| text)
}

/// Multiple of a twelfth of π, other than 0, that differs from an angle by at most `distance` and rounding, with its
/// formula.
fn multiple_within(angle: f64, distance: f64) -> Option<(f64, String)> {
    let twelfths = (angle / (PI / 12.0)).round();
    let multiple = twelfths * PI / 12.0;
    if twelfths == 0.0 || (angle - multiple).abs() > distance + 4e-16 * multiple.abs() {
        return None;
    }
    let (mut top, mut bottom) = (twelfths.abs(), 12.0);
    for factor in [2.0, 2.0, 3.0] {
        if top % factor == 0.0 && bottom % factor == 0.0 {
            (top, bottom) = (top / factor, bottom / factor);
        }
    }
    let sign = if twelfths < 0.0 { "-" } else { "" };
    let factor = if top - 1.0 == 0.0 { String::new() } else { format!("{top}*") };
    let divisor = if bottom - 1.0 == 0.0 { String::new() } else { format!("/{bottom}") };
    Some((multiple, format!("{sign}{factor}pi{divisor}")))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_beyond_the_whole_numbers_of_toml_have_an_exponent() {
        for (value, text) in [(2000.0, "2000"), (9_268_634_660_533_830_000.0, "9.26863466053383e18"), (-1e19, "-1e19")]
        {
            assert_eq!(number_text(value), text);
            assert!(toml::from_str::<toml::Table>(&format!("x = {text}")).is_ok(), "{text}");
        }
    }
}
