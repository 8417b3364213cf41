//! Moving frame of equations: with it, symmetries keep chosen states at zero.
//!
//! A symmetry ζ(x) maps solutions of x' = f(x) to solutions. So with numbers ε(y), a solution of y' =
//! f(y) + Σ ε ζ(y) is at every instant a solution x, transformed by symmetries. Every quantity that
//! no ζ changes is equal in x and y.
//!
//! The number of pinned states (states kept at zero) is the number of symmetries. This is possible
//! if the matrix of the ζ's components at the pinned states has full rank. Then the pinned states
//! leave the equations (a cross-section and its moving frame: M. Fels & P. J. Olver 1999).

use crate::algebra::term::calculus::Substitution;
use crate::algebra::{Arena, Expr};
use crate::mechanics::{Equations, SolvedAccelerations};

/// Symmetry of the equations: a vector field ζ on the states that maps solutions to solutions.
#[derive(Clone)]
pub struct FrameSymmetry {
    /// Description in words of the motion along the symmetry, such as a translation along an axis.
    pub words: String,
    /// Components of ζ for the states of the equations, q then u, as terms in these states.
    pub along: Vec<Expr>,
    /// Components of ζ for the states of the model, q then u, as terms in the states of the model.
    pub of_model: Vec<Expr>,
}

/// Moving frame: the symmetries along which the frame moves, and the states that it keeps at zero.
#[derive(Clone)]
pub struct PinnedFrame {
    /// Symmetries along which the frame moves, as indices into `ReductionBasis::turns`.
    pub turns: Vec<usize>,
    /// States that the frame keeps at zero, as indices in q, then u.
    pub pins: Vec<usize>,
    /// Velocity ε of the frame along each of its symmetries, as a term in q and u.
    pub rates: Vec<Expr>,
    /// Summand Σ ε ζ that the frame adds to the rate of each state.
    pub added: Vec<Expr>,
    /// Divisors of the frame's velocities ε. The frame is singular at states where a divisor is
    /// zero.
    pub divisors: Vec<Expr>,
}

/// Rates q̇, then u̇, of the given equations, as terms in q and u. `None` if the equations do not
/// determine the accelerations.
pub fn solved_rates(arena: &mut Arena, kane: &Equations) -> Option<Vec<Expr>> {
    let mut solved = Substitution::default();
    for step in SolvedAccelerations::steps(arena, kane).ok()? {
        let value = solved.apply(arena, step.value);
        solved.set(step.symbol, value);
    }
    Some(kane.coordinate_rates.iter().chain(&kane.unknowns).map(|e| solved.apply(arena, *e)).collect())
}
