//! Plan of the functions of a scene's reduced equations, and their cost in comparison with the equations of the whole
//! model.

use super::equation_functions::{
    accelerations, derivative, divisors, jacobian, kinematics_and_energies, linear_system,
};
use super::formulation_plan::{Jacobian, singular_text};
use super::programs::cost::OperationCount;
use super::programs::function::{Arguments, Function, Returns, Value};
use super::programs::planner::{Planner, Sharing};
use super::programs::variable_names::{Language, variable_name_without_primes};
use super::taylor_plan::TaylorPlan;
use crate::taylor::{Recurrences, cheapest_recurrences_of};
use tripos_derive::algebra::form::simplify::Simplifier;
use tripos_derive::algebra::text::print::print_text;
use tripos_derive::algebra::{Arena, Expr};
use tripos_derive::mechanics::{self, Derivation, DeriveError, SolvedAccelerations, Unsolved};
use tripos_derive::reduce::{PotentialDifference, ReducedQuantity, Reduction};
use tripos_derive::{Equations, Formulation, Model, derive};

/// Reduced equations of a scene, solved for the accelerations.
pub struct SceneEquations<'a> {
    /// Reduction of the model's equations for the scene.
    pub reduction: &'a Reduction,
    /// Arena with the terms of the equations and their solution.
    arena: Arena,
    /// Accelerations in closed form, and their derivatives with respect to the state.
    solved: SolvedAccelerations,
    /// Recurrences of the Taylor coefficients of the motion; `None` if they are not available.
    recurrences: Option<Recurrences>,
    /// Derivatives of the energy T + V with respect to the coordinates, then the motion variables.
    gradient: Vec<Expr>,
}

impl<'a> SceneEquations<'a> {
    /// Solves the reduced equations for the accelerations. Prepares the recurrences and the gradient of the energy.
    ///
    /// # Errors
    /// Returns [`Unsolved`] if the accelerations are not determined in any configuration, or are not proved.
    pub fn new(reduction: &'a Reduction) -> Result<Self, Unsolved> {
        let mut arena = reduction.arena().clone();
        let equations = &reduction.derivation.equations;
        let solved = SolvedAccelerations::new(&mut arena, equations)?;
        let recurrences = cheapest_recurrences_of(&mut arena, equations, &solved.accelerations);
        let gradient = mechanics::energy_gradient(&mut arena, &mut Simplifier::default(), equations);
        Ok(Self { reduction, arena, solved, recurrences, gradient })
    }

    /// Returns a planner of the scene's functions, whose variables have names that `language` permits.
    #[must_use]
    pub fn planner(&self, language: &Language) -> Planner<'_> {
        Planner::new(
            &self.reduction.model,
            &self.arena,
            &self.reduction.derivation.equations,
            language,
            Sharing::Shared,
        )
    }
}

/// Plan of the generated code for a scene's reduced equations.
pub struct ScenePlan<'a> {
    /// Reduction of the model's equations for the scene.
    pub reduction: &'a Reduction,
    /// Functions that compute the constants and the reduced start from the parameters and a start of the whole model.
    /// Empty for equations in a moving frame, for which no formula gives the start.
    pub from_start: Vec<Function>,
    /// Functions of the equations that people read: accelerations, rates, energies, outputs.
    pub equations: Vec<Function>,
    /// Functions that only runs need: derivative, Jacobian, divisors, gradient of the energy, and difference quotient
    /// of the potential energy.
    pub machine: Vec<Function>,
    /// Names of the divisors that the function `divisors` returns, as formulas; empty if no divisor
    /// can be zero.
    pub divisors: Vec<String>,
    /// Recurrences of the Taylor coefficients; `None` if they are not requested or not known.
    pub taylor: Option<TaylorPlan<'a>>,
    /// Statements about the equations for the header of the file, each as one line.
    pub facts: Vec<String>,
}

/// Choice between planning and leaving out the recurrences of the Taylor coefficients.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Taylor {
    /// The recurrences are planned if the equations have them.
    Planned,
    /// The recurrences of the Taylor coefficients are not planned.
    LeftOut,
}

impl<'a> ScenePlan<'a> {
    /// Plans the functions of a scene of the model `whole`. The entries of the Jacobian and the Taylor recurrences
    /// are planned only if they are requested.
    #[must_use]
    pub fn new(
        whole: &Model,
        planner: &'a Planner<'a>,
        equations: &'a SceneEquations<'a>,
        entries: Jacobian,
        taylor: Taylor,
    ) -> Self {
        let reduction = equations.reduction;
        let steps = &equations.solved.accelerations.steps;
        let mut own = vec![accelerations(planner, steps)];
        own.extend(kinematics_and_energies(planner));
        own.push(outputs(planner, reduction));
        let mut machine = vec![derivative(planner, steps)];
        machine.extend(if entries == Jacobian::Planned { jacobian(planner, &equations.solved) } else { None });
        let (watched, divisors) = divisors(planner, Some(&equations.solved.accelerations));
        machine.extend(watched);
        if reduction.has_energy {
            machine.push(energy_gradient(planner, &equations.gradient));
        }
        if let Some(slope) = &reduction.slope {
            machine.extend(plan_scene_potential_slope(planner, slope));
        }
        let recurrences = equations.recurrences.as_ref().filter(|_| taylor == Taylor::Planned);
        let taylor = recurrences.map(|list| TaylorPlan::new(planner, list));
        let from_start = match reduction.frame {
            None => plan_start_conversion(whole, planner, reduction).to_vec(),
            Some(_) => Vec::new(),
        };
        Self { reduction, from_start, equations: own, machine, divisors, taylor, facts: scene_plan_facts(reduction) }
    }
}

