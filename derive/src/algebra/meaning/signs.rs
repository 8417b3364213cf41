//! Signs of terms, derived from terms that are known to be positive. Known signs resolve square
//! roots and absolute values.
//!
//! The method is exact. A sign is claimed only if it follows from the form of a term, from positive
//! symbols and from terms known to be positive. Any other sign is [`Sign::Unknown`], and the term
//! is not changed.

use crate::algebra::form::normal_form::Normalizer;
use crate::algebra::term::calculus::Substitution;
use crate::algebra::value::interval::{PointInterval, enclose_in_interval};
use crate::algebra::{Arena, Expr, Function, Node, Rational};
use rustc_hash::FxHashMap;

/// Sign of the values of a term, as far as it is known.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sign {
    /// The value of the term is always above 0.
    Positive,
    /// The value of the term is always 0 or above.
    NotNegative,
    /// The value of the term is always below 0.
    Negative,
    /// The value of the term is always 0 or below.
    NotPositive,
    /// The sign of the term is not known.
    Unknown,
}

impl Sign {
    /// True if the sign excludes the value 0.
    pub const fn is_strict(self) -> bool {
        matches!(self, Self::Positive | Self::Negative)
    }

    /// Sign of the negative of the term.
    pub const fn negated(self) -> Self {
        match self {
            Self::Positive => Self::Negative,
            Self::Negative => Self::Positive,
            Self::NotNegative => Self::NotPositive,
            Self::NotPositive => Self::NotNegative,
            Self::Unknown => Self::Unknown,
        }
    }

    /// True if the sign excludes values below 0.
    const fn is_not_negative(self) -> bool {
        matches!(self, Self::Positive | Self::NotNegative)
    }

    /// Sign of the product k · term, for a rational number k other than 0.
    fn scaled(self, k: &Rational) -> Self {
        if k.is_negative() { self.negated() } else { self }
    }

    /// Sign of the product of two terms that have the given signs.
    fn times(self, other: Self) -> Self {
        match (self, other) {
            (Self::Unknown, _) | (_, Self::Unknown) => Self::Unknown,
            _ => {
                let strict = self.is_strict() && other.is_strict();
                let sign = if strict { Self::Positive } else { Self::NotNegative };
                if self.is_not_negative() == other.is_not_negative() { sign } else { sign.negated() }
            }
        }
    }

    /// Sign of a rational number; 0 gives `NotNegative`.
    fn of_number(value: &Rational) -> Self {
        match (value.is_zero(), value.is_negative()) {
            (true, _) => Self::NotNegative,
            (_, true) => Self::Negative,
            _ => Self::Positive,
        }
    }
}

/// Constant bounds of a term. The term never reaches them; a bound is `None` if it is not known.
#[derive(Clone, Debug)]
pub struct Bounds {
    /// Term that the bounds restrict, often a symbol.
    pub of: Expr,
    /// Lower bound: a constant that the term always exceeds; `None` if not known.
    pub low: Option<Expr>,
    /// Upper bound: a constant that the term always stays below; `None` if not known.
    pub high: Option<Expr>,
}

/// Facts about signs: terms that are known to be positive, and the bounds that follow from them.
#[derive(Clone, Debug, Default)]
pub struct Signs {
    /// Terms that are known to be positive in the states considered.
    positive: Vec<Expr>,
    /// Bounds of terms that follow from the positive terms.
    bounds: Vec<Bounds>,
}

/// Largest number of multiplications of polynomial terms in the search for the square root of a
/// sum.
const ROOT: u64 = 50_000;

impl Signs {
    /// Creates the facts about signs in states where each term of `positive` is positive.
    pub fn new(arena: &mut Arena, positive: &[Expr]) -> Self {
        let mut signs = Self { positive: positive.to_vec(), bounds: Vec::new() };
        for term in positive {
            signs.add_bound_from(arena, *term);
        }
        signs
    }

    /// True if no term is known to be positive.
    pub fn is_empty(&self) -> bool {
        self.positive.is_empty()
    }

