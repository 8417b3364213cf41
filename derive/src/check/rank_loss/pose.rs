//! Search for poses in which the rows of constraints lose rank, in doubles.

use crate::algebra::value::evaluate::Tape;
use crate::algebra::{Arena, Expr};
use crate::model::constraints::closed_poses::{Poses, reach};
use crate::model::{Model, Unit};
use nalgebra::DMatrix;

/// Largest number of unknowns for which poses are searched.
const MOST_UNKNOWNS: usize = 120;
/// Singular value below which a row is lost, for rows of length 1. It allows for the rounding of a double root.
const LOST: f64 = 1e-5;

/// Largest absolute value of the instants that are drawn, s.
const SECONDS: f64 = 10.0;
/// Residual allowed for rounding in an equation whose slopes vanish in the pose.
const FLAT: f64 = 1e-14;

/// Result of a search for a pose in which rank is lost.
pub struct Sought {
    /// Pose with a value for each coordinate, and last the instant if it matters; then the rank in the pose. `None` if
    /// none was found.
    pub pose: Option<(Vec<(String, f64)>, usize)>,
    /// Number of random places from which the search started.
    pub tries: usize,
}

/// Rows of constraints. The first `rank` rows are independent except in single poses.
pub struct Constraints<'a> {
    pub model: &'a Model,
    pub rows: &'a [Vec<Expr>],
    pub rank: usize,
    /// Indices of the coordinates that have a column.
    pub columns: &'a [usize],
    /// Symbols of parameters with their default values.
    pub known: &'a [(Expr, f64)],
    /// Terms that are zero in closed poses.
    pub closed: &'a [Expr],
}

impl Constraints<'_> {
    /// Searches for a closed pose in which the rows lose rank.
    pub fn sought(&self, arena: &mut Arena) -> Sought {
        let nothing = Sought { pose: None, tries: 0 };
        let Self { model, columns, .. } = *self;
        // A driven mechanism may be singular at one instant and not at another.
        let time = model.time().filter(|at| {
            let symbol = model.coordinates[*at].symbol;
            self.rows.iter().flatten().chain(self.closed).any(|e| arena.mentions(*e, symbol))
        });
        let places: Vec<usize> = columns.iter().copied().chain(time).collect();
        let lengths = model.parameters.iter().filter(|p| p.unit == Unit::new(1, 0, 0));
        let lengths = lengths.filter_map(|p| Some(p.value.as_ref()?.to_f64()));
        let mut unknowns: Vec<Expr> = places.iter().map(|at| model.coordinates[*at].symbol).collect();
        let mut reach = reach(columns.iter().map(|at| model.coordinates[*at].unit.is_plain()), lengths);
        reach.extend(time.map(|_| SECONDS));
        let (equations, multipliers) = self.equations(arena);
        unknowns.extend(multipliers);
        reach.resize(unknowns.len(), 1.0);
        if unknowns.len() > MOST_UNKNOWNS {
            return nothing;
        }
        let poses = Poses { known: self.known, coordinates: &unknowns, reach: &reach, loops: &equations, flat: FLAT };
        let Some(found) = poses.some(arena, usize::MAX) else { return nothing };
        let ranks = found.iter().filter_map(|q| {
            let rank = self.rank_in(arena, &unknowns[..places.len()], q).filter(|rank| *rank < self.rank)?;
            Some((q, rank))
        });
        let singular: Vec<(&Vec<f64>, usize)> = ranks.collect();
        // Instants from 0 on are preferred: most motions start at 0.
        let later = singular.iter().find(|(q, _)| time.is_none() || q[columns.len()] >= 0.0);
        let named = |q: &[f64]| places.iter().zip(q).map(|(at, x)| (model.coordinates[*at].name.clone(), *x)).collect();
        let pose = later.or(singular.first()).map(|(q, rank)| (named(q), *rank));
        Sought { pose, tries: poses.tries() }
    }

    /// Terms that are zero where loops are closed and Aᵀ λ = 0 for as many orthonormal λ as the loss of rank requires.
    /// Also returns the symbols of all components of λ.
    fn equations(&self, arena: &mut Arena) -> (Vec<Expr>, Vec<Expr>) {
        let mut equations = self.closed.to_vec();
        let vectors = self.rows.len() - self.rank + 1;
        let multipliers: Vec<Vec<Expr>> = (0..vectors)
            .map(|k| (0..self.rows.len()).map(|at| arena.symbol(&format!("λ#{k}#{at}"))).collect())
            .collect();
        for (k, lambda) in multipliers.iter().enumerate() {
            for column in 0..self.columns.len() {
                let terms: Vec<Expr> =
                    self.rows.iter().zip(lambda).map(|(row, l)| arena.mul(row[column], *l)).collect();
                equations.push(arena.sum(&terms));
            }
            for (other, wanted) in multipliers[..=k].iter().zip((0..=k).map(|at| at == k)) {
                let mut terms: Vec<Expr> = lambda.iter().zip(other).map(|(a, b)| arena.mul(*a, *b)).collect();
                terms.extend(wanted.then_some(Expr::MINUS_ONE));
                equations.push(arena.sum(&terms));
            }
        }
        (equations, multipliers.concat())
    }

    /// Number of independent rows in a pose, within rounding; `None` if an entry has no value.
    fn rank_in(&self, arena: &Arena, places: &[Expr], q: &[f64]) -> Option<usize> {
        let inputs: Vec<Expr> = self.known.iter().map(|(symbol, _)| *symbol).chain(places.iter().copied()).collect();
        let tape = Tape::new(arena, &inputs, &self.rows.concat()).ok()?;
        let at: Vec<f64> =
            self.known.iter().map(|(_, value)| *value).chain(q[..places.len()].iter().copied()).collect();
        let mut matrix = DMatrix::from_row_slice(self.rows.len(), self.rows[0].len(), &tape.evaluate(&at));
        if matrix.iter().any(|x| !x.is_finite()) {
            return None;
        }
        for mut row in matrix.row_iter_mut() {
            let size = row.norm();
            // A row that is itself zero is lost as it stands.
            if size > LOST {
                row /= size;
            }
        }
        Some(matrix.singular_values().iter().filter(|value| **value >= LOST).count())
    }
}
