//! Derived equations of motion as a [`System`] that interprets tapes, for models that are not compiled into
//! the program.
//!
//! Invariant: the equations are compiled to tapes only once. Equations in another number type use the same
//! tapes, with exact constants rounded to that type.

use crate::scratch_pool::ScratchPool;
use std::sync::OnceLock;
use tripos_codegen::taylor::{Tape as Series, cheapest_recurrences_of};
use tripos_derive::Model;
use tripos_derive::algebra::Expr;
use tripos_derive::algebra::form::simplify::Simplifier;
use tripos_derive::algebra::term::steps::{Definition, needed_steps};
use tripos_derive::algebra::value::tape::{Numeric, Tape, UnknownSymbol};
use tripos_derive::mechanics::{Derivation, Divisors, SolvedAccelerations, Unsolved, energy_gradient};
use tripos_derive::reduce::Reduction;
use tripos_traits::{DoubleDouble, Lanes, Lengths, System};

/// Reason why equations of motion cannot be interpreted.
#[derive(Clone, Debug)]
pub enum InterpretationError {
    /// An equation contains a symbol that has no value during a run.
    Unknown(UnknownSymbol),
    /// The equations could not be solved for the accelerations v̇.
    Unsolved(Unsolved),
}

impl From<UnknownSymbol> for InterpretationError {
    fn from(unknown: UnknownSymbol) -> Self {
        Self::Unknown(unknown)
    }
}

impl From<Unsolved> for InterpretationError {
    fn from(why: Unsolved) -> Self {
        Self::Unsolved(why)
    }
}

/// Quantity of a set of equations that is computed by a tape of its own. A tape is a list of arithmetic
/// instructions.
#[derive(Clone, Copy)]
enum InterpretedQuantity {
    /// Rates q̇ of the generalized coordinates, n values.
    CoordinateRates,
    /// Matrix A of the linear system A x = b for v̇ and the reactions, row by row.
    MassMatrix,
    /// Right-hand side b of the linear system A x = b for v̇ and the reactions.
    Forcing,
    /// Accelerations v̇, for which the equations were solved symbolically.
    Accelerations,
    /// Rates q̇ of the coordinates, followed by the rates v̇ of the motion variables.
    Derivative,
    /// Jacobian ∂(q̇, v̇)/∂(q, v) row by row, or its product with a direction.
    Jacobian,
    /// Outputs of a scene, as functions of parameters, time, coordinates and motion variables.
    Outputs,
    /// Energy T + V, followed by its derivatives by the state (q, v). Only reduced equations with a conserved
    /// energy have it.
    EnergyGradient,
    /// Angles z whose quotients sin z/z occur in the difference quotient of the potential energy.
    SlopeAngles,
    /// Difference quotient of the potential energy between two values of the coordinate. It is a function of
    /// both values and of quotients sin z/z.
    Slope,
    /// Generalized speeds u of the model, as functions of the state (q, v).
    GeneralizedSpeeds,
    /// Rates u̇ of the generalized speeds of the model, as functions of (q, v) and v̇.
    GeneralizedSpeedRates,
    /// Motion variables v, as functions of coordinates and generalized speeds.
    MotionVariables,
    /// Divisors of the equations that can be zero in a permitted state.
    Divisors,
    /// Constraint functions, which are zero where the constraints hold.
    Constraints,
    /// Derivatives of the constraint functions by the state (q, v), row by row.
    ConstraintSlopes,
    /// Kinetic energy T, J.
    KineticEnergy,
    /// Potential energy V, J.
    PotentialEnergy,
    /// Power of the loads that have no potential, W.
    Power,
}