    /// Constant bounds of the term `e`; `None` if no bound is known.
    pub fn bounds_of(&self, e: Expr) -> Option<&Bounds> {
        self.bounds.iter().find(|b| b.of == e)
    }

    /// Adds the bound of a term that follows from a positive term of the form constant + k · term.
    /// Positive terms of other forms give no bound.
    fn add_bound_from(&mut self, arena: &mut Arena, positive: Expr) {
        let (constant, terms) = match arena.node(positive).clone() {
            Node::Sum(constant, terms) => (constant, terms.to_vec()),
            _ => (Rational::ZERO, vec![(positive, Rational::ONE)]),
        };
        let (fixed, moving): (Vec<_>, Vec<_>) = terms.into_iter().partition(|(term, _)| *arena.node(*term) == Node::Pi);
        let [(term, k)] = moving.as_slice() else { return };
        let Some(inverse) = k.reciprocal() else { return };
        // The bound is term > −constant/k, or term < −constant/k if k is negative.
        let constant = arena.number(constant);
        let fixed: Vec<_> = fixed.into_iter().chain([(constant, Rational::ONE)]).collect();
        let sum = arena.linear_combination(&fixed);
        let limit = arena.scale(sum, &inverse.neg());
        match *arena.node(*term) {
            Node::Apply(Function::Abs, inner) if k.is_negative() => {
                let low = arena.neg(limit);
                self.add_bounds(inner, Some(low), Some(limit));
            }
            _ if k.is_negative() => self.add_bounds(*term, None, Some(limit)),
            _ => self.add_bounds(*term, Some(limit), None),
        }
    }

    /// Adds bounds of a term. A lower or upper bound that is already known is kept instead of the
    /// new one.
    fn add_bounds(&mut self, of: Expr, low: Option<Expr>, high: Option<Expr>) {
        match self.bounds.iter_mut().find(|b| b.of == of) {
            Some(known) => {
                known.low = known.low.or(low);
                known.high = known.high.or(high);
            }
            None => self.bounds.push(Bounds { of, low, high }),
        }
    }

    /// Rewrites a term by known signs: roots of squares, absolute values and sign functions are
    /// resolved if the sign of their argument is known.
    pub fn resolve_roots_and_signs(&self, arena: &mut Arena, e: Expr) -> Expr {
        let is_bent = |f: Function| matches!(f, Function::Sqrt | Function::Abs | Function::Sign);
        let bent: Vec<Expr> = arena.reachable(&[e]);
        let bent = bent.into_iter().filter(|part| matches!(arena.node(*part), Node::Apply(f, _) if is_bent(*f)));
        let bent: Vec<Expr> = bent.collect();
        // Inner terms come before outer terms, so the arguments are already resolved.
        let mut put = Substitution::default();
        for part in bent {
            let Node::Apply(f, argument) = *arena.node(part) else { continue };
            let argument = put.apply(arena, argument);
            let value = self.value(arena, f, argument);
            put.set(part, value);
        }
        put.apply(arena, e)
    }

    /// Value of f(argument) by known signs, where f is a square root, an absolute value or a sign
    /// function.
    fn value(&self, arena: &mut Arena, f: Function, argument: Expr) -> Expr {
        match (f, self.sign(arena, argument)) {
            (Function::Sqrt, _) => self.root(arena, argument),
            (Function::Abs, Sign::Positive | Sign::NotNegative) => argument,
            (Function::Abs, Sign::Negative | Sign::NotPositive) => arena.neg(argument),
            (Function::Sign, Sign::Positive) => Expr::ONE,
            (Function::Sign, Sign::Negative) => Expr::MINUS_ONE,
            _ => arena.apply(f, argument),
        }
    }

