//! One function: what it is given, what it computes and in which order, what it returns, and what that costs.

use super::arguments::{Argument, Entry};
use super::cost::Cost;
use super::names::{Language, Variables, type_name};
use super::parts::Parts;
use super::program::{Output, Program, program};
use rustc_hash::FxHashSet;
use tripos_derive::algebra::form::sharing::{Reading, is_same, share};
use tripos_derive::algebra::form::simplify::Simplifier;
use tripos_derive::algebra::term::steps::{Definition, needed};
use tripos_derive::algebra::{Arena, Expr};
use tripos_derive::{Equations, Model};

/// Named terms above which a program is read in one way only.
const MOST_READ: usize = 100;

/// Lines of a program that have their formulas above them in any case.
const MOST_LINES: usize = 20;

/// A planned function.
#[derive(Clone, Debug)]
pub struct Function {
    /// Its name.
    pub name: &'static str,
    /// Its result, as a sentence.
    pub about: String,
    /// Its arguments, in the order of the signature.
    pub arguments: Vec<Argument>,
    /// Shape of its return value.
    pub returns: Returns,
    /// The steps of the computation.
    pub program: Program,
    /// Entries of the return value, in order.
    pub entries: Vec<Entry>,
    /// The program in parts, if it is long.
    pub parts: Option<Parts>,
    /// Operations of one call.
    pub cost: Cost,
    /// True if each line is to have its formula above it. Where most lines are named terms, their names say it.
    pub explained: bool,
}

/// The kinds of arguments that functions have.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Arguments {
    /// (p, q, v)
    State,
    /// (p, q, u)
    Speeds,
    /// (p, q, v, v̇)
    StateAndRates,
    /// (p, q) alone: no motion variables
    Configuration,
    /// (p, q, v, r): reactions beside the state, in the order of the model
    Balanced,
    /// (p, t, q, v)
    Shown {
        /// The symbol of the time.
        time: Expr,
    },
}

/// Shape of the return value of a function.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Returns {
    /// One number.
    Number,
    /// An array of all entries.
    Vector,
    /// Two arrays: the first this long, the second of what is left.
    Pair(usize),
    /// A square array, row by row; symmetric ones are computed from their upper triangle.
    Matrix {
        /// True if the matrix equals its transpose.
        symmetric: bool,
    },
}

impl Returns {
    /// Heading above the lines of the entries.
    #[must_use]
    pub fn heading(self) -> &'static str {
        match self {
            Self::Matrix { symmetric: true } => "Entries that are not zero; upper triangle.",
            Self::Matrix { .. } => "Entries that are not zero.",
            _ => "Values.",
        }
    }

    /// The entry whose value stands at this place: of a symmetric matrix, always one of the upper triangle.
    fn source(self, at: usize, count: usize) -> usize {
        let side = count.isqrt();
        match self {
            Self::Matrix { symmetric: true } if at % side < at / side => (at % side) * side + at / side,
            _ => at,
        }
    }
}

/// A value to be computed: its variable, its name in comments, its expression.
pub type Value = (String, String, Expr);

/// Plans the functions of one formulation.
pub struct Planner<'a> {
    /// The model.
    pub model: &'a Model,
    /// The store of its terms.
    pub arena: &'a Arena,
    /// The equations.
    pub equations: &'a Equations,
    /// The variable of each symbol.
    pub variables: Variables,
    /// True if common operations are shared. Printed equations share none: they run with their own cancellations.
    pub shares: bool,
}

impl<'a> Planner<'a> {
    /// With a variable for each symbol, as a language permits.
    #[must_use]
    pub fn new(
        model: &'a Model,
        arena: &'a Arena,
        equations: &'a Equations,
        language: &Language,
        shares: bool,
    ) -> Self {
        let mut variables = Variables::new(arena, language, &type_name(&equations.name(model)));
        let rates = model.coordinates.iter().map(|c| c.rate).chain(model.speeds.iter().map(|s| s.rate));
        let unknown = &equations.unknowns[..equations.variables.len()];
        variables.moving = equations.variables.iter().chain(unknown).copied().chain(rates).collect();
        Self { model, arena, equations, variables, shares }
    }

    /// True if lines have their formulas above them; false if the equations are made of named terms.
    #[must_use]
    pub fn explains(&self) -> bool {
        self.equations.definitions.len() <= MOST_READ
    }

    /// A function without steps of its own before its values.
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

