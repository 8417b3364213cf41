//! Reactions as terms in q, u and u̇, from the balances of forces and torques on the bodies.
//!
//! The first equations are the balances along the reactions, then follow those along axes of
//! frames. In the first ones a reaction has the coefficient 1. So no cosine that may become zero
//! during the motion becomes a divisor.

use super::solved_rows::solve_rows;
use crate::algebra::form::simplify::Simplifier;
use crate::algebra::{Arena, Expr};
use crate::mechanics::{Equations, Kinematics, balance_multipliers_along_reactions};
use crate::model::Model;

/// Linear system matrix · reactions = right. It has more rows than reactions, and rows may be
/// dependent.
#[derive(Clone)]
pub struct ReactionBalance {
    /// Symbols of the reactions, which are the unknowns.
    reactions: Vec<Expr>,
    /// Matrix of the system, with a column for each reaction.
    matrix: Vec<Vec<Expr>>,
    /// Right-hand side of the system, as terms in q, u and u̇.
    right: Vec<Expr>,
}

impl ReactionBalance {
    /// Builds the system from Newton–Euler equations, whose unknowns are first the accelerations,
    /// then the reactions.
    pub fn new(model: &Model, kinematics: &mut Kinematics, equations: &Equations) -> Self {
        let n = equations.variables.len();
        let along = balance_multipliers_along_reactions(model, kinematics, &equations.rows);
        let Kinematics { arena, simplifier, .. } = kinematics;
        let (mut matrix, mut right) = (Vec::new(), Vec::new());
        for multipliers in along {
            let mut column = |entry: &dyn Fn(usize) -> Expr| {
                let terms: Vec<Expr> =
                    multipliers.iter().enumerate().map(|(row, by)| arena.mul(*by, entry(row))).collect();
                let sum = arena.sum(&terms);
                simplifier.simplify(arena, sum)
            };
            matrix.push((0..equations.unknowns.len()).map(|at| column(&|row| equations.matrix[row][at])).collect());
            right.push(column(&|row| equations.forcing[row]));
        }
        matrix.extend(equations.matrix.iter().cloned());
        right.extend(equations.forcing.iter().copied());
        for (row, value) in matrix.iter_mut().zip(&mut right) {
            let products: Vec<Expr> = row.drain(..n).zip(&equations.unknowns).map(|(a, x)| arena.mul(a, *x)).collect();
            let moving = arena.sum(&products);
            *value = arena.sub(*value, moving);
        }
        Self { reactions: equations.unknowns[n..].to_vec(), matrix, right }
    }

    /// Applies `change` to every term of the system in place.
    pub fn visit(&mut self, change: &mut dyn FnMut(&mut Expr)) {
        self.matrix.iter_mut().flatten().chain(&mut self.right).for_each(change);
    }

    /// Solves for the reactions. Returns pairs (symbol of a reaction, value); a reaction that is
    /// not determined has its own symbol as value. `states` are the variables that change along a
    /// motion; pivots without them are preferred.
    pub fn solved_reactions(
        self,
        arena: &mut Arena,
        simplifier: &mut Simplifier,
        states: &[Expr],
    ) -> Vec<(Expr, Expr)> {
        let right = self.right.into_iter().map(|value| vec![value]).collect();
        let columns: Vec<usize> = (0..self.reactions.len()).collect();
        let solved = solve_rows(arena, simplifier, self.matrix, right, states, &columns);
        let mut values = self.reactions.clone();
        for k in (0..solved.pivots.len()).rev() {
            let value = solved.value_of_pivot_unknown(arena, k, 0, &values);
            values[solved.pivots[k].1] = simplifier.simplify(arena, value);
        }
        self.reactions.into_iter().zip(values).collect()
    }
}
