//! Interface between derived equations and a target, which is a language in which equations are written. A driver
//! derives the equations of a model and passes each set to a target. The target plans and writes the set.

use std::collections::BTreeMap;
use tripos_derive::algebra::Arena;
use tripos_derive::diagnostic::{Diagnostic, Diagnostics};
use tripos_derive::diff::printed_equations;
use tripos_derive::mechanics::{Derivation, DeriveError, derive_all};
use tripos_derive::publication::load_publication_of_model;
use tripos_derive::{Equations, Formulation, Model, derive};

/// Language in which the equations of a model are written. A target receives sets of equations one after the other,
/// and keeps the texts of their files.
pub trait Target {
    /// Returns the texts of the files written so far, by file name.
    fn files(&self) -> &BTreeMap<String, String>;

    /// Returns the name of the file for a set of equations. `equations` is the name of the set, such as `kane`.
    fn file_of(&self, equations: &str) -> String;

    /// Writes a set of derived equations into this target's files.
    ///
    /// # Errors
    /// Returns [`Diagnostics`] if the accelerations were solved for but the solution is not proved.
    fn write_derived_equations(&mut self, model: &Model, derivation: Derivation) -> Result<(), Diagnostics>;

    /// Writes the equations of a publication exactly as printed. `model` must contain the symbols
    /// of the publication.
    fn printed(&mut self, model: &Model, arena: &Arena, equations: &Equations);
}

/// Formulations that a model does not support, each with the reason.
pub type UnsupportedFormulations = Vec<(Formulation, DeriveError)>;

/// Derives the equations of a model and passes each set to a target. Returns the unsupported formulations with the
/// reasons.
///
/// The given formulations are written. If none are given, the standard formulations that the model supports are
/// written, and the printed equations of its publication. Each formulation is derived with an arena of its own, so
/// that its text does not depend on other formulations.
///
/// # Errors
/// Returns [`Diagnostics`] of the model or the publication, or of a given formulation that the model does not
/// support. Also if the files of two printed systems would have the same name.
pub fn pass_equations_to_target(
    model: &Model,
    formulations: &[Formulation],
    target: &mut dyn Target,
) -> Result<UnsupportedFormulations, Diagnostics> {
    let mut left_out = Vec::new();
    let is_wanted = |f: &Formulation| {
        if formulations.is_empty() { Formulation::STANDARD.contains(f) } else { formulations.contains(f) }
    };
    for f in Formulation::ALL.into_iter().filter(is_wanted) {
        match derive(model, f) {
            Ok(derivation) => target.write_derived_equations(model, derivation)?,
            Err(error) if error.is_unsupported() && formulations.is_empty() => left_out.push((f, error)),
            Err(error) => return Err(model.diagnose(&error)),
        }
    }
    if formulations.is_empty() {
        pass_printed_equations_to_target(model, target)?;
    }
    Ok(left_out)
}

/// Writes the printed equations of the publication in the model's folder, if there is one. They use an arena of their
/// own, so that derived equations do not depend on the publication's symbols.
///
/// # Errors
/// Returns [`Diagnostics`] of the publication, or of two entries whose files would have the same name.
fn pass_printed_equations_to_target(model: &Model, target: &mut dyn Target) -> Result<(), Diagnostics> {
    let mut with_publication = model.clone();
    let Some(publication) = load_publication_of_model(&model.source.path, &mut with_publication)? else {
        return Ok(());
    };
    let mut derivations = derive_all(&with_publication).map_err(|error| model.diagnose(&error))?;
    for equations in printed_equations(&with_publication, &mut derivations, &publication) {
        let name = equations.name(&with_publication);
        let file = target.file_of(&name);
        if target.files().contains_key(&file) {
            let message = format!("the entry `{name}` and another entry give the same file {file}");
            let diagnostic = Diagnostic::of_file(message, "let ids differ in more than signs");
            return Err(Diagnostics::new(publication.source.clone(), vec![diagnostic]));
        }
        target.printed(&with_publication, &derivations.kinematics.arena, &equations);
    }
    Ok(())
}
