//! Equations with products of their transposed slopes. The code that runs computes the rates, and its tapes, run
//! backwards, the products.

use crate::code::{Code, derivation, stepwise};
use crate::error::Error;
use crate::mechanism::Mechanism;
use crate::preparation::problem::Problem;
use tripos_derive::algebra::Expr;
use tripos_derive::algebra::term::steps::needed;
use tripos_derive::algebra::value::evaluate::{Backwards, Tape};
use tripos_derive::mechanics::{Derivation, Distance, EquationsOrigin, Solved, in_distance};
use tripos_sim::{Eliminated, Failure, Pulled, RightHandSide, Transposed};

/// Tapes that a gradient runs backwards: rates, constraints, kinetic energy and motion variables.
///
/// Rates, constraints and energy read parameters, coordinates and motion variables. The motion variables read
/// parameters, coordinates and speeds.
pub struct Tapes {
    /// Tape of q̇ and v̇.
    rates: Tape,
    /// Tape of the constraints onto which a run is kept; `None` if there are none.
    constraints: Option<Tape>,
    /// Tape of the kinetic energy.
    pub energy: Tape,
    /// Tape of the motion variables, from generalized speeds.
    pub motions: Tape,
}

impl Tapes {
    /// Makes the tapes of a set of equations. Those of interpreted equations are copied; for compiled equations they
    /// are made.
    ///
    /// # Errors
    /// [`Error`] if the equations cannot be solved for their accelerations.
    pub fn new(
        mechanism: &Mechanism,
        by: &EquationsOrigin,
        distance: Option<Distance>,
        code: &Code,
    ) -> Result<Self, Error> {
        if let Code::Interpreted(system) = code
            && let (Some(rates), constraints) = system.double.rates_and_constraints()
            && let (Some(energy), Some(motions)) = system.double.energy_and_motions()
        {
            let (rates, constraints) = (rates.clone(), constraints.cloned());
            return Ok(Self { rates, constraints, energy: energy.clone(), motions: motions.clone() });
        }
        let derived = derivation(mechanism, by)?;
        let Derivation { mut arena, equations } = match distance {
            Some(distance) => in_distance(mechanism, derived, distance),
            None => derived,
        };
        let inputs = [mechanism.model.p(), equations.coordinates.clone(), equations.variables.clone()].concat();
        let values: Vec<Expr> = equations.constraints.iter().map(|c| c.value).collect();
        let of_values = needed(&arena, &equations.definitions, &values);
        let constraints =
            (!values.is_empty()).then(|| stepwise(&arena, &inputs, &of_values, &values, "a constraint")).transpose()?;
        let of = |arena: &_, inputs: &[Expr], values: &[Expr], what: &str| {
            stepwise(arena, inputs, &needed(arena, &equations.definitions, values), values, what)
        };
        let energy = of(&arena, &inputs, &[equations.kinetic_energy], "an energy")?;
        let in_speeds = [mechanism.model.p(), equations.coordinates.clone(), mechanism.model.u()].concat();
        let motions = of(&arena, &in_speeds, &equations.motion_variables, "a motion variable")?;
        let written = equations.written(&mut arena);
        let steps = Solved::steps(&mut arena, &written)
            .map_err(|why| Error::request(format!("`{}`: {why}", by.name()), why.help()))?;
        let rates = [&written.coordinate_rates, &written.unknowns[..written.variables.len()]].concat();
        Ok(Self { rates: stepwise(&arena, &inputs, &steps, &rates, "a rate")?, constraints, energy, motions })
    }
}

/// Equations at the parameters of a problem, with products of their transposed slopes.
pub struct Products<'a> {
    rhs: Eliminated<'a>,
    tapes: &'a Tapes,
    parameters: &'a [f64],
    inputs: Vec<f64>,
    slopes: Vec<f64>,
    room: Backwards,
}

impl<'a> Products<'a> {
    /// Prepares the equations of a problem for products with their transposed slopes.
    ///
    /// # Errors
    /// [`Error::Request`] for equations that were not solved for their accelerations.
    pub fn new(problem: &'a Problem<'_>, tapes: &'a Tapes) -> Result<Self, Error> {
        let parameters = problem.scene.parameters.as_slice();
        let rhs = Eliminated::new(problem.system(), parameters);
        let rhs = rhs.ok_or_else(|| Error::request("accelerations are not eliminated", "take other equations"))?;
        let (inputs, slopes) = (Vec::new(), Vec::new());
        Ok(Self { rhs, tapes, parameters, inputs, slopes, room: Backwards::default() })
    }

    /// Adds the slopes, by parameters and state, of a weighted sum of a tape's outputs.
    fn pull_by(&mut self, tape: &Tape, y: &[f64], weights: &[f64], (state, parameters): Pulled<'_>) {
        self.inputs.clear();
        self.inputs.extend_from_slice(self.parameters);
        self.inputs.extend_from_slice(y);
        self.slopes.clear();
        self.slopes.resize(self.inputs.len(), 0.0);
        tape.pull(&self.inputs, weights, &mut self.room, &mut self.slopes);
        let (by_parameters, by_state) = self.slopes.split_at(self.parameters.len());
        parameters.iter_mut().zip(by_parameters).for_each(|(sum, share)| *sum += share);
        state.iter_mut().zip(by_state).for_each(|(sum, share)| *sum += share);
    }
}

impl RightHandSide<f64> for Products<'_> {
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

impl Transposed for Products<'_> {
    fn parameter_count(&self) -> usize {
        self.parameters.len()
    }

    fn pull(&mut self, _t: f64, y: &[f64], weights: &[f64], to: Pulled<'_>) -> Result<(), Failure> {
        let tapes = self.tapes;
        self.pull_by(&tapes.rates, y, weights, to);
        Ok(())
    }

    fn pull_constraints(&mut self, _t: f64, y: &[f64], weights: &[f64], to: Pulled<'_>) -> Result<(), Failure> {
        let tapes = self.tapes;
        if let Some(tape) = &tapes.constraints {
            self.pull_by(tape, y, weights, to);
        }
        Ok(())
    }
}
