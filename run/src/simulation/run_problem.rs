//! Runs of prepared problems, with energies, first integrals, error estimates and notes.

use super::run::Run;
use super::shown_quantities::{ShownQuantities, state_names};
use crate::code::{Code, CodePreparation, runnable_code};
use crate::error::{Error, refused_scene_error};
use crate::integration_options::integration_options;
use crate::mechanism::Mechanism;
use crate::preparation::impacts;
use crate::preparation::problem::Problem;
use crate::preparation::speed_changes::{self, ChosenSpeedEquations};
use crate::trust;
use crate::trust::constraint_residuals::constraint_residuals;
use crate::trust::correct_digits::{CorrectDigits, Values, estimate_digits, unassessed_digits_note};
use crate::trust::load_power::accumulated_load_power;
use crate::trust::stiffness;
use crate::trust::watched_functions::{WatchedFunctions, watched_events};
use crate::trust::watched_invariants::WatchedInvariants;
use tripos_derive::algebra::text::print::print_text;
use tripos_derive::mechanics::{EquationsOrigin, load_divisors};
use tripos_derive::scene::Scene;
use tripos_derive::{Formulation, Model};
use tripos_sim::{Event, Options, Solution, Stop};

/// Replaces the energies of a run by the energies of the whole model, computed from the shown states.
///
/// The energies of reduced equations differ from those of the whole model, because motion due to
/// constant momenta counts as potential energy. A run that shows outputs of its scene gets no
/// energies. It keeps the drift of its own energy if it has one.
///
/// # Errors
/// [`Error`] if the model has no Kane's equations.
pub fn set_whole_model_energies(model: &Mechanism, scene: &Scene, run: &mut Run) -> Result<(), Error> {
    if scene.states_outputs {
        run.energies.clear();
        return Ok(());
    }
    let code = runnable_code(model, &Formulation::Kane.into(), None, CodePreparation::AsDerived)?;
    let (system, p, n) = (code.system(), scene.parameters.as_slice(), scene.q.len());
    let energies = |state: &Vec<f64>| {
        let (q, u) = state.split_at(n);
        (system.kinetic_energy(p, q, u), system.potential_energy(p, q))
    };
    run.energies = run.states.iter().map(energies).collect();
    let (kinetic, potential) = energies(&run.end);
    let drift = || run.solution.energy_drift(run.energies.iter().map(|(t, v)| t + v), kinetic + potential);
    run.energy_drift = (!model.is_driven()).then(drift);
    Ok(())
}

/// Names of the shown quantities. For reduced equations they are the outputs of the scene. Otherwise
/// they are the coordinates, followed by the generalized speeds.
fn shown_names(problem: &Problem<'_>) -> Vec<String> {
    if problem.by.is_reduced() {
        problem.shown.outputs.iter().map(|o| o.name.clone()).collect()
    } else {
        state_names(problem.model)
    }
}

/// Proves the first integrals of a model (quantities that stay constant), so that runs can watch them.
///
/// `None` for a model without speeds. Also `None` for a model with more than eight coordinates, whose
/// proof may take longer than the run.
///
/// # Errors
/// [`Error`] if the model cannot be derived.
pub fn prove_integrals_to_watch(model: &Mechanism) -> Result<Option<WatchedInvariants>, Error> {
    are_integrals_proved(model).then(|| WatchedInvariants::of_model(model)).transpose()
}

/// True if the first integrals of a model are proved before a run: the model has at most eight
/// coordinates, and at least one speed.
pub fn are_integrals_proved(model: &Mechanism) -> bool {
    // A fully prescribed motion conserves nothing of its own.
    model.coordinates.len() <= MOST_PROVED && !model.speeds.is_empty()
}

/// Greatest number of coordinates for which first integrals are proved before a run, so that the run
/// can watch them.
const MOST_PROVED: usize = 8;

