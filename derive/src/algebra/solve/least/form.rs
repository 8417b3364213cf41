//! Quadratic form while it is carried back through the names: its entries, and the removal of a term.
//!
//! Invariant: an entry stands in the rows of both of its terms.

use super::{Block, Depth};
use crate::algebra::form::simplify::Simplifier;
use crate::algebra::term::calculus::{Gradient, Substitution};
use crate::algebra::term::steps::Definition;
use crate::algebra::{Arena, Expr, Function, Node, Rational};
use rustc_hash::{FxHashMap, FxHashSet};
use std::cmp::Reverse;
use std::collections::BTreeMap;

/// Largest number of terms of an entry that is simplified.
const MOST_SHORTENED: usize = 20;

/// Linear form Σ coefficient · end + rest; an end is an unknown or a name.
pub(super) struct Part {
    pub(super) terms: Vec<(Expr, Expr)>,
    pub(super) rest: Expr,
}

/// An unknown, and the name that is solved for in its place: name = sign · unknown + other terms.
pub(super) struct Replaced {
    pub(super) unknown: Expr,
    pub(super) by: Expr,
    /// Sign of the unknown in the name: 1 or −1.
    pub(super) sign: Expr,
}

/// Two terms z that are two ends x, y turned by an angle, plus known rests: z₁ = c x + s y + r₁ and z₂ = c y − s x +
/// r₂.
pub(super) struct Turn {
    x: Expr,
    y: Expr,
    sine: Expr,
    cosine: Expr,
    /// Known rests (r₁, r₂) of the two terms.
    rests: (Expr, Expr),
}

/// Rotation that relates two terms to two ends, by the sine and the cosine of one angle, so that c² + s² = 1; `None` if
/// they are not so related.
pub(super) fn turn(arena: &mut Arena, one: &Part, other: &Part) -> Option<Turn> {
    let ([(x, c), (y, s)], [(x2, minus_s), (y2, c2)]) = (one.terms.as_slice(), other.terms.as_slice()) else {
        return None;
    };
    let negative = arena.neg(*s);
    let is_circular = match (circular(arena, *c), circular(arena, *s)) {
        (Some((f, angle)), Some((g, same))) => f != g && angle == same,
        _ => false,
    };
    (x == x2 && y == y2 && c == c2 && *minus_s == negative && is_circular).then_some(Turn {
        x: *x,
        y: *y,
        sine: *s,
        cosine: *c,
        rests: (one.rest, other.rest),
    })
}

/// Function and angle of a term that is a sine, a cosine or the negative of one; `None` for other terms.
fn circular(arena: &Arena, e: Expr) -> Option<(Function, Expr)> {
    let inner = match arena.node(e) {
        Node::Sum(constant, terms) if constant.is_zero() && terms.len() == 1 && terms[0].1 == Rational::integer(-1) => {
            terms[0].0
        }
        _ => e,
    };
    match arena.node(inner) {
        Node::Apply(f @ (Function::Sin | Function::Cos), angle) => Some((*f, *angle)),
        _ => None,
    }
}

/// Quadratic form while it is carried back. An entry is a list of terms, which are added when the entry is read.
pub(super) struct Form<'a> {
    pub(super) arena: &'a mut Arena,
    pub(super) simplifier: &'a mut Simplifier,
    pub(super) gradient: Gradient,
    pub(super) at_zero: Substitution,
    pub(super) varying: FxHashSet<Expr>,
    pub(super) ends: Vec<Expr>,
    /// Entries of the symmetric matrix by their two ends: each entry stands in the rows of both.
    pub(super) rows: BTreeMap<Expr, BTreeMap<Expr, Vec<Expr>>>,
    pub(super) linear: FxHashMap<Expr, Vec<Expr>>,
}

