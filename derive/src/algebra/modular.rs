//! Is this expression zero by meaning? Exact evaluation modulo random primes.
//!
//! Symbols get random residues, each angle a random point of the unit circle
//! (s = 2t/(1+t²), c = (1−t²)/(1+t²)), square roots the residue that is itself a square, so that
//! √a·√b = √(ab). All of it is arithmetic modulo a 61-bit prime: no rounding. Primes and points come
//! from a generator seeded with the expression's own text, so builds repeat and no fixed prime can
//! be aimed at.
//!
//! A non-zero residue proves that an expression of these atoms is not zero. Zero residues at every
//! point leave an error bound of (degree/p) per point; where square roots occur, 2⁻⁶⁴ in all, since a wrong
//! sign shows at half of the points. Functions other than sine, cosine and square
//! root are taken as independent atoms: with them a non-zero residue proves nothing, and the answer
//! is [`ZeroTest::Undecided`].

use super::elementary::angle_atoms;
use super::{Arena, Expr, Function, Node, Rational};
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::ToPrimitive;
use rustc_hash::{FxHashMap, FxHasher};
use std::hash::{Hash, Hasher};

/// Random points, half of them in each field, at which zeros must be seen.
const POINTS: usize = 4;
/// The same where square roots occur, whose signs are seen with probability 1/2 a point.
const POINTS_WITH_ROOTS: usize = 64;

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

/// A small deterministic generator (`SplitMix64`, Steele, Lea and Flood 2014).
struct Generator(u64);

impl Generator {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }
}

/// Arithmetic modulo a prime below 2^61 that is 3 modulo 4.
#[derive(Clone, Copy)]
struct Field(u64);

impl Field {
    fn random(generator: &mut Generator) -> Self {
        loop {
            let candidate = (1 << 60) | (generator.next() >> 4) | 3;
            if is_prime(candidate) {
                return Self(candidate);
            }
        }
    }

    fn add(self, a: u64, b: u64) -> u64 {
        (a + b) % self.0
    }

    fn sub(self, a: u64, b: u64) -> u64 {
        (a + self.0 - b) % self.0
    }

    fn mul(self, a: u64, b: u64) -> u64 {
        mul_mod(a, b, self.0)
    }

    fn pow(self, a: u64, n: u64) -> u64 {
        pow_mod(a, n, self.0)
    }

    fn inverse(self, a: u64) -> Option<u64> {
        (a != 0).then(|| self.pow(a, self.0 - 2))
    }

    fn power(self, a: u64, n: i32) -> Option<u64> {
        let base = if n < 0 { self.inverse(a)? } else { a };
        Some(self.pow(base, u64::from(n.unsigned_abs())))
    }

    /// The square root that is itself a square; `None` for a non-residue.
    fn root(self, a: u64) -> Option<u64> {
        let root = self.pow(a, self.0.div_ceil(4));
        (self.mul(root, root) == a).then_some(root)
    }

    fn rational(self, value: &Rational) -> Option<u64> {
        let residue = |n: &BigInt| n.mod_floor(&BigInt::from(self.0)).to_u64();
        let big = value.to_big();
        Some(self.mul(residue(big.numer())?, self.inverse(residue(big.denom())?)?))
    }
}

fn mul_mod(a: u64, b: u64, p: u64) -> u64 {
    u64::try_from(u128::from(a) * u128::from(b) % u128::from(p)).expect("below p")
}

fn pow_mod(mut a: u64, mut n: u64, p: u64) -> u64 {
    let mut result = 1;
    a %= p;
    while n > 0 {
        if n & 1 == 1 {
            result = mul_mod(result, a, p);
        }
        a = mul_mod(a, a, p);
        n >>= 1;
    }
    result
}

/// Miller–Rabin with the twelve bases that decide every 64-bit number (Sorenson and Webster 2015).
fn is_prime(n: u64) -> bool {
    let bases = [2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37];
    if bases.iter().any(|b| n.is_multiple_of(*b)) {
        return bases.contains(&n);
    }
    let twos = (n - 1).trailing_zeros();
    bases.iter().all(|&base| {
        let mut x = pow_mod(base, (n - 1) >> twos, n);
        (x == 1 || x == n - 1)
            || (1..twos).any(|_| {
                x = mul_mod(x, x, n);
                x == n - 1
            })
    })
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

    /// (sin, cos) of k times the base angle named by `key`.
    fn circle(&self, key: u64, k: i64) -> Option<(u64, u64)> {
        let f = self.field;
        let t = self.residue(("angle", key));
        let t2 = f.mul(t, t);
        let inverse = f.inverse(f.add(1, t2))?;
        let unit = (f.mul(f.add(t, t), inverse), f.mul(f.sub(1, t2), inverse));
        let (mut result, mut power, mut left) = ((0, 1), unit, k.unsigned_abs());
        while left > 0 {
            if left & 1 == 1 {
                result = self.turn(result, power);
            }
            power = self.turn(power, power);
            left >>= 1;
        }
        Some(if k < 0 { (f.sub(0, result.0), result.1) } else { result })
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
    let opaque = parts.iter().any(|p| match arena.node(*p) {
        Node::Apply(f, _) => !matches!(f, Function::Sin | Function::Cos | Function::Sqrt),
        Node::Pi => true,
        _ => false,
    });
    let denominators = angle_denominators(arena, &parts);
    let mut generator = seeded(arena, &parts);
    let fields = [Field::random(&mut generator), Field::random(&mut generator)];
    let mut evaluated = 0;
    // √x² is x or −x, evenly: each point sees a wrong sign with probability 1/2 only.
    let roots = parts.iter().any(|p| matches!(arena.node(*p), Node::Apply(Function::Sqrt, _)));
    let wanted = if roots { POINTS_WITH_ROOTS } else { POINTS };
    // A point where a root or an inverse does not exist is drawn again.
    for attempt in 0..200 * wanted {
        let point = Point { field: fields[attempt % 2], seed: generator.next() };
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
            Node::Symbol(id) => point.residue(("symbol", *id)),
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
            Node::Apply(function @ (Function::Sin | Function::Cos), argument) => {
                let mut angle = (0, 1);
                for (atom, k) in angle_atoms(arena, *argument) {
                    let denominator = denominators[&atom];
                    if denominator == 0 {
                        return None;
                    }
                    let multiple = k.mul(&Rational::integer(denominator)).to_i64()?;
                    // The base angle atom/denominator is named by its residue: equal by meaning, equal here.
                    let base = f.mul(values[&atom], f.inverse(u64::try_from(denominator).ok()?)?);
                    angle = point.turn(angle, point.circle(base, multiple)?);
                }
                if *function == Function::Sin { angle.0 } else { angle.1 }
            }
            Node::Apply(function, argument) => point.residue((*function, values[argument])),
        };
        values.insert(e, value);
    }
    Some(values)
}

