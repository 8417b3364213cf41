//! Identities, used on the terms of an arena.

use super::terms::{ANGLES, divides};
use proptest::prelude::*;
use tripos_derive::algebra::term::calculus::Substitution;
use tripos_derive::algebra::{Arena, Expr, Function, Node, Rational};

/// One identity at one place: which rule, which of the places where it fits, and what it is written with.
#[derive(Clone, Debug)]
pub struct Step {
    rule: usize,
    place: usize,
    with: &'static str,
}

/// A few identities one after another.
pub fn steps() -> impl Strategy<Value = Vec<Step>> {
    let step = (0..RULES.len(), 0_usize..100, prop::sample::select(&ANGLES[..]));
    prop::collection::vec(step.prop_map(|(rule, place, with)| Step { rule, place, with }), 1..5)
}

/// A node by another term of the same meaning, if the identity fits it; y is an angle to write it with.
type Rule = fn(arena: &mut Arena, node: Expr, y: Expr) -> Option<Expr>;

const RULES: [Rule; 9] = [
    // sin² = 1 − cos², and cos² = 1 − sin².
    |arena, node, _| {
        let (base, n) = wave_power(arena, node)?;
        let other = other_wave(arena, base)?;
        let square = arena.square(other);
        let traded = arena.sub(Expr::ONE, square);
        arena.try_product(&[(traded, 1), (base, n - 2)]).ok()
    },
    // sin x = 2 sin x/2 cos x/2, cos x = 1 − 2 sin² x/2.
    |arena, node, _| {
        let (f, x) = wave(arena, node)?;
        let half = arena.scale(x, &Rational::fraction(1, 2)?);
        let (sine, cosine) = (arena.sin(half), arena.cos(half));
        let two = arena.integer(2);
        Some(match f {
            Function::Sin => arena.product(&[two, sine, cosine]),
            _ => {
                let twice = arena.product(&[two, sine, sine]);
                arena.sub(Expr::ONE, twice)
            }
        })
    },
    // sin x = 3 sin x/3 − 4 sin³ x/3, cos x = 4 cos³ x/3 − 3 cos x/3.
    |arena, node, _| {
        let (f, x) = wave(arena, node)?;
        let third = arena.scale(x, &Rational::fraction(1, 3)?);
        let base = arena.apply(f, third);
        let cube = arena.pow(base, 3).ok()?;
        let sign = if f == Function::Sin { 1 } else { -1 };
        Some(arena.linear_combination(&[(base, Rational::integer(3 * sign)), (cube, Rational::integer(-4 * sign))]))
    },
    // f(x) = f((x − y) + y), written out.
    |arena, node, y| {
        let (f, x) = wave(arena, node)?;
        let rest = arena.sub(x, y);
        let (sa, ca, sb, cb) = (arena.sin(rest), arena.cos(rest), arena.sin(y), arena.cos(y));
        let (first, second) = if f == Function::Sin { ((sa, cb), (ca, sb)) } else { ((ca, cb), (sa, sb)) };
        let (first, second) = (arena.mul(first.0, first.1), arena.mul(second.0, second.1));
        Some(if f == Function::Sin { arena.add(first, second) } else { arena.sub(first, second) })
    },
    // e = e (1 + tan² y) cos² y.
    |arena, node, y| {
        let (sine, cosine) = (arena.sin(y), arena.cos(y));
        let tangent = arena.div(sine, cosine)?;
        let square = arena.square(tangent);
        let secant = arena.add(Expr::ONE, square);
        arena.try_product(&[(node, 1), (secant, 1), (cosine, 2)]).ok()
    },
    // e = (e d)/d with d = 2 + x cos y, the product written out term by term.
    |arena, node, y| {
        let (x, cosine, two) = (arena.symbol("x"), arena.cos(y), arena.integer(2));
        let part = arena.mul(x, cosine);
        let d = arena.add(two, part);
        let (first, second) = (arena.mul(node, two), arena.mul(node, part));
        let above = arena.add(first, second);
        arena.div(above, d)
    },
    // a (b + c) = a b + a c.
    |arena, node, _| {
        let Node::Product(factors) = arena.node(node).clone() else { return None };
        let at = factors.iter().position(|(base, n)| *n > 0 && matches!(arena.node(*base), Node::Sum(..)))?;
        let Node::Sum(constant, terms) = arena.node(factors[at].0).clone() else { return None };
        let mut rest = factors.to_vec();
        rest[at].1 -= 1;
        let rest = arena.try_product(&rest).ok()?;
        let mut parts = vec![(rest, constant)];
        for (term, k) in &terms {
            parts.push((arena.mul(rest, *term), k.clone()));
        }
        Some(arena.linear_combination(&parts))
    },
    // 1/a = (a + 1)/(a² + a).
    |arena, node, _| {
        let Node::Product(factors) = arena.node(node).clone() else { return None };
        let (a, _) = *factors.iter().find(|(_, n)| *n < 0)?;
        let above = arena.add(a, Expr::ONE);
        let square = arena.square(a);
        let below = arena.add(square, a);
        if !divides(arena, below) {
            return None;
        }
        arena.try_product(&[(node, 1), (a, 1), (above, 1), (below, -1)]).ok()
    },
    // e = e + (y + e)² − y² − 2 y e − e².
    |arena, node, y| {
        let sum = arena.add(y, node);
        let (square, y2, e2, mixed) = (arena.square(sum), arena.square(y), arena.square(node), arena.mul(y, node));
        let minus = Rational::MINUS_ONE;
        Some(arena.linear_combination(&[
            (node, Rational::ONE),
            (square, Rational::ONE),
            (y2, minus.clone()),
            (e2, minus),
            (mixed, Rational::integer(-2)),
        ]))
    },
];

fn wave(arena: &Arena, node: Expr) -> Option<(Function, Expr)> {
    match arena.node(node) {
        Node::Apply(f @ (Function::Sin | Function::Cos), x) => Some((*f, *x)),
        _ => None,
    }
}

/// sin^n or cos^n, n at least 2.
fn wave_power(arena: &Arena, node: Expr) -> Option<(Expr, i32)> {
    let Node::Product(factors) = arena.node(node) else { return None };
    match **factors {
        [(base, n)] if n >= 2 && wave(arena, base).is_some() => Some((base, n)),
        _ => None,
    }
}

fn other_wave(arena: &mut Arena, base: Expr) -> Option<Expr> {
    let (f, x) = wave(arena, base)?;
    Some(if f == Function::Sin { arena.cos(x) } else { arena.sin(x) })
}

/// A term after identities, each at one node, everywhere it occurs; steps that fit nowhere are passed over.
pub fn rewritten(arena: &mut Arena, e: Expr, steps: &[Step]) -> Expr {
    let mut e = e;
    for step in steps {
        let y = arena.symbol(step.with);
        let mut fits = Vec::new();
        for node in values(arena, e) {
            if let Some(new) = RULES[step.rule](arena, node, y) {
                fits.push((node, new));
            }
        }
        if !fits.is_empty() {
            let mut substitution = Substitution::new(&[fits[step.place % fits.len()]]);
            e = substitution.apply(arena, e);
        }
    }
    e
}

/// The nodes that are values, and no parts of angles.
fn values(arena: &Arena, e: Expr) -> Vec<Expr> {
    let (mut list, mut stack) = (Vec::new(), vec![e]);
    while let Some(node) = stack.pop() {
        if list.contains(&node) {
            continue;
        }
        list.push(node);
        if !matches!(arena.node(node), Node::Apply(..)) {
            stack.extend(arena.operands(node));
        }
    }
    list
}
