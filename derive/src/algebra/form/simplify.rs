//! Simplification: shorter forms of terms with equal meaning, for people and for generated code.
//!
//! A term is expanded to a Laurent polynomial in its atoms. Squares of sines or cosines are
//! replaced by sin² + cos² = 1 where fewer terms remain. The result is factored again in Horner
//! form. If it divides by sums, the normal form with one denominator is a candidate too.
//! The shortest candidate is taken. The input is kept unless a candidate is shorter, so the result
//! is never longer. A term that would expand beyond [`Simplifier::LIMIT`] terms, or has more than
//! [`Simplifier::PARTS`] subterms, is returned unchanged.

use super::normal_form::Normalizer;
use super::polynomial::{LaurentPolynomial, Monomial, monomial_expr};
use super::sum_atoms::{SumAtoms, atom_polynomial, differ_beyond_angles, is_plain_product};
use crate::algebra::term::elementary::{angle_atoms, is_sine_or_cosine};
use crate::algebra::{Arena, Expr, Function, Node, Rational};
use rustc_hash::FxHashMap;
use std::collections::BTreeMap;

/// Number of subterms, those behind names included, up to which a term is also brought over a common denominator
/// without its names.
const MOST_NAMED_PARTS: usize = 500;

/// Simplifier of terms. It remembers the result for each term.
#[derive(Clone, Default)]
pub struct Simplifier {
    /// Short form of each term simplified so far.
    memo: FxHashMap<Expr, Expr>,
}

impl Simplifier {
    /// Number of terms of an expanded polynomial above which simplification gives up and keeps the
    /// term.
    pub const LIMIT: usize = 600;
    /// Largest number of multiplications of terms for bringing a term over a common denominator.
    pub const FRACTION_BUDGET: u64 = 20_000;
    /// Largest number of multiplications of terms for expanding sines of multiple angles and sums
    /// of angles.
    pub const ANGLE_BUDGET: u64 = 5_000;
    /// Number of different subterms above which simplification returns a term unchanged.
    pub const PARTS: usize = 5000;

    /// Returns the shortest form of the term `e` that simplification finds; it is never longer than
    /// `e`.
    pub fn simplify(&mut self, arena: &mut Arena, e: Expr) -> Expr {
        if let Some(&done) = self.memo.get(&e) {
            return done;
        }
        if is_plain_product(arena, e) {
            return e;
        }
        let result = self.shortest_form(arena, e);
        self.memo.insert(e, result);
        self.memo.insert(result, result);
        result
    }

    /// Shortest of all candidate forms of a term, the term itself included.
    fn shortest_form(&mut self, arena: &mut Arena, e: Expr) -> Expr {
        let Some(expanded) = self.expand(arena, e) else { return e };
        let reduced = reduce(arena, &expanded);
        if reduced.terms.is_empty() {
            return Expr::ZERO;
        }
        let fraction = if simplifies_as_fraction(arena, &reduced) {
            fraction_in_short_form(arena, e, Self::FRACTION_BUDGET)
        } else if mixes_angles(arena, &reduced) && !differ_beyond_angles(arena, &reduced) {
            fraction_in_short_form(arena, e, Self::ANGLE_BUDGET)
        } else {
            None
        };
        let mut best = (operation_count(arena, e), e);
        let both = [&reduced, &expanded];
        for polynomial in &both[..if reduced == expanded { 1 } else { 2 }] {
            for candidate in [factor(arena, &polynomial.terms), simplify_by_common_factor(arena, polynomial)] {
                let candidate = (operation_count(arena, candidate), candidate);
                if candidate.0 < best.0 {
                    best = candidate;
                }
            }
        }
        match fraction {
            Some(fraction) if fraction == Expr::ZERO || operation_count(arena, fraction) < best.0 => fraction,
            _ => best.1,
        }
    }

    /// Expands the term `e` to a Laurent polynomial in symbols, function values and inverse sums.
    /// `None` beyond `LIMIT` terms or `PARTS` subterms.
    pub fn polynomial(&mut self, arena: &mut Arena, e: Expr) -> Option<LaurentPolynomial> {
        let parts = arena.subterms_up_to_names(&[e]);
        if parts.len() > Self::PARTS {
            return None;
        }
        self.polynomial_over(arena, &parts, &SumAtoms::default())
    }

