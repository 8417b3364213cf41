//! Abbreviated equations of a scene: equations without the terms that change the shown quantities by less than a bound.
//!
//! The effect of each term is first estimated along the run of the whole equations, to first order in the
//! accelerations. The terms with the smallest effects are then left out, and the abbreviated equations are run. The
//! differences of the two runs are the only measure that decides, and they hold for this scene alone.

use crate::code::{Code, CodePreparation, interpreted_code, interpreted_scene_code, interpreted_scene_code_as_derived};
use crate::error::Error;
use crate::integration_options::integration_options;
use crate::mechanism::Mechanism;
use crate::preparation::problem::Problem;
use crate::preparation::reduced_equations::ReducedScene;
use crate::simulation::shown_quantities::ShownQuantities;
use crate::trust::watched_functions::{WatchedFunctions, watched_events};
use nalgebra::{DMatrix, DVector};
use rustc_hash::FxHashSet;
use tripos_codegen::plan::{OperationCount, linear_system_cost};
use tripos_derive::algebra::text::print::print_text;
use tripos_derive::mechanics::{Derivation, EquationsOrigin, SumTerm, SumTerms, has_reducible_form, summand};
use tripos_derive::reduce::Reduction;
use tripos_derive::scene::{AccelerationSolution, Integrator, Scene};
use tripos_derive::{Equations, Formulation, Model};
use tripos_sim::Method;
use tripos_traits::AbsoluteTolerance;

/// Number of parts into which the span of the scene is divided. The runs are compared at one instant of each part.
const PARTS: u32 = 1000;
/// Smallest bound: below it, rounding would decide.
const SMALLEST_BOUND: f64 = 1e-10;
/// Least number of instants at which two runs are compared.
const LEAST_INSTANTS: usize = 10;
/// Number of runs after which the search ends with the terms left out so far.
const MOST_RUNS: usize = 120;
/// Part of the bound that is allowed as relative error of the runs themselves.
const RUN_ERROR: f64 = 1e-4;
/// Part of the largest size of all shown quantities below which a quantity counts as zero, since it is made of
/// rounding.
const ZERO: f64 = 1e-13;

/// Abbreviated equations of a scene, with the terms left out and the measured differences.
pub struct Abbreviation {
    /// Origin of the whole equations: the scene's reduced equations, or Kane's.
    pub by: EquationsOrigin,
    /// Model to which the equations belong: that of the scene, or its reduced model.
    pub model: Model,
    /// Abbreviated equations of motion.
    pub derivation: Derivation,
    /// Number of terms in the mass matrix and the forcing of the whole equations.
    pub terms: usize,
    /// Terms that are left out, those with the largest effects first.
    pub dropped: Vec<DroppedTerm>,
    /// Largest difference of each shown quantity.
    pub differences: Vec<Difference>,
    /// Operations of the mass matrix and the forcing of the whole equations.
    pub whole_cost: OperationCount,
    /// Operations of the mass matrix and the forcing of the abbreviated equations.
    pub cost: OperationCount,
    /// Constants of the motion and products of parameters that reduced equations contain, each with its value in SI
    /// units. Empty for Kane's equations.
    pub constants: Vec<(String, f64)>,
    /// Number of runs that the search made.
    pub runs: usize,
    /// True if the search tried all terms. False if it ended after its largest number of runs: more terms may then be
    /// left out within the bound.
    pub is_complete: bool,
    /// Instant at which the compared runs end, s.
    pub end: f64,
}

/// Term that abbreviated equations lack.
#[derive(Clone, Debug)]
pub struct DroppedTerm {
    /// Summand as text.
    pub term: String,
    /// Sum to which the summand belonged, as text.
    pub sum: String,
    /// Largest estimated change of an acceleration if this term alone is left out, as a part of the acceleration's
    /// largest size in the run. Infinite if the acceleration is zero in the whole run.
    pub effect: f64,
}

/// Difference of a shown quantity between the runs of the whole and of the abbreviated equations.
#[derive(Clone, Debug)]
pub struct Difference {
    /// Name of the shown quantity.
    pub name: String,
    /// Largest difference over the run, in SI units.
    pub largest: f64,
    /// Largest size of the quantity in the run of the whole equations, in SI units, but at least 1e-13 of the largest
    /// size of all shown quantities.
    pub scale: f64,
}

impl Difference {
    /// Largest difference as a part of the quantity's largest size. It is 0 if all shown quantities are zero.
    #[must_use]
    pub fn relative(&self) -> f64 {
        if self.largest == 0.0 { 0.0 } else { self.largest / self.scale }
    }
}

