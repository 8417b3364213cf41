//! Command `tripos evaluate`: prints matrix, forcing, accelerations, reactions and energies of the equations of motion
//! at one state.

use crate::files::workspace::{read_model, short_name};
use crate::terminal::failure::{Failure, Output, print, print_json, warn};
use serde_json::{Map, Value, json};
use std::fmt::Write;
use std::path::Path;
use tripos::code::{CodePreparation, compile_tape, derive_or_read_equations, interpreted_code};
use tripos::equations_name::find_equations as equations;
use tripos::{EquationsName, Error, Mechanism, near_divisors};
use tripos_derive::algebra::Expr;
use tripos_derive::diagnostic::Source;
use tripos_derive::mechanics::{Derivation, EquationsOrigin, Kinematics, rates_to_speeds};
use tripos_derive::model::Reaction;
use tripos_derive::plain_text::with_significant_digits;
use tripos_derive::scene::{State, load_state};
use tripos_sim::Dynamics;
use tripos_sim::linear::solve_extended;
use tripos_traits::{DoubleDouble, System};

/// Equations of motion of a formulation, evaluated at one state. All values are in SI units.
struct EvaluatedEquations {
    /// Names of the unknowns of the linear system.
    unknowns: Vec<String>,
    /// Mass matrix, row by row: a row and a column for each unknown.
    mass_matrix: Vec<Vec<f64>>,
    /// Right-hand side of the linear system, one entry per row.
    forcing: Vec<f64>,
    /// Time derivatives of the generalized speeds, with their names.
    accelerations: Vec<(String, f64)>,
    /// Reactions with their names; empty if the formulation has none.
    reactions: Vec<(String, f64)>,
    /// Multipliers of constraints with their names. Empty if the formulation has reactions instead, or if there are no
    /// constraints.
    multipliers: Vec<(String, f64)>,
    /// Kinetic energy T, J.
    kinetic_energy: f64,
    /// Potential energy V, J.
    potential_energy: f64,
    /// Part of the potential energy V that is due to gravity, J.
    gravity_potential: f64,
    /// Rate d(T + V)/dt of the energy, W: the power of the loads without a potential.
    power: f64,
}

/// Runs `tripos evaluate`: evaluates a formulation at the state of a file, and prints the values.
/// Returns the exit status.
///
/// # Errors
/// `Failure` if a file has errors, or if the accelerations are not determined at the state.
pub fn evaluate(model: &Path, by: &EquationsName, at: &Path, output: Output) -> Result<u8, Failure> {
    let mut model = read_model(model)?;
    let by = equations(&model, by)?;
    let state = load_state(&Source::read(at)?, &mut model)?;
    let derivation = derive_or_read_equations(&model, &by)?;
    state.hints(&model).iter().for_each(|hint| warn(hint));
    let values = evaluate_equations(&model, &by, &derivation, &state)?;
    if output == Output::Json {
        let object = |list: &[(String, f64)]| {
            list.iter().map(|(name, value)| (name.clone(), json!(value))).collect::<Map<String, Value>>()
        };
        let value = json!({
            "model": short_name(&model),
            "formulation": by.name(),
            "unknowns": values.unknowns,
            "mass_matrix": values.mass_matrix,
            "forcing": values.forcing,
            "accelerations": object(&values.accelerations),
            "reactions": object(&values.reactions),
            "multipliers": object(&values.multipliers),
            "kinetic_energy": values.kinetic_energy,
            "potential_energy": values.potential_energy,
            "gravity_potential": values.gravity_potential,
            "power": values.power,
        });
        print_json(&value)?;
    } else {
        print(&as_text(&model, &by.title(), &values))?;
    }
    Ok(0)
}

