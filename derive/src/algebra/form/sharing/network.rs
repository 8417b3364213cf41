//! Network of steps and values as sums of monomials over numbered atoms.
//!
//! These sums are separate from those of `polynomial`. Here terms keep their places while divisors are taken out of
//! many sums at once, and atoms are sums themselves. Sorted terms would come out in another order, at other counts.

use crate::algebra::term::steps::Definition;
use crate::algebra::{Arena, Expr, Node, Rational};
use rustc_hash::FxHashMap;

/// Number of an atom: its position in [`Network::atoms`].
pub(super) type Atom = u32;

/// Product Π atom^exponent, sorted by atom, with positive exponents.
pub(super) type Factors = Vec<(Atom, u32)>;

/// Term of a sum, k · Π atom^exponent.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Term {
    pub k: Rational,
    pub factors: Factors,
}

impl Term {
    /// Number of multiplications in the term, between its factors and by k.
    pub fn multiplications(&self) -> usize {
        let degree: u32 = self.factors.iter().map(|(_, n)| *n).sum();
        (degree as usize + usize::from(!is_unit(&self.k))).saturating_sub(1)
    }
}

/// True if a number is 1 or −1.
pub(super) fn is_unit(k: &Rational) -> bool {
    *k == Rational::ONE || *k == Rational::MINUS_ONE
}

/// Value of an atom: a leaf, the inverse of another atom, or a sum.
#[derive(Clone, Debug)]
pub(super) enum Value {
    /// A symbol, π, or a function value.
    Leaf(Expr),
    /// The inverse 1/a of another atom a.
    Inverse(Atom),
    /// A sum of terms; a term that was taken out leaves its place empty.
    Sum(Vec<Option<Term>>),
}

/// An atom and the symbol that stands for it, if it must have one.
#[derive(Clone, Debug)]
pub(super) struct Member {
    pub value: Value,
    pub symbol: Option<Expr>,
}

/// Steps and outputs to compute, as sums over numbered atoms.
#[derive(Clone, Debug, Default)]
pub(super) struct Network {
    pub atoms: Vec<Member>,
    /// Atoms of the steps, in the given order.
    pub steps: Vec<Atom>,
    /// Atoms of the outputs, in the given order.
    pub values: Vec<Atom>,
    /// Steps whose symbols occur inside each leaf, such as inside a square root.
    pub inside: FxHashMap<Atom, Vec<Atom>>,
    /// Atoms by the term that they stand for.
    known: FxHashMap<Expr, Atom>,
    inverses: FxHashMap<Atom, Atom>,
}

impl Network {
    /// Builds the network of steps and values.
    pub fn new(arena: &Arena, steps: &[Definition], values: &[Expr]) -> Self {
        let mut network = Self::default();
        for step in steps {
            let at = network.sum(arena, step.value);
            network.atoms[at as usize].symbol = Some(step.symbol);
            network.known.insert(step.symbol, at);
            network.steps.push(at);
        }
        for value in values {
            let at = match network.known.get(value) {
                Some(known) => *known,
                None => network.sum(arena, *value),
            };
            network.values.push(at);
        }
        network
    }

    /// Adds an atom with this value and returns its number.
    pub fn push(&mut self, value: Value) -> Atom {
        self.atoms.push(Member { value, symbol: None });
        Atom::try_from(self.atoms.len() - 1).expect("fewer atoms than terms fit in memory")
    }

    /// Remaining terms of a sum with their places.
    pub fn terms(&self, sum: Atom) -> impl Iterator<Item = (usize, &Term)> {
        let list: &[Option<Term>] = match &self.atoms[sum as usize].value {
            Value::Sum(terms) => terms,
            Value::Leaf(_) | Value::Inverse(_) => &[],
        };
        list.iter().enumerate().filter_map(|(at, term)| Some((at, term.as_ref()?)))
    }

    /// A new sum atom that holds the terms of `e`.
    fn sum(&mut self, arena: &Arena, e: Expr) -> Atom {
        // Operands have smaller handles, so inner sums are read before the terms that contain them.
        for part in arena.reachable(&[e]) {
            if let Node::Product(factors) = arena.node(part) {
                for (base, _) in factors {
                    if matches!(arena.node(*base), Node::Sum(..)) && !self.known.contains_key(base) {
                        let terms = self.read(arena, *base);
                        let at = self.push(Value::Sum(terms));
                        self.known.insert(*base, at);
                    }
                }
            }
        }
        let terms = self.read(arena, e);
        self.push(Value::Sum(terms))
    }

    fn read(&mut self, arena: &Arena, e: Expr) -> Vec<Option<Term>> {
        match arena.node(e) {
            Node::Number(k) if k.is_zero() => Vec::new(),
            Node::Number(k) => vec![Some(Term { k: k.clone(), factors: Vec::new() })],
            Node::Sum(constant, terms) => {
                let constant = (!constant.is_zero()).then(|| Term { k: constant.clone(), factors: Vec::new() });
                let terms = terms.iter().map(|(term, k)| Term { k: k.clone(), factors: self.monomial(arena, *term) });
                constant.into_iter().chain(terms).map(Some).collect()
            }
            _ => vec![Some(Term { k: Rational::ONE, factors: self.monomial(arena, e) })],
        }
    }

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

    fn atom(&mut self, arena: &Arena, e: Expr) -> Atom {
        if let Some(known) = self.known.get(&e) {
            return *known;
        }
        let at = self.push(Value::Leaf(e));
        let is_symbol = |part: &Expr| matches!(arena.node(*part), Node::Symbol(_));
        let symbols = arena.reachable(&[e]).into_iter().filter(is_symbol);
        let steps: Vec<Atom> = symbols.filter_map(|symbol| self.known.get(&symbol).copied()).collect();
        self.inside.insert(at, steps);
        self.known.insert(e, at);
        at
    }

    fn inverse(&mut self, of: Atom) -> Atom {
        if let Some(known) = self.inverses.get(&of) {
            return *known;
        }
        let at = self.push(Value::Inverse(of));
        self.inverses.insert(of, at);
        at
    }
}
