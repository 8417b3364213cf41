//! Derived equations as a [`System`] by interpretation, for models that are not compiled into the program.
//!
//! Invariant: the equations are compiled to tapes once. Another number type uses the same tapes, with their exact
//! constants rounded anew.

use crate::scratch_pool::ScratchPool;
use tripos_codegen::taylor::{Tape as Series, recurrences_of};
use tripos_derive::Model;
use tripos_derive::algebra::Expr;
use tripos_derive::algebra::form::simplify::Simplifier;
use tripos_derive::algebra::term::steps::{Definition, needed};
use tripos_derive::algebra::value::evaluate::{Numeric, Tape, UnknownSymbol};
use tripos_derive::mechanics::{Derivation, Divisors, Solved, Unsolved, energy_gradient};
use tripos_derive::reduce::Reduction;
use tripos_traits::{Lengths, System};

/// Reason why equations cannot be interpreted.
#[derive(Clone, Debug)]
pub enum NotInterpreted {
    /// An equation mentions a symbol that has no value during a run.
    Unknown(UnknownSymbol),
    /// The equations could not be solved for the accelerations v̇.
    Unsolved(Unsolved),
}

impl From<UnknownSymbol> for NotInterpreted {
    fn from(unknown: UnknownSymbol) -> Self {
        Self::Unknown(unknown)
    }
}

impl From<Unsolved> for NotInterpreted {
    fn from(why: Unsolved) -> Self {
        Self::Unsolved(why)
    }
}

/// Parts of the equations, each computed by a tape of its own.
#[derive(Clone, Copy)]
enum Part {
    CoordinateRates,
    MassMatrix,
    Forcing,
    Accelerations,
    /// Rates q̇ of coordinates and v̇ of motion variables together.
    Derivative,
    Jacobian,
    /// Outputs of a scene, in parameters, time, coordinates and motion variables.
    Outputs,
    /// Energy T + V and its derivatives with respect to the state, for a scene that has an energy.
    EnergyGradient,
    /// Angles z of the quotients sin z/z in the slope of the potential energy.
    SlopeAngles,
    /// Slope of the potential energy between two values of the coordinate, from these values and the quotients sin z/z.
    Slope,
    GeneralizedSpeeds,
    GeneralizedSpeedRates,
    MotionVariables,
    /// Divisors of the equations that may be zero somewhere.
    Divisors,
    /// Functions that are zero where the constraints hold.
    Constraints,
    /// Derivatives of the functions of the constraints with respect to the state.
    ConstraintSlopes,
    KineticEnergy,
    PotentialEnergy,
    Power,
}

/// Equations of one formulation as tapes for interpretation; threads may share them.
pub struct Interpreted<S = f64> {
    lengths: Lengths,
    /// Parameters, coordinates and motion variables, which most tapes read.
    state: Vec<Expr>,
    symmetric: bool,
    /// Tapes of the parts, indexed by [`Part`]; `None` for a part that the equations do not have. Printed equations are
    /// run as they stand, without accelerations. Outputs belong to a scene.
    tapes: [Option<Tape<S>>; Part::Power as usize + 1],
    /// Recurrences of the Taylor coefficients; `None` if the equations have none.
    series: Option<Series<S>>,
    /// Period, in the first coordinate, of the functions that quadrature needs; `None` if they have no period.
    coordinate_period: Option<f64>,
    /// True if the tape of the Jacobian gives its product with a direction.
    is_product: bool,
    /// Names of the divisors that a run watches.
    divisors: Vec<String>,
    /// Names of the constraints onto which a run is kept.
    constraints: Vec<String>,
    /// Buffers for the joined inputs of a tape and for its intermediate values.
    work: ScratchPool<(Vec<S>, Vec<S>)>,
    /// Buffer for the rates q̇ and v̇ together.
    both: ScratchPool<Vec<S>>,
}

