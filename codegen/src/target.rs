//! Targets: the languages that equations are written in. One driver derives the equations of a model and hands each set
//! to a target, which plans and writes it.

use std::collections::BTreeMap;
use tripos_derive::algebra::Arena;
use tripos_derive::diagnostic::{Diagnostic, Diagnostics};
use tripos_derive::diff::printed_equations;
use tripos_derive::mechanics::{Derivation, DeriveError, derive_all};
use tripos_derive::publication::load_beside;
use tripos_derive::{Equations, Formulation, Model, derive};

/// A language while it writes one model: it gets one set of equations after the other, and keeps the files.
pub trait Target {
    /// Text of each file that is written so far, by its name.
    fn files(&self) -> &BTreeMap<String, String>;

    /// The name of the file of equations of this name.
    fn file_of(&self, equations: &str) -> String;

    /// Writes derived equations.
    ///
    /// # Errors
    /// [`Diagnostics`] if the accelerations that were solved for are not proved.
    fn derived(&mut self, model: &Model, derivation: Derivation) -> Result<(), Diagnostics>;

    /// Writes equations that a publication prints, as they stand; the model knows the symbols of the publication.
    fn printed(&mut self, model: &Model, arena: &Arena, equations: &Equations);
}

/// Formulations that a model does not support, each with the reason.
pub type LeftOut = Vec<(Formulation, DeriveError)>;

/// Has a target write a model: these formulations alone, or, if none are named, all that the model supports and the
/// printed equations of the publication beside it. Each formulation is derived with a store of terms of its own, so that
/// the text of one does not depend on the others.
///
/// # Errors
/// [`Diagnostics`] of the model or the publication; a named formulation that the model does not support is one, and so
/// are two printed systems whose files would have one name.
pub fn write(model: &Model, formulations: &[Formulation], target: &mut dyn Target) -> Result<LeftOut, Diagnostics> {
    let mut left_out = Vec::new();
    let is_asked = |f: &Formulation| formulations.is_empty() || formulations.contains(f);
    for f in Formulation::ALL.into_iter().filter(is_asked) {
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

/// Has a target write the printed equations of the publication beside a model, if there is one. Symbols of the
/// publication go to a store of their own, so that derived equations do not depend on it.
fn printed(model: &Model, target: &mut dyn Target) -> Result<(), Diagnostics> {
    let mut with_publication = model.clone();
    let Some(publication) = load_beside(&model.source.path, &mut with_publication)? else { return Ok(()) };
    let mut derivations = derive_all(&with_publication).map_err(|error| model.diagnose(&error))?;
    for equations in printed_equations(&with_publication, &mut derivations, &publication) {
        let name = equations.name(&with_publication);
        let file = target.file_of(&name);
        if target.files().contains_key(&file) {
            let message = format!("another entry than `{name}` gives the same file {file}");
            let diagnostic = Diagnostic::of_file(message, "let ids differ in more than signs");
            return Err(Diagnostics::new(publication.source.clone(), vec![diagnostic]));
        }
        target.printed(&with_publication, &derivations.kinematics.arena, &equations);
    }
    Ok(())
}
