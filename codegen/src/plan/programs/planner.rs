//! Planner that turns terms of one set of equations into planned functions for a target language.

use super::arguments::{Argument, Entry};
use super::cost::OperationCount;
use super::function::{Arguments, Function, LineComments, Returns, Value};
use super::program::{Output, Program, program};
use super::program_parts::Parts;
use super::variable_names::{Language, SymbolVariableNames, type_name};
use rustc_hash::FxHashSet;
use tripos_derive::algebra::form::sharing::{SharingOptions, is_equivalent_after_sharing, share_common_parts};
use tripos_derive::algebra::form::simplify::Simplifier;
use tripos_derive::algebra::term::steps::{Definition, needed_steps};
use tripos_derive::algebra::{Arena, Expr};
use tripos_derive::{Equations, Model};

/// Largest number of named terms in equations for which all readings of their terms are tried, when common operations
/// are searched. For more named terms, a single reading is tried.
const MOST_READ: usize = 100;

/// Largest number of lines of a program in which each line always gets its formula as a comment.
const MOST_LINES: usize = 20;

/// Planner of functions: turns terms of one set of equations into planned functions for a target
/// language.
pub struct Planner<'a> {
    /// Model to which the equations belong.
    pub model: &'a Model,
    /// Arena with the terms of the equations.
    pub arena: &'a Arena,
    /// Set of equations whose functions are planned.
    pub equations: &'a Equations,
    /// Names of the variables for the symbols, as the target language permits them.
    pub variables: SymbolVariableNames,
    /// Choice between sharing common operations of several outputs and computing formulas as they
    /// stand.
    pub sharing: Sharing,
}

/// Choice between sharing common operations of several outputs and computing formulas as they
/// stand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sharing {
    /// Common operations are found and computed only once.
    Shared,
    /// Formulas are computed as they stand. This serves printed equations, which must run with
    /// their own cancellations.
    AsStated,
}

impl<'a> Planner<'a> {
    /// Prepares a planner for a set of equations, and gives each symbol a variable name that the
    /// language permits.
    #[must_use]
    pub fn new(
        model: &'a Model,
        arena: &'a Arena,
        equations: &'a Equations,
        language: &Language,
        sharing: Sharing,
    ) -> Self {
        let mut variables = SymbolVariableNames::new(arena, language, &type_name(&equations.name(model)));
        let rates = model.coordinates.iter().map(|c| c.rate).chain(model.speeds.iter().map(|s| s.rate));
        let unknown = &equations.unknowns[..equations.variables.len()];
        variables.moving = equations.variables.iter().chain(unknown).copied().chain(rates).collect();
        Self { model, arena, equations, variables, sharing }
    }

    /// Returns the comments for long programs: formulas, or none if the equations consist mostly of named terms.
    #[must_use]
    pub fn explanation(&self) -> LineComments {
        if self.equations.definitions.len() <= MOST_READ { LineComments::Formulas } else { LineComments::Names }
    }

    /// Plans a function whose values need no intermediate steps. `about` describes the result.
    #[must_use]
    pub fn plan_function(
        &self,
        name: &'static str,
        about: &str,
        arguments: Arguments,
        returns: Returns,
        values: &[Value],
    ) -> Function {
        self.plan_function_in_steps(name, about, arguments, returns, &[], values)
    }

    /// Plans a function that first computes named intermediate steps and then its values. Entries that are 0, and the
    /// lower triangle of a symmetric matrix, are not computed. Steps that no value needs are left out.
    #[must_use]
    pub fn plan_function_in_steps(
        &self,
        name: &'static str,
        about: &str,
        arguments: Arguments,
        returns: Returns,
        steps: &[Definition],
        values: &[Value],
    ) -> Function {
        // If a step has the value 0, the values contain 0 in its place.
        let is_zero = |e: Expr| steps.iter().any(|step| step.symbol == e && step.value == Expr::ZERO);
        let results: Vec<Expr> = values.iter().map(|(.., e)| if is_zero(*e) { Expr::ZERO } else { *e }).collect();
        let steps = needed_steps(self.arena, steps, &results);
        let places: Vec<usize> =
            (0..values.len()).map(|at| returns.entry_of_upper_triangle(at, values.len())).collect();
        let is_step = |e: Expr| steps.iter().any(|step| step.symbol == e);
        let is_output = |at: usize| places[at] == at && results[at] != Expr::ZERO && !is_step(results[at]);
        let outputs = values.iter().enumerate().filter(|(at, _)| is_output(*at)).map(|(_, (name, label, value))| {
            Output { name: name.clone(), label: label.clone(), value: *value, stated: *value }
        });
        let program = self.cheapest_program(&steps, &outputs.collect::<Vec<_>>(), &results);
        let mut computed = program.outputs.iter().map(|output| &output.name);
        let entries: Vec<Entry> = results
            .iter()
            .enumerate()
            .map(|(at, e)| {
                let own = if is_output(at) { computed.next() } else { None };
                match own.or_else(|| self.variables.of.get(e)) {
                    Some(name) if *e != Expr::ZERO => Entry::Variable(name.clone()),
                    _ => Entry::Zero,
                }
            })
            .collect();
        let entries: Vec<Entry> = places.iter().map(|at| entries[*at].clone()).collect();
        let arguments = self.arguments(arguments, &program.inputs);
        let cost = OperationCount::of(&program);
        let parts = Parts::of(&program, &arguments, &entries);
        let is_short = program.equations().count() <= MOST_LINES;
        let explanation = if is_short { LineComments::Formulas } else { self.explanation() };
        Function { name, about: about.to_owned(), arguments, returns, program, entries, parts, cost, explanation }
    }

