//! Whether a run can be trusted: what is said of it beside its numbers.
//!
//! Every objection comes with its figure. None is raised by a clock: the same run gives the same objections.

use crate::error::{Error, refused};
use crate::how::method;
use crate::invariants::{Conserved, Excursion, Watch};
use crate::problem::Problem;
use tripos_derive::scene::{QUADRATURE, Scene, Solve};
use tripos_sim::stability::growth;
use tripos_sim::{Eliminated, Method, Options, RightHandSide, Solution, Stop};

/// How many times what the tolerances allow a conserved quantity may change before it can be an objection.
const ALLOWED: f64 = 100.0;
/// How many times it may change before it is one whatever the tolerance, in units of what the allowed error of one
/// step moves it where it is: there are many steps, and they all may err to one side.
const ALLOWED_DRIFT: f64 = 1e4;
/// An integral that moves as if the state erred by this leaves no more than three digits, whatever the tolerance.
const THREE_DIGITS: f64 = 1e-3;
/// What fixed steps are judged by, since they promise no tolerance: three digits, too.
const FIXED: f64 = THREE_DIGITS / ALLOWED_DRIFT;
/// Samples of a run at which matrices are looked at.
const MOST_SAMPLES: usize = 400;
/// Steps after which the growth of errors is not followed further.
const MOST_STEPS: u64 = 100_000;
/// A part of the span at whose end a growth says nothing about the rest.
const LAST_PART: f64 = 0.01;

/// Objections to a run, each with its figure.
///
/// # Errors
/// [`Error::Request`] if the parameters are not those of the equations.
pub fn objections(
    problem: &Problem<'_>,
    solution: &Solution,
    watch: Option<&Watch>,
    energy_drift: f64,
) -> Result<Vec<String>, Error> {
    let mut list: Vec<String> = solution.warnings.iter().map(|w| w.described(&problem.variables())).collect();
    if solution.stop == Stop::Interrupted {
        // Nobody waits for a judgement.
        return Ok(list);
    }
    match watch.filter(|watch| !watch.integrals.is_empty()) {
        Some(watch) => {
            let worst = worst(problem, solution, watch);
            list.extend(worst.iter().filter(|(_, furthest)| is_lost(problem.scene, furthest.ratio)).map(said));
        }
        None => list.extend(energy(problem, solution, energy_drift)),
    }
    list.extend(condition(problem, solution)?);
    // Quadrature has no steps whose errors could grow.
    if problem.scene.integration.method != QUADRATURE {
        list.extend(horizon(problem, solution)?);
        list.extend(stiffness(problem, solution)?);
    }
    Ok(list)
}

/// The objection to a run of equations whose first integrals were not looked for: where nothing but gravity works,
/// total energy is constant.
fn energy(problem: &Problem<'_>, solution: &Solution, drift: f64) -> Option<String> {
    let Problem { model, scene, .. } = *problem;
    if scene.integration.step.is_some() || !(model.forces.is_empty() && model.torques.is_empty()) {
        return None;
    }
    let (system, p) = (problem.system(), scene.parameters.as_slice());
    let n = system.lengths().coordinates;
    let potential = |y: &Vec<f64>| system.potential_energy(p, &y[..n]).abs();
    // What kinetic energy can honestly reach: a run that blows up must not raise its own allowance.
    let start = solution.y.first().unwrap_or(&solution.y_end);
    let first = (system.kinetic_energy(p, &start[..n], &start[n..]) + system.potential_energy(p, &start[..n])).abs();
    let scale = solution.y.iter().fold(first, |m, y| m.max(first + potential(y)));
    let how = &scene.integration;
    let allowed = how.atol.smallest() + how.rtol * scale;
    // A run that ended where energy has no value says so by its stop.
    (drift > ALLOWED * allowed).then(|| {
        format!(
            "total energy, constant in this motion, changed by {drift:.3e} J, {} times what the tolerances allow: do not trust this run",
            times(drift / allowed)
        )
    })
}

/// Whether a first integral that is this many times further from its start than one step's errors can move it tells
/// that digits are lost.
fn is_lost(scene: &Scene, ratio: f64) -> bool {
    let tolerance = if scene.integration.step.is_some() { FIXED } else { scene.integration.rtol };
    ratio > ALLOWED_DRIFT || (ratio > ALLOWED && ratio * tolerance > THREE_DIGITS)
}

