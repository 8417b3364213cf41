//! Functions of angles and roots that [`Real`] leaves out.

use tripos_traits::Real;

/// Angle of the point (x, y) from the axis of x, in [−π, π], rad; 0 for the origin.
pub(super) fn angle_of<S: Real>(y: S, x: S) -> S {
    let [zero, two] = [0, 2].map(S::int);
    if x == zero && y == zero {
        return zero;
    }
    // The quotient that is at most 1 is used.
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

/// Whole number nearest to x, as rounded from the f64 nearest to x.
pub(super) fn nearest_whole<S: Real>(x: S) -> S {
    S::from_f64(x.to_f64().round())
}

/// Square root √x, and 0 if rounding left x below 0.
pub(super) fn root_of_positive<S: Real>(x: S) -> S {
    if x < S::int(0) { S::int(0) } else { x.sqrt() }
}
