//! The unknowns at which a quadratic form in named terms is least, in time proportional to the number of names and not
//! to its square.
//!
//! The terms are linear in the unknowns by way of other named terms. The accelerations of bodies, for example, are
//! linear in those of joints, each body's by way of the body before it. The form is carried back through the names, the
//! last first: each named term is replaced by the terms that it is made of. An unknown that no remaining name depends
//! on is eliminated at once, while few terms stand beside it. On a chain this is the recursion of articulated bodies
//! (A. F. Vereshchagin, 1974; R. Featherstone, Int. J. Robotics Research 2 (1983) 13–30), found as an elimination in
//! the order of the names. The form that is least is then that of Gauss's principle.
//!
//! An unknown may occur in one name only, as the rate of a relative angle does in the angular acceleration of its body.
//! Then the name may take the place of the unknown. This avoids terms that cancel later, and the unknown follows from
//! the name at the end.
//!
//! Invariant: a pivot is the value of the form along one unknown, with all others chosen best. It is positive where the
//! form is positive definite.

mod form;

use crate::algebra::form::simplify::{Simplifier, cost};
use crate::algebra::term::calculus::{Gradient, Substitution};
use crate::algebra::term::steps::Definition;
use crate::algebra::{Arena, Expr};
use form::{Form, Part, Replaced, turn};
use rustc_hash::{FxHashMap, FxHashSet};
use std::collections::{BTreeMap, BTreeSet};

/// Part of a quadratic form: ½ Σ K_ij e_i e_j + Σ b_i e_i, with K symmetric.
#[derive(Clone, Debug)]
pub struct Block {
    /// Components e of the block, linear in the unknowns by way of names.
    pub components: [Expr; 3],
    /// Symmetric matrix K of the block.
    pub tensor: [[Expr; 3]; 3],
    /// Coefficients b of the block's linear part.
    pub linear: [Expr; 3],
}

/// Quadratic form: the sum of blocks and of a linear form in the unknowns.
#[derive(Clone, Debug)]
pub struct Sum {
    /// Blocks of the quadratic form.
    pub blocks: Vec<Block>,
    /// Factor of each unknown in the linear form.
    pub linear: Vec<Expr>,
}

/// Order in which terms are taken out of the quadratic form.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Order {
    /// First the term that depends on most unknowns, and among equals the one with most names between it and the
    /// unknowns. On an arm these are all terms of its last body, then all of the body before it.
    Farthest,
    /// First the term with fewest terms beside it: good on a chain whose angles are all measured from one frame.
    Fewest,
}

/// Kind of terms that the quadratic form is solved for.
#[derive(Clone, Copy, PartialEq, Eq)]
enum SolvedFor {
    /// The unknowns themselves.
    Unknowns,
    /// Names that take the place of single unknowns, where an unknown occurs in one name only.
    Names,
}

/// Attempt to solve the quadratic form: its order of elimination, and its limit.
#[derive(Clone, Copy)]
struct Attempt {
    order: Order,
    solved_for: SolvedFor,
    /// Number of new terms beyond which the attempt is given up.
    most: usize,
}

/// Number of unknowns that a name depends on, and number of names between the name and the unknowns.
type Depth = (usize, usize);

/// Unknowns that make a quadratic form least, in terms of names and of earlier unknowns, in the order of computation.
/// The cheapest of several orders of elimination is chosen. Some steps may define names, from which unknowns follow.
/// `None` if a component is not linear in the unknowns, or if they are not determined.
pub fn least(arena: &mut Arena, simplifier: &mut Simplifier, sum: &Sum, unknowns: &[Expr]) -> Option<Vec<Definition>> {
    let mut both = Vec::new();
    let mut most = usize::MAX;
    for solved_for in [SolvedFor::Names, SolvedFor::Unknowns] {
        for order in [Order::Farthest, Order::Fewest] {
            let before = arena.len();
            if let Some(solved) = least_in(arena, simplifier, sum, unknowns, Attempt { order, solved_for, most }) {
                both.push((cost_with_names(arena, &solved), solved));
                // An order that makes more terms than another is not followed to its end.
                most = most.min(arena.len() - before);
            }
        }
    }
    both.into_iter().min_by_key(|(cost, _)| *cost).map(|(_, solved)| solved)
}

/// Number of operations of steps and of all named terms that they use, except the names that the steps define.
fn cost_with_names(arena: &Arena, steps: &[Definition]) -> usize {
    let stated: FxHashSet<Expr> = steps.iter().map(|step| step.symbol).collect();
    let values: Vec<Expr> = steps.iter().map(|step| step.value).collect();
    let parts = arena.reachable_until(&values, |part| stated.contains(&part));
    let names = parts.into_iter().filter(|part| !stated.contains(part)).filter_map(|e| arena.behind(e));
    names.chain(values.iter().copied()).map(|e| cost(arena, e)).sum()
}

