//! The driver: from a question to a [`Solution`].
//!
//! One loop serves every method; a method is a [`Stepper`]. The loop takes a step, lets the events
//! look at it, records it, and stops at the first reason to.

use crate::control;
use crate::dormand_prince::DORMAND_PRINCE_54;
use crate::error::{Failure, SimError};
use crate::events::Event;
use crate::explicit::ExplicitRungeKutta;
use crate::recorder::Recorder;
use crate::solution::{Output, Solution, Stop};
use crate::stepper::{Stepper, Trouble};
use crate::tolerance::{AbsoluteTolerance, ErrorTest};
use crate::watch::Watch;

/// A method of integration.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Method {
    /// Dormand–Prince 5(4) with the step control of `ode45`; see [`DORMAND_PRINCE_54`].
    #[default]
    DormandPrince54,
}

impl Method {
    /// All methods, in the order in which they are always listed.
    pub const ALL: [Self; 1] = [Self::DormandPrince54];

    /// The name used on the command line, in files and in tables.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::DormandPrince54 => "ode45",
        }
    }

    /// Order of the solution at the end of a step.
    #[must_use]
    pub const fn order(self) -> u32 {
        match self {
            Self::DormandPrince54 => DORMAND_PRINCE_54.order,
        }
    }

    /// Order of the solution inside a step.
    #[must_use]
    pub const fn dense_order(self) -> u32 {
        match self {
            Self::DormandPrince54 => DORMAND_PRINCE_54.dense_order,
        }
    }
}

/// How to integrate. The default is that of `ode45`, with a limit of a million steps.
#[derive(Clone, Debug, PartialEq)]
pub struct Options {
    /// The method.
    pub method: Method,
    /// Relative tolerance, 0 or more; positive ones below 100 ε are raised to that, with a warning.
    pub rtol: f64,
    /// Absolute tolerance, 0 or more, in the units of the state. Not 0 where `rtol` is.
    pub atol: AbsoluteTolerance,
    /// Longest step, in s; a tenth of the span unless given. Never below 16 ulp of t.
    pub max_step: Option<f64>,
    /// First step to try, in s; chosen from the derivative at the start unless given.
    pub initial_step: Option<f64>,
    /// Largest number of attempted steps, accepted and rejected together.
    pub step_limit: u64,
    /// Which points to keep.
    pub output: Output,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            method: Method::default(),
            rtol: 1e-3,
            atol: AbsoluteTolerance::Uniform(1e-6),
            max_step: None,
            initial_step: None,
            step_limit: 1_000_000,
            output: Output::Steps { refine: 4 },
        }
    }
}

/// Integrates y' = f(t, y) from (t0, y0) to t1, which may lie before t0.
///
/// `rhs(t, y, dydt)` writes f(t, y) to `dydt`; both slices have the length of `y0`, and `dydt`
/// comes with old contents. It may fail, or write numbers that are not finite: the step is then
/// tried again with half its size, and the run ends with that reason when the size is down to 16
/// ulp of t.
///
/// However the run ends, the solution up to there is returned.
///
/// # Errors
/// [`SimError`] if the question makes no sense: a span that is empty or not finite, a start that is
/// not finite, tolerances or options out of range, output times outside the span.
pub fn integrate<F>(
    mut rhs: F,
    span: (f64, f64),
    y0: &[f64],
    options: &Options,
    events: &mut [Event<'_>],
) -> Result<Solution, SimError>
where
    F: FnMut(f64, &[f64], &mut [f64]) -> Result<(), Failure>,
{
    check(span, y0, options)?;
    let (test, warning) = ErrorTest::new(options.rtol, &options.atol, y0.len())?;
    let mut solution = match options.method {
        Method::DormandPrince54 => {
            let stepper = ExplicitRungeKutta::new(&DORMAND_PRINCE_54, y0.len());
            Run::new(stepper, test, span, options).solve(&mut rhs, y0, events)
        }
    };
    solution.warnings.extend(warning);
    Ok(solution)
}

fn check((t0, t1): (f64, f64), y0: &[f64], options: &Options) -> Result<(), SimError> {
    if !(t0.is_finite() && t1.is_finite() && (t1 - t0).is_finite()) {
        return Err(SimError::NotFinite { what: format!("the span from {t0} s to {t1} s") });
    }
    if t1 - t0 == 0.0 {
        return Err(SimError::EmptySpan { t: t0 });
    }
    if let Some(i) = y0.iter().position(|y| !y.is_finite()) {
        return Err(SimError::NotFinite { what: format!("component {i} of the initial state") });
    }
    for (name, size) in [("max_step", options.max_step), ("initial_step", options.initial_step)] {
        if size.is_some_and(|h| !(h > 0.0 && h.is_finite())) {
            return Err(SimError::Option { name, must: "positive and finite" });
        }
    }
    match &options.output {
        Output::Steps { refine: 0 } => Err(SimError::Option { name: "refine", must: "at least 1" }),
        Output::At(times) => check_times(times, t0, t1),
        Output::Steps { .. } | Output::Ends => Ok(()),
    }
}

fn check_times(times: &[f64], t0: f64, t1: f64) -> Result<(), SimError> {
    let mut previous = t0;
    for (index, &t) in times.iter().enumerate() {
        // Both products are 0 or of the sign of the run; a NaN fails the test.
        let ordered = (t - previous) * (t1 - t0).signum() >= 0.0;
        if !(ordered && (t1 - t) * (t1 - t0).signum() >= 0.0) {
            return Err(SimError::OutputTime { index, t });
        }
        previous = t;
    }
    Ok(())
}

/// What limits the size and number of steps, and how far the run has come.
struct Run<'o, S> {
    stepper: S,
    test: ErrorTest,
    options: &'o Options,
    t0: f64,
    t1: f64,
    /// 1 forward, −1 backward.
    direction: f64,
    longest: f64,
    /// Size to try next.
    size: f64,
    steps: u64,
    rejected: u64,
}

