//! Values of terms at random points of random prime fields.
//!
//! Residues depend on the point and on the names of symbols, never on handles. So every run gives
//! the same residues.

mod point_search;

pub(in crate::algebra) use point_search::PointSearch;

use super::field::{Field, Generator};
use crate::algebra::term::elementary::{angle_atoms, is_exponential};
use crate::algebra::term::fold::{Fold, FoldOrder, Values};
use crate::algebra::{Arena, Expr, Function, Node, Rational};
use num_integer::Integer;
use rustc_hash::{FxHashMap, FxHashSet, FxHasher};
use std::hash::{Hash, Hasher};

/// Number of random points at which a term must be zero to count as zero. Half of the points are in
/// one prime field, half in another.
pub(in crate::algebra) const POINTS: usize = 4;

/// Random point of a prime field. It gives residues to all symbols and to all base angles; the
/// angles in a term are whole multiples of base angles.
#[derive(Clone)]
pub(in crate::algebra) struct ResiduePoint {
    /// Prime field of the residues.
    pub field: Field,
    /// Seed from which the residues of symbols and base angles are drawn.
    seed: u64,
    /// New seed of each symbol whose residue was drawn again.
    redrawn: FxHashMap<Expr, u64>,
}

impl ResiduePoint {
    /// Creates the point of the prime field `field` that belongs to a seed. Equal seeds give equal
    /// points.
    pub fn new(field: Field, seed: u64) -> Self {
        Self { field, seed, redrawn: FxHashMap::default() }
    }

    /// Residue of a symbol at the point, from the symbol's name.
    fn symbol(&self, symbol: Expr, name: &str) -> u64 {
        match self.redrawn.get(&symbol) {
            Some(seed) => self.residue(("redrawn", seed, name)),
            None => self.residue(("symbol", name)),
        }
    }

    /// Residue that depends only on the point and on `key`. Equal keys have equal residues.
    fn residue(&self, key: impl Hash) -> u64 {
        let mut hasher = FxHasher::default();
        (self.seed, key).hash(&mut hasher);
        Generator(hasher.finish() ^ self.seed).next() % self.field.prime
    }

    /// Residues (sin, cos) of the base angle that `key` identifies. `None` if the base angle has no
    /// residues at this point.
    fn base_angle(&self, key: u64) -> Option<(u64, u64)> {
        let f = self.field;
        let t = self.residue(("angle", key));
        let t2 = f.mul(t, t);
        let inverse = f.inverse(f.add(1, t2))?;
        Some((f.mul(f.add(t, t), inverse), f.mul(f.sub(1, t2), inverse)))
    }

    /// Residues (sin, cos) of the angle π/12, which are (√6 − √2)/4 and (√6 + √2)/4. `None` if the
    /// field has no such roots.
    fn sine_and_cosine_of_pi_12(&self) -> Option<(u64, u64)> {
        let f = self.field;
        let (two, three) = (f.root(2)?, f.root(3)?);
        let (six, quarter) = (f.mul(two, three), f.inverse(4)?);
        Some((f.mul(f.sub(six, two), quarter), f.mul(f.add(six, two), quarter)))
    }

    /// Residues (sin, cos) of k times an angle. `unit` is the pair (sin, cos) of the angle itself.
    fn sine_and_cosine_of_multiple(&self, unit: (u64, u64), k: i64) -> (u64, u64) {
        let f = self.field;
        let (mut result, mut power, mut left) = ((0, 1), unit, k.unsigned_abs());
        while left > 0 {
            if left & 1 == 1 {
                result = self.sine_and_cosine_of_sum(result, power);
            }
            power = self.sine_and_cosine_of_sum(power, power);
            left >>= 1;
        }
        if k < 0 { (f.sub(0, result.0), result.1) } else { result }
    }

    /// Residues (sin, cos) of the sum of two angles, each given as (sin, cos).
    fn sine_and_cosine_of_sum(&self, a: (u64, u64), b: (u64, u64)) -> (u64, u64) {
        let f = self.field;
        (f.add(f.mul(a.0, b.1), f.mul(a.1, b.0)), f.sub(f.mul(a.1, b.1), f.mul(a.0, b.0)))
    }

