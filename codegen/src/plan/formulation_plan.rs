//! Plan of the Rust code for one formulation: its functions, and the statements about them in the file's header.

use super::equation_functions::{
    accelerations, constraints, derivative, divisors, inverse_dynamics, jacobian, kinematics_and_energies,
    linear_system, plan_speed_conversions, text_of_equation_symbols,
};
use super::programs::function::{Function, LineComments};
use super::programs::planner::Planner;
use super::taylor_plan::TaylorPlan;
use crate::taylor::Recurrences;
use tripos_derive::algebra::solve::elimination::Elimination;
use tripos_derive::algebra::text::print::print_text;
use tripos_derive::algebra::{Arena, Expr};
use tripos_derive::mechanics::{SolvedAccelerations, distinct_divisors};

/// Largest number of elimination steps for which the function `derivative` is planned, which computes q̇ and v̇
/// together with shared terms.
const MOST_REPEATED: usize = 100;

/// Largest number of divisors that the header lists by their formulas. If there are more, only
/// their number is stated.
const MOST_LISTED: usize = 12;

/// Plan of the generated Rust code for one formulation of one model.
pub struct FormulationPlan<'a> {
    /// Planner, with the model, the arena and the names of variables.
    pub planner: &'a Planner<'a>,
    /// Functions of the equations that people read, such as mass matrix and forcing, in order.
    pub equations: Vec<Function>,
    /// Functions that only runs need: `linear_system`, `divisors`, `constraints` and `inverse_dynamics`. Also
    /// `derivative` and `jacobian`, if the accelerations are in closed form and not too long.
    pub machine: Vec<Function>,
    /// Names of the divisors that the function `divisors` returns, as formulas; empty if no divisor
    /// can be zero.
    pub divisors: Vec<String>,
    /// Names of the constraints whose residuals the function `constraints` returns; empty if no run can violate a
    /// constraint.
    pub constraints: Vec<String>,
    /// Recurrences of the Taylor coefficients of the motion; `None` if they are not requested.
    pub taylor: Option<TaylorPlan<'a>>,
    /// Number of operations of the function `accelerations`. `None` if the accelerations are not in closed form.
    pub solved_cost: Option<usize>,
    /// Statements about the formulation for the header of the generated file, each as one line.
    pub facts: Vec<String>,
}

/// Choice between planning and leaving out the function `jacobian`, which returns the Jacobian of the state
/// derivative.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Jacobian {
    /// The function `jacobian` is planned if the accelerations are in closed form.
    Planned,
    /// The function `jacobian` is not planned.
    LeftOut,
}

impl<'a> FormulationPlan<'a> {
    /// Plans the functions of the equations. If `solved` is given, the accelerations get functions too. The Jacobian
    /// and the Taylor recurrences are planned only if they are requested.
    #[must_use]
    pub fn new(
        planner: &'a Planner<'a>,
        solved: Option<&SolvedAccelerations>,
        entries: Jacobian,
        recurrences: Option<&'a Recurrences>,
    ) -> Self {
        let (mut equations, together) = linear_system(planner);
        let solution = solved.map(|solved| accelerations(planner, &solved.accelerations.steps));
        let solved_cost = solution.as_ref().map(|planned| planned.cost.operations);
        equations.extend(solution);
        equations.extend(kinematics_and_energies(planner));
        if planner.equations.formulation.is_in_rates() {
            equations.extend(plan_speed_conversions(planner));
        }
        let mut machine = solved.map_or_else(Vec::new, |solved| {
            let steps = &solved.accelerations.steps;
            // Long steps are not written twice. Then q̇ and v̇ are computed one after the other.
            let together = (steps.len() <= MOST_REPEATED).then(|| derivative(planner, steps));
            let jacobian = if entries == Jacobian::Planned { jacobian(planner, solved) } else { None };
            together.into_iter().chain(jacobian).collect()
        });
        machine.extend(together);
        let (divisors, names) = divisors(planner, solved.map(|solved| &solved.accelerations));
        machine.extend(divisors);
        machine.extend(constraints(planner));
        let kept = planner.equations.constraints.iter().map(|c| c.name.clone()).collect();
        // Inverse dynamics repeats what matrix and forcing state, so it is among the functions for runs.
        machine.extend(inverse_dynamics(planner));
        let taylor = recurrences.map(|list| TaylorPlan::new(planner, list));
        Self {
            planner,
            equations,
            machine,
            divisors: names,
            constraints: kept,
            taylor,
            solved_cost,
            facts: formulation_facts(planner, solved.map(|solved| &solved.accelerations)),
        }
    }
}

/// Returns the header lines that state the unknowns, and the configurations in which the equations are singular.
pub(super) fn formulation_facts(planner: &Planner<'_>, solved: Option<&Elimination>) -> Vec<String> {
    let e = planner.equations;
    let mut lines = vec![
        format!("Unknowns: {}.", text_of_equation_symbols(planner.arena, &e.unknowns)),
        singular_text(planner.arena, "The kinematic equations are singular", &e.divisors),
    ];
    lines.extend(solved.map(|solved| divisors_text(planner, &solved.divisors)));
    lines
}

/// Returns the header line that states the divisors of the solved accelerations, or only their
/// number if there are many.
fn divisors_text(planner: &Planner<'_>, divisors: &[Expr]) -> String {
    if divisors.is_empty() {
        return "The accelerations divide by nothing.".to_owned();
    }
    let distinct = distinct_divisors(planner.arena, divisors);
    // Long formulations divide by named terms. Their names would tell the reader nothing here.
    if distinct.len() > MOST_LISTED || planner.explanation() == LineComments::Names {
        let count = distinct.len();
        return format!("The accelerations divide by {count} pivots, which are positive where the mass matrix is.");
    }
    let list: Vec<String> = distinct.iter().map(|d| print_text(planner.arena, *d)).collect();
    format!("The accelerations divide by {}.", list.join(", by "))
}

/// Returns the header line that states the configurations in which one of the divisors is zero. `what` is the
/// beginning of the line.
pub(super) fn singular_text(arena: &Arena, what: &str, divisors: &[Expr]) -> String {
    let places: Vec<String> =
        distinct_divisors(arena, divisors).iter().map(|d| format!("{} = 0", print_text(arena, *d))).collect();
    match places.as_slice() {
        [] => format!("{what} nowhere."),
        list => format!("{what} where {}.", list.join(" and where ")),
    }
}
