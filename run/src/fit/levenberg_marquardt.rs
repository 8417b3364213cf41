//! Least squares of nonlinear residuals within bounds, by the method of Levenberg and Marquardt.
//!
//! The damping is that of H. B. Nielsen, "Damping parameter in Marquardt's method" (IMM, Technical University of
//! Denmark, 1999). Each unknown is scaled by the largest norm that its column of the Jacobian has had (J. J. Moré, "The
//! Levenberg–Marquardt algorithm: implementation and theory", Lecture Notes in Mathematics 630 (1978) 105–116). An
//! unknown at a bound stays there as long as the gradient pushes it outwards (D. P. Bertsekas, "Projected Newton
//! methods for optimization problems with simple constraints", SIAM J. Control and Optimization 20 (1982) 221–246).

use crate::Error;
use nalgebra::{DMatrix, DVector};
use std::ops::RangeInclusive;
use tripos_linear::SingularValues;

/// Relative change of the sum of squares, and of the scaled unknowns, below which the search ends.
const CLOSE: f64 = 1e-10;
/// Damping at the first step, relative to the scaled squares of the columns.
const DAMPING: f64 = 1e-3;
/// Damping above which no step lowers the sum of squares.
const MOST_DAMPING: f64 = 1e16;

/// Residuals with their Jacobian, which has a row for each residual and a column for each unknown.
pub type WithJacobian = (DVector<f64>, DMatrix<f64>);

/// Residuals as functions of the unknowns, with their Jacobian.
pub trait Residuals {
    /// Residuals at the given unknowns. `None` if they do not exist there, so that the search takes a shorter step.
    ///
    /// # Errors
    /// [`Error`] if the search has to end, such as for an interruption.
    fn residuals(&mut self, x: &[f64]) -> Result<Option<DVector<f64>>, Error>;

    /// Residuals and their Jacobian at the given unknowns.
    ///
    /// # Errors
    /// [`Error`] if there are no residuals or no derivatives.
    fn with_jacobian(&mut self, x: &[f64]) -> Result<WithJacobian, Error>;
}

/// Unknowns that minimize the sum of squares of residuals.
pub struct Minimum {
    /// Values of the unknowns.
    pub x: Vec<f64>,
    /// Jacobian of the residuals at these values.
    pub jacobian: DMatrix<f64>,
    /// Number of steps that lowered the sum of squares.
    pub steps: usize,
    /// True if the search came to an end by itself, false if it used up its steps.
    pub has_converged: bool,
}

