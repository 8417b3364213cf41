//! One run of a scene by one formulation.

use crate::code::{By, Code, Ready, by_or_first, code, tape};
use crate::error::Error;
use crate::invariants::{Drift, Watch};
use crate::mechanism::Mechanism;
use crate::problem::Problem;
use crate::reduced::Reduced;
use crate::shown::Shown;
use crate::trust;
use tripos_derive::algebra::Expr;
use tripos_derive::algebra::evaluate::Tape;
use tripos_derive::plain::path_in_line;
use tripos_derive::scene::{Project, QUADRATURE, Scene, Solve};
use tripos_derive::{Formulation, Model};
use tripos_sim::{Direction, Dynamics, Effect, Event, EventRecord, Method, Options, Output, SimError, Solution};
use tripos_traits::{AbsoluteTolerance, Lengths, larger};

/// What came out of a run.
pub struct Run {
    /// Which equations ran.
    pub by: By,
    /// Whether compiled code ran.
    pub code: &'static str,
    /// How accelerations were found.
    pub solve: Solve,
    /// The integrator's result.
    pub solution: Solution,
    /// Why it ended, with the names of its variables.
    pub why: String,
    /// When, after how many steps and why it ended, in a sentence.
    pub ending: String,
    /// What has no value, and when first; set by [`Run::look_for_missing`].
    missing: Option<String>,
    /// What is shown of a state: the names of coordinates and generalized speeds, or of the outputs of a scene.
    pub names: Vec<String>,
    /// Their values at each sample.
    pub states: Vec<Vec<f64>>,
    /// Kinetic and potential energy at each sample; nothing where a scene shows outputs of its own.
    pub energies: Vec<(f64, f64)>,
    /// The same at the end.
    pub end: Vec<f64>,
    /// Largest change of total energy over the samples, J, if it is known.
    pub energy_drift: Option<f64>,
    /// How much each first integral that was watched changed.
    pub drifts: Vec<Drift>,
    /// What a reader may want to know of how the run was made; no reason to distrust it.
    pub notes: Vec<String>,
    /// What a reader must know before trusting the numbers.
    pub warnings: Vec<String>,
}

impl Run {
    /// The values of what is shown under this name, at each sample.
    ///
    /// # Errors
    /// [`Error::Request`] if nothing of this name is shown.
    pub fn column(&self, name: &str) -> Result<Vec<f64>, Error> {
        let at = self.names.iter().position(|shown| shown == name).ok_or_else(|| {
            let known = self.names.iter().map(String::as_str);
            Error::request(format!("the run shows no `{name}`"), tripos_derive::diagnostic::nearest(name, known))
        })?;
        Ok(self.states.iter().map(|values| values[at]).collect())
    }

    /// The events and the conditions of the domain that the run met, in order, with their instants and states.
    #[must_use]
    pub fn events(&self) -> &[EventRecord] {
        &self.solution.events
    }

    /// Why the run must not be trusted to the end that was asked for, a reason a line; nothing if it can be.
    #[must_use]
    pub fn objections(&self) -> Vec<String> {
        self.failure().into_iter().chain(self.warnings.iter().cloned()).collect()
    }

    /// Why the run could not go on, or what it does not give; nothing if it gives all that was asked for.
    #[must_use]
    pub fn failure(&self) -> Option<String> {
        if self.solution.stop.is_failure() { Some(self.ending.clone()) } else { self.missing.clone() }
    }

    /// Looks whether all that is shown has a value, as it is shown now.
    ///
    /// # Errors
    /// As [`Problem::near_divisors`].
    pub fn look_for_missing(&mut self, problem: &Problem<'_>) -> Result<(), Error> {
        self.missing = None;
        let Solution { t, y, t_end, y_end, .. } = &self.solution;
        // The last sample is the end, unless only some instants were asked for.
        let end = Some(((t_end, y_end), &self.end)).filter(|_| t.last() != Some(t_end));
        let samples = t.iter().zip(y).zip(&self.states).chain(end);
        let without = samples.filter_map(|(at, values)| Some((at, values.iter().position(|x| !x.is_finite())?)));
        let mut without = without.peekable();
        let Some(&((t, y), which)) = without.peek() else {
            let lost = self.energy_drift.is_some_and(f64::is_nan);
            self.missing = lost.then(|| "the energy has no value that doubles can hold".to_owned());
            return Ok(());
        };
        let more = without.count() - 1;
        let more = if more == 0 { String::new() } else { format!(" and at {more} of the samples after it") };
        let near = problem.near_divisors(y)?;
        self.missing = Some(format!("`{}` has no value at t = {t} s{more}{near}", self.names[which]));
        Ok(())
    }
}