    /// Square root of an argument. Squares are taken out of the root if the signs of their bases
    /// are known.
    fn root(&self, arena: &mut Arena, argument: Expr) -> Expr {
        let (content, primitive) = arena.split_content(argument);
        let (content, primitive) = match arena.node(argument) {
            Node::Sum(constant, terms) if constant.is_zero() && terms.len() == 1 => (terms[0].1.clone(), terms[0].0),
            _ => (content, primitive),
        };
        let factors = match arena.node(primitive) {
            Node::Product(factors) => factors.to_vec(),
            _ => vec![(primitive, 1)],
        };
        let (mut outside, mut inside) = (Vec::new(), Vec::new());
        for (base, n) in factors {
            let half = n.div_euclid(2);
            match (half, self.absolute_value(arena, base)) {
                (0, _) | (_, None) => inside.push((base, n)),
                (_, Some(size)) => {
                    outside.push((size, half));
                    inside.push((base, n.rem_euclid(2)));
                }
            }
        }
        // A remaining factor may be the square of a sum, multiplied out.
        for (base, n) in &mut inside {
            if *n == 1
                && let Some(root) = square_root(arena, *base)
                && let Some(size) = self.absolute_value(arena, root)
            {
                outside.push((size, 1));
                *n = 0;
            }
        }
        let content = arena.number(content);
        inside.push((content, 1));
        let Ok(inside) = arena.try_product(&inside) else { return arena.apply(Function::Sqrt, argument) };
        outside.push((arena.apply(Function::Sqrt, inside), 1));
        arena.try_product(&outside).unwrap_or_else(|_| arena.apply(Function::Sqrt, argument))
    }

    /// Absolute value |e| as `e` or −`e`; `None` if the sign of `e` is unknown.
    fn absolute_value(&self, arena: &mut Arena, e: Expr) -> Option<Expr> {
        match self.sign(arena, e) {
            Sign::Positive | Sign::NotNegative => Some(e),
            Sign::Negative | Sign::NotPositive => Some(arena.neg(e)),
            Sign::Unknown => None,
        }
    }

    /// Sign of the values of the term `e`, as far as it follows from the known facts.
    pub fn sign(&self, arena: &mut Arena, e: Expr) -> Sign {
        let roots: Vec<Expr> = self.positive.iter().copied().chain([e]).collect();
        let mut known: FxHashMap<Expr, Sign> = FxHashMap::default();
        for part in arena.reachable(&roots) {
            let mut sign = self.sign_by_form(arena, part, &known);
            if sign == Sign::Unknown {
                sign = self.sign_by_known_terms(arena, part, &known);
            }
            known.insert(part, sign);
        }
        known[&e]
    }

    /// Sign of a term that follows from the signs of its operands; `known` has these signs.
    fn sign_by_form(&self, arena: &mut Arena, e: Expr, known: &FxHashMap<Expr, Sign>) -> Sign {
        match arena.node(e).clone() {
            Node::Number(value) => Sign::of_number(&value),
            Node::Pi => Sign::Positive,
            Node::Symbol(_) if arena.is_positive(e) => Sign::Positive,
            Node::Symbol(_) => self.sign_by_bounds(arena, e),
            Node::Sum(constant, terms) => sign_of_sum(&constant, &terms, known),
            Node::Product(factors) => factors.iter().fold(Sign::Positive, |sign, (base, n)| {
                let of_base = known[base];
                let power = match (n % 2 == 0, of_base.is_strict()) {
                    (true, true) => Sign::Positive,
                    (true, false) => Sign::NotNegative,
                    _ => of_base,
                };
                sign.times(power)
            }),
            Node::Named(_, term) => known[&term],
            Node::Apply(f, argument) => match f {
                Function::Exp | Function::Cosh => Sign::Positive,
                Function::Sqrt | Function::Abs if known[&argument].is_strict() => Sign::Positive,
                Function::Sqrt | Function::Abs => Sign::NotNegative,
                Function::Sinh | Function::Tanh | Function::Atan | Function::Asin | Function::Sign => known[&argument],
                Function::Sin | Function::Cos => self.sign_of_wave(arena, f, argument),
                Function::Log | Function::Acos => Sign::Unknown,
            },
        }
    }

