//! Angles and exponents as sums of whole multiples of base angles.
//!
//! An angle is multiplied out to a sum Σ k · monomial with rational factors k. So the angles q (a + b q) and
//! a q + b q² have the same base angles, and their sines have the same residues.

use crate::algebra::term::elementary::is_exponential;
use crate::algebra::term::fold::FoldOrder;
use crate::algebra::{Arena, Expr, Function, Node, Rational};
use num_integer::Integer;
use rustc_hash::{FxHashMap, FxHashSet};
use std::collections::BTreeMap;

/// Product of powers of terms, as pairs (term, exponent) sorted by handle. The empty product is 1. The terms are
/// symbols, π, functions, and sums that are not multiplied out.
pub(in crate::algebra) type Monomial = Vec<(Expr, i32)>;

/// Sum Σ k · monomial: the factor k of each monomial. No factor is zero.
type AngleSum = BTreeMap<Monomial, Rational>;

/// Largest number of products that are formed when a product of two sums is multiplied out.
const MOST_PRODUCTS: usize = 256;
/// Largest exponent with which a sum is multiplied out.
const LARGEST_POWER: u32 = 16;

/// Base angle: a monomial divided by the common denominator of its factors in all angles and exponents.
pub(in crate::algebra) struct BaseAngle {
    /// Monomial that is divided.
    pub monomial: Monomial,
    /// Least common denominator of the factors of the monomial; 0 if it does not fit a 64-bit integer.
    pub denominator: i64,
    /// True if all terms of the monomial are symbols.
    pub has_only_symbols: bool,
}

/// Angles and exponents of given terms: the arguments of sines, cosines, and of functions made of powers of e.
pub(in crate::algebra) struct Angles {
    /// Base angles of all arguments.
    bases: Vec<BaseAngle>,
    /// Each argument as a sum Σ n · base angle: pairs (index of the base angle, n). `None` if a whole number n does not
    /// fit a 64-bit integer.
    sums: FxHashMap<Expr, Option<Vec<(usize, i64)>>>,
}

impl Angles {
    /// Finds the base angles of all sines, cosines and powers of e among the given terms.
    pub fn new(arena: &Arena, parts: &[Expr]) -> Self {
        let arguments: FxHashSet<Expr> = parts.iter().filter_map(|part| angle_argument(arena, *part)).collect();
        let (mut bases, mut sums) = (Vec::new(), FxHashMap::default());
        if arguments.is_empty() {
            return Self { bases, sums };
        }
        let mut arguments: Vec<Expr> = arguments.into_iter().collect();
        arguments.sort_unstable();
        let angle_sums = angle_sums(arena, &arguments);
        let mut places: FxHashMap<&Monomial, usize> = FxHashMap::default();
        for (monomial, k) in arguments.iter().flat_map(|argument| &angle_sums[argument]) {
            let place = *places.entry(monomial).or_insert_with(|| {
                let has_only_symbols = monomial.iter().all(|(term, _)| arena.symbol_name(*term).is_some());
                bases.push(BaseAngle { monomial: monomial.clone(), denominator: 1, has_only_symbols });
                bases.len() - 1
            });
            let (known, own) = (bases[place].denominator, k.small().map_or(1, |(_, d)| d));
            if known != 0 {
                bases[place].denominator = (known / known.gcd(&own)).checked_mul(own).unwrap_or(0);
            }
        }
        for argument in &arguments {
            let multiples = angle_sums[argument].iter().map(|(monomial, k)| {
                let place = places[monomial];
                let denominator = bases[place].denominator;
                let multiple = k.mul(&Rational::integer(denominator)).to_i64();
                multiple.filter(|_| denominator != 0).map(|multiple| (place, multiple))
            });
            sums.insert(*argument, multiples.collect());
        }
        Self { bases, sums }
    }

    /// Base angle with a given index.
    pub fn base(&self, index: usize) -> &BaseAngle {
        &self.bases[index]
    }

    /// An angle or exponent as a sum Σ n · base angle: pairs (index of the base angle, n). `None` if a base angle or a
    /// multiple n is too large, or if the argument is none of these angles.
    pub fn sum(&self, argument: Expr) -> Option<&[(usize, i64)]> {
        self.sums.get(&argument)?.as_deref()
    }
}

