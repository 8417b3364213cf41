//! Linear maps between generalized speeds u and rates q̇, and combinations of rows with matrices of
//! terms.

use crate::algebra::term::calculus::Differential;
use crate::algebra::{Arena, Expr};
use crate::mechanics::{Equations, rates_to_speeds, speeds_to_rates};
use crate::model::Model;

/// Matrix whose entries are terms, as a list of rows.
pub type Matrix = Vec<Vec<Expr>>;

/// Linear maps between speeds and rates: q̇ = W u + w, q̈ = W u̇ + x, and u = J q̇ + d, u̇ = J q̈ +
/// y.
pub struct Maps {
    /// Matrix W = ∂q̇/∂u, with a row for each coordinate and a column for each speed.
    pub w: Matrix,
    /// Matrix J = ∂u/∂q̇, with a row for each speed and a column for each coordinate.
    pub j: Matrix,
    /// Part of q̈ that remains at u̇ = 0, one term in q and u for each coordinate.
    x: Vec<Expr>,
    /// Part of u̇ that remains at q̈ = 0, one term in q and q̇ for each speed.
    y: Vec<Expr>,
}

impl Maps {
    /// Differentiates the kinematic equations and the definitions of the speeds of a model.
    pub fn new(model: &Model, arena: &mut Arena) -> Self {
        let jacobian = |arena: &mut Arena, rows: &[Expr], by: &[Expr]| -> Matrix {
            let partials: Vec<Differential> = by.iter().map(|s| Differential::partial(*s)).collect();
            rows.iter().map(|row| partials.clone().iter_mut().map(|d| d.apply(arena, *row)).collect()).collect()
        };
        let rates = &model.kinematic_equations.rates;
        let definitions: Vec<Expr> = model.speeds.iter().map(|s| s.definition).collect();
        // Time derivatives along the motion at zero accelerations.
        let along_speeds: Vec<_> = model.q().into_iter().zip(rates.iter().copied()).collect();
        let along_rates: Vec<_> = model.coordinates.iter().map(|c| (c.symbol, c.rate)).collect();
        let mut by_speeds = Differential::along(&along_speeds);
        let mut by_rates = Differential::along(&along_rates);
        Self {
            w: jacobian(arena, rates, &model.u()),
            j: jacobian(arena, &definitions, &model.q_dot()),
            x: rates.iter().map(|e| by_speeds.apply(arena, *e)).collect(),
            y: definitions.iter().map(|e| by_rates.apply(arena, *e)).collect(),
        }
    }

    /// Substitutions of rates by speeds, q̇ = W u + w and q̈ = W u̇ + x, as pairs (symbol, value).
    pub fn rates_in_speeds(&self, model: &Model, arena: &mut Arena) -> Vec<(Expr, Expr)> {
        let rates = model.q_dot().into_iter().zip(model.kinematic_equations.rates.iter().copied());
        let mut relations: Vec<(Expr, Expr)> = rates.collect();
        let speed_rates: Vec<Expr> = model.speeds.iter().map(|speed| speed.rate).collect();
        for ((coordinate, row), rest) in model.coordinates.iter().zip(&self.w).zip(&self.x) {
            let moving = dot(arena, row, &speed_rates);
            relations.push((coordinate.second_rate, arena.add(moving, *rest)));
        }
        relations
    }

    /// Substitutions of speeds by rates, u = J q̇ + d and u̇ = J q̈ + y, as pairs (symbol, value).
    pub fn speeds_in_rates(&self, model: &Model, arena: &mut Arena) -> Vec<(Expr, Expr)> {
        let mut relations: Vec<(Expr, Expr)> = model.speeds.iter().map(|s| (s.symbol, s.definition)).collect();
        let second_rates: Vec<Expr> = model.coordinates.iter().map(|c| c.second_rate).collect();
        for ((speed, row), rest) in model.speeds.iter().zip(&self.j).zip(&self.y) {
            let moving = dot(arena, row, &second_rates);
            relations.push((speed.rate, arena.add(moving, *rest)));
        }
        relations
    }

    /// Rewrites equations in u̇ as equations in q̈, by A u̇ = A J q̈ + A y. Further unknowns, such
    /// as reactions, stay. The fields `unknowns` and `variables` keep the symbols of the speeds.
    pub fn to_rates(&self, model: &Model, arena: &mut Arena, equations: &Equations) -> Equations {
        let mut to_rates = speeds_to_rates(model);
        let n = model.speeds.len();
        let mut result = equations.clone();
        for (row, right) in result.matrix.iter_mut().zip(&mut result.forcing) {
            for entry in &mut *row {
                *entry = to_rates.apply(arena, *entry);
            }
            let shift = dot(arena, &row[..n], &self.y);
            let known = to_rates.apply(arena, *right);
            *right = arena.sub(known, shift);
            let moved: Vec<Expr> = (0..n).map(|i| dot(arena, &row[..n], &column(&self.j, i))).collect();
            row[..n].copy_from_slice(&moved);
        }
        result
    }

    /// Rewrites equations in q̈ as equations in u̇, by E q̈ = E W u̇ + E x. Further unknowns, such
    /// as multipliers, stay.
    pub fn to_speeds(&self, model: &Model, arena: &mut Arena, equations: &Equations) -> Equations {
        let mut to_speeds = rates_to_speeds(model);
        let mut result = equations.clone();
        for (row, right) in result.matrix.iter_mut().zip(&mut result.forcing) {
            for entry in &mut *row {
                *entry = to_speeds.apply(arena, *entry);
            }
            let n = self.w.len();
            let shift = dot(arena, &row[..n], &self.x);
            let known = to_speeds.apply(arena, *right);
            *right = arena.sub(known, shift);
            let others = row[n..].to_vec();
            *row = (0..model.speeds.len()).map(|i| dot(arena, &row[..n], &column(&self.w, i))).chain(others).collect();
        }
        result.unknowns.splice(..model.coordinates.len(), model.speeds.iter().map(|s| s.rate));
        result
    }
}

/// Transpose of a matrix: its rows become columns.
pub fn transposed(matrix: &Matrix) -> Matrix {
    (0..matrix.first().map_or(0, Vec::len)).map(|at| column(matrix, at)).collect()
}

/// Entries of a column of a matrix, by the column's index from 0.
pub fn column(matrix: &Matrix, at: usize) -> Vec<Expr> {
    matrix.iter().map(|row| row[at]).collect()
}

/// Scalar product Σ a_i b_i of two lists of terms.
pub fn dot(arena: &mut Arena, a: &[Expr], b: &[Expr]) -> Expr {
    let products: Vec<Expr> = a.iter().zip(b).map(|(a, b)| arena.mul(*a, *b)).collect();
    arena.sum(&products)
}

/// Linear system of combined rows: matrix · unknowns = right.
pub struct CombinedSystem {
    /// Matrix of the system, with a column for each unknown.
    pub matrix: Matrix,
    /// Right-hand side of the system, one entry for each row.
    pub right: Vec<Expr>,
}

/// Combines the rows of a system linearly. Each row of `multipliers` gives a row of the result.
pub fn combine_rows(arena: &mut Arena, multipliers: &Matrix, system: &Equations) -> CombinedSystem {
    let width = system.unknowns.len();
    let matrix =
        multipliers.iter().map(|by| (0..width).map(|c| dot(arena, by, &column(&system.matrix, c))).collect()).collect();
    CombinedSystem { matrix, right: multipliers.iter().map(|by| dot(arena, by, &system.forcing)).collect() }
}
