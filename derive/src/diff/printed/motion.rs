//! Solution of a printed system for its motion: its accelerations, its determinant, the rates of first integrals.

use crate::algebra::form::simplify::Simplifier;
use crate::algebra::solve::linear::{determinant, solve};
use crate::algebra::term::calculus::{Differential, Substitution};
use crate::algebra::{Arena, Expr};
use crate::mechanics::{motion_rates, rates_to_speeds};
use crate::model::Model;

/// System of equations of motion as printed, or as derived.
#[derive(Clone, Debug)]
pub struct Motion {
    /// Id of the printed system in the publication.
    pub id: String,
    /// True if the variables are q̇ and not u.
    pub in_rates: bool,
    /// Rates q̇ in q and the variables.
    pub coordinate_rates: Vec<Expr>,
    /// Matrix on the left-hand side, one row for each unknown.
    pub matrix: Vec<Vec<Expr>>,
    /// Right-hand sides of the rows.
    pub right: Vec<Expr>,
}

/// Motion that a system of equations gives, solved.
#[derive(Clone, Debug)]
pub struct Solved {
    /// Rates q̇ in q and u.
    pub coordinate_rates: Vec<Expr>,
    /// Rates u̇ in q and u.
    pub speed_rates: Vec<Expr>,
    /// Deviation of q̈ from the q̈ that u̇ gives by q̇ = W u + w, in q and u. It is zero unless the system breaks a
    /// motion constraint. Empty if q̈ is not among the unknowns, or if there are no motion constraints.
    pub off_constraints: Vec<Expr>,
    /// Multipliers or reactions in q and u, if they are among the unknowns; else empty.
    pub reactions: Vec<Expr>,
}

impl Motion {
    /// Determinant of the matrix, simplified.
    pub fn determinant(&self, arena: &mut Arena, simplifier: &mut Simplifier) -> Expr {
        determinant(arena, simplifier, &self.matrix)
    }

    /// Solves exactly for the accelerations; `None` if the matrix is singular everywhere.
    pub fn solve(&self, model: &Model, arena: &mut Arena, simplifier: &mut Simplifier) -> Option<Solved> {
        let right: Vec<Vec<Expr>> = self.right.iter().map(|e| vec![*e]).collect();
        let (values, _) = solve(arena, simplifier, &self.matrix, &right).ok()?;
        let mut values: Vec<Expr> = values.into_iter().map(|row| row[0]).collect();
        // Multipliers and reactions come after the accelerations.
        let accelerations = if self.in_rates { model.coordinates.len() } else { model.speeds.len() };
        let reactions = values.split_off(accelerations);
        if !self.in_rates {
            let coordinate_rates = self.coordinate_rates.clone();
            return Some(Solved { coordinate_rates, speed_rates: values, off_constraints: Vec::new(), reactions });
        }
        // u̇ = d/dt (J q̇ + d) with the solved q̈, then with q̇ = W u + w.
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
            let mut d_dt = motion_rates(model);
            let rates: Vec<_> = model.speeds.iter().map(|s| s.rate).zip(speed_rates.iter().copied()).collect();
            let mut as_solved = Substitution::new(&rates);
            for (value, rate) in values.iter().zip(&coordinate_rates) {
                let second = d_dt.apply(arena, *rate);
                let (second, value) = (as_solved.apply(arena, second), to_speeds.apply(arena, *value));
                off_constraints.push(arena.sub(value, second));
            }
        }
        Some(Solved { coordinate_rates, speed_rates, off_constraints, reactions })
    }
}

impl Solved {
    /// Time derivative of a function of q and u along this motion, simplified.
    pub fn rate(&self, model: &Model, arena: &mut Arena, simplifier: &mut Simplifier, e: Expr) -> Expr {
        let mut along: Vec<_> = model.q().into_iter().zip(self.coordinate_rates.iter().copied()).collect();
        along.extend(model.u().into_iter().zip(self.speed_rates.iter().copied()));
        let rate = Differential::along(&along).apply(arena, e);
        simplifier.simplify(arena, rate)
    }
}
