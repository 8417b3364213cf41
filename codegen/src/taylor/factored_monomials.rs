//! Other forms of a sum of products, with fewer products of factors that change in time.
//!
//! A sum is expanded, and common factors are taken out again, the most frequent factor first: a multivariate Horner
//! scheme. If several factors are equally frequent, their order changes the number of products, so there are several
//! forms to choose from.
//!
//! `simplify` factors for the shortest text, and `sharing` for few operations. Here only products of factors that
//! change in time count, and terms keep the order in which they occur. Every form is equal to the sum by the rules of
//! a commutative ring alone. Trigonometric identities are deliberately not used.

use rustc_hash::{FxHashMap, FxHashSet};
use tripos_derive::algebra::form::polynomial::multiply_monomials;
use tripos_derive::algebra::{Arena, Expr, Node, Rational};

/// Largest number of products in a sum that is expanded. A longer sum is not changed.
const LONGEST: usize = 200;
/// Highest power of a sum up to which the power is expanded.
const HIGHEST: i32 = 3;

/// Choice of the factor that is taken out first among factors that are equally frequent.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Preference {
    /// The factor that was built first in the arena.
    Early,
    /// The factor that was built last in the arena.
    Late,
    /// Function values, such as sin q1, before other factors.
    Functions,
    /// States, such as q1, before other factors.
    Symbols,
}

impl Preference {
    /// List of all preferences, in the order in which they are tried.
    pub const ALL: [Self; 4] = [Self::Early, Self::Late, Self::Functions, Self::Symbols];
}

/// Monomial: a coefficient times powers of terms (its bases).
#[derive(Clone, Debug, PartialEq, Eq)]
struct Monomial {
    /// Rational coefficient by which the powers are multiplied.
    coefficient: Rational,
    /// Bases with their exponents, sorted by base.
    powers: Vec<(Expr, i32)>,
}

/// Term that occurs in monomials as a factor or as a divisor.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
struct Factor {
    base: Expr,
    is_divisor: bool,
}

impl Monomial {
    /// Returns the monomial base^n with the coefficient 1.
    fn of(base: Expr, n: i32) -> Self {
        Self { coefficient: Rational::ONE, powers: vec![(base, n)] }
    }

    /// Returns the product of two monomials.
    fn times(&self, other: &Self) -> Self {
        Self {
            coefficient: self.coefficient.mul(&other.coefficient),
            powers: multiply_monomials(&self.powers, &other.powers),
        }
    }

    /// Returns the exponent of a factor or divisor in the monomial, as a positive number. It is 0 if the monomial
    /// does not contain the factor or divisor.
    fn exponent(&self, factor: Factor) -> i32 {
        let found = self.powers.iter().find(|(base, _)| *base == factor.base).map_or(0, |(_, n)| *n);
        if factor.is_divisor { (-found).max(0) } else { found.max(0) }
    }
}

/// Returns the different forms of the term `e`, at most one for each preference, without `e` itself. `varying` are
/// the terms that change in time.
pub fn factored_forms(arena: &mut Arena, varying: &FxHashSet<Expr>, e: Expr) -> Vec<Expr> {
    let Some(sum) = expand_into_monomials(arena, varying, e) else { return Vec::new() };
    let mut list = Vec::new();
    for preference in Preference::ALL {
        let form = horner(arena, varying, sum.clone(), preference);
        if form != e && !list.contains(&form) {
            list.push(form);
        }
    }
    list
}

/// Returns the form of the term `e` for one preference. It is `e` itself if `e` is too long to be expanded.
pub fn factored_form(arena: &mut Arena, varying: &FxHashSet<Expr>, e: Expr, preference: Preference) -> Expr {
    match expand_into_monomials(arena, varying, e) {
        Some(sum) => horner(arena, varying, sum, preference),
        None => e,
    }
}

/// Expands the term `e` into a sum of monomials. `None` if there are too many monomials. Sums that are constant in
/// time are not expanded.
fn expand_into_monomials(arena: &Arena, varying: &FxHashSet<Expr>, e: Expr) -> Option<Vec<Monomial>> {
    let mut known: FxHashMap<Expr, Vec<Monomial>> = FxHashMap::default();
    for part in arena.reachable(&[e]) {
        let sum = match arena.node(part) {
            Node::Number(value) => vec![Monomial { coefficient: value.clone(), powers: Vec::new() }],
            Node::Product(factors) => {
                let mut product = vec![Monomial { coefficient: Rational::ONE, powers: Vec::new() }];
                for (base, n) in factors {
                    product = times_power(&product, &known[base], *base, *n)?;
                }
                product
            }
            Node::Sum(constant, terms) if varying.contains(&part) => {
                let mut sum = vec![Monomial { coefficient: constant.clone(), powers: Vec::new() }];
                for (term, k) in terms {
                    sum.extend(known[term].iter().map(|m| Monomial { coefficient: m.coefficient.mul(k), ..m.clone() }));
                }
                collect_monomials(sum)
            }
            _ => vec![Monomial::of(part, 1)],
        };
        if sum.len() > LONGEST {
            return None;
        }
        known.insert(part, sum);
    }
    known.remove(&e)
}

