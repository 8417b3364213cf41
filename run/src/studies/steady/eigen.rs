//! Eigenvalues of small matrices in 32 digits, with their multiplicity, their growth, and the shares of the states in
//! them.
//!
//! Rounding splits an eigenvalue of multiplicity k by the k-th root of the rounding. Two questions are therefore asked
//! of each set of eigenvalues. They coincide if the symmetric functions of their differences are zero, compared with
//! rounding. These functions are the coefficients of the characteristic polynomial of the eigenvalues' part of the
//! Schur form. They stay apart from the others if an error of the matrix moves none of them across a circle around the
//! set: ‖E‖ ‖(A − z)⁻¹‖ < 1 on the circle (L. N. Trefethen & M. Embree, *Spectra and Pseudospectra*, 2005, chapter 52).
//! The part of a set that coincides, without its eigenvalue, is nilpotent: its powers tell whether solutions are
//! bounded or grow like a power of t (F. R. Gantmacher, *The Theory of Matrices*, chapter VIII; J. H. Wilkinson, *The
//! Algebraic Eigenvalue Problem*, 1965, chapter 2). A quantity that is neither clearly 0 nor clearly different from 0
//! is reported as undecided.
//!
//! Entries of a matrix that are exactly 0 have no error. States that do not act on one another in a circle are
//! therefore solved for separately, so that each eigenvalue has the error of its own part alone.

use super::complex::Complex;
use super::dense::Wide;
use super::schur::Schur;
use crate::Error;
use nalgebra::{Complex as Double, DMatrix};
use tripos_traits::{DoubleDouble, Scalar};

/// Multiple of its rounding up to which a quantity is 0.
const ZERO: f64 = 1e3;
/// Multiple of its rounding from which a quantity is not 0.
const NOT_ZERO: f64 = 1e7;
/// Relative error of the entries of a matrix whose eigenvalues are found.
const DIGITS: f64 = 1e-27;
/// Ratio to the size of the matrix below which an entry is rounding alone.
const NOTHING: f64 = 1e-24;
/// Fraction of their rounding up to which the coefficients of eigenvalues that coincide are 0. It is smaller than 1,
/// for most entries are known to more than 27 digits, and a coefficient has the square of a difference.
const SAME: f64 = 1e-3;
/// Number of points of a circle around eigenvalues at which the inverse of A − z is computed.
const AROUND: usize = 8;
/// Largest number of circles that are tried around eigenvalues.
const CIRCLES: usize = 4;
/// Rounding of a computation in doubles, relative to the size of the matrix.
const IN_DOUBLES: f64 = 1e-12;

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
    /// eigenvalue coincides with others, and if the eigenvalues do not satisfy the matrix.
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
    let blocks = if uncertain > 0.0 { vec![(0..a.rows.len()).collect()] } else { in_turn(a) };
    let none = || Error::Stopped("the eigenvalues of this matrix were not found".to_owned());
    let mut forms = Vec::with_capacity(blocks.len());
    let mut groups = Vec::new();
    for block in &blocks {
        let part = scaled.part(block, block);
        let form = Schur::new(&part).ok_or_else(none)?;
        let noise = noise.select_rows(block).select_columns(block).norm();
        let size = part.rounded().norm().max(f64::MIN_POSITIVE);
        let first = forms.iter().map(|form: &Schur| form.t.len()).sum();
        groups.extend(Spectrum { values: form.eigenvalues(), form: &form, noise, size }.groups(first));
        forms.push(form);
    }
    let size = scaled.rounded().norm().max(f64::MIN_POSITIVE);
    let form = Schur::together(&scaled, &blocks, &forms);
    let noise = noise.norm();
    let mut list: Vec<Mode> = united(groups).iter().flat_map(|group| group.modes(&form, noise, size)).collect();
    if !satisfy(&scaled, noise, &list) {
        for mode in &mut list {
            mode.is_undecided = true;
        }
    }
    let mut list = in_pairs(list);
    list.sort_by(|a, b| b.value[0].total_cmp(&a.value[0]).then(b.value[1].total_cmp(&a.value[1])));
    Ok(list.into_iter().flat_map(|mode| std::iter::repeat_n(mode.clone(), mode.multiplicity)).collect())
}

