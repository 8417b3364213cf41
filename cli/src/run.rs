//! One run of a scene by one formulation.

use crate::catalogue::{By, Code, code};
use crate::failure::Failure;
use tripos_derive::algebra::Expr;
use tripos_derive::algebra::evaluate::Tape;
use tripos_derive::scene::{Crossing, Scene};
use tripos_derive::{Formulation, Model};
use tripos_sim::{AbsoluteTolerance, Direction, Dynamics, Effect, Event, Method, Options, Output, Solution, integrate};
use tripos_traits::System;

/// What came out of a run.
pub struct Run {
    /// Which equations ran.
    pub by: By,
    /// Whether compiled code ran.
    pub code: &'static str,
    /// The integrator's result.
    pub solution: Solution,
    /// Coordinates, then generalized speeds, at each sample.
    pub states: Vec<Vec<f64>>,
    /// Kinetic and potential energy at each sample.
    pub energies: Vec<(f64, f64)>,
    /// Coordinates, then generalized speeds, at the end.
    pub end: Vec<f64>,
    /// Largest change of total energy over the samples, J.
    pub energy_drift: f64,
    /// What a reader must know before trusting the numbers.
    pub warnings: Vec<String>,
}

/// How many times what the tolerances allow a conserved energy may change before a run warns.
const ALLOWED_DRIFT: f64 = 100.0;

impl Run {
    /// Why the run must not be trusted to the end that was asked for, a reason a line; nothing if it can be.
    pub fn objections(&self) -> Vec<String> {
        let stop = self.solution.stop.is_failure().then(|| self.solution.to_string());
        stop.into_iter().chain(self.warnings.iter().cloned()).collect()
    }
}

/// The names of the states: coordinates, then generalized speeds.
pub fn state_names(model: &Model) -> Vec<String> {
    let coordinates = model.coordinates.iter().map(|c| c.name.clone());
    coordinates.chain(model.speeds.iter().map(|s| s.name.clone())).collect()
}

/// Runs a scene by one set of equations.
///
/// # Errors
/// [`Failure`] if the formulation is not to be had, or the scene asks for what it cannot give.
pub fn run(model: &Model, scene: &Scene, by: &By) -> Result<Run, Failure> {
    run_code(model, scene, by, &code(model, by)?)
}

/// Runs a scene by one set of equations that is ready.
///
/// # Errors
/// As [`run`].
pub fn run_code(model: &Model, scene: &Scene, by: &By, code: &Code) -> Result<Run, Failure> {
    let balance = Balance::new(model, scene, by)?;
    let system = code.system();
    let request = |error: tripos_sim::SimError| {
        Failure::Request(error.to_string(), format!("check {}", scene.source.path.display()))
    };
    let label = format!("{}, {}", model.title, by.name);
    let mut dynamics = Dynamics::new(system, &scene.parameters).map_err(request)?.labelled(label);
    let mut v = vec![0.0; system.speeds()];
    system.motion_variables(&scene.parameters, &scene.q, &scene.u, &mut v);
    if let Some(at) = v.iter().position(|x| !x.is_finite()) {
        return Err(Failure::Stopped(format!(
            "the run cannot start: motion variable {} of {} is {} there, since the generalized speeds do not determine q'",
            at + 1,
            by.name,
            v[at]
        )));
    }
    let y0 = dynamics.state(&scene.q, &v).map_err(request)?;
    let mut events = events(model, scene, system, &balance)?;
    let options = Options {
        method: method(&scene.method)?,
        rtol: scene.rtol,
        atol: AbsoluteTolerance::Uniform(scene.atol),
        step_limit: scene.step_limit,
        output: output(scene),
        ..Options::default()
    };
    let rhs = |t: f64, y: &[f64], dydt: &mut [f64]| dynamics.rhs(t, y, dydt);
    let solution = integrate(rhs, scene.span, &y0, &options, &mut events).map_err(request)?;
    drop(events);
    Ok(finish(model, scene, code, &dynamics, by.clone(), solution))
}

/// The method of this name.
pub fn method(name: &str) -> Result<Method, Failure> {
    Method::ALL.iter().copied().find(|m| m.name() == name).ok_or_else(|| {
        let names = Method::ALL.iter().map(|m| m.name());
        Failure::Request(format!("there is no method `{name}`"), tripos_derive::diagnostic::nearest(name, names))
    })
}

fn output(scene: &Scene) -> Output {
    match scene.samples {
        None => Output::Steps { refine: 4 },
        Some(n) => {
            let (from, to) = scene.span;
            let last = (n - 1).max(1) as f64;
            // The last instant is exact, whatever the division rounds to.
            Output::At((0..n).map(|i| if i + 1 == n { to } else { from + (to - from) * i as f64 / last }).collect())
        }
    }
}

fn finish(model: &Model, scene: &Scene, code: &Code, dynamics: &Dynamics<'_>, by: By, solution: Solution) -> Run {
    let (system, p) = (code.system(), dynamics.parameters());
    let state = |y: &[f64]| {
        let (q, v) = dynamics.split(y);
        let mut u = vec![0.0; v.len()];
        system.generalized_speeds(p, q, v, &mut u);
        [q, &u].concat()
    };
    let energy = |y: &[f64]| {
        let (q, v) = dynamics.split(y);
        (system.kinetic_energy(p, q, v), system.potential_energy(p, q))
    };
    let energies: Vec<(f64, f64)> = solution.y.iter().map(|y| energy(y)).collect();
    let energy_drift = dynamics.energy_drift(&solution);
    let mut warnings: Vec<String> = solution.warnings.iter().map(ToString::to_string).collect();
    warnings.extend(drift_warning(model, scene, &energies, energy_drift));
    Run {
        by,
        code: code.name(),
        states: solution.y.iter().map(|y| state(y)).collect(),
        energies,
        end: state(&solution.y_end),
        energy_drift,
        warnings,
        solution,
    }
}

