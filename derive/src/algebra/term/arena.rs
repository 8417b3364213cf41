//! Store of expressions as a graph in which each term occurs once (hash-consing).
//!
//! Invariants: two [`Expr`] of one arena are equal exactly if they are the same term, so a
//! comparison of terms compares two integers. Operands have smaller handles than the terms built
//! from them. So every pass is a loop over handles and cannot overflow the stack. Equal handles
//! mean equal form. The module [`crate::algebra::value::zero_test`] decides if terms of different
//! form are identically equal.
//!
//! The constructors keep a light canonical form: like terms are collected, powers of one base are
//! merged, coefficients are exact. tan x is sin x · (cos x)⁻¹, so that it cancels against cosines.
//! Absent on purpose: expansion and trigonometric identities. They make terms longer, and belong to
//! [`crate::algebra::form::simplify`].

use crate::algebra::Rational;
use hashbrown::HashTable;
use rustc_hash::{FxHashMap, FxHashSet, FxHasher};
use std::hash::{Hash, Hasher};

/// Handle of a term in an [`Arena`]: a small integer that is copied freely. Two handles of one
/// arena are equal exactly if they are the same term.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub struct Expr(u32);

impl Expr {
    /// Handle of the number 0, the same in every arena.
    pub const ZERO: Self = Self(0);
    /// Handle of the number 1, the same in every arena.
    pub const ONE: Self = Self(1);
    /// Handle of the number −1, the same in every arena.
    pub const MINUS_ONE: Self = Self(2);

    /// Position of the term in its arena. Operands come before the terms built from them.
    #[must_use]
    pub const fn index(self) -> usize {
        self.0 as usize
    }
}

/// Elementary function of one argument, such as sine or square root.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub enum Function {
    /// Sine of an angle in radians.
    Sin,
    /// Cosine of an angle in radians.
    Cos,
    /// Square root of a number that is not negative.
    Sqrt,
    /// Exponential function eˣ.
    Exp,
    /// Natural logarithm of a positive number.
    Log,
    /// Inverse sine, an angle from −π/2 to π/2 rad.
    Asin,
    /// Inverse cosine, an angle from 0 to π rad.
    Acos,
    /// Inverse tangent, an angle between −π/2 and π/2 rad.
    Atan,
    /// Hyperbolic sine.
    Sinh,
    /// Hyperbolic cosine.
    Cosh,
    /// Hyperbolic tangent.
    Tanh,
    /// Absolute value |x|.
    Abs,
    /// Sign function: −1, 0 or 1; its value at 0 is 0. It is the derivative of the absolute value.
    Sign,
}

impl Function {
    /// Every function with its name in model files, in the order of the variants.
    pub const ALL: [(Self, &'static str); 13] = [
        (Self::Sin, "sin"),
        (Self::Cos, "cos"),
        (Self::Sqrt, "sqrt"),
        (Self::Exp, "exp"),
        (Self::Log, "log"),
        (Self::Asin, "asin"),
        (Self::Acos, "acos"),
        (Self::Atan, "atan"),
        (Self::Sinh, "sinh"),
        (Self::Cosh, "cosh"),
        (Self::Tanh, "tanh"),
        (Self::Abs, "abs"),
        (Self::Sign, "sign"),
    ];

    /// Name of the function as model files write it, such as `sin`.
    #[must_use]
    pub fn name(self) -> &'static str {
        Self::ALL[self as usize].1
    }
}

/// Node of the expression graph: a number, a symbol, π, a sum, a product, a function value or a named term.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub enum Node {
    /// An exact rational number.
    Number(Rational),
    /// A symbol, as the position of its name in [`Arena::symbol_names`].
    Symbol(u32),
    /// The number π.
    Pi,
    /// Sum constant + Σ coefficient · term. The terms are neither numbers nor sums; they are sorted
    /// and have no zero coefficients.
    /// A single term occurs only with a constant or with a coefficient other than 1.
    Sum(Rational, Box<[(Expr, Rational)]>),
    /// Product Π base^exponent. The bases are neither numbers nor products; they are sorted and
    /// have no zero exponents.
    /// A single base occurs only with an exponent other than 1. A sum as base has content 1: no
    /// rational number can be factored out.
    Product(Box<[(Expr, i32)]>),
    /// Value of an elementary function at the argument, a term.
    Apply(Function, Expr),
    /// A named term: the number of its label, and the term that the name abbreviates. Larger terms
    /// show only the name, and rewriting treats the named term as an atom. Its value is that of the
    /// abbreviated term.
    Named(u32, Expr),
}

