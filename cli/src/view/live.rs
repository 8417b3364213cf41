//! Equations of a view in the page itself: the values that sliders change, and the reason if there are none.
//!
//! Invariant: all mechanics in the page is planned from the model here; texts reach the page as data. Absent on
//! purpose: impacts, and drives that bend or jump in time, at which steps would have to end.

use super::{Home, Seen};
use crate::failure::Failure;
use serde_json::{Value, json};
use tripos::EquationsName;
use tripos::code::{by_or_first, derivation};
use tripos::pictures::view::{Links, lengths};
use tripos_codegen::js::{Module, Written};
use tripos_codegen::plan::{Arguments, Function, MotionPlan, Planner, Returns, Watched};
use tripos_derive::Formulation;
use tripos_derive::algebra::Expr;
use tripos_derive::mechanics::EquationsOrigin;
use tripos_traits::{AbsoluteTolerance, Direction};

/// Largest error of a step, relative and absolute, that a run in the page is allowed.
const TOLERANCE: f64 = 1e-10;
/// Decision whether a view runs equations.
pub enum Live {
    /// The view runs these equations.
    Runs(Running),
    /// The view runs no equations, for this reason, in words.
    Rests(String),
}

/// Equations and data with which a view runs.
pub struct Running {
    /// Equations as an expression of JavaScript.
    pub equations: String,
    /// Start of the run, its settings, and its sliders, as JSON.
    pub data: Value,
    /// Title of the equations, for a heading.
    pub title: String,
}

impl Running {
    /// Data for a viewer that shows these points and frames of the mechanism.
    pub fn shown(&self, points: &[usize], frames: &[usize]) -> Value {
        let mut data = self.data.clone();
        // Index of the equations in the list of the page: the first.
        data["equations"] = json!(0);
        data["points"] = json!(points);
        data["frames"] = json!(frames);
        data
    }
}

/// Reason, in words, why the page cannot run the scene; `None` if it can.
fn missing(seen: &Seen<'_>) -> Option<&'static str> {
    let (mechanism, scene) = (seen.mechanism, seen.scene);
    if mechanism.speeds.is_empty() {
        Some("the constraints leave it no speed")
    } else if !scene.impacts.is_empty() {
        Some("bodies meet in it, and impacts are computed by the command alone")
    } else if !mechanism.corners(&scene.parameters).is_empty() {
        Some("what drives it bends or jumps in time, where steps have to end")
    } else {
        None
    }
}

impl Live {
    /// Plans the equations by which the first motion of a view was run, if their code is short enough.
    ///
    /// # Errors
    /// [`Failure`] if there are no such equations.
    pub fn of(seen: &Seen<'_>, by: Option<&EquationsName>, home: Home) -> Result<Self, Failure> {
        if let Some(why) = missing(seen) {
            return Ok(Self::Rests(why.to_owned()));
        }
        let mechanism = seen.mechanism;
        let by = by_or_first(mechanism, by)?;
        let derived = derivation(mechanism, &by)?;
        let written = match by.formulation() {
            Some(_) => Written::solved(derived).map_err(|why| tripos::Error::Input(mechanism.diagnose(&why)))?,
            None => Written::unsolved(derived),
        };
        let stops = Stops::of(seen);
        let balance = Written::balance(mechanism, stops.watched.iter().map(|watched| watched.value))
            .map_err(tripos::Error::Input)?;
        let (own, balance) = (written.planner(mechanism), balance.as_ref().map(|balance| balance.planner(mechanism)));
        let plan = MotionPlan::new(&own, written.solved.as_ref(), &stops.watched, balance.as_ref());
        let beside = [places(&own), sizes(&own, seen)];
        let names: Vec<String> = stops.watched.iter().map(|watched| watched.name.clone()).collect();
        let module = |own: &Planner<'_>, plan: &MotionPlan, beside: &[Function]| {
            Module { planner: own, plan, watched: &names, beside, origin: "" }.object()
        };
        let mut equations = module(&own, &plan, &beside);
        if equations.len() > home.equations() {
            return Ok(Self::Rests("its equations are too long for a page".to_owned()));
        }
        let title = by.title();
        let mut data = data(seen, &plan, &stops, &title);
        // If the independent speeds fail on the way, the equations in all rates may go on.
        if !mechanism.loops.is_empty() && written.solved.is_some() {
            let lagrange = EquationsOrigin::from(Formulation::Lagrange);
            let general = Written::unsolved(derivation(mechanism, &lagrange)?);
            let own = general.planner(mechanism);
            let plan = MotionPlan::new(&own, None, &stops.watched, balance.as_ref());
            let general = module(&own, &plan, &[]);
            if equations.len() + general.len() <= home.equations() {
                equations = format!("((own) => ({{ ...own, general: {{ ...own, ...{general} }} }}))({equations})");
                data["general"] = json!(format!("{}, with multipliers", lagrange.title()));
            }
        }
        Ok(Self::Runs(Running { equations, data, title }))
    }
}

/// Conditions that end a run in the page: the domain, and terminal events.
struct Stops {
    watched: Vec<Watched>,
    /// Direction in which each condition ends a run, as `run` of the page expects it: −1 falling, 1 rising, 0 either.
    directions: Vec<i8>,
    /// True for a condition that must hold at the start.
    holds: Vec<bool>,
}