    /// Residue of e to the power of an argument. `None` if it is 0 or a denominator is too large.
    ///
    /// If the argument is a sum of symbols and of products of symbols, the residue follows from
    /// theirs. For any other argument it follows from the argument's residue alone, since the
    /// argument may be written as different sums.
    fn exponential(
        &self,
        arena: &Arena,
        argument: Expr,
        values: &Values<'_, u64>,
        denominators: &FxHashMap<Expr, i64>,
    ) -> Option<u64> {
        let f = self.field;
        let atoms = angle_atoms(arena, argument);
        if !atoms.iter().all(|(atom, _)| is_monomial(arena, *atom)) {
            let (x, opposite) = (values[argument], f.sub(0, values[argument]));
            let base = self.residue(("power", x.min(opposite)));
            return if x <= opposite { Some(base) } else { f.inverse(base) };
        }
        let mut product = 1;
        for (atom, k) in atoms {
            let denominator = denominators[&atom];
            let value = if atom == Expr::ONE { 1 } else { values[atom] };
            let name = f.mul(value, f.inverse(u64::try_from(denominator).ok().filter(|d| *d != 0)?)?);
            let base = self.residue(("exponential", name));
            let multiple = k.mul(&Rational::integer(denominator)).to_i64()?;
            let own = f.pow(base, multiple.unsigned_abs());
            product = f.mul(product, if multiple < 0 { f.inverse(own)? } else { own });
        }
        (product != 0).then_some(product)
    }

    /// Residues (sin, cos) of an angle, from the residues of its atoms. `bases` stores the residues
    /// of base angles for later calls. `None` if the angle has no residues at this point.
    fn angle(
        &self,
        arena: &Arena,
        argument: Expr,
        values: &Values<'_, u64>,
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
                (self.sine_and_cosine_of_pi_12()?, 12)
            } else {
                // A base angle atom/denominator is identified by its residue, so that identically
                // equal angles have equal residues. A constant counts as a multiple of the atom 1,
                // which need not be in `values`.
                let value = if atom == Expr::ONE { 1 } else { values[atom] };
                let name = f.mul(value, f.inverse(u64::try_from(denominator).ok()?)?);
                let base = match bases.get(&name) {
                    Some(known) => *known,
                    None => self.base_angle(name)?,
                };
                bases.insert(name, base);
                (base, denominator)
            };
            let multiple = k.mul(&Rational::integer(parts)).to_i64()?;
            angle = self.sine_and_cosine_of_sum(angle, self.sine_and_cosine_of_multiple(base, multiple));
        }
        Some(angle)
    }
}

/// Least common denominator of the coefficients of each atom, in all angles and exponents among the
/// given terms. It is 0 if it does not fit a 64-bit integer.
pub(in crate::algebra) fn angle_denominators(arena: &Arena, parts: &[Expr]) -> FxHashMap<Expr, i64> {
    let mut denominators: FxHashMap<Expr, i64> = FxHashMap::default();
    for part in parts {
        if let Node::Apply(function, argument) = arena.node(*part)
            && (matches!(function, Function::Sin | Function::Cos) || is_exponential(*function))
        {
            for (atom, k) in angle_atoms(arena, *argument) {
                let d = k.small().map_or(1, |(_, d)| d);
                let known = denominators.entry(atom).or_insert(1);
                if *known == 0 {
                    continue;
                }
                // A denominator that does not fit a 64-bit integer: no point has residues, and the
                // zero test is undecided.
                let product = (*known / known.gcd(&d)).checked_mul(d);
                *known = product.unwrap_or(0);
            }
        }
    }
    denominators
}

/// True if the term `e` is a number, a symbol or a product of positive powers of symbols.
fn is_monomial(arena: &Arena, e: Expr) -> bool {
    match arena.node(e) {
        Node::Number(_) | Node::Symbol(_) => true,
        Node::Product(factors) => factors.iter().all(|(base, n)| *n > 0 && arena.symbol_name(*base).is_some()),
        _ => false,
    }
}

