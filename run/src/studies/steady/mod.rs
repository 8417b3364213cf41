//! Equilibria, steady motions and the linear systems near them. They are computed in 32 digits from the
//! exact derivatives of a mechanism's equations.
//!
//! A motion is steady if it moves along symmetries of the mechanism. Its rates are then a combination
//! of the directions ζ of the symmetries: `x' = f(x) = Σ c ζ(x)` ([`tripos_derive::flow`]). So every
//! quantity that the symmetries leave unchanged is constant. Rest is the case c = 0.
//!
//! Differences d from a steady motion, in the frame that moves with it, obey
//! `d' = (Df − Σ c Dζ) d`. States that the symmetries shift are left out. Source: J. E. Marsden,
//! Lectures on Mechanics, 1992, chapter 5: relative equilibria.

mod continuation;
mod continuation_map;
mod equilibrium_search;
mod force_balance;
mod linear_system;
mod quotient_system;
mod singular_states;
mod spectra;
mod stability;
mod steady_conditions;
mod steady_family;
mod steady_newton;
mod steady_state;
mod symbolic_linear_system;

pub use continuation::{Continuation, ContinuationPoint, CrossingKind, StabilityCrossing, continue_steady_motion};
pub use continuation_map::{ContinuationMap, continuation_map};
pub use equilibrium_search::{FoundMotion, find_equilibria};
pub use linear_system::{LinearisationOptions, SteadyLinearSystem, linearise};
pub use quotient_system::{QuotientSystem, ShiftedStates};
pub use spectra::controllability::{TransferFunction, controllable_dimension};
pub use spectra::eigenvalues::eigenvalue_modes;
pub use spectra::mode::Mode;
pub use spectra::wide_matrix::WideMatrix;
pub use stability::Stability;
pub use steady_conditions::{
    BranchesAt, Conditions, Formula, NamedFormula, SolutionBranch, SteadyConditions, Velocity, conditions,
};
pub use steady_newton::Unknowns;
pub use steady_state::SteadyState;
pub use symbolic_linear_system::{SymbolicEntry, SymbolicLinearForm, symbolic_linear_system};

use crate::{Error, Mechanism};
use tripos_derive::algebra::Expr;
use tripos_derive::algebra::value::tape::Tape;
use tripos_derive::flow::{Flow, Program};
use tripos_derive::prove::IntegralKind;
use tripos_derive::scene::StateWithUnknowns;
use tripos_traits::DoubleDouble;

/// Mechanism prepared for the search of steady motions at given parameters: its equations of motion
/// and its outputs.
pub struct SteadyProblem {
    /// Equations of motion in first order, x' = f(x), with loops and symmetries.
    pub flow: Flow,
    /// Names of the states: coordinates, followed by generalized speeds.
    pub names: Vec<String>,
    /// Number of coordinates among the states.
    pub coordinates: usize,
    /// Index of the time t among the states; `None` if the model does not name the time.
    pub(crate) time: Option<usize>,
    /// Index of the shift of time among the symmetries. Along it, the time changes at the rate 1. `None`
    /// if there is no such symmetry.
    pub(crate) by_time: Option<usize>,
    /// Names of the loops, with redundant loops last.
    loops: Vec<String>,
    /// Tells for each state if it is an angle.
    is_angle: Vec<bool>,
    /// Indices of the parameters that are inputs of the linear system.
    inputs: Vec<usize>,
    /// Names of the outputs of the linear system.
    outputs: Vec<String>,
    /// Outputs of the linear system as expressions in states and parameters.
    output_terms: Vec<Expr>,
    /// Program that computes rates, loops, symmetries and outputs at a state, with their derivatives.
    program: Program,
    /// Test for states at which the equations of motion are singular.
    poles: singular_states::SingularStateTest,
    /// Tape of the program, for evaluation in 32 digits.
    wide: Tape<DoubleDouble>,
    /// Values of the parameters, to 32 digits, in the order of the model.
    parameters: Vec<DoubleDouble>,
}

