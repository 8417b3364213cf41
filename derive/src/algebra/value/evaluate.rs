//! Interpretation: expressions as a straight-line tape of operations, in numbers of any precision.
//!
//! Invariant: a tape's constants are exact rationals, rounded once to each kind of number that it is evaluated in. A
//! tape proves nothing: its numbers decide no question of meaning.

mod backwards;

pub use backwards::Backwards;

use crate::algebra::term::fold::{Fold, Needed, Values};
use crate::algebra::term::steps::Definition;
use crate::algebra::{Arena, Expr, Function, Rational};
use rustc_hash::FxHashMap;
use std::sync::Arc;
use tripos_traits::{DoubleDouble, Enclosure, Interval, Scalar, Tangent};

/// A kind of number that expressions are evaluated in.
pub trait Numeric: Scalar {
    /// The nearest value to a rational number, to the 32 digits that two doubles hold.
    #[must_use]
    fn of(value: &Rational) -> Self {
        let nearest = value.to_f64();
        let rest = Rational::from_f64_exact(nearest).map(|exact| value.add(&exact.neg()));
        Self::from_f64(nearest) + Self::from_f64(rest.map_or(0.0, |rest| rest.to_f64()))
    }
    /// Function value f(x); not a number outside of the function's domain.
    #[must_use]
    fn apply(self, f: Function) -> Self {
        applied(self, f)
    }
    /// Power xⁿ; n may be negative.
    #[must_use]
    fn power(self, n: i32) -> Self {
        self.powi(n)
    }
}

/// Function value f(x), by the functions of the scalar type.
fn applied<S: Scalar>(x: S, f: Function) -> S {
    match f {
        Function::Sin => x.sin_cos().0,
        Function::Cos => x.sin_cos().1,
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
        Function::Sign => x.sign(),
    }
}

impl Numeric for DoubleDouble {}

/// Evaluates a tape in numbers with slopes. Values come from the functions of a tape in doubles, so that they have the
/// same bits.
impl<const K: usize> Numeric for Tangent<K> {
    fn of(value: &Rational) -> Self {
        Self::constant(value.to_f64())
    }
    fn apply(self, f: Function) -> Self {
        Self { value: self.value.apply(f), ..applied(self, f) }
    }
    fn power(self, n: i32) -> Self {
        Self { value: self.value.power(n), ..self.powi(n) }
    }
}

/// Evaluates a tape over the ranges of its inputs. A constant that no double holds becomes the range between the two
/// doubles next to it.
impl Numeric for Enclosure {
    fn of(value: &Rational) -> Self {
        let nearest = value.to_f64();
        let exact = Rational::from_f64_exact(nearest).as_ref() == Some(value);
        Self::constant(if exact { Interval::point(nearest) } else { Interval::rounded(nearest) })
    }
}

/// Evaluates a tape in doubles with the functions of the standard library, which are those of the system. They are
/// independent of generated code, which brings its own functions.
impl Numeric for f64 {
    fn of(value: &Rational) -> Self {
        value.to_f64()
    }
    fn apply(self, f: Function) -> Self {
        match f {
            Function::Sin => self.sin(),
            Function::Cos => self.cos(),
            Function::Sqrt => self.sqrt(),
            Function::Exp => self.exp(),
            Function::Log => self.ln(),
            Function::Asin => self.asin(),
            Function::Acos => self.acos(),
            Function::Atan => self.atan(),
            Function::Sinh => self.sinh(),
            Function::Cosh => self.cosh(),
            Function::Tanh => self.tanh(),
            Function::Abs => self.abs(),
            Function::Sign => Scalar::sign(self),
        }
    }
    fn power(self, n: i32) -> Self {
        self.powi(n)
    }
}

/// Operation of a tape, with constants of type `K`.
#[derive(Clone, Debug)]
enum Op<K> {
    Constant(K),
    Pi,
    Input(usize),
    /// The sum constant + Σ k·slot
    Sum(K, Box<[(u32, K)]>),
    /// The product Π slot^n
    Product(Box<[(u32, i32)]>),
    Apply(Function, u32),
}

