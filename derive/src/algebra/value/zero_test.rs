//! Zero test of terms, in whatever form they are written: exact evaluation modulo random primes.
//!
//! Symbols get random residues; positive symbols get squares. Each base angle gets a random point
//! of the unit circle (s = 2t/(1+t²), c = (1−t²)/(1+t²)), and multiples of π/12 get their exact
//! values. A square root gets the residue that is itself a square, so that √a·√b = √(ab). The power
//! of e to each base exponent gets a random residue, from which exp, sinh, cosh and tanh are
//! computed.
//!
//! All arithmetic is modulo a 61-bit prime, so nothing is rounded. Primes and points come from a
//! generator seeded with the compared terms, names included. So every run gives the same result,
//! and no formula can be made to pass by the choice of a fixed prime.
//!
//! A non-zero residue proves that an expression of these atoms is not zero. If the residues are
//! zero at every point, there is an error bound ([`bounded_zero_test`]). With m square roots, a
//! wrong pattern of signs may show at only one point in 2^m. So the number of points is multiplied,
//! and beyond four roots no bound is claimed.
//!
//! Other functions are taken as independent atoms. If they occur, a non-zero residue proves
//! nothing, and the answer is [`ZeroTest::Undecided`].

use super::field::Field;
use super::residues::{POINTS, ResiduePoint, angle_denominators, residue_generator, residues_at_point};
use super::zero_error_bound::false_zero_exponent;
use crate::algebra::term::elementary::{angle_atoms, is_exponential};
use crate::algebra::term::fold::FoldOrder;
use crate::algebra::{Arena, Expr, Function, Node};

/// Number of points for terms with square roots, to be doubled for each root. A wrong pattern of
/// the signs of m roots may show at only one point in 2^m. It is overlooked with a probability of
/// (1 − 2^−m)^(44·2^m) < 2^−63.
const POINTS_WITH_ROOTS: usize = 44;
/// Largest number of square roots in a term for which the result "zero" has an error bound.
const MOST_ROOTS: u32 = 4;
/// Largest number of term evaluations in one zero test.
const WORK: usize = 4_000_000;

/// Result of testing if a term is zero for all values of its symbols.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ZeroTest {
    /// The term is zero at every random point. The function [`bounded_zero_test`] also gives the
    /// error bound.
    Zero,
    /// The term is proved not to be zero everywhere.
    NonZero,
    /// Not decided: the term contains a function without known rules, or no point was found where
    /// it has a value.
    Undecided,
}

/// Random point of a prime field at which a zero test found a term to be zero.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Trial {
    /// Prime modulus of the field, a prime of 61 bits.
    pub prime: u64,
    /// Seed from which the residues of all symbols and angles are drawn at the point.
    pub seed: u64,
}

/// Points at which [`zero_test`] evaluates the term `e` and finds zero, in the order of the test.
/// Empty for a number or a symbol.
#[must_use]
pub fn zero_test_points(arena: &Arena, e: Expr) -> Vec<Trial> {
    let mut list = Vec::new();
    zero_test_at(arena, e, &mut |trial| list.push(trial));
    list
}

/// Tests if the term `e` is zero for all values of its symbols, in whatever form it is written.
#[must_use]
pub fn zero_test(arena: &Arena, e: Expr) -> ZeroTest {
    zero_test_at(arena, e, &mut |_| {})
}