/// The names of the states: coordinates, then generalized speeds.
#[must_use]
pub fn state_names(model: &Model) -> Vec<String> {
    let coordinates = model.coordinates.iter().map(|c| c.name.clone());
    coordinates.chain(model.speeds.iter().map(|s| s.name.clone())).collect()
}

/// Runs a scene as it asks to be run: by the equations of this name (`reduced` are its own), else by its own reduced ones where these are
/// a gain, and by the whole ones where they are not. A numeric solve is one of whole equations.
///
/// # Errors
/// [`Error`] if there are no such equations, or they cannot be run.
pub fn simulate(mechanism: &Mechanism, scene: &Scene, by: Option<&str>) -> Result<Run, Error> {
    let numeric = scene.integration.solve == Some(Solve::Numeric);
    let whole = |by| run(mechanism, scene, &by_or_first(mechanism, by)?);
    match by.filter(|by| *by != "reduced") {
        Some(by) => whole(Some(by)),
        None if numeric => {
            let mut done = whole(None)?;
            let what = "accelerations are found numerically for whole equations only: every coordinate and speed is run and shown";
            done.warnings.insert(0, what.to_owned());
            Ok(done)
        }
        None => {
            let reduced = Reduced::new(mechanism, scene)?;
            // Quadrature needs the one degree of freedom that only a reduction has.
            let may_run_whole = by.is_none() && scene.integration.method != QUADRATURE;
            match if may_run_whole { reduced.no_gain(mechanism)? } else { None } {
                None => run_reduced(mechanism, scene, &reduced),
                Some(why) => Ok(Run { notes: vec![format!("whole equations are run: {why}")], ..whole(None)? }),
            }
        }
    }
}

/// Runs a scene by one set of equations, and shows what it asks for.
///
/// # Errors
/// [`Error`] if the formulation is not to be had, or the scene asks for what it cannot give.
pub fn run(model: &Mechanism, scene: &Scene, by: &By) -> Result<Run, Error> {
    let code = code(model, by, scene.integration.distance, Ready::for_runs(scene)?)?;
    let problem = Problem::new(model, scene, by, &code, None)?;
    let mut run = run_problem(&problem, proved(model)?.as_ref())?;
    Shown::new(model, scene)?.apply(&problem, &mut run)?;
    Ok(run)
}

/// Runs a scene by its own reduced equations. Where they have no value at the start, since what determines a speed from a momentum
/// is singular there, no momentum is held.
///
/// # Errors
/// As [`run`].
pub fn run_reduced(model: &Mechanism, scene: &Scene, reduced: &Reduced) -> Result<Run, Error> {
    let code = reduced.code(model)?;
    let singular = Problem::reduced(model, reduced, scene, &code)?.singular_start()?;
    let (Some(singular), false) = (singular, reduced.constants().next().is_none()) else {
        return run_own(model, scene, reduced, &code);
    };
    let plain = Reduced::without_momenta(model, scene)?;
    let code = plain.code(model)?;
    if Problem::reduced(model, &plain, scene, &code)?.singular_start()?.is_some() {
        return Err(Error::Stopped(format!("the run cannot start: {singular}")));
    }
    let mut run = run_own(model, scene, &plain, &code)?;
    run.warnings.insert(0, format!("no momentum is held, since {singular}"));
    Ok(run)
}

