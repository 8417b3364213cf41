//! Transfer of terms from one arena to another. Symbols correspond by name.

use crate::algebra::{Arena, Expr, Node, Rational};
use rustc_hash::FxHashMap;

/// Copies terms of one arena into another. A part that several terms share is copied once.
pub struct Transfer<'a> {
    /// Arena from which terms are copied.
    from: &'a Arena,
    /// Copy of each term that was transferred so far, by the handle of the original.
    done: FxHashMap<Expr, Expr>,
    /// Suffix for the labels of named terms that get a new name in the target arena; empty within
    /// one model.
    suffix: &'static str,
}

impl<'a> Transfer<'a> {
    /// Creates a transfer of terms of the arena `from` to an arena of the same model. Named terms
    /// keep their labels; a term that already has a name in the target arena keeps that name.
    pub fn new(from: &'a Arena) -> Self {
        Self { from, done: FxHashMap::default(), suffix: "" }
    }

    /// Creates a transfer of terms of the arena `from` to the arena of a different model. The
    /// suffix is appended to the labels of named terms that have no name there yet.
    pub fn to_other_model(from: &'a Arena, suffix: &'static str) -> Self {
        Self { suffix, ..Self::new(from) }
    }

    /// Copies the term `e` of the source arena into `arena` and returns its handle there. Repeated
    /// calls for a term give the same handle.
    pub fn transfer_term(&mut self, arena: &mut Arena, e: Expr) -> Expr {
        for part in self.from.reachable(&[e]) {
            if !self.done.contains_key(&part) {
                let new = self.transfer_node(arena, part);
                self.done.insert(part, new);
            }
        }
        self.done[&e]
    }

    /// Copies a single node; its operands must have been copied before.
    fn transfer_node(&self, arena: &mut Arena, e: Expr) -> Expr {
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
            // A term that already has a name in the target arena keeps that name.
            Node::Named(_, term) => {
                let wanted = format!("{}{}", self.from.label_of(e).unwrap_or_default(), self.suffix);
                arena.name(self.done[term], &wanted)
            }
        }
    }
}
