//! Functions that several plans contain. Each is planned from one set of equations.

use super::programs::function::{Arguments, Function, Returns, Value};
use super::programs::planner::Planner;
use super::programs::variable_names::variable_name_without_primes;
use std::ops::RangeInclusive;
use tripos_derive::algebra::solve::elimination::Elimination;
use tripos_derive::algebra::term::calculus::Substitution;
use tripos_derive::algebra::term::steps::Definition;
use tripos_derive::algebra::{Arena, Expr};
use tripos_derive::mechanics::{Constrained, Divisors, EquationsOrigin, SolvedAccelerations};
use tripos_derive::{Equations, Model};

/// Number of operations of mass matrix and forcing for which a function that computes both is planned. Shorter
/// systems cost little when computed separately; for longer systems, compile times would double.
const WORTH_SHARING: RangeInclusive<usize> = 200..=4000;

/// Plans the functions `mass_matrix` and `forcing`. The second result is `linear_system`, which computes both. It is
/// `None` unless it saves a tenth of the operations.
pub(super) fn linear_system(planner: &Planner<'_>) -> (Vec<Function>, Option<Function>) {
    let e = planner.equations;
    let n = e.unknowns.len();
    let place = |i: usize, j: usize| format!("{}{}", function_entry_index(i, n), function_entry_index(j, n));
    let entries: Vec<Value> = (0..n * n)
        .map(|at| (at / n, at % n))
        .map(|(i, j)| (format!("m{}", place(i, j)), format!("M{}", place(i, j)), e.matrix[i][j]))
        .collect();
    let forcing: Vec<Value> = e
        .forcing
        .iter()
        .enumerate()
        .map(|(i, value)| {
            (format!("f{}", function_entry_index(i, n)), format!("f{}", function_entry_index(i, n)), *value)
        })
        .collect();
    let symmetry = if e.symmetric { "symmetric, rows" } else { "rows" };
    let product = e.formulation.equation(planner.model);
    let matrix_about =
        format!("Matrix of the linear system {product}; {symmetry} {}.", e.row_names(planner.model).join(", "));
    let forcing_about = format!(
        "Right-hand side of the linear system; unknowns {}.",
        text_of_equation_symbols(planner.arena, &e.unknowns)
    );
    let returns = Returns::Matrix { symmetric: e.symmetric };
    let planned = |name, about: &str, returns, values: &[Value]| {
        planner.plan_function_in_steps(name, about, Arguments::State, returns, &e.definitions, values)
    };
    let apart = vec![
        planned("mass_matrix", &matrix_about, returns, &entries),
        planned("forcing", &forcing_about, Returns::Vector, &forcing),
    ];
    let operations: usize = apart.iter().map(|function| function.cost.operations).sum();
    let about =
        format!("Matrix of the linear system {product} row by row, and its right-hand side, which share terms.");
    let together = WORTH_SHARING
        .contains(&operations)
        .then(|| planned("linear_system", &about, Returns::System(n), &[entries, forcing].concat()))
        .filter(|together| 10 * together.cost.operations <= 9 * operations);
    (apart, together)
}

/// Plans the function `accelerations`, which returns the solved accelerations v̇ as a vector.
pub(super) fn accelerations(planner: &Planner<'_>, steps: &[Definition]) -> Function {
    let unknowns = unknown_accelerations(planner);
    let about = format!(
        "The accelerations {}, solved for when this code was generated.",
        text_of_equation_symbols(planner.arena, unknowns)
    );
    let values = named_function_values(names(planner.arena, unknowns).into_iter(), unknowns);
    planner.plan_function_in_steps("accelerations", &about, Arguments::State, Returns::Vector, steps, &values)
}

/// Plans the function `jacobian`, which returns the square matrix ∂(q̇, v̇)/∂(q, v). `None` for large systems, whose
/// code is differentiated as it runs.
pub(super) fn jacobian(planner: &Planner<'_>, solved: &SolvedAccelerations) -> Option<Function> {
    let e = planner.equations;
    if !solved.jacobian.direction.is_empty() {
        return None;
    }
    let state = names(planner.arena, &[e.coordinates.as_slice(), &e.variables].concat());
    let q_dot = planner.model.coordinates.iter().map(|c| format!("{}'", c.name));
    let slopes: Vec<Value> = q_dot
        .chain(names(planner.arena, unknown_accelerations(planner)))
        .zip(&solved.jacobian.entries)
        .flat_map(|(rate, row)| jacobian_row_values(&rate, &state, row))
        .collect();
    let about = format!("Jacobian of the derivative by the state; columns {}.", state.join(", "));
    let returns = Returns::Matrix { symmetric: false };
    Some(planner.plan_function_in_steps("jacobian", &about, Arguments::State, returns, &solved.jacobian.steps, &slopes))
}

