//! Equations in the distance of a coordinate from a singular angle, instead of the coordinate
//! itself.
//!
//! Near q = π/2, the number q has few digits for π/2 − q. At a distance of 10⁻⁵, five of sixteen
//! digits are lost before anything is computed. In d = q − π/2, the equations contain cos q = −sin
//! d exactly, and no digit is lost.

use crate::algebra::form::simplify::Simplifier;
use crate::algebra::term::calculus::Substitution;
use crate::algebra::term::steps::fresh_symbol;
use crate::algebra::{Arena, Expr, Function, Node};
use crate::mechanics::derivation::Derivation;
use crate::mechanics::equations_origin::SingularDistance;
use crate::model::Model;

/// Lists the useful distances of a model: from +90° for each coordinate whose cosine divides in the
/// kinematic equations. Empty for a model with loops: its divisors vanish at dead points, which
/// runs pass by other equations.
#[must_use]
pub fn singular_distances(model: &Model) -> Vec<SingularDistance> {
    if !model.loops.is_empty() {
        return Vec::new();
    }
    let arena = &model.arena;
    let is_cosine = |e: &Expr, coordinate: Expr| match arena.node(*e) {
        Node::Apply(Function::Cos, angle) => *angle == coordinate,
        _ => false,
    };
    let divides = |coordinate| model.kinematic_equations.divisors.iter().any(|e| is_cosine(e, coordinate));
    let coordinates = model.coordinates.iter().enumerate().filter(|(_, c)| divides(c.symbol));
    coordinates.map(|(coordinate, _)| SingularDistance { coordinate, quarter_turns: 1 }).collect()
}

/// Rewrites equations in a distance d: d + origin replaces the coordinate in every term, and every
/// term is simplified.
#[must_use]
pub fn equations_in_distance(model: &Model, derivation: Derivation, distance: SingularDistance) -> Derivation {
    let Derivation { mut arena, mut equations } = derivation;
    let coordinate = &model.coordinates[distance.coordinate];
    let degrees = distance.degrees();
    let side = if degrees < 0 { "plus" } else { "minus" };
    let symbol = fresh_symbol(&mut arena, &format!("{}_{side}_{}deg", coordinate.name, degrees.abs()));
    let pi = arena.pi();
    let quarter = arena.ratio(i64::from(distance.quarter_turns), 2);
    let origin = arena.mul(quarter, pi);
    let sum = arena.add(symbol, origin);
    let mut put = Substitution::new(&[(coordinate.symbol, sum)]);
    let mut simplifier = Simplifier::default();
    let mut write = |e: &mut Expr, arena: &mut Arena| {
        let moved = put.apply(arena, *e);
        *e = simplifier.simplify(arena, moved);
    };
    equations.change_terms(&mut write, &mut arena);
    equations.coordinates[distance.coordinate] = symbol;
    equations.distance = Some(distance);
    Derivation { arena, equations }
}
