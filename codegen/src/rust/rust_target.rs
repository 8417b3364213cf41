//! Rust module of one model as a target: files of equations for people, code in `code/`, and a list of the sets of
//! equations.

use super::{FormulationFiles, LANGUAGE, ModuleEquations, WrittenFunctions, formulation_files};
use crate::optional_functions::Extras;
use crate::origin::Origin;
use crate::plan::{FormulationPlan, Jacobian, Planner, Sharing, module_name};
use crate::target::Target;
use crate::taylor::cheapest_recurrences_of;
use std::collections::BTreeMap;
use tripos_derive::algebra::Arena;
use tripos_derive::diagnostic::Diagnostics;
use tripos_derive::mechanics::{
    Derivation, SolvedAccelerations, Unsolved, equations_in_distance, singular_distances, unsolved_equations_error,
};
use tripos_derive::{Equations, Model};

/// Largest number of convolutions at one order for which Taylor recurrences are written. If there are more, a step of
/// another method costs less.
const MOST_CONVOLUTIONS: usize = 200;
/// Largest number of convolutions for which Taylor recurrences are also compiled for SIMD lanes. It counts for each
/// component of the state.
///
/// Up to this number, runs with these recurrences cost about as much as with DOP853. Measured: 0.9 to 1.1 times as
/// much with 2.4 convolutions (the disk), 2.3 times as much with 6.5 (a cart with three pendulums).
const MOST_CONVOLUTIONS_IN_LANES: usize = 4;

/// True if Taylor recurrences with this number of convolutions are short enough for SIMD lanes.
pub(super) fn has_short_series(convolutions: usize, equations: &Equations) -> bool {
    convolutions <= MOST_CONVOLUTIONS_IN_LANES * (equations.coordinates.len() + equations.variables.len())
}

/// Rust module of a model while it is being written, as a target.
pub(crate) struct RustTarget<'a> {
    /// Source file and command, as the headers state them.
    origin: &'a Origin,
    /// Optional functions to be written: Jacobian and Taylor recurrences.
    extras: Extras,
    /// Texts of the files, by path.
    files: BTreeMap<String, String>,
    /// Sets of equations in the order in which they were written.
    entries: Vec<ModuleEquations>,
    /// Functions that are already written. Later sets of equations import them.
    written: WrittenFunctions,
    /// Equations in the distance of a coordinate from an angle at which the equations are singular. They are written
    /// last, so that they import the functions of other equations. They serve only runs.
    near: Vec<Derivation>,
}

impl Target for RustTarget<'_> {
    fn files(&self) -> &BTreeMap<String, String> {
        &self.files
    }

    fn file_of(&self, equations: &str) -> String {
        format!("{}.rs", module_name(equations))
    }

    fn write_derived_equations(&mut self, model: &Model, derivation: Derivation) -> Result<(), Diagnostics> {
        self.near
            .extend(singular_distances(model).into_iter().map(|d| equations_in_distance(model, derivation.clone(), d)));
        self.write_solved_equations(model, derivation, Readers::People)
    }

    fn printed(&mut self, model: &Model, arena: &Arena, equations: &Equations) {
        let planner = Planner::new(model, arena, equations, &LANGUAGE, Sharing::AsStated);
        let plan = FormulationPlan::new(&planner, None, Jacobian::LeftOut, None);
        self.add(&plan, &self.origin.publication_origin_sentence(), Readers::People);
    }
}

/// Intended users of a set of equations: people, or only runs.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Readers {
    /// People read the equations: a file of equations is written in addition to the code.
    People,
    /// Only runs use the equations: no file of equations is written for people.
    Runs,
}

impl<'a> RustTarget<'a> {
    /// Starts the Rust module of a model, without any equations.
    pub fn new(origin: &'a Origin, extras: Extras) -> Self {
        Self {
            origin,
            extras,
            files: BTreeMap::new(),
            entries: Vec::new(),
            written: WrittenFunctions::default(),
            near: Vec::new(),
        }
    }

    /// Writes the equations in distances from singular angles. Returns the texts of all files, and the list of all
    /// sets of equations.
    ///
    /// # Errors
    /// Returns [`Diagnostics`] if accelerations are not determined in closed form, or are not proved.
    pub fn finish(mut self, model: &Model) -> Result<(BTreeMap<String, String>, Vec<ModuleEquations>), Diagnostics> {
        for derivation in std::mem::take(&mut self.near) {
            self.write_solved_equations(model, derivation, Readers::Runs)?;
        }
        Ok((self.files, self.entries))
    }

    /// Solves derived equations for their accelerations and writes them. `shown` are the intended users of the
    /// equations.
    ///
    /// # Errors
    /// Returns [`Diagnostics`] if the accelerations are not determined in closed form, or are not proved.
    fn write_solved_equations(
        &mut self,
        model: &Model,
        derivation: Derivation,
        shown: Readers,
    ) -> Result<(), Diagnostics> {
        let Derivation { mut arena, equations } = derivation;
        let title = equations.formulation.title();
        let refused = |why: Unsolved| unsolved_equations_error(&model.source, title, why);
        let equations = equations.with_definitions(&mut arena);
        let solved = SolvedAccelerations::new(&mut arena, &equations).map_err(refused)?;
        let recurrences = if self.extras.taylor {
            cheapest_recurrences_of(&mut arena, &equations, &solved.accelerations)
        } else {
            None
        };
        let recurrences = recurrences.filter(|list| list.convolutions() <= MOST_CONVOLUTIONS);
        let equations = equations.with_certified_inverse_dynamics(&mut arena).map_err(|why| refused(why.into()))?;
        let planner = Planner::new(model, &arena, &equations, &LANGUAGE, Sharing::Shared);
        let jacobian = if self.extras.jacobian { Jacobian::Planned } else { Jacobian::LeftOut };
        let plan = FormulationPlan::new(&planner, Some(&solved), jacobian, recurrences.as_ref());
        self.add(&plan, &self.origin.model_origin_sentence(), shown);
        Ok(())
    }

    /// Writes the files of planned equations, and adds the equations to the list of all sets of equations.
    fn add(&mut self, plan: &FormulationPlan<'_>, origin: &str, shown: Readers) {
        let (equations, model) = (plan.planner.equations, plan.planner.model);
        let (name, title) = (equations.name(model), equations.title(model));
        let FormulationFiles { equations: text, code } = formulation_files(plan, origin, &mut self.written);
        let file = self.file_of(&name);
        self.files.insert(format!("code/{file}"), code);
        let is_shown = shown == Readers::People;
        self.files.extend(is_shown.then_some((file, text)));
        let series = plan.taylor.as_ref().is_some_and(|taylor| has_short_series(taylor.list.convolutions(), equations));
        self.entries.push(ModuleEquations { name, title, solved: plan.solved_cost, series, shown: is_shown });
    }
}
