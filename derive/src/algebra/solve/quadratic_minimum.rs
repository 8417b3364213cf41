//! Minimization of a quadratic form in named terms: the unknowns at which it has its least value.
//! The time is proportional to the number of names, not to its square.
//!
//! The terms are linear in the unknowns through other named terms. For example, the accelerations
//! of bodies are linear in those of joints, and each body's acceleration contains that of the body
//! before it. The names are removed from the form, the last first: each named term is replaced by
//! the terms in its definition. An unknown that no remaining name depends on is eliminated at once,
//! while few terms are coupled to it.
//!
//! On a chain this is the recursion of articulated bodies (A. F. Vereshchagin, 1974; R.
//! Featherstone, Int. J. Robotics Research 2 (1983) 13–30), found as an elimination in the order of
//! the names. The form that is minimized is then that of Gauss's principle.
//!
//! If an unknown occurs in one name only, the name may replace the unknown. An example is the rate
//! of a relative angle in the angular acceleration of its body. This avoids terms that cancel
//! later. The unknown follows from the name at the end.
//!
//! Invariant: a pivot is the second derivative of the form along one unknown, minimized over the
//! unknowns already eliminated. It is positive where the form is positive definite.

mod form;

use crate::algebra::form::simplify::{Simplifier, operation_count};
use crate::algebra::term::calculus::{Gradient, Substitution};
use crate::algebra::term::steps::Definition;
use crate::algebra::{Arena, Expr};
use form::{Form, LinearPart, ReplacedUnknown, find_rotation};
use rustc_hash::{FxHashMap, FxHashSet};
use std::collections::{BTreeMap, BTreeSet};

/// Block of a quadratic form: ½ Σ K_ij e_i e_j + Σ b_i e_i over three components e, with K
/// symmetric.
#[derive(Clone, Debug)]
pub struct QuadraticBlock {
    /// Components e of the block, linear in the unknowns through named terms.
    pub components: [Expr; 3],
    /// Symmetric 3 × 3 matrix K of the block.
    pub tensor: [[Expr; 3]; 3],
    /// Coefficients b of the linear part, one for each component.
    pub linear: [Expr; 3],
}

/// Quadratic form in the unknowns: the sum of blocks and of a linear form.
#[derive(Clone, Debug)]
pub struct QuadraticForm {
    /// Blocks whose sum is the quadratic part.
    pub blocks: Vec<QuadraticBlock>,
    /// Coefficient of each unknown in the linear form.
    pub linear: Vec<Expr>,
}

/// Order in which named terms and unknowns are eliminated from the quadratic form.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Order {
    /// First the term that depends on most unknowns. Among equals, the term with the longest chain
    /// of names down to the unknowns is first. On an arm these are the terms of the last body, then
    /// those of the body before it.
    Farthest,
    /// First the term that is coupled to the fewest other terms. This is good on a chain whose
    /// angles are all measured from one frame.
    Fewest,
}

/// Kind of terms that are the variables of the minimization.
#[derive(Clone, Copy, PartialEq, Eq)]
enum SolvedFor {
    /// The form is minimized over the unknowns themselves.
    Unknowns,
    /// The form is minimized over names instead of unknowns, for each unknown that occurs in one
    /// name only.
    Names,
}

/// Settings of an attempt to minimize the form: order of elimination, variables, and limit of work.
#[derive(Clone, Copy)]
struct Attempt {
    /// Order in which terms are eliminated from the form.
    order: Order,
    /// Variables over which the form is minimized: unknowns or names.
    solved_for: SolvedFor,
    /// Number of new terms in the arena beyond which the attempt is given up.
    most: usize,
}

/// Depth of a name: the number of unknowns that it depends on, and the length of the longest chain
/// of names down to the unknowns.
type Depth = (usize, usize);

/// Computes the unknowns that minimize a quadratic form. Returns the steps that define the
/// unknowns, in the order of computation, in terms of names and earlier unknowns. Steps may also
/// define names, from which unknowns follow.
///
/// Several orders of elimination are tried; the cheapest result is returned. `None` if a component
/// is not linear in the unknowns, or if the unknowns are not determined.
pub fn minimize_quadratic_form(
    arena: &mut Arena,
    simplifier: &mut Simplifier,
    sum: &QuadraticForm,
    unknowns: &[Expr],
) -> Option<Vec<Definition>> {
    let mut both = Vec::new();
    let mut most = usize::MAX;
    for solved_for in [SolvedFor::Names, SolvedFor::Unknowns] {
        for order in [Order::Farthest, Order::Fewest] {
            let before = arena.len();
            if let Some(solved) = minimize_once(arena, simplifier, sum, unknowns, Attempt { order, solved_for, most }) {
                both.push((cost_of_minimum(arena, &solved), solved));
                // An order that makes more new terms than a finished order is abandoned.
                most = most.min(arena.len() - before);
            }
        }
    }
    both.into_iter().min_by_key(|(cost, _)| *cost).map(|(_, solved)| solved)
}

