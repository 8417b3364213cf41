//! Transposed products with a Jacobian: Σ weight · ∂e/∂x for many variables x, at the cost of a
//! single evaluation.
//!
//! Named terms are processed from the last to the first, as in the reverse mode of automatic
//! differentiation: A. Griewank & A. Walther, *Evaluating Derivatives*, 2nd edition (2008), §3.2.
//! The weight of a named term is the sum of the contributions of all terms that contain it. Each
//! named term passes its weight on to the terms that it contains. The work grows with the number of
//! names, not with the product of names and variables.

use super::calculus::Gradient;
use crate::algebra::{Arena, Expr};
use rustc_hash::{FxHashMap, FxHashSet};

/// Computes Σ weight · ∂e/∂x over the pairs (e, weight), for each variable x: the transposed
/// Jacobian times the weights. The result has one sum for each variable, in the order of
/// `variables`. The weight of a named term gets a name too: `letter`, an underscore and the term's
/// name.
pub fn adjoint_product(arena: &mut Arena, pairs: &[(Expr, Expr)], variables: &[Expr], letter: &str) -> Vec<Expr> {
    let roots: Vec<Expr> = pairs.iter().map(|(e, _)| *e).collect();
    let mut varying: FxHashSet<Expr> = variables.iter().copied().collect();
    let mut named: Vec<Expr> = Vec::new();
    for e in arena.reachable(&roots) {
        if arena.operands(e).any(|operand| varying.contains(&operand)) {
            varying.insert(e);
            if arena.named_term_value(e).is_some() {
                named.push(e);
            }
        }
    }
    let ends: Vec<Expr> = named.iter().chain(variables).copied().collect();
    let mut gradient = Gradient::new(&ends);
    let mut weights: FxHashMap<Expr, Vec<Expr>> = FxHashMap::default();
    let mut spread = |arena: &mut Arena, weights: &mut FxHashMap<Expr, Vec<Expr>>, e: Expr, weight: Expr| {
        for (at, slope) in gradient.apply(arena, e).iter() {
            let share = arena.mul(*slope, weight);
            weights.entry(ends[*at]).or_default().push(share);
        }
    };
    for (e, weight) in pairs {
        spread(arena, &mut weights, *e, *weight);
    }
    for e in named.iter().rev() {
        let Some(shares) = weights.remove(e) else { continue };
        let sum = arena.sum(&shares);
        let wanted = format!("{letter}_{}", arena.name_of(*e).unwrap_or_default());
        let weight = arena.name(sum, &wanted);
        if let Some(term) = arena.named_term_value(*e).filter(|_| weight != Expr::ZERO) {
            spread(arena, &mut weights, term, weight);
        }
    }
    variables.iter().map(|x| weights.remove(x).map_or(Expr::ZERO, |shares| arena.sum(&shares))).collect()
}