    /// Returns the cheapest program for the given outputs. It is either the program as given, or one that shares
    /// common sums and products by one reading of the terms. A rewritten program is used only if it is proved equal.
    fn cheapest_program(&self, steps: &[Definition], outputs: &[Output], results: &[Expr]) -> Program {
        let mut best = program(self.arena, &self.variables, steps, steps, outputs, results);
        let mut least = OperationCount::of(&best).weight();
        if self.sharing == Sharing::AsStated {
            return best;
        }
        let values: Vec<Expr> = outputs.iter().map(|o| o.value).collect();
        // Named terms are short, and all readings of them are equal.
        let readings = match self.explanation() {
            LineComments::Formulas => &SharingOptions::ALL[..],
            LineComments::Names => &SharingOptions::COMMON_OPTIONS[..1],
        };
        for &reading in readings {
            let mut arena = self.arena.clone();
            let shared = share_common_parts(&mut arena, &mut Simplifier::default(), reading, steps, &values);
            let Some(shared) = shared else { continue };
            let rewritten = outputs.iter().zip(&shared.values).map(|(o, value)| Output { value: *value, ..o.clone() });
            let rewritten: Vec<Output> = rewritten.collect();
            let candidate = program(&arena, &self.variables, &shared.steps, steps, &rewritten, results);
            let weight = OperationCount::of(&candidate).weight();
            // A cheaper program is used only if it is proved equal to the planned one.
            if weight < least && is_equivalent_after_sharing(&mut arena, steps, &values, &shared) {
                (best, least) = (candidate, weight);
            }
        }
        best
    }

    /// Returns the list of arguments of a kind. Only entries that occur in `inputs` get variables.
    fn arguments(&self, arguments: Arguments, inputs: &FxHashSet<Expr>) -> Vec<Argument> {
        let e = self.equations;
        let array = |name: &'static str, symbols: &[Expr]| {
            let variable = |s: &Expr| inputs.contains(s).then(|| self.variables.of[s].clone());
            Argument::Array { name, entries: symbols.iter().map(variable).collect() }
        };
        let own = if e.formulation.is_in_rates() { "q_dot" } else { "u" };
        let mut list = vec![self.parameters(inputs)];
        if let Arguments::Shown { time } = arguments {
            list.push(Argument::Number(self.variables.of.get(&time).filter(|_| inputs.contains(&time)).cloned()));
        }
        if arguments != Arguments::Parameters {
            list.push(array("q", &e.coordinates));
        }
        match arguments {
            Arguments::Configuration | Arguments::Parameters => {}
            Arguments::Speeds => list.push(array("u", &self.model.u())),
            Arguments::State
            | Arguments::StateAndRates
            | Arguments::StateAndUnknowns
            | Arguments::Balanced
            | Arguments::Shown { .. } => {
                list.push(array(own, &e.variables));
            }
        }
        if arguments == Arguments::StateAndRates {
            list.push(array("v_dot", &e.unknowns[..e.variables.len()]));
        }
        if arguments == Arguments::StateAndUnknowns {
            list.push(array("x", &e.unknowns));
        }
        if arguments == Arguments::Balanced {
            list.push(array("r", &self.model.reactions.iter().map(|r| r.symbol).collect::<Vec<_>>()));
        }
        list
    }

    /// Returns the argument for all parameters. Only parameters that occur in `inputs` get
    /// variables.
    pub(crate) fn parameters(&self, inputs: &FxHashSet<Expr>) -> Argument {
        let all = &self.model.parameters;
        let read = all.iter().enumerate().filter(|(_, p)| inputs.contains(&p.symbol));
        Argument::Parameters { read: read.map(|(at, p)| (at, self.variables.of[&p.symbol].clone())).collect() }
    }
}
