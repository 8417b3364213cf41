//! C99 as a target: a header and a source for each set of equations, and one header shared by all.
//!
//! The code allocates no memory, keeps no state between calls, and calls only the mathematical functions of the
//! standard library.

mod names;

use super::{CompositeFunction, Dialect, Module};
use crate::plan::{Entry, Function, Language, Returns};
use crate::syntax::{CodeWriter, Comments, Syntax, assignment_statements, number_literal, with_firm_spaces};
use std::fmt::Write;
use tripos_derive::plain_text::{one_line, with_visible_characters};

/// Text of the header `tripos.h`, which all models share.
const SHARED: &str = include_str!("tripos.h");

/// Largest number of digits of a whole number that is written as a C integer. A longer number is
/// written as a decimal.
const MOST_DIGITS: usize = 9;

/// C99 as a language for formulas and as a target for modules.
pub struct C;

impl Syntax for C {
    fn comment_mark(&self) -> &'static str {
        "//"
    }

    /// Replaces backslashes, which could join lines, and breaks trigraphs, so that a text is safe
    /// in a comment.
    fn escape_comment(&self, text: &str) -> String {
        with_visible_characters(&one_line(text)).replace('\\', "/").replace("??", "? ?")
    }

    fn integer_literal(&self, digits: &str) -> String {
        if digits.len() <= MOST_DIGITS { digits.to_owned() } else { self.decimal_literal(&format!("{digits}.0")) }
    }

    fn decimal_literal(&self, text: &str) -> String {
        // A literal beyond the range of doubles would cause a compiler warning.
        match text.parse::<f64>() {
            Ok(0.0) => "TRIPOS_C(0.0)".to_owned(),
            Ok(value) if value.is_infinite() => "TRIPOS_C(HUGE_VAL)".to_owned(),
            _ => format!("TRIPOS_C({text})"),
        }
    }

    fn not_a_number(&self) -> &'static str {
        "TRIPOS_C(NAN)"
    }

    fn pi(&self) -> &'static str {
        "TRIPOS_PI"
    }

    fn call(&self, name: &str, argument: &str) -> String {
        format!("tripos_{name}({argument})")
    }

    fn power(&self, argument: &str, _operand: &str, exponent: i32) -> String {
        format!("tripos_power({argument}, {exponent})")
    }

    fn is_ordered_as_rust(&self) -> bool {
        true
    }

    fn declare(&self, out: &mut String, indent: &str, list: &[(String, String)]) {
        self.statement(out, indent, &format!("const tripos_real {};", assignment_statements(list, ", ")));
    }

    fn sine_and_cosine_statements(&self, sine: &str, cosine: &str, angle: &str) -> Option<Vec<String>> {
        let call = format!("tripos_sincos({angle}, &{sine}, &{cosine});");
        Some(vec![format!("tripos_real {sine}, {cosine};"), call])
    }
}

impl Dialect for C {
    fn language(&self) -> &'static Language {
        &names::LANGUAGE
    }

    fn command(&self) -> &'static str {
        "emit --language c"
    }

    fn extensions(&self) -> &'static [&'static str] {
        &["c", "h"]
    }

    fn main_file(&self, model: &str, equations: &str) -> String {
        format!("{model}_{equations}.h")
    }

    fn files(&self, module: &Module<'_>) -> Vec<(String, String)> {
        let stem = stem(module);
        vec![(format!("{stem}.h"), c_header_text(module)), (format!("{stem}.c"), c_source_text(module))]
    }

    fn shared_files(&self, origin: &str) -> Vec<(String, String)> {
        let mut writer = CodeWriter::new(self, Comments::Written);
        writer.origin(origin);
        writer.write_unbroken("//");
        vec![("tripos.h".to_owned(), writer.out + SHARED)]
    }

    fn composites(&self) -> &'static [CompositeFunction] {
        &[CompositeFunction::Unknowns, CompositeFunction::Reactions, CompositeFunction::Project]
    }
}

/// Returns the text with which the names of a module's files and functions begin, such as `disk_kane`.
fn stem(module: &Module<'_>) -> String {
    format!("{}_{}", module.model_word, module.equations_word)
}

