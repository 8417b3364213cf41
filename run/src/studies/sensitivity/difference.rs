//! Derivatives from differences of numbers with 32 digits, accurate to double precision.

use tripos_traits::{DoubleDouble, Real, Scalar, larger};

/// Step of a difference, relative to the size of the varied numbers. A difference of order 4 then has a
/// relative error of about STEP⁴ = 3e-21, and a rounding error of 1e-32/STEP.
pub const STEP: f64 = 1.0 / 131_072.0;

/// Central difference of order 4, as pairs: a position in steps, and twelve times its weight.
///
/// Source: M. Abramowitz & I. A. Stegun, *Handbook of Mathematical Functions* (1964), table 25.2.
pub const CENTRAL: [(i32, i64); 4] = [(-2, 1), (-1, -8), (1, 8), (2, -1)];

/// One-sided difference of order 4, as pairs: a position in steps, and twelve times its weight.
pub const FORWARD: [(i32, i64); 5] = [(0, -25), (1, 48), (2, -36), (3, 16), (4, -3)];

/// Computes the derivatives of several values by a difference with the given step. `list` has the values
/// at each position of the rule.
pub fn derivative_by_rule(list: &[Vec<DoubleDouble>], rule: &[(i32, i64)], step: DoubleDouble) -> Vec<f64> {
    let twelve = DoubleDouble::int(12) * step;
    let count = list.first().map_or(0, Vec::len);
    // The weights add up to 0. With differences from the first value, a constant value has exactly the
    // derivative 0.
    let sum = |at: usize| {
        let rise = list.iter().map(|values| values[at] - list[0][at]);
        let terms = rise.zip(rule).map(|(rise, (_, weight))| rise * DoubleDouble::int(*weight));
        terms.fold(DoubleDouble::int(0), |sum, term| sum + term)
    };
    (0..count).map(|at| (sum(at) / twelve).to_f64()).collect()
}

/// Least size that is assumed for a component of a state, in its unit. A state may pass through zero,
/// but a length of interest is larger.
const FLOOR: f64 = 1e-6;

/// Computes the derivative of the vector function `of` at `x` along a direction, accurate to double
/// precision. All components are NaN if the direction is not finite.
pub fn directional_difference(
    x: &[f64],
    direction: &[f64],
    of: impl Fn(&[DoubleDouble]) -> Vec<DoubleDouble>,
) -> Vec<f64> {
    let part = x.iter().zip(direction).map(|(x, d)| d.abs() / x.abs().max(FLOOR)).fold(0.0, larger);
    if !(part > 0.0 && part.is_finite()) {
        let known = if part == 0.0 { 0.0 } else { f64::NAN };
        return vec![known; of(&x.iter().map(|x| DoubleDouble::from_f64(*x)).collect::<Vec<_>>()).len()];
    }
    let step = STEP / part;
    let at = |place: i32| {
        let by = DoubleDouble::from_f64(step) * DoubleDouble::int(i64::from(place));
        let moved = x.iter().zip(direction).map(|(x, d)| DoubleDouble::from_f64(*x) + by * DoubleDouble::from_f64(*d));
        of(&moved.collect::<Vec<_>>())
    };
    let list: Vec<_> = CENTRAL.iter().map(|(place, _)| at(*place)).collect();
    derivative_by_rule(&list, &CENTRAL, DoubleDouble::from_f64(step))
}
