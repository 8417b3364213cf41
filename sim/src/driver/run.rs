//! Driver of a run: a single loop for all methods.
//!
//! A method is a [`Stepper`], and [`super::step_control`] decides the sizes of its steps. The loop takes a step,
//! searches it for events, records it, and stops at the first reason to end the run.

use super::event_watch::{EventWatch, Events};
use super::recorder::Recorder;
use super::step_control::{StepControl, Verdict};
use super::step_warnings::StepWarnings;
use super::work::Work;
use crate::dense_output::{DenseStep, Interpolant};
use crate::events::Event;
use crate::events::corners::BetweenCorners;
use crate::events::divisor_guard::{DivisorGuard, DivisorZero};
use crate::methods::run_options::{Options, Poll};
use crate::projection::Projector;
use crate::right_hand_side::RightHandSide;
use crate::solution::{Solution, Stop};
use crate::stepper::{StepFailure, Stepper};
use crate::warning::Warning;
use tripos_traits::Real;

/// Largest number of attempts to shorten a step because the right-hand side must be avoided at its end.
const MOST_AVOIDED: u32 = 4;
/// Error that is assumed for a step with an avoided end, as a multiple of the tolerance. It makes the step shorter.
const SHORTER: f64 = 2.0;

/// Difference of two fractions of a step below which the places inside the step count as the same.
const ONE_PLACE: f64 = 1e-9;

/// Objects that follow each step of a run: the recorder of samples, the projector onto constraints, and
/// the work.
struct Companions<'a, 'o, 'i, 'j, S> {
    /// Recorder of the run's samples.
    recorder: &'a mut Recorder<'o, S>,
    /// Projector that moves the ends of steps onto constraints or invariants; `None` for a run without
    /// either.
    projector: Option<&'a mut Projector<'i, 'j, S>>,
    /// Work of the forces so far; `None` if the right-hand side defines no power.
    work: Option<&'a mut Work<S>>,
}

/// Run in progress: its method, its step control and its counts.
struct Run<'o, M> {
    /// Method of integration, with the current step.
    stepper: M,
    /// Step control of the run, which decides the sizes of its steps.
    pace: StepControl,
    /// Options of the run.
    options: &'o Options,
    /// Number of accepted steps of the run so far.
    steps: u64,
    /// Number of rejected attempted steps of the run so far.
    rejected: u64,
    /// Signs of doubtful steps, from which warnings are made.
    doubts: StepWarnings,
}

