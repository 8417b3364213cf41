//! Rigorous runs of scenes: boxes that provably contain what a scene shows, with the verdicts on its claims and the
//! instants of its events.
//!
//! Nothing between the scene file and the boxes is rounded without a bound: the numbers of the file are read as balls,
//! the start of reduced equations is computed in balls, and the motion is enclosed by [`tripos_sim::rigorous_run`].
//! What is trusted: the derived equations, the compiler, and a processor that rounds to nearest.

use super::claims::ClaimVerdict;
use super::crossings::{Crossing, CrossingCount, EventSearch};
use super::motion_watch::MotionWatch;
use super::observed_equations::{ObservedEquations, StateFormulas};
use crate::code::{solved_scene_tapes, solved_tapes};
use crate::equations_name::{EquationsName, find_equations_or_first};
use crate::error::Error;
use crate::mechanism::Mechanism;
use crate::observer::Observer;
use crate::preparation::exact_start::{StartNumbers, exact_start_speeds};
use crate::preparation::reduced_start::enclosed_reduced_start;
use tripos_derive::algebra::Expr;
use tripos_derive::mechanics::{EquationsOrigin, has_reducible_form};
use tripos_derive::reduce::ReductionBasis;
use tripos_derive::scene::{
    DETERMINANT, EnclosedScene, InitialMotion, Scene, SceneClaim, SceneOutput, default_outputs, enclosed_scene,
    load_claim,
};
use tripos_sim::rigorous_run::{Passage, RigorousEnd, RigorousOptions, RigorousRun, SeriesInBalls, enclose};
use tripos_traits::{Ball, Dual, Interval, Scalar, System};

/// Question about the motion of a scene that a rigorous run answers.
#[derive(Clone, Debug)]
pub struct RigorousRequest<'a> {
    /// Equations to run; `None` for the scene's reduced equations or, if it has none, the whole equations.
    pub by: Option<&'a EquationsName>,
    /// Numbers that replace those of the scene's file, as (name, value in SI units).
    pub set: &'a [(String, f64)],
    /// Instants at which boxes are given.
    pub instants: EnclosedInstants<'a>,
    /// Claims about the motion beside those of the scene, such as `q2 < 90*deg`.
    pub claims: &'a [String],
    /// Number of operations on balls after which the enclosure ends, approximately; `u64::MAX` for no such limit.
    pub operation_limit: u64,
    /// Options of the enclosure.
    pub options: RigorousOptions,
}

/// Instants of a scene at which a rigorous run gives boxes.
#[derive(Clone, Copy, Debug)]
pub enum EnclosedInstants<'a> {
    /// Ends of this number of equal parts of the span, at least 1.
    Parts(usize),
    /// Instants of the span in increasing order, s. The run ends at the last one.
    At(&'a [f64]),
}

impl EnclosedInstants<'_> {
    /// Instants of the span as balls that contain them.
    fn balls(self, (from, to): (Ball, Ball)) -> Vec<Ball> {
        match self {
            Self::Parts(parts) => {
                let parts = i64::try_from(parts.max(1)).unwrap_or(i64::MAX);
                (1..=parts).map(|k| from + (to - from) * Ball::ratio(k, parts)).collect()
            }
            Self::At(list) => list.iter().map(|t| Ball::from_f64(*t)).collect(),
        }
    }
}

/// Boxes that contain what a scene shows, at instants of its span.
#[derive(Clone, Debug)]
pub struct RigorousScene {
    /// Origin of the equations that were run.
    pub by: EquationsOrigin,
    /// Names of the shown quantities.
    pub names: Vec<String>,
    /// Instants, s, to the nearest double, in increasing order. The boxes hold at the exact instants.
    pub t: Vec<f64>,
    /// Ball of each shown quantity in SI units, for each instant.
    pub boxes: Vec<Vec<Ball>>,
    /// Range of each shown quantity in SI units, from the start to `run.t_end`, or to the event that ends the motion.
    pub ranges: Vec<Interval>,
    /// Claims with their verdicts: those of the scene about these equations, then those of the request.
    pub claims: Vec<(SceneClaim, ClaimVerdict)>,
    /// Crossings of the scene's events, in the order of time.
    pub crossings: Vec<Crossing>,
    /// Index of the crossing that ends the motion, or that may end it; `None` if no event does.
    pub ended_by: Option<usize>,
    /// Enclosure of the states of the equations, and the reason why it ended.
    pub run: RigorousRun,
    /// Remarks about the choice of the equations, and what was not looked for.
    pub notes: Vec<String>,
}

