//! Closed poses of a mechanism, in which all its loops are closed, at the default values of its parameters. Finds the
//! constraints that are independent in closed poses.
//!
//! Loops may restrict more at random poses than in closed poses. Six pins in space prevent all motion of six bars,
//! except for special lengths. In the closed poses of these special bars, one equation follows from the other
//! equations (R. Bricard 1897). So independence is decided in closed poses, in doubles. Values that count as zero are
//! far below the smallest value that does not.
//!
//! The poses are found by the method of Levenberg and Marquardt. With the square of the residual as damping, it
//! converges quadratically to solutions that are not isolated (N. Yamashita & M. Fukushima 2001).

use crate::algebra::Arena;
use crate::algebra::Expr;
use crate::algebra::term::calculus::Gradient;
use crate::algebra::value::tape::Tape;
use crate::model::constraint::AssemblyBranch;
use nalgebra::{DMatrix, DVector};
use std::f64::consts::PI;
use std::ops::RangeInclusive;
use tripos_linear::{SingularValues, singular_values};

/// Largest number of random starts of a search for closed poses. Mechanisms with many loops have fewer starts.
const TRIES: usize = 40;
/// Number of found closed poses at which a search ends.
const POSES_ENOUGH: usize = 6;
/// Largest number of steps of Levenberg and Marquardt's method from one start.
const STEPS: usize = 200;
/// Number of steps of a walk from one closed pose to the next.
const WALK: usize = 60;
/// Number of walks that start at the pose in which a mechanism is assembled.
const WALKS_FROM_HOME: usize = 4;
/// Number of steps of each of these walks: they stay near the pose.
const WALK_FROM_HOME: usize = 5;
/// Distance of successive poses on a walk through closed poses, relative to the ranges of the coordinates.
const STRIDE: f64 = 0.05;
/// Largest number of loops of a mechanism for which the search walks through closed poses.
const MOST_LOOPS_WALKED: usize = 24;
/// Largest number of loops for which poses are also found by closing one loop after another.
const MOST_LOOPS_ONE_BY_ONE: usize = 60;
/// Number of random starts of the search that closes one loop after another.
const STARTS_ONE_BY_ONE: usize = 16;
/// Number of poses, found by closing one loop after another, from which a walk through closed poses starts.
const WALKS_ONE_BY_ONE: usize = 2;
/// Residual up to which a loop counts as closed, relative to the norm of the loop's derivatives.
const CLOSED: f64 = 1e-13;
/// Norm above which a row is independent of other rows. It is the norm that the row, of length 1, keeps after the
/// other rows are projected out.
const INDEPENDENT: f64 = 1e-6;
/// Norm below which a row depends on other rows. It is the norm that the row, of length 1, keeps after the other rows
/// are projected out. A norm between this value and `INDEPENDENT` is undecided.
const DEPENDENT: f64 = 1e-8;

/// Search for closed poses: the loop equations, the parameter values, and the ranges of random coordinates.
pub struct ClosedPoseSearch<'m> {
    /// Symbols of the parameters with their values, in SI units.
    pub known: &'m [(Expr, f64)],
    /// Symbols of the coordinates, which the search changes.
    pub coordinates: &'m [Expr],
    /// Range of each random coordinate, from −reach to reach: π rad for angles; for distances, a length of the
    /// mechanism, m.
    pub reach: &'m [f64],
    /// Left sides of the loop equations, which are zero in closed poses.
    pub loops: &'m [Expr],
    /// Additional residual allowed for each loop equation, relative to the norm of all derivatives. It is 0 except
    /// for searches in which an equation may have no derivatives in a pose.
    pub flat: f64,
    /// Coordinates near which the mechanism is assembled; `None` if the model file does not state them.
    pub home: Option<&'m [f64]>,
}

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

/// Generator of pseudorandom numbers that are equal on every machine (G. Marsaglia 2003, xorshift64*).
pub struct RandomNumbers(u64);

impl RandomNumbers {
    /// Creates a generator with the fixed seed `SEED`, which gives the same numbers in every run.
    pub fn new() -> Self {
        Self(SEED)
    }

    /// Next pseudorandom number, uniform between −1 and 1.
    pub fn draw(&mut self) -> f64 {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        let bits = self.0.wrapping_mul(0x2545_F491_4F6C_DD1D) >> 11;
        #[allow(clippy::cast_precision_loss, reason = "53 bits")]
        let unit = bits as f64 / (1_u64 << 53) as f64;
        2.0 * unit - 1.0
    }
}

