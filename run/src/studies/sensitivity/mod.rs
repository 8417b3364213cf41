//! Sensitivities: derivatives of the quantities that a run shows, by parameters and by numbers of the
//! start.
//!
//! The run is made in numbers that carry derivatives, called slopes ([`tripos_traits::Tangent`]).
//! The same equations, compiled or interpreted, compute y′ = f and s′ = f_y s + f_p in one call. So
//! every integrator also computes the derivative of the steps that it takes. The run equals the run
//! without sensitivities bit by bit, because only the errors of the states determine the steps. A
//! second run gives the errors of the derivatives, as it does for the states.
//!
//! Source: H. G. Bock, "Numerical treatment of inverse problems in chemical reaction kinetics",
//! *Modelling of Chemical Reaction Systems* (1981), 102–125: internal numerical differentiation.
//!
//! If an event ends the run, the instant of the end depends on the varied number:
//! `dt/dp = −(g_y s + g_p)/(g_y f)`, with g = 0 at the event. The derivatives at the end then
//! include the shift of the end: `s + f dt/dp`. Other events change no derivative of the state.
//!
//! A backward sweep computes the derivatives of one quantity at the end by many numbers at once
//! ([`gradient`]).
//!
//! Reduced equations of a scene are not differentiated. They contain constants that would have to
//! be differentiated too.

mod contacts;
mod corners;
mod difference;
mod differentiable_quantities;
mod end_derivatives;
mod equations_with_slopes;
pub mod gradient;
mod held_tangents;
mod ridders_table;
mod run_differences;
mod slope_carrier;
mod varied_start;

use crate::equations_name::{EquationsName, find_equations_or_first};
use crate::error::Error;
use crate::integration_options::integration_options;
use crate::mechanism::Mechanism;
use crate::preparation::problem::Problem;
use crate::simulation::run::Run;
use crate::simulation::run_problem::{prove_integrals_to_watch, run_problem_by_solver};
use crate::simulation::shown_quantities::ShownQuantities;
use crate::simulation::simulate::simulate_if_speeds_change;
use differentiable_quantities::DifferentiableQuantities;
use end_derivatives::{EndDerivatives, end_derivative_errors, end_derivatives, event_time_derivatives};
use equations_with_slopes::{RunWithSlopes, SeededStart, SlopeEquations};
use run_differences::RunDifferences;
use tripos_derive::scene::{AccelerationSolution, Integrator, Scene};
use varied_start::VariedStart;

/// Run of a scene, with the derivatives of its shown quantities by the varied numbers.
pub struct Sensitivities {
    /// The run itself, equal bit by bit to the run without derivatives.
    pub run: Run,
    /// Names of the varied numbers (parameters and numbers of the start) by which derivatives are
    /// taken.
    pub by: Vec<String>,
    /// Names of the differentiated quantities: coordinates, generalized speeds, other outputs of the
    /// scene, `kinetic_energy` and `potential_energy`.
    pub names: Vec<String>,
    /// Units of the derivatives: a list for each number in `by`, in the order of `names`. `None` if the
    /// unit of an output is not known.
    pub units: Vec<Vec<Option<String>>>,
    /// Derivatives at the end of the run: a list for each number in `by`, in the order of `names`. If an
    /// event ends the run, they include the shift of the end. Otherwise they hold at a fixed instant.
    pub end: Vec<Vec<f64>>,
    /// Estimated errors of the derivatives at the end, in the order of `end`. `None` if no second run
    /// comes to the same end.
    pub errors: Option<Vec<Vec<f64>>>,
    /// Derivatives at fixed instants, the samples. Indices: number in `by`, sample, quantity in `names`.
    /// Empty if not requested.
    pub samples: Vec<Vec<Vec<f64>>>,
    /// Derivative of the instant of the run's end by each number in `by`, s per unit. They are 0 unless
    /// an event ends the run.
    pub t_end: Vec<f64>,
    /// Derivatives of the instant of each event by each number in `by`, s per unit. `None` for an event
    /// whose function does not cross zero.
    pub events: Vec<Option<Vec<f64>>>,
    /// Text that describes the second run, which gave the errors. `None` if no second run comes to the
    /// same end.
    pub assessed_by: Option<String>,
    /// Text with the instant and the reason at which the derivatives by each number in `by` end early.
    /// `None` if they reach the end of the run.
    pub ended: Vec<Option<String>>,
}

