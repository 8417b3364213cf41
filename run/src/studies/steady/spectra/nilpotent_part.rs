//! Part of a Schur form that belongs to coinciding eigenvalues, and the decision if a quantity is 0 up to
//! rounding.
//!
//! The part minus its eigenvalue is nilpotent. Its powers tell if solutions are bounded or grow like a
//! power of t. A quantity that is neither clearly 0 nor clearly different from 0 is reported as
//! undecided.
//!
//! Sources: F. R. Gantmacher, *The Theory of Matrices*, chapter VIII; J. H. Wilkinson, *The Algebraic
//! Eigenvalue Problem*, 1965, chapter 2.

use super::schur_form::SchurForm;
use super::wide_complex::WideComplex;
use tripos_traits::{DoubleDouble, Scalar};

/// Multiple of its rounding error up to which a quantity counts as 0.
pub(in crate::studies::steady) const ZERO: f64 = 1e3;
/// Multiple of its rounding error from which on a quantity counts as different from 0.
pub(in crate::studies::steady) const NOT_ZERO: f64 = 1e7;
/// Fraction of the rounding error up to which a coefficient counts as 0 in the test if eigenvalues
/// coincide. It is below 1, because most entries are known to more than 27 digits, and because a
/// coefficient contains squared differences.
const SAME: f64 = 1e-3;

/// Decision if a quantity is 0, from its size and its rounding error.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::studies::steady) enum ZeroDecision {
    /// The quantity is 0 up to rounding.
    Zero,
    /// The quantity is neither clearly 0 nor clearly different from 0.
    Undecided,
    /// The quantity is clearly different from 0.
    NotZero,
}

impl ZeroDecision {
    /// Decides if a quantity with the absolute value `x` and the given rounding error is 0.
    pub(in crate::studies::steady) fn decide_zero(x: f64, rounding: f64) -> Self {
        if x <= ZERO * rounding {
            Self::Zero
        } else if x >= NOT_ZERO * rounding {
            Self::NotZero
        } else {
            Self::Undecided
        }
    }
}

/// Part of a Schur form that belongs to eigenvalues that may coincide.
pub(in crate::studies::steady) struct NilpotentPart {
    /// Mean of the eigenvalues of the part.
    pub(in crate::studies::steady) mean: WideComplex,
    /// Diagonal block of the Schur form, row by row, with the mean subtracted on its diagonal.
    nilpotent: Vec<Vec<WideComplex>>,
}

impl NilpotentPart {
    /// Makes the part from the block of the first `many` rows and columns of a Schur form.
    pub(in crate::studies::steady) fn new(form: &SchurForm, many: usize) -> Self {
        let sum = (0..many).fold(WideComplex::default(), |sum, at| sum + form.t[at][at]);
        let mean = sum.scaled(DoubleDouble::int(1) / DoubleDouble::from_f64(many as f64));
        let mut nilpotent: Vec<Vec<WideComplex>> = form.t[..many].iter().map(|row| row[..many].to_vec()).collect();
        for (at, row) in nilpotent.iter_mut().enumerate() {
            row[at] = row[at] - mean;
        }
        Self { mean, nilpotent }
    }

    /// True if the eigenvalues coincide: all symmetric functions of their differences from the mean are 0
    /// up to rounding. `off` is the possible error of the entries.
    pub(in crate::studies::steady) fn coincides(&self, off: f64) -> bool {
        // Coefficients of the product of all (s − λ + mean). In absolute value, they are at most the
        // coefficients of the product of all (s + |λ − mean|).
        let mut coefficients = vec![WideComplex::from_f64(1.0)];
        for (at, row) in self.nilpotent.iter().enumerate() {
            coefficients.push(WideComplex::default());
            for k in (1..coefficients.len()).rev() {
                coefficients[k] = coefficients[k] - row[at] * coefficients[k - 1];
            }
        }
        let length = self.norm().max(off);
        let mut ways = 1.0;
        coefficients.iter().enumerate().skip(1).all(|(k, coefficient)| {
            ways *= (self.nilpotent.len() + 1 - k) as f64 / k as f64;
            let rounding = ways * off * length.powi(i32::try_from(k).unwrap_or(i32::MAX) - 1);
            // A rounding error below the smallest positive number would be 0.
            coefficient.norm() <= SAME * rounding.max(f64::MIN_POSITIVE)
        })
    }

    /// Frobenius norm of the nilpotent block.
    fn norm(&self) -> f64 {
        norm(&self.nilpotent)
    }

