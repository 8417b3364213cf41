//! Flow of a mechanism as a program: values and slopes along a direction, in numbers of any precision.

use super::Flow;
use crate::algebra::Expr;
use crate::algebra::form::simplify::Simplifier;
use crate::algebra::term::calculus::Differential;
use crate::algebra::term::steps::{Definition, fresh_symbol};
use crate::algebra::value::evaluate::{Numeric, Tape, UnknownSymbol};

/// Sizes of the inputs and results of a program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sizes {
    /// Number of parameters.
    pub parameters: usize,
    /// Number of states.
    pub states: usize,
    /// Number of inputs along which slopes can be computed.
    pub inputs: usize,
    /// Number of loops; independent loops come first.
    pub loops: usize,
    /// Number of independent loops; the other loops follow from them.
    pub ties: usize,
    /// Number of symmetries.
    pub symmetries: usize,
    /// Number of outputs.
    pub outputs: usize,
}

/// A flow as a program, with its slopes along any direction of states and inputs.
#[derive(Clone)]
pub struct Program {
    tape: Tape,
    /// Numbers of the program's parameters, states, inputs, loops, symmetries and outputs.
    pub sizes: Sizes,
}

/// Results of a program: values, or slopes of the values along a direction.
#[derive(Clone, Debug)]
pub struct Rates<S> {
    /// Rates f of the states, or their slopes.
    pub flow: Vec<S>,
    /// Residuals φ of the loops, or their slopes.
    pub loops: Vec<S>,
    /// Symmetries ζ, one list of components for each, or their slopes.
    pub symmetries: Vec<Vec<S>>,
    /// Outputs y of the program, or their slopes.
    pub outputs: Vec<S>,
}

impl<S: Clone> Rates<S> {
    pub(super) fn new(sizes: Sizes, values: &[S]) -> Self {
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
    /// Program of this flow. Slopes can also be taken along the parameters `inputs`; the terms `outputs` in states are
    /// its outputs.
    ///
    /// # Errors
    /// [`UnknownSymbol`] if an output contains a symbol that is no state, parameter or step.
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
        let sizes = Sizes {
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
    /// Tape that computes the program in doubles; [`Tape::to`] converts it to other numbers.
    #[must_use]
    pub fn tape(&self) -> &Tape {
        &self.tape
    }

    /// Evaluates the program by a tape at a state `x`. Returns values, and slopes along each of the given directions of
    /// states and inputs.
    #[must_use]
    pub fn evaluate<S: Numeric>(
        &self,
        tape: &Tape<S>,
        parameters: &[S],
        x: &[S],
        directions: &[Vec<S>],
    ) -> (Rates<S>, Vec<Rates<S>>) {
        let half = tape.outputs() / 2;
        let at = |direction: &[S]| tape.evaluate(&[parameters, x, direction].concat());
        let none = vec![S::int(0); self.sizes.states + self.sizes.inputs];
        let values = Rates::new(self.sizes, &at(&none)[..half]);
        let slopes = directions.iter().map(|direction| Rates::new(self.sizes, &at(direction)[half..])).collect();
        (values, slopes)
    }

    /// Values at a state `x`, and slopes along each state, then along each input.
    #[must_use]
    pub fn all_slopes<S: Numeric>(&self, tape: &Tape<S>, parameters: &[S], x: &[S]) -> (Rates<S>, Vec<Rates<S>>) {
        let count = self.sizes.states + self.sizes.inputs;
        let unit = |at: usize| (0..count).map(|k| S::int(i64::from(k == at))).collect();
        self.evaluate(tape, parameters, x, &(0..count).map(unit).collect::<Vec<_>>())
    }
}