/// Instants of a run at which derivatives are computed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DerivativeInstants {
    /// Derivatives at the end of the run and at its events only.
    End,
    /// Derivatives at the end of the run, at its events and at each sample.
    Samples,
}

impl Sensitivities {
    /// Derivative of the quantity `name` by the varied number `by`, at the end of the run.
    ///
    /// # Errors
    /// [`Error::Request`] if no quantity or no varied number has the given name.
    pub fn derivative_of(&self, name: &str, by: &str) -> Result<f64, Error> {
        let place = |list: &[String], name: &str, what: &str| {
            list.iter().position(|other| other == name).ok_or_else(|| {
                let help = tripos_derive::diagnostic::nearest_name_advice(name, list.iter().map(String::as_str));
                Error::request(format!("{what} `{name}`"), help)
            })
        };
        let by = place(&self.by, by, "nothing is differentiated by")?;
        Ok(self.end[by][place(&self.names, name, "nothing is differentiated that is called")?])
    }

    /// Message about the first derivative at the end without a finite value. `None` if all are finite.
    #[must_use]
    pub fn missing_derivative(&self) -> Option<String> {
        let found = self.end.iter().zip(&self.by).find_map(|(list, by)| {
            let at = list.iter().position(|x| !x.is_finite())?;
            Some((&self.names[at], by))
        });
        let why = |by: &String| {
            let at = self.by.iter().position(|other| other == by)?;
            self.ended[at].as_ref().map(|why| format!(": {why}"))
        };
        found.map(|(name, by)| format!("d({name})/d({by}) has no value at the end{}", why(by).unwrap_or_default()))
    }
}

/// Runs a scene by full (not reduced) equations, with the derivatives of its shown quantities by the
/// numbers `names`. These are parameters and numbers of the start. `set` has the names and values of
/// the numbers that differ from the scene file. `by` names the equations; `None` takes the first
/// formulation of the model.
///
/// # Errors
/// [`Error::Input`] if the scene has no number with a given name. [`Error::Request`] if the equations or
/// the integrator cannot be differentiated, or if a number moves a jump of the equations so that the
/// derivative does not exist. Otherwise the errors of [`crate::simulate`].
pub fn sensitivities(
    mechanism: &Mechanism,
    scene: &Scene,
    set: &[(String, f64)],
    names: &[String],
    at: DerivativeInstants,
    by: Option<&EquationsName>,
) -> Result<Sensitivities, Error> {
    check_names(names)?;
    check_differentiable_equations(scene, by)?;
    let by = find_equations_or_first(mechanism, by)?;
    if by.printed_id().is_some() {
        let help = "take kane, lagrange or newton-euler";
        return Err(Error::request("printed equations are not differentiated", help));
    }
    if let Some(run) = simulate_if_speeds_change(mechanism, scene, &by)? {
        return sensitivities_by_differences(mechanism, scene, set, names, at, run);
    }
    let equations = SlopeEquations::new(mechanism, scene, &by, scene.integration.method.method().unwrap_or_default())?;
    let problem = Problem::new(mechanism, scene, &by, &equations.code, Some(AccelerationSolution::Eliminated))?;
    let seeds = names.iter().map(|name| VariedStart::new(&problem, set, name)).collect::<Result<Vec<_>, _>>()?;
    let how = integration_options(scene);
    seeds.iter().try_for_each(|seed| {
        corners::check_moved_corners(&problem, seed, &how).and_then(|()| seed.check_friction_from_zero(scene))
    })?;
    let (shown, quantities) =
        (ShownQuantities::new(mechanism, scene)?, DifferentiableQuantities::new(mechanism, scene)?);
    let slopes: Vec<Vec<f64>> = seeds.iter().map(|seed| seed.state.clone()).collect();
    let mut carried = None;
    let mut run = run_problem_by_solver(
        &problem,
        prove_integrals_to_watch(mechanism)?.as_ref(),
        Some(&shown),
        |y0, options, events| {
            let from = SeededStart { span: scene.span, y: y0, seeds: &seeds, slopes: &slopes };
            let carried = carried.insert(equations.run(&problem, &from, options, events)?);
            Ok(carried.solution.clone())
        },
    )?;
    let carried = carried.ok_or_else(|| Error::Stopped("the run was not made".to_owned()))?;
    let parts = SensitivityInputs { problem: &problem, equations: &equations, quantities: &quantities, seeds: &seeds };
    let own = end_derivatives(&parts, &carried)?;
    let (errors, assessed_by) = end_derivative_errors(&parts, &carried, &own, &slopes)?;
    let samples = match at {
        DerivativeInstants::End => Vec::new(),
        DerivativeInstants::Samples => samples(&parts, &carried)?,
    };
    let events = event_time_derivatives(&parts, &carried, &own.t)?;
    let ended: Vec<Option<String>> =
        carried.history.endings.iter().map(|ending| Some(ending.as_ref()?.to_string())).collect();
    run.notes.splice(..0, notes(mechanism, &seeds, &carried, &own));
    run.warnings.extend(sensitivity_warning_at_signs(mechanism));
    let over = names.iter().zip(&ended).filter_map(|(name, why)| Some((name, why.as_ref()?)));
    run.warnings.extend(over.map(|(name, why)| format!("there are no derivatives by `{name}` {why}")));
    let unit = |of: &Option<tripos_derive::model::Unit>, seed: &VariedStart| {
        Some(of.as_ref()?.divided_by(&seed.unit).to_string())
    };
    let units = seeds.iter().map(|seed| quantities.units.iter().map(|of| unit(of, seed)).collect()).collect();
    let (end, t_end) = (own.shown, own.t);
    Ok(Sensitivities {
        run,
        by: names.to_vec(),
        names: quantities.names,
        units,
        end,
        errors,
        samples,
        t_end,
        events,
        assessed_by,
        ended,
    })
}

