//! Values of terms at random points of random prime fields.
//!
//! Residues depend on the point and on names alone, never on handles, so that they are the same in every build.

use super::elementary::angle_atoms;
use super::field::{Field, Generator};
use super::{Arena, Expr, Function, Node, Rational};
use num_integer::Integer;
use rustc_hash::{FxBuildHasher, FxHashMap, FxHasher};
use std::hash::{Hash, Hasher};

/// Random points, half of them in each field, at which zeros must be seen.
pub(super) const POINTS: usize = 4;

/// One random point in one field.
pub(super) struct Point {
    /// The field.
    pub field: Field,
    /// What the residues are drawn from.
    pub seed: u64,
}

impl Point {
    /// A residue that depends only on the point and on `key`: equal keys, equal residues.
    fn residue(&self, key: impl Hash) -> u64 {
        let mut hasher = FxHasher::default();
        (self.seed, key).hash(&mut hasher);
        Generator(hasher.finish() ^ self.seed).next() % self.field.prime
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

    /// (sin, cos) of an argument from the values of its atoms; `bases` remembers those of base angles by their names.
    fn angle(
        &self,
        arena: &Arena,
        argument: Expr,
        values: &FxHashMap<Expr, u64>,
        denominators: &FxHashMap<Expr, i64>,
        bases: &mut FxHashMap<u64, (u64, u64)>,
    ) -> Option<(u64, u64)> {
        let f = self.field;
        let mut angle = (0, 1);
        for (atom, k) in angle_atoms(arena, argument) {
            let denominator = denominators[&atom];
            if denominator == 0 {
                return None;
            }
            let (base, parts) = if *arena.node(atom) == Node::Pi && 12 % denominator == 0 {
                (self.twelfth()?, 12)
            } else {
                // The base angle atom/denominator is named by its residue: equal by meaning, equal here.
                let name = f.mul(values[&atom], f.inverse(u64::try_from(denominator).ok()?)?);
                let base = match bases.get(&name) {
                    Some(known) => *known,
                    None => self.base(name)?,
                };
                bases.insert(name, base);
                (base, denominator)
            };
            let multiple = k.mul(&Rational::integer(parts)).to_i64()?;
            angle = self.turn(angle, self.multiple(base, multiple));
        }
        Some(angle)
    }
}

/// For each atom inside the angles: the least common denominator of its coefficients.
pub(super) fn angle_denominators(arena: &Arena, parts: &[Expr]) -> FxHashMap<Expr, i64> {
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
pub(super) fn values_at(
    arena: &Arena,
    parts: &[Expr],
    denominators: &FxHashMap<Expr, i64>,
    point: &Point,
) -> Option<FxHashMap<Expr, u64>> {
    let f = point.field;
    // An angle's constant part counts as a multiple of the atom 1, which need not be among the parts.
    let mut values: FxHashMap<Expr, u64> = FxHashMap::with_capacity_and_hasher(parts.len() + 1, FxBuildHasher);
    values.insert(Expr::ONE, 1);
    // (sine, cosine) of base angles by their names, and of whole angles: most have both in the term.
    let mut bases: FxHashMap<u64, (u64, u64)> = FxHashMap::default();
    let mut angles: FxHashMap<Expr, (u64, u64)> = FxHashMap::default();
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
                let (sine, cosine) = match angles.get(argument) {
                    Some(known) => *known,
                    None => {
                        let angle = point.angle(arena, *argument, &values, denominators, &mut bases)?;
                        angles.insert(*argument, angle);
                        angle
                    }
                };
                if *function == Function::Sin { sine } else { cosine }
            }
            Node::Apply(function, argument) => point.residue((*function, values[argument])),
        };
        values.insert(e, value);
    }
    Some(values)
}

/// The residues of terms at random points, each modulo another prime: at most `count` of them, fewer where there are no
/// values; computed as they are asked for.
pub(super) fn residues<'a>(
    arena: &'a Arena,
    terms: &[Expr],
    count: usize,
) -> impl Iterator<Item = (Field, FxHashMap<Expr, u64>)> + use<'a> {
    let parts = arena.reachable(terms);
    let denominators = angle_denominators(arena, &parts);
    let mut generator = seeded(arena, &parts);
    let points = (0..100 * count).filter_map(move |_| {
        let point = Point { field: Field::random(&mut generator), seed: generator.next() };
        values_at(arena, &parts, &denominators, &point).map(|values| (point.field, values))
    });
    points.take(count)
}

/// A generator seeded with the terms, by the names of their symbols and not by their handles.
pub(super) fn seeded(arena: &Arena, parts: &[Expr]) -> Generator {
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