/// Returns the text of the C header: lengths of arrays, indices of the parameters, and
/// declarations.
fn c_header_text(module: &Module<'_>) -> String {
    let (stem, mut writer) = (stem(module), CodeWriter::new(&C, Comments::Written));
    let upper = stem.to_ascii_uppercase();
    let usage = format!(
        "Arrays have the lengths that the declarations state; the parameters p are in the order of {upper}_P_*. \
         Matrices are row by row. No function allocates or keeps anything."
    );
    module.header(&mut writer, &module.title(), &usage);
    writer.write_unbroken(&format!("#ifndef {upper}_H\n#define {upper}_H\n\n#include \"tripos.h\"\n"));
    writer.write_unbroken("#ifdef __cplusplus\nextern \"C\" {\n#endif");
    writer.write_empty_line();
    let (model, e) = (module.model(), module.equations());
    let lengths = [
        ("PARAMETERS", model.parameters.len()),
        ("COORDINATES", e.coordinates.len()),
        ("VARIABLES", e.variables.len()),
        ("UNKNOWNS", e.unknowns.len()),
        ("DIVISORS", module.plan.divisors.len()),
        ("CONSTRAINTS", module.plan.constraints.len()),
        ("CONDITIONS", module.plan.conditions.len()),
    ];
    let further = module.plan.further.iter();
    let further = further.map(|(title, names)| (title.to_ascii_uppercase().replace(' ', "_"), names.len()));
    let lengths: Vec<(String, usize)> =
        lengths.iter().map(|(name, length)| ((*name).to_owned(), *length)).chain(further).collect();
    writer.write_unbroken("enum {");
    for (at, (name, length)) in lengths.iter().enumerate() {
        let comma = if at + 1 < lengths.len() { "," } else { "" };
        writer.write_unbroken(&format!("  {upper}_{name} = {length}{comma}"));
    }
    writer.write_unbroken("};");
    writer.write_empty_line();
    if !model.parameters.is_empty() {
        writer.comment("Places of the parameters in p.");
        writer.write_unbroken("enum {");
        writer.indent("  ");
        let words = module.parameter_words();
        for (at, (word, meaning)) in words.iter().zip(module.parameter_meanings()).enumerate() {
            writer.comment(&meaning);
            let comma = if at + 1 < words.len() { "," } else { "" };
            writer.write_unbroken(&format!("{upper}_P_{word} = {at}{comma}"));
        }
        writer.indent("");
        writer.write_unbroken("};");
        writer.write_empty_line();
        writer.comment("Fills p with the values of the model file; not numbers where it states none.");
        writer.write_unbroken(&format!("void {stem}_defaults(tripos_real p[{}]);", model.parameters.len()));
    }
    for function in &module.plan.functions {
        writer.write_empty_line();
        writer.comment(&function.about);
        writer.comment(&format!("{}.", function.cost));
        writer.line(&format!("{};", signature(module, function)));
    }
    for composite in module.composites {
        writer.write_empty_line();
        let (about, signature) = composite_signature(module, *composite);
        writer.comment(about);
        writer.line(&format!("{signature};"));
    }
    writer.write_empty_line();
    writer.write_unbroken("#ifdef __cplusplus\n}\n#endif\n\n#endif");
    writer.out
}

/// Returns the text of the C source: default parameters, planned functions, and composite functions
/// that call them.
fn c_source_text(module: &Module<'_>) -> String {
    let (stem, mut writer) = (stem(module), CodeWriter::new(&C, Comments::Written));
    writer.comment(&module.title());
    writer.comment("");
    writer.origin(module.origin);
    writer.write_empty_line();
    writer.write_unbroken(&format!("#include \"{stem}.h\""));
    if !module.model().parameters.is_empty() {
        writer.write_empty_line();
        writer.write_unbroken(&format!("void {stem}_defaults(tripos_real p[{}])\n{{", module.model().parameters.len()));
        writer.indent("  ");
        let meanings = module.parameter_meanings();
        for ((at, p), meaning) in module.model().parameters.iter().enumerate().zip(meanings) {
            let value = p.value.as_ref().map_or_else(|| C.not_a_number().to_owned(), |value| number_literal(&C, value));
            writer.comment(&meaning);
            writer.line(&format!("p[{at}] = {value};"));
        }
        writer.indent("");
        writer.write_unbroken("}");
    }
    for planned in &module.plan.functions {
        write_c_function(&mut writer, module, planned);
    }
    for composite in module.composites {
        writer.write_empty_line();
        let (_, signature) = composite_signature(module, *composite);
        writer.line(&signature);
        writer.write_unbroken("{");
        writer.indent("  ");
        write_composite_c_body(&mut writer, module, *composite);
        writer.indent("");
        writer.write_unbroken("}");
    }
    writer.out
}

/// Returns the name and length of each output array of a C function. There is none for a number, two for a pair or a
/// system, and otherwise one.
fn results(function: &Function) -> Vec<(&'static str, usize)> {
    let count = function.entries.len();
    match function.returns {
        Returns::Number => Vec::new(),
        Returns::Pair(_) | Returns::System(_) => {
            let first = function.returns.first().unwrap_or_default();
            vec![("out", first), ("out_2", count - first)]
        }
        Returns::Vector | Returns::Matrix { .. } | Returns::Table { .. } => vec![("out", count)],
    }
}

