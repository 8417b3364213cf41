//! Parsing and printing of `DoubleDouble` in decimal notation.

use super::DoubleDouble;
use core::fmt;
use core::fmt::{Display, Formatter, Write};

/// Exponent of 10⁴⁵, the largest power of ten that two f64 hold exactly.
const LARGEST_EXACT_POWER: i32 = 45;
/// Number of decimal digits that are read; a u128 can hold 38 digits.
const DIGITS_READ: u32 = 38;
/// Largest absolute exponent of ten that is used. It is beyond the exponents of f64, with room for
/// the digits.
const EXPONENT_LIMIT: i32 = 800;

/// Parses a number in any notation that f64 accepts; "not a number" if `text` has another form.
pub(super) fn parsed(text: &str) -> DoubleDouble {
    // The f64 parser decides if the text is a number, and if it is within range.
    let nearest: f64 = text.parse().unwrap_or(f64::NAN);
    if nearest == 0.0 || !nearest.is_finite() {
        return nearest.into();
    }
    let (mantissa, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
    let (digits, places) = leading_digits(mantissa);
    // An exponent out of range of i32 would have made 0 or infinity.
    let exponent: i32 = exponent.parse().unwrap_or(0);
    let size = times_power_of_ten(DoubleDouble::whole(digits), exponent.saturating_sub(places));
    if nearest < 0.0 { -size } else { size }
}

/// Reads the first 38 digits of a mantissa such as "-12.345" as a whole number without sign. Also
/// returns the power of ten by which to divide it.
fn leading_digits(mantissa: &str) -> (i128, i32) {
    let (mut digits, mut taken, mut places, mut after_point) = (0_i128, 0, 0_i32, false);
    for character in mantissa.chars() {
        let Some(digit) = character.to_digit(10) else {
            after_point |= character == '.';
            continue;
        };
        if taken < DIGITS_READ {
            digits = 10 * digits + i128::from(digit);
            taken += u32::from(digits > 0); // leading zeros are free
            places = places.saturating_add(i32::from(after_point));
        } else {
            places = places.saturating_sub(i32::from(!after_point));
        }
    }
    (digits, places)
}

/// Computes x 10ⁿ, with a rounding for each 45 powers of ten.
fn times_power_of_ten(x: DoubleDouble, n: i32) -> DoubleDouble {
    let n = n.clamp(-EXPONENT_LIMIT, EXPONENT_LIMIT);
    let mut left = n.abs();
    let mut result = x;
    while left > 0 {
        let step = left.min(LARGEST_EXACT_POWER);
        let power = power_of_ten(step);
        result = if n > 0 { result * power } else { result / power };
        left -= step;
    }
    result
}

/// Power 10ⁿ for 0 ≤ n ≤ 45, exactly.
fn power_of_ten(n: i32) -> DoubleDouble {
    let mut power = DoubleDouble::ONE;
    for _ in 0..n {
        power = power.times(10.0);
    }
    power
}

/// Prints scientific notation with 32 digits. A format precision sets the number of digits after
/// the point, at most 32.
impl Display for DoubleDouble {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        if self.hi == 0.0 || !self.is_finite() {
            return Display::fmt(&self.hi, f);
        }
        let places = f.precision().unwrap_or(31).min(32);
        let (digits, exponent) = rounded_digits(*self, places + 1);
        if self.hi < 0.0 {
            f.write_char('-')?;
        } else if f.sign_plus() {
            f.write_char('+')?;
        }
        for (place, &digit) in digits[..=places].iter().enumerate() {
            if place == 1 {
                f.write_char('.')?;
            }
            f.write_char(char::from(b'0' + digit))?;
        }
        write!(f, "e{exponent}")
    }
}

/// Rounds |x| ≈ d₀.d₁d₂… 10ᵉ to `count` ≤ 33 digits, and returns (d, e). All later digits are 0.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "exponents of f64, digits 0 to 9")]
fn rounded_digits(x: DoubleDouble, count: usize) -> ([u8; 34], i32) {
    let size = if x.hi < 0.0 { -x } else { x };
    let mut exponent = libm::floor(libm::log10(size.hi)) as i32;
    let mut rest = times_power_of_ten(size, -exponent);
    // The logarithm is rounded, and so is the quotient.
    if rest >= DoubleDouble::from(10.0) {
        (exponent, rest) = (exponent + 1, rest / DoubleDouble::from(10.0));
    } else if rest < DoubleDouble::ONE {
        (exponent, rest) = (exponent - 1, rest.times(10.0));
    }
    let mut digits = [0_u8; 34];
    for digit in &mut digits[..=count] {
        *digit = whole_part(rest);
        rest = rest.plus(-f64::from(*digit)).times(10.0);
    }
    let carried = round_last(&mut digits, count);
    (digits, exponent + i32::from(carried))
}

/// Whole part ⌊x⌋ for 0 ≤ x < 10, limited to 0…9 even if rounding moved x out of this range.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to 0…9")]
#[allow(clippy::float_cmp, reason = "asks whether hi is a whole number")]
fn whole_part(x: DoubleDouble) -> u8 {
    let floor = libm::floor(x.hi);
    // If hi is a whole number, a negative lo puts x below it.
    let below = floor == x.hi && x.lo < 0.0;
    (if below { floor - 1.0 } else { floor }).clamp(0.0, 9.0) as u8
}

/// Rounds the digits before index `count` by the digit at `count`, which becomes 0. True if a carry
/// out of the first digit made the number 10.
fn round_last(digits: &mut [u8; 34], count: usize) -> bool {
    let up = digits[count] >= 5;
    digits[count] = 0;
    if !up {
        return false;
    }
    for digit in digits[..count].iter_mut().rev() {
        if *digit < 9 {
            *digit += 1;
            return false;
        }
        *digit = 0;
    }
    digits[0] = 1;
    true
}