/// Equations of motion by one formulation, as tapes that are interpreted in the number type `S`. Threads may
/// share them.
pub struct InterpretedEquations<S = f64> {
    /// Numbers of parameters, coordinates, motion variables, speeds and reactions.
    lengths: Lengths,
    /// Symbols of the parameters, coordinates and motion variables, in this order. They are the inputs of most
    /// tapes.
    state: Vec<Expr>,
    /// True if the mass matrix is symmetric and, away from singular configurations, positive definite.
    symmetric: bool,
    /// Tapes of the quantities, indexed by [`InterpretedQuantity`]. `None` for a quantity that these equations do
    /// not have, such as eliminated accelerations of printed equations.
    tapes: [Option<Tape<S>>; InterpretedQuantity::Power as usize + 1],
    /// Recurrences of the Taylor coefficients of the motion; `None` if the equations have none.
    series: Option<Series<S>>,
    /// Period of the integrands of quadrature in the first coordinate, in its unit; `None` if they are not
    /// periodic.
    coordinate_period: Option<f64>,
    /// True if the tape of the Jacobian computes the product of the Jacobian and a direction. False if it
    /// computes all entries.
    is_product: bool,
    /// Names of the divisors whose sign a run watches, as text for people.
    divisors: Vec<String>,
    /// Names of the constraints that a run corrects after each step.
    constraints: Vec<String>,
    /// Reusable buffers: the joined inputs of a tape, and its intermediate values.
    work: ScratchPool<(Vec<S>, Vec<S>)>,
    /// Reusable buffer for q̇ and v̇ together. It has the length of the state.
    both: ScratchPool<Vec<S>>,
}

impl InterpretedEquations {
    /// Compiles the derived equations of a model to tapes, without eliminated accelerations.
    /// [`Self::with_solved_accelerations`] adds these.
    ///
    /// # Errors
    /// [`UnknownSymbol`] if an equation contains a symbol without a value during a run. Derived equations never
    /// do.
    pub fn new(model: &Model, derivation: &Derivation) -> Result<Self, UnknownSymbol> {
        let Derivation { arena, equations: e } = derivation;
        let (p, q) = (model.p(), e.coordinates.clone());
        let state = [p.clone(), q.clone(), e.variables.clone()].concat();
        let speed_rates = e.unknowns[..e.variables.len()].to_vec();
        let mut tapes = [const { None }; _];
        let mut tape = |part: InterpretedQuantity, inputs: &[Expr], outputs: &[Expr]| {
            // Unused steps are left out, so that their symbols need no value.
            let steps = needed_steps(arena, &e.definitions, outputs);
            tapes[part as usize] = Some(Tape::stepwise(arena, inputs, &steps, outputs)?);
            Ok(())
        };
        tape(InterpretedQuantity::CoordinateRates, &state, &e.coordinate_rates)?;
        tape(InterpretedQuantity::MassMatrix, &state, &e.matrix.concat())?;
        tape(InterpretedQuantity::Forcing, &state, &e.forcing)?;
        tape(InterpretedQuantity::GeneralizedSpeeds, &state, &e.generalized_speeds)?;
        tape(
            InterpretedQuantity::GeneralizedSpeedRates,
            &[state.clone(), speed_rates].concat(),
            &e.generalized_speed_rates,
        )?;
        tape(InterpretedQuantity::MotionVariables, &[p.clone(), q.clone(), model.u()].concat(), &e.motion_variables)?;
        tape(InterpretedQuantity::KineticEnergy, &state, &[e.kinetic_energy])?;
        tape(InterpretedQuantity::PotentialEnergy, &[p.clone(), q.clone()].concat(), &[e.potential_energy])?;
        if e.power != Expr::ZERO {
            tape(InterpretedQuantity::Power, &state, &[e.power])?;
        }
        if !e.constraints.is_empty() {
            let values: Vec<Expr> = e.constraints.iter().map(|c| c.value).collect();
            let slopes: Vec<Expr> = e.constraints.iter().flat_map(|c| c.slopes.iter().copied()).collect();
            tape(InterpretedQuantity::Constraints, &state, &values)?;
            tape(InterpretedQuantity::ConstraintSlopes, &state, &slopes)?;
        }
        let divisors = Divisors::of(arena, e, None);
        tape(InterpretedQuantity::Divisors, &state, &divisors.values)?;
        Ok(Self {
            divisors: divisors.names(arena),
            constraints: e.constraints.iter().map(|c| c.name.clone()).collect(),
            lengths: Lengths {
                parameters: p.len(),
                coordinates: q.len(),
                variables: e.variables.len(),
                speeds: model.speeds.len(),
                reactions: e.unknowns.len() - e.variables.len(),
            },
            state,
            symmetric: e.symmetric,
            tapes,
            series: None,
            coordinate_period: None,
            is_product: false,
            work: ScratchPool::default(),
            both: ScratchPool::default(),
        })
    }

