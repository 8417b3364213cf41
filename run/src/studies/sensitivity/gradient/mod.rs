//! Gradient of a quantity at the end of a run: its derivatives by all parameters and all numbers of
//! the start at once.
//!
//! The run is the same as without a gradient. Then a backward sweep repeats its steps from the end to
//! the start, each step transposed ([`tripos_sim::adjoint`]). The code of the run computes the rates.
//! Tapes that are run backwards give products with the transposed derivatives of the rates. The start
//! and the quantity at the end are differentiated as for forward derivatives. So the result equals
//! forward derivatives along the same steps, but its cost does not grow with the number of varied
//! numbers. A second run with other steps, also swept backwards, gives the estimated errors.
//!
//! Across impacts and other changes of contacts, the sweep uses the transpose of the map for forward
//! derivatives (`backward_crossings`). While contacts are held closed, it uses the transpose of the
//! map to their forces (`transposed_contact_forces`).
//!
//! Implicit methods and Taylor's method have no backward sweep here. DOP853 replaces them.

mod backward_crossings;
mod backward_sweep;
mod recorded_steps;
mod transposed_contact_forces;
mod transposed_products;
mod varied_numbers;

use super::differentiable_quantities::DifferentiableQuantities;
use super::equations_with_slopes::{SeededStart, SlopeEquations};
use super::run_differences::{RunDifferences, WORDS};
use super::varied_start::VariedStart;
use super::{check_differentiable_equations, sensitivity_warning_at_signs};
use crate::code::{CodePreparation, runnable_code};
use crate::equations_name::{EquationsName, find_equations_or_first};
use crate::error::Error;
use crate::integration_options::{integration_options, integration_options_for_ends};
use crate::mechanism::Mechanism;
use crate::preparation::problem::Problem;
use crate::simulation::run::Run;
use crate::simulation::run_problem::{prove_integrals_to_watch, run_problem_by_solver};
use crate::simulation::shown_quantities::ShownQuantities;
use crate::simulation::simulate::simulate_if_speeds_change;
use crate::trust::correct_digits::parameters_one_rounding_away;
use crate::trust::watched_functions::{WatchedFunctions, watched_events};
use backward_sweep::{BackwardSweep, SweepInputs, Target, sweep_backwards};
use recorded_steps::RecordedRun;
use transposed_products::BackwardTapes;
use tripos_derive::model::{TIME, Unit};
use tripos_derive::plain_text::with_reliable_digits;
use tripos_derive::scene::{AccelerationSolution, Scene};
use tripos_sim::adjoint::has_adjoint;
use tripos_sim::{Method, Options, SecondRun, Stop, TaylorSeries, second_runs};
use tripos_traits::larger;
use varied_numbers::{VariedNumber, varied_number_names, varied_numbers};

/// Run of a scene with the gradient of one quantity at its end.
pub struct Gradient {
    /// The run itself, equal bit by bit to the run without a gradient.
    pub run: Run,
    /// Scene as it was run. Its integrator is DOP853 if the scene's own integrator cannot be swept
    /// backwards.
    pub scene: Scene,
    /// Name of the differentiated quantity: an output, a coordinate, a generalized speed or an energy.
    /// It is `t` for the instant at which an event ends the run.
    pub of: String,
    /// True if an event ends the run. The derivatives then include the shift of the end. Otherwise they
    /// hold at a fixed instant.
    pub is_total: bool,
    /// Derivatives of the quantity by each parameter and each number that the start states, in the
    /// order of the model.
    pub slopes: Vec<Slope>,
    /// Names of the numbers on which the span of the run depends. The derivatives by these numbers hold
    /// at a fixed instant.
    pub moving_span: Vec<String>,
    /// Text that describes the second run, which gave the errors. `None` if no second run came to the
    /// same end.
    pub assessed_by: Option<String>,
    /// Largest number of states that the backward sweep stored at one time.
    pub states: usize,
}

/// Derivative of a quantity at the end of a run by one varied number.
#[derive(Clone, Debug, PartialEq)]
pub struct Slope {
    /// Name of the varied number.
    pub by: String,
    /// Unit of the derivative. `None` if the unit of the quantity is not known, or if the derivative does
    /// not exist.
    pub unit: Option<String>,
    /// Value of the derivative; NaN if it does not exist.
    pub value: f64,
    /// Estimated error of the derivative, in its unit; `None` if no second run came to the same end.
    pub error: Option<f64>,
    /// Reason why the derivative does not exist; `None` if it exists.
    pub missing: Option<String>,
}

