//! Singular surface of a reduction, and equations in the distance from it.
//!
//! On a singular surface a momentum does not determine its speed; an example is the spin about a
//! vertical axis. There, the reduced equations contain a quotient N(q; c)/D(q) of two terms that
//! vanish together. In d = q − q_s, the divisor is computed without cancellation; the module
//! `separate` treats the numerator.

use crate::algebra::form::simplify::Simplifier;
use crate::algebra::term::calculus::Substitution;
use crate::algebra::term::steps::fresh_symbol;
use crate::algebra::{Arena, Expr};
use crate::mechanics::Distance;
use crate::reduce::basis::reduction_basis::ReductionBasis;
use crate::reduce::levels::level::Level;
use crate::reduce::levels::separate::Surface;
use crate::reduce::slices::outputs::Wanted;
use crate::reduce::slices::slice::Flow;
use crate::scene::Scene;
use std::f64::consts::FRAC_PI_2;

/// Number of whole turns on either side of a coordinate's origin within which singular surfaces are
/// searched.
const MOST_TURNS: i32 = 100;

impl ReductionBasis {
    /// Finds the singular surface of reduced equations, if it is a multiple of a quarter turn of an
    /// integrated coordinate. A surface that the scene names takes precedence over the surface nearest
    /// to the start. `None` if there is no such surface, or if the scene forbids distances.
    pub(in crate::reduce) fn surface(&mut self, level: &Level, wanted: &Wanted, scene: &Scene) -> Option<Distance> {
        let stated = scene.integration.distance;
        if !scene.integration.may_measure || (level.divisors.is_empty() && stated.is_none()) {
            return None;
        }
        let flow = Flow::new(self, level, wanted)?;
        let candidates: Vec<usize> = (0..self.q.len()).filter(|at| flow.is_core(self.q[*at])).collect();
        let mut found: Vec<(f64, usize, i32)> = Vec::new();
        for at in candidates {
            let away = |turns: i32| (scene.q[at] - f64::from(turns) * FRAC_PI_2).abs();
            for quarter_turns in -2..2 {
                // The surface repeats after each whole turn; the repetition nearest to the start counts.
                let again = (-MOST_TURNS..=MOST_TURNS).map(|turn| quarter_turns + 4 * turn);
                let nearest = again.min_by(|a, b| away(*a).total_cmp(&away(*b))).unwrap_or(quarter_turns);
                let place = Distance { coordinate: at, quarter_turns: nearest };
                if level.divisors.iter().any(|d| self.vanishes(*d, place)) {
                    found.push((away(nearest), at, nearest));
                }
            }
        }
        found.sort_by(|a, b| a.0.total_cmp(&b.0).then((a.1, a.2).cmp(&(b.1, b.2))));
        let nearest = found
            .first()
            .map(|(_, coordinate, quarter_turns)| Distance { coordinate: *coordinate, quarter_turns: *quarter_turns });
        stated.filter(|d| flow.is_core(self.q[d.coordinate])).or(nearest)
    }

    /// True if a term is zero where a coordinate has the value of `place`.
    fn vanishes(&mut self, e: Expr, place: Distance) -> bool {
        let origin = quarter(&mut self.arena, place.quarter_turns);
        let mut there = Substitution::new(&[(self.q[place.coordinate], origin)]);
        let value = there.apply(&mut self.arena, e);
        there.undefined.is_none() && self.simplifier.simplify(&mut self.arena, value) == Expr::ZERO
    }

    /// Writes all equations in the distance from a surface. Returns the surface, and the wanted
    /// quantities in the distance.
    pub(in crate::reduce) fn measure_from(&mut self, place: Distance, wanted: &Wanted) -> (Surface, Wanted) {
        let surface = Surface { symbol: self.distance_symbol(place) };
        let Distance { coordinate, quarter_turns } = place;
        if quarter_turns == 0 {
            return (surface, wanted.clone());
        }
        let origin = quarter(&mut self.arena, quarter_turns);
        let sum = self.arena.add(surface.symbol, origin);
        let mut put = Substitution::new(&[(self.q[coordinate], sum)]);
        let mut rewrite = |arena: &mut Arena, simplifier: &mut Simplifier, e: Expr| {
            let moved = put.apply(arena, e);
            simplifier.simplify(arena, moved)
        };
        self.change(&mut rewrite);
        let wanted = wanted.map(|e| put.apply(&mut self.arena, e));
        self.q[coordinate] = surface.symbol;
        self.q_start[coordinate] = self.arena.sub(self.q_start[coordinate], origin);
        self.kane.coordinates[coordinate] = surface.symbol;
        (surface, wanted)
    }

    /// Symbol of the distance from a surface; the coordinate itself if the surface is at 0.
    fn distance_symbol(&mut self, place: Distance) -> Expr {
        let name = &self.model.coordinates[place.coordinate].name;
        let degrees = 90 * place.quarter_turns;
        let side = if degrees < 0 { "plus" } else { "minus" };
        match degrees {
            0 => self.q[place.coordinate],
            _ => fresh_symbol(&mut self.arena, &format!("{name}_{side}_{}deg", degrees.abs())),
        }
    }
}

/// Angle k π/2 of k = `turns` quarter turns, rad, as a term.
pub fn quarter(arena: &mut Arena, turns: i32) -> Expr {
    let pi = arena.pi();
    let half_turns = arena.ratio(i64::from(turns), 2);
    arena.mul(half_turns, pi)
}