    /// Solves the equations symbolically for the accelerations v̇. Adds the tapes of v̇ and of its Jacobian, and
    /// the recurrences of Taylor coefficients if they exist.
    ///
    /// # Errors
    /// [`InterpretationError`] if v̇ is not determined in any configuration, if the proof of the solution fails,
    /// or if a step contains a symbol without a value.
    pub fn with_solved_accelerations(mut self, derivation: &Derivation) -> Result<Self, InterpretationError> {
        let Derivation { mut arena, equations: e } = derivation.clone();
        let SolvedAccelerations { accelerations, jacobian, .. } = SolvedAccelerations::new(&mut arena, &e)?;
        let divisors = Divisors::of(&arena, &e, Some(&accelerations));
        self.divisors = divisors.names(&arena);
        let parameters = &self.state[..self.lengths.parameters];
        let recurrences = cheapest_recurrences_of(&mut arena, &e, &accelerations);
        self.series = recurrences.map(|list| Series::new(&arena, parameters, &list)).transpose()?;
        let rates = &e.unknowns[..e.variables.len()];
        let both = [&e.coordinate_rates, rates].concat();
        // Lagrange's equations of long loops also define the generalized speeds of joints, which v̇ does not need.
        let tape = |inputs: &[Expr], steps: &[Definition], outputs: &[Expr]| {
            Tape::stepwise(&arena, inputs, &needed_steps(&arena, steps, outputs), outputs)
        };
        self.tapes[InterpretedQuantity::Accelerations as usize] = Some(tape(&self.state, &accelerations.steps, rates)?);
        self.tapes[InterpretedQuantity::Derivative as usize] = Some(tape(&self.state, &accelerations.steps, &both)?);
        let inputs = [self.state.clone(), jacobian.direction.clone()].concat();
        let of_jacobian = tape(&inputs, &jacobian.steps, &jacobian.entries.concat())?;
        self.is_product = !jacobian.direction.is_empty();
        self.tapes[InterpretedQuantity::Jacobian as usize] = Some(of_jacobian);
        self.tapes[InterpretedQuantity::Divisors as usize] =
            Some(tape(&self.state, &divisors.steps, &divisors.values)?);
        Ok(self)
    }

    /// Adds the outputs of the reduction to which these equations belong. Also adds the gradient of its energy and
    /// the difference quotient of its potential energy, if the reduction has them.
    ///
    /// # Errors
    /// [`UnknownSymbol`] if an output contains a symbol without a value. Outputs of a reduction never do.
    pub fn with_scene_outputs(mut self, reduction: &Reduction) -> Result<Self, UnknownSymbol> {
        let values: Vec<Expr> = reduction.outputs.iter().map(|o| o.value).collect();
        let (p, state) = self.state.split_at(self.lengths.parameters);
        let inputs = [p, &[reduction.time], state].concat();
        let steps = needed_steps(reduction.arena(), &reduction.derivation.equations.definitions, &values);
        let outputs = Tape::stepwise(reduction.arena(), &inputs, &steps, &values)?;
        self.tapes[InterpretedQuantity::Outputs as usize] = Some(outputs);
        let equations = &reduction.derivation.equations;
        if reduction.has_energy {
            let mut arena = reduction.arena().clone();
            let energy = arena.add(equations.kinetic_energy, equations.potential_energy);
            let gradient = energy_gradient(&mut arena, &mut Simplifier::default(), equations);
            let values = [&[energy][..], &gradient].concat();
            let steps = needed_steps(&arena, &equations.definitions, &values);
            let gradient = Tape::stepwise(&arena, &self.state, &steps, &values)?;
            self.tapes[InterpretedQuantity::EnergyGradient as usize] = Some(gradient);
        }
        if let Some(slope) = &reduction.slope {
            let (symbols, angles): (Vec<Expr>, Vec<Expr>) = slope.sincs.iter().copied().unzip();
            let ends = [p, &slope.ends].concat();
            let angles = Tape::new(reduction.arena(), &ends, &angles)?;
            let value = Tape::new(reduction.arena(), &[ends, symbols].concat(), &[slope.value])?;
            self.tapes[InterpretedQuantity::SlopeAngles as usize] = Some(angles);
            self.tapes[InterpretedQuantity::Slope as usize] = Some(value);
            self.coordinate_period = slope.period();
        }
        Ok(self)
    }