/// Leaves out terms of a scene's equations as long as no shown quantity changes by more than the part `within` of its
/// largest size in the run. The shown quantities are the scene's outputs, or all coordinates and speeds if the scene
/// names none.
///
/// # Errors
/// [`Error::Request`] if `within` is not between 1e-10 and 1, or if the scene has impacts. [`Error::Stopped`] if the
/// run of the whole equations fails. [`Error`] if the model cannot be derived.
pub fn abbreviate(mechanism: &Mechanism, scene: &Scene, within: f64) -> Result<Abbreviation, Error> {
    if !(SMALLEST_BOUND..1.0).contains(&within) {
        let what = format!("the bound {within} is not between {SMALLEST_BOUND:e} and 1");
        return Err(Error::request(what, "state a part of each shown quantity, such as --within 1e-3"));
    }
    if !scene.impacts.is_empty() {
        let help = "leave the contacts out of the scene, or use its whole equations";
        return Err(Error::request("the equations of a scene with contacts are not abbreviated", help));
    }
    mechanism.require_speeds("no equation is left to abbreviate")?;
    let mut scene = scene_for_comparison(scene);
    let mut base = BaseEquations::new(mechanism, &scene)?;
    let mut derivation = base.derivation().clone();
    let parameters = base.model().p();
    let terms = SumTerms::new(&mut derivation.arena, &derivation.equations, &parameters).map_err(|unknown| {
        let what = format!("the equations mention `{}`, which has no value during a run", unknown.0);
        Error::request(what, "abbreviate a scene of derived equations")
    })?;
    // A first run gives the sizes of the states, from which the tolerances of all other runs follow.
    let first = base.run(mechanism, &scene, &derivation)?;
    base.tighten_tolerances(&mut scene, &first, RUN_ERROR * within);
    let whole = base.run(mechanism, &scene, &derivation)?;
    if let Some(why) = &whole.failure {
        return Err(Error::Stopped(format!("the run of the whole equations does not reach its end: {why}")));
    }
    if whole.instants.len() < LEAST_INSTANTS {
        let what = format!("the run of the whole equations ends at t = {} s: too early for a comparison", whole.end);
        return Err(Error::Stopped(what));
    }
    let effects = largest_effects(&terms, &derivation, &base, &scene, &whole)?;
    let mut search = Search {
        mechanism,
        scene: &scene,
        base: &base,
        terms: &terms,
        derivation,
        whole,
        within,
        dropped: FxHashSet::default(),
        kept: None,
        runs: 2,
        is_complete: true,
    };
    let mut order: Vec<usize> = (0..effects.len()).collect();
    order.sort_by(|a, b| effects[*a].total_cmp(&effects[*b]));
    search.drop_in_order(&order)?;
    Ok(search.finish(&order, &effects))
}

/// The scene with the method and the instants of the comparison. The instants are uneven, so that no period hides
/// between them.
fn scene_for_comparison(scene: &Scene) -> Scene {
    let mut scene = scene.clone();
    let (start, end) = scene.span;
    let how = &mut scene.integration;
    how.method = match how.method.method() {
        Some(method) if method.needs_jacobian() => how.method,
        _ => Integrator::Steps(Method::Dop853),
    };
    how.step = None;
    how.solve = None;
    how.project = None;
    how.distance = None;
    // Fractional parts of multiples of the golden ratio have no period.
    let golden = f64::midpoint(1.0, 5.0_f64.sqrt());
    let part = |at: u32| (f64::from(at) + (f64::from(at) * golden).fract()) / f64::from(PARTS);
    how.instants = (0..PARTS).map(|at| start + (end - start) * part(at)).chain([end]).collect();
    scene
}

/// Whole equations of a scene that are abbreviated.
enum BaseEquations {
    /// The scene's own reduced equations.
    Reduced(Box<ReducedScene>),
    /// Kane's equations of the whole model.
    Whole(Box<(Model, Derivation, EquationsOrigin)>),
}

/// Shown quantities of a run at the instants of the comparison.
struct Samples {
    /// Names of the shown quantities.
    names: Vec<String>,
    /// Instants of the samples, s.
    instants: Vec<f64>,
    /// Values of the shown quantities at each instant.
    values: Vec<Vec<f64>>,
    /// Integrated states at the same instants.
    states: Vec<Vec<f64>>,
    /// Instant at which the run ends, s.
    end: f64,
    /// Reason why the run failed; `None` if it did not.
    failure: Option<String>,
}

