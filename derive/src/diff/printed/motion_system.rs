//! Printed or derived equations of motion as a linear system, solved symbolically for rates,
//! accelerations and reactions.

use crate::algebra::form::simplify::Simplifier;
use crate::algebra::solve::linear::{determinant, solve_linear};
use crate::algebra::term::calculus::{Differential, Substitution};
use crate::algebra::{Arena, Expr};
use crate::diff::equations::row_judgement::Row;
use crate::mechanics::{Formulation, Quantities, kinematic_rates, rates_to_speeds};
use crate::model::Model;

/// Equations of motion, printed or derived, as a linear system: matrix · unknowns = right.
#[derive(Clone, Debug)]
pub struct MotionSystem {
    /// Id of the printed system in the publication, or name of the formulation of a derived system.
    pub id: String,
    /// True if the motion variables are the rates q̇; false if they are the generalized speeds u.
    pub in_rates: bool,
    /// Rates q̇ as functions of q and the motion variables, one for each coordinate.
    pub coordinate_rates: Vec<Expr>,
    /// Square matrix of coefficients, with a row for each equation and a column for each unknown.
    pub matrix: Vec<Vec<Expr>>,
    /// Right-hand sides of the linear system, one for each row of the matrix.
    pub right: Vec<Expr>,
}

/// Solution of a system of equations of motion for rates, accelerations and reactions.
#[derive(Clone, Debug)]
pub struct SolvedMotion {
    /// Rates q̇ as functions of q and u, one for each coordinate.
    pub coordinate_rates: Vec<Expr>,
    /// Accelerations u̇ as functions of q and u, one for each generalized speed.
    pub speed_rates: Vec<Expr>,
    /// Difference, in q and u, between the solved q̈ and the q̈ that follows from u̇ by q̇ = W u + w. It is zero unless
    /// the system violates a motion constraint. Empty if q̈ is not among the unknowns, or if there are no motion
    /// constraints.
    pub off_constraints: Vec<Expr>,
    /// Multipliers or reactions as functions of q and u; empty if the unknowns of the system contain none.
    pub reactions: Vec<Expr>,
}

impl MotionSystem {
    /// Determinant of the system's matrix, simplified.
    pub fn determinant(&self, arena: &mut Arena, simplifier: &mut Simplifier) -> Expr {
        determinant(arena, simplifier, &self.matrix)
    }

    /// Solves the system exactly for its accelerations and reactions; `None` if the matrix is
    /// singular everywhere.
    pub fn solve(&self, model: &Model, arena: &mut Arena, simplifier: &mut Simplifier) -> Option<SolvedMotion> {
        let right: Vec<Vec<Expr>> = self.right.iter().map(|e| vec![*e]).collect();
        let (values, _) = solve_linear(arena, simplifier, &self.matrix, &right).ok()?;
        let mut values: Vec<Expr> = values.into_iter().map(|row| row[0]).collect();
        // Multipliers and reactions come after the accelerations.
        let accelerations = if self.in_rates { model.coordinates.len() } else { model.speeds.len() };
        let reactions = values.split_off(accelerations);
        if !self.in_rates {
            let coordinate_rates = self.coordinate_rates.clone();
            return Some(SolvedMotion {
                coordinate_rates,
                speed_rates: values,
                off_constraints: Vec::new(),
                reactions,
            });
        }
        // u̇ = d/dt (J q̇ + d), first with the solved q̈, then with q̇ = W u + w.
        let mut along: Vec<_> = model.coordinates.iter().map(|c| (c.symbol, c.rate)).collect();
        along.extend(model.coordinates.iter().zip(&values).map(|(c, value)| (c.rate, *value)));
        let mut d_dt = Differential::along(&along);
        let mut to_speeds = rates_to_speeds(model);
        let mut speed_rates = Vec::new();
        for speed in &model.speeds {
            let rate = d_dt.apply(arena, speed.definition);
            let rate = to_speeds.apply(arena, rate);
            speed_rates.push(simplifier.simplify(arena, rate));
        }
        let coordinate_rates = model.kinematic_equations.rates.clone();
        let mut off_constraints = Vec::new();
        if !model.motion_constraints.is_empty() {
            let mut d_dt = kinematic_rates(model);
            let rates: Vec<_> = model.speeds.iter().map(|s| s.rate).zip(speed_rates.iter().copied()).collect();
            let mut as_solved = Substitution::new(&rates);
            for (value, rate) in values.iter().zip(&coordinate_rates) {
                let second = d_dt.apply(arena, *rate);
                let (second, value) = (as_solved.apply(arena, second), to_speeds.apply(arena, *value));
                off_constraints.push(arena.sub(value, second));
            }
        }
        Some(SolvedMotion { coordinate_rates, speed_rates, off_constraints, reactions })
    }
}

/// Creates equations of motion from printed rows. Each row ends with its right-hand side.
pub(super) fn motion_of_rows(
    quantities: &Quantities<'_>,
    id: &str,
    formulation: Formulation,
    rows: &[Row],
) -> MotionSystem {
    let model = quantities.model;
    let in_rates = formulation.is_in_rates();
    MotionSystem {
        id: id.to_owned(),
        in_rates,
        coordinate_rates: if in_rates { model.q_dot() } else { model.kinematic_equations.rates.clone() },
        matrix: rows.iter().map(|row| row[..row.len() - 1].to_vec()).collect(),
        right: rows.iter().map(|row| row[row.len() - 1]).collect(),
    }
}

impl SolvedMotion {
    /// Time derivative of `e`, a function of q and u, along the solved motion; simplified.
    pub fn rate(&self, model: &Model, arena: &mut Arena, simplifier: &mut Simplifier, e: Expr) -> Expr {
        let mut along: Vec<_> = model.q().into_iter().zip(self.coordinate_rates.iter().copied()).collect();
        along.extend(model.u().into_iter().zip(self.speed_rates.iter().copied()));
        let rate = Differential::along(&along).apply(arena, e);
        simplifier.simplify(arena, rate)
    }
}
