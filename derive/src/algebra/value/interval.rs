//! Intervals that contain the real value of an expression at a point: every operation is rounded
//! outwards.
//!
//! If the interval of a difference excludes 0, the two sides are proved to differ at that point.

use super::tape::Tape;
use super::zero_test::{ZeroTest, zero_test};
use crate::algebra::term::calculus::Substitution;
use crate::algebra::term::fold::{Fold, Values, fold};
use crate::algebra::{Arena, Expr, Function, Node, Rational};
use rustc_hash::{FxHashMap, FxHashSet};

/// Interval of real numbers from lo to hi, lo ≤ hi, both finite.
#[derive(Clone, Copy, Debug)]
pub struct PointInterval {
    /// Lower end of the interval.
    lo: f64,
    /// Upper end of the interval.
    hi: f64,
}

/// Relative error allowed for the sine, cosine or exponential of a library: a hundred units in the
/// last place. The error of any real library is far smaller.
const LIBRARY: f64 = 100.0 * f64::EPSILON;
/// Largest absolute value of an exponent for which a power has an interval. Powers are computed by
/// repeated multiplication.
const MOST_POWER: u32 = 2000;

impl PointInterval {
    /// Creates an interval, widened at both ends by one unit in the last place. `None` if an end
    /// exceeds the range of doubles.
    fn new(lo: f64, hi: f64) -> Option<Self> {
        let (lo, hi) = (lo.next_down(), hi.next_up());
        (lo.is_finite() && hi.is_finite() && lo <= hi).then_some(Self { lo, hi })
    }

    /// Creates the interval of a single number.
    pub const fn point(x: f64) -> Self {
        Self { lo: x, hi: x }
    }

    /// True if the width of the interval is at most `precision` times its smaller end, in absolute
    /// value. An interval that contains 0 fulfils this only if it is the point 0.
    pub fn is_within_precision(self, precision: f64) -> bool {
        self.hi - self.lo <= precision * self.lo.abs().min(self.hi.abs())
    }

    /// True if every number of the interval is above 0.
    pub fn is_positive(self) -> bool {
        self.lo > 0.0
    }

    /// True if 0 lies outside the interval.
    pub fn excludes_zero(self) -> bool {
        self.lo > 0.0 || self.hi < 0.0
    }

    /// True if every number of this interval is above every number of the interval `other`.
    pub fn is_above(self, other: Self) -> bool {
        self.lo > other.hi
    }

    /// Interval that contains a rational number; it is a single double if that is exact. `None`
    /// beyond the range of doubles.
    fn rational(value: &Rational) -> Option<Self> {
        let x = value.to_f64();
        if Rational::from_f64_exact(x).as_ref() == Some(value) { Some(Self::point(x)) } else { Self::new(x, x) }
    }

    /// Interval of the sums x + y, for x in this interval and y in `other`; `None` beyond the range
    /// of doubles.
    fn add(self, other: Self) -> Option<Self> {
        Self::new(self.lo + other.lo, self.hi + other.hi)
    }

    /// Interval of the products x · y, for x in this interval and y in `other`; `None` beyond the
    /// range of doubles.
    fn mul(self, other: Self) -> Option<Self> {
        let products = [self.lo * other.lo, self.lo * other.hi, self.hi * other.lo, self.hi * other.hi];
        let lo = products.iter().copied().fold(f64::INFINITY, f64::min);
        let hi = products.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        Self::new(lo, hi)
    }

    /// Interval of the powers xⁿ, for x in the interval. `None` if n is too large, if n is negative
    /// and the interval may contain 0, or beyond the range of doubles.
    fn power(self, n: i32) -> Option<Self> {
        if n.unsigned_abs() > MOST_POWER {
            return None;
        }
        let mut result = Self::point(1.0);
        for _ in 0..n.unsigned_abs() {
            result = result.mul(self)?;
        }
        if n >= 0 {
            return Some(result);
        }
        if result.excludes_zero() { Self::new(1.0 / result.hi, 1.0 / result.lo) } else { None }
    }

    /// Interval of −x, for x in the interval.
    fn negated(self) -> Self {
        Self { lo: -self.hi, hi: -self.lo }
    }

    /// Interval of |x|, for x in the interval.
    fn absolute_value(self) -> Self {
        let (a, b) = (self.lo.abs(), self.hi.abs());
        Self { lo: if self.excludes_zero() { a.min(b) } else { 0.0 }, hi: a.max(b) }
    }