/// Plans the function `parameter_jacobian`, which returns ∂(q̇, v̇)/∂p: a row for each rate, a
/// column for each parameter.
pub(super) fn parameter_jacobian(planner: &Planner<'_>, slopes: &tripos_derive::mechanics::Jacobian) -> Function {
    let parameters: Vec<String> = planner.model.parameters.iter().map(|p| p.name.clone()).collect();
    let q_dot = planner.model.coordinates.iter().map(|c| format!("{}'", c.name));
    let rows = q_dot.chain(names(planner.arena, unknown_accelerations(planner))).zip(&slopes.entries);
    let values: Vec<Value> = rows.flat_map(|(rate, row)| jacobian_row_values(&rate, &parameters, row)).collect();
    let about = format!("Slopes of the derivative along the parameters; columns {}.", parameters.join(", "));
    let returns = Returns::Table { columns: parameters.len() };
    planner.plan_function_in_steps("parameter_jacobian", &about, Arguments::State, returns, &slopes.steps, &values)
}

/// Returns the values of one row of a Jacobian, with their names: the derivatives of one rate with respect to the
/// quantities `along`.
fn jacobian_row_values(rate: &str, along: &[String], row: &[Expr]) -> Vec<Value> {
    let entry = |(by, value): (&String, &Expr)| {
        (
            format!("{}_by_{}_value", variable_name_without_primes(rate), variable_name_without_primes(by)),
            format!("d({rate})/d({by})"),
            *value,
        )
    };
    along.iter().zip(row).map(entry).collect()
}

/// Plans the function `residual`, which returns M x − f for any unknowns x. The residual is zero if
/// x solves the linear system.
pub(super) fn residual(planner: &Planner<'_>) -> Function {
    let e = planner.equations;
    let mut arena = planner.arena.clone();
    let n = e.unknowns.len();
    let values: Vec<Value> = (0..n)
        .map(|i| {
            let products: Vec<Expr> = (0..n).map(|j| arena.mul(e.matrix[i][j], e.unknowns[j])).collect();
            let product = products.into_iter().fold(Expr::ZERO, |sum, term| arena.add(sum, term));
            let name = format!("residual{}", function_entry_index(i, n));
            (name.clone(), name, arena.sub(product, e.forcing[i]))
        })
        .collect();
    let planner = Planner { arena: &arena, variables: planner.variables.clone(), ..*planner };
    let about = format!(
        "Residual M x - f of the linear system, for any unknowns x = {}.",
        text_of_equation_symbols(&arena, &e.unknowns)
    );
    planner.plan_function_in_steps(
        "residual",
        &about,
        Arguments::StateAndUnknowns,
        Returns::Vector,
        &e.definitions,
        &values,
    )
}

/// Plans the function `divisors`, which returns the divisors of q̇ and v̇ that may be zero. The second result is
/// their names. The function is `None` if there are no such divisors.
pub(super) fn divisors(planner: &Planner<'_>, solved: Option<&Elimination>) -> (Option<Function>, Vec<String>) {
    let divisors = Divisors::of(planner.arena, planner.equations, solved);
    let names = divisors.names(planner.arena);
    let name = |at: usize| format!("divisor{}", function_entry_index(at, names.len()));
    let named: Vec<Value> =
        divisors.values.iter().enumerate().map(|(at, value)| (name(at), name(at), *value)).collect();
    let about = "What the equations divide by: where one of these is zero, they have no value.";
    let planned = (!named.is_empty()).then(|| {
        planner.plan_function_in_steps("divisors", about, Arguments::State, Returns::Vector, &divisors.steps, &named)
    });
    (planned, names)
}

/// Plans the functions `constraints` (residuals) and `constraint_slopes` (their derivatives with respect to the
/// state). They belong to the constraints that runs maintain. Empty without constraints.
pub(super) fn constraints(planner: &Planner<'_>) -> Vec<Function> {
    let e = planner.equations;
    if e.constraints.is_empty() {
        return Vec::new();
    }
    let name = |at: usize| format!("residual{}", function_entry_index(at, e.constraints.len()));
    let value = |(at, c): (usize, &Constrained)| (name(at), c.name.clone(), c.value);
    let values: Vec<Value> = e.constraints.iter().enumerate().map(value).collect();
    let state = names(planner.arena, &[e.coordinates.as_slice(), &e.variables].concat());
    let slopes_of = |(at, c): (usize, &Constrained)| {
        let slope = |(by, value): (&String, &Expr)| {
            (format!("{}_by_{}", name(at), variable_name_without_primes(by)), format!("d({})/d({by})", c.name), *value)
        };
        state.iter().zip(&c.slopes).map(slope).collect::<Vec<_>>()
    };
    let slopes: Vec<Value> = e.constraints.iter().enumerate().flat_map(slopes_of).collect();
    let about = "What is zero where the constraints hold, each in its own unit.";
    let about_slopes = format!("Slopes of the constraints, one after the other, along {}.", state.join(", "));
    let planned = |name, about, values: &[Value]| {
        planner.plan_function_in_steps(name, about, Arguments::State, Returns::Vector, &e.definitions, values)
    };
    vec![planned("constraints", about, &values), planned("constraint_slopes", &about_slopes, &slopes)]
}

