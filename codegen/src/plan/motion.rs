//! Functions with which a target runs a motion by itself: accelerations, divisors, constraints and watched quantities.

use super::formulation::{
    accelerations, constraints, conversions, derivative, divisors, facts, kinematics_and_energies, linear_system,
    redundant_constraints,
};
use super::function::{Arguments, Function, Planner, Returns, Value};
use tripos_derive::algebra::Expr;
use tripos_derive::algebra::solve::elimination::Elimination;
use tripos_derive::algebra::term::steps::Definition;
use tripos_derive::{Equations, Model};

/// Most steps of accelerations for which q̇ and v̇ are also computed together, in one function.
const MOST_TOGETHER: usize = 400;

/// Quantity that a run watches: a condition that holds as long as it is positive, or an event where it is zero.
#[derive(Clone, Debug)]
pub struct Watched {
    /// Name of the quantity, for people.
    pub name: String,
    /// Value of the quantity, in parameters, q, q̇, u and reactions.
    pub value: Expr,
}

/// Functions that run one formulation of one model.
#[derive(Debug)]
pub struct MotionPlan {
    /// Planned functions, in the order in which they are read. They begin with `accelerations`, or with `mass_matrix`
    /// and `forcing` of a linear system whose first unknowns are the accelerations. Then come `coordinate_rates`, the
    /// energies and further functions.
    pub functions: Vec<Function>,
    /// True if the accelerations were solved for in closed form.
    pub is_solved: bool,
    /// True if a load without a potential in V does work, so that T + V is not constant.
    pub has_power: bool,
    /// Number of motion variables.
    pub variables: usize,
    /// Functions `balance_matrix` and `balance_forcing` of the linear system that gives the accelerations and then the
    /// reactions, from parameters, q and u. Empty if no watched quantity contains a reaction, or the reactions cannot
    /// be derived.
    pub balance: Vec<Function>,
    /// Names, for people, of the divisors that the function `divisors` returns.
    pub divisors: Vec<String>,
    /// Names of the constraints whose residuals the function `constraints` returns, the loops of the model first. A
    /// residual is zero in every motion, and drifts in a run without projection.
    pub constraints: Vec<String>,
    /// Indices, among the given watched quantities, of the values that the function `conditions` returns.
    pub conditions: Vec<usize>,
    /// Indices of the watched quantities that contain a reaction which no balance gives.
    pub unwatched: Vec<usize>,
    /// Statements about the formulation for a header, line by line.
    pub facts: Vec<String>,
}

impl MotionPlan {
    /// Plans the equations with the accelerations solved from them. Reactions come from `balance`, which are equations
    /// of the model with the reactions among their unknowns.
    #[must_use]
    pub fn new(
        planner: &Planner<'_>,
        solved: Option<&Elimination>,
        watched: &[Watched],
        balance: Option<&Planner<'_>>,
    ) -> Self {
        let mut functions = match solved {
            Some(solved) => vec![accelerations(planner, &solved.steps)],
            None => linear_system(planner).0,
        };
        functions.extend(
            solved
                .filter(|solved| solved.steps.len() <= MOST_TOGETHER)
                .map(|solved| derivative(planner, &solved.steps)),
        );
        functions.extend(kinematics_and_energies(planner));
        if planner.equations.formulation.is_in_rates() {
            functions.extend(conversions(planner));
        }
        let (watches, divisors) = divisors(planner, solved);
        functions.extend(watches);
        functions.extend(constraints(planner));
        functions.extend(redundant_constraints(planner));
        let needs = |at: &usize| needs_reaction(planner, watched[*at].value);
        let (of_reactions, of_state): (Vec<usize>, Vec<usize>) = (0..watched.len()).partition(needs);
        let balance = balance.filter(|balance| !of_reactions.is_empty() && gives_reactions(balance));
        let balance = balance.map_or_else(Vec::new, balanced);
        let (mut conditions, unwatched) =
            if balance.is_empty() { (of_state, of_reactions) } else { ((0..watched.len()).collect(), Vec::new()) };
        conditions.sort_unstable();
        functions.extend(conditions_of(planner, watched, &conditions));
        Self {
            functions,
            is_solved: solved.is_some(),
            has_power: planner.equations.power != Expr::ZERO,
            variables: planner.equations.variables.len(),
            balance,
            divisors,
            constraints: planner.equations.constraints.iter().map(|c| c.name.clone()).collect(),
            conditions,
            unwatched,
            facts: facts(planner, solved),
        }
    }
}

/// True if a watched quantity contains a reaction.
pub(super) fn needs_reaction(planner: &Planner<'_>, e: Expr) -> bool {
    planner.model.reactions.iter().any(|reaction| planner.arena.mentions(e, reaction.symbol))
}

/// True if equations are in u, and their unknowns are the accelerations, then the reactions in the order of the model.
fn gives_reactions(planner: &Planner<'_>) -> bool {
    let (e, reactions) = (planner.equations, &planner.model.reactions);
    let unknowns = e.unknowns.iter().skip(e.variables.len()).copied();
    !e.formulation.is_in_rates() && unknowns.eq(reactions.iter().map(|reaction| reaction.symbol))
}

/// Functions of the linear system of a force balance, with the names `balance_matrix` and `balance_forcing`.
fn balanced(planner: &Planner<'_>) -> Vec<Function> {
    let names = ["balance_matrix", "balance_forcing"];
    linear_system(planner).0.into_iter().zip(names).map(|(function, name)| Function { name, ..function }).collect()
}

/// Function `conditions`, which returns the watched quantities `which`, in this order; `None` if there are none.
fn conditions_of(planner: &Planner<'_>, watched: &[Watched], which: &[usize]) -> Option<Function> {
    let steps = state_steps(planner);
    let values: Vec<Value> = which
        .iter()
        .enumerate()
        .map(|(at, place)| (format!("condition{}", at + 1), watched[*place].name.clone(), watched[*place].value))
        .collect();
    let about = "What is watched, in the order of `CONDITIONS`: the equations hold as long as these are positive.";
    (!values.is_empty())
        .then(|| planner.stepwise("conditions", about, Arguments::Balanced, Returns::Vector, &steps, &values))
}

/// Steps that compute the definitions of the equations and, of u and q̇, those that the equations do not integrate.
pub(super) fn state_steps(planner: &Planner<'_>) -> Vec<Definition> {
    let e = planner.equations;
    e.definitions.iter().copied().chain(other_variables(planner.model, e)).collect()
}

/// Steps that compute those of u and q̇ that the equations do not integrate.
pub(super) fn other_variables(model: &Model, e: &Equations) -> Vec<Definition> {
    let (symbols, values) = if e.formulation.is_in_rates() {
        (model.u(), &e.generalized_speeds)
    } else {
        (model.q_dot(), &e.coordinate_rates)
    };
    symbols.into_iter().zip(values).map(|(symbol, value)| Definition { symbol, value: *value }).collect()
}
