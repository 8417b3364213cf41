//! Recorder of a run's samples: times, states and work.
//!
//! Invariant: memory does not grow with the number of steps. At most [`MOST`] points of steps are kept, unless their
//! times were asked for. At this limit every second kept point is dropped, and from then on only every second point is
//! taken.

use tripos_traits::Real;

use crate::dense_output::{DenseStep, Interpolant};
use crate::events::corners::replace_slopes;
use crate::methods::run_options::OutputOption;
use crate::rounding::{exactly_equal, smallest_step_beyond_rounding};

/// Largest number of points of steps that a recorder keeps; beyond it every second point is dropped.
pub(crate) const MOST: usize = 200_000;

/// Samples of a run so far, with the rule that decides which further points become samples.
pub(crate) struct Recorder<'a, S> {
    /// Choice of the points of the run that are kept as samples.
    output: &'a OutputOption,
    /// Index of the next wanted output time in the list of [`OutputOption::At`]; unused without such a list.
    next: usize,
    /// Number n such that only every n-th point of the steps is kept as a sample.
    every: u64,
    /// Number of points of steps since the last point that was kept as a sample.
    passed: u64,
    /// Times of the samples recorded so far, s.
    pub(crate) t: Vec<f64>,
    /// States of the samples recorded so far, one for each time.
    pub(crate) y: Vec<Vec<S>>,
    /// Work done up to each sample, J; empty if the equations define no power.
    pub(crate) work: Vec<f64>,
}

/// Function that computes a sample from a fraction of a step and the time there, s. Returns the state and the work up
/// to there, J; `None` for the work if it is not recorded.
type Sampled<'a, S> = dyn FnMut(f64, f64) -> (Vec<S>, Option<f64>) + 'a;

impl<'a, S: Real> Recorder<'a, S> {
    /// Creates a recorder, and records the start (t0, y0) if it is wanted. `work` is the work at the start,
    /// J; `None` if it is not recorded. The times of [`OutputOption::At`] must be in the order of the run.
    pub(crate) fn new(output: &'a OutputOption, t0: f64, y0: &[S], work: Option<f64>) -> Self {
        let mut recorder =
            Self { output, next: 0, every: 1, passed: 0, t: Vec::new(), y: Vec::new(), work: Vec::new() };
        match output {
            OutputOption::Steps { .. } | OutputOption::Ends => recorder.push(t0, y0.to_vec(), work),
            OutputOption::At(times) => {
                while times.get(recorder.next).is_some_and(|t| exactly_equal(*t, t0)) {
                    recorder.push(t0, y0.to_vec(), work);
                    recorder.next += 1;
                }
            }
        }
        recorder
    }

    /// Appends a sample: time t, s, state y, and work, J, or `None` if no work is recorded.
    fn push(&mut self, t: f64, y: Vec<S>, work: Option<f64>) {
        self.t.push(t);
        self.y.push(y);
        self.work.extend(work);
    }

    /// Appends the sample at time `t`, s, which is the fraction `theta` of the current step.
    fn sample(&mut self, t: f64, theta: f64, sampled: &mut Sampled<'_, S>) {
        let (y, work) = sampled(theta, t);
        self.push(t, y, work);
    }

    /// Records the point at the fraction `theta` of a step. Skips the point if points are being left out to bound their
    /// number.
    fn record_point(&mut self, step: &impl Interpolant<Real = S>, theta: f64, sampled: &mut Sampled<'_, S>) {
        self.passed += 1;
        if self.passed < self.every {
            return;
        }
        self.passed = 0;
        self.sample(step.time_at(theta), theta, sampled);
        if self.t.len() > MOST {
            drop_every_second_record(&mut self.t);
            drop_every_second_record(&mut self.y);
            drop_every_second_record(&mut self.work);
            self.every *= 2;
        }
    }

