//! Constraints of a mechanism that are independent in its closed poses, in which all its loops are closed, at the
//! default values of its parameters.
//!
//! Loops may restrict more at random poses than in closed poses. Six pins in space prevent all motion of six bars,
//! except for special lengths. In the closed poses of these special bars, one equation follows from the other
//! equations (R. Bricard 1897). So independence is decided in closed poses, in doubles. Values that count as zero are
//! far below the smallest value that does not.

use super::closed_pose_search::{ClosedPoseSearch, INDEPENDENT, POSES_ENOUGH};
use super::vanishing_rows::{RowSizes, VanishingRows};
use crate::algebra::value::tape::Tape;
use crate::algebra::{Arena, Expr};
use crate::model::constraint::AssemblyBranch;
use nalgebra::{DMatrix, DVector};
use std::ops::RangeInclusive;
use tripos_linear::{SingularValues, singular_values};

/// Norm below which a row depends on other rows. It is the norm that the row, of length 1, keeps after the other rows
/// are projected out. A norm between this value and `INDEPENDENT` is undecided.
const DEPENDENT: f64 = 1e-8;

/// Redundant constraint: it follows from other constraints in every closed pose that was found.
pub struct RedundantRow {
    /// Index of the redundant constraint.
    pub at: usize,
    /// Indices of the constraints from which the redundant constraint follows.
    pub of: Vec<usize>,
}

/// Closed poses with the derivatives of constraints and speeds in them, and with the rows that are independent. Each
/// row of derivatives is scaled to length 1.
pub struct ClosedPoses {
    /// Matrix of derivatives in each closed pose. It has a row for each constraint, then for each speed.
    poses: Vec<DMatrix<f64>>,
    /// Indices of the constraint rows that are independent of one another, ascending.
    independent: Vec<usize>,
    /// Redundant rows, each with the rows from which it follows.
    dependent: Vec<RedundantRow>,
    /// Branch to which the closed poses belong, with its rank.
    branch: AssemblyBranch,
}

/// A closed pose, with the rows of derivatives in this pose and their dependence.
struct ClosedPose {
    /// Coordinates of the pose, in SI units.
    q: Vec<f64>,
    /// Rows of derivatives in the pose, scaled to length 1.
    matrix: DMatrix<f64>,
    /// Split of the constraint rows into independent and dependent rows.
    rows: Rows,
}

/// Program of the rows of derivatives, by which closed poses are judged.
struct PoseDerivatives<'t> {
    /// Program that computes the rows: of the constraints, then of the speeds.
    tape: &'t Tape,
    /// Number of rows.
    rows: usize,
    /// Number of constraints.
    constraints: usize,
    /// Sizes of the rows, by which rows without a slope are found.
    sizes: RowSizes,
}

impl PoseDerivatives<'_> {
    /// The closed pose `q` with its rows of derivatives and their dependence; `None` if the dependence is undecided.
    fn judge(&self, poses: &ClosedPoseSearch<'_>, q: Vec<f64>) -> Option<ClosedPose> {
        let values = self.tape.evaluate(&poses.with_known(&q));
        let mut matrix = DMatrix::from_row_slice(self.rows, poses.coordinates.len(), &values);
        self.sizes.scale(&mut matrix);
        let rows = split_closed_pose_rows(&matrix, self.constraints)?;
        Some(ClosedPose { q, matrix, rows })
    }
}

/// Split of rows into independent and dependent rows. A row is dependent if it follows from earlier rows.
struct Rows {
    /// Indices of the independent rows.
    independent: Vec<usize>,
    /// Dependent rows, each with the rows from which it follows.
    dependent: Vec<RedundantRow>,
    /// Smallest norm that an independent row keeps after the rows before it are projected out. Then the largest norm
    /// that a dependent row keeps.
    left: (f64, f64),
}

/// Factor by which another choice of rows must raise the smallest singular value to replace the choice before it.
const BETTER: f64 = 1.5;

