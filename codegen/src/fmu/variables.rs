//! Variables of a functional mock-up unit, with their value references.

use super::functions::FmuFunctions;
use crate::plan::{Entry, ModulePlan};
use rustc_hash::FxHashSet;
use tripos_derive::Model;
use tripos_derive::model::Unit;
use tripos_derive::scene::Scene;

/// Role of a variable in a functional mock-up unit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// Time, the independent variable, s.
    Time,
    /// Parameter of the model, which importing tools can change between steps.
    Parameter,
    /// Input of the model, which importing tools can set at any time.
    Input,
    /// Coordinate or generalized speed. The flag is true if the scene lists it as an output.
    State(bool),
    /// Derivative in time of the state that has this value reference.
    Derivative(usize),
    /// Output of the scene that is not a state.
    Output,
    /// Event indicator: a function whose change of sign is an event.
    Indicator,
}

/// Variable of a functional mock-up unit, as the model description lists it.
pub struct Variable {
    /// Name of the variable, different from the names of all other variables.
    pub name: String,
    /// Number by which importing tools address the variable: its place in the list, from 0.
    pub reference: usize,
    /// Kind of the variable: time, parameter, input, state, derivative, output or event indicator.
    pub role: Role,
    /// Value of the variable at the start, in `unit`; `None` for a variable that is computed.
    pub start: Option<f64>,
    /// Physical unit of the variable; `None` if it is unknown.
    pub unit: Option<Unit>,
    /// Description of the variable in words; may be empty.
    pub about: String,
    /// Value references of the states and inputs on which the variable depends. `None` if they are unknown.
    pub depends_on: Option<Vec<usize>>,
}

/// Variables of a functional mock-up unit, in the order of their value references.
pub struct Variables {
    /// Variables of the unit; the place in the list is the value reference.
    pub list: Vec<Variable>,
}

impl Variables {
    /// Lists the variables of a scene: time, parameters and inputs, states, their derivatives,
    /// outputs, event indicators.
    pub fn new(model: &Model, scene: &Scene, functions: &FmuFunctions, plan: &ModulePlan) -> Self {
        let mut names = FmuVariableNames::default();
        let mut list = Vec::new();
        let mut add = |name: &str, role, start, unit: Option<&Unit>, about: &str, depends_on| {
            let (name, reference) = (names.unique(name), list.len());
            list.push(Variable {
                name,
                reference,
                role,
                start,
                unit: unit.cloned(),
                about: about.to_owned(),
                depends_on,
            });
        };
        let second = Unit::new(0, 0, 1);
        add("time", Role::Time, None, Some(&second), "time", None);
        for (p, value) in model.parameters.iter().zip(&scene.parameters) {
            let role = if p.is_input { Role::Input } else { Role::Parameter };
            add(&p.name, role, Some(*value), Some(&p.unit), &p.about, None);
        }
        let (np, nq) = (model.parameters.len(), model.coordinates.len());
        let is_shown = |name: &str| scene.outputs.iter().any(|o| o.name == name);
        let states: Vec<(&str, &Unit, &str, f64)> = (model.coordinates.iter().zip(&scene.q))
            .map(|(c, q)| (c.name.as_str(), &c.unit, c.about.as_str(), *q))
            .chain(model.speeds.iter().zip(&scene.u).map(|(s, u)| (s.name.as_str(), &s.unit, "", *u)))
            .collect();
        let first_state = np + 1;
        for (name, unit, about, start) in &states {
            add(name, Role::State(is_shown(name)), Some(*start), Some(unit), about, None);
        }
        let inputs: Vec<usize> = (0..np).filter(|at| model.parameters[*at].is_input).collect();
        let entry = |name: &str, at: usize| plan.functions.iter().find(|f| f.name == name).map(|f| &f.entries[at]);
        let nx = states.len();
        for (row, (name, unit, ..)) in states.iter().enumerate() {
            let of_states = (0..nx).map(|at| Some((first_state + at, entry("jacobian", row * nx + at)?)));
            let of_inputs = inputs.iter().map(|at| Some((at + 1, entry("parameter_jacobian", row * np + at)?)));
            let depends_on = nonzero_dependencies(of_states.chain(of_inputs));
            let unit = unit.times(&Unit::new(0, 0, -1));
            let what = if row < nq { "rate" } else { "acceleration" };

            add(&format!("der({name})"), Role::Derivative(first_state + row), None, Some(&unit), what, depends_on);
        }
        for (row, output) in functions.outputs().iter().enumerate() {
            let columns = nx + np;
            let of_states = (0..nx).map(|at| Some((first_state + at, entry("output_jacobian", row * columns + at)?)));
            let of_inputs = inputs.iter().map(|at| Some((at + 1, entry("output_jacobian", row * columns + nx + at)?)));
            let depends_on = nonzero_dependencies(of_states.chain(of_inputs));
            add(&output.name, Role::Output, None, None, "output of the scene", depends_on);
        }
        let events = functions.events().iter().map(|event| &event.name);
        for name in plan.divisors.iter().chain(&plan.conditions).chain(events) {
            add(name, Role::Indicator, None, None, "an event where it changes its sign", None);
        }
        Self { list }
    }

    /// Returns the start values of the coordinates and generalized speeds, in the order of their
    /// value references.
    pub fn start(&self) -> Vec<f64> {
        let states = self.list.iter().filter(|variable| matches!(variable.role, Role::State(_)));
        states.filter_map(|variable| variable.start).collect()
    }
}

/// Returns the value references for which the derivative is not identically zero. `None` if a derivative is missing
/// from the plan.
fn nonzero_dependencies<'e>(mut slopes: impl Iterator<Item = Option<(usize, &'e Entry)>>) -> Option<Vec<usize>> {
    slopes.try_fold(Vec::new(), |mut list, slope| {
        let (reference, entry) = slope?;
        if !matches!(entry, Entry::Zero) {
            list.push(reference);
        }
        Some(list)
    })
}

/// Set of variable names already used.
#[derive(Default)]
struct FmuVariableNames(FxHashSet<String>);

impl FmuVariableNames {
    /// Returns the wanted name. If it is already used, the first free number from 2 is appended, such as `q (2)`.
    fn unique(&mut self, wanted: &str) -> String {
        let numbered = (2..).map(|n| format!("{wanted} ({n})"));
        let mut candidates = std::iter::once(wanted.to_owned()).chain(numbered);
        let found = candidates.find(|name| !self.0.contains(name)).expect("numbers do not end");
        self.0.insert(found.clone());
        found
    }
}
