//! Search for the nearest state (q, q̇) on the constraints, in the metric of the mass matrix.
//!
//! Newton's method finds the state with the slopes at the given state; they are computed again if convergence is slow.
//! A stage of a step is so near the constraints that few evaluations are enough. The result depends only on the given
//! state, and smoothly. The working space is allocated once for many states.

use tripos_traits::System;

use super::correction::Correction;
use crate::right_hand_side;

/// Largest number of Newton iterations in a search for a state on the constraints.
const ITERATIONS: usize = 12;
/// Correction that counts as zero, in units in the last place of the largest component.
const ROUNDING: f64 = 4.0;
/// Ratio of a Newton correction to the one before it, above which new slopes are computed.
const SLOW: f64 = 0.1;

/// Solver for the nearest state (q, q̇) on the constraints, with its working space.
#[derive(Clone)]
pub(crate) struct NearestState {
    /// Solver for the correction of a state by the drift of its constraints.
    correction: Correction,
    /// Index of the coordinate that is the time, which is never moved; `None` if no coordinate is.
    clock: Option<usize>,
    /// Values of the constraints at the state `placed`.
    values: Vec<f64>,
    /// Slopes of the constraints by the components of the state, row by row.
    slopes: Vec<f64>,
    /// Working space for the matrix of the linear system of accelerations and multipliers.
    matrix: Vec<f64>,
    /// Mass matrix at the state `placed`, row by row, in whose metric the distance is measured.
    inertia: Vec<f64>,
    /// State that is being moved onto the constraints.
    placed: Vec<f64>,
}

impl NearestState {
    /// Creates the solver for a system in all rates with multipliers. `clock` is the index of the
    /// coordinate that is the time; `None` if no coordinate is.
    pub(crate) fn new(system: &dyn System<f64>, clock: Option<usize>) -> Self {
        let (count, state) = (system.constraint_count(), system.lengths().state());
        Self {
            correction: Correction::new(),
            clock,
            values: vec![0.0; count],
            slopes: vec![0.0; count * state],
            matrix: Vec::new(),
            inertia: Vec::new(),
            placed: vec![0.0; state],
        }
    }

    /// Returns the state on the constraints that is nearest to y = (q, q̇); y itself if the search fails.
    pub(crate) fn nearest_state(&mut self, system: &dyn System<f64>, parameters: &[f64], y: &[f64]) -> &[f64] {
        self.placed.copy_from_slice(y);
        if self.move_onto_constraints(system, parameters).is_none() {
            self.placed.copy_from_slice(y);
        }
        &self.placed
    }

    /// Moves the state `placed` onto the constraints by Newton's method. `None` if a value on the way is
    /// not finite, or if the mass matrix is not positive definite.
    fn move_onto_constraints(&mut self, system: &dyn System<f64>, parameters: &[f64]) -> Option<()> {
        let n = system.lengths().coordinates;
        let (mut last, mut is_slow) = (f64::INFINITY, true);
        for _ in 0..ITERATIONS {
            if is_slow {
                self.evaluate_constraints(system, parameters)?;
            } else {
                let (q, v) = self.placed.split_at(n);
                system.constraints(parameters, q, v, &mut self.values);
            }
            let step = self.correction.correction_of_drift(&self.values, n);
            let most = step.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
            let size = self.placed.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
            if !step.iter().all(|x| x.is_finite()) {
                return None;
            }
            for (x, step) in self.placed.iter_mut().zip(step) {
                *x -= step;
            }
            // The ratio of successive corrections is expected to stay the same.
            let ratio = if last.is_finite() { most / last } else { 1.0 };
            if most * ratio <= ROUNDING * f64::EPSILON * size {
                break;
            }
            (is_slow, last) = (last.is_finite() && ratio > SLOW, most);
        }
        Some(())
    }

    /// Computes the constraints, their slopes and the mass matrix at the state `placed`, and prepares corrections
    /// there. `None` if a number is not finite, or if the mass matrix is not positive definite.
    fn evaluate_constraints(&mut self, system: &dyn System<f64>, parameters: &[f64]) -> Option<()> {
        let Self { correction, clock, values, slopes, matrix, inertia, placed } = self;
        right_hand_side::system_constraints(system, parameters, placed, values, slopes);
        right_hand_side::system_inertia(system, parameters, placed, matrix, inertia);
        let is_known = values.iter().chain(&*slopes).chain(&*inertia).all(|x| x.is_finite());
        (is_known && correction.set(inertia, slopes, placed.len() / 2, *clock)).then_some(())
    }
}