/// True if eigenvalues satisfy their matrix within their errors and its own, `noise`: their sum is its trace, their
/// product its determinant, and A − λ is singular for each of them.
fn satisfy(a: &Wide, noise: f64, list: &[Mode]) -> bool {
    let n = a.rows.len();
    let rounded = a.rounded();
    let off = noise + IN_DOUBLES * rounded.norm();
    let all = || list.iter().flat_map(|mode| std::iter::repeat_n(mode, mode.multiplicity));
    let value = |mode: &Mode| Double::new(mode.value[0], mode.value[1]);
    let trace = (0..n).fold(DoubleDouble::int(0), |sum, at| sum + a.rows[at][at]).hi();
    let sum = all().fold(Double::default(), |sum, mode| sum + value(mode));
    let is_sum = (sum - trace).norm() <= all().map(|mode| mode.error).sum::<f64>() + off * n as f64;
    let product = all().fold(Double::new(1.0, 0.0), |product, mode| product * value(mode));
    let most: f64 = all().map(|mode| value(mode).norm() + mode.error).product();
    // An error of one row changes the determinant by at most its product with the sizes of the other rows.
    let sizes: Vec<f64> = rounded.row_iter().map(|row| row.norm() + noise).collect();
    let others = |row: usize| (0..n).filter(|at| *at != row).map(|at| sizes[at]).product::<f64>();
    let by_noise: f64 = (0..n).map(|row| noise * others(row)).sum();
    let off_product = (most - product.norm()).max(0.0) + IN_DOUBLES * most + by_noise;
    let is_product = !most.is_finite() || (product - determinant(a)).norm() <= off_product + f64::MIN_POSITIVE;
    let is_root = |mode: &Mode| {
        let left = rounded.map(|x| Double::new(x, 0.0)) - DMatrix::identity(n, n) * value(mode);
        left.singular_values().min() <= mode.error + off
    };
    all().count() == n && is_sum && is_product && list.iter().all(is_root)
}

/// Determinant of a matrix, by Gauss's elimination with row pivots in 32 digits.
fn determinant(a: &Wide) -> f64 {
    let mut rows = a.rows.clone();
    let mut product = DoubleDouble::int(1);
    for column in 0..rows.len() {
        let pivot = (column..rows.len()).max_by(|i, j| {
            let size = |row: usize| rows[row][column].hi().abs();
            size(*i).total_cmp(&size(*j))
        });
        let Some(pivot) = pivot.filter(|row| rows[*row][column].hi().abs() > 0.0) else { return 0.0 };
        if pivot != column {
            rows.swap(pivot, column);
            product = -product;
        }
        let chosen = rows[column].clone();
        product = product * chosen[column];
        for row in &mut rows[column + 1..] {
            let factor = row[column] / chosen[column];
            row.iter_mut().zip(&chosen).skip(column).for_each(|(x, p)| *x = *x - factor * *p);
        }
    }
    product.hi()
}

