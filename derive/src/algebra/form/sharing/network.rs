//! Network of a function's steps and values: sums of monomials in numbered atoms.
//!
//! These sums are separate from those of `polynomial`. Here terms keep their positions while
//! divisors are taken out of many sums at once, and atoms may be sums themselves. Sorted terms
//! would give another order and another number of operations.

use crate::algebra::term::steps::Definition;
use crate::algebra::{Arena, Expr, Node, Rational};
use rustc_hash::FxHashMap;

/// Number of an atom (a leaf, an inverse or a sum of the network): its position in the list
/// [`Network::atoms`].
pub(super) type Atom = u32;

/// Product Π atom^exponent as pairs (atom, exponent), sorted by atom, with positive exponents.
pub(super) type Factors = Vec<(Atom, u32)>;

/// Term k · Π atom^exponent of a sum.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct NetworkTerm {
    /// Rational coefficient k of the term k · Π atom^exponent.
    pub k: Rational,
    /// Atoms of the term k · Π atom^exponent, with their exponents.
    pub factors: Factors,
}

impl NetworkTerm {
    /// Number of multiplications that the term needs, between its factors and by k.
    pub fn multiplications(&self) -> usize {
        let degree: u32 = self.factors.iter().map(|(_, n)| *n).sum();
        (degree as usize + usize::from(!is_unit(&self.k))).saturating_sub(1)
    }
}

/// True if the number is 1 or −1.
pub(super) fn is_unit(k: &Rational) -> bool {
    *k == Rational::ONE || *k == Rational::MINUS_ONE
}

/// Value of an atom: a leaf, the inverse of another atom, or a sum.
#[derive(Clone, Debug)]
pub(super) enum Value {
    /// A symbol, π, or a function value, which the network does not look into.
    Leaf(Expr),
    /// The inverse 1/a of another atom a.
    Inverse(Atom),
    /// A sum of terms. The position of a term that was taken out holds `None`.
    Sum(Vec<Option<NetworkTerm>>),
}

/// Atom of a network: its value, with its symbol if it must have one.
#[derive(Clone, Debug)]
pub(super) struct Member {
    /// Value of the atom: a leaf, an inverse or a sum.
    pub value: Value,
    /// Symbol of the step that the atom defines; `None` if the atom need not be a step.
    pub symbol: Option<Expr>,
}

/// Steps and outputs of a function, as sums over numbered atoms.
#[derive(Clone, Debug, Default)]
pub(super) struct Network {
    /// All atoms of the network, by number.
    pub atoms: Vec<Member>,
    /// Atoms whose values are the steps of the computation, in the given order.
    pub steps: Vec<Atom>,
    /// Atoms whose values are the outputs, in the given order.
    pub values: Vec<Atom>,
    /// Steps whose symbols occur inside each leaf, for instance inside a square root.
    pub inside: FxHashMap<Atom, Vec<Atom>>,
    /// Atom of each term that was read, and of each step's symbol.
    known: FxHashMap<Expr, Atom>,
    /// Atom of the inverse 1/a, by the atom a, for each inverse that occurs.
    inverses: FxHashMap<Atom, Atom>,
}

impl Network {
    /// Builds the network of the given steps and values.
    pub fn new(arena: &Arena, steps: &[Definition], values: &[Expr]) -> Self {
        let mut network = Self::default();
        for step in steps {
            let at = network.sum_atom(arena, step.value);
            network.atoms[at as usize].symbol = Some(step.symbol);
            network.known.insert(step.symbol, at);
            network.steps.push(at);
        }
        for value in values {
            let at = match network.known.get(value) {
                Some(known) => *known,
                None => network.sum_atom(arena, *value),
            };
            network.values.push(at);
        }
        network
    }

    /// Adds an atom with the given value and returns its number.
    pub fn push_atom(&mut self, value: Value) -> Atom {
        self.atoms.push(Member { value, symbol: None });
        Atom::try_from(self.atoms.len() - 1).expect("fewer atoms than terms fit in memory")
    }