/// Where nothing but gravity works, total energy is constant: says so if it was not.
fn drift_warning(model: &Model, scene: &Scene, energies: &[(f64, f64)], drift: f64) -> Option<String> {
    if !(model.forces.is_empty() && model.torques.is_empty()) {
        return None;
    }
    // What kinetic energy can honestly reach: a run that blows up must not raise its own allowance.
    let start = energies.first().map_or(0.0, |(kinetic, potential)| (kinetic + potential).abs());
    let scale = energies.iter().fold(start, |m, (_, potential)| m.max(start + potential.abs()));
    let allowed = scene.atol + scene.rtol * scale;
    // A run that ended where energy has no value says so by its stop.
    (drift > ALLOWED_DRIFT * allowed).then(|| {
        format!(
            "total energy, constant in this motion, changed by {drift:.3e} J, {:.0} times what the tolerances allow: do not trust this run",
            drift / allowed
        )
    })
}

/// The force balance that gives reactions, whichever formulation runs: needed only if a watched
/// expression mentions one.
struct Balance {
    code: Option<Code>,
}

impl Balance {
    fn new(model: &Model, scene: &Scene, by: &By) -> Result<Self, Failure> {
        let domain = model.domain.iter().map(|c| (c.name.as_str(), c.positive));
        let watched = domain.chain(scene.events.iter().map(|e| (e.name.as_str(), e.function)));
        for (name, e) in watched {
            let Some(reaction) = model.reactions.iter().find(|r| model.arena.mentions(e, r.symbol)) else { continue };
            return match code(model, &Formulation::NewtonEuler.into()) {
                Ok(code) => Ok(Self { code: Some(code) }),
                Err(error) => Err(Failure::Request(
                    format!(
                        "`{name}` needs the reaction `{}`, which only newton-euler gives, also in a run by {}:\n{error}",
                        reaction.name, by.name
                    ),
                    "name the missing reactions, or state the condition without a reaction".to_owned(),
                )),
            };
        }
        Ok(Self { code: None })
    }
}

/// The domain's conditions and the scene's events as functions of the integrated state.
fn events<'a>(
    model: &Model,
    scene: &Scene,
    system: &'a dyn System<f64>,
    balance: &'a Balance,
) -> Result<Vec<Event<'a>>, Failure> {
    let mut events = Vec::new();
    for condition in &model.domain {
        let function = watch(model, scene, system, balance, condition.positive)?;
        let name = format!("{} ({})", condition.name, condition.text);
        if scene.domain_stops {
            events.push(Event::domain(name, function));
        } else {
            events.push(Event::recorded(name, Direction::Falling, function));
        }
    }
    for event in &scene.events {
        let function = watch(model, scene, system, balance, event.function)?;
        let direction = match event.crossing {
            Crossing::Rising => Direction::Rising,
            Crossing::Falling => Direction::Falling,
            Crossing::Either => Direction::Either,
        };
        let effect = if event.terminal { Effect::Terminal } else { Effect::Record };
        events.push(Event { name: event.name.clone(), function: Box::new(function), direction, effect });
    }
    Ok(events)
}

/// An expression in parameters, q, q̇, u and reactions as a function of (t, y).
fn watch<'a>(
    model: &Model,
    scene: &Scene,
    system: &'a dyn System<f64>,
    balance: &'a Balance,
    e: Expr,
) -> Result<impl FnMut(f64, &[f64]) -> f64 + 'a, Failure> {
    let reactions: Vec<Expr> = model.reactions.iter().map(|r| r.symbol).collect();
    let inputs = [model.p(), model.q(), model.q_dot(), model.u(), reactions.clone()].concat();
    let tape = Tape::new(&model.arena, &inputs, &[e]).map_err(|unknown| {
        let what = format!("a watched expression mentions `{}`, which has no value during a run", unknown.0);
        Failure::Request(what, "use parameters, coordinates, q', speeds and reactions".to_owned())
    })?;
    let p = scene.parameters.clone();
    let (n, m) = (system.coordinates(), system.speeds());
    let needs_reactions = reactions.iter().any(|r| model.arena.mentions(e, *r));
    let mut dynamics = match &balance.code {
        Some(code) if needs_reactions => Dynamics::new(code.system(), &p).ok(),
        _ => None,
    };
    let (mut q_dot, mut u, mut scratch) = (vec![0.0; n], vec![0.0; m], Vec::new());
    Ok(move |_t: f64, y: &[f64]| {
        let (q, v) = y.split_at(n);
        system.coordinate_rates(&p, q, v, &mut q_dot);
        system.generalized_speeds(&p, q, v, &mut u);
        let mut values = [p.as_slice(), q, &q_dot, &u].concat();
        match &mut dynamics {
            // The state has no reaction where the balance is singular: not a number, said by the integrator.
            Some(balance) => match balance.unknowns(q, &u) {
                Ok(x) => values.extend_from_slice(&x[m..]),
                Err(_) => return f64::NAN,
            },
            None => values.extend(reactions.iter().map(|_| f64::NAN)),
        }
        let mut out = [0.0];
        tape.evaluate_into(&values, &mut scratch, &mut out);
        out[0]
    })
}