/// Returns the C signature of a planned function, without a semicolon.
fn signature(module: &Module<'_>, planned: &Function) -> String {
    let results = results(planned);
    let is_number = planned.returns == Returns::Number;
    // Only output arrays need `restrict`, the promise that they do not overlap other arrays.
    let mut arguments: Vec<String> = module
        .argument_lengths(planned)
        .iter()
        .map(|(name, length)| match length {
            Some(0) => format!("const tripos_real *{name}"),
            Some(length) => format!("const tripos_real {name}[{length}]"),
            None => format!("tripos_real {name}"),
        })
        .map(|argument| with_firm_spaces(&argument))
        .collect();
    arguments.extend(results.iter().map(|(name, _)| with_firm_spaces(&format!("tripos_real *TRIPOS_RESTRICT {name}"))));
    let returned = if is_number { "tripos_real" } else { "void" };
    format!("{returned} {}_{}({})", stem(module), planned.name, arguments.join(", "))
}

/// Writes the C definition of a planned function.
fn write_c_function(writer: &mut CodeWriter<'_>, module: &Module<'_>, planned: &Function) {
    writer.write_empty_line();
    writer.line(&signature(module, planned));
    writer.write_unbroken("{");
    writer.indent("  ");
    for argument in planned.arguments.iter().filter(|argument| !argument.is_read()) {
        writer.line(&format!("(void){};", argument.name()));
    }
    writer.declare_arguments(&planned.arguments);
    writer.program(planned, &planned.program, &[]);
    let text = |entry: &Entry| match entry {
        Entry::Zero => "0".to_owned(),
        Entry::Variable(name) => name.clone(),
    };
    if planned.returns == Returns::Number {
        writer.line(&format!("return {};", planned.entries.iter().map(text).collect::<Vec<_>>().concat()));
    }
    let mut entries = planned.entries.iter();
    for (name, length) in results(planned) {
        for (at, entry) in entries.by_ref().take(length).enumerate() {
            writer.line(&format!("{name}[{at}] = {};", text(entry)));
        }
        if length == 0 {
            writer.line(&format!("(void){name};"));
        }
    }
    writer.indent("");
    writer.write_unbroken("}");
}

/// Returns the description and the C signature of a function that calls planned functions.
fn composite_signature(module: &Module<'_>, composite: CompositeFunction) -> (&'static str, String) {
    let (stem, v) = (stem(module), module.variables_argument());
    let solving = format!(
        "int {stem}_{}({}, {}, {}, {})",
        composite.name(),
        with_firm_spaces("const tripos_real *p"),
        with_firm_spaces("const tripos_real *q"),
        with_firm_spaces(&format!("const tripos_real *{v}")),
        with_firm_spaces("tripos_real *TRIPOS_RESTRICT out")
    );
    match composite {
        CompositeFunction::Unknowns => (
            "Solves the linear system for its unknowns: the accelerations, then the reactions or multipliers. Returns 0, \
             or 1 where the matrix is singular.",
            solving,
        ),
        CompositeFunction::Reactions => (
            "Solves the linear system for its reactions alone, in their order among the unknowns. Returns 0, or 1 where \
             the matrix is singular.",
            solving,
        ),
        _ => (
            "Moves a state, or a guess of a pose, onto the constraints, by the smallest corrections. Returns 0 if the \
             constraints then hold up to rounding, else 1.",
            format!("int {stem}_project(const tripos_real *p, tripos_real *q, tripos_real *{v})"),
        ),
    }
}

/// Writes the body of a C function that calls planned functions, such as a linear solve or a projection onto
/// constraints.
fn write_composite_c_body(writer: &mut CodeWriter<'_>, module: &Module<'_>, composite: CompositeFunction) {
    let (stem, v, e) = (stem(module), module.variables_argument(), module.equations());
    let mut text = String::new();
    let n = e.unknowns.len();
    let system = format!("{stem}_mass_matrix(p, q, {v}, matrix);\n{stem}_forcing(p, q, {v}, right);\n");
    if composite == CompositeFunction::Unknowns {
        let _ = write!(
            text,
            "tripos_real matrix[{}], right[{}];\n{system}return tripos_solve({n}, matrix, right, out);",
            (n * n).max(1),
            n.max(1)
        );
    } else if composite == CompositeFunction::Reactions {
        let _ = write!(
            text,
            "tripos_real matrix[{}], right[{n}], x[{n}];\nint k, failed;\n{system}\
             failed = tripos_solve({n}, matrix, right, x);\n\
             for (k = {}; k < {n}; k++) {{\n  out[k - {1}] = x[k];\n}}\nreturn failed;",
            n * n,
            e.variables.len()
        );
    } else {
        let (m, nq, nv) = (module.plan.constraints.len(), e.coordinates.len(), e.variables.len());
        let _ = write!(
            text,
            "tripos_real work[{}];\n\
             return tripos_project({m}, {nq}, {nv}, {stem}_constraints, {stem}_constraint_slopes, p, q, {v}, work);",
            m * (nq + nv + 3)
        );
    }
    text.lines().for_each(|line| writer.line(line));
}