impl Interpreted {
    /// Compiles the derived equations of a model to tapes, without eliminated accelerations.
    ///
    /// # Errors
    /// [`UnknownSymbol`] if an equation has a symbol that is not among its inputs. Derived equations never do.
    pub fn new(model: &Model, derivation: &Derivation) -> Result<Self, UnknownSymbol> {
        let Derivation { arena, equations: e } = derivation;
        let (p, q) = (model.p(), e.coordinates.clone());
        let state = [p.clone(), q.clone(), e.variables.clone()].concat();
        let speed_rates = e.unknowns[..e.variables.len()].to_vec();
        let mut tapes = [const { None }; _];
        let mut tape = |part: Part, inputs: &[Expr], outputs: &[Expr]| {
            // Unused steps are left out, so that their symbols need no value.
            let steps = needed(arena, &e.definitions, outputs);
            tapes[part as usize] = Some(Tape::stepwise(arena, inputs, &steps, outputs)?);
            Ok(())
        };
        tape(Part::CoordinateRates, &state, &e.coordinate_rates)?;
        tape(Part::MassMatrix, &state, &e.matrix.concat())?;
        tape(Part::Forcing, &state, &e.forcing)?;
        tape(Part::GeneralizedSpeeds, &state, &e.generalized_speeds)?;
        tape(Part::GeneralizedSpeedRates, &[state.clone(), speed_rates].concat(), &e.generalized_speed_rates)?;
        tape(Part::MotionVariables, &[p.clone(), q.clone(), model.u()].concat(), &e.motion_variables)?;
        tape(Part::KineticEnergy, &state, &[e.kinetic_energy])?;
        tape(Part::PotentialEnergy, &[p.clone(), q.clone()].concat(), &[e.potential_energy])?;
        if e.power != Expr::ZERO {
            tape(Part::Power, &state, &[e.power])?;
        }
        if !e.constraints.is_empty() {
            let values: Vec<Expr> = e.constraints.iter().map(|c| c.value).collect();
            let slopes: Vec<Expr> = e.constraints.iter().flat_map(|c| c.slopes.iter().copied()).collect();
            tape(Part::Constraints, &state, &values)?;
            tape(Part::ConstraintSlopes, &state, &slopes)?;
        }
        let divisors = Divisors::of(arena, e, None);
        tape(Part::Divisors, &state, &divisors.values)?;
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

    /// Adds the eliminated accelerations, their Jacobian and, if possible, the recurrences of Taylor coefficients.
    ///
    /// # Errors
    /// [`NotInterpreted`] if v̇ is not determined in any configuration, is not proved, or has a step with an undefined
    /// symbol.
    pub fn solved(mut self, derivation: &Derivation) -> Result<Self, NotInterpreted> {
        let Derivation { mut arena, equations: e } = derivation.clone();
        let Solved { accelerations, jacobian, .. } = Solved::new(&mut arena, &e)?;
        let divisors = Divisors::of(&arena, &e, Some(&accelerations));
        self.divisors = divisors.names(&arena);
        let parameters = &self.state[..self.lengths.parameters];
        let recurrences = recurrences_of(&mut arena, &e, &accelerations);
        self.series = recurrences.map(|list| Series::new(&arena, parameters, &list)).transpose()?;
        let rates = &e.unknowns[..e.variables.len()];
        let both = [&e.coordinate_rates, rates].concat();
        let tape = |steps: &[Definition], outputs: &[Expr]| Tape::stepwise(&arena, &self.state, steps, outputs);
        self.tapes[Part::Accelerations as usize] = Some(tape(&accelerations.steps, rates)?);
        self.tapes[Part::Derivative as usize] = Some(tape(&accelerations.steps, &both)?);
        let inputs = [self.state.clone(), jacobian.direction.clone()].concat();
        let of_jacobian = Tape::stepwise(&arena, &inputs, &jacobian.steps, &jacobian.entries.concat())?;
        self.is_product = !jacobian.direction.is_empty();
        self.tapes[Part::Jacobian as usize] = Some(of_jacobian);
        self.tapes[Part::Divisors as usize] = Some(tape(&divisors.steps, &divisors.values)?);
        Ok(self)
    }

    /// Adds the outputs of the scene to which these equations belong, and its energy and potential slope if it has
    /// them.
    ///
    /// # Errors
    /// [`UnknownSymbol`] if an output has an undefined symbol. Outputs of a reduction never do.
    pub fn showing(mut self, reduction: &Reduction) -> Result<Self, UnknownSymbol> {
        let values: Vec<Expr> = reduction.outputs.iter().map(|o| o.value).collect();
        let (p, state) = self.state.split_at(self.lengths.parameters);
        let inputs = [p, &[reduction.time], state].concat();
        let steps = needed(reduction.terms(), &reduction.derivation.equations.definitions, &values);
        let outputs = Tape::stepwise(reduction.terms(), &inputs, &steps, &values)?;
        self.tapes[Part::Outputs as usize] = Some(outputs);
        let equations = &reduction.derivation.equations;
        if reduction.has_energy {
            let mut arena = reduction.terms().clone();
            let energy = arena.add(equations.kinetic_energy, equations.potential_energy);
            let gradient = energy_gradient(&mut arena, &mut Simplifier::default(), equations);
            let values = [&[energy][..], &gradient].concat();
            let steps = needed(&arena, &equations.definitions, &values);
            let gradient = Tape::stepwise(&arena, &self.state, &steps, &values)?;
            self.tapes[Part::EnergyGradient as usize] = Some(gradient);
        }
        if let Some(slope) = &reduction.slope {
            let (symbols, angles): (Vec<Expr>, Vec<Expr>) = slope.sincs.iter().copied().unzip();
            let ends = [p, &slope.ends].concat();
            let angles = Tape::new(reduction.terms(), &ends, &angles)?;
            let value = Tape::new(reduction.terms(), &[ends, symbols].concat(), &[slope.value])?;
            self.tapes[Part::SlopeAngles as usize] = Some(angles);
            self.tapes[Part::Slope as usize] = Some(value);
            self.coordinate_period = slope.period();
        }
        Ok(self)
    }

    /// Converts the equations to another number type.
    #[must_use]
    pub fn to<S: Numeric>(&self) -> Interpreted<S> {
        Interpreted {
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

impl<S: Numeric> Interpreted<S> {
    /// True if the equations have this part.
    fn has(&self, part: Part) -> bool {
        self.tapes[part as usize].is_some()
    }

    /// Tape of q̇ and v̇, and tape of the constraints onto which a run is kept. Both read parameters, coordinates and
    /// motion variables.
    pub fn rates_and_constraints(&self) -> (Option<&Tape<S>>, Option<&Tape<S>>) {
        (self.tapes[Part::Derivative as usize].as_ref(), self.tapes[Part::Constraints as usize].as_ref())
    }

    /// Tapes of the kinetic energy and of the motion variables. The first reads parameters, coordinates and motion
    /// variables, the second parameters, coordinates and speeds.
    pub fn energy_and_motions(&self) -> (Option<&Tape<S>>, Option<&Tape<S>>) {
        (self.tapes[Part::KineticEnergy as usize].as_ref(), self.tapes[Part::MotionVariables as usize].as_ref())
    }

    /// Computes the values of a part; NaN if these equations do not have it.
    fn run(&self, part: Part, inputs: &[&[S]], out: &mut [S]) {
        let Some(tape) = &self.tapes[part as usize] else { return out.fill(S::from_f64(f64::NAN)) };
        self.work.with(|(joined, scratch)| {
            joined.clear();
            for part in inputs {
                joined.extend_from_slice(part);
            }
            tape.evaluate_into(joined, scratch, out);
        });
    }

    /// Computes the value of a part that has only one value.
    fn value(&self, part: Part, inputs: &[&[S]]) -> S {
        let mut out = [S::int(0)];
        self.run(part, inputs, &mut out);
        out[0]
    }

    /// Number of values that a part has; 0 if the equations do not have the part.
    fn count(&self, part: Part) -> usize {
        self.tapes[part as usize].as_ref().map_or(0, Tape::outputs)
    }
}

impl<S: Numeric> System<S> for Interpreted<S> {
    fn lengths(&self) -> Lengths {
        self.lengths
    }
    fn symmetric(&self) -> bool {
        self.symmetric
    }
    fn coordinate_rates(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        self.run(Part::CoordinateRates, &[p, q, v], out);
    }
    fn mass_matrix(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        self.run(Part::MassMatrix, &[p, q, v], out);
    }
    fn forcing(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        self.run(Part::Forcing, &[p, q, v], out);
    }
    fn output_count(&self) -> usize {
        if self.has(Part::Outputs) { self.count(Part::Outputs) } else { self.lengths.coordinates + self.lengths.speeds }
    }
    fn outputs(&self, p: &[S], t: S, q: &[S], v: &[S], out: &mut [S]) {
        if self.has(Part::Outputs) {
            self.run(Part::Outputs, &[p, &[t], q, v], out);
        } else {
            self.whole_state(p, q, v, out);
        }
    }
    fn has_energy_gradient(&self) -> bool {
        self.has(Part::EnergyGradient)
    }
    fn energy_gradient(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) -> S {
        let mut values = vec![S::int(0); 1 + out.len()];
        self.run(Part::EnergyGradient, &[p, q, v], &mut values);
        out.copy_from_slice(&values[1..]);
        values[0]
    }
    fn has_potential_slope(&self) -> bool {
        self.has(Part::Slope)
    }
    fn potential_slope(&self, p: &[S], a: S, b: S) -> S {
        let mut sincs = vec![S::int(0); self.count(Part::SlopeAngles)];
        self.run(Part::SlopeAngles, &[p, &[a, b]], &mut sincs);
        for z in &mut sincs {
            *z = z.sinc();
        }
        self.value(Part::Slope, &[p, &[a, b], &sincs])
    }
    fn coordinate_period(&self) -> Option<f64> {
        self.coordinate_period
    }
    fn has_accelerations(&self) -> bool {
        self.has(Part::Accelerations)
    }
    fn accelerations(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        self.run(Part::Accelerations, &[p, q, v], out);
    }
    fn derivative(&self, p: &[S], q: &[S], v: &[S], q_dot: &mut [S], v_dot: &mut [S]) {
        self.both.with(|both| {
            both.resize(q.len() + v.len(), S::int(0));
            self.run(Part::Derivative, &[p, q, v], both);
            q_dot.copy_from_slice(&both[..q.len()]);
            v_dot.copy_from_slice(&both[q.len()..]);
        });
    }
    fn jacobian(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        if !self.is_product {
            return self.run(Part::Jacobian, &[p, q, v], out);
        }
        let n = self.lengths.state();
        let (mut direction, mut column) = (vec![S::int(0); n], vec![S::int(0); n]);
        for at in 0..n {
            direction[at] = S::int(1);
            self.run(Part::Jacobian, &[p, q, v, &direction], &mut column);
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
        self.run(Part::GeneralizedSpeeds, &[p, q, v], out);
    }
    fn generalized_speed_rates(&self, p: &[S], q: &[S], v: &[S], v_dot: &[S], out: &mut [S]) {
        self.run(Part::GeneralizedSpeedRates, &[p, q, v, v_dot], out);
    }
    fn motion_variables(&self, p: &[S], q: &[S], u: &[S], out: &mut [S]) {
        self.run(Part::MotionVariables, &[p, q, u], out);
    }
    fn divisor_count(&self) -> usize {
        self.divisors.len()
    }
    fn divisor_name(&self, at: usize) -> &str {
        &self.divisors[at]
    }
    fn divisors(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        self.run(Part::Divisors, &[p, q, v], out);
    }
    fn constraint_count(&self) -> usize {
        self.constraints.len()
    }
    fn constraint_name(&self, at: usize) -> &str {
        &self.constraints[at]
    }
    fn constraints(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        self.run(Part::Constraints, &[p, q, v], out);
    }
    fn constraint_slopes(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        self.run(Part::ConstraintSlopes, &[p, q, v], out);
    }
    fn kinetic_energy(&self, p: &[S], q: &[S], v: &[S]) -> S {
        self.value(Part::KineticEnergy, &[p, q, v])
    }
    fn potential_energy(&self, p: &[S], q: &[S]) -> S {
        self.value(Part::PotentialEnergy, &[p, q])
    }
    fn has_power(&self) -> bool {
        self.tapes[Part::Power as usize].is_some()
    }
    fn power(&self, p: &[S], q: &[S], v: &[S]) -> S {
        if self.has_power() { self.value(Part::Power, &[p, q, v]) } else { S::int(0) }
    }
}
