//! Values of terms and their derivatives along a direction, modulo a random prime, as dual numbers.
//!
//! The derivative of a term is computed by the rules of differentiation, from residues alone. It
//! shares no code with [`crate::algebra::term::calculus`], which builds terms, so that it can check
//! the derivatives built there.

use super::field::Field;
use super::residues::{PointSearch, Residues};
use crate::algebra::term::fold::{Fold, Values};
use crate::algebra::{Arena, Expr, Function, Rational};
use rustc_hash::FxHashMap;

/// Largest number of random points that are tried until all terms have residues.
const MOST_DRAWN: usize = 8;

/// Dual number a + b ε with ε² = 0, modulo a prime. It holds the value a of a term and its
/// derivative b along a direction.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct TangentValue {
    /// Value a of the dual number a + b ε, a residue.
    pub value: u64,
    /// Derivative b of the dual number a + b ε along the direction, a residue.
    pub slope: u64,
}

impl TangentValue {
    /// True if both the value and the derivative are zero.
    #[must_use]
    pub fn is_zero(self) -> bool {
        self == Self::default()
    }

    /// Dual number self − factor · other, in the field `f`.
    #[must_use]
    pub fn minus_product(self, f: Field, factor: Self, other: Self) -> Self {
        let across = f.add(f.mul(factor.value, other.slope), f.mul(factor.slope, other.value));
        Self { value: f.sub(self.value, f.mul(factor.value, other.value)), slope: f.sub(self.slope, across) }
    }

    /// Quotient self/other of dual numbers in the field `f`; `None` if the value of `other` is
    /// zero.
    #[must_use]
    pub fn quotient(self, f: Field, other: Self) -> Option<Self> {
        let inverse = f.inverse(other.value)?;
        let value = f.mul(self.value, inverse);
        // (a/b)' = (a' − (a/b) b')/b.
        let slope = f.mul(f.sub(self.slope, f.mul(value, other.slope)), inverse);
        Some(Self { value, slope })
    }
}

/// Values and directional derivatives of terms at random points. Each point has another prime and
/// another random direction.
pub struct Tangents<'a> {
    /// Arena of the terms.
    arena: &'a Arena,
    /// Terms whose values and derivatives are computed.
    terms: &'a [Expr],
    /// Direction of the derivatives: for each symbol that varies, the symbol whose residue is its
    /// rate.
    along: FxHashMap<Expr, Expr>,
    /// Search for random points at which all terms have residues.
    draw: PointSearch<'a>,
}

impl<'a> Tangents<'a> {
    /// Prepares the terms for evaluation. `along` is the direction of the derivatives: pairs
    /// (symbol that varies, symbol whose residue is its rate).
    #[must_use]
    pub fn new(arena: &'a Arena, terms: &'a [Expr], along: &[(Expr, Expr)]) -> Self {
        let all: Vec<Expr> = terms.iter().chain(along.iter().flat_map(|(x, d)| [x, d])).copied().collect();
        Self { arena, terms, along: along.iter().copied().collect(), draw: PointSearch::with_slopes(arena, &all) }
    }

    /// Draws the next random point at which every term has a value and a derivative. Returns the
    /// prime field of the point and a dual number for each term, in their order. `None` if no point
    /// was found in eight attempts.
    pub fn next(&mut self) -> Option<(Field, Vec<TangentValue>)> {
        (0..MOST_DRAWN).find_map(|_| {
            let point = self.draw.point()?;
            let mut residues = self.draw.residues(point);
            let field = residues.field();
            let values = self.draw.needed().fold(self.arena, &mut residues)?;
            let mut rules = Slopes { field, values: &values, residues: &residues, along: &self.along };
            let slopes = self.draw.needed().fold(self.arena, &mut rules)?;
            Some((field, self.terms.iter().map(|e| TangentValue { value: values[*e], slope: slopes[*e] }).collect()))
        })
    }
}

/// Rules that compute the derivatives of terms along a direction, from the residues of the terms.
struct Slopes<'a> {
    /// Prime field of the point.
    field: Field,
    /// Residue of each term at the point.
    values: &'a Values<'a, u64>,
    /// Rules by which the residues of the terms were computed.
    residues: &'a Residues<'a>,
    /// Direction of the derivatives: for each symbol that varies, the symbol whose residue is its
    /// rate.
    along: &'a FxHashMap<Expr, Expr>,
}

