//! Jacobian of a first-order system: derivatives of q̇ and v̇ with respect to the state, by the chain rule over a
//! list of definitions.

use crate::algebra::form::simplify::{Simplifier, operation_count, operation_count_of_all};
use crate::algebra::solve::elimination::Elimination;
use crate::algebra::term::calculus::Differential;
use crate::algebra::term::steps::{Definition, fresh_symbol, needed_steps};
use crate::algebra::{Arena, Expr};
use crate::mechanics::equations::Equations;

/// Largest number of operations in the derivative of an intermediate quantity for which the derivative gets no symbol
/// of its own.
const LONGEST_SLOPE: usize = 6;

/// Jacobian ∂(q̇, v̇)/∂(q, v) of a first-order system as a list of definitions: the whole matrix,
/// or its product with a direction.
#[derive(Clone, Debug, Default)]
pub struct Jacobian {
    /// Definitions in the order of computation: those of the accelerations and of quantities that they need, then the
    /// derivatives of both.
    pub steps: Vec<Definition>,
    /// Entries of the Jacobian, row by row: first q̇, then v̇. It has a column for each coordinate,
    /// then for each motion variable. The product with a direction has a single column.
    pub entries: Vec<Vec<Expr>>,
    /// Symbols of the direction, one for each coordinate and motion variable. Empty if the entries are
    /// the whole Jacobian.
    pub direction: Vec<Expr>,
}

/// Largest number of derivatives (definitions × states) of a whole Jacobian. If there are more, only the Jacobian's
/// product with a direction is derived.
const MOST_SLOPES: usize = 2000;
/// Largest number of operations × states for a whole Jacobian, which limits the length of its formulas.
const MOST_SLOPES_OF_OPERATIONS: usize = 8000;

/// Differentiates q̇ and v̇ exactly with respect to q and v. It uses the chain rule over the solved definitions, so
/// that no term is expanded. A long Jacobian is given only as its product with a direction.
pub fn jacobian(
    arena: &mut Arena,
    simplifier: &mut Simplifier,
    equations: &Equations,
    solved: &Elimination,
) -> Jacobian {
    let n = equations.variables.len();
    let of_state = [&equations.unknowns[..n], &equations.coordinate_rates].concat();
    let steps = needed_steps(arena, &solved.steps, &of_state);
    let states: Vec<Expr> = equations.coordinates.iter().chain(&equations.variables).copied().collect();
    if is_long_jacobian(arena, &steps, states.len()) {
        return jacobian_direction_product(arena, simplifier, equations, steps);
    }
    let rates = [&equations.coordinate_rates, &equations.unknowns[..n]].concat();
    whole_jacobian(arena, simplifier, &rates, steps, &states)
}

/// Derivatives of `values` with respect to the symbols `along`, with a row for each value and a column for each
/// symbol. The values may contain symbols that `steps` define. `None` if the Jacobian would be too long.
pub(super) fn jacobian_along_symbols(
    arena: &mut Arena,
    simplifier: &mut Simplifier,
    steps: &[Definition],
    values: &[Expr],
    along: &[Expr],
) -> Option<Jacobian> {
    let steps = needed_steps(arena, steps, values);
    let is_short = !is_long_jacobian(arena, &steps, along.len());
    is_short.then(|| whole_jacobian(arena, simplifier, values, steps, along))
}

/// True if the derivatives of all definitions with respect to `count` symbols would be too many or too long for a
/// whole Jacobian.
fn is_long_jacobian(arena: &Arena, steps: &[Definition], count: usize) -> bool {
    let values: Vec<Expr> = steps.iter().map(|step| step.value).collect();
    count * steps.len() > MOST_SLOPES || count * operation_count_of_all(arena, &values) > MOST_SLOPES_OF_OPERATIONS
}

/// Derives the whole Jacobian of `values`, with a row for each value and a column for each symbol in `along`.
fn whole_jacobian(
    arena: &mut Arena,
    simplifier: &mut Simplifier,
    values: &[Expr],
    mut steps: Vec<Definition>,
    along: &[Expr],
) -> Jacobian {
    let accelerations = steps.clone();
    let mut columns = Vec::new();
    for &variable in along {
        let mut slope_of = Differential::partial(variable);
        for step in &accelerations {
            let slope = slope_of.apply(arena, step.value);
            let mut slope = simplifier.simplify(arena, slope);
            if operation_count(arena, slope) > LONGEST_SLOPE {
                let wanted = format!(
                    "{}_by_{}",
                    jacobian_symbol_name(arena, step.symbol),
                    jacobian_symbol_name(arena, variable)
                );
                let symbol = fresh_symbol(arena, &wanted);
                steps.push(Definition { symbol, value: slope });
                slope = symbol;
            }
            slope_of.set_rate(step.symbol, slope);
        }
        let slopes: Vec<Expr> = values.iter().map(|e| slope_of.apply(arena, *e)).collect();
        columns.push(slopes.into_iter().map(|e| simplifier.simplify(arena, e)).collect::<Vec<_>>());
    }
    let entries = (0..values.len()).map(|i| columns.iter().map(|column| column[i]).collect()).collect();
    Jacobian { steps, entries, direction: Vec::new() }
}

/// Name of a symbol in a form that other names can contain, such as `u1_dot` for `u1'`.
fn jacobian_symbol_name(arena: &Arena, symbol: Expr) -> String {
    arena.symbol_name(symbol).unwrap_or_default().replace("''", "_ddot").replace('\'', "_dot")
}

/// Derives the product of the Jacobian with a direction. It needs a single derivative of each definition, along the
/// direction.
fn jacobian_direction_product(
    arena: &mut Arena,
    simplifier: &mut Simplifier,
    equations: &Equations,
    accelerations: Vec<Definition>,
) -> Jacobian {
    let states = equations.coordinates.iter().chain(&equations.variables);
    let along: Vec<(Expr, Expr)> = states
        .map(|state| {
            let wanted = format!("d_{}", jacobian_symbol_name(arena, *state));
            (*state, fresh_symbol(arena, &wanted))
        })
        .collect();
    let mut slope_of = Differential::along(&along);
    let mut steps = Vec::with_capacity(2 * accelerations.len());
    for step in accelerations {
        steps.push(step);
        let slope = slope_of.apply(arena, step.value);
        let mut slope = simplifier.simplify(arena, slope);
        if operation_count(arena, slope) > 0 {
            let wanted = format!("d_{}", jacobian_symbol_name(arena, step.symbol));
            let symbol = fresh_symbol(arena, &wanted);
            steps.push(Definition { symbol, value: slope });
            slope = symbol;
        }
        slope_of.set_rate(step.symbol, slope);
    }
    let rates = equations.coordinate_rates.iter().chain(&equations.unknowns[..equations.variables.len()]);
    let entries = rates.map(|e| vec![slope_of.apply(arena, *e)]).collect();
    Jacobian { steps, entries, direction: along.into_iter().map(|(_, direction)| direction).collect() }
}
