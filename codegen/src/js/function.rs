//! JavaScript function for a planned function.

use super::expression::expression;
use super::text::{comment, statement};
use crate::plan::{Argument, Entry, Function, Line, Parts, Program, Returns, Statement};

/// Choice whether the code contains comments.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Comments {
    /// Comments are written, for people.
    Written,
    /// Comments are left out, for browsers.
    LeftOut,
}

/// Writer of JavaScript functions.
pub struct Writer {
    /// Text written so far.
    pub out: String,
    comments: Comments,
    indent: &'static str,
}

impl Writer {
    /// Writer with no text written.
    #[must_use]
    pub fn new(comments: Comments) -> Self {
        Self { out: String::new(), comments, indent: "" }
    }

    /// Choice whether comments are written.
    #[must_use]
    pub fn comments(&self) -> Comments {
        self.comments
    }

    /// Writes a comment on the following code, if comments are written.
    pub fn comment(&mut self, text: &str) {
        if self.comments == Comments::Written {
            comment(&mut self.out, self.indent, text);
        }
    }

    /// Writes an empty line, if comments are written.
    pub fn gap(&mut self) {
        if self.comments == Comments::Written {
            self.out.push('\n');
        }
    }

    /// Writes a statement that may contain string literals, without line breaks.
    pub fn raw(&mut self, text: &str) {
        self.out += text;
        self.out.push('\n');
    }

    /// Writes a statement without string literals, on as many lines as it needs.
    pub fn line(&mut self, text: &str) {
        statement(&mut self.out, self.indent, text);
    }

    /// Writes a planned function, after the functions of its parts.
    pub fn function(&mut self, planned: &Function) {
        if let Some(parts) = &planned.parts {
            self.parts(planned, parts);
        }
        self.gap();
        self.comment(&planned.about);
        self.comment(&format!("{}.", planned.cost));
        let arguments: Vec<&str> = planned.arguments.iter().map(Argument::name).collect();
        self.line(&format!("export function {}({}) {{", planned.name, arguments.join(", ")));
        self.indent = "  ";
        match &planned.parts {
            Some(parts) => {
                self.line(&format!("const values = new Array({}).fill(0);", parts.places));
                let given = given(planned);
                for at in 1..=parts.list.len() {
                    self.line(&format!("{}({}values);", part_name(planned, at), given));
                }
                self.unpack(&parts.arguments);
                self.taken("values", &parts.results);
            }
            None => {
                self.unpack(&planned.arguments);
                self.program(planned, &planned.program, &[]);
            }
        }
        self.line(&format!("return {};", result(planned.returns, &planned.entries)));
        self.indent = "";
        self.line("}");
    }

    /// Writes a long program as one function for each part. A part passes values to later parts in an array.
    fn parts(&mut self, planned: &Function, parts: &Parts) {
        for (at, part) in parts.list.iter().enumerate() {
            self.gap();
            self.line(&format!("function {}({}values) {{", part_name(planned, at + 1), given(planned)));
            self.indent = "  ";
            self.unpack(&part.arguments);
            self.taken("values", &part.reads);
            self.program(planned, &part.program, &part.writes);
            for (place, name) in &part.writes {
                self.line(&format!("values[{place}] = {name};"));
            }
            self.indent = "";
            self.line("}");
        }
    }

    /// Declares variables for the entries that the body reads of its arguments.
    fn unpack(&mut self, arguments: &[Argument]) {
        for argument in arguments {
            match argument {
                Argument::Parameters { read } => self.taken("p", read),
                Argument::Array { name, entries } => {
                    let read = entries.iter().enumerate().filter_map(|(at, entry)| Some((at, entry.clone()?)));
                    self.taken(name, &read.collect::<Vec<_>>());
                }
                // An argument that is a number already has the name of its variable.
                Argument::Number(_) => {}
            }
        }
    }

    /// Declares variables for entries of an array, given as (index, variable).
    fn taken(&mut self, array: &str, list: &[(usize, String)]) {
        let each: Vec<String> = list.iter().map(|(at, name)| format!("{name} = {array}[{at}]")).collect();
        if !each.is_empty() {
            self.line(&format!("const {};", each.join(", ")));
        }
    }

    /// Writes the lines and outputs of a program, with one heading for each kind of line. The code after the program
    /// reads the variables in `more`.
    fn program(&mut self, planned: &Function, program: &Program, more: &[(usize, String)]) {
        let mut read = program.names_read(0..usize::MAX);
        read.extend(more.iter().map(|(_, name)| name.as_str()));
        let mut headings = Vec::new();
        for line in &program.lines {
            let wanted = heading(planned, line, &program.lines);
            if !headings.contains(&wanted) {
                headings.push(wanted);
                self.comment(wanted);
            }
            match line {
                Line::Circular { sine, cosine, angle } => {
                    let of = |name: &str, f: &str| format!("{name} = Math.{f}({})", expression(angle));
                    let both =
                        [(sine, "sin"), (cosine, "cos")].into_iter().filter(|(name, _)| read.contains(name.as_str()));
                    let both: Vec<String> = both.map(|(name, f)| of(name, f)).collect();
                    if !both.is_empty() {
                        self.line(&format!("const {};", both.join(", ")));
                    }
                }
                Line::Let(step) | Line::Step(step) => self.step(step, planned.explained),
            }
        }
        if !program.outputs.is_empty() {
            self.comment(planned.returns.heading());
        }
        for output in &program.outputs {
            self.step(output, planned.explained);
        }
    }

    fn step(&mut self, step: &Statement, explained: bool) {
        if let Some(equation) = step.comment.as_deref().filter(|_| explained) {
            self.comment(equation);
        }
        self.line(&format!("const {} = {};", step.name, expression(&step.value)));
    }
}

fn heading(planned: &Function, line: &Line, lines: &[Line]) -> &'static str {
    let eliminates = lines.iter().any(|line| matches!(line, Line::Step(_)));
    match line {
        Line::Circular { .. } => "Sines and cosines.",
        _ if !planned.explained => "Step by step, each after the terms that it needs.",
        _ if eliminates => "Elimination, step by step, each after the terms that it shares.",
        _ => "Shared terms.",
    }
}

/// Name of the function of a part. No name of a model contains a `$`.
fn part_name(planned: &Function, at: usize) -> String {
    format!("{}$part{at}", planned.name)
}

/// Arguments that parts get before the array `values`, each followed by a comma.
fn given(planned: &Function) -> String {
    planned.arguments.iter().flat_map(|argument| [argument.name(), ", "]).collect()
}

/// The `return` value of a function, as an expression: a number, an array, a pair of arrays, or an array of rows.
fn result(returns: Returns, entries: &[Entry]) -> String {
    let names: Vec<&str> = entries.iter().map(|e| if let Entry::Variable(name) = e { name } else { "0" }).collect();
    let array = |list: &[&str]| format!("[{}]", list.join(", "));
    match returns {
        Returns::Number => names.concat(),
        Returns::Vector => array(&names),
        Returns::Pair(first) => format!("[{}, {}]", array(&names[..first]), array(&names[first..])),
        Returns::Matrix { .. } => {
            let rows: Vec<String> = names.chunks(names.len().isqrt().max(1)).map(array).collect();
            format!("[{}]", rows.join(", "))
        }
    }
}
