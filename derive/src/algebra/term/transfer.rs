//! Transfer of terms from one arena to another; symbols correspond by name.

use crate::algebra::{Arena, Expr, Node, Rational};
use rustc_hash::FxHashMap;

/// Writes terms of one arena into another; parts that several terms share are written once.
pub struct Transfer<'a> {
    from: &'a Arena,
    done: FxHashMap<Expr, Expr>,
    /// Suffix appended to the name of each term that has no name in the other arena.
    suffix: &'static str,
}

impl<'a> Transfer<'a> {
    /// Creates a transfer of terms of `from`. A term that has a name in `from` and none in the other arena gets the
    /// same name there.
    pub fn new(from: &'a Arena) -> Self {
        Self { from, done: FxHashMap::default(), suffix: "" }
    }

    /// Creates a transfer into the arena of another model than that of `from`. The suffix marks the names of terms that
    /// have no name there.
    pub fn of_other_model(from: &'a Arena, suffix: &'static str) -> Self {
        Self { suffix, ..Self::new(from) }
    }

    /// Writes the term `e` of the first arena into `arena`; the result for a term is always the same.
    pub fn term(&mut self, arena: &mut Arena, e: Expr) -> Expr {
        for part in self.from.reachable(&[e]) {
            if !self.done.contains_key(&part) {
                let new = self.one(arena, part);
                self.done.insert(part, new);
            }
        }
        self.done[&e]
    }

    fn one(&self, arena: &mut Arena, e: Expr) -> Expr {
        match self.from.node(e) {
            Node::Number(value) => arena.number(value.clone()),
            Node::Symbol(_) => arena.symbol(self.from.symbol_name(e).unwrap_or_default()),
            Node::Pi => arena.pi(),
            Node::Sum(constant, terms) => {
                let constant = arena.number(constant.clone());
                let mut list: Vec<_> = terms.iter().map(|(term, k)| (self.done[term], k.clone())).collect();
                list.push((constant, Rational::ONE));
                arena.linear_combination(&list)
            }
            Node::Product(factors) => {
                let list: Vec<_> = factors.iter().map(|(base, n)| (self.done[base], *n)).collect();
                arena.try_product(&list).expect("what could be built in one arena can be built in another")
            }
            Node::Apply(f, argument) => arena.apply(*f, self.done[argument]),
            // A term that has a name in the other arena keeps it.
            Node::Named(_, term) => {
                let wanted = format!("{}{}", self.from.label_of(e).unwrap_or_default(), self.suffix);
                arena.name(self.done[term], &wanted)
            }
        }
    }
}