    /// True if samples inside a step over `span`, s, are wanted, so that its dense output is needed.
    pub(crate) fn wants_samples_inside(&self, span: (f64, f64)) -> bool {
        let (t_old, t_new) = span;
        match self.output {
            OutputOption::Ends => false,
            OutputOption::Steps { refine } => *refine > 1,
            // Times up to t_old are kept already, so that only the next time has to be compared with the end of the
            // step.
            OutputOption::At(times) => {
                times.get(self.next).is_some_and(|t| (t_new - t) * (t_new - t_old).signum() > 0.0)
            }
        }
    }

    /// Records the wanted samples of an accepted step up to its fraction `end`, which is 1 unless the run
    /// ends inside the step.
    pub(crate) fn record_step(&mut self, step: &impl Interpolant<Real = S>, end: f64, sampled: &mut Sampled<'_, S>) {
        if end == 0.0 {
            return; // the run ends where the step began
        }
        match self.output {
            OutputOption::Ends => {}
            OutputOption::Steps { refine } => {
                for i in 1..*refine {
                    self.record_point(step, end * (i as f64 / *refine as f64), sampled);
                }
                self.record_point(step, end, sampled);
            }
            OutputOption::At(times) => {
                let (t_old, t_new) = step.times();
                let (h, t_stop) = (t_new - t_old, step.time_at(end));
                let beyond = |t: f64| (t - t_stop) * h.signum() > 0.0;
                while let Some(&t) = times.get(self.next).filter(|t| !beyond(**t)) {
                    let theta = if exactly_equal(t, t_stop) { end } else { ((t - t_old) / h).clamp(0.0, end) };
                    self.sample(t, theta, sampled);
                    self.next += 1;
                }
            }
        }
    }

    /// Replaces the derivatives of the samples at time `t`, s, with those of `y`. The derivatives jump at `t`, and `y`
    /// has the values after the jump.
    pub(crate) fn record_jump_of_derivatives(&mut self, t: f64, y: &[S]) {
        if S::SLOPES == 0 {
            return;
        }
        let is_there = |at: f64| (t - at).abs() < smallest_step_beyond_rounding(t);
        let kept = self.t.iter().zip(&mut self.y).rev().take_while(|(at, _)| is_there(**at));
        kept.for_each(|(_, own)| replace_slopes(own, y));
    }

    /// Records the end of the run, if it is wanted and not recorded yet. `steps` is the number of accepted
    /// steps.
    pub(crate) fn record_end(&mut self, t_end: f64, y_end: &[S], work: Option<f64>, steps: u64) {
        let is_kept = self.t.last().is_some_and(|t| exactly_equal(*t, t_end));
        let is_asked = match self.output {
            OutputOption::Ends => true,
            OutputOption::Steps { .. } => !is_kept,
            OutputOption::At(_) => false,
        };
        if is_asked && steps > 0 {
            self.push(t_end, y_end.to_vec(), work);
        }
    }
}

/// Drops every second entry of a list, beginning with the second; the first entry stays.
fn drop_every_second_record<T>(list: &mut Vec<T>) {
    let mut stays = false;
    list.retain(|_| {
        stays = !stays;
        stays
    });
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Method, Options, integrate};

    #[test]
    fn a_run_of_a_million_steps_keeps_no_more_points_than_are_bounded() {
        let rhs = |_t: f64, _y: &[f64], out: &mut [f64]| {
            out[0] = 1.0;
            Ok(())
        };
        let options = Options { method: Method::Rk4, step: Some(1e-3), step_limit: 2_000_000, ..Options::default() };
        let run = integrate(rhs, (0.0, 1000.0003), &[0.0], &options, &mut []).unwrap();
        assert!(run.steps == 1_000_001 && run.t.len() <= MOST + 1 && run.t.len() > MOST / 2, "{}", run.t.len());
        assert!(run.t[0] == 0.0 && run.t.last() == Some(&run.t_end) && run.y.len() == run.t.len());
        let longest = run.t.windows(2).map(|w| w[1] - w[0]).fold(0.0, f64::max);
        assert!(longest < 0.01, "points are evenly spread: {longest}");
    }
}
