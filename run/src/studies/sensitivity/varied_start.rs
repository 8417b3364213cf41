//! Derivatives of the start of a run, and of its parameters, by one varied number of the scene.
//!
//! A start may depend on a number in many ways: by formulas, by closed loops, or by speeds that are
//! computed from rates. Its derivative is a difference of starts in 32 digits, of order 4 in the step.
//! This difference has about 20 correct digits, so the derivative is accurate to double precision.

use super::contacts::held_contact_forces::VariedNumber;
use super::difference::{CENTRAL, FORWARD, STEP, derivative_by_rule};
use crate::error::Error;
use crate::preparation::problem::Problem;
use tripos_derive::diagnostic::Diagnostics;
use tripos_derive::model::Unit;
use tripos_derive::scene::{ImpactContact, Scene, SceneNeighbours};
use tripos_traits::{DoubleDouble, Real, Scalar};

/// Varied number of a scene, with the derivatives of the parameters and of the start by this number.
#[derive(Clone)]
pub struct VariedStart {
    /// Name of the varied number.
    pub name: String,
    /// Unit of the varied number.
    pub unit: Unit,
    /// Derivatives of the parameters by the varied number, in the order of the model.
    pub parameters: Vec<f64>,
    /// Derivatives of the integrated state (q, v) at the start by the varied number.
    pub state: Vec<f64>,
    /// Derivative of each contact's coefficient of restitution by the varied number.
    pub restitutions: Vec<f64>,
    /// Derivative of each contact's coefficient of friction by the varied number; 0 for a contact without
    /// friction.
    pub frictions: Vec<f64>,
    /// True if the span of the scene, its first or last instant, changes with the varied number.
    pub moves_span: bool,
}

impl VariedStart {
    /// Computes the derivatives of the start and the parameters by the number with the given name. `set`
    /// has the names and values of the numbers that differ from the scene file.
    ///
    /// # Errors
    /// [`Error::Input`] if the name is neither a parameter nor a number of the start, or if no
    /// neighbouring scene exists.
    pub fn new(problem: &Problem<'_>, set: &[(String, f64)], name: &str) -> Result<Self, Error> {
        let mut nearby = SceneNeighbours::new(problem.scene, problem.mechanism, set, name)?;
        let (value, unit) = (nearby.value(), nearby.unit());
        let size = value.to_f64().abs();
        let step = DoubleDouble::from_f64(STEP * if size > 0.0 { size } else { 1.0 });
        let mut at = |offset: i32| nearby.at(value + step * DoubleDouble::int(i64::from(offset)));
        let (scenes, rule) = scenes_of_varied_starts(&mut at)?;
        let start = |scene: &Scene| {
            let restitutions = scene.impacts.iter().map(|impact| impact.restitution_extended);
            let friction =
                |impact: &ImpactContact| impact.friction.as_ref().map(|friction| friction.coefficient_extended);
            let frictions = scene.impacts.iter().map(|impact| friction(impact).unwrap_or(DoubleDouble::int(0)));
            let coefficients = restitutions.chain(frictions).collect();
            problem.with_scene(scene).extended_start().map(|(p, y)| [p, y, coefficients].concat())
        };
        let list = scenes.iter().map(start).collect::<Result<Vec<_>, _>>()?;
        let mut parameters = derivative_by_rule(&list, rule, step);
        let mut state = parameters.split_off(problem.scene.parameters.len());
        let contacts = problem.scene.impacts.len();
        let mut restitutions = state.split_off(state.len() - 2 * contacts);
        let frictions = restitutions.split_off(contacts);
        let span = scenes[0].span;
        let moves_span = scenes.iter().any(|scene| scene.span != span);
        Ok(Self { name: name.to_owned(), unit, parameters, state, restitutions, frictions, moves_span })
    }

    /// Checks that the varied number does not raise a coefficient of friction from 0, where the direction
    /// of friction is not known.
    ///
    /// # Errors
    /// [`Error::Request`] with the reason if the derivative does not exist.
    pub fn check_friction_from_zero(&self, scene: &Scene) -> Result<(), Error> {
        let is_zero =
            |impact: &ImpactContact| impact.friction.as_ref().is_some_and(|friction| friction.coefficient == 0.0);
        let found = scene.impacts.iter().zip(&self.frictions).find(|(impact, by)| is_zero(impact) && **by != 0.0);
        found.map_or(Ok(()), |(impact, _)| {
            let what = format!(
                "`{}` changes the friction of the contact `{}` from 0 on, where it has no derivative",
                self.name, impact.name
            );
            Err(Error::request(what, "give it a coefficient above 0"))
        })
    }

    /// Returns the varied number with the derivatives of the parameters and of the coefficients of
    /// contacts.
    pub fn as_varied_number(&self) -> VariedNumber<'_> {
        let Self { name, parameters, restitutions, frictions, .. } = self;
        VariedNumber { name, parameters, restitutions, frictions }
    }
}

/// Scenes at the positions of a difference rule, and this rule as pairs: a position in steps, and twelve
/// times its weight.
type NeighbouringScenes = (Vec<Scene>, &'static [(i32, i64)]);

/// Makes the scenes at the positions of a difference rule. The rule is central, or one-sided if the
/// number cannot be lowered. `at` makes the scene for a given number of steps.
///
/// # Errors
/// `Error` if neither rule is possible.
fn scenes_of_varied_starts(at: &mut dyn FnMut(i32) -> Result<Scene, Diagnostics>) -> Result<NeighbouringScenes, Error> {
    let mut by = |rule: &'static [(i32, i64)], side: i32| -> Result<Vec<Scene>, Diagnostics> {
        rule.iter().map(|(place, _)| at(side * place)).collect()
    };
    match by(&CENTRAL, 1) {
        Ok(list) => Ok((list, &CENTRAL)),
        // The number is at the lower edge of its range.
        Err(error) => Ok((by(&FORWARD, 1).map_err(|_| error)?, &FORWARD)),
    }
}
