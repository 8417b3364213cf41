//! Run of a system with one degree of freedom by quadrature. Its output and events are like those of a run by steps.

use tripos_traits::System;

use super::{MotionByQuadrature, NoQuadrature};
use crate::dense_output::{DenseStep, Interpolant};
use crate::driver::event_watch::{EventWatch, Events};
use crate::driver::recorder::Recorder;
use crate::error::SimError;
use crate::events::Event;
use crate::methods::run_options::{self, Options, OutputOption, Poll};
use crate::rounding::exactly_equal;
use crate::solution::{Solution, Stop};

/// Computes the motion from y0 = (q, v) over `span`, s, by quadrature, with a result like that of [`crate::integrate`].
/// `p` are the parameters.
///
/// Of the options, only `output`, `step_limit` and `poll` are used. A step is a panel (a subinterval of the
/// quadrature): panels are counted as steps in the result, and [`OutputOption::Steps`] refines them. Events are located
/// inside them as inside the steps of a method, and may end the run. The state contains all coordinates; see
/// [`MotionByQuadrature::new`] for the requirements on the equations.
///
/// # Errors
/// [`NoQuadrature`] if the arguments are invalid ([`NoQuadrature::Question`]), or if quadrature gives no motion.
pub fn run_by_quadrature(
    system: &dyn System<f64>,
    p: &[f64],
    span: (f64, f64),
    y0: &[f64],
    options: &Options,
    events: &mut [Event<'_>],
) -> Result<Solution, NoQuadrature> {
    run_options::check_span(span, y0)?;
    run_options::check_output(span, &options.output)?;
    let Some((v, q)) = y0.split_last() else {
        return Err(
            SimError::Length { what: "initial state", expected: system.lengths().coordinates + 1, found: 0 }.into()
        );
    };
    let mut motion = MotionByQuadrature::new(system, p, q, *v)?;
    let (t0, t1) = span;
    motion.cover(0.0, t1 - t0)?;
    let mut recorder = Recorder::new(&options.output, t0, y0, None);
    let mut watch = EventWatch::new(Events::Lent(events), y0.len());
    let mut run = QuadratureRun { motion: &motion, t0, y_end: y0.to_vec(), t_end: t0, steps: 0 };
    let stop = match watch.start(t0, y0) {
        Some(stop) => stop,
        None => run.run_quadrature_steps(span, options, &mut watch, &mut recorder),
    };
    let QuadratureRun { y_end, t_end, steps, .. } = run;
    recorder.record_end(t_end, &y_end, None, steps);
    Ok(Solution {
        t: recorder.t,
        y: recorder.y,
        work: Vec::new(),
        t_end,
        y_end,
        work_end: 0.0,
        steps,
        rejected: motion.course.stretches_of_motion().iter().map(|track| u64::from(track.rejected)).sum(),
        evaluations: motion.evaluations(),
        jacobians: 0,
        stop,
        events: watch.records,
        impacts: Vec::new(),
        warnings: Vec::new(),
        projection: None,
    })
}

/// Run by quadrature in progress: its motion, its last state and its count of steps.
struct QuadratureRun<'m> {
    /// Motion of one degree of freedom that quadrature gives.
    motion: &'m MotionByQuadrature<'m>,
    /// Start time of the run, s.
    t0: f64,
    /// State at the last time of the run so far.
    y_end: Vec<f64>,
    /// Last time of the run so far, s.
    t_end: f64,
    /// Number of steps so far.
    steps: u64,
}

impl QuadratureRun<'_> {
    /// Takes steps until there is a reason to stop, and returns this reason.
    fn run_quadrature_steps(
        &mut self,
        span: (f64, f64),
        options: &Options,
        watch: &mut EventWatch<'_, '_>,
        recorder: &mut Recorder<'_, f64>,
    ) -> Stop {
        let forward = span.1 > span.0;
        // Steps are needed only for events, or if the output asks for each step.
        let all = !watch.is_empty() || matches!(options.output, OutputOption::Steps { .. });
        let mut nodes = PanelTimes::new(self.motion, if all { span.1 - span.0 } else { 0.0 });
        let mut step =
            QuadratureStep { motion: self.motion, t0: self.t0, span: (span.0, span.0), ends: Default::default() };
        step.ends.1.clone_from(&self.y_end);
        loop {
            if self.steps >= options.step_limit {
                return Stop::StepLimit { limit: options.step_limit };
            }
            let from = step.span.1;
            let next = if all { nodes.next_panel_time(from - self.t0).map(|t| self.t0 + t) } else { None };
            // A node at or beyond the end of the span ends no step: the last step ends exactly at the end of the span.
            let inside = |t: &f64| if forward { *t > from && *t < span.1 } else { *t < from && *t > span.1 };
            let to = next.filter(inside).unwrap_or(span.1);
            step.advance(to);
            self.steps += 1;
            match watch.watch_step(&step) {
                Ok(None) => recorder.record_step(&step, 1.0, &mut |theta, t| (step.sample(theta, t), None)),
                Ok(Some((theta, stop))) => {
                    recorder.record_step(&step, theta, &mut |theta, t| (step.sample(theta, t), None));
                    self.t_end = step.time_at(theta);
                    self.y_end.copy_from_slice(&step.sample(theta, self.t_end));
                    return stop;
                }
                Err(failure) => return Stop::Failed(failure),
            }
            self.t_end = to;
            self.y_end.copy_from_slice(&step.ends.1);
            if exactly_equal(to, span.1) {
                return Stop::End;
            }
            if Poll::ends(options.poll.as_ref(), to) {
                return Stop::Interrupted;
            }
        }
    }
}

