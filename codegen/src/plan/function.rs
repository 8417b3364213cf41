//! Plan of one function: its arguments, its steps in order, its return value, and its cost.

use super::arguments::{Argument, Entry};
use super::cost::Cost;
use super::names::{Language, Variables, type_name};
use super::parts::Parts;
use super::program::{Output, Program, Statement, program};
use rustc_hash::FxHashSet;
use tripos_derive::algebra::form::sharing::{Reading, is_same, share};
use tripos_derive::algebra::form::simplify::Simplifier;
use tripos_derive::algebra::term::steps::{Definition, needed};
use tripos_derive::algebra::{Arena, Expr};
use tripos_derive::{Equations, Model};

/// Most named terms of equations whose programs are rewritten by all readings of their terms. With more, a single
/// reading is tried.
const MOST_READ: usize = 100;

/// Most lines of a program whose formulas are always written as comments.
const MOST_LINES: usize = 20;

/// Function planned independently of a language.
#[derive(Clone, Debug)]
pub struct Function {
    /// Name of the function.
    pub name: &'static str,
    /// Description of the result, as a sentence.
    pub about: String,
    /// Arguments in the order of the signature.
    pub arguments: Vec<Argument>,
    /// Shape of the return value.
    pub returns: Returns,
    /// Steps of the computation.
    pub program: Program,
    /// Entries of the return value, in order.
    pub entries: Vec<Entry>,
    /// Parts of the program if it is long; `None` if it stays whole.
    pub parts: Option<Parts>,
    /// Operations of one call of the function.
    pub cost: Cost,
    /// Comments on the lines of the program.
    pub explanation: Explanation,
}

/// Comments on the lines of a program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Explanation {
    /// Each line has its formula above it as a comment.
    Formulas,
    /// No line has a comment. Most lines are named terms, whose names are enough.
    Names,
}

impl Explanation {
    /// Formula of a statement, if it stands above the statement as a comment.
    #[must_use]
    pub fn of(self, statement: &Statement) -> Option<&str> {
        statement.comment.as_deref().filter(|_| self == Self::Formulas)
    }
}

/// Kinds of argument lists that planned functions have.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Arguments {
    /// Arguments (p, q, v): parameters, coordinates and motion variables.
    State,
    /// Arguments (p, q, u): parameters, coordinates and generalized speeds.
    Speeds,
    /// Arguments (p, q, v, v̇): the state with the rates of the motion variables.
    StateAndRates,
    /// Arguments (p, q, v, x): the state with the unknowns of the linear system.
    StateAndUnknowns,
    /// Arguments (p, q): parameters and coordinates, without motion variables.
    Configuration,
    /// Argument p alone: the parameters.
    Parameters,
    /// Arguments (p, q, v, r): the state with the reactions in the order of the model.
    Balanced,
    /// Arguments (p, t, q, v): the state with the time, for outputs.
    Shown {
        /// Symbol of the time.
        time: Expr,
    },
}

/// Shape of the return value of a function.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Returns {
    /// Single number.
    Number,
    /// Array of all entries.
    Vector,
    /// Two arrays: the first has this length, the second contains the other entries.
    Pair(usize),
    /// Square matrix with this many rows, row by row, and as an array of its own a vector of this length.
    System(usize),
    /// Square array, row by row. A symmetric one is computed from its upper triangle.
    Matrix {
        /// True if the matrix equals its transpose.
        symmetric: bool,
    },
    /// Rectangular array, row by row.
    Table {
        /// Number of columns.
        columns: usize,
    },
}

impl Returns {
    /// Heading above the lines that compute the entries.
    #[must_use]
    pub fn heading(self) -> &'static str {
        match self {
            Self::Matrix { symmetric: true } => "Entries that are not zero; upper triangle.",
            Self::Matrix { .. } | Self::Table { .. } => "Entries that are not zero.",
            _ => "Values.",
        }
    }

    /// Number of entries of the first of two results; `None` if there is one result.
    #[must_use]
    pub fn first(self) -> Option<usize> {
        match self {
            Self::Pair(first) => Some(first),
            Self::System(side) => Some(side * side),
            Self::Number | Self::Vector | Self::Matrix { .. } | Self::Table { .. } => None,
        }
    }

    /// Index of the entry that gives the value of entry `at` of `count`: in a symmetric matrix, always one of the upper
    /// triangle.
    fn source(self, at: usize, count: usize) -> usize {
        let side = count.isqrt();
        match self {
            Self::Matrix { symmetric: true } if at % side < at / side => (at % side) * side + at / side,
            _ => at,
        }
    }
}

/// Value to be computed: its variable, its name in comments, its expression.
pub type Value = (String, String, Expr);

/// Planner of the functions of one set of equations.
pub struct Planner<'a> {
    /// Model of the equations.
    pub model: &'a Model,
    /// Store of the terms of the equations.
    pub arena: &'a Arena,
    /// Equations whose functions are planned.
    pub equations: &'a Equations,
    /// Variables of the symbols, in the target's language.
    pub variables: Variables,
    /// Treatment of operations that several outputs have in common.
    pub sharing: Sharing,
}

/// Treatment of operations that several outputs have in common.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sharing {
    /// Common operations are found and computed once.
    Shared,
    /// Formulas stay as they stand. Printed equations do, because they run with their own cancellations.
    AsStated,
}