impl RigorousScene {
    /// Crossing of the event that ends the motion, or that may end it; `None` if no event does.
    #[must_use]
    pub fn last_event(&self) -> Option<&Crossing> {
        self.ended_by.map(|at| &self.crossings[at])
    }

    /// True if the motion is enclosed to the end of the span, or to an event that is proved to end it.
    #[must_use]
    pub fn is_whole(&self) -> bool {
        match self.last_event() {
            Some(crossing) => crossing.count != CrossingCount::Open,
            None => self.run.end == RigorousEnd::Reached,
        }
    }
}

/// Encloses the motion of a scene, looks for its events, and judges its claims about the equations that are run.
///
/// # Errors
/// [`Error::Request`] if the scene has contacts, drives with kinks, or a start that is solved for without a proof; or
/// if its equations have no Taylor series. [`Error::Input`] if a claim is not understood, or if a number of the request
/// has no value.
pub fn enclose_scene(
    mechanism: &Mechanism,
    scene: &Scene,
    request: &RigorousRequest<'_>,
) -> Result<RigorousScene, Error> {
    refuse_motion_with_corners(mechanism, scene)?;
    let mut mechanism = mechanism.clone();
    let mut claims = Vec::new();
    let mut notes = Vec::new();
    for claim in &scene.claims {
        let by = claim.by.as_deref().map(EquationsName::from);
        if by.as_ref() == request.by {
            claims.push(claim.clone());
        } else {
            let option = by.map_or_else(|| "without `--by`".to_owned(), |by| format!("with `--by {by}`"));
            notes.push(format!("the claim `{}` is about other equations: run {option}", claim.text));
        }
    }
    for text in request.claims {
        claims.push(load_claim(text, scene, &mut mechanism)?);
    }
    let numbers = enclosed_scene(scene, &mechanism, request.set)?;
    refuse_unknown_start(&numbers)?;
    let observed = Observed { scene, claims };
    let problem = match request.by {
        None | Some(EquationsName::Reduced) => match reduced_problem(&mechanism, &observed, &numbers) {
            Ok(problem) => problem,
            Err(error) if request.by.is_none() => {
                notes.push(format!("the full equations are enclosed: {}", error.first_line()));
                let by = find_equations_or_first(&mechanism, None)?;
                whole_problem(&mut mechanism, &observed, &numbers, &by, &mut notes)?
            }
            Err(error) => return Err(error),
        },
        Some(by) => {
            let by = find_equations_or_first(&mechanism, Some(by))?;
            whole_problem(&mut mechanism, &observed, &numbers, &by, &mut notes)?
        }
    };
    if !problem.wide.equations.0.has_taylor() {
        let help = "use loads without |x| and sign, or run the scene without --rigorous";
        return Err(Error::request(format!("{} has no Taylor series here", problem.by.title()), help));
    }
    Ok(problem.enclosed(&numbers, request, observed, notes))
}

/// Refuses scenes whose motion has corners or jumps, or goes backwards in time.
fn refuse_motion_with_corners(mechanism: &Mechanism, scene: &Scene) -> Result<(), Error> {
    let help = "run the scene without --rigorous";
    if !scene.impacts.is_empty() {
        return Err(Error::request("a rigorous run has no contacts", help));
    }
    if !mechanism.corner_instants(&scene.parameters).is_empty() {
        return Err(Error::request("a rigorous run has no drives with kinks or jumps", help));
    }
    if scene.span.1 < scene.span.0 {
        return Err(Error::request("a rigorous run goes forwards in time", "let the span end after its first instant"));
    }
    Ok(())
}

/// Refuses a start with a number that has no proved bound.
fn refuse_unknown_start(numbers: &EnclosedScene) -> Result<(), Error> {
    let start = &numbers.start;
    let (InitialMotion::Speeds(motion) | InitialMotion::Rates(motion)) = &start.motion;
    let mut all = start.parameters.iter().chain(&start.q).chain(motion).chain([&numbers.span.0, &numbers.span.1]);
    if all.all(|x| x.is_defined()) {
        return Ok(());
    }
    let what = "a coordinate or a rate of the start is solved for, and its error is not proved to be small";
    let help =
        "state as many coordinates, and speeds or rates, as the mechanism has freedoms, so that the others follow";
    Err(Error::request(what, help))
}

/// Scene with the claims that are judged in one rigorous run.
struct Observed<'a> {
    /// Scene whose motion is enclosed.
    scene: &'a Scene,
    /// Claims about its motion.
    claims: Vec<SceneClaim>,
}

impl Observed<'_> {
    /// Terms of the distances of the claims.
    fn distances(&self) -> impl Iterator<Item = Expr> {
        self.claims.iter().map(|claim| claim.distance)
    }
}

