//! Maxima that respect NaN ("not a number").
//!
//! `f64::max` ignores an argument that is NaN, so an error without a value would seem to be the
//! smallest of all errors. All decisions use the maxima of this module.

/// Larger of two numbers; NaN if either is NaN, so that no error is hidden.
#[must_use]
pub fn larger(a: f64, b: f64) -> f64 {
    if a.is_nan() || a > b { a } else { b }
}

/// Largest absolute value in a list; NaN if any of the values is NaN; 0 for an empty list.
#[must_use]
pub fn largest(list: impl IntoIterator<Item = f64>) -> f64 {
    list.into_iter().map(f64::abs).fold(0.0, larger)
}

/// Larger of two numbers; the second number if either is NaN. It takes a single instruction, for
/// weights in loops whose values are checked for NaN elsewhere.
#[must_use]
#[inline(always)]
#[expect(clippy::inline_always, reason = "one instruction, also inside code for wider registers")]
pub fn larger_or_second(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_no_number_is_the_largest() {
        for list in [[f64::NAN, 1.0, 2.0], [1.0, f64::NAN, 2.0], [1.0, 2.0, f64::NAN]] {
            assert!(largest(list).is_nan(), "{list:?}");
        }
        assert!(largest([]).abs() < f64::MIN_POSITIVE && largest([1.0, -3.0]).to_bits() == 3.0_f64.to_bits());
        assert!(larger(f64::NAN, 1.0).is_nan() && larger(1.0, f64::NAN).is_nan());
    }
}
