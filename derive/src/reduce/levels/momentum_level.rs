//! Motion on a level set of momenta: the constant momenta determine speeds, and equations remain
//! for the other speeds.
//!
//! The momenta A u + b = c are solved as u = P(q; c) + Z(q) u_R, where u_R are the remaining
//! speeds. Kane's equations multiplied by Zᵀ are (Zᵀ M Z) u̇_R = Zᵀ(f − M (Ṗ + Ż u_R)). The rows of
//! A are momenta of symmetries ξ, so Kane's equations multiplied by ξᵀ state that c is constant.
//! These two sets are together equivalent to Kane's equations wherever A has full rank.

use super::held_momenta::HeldMomentum;
use super::surface_quotients::SingularSurface;
use crate::algebra::form::simplify::Simplifier;
use crate::algebra::term::steps::Definition;
use crate::algebra::{Arena, Expr};
use crate::reduce::basis::reduction_basis::ReductionBasis;
use crate::reduce::basis::solved_rows::{SolvedRows, solve_rows};

/// Equations of motion on a level set of momenta. The constant momenta determine some speeds;
/// equations remain for the other speeds u_R.
#[derive(Clone)]
pub struct Level {
    /// Momenta that are kept constant, each with a symbol for its value.
    pub held: Vec<HeldMomentum>,
    /// Indices of the speeds u_R that the momenta do not determine, so that they remain in the
    /// equations.
    pub kept: Vec<usize>,
    /// Definitions of the determined speeds, as terms in q, the constant momenta, u_R and speeds
    /// defined before.
    pub definitions: Vec<Definition>,
    /// Rates u̇ of all speeds, as terms in q, u and the rates u̇_R of the remaining speeds.
    pub accelerations: Vec<Expr>,
    /// Mass matrix Zᵀ M Z of the remaining speeds u_R, in q.
    pub matrix: Vec<Vec<Expr>>,
    /// Forcing Zᵀ(f − M (Ṗ + Ż u_R)) of the remaining speeds u_R, in q and u.
    pub forcing: Vec<Expr>,
    /// Divisors of the determined speeds and of the frame's rates, except numbers.
    pub divisors: Vec<Expr>,
}

impl ReductionBasis {
    /// Derives the equations on the level set of the given momenta. If `surface` is given,
    /// quotients are rewritten so that they do not cancel near it.
    ///
    /// `None` if the symmetries of the momenta move more or fewer speeds than there are momenta.
    /// `None` also if the momenta do not determine these speeds.
    pub(in crate::reduce) fn equations_on_momentum_level(
        &mut self,
        momenta: &[usize],
        surface: Option<&SingularSurface>,
    ) -> Option<Level> {
        let n = self.kane.variables.len();
        if momenta.len() > n {
            return None;
        }
        let mut held: Vec<HeldMomentum> = momenta.iter().map(|at| self.hold_momentum(*at)).collect();
        // If the symmetries move as many speeds as there are momenta, the mass matrix of these
        // speeds is positive definite. Then the momenta determine the speeds wherever the
        // symmetries are independent. With more speeds to choose from, there would be further
        // singularities.
        let moved = |at: usize| momenta.iter().any(|m| self.momenta[*m].direction[at] != Expr::ZERO);
        let free = (0..n).filter(|at| !self.section_pins_speed(*at));
        let (solved_for, kept): (Vec<usize>, Vec<usize>) = free.partition(|at| moved(*at));
        if solved_for.len() != momenta.len() {
            return None;
        }
        let rows: Vec<Vec<Expr>> = momenta.iter().map(|at| self.momenta[*at].row.clone()).collect();
        let right = held.iter().map(|h| self.momentum_right_sides(h)).collect();
        let (arena, simplifier) = (&mut self.arena, &mut self.simplifier);
        let states = [self.q.clone(), self.kane.variables.clone()].concat();
        let mut solved = solve_rows(arena, simplifier, rows, right, &states, &solved_for);
        if solved.pivots.len() < momenta.len() {
            return None;
        }
        let z = momentum_level_directions(arena, simplifier, &solved, &kept, n);
        if let Some(surface) = surface {
            surface.split_surface_quotients(arena, simplifier, &mut solved, &mut held);
        }
        self.choose_momentum_constants(&mut solved, &mut held);
        Some(self.momentum_level_of_kept_speeds(held, kept, &solved, &z))
    }

