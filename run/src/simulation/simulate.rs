//! Runs of scenes by the scene's own reduced equations or by full equations, with checks of the
//! results.

use super::run::Run;
use super::run_problem::{
    are_integrals_proved, prove_integrals_to_watch, run_problem, run_problem_by_solver, run_problem_with_quantities,
    set_whole_model_energies,
};
use super::shown_quantities::ShownQuantities;
use crate::code::{Code, CodePreparation, runnable_code};
use crate::equations_name::{EquationsName, find_equations_or_first};
use crate::error::Error;
use crate::integration_options::integration_options;
use crate::mechanism::Mechanism;
use crate::preparation::problem::Problem;
use crate::preparation::reduced_equations::ReducedScene;
use crate::preparation::speed_changes::ChosenSpeedEquations;
use crate::trust::load_power::accumulated_load_power;
use crate::trust::watched_functions::{WatchedFunctions, watched_events};
use crate::trust::watched_invariants::WatchedInvariants;
use std::sync::Mutex;
use tripos_derive::Formulation;
use tripos_derive::mechanics::{EquationsOrigin, has_reducible_form};
use tripos_derive::plain_text::with_reliable_digits;
use tripos_derive::reduce::ReductionBasis;
use tripos_derive::scene::{AccelerationSolution, Integrator, Scene};
use tripos_sim::{Solution, Stop};

/// Runs a scene by the equations `by`, such as `kane`. The name `reduced` means the scene's own reduced
/// equations.
///
/// If `by` is `None`, the scene's reduced equations are used if they have an advantage and reach the
/// end. Otherwise full equations are used. Full equations are also used if the scene asks for
/// numerical accelerations.
///
/// # Errors
/// [`Error`] if there are no equations of this name, or they cannot be run.
pub fn simulate(mechanism: &Mechanism, scene: &Scene, by: Option<&EquationsName>) -> Result<Run, Error> {
    let reduced = match by {
        None => ReducedRun::IfGain,
        Some(EquationsName::Reduced) => ReducedRun::Asked,
        Some(by) => return simulate_full_equations(mechanism, scene, &find_equations_or_first(mechanism, Some(by))?),
    };
    match reason_to_simulate_full_equations(mechanism, scene, reduced) {
        Some(why) => {
            let mut done = simulate_full_equations(mechanism, scene, &find_equations_or_first(mechanism, None)?)?;
            done.notes.insert(0, why.to_owned());
            Ok(done)
        }
        None => simulate_own(mechanism, scene, reduced),
    }
}

/// Condition for the use of a scene's reduced equations.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ReducedRun {
    /// The reduced equations are requested: they are used in any case.
    Asked,
    /// No equations are requested: the reduced equations are used if they have an advantage over full
    /// equations.
    IfGain,
}

/// Reason why full equations are used and the scene's reduced equations are not tried. `None` if the
/// reduced equations are tried.
pub(crate) fn reason_to_simulate_full_equations(
    mechanism: &Mechanism,
    scene: &Scene,
    reduced: ReducedRun,
) -> Option<&'static str> {
    if scene.integration.solve == Some(AccelerationSolution::Numeric) {
        return Some(
            "accelerations are found numerically for full equations only: every coordinate and speed is run and shown",
        );
    }
    // Quadrature needs one degree of freedom, which only a reduction has.
    if reduced == ReducedRun::Asked || scene.integration.method == Integrator::Quadrature {
        return None;
    }
    if !scene.impacts.is_empty() {
        return Some("the full equations are integrated: impacts change values that reduced equations hold constant");
    }
    if mechanism.speeds.is_empty() {
        return Some("the constraints leave no speed: the coordinates follow from them, and forces from the motion");
    }
    (!has_reducible_form(mechanism)).then_some(if mechanism.loops.is_empty() {
        "the full equations are integrated: this model is too large for reduced equations"
    } else {
        "the full equations are integrated: a mechanism with closed loops needs all of them"
    })
}

