//! MATLAB and Octave as a target: one file for each function of a set of equations. A column of a function's
//! arguments holds one state, so that a call can take many states.

mod names;

use super::{CompositeFunction, Dialect, Module, SceneRun};
use crate::lines::wrap;
use crate::plan::{Argument, Entry, Function, Language, ModulePlan, result_matrix_size};
use crate::syntax::{CodeWriter, Comments, Syntax, WIDTH, number_literal};
use std::fmt::Write;
use tripos_derive::plain_text::{one_line, with_visible_characters};

/// Largest number of bytes in the name of a MATLAB function.
const LONGEST: usize = 63;

/// Number of bytes reserved for the longest name of a planned function, with the underscore in front of it.
const LONGEST_FUNCTION: usize = 24;

/// Largest residual of a satisfied constraint, relative to the sizes of its terms. If a residual is larger, the
/// projected state is NaN.
const LARGEST_CLOSED_RESIDUAL: &str = "1e-12";

/// MATLAB and Octave as a language for formulas and as a target for modules.
pub struct Matlab;

impl Syntax for Matlab {
    fn comment_mark(&self) -> &'static str {
        "%"
    }

    fn escape_comment(&self, text: &str) -> String {
        with_visible_characters(&one_line(text)).into_owned()
    }

    fn operators(&self) -> [&'static str; 2] {
        [".*", "./"]
    }

    fn not_a_number(&self) -> &'static str {
        "NaN"
    }

    fn pi(&self) -> &'static str {
        "pi"
    }

    fn call(&self, name: &str, argument: &str) -> String {
        format!("{name}({argument})")
    }

    fn power(&self, _argument: &str, operand: &str, exponent: i32) -> String {
        format!("{operand}.^{}", if exponent < 0 { format!("({exponent})") } else { exponent.to_string() })
    }

    fn entry(&self, array: &str, at: usize) -> String {
        format!("{array}({}, :)", at + 1)
    }

    fn declare(&self, out: &mut String, indent: &str, list: &[(String, String)]) {
        // Short assignments share a line.
        let mut lines: Vec<String> = Vec::new();
        for (name, value) in list {
            let text = format!("{name} = {value};");
            match lines.last_mut() {
                Some(last) if last.len() + text.len() + 12 <= WIDTH => last.extend([" ", text.as_str()]),
                _ => lines.push(text),
            }
        }
        for text in lines {
            self.statement(out, indent, &text);
        }
    }

    fn statement(&self, out: &mut String, indent: &str, text: &str) {
        let parts = wrap(text, WIDTH - indent.len() - 8);
        for (at, part) in parts.iter().enumerate() {
            let hang = if at == 0 { "" } else { "    " };
            let more = if at + 1 < parts.len() { " ..." } else { "" };
            let _ = writeln!(out, "{indent}{hang}{part}{more}");
        }
    }
}

impl Dialect for Matlab {
    fn language(&self) -> &'static Language {
        &names::LANGUAGE
    }

    fn command(&self) -> &'static str {
        "emit --language matlab"
    }

    fn extensions(&self) -> &'static [&'static str] {
        &["m"]
    }

    fn main_file(&self, model: &str, equations: &str) -> String {
        format!("{}_parameters.m", stem(model, equations))
    }

    fn files(&self, module: &Module<'_>) -> Vec<(String, String)> {
        let stem = stem(module.model_word, module.equations_word);
        let mut files = vec![(format!("{stem}_parameters.m"), parameters(module, &stem))];
        let planned = module.plan.functions.iter();
        files.extend(planned.map(|f| (format!("{stem}_{}.m", f.name), function(module, &stem, f))));
        files.extend(
            module
                .composites
                .iter()
                .map(|c| (format!("{stem}_{}.m", c.name()), matlab_composite_file(module, &stem, *c))),
        );
        files
    }

    fn possible_files(&self, model: &str, equations: &str) -> Vec<String> {
        let stem = stem(model, equations);
        let functions = ModulePlan::FUNCTIONS.into_iter().chain(self.composites().iter().map(|one| one.name()));
        functions.chain(["simulate"]).map(|name| format!("{stem}_{name}.m")).collect()
    }

    fn shared_files(&self, _origin: &str) -> Vec<(String, String)> {
        Vec::new()
    }

    fn script(&self, module: &Module<'_>, run: &SceneRun) -> Option<(String, String)> {
        let stem = stem(module.model_word, module.equations_word);
        Some((format!("{stem}_simulate.m"), matlab_simulation_script(module, &stem, run)))
    }

    fn composites(&self) -> &'static [CompositeFunction] {
        use CompositeFunction::{Project, Reactions, StateDerivative, StateForcing, StateMass, Unknowns};
        &[Unknowns, Reactions, StateDerivative, StateMass, StateForcing, Project]
    }
}

