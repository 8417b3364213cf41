//! Runs of scenes by their own reduced equations or by whole equations, with checks of the results.

use super::outputs::{Shown, state_names};
use super::run::Run;
use crate::code::{Code, Ready, by_or_first, code};
use crate::error::{Error, refused};
use crate::mechanism::Mechanism;
use crate::options::options;
use crate::preparation::impacts;
use crate::preparation::passage::{self, Chosen};
use crate::preparation::problem::Problem;
use crate::preparation::reduced::Reduced;
use crate::trust;
use crate::trust::digits::{Digits, Values, assess};
use crate::trust::events::{Balance, events};
use crate::trust::invariants::Watch;
use crate::trust::power::accounted;
use crate::trust::residuals::residuals;
use crate::trust::stiffness;
use std::sync::Mutex;
use tripos_derive::algebra::text::print::text;
use tripos_derive::mechanics::{EquationsOrigin, is_reducible, load_divisors};
use tripos_derive::reduce::ReductionBasis;
use tripos_derive::scene::{Integrator, Scene, Solve};
use tripos_derive::{Formulation, Model};
use tripos_sim::{Event, Options, Solution, Stop};

/// Runs a scene by the equations named `by`, such as `kane`; `reduced` names the scene's own. Without a name the
/// scene's reduced equations run if they are a gain and reach the end. Otherwise, and for a numeric solve, whole
/// equations run.
///
/// # Errors
/// [`Error`] if there are no equations of this name, or they cannot be run.
pub fn simulate(mechanism: &Mechanism, scene: &Scene, by: Option<&str>) -> Result<Run, Error> {
    if let Some(by) = by.filter(|by| *by != EquationsOrigin::Reduced.name()) {
        return run(mechanism, scene, &by_or_first(mechanism, Some(by))?);
    }
    match without_own(mechanism, scene, by.is_none()) {
        Some(why) => {
            let mut done = run(mechanism, scene, &by_or_first(mechanism, None)?)?;
            done.notes.insert(0, why.to_owned());
            Ok(done)
        }
        None => simulate_own(mechanism, scene, by.is_none()),
    }
}

/// Reason why whole equations run and a scene's reduced equations are not tried; `None` if these are tried.
fn without_own(mechanism: &Mechanism, scene: &Scene, is_default: bool) -> Option<&'static str> {
    if scene.integration.solve == Some(Solve::Numeric) {
        return Some(
            "accelerations are found numerically for whole equations only: every coordinate and speed is run and shown",
        );
    }
    // Quadrature needs one degree of freedom, which only a reduction has.
    if !is_default || scene.integration.method == Integrator::Quadrature {
        return None;
    }
    if !scene.impacts.is_empty() {
        return Some("whole equations are run: impacts change what reduced ones hold constant");
    }
    if mechanism.speeds.is_empty() {
        return Some("the constraints leave no speed: the coordinates follow from them, and forces from the motion");
    }
    (!is_reducible(mechanism)).then_some(if mechanism.loops.is_empty() {
        "whole equations are run: those of this model are too large to be written out for a scene's own"
    } else {
        "whole equations are run: nothing is left out of a mechanism whose loops are to stay closed"
    })
}

/// Runs a scene by its own reduced equations. If the caller did not ask for these and they do not exist, are no gain,
/// or do not reach the end, whole equations run.
fn simulate_own(mechanism: &Mechanism, scene: &Scene, is_default: bool) -> Result<Run, Error> {
    let basis = ReductionBasis::new(mechanism).map_err(|error| mechanism.diagnose(&error))?;
    let watch = is_proved(mechanism).then(|| Watch::of_basis(mechanism, &basis)).transpose()?;
    let watch = watch.as_ref();
    if !is_default || scene.integration.method == Integrator::Quadrature {
        return run_reduced(mechanism, scene, &basis, &Reduced::of_basis(&basis, mechanism, scene)?, watch);
    }
    let whole = |why: &str| {
        let mut run = run_whole(mechanism, scene, &by_or_first(mechanism, None)?, watch)?;
        run.notes.insert(0, format!("whole equations are run: {why}"));
        taken_through(mechanism, scene, watch, run)
    };
    match run_gain(mechanism, scene, &basis, watch) {
        Ok(Own::Run(run)) => taken_through(mechanism, scene, watch, *run),
        Ok(Own::NoGain(why)) => whole(&why),
        Err(error) => {
            let why = format!("the scene's reduced equations do not run it ({})", error.first_line());
            whole(&why).or(Err(error))
        }
    }
}

