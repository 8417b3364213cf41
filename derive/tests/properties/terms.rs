//! Random formulas.

use proptest::prelude::*;
use tripos_derive::algebra::value::zero_test::{ZeroTest, zero_test};
use tripos_derive::algebra::{Arena, Expr, Function, Rational};

/// Σ k · angle, k = n/d.
pub type Angle = Vec<(&'static str, i64, i64)>;

/// A formula before it is built.
#[derive(Clone, Debug)]
pub enum Term {
    Number(i64, i64),
    Symbol(&'static str),
    Sine(Angle),
    Cosine(Angle),
    Tangent(Angle),
    Sum(Vec<Term>),
    Product(Vec<Term>),
    Quotient(Box<Term>, Box<Term>),
    Power(Box<Term>, i32),
    /// A function without rules for sums, or a root.
    Apply(Function, Box<Term>),
}

/// Symbols of the formulas.
pub const SYMBOLS: [&str; 4] = ["x", "y", "m", "q"];
/// Symbols that angles are made of; `q` stands outside of angles too.
pub const ANGLES: [&str; 3] = ["q", "p", "r"];

/// An angle of one or two symbols with whole or fractional multiples.
pub fn angle() -> impl Strategy<Value = Angle> + Clone {
    let part = (prop::sample::select(&ANGLES[..]), prop::sample::select(&[-3_i64, -2, -1, 1, 2][..]), 1_i64..4);
    prop::collection::vec(part, 1..3)
}

/// x, 2 x or x/2: what stays short when formulas are multiplied.
fn plain_angle() -> impl Strategy<Value = Angle> + Clone {
    let part = (prop::sample::select(&ANGLES[..]), prop::sample::select(&[(1_i64, 1_i64), (2, 1), (1, 2)][..]));
    part.prop_map(|(name, (n, d))| vec![(name, n, d)])
}

fn leaf(angle: impl Strategy<Value = Angle> + Clone) -> impl Strategy<Value = Term> {
    prop_oneof![
        2 => (-4_i64..5, 1_i64..4).prop_map(|(n, d)| Term::Number(n, d)),
        4 => prop::sample::select(&SYMBOLS[..]).prop_map(Term::Symbol),
        2 => angle.clone().prop_map(Term::Sine),
        2 => angle.clone().prop_map(Term::Cosine),
        1 => angle.prop_map(Term::Tangent),
    ]
}

/// Rational functions of symbols, sines, cosines and tangents.
pub fn term() -> impl Strategy<Value = Term> {
    composed(leaf(angle()).prop_recursive(3, 16, 3, |inner| composed(inner).boxed()))
}

/// Random terms like those of [`term`], short enough for a normal form.
pub fn short_term() -> impl Strategy<Value = Term> {
    leaf(angle()).prop_recursive(3, 12, 3, |inner| composed(inner).boxed())
}

/// Random terms that are short enough to be multiplied by others before the product gets a normal form.
pub fn factor() -> impl Strategy<Value = Term> {
    leaf(plain_angle()).prop_recursive(2, 6, 2, |inner| composed(inner).boxed())
}

/// Random terms like those of [`term`], with roots, absolute values and functions that have no rules.
pub fn term_with_functions() -> impl Strategy<Value = Term> {
    let functions = prop::sample::select(&Function::ALL[..]).prop_map(|(f, _)| f);
    let with_functions = leaf(angle()).prop_recursive(3, 16, 3, move |inner| {
        let applied = (functions.clone(), inner.clone()).prop_map(|(f, x)| Term::Apply(f, Box::new(x)));
        prop_oneof![4 => composed(inner), 1 => applied].boxed()
    });
    composed(with_functions)
}

fn composed(inner: impl Strategy<Value = Term> + Clone) -> impl Strategy<Value = Term> {
    prop_oneof![
        3 => prop::collection::vec(inner.clone(), 2..4).prop_map(Term::Sum),
        3 => prop::collection::vec(inner.clone(), 2..4).prop_map(Term::Product),
        1 => (inner.clone(), inner.clone()).prop_map(|(a, b)| Term::Quotient(Box::new(a), Box::new(b))),
        1 => (inner, prop::sample::select(&[-2, -1, 2, 3][..])).prop_map(|(a, n)| Term::Power(Box::new(a), n)),
    ]
}

/// An arena with the symbols declared; m is positive.
pub fn arena() -> Arena {
    let mut arena = Arena::new();
    for name in ["m", "x", "y", "q", "p", "r"] {
        arena.symbol(name);
    }
    let m = arena.symbol("m");
    arena.assume_positive(m);
    arena
}

impl Term {
    /// The term in an arena. What would divide by zero is not divided.
    pub fn build(&self, arena: &mut Arena) -> Expr {
        match self {
            Self::Number(n, d) => arena.ratio(*n, *d),
            Self::Symbol(name) => arena.symbol(name),
            Self::Sine(angle) => {
                let angle = sum_of(arena, angle);
                arena.sin(angle)
            }
            Self::Cosine(angle) => {
                let angle = sum_of(arena, angle);
                arena.cos(angle)
            }
            Self::Tangent(angle) => {
                let angle = sum_of(arena, angle);
                let (sine, cosine) = (arena.sin(angle), arena.cos(angle));
                arena.div(sine, cosine).expect("a cosine is not the literal 0")
            }
            Self::Sum(terms) => {
                let terms: Vec<Expr> = terms.iter().map(|t| t.build(arena)).collect();
                arena.sum(&terms)
            }
            Self::Product(factors) => {
                let factors: Vec<Expr> = factors.iter().map(|f| f.build(arena)).collect();
                arena.product(&factors)
            }
            Self::Quotient(above, below) => {
                let (above, below) = (above.build(arena), below.build(arena));
                divided(arena, above, below)
            }
            Self::Power(base, n) => {
                let base = base.build(arena);
                if *n < 0 && !divides(arena, base) { base } else { arena.pow(base, *n).expect("a small power") }
            }
            Self::Apply(f, argument) => {
                let argument = argument.build(arena);
                // Of a number it may have no value, which the parser refuses.
                if arena.as_number(argument).is_some() { argument } else { arena.apply(*f, argument) }
            }
        }
    }
}

/// The angle as a term.
pub fn sum_of(arena: &mut Arena, angle: &Angle) -> Expr {
    let parts: Vec<(Expr, Rational)> = angle
        .iter()
        .map(|(name, n, d)| (arena.symbol(name), Rational::fraction(*n, *d).expect("d is at least 1")))
        .collect();
    arena.linear_combination(&parts)
}

/// True if a term may be a divisor: it is not zero by meaning.
pub fn divides(arena: &Arena, e: Expr) -> bool {
    zero_test(arena, e) == ZeroTest::NonZero
}

/// a/b, or a where b is zero by meaning or not known not to be.
pub fn divided(arena: &mut Arena, a: Expr, b: Expr) -> Expr {
    if divides(arena, b) { arena.div(a, b).expect("it is not zero") } else { a }
}
