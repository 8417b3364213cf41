//! Eigenvalues of small matrices in 32 digits, with their multiplicity, their growth, and the shares of the states in
//! them.
//!
//! Rounding splits an eigenvalue of multiplicity k by the k-th root of the rounding. Eigenvalues count as one if the
//! symmetric functions of their differences are zero, compared with rounding. These functions are the coefficients of
//! the characteristic polynomial of the eigenvalues' part of the Schur form. That part without its eigenvalue is
//! nilpotent: its powers tell whether solutions are bounded or grow like a power of t (F. R. Gantmacher, *The Theory of
//! Matrices*, chapter VIII; J. H. Wilkinson, *The Algebraic Eigenvalue Problem*, 1965, chapter 2). A quantity that is
//! neither clearly 0 nor clearly different from 0 is reported as undecided.

use super::complex::Complex;
use super::dense::Wide;
use super::schur::Schur;
use crate::Error;
use nalgebra::DMatrix;
use tripos_traits::{DoubleDouble, Scalar};

/// Multiple of its rounding up to which a quantity is 0.
const ZERO: f64 = 1e3;
/// Multiple of its rounding from which a quantity is not 0.
const NOT_ZERO: f64 = 1e7;
/// Relative error of the entries of a matrix whose eigenvalues are found.
const DIGITS: f64 = 1e-27;
/// Ratio to the size of the matrix below which an entry is rounding alone.
const NOTHING: f64 = 1e-24;
/// Largest distance of k eigenvalues that may coincide, as a multiple of the k-th root of the least size that is
/// clearly not 0.
const APART: f64 = 3.0;

/// Eigenvalue with its error, its multiplicity, and the shares of the states in it.
#[derive(Clone, Debug)]
pub struct Mode {
    /// Real and imaginary part of the eigenvalue, 1/s. A part that cannot be told from 0 is 0.
    pub value: [f64; 2],
    /// Factor by which an error of the matrix may grow in the eigenvalue: the size of the projector onto its vectors.
    /// For a simple eigenvalue this is 1/|yᴴ x| with its left and right vectors y and x of length 1. It is 1 at best,
    /// and large near values that nearly coincide.
    pub condition: f64,
    /// Largest error that the eigenvalue may have, 1/s.
    pub error: f64,
    /// Share of each state in the eigenvalue: |y_k x_k|, scaled to the sum 1.
    pub shares: Vec<f64>,
    /// Number of eigenvalues that coincide with this one, itself included.
    pub multiplicity: usize,
    /// Power of t by which solutions grow in addition to e^(λ t). It is 0 if the eigenvalue has as many vectors as its
    /// multiplicity, and k − 1 if its largest Jordan block has k rows.
    pub power: usize,
    /// Number of independent eigenvectors of the eigenvalue.
    pub vectors: usize,
    /// True if the digits do not tell whether the real part is 0. Also true if it is 0 and they do not tell whether the
    /// eigenvalue coincides with others.
    pub is_undecided: bool,
}

impl Mode {
    /// True if solutions of this mode grow exponentially.
    #[must_use]
    pub fn grows(&self) -> bool {
        self.value[0] > 0.0
    }

    /// True if the real part of the eigenvalue is 0.
    #[must_use]
    pub fn is_neutral(&self) -> bool {
        self.value[0].abs() <= 0.0
    }
}

/// Eigenvalues of a square matrix, those with the largest real part first. The entries of the matrix are known to 27
/// digits, and may have a further error of `uncertain` times the size of the matrix.
///
/// # Errors
/// [`Error::Stopped`] if the eigenvalues are not found.
pub fn modes(a: &Wide, uncertain: f64) -> Result<Vec<Mode>, Error> {
    if a.rows.is_empty() {
        return Ok(Vec::new());
    }
    let (scaled, noise) = balanced(a, uncertain);
    let none = || Error::Stopped("the eigenvalues of this matrix were not found".to_owned());
    let form = Schur::new(&scaled).ok_or_else(none)?;
    let size = scaled.rounded().norm().max(f64::MIN_POSITIVE);
    let spectrum = Spectrum { values: form.eigenvalues(), form, noise, size };
    let groups = spectrum.groups();
    let mut list = in_pairs(groups.iter().map(|group| spectrum.mode(group)).collect());
    list.sort_by(|a, b| b.value[0].total_cmp(&a.value[0]).then(b.value[1].total_cmp(&a.value[1])));
    Ok(list.into_iter().flat_map(|mode| std::iter::repeat_n(mode.clone(), mode.multiplicity)).collect())
}