/// Result of trying to run a scene by its own reduced equations.
enum Own {
    /// A run by the scene's reduced equations.
    Run(Box<Run>),
    /// Reason why the scene's reduced equations are no gain over whole ones.
    NoGain(String),
}

/// Runs a scene by its own reduced equations if these are a gain over whole equations.
fn run_gain(mechanism: &Mechanism, scene: &Scene, basis: &ReductionBasis, watch: Option<&Watch>) -> Result<Own, Error> {
    let reduced = Reduced::of_basis(basis, mechanism, scene)?;
    match reduced.no_gain(mechanism)? {
        Some(why) => Ok(Own::NoGain(why)),
        None => Ok(Own::Run(Box::new(run_reduced(mechanism, scene, basis, &reduced, watch)?))),
    }
}

/// Replaces a run that could not go on by a run of other equations of the same motion, if one goes on: Kane's, or
/// Lagrange's, whose motion variables are the rates. The new run starts again and shows all that the scene shows.
///
/// A scene's reduced equations contain momenta and may be in a moving frame. The motion may be regular at a pole of
/// that frame, so a failed run by them is replaced for any reason. A run by whole equations is replaced only if these
/// divide by zero.
fn taken_through(mechanism: &Mechanism, scene: &Scene, watch: Option<&Watch>, run: Run) -> Result<Run, Error> {
    let Some(why) = left_for(&run) else { return Ok(run) };
    let mut doubtful = None;
    for formulation in [Formulation::Kane, Formulation::Lagrange] {
        let by = EquationsOrigin::from(formulation);
        if by == run.by {
            continue;
        }
        let mut other = match run_whole(mechanism, scene, &by, watch) {
            Ok(other) => other,
            // A formulation that the model does not have cannot help.
            Err(Error::Unsupported(_) | Error::Stopped(_)) => continue,
            Err(error) => return Err(error),
        };
        if other.failure().is_none() && comes_as_far(scene, &other, &run) {
            let left =
                if run.by.is_reduced() { "the scene's own".to_owned() } else { format!("those by {}", run.by.title()) };
            other.notes.insert(0, format!("whole equations are run, by {}, since {left} {why}", other.by.title()));
            if other.warnings.is_empty() {
                return Ok(other);
            }
            // Another formulation may give no warning.
            doubtful = doubtful.or(Some(other));
        } else if matches!(other.solution.stop, Stop::StepLimit { .. } | Stop::Interrupted) {
            break;
        }
    }
    Ok(doubtful.unwrap_or(run))
}

/// Reason why a run must be replaced, as the end of a sentence about its equations; `None` if the run is kept.
fn left_for(run: &Run) -> Option<String> {
    let t = run.solution.t_end;
    match &run.solution.stop {
        Stop::Interrupted => None,
        Stop::Singular { divisor } => Some(format!("divide by {divisor}, which is 0 at t = {t} s")),
        _ if !run.by.is_reduced() => None,
        stop if stop.is_failure() => Some(format!("stop at t = {t} s: {}", run.why)),
        _ => run.missing.as_ref().map(|what| format!("do not give all that is shown: {what}")),
    }
}

/// True if a run of a scene comes at least as far as another run.
fn comes_as_far(scene: &Scene, run: &Run, other: &Run) -> bool {
    (run.solution.t_end - other.solution.t_end) * (scene.span.1 - scene.span.0).signum() >= 0.0
}

/// Runs a scene by one set of whole equations, and shows the requested quantities.
///
/// # Errors
/// [`Error`] if the model does not have the formulation, or the equations cannot give a requested quantity.
pub fn run(model: &Mechanism, scene: &Scene, by: &EquationsOrigin) -> Result<Run, Error> {
    // Impacts change the conserved quantities, so no proof is tried.
    let watch = if scene.impacts.is_empty() { proved(model)? } else { None };
    run_whole(model, scene, by, watch.as_ref())
}

