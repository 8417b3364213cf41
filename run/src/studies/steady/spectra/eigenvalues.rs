//! Eigenvalues of small matrices in 32 digits, with their multiplicity, the growth of solutions, and
//! the share of each state.
//!
//! Eigenvalues that coincide form groups ([`super::eigenvalue_groups`]). The nilpotent part of a group
//! tells how solutions grow ([`super::nilpotent_part`]). Entries of a matrix that are exactly 0 have no
//! error. They split the states into blocks, so that states of different blocks do not act on each
//! other both ways. The eigenvalues of each block are computed separately, and have only the error of
//! their own block.

use super::eigenvalue_groups::{UngroupedSpectrum, unite_groups};
use super::mode::Mode;
use super::nilpotent_part::NOT_ZERO;
use super::schur_form::SchurForm;
use super::wide_matrix::WideMatrix;
use crate::Error;
use nalgebra::Complex as Double;
use nalgebra::DMatrix;
use tripos_linear::singular_values;
use tripos_traits::{DoubleDouble, Scalar};

/// Relative error that the entries of a matrix are assumed to have.
const DIGITS: f64 = 1e-27;
/// Fraction of the size of a matrix up to which an entry counts as a rounding error.
const NOTHING: f64 = 1e-24;
/// Rounding error of a computation in double precision, relative to the size of the matrix.
const IN_DOUBLES: f64 = 1e-12;

/// Computes the eigenvalues of a square matrix, sorted by real part with the largest first. The entries
/// are known to 27 digits. They may have a further error of `uncertain` times the norm of the matrix.
///
/// # Errors
/// [`Error::Stopped`] if the eigenvalues cannot be computed.
pub fn eigenvalue_modes(a: &WideMatrix, uncertain: f64) -> Result<Vec<Mode>, Error> {
    if a.rows.is_empty() {
        return Ok(Vec::new());
    }
    let (scaled, noise) = balance_matrix(a, uncertain);
    let blocks = if uncertain > 0.0 { vec![(0..a.rows.len()).collect()] } else { coupled_state_blocks(a) };
    let none = || Error::Stopped("the eigenvalues of this matrix were not found".to_owned());
    let mut forms = Vec::with_capacity(blocks.len());
    let mut groups = Vec::new();
    for block in &blocks {
        let part = scaled.submatrix(block, block);
        let form = SchurForm::new(&part).ok_or_else(none)?;
        let noise = noise.select_rows(block).select_columns(block).norm();
        let size = part.rounded().norm().max(f64::MIN_POSITIVE);
        let first = forms.iter().map(|form: &SchurForm| form.t.len()).sum();
        groups.extend(UngroupedSpectrum { values: form.eigenvalues(), form: &form, noise, size }.groups(first));
        forms.push(form);
    }
    let size = scaled.rounded().norm().max(f64::MIN_POSITIVE);
    let form = SchurForm::from_diagonal_blocks(&scaled, &blocks, &forms);
    let noise = noise.norm();
    let mut list: Vec<Mode> = unite_groups(groups).iter().flat_map(|group| group.modes(&form, noise, size)).collect();
    if !eigenvalues_fit_matrix(&scaled, noise, &list) {
        for mode in &mut list {
            mode.is_undecided = true;
        }
    }
    let mut list = exact_conjugate_pairs(list);
    list.sort_by(|a, b| b.value[0].total_cmp(&a.value[0]).then(b.value[1].total_cmp(&a.value[1])));
    Ok(list.into_iter().flat_map(|mode| std::iter::repeat_n(mode.clone(), mode.multiplicity)).collect())
}

/// True if eigenvalues fit their matrix within their errors and the error `noise` of the matrix. Their
/// sum must be the trace, and their product the determinant. A − λ must be singular for each eigenvalue
/// λ.
fn eigenvalues_fit_matrix(a: &WideMatrix, noise: f64, list: &[Mode]) -> bool {
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
    // An error in one row changes the determinant by at most this error times the sizes of the other
    // rows.
    let sizes: Vec<f64> = rounded.row_iter().map(|row| row.norm() + noise).collect();
    let others = |row: usize| (0..n).filter(|at| *at != row).map(|at| sizes[at]).product::<f64>();
    let by_noise: f64 = (0..n).map(|row| noise * others(row)).sum();
    let off_product = (most - product.norm()).max(0.0) + IN_DOUBLES * most + by_noise;
    let is_product = !most.is_finite() || (product - determinant(a)).norm() <= off_product + f64::MIN_POSITIVE;
    let is_root = |mode: &Mode| {
        let eigenvalue = value(mode);
        let real = &rounded - DMatrix::identity(n, n) * eigenvalue.re;
        // The real matrix [Re, −Im; Im, Re] has each singular value of the complex one twice.
        let mut both = DMatrix::zeros(2 * n, 2 * n);
        both.view_mut((0, 0), (n, n)).copy_from(&real);
        both.view_mut((n, n), (n, n)).copy_from(&real);
        both.view_mut((0, n), (n, n)).fill_diagonal(eigenvalue.im);
        both.view_mut((n, 0), (n, n)).fill_diagonal(-eigenvalue.im);
        singular_values(&both).min() <= mode.error + off
    };
    all().count() == n && is_sum && is_product && list.iter().all(is_root)
}

/// Computes the determinant of a square matrix in 32 digits, by Gaussian elimination with row pivots.
/// The result is rounded to a double.
fn determinant(a: &WideMatrix) -> f64 {
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

/// Splits states into sets, by the entries of a matrix that are not exactly 0. All states of a set act
/// on one another, directly or through others. The sets are ordered so that no set acts on a later set.
fn coupled_state_blocks(a: &WideMatrix) -> Vec<Vec<usize>> {
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

/// Replaces the eigenvalues below the real axis by exact mirror images of the eigenvalues above it.
/// Returns the list unchanged if there are not as many below as above.
fn exact_conjugate_pairs(modes: Vec<Mode>) -> Vec<Mode> {
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

/// Scales a matrix by powers of two to a similar matrix with rows and columns of comparable sizes. Also
/// returns the possible error of each entry. Entries that are not clearly larger than their uncertainty
/// are ignored in the scaling. Source: B. N. Parlett & C. Reinsch, Numer. Math. 13, 1969.
fn balance_matrix(a: &WideMatrix, uncertain: f64) -> (WideMatrix, DMatrix<f64>) {
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
