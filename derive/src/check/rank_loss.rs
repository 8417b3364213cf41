//! Rank loss: poses in which the constraints of a mechanism lose rank, whatever generalized speeds
//! are chosen.
//!
//! In such a pose the mechanism may have more freedom than elsewhere, no choice of independent
//! speeds determines the motion, and some reactions are undetermined. All rows of the constraint
//! matrix are used, also redundant rows, since it is arbitrary which row counts as redundant. The
//! poses are the common zeros of minors, which are exact ([`minors`]).
//!
//! Each result has a proof, or an example pose in which the rank was computed ([`singular_pose`]).
//! The search for a pose q solves Aᵀ λ = 0 with as many orthonormal vectors λ as the loss of rank
//! requires. Source: J. M. Selig, *Geometric Fundamentals of Robotics*, 2nd edition (2005), § 4.6.

mod minors;
mod singular_pose;

use crate::algebra::term::calculus::Gradient;
use crate::algebra::text::print::print_text;
use crate::algebra::{Arena, Expr};
use crate::model::{Model, MotionConstraintKind};
use minors::{Matrix, common_zeros_of_minors};
use singular_pose::SingularPoseSearch;

/// Poses where the constraints of a model lose rank: formulas for them, a proof that there are
/// none, or an example.
#[derive(Clone, Debug, PartialEq)]
pub struct RankLoss {
    /// Rank of the constraints in all poses without rank loss: the number of independent constraints.
    pub rank: usize,
    /// Formulas that are all zero exactly in the poses where rank is lost. Empty if it is proved that
    /// no such pose exists; `None` if there are too many formulas.
    pub where_all_zero: Option<Vec<String>>,
    /// True if it is proved that the constraints never lose rank.
    pub nowhere: bool,
    /// Proof in words that rank is never lost, one for each block of constraints. A block shares no
    /// coordinate with other blocks.
    pub proof: Vec<String>,
    /// Formulas in parameters that the results assume to be nonzero, because they are nonzero at
    /// the default values.
    pub taken: Vec<String>,
    /// Example of a pose where rank is lost, as (coordinate, value in SI units) at the default values.
    /// A last entry is the instant, s, if the pose depends on time. `None` if none was found.
    pub pose: Option<Vec<(String, f64)>>,
    /// Number of independent constraints in the example pose; `None` if there is no example.
    pub rank_there: Option<usize>,
    /// Number of random poses from which the search for an example pose started.
    pub sought: usize,
}

/// Finds the poses where the constraints of a model lose rank. `None` if there is no constraint
/// between the model's coordinates.
pub fn rank_loss(model: &Model) -> Option<RankLoss> {
    let mut arena = model.arena.clone();
    let columns: Vec<usize> = (0..model.coordinates.len()).filter(|at| Some(*at) != model.time()).collect();
    let (rows, rank) = rank_loss_matrix(model, &mut arena, &columns);
    if rank == 0 {
        return None;
    }
    let known: Vec<(Expr, f64)> =
        model.parameters.iter().filter_map(|p| Some((p.symbol, p.value.as_ref()?.to_f64()))).collect();
    let closed: Vec<Expr> = model.loops.iter().chain(&model.closed).map(|c| c.equation).collect();
    let mut found = RankLoss {
        rank,
        where_all_zero: None,
        nowhere: false,
        proof: Vec::new(),
        taken: Vec::new(),
        pose: None,
        rank_there: None,
        sought: 0,
    };
    let matrix = Matrix { rows: &rows, rank, known: &known, loops: &closed, places: &model.q() };
    if let Some(surfaces) = common_zeros_of_minors(&mut arena, &matrix) {
        found.nowhere = surfaces.all_zero.is_empty();
        found.where_all_zero = Some(surfaces.all_zero.iter().map(|e| print_text(&arena, *e)).collect());
        found.taken = surfaces.taken.iter().map(|e| print_text(&arena, *e)).collect();
        found.proof = if found.nowhere { surfaces.never } else { Vec::new() };
    }
    if !found.nowhere {
        let rows = SingularPoseSearch { model, rows: &rows, rank, columns: &columns, known: &known, closed: &closed };
        let sought = rows.search_singular_pose(&mut arena);
        (found.pose, found.rank_there) = sought.pose.unzip();
        found.sought = sought.tries;
    }
    Some(found)
}

/// Constraint matrix of a model: partial derivatives of all constraints with respect to the rates
/// of the coordinates `columns`. The rows that are independent in most poses come first, and their
/// number is returned. Redundant rows follow, except those that depend on other rows in every pose.
fn rank_loss_matrix(model: &Model, arena: &mut Arena, columns: &[usize]) -> (Vec<Vec<Expr>>, usize) {
    let rates: Vec<Expr> = columns.iter().map(|at| model.coordinates[*at].rate).collect();
    let places: Vec<Expr> = columns.iter().map(|at| model.coordinates[*at].symbol).collect();
    let stated = model.motion_constraints.iter().filter(|c| c.kind != MotionConstraintKind::Clock).map(|c| c.equation);
    let mut rows: Vec<Vec<Expr>> = stated.map(|e| slopes(arena, e, &rates)).collect();
    let rank = rows.len();
    let left_out = model.repeated.iter().map(|r| r.elsewhere).chain(model.dependent.iter().map(|d| d.equation));
    rows.extend(left_out.flatten().map(|e| slopes(arena, e, &rates)));
    rows.extend(model.closed.iter().map(|c| slopes(arena, c.equation, &places)));
    (rows, rank)
}

/// Row of partial derivatives of a term with respect to the variables `along`.
fn slopes(arena: &mut Arena, of: Expr, along: &[Expr]) -> Vec<Expr> {
    let mut row = vec![Expr::ZERO; along.len()];
    for &(at, slope) in Gradient::new(along).apply(arena, of).iter() {
        row[at] = slope;
    }
    row
}
