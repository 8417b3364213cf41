//! Derivatives along given rates, gradients, and substitution. Each operation is one loop over the
//! shared graph of terms; nothing is expanded.

use crate::algebra::{Arena, Expr, Function, Node, Rational};
use rustc_hash::FxHashMap;
use std::rc::Rc;

/// Rebuilds the term `e` from new operands; `map` has the new operand for each old one. `None` if a
/// divisor became the literal 0.
fn substitute_operands(arena: &mut Arena, e: Expr, map: &FxHashMap<Expr, Expr>) -> Option<Expr> {
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
        Node::Named(_, term) => {
            if map[&term] == term {
                e
            } else {
                arena.name_like(e, map[&term])
            }
        }
    })
}

/// Substitution of terms for symbols, or for any other terms, wherever they occur.
///
/// Reuse a value for many expressions: it remembers every term that it has rewritten.
#[derive(Clone, Default)]
pub struct Substitution {
    /// Replacement of each term: the given pairs, and the result for every term rewritten so far.
    map: FxHashMap<Expr, Expr>,
    /// First term in which a divisor became 0 by the substitution; this term was left unchanged.
    /// `None` if there is no such term.
    pub undefined: Option<Expr>,
}

impl Substitution {
    /// Creates the substitution that replaces the first term of each pair by the second.
    #[must_use]
    pub fn new(pairs: &[(Expr, Expr)]) -> Self {
        Self { map: pairs.iter().copied().collect(), undefined: None }
    }

    /// Adds a replacement of a symbol by a value. Call it before an expression that mentions the
    /// symbol is rewritten.
    pub fn set(&mut self, symbol: Expr, value: Expr) {
        self.map.insert(symbol, value);
    }

    /// True if the replacement of the term `e` is already known: it was given, or `e` was rewritten
    /// before.
    #[must_use]
    pub fn knows(&self, e: Expr) -> bool {
        self.map.contains_key(&e)
    }

    /// Rewrites the term `e` by the substitution. A quotient whose divisor becomes the literal 0 is
    /// left unchanged and recorded in [`Self::undefined`].
    pub fn apply(&mut self, arena: &mut Arena, e: Expr) -> Expr {
        if let Some(&done) = self.map.get(&e) {
            return done;
        }
        for part in arena.reachable_until(&[e], |part| self.map.contains_key(&part)) {
            let new = substitute_operands(arena, part, &self.map);
            if new.is_none() {
                self.undefined = self.undefined.or(Some(part));
            }
            self.map.insert(part, new.unwrap_or(part));
        }
        self.map[&e]
    }

    /// Rewrites several terms by the substitution and returns them in their order; see
    /// [`Self::apply`].
    pub fn all(&mut self, arena: &mut Arena, terms: &[Expr]) -> Vec<Expr> {
        terms.iter().map(|e| self.apply(arena, *e)).collect()
    }
}

/// Replaces all named terms within `e` by the expressions that the names abbreviate.
pub fn expand_names(arena: &mut Arena, e: Expr) -> Expr {
    let mut put = Substitution::default();
    for part in arena.reachable(&[e]) {
        if let Node::Named(_, term) = *arena.node(part) {
            let value = put.apply(arena, term);
            put.set(part, value);
        }
    }
    put.apply(arena, e)
}

/// Derivative of terms along given rates: the derivative of e is Σ (∂e/∂x)·rate(x) over the symbols
/// x.
///
/// With a single rate x ↦ 1 it is ∂/∂x; with the rates q ↦ q̇, q̇ ↦ q̈ it is d/dt. Symbols without
/// a rate are constants. Reuse a value for many expressions: it remembers every derivative.
#[derive(Clone, Default)]
pub struct Differential {
    /// Derivative of each term: the given rates of symbols, and every term differentiated so far.
    map: FxHashMap<Expr, Expr>,
}

impl Differential {
    /// Creates the derivative along the given pairs (symbol, rate of the symbol).
    #[must_use]
    pub fn along(rates: &[(Expr, Expr)]) -> Self {
        Self { map: rates.iter().copied().collect() }
    }

    /// Creates the partial derivative ∂/∂x with respect to a symbol x.
    #[must_use]
    pub fn partial(x: Expr) -> Self {
        Self::along(&[(x, Expr::ONE)])
    }

    /// Adds the rate of a symbol. Call it before an expression that mentions the symbol is
    /// differentiated.
    pub fn set_rate(&mut self, symbol: Expr, rate: Expr) {
        self.map.insert(symbol, rate);
    }

    /// Differentiates the term `e` along the rates.
    pub fn apply(&mut self, arena: &mut Arena, e: Expr) -> Expr {
        if let Some(&done) = self.map.get(&e) {
            return done;
        }
        for part in arena.reachable_until(&[e], |part| self.map.contains_key(&part)) {
            let derivative = self.derivative_of_node(arena, part);
            self.map.insert(part, derivative);
        }
        self.map[&e]
    }

    /// Derivative of a term from the derivatives of its operands, which `map` must contain.
    fn derivative_of_node(&self, arena: &mut Arena, e: Expr) -> Expr {
        if arena.operands(e).all(|operand| self.map[&operand] == Expr::ZERO) {
            return Expr::ZERO;
        }
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
            Node::Named(_, term) => arena.name_like(e, self.map[&term]),
        }
    }
}

/// Non-zero partial derivatives of a term e, as pairs (number of the variable x, ∂e/∂x), in the
/// order of the variables. Derivatives that are 0 by form are left out.
pub type Slopes = Rc<[(usize, Expr)]>;