/// Makes modes exact pairs: eigenvalues below the real axis mirror those above it, to the last digit.
fn in_pairs(modes: Vec<Mode>) -> Vec<Mode> {
    let count = |is_side: fn(f64) -> bool| -> usize {
        modes.iter().filter(|mode| is_side(mode.value[1])).map(|mode| mode.multiplicity).sum()
    };
    if count(|im| im > 0.0) != count(|im| im < 0.0) {
        return modes;
    }
    let mut list: Vec<Mode> = modes.into_iter().filter(|mode| mode.value[1] >= 0.0).collect();
    for at in 0..list.len() {
        let Mode { value: [re, im], .. } = list[at];
        if im > 0.0 {
            let below = Mode { value: [re, -im], ..list[at].clone() };
            list.push(below);
        }
    }
    list
}

/// Similar matrix whose rows and columns have comparable sizes, scaled by powers of two, and its possible error (B. N.
/// Parlett & C. Reinsch, Numer. Math. 13, 1969). Entries that are not clearly larger than their uncertainty do not
/// count in the scaling.
fn balanced(a: &Wide, uncertain: f64) -> (Wide, f64) {
    let rounded = a.rounded();
    let (size, off) = (rounded.norm(), uncertain * rounded.norm());
    let counts = |x: f64| x.abs() > NOTHING * size && x.abs() > NOT_ZERO * off;
    let mut sizes = rounded.map(|x| if counts(x) { x } else { 0.0 });
    let scales = nalgebra::linalg::balancing::balance_parlett_reinsch(&mut sizes);
    let mut scaled = a.clone();
    scaled.rows.iter_mut().flatten().filter(|x| x.hi().abs() <= NOTHING * size).for_each(|x| *x = DoubleDouble::int(0));
    let mut noise = DMatrix::zeros(scales.len(), scales.len());
    for (i, row) in scaled.rows.iter_mut().enumerate() {
        for (j, entry) in row.iter_mut().enumerate() {
            let scale = scales[j] / scales[i];
            *entry = *entry * DoubleDouble::from_f64(scale);
            noise[(i, j)] = DIGITS * entry.hi().abs() + off * scale;
        }
    }
    (scaled, noise.norm())
}

/// Eigenvalues that coincide, by their indices on the diagonal of the Schur form.
struct Group {
    places: Vec<usize>,
    is_undecided: bool,
}

/// Decision whether a quantity is 0, by its size compared with its rounding.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Size {
    Zero,
    Undecided,
    NotZero,
}

impl Size {
    /// Decides whether the size `x` of a quantity is 0, for its rounding.
    fn of(x: f64, rounding: f64) -> Self {
        if x <= ZERO * rounding {
            Self::Zero
        } else if x >= NOT_ZERO * rounding {
            Self::NotZero
        } else {
            Self::Undecided
        }
    }

    /// Decision about the larger of two quantities.
    fn most(self, other: Self) -> Self {
        match (self, other) {
            (Self::NotZero, _) | (_, Self::NotZero) => Self::NotZero,
            (Self::Undecided, _) | (_, Self::Undecided) => Self::Undecided,
            _ => Self::Zero,
        }
    }
}

/// Schur form of a matrix, with the data that sort its eigenvalues into groups that coincide.
struct Spectrum {
    form: Schur,
    values: Vec<Complex>,
    /// Possible error of the matrix, by its norm.
    noise: f64,
    /// Norm of the matrix.
    size: f64,
}

impl Spectrum {
    /// Sorts the eigenvalues into groups that coincide, the largest groups first.
    fn groups(&self) -> Vec<Group> {
        let n = self.values.len();
        let mut left: Vec<usize> = (0..n).collect();
        let mut doubtful = vec![false; n];
        let mut groups = Vec::new();
        for many in (2..=n).rev() {
            let reach = APART * self.size * (NOT_ZERO * self.noise / self.size).min(1.0).powf(1.0 / many as f64);
            for places in self.linked(&left, reach) {
                if places.len() < 2 {
                    continue;
                }
                match self.coincide(&places) {
                    Size::Zero => {
                        left.retain(|at| !places.contains(at));
                        groups.push(Group { places, is_undecided: false });
                    }
                    Size::Undecided => places.iter().for_each(|at| doubtful[*at] = true),
                    Size::NotZero => {}
                }
            }
        }
        groups.extend(left.into_iter().map(|at| Group { places: vec![at], is_undecided: doubtful[at] }));
        groups
    }

