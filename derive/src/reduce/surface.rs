//! The singular surface of a reduction, and equations in the distance from it.
//!
//! Where a momentum loses its hold on the speeds, as the spin about the vertical does on an axis that is vertical, the reduced
//! equations hold a quotient N(q; c)/D(q) whose parts vanish together. In d = q − q_s the divisor is computed without
//! cancellation; the numerator is split into what is left of it on the surface, a constant of the motion that is computed once,
//! and a rest in which every 1 − cos d stands as 2 sin²(d/2).

use super::Ground;
use super::level::{Held, Level};
use super::pivots::Solved;
use super::slice::{Flow, Wanted};
use crate::algebra::calculus::Substitution;
use crate::algebra::elimination::fresh_symbol;
use crate::algebra::simplify::Simplifier;
use crate::algebra::{Arena, Expr, Rational};
use crate::mechanics::Distance;
use crate::scene::Scene;
use std::f64::consts::FRAC_PI_2;

/// Turns from the origin within which surfaces are looked for.
const MOST_TURNS: i32 = 100;

/// A singular surface q = k π/2.
#[derive(Clone, Copy, Debug)]
pub struct Surface {
    /// The distance from it; the coordinate itself if k = 0.
    pub symbol: Expr,
}

impl Ground {
    /// Where this level is singular, if that is a multiple of a quarter turn of a coordinate among the states: what the scene
    /// names, or else the one nearest to the start.
    pub(super) fn surface(&mut self, level: &Level, wanted: &Wanted, scene: &Scene) -> Option<Distance> {
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
                // Whole turns later the same surface comes again: the one next to the start counts.
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

    fn vanishes(&mut self, e: Expr, place: Distance) -> bool {
        let origin = quarter(&mut self.arena, place.quarter_turns);
        let mut there = Substitution::new(&[(self.q[place.coordinate], origin)]);
        let value = there.apply(&mut self.arena, e);
        there.undefined.is_none() && self.simplifier.simplify(&mut self.arena, value) == Expr::ZERO
    }

    /// Writes every equation in the distance from a surface; what is wanted comes back in it.
    pub(super) fn measure_from(&mut self, place: Distance, wanted: &Wanted) -> (Surface, Wanted) {
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

    /// The symbol of the distance from a surface.
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

/// k π/2.
pub fn quarter(arena: &mut Arena, turns: i32) -> Expr {
    let pi = arena.pi();
    let half_turns = arena.ratio(i64::from(turns), 2);
    arena.mul(half_turns, pi)
}

impl Surface {
    /// Splits the right-hand sides that are divided by what vanishes on the surface.
    pub(super) fn separate(
        self,
        arena: &mut Arena,
        simplifier: &mut Simplifier,
        solved: &mut Solved,
        held: &mut [Held],
    ) {
        let mut on_surface = Substitution::new(&[(self.symbol, Expr::ZERO)]);
        for k in 0..solved.pivots.len() {
            let (row, divisor) = (solved.pivots[k].0, solved.divisors[k]);
            let value = on_surface.apply(arena, divisor);
            if simplifier.simplify(arena, value) != Expr::ZERO {
                continue;
            }
            let Some((given_way, instead)) =
                self.separate_row(arena, simplifier, (row, &mut solved.right[row][0], divisor), held)
            else {
                continue;
            };
            let mut put = Substitution::new(&[(given_way, instead)]);
            for right in &mut solved.right {
                let moved = put.apply(arena, right[0]);
                right[0] = simplifier.simplify(arena, moved);
            }
        }
    }

    /// One quotient N/D with D = 0 on the surface and N linear in what is held: a momentum gives way to N on the surface.
    /// Returned are the symbol that gave way and what stands for it now.
    fn separate_row(
        self,
        arena: &mut Arena,
        simplifier: &mut Simplifier,
        (row, quotient, divisor): (usize, &mut Expr, Expr),
        held: &mut [Held],
    ) -> Option<(Expr, Expr)> {
        let product = arena.mul(*quotient, divisor);
        let numerator = simplifier.simplify(arena, product);
        let mut on_surface = Substitution::new(&[(self.symbol, Expr::ZERO)]);
        let left = on_surface.apply(arena, numerator);
        let left = simplifier.simplify(arena, left);
        if on_surface.undefined.is_some() || left == Expr::ZERO || left == numerator {
            return None;
        }
        let symbols: Vec<Expr> = held.iter().map(|h| h.symbol).collect();
        // Only a combination of momenta with constant coefficients is a constant of the motion.
        let constant = arena
            .reachable(&[left])
            .iter()
            .all(|e| arena.symbol_name(*e).is_none() || symbols.contains(e) || arena.is_positive(*e));
        let (coefficients, rest) = crate::algebra::linear::LinearForm::new(&symbols).coefficients(arena, left).ok()?;
        // Its own momentum, if that stands alone in the numerator.
        let alone = |at: &usize| arena.as_number(coefficients[*at]).is_some_and(|k| !k.is_zero());
        let at = std::iter::once(row).chain(0..symbols.len()).find(alone)?;
        if !constant || rest != Expr::ZERO {
            return None;
        }
        let name = arena.symbol_name(symbols[at]).unwrap_or_default().to_owned();
        let fresh = fresh_symbol(arena, &format!("{name}_there"));
        // fresh = Σ coefficient · momentum, solved for the one that gives way.
        let others: Vec<Expr> = (0..symbols.len())
            .filter(|other| *other != at)
            .map(|other| arena.mul(coefficients[other], symbols[other]))
            .collect();
        let others = arena.sum(&others);
        let difference = arena.sub(fresh, others);
        let instead = arena.div(difference, coefficients[at])?;
        let mut put = Substitution::new(&[(symbols[at], instead)]);
        let moved = put.apply(arena, numerator);
        let cosine = arena.cos(self.symbol);
        let half = arena.scale(self.symbol, &Rational::fraction(1, 2)?);
        let sine = arena.sin(half);
        let square = arena.square(sine);
        let twice = arena.scale(square, &Rational::integer(2));
        let versed = arena.sub(Expr::ONE, twice);
        let moved = Substitution::new(&[(cosine, versed)]).apply(arena, moved);
        let moved = simplifier.simplify(arena, moved);
        *quotient = arena.div(moved, divisor)?;
        let terms: Vec<Expr> = coefficients.iter().zip(held.iter()).map(|(c, h)| arena.mul(*c, h.of_state)).collect();
        let of_state = arena.sum(&terms);
        let about = format!("{}, what is left of it on the singular surface", held[at].about);
        held[at] = Held { symbol: fresh, of_state: simplifier.simplify(arena, of_state), about, ..held[at].clone() };
        Some((symbols[at], instead))
    }
}
