//! Expressions as a hash-consed graph.
//!
//! Invariants: two [`Expr`] of one arena are equal iff they are the same term, so comparing costs one integer
//! comparison. Operands have smaller handles than the terms that are built from them, so every pass is a loop over
//! handles and none can overflow the stack. This is equality of *form*; equality of *meaning* is
//! [`crate::algebra::value::modular`].
//!
//! The constructors keep a light canonical form: like terms are collected, powers of one base are
//! merged, coefficients are exact. tan x is sin x · (cos x)⁻¹, so that it cancels against cosines.
//! Absent on purpose: expansion and trigonometric identities. They cost terms, and belong to
//! [`crate::algebra::form::simplify`].

use crate::algebra::Rational;
use hashbrown::HashTable;
use rustc_hash::{FxHashMap, FxHashSet, FxHasher};
use std::hash::{Hash, Hasher};

/// A term of an [`Arena`]: a copyable handle.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub struct Expr(u32);

impl Expr {
    /// The number 0, in every arena.
    pub const ZERO: Self = Self(0);
    /// The number 1, in every arena.
    pub const ONE: Self = Self(1);
    /// The number −1, in every arena.
    pub const MINUS_ONE: Self = Self(2);

    /// Position of the term in the arena; operands come before the terms that are built from them.
    #[must_use]
    pub const fn index(self) -> usize {
        self.0 as usize
    }
}

/// A function of one argument.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub enum Function {
    /// Sine of an angle in radians.
    Sin,
    /// Cosine of an angle in radians.
    Cos,
    /// Square root.
    Sqrt,
    /// Exponential.
    Exp,
    /// Natural logarithm.
    Log,
    /// Inverse sine.
    Asin,
    /// Inverse cosine.
    Acos,
    /// Inverse tangent.
    Atan,
    /// Hyperbolic sine.
    Sinh,
    /// Hyperbolic cosine.
    Cosh,
    /// Hyperbolic tangent.
    Tanh,
    /// Absolute value.
    Abs,
    /// Sign: −1, 0 or 1. It is the derivative of the absolute value, and 0 at 0.
    Sign,
}

impl Function {
    /// Every function, with the name used in model files.
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

    /// Name of the function in model files.
    #[must_use]
    pub fn name(self) -> &'static str {
        Self::ALL[self as usize].1
    }
}

/// Node of the expression graph: a number, a symbol, π, a sum, a product, a function value or a named term.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub enum Node {
    /// An exact number.
    Number(Rational),
    /// A named quantity, by its position in [`Arena::symbol_names`].
    Symbol(u32),
    /// The number π.
    Pi,
    /// Sum constant + Σ coefficient · term. Terms are neither numbers nor sums, sorted, coefficients not zero; a single
    /// term stands only with a constant or with a coefficient other than 1.
    Sum(Rational, Box<[(Expr, Rational)]>),
    /// Product Π base^exponent. Bases are neither numbers nor products, sorted, exponents not zero; a single base
    /// stands only with an exponent other than 1. A sum as base has content 1.
    Product(Box<[(Expr, i32)]>),
    /// A function of its argument.
    Apply(Function, Expr),
    /// A named term, as its label and the term itself. Terms that mention it show the name, and no rewriting looks
    /// behind it; by meaning it equals the term.
    Named(u32, Expr),
}

/// A power that cannot be built: a negative power of zero, or an exponent or number too large.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum PowerError {
    /// The number 0 to a negative power.
    DivisionByZero,
    /// An exponent beyond ±[`Arena::MAX_EXPONENT`], or a number with too many digits.
    TooLarge,
}

/// Names of terms: labels, handles of named terms, and the symbols of names that were written down.
#[derive(Clone, Default)]
pub(in crate::algebra) struct Names {
    pub(in crate::algebra) labels: Vec<String>,
    pub(in crate::algebra) label_index: FxHashMap<String, u32>,
    /// Handle of the [`Node::Named`] for each term that has a name.
    pub(in crate::algebra) stands: FxHashMap<Expr, Expr>,
    /// Symbol of each named term that was written down.
    pub(in crate::algebra) symbols: FxHashMap<Expr, NameSymbol>,
    /// Number of named terms written down so far under each wanted name; it numbers terms that are called alike.
    pub(in crate::algebra) written: FxHashMap<String, usize>,
    /// Part of a document that names are written for; `None` for names that all documents have.
    pub(in crate::algebra) part: Option<String>,
    /// Names by which documents show symbols, for symbols that have another name in documents than in files.
    pub(in crate::algebra) printed: FxHashMap<String, String>,
}

/// The symbol that a named term is written with.
#[derive(Clone, Copy)]
pub(in crate::algebra) struct NameSymbol {
    pub(in crate::algebra) symbol: Expr,
    /// True if the name was written for no part of a document: then all documents about the model use this name.
    pub(in crate::algebra) everywhere: bool,
}

/// The store of all terms of one model.
#[derive(Clone)]
pub struct Arena {
    nodes: Vec<Node>,
    table: HashTable<u32>,
    symbols: Vec<String>,
    symbol_index: FxHashMap<String, Expr>,
    positive: FxHashSet<Expr>,
    restrictions: Vec<Expr>,
    pub(in crate::algebra) names: Names,
}

impl Default for Arena {
    fn default() -> Self {
        Self::new()
    }
}

fn hash_of(node: &Node) -> u64 {
    let mut hasher = FxHasher::default();
    node.hash(&mut hasher);
    hasher.finish()
}