impl<'a> Planner<'a> {
    /// Planner with a variable for each symbol, as a language permits.
    #[must_use]
    pub fn new(
        model: &'a Model,
        arena: &'a Arena,
        equations: &'a Equations,
        language: &Language,
        sharing: Sharing,
    ) -> Self {
        let mut variables = Variables::new(arena, language, &type_name(&equations.name(model)));
        let rates = model.coordinates.iter().map(|c| c.rate).chain(model.speeds.iter().map(|s| s.rate));
        let unknown = &equations.unknowns[..equations.variables.len()];
        variables.moving = equations.variables.iter().chain(unknown).copied().chain(rates).collect();
        Self { model, arena, equations, variables, sharing }
    }

    /// Comments on the lines of long programs: formulas, or none if the equations consist of named terms.
    #[must_use]
    pub fn explanation(&self) -> Explanation {
        if self.equations.definitions.len() <= MOST_READ { Explanation::Formulas } else { Explanation::Names }
    }

    /// Plans a function that computes its values without further steps.
    #[must_use]
    pub fn function(
        &self,
        name: &'static str,
        about: &str,
        arguments: Arguments,
        returns: Returns,
        values: &[Value],
    ) -> Function {
        self.stepwise(name, about, arguments, returns, &[], values)
    }

    /// Plans a function that computes steps of an elimination, and from them its values. Entries that are 0 are not
    /// computed, nor is the lower triangle of a symmetric matrix.
    #[must_use]
    pub fn stepwise(
        &self,
        name: &'static str,
        about: &str,
        arguments: Arguments,
        returns: Returns,
        steps: &[Definition],
        values: &[Value],
    ) -> Function {
        // A step whose value is 0 becomes 0 in the values.
        let is_zero = |e: Expr| steps.iter().any(|step| step.symbol == e && step.value == Expr::ZERO);
        let results: Vec<Expr> = values.iter().map(|(.., e)| if is_zero(*e) { Expr::ZERO } else { *e }).collect();
        let steps = needed(self.arena, steps, &results);
        let places: Vec<usize> = (0..values.len()).map(|at| returns.source(at, values.len())).collect();
        let is_step = |e: Expr| steps.iter().any(|step| step.symbol == e);
        let is_output = |at: usize| places[at] == at && results[at] != Expr::ZERO && !is_step(results[at]);
        let outputs = values.iter().enumerate().filter(|(at, _)| is_output(*at)).map(|(_, (name, label, value))| {
            Output { name: name.clone(), label: label.clone(), value: *value, stated: *value }
        });
        let program = self.cheapest(&steps, &outputs.collect::<Vec<_>>(), &results);
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
        let cost = Cost::of(&program);
        let parts = Parts::of(&program, &arguments, &entries);
        let is_short = program.equations().count() <= MOST_LINES;
        let explanation = if is_short { Explanation::Formulas } else { self.explanation() };
        Function { name, about: about.to_owned(), arguments, returns, program, entries, parts, cost, explanation }
    }

    /// Program with the least cost for these outputs and for results that are steps or inputs: as given, or with common
    /// sub-sums and sub-products shared, by one of the readings of its terms.
    fn cheapest(&self, steps: &[Definition], outputs: &[Output], results: &[Expr]) -> Program {
        let mut best = program(self.arena, &self.variables, steps, steps, outputs, results);
        let mut least = Cost::of(&best).weight();
        if self.sharing == Sharing::AsStated {
            return best;
        }
        let values: Vec<Expr> = outputs.iter().map(|o| o.value).collect();
        // Named terms are short, and every reading of them is equal.
        let readings = match self.explanation() {
            Explanation::Formulas => &Reading::ALL[..],
            Explanation::Names => &Reading::SAMPLE[..1],
        };
        for &reading in readings {
            let mut arena = self.arena.clone();
            let shared = share(&mut arena, &mut Simplifier::default(), reading, steps, &values);
            let Some(shared) = shared else { continue };
            let rewritten = outputs.iter().zip(&shared.values).map(|(o, value)| Output { value: *value, ..o.clone() });
            let rewritten: Vec<Output> = rewritten.collect();
            let candidate = program(&arena, &self.variables, &shared.steps, steps, &rewritten, results);
            let weight = Cost::of(&candidate).weight();
            // A cheaper program is used only if it is proved equal to the planned one.
            if weight < least && is_same(&mut arena, steps, &values, &shared) {
                (best, least) = (candidate, weight);
            }
        }
        best
    }

    /// Arguments of a kind, with the variables of the entries that the inputs contain.
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

    /// Argument for all parameters, with the variables of those that the inputs contain.
    pub(crate) fn parameters(&self, inputs: &FxHashSet<Expr>) -> Argument {
        let all = &self.model.parameters;
        let read = all.iter().enumerate().filter(|(_, p)| inputs.contains(&p.symbol));
        Argument::Parameters { read: read.map(|(at, p)| (at, self.variables.of[&p.symbol].clone())).collect() }
    }
}

impl Function {
    /// Part of [`Function::cost`] that depends only on parameters, and so could be computed once for all states.
    #[must_use]
    pub fn cost_of_parameters(&self) -> Cost {
        let mut fixed: FxHashSet<&str> = FxHashSet::default();
        for argument in &self.arguments {
            if let Argument::Parameters { read } = argument {
                fixed.extend(read.iter().map(|(_, variable)| variable.as_str()));
            }
        }
        let mut lines = Vec::new();
        for (at, line) in self.program.lines.iter().enumerate() {
            if self.program.names_read(at..at + 1).is_subset(&fixed) {
                fixed.extend(self.program.names_set(at..at + 1));
                lines.push(line.clone());
            }
        }
        Cost::of(&Program { lines, ..Program::default() })
    }
}
