//! Equations of motion in numbers that carry derivatives ("slopes"): compiled, or interpreted by
//! tapes with slopes.

use super::bounce::{Bounced, Parts};
use super::contacts::Wide;
use super::corners::corners;
use super::graze::{self, near};
use super::history::ContactHistory;
use super::start::Seed;
use crate::code::{Code, Ready, code, code_of, derivation};
use crate::error::{Error, refused};
use crate::interpreted::Interpreted;
use crate::mechanism::Mechanism;
use crate::preparation::impacts::Approach;
use crate::preparation::initial::InitialState;
use crate::preparation::problem::Problem;
use crate::trust::power::accounted;
use std::cell::OnceCell;
use tripos_derive::mechanics::{EquationsOrigin, in_distance};
use tripos_derive::scene::Scene;
use tripos_sim::{Accompanied, Event, Lent, Options, Output, RightHandSide, Solution, Tangents, integrate};
use tripos_traits::{CompiledSystem, Derivative, InTangents, Method, Tangent};

/// Equations of motion that compute rates together with their derivatives ("slopes") by varied
/// numbers.
pub struct Equations {
    /// Equations of motion in double precision.
    pub code: Code,
    /// Interpreted equations in numbers with one slope; empty until they are first used.
    one: OnceCell<Derivative<Interpreted<Tangent<1>>>>,
    /// Interpreted equations in numbers with four slopes; empty until they are first used.
    four: OnceCell<Derivative<Interpreted<Tangent<4>>>>,
}

impl Equations {
    /// Prepares the equations of a mechanism for an integrator. Compiled equations are used only if the
    /// program also contains them with slopes, and the integrator needs no Taylor series. Otherwise the
    /// equations are interpreted.
    ///
    /// # Errors
    /// `Error` if the model cannot be derived, or the equations cannot be interpreted.
    pub fn new(mechanism: &Mechanism, scene: &Scene, by: &EquationsOrigin, method: Method) -> Result<Self, Error> {
        let distance = scene.integration.distance;
        let mut code = code(mechanism, by, distance, Ready::Solved)?;
        let has_all = compiled(&code).is_some() && !method.needs_series();
        if code.is_compiled() && !has_all {
            let derived = derivation(mechanism, by)?;
            let derived = match distance {
                Some(distance) => in_distance(mechanism, derived, distance),
                None => derived,
            };
            code = code_of(mechanism, by, &derived, Ready::Solved)?;
        }
        Ok(Self { code, one: OnceCell::new(), four: OnceCell::new() })
    }

    /// True if Taylor coefficients can be computed together with slopes, which only interpreted
    /// equations can.
    pub fn has_series(&self) -> bool {
        compiled(&self.code).is_none() && self.code.system().has_taylor()
    }

    /// Functions that compute rates with the slopes by one varied number.
    pub fn one(&self) -> Parts<'_, 1> {
        match (&self.code, compiled(&self.code)) {
            (Code::Interpreted(system), _) => parts(self.one.get_or_init(|| Derivative(system.double.to()))),
            (_, Some(tangents)) => (tangents.one, None),
            _ => unreachable!("equations that are compiled without slopes are interpreted"),
        }
    }

    /// Functions that compute rates with the slopes by four varied numbers.
    fn four(&self) -> Parts<'_, 4> {
        match (&self.code, compiled(&self.code)) {
            (Code::Interpreted(system), _) => parts(self.four.get_or_init(|| Derivative(system.double.to()))),
            (_, Some(tangents)) => (tangents.four, None),
            _ => unreachable!("equations that are compiled without slopes are interpreted"),
        }
    }

    /// Makes a run together with its derivatives by each varied number of its start.
    ///
    /// The results are the derivatives of the computed steps themselves. A run carries at most four
    /// slopes. For more varied numbers, the run is repeated for each further four.
    ///
    /// # Errors
    /// [`Error::Request`] if the run cannot begin, or there is no varied number.
    pub fn run(
        &self,
        problem: &Problem<'_>,
        from: &SeededStart<'_>,
        options: &Options,
        events: &mut [Event<'_>],
    ) -> Result<Carried, Error> {
        let mut carried: Option<Carried> = None;
        for (seeds, slopes) in from.seeds.chunks(4).zip(from.slopes.chunks(4)) {
            let part = SeededStart { seeds, slopes, ..*from };
            let more = match seeds.len() {
                1 => watched(problem, self.one(), &part, options, events)?,
                _ => watched(problem, self.four(), &part, options, events)?,
            };
            match &mut carried {
                None => carried = Some(more),
                Some(known) => {
                    known.at.extend(more.at);
                    known.end.extend(more.end);
                    known.history.extend(more.history);
                }
            }
        }
        carried.ok_or_else(|| Error::request("there is nothing to differentiate by", "name a parameter"))
    }
}

