//! Options of a run, and the checks that refuse invalid options.

use std::fmt;
use std::ops::ControlFlow;
use std::sync::Arc;

use tripos_traits::{AbsoluteTolerance, Method, RTOL, Real};

use crate::error::SimError;
use crate::events::corners::Corner;

/// Lowest and highest order that can be chosen for Taylor's method.
pub(crate) const ORDERS: (usize, usize) = (2, 60);

/// Options of a run: method, tolerances, step sizes, corners and output. The default is that of scene files: `ode45`
/// with the relative tolerance [`RTOL`] and the absolute tolerance [`AbsoluteTolerance::default`], and at most a
/// million steps.
#[derive(Clone, Debug, PartialEq)]
pub struct Options {
    /// Method of integration of the run.
    pub method: Method,
    /// Relative tolerance of the error of a step, 0 or more. A positive value below 100 ε is raised to 100
    /// ε, with a warning.
    pub rtol: f64,
    /// Absolute tolerance of the error of a step, 0 or more, in the units of the state. It must not be 0 if
    /// `rtol` is 0.
    pub atol: AbsoluteTolerance,
    /// Largest size of a step, s. `None` allows a tenth of the span for `ode45` and `taylor`, and the span
    /// for other methods. Steps are never limited to less than 16 ulp of t.
    pub max_step: Option<f64>,
    /// Size of the first step to try, s; `None` chooses it from the derivative at the start. Taylor's method, which
    /// proposes its own steps, may take a shorter step.
    pub initial_step: Option<f64>,
    /// Size of equal steps, s; `None` means that error estimates determine the steps. The span is divided into the
    /// smallest number of equal steps that are no longer than this size.
    ///
    /// With equal steps errors are not estimated, and tolerances, `max_step` and `initial_step` are ignored. A step
    /// that fails ends the run.
    pub step: Option<f64>,
    /// Order of [`Method::Taylor`], from 2 to 60; other methods ignore it. `None` derives it from the
    /// relative tolerance, or from the smallest absolute tolerance if the relative one is 0.
    pub order: Option<usize>,
    /// Largest number of attempted steps, accepted and rejected together.
    pub step_limit: u64,
    /// Times at which the right-hand side has a kink or a jump, s, in any order. A step ends at each of these times
    /// inside the span, so that no step leads across one. Equal steps ignore corners.
    pub corners: Vec<Corner>,
    /// Index of the component of the state that is the time itself; `None` if there is none. Near a jump this component
    /// is kept on the step's side of the jump, like the time.
    pub clock: Option<usize>,
    /// Choice of the points of the solution that are kept.
    pub output: OutputOption,
    /// Function that is called after each accepted step and may end the run; `None` if there is none. It
    /// has no influence on the steps.
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
            output: OutputOption::Steps { refine: 4 },
            poll: None,
        }
    }
}

impl Options {
    /// Default options with these tolerances. The absolute tolerance is a single number, or a list with a number for
    /// each component of the state.
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

/// Choice of the points of a solution that are kept.
#[derive(Clone, Debug, PartialEq)]
pub enum OutputOption {
    /// The start, then `refine` points for each step, evenly spaced in time: the end of the step, and points inside it
    /// from the dense output. `ode45` uses 4.
    ///
    /// At 200 000 points, every second point is dropped, as often as needed: memory does not grow with the number of
    /// steps.
    Steps {
        /// Number of points for each step, at least 1; with 1 only the end of each step is kept.
        refine: usize,
    },
    /// Points at these times, s, from the dense output. They must be in the direction of the run and within
    /// its span. They have no influence on the steps. Times beyond an early end of the run are left out.
    At(Vec<f64>),
    /// Only the start and the end of the run are kept.
    Ends,
}

/// Function that follows a run and can interrupt it. It is called after each accepted step with the time reached, s,
/// and decides if the run goes on.
///
/// The steps are the same for any answers. A run that is interrupted ends with
/// [`Stop::Interrupted`](crate::Stop::Interrupted), and the solution up to that time.
#[derive(Clone)]
pub struct Poll(Arc<dyn Fn(f64) -> ControlFlow<()> + Send + Sync>);

impl Poll {
    /// Creates a poll from a function of the time, s. The function returns `Break` to end the run.
    pub fn new(function: impl Fn(f64) -> ControlFlow<()> + Send + Sync + 'static) -> Self {
        Self(Arc::new(function))
    }

    /// Calls the poll of a run that has reached time `t`, s. True if the poll ends the run; false if there is no poll.
    pub(crate) fn ends(poll: Option<&Self>, t: f64) -> bool {
        poll.is_some_and(|poll| (poll.0)(t).is_break())
    }
}

impl fmt::Debug for Poll {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Poll")
    }
}

/// Polls are equal if both call the same function object.
impl PartialEq for Poll {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }
}

/// Refuses a span, a start or options with which no run is possible. The tolerances are checked when the error test is
/// created.
pub(crate) fn check_options<S: Real>(span: (f64, f64), y0: &[S], options: &Options) -> Result<(), SimError> {
    check_span(span, y0)?;
    check_step_options(span, options)?;
    if options.clock.is_some_and(|at| at >= y0.len()) {
        return Err(SimError::Option { name: "clock", must: "a component of the state" });
    }
    if options.order.is_some_and(|order| !(ORDERS.0..=ORDERS.1).contains(&order)) {
        return Err(SimError::Option { name: "order", must: "from 2 to 60" });
    }
    check_output(span, &options.output)
}

/// Refuses a span that is empty or not finite, and a start `y0` that is not finite.
pub(crate) fn check_span<S: Real>(span: (f64, f64), y0: &[S]) -> Result<(), SimError> {
    let (t0, t1) = span;
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

/// Refuses impossible output of a run over `span`, s: no points for a step, or times outside the span or out of order.
pub(crate) fn check_output(span: (f64, f64), output: &OutputOption) -> Result<(), SimError> {
    match output {
        OutputOption::Steps { refine: 0 } => Err(SimError::Option { name: "refine", must: "at least 1" }),
        OutputOption::At(times) => check_output_times(times, span.0, span.1),
        OutputOption::Steps { .. } | OutputOption::Ends => Ok(()),
    }
}

/// Refuses step sizes that are not positive and finite, corners that are not finite, and a method
/// without the fixed step that it needs.
fn check_step_options(span: (f64, f64), options: &Options) -> Result<(), SimError> {
    let (t0, t1) = span;
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
        None if super::method_rules::method_rules(options.method).is_none() => {
            Err(SimError::NoStep { method: options.method.name() })
        }
        Some(step) if step.min((t1 - t0).abs()) < crate::rounding::rounding_unit(t0.abs().max(t1.abs())) => {
            Err(SimError::Option { name: "step", must: "longer than the rounding of t" })
        }
        _ => Ok(()),
    }
}

/// Refuses output times that lie outside the span from `t0` to `t1`, s, or are not in the direction of
/// the run.
fn check_output_times(times: &[f64], t0: f64, t1: f64) -> Result<(), SimError> {
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
