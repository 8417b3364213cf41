//! CasADi as a target: a Python module of symbolic functions for each set of equations, and one module of helpers.

use super::python::names::LANGUAGE;
use super::python::text::{
    docstring, escape_python_comment, python_number_literal, write_python_array, write_python_declarations,
    write_python_expression, write_python_names_and_values,
};
use super::{CompositeFunction, Dialect, Module};
use crate::plan::{Argument, Entry, Function, Language, Returns, result_matrix_size};
use crate::syntax::{CodeWriter, Comments, Syntax};

/// Text of the Python module of helpers, `tripos_casadi.py`.
const SHARED: &str = include_str!("casadi/tripos_casadi.py");

/// Name of the Python module of helpers, without extension.
const HELPERS: &str = "tripos_casadi";

/// CasADi as a target: Python functions that return symbolic expressions.
pub struct CasADi;

impl Syntax for CasADi {
    fn comment_mark(&self) -> &'static str {
        "#"
    }

    fn escape_comment(&self, text: &str) -> String {
        escape_python_comment(text)
    }

    fn integer_literal(&self, digits: &str) -> String {
        python_number_literal(digits)
    }

    fn not_a_number(&self) -> &'static str {
        "casadi.nan"
    }

    fn pi(&self) -> &'static str {
        "casadi.pi"
    }

    fn call(&self, name: &str, argument: &str) -> String {
        let name = match name {
            "abs" => "fabs",
            name => name,
        };
        format!("casadi.{name}({argument})")
    }

    fn power(&self, _argument: &str, operand: &str, exponent: i32) -> String {
        format!("{operand}**{exponent}")
    }

    fn declare(&self, out: &mut String, indent: &str, list: &[(String, String)]) {
        write_python_declarations(out, indent, list);
    }
}

impl Dialect for CasADi {
    fn language(&self) -> &'static Language {
        &LANGUAGE
    }

    fn command(&self) -> &'static str {
        "emit --language casadi"
    }

    fn extensions(&self) -> &'static [&'static str] {
        &["py"]
    }

    fn main_file(&self, model: &str, equations: &str) -> String {
        format!("{model}_{equations}_casadi.py")
    }

    fn files(&self, module: &Module<'_>) -> Vec<(String, String)> {
        vec![(self.main_file(module.model_word, module.equations_word), casadi_module_text(module))]
    }

    fn shared_files(&self, origin: &str) -> Vec<(String, String)> {
        let mut writer = CodeWriter::new(self, Comments::Written);
        writer.origin(origin);
        vec![(format!("{HELPERS}.py"), writer.out + SHARED)]
    }

    fn composites(&self) -> &'static [CompositeFunction] {
        &[CompositeFunction::Unknowns, CompositeFunction::Reactions, CompositeFunction::Ode, CompositeFunction::Dae]
    }
}

/// Returns the text of the Python module for one set of equations: names, functions, and tables of
/// arguments and lengths.
fn casadi_module_text(module: &Module<'_>) -> String {
    let mut writer = CodeWriter::new(&CasADi, Comments::Written);
    let usage = "Functions take parameters p, coordinates q and motion variables, in the order of PARAMETERS, COORDINATES and \
                 VARIABLES, as columns of SX, MX or DM, and return expressions. `function(name)` makes a casadi.Function of \
                 one of them.";
    module.header(&mut writer, &module.title(), usage);
    writer.write_empty_line();
    writer.write_unbroken(&docstring(&module.title()));
    writer.write_unbroken(&format!("import casadi\n\nimport {HELPERS} as _helpers\n"));
    write_python_names_and_values(&mut writer, module, "casadi.nan");
    for planned in &module.plan.functions {
        function(&mut writer, planned);
    }
    module.composites.iter().for_each(|composite| write_composite_casadi_function(&mut writer, module, *composite));
    let (e, v) = (module.equations(), module.variables_argument());
    writer.write_unbroken("\n");
    writer.comment("Lengths of the arguments.");
    writer.write_unbroken(&format!(
        "LENGTHS = {{\"p\": {}, \"q\": {}, \"{v}\": {}, \"v_dot\": {}, \"x\": {}{}}}",
        module.model().parameters.len(),
        e.coordinates.len(),
        e.variables.len(),
        e.variables.len(),
        e.unknowns.len(),
        if e.formulation.is_in_rates() { format!(", \"u\": {}", module.model().speeds.len()) } else { String::new() },
    ));
    writer.comment("Functions by name, with their arguments.");
    writer.write_unbroken("FUNCTIONS = {");
    for planned in &module.plan.functions {
        let names: Vec<String> = planned.arguments.iter().map(|argument| format!("\"{}\"", argument.name())).collect();
        writer.write_unbroken(&format!("    \"{0}\": ({0}, [{1}]),", planned.name, names.join(", ")));
    }
    for composite in [CompositeFunction::Unknowns, CompositeFunction::Reactions] {
        if module.composites.contains(&composite) {
            writer.write_unbroken(&format!("    \"{0}\": ({0}, [\"p\", \"q\", \"{v}\"]),", composite.name()));
        }
    }
    writer.write_unbroken("}\n\n");
    writer.write_unbroken(
        "def function(name):\n    \"\"\"A casadi.Function of symbols with the names of the arguments.\"\"\"\n    \
         return _helpers.function(name, *FUNCTIONS[name], LENGTHS)",
    );
    writer.out
}

