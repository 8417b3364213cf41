//! Generalized speeds at the start of a scene, computed in numbers of 32 digits or in balls that contain them.
//!
//! Invariant: no number of the scene file is rounded to a double before it is used here. Momenta, and
//! angles near a singular surface, are small differences of large numbers. Rounding would destroy them.

use crate::code::compile_tape;
use crate::error::Error;
use tripos_derive::Model;
use tripos_derive::algebra::Expr;
use tripos_derive::algebra::value::tape::Numeric;
use tripos_derive::scene::{EnclosedStart, ExactStart, InitialMotion};
use tripos_traits::{Ball, DoubleDouble};

/// Parameters, coordinates and motion at the start of a scene, in numbers of the type `S`.
#[derive(Clone, Copy)]
pub struct StartNumbers<'a, S> {
    /// Values of the parameters, in the order of the model.
    pub parameters: &'a [S],
    /// Values of the coordinates, in the order of the model.
    pub q: &'a [S],
    /// Generalized speeds or rates, as the scene states them.
    pub motion: &'a InitialMotion<S>,
}

impl<'a> From<&'a ExactStart> for StartNumbers<'a, DoubleDouble> {
    fn from(start: &'a ExactStart) -> Self {
        Self { parameters: &start.parameters, q: &start.q, motion: &start.motion }
    }
}

impl<'a> From<&'a EnclosedStart> for StartNumbers<'a, Ball> {
    fn from(start: &'a EnclosedStart) -> Self {
        Self { parameters: &start.parameters, q: &start.q, motion: &start.motion }
    }
}

/// Computes the generalized speeds at the start of a scene, in the order of the model.
///
/// # Errors
/// [`Error::Request`] if the definition of a speed contains a symbol that has no value at the
/// start.
pub fn exact_start_speeds<S: Numeric>(model: &Model, exact: StartNumbers<'_, S>) -> Result<Vec<S>, Error> {
    match exact.motion {
        InitialMotion::Speeds(u) => Ok(u.clone()),
        InitialMotion::Rates(rates) => {
            let inputs = [model.p(), model.q(), model.q_dot()].concat();
            let definitions: Vec<Expr> = model.speeds.iter().map(|s| s.definition).collect();
            let tape = compile_tape(&model.arena, &inputs, &definitions, "a generalized speed")?.to();
            Ok(tape.evaluate(&[exact.parameters, exact.q, rates].concat()))
        }
    }
}

/// Returns the symbols that have a value at the start of a scene, and their values, in the same order. The symbols are
/// the parameters, coordinates and generalized speeds. The rates q̇ follow if the scene file states rates.
///
/// # Errors
/// `Error::Request` if the definition of a speed contains a symbol that has no value at the start.
pub fn symbols_known_at_start<S: Numeric>(
    model: &Model,
    exact: StartNumbers<'_, S>,
) -> Result<(Vec<Expr>, Vec<S>), Error> {
    let mut symbols = [model.p(), model.q(), model.u()].concat();
    let mut values = [exact.parameters, exact.q, &exact_start_speeds(model, exact)?].concat();
    if let InitialMotion::Rates(rates) = exact.motion {
        symbols.extend(model.q_dot());
        values.extend(rates);
    }
    Ok((symbols, values))
}
