//! Derives the equations of motion of a model by one formulation, with or without intermediate steps, or by all
//! formulations in one arena.

use super::derivation_limits::check_term_limit;
use super::derive_error::DeriveError;
use super::equations::{Equations, equations_from_rows};
use super::formulations::formulation::Formulation;
use super::motion::equation_form::EquationForm;
use super::motion::kinematics::Kinematics;
use super::rows::{RowName, Step};
use crate::algebra::text::definitions::{adopt_definitions, define_names_in_part, write_definitions};
use crate::algebra::text::print::printed_length;
use crate::algebra::value::rank::rank;
use crate::algebra::{Arena, Expr};
use crate::model::Model;
use rustc_hash::FxHashSet;

/// Equations of motion of a model by one formulation, with the arena that holds their terms.
#[derive(Clone)]
pub struct Derivation {
    /// Arena that holds the terms of `equations`.
    pub arena: Arena,
    /// Equations of motion by the chosen formulation.
    pub equations: Equations,
}

impl Derivation {
    /// Gives the named terms of the equations their names, which are the same in every document about the model.
    /// Terms that Kane's equations also have get plain names. All other terms get a name that contains the
    /// formulation's name.
    pub fn write_names(&mut self) {
        write_names_of_derivation(&mut self.arena, self.equations.formulation, &self.equations);
    }
}

/// Equations of motion by one formulation, with the steps that a textbook shows, and the arena of
/// all terms.
#[derive(Clone)]
pub struct DerivationInSteps {
    /// Arena that holds the terms of `equations` and `steps`.
    pub arena: Arena,
    /// Equations of motion by the chosen formulation.
    pub equations: Equations,
    /// Intermediate results that lead to [`Self::equations`], such as velocities and energies, in the order of the
    /// derivation.
    pub steps: Vec<Step>,
}

/// Largest number of expression nodes for display in closed form: about two pages. It applies to M, f, T, V and all
/// definitions together.
const MOST_IN_ALL: usize = 2_000;

/// Largest number of expression nodes of a single formula for display in closed form: about twenty
/// lines.
const MOST_IN_ONE: usize = 500;

impl DerivationInSteps {
    /// True if M, f, T, V and the definitions are short enough to be read in closed form, without names for subterms.
    fn is_short(&self) -> bool {
        let Self { arena, equations: e, .. } = self;
        let scalars = [e.kinetic_energy, e.potential_energy];
        let definitions = e.definitions.iter().map(|definition| definition.value);
        let formulas = e.matrix.iter().flatten().chain(&e.forcing).copied().chain(scalars).chain(definitions);
        let lengths: Vec<usize> = formulas.map(|formula| printed_length(arena, formula)).collect();
        let total = lengths.iter().fold(0_usize, |sum, length| sum.saturating_add(*length));
        total <= MOST_IN_ALL && lengths.iter().all(|length| *length <= MOST_IN_ONE)
    }
}

/// Equations of a model by several formulations in one arena, so that their terms can be compared.
pub struct Derivations {
    /// Kinematics that all formulations share; it owns the arena of all terms.
    pub kinematics: Kinematics,
    /// Formulations in the order of derivation. Each has its equations, or the reason why they cannot be derived.
    pub list: Vec<(Formulation, Result<Equations, DeriveError>)>,
}

impl Derivations {
    /// Equations by the given formulation. `None` if the formulation is not listed or cannot be derived for this
    /// model.
    #[must_use]
    pub fn get(&self, formulation: Formulation) -> Option<&Equations> {
        self.result(formulation).ok()
    }

    /// Derives the model by a further formulation and appends the result to the list. Does nothing if the formulation
    /// is already listed. A formulation that the model does not support is listed with its error.
    ///
    /// # Errors
    /// Returns a [`DeriveError`] if the model itself is wrong.
    pub fn add(&mut self, model: &Model, formulation: Formulation) -> Result<(), DeriveError> {
        if self.list.iter().any(|(listed, _)| *listed == formulation) {
            return Ok(());
        }
        match derive_with(model, &mut self.kinematics, formulation) {
            Err(error) if !error.is_unsupported() => Err(error),
            result => {
                self.list.push((formulation, result));
                Ok(())
            }
        }
    }

