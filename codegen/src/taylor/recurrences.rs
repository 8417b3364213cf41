//! Recurrences as data: which series there are, and how the coefficient of order k of each follows.

use tripos_derive::algebra::{Expr, Function};

/// Weights with which constants in time enter: terms of parameters and of states that do not change.
pub type Constant = Expr;

/// Recurrence for the coefficients of a series z from those of others; x, y, w are places in [`Recurrences::series`],
/// and z_k is the coefficient of order k.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Rule {
    /// The state at this place: z_k is the coefficient k − 1 of its rate, over k.
    State(usize),
    /// constant + Σ weight · x.
    Linear {
        /// Constant that is added at order 0.
        constant: Constant,
        /// (weight, x)
        terms: Vec<(Constant, usize)>,
    },
    /// Product of two series: z = x y.
    Product(usize, usize),
    /// z = x/y, or 1/y without an x.
    Quotient(Option<usize>, usize),
    /// Square root of a series: z² = x.
    Root(usize),
    /// z' = ±x' w, as for sin x with w = cos x.
    Forward {
        /// The function whose value z has at order 0.
        value: Function,
        /// Place of x.
        of: usize,
        /// w, of which only lower orders are used; it may come later in the list.
        slope: usize,
        /// True for the minus sign.
        negative: bool,
    },
    /// z' w = ±x', as for log x with w = x.
    Backward {
        /// The function whose value z has at order 0.
        value: Function,
        /// Place of x.
        of: usize,
        /// Place of w.
        slope: usize,
        /// True for the minus sign.
        negative: bool,
    },
}

impl Rule {
    /// True if a convolution over lower orders is needed.
    #[must_use]
    pub fn convolves(&self) -> bool {
        !matches!(self, Self::State(_) | Self::Linear { .. })
    }

    /// The series whose coefficient of the same order is needed.
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

    /// Renames places.
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

/// A series: what it stands for, and its rule.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Series {
    /// The term whose coefficients it has, as formed from other series.
    pub term: Expr,
    /// Recurrence for its coefficients.
    pub rule: Rule,
    /// The state or the step whose value first needs it.
    pub needed_by: Expr,
}

/// The rate of a state: a constant in time, or a weight and a series.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Operand {
    /// A constant in time.
    Constant(Constant),
    /// weight · series
    Scaled(Constant, usize),
}

/// The recurrences of the Taylor coefficients of a motion.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Recurrences {
    /// The states first, those that are constant in time left out; then each after what it reads, other than slopes of
    /// [`Rule::Forward`].
    pub series: Vec<Series>,
    /// The symbols of all states.
    pub states: Vec<Expr>,
    /// The rate of each.
    pub rates: Vec<Operand>,
}

impl Recurrences {
    /// Number of convolutions of an order.
    #[must_use]
    pub fn convolutions(&self) -> usize {
        self.series.iter().filter(|s| s.rule.convolves()).count()
    }

    /// Products and sums of the linear rules, at each order.
    #[must_use]
    pub fn linear_operations(&self) -> usize {
        let of = |rule: &Rule| match rule {
            Rule::Linear { terms, .. } => 2 * terms.len(),
            _ => 0,
        };
        self.series.iter().map(|s| of(&s.rule)).sum()
    }

    /// All weights and constants, each once, in order of appearance; 0, 1 and −1 left out.
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
