//! Zeros and minima of a function of a single variable on an interval.
//!
//! Invariant: an iteration keeps a bracket and ends by itself; no input makes it loop. A value that is
//! not a number is returned as the error [`NotANumber`].

/// Error of a search for a zero or minimum: the function is not a number at a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct NotANumber {
    /// Argument at which the function is not a number.
    pub(crate) at: f64,
}

/// Point (x, f(x)) on the graph of a function.
pub(crate) type Point = (f64, f64);

/// Value of `f` at `x`; an error if it is not a number.
fn value_or_error(f: &mut impl FnMut(f64) -> f64, x: f64) -> Result<f64, NotANumber> {
    let y = f(x);
    if y.is_nan() { Err(NotANumber { at: x }) } else { Ok(y) }
}

/// Finds a zero of `f` between two points with values of opposite sign, to within `tolerance` or the spacing of `f64`
/// numbers. Returns the end of the final bracket at which |f| is smaller. Error if a value is not a number.
///
/// Bisection safeguards a secant through the bracket's ends with the Illinois modification; infinite values are only
/// bisected. G. Dahlquist & Å. Björck, *Numerical Methods* (1974), §6.4.
pub(crate) fn root_in_bracket(
    f: &mut impl FnMut(f64) -> f64,
    mut a: Point,
    mut b: Point,
    tolerance: f64,
) -> Result<f64, NotANumber> {
    // Weights of the ends in the secant. A weight is halved while only the other end moves.
    let (mut weight_a, mut weight_b) = (1.0, 1.0);
    let mut moved_a = None;
    for iteration in 0..200 {
        let width = b.0 - a.0;
        if a.1 == 0.0 || b.1 == 0.0 || width.abs() <= tolerance {
            break;
        }
        let (fa, fb) = (a.1 * weight_a, b.1 * weight_b);
        let secant = b.0 - fb * (width / (fb - fa));
        let inside = (secant - a.0) * (secant - b.0) < 0.0;
        // Every third point is the middle, so that the bracket shrinks for any function.
        let x = if inside && iteration % 3 != 2 { secant } else { a.0 + 0.5 * width };
        if (x - a.0) * (x - b.0) >= 0.0 {
            break;
        }
        let y = value_or_error(f, x)?;
        if (y < 0.0) == (a.1 < 0.0) && y != 0.0 {
            (a, weight_a) = ((x, y), 1.0);
            weight_b *= if moved_a == Some(true) { 0.5 } else { 1.0 };
            moved_a = Some(true);
        } else {
            (b, weight_b) = ((x, y), 1.0);
            weight_a *= if moved_a == Some(false) { 0.5 } else { 1.0 };
            moved_a = Some(false);
        }
    }
    Ok(if a.1.abs() < b.1.abs() { a.0 } else { b.0 })
}

/// Finds a minimum of `f` between `low` and `high`, and returns the point (x, f(x)). The search ends early once a value
/// is below `enough`. Error if a value is not a number.
///
/// The method is golden sections, with a parabola through the three best points where it helps; R. P. Brent,
/// *Algorithms for Minimization without Derivatives* (1973), ch. 5.
pub(crate) fn minimum(
    f: &mut impl FnMut(f64) -> f64,
    mut low: f64,
    mut high: f64,
    enough: f64,
) -> Result<Point, NotANumber> {
    const GOLDEN: f64 = 0.381_966_011_250_105_1;
    // A smooth minimum is known to half of the digits; in a narrow interval more digits count.
    let narrow = 1e-6 * (high - low);
    let start = low + GOLDEN * (high - low);
    let mut x = (start, value_or_error(f, start)?);
    let (mut second, mut third) = (x, x);
    let (mut step, mut before) = (0.0_f64, 0.0_f64);
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        let tolerance = (1e-9 * x.0.abs() + 1e-12).min(narrow).max(f64::EPSILON * x.0.abs());
        if x.1 < enough || (x.0 - middle).abs() <= 2.0 * tolerance - 0.5 * (high - low) {
            break;
        }
        let parabola = vertex_of_parabola(x, second, third)
            .filter(|d| before.abs() > tolerance && d.abs() < 0.5 * before.abs())
            .filter(|d| x.0 + d > low && x.0 + d < high);
        before = step;
        step = parabola.unwrap_or_else(|| {
            before = if x.0 >= middle { low - x.0 } else { high - x.0 };
            GOLDEN * before
        });
        let far = if step.abs() >= tolerance { step } else { tolerance.copysign(step) };
        let u = (x.0 + far, value_or_error(f, x.0 + far)?);
        if u.1 <= x.1 {
            if u.0 >= x.0 {
                low = x.0;
            } else {
                high = x.0;
            }
            (third, second, x) = (second, x, u);
        } else {
            if u.0 < x.0 {
                low = u.0;
            } else {
                high = u.0;
            }
            if u.1 <= second.1 || second == x {
                (third, second) = (second, u);
            } else if u.1 <= third.1 || third == x || third == second {
                third = u;
            }
        }
    }
    Ok(x)
}