impl BaseEquations {
    /// Chooses the reduced equations of a scene if they are a gain, and Kane's equations otherwise.
    fn new(mechanism: &Mechanism, scene: &Scene) -> Result<Self, Error> {
        if has_reducible_form(mechanism)
            && let Ok(reduced) = ReducedScene::new(mechanism, scene)
            && reduced.reason_against_reduction(mechanism)?.is_none()
        {
            return Ok(Self::Reduced(Box::new(reduced)));
        }
        let derivation = mechanism.derive(Formulation::Kane)?;
        Ok(Self::Whole(Box::new((mechanism.model.clone(), derivation, EquationsOrigin::from(Formulation::Kane)))))
    }

    /// Sets the tolerances of all further runs to a part of the sizes of the states in a first run.
    fn tighten_tolerances(&mut self, scene: &mut Scene, first: &Samples, part: f64) {
        let count = first.states.first().map_or(0, Vec::len);
        let size = |at: usize| first.states.iter().map(|y| y[at].abs()).fold(0.0, f64::max);
        let sizes: Vec<f64> = (0..count).map(size).collect();
        let largest = sizes.iter().copied().fold(f64::MIN_POSITIVE, f64::max);
        let each = sizes.iter().map(|size| part * if *size > 0.0 { *size } else { largest }).collect();
        let how = match self {
            Self::Reduced(reduced) => &mut reduced.scene.integration,
            Self::Whole(_) => &mut scene.integration,
        };
        how.atol = AbsoluteTolerance::Each(each);
        how.rtol = if how.rtol > 0.0 { how.rtol.min(part) } else { part };
    }

    /// Constants of the motion and products of parameters in reduced equations, with their values.
    fn constants(&self) -> Vec<(String, f64)> {
        match self {
            Self::Reduced(reduced) => reduced.constants().map(|(q, value)| (q.name.clone(), value)).collect(),
            Self::Whole(_) => Vec::new(),
        }
    }

    /// Equations of motion with their arena.
    fn derivation(&self) -> &Derivation {
        match self {
            Self::Reduced(reduced) => &reduced.reduction.derivation,
            Self::Whole(whole) => &whole.1,
        }
    }

    /// Model whose parameters, coordinates and speeds the equations contain.
    fn model(&self) -> &Model {
        match self {
            Self::Reduced(reduced) => &reduced.reduction.model,
            Self::Whole(whole) => &whole.0,
        }
    }

    /// Origin of the equations.
    fn by(&self) -> &EquationsOrigin {
        match self {
            Self::Reduced(reduced) => &reduced.by,
            Self::Whole(whole) => &whole.2,
        }
    }

    /// Values of the parameters of the equations, in SI units.
    fn parameters<'a>(&'a self, scene: &'a Scene) -> &'a [f64] {
        match self {
            Self::Reduced(reduced) => &reduced.scene.parameters,
            Self::Whole(_) => &scene.parameters,
        }
    }

    /// Runs the scene by equations in the variables of these equations.
    fn run(&self, mechanism: &Mechanism, scene: &Scene, derivation: &Derivation) -> Result<Samples, Error> {
        let is_implicit = scene.integration.method.method().is_some_and(Method::needs_jacobian);
        match self {
            Self::Reduced(reduced) => {
                let reduction = Reduction { derivation: derivation.clone(), ..(*reduced.reduction).clone() };
                let code = if is_implicit {
                    interpreted_scene_code(&reduction)?
                } else {
                    interpreted_scene_code_as_derived(&reduction)?
                };
                let problem = Problem::reduced(mechanism, reduced, scene, &code)?;
                let names = reduced.reduction.outputs.iter().map(|output| output.name.clone()).collect();
                samples_of(&problem, names, &|t, y| Ok(problem.shown_state(t, y)))
            }
            Self::Whole(whole) => {
                let ready = if is_implicit { CodePreparation::Solved } else { CodePreparation::AsDerived };
                let code: Code = interpreted_code(mechanism, &whole.2, derivation, ready)?;
                let problem = Problem::new(mechanism, scene, &whole.2, &code, Some(solution_of(is_implicit)))?;
                let shown = ShownQuantities::new(mechanism, scene)?;
                let time = mechanism.time().map(|at| &mechanism.coordinates[at].name);
                let is_wanted = |name: &String| {
                    time != Some(name) && (scene.outputs.is_empty() || scene.outputs.iter().any(|o| o.name == *name))
                };
                let wanted: Vec<usize> = (0..shown.names.len()).filter(|at| is_wanted(&shown.names[*at])).collect();
                let names = wanted.iter().map(|at| shown.names[*at].clone()).collect();
                samples_of(&problem, names, &|t, y| {
                    let all = shown.of(&problem, t, y)?;
                    Ok(wanted.iter().map(|at| all[*at]).collect())
                })
            }
        }
    }
}

