//! Coefficients of Radau IIA with three stages, in any scalar, computed from the published formulae.
//!
//! B = A⁻¹ has the real eigenvalue γ and the pair α ± iβ. T⁻¹ B T = \[γ; (α, −β; β, α)\] separates the 3n equations of
//! a step into n real and n complex equations. E. Hairer & G. Wanner, *Solving Ordinary Differential Equations II*, 2nd
//! edition (1996), §IV.5 (the method), §IV.8 (the transformation and the error).

use tripos_traits::Real;

use super::complex::Complex;
use crate::linear::lu::Entry;

/// Matrix of order 3, as a list of its three rows.
pub(super) type Matrix<E> = [[E; 3]; 3];

/// Nodes, eigenvalues and transformations of Radau IIA with three stages.
pub(super) struct Scheme<S> {
    /// Nodes of the stages as fractions of the step, the zeros of Radau's polynomial: (4 − √6)/10, (4 +
    /// √6)/10, 1.
    pub(super) c: [S; 3],
    /// Real eigenvalue γ of the inverse A⁻¹ of the method's matrix.
    pub(super) real: S,
    /// Complex eigenvalue α + iβ of the inverse A⁻¹ of the method's matrix, with β > 0.
    pub(super) pair: Complex<S>,
    /// Transformation T, whose columns are the eigenvectors of A⁻¹; the last entry of each is 1.
    pub(super) t: Matrix<S>,
    /// Inverse of the transformation T.
    pub(super) t_inverse: Matrix<S>,
    /// Matrix that computes the coefficients of θ, θ² and θ³ of a polynomial from its values at the nodes. The
    /// polynomial is 0 at θ = 0.
    pub(super) powers: Matrix<S>,
    /// Weights of the three stage differences in the error estimate of a Radau step.
    pub(super) error: [S; 3],
}

impl<S: Real> Scheme<S> {
    /// Computes all coefficients of Radau IIA in the scalar `S`.
    pub(super) fn new() -> Self {
        let root = S::int(6).sqrt();
        let one = S::int(1);
        let c = [(S::int(4) - root) / S::int(10), (S::int(4) + root) / S::int(10), one];
        let b = inverse_of_order_3(&radau_matrix());
        // det(z I − A⁻¹) = z³ − 9 z² + 36 z − 60: the denominator of the stability function with its coefficients in
        // reverse order.
        let real = radau_root_of_cubic([S::int(-60), S::int(36), S::int(-9)], S::from_f64(3.637_834_252_744_496));
        let alpha = (S::int(9) - real) / S::int(2);
        let pair = Complex { re: alpha, im: (real * (real - S::int(9)) + S::int(36) - alpha * alpha).sqrt() };
        let first = eigenvector(&b, real);
        // The eigenvector of α − iβ: its real and imaginary parts are the second and third column.
        let wide = b.map(|row| row.map(|re| Complex { re, im: S::int(0) }));
        let second = eigenvector(&wide, Complex { re: pair.re, im: -pair.im });
        let t = [0, 1, 2].map(|i| [first[i], second[i].re, second[i].im]);
        let third = S::int(-3);
        let seven = S::int(7) * root;
        Self {
            c,
            real,
            pair,
            t,
            t_inverse: inverse_of_order_3(&t),
            powers: inverse_of_order_3(&c.map(|c| [c, c * c, c * c * c])),
            error: [(S::int(13) + seven) / third, (S::int(13) - seven) / third, one / third],
        }
    }
}

/// Matrix A of Radau IIA with three stages: aᵢⱼ is the weight of stage j at node i.
pub(super) fn radau_matrix<S: Real>() -> Matrix<S> {
    let root = S::int(6).sqrt();
    let entry = |whole: i64, roots: i64, over: i64| (S::int(whole) + S::int(roots) * root) / S::int(over);
    [
        [entry(88, -7, 360), entry(296, -169, 1800), entry(-2, 3, 225)],
        [entry(296, 169, 1800), entry(88, 7, 360), entry(-2, -3, 225)],
        [entry(16, -1, 36), entry(16, 1, 36), entry(1, 0, 9)],
    ]
}

/// Root of z³ + a₂ z² + a₁ z + a₀ near `z`, which is the root rounded to `f64`. Three Newton steps each double the
/// number of digits.
fn radau_root_of_cubic<S: Real>([a0, a1, a2]: [S; 3], mut z: S) -> S {
    for _ in 0..3 {
        let value = ((z + a2) * z + a1) * z + a0;
        let slope = (S::int(3) * z + S::int(2) * a2) * z + a1;
        z = z - value / slope;
    }
    z
}

