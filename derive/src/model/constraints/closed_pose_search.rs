//! Search for closed poses of a mechanism, in which all its loops are closed, at given values of its parameters.
//!
//! The poses are found by the method of Levenberg and Marquardt. With the square of the residual as damping, it
//! converges quadratically to solutions that are not isolated (N. Yamashita & M. Fukushima 2001). Walks lead from one
//! closed pose to the next.

use crate::algebra::term::calculus::Gradient;
use crate::algebra::value::tape::Tape;
use crate::algebra::{Arena, Expr};
use crate::model::HeldOrientation;
use nalgebra::{DMatrix, DVector};
use std::f64::consts::PI;
use std::ops::Range;
use tripos_linear::{SingularValues, singular_values};

/// Largest number of random starts of a search for closed poses. Mechanisms with many loops have fewer starts.
const TRIES: usize = 40;
/// Number of found closed poses at which a search ends.
pub(super) const POSES_ENOUGH: usize = 6;
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
/// Number of random poses near the assembled pose from which a closed pose is searched.
const TRIES_NEAR_HOME: u32 = 60;
/// Residual up to which a loop counts as closed, relative to the norm of the loop's derivatives.
const CLOSED: f64 = 1e-13;
/// Norm above which a row is independent of other rows. It is the norm that the row, of length 1, keeps after the
/// other rows are projected out.
pub(super) const INDEPENDENT: f64 = 1e-6;
/// Residual up to which a loop counts as closed where its derivatives vanish, relative to the norm of all derivatives.
/// It is the rounding error of an equation in doubles.
pub(super) const FLAT: f64 = 1e-15;

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
    /// Program of terms that are positive in the poses that are meant, from the inputs of the loop program. A pose in
    /// which one is not positive is not taken. `None` if all closed poses are meant.
    pub sides: Option<&'m Tape>,
    /// Coordinates near which the mechanism is assembled; `None` if the model file does not state them.
    pub home: Option<&'m [f64]>,
}

/// Closed poses in which a mechanism is meant to be.
#[derive(Clone, Copy)]
pub struct MeantPoses<'m> {
    /// Pose near which the mechanism is assembled, with its place in the model file; `None` if the file states none.
    pub home: Option<(&'m [f64], &'m Range<usize>)>,
    /// Orientations that joints hold in the poses.
    pub orientations: &'m [HeldOrientation],
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