/// Plans the function `redundant_constraints`, which returns the residuals of redundant constraints. They are zero in
/// closed poses if the mechanism has as many degrees of freedom as when it was derived. `None` without such
/// constraints.
pub(super) fn redundant_constraints(planner: &Planner<'_>) -> Option<Function> {
    let closed = planner.model.closed.iter().enumerate();
    let values: Vec<Value> =
        closed.map(|(at, c)| (format!("redundant{}", at + 1), c.name.clone(), c.equation)).collect();
    let about = "What is zero wherever the loops are closed, unless numbers take a freedom from the mechanism.";
    (!values.is_empty()).then(|| {
        planner.plan_function("redundant_constraints", about, Arguments::Configuration, Returns::Vector, &values)
    })
}

/// Returns the symbols of the accelerations v̇, one for each motion variable.
fn unknown_accelerations<'a>(planner: &'a Planner<'_>) -> &'a [Expr] {
    &planner.equations.unknowns[..planner.equations.variables.len()]
}

/// Returns the names of symbols of the arena.
fn names(arena: &Arena, symbols: &[Expr]) -> Vec<String> {
    symbols.iter().map(|s| arena.symbol_name(*s).unwrap_or_default().to_owned()).collect()
}

/// Plans the function `derivative`, which returns the state derivative as two vectors, q̇ and v̇.
#[must_use]
pub fn derivative(planner: &Planner<'_>, steps: &[Definition]) -> Function {
    let e = planner.equations;
    let v_dot = named_function_values(
        names(planner.arena, unknown_accelerations(planner)).into_iter(),
        unknown_accelerations(planner),
    );
    let q_dot =
        named_function_values(planner.model.coordinates.iter().map(|c| format!("{}'", c.name)), &e.coordinate_rates);
    let both = [q_dot.clone(), v_dot].concat();
    planner.plan_function_in_steps(
        "derivative",
        "The derivative of the state: the rates of the coordinates, and the accelerations.",
        Arguments::State,
        Returns::Pair(q_dot.len()),
        steps,
        &both,
    )
}

/// Plans the functions `coordinate_rates`, `kinetic_energy` and `potential_energy`. Plans also
/// `power` if loads without a potential do work.
pub(super) fn kinematics_and_energies(planner: &Planner<'_>) -> Vec<Function> {
    let e = planner.equations;
    let rates =
        named_function_values(planner.model.coordinates.iter().map(|c| format!("{}'", c.name)), &e.coordinate_rates);
    let about = "Kinematic equations: the time derivatives of the coordinates.";
    let kinetic = [("energy".to_owned(), "T".to_owned(), e.kinetic_energy)];
    let potential = [("energy".to_owned(), "V".to_owned(), e.potential_energy)];
    let function = |name, about, arguments, returns, values: &[Value]| {
        planner.plan_function_in_steps(name, about, arguments, returns, &e.definitions, values)
    };
    let about_potential = if e.by == EquationsOrigin::Reduced && !e.definitions.is_empty() {
        "Potential energy V, with the kinetic energy of what the momenta determine."
    } else {
        "Potential energy V: of gravity, and of the applied loads that have a potential."
    };
    let power = [("rate".to_owned(), "d(T + V)/dt".to_owned(), e.power)];
    let about_power = if equations_have_given_motion(planner) {
        "The power of the loads that have no potential. Given motions exert power too: this is not the rate of T + V."
    } else {
        "The power of the loads that have no potential: the rate of T + V."
    };
    let power =
        (e.power != Expr::ZERO).then(|| function("power", about_power, Arguments::State, Returns::Number, &power));
    let energies = [
        function("coordinate_rates", about, Arguments::State, Returns::Vector, &rates),
        function("kinetic_energy", "Kinetic energy T.", Arguments::State, Returns::Number, &kinetic),
        function("potential_energy", about_potential, Arguments::Configuration, Returns::Number, &potential),
    ];
    energies.into_iter().chain(power).collect()
}

