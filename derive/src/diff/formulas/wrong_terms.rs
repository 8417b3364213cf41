//! Wrong terms of a printed sum, each with its right value.
//!
//! Invariant: if every listed term is corrected, the printed value equals the derived value. A long list is replaced
//! with an empty list. Each term of the difference is assigned to the printed term of which it is a numerical multiple.
//! If there is no such printed term, the term is missing in print.

use super::ratio::numerical_ratio;
use crate::algebra::form::simplify::Simplifier;
use crate::algebra::text::print::print_text;
use crate::algebra::{Arena, Expr, Node, Rational};
use crate::diff::repairs::MistakeKind;

/// Largest number of wrong terms that are listed for one printed sum.
const MOST: usize = 3;
/// Half of the longest description of a wrong term, in bytes.
const LONGEST: usize = 80;

/// Mistake in a single term of a printed sum.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WrongTerm {
    /// Printed term that should not be there.
    Extra(Expr),
    /// Wrong printed term, and the right term for its place.
    Other(Expr, Expr),
    /// Derived term that is not printed.
    Missing(Expr),
}

impl WrongTerm {
    /// Kind of the mistake: an extra term, a lost term, a sign or a number.
    pub fn slip(self, arena: &mut Arena) -> MistakeKind {
        match self {
            Self::Extra(_) => MistakeKind::ExtraTerm,
            Self::Missing(_) => MistakeKind::LostTerm,
            Self::Other(own, right) => {
                if arena.neg(own) == right {
                    MistakeKind::Sign
                } else {
                    MistakeKind::Number
                }
            }
        }
    }

    /// Terms that the mistake mentions: the printed term, the right term, or both.
    pub fn parts(&self) -> impl Iterator<Item = Expr> {
        let (first, second) = match *self {
            Self::Extra(e) | Self::Missing(e) => (e, None),
            Self::Other(own, right) => (own, Some(right)),
        };
        std::iter::once(first).chain(second)
    }

    /// Description of the mistake, in words.
    pub fn words(self, arena: &Arena) -> String {
        match self {
            Self::Extra(own) => format!("the term {} should not be there", print_text(arena, own)),
            Self::Other(own, right) => {
                format!("the term {} should be {}", print_text(arena, own), print_text(arena, right))
            }
            Self::Missing(term) => format!("the term {} is missing", print_text(arena, term)),
        }
    }
}

/// Wrong terms of a printed sum; `difference` is printed − derived.
/// Returns an empty list if there are more than three wrong terms, or if a term is long.
pub fn wrong_terms(arena: &mut Arena, simplifier: &mut Simplifier, printed: Expr, difference: Expr) -> Vec<WrongTerm> {
    let (printed, wrong) = (terms_multiplied_out(arena, printed), terms_multiplied_out(arena, difference));
    if printed.len() < 2 || wrong.len() > MOST {
        return Vec::new();
    }
    let mut found = Vec::new();
    for term in wrong {
        let own = printed.iter().find_map(|own| Some((*own, numerical_ratio(arena, simplifier, term, *own)?)));
        // With term = k own, the right term is own − term. It vanishes if k = 1.
        found.push(match own {
            Some((own, k)) if k.is_one() => WrongTerm::Extra(own),
            Some((own, k)) => WrongTerm::Other(own, arena.scale(own, &Rational::ONE.add(&k.neg()))),
            None => WrongTerm::Missing(arena.neg(term)),
        });
    }
    if found.iter().any(|term| term.words(arena).len() > 2 * LONGEST) { Vec::new() } else { found }
}

/// Terms of a sum, multiplied out if other factors multiply it; `e` itself if it is no sum.
pub fn terms_multiplied_out(arena: &mut Arena, e: Expr) -> Vec<Expr> {
    let scaled = |arena: &mut Arena, terms: &[(Expr, Rational)], constant: &Rational| {
        let mut list: Vec<Expr> = terms.iter().map(|(term, k)| arena.scale(*term, k)).collect();
        if !constant.is_zero() {
            list.push(arena.number(constant.clone()));
        }
        list
    };
    match arena.node(e).clone() {
        Node::Sum(constant, terms) if terms.len() == 1 && constant.is_zero() => {
            let (term, k) = terms[0].clone();
            terms_multiplied_out(arena, term).into_iter().map(|part| arena.scale(part, &k)).collect()
        }
        Node::Sum(constant, terms) => scaled(arena, &terms, &constant),
        Node::Product(factors) => {
            let sum = factors.iter().position(|(base, n)| *n == 1 && matches!(arena.node(*base), Node::Sum(..)));
            let Some(at) = sum else { return vec![e] };
            let Node::Sum(constant, terms) = arena.node(factors[at].0).clone() else { return vec![e] };
            let Some(rest) = arena.div(e, factors[at].0) else { return vec![e] };
            scaled(arena, &terms, &constant).into_iter().map(|part| arena.mul(part, rest)).collect()
        }
        _ => vec![e],
    }
}
