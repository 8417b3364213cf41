//! Result of a search for a steady motion, and the test if two results are the same.

use crate::Mechanism;
use std::f64::consts::TAU;
use tripos_traits::DoubleDouble;

/// Difference of two states up to which they count as the same steady motion, relative to their size or
/// to 1, whichever is larger.
const SAME: f64 = 1e-8;
/// Residual of a rate up to which a motion counts as steady, relative to the size of the rate or to 1,
/// whichever is larger.
pub(super) const BALANCED: f64 = 1e-9;

/// Result of a search for a steady motion: a state, the velocities along symmetries, and the residuals.
#[derive(Clone, Debug)]
pub struct SteadyState {
    /// Values of the coordinates, followed by the generalized speeds, to 32 digits.
    pub x: Vec<DoubleDouble>,
    /// Velocity c along each symmetry of the mechanism.
    pub along: Vec<DoubleDouble>,
    /// Largest absolute residual: of the rates, x' − Σ c ζ, and of the independent loops. ζ are the
    /// directions of the symmetries, and c the velocities along them.
    pub residual: f64,
    /// Possible error of the state, relative to its size or to 1. It is the last change of the state if the
    /// changes shrank slowly, as near a state where steady motions meet. Otherwise it is 0.
    pub uncertain: f64,
    /// Indices of the states whose rates are not along the symmetries, each with the residual of the rate.
    pub unbalanced: Vec<(usize, f64)>,
    /// Indices of the coordinates along which the forces are not balanced, each with the force that is
    /// left. Empty if the rates already tell if the state is steady.
    pub forces: Vec<(usize, f64)>,
    /// Indices of the loops that are not closed, each with the residual of the loop.
    pub open: Vec<(usize, f64)>,
    /// Index of the shift of time among the symmetries; `None` if there is no such symmetry. A state that
    /// moves only along it is at rest relative to its drives.
    pub(super) by_time: Option<usize>,
}

impl SteadyState {
    /// True if the state is steady: all rates are along symmetries, forces are balanced, and loops are
    /// closed.
    #[must_use]
    pub fn is_steady(&self) -> bool {
        self.residual.is_finite() && self.unbalanced.is_empty() && self.forces.is_empty() && self.open.is_empty()
    }

    /// Indices of the symmetries along which the state moves, with a velocity other than 0.
    #[must_use]
    pub fn active_symmetries(&self) -> Vec<usize> {
        (0..self.along.len()).filter(|at| self.along[*at].hi().abs() > 0.0).collect()
    }

    /// Velocities of the state along all symmetries except the shift of time.
    #[must_use]
    pub fn velocities(&self) -> Vec<DoubleDouble> {
        let others = self.along.iter().enumerate().filter(|(at, _)| Some(*at) != self.by_time);
        others.map(|(_, c)| *c).collect()
    }

    /// True if the state is at rest: its velocity is 0 along all symmetries except the shift of time.
    #[must_use]
    pub fn is_rest(&self) -> bool {
        self.along.iter().enumerate().all(|(at, c)| Some(at) == self.by_time || c.hi().abs() <= BALANCED)
    }
}

/// True if two states are equal up to a tolerance, with angles compared up to whole turns.
pub(super) fn is_same_steady_state(model: &Mechanism, a: &SteadyState, b: &SteadyState) -> bool {
    (0..a.x.len()).all(|at| is_same_state_value(model, at, a.x[at].hi(), b.x[at].hi()))
}

/// True if two values of the state with the index `at` are equal up to a tolerance. Angles are compared
/// up to whole turns.
pub(super) fn is_same_state_value(model: &Mechanism, at: usize, a: f64, b: f64) -> bool {
    let turns = model.coordinates.get(at).is_some_and(|c| c.unit.is_plain());
    let difference = if turns { (a - b) - TAU * ((a - b) / TAU).round() } else { a - b };
    difference.abs() <= SAME * a.abs().max(1.0)
}
