//! Text of a JavaScript module for one set of equations: its names, its functions, and the data
//! that runs need.

use super::function::JavaScriptFunctionWriter;
use super::javascript_strings::{javascript_script_text, javascript_string, javascript_string_array};
use super::syntax::JavaScript;
use crate::plan::{Function, MotionPlan, Planner};
use crate::syntax::{CodeWriter, Comments, number_literal};
use tripos_derive::Model;

/// JavaScript source of a solver for linear systems. Modules contain it if their accelerations are not in closed
/// form, or if they compute reactions.
const SOLVE: &str = include_str!("solve.js");

/// Names of the constants that every module exports.
const NAMES: [&str; 10] = [
    "TITLE",
    "PARAMETERS",
    "DEFAULTS",
    "COORDINATES",
    "VARIABLES",
    "SPEEDS",
    "DIVISORS",
    "CONDITIONS",
    "CONSTRAINTS",
    "LOOPS",
];

/// Names of functions that every module exports. If the plan lacks such a function, it is written as a call of
/// planned functions.
const FUNCTIONS: [&str; 6] =
    ["accelerations", "coordinate_rates", "derivative", "generalized_speeds", "motion_variables", "reactions"];

/// Names of planned functions that runs in a page never call.
const FUNCTIONS_WITHOUT_RUN: [&str; 1] = ["power"];

/// Contents of a JavaScript module: a plan, the watched quantities, and further functions.
pub struct JavaScriptModule<'a> {
    /// Planner of the module's functions.
    pub planner: &'a Planner<'a>,
    /// Plan with the functions for motion, and names of divisors, conditions and constraints.
    pub plan: &'a MotionPlan,
    /// Names of the watched quantities, such as normal forces, in the order in which the plan got them.
    pub watched: &'a [String],
    /// Further planned functions that the module exports, in addition to those of the plan.
    pub beside: &'a [Function],
    /// Sentence of the header that names the origin of the module.
    pub origin: &'a str,
}