impl Gradient {
    /// Finds the derivative by the varied number with the given name.
    ///
    /// # Errors
    /// [`Error::Request`] if there is no varied number of this name.
    pub fn slope_by(&self, name: &str) -> Result<&Slope, Error> {
        let found = self.slopes.iter().find(|slope| slope.by == name);
        found.ok_or_else(|| {
            let known = self.slopes.iter().map(|slope| slope.by.as_str());
            Error::request(format!("nothing is differentiated by `{name}`"), nearest(name, known))
        })
    }

    /// Message about a derivative without a value. It names the first derivative that should have a finite
    /// value and has none, or the first of all if no derivative exists. `None` if no value is missing.
    #[must_use]
    pub fn missing(&self) -> Option<String> {
        let first = self.slopes.first().filter(|_| self.slopes.iter().all(|slope| slope.missing.is_some()));
        if let Some((first, why)) = first.and_then(|first| Some((first, first.missing.as_ref()?))) {
            return Some(format!("d({})/d({}) has no value at the end: {why}", self.of, first.by));
        }
        let slope = self.slopes.iter().find(|slope| slope.missing.is_none() && !slope.value.is_finite())?;
        Some(format!("d({})/d({}) has no value at the end", self.of, slope.by))
    }
}

/// Runs a scene by full (not reduced) equations, with the gradient of the quantity `of` at the end of
/// the run. `set` has the names and values of the numbers that differ from the scene file. `by` names
/// the equations; `None` takes the first formulation of the model.
///
/// # Errors
/// [`Error::Request`] if the scene shows no quantity of this name, or if the equations or the
/// integrator cannot be differentiated. Otherwise the errors of [`crate::simulate`].
pub fn gradient(
    mechanism: &Mechanism,
    scene: &Scene,
    set: &[(String, f64)],
    of: &str,
    by: Option<&EquationsName>,
) -> Result<Gradient, Error> {
    check_differentiable_equations(scene, by)?;
    let own = scene.integration.method.method().unwrap_or_default();
    let scene = with_adjoint_method(scene, own);
    let by = find_equations_or_first(mechanism, by)?;
    if by.printed_id().is_some() {
        return Err(Error::request("printed equations are not differentiated", "take kane, lagrange or newton-euler"));
    }
    if let Some(run) = simulate_if_speeds_change(mechanism, &scene, &by)? {
        return gradient_by_differences(mechanism, scene, set, of, run);
    }
    let code = runnable_code(mechanism, &by, scene.integration.distance, CodePreparation::Solved)?;
    let problem = Problem::new(mechanism, &scene, &by, &code, Some(AccelerationSolution::Eliminated))?;
    let (shown, quantities) =
        (ShownQuantities::new(mechanism, &scene)?, DifferentiableQuantities::new(mechanism, &scene)?);
    let target = find_gradient_target(&quantities, &scene, of)?;
    let numbers = varied_numbers(&problem, set, &integration_options(&scene));
    let tapes = BackwardTapes::new(mechanism, &by, scene.integration.distance, &code)?;
    let with_slopes =
        || SlopeEquations::new(mechanism, &scene, &by, scene.integration.method.method().unwrap_or_default());
    let equations = (!scene.impacts.is_empty()).then(with_slopes).transpose()?;
    let mut stepped = None;
    let mut run = run_problem_by_solver(
        &problem,
        prove_integrals_to_watch(mechanism)?.as_ref(),
        Some(&shown),
        |y0, options, events| {
            let run = stepped.insert(RecordedRun::new(&problem, y0, options, events)?);
            Ok(run.solution.clone())
        },
    )?;
    let stepped = stepped.ok_or_else(|| Error::Stopped("the run was not made".to_owned()))?;
    let through =
        SweepInputs { tapes: &tapes, quantities: &quantities, numbers: &numbers, equations: equations.as_ref() };
    let parts = GradientInputs { through, target };
    let is_total = stepped.ending_event().is_some();
    if target == Target::End && !is_total && !stepped.solution.stop.is_failure() {
        let help = "a gradient of an event's time needs a terminal event: give the scene one";
        return Err(Error::request(
            format!("no event ended the run at t = {} s", with_reliable_digits(stepped.solution.t_end, None)),
            help,
        ));
    }
    let assessed =
        if stepped.solution.stop.is_failure() { None } else { Some(parts.assess_gradient(&problem, &stepped)?) };
    run.notes.splice(..0, notes(mechanism, own, &scene, &numbers));
    run.warnings.extend(sensitivity_warning_at_signs(mechanism));
    let missing: Vec<Option<String>> = match &assessed {
        Some(known) => known.missing.clone(),
        None => numbers.iter().map(|number| number.seed.as_ref().err().cloned()).collect(),
    };
    run.warnings.extend(missing_gradient_warnings(&numbers, &missing));
    let slopes = numbers.iter().zip(missing).enumerate().map(|(at, (number, missing))| {
        let known = assessed.as_ref().filter(|_| missing.is_none());
        Slope {
            by: number.name.clone(),
            unit: number.seed.as_ref().ok().and_then(|seed| Some(unit(&parts)?.divided_by(&seed.unit).to_string())),
            value: known.map_or(f64::NAN, |known| known.own.derivative_by(at, number).0),
            error: known.and_then(|known| Some(known.errors.as_ref()?[at])),
            missing: missing.or_else(|| assessed.is_none().then(|| "the run came to no end".to_owned())),
        }
    });
    let slopes = slopes.collect();
    let (states, assessed_by) = assessed.map_or((0, None), |known| (known.own.states, known.by));
    // An event that ends the run has an instant of its own.
    let moving_span = if is_total { Vec::new() } else { moving_span(&numbers) };
    Ok(Gradient { run, of: of.to_owned(), is_total, slopes, moving_span, assessed_by, states, scene })
}