/// Way in which a run of the comparison finds the accelerations.
fn solution_of(is_implicit: bool) -> AccelerationSolution {
    if is_implicit { AccelerationSolution::Eliminated } else { AccelerationSolution::Numeric }
}

/// Function that computes the shown quantities at the time t, s, in the integrated state y.
type ShownValues<'a> = dyn Fn(f64, &[f64]) -> Result<Vec<f64>, Error> + 'a;

/// Runs a problem, and computes the shown quantities at its instants by the function `shown`.
fn samples_of(problem: &Problem<'_>, names: Vec<String>, shown: &ShownValues<'_>) -> Result<Samples, Error> {
    let balance = WatchedFunctions::new(problem.mechanism, problem.model, problem.scene, problem.by)?;
    let mut events = watched_events(problem, &balance);
    let y0 = problem.start()?;
    let solution = problem.solve(&y0, &integration_options(problem.scene), &mut events, None)?;
    drop(events);
    let values: Result<Vec<_>, _> = solution.t.iter().zip(&solution.y).map(|(t, y)| shown(*t, y)).collect();
    let values = values?;
    let missing = values.iter().flatten().any(|value| !value.is_finite());
    let failure = if solution.stop.is_failure() {
        Some(solution.stop.described(&problem.variable_names()))
    } else {
        missing.then(|| "a shown quantity has no value".to_owned())
    };
    Ok(Samples { names, instants: solution.t, values, end: solution.t_end, states: solution.y, failure })
}

/// Largest effect of each term along the run of the whole equations: the estimated change of an acceleration if the
/// term is left out, as a part of the acceleration's largest size.
fn largest_effects(
    terms: &SumTerms,
    derivation: &Derivation,
    base: &BaseEquations,
    scene: &Scene,
    whole: &Samples,
) -> Result<Vec<f64>, Error> {
    let parameters = base.parameters(scene);
    let count = derivation.equations.unknowns.len();
    let mut scales = vec![0.0_f64; count];
    let mut largest = vec![vec![0.0_f64; terms.list().len()]; count];
    for state in &whole.states {
        let values = terms.values(&[parameters, state].concat());
        let (rows, forcing) = terms.linear_system(&values);
        let matrix = DMatrix::from_fn(count, count, |i, j| rows[i][j]);
        let inverse = matrix.try_inverse().ok_or_else(|| {
            Error::Stopped("the mass matrix is singular at a state of the run: no term is left out".to_owned())
        })?;
        let unknowns = &inverse * DVector::from_vec(forcing);
        for (at, list) in largest.iter_mut().enumerate() {
            scales[at] = scales[at].max(unknowns[at].abs());
            let weights: Vec<f64> = inverse.row(at).iter().copied().collect();
            let effects = terms.effects(&derivation.arena, &values, unknowns.as_slice(), &weights);
            for (known, effect) in list.iter_mut().zip(effects) {
                *known = known.max(effect.abs());
            }
        }
    }
    let relative = |at: usize, effect: f64| if effect == 0.0 { 0.0 } else { effect / scales[at] };
    let of = |term: usize| largest.iter().enumerate().map(|(at, list)| relative(at, list[term])).fold(0.0, f64::max);
    Ok((0..terms.list().len()).map(of).collect())
}

/// Search for the terms that can be left out.
struct Search<'a> {
    /// Mechanism of the scene.
    mechanism: &'a Mechanism,
    /// Scene with the settings of the comparison.
    scene: &'a Scene,
    /// Whole equations.
    base: &'a BaseEquations,
    /// Terms of the whole equations.
    terms: &'a SumTerms,
    /// Whole equations with the arena of all abbreviated equations.
    derivation: Derivation,
    /// Run of the whole equations.
    whole: Samples,
    /// Largest allowed difference of a shown quantity, as a part of its largest size.
    within: f64,
    /// Terms that are left out so far.
    dropped: FxHashSet<SumTerm>,
    /// Equations without the terms left out so far, and their differences. `None` if no term is left out.
    kept: Option<(Equations, Vec<Difference>)>,
    /// Number of runs so far.
    runs: usize,
    /// False if the search ended before all terms were tried.
    is_complete: bool,
}