/// Runs a scene by its own reduced equations, or by full equations if these are better.
///
/// Requested reduced equations are always used. Otherwise full equations replace reduced equations
/// that do not exist, have no advantage, or do not reach the end.
fn simulate_own(mechanism: &Mechanism, scene: &Scene, reduced: ReducedRun) -> Result<Run, Error> {
    let basis = ReductionBasis::new(mechanism).map_err(|error| mechanism.diagnose(&error))?;
    let watch = are_integrals_proved(mechanism).then(|| WatchedInvariants::of_basis(mechanism, &basis)).transpose()?;
    let watch = watch.as_ref();
    if reduced == ReducedRun::Asked || scene.integration.method == Integrator::Quadrature {
        return run_reduced(mechanism, scene, &basis, &ReducedScene::from_basis(&basis, mechanism, scene)?, watch);
    }
    let whole = |why: &str| {
        let mut run =
            simulate_full_equations_watched(mechanism, scene, &find_equations_or_first(mechanism, None)?, watch)?;
        run.notes.insert(0, format!("the full equations are integrated: {why}"));
        replace_failed_run(mechanism, scene, watch, run)
    };
    match simulate_reduced_if_advantage(mechanism, scene, &basis, watch) {
        Ok(ReducedOutcome::Run(run)) => replace_failed_run(mechanism, scene, watch, *run),
        Ok(ReducedOutcome::NoGain(why)) => whole(&why),
        Err(error) => {
            let why = format!("the reduced equations cannot simulate this scene ({})", error.first_line());
            whole(&why).or(Err(error))
        }
    }
}

/// Result of a trial run by a scene's own reduced equations.
enum ReducedOutcome {
    /// Run that the scene's reduced equations gave.
    Run(Box<Run>),
    /// Reason why the scene's reduced equations have no advantage over full equations.
    NoGain(String),
}

/// Tries to run a scene by its own reduced equations. They are used only if they have an advantage over
/// full equations.
fn simulate_reduced_if_advantage(
    mechanism: &Mechanism,
    scene: &Scene,
    basis: &ReductionBasis,
    watch: Option<&WatchedInvariants>,
) -> Result<ReducedOutcome, Error> {
    let reduced = ReducedScene::from_basis(basis, mechanism, scene)?;
    match reduced.reason_against_reduction(mechanism)? {
        Some(why) => Ok(ReducedOutcome::NoGain(why)),
        None => Ok(ReducedOutcome::Run(Box::new(run_reduced(mechanism, scene, basis, &reduced, watch)?))),
    }
}

/// Replaces a run that could not go on by a run of full equations of the same motion that goes on. Kane's
/// equations are tried first, then Lagrange's, whose motion variables are the rates. The new run
/// begins at the start and shows all that the scene requests. Returns the given run if no other run
/// is better.
///
/// Reduced equations contain momenta and may be in a moving frame. The motion may be regular where
/// that frame has a pole. So a failed run by reduced equations is replaced for any reason. A run by
/// full equations is replaced only if the equations divide by zero.
fn replace_failed_run(
    mechanism: &Mechanism,
    scene: &Scene,
    watch: Option<&WatchedInvariants>,
    run: Run,
) -> Result<Run, Error> {
    let Some(why) = reason_to_replace_run(&run) else { return Ok(run) };
    let mut doubtful = None;
    for formulation in [Formulation::Kane, Formulation::Lagrange] {
        let by = EquationsOrigin::from(formulation);
        if by == run.by {
            continue;
        }
        let mut other = match simulate_full_equations_watched(mechanism, scene, &by, watch) {
            Ok(other) => other,
            // A formulation that the model does not have cannot replace the run.
            Err(Error::Unsupported(_) | Error::Stopped(_)) => continue,
            Err(error) => return Err(error),
        };
        if other.failure().is_none() && reaches_as_far(scene, other.solution.t_end, run.solution.t_end) {
            let left =
                if run.by.is_reduced() { "the scene's own".to_owned() } else { format!("those by {}", run.by.title()) };
            other
                .notes
                .insert(0, format!("the full equations are integrated, by {}, since {left} {why}", other.by.title()));
            if other.warnings.is_empty() {
                return Ok(other);
            }
            // The next formulation may give a run without warnings.
            doubtful = doubtful.or(Some(other));
        } else if matches!(other.solution.stop, Stop::StepLimit { .. } | Stop::Interrupted) {
            break;
        }
    }
    Ok(doubtful.unwrap_or(run))
}

