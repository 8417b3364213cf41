//! Derivatives along given rates, and substitution. One loop each over the shared graph; nothing is
//! expanded.

use super::{Arena, Expr, Function, Node, Rational};
use rustc_hash::FxHashMap;

/// Rebuilds `e` with mapped operands; `None` if a divisor became the literal 0.
fn rebuild(arena: &mut Arena, e: Expr, map: &FxHashMap<Expr, Expr>) -> Option<Expr> {
    Some(match arena.node(e).clone() {
        Node::Number(_) | Node::Symbol(_) | Node::Pi => e,
        Node::Sum(constant, terms) => {
            if terms.iter().all(|(term, _)| map[term] == *term) {
                return Some(e);
            }
            let constant = arena.number(constant);
            let mut new: Vec<_> = terms.iter().map(|(term, k)| (map[term], k.clone())).collect();
            new.push((constant, Rational::ONE));
            arena.linear_combination(&new)
        }
        Node::Product(factors) => {
            if factors.iter().all(|(base, _)| map[base] == *base) {
                return Some(e);
            }
            let new: Vec<_> = factors.iter().map(|(base, n)| (map[base], *n)).collect();
            arena.try_product(&new).ok()?
        }
        Node::Apply(f, argument) => {
            if map[&argument] == argument {
                e
            } else {
                arena.apply(f, map[&argument])
            }
        }
    })
}

/// Replaces symbols (or any other terms) by terms, everywhere at once.
///
/// Reuse one value for many expressions: what was rewritten once is remembered.
#[derive(Clone, Default)]
pub struct Substitution {
    map: FxHashMap<Expr, Expr>,
    /// The first term, if any, that has no value after the replacement since its divisor became 0. It was
    /// left as it was.
    pub undefined: Option<Expr>,
}

impl Substitution {
    /// Replaces the first of each pair by the second.
    #[must_use]
    pub fn new(pairs: &[(Expr, Expr)]) -> Self {
        Self { map: pairs.iter().copied().collect(), undefined: None }
    }

    /// `e` rewritten. A quotient whose divisor becomes the literal 0 is left as it was and noted in
    /// [`Self::undefined`].
    pub fn apply(&mut self, arena: &mut Arena, e: Expr) -> Expr {
        if let Some(&done) = self.map.get(&e) {
            return done;
        }
        for part in arena.reachable(&[e]) {
            if !self.map.contains_key(&part) {
                let new = rebuild(arena, part, &self.map);
                if new.is_none() {
                    self.undefined = self.undefined.or(Some(part));
                }
                self.map.insert(part, new.unwrap_or(part));
            }
        }
        self.map[&e]
    }
}

/// The derivative along given rates: d e = Σ (∂e/∂x)·rate(x).
///
/// With the one rate x ↦ 1 it is ∂/∂x; with q ↦ q̇, q̇ ↦ q̈ it is d/dt. Symbols without a rate are
/// constants.
#[derive(Clone, Default)]
pub struct Differential {
    map: FxHashMap<Expr, Expr>,
}

impl Differential {
    /// Along the given rates (symbol, rate).
    #[must_use]
    pub fn along(rates: &[(Expr, Expr)]) -> Self {
        Self { map: rates.iter().copied().collect() }
    }

    /// ∂/∂x.
    #[must_use]
    pub fn partial(x: Expr) -> Self {
        Self::along(&[(x, Expr::ONE)])
    }

    /// Gives a symbol a rate before the first expression that mentions it is differentiated.
    pub fn set_rate(&mut self, symbol: Expr, rate: Expr) {
        self.map.insert(symbol, rate);
    }

    /// The derivative of `e`.
    pub fn apply(&mut self, arena: &mut Arena, e: Expr) -> Expr {
        if let Some(&done) = self.map.get(&e) {
            return done;
        }
        for part in arena.reachable(&[e]) {
            if !self.map.contains_key(&part) {
                let derivative = self.one(arena, part);
                self.map.insert(part, derivative);
            }
        }
        self.map[&e]
    }

    fn one(&self, arena: &mut Arena, e: Expr) -> Expr {
        match arena.node(e).clone() {
            Node::Number(_) | Node::Symbol(_) | Node::Pi => Expr::ZERO,
            Node::Sum(_, terms) => {
                let terms: Vec<_> = terms.iter().map(|(term, k)| (self.map[term], k.clone())).collect();
                arena.linear_combination(&terms)
            }
            Node::Product(factors) => {
                let mut sum = Vec::new();
                for (at, &(base, n)) in factors.iter().enumerate() {
                    let inner = self.map[&base];
                    if inner == Expr::ZERO {
                        continue;
                    }
                    let mut term: Vec<(Expr, i32)> = factors.to_vec();
                    term[at].1 -= 1;
                    term.push((inner, 1));
                    let term = arena.try_product(&term).expect("bases are not zero, exponents hardly grow");
                    sum.push((term, Rational::integer(i64::from(n))));
                }
                arena.linear_combination(&sum)
            }
            Node::Apply(f, argument) => {
                let inner = self.map[&argument];
                if inner == Expr::ZERO {
                    return Expr::ZERO;
                }
                let outer = derivative_of(arena, f, argument, e);
                arena.mul(outer, inner)
            }
        }
    }
}

/// f′(x), where `value` is f(x).
fn derivative_of(arena: &mut Arena, f: Function, x: Expr, value: Expr) -> Expr {
    let one_over = |arena: &mut Arena, e: Expr| arena.div(Expr::ONE, e).expect("not the literal 0");
    match f {
        Function::Sin => arena.cos(x),
        Function::Cos => {
            let sine = arena.sin(x);
            arena.neg(sine)
        }
        Function::Sqrt => {
            let twice = arena.scale(value, &Rational::integer(2));
            one_over(arena, twice)
        }
        Function::Exp => value,
        Function::Log => one_over(arena, x),
        Function::Asin | Function::Acos => {
            let square = arena.square(x);
            let radicand = arena.sub(Expr::ONE, square);
            let root = arena.apply(Function::Sqrt, radicand);
            let slope = one_over(arena, root);
            if f == Function::Asin { slope } else { arena.neg(slope) }
        }
        Function::Atan => {
            let square = arena.square(x);
            let sum = arena.add(Expr::ONE, square);
            one_over(arena, sum)
        }
        Function::Sinh => arena.apply(Function::Cosh, x),
        Function::Cosh => arena.apply(Function::Sinh, x),
        Function::Tanh => {
            let square = arena.square(value);
            arena.sub(Expr::ONE, square)
        }
        Function::Abs => arena.apply(Function::Sign, x),
        // Away from the jump.
        Function::Sign => Expr::ZERO,
    }
}