    /// Interval of a function such as sine, computed from its value at the middle of the interval.
    /// The absolute values of the function and of its slope must be at most 1.
    fn enclose_wave(self, f: impl Fn(f64) -> f64) -> Option<Self> {
        let value = f(f64::midpoint(self.lo, self.hi));
        let radius = self.hi - self.lo + LIBRARY * value.abs();
        Self::new(value - radius, value + radius)
    }

    /// Interval of an increasing function f, from its values at both ends. `None` beyond the range
    /// of doubles.
    fn enclose_increasing(self, f: impl Fn(f64) -> f64) -> Option<Self> {
        let (lo, hi) = (f(self.lo), f(self.hi));
        Self::new(lo - LIBRARY * lo.abs(), hi + LIBRARY * hi.abs())
    }

    /// Interval of f(x), for x in the interval. `None` if part of the interval is outside the
    /// domain of f, or the result exceeds the range of doubles.
    fn apply(self, f: Function) -> Option<Self> {
        match f {
            Function::Sin => self.enclose_wave(f64::sin),
            Function::Cos => self.enclose_wave(f64::cos),
            Function::Sqrt if self.lo >= 0.0 => Self::new(self.lo.sqrt(), self.hi.sqrt()),
            Function::Exp => self.enclose_increasing(f64::exp),
            Function::Sinh => self.enclose_increasing(f64::sinh),
            // cosh x = cosh |x|, which increases with |x|.
            Function::Cosh => self.absolute_value().enclose_increasing(f64::cosh),
            Function::Asin if self.lo >= -1.0 && self.hi <= 1.0 => self.enclose_increasing(f64::asin),
            // acos decreases: −acos increases.
            Function::Acos if self.lo >= -1.0 && self.hi <= 1.0 => {
                self.enclose_increasing(|x| -x.acos()).map(Self::negated)
            }
            Function::Log if self.lo > 0.0 => self.enclose_increasing(f64::ln),
            Function::Atan => self.enclose_increasing(f64::atan),
            Function::Tanh => self.enclose_increasing(f64::tanh),
            Function::Abs => Some(self.absolute_value()),
            Function::Sign if self.excludes_zero() => Some(Self::point(self.lo.signum())),
            _ => None,
        }
    }
}

/// Relative width of a constant's interval above which its digits count as lost to rounding.
const KNOWN: f64 = 1e-8;

/// Power of ten of the first number in the term whose size is beyond the range of normal doubles.
/// `None` if all numbers are within this range.
#[must_use]
pub fn number_beyond_doubles(arena: &Arena, e: Expr) -> Option<f64> {
    let fits = |value: &&Rational| {
        let size = value.to_f64().abs();
        value.is_zero() || (size.is_normal() && size.recip().is_normal())
    };
    let found = arena.reachable(&[e]).into_iter().find_map(|part| match arena.node(part) {
        Node::Number(value) => Some(value).filter(|value| !fits(value)),
        Node::Sum(constant, terms) => terms.iter().map(|(_, k)| k).chain([constant]).find(|value| !fits(value)),
        _ => None,
    });
    found.map(magnitude)
}

/// Power of ten of a number's absolute value, rounded to an integer.
fn magnitude(value: &Rational) -> f64 {
    let big = value.to_big();
    let bits = |n: u64| i64::try_from(n).unwrap_or(i64::MAX);
    let twos = bits(big.numer().bits()) - bits(big.denom().bits());
    (twos as f64 * std::f64::consts::LOG10_2).round()
}