/// Times at which panels (subintervals of the quadrature) meet, in the order of the run.
struct PanelTimes {
    /// Times τ, s, at which panels meet: those within one period of the motion, or all if the motion does not repeat.
    /// They are counted from an origin of the motion, not from the start of the run.
    times: Vec<f64>,
    /// Period of the motion, s; `None` if it does not repeat.
    period: Option<f64>,
    /// Time τ at which the run starts, s.
    lead: f64,
    /// True if the run goes forward in time.
    forward: bool,
    /// Index in `times` of the next time at which panels meet.
    at: usize,
    /// Number of whole periods that are added to `times`.
    turns: f64,
}

impl PanelTimes {
    /// Lists the times at which the panels of a motion meet, in the direction of the signed length `span`, s. The list
    /// is empty if `span` is 0.
    fn new(motion: &MotionByQuadrature<'_>, span: f64) -> Self {
        let forward = span >= 0.0;
        let mut times = if exactly_equal(span, 0.0) { Vec::new() } else { motion.course.nodes() };
        // Panels of both directions of a swing, or of both halves, may end at the same time.
        times.dedup_by(|a, b| (*a - *b).abs() <= 1e-9 * motion.course.period().unwrap_or(0.0));
        if !forward {
            times.reverse();
        }
        let period = motion.period();
        let turns = period.map_or(0.0, |period| (motion.lead / period).round() - if forward { 1.0 } else { -1.0 });
        Self { times, period, lead: motion.lead, forward, at: 0, turns }
    }

    /// Time at which the next two panels after the time `t` meet; `None` if no later panels meet. Both times are in s
    /// from the start of the run.
    fn next_panel_time(&mut self, t: f64) -> Option<f64> {
        loop {
            if self.at >= self.times.len() {
                self.period.filter(|_| !self.times.is_empty())?;
                self.at = 0;
                self.turns += if self.forward { 1.0 } else { -1.0 };
            }
            let node = self.times[self.at] + self.turns * self.period.unwrap_or(0.0) - self.lead;
            if if self.forward { node > t } else { node < t } {
                return Some(node);
            }
            self.at += 1;
        }
    }
}

/// Part of the motion between two times, with the interface of a step of a method.
struct QuadratureStep<'m> {
    /// Motion of one degree of freedom that quadrature gives.
    motion: &'m MotionByQuadrature<'m>,
    /// Start time of the run, s.
    t0: f64,
    /// Start and end time of the step, s.
    span: (f64, f64),
    /// States at the start and at the end of the step.
    ends: (Vec<f64>, Vec<f64>),
}

impl QuadratureStep<'_> {
    /// Replaces the step with the next one, from the end of this step to the time `to`, s.
    fn advance(&mut self, to: f64) {
        let mut old = std::mem::take(&mut self.ends.0);
        old.clone_from(&self.ends.1);
        self.ends.0 = old;
        self.span = (self.span.1, to);
        let mut new = std::mem::take(&mut self.ends.1);
        self.state_at(to, &mut new);
        self.ends.1 = new;
    }

    /// Writes the state at time `t`, s, to `y`; NaN if the motion is not known there.
    fn state_at(&self, t: f64, y: &mut [f64]) {
        if self.motion.state_into(t - self.t0, y).is_err() {
            y.fill(f64::NAN);
        }
    }
}

impl Interpolant for QuadratureStep<'_> {
    type Real = f64;

    fn span(&self) -> (f64, f64) {
        self.span
    }

    fn ends(&self) -> (&[f64], &[f64]) {
        (&self.ends.0, &self.ends.1)
    }

    fn dense_output(&self, theta: f64, mut put: impl FnMut(usize, f64)) {
        let mut y = vec![0.0; self.ends.0.len()];
        self.state_at(self.time_at(theta), &mut y);
        for (i, y) in y.into_iter().enumerate() {
            put(i, y);
        }
    }

    /// Returns `None`: the time is a series in the coordinate, but the coordinate is no polynomial in time.
    fn degree_of_dense_output(&self) -> Option<usize> {
        None
    }

    fn coefficients(&self, _put: impl FnMut(usize, usize, f64)) {}

    /// State at time `t`, s. The fraction `theta` is not used, since it would be less exact in a long step.
    fn sample(&self, _theta: f64, t: f64) -> Vec<f64> {
        let mut y = vec![0.0; self.ends.0.len()];
        self.state_at(t, &mut y);
        y
    }
}
