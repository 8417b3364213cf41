//! Poses in which the constraints of a mechanism lose rank, whatever its speeds are.
//!
//! There more may move than elsewhere, no choice of independent speeds determines the motion, and some reactions are free. The
//! surfaces are the common zeros of the minors of A, which are exact. Whether the loops can be closed there is asked in doubles: a pose
//! q with as many vectors λ that Aᵀ λ = 0 as the loss of rank takes, orthonormal.
//! J. M. Selig, *Geometric Fundamentals of Robotics*, 2nd edition (2005), § 4.6.

use crate::algebra::calculus::Gradient;
use crate::algebra::contract::contract;
use crate::algebra::evaluate::Tape;
use crate::algebra::linear::determinant;
use crate::algebra::print::text;
use crate::algebra::range::never_zero;
use crate::algebra::simplify::Simplifier;
use crate::algebra::{Arena, Expr, Node};
use crate::mechanics::bare;
use crate::model::closed_poses::{Poses, reach};
use crate::model::{Model, Tie, Unit};
use nalgebra::DMatrix;

/// Minors up to which all are made, and their rows.
const MOST_MINORS: usize = 20;
const MOST_ROWS: usize = 3;
/// Unknowns up to which poses are looked for.
const MOST_UNKNOWNS: usize = 120;
/// What a row of length 1 adds to the others where it follows from them, to rounding of a double root.
const LOST: f64 = 1e-5;

/// How far from 0 instants are drawn, s.
const SECONDS: f64 = 10.0;
/// What rounding leaves of an equation of which the slopes vanish in the pose.
const FLAT: f64 = 1e-14;

/// Where constraints lose rank.
#[derive(Clone, Debug, PartialEq)]
pub struct RankLoss {
    /// How many constraints are independent elsewhere.
    pub rank: usize,
    /// Formulas that are all zero in exactly these poses; one that is never zero proves that there is none. Nothing where
    /// they are too many.
    pub where_all_zero: Option<Vec<String>>,
    /// Whether it is proved that they lose rank nowhere.
    pub nowhere: bool,
    /// Such a pose, in doubles, at the default values: a value for each coordinate, and last the instant, s, where it depends on that.
    pub pose: Option<Vec<(String, f64)>>,
    /// From how many random places one was looked for.
    pub sought: usize,
}

/// Where the constraints of a model lose rank; nothing if it has none between what is left of its coordinates.
pub fn rank_loss(model: &Model) -> Option<RankLoss> {
    let mut arena = model.arena.clone();
    let columns: Vec<usize> = (0..model.coordinates.len()).filter(|at| Some(*at) != model.time()).collect();
    let stated = model.motion_constraints.iter().filter(|c| c.tie != Tie::Clock).map(|c| c.equation);
    let rates: Vec<Expr> = columns.iter().map(|at| model.coordinates[*at].rate).collect();
    let places: Vec<Expr> = columns.iter().map(|at| model.coordinates[*at].symbol).collect();
    let mut rows: Vec<Vec<Expr>> = stated.map(|e| slopes(&mut arena, e, &rates)).collect();
    let rank = rows.len();
    rows.extend(
        model.closed.iter().map(|c| c.equation).collect::<Vec<_>>().iter().map(|e| slopes(&mut arena, *e, &places)),
    );
    if rank == 0 {
        return None;
    }
    let minors = if rows.len() == rank { minors(&mut arena, &rows) } else { None };
    let mut found = RankLoss { rank, where_all_zero: None, nowhere: false, pose: None, sought: 0 };
    if let Some(minors) = minors {
        found.nowhere = minors.iter().any(|minor| never_zero(&arena, *minor));
        found.where_all_zero = Some(minors.iter().map(|minor| text(&arena, *minor)).collect());
    }
    if !found.nowhere {
        (found.pose, found.sought) = pose(model, &mut arena, &rows, rank, &columns);
    }
    Some(found)
}

fn slopes(arena: &mut Arena, of: Expr, along: &[Expr]) -> Vec<Expr> {
    let mut row = vec![Expr::ZERO; along.len()];
    for &(at, slope) in Gradient::new(along).apply(arena, of).iter() {
        row[at] = slope;
    }
    row
}

/// The minors of all rows that are not zero, without factors that never are, each once; nothing if they are too many.
fn minors(arena: &mut Arena, rows: &[Vec<Expr>]) -> Option<Vec<Expr>> {
    let (m, n) = (rows.len(), rows[0].len());
    let choices = (0..m).fold(1, |count, k| count * (n - k) / (k + 1));
    if m > MOST_ROWS || choices > MOST_MINORS {
        return None;
    }
    let mut simplifier = Simplifier::default();
    let mut found: Vec<Expr> = Vec::new();
    let mut columns: Vec<usize> = (0..m).collect();
    loop {
        let minor: Vec<Vec<Expr>> = rows.iter().map(|row| columns.iter().map(|at| row[*at]).collect()).collect();
        let value = determinant(arena, &mut simplifier, &minor);
        if value != Expr::ZERO {
            let value = surface(arena, value);
            if !found.contains(&value) {
                found.push(value);
            }
        }
        // The next choice of columns, in order.
        let Some(at) = (0..m).rev().find(|at| columns[*at] < n - m + at) else { return Some(found) };
        columns[at] += 1;
        for later in at + 1..m {
            columns[later] = columns[later - 1] + 1;
        }
    }
}

