//! Standard errors and correlations of fitted unknowns, and what data do not tell.

use nalgebra::{DMatrix, DVector};
use tripos_linear::SingularValues;

/// Part of a unit vector of scaled unknowns above which an unknown counts as part of an untold combination.
const PART: f64 = 1e-3;

/// Uncertainty of unknowns from the Jacobian of residuals whose standard deviation is 1.
pub struct Uncertainty {
    /// Standard error of each unknown. `None` for an unknown that the data do not determine.
    pub errors: Vec<Option<f64>>,
    /// Correlation of each pair of unknowns, from −1 to 1; 0 for undetermined unknowns.
    pub correlations: Vec<Vec<f64>>,
    /// Directions in which the unknowns can move without a change of any residual: in each, a rate for each unknown,
    /// the largest of size 1.
    pub untold: Vec<Vec<f64>>,
}

/// Solution of linear least squares, with its uncertainty.
pub struct LinearSolution {
    /// Unknowns that minimize the sum of squares. Along untold directions they are nearest to the guess.
    pub x: DVector<f64>,
    /// Uncertainty of the unknowns, if the residuals have the standard deviation 1.
    pub uncertainty: Uncertainty,
}

/// Matrix with columns of length 1, and the decomposition of its triangular factor.
struct ScaledColumns {
    /// Lengths of the columns; 1 for a column of zeros.
    scale: Vec<f64>,
    /// Singular values of the scaled columns.
    parts: SingularValues,
    /// Singular values up to this one count as zero.
    least: f64,
}

impl ScaledColumns {
    /// Scales the columns of a triangular factor, and decomposes it. Singular values below the fraction `tiny` of the
    /// largest one count as zero.
    fn new(triangle: &DMatrix<f64>, tiny: f64) -> Self {
        let mut scaled = triangle.clone();
        let mut scale = Vec::with_capacity(scaled.ncols());
        for mut column in scaled.column_iter_mut() {
            let length = column.norm();
            let length = if length > 0.0 { length } else { 1.0 };
            column /= length;
            scale.push(length);
        }
        let parts = SingularValues::new(&scaled);
        let least = tiny * parts.values.iter().fold(0.0_f64, |most, x| most.max(*x));
        Self { scale, parts, least }
    }

    /// Uncertainty of the unknowns. `sizes` are the sizes that count as a whole change of each unknown.
    fn uncertainty(&self, sizes: &[f64]) -> Uncertainty {
        let n = self.scale.len();
        let mut covariance = DMatrix::<f64>::zeros(n, n);
        let mut is_told = vec![true; n];
        let mut untold = Vec::new();
        for (k, value) in self.parts.values.iter().enumerate() {
            let direction = self.parts.right.row(k);
            if *value > self.least {
                for i in 0..n {
                    for j in 0..n {
                        covariance[(i, j)] +=
                            direction[i] * direction[j] / (value * value * self.scale[i] * self.scale[j]);
                    }
                }
                continue;
            }
            let relative = (0..n).map(|i| direction[i] / self.scale[i] / sizes[i]).collect();
            for (told, part) in is_told.iter_mut().zip(direction.iter()) {
                *told &= part.abs() <= PART;
            }
            untold.push(relative);
        }
        reduce_rows(&mut untold);
        for direction in &mut untold {
            direction.iter_mut().zip(sizes).for_each(|(x, size)| *x *= size);
            let most = direction.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
            for x in direction.iter_mut() {
                *x /= most.max(f64::MIN_POSITIVE);
            }
        }
        let deviation: Vec<f64> = (0..n).map(|i| covariance[(i, i)].sqrt()).collect();
        let correlation = |i: usize, j: usize| {
            let is_known = is_told[i] && is_told[j] && deviation[i] > 0.0 && deviation[j] > 0.0;
            if is_known { covariance[(i, j)] / (deviation[i] * deviation[j]) } else { 0.0 }
        };
        Uncertainty {
            errors: (0..n).map(|i| is_told[i].then_some(deviation[i])).collect(),
            correlations: (0..n).map(|i| (0..n).map(|j| correlation(i, j)).collect()).collect(),
            untold,
        }
    }
}

/// Combines directions so that each has an unknown of its own, which no other has, at the rate 1. Rates below [`PART`]
/// become 0.
fn reduce_rows(rows: &mut [Vec<f64>]) {
    let columns = rows.first().map_or(0, Vec::len);
    for at in 0..rows.len() {
        let largest = (0..columns).max_by(|a, b| rows[at][*a].abs().total_cmp(&rows[at][*b].abs())).unwrap_or(0);
        let pivot = rows[at][largest];
        if pivot == 0.0 {
            continue;
        }
        rows[at].iter_mut().for_each(|x| *x /= pivot);
        let own = rows[at].clone();
        for (_, other) in rows.iter_mut().enumerate().filter(|(k, _)| *k != at) {
            let factor = other[largest];
            other.iter_mut().zip(&own).for_each(|(x, own)| *x -= factor * own);
        }
    }
    rows.iter_mut().flatten().filter(|x| x.abs() <= PART).for_each(|x| *x = 0.0);
}

/// Triangular factor of a matrix, with the right-hand side in its axes. A matrix with fewer rows than columns is
/// returned unchanged.
fn triangle(matrix: DMatrix<f64>, mut side: DVector<f64>) -> (DMatrix<f64>, DVector<f64>) {
    if matrix.nrows() <= matrix.ncols() {
        return (matrix, side);
    }
    let columns = matrix.ncols();
    let qr = matrix.qr();
    qr.q_tr_mul(&mut side);
    (qr.r(), side.rows(0, columns).into_owned())
}

/// Uncertainty of unknowns from the Jacobian of residuals of standard deviation 1. `sizes` are the sizes of the
/// unknowns. Directions whose effect is below the fraction `tiny` of the largest one count as untold.
pub fn uncertainty_of_jacobian(jacobian: &DMatrix<f64>, sizes: &[f64], tiny: f64) -> Uncertainty {
    let (triangle, _) = triangle(jacobian.clone(), DVector::zeros(jacobian.nrows()));
    ScaledColumns::new(&triangle, tiny).uncertainty(sizes)
}

/// Minimizes |A x − b| for residuals of standard deviation 1. Directions whose effect is below the fraction `tiny` of
/// the largest one count as untold. Along these, x is nearest to `guess`.
pub fn solve_linear_least_squares(
    a: &DMatrix<f64>,
    b: &DVector<f64>,
    guess: &DVector<f64>,
    tiny: f64,
) -> LinearSolution {
    let (triangle, side) = triangle(a.clone(), b - a * guess);
    let scaled = ScaledColumns::new(&triangle, tiny);
    let mut x = scaled.parts.solve(&side, scaled.least);
    for ((x, scale), guess) in x.iter_mut().zip(&scaled.scale).zip(guess.iter()) {
        *x = guess + *x / scale;
    }
    let sizes: Vec<f64> = scaled.scale.iter().map(|scale| 1.0 / scale).collect();
    LinearSolution { x, uncertainty: scaled.uncertainty(&sizes) }
}
