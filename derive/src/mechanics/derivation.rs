//! Deriving a model: one formulation, one with its steps, or all of them over one store of terms.

use super::budget::check_terms;
use super::equations::{Equations, complete};
use super::error::DeriveError;
use super::formulations::formulation::Formulation;
use super::motion::kinematics::Kinematics;
use super::rows::{RowName, Step};
use crate::algebra::text::definitions::{adopt, write_down, written};
use crate::algebra::value::rank::rank;
use crate::algebra::{Arena, Expr};
use crate::model::Model;
use rustc_hash::FxHashSet;

/// One formulation of a model, with the store of its terms.
#[derive(Clone)]
pub struct Derivation {
    /// The terms of `equations`.
    pub arena: Arena,
    /// The equations.
    pub equations: Equations,
}

impl Derivation {
    /// Gives the named terms of the equations the names that every document about the model uses. For a formulation
    /// other than Kane's, only terms that Kane's equations lack are named after it.
    pub fn write_names(&mut self) {
        write_names(&mut self.arena, self.equations.formulation, &self.equations);
    }
}

/// One formulation of a model as a textbook shows it, with the store of its terms.
#[derive(Clone)]
pub struct DerivationInSteps {
    /// The terms of `equations` and `steps`.
    pub arena: Arena,
    /// The equations.
    pub equations: Equations,
    /// Steps from which the equations come, in order.
    pub steps: Vec<Step>,
}

/// All formulations of a model over one store of terms, so that they can be compared.
pub struct Derivations {
    /// The kinematics that they share, with the store of all terms.
    pub kinematics: Kinematics,
    /// Each formulation with its equations, or the reason why it cannot be derived.
    pub list: Vec<(Formulation, Result<Equations, DeriveError>)>,
}

impl Derivations {
    /// The equations by one method, if it is possible.
    #[must_use]
    pub fn get(&self, formulation: Formulation) -> Option<&Equations> {
        self.result(formulation).ok()
    }

    /// Gives the named terms of all equations the names that every document about the model uses: Kane's, then those
    /// that only others have.
    pub fn write_names(&mut self) {
        for (formulation, equations) in &self.list {
            if let Ok(equations) = equations {
                write_names(&mut self.kinematics.arena, *formulation, equations);
            }
        }
    }

    /// The equations by one method.
    ///
    /// # Errors
    /// [`DeriveError`] if this method cannot be used.
    pub fn result(&self, formulation: Formulation) -> Result<&Equations, DeriveError> {
        let found = self.list.iter().find(|(f, _)| *f == formulation);
        found.map_or(Err(DeriveError::NotLinear), |(_, equations)| equations.as_ref().map_err(Clone::clone))
    }
}

/// Derives the equations of motion of a model.
///
/// # Errors
/// [`DeriveError`]; ask [`DeriveError::is_unsupported`] whether another formulation may succeed.
pub fn derive(model: &Model, formulation: Formulation) -> Result<Derivation, DeriveError> {
    let mut kinematics = Kinematics::new(model)?;
    let equations = derive_with(model, &mut kinematics, formulation)?;
    Ok(Derivation { arena: kinematics.arena, equations })
}

/// Derives the equations of motion of a model, and shows what they come from, step by step.
///
/// # Errors
/// As [`derive()`].
pub fn derive_in_steps(model: &Model, formulation: Formulation) -> Result<DerivationInSteps, DeriveError> {
    let mut kinematics = Kinematics::new(model)?;
    let equations = derive_with(model, &mut kinematics, formulation)?;
    let steps = (formulation.method().steps)(model, &mut kinematics)?;
    let mut arena = kinematics.arena;
    // Inverse dynamics is code, and no part of what is shown.
    let equations = Equations { required: Vec::new(), ..equations };
    if formulation != REFERENCE {
        if arena.has_names() {
            adopt(&mut arena, &with_names(model, formulation)?);
        }
        write_names(&mut arena, formulation, &equations);
    }
    Ok(written_down(arena, &equations, steps))
}

