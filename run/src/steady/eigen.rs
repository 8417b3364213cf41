//! Eigenvalues of small matrices, refined in 32 digits, and which states take part in a mode.
//!
//! The first values come from the real Schur form in doubles; each is then a root of A x = λ x, eᴴ x = 1, corrected by Newton's method
//! with what is left in 32 digits (J. J. Dongarra, C. B. Moler & J. H. Wilkinson, SIAM J. Numer. Anal. 20, 1983, 23-45). Where it
//! does not converge, as at a value that is defective, the first one stands, with its conditioning.

use super::dense::Wide;
use crate::Error;
use nalgebra::{Complex, DMatrix, DVector, Schur};
use tripos_traits::{DoubleDouble, Scalar};

type C64 = Complex<f64>;

/// Steps of refinement, and how far they may lead from the first value, over the size of the matrix.
const REFINEMENTS: usize = 8;
const NEAR: f64 = 1e-5;
/// Most steps of the iteration for the Schur form.
const MOST_STEPS: usize = 10_000;

/// An eigenvalue with what it means.
#[derive(Clone, Debug)]
pub struct Mode {
    /// Its real and imaginary part, 1/s.
    pub value: [f64; 2],
    /// How much larger an error of the matrix may be in it, 1/|yᴴ x| of its left and right vectors of length 1: 1 at best, large
    /// near values that coincide.
    pub condition: f64,
    /// How far off it may be.
    pub error: f64,
    /// How much of it each state has, from 0 to 1 with sum 1: |y_k x_k|.
    pub shares: Vec<f64>,
}

impl Mode {
    /// What its real part must be above to be told from 0, 1/s.
    #[must_use]
    pub fn margin(&self) -> f64 {
        let size = self.value[0].hypot(self.value[1]);
        (10.0 * self.error).max(1e-15 * size).max(f64::MIN_POSITIVE)
    }
}

/// The eigenvalues of a square matrix, those with the largest real part first.
///
/// # Errors
/// [`Error::Stopped`] if they are not found.
pub fn modes(a: &Wide) -> Result<Vec<Mode>, Error> {
    let n = a.rows.len();
    if n == 0 {
        return Ok(Vec::new());
    }
    let (scaled, rounded) = balanced(a);
    let none = || Error::Stopped("the eigenvalues of this matrix were not found".to_owned());
    let schur = Schur::try_new(rounded.clone(), f64::EPSILON, MOST_STEPS).ok_or_else(none)?;
    let size = rounded.norm().max(f64::MIN_POSITIVE);
    let mut list = Vec::with_capacity(n);
    for first in schur.complex_eigenvalues().iter() {
        let (right, left) = (vector(&rounded, *first, size), vector(&rounded.transpose(), first.conj(), size));
        let product: C64 = left.iter().zip(&right).map(|(y, x)| y.conj() * x).sum();
        let condition = 1.0 / product.norm().max(f64::MIN_POSITIVE);
        let refined = refined(&scaled, &rounded, *first, &right, size);
        let error =
            if refined.is_some() { f64::EPSILON * first.norm() } else { 10.0 * f64::EPSILON * condition * size };
        let mut value = refined.unwrap_or(*first);
        if first.im.abs() <= 0.0 {
            // A simple real value stays real.
            value.im = 0.0;
        }
        let parts: Vec<f64> = left.iter().zip(&right).map(|(y, x)| (y.conj() * x).norm()).collect();
        let whole: f64 = parts.iter().sum();
        let shares = parts.iter().map(|part| part / whole).collect();
        list.push(Mode { value: [value.re, value.im], condition, error: error.min(size), shares });
    }
    list.sort_by(|a, b| b.value[0].total_cmp(&a.value[0]).then(b.value[1].total_cmp(&a.value[1])));
    Ok(list)
}

