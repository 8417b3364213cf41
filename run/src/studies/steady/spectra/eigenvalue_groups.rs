//! Groups of eigenvalues that coincide.
//!
//! Rounding splits an eigenvalue of multiplicity k by the k-th root of the rounding error. So two
//! questions are asked about each set of eigenvalues.
//!
//! First, do they coincide? They do if the symmetric functions of their differences are zero up to
//! rounding. These functions are the coefficients of the characteristic polynomial of their part of
//! the Schur form.
//!
//! Second, is the set separate from the other eigenvalues? It is if no error of the matrix moves an
//! eigenvalue across a circle around the set. This holds if `‖E‖ ‖(A − z)⁻¹‖ < 1` on the circle, for
//! an error E of the matrix A. Source: L. N. Trefethen & M. Embree, *Spectra and Pseudospectra*, 2005,
//! chapter 52.

use super::mode::Mode;
use super::nilpotent_part::{NOT_ZERO, NilpotentPart, ZERO, ZeroDecision, spectral_projector};
use super::schur_form::SchurForm;
use super::wide_complex::WideComplex;

/// Number of points on a circle around eigenvalues at which the inverse of A − z is computed. A is the
/// matrix.
const AROUND: usize = 8;
/// Largest number of radii, besides the first, that are tried for a circle around eigenvalues.
const CIRCLES: usize = 4;

/// Group of eigenvalues that coincide, or that cannot be separated because of errors of the matrix.
#[derive(Clone, Debug)]
pub(in crate::studies::steady) struct EigenvalueGroup {
    /// Indices of the eigenvalues of the group on the diagonal of the Schur form.
    places: Vec<usize>,
    /// Mean of the eigenvalues of the group.
    mean: WideComplex,
    /// Possible error of the mean, in absolute value.
    off: f64,
    /// Centre and radius of a circle that the eigenvalues of the group do not leave. `None` if no other
    /// eigenvalue can coincide with them.
    doubt: Option<(WideComplex, f64)>,
}

impl EigenvalueGroup {
    /// Computes the modes of this group: one mode for the group, or one mode for each eigenvalue if it is
    /// uncertain which eigenvalues coincide. `form` is the Schur form of the whole matrix, `noise` its
    /// possible error, and `size` its norm.
    pub(in crate::studies::steady) fn modes(&self, form: &SchurForm, noise: f64, size: f64) -> Vec<Mode> {
        if let (Some(_), true) = (self.doubt, self.places.len() > 1) {
            let single = |at: &usize| Self { places: vec![*at], mean: form.t[*at][*at], ..self.clone() };
            return self.places.iter().flat_map(|at| single(at).modes(form, noise, size)).collect();
        }
        let form = form.with_eigenvalues_first(&self.places);
        let many = self.places.len();
        let part = NilpotentPart::new(&form, many);
        let (norm, shares) = spectral_projector(&form, many, noise.max(f64::MIN_POSITIVE));
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
            // An eigenvalue whose real part is surely not 0 surely decays or grows, even if it may coincide
            // with others.
            let is_undecided = centre.re.hi().abs() <= radius || centre.re.hi() * raw[0] <= 0.0;
            return vec![mode(raw, radius + (self.mean - centre).norm(), is_undecided)];
        }
        let off = noise * condition;
        let [re, im] = raw.map(|x| ZeroDecision::decide_zero(x.abs(), self.off));
        let clean = |x: f64, size: ZeroDecision| if size == ZeroDecision::Zero { 0.0 } else { x };
        let (power, power_is_sure) = part.largest_nonzero_power(off);
        let (rank, rank_is_sure) = part.rank(off);
        let is_undecided = match re {
            ZeroDecision::Zero => !power_is_sure || !rank_is_sure,
            ZeroDecision::Undecided => true,
            ZeroDecision::NotZero => false,
        };
        let value = [clean(raw[0], re), clean(raw[1], im)];
        vec![Mode { power, vectors: many - rank, ..mode(value, ZERO * self.off, is_undecided) }]
    }
}

/// Joins groups from separate blocks of a matrix if their means are equal within their errors.
pub(in crate::studies::steady) fn unite_groups(groups: Vec<EigenvalueGroup>) -> Vec<EigenvalueGroup> {
    let mut list: Vec<EigenvalueGroup> = Vec::new();
    for mut group in groups {
        let mut apart = Vec::new();
        for other in list {
            let between = (group.mean - other.mean).norm();
            let off = (group.off + other.off).max(f64::MIN_POSITIVE);
            let reach =
                |group: &EigenvalueGroup| group.doubt.map_or(0.0, |(centre, r)| r + (group.mean - centre).norm());
            let far = reach(&group) + reach(&other);
            if between > far + NOT_ZERO * off {
                apart.push(other);
                continue;
            }
            let is_same = far <= 0.0 && between <= off;
            let radius = far + between + NOT_ZERO * off;
            let doubt = if is_same { None } else { Some((group.mean, radius)) };
            let places = [other.places, group.places].concat();
            group = EigenvalueGroup { places, mean: group.mean, off: group.off.max(other.off), doubt };
        }
        apart.push(group);
        list = apart;
    }
    list
}

