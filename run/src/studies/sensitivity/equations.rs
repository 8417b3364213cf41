//! Equations in numbers with slopes: compiled ones, or interpreted ones whose tapes compute with slopes.

use super::bounce::{Bounced, Parts};
use super::contacts::Wide;
use super::corners::corners;
use super::graze::{self, near};
use super::start::Seed;
use super::way::Way;
use crate::code::{Code, Ready, code, code_of, derivation};
use crate::error::{Error, refused};
use crate::interpreted::Interpreted;
use crate::mechanism::Mechanism;
use crate::preparation::impacts::Approach;
use crate::preparation::problem::Problem;
use crate::trust::power::accounted;
use std::cell::OnceCell;
use tripos_derive::mechanics::{EquationsOrigin, in_distance};
use tripos_derive::scene::Scene;
use tripos_sim::{Accompanied, Event, Lent, Options, Output, RightHandSide, Solution, Tangents, integrate};
use tripos_traits::{CompiledSystem, Derivative, InTangents, Method, Tangent};

/// Equations of motion that compute rates with slopes.
pub struct Equations {
    /// Equations of motion in doubles.
    pub code: Code,
    /// Interpreted equations in numbers with one slope, made on first use.
    one: OnceCell<Derivative<Interpreted<Tangent<1>>>>,
    /// Interpreted equations in numbers with four slopes, made on first use.
    four: OnceCell<Derivative<Interpreted<Tangent<4>>>>,
}

impl Equations {
    /// Prepares the equations of a mechanism for a method. Compiled equations are used only if they are also compiled
    /// with slopes.
    ///
    /// # Errors
    /// Errors of [`code`].
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

    /// True if Taylor coefficients can be computed with slopes.
    pub fn has_series(&self) -> bool {
        compiled(&self.code).is_none() && self.code.system().has_taylor()
    }

    /// Functions that compute rates with one slope.
    pub fn one(&self) -> Parts<'_, 1> {
        match (&self.code, compiled(&self.code)) {
            (Code::Interpreted(system), _) => parts(self.one.get_or_init(|| Derivative(system.double.to()))),
            (_, Some(tangents)) => (tangents.one, None),
            _ => unreachable!("equations that are compiled without slopes are interpreted"),
        }
    }

    /// Functions that compute rates with four slopes.
    fn four(&self) -> Parts<'_, 4> {
        match (&self.code, compiled(&self.code)) {
            (Code::Interpreted(system), _) => parts(self.four.get_or_init(|| Derivative(system.double.to()))),
            (_, Some(tangents)) => (tangents.four, None),
            _ => unreachable!("equations that are compiled without slopes are interpreted"),
        }
    }

    /// Makes a run with its derivatives by each of the seeds, from a state with slopes along each seed.
    ///
    /// The results are the derivatives of the run itself, along the steps that it takes. One run carries four slopes.
    /// If there are more seeds, the same run is made again for each further four.
    ///
    /// # Errors
    /// [`Error::Request`] if the run cannot begin, or there is no seed.
    pub fn run(
        &self,
        problem: &Problem<'_>,
        (from, seeds): (&From<'_>, &[Seed]),
        options: &Options,
        events: &mut [Event<'_>],
    ) -> Result<Carried, Error> {
        let mut carried: Option<Carried> = None;
        for first in (0..seeds.len()).step_by(4) {
            let part = first..seeds.len().min(first + 4);
            let more = match part.len() {
                1 => watched(problem, self.one(), (from, part.start, &seeds[part]), options, events)?,
                _ => watched(problem, self.four(), (from, part.start, &seeds[part]), options, events)?,
            };
            match &mut carried {
                None => carried = Some(more),
                Some(known) => {
                    known.at.extend(more.at);
                    known.end.extend(more.end);
                    known.way.extend(more.way);
                }
            }
        }
        carried.ok_or_else(|| Error::request("there is nothing to differentiate by", "name a parameter"))
    }
}

/// Start of a run with slopes: an instant, a state, and the slopes of the state by each seed.
pub struct From<'a> {
    /// First and last instant, s.
    pub span: (f64, f64),
    /// Integrated state at the first instant.
    pub y: &'a [f64],
    /// Slopes of the state `y`, a list for each seed.
    pub slopes: &'a [Vec<f64>],
}

/// A run with the slopes of its integrated states by each seed.
pub struct Carried {
    /// Solution of the run in plain doubles.
    pub solution: Solution,
    /// Slopes of the integrated state: by each seed, at each sample, of each component.
    pub at: Vec<Vec<Vec<f64>>>,
    /// Slopes of the integrated state at the end of the run: by each seed, of each component.
    pub end: Vec<Vec<f64>>,
    /// Changes of contacts during the run, and ends of derivatives.
    pub way: Way,
}

/// Functions of interpreted equations that compute rates and Taylor coefficients with slopes.
fn parts<const K: usize>(system: &Derivative<Interpreted<Tangent<K>>>) -> Parts<'_, K> {
    (system, Some(system))
}