/// Computes the gradient of a run that changes its generalized speeds on the way, from differences with
/// neighbouring runs.
///
/// # Errors
/// `Error::Request` if the scene shows no quantity named `of`.
fn gradient_by_differences(
    mechanism: &Mechanism,
    scene: Scene,
    set: &[(String, f64)],
    of: &str,
    mut run: Run,
) -> Result<Gradient, Error> {
    let quantities = DifferentiableQuantities::new(mechanism, &scene)?;
    let target = find_gradient_target(&quantities, &scene, of)?;
    let by = run.by.clone();
    let apart = RunDifferences { mechanism, scene: &scene, set, by: &by, names: &quantities.names };
    let slope = |name: String| match apart.differentiate_by(&name, &run) {
        Ok(found) => {
            let (value, error, own) = match target {
                Target::End => (found.t_end, None, Some(Unit::new(0, 0, 1))),
                Target::Shown(at) => {
                    (found.values[at], found.errors.map(|errors| errors[at]), quantities.units[at].clone())
                }
            };
            Slope {
                by: name,
                unit: own.map(|own| own.divided_by(&found.unit).to_string()),
                value,
                error,
                missing: None,
            }
        }
        Err(error) => {
            Slope { by: name, unit: None, value: f64::NAN, error: None, missing: Some(Error::first_line(&error)) }
        }
    };
    let slopes: Vec<Slope> = varied_number_names(mechanism, &scene).into_iter().map(slope).collect();
    run.warnings.extend(
        slopes
            .iter()
            .filter_map(|slope| Some(format!("there is no derivative by `{}`: {}", slope.by, slope.missing.as_ref()?))),
    );
    let is_total = matches!(run.solution.stop, Stop::Event { .. } | Stop::LeftDomain { .. });
    let (assessed_by, moving_span) = (Some(WORDS.to_owned()), Vec::new());
    Ok(Gradient { run, of: of.to_owned(), is_total, slopes, moving_span, assessed_by, states: 0, scene })
}

/// Returns the scene with DOP853 in place of its integrator `own`, if `own` cannot be swept backwards.
/// The tolerances stay the same.
fn with_adjoint_method(scene: &Scene, own: Method) -> Scene {
    let mut scene = scene.clone();
    if !has_adjoint(own) {
        scene.integration.method = Method::Dop853.into();
    }
    scene
}

/// Advice that names the known name that is most similar to an unknown name.
fn nearest<'n>(name: &str, known: impl Iterator<Item = &'n str>) -> String {
    tripos_derive::diagnostic::nearest_name_advice(name, known)
}

