//! Extrapolation of central differences to step 0 by Ridders' method
//! ([`super::run_differences`] names the source).

use tripos_traits::larger;

/// Relative error of a derivative up to which it is accepted, so that no shorter step is tried.
const EXACT: f64 = 1e-9;
/// Number of successive steps without a smaller error after which no shorter step is tried.
const IDLE_STEPS: usize = 3;
/// Greatest number of extrapolations of each difference of runs.
const MOST_EXTRAPOLATIONS: usize = 4;

/// Central differences of one quantity with ever smaller steps, and their extrapolations to step 0.
#[derive(Clone)]
pub(super) struct RiddersTable {
    /// Last difference, followed by its extrapolations. They use one, two and more of the differences
    /// before it.
    last: Vec<f64>,
    /// Best derivative so far, with its estimated error.
    pub(super) best: (f64, f64),
    /// Number of differences that were added after the best derivative was found.
    idle: usize,
}

impl Default for RiddersTable {
    fn default() -> Self {
        Self { last: Vec::new(), best: (f64::NAN, f64::INFINITY), idle: 0 }
    }
}

impl RiddersTable {
    /// Adds a difference whose step is half the step of the last difference. `rounding` is the error of
    /// the difference that the errors of both runs cause.
    pub(super) fn add(&mut self, difference: f64, rounding: f64) {
        let mut row = vec![difference];
        let mut factor = 1.0;
        self.idle += 1;
        for before in self.last.iter().take(MOST_EXTRAPOLATIONS) {
            factor *= 4.0;
            let shorter = row[row.len() - 1];
            let value = (factor * shorter - before) / (factor - 1.0);
            // Extrapolation enlarges the errors of the runs to at most twice their size.
            let error = 2.0 * rounding + larger((value - shorter).abs(), (value - before).abs());
            if error < self.best.1 {
                self.best = (value, error);
                self.idle = 0;
            }
            row.push(value);
        }
        self.last = row;
    }

    /// True if shorter steps are unlikely to give a better derivative.
    pub(super) fn is_done(&self) -> bool {
        let (value, error) = self.best;
        error <= EXACT * value.abs() || self.idle >= IDLE_STEPS
    }

    /// Removes all differences and the best derivative.
    pub(super) fn clear(&mut self) {
        *self = Self::default();
    }
}
