//! Start of the reduced equations of a scene, computed from the start of the whole model.

use super::exact_start::{StartNumbers, StartSpeeds};
use super::moving_frame_start::SectionMotion;
use crate::code::compile_tape;
use crate::error::Error;
use tripos_derive::Model;
use tripos_derive::algebra::Expr;
use tripos_derive::algebra::value::tape::{Numeric, Tape};
use tripos_derive::reduce::Reduction;
use tripos_derive::scene::{EnclosedStart, ExactStart, InitialMotion};
use tripos_traits::{Ball, DoubleDouble};

/// Compiled functions that compute the start of reduced equations, to 32 digits, for scenes that differ only in their
/// numbers.
pub struct ReducedStart {
    /// Functions without the moving frame.
    plain: PlainStart<DoubleDouble>,
    /// Symmetries of the moving frame; `None` without a frame.
    section: Option<SectionMotion>,
    /// Number of parameters of the whole model.
    parameters: usize,
}

impl ReducedStart {
    /// Compiles the start of reduced equations for scenes of a model. `exact` is the start of one of these scenes.
    ///
    /// # Errors
    /// [`Error::Request`] if a variable depends on a symbol that has no value at the start.
    pub fn new(reduction: &Reduction, model: &Model, exact: &ExactStart) -> Result<Self, Error> {
        let states = [model.p(), model.q(), model.u()].concat();
        let section = reduction.frame.as_ref().map(|frame| SectionMotion::new(reduction.arena(), frame, &states));
        Ok(Self {
            plain: PlainStart::new(reduction, model, &exact.motion)?,
            section: section.transpose()?,
            parameters: model.parameters.len(),
        })
    }

    /// Computes the parameters, coordinates and motion variables of the reduced system at the start of a
    /// scene. `exact` is the start in the variables of the whole model.
    ///
    /// # Errors
    /// [`Error::Stopped`] if the start cannot be moved to the section of the moving frame.
    pub fn evaluate(&self, exact: &ExactStart) -> Result<[Vec<DoubleDouble>; 3], Error> {
        let mut values = self.plain.known_values(exact.into());
        if let Some(section) = &self.section {
            let states = values.split_off(self.parameters);
            let moved = section.move_to_section(&values, &states)?;
            values.extend(moved);
        }
        Ok(self.plain.variables(&values))
    }
}

/// Computes the parameters, coordinates and motion variables of a reduced system without a moving frame at the start
/// of a scene, in balls that contain them.
///
/// # Errors
/// `Error::Request` if a symbol has no value at the start.
pub fn enclosed_reduced_start(
    reduction: &Reduction,
    model: &Model,
    start: &EnclosedStart,
) -> Result<[Vec<Ball>; 3], Error> {
    let plain = PlainStart::new(reduction, model, &start.motion)?;
    Ok(plain.variables(&plain.known_values(start.into())))
}

/// Compiled functions that compute the variables of a reduced system at the start of a scene.
struct PlainStart<S> {
    /// Generalized speeds of the whole model at the start.
    speeds: StartSpeeds<S>,
    /// Program that computes the parameters, coordinates and motion variables of the reduced system.
    variables: Tape<S>,
    /// Numbers of parameters and of coordinates of the reduced system.
    lengths: (usize, usize),
    /// True if the program also takes the rates q̇, which a scene may state.
    takes_rates: bool,
}

impl<S: Numeric> PlainStart<S> {
    /// Compiles the functions for scenes that state the same kind of motion as `motion`: speeds or rates.
    ///
    /// # Errors
    /// `Error::Request` if a variable depends on a symbol that has no value at the start.
    fn new(reduction: &Reduction, model: &Model, motion: &InitialMotion<S>) -> Result<Self, Error> {
        // Rates in the scene file belong to the start before it is moved along symmetries. The generalized
        // speeds contain the same information, so the rates are dropped.
        let takes_rates = matches!(motion, InitialMotion::Rates(_)) && reduction.frame.is_none();
        let mut symbols = [model.p(), model.q(), model.u()].concat();
        if takes_rates {
            symbols.extend(model.q_dot());
        }
        let free = reduction.model.parameters.len() - reduction.constants.len();
        let equations = &reduction.derivation.equations;
        let variables = || reduction.states.iter().chain(&reduction.quadratures);
        let of_start = |symbol: &Expr| variables().find(|q| q.symbol == *symbol).map_or(*symbol, |q| q.of_start);
        let mut wanted: Vec<Expr> = reduction.model.parameters[..free].iter().map(|p| p.symbol).collect();
        wanted.extend(reduction.constants.iter().map(|constant| constant.of_start));
        wanted.extend(equations.coordinates.iter().chain(&equations.variables).map(of_start));
        let tape = compile_tape(reduction.arena(), &symbols, &wanted, "the start of a reduced variable")?;
        Ok(Self {
            speeds: StartSpeeds::new(model, motion)?,
            variables: tape.to(),
            lengths: (reduction.model.parameters.len(), equations.coordinates.len()),
            takes_rates,
        })
    }

    /// Values at a start that the functions take: the parameters, coordinates and generalized speeds of the whole
    /// model, then the rates q̇ if they are needed.
    fn known_values(&self, exact: StartNumbers<'_, S>) -> Vec<S> {
        let mut values = [exact.parameters, exact.q, &self.speeds.evaluate(exact)].concat();
        if let (InitialMotion::Rates(rates), true) = (exact.motion, self.takes_rates) {
            values.extend(rates);
        }
        values
    }

    /// Computes the parameters, coordinates and motion variables of the reduced system.
    fn variables(&self, known: &[S]) -> [Vec<S>; 3] {
        let mut parameters = self.variables.evaluate(known);
        let mut q = parameters.split_off(self.lengths.0);
        let v = q.split_off(self.lengths.1);
        [parameters, q, v]
    }
}