/// The terms of all formulations up to this one over one store, with the names that every document about the model has.
fn with_names(model: &Model, formulation: Formulation) -> Result<Arena, DeriveError> {
    let mut kinematics = Kinematics::new(model)?;
    let mut list = Vec::new();
    for f in Formulation::ALL.into_iter().filter(|f| *f <= formulation) {
        list.push((f, derive_with(model, &mut kinematics, f)));
    }
    let mut all = Derivations { kinematics, list };
    all.write_names();
    Ok(all.kinematics.arena)
}

/// The formulation whose named terms have plain names in every document; others put their own name into theirs.
const REFERENCE: Formulation = Formulation::Kane;

/// Gives the named terms of these equations their names.
fn write_names(arena: &mut Arena, formulation: Formulation, equations: &Equations) {
    // Inverse dynamics is code, and no part of what is shown.
    let equations = Equations { required: Vec::new(), ..equations.clone() };
    if formulation == REFERENCE {
        let _ = equations.written(arena);
    } else {
        let terms = equations.terms(arena);
        write_down(arena, &formulation.name().replace('-', "_"), &terms);
    }
}

/// Equations and steps with a symbol for each name; what the symbols stand for is among the definitions.
fn written_down(mut arena: Arena, equations: &Equations, mut steps: Vec<Step>) -> DerivationInSteps {
    let mut equations = equations.written(&mut arena);
    let lines = || steps.iter().flat_map(|step| step.lines.iter());
    let values: Vec<Expr> = lines().map(|(_, value)| *value).collect();
    let (named, values) = written(&mut arena, &[], &values);
    let known: FxHashSet<Expr> = equations.definitions.iter().map(|definition| definition.symbol).collect();
    equations.definitions.extend(named.into_iter().filter(|definition| !known.contains(&definition.symbol)));
    let places = steps.iter_mut().flat_map(|step| &mut step.lines);
    for ((_, place), value) in places.zip(values) {
        *place = value;
    }
    DerivationInSteps { arena, equations, steps }
}

/// Derives the equations of motion of a model by every method.
///
/// # Errors
/// [`DeriveError`] if the model is wrong; a formulation that this model does not support is listed with its reason.
pub fn derive_all(model: &Model) -> Result<Derivations, DeriveError> {
    derive_all_with(model, Kinematics::new(model)?)
}

/// [`derive_all`] from kinematics in one form or the other: [`Kinematics::in_form`].
///
/// # Errors
/// As [`derive_all`].
pub fn derive_all_with(model: &Model, mut kinematics: Kinematics) -> Result<Derivations, DeriveError> {
    let mut list = Vec::new();
    for f in Formulation::ALL {
        match derive_with(model, &mut kinematics, f) {
            Err(error) if !error.is_unsupported() => return Err(error),
            result => list.push((f, result)),
        }
    }
    Ok(Derivations { kinematics, list })
}

/// The equations of one formulation over kinematics that others may share.
pub(crate) fn derive_with(
    model: &Model,
    kinematics: &mut Kinematics,
    formulation: Formulation,
) -> Result<Equations, DeriveError> {
    let rows = (formulation.method().derive)(model, kinematics)?;
    check_terms(model, &kinematics.arena)?;
    let equations = complete(model, kinematics, formulation, rows)?;
    match rank(&kinematics.arena, &equations.matrix).and_then(|rank| rank.dependent) {
        Some(row) => Err(singular(model, &equations.rows[row])),
        None => Ok(equations),
    }
}

/// The matrix is singular in every configuration: this row follows from those before it.
fn singular(model: &Model, row: &RowName) -> DeriveError {
    match row {
        RowName::Balance(_) | RowName::Power(_) => DeriveError::ReactionsDependent,
        RowName::Coordinate(_) => DeriveError::NoInertia { speed: format!("{}'", row.text(model)) },
        _ => DeriveError::NoInertia { speed: row.text(model) },
    }
}