    /// Sorts eigenvalues into groups that are linked by chains with steps up to `reach`.
    fn linked(&self, among: &[usize], reach: f64) -> Vec<Vec<usize>> {
        let mut left = among.to_vec();
        let mut chains = Vec::new();
        while let Some(first) = left.pop() {
            let mut chain = vec![first];
            let mut next = 0;
            while next < chain.len() {
                let from = self.values[chain[next]];
                let (near, far) = left.iter().partition(|at| (self.values[**at] - from).norm() <= reach);
                (left, next) = (far, next + 1);
                let near: Vec<usize> = near;
                chain.extend(near);
            }
            chains.push(chain);
        }
        chains
    }

    /// Decides whether eigenvalues coincide: the symmetric functions of their distances from the mean are 0.
    fn coincide(&self, places: &[usize]) -> Size {
        let part = Part::new(&self.form.with_first(places), places.len());
        // Coefficients of the product of all (s − λ + mean), and coefficients of the product of all (s + |λ − mean|),
        // which are no smaller.
        let mut coefficients = vec![Complex::from_f64(1.0)];
        for (at, row) in part.nilpotent.iter().enumerate() {
            coefficients.push(Complex::default());
            for k in (1..coefficients.len()).rev() {
                coefficients[k] = coefficients[k] - row[at] * coefficients[k - 1];
            }
        }
        let length = part.norm().max(self.noise);
        let mut ways = 1.0;
        let mut most = Size::Zero;
        for (k, coefficient) in coefficients.iter().enumerate().skip(1) {
            ways *= (part.nilpotent.len() + 1 - k) as f64 / k as f64;
            let rounding = ways * self.noise * length.powi(i32::try_from(k).unwrap_or(i32::MAX) - 1);
            // The smallest positive number is the least rounding that tells anything.
            most = most.most(Size::of(coefficient.norm(), rounding.max(f64::MIN_POSITIVE)));
        }
        most
    }

    /// Makes the mode of a group of eigenvalues that coincide.
    fn mode(&self, group: &Group) -> Mode {
        let form = self.form.with_first(&group.places);
        let many = group.places.len();
        let part = Part::new(&form, many);
        let (norm, shares) = projector(&form, many, self.noise.max(f64::MIN_POSITIVE));
        let condition = norm / (many as f64).sqrt();
        let off = self.noise * condition;
        let parts = [part.mean.re, part.mean.im].map(|x| (x.hi(), Size::of(x.hi().abs(), off)));
        let clean = |(x, size): (f64, Size)| if size == Size::Zero { 0.0 } else { x };
        let value = [clean(parts[0]), clean(parts[1])];
        let (power, power_is_sure) = part.power(off);
        let (rank, rank_is_sure) = part.rank(off);
        // An eigenvalue whose real part is not 0 decays or grows, whatever it coincides with.
        let is_undecided = match parts[0].1 {
            Size::Zero => group.is_undecided || !power_is_sure || !rank_is_sure,
            Size::Undecided => true,
            Size::NotZero => false,
        };
        Mode {
            value,
            condition,
            error: (ZERO * off).max(f64::EPSILON * part.mean.norm()).min(self.size),
            shares,
            multiplicity: many,
            power,
            vectors: many - rank,
            is_undecided,
        }
    }
}

/// Part of a Schur form that belongs to eigenvalues that coincide.
struct Part {
    /// Mean of the eigenvalues.
    mean: Complex,
    /// Block of the Schur form, less the mean on its diagonal.
    nilpotent: Vec<Vec<Complex>>,
}

impl Part {
    /// Takes the block of the first `many` rows and columns of a Schur form.
    fn new(form: &Schur, many: usize) -> Self {
        let sum = (0..many).fold(Complex::default(), |sum, at| sum + form.t[at][at]);
        let mean = sum.scaled(DoubleDouble::int(1) / DoubleDouble::from_f64(many as f64));
        let mut nilpotent: Vec<Vec<Complex>> = form.t[..many].iter().map(|row| row[..many].to_vec()).collect();
        for (at, row) in nilpotent.iter_mut().enumerate() {
            row[at] = row[at] - mean;
        }
        Self { mean, nilpotent }
    }