/// Functions of compiled equations that compute with slopes; `None` if these are not compiled.
fn compiled(code: &Code) -> Option<InTangents<'static>> {
    match code {
        Code::Compiled(CompiledSystem { lanes: Some(lanes), .. }) => lanes.tangents,
        _ => None,
    }
}

/// Makes one run in numbers with `K` slopes. Derivatives end at an instant at which a contact is only touched.
fn watched<const K: usize>(
    problem: &Problem<'_>,
    parts: Parts<'_, K>,
    from: (&From<'_>, usize, &[Seed]),
    options: &Options,
    events: &mut [Event<'_>],
) -> Result<Carried, Error> {
    let (mut carried, approaches) = carry(problem, parts, from, (options, true), events)?;
    for approach in &approaches {
        end_at(problem, parts, &mut carried, (approach, from.2), options)?;
    }
    Ok(carried)
}

/// Ends the derivatives by numbers that change a gap at its minimum of zero.
fn end_at<const K: usize>(
    problem: &Problem<'_>,
    parts: Parts<'_, K>,
    carried: &mut Carried,
    (approach, seeds): (&Approach, &[Seed]),
    options: &Options,
) -> Result<(), Error> {
    let Approach { contact, t, y } = approach;
    let solution = &carried.solution;
    let Some(sample) = solution.t.iter().rposition(|sample| sample <= t) else { return Ok(()) };
    let mut slopes: Vec<Vec<f64>> = carried.at.iter().map(|list| list[sample].clone()).collect();
    if solution.t[sample] < *t {
        let from = From { span: (solution.t[sample], *t), y: &solution.y[sample], slopes: &slopes };
        let short = Options { output: Output::Ends, ..options.clone() };
        slopes = carry(problem, parts, (&from, 0, seeds), (&short, false), &mut [])?.0.end;
    }
    let contacts = problem.contacts();
    let wide = Wide::new(&contacts, problem.code.extended(), near(options));
    for (k, (seed, slopes)) in seeds.iter().zip(&slopes).enumerate() {
        if let Err(why) = graze::check(&wide, (*contact, y), &seed.varied(), slopes) {
            carried.over(k, *t, why);
        }
    }
    Ok(())
}

impl Carried {
    /// Ends the derivatives by a number at the instant `t`, s: later slopes become NaN.
    fn over(&mut self, number: usize, t: f64, why: String) {
        self.way.end(number, t, why);
        let later = self.solution.t.iter().zip(&mut self.at[number]).filter(|(sample, _)| **sample >= t);
        let later = later.map(|(_, slopes)| slopes);
        later.chain([&mut self.end[number]]).for_each(|slopes| slopes.fill(f64::NAN));
    }
}

/// Makes one run in numbers with `K` slopes, by `seeds`. Also lists the minima of gaps that are nearly zero, if
/// `is_watched` is true.
fn carry<const K: usize>(
    problem: &Problem<'_>,
    parts: Parts<'_, K>,
    (from, first, seeds): (&From<'_>, usize, &[Seed]),
    (options, is_watched): (&Options, bool),
    events: &mut [Event<'_>],
) -> Result<(Carried, Vec<Approach>), Error> {
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
    let y0: Vec<Tangent<K>> = values.map(|(at, y)| tangent(*y, &|k| from.slopes[first + k][at])).collect();
    let options = Options { corners: corners(problem, &p), ..problem.options(options) };
    let (solution, way, approaches) = if problem.scene.impacts.is_empty() {
        (smooth(problem, parts, &p, (from.span, &y0), &options, events)?, Way::new(seeds.len()), Vec::new())
    } else {
        let (contacts, near) = (problem.contacts(), (near(&options), is_watched));
        let bounced = Bounced::new(problem, parts, (&p, seeds), (&contacts, &options.corners), near);
        let run = problem.bounce(&contacts, &bounced, (from.span, &y0), &options, events, accounted(problem)?);
        let run = run.map_err(|error| refused(problem.scene, &error))?;
        (run, bounced.way.into_inner(), bounced.approaches.into_inner())
    };
    let slopes = |k: usize, t: f64, y: &[Tangent<K>]| -> Vec<f64> {
        let is_over = way.endings[k].as_ref().is_some_and(|ending| t >= ending.t);
        y.iter().map(|y| if is_over { f64::NAN } else { y.slopes[k] }).collect()
    };
    let at = |k: usize| solution.t.iter().zip(&solution.y).map(|(t, y)| slopes(k, *t, y)).collect();
    let carried = Carried {
        at: (0..seeds.len()).map(at).collect(),
        end: (0..seeds.len()).map(|k| slopes(k, solution.t_end, &solution.y_end)).collect(),
        solution: solution.rounded(),
        way,
    };
    Ok((carried, approaches))
}

/// Makes a run of a scene without contacts, in numbers with `K` slopes.
fn smooth<const K: usize>(
    problem: &Problem<'_>,
    (flow, series): Parts<'_, K>,
    p: &[Tangent<K>],
    (span, y0): ((f64, f64), &[Tangent<K>]),
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
    integrate(lent, span, y0, options, events).map_err(|error| refused(problem.scene, &error))
}
