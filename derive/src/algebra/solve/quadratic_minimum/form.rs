//! Matrix entries of the quadratic form that is minimized, and elimination of a named term or an
//! unknown from it.
//!
//! Invariant: the entry that couples two terms is stored in the rows of both. An "end" of the form
//! is a variable of it: an unknown or a name.

use super::{Depth, QuadraticBlock};
use crate::algebra::form::simplify::Simplifier;
use crate::algebra::term::calculus::{Gradient, Substitution};
use crate::algebra::term::steps::Definition;
use crate::algebra::{Arena, Expr, Function, Node, Rational};
use rustc_hash::{FxHashMap, FxHashSet};
use std::cmp::Reverse;
use std::collections::BTreeMap;

/// Largest number of terms in a matrix entry that is still simplified.
const MOST_SHORTENED: usize = 20;

/// Linear form Σ coefficient · end + rest, where each end is an unknown or a name.
pub(super) struct LinearPart {
    /// Pairs (unknown or name, coefficient).
    pub(super) terms: Vec<(Expr, Expr)>,
    /// Constant part of the linear form, which depends on no unknown.
    pub(super) rest: Expr,
}

/// Replacement of an unknown by a name that contains it: name = sign · unknown + other terms.
pub(super) struct ReplacedUnknown {
    /// Unknown that the name replaces.
    pub(super) unknown: Expr,
    /// Name that replaces the unknown.
    pub(super) by: Expr,
    /// Sign of the unknown in the name: the number 1 or −1.
    pub(super) sign: Expr,
}

/// Rotation that relates two terms z₁ and z₂ to two unknowns or names x and y: z₁ = c x + s y + r₁
/// and z₂ = c y − s x + r₂.
pub(super) struct Rotation {
    /// Unknown or name x that the rotation relates.
    x: Expr,
    /// Unknown or name y that the rotation relates.
    y: Expr,
    /// Sine s of the angle of rotation, with either sign.
    sine: Expr,
    /// Cosine c of the angle of rotation, with either sign.
    cosine: Expr,
    /// Rests (r₁, r₂) of the two terms, which depend on no unknown.
    rests: (Expr, Expr),
}

/// Finds the rotation that relates two linear forms to two common unknowns or names. Their
/// coefficients must be the sine and cosine of one angle, so that c² + s² = 1. `None` if the forms
/// are not related by a rotation.
pub(super) fn find_rotation(arena: &mut Arena, one: &LinearPart, other: &LinearPart) -> Option<Rotation> {
    let ([(x, c), (y, s)], [(x2, minus_s), (y2, c2)]) = (one.terms.as_slice(), other.terms.as_slice()) else {
        return None;
    };
    let negative = arena.neg(*s);
    let is_circular = match (circular(arena, *c), circular(arena, *s)) {
        (Some((f, angle)), Some((g, same))) => f != g && angle == same,
        _ => false,
    };
    (x == x2 && y == y2 && c == c2 && *minus_s == negative && is_circular).then_some(Rotation {
        x: *x,
        y: *y,
        sine: *s,
        cosine: *c,
        rests: (one.rest, other.rest),
    })
}

/// Function and angle of a term that is a sine, a cosine or the negative of either; `None` for
/// other terms.
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

/// Quadratic form during elimination. A matrix entry is a list of terms, which are added up when
/// the entry is read.
pub(super) struct Form<'a> {
    /// Arena of the terms.
    pub(super) arena: &'a mut Arena,
    /// Simplifier of the entries.
    pub(super) simplifier: &'a mut Simplifier,
    /// Derivatives of terms with respect to all unknowns and names.
    pub(super) gradient: Gradient,
    /// Substitution of 0 for all unknowns and names.
    pub(super) at_zero: Substitution,
    /// Set of the unknowns and of all names that depend on them.
    pub(super) varying: FxHashSet<Expr>,
    /// Variables of the form: names that depend on unknowns, then the unknowns.
    pub(super) ends: Vec<Expr>,
    /// Entries of the symmetric matrix, by the two unknowns or names that they couple. Each entry
    /// is in the rows of both.
    pub(super) rows: BTreeMap<Expr, BTreeMap<Expr, Vec<Expr>>>,
    /// Terms of the linear coefficient of each unknown or name.
    pub(super) linear: FxHashMap<Expr, Vec<Expr>>,
}

