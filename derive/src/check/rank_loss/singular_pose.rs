//! Search, in doubles, for a pose in which the constraints of a mechanism lose rank.

use crate::algebra::value::tape::Tape;
use crate::algebra::{Arena, Expr};
use crate::model::constraints::closed_pose_search::{ClosedPoseSearch, orientation_program, random_coordinate_ranges};
use crate::model::{Model, Unit};
use nalgebra::DMatrix;
use tripos_linear::singular_values;

/// Largest number of unknowns (coordinates and components of λ) for which poses are searched.
const MOST_UNKNOWNS: usize = 120;
/// Singular value below which the constraint matrix loses rank, with rows scaled to length 1. It
/// allows for the rounding error of a double root.
const LOST: f64 = 1e-5;

/// Largest absolute value of the random instants of driven mechanisms, s.
const SECONDS: f64 = 10.0;
/// Residual up to which an equation counts as satisfied if its derivatives are zero in the pose. It
/// allows for rounding.
const FLAT: f64 = 1e-14;

/// Result of the search for a pose in which constraints lose rank.
pub struct PoseSearch {
    /// Pose with rank loss, as (list of (coordinate, value), rank in that pose). The instant is the
    /// last entry if the pose depends on time. `None` if no such pose was found.
    pub pose: Option<(Vec<(String, f64)>, usize)>,
    /// Number of random poses from which the search started.
    pub tries: usize,
}

/// Search for poses in which the constraint matrix of a model loses rank. The first `rank` rows are
/// independent, except in single poses.
pub struct SingularPoseSearch<'a> {
    /// Model that the constraints belong to.
    pub model: &'a Model,
    /// Rows of the matrix: the coefficients of the rates in each constraint.
    pub rows: &'a [Vec<Expr>],
    /// Number of leading rows that are independent in most poses.
    pub rank: usize,
    /// Indices of the coordinates to which the columns of the matrix belong.
    pub columns: &'a [usize],
    /// Symbols of the parameters with their default values, in SI units.
    pub known: &'a [(Expr, f64)],
    /// Left sides of the loop equations: terms that are zero in closed poses.
    pub closed: &'a [Expr],
}

impl SingularPoseSearch<'_> {
    /// Searches for a closed pose in which the rows lose rank. The result contains no pose if none
    /// was found or if there are too many unknowns.
    pub fn search_singular_pose(&self, arena: &mut Arena) -> PoseSearch {
        let nothing = PoseSearch { pose: None, tries: 0 };
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
        let mut reach =
            random_coordinate_ranges(columns.iter().map(|at| model.coordinates[*at].unit.is_plain()), lengths);
        reach.extend(time.map(|_| SECONDS));
        let (equations, multipliers) = self.equations(arena);
        unknowns.extend(multipliers);
        reach.resize(unknowns.len(), 1.0);
        if unknowns.len() > MOST_UNKNOWNS {
            return nothing;
        }
        let sides = orientation_program(arena, self.known, &unknowns, &model.orientations);
        let poses = ClosedPoseSearch {
            known: self.known,
            coordinates: &unknowns,
            reach: &reach,
            loops: &equations,
            flat: FLAT,
            sides: sides.as_ref(),
            home: None,
        };
        let Some(found) = poses.find_closed_poses(arena, usize::MAX) else { return nothing };
        let ranks = found.iter().filter_map(|q| {
            let rank = self.rank_in(arena, &unknowns[..places.len()], q).filter(|rank| *rank < self.rank)?;
            Some((q, rank))
        });
        let singular: Vec<(&Vec<f64>, usize)> = ranks.collect();
        // Instants t ≥ 0 are preferred, because most motions start at 0.
        let later = singular.iter().find(|(q, _)| time.is_none() || q[columns.len()] >= 0.0);
        let named = |q: &[f64]| places.iter().zip(q).map(|(at, x)| (model.coordinates[*at].name.clone(), *x)).collect();
        let pose = later.or(singular.first()).map(|(q, rank)| (named(q), *rank));
        PoseSearch { pose, tries: poses.tries() }
    }

    /// Equations of the search, as terms that must be zero. They are the loop equations, and Aᵀ λ =
    /// 0 for as many orthonormal λ as the loss of rank requires. Returns the equations and the
    /// symbols of all components of λ.
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

    /// Numerical rank of the constraint matrix in the pose `q`; `None` if an entry has no finite value.
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
            // A row that is zero within rounding is not scaled, so that it does not count as
            // independent.
            if size > LOST {
                row /= size;
            }
        }
        Some(singular_values(&matrix).iter().filter(|value| **value >= LOST).count())
    }
}
