//! Equations that a view runs in the browser, and the values that its sliders change.
//!
//! Invariant: all mechanics in the page is planned here from the model, and texts reach the page as data. Scenes are
//! excluded if they have impacts, or drives with kinks or jumps in time, at which steps would have to end.

use super::{ViewContent, ViewPlace};
use crate::terminal::failure::Failure;
use serde_json::{Value, json};
use tripos::EquationsName;
use tripos::code::derive_or_read_equations;
use tripos::equations_name::find_equations_or_first;
use tripos::pictures::view::{FrameTree, stated_solid_lengths};
use tripos_codegen::js::{JavaScriptModule, WrittenEquations};
use tripos_codegen::plan::{Arguments, Function, MotionPlan, Planner, Returns, WatchedQuantity};
use tripos_derive::Formulation;
use tripos_derive::algebra::Expr;
use tripos_derive::mechanics::EquationsOrigin;
use tripos_traits::{AbsoluteTolerance, Direction};

/// Tolerance of a run in the page, relative and absolute.
const TOLERANCE: f64 = 1e-10;
/// Decision whether a view runs equations in the browser.
pub enum LiveEquations {
    /// The view runs the motion in the browser by these equations.
    Runs(RunnableEquations),
    /// The view runs no equations. The text is the reason.
    Rests(String),
}

/// Equations and data with which a view runs a motion in the browser.
pub struct RunnableEquations {
    /// Equations as a JavaScript expression for an object of functions.
    pub equations: String,
    /// Data of the run as JSON: start, settings and sliders.
    pub data: Value,
    /// Title of the equations, such as the name of a formulation.
    pub title: String,
}

impl RunnableEquations {
    /// Returns the data for a viewer that shows these points and frames, which are indices in the model.
    pub fn shown(&self, points: &[usize], frames: &[usize]) -> Value {
        let mut data = self.data.clone();
        // Index of the equations in the page's list, which has only one set.
        data["equations"] = json!(0);
        data["points"] = json!(points);
        data["frames"] = json!(frames);
        data
    }
}

/// Returns the reason, in words, why the page cannot run the scene; `None` if it can.
fn reason_for_no_live_equations(seen: &ViewContent<'_>) -> Option<&'static str> {
    let (mechanism, scene) = (seen.mechanism, seen.scene);
    if mechanism.speeds.is_empty() {
        Some("the constraints leave it no speed")
    } else if !scene.impacts.is_empty() {
        Some("bodies meet in it, and impacts are computed by the command alone")
    } else if !mechanism.corner_instants(&scene.parameters).is_empty() {
        Some("what drives it bends or jumps in time, where steps have to end")
    } else {
        None
    }
}

impl LiveEquations {
    /// Plans the equations of a view's first motion for the browser. If their code is too long, the
    /// view runs none.
    ///
    /// # Errors
    /// [`Failure`] if the equations named by `by` cannot be derived.
    pub fn of(seen: &ViewContent<'_>, by: Option<&EquationsName>, home: ViewPlace) -> Result<Self, Failure> {
        if let Some(why) = reason_for_no_live_equations(seen) {
            return Ok(Self::Rests(why.to_owned()));
        }
        let mechanism = seen.mechanism;
        let by = find_equations_or_first(mechanism, by)?;
        let derived = derive_or_read_equations(mechanism, &by)?;
        let written = match by.formulation() {
            Some(_) => WrittenEquations::solve_for_accelerations(derived)
                .map_err(|why| tripos::Error::Input(mechanism.diagnose(&why)))?,
            None => WrittenEquations::keep_linear_system(derived),
        };
        let stops = StopConditions::of(seen);
        let balance =
            WrittenEquations::reaction_equations(mechanism, stops.watched.iter().map(|watched| watched.value))
                .map_err(tripos::Error::Input)?;
        let (own, balance) = (written.planner(mechanism), balance.as_ref().map(|balance| balance.planner(mechanism)));
        let plan = MotionPlan::new(&own, written.solved.as_ref(), &stops.watched, balance.as_ref());
        let beside = [places(&own), sizes(&own, seen)];
        let names: Vec<String> = stops.watched.iter().map(|watched| watched.name.clone()).collect();
        let module = |own: &Planner<'_>, plan: &MotionPlan, beside: &[Function]| {
            JavaScriptModule { planner: own, plan, watched: &names, beside, origin: "" }.javascript_module_object()
        };
        let mut equations = module(&own, &plan, &beside);
        if equations.len() > home.equations() {
            return Ok(Self::Rests("its equations are too long for a page".to_owned()));
        }
        let title = by.title();
        let mut data = live_equations_data(seen, &plan, &stops, &title);
        // If the independent speeds become singular during a run, the equations in all rates can continue the motion.
        if !mechanism.loops.is_empty() && written.solved.is_some() {
            let lagrange = EquationsOrigin::from(Formulation::Lagrange);
            let general = WrittenEquations::keep_linear_system(derive_or_read_equations(mechanism, &lagrange)?);
            let own = general.planner(mechanism);
            let plan = MotionPlan::new(&own, None, &stops.watched, balance.as_ref());
            let general = module(&own, &plan, &[]);
            if equations.len() + general.len() <= home.equations() {
                equations = format!("((own) => ({{ ...own, general: {{ ...own, ...{general} }} }}))({equations})");
                data["general"] = json!(format!("{}, with multipliers", lagrange.title()));
            }
        }
        Ok(Self::Runs(RunnableEquations { equations, data, title }))
    }
}