/// Start of a run with derivatives: its span, its state, and the slopes of the state by each varied
/// number.
#[derive(Clone, Copy)]
pub struct SeededStart<'a> {
    /// First and last instant of the run, s.
    pub span: (f64, f64),
    /// Integrated state (q, v) at the first instant.
    pub y: &'a [f64],
    /// Varied numbers by which derivatives are taken.
    pub seeds: &'a [Seed],
    /// Slopes of the state `y` at the first instant, a list for each varied number.
    pub slopes: &'a [Vec<f64>],
}

/// A run with the slopes of its integrated states by each varied number.
pub struct Carried {
    /// Solution of the run in double precision, without slopes.
    pub solution: Solution,
    /// Slopes of the integrated state. Indices: varied number, sample, component of the state.
    pub at: Vec<Vec<Vec<f64>>>,
    /// Slopes of the integrated state at the end of the run. Indices: varied number, component of the
    /// state.
    pub end: Vec<Vec<f64>>,
    /// Changes of contacts during the run with their derivatives, and early ends of derivatives.
    pub history: ContactHistory,
}

/// Functions of interpreted equations that compute rates, and Taylor coefficients, with slopes.
fn parts<const K: usize>(system: &Derivative<Interpreted<Tangent<K>>>) -> Parts<'_, K> {
    (system, Some(system))
}

/// Functions of compiled equations that compute rates with slopes. `None` if the equations are
/// interpreted, or were compiled without slopes.
fn compiled(code: &Code) -> Option<InTangents<'static>> {
    match code {
        Code::Compiled(CompiledSystem { lanes: Some(lanes), .. }) => lanes.tangents,
        _ => None,
    }
}

/// Makes a run in numbers with `K` slopes. Derivatives end early at an instant at which a gap only
/// touches zero, if the varied number changes this gap.
///
/// # Errors
/// `Error::Request` if the run cannot begin.
fn watched<const K: usize>(
    problem: &Problem<'_>,
    parts: Parts<'_, K>,
    from: &SeededStart<'_>,
    options: &Options,
    events: &mut [Event<'_>],
) -> Result<Carried, Error> {
    let (mut carried, approaches) = carry(problem, parts, from, options, Touches::Listed, events)?;
    for approach in &approaches {
        end_at(problem, parts, &mut carried, approach, from.seeds, options)?;
    }
    Ok(carried)
}

/// Ends the derivatives by those varied numbers that change a gap at its minimum of zero.
///
/// # Errors
/// `Error` if the state at the minimum cannot be computed.
fn end_at<const K: usize>(
    problem: &Problem<'_>,
    parts: Parts<'_, K>,
    carried: &mut Carried,
    approach: &Approach,
    seeds: &[Seed],
    options: &Options,
) -> Result<(), Error> {
    let Approach { contact, t, y } = approach;
    let solution = &carried.solution;
    let Some(sample) = solution.t.iter().rposition(|sample| sample <= t) else { return Ok(()) };
    let mut slopes: Vec<Vec<f64>> = carried.at.iter().map(|list| list[sample].clone()).collect();
    if solution.t[sample] < *t {
        let from = SeededStart { span: (solution.t[sample], *t), y: &solution.y[sample], seeds, slopes: &slopes };
        let short = Options { output: Output::Ends, ..options.clone() };
        slopes = carry(problem, parts, &from, &short, Touches::Ignored, &mut [])?.0.end;
    }
    let contacts = problem.contacts();
    let wide = Wide::new(&contacts, problem.code.extended(), near(options));
    for (k, (seed, slopes)) in seeds.iter().zip(&slopes).enumerate() {
        if let Err(why) = graze::check(&wide, *contact, y, &seed.varied(), slopes) {
            carried.over(k, *t, why);
        }
    }
    Ok(())
}

impl Carried {
    /// Ends the derivatives by the varied number with index `number` at the instant `t`, s. Later
    /// slopes become NaN.
    fn over(&mut self, number: usize, t: f64, why: String) {
        self.history.end(number, t, why);
        let later = self.solution.t.iter().zip(&mut self.at[number]).filter(|(sample, _)| **sample >= t);
        let later = later.map(|(_, slopes)| slopes);
        later.chain([&mut self.end[number]]).for_each(|slopes| slopes.fill(f64::NAN));
    }
}

/// Choice to list the gaps whose minimum is nearly zero, or to ignore them.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Touches {
    /// The minima of gaps that are nearly zero are listed.
    Listed,
    /// Minima of gaps are not searched for.
    Ignored,
}

