//! Elementary functions of `DoubleDouble`: argument reduction, a table, and a short Taylor series.
//!
//! Series terms below 2⁻⁵³ of the result are summed in f64: their rounding error is below that of
//! the result. Inverse functions start from the f64 result and correct it by a step of Newton's
//! method, whose error is the square of 2⁻⁵³.

use super::DoubleDouble;
use super::error_free::two_product;
use super::tables::{EXP_M1, HALF_PI, INVERSE_FACTORIAL, LN_2, SIN_COS};
use crate::Scalar;

/// Largest angle, rad, for which the nearest quarter turn is certain from the leading part of the
/// angle.
const LARGEST_ANGLE: f64 = 1_099_511_627_776.0; // 2⁴⁰
/// Largest x for which eˣ does not overflow f64.
const LARGEST_EXPONENT: f64 = 709.79;
/// Smallest x for which eˣ does not underflow to 0 in f64.
const SMALLEST_EXPONENT: f64 = -745.2;

/// Square root √x with 32 digits; "not a number" for x < 0.
pub(super) fn sqrt(x: DoubleDouble) -> DoubleDouble {
    let estimate = libm::sqrt(x.hi);
    // x is 0, infinite or negative, or not a number.
    if estimate == 0.0 || !estimate.is_finite() {
        return estimate.into();
    }
    // The error of the square must not underflow.
    if x.hi < 1e-240 {
        return sqrt(x.shifted(600)).shifted(-300);
    }
    // √x = s + (x − s²)/(2 s), to the square of the error of s.
    let (square, error) = two_product(estimate, estimate);
    let rest = x - DoubleDouble { hi: square, lo: error };
    DoubleDouble::normalized(estimate, rest.hi / (2.0 * estimate))
}

/// Sine and cosine of an angle in rad; "not a number" unless x is finite.
pub(super) fn sin_cos(x: DoubleDouble) -> (DoubleDouble, DoubleDouble) {
    if !x.is_finite() {
        return (DoubleDouble::NAN, DoubleDouble::NAN);
    }
    if x.hi.abs() > LARGEST_ANGLE {
        return sin_cos_of_large(x);
    }
    let (quarter, rest) = quarter_turns(x);
    let (sin, cos) = sin_cos_within_eighth(rest);
    match quarter {
        0 => (sin, cos),
        1 => (cos, -sin),
        2 => (-sin, -cos),
        _ => (-cos, sin),
    }
}

/// Reduces an angle to r with x = k π/2 + r and |r| ≤ π/4, rad. Returns (k mod 4, r).
#[inline]
#[allow(clippy::cast_possible_truncation, reason = "whole numbers up to 2⁴⁰")]
fn quarter_turns(x: DoubleDouble) -> (i64, DoubleDouble) {
    let k = libm::rint(x.hi * core::f64::consts::FRAC_2_PI);
    if k == 0.0 {
        return (0, x);
    }
    // The products are exact, and what cancels, cancels in exact differences, so that r keeps its own digits.
    let first = DoubleDouble::product(k, HALF_PI[0]);
    let rest = DoubleDouble::sum(x.hi, -first.hi) + DoubleDouble::sum(x.lo, -first.lo);
    let rest = rest - DoubleDouble::product(k, HALF_PI[1]);
    let rest = rest - DoubleDouble::product(k, HALF_PI[2]);
    ((k as i64) & 3, rest.plus(-k * HALF_PI[3]))
}

/// Computes (sin x, cos x) for |x| ≤ π/4 and slightly more, from a table of multiples of π/32 and
/// short series.
#[inline]
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "0 ≤ j ≤ 8")]
fn sin_cos_within_eighth(x: DoubleDouble) -> (DoubleDouble, DoubleDouble) {
    let positive = x.abs();
    let j = libm::rint(positive.hi * (16.0 * core::f64::consts::FRAC_2_PI)).min(8.0);
    let step = DoubleDouble::product(j, HALF_PI[0] / 16.0).plus(j * (HALF_PI[1] / 16.0));
    let t = positive - step;
    let (sin_t, cos_t_less_1) = sin_and_cos_less_1(t);
    let (sin_j, cos_j) = SIN_COS[j as usize];
    let (sin_j, cos_j) = (DoubleDouble::from_parts(sin_j), DoubleDouble::from_parts(cos_j));
    // The table's value last: the corrections are small against it, and so is their rounding.
    let sin = sin_j + (sin_j * cos_t_less_1 + cos_j * sin_t);
    let cos = cos_j + (cos_j * cos_t_less_1 - sin_j * sin_t);
    (if x.hi < 0.0 { -sin } else { sin }, cos)
}