/// Conditions that end a run in the page: the domain of the model, and terminal events.
struct StopConditions {
    /// Watched quantities, one for each condition.
    watched: Vec<WatchedQuantity>,
    /// Direction, for each condition, of the sign change that ends a run: −1 falling, 1 rising, 0 either.
    directions: Vec<i8>,
    /// True, for each condition, if it must hold at the start, as the conditions of the domain must.
    holds: Vec<bool>,
}

impl StopConditions {
    /// Collects the conditions of the mechanism's domain and of the scene's terminal events.
    fn of(seen: &ViewContent<'_>) -> Self {
        let (mut watched, mut directions, mut holds) = (Vec::new(), Vec::new(), Vec::new());
        let mut put = |name: String, value: Expr, direction: Direction, must_hold: bool| {
            watched.push(WatchedQuantity { name, value });
            directions.push(match direction {
                Direction::Falling => -1,
                Direction::Rising => 1,
                Direction::Either => 0,
            });
            holds.push(must_hold);
        };
        if seen.scene.integration.domain_stops {
            for condition in &seen.mechanism.domain {
                put(format!("{} ({})", condition.name, condition.text), condition.positive, Direction::Falling, true);
            }
        }
        for event in seen.scene.events.iter().filter(|event| event.terminal) {
            put(event.name.clone(), event.function, event.direction, false);
        }
        Self { watched, directions, holds }
    }
}

/// Plans the JavaScript function `places`. It computes the rotations and positions of the links, from which poses are
/// assembled.
fn places(planner: &Planner<'_>) -> Function {
    let values = numbered_values("place", FrameTree::of(planner.model).values);
    planner.plan_function(
        "places",
        "The turns and places of links.",
        Arguments::Configuration,
        Returns::Vector,
        &values,
    )
}

/// Plans the JavaScript function `sizes`. It computes the dimensions of the shapes in the model file, m, one solid
/// after another.
fn sizes(planner: &Planner<'_>, seen: &ViewContent<'_>) -> Function {
    let values =
        numbered_values("size", stated_solid_lengths(seen.mechanism).into_iter().flatten().map(|(_, e)| e).collect());
    planner.plan_function("sizes", "The sizes of shapes.", Arguments::Configuration, Returns::Vector, &values)
}

/// Returns values to be computed, whose variables are named `stem` with the numbers 0, 1 and so on.
fn numbered_values(stem: &str, values: Vec<Expr>) -> Vec<(String, String, Expr)> {
    values.into_iter().enumerate().map(|(at, e)| (format!("{stem}_{at}"), format!("{stem} {at}"), e)).collect()
}

/// Returns the data of the run in the page as JSON: start, tolerances, conditions, links and
/// sliders.
fn live_equations_data(seen: &ViewContent<'_>, plan: &MotionPlan, stops: &StopConditions, title: &str) -> Value {
    let (mechanism, scene) = (seen.mechanism, seen.scene);
    let links = FrameTree::of(mechanism);
    let at = |list: &[i8]| plan.conditions.iter().map(|place| list[*place]).collect::<Vec<_>>();
    let least = match &scene.integration.atol {
        AbsoluteTolerance::Uniform(atol) => *atol,
        AbsoluteTolerance::Each(list) => list.iter().copied().fold(f64::INFINITY, f64::min),
    };
    let keys = stated_solid_lengths(mechanism)
        .into_iter()
        .map(|list| list.into_iter().map(|(key, _)| key).collect::<Vec<_>>());
    json!({
        "title": title,
        "p": scene.parameters, "q": scene.q, "u": scene.u,
        "span": [scene.span.0, scene.span.1],
        // Tolerances are at most those of the scene, but above zero, because the error of a step cannot be 0.
        "rtol": TOLERANCE.min(scene.integration.rtol).max(1e-13),
        "atol": TOLERANCE.min(least).max(1e-30),
        "directions": at(&stops.directions),
        "holds": plan.conditions.iter().map(|place| stops.holds[*place]).collect::<Vec<_>>(),
        "conditions": plan.conditions.len(),
        "unwatched": plan.unwatched.iter().map(|place| &stops.watched[*place].name).collect::<Vec<_>>(),
        "conserves": !plan.has_power && !mechanism.is_driven(),
        "links": { "frames": links.frames, "points": links.points },
        "sizes": if seen.view.is_stated { keys.collect::<Vec<_>>() } else { Vec::new() },
        // Point of contact and middle point of each solid that touches another. Its radius follows from the distance of
        // the two.
        "touches": seen.view.solids.iter().map(|solid| Some([solid.touches?, *solid.form.points().first()?])).collect::<Vec<_>>(),
        "parameters": parameters(seen),
        "start": live_start_sliders(seen),
        // Indices of the coordinates that close the loops, if the scene leaves coordinates to be solved for.
        "closing": live_loop_coordinates(seen),
    })
}

