//! Target for C, Python, MATLAB and CasADi: writes the modules of a model's formulations and
//! printed equations.

use super::module_contents::module_identifier_word;
use super::{CompositeFunction, Dialect, Module, SceneRun};
use crate::emit::{Emission, ReplacedFiles};
use crate::origin::{Origin, model_name_of_origin};
use crate::plan::{
    MissingOutputReason, ModulePlan, Planner, RegressorFunctions, SceneOutputs, Sharing, Solution, module_name,
};
use crate::target::{self, Target};
use std::collections::{BTreeMap, BTreeSet};
use tripos_derive::algebra::form::simplify::Simplifier;
use tripos_derive::algebra::term::steps::Definition;
use tripos_derive::algebra::{Arena, Expr};
use tripos_derive::diagnostic::{Diagnostic, Diagnostics};
use tripos_derive::identify::BaseEquations;
use tripos_derive::mechanics::{Derivation, DeriveError, SolvedAccelerations, Unsolved, parameter_jacobian};
use tripos_derive::scene::Scene;
use tripos_derive::{Equations, Formulation, Model, derive};

/// Choice of the equations and functions that modules contain.
#[derive(Clone, Copy, Default)]
pub struct Selection<'a> {
    /// Formulations to write. An empty list means all that the model supports, and the printed equations of its
    /// publication.
    pub formulations: &'a [Formulation],
    /// Names of the functions to write. An empty list means all functions.
    pub functions: &'a [String],
    /// True if the equations are written in base parameters, by Kane's method alone.
    pub in_base_parameters: bool,
    /// Scene with which the model was read; `None` if only a model is given. The scene's outputs and events become
    /// functions, and scripts run the scene.
    pub scene: Option<&'a Scene>,
}

/// Files of a model in one language, with the names of the functions that they contain.
pub struct LanguageEmission {
    /// Texts of the files, and the formulations that were left out.
    pub emission: Emission,
    /// Name of the file that a program imports or includes to use the first module.
    pub main_file: String,
    /// Names of the functions that at least one module contains, without repetition.
    pub functions: Vec<&'static str>,
    /// Outputs, events and conditions that no function gives, each as (name, title of the equations, reason).
    pub hidden: Vec<(String, String, MissingOutputReason)>,
    /// Operations of mass matrix and forcing together, in base parameters and in the parameters of the model. `None`
    /// unless the equations were written in base parameters.
    pub operations_in_base_parameters: Option<[usize; 2]>,
}

/// Writes the modules of a model in one language.
///
/// # Errors
/// Returns [`Diagnostics`] of the publication, of a given formulation that the model does not support, or of a
/// requested function that no module has.
pub fn emit_language_modules(
    model: &Model,
    dialect: &dyn Dialect,
    selection: Selection<'_>,
) -> Result<LanguageEmission, Diagnostics> {
    let origin = Origin::origin_of_model_file(&model.source.path, dialect.command());
    let run = || {
        selection
            .scene
            .map_or_else(|| SceneRun::first_scene_run(model), |scene| SceneRun::plain_scene_run(scene, model))
    };
    let mut model_word = module_identifier_word(model_name_of_origin(&origin)).to_ascii_lowercase();
    if selection.in_base_parameters {
        model_word.push_str("_base");
    }
    let mut modules = LanguageTarget {
        dialect,
        model_word,
        selection,
        run: if selection.functions.is_empty() && !selection.in_base_parameters { run() } else { None },
        files: dialect.shared_files(&origin.shared_file_origin_sentence()).into_iter().collect(),
        replaced: BTreeSet::new(),
        written: Vec::new(),
        hidden: Vec::new(),
        main_file: None,
        origin,
    };
    let mut operations_in_base_parameters = None;
    let left_out = if selection.in_base_parameters {
        operations_in_base_parameters = Some(modules.write_base_equations(model)?);
        Vec::new()
    } else {
        target::pass_equations_to_target(model, selection.formulations, &mut modules)?
    };
    if let Some(name) = selection.functions.iter().find(|name| !modules.written.contains(&name.as_str())) {
        let message = format!("the equations of this model have no function `{name}`");
        let help = missing_function_help(name, model, dialect, selection)?;
        return Err(Diagnostics::new(model.source.clone(), vec![Diagnostic::of_file(message, help)]));
    }
    let emission = Emission {
        files: modules.files,
        left_out,
        command: dialect.command(),
        extensions: dialect.extensions(),
        replaced: ReplacedFiles::Named(modules.replaced),
    };
    let main_file = modules.main_file.unwrap_or_default();
    let LanguageTarget { written: functions, hidden, .. } = modules;
    Ok(LanguageEmission { emission, main_file, functions, hidden, operations_in_base_parameters })
}