    /// Converts the equations to another number type `S`. Exact constants are rounded to this type.
    #[must_use]
    pub fn convert_to<S: Numeric>(&self) -> InterpretedEquations<S> {
        InterpretedEquations {
            lengths: self.lengths,
            state: self.state.clone(),
            symmetric: self.symmetric,
            divisors: self.divisors.clone(),
            constraints: self.constraints.clone(),
            tapes: self.tapes.each_ref().map(|tape| tape.as_ref().map(Tape::to)),
            series: self.series.as_ref().map(Series::to),
            coordinate_period: self.coordinate_period,
            is_product: self.is_product,
            work: ScratchPool::default(),
            both: ScratchPool::default(),
        }
    }
}

impl<S> InterpretedEquations<S> {
    /// Number of products of series in the Taylor recurrences, which tells the cost of a Taylor step; 0 if the
    /// equations have no recurrences.
    pub fn series_products(&self) -> usize {
        self.series.as_ref().map_or(0, |series| series.recurrences().convolutions())
    }
}

impl<S: Numeric> InterpretedEquations<S> {
    /// True if the equations have a tape for this quantity.
    fn has(&self, part: InterpretedQuantity) -> bool {
        self.tapes[part as usize].is_some()
    }

    /// Returns the tape of q̇ and v̇, and the tape of the constraint functions that a run keeps at zero. The inputs
    /// of both are parameters, coordinates and motion variables. `None` for a tape that the equations do not
    /// have.
    pub fn rates_and_constraints(&self) -> (Option<&Tape<S>>, Option<&Tape<S>>) {
        (
            self.tapes[InterpretedQuantity::Derivative as usize].as_ref(),
            self.tapes[InterpretedQuantity::Constraints as usize].as_ref(),
        )
    }

    /// Returns the tape of the kinetic energy, and the tape of the motion variables v. The inputs of the first
    /// are parameters, coordinates and motion variables. The inputs of the second are parameters, coordinates
    /// and generalized speeds. `None` for a tape that the equations do not have.
    pub fn energy_and_motions(&self) -> (Option<&Tape<S>>, Option<&Tape<S>>) {
        (
            self.tapes[InterpretedQuantity::KineticEnergy as usize].as_ref(),
            self.tapes[InterpretedQuantity::MotionVariables as usize].as_ref(),
        )
    }

    /// Evaluates the tape of a quantity at the joined inputs, and writes its values to `out`. All values are NaN
    /// if the equations have no such tape.
    fn evaluate_tape(&self, part: InterpretedQuantity, inputs: &[&[S]], out: &mut [S]) {
        let Some(tape) = &self.tapes[part as usize] else { return out.fill(S::from_f64(f64::NAN)) };
        self.work.with_scratch(|(joined, scratch)| {
            joined.clear();
            for part in inputs {
                joined.extend_from_slice(part);
            }
            tape.evaluate_into(joined, scratch, out);
        });
    }

