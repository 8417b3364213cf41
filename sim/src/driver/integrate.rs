//! Integration of an initial value problem, with a [`Solution`] as the result: checks the arguments, selects the method
//! and runs it.

use tripos_traits::Real;

use super::run::run_method;
use super::step_control::StepControl;
use crate::error::SimError;
use crate::events::Event;
use crate::methods::dop853::Dop853;
use crate::methods::dormand_prince::DORMAND_PRINCE_54;
use crate::methods::explicit_runge_kutta::{ExplicitRungeKutta, StepLength};
use crate::methods::gauss6::Gauss6;
use crate::methods::radau::Radau5;
use crate::methods::rk4::Rk4;
use crate::methods::run_options::{self, Options};
use crate::methods::taylor::{Taylor, taylor_order};
use crate::projection::{Invariants, ProjectionTarget, Projector};
use crate::right_hand_side::RightHandSide;
use crate::solution::Solution;
use tripos_traits::Method;

/// Integrates y' = f(t, y) from (t0, y0) to t1, which may lie before t0; `span` is (t0, t1), s.
///
/// `rhs` is a closure `|t: f64, y: &[S], dydt: &mut [S]|` that writes f(t, y) to `dydt`, or another [`RightHandSide`].
/// Both slices have the length of `y0`, and `dydt` has old contents at the call. `rhs` may fail, or write numbers that
/// are not finite: the step is then tried again with half its size. The run ends with that reason when the size is down
/// to 16 ulp of t.
///
/// The state is computed in the scalar `S`. Times, output times and errors are `f64`, and events get the state rounded
/// to `f64`. Steps begin and end at times that are `f64` exactly, so that a wider scalar loses nothing.
///
/// If the right-hand side has constraints, the state is moved onto them after each step. The corrections are reported
/// in [`Solution::projection`].
///
/// The solution up to the end of the run is returned, whatever the reason for that end.
///
/// # Errors
/// [`SimError`] if nothing can be run: a span that is empty or not finite, a start that is not finite, tolerances or
/// options out of range, output times outside the span. Also if the method lacks the fixed step, the Jacobian or the
/// Taylor coefficients that it needs.
pub fn integrate<S, R>(
    rhs: R,
    span: (f64, f64),
    y0: &[S],
    options: &Options,
    events: &mut [Event<'_>],
) -> Result<Solution<S>, SimError>
where
    S: Real,
    R: RightHandSide<S>,
{
    integrate_with_invariants(rhs, span, y0, options, events, None)
}

/// Integrates y' = f(t, y) from `y0` over `span`, s, like [`integrate`], and keeps `invariants` at
/// their values at the start. After each step the state is moved onto them.
///
/// The corrections are reported in [`Solution::projection`]. See [`crate::projection`] for events and
/// output.
///
/// # Errors
/// [`SimError`] if nothing can be run: an empty span, a tolerance or option out of range, a wrong
/// length.
pub fn integrate_projected<S, R>(
    rhs: R,
    span: (f64, f64),
    y0: &[S],
    options: &Options,
    events: &mut [Event<'_>],
    invariants: &mut Invariants<'_, S>,
) -> Result<Solution<S>, SimError>
where
    S: Real,
    R: RightHandSide<S>,
{
    integrate_with_invariants(rhs, span, y0, options, events, Some(invariants))
}

/// Integrates y' = f(t, y) from `y0` over `span`, s, with the method of the options. The state is moved
/// onto the given invariants, or else onto the constraints of the right-hand side if it has any.
fn integrate_with_invariants<S, R>(
    mut rhs: R,
    span: (f64, f64),
    y0: &[S],
    options: &Options,
    events: &mut [Event<'_>],
    invariants: Option<&mut Invariants<'_, S>>,
) -> Result<Solution<S>, SimError>
where
    S: Real,
    R: RightHandSide<S>,
{
    run_options::check_options(span, y0, options)?;
    let n = y0.len();
    let (pace, warning) = StepControl::new::<S>(span, n, options)?;
    let rhs = &mut rhs;
    if options.method.needs_jacobian() && rhs.jacobian(span.0, y0, &mut vec![S::from_f64(0.0); n * n]).is_none() {
        return Err(SimError::NoJacobian { method: options.method.name() });
    }
    let onto = match (invariants, rhs.constraint_count()) {
        (Some(invariants), _) => Some(ProjectionTarget::Invariants(invariants)),
        (None, 0) => None,
        (None, count) => Some(ProjectionTarget::Constraints(count)),
    };
    let projector = onto.map(|onto| Projector::new(onto, rhs, options, span.0, y0));
    let mut solution = match options.method {
        Method::Rk4 => run_method(Rk4::new(n), pace, rhs, y0, options, events, projector),
        Method::Ode45 => {
            let stepper = ExplicitRungeKutta::new(&DORMAND_PRINCE_54, StepLength::Chosen, n);
            run_method(stepper, pace, rhs, y0, options, events, projector)
        }
        Method::Dopri5 => {
            let stepper = ExplicitRungeKutta::new(&DORMAND_PRINCE_54, StepLength::Exact, n);
            run_method(stepper, pace, rhs, y0, options, events, projector)
        }
        Method::Dop853 => run_method(Dop853::new(n), pace, rhs, y0, options, events, projector),
        Method::Gauss6 => run_method(Gauss6::new(n), pace, rhs, y0, options, events, projector),
        Method::Radau5 => run_method(Radau5::new(n, options), pace, rhs, y0, options, events, projector),
        Method::Taylor => {
            let order = taylor_order(options);
            let mut x = y0.repeat(order + 1);
            if rhs.taylor(span.0, order, &mut x).is_none() {
                return Err(SimError::NoSeries { method: options.method.name() });
            }
            run_method(Taylor::new(n, order), pace, rhs, y0, options, events, projector)
        }
    };
    solution.warnings.splice(..0, warning);
    Ok(solution)
}