/// Returns the text with which the names of a module's functions begin. If it would make a name too long for MATLAB,
/// it is cut and ends in a hash.
fn stem(model: &str, equations: &str) -> String {
    let stem = format!("{model}_{equations}");
    let room = LONGEST - LONGEST_FUNCTION;
    if stem.len() <= room {
        return stem;
    }
    // The hash of Fowler, Noll & Vo keeps different names different.
    let hash = stem.bytes().fold(0x811c_9dc5_u32, |hash, byte| (hash ^ u32::from(byte)).wrapping_mul(0x0100_0193));
    format!("{}_{hash:08x}", &stem[..room - 9])
}

/// Returns the MATLAB string literal for a text.
fn string(text: &str) -> String {
    format!("'{}'", with_visible_characters(&one_line(text)).replace('\'', "''"))
}

/// Starts a function file: the origin, the first line with the signature, and comments.
fn start_matlab_file(module: &Module<'_>, signature: &str, comments: &[&str]) -> CodeWriter<'static> {
    let mut writer = CodeWriter::new(&Matlab, Comments::Written);
    // The origin comes first, so that programs find it. A function file may begin with comments.
    writer.origin(module.origin);
    writer.write_unbroken(&format!("function {signature}"));
    for text in comments {
        writer.comment(text);
    }
    writer.comment("");
    writer.comment(&module.title());
    writer.indent("  ");
    writer
}

/// Returns the text of the function file that gives the values, names and units of the parameters.
fn parameters(module: &Module<'_>, stem: &str) -> String {
    let about =
        "Parameters in their order, with the values of the model file (NaN where it states none), names and units.";
    let signature = format!("[p, names, units] = {stem}_parameters()");
    let mut writer = start_matlab_file(module, &signature, &[about]);
    writer.indent("");
    let usage = "Functions take parameters p, coordinates q and motion variables as columns; with several columns, they \
                 compute several states at once, along the last dimension of the results.";
    module.header(&mut writer, about, usage);
    writer.indent("  ");
    let model = module.model();
    writer.write_unbroken(&format!("p = zeros({}, 1);", model.parameters.len()));
    for ((at, p), meaning) in model.parameters.iter().enumerate().zip(module.parameter_meanings()) {
        writer.comment(&meaning);
        let value = p.value.as_ref().map_or_else(|| "NaN".to_owned(), |value| number_literal(&Matlab, value));
        writer.write_unbroken(&format!("p({}) = {value};", at + 1));
    }
    let mut list = |name: &str, texts: &mut dyn Iterator<Item = String>| {
        writer.write_unbroken(&format!("{name} = {{ ..."));
        texts.for_each(|text| writer.write_unbroken(&format!("  {}, ...", string(&text))));
        writer.write_unbroken("};");
    };
    list("names", &mut model.parameters.iter().map(|p| p.name.clone()));
    list("units", &mut model.parameters.iter().map(|p| p.unit.to_string()));
    end_matlab_file(writer)
}

/// Ends a function file and returns its text.
fn end_matlab_file(mut writer: CodeWriter<'_>) -> String {
    writer.indent("");
    writer.write_unbroken("end");
    writer.out
}

/// Returns the text of the file of a planned function.
fn function(module: &Module<'_>, stem: &str, planned: &Function) -> String {
    let names: Vec<&str> = planned.arguments.iter().map(Argument::name).collect();
    let is_pair = planned.returns.first().is_some();
    let results = if is_pair { "[out, out_2]" } else { "out" };
    let signature = format!("{results} = {stem}_{}({})", planned.name, names.join(", "));
    let mut writer = start_matlab_file(module, &signature, &[&planned.about, &format!("{}.", planned.cost)]);
    for (name, length) in module.argument_lengths(planned) {
        if let Some(length) = length.filter(|length| *length > 0) {
            writer.write_unbroken(&format!(
                "assert(size({name}, 1) == {length}, '{name} needs {length} rows, one for each entry');"
            ));
        }
    }
    let widths: Vec<String> = names.iter().map(|name| format!("size({name}, 2)")).collect();
    writer.line(&format!("N = max([{}]);", widths.join(", ")));
    writer.declare_arguments(&planned.arguments);
    writer.program(planned, &planned.program, &[]);
    let entries = &planned.entries;
    let mut filled = |name: &str, entries: &[(usize, &Entry)]| {
        writer.write_unbroken(&format!("{name} = zeros({}, N);", entries.len()));
        for (place, entry) in entries {
            if let Entry::Variable(variable) = entry {
                writer.write_unbroken(&format!("{name}({}, :) = {variable};", place + 1));
            }
        }
    };
    let (first, second) = entries.split_at(planned.returns.first().unwrap_or(entries.len()));
    let shape = result_matrix_size(planned);
    // Entries of a matrix are stored column by column.
    let place = |at: usize| match shape {
        Some([rows, columns]) => at % columns.max(1) * rows + at / columns.max(1),
        None => at,
    };
    filled("out", &first.iter().enumerate().map(|(at, entry)| (place(at), entry)).collect::<Vec<_>>());
    if is_pair {
        filled("out_2", &second.iter().enumerate().collect::<Vec<_>>());
    }
    if let Some([rows, columns]) = shape {
        writer.write_unbroken(&format!("out = reshape(out, {rows}, {columns}, N);"));
    }
    end_matlab_file(writer)
}

/// Returns the text of the file for a composite function, which calls planned functions.
fn matlab_composite_file(module: &Module<'_>, stem: &str, composite: CompositeFunction) -> String {
    let (v, e) = (module.variables_argument(), module.equations());
    let n = e.coordinates.len();
    let of_state = format!("q = state(1:{n}, :);\n{v} = state({}:end, :);\n", n + 1);
    let (signature, about, body) = match composite {
        CompositeFunction::Unknowns => (
            format!("out = {stem}_unknowns(p, q, {v})"),
            "Accelerations, then reactions or multipliers: the solution of the linear system.",
            format!(
                "matrix = {stem}_mass_matrix(p, q, {v});\nright = {stem}_forcing(p, q, {v});\nout = zeros(size(right));\n\
                 for k = 1:size(right, 2)\n  out(:, k) = matrix(:, :, k) \\ right(:, k);\nend\n"
            ),
        ),
        CompositeFunction::Reactions => (
            format!("out = {stem}_reactions(p, q, {v})"),
            "Reactions, in the order of the unknowns after the accelerations.",
            format!(
                "matrix = {stem}_mass_matrix(p, q, {v});\nright = {stem}_forcing(p, q, {v});\nout = zeros(size(right));\n\
                 for k = 1:size(right, 2)\n  out(:, k) = matrix(:, :, k) \\ right(:, k);\nend\nout = out({}:end, :);\n",
                e.variables.len() + 1
            ),
        ),
        CompositeFunction::StateDerivative => (
            format!("out = {stem}_state_derivative(t, state, p)"),
            "Derivative of the state: ode45(@(t, state) f(t, state, p), span, start).",
            format!("{of_state}[q_rates, v_rates] = {stem}_derivative(p, q, {v});\nout = [q_rates; v_rates];\n"),
        ),
        CompositeFunction::StateMass => (
            format!("out = {stem}_state_mass(t, state, p)"),
            "Matrix of the state's linear system, for odeset('Mass', ...); the right-hand side is `state_forcing`.",
            format!("{of_state}out = blkdiag(eye({n}), {stem}_mass_matrix(p, q, {v}));\n"),
        ),
        CompositeFunction::StateForcing => (
            format!("out = {stem}_state_forcing(t, state, p)"),
            "Right-hand side of the state's linear system; its matrix is `state_mass`.",
            format!("{of_state}out = [{stem}_coordinate_rates(p, q, {v}); {stem}_forcing(p, q, {v})];\n"),
        ),
        _ => (
            format!("[q, {v}] = {stem}_project(p, q, {v})"),
            "State, or guess of a pose, moved onto the constraints by the smallest corrections; NaN where they stay open.",
            format!(
                "all_p = p;\nfor k = 1:size(q, 2)\n  p = all_p(:, min(k, end));\n  for correction = 1:30\n    \
                 step = pinv({stem}_constraint_slopes(p, q(:, k), {v}(:, k)), 1e-8) * {stem}_constraints(p, q(:, k), {v}(:, k));\n    \
                 q(:, k) = q(:, k) - step(1:{n});\n    {v}(:, k) = {v}(:, k) - step({}:end);\n    \
                 if norm(step) <= 1e-15 * (1 + norm([q(:, k); {v}(:, k)]))\n      break\n    end\n  end\n  \
                 sizes = abs({stem}_constraint_slopes(p, q(:, k), {v}(:, k))) * (1 + abs([q(:, k); {v}(:, k)]));\n  \
                 if ~all(abs({stem}_constraints(p, q(:, k), {v}(:, k))) <= {LARGEST_CLOSED_RESIDUAL} * sizes)\n    \
                 q(:, k) = NaN;\n    {v}(:, k) = NaN;\n  end\nend\n",
                n + 1
            ),
        ),
    };
    let mut writer = start_matlab_file(module, &signature, &[about]);
    body.lines().for_each(|line| writer.write_unbroken(line));
    end_matlab_file(writer)
}

/// Returns the text of the script that runs a scene by `ode45` and draws the states.
fn matlab_simulation_script(module: &Module<'_>, stem: &str, run: &SceneRun) -> String {
    let mut writer = CodeWriter::new(&Matlab, Comments::Written);
    writer.origin(module.origin);
    writer.comment(&format!("Runs the scene {} by ode45, and draws the states.", run.name));
    writer.comment("");
    writer.comment(&module.title());
    let column = |values: &[f64]| {
        let list: Vec<String> =
            values.iter().map(|x| if x.is_nan() { "NaN".to_owned() } else { format!("{x:?}") }).collect();
        format!("[{}]", list.join("; "))
    };
    writer.line(&format!("p = {};", column(&run.parameters)));
    writer.line(&format!("q = {};", column(&run.q)));
    writer.line(&format!("u = {};", column(&run.u)));
    let is_in_rates = module.equations().formulation.is_in_rates();
    writer.write_unbroken(&if is_in_rates {
        format!("state = [q; {stem}_motion_variables(p, q, u)];")
    } else {
        "state = [q; u];".into()
    });
    let tolerance = run.rtol.max(1e-13);
    writer.write_unbroken(&format!("options = odeset('RelTol', {tolerance:?}, 'AbsTol', {tolerance:?});"));
    let (start, end) = run.span;
    let f = format!("@(t, state) {stem}_state_derivative(t, state, p)");
    writer.write_unbroken(&format!("[t, states] = ode45({f}, [{start:?}, {end:?}], state, options);"));
    let before = if end < start { '>' } else { '<' };
    writer.write_unbroken(&format!("if t(end) {before} {end:?} || any(isnan(states(end, :)))"));
    writer.write_unbroken("  error('the run ends at t = %g s', t(end));\nend");
    let names = module.model().coordinates.iter().map(|c| c.name.clone());
    let variables = module.equations().variables.iter();
    let variables = variables.filter_map(|v| module.planner.arena.symbol_name(*v)).map(str::to_owned);
    let names: Vec<String> = names.chain(variables).map(|name| string(&name)).collect();
    // Octave cannot draw without a display.
    writer.write_unbroken(
        "if ~exist('OCTAVE_VERSION', 'builtin') || ~isunix() || ismac() || ~isempty(getenv('DISPLAY'))",
    );
    writer.write_unbroken(&format!("  plot(t, states); legend({}); xlabel('t, s');", names.join(", ")));
    writer.write_unbroken("end\ndisp(states(end, :));");
    writer.out
}