/// Evaluates the equations of a formulation at a state.
///
/// # Errors
/// `Failure` if the matrix is singular to rounding, or if an acceleration or energy is not
/// finite.
fn evaluate_equations(
    model: &Mechanism,
    by: &EquationsOrigin,
    derivation: &Derivation,
    state: &State,
) -> Result<EvaluatedEquations, Failure> {
    let code = interpreted_code(model, by, derivation, CodePreparation::AsDerived)?;
    let system = code.system();
    let State { parameters: p, q, u } = state;
    let mut v = vec![0.0; system.lengths().variables];
    system.motion_variables(p, q, u, &mut v);
    let n = system.lengths().unknowns();
    let stopped = |why: String| Failure::from(Error::Stopped(format!("no accelerations at this state: {why}")));
    let mut dynamics = Dynamics::new(system, p).map_err(|error| stopped(error.to_string()))?;
    // If constraints leave no speed, there is no equation of motion.
    let rcond = if n == 0 {
        1.0
    } else {
        dynamics.unknowns(q, &v).map_err(|failure| stopped(failure.message))?;
        dynamics.reciprocal_condition(q, &v)
    };
    if rcond.is_nan() || rcond < f64::EPSILON {
        let what = "the matrix is singular to rounding";
        return Err(stopped(format!(
            "{what}: equilibrated rcond {}{}",
            with_significant_digits(rcond, 2),
            near_divisors(model, &state.parameters, &state.q)?
        )));
    }
    if rcond < LARGEST_LOSSY_RCOND {
        let lost = (-rcond.log10()).floor();
        warn(&format!(
            "equilibrated rcond is {}: a state with 16 digits determines the accelerations to about {lost} digits fewer",
            with_significant_digits(rcond, 2)
        ));
    }
    let near = near_divisors(model, p, q)?;
    if !near.is_empty() {
        warn(&format!("the speeds hardly determine the motion at this state, so that digits are lost{near}"));
    }
    // In 32 digits, so that terms that cancel cost none of the 16 digits that are shown.
    let ExtendedValues { matrix, forcing, unknowns: x, speed_rates: u_dot, energies } =
        extended_values(code.extended(), state).ok_or_else(|| stopped("the matrix is singular".to_owned()))?;
    let (v_dot, others) = x.split_at(system.lengths().variables);
    if let Some(at) = u_dot.iter().position(|a| !a.is_finite()) {
        return Err(stopped(format!("{}' is not finite", model.speeds[at].name)));
    }
    let gravity = gravity_potential(model, state)?;
    if energies.iter().chain([&gravity]).any(|e| !e.is_finite()) {
        return Err(stopped("an energy or its rate is not a finite number".to_owned()));
    }
    let carries_reactions = derivation.equations.formulation.has_reactions();
    warn_outside_domain(model, state, if carries_reactions { others } else { &[] })?;
    let unknowns = &derivation.equations.unknowns;
    let unknowns: Vec<String> =
        unknowns.iter().filter_map(|e| derivation.arena.symbol_name(*e)).map(str::to_owned).collect();
    let others: Vec<(String, f64)> = unknowns[v_dot.len()..].iter().cloned().zip(others.iter().copied()).collect();
    let (reactions, multipliers) = if carries_reactions { (others, Vec::new()) } else { (Vec::new(), others) };
    Ok(EvaluatedEquations {
        unknowns,
        multipliers,
        mass_matrix: matrix.chunks(n.max(1)).map(<[f64]>::to_vec).collect(),
        forcing,
        accelerations: model.speeds.iter().zip(&u_dot).map(|(s, a)| (format!("{}'", s.name), *a)).collect(),
        reactions,
        kinetic_energy: energies[0],
        potential_energy: energies[1],
        gravity_potential: gravity,
        power: energies[2],
    })
}

/// Values of equations of motion at a state, computed in 32 digits and rounded to doubles, in SI units.
struct ExtendedValues {
    /// Entries of the matrix A, row by row.
    matrix: Vec<f64>,
    /// Right-hand side b.
    forcing: Vec<f64>,
    /// Solution x of A x = b: the rates of the motion variables, then reactions or multipliers.
    unknowns: Vec<f64>,
    /// Rates of the generalized speeds.
    speed_rates: Vec<f64>,
    /// Kinetic energy and potential energy, J, and power of the loads, W.
    energies: [f64; 3],
}