/// Runs a scene by one set of whole equations with known first integrals.
///
/// # Errors
/// Errors of [`run`].
pub fn run_whole(model: &Mechanism, scene: &Scene, by: &EquationsOrigin, watch: Option<&Watch>) -> Result<Run, Error> {
    let code = code(model, by, scene.integration.distance, Ready::for_runs(scene))?;
    let problem = Problem::new(model, scene, by, &code, None)?;
    let shown = Shown::new(model, scene)?;
    let Some(rates) = in_rates(&problem)? else { return run_shown(&problem, watch, Some(&shown)) };
    match alone(&problem, &rates)? {
        Some(solution) => run_by(&problem, watch, Some(&shown), |_, _, _| Ok(solution)),
        None => {
            let mut run = changing_speeds(&problem, &rates, |problem| run_shown(problem, watch, Some(&shown)))?;
            (run.by, run.code, run.solve) = (problem.by.clone(), problem.code.form(), problem.solve);
            Ok(run)
        }
    }
}

/// Runs a problem by its chosen speeds alone; `None` if the run has to change them.
fn alone(problem: &Problem<'_>, rates: &Code) -> Result<Option<Solution>, Error> {
    let balance = Balance::new(problem.mechanism, problem.model, problem.scene, problem.by)?;
    let mut events = events(problem, &balance);
    problem.in_speeds_alone(rates, &options(problem.scene), &mut events, accounted(problem)?)
}

/// Runs a scene by whole equations. `None` unless the run changes its speeds and does not fail.
///
/// # Errors
/// Errors of [`run`].
pub fn changes_speeds(model: &Mechanism, scene: &Scene, by: &EquationsOrigin) -> Result<Option<Run>, Error> {
    if !model.ties_rates() {
        return Ok(None);
    }
    let code = code(model, by, scene.integration.distance, Ready::for_runs(scene))?;
    let problem = Problem::new(model, scene, by, &code, None)?;
    let Some(rates) = in_rates(&problem)? else { return Ok(None) };
    if alone(&problem, &rates)?.is_some() {
        return Ok(None);
    }
    let run = run(model, scene, by)?;
    Ok((!run.solution.stop.is_failure()).then_some(run))
}

/// Equations in the rates of all coordinates, for places where the speeds of a run do not determine the motion. `None`
/// if no constraint makes such places, or the model has no equations in all rates.
///
/// # Errors
/// [`Error::Input`] if the model cannot be derived.
pub fn in_rates(problem: &Problem<'_>) -> Result<Option<Code>, Error> {
    let (model, scene, how) = (problem.mechanism, problem.scene, &problem.scene.integration);
    let is_free = !model.ties_rates() || model.speeds.is_empty();
    let is_own = how.distance.is_some() || how.project.is_some() || how.method == Integrator::Quadrature;
    if is_free || is_own || !scene.impacts.is_empty() {
        return Ok(None);
    }
    match code(model, &Formulation::Lagrange.into(), None, Ready::AsDerived) {
        Err(Error::Unsupported(_) | Error::Stopped(_)) => Ok(None),
        code => code.map(Some),
    }
}