    /// Expands a term to a polynomial, but keeps sums of symbols whose expansion cannot cancel a
    /// term. `None` beyond `LIMIT` terms or `PARTS` subterms.
    fn expand(&mut self, arena: &mut Arena, e: Expr) -> Option<LaurentPolynomial> {
        let parts = arena.subterms_up_to_names(&[e]);
        if parts.len() > Self::PARTS {
            return None;
        }
        let sums = SumAtoms::new(arena, &parts);
        if !sums.is_empty()
            && let Some(polynomial) = self.polynomial_over(arena, &parts, &sums)
            && sums.expansion_cannot_shorten(arena, &polynomial)
        {
            return Some(polynomial);
        }
        self.polynomial_over(arena, &parts, &SumAtoms::default())
    }

    /// Expands the last term of `parts` to a Laurent polynomial in symbols, function values,
    /// inverse sums and the atoms `sums`. `parts` must contain all subterms of this term, operands
    /// first. `None` beyond [`Self::LIMIT`] terms.
    fn polynomial_over(&mut self, arena: &mut Arena, parts: &[Expr], sums: &SumAtoms) -> Option<LaurentPolynomial> {
        let mut forms: FxHashMap<Expr, LaurentPolynomial> = FxHashMap::default();
        for &part in parts {
            let form = match arena.node(part).clone() {
                _ if sums.contains(part) => atom_polynomial(part),
                Node::Number(value) => LaurentPolynomial::constant(&value),
                Node::Symbol(_) | Node::Pi | Node::Named(..) => atom_polynomial(part),
                Node::Sum(constant, terms) => {
                    let mut sum = LaurentPolynomial::constant(&constant);
                    for (term, k) in &terms {
                        sum.add_scaled(&forms[term], k);
                    }
                    sum
                }
                Node::Product(factors) => {
                    let mut product = LaurentPolynomial::constant(&Rational::ONE);
                    for (base, n) in &factors {
                        let power = if *n < 0 && forms[base].terms.len() != 1 {
                            self.inverse_power(arena, &forms[base], *n)?
                        } else {
                            forms[base].pow(*n, Self::LIMIT)?
                        };
                        product = product.mul(&power, Self::LIMIT)?;
                    }
                    product
                }
                Node::Apply(f, argument) => {
                    let argument = self.short_form(arena, &forms[&argument]);
                    let value = arena.apply(f, argument);
                    LaurentPolynomial::read_sum(arena, value)
                }
            };
            if form.terms.len() > Self::LIMIT {
                return None;
            }
            forms.insert(part, form);
        }
        forms.remove(parts.last()?)
    }

    /// Short form of a polynomial, as a term: squares of sines and cosines are replaced and common
    /// factors taken out, if that saves operations.
    fn short_form(&mut self, arena: &mut Arena, polynomial: &LaurentPolynomial) -> Expr {
        let e = polynomial.expand(arena);
        if let Some(&done) = self.memo.get(&e) {
            return done;
        }
        let reduced = reduce(arena, polynomial);
        let factored = factor(arena, &reduced.terms);
        let result = if operation_count(arena, factored) < operation_count(arena, e) { factored } else { e };
        self.memo.insert(e, result);
        result
    }

    /// Negative power of a polynomial with several terms. The polynomial is simplified to a sum,
    /// which becomes an atom of the result. `None` if this sum is the number 0.
    fn inverse_power(&mut self, arena: &mut Arena, base: &LaurentPolynomial, n: i32) -> Option<LaurentPolynomial> {
        let base = self.short_form(arena, base);
        // The power fails if the divisor is identically zero. Then nothing can be simplified, and
        // the zero test of the caller will find the divisor.
        let power = arena.pow(base, n).ok()?;
        Some(LaurentPolynomial::read_sum(arena, power))
    }
}

/// True if a polynomial of several terms divides by a sum. A common denominator may then be
/// shorter.
fn simplifies_as_fraction(arena: &Arena, polynomial: &LaurentPolynomial) -> bool {
    let inverse_sum = |(e, n): &(Expr, i32)| *n < 0 && matches!(arena.node(*e), Node::Sum(..));
    polynomial.terms.len() > 1 && polynomial.terms.keys().flatten().any(inverse_sum)
}

/// True if an angle of the polynomial occurs both alone and in a multiple or a sum. Terms with sin
/// 2q and sin q, for example, may cancel.
fn mixes_angles(arena: &Arena, polynomial: &LaurentPolynomial) -> bool {
    let mut seen: BTreeMap<Expr, Expr> = BTreeMap::new();
    polynomial
        .angles(arena)
        .into_iter()
        .any(|angle| angle_atoms(arena, angle).into_iter().any(|(atom, _)| *seen.entry(atom).or_insert(angle) != angle))
}

