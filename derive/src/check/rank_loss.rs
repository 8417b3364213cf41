//! Poses in which the constraints of a mechanism lose rank, for every choice of speeds.
//!
//! In such a pose more may move than elsewhere, no choice of independent speeds determines the motion, and some
//! reactions are free. All rows count, even those that follow from the others in most poses: the choice of the row to
//! leave out is no property of the mechanism. The surfaces are the common zeros of minors, which are exact
//! ([`minors`]). A claim carries its proof, or a pose in which the rank was computed ([`pose`]): q with as many
//! orthonormal vectors λ with Aᵀ λ = 0 as the loss of rank requires. J. M. Selig, *Geometric Fundamentals of Robotics*,
//! 2nd edition (2005), § 4.6.

mod minors;
mod pose;

use crate::algebra::term::calculus::Gradient;
use crate::algebra::text::print::text;
use crate::algebra::{Arena, Expr};
use crate::model::{Model, MotionConstraintKind};
use minors::{Matrix, surfaces};
use pose::Constraints;

/// Poses where the constraints of a model lose rank, with a proof that there are none or an example.
#[derive(Clone, Debug, PartialEq)]
pub struct RankLoss {
    /// Number of independent constraints in all other poses.
    pub rank: usize,
    /// Formulas that are all zero exactly in the poses where rank is lost; empty if it is proved that no such pose
    /// exists. `None` if there are too many formulas.
    pub where_all_zero: Option<Vec<String>>,
    /// True if it is proved that the constraints never lose rank.
    pub nowhere: bool,
    /// Proof that rank is never lost, for each part of the constraints that shares no coordinate with the others.
    pub proof: Vec<String>,
    /// Formulas of parameters that the results assume nonzero, as they are at the default values.
    pub taken: Vec<String>,
    /// An example of a pose where rank is lost, in doubles, at the default values. It has a value for each coordinate,
    /// and last the instant, s, if the pose depends on time.
    pub pose: Option<Vec<(String, f64)>>,
    /// Number of independent constraints in the example pose; `None` without an example.
    pub rank_there: Option<usize>,
    /// Number of random places from which the search for an example started.
    pub sought: usize,
}

/// Finds the poses where the constraints of a model lose rank; `None` if no constraint is left between the remaining
/// coordinates.
pub fn rank_loss(model: &Model) -> Option<RankLoss> {
    let mut arena = model.arena.clone();
    let columns: Vec<usize> = (0..model.coordinates.len()).filter(|at| Some(*at) != model.time()).collect();
    let (rows, rank) = rows(model, &mut arena, &columns);
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
    if let Some(surfaces) = surfaces(&mut arena, &matrix) {
        found.nowhere = surfaces.all_zero.is_empty();
        found.where_all_zero = Some(surfaces.all_zero.iter().map(|e| text(&arena, *e)).collect());
        found.taken = surfaces.taken.iter().map(|e| text(&arena, *e)).collect();
        found.proof = if found.nowhere { surfaces.never } else { Vec::new() };
    }
    if !found.nowhere {
        let rows = Constraints { model, rows: &rows, rank, columns: &columns, known: &known, closed: &closed };
        let sought = rows.sought(&mut arena);
        (found.pose, found.rank_there) = sought.pose.unzip();
        found.sought = sought.tries;
    }
    Some(found)
}

/// Slopes of all constraints along the rates of these coordinates. First come the rows that are independent in most
/// poses, whose number is returned. Then come the others, without those that follow in every pose.
fn rows(model: &Model, arena: &mut Arena, columns: &[usize]) -> (Vec<Vec<Expr>>, usize) {
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

fn slopes(arena: &mut Arena, of: Expr, along: &[Expr]) -> Vec<Expr> {
    let mut row = vec![Expr::ZERO; along.len()];
    for &(at, slope) in Gradient::new(along).apply(arena, of).iter() {
        row[at] = slope;
    }
    row
}