impl<'o, S: Stepper> Run<'o, S> {
    fn new(stepper: S, test: ErrorTest, (t0, t1): (f64, f64), options: &'o Options) -> Self {
        let length = (t1 - t0).abs();
        Self {
            stepper,
            test,
            options,
            t0,
            t1,
            direction: (t1 - t0).signum(),
            longest: options.max_step.unwrap_or(0.1 * length).min(length),
            size: 0.0,
            steps: 0,
            rejected: 0,
        }
    }

    fn solve<F>(mut self, rhs: &mut F, y0: &[f64], events: &mut [Event<'_>]) -> Solution
    where
        F: FnMut(f64, &[f64], &mut [f64]) -> Result<(), Failure>,
    {
        let mut recorder = Recorder::new(&self.options.output, self.t0, y0);
        let mut watch = Watch::new(events, y0.len());
        let mut y_end = y0.to_vec();
        let (stop, t_end) = match self.start(rhs, y0, &mut watch) {
            Some(stop) => (stop, self.t0),
            None => self.walk(rhs, &mut watch, &mut recorder, &mut y_end),
        };
        recorder.finish(t_end, &y_end, self.steps);
        Solution {
            t: recorder.t,
            y: recorder.y,
            t_end,
            y_end,
            steps: self.steps,
            rejected: self.rejected,
            evaluations: self.stepper.evaluations(),
            stop,
            events: watch.records,
            warnings: Vec::new(),
        }
    }

    /// Prepares the first step; returns a reason not to take it.
    fn start<F>(&mut self, rhs: &mut F, y0: &[f64], watch: &mut Watch<'_, '_>) -> Option<Stop>
    where
        F: FnMut(f64, &[f64], &mut [f64]) -> Result<(), Failure>,
    {
        if let Some(stop) = watch.start(self.t0, y0) {
            return Some(stop);
        }
        if let Err(trouble) = self.stepper.start(rhs, self.t0, y0) {
            return Some(stop_for(trouble));
        }
        let norm = self.test.slope_norm(self.stepper.slope(), y0);
        let order = self.stepper.order();
        self.size = match self.options.initial_step {
            Some(size) => size,
            None => control::initial(&self.test, order, self.longest, self.t0, norm),
        };
        None
    }

    /// Steps until there is a reason to stop, which is returned with the last time of the solution.
    fn walk<F>(
        &mut self,
        rhs: &mut F,
        watch: &mut Watch<'_, '_>,
        recorder: &mut Recorder<'_>,
        y_end: &mut [f64],
    ) -> (Stop, f64)
    where
        F: FnMut(f64, &[f64], &mut [f64]) -> Result<(), Failure>,
    {
        let n = y_end.len();
        let stop = loop {
            let last = match self.advance(rhs) {
                Ok(last) => last,
                Err(stop) => break stop,
            };
            match watch.look(&self.stepper) {
                Ok(None) => recorder.step(&self.stepper, 1.0, n),
                Ok(Some((theta, stop))) => {
                    recorder.step(&self.stepper, theta, n);
                    self.stepper.interpolate(theta, y_end);
                    return (stop, self.stepper.time_at(theta));
                }
                Err(failure) => break Stop::Failed(failure),
            }
            self.stepper.accept();
            if last {
                break Stop::End;
            }
        };
        y_end.copy_from_slice(self.stepper.state());
        (stop, self.stepper.time())
    }

    /// Takes one step, with as many attempts as it needs; says whether it reached the end of the
    /// span.
    fn advance<F>(&mut self, rhs: &mut F) -> Result<bool, Stop>
    where
        F: FnMut(f64, &[f64], &mut [f64]) -> Result<(), Failure>,
    {
        let (t, order) = (self.stepper.time(), self.stepper.order());
        let smallest = control::smallest(t);
        let mut size = self.size.min(self.longest).max(smallest);
        // Stretch or shorten the step if the end is within 1.1 of it.
        let mut last = 1.1 * size >= (self.t1 - t).abs();
        if last {
            size = (self.t1 - t).abs();
        }
        let mut failed_before = false;
        loop {
            if self.steps + self.rejected >= self.options.step_limit {
                return Err(Stop::StepLimit { limit: self.options.step_limit });
            }
            let h = self.direction * size;
            let t_end = if last { self.t1 } else { t + h };
            let attempt = self.stepper.attempt(rhs, h, t_end, &self.test);
            if let Ok(error) = attempt
                && error <= self.test.tolerance
            {
                self.steps += 1;
                self.size = if failed_before { size } else { control::after_success(&self.test, order, size, error) };
                return Ok(last);
            }
            self.rejected += 1;
            if size <= smallest {
                return Err(match attempt {
                    Ok(_) => Stop::StepTooSmall { step: size },
                    Err(trouble) => stop_for(trouble),
                });
            }
            let smaller = match attempt {
                Ok(error) if !failed_before => control::after_first_failure(&self.test, order, size, error),
                Ok(_) | Err(_) => 0.5 * size,
            };
            size = smaller.max(smallest);
            failed_before = true;
            last = false;
        }
    }
}

fn stop_for(trouble: Trouble) -> Stop {
    match trouble {
        Trouble::NotFinite { component } => Stop::NotFinite { component },
        Trouble::Failed(failure) => Stop::Failed(failure),
    }
}