/// Sets of states that act on one another in a circle, by the entries of a matrix that are not exactly 0. No set acts
/// on one that comes after it.
fn in_turn(a: &Wide) -> Vec<Vec<usize>> {
    let n = a.rows.len();
    // Entry (i, j) is true if state j acts on state i, directly or through others.
    let mut acts: Vec<Vec<bool>> =
        a.rows.iter().map(|row| row.iter().map(|x| x.hi().abs() > 0.0 || !x.is_finite()).collect()).collect();
    for through in 0..n {
        let from = acts[through].clone();
        for row in acts.iter_mut().filter(|row| row[through]) {
            row.iter_mut().zip(&from).for_each(|(acts, from)| *acts |= *from);
        }
    }
    let mut left: Vec<usize> = (0..n).collect();
    let mut sets = Vec::new();
    while let Some(first) = left.iter().copied().find(|i| left.iter().all(|k| !acts[*k][*i] || acts[*i][*k])) {
        let (set, rest) = left.iter().partition(|k| **k == first || (acts[first][**k] && acts[**k][first]));
        (left, sets) = (rest, [sets, vec![set]].concat());
    }
    sets
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

/// Similar matrix whose rows and columns have comparable sizes, scaled by powers of two, and the possible errors of its
/// entries (B. N. Parlett & C. Reinsch, Numer. Math. 13, 1969). Entries that are not clearly larger than their
/// uncertainty do not count in the scaling.
fn balanced(a: &Wide, uncertain: f64) -> (Wide, DMatrix<f64>) {
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
    (scaled, noise)
}

/// Eigenvalues that coincide, by their indices on the diagonal of the Schur form.
#[derive(Clone, Debug)]
struct Group {
    places: Vec<usize>,
    /// Mean of the eigenvalues.
    mean: Complex,
    /// Possible error of the mean.
    off: f64,
    /// Circle that the eigenvalues of the group do not leave, by its centre and radius, if the group may coincide with
    /// others.
    doubt: Option<(Complex, f64)>,
}

impl Group {
    /// Makes the mode of the group. `form` is the Schur form of the whole matrix, `noise` its possible error, and
    /// `size` its norm. Eigenvalues of a group in doubt have a mode each.
    fn modes(&self, form: &Schur, noise: f64, size: f64) -> Vec<Mode> {
        if let (Some(_), true) = (self.doubt, self.places.len() > 1) {
            let single = |at: &usize| Self { places: vec![*at], mean: form.t[*at][*at], ..self.clone() };
            return self.places.iter().flat_map(|at| single(at).modes(form, noise, size)).collect();
        }
        let form = form.with_first(&self.places);
        let many = self.places.len();
        let part = Part::new(&form, many);
        let (norm, shares) = projector(&form, many, noise.max(f64::MIN_POSITIVE));
        let condition = norm / (many as f64).sqrt();
        let mode = |value, error: f64, is_undecided| Mode {
            value,
            condition,
            error: error.max(f64::EPSILON * self.mean.norm()).min(size),
            shares,
            multiplicity: many,
            power: 0,
            vectors: many,
            is_undecided,
        };
        let raw = [self.mean.re.hi(), self.mean.im.hi()];
        if let Some((centre, radius)) = self.doubt {
            // An eigenvalue whose real part is not 0 decays or grows, whatever it coincides with.
            let is_undecided = centre.re.hi().abs() <= radius || centre.re.hi() * raw[0] <= 0.0;
            return vec![mode(raw, radius + (self.mean - centre).norm(), is_undecided)];
        }
        let off = noise * condition;
        let [re, im] = raw.map(|x| Size::of(x.abs(), self.off));
        let clean = |x: f64, size: Size| if size == Size::Zero { 0.0 } else { x };
        let (power, power_is_sure) = part.power(off);
        let (rank, rank_is_sure) = part.rank(off);
        let is_undecided = match re {
            Size::Zero => !power_is_sure || !rank_is_sure,
            Size::Undecided => true,
            Size::NotZero => false,
        };
        let value = [clean(raw[0], re), clean(raw[1], im)];
        vec![Mode { power, vectors: many - rank, ..mode(value, ZERO * self.off, is_undecided) }]
    }
}

/// Unites groups of separate parts of a matrix whose means are equal, compared with their errors.
fn united(groups: Vec<Group>) -> Vec<Group> {
    let mut list: Vec<Group> = Vec::new();
    for mut group in groups {
        let mut apart = Vec::new();
        for other in list {
            let between = (group.mean - other.mean).norm();
            let off = (group.off + other.off).max(f64::MIN_POSITIVE);
            let reach = |group: &Group| group.doubt.map_or(0.0, |(centre, r)| r + (group.mean - centre).norm());
            let far = reach(&group) + reach(&other);
            if between > far + NOT_ZERO * off {
                apart.push(other);
                continue;
            }
            let is_same = far <= 0.0 && between <= off;
            let radius = far + between + NOT_ZERO * off;
            let doubt = if is_same { None } else { Some((group.mean, radius)) };
            let places = [other.places, group.places].concat();
            group = Group { places, mean: group.mean, off: group.off.max(other.off), doubt };
        }
        apart.push(group);
        list = apart;
    }
    list
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
}

/// Schur form of a matrix, with the data that sort its eigenvalues into groups that coincide.
struct Spectrum<'f> {
    form: &'f Schur,
    values: Vec<Complex>,
    /// Possible error of the matrix, by its norm.
    noise: f64,
    /// Norm of the matrix.
    size: f64,
}