/// Finds the quantity named `of` at the end of a run. The name `t` stands for the instant at which an
/// event ends the run.
///
/// # Errors
/// `Error::Request` if the scene shows no quantity of this name.
fn find_gradient_target(quantities: &DifferentiableQuantities, scene: &Scene, of: &str) -> Result<Target, Error> {
    if of == TIME {
        return Ok(Target::End);
    }
    let found = quantities.names.iter().position(|name| name == of);
    found.map(Target::Shown).ok_or_else(|| {
        let known = quantities.names.iter().map(String::as_str).chain(scene.events.first().map(|_| TIME));
        Error::request(format!("the scene shows no `{of}`"), nearest(of, known))
    })
}

/// Unit of the quantity whose gradient is computed; `None` if it is not known.
fn unit(parts: &GradientInputs<'_>) -> Option<Unit> {
    match parts.target {
        Target::End => Some(Unit::new(0, 0, 1)),
        Target::Shown(at) => parts.through.quantities.units[at].clone(),
    }
}

/// Notes to the user about the gradient of a run, such as an integrator that was replaced. `own` is the
/// integrator of the scene file.
fn notes(mechanism: &Mechanism, own: Method, scene: &Scene, numbers: &[VariedNumber]) -> Vec<String> {
    let mut list = Vec::new();
    if mechanism.loops.is_empty() {
        list.push("the full equations are integrated, since derivatives need them".to_owned());
    }
    let run = scene.integration.method.name();
    if own.name() != run {
        list.push(format!("the method {} has no gradient: the run is by {run}, to the same tolerances", own.name()));
    }
    list.extend(
        moving_span(numbers)
            .iter()
            .map(|name| format!("the span depends on `{name}`: the derivative is that at a fixed instant")),
    );
    list
}

/// Names of the numbers on which the span of the run depends.
fn moving_span(numbers: &[VariedNumber]) -> Vec<String> {
    let moving = numbers.iter().filter(|number| number.seed.as_ref().is_ok_and(|seed| seed.moves_span));
    moving.map(|number| number.name.clone()).collect()
}

/// Warnings about the derivatives that do not exist, one for each reason.
fn missing_gradient_warnings(numbers: &[VariedNumber], missing: &[Option<String>]) -> Vec<String> {
    let mut list: Vec<(&String, Vec<String>)> = Vec::new();
    for (number, why) in numbers.iter().zip(missing).filter_map(|(number, why)| Some((number, why.as_ref()?))) {
        let name = format!("`{}`", number.name);
        match list.iter_mut().find(|(other, _)| *other == why) {
            Some((_, names)) => names.push(name),
            None => list.push((why, vec![name])),
        }
    }
    let said = |(why, names): (&String, Vec<String>)| format!("there is no derivative by {}: {why}", names.join(", "));
    list.into_iter().map(said).collect()
}

/// Quantity whose gradient is computed, with the tapes and varied numbers for it.
struct GradientInputs<'a> {
    /// Tapes, quantities and varied numbers of the backward sweep.
    through: SweepInputs<'a>,
    /// Quantity at the end of the run that is differentiated.
    target: Target,
}

/// Gradient with its estimated errors, and a text about the second run that gave the errors.
struct AssessedGradient {
    /// Gradient of the run itself.
    own: BackwardSweep,
    /// Estimated error of the derivative by each varied number. `None` if no second run came to the same
    /// end.
    errors: Option<Vec<f64>>,
    /// Text that describes the second run. `None` if no second run came to the same end.
    by: Option<String>,
    /// Reason why the derivative by each number does not exist; `None` if it exists.
    missing: Vec<Option<String>>,
}

/// Least error of a derivative, relative to the sum of the sizes of its terms: eight rounding errors.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

