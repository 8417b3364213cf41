//! Dense output of the method DOP853: the polynomial inside a step, from the published coefficients, for a component of
//! the state.

use tripos_traits::Real;

/// Value of a component of the state at the fraction `theta` of a step of DOP853. The first argument has the eight
/// coefficients of the component's dense output.
pub(crate) fn dense_output_value<S: Real>([r0, r1, r2, r3, r4, r5, r6, r7]: [S; 8], theta: S) -> S {
    let rest = S::int(1) - theta;
    let inner = r4 + theta * (r5 + rest * (r6 + theta * r7));
    r0 + theta * (r1 + rest * (r2 + theta * (r3 + rest * inner)))
}

/// Coefficients of the powers 0 to 7 of the fraction `theta` of a step, in the dense output of a component of DOP853.
/// `r` has its eight coefficients in the published form.
pub(crate) fn dense_output_powers<S: Real>(r: [S; 8]) -> [S; 8] {
    // From the innermost bracket outwards, the polynomial is multiplied by θ or 1 − θ in turn, and the
    // next coefficient of r is added.
    let mut p = [S::from_f64(0.0); 8];
    p[0] = r[7];
    for (at, add) in r[..7].iter().enumerate().rev() {
        for k in (1..8).rev() {
            p[k] = if at % 2 == 0 { p[k - 1] } else { p[k] - p[k - 1] };
        }
        p[0] = if at % 2 == 0 { *add } else { p[0] + *add };
    }
    p
}
