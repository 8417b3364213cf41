//! Functions that [`Real`] leaves out.

use tripos_traits::Real;

/// The angle of the point (x, y) from the axis of x, in [−π, π]; 0 for the origin.
pub(super) fn angle_of<S: Real>(y: S, x: S) -> S {
    let [zero, two] = [0, 2].map(S::int);
    if x == zero && y == zero {
        return zero;
    }
    // Of the two quotients, the one that is at most 1.
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

/// The whole number nearest to x, as far as the nearest f64 tells.
pub(super) fn nearest_whole<S: Real>(x: S) -> S {
    S::from_f64(x.to_f64().round())
}

/// √x, and 0 where rounding left x below 0.
pub(super) fn root_of_positive<S: Real>(x: S) -> S {
    if x < S::int(0) { S::int(0) } else { x.sqrt() }
}
