//! Module of one set of equations: its plan and its names, before it is written in a language.

use super::CompositeFunction;
use crate::plan::{Argument, Function, ModulePlan, Planner, variable_name_without_primes};
use crate::syntax::CodeWriter;
use rustc_hash::FxHashSet;
use tripos_derive::{Equations, Model};

/// Contents of a generated module for one set of equations: planned functions, names and origin.
pub struct Module<'a> {
    /// Word for the model in names of files and functions: letters, digits and underscores.
    pub model_word: &'a str,
    /// Word for the set of equations in names of files and functions: letters, digits and
    /// underscores.
    pub equations_word: &'a str,
    /// Planner of the functions. It holds the model, the arena and the equations.
    pub planner: &'a Planner<'a>,
    /// Plan with the functions that the module contains.
    pub plan: &'a ModulePlan,
    /// Functions written in addition to the planned functions, which they call.
    pub composites: &'a [CompositeFunction],
    /// Sentence of the header that names the origin of the module.
    pub origin: &'a str,
}

impl Module<'_> {
    /// Returns the model to which the module's equations belong.
    #[must_use]
    pub fn model(&self) -> &Model {
        self.planner.model
    }

    /// Returns the set of equations of motion that the module contains.
    #[must_use]
    pub fn equations(&self) -> &Equations {
        self.planner.equations
    }

    /// Returns the argument name for the motion variables: `q_dot` for equations in rates of the
    /// coordinates, `u` for generalized speeds.
    #[must_use]
    pub fn variables_argument(&self) -> &'static str {
        if self.equations().formulation.is_in_rates() { "q_dot" } else { "u" }
    }

    /// Returns one sentence with the title of the model, the name of the equations, and the matrix equation that they
    /// solve.
    #[must_use]
    pub fn title(&self) -> String {
        let (model, e) = (self.model(), self.equations());
        format!("{}: {}, {}.", model.title, e.title(model), e.formulation.equation(model))
    }

    /// Writes the comments at the beginning of a file: title, origin, facts on the equations, and
    /// orders of arguments and results.
    pub fn header(&self, writer: &mut CodeWriter<'_>, title: &str, usage: &str) {
        let (model, e) = (self.model(), self.equations());
        writer.comment(title);
        writer.comment("");
        writer.origin(self.origin);
        self.plan.facts.iter().for_each(|fact| writer.comment(fact));
        writer.comment("");
        let list = |names: &mut dyn Iterator<Item = &str>| names.collect::<Vec<_>>().join(", ");
        let of_arena = |symbols: &[tripos_derive::algebra::Expr]| {
            list(&mut symbols.iter().filter_map(|symbol| self.planner.arena.symbol_name(*symbol)))
        };
        writer.comment(&format!("Coordinates q: {}.", list(&mut model.coordinates.iter().map(|c| c.name.as_str()))));
        writer.comment(&format!("Motion variables {}: {}.", self.variables_argument(), of_arena(&e.variables)));
        let named = [
            ("Divisors", &self.plan.divisors),
            ("Constraints", &self.plan.constraints),
            ("Conditions", &self.plan.conditions),
        ];
        for (what, names) in named {
            if !names.is_empty() {
                writer.comment(&format!("{what}: {}.", names.join("; ")));
            }
        }
        for (what, names) in &self.plan.further {
            writer.comment(&format!("{what}: {}.", names.join("; ")));
        }
        writer.comment("");
        writer.comment(usage);
    }

    /// Returns a different word for each parameter: letters, digits and underscores, with a letter at the front.
    #[must_use]
    pub fn parameter_words(&self) -> Vec<String> {
        let mut taken = FxHashSet::default();
        let unique = |p: &tripos_derive::model::Parameter| {
            let word = module_identifier_word(&variable_name_without_primes(&p.name));
            let mut candidates = std::iter::once(word.clone()).chain((2..).map(|n| format!("{word}_{n}")));
            let found = candidates.find(|name| !taken.contains(name)).expect("numbers do not end");
            taken.insert(found.clone());
            found
        };
        self.model().parameters.iter().map(unique).collect()
    }

    /// Returns a comment for each parameter: its name, its description, a remark if it is an input, and its unit.
    #[must_use]
    pub fn parameter_meanings(&self) -> Vec<String> {
        let meaning = |p: &tripos_derive::model::Parameter| {
            let about = if p.about.is_empty() { "parameter" } else { &p.about };
            let input = if p.is_input { ", an input" } else { "" };
            format!("{}: {about}{input}, {}", p.name, p.unit)
        };
        self.model().parameters.iter().map(meaning).collect()
    }

    /// Returns the name and length of each argument of a function, in the order of its signature.
    /// The length is `None` for a number.
    #[must_use]
    pub fn argument_lengths<'f>(&self, function: &'f Function) -> Vec<(&'f str, Option<usize>)> {
        let length = |argument: &Argument| match argument {
            Argument::Parameters { .. } => Some(self.model().parameters.len()),
            Argument::Array { entries, .. } => Some(entries.len()),
            Argument::Number(_) => None,
        };
        function.arguments.iter().map(|argument| (argument.name(), length(argument))).collect()
    }
}

/// Returns a word for a text in names: all characters except letters and digits become underscores. `m_` is put in
/// front unless the text begins with a letter.
#[must_use]
pub fn module_identifier_word(text: &str) -> String {
    let spelled: String = text.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '_' }).collect();
    if spelled.starts_with(|c: char| c.is_ascii_alphabetic()) { spelled } else { format!("m_{spelled}") }
}