/// Gradient of terms: their partial derivatives with respect to several variables. Derivatives that
/// are 0 by form are left out.
///
/// One pass computes all derivatives, whereas [`Differential::partial`] takes a pass for each
/// variable. Reuse a value for many expressions: it remembers every gradient.
pub struct Gradient {
    /// Gradient of each variable and of every term differentiated so far.
    map: FxHashMap<Expr, Slopes>,
    /// Empty gradient, shared by all terms that depend on no variable.
    nothing: Slopes,
}

impl Gradient {
    /// Creates the gradient with respect to the given variables, which are numbered from 0 in their
    /// order.
    #[must_use]
    pub fn new(variables: &[Expr]) -> Self {
        let nothing: Slopes = Rc::new([]);
        let map = variables.iter().enumerate().map(|(at, x)| (*x, Rc::new([(at, Expr::ONE)]) as Slopes)).collect();
        Self { map, nothing }
    }

    /// Computes the gradient of the term `e`: pairs (number of the variable, derivative).
    /// Derivatives that are 0 by form are left out.
    pub fn apply(&mut self, arena: &mut Arena, e: Expr) -> Slopes {
        if let Some(done) = self.map.get(&e) {
            return done.clone();
        }
        for part in arena.reachable_until(&[e], |part| self.map.contains_key(&part)) {
            let slopes = self.gradient_of_node(arena, part);
            self.map.insert(part, slopes);
        }
        self.map[&e].clone()
    }

    /// Gradient of a term from the gradients of its operands, which `map` must contain.
    fn gradient_of_node(&self, arena: &mut Arena, e: Expr) -> Slopes {
        if arena.operands(e).all(|operand| self.map[&operand].is_empty()) {
            return self.nothing.clone();
        }
        // (variable, term, factor), to be added up variable by variable.
        let mut shares: Vec<(usize, Expr, Rational)> = Vec::new();
        match arena.node(e).clone() {
            Node::Number(_) | Node::Symbol(_) | Node::Pi => {}
            Node::Sum(_, terms) => {
                for (term, k) in &terms {
                    shares.extend(self.map[term].iter().map(|(at, slope)| (*at, *slope, k.clone())));
                }
            }
            Node::Product(factors) => {
                for (place, (base, n)) in factors.iter().enumerate() {
                    for &(at, slope) in self.map[base].iter() {
                        let mut term: Vec<(Expr, i32)> = factors.to_vec();
                        term[place].1 -= 1;
                        term.push((slope, 1));
                        let term = arena.try_product(&term).expect("bases are not zero, exponents hardly grow");
                        shares.push((at, term, Rational::integer(i64::from(*n))));
                    }
                }
            }
            Node::Apply(f, argument) => {
                let outer = derivative_of(arena, f, argument, e);
                for (at, inner) in self.map[&argument].iter() {
                    shares.push((*at, arena.mul(outer, *inner), Rational::ONE));
                }
            }
            Node::Named(_, term) => {
                let slopes = self.map[&term].clone();
                return slopes.iter().map(|(at, slope)| (*at, arena.name_like(e, *slope))).collect();
            }
        }
        shares.sort_by_key(|(at, ..)| *at);
        let sums = shares.chunk_by(|a, b| a.0 == b.0).map(|group| {
            let terms: Vec<(Expr, Rational)> = group.iter().map(|(_, term, k)| (*term, k.clone())).collect();
            (group[0].0, arena.linear_combination(&terms))
        });
        sums.filter(|(_, slope)| *slope != Expr::ZERO).collect()
    }
}

/// Derivative f′(x) of an elementary function, where `value` is the term f(x).
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
        // The derivative of sign x is 0 everywhere except at the jump at 0.
        Function::Sign => Expr::ZERO,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::text::parse::parse_free;

    /// A gradient has the same derivatives as one differentiation for each variable. The terms are
    /// compared by handle.
    #[test]
    fn a_gradient_holds_the_partial_derivatives() {
        let mut arena = Arena::new();
        let variables = ["a", "b", "c"].map(|name| arena.symbol(name));
        for text in
            ["a", "m", "a*b^2*sin(c) + m*b", "sqrt(a^2 + b^2)/c", "exp(a*m)*(a + 2*b - c)^3", "tan(a - b) + a - a"]
        {
            let e = parse_free(&mut arena, text).unwrap();
            let slopes = Gradient::new(&variables).apply(&mut arena, e);
            let found = |at: usize| slopes.iter().find(|(i, _)| *i == at).map_or(Expr::ZERO, |(_, slope)| *slope);
            for (at, x) in variables.iter().enumerate() {
                assert_eq!(found(at), Differential::partial(*x).apply(&mut arena, e), "{text} along {at}");
            }
            assert!(
                slopes.windows(2).all(|pair| pair[0].0 < pair[1].0) && slopes.iter().all(|(_, e)| *e != Expr::ZERO)
            );
        }
    }

    /// Subterms come after their operands, for short lists (sorted by comparison) and long lists
    /// (sorted by bits).
    #[test]
    fn terms_are_reached_operands_first() {
        let mut arena = Arena::new();
        let mut e = arena.symbol("x");
        for _ in 0..500 {
            let sine = arena.sin(e);
            e = arena.add(sine, Expr::ONE);
        }
        let far = arena.cos(e);
        let near = arena.symbol("y");
        for roots in [vec![far], vec![near, far], vec![near], vec![e, e]] {
            let all = arena.reachable(&roots);
            assert!(all.windows(2).all(|pair| pair[0] < pair[1]), "sorted, each once");
            assert!(all.iter().all(|e| arena.operands(*e).all(|operand| all.binary_search(&operand).is_ok())));
            assert!(roots.iter().all(|root| all.binary_search(root).is_ok()));
        }
    }
}
