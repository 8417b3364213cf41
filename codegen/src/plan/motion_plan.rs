//! Plan of the functions that integrate a motion: accelerations, divisors, constraints and watched
//! quantities.

use super::equation_functions::{
    accelerations, constraints, definitions_in_state, derivative, divisors, kinematics_and_energies, linear_system,
    needs_reaction, plan_speed_conversions, redundant_constraints,
};
use super::formulation_plan::formulation_facts;
use super::programs::function::{Arguments, Function, Returns, Value};
use super::programs::planner::Planner;
use tripos_derive::algebra::Expr;
use tripos_derive::algebra::solve::elimination::Elimination;

/// Largest number of elimination steps for which the function `derivative` is planned, which
/// computes q̇ and v̇ together.
const MOST_TOGETHER: usize = 400;

/// Quantity that a run watches: a condition that must stay positive, or an event function that
/// crosses zero.
#[derive(Clone, Debug)]
pub struct WatchedQuantity {
    /// Name of the quantity, for messages to people.
    pub name: String,
    /// Term of the quantity's value. It may contain parameters, q, q̇, u and reactions.
    pub value: Expr,
}

/// Plan of the functions that integrate the motion by one formulation of one model.
#[derive(Debug)]
pub struct MotionPlan {
    /// Planned functions, in the order in which they are written. The first is `accelerations`. If the accelerations
    /// are not in closed form, the first are `mass_matrix` and `forcing` of a linear system whose first unknowns are
    /// the accelerations.
    pub functions: Vec<Function>,
    /// True if the accelerations are in closed form.
    pub is_solved: bool,
    /// True if T + V is not constant, because a load without a potential in V does work.
    pub has_power: bool,
    /// Number of motion variables: generalized speeds u or rates q̇.
    pub variables: usize,
    /// Functions `balance_matrix` and `balance_forcing` of the linear system for the accelerations
    /// and reactions, from p, q and u. Empty if no watched quantity contains a reaction, or if the
    /// reactions cannot be derived.
    pub balance: Vec<Function>,
    /// Names of the divisors that the function `divisors` returns, as formulas.
    pub divisors: Vec<String>,
    /// Names of the constraints whose residuals the function `constraints` returns, loops first. A
    /// residual is zero in every exact motion, and drifts in a run without projection.
    pub constraints: Vec<String>,
    /// Indices of the watched quantities whose values the function `conditions` returns, in this order.
    pub conditions: Vec<usize>,
    /// Indices of the watched quantities that cannot be watched, because no linear system gives
    /// their reactions.
    pub unwatched: Vec<usize>,
    /// Statements about the formulation for the header of the module, each as one line.
    pub facts: Vec<String>,
}

impl MotionPlan {
    /// Plans the functions of the equations and, if `solved` is given, of the accelerations. `balance` are equations
    /// of the same model with the reactions among their unknowns, from which the reactions in watched quantities
    /// come.
    #[must_use]
    pub fn new(
        planner: &Planner<'_>,
        solved: Option<&Elimination>,
        watched: &[WatchedQuantity],
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
            functions.extend(plan_speed_conversions(planner));
        }
        let (watches, divisors) = divisors(planner, solved);
        functions.extend(watches);
        functions.extend(constraints(planner));
        functions.extend(redundant_constraints(planner));
        let needs = |at: &usize| needs_reaction(planner, watched[*at].value);
        let (of_reactions, of_state): (Vec<usize>, Vec<usize>) = (0..watched.len()).partition(needs);
        let balance = balance.filter(|balance| !of_reactions.is_empty() && balance_gives_reactions(balance));
        let balance = balance.map_or_else(Vec::new, plan_motion_balance);
        let (mut conditions, unwatched) =
            if balance.is_empty() { (of_state, of_reactions) } else { ((0..watched.len()).collect(), Vec::new()) };
        conditions.sort_unstable();
        functions.extend(plan_motion_conditions(planner, watched, &conditions));
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
            facts: formulation_facts(planner, solved),
        }
    }
}

/// True if the motion variables are generalized speeds, and the unknowns are the accelerations
/// followed by the reactions in the order of the model.
fn balance_gives_reactions(planner: &Planner<'_>) -> bool {
    let (e, reactions) = (planner.equations, &planner.model.reactions);
    let unknowns = e.unknowns.iter().skip(e.variables.len()).copied();
    !e.formulation.is_in_rates() && unknowns.eq(reactions.iter().map(|reaction| reaction.symbol))
}

/// Plans the functions `balance_matrix` and `balance_forcing`, the linear system for accelerations
/// and reactions.
fn plan_motion_balance(planner: &Planner<'_>) -> Vec<Function> {
    let names = ["balance_matrix", "balance_forcing"];
    linear_system(planner).0.into_iter().zip(names).map(|(function, name)| Function { name, ..function }).collect()
}

/// Plans the function `conditions`, which returns the watched quantities with the indices `which`,
/// in this order. `None` if there are none.
fn plan_motion_conditions(planner: &Planner<'_>, watched: &[WatchedQuantity], which: &[usize]) -> Option<Function> {
    let steps = definitions_in_state(planner);
    let values: Vec<Value> = which
        .iter()
        .enumerate()
        .map(|(at, place)| (format!("condition{}", at + 1), watched[*place].name.clone(), watched[*place].value))
        .collect();
    let about = "What is watched, in the order of `CONDITIONS`: the equations hold as long as these are positive.";
    (!values.is_empty()).then(|| {
        planner.plan_function_in_steps("conditions", about, Arguments::Balanced, Returns::Vector, &steps, &values)
    })
}