/// Computes the derivatives of a run that changes its generalized speeds on the way, from differences
/// with neighbouring runs.
///
/// # Errors
/// `Error::Request` if derivatives at samples are requested. `Error` if a neighbouring run cannot be
/// made, or ends for another reason.
fn sensitivities_by_differences(
    mechanism: &Mechanism,
    scene: &Scene,
    set: &[(String, f64)],
    names: &[String],
    at: DerivativeInstants,
    run: Run,
) -> Result<Sensitivities, Error> {
    if at == DerivativeInstants::Samples {
        let what = "a run that replaces its generalized speeds has no derivatives at samples";
        return Err(Error::request(
            what,
            "ask for derivatives at the end, or choose speeds that determine the motion everywhere",
        ));
    }
    let quantities = DifferentiableQuantities::new(mechanism, scene)?;
    let apart = RunDifferences { mechanism, scene, set, by: &run.by, names: &quantities.names };
    let list = names.iter().map(|name| apart.differentiate_by(name, &run)).collect::<Result<Vec<_>, _>>()?;
    let unit = |of: &Option<tripos_derive::model::Unit>, by| Some(of.as_ref()?.divided_by(by).to_string());
    let event = |at: usize| list.iter().map(|found| Some(found.events.as_ref()?[at])).collect();
    Ok(Sensitivities {
        by: names.to_vec(),
        units: list.iter().map(|found| quantities.units.iter().map(|of| unit(of, &found.unit)).collect()).collect(),
        end: list.iter().map(|found| found.values.clone()).collect(),
        errors: list.iter().map(|found| found.errors.clone()).collect(),
        samples: Vec::new(),
        t_end: list.iter().map(|found| found.t_end).collect(),
        events: (0..run.solution.events.len()).map(event).collect(),
        assessed_by: Some(run_differences::WORDS.to_owned()),
        ended: vec![None; names.len()],
        names: quantities.names,
        run,
    })
}

/// Inputs for the derivatives of a run: scene, equations, quantities, and varied numbers.
struct SensitivityInputs<'a> {
    /// Scene with its equations of motion in double precision.
    problem: &'a Problem<'a>,
    /// Equations of motion in numbers with slopes (derivatives).
    equations: &'a SlopeEquations,
    /// Quantities that are differentiated: shown quantities, energies, and the functions of events.
    quantities: &'a DifferentiableQuantities,
    /// Varied numbers, by which the derivatives are taken.
    seeds: &'a [VariedStart],
}

