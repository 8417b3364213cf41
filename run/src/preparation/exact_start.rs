//! Generalized speeds at the start of a scene, computed in numbers of 32 digits.
//!
//! Invariant: no number of the scene file is rounded to a double before it is used here. Momenta, and
//! angles near a singular surface, are small differences of large numbers. Rounding would destroy them.

use crate::code::compile_tape;
use crate::error::Error;
use tripos_derive::Model;
use tripos_derive::algebra::Expr;
use tripos_derive::scene::{ExactStart, InitialMotion};
use tripos_traits::DoubleDouble;

/// Computes the generalized speeds at the start of a scene to 32 digits, in the order of the model.
///
/// # Errors
/// [`Error::Request`] if the definition of a speed contains a symbol that has no value at the
/// start.
pub fn exact_start_speeds(model: &Model, exact: &ExactStart) -> Result<Vec<DoubleDouble>, Error> {
    match &exact.motion {
        InitialMotion::Speeds(u) => Ok(u.clone()),
        InitialMotion::Rates(rates) => {
            let inputs = [model.p(), model.q(), model.q_dot()].concat();
            let definitions: Vec<Expr> = model.speeds.iter().map(|s| s.definition).collect();
            let tape = compile_tape(&model.arena, &inputs, &definitions, "a generalized speed")?.to();
            Ok(tape.evaluate(&[&exact.parameters[..], &exact.q, rates].concat()))
        }
    }
}

/// Returns the symbols that have a value at the start of a scene, and their values to 32 digits, in
/// the same order. The symbols are the parameters, coordinates and generalized speeds. The rates q̇
/// follow if the scene file states rates.
///
/// # Errors
/// `Error::Request` if the definition of a speed contains a symbol that has no value at the start.
pub fn symbols_known_at_start(model: &Model, exact: &ExactStart) -> Result<(Vec<Expr>, Vec<DoubleDouble>), Error> {
    let mut symbols = [model.p(), model.q(), model.u()].concat();
    let mut values = [&exact.parameters[..], &exact.q, &exact_start_speeds(model, exact)?].concat();
    if let InitialMotion::Rates(rates) = &exact.motion {
        symbols.extend(model.q_dot());
        values.extend(rates);
    }
    Ok((symbols, values))
}
