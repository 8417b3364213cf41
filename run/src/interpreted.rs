//! Derived equations as a [`System`] by interpretation: for models that are not compiled in.

use std::cell::RefCell;
use tripos_codegen::taylor::{Tape as Series, recurrences_of};
use tripos_derive::Model;
use tripos_derive::algebra::Expr;
use tripos_derive::algebra::elimination::{Definition, needed};
use tripos_derive::algebra::evaluate::{Tape, UnknownSymbol};
use tripos_derive::algebra::linear::Singular;
use tripos_derive::algebra::simplify::Simplifier;
use tripos_derive::mechanics::{Derivation, Solved, energy_gradient};
use tripos_derive::reduce::Reduction;
use tripos_traits::{Lengths, Scalar, System};

/// Why equations cannot be interpreted.
#[derive(Clone, Debug)]
pub enum NotInterpreted {
    /// They mention what has no value during a run.
    Unknown(UnknownSymbol),
    /// They determine v̇ in no configuration.
    Singular,
}

impl From<UnknownSymbol> for NotInterpreted {
    fn from(unknown: UnknownSymbol) -> Self {
        Self::Unknown(unknown)
    }
}

impl From<Singular> for NotInterpreted {
    fn from(_: Singular) -> Self {
        Self::Singular
    }
}

/// One formulation, interpreted. Its working space makes it a thread's own; another thread takes a copy.
#[derive(Clone)]
pub struct Interpreted {
    lengths: Lengths,
    /// Parameters, coordinates and motion variables: what most tapes read.
    state: Vec<Expr>,
    symmetric: bool,
    coordinate_rates: Tape,
    mass_matrix: Tape,
    forcing: Tape,
    /// v̇, then q̇ and v̇, then the Jacobian; none for printed equations, which are run as they stand.
    solved: Option<[Tape; 3]>,
    /// What a scene shows, in parameters, time, coordinates and motion variables.
    outputs: Option<Tape>,
    /// T + V and its slopes by the state, of a scene that has an energy.
    energy_gradient: Option<Tape>,
    /// The slope of the potential energy: the angles z, then the value for sin z/z.
    slope: Option<[Tape; 2]>,
    /// The recurrences of the Taylor coefficients.
    series: Option<Series>,
    generalized_speeds: Tape,
    generalized_speed_rates: Tape,
    motion_variables: Tape,
    kinetic_energy: Tape,
    potential_energy: Tape,
    work: RefCell<(Vec<f64>, Vec<f64>)>,
    /// Room for q̇ and v̇.
    derivative: RefCell<Vec<f64>>,
}

impl Interpreted {
    /// Compiles the equations to tapes.
    ///
    /// # Errors
    /// [`UnknownSymbol`] if an equation has a symbol that is no input of it: derived ones never do.
    pub fn new(model: &Model, derivation: &Derivation) -> Result<Self, UnknownSymbol> {
        let Derivation { arena, equations: e } = derivation;
        let (p, q) = (model.p(), e.coordinates.clone());
        let q_length = q.len();
        let state = [p.clone(), q.clone(), e.variables.clone()].concat();
        let tape = |inputs: &[Expr], outputs: &[Expr]| {
            // What is not used is no part of the tape, and what it mentions need have no value.
            let steps = needed(arena, &e.definitions, outputs);
            Tape::stepwise(arena, inputs, &steps, outputs)
        };
        let speed_rates = e.unknowns[..e.variables.len()].to_vec();
        Ok(Self {
            solved: None,
            outputs: None,
            energy_gradient: None,
            slope: None,
            series: None,
            state: state.clone(),
            lengths: Lengths {
                parameters: p.len(),
                coordinates: q.len(),
                variables: e.variables.len(),
                speeds: model.speeds.len(),
                reactions: e.unknowns.len() - e.variables.len(),
            },
            symmetric: e.symmetric,
            coordinate_rates: tape(&state, &e.coordinate_rates)?,
            mass_matrix: tape(&state, &e.matrix.concat())?,
            forcing: tape(&state, &e.forcing)?,
            generalized_speeds: tape(&state, &e.generalized_speeds)?,
            generalized_speed_rates: tape(&[state.clone(), speed_rates].concat(), &e.generalized_speed_rates)?,
            motion_variables: tape(&[p.clone(), q.clone(), model.u()].concat(), &e.motion_variables)?,
            kinetic_energy: tape(&state, &[e.kinetic_energy])?,
            potential_energy: tape(&[p, q].concat(), &[e.potential_energy])?,
            work: RefCell::default(),
            derivative: RefCell::new(vec![0.0; q_length + e.variables.len()]),
        })
    }