/// Runs a scene by one set of equations. `code` must use the scene's distance from a singular surface
/// if the scene has one. `watch` are the first integrals to watch; `None` watches only the energy.
///
/// # Errors
/// [`Error`] if the run cannot begin. A run that began and could not go on is a [`Run`] that says so.
pub fn run_code(
    model: &Mechanism,
    scene: &Scene,
    by: &EquationsOrigin,
    code: &Code,
    watch: Option<&WatchedInvariants>,
) -> Result<Run, Error> {
    run_problem(&Problem::new(model, scene, by, code, None)?, watch)
}

/// Runs a problem over the span of its scene with the scene's integration settings. The result shows
/// the states, or the outputs of a reduced scene. `watch` are the first integrals to watch; `None`
/// watches only the energy.
///
/// # Errors
/// [`Error`] if the run cannot begin. A run that began and could not go on is a [`Run`] that says so.
pub fn run_problem(problem: &Problem<'_>, watch: Option<&WatchedInvariants>) -> Result<Run, Error> {
    run_problem_with_quantities(problem, watch, None)
}

/// Runs a problem and shows the quantities `shown`. `None` shows the states, or the outputs of a
/// reduced scene. `watch` are the first integrals to watch; `None` watches only the energy.
///
/// # Errors
/// Errors of [`run_problem`].
pub fn run_problem_with_quantities(
    problem: &Problem<'_>,
    watch: Option<&WatchedInvariants>,
    shown: Option<&ShownQuantities>,
) -> Result<Run, Error> {
    run_problem_by_solver(problem, watch, shown, |y0, options, events| {
        problem.solve(y0, options, events, accumulated_load_power(problem)?)
    })
}

