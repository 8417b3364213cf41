//! Angles and exponents as sums of whole multiples of base angles.
//!
//! An angle of symbols is multiplied out to a sum Σ k · monomial with rational factors k. So the angles q (a + b q)
//! and a q + b q² have the same base angles, and their sines have the same residues.

use crate::algebra::term::elementary::{angle_atoms, is_exponential};
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

/// Base angle: a monomial divided by the common denominator of its factors in all angles, or in all exponents.
pub(in crate::algebra) struct BaseAngle {
    /// Monomial that is divided.
    pub monomial: Monomial,
    /// Least common denominator of the factors of the monomial; 0 if it does not fit a 64-bit integer.
    pub denominator: i64,
    /// True if the monomial is a product of positive powers of symbols.
    pub is_plain: bool,
}

/// A sum Σ n · base angle: pairs (index of the base angle, n). `None` if a whole number n does not fit a 64-bit
/// integer.
type Multiples = Option<Vec<(usize, i64)>>;

/// Angles and exponents of given terms: the arguments of sines, cosines, and of functions made of powers of e.
pub(in crate::algebra) struct Angles {
    /// Base angles of all arguments.
    bases: Vec<BaseAngle>,
    /// Each argument of a kind of function as a sum of multiples of base angles.
    sums: FxHashMap<(Expr, AngleKind), Multiples>,
}

/// Kind of functions whose arguments are divided into base angles.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(in crate::algebra) enum AngleKind {
    /// Sine and cosine.
    Circular,
    /// The exponential function and the hyperbolic functions.
    Exponential,
}

impl Angles {
    /// Finds the base angles of all sines, cosines and powers of e among the given terms.
    pub fn new(arena: &Arena, parts: &[Expr]) -> Self {
        let arguments: FxHashSet<(Expr, AngleKind)> = parts.iter().filter_map(|part| angle(arena, *part)).collect();
        let mut arguments: Vec<(Expr, AngleKind)> = arguments.into_iter().collect();
        arguments.sort_unstable();
        let mut bases: Vec<BaseAngle> = Vec::new();
        let mut places: FxHashMap<(Monomial, AngleKind), usize> = FxHashMap::default();
        let mut lists = Vec::with_capacity(arguments.len());
        for (argument, kind) in &arguments {
            let mut list = Vec::new();
            for (monomial, k) in angle_terms(arena, *argument, *kind) {
                let place = *places.entry((monomial, *kind)).or_insert_with_key(|(monomial, _)| {
                    let is_plain = monomial.iter().all(|(term, n)| *n > 0 && arena.symbol_name(*term).is_some());
                    bases.push(BaseAngle { monomial: monomial.clone(), denominator: 1, is_plain });
                    bases.len() - 1
                });
                let (known, own) = (bases[place].denominator, k.small().map_or(1, |(_, d)| d));
                if known != 0 {
                    bases[place].denominator = (known / known.gcd(&own)).checked_mul(own).unwrap_or(0);
                }
                list.push((place, k));
            }
            lists.push(list);
        }
        let multiple = |(place, k): &(usize, Rational)| {
            let denominator = Some(bases[*place].denominator).filter(|d| *d != 0)?;
            Some((*place, k.mul(&Rational::integer(denominator)).to_i64()?))
        };
        let sums = lists.iter().map(|list| list.iter().map(multiple).collect());
        let sums = arguments.iter().copied().zip(sums).collect();
        Self { bases, sums }
    }

    /// Base angle with a given index.
    pub fn base(&self, index: usize) -> &BaseAngle {
        &self.bases[index]
    }

    /// An angle or exponent as a sum Σ n · base angle: pairs (index of the base angle, n). `None` if a base angle or a
    /// multiple n is too large, or if the argument is none of these angles.
    pub fn sum(&self, argument: Expr, kind: AngleKind) -> Option<&[(usize, i64)]> {
        self.sums.get(&(argument, kind))?.as_deref()
    }
}

/// Argument of a sine, a cosine or a function made of powers of e, with the kind of the function; `None` for any other
/// term.
pub(in crate::algebra) fn angle(arena: &Arena, term: Expr) -> Option<(Expr, AngleKind)> {
    let Node::Apply(function, argument) = arena.node(term) else { return None };
    if matches!(function, Function::Sin | Function::Cos) {
        return Some((*argument, AngleKind::Circular));
    }
    is_exponential(*function).then_some((*argument, AngleKind::Exponential))
}

/// Terms Σ k · monomial of an angle or exponent, as pairs (monomial, k).
///
/// An angle is multiplied out if it is a polynomial of symbols and π. Any other angle is divided into its printed
/// terms, since functions in it may cancel; the value of such a term identifies it. Exponents are always divided into
/// their printed terms: an exponent in which one is no product of symbols is identified by its value as a whole.
pub(in crate::algebra) fn angle_terms(arena: &Arena, argument: Expr, kind: AngleKind) -> Vec<(Monomial, Rational)> {
    if kind == AngleKind::Circular {
        let sum = angle_sums(arena, &[argument]).remove(&argument).unwrap_or_default();
        let is_known = |term: Expr| arena.symbol_name(term).is_some() || *arena.node(term) == Node::Pi;
        if sum.keys().flatten().all(|(term, _)| is_known(*term)) {
            return sum.into_iter().collect();
        }
    }
    let printed = angle_atoms(arena, argument).into_iter();
    printed.map(|(atom, k)| (monomial_of_atom(arena, atom), k)).collect()
}

/// Monomial of a printed term of an angle: its powers if it is a product of powers of symbols, else the term itself.
fn monomial_of_atom(arena: &Arena, atom: Expr) -> Monomial {
    match arena.node(atom) {
        _ if atom == Expr::ONE => Monomial::new(),
        Node::Product(factors) if factors.iter().all(|(base, _)| arena.symbol_name(*base).is_some()) => {
            let mut powers = factors.to_vec();
            powers.sort_unstable();
            powers
        }
        _ => vec![(atom, 1)],
    }
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