/// Residue of every needed term at a point. `None` if an inverse or a square root does not exist at
/// this point.
pub(in crate::algebra) fn residues_at_point<'n>(
    arena: &Arena,
    needed: &'n FoldOrder,
    denominators: &FxHashMap<Expr, i64>,
    point: &ResiduePoint,
) -> Option<Values<'n, u64>> {
    needed.fold(arena, &mut Residues::new(arena, denominators, point.clone()))
}

/// Rules that compute the residues of terms at a point of a prime field.
pub(in crate::algebra) struct Residues<'a> {
    /// Arena of the terms.
    arena: &'a Arena,
    /// Least common denominator of the coefficients of each atom inside angles; an angle is a sum Σ
    /// k · atom.
    denominators: &'a FxHashMap<Expr, i64>,
    /// Point that gives symbols and base angles their residues.
    point: ResiduePoint,
    /// Sets of symbols whose residues are drawn with another seed than that of the point, each with
    /// its seed.
    moved: &'a [(&'a FxHashSet<Expr>, u64)],
    /// Residues (sine, cosine) of base angles, by the keys that identify these angles. They are
    /// kept because most terms with a sine also contain the cosine.
    bases: FxHashMap<u64, (u64, u64)>,
    /// Residues (sine, cosine) of each angle evaluated so far.
    angles: FxHashMap<Expr, (u64, u64)>,
}

impl<'a> Residues<'a> {
    /// Creates the rules at a point, with the [denominators][angle_denominators] of all angles.
    pub(in crate::algebra) fn new(
        arena: &'a Arena,
        denominators: &'a FxHashMap<Expr, i64>,
        point: ResiduePoint,
    ) -> Self {
        let (bases, angles) = Default::default();
        Self { arena, denominators, point, moved: &[], bases, angles }
    }

    /// Prime field of the residues.
    pub(in crate::algebra) fn field(&self) -> Field {
        self.point.field
    }

    /// Residues (sine, cosine) of an angle whose sine or cosine was already computed; `None` for
    /// any other angle.
    pub(in crate::algebra) fn known_sine_and_cosine(&self, argument: Expr) -> Option<(u64, u64)> {
        self.angles.get(&argument).copied()
    }

    /// Residue of exp, sinh, cosh or tanh of an argument, computed from an exponential. `None` if
    /// the exponential has no residue at this point.
    pub(in crate::algebra) fn exponential(
        &self,
        function: Function,
        argument: Expr,
        of: &Values<'_, u64>,
    ) -> Option<u64> {
        let f = self.point.field;
        let e = self.point.exponential(self.arena, argument, of, self.denominators)?;
        let (back, half) = (f.inverse(e)?, f.inverse(2)?);
        let (sinh, cosh) = (f.mul(half, f.sub(e, back)), f.mul(half, f.add(e, back)));
        Some(match function {
            Function::Sinh => sinh,
            Function::Cosh => cosh,
            Function::Tanh => f.mul(sinh, f.inverse(cosh)?),
            _ => e,
        })
    }

    /// Residues (sine, cosine) of an angle; they are stored for later calls. `None` if the angle
    /// has no residues at this point.
    fn sine_and_cosine(&mut self, argument: Expr, of: &Values<'_, u64>) -> Option<(u64, u64)> {
        if let Some(known) = self.angles.get(&argument) {
            return Some(*known);
        }
        let angle = self.point.angle(self.arena, argument, of, self.denominators, &mut self.bases)?;
        self.angles.insert(argument, angle);
        Some(angle)
    }
}