/// Runs the method `stepper` from the start of the span, at state `y0`, to the end of the span or to the first reason
/// to stop. Returns the solution.
pub(crate) fn run_method<M, R>(
    stepper: M,
    mut pace: StepControl,
    rhs: &mut R,
    y0: &[M::Real],
    options: &Options,
    events: &mut [Event<'_>],
    mut projector: Option<Projector<'_, '_, M::Real>>,
) -> Solution<M::Real>
where
    M: Stepper,
    R: RightHandSide<M::Real>,
{
    let t0 = pace.t0;
    pace.pass_corners(t0);
    let rhs = &mut BetweenCorners::new(rhs, options.clock, pace.smooth_intervals());
    let mut run = Run { stepper, pace, options, steps: 0, rejected: 0, doubts: StepWarnings::default() };
    if projector.is_some() {
        run.stepper.expect_moves();
    }
    let mut work = Work::new(rhs, t0, y0);
    let mut recorder = Recorder::new(&options.output, t0, y0, work.as_ref().map(|work| work.done));
    let mut watch = EventWatch::new(Events::Lent(events), y0.len());
    let mut y_end = y0.to_vec();
    let (stop, t_end) = match run.start(rhs, y0, &mut watch) {
        Some(stop) => (stop, t0),
        None => {
            let (projector, work) = (projector.as_mut(), work.as_mut());
            run.run_steps(rhs, &mut watch, Companions { recorder: &mut recorder, projector, work }, &mut y_end)
        }
    };
    let work = work.map(|work| work.done);
    recorder.record_end(t_end, &y_end, work, run.steps);
    let undecided: Vec<Warning> = watch.warnings().collect();
    Solution {
        t: recorder.t,
        y: recorder.y,
        work: recorder.work,
        t_end,
        y_end,
        work_end: work.unwrap_or(0.0),
        steps: run.steps,
        rejected: run.rejected,
        evaluations: run.stepper.evaluations() + run.pace.evaluations,
        jacobians: run.stepper.jacobians(),
        stop,
        events: watch.records,
        impacts: Vec::new(),
        warnings: run.doubts.warnings::<M::Real>().chain(undecided).collect(),
        projection: projector.map(|projector| projector.report),
    }
}

impl<M: Stepper> Run<'_, M> {
    /// Prepares the events, the method and the first step size. Returns the reason to stop if the run
    /// cannot start, else `None`.
    fn start<R>(&mut self, rhs: &mut R, y0: &[M::Real], watch: &mut EventWatch<'_, '_>) -> Option<Stop>
    where
        R: RightHandSide<M::Real>,
    {
        let t0 = self.pace.t0;
        if let Some(stop) = watch.start(t0, y0) {
            return Some(stop);
        }
        if let Err(trouble) = self.stepper.start(rhs, t0, y0) {
            return Some(stop_of_failed_run(trouble));
        }
        self.pace.start(rhs, y0, self.stepper.slope(), self.options.initial_step);
        None
    }

    /// Takes steps until there is a reason to stop. Writes the last state to `y_end`, and returns the
    /// reason and the last time, s.
    fn run_steps<R>(
        &mut self,
        rhs: &mut BetweenCorners<'_, R, M::Real>,
        watch: &mut EventWatch<'_, '_>,
        companions: Companions<'_, '_, '_, '_, M::Real>,
        y_end: &mut [M::Real],
    ) -> (Stop, f64)
    where
        R: RightHandSide<M::Real>,
    {
        let Companions { recorder, mut projector, mut work } = companions;
        let mut guard = DivisorGuard::new(rhs, self.stepper.span().0, self.stepper.ends().0);
        let stop = loop {
            let last = match self.run_step(rhs) {
                Ok(last) => last,
                Err(stop) => break stop,
            };
            if rhs.yields_step(self.stepper.span().1, self.stepper.ends().1) {
                break Stop::HandedOver;
            }
            let looks_inside = work.is_some() || recorder.wants_samples_inside(self.stepper.span());
            let suspects = !guard.is_empty() && guard.suspects_divisor_zero(rhs, &self.stepper);
            if suspects || looks_inside || !watch.is_empty() {
                self.prepare_inside(rhs);
            }
            let end = match run_end_inside_step(&self.stepper, rhs, watch, suspects.then_some(&mut guard)) {
                Ok(end) => end,
                Err(stop) => break stop,
            };
            let at_zero = matches!(&end, Some((_, Stop::Singular { .. })));
            if at_zero && rhs.hands_over(self.stepper.span().1, None) {
                y_end.copy_from_slice(self.stepper.ends().0);
                return (Stop::HandedOver, self.stepper.span().0);
            }
            let theta = end.as_ref().map_or(1.0, |(theta, _)| *theta);
            recorder.record_step(&self.stepper, theta, &mut |theta, t| {
                let done = work.as_deref_mut().map(|work| work.work_up_to(rhs, &self.stepper, theta));
                let y = self.stepper.sample(theta, t);
                match projector.as_deref_mut() {
                    Some(projector) => (projector.sample(rhs, t, y), done),
                    None => (y, done),
                }
            });
            if let Some(work) = work.as_deref_mut() {
                work.work_up_to(rhs, &self.stepper, theta);
            }
            if let Some((theta, stop)) = end {
                let t_end = self.stepper.time_at(theta);
                watch.forget_records_beyond(t_end, self.stepper.span());
                y_end.copy_from_slice(&self.stepper.sample(theta, t_end));
                return (stop, t_end);
            }
            let (t, t_new) = self.stepper.span();
            guard.accept(t_new - t);
            if let Some(work) = &mut work {
                work.accept();
            }
            self.stepper.accept();
            if let Some(projector) = &mut projector {
                let outcome = match projector.project(rhs, self.stepper.span().0, self.stepper.ends().0) {
                    Some(y) => self.stepper.continue_from_moved_state(rhs, y),
                    None => self.stepper.continue_unmoved(rhs),
                };
                if let Err(trouble) = outcome {
                    break stop_of_failed_run(trouble);
                }
            }
            if last {
                break Stop::End;
            }
            let (here, now) = (self.stepper.ends().0, self.stepper.span().0);
            if rhs.hands_over(now, Some(here)) {
                break Stop::HandedOver;
            }
            if let Some(moves) = self.pace.pass_corners(now) {
                let mut here = self.stepper.ends().0.to_vec();
                rhs.pass_jump(self.pace.smooth_intervals(), now, &mut here, &moves);
                recorder.record_jump_of_derivatives(now, &here);
                if let Err(trouble) = self.stepper.continue_from_moved_state(rhs, &here) {
                    break stop_of_failed_run(trouble);
                }
            }
            if Poll::ends(self.options.poll.as_ref(), self.stepper.span().0) {
                break Stop::Interrupted;
            }
        };
        // Until a step is accepted, both ends of `ends` are the start of the run; afterwards the first is the current
        // state.
        y_end.copy_from_slice(self.stepper.ends().0);
        (stop, self.stepper.span().0)
    }

    /// Prepares the dense output of the last step, and records a step whose dense output is coarse.
    fn prepare_inside<R>(&mut self, rhs: &mut R)
    where
        R: RightHandSide<M::Real>,
    {
        if !self.stepper.prepare_inside(rhs) {
            self.doubts.note_coarse(&self.stepper);
        }
    }

    /// Takes a step, with as many attempts as it needs. Returns true if it reached the end of the span. The error is
    /// the reason to stop the run.
    fn run_step<R>(&mut self, rhs: &mut R) -> Result<bool, Stop>
    where
        R: RightHandSide<M::Real>,
    {
        if let Some(test) = &self.pace.test
            && let Some(size) = self.stepper.proposal(test)
        {
            let first = self.options.initial_step.filter(|_| self.steps == 0);
            self.pace.propose_step_size(first.map_or(size, |first| first.min(size)));
        }
        self.pace.begin_step(self.stepper.span().0, self.steps);
        let mut avoided = 0;
        loop {
            if self.steps + self.rejected >= self.options.step_limit {
                return Err(Stop::StepLimit { limit: self.options.step_limit });
            }
            let tried = self.pace.trial.h.abs();
            let attempt = self.stepper.attempt(rhs, self.pace.trial, self.pace.test.as_ref());
            let error = match (&attempt, &self.pace.test) {
                (Ok(error), Some(test)) if *error <= test.tolerance && avoided < MOST_AVOIDED => {
                    let is_avoided = rhs.avoids_end_of_step(self.stepper.span().1, self.stepper.ends().1);
                    avoided += u32::from(is_avoided);
                    Some(if is_avoided { SHORTER * test.tolerance } else { *error })
                }
                _ => attempt.as_ref().ok().copied(),
            };
            match (&attempt, &self.pace.test) {
                // The step is shortened because of the place of its end, not because of its error.
                (Ok(own), _) if error > Some(*own) => self.doubts.note_trouble(),
                (Ok(error), Some(test)) => self.doubts.note_step_error(&self.stepper, test, tried, *error),
                _ => self.doubts.note_trouble(),
            }
            self.pace.limit_next_step(self.stepper.next_step_margin());
            match self.pace.judge_step(self.stepper.span().0, error) {
                Verdict::Accepted { last } => {
                    self.steps += 1;
                    return Ok(last);
                }
                Verdict::Again => self.rejected += 1,
                Verdict::GiveUp => {
                    self.rejected += 1;
                    return Err(match attempt {
                        Ok(_) => Stop::StepTooSmall { step: tried },
                        Err(trouble) => stop_of_failed_run(trouble),
                    });
                }
            }
        }
    }
}