    /// Evaluates the tape of a quantity with a single value. NaN if the equations have no such tape.
    fn evaluate_single_value(&self, part: InterpretedQuantity, inputs: &[&[S]]) -> S {
        let mut out = [S::int(0)];
        self.evaluate_tape(part, inputs, &mut out);
        out[0]
    }

    /// Number of values that the tape of a quantity gives; 0 if the equations have no such tape.
    fn tape_output_count(&self, part: InterpretedQuantity) -> usize {
        self.tapes[part as usize].as_ref().map_or(0, Tape::outputs)
    }
}

impl<S: Numeric> System<S> for InterpretedEquations<S> {
    fn lengths(&self) -> Lengths {
        self.lengths
    }
    fn symmetric(&self) -> bool {
        self.symmetric
    }
    fn coordinate_rates(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        self.evaluate_tape(InterpretedQuantity::CoordinateRates, &[p, q, v], out);
    }
    fn mass_matrix(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        self.evaluate_tape(InterpretedQuantity::MassMatrix, &[p, q, v], out);
    }
    fn forcing(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        self.evaluate_tape(InterpretedQuantity::Forcing, &[p, q, v], out);
    }
    fn output_count(&self) -> usize {
        if self.has(InterpretedQuantity::Outputs) {
            self.tape_output_count(InterpretedQuantity::Outputs)
        } else {
            self.lengths.coordinates + self.lengths.speeds
        }
    }
    fn outputs(&self, p: &[S], t: S, q: &[S], v: &[S], out: &mut [S]) {
        if self.has(InterpretedQuantity::Outputs) {
            self.evaluate_tape(InterpretedQuantity::Outputs, &[p, &[t], q, v], out);
        } else {
            self.whole_state(p, q, v, out);
        }
    }
    fn has_energy_gradient(&self) -> bool {
        self.has(InterpretedQuantity::EnergyGradient)
    }
    fn energy_gradient(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) -> S {
        let mut values = vec![S::int(0); 1 + out.len()];
        self.evaluate_tape(InterpretedQuantity::EnergyGradient, &[p, q, v], &mut values);
        out.copy_from_slice(&values[1..]);
        values[0]
    }
    fn has_potential_slope(&self) -> bool {
        self.has(InterpretedQuantity::Slope)
    }
    fn potential_slope(&self, p: &[S], a: S, b: S) -> S {
        let mut sincs = vec![S::int(0); self.tape_output_count(InterpretedQuantity::SlopeAngles)];
        self.evaluate_tape(InterpretedQuantity::SlopeAngles, &[p, &[a, b]], &mut sincs);
        for z in &mut sincs {
            *z = z.sinc();
        }
        self.evaluate_single_value(InterpretedQuantity::Slope, &[p, &[a, b], &sincs])
    }
    fn coordinate_period(&self) -> Option<f64> {
        self.coordinate_period
    }
    fn has_accelerations(&self) -> bool {
        self.has(InterpretedQuantity::Accelerations)
    }
    fn accelerations(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        self.evaluate_tape(InterpretedQuantity::Accelerations, &[p, q, v], out);
    }
    fn derivative(&self, p: &[S], q: &[S], v: &[S], q_dot: &mut [S], v_dot: &mut [S]) {
        self.both.with_scratch(|both| {
            both.resize(q.len() + v.len(), S::int(0));
            self.evaluate_tape(InterpretedQuantity::Derivative, &[p, q, v], both);
            q_dot.copy_from_slice(&both[..q.len()]);
            v_dot.copy_from_slice(&both[q.len()..]);
        });
    }
    fn jacobian(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        if !self.is_product {
            return self.evaluate_tape(InterpretedQuantity::Jacobian, &[p, q, v], out);
        }
        let n = self.lengths.state();
        let (mut direction, mut column) = (vec![S::int(0); n], vec![S::int(0); n]);
        for at in 0..n {
            direction[at] = S::int(1);
            self.evaluate_tape(InterpretedQuantity::Jacobian, &[p, q, v, &direction], &mut column);
            direction[at] = S::int(0);
            for (row, value) in column.iter().enumerate() {
                out[row * n + at] = *value;
            }
        }
    }
    fn has_taylor(&self) -> bool {
        self.series.is_some()
    }
    fn taylor(&self, p: &[S], order: usize, x: &mut [S], _work: &mut [S]) {
        match &self.series {
            Some(series) => series.evaluate(p, order, x),
            None => x[self.lengths.state()..].fill(S::from_f64(f64::NAN)),
        }
    }
    fn generalized_speeds(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        self.evaluate_tape(InterpretedQuantity::GeneralizedSpeeds, &[p, q, v], out);
    }
    fn generalized_speed_rates(&self, p: &[S], q: &[S], v: &[S], v_dot: &[S], out: &mut [S]) {
        self.evaluate_tape(InterpretedQuantity::GeneralizedSpeedRates, &[p, q, v, v_dot], out);
    }
    fn motion_variables(&self, p: &[S], q: &[S], u: &[S], out: &mut [S]) {
        self.evaluate_tape(InterpretedQuantity::MotionVariables, &[p, q, u], out);
    }
    fn divisor_count(&self) -> usize {
        self.divisors.len()
    }
    fn divisor_name(&self, at: usize) -> &str {
        &self.divisors[at]
    }
    fn divisors(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        self.evaluate_tape(InterpretedQuantity::Divisors, &[p, q, v], out);
    }
    fn constraint_count(&self) -> usize {
        self.constraints.len()
    }
    fn constraint_name(&self, at: usize) -> &str {
        &self.constraints[at]
    }
    fn constraints(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        self.evaluate_tape(InterpretedQuantity::Constraints, &[p, q, v], out);
    }
    fn constraint_slopes(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        self.evaluate_tape(InterpretedQuantity::ConstraintSlopes, &[p, q, v], out);
    }
    fn kinetic_energy(&self, p: &[S], q: &[S], v: &[S]) -> S {
        self.evaluate_single_value(InterpretedQuantity::KineticEnergy, &[p, q, v])
    }
    fn potential_energy(&self, p: &[S], q: &[S]) -> S {
        self.evaluate_single_value(InterpretedQuantity::PotentialEnergy, &[p, q])
    }
    fn has_power(&self) -> bool {
        self.tapes[InterpretedQuantity::Power as usize].is_some()
    }
    fn power(&self, p: &[S], q: &[S], v: &[S]) -> S {
        if self.has_power() { self.evaluate_single_value(InterpretedQuantity::Power, &[p, q, v]) } else { S::int(0) }
    }
}