/// Reason why a power cannot be built: a negative power of zero, or an exponent or number that is
/// too large.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum PowerError {
    /// Division by zero: the number 0 to a negative power.
    DivisionByZero,
    /// An exponent beyond ±[`Arena::MAX_EXPONENT`], or a number with too many digits to compute.
    TooLarge,
}

/// Names of the terms of an arena: labels, handles of named terms, and the symbols that documents
/// show for named terms.
#[derive(Clone, Default)]
pub(in crate::algebra) struct Names {
    /// Labels of named terms, each once, in the order of creation. Several terms may share a label.
    pub(in crate::algebra) labels: Vec<String>,
    /// Position of each label in `labels`.
    pub(in crate::algebra) label_index: FxHashMap<String, u32>,
    /// Handle of the [`Node::Named`] for each term that has a name, by the handle of the
    /// abbreviated term.
    pub(in crate::algebra) stands: FxHashMap<Expr, Expr>,
    /// Symbol that documents show for a named term, by the handle of the named term. A named term
    /// has no entry until a document has defined it.
    pub(in crate::algebra) symbols: FxHashMap<Expr, NameSymbol>,
    /// Number of named terms that documents have defined so far under each label. It distinguishes
    /// the names of terms that share a label.
    pub(in crate::algebra) written: FxHashMap<String, usize>,
    /// Part of a document for which names are written at present; it is appended to new names.
    /// `None` for names that all documents share.
    pub(in crate::algebra) part: Option<String>,
    /// Name in documents, by name in files, for each symbol whose two names differ.
    pub(in crate::algebra) printed: FxHashMap<String, String>,
}

/// Symbol with which documents show a named term.
#[derive(Clone, Copy)]
pub(in crate::algebra) struct NameSymbol {
    /// Symbol that documents show in place of the term.
    pub(in crate::algebra) symbol: Expr,
    /// True if all documents about the model use this symbol; false if it was made for one part of
    /// a document.
    pub(in crate::algebra) everywhere: bool,
}

/// Store of all terms of one model. Each term is stored once, and handles (`Expr`) refer to it.
#[derive(Clone)]
pub struct Arena {
    /// Nodes of all terms, indexed by handle.
    nodes: Vec<Node>,
    /// Hash table from each node to its handle.
    table: HashTable<u32>,
    /// Names of all symbols, in the order of declaration.
    symbols: Vec<String>,
    /// Handle of each symbol, by name.
    symbol_index: FxHashMap<String, Expr>,
    /// Symbols that were declared positive.
    positive: FxHashSet<Expr>,
    /// Terms that were cancelled from written formulas. The formulas are valid only where these
    /// terms have values.
    restrictions: Vec<Expr>,
    /// Names that abbreviate terms, and their symbols in documents.
    pub(in crate::algebra) names: Names,
}

impl Default for Arena {
    fn default() -> Self {
        Self::new()
    }
}

/// Hash of a node, for the hash table that stores each term once.
fn hash_of(node: &Node) -> u64 {
    let mut hasher = FxHasher::default();
    node.hash(&mut hasher);
    hasher.finish()
}

impl Arena {
    /// Largest absolute value of an exponent of a power; larger exponents are refused. The parser
    /// limits written exponents to [`Self::MAX_WRITTEN_EXPONENT`], so that derivations stay far
    /// below this limit.
    pub const MAX_EXPONENT: i32 = 1_000_000;
    /// Largest absolute value of an exponent that the parser accepts in a formula.
    pub const MAX_WRITTEN_EXPONENT: i32 = 1000;