impl Form<'_> {
    /// Reads a term as a linear form in the ends; `None` if it is not linear.
    pub(super) fn part(&mut self, e: Expr) -> Option<Part> {
        let slopes = self.gradient.apply(self.arena, e);
        let terms: Vec<(Expr, Expr)> = slopes.iter().map(|(at, slope)| (self.ends[*at], *slope)).collect();
        let is_known = |e: &Expr| self.arena.reachable(&[*e]).iter().all(|part| !self.varying.contains(part));
        if !terms.iter().all(|(_, slope)| is_known(slope)) {
            return None;
        }
        Some(Part { terms, rest: self.at_zero.apply(self.arena, e) })
    }

    /// Unknowns that occur in one name only, and nowhere by themselves in the quadratic part, each with that name.
    pub(super) fn replaced(&self, named: &[Expr], parts: &FxHashMap<Expr, Part>, unknowns: &[Expr]) -> Vec<Replaced> {
        let mut list: Vec<Replaced> = Vec::new();
        for unknown in unknowns.iter().filter(|unknown| !self.rows.contains_key(unknown)) {
            let factor =
                |name: &Expr| parts[name].terms.iter().find(|(of, _)| of == unknown).map(|(_, factor)| *factor);
            let mut found = named.iter().filter_map(|name| Some((*name, factor(name)?)));
            let (Some((by, sign)), None) = (found.next(), found.next()) else { continue };
            let is_free = !list.iter().any(|other| other.by == by);
            if is_free && [Expr::ONE, Expr::MINUS_ONE].contains(&sign) {
                list.push(Replaced { unknown: *unknown, by, sign });
            }
        }
        list
    }

    /// Puts a name in the place of an unknown, and returns the step by which the unknown follows from the name.
    pub(super) fn replace(&mut self, unknown: Expr, by: Expr, sign: Expr, part: &Part) -> Definition {
        let others = || part.terms.iter().filter(|(of, _)| *of != unknown);
        for term in self.linear.remove(&unknown).unwrap_or_default() {
            let share = self.arena.mul(sign, term);
            self.add_linear(by, share);
            for (of, factor) in others() {
                let share = self.arena.product(&[Expr::MINUS_ONE, sign, *factor, term]);
                self.add_linear(*of, share);
            }
        }
        let mut terms = vec![by];
        for (of, factor) in others().copied().chain([(part.rest, Expr::ONE)]) {
            terms.push(self.arena.product(&[Expr::MINUS_ONE, factor, of]));
        }
        let sum = self.arena.sum(&terms);
        Definition { symbol: unknown, value: self.arena.mul(sign, sum) }
    }

    fn add(&mut self, a: Expr, b: Expr, term: Expr) {
        if term == Expr::ZERO {
            return;
        }
        self.rows.entry(a).or_default().entry(b).or_default().push(term);
        if a != b {
            self.rows.entry(b).or_default().entry(a).or_default().push(term);
        }
    }

    pub(super) fn add_linear(&mut self, a: Expr, term: Expr) {
        if term != Expr::ZERO {
            self.linear.entry(a).or_default().push(term);
        }
    }

    pub(super) fn add_block(&mut self, block: &Block) -> Option<()> {
        let parts: Option<Vec<Part>> = block.components.iter().map(|e| self.part(*e)).collect();
        let parts = parts?;
        for (i, part) in parts.iter().enumerate() {
            for (other, k) in parts.iter().zip(block.tensor[i]) {
                for (a, by_a) in &part.terms {
                    let to_rest = self.arena.product(&[k, *by_a, other.rest]);
                    self.add_linear(*a, to_rest);
                    for (b, by_b) in other.terms.iter().filter(|(b, _)| a <= b) {
                        // Each pair of ends occurs in both orders, of which one is kept.
                        let entry = self.arena.product(&[k, *by_a, *by_b]);
                        self.add(*a, *b, entry);
                    }
                }
            }
            for (a, by_a) in &part.terms {
                let share = self.arena.mul(*by_a, block.linear[i]);
                self.add_linear(*a, share);
            }
        }
        Some(())
    }

    /// Position in `ready` of the end to take out next; `None` if `ready` is empty. Unknowns go first, then the names
    /// farthest from the unknowns; among equals, the end with the fewest entries.
    pub(super) fn next(&self, ready: &[Expr], depth: impl Fn(&Expr) -> Option<Depth>) -> Option<usize> {
        let key = |e: &Expr| (depth(e).map(Reverse), self.rows.get(e).map_or(0, BTreeMap::len), Reverse(*e));
        (0..ready.len()).min_by_key(|at| key(&ready[*at]))
    }

    /// Sum of terms in short form; a sum of several terms gets a name.
    fn read(&mut self, terms: &[Expr], wanted: &str) -> Expr {
        let sum = self.arena.sum(terms);
        // Only an order of elimination that will lose to another gathers so many terms.
        let sum = if terms.len() > MOST_SHORTENED { sum } else { self.simplifier.simplify(self.arena, sum) };
        if matches!(self.arena.node(sum), Node::Sum(..)) { self.arena.name(sum, wanted) } else { sum }
    }

    fn called(&self, e: Expr) -> String {
        let name = self.arena.name_of(e).or_else(|| self.arena.symbol_name(e)).unwrap_or_default();
        name.replace("''", "_ddot").replace('\'', "_dot")
    }

    /// Removes the row of end `z` from the form. Returns (diagonal entry, entries with other ends, linear entry).
    fn take(&mut self, z: Expr) -> (Expr, Vec<(Expr, Expr)>, Expr) {
        let row = self.rows.remove(&z).unwrap_or_default();
        let linear = self.linear.remove(&z).unwrap_or_default();
        let name = self.called(z);
        let linear = self.read(&linear, &format!("b_{name}"));
        let (mut own, mut others) = (Expr::ZERO, Vec::new());
        for (y, terms) in row {
            let entry = self.read(&terms, &format!("K_{name}"));
            if y == z {
                own = entry;
                continue;
            }
            if let Some(row) = self.rows.get_mut(&y) {
                row.remove(&z);
            }
            if entry != Expr::ZERO {
                others.push((y, entry));
            }
        }
        (own, others, linear)
    }

    /// Replaces a name `z` in the form by the linear form that it is made of.
    pub(super) fn substitute(&mut self, z: Expr, part: &Part) {
        let (own, others, linear) = self.take(z);
        for (y, entry) in &others {
            let share = self.arena.mul(*entry, part.rest);
            self.add_linear(*y, share);
        }
        let along = self.arena.mul(own, part.rest);
        let along = self.read(&[linear, along], "b");
        for (at, (x, c)) in part.terms.iter().enumerate() {
            let share = self.arena.mul(*c, along);
            self.add_linear(*x, share);
            for (y, entry) in &others {
                let share = self.arena.mul(*c, *entry);
                let twice = if x == y { self.arena.scale(share, &Rational::integer(2)) } else { share };
                self.add(*x, *y, twice);
            }
            for (x2, c2) in &part.terms[at..] {
                let entry = self.arena.product(&[*c, *c2, own]);
                self.add(*x, *x2, entry);
            }
        }
    }

    /// Moves the 2 × 2 block K of two terms z = R (x, y) + r to x and y: Rᵀ K R becomes the block of x and y, and K r
    /// is added to the linear entries of z, which [`Self::substitute`] carries on as Rᵀ K r.
    ///
    /// With t = s (K₂₂ − K₁₁) − 2 c K₁₂ the block of x and y is K₁₁ + s t, K₂₂ − s t and −(c t + K₁₂).
    pub(super) fn turn_block(&mut self, one: Expr, other: Expr, turn: &Turn) {
        let entry = |form: &mut Self, a: Expr, b: Expr| {
            let terms = form.rows.get(&a).and_then(|row| row.get(&b)).cloned().unwrap_or_default();
            let name = form.called(a);
            form.read(&terms, &format!("K_{name}"))
        };
        let (k11, k22, k12) = (entry(self, one, one), entry(self, other, other), entry(self, one, other));
        for (a, b) in [(one, one), (other, other), (one, other), (other, one)] {
            if let Some(row) = self.rows.get_mut(&a) {
                row.remove(&b);
            }
        }
        let Turn { x, y, sine, cosine, rests: (r1, r2) } = *turn;
        for (z, entry, rest) in [(one, k11, r1), (one, k12, r2), (other, k12, r1), (other, k22, r2)] {
            let share = self.arena.mul(entry, rest);
            self.add_linear(z, share);
        }
        let name = self.called(one);
        let difference = self.arena.sub(k22, k11);
        let difference = self.arena.name(difference, &format!("K_{name}"));
        let (a, b) = (self.arena.mul(sine, difference), self.arena.mul(cosine, k12));
        let twice = self.arena.scale(b, &Rational::integer(2));
        // z₁ = c x + s y, z₂ = c y − s x: K_xx = c² K₁₁ + s² K₂₂ − 2 s c K₁₂.
        let t = self.arena.sub(a, twice);
        let t = self.read(&[t], &format!("K_{name}"));
        let (st, ct) = (self.arena.mul(sine, t), self.arena.mul(cosine, t));
        let st = self.arena.name(st, &format!("K_{name}"));
        let minus = self.arena.neg(st);
        self.add(x, x, k11);
        self.add(x, x, st);
        self.add(y, y, k22);
        self.add(y, y, minus);
        let across = self.arena.add(ct, k12);
        let across = self.arena.neg(across);
        self.add(x, y, across);
        // Both keep a row, so that their entries with other ends are substituted later.
        self.rows.entry(one).or_default();
        self.rows.entry(other).or_default();
    }

    /// Eliminates an unknown: returns the value at which the form is least for given other ends. `None` if the pivot is
    /// 0.
    pub(super) fn eliminate(&mut self, unknown: Expr) -> Option<Definition> {
        let (own, others, linear) = self.take(unknown);
        let name = self.called(unknown);
        let own = self.arena.name(own, &format!("D_{name}"));
        let inverse = self.arena.div(Expr::ONE, own)?;
        let inverse = self.arena.name(inverse, &format!("over_D_{name}"));
        let mut terms = Vec::with_capacity(others.len() + 1);
        let gain = |form: &mut Self, e: Expr| {
            let quotient = form.arena.mul(e, inverse);
            form.arena.name(quotient, &format!("G_{name}"))
        };
        let start = gain(self, linear);
        terms.push(start);
        let gains: Vec<Expr> = others.iter().map(|(_, entry)| gain(self, *entry)).collect();
        for (at, (y, _)) in others.iter().enumerate() {
            terms.push(self.arena.mul(gains[at], *y));
            let share = self.arena.product(&[gains[at], linear, Expr::MINUS_ONE]);
            self.add_linear(*y, share);
            for (y2, entry) in &others[at..] {
                let share = self.arena.product(&[gains[at], *entry, Expr::MINUS_ONE]);
                self.add(*y, *y2, share);
            }
        }
        let sum = self.arena.sum(&terms);
        Some(Definition { symbol: unknown, value: self.arena.neg(sum) })
    }
}
