//! Equations of motion in numbers that carry derivatives ("slopes"), compiled or interpreted.

use super::contacts::contact_history::ContactHistory;
use super::contacts::grazing_contacts;
use super::contacts::grazing_contacts::grazing_gap_limit;
use super::contacts::precise_contacts::PreciseContacts;
use super::corners::corners;
use super::slope_carrier::{SlopeCarrier, SlopeFunctions};
use super::varied_start::VariedStart;
use crate::code::{Code, CodePreparation, derive_or_read_equations, interpreted_code, runnable_code};
use crate::error::{Error, refused_scene_error};
use crate::interpreted_equations::InterpretedEquations;
use crate::mechanism::Mechanism;
use crate::preparation::impacts::GapMinimum;
use crate::preparation::initial_state::InitialState;
use crate::preparation::problem::Problem;
use crate::trust::load_power::accumulated_load_power;
use std::cell::OnceCell;
use tripos_derive::mechanics::{EquationsOrigin, equations_in_distance};
use tripos_derive::scene::Scene;
use tripos_sim::{
    AccompaniedRightHandSide, DynamicsWithTangents, Event, LentRightHandSide, Options, OutputOption, RightHandSide,
    Solution, integrate,
};
use tripos_traits::{CompiledSystem, Derivative, InTangents, Method, Tangent};

/// Equations of motion that compute the rates of the state together with their derivatives ("slopes") by
/// varied numbers.
pub struct SlopeEquations {
    /// Equations of motion in double precision.
    pub code: Code,
    /// Interpreted equations in numbers with one slope; empty until they are first used.
    one: OnceCell<Derivative<InterpretedEquations<Tangent<1>>>>,
    /// Interpreted equations in numbers with four slopes; empty until they are first used.
    four: OnceCell<Derivative<InterpretedEquations<Tangent<4>>>>,
}

impl SlopeEquations {
    /// Prepares the equations of a mechanism for an integrator. Compiled equations are used only if they
    /// were also compiled with slopes, and if the integrator needs no Taylor series. Otherwise the
    /// equations are interpreted.
    ///
    /// # Errors
    /// `Error` if the model cannot be derived, or the equations cannot be interpreted.
    pub fn new(mechanism: &Mechanism, scene: &Scene, by: &EquationsOrigin, method: Method) -> Result<Self, Error> {
        let distance = scene.integration.distance;
        let mut code = runnable_code(mechanism, by, distance, CodePreparation::Solved)?;
        let has_all = compiled_slope_functions(&code).is_some() && !method.needs_series();
        if code.is_compiled() && !has_all {
            let derived = derive_or_read_equations(mechanism, by)?;
            let derived = match distance {
                Some(distance) => equations_in_distance(mechanism, derived, distance),
                None => derived,
            };
            code = interpreted_code(mechanism, by, &derived, CodePreparation::Solved)?;
        }
        Ok(Self { code, one: OnceCell::new(), four: OnceCell::new() })
    }

    /// True if the equations can compute Taylor coefficients with slopes. Only interpreted equations can.
    pub fn has_series(&self) -> bool {
        compiled_slope_functions(&self.code).is_none() && self.code.system().has_taylor()
    }

    /// Functions that compute the rates with their slopes by one varied number.
    pub fn rates_with_one_slope(&self) -> SlopeFunctions<'_, 1> {
        match (&self.code, compiled_slope_functions(&self.code)) {
            (Code::Interpreted(system), _) => {
                interpreted_slope_functions(self.one.get_or_init(|| Derivative(system.double.convert_to())))
            }
            (_, Some(tangents)) => (tangents.one, None),
            _ => unreachable!("equations that are compiled without slopes are interpreted"),
        }
    }

    /// Functions that compute the rates with their slopes by four varied numbers.
    fn rates_with_four_slopes(&self) -> SlopeFunctions<'_, 4> {
        match (&self.code, compiled_slope_functions(&self.code)) {
            (Code::Interpreted(system), _) => {
                interpreted_slope_functions(self.four.get_or_init(|| Derivative(system.double.convert_to())))
            }
            (_, Some(tangents)) => (tangents.four, None),
            _ => unreachable!("equations that are compiled without slopes are interpreted"),
        }
    }

    /// Makes a run together with its derivatives by each varied number of its start.
    ///
    /// The results are the exact derivatives of the computed steps. A run carries at most four slopes.
    /// With more varied numbers, the run is repeated for every further four.
    ///
    /// # Errors
    /// [`Error::Request`] if the run cannot begin, or there is no varied number.
    pub fn run(
        &self,
        problem: &Problem<'_>,
        from: &SeededStart<'_>,
        options: &Options,
        events: &mut [Event<'_>],
    ) -> Result<RunWithSlopes, Error> {
        let mut carried: Option<RunWithSlopes> = None;
        for (seeds, slopes) in from.seeds.chunks(4).zip(from.slopes.chunks(4)) {
            let part = SeededStart { seeds, slopes, ..*from };
            let more = match seeds.len() {
                1 => run_slopes_with_touch_checks(problem, self.rates_with_one_slope(), &part, options, events)?,
                _ => run_slopes_with_touch_checks(problem, self.rates_with_four_slopes(), &part, options, events)?,
            };
            match &mut carried {
                None => carried = Some(more),
                Some(known) => {
                    known.at.extend(more.at);
                    known.end.extend(more.end);
                    known.history.extend_history(more.history);
                }
            }
        }
        carried.ok_or_else(|| Error::request("there is nothing to differentiate by", "name a parameter"))
    }
}