/// Returns the help text for a requested function that no module of the model has. It states a way to get the
/// function, and the names of all functions. `Err` if the model has errors.
fn missing_function_help(
    name: &str,
    model: &Model,
    dialect: &dyn Dialect,
    selection: Selection<'_>,
) -> Result<String, Diagnostics> {
    let functions = emit_language_modules(model, dialect, Selection { functions: &[], ..selection })?.functions;
    let why = match name {
        "outputs" | "events" if selection.scene.is_none() => {
            "give a scene file in place of the model: its outputs and events become functions; "
        }
        "reactions" => "reactions are unknowns of `--formulation newton-euler`; ",
        "base_regressor" | "base_parameters" if functions.contains(&"inverse_dynamics") => {
            "the base parameters of this model have no formulas; `regressor` has a column for each inertial parameter; "
        }
        name if RegressorFunctions::FUNCTIONS.contains(&name) => "regressors belong to `--formulation kane`; ",
        _ => "",
    };
    Ok(format!("{why}its functions are {}", functions.join(", ")))
}

/// Modules of a model in one language while they are being written, as a target.
struct LanguageTarget<'a> {
    /// Language in which the modules are written.
    dialect: &'a dyn Dialect,
    /// Source file and command, as the headers state them.
    origin: Origin,
    /// Word for the model in names of files and functions.
    model_word: String,
    /// Choice of the equations and functions that are written.
    selection: Selection<'a>,
    /// Texts of the files written so far, by file name.
    files: BTreeMap<String, String>,
    /// Names of the files that the sets of equations written so far may have with any functions.
    replaced: BTreeSet<String>,
    /// Scene that the simulation scripts run; `None` if there is none, or if only chosen functions
    /// are written.
    run: Option<SceneRun>,
    /// Names of the functions that were written so far.
    written: Vec<&'static str>,
    /// Outputs, events and conditions that no function gives, each as (name, title of the equations, reason).
    hidden: Vec<(String, String, MissingOutputReason)>,
    /// Name of the file of the first module; `None` until this module is written.
    main_file: Option<String>,
}

impl Target for LanguageTarget<'_> {
    fn files(&self) -> &BTreeMap<String, String> {
        &self.files
    }

    fn file_of(&self, equations: &str) -> String {
        self.dialect.main_file(&self.model_word, &module_name(equations))
    }

    fn write_derived_equations(&mut self, model: &Model, derivation: Derivation) -> Result<(), Diagnostics> {
        self.write_equations(model, derivation, &[])
    }

    fn printed(&mut self, model: &Model, arena: &Arena, equations: &Equations) {
        let origin = self.origin.publication_origin_sentence();
        let planner = Planner::new(model, arena, equations, self.dialect.language(), Sharing::AsStated);
        self.add(&planner, ModulePlan::new(&planner, None), &origin);
    }
}