impl ClosedPoseSearch<'_> {
    /// Symbols of the inputs of the loop program: parameters, then coordinates.
    pub(super) fn inputs(&self) -> Vec<Expr> {
        self.known.iter().map(|(symbol, _)| *symbol).chain(self.coordinates.iter().copied()).collect()
    }

    /// Values of the inputs of the loop program: parameters, then the coordinates `q`.
    pub(super) fn with_known(&self, q: &[f64]) -> Vec<f64> {
        self.known.iter().map(|(_, value)| *value).chain(q.iter().copied()).collect()
    }

    /// Closed poses near the assembled pose if it is stated, else from random poses. A loop without a slope in a closed
    /// pose may remain open there by a rounding error. So the search permits this error if it finds no pose without.
    pub(super) fn closed_poses(&self, tape: &Tape) -> Vec<Vec<f64>> {
        let found = |search: &Self| match search.home {
            Some(home) => search.poses_around(tape, home),
            None => search.find_closed_poses_with_walks(tape),
        };
        let exact = found(self);
        if exact.is_empty() { found(&ClosedPoseSearch { flat: FLAT, ..*self }) } else { exact }
    }

    /// Loop with the largest residual in the pose in which a search from the pose `home` ends, as (index, residual in
    /// the equation's SI unit). `None` if a value is not known or not finite.
    pub(super) fn widest_gap_near(&self, arena: &mut Arena, home: &[f64]) -> Option<(usize, f64)> {
        let tape = self.tape(arena)?;
        let mut pose = home.to_vec();
        self.close_first_loops(&tape, self.loops.len(), &mut pose);
        let values = tape.evaluate(&self.with_known(&pose));
        let gaps = values.into_iter().take(self.loops.len()).enumerate();
        gaps.max_by(|a, b| a.1.abs().total_cmp(&b.1.abs())).filter(|(_, gap)| gap.is_finite())
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
        let mut chance = RandomNumbers(SEED);
        let Some(first) = self.closed_pose_near(tape, home, &mut chance) else { return Vec::new() };
        let mut found = vec![first.clone()];
        for _ in 0..WALKS_FROM_HOME {
            self.walk_closed_poses(tape, first.clone(), WALK_FROM_HOME, &mut chance, &mut found);
        }
        found
    }

    /// Closed pose that the search reaches from the pose `home`. If its frames are turned from their orientations, the
    /// closed pose that it reaches from a random pose near `home`. `None` if there is none.
    fn closed_pose_near(&self, tape: &Tape, home: &[f64], chance: &mut RandomNumbers) -> Option<Vec<f64>> {
        let rows = self.loops.len();
        let mut first = home.to_vec();
        if self.close_first_loops(tape, rows, &mut first) {
            return Some(first);
        }
        self.sides?;
        let mut found = (1..=TRIES_NEAR_HOME).find_map(|at| {
            let part = f64::from(at) / f64::from(TRIES_NEAR_HOME);
            let beside = home.iter().zip(self.reach).map(|(q, reach)| q + part * reach * chance.draw());
            let mut q: Vec<f64> = beside.collect();
            self.close_first_loops(tape, rows, &mut q).then_some(q)
        })?;
        // Coordinates that need not differ from those of `home` return to them.
        for at in 0..home.len() {
            let mut q = found.clone();
            q[at] = home[at];
            if self.close_first_loops(tape, rows, &mut q) && self.distance(&q, home) < self.distance(&found, home) {
                found = q;
            }
        }
        Some(found)
    }

    /// Distance of two poses, relative to the ranges of the coordinates.
    fn distance(&self, a: &[f64], b: &[f64]) -> f64 {
        a.iter().zip(b).zip(self.reach).map(|((a, b), reach)| ((a - b) / reach).powi(2)).sum::<f64>().sqrt()
    }

    /// Finds closed poses on the branches with the fewest degrees of freedom, by closing one loop after another. A
    /// search that closes all loops at once ends on branches with most degrees of freedom.
    pub(super) fn close_loops_one_by_one(&self, tape: &Tape) -> Vec<Vec<f64>> {
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
    pub(super) fn tape(&self, arena: &mut Arena) -> Option<Tape> {
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
    pub(super) fn walk_closed_poses(
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

    /// True if the closed pose `q` is meant.
    fn is_meant(&self, q: &[f64]) -> bool {
        self.sides.is_none_or(|sides| sides.evaluate(&self.with_known(q)).iter().all(|side| *side > 0.0))
    }

    /// Moves the pose `q` until the first `rows` loops are closed. Returns false if no such pose is reached, or if all
    /// loops are closed in it and it is not meant.
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
                return rows < all || self.is_meant(q);
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

/// Program for [`ClosedPoseSearch::sides`], from the orientations that joints hold. `None` if no joint holds one that
/// changes with the coordinates.
pub fn orientation_program(
    arena: &Arena,
    known: &[(Expr, f64)],
    coordinates: &[Expr],
    orientations: &[HeldOrientation],
) -> Option<Tape> {
    let cosines = orientations.iter().map(|held| held.cosines);
    let cosines: Vec<Expr> = cosines.filter(|e| coordinates.iter().any(|q| arena.mentions(*e, *q))).collect();
    let inputs: Vec<Expr> = known.iter().map(|(symbol, _)| *symbol).chain(coordinates.iter().copied()).collect();
    if cosines.is_empty() { None } else { Tape::new(arena, &inputs, &cosines).ok() }
}

/// Largest absolute values of random coordinates: π rad for angles. For distances, twice the
/// longest of the `lengths`, or 1 m if there is none.
pub fn random_coordinate_ranges(is_angle: impl Iterator<Item = bool>, lengths: impl Iterator<Item = f64>) -> Vec<f64> {
    let longest = lengths.fold(0.0, |most: f64, length| most.max(length.abs()));
    let longest = if longest > 0.0 { 2.0 * longest } else { 1.0 };
    is_angle.map(|is_angle| if is_angle { PI } else { longest }).collect()
}
