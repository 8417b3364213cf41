//! Eigenvalues of small matrices in 32 digits, which of them coincide, whether they grow, and which states take part in them.
//!
//! Rounding takes an eigenvalue of k-fold multiplicity apart by a k-th root of what was rounded. Eigenvalues are taken for one where
//! the symmetric functions of their differences vanish beside rounding: the coefficients of the characteristic polynomial of their
//! part of the Schur form. What is left of that part without its eigenvalue is nilpotent: its powers tell whether solutions are
//! bounded or grow like a power of t (F. R. Gantmacher, *The Theory of Matrices*, chapter VIII; J. H. Wilkinson, *The Algebraic
//! Eigenvalue Problem*, 1965, chapter 2). What is neither clearly 0 nor clearly not is said to be undecided.

use super::complex::Complex;
use super::dense::Wide;
use super::schur::Schur;
use crate::Error;
use nalgebra::DMatrix;
use tripos_traits::{DoubleDouble, Scalar};

/// What is below the first of these beside what rounding makes of it is 0; what is above the second is not 0.
const ZERO: f64 = 1e3;
const NOT_ZERO: f64 = 1e7;
/// How far off entries of a matrix are beside their size, and below which part of the size of the matrix an entry is rounding alone.
const DIGITS: f64 = 1e-27;
const NOTHING: f64 = 1e-24;
/// How far apart eigenvalues are looked at that may coincide, over the root of what is not clearly 0.
const APART: f64 = 3.0;

/// An eigenvalue with what it means.
#[derive(Clone, Debug)]
pub struct Mode {
    /// Its real and imaginary part, 1/s; parts that are not told from 0 are 0.
    pub value: [f64; 2],
    /// How much larger an error of the matrix may be in it: the size of the projector onto its vectors, which is 1/|yᴴ x| of its left
    /// and right vectors of length 1 where it is simple. 1 at best, large near values that nearly coincide.
    pub condition: f64,
    /// How far off it may be, 1/s.
    pub error: f64,
    /// How much of it each state has, from 0 to 1 with sum 1: |y_k x_k|.
    pub shares: Vec<f64>,
    /// How many eigenvalues coincide with it, itself among them.
    pub multiplicity: usize,
    /// The power of t by which solutions grow beside e^(λ t): 0 where it has as many vectors as its multiplicity, k − 1 where its
    /// largest Jordan block has k rows.
    pub power: usize,
    /// The number of independent vectors that it has.
    pub vectors: usize,
    /// Whether its digits do not tell if its real part is 0, or, where it is, whether it coincides with others.
    pub is_undecided: bool,
}

impl Mode {
    /// Whether solutions grow with it exponentially.
    #[must_use]
    pub fn grows(&self) -> bool {
        self.value[0] > 0.0
    }

    /// Whether its real part is 0.
    #[must_use]
    pub fn is_neutral(&self) -> bool {
        self.value[0].abs() <= 0.0
    }
}

/// The eigenvalues of a square matrix, those with the largest real part first. Its entries are known to 27 digits, and may be off by a
/// part `uncertain` of the size of the matrix beside.
///
/// # Errors
/// [`Error::Stopped`] if they are not found.
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

/// Modes whose values below the real axis are those above it, to the last digit.
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

/// A similar matrix whose rows and columns are of like sizes, by powers of two (B. N. Parlett & C. Reinsch, Numer. Math. 13, 1969), and by
/// how much it may be off. Entries that are not clear of their uncertainty scale nothing.
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

/// Eigenvalues that are one, by their places on the diagonal.
struct Group {
    places: Vec<usize>,
    is_undecided: bool,
}

/// Whether something is 0, by how large it is beside what rounding makes of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Size {
    Zero,
    Undecided,
    NotZero,
}

impl Size {
    fn of(x: f64, rounding: f64) -> Self {
        if x <= ZERO * rounding {
            Self::Zero
        } else if x >= NOT_ZERO * rounding {
            Self::NotZero
        } else {
            Self::Undecided
        }
    }

    fn most(self, other: Self) -> Self {
        match (self, other) {
            (Self::NotZero, _) | (_, Self::NotZero) => Self::NotZero,
            (Self::Undecided, _) | (_, Self::Undecided) => Self::Undecided,
            _ => Self::Zero,
        }
    }
}

/// A Schur form whose eigenvalues are sorted into such as are one.
struct Spectrum {
    form: Schur,
    values: Vec<Complex>,
    /// How far off entries may be, and the size of the matrix.
    noise: f64,
    size: f64,
}

impl Spectrum {
    /// The eigenvalues in groups of such as coincide, the largest groups first.
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

    /// Eigenvalues that chains link whose steps are shorter than a reach.
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

    /// Whether the symmetric functions of these eigenvalues less their mean are 0, as those of one that is repeated.
    fn coincide(&self, places: &[usize]) -> Size {
        let part = Part::new(&self.form.with_first(places), places.len());
        // Coefficients of the product of all (s − λ + mean), and those of (s + |λ − mean|), which are no smaller.
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
            // Where this is below the smallest numbers nothing is told.
            most = most.most(Size::of(coefficient.norm(), rounding.max(f64::MIN_POSITIVE)));
        }
        most
    }

    /// What eigenvalues that are one mean.
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
        // What dies away or grows for sure does so whatever it coincides with.
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

/// The part of a Schur form that belongs to eigenvalues that are one.
struct Part {
    mean: Complex,
    /// Without the eigenvalue.
    nilpotent: Vec<Vec<Complex>>,
}

impl Part {
    /// The block of the first `many` rows and columns of a Schur form.
    fn new(form: &Schur, many: usize) -> Self {
        let sum = (0..many).fold(Complex::default(), |sum, at| sum + form.t[at][at]);
        let mean = sum.scaled(DoubleDouble::int(1) / DoubleDouble::from_f64(many as f64));
        let mut nilpotent: Vec<Vec<Complex>> = form.t[..many].iter().map(|row| row[..many].to_vec()).collect();
        for (at, row) in nilpotent.iter_mut().enumerate() {
            row[at] = row[at] - mean;
        }
        Self { mean, nilpotent }
    }

    fn norm(&self) -> f64 {
        norm(&self.nilpotent)
    }

    /// The largest power of the nilpotent part that is not 0, and whether that is sure; entries may be off by so much.
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

    /// The rank of the nilpotent part, by elimination with the largest pivots, and whether it is sure.
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

fn norm(matrix: &[Vec<Complex>]) -> f64 {
    matrix.iter().flatten().map(|x| x.norm()).fold(0.0, f64::hypot)
}

fn times(a: &[Vec<Complex>], b: &[Vec<Complex>]) -> Vec<Vec<Complex>> {
    let entry = |row: &[Complex], j: usize| row.iter().zip(b).fold(Complex::default(), |sum, (x, y)| sum + *x * y[j]);
    a.iter().map(|row| (0..b.len()).map(|j| entry(row, j)).collect()).collect()
}

/// The size of the projector P onto the vectors of the first eigenvalues along those of the others, and the shares |P_kk| of the states.
///
/// P = Q (1 Z; 0 0) Qᴴ with T₁₁ Z − Z T₂₂ = T₁₂, which is solved column by column; eigenvalues are no nearer than `noise`.
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
