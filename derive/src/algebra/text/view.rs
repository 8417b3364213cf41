//! A formula as a tree of marks, from which all notations, and code generation, are written.
//!
//! Factors and terms stand in the order in which their symbols were declared; sums stand last; sin x /
//! cos x becomes tan x; negative powers become a fraction.

use crate::algebra::{Arena, Expr, Function, Node, Rational};
use rustc_hash::FxHashMap;

/// A formula as a tree of marks, before a notation is chosen: mathematics or program text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum View {
    /// A whole number, not negative.
    Number(String),
    /// A symbol by its name, shown with a subscript if it has one.
    Name(String),
    /// A symbol that is spelled out without a subscript, since another symbol would look like it.
    Word(String),
    /// A term that is shown by the name that [`Shared`] gives it.
    Shared(String),
    /// The number π.
    Pi,
    /// Terms of a sum: true if the term is subtracted, and the term.
    Sum(Vec<(bool, View)>),
    /// Factors of a product.
    Product(Vec<View>),
    /// A fraction: numerator and denominator.
    Fraction(Box<View>, Box<View>),
    /// A power: base and exponent, which is at least 2.
    Power(Box<View>, i32),
    /// A function and its argument; among them `tan` for a quotient of sine and cosine.
    Call(&'static str, Box<View>),
    /// Square root of this formula.
    Root(Box<View>),
    /// Mark for a part left out, since the budget of nodes ended.
    Cut,
}

impl View {
    /// True if the view needs parentheses as a factor.
    pub(in crate::algebra) fn is_loose(&self) -> bool {
        matches!(self, Self::Sum(_))
    }
}

/// Names of the terms that are shown by a name.
pub type Shared = FxHashMap<Expr, String>;

/// Tree of marks of the term `e`. Terms in `shared`, other than `e` itself, are shown by their names; after `budget`
/// nodes the tree is cut.
#[must_use]
pub fn view(arena: &Arena, e: Expr, shared: &Shared, budget: usize) -> View {
    Viewer { arena, ranks: ranks(arena, e), shared, left: budget }.expand(e)
}

/// Order of a term among factors: (latest symbol in it, kind of node, handle).
type Rank = (u32, u8, Expr);

fn ranks(arena: &Arena, e: Expr) -> FxHashMap<Expr, Rank> {
    let mut ranks: FxHashMap<Expr, Rank> = FxHashMap::default();
    for part in arena.shown(&[e]) {
        let kind = match arena.node(part) {
            Node::Number(_) | Node::Pi => 0,
            Node::Symbol(_) => 1,
            Node::Named(_, term) => {
                if arena.written_name(part).is_some() {
                    1
                } else {
                    ranks[term].1
                }
            }
            Node::Apply(f, _) => 2 + *f as u8,
            Node::Product(_) => 30,
            Node::Sum(..) => 40,
        };
        let latest = match arena.node(part) {
            Node::Symbol(id) => id + 1,
            Node::Named(..) if arena.written_name(part).is_some() => u32::MAX,
            _ => arena.operands(part).map(|o| ranks[&o].0).max().unwrap_or(0),
        };
        ranks.insert(part, (latest, kind, part));
    }
    ranks
}

struct Viewer<'a> {
    arena: &'a Arena,
    ranks: FxHashMap<Expr, Rank>,
    shared: &'a Shared,
    left: usize,
}