/// Tests a term in the same way as [`zero_test`]. Each point at which the term is zero is passed to
/// the function `found`.
fn zero_test_at(arena: &Arena, e: Expr, found: &mut dyn FnMut(Trial)) -> ZeroTest {
    match arena.node(e) {
        Node::Number(value) => return if value.is_zero() { ZeroTest::Zero } else { ZeroTest::NonZero },
        Node::Symbol(_) | Node::Pi => return ZeroTest::NonZero,
        Node::Named(_, term) => return zero_test_at(arena, *term, found),
        _ => {}
    }
    let needed = FoldOrder::new(arena, &[e]);
    let parts = needed.nodes();
    let opaque = !zero_test_is_proof(arena, parts);
    let denominators = angle_denominators(arena, parts);
    let mut generator = residue_generator(arena, &needed);
    let mut evaluated = 0;
    // The residue of √x² is x or −x with equal probability, so a point detects a wrong sign with
    // probability 1/2 only.
    let all_roots = count_roots_for_zero_test(arena, parts);
    let roots = all_roots.min(MOST_ROOTS);
    let wanted = if roots == 0 { POINTS } else { POINTS_WITH_ROOTS << roots };
    // The sign of the root of a number depends on the prime alone. If there are such roots, each
    // point has its own prime.
    let primes = if roots > 0 && has_roots_of_numbers(arena, parts) { 1 } else { 8 };
    // The second field is drawn only when needed, since most differences show at the first point.
    let mut field = Field::random(&mut generator);
    let mut is_second = false;
    // If a root or an inverse does not exist at a point, another point is drawn. Each root rejects
    // half of all points, so for many roots no point may be left.
    let attempts = (WORK / parts.len()).clamp(8, 400 * wanted);
    if 1_usize.checked_shl(all_roots).is_none_or(|needed| needed > attempts) {
        return ZeroTest::Undecided;
    }
    for attempt in 0..attempts {
        let halfway = roots == 0 && evaluated == wanted / 2 && !is_second;
        if halfway || (roots > 0 && attempt > 0 && attempt % primes == 0) {
            field = Field::random(&mut generator);
            is_second = true;
        }
        let seed = generator.next();
        let point = ResiduePoint::new(field, seed);
        match residues_at_point(arena, &needed, &denominators, &point).map(|values| values[e]) {
            Some(0) => {
                found(Trial { prime: field.prime, seed });
                evaluated += 1;
            }
            Some(_) => return if opaque { ZeroTest::Undecided } else { ZeroTest::NonZero },
            None => {}
        }
        if evaluated == wanted {
            return ZeroTest::Zero;
        }
    }
    ZeroTest::Undecided
}

/// Tests a term in the same way as [`zero_test`]. Returns the result and an exponent k: the result
/// "zero" is wrong with a probability below 2^−k.
#[must_use]
pub fn bounded_zero_test(arena: &Arena, e: Expr) -> (ZeroTest, f64) {
    let needed = FoldOrder::new(arena, &[e]);
    let exponent = false_zero_exponent(arena, &needed, &angle_denominators(arena, needed.nodes()), e);
    let roots = count_roots_for_zero_test(arena, needed.nodes());
    let exponent = match roots {
        0 => exponent,
        1..=MOST_ROOTS => exponent.min(63.0),
        _ => 0.0,
    };
    match zero_test(arena, e) {
        // A zero with a bound weaker than 2^−32 counts as undecided.
        ZeroTest::Zero if exponent < 32.0 => (ZeroTest::Undecided, exponent),
        answer => (answer, exponent),
    }
}

/// Number of different square roots, absolute values and signs among the given terms. The absolute
/// value and the sign of one argument count as one.
pub(in crate::algebra) fn count_roots_for_zero_test(arena: &Arena, parts: &[Expr]) -> u32 {
    let mut arguments: Vec<(bool, Expr)> = parts
        .iter()
        .filter_map(|p| match arena.node(*p) {
            Node::Apply(Function::Sqrt, argument) => Some((true, *argument)),
            Node::Apply(Function::Abs | Function::Sign, argument) => Some((false, *argument)),
            _ => None,
        })
        .collect();
    arguments.sort_unstable();
    arguments.dedup();
    u32::try_from(arguments.len()).unwrap_or(u32::MAX)
}