impl ClosedPoses {
    /// Finds closed poses and determines the independent rows in them. `rows` are the derivatives of constraints, then
    /// of speeds, as terms in q. `constraints` has an entry for each constraint: the index of the loop equation whose
    /// rate it is, or `None` for a constraint between velocities.
    ///
    /// The poses are on a branch whose number of degrees of freedom is in `declared`, if the search reaches such a
    /// branch. `None` if no pose was found, or if a value is not known.
    pub fn new(
        arena: &mut Arena,
        poses: &ClosedPoseSearch<'_>,
        constraints: &[Option<usize>],
        rows: &[Vec<Expr>],
        declared: RangeInclusive<usize>,
    ) -> Option<Self> {
        let of_loops = poses.tape(arena)?;
        let slopes: Vec<Expr> = rows.iter().flatten().copied().collect();
        let tape = Tape::new(arena, &poses.inputs(), &slopes).ok()?;
        let mut sizes = RowSizes::new(poses, &tape, rows.len());
        let found = poses.closed_poses(&of_loops);
        loop {
            let derivatives = PoseDerivatives { tape: &tape, rows: rows.len(), constraints: constraints.len(), sizes };
            let (closed, split_at) =
                Self::on_declared_branch(poses, &of_loops, &derivatives, found.clone(), &declared)?;
            sizes = derivatives.sizes;
            let zero: Vec<usize> = closed.dependent.iter().filter(|row| row.of.is_empty()).map(|row| row.at).collect();
            let vanishing = VanishingRows { rows: &zero, loops: constraints, pose: &split_at };
            let restricting = sizes.rows_with_slopes_nearby(arena, poses, &tape, &vanishing);
            if restricting.is_empty() {
                return Some(closed);
            }
            sizes.keep(&restricting);
        }
    }

    /// Independent rows in the closed poses `found`, and in further poses if these are not on a branch with as many
    /// degrees of freedom as `declared`. The second value is the pose in which rows were split.
    fn on_declared_branch(
        poses: &ClosedPoseSearch<'_>,
        of_loops: &Tape,
        derivatives: &PoseDerivatives<'_>,
        found: Vec<Vec<f64>>,
        declared: &RangeInclusive<usize>,
    ) -> Option<(Self, Vec<f64>)> {
        let constraints = derivatives.constraints;
        let judged = |q: Vec<f64>| derivatives.judge(poses, q);
        let freedoms = |found: &ClosedPose| poses.coordinates.len() - found.rows.independent.len();
        let is_declared = |found: &ClosedPose| declared.contains(&freedoms(found));
        let mut all: Vec<ClosedPose> = found.into_iter().filter_map(judged).collect();
        // Random poses reach the branch with most degrees of freedom. A mechanism may be meant to be
        // assembled on another branch.
        let is_mixed = |all: &[ClosedPose]| {
            !all.iter().any(is_declared) || all.iter().any(|found| freedoms(found) != freedoms(&all[0]))
        };
        if poses.home.is_none() && is_mixed(&all) {
            let moves = |found: &&ClosedPose| is_declared(found) && (freedoms(found) > 0 || *declared.end() == 0);
            let best = |list: &[ClosedPose]| list.iter().filter(moves).map(|found| found.rows.independent.len()).max();
            let grown: Vec<ClosedPose> =
                poses.close_loops_one_by_one(of_loops).into_iter().filter_map(judged).collect();
            if best(&grown) > best(&all) {
                all.extend(grown);
            }
        }
        let larger = all.iter().max_by_key(|found| freedoms(found)).map(|found| (freedoms(found), found.q.clone()));
        if all.iter().any(is_declared) {
            all.retain(is_declared);
        }
        // A mechanism may be unable to move in another assembly. Poses of that assembly tell nothing about the poses
        // in which it moves.
        let moves = |found: &ClosedPose| found.rows.independent.len() < poses.coordinates.len();
        if all.iter().filter(|found| moves(found)).count() > POSES_ENOUGH {
            all.retain(moves);
        }
        // At singular poses more rows are dependent than elsewhere, so these poses are left out.
        let most = all.iter().map(|found| found.rows.independent.len()).max()?;
        all.retain(|found| found.rows.independent.len() == most);
        let branch = AssemblyBranch {
            pose: all[0].q.clone(),
            poses: all.len(),
            constraints,
            rank: most,
            independent: all.iter().map(|found| found.rows.left.0).fold(f64::INFINITY, f64::min),
            larger: larger.filter(|(freedoms, _)| *freedoms > poses.coordinates.len() - most),
            dependent: (most < constraints).then(|| all.iter().map(|found| found.rows.left.1).fold(0.0, f64::max)),
        };
        // A row without a slope in one pose may have a slope in the others.
        let without_slope = |found: &ClosedPose| found.rows.dependent.iter().filter(|row| row.of.is_empty()).count();
        let split_at = (0..all.len()).min_by_key(|at| without_slope(&all[*at]))?;
        let pose = all[split_at].q.clone();
        let mut closed = Self { poses: Vec::new(), independent: Vec::new(), dependent: Vec::new(), branch };
        for (at, ClosedPose { matrix, rows, .. }) in all.into_iter().enumerate() {
            closed.poses.push(matrix);
            if at == split_at {
                (closed.independent, closed.dependent) = (rows.independent, rows.dependent);
            }
        }
        closed.choose_dependent();
        Some((closed, pose))
    }