/// The error that the tolerances allow in a component.
fn allowance(scene: &Scene, at: usize, value: f64) -> f64 {
    if scene.integration.step.is_some() {
        return FIXED * (1.0 + value.abs());
    }
    let atol = scene.integration.atol.of(at).unwrap_or(0.0);
    // No tolerance makes a number better known than to its rounding.
    (atol + scene.integration.rtol * value.abs()).max(f64::EPSILON * value.abs())
}

/// How many times, in few digits.
fn times(ratio: f64) -> String {
    if ratio < 1e6 { format!("{ratio:.0}") } else { format!("{ratio:.0e}") }
}

/// A first integral, and where it is furthest from its start.
type Worst<'a> = (&'a Conserved, Excursion);

fn worst<'a>(problem: &Problem<'_>, solution: &Solution, watch: &'a Watch) -> Vec<Worst<'a>> {
    let worst = watch.worst(problem, solution, MOST_SAMPLES, &|at, x| allowance(problem.scene, at, x));
    let list = watch.integrals.iter().zip(worst).zip(watch.exist(&problem.shown.parameters));
    list.filter(|(_, exists)| *exists).map(|(found, _)| found).collect()
}

fn said((integral, Excursion { t, change, ratio }): &Worst<'_>) -> String {
    let (name, unit) = (integral.name(), &integral.unit);
    if change.is_nan() {
        return format!("{name}, constant in this motion, has no value at t = {t:.4} s: do not trust this run");
    }
    format!(
        "{name}, constant in this motion, has changed by {change:.3e} {unit} at t = {t:.4} s, {} times what the tolerances allow in a step: do not trust this run",
        times(*ratio)
    )
}

/// States spread evenly over a run, few enough to be looked at closely.
fn spread(solution: &Solution) -> impl Iterator<Item = (f64, &Vec<f64>)> {
    let every = solution.y.len().div_ceil(MOST_SAMPLES).max(1);
    solution.t.iter().copied().zip(&solution.y).step_by(every)
}

/// A numeric solve loses as many digits as its matrix is ill-conditioned.
fn condition(problem: &Problem<'_>, solution: &Solution) -> Result<Option<String>, Error> {
    if problem.solve == Solve::Eliminated {
        return Ok(None);
    }
    let mut dynamics = problem.dynamics().map_err(|error| refused(problem.scene, &error))?;
    let worst = spread(solution)
        .map(|(t, y)| {
            let (q, v) = dynamics.split(y);
            let (q, v) = (q.to_vec(), v.to_vec());
            (t, dynamics.reciprocal_condition(&q, &v))
        })
        .min_by(|a, b| a.1.total_cmp(&b.1));
    let Some((t, rcond)) = worst else { return Ok(None) };
    let lost = f64::EPSILON / rcond.max(f64::MIN_POSITIVE);
    let asked = problem.scene.integration.rtol.max(problem.scene.integration.atol.smallest());
    Ok((lost > asked).then(|| {
        let digits = (-lost.log10()).floor().max(0.0);
        format!(
            "the matrix is ill-conditioned at t = {t} s: equilibrated rcond {rcond:.1e}, so the numeric solve leaves {digits} digits there, less than rtol {:e} asks for{}",
            problem.scene.integration.rtol,
            if problem.system().has_accelerations() { "; eliminated accelerations lose none of them" } else { "" }
        )
    }))
}

/// Steps of a run from which on it is asked whether stability alone keeps them short.
const MANY_STEPS: u64 = 10_000;
/// A step this long times the fastest decay is near the bound of stability of every explicit method here: from 2.8
/// (rk4) to 6 (dop853).
const NEAR_BOUND: f64 = 2.0;
/// States of a run at which its fastest decay is looked for, and iterations that find it.
const STIFF_SAMPLES: usize = 20;
const ITERATIONS: usize = 40;