/// Seed of the random numbers in searches for closed poses.
const SEED: u64 = 0x9E37_79B9_7F4A_7C15;

/// Factor by which another choice of rows must raise the smallest singular value to replace the choice before it.
const BETTER: f64 = 1.5;

impl ClosedPoses {
    /// Finds closed poses and determines the independent rows in them. `rows` are the derivatives of `constraints`
    /// constraints, then of speeds, as terms in q.
    ///
    /// The poses are on a branch whose number of degrees of freedom is in `declared`, if the search reaches such a
    /// branch. `None` if no pose was found, or if a value is not known.
    pub fn new(
        arena: &mut Arena,
        poses: &ClosedPoseSearch<'_>,
        constraints: usize,
        rows: &[Vec<Expr>],
        declared: RangeInclusive<usize>,
    ) -> Option<Self> {
        let of_loops = poses.tape(arena)?;
        let flat: Vec<Expr> = rows.iter().flatten().copied().collect();
        let tape = Tape::new(arena, &poses.inputs(), &flat).ok()?;
        let judged = |q: Vec<f64>| {
            let values = tape.evaluate(&poses.with_known(&q));
            let mut matrix = DMatrix::from_row_slice(rows.len(), poses.coordinates.len(), &values);
            for mut row in matrix.row_iter_mut() {
                row.normalize_mut();
            }
            let rows = split_closed_pose_rows(&matrix, constraints)?;
            Some(ClosedPose { q, matrix, rows })
        };
        let freedoms = |found: &ClosedPose| poses.coordinates.len() - found.rows.independent.len();
        let is_declared = |found: &ClosedPose| declared.contains(&freedoms(found));
        let found = match poses.home {
            Some(home) => poses.poses_around(&of_loops, home),
            None => poses.find_closed_poses_with_walks(&of_loops),
        };
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
                poses.close_loops_one_by_one(&of_loops).into_iter().filter_map(judged).collect();
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
        let mut closed = Self { poses: Vec::new(), independent: Vec::new(), dependent: Vec::new(), branch };
        for (at, ClosedPose { matrix, rows, .. }) in all.into_iter().enumerate() {
            closed.poses.push(matrix);
            if at == 0 {
                (closed.independent, closed.dependent) = (rows.independent, rows.dependent);
            }
        }
        closed.choose_dependent();
        Some(closed)
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
        self.smallest_singular_value_above(rows, 0.0)
    }

