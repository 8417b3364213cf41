//! Equations of motion, and products with their transposed derivatives. Code computes the rates. Tapes
//! that are run backwards compute the products.

use crate::code::{Code, compile_tape_with_steps, derive_or_read_equations};
use crate::error::Error;
use crate::mechanism::Mechanism;
use crate::preparation::problem::Problem;
use tripos_derive::algebra::Expr;
use tripos_derive::algebra::term::steps::needed_steps;
use tripos_derive::algebra::value::tape::{BackwardWorkspace, Tape};
use tripos_derive::mechanics::{
    Derivation, EquationsOrigin, SingularDistance, SolvedAccelerations, equations_in_distance,
};
use tripos_sim::{EliminatedDynamics, Failure, ProductSums, RightHandSide, TransposedRightHandSide};

/// Tapes that a backward sweep runs backwards: rates, constraints, kinetic energy and motion variables.
///
/// The inputs of the first three are the parameters, coordinates and motion variables. The inputs of
/// the tape of the motion variables are the parameters, coordinates and generalized speeds.
pub struct BackwardTapes {
    /// Tape of the rates q̇, followed by v̇.
    rates: Tape,
    /// Tape of the constraint functions that a run keeps at zero; `None` if there are none.
    constraints: Option<Tape>,
    /// Tape of the kinetic energy, J.
    pub energy: Tape,
    /// Tape of the motion variables v, as functions of the generalized speeds.
    pub motions: Tape,
}

impl BackwardTapes {
    /// Makes the tapes of a set of equations. The tapes of interpreted equations are copied. For compiled
    /// equations, the tapes are derived again. `distance` is the scene's distance from a singular
    /// surface.
    ///
    /// # Errors
    /// [`Error`] if the equations cannot be derived, or cannot be solved for their accelerations.
    pub fn new(
        mechanism: &Mechanism,
        by: &EquationsOrigin,
        distance: Option<SingularDistance>,
        code: &Code,
    ) -> Result<Self, Error> {
        if let Code::Interpreted(system) = code
            && let (Some(rates), constraints) = system.double.rates_and_constraints()
            && let (Some(energy), Some(motions)) = system.double.energy_and_motions()
        {
            let (rates, constraints) = (rates.clone(), constraints.cloned());
            return Ok(Self { rates, constraints, energy: energy.clone(), motions: motions.clone() });
        }
        let derived = derive_or_read_equations(mechanism, by)?;
        let Derivation { mut arena, equations } = match distance {
            Some(distance) => equations_in_distance(mechanism, derived, distance),
            None => derived,
        };
        let inputs = [mechanism.model.p(), equations.coordinates.clone(), equations.variables.clone()].concat();
        let values: Vec<Expr> = equations.constraints.iter().map(|c| c.value).collect();
        let of_values = needed_steps(&arena, &equations.definitions, &values);
        let constraints = (!values.is_empty())
            .then(|| compile_tape_with_steps(&arena, &inputs, &of_values, &values, "a constraint"))
            .transpose()?;
        let of = |arena: &_, inputs: &[Expr], values: &[Expr], what: &str| {
            compile_tape_with_steps(arena, inputs, &needed_steps(arena, &equations.definitions, values), values, what)
        };
        let energy = of(&arena, &inputs, &[equations.kinetic_energy], "an energy")?;
        let in_speeds = [mechanism.model.p(), equations.coordinates.clone(), mechanism.model.u()].concat();
        let motions = of(&arena, &in_speeds, &equations.motion_variables, "a motion variable")?;
        let written = equations.with_definitions(&mut arena);
        let steps = SolvedAccelerations::steps(&mut arena, &written)
            .map_err(|why| Error::request(format!("`{}`: {why}", by.name()), why.help()))?;
        let rates = [&written.coordinate_rates, &written.unknowns[..written.variables.len()]].concat();
        Ok(Self {
            rates: compile_tape_with_steps(&arena, &inputs, &steps, &rates, "a rate")?,
            constraints,
            energy,
            motions,
        })
    }
}