/// An explicit method whose steps are as long as stability lets them, while the motion would let them be longer.
fn stiffness(problem: &Problem<'_>, solution: &Solution) -> Result<Option<String>, Error> {
    let scene = problem.scene;
    let is_implicit = method(&scene.integration.method)?.needs_jacobian();
    let known = Eliminated::new(problem.system(), &scene.parameters);
    let (Some(mut rhs), false) = (known, is_implicit || solution.steps < MANY_STEPS) else { return Ok(None) };
    let step = (solution.t_end - scene.span.0).abs() / solution.steps as f64;
    let every = solution.y.len().div_ceil(STIFF_SAMPLES).max(1);
    let samples = solution.t.iter().zip(&solution.y).step_by(every);
    let decays: Vec<f64> = samples.filter_map(|(t, y)| fastest_decay(&mut rhs, *t, y)).collect();
    let fast = decays.iter().copied().fold(0.0, f64::max);
    let is_stiff = 2 * decays.len() > STIFF_SAMPLES && step * fast > NEAR_BOUND;
    Ok(is_stiff.then(|| {
        format!(
            "stiff: what decays at {fast:.1e} 1/s keeps the steps of {} at {step:.1e} s on average, however smooth the motion is; the method gauss6 has no such bound",
            scene.integration.method
        )
    }))
}

/// The rate of the fastest decay at a state, 1/s, if the dominant eigenvalue of the Jacobian is real and negative.
fn fastest_decay(rhs: &mut Eliminated<'_>, t: f64, y: &[f64]) -> Option<f64> {
    let n = y.len();
    // What is all algebra decays by nothing.
    if n == 0 {
        return None;
    }
    let mut jacobian = vec![0.0; n * n];
    rhs.jacobian(t, y, &mut jacobian)?.ok()?;
    let mut w: Vec<f64> = (0..n).map(|i| 1.0 + i as f64 / 10.0).collect();
    let (mut eigenvalue, mut change) = (0.0, f64::INFINITY);
    for _ in 0..ITERATIONS {
        let image: Vec<f64> =
            jacobian.chunks_exact(n).map(|row| row.iter().zip(&w).map(|(j, w)| j * w).sum()).collect();
        let square: f64 = w.iter().map(|w| w * w).sum();
        let next = image.iter().zip(&w).map(|(a, b)| a * b).sum::<f64>() / square;
        change = (next - eigenvalue).abs();
        eigenvalue = next;
        let length = image.iter().map(|x| x * x).sum::<f64>().sqrt();
        if !(length.is_finite() && length > 0.0) {
            return None;
        }
        w = image.into_iter().map(|x| x / length).collect();
    }
    (eigenvalue < 0.0 && change < 0.01 * eigenvalue.abs()).then_some(-eigenvalue)
}

/// The instant after which no digit is left, if the run goes beyond it.
///
/// Without eliminated accelerations the growth is followed by differences of those that are solved for.
fn horizon(problem: &Problem<'_>, solution: &Solution) -> Result<Option<String>, Error> {
    let scene = problem.scene;
    // A run that took no step says why.
    let Some(start) = solution.y.first().filter(|_| solution.steps > 0) else { return Ok(None) };
    let mut rhs: Box<dyn RightHandSide<f64> + '_> = match Eliminated::new(problem.system(), &scene.parameters) {
        Some(rhs) => Box::new(rhs),
        None => Box::new(problem.dynamics().map_err(|error| refused(scene, &error))?),
    };
    // Tight, whatever the run: of a motion that is wrong the growth is wrong too.
    let options = Options { method: Method::Dop853, step_limit: MOST_STEPS, ..Options::tolerances(1e-9, 1e-9) };
    let span = (solution.t[0], solution.t_end);
    let growth = growth(rhs.as_mut(), span, start, &vec![1.0; start.len()], &options);
    let growth = growth.map_err(|error| refused(scene, &error))?;
    let tolerance = scene.integration.rtol.max(scene.integration.atol.smallest()).max(f64::EPSILON);
    // What only the very end shows is the surface that the motion ends at.
    // Every step adds an error of its own, and the growth carries all of them on.
    let steps = solution.steps as f64;
    let sum = |t: f64| tolerance * (steps * (t - span.0) / (span.1 - span.0)).max(1.0);
    let t = growth.horizon(sum).filter(|t| (span.1 - t).abs() > LAST_PART * (span.1 - span.0).abs());
    Ok(t.map(|t| {
        format!(
            "the errors of {tolerance:.0e} that the tolerances allow in each step can have grown to 1 at t = {t:.4} s: no digit need be left after that"
        )
    }))
}
