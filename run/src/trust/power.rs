//! Power of the loads without a potential, along a run by any set of equations.

use crate::code::{Ready, code};
use crate::error::Error;
use crate::preparation::problem::{Power, Problem};
use tripos_derive::Formulation;

/// Function for the power that changes T + V along a run, W. `None` if no load without a potential works, or the run
/// shows no energies.
///
/// A scene's reduced equations show the energies of the whole model. The power is then computed by Kane's equations at
/// the shown state.
///
/// # Errors
/// [`Error`] if the model has no Kane's equations.
pub fn power<'a>(problem: &'a Problem<'_>) -> Result<Option<Power<'a>>, Error> {
    let system = problem.system();
    if !problem.by.is_reduced() {
        let n = system.lengths().coordinates;
        let p = problem.scene.parameters.as_slice();
        return Ok(system.has_power().then(|| Box::new(move |_, y: &[f64]| system.power(p, &y[..n], &y[n..])) as _));
    }
    // A motion that keeps its energy has no load without a potential that works.
    if problem.shown.states_outputs || system.has_energy_gradient() {
        return Ok(None);
    }
    let whole = code(problem.mechanism, &Formulation::Kane.into(), None, Ready::AsDerived)?;
    let (p, n) = (problem.shown.parameters.as_slice(), problem.shown.q.len());
    Ok(whole.system().has_power().then(|| {
        Box::new(move |t, y: &[f64]| {
            let state = problem.state(t, y);
            whole.system().power(p, &state[..n], &state[n..])
        }) as _
    }))
}

/// Function for the power whose work a run accumulates, W. With contacts there is always one, at least zero, since
/// impacts add to the work.
///
/// # Errors
/// Errors of [`power`].
pub fn accounted<'a>(problem: &'a Problem<'_>) -> Result<Option<Power<'a>>, Error> {
    let power = power(problem)?;
    Ok(if problem.scene.impacts.is_empty() { power } else { power.or_else(|| Some(Box::new(|_, _: &[f64]| 0.0))) })
}
