//! Rigorous runs of scenes: boxes that provably contain what a scene shows, and claims about it.
//!
//! Nothing between the scene file and the boxes is rounded without a bound: the numbers of the file are read as balls,
//! the start of reduced equations is computed in balls, and the motion is enclosed by [`tripos_sim::rigorous_run`].
//! What is trusted: the derived equations, the compiler, and a processor that rounds to nearest.

use super::claims::{Claim, ClaimVerdict};
use crate::code::{solved_scene_tapes, solved_tapes};
use crate::equations_name::{EquationsName, find_equations_or_first};
use crate::error::Error;
use crate::interpreted_equations::InterpretedEquations;
use crate::mechanism::Mechanism;
use crate::observer::Observer;
use crate::preparation::exact_start::{StartNumbers, exact_start_speeds};
use crate::preparation::reduced_equations::enclosed_reduced_start;
use crate::simulation::shown_quantities::state_names;
use tripos_derive::diagnostic::Source;
use tripos_derive::mechanics::{EquationsOrigin, has_reducible_form};
use tripos_derive::reduce::ReductionBasis;
use tripos_derive::scene::{EnclosedScene, InitialMotion, Scene, enclosed_scene};
use tripos_sim::rigorous_run::{Passage, RigorousEnd, RigorousOptions, RigorousRun, SeriesInBalls, enclose};
use tripos_traits::{Ball, Derivative, Dual, Interval, Scalar, System};

/// Number of parts of a step over which ranges are bounded one by one.
const PARTS: usize = 8;
/// Number of times that a part of a step is halved while a claim is undecided in it.
const HALVINGS: u32 = 12;

/// Question about the motion of a scene that a rigorous run answers.
#[derive(Clone, Debug)]
pub struct RigorousRequest<'a> {
    /// Equations to run; `None` for the scene's reduced equations or, if it has none, the whole equations.
    pub by: Option<&'a EquationsName>,
    /// Numbers that replace those of the scene's file, as (name, value in SI units).
    pub set: &'a [(String, f64)],
    /// Number of equal parts of the span at whose ends boxes are given; at least 1.
    pub parts: usize,
    /// Claims about shown quantities, such as `q2 < 90*deg`.
    pub claims: &'a [String],
    /// Options of the enclosure.
    pub options: RigorousOptions,
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
    /// Range of each shown quantity in SI units, from the start to `run.t_end`.
    pub ranges: Vec<Interval>,
    /// Claims with their verdicts, in the order of the request.
    pub claims: Vec<(Claim, ClaimVerdict)>,
    /// Enclosure of the states of the equations, and the reason why it ended.
    pub run: RigorousRun,
    /// Remarks about the choice of the equations.
    pub notes: Vec<String>,
}