/// Distance along the axis from `x` to the vertex of the parabola through three points; `None` if they
/// define no parabola.
fn vertex_of_parabola(x: Point, v: Point, w: Point) -> Option<f64> {
    let r = (x.0 - v.0) * (x.1 - w.1);
    let q = (x.0 - w.0) * (x.1 - v.1);
    let d = -0.5 * ((x.0 - w.0) * q - (x.0 - v.0) * r) / (q - r);
    d.is_finite().then_some(d)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_zero_is_found_to_rounding() {
        let mut calls = 0;
        let mut f = |x: f64| {
            calls += 1;
            x.cos() - x
        };
        let x = root_in_bracket(&mut f, (0.0, 1.0), (1.0, 1_f64.cos() - 1.0), 0.0).unwrap();
        // The fixed point of the cosine; the tolerance is 2 ε, since x and cos x are each rounded.
        assert!((x - 0.739_085_133_215_160_6).abs() < 2.0 * f64::EPSILON, "{x}");
        assert!(calls < 30, "{calls}");
    }

    #[test]
    fn a_zero_of_a_step_is_bracketed_to_neighbouring_numbers() {
        let mut f = |x: f64| if x < 0.3 { -f64::INFINITY } else { 1e-300 };
        let x = root_in_bracket(&mut f, (0.0, -f64::INFINITY), (1.0, 1e-300), 0.0).unwrap();
        assert!((x - 0.3).abs() <= f64::EPSILON, "{x}");
    }

    #[test]
    fn a_zero_in_a_descending_bracket_is_found() {
        let x = root_in_bracket(&mut |x: f64| x * x * x - 0.125, (1.0, 0.875), (0.0, -0.125), 0.0).unwrap();
        assert!((x - 0.5).abs() <= f64::EPSILON, "{x}");
    }

    #[test]
    fn a_point_without_a_value_is_reported() {
        let f = &mut |x: f64| (x - 0.5).sqrt() - 0.1;
        assert!(root_in_bracket(f, (0.0, -1.0), (1.0, 0.6), 0.0).is_err());
    }

    #[test]
    fn a_minimum_is_found_to_half_the_digits() {
        let mut f = |x: f64| (x - 0.3).powi(2) + (x - 0.3).powi(4);
        let (x, y) = minimum(&mut f, 0.0, 1.0, -1.0).unwrap();
        // The tolerance is the square root of ε, since the function is flat at its minimum.
        assert!((x - 0.3).abs() < 2e-8, "{x}");
        assert!(y < 1e-15, "{y}");
    }

    #[test]
    fn a_minimum_is_found_next_to_an_end_of_the_interval() {
        let mut f = |x: f64| (x - 1e-3).powi(2);
        let (x, _) = minimum(&mut f, 0.0, 1.0, -1.0).unwrap();
        assert!((x - 1e-3).abs() < 1e-8, "{x}");
    }
}
