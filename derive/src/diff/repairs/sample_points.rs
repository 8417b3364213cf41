//! Numerical values of changed formulas at random states, in double precision.
//!
//! The states are permitted: they satisfy the model's constraints and its domain. Numbers only reject changes, and
//! prove nothing: a change that agrees in numbers is proved by exact algebra afterwards.

use super::Rewriting;
use crate::algebra::meaning::compare::Comparer;
use crate::algebra::{Arena, Expr, Function, Node};
use crate::mechanics::Quantities;
use rustc_hash::FxHashMap;

/// Number of random states at which a changed formula is evaluated.
pub const POINTS: usize = 3;
/// Relative difference up to which two values count as equal.
pub const SMALL: f64 = 1e-9;

/// Random states that the model's constraints permit, with the values of the symbols and of the right formula at each
/// state.
pub struct SamplePoints {
    /// Values of symbols and of terms evaluated so far, one number for each state.
    values: FxHashMap<Expr, [f64; POINTS]>,
    /// Values of the right formula, one number for each state.
    right: [f64; POINTS],
}

impl SamplePoints {
    /// Draws three random states that the model's constraints permit. `symbols` are in `arena`, and the right formula
    /// `derived` is in the arena of the derivations. Returns `None` if not enough states are found, or if a symbol is
    /// unknown to the derivations.
    pub fn new(
        quantities: &mut Quantities<'_>,
        comparer: &mut Comparer,
        arena: &Arena,
        symbols: &[Expr],
        derived: Expr,
        rewriting: &mut Rewriting<'_>,
    ) -> Option<Self> {
        let mut outputs = vec![derived];
        let mut valued = Vec::new();
        for symbol in symbols {
            let own = quantities.derivations.kinematics.arena.find_symbol(arena.symbol_name(*symbol)?)?;
            if let Ok(value) = rewriting(quantities, own) {
                valued.push(*symbol);
                outputs.push(value);
            }
        }
        let main = &mut quantities.derivations.kinematics.arena;
        let samples = comparer.permitted().samples(main, &outputs)?;
        let states: Vec<Vec<f64>> = samples.take(POINTS).collect();
        let states: [Vec<f64>; POINTS] = states.try_into().ok()?;
        let values = |at: usize| states.each_ref().map(|state| state[at]);
        let right = values(0);
        Some(Self {
            values: valued.into_iter().enumerate().map(|(at, symbol)| (symbol, values(at + 1))).collect(),
            right,
        })
    }

    /// Sets the values of `symbol` to the values of `formula`. Does nothing if the formula has a symbol without values.
    pub fn set_symbol_values(&mut self, arena: &Arena, symbol: Expr, formula: Expr) {
        if self.evaluate_at_points(arena, formula) {
            self.values.insert(symbol, self.values[&formula]);
        }
    }

    /// Computes and stores the values of a formula. Returns false if a symbol in it has no values.
    fn evaluate_at_points(&mut self, arena: &Arena, e: Expr) -> bool {
        for part in arena.reachable_until(&[e], |e| self.values.contains_key(&e)) {
            let Some(value) = self.value(arena, part) else { return false };
            self.values.insert(part, value);
        }
        true
    }

    /// Values of a formula, one for each state; `None` if a symbol in it has no values.
    pub fn values(&mut self, arena: &Arena, formula: Expr) -> Option<[f64; POINTS]> {
        self.evaluate_at_points(arena, formula).then(|| self.values[&formula])
    }

    /// Values of the right formula, one for each state.
    pub fn right_values(&self) -> [f64; POINTS] {
        self.right
    }

    /// True if a changed formula has the values of the right formula at all states, up to rounding errors.
    pub fn agrees_with_right_values(&mut self, arena: &Arena, changed: Expr) -> bool {
        let Some(values) = self.values(arena, changed) else { return false };
        values.iter().zip(&self.right).all(|(value, right)| (value - right).abs() <= SMALL * right.abs().max(1e-3))
    }

    /// Values of a term, from the stored values of its operands; `None` for a symbol without
    /// values.
    fn value(&self, arena: &Arena, e: Expr) -> Option<[f64; POINTS]> {
        let of = |e: &Expr, at: usize| self.values.get(e).map(|values| values[at]);
        let mut out = [0.0; POINTS];
        for (at, place) in out.iter_mut().enumerate() {
            *place = match arena.node(e) {
                Node::Number(value) => value.to_f64(),
                Node::Pi => std::f64::consts::PI,
                Node::Symbol(_) => return None,
                Node::Sum(constant, terms) => {
                    let mut sum = constant.to_f64();
                    for (term, k) in terms {
                        sum += k.to_f64() * of(term, at)?;
                    }
                    sum
                }
                Node::Product(factors) => {
                    let mut product = 1.0;
                    for (base, n) in factors {
                        product *= of(base, at)?.powi(*n);
                    }
                    product
                }
                Node::Apply(f, argument) => function_value(*f, of(argument, at)?),
                Node::Named(_, term) => of(term, at)?,
            };
        }
        Some(out)
    }
}

/// Value of an elementary function f(x), in double precision.
fn function_value(f: Function, x: f64) -> f64 {
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
        Function::Sign if x == 0.0 => 0.0,
        Function::Sign => x.signum(),
    }
}
