//! Python as a target: a module for each set of equations, and one module of helpers. The arrays can come from any
//! library with the interface of NumPy.

pub(super) mod names;
pub(super) mod text;

use super::{CompositeFunction, Dialect, Module, SceneRun};
use crate::plan::{Entry, Function, Language, Returns, result_matrix_size};
use crate::syntax::{CodeWriter, Comments, Syntax};
use text::{
    docstring, python_number_literal, write_python_array, write_python_assignment, write_python_expression,
    write_python_names_and_values,
};

/// Text of the Python module of helpers, `tripos_arrays.py`.
const SHARED: &str = include_str!("tripos_arrays.py");

/// Name of the Python module of helpers, without extension.
const ARRAYS: &str = "tripos_arrays";

/// Python as a language for formulas and as a target. Generated functions take the array library as
/// the argument `xp`.
pub struct Python;

impl Syntax for Python {
    fn comment_mark(&self) -> &'static str {
        "#"
    }

    fn escape_comment(&self, text: &str) -> String {
        text::escape_python_comment(text)
    }

    fn integer_literal(&self, digits: &str) -> String {
        python_number_literal(digits)
    }

    fn not_a_number(&self) -> &'static str {
        "xp.nan"
    }

    fn pi(&self) -> &'static str {
        "xp.pi"
    }

    fn call(&self, name: &str, argument: &str) -> String {
        let name = match name {
            "asin" => "arcsin",
            "acos" => "arccos",
            "atan" => "arctan",
            name => name,
        };
        format!("xp.{name}({argument})")
    }

    fn power(&self, _argument: &str, operand: &str, exponent: i32) -> String {
        format!("{operand}**{exponent}")
    }

    fn declare(&self, out: &mut String, indent: &str, list: &[(String, String)]) {
        text::write_python_declarations(out, indent, list);
    }
}

impl Dialect for Python {
    fn language(&self) -> &'static Language {
        &names::LANGUAGE
    }

    fn command(&self) -> &'static str {
        "emit --language python"
    }

    fn extensions(&self) -> &'static [&'static str] {
        &["py"]
    }

    fn main_file(&self, model: &str, equations: &str) -> String {
        format!("{model}_{equations}.py")
    }

    fn files(&self, module: &Module<'_>) -> Vec<(String, String)> {
        vec![(self.main_file(module.model_word, module.equations_word), module_text(module))]
    }

    fn shared_files(&self, origin: &str) -> Vec<(String, String)> {
        let mut writer = CodeWriter::new(self, Comments::Written);
        writer.origin(origin);
        vec![(format!("{ARRAYS}.py"), writer.out + SHARED)]
    }

    fn script(&self, module: &Module<'_>, run: &SceneRun) -> Option<(String, String)> {
        let name = format!("{}_{}_simulate.py", module.model_word, module.equations_word);
        Some((name, python_simulation_script(module, run)))
    }

    fn composites(&self) -> &'static [CompositeFunction] {
        &[
            CompositeFunction::Unknowns,
            CompositeFunction::Reactions,
            CompositeFunction::StateDerivative,
            CompositeFunction::Project,
        ]
    }
}

/// Returns the text of the Python module for one set of equations: names, default values and
/// functions.
fn module_text(module: &Module<'_>) -> String {
    let mut writer = CodeWriter::new(&Python, Comments::Written);
    let usage = "Functions take parameters p, coordinates q and motion variables: arrays of shape (n,), or (n, N) for N states \
                 side by side, in the order of PARAMETERS, COORDINATES and VARIABLES. The last axis of a result is that of \
                 the states. `xp` is an array library with the interface of NumPy, such as jax.numpy or cupy.";
    module.header(&mut writer, &module.title(), usage);
    writer.write_empty_line();
    writer.write_unbroken(&docstring(&module.title()));
    writer.write_unbroken(&format!("import numpy\n\nimport {ARRAYS} as _arrays\n"));
    write_python_names_and_values(&mut writer, module, "numpy.nan");
    for planned in &module.plan.functions {
        function(&mut writer, planned);
    }
    module.composites.iter().for_each(|composite| write_composite_python_function(&mut writer, module, *composite));
    writer.out
}

/// Writes the Python definition of a planned function, with arrays as results.
fn function(writer: &mut CodeWriter<'_>, planned: &Function) {
    let arguments: Vec<&str> = planned.arguments.iter().map(crate::plan::Argument::name).collect();
    writer.write_unbroken("\n");
    writer.write_unbroken(&format!("def {}({}, xp=numpy):", planned.name, arguments.join(", ")));
    writer.indent("    ");
    writer.write_unbroken(&docstring(&format!("{}\n\n{}.", planned.about, planned.cost)));
    let arrays = arguments.join(", ");
    let names: Vec<&str> = arguments.iter().copied().chain(["shape"]).collect();
    write_python_assignment(&mut writer.out, "    ", &names, &format!("_arrays.arguments(xp, {arrays})"));
    writer.declare_arguments(&planned.arguments);
    writer.program(planned, &planned.program, &[]);
    let text = |entry: &Entry| match entry {
        Entry::Zero => "0.0".to_owned(),
        Entry::Variable(name) => name.clone(),
    };
    let entries: Vec<String> = planned.entries.iter().map(text).collect();
    let array = |writer: &mut CodeWriter<'_>, start: &str, entries: &[String], shape: &str| {
        write_python_array(writer, &format!("{start}_arrays.array(xp, shape, {shape}, ["), entries, "])");
    };
    match (planned.returns, result_matrix_size(planned)) {
        (Returns::System(side), _) => {
            let (matrix, right) = entries.split_at(side * side);
            array(writer, "first = ", matrix, &format!("({side}, {side})"));
            array(writer, "second = ", right, &format!("({side},)"));
            writer.write_unbroken("return first, second");
        }
        (Returns::Number, _) => {
            let number = format!("xp.broadcast_to(xp.asarray({}), shape)", entries.concat());
            write_python_expression(&mut writer.out, "    ", "return ", &number);
        }
        (Returns::Pair(first), _) => {
            array(writer, "first = ", &entries[..first], &format!("({first},)"));
            array(writer, "second = ", &entries[first..], &format!("({},)", entries.len() - first));
            writer.write_unbroken("return first, second");
        }
        (_, Some([rows, columns])) => array(writer, "return ", &entries, &format!("({rows}, {columns})")),
        (_, None) => array(writer, "return ", &entries, &format!("({},)", entries.len())),
    }
    writer.indent("");
}