/// Multiplies a sum by the power base^n; `inner` is the expansion of the base. `None` if the result has too many
/// monomials.
fn times_power(product: &[Monomial], inner: &[Monomial], base: Expr, n: i32) -> Option<Vec<Monomial>> {
    let (factor, count) = match inner {
        [one] => {
            let powers = one.powers.iter().map(|(base, k)| (*base, k * n)).collect();
            (vec![Monomial { coefficient: one.coefficient.pow(n)?, powers }], 1)
        }
        _ if (1..=HIGHEST).contains(&n) => (inner.to_vec(), n),
        _ => (vec![Monomial::of(base, n)], 1),
    };
    let mut result = product.to_vec();
    for _ in 0..count {
        if result.len() * factor.len() > 4 * LONGEST {
            return None;
        }
        result = collect_monomials(result.iter().flat_map(|a| factor.iter().map(|b| a.times(b))).collect());
    }
    Some(result)
}

/// Returns a sum in which monomials with equal powers are added, and monomials with the coefficient 0 are removed.
fn collect_monomials(sum: Vec<Monomial>) -> Vec<Monomial> {
    let mut place: FxHashMap<Vec<(Expr, i32)>, usize> = FxHashMap::default();
    let mut list: Vec<Monomial> = Vec::new();
    for m in sum {
        match place.get(&m.powers) {
            Some(&at) => list[at].coefficient = list[at].coefficient.add(&m.coefficient),
            None => {
                place.insert(m.powers.clone(), list.len());
                list.push(m);
            }
        }
    }
    list.retain(|m| !m.coefficient.is_zero());
    list
}

/// Returns the term for a sum with common factors taken out. Its nesting depth is at most the
/// number of monomials.
fn horner(arena: &mut Arena, varying: &FxHashSet<Expr>, mut sum: Vec<Monomial>, preference: Preference) -> Expr {
    let common = common_factor(&sum);
    let mut terms = Vec::new();
    divide_by_factor(&mut sum, &common);
    while let Some(factor) = most_frequent(arena, varying, &sum, preference) {
        let (mut with, without): (Vec<Monomial>, Vec<Monomial>) = sum.into_iter().partition(|m| m.exponent(factor) > 0);
        let n = with.iter().map(|m| m.exponent(factor)).min().unwrap_or(1);
        let power = [(factor.base, if factor.is_divisor { -n } else { n })];
        divide_by_factor(&mut with, &power);
        let inner = horner(arena, varying, with, preference);
        let power = arena.pow(factor.base, power[0].1).expect("a divisor is not 0");
        terms.push(arena.mul(power, inner));
        sum = without;
    }
    for m in sum {
        let product = arena.try_product(&m.powers).expect("divisors are not 0");
        terms.push(arena.scale(product, &m.coefficient));
    }
    let sum = arena.sum(&terms);
    let common = arena.try_product(&common).expect("divisors are not 0");
    arena.mul(common, sum)
}

/// Returns the factors that all monomials of a sum have in common, with their exponents. Empty for a single monomial.
fn common_factor(sum: &[Monomial]) -> Vec<(Expr, i32)> {
    let Some(first) = sum.first().filter(|_| sum.len() > 1) else { return Vec::new() };
    let least = |&(base, n): &(Expr, i32)| {
        let least = sum.iter().map(|m| m.exponent(Factor { base, is_divisor: n < 0 })).min().unwrap_or(0);
        (base, if n < 0 { -least } else { least })
    };
    first.powers.iter().map(least).filter(|(_, n)| *n != 0).collect()
}

/// Divides all monomials of a sum by a product of powers.
fn divide_by_factor(sum: &mut [Monomial], factor: &[(Expr, i32)]) {
    let inverse = Monomial { coefficient: Rational::ONE, powers: factor.iter().map(|(base, n)| (*base, -n)).collect() };
    for m in sum {
        *m = m.times(&inverse);
    }
}

/// Returns the factor or divisor that changes in time and occurs in the most monomials. `None` if none occurs in at
/// least two monomials.
fn most_frequent(arena: &Arena, varying: &FxHashSet<Expr>, sum: &[Monomial], preference: Preference) -> Option<Factor> {
    let mut counts: FxHashMap<Factor, usize> = FxHashMap::default();
    for (base, n) in sum.iter().flat_map(|m| &m.powers).filter(|(base, _)| varying.contains(base)) {
        *counts.entry(Factor { base: *base, is_divisor: *n < 0 }).or_default() += 1;
    }
    let rank = |base: Expr| {
        let (function, symbol) =
            (matches!(arena.node(base), Node::Apply(..)), matches!(arena.node(base), Node::Symbol(_)));
        let place = i64::try_from(base.index()).unwrap_or(i64::MAX);
        match preference {
            Preference::Early => (false, -place),
            Preference::Late => (false, place),
            Preference::Functions => (function, -place),
            Preference::Symbols => (symbol, -place),
        }
    };
    let often = counts.into_iter().filter(|(_, count)| *count > 1);
    often.max_by_key(|(factor, count)| (*count, rank(factor.base), factor.is_divisor)).map(|(factor, _)| factor)
}