/// Eigenvalues of a matrix, with its Schur form, that are not yet sorted into groups.
pub(in crate::studies::steady) struct UngroupedSpectrum<'f> {
    /// Schur form of the matrix.
    pub(in crate::studies::steady) form: &'f SchurForm,
    /// Eigenvalues, in the order of the diagonal of the Schur form.
    pub(in crate::studies::steady) values: Vec<WideComplex>,
    /// Norm of the possible error of the matrix.
    pub(in crate::studies::steady) noise: f64,
    /// Frobenius norm of the matrix.
    pub(in crate::studies::steady) size: f64,
}

impl UngroupedSpectrum<'_> {
    /// Sorts the eigenvalues into groups that coincide. `first` is added to the indices of the eigenvalues.
    ///
    /// A set of eigenvalues that do not coincide is split at its largest gap. Eigenvalues that an error of
    /// the matrix may mix with others are in doubt. They stay in the smallest circle across which no error
    /// moves an eigenvalue.
    pub(in crate::studies::steady) fn groups(&self, first: usize) -> Vec<EigenvalueGroup> {
        let all: Vec<usize> = (0..self.values.len()).collect();
        let mut groups = Vec::new();
        let mut sets = vec![(all, (WideComplex::default(), self.size))];
        while let Some((places, within)) = sets.pop() {
            let part = NilpotentPart::new(&self.form.with_eigenvalues_first(&places), places.len());
            let circle = self.separating_radius(&places, part.mean).map(|radius| (part.mean, radius));
            let off = self.noise * self.mean_condition(&places);
            let is_one = places.len() == 1 || (circle.is_some() && part.coincides(off));
            if is_one {
                let doubt = if circle.is_some() { None } else { Some(within) };
                let places = places.iter().map(|at| first + at).collect();
                groups.push(EigenvalueGroup { places, mean: part.mean, off, doubt });
            } else {
                sets.extend(self.split_at_largest_gap(&places).map(|places| (places, circle.unwrap_or(within))));
            }
        }
        groups
    }

    /// Factor from an error of the matrix to the error of the mean of some eigenvalues. `places` are the
    /// indices of these eigenvalues.
    fn mean_condition(&self, places: &[usize]) -> f64 {
        let many = places.len();
        let (norm, _) =
            spectral_projector(&self.form.with_eigenvalues_first(places), many, self.noise.max(f64::MIN_POSITIVE));
        norm / (many as f64).sqrt()
    }

    /// Splits a set of eigenvalues in two at its largest gap. This gap is the longest link of the shortest
    /// tree that connects them.
    fn split_at_largest_gap(&self, places: &[usize]) -> [Vec<usize>; 2] {
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

    /// Finds the radius of a circle around the mean of eigenvalues, across which no error of the matrix
    /// moves an eigenvalue. `None` if no such circle is found.
    fn separating_radius(&self, places: &[usize], mean: WideComplex) -> Option<f64> {
        let distance = |at: &usize| (self.values[*at] - mean).norm();
        let inner = places.iter().map(distance).fold(0.0, f64::max);
        let others = (0..self.values.len()).filter(|at| !places.contains(at));
        let outer = others.map(|at| distance(&at)).fold(f64::INFINITY, f64::min);
        let error = NOT_ZERO * self.noise;
        if outer.is_infinite() {
            // No eigenvalue moves by more than the size of the matrix and its error.
            return Some(2.0 * self.size + error);
        }
        let inner = inner.max(error.min(0.5 * outer));
        let share = |k: usize| (2 * k + 1) as f64 / (2 * CIRCLES) as f64;
        let radii = [0.5].into_iter().chain((0..CIRCLES).map(share)).map(|x| inner * (outer / inner).powf(x));
        let is_barrier = |radius: &f64| {
            let points = (0..AROUND).map(|k| std::f64::consts::TAU * k as f64 / AROUND as f64);
            let mut points = points.map(|angle| mean + WideComplex::polar(*radius, angle));
            inner < outer && points.all(|z| error * self.resolvent_norm(z) < 1.0)
        };
        radii.into_iter().find(is_barrier)
    }

    /// Frobenius norm of (T − z)⁻¹, where T is the upper triangular Schur form. It is infinite if z is an
    /// eigenvalue.
    fn resolvent_norm(&self, z: WideComplex) -> f64 {
        let (t, n) = (&self.form.t, self.form.t.len());
        let one = WideComplex::from_f64(1.0);
        let mut all = 0.0_f64;
        for column in 0..n {
            let mut x = vec![WideComplex::default(); column + 1];
            x[column] = one / (t[column][column] - z);
            for row in (0..column).rev() {
                let sum = (row + 1..=column).fold(WideComplex::default(), |sum, k| sum + t[row][k] * x[k]);
                x[row] = -sum / (t[row][row] - z);
            }
            all = x.iter().fold(all, |all, x| all.hypot(x.norm()));
        }
        if all.is_nan() { f64::INFINITY } else { all }
    }
}
