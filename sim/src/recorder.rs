//! Keeps the samples of a solution that were asked for.

use tripos_traits::Real;

use crate::options::Output;
use crate::stepper::{DenseStep, Interpolant, same};

/// Samples so far.
pub(crate) struct Recorder<'a, S> {
    output: &'a Output,
    next: usize,
    pub(crate) t: Vec<f64>,
    pub(crate) y: Vec<Vec<S>>,
}

impl<'a, S: Real> Recorder<'a, S> {
    /// Starts at (t0, y0). `Output::At` must have been checked to be in order.
    pub(crate) fn new(output: &'a Output, t0: f64, y0: &[S]) -> Self {
        let mut recorder = Self { output, next: 0, t: Vec::new(), y: Vec::new() };
        match output {
            Output::Steps { .. } | Output::Ends => recorder.push(t0, y0.to_vec()),
            Output::At(times) => {
                while times.get(recorder.next).is_some_and(|t| same(*t, t0)) {
                    recorder.push(t0, y0.to_vec());
                    recorder.next += 1;
                }
            }
        }
        recorder
    }

    fn push(&mut self, t: f64, y: Vec<S>) {
        self.t.push(t);
        self.y.push(y);
    }

    fn sample(&mut self, step: &impl Interpolant<Real = S>, t: f64, theta: f64) {
        self.push(t, step.sample(theta, t));
    }

    /// Whether samples inside a step from `t_old` to `t_new` are to be kept.
    pub(crate) fn looks_inside(&self, (t_old, t_new): (f64, f64)) -> bool {
        match self.output {
            Output::Ends => false,
            Output::Steps { refine } => *refine > 1,
            // Times up to t_old are kept already, so that the next one need only come before the end.
            Output::At(times) => times.get(self.next).is_some_and(|t| (t_new - t) * (t_new - t_old).signum() > 0.0),
        }
    }

    /// Records an accepted step up to its fraction `end` (1 unless an event ends the run inside the step).
    pub(crate) fn step(&mut self, step: &impl Interpolant<Real = S>, end: f64) {
        if end == 0.0 {
            return; // the run ends where the step began
        }
        match self.output {
            Output::Ends => {}
            Output::Steps { refine } => {
                for i in 1..*refine {
                    let theta = end * (i as f64 / *refine as f64);
                    self.sample(step, step.time_at(theta), theta);
                }
                self.sample(step, step.time_at(end), end);
            }
            Output::At(times) => {
                let (t_old, t_new) = step.times();
                let (h, t_stop) = (t_new - t_old, step.time_at(end));
                let beyond = |t: f64| (t - t_stop) * h.signum() > 0.0;
                while let Some(&t) = times.get(self.next).filter(|t| !beyond(**t)) {
                    let theta = if same(t, t_stop) { end } else { ((t - t_old) / h).clamp(0.0, end) };
                    self.sample(step, t, theta);
                    self.next += 1;
                }
            }
        }
    }

    /// Adds the end of the run where only the ends are kept.
    pub(crate) fn finish(&mut self, t_end: f64, y_end: &[S], steps: u64) {
        if matches!(self.output, Output::Ends) && steps > 0 {
            self.push(t_end, y_end.to_vec());
        }
    }
}
