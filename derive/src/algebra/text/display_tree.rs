//! Display trees of formulas, from which all notations and generated code are written.
//!
//! Factors and terms are in the order in which their symbols were declared, and sums come last. sin
//! x / cos x becomes tan x; negative powers become a fraction.

use crate::algebra::{Arena, Expr, Function, Node, Rational};
use rustc_hash::FxHashMap;

/// Formula as a display tree: sums, products, fractions and calls in printing order. It is printed
/// in any notation, as mathematics or as program text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum DisplayTree {
    /// A non-negative integer, as its decimal digits.
    Number(String),
    /// A symbol by its name, printed with a subscript if the name has one.
    Name(String),
    /// A symbol printed as a whole word without a subscript, because another symbol would look the
    /// same.
    Word(String),
    /// A term that is shown by a name in place of its formula; the map [`SharedNames`] gives the names.
    Shared(String),
    /// The number π.
    Pi,
    /// A sum: pairs of a flag, true if the term is subtracted, and the term.
    Sum(Vec<(bool, DisplayTree)>),
    /// A product of factors.
    Product(Vec<DisplayTree>),
    /// A fraction of two formulas: numerator and denominator.
    Fraction(Box<DisplayTree>, Box<DisplayTree>),
    /// A power: base and integer exponent, which is at least 2.
    Power(Box<DisplayTree>, i32),
    /// A function call: name and argument. The name `tan` stands for a quotient of sine and cosine.
    Call(&'static str, Box<DisplayTree>),
    /// Square root of a formula.
    Root(Box<DisplayTree>),
    /// Mark for an omitted part, where the limit on the number of nodes was reached.
    Cut,
}

impl DisplayTree {
    /// True if the formula needs parentheses as a factor: only sums do.
    pub(in crate::algebra) fn is_loose(&self) -> bool {
        matches!(self, Self::Sum(_))
    }
}

/// Names of the terms that are shown by a name in place of their formulas.
pub type SharedNames = FxHashMap<Expr, String>;

/// Builds the display tree of the term `e`. Other terms that are in `shared` are shown by their
/// names. After `budget` nodes the rest of the tree is cut.
#[must_use]
pub fn display_tree(arena: &Arena, e: Expr, shared: &SharedNames, budget: usize) -> DisplayTree {
    DisplayTreeBuilder { arena, ranks: display_sort_keys(arena, e), shared, left: budget }.expand(e)
}

/// Sort key of a factor: number of the symbol in it that was declared last, kind of node, handle.
type SortKey = (u32, u8, Expr);