    /// Creates an arena that contains only the numbers 0, 1 and −1.
    #[must_use]
    pub fn new() -> Self {
        let mut arena = Self {
            nodes: Vec::new(),
            table: HashTable::new(),
            symbols: Vec::new(),
            symbol_index: FxHashMap::default(),
            positive: FxHashSet::default(),
            restrictions: Vec::new(),
            names: Names::default(),
        };
        for n in [0, 1, -1] {
            arena.intern(Node::Number(Rational::integer(n)));
        }
        arena
    }

    /// Stores a node and returns its handle. A node that the arena already has keeps its handle.
    pub(in crate::algebra) fn intern(&mut self, node: Node) -> Expr {
        let hash = hash_of(&node);
        let nodes = &self.nodes;
        if let Some(&at) = self.table.find(hash, |&i| nodes[i as usize] == node) {
            return Expr(at);
        }
        let at = u32::try_from(self.nodes.len()).expect("fewer than 2^32 terms fit in memory");
        self.nodes.push(node);
        let nodes = &self.nodes;
        self.table.insert_unique(hash, at, |&i| hash_of(&nodes[i as usize]));
        Expr(at)
    }

    /// Node of the term `e`: its kind and its operands.
    #[must_use]
    pub fn node(&self, e: Expr) -> &Node {
        &self.nodes[e.index()]
    }

    /// Iterates over the nodes of all terms built so far, in the order of the handles.
    pub fn nodes(&self) -> impl Iterator<Item = &Node> {
        self.nodes.iter()
    }

    /// Number of different terms in the arena.
    #[must_use]
    pub fn len(&self) -> usize {
        self.nodes.len()
    }