/// Writes a Python function that calls planned functions, such as a linear solve, the state derivative, or a
/// projection onto constraints.
fn write_composite_python_function(writer: &mut CodeWriter<'_>, module: &Module<'_>, composite: CompositeFunction) {
    let (v, e) = (module.variables_argument(), module.equations());
    let n = e.coordinates.len();
    writer.write_unbroken("\n");
    let body = match composite {
        CompositeFunction::Unknowns => format!(
            "def unknowns(p, q, {v}, xp=numpy):\n    \"\"\"The accelerations, then the reactions or multipliers: the solution of \
             the linear system.\"\"\"\n    return _arrays.solve(xp, mass_matrix(p, q, {v}, xp), forcing(p, q, {v}, xp))"
        ),
        CompositeFunction::Reactions => format!(
            "def reactions(p, q, {v}, xp=numpy):\n    \"\"\"The reactions, in the order of UNKNOWNS after the \
             accelerations.\"\"\"\n    return _arrays.solve(xp, mass_matrix(p, q, {v}, xp), forcing(p, q, {v}, xp))[{}:]",
            e.variables.len()
        ),
        CompositeFunction::StateDerivative => format!(
            "def state_derivative(t, state, p=DEFAULTS, xp=numpy):\n    \"\"\"The derivative of the state (q, {v}), as \
             scipy.integrate.solve_ivp takes it.\"\"\"\n    state = xp.asarray(state)\n    first, second = \
             derivative(p, state[:{n}], state[{n}:], xp)\n    return xp.concatenate((first, second))"
        ),
        _ => format!(
            "def project(p, q, {v}, xp=numpy, corrections=30):\n    \"\"\"The state, or guess of a pose, moved onto the constraints \
             by the smallest\n    corrections; nan where they do not hold afterwards.\"\"\"\n    return _arrays.project(xp, constraints, \
             constraint_slopes, p, q, {v}, corrections)"
        ),
    };
    writer.write_unbroken(&body);
}

/// Returns the text of the script that runs a scene by SciPy and prints the last state. It draws the states if
/// Matplotlib is installed.
fn python_simulation_script(module: &Module<'_>, run: &SceneRun) -> String {
    let mut writer = CodeWriter::new(&Python, Comments::Written);
    let stem = format!("{}_{}", module.model_word, module.equations_word);
    writer.comment(&module.title());
    writer.comment("");
    writer.origin(module.origin);
    writer.write_empty_line();
    let about =
        format!("Runs the scene {}, prints the last state, and draws all states if Matplotlib is installed.", run.name);
    writer.write_unbroken(&docstring(&about));
    writer.write_unbroken(&format!("import numpy\nfrom scipy.integrate import solve_ivp\n\nimport {stem} as model\n"));
    let list = |writer: &mut CodeWriter<'_>, name: &str, values: &[f64]| {
        let number = |x: &f64| if x.is_nan() { "numpy.nan".to_owned() } else { format!("{x:?}") };
        write_python_array(writer, &format!("{name} = ["), &values.iter().map(number).collect::<Vec<_>>(), "]");
    };
    list(&mut writer, "p", &run.parameters);
    list(&mut writer, "q", &run.q);
    list(&mut writer, "u", &run.u);
    let is_in_rates = module.equations().formulation.is_in_rates();
    let v = if is_in_rates { "model.motion_variables(p, q, u)" } else { "u" };
    let (tolerance, (start, end)) = (run.rtol.max(1e-13), run.span);
    writer.write_unbroken(&format!("state = numpy.concatenate((q, {v}))"));
    writer.write_unbroken(&format!(
        "run = solve_ivp(model.state_derivative, ({start:?}, {end:?}), state, \"DOP853\", args=(p,), rtol={tolerance:?}, \
         atol={tolerance:?})"
    ));
    writer.write_unbroken(
        "if not run.success:\n    raise SystemExit(f\"the run ends at t = {run.t[-1]} s: {run.message}\")",
    );
    writer.write_unbroken(
        "for name, value in zip(model.COORDINATES + model.VARIABLES, run.y[:, -1]):\n    print(name, value)",
    );
    writer.write_unbroken("try:\n    import matplotlib.pyplot as plot\nexcept ImportError:\n    plot = None");
    writer.write_unbroken(
        "if plot:\n    plot.plot(run.t, run.y.T)\n    plot.legend(model.COORDINATES + model.VARIABLES)\n    \
         plot.xlabel(\"t, s\")\n    plot.show()",
    );
    writer.out
}