/// Sort keys of the term `e` and of all its subterms that its text shows.
fn display_sort_keys(arena: &Arena, e: Expr) -> FxHashMap<Expr, SortKey> {
    let mut ranks: FxHashMap<Expr, SortKey> = FxHashMap::default();
    for part in arena.shown_subterms(&[e]) {
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

/// State of building a display tree.
struct DisplayTreeBuilder<'a> {
    /// Arena of the terms.
    arena: &'a Arena,
    /// Sort key of each subterm that the formula shows.
    ranks: FxHashMap<Expr, SortKey>,
    /// Terms that are shown by a name in place of their formulas.
    shared: &'a SharedNames,
    /// Number of nodes that may still be added before the tree is cut.
    left: usize,
}

impl DisplayTreeBuilder<'_> {
    /// Display tree of a term; a shared term becomes its name.
    fn view(&mut self, e: Expr) -> DisplayTree {
        match self.shared.get(&e) {
            Some(name) => DisplayTree::Shared(name.clone()),
            None => self.expand(e),
        }
    }

    /// Display tree of a term, written out even if the term itself has a shared name.
    fn expand(&mut self, e: Expr) -> DisplayTree {
        if self.left == 0 {
            return DisplayTree::Cut;
        }
        self.left -= 1;
        match self.arena.node(e).clone() {
            Node::Number(value) => {
                let (negative, magnitude) = self.quotient(&value, Vec::new());
                if negative { DisplayTree::Sum(vec![(true, magnitude)]) } else { magnitude }
            }
            Node::Symbol(_) => DisplayTree::Name(self.arena.symbol_name(e).unwrap_or_default().to_owned()),
            Node::Named(_, term) => match self.arena.written_name(e) {
                Some(name) => DisplayTree::Name(name.to_owned()),
                // A name that was never written has no definition, so its term is shown in full.
                None => self.view(term),
            },
            Node::Pi => DisplayTree::Pi,
            Node::Apply(Function::Sqrt, argument) => DisplayTree::Root(Box::new(self.view(argument))),
            Node::Apply(f, argument) => DisplayTree::Call(f.name(), Box::new(self.view(argument))),
            Node::Product(factors) => self.quotient(&Rational::ONE, factors.to_vec()).1,
            Node::Sum(constant, terms) => {
                let mut ordered = terms.to_vec();
                ordered.sort_by_cached_key(|(term, _)| self.monomial_sort_key(*term));
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
                DisplayTree::Sum(parts)
            }
        }
    }

    /// Sort key of a term in a sum: the sort keys of its factors, those of symbols declared later
    /// first. So a linear form is printed in the order of its variables.
    fn monomial_sort_key(&self, term: Expr) -> Vec<(SortKey, i32)> {
        let mut ranks: Vec<_> = match self.arena.node(term) {
            Node::Product(factors) => factors.iter().map(|(base, n)| (self.ranks[base], -n)).collect(),
            _ => vec![(self.ranks[&term], -1)],
        };
        ranks.sort_unstable();
        ranks.reverse();
        ranks
    }

    /// Splits the product k · e into its sign (true if negative) and the display tree of its
    /// absolute value.
    fn scaled(&mut self, k: &Rational, e: Expr) -> (bool, DisplayTree) {
        let factors: Vec<(Expr, i32)> = match self.arena.node(e) {
            Node::Product(factors) if !self.shared.contains_key(&e) => factors.to_vec(),
            _ if e == Expr::ONE => Vec::new(),
            _ => vec![(e, 1)],
        };
        self.quotient(k, factors)
    }

    /// Splits the product k · Π base^exponent into its sign (true if negative) and the display tree
    /// of its absolute value.
    fn quotient(&mut self, k: &Rational, mut factors: Vec<(Expr, i32)>) -> (bool, DisplayTree) {
        factors.sort_by_key(|(base, _)| self.ranks.get(base).copied());
        let magnitude = if k.is_negative() { k.neg() } else { k.clone() };
        let (numerator, denominator) = match magnitude.to_string().split_once('/') {
            Some((n, d)) => (n.to_owned(), d.to_owned()),
            None => (magnitude.to_string(), "1".to_owned()),
        };
        let (mut above, mut below) = (Vec::new(), Vec::new());
        let mut negative = k.is_negative();
        let tangents = self.take_tangents(&mut factors);
        // Symbols come first, then functions, then sums: `sin q1 u4` could be misread as sin(q1
        // u4).
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
            // A minus sign is taken into a sum: −a (5 c − 6) becomes a (6 − 5 c).
            if let DisplayTree::Sum(parts) = &mut view
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
            let view = if tangent { DisplayTree::Call("tan", Box::new(view)) } else { view };
            let side = if n > 0 { &mut above } else { &mut below };
            side.push(if n.abs() == 1 { view } else { DisplayTree::Power(Box::new(view), n.abs()) });
        }
        if numerator != "1" || above.is_empty() {
            above.insert(0, DisplayTree::Number(numerator));
        }
        if denominator != "1" {
            below.insert(0, DisplayTree::Number(denominator));
        }
        let one =
            |mut views: Vec<DisplayTree>| if views.len() == 1 { views.remove(0) } else { DisplayTree::Product(views) };
        let view = if below.is_empty() {
            one(above)
        } else {
            DisplayTree::Fraction(Box::new(one(above)), Box::new(one(below)))
        };
        (negative, view)
    }

    /// Takes the tangents out of a list of factors: sin^n·cos^−n of one angle is tan^n. Returns
    /// pairs (angle, n).
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

/// Moves the first positive term of a sum to the front if the sum begins with a minus, which is
/// harder to read.
fn positive_first(parts: &mut Vec<(bool, DisplayTree)>) {
    if let Some(at) = parts.iter().position(|(negative, _)| !negative)
        && parts[0].0
    {
        let first = parts.remove(at);
        parts.insert(0, first);
    }
}

/// True if a formula contains no sum.
#[must_use]
pub fn is_sum_free_formula(view: &DisplayTree) -> bool {
    match view {
        DisplayTree::Sum(_) => false,
        DisplayTree::Product(factors) => factors.iter().all(is_sum_free_formula),
        DisplayTree::Fraction(above, below) => is_sum_free_formula(above) && is_sum_free_formula(below),
        DisplayTree::Power(inner, _) | DisplayTree::Call(_, inner) | DisplayTree::Root(inner) => {
            is_sum_free_formula(inner)
        }
        DisplayTree::Number(_)
        | DisplayTree::Name(_)
        | DisplayTree::Word(_)
        | DisplayTree::Shared(_)
        | DisplayTree::Pi
        | DisplayTree::Cut => true,
    }
}

/// Splits a product into its leading whole number and its other factors. The number is `1` if there
/// is none.
#[must_use]
pub fn constant_and_factors(view: &DisplayTree) -> (String, Vec<DisplayTree>) {
    match view {
        DisplayTree::Number(text) => (text.clone(), Vec::new()),
        DisplayTree::Product(factors) => match &factors[0] {
            DisplayTree::Number(text) => (text.clone(), factors[1..].to_vec()),
            _ => ("1".to_owned(), factors.clone()),
        },
        other => ("1".to_owned(), vec![other.clone()]),
    }
}