/// Computes (sin t, cos t − 1) for |t| ≤ π/64 = 0.049, by 8 terms of each series, with a remainder
/// of 2⁻¹¹⁴.
#[inline]
fn sin_and_cos_less_1(t: DoubleDouble) -> (DoubleDouble, DoubleDouble) {
    let t_2 = t.squared();
    let sin = alternating_series(t_2, [17, 15, 13, 11, 9], [7, 5, 3]) * (t * t_2);
    let cos = alternating_series(t_2, [18, 16, 14, 12, 10], [8, 6, 4, 2]) * t_2;
    (t - sin, -cos)
}

/// Alternating series 1/n! − t²/(n+2)! + … up to the largest n listed, by Horner's scheme. The
/// terms of `low` are summed in f64, those of `high` in full precision.
#[inline]
fn alternating_series<const A: usize, const B: usize>(
    t_2: DoubleDouble,
    low: [usize; A],
    high: [usize; B],
) -> DoubleDouble {
    let tail = low.iter().fold(0.0, |sum, &n| INVERSE_FACTORIAL[n][0] - sum * t_2.hi);
    high.iter().fold(tail.into(), |sum, &n| DoubleDouble::from_parts(INVERSE_FACTORIAL[n]) - sum * t_2)
}

/// Sine and cosine of a large angle to 16 digits. `libm` reduces an f64 of any size, so hi and lo
/// are treated as two angles.
fn sin_cos_of_large(x: DoubleDouble) -> (DoubleDouble, DoubleDouble) {
    let (sin_hi, cos_hi) = libm::sincos(x.hi);
    let (sin_lo, cos_lo) = libm::sincos(x.lo);
    ((sin_hi * cos_lo + cos_hi * sin_lo).into(), (cos_hi * cos_lo - sin_hi * sin_lo).into())
}

/// Angle of the point (x, y) from the x axis, in (−π, π], rad. x and y must not both be 0, and must
/// have comparable size.
fn angle(y: DoubleDouble, x: DoubleDouble) -> DoubleDouble {
    let estimate = libm::atan2(y.hi, x.hi);
    let (sin, cos) = sin_cos(estimate.into());
    // Turned back by the estimate, the point has the angle tan⁻¹(across/along) ≈ across/along, about 1e-16.
    let across = y * cos - x * sin;
    let along = x.hi * cos.hi + y.hi * sin.hi;
    DoubleDouble::from(estimate).plus(across.hi / along)
}

/// Inverse tangent of x, rad, in [−π/2, π/2].
pub(super) fn atan(x: DoubleDouble) -> DoubleDouble {
    if x.hi.is_infinite() {
        return DoubleDouble::from_parts([HALF_PI[0], HALF_PI[1]]) * x.sign();
    }
    if x.hi == 0.0 { x } else { angle(x, DoubleDouble::ONE) }
}

/// Inverse sine of x, rad, in [−π/2, π/2]; "not a number" for |x| > 1.
pub(super) fn asin(x: DoubleDouble) -> DoubleDouble {
    if x.hi == 0.0 { x } else { angle(x, other_leg(x)) }
}

/// Inverse cosine of x, rad, in [0, π]; "not a number" for |x| > 1.
pub(super) fn acos(x: DoubleDouble) -> DoubleDouble {
    if x == DoubleDouble::ONE { DoubleDouble::ZERO } else { angle(other_leg(x), x) }
}

/// Computes √(1 − x²) without cancellation near |x| = 1; "not a number" for |x| > 1.
fn other_leg(x: DoubleDouble) -> DoubleDouble {
    ((DoubleDouble::ONE - x) * (DoubleDouble::ONE + x)).sqrt()
}

/// Exponential eˣ with 32 digits; infinite if it overflows f64.
pub(super) fn exp(x: DoubleDouble) -> DoubleDouble {
    exp_scaled(x, 0)
}

/// Computes eˣ 2ⁿ, which may be in the range of f64 although eˣ is not.
#[allow(clippy::cast_possible_truncation, reason = "|k| ≤ 1075")]
fn exp_scaled(x: DoubleDouble, n: i32) -> DoubleDouble {
    if x.hi.is_nan() {
        return x;
    }
    let beyond = f64::from(n) * core::f64::consts::LN_2;
    if x.hi > LARGEST_EXPONENT - beyond {
        return DoubleDouble::INFINITY;
    }
    if x.hi < SMALLEST_EXPONENT - beyond {
        return DoubleDouble::ZERO;
    }
    let k = libm::rint(x.hi * core::f64::consts::LOG2_E);
    let rest = x.plus(-k * LN_2[0]) - times_rest_of_ln_2(k);
    exp_less_1_reduced(rest).plus(1.0).shifted(k as i32 + n)
}