    /// Gives the named terms of all equations their names, which are the same in every document about the model.
    /// Kane's terms are named first, then the terms that only other formulations have.
    pub fn write_names(&mut self) {
        for (formulation, equations) in &self.list {
            if let Ok(equations) = equations {
                write_names_of_derivation(&mut self.kinematics.arena, *formulation, equations);
            }
        }
    }

    /// Equations by the given formulation.
    ///
    /// # Errors
    /// Returns the [`DeriveError`] of a formulation that cannot be derived for this model. Returns
    /// `DeriveError::NotLinear` if the formulation is not listed.
    pub fn result(&self, formulation: Formulation) -> Result<&Equations, DeriveError> {
        let found = self.list.iter().find(|(f, _)| *f == formulation);
        found.map_or(Err(DeriveError::NotLinear), |(_, equations)| equations.as_ref().map_err(Clone::clone))
    }
}

/// Derives the equations of motion of a model by one formulation.
///
/// # Errors
/// Returns a [`DeriveError`] if the equations cannot be derived. If [`DeriveError::is_unsupported`] is true, another
/// formulation may succeed.
pub fn derive(model: &Model, formulation: Formulation) -> Result<Derivation, DeriveError> {
    let mut kinematics = Kinematics::new(model)?;
    let equations = derive_with(model, &mut kinematics, formulation)?;
    Ok(Derivation { arena: kinematics.arena, equations })
}

/// Derives the equations of motion of a model for display, with the steps that lead to them.
///
/// `form` chooses closed form or named terms. With `None`, the closed form is used if M, f, T and V then fit on about
/// two pages, otherwise named terms.
///
/// # Errors
/// Returns a [`DeriveError`], for the same reasons as [`derive()`].
pub fn derive_in_steps(
    model: &Model,
    formulation: Formulation,
    form: Option<EquationForm>,
) -> Result<DerivationInSteps, DeriveError> {
    let computed = EquationForm::computed(model);
    match form {
        Some(form) => derivation_in_form(model, formulation, form),
        None if computed == EquationForm::Steps && EquationForm::is_closed_tried(model) => {
            match derivation_in_form(model, formulation, EquationForm::Closed) {
                Ok(closed) if closed.is_short() => Ok(closed),
                Ok(_) | Err(DeriveError::TooLarge { .. }) => derivation_in_form(model, formulation, computed),
                Err(error) => Err(error),
            }
        }
        None => derivation_in_form(model, formulation, computed),
    }
}

/// Derives equations of motion and their steps in the given form: closed, or with named terms.
///
/// # Errors
/// Returns a `DeriveError` if the formulation cannot be derived for this model.
fn derivation_in_form(
    model: &Model,
    formulation: Formulation,
    form: EquationForm,
) -> Result<DerivationInSteps, DeriveError> {
    let mut kinematics = Kinematics::in_form(model, form)?;
    let equations = derive_with(model, &mut kinematics, formulation)?;
    let steps = (formulation.method().steps)(model, &mut kinematics)?;
    let mut arena = kinematics.arena;
    // Inverse dynamics appears only in generated code, so the steps do not show it.
    let equations = Equations { required: Vec::new(), ..equations };
    if formulation != REFERENCE {
        if arena.has_names() {
            adopt_definitions(&mut arena, &arena_with_derivation_names(model, formulation, form)?);
        }
        write_names_of_derivation(&mut arena, formulation, &equations);
    }
    Ok(derivation_with_definitions(arena, &equations, steps))
}

/// Derives all formulations up to and including the given one, and returns the arena of their terms. Its named terms
/// have the names that every document about the model uses. Returns an error if the kinematics cannot be derived.
fn arena_with_derivation_names(
    model: &Model,
    formulation: Formulation,
    form: EquationForm,
) -> Result<Arena, DeriveError> {
    let mut kinematics = Kinematics::in_form(model, form)?;
    let mut list = Vec::new();
    for f in Formulation::ALL.into_iter().filter(|f| *f <= formulation) {
        list.push((f, derive_with(model, &mut kinematics, f)));
    }
    let mut all = Derivations { kinematics, list };
    all.write_names();
    Ok(all.kinematics.arena)
}

