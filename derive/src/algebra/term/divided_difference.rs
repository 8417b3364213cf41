//! Divided differences: (e(b) − e(a))/(b − a) as a term without that subtraction, so that no digits
//! are lost for b near a.
//!
//! Each function has a rule that gives its divided difference from those of its operands. So one
//! loop over the shared graph gives the divided difference of any term, as for a derivative. At b =
//! a each rule becomes the rule of the derivative, so the term is valid there too.
//!
//! Absent on purpose: a function sinc z = sin z/z in the arena. Only the rules of sine and cosine
//! need it. As a function it would have to be known to every pass over terms, to both zero tests
//! and to the recurrences of Taylor coefficients. To the zero tests sin z/z is an ordinary
//! quotient, and sinc z would be an atom without rules.
//!
//! So the values of sinc are inputs of the term, listed by name in `DividedDifference::sincs`. The
//! code that evaluates the term takes sin z/z as 1 at z = 0.

use super::calculus::{Differential, Substitution};
use crate::algebra::{Arena, Expr, Function, Node, Rational};
use rustc_hash::FxHashMap;

/// Divided difference of a term, with the values of sinc z = sin z/z that it contains as symbols.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct DividedDifference {
    /// Divided difference (e(b) − e(a))/(b − a) as a term, in which the symbols of `sincs` occur.
    pub value: Expr,
    /// Pairs (symbol, z): the symbol stands for sinc z = sin z/z, which is 1 at z = 0. Each z is k
    /// (b − a)/2, in radians; no two entries differ only in the sign of z.
    pub sincs: Vec<(Expr, Expr)>,
}

/// Divided difference e\[a, b\] = (e(b) − e(a))/(b − a) of `e` as a function of the symbol `x`. At
/// a = b it is de/dx. Its unit is that of de/dx.
///
/// The term subtracts nothing that the derivative does not subtract. The rules are:
///
/// - constant: 0; symbol x: 1; sum: term by term
/// - product: (f g)\[a, b\] = f\[a, b\] g(b) + f(a) g\[a, b\]
/// - inverse: −f\[a, b\]/(f(a) f(b))
/// - power: by halves, f²ⁿ\[a, b\] = fⁿ\[a, b\] (fⁿ(a) + fⁿ(b))
/// - root: f\[a, b\]/(√f(a) + √f(b)); odd powers of √f by these rules
/// - sine: sin(k x + c)\[a, b\] = k sinc(k (b − a)/2) cos(k (a + b)/2 + c)
/// - cosine: the rule of the sine with −sin in place of cos
///
/// `None` in three cases. The argument of a sine or cosine is not linear in x by form. Or x occurs
/// in another function, such as exp, asin or |x|. Or a divisor becomes the literal 0 at a or b.
///
/// L. M. Milne-Thomson, *The Calculus of Finite Differences* (1933), ch. I; the rules are those of Leibniz and
/// Steffensen.
///
/// ```
/// use tripos_derive::algebra::Arena;
/// use tripos_derive::algebra::term::divided_difference::divided_difference;
/// use tripos_derive::algebra::text::{parse::parse_free, print::print_text};
///
/// let arena = &mut Arena::new();
/// let [x, a, b] = ["x", "a", "b"].map(|name| arena.symbol(name));
/// let e = parse_free(arena, "x^2 + 3*x").unwrap();
/// let divided = divided_difference(arena, e, x, a, b).unwrap();
/// assert_eq!(print_text(arena, divided.value), "3 + a + b");
/// ```
pub fn divided_difference(arena: &mut Arena, e: Expr, x: Expr, a: Expr, b: Expr) -> Option<DividedDifference> {
    let mut rules = DividedRules {
        x,
        ends: [a, b],
        at: [Substitution::new(&[(x, a)]), Substitution::new(&[(x, b)])],
        slope: Differential::partial(x),
        map: FxHashMap::from_iter([(x, Expr::ONE)]),
        sincs: Vec::new(),
    };
    for part in arena.reachable(&[e]) {
        if part != x {
            let difference = rules.divided_difference_of_node(arena, part)?;
            rules.map.insert(part, difference);
        }
    }
    let defined = rules.at.iter().all(|at| at.undefined.is_none());
    defined.then(|| DividedDifference { value: rules.map[&e], sincs: rules.sincs })
}