/// Checks that the list of varied numbers is not empty and names no number twice.
///
/// # Errors
/// `Error::Request` if the list is empty or names a number twice.
fn check_names(names: &[String]) -> Result<(), Error> {
    if names.is_empty() {
        let help = "name parameters or numbers of the start";
        return Err(Error::request("there is nothing to differentiate by", help));
    }
    match names.iter().enumerate().find(|(at, name)| names[..*at].contains(name)) {
        Some((_, twice)) => Err(Error::request(format!("`{twice}` is named twice"), "leave one of them out")),
        None => Ok(()),
    }
}

/// Checks that the equations and the integrator of a scene can be differentiated.
///
/// # Errors
/// `Error::Request` for reduced equations, quadrature, projection, or accelerations that are solved for
/// numerically.
fn check_differentiable_equations(scene: &Scene, by: Option<&EquationsName>) -> Result<(), Error> {
    let how = &scene.integration;
    let refuse = |what: &str, help: &str| Err(Error::request(what, help));
    if by == Some(&EquationsName::Reduced) {
        let help = "leave `--by` out: derivatives need the full equations";
        return refuse("a scene's reduced equations are not differentiated", help);
    }
    if how.method == Integrator::Quadrature {
        return refuse("motions by quadrature are not differentiated", "give a stepping method, such as dop853");
    }
    if how.project.is_some() {
        let help = "leave the projection out: tolerances can be as fine as 1e-13";
        return refuse("runs that are projected onto their energy are not differentiated", help);
    }
    if how.solve == Some(AccelerationSolution::Numeric) {
        let help = "leave `solve` out: eliminated accelerations are differentiated";
        return refuse("a numeric solve for accelerations is not differentiated", help);
    }
    Ok(())
}

/// Notes to the user about the derivatives of a run, such as a number on which no shown value depends.
fn notes(mechanism: &Mechanism, seeds: &[VariedStart], carried: &RunWithSlopes, end: &EndDerivatives) -> Vec<String> {
    let mut list = Vec::new();
    if mechanism.loops.is_empty() {
        list.push("the full equations are integrated, since derivatives need them".to_owned());
    }
    for (at, seed) in seeds.iter().enumerate() {
        let states = carried.at[at].iter().chain([&carried.end[at]]).flatten();
        if states.chain(&end.shown[at]).all(|x| *x == 0.0) {
            list.push(format!("no shown value depends on `{}`: all derivatives are 0", seed.name));
        }
        if seed.moves_span {
            list.push(format!("the span depends on `{}`: derivatives are those at fixed instants", seed.name));
        }
    }
    list
}

/// Warning that derivatives may lack the effect of jumps where a sign of a state changes. `None` if the
/// model contains no such sign.
fn sensitivity_warning_at_signs(mechanism: &Mechanism) -> Option<String> {
    let list = mechanism.model.sign_arguments_of_states();
    let shown: Vec<String> = list.iter().map(|text| format!("`{text}`")).collect();
    (!list.is_empty()).then(|| {
        format!(
            "the model has the sign of {}: where the equations jump as it changes, derivatives lack what the jump adds",
            shown.join(", ")
        )
    })
}

/// Computes the derivatives of the shown quantities at each sample. Indices: varied number, sample,
/// quantity.
///
/// # Errors
/// `Error::Request` if the number of parameters does not fit the equations.
fn samples(parts: &SensitivityInputs<'_>, carried: &RunWithSlopes) -> Result<Vec<Vec<Vec<f64>>>, Error> {
    let solution = &carried.solution;
    let mut lists = vec![Vec::with_capacity(solution.t.len()); parts.seeds.len()];
    for (sample, (t, y)) in solution.t.iter().zip(&solution.y).enumerate() {
        let place = parts.quantities.prepare_state(parts.problem, *t, y)?;
        for ((seed, list), at) in parts.seeds.iter().zip(&mut lists).zip(&carried.at) {
            list.push(parts.quantities.quantity_derivatives(&place, &seed.parameters, &at[sample]).shown);
        }
    }
    Ok(lists)
}

/// Integration options of a short run from a sample to a later instant. They are the scene's, with
/// output at the ends only.
fn short_sensitivity_run_options(parts: &SensitivityInputs<'_>) -> tripos_sim::Options {
    tripos_sim::Options { output: tripos_sim::OutputOption::Ends, ..integration_options(parts.problem.scene) }
}