/// Number of operations of the given steps and of all named terms that they use. Names that the
/// steps define are not counted twice.
fn cost_of_minimum(arena: &Arena, steps: &[Definition]) -> usize {
    let stated: FxHashSet<Expr> = steps.iter().map(|step| step.symbol).collect();
    let values: Vec<Expr> = steps.iter().map(|step| step.value).collect();
    let parts = arena.reachable_until(&values, |part| stated.contains(&part));
    let names = parts.into_iter().filter(|part| !stated.contains(part)).filter_map(|e| arena.named_term_value(e));
    names.chain(values.iter().copied()).map(|e| operation_count(arena, e)).sum()
}

/// Minimizes the form in one attempt with the given settings. `None` if the form does not determine
/// the unknowns, is not linear in names, or needs more new terms than the attempt allows.
fn minimize_once(
    arena: &mut Arena,
    simplifier: &mut Simplifier,
    QuadraticForm { blocks, linear }: &QuadraticForm,
    unknowns: &[Expr],
    attempt: Attempt,
) -> Option<Vec<Definition>> {
    let Attempt { order, solved_for, most } = attempt;
    let before = arena.len();
    let components: Vec<Expr> = blocks.iter().flat_map(|block| block.components).collect();
    let named = names_in_quadratic_form(arena, &components, unknowns);
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
    let mut parts: FxHashMap<Expr, LinearPart> = FxHashMap::default();
    for e in &named {
        let part = form.part(form.arena.named_term_value(*e)?)?;
        parts.insert(*e, part);
    }
    let replaced = match solved_for {
        SolvedFor::Names => form.replaceable_unknowns(&named, &parts, unknowns),
        SolvedFor::Unknowns => Vec::new(),
    };
    if solved_for == SolvedFor::Names && replaced.is_empty() {
        return None;
    }
    let depth = depths(order, &named, &parts, unknowns);
    let mut following = Vec::with_capacity(replaced.len());
    for ReplacedUnknown { unknown, by, sign } in replaced {
        let part = parts.remove(&by)?;
        following.push(form.replace_unknown(unknown, by, sign, &part));
    }
    // Number of remaining names whose definitions contain each unknown or name. A term with the
    // number 0 can be eliminated.
    let mut left: FxHashMap<Expr, usize> = FxHashMap::default();
    for (of, _) in parts.values().flat_map(|part| &part.terms) {
        *left.entry(*of).or_default() += 1;
    }
    let mut solved = Vec::new();
    let is_gone: FxHashSet<Expr> = following.iter().map(|step| step.symbol).collect();
    let is_left = |e: &Expr| !left.contains_key(e) && !is_gone.contains(e);
    let mut ready: Vec<Expr> = form.ends.iter().copied().filter(is_left).collect();
    while let Some(next) = form.next_to_eliminate(&ready, |e| parts.get(e).and_then(|_| depth.get(e).copied())) {
        if form.arena.len() - before > most {
            return None;
        }
        let e = ready.swap_remove(next);
        let Some(part) = parts.get(&e) else {
            solved.push(form.eliminate(e)?);
            continue;
        };
        for other in &ready {
            if let Some(turned) = parts.get(other).and_then(|other| find_rotation(form.arena, part, other)) {
                form.rotate_block(e, *other, &turned);
            } else if let Some(turned) = parts.get(other).and_then(|other| find_rotation(form.arena, other, part)) {
                form.rotate_block(*other, e, &turned);
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

/// Depth of each name: the number of unknowns that it depends on, and the length of the longest
/// chain of names down to the unknowns. Both numbers are 0 for the order `Fewest`, which does not
/// use depths.
fn depths(
    order: Order,
    named: &[Expr],
    parts: &FxHashMap<Expr, LinearPart>,
    unknowns: &[Expr],
) -> FxHashMap<Expr, Depth> {
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

/// Named terms among the subterms of `terms` that depend on the unknowns, operands before the terms
/// built from them.
fn names_in_quadratic_form(arena: &Arena, terms: &[Expr], unknowns: &[Expr]) -> Vec<Expr> {
    let mut varying: FxHashSet<Expr> = unknowns.iter().copied().collect();
    let mut parts = arena.reachable(terms);
    parts.retain(|e| {
        let varies = arena.operands(*e).any(|operand| varying.contains(&operand));
        varies && varying.insert(*e) && arena.named_term_value(*e).is_some()
    });
    parts
}