/// Makes a run in numbers with `K` slopes, by at most `K` varied numbers. The list contains the
/// minima of gaps that are nearly zero; it is empty if `touches` asks for none.
///
/// # Errors
/// `Error::Request` if the run cannot begin.
fn carry<const K: usize>(
    problem: &Problem<'_>,
    parts: Parts<'_, K>,
    from: &SeededStart<'_>,
    options: &Options,
    touches: Touches,
    events: &mut [Event<'_>],
) -> Result<(Carried, Vec<Approach>), Error> {
    let SeededStart { span, seeds, .. } = *from;
    let tangent = |value: f64, slope: &dyn Fn(usize) -> f64| {
        let mut slopes = [0.0; K];
        for (k, out) in slopes.iter_mut().enumerate().take(seeds.len()) {
            *out = slope(k);
        }
        Tangent { value, slopes }
    };
    let values = problem.scene.parameters.iter().enumerate();
    let p: Vec<Tangent<K>> = values.map(|(at, p)| tangent(*p, &|k| seeds[k].parameters[at])).collect();
    let values = from.y.iter().enumerate();
    let y0: Vec<Tangent<K>> = values.map(|(at, y)| tangent(*y, &|k| from.slopes[k][at])).collect();
    let options = Options { corners: corners(problem, &p), ..problem.options(options) };
    let start = InitialState { span, y: &y0 };
    let (solution, history, approaches) = if problem.scene.impacts.is_empty() {
        (smooth(problem, parts, &p, start, &options, events)?, ContactHistory::new(seeds.len()), Vec::new())
    } else {
        let (contacts, near) = (problem.contacts(), near(&options));
        let mut bounced = Bounced::new(problem, parts, &p, seeds, &contacts, near);
        bounced.corners = &options.corners;
        bounced.near = (touches == Touches::Listed).then_some(near);
        let run = problem.bounce(&contacts, &bounced, start, &options, events, accounted(problem)?);
        let run = run.map_err(|error| refused(problem.scene, &error))?;
        (run, bounced.history.into_inner(), bounced.approaches.into_inner())
    };
    let slopes = |k: usize, t: f64, y: &[Tangent<K>]| -> Vec<f64> {
        let is_over = history.endings[k].as_ref().is_some_and(|ending| t >= ending.t);
        y.iter().map(|y| if is_over { f64::NAN } else { y.slopes[k] }).collect()
    };
    let at = |k: usize| solution.t.iter().zip(&solution.y).map(|(t, y)| slopes(k, *t, y)).collect();
    let carried = Carried {
        at: (0..seeds.len()).map(at).collect(),
        end: (0..seeds.len()).map(|k| slopes(k, solution.t_end, &solution.y_end)).collect(),
        solution: solution.rounded(),
        history,
    };
    Ok((carried, approaches))
}

/// Makes a run of a scene without contacts in numbers with `K` slopes.
///
/// # Errors
/// `Error::Request` if the accelerations are not eliminated, or the options do not fit.
fn smooth<const K: usize>(
    problem: &Problem<'_>,
    (flow, series): Parts<'_, K>,
    p: &[Tangent<K>],
    start: InitialState<'_, Tangent<K>>,
    options: &Options,
    events: &mut [Event<'_>],
) -> Result<Solution<Tangent<K>>, Error> {
    let rhs = Tangents::new(problem.system(), flow, series, p);
    let mut rhs = rhs.ok_or_else(|| Error::request("accelerations are not eliminated", "take other equations"))?;
    let mut power = accounted(problem)?;
    let mut doubles = Vec::new();
    let mut of_values = |t: f64, y: &[Tangent<K>]| {
        doubles.clear();
        doubles.extend(y.iter().map(|y| y.value));
        power.as_mut().map_or(0.0, |power| power(t, &doubles))
    };
    let has_power = problem.system().has_power();
    let mut with = Accompanied {
        rhs: &mut rhs,
        power: if has_power { Some(&mut of_values) } else { None },
        over: None,
        yields: None,
    };
    let lent = Lent(&mut with as &mut dyn RightHandSide<Tangent<K>>);
    integrate(lent, start.span, start.y, options, events).map_err(|error| refused(problem.scene, &error))
}
