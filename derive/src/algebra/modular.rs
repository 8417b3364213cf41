//! Is this expression zero by meaning? Exact evaluation modulo random primes.
//!
//! Symbols get random residues (squares where the symbol is known to be positive), each angle a random
//! point of the unit circle (s = 2t/(1+t²), c = (1−t²)/(1+t²)), multiples of π/12 their exact values, square
//! roots the residue that is itself a square, so that √a·√b = √(ab). All of it is arithmetic modulo a
//! 61-bit prime: no rounding. Primes and points come from a generator seeded with the terms compared, names included,
//! so builds repeat and no fixed prime can be aimed at.
//!
//! A non-zero residue proves that an expression of these atoms is not zero. Zero residues at every
//! point leave an error bound ([`bounded_zero_test`]); with m square roots a wrong pattern of signs shows at one
//! point in 2^m at worst, so points multiply, and beyond four roots no bound is claimed. Functions other than sine, cosine and square
//! root are taken as independent atoms: with them a non-zero residue proves nothing, and the answer
//! is [`ZeroTest::Undecided`].

use super::bound::error_exponent;
use super::elementary::angle_atoms;
use super::field::{Field, Generator};
use super::{Arena, Expr, Function, Node, Rational};
use num_integer::Integer;
use rustc_hash::{FxHashMap, FxHasher};
use std::hash::{Hash, Hasher};

/// Random points, half of them in each field, at which zeros must be seen.
pub const POINTS: usize = 4;
/// The same for one square root; each further one doubles it, since a wrong pattern of m signs may show at one point in
/// 2^m only: (1 − 2^−m)^(44·2^m) < 2^−63.
const POINTS_WITH_ROOTS: usize = 44;
/// More roots than this are not tested to that bound.
const MOST_ROOTS: u32 = 4;
/// Evaluations of terms that one zero test may cost.
const WORK: usize = 4_000_000;

/// The answer to "is it zero?".
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ZeroTest {
    /// Zero at every random point, in both fields.
    Zero,
    /// Proved not to be zero.
    NonZero,
    /// Not decided: a function that this engine cannot reason about, or no point where it is defined.
    Undecided,
}

/// One random point in one field.
struct Point {
    field: Field,
    seed: u64,
}

impl Point {
    /// A residue that depends only on the point and on `key`: equal keys, equal residues.
    fn residue(&self, key: impl Hash) -> u64 {
        let mut hasher = FxHasher::default();
        (self.seed, key).hash(&mut hasher);
        Generator(hasher.finish() ^ self.seed).next() % self.field.0
    }

    /// (sin, cos) of the base angle named by `key`.
    fn base(&self, key: u64) -> Option<(u64, u64)> {
        let f = self.field;
        let t = self.residue(("angle", key));
        let t2 = f.mul(t, t);
        let inverse = f.inverse(f.add(1, t2))?;
        Some((f.mul(f.add(t, t), inverse), f.mul(f.sub(1, t2), inverse)))
    }

    /// (sin, cos) of π/12: (√6 − √2)/4 and (√6 + √2)/4.
    fn twelfth(&self) -> Option<(u64, u64)> {
        let f = self.field;
        let (two, three) = (f.root(2)?, f.root(3)?);
        let (six, quarter) = (f.mul(two, three), f.inverse(4)?);
        Some((f.mul(f.sub(six, two), quarter), f.mul(f.add(six, two), quarter)))
    }

    /// (sin, cos) of k times an angle.
    fn multiple(&self, unit: (u64, u64), k: i64) -> (u64, u64) {
        let f = self.field;
        let (mut result, mut power, mut left) = ((0, 1), unit, k.unsigned_abs());
        while left > 0 {
            if left & 1 == 1 {
                result = self.turn(result, power);
            }
            power = self.turn(power, power);
            left >>= 1;
        }
        if k < 0 { (f.sub(0, result.0), result.1) } else { result }
    }