impl Stops {
    fn of(seen: &Seen<'_>) -> Self {
        let (mut watched, mut directions, mut holds) = (Vec::new(), Vec::new(), Vec::new());
        let mut put = |name: String, value: Expr, direction: Direction, must_hold: bool| {
            watched.push(Watched { name, value });
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

/// Function `places` of the page: turns and places of links, from which poses follow.
fn places(planner: &Planner<'_>) -> Function {
    let values = named("place", Links::of(planner.model).values);
    planner.function("places", "The turns and places of links.", Arguments::Configuration, Returns::Vector, &values)
}

/// Function `sizes` of the page: dimensions of the shapes in the model file, one solid after the other.
fn sizes(planner: &Planner<'_>, seen: &Seen<'_>) -> Function {
    let values = named("size", lengths(seen.mechanism).into_iter().flatten().map(|(_, e)| e).collect());
    planner.function("sizes", "The sizes of shapes.", Arguments::Configuration, Returns::Vector, &values)
}

fn named(stem: &str, values: Vec<Expr>) -> Vec<(String, String, Expr)> {
    values.into_iter().enumerate().map(|(at, e)| (format!("{stem}_{at}"), format!("{stem} {at}"), e)).collect()
}

/// Data of the run in the page, and of the values that can be changed, as JSON.
fn data(seen: &Seen<'_>, plan: &MotionPlan, stops: &Stops, title: &str) -> Value {
    let (mechanism, scene) = (seen.mechanism, seen.scene);
    let links = Links::of(mechanism);
    let at = |list: &[i8]| plan.conditions.iter().map(|place| list[*place]).collect::<Vec<_>>();
    let least = match &scene.integration.atol {
        AbsoluteTolerance::Uniform(atol) => *atol,
        AbsoluteTolerance::Each(list) => list.iter().copied().fold(f64::INFINITY, f64::min),
    };
    let keys = lengths(mechanism).into_iter().map(|list| list.into_iter().map(|(key, _)| key).collect::<Vec<_>>());
    json!({
        "title": title,
        "p": scene.parameters, "q": scene.q, "u": scene.u,
        "span": [scene.span.0, scene.span.1],
        // Tolerances are at most those of the scene, but above zero: steps cannot have an error of 0.
        "rtol": TOLERANCE.min(scene.integration.rtol).max(1e-13),
        "atol": TOLERANCE.min(least).max(1e-30),
        "directions": at(&stops.directions),
        "holds": plan.conditions.iter().map(|place| stops.holds[*place]).collect::<Vec<_>>(),
        "conditions": plan.conditions.len(),
        "unwatched": plan.unwatched.iter().map(|place| &stops.watched[*place].name).collect::<Vec<_>>(),
        "conserves": !plan.has_power && !mechanism.is_driven(),
        "links": { "frames": links.frames, "points": links.points },
        "sizes": if seen.view.is_stated { keys.collect::<Vec<_>>() } else { Vec::new() },
        // Point of contact and middle point of each solid that touches: its radius follows from their distance.
        "touches": seen.view.solids.iter().map(|solid| Some([solid.touches?, *solid.form.points().first()?])).collect::<Vec<_>>(),
        "parameters": parameters(seen),
        "start": start(seen),
        // Coordinates that close the loops, if the scene leaves some to be solved for.
        "closing": closing(seen),
    })
}

/// JSON of a slider from one value to another; `at` is the index of the value that it changes.
fn slider(name: &str, about: &str, unit: &str, at: usize, value: f64, range: (f64, f64)) -> Value {
    let (from, to) = range;
    json!({ "name": name, "about": about, "unit": unit, "at": at, "value": value, "from": from, "to": to })
}

/// Sliders of the parameters. A positive parameter stays positive; other numbers may become zero.
fn parameters(seen: &Seen<'_>) -> Vec<Value> {
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

/// Indices of the coordinates that a scene's loops determine.
fn closing(seen: &Seen<'_>) -> Vec<usize> {
    let is_closed = |name: &str| seen.scene.closed.iter().any(|closed| closed.name == name);
    let coordinates = seen.mechanism.coordinates.iter().enumerate();
    coordinates.filter(|(_, c)| is_closed(&c.name)).map(|(at, _)| at).collect()
}

/// Sliders of the start: coordinates except time and dependent ones, then generalized speeds. An angle may change by
/// half a turn, other values by their range in the motion.
fn start(seen: &Seen<'_>) -> Vec<Value> {
    let (mechanism, scene) = (seen.mechanism, seen.scene);
    let ranges = seen.motions.first().map_or(&[][..], |motion| &motion.ranges);
    let reach = |at: usize, value: f64| {
        let spread = ranges.get(at).map_or(0.0, |(least, most)| (most - value).max(value - least));
        Some(spread.max(value.abs())).filter(|reach| *reach > 0.0 && reach.is_finite()).unwrap_or(1.0)
    };
    let n = mechanism.coordinates.len();
    let (time, closing) = (mechanism.time(), closing(seen));
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

/// Unit of a coordinate or a speed as text behind a number, such as rad/s.
fn unit_of_motion(seen: &Seen<'_>, symbol: Expr) -> String {
    seen.mechanism.unit_label(&seen.mechanism.arena, symbol).unwrap_or_default()
}

/// Unit of a parameter as text behind a number; empty for plain numbers.
fn unit(unit: &tripos_derive::model::Unit) -> String {
    if unit.is_plain() { String::new() } else { unit.to_string() }
}
