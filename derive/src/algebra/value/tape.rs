//! Numerical evaluation of expressions, in numbers of any precision. A tape is a straight-line list
//! of operations that computes all expressions.
//!
//! Invariant: the constants of a tape are exact rationals, rounded once to the number type in which
//! the tape is evaluated. A tape proves nothing: its numbers decide no question of meaning.

mod backwards;

pub use backwards::BackwardWorkspace;

use crate::algebra::term::fold::{Fold, FoldOrder, Values};
use crate::algebra::term::steps::Definition;
use crate::algebra::{Arena, Expr, Function, Rational};
use rustc_hash::FxHashMap;
use std::sync::Arc;
use tripos_traits::{Ball, Centre, DoubleDouble, Dual, Enclosure, Interval, Lanes, Scalar, Tangent};

/// Number type in which expressions are evaluated, such as doubles or intervals.
pub trait Numeric: Scalar {
    /// Converts a rational number to the nearest value, to the 32 digits that a pair of doubles
    /// holds.
    #[must_use]
    fn from_rational(value: &Rational) -> Self {
        let nearest = value.to_f64();
        let rest = Rational::from_f64_exact(nearest).map(|exact| value.add(&exact.neg()));
        Self::from_f64(nearest) + Self::from_f64(rest.map_or(0.0, |rest| rest.to_f64()))
    }
    /// Function value f(x), with angles in radians. The result is NaN ("not a number") outside of
    /// the function's domain.
    #[must_use]
    fn apply(self, f: Function) -> Self {
        function_value(self, f)
    }
    /// Power xⁿ of a number; n may be negative.
    #[must_use]
    fn power(self, n: i32) -> Self {
        self.powi(n)
    }
}

/// Function value f(x), computed with the functions of the scalar type.
fn function_value<S: Scalar>(x: S, f: Function) -> S {
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

/// Number with derivatives. Its value is computed with the functions for doubles, so it has the
/// same bits as in a tape of doubles.
impl<const K: usize> Numeric for Tangent<K> {
    fn from_rational(value: &Rational) -> Self {
        Self::constant(value.to_f64())
    }
    fn apply(self, f: Function) -> Self {
        Self { value: self.value.apply(f), ..function_value(self, f) }
    }
    fn power(self, n: i32) -> Self {
        Self { value: self.value.power(n), ..self.powi(n) }
    }
}

/// Range of values for ranges of the inputs. A constant that no double represents exactly becomes
/// the interval between the two neighbouring doubles.
impl Numeric for Enclosure {
    fn from_rational(value: &Rational) -> Self {
        let nearest = value.to_f64();
        let exact = Rational::from_f64_exact(nearest).as_ref() == Some(value);
        Self::constant(if exact { Interval::point(nearest) } else { Interval::rounded(nearest) })
    }
}

/// Ball that provably contains the value. A constant that the centre does not represent exactly has a radius.
impl<C: Centre> Numeric for Ball<C> {
    fn from_rational(value: &Rational) -> Self {
        let nearest = value.to_f64();
        let Some(exact) = Rational::from_f64_exact(nearest) else { return Self::undefined() };
        let rest = value.add(&exact.neg()).to_f64();
        // The rest is rounded to a double, with an error of at most one unit in its last place.
        let wide = Ball { centre: DoubleDouble::sum(nearest, rest), radius: 2.0 * f64::EPSILON * rest.abs() };
        Self::narrowed(wide)
    }
}

/// Ball with a ball of the derivative along a single direction.
impl<C: Centre> Numeric for Dual<Ball<C>> {
    fn from_rational(value: &Rational) -> Self {
        Self::constant(Ball::from_rational(value))
    }
}

/// Double, evaluated with the functions of the system's standard library. They are independent of
/// the functions in generated code.
impl Numeric for f64 {
    fn from_rational(value: &Rational) -> Self {
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

/// Doubles of several states at once. Each lane has the same bits as a tape in doubles.
impl<const N: usize> Numeric for Lanes<N> {
    fn from_rational(value: &Rational) -> Self {
        Self::from_f64(value.to_f64())
    }
    fn apply(self, f: Function) -> Self {
        Self(self.0.map(|x| x.apply(f)))
    }
    fn power(self, n: i32) -> Self {
        // A factor without a power is the most frequent.
        if n == 1 { self } else { Self(self.0.map(|x| x.power(n))) }
    }
}

/// Operation of a tape, with constants of type `K`. An operand is a slot: the number of an earlier
/// operation, whose result is used.
#[derive(Clone, Debug)]
enum Op<K> {
    /// A constant number, rounded to the number type.
    Constant(K),
    /// The number π.
    Pi,
    /// Value of an input of the tape, by the input's number.
    Input(usize),
    /// Sum constant + Σ k · slot over pairs (slot, k); a slot is the result of an earlier
    /// operation.
    Sum(K, Box<[(u32, K)]>),
    /// Product Π slot^n over pairs (slot, n); a slot is the result of an earlier operation.
    Product(Box<[(u32, i32)]>),
    /// Function value at a slot, the result of an earlier operation.
    Apply(Function, u32),
}

impl Op<Rational> {
    /// Same operation for numbers of type `S`, with its constants rounded to that type.
    fn round_constants<S: Numeric>(&self) -> Op<S> {
        match self {
            Self::Constant(value) => Op::Constant(S::from_rational(value)),
            Self::Pi => Op::Pi,
            Self::Input(at) => Op::Input(*at),
            Self::Sum(constant, terms) => Op::Sum(
                S::from_rational(constant),
                terms.iter().map(|(slot, k)| (*slot, S::from_rational(k))).collect(),
            ),
            Self::Product(factors) => Op::Product(factors.clone()),
            Self::Apply(f, slot) => Op::Apply(*f, *slot),
        }
    }
}

/// Expressions compiled to a tape of operations. An evaluation costs one pass and allocates
/// nothing.
#[derive(Clone, Debug)]
pub struct Tape<S = f64> {
    /// Operations in the order of evaluation, with rounded constants.
    ops: Vec<Op<S>>,
    /// Operations with exact constants, from which other number types are rounded.
    exact: Arc<[Op<Rational>]>,
    /// Slot of each output: the number of the operation that computes it.
    outputs: Vec<u32>,
    /// Number of inputs of the tape.
    inputs: usize,
}

/// Error: a symbol, given by its name, occurs in an expression but is not an input of the tape.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnknownSymbol(pub String);

/// Tape under construction. Each term has a slot: the number of the operation that computes it.
struct Assembly<'a> {
    /// Arena of the compiled terms.
    arena: &'a Arena,
    /// Number of each input, by the symbol of the input.
    inputs: FxHashMap<Expr, usize>,
    /// Operations so far, with exact constants.
    ops: Vec<Op<Rational>>,
    /// Slot of each term that the tape already computes.
    slots: FxHashMap<Expr, u32>,
    /// Symbol that is neither an input nor a step; `None` if none was found.
    unknown: Option<UnknownSymbol>,
}

impl Assembly<'_> {
    /// Appends the operations that compute the given expressions, unless the tape already computes
    /// them. Error if a symbol is not an input.
    fn extend(&mut self, expressions: &[Expr]) -> Result<(), UnknownSymbol> {
        let needed = FoldOrder::new(self.arena, expressions);
        let made = needed.fold(self.arena, self);
        let made = made.ok_or_else(|| self.unknown.take().expect("nothing else has no place"))?;
        self.slots.extend(made.iter().map(|(e, slot)| (e, *slot)));
        Ok(())
    }

    /// Appends an operation and returns its slot.
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
    /// Compiles the terms `outputs` as functions of the symbols `inputs`, for evaluation in
    /// doubles.
    ///
    /// # Errors
    /// [`UnknownSymbol`] if an output depends on a symbol that is not an input.
    pub fn new(arena: &Arena, inputs: &[Expr], outputs: &[Expr]) -> Result<Self, UnknownSymbol> {
        Self::stepwise(arena, inputs, &[], outputs)
    }

    /// Compiles the terms `outputs` as functions of the symbols `inputs` and of the symbols that
    /// `steps` define. Each step may use earlier steps.
    ///
    /// # Errors
    /// [`UnknownSymbol`] if a step or an output depends on a symbol that is neither an input nor an
    /// earlier step.
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
        let ops = made.ops.iter().map(Op::round_constants).collect();
        Ok(Self { ops, exact: made.ops.into(), outputs, inputs: inputs.len() })
    }

    /// Absolute value of the largest intermediate term in the computation of each output, in the
    /// output's unit. The rounding error of an output is that of this term, even if most of the
    /// term cancels.
    ///
    /// # Panics
    /// If the number of `inputs` differs from that of the tape.
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
                // A divisor counts with its absolute value, a factor with its largest intermediate
                // term.
                Op::Product(factors) => factors.iter().fold(1.0, |product, (slot, n)| {
                    product * if *n > 0 { of(slot).powi(*n) } else { values[*slot as usize].abs().powi(*n) }
                }),
                // The sine of a large angle has the rounding error of the angle.
                Op::Apply(Function::Sin | Function::Cos, slot) => value.abs().max(of(slot).min(1.0)),
                Op::Constant(_) | Op::Pi | Op::Input(_) | Op::Apply(..) => value.abs(),
            };
            largest.push(size);
        }
        self.outputs.iter().map(|slot| largest[*slot as usize]).collect()
    }
}

