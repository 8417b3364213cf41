//! Interpretation: expressions as a straight-line tape of floating-point operations.

use super::elimination::Definition;
use super::{Arena, Expr, Function, Node};
use rustc_hash::FxHashMap;

#[derive(Clone, Debug)]
enum Op {
    Constant(f64),
    Input(usize),
    /// constant + Σ k·slot
    Sum(f64, Box<[(u32, f64)]>),
    /// Π slot^n
    Product(Box<[(u32, i32)]>),
    Apply(Function, u32),
}

/// Expressions compiled to a tape; evaluating costs one pass without allocation.
#[derive(Clone, Debug)]
pub struct Tape {
    ops: Vec<Op>,
    outputs: Vec<u32>,
    inputs: usize,
}

/// A symbol that occurs in an expression but is none of the tape's inputs.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnknownSymbol(pub String);

impl Tape {
    /// Compiles `outputs` as functions of `inputs`.
    ///
    /// # Errors
    /// [`UnknownSymbol`] if an output depends on a symbol that is no input.
    pub fn new(arena: &Arena, inputs: &[Expr], outputs: &[Expr]) -> Result<Self, UnknownSymbol> {
        Self::stepwise(arena, inputs, &[], outputs)
    }

    /// Compiles `outputs` as functions of `inputs` and of what the steps define, each by those before it.
    ///
    /// # Errors
    /// [`UnknownSymbol`] if a step or an output depends on a symbol that is neither.
    pub fn stepwise(
        arena: &Arena,
        inputs: &[Expr],
        steps: &[Definition],
        outputs: &[Expr],
    ) -> Result<Self, UnknownSymbol> {
        let position: FxHashMap<Expr, usize> = inputs.iter().enumerate().map(|(i, e)| (*e, i)).collect();
        let mut tape = Self { ops: Vec::new(), outputs: Vec::new(), inputs: inputs.len() };
        let mut slots: FxHashMap<Expr, u32> = FxHashMap::default();
        for step in steps {
            tape.extend(arena, &position, &mut slots, &[step.value])?;
            slots.insert(step.symbol, slots[&step.value]);
        }
        tape.extend(arena, &position, &mut slots, outputs)?;
        tape.outputs = outputs.iter().map(|e| slots[e]).collect();
        Ok(tape)
    }

    /// Appends what computes these expressions, unless it is there.
    fn extend(
        &mut self,
        arena: &Arena,
        position: &FxHashMap<Expr, usize>,
        slots: &mut FxHashMap<Expr, u32>,
        expressions: &[Expr],
    ) -> Result<(), UnknownSymbol> {
        for e in arena.reachable(expressions) {
            if slots.contains_key(&e) {
                continue;
            }
            let op = match arena.node(e) {
                _ if position.contains_key(&e) => Op::Input(position[&e]),
                Node::Symbol(_) => {
                    return Err(UnknownSymbol(arena.symbol_name(e).unwrap_or_default().to_owned()));
                }
                Node::Number(value) => Op::Constant(value.to_f64()),
                Node::Pi => Op::Constant(std::f64::consts::PI),
                Node::Sum(constant, terms) => {
                    Op::Sum(constant.to_f64(), terms.iter().map(|(t, k)| (slots[t], k.to_f64())).collect())
                }
                Node::Product(factors) => Op::Product(factors.iter().map(|(b, n)| (slots[b], *n)).collect()),
                Node::Apply(f, argument) => Op::Apply(*f, slots[argument]),
            };
            slots.insert(e, u32::try_from(self.ops.len()).expect("as many slots as terms"));
            self.ops.push(op);
        }
        Ok(())
    }

    /// Number of outputs.
    #[must_use]
    pub fn outputs(&self) -> usize {
        self.outputs.len()
    }

    /// Evaluates all outputs. `scratch` is working space, reused between calls.
    ///
    /// # Panics
    /// If `inputs` or `out` have another length than the tape was made for.
    pub fn evaluate_into(&self, inputs: &[f64], scratch: &mut Vec<f64>, out: &mut [f64]) {
        assert_eq!(inputs.len(), self.inputs, "one value for each input");
        assert_eq!(out.len(), self.outputs.len(), "one place for each output");
        scratch.clear();
        for op in &self.ops {
            let value = match op {
                Op::Constant(value) => *value,
                Op::Input(at) => inputs[*at],
                Op::Sum(constant, terms) => {
                    terms.iter().fold(*constant, |sum, (slot, k)| sum + k * scratch[*slot as usize])
                }
                Op::Product(factors) => {
                    factors.iter().fold(1.0, |product, (slot, n)| product * scratch[*slot as usize].powi(*n))
                }
                Op::Apply(f, slot) => value_of(*f, scratch[*slot as usize]),
            };
            scratch.push(value);
        }
        for (place, slot) in out.iter_mut().zip(&self.outputs) {
            *place = scratch[*slot as usize];
        }
    }

    /// For each output the largest term that is added or multiplied on the way to it: a value is not known better than to the
    /// rounding of these, however much of them cancels.
    ///
    /// # Panics
    /// If `inputs` have another length than the tape was made for.
    #[must_use]
    pub fn largest_terms(&self, inputs: &[f64]) -> Vec<f64> {
        let mut values = Vec::with_capacity(self.ops.len());
        self.evaluate_into(inputs, &mut values, &mut vec![0.0; self.outputs.len()]);
        let mut largest: Vec<f64> = Vec::with_capacity(self.ops.len());
        for (op, value) in self.ops.iter().zip(&values) {
            let of = |slot: &u32| largest[*slot as usize];
            let size = match op {
                Op::Sum(constant, terms) => {
                    terms.iter().fold(constant.abs(), |most, (slot, k)| most.max((k * of(slot)).abs()))
                }
                // A divisor is as small as it is; a factor counts with its largest term.
                Op::Product(factors) => factors.iter().fold(1.0, |product, (slot, n)| {
                    product * if *n > 0 { of(slot).powi(*n) } else { values[*slot as usize].abs().powi(*n) }
                }),
                // The sine of a large angle is rounded with the angle.
                Op::Apply(Function::Sin | Function::Cos, slot) => value.abs().max(of(slot).min(1.0)),
                Op::Constant(_) | Op::Input(_) | Op::Apply(..) => value.abs(),
            };
            largest.push(size);
        }
        self.outputs.iter().map(|slot| largest[*slot as usize]).collect()
    }

    /// All outputs, in a new vector.
    #[must_use]
    pub fn evaluate(&self, inputs: &[f64]) -> Vec<f64> {
        let mut out = vec![0.0; self.outputs.len()];
        self.evaluate_into(inputs, &mut Vec::with_capacity(self.ops.len()), &mut out);
        out
    }
}

/// f(x) in floating point.
#[must_use]
pub fn value_of(f: Function, x: f64) -> f64 {
    match f {
        Function::Sin => x.sin(),
        Function::Cos => x.cos(),
        Function::Sqrt => x.sqrt(),
        Function::Exp => x.exp(),
        Function::Log => x.ln(),
        Function::Asin => x.asin(),
        Function::Acos => x.acos(),
        Function::Atan => x.atan(),
        Function::Sinh => x.sinh(),
        Function::Cosh => x.cosh(),
        Function::Tanh => x.tanh(),
        Function::Abs => x.abs(),
        Function::Sign => {
            if x == 0.0 {
                0.0
            } else {
                x.signum()
            }
        }
    }
}
