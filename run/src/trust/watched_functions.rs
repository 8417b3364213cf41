//! Functions that a run of a scene watches: conditions of the model's domain, and events of the scene.
//!
//! The functions are compiled once for a scene. They are then bound to each problem.

use crate::code::{Code, CodePreparation, compile_tape, runnable_code};
use crate::error::Error;
use crate::mechanism::Mechanism;
use crate::preparation::problem::Problem;
use tripos_derive::algebra::Expr;
use tripos_derive::algebra::term::steps::{Definition, fresh_symbol, needed_steps};
use tripos_derive::algebra::value::tape::{Numeric, Tape, UnknownSymbol};
use tripos_derive::mechanics::EquationsOrigin;
use tripos_derive::scene::Scene;
use tripos_derive::{Formulation, Model};
use tripos_sim::{Direction, Dynamics, Effect, Event, EventFunction, InRanges};
use tripos_traits::{Enclosure, Lengths, Scalar};

/// Compiled functions that the runs of a scene watch. If a function contains a reaction, the
/// Newton–Euler equations give this reaction in a run by any formulation.
#[derive(Clone)]
pub struct WatchedFunctions {
    /// Newton–Euler equations, which give the reactions; `None` if no watched function needs a reaction.
    code: Option<Code>,
    /// Conditions of the model's domain, followed by the events of the scene.
    watched: Vec<WatchedFunction>,
}

/// Watched function in its compiled form.
#[derive(Clone)]
enum WatchedFunction {
    /// Function of the parameters and the integrated state, compiled for numbers and for intervals.
    OfState { tape: Tape, ranges: Tape<Enclosure> },
    /// Function of the parameters, q, q̇, u and reactions. The equations of the run give q, q̇ and u. The
    /// Newton–Euler equations give the reactions.
    OfMotion { tape: Tape, needs_reactions: bool },
}

impl WatchedFunctions {
    /// Compiles the watched functions of a scene. `model` is the mechanism's own model, or a reduced
    /// model without reactions.
    ///
    /// # Errors
    /// [`Error::Request`] if a watched reaction is not determined, or if a symbol has no value during a
    /// run. Also if a watched function contains a reaction and the scene has impacts.
    pub fn new(mechanism: &Mechanism, model: &Model, scene: &Scene, by: &EquationsOrigin) -> Result<Self, Error> {
        let domain = model.domain.iter().map(|c| (c.name.as_str(), c.positive));
        let watched = domain.chain(scene.events.iter().map(|e| (e.name.as_str(), e.function)));
        let (mut balance, mut list) = (None, Vec::new());
        for (name, e) in watched {
            let reaction = model.reactions.iter().find(|r| model.arena.mentions(e, r.symbol));
            if let (Some(reaction), false) = (reaction, scene.impacts.is_empty()) {
                let what = format!(
                    "`{name}` needs the reaction `{}`, which does not contain the force of closed contacts",
                    reaction.name
                );
                return Err(Error::request(what, "leave the condition out, or the impacts out of the scene"));
            }
            if let (Some(reaction), None) = (reaction, &balance) {
                balance = Some(runnable_code(mechanism, &Formulation::NewtonEuler.into(), None, CodePreparation::AsDerived).map_err(|error| {
                    Error::request(
                        format!(
                            "`{name}` needs the reaction `{}`, which only newton-euler gives, also in a run by {}:\n{error}",
                            reaction.name, by.name()
                        ),
                        "name the missing reactions, or state the condition without a reaction".to_owned(),
                    )
                })?);
            }
            list.push(match compile_function_of_state(model, scene, by, e) {
                Ok(tape) => WatchedFunction::OfState { ranges: tape.to(), tape },
                // If a symbol is unknown here too, the error of this call names it.
                Err(UnknownSymbol(_)) => compile_function_of_motion(model, e, name)?,
            });
        }
        Ok(Self { code: balance, watched: list })
    }

    /// True if a watched function contains a reaction, which the Newton–Euler equations give by a numeric solve.
    #[must_use]
    pub fn needs_reactions(&self) -> bool {
        self.code.is_some()
    }
}

/// Compiles an expression as a function of the parameters and the integrated state.
///
/// The error names a symbol that such a function cannot contain: a reaction, or a rate in a run by
/// printed equations, which define their own rates.
fn compile_function_of_state(
    model: &Model,
    scene: &Scene,
    by: &EquationsOrigin,
    e: Expr,
) -> Result<Tape, UnknownSymbol> {
    let mut arena = model.arena.clone();
    let (mut variables, mut steps) = (model.q(), Vec::new());
    if let Some(distance) = scene.integration.distance {
        let coordinate = variables[distance.coordinate];
        let symbol = fresh_symbol(&mut arena, "distance");
        let (quarter, pi) = (arena.ratio(i64::from(distance.quarter_turns), 2), arena.pi());
        let origin = arena.mul(quarter, pi);
        steps.push(Definition { symbol: coordinate, value: arena.add(symbol, origin) });
        variables[distance.coordinate] = symbol;
    }
    let formulation = match by {
        EquationsOrigin::Derived(formulation) | EquationsOrigin::Printed { formulation, .. } => Some(*formulation),
        EquationsOrigin::Reduced => None,
    };
    let (v, other, values) = if formulation.is_some_and(Formulation::is_in_rates) {
        (model.q_dot(), model.u(), model.speeds.iter().map(|s| s.definition).collect())
    } else {
        (model.u(), model.q_dot(), model.kinematic_equations.rates.clone())
    };
    if by.printed_id().is_none() {
        steps.extend(other.into_iter().zip(values).map(|(symbol, value)| Definition { symbol, value }));
    }
    let steps = needed_steps(&arena, &steps, &[e]);
    Tape::stepwise(&arena, &[model.p(), variables, v].concat(), &steps, &[e])
}