/// Equations of motion in balls, with a start.
struct EnclosedProblem {
    /// Origin of the equations.
    by: EquationsOrigin,
    /// Names of the shown quantities.
    names: Vec<String>,
    /// Indices in the scene of the events that are looked for.
    events: Vec<usize>,
    /// Equations in balls with 32 digits.
    wide: ObservedEquations<Ball>,
    /// Equations in balls of doubles.
    narrow: ObservedEquations<Ball<f64>>,
    /// Equations in balls of doubles with derivatives.
    slopes: ObservedEquations<Dual<Ball<f64>>>,
    /// Values of the parameters of the equations.
    parameters: Vec<Ball>,
    /// State of the equations at the start.
    start: Vec<Ball>,
    /// Observer of the mechanism, who may end the run.
    follow: Observer,
}

/// Reduced equations of a scene without a moving frame, with their start. They observe the outputs, the claims and the
/// events of the scene.
///
/// # Errors
/// `Error` if the model has no reduced equations, or does not determine an output of the scene.
fn reduced_problem(
    mechanism: &Mechanism,
    observed: &Observed<'_>,
    numbers: &EnclosedScene,
) -> Result<EnclosedProblem, Error> {
    if mechanism.speeds.is_empty() || !has_reducible_form(mechanism) {
        return Err(Error::request("this model has no reduced equations", "leave --by out"));
    }
    let is_determinant = |claim: &&SceneClaim| {
        let symbol = mechanism.arena.find_symbol(DETERMINANT);
        symbol.is_some_and(|symbol| mechanism.arena.mentions(claim.distance, symbol))
    };
    if let Some(claim) = observed.claims.iter().find(is_determinant) {
        let what = format!("the claim `{}` needs the mass matrix of whole equations", claim.text);
        return Err(Error::request(what, "state the equations, such as --by kane"));
    }
    let mut scene = observed.scene.clone();
    let names = scene.outputs.iter().map(|output| output.name.clone()).collect();
    let functions = scene.events.iter().map(|event| event.function);
    let further: Vec<Expr> = observed.distances().chain(functions).collect();
    scene.outputs.extend(further.into_iter().map(|value| SceneOutput { name: String::new(), value }));
    let basis = ReductionBasis::new(mechanism).map_err(|error| mechanism.diagnose(&error))?;
    let reduction = basis.reduce(&scene).map_err(|error| mechanism.diagnose(&error))?;
    // The start of a moving frame is solved for without a proof.
    let reduction = match reduction.frame {
        None => reduction,
        Some(_) => basis.reduce_without_frame(&scene).map_err(|error| mechanism.diagnose(&error))?,
    };
    let [parameters, q, v] = enclosed_reduced_start(&reduction, mechanism, &numbers.start)?;
    let tapes = solved_scene_tapes(&reduction)?;
    Ok(EnclosedProblem {
        by: EquationsOrigin::Reduced,
        names,
        events: (0..scene.events.len()).collect(),
        wide: ObservedEquations::new(&tapes, None),
        narrow: ObservedEquations::new(&tapes, None),
        slopes: ObservedEquations::new(&tapes, None),
        parameters,
        start: [q, v].concat(),
        follow: mechanism.follow.clone(),
    })
}

/// Equations of the whole model, with their start. They observe all coordinates and speeds, and the outputs, claims and
/// events of the scene. Events that contain reactions are left out, with a note.
///
/// # Errors
/// `Error` if the model does not have these equations, if they cannot be solved for the accelerations, or if an output
/// or a claim contains a reaction.
fn whole_problem(
    mechanism: &mut Mechanism,
    observed: &Observed<'_>,
    numbers: &EnclosedScene,
    by: &EquationsOrigin,
    notes: &mut Vec<String>,
) -> Result<EnclosedProblem, Error> {
    let tapes = solved_tapes(mechanism, by)?;
    let Observed { scene, .. } = observed;
    let mut names: Vec<String> = default_outputs(mechanism).into_iter().map(|output| output.name).collect();
    let others: Vec<&SceneOutput> = scene.outputs.iter().filter(|output| !names.contains(&output.name)).collect();
    names.extend(others.iter().map(|output| output.name.clone()));
    let mut formulas: Vec<Expr> = others.iter().map(|output| output.value).chain(observed.distances()).collect();
    let mut events = Vec::new();
    for (at, event) in scene.events.iter().enumerate() {
        if StateFormulas::new(mechanism, &[event.function]).is_ok() {
            formulas.push(event.function);
            events.push(at);
        } else {
            notes.push(format!("the event `{}` is not looked for: whole equations do not give reactions", event.name));
        }
    }
    let formulas = if formulas.is_empty() { None } else { Some(StateFormulas::new(mechanism, &formulas)?) };
    let wide = ObservedEquations::<Ball>::new(&tapes, formulas.as_ref());
    let start = &numbers.start;
    let u = exact_start_speeds(mechanism, StartNumbers::from(start))?;
    let system = &wide.equations.0;
    let mut v = vec![Ball::int(0); system.lengths().variables];
    system.motion_variables(&start.parameters, &start.q, &u, &mut v);
    Ok(EnclosedProblem {
        by: by.clone(),
        names,
        events,
        narrow: ObservedEquations::new(&tapes, formulas.as_ref()),
        slopes: ObservedEquations::new(&tapes, formulas.as_ref()),
        wide,
        parameters: start.parameters.clone(),
        start: [start.q.clone(), v].concat(),
        follow: mechanism.follow.clone(),
    })
}

