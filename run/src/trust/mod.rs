//! Objections to a run: sentences that say why its numbers cannot be trusted.
//!
//! Every objection states a number. None depends on a clock: the same run gives the same objections.

pub mod compared_quantities;
pub(super) mod constraint_residuals;
pub(super) mod correct_digits;
pub(super) mod load_power;
pub(super) mod reference_solution;
pub(super) mod stiffness;
pub(super) mod watched_functions;
pub(super) mod watched_invariants;

pub use correct_digits::unassessed_digits_note;

use crate::error::{Error, refused_scene_error};
use crate::preparation::problem::Problem;
use crate::trust::constraint_residuals::{broken_constraint_objection, opened_loop_objections};
use crate::trust::correct_digits::{CorrectDigits, FEW};
use crate::trust::watched_invariants::{ConservedQuantity, Excursion, WatchedInvariants};
use tripos_derive::plain_text::{with_reliable_digits, with_significant_digits};
use tripos_derive::scene::AccelerationSolution;
use tripos_sim::{Solution, Stop};

/// Relative error from which on fewer than three digits are correct.
const THREE_DIGITS: f64 = 1e-3;
/// Greatest number of samples of a run at which the matrix and the first integrals are checked.
const MOST_SAMPLES: usize = 400;

/// Lists the objections to a run, as sentences with numbers. `names` are the names of the values in
/// `digits`. `watch` are the first integrals to check; `None` checks only the energy.
///
/// # Errors
/// [`Error::Request`] if the number of parameters does not fit the equations.
pub fn objections_to_run(
    problem: &Problem<'_>,
    solution: &Solution,
    watch: Option<&WatchedInvariants>,
    energy_drift: Option<f64>,
    digits: Option<&CorrectDigits>,
    names: &[String],
) -> Result<Vec<String>, Error> {
    let mut list: Vec<String> = solution.warnings.iter().map(|w| w.warning_text(&problem.variable_names())).collect();
    if solution.stop == Stop::Interrupted {
        // An interrupted run needs no judgement.
        return Ok(list);
    }
    list.extend(digits.and_then(|digits| too_few_digits_objection(digits, names)));
    list.extend(digits.and_then(|digits| contradiction_objection(digits, &problem.variable_names())));
    list.extend(objections_without_digits(problem, solution, watch, energy_drift)?);
    Ok(list)
}

/// Lists the objections to a run that need no second run: changes of conserved quantities, open constraints, and an
/// ill-conditioned matrix. `watch` are the first integrals to check, and `energy_drift` is the change of T + V less the
/// work done, J; `None` for what is not checked.
///
/// # Errors
/// [`Error::Request`] if the number of parameters does not fit the equations.
pub fn objections_without_digits(
    problem: &Problem<'_>,
    solution: &Solution,
    watch: Option<&WatchedInvariants>,
    energy_drift: Option<f64>,
) -> Result<Vec<String>, Error> {
    let worst = watch.map_or_else(Vec::new, |watch| excursions_for_objections(problem, solution, watch));
    let changed: Vec<_> = worst.iter().filter(|(_, furthest)| furthest.ratio > 1.0).collect();
    let mut list: Vec<String> = changed.iter().map(|worst| excursion_objection(worst)).collect();
    // Near a pole of the coordinates, a small error of one coordinate allows any change of the energy. There the energy
    // itself decides.
    if !changed.iter().any(|(integral, _)| integral.kind.is_energy()) {
        list.extend(energy_drift.and_then(|drift| energy_objection(problem, solution, drift)));
    }
    list.extend(broken_constraint_objection(problem, solution));
    list.extend(opened_loop_objections(problem, solution));
    list.extend(condition_objection(problem, solution)?);
    Ok(list)
}

/// Objection to a run that has fewer than three correct digits at an instant. It names the first such
/// instant. `None` if all values have enough digits.
fn too_few_digits_objection(digits: &CorrectDigits, names: &[String]) -> Option<String> {
    let (instant, which) = digits.first_with_few()?;
    let (t, error, name) = (digits.t[instant], digits.errors[instant][which], &names[which]);
    if error.is_nan() {
        return Some(format!(
            "`{name}` has no value at t = {} s in this run, or in the second run: {}",
            with_significant_digits(t, 4),
            digits.by
        ));
    }
    let end = digits
        .digits_at_end_least()
        .filter(|left| *left >= FEW)
        .map(|left| format!("; at the end {left:.0} digits are right again"));
    Some(format!(
        "fewer than three digits are right from t = {} s on, where `{name}` may be off by {}: this is the difference from another run, {}{}",
        with_significant_digits(t, 4),
        with_significant_digits(error, 2),
        digits.by,
        end.unwrap_or_default()
    ))
}

/// Objection to a run that a more accurate run of the same motion cannot follow to its end. `None` if
/// there is no such contradiction.
fn contradiction_objection(digits: &CorrectDigits, names: &[String]) -> Option<String> {
    let beyond = digits.part_without_digits().filter(|_| digits.second_run_stopped_early())?;
    let why = digits.second.stop.described(names);
    Some(format!("another run of this motion ({}) could not go on: {why}; do not trust this one {beyond}", digits.by))
}

