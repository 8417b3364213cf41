//! Balance of forces at rest along every motion that the constraints permit, with the constraint forces as
//! multipliers.
//!
//! At a dead point, the chosen speeds u do not move the mechanism, so the balance along u is satisfied there by any
//! forces. In the rates of all coordinates, rest needs f(q, 0) + Aᵀ λ = 0 and a = 0. Here f are the applied forces,
//! and A q̇ + a = 0 the constraints (H. Goldstein, C. Poole & J. Safko, *Classical Mechanics*, 3rd edition, 2002, §§
//! 1.4, 2.4).

use super::Flow;
use crate::algebra::Expr;
use crate::algebra::term::calculus::Substitution;
use crate::algebra::term::steps::Definition;
use crate::mechanics::{DeriveError, Formulation, Kinematics, derive_with};
use crate::model::Model;

/// Balance of forces at rest, as conditions on the coordinates and the constraint multipliers.
pub struct RestBalance {
    /// Residuals that vanish at rest, in the form of a flow. The states are the coordinates, then the multipliers.
    /// The rates are the unbalanced force along each coordinate, then the velocity that each constraint demands at
    /// rest.
    pub residuals: Flow,
    /// Number of constraint multipliers among the states, one for each motion constraint.
    pub multipliers: usize,
    /// Generalized speeds at rest, as terms in the coordinates.
    pub speeds: Vec<Expr>,
}

impl RestBalance {
    /// Derives the balance of forces at rest by Lagrange's method.
    ///
    /// # Errors
    /// Returns a [`DeriveError`] if Lagrange's equations cannot be derived for the model.
    pub fn new(model: &Model) -> Result<Self, DeriveError> {
        let mut kinematics = Kinematics::new(model)?;
        let equations = derive_with(model, &mut kinematics, Formulation::Lagrange)?;
        let mut arena = kinematics.arena;
        let equations = equations.with_definitions(&mut arena);
        let standing: Vec<(Expr, Expr)> = model.q_dot().into_iter().map(|rate| (rate, Expr::ZERO)).collect();
        let mut at_rest = Substitution::new(&standing);
        let n = model.coordinates.len();
        let multipliers = equations.unknowns[n..].to_vec();
        let mut rates = Vec::new();
        for (row, forcing) in equations.matrix.iter().zip(&equations.forcing).take(n) {
            let forces: Vec<Expr> = row[n..].iter().zip(&multipliers).map(|(a, l)| arena.mul(*a, *l)).collect();
            let sum = arena.sum(&forces);
            let left = arena.sub(*forcing, sum);
            rates.push(at_rest.apply(&mut arena, left));
        }
        for constraint in &model.motion_constraints {
            rates.push(at_rest.apply(&mut arena, constraint.equation));
        }
        let step = |step: &Definition| Definition { value: at_rest.apply(&mut arena, step.value), ..*step };
        let steps = equations.definitions.iter().map(step).collect();
        let speeds = model.speeds.iter().map(|speed| at_rest.apply(&mut arena, speed.definition)).collect();
        let residuals = Flow {
            arena,
            steps,
            parameters: model.p(),
            states: [model.q(), multipliers.clone()].concat(),
            rates,
            inertia: Vec::new(),
            balances: Vec::new(),
            loops: model.loops.iter().map(|c| c.equation).collect(),
            closed: model.closed.iter().map(|c| c.equation).collect(),
            symmetries: Vec::new(),
            energies: [Expr::ZERO; 3],
            divisors: Vec::new(),
        };
        Ok(Self { residuals, multipliers: multipliers.len(), speeds })
    }
}
