//! Residuals of the constraints along a run, and objections to large residuals.

use crate::preparation::problem::Problem;
use tripos_derive::plain_text::with_significant_digits;
use tripos_derive::scene::{DependentLoop, Loops};
use tripos_sim::Solution;

/// Gap up to which a redundant loop counts as closed, relative to the sizes of the loop's terms.
/// Redundant loops amplify the residuals of the other loops.
const MAY_OPEN: f64 = 1e-6;
/// Residual of a constraint that rounding can cause, relative to the sum of the sizes of its terms.
const ROUNDING: f64 = 1e-12;

/// Largest residual of one constraint along a run.
#[derive(Clone, Debug, PartialEq)]
pub struct Residual {
    /// Name of the constraint in the model file. A prime follows if the constraint is the rate of a
    /// loop.
    pub name: String,
    /// Largest residual over the samples, with its sign, in the unit of the constraint.
    pub largest: f64,
}

/// Largest residual of each constraint over the samples of a run. The enforced constraints come first,
/// then the redundant loops.
pub fn constraint_residuals(problem: &Problem<'_>, solution: &Solution) -> Vec<Residual> {
    let system = problem.system();
    let count = system.constraint_count();
    let mut largest = vec![0.0_f64; count];
    let mut values = vec![0.0; count];
    for y in solution.y.iter().chain([&solution.y_end]) {
        let (q, v) = y.split_at(system.lengths().coordinates);
        system.constraints(&problem.scene.parameters, q, v, &mut values);
        for (most, value) in largest.iter_mut().zip(&values) {
            // A NaN replaces any number and is never replaced.
            if value.is_nan() || value.abs() > most.abs() {
                *most = *value;
            }
        }
    }
    let named = |(at, largest)| Residual { name: system.constraint_name(at).to_owned(), largest };
    let following = redundant_loop_residuals(problem, solution).into_iter().map(|(residual, _)| residual);
    largest.into_iter().enumerate().map(named).chain(following).collect()
}

/// Largest residual of each redundant loop along a run, which does not enforce these loops. The second
/// value of each pair is the largest gap relative to the sizes of the loop's terms.
fn redundant_loop_residuals(problem: &Problem<'_>, solution: &Solution) -> Vec<(Residual, f64)> {
    let model = problem.model;
    if model.closed.is_empty() {
        return Vec::new();
    }
    let loops = Loops::new(model);
    let mut list: Vec<(Residual, f64)> =
        model.closed.iter().map(|c| (Residual { name: c.name.clone(), largest: 0.0 }, 0.0)).collect();
    for y in solution.y.iter().chain([&solution.y_end]) {
        for ((residual, most), DependentLoop { residual: open, part, .. }) in
            list.iter_mut().zip(loops.redundant_residuals(&problem.scene.parameters, &y[..model.coordinates.len()]))
        {
            if part.is_nan() || part > *most {
                (residual.largest, *most) = (open, part);
            }
        }
    }
    list
}

/// Objections to redundant loops that open in a run, one for each loop whose relative gap exceeds
/// 1e-6.
pub fn opened_loop_objections(problem: &Problem<'_>, solution: &Solution) -> impl Iterator<Item = String> {
    redundant_loop_residuals(problem, solution).into_iter().filter(|(_, part)| part.is_nan() || *part > MAY_OPEN).map(|(residual, _)| {
        format!(
            "the loop `{}`, which is to follow from the others wherever they are closed, opens by {}: at these values it does \
             not, or not along the whole way, and this is not the motion of the mechanism",
            residual.name,
            with_significant_digits(residual.largest.abs(), 2)
        )
    })
}

/// Objection to a run that left its constraints: corrections failed, and a residual exceeds its
/// tolerance. `None` if no correction failed, or if all residuals are within tolerance or rounding.
pub fn broken_constraint_objection(problem: &Problem<'_>, solution: &Solution) -> Option<String> {
    let publication = solution.projection.as_ref().filter(|_| problem.system().constraint_count() > 0)?;
    let left = publication.singular + publication.not_converged;
    let is_off = || solution.y.iter().chain([&solution.y_end]).any(|y| has_excess_residual(problem, y));
    (left > 0 && is_off()).then(|| {
        format!(
            "after {left} steps the state could not be moved back onto the constraints: they are dependent there, or the steps \
             are far too long"
        )
    })
}

/// True if the residual of a constraint at the state `y` exceeds the tolerance times the sizes of the
/// constraint's terms.
fn has_excess_residual(problem: &Problem<'_>, y: &[f64]) -> bool {
    let (system, p, how) = (problem.system(), &problem.scene.parameters, &problem.scene.integration);
    let count = system.constraint_count();
    let (mut values, mut slopes) = (vec![0.0; count], vec![0.0; count * y.len()]);
    let (q, v) = y.split_at(system.lengths().coordinates);
    system.constraints(p, q, v, &mut values);
    system.constraint_slopes(p, q, v, &mut slopes);
    let allowed = if how.step.is_some() { ROUNDING } else { how.rtol.max(ROUNDING) };
    values.iter().zip(slopes.chunks_exact(y.len().max(1))).any(|(value, row)| {
        let size: f64 = row.iter().zip(y).map(|(slope, y)| (slope * y).abs().max(slope.abs())).sum();
        // A residual that is not a number counts as exceeded.
        value.is_nan() || value.abs() > allowed * size
    })
}
