//! Run by quadrature, with the output and the events of any other run.

use tripos_traits::System;

use super::{NoQuadrature, OneDegree};
use crate::driver::recorder::Recorder;
use crate::driver::watch::{Events, Watch};
use crate::error::SimError;
use crate::events::Event;
use crate::methods::options::{self, Options, Output, Poll};
use crate::solution::{Solution, Stop};
use crate::stepper::{DenseStep, Interpolant, same};

/// Computes the motion from y0 = \[q; v\] over `span`, with the result of [`crate::integrate`].
///
/// Of the options, only `output`, `step_limit` and `poll` are used. Steps are those of the panels: they count in the
/// result, and [`Output::Steps`] refines them. Events are located on them as on steps of a method, and may end the run.
/// The quadratures, like all coordinates, are in the state; see [`OneDegree::new`] for the demands on the equations.
///
/// # Errors
/// [`NoQuadrature`] if the question makes no sense ([`NoQuadrature::Question`]), or if quadrature gives no motion.
pub fn solve(
    system: &dyn System<f64>,
    p: &[f64],
    span: (f64, f64),
    y0: &[f64],
    options: &Options,
    events: &mut [Event<'_>],
) -> Result<Solution, NoQuadrature> {
    options::check_span(span, y0)?;
    options::check_output(span, &options.output)?;
    let Some((v, q)) = y0.split_last() else {
        return Err(
            SimError::Length { what: "initial state", expected: system.lengths().coordinates + 1, found: 0 }.into()
        );
    };
    let mut motion = OneDegree::new(system, p, q, *v)?;
    let (t0, t1) = span;
    motion.cover(0.0, t1 - t0)?;
    let mut recorder = Recorder::new(&options.output, t0, y0, None);
    let mut watch = Watch::new(Events::Lent(events), y0.len());
    let mut run = Run { motion: &motion, t0, y_end: y0.to_vec(), t_end: t0, steps: 0 };
    let stop = match watch.start(t0, y0) {
        Some(stop) => stop,
        None => run.walk(span, options, &mut watch, &mut recorder),
    };
    let Run { y_end, t_end, steps, .. } = run;
    recorder.finish(t_end, &y_end, None, steps);
    Ok(Solution {
        t: recorder.t,
        y: recorder.y,
        work: Vec::new(),
        t_end,
        y_end,
        work_end: 0.0,
        steps,
        rejected: motion.course.tracks().iter().map(|track| u64::from(track.rejected)).sum(),
        evaluations: motion.evaluations(),
        jacobians: 0,
        stop,
        events: watch.records,
        impacts: Vec::new(),
        warnings: Vec::new(),
        projection: None,
    })
}

/// A run by quadrature in progress.
struct Run<'m> {
    motion: &'m OneDegree<'m>,
    t0: f64,
    y_end: Vec<f64>,
    t_end: f64,
    steps: u64,
}

impl Run<'_> {
    fn walk(
        &mut self,
        span: (f64, f64),
        options: &Options,
        watch: &mut Watch<'_, '_>,
        recorder: &mut Recorder<'_, f64>,
    ) -> Stop {
        let forward = span.1 > span.0;
        // The steps matter only if there are events, or if the output asks for each step.
        let all = !watch.is_empty() || matches!(options.output, Output::Steps { .. });
        let mut nodes = Nodes::new(self.motion, if all { span.1 - span.0 } else { 0.0 });
        let mut step = Step { motion: self.motion, t0: self.t0, span: (span.0, span.0), ends: Default::default() };
        step.ends.1.clone_from(&self.y_end);
        loop {
            if self.steps >= options.step_limit {
                return Stop::StepLimit { limit: options.step_limit };
            }
            let from = step.span.1;
            let next = if all { nodes.next_beyond(from - self.t0).map(|t| self.t0 + t) } else { None };
            // A rest of the span that is only rounding, after a node next to its end, is no step.
            let inside = |t: &f64| if forward { *t > from && *t < span.1 } else { *t < from && *t > span.1 };
            let to = next.filter(inside).unwrap_or(span.1);
            step.advance(to);
            self.steps += 1;
            match watch.look(&step) {
                Ok(None) => recorder.step(&step, 1.0, &mut |theta, t| (step.sample(theta, t), None)),
                Ok(Some((theta, stop))) => {
                    recorder.step(&step, theta, &mut |theta, t| (step.sample(theta, t), None));
                    self.t_end = step.time_at(theta);
                    self.y_end.copy_from_slice(&step.sample(theta, self.t_end));
                    return stop;
                }
                Err(failure) => return Stop::Failed(failure),
            }
            self.t_end = to;
            self.y_end.copy_from_slice(&step.ends.1);
            if same(to, span.1) {
                return Stop::End;
            }
            if Poll::ends(options.poll.as_ref(), to) {
                return Stop::Interrupted;
            }
        }
    }
}