/// State of the computation of a divided difference: the divided difference of every subterm so
/// far, and the substitutions of both ends.
struct DividedRules {
    /// Symbol x, as a function of which the divided difference is taken.
    x: Expr,
    /// Ends a and b of the interval, as terms.
    ends: [Expr; 2],
    /// Substitutions x ↦ a and x ↦ b, which give the values of a part at both ends.
    at: [Substitution; 2],
    /// Partial derivative with respect to x, for the factors k in sin(k x + c).
    slope: Differential,
    /// Divided difference of each subterm computed so far.
    map: FxHashMap<Expr, Expr>,
    /// Pairs (symbol, z) of the values sinc z used so far.
    sincs: Vec<(Expr, Expr)>,
}

/// Values f(a) and f(b) of a function at both ends, with its divided difference (f(b) − f(a))/(b −
/// a).
#[derive(Clone, Copy)]
struct DividedPair {
    /// Value f(a) at the first end.
    at_a: Expr,
    /// Value f(b) at the second end.
    at_b: Expr,
    /// Divided difference (f(b) − f(a))/(b − a).
    difference: Expr,
}

impl DividedRules {
    /// Divided difference of a term from those of its operands. `None` if no rule covers the term
    /// or a divisor becomes 0.
    fn divided_difference_of_node(&mut self, arena: &mut Arena, e: Expr) -> Option<Expr> {
        if arena.operands(e).all(|operand| self.map[&operand] == Expr::ZERO) {
            return Some(Expr::ZERO);
        }
        match arena.node(e).clone() {
            Node::Number(_) | Node::Symbol(_) | Node::Pi => Some(Expr::ZERO),
            Node::Named(_, term) => Some(self.map[&term]),
            Node::Sum(_, terms) => {
                let terms: Vec<_> = terms.iter().map(|(term, k)| (self.map[term], k.clone())).collect();
                Some(arena.linear_combination(&terms))
            }
            Node::Product(factors) => self.divided_difference_of_product(arena, &factors),
            Node::Apply(Function::Sqrt, argument) => {
                let DividedPair { at_a, at_b, difference } = self.end_values(arena, argument);
                let roots = [at_a, at_b].map(|value| arena.apply(Function::Sqrt, value));
                let sum = arena.add(roots[0], roots[1]);
                arena.div(difference, sum)
            }
            Node::Apply(f @ (Function::Sin | Function::Cos), argument) => {
                self.divided_difference_of_wave(arena, f, argument)
            }
            Node::Apply(..) => None,
        }
    }

    /// Values of a subterm at both ends, with its divided difference, which must already be in
    /// `map`.
    fn end_values(&mut self, arena: &mut Arena, e: Expr) -> DividedPair {
        let [at_a, at_b] = self.at.each_mut().map(|at| at.apply(arena, e));
        DividedPair { at_a, at_b, difference: self.map[&e] }
    }

    /// Divided difference of a product Π fᵢ: Σᵢ (Π_{j<i} fⱼ(a)) fᵢ\[a, b\] (Π_{j>i} fⱼ(b)). `None`
    /// if a divisor becomes 0.
    fn divided_difference_of_product(&mut self, arena: &mut Arena, factors: &[(Expr, i32)]) -> Option<Expr> {
        let (content, powers) = join_divided_roots(arena, factors);
        let mut whole = DividedPair { at_a: Expr::ONE, at_b: Expr::ONE, difference: Expr::ZERO };
        for (base, n) in powers {
            let base = self.end_values(arena, base);
            let factor = power_of_pair(arena, base, n)?;
            whole = multiply_pairs(arena, whole, factor)?;
        }
        Some(arena.scale(whole.difference, &content))
    }

    /// Divided difference of sin(k x + c): k sinc(k (b − a)/2) cos(k (a + b)/2 + c). For the
    /// cosine, −sin takes the place of cos(k (a + b)/2 + c). `None` if the argument is not linear
    /// in x.
    fn divided_difference_of_wave(&mut self, arena: &mut Arena, f: Function, argument: Expr) -> Option<Expr> {
        let k = self.slope.apply(arena, argument);
        if arena.mentions(k, self.x) {
            return None;
        }
        let DividedPair { at_a, at_b, .. } = self.end_values(arena, argument);
        let half = Rational::fraction(1, 2)?;
        let middle = arena.linear_combination(&[(at_a, half.clone()), (at_b, half.clone())]);
        let outer = if f == Function::Sin {
            arena.cos(middle)
        } else {
            let sine = arena.sin(middle);
            arena.neg(sine)
        };
        let width = arena.sub(self.ends[1], self.ends[0]);
        let z = arena.mul(k, width);
        let z = arena.scale(z, &half);
        let sinc = self.sinc(arena, z);
        Some(arena.product(&[k, sinc, outer]))
    }

