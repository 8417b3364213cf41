//! Probe of an event function along the dense output of a step, with the rounding error of its values.

use super::root_and_minimum::NotANumber;
use crate::dense_output::DenseStep;

/// Event function along the dense output of a step, as a function of the fraction of the step.
pub(crate) struct Probe<'p> {
    /// Step of the run, with its dense output.
    pub(crate) step: &'p dyn DenseStep,
    /// Event function g(t, y) of time, s, and state.
    pub(crate) function: &'p mut (dyn FnMut(f64, &[f64]) -> f64 + 'p),
    /// Working space for a state at which the event function is evaluated.
    pub(crate) y: &'p mut [f64],
    /// Largest absolute value of each component of the state in the run so far; its rounding errors were
    /// made at that size.
    pub(crate) magnitudes: &'p [f64],
}

impl Probe<'_> {
    /// Value of the event function at the fraction `theta` of the step; it may be NaN.
    pub(crate) fn event_value(&mut self, theta: f64) -> f64 {
        self.step.interpolate(theta, self.y);
        (self.function)(self.step.time_at(theta), self.y)
    }

    /// Rounding error of a time within the step, s: 4 ε of the start or end time, whichever is larger.
    pub(crate) fn rounding_of_time(&self) -> f64 {
        let (start, end) = self.step.times();
        4.0 * f64::EPSILON * start.abs().max(end.abs())
    }

    /// Value of the event function at the fraction `theta` of the step; an error if it is not a number.
    pub(crate) fn value_at(&mut self, theta: f64) -> Result<f64, NotANumber> {
        let g = self.event_value(theta);
        if g.is_nan() { Err(NotANumber { at: theta }) } else { Ok(g) }
    }

    /// Largest |g| that rounding alone can cause at the fraction `theta` of the step, for the event
    /// function g.
    ///
    /// It is 4 times the change of g if each component of the state, and the time, move by ε of their size,
    /// plus 2 ε of `scale`.
    pub(crate) fn rounding(&mut self, theta: f64, scale: f64) -> f64 {
        const ULPS: f64 = 8.0; // moved together, so that the change is not lost in g's own rounding
        let base = self.event_value(theta);
        let t = self.step.time_at(theta);
        let (t_old, t_new) = self.step.times();
        let t_unit = f64::EPSILON * t_old.abs().max(t_new.abs());
        let by_time = ((self.function)(t + ULPS * t_unit, self.y) - base).abs();
        let mut changes = if by_time.is_finite() { by_time } else { 0.0 };
        for (i, magnitude) in self.magnitudes.iter().enumerate() {
            let y_i = self.y[i];
            self.y[i] = y_i + ULPS * f64::EPSILON * magnitude;
            let change = ((self.function)(t, self.y) - base).abs();
            self.y[i] = y_i;
            if change.is_finite() {
                changes += change;
            }
        }
        4.0 * changes / ULPS + 2.0 * f64::EPSILON * scale
    }
}