/// Searches a step for an event or a zero of a divisor that ends the run. The dense output of the step must be
/// prepared. Returns the fraction of the step and the reason to stop; `None` if the run goes on. The error is a failure
/// of an event function.
///
/// `suspicious` is the guard of the divisors, or `None` if it suspects no zero in this step. If an event and a zero of
/// a divisor lie at the same place, the event counts, since its name tells why the motion ends there.
pub(crate) fn run_end_inside_step<S, I, R>(
    step: &I,
    rhs: &mut R,
    watch: &mut EventWatch<'_, '_>,
    suspicious: Option<&mut DivisorGuard<S>>,
) -> Result<Option<(f64, Stop)>, Stop>
where
    S: Real,
    I: Interpolant<Real = S>,
    R: RightHandSide<S>,
{
    let zero = suspicious.and_then(|guard| guard.first_divisor_zero(rhs, step));
    match (watch.watch_step(step), zero) {
        (Ok(Some((theta, stop))), zero) if zero.is_none_or(|zero| theta <= zero.theta + ONE_PLACE) => {
            Ok(Some((theta, stop)))
        }
        (_, Some(DivisorZero { divisor, theta })) => {
            Ok(Some((theta, Stop::Singular { divisor: rhs.divisor_name(divisor) })))
        }
        (Ok(_), None) => Ok(None),
        (Err(failure), None) => Err(Stop::Failed(failure)),
    }
}

/// Reason to stop a run whose step failed in this way even at the smallest size.
fn stop_of_failed_run(trouble: StepFailure) -> Stop {
    match trouble {
        StepFailure::NotFinite { component } => Stop::NotFinite { component },
        StepFailure::Failed(failure) => Stop::Failed(failure),
        StepFailure::NotConverged { iterations } => Stop::NotConverged { iterations },
    }
}