/// Equations of motion at the parameters of a problem, with products of their transposed derivatives.
pub struct TransposedProducts<'a> {
    /// Right-hand side with eliminated accelerations.
    rhs: EliminatedDynamics<'a>,
    /// Tapes of the equations of motion, which are run backwards.
    tapes: &'a BackwardTapes,
    /// Values of the parameters.
    parameters: &'a [f64],
    /// Working memory for the joined inputs of a tape.
    inputs: Vec<f64>,
    /// Working memory for the derivatives of a tape's outputs by its inputs.
    slopes: Vec<f64>,
    /// Working memory of the backward evaluation of a tape.
    room: BackwardWorkspace,
}

impl<'a> TransposedProducts<'a> {
    /// Prepares the equations of a problem for products with their transposed derivatives.
    ///
    /// # Errors
    /// [`Error::Request`] if the accelerations are not eliminated.
    pub fn new(problem: &'a Problem<'_>, tapes: &'a BackwardTapes) -> Result<Self, Error> {
        let parameters = problem.scene.parameters.as_slice();
        let rhs = EliminatedDynamics::new(problem.system(), parameters);
        let rhs = rhs.ok_or_else(|| Error::request("accelerations are not eliminated", "take other equations"))?;
        let (inputs, slopes) = (Vec::new(), Vec::new());
        Ok(Self { rhs, tapes, parameters, inputs, slopes, room: BackwardWorkspace::default() })
    }

    /// Adds the derivatives of a weighted sum of a tape's outputs to the sums `state` and `parameters`.
    /// The inputs of the tape are the parameters and the state `y`.
    fn pull_tape(&mut self, tape: &Tape, y: &[f64], weights: &[f64], (state, parameters): ProductSums<'_>) {
        self.inputs.clear();
        self.inputs.extend_from_slice(self.parameters);
        self.inputs.extend_from_slice(y);
        self.slopes.clear();
        self.slopes.resize(self.inputs.len(), 0.0);
        tape.backward_pass(&self.inputs, weights, &mut self.room, &mut self.slopes);
        let (by_parameters, by_state) = self.slopes.split_at(self.parameters.len());
        parameters.iter_mut().zip(by_parameters).for_each(|(sum, share)| *sum += share);
        state.iter_mut().zip(by_state).for_each(|(sum, share)| *sum += share);
    }
}

impl RightHandSide<f64> for TransposedProducts<'_> {
    fn rhs(&mut self, t: f64, y: &[f64], dydt: &mut [f64]) -> Result<(), Failure> {
        self.rhs.rhs(t, y, dydt)
    }

    fn constraint_count(&self) -> usize {
        self.rhs.constraint_count()
    }

    fn constraints(&mut self, t: f64, y: &[f64], values: &mut [f64], slopes: &mut [f64]) {
        self.rhs.constraints(t, y, values, slopes);
    }

    fn inertia(&mut self, t: f64, y: &[f64], out: &mut Vec<f64>) -> bool {
        self.rhs.inertia(t, y, out)
    }
}

impl TransposedRightHandSide for TransposedProducts<'_> {
    fn parameter_count(&self) -> usize {
        self.parameters.len()
    }

    fn add_transposed_product(
        &mut self,
        _t: f64,
        y: &[f64],
        weights: &[f64],
        to: ProductSums<'_>,
    ) -> Result<(), Failure> {
        let tapes = self.tapes;
        self.pull_tape(&tapes.rates, y, weights, to);
        Ok(())
    }

    fn add_transposed_constraint_product(
        &mut self,
        _t: f64,
        y: &[f64],
        weights: &[f64],
        to: ProductSums<'_>,
    ) -> Result<(), Failure> {
        let tapes = self.tapes;
        if let Some(tape) = &tapes.constraints {
            self.pull_tape(tape, y, weights, to);
        }
        Ok(())
    }
}
