//! Advice on stiff runs, in which stability and not accuracy limits the steps.
//!
//! A step h of an explicit method is stable up to a certain |h λ|, where λ is an eigenvalue of the
//! Jacobian. If the steps reach this bound on average, stability may limit them. A trial decides:
//! Radau's implicit method runs the motion at the same tolerances with a fraction of the steps, and
//! either arrives or does not. A motion that needs its short steps for accuracy gets no advice.

use crate::error::{Error, refused_scene_error};
use crate::integration_options::integration_options_for_ends;
use crate::preparation::problem::Problem;
use tripos_derive::plain_text::with_reliable_digits;
use tripos_sim::{EliminatedDynamics, Method, Options, OutputOption, RightHandSide, Solution, Stop};

/// Least number of steps at which a run is examined for stiffness. Shorter runs take little time.
const MANY_STEPS: u64 = 2_000;
/// Average |h λ| from which on stability may limit the steps of an explicit run.
///
/// The bounds along the negative real axis are 2.8 (rk4), 3.3 (dopri5), 6.1 (dop853) and more for
/// Taylor's method. Source: E. Hairer, S. P. Nørsett & G. Wanner, *Solving Ordinary Differential
/// Equations*, §IV.2 of volume II.
const NEAR_BOUND: f64 = 2.0;
/// Factor by which the implicit method must need fewer steps than the explicit run. The trial stops at
/// this number of steps.
const FEWER: u64 = 10;
/// Factor by which the implicit method must need fewer evaluations than the explicit run.
const CHEAPER: u64 = 2;
/// Number of states of a run at which the largest eigenvalue of the Jacobian is estimated.
const SAMPLES: usize = 20;
/// Number of iterations that turn a vector towards the direction of the largest eigenvalue, before this
/// eigenvalue is measured.
const TURNS: usize = 10;
/// Number of iterations over which the size of the largest eigenvalue is measured.
const MEASURED: usize = 30;

/// Advises an implicit method for a run whose steps are limited by stability, with the numbers of steps
/// of both methods. `None` if stability does not limit the steps, if the equations have no Jacobian,
/// or if the implicit method is not much better. Runs with few steps are not examined.
///
/// # Errors
/// [`Error`] if the problem cannot be run as its scene says.
pub fn stiffness_advice(problem: &Problem<'_>, solution: &Solution) -> Result<Option<String>, Error> {
    let how = &problem.scene.integration;
    let is_explicit = how.method.method().is_some_and(|method| !method.needs_jacobian());
    let is_asked = is_explicit && how.step.is_none() && solution.steps >= MANY_STEPS;
    if !is_asked || solution.stop == Stop::Interrupted {
        return Ok(None);
    }
    let Some(product) = mean_stiffness_product(problem, solution).filter(|product| *product > NEAR_BOUND) else {
        return Ok(None);
    };
    let Some((end, implicit)) = measure_implicit_run(problem, solution)? else { return Ok(None) };
    let done = if solution.stop == Stop::End {
        String::new()
    } else {
        format!(" to t = {} s", with_reliable_digits(solution.t_end, None))
    };
    let arrived = if solution.t_end.total_cmp(&end).is_eq() {
        String::new()
    } else {
        format!(" to t = {} s", with_reliable_digits(end, None))
    };
    Ok(Some(format!(
        "explicit steps are limited by stability here, not by accuracy: {} steps of {}{done}, with |h λ| = {product:.1} on \
         average; radau5 takes {} at the same tolerances{arrived}",
        solution.steps, how.method, implicit.steps
    )))
}

/// Average of |h λ| over the steps h of a run, for the eigenvalue λ of the Jacobian with the largest
/// |λ|: (1/steps) ∫ |λ| dt. `None` if the Jacobian cannot be computed at any sample.
fn mean_stiffness_product(problem: &Problem<'_>, solution: &Solution) -> Option<f64> {
    let mut rhs = EliminatedDynamics::new(problem.system(), &problem.scene.parameters)?;
    let every = solution.y.len().div_ceil(SAMPLES).max(1);
    let samples = solution.t.iter().zip(&solution.y).step_by(every);
    let radii: Vec<f64> = samples.filter_map(|(t, y)| spectral_radius(&mut rhs, *t, y)).collect();
    let step = (solution.t_end - problem.scene.span.0).abs() / solution.steps as f64;
    (!radii.is_empty()).then(|| step * radii.iter().sum::<f64>() / radii.len() as f64)
}

/// Absolute value |λ| of the largest eigenvalue of the Jacobian at a state, 1/s. λ may be complex. The
/// value is the mean growth of a vector under repeated multiplication by the Jacobian. `None` if it
/// cannot be computed.
fn spectral_radius(rhs: &mut EliminatedDynamics<'_>, t: f64, y: &[f64]) -> Option<f64> {
    let n = y.len();
    // Purely algebraic equations have no integrated state.
    if n == 0 {
        return None;
    }
    let mut jacobian = vec![0.0; n * n];
    rhs.jacobian(t, y, &mut jacobian)?.ok()?;
    let mut w: Vec<f64> = (0..n).map(|i| 1.0 + i as f64 / 10.0).collect();
    let mut growth = 0.0;
    for turn in 0..TURNS + MEASURED {
        let image: Vec<f64> =
            jacobian.chunks_exact(n).map(|row| row.iter().zip(&w).map(|(j, w)| j * w).sum()).collect();
        let length = image.iter().map(|x| x * x).sum::<f64>().sqrt();
        if !(length.is_finite() && length > 0.0) {
            return None;
        }
        if turn >= TURNS {
            growth += length.ln();
        }
        w = image.into_iter().map(|x| x / length).collect();
    }
    Some((growth / MEASURED as f64).exp())
}

/// Runs the motion of a problem by Radau's method, up to the end of the given run. If the given run used
/// up its steps, the end of the span is taken instead. Returns this end, s, and the solution. `None`
/// unless Radau's method arrives with far fewer steps and less work.
fn measure_implicit_run(problem: &Problem<'_>, solution: &Solution) -> Result<Option<(f64, Solution)>, Error> {
    let scene = problem.scene;
    let is_given_up = matches!(solution.stop, Stop::StepLimit { .. });
    let end = if is_given_up { scene.span.1 } else { solution.t_end };
    let options = Options {
        method: Method::Radau5,
        step_limit: solution.steps / FEWER,
        output: OutputOption::Ends,
        ..integration_options_for_ends(scene)
    };
    let run = problem.integrate_over((scene.span.0, end), &problem.start()?, &options, &mut []);
    let run = run.map_err(|error| refused_scene_error(scene, &error))?;
    // A Jacobian counts as one evaluation for each column, as if computed by differences.
    let spent = run.evaluations + run.jacobians * run.y_end.len() as u64;
    Ok((run.stop == Stop::End && CHEAPER * spent <= solution.evaluations).then_some((end, run)))
}