impl Op<Rational> {
    /// Operation in numbers of type `S`, with its constants rounded to that type.
    fn rounded<S: Numeric>(&self) -> Op<S> {
        match self {
            Self::Constant(value) => Op::Constant(S::of(value)),
            Self::Pi => Op::Pi,
            Self::Input(at) => Op::Input(*at),
            Self::Sum(constant, terms) => {
                Op::Sum(S::of(constant), terms.iter().map(|(slot, k)| (*slot, S::of(k))).collect())
            }
            Self::Product(factors) => Op::Product(factors.clone()),
            Self::Apply(f, slot) => Op::Apply(*f, *slot),
        }
    }
}

/// Expressions compiled to a tape; evaluating costs one pass without allocation.
#[derive(Clone, Debug)]
pub struct Tape<S = f64> {
    ops: Vec<Op<S>>,
    exact: Arc<[Op<Rational>]>,
    outputs: Vec<u32>,
    inputs: usize,
}

/// A symbol that occurs in an expression but is not an input of the tape.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnknownSymbol(pub String);

/// A tape while it is made. The value of a term is the slot that holds it.
struct Assembly<'a> {
    arena: &'a Arena,
    inputs: FxHashMap<Expr, usize>,
    ops: Vec<Op<Rational>>,
    /// Slot of each term whose value the tape computes already.
    slots: FxHashMap<Expr, u32>,
    unknown: Option<UnknownSymbol>,
}

impl Assembly<'_> {
    /// Appends the operations that compute these expressions, unless they are there already.
    fn extend(&mut self, expressions: &[Expr]) -> Result<(), UnknownSymbol> {
        let needed = Needed::new(self.arena, expressions);
        let made = needed.fold(self.arena, self);
        let made = made.ok_or_else(|| self.unknown.take().expect("nothing else has no place"))?;
        self.slots.extend(made.iter().map(|(e, slot)| (e, *slot)));
        Ok(())
    }

    fn push(&mut self, op: Op<Rational>) -> u32 {
        self.ops.push(op);
        u32::try_from(self.ops.len() - 1).expect("as many slots as terms")
    }
}

impl Fold for Assembly<'_> {
    type Value = u32;
    fn number(&mut self, value: &Rational) -> Option<u32> {
        Some(self.push(Op::Constant(value.clone())))
    }
    fn pi(&mut self) -> Option<u32> {
        Some(self.push(Op::Pi))
    }
    fn symbol(&mut self, symbol: Expr) -> Option<u32> {
        self.unknown = Some(UnknownSymbol(self.arena.symbol_name(symbol).unwrap_or_default().to_owned()));
        None
    }
    fn sum(&mut self, constant: &Rational, terms: &[(Expr, Rational)], of: &Values<'_, u32>) -> Option<u32> {
        Some(self.push(Op::Sum(constant.clone(), terms.iter().map(|(term, k)| (of[*term], k.clone())).collect())))
    }
    fn product(&mut self, factors: &[(Expr, i32)], of: &Values<'_, u32>) -> Option<u32> {
        Some(self.push(Op::Product(factors.iter().map(|(base, n)| (of[*base], *n)).collect())))
    }
    fn apply(&mut self, f: Function, argument: Expr, of: &Values<'_, u32>) -> Option<u32> {
        Some(self.push(Op::Apply(f, of[argument])))
    }
    fn known(&mut self, term: Expr) -> Option<u32> {
        if let Some(slot) = self.slots.get(&term) {
            return Some(*slot);
        }
        let at = *self.inputs.get(&term)?;
        Some(self.push(Op::Input(at)))
    }
}

impl Tape {
    /// Compiles `outputs` as functions of `inputs`, to be evaluated in doubles.
    ///
    /// # Errors
    /// [`UnknownSymbol`] if an output depends on a symbol that is no input.
    pub fn new(arena: &Arena, inputs: &[Expr], outputs: &[Expr]) -> Result<Self, UnknownSymbol> {
        Self::stepwise(arena, inputs, &[], outputs)
    }