/// Plans the function `inverse_dynamics`, which returns the generalized forces that given
/// accelerations require. `None` if the equations do not state them.
pub(super) fn inverse_dynamics(planner: &Planner<'_>) -> Option<Function> {
    let e = planner.equations;
    let n = e.required.len();
    let name = |i: usize| format!("tau{}", function_entry_index(i, n));
    let values: Vec<Value> = e.required.iter().enumerate().map(|(i, value)| (name(i), name(i), *value)).collect();
    let about = format!(
        "Inverse dynamics: the generalized forces along {} that must act beside the loads of the model for the accelerations to be {}.",
        text_of_equation_symbols(planner.arena, &e.variables),
        text_of_equation_symbols(planner.arena, unknown_accelerations(planner))
    );
    let arguments = Arguments::StateAndRates;
    (n > 0).then(|| {
        planner.plan_function_in_steps("inverse_dynamics", &about, arguments, Returns::Vector, &e.definitions, &values)
    })
}

/// Plans the functions that convert between the rates q' and the generalized speeds u, for
/// formulations whose motion variables are q'.
pub(super) fn plan_speed_conversions(planner: &Planner<'_>) -> Vec<Function> {
    let (e, model) = (planner.equations, planner.model);
    let speeds = named_function_values(model.speeds.iter().map(|s| s.name.clone()), &e.generalized_speeds);
    let rates = named_function_values(model.speeds.iter().map(|s| format!("{}'", s.name)), &e.generalized_speed_rates);
    let variables =
        named_function_values(model.coordinates.iter().map(|c| format!("{}'", c.name)), &e.motion_variables);
    let function = |name, about, arguments, values: &[Value]| {
        planner.plan_function_in_steps(name, about, arguments, Returns::Vector, &e.definitions, values)
    };
    vec![
        function("generalized_speeds", "The generalized speeds u, from q and q'.", Arguments::State, &speeds),
        function(
            "generalized_speed_rates",
            "Their time derivatives u', from q, q' and q''.",
            Arguments::StateAndRates,
            &rates,
        ),
        function("motion_variables", "q' from q and the generalized speeds u.", Arguments::Speeds, &variables),
    ]
}

/// Returns values to be computed, named after symbols. For example, the value of `q1'` gets the variable
/// `q1_dot_value`, which differs from an input `q1_dot`.
fn named_function_values(symbols: impl Iterator<Item = String>, values: &[Expr]) -> Vec<Value> {
    symbols
        .zip(values)
        .map(|(symbol, value)| (format!("{}_value", variable_name_without_primes(&symbol)), symbol, *value))
        .collect()
}

/// Returns the number i + 1 as text. It begins with `_` if the number of entries `n` is ten or more.
fn function_entry_index(i: usize, n: usize) -> String {
    if n < 10 { format!("{}", i + 1) } else { format!("_{}", i + 1) }
}

/// Returns the names of symbols as a text in parentheses, such as `(u1, u2)`.
pub(super) fn text_of_equation_symbols(arena: &Arena, symbols: &[Expr]) -> String {
    let names: Vec<&str> = symbols.iter().filter_map(|s| arena.symbol_name(*s)).collect();
    format!("({})", names.join(", "))
}

/// True if part of the motion is prescribed: time is a coordinate, or a constraint demands motion although all speeds
/// are zero.
fn equations_have_given_motion(planner: &Planner<'_>) -> bool {
    let model = planner.model;
    let moving = model.q_dot().into_iter().chain(model.u());
    let mut at_rest = Substitution::new(&moving.map(|symbol| (symbol, Expr::ZERO)).collect::<Vec<_>>());
    let mut arena = planner.arena.clone();
    let mut asks = |equation: Expr| at_rest.apply(&mut arena, equation) != Expr::ZERO;
    model.time().is_some() || model.motion_constraints.iter().any(|constraint| asks(constraint.equation))
}

/// True if the term `e` contains a reaction of the model.
pub(super) fn needs_reaction(planner: &Planner<'_>, e: Expr) -> bool {
    planner.model.reactions.iter().any(|reaction| planner.arena.mentions(e, reaction.symbol))
}

/// Returns definitions of the terms of the equations, then of the rates q̇ or the speeds u. Of these two, it defines
/// the one that is not integrated.
pub(super) fn definitions_in_state(planner: &Planner<'_>) -> Vec<Definition> {
    let e = planner.equations;
    e.definitions.iter().copied().chain(definitions_of_other_variables(planner.model, e)).collect()
}

/// Returns definitions of the rates q̇ in terms of the speeds u. For equations whose motion variables are q̇, defines
/// u in terms of q̇ instead.
pub(super) fn definitions_of_other_variables(model: &Model, e: &Equations) -> Vec<Definition> {
    let (symbols, values) = if e.formulation.is_in_rates() {
        (model.u(), &e.generalized_speeds)
    } else {
        (model.q_dot(), &e.coordinate_rates)
    };
    symbols.into_iter().zip(values).map(|(symbol, value)| Definition { symbol, value: *value }).collect()
}