impl EnclosedProblem {
    /// Largest number of steps, so that the operations stay within the limit of the request.
    fn step_limit(&self, request: &RigorousRequest<'_>) -> u64 {
        let products = self.wide.equations.0.series_products().max(1) as u64;
        let order = request.options.order as u64;
        // Every step computes the coefficients twice, and their derivatives by each state.
        let of_step = products * order * order / 2 * (2 + 2 * self.start.len() as u64);
        request.options.step_limit.min((request.operation_limit / of_step.max(1)).max(1))
    }

    /// Encloses the motion at the instants of the request, the shown quantities over the whole span, and the events;
    /// judges the claims.
    fn enclosed(
        &self,
        numbers: &EnclosedScene,
        request: &RigorousRequest<'_>,
        observed: Observed<'_>,
        notes: Vec<String>,
    ) -> RigorousScene {
        let from = numbers.span.0;
        let instants = request.instants.balls(numbers.span);
        let (wide, narrow, slopes) = (&self.wide, &self.narrow, &self.slopes);
        let series = SeriesInBalls { wide: &wide.equations, narrow: &narrow.equations, slopes: &slopes.equations };
        let shown_in = |t: Ball, state: &[Ball]| {
            let mut values = wide.observed(&self.parameters, t, state);
            values.truncate(self.names.len());
            values
        };
        let at_start = wide.observed(&self.parameters, Ball::int(0), &self.start);
        let (shown_at_start, _) = at_start.split_at(self.names.len());
        let event_functions = &at_start[at_start.len() - self.events.len()..];
        let search = |(at, start): (&usize, &Ball)| {
            let event = &observed.scene.events[*at];
            EventSearch::new(*at, event.direction, event.terminal, *start)
        };
        let mut watch = MotionWatch {
            narrow,
            slopes,
            parameters: self.parameters.iter().map(|x| Ball::narrowed(*x)).collect(),
            from: Ball::narrowed(from),
            ranges: shown_at_start.iter().map(|x| Interval::new(x.low(), x.high())).collect(),
            verdicts: vec![ClaimVerdict::default(); observed.claims.len()],
            events: self.events.iter().zip(event_functions).map(search).collect(),
            crossings: Vec::new(),
        };
        let observe = |passage: &Passage<'_>| watch.watch(passage).is_continue() && !self.follow.is_interrupted();
        let options = RigorousOptions { step_limit: self.step_limit(request), ..request.options };
        let run = enclose(series, &self.parameters, from, &self.start, &instants, &options, observe);
        watch.finish();
        let MotionWatch { ranges, mut verdicts, mut crossings, .. } = watch;
        crossings.sort_by(|a, b| a.from.total_cmp(&b.from));
        let ended_by = crossings.iter().position(|crossing| observed.scene.events[crossing.event].terminal);
        if let Some(end) = ended_by.map(|at| crossings[at].to) {
            crossings.retain(|crossing| crossing.from <= end);
        }
        let boxes = run.boxes.iter().zip(&instants);
        let boxes = boxes.map(|(state, t)| shown_in(*t - from, state)).collect();
        let t = instants.iter().take(run.boxes.len()).map(|t| t.centre.hi()).collect();
        let names = self.names.clone();
        let mut scene = RigorousScene {
            by: self.by.clone(),
            names,
            t,
            boxes,
            ranges,
            claims: Vec::new(),
            crossings,
            ended_by,
            run,
            notes,
        };
        if !scene.is_whole() {
            for verdict in &mut verdicts {
                verdict.is_open = true;
            }
        }
        scene.claims = observed.claims.into_iter().zip(verdicts).collect();
        scene
    }
}