impl Fold for Residues<'_> {
    type Value = u64;
    fn number(&mut self, value: &Rational) -> Option<u64> {
        self.point.field.residue_of_rational(value)
    }
    fn pi(&mut self) -> Option<u64> {
        Some(self.point.residue("pi"))
    }
    fn symbol(&mut self, symbol: Expr) -> Option<u64> {
        let name = self.arena.symbol_name(symbol)?;
        let residue = match self.moved.iter().find(|(symbols, _)| symbols.contains(&symbol)) {
            Some((_, seed)) => self.point.residue(("moved", seed, name)),
            None => self.point.symbol(symbol, name),
        };
        Some(if self.arena.is_positive(symbol) { self.point.field.mul(residue, residue) } else { residue })
    }
    fn sum(&mut self, constant: &Rational, terms: &[(Expr, Rational)], of: &Values<'_, u64>) -> Option<u64> {
        let f = self.point.field;
        let add = |sum, (term, k): &(Expr, Rational)| Some(f.add(sum, f.mul(f.residue_of_rational(k)?, of[*term])));
        terms.iter().try_fold(f.residue_of_rational(constant)?, add)
    }
    fn product(&mut self, factors: &[(Expr, i32)], of: &Values<'_, u64>) -> Option<u64> {
        let f = self.point.field;
        factors.iter().try_fold(1, |product, (base, n)| Some(f.mul(product, f.signed_power(of[*base], *n)?)))
    }
    fn apply(&mut self, function: Function, argument: Expr, of: &Values<'_, u64>) -> Option<u64> {
        let (f, x) = (self.point.field, of[argument]);
        match function {
            Function::Sin => Some(self.sine_and_cosine(argument, of)?.0),
            Function::Cos => Some(self.sine_and_cosine(argument, of)?.1),
            Function::Sqrt => f.root(x),
            // |x| = √x²: x or −x, whichever is a square. So |a| |b| = |a b|.
            Function::Abs => f.root(f.mul(x, x)),
            Function::Sign => Some(f.mul(f.root(f.mul(x, x))?, f.inverse(x)?)),
            _ if is_exponential(function) => self.exponential(function, argument, of),
            _ => Some(self.point.residue((function, x))),
        }
    }
}

/// Residues of the given terms, in their order, at random points, each modulo another prime: pairs
/// (field, residues). Each point is computed only when the iterator reaches it. The iterator has at
/// most `count` items, and fewer if the terms have no residues at the points tried.
pub(in crate::algebra) fn residues(
    arena: &Arena,
    terms: Vec<Expr>,
    count: usize,
) -> impl Iterator<Item = (Field, Vec<u64>)> + use<'_> {
    let mut draw = PointSearch::new(arena, &terms);
    let points = (0..100 * count).map_while(move |_| {
        let point = draw.point()?;
        let values = draw.values(&point);
        Some(values.map(|values| (point.field, terms.iter().map(|e| values[*e]).collect())))
    });
    points.flatten().take(count)
}

/// Random point of a prime field at which given terms have residues.
pub struct PointWithResidues(ResiduePoint);

impl PointWithResidues {
    /// Finds a random point at which all given terms have residues. Returns it with the residues,
    /// in the order of the terms. `None` if no point was found.
    pub fn new(arena: &Arena, terms: &[Expr]) -> Option<(Self, Vec<u64>)> {
        let mut draw = PointSearch::new(arena, terms);
        (0..100).map_while(|_| draw.point()).find_map(|point| {
            let drawn = Self(point);
            let values = drawn.values(arena, terms)?;
            Some((drawn, values))
        })
    }

    /// Prime field of the point.
    pub fn field(&self) -> Field {
        self.0.field
    }

    /// Residues of further terms at the point, in the order of the terms. `None` if a term has no
    /// residue. Sines and cosines of fractions of an angle agree only within one call.
    pub fn values(&self, arena: &Arena, terms: &[Expr]) -> Option<Vec<u64>> {
        let needed = FoldOrder::new(arena, terms);
        let denominators = angle_denominators(arena, needed.nodes());
        let values = residues_at_point(arena, &needed, &denominators, &self.0)?;
        Some(terms.iter().map(|e| values[*e]).collect())
    }
}

