//! Equations in a moving frame: symmetries turn the state so that some of its variables stay zero.
//!
//! A symmetry ζ(x) takes solutions of x' = f(x) to solutions. So with numbers ε(y) the motion y' = f(y) + Σ ε ζ(y) is
//! at every instant a solution x turned by symmetries alone: every quantity that no ζ changes is equal in both. Where
//! the matrix of the ζ's components at as many pinned states has full rank, ε keeps these at zero, and they are no
//! states any more (a cross-section and its moving frame: M. Fels & P. J. Olver 1999).

use crate::algebra::term::calculus::Substitution;
use crate::algebra::{Arena, Expr};
use crate::mechanics::{Equations, Solved};

/// A symmetry that turns states into one another.
#[derive(Clone)]
pub struct Turn {
    /// Description of the motion along it, in words.
    pub words: String,
    /// Its components in the states of the equations, q then u.
    pub along: Vec<Expr>,
    /// Its components in the model's own q and u.
    pub of_model: Vec<Expr>,
}

/// A moving frame.
#[derive(Clone)]
pub struct Frame {
    /// The symmetries by which it moves, as places among those of the ground.
    pub turns: Vec<usize>,
    /// The states that stay zero, as places in q, then u.
    pub pins: Vec<usize>,
    /// Velocity of the frame along each symmetry.
    pub rates: Vec<Expr>,
    /// Addition to the rate of each state by the motion of the frame.
    pub added: Vec<Expr>,
    /// Divisors of the rates; the frame is singular where one is zero.
    pub divisors: Vec<Expr>,
}

/// q̇ and u̇ of equations, in q and u: shared, not written out. `None` if the accelerations are not determined.
pub fn solved_rates(arena: &mut Arena, kane: &Equations) -> Option<Vec<Expr>> {
    let mut solved = Substitution::default();
    for step in Solved::steps(arena, kane).ok()? {
        let value = solved.apply(arena, step.value);
        solved.set(step.symbol, value);
    }
    Some(kane.coordinate_rates.iter().chain(&kane.unknowns).map(|e| solved.apply(arena, *e)).collect())
}