/// Start of a run with derivatives: its span, its state, and the derivatives ("slopes") of the state by
/// each varied number.
#[derive(Clone, Copy)]
pub struct SeededStart<'a> {
    /// First and last instant of the run, s.
    pub span: (f64, f64),
    /// Integrated state (q, v) at the first instant.
    pub y: &'a [f64],
    /// Varied numbers by which derivatives are taken.
    pub seeds: &'a [VariedStart],
    /// Slopes of the state `y` at the first instant, a list for each varied number.
    pub slopes: &'a [Vec<f64>],
}

/// Run with the derivatives ("slopes") of its integrated states by each varied number.
pub struct RunWithSlopes {
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
fn interpreted_slope_functions<const K: usize>(
    system: &Derivative<InterpretedEquations<Tangent<K>>>,
) -> SlopeFunctions<'_, K> {
    (system, Some(system))
}

/// Functions of compiled equations that compute rates with slopes. `None` if the equations are
/// interpreted, or were compiled without slopes.
fn compiled_slope_functions(code: &Code) -> Option<InTangents<'static>> {
    match code {
        Code::Compiled(CompiledSystem { lanes: Some(lanes), .. }) => lanes.tangents,
        _ => None,
    }
}

/// Makes a run in numbers with `K` slopes. If a gap only touches zero and a varied number changes this
/// gap, the derivatives by this number end there.
///
/// # Errors
/// `Error::Request` if the run cannot begin.
fn run_slopes_with_touch_checks<const K: usize>(
    problem: &Problem<'_>,
    parts: SlopeFunctions<'_, K>,
    from: &SeededStart<'_>,
    options: &Options,
    events: &mut [Event<'_>],
) -> Result<RunWithSlopes, Error> {
    let (mut carried, approaches) = run_with_slopes(problem, parts, from, options, TouchTreatment::Listed, events)?;
    for approach in &approaches {
        stop_slopes_at_touch(problem, parts, &mut carried, approach, from.seeds, options)?;
    }
    Ok(carried)
}

/// Ends the derivatives by the varied numbers that change a gap at its minimum of zero.
///
/// # Errors
/// `Error` if the state at the minimum cannot be computed.
fn stop_slopes_at_touch<const K: usize>(
    problem: &Problem<'_>,
    parts: SlopeFunctions<'_, K>,
    carried: &mut RunWithSlopes,
    approach: &GapMinimum,
    seeds: &[VariedStart],
    options: &Options,
) -> Result<(), Error> {
    let GapMinimum { contact, t, y } = approach;
    let solution = &carried.solution;
    let Some(sample) = solution.t.iter().rposition(|sample| sample <= t) else { return Ok(()) };
    let mut slopes: Vec<Vec<f64>> = carried.at.iter().map(|list| list[sample].clone()).collect();
    if solution.t[sample] < *t {
        let from = SeededStart { span: (solution.t[sample], *t), y: &solution.y[sample], seeds, slopes: &slopes };
        let short = Options { output: OutputOption::Ends, ..options.clone() };
        slopes = run_with_slopes(problem, parts, &from, &short, TouchTreatment::Ignored, &mut [])?.0.end;
    }
    let contacts = problem.contacts();
    let wide = PreciseContacts::new(&contacts, problem.code.extended(), grazing_gap_limit(options));
    for (k, (seed, slopes)) in seeds.iter().zip(&slopes).enumerate() {
        if let Err(why) = grazing_contacts::check_grazing_gap(&wide, *contact, y, &seed.as_varied_number(), slopes) {
            carried.stop_slopes(k, *t, why);
        }
    }
    Ok(())
}

impl RunWithSlopes {
    /// Ends the derivatives by the varied number with index `number` at the instant `t`, s. Later
    /// slopes become NaN.
    fn stop_slopes(&mut self, number: usize, t: f64, why: String) {
        self.history.end(number, t, why);
        let later = self.solution.t.iter().zip(&mut self.at[number]).filter(|(sample, _)| **sample >= t);
        let later = later.map(|(_, slopes)| slopes);
        later.chain([&mut self.end[number]]).for_each(|slopes| slopes.fill(f64::NAN));
    }
}

/// Choice if gaps with a minimum of nearly zero are listed or ignored.
#[derive(Clone, Copy, PartialEq, Eq)]
enum TouchTreatment {
    /// The minima of gaps that are nearly zero are listed.
    Listed,
    /// Minima of gaps are not searched for.
    Ignored,
}

/// Makes a run in numbers with `K` slopes, by at most `K` varied numbers. Also returns the list of the
/// gap minima that are nearly zero. It is empty if `touches` ignores them.
///
/// # Errors
/// `Error::Request` if the run cannot begin.
fn run_with_slopes<const K: usize>(
    problem: &Problem<'_>,
    parts: SlopeFunctions<'_, K>,
    from: &SeededStart<'_>,
    options: &Options,
    touches: TouchTreatment,
    events: &mut [Event<'_>],
) -> Result<(RunWithSlopes, Vec<GapMinimum>), Error> {
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
    let options = Options { corners: corners(problem, &p), ..problem.run_options(options) };
    let start = InitialState { span, y: &y0 };
    let (solution, history, approaches) = if problem.scene.impacts.is_empty() {
        (
            run_without_contacts(problem, parts, &p, start, &options, events)?,
            ContactHistory::new(seeds.len()),
            Vec::new(),
        )
    } else {
        let (contacts, near) = (problem.contacts(), grazing_gap_limit(&options));
        let mut bounced = SlopeCarrier::new(problem, parts, &p, seeds, &contacts, near);
        bounced.corners = &options.corners;
        bounced.near = (touches == TouchTreatment::Listed).then_some(near);
        let run = problem.run_with_contacts_in(
            &contacts,
            &bounced,
            start,
            &options,
            events,
            accumulated_load_power(problem)?,
        );
        let run = run.map_err(|error| refused_scene_error(problem.scene, &error))?;
        (run, bounced.history.into_inner(), bounced.approaches.into_inner())
    };
    let slopes = |k: usize, t: f64, y: &[Tangent<K>]| -> Vec<f64> {
        let is_over = history.endings[k].as_ref().is_some_and(|ending| t >= ending.t);
        y.iter().map(|y| if is_over { f64::NAN } else { y.slopes[k] }).collect()
    };
    let at = |k: usize| solution.t.iter().zip(&solution.y).map(|(t, y)| slopes(k, *t, y)).collect();
    let carried = RunWithSlopes {
        at: (0..seeds.len()).map(at).collect(),
        end: (0..seeds.len()).map(|k| slopes(k, solution.t_end, &solution.y_end)).collect(),
        solution: solution.solution_in_doubles(),
        history,
    };
    Ok((carried, approaches))
}

/// Makes a run of a scene without contacts in numbers with `K` slopes.
///
/// # Errors
/// `Error::Request` if the accelerations are not eliminated, or if the options do not fit the equations.
fn run_without_contacts<const K: usize>(
    problem: &Problem<'_>,
    (flow, series): SlopeFunctions<'_, K>,
    p: &[Tangent<K>],
    start: InitialState<'_, Tangent<K>>,
    options: &Options,
    events: &mut [Event<'_>],
) -> Result<Solution<Tangent<K>>, Error> {
    let rhs = DynamicsWithTangents::new(problem.system(), flow, series, p);
    let mut rhs = rhs.ok_or_else(|| Error::request("accelerations are not eliminated", "take other equations"))?;
    let mut power = accumulated_load_power(problem)?;
    let mut doubles = Vec::new();
    let mut of_values = |t: f64, y: &[Tangent<K>]| {
        doubles.clear();
        doubles.extend(y.iter().map(|y| y.value));
        power.as_mut().map_or(0.0, |power| power(t, &doubles))
    };
    let has_power = problem.system().has_power();
    let mut with = AccompaniedRightHandSide {
        rhs: &mut rhs,
        power: if has_power { Some(&mut of_values) } else { None },
        over: None,
        yields: None,
    };
    let lent = LentRightHandSide(&mut with as &mut dyn RightHandSide<Tangent<K>>);
    integrate(lent, start.span, start.y, options, events).map_err(|error| refused_scene_error(problem.scene, &error))
}