/// Product of k and (ln 2 − `LN_2[0]`). Together with k · `LN_2[0]`, which is exact in f64, it
/// gives k ln 2.
#[inline]
fn times_rest_of_ln_2(k: f64) -> DoubleDouble {
    DoubleDouble::product(k, LN_2[1]).plus(k * LN_2[2])
}

/// Computes eˣ − 1 with a small relative error, also near x = 0.
fn exp_less_1(x: DoubleDouble) -> DoubleDouble {
    if x.hi.abs() < 0.34 { exp_less_1_reduced(x) } else { exp(x).plus(-1.0) }
}

/// Computes eˣ − 1 for |x| ≤ ½ ln 2, from a table of multiples of 1/32 and a short series.
#[inline]
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "|j| ≤ 11")]
fn exp_less_1_reduced(x: DoubleDouble) -> DoubleDouble {
    let j = libm::rint(x.hi * 32.0).clamp(-11.0, 11.0);
    let t = x.plus(-j / 32.0);
    // |t| ≤ 1/64: the terms up to 1/13! leave an error of 2⁻¹¹⁴ of t.
    let tail = (8..=13).rev().fold(0.0, |sum, n| INVERSE_FACTORIAL[n][0] + sum * t.hi);
    let series =
        (2..=7).rev().fold(DoubleDouble::from(tail), |sum, n| DoubleDouble::from_parts(INVERSE_FACTORIAL[n]) + sum * t);
    let of_t = t + series * t.squared();
    let of_j = DoubleDouble::from_parts(EXP_M1[(j + 11.0) as usize]);
    of_j + (of_t + of_j * of_t)
}

/// Natural logarithm; "not a number" for negative x, −∞ for 0.
pub(super) fn ln(x: DoubleDouble) -> DoubleDouble {
    if x.hi <= 0.0 || !x.is_finite() {
        return libm::log(x.hi).into();
    }
    // x = 2ᵏ f with f within a factor √2 of 1.
    let (mantissa, exponent) = libm::frexp(x.hi);
    let k = if mantissa < core::f64::consts::FRAC_1_SQRT_2 { exponent - 1 } else { exponent };
    let of_f = ln_near_1(x.shifted(-k));
    let k = f64::from(k);
    DoubleDouble::from(k * LN_2[0]) + (times_rest_of_ln_2(k) + of_f)
}

/// Computes ln f for f between 1/√2 and √2, with a small relative error.
fn ln_near_1(f: DoubleDouble) -> DoubleDouble {
    let estimate = libm::log(f.hi);
    // d = f e^(−estimate) − 1 = y + m + y m  with  y = f − 1,  m = e^(−estimate) − 1; then ln f = estimate + ln(1 + d).
    let y = f.plus(-1.0);
    let m = exp_less_1_reduced((-estimate).into());
    let d = y + m + y * m;
    DoubleDouble::from(estimate) + d.plus(-0.5 * d.hi * d.hi)
}

/// Hyperbolic sine of x, with 32 digits also near 0.
pub(super) fn sinh(x: DoubleDouble) -> DoubleDouble {
    let positive = x.abs();
    let sinh = if positive.hi > 40.0 {
        exp_scaled(positive, -1) // e^(−x) is below 2⁻¹¹⁵ of it
    } else {
        // With m = eˣ − 1:  sinh x = (m + m/(m + 1))/2.
        let m = exp_less_1(positive);
        (m + m / m.plus(1.0)).scaled(0.5)
    };
    if x.hi < 0.0 { -sinh } else { sinh }
}

/// Hyperbolic cosine of x, with 32 digits.
pub(super) fn cosh(x: DoubleDouble) -> DoubleDouble {
    let positive = x.abs();
    if positive.hi > 40.0 {
        return exp_scaled(positive, -1);
    }
    let e = exp(positive);
    (e + DoubleDouble::ONE / e).scaled(0.5)
}

/// Hyperbolic tangent of x, with 32 digits also near 0.
pub(super) fn tanh(x: DoubleDouble) -> DoubleDouble {
    let positive = x.abs();
    let tanh = if positive.hi > 40.0 {
        DoubleDouble::ONE
    } else {
        // With m = e^(2x) − 1:  tanh x = m/(m + 2).
        let m = exp_less_1(positive.scaled(2.0));
        m / m.plus(2.0)
    };
    if x.hi < 0.0 { -tanh } else { tanh }
}