    /// Frobenius norm of the nilpotent part.
    fn norm(&self) -> f64 {
        norm(&self.nilpotent)
    }

    /// Largest exponent with which a power of the nilpotent part is not 0, and true if that is sure. Entries may have
    /// the error `off`.
    fn power(&self, off: f64) -> (usize, bool) {
        let many = self.nilpotent.len();
        let length = self.norm().max(off);
        let mut product = self.nilpotent.clone();
        let mut is_sure = true;
        for power in 1..many {
            let rounding = power as f64 * off * length.powi(i32::try_from(power).unwrap_or(i32::MAX) - 1);
            match Size::of(norm(&product), rounding.max(f64::MIN_POSITIVE)) {
                Size::Zero => return (power - 1, is_sure),
                Size::Undecided => is_sure = false,
                Size::NotZero => {}
            }
            product = times(&product, &self.nilpotent);
        }
        (many - 1, is_sure)
    }

    /// Rank of the nilpotent part, by elimination with the largest pivots, and true if the rank is sure. Entries may
    /// have the error `off`.
    fn rank(&self, off: f64) -> (usize, bool) {
        let mut left = self.nilpotent.clone();
        for rank in 0..left.len() {
            let places = (rank..left.len()).flat_map(|i| (rank..left.len()).map(move |j| (i, j)));
            let largest = places.max_by(|a, b| left[a.0][a.1].norm().total_cmp(&left[b.0][b.1].norm()));
            let Some((row, column)) = largest else { return (rank, true) };
            match Size::of(left[row][column].norm(), off.max(f64::MIN_POSITIVE)) {
                Size::NotZero => {}
                other => return (rank, other == Size::Zero),
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
fn norm(matrix: &[Vec<Complex>]) -> f64 {
    matrix.iter().flatten().map(|x| x.norm()).fold(0.0, f64::hypot)
}

/// Product of two square matrices.
fn times(a: &[Vec<Complex>], b: &[Vec<Complex>]) -> Vec<Vec<Complex>> {
    let entry = |row: &[Complex], j: usize| row.iter().zip(b).fold(Complex::default(), |sum, (x, y)| sum + *x * y[j]);
    a.iter().map(|row| (0..b.len()).map(|j| entry(row, j)).collect()).collect()
}

/// Norm of the projector P onto the vectors of the first eigenvalues of a Schur form, along those of the others. Also
/// returns the shares |P_kk| of the states, scaled to the sum 1.
///
/// P = Q (1 Z; 0 0) Qᴴ with T₁₁ Z − Z T₂₂ = T₁₂, which is solved column by column. Differences of eigenvalues count as
/// at least `noise`.
fn projector(form: &Schur, many: usize, noise: f64) -> (f64, Vec<f64>) {
    let (t, n) = (&form.t, form.t.len());
    let mut z: Vec<Vec<Complex>> = vec![Vec::with_capacity(n - many); many];
    for column in many..n {
        let mut right: Vec<Complex> = (0..many).map(|row| t[row][column]).collect();
        for (row, right) in right.iter_mut().enumerate() {
            for (k, known) in z[row].iter().enumerate() {
                *right = *right + *known * t[many + k][column];
            }
        }
        for row in (0..many).rev() {
            let solved = (row + 1..many).fold(right[row], |sum, k| sum - t[row][k] * right[k]);
            let difference = t[row][row] - t[column][column];
            right[row] = solved / if difference.norm() > noise { difference } else { Complex::from_f64(noise) };
        }
        z.iter_mut().zip(right).for_each(|(row, x)| row.push(x));
    }
    let of_state = |q: &Vec<Complex>| {
        let left = |a: usize| z[a].iter().zip(&q[many..]).fold(q[a].conj(), |sum, (z, q)| sum + *z * q.conj());
        (0..many).fold(Complex::default(), |sum, a| sum + q[a] * left(a)).norm()
    };
    let parts: Vec<f64> = form.q.iter().map(of_state).collect();
    let whole: f64 = parts.iter().sum();
    let size = norm(&z).hypot((many as f64).sqrt());
    (size, parts.iter().map(|part| part / whole).collect())
}
