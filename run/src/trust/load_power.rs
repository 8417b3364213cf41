//! Power of the loads that have no potential, along a run by any set of equations.

use crate::code::{CodePreparation, runnable_code};
use crate::error::Error;
use crate::preparation::problem::{Power, Problem};
use tripos_derive::Formulation;

/// Makes the function that computes the power, W, of the loads without a potential. Their work changes
/// T + V along a run. `None` if no such load exists, or if the run shows no energies.
///
/// A run by reduced equations shows the energies of the whole model. Its power is computed by Kane's
/// equations at the shown state.
///
/// # Errors
/// [`Error`] if the model has no Kane's equations.
pub fn load_power<'a>(problem: &'a Problem<'_>) -> Result<Option<Power<'a>>, Error> {
    let system = problem.system();
    if !problem.by.is_reduced() {
        let n = system.lengths().coordinates;
        let p = problem.scene.parameters.as_slice();
        return Ok(system.has_power().then(|| Box::new(move |_, y: &[f64]| system.power(p, &y[..n], &y[n..])) as _));
    }
    // A motion that conserves its energy has no working load without a potential.
    if problem.shown.states_outputs || system.has_energy_gradient() {
        return Ok(None);
    }
    let whole = runnable_code(problem.mechanism, &Formulation::Kane.into(), None, CodePreparation::AsDerived)?;
    let (p, n) = (problem.shown.parameters.as_slice(), problem.shown.q.len());
    Ok(whole.system().has_power().then(|| {
        Box::new(move |t, y: &[f64]| {
            let state = problem.shown_state(t, y);
            whole.system().power(p, &state[..n], &state[n..])
        }) as _
    }))
}

/// Makes the function that computes the power, W, whose work a run accumulates. `None` if there is no
/// such power. In a scene with contacts there is always a function, at least the constant zero, because
/// impacts add to the work.
///
/// # Errors
/// Errors of [`load_power`].
pub fn accumulated_load_power<'a>(problem: &'a Problem<'_>) -> Result<Option<Power<'a>>, Error> {
    let power = load_power(problem)?;
    Ok(if problem.scene.impacts.is_empty() { power } else { power.or_else(|| Some(Box::new(|_, _: &[f64]| 0.0))) })
}
