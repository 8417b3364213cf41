//! Rust module of one model as a target: files of equations for people, code in `code/`, and an entry for each set of
//! equations.

use super::{Entry, FormulationFiles, LANGUAGE, Written, formulation_files};
use crate::extras::Extras;
use crate::origin::Origin;
use crate::plan::{FormulationPlan, Jacobian, Planner, Sharing, module_name};
use crate::target::Target;
use crate::taylor::recurrences_of;
use std::collections::BTreeMap;
use tripos_derive::algebra::Arena;
use tripos_derive::diagnostic::{Diagnostic, Diagnostics, Source};
use tripos_derive::mechanics::{Derivation, Solved, Unsolved, distances, in_distance};
use tripos_derive::{Equations, Model};

/// Most convolutions at one order for which recurrences are written. With more, a step of another method costs less.
const MOST_CONVOLUTIONS: usize = 200;
/// Most convolutions, for each component of the state, of recurrences that are also compiled in lanes. Up to this
/// number, runs by them cost no more than by DOP853: 2.4 of the disk cost 0.9 to 1.1 times as much, 6.5 of a cart with
/// three pendulums 2.3 times.
const MOST_CONVOLUTIONS_IN_LANES: usize = 4;

fn has_short_series(convolutions: usize, equations: &Equations) -> bool {
    convolutions <= MOST_CONVOLUTIONS_IN_LANES * (equations.coordinates.len() + equations.variables.len())
}

/// Rust module of a model while it is written.
pub(crate) struct RustModule<'a> {
    origin: &'a Origin,
    extras: Extras,
    files: BTreeMap<String, String>,
    /// Sets of equations in the order in which they were written.
    entries: Vec<Entry>,
    /// Functions that are already written, which later sets of equations use.
    written: Written,
    /// Equations in distances from singular surfaces. They are only for runs and come last, so that they use the
    /// functions of the other equations.
    near: Vec<Derivation>,
}

impl Target for RustModule<'_> {
    fn files(&self) -> &BTreeMap<String, String> {
        &self.files
    }

    fn file_of(&self, equations: &str) -> String {
        format!("{}.rs", module_name(equations))
    }

    fn derived(&mut self, model: &Model, derivation: Derivation) -> Result<(), Diagnostics> {
        self.near.extend(distances(model).into_iter().map(|d| in_distance(model, derivation.clone(), d)));
        self.solved(model, derivation, Readers::People)
    }

    fn printed(&mut self, model: &Model, arena: &Arena, equations: &Equations) {
        let planner = Planner::new(model, arena, equations, &LANGUAGE, Sharing::AsStated);
        let plan = FormulationPlan::new(&planner, None, Jacobian::LeftOut, None);
        self.add(&plan, &self.origin.of_publication(), Readers::People);
    }
}

/// Intended readers of a set of equations.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Readers {
    /// People: a file of equations is written beside the code.
    People,
    /// Only runs: no file of equations is written.
    Runs,
}

impl<'a> RustModule<'a> {
    /// Module without equations.
    pub fn new(origin: &'a Origin, extras: Extras) -> Self {
        Self {
            origin,
            extras,
            files: BTreeMap::new(),
            entries: Vec::new(),
            written: Written::default(),
            near: Vec::new(),
        }
    }

    /// Writes the equations in distances from singular surfaces, and returns all files and entries.
    ///
    /// # Errors
    /// [`Diagnostics`] if accelerations are not determined, or are not proved.
    pub fn finish(mut self, model: &Model) -> Result<(BTreeMap<String, String>, Vec<Entry>), Diagnostics> {
        for derivation in std::mem::take(&mut self.near) {
            self.solved(model, derivation, Readers::Runs)?;
        }
        Ok((self.files, self.entries))
    }

    /// Adds derived equations, solved for their accelerations.
    fn solved(&mut self, model: &Model, derivation: Derivation, shown: Readers) -> Result<(), Diagnostics> {
        let Derivation { mut arena, equations } = derivation;
        let title = equations.formulation.title();
        let refused = |why: Unsolved| unsolved(&model.source, title, why);
        let equations = equations.written(&mut arena);
        let solved = Solved::new(&mut arena, &equations).map_err(refused)?;
        let recurrences =
            if self.extras.taylor { recurrences_of(&mut arena, &equations, &solved.accelerations) } else { None };
        let recurrences = recurrences.filter(|list| list.convolutions() <= MOST_CONVOLUTIONS);
        let equations = equations.with_inverse_dynamics(&mut arena).map_err(|why| refused(why.into()))?;
        let planner = Planner::new(model, &arena, &equations, &LANGUAGE, Sharing::Shared);
        let jacobian = if self.extras.jacobian { Jacobian::Planned } else { Jacobian::LeftOut };
        let plan = FormulationPlan::new(&planner, Some(&solved), jacobian, recurrences.as_ref());
        self.add(&plan, &self.origin.of_model(), shown);
        Ok(())
    }

    fn add(&mut self, plan: &FormulationPlan<'_>, origin: &str, shown: Readers) {
        let (equations, model) = (plan.planner.equations, plan.planner.model);
        let (name, title) = (equations.name(model), equations.title(model));
        let FormulationFiles { equations: text, code } = formulation_files(plan, origin, &mut self.written);
        let file = self.file_of(&name);
        self.files.insert(format!("code/{file}"), code);
        let is_shown = shown == Readers::People;
        self.files.extend(is_shown.then_some((file, text)));
        let series = plan.taylor.as_ref().is_some_and(|taylor| has_short_series(taylor.list.convolutions(), equations));
        self.entries.push(Entry { name, title, solved: plan.solved_cost, series, shown: is_shown });
    }
}

/// Diagnostics for equations that are not written because their accelerations cannot be used.
pub(crate) fn unsolved(source: &Source, equations: &str, why: Unsolved) -> Diagnostics {
    Diagnostics::new(source.clone(), vec![Diagnostic::of_file(format!("{equations}: {why}"), why.help())])
}