/// Runs a scene by these of its own equations.
fn run_own(model: &Mechanism, scene: &Scene, reduced: &Reduced, code: &Code) -> Result<Run, Error> {
    let problem = Problem::reduced(model, reduced, scene, code)?;
    // Integrals of the whole are functions of all states, which a scene may not show.
    let watch = if scene.states_outputs { None } else { proved(model)? };
    let mut run = run_problem(&problem, watch.as_ref())?;
    whole_energies(model, scene, reduced, &mut run)?;
    Ok(run)
}

/// The energies of the whole model, from the states that are shown; where a scene shows outputs of its own, none, and the drift of
/// its own energy if it has one.
///
/// The energies of reduced equations are others: what moves by the momenta that are held counts as potential.
///
/// # Errors
/// [`Error`] if Kane's equations cannot be had.
pub fn whole_energies(model: &Mechanism, scene: &Scene, reduced: &Reduced, run: &mut Run) -> Result<(), Error> {
    if scene.states_outputs {
        run.energies.clear();
        run.energy_drift = run.energy_drift.filter(|_| reduced.reduction.has_energy);
        return Ok(());
    }
    let code = code(model, &Formulation::Kane.into(), None, Ready::AsDerived)?;
    let (system, p, n) = (code.system(), scene.parameters.as_slice(), scene.q.len());
    let energies = |state: &Vec<f64>| {
        let (q, u) = state.split_at(n);
        (system.kinetic_energy(p, q, u), system.potential_energy(p, q))
    };
    run.energies = run.states.iter().map(energies).collect();
    let start = run.energies.first().map_or(f64::NAN, |(t, v)| t + v);
    let end = energies(&run.end);
    let changes = run.energies.iter().chain([&end]).map(|(t, v)| (t + v - start).abs());
    run.energy_drift = Some(changes.fold(0.0, larger));
    Ok(())
}

fn shown(problem: &Problem<'_>) -> Vec<String> {
    if problem.by.is_reduced() {
        problem.shown.outputs.iter().map(|o| o.name.clone()).collect()
    } else {
        state_names(problem.model)
    }
}

/// What is conserved; nothing of a large model, of which the proof may take longer than the run: there energy alone is watched.
///
/// # Errors
/// [`Error`] if the model cannot be derived.
pub fn proved(model: &Mechanism) -> Result<Option<Watch>, Error> {
    let small = model.coordinates.len() <= MOST_PROVED;
    small.then(|| Watch::of_model(model)).transpose()
}

/// Coordinates up to which a run proves what is conserved before it watches it.
const MOST_PROVED: usize = 8;

/// Runs a scene by one set of equations that is ready, in the scene's distance if it has one.
///
/// # Errors
/// As [`run`].
pub fn run_code(model: &Mechanism, scene: &Scene, by: &By, code: &Code, watch: Option<&Watch>) -> Result<Run, Error> {
    run_problem(&Problem::new(model, scene, by, code, None)?, watch)
}

/// Runs a problem over the span of its scene, as the scene says.
///
/// # Errors
/// As [`run`].
pub fn run_problem(problem: &Problem<'_>, watch: Option<&Watch>) -> Result<Run, Error> {
    let scene = problem.scene;
    let balance = Balance::new(problem.mechanism, problem.model, scene, problem.by)?;
    let y0 = problem.start()?;
    let mut events = events(problem, &balance);
    let solution = problem.solve(&y0, &options(scene)?, &mut events)?;
    drop(events);
    finish(problem, solution, watch)
}

/// A scene that the simulator refuses.
#[must_use]
pub fn refused(scene: &Scene, error: &SimError) -> Error {
    Error::request(error.to_string(), format!("check {}", path_in_line(&scene.source.path)))
}

/// How a scene is integrated, and at which instants it is sampled.
///
/// # Errors
/// [`Error::Request`] if there is no such method.
pub fn options(scene: &Scene) -> Result<Options, Error> {
    Ok(Options { output: output(scene), ..options_of_ends(scene)? })
}

/// How a scene is integrated where only the ends of its runs are kept: the same steps.
///
/// # Errors
/// [`Error::Request`] if there is no such method.
pub fn options_of_ends(scene: &Scene) -> Result<Options, Error> {
    let how = &scene.integration;
    Ok(Options {
        // Quadrature takes no steps: any method will do.
        method: if how.method == QUADRATURE { Method::Dop853 } else { method(&how.method)? },
        step: how.step,
        step_limit: how.step_limit,
        output: Output::Ends,
        ..Options::tolerances(how.rtol, how.atol.clone())
    })
}