    /// Compiles `outputs` as functions of `inputs` and of the symbols that `steps` define, each step by earlier ones.
    ///
    /// # Errors
    /// [`UnknownSymbol`] if a step or an output depends on a symbol that is neither.
    pub fn stepwise(
        arena: &Arena,
        inputs: &[Expr],
        steps: &[Definition],
        outputs: &[Expr],
    ) -> Result<Self, UnknownSymbol> {
        let mut made = Assembly {
            arena,
            inputs: inputs.iter().enumerate().map(|(at, e)| (*e, at)).collect(),
            ops: Vec::new(),
            slots: FxHashMap::default(),
            unknown: None,
        };
        for step in steps {
            made.extend(&[step.value])?;
            made.slots.insert(step.symbol, made.slots[&step.value]);
        }
        made.extend(outputs)?;
        let outputs = outputs.iter().map(|e| made.slots[e]).collect();
        let ops = made.ops.iter().map(Op::rounded).collect();
        Ok(Self { ops, exact: made.ops.into(), outputs, inputs: inputs.len() })
    }

    /// Largest term, for each output, that is added or multiplied on the way to it. A value is known only to the
    /// rounding of this term, however much of it cancels.
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
                // A divisor counts with its value, a factor with its largest term.
                Op::Product(factors) => factors.iter().fold(1.0, |product, (slot, n)| {
                    product * if *n > 0 { of(slot).powi(*n) } else { values[*slot as usize].abs().powi(*n) }
                }),
                // The sine of a large angle is rounded with the angle.
                Op::Apply(Function::Sin | Function::Cos, slot) => value.abs().max(of(slot).min(1.0)),
                Op::Constant(_) | Op::Pi | Op::Input(_) | Op::Apply(..) => value.abs(),
            };
            largest.push(size);
        }
        self.outputs.iter().map(|slot| largest[*slot as usize]).collect()
    }
}

impl<S: Numeric> Tape<S> {
    /// Tape in another kind of number, rounded from the exact constants.
    #[must_use]
    pub fn to<T: Numeric>(&self) -> Tape<T> {
        let ops = self.exact.iter().map(Op::rounded).collect();
        Tape { ops, exact: Arc::clone(&self.exact), outputs: self.outputs.clone(), inputs: self.inputs }
    }

    /// Number of outputs.
    #[must_use]
    pub fn outputs(&self) -> usize {
        self.outputs.len()
    }

    /// Numbers of the inputs that the outputs depend on, in order.
    #[must_use]
    pub fn used(&self) -> Vec<usize> {
        let mut list: Vec<usize> =
            self.ops.iter().filter_map(|op| if let Op::Input(at) = op { Some(*at) } else { None }).collect();
        list.sort_unstable();
        list.dedup();
        list
    }

    /// Evaluates all outputs. `scratch` is working space, reused between calls.
    ///
    /// # Panics
    /// If `inputs` or `out` have another length than the tape was made for.
    pub fn evaluate_into(&self, inputs: &[S], scratch: &mut Vec<S>, out: &mut [S]) {
        assert_eq!(inputs.len(), self.inputs, "one value for each input");
        assert_eq!(out.len(), self.outputs.len(), "one place for each output");
        scratch.clear();
        for op in &self.ops {
            let of = |slot: &u32| scratch[*slot as usize];
            let value = match op {
                Op::Constant(value) => *value,
                Op::Pi => S::pi(),
                Op::Input(at) => inputs[*at],
                Op::Sum(constant, terms) => terms.iter().fold(*constant, |sum, (slot, k)| sum + *k * of(slot)),
                Op::Product(factors) => {
                    factors.iter().fold(S::int(1), |product, (slot, n)| product * of(slot).power(*n))
                }
                Op::Apply(f, slot) => of(slot).apply(*f),
            };
            scratch.push(value);
        }
        for (place, slot) in out.iter_mut().zip(&self.outputs) {
            *place = scratch[*slot as usize];
        }
    }

    /// Evaluates all outputs into a new vector.
    ///
    /// # Panics
    /// If `inputs` have another length than the tape was made for.
    #[must_use]
    pub fn evaluate(&self, inputs: &[S]) -> Vec<S> {
        let mut out = vec![S::int(0); self.outputs.len()];
        self.evaluate_into(inputs, &mut Vec::with_capacity(self.ops.len()), &mut out);
        out
    }
}
