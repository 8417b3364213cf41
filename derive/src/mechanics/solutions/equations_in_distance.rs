//! Equations in the distance of a coordinate from a singular angle, instead of the coordinate
//! itself.
//!
//! Near q = π/2, the number q has few digits for π/2 − q. At a distance of 10⁻⁵, five of sixteen
//! digits are lost before anything is computed. In d = q − π/2, the equations contain cos q = −sin
//! d exactly, and no digit is lost.

use crate::algebra::form::simplify::Simplifier;
use crate::algebra::term::calculus::Substitution;
use crate::algebra::term::steps::fresh_symbol;
use crate::algebra::{Arena, Expr};
use crate::mechanics::derivation::Derivation;
use crate::mechanics::singular_distance::SingularDistance;
use crate::model::Model;

/// Rewrites equations in a distance d: the term d + origin replaces the coordinate in every term. Every term is then
/// simplified.
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
