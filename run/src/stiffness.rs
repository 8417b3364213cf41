//! Whether stability, not accuracy, keeps the steps of an explicit run short, and what an implicit method makes of it.
//!
//! A step h of an explicit method is stable up to some |h λ|, λ an eigenvalue of the Jacobian; where steps are so long on
//! average, stability may be what decides them. Whether it does is asked of the motion itself: Radau's method runs it at the
//! same tolerances with a part of the steps, and either arrives or does not. So what is said is measured, and of a motion
//! that needs its steps nothing is said.

use crate::error::{Error, refused};
use crate::how::{method, options_of_ends};
use crate::problem::Problem;
use tripos_derive::scene::QUADRATURE;
use tripos_sim::{Eliminated, Method, Options, Output, RightHandSide, Solution, Stop};

/// Steps of a run from which on it is asked: fewer take no time.
const MANY_STEPS: u64 = 2_000;
/// |h λ| on average from which on stability may decide. The bounds along the negative axis are 2.8 (rk4), 3.3 (dopri5),
/// 6.1 (dop853) and more of Taylor's method: E. Hairer, S. P. Nørsett & G. Wanner, *Solving Ordinary Differential
/// Equations*, §IV.2 of volume II.
const NEAR_BOUND: f64 = 2.0;
/// How many times fewer steps the implicit method must take, and is given.
const FEWER: u64 = 10;
/// How many times less it must cost.
const CHEAPER: u64 = 2;
/// States of a run at which its largest eigenvalue is estimated; iterations that find its direction, and that measure it.
const SAMPLES: usize = 20;
const TURNS: usize = 10;
const MEASURED: usize = 30;

/// What to say of a run whose steps stability keeps short; nothing if it does not, if that cannot be told without a
/// Jacobian, or if an implicit method would not be better.
///
/// # Errors
/// [`Error`] if the problem cannot be run as its scene says.
pub fn advice(problem: &Problem<'_>, solution: &Solution) -> Result<Option<String>, Error> {
    let how = &problem.scene.integration;
    let is_asked = how.method != QUADRATURE && how.step.is_none() && solution.steps >= MANY_STEPS;
    if !is_asked || method(&how.method)?.needs_jacobian() || solution.stop == Stop::Interrupted {
        return Ok(None);
    }
    let Some(product) = mean_product(problem, solution).filter(|product| *product > NEAR_BOUND) else {
        return Ok(None);
    };
    let Some((end, implicit)) = measured(problem, solution)? else { return Ok(None) };
    let done = if solution.stop == Stop::End { String::new() } else { format!(" to t = {} s", solution.t_end) };
    let arrived = if solution.t_end.total_cmp(&end).is_eq() { String::new() } else { format!(" to t = {end} s") };
    Ok(Some(format!(
        "explicit steps are limited by stability here, not by accuracy: {} steps of {}{done}, with |h λ| = {product:.1} on \
         average; radau5 takes {} at the same tolerances{arrived}",
        solution.steps, how.method, implicit.steps
    )))
}

/// The largest |λ| of the Jacobian times the length of a step, on average over the run: (1/steps) ∫ |λ| dt.
fn mean_product(problem: &Problem<'_>, solution: &Solution) -> Option<f64> {
    let mut rhs = Eliminated::new(problem.system(), &problem.scene.parameters)?;
    let every = solution.y.len().div_ceil(SAMPLES).max(1);
    let samples = solution.t.iter().zip(&solution.y).step_by(every);
    let radii: Vec<f64> = samples.filter_map(|(t, y)| spectral_radius(&mut rhs, *t, y)).collect();
    let step = (solution.t_end - problem.scene.span.0).abs() / solution.steps as f64;
    (!radii.is_empty()).then(|| step * radii.iter().sum::<f64>() / radii.len() as f64)
}

/// The largest |λ| of the Jacobian at a state, 1/s, by the mean growth of a vector that it is applied to again and again:
/// it need not be real.
fn spectral_radius(rhs: &mut Eliminated<'_>, t: f64, y: &[f64]) -> Option<f64> {
    let n = y.len();
    // What is all algebra has no rates.
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

/// This motion by Radau's method, and where it ends: where the run did, or where it was to end if its steps were used
/// up. Nothing if that does not arrive, by far fewer steps and by less work.
fn measured(problem: &Problem<'_>, solution: &Solution) -> Result<Option<(f64, Solution)>, Error> {
    let scene = problem.scene;
    let is_given_up = matches!(solution.stop, Stop::StepLimit { .. });
    let end = if is_given_up { scene.span.1 } else { solution.t_end };
    let options = Options {
        method: Method::Radau5,
        step_limit: solution.steps / FEWER,
        output: Output::Ends,
        ..options_of_ends(scene)?
    };
    let run = problem.integrate_over((scene.span.0, end), &problem.start()?, &options, &mut []);
    let run = run.map_err(|error| refused(scene, &error))?;
    // A Jacobian is counted as if it were made by columns.
    let spent = run.evaluations + run.jacobians * run.y_end.len() as u64;
    Ok((run.stop == Stop::End && CHEAPER * spent <= solution.evaluations).then_some((end, run)))
}