    /// Derives the equations of the remaining speeds, whose indices are `kept`, from the solved
    /// momenta and the matrix Z.
    fn momentum_level_of_kept_speeds(
        &mut self,
        held: Vec<HeldMomentum>,
        kept: Vec<usize>,
        solved: &SolvedRows,
        z: &[Vec<Expr>],
    ) -> Level {
        let (arena, simplifier) = (&mut self.arena, &mut self.simplifier);
        let mut short = |arena: &mut Arena, e: Expr| simplifier.simplify(arena, e);
        let (variables, unknowns) = (&self.kane.variables, &self.kane.unknowns);
        let mut definitions = Vec::new();
        let mut drifts = vec![Expr::ZERO; variables.len()];
        let mut accelerations = unknowns.clone();
        for (at, acceleration) in accelerations.iter_mut().enumerate() {
            if self.frame.as_ref().is_some_and(|frame| frame.pins.contains(&(self.q.len() + at))) {
                *acceleration = Expr::ZERO;
            }
        }
        for k in (0..solved.pivots.len()).rev() {
            let (_, column) = solved.pivots[k];
            let value = solved.value_of_pivot_unknown(arena, k, 0, variables);
            let value = short(arena, value);
            // A speed that is itself a held constant needs no definition.
            if value != variables[column] {
                definitions.push(Definition { symbol: variables[column], value });
            }
            let drift = solved.value_of_pivot_unknown(arena, k, 1, &drifts);
            drifts[column] = short(arena, drift);
            let acceleration = solved.value_of_pivot_unknown(arena, k, 1, &accelerations);
            accelerations[column] = short(arena, acceleration);
        }
        // Kane's equations hold for the motion of the model, so the rates that the frame adds are
        // subtracted.
        if let Some(frame) = &self.frame {
            let added = &frame.added[self.q.len()..];
            for ((drift, acceleration), added) in drifts.iter_mut().zip(&mut accelerations).zip(added) {
                *drift = arena.sub(*drift, *added);
                let whole = arena.sub(*acceleration, *added);
                *acceleration = short(arena, whole);
            }
        }
        let m = &self.kane.matrix;
        let (mut matrix, mut forcing) = (Vec::new(), Vec::new());
        for a in 0..kept.len() {
            let mut projected = Vec::new();
            for j in 0..m.len() {
                let terms: Vec<Expr> = (0..m.len()).map(|i| arena.mul(z[i][a], m[i][j])).collect();
                let sum = arena.sum(&terms);
                projected.push(short(arena, sum));
            }
            let mut row = Vec::new();
            for b in 0..kept.len() {
                let terms: Vec<Expr> = projected.iter().zip(z).map(|(p, z)| arena.mul(*p, z[b])).collect();
                let sum = arena.sum(&terms);
                row.push(short(arena, sum));
            }
            matrix.push(row);
            let mut terms: Vec<Expr> = self.kane.forcing.iter().zip(z).map(|(f, z)| arena.mul(*f, z[a])).collect();
            for (p, drift) in projected.iter().zip(&drifts) {
                let term = arena.mul(*p, *drift);
                terms.push(arena.neg(term));
            }
            let sum = arena.sum(&terms);
            forcing.push(short(arena, sum));
        }
        let mut divisors: Vec<Expr> =
            solved.divisors.iter().copied().filter(|d| arena.as_number(*d).is_none()).collect();
        divisors.extend(self.frame.iter().flat_map(|frame| &frame.divisors));
        divisors.dedup();
        Level { held, kept, definitions, accelerations, matrix, forcing, divisors }
    }
}

/// Matrix Z = ∂u/∂u_R at constant momenta, with a row for each speed and a column for each
/// remaining speed u_R.
fn momentum_level_directions(
    arena: &mut Arena,
    simplifier: &mut Simplifier,
    solved: &SolvedRows,
    kept: &[usize],
    n: usize,
) -> Vec<Vec<Expr>> {
    let unit = |place: usize| kept.iter().map(|k| if *k == place { Expr::ONE } else { Expr::ZERO }).collect();
    let mut z: Vec<Vec<Expr>> = (0..n).map(unit).collect();
    for (row, column) in solved.pivots.iter().rev() {
        let others: Vec<usize> = (0..n).filter(|at| at != column && solved.rows[*row][*at] != Expr::ZERO).collect();
        let direction = |direction: usize| {
            let terms: Vec<Expr> =
                others.iter().map(|at| arena.mul(solved.rows[*row][*at], z[*at][direction])).collect();
            let sum = arena.sum(&terms);
            let back = arena.neg(sum);
            simplifier.simplify(arena, back)
        };
        z[*column] = (0..kept.len()).map(direction).collect();
    }
    z
}
