//! Recurrences as data: the series, and the rule for the coefficient of order k of each series.

use tripos_derive::algebra::{Expr, Function};

/// Weight or constant of a recurrence: a term of parameters and of states that do not change.
pub type Constant = Expr;

/// Recurrence for the coefficients of a series z from those of other series. The indices x, y and w refer to
/// [`Recurrences::series`], and z_k is the coefficient of order k.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Rule {
    /// State with this index: z_k is the coefficient k − 1 of its rate, divided by k.
    State(usize),
    /// Linear combination of series: z = constant + Σ weight · x.
    Linear {
        /// Constant that is added at order 0.
        constant: Constant,
        /// Terms of the sum, as (weight, x).
        terms: Vec<(Constant, usize)>,
    },
    /// Product of two series: z = x y.
    Product(usize, usize),
    /// Quotient of two series: z = x/y, or z = 1/y without x.
    Quotient(Option<usize>, usize),
    /// Square root of a series: z² = x.
    Root(usize),
    /// Function value with z' = ±x' w, such as sin x with w = cos x.
    Forward {
        /// Function whose value z has at order 0.
        value: Function,
        /// Index of the argument x.
        of: usize,
        /// Index of the slope w. Only its lower orders are used, so it may come later in the list.
        slope: usize,
        /// True for the minus sign in the rule.
        negative: bool,
    },
    /// Function value with z' w = ±x', such as log x with w = x.
    Backward {
        /// Function whose value z has at order 0.
        value: Function,
        /// Index of the argument x.
        of: usize,
        /// Index of the slope's inverse w.
        slope: usize,
        /// True for the minus sign in the rule.
        negative: bool,
    },
}

impl Rule {
    /// True if the rule needs a convolution over lower orders.
    #[must_use]
    pub fn convolves(&self) -> bool {
        !matches!(self, Self::State(_) | Self::Linear { .. })
    }

    /// Indices of the series whose coefficient of equal order the rule needs.
    #[must_use]
    pub fn reads(&self) -> Vec<usize> {
        match self {
            Self::State(_) => Vec::new(),
            Self::Linear { terms, .. } => terms.iter().map(|(_, x)| *x).collect(),
            Self::Product(x, y) => vec![*x, *y],
            Self::Quotient(x, y) => x.iter().copied().chain([*y]).collect(),
            Self::Root(x) | Self::Forward { of: x, .. } => vec![*x],
            Self::Backward { of, slope, .. } => vec![*of, *slope],
        }
    }

    /// Renumbers the series that the rule reads.
    pub(super) fn renamed(&mut self, place: impl Fn(usize) -> usize) {
        let rename = |x: &mut usize| *x = place(*x);
        match self {
            Self::State(_) => {}
            Self::Linear { terms, .. } => terms.iter_mut().for_each(|(_, x)| rename(x)),
            Self::Product(x, y) => [x, y].into_iter().for_each(rename),
            Self::Quotient(x, y) => x.iter_mut().chain([y]).for_each(rename),
            Self::Root(x) => rename(x),
            Self::Forward { of, slope, .. } | Self::Backward { of, slope, .. } => {
                [of, slope].into_iter().for_each(rename);
            }
        }
    }
}

/// Series of Taylor coefficients of a term, with its recurrence.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Series {
    /// Term whose coefficients the series has, as formed from other series.
    pub term: Expr,
    /// Recurrence for the coefficients.
    pub rule: Rule,
    /// State or step whose value first needs the series.
    pub needed_by: Expr,
}

/// Term that is constant in time, or a weight times a series.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Operand {
    /// Constant in time.
    Constant(Constant),
    /// Weight times the series with this index.
    Scaled(Constant, usize),
}

/// Recurrences of the Taylor coefficients of a motion.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Recurrences {
    /// Series of the motion. States that change in time come first. Each later series comes after those that it reads,
    /// except for the slopes of [`Rule::Forward`].
    pub series: Vec<Series>,
    /// Symbols of all states.
    pub states: Vec<Expr>,
    /// Rates of the states, in the order of `states`.
    pub rates: Vec<Operand>,
}

impl Recurrences {
    /// Number of convolutions at each order.
    #[must_use]
    pub fn convolutions(&self) -> usize {
        self.series.iter().filter(|s| s.rule.convolves()).count()
    }

    /// Number of products and sums of the linear rules, at each order.
    #[must_use]
    pub fn linear_operations(&self) -> usize {
        let of = |rule: &Rule| match rule {
            Rule::Linear { terms, .. } => 2 * terms.len(),
            _ => 0,
        };
        self.series.iter().map(|s| of(&s.rule)).sum()
    }

    /// Distinct weights and constants, in order of appearance, without 0, 1 and −1.
    #[must_use]
    pub fn constants(&self) -> Vec<Constant> {
        let mut list: Vec<Constant> = Vec::new();
        let mut note = |e: Constant| {
            if ![Expr::ZERO, Expr::ONE, Expr::MINUS_ONE].contains(&e) && !list.contains(&e) {
                list.push(e);
            }
        };
        for series in &self.series {
            if let Rule::Linear { constant, terms } = &series.rule {
                note(*constant);
                for (weight, _) in terms {
                    note(*weight);
                }
            }
        }
        for rate in &self.rates {
            let (Operand::Constant(e) | Operand::Scaled(e, _)) = rate;
            note(*e);
        }
        list
    }
}
