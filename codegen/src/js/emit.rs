//! The modules of any one model file, beside what runs them.

use super::{Module, RUNNERS, Written};
use crate::emit::Emission;
use crate::origin::Origin;
use crate::plan::{MotionPlan, Watched, module_name};
use std::collections::BTreeMap;
use tripos_derive::diagnostic::{Diagnostic, Diagnostics};
use tripos_derive::diff::printed_equations;
use tripos_derive::mechanics::derive_all;
use tripos_derive::publication::load_beside;
use tripos_derive::{Formulation, Model, derive};

/// Extension of JavaScript files: modules, for Node as for browsers.
pub const EXTENSION: &str = "mjs";

/// Emits the JavaScript modules of a model: of these formulations alone, or, if none are named, of all that the model
/// supports and of the printed equations of the publication beside it.
///
/// # Errors
/// [`Diagnostics`] of the model file or the publication; a formulation that is named and cannot be had is one.
pub fn emit_model(model: &Model, formulations: &[Formulation]) -> Result<Emission, Diagnostics> {
    let origin = Origin::emitted(&model.source.path);
    let mut emitting = Emitting::new(model, &origin)?;
    let mut left_out = Vec::new();
    for f in Formulation::ALL.into_iter().filter(|f| formulations.is_empty() || formulations.contains(f)) {
        match derive(model, f) {
            Ok(derivation) => {
                let written = Written::solved(derivation).map_err(|why| model.diagnose(&why))?;
                emitting.add(model, &written, &origin.of_model())?;
            }
            Err(error) if error.is_unsupported() && formulations.is_empty() => left_out.push((f, error)),
            Err(error) => return Err(model.diagnose(&error)),
        }
    }
    if formulations.is_empty() {
        emitting.printed(model, &origin.of_publication())?;
    }
    Ok(Emission { files: emitting.files, left_out, extension: EXTENSION })
}

/// Modules while they are written.
struct Emitting {
    files: BTreeMap<String, String>,
    /// The equations that give reactions, where the domain asks for some and they can be had.
    balance: Option<Written>,
}

impl Emitting {
    fn new(model: &Model, origin: &Origin) -> Result<Self, Diagnostics> {
        let header = format!("// {}\n//\n", origin.beside());
        let runners = RUNNERS.map(|(name, text)| (format!("{name}.{EXTENSION}"), header.clone() + text));
        Ok(Self {
            files: runners.into(),
            balance: Written::balance(model, model.domain.iter().map(|condition| condition.positive))?,
        })
    }

    fn printed(&mut self, model: &Model, origin: &str) -> Result<(), Diagnostics> {
        let mut with_publication = model.clone();
        let Some(publication) = load_beside(&model.source.path, &mut with_publication)? else { return Ok(()) };
        let mut derivations = derive_all(&with_publication).map_err(|error| model.diagnose(&error))?;
        for equations in printed_equations(&with_publication, &mut derivations, &publication) {
            let arena = derivations.kinematics.arena.clone();
            self.add(&with_publication, &Written { arena, equations, solved: None }, origin)?;
        }
        Ok(())
    }

    fn add(&mut self, model: &Model, written: &Written, origin: &str) -> Result<(), Diagnostics> {
        let name = written.equations.name(model);
        let file = format!("{}.{EXTENSION}", module_name(&name));
        if self.files.contains_key(&file) {
            let message = format!("another entry than `{name}` gives the same file {file}");
            let diagnostic = Diagnostic::of_file(message, "let ids differ in more than signs");
            return Err(Diagnostics::new(model.source.clone(), vec![diagnostic]));
        }
        let text = self.module(model, written, origin);
        self.files.insert(file, text);
        Ok(())
    }

    fn module(&self, model: &Model, written: &Written, origin: &str) -> String {
        let (own, balance) = (written.planner(model), self.balance.as_ref().map(|balance| balance.planner(model)));
        let names: Vec<String> = model.domain.iter().map(|c| format!("{} ({})", c.name, c.text)).collect();
        let values = model.domain.iter().map(|condition| condition.positive);
        let watched = names.iter().cloned().zip(values).map(|(name, value)| Watched { name, value });
        let plan = MotionPlan::new(&own, written.solved.as_ref(), &watched.collect::<Vec<_>>(), balance.as_ref());
        Module { planner: &own, plan: &plan, watched: &names, beside: &[], origin }.text()
    }
}