    /// A function that computes steps of an elimination, and from them its values. What is 0 is not computed, nor is
    /// the lower triangle of a symmetric matrix.
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
        // A step whose value is 0 stands in the values as such.
        let is_zero = |e: Expr| steps.iter().any(|step| step.symbol == e && step.value == Expr::ZERO);
        let results: Vec<Expr> = values.iter().map(|(.., e)| if is_zero(*e) { Expr::ZERO } else { *e }).collect();
        let steps = needed(self.arena, steps, &results);
        let places: Vec<usize> = (0..values.len()).map(|at| returns.source(at, values.len())).collect();
        let is_step = |e: Expr| steps.iter().any(|step| step.symbol == e);
        let is_output = |at: usize| places[at] == at && results[at] != Expr::ZERO && !is_step(results[at]);
        let outputs = values.iter().enumerate().filter(|(at, _)| is_output(*at)).map(|(_, (name, label, value))| {
            Output { name: name.clone(), label: label.clone(), value: *value, stated: *value }
        });
        let program = self.cheapest(&steps, &outputs.collect::<Vec<_>>());
        let mut computed = program.outputs.iter().map(|output| &output.name);
        let entries: Vec<Entry> = results
            .iter()
            .enumerate()
            .map(|(at, e)| match computed_name(is_output(at), &mut computed).or_else(|| self.variables.of.get(e)) {
                Some(name) if *e != Expr::ZERO => Entry::Variable(name.clone()),
                _ => Entry::Zero,
            })
            .collect();
        let entries: Vec<Entry> = places.iter().map(|at| entries[*at].clone()).collect();
        let arguments = self.arguments(arguments, &program.inputs);
        let cost = Cost::of(&program);
        let parts = Parts::of(&program, &arguments, &entries);
        let explained = self.explains() || program.equations().count() <= MOST_LINES;
        Function { name, about: about.to_owned(), arguments, returns, program, entries, parts, cost, explained }
    }

    /// The program for these outputs that costs least: as it stands, or with common sub-sums and sub-products
    /// taken out of one reading of it or another.
    fn cheapest(&self, steps: &[Definition], outputs: &[Output]) -> Program {
        let mut best = program(self.arena, &self.variables, steps, steps, outputs);
        let mut least = Cost::of(&best).weight();
        if !self.shares {
            return best;
        }
        let values: Vec<Expr> = outputs.iter().map(|o| o.value).collect();
        // Named terms are short, and read alike in every way.
        let readings = if self.explains() { &Reading::ALL[..] } else { &Reading::SAMPLE[..1] };
        for &reading in readings {
            let mut arena = self.arena.clone();
            let shared = share(&mut arena, &mut Simplifier::default(), reading, steps, &values);
            let Some(shared) = shared else { continue };
            let rewritten = outputs.iter().zip(&shared.values).map(|(o, value)| Output { value: *value, ..o.clone() });
            let candidate = program(&arena, &self.variables, &shared.steps, steps, &rewritten.collect::<Vec<_>>());
            let weight = Cost::of(&candidate).weight();
            // What is used is proved to be what was planned.
            if weight < least && is_same(&mut arena, steps, &values, &shared) {
                (best, least) = (candidate, weight);
            }
        }
        best
    }

    /// The arguments, with what is read of them.
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
        list.push(array("q", &e.coordinates));
        match arguments {
            Arguments::Configuration => {}
            Arguments::Speeds => list.push(array("u", &self.model.u())),
            Arguments::State | Arguments::StateAndRates | Arguments::Balanced | Arguments::Shown { .. } => {
                list.push(array(own, &e.variables));
            }
        }
        if arguments == Arguments::StateAndRates {
            list.push(array("v_dot", &e.unknowns[..e.variables.len()]));
        }
        if arguments == Arguments::Balanced {
            list.push(array("r", &self.model.reactions.iter().map(|r| r.symbol).collect::<Vec<_>>()));
        }
        list
    }

    /// The parameters as an argument.
    pub(crate) fn parameters(&self, inputs: &FxHashSet<Expr>) -> Argument {
        let all = &self.model.parameters;
        let read = all.iter().enumerate().filter(|(_, p)| inputs.contains(&p.symbol));
        Argument::Parameters { read: read.map(|(at, p)| (at, self.variables.of[&p.symbol].clone())).collect() }
    }
}

impl Function {
    /// The share of [`Function::cost`] that depends on parameters alone: it could be computed once for all states.
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

/// The next of the computed names, if it is this entry's.
fn computed_name<'n>(is_output: bool, names: &mut impl Iterator<Item = &'n String>) -> Option<&'n String> {
    if is_output { names.next() } else { None }
}