/// Compiles an expression as a function of the parameters, q, q̇, u and reactions. `name` is the name of
/// the expression in errors.
fn compile_function_of_motion(model: &Model, e: Expr, name: &str) -> Result<WatchedFunction, Error> {
    let reactions: Vec<Expr> = model.reactions.iter().map(|r| r.symbol).collect();
    let needs_reactions = reactions.iter().any(|r| model.arena.mentions(e, *r));
    let inputs = [model.p(), model.q(), model.q_dot(), model.u(), reactions].concat();
    Ok(WatchedFunction::OfMotion {
        tape: compile_tape(&model.arena, &inputs, &[e], &format!("`{name}`"))?,
        needs_reactions,
    })
}

/// Binds the watched functions to a problem, and returns them as events of the integrated state. A
/// function without reactions is also given for intervals. `balance` must have been compiled for the
/// conditions and events of the problem's scene.
#[must_use]
pub fn watched_events<'a>(problem: &'a Problem<'_>, balance: &'a WatchedFunctions) -> Vec<Event<'a>> {
    let Problem { model, scene, .. } = *problem;
    let conditions = model.domain.iter().map(|condition| {
        let effect = if scene.integration.domain_stops { Effect::Domain } else { Effect::Record };
        (format!("{} ({})", condition.name, condition.text), Direction::Falling, effect)
    });
    let events = scene.events.iter().map(|event| {
        let effect = if event.terminal { Effect::Terminal } else { Effect::Record };
        (event.name.clone(), event.direction, effect)
    });
    let watched = conditions.chain(events).zip(&balance.watched);
    let event = |((name, direction, effect), watched): ((String, Direction, Effect), &'a WatchedFunction)| {
        let (function, ranges) = bind_watched_function(problem, balance, watched);
        Event { name, function, ranges, direction, effect }
    };
    watched.map(event).collect()
}

/// Binds one watched function to a problem. Returns it as a function of (t, y), and the same function
/// for intervals; `None` if it contains reactions or unknown rates.
fn bind_watched_function<'a>(
    problem: &'a Problem<'_>,
    balance: &'a WatchedFunctions,
    watched: &'a WatchedFunction,
) -> (EventFunction<'a>, Option<InRanges<'a>>) {
    match watched {
        WatchedFunction::OfState { tape, ranges } => {
            let p = problem.scene.parameters.as_slice();
            let mut value = watched_function_of_inputs(tape, p.to_vec());
            let mut range = watched_function_of_inputs(ranges, p.iter().map(|p| Enclosure::from_f64(*p)).collect());
            let components = tape.used_inputs().into_iter().filter_map(|at| at.checked_sub(p.len())).collect();
            let ranges = InRanges { function: Box::new(move |_t, y| range(y)), components: Some(components) };
            (Box::new(move |_t, y| value(y)), Some(ranges))
        }
        WatchedFunction::OfMotion { tape, needs_reactions } => {
            let code = balance.code.as_ref().filter(|_| *needs_reactions);
            (Box::new(function_along_motion(problem, code, tape)), None)
        }
    }
}

/// Makes a function of the last inputs of a tape. `inputs` are the values of the first inputs.
fn watched_function_of_inputs<S: Numeric>(tape: &Tape<S>, mut inputs: Vec<S>) -> impl FnMut(&[S]) -> S + '_ {
    let (given, mut scratch) = (inputs.len(), Vec::new());
    move |rest: &[S]| {
        inputs.truncate(given);
        inputs.extend_from_slice(rest);
        let mut out = [S::int(0)];
        tape.evaluate_into(&inputs, &mut scratch, &mut out);
        out[0]
    }
}

/// Makes a function of (t, y) from a tape whose inputs are the parameters, q, q̇, u and reactions.
/// `code` has the Newton–Euler equations, which give the reactions. Without it, reactions are NaN.
fn function_along_motion<'a>(
    problem: &'a Problem<'_>,
    code: Option<&'a Code>,
    tape: &'a Tape,
) -> impl FnMut(f64, &[f64]) -> f64 + 'a {
    let system = problem.system();
    let p = problem.scene.parameters.clone();
    let Lengths { coordinates, speeds, .. } = system.lengths();
    let reactions = problem.model.reactions.len();
    let mut dynamics = code.and_then(|code| Dynamics::new(code.system(), &p).ok());
    let (mut q_dot, mut u, mut scratch) = (vec![0.0; coordinates], vec![0.0; speeds], Vec::new());
    move |_t: f64, y: &[f64]| {
        let (variables, v) = y.split_at(coordinates);
        system.coordinate_rates(&p, variables, v, &mut q_dot);
        system.generalized_speeds(&p, variables, v, &mut u);
        let q = problem.coordinates(y);
        let mut values = [p.as_slice(), &q, &q_dot, &u].concat();
        match &mut dynamics {
            // Where the Newton–Euler equations are singular, the reactions are not determined. The value
            // is then NaN, which the integrator reports.
            Some(balance) => match balance.unknowns(&q, &u) {
                Ok(x) => values.extend_from_slice(&x[speeds..]),
                Err(_) => return f64::NAN,
            },
            None => values.resize(values.len() + reactions, f64::NAN),
        }
        let mut out = [0.0];
        tape.evaluate_into(&values, &mut scratch, &mut out);
        out[0]
    }
}
