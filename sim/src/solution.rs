//! Result of a run: samples, counts, events, and the reason why it ended.
//!
//! Invariant: (`t_end`, `y_end`) is the last point of the solution. No sample and no event lies beyond it, whatever the
//! reason for the end of the run.

use std::fmt;

use tripos_traits::{Real, larger};

use crate::contacts::closed_contacts::ImpactRecord;
use crate::error::Failure;
use crate::events::EventRecord;
use crate::projection::ProjectionReport;
use crate::warning::Warning;

/// Reason why a run ended.
#[derive(Clone, Debug, PartialEq)]
pub enum Stop {
    /// The run reached the end of its span.
    End,
    /// A terminal event happened, that is, an event that ends runs.
    Event {
        /// Name of the event that ended the run.
        name: String,
    },
    /// The run left the domain in which its equations hold: the function of a domain event became negative.
    LeftDomain {
        /// Name of the domain event whose condition no longer holds.
        name: String,
    },
    /// The run started outside the domain in which its equations hold: no step was made.
    StartsOutside {
        /// Name of the domain event whose condition does not hold at the start.
        name: String,
    },
    /// The error of a step is above the tolerance, although the step is as small as rounding allows, 16 ulp of t.
    StepTooSmall {
        /// Size of the smallest step that was tried, s.
        step: f64,
    },
    /// The number of accepted and rejected steps has reached its limit.
    StepLimit {
        /// Largest number of steps that the options allow.
        limit: u64,
    },
    /// A state or derivative is infinite or not a number, even in the smallest step.
    NotFinite {
        /// Index in the state, from 0, of the component that is infinite or not a number.
        component: usize,
    },
    /// Newton's method does not solve the equations of an implicit step, even for the smallest step.
    NotConverged {
        /// Number of iterations of Newton's method that were made.
        iterations: u32,
    },
    /// A divisor of the equations is zero at the end of the run. The equations have no value there, and
    /// cannot continue the motion.
    Singular {
        /// Name of the divisor that is zero.
        divisor: String,
    },
    /// The right-hand side or an event function has no value, even in the smallest step.
    Failed(Failure),
    /// The `poll` function of the options asked to stop the run.
    Interrupted,
    /// Other equations of the same motion must continue it, by [`crate::RightHandSide::hands_over`] or
    /// [`crate::RightHandSide::yields_step`].
    HandedOver,
}

impl Stop {
    /// Stable text that identifies the reason for other programs: `end`, `event:NAME`, `domain:NAME`, `step-too-small`,
    /// `step-limit`, `not-finite`, `not-converged`, `singular`, `interrupted` or `handed-over`. If the right-hand side
    /// failed, it is the code of its [`Failure`].
    #[must_use]
    pub fn code(&self) -> String {
        match self {
            Self::End => "end".to_owned(),
            Self::Event { name } => format!("event:{name}"),
            Self::LeftDomain { name } | Self::StartsOutside { name } => format!("domain:{name}"),
            Self::StepTooSmall { .. } => "step-too-small".to_owned(),
            Self::StepLimit { .. } => "step-limit".to_owned(),
            Self::NotFinite { .. } => "not-finite".to_owned(),
            Self::NotConverged { .. } => "not-converged".to_owned(),
            Self::Singular { .. } => "singular".to_owned(),
            Self::Failed(failure) => failure.code.to_owned(),
            Self::Interrupted => "interrupted".to_owned(),
            Self::HandedOver => "handed-over".to_owned(),
        }
    }

    /// True if the run could not go on. False if it reached its end, met an event that ends runs, or left its domain.
    #[must_use]
    pub fn is_failure(&self) -> bool {
        !matches!(self, Self::End | Self::Event { .. } | Self::LeftDomain { .. } | Self::StartsOutside { .. })
    }
}

