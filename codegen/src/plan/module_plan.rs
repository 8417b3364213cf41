//! Plan of all functions of one set of equations, for modules in C, Python, MATLAB and CasADi.

use super::equation_functions::{
    accelerations, constraints, definitions_in_state, derivative, divisors, inverse_dynamics, jacobian,
    kinematics_and_energies, linear_system, needs_reaction, parameter_jacobian, plan_speed_conversions,
    redundant_constraints, residual,
};
use super::formulation_plan::formulation_facts;
use super::programs::function::{Arguments, Function, Returns, Value};
use super::programs::planner::Planner;
use super::programs::variable_names::Language;
use super::regressor::RegressorFunctions;
use super::scene_outputs::SceneOutputs;
use tripos_derive::algebra::Expr;
use tripos_derive::algebra::term::steps::Definition;
use tripos_derive::mechanics::{Jacobian, SolvedAccelerations};
use tripos_derive::model::DomainCondition;

/// Accelerations in closed form, with their derivatives with respect to the state and to the parameters.
#[derive(Clone, Debug)]
pub struct Solution {
    /// Accelerations and their derivatives with respect to the state, proved from the equations.
    pub by_state: SolvedAccelerations,
    /// Derivatives of q̇ and v̇ with respect to the parameters, a column for each parameter. `None` if they are not
    /// requested or would be too long.
    pub by_parameters: Option<Jacobian>,
}

/// Plan of all functions of one set of equations, for a module in C, Python, MATLAB or CasADi.
#[derive(Debug)]
pub struct ModulePlan {
    /// Planned functions, in the order in which they are written.
    pub functions: Vec<Function>,
    /// Names of the divisors that the function `divisors` returns, as formulas.
    pub divisors: Vec<String>,
    /// Names of the constraints whose residuals the function `constraints` returns.
    pub constraints: Vec<String>,
    /// Names and texts of the conditions whose values the function `conditions` returns.
    pub conditions: Vec<String>,
    /// Names of the conditions of the domain that no function returns, because they contain reactions.
    pub unchecked: Vec<String>,
    /// Names of the unknowns of the linear system: the accelerations, then the reactions or multipliers.
    pub unknowns: Vec<String>,
    /// Titled lists with the names of the entries of further results, such as outputs and events.
    pub further: Vec<(&'static str, Vec<String>)>,
    /// Statements about the equations for the header of the module, each as one line.
    pub facts: Vec<String>,
}

impl ModulePlan {
    /// Name of the function that computes the base parameters.
    pub const BASE_PARAMETERS: &'static str = "base_parameters";

    /// Names of all functions that a plan may contain, in the order in which they are written.
    pub const FUNCTIONS: [&'static str; 28] = [
        "mass_matrix",
        "forcing",
        "linear_system",
        "residual",
        "accelerations",
        "coordinate_rates",
        "kinetic_energy",
        "potential_energy",
        "power",
        "generalized_speeds",
        "generalized_speed_rates",
        "motion_variables",
        "derivative",
        "jacobian",
        "parameter_jacobian",
        "inverse_dynamics",
        "divisors",
        "constraints",
        "constraint_slopes",
        "redundant_constraints",
        "conditions",
        "outputs",
        "events",
        "regressor",
        "regressor_rest",
        "inertial_parameters",
        "base_regressor",
        "base_parameters",
    ];

    /// Plans all functions of a set of equations. If `solution` is given, the accelerations and
    /// their derivatives get functions too.
    #[must_use]
    pub fn new(planner: &Planner<'_>, solution: Option<&Solution>) -> Self {
        let e = planner.equations;
        let (mut functions, together) = linear_system(planner);
        functions.extend(together);
        functions.push(residual(planner));
        let solved = solution.map(|solution| &solution.by_state.accelerations);
        functions.extend(solved.map(|solved| accelerations(planner, &solved.steps)));
        functions.extend(kinematics_and_energies(planner));
        if e.formulation.is_in_rates() {
            functions.extend(plan_speed_conversions(planner));
        }
        if let Some(solution) = solution {
            let steps = &solution.by_state.accelerations.steps;
            functions.push(derivative(planner, steps));
            functions.extend(jacobian(planner, &solution.by_state));
            functions.extend(solution.by_parameters.as_ref().map(|slopes| parameter_jacobian(planner, slopes)));
        }
        functions.extend(inverse_dynamics(planner));
        let (watched, divisors) = divisors(planner, solved);
        functions.extend(watched);
        let columns = e.coordinates.len() + e.variables.len();
        functions.extend(constraints(planner).into_iter().map(|function| match function.name {
            "constraint_slopes" => Function { returns: Returns::Table { columns }, ..function },
            _ => function,
        }));
        functions.extend(redundant_constraints(planner));
        let (of_domain, conditions) = plan_module_conditions(planner);
        functions.extend(of_domain);
        let name = |symbol: &Expr| planner.arena.symbol_name(*symbol).unwrap_or_default().to_owned();
        Self {
            functions,
            divisors,
            constraints: e.constraints.iter().map(|c| c.name.clone()).collect(),
            conditions,
            unchecked: unchecked_module_conditions(planner).map(|condition| condition.name.clone()).collect(),
            unknowns: e.unknowns.iter().map(name).collect(),
            further: Vec::new(),
            facts: formulation_facts(planner, solved)
                .into_iter()
                .chain(unchecked_module_conditions(planner).map(module_fact_of_unchecked))
                .collect(),
        }
    }