fn least_in(
    arena: &mut Arena,
    simplifier: &mut Simplifier,
    Sum { blocks, linear }: &Sum,
    unknowns: &[Expr],
    attempt: Attempt,
) -> Option<Vec<Definition>> {
    let Attempt { order, solved_for, most } = attempt;
    let before = arena.len();
    let components: Vec<Expr> = blocks.iter().flat_map(|block| block.components).collect();
    let named = depending(arena, &components, unknowns);
    let ends: Vec<Expr> = named.iter().chain(unknowns).copied().collect();
    let zeros: Vec<(Expr, Expr)> = ends.iter().map(|e| (*e, Expr::ZERO)).collect();
    let mut form = Form {
        arena,
        simplifier,
        gradient: Gradient::new(&ends),
        at_zero: Substitution::new(&zeros),
        varying: ends.iter().copied().collect(),
        ends,
        rows: BTreeMap::new(),
        linear: FxHashMap::default(),
    };
    for (unknown, k) in unknowns.iter().zip(linear) {
        form.add_linear(*unknown, *k);
    }
    for block in blocks {
        form.add_block(block)?;
    }
    let mut parts: FxHashMap<Expr, Part> = FxHashMap::default();
    for e in &named {
        let part = form.part(form.arena.behind(*e)?)?;
        parts.insert(*e, part);
    }
    let replaced = match solved_for {
        SolvedFor::Names => form.replaced(&named, &parts, unknowns),
        SolvedFor::Unknowns => Vec::new(),
    };
    if solved_for == SolvedFor::Names && replaced.is_empty() {
        return None;
    }
    let depth = depths(order, &named, &parts, unknowns);
    let mut following = Vec::with_capacity(replaced.len());
    for Replaced { unknown, by, sign } in replaced {
        let part = parts.remove(&by)?;
        following.push(form.replace(unknown, by, sign, &part));
    }
    // Number of remaining names that contain each end. An end that none contains can be taken out.
    let mut left: FxHashMap<Expr, usize> = FxHashMap::default();
    for (of, _) in parts.values().flat_map(|part| &part.terms) {
        *left.entry(*of).or_default() += 1;
    }
    let mut solved = Vec::new();
    let is_gone: FxHashSet<Expr> = following.iter().map(|step| step.symbol).collect();
    let is_left = |e: &Expr| !left.contains_key(e) && !is_gone.contains(e);
    let mut ready: Vec<Expr> = form.ends.iter().copied().filter(is_left).collect();
    while let Some(next) = form.next(&ready, |e| parts.get(e).and_then(|_| depth.get(e).copied())) {
        if form.arena.len() - before > most {
            return None;
        }
        let e = ready.swap_remove(next);
        let Some(part) = parts.get(&e) else {
            solved.push(form.eliminate(e)?);
            continue;
        };
        for other in &ready {
            if let Some(turned) = parts.get(other).and_then(|other| turn(form.arena, part, other)) {
                form.turn_block(e, *other, &turned);
            } else if let Some(turned) = parts.get(other).and_then(|other| turn(form.arena, other, part)) {
                form.turn_block(*other, e, &turned);
            }
        }
        form.substitute(e, part);
        for (of, _) in &part.terms {
            let count = left.get_mut(of)?;
            *count -= 1;
            if *count == 0 {
                ready.push(*of);
            }
        }
    }
    solved.reverse();
    let is_whole = solved.len() == unknowns.len();
    solved.extend(following);
    is_whole.then_some(solved)
}

/// Depth of each name: number of unknowns that it depends on, and number of names between. Both are 0 for an order that
/// does not use them.
fn depths(order: Order, named: &[Expr], parts: &FxHashMap<Expr, Part>, unknowns: &[Expr]) -> FxHashMap<Expr, Depth> {
    let mut reach: FxHashMap<Expr, BTreeSet<Expr>> = unknowns.iter().map(|e| (*e, BTreeSet::from([*e]))).collect();
    let mut depth: FxHashMap<Expr, Depth> = FxHashMap::default();
    for e in named {
        let terms = &parts[e].terms;
        let found: BTreeSet<Expr> = terms.iter().flat_map(|(of, _)| &reach[of]).copied().collect();
        let names = terms.iter().filter_map(|(of, _)| depth.get(of)).map(|below| below.1 + 1).max().unwrap_or(0);
        depth.insert(*e, if order == Order::Farthest { (found.len(), names) } else { (0, 0) });
        reach.insert(*e, found);
    }
    depth
}

/// Named terms within `terms` that depend on the unknowns, operands first.
fn depending(arena: &Arena, terms: &[Expr], unknowns: &[Expr]) -> Vec<Expr> {
    let mut varying: FxHashSet<Expr> = unknowns.iter().copied().collect();
    let mut parts = arena.reachable(terms);
    parts.retain(|e| {
        let varies = arena.operands(*e).any(|operand| varying.contains(&operand));
        varies && varying.insert(*e) && arena.behind(*e).is_some()
    });
    parts
}
