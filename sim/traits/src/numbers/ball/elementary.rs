//! Elementary functions of balls with 32 digits, each with a proved bound.
//!
//! Sine, cosine and exponential are series of balls, so that rounding is bounded by the arithmetic; the rest of
//! a series is bounded by its first term left out. Inverse functions take a value that need not be right,
//! and bound its error by the series.

use super::super::double_double::DoubleDouble;
use super::super::scalar::{Real, Scalar};
use super::{Ball, TINY, UP};

/// Ball with 32 digits.
type Wide = Ball<DoubleDouble>;

/// Largest angle, rad, whose sine and cosine are computed. Larger angles give −1 to 1.
const FAR: f64 = 1e9;
/// Number of factors of the series of sine and cosine. For |x| ≤ 0.9 the first term left out is below 1e-36 of
/// the first term.
const TERMS: i64 = 16;
/// Bound on the rest of the series of sine, relative to x, and of cosine.
const REST: f64 = 1e-36;
/// Number of terms of the series of the exponential. For |x| ≤ 0.4 the first term left out is below 1e-38.
const EXPONENTIAL_TERMS: i64 = 27;

/// Computes (sin x, cos x), x in rad.
pub fn sin_cos(x: Wide) -> (Wide, Wide) {
    let all = Wide { centre: DoubleDouble::from(0.0), radius: 1.0 };
    if !x.is_defined() {
        return (Wide::undefined(), Wide::undefined());
    }
    if x.size() > FAR {
        return (all, all);
    }
    let turns = libm::round(x.centre.hi() / core::f64::consts::FRAC_PI_2);
    let rest = Wide::point(x.centre) - Wide::from_f64(turns) * (Wide::pi() / Wide::int(2));
    if rest.size() > 0.9 {
        return (all, all);
    }
    let square = rest * rest;
    let (mut of_sine, mut of_cosine) = (Wide::int(1), Wide::int(1));
    for k in (1..TERMS).rev() {
        of_sine = Wide::int(1) - square * of_sine / Wide::int(2 * k * (2 * k + 1));
        of_cosine = Wide::int(1) - square * of_cosine / Wide::int((2 * k - 1) * 2 * k);
    }
    let (sine, cosine) = ((rest * of_sine).widened(REST * rest.size()), of_cosine.widened(REST));
    // `rem_euclid` needs the standard library. All these whole numbers are exact.
    let (sine, cosine) = match turns - 4.0 * libm::floor(0.25 * turns) {
        0.0 => (sine, cosine),
        1.0 => (cosine, -sine),
        2.0 => (-sine, -cosine),
        _ => (-cosine, sine),
    };
    (within_radius(sine, cosine, x.radius), within_radius(cosine, sine, x.radius))
}

/// Ball of f(m + δ), |δ| ≤ `radius`, where f is a sine or cosine with the given value and the given derivative, up
/// to its sign, at m.
fn within_radius(value: Wide, derivative: Wide, radius: f64) -> Wide {
    if radius == 0.0 {
        return value;
    }
    let change = (radius * (derivative.size() + 0.5 * radius)) * UP;
    let around = value.widened(change.min(radius) + TINY);
    if around.radius >= 1.0 { Wide { centre: DoubleDouble::from(0.0), radius: 1.0 } } else { around }
}

/// Square root; undefined if x may be negative.
pub fn sqrt(x: Wide) -> Wide {
    if !x.is_defined() || x.low() < 0.0 {
        return Wide::undefined();
    }
    let root = x.centre.sqrt();
    if root.hi() <= 0.0 {
        // All numbers are between 0 and twice the radius.
        let high = libm::sqrt(x.high()) * UP;
        return Wide::between(0.0, high);
    }
    // √y − r = (y − r²)/(√y + r), for all y of the ball.
    let gap = x - Wide::point(root) * Wide::point(root);
    Wide { centre: root, radius: (gap.size() / (root.hi() * (1.0 - 4.0 * f64::EPSILON))) * UP + TINY }
}