/// Runs a problem by the function `solve`, which gets the integrated start state, the options and the
/// watched events, and returns the solution. Energies, error estimates and notes are added.
///
/// # Errors
/// Errors of [`run_problem`], and the errors of `solve`.
pub fn run_problem_by_solver(
    problem: &Problem<'_>,
    watch: Option<&WatchedInvariants>,
    shown: Option<&ShownQuantities>,
    solve: impl FnOnce(&[f64], &Options, &mut [Event<'_>]) -> Result<Solution, Error>,
) -> Result<Run, Error> {
    let scene = problem.scene;
    let watch = watch.filter(|_| scene.impacts.is_empty());
    let balance = WatchedFunctions::new(problem.mechanism, problem.model, scene, problem.by)?;
    let y0 = problem.start()?;
    let mut events = watched_events(problem, &balance);
    let options = integration_options(scene);
    let solution = solve(&y0, &options, &mut events)?;
    drop(events);
    let changes = problem.chosen.map(|chosen| speed_change_notes(problem.model, chosen));
    let values = |problem: &Problem<'_>, t: f64, y: &[f64]| match shown {
        Some(shown) => shown.of(problem, t, y),
        None => Ok(problem.shown_state(t, y)),
    };
    let names = shown.map_or_else(|| shown_names(problem), |shown| shown.names.clone());
    let digits = estimate_digits(problem, &y0, &options, &solution, &values, &balance)?;
    let mut run = finish_run(problem, solution, watch, names, digits, &values)?;
    run.notes.splice(..0, changes.into_iter().flatten());
    Ok(run)
}

/// Notes on the instants at which a run changed between its chosen speeds and the rates of all
/// coordinates.
fn speed_change_notes(model: &Model, chosen: ChosenSpeedEquations<'_>) -> Vec<String> {
    let speeds: Vec<String> = model.speeds.iter().map(|speed| format!("`{}`", speed.name)).collect();
    chosen
        .changes
        .lock()
        .map_or_else(|_| Vec::new(), |list| speed_changes::notes_on_rates_intervals(&list, &speeds, chosen.by))
}

/// Completes a solution to the result of a run: adds shown values, energies, notes and objections.
fn finish_run(
    problem: &Problem<'_>,
    solution: Solution,
    watch: Option<&WatchedInvariants>,
    names: Vec<String>,
    digits: Option<CorrectDigits>,
    values: &Values<'_>,
) -> Result<Run, Error> {
    let scene = problem.scene;
    let (system, p) = (problem.system(), scene.parameters.as_slice());
    let dynamics = problem.dynamics().map_err(|error| refused_scene_error(scene, &error))?;
    let energy = |y: &[f64]| {
        let (q, v) = dynamics.split(y);
        (system.kinetic_energy(p, q, v), system.potential_energy(p, q))
    };
    let energies: Vec<(f64, f64)> = solution.y.iter().map(|y| energy(y)).collect();
    // Reduced equations may have no energy of their own, and the work of a drive is unknown.
    let has_energy = (!problem.by.is_reduced() || system.has_energy_gradient()) && !problem.mechanism.is_driven();
    let energy_drift = has_energy.then(|| dynamics.energy_drift(&solution));
    let warnings = trust::objections_to_run(problem, &solution, watch, energy_drift, digits.as_ref(), &names)?;
    let drifts = watch.map_or_else(Vec::new, |watch| watch.integral_drifts(problem, &solution));
    let variables = problem.variable_names();
    let at = match &solution.stop {
        Stop::Singular { divisor } => zero_divisor_meaning(problem, divisor),
        stop if stop.is_failure() => problem.near_divisors(&solution.y_end)?,
        _ => String::new(),
    };
    let states = solution.t.iter().zip(&solution.y).map(|(t, y)| values(problem, *t, y));
    let mut run = Run {
        why: solution.stop.described(&variables) + &at,
        ending: solution.described(&variables) + &at,
        missing: None,
        drifts,
        by: problem.by.clone(),
        code: problem.code.form(),
        solve: problem.solve,
        states: states.collect::<Result<_, _>>()?,
        energies,
        names,
        end: values(problem, solution.t_end, &solution.y_end)?,
        energy_drift,
        residuals: constraint_residuals(problem, &solution),
        notes: closed_start_notes(scene)
            .chain(impacts::notes_on_short_bounces(&scene.impacts, &solution))
            .chain(driven_mechanism_note(problem))
            .chain(digits.as_ref().and_then(unassessed_digits_note))
            .chain(stiffness::stiffness_advice(problem, &solution)?)
            .collect(),
        digits,
        warnings,
        solution,
    };
    run.find_missing_values(problem)?;
    Ok(run)
}

/// Text that explains a divisor of a load that became zero, as the end of a sentence. Empty if the
/// divisor belongs to no load.
fn zero_divisor_meaning(problem: &Problem<'_>, divisor: &str) -> String {
    let mut arena = problem.mechanism.arena.clone();
    let loads = load_divisors(&mut arena, problem.mechanism);
    let of_load = loads.iter().find(|load| print_text(&arena, load.value) == divisor);
    of_load.map_or_else(String::new, |load| format!(": {}", load.zero_divisor_meaning()))
}

/// Note that the energy cannot check a run of a driven mechanism. `None` if no constraint drives the
/// mechanism.
fn driven_mechanism_note(problem: &Problem<'_>) -> Option<String> {
    problem.mechanism.is_driven().then(|| {
        "constraints drive the mechanism: their forces change the energy, and no drift of energy is stated".to_owned()
    })
}

/// Notes on the coordinates and rates that were computed for the start, so that loops are closed and
/// constraints are satisfied.
fn closed_start_notes(scene: &Scene) -> impl Iterator<Item = String> {
    let solved = |is_rate: bool| -> Option<String> {
        let list = scene.closed.iter().filter(|c| c.is_rate == is_rate);
        let list: Vec<String> = list.map(|c| format!("{} = {}", c.name, c.value)).collect();
        (!list.is_empty()).then(|| list.join(", "))
    };
    let places = solved(false).map(|list| format!("the loops are closed at the start by {list}"));
    let rates = solved(true).map(|list| format!("the constraints give {list} at the start"));
    places.into_iter().chain(rates)
}