impl GradientInputs<'_> {
    /// Sweeps backwards through the recorded steps of a run, and returns the derivatives of the target.
    ///
    /// # Errors
    /// `Error::Interrupted` if the observer ends the sweep; `Error::Stopped` if a value does not exist.
    fn sweep(&self, problem: &Problem<'_>, options: &Options, run: &RecordedRun) -> Result<BackwardSweep, Error> {
        sweep_backwards(problem, &self.through, self.target, options, run)
    }

    /// Finds for each number the reason why the derivative by it does not exist; `None` if it exists. If
    /// the sweep cannot tell, a run with forward derivatives decides.
    ///
    /// # Errors
    /// `Error` if the run with forward derivatives cannot be made.
    fn missing(&self, problem: &Problem<'_>, y0: &[f64], own: &BackwardSweep) -> Result<Vec<Option<String>>, Error> {
        let numbers = self.through.numbers;
        let mut list: Vec<Option<String>> = (0..numbers.len()).map(|at| own.missing_reason(at)).collect();
        let (Some(equations), true, None) = (self.through.equations, own.asks, &own.ended) else { return Ok(list) };
        let known = |at: &usize| list[*at].is_none();
        let places: Vec<usize> = (0..numbers.len()).filter(known).collect();
        let seeds: Vec<VariedStart> = places.iter().filter_map(|at| numbers[*at].seed.as_ref().ok().cloned()).collect();
        if seeds.is_empty() {
            return Ok(list);
        }
        let slopes: Vec<Vec<f64>> = seeds.iter().map(|seed| seed.state.clone()).collect();
        let from = SeededStart { span: problem.scene.span, y: y0, seeds: &seeds, slopes: &slopes };
        let balance = WatchedFunctions::new(problem.mechanism, problem.model, problem.scene, problem.by)?;
        let mut watched = watched_events(problem, &balance);
        let run = equations.run(problem, &from, &integration_options_for_ends(problem.scene), &mut watched)?;
        for (at, ending) in places.into_iter().zip(run.history.endings) {
            list[at] = ending.map(|ending| ending.to_string());
        }
        Ok(list)
    }

    /// Computes the gradient of a run, and estimates its errors by a second run with other steps. The
    /// start and the parameters of the second run differ by one rounding.
    ///
    /// # Errors
    /// `Error` if a run cannot be made or a sweep stops.
    fn assess_gradient(&self, problem: &Problem<'_>, first: &RecordedRun) -> Result<AssessedGradient, Error> {
        let how = integration_options_for_ends(problem.scene);
        let y0 = problem.start()?;
        let own = self.sweep(problem, &how, first)?;
        let missing = self.missing(problem, &y0, &own)?;
        if first.solution.steps == 0 {
            return Ok(AssessedGradient { own, errors: None, by: None, missing });
        }
        let scene = Scene { parameters: parameters_one_rounding_away(problem.scene), ..problem.scene.clone() };
        let beside = problem.with_scene(&scene);
        let balance = WatchedFunctions::new(problem.mechanism, problem.model, &scene, problem.by)?;
        let y: Vec<f64> = y0.iter().map(|y| y * (1.0 + f64::EPSILON)).collect();
        for SecondRun { options, part, words, .. } in
            second_runs(&how, &first.solution, problem.scene.span, TaylorSeries::Costly)
        {
            let mut watched = watched_events(&beside, &balance);
            let run = RecordedRun::new(&beside, &y, &options, &mut watched)?;
            if run.solution.stop.code() == first.solution.stop.code() {
                let other = self.sweep(&beside, &options, &run)?;
                if other.ended.is_some() == own.ended.is_some() {
                    let errors = Some(self.gradient_errors(&own, &other, part));
                    return Ok(AssessedGradient { errors, by: Some(words), own, missing });
                }
            }
        }
        Ok(AssessedGradient { own, errors: None, by: None, missing })
    }

    /// Estimates the errors of a gradient from its differences to a second gradient. `part` is the factor
    /// from a difference to the error. Each derivative gets at least the median of the relative
    /// differences, because two motions that oscillate about each other may agree by chance.
    fn gradient_errors(&self, own: &BackwardSweep, other: &BackwardSweep, part: f64) -> Vec<f64> {
        let numbers = self.through.numbers.iter().enumerate();
        let pairs: Vec<_> =
            numbers.map(|(at, number)| (own.derivative_by(at, number), other.derivative_by(at, number).0)).collect();
        let apart = |((value, _), other): &((f64, f64), f64)| (value - other).abs();
        let known = pairs.iter().filter(|((value, _), _)| value.is_finite() && *value != 0.0);
        let mut relative: Vec<f64> = known.map(|pair| apart(pair) / pair.0.0.abs()).collect();
        relative.sort_by(f64::total_cmp);
        let half = relative.get(relative.len() / 2).copied().unwrap_or(0.0);
        let error = |pair: &((f64, f64), f64)| {
            let (value, size) = pair.0;
            part * larger(apart(pair), half * value.abs()) + ROUNDING * size
        };
        pairs.iter().map(error).collect()
    }
}