    /// Sign of a term that follows from its constant bounds.
    fn sign_by_bounds(&self, arena: &Arena, e: Expr) -> Sign {
        let Some(bounds) = self.bounds_of(e) else { return Sign::Unknown };
        if bounds.low.is_some_and(|low| is_at_least(arena, low, Expr::ZERO)) {
            return Sign::Positive;
        }
        if bounds.high.is_some_and(|high| is_at_least(arena, Expr::ZERO, high)) {
            return Sign::Negative;
        }
        Sign::Unknown
    }

    /// Sign of a sine or cosine that follows from the bounds of its angle. A cosine has a known
    /// sign for angles between −π/2 and π/2. A sine has a known sign for angles between 0 and π, or
    /// between −π and 0.
    fn sign_of_wave(&self, arena: &mut Arena, f: Function, argument: Expr) -> Sign {
        let Some(Bounds { low: Some(low), high: Some(high), .. }) = self.bounds_of(argument).cloned() else {
            return Sign::Unknown;
        };
        let pi = arena.pi();
        let half = arena.scale(pi, &Rational::fraction(1, 2).expect("not zero"));
        let (below_half, below) = (arena.neg(half), arena.neg(pi));
        let within = |arena: &Arena, a: Expr, b: Expr| is_at_least(arena, low, a) && is_at_least(arena, b, high);
        match f {
            Function::Cos if within(arena, below_half, half) => Sign::Positive,
            Function::Sin if within(arena, Expr::ZERO, pi) => Sign::Positive,
            Function::Sin if within(arena, below, Expr::ZERO) => Sign::Negative,
            _ => Sign::Unknown,
        }
    }

    /// Sign of a term that is a multiple of a known positive term plus a rest of the same sign.
    /// `Unknown` for other terms.
    fn sign_by_known_terms(&self, arena: &mut Arena, e: Expr, known: &FxHashMap<Expr, Sign>) -> Sign {
        for positive in &self.positive {
            let Some(k) = ratio_to_positive_term(arena, e, *positive) else { continue };
            let rest = arena.linear_combination(&[(e, Rational::ONE), (*positive, k.neg())]);
            let sign = match arena.node(rest) {
                Node::Number(value) if value.is_zero() => Sign::Positive.scaled(&k),
                Node::Number(value) => Sign::of_number(value),
                Node::Sum(constant, terms) if terms.iter().all(|(term, _)| known.contains_key(term)) => {
                    sign_of_sum(constant, terms, known)
                }
                _ => known.get(&rest).copied().unwrap_or(Sign::Unknown),
            };
            if sign != Sign::Unknown && sign.is_not_negative() != k.is_negative() {
                return Sign::Positive.scaled(&k);
            }
        }
        Sign::Unknown
    }
}

/// Sign of the sum constant + Σ k · term, from the known signs of its terms. `Unknown` unless all
/// summands have the same sign.
fn sign_of_sum(constant: &Rational, terms: &[(Expr, Rational)], known: &FxHashMap<Expr, Sign>) -> Sign {
    let mut parts: Vec<Sign> = terms.iter().map(|(term, k)| known[term].scaled(k)).collect();
    if !constant.is_zero() {
        parts.push(Sign::of_number(constant));
    }
    let strict = parts.iter().any(|sign| sign.is_strict());
    let sign = if strict { Sign::Positive } else { Sign::NotNegative };
    if parts.iter().all(|part| part.is_not_negative()) {
        return sign;
    }
    let is_not_positive = |part: &Sign| part.negated().is_not_negative();
    if parts.iter().all(is_not_positive) { sign.negated() } else { Sign::Unknown }
}