impl Stop {
    /// Returns the reason why the run ended, in words. `names` names the components of the state, in order.
    #[must_use]
    pub fn described(&self, names: &[String]) -> String {
        match self {
            Self::NotFinite { component } => match names.get(*component) {
                Some(name) => format!("`{name}` or its rate is not finite"),
                None => self.to_string(),
            },
            other => other.to_string(),
        }
    }
}

impl fmt::Display for Stop {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::End => f.write_str("end of the run"),
            Self::Event { name } => write!(f, "event `{name}`"),
            Self::LeftDomain { name } => {
                write!(f, "left the domain of the equations: `{name}` no longer holds")
            }
            Self::StartsOutside { name } => {
                write!(f, "the start is outside the domain of the equations: `{name}` does not hold there")
            }
            Self::StepTooSmall { step } => write!(f, "step {step:.1e} s is below rounding"),
            Self::StepLimit { limit } => write!(f, "the limit of {limit} steps is used up"),
            Self::NotFinite { component } => {
                write!(f, "component {component} of the state or its derivative is not finite")
            }
            Self::NotConverged { iterations } => {
                write!(f, "Newton's method does not solve the equations of the step in {iterations} iterations")
            }
            Self::Singular { divisor } => write!(f, "the equations divide by {divisor}, which is 0 there"),
            Self::Failed(failure) => failure.fmt(f),
            Self::Interrupted => f.write_str("interrupted"),
            Self::HandedOver => f.write_str("other equations go on from here"),
        }
    }
}

/// Result of a run: samples, counts, events, and the reason why it ended.
#[derive(Clone, Debug, PartialEq)]
pub struct Solution<S = f64> {
    /// Times of the samples, s, in the direction of the run, which may go backward in time.
    pub t: Vec<f64>,
    /// States of the samples, one for each time in `t`.
    pub y: Vec<Vec<S>>,
    /// Work of the forces from the start to each sample, J, including the work of impacts. Empty if the equations
    /// define no power and there are no impacts.
    pub work: Vec<f64>,
    /// Time at which the solution ends, s.
    pub t_end: f64,
    /// State at the end of the solution, at time `t_end`.
    pub y_end: Vec<S>,
    /// Work of the forces from the start to `t_end`, J; 0 if the equations define no power.
    pub work_end: f64,
    /// Number of accepted steps of the run.
    pub steps: u64,
    /// Number of rejected steps: too inaccurate, or without a finite result.
    pub rejected: u64,
    /// Number of calls of the right-hand side by the method; calls by event functions are not counted.
    pub evaluations: u64,
    /// Number of evaluations of the Jacobian ∂f/∂y; 0 for explicit methods.
    pub jacobians: u64,
    /// Reason why the run ended, such as the end of its span, an event or a failure.
    pub stop: Stop,
    /// Events that happened in the run, in the order in which the run met them.
    pub events: Vec<EventRecord>,
    /// Impacts in the order in which they happened. Empty for a single run: only a run that is joined from
    /// parts has impacts.
    pub impacts: Vec<ImpactRecord>,
    /// Warnings about the accuracy of the run and about undecided events.
    pub warnings: Vec<Warning>,
    /// Report on the corrections that kept the state on invariants or constraints; `None` if the run had
    /// neither.
    pub projection: Option<ProjectionReport>,
}

impl<S: Clone> Solution<S> {
    /// Creates the solution of a run that ended at its start (t, y), before the first step, for the reason
    /// `stop`.
    #[must_use]
    pub fn ended_at_start(t: f64, y: &[S], stop: Stop) -> Self {
        Self {
            t: vec![t],
            y: vec![y.to_vec()],
            work: Vec::new(),
            t_end: t,
            y_end: y.to_vec(),
            work_end: 0.0,
            steps: 0,
            rejected: 0,
            evaluations: 0,
            jacobians: 0,
            stop,
            events: Vec::new(),
            impacts: Vec::new(),
            warnings: Vec::new(),
            projection: None,
        }
    }
}