    /// Largest exponent for which the power of the nilpotent block is not 0. The flag is true if this
    /// exponent is certain. Entries of the block may have the error `off`.
    pub(in crate::studies::steady) fn largest_nonzero_power(&self, off: f64) -> (usize, bool) {
        let many = self.nilpotent.len();
        let length = self.norm().max(off);
        let mut product = self.nilpotent.clone();
        let mut is_sure = true;
        for power in 1..many {
            let rounding = power as f64 * off * length.powi(i32::try_from(power).unwrap_or(i32::MAX) - 1);
            match ZeroDecision::decide_zero(norm(&product), rounding.max(f64::MIN_POSITIVE)) {
                ZeroDecision::Zero => return (power - 1, is_sure),
                ZeroDecision::Undecided => is_sure = false,
                ZeroDecision::NotZero => {}
            }
            product = matrix_product(&product, &self.nilpotent);
        }
        (many - 1, is_sure)
    }

    /// Rank of the nilpotent block, by elimination with the largest pivots. The flag is true if the rank
    /// is certain. Entries of the block may have the error `off`.
    pub(in crate::studies::steady) fn rank(&self, off: f64) -> (usize, bool) {
        let mut left = self.nilpotent.clone();
        for rank in 0..left.len() {
            let places = (rank..left.len()).flat_map(|i| (rank..left.len()).map(move |j| (i, j)));
            let largest = places.max_by(|a, b| left[a.0][a.1].norm().total_cmp(&left[b.0][b.1].norm()));
            let Some((row, column)) = largest else { return (rank, true) };
            match ZeroDecision::decide_zero(left[row][column].norm(), off.max(f64::MIN_POSITIVE)) {
                ZeroDecision::NotZero => {}
                other => return (rank, other == ZeroDecision::Zero),
            }
            left.swap(rank, row);
            for row in &mut left {
                row.swap(rank, column);
            }
            let pivot = left[rank].clone();
            for row in &mut left[rank + 1..] {
                let factor = row[rank] / pivot[rank];
                row.iter_mut().zip(&pivot).skip(rank).for_each(|(x, p)| *x = *x - factor * *p);
            }
        }
        (self.nilpotent.len(), true)
    }
}

/// Frobenius norm of a matrix.
fn norm(matrix: &[Vec<WideComplex>]) -> f64 {
    matrix.iter().flatten().map(|x| x.norm()).fold(0.0, f64::hypot)
}

/// Product of two square matrices.
fn matrix_product(a: &[Vec<WideComplex>], b: &[Vec<WideComplex>]) -> Vec<Vec<WideComplex>> {
    let entry =
        |row: &[WideComplex], j: usize| row.iter().zip(b).fold(WideComplex::default(), |sum, (x, y)| sum + *x * y[j]);
    a.iter().map(|row| (0..b.len()).map(|j| entry(row, j)).collect()).collect()
}

/// Computes the norm of the projector P onto the eigenvectors of the first `many` eigenvalues of a Schur
/// form, along the eigenvectors of the other eigenvalues. Also returns the shares |P_kk| of the states,
/// scaled so that their sum is 1.
///
/// P = Q (1 Z; 0 0) Qᴴ, where T₁₁ Z − Z T₂₂ = T₁₂ is solved for Z column by column. Differences of
/// eigenvalues count as at least `noise`.
pub(in crate::studies::steady) fn spectral_projector(form: &SchurForm, many: usize, noise: f64) -> (f64, Vec<f64>) {
    let (t, n) = (&form.t, form.t.len());
    let mut z: Vec<Vec<WideComplex>> = vec![Vec::with_capacity(n - many); many];
    for column in many..n {
        let mut right: Vec<WideComplex> = (0..many).map(|row| t[row][column]).collect();
        for (row, right) in right.iter_mut().enumerate() {
            for (k, known) in z[row].iter().enumerate() {
                *right = *right + *known * t[many + k][column];
            }
        }
        for row in (0..many).rev() {
            let solved = (row + 1..many).fold(right[row], |sum, k| sum - t[row][k] * right[k]);
            let difference = t[row][row] - t[column][column];
            right[row] = solved / if difference.norm() > noise { difference } else { WideComplex::from_f64(noise) };
        }
        z.iter_mut().zip(right).for_each(|(row, x)| row.push(x));
    }
    let of_state = |q: &Vec<WideComplex>| {
        let left = |a: usize| z[a].iter().zip(&q[many..]).fold(q[a].conj(), |sum, (z, q)| sum + *z * q.conj());
        (0..many).fold(WideComplex::default(), |sum, a| sum + q[a] * left(a)).norm()
    };
    let parts: Vec<f64> = form.q.iter().map(of_state).collect();
    let whole: f64 = parts.iter().sum();
    let size = norm(&z).hypot((many as f64).sqrt());
    (size, parts.iter().map(|part| part / whole).collect())
}