/// Writes the Python definition of a planned function, with CasADi vectors and matrices as results.
fn function(writer: &mut CodeWriter<'_>, planned: &Function) {
    let arguments: Vec<&str> = planned.arguments.iter().map(Argument::name).collect();
    writer.write_unbroken("\n");
    writer.write_unbroken(&format!("def {}({}):", planned.name, arguments.join(", ")));
    writer.indent("    ");
    writer.write_unbroken(&docstring(&format!("{}\n\n{}.", planned.about, planned.cost)));
    writer.declare_arguments(&planned.arguments);
    writer.program(planned, &planned.program, &[]);
    let text = |entry: &Entry| match entry {
        Entry::Zero => "0".to_owned(),
        Entry::Variable(name) => name.clone(),
    };
    let entries: Vec<String> = planned.entries.iter().map(text).collect();
    match (planned.returns, result_matrix_size(planned)) {
        (Returns::Number, _) => write_python_expression(&mut writer.out, "    ", "return ", &entries.concat()),
        (Returns::System(side), _) => {
            let (matrix, right) = entries.split_at(side * side);
            write_python_array(writer, &format!("first = _helpers.table({side}, {side}, ["), matrix, "])");
            write_python_array(writer, "second = casadi.vertcat(", right, ")");
            writer.write_unbroken("return first, second");
        }
        (Returns::Pair(first), _) => {
            write_python_array(writer, "first = casadi.vertcat(", &entries[..first], ")");
            write_python_array(writer, "second = casadi.vertcat(", &entries[first..], ")");
            writer.write_unbroken("return first, second");
        }
        (_, Some([rows, columns])) => {
            write_python_array(writer, &format!("return _helpers.table({rows}, {columns}, ["), &entries, "])");
        }
        (_, None) => write_python_array(writer, "return casadi.vertcat(", &entries, ")"),
    }
    writer.indent("");
}

/// Writes a Python function that calls planned functions, such as a linear solve, `ode` or `dae`.
fn write_composite_casadi_function(writer: &mut CodeWriter<'_>, module: &Module<'_>, composite: CompositeFunction) {
    let v = module.variables_argument();
    writer.write_unbroken("\n");
    writer.write_unbroken(&match composite {
        CompositeFunction::Unknowns => format!(
            "def unknowns(p, q, {v}):\n    \"\"\"The accelerations, then the reactions or multipliers: the solution of the linear \
             system.\"\"\"\n    return casadi.solve(mass_matrix(p, q, {v}), forcing(p, q, {v}))"
        ),
        CompositeFunction::Reactions => format!(
            "def reactions(p, q, {v}):\n    \"\"\"The reactions, in the order of UNKNOWNS after the accelerations.\"\"\"\n    \
             return casadi.solve(mass_matrix(p, q, {v}), forcing(p, q, {v}))[{}:]",
            module.equations().variables.len()
        ),
        CompositeFunction::Ode => format!(
            "def ode():\n    \"\"\"The ordinary differential equation of x = (q, {v}) with parameters p, as casadi.integrator takes \
             it.\"\"\"\n    return _helpers.ode(derivative, LENGTHS, \"{v}\")"
        ),
        _ => format!(
            "def dae():\n    \"\"\"The semi-explicit equation of x = (q, {v}) and the unknowns z with parameters p: the linear \
             system stays unsolved.\"\"\"\n    return _helpers.dae(coordinate_rates, residual, LENGTHS, \"{v}\")"
        ),
    });
}