/// Reason why a run must be replaced, as the end of a sentence about its equations. `None` if the run
/// is kept.
fn reason_to_replace_run(run: &Run) -> Option<String> {
    let t = with_reliable_digits(run.solution.t_end, None);
    match &run.solution.stop {
        Stop::Interrupted => None,
        Stop::Singular { divisor } => Some(format!("divide by {divisor}, which is 0 at t = {t} s")),
        _ if !run.by.is_reduced() => None,
        stop if stop.is_failure() => Some(format!("stop at t = {t} s: {}", run.why)),
        _ => run.missing.as_ref().map(|what| format!("do not give all that is shown: {what}")),
    }
}

/// True if the instant `end`, s, is no earlier than `other`, in the direction of time of the scene's span.
pub(crate) fn reaches_as_far(scene: &Scene, end: f64, other: f64) -> bool {
    (end - other) * (scene.span.1 - scene.span.0).signum() >= 0.0
}

/// Runs a scene by one set of full equations, and shows the quantities that the scene requests.
///
/// # Errors
/// [`Error`] if the model does not have the formulation, or the equations cannot give a requested
/// quantity.
pub fn simulate_full_equations(model: &Mechanism, scene: &Scene, by: &EquationsOrigin) -> Result<Run, Error> {
    // Impacts change the conserved quantities, so first integrals are not proved.
    let watch = if scene.impacts.is_empty() { prove_integrals_to_watch(model)? } else { None };
    simulate_full_equations_watched(model, scene, by, watch.as_ref())
}

/// Runs a scene by one set of full equations, and shows the quantities that the scene requests.
/// `watch` are the first integrals to watch; `None` watches only the energy.
///
/// # Errors
/// Errors of [`simulate_full_equations`].
pub fn simulate_full_equations_watched(
    model: &Mechanism,
    scene: &Scene,
    by: &EquationsOrigin,
    watch: Option<&WatchedInvariants>,
) -> Result<Run, Error> {
    let code = runnable_code(model, by, scene.integration.distance, CodePreparation::preparation_for_runs(scene))?;
    let problem = Problem::new(model, scene, by, &code, None)?;
    let shown = ShownQuantities::new(model, scene)?;
    let Some(rates) = equations_in_all_rates(&problem)? else {
        return run_problem_with_quantities(&problem, watch, Some(&shown));
    };
    match simulate_in_chosen_speeds(&problem, &rates)? {
        Some(solution) => run_problem_by_solver(&problem, watch, Some(&shown), |_, _, _| Ok(solution)),
        None => {
            let mut run = simulate_with_changing_speeds(&problem, &rates, |problem| {
                run_problem_with_quantities(problem, watch, Some(&shown))
            })?;
            (run.by, run.code, run.solve) = (problem.by.clone(), problem.code.form(), problem.solve);
            Ok(run)
        }
    }
}

/// Solves a problem in its chosen generalized speeds alone. `None` if the run would have to change to
/// the rates of all coordinates. `rates` are the equations in these rates.
///
/// # Errors
/// `Error` if the problem cannot be run.
fn simulate_in_chosen_speeds(problem: &Problem<'_>, rates: &Code) -> Result<Option<Solution>, Error> {
    let balance = WatchedFunctions::new(problem.mechanism, problem.model, problem.scene, problem.by)?;
    let mut events = watched_events(problem, &balance);
    problem.run_in_chosen_speeds_alone(
        rates,
        &integration_options(problem.scene),
        &mut events,
        accumulated_load_power(problem)?,
    )
}

/// Runs a scene by full equations if the run changes between its speeds and the rates of all
/// coordinates. `None` if it does not change, or if the run fails.
///
/// # Errors
/// Errors of [`simulate_full_equations`].
pub fn simulate_if_speeds_change(model: &Mechanism, scene: &Scene, by: &EquationsOrigin) -> Result<Option<Run>, Error> {
    if !model.ties_rates() {
        return Ok(None);
    }
    let code = runnable_code(model, by, scene.integration.distance, CodePreparation::preparation_for_runs(scene))?;
    let problem = Problem::new(model, scene, by, &code, None)?;
    let Some(rates) = equations_in_all_rates(&problem)? else { return Ok(None) };
    if simulate_in_chosen_speeds(&problem, &rates)?.is_some() {
        return Ok(None);
    }
    let run = simulate_full_equations(model, scene, by)?;
    Ok((!run.solution.stop.is_failure()).then_some(run))
}

