//! Equations in the distance from a singular surface instead of the coordinate itself.
//!
//! Near q = π/2 the number q has no digits left for π/2 − q: at a distance of 10⁻⁵ five of sixteen are gone before anything is
//! computed. In d = q − π/2 the same equations read cos q = −sin d, exactly, and nothing is lost.

use super::{Derivation, Equations};
use crate::algebra::calculus::Substitution;
use crate::algebra::simplify::Simplifier;
use crate::algebra::steps::fresh_symbol;
use crate::algebra::{Arena, Expr, Function, Node};
use crate::model::Model;

/// A coordinate is replaced by its distance from a multiple of a quarter turn.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Distance {
    /// Which coordinate, from 0.
    pub coordinate: usize,
    /// The origin in quarter turns: 1 for 90°.
    pub quarter_turns: i32,
}

impl Distance {
    /// How equations in it are called: `q2-90deg`.
    #[must_use]
    pub fn name(&self, model: &Model) -> String {
        let degrees = 90 * i64::from(self.quarter_turns);
        let sign = if degrees < 0 { '+' } else { '-' };
        format!("{}{sign}{}deg", model.coordinates[self.coordinate].name, degrees.abs())
    }
}

/// The distances that are worth having: from +90° for each coordinate by whose cosine the kinematic equations divide.
#[must_use]
pub fn distances(model: &Model) -> Vec<Distance> {
    let arena = &model.arena;
    let divides = |coordinate: Expr| {
        let parts = arena.reachable(&model.kinematic_equations.divisors);
        parts.into_iter().any(|e| matches!(arena.node(e), Node::Apply(Function::Cos, angle) if *angle == coordinate))
    };
    let coordinates = model.coordinates.iter().enumerate().filter(|(_, c)| divides(c.symbol));
    coordinates.map(|(coordinate, _)| Distance { coordinate, quarter_turns: 1 }).collect()
}

/// The same equations in a distance: every place of the coordinate holds d + origin, simplified.
#[must_use]
pub fn in_distance(model: &Model, derivation: Derivation, distance: Distance) -> Derivation {
    let Derivation { mut arena, mut equations } = derivation;
    let coordinate = &model.coordinates[distance.coordinate];
    let degrees = 90 * i64::from(distance.quarter_turns);
    let side = if degrees < 0 { "plus" } else { "minus" };
    let symbol = fresh_symbol(&mut arena, &format!("{}_{side}_{}deg", coordinate.name, degrees.abs()));
    let pi = arena.pi();
    let quarter = arena.ratio(i64::from(distance.quarter_turns), 2);
    let origin = arena.mul(quarter, pi);
    let sum = arena.add(symbol, origin);
    let mut put = Substitution::new(&[(coordinate.symbol, sum)]);
    let mut simplifier = Simplifier::default();
    visit(
        &mut equations,
        &mut |e: &mut Expr, arena: &mut Arena| {
            let moved = put.apply(arena, *e);
            *e = simplifier.simplify(arena, moved);
        },
        &mut arena,
    );
    equations.coordinates[distance.coordinate] = symbol;
    equations.name = format!("{}@{}", equations.name, distance.name(model));
    equations.title = format!("{} in {}", equations.title, distance.name(model).replace("deg", "°"));
    Derivation { arena, equations }
}

/// Changes every expression of the equations.
pub fn visit(e: &mut Equations, change: &mut dyn FnMut(&mut Expr, &mut Arena), arena: &mut Arena) {
    let vectors = [
        &mut e.forcing,
        &mut e.coordinate_rates,
        &mut e.generalized_speeds,
        &mut e.generalized_speed_rates,
        &mut e.motion_variables,
        &mut e.divisors,
    ];
    let matrices = e.matrix.iter_mut().chain(&mut e.projection);
    let scalars = [&mut e.kinetic_energy, &mut e.potential_energy];
    let definitions = e.definitions.iter_mut().map(|d| &mut d.value);
    let all = vectors.into_iter().chain(matrices).flatten().chain(scalars).chain(definitions);
    for value in all {
        change(value, arena);
    }
}