impl<S: Numeric> Tape<S> {
    /// Converts the tape to another type of number; constants are rounded anew from their exact
    /// values.
    #[must_use]
    pub fn to<T: Numeric>(&self) -> Tape<T> {
        let ops = self.exact.iter().map(Op::round_constants).collect();
        Tape { ops, exact: Arc::clone(&self.exact), outputs: self.outputs.clone(), inputs: self.inputs }
    }

    /// Number of outputs of the tape.
    #[must_use]
    pub fn outputs(&self) -> usize {
        self.outputs.len()
    }

    /// Indices of the inputs that the tape uses, in ascending order.
    #[must_use]
    pub fn used_inputs(&self) -> Vec<usize> {
        let mut list: Vec<usize> =
            self.ops.iter().filter_map(|op| if let Op::Input(at) = op { Some(*at) } else { None }).collect();
        list.sort_unstable();
        list.dedup();
        list
    }

    /// Evaluates all outputs into `out`, which has one entry for each output. `scratch` is working
    /// space that may be reused in later calls.
    ///
    /// # Panics
    /// If the number of `inputs` or the length of `out` differs from that of the tape.
    pub fn evaluate_into(&self, inputs: &[S], scratch: &mut Vec<S>, out: &mut [S]) {
        assert_eq!(inputs.len(), self.inputs, "one value for each input");
        assert_eq!(out.len(), self.outputs.len(), "one place for each output");
        scratch.clear();
        S::dispatch(
            #[inline(always)]
            || {
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
            },
        );
        for (place, slot) in out.iter_mut().zip(&self.outputs) {
            *place = scratch[*slot as usize];
        }
    }

    /// Evaluates all outputs into a new vector, one entry per output.
    ///
    /// # Panics
    /// If the number of `inputs` differs from that of the tape.
    #[must_use]
    pub fn evaluate(&self, inputs: &[S]) -> Vec<S> {
        let mut out = vec![S::int(0); self.outputs.len()];
        self.evaluate_into(inputs, &mut Vec::with_capacity(self.ops.len()), &mut out);
        out
    }
}