/// Evaluates terms at many points of a prime field. From point to point, chosen symbols get new
/// residues and all other symbols keep theirs.
pub struct ResidueSampler<'a> {
    /// Arena of the terms.
    arena: &'a Arena,
    /// Terms that the sampler evaluates.
    terms: Vec<Expr>,
    /// The terms with all their subterms, in the order of evaluation.
    needed: FoldOrder,
    /// Least common denominator of the coefficients of each atom inside angles; an angle is a sum Σ
    /// k · atom.
    denominators: FxHashMap<Expr, i64>,
    /// Generator of the primes and seeds.
    generator: Generator,
}

impl<'a> ResidueSampler<'a> {
    /// Creates a sampler that evaluates the given terms.
    pub fn new(arena: &'a Arena, terms: Vec<Expr>) -> Self {
        let needed = FoldOrder::new(arena, &terms);
        let (denominators, generator) = (angle_denominators(arena, needed.nodes()), residue_generator(arena, &needed));
        Self { arena, terms, needed, denominators, generator }
    }

    /// Draws a random prime field with the sampler's generator.
    pub fn field(&mut self) -> Field {
        Field::random(&mut self.generator)
    }

    /// Draws the seed of a new random point.
    pub fn seed(&mut self) -> u64 {
        self.generator.next()
    }

    /// Residues of the terms, in their order, at the point that belongs to `seed`. Each set of
    /// symbols in `moved` takes its residues from the seed given with it instead. `None` if a term
    /// has no residue. An angle without moved symbols keeps its sine and cosine.
    pub fn at(&self, field: Field, seed: u64, moved: &[(&FxHashSet<Expr>, u64)]) -> Option<Vec<u64>> {
        let mut residues =
            Residues { moved, ..Residues::new(self.arena, &self.denominators, ResiduePoint::new(field, seed)) };
        let values = self.needed.fold(self.arena, &mut residues)?;
        Some(self.terms.iter().map(|e| values[*e]).collect())
    }
}

/// Generator of random numbers, seeded with the structure of the terms and the names of their
/// symbols. It does not depend on handles, so it gives the same numbers in every run.
pub(in crate::algebra) fn residue_generator(arena: &Arena, needed: &FoldOrder) -> Generator {
    let hashes = needed.fold(arena, &mut Hashes(arena));
    Generator(hashes.iter().flat_map(Values::iter).fold(0, |all: u64, (_, hash)| all.wrapping_add(*hash)))
}

/// Rules that hash terms by their structure and the names of their symbols.
struct Hashes<'a>(&'a Arena);

impl Fold for Hashes<'_> {
    type Value = u64;
    fn number(&mut self, value: &Rational) -> Option<u64> {
        Some(hash_of(("number", value)))
    }
    fn pi(&mut self) -> Option<u64> {
        Some(hash_of("pi"))
    }
    fn symbol(&mut self, symbol: Expr) -> Option<u64> {
        Some(hash_of(("symbol", self.0.symbol_name(symbol)?)))
    }
    fn sum(&mut self, constant: &Rational, terms: &[(Expr, Rational)], of: &Values<'_, u64>) -> Option<u64> {
        // The hash does not depend on the order of terms, because handles differ from run to run.
        Some(hash_of((("sum", constant), order_independent_hash(terms.iter().map(|(term, k)| (of[*term], k))))))
    }
    fn product(&mut self, factors: &[(Expr, i32)], of: &Values<'_, u64>) -> Option<u64> {
        Some(hash_of(("product", order_independent_hash(factors.iter().map(|(base, n)| (of[*base], n))))))
    }
    fn apply(&mut self, f: Function, argument: Expr, of: &Values<'_, u64>) -> Option<u64> {
        Some(hash_of((f, of[argument])))
    }
}

/// Hash of a key, with well-mixed bits.
fn hash_of(key: impl Hash) -> u64 {
    let mut hasher = FxHasher::default();
    key.hash(&mut hasher);
    Generator(hasher.finish()).next()
}

/// Hash of a set of items that does not depend on their order.
fn order_independent_hash(items: impl Iterator<Item = impl Hash>) -> u64 {
    items.fold(0, |sum: u64, item| sum.wrapping_add(hash_of(item)))
}
