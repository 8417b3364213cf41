//! Tape that interprets Taylor recurrences in numbers of any precision, for models that are not
//! compiled.

use super::recurrences::{Constant, Operand, Recurrences, Rule};
use rustc_hash::FxHashMap;
use tripos_derive::algebra::value::tape::{Numeric, Tape as Values, UnknownSymbol};
use tripos_derive::algebra::{Arena, Expr};

/// Taylor recurrences with their constants, ready for evaluation in numbers of the type `S`.
#[derive(Clone, Debug)]
pub struct Tape<S = f64> {
    /// Taylor recurrences that the tape evaluates.
    list: Recurrences,
    /// Program that computes the constant factors and summands from parameters and states.
    constants: Values<S>,
    /// Index of each constant in the values that [`Self::constants`] computes.
    places: FxHashMap<Constant, usize>,
}

impl Tape {
    /// Prepares recurrences for evaluation. Their inputs are the given parameters and the states.
    ///
    /// # Errors
    /// Returns [`UnknownSymbol`] if a constant depends on another symbol.
    pub fn new(arena: &Arena, parameters: &[Expr], list: &Recurrences) -> Result<Self, UnknownSymbol> {
        let constants = [vec![Expr::ZERO, Expr::ONE, Expr::MINUS_ONE], list.constants()].concat();
        let inputs = [parameters, &list.states].concat();
        let places = constants.iter().enumerate().map(|(at, e)| (*e, at)).collect();
        Ok(Self { list: list.clone(), constants: Values::new(arena, &inputs, &constants)?, places })
    }
}

impl<S> Tape<S> {
    /// Returns the Taylor recurrences that the tape evaluates.
    #[must_use]
    pub fn recurrences(&self) -> &Recurrences {
        &self.list
    }
}

impl<S: Numeric> Tape<S> {
    /// Returns the tape for another type of number `T`.
    #[must_use]
    pub fn to<T: Numeric>(&self) -> Tape<T> {
        Tape { list: self.list.clone(), constants: self.constants.to(), places: self.places.clone() }
    }

    /// Computes the Taylor coefficients of the states for the parameters `p`, from order 0 to `order`.
    ///
    /// `x` has (`order` + 1) rows, one for each order, and a column for each state. The first row holds the state at
    /// the start. The other rows are computed.
    ///
    /// # Panics
    /// Panics if the length of `x` is not (`order` + 1) times the number of states.
    pub fn evaluate(&self, p: &[S], order: usize, x: &mut [S]) {
        let n = self.list.states.len();
        assert_eq!(x.len(), (order + 1) * n, "a row for each order");
        let constants = self.constants.evaluate(&[p, &x[..n]].concat());
        let weight = |e: Constant| constants[self.places[&e]];
        // The list `z` has a row for each order and a column for each series.
        let columns = self.list.series.len();
        let mut z = vec![S::int(0); (order + 1) * columns];
        for k in 0..=order {
            for (at, series) in self.list.series.iter().enumerate() {
                let known = TapeCoefficients { z: &z, columns, k };
                z[k * columns + at] = match &series.rule {
                    Rule::State(place) if k == 0 => x[*place],
                    Rule::State(place) => match self.list.rates[*place] {
                        Operand::Constant(e) if k == 1 => weight(e),
                        Operand::Constant(_) => S::int(0),
                        Operand::Scaled(e, from) => weight(e) * known.of(k - 1, from) / whole_number(k),
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
            (1..=order).for_each(|k| x[k * n + place] = S::int(0));
        }
    }
}

/// Returns a whole number as a number of the type `S`.
fn whole_number<S: Numeric>(n: usize) -> S {
    S::from_f64(n as f64)
}

/// Coefficients of all series computed so far, while the coefficients of order `k` are computed.
struct TapeCoefficients<'a, S> {
    /// Coefficients, row by row: a row for each order, a column for each series.
    z: &'a [S],
    /// Number of series: the number of columns in `z`.
    columns: usize,
    /// Order k of the Taylor coefficients that are being computed.
    k: usize,
}

impl<S: Numeric> TapeCoefficients<'_, S> {
    /// Returns the coefficient of order `j` of the series with index `series`.
    fn of(&self, j: usize, series: usize) -> S {
        self.z[j * self.columns + series]
    }

    /// Returns the convolution Σ a_j b_{k−j} over `from` ≤ j < `to`. Here k is the order that is being computed, and
    /// `a` and `b` are the indices of the two series.
    fn convolution(&self, a: usize, b: usize, from: usize, to: usize) -> S {
        S::sum_of_products((from..to).map(|j| (self.of(j, a), self.of(self.k - j, b))))
    }

    /// Returns the convolution Σ j a_j b_{k−j} over `from` ≤ j < `to`. Here k is the order that is being computed,
    /// and `a` and `b` are the indices of the two series.
    fn counted_convolution(&self, a: usize, b: usize, from: usize, to: usize) -> S {
        S::sum_of_products((from..to).map(|j| (whole_number::<S>(j) * self.of(j, a), self.of(self.k - j, b))))
    }

    /// Computes the coefficient of order k of the series with the index `at` by its rule.
    fn coefficient(&self, rule: &Rule, at: usize, weight: impl Fn(Constant) -> S) -> S {
        let k = self.k;
        let now = |x: usize| self.of(k, x);
        let first = |x: usize| self.of(0, x);
        match rule {
            Rule::State(_) => unreachable!("states follow from their rates"),
            Rule::Linear { constant, terms } => {
                let start = if k == 0 { weight(*constant) } else { S::int(0) };
                terms.iter().fold(start, |sum, (w, x)| sum + weight(*w) * now(*x))
            }
            Rule::Product(x, y) => self.convolution(*x, *y, 0, k + 1),
            Rule::Quotient(x, y) => {
                let above = x.map_or(S::int(i64::from(k == 0)), now);
                // It follows from y z = x, without the term of z_k.
                (above - self.convolution(*y, at, 1, k + 1)) / first(*y)
            }
            Rule::Root(x) if k == 0 => first(*x).sqrt(),
            Rule::Root(x) => (now(*x) - self.convolution(at, at, 1, k)) / (S::int(2) * first(at)),
            Rule::Forward { value, of, .. } | Rule::Backward { value, of, .. } if k == 0 => first(*of).apply(*value),
            Rule::Forward { of, slope, negative, .. } => {
                let sum = self.counted_convolution(*of, *slope, 1, k + 1) / whole_number(k);
                if *negative { -sum } else { sum }
            }
            Rule::Backward { of, slope, negative, .. } => {
                let above = if *negative { -now(*of) } else { now(*of) };
                (above - self.counted_convolution(at, *slope, 1, k) / whole_number(k)) / first(*slope)
            }
        }
    }
}