impl Spectrum<'_> {
    /// Sorts the eigenvalues into groups that coincide. `first` is added to their indices.
    ///
    /// Sets of eigenvalues that do not coincide are split at the largest gap. Eigenvalues that an error of the matrix
    /// may mix with others are in doubt; they stay in the smallest circle that no error moves an eigenvalue across.
    fn groups(&self, first: usize) -> Vec<Group> {
        let all: Vec<usize> = (0..self.values.len()).collect();
        let mut groups = Vec::new();
        let mut sets = vec![(all, (Complex::default(), self.size))];
        while let Some((places, within)) = sets.pop() {
            let part = Part::new(&self.form.with_first(&places), places.len());
            let circle = self.circle(&places, part.mean).map(|radius| (part.mean, radius));
            let off = self.noise * self.condition(&places);
            let is_one = places.len() == 1 || (circle.is_some() && part.coincides(off));
            if is_one {
                let doubt = if circle.is_some() { None } else { Some(within) };
                let places = places.iter().map(|at| first + at).collect();
                groups.push(Group { places, mean: part.mean, off, doubt });
            } else {
                sets.extend(self.split(&places).map(|places| (places, circle.unwrap_or(within))));
            }
        }
        groups
    }

    /// Growth of an error of the matrix in the mean of eigenvalues.
    fn condition(&self, places: &[usize]) -> f64 {
        let many = places.len();
        let (norm, _) = projector(&self.form.with_first(places), many, self.noise.max(f64::MIN_POSITIVE));
        norm / (many as f64).sqrt()
    }

    /// Splits eigenvalues at the largest gap: the longest link of the shortest tree that connects them.
    fn split(&self, places: &[usize]) -> [Vec<usize>; 2] {
        let between = |a: usize, b: usize| (self.values[a] - self.values[b]).norm();
        let mut tree = vec![(places[0], places[0], 0.0)];
        let mut left = places[1..].to_vec();
        while !left.is_empty() {
            let links = left.iter().flat_map(|at| tree.iter().map(|(from, _, _)| (*at, *from, between(*at, *from))));
            let Some(link) = links.min_by(|a, b| a.2.total_cmp(&b.2)) else { break };
            left.retain(|at| *at != link.0);
            tree.push(link);
        }
        let longest = tree[1..].iter().max_by(|a, b| a.2.total_cmp(&b.2)).map_or(places[0], |link| link.0);
        let mut far = vec![longest];
        for (at, from, _) in &tree[1..] {
            if far.contains(from) && !far.contains(at) {
                far.push(*at);
            }
        }
        let near = places.iter().copied().filter(|at| !far.contains(at)).collect();
        [near, far]
    }

    /// Radius of a circle around eigenvalues that no error of the matrix moves an eigenvalue across; `None` if none is
    /// found.
    fn circle(&self, places: &[usize], mean: Complex) -> Option<f64> {
        let distance = |at: &usize| (self.values[*at] - mean).norm();
        let inner = places.iter().map(distance).fold(0.0, f64::max);
        let others = (0..self.values.len()).filter(|at| !places.contains(at));
        let outer = others.map(|at| distance(&at)).fold(f64::INFINITY, f64::min);
        let error = NOT_ZERO * self.noise;
        if outer.is_infinite() {
            // All eigenvalues move by less than the size of the matrix and its error.
            return Some(2.0 * self.size + error);
        }
        let inner = inner.max(error.min(0.5 * outer));
        let share = |k: usize| (2 * k + 1) as f64 / (2 * CIRCLES) as f64;
        let radii = [0.5].into_iter().chain((0..CIRCLES).map(share)).map(|x| inner * (outer / inner).powf(x));
        let is_barrier = |radius: &f64| {
            let points = (0..AROUND).map(|k| std::f64::consts::TAU * k as f64 / AROUND as f64);
            let mut points = points.map(|angle| mean + Complex::polar(*radius, angle));
            inner < outer && points.all(|z| error * self.inverse(z) < 1.0)
        };
        radii.into_iter().find(is_barrier)
    }

    /// Frobenius norm of (T − z)⁻¹.
    fn inverse(&self, z: Complex) -> f64 {
        let (t, n) = (&self.form.t, self.form.t.len());
        let one = Complex::from_f64(1.0);
        let mut all = 0.0_f64;
        for column in 0..n {
            let mut x = vec![Complex::default(); column + 1];
            x[column] = one / (t[column][column] - z);
            for row in (0..column).rev() {
                let sum = (row + 1..=column).fold(Complex::default(), |sum, k| sum + t[row][k] * x[k]);
                x[row] = -sum / (t[row][row] - z);
            }
            all = x.iter().fold(all, |all, x| all.hypot(x.norm()));
        }
        if all.is_nan() { f64::INFINITY } else { all }
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

    /// True if eigenvalues coincide: the symmetric functions of their distances from the mean are 0. `off` is the
    /// possible error of the part.
    fn coincides(&self, off: f64) -> bool {
        // Coefficients of the product of all (s − λ + mean), and coefficients of the product of all (s + |λ − mean|),
        // which are no smaller.
        let mut coefficients = vec![Complex::from_f64(1.0)];
        for (at, row) in self.nilpotent.iter().enumerate() {
            coefficients.push(Complex::default());
            for k in (1..coefficients.len()).rev() {
                coefficients[k] = coefficients[k] - row[at] * coefficients[k - 1];
            }
        }
        let length = self.norm().max(off);
        let mut ways = 1.0;
        coefficients.iter().enumerate().skip(1).all(|(k, coefficient)| {
            ways *= (self.nilpotent.len() + 1 - k) as f64 / k as f64;
            let rounding = ways * off * length.powi(i32::try_from(k).unwrap_or(i32::MAX) - 1);
            // The smallest positive number is the least rounding that tells anything.
            coefficient.norm() <= SAME * rounding.max(f64::MIN_POSITIVE)
        })
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