/// A similar matrix whose rows and columns are of like sizes, by powers of two (B. N. Parlett & C. Reinsch, Numer. Math. 13, 1969).
fn balanced(a: &Wide) -> (Wide, DMatrix<f64>) {
    let mut rounded = a.rounded();
    let scales = nalgebra::linalg::balancing::balance_parlett_reinsch(&mut rounded);
    let mut scaled = a.clone();
    for (i, row) in scaled.rows.iter_mut().enumerate() {
        for (j, entry) in row.iter_mut().enumerate() {
            *entry = *entry * DoubleDouble::from_f64(scales[j] / scales[i]);
        }
    }
    let rounded = scaled.rounded();
    (scaled, rounded)
}

/// An eigenvector of length 1, by inverse iteration beside its value.
fn vector(a: &DMatrix<f64>, value: C64, size: f64) -> DVector<C64> {
    let n = a.nrows();
    let beside = value + C64::new(f64::EPSILON * size, f64::EPSILON * size);
    let shifted = DMatrix::from_fn(n, n, |i, j| C64::from(a[(i, j)]) - if i == j { beside } else { C64::from(0.0) });
    let lu = shifted.lu();
    // No component is left out by symmetry.
    let mut x = DVector::from_fn(n, |i, _| C64::new(1.0 + 0.1 * i as f64, 0.3));
    for _ in 0..3 {
        if let Some(next) = lu.solve(&x).filter(|next| next.iter().all(nalgebra::ComplexField::is_finite)) {
            let length = next.norm();
            x = next / C64::from(length);
        }
    }
    let length = x.norm();
    x / C64::from(length)
}

/// A number with a real and an imaginary part, to 32 digits.
type Pair = [DoubleDouble; 2];

fn pair(value: C64) -> Pair {
    [DoubleDouble::from_f64(value.re), DoubleDouble::from_f64(value.im)]
}

/// The eigenvalue to some 28 digits, rounded; nothing where Newton's method does not lead to one beside the first value.
fn refined(a: &Wide, rounded: &DMatrix<f64>, first: C64, vector: &DVector<C64>, size: f64) -> Option<C64> {
    let n = vector.len();
    let mut value = pair(first);
    let mut x: Vec<Pair> = vector.iter().map(|x| pair(*x)).collect();
    let bordered = DMatrix::from_fn(n + 1, n + 1, |i, j| match (i < n, j < n) {
        (true, true) => C64::from(rounded[(i, j)]) - if i == j { first } else { C64::from(0.0) },
        (true, false) => -vector[i],
        (false, true) => vector[j].conj(),
        (false, false) => C64::from(0.0),
    });
    let lu = bordered.lu();
    let mut last = f64::INFINITY;
    for _ in 0..REFINEMENTS {
        let left =
            DVector::from_fn(n + 1, |i, _| if i < n { -left_of(&a.rows[i], value, &x, i) } else { C64::from(0.0) });
        let change = lu.solve(&left)?;
        if !change.iter().all(nalgebra::ComplexField::is_finite) {
            return None;
        }
        let add = |to: &mut Pair, by: C64| {
            to[0] = to[0] + DoubleDouble::from_f64(by.re);
            to[1] = to[1] + DoubleDouble::from_f64(by.im);
        };
        x.iter_mut().zip(change.iter()).for_each(|(x, by)| add(x, *by));
        add(&mut value, change[n]);
        last = change[n].norm();
        if last <= 1e-26 * size {
            break;
        }
    }
    let value = C64::new(value[0].hi(), value[1].hi());
    (last <= 1e-18 * size && (value - first).norm() <= NEAR * size).then_some(value)
}

/// A row of A x − λ x.
fn left_of(row: &[DoubleDouble], value: Pair, x: &[Pair], at: usize) -> C64 {
    let sum = |part: usize| row.iter().zip(x).fold(DoubleDouble::int(0), |sum, (a, x)| sum + *a * x[part]);
    let [re, im] = [sum(0), sum(1)];
    let re = re - (value[0] * x[at][0] - value[1] * x[at][1]);
    let im = im - (value[0] * x[at][1] + value[1] * x[at][0]);
    C64::new(re.hi(), im.hi())
}