/// Runs a problem in its chosen speeds as far as these determine the motion, and elsewhere in all rates by `code`.
/// Returns the result of `run`.
///
/// # Errors
/// Errors of [`Problem::new`], and the errors of `run`.
pub fn changing_speeds<T>(
    problem: &Problem<'_>,
    code: &Code,
    run: impl FnOnce(&Problem<'_>) -> Result<T, Error>,
) -> Result<T, Error> {
    let (by, changes) = (EquationsOrigin::from(Formulation::Lagrange), Mutex::default());
    let chosen = Chosen { by: problem.by, code: problem.code, solve: problem.solve, changes: &changes };
    let rates = Problem::new(problem.mechanism, problem.scene, &by, code, Some(Solve::Numeric))?.beside(chosen);
    run(&rates)
}

/// Runs a scene by its own reduced equations. If these have no value at the start, the run uses reduced equations
/// without constant momenta: a speed may not be determined by a momentum there.
///
/// # Errors
/// [`Error`] if the run cannot begin; one that began and could not go on is a [`Run`] that says so.
fn run_reduced(
    model: &Mechanism,
    scene: &Scene,
    basis: &ReductionBasis,
    reduced: &Reduced,
    watch: Option<&Watch>,
) -> Result<Run, Error> {
    // First integrals of the whole model are functions of all states, which a scene may not show.
    let watch = watch.filter(|_| !scene.states_outputs);
    let code = reduced.code(model)?;
    let singular = Problem::reduced(model, reduced, scene, &code)?.singular_start()?;
    let is_plain = reduced.constants().next().is_none() && reduced.reduction.frame.is_none();
    let (Some(singular), false) = (singular, is_plain) else {
        return run_own(model, scene, (reduced, &code), watch);
    };
    let plain = Reduced::without_momenta(basis, model, scene)?;
    let code = plain.code(model)?;
    if Problem::reduced(model, &plain, scene, &code)?.singular_start()?.is_some() {
        return Err(Error::Stopped(format!("the run cannot start: {singular}")));
    }
    let mut run = run_own(model, scene, (&plain, &code), watch)?;
    run.notes.insert(0, format!("no momentum is held, since {singular}"));
    Ok(run)
}

/// Runs a scene by the given reduced equations of its own.
fn run_own(
    model: &Mechanism,
    scene: &Scene,
    (reduced, code): (&Reduced, &Code),
    watch: Option<&Watch>,
) -> Result<Run, Error> {
    let problem = Problem::reduced(model, reduced, scene, code)?;
    let mut run = run_problem(&problem, watch)?;
    whole_energies(model, scene, &mut run)?;
    Ok(run)
}

/// Replaces the energies of a run by those of the whole model, computed from the shown states. A run that shows outputs
/// of its scene has no such energies, but keeps the drift of its own energy if it has one.
///
/// The energies of reduced equations differ from these: motion due to constant momenta counts as potential energy.
///
/// # Errors
/// [`Error`] if the model has no Kane's equations.
pub fn whole_energies(model: &Mechanism, scene: &Scene, run: &mut Run) -> Result<(), Error> {
    if scene.states_outputs {
        run.energies.clear();
        return Ok(());
    }
    let code = code(model, &Formulation::Kane.into(), None, Ready::AsDerived)?;
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

/// Names of the quantities that a run shows: the outputs of a scene, or coordinates and generalized speeds.
fn shown_names(problem: &Problem<'_>) -> Vec<String> {
    if problem.by.is_reduced() {
        problem.shown.outputs.iter().map(|o| o.name.clone()).collect()
    } else {
        state_names(problem.model)
    }
}

/// Proves the first integrals of a model, to watch them in runs. `None` for a large model, whose proof may take longer
/// than the run; then only energy is watched.
///
/// # Errors
/// [`Error`] if the model cannot be derived.
pub fn proved(model: &Mechanism) -> Result<Option<Watch>, Error> {
    is_proved(model).then(|| Watch::of_model(model)).transpose()
}

/// True if the first integrals of a model are proved before a run watches them.
fn is_proved(model: &Mechanism) -> bool {
    // A fully prescribed motion conserves nothing of its own.
    model.coordinates.len() <= MOST_PROVED && !model.speeds.is_empty()
}

/// Greatest number of coordinates for which a run proves the first integrals before it watches them.
const MOST_PROVED: usize = 8;

/// Runs a scene by one set of equations that is ready to run, in the scene's distance if it has one.
///
/// # Errors
/// [`Error`] if the run cannot begin; one that began and could not go on is a [`Run`] that says so.
pub fn run_code(
    model: &Mechanism,
    scene: &Scene,
    by: &EquationsOrigin,
    code: &Code,
    watch: Option<&Watch>,
) -> Result<Run, Error> {
    run_problem(&Problem::new(model, scene, by, code, None)?, watch)
}

/// Runs a problem over the span of its scene, as the scene says, and shows its states.
///
/// # Errors
/// [`Error`] if the run cannot begin; one that began and could not go on is a [`Run`] that says so.
pub fn run_problem(problem: &Problem<'_>, watch: Option<&Watch>) -> Result<Run, Error> {
    run_shown(problem, watch, None)
}

/// Runs a problem, and shows the quantities `shown` of its states. Without `shown` it shows the states, or the outputs
/// of a reduced scene.
fn run_shown(problem: &Problem<'_>, watch: Option<&Watch>, shown: Option<&Shown>) -> Result<Run, Error> {
    run_by(problem, watch, shown, |y0, options, events| problem.solve(y0, options, events, accounted(problem)?))
}

/// Runs a problem by `solve`, which gets the integrated state at the start, the options and the watched events.
///
/// # Errors
/// Errors of [`run_problem`], and the errors of `solve`.
pub fn run_by(
    problem: &Problem<'_>,
    watch: Option<&Watch>,
    shown: Option<&Shown>,
    solve: impl FnOnce(&[f64], &Options, &mut [Event<'_>]) -> Result<Solution, Error>,
) -> Result<Run, Error> {
    let scene = problem.scene;
    let watch = watch.filter(|_| scene.impacts.is_empty());
    let balance = Balance::new(problem.mechanism, problem.model, scene, problem.by)?;
    let y0 = problem.start()?;
    let mut events = events(problem, &balance);
    let options = options(scene);
    let solution = solve(&y0, &options, &mut events)?;
    drop(events);
    let changes = problem.chosen.map(|chosen| changes(problem.model, chosen));
    let values = |problem: &Problem<'_>, t: f64, y: &[f64]| match shown {
        Some(shown) => shown.of(problem, t, y),
        None => Ok(problem.state(t, y)),
    };
    let names = shown.map_or_else(|| shown_names(problem), |shown| shown.names.clone());
    let digits = assess(problem, &y0, &options, &solution, (&values, &balance))?;
    let mut run = finish(problem, solution, watch, names, digits, &values)?;
    run.notes.splice(..0, changes.into_iter().flatten());
    Ok(run)
}

/// Notes on the instants at which the last run changed between its chosen speeds and all rates.
fn changes(model: &Model, chosen: Chosen<'_>) -> Vec<String> {
    let speeds: Vec<String> = model.speeds.iter().map(|speed| format!("`{}`", speed.name)).collect();
    chosen.changes.lock().map_or_else(|_| Vec::new(), |list| passage::said(&list, &speeds, chosen.by))
}

/// Makes the result of a run from its solution: shown values, energies, notes and objections.
fn finish(
    problem: &Problem<'_>,
    solution: Solution,
    watch: Option<&Watch>,
    names: Vec<String>,
    digits: Option<Digits>,
    values: &Values<'_>,
) -> Result<Run, Error> {
    let scene = problem.scene;
    let (system, p) = (problem.system(), scene.parameters.as_slice());
    let dynamics = problem.dynamics().map_err(|error| refused(scene, &error))?;
    let energy = |y: &[f64]| {
        let (q, v) = dynamics.split(y);
        (system.kinetic_energy(p, q, v), system.potential_energy(p, q))
    };
    let energies: Vec<(f64, f64)> = solution.y.iter().map(|y| energy(y)).collect();
    // Reduced equations may have no energy of their own, and the work of a drive is unknown.
    let has_energy = (!problem.by.is_reduced() || system.has_energy_gradient()) && !problem.mechanism.is_driven();
    let energy_drift = has_energy.then(|| dynamics.energy_drift(&solution));
    let warnings = trust::objections(problem, &solution, watch, energy_drift, (digits.as_ref(), &names))?;
    let drifts = watch.map_or_else(Vec::new, |watch| watch.drifts(problem, &solution));
    let variables = problem.variables();
    let at = match &solution.stop {
        Stop::Singular { divisor } => meaning(problem, divisor),
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
        residuals: residuals(problem, &solution),
        notes: closed(scene)
            .chain(impacts::said(&scene.impacts, &solution))
            .chain(driven(problem))
            .chain(digits.as_ref().and_then(trust::unassessed))
            .chain(stiffness::advice(problem, &solution)?)
            .collect(),
        digits,
        warnings,
        solution,
    };
    run.look_for_missing(problem)?;
    Ok(run)
}

/// Consequence for a load of the zero divisor with the given name, as the end of a sentence; empty if no load has it.
fn meaning(problem: &Problem<'_>, divisor: &str) -> String {
    let mut arena = problem.mechanism.arena.clone();
    let loads = load_divisors(&mut arena, problem.mechanism);
    let of_load = loads.iter().find(|load| text(&arena, load.value) == divisor);
    of_load.map_or_else(String::new, |load| format!(": {}", load.meaning()))
}

/// Note that the energy of a driven mechanism is no measure of a run; `None` if constraints do not drive it.
fn driven(problem: &Problem<'_>) -> Option<String> {
    problem.mechanism.is_driven().then(|| {
        "constraints drive the mechanism: its energy changes by what their forces work, and no drift of it is stated"
            .to_owned()
    })
}

/// Notes on the coordinates and rates that were solved for at the start, to close the loops and satisfy the
/// constraints.
fn closed(scene: &Scene) -> impl Iterator<Item = String> {
    let solved = |is_rate: bool| -> Option<String> {
        let list = scene.closed.iter().filter(|c| c.is_rate == is_rate);
        let list: Vec<String> = list.map(|c| format!("{} = {}", c.name, c.value)).collect();
        (!list.is_empty()).then(|| list.join(", "))
    };
    let places = solved(false).map(|list| format!("the loops are closed at the start by {list}"));
    let rates = solved(true).map(|list| format!("the constraints give {list} at the start"));
    places.into_iter().chain(rates)
}