    /// Adds functions for the outputs and events of a scene.
    pub fn add_scene_outputs(&mut self, planner: &Planner<'_>, shown: &SceneOutputs) {
        self.functions.extend(shown.functions(planner));
        self.list(shown.names());
    }

    /// Adds functions for the regressor: the matrix whose product with the inertial parameters is the generalized
    /// forces.
    pub fn add_regressor(&mut self, planner: &Planner<'_>, regression: &RegressorFunctions, language: &Language) {
        self.functions.extend(regression.functions(planner.model, language));
        self.list(regression.names());
    }

    /// Adds the function `base_parameters`, if the equations contain parameters that follow from the other parameters.
    pub fn add_base_parameters(&mut self, planner: &Planner<'_>, base_parameters: &[Definition]) {
        if base_parameters.is_empty() {
            return;
        }
        let name = |symbol: Expr| planner.arena.symbol_name(symbol).unwrap_or_default().to_owned();
        let values =
            base_parameters.iter().map(|base| (format!("{}_value", name(base.symbol)), name(base.symbol), base.value));
        let values: Vec<Value> = values.collect();
        let about = "Base parameters from the parameters of the model: the values of the last entries of p.";
        let function =
            planner.plan_function(Self::BASE_PARAMETERS, about, Arguments::Parameters, Returns::Vector, &values);
        self.functions.push(function);
        let last = match base_parameters.len() {
            1 => "The last parameter is a base parameter".to_owned(),
            count => format!("The last {count} parameters are base parameters"),
        };
        self.facts
            .push(format!("{last}. The function `base_parameters` computes them from the parameters before them."));
    }

    /// Adds titled lists of names of results, except empty lists.
    fn list<const N: usize>(&mut self, names: [(&'static str, Vec<String>); N]) {
        self.further.extend(names.into_iter().filter(|(_, names)| !names.is_empty()));
    }

    /// True if the plan contains a function of this name.
    #[must_use]
    pub fn has(&self, name: &str) -> bool {
        self.functions.iter().any(|function| function.name == name)
    }
}

/// Returns the header line for a condition that no function checks because it contains a reaction.
fn module_fact_of_unchecked(condition: &DomainCondition) -> String {
    format!("No function checks the condition {} ({}), which contains a reaction.", condition.name, condition.text)
}

/// Returns the conditions of the model's domain that contain reactions.
fn unchecked_module_conditions<'a>(planner: &'a Planner<'_>) -> impl Iterator<Item = &'a DomainCondition> {
    planner.model.domain.iter().filter(|c| needs_reaction(planner, c.positive))
}

/// Plans the function `conditions`, whose values are positive in the domain of the model. The second result is their
/// names. Conditions on reactions are left out, because a state alone does not give reactions. The function is `None`
/// if no condition remains.
fn plan_module_conditions(planner: &Planner<'_>) -> (Option<Function>, Vec<String>) {
    let kept: Vec<_> = planner.model.domain.iter().filter(|c| !needs_reaction(planner, c.positive)).collect();
    let steps = definitions_in_state(planner);
    let values: Vec<Value> =
        kept.iter().enumerate().map(|(at, c)| (format!("condition{}", at + 1), c.name.clone(), c.positive)).collect();
    let about = "Domain of the model: the equations hold as long as these values are positive.";
    let names = kept.iter().map(|c| format!("{} ({})", c.name, c.text)).collect();
    let planned = (!values.is_empty()).then(|| {
        planner.plan_function_in_steps("conditions", about, Arguments::State, Returns::Vector, &steps, &values)
    });
    (planned, names)
}