/// Objection to a drift of the energy: T + V minus the work done must be constant. `None` if the drift
/// is small. It is used if no watched first integral shows a loss of energy.
fn energy_objection(problem: &Problem<'_>, solution: &Solution, drift: f64) -> Option<String> {
    let (system, p) = (problem.system(), problem.scene.parameters.as_slice());
    let n = system.lengths().coordinates;
    let potential = |y: &Vec<f64>| system.potential_energy(p, &y[..n]).abs();
    // The scale is the largest kinetic energy that the initial energy allows. A run that blows up
    // must not raise its own allowance.
    let start = solution.y.first().unwrap_or(&solution.y_end);
    let first = (system.kinetic_energy(p, &start[..n], &start[n..]) + system.potential_energy(p, &start[..n])).abs();
    let scale = solution.y.iter().fold(first, |m, y| m.max(first + potential(y)));
    let scale = solution.work.iter().fold(scale, |m, work| m.max(first + work.abs()));
    let what = if solution.work.is_empty() { "total energy" } else { "total energy less the work done" };
    // Displacements below the absolute tolerance do not matter, as for a body that rests where V is 0.
    let (end, least) = (&solution.y_end[..n], problem.scene.integration.atol.smallest());
    let reach = |at: usize| {
        let mut beside = end.to_vec();
        beside[at] += least;
        (system.potential_energy(p, &beside) - system.potential_energy(p, end)).abs()
    };
    let nothing = (0..n).map(reach).sum::<f64>();
    // A drift that is NaN gives no objection. The reason of the run's end reports a missing energy.
    (drift > (THREE_DIGITS * scale).max(nothing)).then(|| {
        format!(
            "{what}, constant in this motion, changed by {} J of {} J: fewer than three digits are left",
            with_significant_digits(drift, 4),
            with_significant_digits(scale, 4)
        )
    })
}

/// First integral, with its largest change since the start of the run.
type Worst<'a> = (&'a ConservedQuantity, Excursion);

/// Largest change of each first integral that exists at the parameters, relative to an allowed change.
/// A state with an error in its fourth digit would cause the allowed change.
fn excursions_for_objections<'a>(
    problem: &Problem<'_>,
    solution: &Solution,
    watch: &'a WatchedInvariants,
) -> Vec<Worst<'a>> {
    // The allowed change is caused by a state with three correct digits.
    let worst = watch.worst_excursions(problem, solution, MOST_SAMPLES, &|_, x| THREE_DIGITS * (1.0 + x.abs()));
    let list = watch.integrals.iter().zip(worst).zip(watch.integrals_exist(&problem.shown.parameters));
    list.filter(|(_, exists)| *exists).map(|(found, _)| found).collect()
}

/// Objection that states the largest change of a first integral, and its instant.
fn excursion_objection((integral, Excursion { t, change, .. }): &Worst<'_>) -> String {
    let (name, unit, t) = (&integral.name, &integral.unit, with_significant_digits(*t, 4));
    if change.is_nan() {
        return format!("{name}, constant in this motion, has no value at t = {t} s: do not trust this run");
    }
    format!(
        "{name}, constant in this motion, has changed by {} {unit} at t = {t} s: fewer than three digits are left there",
        with_significant_digits(*change, 4)
    )
}

/// States (t, y) spread evenly over a run, at most about [`MOST_SAMPLES`].
fn samples_for_objections(solution: &Solution) -> impl Iterator<Item = (f64, &Vec<f64>)> {
    let every = solution.y.len().div_ceil(MOST_SAMPLES).max(1);
    solution.t.iter().copied().zip(&solution.y).step_by(every)
}

/// Objection to a run whose accelerations are solved for with an ill-conditioned matrix, so that too
/// many digits are lost. `None` if the condition is good enough, or if accelerations are eliminated.
///
/// # Errors
/// `Error::Request` if the number of parameters does not fit the equations.
fn condition_objection(problem: &Problem<'_>, solution: &Solution) -> Result<Option<String>, Error> {
    // Equations with multipliers are solved for constraints of any rank.
    if problem.solve == AccelerationSolution::Eliminated || problem.chosen.is_some() {
        return Ok(None);
    }
    let mut dynamics = problem.dynamics().map_err(|error| refused_scene_error(problem.scene, &error))?;
    let worst = samples_for_objections(solution)
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
            "the matrix is ill-conditioned at t = {} s: equilibrated rcond {}, so the numeric solve leaves {digits} digits there, less than rtol {:e} asks for{}",
            with_reliable_digits(t, None),
            with_significant_digits(rcond, 2),
            problem.scene.integration.rtol,
            if problem.system().has_accelerations() { "; eliminated accelerations lose none of them" } else { "" }
        )
    }))
}
