//! Check that every motion has inertia if some parameters are 0.
//!
//! If parameters are 0, the mass matrix may be singular in every configuration, and a quotient by its determinant has
//! no meaning. Only the set of parameters that are 0 matters, not the values of the others.

use crate::algebra::term::calculus::Substitution;
use crate::algebra::value::rank::rank;
use crate::algebra::{Arena, Expr, Rational};
use crate::mechanics::derivation::{Derivation, derive};
use crate::mechanics::equations::Equations;
use crate::mechanics::error::DeriveError;
use crate::mechanics::formulations::formulation::Formulation;
use crate::model::Model;
use rustc_hash::{FxHashMap, FxHashSet};
use std::sync::{Mutex, PoisonError};

/// Check of inertia for many sets of values of one model's parameters. Kane's equations are derived once, and only if a
/// parameter on which inertia can depend is 0.
pub struct InertiaCheck<'a> {
    model: &'a Model,
    inertial: Vec<bool>,
    known: Mutex<Known>,
}

#[derive(Default)]
struct Known {
    kane: Option<Derivation>,
    /// Results of earlier checks, by the indices of the parameters that are 0.
    answers: FxHashMap<Vec<usize>, Result<(), DeriveError>>,
}

impl<'a> InertiaCheck<'a> {
    /// Makes the check for this model without a derivation.
    #[must_use]
    pub fn new(model: &'a Model) -> Self {
        Self { model, inertial: inertial(model), known: Mutex::default() }
    }

    /// Checks that every motion has inertia at these values, one for each parameter; `None` for a parameter that stays
    /// a letter.
    ///
    /// # Errors
    /// [`DeriveError::NoInertiaAt`] if a speed moves no mass; another [`DeriveError`] if Kane's equations cannot be
    /// derived.
    pub fn at(&self, values: &[Option<Rational>]) -> Result<(), DeriveError> {
        let absent = absent(&self.inertial, values);
        if absent.is_empty() {
            return Ok(());
        }
        let mut known = self.known.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(answer) = known.answers.get(&absent) {
            return answer.clone();
        }
        let kane = match known.kane.take() {
            Some(kane) => kane,
            None => derive(self.model, Formulation::Kane)?,
        };
        let answer = without(&kane.arena, &kane.equations, self.model, &absent);
        known.kane = Some(kane);
        known.answers.insert(absent, answer.clone());
        answer
    }
}

/// Checks exactly that every motion has inertia at these values of the parameters, one for each parameter. `kane` are
/// Kane's equations of the model, with their terms in `arena`.
///
/// # Errors
/// [`DeriveError::NoInertiaAt`] if a speed moves no mass.
pub fn has_inertia_at(
    arena: &Arena,
    kane: &Equations,
    model: &Model,
    values: &[Option<Rational>],
) -> Result<(), DeriveError> {
    let absent = absent(&inertial(model), values);
    if absent.is_empty() { Ok(()) } else { without(arena, kane, model, &absent) }
}

/// For each parameter, true if inertia can depend on it: parameters of masses, inertias, positions, rotations,
/// constraints and definitions of speeds.
fn inertial(model: &Model) -> Vec<bool> {
    let bodies = model.bodies.iter().flat_map(|body| {
        let tensor = body.rigid.iter().flat_map(|(_, inertia)| inertia.tensor.iter().flatten().copied());
        tensor.chain([body.mass])
    });
    let points = model.points.iter().filter_map(|point| point.position).flat_map(|placement| placement.components);
    let turns = model.frames.iter().filter_map(|frame| frame.rotation.as_ref()).flat_map(|(_, turn)| turn.terms());
    let constraints = model.constraints.iter().flat_map(|constraint| [constraint.equation, constraint.value]);
    let speeds = model.speeds.iter().map(|speed| speed.definition);
    let rates = model.kinematic_equations.rates.iter().copied();
    let roots: Vec<Expr> = bodies.chain(points).chain(turns).chain(constraints).chain(speeds).chain(rates).collect();
    let reached: FxHashSet<Expr> = model.arena.reachable(&roots).into_iter().collect();
    model.parameters.iter().map(|parameter| reached.contains(&parameter.symbol)).collect()
}

/// Indices of the parameters that are 0 and on which inertia can depend.
fn absent(inertial: &[bool], values: &[Option<Rational>]) -> Vec<usize> {
    let is_zero = |value: &Option<Rational>| value.as_ref().is_some_and(Rational::is_zero);
    let each = inertial.iter().zip(values).enumerate();
    each.filter(|(_, (inertial, value))| **inertial && is_zero(value)).map(|(at, _)| at).collect()
}

/// Checks that every motion has inertia if the parameters of these indices are 0.
fn without(arena: &Arena, kane: &Equations, model: &Model, absent: &[usize]) -> Result<(), DeriveError> {
    let mut arena = arena.clone();
    let pairs: Vec<(Expr, Expr)> = absent.iter().map(|at| (model.parameters[*at].symbol, Expr::ZERO)).collect();
    let mut put = Substitution::new(&pairs);
    let matrix: Vec<Vec<Expr>> =
        kane.matrix.iter().map(|row| row.iter().map(|e| put.apply(&mut arena, *e)).collect()).collect();
    // A term that divides by a parameter that is 0 tells nothing about inertia.
    if put.undefined.is_some() {
        return Ok(());
    }
    match rank(&arena, &matrix).and_then(|rank| rank.dependent) {
        Some(row) => Err(DeriveError::NoInertiaAt {
            speed: model.speeds[row].name.clone(),
            zero: absent.iter().map(|at| model.parameters[*at].name.clone()).collect(),
        }),
        None => Ok(()),
    }
}