/// Normal form of the term `e` as a fraction, with numerator and factors of the denominator in short form. The shorter
/// one of two is taken: with named terms as generators and, for a term with few subterms, with the terms that the names
/// stand for, which may cancel. `None` if the budget of multiplications is used up.
fn fraction_in_short_form(arena: &mut Arena, e: Expr, budget: u64) -> Option<Expr> {
    let own = short_form_of_fraction(arena, e, Normalizer::for_rewriting(budget));
    let parts = arena.reachable(&[e]);
    if parts.len() > MOST_NAMED_PARTS || !parts.iter().any(|part| arena.named_term_value(*part).is_some()) {
        return own;
    }
    let written_out = short_form_of_fraction(arena, e, Normalizer::new(budget));
    let count = |form: &Expr| operation_count(arena, *form);
    own.into_iter().chain(written_out).min_by_key(count)
}

/// Normal form of the term `e` in the ring of a normalizer, in short form. `None` if its budget is used up.
fn short_form_of_fraction(arena: &mut Arena, e: Expr, mut normalizer: Normalizer) -> Option<Expr> {
    let form = normalizer.normal_form(arena, e)?;
    let short = |arena: &mut Arena, p: &LaurentPolynomial| {
        let reduced = reduce(arena, p);
        factor(arena, &reduced.terms)
    };
    let mut factors = vec![(short(arena, &normalizer.polynomial(&form.numerator)), 1)];
    for (below, n) in &form.denominator {
        let below = short(arena, &normalizer.polynomial(below));
        factors.push((below, -i32::try_from(*n).ok()?));
    }
    arena.try_product(&factors).ok()
}

/// Replaces sin² or cos² by 1 − cos² or 1 − sin² where a shorter polynomial results, angle by
/// angle. A polynomial that is zero by sin² + cos² = 1 becomes empty.
fn reduce(arena: &mut Arena, polynomial: &LaurentPolynomial) -> LaurentPolynomial {
    let mut best = polynomial.clone();
    if !polynomial.terms.keys().flatten().any(|(e, n)| *n >= 2 && is_sine_or_cosine(arena, *e)) {
        return best;
    }
    let mut canonical = polynomial.clone();
    for angle in polynomial.angles(arena) {
        let (sine, cosine) = (arena.apply(Function::Sin, angle), arena.apply(Function::Cos, angle));
        for (from, to) in [(sine, cosine), (cosine, sine)] {
            if best.has_square(from)
                && let Some(traded) = best.replace_squares(from, to, Simplifier::LIMIT)
                && size(arena, &traded) < size(arena, &best)
                && (traded.terms.len() < best.terms.len() || !best.divides_by(from, to))
            {
                best = traded;
            }
        }
        if canonical.has_square(sine)
            && let Some(traded) = canonical.replace_squares(sine, cosine, Simplifier::LIMIT)
        {
            canonical = traded;
        }
    }
    if canonical.terms.len() < best.terms.len() { canonical } else { best }
}

/// Size of a polynomial, as a measure for replacing squares: its number of terms, then its number
/// of different sines and cosines.
fn size(arena: &Arena, polynomial: &LaurentPolynomial) -> (usize, usize) {
    let circular: std::collections::BTreeSet<Expr> =
        polynomial.terms.keys().flatten().map(|(e, _)| *e).filter(|e| is_sine_or_cosine(arena, *e)).collect();
    (polynomial.terms.len(), circular.len())
}

/// Factors a sum of monomials: takes out common factors, then the atom that most terms share,
/// repeatedly. Returns the product as a term.
fn factor(arena: &mut Arena, terms: &BTreeMap<Monomial, Rational>) -> Expr {
    let polynomial = LaurentPolynomial { terms: terms.clone() };
    let (monomial, content, rest) = polynomial.split_common_factor();
    let inner = if rest.terms.len() < 2 {
        rest.expand(arena)
    } else if let Some((atom, positive)) = rest.most_shared_atom() {
        let shares = |m: &Monomial| m.iter().any(|(e, n)| *e == atom && (*n > 0) == positive);
        let (with, without): (BTreeMap<_, _>, BTreeMap<_, _>) = rest.terms.into_iter().partition(|(m, _)| shares(m));
        let (with, without) = (factor(arena, &with), factor(arena, &without));
        arena.add(with, without)
    } else {
        rest.expand(arena)
    };
    scale_by_monomial(arena, &monomial, &content, inner)
}

/// Takes the common factor out of a polynomial and expands the rest. Returns the product as a term.
fn simplify_by_common_factor(arena: &mut Arena, polynomial: &LaurentPolynomial) -> Expr {
    let (monomial, content, rest) = polynomial.split_common_factor();
    let inner = rest.expand(arena);
    scale_by_monomial(arena, &monomial, &content, inner)
}

