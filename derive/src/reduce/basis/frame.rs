//! Equations in a moving frame, in which symmetries keep chosen states at zero.
//!
//! A symmetry ζ(x) maps solutions of x' = f(x) to solutions. So with numbers ε(y) the motion y' = f(y) + Σ ε ζ(y) is at
//! every instant a solution x, transformed by symmetries. Every quantity that no ζ changes is equal in x and y. As many
//! states are pinned as there are symmetries. If the matrix of the ζ's components at the pinned states has full rank, ε
//! can keep these states at zero. Then they are no states any more (a cross-section and its moving frame: M. Fels & P.
//! J. Olver 1999).

use crate::algebra::term::calculus::Substitution;
use crate::algebra::{Arena, Expr};
use crate::mechanics::{Equations, Solved};

/// Symmetry of the equations, which maps solutions to solutions.
#[derive(Clone)]
pub struct Turn {
    /// Description of the motion along the symmetry, in words.
    pub words: String,
    /// Components of the symmetry in the states of the equations, q then u.
    pub along: Vec<Expr>,
    /// Components of the symmetry in the model's own q and u.
    pub of_model: Vec<Expr>,
}

/// Moving frame: symmetries that move it, and the states that stay zero in it.
#[derive(Clone)]
pub struct Frame {
    /// Symmetries along which the frame moves, as indices among those of the reduction basis.
    pub turns: Vec<usize>,
    /// States that stay zero in the frame, as indices in q, then u.
    pub pins: Vec<usize>,
    /// Velocity ε of the frame along each of its symmetries.
    pub rates: Vec<Expr>,
    /// Addition Σ ε ζ to the rate of each state by the motion of the frame.
    pub added: Vec<Expr>,
    /// Divisors of the frame's velocities; the frame is singular where a divisor is zero.
    pub divisors: Vec<Expr>,
}

/// Rates q̇ and u̇ of equations, in q and u, with shared subterms. `None` if the accelerations are not determined.
pub fn solved_rates(arena: &mut Arena, kane: &Equations) -> Option<Vec<Expr>> {
    let mut solved = Substitution::default();
    for step in Solved::steps(arena, kane).ok()? {
        let value = solved.apply(arena, step.value);
        solved.set(step.symbol, value);
    }
    Some(kane.coordinate_rates.iter().chain(&kane.unknowns).map(|e| solved.apply(arena, *e)).collect())
}
