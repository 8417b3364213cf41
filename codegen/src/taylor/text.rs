//! Names of everything that a function `taylor` computes, and what its comments say.

use super::recurrences::{Operand, Recurrences, Rule, Series};
use crate::function::Writer;
use crate::identifiers::{Allocator, Variables};
use crate::program::{Names, identifier};
use crate::tokens::{Cost, expression};
use proc_macro2::TokenStream;
use quote::{format_ident, quote};
use rustc_hash::FxHashMap;
use tripos_derive::algebra::print::text;
use tripos_derive::algebra::view::view;
use tripos_derive::algebra::{Arena, Expr, Function as Elementary, Node};

/// Names of everything the function computes.
pub(super) struct Text<'a> {
    pub(super) arena: &'a Arena,
    pub(super) list: &'a Recurrences,
    pub(super) variables: Variables,
    /// Of each series.
    pub(super) names: Vec<String>,
    /// Of each series that is divided by: what it is multiplied with instead.
    pub(super) over: FxHashMap<usize, String>,
    /// The same for its double, which a root divides by.
    pub(super) over_twice: FxHashMap<usize, String>,
    /// Of each weight that is no number and no symbol.
    pub(super) weights: FxHashMap<Expr, String>,
    /// The rate of each state of the series, while orders are computed.
    pub(super) rates: FxHashMap<usize, String>,
    /// Operations that each series waits for at one order.
    pub(super) depths: Vec<usize>,
    /// The convolution of each series.
    pub(super) slots: FxHashMap<usize, usize>,
}

impl<'a> Text<'a> {
    pub(super) fn new(writer: &'a Writer<'_>, list: &'a Recurrences) -> Self {
        let (arena, mut variables) = (writer.arena, writer.variables.clone());
        let mut names = Names { allocator: variables.allocator.clone(), circular: FxHashMap::default() };
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
        Self { arena, list, variables, names: series, over, over_twice, weights, rates, depths: depths(list), slots }
    }

    /// Whether anything reads the value of a series at order 0.
    pub(super) fn needs_start(&self, at: usize) -> bool {
        let read =
            |s: &Series| s.rule.reads().contains(&at) || matches!(s.rule, Rule::Forward { slope, .. } if slope == at);
        let quotient = matches!(self.list.series[at].rule, Rule::Quotient(..) | Rule::Root(_));
        let rate = |rate: &Operand| matches!(rate, Operand::Scaled(_, x) if *x == at);
        quotient || self.list.series.iter().any(read) || self.list.rates.iter().any(rate)
    }

    pub(super) fn first(&self, at: usize) -> TokenStream {
        let name = format_ident!("{}_0", self.names[at]);
        quote!(#name)
    }

    pub(super) fn at_one(&self, at: usize) -> TokenStream {
        let name = format_ident!("{}_1", self.names[at]);
        quote!(#name)
    }

    pub(super) fn last(&self, at: usize) -> TokenStream {
        let name = format_ident!("{}_last", self.names[at]);
        quote!(#name)
    }

    pub(super) fn now(&self, at: usize) -> TokenStream {
        let name = format_ident!("{}", self.names[at]);
        quote!(#name)
    }

    pub(super) fn over(&self, at: usize) -> TokenStream {
        let name = format_ident!("{}", self.over[&at]);
        quote!(#name)
    }

    pub(super) fn over_twice(&self, at: usize) -> TokenStream {
        let name = format_ident!("{}", self.over_twice[&at]);
        quote!(#name)
    }

    pub(super) fn weight(&self, e: Expr) -> TokenStream {
        let symbol = self.variables.of.get(&e);
        match self.weights.get(&e).or(symbol) {
            Some(name) => {
                let name = format_ident!("{name}");
                quote!(#name)
            }
            None => {
                let number = view(self.arena, e, &FxHashMap::default(), usize::MAX);
                expression(&number, &mut Cost::default())
            }
        }
    }

    /// How a weight reads in a comment.
    pub(super) fn weight_text(&self, e: Expr) -> String {
        self.weights.get(&e).cloned().unwrap_or_else(|| text(self.arena, e))
    }

    /// What a series is, in terms of others.
    pub(super) fn equation(&self, at: usize) -> String {
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

    pub(super) fn sum_text(&self, constant: Expr, terms: &[(Expr, usize)]) -> String {
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

/// What stands behind the name of a series at orders 0, 1 and k − 1.
const ORDERS: [&str; 3] = ["_0", "_1", "_last"];

/// A name for each series, after what it stands for or what needs it; free at each order.
fn names_of(arena: &Arena, variables: &Variables, names: &mut Names, list: &Recurrences) -> Vec<String> {
    let rate_of = |at: usize| {
        let place = list.rates.iter().position(|rate| *rate == Operand::Scaled(Expr::ONE, at))?;
        Some(format!("{}_dot", variables.of[&list.states[place]]))
    };
    let mut one = |(at, s): (usize, &Series)| match (&s.rule, arena.node(s.term)) {
        (Rule::State(place), _) => reserved(&mut names.allocator, &variables.of[&list.states[*place]], true),
        (_, Node::Apply(f @ (Elementary::Sin | Elementary::Cos), angle)) => {
            let (sine, cosine) = names.circular(arena, *angle);
            let name = if *f == Elementary::Sin { sine } else { cosine };
            reserved(&mut names.allocator, &name, true)
        }
        _ => {
            let word = || identifier(&text(arena, s.term).replace('^', "_p"), 20);
            let needed_by = variables.of.get(&s.needed_by).cloned().unwrap_or_default();
            let part = || format!("{}_part", if needed_by.is_empty() { "rate" } else { &needed_by });
            let wanted = rate_of(at).or_else(word).unwrap_or_else(part);
            reserved(&mut names.allocator, &wanted, false)
        }
    };
    list.series.iter().enumerate().map(&mut one).collect()
}

/// A name that is free at every order; one that is given out already is kept if it is free there, and gets a mark
/// otherwise.
fn reserved(allocator: &mut Allocator, wanted: &str, given: bool) -> String {
    let mut name = if given { wanted.to_owned() } else { allocator.unique(wanted) };
    while ORDERS.iter().any(|order| !allocator.is_free(&format!("{name}{order}"))) {
        name = allocator.unique(&format!("{wanted}_"));
    }
    for order in ORDERS {
        allocator.unique(&format!("{name}{order}"));
    }
    name
}

/// How many operations the coefficient of each series waits for, about, at one order.
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