/// What is zero where a minor is: angles taken together, without powers and factors that are zero nowhere.
fn surface(arena: &mut Arena, minor: Expr) -> Expr {
    let minor = contract(arena, minor);
    let minor = bare(arena, minor);
    let factors = match arena.node(minor) {
        Node::Product(factors) => factors.clone(),
        _ => return minor,
    };
    let left: Vec<Expr> = factors.iter().map(|(base, _)| *base).filter(|base| !never_zero(arena, *base)).collect();
    arena.product(&left)
}

/// A closed pose in which rows lose rank, and from how many random places it was looked for.
fn pose(
    model: &Model,
    arena: &mut Arena,
    rows: &[Vec<Expr>],
    rank: usize,
    columns: &[usize],
) -> (Option<Vec<(String, f64)>>, usize) {
    let vectors = rows.len() - rank + 1;
    let closed: Vec<Expr> = model.loops.iter().chain(&model.closed).map(|c| c.equation).collect();
    // What is driven may be singular at one instant and not at another.
    let time = model.time().filter(|at| {
        let symbol = model.coordinates[*at].symbol;
        rows.iter().flatten().chain(&closed).any(|e| arena.mentions(*e, symbol))
    });
    let places: Vec<usize> = columns.iter().copied().chain(time).collect();
    let known: Vec<(Expr, f64)> =
        model.parameters.iter().filter_map(|p| Some((p.symbol, p.value.as_ref()?.to_f64()))).collect();
    let lengths = model.parameters.iter().filter(|p| p.unit == Unit::new(1, 0, 0));
    let lengths = lengths.filter_map(|p| Some(p.value.as_ref()?.to_f64()));
    let mut unknowns: Vec<Expr> = places.iter().map(|at| model.coordinates[*at].symbol).collect();
    let mut reach = reach(columns.iter().map(|at| model.coordinates[*at].unit.is_plain()), lengths);
    reach.extend(time.map(|_| SECONDS));
    let mut equations = closed;
    let multipliers: Vec<Vec<Expr>> =
        (0..vectors).map(|k| (0..rows.len()).map(|at| arena.symbol(&format!("λ#{k}#{at}"))).collect()).collect();
    for (k, lambda) in multipliers.iter().enumerate() {
        for column in 0..columns.len() {
            let terms: Vec<Expr> = rows.iter().zip(lambda).map(|(row, l)| arena.mul(row[column], *l)).collect();
            equations.push(arena.sum(&terms));
        }
        for (other, wanted) in multipliers[..=k].iter().zip((0..=k).map(|at| at == k)) {
            let mut terms: Vec<Expr> = lambda.iter().zip(other).map(|(a, b)| arena.mul(*a, *b)).collect();
            terms.extend(wanted.then_some(Expr::MINUS_ONE));
            equations.push(arena.sum(&terms));
        }
    }
    unknowns.extend(multipliers.iter().flatten());
    reach.resize(unknowns.len(), 1.0);
    if unknowns.len() > MOST_UNKNOWNS {
        return (None, 0);
    }
    let poses = Poses { known: &known, coordinates: &unknowns, reach: &reach, loops: &equations, flat: FLAT };
    let Some(found) = poses.some(arena, usize::MAX) else { return (None, 0) };
    let loses = |q: &&Vec<f64>| loses(arena, &known, &unknowns[..places.len()], rows, rank, q);
    let named = |q: &Vec<f64>| places.iter().zip(q).map(|(at, x)| (model.coordinates[*at].name.clone(), *x)).collect();
    let singular: Vec<&Vec<f64>> = found.iter().filter(loses).collect();
    // What comes later before what has been: most motions start at 0.
    let later = singular.iter().find(|q| time.is_none() || q[columns.len()] >= 0.0);
    (later.or(singular.first()).map(|q| named(q)), poses.tries())
}

/// Whether fewer rows than elsewhere are independent in a pose, as far as doubles tell.
fn loses(arena: &Arena, known: &[(Expr, f64)], places: &[Expr], rows: &[Vec<Expr>], rank: usize, q: &[f64]) -> bool {
    let inputs: Vec<Expr> = known.iter().map(|(symbol, _)| *symbol).chain(places.iter().copied()).collect();
    let Ok(tape) = Tape::new(arena, &inputs, &rows.concat()) else { return false };
    let at: Vec<f64> = known.iter().map(|(_, value)| *value).chain(q[..places.len()].iter().copied()).collect();
    let mut matrix = DMatrix::from_row_slice(rows.len(), rows[0].len(), &tape.evaluate(&at));
    for mut row in matrix.row_iter_mut() {
        let size = row.norm();
        // A row that is zero itself is lost as it stands.
        if size > LOST {
            row /= size;
        }
    }
    let mut values: Vec<f64> = matrix.singular_values().iter().copied().collect();
    values.sort_by(|a, b| b.total_cmp(a));
    values.get(rank - 1).is_none_or(|value| *value < LOST)
}
