//! Constraints whose derivatives vanish in every closed pose.
//!
//! Two pins hold a rod of length a at the points 0 and (a, 0). The equation a cos q − a = 0 of the second pin has no
//! slope at q = 0, the only closed pose, and the equation a sin q = 0 of this pin alone locks the rod. A row without a
//! slope has no direction: scaled to length 1, it would be rounding errors. Such a row is zero here, so that it
//! depends on no other row.
//!
//! An equation without a slope is redundant only if it holds in all poses that the other equations permit. A
//! linkage that is stretched to its full length has an equation without a slope as well, but there the equation
//! restricts motions of finite size. So the other equations are followed along walks, on which the slope must remain
//! zero.

use super::closed_pose_search::{ClosedPoseSearch, FLAT, RandomNumbers};
use crate::algebra::value::tape::Tape;
use crate::algebra::{Arena, Expr};
use nalgebra::DMatrix;
use tripos_linear::singular_values;

/// Number of random poses in which the rows are measured.
const SAMPLES: usize = 8;
/// Norm of a row in a pose below which the row counts as zero there, relative to the row's largest norm at random
/// poses.
const VANISHING: f64 = 1e-8;
/// Number of walks along the poses that the other equations permit.
const WALKS: usize = 3;
/// Number of steps of each of these walks.
const STEPS: usize = 4;
/// Sizes of rows of derivatives, by which rows without a slope are found.
pub(super) struct RowSizes {
    /// Largest norm of each row at random poses.
    norms: Vec<f64>,
    /// For each row, true if it is never taken as zero, since its equation restricts motions of finite size.
    kept: Vec<bool>,
}

/// Rows of derivatives that are zero in a closed pose, with the loops from which they come.
pub(super) struct VanishingRows<'r> {
    /// Indices of the rows.
    pub rows: &'r [usize],
    /// Index of the loop equation of each constraint; `None` for constraints between velocities.
    pub loops: &'r [Option<usize>],
    /// Coordinates of the closed pose, in SI units.
    pub pose: &'r [f64],
}

impl RowSizes {
    /// Measures the rows that `tape` computes, at random poses. Derivatives that are not finite are left out.
    pub(super) fn new(search: &ClosedPoseSearch<'_>, tape: &Tape, rows: usize) -> Self {
        let mut chance = RandomNumbers::new();
        let mut norms = vec![0.0_f64; rows];
        for _ in 0..SAMPLES {
            let q: Vec<f64> = search.reach.iter().map(|reach| reach * chance.draw()).collect();
            for (norm, most) in row_norms(search, tape, rows, &q).into_iter().zip(&mut norms) {
                if norm.is_finite() {
                    *most = most.max(norm);
                }
            }
        }
        Self { norms, kept: vec![false; rows] }
    }

    /// Scales each row of a matrix to length 1. Rows without a slope become zero.
    pub(super) fn scale(&self, matrix: &mut DMatrix<f64>) {
        for (at, mut row) in matrix.row_iter_mut().enumerate() {
            if !self.kept[at] && row.norm() <= VANISHING * self.norms[at] {
                row.fill(0.0);
            } else {
                row.normalize_mut();
            }
        }
    }

    /// Excludes rows from those that may be taken as zero.
    pub(super) fn keep(&mut self, rows: &[usize]) {
        for at in rows {
            self.kept[*at] = true;
        }
    }

    /// Those of the `vanishing` rows that do not stay zero in all poses that the other loops permit. Their equations
    /// do not follow from the others.
    pub(super) fn rows_with_slopes_nearby(
        &self,
        arena: &mut Arena,
        search: &ClosedPoseSearch<'_>,
        tape: &Tape,
        vanishing: &VanishingRows<'_>,
    ) -> Vec<usize> {
        let all = || vanishing.rows.to_vec();
        let left_out: Vec<usize> = vanishing.rows.iter().filter_map(|row| vanishing.loops[*row]).collect();
        let is_other = |at: &usize| !left_out.contains(at);
        let others: Vec<Expr> = (0..search.loops.len()).filter(is_other).map(|at| search.loops[at]).collect();
        if vanishing.rows.is_empty() || others.is_empty() {
            return all();
        }
        let search = ClosedPoseSearch { loops: &others, flat: FLAT, ..*search };
        let Some(of_loops) = search.tape(arena) else { return all() };
        let (mut chance, mut found) = (RandomNumbers::new(), Vec::new());
        for _ in 0..WALKS {
            search.walk_closed_poses(&of_loops, vanishing.pose.to_vec(), STEPS, &mut chance, &mut found);
        }
        if found.is_empty() && !search.is_locked_at(&of_loops, vanishing.pose) {
            return all();
        }
        let rows = self.norms.len();
        let norms: Vec<Vec<f64>> = found.iter().map(|q| row_norms(&search, tape, rows, q)).collect();
        let stays_zero = |row: &usize| norms.iter().all(|norms| norms[*row] <= VANISHING * self.norms[*row]);
        vanishing.rows.iter().copied().filter(|row| !stays_zero(row)).collect()
    }
}

/// Norm of each row of derivatives in the pose `q`.
fn row_norms(search: &ClosedPoseSearch<'_>, tape: &Tape, rows: usize, q: &[f64]) -> Vec<f64> {
    let values = tape.evaluate(&search.with_known(q));
    let matrix = DMatrix::from_row_slice(rows, q.len(), &values);
    matrix.row_iter().map(|row| row.norm()).collect()
}

impl ClosedPoseSearch<'_> {
    /// True if the loops permit no motion out of the pose `q`, to first order.
    fn is_locked_at(&self, tape: &Tape, q: &[f64]) -> bool {
        let (rows, columns) = (self.loops.len(), q.len());
        let slopes = DMatrix::from_row_slice(rows, columns, &tape.evaluate(&self.with_known(q))[rows..]);
        if rows < columns || !slopes.iter().all(|x| x.is_finite()) {
            return false;
        }
        let values = singular_values(&slopes);
        values.min() > VANISHING * values.max()
    }
}