    /// With the accelerations eliminated.
    ///
    /// # Errors
    /// [`NotInterpreted`] if v̇ is not determined in any configuration, or a step has a symbol that nothing defines.
    pub fn solved(mut self, derivation: &Derivation) -> Result<Self, NotInterpreted> {
        let Derivation { mut arena, equations: e } = derivation.clone();
        let Solved { accelerations, jacobian } = Solved::new(&mut arena, &e)?;
        let parameters = &self.state[..self.lengths.parameters];
        let recurrences = recurrences_of(&mut arena, &e, &accelerations);
        self.series = recurrences.map(|list| Series::new(&arena, parameters, &list)).transpose()?;
        let rates = &e.unknowns[..e.variables.len()];
        let both = [&e.coordinate_rates, rates].concat();
        let tape = |steps: &[Definition], outputs: &[Expr]| Tape::stepwise(&arena, &self.state, steps, outputs);
        self.solved = Some([
            tape(&accelerations.steps, rates)?,
            tape(&accelerations.steps, &both)?,
            tape(&jacobian.steps, &jacobian.entries.concat())?,
        ]);
        Ok(self)
    }

    /// With the outputs of the scene that these are the equations of.
    ///
    /// # Errors
    /// [`UnknownSymbol`] if an output has a symbol that nothing defines: what a reduction gives never does.
    pub fn showing(mut self, reduction: &Reduction) -> Result<Self, UnknownSymbol> {
        let values: Vec<Expr> = reduction.outputs.iter().map(|o| o.value).collect();
        let (p, state) = self.state.split_at(self.lengths.parameters);
        let inputs = [p, &[reduction.time], state].concat();
        let steps = needed(reduction.terms(), &reduction.derivation.equations.definitions, &values);
        self.outputs = Some(Tape::stepwise(reduction.terms(), &inputs, &steps, &values)?);
        let equations = &reduction.derivation.equations;
        if reduction.has_energy {
            let mut arena = reduction.terms().clone();
            let energy = arena.add(equations.kinetic_energy, equations.potential_energy);
            let gradient = energy_gradient(&mut arena, &mut Simplifier::default(), equations);
            let values = [&[energy][..], &gradient].concat();
            let steps = needed(&arena, &equations.definitions, &values);
            self.energy_gradient = Some(Tape::stepwise(&arena, &self.state, &steps, &values)?);
        }
        if let Some(slope) = &reduction.slope {
            let (symbols, angles): (Vec<Expr>, Vec<Expr>) = slope.sincs.iter().copied().unzip();
            let ends = [p, &slope.ends].concat();
            let angles = Tape::new(reduction.terms(), &ends, &angles)?;
            let value = Tape::new(reduction.terms(), &[ends, symbols].concat(), &[slope.value])?;
            self.slope = Some([angles, value]);
        }
        Ok(self)
    }

    fn run(&self, tape: &Tape, inputs: &[&[f64]], out: &mut [f64]) {
        let (joined, scratch) = &mut *self.work.borrow_mut();
        joined.clear();
        for part in inputs {
            joined.extend_from_slice(part);
        }
        tape.evaluate_into(joined, scratch, out);
    }
}

