//! Ranges of the values that a term can take. They are often enough to prove that a determinant is
//! never zero.
//!
//! The ranges are proved, but they may be too wide: each operand counts as if it varied on its own.
//! So "never zero" is a proof for all real values of the symbols, and for all positive values of
//! positive symbols. Any other result proves nothing.

use crate::algebra::term::fold::{Fold, Values, fold};
use crate::algebra::{Arena, Expr, Function, Rational};

/// True if the term `e` is proved never to be zero where it has a value. False means that nothing
/// is proved.
#[must_use]
pub fn range_excludes_zero(arena: &Arena, e: Expr) -> bool {
    fold(arena, e, &mut Ranges(arena)).is_some_and(|range| range.nonzero)
}

/// True if the term `e` is proved never to be above zero. False means that nothing is proved.
#[must_use]
pub fn range_excludes_positive(arena: &Arena, e: Expr) -> bool {
    fold(arena, e, &mut Ranges(arena)).is_some_and(|range| range.neg().is_nonnegative())
}

/// Rules that give the range of each term; the arena says which symbols are positive.
struct Ranges<'a>(&'a Arena);

impl Fold for Ranges<'_> {
    type Value = Range;
    fn number(&mut self, value: &Rational) -> Option<Range> {
        Some(Range::point(value))
    }
    fn pi(&mut self) -> Option<Range> {
        Some(Range::new(Some(Rational::integer(3)), Some(Rational::integer(4))))
    }
    fn symbol(&mut self, symbol: Expr) -> Option<Range> {
        let positive = Range { low: Some(Rational::ZERO), high: None, nonzero: true };
        Some(if self.0.is_positive(symbol) { positive } else { Range::default() })
    }
    fn sum(&mut self, constant: &Rational, terms: &[(Expr, Rational)], of: &Values<'_, Range>) -> Option<Range> {
        let terms = terms.iter().map(|(term, k)| of[*term].scaled(k));
        Some(Range::sum(&[Range::point(constant)].into_iter().chain(terms).collect::<Vec<_>>()))
    }
    fn product(&mut self, factors: &[(Expr, i32)], of: &Values<'_, Range>) -> Option<Range> {
        let times = |product: Range, (base, n): &(Expr, i32)| product.times(&of[*base].pow(*n));
        Some(factors.iter().fold(Range::point(&Rational::ONE), times))
    }
    fn apply(&mut self, f: Function, argument: Expr, of: &Values<'_, Range>) -> Option<Range> {
        Some(of_function(f, &of[argument]))
    }
}

/// Range of the values of a term, from `low` to `high`. A bound is `None` if it is not known.
#[derive(Clone, Debug, Default)]
struct Range {
    /// Lower bound of the values; `None` if no lower bound is known.
    low: Option<Rational>,
    /// Upper bound of the values; `None` if no upper bound is known.
    high: Option<Rational>,
    /// True if the value is proved never to be 0.
    nonzero: bool,
}

impl Range {
    /// Creates a range between bounds. It counts as non-zero if both bounds are on one side of 0.
    fn new(low: Option<Rational>, high: Option<Rational>) -> Self {
        let above = low.as_ref().is_some_and(|low| *low > Rational::ZERO);
        let below = high.as_ref().is_some_and(Rational::is_negative);
        Self { low, high, nonzero: above || below }
    }

    /// Creates the range of a single number.
    fn point(value: &Rational) -> Self {
        Self::new(Some(value.clone()), Some(value.clone()))
    }

    /// Same range, marked as never 0.
    fn without_zero(self) -> Self {
        Self { nonzero: true, ..self }
    }

    /// Same range, marked as never 0 if the range `other` is never 0.
    fn without_zero_if(self, other: &Self) -> Self {
        if other.nonzero { self.without_zero() } else { self }
    }

    /// True if the lower bound is known and not below 0.
    fn is_nonnegative(&self) -> bool {
        self.low.as_ref().is_some_and(|low| !low.is_negative())
    }

    /// Range of −x, for x in the range.
    fn neg(&self) -> Self {
        Self { low: self.high.as_ref().map(Rational::neg), high: self.low.as_ref().map(Rational::neg), ..*self }
    }

    /// Range of k · x, for x in the range.
    fn scaled(&self, k: &Rational) -> Self {
        self.times(&Self::point(k))
    }

    /// Range of a sum of independent values with the given ranges.
    fn sum(parts: &[Self]) -> Self {
        let total = |bound: fn(&Self) -> &Option<Rational>| {
            parts.iter().try_fold(Rational::ZERO, |sum, part| Some(sum.add(bound(part).as_ref()?)))
        };
        // Parts of one sign cannot cancel: if one of them is never 0, the sum is never 0.
        let one_sign = |parts: &[Self]| parts.iter().all(Self::is_nonnegative) && parts.iter().any(|part| part.nonzero);
        let opposite: Vec<Self> = parts.iter().map(Self::neg).collect();
        let sum = Self::new(total(|part| &part.low), total(|part| &part.high));
        if one_sign(parts) || one_sign(&opposite) { sum.without_zero() } else { sum }
    }

