//! Plan of the function `taylor`, which computes Taylor coefficients of a motion. The plan states names of variables,
//! order of computation, and comments.

use super::{
    Allocator, Argument, LineComments, Output, Planner, Program, SymbolVariableNames, TermVariableNames, program,
    variable_word_of_formula,
};
use crate::taylor::{Operand, Recurrences, Rule, Series};
use rustc_hash::{FxHashMap, FxHashSet};
use tripos_derive::algebra::text::print::print_text;
use tripos_derive::algebra::{Arena, Expr, Function as Elementary, Node};

/// Number to a multiple of which the number of convolutions is rounded up: `LANES` of `tripos_traits::series`.
const LANES: usize = 8;

/// Plan of a function that computes the Taylor coefficients of the state by recurrences, order by
/// order.
pub struct TaylorPlan<'a> {
    /// Arena that stores all terms of the recurrences.
    pub arena: &'a Arena,
    /// Recurrences that the function computes, one for each series.
    pub list: &'a Recurrences,
    /// Variables of the symbols in the generated code.
    pub variables: SymbolVariableNames,
    /// Name of the variable of each series, in the order of [`Self::list`].
    pub names: Vec<String>,
    /// Variables of the reciprocals of divisors, by the index of the divisor's series.
    pub over: FxHashMap<usize, String>,
    /// Variables of 1/(2 z), where z is a square root, by the index of the series of z.
    pub over_twice: FxHashMap<usize, String>,
    /// Variables of the constant factors in the recurrences that are neither numbers nor symbols.
    pub weights: FxHashMap<Expr, String>,
    /// Variables of the time derivatives of the states, by the index of the state's series.
    pub rates: FxHashMap<usize, String>,
    /// Depth of each series: approximate number of successive operations at an order before the series' coefficient
    /// is known.
    pub depths: Vec<usize>,
    /// Index of each convolution, by the index of its series. A convolution is a sum over products of coefficients.
    pub slots: FxHashMap<usize, usize>,
    /// Argument for the parameters, with variables for those that the constant factors contain.
    pub parameters: Argument,
    /// Program that computes the terms that are constant in time.
    pub constants: Program,
    /// Choice of the comments on the lines: formulas or none.
    pub explanation: LineComments,
}

impl<'a> TaylorPlan<'a> {
    /// Plans the names of all variables that the recurrences need. `list` are the recurrences.
    #[must_use]
    pub fn new(planner: &'a Planner<'_>, list: &'a Recurrences) -> Self {
        let (arena, mut variables) = (planner.arena, planner.variables.clone());
        let mut names = TermVariableNames::new(variables.allocator.clone());
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
                let word = variable_word_of_formula(&print_text(arena, e), 24).unwrap_or_else(|| "weight".to_owned());
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
            depths: operation_depths(list),
            slots,
            parameters: planner.parameters(&taylor_plan_inputs(arena, list)),
            constants: constants(arena, &variables, list, &weights),
            explanation: planner.explanation(),
            weights,
            variables,
        }
    }

    /// Returns the number of convolutions, rounded up to a multiple of eight and at least eight.
    #[must_use]
    pub fn width(&self) -> usize {
        self.list.convolutions().next_multiple_of(LANES).max(LANES)
    }

    /// Returns the variable for the initial value of the state with the index `place`. `None` if the function does
    /// not read this value.
    #[must_use]
    pub fn start(&self, place: usize) -> Option<String> {
        let state = self.list.states[place];
        match self.list.series.iter().position(|s| s.rule == Rule::State(place)) {
            Some(at) if self.needs_start(at) => Some(format!("{}_0", self.names[at])),
            None if taylor_plan_inputs(self.arena, self.list).contains(&state) => {
                self.variables.of.get(&state).cloned()
            }
            _ => None,
        }
    }

    /// True if a recurrence or a rate reads the coefficient of order 0 of the series with the index `at`.
    fn needs_start(&self, at: usize) -> bool {
        let read =
            |s: &Series| s.rule.reads().contains(&at) || matches!(s.rule, Rule::Forward { slope, .. } if slope == at);
        let quotient = matches!(self.list.series[at].rule, Rule::Quotient(..) | Rule::Root(_));
        let rate = |rate: &Operand| matches!(rate, Operand::Scaled(_, x) if *x == at);
        quotient || self.list.series.iter().any(read) || self.list.rates.iter().any(rate)
    }

    /// Returns a constant factor as text for a comment: its variable or its formula.
    fn weight_text(&self, e: Expr) -> String {
        self.weights.get(&e).cloned().unwrap_or_else(|| print_text(self.arena, e))
    }

    /// Returns the equation `name = formula` of a series in terms of other series. The text is empty for a series
    /// that is a state.
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

    /// Returns a linear combination of series as text for a comment.
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

