//! Multipliers λ of motion constraints in Lagrange's equations. The time derivative of each constraint is a row.
//!
//! E q̈ − Aᵀ λ = f and A q̈ = −(dA/dt q̇ + da/dt), for the constraints A q̇ + a = 0. The kinetic energy T ignores the
//! constraints. If a constraint were put into T before T is differentiated, the forces that enforce the constraint
//! would be lost.
//!
//! H. Goldstein, C. Poole & J. Safko, *Classical Mechanics*, 3rd edition (2002), §2.4.

use crate::algebra::Expr;
use crate::algebra::term::calculus::{Differential, Gradient};
use crate::mechanics::motion::kinematics::{Kinematics, speeds_to_rates};
use crate::mechanics::rows::{AccelerationEmbedding, RowName, Rows};
use crate::model::Model;

impl Kinematics {
    /// Adds the constraint forces to the rows of all coordinates, and a row for each motion constraint.
    /// Without motion constraints, returns `rows` unchanged.
    pub(in crate::mechanics) fn with_multipliers(&mut self, model: &Model, rows: Rows) -> Rows {
        if model.motion_constraints.is_empty() {
            return rows;
        }
        let (n, m) = (model.coordinates.len(), model.motion_constraints.len());
        let mut result = rows;
        let mut along = Gradient::new(&model.q_dot());
        let rates: Vec<_> = model.coordinates.iter().map(|c| (c.symbol, c.rate)).collect();
        let mut d_dt = Differential::along(&rates);
        for row in &mut result.matrix {
            row.resize(n + m, Expr::ZERO);
        }
        for (at, constraint) in model.motion_constraints.iter().enumerate() {
            let mut row = vec![Expr::ZERO; n + m];
            for &(i, slope) in along.apply(&mut self.arena, constraint.equation).iter() {
                row[i] = slope;
                result.matrix[i][n + at] = self.arena.neg(slope);
            }
            let rest = d_dt.apply(&mut self.arena, constraint.equation);
            result.matrix.push(row);
            result.forcing.push(self.arena.neg(rest));
            result.names.push(RowName::Constraint(at));
        }
        let embedding = self.embedding_that_cancels_multipliers(model);
        result.projection = (0..model.speeds.len())
            .map(|s| embedding.matrix.iter().map(|row| row[s]).chain((0..m).map(|_| Expr::ZERO)).collect())
            .collect();
        result.embedding = Some(embedding);
        // Both fields are dropped: the forces required along q̇ would include constraint forces, and Gauss's function
        // ignores constraints.
        result.required = None;
        result.gauss = None;
        result
    }

    /// Map q̈ = W u̇ + x from the free accelerations u̇ to q̈, from q̇ = W u + w. It cancels the multipliers.
    fn embedding_that_cancels_multipliers(&mut self, model: &Model) -> AccelerationEmbedding {
        let rates = &model.kinematic_equations.rates;
        let flow: Vec<_> = model.q().into_iter().zip(rates.iter().copied()).collect();
        let (mut d_dt, mut along) = (Differential::along(&flow), Gradient::new(&model.u()));
        let mut to_rates = speeds_to_rates(model);
        let (mut matrix, mut rest) = (Vec::new(), Vec::new());
        for rate in rates {
            let mut row = vec![Expr::ZERO; model.speeds.len()];
            for &(at, slope) in along.apply(&mut self.arena, *rate).iter() {
                row[at] = slope;
            }
            matrix.push(row);
            let x = d_dt.apply(&mut self.arena, *rate);
            let x = to_rates.apply(&mut self.arena, x);
            rest.push(self.simplifier.simplify(&mut self.arena, x));
        }
        AccelerationEmbedding { free: model.speeds.iter().map(|s| s.rate).collect(), matrix, rest }
    }
}