impl JavaScriptModule<'_> {
    /// Returns the text of the module with its header and comments.
    #[must_use]
    pub fn text(&self) -> String {
        let mut functions = JavaScriptFunctionWriter::new(Comments::Written);
        self.header(&mut functions.lines);
        self.names(&mut functions.lines);
        self.functions(&mut functions);
        functions.lines.out
    }

    /// Returns a JavaScript expression for a page. Its value is an object with all exports of the
    /// module; it has no comments.
    #[must_use]
    pub fn javascript_module_object(&self) -> String {
        let mut functions = JavaScriptFunctionWriter::new(Comments::LeftOut);
        self.names(&mut functions.lines);
        self.functions(&mut functions);
        let mut exports: Vec<&str> = NAMES.to_vec();
        exports.extend(FUNCTIONS.iter().filter(|name| !self.is_left_out(name, Comments::LeftOut)));
        let planned = self.plan.functions.iter().chain(self.beside).map(|function| function.name);
        exports.extend(planned.filter(|name| !FUNCTIONS.contains(name) && !self.is_left_out(name, Comments::LeftOut)));
        format!(
            "(() => {{\n{}return {{ {} }};\n}})()",
            javascript_script_text(&functions.lines.out),
            exports.join(", ")
        )
    }

    fn model(&self) -> &Model {
        self.planner.model
    }

    /// Writes the header: title, origin, facts about the equations, quantities that cannot be
    /// watched, and usage.
    fn header(&self, writer: &mut CodeWriter<'_>) {
        let (model, e) = (self.model(), self.planner.equations);
        writer.comment(&format!("{}: {}, {}.", model.title, e.title(model), e.formulation.equation(model)));
        writer.out.push_str("//\n");
        writer.origin(self.origin);
        for fact in &self.plan.facts {
            writer.comment(fact);
        }
        for at in &self.plan.unwatched {
            writer.comment(&format!("Not watched, since no reactions can be had: {}.", self.watched[*at]));
        }
        writer.out.push_str("//\n");
        writer.comment(
            "Functions take parameters p, coordinates q and motion variables, arrays in the order of PARAMETERS, COORDINATES and VARIABLES; \
             `run` of run.mjs integrates them.",
        );
        writer.write_empty_line();
    }

    /// Writes the exported constants: names and default values of parameters, and names of
    /// coordinates, speeds, divisors, conditions and constraints.
    fn names(&self, writer: &mut CodeWriter<'_>) {
        let (model, e) = (self.model(), self.planner.equations);
        writer.write_unbroken(&format!(
            "export const TITLE = {};",
            javascript_string(&format!("{}, {}", model.title, e.title(model)))
        ));
        writer.write_empty_line();
        for p in &model.parameters {
            let about = if p.about.is_empty() { "parameter" } else { &p.about };
            writer.comment(&format!("{}: {about}, {}", p.name, p.unit));
        }
        let list = |names: &mut dyn Iterator<Item = &str>| javascript_string_array(names);
        let parameters = list(&mut model.parameters.iter().map(|p| p.name.as_str()));
        writer.write_unbroken(&format!("export const PARAMETERS = {parameters};"));
        let values = model
            .parameters
            .iter()
            .map(|p| p.value.as_ref().map_or_else(|| "null".to_owned(), |v| number_literal(&JavaScript, v)));
        writer.comment("What the model file states of them.");
        writer.write_unbroken(&format!("export const DEFAULTS = [{}];", values.collect::<Vec<_>>().join(", ")));
        for coordinate in model.coordinates.iter().filter(|c| !c.about.is_empty()) {
            writer.comment(&format!("{}: {}", coordinate.name, coordinate.about));
        }
        let coordinates = list(&mut model.coordinates.iter().map(|c| c.name.as_str()));
        writer.write_unbroken(&format!("export const COORDINATES = {coordinates};"));
        let variables = list(&mut e.variables.iter().filter_map(|v| self.planner.arena.symbol_name(*v)));
        writer.write_unbroken(&format!("export const VARIABLES = {variables};"));
        let speeds = list(&mut model.speeds.iter().map(|s| s.name.as_str()));
        writer.write_unbroken(&format!("export const SPEEDS = {speeds};"));
        writer.comment("What the equations divide by, and what must be positive for them to hold.");
        let divisors = list(&mut self.plan.divisors.iter().map(String::as_str));
        writer.write_unbroken(&format!("export const DIVISORS = {divisors};"));
        let conditions = list(&mut self.plan.conditions.iter().map(|at| self.watched[*at].as_str()));
        writer.write_unbroken(&format!("export const CONDITIONS = {conditions};"));
        writer.comment(
            "What a run drifts from unless it is kept there; first, so many of them, the loops, which tie coordinates.",
        );
        let constraints = list(&mut self.plan.constraints.iter().map(String::as_str));
        writer.write_unbroken(&format!("export const CONSTRAINTS = {constraints};"));
        writer.write_unbroken(&format!("export const LOOPS = {};", model.loops.len()));
    }

    /// True if a page does not need the function `name`: another function computes its values, or
    /// no run calls it. Always false for modules with comments.
    fn is_left_out(&self, name: &str, comments: Comments) -> bool {
        let together = ["accelerations", "coordinate_rates"];
        comments == Comments::LeftOut
            && (together.contains(&name) && self.has("derivative") || FUNCTIONS_WITHOUT_RUN.contains(&name))
    }

    /// True if the plan contains a function with this name.
    fn has(&self, name: &str) -> bool {
        self.plan.functions.iter().any(|planned| planned.name == name)
    }

    /// Writes the planned functions. Then writes the required functions without a plan, as calls of planned
    /// functions.
    fn functions(&self, functions: &mut JavaScriptFunctionWriter) {
        let comments = functions.lines.comments();
        if !self.plan.is_solved || !self.plan.balance.is_empty() {
            functions.lines.write_empty_line();
            functions.lines.out.push_str(SOLVE);
        }
        let planned = self.plan.functions.iter().filter(|planned| !self.is_left_out(planned.name, comments));
        for planned in planned.chain(&self.plan.balance).chain(self.beside) {
            functions.function(planned);
        }
        let writer = &mut functions.lines;
        let own = if self.planner.equations.formulation.is_in_rates() { "q_dot" } else { "u" };
        let mut made = |name: &str, arguments: &str, about: &str, value: &str| {
            if !self.has(name) && !self.is_left_out(name, comments) {
                writer.write_empty_line();
                writer.comment(about);
                writer.line(&format!("export function {name}(p, q, {arguments}) {{"));
                writer.line(&format!("  return {value};"));
                writer.line("}");
            }
        };
        let (own_arguments, n) = (format!("(p, q, {own})"), self.plan.variables);
        let solved = format!("solve$(mass_matrix{own_arguments}, forcing{own_arguments}).slice(0, {n})");
        made("accelerations", own, "The accelerations: the first unknowns of the linear system.", &solved);
        let both = format!("[coordinate_rates{own_arguments}, accelerations{own_arguments}]");
        made("derivative", own, "The rates of the coordinates, and the accelerations.", &both);
        made("generalized_speeds", "u", "The generalized speeds, which are the motion variables.", "u");
        made("motion_variables", "u", "The motion variables, which are the generalized speeds.", "u");
        let balance = if self.plan.balance.is_empty() {
            "[]".to_owned()
        } else {
            let at = format!("(p, q, generalized_speeds{own_arguments})");
            format!("solve$(balance_matrix{at}, balance_forcing{at}).slice({})", self.model().speeds.len())
        };
        made(
            "reactions",
            own,
            "The reactions that conditions are about, by the balance of forces; none if none are.",
            &balance,
        );
    }
}