/// True if the given terms contain a square root, absolute value or sign of a constant, which is a
/// term without symbols.
fn has_roots_of_numbers(arena: &Arena, parts: &[Expr]) -> bool {
    parts.iter().any(|p| match arena.node(*p) {
        Node::Apply(Function::Sqrt | Function::Abs | Function::Sign, argument) => {
            arena.reachable(&[*argument]).iter().all(|inner| arena.symbol_name(*inner).is_none())
        }
        _ => false,
    })
}

/// Largest number of divisors of a term that are tested for being identically zero.
const MAX_DIVISORS: usize = 200;

/// First divisor in the term `e` that is identically zero, such as cos(q)^2 + sin(q)^2 - 1; `None`
/// if no divisor is zero.
#[must_use]
pub fn zero_divisor(arena: &Arena, e: Expr) -> Option<Expr> {
    let mut divisors = Vec::new();
    for part in arena.reachable(&[e]) {
        if let Node::Product(factors) = arena.node(part) {
            divisors.extend(factors.iter().filter(|(_, n)| *n < 0).map(|(base, _)| *base));
        }
    }
    // A sum of different symbols is not zero; only sums with products or functions can cancel.
    let may_cancel = |base: &Expr| match arena.node(*base) {
        Node::Sum(_, terms) => terms.iter().any(|(term, _)| arena.symbol_name(*term).is_none()),
        _ => false,
    };
    divisors.retain(may_cancel);
    divisors.truncate(MAX_DIVISORS);
    divisors.into_iter().find(|d| zero_test(arena, *d) == ZeroTest::Zero)
}

/// True if a square root, an absolute value or a sign occurs among the given terms.
#[must_use]
pub fn has_roots(arena: &Arena, parts: &[Expr]) -> bool {
    let root = |p: &Expr| matches!(arena.node(*p), Node::Apply(Function::Sqrt | Function::Abs | Function::Sign, _));
    parts.iter().any(root)
}

/// True if all algebraic relations between the atoms of the given terms are known. Then a non-zero
/// residue proves that a term is not zero.
///
/// Symbols are independent of one another, of π and of any single transcendental number. So are
/// sines of base angles and powers of e to base exponents, as long as angles and exponents are sums
/// of products of powers of symbols, also negative ones (Ax 1971). Square roots are evaluated and are not atoms.
///
/// False if other functions occur. False also for sines of numbers if π occurs outside of angles,
/// and for multiples of π whose sines are not roots.
#[must_use]
pub fn zero_test_is_proof(arena: &Arena, parts: &[Expr]) -> bool {
    let (mut pi_outside, mut numbers_inside) = (false, false);
    let mut inside_only: rustc_hash::FxHashSet<Expr> = rustc_hash::FxHashSet::default();
    for part in parts {
        match arena.node(*part) {
            Node::Apply(function, argument)
                if matches!(function, Function::Sin | Function::Cos) || is_exponential(*function) =>
            {
                for (atom, k) in angle_atoms(arena, *argument) {
                    match arena.node(atom) {
                        Node::Symbol(_) => {}
                        Node::Number(_) => numbers_inside = true,
                        Node::Pi if is_exponential(*function) => return false,
                        Node::Pi if k.small().is_some_and(|(_, d)| 12 % d == 0) => {
                            inside_only.insert(*argument);
                        }
                        Node::Product(factors)
                            if factors.iter().all(|(base, _)| arena.symbol_name(*base).is_some()) => {}
                        _ => return false,
                    }
                }
            }
            Node::Apply(Function::Sqrt | Function::Abs | Function::Sign, _) => {}
            Node::Apply(..) => return false,
            Node::Sum(_, terms) => {
                let has_pi = terms.iter().any(|(term, _)| *arena.node(*term) == Node::Pi);
                pi_outside |= has_pi && !inside_only.contains(part) && !is_angle(arena, parts, *part);
            }
            Node::Product(factors) => pi_outside |= factors.iter().any(|(base, _)| *arena.node(*base) == Node::Pi),
            _ => {}
        }
    }
    !(pi_outside && numbers_inside)
}

