//! Writer of planned functions in a language with infix formulas: their statements and comments.

use super::{Syntax, WIDTH, formula};
use crate::lines::wrap;
use crate::plan::{Argument, Function, LineComments, Program, ProgramLine, Statement};
use std::fmt::Write;

/// Choice between writing and leaving out comments in generated code.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Comments {
    /// Comments are written, for people who read the code.
    Written,
    /// Comments are left out, because only programs read the code.
    LeftOut,
}

/// Writer of generated code in one language.
pub struct CodeWriter<'s> {
    /// Text of the code written so far.
    pub out: String,
    /// Syntax of the language in which code is written.
    pub syntax: &'s dyn Syntax,
    /// Choice between writing and leaving out comments.
    comments: Comments,
    /// Spaces at the beginning of each line of code that is written next.
    indent: &'static str,
}

impl<'s> CodeWriter<'s> {
    /// Returns a writer of code in a language, without any text yet.
    #[must_use]
    pub fn new(syntax: &'s dyn Syntax, comments: Comments) -> Self {
        Self { out: String::new(), syntax, comments, indent: "" }
    }

    /// Returns the choice between writing and leaving out comments.
    #[must_use]
    pub fn comments(&self) -> Comments {
        self.comments
    }

    /// Sets the spaces at the beginning of each line that is written next.
    pub fn indent(&mut self, indent: &'static str) {
        self.indent = indent;
    }

    /// Writes a comment, broken into lines. Writes nothing if comments are left out.
    pub fn comment(&mut self, text: &str) {
        if self.comments == Comments::LeftOut {
            return;
        }
        let (line, mark) = (self.syntax.escape_comment(text), self.syntax.comment_mark());
        for (at, part) in wrap(line.trim(), WIDTH - self.indent.len() - mark.len() - 1).iter().enumerate() {
            let hang = if at == 0 || part.is_empty() { "" } else { "  " };
            let _ = writeln!(self.out, "{}", format!("{}{mark} {hang}{part}", self.indent).trim_end());
        }
    }

    /// Writes the sentence on the origin of the code as a comment on one line, so that programs can
    /// find it.
    pub fn origin(&mut self, sentence: &str) {
        let _ = writeln!(self.out, "{} {}", self.syntax.comment_mark(), self.syntax.escape_comment(sentence).trim());
    }

    /// Writes an empty line. Writes nothing if comments are left out.
    pub fn write_empty_line(&mut self) {
        if self.comments == Comments::Written {
            self.out.push('\n');
        }
    }

    /// Writes a statement without breaking its lines. It may contain string literals.
    pub fn write_unbroken(&mut self, text: &str) {
        self.out += self.indent;
        self.out += text;
        self.out.push('\n');
    }

    /// Writes a statement on as many lines as it needs. It must not contain string literals.
    pub fn line(&mut self, text: &str) {
        self.syntax.statement(&mut self.out, self.indent, text);
    }

    /// Writes declarations of variables for the entries of the arguments that the function's body
    /// reads.
    pub fn declare_arguments(&mut self, arguments: &[Argument]) {
        for argument in arguments {
            match argument {
                Argument::Parameters { read } => self.declare_array_entries("p", read),
                Argument::Array { name, entries } => {
                    let read = entries.iter().enumerate().filter_map(|(at, entry)| Some((at, entry.clone()?)));
                    self.declare_array_entries(name, &read.collect::<Vec<_>>());
                }
                // An argument that is a single number already has the name of its variable.
                Argument::Number(_) => {}
            }
        }
    }

    /// Writes declarations of variables for entries of an array, given as pairs (index, variable).
    pub fn declare_array_entries(&mut self, array: &str, list: &[(usize, String)]) {
        let each = list.iter().map(|(at, name)| (name.clone(), self.syntax.entry(array, *at)));
        self.declare(&each.collect::<Vec<_>>());
    }

    /// Writes declarations of variables with their values. Writes nothing for an empty list.
    fn declare(&mut self, list: &[(String, String)]) {
        if !list.is_empty() {
            self.syntax.declare(&mut self.out, self.indent, list);
        }
    }

    /// Writes the lines and outputs of a program, with a heading for each kind of line. `more` lists variables that
    /// later code reads, in addition to those that the program reads itself.
    pub fn program(&mut self, planned: &Function, program: &Program, more: &[(usize, String)]) {
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
                ProgramLine::Circular { sine, cosine, angle } => {
                    let [sine, cosine] = [sine, cosine].map(|name| Some(name.as_str()).filter(|n| read.contains(n)));
                    self.circular(sine, cosine, &formula(self.syntax, angle));
                }
                ProgramLine::Let(step) | ProgramLine::Step(step) => self.step(step, planned.explanation),
            }
        }
        if !program.outputs.is_empty() {
            self.comment(planned.returns.heading());
        }
        for output in &program.outputs {
            self.step(output, planned.explanation);
        }
    }

    /// Writes the declarations of the sine and cosine of an angle. `None` is for a sine or cosine that no code reads.
    fn circular(&mut self, sine: Option<&str>, cosine: Option<&str>, angle: &str) {
        let both =
            sine.zip(cosine).and_then(|(sine, cosine)| self.syntax.sine_and_cosine_statements(sine, cosine, angle));
        if let Some(lines) = both {
            for text in &lines {
                self.line(text);
            }
            return;
        }
        let each = [("sin", sine), ("cos", cosine)].into_iter();
        let list = each.filter_map(|(f, name)| Some((name?.to_owned(), self.syntax.call(f, angle))));
        self.declare(&list.collect::<Vec<_>>());
    }

    /// Writes the declaration of a variable. If `explanation` asks for formulas, its equation is above it as a
    /// comment.
    fn step(&mut self, step: &Statement, explanation: LineComments) {
        if let Some(equation) = explanation.of(step) {
            self.comment(equation);
        }
        self.declare(&[(step.name.clone(), formula(self.syntax, &step.value))]);
    }
}

/// Returns the heading, for a comment, of the kind of a program's line.
fn heading(planned: &Function, line: &ProgramLine, lines: &[ProgramLine]) -> &'static str {
    let eliminates = lines.iter().any(|line| matches!(line, ProgramLine::Step(_)));
    match line {
        ProgramLine::Circular { .. } => "Sines and cosines.",
        _ if planned.explanation == LineComments::Names => "Step by step, each after the terms that it needs.",
        _ if eliminates => "Elimination, step by step, each after the terms that it shares.",
        _ => "Shared terms.",
    }
}