/// Equations in the rates of all coordinates, for poses in which the speeds of a run do not determine
/// the motion. `None` if no constraint makes such poses, or if the model has no equations in all
/// rates. Also `None` for scenes with impacts, quadrature, projection or a distance.
///
/// # Errors
/// [`Error::Input`] if the model cannot be derived.
pub fn equations_in_all_rates(problem: &Problem<'_>) -> Result<Option<Code>, Error> {
    let (model, scene, how) = (problem.mechanism, problem.scene, &problem.scene.integration);
    let is_free = !model.ties_rates() || model.speeds.is_empty();
    let is_own = how.distance.is_some() || how.project.is_some() || how.method == Integrator::Quadrature;
    if is_free || is_own || !scene.impacts.is_empty() {
        return Ok(None);
    }
    match runnable_code(model, &Formulation::Lagrange.into(), None, CodePreparation::AsDerived) {
        Err(Error::Unsupported(_) | Error::Stopped(_)) => Ok(None),
        code => code.map(Some),
    }
}

/// Prepares a problem that changes between its chosen speeds and the rates of all coordinates, and
/// returns the result of `run`. The speeds are used where they determine the motion. Elsewhere
/// `code`, the equations in all rates, is used.
///
/// # Errors
/// Errors of [`Problem::new`], and the errors of `run`.
pub fn simulate_with_changing_speeds<T>(
    problem: &Problem<'_>,
    code: &Code,
    run: impl FnOnce(&Problem<'_>) -> Result<T, Error>,
) -> Result<T, Error> {
    let (by, changes) = (EquationsOrigin::from(Formulation::Lagrange), Mutex::default());
    let chosen = ChosenSpeedEquations { by: problem.by, code: problem.code, solve: problem.solve, changes: &changes };
    let rates = Problem::new(problem.mechanism, problem.scene, &by, code, Some(AccelerationSolution::Numeric))?
        .with_chosen_speeds(chosen);
    run(&rates)
}

/// Runs a scene by its own reduced equations. If these have no value at the start, reduced equations
/// without constant momenta are used, because a momentum may not determine a speed there.
///
/// # Errors
/// [`Error`] if the run cannot begin. A run that began and could not go on is a [`Run`] that says so.
fn run_reduced(
    model: &Mechanism,
    scene: &Scene,
    basis: &ReductionBasis,
    reduced: &ReducedScene,
    watch: Option<&WatchedInvariants>,
) -> Result<Run, Error> {
    // First integrals of the whole model are functions of all states, which a scene may not show.
    let watch = watch.filter(|_| !scene.states_outputs);
    let code = reduced.code(model)?;
    let singular = Problem::reduced(model, reduced, scene, &code)?.reason_start_is_singular()?;
    let is_plain = reduced.constants().next().is_none() && reduced.reduction.frame.is_none();
    let (Some(singular), false) = (singular, is_plain) else {
        return simulate_reduced_equations(model, scene, reduced, &code, watch);
    };
    let plain = ReducedScene::without_momenta(basis, model, scene)?;
    let code = plain.code(model)?;
    if Problem::reduced(model, &plain, scene, &code)?.reason_start_is_singular()?.is_some() {
        return Err(Error::Stopped(format!("the run cannot start: {singular}")));
    }
    let mut run = simulate_reduced_equations(model, scene, &plain, &code, watch)?;
    run.notes.insert(0, format!("no momentum is held, since {singular}"));
    Ok(run)
}

/// Runs a scene by the reduced equations `reduced`, and computes the energies of the whole model.
fn simulate_reduced_equations(
    model: &Mechanism,
    scene: &Scene,
    reduced: &ReducedScene,
    code: &Code,
    watch: Option<&WatchedInvariants>,
) -> Result<Run, Error> {
    let problem = Problem::reduced(model, reduced, scene, code)?;
    let mut run = run_problem(&problem, watch)?;
    set_whole_model_energies(model, scene, &mut run)?;
    Ok(run)
}