/// True if the term `e` is the argument of a sine or cosine in the list `parts`.
fn is_angle(arena: &Arena, parts: &[Expr], e: Expr) -> bool {
    parts.iter().any(|p| matches!(arena.node(*p), Node::Apply(Function::Sin | Function::Cos, inner) if *inner == e))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::text::parse::parse_free;

    fn test(text: &str) -> ZeroTest {
        let mut arena = Arena::new();
        let e = parse_free(&mut arena, text).unwrap();
        zero_test(&arena, e)
    }

    #[test]
    fn identities_are_zero() {
        for text in [
            "cos(q)^2 + sin(q)^2 - 1",
            "sin(2*q) - 2*sin(q)*cos(q)",
            "sin(a + b) - sin(a)*cos(b) - cos(a)*sin(b)",
            "cos(q/2)^2 - (1 + cos(q))/2",
            "tan(q)^2 + 1 - sec(q)^2",
            "sqrt(a)*sqrt(b) - sqrt(a*b)",
            "(a + b)^5 - a^5 - 5*a^4*b - 10*a^3*b^2 - 10*a^2*b^3 - 5*a*b^4 - b^5",
            "1/(a - b) - 1/(a + b) - 2*b/(a^2 - b^2)",
            "exp(a + b) - exp(b + a)",
            "exp(a)*exp(b) - exp(a + b)",
            "cosh(a)^2 - sinh(a)^2 - 1",
            "tanh(a/2)*(cosh(a) + 1) - sinh(a)",
            "sin(atan(a)) - a/sqrt(1 + a^2)",
            "cos(2*asin(a)) - 1 + 2*a^2",
            "sin(b - acos(a)) - a*sin(b) + sqrt(1 - a^2)*cos(b)",
            "abs(a)*abs(b) - abs(a*b)",
            "abs(a)^2 - a^2",
            "sign(a)*a - abs(a)",
            "sin(q + 1/2)^2 + cos(q + 1/2)^2 - 1",
            "sin(q + 1/2) - sin(q)*cos(1/2) - cos(q)*sin(1/2)",
            "sin(q + pi/4) - sqrt(1/2)*(sin(q) + cos(q))",
            "cos(q - 5*pi/6) + sqrt(3)/2*cos(q) - sin(q)/2",
            "sin(pi/12) - (sqrt(6) - sqrt(2))/4",
        ] {
            assert_eq!(test(text), ZeroTest::Zero, "{text}");
        }
    }

    #[test]
    fn near_identities_are_not_zero() {
        for text in [
            "cos(q)^2 + sin(q)^2 - 1 + a/10^40",
            "sin(2*q) - 2*sin(q)",
            "sqrt(a^2) - a",
            "sqrt(b^2) - b",
            "abs(a) - a",
            "abs(a + b) - abs(a) - abs(b)",
            "sqrt(cos(q)^2) - cos(q)",
            "sin(q) - q + q^3/6",
            "2305843009213693951*a",
            "a - 9223372036854775808*a",
            "a*(b - pi/2) - a*(b - pi/3)",
            "sin(q + pi/4) - sin(q)",
            "cosh(a)^2 - sinh(a)^2 - 2",
            "exp(a) - 1 - a",
        ] {
            assert_eq!(test(text), ZeroTest::NonZero, "{text}");
        }
    }

    #[test]
    fn functions_without_rules_are_left_undecided() {
        assert_eq!(test("log(a*b) - log(a) - log(b)"), ZeroTest::Undecided);
        assert_eq!(test("sin(q + pi/5)^2 + cos(q + pi/5)^2 - 1"), ZeroTest::Zero);
        assert_eq!(test("sin(q/4000000007)*cos(q/5000000029) - sin(q)"), ZeroTest::Undecided);
        assert_eq!(test("sin(pi/5)^2 - (5 - sqrt(5))/8"), ZeroTest::Undecided);
    }
}