impl System<f64> for Interpreted {
    fn lengths(&self) -> Lengths {
        self.lengths
    }
    fn symmetric(&self) -> bool {
        self.symmetric
    }
    fn coordinate_rates(&self, p: &[f64], q: &[f64], v: &[f64], out: &mut [f64]) {
        self.run(&self.coordinate_rates, &[p, q, v], out);
    }
    fn mass_matrix(&self, p: &[f64], q: &[f64], v: &[f64], out: &mut [f64]) {
        self.run(&self.mass_matrix, &[p, q, v], out);
    }
    fn forcing(&self, p: &[f64], q: &[f64], v: &[f64], out: &mut [f64]) {
        self.run(&self.forcing, &[p, q, v], out);
    }
    fn output_count(&self) -> usize {
        self.outputs.as_ref().map_or(self.lengths.coordinates + self.lengths.speeds, Tape::outputs)
    }
    fn outputs(&self, p: &[f64], t: f64, q: &[f64], v: &[f64], out: &mut [f64]) {
        match &self.outputs {
            Some(tape) => self.run(tape, &[p, &[t], q, v], out),
            None => self.whole_state(p, q, v, out),
        }
    }
    fn has_energy_gradient(&self) -> bool {
        self.energy_gradient.is_some()
    }
    fn energy_gradient(&self, p: &[f64], q: &[f64], v: &[f64], out: &mut [f64]) -> f64 {
        let Some(tape) = &self.energy_gradient else {
            out.fill(f64::NAN);
            return f64::NAN;
        };
        let mut values = vec![0.0; 1 + out.len()];
        self.run(tape, &[p, q, v], &mut values);
        out.copy_from_slice(&values[1..]);
        values[0]
    }
    fn has_potential_slope(&self) -> bool {
        self.slope.is_some()
    }
    fn potential_slope(&self, p: &[f64], a: f64, b: f64) -> f64 {
        let Some([angles, value]) = &self.slope else { return f64::NAN };
        let mut sincs = vec![0.0; angles.outputs()];
        self.run(angles, &[p, &[a, b]], &mut sincs);
        for z in &mut sincs {
            *z = z.sinc();
        }
        let mut out = [0.0];
        self.run(value, &[p, &[a, b], &sincs], &mut out);
        out[0]
    }
    fn has_accelerations(&self) -> bool {
        self.solved.is_some()
    }
    fn accelerations(&self, p: &[f64], q: &[f64], v: &[f64], out: &mut [f64]) {
        match &self.solved {
            Some([accelerations, ..]) => self.run(accelerations, &[p, q, v], out),
            None => out.fill(f64::NAN),
        }
    }
    fn derivative(&self, p: &[f64], q: &[f64], v: &[f64], q_dot: &mut [f64], v_dot: &mut [f64]) {
        let Some([_, derivative, _]) = &self.solved else {
            q_dot.fill(f64::NAN);
            return v_dot.fill(f64::NAN);
        };
        let mut both = self.derivative.borrow_mut();
        self.run(derivative, &[p, q, v], &mut both);
        q_dot.copy_from_slice(&both[..q.len()]);
        v_dot.copy_from_slice(&both[q.len()..]);
    }
    fn jacobian(&self, p: &[f64], q: &[f64], v: &[f64], out: &mut [f64]) {
        match &self.solved {
            Some([.., jacobian]) => self.run(jacobian, &[p, q, v], out),
            None => out.fill(f64::NAN),
        }
    }
    fn has_taylor(&self) -> bool {
        self.series.is_some()
    }
    fn taylor(&self, p: &[f64], order: usize, x: &mut [f64], _work: &mut [f64]) {
        match &self.series {
            Some(series) => series.evaluate(p, order, x),
            None => x[self.lengths.state()..].fill(f64::NAN),
        }
    }
    fn generalized_speeds(&self, p: &[f64], q: &[f64], v: &[f64], out: &mut [f64]) {
        self.run(&self.generalized_speeds, &[p, q, v], out);
    }
    fn generalized_speed_rates(&self, p: &[f64], q: &[f64], v: &[f64], v_dot: &[f64], out: &mut [f64]) {
        self.run(&self.generalized_speed_rates, &[p, q, v, v_dot], out);
    }
    fn motion_variables(&self, p: &[f64], q: &[f64], u: &[f64], out: &mut [f64]) {
        self.run(&self.motion_variables, &[p, q, u], out);
    }
    fn kinetic_energy(&self, p: &[f64], q: &[f64], v: &[f64]) -> f64 {
        let mut out = [0.0];
        self.run(&self.kinetic_energy, &[p, q, v], &mut out);
        out[0]
    }
    fn potential_energy(&self, p: &[f64], q: &[f64]) -> f64 {
        let mut out = [0.0];
        self.run(&self.potential_energy, &[p, q], &mut out);
        out[0]
    }
}