impl Viewer<'_> {
    fn view(&mut self, e: Expr) -> View {
        match self.shared.get(&e) {
            Some(name) => View::Shared(name.clone()),
            None => self.expand(e),
        }
    }

    fn expand(&mut self, e: Expr) -> View {
        if self.left == 0 {
            return View::Cut;
        }
        self.left -= 1;
        match self.arena.node(e).clone() {
            Node::Number(value) => {
                let (negative, magnitude) = self.quotient(&value, Vec::new());
                if negative { View::Sum(vec![(true, magnitude)]) } else { magnitude }
            }
            Node::Symbol(_) => View::Name(self.arena.symbol_name(e).unwrap_or_default().to_owned()),
            Node::Named(_, term) => match self.arena.written_name(e) {
                Some(name) => View::Name(name.to_owned()),
                // A name that was never written down is defined nowhere.
                None => self.view(term),
            },
            Node::Pi => View::Pi,
            Node::Apply(Function::Sqrt, argument) => View::Root(Box::new(self.view(argument))),
            Node::Apply(f, argument) => View::Call(f.name(), Box::new(self.view(argument))),
            Node::Product(factors) => self.quotient(&Rational::ONE, factors.to_vec()).1,
            Node::Sum(constant, terms) => {
                let mut ordered = terms.to_vec();
                ordered.sort_by_cached_key(|(term, _)| self.monomial_rank(*term));
                let mut parts = Vec::new();
                if !constant.is_zero() {
                    parts.push(self.scaled(&constant, Expr::ONE));
                }
                for (term, k) in &ordered {
                    parts.push(self.scaled(k, *term));
                }
                if parts.len() == 1 && !parts[0].0 {
                    return parts.remove(0).1;
                }
                positive_first(&mut parts);
                View::Sum(parts)
            }
        }
    }

    /// Order of terms in a sum: by their factors, the latest declared first. So a linear form stands in the order of
    /// its variables.
    fn monomial_rank(&self, term: Expr) -> Vec<(Rank, i32)> {
        let mut ranks: Vec<_> = match self.arena.node(term) {
            Node::Product(factors) => factors.iter().map(|(base, n)| (self.ranks[base], -n)).collect(),
            _ => vec![(self.ranks[&term], -1)],
        };
        ranks.sort_unstable();
        ranks.reverse();
        ranks
    }

    /// Product k · e as (true if negative, view of the absolute value).
    fn scaled(&mut self, k: &Rational, e: Expr) -> (bool, View) {
        let factors: Vec<(Expr, i32)> = match self.arena.node(e) {
            Node::Product(factors) if !self.shared.contains_key(&e) => factors.to_vec(),
            _ if e == Expr::ONE => Vec::new(),
            _ => vec![(e, 1)],
        };
        self.quotient(k, factors)
    }

    /// Product k · Π base^exponent as (true if negative, view of the absolute value).
    fn quotient(&mut self, k: &Rational, mut factors: Vec<(Expr, i32)>) -> (bool, View) {
        factors.sort_by_key(|(base, _)| self.ranks.get(base).copied());
        let magnitude = if k.is_negative() { k.neg() } else { k.clone() };
        let (numerator, denominator) = match magnitude.to_string().split_once('/') {
            Some((n, d)) => (n.to_owned(), d.to_owned()),
            None => (magnitude.to_string(), "1".to_owned()),
        };
        let (mut above, mut below) = (Vec::new(), Vec::new());
        let mut negative = k.is_negative();
        let tangents = self.take_tangents(&mut factors);
        // Symbols first, then functions, then sums: `u4 sin q1` cannot be misread, `sin q1 u4` can.
        let class = |e: Expr| match self.arena.node(e) {
            Node::Apply(..) => 1,
            Node::Sum(..) => 2,
            _ => 0,
        };
        let mut ordered: Vec<(u8, Expr, i32, bool)> =
            factors.into_iter().map(|(base, n)| (class(base), base, n, false)).collect();
        ordered.extend(tangents.into_iter().map(|(angle, n)| (1, angle, n, true)));
        ordered.sort_by_key(|(class, ..)| *class);
        for (_, base, n, tangent) in ordered {
            let mut view = self.view(base);
            // −a (5 c − 6) is a (6 − 5 c).
            if let View::Sum(parts) = &mut view
                && negative
                && n % 2 != 0
                && parts.iter().any(|(subtracted, _)| *subtracted)
            {
                for (subtracted, _) in parts.iter_mut() {
                    *subtracted = !*subtracted;
                }
                positive_first(parts);
                negative = false;
            }
            let view = if tangent { View::Call("tan", Box::new(view)) } else { view };
            let side = if n > 0 { &mut above } else { &mut below };
            side.push(if n.abs() == 1 { view } else { View::Power(Box::new(view), n.abs()) });
        }
        if numerator != "1" || above.is_empty() {
            above.insert(0, View::Number(numerator));
        }
        if denominator != "1" {
            below.insert(0, View::Number(denominator));
        }
        let one = |mut views: Vec<View>| if views.len() == 1 { views.remove(0) } else { View::Product(views) };
        let view =
            if below.is_empty() { one(above) } else { View::Fraction(Box::new(one(above)), Box::new(one(below))) };
        (negative, view)
    }

    /// Takes tangents sin^n·cos^−n out of the factors, and returns them as (angle, n).
    fn take_tangents(&self, factors: &mut Vec<(Expr, i32)>) -> Vec<(Expr, i32)> {
        let mut tangents = Vec::new();
        for at in 0..factors.len() {
            let (base, n) = factors[at];
            let Node::Apply(Function::Sin, angle) = *self.arena.node(base) else { continue };
            let partner = factors
                .iter()
                .position(|(e, _)| matches!(self.arena.node(*e), Node::Apply(Function::Cos, a) if *a == angle));
            if let Some(partner) = partner
                && n.signum() == -factors[partner].1.signum()
            {
                let power = n.signum() * n.abs().min(factors[partner].1.abs());
                factors[at].1 -= power;
                factors[partner].1 += power;
                tangents.push((angle, power));
            }
        }
        factors.retain(|(_, n)| *n != 0);
        tangents
    }
}

/// Moves the first positive term of a sum to its front: a sum that begins with a minus is harder to read.
fn positive_first(parts: &mut Vec<(bool, View)>) {
    if let Some(at) = parts.iter().position(|(negative, _)| !negative)
        && parts[0].0
    {
        let first = parts.remove(at);
        parts.insert(0, first);
    }
}
