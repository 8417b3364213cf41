//! Evaluation of terms in one pass, operands before the terms that are built from them.
//!
//! A [`Fold`] gives each kind of node its value: a double, an interval, a residue, a range, a bound
//! or a tape operation.
//! Invariant: the values are a dense list in the order of the handles. So no pass is recursive, and
//! terms that are evaluated repeatedly are listed once. Absent on purpose: passes that build other
//! terms (`calculus`, `normal_form`, `simplify`). They keep their results from one call to the
//! next.

use crate::algebra::{Arena, Expr, Function, Node, Rational};
use rustc_hash::{FxBuildHasher, FxHashMap};
use std::ops::Index;

/// Rules that evaluate a term of the arena. There is one rule for each kind of node; it uses the
/// values of the node's operands. If a rule returns `None`, the evaluation ends without a value for
/// any term.
pub trait Fold {
    /// Type of the value of a term: a double, an interval, a residue or any other type.
    type Value: Clone;
    /// Value of an exact rational number; `None` ends the evaluation.
    fn number(&mut self, value: &Rational) -> Option<Self::Value>;
    /// Value of the constant π; `None` ends the evaluation.
    fn pi(&mut self) -> Option<Self::Value>;
    /// Value of a symbol, given by its handle; `None` ends the evaluation.
    fn symbol(&mut self, symbol: Expr) -> Option<Self::Value>;
    /// Value of the sum constant + Σ k · term over the pairs (term, k). `of` has the values of the
    /// terms; `None` ends the evaluation.
    fn sum(
        &mut self,
        constant: &Rational,
        terms: &[(Expr, Rational)],
        of: &Values<'_, Self::Value>,
    ) -> Option<Self::Value>;
    /// Value of the product Π base^exponent over the pairs (base, exponent). `of` has the values of
    /// the bases; `None` ends the evaluation.
    fn product(&mut self, factors: &[(Expr, i32)], of: &Values<'_, Self::Value>) -> Option<Self::Value>;
    /// Value of the function f at a term. `of` has the value of the argument; `None` ends the
    /// evaluation.
    fn apply(&mut self, f: Function, argument: Expr, of: &Values<'_, Self::Value>) -> Option<Self::Value>;
    /// Value of a named term. By default it is the value of `term`, the expression that the name
    /// abbreviates.
    fn named(&mut self, term: Expr, of: &Values<'_, Self::Value>) -> Option<Self::Value> {
        Some(of[term].clone())
    }
    /// Value of a term that the rules know without evaluating its operands. `None` if the value
    /// follows from the operands, which is the default.
    fn known(&mut self, _term: Expr) -> Option<Self::Value> {
        None
    }
}

/// List of given terms and all their subterms, each once, operands before the terms built from
/// them.
#[derive(Clone, Debug)]
pub struct FoldOrder {
    /// Collected terms with all their subterms, sorted by handle.
    nodes: Vec<Expr>,
    /// Position of each term in `nodes`. The map is empty for short lists, where a binary search is
    /// as fast.
    places: FxHashMap<Expr, u32>,
}

/// Number of nodes up to which a binary search is as fast as a look-up in a table.
const LARGEST_SEARCHED_LIST: usize = 48;

impl FoldOrder {
    /// Collects the given terms and all their subterms.
    #[must_use]
    pub fn new(arena: &Arena, terms: &[Expr]) -> Self {
        let nodes = arena.reachable(terms);
        let mut places = FxHashMap::default();
        if nodes.len() > LARGEST_SEARCHED_LIST {
            places = FxHashMap::with_capacity_and_hasher(nodes.len(), FxBuildHasher);
            places.extend(nodes.iter().copied().zip(0..));
        }
        Self { nodes, places }
    }

    /// Position of a term in the list of nodes; `None` if the term was not collected.
    fn place(&self, term: Expr) -> Option<usize> {
        if self.nodes.len() > LARGEST_SEARCHED_LIST {
            return self.places.get(&term).map(|place| *place as usize);
        }
        self.nodes.binary_search(&term).ok()
    }

    /// All collected terms, each once, sorted by handle: operands come before the terms built from
    /// them.
    #[must_use]
    pub fn nodes(&self) -> &[Expr] {
        &self.nodes
    }

    /// Evaluates every collected term by the given rules. `None` if a rule gives no value for a
    /// term.
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

/// Evaluates one term by the given rules. `None` if a rule gives no value for the term or for one
/// of its subterms.
pub fn fold<F: Fold>(arena: &Arena, term: Expr, rules: &mut F) -> Option<F::Value> {
    // Operands have smaller handles: the term itself comes last.
    let needed = FoldOrder::new(arena, &[term]);
    needed.fold(arena, rules)?.list.pop()
}

/// Values of all terms of an evaluation, accessible by the handles of the terms.
#[derive(Clone, Debug)]
pub struct Values<'a, V> {
    /// Evaluated terms, with their positions in the list of values.
    needed: &'a FoldOrder,
    /// Value of each term of `needed`, in the same order.
    list: Vec<V>,
}

impl<V> Values<'_, V> {
    /// Value of a term; `None` if the evaluation did not reach this term.
    #[must_use]
    pub fn get(&self, term: Expr) -> Option<&V> {
        self.needed.place(term).map(|place| &self.list[place])
    }

    /// Iterates over all evaluated terms with their values, in the order of the handles.
    pub fn iter(&self) -> impl Iterator<Item = (Expr, &V)> {
        self.needed.nodes.iter().copied().zip(&self.list)
    }
}

impl<V> Index<Expr> for Values<'_, V> {
    type Output = V;
    /// Returns the value of an evaluated term.
    ///
    /// # Panics
    /// If the evaluation did not reach the term.
    fn index(&self, term: Expr) -> &V {
        self.get(term).expect("one of the terms that were folded")
    }
}