impl Arena {
    /// The largest exponent that a power may have. The parser limits exponents that people write to
    /// [`Self::MAX_WRITTEN_EXPONENT`], so that no derivation gets near.
    pub const MAX_EXPONENT: i32 = 1_000_000;
    /// The largest exponent that the parser lets a term have.
    pub const MAX_WRITTEN_EXPONENT: i32 = 1000;

    /// Creates an arena that holds only the numbers 0, 1 and −1.
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

    /// Node that the handle `e` stands for.
    #[must_use]
    pub fn node(&self, e: Expr) -> &Node {
        &self.nodes[e.index()]
    }

    /// Nodes of all terms built so far, in the order of handles.
    pub fn nodes(&self) -> impl Iterator<Item = &Node> {
        self.nodes.iter()
    }

    /// Number of different terms built so far.
    #[must_use]
    pub fn len(&self) -> usize {
        self.nodes.len()
    }

    /// True if the arena holds no term. Always false: 0, 1 and −1 are built at the start.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.nodes.is_empty()
    }

    /// Symbol of this name, created if it is new. The order of first use is the order of declaration, which all printed
    /// output follows.
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

    /// Symbol of this name; `None` if there is none.
    #[must_use]
    pub fn find_symbol(&self, name: &str) -> Option<Expr> {
        self.symbol_index.get(name).copied()
    }

    /// All symbol names, in order of declaration.
    #[must_use]
    pub fn symbol_names(&self) -> &[String] {
        &self.symbols
    }

    /// The name of a symbol; `None` for any other term.
    #[must_use]
    pub fn symbol_name(&self, e: Expr) -> Option<&str> {
        match self.node(e) {
            Node::Symbol(id) => Some(&self.symbols[*id as usize]),
            _ => None,
        }
    }

    /// Takes a symbol to be positive from now on, so that √(x²) = x. State it before the symbol is used.
    pub fn assume_positive(&mut self, symbol: Expr) {
        self.positive.insert(symbol);
    }

    /// Records a term that cancelled in a written formula: the formula has a value only where this term has one.
    pub fn restrict(&mut self, e: Expr) {
        if !self.restrictions.contains(&e) {
            self.restrictions.push(e);
        }
    }

    /// Terms that must have a value wherever a statement about the written formulas is made: those given to
    /// [`Arena::restrict`].
    #[must_use]
    pub fn restrictions(&self) -> &[Expr] {
        &self.restrictions
    }

    /// True if a symbol was stated to be positive.
    #[must_use]
    pub fn is_positive(&self, symbol: Expr) -> bool {
        self.positive.contains(&symbol)
    }

    /// Term that is an exact number.
    pub fn number(&mut self, value: Rational) -> Expr {
        self.intern(Node::Number(value))
    }

    /// Term that is an integer.
    pub fn integer(&mut self, n: i64) -> Expr {
        self.number(Rational::integer(n))
    }

    /// Term that is the fraction n/d, as an exact number.
    ///
    /// # Panics
    /// If d is 0: for literal fractions in code.
    pub fn ratio(&mut self, n: i64, d: i64) -> Expr {
        self.number(Rational::fraction(n, d).expect("a literal fraction"))
    }

    /// The number π as a term.
    pub fn pi(&mut self) -> Expr {
        self.intern(Node::Pi)
    }

    /// Value of a literal number; `None` for any other term.
    #[must_use]
    pub fn as_number(&self, e: Expr) -> Option<&Rational> {
        match self.node(e) {
            Node::Number(value) => Some(value),
            _ => None,
        }
    }

    /// The operands of `e`, each once.
    pub fn operands(&self, e: Expr) -> impl Iterator<Item = Expr> + '_ {
        let (terms, factors, argument): (&[_], &[_], _) = match self.node(e) {
            Node::Sum(_, terms) => (terms, &[], None),
            Node::Product(factors) => (&[], factors, None),
            Node::Apply(_, argument) | Node::Named(_, argument) => (&[], &[], Some(*argument)),
            _ => (&[], &[], None),
        };
        terms.iter().map(|(e, _)| *e).chain(factors.iter().map(|(e, _)| *e)).chain(argument)
    }

    /// All terms that `roots` are built from, themselves included, operands first.
    #[must_use]
    pub fn reachable(&self, roots: &[Expr]) -> Vec<Expr> {
        self.reachable_until(roots, |_| false)
    }

    /// Terms that `roots` are built from, themselves included, as text shows them: terms that stand only behind a
    /// written name are left out.
    #[must_use]
    pub fn shown(&self, roots: &[Expr]) -> Vec<Expr> {
        self.walk(roots, |_| false, |e| self.written_name(e).is_some())
    }

    /// Terms that the roots are built from, in the order of handles. Terms for which `known` holds are left out, and so
    /// are terms that only known terms are built from.
    pub(crate) fn reachable_until(&self, roots: &[Expr], known: impl Fn(Expr) -> bool) -> Vec<Expr> {
        self.walk(roots, known, |_| false)
    }

    /// Terms that the roots are built from, in the order of handles, without known terms and without the operands of
    /// terms for which `is_end` holds.
    fn walk(&self, roots: &[Expr], known: impl Fn(Expr) -> bool, is_end: impl Fn(Expr) -> bool) -> Vec<Expr> {
        // A bit for each handle up to the largest root: operands have smaller ones.
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
            in_order(&mut all, &seen);
        }
        all
    }

    /// True if `symbol` occurs in `e`. This is form, not meaning: the symbol may occur and cancel.
    #[must_use]
    pub fn mentions(&self, e: Expr, symbol: Expr) -> bool {
        self.reachable(&[e]).binary_search(&symbol).is_ok()
    }
}

/// Sorts the handles whose bits are set in `seen`: few by comparison, many by reading the bits.
fn in_order(all: &mut Vec<Expr>, seen: &[u64]) {
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
