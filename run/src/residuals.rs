//! How far a run is from its constraints.

use crate::problem::Problem;
use tripos_derive::scene::Loops;
use tripos_sim::Solution;

/// By what part of what it is made of a loop may be open that follows from others: they amplify what is left of these.
const MAY_OPEN: f64 = 1e-6;
/// What a constraint may be open by rounding, over what it is made of.
const ROUNDING: f64 = 1e-12;

/// A constraint that a run is kept on.
#[derive(Clone, Debug, PartialEq)]
pub struct Residual {
    /// What it is called: the name in the file, with a prime if it is the rate of a loop.
    pub name: String,
    /// The largest in size over the samples, with its sign, in the unit of the constraint.
    pub largest: f64,
}

/// The constraints of a problem, over the samples of its solution.
pub fn residuals(problem: &Problem<'_>, solution: &Solution) -> Vec<Residual> {
    let system = problem.system();
    let count = system.constraint_count();
    let mut largest = vec![0.0_f64; count];
    let mut values = vec![0.0; count];
    for y in solution.y.iter().chain([&solution.y_end]) {
        let (q, v) = y.split_at(system.lengths().coordinates);
        system.constraints(&problem.scene.parameters, q, v, &mut values);
        for (most, value) in largest.iter_mut().zip(&values) {
            // What is not a number stays.
            if value.is_nan() || value.abs() > most.abs() {
                *most = *value;
            }
        }
    }
    let named = |(at, largest)| Residual { name: system.constraint_name(at).to_owned(), largest };
    let following = following(problem, solution).into_iter().map(|(residual, _)| residual);
    largest.into_iter().enumerate().map(named).chain(following).collect()
}

/// The loops that are not kept closed, since they follow from the others, each with the largest part of what it is made of by which it
/// is open.
fn following(problem: &Problem<'_>, solution: &Solution) -> Vec<(Residual, f64)> {
    let model = problem.model;
    if model.closed.is_empty() {
        return Vec::new();
    }
    let loops = Loops::new(model);
    let mut list: Vec<(Residual, f64)> =
        model.closed.iter().map(|c| (Residual { name: c.name.clone(), largest: 0.0 }, 0.0)).collect();
    for y in solution.y.iter().chain([&solution.y_end]) {
        for ((residual, most), (_, open, part)) in
            list.iter_mut().zip(loops.following(&problem.scene.parameters, &y[..model.coordinates.len()]))
        {
            if part.is_nan() || part > *most {
                (residual.largest, *most) = (open, part);
            }
        }
    }
    list
}

/// The objections to a run in which a loop opens that is to follow from the others.
pub fn opened(problem: &Problem<'_>, solution: &Solution) -> impl Iterator<Item = String> {
    following(problem, solution).into_iter().filter(|(_, part)| part.is_nan() || *part > MAY_OPEN).map(|(residual, _)| {
        format!(
            "the loop `{}`, which is to follow from the others wherever they are closed, opens by {:.1e}: at these values it does \
             not, or not along the whole way, and this is not the motion of the mechanism",
            residual.name,
            residual.largest.abs()
        )
    })
}

/// The objection to a run that could not be kept on its constraints: where it is off them by more than its tolerance. Corrections that rounding decides do not
/// matter.
pub fn broken(problem: &Problem<'_>, solution: &Solution) -> Option<String> {
    let report = solution.projection.as_ref().filter(|_| problem.system().constraint_count() > 0)?;
    let left = report.singular + report.not_converged;
    let is_off = || solution.y.iter().chain([&solution.y_end]).any(|y| is_off(problem, y));
    (left > 0 && is_off()).then(|| {
        format!(
            "after {left} steps the state could not be moved back onto the constraints: they are dependent there, or the steps \
             are far too long"
        )
    })
}

/// Whether a state is off a constraint by more than its tolerance, over the sum of the sizes of what the constraint is made of.
fn is_off(problem: &Problem<'_>, y: &[f64]) -> bool {
    let (system, p, how) = (problem.system(), &problem.scene.parameters, &problem.scene.integration);
    let count = system.constraint_count();
    let (mut values, mut slopes) = (vec![0.0; count], vec![0.0; count * y.len()]);
    let (q, v) = y.split_at(system.lengths().coordinates);
    system.constraints(p, q, v, &mut values);
    system.constraint_slopes(p, q, v, &mut slopes);
    let allowed = if how.step.is_some() { ROUNDING } else { how.rtol.max(ROUNDING) };
    values.iter().zip(slopes.chunks_exact(y.len().max(1))).any(|(value, row)| {
        let size: f64 = row.iter().zip(y).map(|(slope, y)| (slope * y).abs().max(slope.abs())).sum();
        // What is not a number is off.
        value.is_nan() || value.abs() > allowed * size
    })
}