/// Interpreted equations of motion in each number type that runs use: doubles, pairs of doubles, and lanes of
/// eight doubles.
pub struct InterpretedSystem {
    /// Equations of motion as tapes in double precision.
    pub double: InterpretedEquations,
    /// Equations as tapes to 32 digits. The cell is empty until they are first used.
    extended: OnceLock<InterpretedEquations<DoubleDouble>>,
    /// Equations as tapes for eight states at once. The cell is empty until they are first used.
    lanes: OnceLock<InterpretedEquations<Lanes<8>>>,
}

impl From<InterpretedEquations> for InterpretedSystem {
    fn from(double: InterpretedEquations) -> Self {
        Self { double, extended: OnceLock::new(), lanes: OnceLock::new() }
    }
}

impl InterpretedSystem {
    /// Returns the equations as tapes to 32 digits, twice the precision of a double. The first call makes them.
    #[must_use]
    pub fn extended(&self) -> &InterpretedEquations<DoubleDouble> {
        self.extended.get_or_init(|| self.double.convert_to())
    }

    /// Returns the equations as tapes for eight states at once. Their values have the same bits as the values of
    /// one state alone. The first call makes the tapes.
    #[must_use]
    pub fn lanes(&self) -> &InterpretedEquations<Lanes<8>> {
        self.lanes.get_or_init(|| self.double.convert_to())
    }
}