    /// Symbol that stands for sinc z = sin z/z, recorded in `sincs`. z and −z share a symbol, since
    /// sinc is even. Returns 1 if z is 0.
    fn sinc(&mut self, arena: &mut Arena, z: Expr) -> Expr {
        let opposite = arena.neg(z);
        if z == opposite {
            return Expr::ONE;
        }
        if let Some((symbol, _)) = self.sincs.iter().find(|(_, known)| *known == z || *known == opposite) {
            return *symbol;
        }
        // Among so many names at least one is free.
        let names = 1..=arena.symbol_names().len() + 1;
        let free = names.map(|i| format!("sinc{i}")).find(|name| arena.find_symbol(name).is_none());
        let symbol = arena.symbol(&free.unwrap_or_default());
        self.sincs.push((symbol, z));
        symbol
    }
}

/// Product of two functions f and g, each given by its values at both ends and its divided
/// difference. The rule is (f g)\[a, b\] = f\[a, b\] g(b) + f(a) g\[a, b\]. `None` if a divisor is 0.
fn multiply_pairs(arena: &mut Arena, f: DividedPair, g: DividedPair) -> Option<DividedPair> {
    let mut product = |factors: &[(Expr, i32)]| arena.try_product(factors).ok();
    let first = product(&[(f.difference, 1), (g.at_b, 1)])?;
    let second = product(&[(f.at_a, 1), (g.difference, 1)])?;
    let (at_a, at_b) = (product(&[(f.at_a, 1), (g.at_a, 1)])?, product(&[(f.at_b, 1), (g.at_b, 1)])?);
    Some(DividedPair { at_a, at_b, difference: arena.add(first, second) })
}

/// Power fⁿ for n ≠ 0, by the binary digits of |n|: its values at both ends and its divided
/// difference. Nothing cancels if f changes its sign between a and b, and the term grows only with
/// the number of digits. `None` if a divisor is 0.
fn power_of_pair(arena: &mut Arena, f: DividedPair, n: i32) -> Option<DividedPair> {
    let size = n.unsigned_abs();
    let mut result = f;
    for digit in (0..size.checked_ilog2()?).rev() {
        let sum = arena.add(result.at_a, result.at_b);
        result = DividedPair {
            at_a: arena.pow(result.at_a, 2).ok()?,
            at_b: arena.pow(result.at_b, 2).ok()?,
            difference: arena.try_product(&[(result.difference, 1), (sum, 1)]).ok()?,
        };
        if size >> digit & 1 == 1 {
            result = multiply_pairs(arena, result, f)?;
        }
    }
    if n > 0 {
        return Some(result);
    }
    let quotient = arena.try_product(&[(result.difference, 1), (result.at_a, -1), (result.at_b, -1)]).ok()?;
    Some(DividedPair {
        at_a: arena.pow(result.at_a, -1).ok()?,
        at_b: arena.pow(result.at_b, -1).ok()?,
        difference: arena.neg(quotient),
    })
}

/// Writes each product √g gⁿ among the factors as (√g)²ⁿ⁺¹. Returns the numerical factor that
/// remains, and the new factors. Otherwise the divided difference of √g · 1/g would subtract nearly
/// equal values if g(b) is much larger than g(a).
fn join_divided_roots(arena: &mut Arena, factors: &[(Expr, i32)]) -> (Rational, Vec<(Expr, i32)>) {
    let mut powers = factors.to_vec();
    let mut content = Rational::ONE;
    for at in 0..powers.len() {
        let Node::Apply(Function::Sqrt, argument) = *arena.node(powers[at].0) else { continue };
        let (scale, primitive) = arena.split_content(argument);
        let inner = match arena.node(primitive) {
            Node::Product(inner) => inner.to_vec(),
            _ => vec![(primitive, 1)],
        };
        let exponent = |base: Expr| powers.iter().find(|(other, _)| *other == base).map_or(0, |(_, n)| *n);
        let n = exponent(inner[0].0) / inner[0].1;
        let whole = n != 0 && inner.iter().all(|(base, k)| exponent(*base) == n * k);
        if let Some(rest) = scale.pow(-n).filter(|_| whole && powers[at].1 == 1) {
            content = content.mul(&rest);
            powers[at].1 = 2 * n + 1;
            for (_, n) in powers.iter_mut().filter(|(base, _)| inner.iter().any(|(other, _)| other == base)) {
                *n = 0;
            }
        }
    }
    powers.retain(|(_, n)| *n != 0);
    (content, powers)
}