    /// Number of closed poses in which independence was decided.
    pub fn count(&self) -> usize {
        self.poses.len()
    }

    /// Branch of closed poses in which independence was decided.
    pub fn branch(&self) -> &AssemblyBranch {
        &self.branch
    }

    /// Redundant constraints: they follow from other constraints in every closed pose that was found.
    pub fn dependent(&self) -> &[RedundantRow] {
        &self.dependent
    }

    /// Smallest singular value of the given rows over all closed poses, a measure of their independence. It is 0 if a
    /// derivative in one of the poses is not finite.
    fn smallest_singular_value(&self, rows: &[usize]) -> f64 {
        smallest_singular_value_above(self.poses.iter(), rows, 0.0)
    }

    /// Chooses the redundant row of each group of dependent rows. It is the row without which the remaining rows have
    /// the largest smallest singular value.
    fn choose_dependent(&mut self) {
        for at in 0..self.dependent.len() {
            let RedundantRow { at: last, of } = &self.dependent[at];
            let (last, of) = (*last, of.clone());
            let mut best = (self.independent.clone(), self.smallest_singular_value(&self.independent), last);
            for out in &of {
                let rest = self.independent.iter().copied().filter(|row| row != out).chain([last]);
                let mut rows: Vec<usize> = rest.collect();
                rows.sort_unstable();
                let least = self.smallest_singular_value(&rows);
                if least > BETTER * best.1 {
                    best = (rows, least, *out);
                }
            }
            let (rows, _, out) = best;
            let mut of: Vec<usize> = of.into_iter().chain([last]).filter(|row| *row != out).collect();
            of.sort_unstable();
            self.independent = rows;
            self.dependent[at] = RedundantRow { at: out, of };
        }
        self.dependent.sort_by_key(|dependent| dependent.at);
    }

    /// Chooses up to `wanted` rows of `among` that are independent of one another and of the rows `kept` in all
    /// closed poses. Rows are chosen one by one: always the row that leaves the largest smallest singular value.
    /// Poses in which no choice is independent decide nothing, if there are others. Returns ascending indices.
    pub fn choose_independent_rows(&self, mut kept: Vec<usize>, mut among: Vec<usize>, wanted: usize) -> Vec<usize> {
        let mut chosen = Vec::new();
        let all: Vec<usize> = kept.iter().chain(&among).copied().collect();
        let decides = |pose: &&DMatrix<f64>| rank_of_rows(pose, &all) >= kept.len() + wanted;
        let mut deciding: Vec<&DMatrix<f64>> = self.poses.iter().filter(decides).collect();
        if deciding.is_empty() {
            deciding = self.poses.iter().collect();
        }
        while chosen.len() < wanted {
            let mut best: Option<(usize, f64)> = None;
            for (place, row) in among.iter().enumerate() {
                let rows: Vec<usize> = kept.iter().copied().chain([*row]).collect();
                let needed = best.map_or(0.0, |(_, most)| BETTER * most);
                let least = smallest_singular_value_above(deciding.iter().copied(), &rows, needed);
                if best.is_none_or(|(_, most)| least > BETTER * most) {
                    best = Some((place, least));
                }
            }
            let Some((place, _)) = best else { break };
            let row = among.remove(place);
            kept.push(row);
            chosen.push(row);
        }
        chosen.sort_unstable();
        chosen
    }

