//! Differences in 32 digits: derivatives that are exact in doubles.

use tripos_traits::{DoubleDouble, Real, Scalar, larger};

/// Step of a difference relative to the size of the numbers that change. Rules of order 4 have an error of STEP⁴, some
/// 3e-21, and a rounding of 1e-32/STEP.
pub const STEP: f64 = 1.0 / 131_072.0;

/// Central difference of order 4: the places in steps, and twelve times the weights. M. Abramowitz & I. A. Stegun,
/// *Handbook of Mathematical Functions* (1964), table 25.2.
pub const CENTRAL: [(i32, i64); 4] = [(-2, 1), (-1, -8), (1, 8), (2, -1)];

/// Difference of order 4 on one side: the places in steps, and twelve times the weights.
pub const FORWARD: [(i32, i64); 5] = [(0, -25), (1, 48), (2, -36), (3, 16), (4, -3)];

/// Derivative of several values, which are given at the places of a rule for differences.
pub fn difference(list: &[Vec<DoubleDouble>], rule: &[(i32, i64)], step: DoubleDouble) -> Vec<f64> {
    let twelve = DoubleDouble::int(12) * step;
    let count = list.first().map_or(0, Vec::len);
    // Weights add up to 0. With differences from the first value, a value that does not change has a derivative of
    // exactly 0.
    let sum = |at: usize| {
        let rise = list.iter().map(|values| values[at] - list[0][at]);
        let terms = rise.zip(rule).map(|(rise, (_, weight))| rise * DoubleDouble::int(*weight));
        terms.fold(DoubleDouble::int(0), |sum, term| sum + term)
    };
    (0..count).map(|at| (sum(at) / twelve).to_f64()).collect()
}

/// Least size of a component of a state, in its unit: a smaller component counts as this size. A state may pass through
/// zero, but a length that matters is larger.
const FLOOR: f64 = 1e-6;

/// Derivative of a function at `x` along a direction, exact in doubles; NaN if the direction is not finite.
pub fn along(x: &[f64], direction: &[f64], of: impl Fn(&[DoubleDouble]) -> Vec<DoubleDouble>) -> Vec<f64> {
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
    difference(&list, &CENTRAL, DoubleDouble::from_f64(step))
}