impl Form<'_> {
    /// Splits a term into a linear form in unknowns and names; `None` if the term is not linear in
    /// them.
    pub(super) fn part(&mut self, e: Expr) -> Option<LinearPart> {
        let slopes = self.gradient.apply(self.arena, e);
        let terms: Vec<(Expr, Expr)> = slopes.iter().map(|(at, slope)| (self.ends[*at], *slope)).collect();
        let is_known = |e: &Expr| self.arena.reachable(&[*e]).iter().all(|part| !self.varying.contains(part));
        if !terms.iter().all(|(_, slope)| is_known(slope)) {
            return None;
        }
        Some(LinearPart { terms, rest: self.at_zero.apply(self.arena, e) })
    }

    /// Finds the unknowns that can be replaced by a name. Each occurs in exactly one name, with the
    /// coefficient 1 or −1, and not directly in the quadratic part. A name replaces one unknown at
    /// most.
    pub(super) fn replaceable_unknowns(
        &self,
        named: &[Expr],
        parts: &FxHashMap<Expr, LinearPart>,
        unknowns: &[Expr],
    ) -> Vec<ReplacedUnknown> {
        let mut list: Vec<ReplacedUnknown> = Vec::new();
        for unknown in unknowns.iter().filter(|unknown| !self.rows.contains_key(unknown)) {
            let factor =
                |name: &Expr| parts[name].terms.iter().find(|(of, _)| of == unknown).map(|(_, factor)| *factor);
            let mut found = named.iter().filter_map(|name| Some((*name, factor(name)?)));
            let (Some((by, sign)), None) = (found.next(), found.next()) else { continue };
            let is_free = !list.iter().any(|other| other.by == by);
            if is_free && [Expr::ONE, Expr::MINUS_ONE].contains(&sign) {
                list.push(ReplacedUnknown { unknown: *unknown, by, sign });
            }
        }
        list
    }

    /// Replaces an unknown by the name `by`, whose linear form is `part`. Returns the step that
    /// defines the unknown by the name.
    pub(super) fn replace_unknown(&mut self, unknown: Expr, by: Expr, sign: Expr, part: &LinearPart) -> Definition {
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

    /// Adds a term to the matrix entry of two unknowns or names a and b, in the rows of both.
    fn add(&mut self, a: Expr, b: Expr, term: Expr) {
        if term == Expr::ZERO {
            return;
        }
        self.rows.entry(a).or_default().entry(b).or_default().push(term);
        if a != b {
            self.rows.entry(b).or_default().entry(a).or_default().push(term);
        }
    }

    /// Adds a term to the linear coefficient of the unknown or name a.
    pub(super) fn add_linear(&mut self, a: Expr, term: Expr) {
        if term != Expr::ZERO {
            self.linear.entry(a).or_default().push(term);
        }
    }

    /// Adds a block to the form; `None` if a component is not linear in unknowns and names.
    pub(super) fn add_block(&mut self, block: &QuadraticBlock) -> Option<()> {
        let parts: Option<Vec<LinearPart>> = block.components.iter().map(|e| self.part(*e)).collect();
        let parts = parts?;
        for (i, part) in parts.iter().enumerate() {
            for (other, k) in parts.iter().zip(block.tensor[i]) {
                for (a, by_a) in &part.terms {
                    let to_rest = self.arena.product(&[k, *by_a, other.rest]);
                    self.add_linear(*a, to_rest);
                    for (b, by_b) in other.terms.iter().filter(|(b, _)| a <= b) {
                        // Each pair of unknowns or names occurs in both orders; one order is
                        // enough.
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

    /// Index in `ready` of the unknown or name that is eliminated next; `None` if `ready` is empty.
    /// Unknowns go first, then the names with the greatest depth. Among equals, the term with the
    /// fewest matrix entries goes first.
    pub(super) fn next_to_eliminate(&self, ready: &[Expr], depth: impl Fn(&Expr) -> Option<Depth>) -> Option<usize> {
        let key = |e: &Expr| (depth(e).map(Reverse), self.rows.get(e).map_or(0, BTreeMap::len), Reverse(*e));
        (0..ready.len()).min_by_key(|at| key(&ready[*at]))
    }

    /// Sum of the terms of a matrix entry, in short form. A result that is still a sum gets a name
    /// with the label `wanted`.
    fn read(&mut self, terms: &[Expr], wanted: &str) -> Expr {
        let sum = self.arena.sum(terms);
        // So many terms arise only in an order of elimination that will be rejected, so they are
        // not simplified.
        let sum = if terms.len() > MOST_SHORTENED { sum } else { self.simplifier.simplify(self.arena, sum) };
        if matches!(self.arena.node(sum), Node::Sum(..)) { self.arena.name(sum, wanted) } else { sum }
    }

    /// Name of an unknown or a named term for use in labels: primes are replaced by `_dot` and
    /// `_ddot`.
    fn name_of(&self, e: Expr) -> String {
        let name = self.arena.name_of(e).or_else(|| self.arena.symbol_name(e)).unwrap_or_default();
        name.replace("''", "_ddot").replace('\'', "_dot")
    }

    /// Removes the row of the unknown or name `z` from the form. Returns its diagonal entry, its
    /// entries with other terms, and its linear coefficient.
    fn remove_row(&mut self, z: Expr) -> (Expr, Vec<(Expr, Expr)>, Expr) {
        let row = self.rows.remove(&z).unwrap_or_default();
        let linear = self.linear.remove(&z).unwrap_or_default();
        let name = self.name_of(z);
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

    /// Replaces the name `z` in the form by the linear form `part` that defines it.
    pub(super) fn substitute(&mut self, z: Expr, part: &LinearPart) {
        let (own, others, linear) = self.remove_row(z);
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

    /// Moves the 2 × 2 block K of two terms z = R (x, y) + r to x and y, where R is a rotation. Rᵀ
    /// K R becomes the block of x and y. K r is added to the linear coefficients of z, which
    /// [`Self::substitute`] later turns into Rᵀ K r.
    ///
    /// The new block has the entries K₁₁ + s t, K₂₂ − s t and −(c t + K₁₂). Here t = s (K₂₂ − K₁₁)
    /// − 2 c K₁₂.
    pub(super) fn rotate_block(&mut self, one: Expr, other: Expr, turn: &Rotation) {
        let entry = |form: &mut Self, a: Expr, b: Expr| {
            let terms = form.rows.get(&a).and_then(|row| row.get(&b)).cloned().unwrap_or_default();
            let name = form.name_of(a);
            form.read(&terms, &format!("K_{name}"))
        };
        let (k11, k22, k12) = (entry(self, one, one), entry(self, other, other), entry(self, one, other));
        for (a, b) in [(one, one), (other, other), (one, other), (other, one)] {
            if let Some(row) = self.rows.get_mut(&a) {
                row.remove(&b);
            }
        }
        let Rotation { x, y, sine, cosine, rests: (r1, r2) } = *turn;
        for (z, entry, rest) in [(one, k11, r1), (one, k12, r2), (other, k12, r1), (other, k22, r2)] {
            let share = self.arena.mul(entry, rest);
            self.add_linear(z, share);
        }
        let name = self.name_of(one);
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
        // Both terms keep a row, so that their other entries are substituted later.
        self.rows.entry(one).or_default();
        self.rows.entry(other).or_default();
    }

    /// Eliminates an unknown from the form. Returns the step that defines the unknown: its value
    /// minimizes the form for given values of the other unknowns and names. `None` if the pivot is 0.
    pub(super) fn eliminate(&mut self, unknown: Expr) -> Option<Definition> {
        let (own, others, linear) = self.remove_row(unknown);
        let name = self.name_of(unknown);
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