/// Returns the JSON of a slider. `at` is the index of the value that the slider changes; `range` is its smallest and
/// largest value.
fn slider(name: &str, about: &str, unit: &str, at: usize, value: f64, range: (f64, f64)) -> Value {
    let (from, to) = range;
    json!({ "name": name, "about": about, "unit": unit, "at": at, "value": value, "from": from, "to": to })
}

/// Returns the sliders of the parameters. A positive parameter remains positive; other parameters
/// can become zero.
fn parameters(seen: &ViewContent<'_>) -> Vec<Value> {
    let values = seen.mechanism.parameters.iter().zip(&seen.scene.parameters).enumerate();
    let of = |(at, (p, value)): (usize, (&tripos_derive::model::Parameter, &f64))| {
        let range = if p.positive {
            (0.2 * value, 3.0 * value)
        } else if *value == 0.0 {
            (-1.0, 1.0)
        } else {
            (0.0_f64.min(3.0 * value), 0.0_f64.max(3.0 * value))
        };
        slider(&p.name, &p.about, &unit(&p.unit), at, *value, range)
    };
    values.map(of).collect()
}

/// Returns the indices of the coordinates that the closed loops of the scene determine.
fn live_loop_coordinates(seen: &ViewContent<'_>) -> Vec<usize> {
    let is_closed = |name: &str| seen.scene.closed.iter().any(|closed| closed.name == name);
    let coordinates = seen.mechanism.coordinates.iter().enumerate();
    coordinates.filter(|(_, c)| is_closed(&c.name)).map(|(at, _)| at).collect()
}

/// Returns the sliders of the start: coordinates except time and dependent coordinates, then
/// generalized speeds. An angle can change by π rad, other values by their range in the motion.
fn live_start_sliders(seen: &ViewContent<'_>) -> Vec<Value> {
    let (mechanism, scene) = (seen.mechanism, seen.scene);
    let ranges = seen.motions.first().map_or(&[][..], |motion| &motion.ranges);
    let reach = |at: usize, value: f64| {
        let spread = ranges.get(at).map_or(0.0, |(least, most)| (most - value).max(value - least));
        Some(spread.max(value.abs())).filter(|reach| *reach > 0.0 && reach.is_finite()).unwrap_or(1.0)
    };
    let n = mechanism.coordinates.len();
    let (time, closing) = (mechanism.time(), live_loop_coordinates(seen));
    let is_free = |at: usize| Some(at) != time && !closing.contains(&at);
    let coordinates = mechanism.coordinates.iter().enumerate().filter(|(at, _)| is_free(*at)).map(|(at, c)| {
        let value = scene.q[at];
        let reach = if c.unit.is_plain() { std::f64::consts::PI } else { reach(at, value) };
        slider(&c.name, &c.about, &unit_of_motion(seen, c.symbol), at, value, (value - reach, value + reach))
    });
    let speeds = mechanism.speeds.iter().enumerate().map(|(at, s)| {
        let (value, reach) = (scene.u[at], reach(n + at, scene.u[at]));
        slider(&s.name, "", &unit_of_motion(seen, s.symbol), n + at, value, (value - reach, value + reach))
    });
    coordinates.chain(speeds).collect()
}

/// Returns the unit of a coordinate or generalized speed as text, such as rad/s. Empty if it is not
/// known.
fn unit_of_motion(seen: &ViewContent<'_>, symbol: Expr) -> String {
    seen.mechanism.unit_label(&seen.mechanism.arena, symbol).unwrap_or_default()
}

/// Returns the unit of a parameter as text; empty for a plain number.
fn unit(unit: &tripos_derive::model::Unit) -> String {
    if unit.is_plain() { String::new() } else { unit.to_string() }
}
