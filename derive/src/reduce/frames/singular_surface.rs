//! Singular surface of a reduction, and equations in the distance from it.
//!
//! On a singular surface, a momentum does not determine its speed. An example is the spin about a
//! vertical axis. The reduced equations then contain a quotient N(q; c)/D(q) of two terms that are
//! both zero on the surface. In the distance d = q − q_s, the divisor is computed without
//! cancellation. The module `surface_quotients` rewrites the numerator.

use crate::algebra::form::simplify::Simplifier;
use crate::algebra::term::calculus::Substitution;
use crate::algebra::term::steps::fresh_symbol;
use crate::algebra::{Arena, Expr};
use crate::mechanics::SingularDistance;
use crate::reduce::basis::reduction_basis::ReductionBasis;
use crate::reduce::levels::momentum_level::Level;
use crate::reduce::levels::surface_quotients::SingularSurface;
use crate::reduce::result::surface_choice::{SurfaceChoice, nearest_repetition, nearest_singular};
use crate::reduce::slices::slice::Slice;
use crate::reduce::slices::wanted_outputs::WantedOutputs;
use crate::scene::Scene;

impl ReductionBasis {
    /// Chooses the singular surface of reduced equations, on which one of the states is a multiple of
    /// a quarter turn. A surface that the scene names takes precedence over the surface nearest to
    /// the start. No surface is chosen if there is none, or if the scene forbids distances.
    pub(in crate::reduce) fn choose_singular_surface(
        &mut self,
        level: &Level,
        wanted: &WantedOutputs,
        scene: &Scene,
    ) -> SurfaceChoice {
        let stated = scene.integration.distance;
        if !scene.integration.may_measure || (level.divisors.is_empty() && stated.is_none()) {
            return SurfaceChoice::default();
        }
        let Some(flow) = Slice::new(self, level, wanted) else { return SurfaceChoice::default() };
        if let Some(chosen) = stated.filter(|d| flow.is_slice_state(self.q[d.coordinate])) {
            return SurfaceChoice { examined: Vec::new(), chosen: Some(chosen) };
        }
        let candidates: Vec<usize> = (0..self.q.len()).filter(|at| flow.is_slice_state(self.q[*at])).collect();
        let mut examined = Vec::new();
        for coordinate in candidates {
            for quarter_turns in -2..2 {
                // The surface repeats after each whole turn; the repetition nearest to the start is
                // used.
                let place = nearest_repetition(SingularDistance { coordinate, quarter_turns }, &scene.q);
                examined.push((place, level.divisors.iter().any(|d| self.vanishes_on_surface(*d, place))));
            }
        }
        let chosen = nearest_singular(&examined, &scene.q);
        SurfaceChoice { examined, chosen }
    }

    /// True if the term `e` is zero where the coordinate has the value of the surface `place`.
    fn vanishes_on_surface(&mut self, e: Expr, place: SingularDistance) -> bool {
        let origin = quarter_turn_angle(&mut self.arena, place.quarter_turns);
        let mut there = Substitution::new(&[(self.q[place.coordinate], origin)]);
        let value = there.apply(&mut self.arena, e);
        there.undefined.is_none() && self.simplifier.simplify(&mut self.arena, value) == Expr::ZERO
    }

    /// Writes all equations in the distance from the surface `place`. Returns the surface, and the
    /// wanted quantities in terms of the distance.
    pub(in crate::reduce) fn write_in_distance_from_surface(
        &mut self,
        place: SingularDistance,
        wanted: &WantedOutputs,
    ) -> (SingularSurface, WantedOutputs) {
        let surface = SingularSurface { symbol: self.distance_symbol(place) };
        let SingularDistance { coordinate, quarter_turns } = place;
        if quarter_turns == 0 {
            return (surface, wanted.clone());
        }
        let origin = quarter_turn_angle(&mut self.arena, quarter_turns);
        let sum = self.arena.add(surface.symbol, origin);
        let mut put = Substitution::new(&[(self.q[coordinate], sum)]);
        let mut rewrite = |arena: &mut Arena, simplifier: &mut Simplifier, e: Expr| {
            let moved = put.apply(arena, e);
            simplifier.simplify(arena, moved)
        };
        self.rewrite_basis_terms(&mut rewrite);
        let wanted = wanted.map(|e| put.apply(&mut self.arena, e));
        self.q[coordinate] = surface.symbol;
        self.q_start[coordinate] = self.arena.sub(self.q_start[coordinate], origin);
        self.kane.coordinates[coordinate] = surface.symbol;
        (surface, wanted)
    }

    /// Symbol of the distance of a coordinate from a surface. It is the coordinate itself if the
    /// surface is at 0.
    fn distance_symbol(&mut self, place: SingularDistance) -> Expr {
        let name = &self.model.coordinates[place.coordinate].name;
        let degrees = 90 * place.quarter_turns;
        let side = if degrees < 0 { "plus" } else { "minus" };
        match degrees {
            0 => self.q[place.coordinate],
            _ => fresh_symbol(&mut self.arena, &format!("{name}_{side}_{}deg", degrees.abs())),
        }
    }
}

/// Angle k π/2, rad, as a term, where k is the number `turns` of quarter turns.
pub fn quarter_turn_angle(arena: &mut Arena, turns: i32) -> Expr {
    let pi = arena.pi();
    let half_turns = arena.ratio(i64::from(turns), 2);
    arena.mul(half_turns, pi)
}