/// Product monomial · content · inner as a term.
fn scale_by_monomial(arena: &mut Arena, monomial: &Monomial, content: &Rational, inner: Expr) -> Expr {
    let outer = monomial_expr(arena, monomial);
    let product = arena.mul(outer, inner);
    arena.scale(product, content)
}

/// Number of arithmetic operations in a term, the measure of short forms; a function counts as 4. A
/// shared subterm counts once. A named term counts nothing if a document has defined it.
#[must_use]
pub fn operation_count(arena: &Arena, e: Expr) -> usize {
    operation_count_of_all(arena, &[e])
}

/// Number of arithmetic operations in several terms together; a function counts as 4. A shared
/// subterm counts once. A named term counts nothing if a document has defined it, and otherwise as
/// the term that it abbreviates.
#[must_use]
pub fn operation_count_of_all(arena: &Arena, list: &[Expr]) -> usize {
    arena
        .shown_subterms(list)
        .into_iter()
        .map(|part| match arena.node(part) {
            Node::Number(_) | Node::Symbol(_) | Node::Pi | Node::Named(..) => 0,
            Node::Sum(constant, terms) => {
                let plain = Rational::ONE;
                let scaled = terms.iter().filter(|(_, k)| *k != plain && *k != Rational::MINUS_ONE).count();
                terms.len() + scaled - usize::from(constant.is_zero())
            }
            Node::Product(factors) => {
                let exponents: u32 = factors.iter().map(|(_, n)| n.unsigned_abs()).sum();
                exponents as usize - usize::from(factors.iter().all(|(_, n)| *n > 0))
            }
            Node::Apply(..) => 4,
        })
        .sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::text::parse::parse_free;
    use crate::algebra::text::print::print_text;

    fn simplified(input: &str) -> String {
        let mut arena = Arena::new();
        for name in ["M", "R", "g", "q1", "q2", "u1", "u2", "u3"] {
            arena.symbol(name);
        }
        let e = parse_free(&mut arena, input).unwrap();
        let e = Simplifier::default().simplify(&mut arena, e);
        print_text(&arena, e)
    }

    #[test]
    fn short_forms_are_what_a_person_would_write() {
        for (input, expected) in [
            ("cos(q1)^2*M + M*sin(q1)^2", "M"),
            ("M*R^2/4 + M*R^2*tan(q2)^2", "M*R^2*(1 + 4*tan(q2)^2)/4"),
            ("R*u1*u2*(1 + tan(q2)^2) + R*u1*u2", "R*u1*u2*(2 + tan(q2)^2)"),
            ("sin(q1)*(sin(q1)*u1 + cos(q1)*u2) + cos(q1)*(cos(q1)*u1 - sin(q1)*u2)", "u1"),
            ("1/cos(q1)^2 - tan(q1)^2", "1"),
            ("(u1 + u2)^2 - u1^2 - u2^2 - 2*u1*u2", "0"),
            ("u1/(u1 + u2) + u2/(u1 + u2)", "1"),
            ("1/(u1 - u2) - 1/(u1 + u2) - 2*u2/(u1^2 - u2^2)", "0"),
            ("(u1^2 - u2^2)/(u1 - u2) + u2", "u1 + 2*u2"),
            ("u1/(1 + tan(q1)^2) - u1*cos(q1)^2", "0"),
            ("(u1 + u2)*M - u1*M", "M*u2"),
            ("(u1 + u2)*sin(q1)^2 + u1*cos(q1)^2", "u1 + u2*sin(q1)^2"),
            ("M*((u1 + u2)*R*cos(q1) - (u1 + u2)*g*R)", "M*R*(cos(q1) - g)*(u1 + u2)"),
            ("R*sin(q1 - q2) - R*(sin(q1)*cos(q2) - cos(q1)*sin(q2)) + M", "M"),
            ("M*g*sin(q1) + R*u1*(2*sin(q1)*cos(q1) - sin(2*q1))", "M*g*sin(q1)"),
        ] {
            assert_eq!(simplified(input), expected, "{input}");
        }
    }

    #[test]
    fn a_product_of_forty_sums_is_left_alone() {
        let text: Vec<String> = (0..40).map(|i| format!("(a{i} + b{i})")).collect();
        let text = text.join("*");
        let mut arena = Arena::new();
        let e = parse_free(&mut arena, &text).unwrap();
        assert_eq!(Simplifier::default().simplify(&mut arena, e), e);
    }
}