/// Formulation whose named terms have plain names in every document: Kane. Names of other formulations' terms begin
/// with the formulation's name.
const REFERENCE: Formulation = Formulation::Kane;

/// Names the named terms in one formulation's equations. Kane's terms get plain names; names of other terms begin
/// with the formulation's name.
fn write_names_of_derivation(arena: &mut Arena, formulation: Formulation, equations: &Equations) {
    // Inverse dynamics appears only in generated code, so documents do not show it.
    let equations = Equations { required: Vec::new(), ..equations.clone() };
    if formulation == REFERENCE {
        let _ = equations.with_definitions(arena);
    } else {
        let terms = equations.terms(arena);
        define_names_in_part(arena, &formulation.name().replace('-', "_"), &terms);
    }
}

/// Replaces each named term of the equations and steps by a symbol. The definitions of the equations then list each
/// symbol with its term.
fn derivation_with_definitions(mut arena: Arena, equations: &Equations, mut steps: Vec<Step>) -> DerivationInSteps {
    let mut equations = equations.with_definitions(&mut arena);
    let lines = || steps.iter().flat_map(|step| step.lines.iter());
    let values: Vec<Expr> = lines().map(|(_, value)| *value).collect();
    let (named, values) = write_definitions(&mut arena, &[], &values);
    let known: FxHashSet<Expr> = equations.definitions.iter().map(|definition| definition.symbol).collect();
    equations.definitions.extend(named.into_iter().filter(|definition| !known.contains(&definition.symbol)));
    let places = steps.iter_mut().flat_map(|step| &mut step.lines);
    for ((_, place), value) in places.zip(values) {
        *place = value;
    }
    DerivationInSteps { arena, equations, steps }
}

/// Derives the equations of motion of a model by the standard formulations.
///
/// # Errors
/// Returns a [`DeriveError`] if the model itself is wrong. A formulation that this model does not support is listed
/// with its error instead.
pub fn derive_all(model: &Model) -> Result<Derivations, DeriveError> {
    derive_all_with(model, Kinematics::new(model)?)
}

/// Derives a model by the standard formulations from given kinematics. Terms are named if [`Kinematics::in_form`] has
/// named them.
///
/// # Errors
/// Returns a [`DeriveError`], for the same reasons as [`derive_all`].
pub fn derive_all_with(model: &Model, kinematics: Kinematics) -> Result<Derivations, DeriveError> {
    let mut derivations = Derivations { kinematics, list: Vec::new() };
    for f in Formulation::STANDARD {
        derivations.add(model, f)?;
    }
    Ok(derivations)
}

/// Derives the equations of one formulation from kinematics that several formulations may share.
///
/// # Errors
/// Returns a `DeriveError` if the formulation fails, the arena grows too large, or the matrix is singular everywhere.
pub(crate) fn derive_with(
    model: &Model,
    kinematics: &mut Kinematics,
    formulation: Formulation,
) -> Result<Equations, DeriveError> {
    let rows = (formulation.method().derive)(model, kinematics)?;
    check_term_limit(model, &kinematics.arena)?;
    let equations = equations_from_rows(model, kinematics, formulation, rows)?;
    match rank(&kinematics.arena, &equations.matrix).and_then(|rank| rank.dependent) {
        Some(row) => Err(singular_derivation_error(model, &equations.rows[row])),
        None => Ok(equations),
    }
}

/// Returns the error for a matrix that is singular in every configuration. `row` is the first row
/// that depends on the rows before it.
fn singular_derivation_error(model: &Model, row: &RowName) -> DeriveError {
    match row {
        RowName::Balance(_) | RowName::Power(_) | RowName::Law { .. } => DeriveError::ReactionsDependent,
        RowName::Coordinate(_) => DeriveError::NoInertia { speed: format!("{}'", row.text(model)) },
        _ => DeriveError::NoInertia { speed: row.text(model) },
    }
}
