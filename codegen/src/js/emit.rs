//! JavaScript modules for any model file, and the modules that integrate its motion.

use super::{JavaScriptModule, RUNNERS, WrittenEquations};
use crate::emit::{Emission, ReplacedFiles};
use crate::origin::{EMIT, Origin};
use crate::plan::{MotionPlan, WatchedQuantity, module_name};
use crate::target::{self, Target};
use std::collections::{BTreeMap, BTreeSet};
use tripos_derive::algebra::Arena;
use tripos_derive::diagnostic::Diagnostics;
use tripos_derive::mechanics::Derivation;
use tripos_derive::{Equations, Formulation, Model};

/// File extension of JavaScript modules, without a dot, for Node and for browsers.
pub const EXTENSION: &str = "mjs";

/// Generates the JavaScript modules of a model.
///
/// They contain the given formulations. If none are given, they contain all that the model supports, and the printed
/// equations of its publication.
///
/// # Errors
/// Returns [`Diagnostics`] of the model file or the publication, or of a given formulation that the model does not
/// support.
pub fn emit_javascript_modules(model: &Model, formulations: &[Formulation]) -> Result<Emission, Diagnostics> {
    let mut modules = JavaScriptModules::new(model)?;
    let left_out = target::pass_equations_to_target(model, formulations, &mut modules)?;
    let replaced = ReplacedFiles::Named(BTreeSet::new());
    Ok(Emission { files: modules.files, left_out, command: EMIT, extensions: &[EXTENSION], replaced })
}

/// JavaScript modules of a model while they are being written, as a target.
struct JavaScriptModules {
    /// Source file and command, as the header of each module states them.
    origin: Origin,
    /// Texts of the modules, by file name.
    files: BTreeMap<String, String>,
    /// Equations that give the reactions. `None` if no condition of the domain contains a reaction, or if the
    /// reactions cannot be derived.
    balance: Option<WrittenEquations>,
}

impl Target for JavaScriptModules {
    fn files(&self) -> &BTreeMap<String, String> {
        &self.files
    }

    fn file_of(&self, equations: &str) -> String {
        format!("{}.{EXTENSION}", module_name(equations))
    }

    fn write_derived_equations(&mut self, model: &Model, derivation: Derivation) -> Result<(), Diagnostics> {
        let written = WrittenEquations::solve_for_accelerations(derivation).map_err(|why| model.diagnose(&why))?;
        self.add(model, &written, &self.origin.model_origin_sentence());
        Ok(())
    }

    fn printed(&mut self, model: &Model, arena: &Arena, equations: &Equations) {
        let written = WrittenEquations { arena: arena.clone(), equations: equations.clone(), solved: None };
        self.add(model, &written, &self.origin.publication_origin_sentence());
    }
}

impl JavaScriptModules {
    /// Starts the files of a model with the runner modules. Derives the equations for reactions if conditions of the
    /// domain need them. `Err` if the model cannot be derived.
    fn new(model: &Model) -> Result<Self, Diagnostics> {
        let origin = Origin::origin_of_model_file(&model.source.path, EMIT);
        let header = format!("// {}\n//\n", origin.shared_file_origin_sentence());
        let runners = RUNNERS.map(|(name, text)| (format!("{name}.{EXTENSION}"), header.clone() + text));
        let balance =
            WrittenEquations::reaction_equations(model, model.domain.iter().map(|condition| condition.positive))?;
        Ok(Self { origin, files: runners.into(), balance })
    }

    /// Writes the module of one set of equations. `origin` is the header sentence.
    fn add(&mut self, model: &Model, written: &WrittenEquations, origin: &str) {
        let file = self.file_of(&written.equations.name(model));
        let text = self.module(model, written, origin);
        self.files.insert(file, text);
    }

    /// Returns the text of the module for one set of equations. Its runs watch the conditions of the model's domain.
    fn module(&self, model: &Model, written: &WrittenEquations, origin: &str) -> String {
        let (own, balance) = (written.planner(model), self.balance.as_ref().map(|balance| balance.planner(model)));
        let names: Vec<String> = model.domain.iter().map(|c| format!("{} ({})", c.name, c.text)).collect();
        let values = model.domain.iter().map(|condition| condition.positive);
        let watched = names.iter().cloned().zip(values).map(|(name, value)| WatchedQuantity { name, value });
        let plan = MotionPlan::new(&own, written.solved.as_ref(), &watched.collect::<Vec<_>>(), balance.as_ref());
        JavaScriptModule { planner: &own, plan: &plan, watched: &names, beside: &[], origin }.text()
    }
}
