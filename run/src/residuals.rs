//! How far a run is from its constraints.

use crate::problem::Problem;
use tripos_sim::Solution;

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
    largest.into_iter().enumerate().map(named).collect()
}

/// The objection to a run that could not be kept on its constraints.
pub fn broken(problem: &Problem<'_>, solution: &Solution) -> Option<String> {
    let report = solution.projection.as_ref().filter(|_| problem.system().constraint_count() > 0)?;
    let left = report.singular + report.not_converged;
    (left > 0).then(|| {
        format!(
            "after {left} steps the state could not be moved back onto the constraints: they are dependent there, or the steps \
             are far too long"
        )
    })
}