impl Fold for Slopes<'_> {
    type Value = u64;
    fn number(&mut self, _: &Rational) -> Option<u64> {
        Some(0)
    }
    fn pi(&mut self) -> Option<u64> {
        Some(0)
    }
    fn symbol(&mut self, symbol: Expr) -> Option<u64> {
        Some(self.along.get(&symbol).map_or(0, |direction| self.values[*direction]))
    }
    fn sum(&mut self, _: &Rational, terms: &[(Expr, Rational)], of: &Values<'_, u64>) -> Option<u64> {
        let f = self.field;
        let add = |sum, (term, k): &(Expr, Rational)| match of[*term] {
            0 => Some(sum),
            slope => Some(f.add(sum, f.mul(f.residue_of_rational(k)?, slope))),
        };
        terms.iter().try_fold(0, add)
    }
    fn product(&mut self, factors: &[(Expr, i32)], of: &Values<'_, u64>) -> Option<u64> {
        let f = self.field;
        // The derivative of Π b^n is the sum of n b^(n−1) db times the product of the other
        // factors.
        let mut sum = 0;
        for (at, (base, n)) in factors.iter().enumerate().filter(|(_, (base, _))| of[*base] != 0) {
            let times = f.residue_of_rational(&Rational::integer(i64::from(*n)))?;
            let own = f.mul(f.mul(times, f.signed_power(self.values[*base], n - 1)?), of[*base]);
            let others = factors.iter().enumerate().filter(|(other, _)| *other != at);
            let share = others
                .map(|(_, factor)| factor)
                .try_fold(own, |product, (base, n)| Some(f.mul(product, f.signed_power(self.values[*base], *n)?)))?;
            sum = f.add(sum, share);
        }
        Some(sum)
    }
    fn apply(&mut self, function: Function, argument: Expr, of: &Values<'_, u64>) -> Option<u64> {
        match of[argument] {
            0 => Some(0),
            slope => Some(self.field.mul(self.derivative(function, argument)?, slope)),
        }
    }
}

impl Slopes<'_> {
    /// Residue of the derivative f′(x) of a function at its argument x. `None` if the derivative
    /// has no residue at this point.
    fn derivative(&self, function: Function, argument: Expr) -> Option<u64> {
        let (f, x) = (self.field, self.values[argument]);
        let other = |function| self.residues.exponential(function, argument, self.values);
        let square = f.mul(x, x);
        match function {
            Function::Sin => Some(self.residues.known_sine_and_cosine(argument)?.1),
            Function::Cos => Some(f.sub(0, self.residues.known_sine_and_cosine(argument)?.0)),
            Function::Sqrt => f.inverse(f.mul(2, f.root(x)?)),
            Function::Exp => other(Function::Exp),
            Function::Log => f.inverse(x),
            Function::Asin => f.inverse(f.root(f.sub(1, square))?),
            Function::Acos => f.inverse(f.sub(0, f.root(f.sub(1, square))?)),
            Function::Atan => f.inverse(f.add(1, square)),
            Function::Sinh => other(Function::Cosh),
            Function::Cosh => other(Function::Sinh),
            Function::Tanh => Some(f.sub(1, f.pow(other(Function::Tanh)?, 2))),
            Function::Abs => Some(f.mul(f.root(square)?, f.inverse(x)?)),
            Function::Sign => Some(0),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::term::calculus::Differential;
    use crate::algebra::text::parse::parse_free;
    use crate::algebra::value::field::Generator;

    /// The derivatives modulo a prime are the residues of the derivatives that `calculus` builds.
    #[test]
    fn slopes_are_those_of_derivatives() {
        for text in [
            "a^3*b/(a + 2*b)",
            "sin(a + 2*b)*cos(a/2)",
            "sqrt(a^2 + b)",
            "a*exp(b)",
            "log(a*b)",
            "atan(a)*b",
            "asin(a/3)",
            "acos(a/3)",
            "abs(a)*b",
            "tanh(a)^2",
            "tan(a)/b^2",
        ] {
            let mut arena = Arena::new();
            let e = parse_free(&mut arena, text).unwrap();
            let symbols: Vec<Expr> = ["a", "b"].map(|name| arena.symbol(name)).to_vec();
            let along: Vec<(Expr, Expr)> =
                symbols.into_iter().zip(["da", "db"]).map(|(x, name)| (x, arena.symbol(name))).collect();
            let derivative = Differential::along(&along).apply(&mut arena, e);
            let terms = [e, derivative];
            let (_, duals) = Tangents::new(&arena, &terms, &along).next().unwrap();
            assert_eq!(duals[0].slope, duals[1].value, "{text}");
        }
    }

    #[test]
    fn quotients_undo_products() {
        let f = Field::random(&mut Generator(3));
        let (a, b) = (TangentValue { value: 5, slope: 7 }, TangentValue { value: 11, slope: 13 });
        let quotient = a.quotient(f, b).unwrap();
        assert!(a.minus_product(f, quotient, b).is_zero());
        assert_eq!(a.quotient(f, TangentValue { value: 0, slope: 1 }), None);
    }
}
