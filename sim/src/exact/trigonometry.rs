//! Functions of angles and roots for scalars of the trait [`Real`], which has no arctangent of two
//! arguments.

use tripos_traits::Real;

/// Angle of the point (x, y) from the x axis (arctangent of two arguments), from −π to π rad; 0 for the
/// origin.
pub(super) fn arctangent_of_two<S: Real>(y: S, x: S) -> S {
    let [zero, two] = [0, 2].map(S::int);
    if x == zero && y == zero {
        return zero;
    }
    // The larger of |x| and |y| is the divisor, so that the quotient is at most 1.
    if y.abs() > x.abs() {
        return S::pi() / two * y.sign() - (x / y).atan();
    }
    let turned = if x > zero {
        zero
    } else if y < zero {
        -S::pi()
    } else {
        S::pi()
    };
    turned + (y / x).atan()
}

/// Whole number nearest to x, after x is rounded to `f64`.
pub(super) fn nearest_whole<S: Real>(x: S) -> S {
    S::from_f64(x.to_f64().round())
}

/// Square root of x; 0 if rounding errors have made x negative.
pub(super) fn root_of_positive<S: Real>(x: S) -> S {
    if x < S::int(0) { S::int(0) } else { x.sqrt() }
}
