//! Intervals that hold the real value of an expression at a point: every operation is rounded outwards.
//!
//! Where the interval of a difference excludes 0, the two sides differ there, and that is a proof.

use super::{Arena, Expr, Function, Node, Rational};
use rustc_hash::FxHashMap;

/// [lo, hi], lo ≤ hi, both finite.
#[derive(Clone, Copy, Debug)]
pub struct Interval {
    lo: f64,
    hi: f64,
}

/// What a mathematical library's sine, cosine or exponential may err by, relative: a hundred units in the last place,
/// far beyond what any of them does.
const LIBRARY: f64 = 100.0 * f64::EPSILON;

impl Interval {
    /// Outwards by one unit in the last place; `None` beyond the range of a double.
    fn new(lo: f64, hi: f64) -> Option<Self> {
        let (lo, hi) = (lo.next_down(), hi.next_up());
        (lo.is_finite() && hi.is_finite() && lo <= hi).then_some(Self { lo, hi })
    }

    /// A number that a double holds.
    pub const fn point(x: f64) -> Self {
        Self { lo: x, hi: x }
    }

    /// Whether 0 is outside.
    pub fn excludes_zero(self) -> bool {
        self.lo > 0.0 || self.hi < 0.0
    }

    fn rational(value: &Rational) -> Option<Self> {
        let x = value.to_f64();
        if Rational::from_f64_exact(x).as_ref() == Some(value) { Some(Self::point(x)) } else { Self::new(x, x) }
    }

    fn add(self, other: Self) -> Option<Self> {
        Self::new(self.lo + other.lo, self.hi + other.hi)
    }

    fn mul(self, other: Self) -> Option<Self> {
        let products = [self.lo * other.lo, self.lo * other.hi, self.hi * other.lo, self.hi * other.hi];
        let lo = products.iter().copied().fold(f64::INFINITY, f64::min);
        let hi = products.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        Self::new(lo, hi)
    }

    fn power(self, n: i32) -> Option<Self> {
        let mut result = Self::point(1.0);
        for _ in 0..n.unsigned_abs().min(2000) {
            result = result.mul(self)?;
        }
        if n >= 0 {
            return Some(result);
        }
        if result.excludes_zero() { Self::new(1.0 / result.hi, 1.0 / result.lo) } else { None }
    }

    /// f about the middle, for a function that changes by at most `slope` times its argument and is at most `size`.
    fn lipschitz(self, f: impl Fn(f64) -> f64, slope: f64, size: f64) -> Option<Self> {
        let middle = f64::midpoint(self.lo, self.hi);
        let radius = slope * (self.hi - self.lo) + LIBRARY * size;
        let value = f(middle);
        Self::new(value - radius, value + radius)
    }

    fn apply(self, f: Function) -> Option<Self> {
        match f {
            Function::Sin => self.lipschitz(f64::sin, 1.0, 1.0),
            Function::Cos => self.lipschitz(f64::cos, 1.0, 1.0),
            Function::Sqrt if self.lo >= 0.0 => Self::new(self.lo.sqrt(), self.hi.sqrt()),
            Function::Exp => {
                let (lo, hi) = (self.lo.exp(), self.hi.exp());
                Self::new(lo * (1.0 - LIBRARY), hi * (1.0 + LIBRARY))
            }
            Function::Log if self.lo > 0.0 => {
                let (lo, hi) = (self.lo.ln(), self.hi.ln());
                Self::new(lo - LIBRARY * (1.0 + lo.abs()), hi + LIBRARY * (1.0 + hi.abs()))
            }
            Function::Atan => self.lipschitz(f64::atan, 1.0, 2.0),
            Function::Tanh => self.lipschitz(f64::tanh, 1.0, 1.0),
            Function::Abs if self.excludes_zero() => {
                let (a, b) = (self.lo.abs(), self.hi.abs());
                Some(Self { lo: a.min(b), hi: a.max(b) })
            }
            Function::Sign if self.excludes_zero() => Some(Self::point(self.lo.signum())),
            _ => None,
        }
    }
}

/// The interval of `e` where each symbol has the given value; `None` where a divisor or a root's argument is not
/// known to be in its domain.
pub fn enclose(arena: &Arena, e: Expr, at: &FxHashMap<Expr, f64>) -> Option<Interval> {
    let mut values: FxHashMap<Expr, Interval> = FxHashMap::default();
    for part in arena.reachable(&[e]) {
        let value = match arena.node(part) {
            Node::Number(value) => Interval::rational(value)?,
            Node::Symbol(_) => Interval::point(*at.get(&part)?),
            Node::Pi => Interval::new(std::f64::consts::PI, std::f64::consts::PI)?,
            Node::Sum(constant, terms) => {
                let mut sum = Interval::rational(constant)?;
                for (term, k) in terms {
                    sum = sum.add(values[term].mul(Interval::rational(k)?)?)?;
                }
                sum
            }
            Node::Product(factors) => {
                let mut product = Interval::point(1.0);
                for (base, n) in factors {
                    product = product.mul(values[base].power(*n)?)?;
                }
                product
            }
            Node::Apply(f, argument) => values[argument].apply(*f)?,
        };
        values.insert(part, value);
    }
    values.get(&e).copied()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::parse::parse_free;

    fn excludes_zero(text: &str) -> bool {
        let mut arena = Arena::new();
        let e = parse_free(&mut arena, text).unwrap();
        let at = ["x", "y"].map(|name| arena.symbol(name)).into_iter().zip([0.7, -1.9]).collect();
        enclose(&arena, e, &at).is_some_and(Interval::excludes_zero)
    }

    #[test]
    fn rounding_is_never_taken_for_a_difference() {
        for text in [
            "sqrt(x^4 + 2*x^2 + 1) - x^2 - 1",
            "sin(x)^2 + cos(x)^2 - 1",
            "(x + 1)^20 - (1 + x)^19*(x + 1)",
            "exp(x)*exp(y) - exp(x + y)",
        ] {
            assert!(!excludes_zero(text), "{text}");
        }
        for text in ["sqrt(x^2) + x", "abs(y) - y", "exp(x) - 1 - x", "sin(x) - x", "x - 7/10 + 1/10^15"] {
            assert!(excludes_zero(text), "{text}");
        }
    }
}