/// Argument of a sine, a cosine or a function made of powers of e; `None` for any other term.
fn angle_argument(arena: &Arena, term: Expr) -> Option<Expr> {
    match arena.node(term) {
        Node::Apply(function, argument)
            if matches!(function, Function::Sin | Function::Cos) || is_exponential(*function) =>
        {
            Some(*argument)
        }
        _ => None,
    }
}

/// Monomials of an angle that is multiplied out, each with its factor.
pub(in crate::algebra) fn monomials(arena: &Arena, angle: Expr) -> Vec<(Monomial, Rational)> {
    angle_sums(arena, &[angle]).remove(&angle).into_iter().flatten().collect()
}

/// Given angles and all their subterms, multiplied out.
fn angle_sums(arena: &Arena, angles: &[Expr]) -> FxHashMap<Expr, AngleSum> {
    let mut sums: FxHashMap<Expr, AngleSum> = FxHashMap::default();
    for e in FoldOrder::new(arena, angles).nodes() {
        let sum = match arena.node(*e) {
            Node::Number(value) => constant(value),
            Node::Named(_, term) => sums[term].clone(),
            Node::Sum(number, terms) => {
                let mut total = constant(number);
                for (term, k) in terms {
                    add_multiple(&mut total, &sums[term], k);
                }
                total
            }
            Node::Product(factors) => product(factors, &sums).unwrap_or_else(|| single(*e)),
            Node::Pi | Node::Symbol(_) | Node::Apply(..) => single(*e),
        };
        sums.insert(*e, sum);
    }
    sums
}

/// Sum of the term `e` alone.
fn single(e: Expr) -> AngleSum {
    AngleSum::from([(vec![(e, 1)], Rational::ONE)])
}

/// Sum of a number alone.
fn constant(value: &Rational) -> AngleSum {
    if value.is_zero() { AngleSum::new() } else { AngleSum::from([(Monomial::new(), value.clone())]) }
}

/// Adds k times a sum to the sum `total`.
fn add_multiple(total: &mut AngleSum, sum: &AngleSum, k: &Rational) {
    for (monomial, own) in sum {
        let own = own.mul(k);
        let whole = match total.get(monomial) {
            Some(known) => known.add(&own),
            None => own,
        };
        if whole.is_zero() {
            total.remove(monomial);
        } else {
            total.insert(monomial.clone(), whole);
        }
    }
}

/// Product of powers of terms, multiplied out. `None` if the result is too long or an exponent is too large.
fn product(factors: &[(Expr, i32)], sums: &FxHashMap<Expr, AngleSum>) -> Option<AngleSum> {
    let mut result = constant(&Rational::ONE);
    for (base, exponent) in factors {
        let sum = &sums[base];
        let power = match single_monomial(sum) {
            Some(monomial) => {
                let powers = monomial.iter().map(|(term, n)| Some((*term, n.checked_mul(*exponent)?)));
                AngleSum::from([(powers.collect::<Option<_>>()?, Rational::ONE)])
            }
            // A sum in a denominator is not divided.
            None if *exponent < 0 => AngleSum::from([(vec![(*base, *exponent)], Rational::ONE)]),
            None if exponent.unsigned_abs() > LARGEST_POWER => return None,
            None => (1..*exponent).try_fold(sum.clone(), |power, _| product_of_two(&power, sum))?,
        };
        result = product_of_two(&result, &power)?;
    }
    Some(result)
}

/// Monomial that is the whole sum; `None` if the sum has another factor than 1 or several monomials.
fn single_monomial(sum: &AngleSum) -> Option<&Monomial> {
    let (monomial, k) = sum.first_key_value().filter(|_| sum.len() == 1)?;
    (*k == Rational::ONE).then_some(monomial)
}

/// Product of two sums, multiplied out. `None` if it takes too many products or an exponent is too large.
fn product_of_two(a: &AngleSum, b: &AngleSum) -> Option<AngleSum> {
    if a.len() * b.len() > MOST_PRODUCTS {
        return None;
    }
    let mut result = AngleSum::new();
    for (left, k) in a {
        for (right, l) in b {
            let mut powers: BTreeMap<Expr, i32> = left.iter().copied().collect();
            for (term, n) in right {
                let power = powers.entry(*term).or_default();
                *power = power.checked_add(*n)?;
            }
            let monomial = powers.into_iter().filter(|(_, n)| *n != 0).collect();
            add_multiple(&mut result, &AngleSum::from([(monomial, k.mul(l))]), &Rational::ONE);
        }
    }
    Some(result)
}
