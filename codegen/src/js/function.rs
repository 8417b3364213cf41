//! Text of a JavaScript function for a planned function.

use super::syntax::JavaScript;
use crate::plan::{Argument, Entry, Function, Parts, Returns};
use crate::syntax::{CodeWriter, Comments};

/// Writer of planned functions as JavaScript text.
pub struct JavaScriptFunctionWriter {
    /// Writer of lines, which contains the text of the functions written so far.
    pub lines: CodeWriter<'static>,
}

impl JavaScriptFunctionWriter {
    /// Returns a writer of JavaScript functions, without any text yet. `comments` says if comments
    /// are written.
    #[must_use]
    pub fn new(comments: Comments) -> Self {
        Self { lines: CodeWriter::new(&JavaScript, comments) }
    }

    /// Writes a planned function. If it is long, the functions of its parts come first.
    pub fn function(&mut self, planned: &Function) {
        if let Some(parts) = &planned.parts {
            self.parts(planned, parts);
        }
        self.lines.write_empty_line();
        self.lines.comment(&planned.about);
        self.lines.comment(&format!("{}.", planned.cost));
        let arguments: Vec<&str> = planned.arguments.iter().map(Argument::name).collect();
        self.lines.line(&format!("export function {}({}) {{", planned.name, arguments.join(", ")));
        self.lines.indent("  ");
        match &planned.parts {
            Some(parts) => {
                self.lines.line(&format!("const values = new Array({}).fill(0);", parts.places));
                let given = javascript_part_arguments(planned);
                for at in 1..=parts.list.len() {
                    self.lines.line(&format!("{}({}values);", javascript_part_name(planned, at), given));
                }
                self.lines.declare_arguments(&parts.arguments);
                self.lines.declare_array_entries("values", &parts.results);
            }
            None => {
                self.lines.declare_arguments(&planned.arguments);
                self.lines.program(planned, &planned.program, &[]);
            }
        }
        self.lines.line(&format!("return {};", javascript_return_expression(planned.returns, &planned.entries)));
        self.lines.indent("");
        self.lines.line("}");
    }

    /// Writes a long program as one function for each part. Each part passes values to later parts
    /// in the array `values`.
    fn parts(&mut self, planned: &Function, parts: &Parts) {
        for (at, part) in parts.list.iter().enumerate() {
            self.lines.write_empty_line();
            self.lines.line(&format!(
                "function {}({}values) {{",
                javascript_part_name(planned, at + 1),
                javascript_part_arguments(planned)
            ));
            self.lines.indent("  ");
            self.lines.declare_arguments(&part.arguments);
            self.lines.declare_array_entries("values", &part.reads);
            self.lines.program(planned, &part.program, &part.writes);
            for (place, name) in &part.writes {
                self.lines.line(&format!("values[{place}] = {name};"));
            }
            self.lines.indent("");
            self.lines.line("}");
        }
    }
}

/// Returns the name of the function for the part with the number `at`, counted from 1. It contains a `$`, which no
/// name of a model contains.
fn javascript_part_name(planned: &Function, at: usize) -> String {
    format!("{}$part{at}", planned.name)
}

/// Returns the arguments of a long function as text, each followed by a comma. The functions of its parts take the
/// same arguments.
fn javascript_part_arguments(planned: &Function) -> String {
    planned.arguments.iter().flat_map(|argument| [argument.name(), ", "]).collect()
}

/// Returns the expression after `return`: a number, an array, a pair of arrays, or an array of
/// rows.
fn javascript_return_expression(returns: Returns, entries: &[Entry]) -> String {
    let names: Vec<&str> = entries.iter().map(|e| if let Entry::Variable(name) = e { name } else { "0" }).collect();
    let array = |list: &[&str]| format!("[{}]", list.join(", "));
    let rows = |columns: usize| {
        let rows: Vec<String> = names.chunks(columns.max(1)).map(array).collect();
        format!("[{}]", rows.join(", "))
    };
    match returns {
        Returns::Number => names.concat(),
        Returns::Vector => array(&names),
        Returns::Pair(_) | Returns::System(_) => {
            let (front, back) = names.split_at(returns.first().unwrap_or_default());
            format!("[{}, {}]", array(front), array(back))
        }
        Returns::Matrix { .. } => rows(names.len().isqrt()),
        Returns::Table { columns } => rows(columns),
    }
}
