//! Evaluation of terms in one pass, operands before the terms that are built from them.
//!
//! A [`Fold`] gives the value of each kind of node: a double, an interval, a residue, a range, a bound, an operation of
//! a tape. Invariant: values stand in a dense list in the order of handles. So no pass is recursive, and terms that are
//! evaluated repeatedly are listed once. Absent on purpose: passes that build other terms (`calculus`, `normal`,
//! `simplify`), which keep their results from one call to the next.

use crate::algebra::{Arena, Expr, Function, Node, Rational};
use rustc_hash::{FxBuildHasher, FxHashMap};
use std::ops::Index;

/// Rules that give each term a value: one rule for each kind of node, from the values of its operands. `None` ends the
/// pass: then no term has a value.
pub trait Fold {
    /// Type of the value of a term.
    type Value: Clone;
    /// The value of a number.
    fn number(&mut self, value: &Rational) -> Option<Self::Value>;
    /// The value of π.
    fn pi(&mut self) -> Option<Self::Value>;
    /// The value of a symbol.
    fn symbol(&mut self, symbol: Expr) -> Option<Self::Value>;
    /// The value of constant + Σ k · term.
    fn sum(
        &mut self,
        constant: &Rational,
        terms: &[(Expr, Rational)],
        of: &Values<'_, Self::Value>,
    ) -> Option<Self::Value>;
    /// The value of Π base^exponent.
    fn product(&mut self, factors: &[(Expr, i32)], of: &Values<'_, Self::Value>) -> Option<Self::Value>;
    /// The value of a function f(argument).
    fn apply(&mut self, f: Function, argument: Expr, of: &Values<'_, Self::Value>) -> Option<Self::Value>;
    /// The value of a named term: that of the term behind the name.
    fn named(&mut self, term: Expr, of: &Values<'_, Self::Value>) -> Option<Self::Value> {
        Some(of[term].clone())
    }
    /// Value that is given for a term; `None` if its operands determine the value.
    fn known(&mut self, _term: Expr) -> Option<Self::Value> {
        None
    }
}

/// Terms and all terms that they are built from, each once, operands first.
#[derive(Clone, Debug)]
pub struct Needed {
    nodes: Vec<Expr>,
    /// Place of each node in the list; empty for a short list, where a search is as fast.
    places: FxHashMap<Expr, u32>,
}

/// Number of nodes up to which a binary search is as fast as a look-up in a table.
const FEW: usize = 48;

impl Needed {
    /// Collects terms together with all terms that they are built from.
    #[must_use]
    pub fn new(arena: &Arena, terms: &[Expr]) -> Self {
        let nodes = arena.reachable(terms);
        let mut places = FxHashMap::default();
        if nodes.len() > FEW {
            places = FxHashMap::with_capacity_and_hasher(nodes.len(), FxBuildHasher);
            places.extend(nodes.iter().copied().zip(0..));
        }
        Self { nodes, places }
    }

    fn place(&self, term: Expr) -> Option<usize> {
        if self.nodes.len() > FEW {
            return self.places.get(&term).map(|place| *place as usize);
        }
        self.nodes.binary_search(&term).ok()
    }

    /// All collected terms, in the order of handles.
    #[must_use]
    pub fn nodes(&self) -> &[Expr] {
        &self.nodes
    }

    /// Value of every collected term by these rules; `None` if one of them has no value.
    pub fn fold<F: Fold>(&self, arena: &Arena, rules: &mut F) -> Option<Values<'_, F::Value>> {
        let mut values = Values { needed: self, list: Vec::with_capacity(self.nodes.len()) };
        for &e in &self.nodes {
            let value = match rules.known(e) {
                Some(value) => value,
                None => match arena.node(e) {
                    Node::Number(value) => rules.number(value)?,
                    Node::Pi => rules.pi()?,
                    Node::Symbol(_) => rules.symbol(e)?,
                    Node::Sum(constant, terms) => rules.sum(constant, terms, &values)?,
                    Node::Product(factors) => rules.product(factors, &values)?,
                    Node::Apply(f, argument) => rules.apply(*f, *argument, &values)?,
                    Node::Named(_, term) => rules.named(*term, &values)?,
                },
            };
            values.list.push(value);
        }
        Some(values)
    }
}

/// Value of a term by these rules; `None` if the term, or one that it is built from, has no value.
pub fn fold<F: Fold>(arena: &Arena, term: Expr, rules: &mut F) -> Option<F::Value> {
    // Operands have smaller handles: the term itself comes last.
    let needed = Needed::new(arena, &[term]);
    needed.fold(arena, rules)?.list.pop()
}

/// Values of the terms that were folded, by their handles.
#[derive(Clone, Debug)]
pub struct Values<'a, V> {
    needed: &'a Needed,
    list: Vec<V>,
}

impl<V> Values<'_, V> {
    /// Value of a term; `None` if the term was not folded.
    #[must_use]
    pub fn get(&self, term: Expr) -> Option<&V> {
        self.needed.place(term).map(|place| &self.list[place])
    }

    /// Every term with its value, in the order of handles.
    pub fn iter(&self) -> impl Iterator<Item = (Expr, &V)> {
        self.needed.nodes.iter().copied().zip(&self.list)
    }
}

impl<V> Index<Expr> for Values<'_, V> {
    type Output = V;
    /// Value of a term that was folded.
    ///
    /// # Panics
    /// If the term was not folded.
    fn index(&self, term: Expr) -> &V {
        self.get(term).expect("one of the terms that were folded")
    }
}