/// Encloses the motion of a scene.
///
/// # Errors
/// [`Error::Request`] if the scene has contacts, drives with kinks, or a start that is solved for without a proof; if
/// its equations have no Taylor series; or if a claim is not understood. [`Error::Input`] if a number of the request
/// has no value.
pub fn enclose_scene(
    mechanism: &Mechanism,
    scene: &Scene,
    request: &RigorousRequest<'_>,
) -> Result<RigorousScene, Error> {
    refuse_motion_with_corners(mechanism, scene)?;
    let claims = request.claims.iter().map(|text| Claim::parse(text)).collect::<Result<Vec<_>, _>>()?;
    let bounds: Vec<Source> = claims.iter().map(|claim| Source::from_text("--claim", &claim.bound_text)).collect();
    let numbers = enclosed_scene(scene, mechanism, request.set, &bounds)?;
    refuse_unknown_start(&numbers)?;
    let mut notes = Vec::new();
    let problem = match request.by {
        None | Some(EquationsName::Reduced) => match reduced_problem(mechanism, scene, &numbers) {
            Ok(problem) => problem,
            Err(error) if request.by.is_none() => {
                notes.push(format!("the full equations are enclosed: {}", error.first_line()));
                whole_problem(mechanism, &numbers, &find_equations_or_first(mechanism, None)?)?
            }
            Err(error) => return Err(error),
        },
        Some(by) => whole_problem(mechanism, &numbers, &find_equations_or_first(mechanism, Some(by))?)?,
    };
    if !problem.wide.0.has_taylor() {
        let help = "use loads without |x| and sign, or run the scene without --rigorous";
        return Err(Error::request(format!("{} has no Taylor series here", problem.by.title()), help));
    }
    let claims = claims.into_iter().zip(&numbers.formulas);
    let claims = claims.map(|(claim, bound)| claim.about(&problem.names, *bound)).collect::<Result<Vec<_>, _>>()?;
    Ok(problem.enclosed(&numbers, request, claims, notes))
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

/// Equations of motion in balls, with a start.
struct EnclosedProblem {
    /// Origin of the equations.
    by: EquationsOrigin,
    /// Names of the shown quantities.
    names: Vec<String>,
    /// Equations in balls with 32 digits.
    wide: Derivative<InterpretedEquations<Ball>>,
    /// Equations in balls of doubles.
    narrow: Derivative<InterpretedEquations<Ball<f64>>>,
    /// Equations in balls of doubles with derivatives.
    slopes: Derivative<InterpretedEquations<Dual<Ball<f64>>>>,
    /// Values of the parameters of the equations.
    parameters: Vec<Ball>,
    /// State of the equations at the start.
    start: Vec<Ball>,
    /// Observer of the mechanism, who may end the run.
    follow: Observer,
}

/// Reduced equations of a scene without a moving frame, with their start.
///
/// # Errors
/// `Error` if the model has no reduced equations, or does not determine an output of the scene.
fn reduced_problem(mechanism: &Mechanism, scene: &Scene, numbers: &EnclosedScene) -> Result<EnclosedProblem, Error> {
    if mechanism.speeds.is_empty() || !has_reducible_form(mechanism) {
        return Err(Error::request("this model has no reduced equations", "leave --by out"));
    }
    let basis = ReductionBasis::new(mechanism).map_err(|error| mechanism.diagnose(&error))?;
    let reduction = basis.reduce(scene).map_err(|error| mechanism.diagnose(&error))?;
    // The start of a moving frame is solved for without a proof.
    let reduction = match reduction.frame {
        None => reduction,
        Some(_) => basis.reduce_without_frame(scene).map_err(|error| mechanism.diagnose(&error))?,
    };
    let [parameters, q, v] = enclosed_reduced_start(&reduction, mechanism, &numbers.start)?;
    let names = scene.outputs.iter().map(|output| output.name.clone()).collect();
    let tapes = solved_scene_tapes(&reduction)?;
    let follow = mechanism.follow.clone();
    Ok(EnclosedProblem::new(EquationsOrigin::Reduced, names, &tapes, parameters, [q, v].concat(), follow))
}

/// Equations of the whole model, with their start.
///
/// # Errors
/// `Error` if the model does not have these equations, or if they cannot be solved for the accelerations.
fn whole_problem(
    mechanism: &Mechanism,
    numbers: &EnclosedScene,
    by: &EquationsOrigin,
) -> Result<EnclosedProblem, Error> {
    let tapes = solved_tapes(mechanism, by)?;
    let wide: InterpretedEquations<Ball> = tapes.convert_to();
    let start = &numbers.start;
    let u = exact_start_speeds(mechanism, StartNumbers::from(start))?;
    let mut v = vec![Ball::int(0); wide.lengths().variables];
    wide.motion_variables(&start.parameters, &start.q, &u, &mut v);
    let state = [start.q.clone(), v].concat();
    let follow = mechanism.follow.clone();
    Ok(EnclosedProblem::new(by.clone(), state_names(mechanism), &tapes, start.parameters.clone(), state, follow))
}

impl EnclosedProblem {
    /// Converts equations to balls, for runs from a start with these parameters.
    fn new(
        by: EquationsOrigin,
        names: Vec<String>,
        tapes: &InterpretedEquations,
        parameters: Vec<Ball>,
        start: Vec<Ball>,
        follow: Observer,
    ) -> Self {
        let (wide, narrow) = (Derivative(tapes.convert_to()), Derivative(tapes.convert_to()));
        Self { by, names, wide, narrow, slopes: Derivative(tapes.convert_to()), parameters, start, follow }
    }

    /// Encloses the motion at equal parts of the span, the shown quantities over the whole span, and judges claims.
    fn enclosed(
        &self,
        numbers: &EnclosedScene,
        request: &RigorousRequest<'_>,
        claims: Vec<Claim>,
        notes: Vec<String>,
    ) -> RigorousScene {
        let (from, to) = numbers.span;
        let parts = i64::try_from(request.parts.max(1)).unwrap_or(i64::MAX);
        let instants: Vec<Ball> = (1..=parts).map(|k| from + (to - from) * Ball::ratio(k, parts)).collect();
        let series = SeriesInBalls { wide: &self.wide, narrow: &self.narrow, slopes: &self.slopes };
        let at_start = shown(&self.wide.0, &self.parameters, Ball::int(0), &self.start);
        let mut watch = MotionWatch {
            system: &self.narrow.0,
            parameters: self.parameters.iter().map(|x| Ball::narrowed(*x)).collect(),
            from: Ball::narrowed(from),
            ranges: at_start.iter().map(|x| Interval::new(x.low(), x.high())).collect(),
            verdicts: vec![ClaimVerdict::default(); claims.len()],
            claims: &claims,
        };
        let observe = |passage: &Passage<'_>| {
            for part in 0..PARTS {
                let after = |part: usize| passage.h * (part as f64 / PARTS as f64);
                watch.watch(passage, (after(part), after(part + 1).next_up()), HALVINGS);
            }
            !self.follow.is_interrupted()
        };
        let run = enclose(series, &self.parameters, from, &self.start, &instants, &request.options, observe);
        let MotionWatch { ranges, mut verdicts, .. } = watch;
        if run.end != RigorousEnd::Reached {
            for verdict in &mut verdicts {
                verdict.is_open = true;
            }
        }
        let boxes = run.boxes.iter().zip(&instants);
        let boxes = boxes.map(|(state, t)| shown(&self.wide.0, &self.parameters, *t - from, state)).collect();
        let t = instants.iter().take(run.boxes.len()).map(|t| t.centre.hi()).collect();
        let claims = claims.into_iter().zip(verdicts).collect();
        RigorousScene { by: self.by.clone(), names: self.names.clone(), t, boxes, ranges, claims, run, notes }
    }
}

