//! Generalized speeds at the start of a scene, computed in numbers of 32 digits or in balls that contain them.
//!
//! Invariant: no number of the scene file is rounded to a double before it is used here. Momenta, and
//! angles near a singular surface, are small differences of large numbers. Rounding would destroy them.

use crate::code::compile_tape;
use crate::error::Error;
use tripos_derive::Model;
use tripos_derive::algebra::Expr;
use tripos_derive::algebra::value::tape::{Numeric, Tape};
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
    Ok(StartSpeeds::new(model, exact.motion)?.evaluate(exact))
}

/// Compiled functions that compute the generalized speeds at the start of scenes of a model.
pub struct StartSpeeds<S> {
    /// Program that computes the speeds from the parameters, q and q̇. `None` if the scenes state the speeds.
    definitions: Option<Tape<S>>,
}

impl<S: Numeric> StartSpeeds<S> {
    /// Compiles the functions for scenes that state the same kind of motion as `motion`: speeds or rates.
    ///
    /// # Errors
    /// [`Error::Request`] if the definition of a speed contains a symbol that has no value at the
    /// start.
    pub fn new(model: &Model, motion: &InitialMotion<S>) -> Result<Self, Error> {
        let definitions = match motion {
            InitialMotion::Speeds(_) => None,
            InitialMotion::Rates(_) => {
                let inputs = [model.p(), model.q(), model.q_dot()].concat();
                let definitions: Vec<Expr> = model.speeds.iter().map(|s| s.definition).collect();
                Some(compile_tape(&model.arena, &inputs, &definitions, "a generalized speed")?.to())
            }
        };
        Ok(Self { definitions })
    }

    /// Computes the generalized speeds at a start, in the order of the model.
    pub fn evaluate(&self, exact: StartNumbers<'_, S>) -> Vec<S> {
        match (exact.motion, &self.definitions) {
            (InitialMotion::Rates(rates), Some(tape)) => tape.evaluate(&[exact.parameters, exact.q, rates].concat()),
            (InitialMotion::Speeds(values) | InitialMotion::Rates(values), _) => values.clone(),
        }
    }
}
