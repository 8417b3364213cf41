//! Search for steady motions beside a steady motion (its family). They may exist if its linear system
//! has an eigenvalue of 0.

use super::SteadyProblem;
use super::quotient_system::QuotientSystem;
use super::spectra::wide_matrix::{least_squares, smallest_singular_directions};
use super::steady_newton::Unknowns;
use super::steady_state::SteadyState;
use nalgebra::{DMatrix, DVector};
use tripos_traits::{DoubleDouble, Scalar};

/// Distance at which neighbouring steady motions are searched for, relative to the size of the state or
/// to 1, whichever is larger.
const BESIDE: f64 = 1e-3;
/// Largest residual of the balance that a neighbouring steady motion may have.
const LEFT: f64 = 1e-20;
/// Largest distance by which Newton's method may move back towards the first steady motion, as a
/// fraction of the initial distance from it.
const BACK: f64 = 0.3;

impl SteadyProblem {
    /// Finds the directions in which neighbouring steady motions exist, by Newton's method. The rows are
    /// the kept states of the linear system. The columns are all `count` directions that the matrix A maps
    /// to zero, or none. Each direction, and the sum of all, is tried both ways. For example, `q̈ = −q³`
    /// has no steady motion beside `q = 0`.
    pub(super) fn family_directions(
        &self,
        steady: &SteadyState,
        system: &QuotientSystem,
        count: usize,
    ) -> DMatrix<f64> {
        let directions = smallest_singular_directions(&system.a.rounded(), count);
        let together = directions.column_iter().fold(DVector::zeros(directions.nrows()), |sum, column| sum + column);
        let single = directions.column_iter().map(nalgebra::Matrix::into_owned);
        let ways = single.chain((count > 1).then_some(together)).flat_map(|way| [way.clone(), -way]);
        let is_found =
            steady.is_steady() && ways.into_iter().all(|way| self.has_neighbour(steady, system, &directions, &way));
        if is_found { directions } else { DMatrix::zeros(directions.nrows(), 0) }
    }

    /// True if another steady motion is found in the direction `way` of the kept states.
    fn has_neighbour(
        &self,
        steady: &SteadyState,
        system: &QuotientSystem,
        directions: &DMatrix<f64>,
        way: &DVector<f64>,
    ) -> bool {
        let unknowns = Unknowns { states: self.free_states(), moves: true };
        let Some(lifted) = self.extended_direction(steady, &unknowns.states, system, way) else { return false };
        let beside = |at: usize, by: f64| by.abs() / steady.x[at].hi().abs().max(1.0);
        let most = unknowns.states.iter().zip(&lifted).fold(0.0_f64, |most, (at, by)| most.max(beside(*at, *by)));
        let share = BESIDE / most;
        let mut x = steady.x.clone();
        for (at, by) in unknowns.states.iter().zip(&lifted) {
            x[*at] = x[*at] + DoubleDouble::from_f64(share * by);
        }
        let found = self.find_steady_state(&x, &unknowns);
        let moved = system.kept.iter().map(|at| (found.x[*at] - steady.x[*at]).hi() / share);
        let moved = DVector::from_iterator(system.kept.len(), moved);
        let back = (directions.transpose() * (moved - way)).norm();
        found.is_steady() && found.residual <= LEFT.max(10.0 * steady.residual) && back <= BACK * way.norm()
    }

    /// Extends a direction `way` of the kept states to a direction in the given states of the mechanism.
    /// The derivatives of the residual determine the other components. `None` if a derivative is not
    /// finite.
    fn extended_direction(
        &self,
        steady: &SteadyState,
        states: &[usize],
        system: &QuotientSystem,
        way: &DVector<f64>,
    ) -> Option<Vec<f64>> {
        let slopes = self.residual_slopes_at(steady, states);
        let (rows, columns) = slopes.shape();
        let mut matrix = slopes.resize_vertically(rows + way.len(), 0.0);
        let mut right = DVector::zeros(rows + way.len());
        for (row, at) in system.kept.iter().enumerate() {
            let Some(column) = states.iter().position(|state| state == at) else { continue };
            matrix[(rows + row, column)] = 1.0;
            right[rows + row] = -way[row];
        }
        let found = least_squares(&matrix, &right, 1e-12)?;
        Some(found.iter().take(states.len().min(columns)).copied().collect())
    }
}