/// Minimizes the sum of squares of residuals, from a start within the bounds, in at most `most_steps` steps.
///
/// # Errors
/// [`Error`] if the residuals do not exist at the start or their sum of squares overflows, or if the search has to end.
pub fn minimize(
    residuals: &mut dyn Residuals,
    start: &[f64],
    bounds: &[RangeInclusive<f64>],
    most_steps: usize,
) -> Result<Minimum, Error> {
    let within = |x: f64, at: usize| x.clamp(*bounds[at].start(), *bounds[at].end());
    let mut x: Vec<f64> = start.iter().enumerate().map(|(at, x)| within(*x, at)).collect();
    let (mut r, mut j) = residuals.with_jacobian(&x)?;
    if !(r.norm_squared().is_finite() && j.norm_squared().is_finite()) {
        let help = "look for measured values that are far off, and for standard deviations that are too small";
        return Err(Error::request("the sum of the squares of the residuals is too large for a number", help));
    }
    let mut scale: Vec<f64> = vec![0.0; x.len()];
    let (mut damping, mut growth, mut steps) = (DAMPING, 2.0, 0);
    let mut has_converged = x.is_empty();
    for _ in 0..most_steps {
        if has_converged {
            break;
        }
        let gradient = j.tr_mul(&r);
        let is_free = |at: usize| {
            let outwards = -gradient[at];
            !(x[at] <= *bounds[at].start() && outwards < 0.0 || x[at] >= *bounds[at].end() && outwards > 0.0)
        };
        let free: Vec<usize> = (0..x.len()).filter(|at| is_free(*at)).collect();
        for (scale, column) in scale.iter_mut().zip(j.column_iter()) {
            *scale = scale.max(column.norm());
        }
        let cost = r.norm_squared();
        if free.iter().all(|at| gradient[*at].abs() <= CLOSE * scale[*at] * cost.sqrt()) {
            has_converged = true;
            break;
        }
        let step = damped_step(&j, &r, &free, &scale, damping);
        let next: Vec<f64> =
            x.iter().zip(step.iter()).enumerate().map(|(at, (x, step))| within(x + step, at)).collect();
        let moved = DVector::from_iterator(x.len(), next.iter().zip(&x).map(|(next, x)| next - x));
        let is_small =
            moved.iter().zip(&x).zip(&scale).all(|((moved, x), scale)| {
                *scale == 0.0 || moved.abs() <= CLOSE * x.abs().max(f64::MIN_POSITIVE.sqrt())
            });
        let predicted = cost - (&r + &j * &moved).norm_squared();
        let found = residuals.residuals(&next)?;
        let found = found.filter(|found| found.iter().all(|x| x.is_finite()));
        let lowered = found.as_ref().map_or(f64::NEG_INFINITY, |found| cost - found.norm_squared());
        let is_lower = lowered > 0.0 && lowered >= 1e-4 * predicted;
        // A step without derivatives at its end counts as too long.
        let there = if is_lower { derivatives_at(residuals, &next)? } else { None };
        // Short steps and small gains tell the end of the search only if damping does not cause them.
        let is_undamped = damping <= DAMPING;
        if let Some(there) = there {
            has_converged = is_undamped && (is_small || lowered <= CLOSE * cost);
            x = next;
            (r, j) = there;
            steps += 1;
            let ratio = if predicted > 0.0 { lowered / predicted } else { 1.0 };
            damping *= (1.0 - (2.0 * ratio - 1.0).powi(3)).max(1.0 / 3.0);
            growth = 2.0;
        } else {
            has_converged = is_undamped && is_small || damping > MOST_DAMPING;
            damping *= growth;
            growth *= 2.0;
        }
    }
    Ok(Minimum { x, jacobian: j, steps, has_converged })
}

/// Residuals with their Jacobian. `None` if they have no finite values or no derivatives.
///
/// # Errors
/// [`Error::Interrupted`] if the search is interrupted.
fn derivatives_at(residuals: &mut dyn Residuals, x: &[f64]) -> Result<Option<WithJacobian>, Error> {
    match residuals.with_jacobian(x) {
        Ok((r, j)) => Ok((r.norm_squared().is_finite() && j.norm_squared().is_finite()).then_some((r, j))),
        Err(Error::Interrupted) => Err(Error::Interrupted),
        Err(_) => Ok(None),
    }
}

/// Step δ of the free unknowns that minimizes |r + J δ|² + λ |D δ|² with the damping λ and the scales D. Other unknowns
/// do not move.
fn damped_step(j: &DMatrix<f64>, r: &DVector<f64>, free: &[usize], scale: &[f64], damping: f64) -> DVector<f64> {
    let rows = j.nrows();
    let root = damping.sqrt();
    // In unknowns D δ, all columns have similar sizes.
    let of = |at: usize| if scale[at] > 0.0 { scale[at] } else { 1.0 };
    let mut whole = DMatrix::zeros(rows + free.len(), free.len());
    for (column, at) in free.iter().enumerate() {
        for row in 0..rows {
            whole[(row, column)] = j[(row, *at)] / of(*at);
        }
        whole[(rows + column, column)] = root;
    }
    let mut side = DVector::zeros(rows + free.len());
    side.rows_mut(0, rows).copy_from(&-r);
    let qr = whole.qr();
    qr.q_tr_mul(&mut side);
    let scaled = SingularValues::new(&qr.r()).solve(&side.rows(0, free.len()).into_owned(), 0.0);
    let mut step = DVector::zeros(scale.len());
    for (value, at) in scaled.iter().zip(free) {
        step[*at] = value / of(*at);
    }
    step
}