/// Exponential; undefined if it overflows.
pub fn exp(x: Wide) -> Wide {
    if !x.is_defined() || x.high() > 700.0 {
        return Wide::undefined();
    }
    if x.high() < -700.0 {
        return Wide::between(0.0, 1e-303);
    }
    if x.radius > 1.0 {
        let high = exp(Wide::from_f64(x.high())).high();
        return Wide::between(0.0, high);
    }
    let centre = x.centre.hi().max(-700.0);
    let powers = libm::round(centre / core::f64::consts::LN_2);
    // ln 2 to 38 digits.
    let logarithm = Wide::decimal("0.69314718055994530941723212145817656808");
    let rest = Wide::point(x.centre) - Wide::from_f64(powers) * logarithm;
    if rest.size() > 0.4 {
        return Wide::between(0.0, exp(Wide::from_f64(x.high())).high());
    }
    let mut sum = Wide::int(1);
    for k in (1..EXPONENTIAL_TERMS).rev() {
        sum = Wide::int(1) + rest * sum / Wide::int(k);
    }
    // A power of two is an exact factor.
    #[expect(clippy::cast_possible_truncation, reason = "between -1011 and 1011")]
    let scale = Wide::from_f64(libm::scalbn(1.0, powers as i32));
    let value = sum.widened(REST) * scale;
    // |e^(m + δ) − e^m| ≤ e^m (e^|δ| − 1) ≤ e^m |δ| (1 + |δ|) for |δ| ≤ 1.
    value.widened(value.size() * (x.radius * (1.0 + x.radius) * UP))
}

/// Natural logarithm; undefined if x may not be positive.
pub fn ln(x: Wide) -> Wide {
    let least = x.low();
    if !x.is_defined() || least <= 0.0 {
        return Wide::undefined();
    }
    let guess = x.centre.ln();
    // ln m = y + ln(m e^(−y)).
    let rest = (Wide::point(x.centre) * exp(Wide::point(-guess)) - Wide::int(1)).size();
    if !rest.is_finite() || rest > 0.5 {
        return Wide::undefined();
    }
    Wide { centre: guess, radius: (2.0 * rest + x.radius / least) * UP + TINY }
}

/// Hyperbolic tangent.
pub fn tanh(x: Wide) -> Wide {
    if x.is_defined() && x.least_size() > 300.0 {
        let one = Wide { centre: DoubleDouble::from(1.0), radius: DoubleDouble::EPSILON };
        return if x.centre.hi() > 0.0 { one } else { -one };
    }
    rising(x, |x| Wide::int(1) - Wide::int(2) / (exp(x + x) + Wide::int(1)))
}

/// Inverse tangent, rad.
pub fn atan(x: Wide) -> Wide {
    if !x.is_defined() {
        return Wide::undefined();
    }
    let guess = x.centre.atan();
    let (sine, cosine) = sin_cos(Wide::point(guess));
    let m = Wide::point(x.centre);
    // atan m = y + atan((m cos y − sin y)/(cos y + m sin y)), and |atan z| ≤ |z|.
    let rest = ((m * cosine - sine) / (cosine + m * sine)).size();
    let least = x.least_size();
    let slope = 1.0 / (1.0 + least * least * (1.0 - 8.0 * f64::EPSILON));
    Wide::around(guess, (rest + slope * x.radius) * UP + TINY)
}

/// Inverse sine, rad; undefined if |x| may exceed 1.
pub fn asin(x: Wide) -> Wide {
    if !x.is_defined() {
        return Wide::undefined();
    }
    rising(x, |x| {
        if x.radius == 0.0 && x.centre.abs() == DoubleDouble::from(1.0) {
            return x.sign() * Wide::pi() / Wide::int(2);
        }
        let leg = sqrt((Wide::int(1) - x) * (Wide::int(1) + x));
        if leg.least_size() > 0.0 { atan(x / leg) } else { Wide::undefined() }
    })
}

/// Ball of f(x) for a function f that rises, whose values are between those at the ends of x.
fn rising(x: Wide, f: impl Fn(Wide) -> Wide) -> Wide {
    if x.radius == 0.0 {
        return f(x);
    }
    let (middle, radius) = (Wide::point(x.centre), Wide::from_f64(x.radius));
    f(middle - radius).hull(f(middle + radius))
}

/// Inverse cosine, rad, in [0, π]; undefined if |x| may exceed 1.
pub fn acos(x: Wide) -> Wide {
    Wide::pi() / Wide::int(2) - asin(x)
}