/// Eigenvector of B for this eigenvalue, scaled so that the last entry is 1. It is orthogonal to the first two rows of
/// B − λ.
fn eigenvector<E: Entry>(b: &Matrix<E>, eigenvalue: E) -> [E; 3] {
    let (mut first, mut second) = (b[0], b[1]);
    first[0] = first[0] - eigenvalue;
    second[1] = second[1] - eigenvalue;
    let v = cross(&first, &second);
    v.map(|entry| entry / v[2])
}

/// Cross product of two vectors of three entries.
fn cross<E: Entry>(a: &[E; 3], b: &[E; 3]) -> [E; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// Computes the inverse of a matrix of order 3 by the cross products of its columns.
fn inverse_of_order_3<S: Real>(m: &Matrix<S>) -> Matrix<S> {
    let column = |j: usize| [m[0][j], m[1][j], m[2][j]];
    let rows = [cross(&column(1), &column(2)), cross(&column(2), &column(0)), cross(&column(0), &column(1))];
    let determinant = dot(&rows[0], &column(0));
    rows.map(|row| row.map(|x| x / determinant))
}

/// Dot product Σ aᵢ bᵢ of two vectors of three entries.
pub(super) fn dot<S: Real>(a: &[S; 3], b: &[S; 3]) -> S {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

#[cfg(test)]
mod tests {
    use super::*;
    use tripos_traits::{DoubleDouble, Scalar};

    fn product<S: Real>(a: &Matrix<S>, b: &Matrix<S>) -> Matrix<S> {
        a.map(|row| [0, 1, 2].map(|j| dot(&row, &[b[0][j], b[1][j], b[2][j]])))
    }

    fn apart<S: Real>(a: &Matrix<S>, b: &Matrix<S>) -> f64 {
        let entries = a.iter().flatten().zip(b.iter().flatten());
        entries.map(|(a, b)| (*a - *b).to_f64().abs()).fold(0.0, f64::max)
    }

    /// The tolerance is 100 ε of each scalar, since the entries are below 10.
    fn is_taken_apart<S: Real>() {
        let Scheme { real, pair: Complex { re, im }, t, t_inverse, .. } = Scheme::<S>::new();
        let (zero, found) = (S::int(0), product(&t_inverse, &product(&inverse_of_order_3(&radau_matrix()), &t)));
        let blocks = [[real, zero, zero], [zero, re, -im], [zero, im, re]];
        assert!(apart(&found, &blocks) < 100.0 * S::EPSILON, "{found:?}");
    }

    #[test]
    fn the_matrix_is_taken_apart_in_every_scalar() {
        is_taken_apart::<f64>();
        is_taken_apart::<DoubleDouble>();
    }

    /// The simplifying assumptions C(3) and B(5): Σⱼ aᵢⱼ cⱼᵏ⁻¹ = cᵢᵏ/k for k ≤ 3, and Σ bⱼ cⱼᵏ⁻¹ = 1/k for k ≤ 5, where
    /// b is the last row. They give the order 5 (Hairer & Wanner II, theorem 5.1), and fail for k = 6. Checked in 32
    /// digits.
    #[test]
    fn the_simplifying_assumptions_hold_to_the_last_digit() {
        let (a, c) = (radau_matrix::<DoubleDouble>(), Scheme::<DoubleDouble>::new().c);
        let off = |row: &[DoubleDouble; 3], end: DoubleDouble, k: i32| {
            let found = dot(row, &c.map(|c| c.powi(k - 1)));
            (found - end.powi(k) / DoubleDouble::int(k.into())).to_f64().abs()
        };
        for k in 1..=3 {
            assert!(a.iter().zip(c).all(|(row, c)| off(row, c, k) < 1e-31), "C({k})");
        }
        assert!((1..=5).all(|k| off(&a[2], c[2], k) < 1e-31));
        assert!(off(&a[2], c[2], 6) > 1e-4);
    }

    /// Truth: 3 + 3^(2/3) − 3^(1/3), 3 + (3^(1/3) − 3^(2/3))/2 and (3^(5/6) + 3^(7/6))/2, computed independently to 30
    /// digits.
    #[test]
    fn eigenvalues_are_those_in_closed_form() {
        let Scheme { real, pair, .. } = Scheme::<DoubleDouble>::new();
        for (found, text) in [
            (real, "3.63783425274449573220841851358"),
            (pair.re, "2.68108287362775213389579074321"),
            (pair.im, "3.05043019924741056942637762479"),
        ] {
            assert!((found - DoubleDouble::decimal(text)).to_f64().abs() < 1e-28, "{text}: {found:?}");
        }
    }
}