/// Ranges and verdicts that are collected along a rigorous run.
struct MotionWatch<'a> {
    /// Equations in balls of doubles.
    system: &'a dyn System<Ball<f64>>,
    /// Values of the parameters of the equations.
    parameters: Vec<Ball<f64>>,
    /// First instant of the run, s.
    from: Ball<f64>,
    /// Range of each shown quantity so far.
    ranges: Vec<Interval>,
    /// Claims about shown quantities.
    claims: &'a [Claim],
    /// Verdict on each claim so far.
    verdicts: Vec<ClaimVerdict>,
}

impl MotionWatch<'_> {
    /// Goes on over a part of a step, between two instants in s after its start. A part that leaves a claim
    /// undecided is halved up to `halvings` times.
    fn watch(&mut self, passage: &Passage<'_>, (a, b): (f64, f64), halvings: u32) {
        let time = Ball::between((passage.t + a).next_down(), (passage.t + b).next_up());
        let values = shown(self.system, &self.parameters, time - self.from, &passage.bounds_between(a, b));
        let mut verdicts = self.claims.iter().zip(&self.verdicts);
        if halvings > 0 && verdicts.any(|(claim, verdict)| claim.is_undecided(*verdict, values[claim.quantity])) {
            let middle = 0.5 * a + 0.5 * b;
            self.watch(passage, (a, middle), halvings - 1);
            return self.watch(passage, (middle, b), halvings - 1);
        }
        for (range, x) in self.ranges.iter_mut().zip(&values) {
            *range = Interval::new(x.low().min(range.lo()), x.high().max(range.hi()));
        }
        for (claim, verdict) in self.claims.iter().zip(&mut self.verdicts) {
            claim.judge(verdict, values[claim.quantity], passage.t + b);
        }
    }
}

/// Balls of the shown quantities at an instant, s after the start, in a state.
fn shown<S: Scalar>(system: &dyn System<S>, p: &[S], t: S, state: &[S]) -> Vec<S> {
    let (q, v) = state.split_at(system.lengths().coordinates);
    let mut out = vec![S::int(0); system.output_count()];
    system.outputs(p, t, q, v, &mut out);
    out
}
