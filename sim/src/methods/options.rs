//! Options of a run, and the checks that refuse senseless ones.

use std::fmt;
use std::ops::ControlFlow;
use std::sync::Arc;

use tripos_traits::{AbsoluteTolerance, Method, RTOL, Real};

use crate::error::SimError;
use crate::events::corners::Corner;

/// The lowest and the highest order that a method without a fixed one takes.
pub(crate) const ORDERS: (usize, usize) = (2, 60);

/// Options of a run. The default is that of scene files: `ode45` to [`RTOL`] and [`AbsoluteTolerance::default`], with a
/// limit of a million steps.
#[derive(Clone, Debug, PartialEq)]
pub struct Options {
    /// The method.
    pub method: Method,
    /// Relative tolerance, 0 or more; positive ones below 100 ε are raised to that, with a warning.
    pub rtol: f64,
    /// Absolute tolerance, 0 or more, in the units of the state. Not 0 where `rtol` is.
    pub atol: AbsoluteTolerance,
    /// Longest step, in s; unless given, a tenth of the span for `ode45`, the span for the others. Never below 16
    /// ulp of t.
    pub max_step: Option<f64>,
    /// First step to try, in s; chosen from the derivative at the start unless given. A method that proposes its steps
    /// may take a shorter one.
    pub initial_step: Option<f64>,
    /// A fixed step, in s: the span is divided into equal steps, as few as are no longer than this. Errors are not
    /// estimated then, and tolerances, `max_step` and `initial_step` play no part; a step that fails ends the run.
    pub step: Option<f64>,
    /// The order of [`Method::Taylor`], from 2 to 60; unless given, it follows from the relative tolerance, or from the
    /// smallest absolute one where there is no other. No other method has a choice.
    pub order: Option<usize>,
    /// Largest number of attempted steps, accepted and rejected together.
    pub step_limit: u64,
    /// Instants at which the right-hand side is not smooth in time, in any order. A step ends at each of them inside
    /// the span, so that none goes across. Equal steps take no notice.
    pub corners: Vec<Corner>,
    /// The component of the state that is the time itself, if one is: next to a jump it is kept on its side as well.
    pub clock: Option<usize>,
    /// Points of the solution to keep.
    pub output: Output,
    /// Asked after every accepted step whether to go on; it has no influence on the steps themselves.
    pub poll: Option<Poll>,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            method: Method::default(),
            rtol: RTOL,
            atol: AbsoluteTolerance::default(),
            max_step: None,
            initial_step: None,
            step: None,
            order: None,
            step_limit: 1_000_000,
            corners: Vec::new(),
            clock: None,
            output: Output::Steps { refine: 4 },
            poll: None,
        }
    }
}

impl Options {
    /// The default but for its tolerances: relative, and absolute as one number or a list of one for each component.
    ///
    /// ```
    /// use tripos_sim::{Method, Options};
    /// let options = Options { method: Method::Dop853, ..Options::tolerances(1e-9, vec![1e-9, 1e-12]) };
    /// ```
    #[must_use]
    pub fn tolerances(rtol: f64, atol: impl Into<AbsoluteTolerance>) -> Self {
        Self { rtol, atol: atol.into(), ..Self::default() }
    }
}

/// Points of a solution that are kept.
#[derive(Clone, Debug, PartialEq)]
pub enum Output {
    /// The start, then `refine` points a step: its end and `refine` − 1 inside, evenly spaced in
    /// time, from the dense output. `ode45` uses 4. Of more than 200 000 points every second is left out, as often as
    /// there are more: memory does not grow with the number of steps.
    Steps {
        /// Points a step, at least 1.
        refine: usize,
    },
    /// These times, in s, from the dense output: in the direction of the run, within its span.
    /// They have no influence on the steps (in `ode45` the first one bounds the initial step).
    /// Times beyond an early end are left out.
    At(Vec<f64>),
    /// Start and end only: memory does not grow with the number of steps.
    Ends,
}

/// Follower of a run. It is told the time, in s, that each accepted step has reached, and answers whether to go on.
///
/// Whatever it answers, the steps are the same: a run that it ends has [`Stop::Interrupted`](crate::Stop::Interrupted),
/// and the solution up to there.
#[derive(Clone)]
pub struct Poll(Arc<dyn Fn(f64) -> ControlFlow<()> + Send + Sync>);

impl Poll {
    /// A follower that asks this function: it is told the time, s, and breaks to end the run.
    pub fn new(function: impl Fn(f64) -> ControlFlow<()> + Send + Sync + 'static) -> Self {
        Self(Arc::new(function))
    }

    /// True if the follower ends the run that has reached `t`.
    pub(crate) fn ends(poll: Option<&Self>, t: f64) -> bool {
        poll.is_some_and(|poll| (poll.0)(t).is_break())
    }
}

impl fmt::Debug for Poll {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Poll")
    }
}

/// Equal if both ask one and the same function.
impl PartialEq for Poll {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }
}

/// Refuses questions that cannot be run, tolerances aside.
pub(crate) fn check<S: Real>(span: (f64, f64), y0: &[S], options: &Options) -> Result<(), SimError> {
    check_span(span, y0)?;
    check_steps(span, options)?;
    if options.clock.is_some_and(|at| at >= y0.len()) {
        return Err(SimError::Option { name: "clock", must: "a component of the state" });
    }
    if options.order.is_some_and(|order| !(ORDERS.0..=ORDERS.1).contains(&order)) {
        return Err(SimError::Option { name: "order", must: "from 2 to 60" });
    }
    check_output(span, &options.output)
}

/// Refuses a span without a length, and a start that is none.
pub(crate) fn check_span<S: Real>((t0, t1): (f64, f64), y0: &[S]) -> Result<(), SimError> {
    if !(t0.is_finite() && t1.is_finite() && (t1 - t0).is_finite()) {
        return Err(SimError::NotFinite { what: format!("the span from {t0} s to {t1} s") });
    }
    if t1 - t0 == 0.0 {
        return Err(SimError::EmptySpan { t: t0 });
    }
    if let Some(i) = y0.iter().position(|y| !y.to_f64().is_finite()) {
        return Err(SimError::NotFinite { what: format!("component {i} of the initial state") });
    }
    Ok(())
}

/// Refuses output that a run over this span cannot have.
pub(crate) fn check_output((t0, t1): (f64, f64), output: &Output) -> Result<(), SimError> {
    match output {
        Output::Steps { refine: 0 } => Err(SimError::Option { name: "refine", must: "at least 1" }),
        Output::At(times) => check_times(times, t0, t1),
        Output::Steps { .. } | Output::Ends => Ok(()),
    }
}

fn check_steps((t0, t1): (f64, f64), options: &Options) -> Result<(), SimError> {
    if let Some(corner) = options.corners.iter().find(|corner| !corner.at.is_finite()) {
        return Err(SimError::NotFinite { what: format!("the corner at {} s", corner.at) });
    }
    let sizes = [("max_step", options.max_step), ("initial_step", options.initial_step), ("step", options.step)];
    for (name, size) in sizes {
        if size.is_some_and(|h| !(h > 0.0 && h.is_finite())) {
            return Err(SimError::Option { name, must: "positive and finite" });
        }
    }
    match options.step {
        None if super::method::rules(options.method).is_none() => {
            Err(SimError::NoStep { method: options.method.name() })
        }
        Some(step) if step.min((t1 - t0).abs()) < crate::rounding::ulp(t0.abs().max(t1.abs())) => {
            Err(SimError::Option { name: "step", must: "longer than the rounding of t" })
        }
        _ => Ok(()),
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