/// Returns all symbols and subterms that the constant factors of the recurrences contain.
fn taylor_plan_inputs(arena: &Arena, list: &Recurrences) -> FxHashSet<Expr> {
    arena.reachable(&list.constants()).into_iter().collect()
}

/// Builds the program that computes the constant factors from parameters and constant states.
fn constants(
    arena: &Arena,
    variables: &SymbolVariableNames,
    list: &Recurrences,
    weights: &FxHashMap<Expr, String>,
) -> Program {
    let named = list.constants().into_iter().filter_map(|e| Some((e, weights.get(&e)?)));
    let outputs = named.map(|(value, name)| Output { name: name.clone(), label: name.clone(), value, stated: value });
    // The names of the constant factors are released, so that the program can use them.
    let mut variables = variables.clone();
    variables.allocator.release(weights.values());
    program(arena, &variables, &[], &[], &outputs.collect::<Vec<_>>(), &[])
}

/// Suffixes of a series' variables for its coefficients of orders 0, 1 and k − 1.
const ORDERS: [&str; 3] = ["_0", "_1", "_last"];

/// Returns the names of all series. A series is named after its term, or after the first state that needs it. Its
/// name is free with every suffix for an order.
fn names_of(
    arena: &Arena,
    variables: &SymbolVariableNames,
    names: &mut TermVariableNames,
    list: &Recurrences,
) -> Vec<String> {
    let rate_of = |at: usize| {
        let place = list.rates.iter().position(|rate| *rate == Operand::Scaled(Expr::ONE, at))?;
        Some(format!("{}_dot", variables.of[&list.states[place]]))
    };
    let mut one = |(at, s): (usize, &Series)| match (&s.rule, arena.node(s.term)) {
        (Rule::State(place), _) => {
            reserve_series_name(&mut names.allocator, variables.of[&list.states[*place]].clone())
        }
        (_, Node::Apply(f @ (Elementary::Sin | Elementary::Cos), angle)) => {
            let (sine, cosine) = names.sine_and_cosine_names(arena, *angle);
            let name = if *f == Elementary::Sin { sine } else { cosine };
            reserve_series_name(&mut names.allocator, name)
        }
        _ => {
            let stem = variables.of.get(&s.needed_by).map_or("rate", String::as_str);
            let wanted = rate_of(at).unwrap_or_else(|| names.descriptive_name(arena, variables, s.term, stem));
            let free = names.allocator.unique(&wanted);
            free_series_name(&mut names.allocator, free, &wanted)
        }
    };
    list.series.iter().enumerate().map(&mut one).collect()
}

/// Returns a name for a series that is free with every suffix for an order. `given` is the name that the series
/// already has; it is changed only if a suffixed name is not free.
fn reserve_series_name(allocator: &mut Allocator, given: String) -> String {
    let stem = given.clone();
    free_series_name(allocator, given, &stem)
}

/// Returns a name that is free with every suffix for an order. It is `name` or, if that is not free, a name made from
/// `wanted`.
fn free_series_name(allocator: &mut Allocator, mut name: String, wanted: &str) -> String {
    while ORDERS.iter().any(|order| !allocator.is_free(&format!("{name}{order}"))) {
        name = allocator.unique(&format!("{wanted}_"));
    }
    for order in ORDERS {
        allocator.unique(&format!("{name}{order}"));
    }
    name
}

/// Returns the depth of each series: the approximate number of successive operations at an order before the series'
/// coefficient is known.
fn operation_depths(list: &Recurrences) -> Vec<usize> {
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