    /// (sin, cos) of the sum of two angles.
    fn turn(&self, a: (u64, u64), b: (u64, u64)) -> (u64, u64) {
        let f = self.field;
        (f.add(f.mul(a.0, b.1), f.mul(a.1, b.0)), f.sub(f.mul(a.1, b.1), f.mul(a.0, b.0)))
    }
}

/// Whether `e` is zero by meaning.
#[must_use]
pub fn zero_test(arena: &Arena, e: Expr) -> ZeroTest {
    match arena.node(e) {
        Node::Number(value) => return if value.is_zero() { ZeroTest::Zero } else { ZeroTest::NonZero },
        Node::Symbol(_) | Node::Pi => return ZeroTest::NonZero,
        _ => {}
    }
    let parts = arena.reachable(&[e]);
    let opaque = !independent(arena, &parts);
    let denominators = angle_denominators(arena, &parts);
    let mut generator = seeded(arena, &parts);
    let fields = [Field::random(&mut generator), Field::random(&mut generator)];
    let mut evaluated = 0;
    // √x² is x or −x, evenly: each point sees a wrong sign with probability 1/2 only.
    let roots = count_roots(arena, &parts).min(MOST_ROOTS);
    let wanted = if roots == 0 { POINTS } else { POINTS_WITH_ROOTS << roots };
    // A point where a root or an inverse does not exist is drawn again.
    // The sign of a number's root hangs on the prime alone: then each point has a prime of its own.
    let primes = if roots > 0 && has_roots_of_numbers(arena, &parts) { 1 } else { 8 };
    let mut fresh = fields[0];
    for attempt in 0..(WORK / parts.len()).clamp(8, 400 * wanted) {
        if roots > 0 && attempt % primes == 0 {
            fresh = Field::random(&mut generator);
        }
        let field = if roots > 0 { fresh } else { fields[evaluated % 2] };
        let point = Point { field, seed: generator.next() };
        match values_at(arena, &parts, &denominators, &point).map(|values| values[&e]) {
            Some(0) => evaluated += 1,
            Some(_) => return if opaque { ZeroTest::Undecided } else { ZeroTest::NonZero },
            None => {}
        }
        if evaluated == wanted {
            return ZeroTest::Zero;
        }
    }
    ZeroTest::Undecided
}

/// [`zero_test`], and for a zero the k for which it is wrong with a probability below 2^−k.
#[must_use]
pub fn bounded_zero_test(arena: &Arena, e: Expr) -> (ZeroTest, f64) {
    let parts = arena.reachable(&[e]);
    let exponent = error_exponent(arena, &parts, &angle_denominators(arena, &parts), e);
    let roots = count_roots(arena, &parts);
    let exponent = match roots {
        0 => exponent,
        1..=MOST_ROOTS => exponent.min(63.0),
        _ => 0.0,
    };
    match zero_test(arena, e) {
        // A bound that bounds nothing is no answer.
        ZeroTest::Zero if exponent < 32.0 => (ZeroTest::Undecided, exponent),
        answer => (answer, exponent),
    }
}