impl LanguageTarget<'_> {
    /// Writes Kane's equations of the model in base parameters. Returns the operations of mass matrix and forcing
    /// together, in base parameters and in the parameters of the model. `Err` if the equations cannot be derived.
    fn write_base_equations(&mut self, model: &Model) -> Result<[usize; 2], Diagnostics> {
        let base = BaseEquations::new(model).map_err(|error| model.diagnose(&error))?;
        let plain = derive(model, BaseEquations::FORMULATION).map_err(|error| model.diagnose(&error))?;
        let language = self.dialect.language();
        let operations = [(&base.model, base.derivation.clone()), (model, plain)].map(|(model, derivation)| {
            let Derivation { mut arena, equations } = derivation;
            let equations = equations.with_definitions(&mut arena);
            let planner = Planner::new(model, &arena, &equations, language, Sharing::Shared);
            let functions = ModulePlan::new(&planner, None).functions;
            let system = functions.iter().filter(|function| ["mass_matrix", "forcing"].contains(&function.name));
            system.map(|function| function.cost.operations).sum()
        });
        self.write_equations(&base.model, base.derivation, &base.base_parameters)?;
        Ok(operations)
    }

    /// Writes a set of derived equations. `base_parameters` are the parameters that follow from the other parameters.
    fn write_equations(
        &mut self,
        model: &Model,
        derivation: Derivation,
        base_parameters: &[Definition],
    ) -> Result<(), Diagnostics> {
        let Derivation { mut arena, equations } = derivation;
        let equations = equations.with_definitions(&mut arena);
        let parameters = self.wants("parameter_jacobian").then(|| model.p());
        let solution =
            solution_for_target(&mut arena, &equations, parameters.as_deref()).map_err(|why| model.diagnose(&why))?;
        let shown = self.selection.scene.map(|scene| {
            let solved = solution.as_ref().map(|solution| &solution.by_state.accelerations);
            SceneOutputs::new(model, scene, &mut arena, &equations, solved)
        });
        let equations = equations
            .with_certified_inverse_dynamics(&mut arena)
            .map_err(|why| model.diagnose(&DeriveError::Unsolved(why.into())))?;
        let wants_regressor =
            base_parameters.is_empty() && RegressorFunctions::FUNCTIONS.iter().any(|name| self.names(name));
        // The required forces act along the generalized speeds, and no reaction is among the unknowns, as in inverse
        // dynamics.
        let is_in_speeds = !equations.required.is_empty()
            && equations.variables == model.u()
            && equations.unknowns.iter().copied().eq(model.speeds.iter().map(|speed| speed.rate));
        let regression = if wants_regressor && is_in_speeds {
            Some(RegressorFunctions::new(model, &equations).map_err(|why| model.diagnose(&why))?)
        } else {
            None
        };
        let language = self.dialect.language();
        let planner = Planner::new(model, &arena, &equations, language, Sharing::Shared);
        let mut plan = ModulePlan::new(&planner, solution.as_ref());
        if let Some(regression) = &regression {
            plan.add_regressor(&planner, regression, language);
        }
        plan.add_base_parameters(&planner, base_parameters);
        let title = equations.title(model);
        if self.wants("conditions") {
            self.hidden
                .extend(plan.unchecked.iter().map(|name| (name.clone(), title.clone(), MissingOutputReason::Reaction)));
        }
        if let Some(shown) = &shown {
            plan.add_scene_outputs(&planner, shown);
            self.hidden.extend(shown.left_out.iter().map(|(name, why)| (name.clone(), title.clone(), *why)));
        }
        let origin = self.origin.model_origin_sentence();
        self.add(&planner, plan, &origin);
        Ok(())
    }

    /// True if the function of this name is to be written: either all functions are, or the name is requested.
    fn wants(&self, name: &str) -> bool {
        self.selection.functions.is_empty() || self.names(name)
    }

    /// True if the user requests the function by its name.
    fn names(&self, name: &str) -> bool {
        self.selection.functions.iter().any(|wanted| wanted == name)
    }

    /// Writes the module of one set of equations: the wanted planned functions, the composite
    /// functions that can be built from them, and a script.
    fn add(&mut self, planner: &Planner<'_>, mut plan: ModulePlan, origin: &str) {
        let name = planner.equations.name(planner.model);
        let can_write = |composite: &CompositeFunction| {
            composite.needs().iter().all(|needed| plan.has(needed)) && composite.exists_for_equations(planner.equations)
        };
        let composites = self.dialect.composites().iter().copied().filter(can_write);
        let composites: Vec<CompositeFunction> = composites.filter(|composite| self.wants(composite.name())).collect();
        // Without the function of the base parameters, the last parameters would have no values.
        let of_base = self.selection.in_base_parameters.then_some(ModulePlan::BASE_PARAMETERS);
        let needed = composites.iter().flat_map(|composite| composite.needs()).copied().chain(of_base);
        let needed: Vec<&str> = needed.collect();
        plan.functions.retain(|function| self.wants(function.name) || needed.contains(&function.name));
        let own = composites.iter().map(|composite| composite.name());
        for name in plan.functions.iter().map(|function| function.name).chain(own) {
            if !self.written.contains(&name) {
                self.written.push(name);
            }
        }
        let module = Module {
            model_word: &self.model_word,
            equations_word: &module_name(&name),
            planner,
            plan: &plan,
            composites: &composites,
            origin,
        };
        self.replaced.extend(self.dialect.possible_files(&self.model_word, &module_name(&name)));
        self.files.extend(self.dialect.files(&module));
        let script = self.run.as_ref().filter(|_| composites.contains(&CompositeFunction::StateDerivative));
        self.files.extend(script.and_then(|run| self.dialect.script(&module, run)));
        self.main_file.get_or_insert_with(|| self.dialect.main_file(&self.model_word, &module_name(&name)));
    }
}

/// Solves the equations for the accelerations in closed form, and differentiates the accelerations with respect to
/// the state and the given parameters. `None` if the equations do not determine the accelerations in closed form.
/// `Err` if a result is not proved.
fn solution_for_target(
    arena: &mut Arena,
    equations: &Equations,
    parameters: Option<&[Expr]>,
) -> Result<Option<Solution>, DeriveError> {
    let by_state = match SolvedAccelerations::new(arena, equations) {
        Ok(solved) => solved,
        Err(Unsolved::Singular(_)) => return Ok(None),
        Err(why) => return Err(DeriveError::Unsolved(why)),
    };
    let solved = &by_state.accelerations;
    let by_parameters = match parameters {
        Some(parameters) => parameter_jacobian(arena, &mut Simplifier::default(), equations, solved, parameters)
            .map_err(|why| DeriveError::Unsolved(why.into()))?,
        None => None,
    };
    Ok(Some(Solution { by_state, by_parameters }))
}