impl SteadyProblem {
    /// Prepares a model for the search, with the parameters and outputs of a state file. `inputs` are the
    /// names of the parameters that are inputs of the linear system. If the list is empty, all inputs of
    /// the model are taken.
    ///
    /// # Errors
    /// [`Error`] if the model cannot be derived, depends on time, or lacks a named input or an output.
    pub fn new(model: &Mechanism, asked: &StateWithUnknowns, inputs: &[String]) -> Result<Self, Error> {
        let inputs = input_indices(model, inputs)?;
        let symbols: Vec<Expr> = inputs.iter().map(|at| model.parameters[*at].symbol).collect();
        let mut flow = steady_flow(model)?;
        let values: Vec<Expr> =
            asked.outputs.iter().map(|output| flow.flow_term_in_states(model, output.value)).collect();
        let program = flow.program(&symbols, &values).map_err(|unknown| {
            let what = format!("`{}` has no value in coordinates, speeds and parameters", unknown.0);
            Error::request(what, "choose among coordinates, speeds, rates and energies")
        })?;
        let poles = singular_states::SingularStateTest::new(model, &flow).map_err(|unknown| {
            Error::request(
                format!("`{}` has no value at a state", unknown.0),
                "please report this model: the derivation succeeded and the run did not",
            )
        })?;
        let names = model.coordinates.iter().map(|c| c.name.clone());
        Ok(Self {
            poles,
            names: names.chain(model.speeds.iter().map(|s| s.name.clone())).collect(),
            coordinates: model.coordinates.len(),
            time: model.time(),
            by_time: flow.time_shift_symmetry(model),
            loops: model.loops.iter().chain(&model.closed).map(|c| c.name.clone()).collect(),
            is_angle: model
                .coordinates
                .iter()
                .map(|c| c.unit.is_plain())
                .chain(model.speeds.iter().map(|_| false))
                .collect(),
            inputs,
            outputs: asked.outputs.iter().map(|output| output.name.clone()).collect(),
            output_terms: values,
            wide: program.tape().to(),
            program,
            parameters: asked.parameters.clone(),
            flow,
        })
    }

    /// True if a coordinate other than the time changes at the state `x`, or a speed is not zero.
    pub(crate) fn has_motion_at(&self, x: &[DoubleDouble]) -> bool {
        let doubles = |list: &[DoubleDouble]| list.iter().map(|x| x.hi()).collect::<Vec<f64>>();
        let (values, _) = self.program.evaluate(self.program.tape(), &doubles(&self.parameters), &doubles(x), &[]);
        let speeds = x[self.coordinates..].iter().any(|u| u.hi().abs() > 0.0);
        let goes_on = |(at, rate): (usize, &f64)| Some(at) != self.time && rate.abs() > 0.0;
        speeds || values.flow[..self.coordinates].iter().enumerate().any(goes_on)
    }

    /// Replaces the values of the parameters. `parameters` are in the order of the model.
    pub fn set_parameters(&mut self, parameters: &[DoubleDouble]) {
        self.parameters = parameters.to_vec();
    }
}

/// Derives the equations of motion of a model for steady motions. The equations must not depend on time,
/// although the model may name it.
///
/// # Errors
/// [`Error`] if the model has no generalized speed, cannot be derived, or depends on time.
fn steady_flow(model: &Mechanism) -> Result<Flow, Error> {
    model.require_speeds("the mechanism cannot move: every closed pose is at rest")?;
    let mut flow = Flow::new(model).map_err(|error| model.diagnose(&error))?;
    let Some(time) = model.time() else { return Ok(flow) };
    if flow.time_shift_symmetry(model).is_some() {
        // A rotation by a drive in time equals the shift of time, so only the shift of time is kept.
        flow.symmetries.retain(|field| field.kind == IntegralKind::Coordinate(time) || field.along[time] == Expr::ZERO);
        return Ok(flow);
    }
    let names: Vec<&String> =
        model.coordinates.iter().map(|c| &c.name).chain(model.speeds.iter().map(|s| &s.name)).collect();
    let what = flow.depends_on_time(model).map_or("closed loops".to_owned(), |at| format!("{}'", names[at]));
    let what = format!("{what} depends on the time t explicitly: the model has no steady motion");
    let help = "leave out of the model, or of [inputs], what names `t`; what is driven at a constant rate may name it where the \
                equations do not depend on it";
    Err(Error::request(what, help))
}

/// Finds the indices of the named parameters among all parameters. If `names` is empty, returns the
/// indices of all inputs of the model.
///
/// # Errors
/// `Error::Request` if the model has no parameter of a given name.
fn input_indices(model: &Mechanism, names: &[String]) -> Result<Vec<usize>, Error> {
    if names.is_empty() {
        return Ok((0..model.parameters.len()).filter(|at| model.parameters[*at].is_input).collect());
    }
    let place = |name: &String| {
        model.parameters.iter().position(|p| p.name == *name).ok_or_else(|| {
            let help =
                tripos_derive::diagnostic::nearest_name_advice(name, model.parameters.iter().map(|p| p.name.as_str()));
            Error::request(format!("the model has no input `{name}`"), help)
        })
    };
    names.iter().map(place).collect()
}
