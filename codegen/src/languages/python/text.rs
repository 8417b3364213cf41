//! Texts in Python modules: comments, docstrings, literals, and statements broken into lines.

use super::super::Module;
use crate::lines::wrap;
use crate::syntax::{CodeWriter, FIRM_SPACE, Syntax, WIDTH, number_literal, with_firm_spaces};
use std::fmt::Write;
use tripos_derive::algebra::Rational;
use tripos_derive::plain_text::{one_line, with_visible_characters};

/// Largest number of digits of a whole number that is written as a Python integer. A longer number
/// is written as a float.
const MOST_DIGITS: usize = 15;

/// Returns a text that is safe in a Python comment. It cannot declare an encoding, which Python would obey in the
/// first two lines of a file.
pub fn escape_python_comment(text: &str) -> String {
    with_visible_characters(&one_line(text)).replace("coding:", "coding :").replace("coding=", "coding =")
}

/// Returns the Python string literal for a text. A mark replaces each space, so that no line is broken inside the
/// literal.
pub fn string(text: &str) -> String {
    let mut out = String::from("\"");
    for c in with_visible_characters(text).chars() {
        match c {
            '"' | '\\' => out.extend(['\\', c]),
            '\n' => out.push_str("\\n"),
            c => out.push(c),
        }
    }
    out.push('"');
    with_firm_spaces(&out)
}

/// Returns a Python docstring with the given text, broken into lines.
pub fn docstring(text: &str) -> String {
    let lines: Vec<String> =
        text.split('\n').flat_map(|line| wrap(&with_visible_characters(line), WIDTH - 10)).collect();
    let escaped = lines.join("\n").replace('\\', "\\\\").replace('"', "\\\"");
    let lines: Vec<&str> = escaped.split('\n').collect();
    match lines.as_slice() {
        [one] => format!("\"\"\"{one}\"\"\""),
        many => format!("\"\"\"{}\n    \"\"\"", many.join("\n    ").replace("\n    \n", "\n\n")),
    }
}

/// Returns the Python literal of a whole number. A long number is written as a float, because arrays cannot hold long
/// integers.
pub fn python_number_literal(digits: &str) -> String {
    if digits.len() <= MOST_DIGITS {
        return digits.to_owned();
    }
    let value = Rational::parse_decimal(digits).map_or(f64::INFINITY, |value| value.to_f64());
    if value.is_finite() { format!("{value:?}") } else { "1e999".to_owned() }
}

/// Writes one Python statement that assigns a value to each of several variables.
pub fn write_python_declarations(out: &mut String, indent: &str, list: &[(String, String)]) {
    let names: Vec<&str> = list.iter().map(|(name, _)| name.as_str()).collect();
    let values: Vec<&str> = list.iter().map(|(_, value)| value.as_str()).collect();
    write_python_assignment(out, indent, &names, &values.join(", "));
}

/// Writes a Python statement that assigns an expression to one or several variables. A long list of variables gets
/// lines of its own.
pub fn write_python_assignment(out: &mut String, indent: &str, names: &[&str], expression: &str) {
    let list = names.join(", ");
    let is_long = indent.len() + list.len() + 3 + expression.len() > WIDTH;
    if is_long && names.len() > 1 && list.len() + 3 > WIDTH / 2 {
        let _ = writeln!(out, "{indent}(");
        write_python_lines(out, indent, &list);
        let _ = writeln!(out, "{indent}) = (");
        write_python_lines(out, indent, expression);
        let _ = writeln!(out, "{indent})");
    } else {
        write_python_expression(out, indent, &format!("{list} = "), expression);
    }
}

/// Writes a Python statement that consists of `beginning` and an expression. The expression is put in parentheses if
/// it needs several lines.
pub fn write_python_expression(out: &mut String, indent: &str, beginning: &str, expression: &str) {
    if indent.len() + beginning.len() + expression.len() <= WIDTH {
        let _ = writeln!(out, "{indent}{beginning}{expression}");
        return;
    }
    let _ = writeln!(out, "{indent}{beginning}(");
    write_python_lines(out, indent, expression);
    let _ = writeln!(out, "{indent})");
}

/// Writes a text in lines of limited width, indented by four more spaces.
fn write_python_lines(out: &mut String, indent: &str, text: &str) {
    for part in wrap(text, WIDTH - indent.len() - 4) {
        let _ = writeln!(out, "{indent}    {part}");
    }
}

/// Writes a list of entries between `opening` and `ending`, on as many lines as it needs.
pub fn write_python_array(writer: &mut CodeWriter<'_>, opening: &str, entries: &[String], ending: &str) {
    let list = entries.join(", ");
    let soft = |text: &str| text.replace(FIRM_SPACE, " ");
    if opening.len() + list.len() + ending.len() + 4 <= WIDTH {
        writer.write_unbroken(&soft(&format!("{opening}{list}{ending}")));
        return;
    }
    writer.write_unbroken(opening);
    for part in wrap(&list, WIDTH - 8) {
        writer.write_unbroken(&soft(&format!("    {part}")));
    }
    writer.write_unbroken(ending);
}

/// Writes the names and default values of a module as Python lists. `missing` is the text for a
/// parameter whose value the model file does not state.
pub fn write_python_names_and_values(writer: &mut CodeWriter<'_>, module: &Module<'_>, missing: &str) {
    let (model, e) = (module.model(), module.equations());
    let list = |writer: &mut CodeWriter<'_>, name: &str, entries: &[String]| {
        write_python_array(writer, &format!("{name} = ["), entries, "]");
    };
    module.parameter_meanings().iter().for_each(|meaning| writer.comment(meaning));
    let strings = |names: &mut dyn Iterator<Item = &str>| names.map(string).collect::<Vec<_>>();
    list(writer, "PARAMETERS", &strings(&mut model.parameters.iter().map(|p| p.name.as_str())));
    list(writer, "UNITS", &model.parameters.iter().map(|p| string(&p.unit.to_string())).collect::<Vec<_>>());
    writer.comment("Values that the model file states.");
    let syntax: &dyn Syntax = writer.syntax;
    let value = |p: &tripos_derive::model::Parameter| {
        p.value.as_ref().map_or_else(|| missing.to_owned(), |value| number_literal(syntax, value))
    };
    list(writer, "DEFAULTS", &model.parameters.iter().map(value).collect::<Vec<_>>());
    let inputs = model.parameters.iter().filter(|p| p.is_input);
    list(writer, "INPUTS", &strings(&mut inputs.map(|p| p.name.as_str())));
    list(writer, "COORDINATES", &strings(&mut model.coordinates.iter().map(|c| c.name.as_str())));
    let arena = module.planner.arena;
    list(writer, "VARIABLES", &strings(&mut e.variables.iter().filter_map(|v| arena.symbol_name(*v))));
    let named = [
        ("UNKNOWNS", &module.plan.unknowns),
        ("DIVISORS", &module.plan.divisors),
        ("CONSTRAINTS", &module.plan.constraints),
        ("CONDITIONS", &module.plan.conditions),
    ];
    for (name, names) in named {
        list(writer, name, &strings(&mut names.iter().map(String::as_str)));
    }
    for (title, names) in &module.plan.further {
        let name = title.to_ascii_uppercase().replace(' ', "_");
        list(writer, &name, &strings(&mut names.iter().map(String::as_str)));
    }
}