/// Plans the functions `constants` and `start`. From a start of the whole model, they compute the parameters and the
/// state of the reduced equations.
fn plan_start_conversion(whole: &Model, planner: &Planner<'_>, reduction: &Reduction) -> [Function; 2] {
    let e = planner.equations;
    let equations = Equations { coordinates: whole.q(), variables: whole.u(), ..e.clone() };
    let planner = Planner { model: whole, equations: &equations, variables: planner.variables.clone(), ..*planner };
    let kept = || reduction.states.iter().chain(&reduction.quadratures).chain(&reduction.constants);
    let value = |symbol: Expr| -> Value {
        let quantity = kept().find(|quantity| quantity.symbol == symbol);
        let name = planner.arena.symbol_name(symbol).unwrap_or_default();
        (
            format!("{}_value", variable_name_without_primes(name)),
            name.to_owned(),
            quantity.map_or(symbol, |quantity| quantity.of_start),
        )
    };
    let function = |name, about, returns, symbols: &[Expr]| {
        let values: Vec<Value> = symbols.iter().copied().map(value).collect();
        planner.plan_function(name, about, Arguments::State, returns, &values)
    };
    let about = "The parameters of these equations, in the order of `PARAMETERS`, for the motion of the whole model that starts so.";
    let constants = function("constants", about, Returns::Vector, &reduction.model.p());
    let about = "The coordinates and the motion variables of these equations, at this start of the whole model.";
    let state = [e.coordinates.as_slice(), &e.variables].concat();
    [constants, function("start", about, Returns::Pair(e.coordinates.len()), &state)]
}

/// Returns the header lines: outputs, states, quadratures, constants, moving frame, fixed
/// parameters, singular configurations.
fn scene_plan_facts(reduction: &Reduction) -> Vec<String> {
    let arena = reduction.arena();
    let names = |list: &[ReducedQuantity]| match list {
        [] => "none".to_owned(),
        list => list.iter().map(|q| q.name.clone()).collect::<Vec<_>>().join(", "),
    };
    let shown: Vec<&str> = reduction.outputs.iter().map(|o| o.name.as_str()).collect();
    let mut lines = vec![
        format!("Outputs: {}.", shown.join(", ")),
        format!("States: {}. Quadratures: {}.", names(&reduction.states), names(&reduction.quadratures)),
    ];
    for constant in &reduction.constants {
        lines.push(scene_fact_of_constant(
            &constant.name,
            &print_text(arena, constant.of_start),
            &constant.about.text(arena),
        ));
    }
    if let Some(frame) = &reduction.frame {
        let pins: Vec<String> = frame.pins.iter().map(|pin| format!("{} = 0", print_text(arena, *pin))).collect();
        lines.push(format!("In a frame moved by {}, where {}.", frame.about.join(" and by "), pins.join(", ")));
    }
    let folded: Vec<String> =
        reduction.folded.iter().map(|(name, value)| format!("{name} = {}", value.to_f64())).collect();
    if !folded.is_empty() {
        lines.push(format!("Parameters that the scene fixes: {}.", folded.join(", ")));
    }
    lines.push(singular_text(arena, "Singular", &reduction.divisors));
    lines
}

/// Returns the header line for a constant: name, value at the start and description, without
/// repetition.
fn scene_fact_of_constant(name: &str, formula: &str, about: &str) -> String {
    match (name == formula, formula == about) {
        (true, _) => format!("{name}: {about}."),
        (false, true) => format!("{name} = {formula}."),
        (false, false) => format!("{name} = {formula}: {about}."),
    }
}

/// Plans the function `outputs`, which returns the scene's outputs at time t after the start.
fn outputs(planner: &Planner<'_>, reduction: &Reduction) -> Function {
    let values: Vec<Value> = reduction
        .outputs
        .iter()
        .enumerate()
        .map(|(at, o)| {
            let word = o.name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_' || c == '\'');
            let wanted = if word {
                format!("{}_value", variable_name_without_primes(&o.name))
            } else {
                format!("output{}", at + 1)
            };
            (wanted, o.name.clone(), o.value)
        })
        .collect();
    let about = "What the scene asks for, a time t after the start.";
    let arguments = Arguments::Shown { time: reduction.time };
    let definitions = &planner.equations.definitions;
    planner.plan_function_in_steps("outputs", about, arguments, Returns::Vector, definitions, &values)
}