/// Times from the start at which panels meet, s, in the order of the run.
struct Nodes {
    /// Times τ of the nodes of one period, s, or of all nodes if there is no period.
    times: Vec<f64>,
    period: Option<f64>,
    lead: f64,
    forward: bool,
    at: usize,
    turns: f64,
}

impl Nodes {
    /// Creates the nodes of a motion, in the direction of `span`, s.
    fn new(motion: &OneDegree<'_>, span: f64) -> Self {
        let forward = span >= 0.0;
        let mut times = if same(span, 0.0) { Vec::new() } else { motion.course.nodes() };
        // Panels of both directions of a swing, and of both halves, may end at one time.
        times.dedup_by(|a, b| (*a - *b).abs() <= 1e-9 * motion.course.period().unwrap_or(0.0));
        if !forward {
            times.reverse();
        }
        let period = motion.period();
        let turns = period.map_or(0.0, |period| (motion.lead / period).round() - if forward { 1.0 } else { -1.0 });
        Self { times, period, lead: motion.lead, forward, at: 0, turns }
    }

    /// Next node beyond the time `t` from the start, s; `None` if there is none.
    fn next_beyond(&mut self, t: f64) -> Option<f64> {
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

/// Part of the motion between two times, in the form of a step of a method.
struct Step<'m> {
    motion: &'m OneDegree<'m>,
    t0: f64,
    span: (f64, f64),
    ends: (Vec<f64>, Vec<f64>),
}

impl Step<'_> {
    fn advance(&mut self, to: f64) {
        let mut old = std::mem::take(&mut self.ends.0);
        old.clone_from(&self.ends.1);
        self.ends.0 = old;
        self.span = (self.span.1, to);
        let mut new = std::mem::take(&mut self.ends.1);
        self.at(to, &mut new);
        self.ends.1 = new;
    }

    fn at(&self, t: f64, y: &mut [f64]) {
        if self.motion.state_into(t - self.t0, y).is_err() {
            y.fill(f64::NAN);
        }
    }
}

impl Interpolant for Step<'_> {
    type Real = f64;

    fn span(&self) -> (f64, f64) {
        self.span
    }

    fn ends(&self) -> (&[f64], &[f64]) {
        (&self.ends.0, &self.ends.1)
    }

    fn inside(&self, theta: f64, mut put: impl FnMut(usize, f64)) {
        let mut y = vec![0.0; self.ends.0.len()];
        self.at(self.time_at(theta), &mut y);
        for (i, y) in y.into_iter().enumerate() {
            put(i, y);
        }
    }

    /// Returns `None`: time is a series in the coordinate, not the coordinate a series in time.
    fn order_inside(&self) -> Option<usize> {
        None
    }

    fn coefficients(&self, _put: impl FnMut(usize, usize, f64)) {}

    /// State at the time `t`: the fraction `theta` of a long step would be less exact.
    fn sample(&self, _theta: f64, t: f64) -> Vec<f64> {
        let mut y = vec![0.0; self.ends.0.len()];
        self.at(t, &mut y);
        y
    }
}