    /// Smallest singular value of the given rows over all closed poses, as far as it is above `needed`. As soon as one
    /// pose has a value of at most `needed`, this value is returned.
    fn smallest_singular_value_above(&self, rows: &[usize], needed: f64) -> f64 {
        // With a derivative that is not finite, every choice of rows gets 0, so that no choice is preferred.
        let value = |pose: &DMatrix<f64>| {
            let part = pose.select_rows(rows);
            if part.iter().all(|x| x.is_finite()) { singular_values(&part).min() } else { 0.0 }
        };
        let mut least = f64::INFINITY;
        for pose in &self.poses {
            least = least.min(value(pose));
            if least <= needed {
                break;
            }
        }
        least
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
    /// Returns ascending indices.
    pub fn choose_independent_rows(&self, mut kept: Vec<usize>, mut among: Vec<usize>, wanted: usize) -> Vec<usize> {
        let mut chosen = Vec::new();
        while chosen.len() < wanted {
            let mut best: Option<(usize, f64)> = None;
            for (place, row) in among.iter().enumerate() {
                let rows: Vec<usize> = kept.iter().copied().chain([*row]).collect();
                let needed = best.map_or(0.0, |(_, most)| BETTER * most);
                let least = self.smallest_singular_value_above(&rows, needed);
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

    /// Indices of the constraints that are independent of one another in the closed poses, ascending.
    pub fn independent(&self) -> &[usize] {
        &self.independent
    }
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

impl ClosedPoseSearch<'_> {
    /// Symbols of the inputs of the loop program: parameters, then coordinates.
    fn inputs(&self) -> Vec<Expr> {
        self.known.iter().map(|(symbol, _)| *symbol).chain(self.coordinates.iter().copied()).collect()
    }

    /// Values of the inputs of the loop program: parameters, then the coordinates `q`.
    fn with_known(&self, q: &[f64]) -> Vec<f64> {
        self.known.iter().map(|(_, value)| *value).chain(q.iter().copied()).collect()
    }

    /// Finds closed poses from random poses, and further closed poses on walks that start at them. Each pose has a
    /// value for every coordinate.
    fn find_closed_poses_with_walks(&self, tape: &Tape) -> Vec<Vec<f64>> {
        let mut chance = RandomNumbers(SEED);
        let mut found = self.seek_closed_poses(tape, &mut chance, self.tries(), POSES_ENOUGH);
        if self.loops.len() <= MOST_LOOPS_WALKED {
            for first in found.clone() {
                self.walk_closed_poses(tape, first, WALK, &mut chance, &mut found);
            }
        }
        found
    }

    /// Closed pose at the pose `home` or near it, and the closed poses of short walks that start there. Empty if no
    /// closed pose is near.
    fn poses_around(&self, tape: &Tape, home: &[f64]) -> Vec<Vec<f64>> {
        let mut first = home.to_vec();
        if !self.close_first_loops(tape, self.loops.len(), &mut first) {
            return Vec::new();
        }
        let mut chance = RandomNumbers(SEED);
        let mut found = vec![first.clone()];
        for _ in 0..WALKS_FROM_HOME {
            self.walk_closed_poses(tape, first.clone(), WALK_FROM_HOME, &mut chance, &mut found);
        }
        found
    }

    /// Finds closed poses on the branches with the fewest degrees of freedom, by closing one loop after another. A
    /// search that closes all loops at once ends on branches with most degrees of freedom.
    fn close_loops_one_by_one(&self, tape: &Tape) -> Vec<Vec<f64>> {
        let mut chance = RandomNumbers(SEED ^ 1);
        let (rows, columns) = (self.loops.len(), self.coordinates.len());
        if rows > MOST_LOOPS_ONE_BY_ONE {
            return Vec::new();
        }
        let mut best: (usize, Vec<Vec<f64>>) = (0, Vec::new());
        for _ in 0..STARTS_ONE_BY_ONE {
            let mut q: Vec<f64> = self.reach.iter().map(|reach| reach * chance.draw()).collect();
            if !(1..=rows).all(|some| self.close_first_loops(tape, some, &mut q)) {
                continue;
            }
            let values = tape.evaluate(&self.with_known(&q));
            let slopes = DMatrix::from_row_slice(rows, columns, &values[rows..]);
            if !slopes.iter().all(|x| x.is_finite()) {
                continue;
            }
            let svd = singular_values(&slopes);
            let rank = svd.iter().filter(|value| **value > INDEPENDENT * svd.max()).count();
            if rank > best.0 {
                best = (rank, Vec::new());
            }
            if rank == best.0 {
                best.1.push(q);
            }
        }
        let mut found = best.1;
        for first in found.iter().take(WALKS_ONE_BY_ONE).cloned().collect::<Vec<_>>() {
            self.walk_closed_poses(tape, first, WALK, &mut chance, &mut found);
        }
        found
    }

    /// Finds at most `most` closed poses from random poses, without walks. `None` if a value is not
    /// known.
    pub fn find_closed_poses(&self, arena: &mut Arena, most: usize) -> Option<Vec<Vec<f64>>> {
        self.seek_closed_poses_from(arena, self.tries(), most)
    }

    /// Finds at most `most` closed poses from at most `tries` random poses, without walks. `None` if a
    /// value is not known.
    pub fn seek_closed_poses_from(&self, arena: &mut Arena, tries: usize, most: usize) -> Option<Vec<Vec<f64>>> {
        let tape = self.tape(arena)?;
        Some(self.seek_closed_poses(&tape, &mut RandomNumbers(SEED), tries, most))
    }

    /// Number of random starts of a search for closed poses: 40 for few loops, down to 3 for many.
    pub fn tries(&self) -> usize {
        (TRIES * 1000 / (self.loops.len().pow(2) + 1)).clamp(3, TRIES)
    }

    /// Program that computes the values of all loop equations, then their derivatives with respect to the
    /// coordinates. `None` if a symbol in the equations is not an input.
    fn tape(&self, arena: &mut Arena) -> Option<Tape> {
        let mut gradient = Gradient::new(self.coordinates);
        let mut all = self.loops.to_vec();
        for equation in self.loops {
            let mut slopes = vec![Expr::ZERO; self.coordinates.len()];
            for &(at, slope) in gradient.apply(arena, *equation).iter() {
                slopes[at] = slope;
            }
            all.extend(slopes);
        }
        Tape::new(arena, &self.inputs(), &all).ok()
    }

    /// Searches for closed poses from at most `tries` random poses, until `most` are found.
    fn seek_closed_poses(&self, tape: &Tape, chance: &mut RandomNumbers, tries: usize, most: usize) -> Vec<Vec<f64>> {
        let mut found = Vec::new();
        for _ in 0..tries {
            let mut q: Vec<f64> = self.reach.iter().map(|reach| reach * chance.draw()).collect();
            if self.close_first_loops(tape, self.loops.len(), &mut q) {
                found.push(q);
                if found.len() == most {
                    break;
                }
            }
        }
        found
    }

    /// Walks through closed poses from the pose `q` by at most `steps` steps, and adds them to `found`. Each step
    /// continues the last direction as far as the loops permit.
    fn walk_closed_poses(
        &self,
        tape: &Tape,
        mut q: Vec<f64>,
        steps: usize,
        chance: &mut RandomNumbers,
        found: &mut Vec<Vec<f64>>,
    ) {
        let (rows, columns) = (self.loops.len(), self.coordinates.len());
        let start: Vec<f64> = self.reach.iter().map(|reach| reach * chance.draw()).collect();
        let mut direction = DVector::from_vec(start);
        for _ in 0..steps {
            let outputs = tape.evaluate(&self.with_known(&q));
            let slopes = DMatrix::from_row_slice(rows, columns, &outputs[rows..]);
            if !slopes.iter().all(|x| x.is_finite()) {
                return;
            }
            let SingularValues { values, right, .. } = SingularValues::new(&slopes);
            let largest = values.max();
            // Keep the part of the last direction that the loops permit.
            let mut onward = direction.clone();
            for (axis, value) in right.row_iter().zip(values.iter()) {
                if *value > INDEPENDENT * largest {
                    onward -= axis.transpose() * axis.transpose().dot(&direction);
                }
            }
            let ahead = onward.iter().zip(self.reach).map(|(x, reach)| (x / reach).powi(2)).sum::<f64>().sqrt();
            if ahead.is_nan() || ahead < 1e-9 {
                return;
            }
            onward *= STRIDE / ahead;
            let mut next: Vec<f64> = q.iter().zip(onward.iter()).map(|(q, step)| q + step).collect();
            if !self.close_first_loops(tape, rows, &mut next) {
                return;
            }
            direction = DVector::from_iterator(columns, next.iter().zip(&q).map(|(next, q)| next - q));
            q.clone_from(&next);
            found.push(next);
        }
    }

    /// Moves the pose `q` until the first `rows` loops are closed. Returns false if no such pose is reached.
    fn close_first_loops(&self, tape: &Tape, rows: usize, q: &mut Vec<f64>) -> bool {
        let (columns, all) = (q.len(), self.loops.len());
        let at = |q: &[f64]| {
            let values = tape.evaluate(&self.with_known(q));
            let open = DVector::from_column_slice(&values[..rows]);
            (open, DMatrix::from_row_slice(rows, columns, &values[all..all + rows * columns]))
        };
        let (mut open, mut slopes) = at(q);
        for _ in 0..STEPS {
            let left = open.norm_squared();
            if !left.is_finite() {
                return false;
            }
            let scale = slopes.norm_squared();
            let flat = self.flat * scale.sqrt();
            let is_closed = |(row, open): (usize, &f64)| open.abs() <= CLOSED * slopes.row(row).norm() + flat;
            if open.iter().enumerate().all(is_closed) {
                return true;
            }
            let mut damping = left.min(scale);
            let mut better = None;
            for _ in 0..20 {
                let normal = slopes.tr_mul(&slopes) + DMatrix::identity(columns, columns) * damping;
                let Some(factor) = normal.cholesky() else {
                    damping = (damping * 10.0).max(1e-16 * scale);
                    continue;
                };
                let step = factor.solve(&slopes.tr_mul(&open));
                let next: Vec<f64> = q.iter().zip(step.iter()).map(|(q, step)| q - step).collect();
                let (next_open, next_slopes) = at(&next);
                if next_open.norm_squared() < left {
                    better = Some((next, next_open, next_slopes));
                    break;
                }
                damping = (damping * 10.0).max(1e-16 * scale);
            }
            let Some(better) = better else { return false };
            (*q, open, slopes) = better;
        }
        false
    }
}

/// Largest absolute values of random coordinates: π rad for angles. For distances, twice the
/// longest of the `lengths`, or 1 m if there is none.
pub fn random_coordinate_ranges(is_angle: impl Iterator<Item = bool>, lengths: impl Iterator<Item = f64>) -> Vec<f64> {
    let longest = lengths.fold(0.0, |most: f64, length| most.max(length.abs()));
    let longest = if longest > 0.0 { 2.0 * longest } else { 1.0 };
    is_angle.map(|is_angle| if is_angle { PI } else { longest }).collect()
}