/// First constant part of a term whose value is not known to eight digits in doubles, such as
/// exp(10^-20) − 1 or sin(10^30). A constant part has no symbols. `None` if there is no such part.
pub fn constant_with_wide_interval(arena: &Arena, e: Expr) -> Option<Expr> {
    let mut constant: FxHashSet<Expr> = FxHashSet::default();
    // Operands have smaller handles than the terms built from them.
    for part in arena.reachable(&[e]) {
        let is_constant = match arena.node(part) {
            Node::Number(_) | Node::Pi => true,
            Node::Symbol(_) => false,
            Node::Sum(_, terms) => terms.iter().all(|(term, _)| constant.contains(term)),
            Node::Product(factors) => factors.iter().all(|(base, _)| constant.contains(base)),
            Node::Apply(_, argument) | Node::Named(_, argument) => constant.contains(argument),
        };
        if !is_constant {
            continue;
        }
        constant.insert(part);
        let is_known = match enclose_in_interval(arena, part, &FxHashMap::default()) {
            _ if matches!(arena.node(part), Node::Number(_) | Node::Pi) => true,
            Some(found) => found.is_within_precision(KNOWN),
            // Without an interval, the value is at the edge of a function's domain, or beyond the
            // range of doubles. The second case is reported elsewhere.
            None => Tape::new(arena, &[], &[part]).is_ok_and(|tape| !tape.evaluate(&[])[0].is_finite()),
        };
        if !is_known {
            return Some(part);
        }
    }
    None
}

/// Replaces constant parts of the term `e` by 0 if they are exactly 0 but lose their digits in
/// doubles. An example is 2 + √5 (1/(5 + 2 √5) − 1).
pub fn without_zeros_of_wide_interval(arena: &mut Arena, mut e: Expr) -> Expr {
    while let Some(lost) =
        constant_with_wide_interval(arena, e).filter(|lost| zero_test(arena, *lost) == ZeroTest::Zero)
    {
        let mut put = Substitution::new(&[(lost, Expr::ZERO)]);
        let next = put.apply(arena, e);
        if put.undefined.is_some() {
            break;
        }
        e = next;
    }
    e
}

/// Interval that contains the value of the term `e` at a point; the map `at` has the value of each
/// symbol.
///
/// `None` if a symbol has no value, if a divisor may be 0, or if the argument of a function may be
/// outside its domain. `None` also beyond the range of doubles.
pub fn enclose_in_interval(arena: &Arena, e: Expr, at: &FxHashMap<Expr, f64>) -> Option<PointInterval> {
    fold(arena, e, &mut IntervalRules(at))
}

/// Rules that enclose the value of each term in an interval, with the values of the symbols.
struct IntervalRules<'a>(&'a FxHashMap<Expr, f64>);

