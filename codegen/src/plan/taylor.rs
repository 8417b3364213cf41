//! Plan of a function `taylor`: the names and the order of all that it computes, and its comments.

use super::{Allocator, Argument, Explanation, Names, Output, Planner, Program, Variables, identifier, program};
use crate::taylor::{Operand, Recurrences, Rule, Series};
use rustc_hash::{FxHashMap, FxHashSet};
use tripos_derive::algebra::text::print::text;
use tripos_derive::algebra::{Arena, Expr, Function as Elementary, Node};

/// Factor of the padded number of convolutions: `LANES` of `tripos_traits::series`.
const LANES: usize = 8;

/// Plan of a function that computes Taylor coefficients by recurrences.
pub struct TaylorPlan<'a> {
    /// Store of all terms.
    pub arena: &'a Arena,
    /// Recurrences that the function computes.
    pub list: &'a Recurrences,
    /// Variables of the symbols.
    pub variables: Variables,
    /// Name of the variable of each series.
    pub names: Vec<String>,
    /// Variables of the inverses of divisors, by the index of the series that is a divisor.
    pub over: FxHashMap<usize, String>,
    /// Variables of 1/(2 z), by the index of the root z.
    pub over_twice: FxHashMap<usize, String>,
    /// Variables of the weights that are neither numbers nor symbols.
    pub weights: FxHashMap<Expr, String>,
    /// Variables of the rates of states, by the index of the state's series. They are used while orders are computed.
    pub rates: FxHashMap<usize, String>,
    /// Operations that the coefficient of each series must wait for, at one order.
    pub depths: Vec<usize>,
    /// Places of the convolutions, by the index of the series that has one.
    pub slots: FxHashMap<usize, usize>,
    /// Argument for the parameters, with those that the weights contain.
    pub parameters: Argument,
    /// Program of the terms that are constant in time.
    pub constants: Program,
    /// Comments on the lines.
    pub explanation: Explanation,
}

impl<'a> TaylorPlan<'a> {
    /// Plans the names of all terms that the recurrences need.
    #[must_use]
    pub fn new(planner: &'a Planner<'_>, list: &'a Recurrences) -> Self {
        let (arena, mut variables) = (planner.arena, planner.variables.clone());
        let mut names = Names::new(variables.allocator.clone());
        let series = names_of(arena, &variables, &mut names, list);
        variables.allocator = names.allocator;
        let allocator = &mut variables.allocator;
        let (mut over, mut over_twice) = (FxHashMap::default(), FxHashMap::default());
        let mut rates = FxHashMap::default();
        for (at, s) in list.series.iter().enumerate() {
            match s.rule {
                Rule::Quotient(_, y) | Rule::Backward { slope: y, .. } => {
                    over.entry(y).or_insert_with(|| allocator.unique(&format!("over_{}", series[y])));
                }
                Rule::Root(_) => {
                    over_twice.insert(at, allocator.unique(&format!("over_twice_{}", series[at])));
                }
                Rule::State(_) => {
                    rates.insert(at, allocator.unique(&format!("{}_rate", series[at])));
                }
                _ => {}
            }
        }
        let mut weights = FxHashMap::default();
        for e in list.constants() {
            if !matches!(arena.node(e), Node::Number(_) | Node::Symbol(_)) {
                let word = identifier(&text(arena, e), 24).unwrap_or_else(|| "weight".to_owned());
                weights.insert(e, allocator.unique(&word));
            }
        }
        let convolving = (0..list.series.len()).filter(|at| list.series[*at].rule.convolves());
        let slots = convolving.enumerate().map(|(slot, at)| (at, slot)).collect();
        Self {
            arena,
            list,
            names: series,
            over,
            over_twice,
            rates,
            depths: depths(list),
            slots,
            parameters: planner.parameters(&inputs(arena, list)),
            constants: constants(arena, &variables, list, &weights),
            explanation: planner.explanation(),
            weights,
            variables,
        }
    }

    /// Number of convolutions for which there is room, with padding.
    #[must_use]
    pub fn width(&self) -> usize {
        self.list.convolutions().next_multiple_of(LANES).max(LANES)
    }

    /// Variable of the state `place` at order 0: that of its series, or of a constant in time. `None` if it is not
    /// read.
    #[must_use]
    pub fn start(&self, place: usize) -> Option<String> {
        let state = self.list.states[place];
        match self.list.series.iter().position(|s| s.rule == Rule::State(place)) {
            Some(at) if self.needs_start(at) => Some(format!("{}_0", self.names[at])),
            None if inputs(self.arena, self.list).contains(&state) => self.variables.of.get(&state).cloned(),
            _ => None,
        }
    }

    /// True if a recurrence or a rate reads the value of a series at order 0.
    fn needs_start(&self, at: usize) -> bool {
        let read =
            |s: &Series| s.rule.reads().contains(&at) || matches!(s.rule, Rule::Forward { slope, .. } if slope == at);
        let quotient = matches!(self.list.series[at].rule, Rule::Quotient(..) | Rule::Root(_));
        let rate = |rate: &Operand| matches!(rate, Operand::Scaled(_, x) if *x == at);
        quotient || self.list.series.iter().any(read) || self.list.rates.iter().any(rate)
    }

    /// Text of a weight for a comment: its variable or its formula.
    fn weight_text(&self, e: Expr) -> String {
        self.weights.get(&e).cloned().unwrap_or_else(|| text(self.arena, e))
    }