/// The method of this name.
///
/// # Errors
/// [`Error::Request`] if there is none.
pub fn method(name: &str) -> Result<Method, Error> {
    Method::ALL.iter().copied().find(|m| m.name() == name).ok_or_else(|| {
        let names = Method::ALL.iter().map(|m| m.name());
        Error::request(format!("there is no method `{name}`"), tripos_derive::diagnostic::nearest(name, names))
    })
}

/// The method and what its steps are made by: "ode45 with rtol 1e-3, atol 1e-5".
pub fn method_words(scene: &Scene) -> String {
    let how = &scene.integration;
    if how.method == QUADRATURE {
        return QUADRATURE.to_owned();
    }
    let projected = match how.project {
        Some(Project::Energy) => ", each projected onto the energy",
        None => "",
    };
    let steps = match (how.step, &how.atol) {
        (Some(step), _) => format!("steps of {step:e} s"),
        (None, AbsoluteTolerance::Uniform(atol)) => format!("rtol {:e}, atol {atol:e}", how.rtol),
        (None, AbsoluteTolerance::Each(_)) => format!("rtol {:e}, an atol for each state", how.rtol),
    };
    let distance = how.distance.map_or_else(String::new, |d| {
        format!(", in a coordinate's distance from {}°", 90 * i64::from(d.quarter_turns))
    });
    format!("{} with {steps}{projected}{distance}", how.method)
}

fn output(scene: &Scene) -> Output {
    match scene.integration.samples {
        None => Output::Steps { refine: 4 },
        Some(n) => {
            let (from, to) = scene.span;
            let last = (n - 1).max(1) as f64;
            // The last instant is exact, whatever the division rounds to.
            Output::At((0..n).map(|i| if i + 1 == n { to } else { from + (to - from) * i as f64 / last }).collect())
        }
    }
}

fn finish(problem: &Problem<'_>, solution: Solution, watch: Option<&Watch>) -> Result<Run, Error> {
    let scene = problem.scene;
    let (system, p) = (problem.system(), scene.parameters.as_slice());
    let dynamics = problem.dynamics().map_err(|error| refused(scene, &error))?;
    let energy = |y: &[f64]| {
        let (q, v) = dynamics.split(y);
        (system.kinetic_energy(p, q, v), system.potential_energy(p, q))
    };
    let energies: Vec<(f64, f64)> = solution.y.iter().map(|y| energy(y)).collect();
    let energy_drift = dynamics.energy_drift(&solution);
    let warnings = trust::objections(problem, &solution, watch, energy_drift)?;
    let drifts = watch.map_or_else(Vec::new, |watch| watch.drifts(problem, &solution));
    let names = problem.variables();
    let at = if solution.stop.is_failure() { problem.near_divisors(&solution.y_end)? } else { String::new() };
    let mut run = Run {
        why: solution.stop.described(&names) + &at,
        ending: solution.described(&names) + &at,
        missing: None,
        drifts,
        by: problem.by.clone(),
        code: problem.code.name(),
        solve: problem.solve,
        states: solution.t.iter().zip(&solution.y).map(|(t, y)| problem.state(*t, y)).collect(),
        energies,
        names: shown(problem),
        end: problem.state(solution.t_end, &solution.y_end),
        energy_drift: Some(energy_drift),
        notes: Vec::new(),
        warnings,
        solution,
    };
    run.look_for_missing(problem)?;
    Ok(run)
}

/// What is watched in the runs of a scene, compiled once: expressions, and the force balance that gives reactions, whichever
/// formulation runs, if one of them mentions a reaction.
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
    /// For what is watched in a scene of this model: the mechanism's own, or a reduced one, which has no reactions any more.
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
                            reaction.name, by.name
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
        events.push(Event {
            name: event.name.clone(),
            function: Box::new(function),
            direction: event.direction,
            effect,
        });
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
