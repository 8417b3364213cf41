//! Runs by an indirect call, so that the methods are compiled once and not for the right-hand side of each test.

use tripos_sim::projection::Invariants;
use tripos_sim::{Event, LentRightHandSide, Options, RightHandSide, SimError, Solution};
use tripos_traits::Real;

/// [`tripos_sim::integrate`].
pub fn integrate<S: Real>(
    mut rhs: impl RightHandSide<S>,
    span: (f64, f64),
    y0: &[S],
    options: &Options,
    events: &mut [Event<'_>],
) -> Result<Solution<S>, SimError> {
    tripos_sim::integrate(LentRightHandSide(&mut rhs as &mut dyn RightHandSide<S>), span, y0, options, events)
}

/// [`tripos_sim::integrate_projected`].
pub fn integrate_projected<S: Real>(
    mut rhs: impl RightHandSide<S>,
    span: (f64, f64),
    y0: &[S],
    options: &Options,
    events: &mut [Event<'_>],
    invariants: &mut Invariants<'_, S>,
) -> Result<Solution<S>, SimError> {
    let lent = LentRightHandSide(&mut rhs as &mut dyn RightHandSide<S>);
    tripos_sim::integrate_projected(lent, span, y0, options, events, invariants)
}