    /// Equation `name = formula` of a series, in terms of other series; empty for a state.
    #[must_use]
    pub fn equation(&self, at: usize) -> String {
        let name = |x: &usize| self.names[*x].as_str();
        let value = match &self.list.series[at].rule {
            Rule::State(_) => return String::new(),
            Rule::Linear { constant, terms } => self.sum_text(*constant, terms),
            Rule::Product(x, y) => format!("{}*{}", name(x), name(y)),
            Rule::Quotient(Some(x), y) => format!("{}/{}", name(x), name(y)),
            Rule::Quotient(None, y) => format!("1/{}", name(y)),
            Rule::Root(x) => format!("sqrt({})", name(x)),
            Rule::Forward { value, of, .. } | Rule::Backward { value, of, .. } => {
                format!("{}({})", value.name(), name(of))
            }
        };
        format!("{} = {value}", name(&at))
    }

    fn sum_text(&self, constant: Expr, terms: &[(Expr, usize)]) -> String {
        let mut out = if constant == Expr::ZERO { String::new() } else { self.weight_text(constant) };
        for (weight, x) in terms {
            let (weight, negative) = match *weight {
                Expr::ONE => (String::new(), false),
                Expr::MINUS_ONE => (String::new(), true),
                weight => {
                    let text = self.weight_text(weight);
                    let negative = text.starts_with('-');
                    (format!("{}*", text.trim_start_matches('-')), negative)
                }
            };
            out += match (out.is_empty(), negative) {
                (true, false) => "",
                (true, true) => "-",
                (false, false) => " + ",
                (false, true) => " - ",
            };
            out += &weight;
            out += &self.names[*x];
        }
        if out.is_empty() { "0".to_owned() } else { out }
    }
}

/// Symbols and subterms that the weights and constants contain.
fn inputs(arena: &Arena, list: &Recurrences) -> FxHashSet<Expr> {
    arena.reachable(&list.constants()).into_iter().collect()
}

/// Program of the weights, in terms of parameters and of states that do not change.
fn constants(arena: &Arena, variables: &Variables, list: &Recurrences, weights: &FxHashMap<Expr, String>) -> Program {
    let named = list.constants().into_iter().filter_map(|e| Some((e, weights.get(&e)?)));
    let outputs = named.map(|(value, name)| Output { name: name.clone(), label: name.clone(), value, stated: value });
    // The names of the weights are released, so that the program can give them out.
    let mut variables = variables.clone();
    variables.allocator.release(weights.values());
    program(arena, &variables, &[], &[], &outputs.collect::<Vec<_>>(), &[])
}

/// Suffixes for the variable of a series at orders 0, 1 and k − 1.
const ORDERS: [&str; 3] = ["_0", "_1", "_last"];

/// Names of all series, after the term or the first state that needs it; each is free at every order.
fn names_of(arena: &Arena, variables: &Variables, names: &mut Names, list: &Recurrences) -> Vec<String> {
    let rate_of = |at: usize| {
        let place = list.rates.iter().position(|rate| *rate == Operand::Scaled(Expr::ONE, at))?;
        Some(format!("{}_dot", variables.of[&list.states[place]]))
    };
    let mut one = |(at, s): (usize, &Series)| match (&s.rule, arena.node(s.term)) {
        (Rule::State(place), _) => reserved(&mut names.allocator, variables.of[&list.states[*place]].clone()),
        (_, Node::Apply(f @ (Elementary::Sin | Elementary::Cos), angle)) => {
            let (sine, cosine) = names.circular(arena, *angle);
            let name = if *f == Elementary::Sin { sine } else { cosine };
            reserved(&mut names.allocator, name)
        }
        _ => {
            let stem = variables.of.get(&s.needed_by).map_or("rate", String::as_str);
            let wanted = rate_of(at).unwrap_or_else(|| names.describe(arena, variables, s.term, stem));
            let free = names.allocator.unique(&wanted);
            renamed(&mut names.allocator, free, &wanted)
        }
    };
    list.series.iter().enumerate().map(&mut one).collect()
}

/// Name that is free at every order, for a name that is already given out. The name is kept if it is free there, else
/// it gets a suffix.
fn reserved(allocator: &mut Allocator, given: String) -> String {
    let stem = given.clone();
    renamed(allocator, given, &stem)
}

/// Name that is free at every order: `name`, or a name made from `wanted` if that is not free.
fn renamed(allocator: &mut Allocator, mut name: String, wanted: &str) -> String {
    while ORDERS.iter().any(|order| !allocator.is_free(&format!("{name}{order}"))) {
        name = allocator.unique(&format!("{wanted}_"));
    }
    for order in ORDERS {
        allocator.unique(&format!("{name}{order}"));
    }
    name
}

/// Operations at one order up to the coefficient of each series, along its longest chain of recurrences, roughly.
fn depths(list: &Recurrences) -> Vec<usize> {
    let mut depths: Vec<usize> = Vec::new();
    for s in &list.series {
        let before = s.rule.reads().iter().map(|x| depths.get(*x).copied().unwrap_or(0)).max().unwrap_or(0);
        let cost = match &s.rule {
            Rule::State(_) => 0,
            Rule::Linear { .. } => 1,
            _ => 2,
        };
        depths.push(before + cost);
    }
    depths
}