/// How many different square roots and absolute values occur.
fn count_roots(arena: &Arena, parts: &[Expr]) -> u32 {
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

/// Whether a square root of a number occurs that is no rational.
fn has_roots_of_numbers(arena: &Arena, parts: &[Expr]) -> bool {
    parts.iter().any(|p| match arena.node(*p) {
        Node::Apply(Function::Sqrt | Function::Abs | Function::Sign, argument) => {
            arena.reachable(&[*argument]).iter().all(|inner| arena.symbol_name(*inner).is_none())
        }
        _ => false,
    })
}

/// Whether square roots or absolute values occur among these terms.
#[must_use]
pub fn has_roots(arena: &Arena, parts: &[Expr]) -> bool {
    let root = |p: &Expr| matches!(arena.node(*p), Node::Apply(Function::Sqrt | Function::Abs | Function::Sign, _));
    parts.iter().any(root)
}

/// Whether no relation between the atoms is unknown here, so that a non-zero residue proves something.
///
/// Symbols are independent of one another, of π and of any one transcendental number; sines of base angles are
/// too, as long as the angles are polynomials (Ax 1971). Square roots are no atoms but evaluated. Other functions may be
/// anything, and so may sines of numbers beside π, or of multiples of π that have no roots for values.
#[must_use]
pub fn independent(arena: &Arena, parts: &[Expr]) -> bool {
    let (mut pi_outside, mut numbers_inside) = (false, false);
    let mut inside_only: rustc_hash::FxHashSet<Expr> = rustc_hash::FxHashSet::default();
    for part in parts {
        match arena.node(*part) {
            Node::Apply(Function::Sin | Function::Cos, argument) => {
                for (atom, k) in angle_atoms(arena, *argument) {
                    match arena.node(atom) {
                        Node::Symbol(_) => {}
                        Node::Number(_) => numbers_inside = true,
                        Node::Pi if k.small().is_some_and(|(_, d)| 12 % d == 0) => {
                            inside_only.insert(*argument);
                        }
                        Node::Product(factors)
                            if factors.iter().all(|(base, n)| *n > 0 && arena.symbol_name(*base).is_some()) => {}
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

/// Whether a term stands inside a sine or cosine among these.
fn is_angle(arena: &Arena, parts: &[Expr], e: Expr) -> bool {
    parts.iter().any(|p| matches!(arena.node(*p), Node::Apply(Function::Sin | Function::Cos, inner) if *inner == e))
}

/// For each atom inside the angles: the least common denominator of its coefficients.
fn angle_denominators(arena: &Arena, parts: &[Expr]) -> FxHashMap<Expr, i64> {
    let mut denominators: FxHashMap<Expr, i64> = FxHashMap::default();
    for part in parts {
        if let Node::Apply(Function::Sin | Function::Cos, argument) = arena.node(*part) {
            for (atom, k) in angle_atoms(arena, *argument) {
                let d = k.small().map_or(1, |(_, d)| d);
                let known = denominators.entry(atom).or_insert(1);
                if *known == 0 {
                    continue;
                }
                // A base angle too fine for a word: no point can be drawn, and the test is undecided.
                let product = (*known / known.gcd(&d)).checked_mul(d);
                *known = product.unwrap_or(0);
            }
        }
    }
    denominators
}

/// The residue of every part at a point; `None` where an inverse or a root does not exist.
fn values_at(
    arena: &Arena,
    parts: &[Expr],
    denominators: &FxHashMap<Expr, i64>,
    point: &Point,
) -> Option<FxHashMap<Expr, u64>> {
    let f = point.field;
    // An angle's constant part counts as a multiple of the atom 1, which need not be among the parts.
    let mut values: FxHashMap<Expr, u64> = FxHashMap::from_iter([(Expr::ONE, 1)]);
    for &e in parts {
        let value = match arena.node(e) {
            Node::Number(value) => f.rational(value)?,
            Node::Symbol(id) => {
                let residue = point.residue(("symbol", &arena.symbol_names()[*id as usize]));
                if arena.is_positive(e) { f.mul(residue, residue) } else { residue }
            }
            Node::Pi => point.residue("pi"),
            Node::Sum(constant, terms) => {
                let mut sum = f.rational(constant)?;
                for (term, k) in terms {
                    sum = f.add(sum, f.mul(f.rational(k)?, values[term]));
                }
                sum
            }
            Node::Product(factors) => {
                let mut product = 1;
                for (base, n) in factors {
                    product = f.mul(product, f.power(values[base], *n)?);
                }
                product
            }
            Node::Apply(Function::Sqrt, argument) => f.root(values[argument])?,
            // |x| = √x²: x or −x, whichever is a square. So |a| |b| = |a b|.
            Node::Apply(Function::Abs, argument) => f.root(f.mul(values[argument], values[argument]))?,
            Node::Apply(Function::Sign, argument) => {
                let x = values[argument];
                f.mul(f.root(f.mul(x, x))?, f.inverse(x)?)
            }
            Node::Apply(function @ (Function::Sin | Function::Cos), argument) => {
                let mut angle = (0, 1);
                for (atom, k) in angle_atoms(arena, *argument) {
                    let denominator = denominators[&atom];
                    if denominator == 0 {
                        return None;
                    }
                    let (base, parts) = if *arena.node(atom) == Node::Pi && 12 % denominator == 0 {
                        (point.twelfth()?, 12)
                    } else {
                        // The base angle atom/denominator is named by its residue: equal by meaning, equal here.
                        let name = f.mul(values[&atom], f.inverse(u64::try_from(denominator).ok()?)?);
                        (point.base(name)?, denominator)
                    };
                    let multiple = k.mul(&Rational::integer(parts)).to_i64()?;
                    angle = point.turn(angle, point.multiple(base, multiple));
                }
                if *function == Function::Sin { angle.0 } else { angle.1 }
            }
            Node::Apply(function, argument) => point.residue((*function, values[argument])),
        };
        values.insert(e, value);
    }
    Some(values)
}

/// The residues of terms at random points, each modulo another prime: `count` of them, fewer where there are no values.
pub(super) fn residues(arena: &Arena, terms: &[Expr], count: usize) -> Vec<(Field, FxHashMap<Expr, u64>)> {
    let parts = arena.reachable(terms);
    let denominators = angle_denominators(arena, &parts);
    let mut generator = seeded(arena, &parts);
    let mut found = Vec::new();
    for _ in 0..100 * count {
        let point = Point { field: Field::random(&mut generator), seed: generator.next() };
        let Some(values) = values_at(arena, &parts, &denominators, &point) else { continue };
        found.push((point.field, values));
        if found.len() == count {
            break;
        }
    }
    found
}

/// A generator seeded with the terms, by the names of their symbols and not by their handles.
fn seeded(arena: &Arena, parts: &[Expr]) -> Generator {
    let mut hashes: FxHashMap<Expr, u64> = FxHashMap::default();
    let mut all = 0_u64;
    for part in parts {
        let mut hasher = FxHasher::default();
        match arena.node(*part) {
            Node::Number(value) => ("number", value).hash(&mut hasher),
            Node::Symbol(id) => ("symbol", &arena.symbol_names()[*id as usize]).hash(&mut hasher),
            Node::Pi => "pi".hash(&mut hasher),
            Node::Sum(constant, terms) => {
                ("sum", constant).hash(&mut hasher);
                // In no order: handles differ from run to run, meanings do not.
                unordered(terms.iter().map(|(term, k)| (hashes[term], k))).hash(&mut hasher);
            }
            Node::Product(factors) => {
                ("product", unordered(factors.iter().map(|(base, n)| (hashes[base], n)))).hash(&mut hasher);
            }
            Node::Apply(f, argument) => (*f, hashes[argument]).hash(&mut hasher),
        }
        let hash = Generator(hasher.finish()).next();
        all = all.wrapping_add(hash);
        hashes.insert(*part, hash);
    }
    Generator(all)
}

/// One hash for all items, whatever their order.
fn unordered(items: impl Iterator<Item = impl Hash>) -> u64 {
    items.fold(0, |sum: u64, item| {
        let mut hasher = FxHasher::default();
        item.hash(&mut hasher);
        sum.wrapping_add(Generator(hasher.finish()).next())
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::parse::parse_free;

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
        ] {
            assert_eq!(test(text), ZeroTest::NonZero, "{text}");
        }
    }

    #[test]
    fn functions_without_rules_are_left_undecided() {
        assert_eq!(test("exp(a)*exp(b) - exp(a + b)"), ZeroTest::Undecided);
        assert_eq!(test("sin(q + pi/5)^2 + cos(q + pi/5)^2 - 1"), ZeroTest::Zero);
        assert_eq!(test("sin(q/4000000007)*cos(q/5000000029) - sin(q)"), ZeroTest::Undecided);
        assert_eq!(test("sin(pi/5)^2 - (5 - sqrt(5))/8"), ZeroTest::Undecided);
    }
}
