//! Check that every speed moves a mass although some parameters of a model are 0.
//!
//! If parameters are 0, the mass matrix may be singular in every configuration, and a quotient by its determinant has
//! no meaning. Only the set of parameters that are 0 matters. The values of the other parameters do not.

use crate::algebra::term::calculus::Substitution;
use crate::algebra::value::rank::rank;
use crate::algebra::{Arena, Expr, Rational};
use crate::mechanics::derivation::{Derivation, derive};
use crate::mechanics::derive_error::DeriveError;
use crate::mechanics::equations::Equations;
use crate::mechanics::formulations::formulation::Formulation;
use crate::model::Model;
use rustc_hash::{FxHashMap, FxHashSet};
use std::sync::{Mutex, PoisonError};

/// Check that every speed moves a mass, for many sets of parameter values of a model. Kane's equations are derived at
/// most once, and only if a parameter on which inertia can depend is 0.
pub struct InertiaCheck<'a> {
    /// Model whose parameters are checked.
    model: &'a Model,
    /// For each parameter of the model: true if inertia can depend on it.
    inertial: Vec<bool>,
    /// Kane's equations and earlier answers, shared between threads.
    known: Mutex<KnownInertiaChecks>,
}

/// Results that an inertia check keeps for later calls.
#[derive(Default)]
struct KnownInertiaChecks {
    /// Kane's equations; `None` until they are first needed.
    kane: Option<Derivation>,
    /// Results of earlier checks, by the indices of the parameters that are 0.
    answers: FxHashMap<Vec<usize>, Result<(), DeriveError>>,
}

impl<'a> InertiaCheck<'a> {
    /// Creates the check for a model; nothing is derived yet.
    #[must_use]
    pub fn new(model: &'a Model) -> Self {
        Self { model, inertial: parameters_that_affect_inertia(model), known: Mutex::default() }
    }

    /// Checks that every speed moves a mass at the given values, one for each parameter. `None` is for a parameter
    /// that stays symbolic.
    ///
    /// # Errors
    /// Returns [`DeriveError::NoInertiaAt`] if a speed moves no mass. Returns another [`DeriveError`] if Kane's
    /// equations cannot be derived.
    pub fn at(&self, values: &[Option<Rational>]) -> Result<(), DeriveError> {
        let absent = zero_parameters_that_affect_inertia(&self.inertial, values);
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
        let answer = check_inertia_without_parameters(&kane.arena, &kane.equations, self.model, &absent);
        known.kane = Some(kane);
        known.answers.insert(absent, answer.clone());
        answer
    }
}

/// Checks exactly that every speed moves a mass at the given values, one for each parameter. `None` is for a
/// parameter that stays symbolic. `kane` are Kane's equations of the model, with their terms in `arena`.
///
/// # Errors
/// Returns [`DeriveError::NoInertiaAt`] if a speed moves no mass.
pub fn check_inertia_at(
    arena: &Arena,
    kane: &Equations,
    model: &Model,
    values: &[Option<Rational>],
) -> Result<(), DeriveError> {
    let absent = zero_parameters_that_affect_inertia(&parameters_that_affect_inertia(model), values);
    if absent.is_empty() { Ok(()) } else { check_inertia_without_parameters(arena, kane, model, &absent) }
}

/// For each parameter: true if inertia can depend on it. It can if the parameter occurs in masses, inertias,
/// positions, rotations, constraints or definitions of speeds.
fn parameters_that_affect_inertia(model: &Model) -> Vec<bool> {
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
fn zero_parameters_that_affect_inertia(inertial: &[bool], values: &[Option<Rational>]) -> Vec<usize> {
    let is_zero = |value: &Option<Rational>| value.as_ref().is_some_and(Rational::is_zero);
    let each = inertial.iter().zip(values).enumerate();
    each.filter(|(_, (inertial, value))| **inertial && is_zero(value)).map(|(at, _)| at).collect()
}

/// Checks that the mass matrix keeps full rank if the parameters with the indices `absent` are 0.
///
/// # Errors
/// Returns `DeriveError::NoInertiaAt` with the first speed whose row depends on the rows before it.
fn check_inertia_without_parameters(
    arena: &Arena,
    kane: &Equations,
    model: &Model,
    absent: &[usize],
) -> Result<(), DeriveError> {
    let mut arena = arena.clone();
    let pairs: Vec<(Expr, Expr)> = absent.iter().map(|at| (model.parameters[*at].symbol, Expr::ZERO)).collect();
    let mut put = Substitution::new(&pairs);
    let matrix: Vec<Vec<Expr>> =
        kane.matrix.iter().map(|row| row.iter().map(|e| put.apply(&mut arena, *e)).collect()).collect();
    // If a term divides by a parameter that is 0, the check cannot decide and passes.
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