/// The rank of a matrix by meaning.
///
/// The rank at a random point is never above it, and below it only with the probability of a false
/// zero: the largest of several points is returned. `None` if no point could be evaluated.
#[must_use]
pub fn rank(arena: &Arena, matrix: &[Vec<Expr>]) -> Option<Rank> {
    let parts = arena.reachable(&matrix.concat());
    let denominators = angle_denominators(arena, &parts);
    let mut generator = seeded(arena, &parts);
    let mut best: Option<Rank> = None;
    let mut evaluated = 0;
    for _ in 0..400 {
        let point = Point { field: Field::random(&mut generator), seed: generator.next() };
        let Some(values) = values_at(arena, &parts, &denominators, &point) else { continue };
        let rows = matrix.iter().map(|row| row.iter().map(|e| values[e]).collect()).collect();
        let found = eliminate(point.field, rows);
        best = best.max(Some(found));
        evaluated += 1;
        if evaluated == 4 {
            break;
        }
    }
    best
}

/// How many rows of a matrix are independent, and the first that depends on those before it.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct Rank {
    /// Independent rows.
    pub rank: usize,
    /// The first dependent row, if there is one.
    pub dependent: Option<usize>,
}

/// Gaussian elimination row by row: each row is reduced by those before it.
fn eliminate(f: Field, rows: Vec<Vec<u64>>) -> Rank {
    let mut basis: Vec<(usize, Vec<u64>)> = Vec::new();
    let mut dependent = None;
    for (at, mut row) in rows.into_iter().enumerate() {
        for (column, pivot) in &basis {
            let factor = row[*column];
            for (entry, p) in row.iter_mut().zip(pivot) {
                *entry = f.sub(*entry, f.mul(factor, *p));
            }
        }
        match row.iter().position(|x| *x != 0) {
            Some(column) => {
                let inverse = f.inverse(row[column]).unwrap_or(1);
                for x in &mut row {
                    *x = f.mul(*x, inverse);
                }
                basis.push((column, row));
            }
            None => dependent = dependent.or(Some(at)),
        }
    }
    Rank { rank: basis.len(), dependent }
}

fn seeded(arena: &Arena, parts: &[Expr]) -> Generator {
    let mut hasher = FxHasher::default();
    for part in parts {
        arena.node(*part).hash(&mut hasher);
    }
    Generator(hasher.finish())
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
            "sin(q + 1/2)^2 + cos(q + 1/2)^2 - 1",
            "sin(q + 1/2) - sin(q)*cos(1/2) - cos(q)*sin(1/2)",
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
            "sqrt(cos(q)^2) - cos(q)",
            "sin(q) - q + q^3/6",
            "2305843009213693951*a",
            "a - 9223372036854775808*a",
        ] {
            assert_eq!(test(text), ZeroTest::NonZero, "{text}");
        }
    }

    #[test]
    fn rank_sees_dependence_that_no_entry_shows() {
        let mut arena = Arena::new();
        let mut matrix = |texts: [[&str; 2]; 2]| {
            let rows = texts.map(|row| row.map(|t| parse_free(&mut arena, t).unwrap()).to_vec()).to_vec();
            rank(&arena, &rows).unwrap()
        };
        assert_eq!(matrix([["m", "m"], ["m", "m"]]), Rank { rank: 1, dependent: Some(1) });
        let hidden = [["sin(q)", "1"], ["1 - cos(q)^2", "sin(q)"]];
        assert_eq!(matrix(hidden), Rank { rank: 1, dependent: Some(1) });
        assert_eq!(matrix([["0", "1"], ["m", "0"]]), Rank { rank: 2, dependent: None });
    }

    #[test]
    fn functions_without_rules_are_left_undecided() {
        assert_eq!(test("exp(a)*exp(b) - exp(a + b)"), ZeroTest::Undecided);
        assert_eq!(test("sin(q + pi/5)^2 + cos(q + pi/5)^2 - 1"), ZeroTest::Zero);
        assert_eq!(test("sin(q/4000000007)*cos(q/5000000029) - sin(q)"), ZeroTest::Undecided);
        assert_eq!(test("sin(pi/5)^2 - (5 - sqrt(5))/8"), ZeroTest::Undecided);
    }
}
