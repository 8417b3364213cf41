//! Targets: the languages in which equations are written. One driver derives the equations of a model and passes each
//! set to a target, which plans and writes it.

use std::collections::BTreeMap;
use tripos_derive::algebra::Arena;
use tripos_derive::diagnostic::{Diagnostic, Diagnostics};
use tripos_derive::diff::printed_equations;
use tripos_derive::mechanics::{Derivation, DeriveError, derive_all};
use tripos_derive::publication::load_beside;
use tripos_derive::{Equations, Formulation, Model, derive};

/// Language into which one model is written. A target gets one set of equations after the other, and keeps the files.
pub trait Target {
    /// Texts of the files written so far, by file name.
    fn files(&self) -> &BTreeMap<String, String>;

    /// Name of the file for equations with this name.
    fn file_of(&self, equations: &str) -> String;

    /// Writes derived equations.
    ///
    /// # Errors
    /// [`Diagnostics`] if the accelerations were solved for but are not proved.
    fn derived(&mut self, model: &Model, derivation: Derivation) -> Result<(), Diagnostics>;

    /// Writes equations that a publication prints, exactly as printed; `model` contains the symbols of the publication.
    fn printed(&mut self, model: &Model, arena: &Arena, equations: &Equations);
}

/// Formulations that a model does not support, each with the reason.
pub type LeftOut = Vec<(Formulation, DeriveError)>;

/// Writes a model by a target. It writes the given formulations, or, if none are given, the standard ones that the
/// model supports and the printed equations of the publication beside it. Each formulation is derived with a store of
/// terms of its own, so that its text does not depend on the others.
///
/// # Errors
/// [`Diagnostics`] of the model or the publication, of a given formulation that the model does not support, or of two
/// printed systems whose files would have one name.
pub fn write(model: &Model, formulations: &[Formulation], target: &mut dyn Target) -> Result<LeftOut, Diagnostics> {
    let mut left_out = Vec::new();
    let is_wanted = |f: &Formulation| {
        if formulations.is_empty() { Formulation::STANDARD.contains(f) } else { formulations.contains(f) }
    };
    for f in Formulation::ALL.into_iter().filter(is_wanted) {
        match derive(model, f) {
            Ok(derivation) => target.derived(model, derivation)?,
            Err(error) if error.is_unsupported() && formulations.is_empty() => left_out.push((f, error)),
            Err(error) => return Err(model.diagnose(&error)),
        }
    }
    if formulations.is_empty() {
        printed(model, target)?;
    }
    Ok(left_out)
}

/// Writes the printed equations of the publication beside a model by a target, if there is a publication. Its symbols
/// are put into a store of their own, so that derived equations do not depend on them.
fn printed(model: &Model, target: &mut dyn Target) -> Result<(), Diagnostics> {
    let mut with_publication = model.clone();
    let Some(publication) = load_beside(&model.source.path, &mut with_publication)? else { return Ok(()) };
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