    /// Range of a product of two independent values with the given ranges.
    fn times(&self, other: &Self) -> Self {
        let bounds = match (&self.low, &self.high, &other.low, &other.high) {
            (Some(a), Some(b), Some(c), Some(d)) => {
                let mut corners = [a.mul(c), a.mul(d), b.mul(c), b.mul(d)];
                corners.sort();
                Self::new(Some(corners[0].clone()), Some(corners[3].clone()))
            }
            (Some(a), _, Some(c), _) if self.is_nonnegative() && other.is_nonnegative() => {
                Self::new(Some(a.mul(c)), None)
            }
            _ if self.neg().is_nonnegative() && other.is_nonnegative() => return self.neg().times(other).neg(),
            _ if self.is_nonnegative() && other.neg().is_nonnegative() => return self.times(&other.neg()).neg(),
            _ if self.neg().is_nonnegative() && other.neg().is_nonnegative() => return self.neg().times(&other.neg()),
            _ => Self::default(),
        };
        if self.nonzero && other.nonzero { bounds.without_zero() } else { bounds }
    }

    /// Range of xⁿ, for x in the range.
    fn pow(&self, n: i32) -> Self {
        if n < 0 {
            return self.pow(-n).reciprocal();
        }
        let to = |bound: &Option<Rational>| bound.as_ref().and_then(|bound| bound.pow(n));
        if n % 2 == 1 {
            return Self::new(to(&self.low), to(&self.high)).without_zero_if(self);
        }
        if self.neg().is_nonnegative() {
            return self.neg().pow(n);
        }
        if self.is_nonnegative() {
            return Self::new(to(&self.low), to(&self.high)).without_zero_if(self);
        }
        let high = to(&self.low).zip(to(&self.high)).map(|(a, b)| a.max(b));
        Self::new(Some(Rational::ZERO), high).without_zero_if(self)
    }

    /// Range of 1/x, for all x ≠ 0 in the range. It is marked as never 0.
    fn reciprocal(&self) -> Self {
        if self.neg().is_nonnegative() {
            return self.neg().reciprocal().neg();
        }
        if !self.is_nonnegative() {
            return Self { nonzero: true, ..Self::default() };
        }
        let low = self.high.as_ref().and_then(Rational::reciprocal).unwrap_or(Rational::ZERO);
        Self::new(Some(low), self.low.as_ref().and_then(Rational::reciprocal)).without_zero()
    }
}

/// Range of the function value f(x), for x in the range `argument`.
fn of_function(f: Function, argument: &Range) -> Range {
    let bounds = |low: i64, high: Option<i64>| Range::new(Some(Rational::integer(low)), high.map(Rational::integer));
    match f {
        Function::Sin | Function::Cos => bounds(-1, Some(1)),
        Function::Sqrt | Function::Abs => bounds(0, None).without_zero_if(argument),
        Function::Exp => bounds(0, None).without_zero(),
        Function::Cosh => bounds(1, None),
        Function::Tanh | Function::Sign => bounds(-1, Some(1)).without_zero_if(argument),
        Function::Asin | Function::Atan | Function::Sinh => Range::default().without_zero_if(argument),
        Function::Log | Function::Acos => Range::default(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::text::parse::parse_free;

    /// True if the term is proved never to be zero. `M`, `R` and `m` are positive; all other
    /// symbols are any real numbers.
    fn proved(text: &str) -> bool {
        let mut arena = Arena::new();
        for name in ["M", "R", "m"] {
            let symbol = arena.symbol(name);
            arena.assume_positive(symbol);
        }
        let e = parse_free(&mut arena, text).unwrap();
        range_excludes_zero(&arena, e)
    }

    #[test]
    fn what_cannot_vanish_is_recognized() {
        for text in [
            "R^2*(4*cos(q)^2 - 5)",
            "M^3*R^2*(1 + 4*sin(q)^2)",
            "M + m*sin(q)^2",
            "-M - m*x^2",
            "1/x",
            "-3/(M*cos(q)^2)",
            "exp(x) + abs(y)",
            "(sin(x) - 2)*(pi - 2)",
            "sqrt(M + m)",
            "(cos(q) - 3)^3/R",
        ] {
            assert!(proved(text), "{text}");
        }
    }

    #[test]
    fn what_can_vanish_is_never_claimed() {
        for text in [
            "0",
            "cos(q)",
            "R*cos(q)^2",
            "1 + sin(q)",
            "M - R",
            "x^2",
            "x*M",
            "x + M",
            "log(M)",
            "sin(q)^2 + cos(q) + 1",
        ] {
            assert!(!proved(text), "{text}");
        }
    }
}