impl Fold for IntervalRules<'_> {
    type Value = PointInterval;
    fn number(&mut self, value: &Rational) -> Option<PointInterval> {
        PointInterval::rational(value)
    }
    fn pi(&mut self) -> Option<PointInterval> {
        PointInterval::new(std::f64::consts::PI, std::f64::consts::PI)
    }
    fn symbol(&mut self, symbol: Expr) -> Option<PointInterval> {
        self.0.get(&symbol).map(|value| PointInterval::point(*value))
    }
    fn sum(
        &mut self,
        constant: &Rational,
        terms: &[(Expr, Rational)],
        of: &Values<'_, PointInterval>,
    ) -> Option<PointInterval> {
        let add =
            |sum: PointInterval, (term, k): &(Expr, Rational)| sum.add(of[*term].mul(PointInterval::rational(k)?)?);
        terms.iter().try_fold(PointInterval::rational(constant)?, add)
    }
    fn product(&mut self, factors: &[(Expr, i32)], of: &Values<'_, PointInterval>) -> Option<PointInterval> {
        factors.iter().try_fold(PointInterval::point(1.0), |product, (base, n)| product.mul(of[*base].power(*n)?))
    }
    fn apply(&mut self, f: Function, argument: Expr, of: &Values<'_, PointInterval>) -> Option<PointInterval> {
        of[argument].apply(f)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::text::parse::parse_free;
    use crate::algebra::value::field::Generator;
    use crate::algebra::value::tape::Numeric;

    fn excludes_zero(text: &str) -> bool {
        let mut arena = Arena::new();
        let e = parse_free(&mut arena, text).unwrap();
        let at = ["x", "y"].map(|name| arena.symbol(name)).into_iter().zip([0.7, -1.9]).collect();
        enclose_in_interval(&arena, e, &at).is_some_and(PointInterval::excludes_zero)
    }

    fn contains(interval: PointInterval, x: &Rational) -> bool {
        let end = |x: f64| Rational::from_f64_exact(x).unwrap();
        end(interval.lo) <= *x && *x <= end(interval.hi)
    }

    /// Random number from −`size` to `size`, in steps of a thousandth of `size`.
    fn number(generator: &mut Generator, size: f64) -> f64 {
        (generator.next() % 2001) as f64 / 1000.0 * size - size
    }

    /// Intervals of powers and sums contain the exact value, computed in rational arithmetic at
    /// points that doubles represent exactly.
    #[test]
    fn powers_and_sums_hold_the_exact_value() {
        let mut generator = Generator(1);
        for n in -40_i32..=40 {
            for _ in 0..20 {
                let x = number(&mut generator, 3.0);
                let (exact, point) = (Rational::from_f64_exact(x).unwrap(), PointInterval::point(x));
                let Some(power) = point.power(n) else {
                    assert!(x == 0.0 && n < 0, "{x}^{n}");
                    continue;
                };
                let value = exact.pow(n).unwrap();
                assert!(contains(power, &value), "{x}^{n}: {power:?}");
                assert!(contains(power.add(point).unwrap(), &value.add(&exact)), "{x}^{n} + {x}");
            }
        }
    }

    #[test]
    fn a_power_too_high_to_multiply_out_has_no_enclosure() {
        let above_one = PointInterval::new(1.0001, 1.0001).unwrap();
        assert!(above_one.power(2000).is_some_and(|x| x.lo > 1.22 && x.hi < 1.2215));
        assert!(above_one.power(-2000).is_some_and(|x| x.lo > 0.818 && x.hi < 0.82));
        for n in [2001, -2001, i32::MAX, i32::MIN] {
            assert!(above_one.power(n).is_none(), "{n}");
        }
    }

    /// The interval of a function contains the function's values at arguments between the ends. All
    /// functions are tested at seeded points. The error of the library's values is far below the
    /// error that the interval allows.
    #[test]
    fn functions_hold_their_values_between_the_ends() {
        let mut generator = Generator(2);
        for (f, name) in Function::ALL {
            let mut found = 0;
            for at in 0..1000 {
                // Arguments near 0, within [−0.9, 0.9], and up to 10.
                let x = number(&mut generator, [1e-9, 0.9, 10.0][at % 3]);
                let width = [0.0, 1e-9, 0.1, 5.0][at % 4];
                let (left, right) = (number(&mut generator, width).abs(), number(&mut generator, width).abs());
                let Some(interval) = PointInterval::new(x - left, x + right).and_then(|i| i.apply(f)) else { continue };
                let value = x.apply(f);
                assert!(interval.lo <= value && value <= interval.hi, "{name}({x}) = {value}: {interval:?}");
                found += 1;
            }
            assert!(found > 200, "{name}: {found}");
        }
    }

    /// No interval is too narrow: the intervals of both sides of an identity must overlap.
    #[test]
    fn functions_and_their_inverses_meet() {
        let mut generator = Generator(3);
        for _ in 0..1000 {
            let x = number(&mut generator, 1.5);
            let after = |first: Function, second: Function, x: f64| {
                PointInterval::point(x).apply(first).and_then(|y| y.apply(second))
            };
            for (first, second, x) in [
                (Function::Sin, Function::Asin, x),
                (Function::Cos, Function::Acos, x.abs()),
                (Function::Exp, Function::Log, x),
            ] {
                // If rounding may put sin x above 1, the inverse has no interval.
                let Some(back) = after(first, second, x) else { continue };
                assert!(back.lo <= x && x <= back.hi, "{} {} of {x}: {back:?}", second.name(), first.name());
            }
            let point = PointInterval::point(x);
            let of = |f: Function| point.apply(f).unwrap();
            // cosh x + sinh x = exp x;  tanh x · cosh x = sinh x
            let e = of(Function::Cosh).add(of(Function::Sinh)).unwrap();
            assert!(!e.add(of(Function::Exp).negated()).unwrap().excludes_zero(), "exp({x})");
            let product = of(Function::Tanh).mul(of(Function::Cosh)).unwrap();
            assert!(!product.add(of(Function::Sinh).negated()).unwrap().excludes_zero(), "sinh({x})");
        }
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
        for text in [
            "sqrt(x^2) + x",
            "abs(y) - y",
            "exp(x) - 1 - x",
            "sin(x) - x",
            "x - 7/10 + 1/10^15",
            "asin(x) + acos(x) - 157/100",
            "cosh(x)^2 - sinh(x)^2 - 1 + 1/10^12",
        ] {
            assert!(excludes_zero(text), "{text}");
        }
    }
}
