//! Recurrences of Taylor coefficients as data: a list of series, each with the rule that gives its coefficient of
//! order k.

use tripos_derive::algebra::{Expr, Function};

/// Constant factor or summand of a recurrence: a term of parameters and of states that do not
/// change in time.
pub type Constant = Expr;

/// Rule for the coefficients of a series z, from the coefficients of other series. The indices x, y and w refer to
/// [`Recurrences::series`], and z_k is the coefficient of order k.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Rule {
    /// State with this index: z_k is the coefficient of order k − 1 of the state's rate, divided by
    /// k.
    State(usize),
    /// Linear combination of series, z = constant + Σ weight · x.
    Linear {
        /// Constant summand of the linear combination. It only adds to the coefficient of order 0.
        constant: Constant,
        /// Terms of the sum, as pairs (weight, index of the series x).
        terms: Vec<(Constant, usize)>,
    },
    /// Product of two series, given by their indices: z = x y.
    Product(usize, usize),
    /// Quotient of two series, given by their indices: z = x/y. If x is `None`, it is z = 1/y.
    Quotient(Option<usize>, usize),
    /// Square root of the series with this index: z² = x.
    Root(usize),
    /// Function value with z' = ±x' w, such as z = sin x with w = cos x.
    Forward {
        /// Elementary function whose Taylor series is z.
        value: Function,
        /// Index of the series x of the function's argument.
        of: usize,
        /// Index of the series w, the derivative of the function. The rule reads only its lower orders, so it may
        /// come later in the list.
        slope: usize,
        /// True if the rule has the minus sign, z' = −x' w.
        negative: bool,
    },
    /// Function value with z' w = ±x', such as z = log x with w = x.
    Backward {
        /// Elementary function whose Taylor series is z.
        value: Function,
        /// Index of the series x of the function's argument.
        of: usize,
        /// Index of the series w, the reciprocal of the function's derivative.
        slope: usize,
        /// True if the rule has the minus sign, z' w = −x'.
        negative: bool,
    },
}

impl Rule {
    /// True if the rule needs a convolution: a sum over products of lower-order coefficients. Rules for states and
    /// linear combinations need none.
    #[must_use]
    pub fn convolves(&self) -> bool {
        !matches!(self, Self::State(_) | Self::Linear { .. })
    }

    /// Returns the indices of the series whose coefficient of order k must be known before z_k.
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

    /// Renumbers the series to which the rule refers. `place` maps an old index to a new index.
    pub(super) fn renumber_series(&mut self, place: impl Fn(usize) -> usize) {
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

/// Taylor series of a term in time, with the recurrence for its coefficients.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Series {
    /// Term whose Taylor coefficients in time are computed.
    pub term: Expr,
    /// Recurrence that gives the coefficients.
    pub rule: Rule,
    /// State or step for whose value the series is first needed.
    pub needed_by: Expr,
}

/// Value in a recurrence: a term that is constant in time, or a constant factor times a series.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Operand {
    /// Value that is constant in time, as a term.
    Constant(Constant),
    /// Constant factor times the series with this index.
    Scaled(Constant, usize),
}

/// Recurrences of the Taylor coefficients of a motion in time.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Recurrences {
    /// All series. States that change in time come first. Each later series comes after the series that its rule
    /// reads, except for the derivatives in [`Rule::Forward`].
    pub series: Vec<Series>,
    /// Symbols of all states, coordinates before motion variables.
    pub states: Vec<Expr>,
    /// Time derivatives of the states, in the order of `states`.
    pub rates: Vec<Operand>,
}

impl Recurrences {
    /// Returns the number of convolutions at each order.
    #[must_use]
    pub fn convolutions(&self) -> usize {
        self.series.iter().filter(|s| s.rule.convolves()).count()
    }

    /// Returns the number of multiplications and additions of the linear rules at each order.
    #[must_use]
    pub fn linear_operations(&self) -> usize {
        let of = |rule: &Rule| match rule {
            Rule::Linear { terms, .. } => 2 * terms.len(),
            _ => 0,
        };
        self.series.iter().map(|s| of(&s.rule)).sum()
    }

    /// Returns the distinct constant factors and summands of the recurrences in order of appearance, without 0, 1 and
    /// −1.
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