/// Ratio of two coefficients of one term: its coefficient in the sum `e`, divided by its
/// coefficient in the sum `positive`. The first term that both sums contain is used. `None` if they
/// have no common term.
fn ratio_to_positive_term(arena: &Arena, e: Expr, positive: Expr) -> Option<Rational> {
    let terms = |e: Expr| match arena.node(e) {
        Node::Sum(_, terms) => terms.to_vec(),
        _ => vec![(e, Rational::ONE)],
    };
    let own = terms(e);
    terms(positive).into_iter().find_map(|(term, k)| {
        let (_, other) = own.iter().find(|(known, _)| *known == term)?;
        Some(other.mul(&k.reciprocal()?))
    })
}

/// True if the constant `a` is proved to be at least the constant `b`. False means that nothing is
/// proved.
fn is_at_least(arena: &Arena, a: Expr, b: Expr) -> bool {
    if a == b {
        return true;
    }
    let at = FxHashMap::default();
    let (Some(a), Some(b)) = (enclose_in_interval(arena, a, &at), enclose_in_interval(arena, b, &at)) else {
        return false;
    };
    PointInterval::is_above(a, b)
}

/// Polynomial p with p² = e, for a sum `e`; the sign of p is arbitrary. `None` if no such
/// polynomial is found.
fn square_root(arena: &mut Arena, e: Expr) -> Option<Expr> {
    if !matches!(arena.node(e), Node::Sum(..)) {
        return None;
    }
    let mut normalizer = Normalizer::new(ROOT);
    let form = normalizer.normal_form(arena, e)?;
    if !form.denominator.is_empty() {
        return None;
    }
    let root = normalizer.ring().square_root(&form.numerator)?;
    Some(normalizer.polynomial(&root).expand(arena))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::text::parse::parse_free;
    use crate::algebra::text::print::print_text;

    /// Resolves the roots and absolute values of a term and returns it as text. Known facts: r > 0,
    /// l + x > 0, h > 1/10, and bounds of the angles q and p.
    fn resolved(e: &str) -> String {
        let mut arena = Arena::new();
        let m = arena.symbol("m");
        arena.assume_positive(m);
        let known = ["r", "l + x", "h - 1/10", "pi/2 - abs(q)", "p", "pi - p", "3*(b - a)"];
        let known = known.map(|k| parse_free(&mut arena, k).unwrap());
        let signs = Signs::new(&mut arena, &known);
        let e = parse_free(&mut arena, e).unwrap();
        let e = signs.resolve_roots_and_signs(&mut arena, e);
        print_text(&arena, e)
    }

    #[test]
    fn what_has_a_known_sign_is_resolved() {
        for (e, value) in [
            ("sqrt(r^2)", "r"),
            ("abs(-r)", "r"),
            ("sqrt(m^2*r^2*(l + x)^2)", "m*r*(l + x)"),
            ("sqrt(l^2 + 2*l*x + x^2)", "l + x"),
            ("abs(h)", "h"),
            ("abs(cos(q))/cos(q)", "1"),
            ("sqrt(sin(p)^2)", "sin(p)"),
            ("sign(a - b)", "-1"),
            ("abs(l + x + m)", "l + x + m"),
            ("sqrt(4*r^2)", "2*r"),
            ("sqrt(r^3)", "r*sqrt(r)"),
            ("abs(sqrt(r^2) + m)", "r + m"),
        ] {
            // The order in which factors and terms are printed does not matter here.
            let mut arena = Arena::new();
            let (found, wanted) = (resolved(e), parse_free(&mut arena, value).unwrap());
            assert_eq!(parse_free(&mut arena, &found).unwrap(), wanted, "{e}: {found}");
        }
    }

    #[test]
    fn what_has_none_stays() {
        for e in
            ["sqrt(x^2)", "abs(l - x)", "sqrt((a + b)^2)", "abs(sin(q))", "abs(cos(p))", "abs(h - 1)", "sign(m - r)"]
        {
            let mut arena = Arena::new();
            let plain = parse_free(&mut arena, e).unwrap();
            let again = resolved(e);
            let again = parse_free(&mut arena, &again).unwrap();
            assert_eq!(again, plain, "{e}");
        }
    }
}