    /// Indices of the coordinates whose rates the given rows do not determine in any closed pose. Empty if they
    /// determine all rates in one pose.
    pub fn undetermined_coordinates(&self, rows: &[usize]) -> Vec<usize> {
        let columns = |pose: &DMatrix<f64>| rank_of_rows(pose, rows) < pose.ncols();
        let Some(pose) = self.poses.first().filter(|_| self.poses.iter().all(columns)) else { return Vec::new() };
        let part = pose.select_rows(rows);
        if !part.iter().all(|x| x.is_finite()) {
            return Vec::new();
        }
        // Unit vectors along which all rows vanish are what remains of the axes of the coordinates.
        let normal = part.tr_mul(&part);
        let SingularValues { values, right, .. } = SingularValues::new(&normal);
        let is_free = |at: &usize| values[*at] <= INDEPENDENT * INDEPENDENT * values.max();
        let free: Vec<usize> = (0..values.len()).filter(is_free).collect();
        (0..pose.ncols()).filter(|column| free.iter().any(|at| right[(*at, *column)].abs() > INDEPENDENT)).collect()
    }

    /// Indices of the constraints that are independent of one another in the closed poses, ascending.
    pub fn independent(&self) -> &[usize] {
        &self.independent
    }
}

/// Smallest singular value of the given rows over closed poses, as far as it is above `needed`. As soon as one pose has
/// a value of at most `needed`, this value is returned. The value is 0 if a derivative is not finite.
fn smallest_singular_value_above<'p>(
    poses: impl Iterator<Item = &'p DMatrix<f64>>,
    rows: &[usize],
    needed: f64,
) -> f64 {
    // With a derivative that is not finite, every choice of rows gets 0, so that no choice is preferred.
    let value = |pose: &DMatrix<f64>| {
        let part = pose.select_rows(rows);
        if part.iter().all(|x| x.is_finite()) { singular_values(&part).min() } else { 0.0 }
    };
    let mut least = f64::INFINITY;
    for pose in poses {
        least = least.min(value(pose));
        if least <= needed {
            break;
        }
    }
    least
}

/// Rank of the given rows of a closed pose; 0 if a derivative is not finite.
fn rank_of_rows(pose: &DMatrix<f64>, rows: &[usize]) -> usize {
    let part = pose.select_rows(rows);
    if !part.iter().all(|x| x.is_finite()) {
        return 0;
    }
    singular_values(&part).iter().filter(|value| **value > DEPENDENT).count()
}

/// Splits the first `count` rows into independent and dependent rows, in order. `None` if a norm is
/// undecided.
fn split_closed_pose_rows(matrix: &DMatrix<f64>, count: usize) -> Option<Rows> {
    let mut basis: Vec<DVector<f64>> = Vec::new();
    let mut rows = Rows { independent: Vec::new(), dependent: Vec::new(), left: (f64::INFINITY, 0.0) };
    for at in 0..count {
        let row: DVector<f64> = matrix.row(at).transpose();
        let mut left = row.clone();
        // Each row is projected twice, to remove the rounding error of the first projection.
        for _ in 0..2 {
            for other in &basis {
                left -= other * other.dot(&left);
            }
        }
        let size = left.norm();
        if size > INDEPENDENT {
            rows.independent.push(at);
            rows.left.0 = rows.left.0.min(size);
            basis.push(left / size);
        } else if size < DEPENDENT {
            rows.dependent
                .push(RedundantRow { at, of: closed_pose_rows_in_combination(matrix, &rows.independent, &row)? });
            rows.left.1 = rows.left.1.max(size);
        } else {
            return None;
        }
    }
    Some(rows)
}

/// Indices of the rows among `kept` whose linear combination is `row`. `None` if the combination cannot be computed.
fn closed_pose_rows_in_combination(matrix: &DMatrix<f64>, kept: &[usize], row: &DVector<f64>) -> Option<Vec<usize>> {
    let rows = matrix.select_rows(kept).transpose();
    if !rows.iter().all(|x| x.is_finite()) {
        return None;
    }
    let shares = SingularValues::new(&rows).solve(row, 1e-12);
    Some(kept.iter().zip(shares.iter()).filter(|(_, share)| share.abs() > INDEPENDENT).map(|(at, _)| *at).collect())
}
