//! What is watched in runs of a scene: the domain's conditions and the scene's events, compiled once and bound to a
//! problem.

use crate::code::{Code, Ready, code, tape};
use crate::error::Error;
use crate::mechanism::Mechanism;
use crate::problem::Problem;
use tripos_derive::algebra::Expr;
use tripos_derive::algebra::evaluate::Tape;
use tripos_derive::mechanics::By;
use tripos_derive::scene::Scene;
use tripos_derive::{Formulation, Model};
use tripos_sim::{Direction, Dynamics, Effect, Event};
use tripos_traits::Lengths;

/// What is watched in the runs of a scene, compiled once: expressions, and the force balance that gives reactions,
/// whichever formulation runs, if one of them mentions a reaction.
#[derive(Clone)]
pub struct Balance {
    code: Option<Code>,
    /// The domain's conditions, then the scene's events.
    watched: Vec<Watched>,
}

/// An expression in parameters, q, q̇, u and reactions.
#[derive(Clone)]
struct Watched {
    tape: Tape,
    needs_reactions: bool,
}

impl Balance {
    /// For what is watched in a scene of this model: the mechanism's own, or a reduced one, which has no reactions
    /// any more.
    ///
    /// # Errors
    /// [`Error::Request`] if a reaction is watched that cannot be had, or what has no value during a run.
    pub fn new(mechanism: &Mechanism, model: &Model, scene: &Scene, by: &By) -> Result<Self, Error> {
        let domain = model.domain.iter().map(|c| (c.name.as_str(), c.positive));
        let watched = domain.chain(scene.events.iter().map(|e| (e.name.as_str(), e.function)));
        let (mut balance, mut list) = (None, Vec::new());
        for (name, e) in watched {
            let reaction = model.reactions.iter().find(|r| model.arena.mentions(e, r.symbol));
            if let (Some(reaction), None) = (reaction, &balance) {
                balance = Some(code(mechanism, &Formulation::NewtonEuler.into(), None, Ready::AsDerived).map_err(|error| {
                    Error::request(
                        format!(
                            "`{name}` needs the reaction `{}`, which only newton-euler gives, also in a run by {}:\n{error}",
                            reaction.name, by.name()
                        ),
                        "name the missing reactions, or state the condition without a reaction".to_owned(),
                    )
                })?);
            }
            let reactions: Vec<Expr> = model.reactions.iter().map(|r| r.symbol).collect();
            let inputs = [model.p(), model.q(), model.q_dot(), model.u(), reactions].concat();
            let tape = tape(&model.arena, &inputs, &[e], &format!("`{name}`"))?;
            list.push(Watched { tape, needs_reactions: reaction.is_some() });
        }
        Ok(Self { code: balance, watched: list })
    }
}

/// The domain's conditions and the scene's events as functions of the integrated state; the scene must have those that
/// `balance` was made for.
#[must_use]
pub fn events<'a>(problem: &'a Problem<'_>, balance: &'a Balance) -> Vec<Event<'a>> {
    let Problem { model, scene, .. } = *problem;
    let mut watched = balance.watched.iter();
    let mut events = Vec::new();
    for (condition, watched) in model.domain.iter().zip(&mut watched) {
        let function = watch(problem, balance, watched);
        let name = format!("{} ({})", condition.name, condition.text);
        if scene.integration.domain_stops {
            events.push(Event::domain(name, function));
        } else {
            events.push(Event::recorded(name, Direction::Falling, function));
        }
    }
    for (event, watched) in scene.events.iter().zip(watched) {
        let function = watch(problem, balance, watched);
        let effect = if event.terminal { Effect::Terminal } else { Effect::Record };
        let name = event.name.clone();
        events.push(Event { name, function: Box::new(function), direction: event.direction, effect });
    }
    events
}

/// A watched expression as a function of (t, y).
fn watch<'a>(
    problem: &'a Problem<'_>,
    balance: &'a Balance,
    watched: &'a Watched,
) -> impl FnMut(f64, &[f64]) -> f64 + 'a {
    let system = problem.system();
    let p = problem.scene.parameters.clone();
    let Lengths { coordinates, speeds, .. } = system.lengths();
    let reactions = problem.model.reactions.len();
    let mut dynamics = match &balance.code {
        Some(code) if watched.needs_reactions => Dynamics::new(code.system(), &p).ok(),
        _ => None,
    };
    let (mut q_dot, mut u, mut scratch) = (vec![0.0; coordinates], vec![0.0; speeds], Vec::new());
    move |_t: f64, y: &[f64]| {
        let (variables, v) = y.split_at(coordinates);
        system.coordinate_rates(&p, variables, v, &mut q_dot);
        system.generalized_speeds(&p, variables, v, &mut u);
        let q = problem.coordinates(y);
        let mut values = [p.as_slice(), &q, &q_dot, &u].concat();
        match &mut dynamics {
            // The state has no reaction where the balance is singular: not a number, said by the integrator.
            Some(balance) => match balance.unknowns(&q, &u) {
                Ok(x) => values.extend_from_slice(&x[speeds..]),
                Err(_) => return f64::NAN,
            },
            None => values.resize(values.len() + reactions, f64::NAN),
        }
        let mut out = [0.0];
        watched.tape.evaluate_into(&values, &mut scratch, &mut out);
        out[0]
    }
}