impl Search<'_> {
    /// Leaves out terms in the given order. A group of terms is left out at once, and halved if the differences are
    /// too large. A single term with too large a difference stays.
    fn drop_in_order(&mut self, order: &[usize]) -> Result<(), Error> {
        let mut waiting = vec![order];
        while let Some(group) = waiting.pop() {
            if group.is_empty() {
                continue;
            }
            if self.runs >= MOST_RUNS {
                self.is_complete = false;
                break;
            }
            if !self.try_group(group)? && group.len() > 1 {
                let (first, rest) = group.split_at(group.len() / 2);
                waiting.extend([rest, first]);
            }
        }
        Ok(())
    }

    /// Leaves out a group of terms if the differences stay within the bound. Returns true if it is left out.
    fn try_group(&mut self, group: &[usize]) -> Result<bool, Error> {
        let mut dropped = self.dropped.clone();
        dropped.extend(group.iter().map(|at| self.terms.list()[*at]));
        let Some(equations) = self.terms.equations_without(&mut self.derivation.arena, &dropped) else {
            return Ok(false);
        };
        let trial = Derivation { arena: self.derivation.arena.clone(), equations };
        self.runs += 1;
        let run = match self.base.run(self.mechanism, self.scene, &trial) {
            Ok(run) if run.failure.is_none() => run,
            // Equations without these terms may be singular, which eliminated accelerations refuse, or run away. The
            // whole equations ran, so the request itself has no error.
            Ok(_) | Err(Error::Stopped(_) | Error::Request { .. }) => return Ok(false),
            Err(error) => return Err(error),
        };
        let span = (self.scene.span.1 - self.scene.span.0).abs();
        let differences = differences_of(&self.whole, &run);
        let is_within = (run.end - self.whole.end).abs() <= self.within * span
            && differences.iter().all(|difference| difference.relative() <= self.within);
        if is_within {
            self.dropped = dropped;
            self.kept = Some((trial.equations, differences));
        }
        Ok(is_within)
    }

    /// The result of the search. `effects` are the estimated effects of all terms, and `order` sorts them.
    fn finish(self, order: &[usize], effects: &[f64]) -> Abbreviation {
        let model = self.base.model();
        let arena = self.derivation.arena;
        let whole_cost = linear_system_cost(model, self.base.derivation());
        let none = || (self.base.derivation().equations.clone(), differences_of(&self.whole, &self.whole));
        let (equations, differences) = self.kept.unwrap_or_else(none);
        let mut scratch = arena.clone();
        let listed = order.iter().rev().filter(|at| self.dropped.contains(&self.terms.list()[**at]));
        let dropped = listed.map(|at| {
            let term = self.terms.list()[*at];
            let (inner, factor) = summand(&scratch, term);
            let whole = scratch.scale(inner, &factor);
            DroppedTerm { term: print_text(&scratch, whole), sum: print_text(&scratch, term.sum), effect: effects[*at] }
        });
        let dropped = dropped.collect();
        let derivation = Derivation { arena, equations };
        let cost = linear_system_cost(model, &derivation);
        Abbreviation {
            by: self.base.by().clone(),
            model: model.clone(),
            terms: self.terms.list().len(),
            dropped,
            differences,
            whole_cost,
            cost,
            constants: self.base.constants(),
            runs: self.runs,
            is_complete: self.is_complete,
            end: self.whole.end,
            derivation,
        }
    }
}

/// Largest differences of the shown quantities of two runs, at the instants that both runs have.
fn differences_of(whole: &Samples, other: &Samples) -> Vec<Difference> {
    // The last sample of a run that an event ends is at the instant of the event.
    let both = whole.instants.iter().zip(&other.instants).take_while(|(a, b)| a.to_bits() == b.to_bits()).count();
    let size = |at: usize| whole.values.iter().map(|row| row[at].abs()).fold(0.0, f64::max);
    let zero = ZERO * (0..whole.names.len()).map(size).fold(0.0, f64::max);
    let of = |(at, name): (usize, &String)| {
        let pairs = whole.values[..both].iter().zip(&other.values);
        let largest = pairs.map(|(a, b)| (a[at] - b[at]).abs()).fold(0.0, f64::max);
        Difference { name: name.clone(), largest, scale: size(at).max(zero) }
    };
    whole.names.iter().enumerate().map(of).collect()
}
