//! The recurrences interpreted: for models that are not compiled in.

use super::recurrences::{Constant, Operand, Recurrences, Rule};
use rustc_hash::FxHashMap;
use tripos_derive::algebra::evaluate::{Tape as Values, UnknownSymbol, value_of};
use tripos_derive::algebra::{Arena, Expr};

/// Recurrences with numbers for their weights, ready to be evaluated.
#[derive(Clone, Debug)]
pub struct Tape {
    list: Recurrences,
    /// Weights and constants as functions of parameters and states.
    constants: Values,
    places: FxHashMap<Constant, usize>,
}

impl Tape {
    /// With these parameters and the states as inputs.
    ///
    /// # Errors
    /// [`UnknownSymbol`] if a weight depends on a symbol that is neither.
    pub fn new(arena: &Arena, parameters: &[Expr], list: &Recurrences) -> Result<Self, UnknownSymbol> {
        let constants = [vec![Expr::ZERO, Expr::ONE, Expr::MINUS_ONE], list.constants()].concat();
        let inputs = [parameters, &list.states].concat();
        let places = constants.iter().enumerate().map(|(at, e)| (*e, at)).collect();
        Ok(Self { list: list.clone(), constants: Values::new(arena, &inputs, &constants)?, places })
    }

    /// Coefficients of the states at the parameters `p`, row by row up to `order`: `x` has (`order` + 1) rows, and
    /// comes with the state in the first one.
    ///
    /// # Panics
    /// If a length is another.
    pub fn evaluate(&self, p: &[f64], order: usize, x: &mut [f64]) {
        let n = self.list.states.len();
        assert_eq!(x.len(), (order + 1) * n, "a row for each order");
        let constants = self.constants.evaluate(&[p, &x[..n]].concat());
        let weight = |e: Constant| constants[self.places[&e]];
        // One row for each order, one column for each series.
        let columns = self.list.series.len();
        let mut z = vec![0.0; (order + 1) * columns];
        for k in 0..=order {
            for (at, series) in self.list.series.iter().enumerate() {
                let known = Known { z: &z, columns, k };
                z[k * columns + at] = match &series.rule {
                    Rule::State(place) if k == 0 => x[*place],
                    Rule::State(place) => match self.list.rates[*place] {
                        Operand::Constant(e) => {
                            if k == 1 {
                                weight(e)
                            } else {
                                0.0
                            }
                        }
                        Operand::Scaled(e, from) => weight(e) * known.of(k - 1, from) / k as f64,
                    },
                    rule => known.coefficient(rule, at, weight),
                };
            }
            for (at, series) in self.list.series.iter().enumerate() {
                if let Rule::State(place) = series.rule {
                    x[k * n + place] = z[k * columns + at];
                }
            }
        }
        let constant = |place: usize| !self.list.series.iter().any(|s| s.rule == Rule::State(place));
        for place in (0..n).filter(|place| constant(*place)) {
            (1..=order).for_each(|k| x[k * n + place] = 0.0);
        }
    }
}

/// The coefficients so far.
struct Known<'a> {
    z: &'a [f64],
    columns: usize,
    k: usize,
}

impl Known<'_> {
    fn of(&self, j: usize, series: usize) -> f64 {
        self.z[j * self.columns + series]
    }

    /// Σ a_j b_{k−j} over `from` ≤ j < `to`; with j a_j for a_j if `counted`.
    fn sum(&self, (a, b): (usize, usize), from: usize, to: usize, counted: bool) -> f64 {
        let factor = |j: usize| if counted { j as f64 } else { 1.0 };
        (from..to).map(|j| factor(j) * self.of(j, a) * self.of(self.k - j, b)).sum()
    }

    fn coefficient(&self, rule: &Rule, at: usize, weight: impl Fn(Constant) -> f64) -> f64 {
        let k = self.k;
        let now = |x: usize| self.of(k, x);
        let first = |x: usize| self.of(0, x);
        match rule {
            Rule::State(_) => unreachable!("states follow from their rates"),
            Rule::Linear { constant, terms } => {
                let start = if k == 0 { weight(*constant) } else { 0.0 };
                terms.iter().fold(start, |sum, (w, x)| sum + weight(*w) * now(*x))
            }
            Rule::Product(x, y) => self.sum((*x, *y), 0, k + 1, false),
            Rule::Quotient(x, y) => {
                let above = x.map_or(if k == 0 { 1.0 } else { 0.0 }, now);
                // y z = x, without the term of z_k
                (above - self.sum((*y, at), 1, k + 1, false)) / first(*y)
            }
            Rule::Root(x) if k == 0 => first(*x).sqrt(),
            Rule::Root(x) => (now(*x) - self.sum((at, at), 1, k, false)) / (2.0 * first(at)),
            Rule::Forward { value, of, .. } | Rule::Backward { value, of, .. } if k == 0 => {
                value_of(*value, first(*of))
            }
            Rule::Forward { of, slope, negative, .. } => {
                let sum = self.sum((*of, *slope), 1, k + 1, true) / k as f64;
                if *negative { -sum } else { sum }
            }
            Rule::Backward { of, slope, negative, .. } => {
                let above = if *negative { -now(*of) } else { now(*of) };
                (above - self.sum((at, *slope), 1, k, true) / k as f64) / first(*slope)
            }
        }
    }
}