    /// Remaining terms of a sum, each with its position; none if the atom is not a sum.
    pub fn terms(&self, sum: Atom) -> impl Iterator<Item = (usize, &NetworkTerm)> {
        let list: &[Option<NetworkTerm>] = match &self.atoms[sum as usize].value {
            Value::Sum(terms) => terms,
            Value::Leaf(_) | Value::Inverse(_) => &[],
        };
        list.iter().enumerate().filter_map(|(at, term)| Some((at, term.as_ref()?)))
    }

    /// Adds an atom for the sum of the terms of `e`, and atoms for the sums inside its products.
    fn sum_atom(&mut self, arena: &Arena, e: Expr) -> Atom {
        // Operands have smaller handles, so inner sums are read before the terms that contain them.
        for part in arena.reachable(&[e]) {
            if let Node::Product(factors) = arena.node(part) {
                for (base, _) in factors {
                    if matches!(arena.node(*base), Node::Sum(..)) && !self.known.contains_key(base) {
                        let terms = self.terms_of(arena, *base);
                        let at = self.push_atom(Value::Sum(terms));
                        self.known.insert(*base, at);
                    }
                }
            }
        }
        let terms = self.terms_of(arena, e);
        self.push_atom(Value::Sum(terms))
    }

    /// Splits a term of the arena into the terms of a sum.
    fn terms_of(&mut self, arena: &Arena, e: Expr) -> Vec<Option<NetworkTerm>> {
        match arena.node(e) {
            Node::Number(k) if k.is_zero() => Vec::new(),
            Node::Number(k) => vec![Some(NetworkTerm { k: k.clone(), factors: Vec::new() })],
            Node::Sum(constant, terms) => {
                let constant = (!constant.is_zero()).then(|| NetworkTerm { k: constant.clone(), factors: Vec::new() });
                let terms =
                    terms.iter().map(|(term, k)| NetworkTerm { k: k.clone(), factors: self.monomial(arena, *term) });
                constant.into_iter().chain(terms).map(Some).collect()
            }
            _ => vec![Some(NetworkTerm { k: Rational::ONE, factors: self.monomial(arena, e) })],
        }
    }

    /// Reads a product of the arena as a list of factors with positive exponents. Each divisor
    /// becomes the atom of its inverse.
    fn monomial(&mut self, arena: &Arena, e: Expr) -> Factors {
        let whole = [(e, 1)];
        let factors: &[(Expr, i32)] = match arena.node(e) {
            Node::Product(factors) => factors,
            _ => &whole,
        };
        let mut list: Factors = Vec::with_capacity(factors.len());
        for (base, n) in factors {
            let mut atom = self.atom(arena, *base);
            if *n < 0 {
                atom = self.inverse(atom);
            }
            list.push((atom, n.unsigned_abs()));
        }
        list.sort_unstable();
        list
    }

    /// Atom of a term of the arena. A new term becomes a leaf of the network.
    fn atom(&mut self, arena: &Arena, e: Expr) -> Atom {
        if let Some(known) = self.known.get(&e) {
            return *known;
        }
        let at = self.push_atom(Value::Leaf(e));
        let is_symbol = |part: &Expr| matches!(arena.node(*part), Node::Symbol(_));
        let symbols = arena.reachable(&[e]).into_iter().filter(is_symbol);
        let steps: Vec<Atom> = symbols.filter_map(|symbol| self.known.get(&symbol).copied()).collect();
        self.inside.insert(at, steps);
        self.known.insert(e, at);
        at
    }

    /// Atom of the inverse of another atom. It is added to the network if it is new.
    fn inverse(&mut self, of: Atom) -> Atom {
        if let Some(known) = self.inverses.get(&of) {
            return *known;
        }
        let at = self.push_atom(Value::Inverse(of));
        self.inverses.insert(of, at);
        at
    }
}