    /// True if the arena contains no term. Always false, because a new arena contains 0, 1 and −1.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.nodes.is_empty()
    }

    /// Symbol with the given name; created if the name is new. The order of first use is the order
    /// of declaration, which all printed output follows.
    pub fn symbol(&mut self, name: &str) -> Expr {
        if let Some(&e) = self.symbol_index.get(name) {
            return e;
        }
        let id = u32::try_from(self.symbols.len()).expect("fewer than 2^32 symbols");
        self.symbols.push(name.to_owned());
        let e = self.intern(Node::Symbol(id));
        self.symbol_index.insert(name.to_owned(), e);
        e
    }

    /// Symbol with the given name; `None` if the arena has no symbol of that name.
    #[must_use]
    pub fn find_symbol(&self, name: &str) -> Option<Expr> {
        self.symbol_index.get(name).copied()
    }

    /// Names of all symbols, in the order of declaration.
    #[must_use]
    pub fn symbol_names(&self) -> &[String] {
        &self.symbols
    }

    /// Name of a symbol; `None` if the term is not a symbol.
    #[must_use]
    pub fn symbol_name(&self, e: Expr) -> Option<&str> {
        match self.node(e) {
            Node::Symbol(id) => Some(&self.symbols[*id as usize]),
            _ => None,
        }
    }

    /// Declares that a symbol is positive, so that √(x²) becomes x. Terms built before the
    /// declaration are not simplified.
    pub fn assume_positive(&mut self, symbol: Expr) {
        self.positive.insert(symbol);
    }

    /// Records a term that was cancelled while a written formula was built. The formula has a value
    /// only where this term has a value.
    pub fn restrict(&mut self, e: Expr) {
        if !self.restrictions.contains(&e) {
            self.restrictions.push(e);
        }
    }

    /// Terms recorded by [`Arena::restrict`]. A statement about the written formulas holds only
    /// where all of them have a value.
    #[must_use]
    pub fn restrictions(&self) -> &[Expr] {
        &self.restrictions
    }

    /// True if the symbol was declared positive.
    #[must_use]
    pub fn is_positive(&self, symbol: Expr) -> bool {
        self.positive.contains(&symbol)
    }

    /// Value of a term that is a rational number; `None` for any other term.
    #[must_use]
    pub fn as_number(&self, e: Expr) -> Option<&Rational> {
        match self.node(e) {
            Node::Number(value) => Some(value),
            _ => None,
        }
    }

    /// Iterates over the direct operands of the term `e`, each once. Numbers and symbols have none.
    pub fn operands(&self, e: Expr) -> impl Iterator<Item = Expr> + '_ {
        let (terms, factors, argument): (&[_], &[_], _) = match self.node(e) {
            Node::Sum(_, terms) => (terms, &[], None),
            Node::Product(factors) => (&[], factors, None),
            Node::Apply(_, argument) | Node::Named(_, argument) => (&[], &[], Some(*argument)),
            _ => (&[], &[], None),
        };
        terms.iter().map(|(e, _)| *e).chain(factors.iter().map(|(e, _)| *e)).chain(argument)
    }

    /// All subterms of the terms `roots`, the roots included, each once; operands come first.
    #[must_use]
    pub fn reachable(&self, roots: &[Expr]) -> Vec<Expr> {
        self.reachable_until(roots, |_| false)
    }

    /// All subterms that appear in the text of `roots`, the roots included, in the order of
    /// handles. Terms that occur only inside named terms, which the text shows by name, are left
    /// out.
    #[must_use]
    pub fn shown_subterms(&self, roots: &[Expr]) -> Vec<Expr> {
        self.subterms_until(roots, |_| false, |e| self.written_name(e).is_some())
    }

    /// All subterms of `roots` that rewriting sees, the roots included, in the order of handles. Terms that occur only
    /// inside named terms are left out, whether or not a document has defined the names.
    #[must_use]
    pub fn subterms_up_to_names(&self, roots: &[Expr]) -> Vec<Expr> {
        self.subterms_until(roots, |_| false, |e| self.named_term_value(e).is_some())
    }

    /// Subterms of the terms `roots`, the roots included, in the order of handles. Left out are the
    /// terms for which `known` is true, and terms that occur only inside these.
    pub(crate) fn reachable_until(&self, roots: &[Expr], known: impl Fn(Expr) -> bool) -> Vec<Expr> {
        self.subterms_until(roots, known, |_| false)
    }

    /// Subterms of the terms `roots`, in the order of handles. Terms for which `known` is true are
    /// left out, with their operands. Operands of terms for which `is_end` is true are not visited.
    fn subterms_until(&self, roots: &[Expr], known: impl Fn(Expr) -> bool, is_end: impl Fn(Expr) -> bool) -> Vec<Expr> {
        // `seen` has a bit for each handle up to the largest root, since operands have smaller
        // handles.
        let words = roots.iter().map(|e| e.index() / 64 + 1).max().unwrap_or(0);
        let mut seen = vec![0_u64; words];
        let mut stack: Vec<Expr> = Vec::new();
        let (mut all, mut sorted) = (Vec::new(), true);
        let mut visit = |e: Expr, stack: &mut Vec<Expr>| {
            let (word, bit) = (e.index() / 64, 1 << (e.index() % 64));
            if seen[word] & bit == 0 && !known(e) {
                seen[word] |= bit;
                sorted &= all.last().is_none_or(|last| *last < e);
                all.push(e);
                if !is_end(e) {
                    stack.push(e);
                }
            }
        };
        for root in roots {
            visit(*root, &mut stack);
            while let Some(e) = stack.pop() {
                for operand in self.operands(e) {
                    visit(operand, &mut stack);
                }
            }
        }
        if !sorted {
            sort_handles(&mut all, &seen);
        }
        all
    }

    /// True if `symbol` occurs in the term `e`. The test is by form: the term may contain the
    /// symbol without depending on it.
    #[must_use]
    pub fn mentions(&self, e: Expr, symbol: Expr) -> bool {
        self.reachable(&[e]).binary_search(&symbol).is_ok()
    }
}

/// Sorts a list of handles. `seen` has a bit set for each listed handle. A short list is sorted by
/// comparison, a long list by reading the bits in order.
fn sort_handles(all: &mut Vec<Expr>, seen: &[u64]) {
    if all.len() < seen.len() / 4 {
        return all.sort_unstable();
    }
    all.clear();
    for (at, word) in (0_u32..).zip(seen) {
        let mut left = *word;
        while left != 0 {
            all.push(Expr(64 * at + left.trailing_zeros()));
            left &= left - 1;
        }
    }
}