impl<S> Solution<S> {
    /// Largest change of energy that is not explained by the work, J. It is the largest change of E − W since the first
    /// sample, over all samples and the end of the run.
    ///
    /// `at_samples` has the energy E at each sample, J, and `at_end` the energy at the end. NaN if an energy is NaN.
    pub fn energy_drift(&self, at_samples: impl IntoIterator<Item = f64>, at_end: f64) -> f64 {
        let work = self.work.iter().copied().chain(std::iter::repeat(0.0));
        let mut left = at_samples.into_iter().zip(work).map(|(energy, work)| energy - work).peekable();
        let end = at_end - self.work_end;
        let start = left.peek().copied().unwrap_or(end);
        left.chain([end]).map(|left| (left - start).abs()).fold(0.0, larger)
    }

    /// Returns the end time, the number of steps and the reason of the end, in words. `names` names the components of
    /// the state, in order.
    #[must_use]
    pub fn described(&self, names: &[String]) -> String {
        let verb = if self.stop == Stop::End { "ended" } else { "stopped" };
        let plural = if self.steps == 1 { "" } else { "s" };
        let (t, steps, rejected) = (self.t_end, self.steps, self.rejected);
        let how = format!("{verb} at t = {t} s after {steps} step{plural} ({rejected} rejected)");
        if self.stop == Stop::End { how } else { format!("{how}: {}", self.stop.described(names)) }
    }
}

impl<S: Real> Solution<S> {
    /// Returns a copy of the solution whose states are rounded to `f64`.
    #[must_use]
    pub fn solution_in_doubles(&self) -> Solution {
        let doubles = |y: &Vec<S>| y.iter().map(|y| y.to_f64()).collect::<Vec<f64>>();
        Solution {
            t: self.t.clone(),
            y: self.y.iter().map(doubles).collect(),
            work: self.work.clone(),
            t_end: self.t_end,
            y_end: doubles(&self.y_end),
            work_end: self.work_end,
            steps: self.steps,
            rejected: self.rejected,
            evaluations: self.evaluations,
            jacobians: self.jacobians,
            stop: self.stop.clone(),
            events: self.events.clone(),
            impacts: self.impacts.clone(),
            warnings: self.warnings.clone(),
            projection: self.projection.clone(),
        }
    }
}

/// Writes the end time, the number of steps and the reason of the end: "stopped at t = 3.181 s after 412 steps (19
/// rejected): …".
impl<S> fmt::Display for Solution<S> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.described(&[]))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn stopped(stop: Stop) -> Solution {
        Solution { steps: 412, rejected: 19, ..Solution::ended_at_start(3.181, &[], stop) }
    }

    #[test]
    fn a_stopped_run_says_when_after_how_many_steps_and_why() {
        assert_eq!(
            stopped(Stop::StepTooSmall { step: 4.1e-15 }).to_string(),
            "stopped at t = 3.181 s after 412 steps (19 rejected): step 4.1e-15 s is below rounding"
        );
        assert_eq!(stopped(Stop::End).to_string(), "ended at t = 3.181 s after 412 steps (19 rejected)");
    }

    #[test]
    fn codes_are_stable() {
        let failure = Failure { code: "singular", message: String::new() };
        for (stop, code, failed) in [
            (Stop::End, "end", false),
            (Stop::Event { name: "hit".into() }, "event:hit", false),
            (Stop::LeftDomain { name: "N".into() }, "domain:N", false),
            (Stop::StartsOutside { name: "N".into() }, "domain:N", false),
            (Stop::StepTooSmall { step: 1.0 }, "step-too-small", true),
            (Stop::StepLimit { limit: 1 }, "step-limit", true),
            (Stop::NotFinite { component: 0 }, "not-finite", true),
            (Stop::NotConverged { iterations: 9 }, "not-converged", true),
            (Stop::Failed(failure), "singular", true),
            (Stop::Interrupted, "interrupted", true),
        ] {
            assert_eq!((stop.code().as_str(), stop.is_failure()), (code, failed));
        }
    }
}