/// Plans the function `energy_gradient`, which returns T + V, then its derivatives with respect to the coordinates
/// and motion variables.
fn energy_gradient(planner: &Planner<'_>, gradient: &[Expr]) -> Function {
    let e = planner.equations;
    let mut arena = planner.arena.clone();
    let energy = arena.add(e.kinetic_energy, e.potential_energy);
    let planner = Planner { arena: &arena, variables: planner.variables.clone(), ..*planner };
    let mut values: Vec<Value> = vec![("energy".to_owned(), "T + V".to_owned(), energy)];
    for (symbol, slope) in e.coordinates.iter().chain(&e.variables).zip(gradient) {
        let name = planner.arena.symbol_name(*symbol).unwrap_or_default();
        values.push((
            format!("energy_by_{}", variable_name_without_primes(name)),
            format!("d(T + V)/d({name})"),
            *slope,
        ));
    }
    let about = "The energy, then its derivatives by the state.";
    planner.plan_function_in_steps("energy_gradient", about, Arguments::State, Returns::Vector, &e.definitions, &values)
}

/// Plans the functions `half_differences` and `potential_slope` for the difference quotient (V(b) − V(a))/(b − a) of
/// the potential energy.
///
/// In both functions, the coordinates `q` are (a, b). The argument `u` holds sin z/z for the angles z that
/// `half_differences` returns. The formula is not rewritten, because sharing would bring back the cancellation that
/// it avoids.
fn plan_scene_potential_slope(planner: &Planner<'_>, slope: &PotentialDifference) -> Vec<Function> {
    let (symbols, angles): (Vec<Expr>, Vec<Expr>) = slope.sincs.iter().copied().unzip();
    let equations = Equations {
        coordinates: slope.ends.to_vec(),
        variables: symbols,
        definitions: Vec::new(),
        required: Vec::new(),
        gauss: None,
        ..planner.equations.clone()
    };
    let planner =
        Planner { equations: &equations, variables: planner.variables.clone(), sharing: Sharing::AsStated, ..*planner };
    let name = |at: usize| (format!("z{}", at + 1), format!("z{}", at + 1), angles[at]);
    let values: Vec<Value> = (0..angles.len()).map(name).collect();
    let value = [("slope".to_owned(), "(V(b) - V(a))/(b - a)".to_owned(), slope.value)];
    vec![
        planner.plan_function(
            "half_differences",
            "The angles z whose sin z/z the slope of the potential needs.",
            Arguments::Configuration,
            Returns::Vector,
            &values,
        ),
        planner.plan_function(
            "potential_slope",
            "The slope of the potential energy between two places `q`, without cancellation; `u` holds sin z/z.",
            Arguments::State,
            Returns::Number,
            &value,
        ),
    ]
}

/// Numbers of operations in one call of the state derivative, for Kane's equations of the whole model and for a
/// scene's reduced equations.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Costs {
    /// Number of operations in one call for the whole model.
    pub full: OperationCount,
    /// Number of operations in one call for the reduced equations of the scene.
    pub scene: OperationCount,
}

/// Counts the operations of the state derivative for the whole model and for a scene's reduced equations.
///
/// # Errors
/// Returns a [`DeriveError`] if Kane's equations cannot be derived, or if the accelerations are not determined in any
/// configuration.
pub fn scene_costs(model: &Model, reduction: &Reduction) -> Result<Costs, DeriveError> {
    let of = |model: &Model, arena: &Arena, equations: &Equations| {
        let mut arena = arena.clone();
        let equations = &equations.with_definitions(&mut arena);
        let solved = mechanics::accelerations(&mut arena, &mut Simplifier::default(), equations)
            .map_err(DeriveError::Unsolved)?;
        Ok(derivative(&Planner::new(model, &arena, equations, &Language::NONE, Sharing::Shared), &solved.steps).cost)
    };
    let kane = derive(model, Formulation::Kane)?;
    let full = of(model, &kane.arena, &kane.equations)?;
    let scene = of(&reduction.model, reduction.arena(), &reduction.derivation.equations)?;
    Ok(Costs { full, scene })
}

/// Counts the operations of the mass matrix and the forcing of equations of motion together, in one call of each.
#[must_use]
pub fn linear_system_cost(model: &Model, derivation: &Derivation) -> OperationCount {
    let mut arena = derivation.arena.clone();
    let equations = &derivation.equations.with_definitions(&mut arena);
    let planner = Planner::new(model, &arena, equations, &Language::NONE, Sharing::Shared);
    let (apart, together) = linear_system(&planner);
    together.map_or_else(|| apart.iter().map(|function| function.cost).sum(), |function| function.cost)
}
