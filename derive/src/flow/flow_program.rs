//! Numeric program of a flow. It computes values and directional derivatives, in numbers of any precision.

use super::Flow;
use crate::algebra::Expr;
use crate::algebra::form::simplify::Simplifier;
use crate::algebra::term::calculus::Differential;
use crate::algebra::term::steps::{Definition, fresh_symbol};
use crate::algebra::value::tape::{Numeric, Tape, UnknownSymbol};

/// Numbers of parameters, states, inputs, loops, symmetries and outputs of a flow's program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FlowProgramSizes {
    /// Number of parameters of the flow.
    pub parameters: usize,
    /// Number of states: coordinates and speeds.
    pub states: usize,
    /// Number of inputs with respect to which derivatives can be computed.
    pub inputs: usize,
    /// Number of loop equations; independent loops come first, redundant loops last.
    pub loops: usize,
    /// Number of independent loop equations, which come first. The remaining loops depend on them.
    pub ties: usize,
    /// Number of symmetries of the flow.
    pub symmetries: usize,
    /// Number of outputs that the program computes.
    pub outputs: usize,
}

/// Flow as a numeric program, which also gives derivatives along any direction of states and inputs.
#[derive(Clone)]
pub struct Program {
    /// Instructions of the program in double precision. Its outputs are the values, then the derivatives.
    tape: Tape,
    /// Numbers of the program's parameters, states, inputs, loops, symmetries and outputs.
    pub sizes: FlowProgramSizes,
}

/// Results of a flow's program: values at a state, or derivatives of these values along a direction.
#[derive(Clone, Debug)]
pub struct FlowProgramResults<S> {
    /// Rates f of the states, one for each state, or their derivatives.
    pub flow: Vec<S>,
    /// Residuals φ of the loops, one for each loop, or their derivatives.
    pub loops: Vec<S>,
    /// Components of each symmetry ζ, one inner list for each symmetry, or their derivatives.
    pub symmetries: Vec<Vec<S>>,
    /// Outputs y of the program, one for each output, or their derivatives.
    pub outputs: Vec<S>,
}

impl<S: Clone> FlowProgramResults<S> {
    /// Splits a list of values into rates, loops, symmetries and outputs.
    pub(super) fn new(sizes: FlowProgramSizes, values: &[S]) -> Self {
        let (flow, rest) = values.split_at(sizes.states);
        let (loops, rest) = rest.split_at(sizes.loops);
        let (symmetries, outputs) = rest.split_at(sizes.symmetries * sizes.states);
        Self {
            flow: flow.to_vec(),
            loops: loops.to_vec(),
            symmetries: symmetries.chunks(sizes.states.max(1)).map(<[S]>::to_vec).collect(),
            outputs: outputs.to_vec(),
        }
    }
}

impl Flow {
    /// Compiles this flow to a numeric program, which also computes the terms `outputs` in states. `inputs` are
    /// parameters with respect to which derivatives are also possible.
    ///
    /// # Errors
    /// Returns [`UnknownSymbol`] if an output contains a symbol that is not a state, a parameter or a defined symbol.
    pub fn program(&self, inputs: &[Expr], outputs: &[Expr]) -> Result<Program, UnknownSymbol> {
        let mut arena = self.arena.clone();
        let mut simplifier = Simplifier::default();
        let along: Vec<Expr> = self.states.iter().chain(inputs).copied().collect();
        let direction: Vec<Expr> =
            (0..along.len()).map(|at| fresh_symbol(&mut arena, &format!("along_{at}"))).collect();
        let mut slope = Differential::along(&along.iter().copied().zip(direction.iter().copied()).collect::<Vec<_>>());
        let mut steps = Vec::with_capacity(2 * self.steps.len());
        for step in &self.steps {
            steps.push(*step);
            let value = slope.apply(&mut arena, step.value);
            let value = simplifier.simplify(&mut arena, value);
            let symbol = fresh_symbol(&mut arena, "slope");
            steps.push(Definition { symbol, value });
            slope.set_rate(step.symbol, symbol);
        }
        let values: Vec<Expr> = self
            .rates
            .iter()
            .chain(&self.loops)
            .chain(&self.closed)
            .chain(self.symmetries.iter().flat_map(|symmetry| &symmetry.along))
            .chain(outputs)
            .copied()
            .collect();
        let slopes: Vec<Expr> = values.iter().map(|value| slope.apply(&mut arena, *value)).collect();
        let symbols = [&self.parameters[..], &self.states, &direction].concat();
        let tape = Tape::stepwise(&arena, &symbols, &steps, &[values, slopes].concat())?;
        let sizes = FlowProgramSizes {
            parameters: self.parameters.len(),
            states: self.states.len(),
            inputs: inputs.len(),
            loops: self.loops.len() + self.closed.len(),
            ties: self.loops.len(),
            symmetries: self.symmetries.len(),
            outputs: outputs.len(),
        };
        Ok(Program { tape, sizes })
    }
}

impl Program {
    /// Instructions of the program in double precision. [`Tape::to`] converts them to other numbers.
    #[must_use]
    pub fn tape(&self) -> &Tape {
        &self.tape
    }

    /// Evaluates the program at a state `x`, with the instructions `tape`. Returns the values, and their derivatives
    /// along each of the given directions. A direction has a component for each state, then for each input.
    #[must_use]
    pub fn evaluate<S: Numeric>(
        &self,
        tape: &Tape<S>,
        parameters: &[S],
        x: &[S],
        directions: &[Vec<S>],
    ) -> (FlowProgramResults<S>, Vec<FlowProgramResults<S>>) {
        let half = tape.outputs() / 2;
        let at = |direction: &[S]| tape.evaluate(&[parameters, x, direction].concat());
        let none = vec![S::int(0); self.sizes.states + self.sizes.inputs];
        let values = FlowProgramResults::new(self.sizes, &at(&none)[..half]);
        let slopes =
            directions.iter().map(|direction| FlowProgramResults::new(self.sizes, &at(direction)[half..])).collect();
        (values, slopes)
    }

    /// Evaluates the program at a state `x`, with the instructions `tape`. Returns the values, and their derivatives
    /// with respect to each state, then to each input.
    #[must_use]
    pub fn all_slopes<S: Numeric>(
        &self,
        tape: &Tape<S>,
        parameters: &[S],
        x: &[S],
    ) -> (FlowProgramResults<S>, Vec<FlowProgramResults<S>>) {
        let count = self.sizes.states + self.sizes.inputs;
        let unit = |at: usize| (0..count).map(|k| S::int(i64::from(k == at))).collect();
        self.evaluate(tape, parameters, x, &(0..count).map(unit).collect::<Vec<_>>())
    }
}