/// Evaluates equations of motion at a state; `None` if their matrix is exactly singular or not finite.
fn extended_values(system: &dyn System<DoubleDouble>, state: &State) -> Option<ExtendedValues> {
    let wide = |list: &[f64]| list.iter().map(|x| DoubleDouble::from(*x)).collect::<Vec<_>>();
    let rounded = |list: &[DoubleDouble]| list.iter().map(|x| x.hi()).collect::<Vec<f64>>();
    let zeros = |count: usize| vec![DoubleDouble::from(0.0); count];
    let (p, q, u) = (wide(&state.parameters), wide(&state.q), wide(&state.u));
    let (lengths, n) = (system.lengths(), system.lengths().unknowns());
    let mut v = zeros(lengths.variables);
    system.motion_variables(&p, &q, &u, &mut v);
    let (mut matrix, mut forcing) = (zeros(n * n), zeros(n));
    system.mass_matrix(&p, &q, &v, &mut matrix);
    system.forcing(&p, &q, &v, &mut forcing);
    let mut unknowns = forcing.clone();
    if !solve_extended(&matrix, &mut unknowns) {
        return None;
    }
    let mut speed_rates = zeros(lengths.speeds);
    system.generalized_speed_rates(&p, &q, &v, &unknowns[..lengths.variables], &mut speed_rates);
    let energies = [system.kinetic_energy(&p, &q, &v), system.potential_energy(&p, &q), system.power(&p, &q, &v)];
    Some(ExtendedValues {
        matrix: rounded(&matrix),
        forcing: rounded(&forcing),
        unknowns: rounded(&unknowns),
        speed_rates: rounded(&speed_rates),
        energies: energies.map(DoubleDouble::hi),
    })
}

/// Returns the potential energy of gravity alone at a state, J.
/// `Err` if the kinematics cannot be derived.
fn gravity_potential(model: &Mechanism, state: &State) -> Result<f64, Failure> {
    let mut kinematics = Kinematics::new(model).map_err(|error| model.diagnose(&error))?;
    let gravity = kinematics.gravity_potential(model).map_err(|error| model.diagnose(&error))?;
    let tape =
        compile_tape(&kinematics.arena, &[model.p(), model.q()].concat(), &[gravity], "the potential of gravity")?;
    Ok(tape.evaluate(&[state.parameters.as_slice(), &state.q].concat())[0])
}

/// Reciprocal condition number below which a warning says that more than half of the digits are lost.
const LARGEST_LOSSY_RCOND: f64 = 1e-8;

/// Warns about conditions of the model's domain that do not hold at a state. Conditions on reactions are checked only
/// if `reactions` are given. `Err` if a condition contains an unknown symbol.
fn warn_outside_domain(model: &Mechanism, state: &State, reactions: &[f64]) -> Result<(), Failure> {
    let known: Vec<Expr> = model.reactions.iter().take(reactions.len()).map(|r| r.symbol).collect();
    let inputs = [model.p(), model.q(), model.u(), known].concat();
    let values = [state.parameters.as_slice(), &state.q, &state.u, reactions].concat();
    for condition in &model.domain {
        let mut in_speeds = rates_to_speeds(model);
        let mut arena = model.arena.clone();
        let positive = in_speeds.apply(&mut arena, condition.positive);
        let unknown = |r: &Reaction| !inputs.contains(&r.symbol) && arena.mentions(positive, r.symbol);
        if model.reactions.iter().any(unknown) {
            continue;
        }
        let tape = compile_tape(&arena, &inputs, &[positive], &format!("`{}`", condition.name))?;
        if tape.evaluate(&values)[0] <= 0.0 {
            warn(&format!(
                "this state is outside the model's domain: `{}` ({}) does not hold",
                condition.name, condition.text
            ));
        }
    }
    Ok(())
}

/// Returns the evaluated equations of motion as text.
fn as_text(model: &Mechanism, title: &str, values: &EvaluatedEquations) -> String {
    let mut out = format!("{}: {title}, by interpretation\n\n", model.title);
    let row = |numbers: &[f64]| numbers.iter().map(|x| format!("{x:>15.8e}")).collect::<Vec<_>>().join(" ");
    let _ = writeln!(out, "unknowns: {}\nmatrix | right-hand side", values.unknowns.join(", "));
    for (numbers, right) in values.mass_matrix.iter().zip(&values.forcing) {
        let _ = writeln!(out, "  {} | {right:>15.8e}", row(numbers));
    }
    let lists = [
        ("accelerations", &values.accelerations),
        ("reactions", &values.reactions),
        ("multipliers of the constraints", &values.multipliers),
    ];
    for (heading, list) in lists {
        if !list.is_empty() {
            let _ = writeln!(out, "\n{heading}");
        }
        for (name, value) in list {
            let _ = writeln!(out, "  {name} = {value}");
        }
    }
    let _ = writeln!(out, "\nT = {} J\nV = {} J", values.kinetic_energy, values.potential_energy);
    if values.potential_energy.total_cmp(&values.gravity_potential).is_ne() {
        let _ = writeln!(out, "  {} J of it by gravity", values.gravity_potential);
    }
    if values.power != 0.0 {
        let _ = writeln!(out, "d(T + V)/dt = {} W", values.power);
    }
    out
}
