//! One generated function: signature, body, cost.

use crate::identifiers::{Variables, fields};
use crate::program::{Output, Program, program};
use crate::tokens::{Cost, section, statements};
use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};
use tripos_derive::algebra::elimination::{Definition, needed};
use tripos_derive::algebra::sharing::{Reading, share};
use tripos_derive::algebra::simplify::Simplifier;
use tripos_derive::algebra::{Arena, Expr};
use tripos_derive::{Equations, Formulation, Model};

/// The functions that runs spend their time in: `System` calls them through `Scalar::dispatch`.
const DISPATCHED: [&str; 2] = ["accelerations", "derivative"];

/// The arguments a generated function reads.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Arguments {
    /// (p, q, v)
    State,
    /// (p, q, u)
    Speeds,
    /// (p, q, v, v̇)
    StateAndRates,
    /// (p, q)
    Configuration,
    /// (p, t, q, v)
    Shown {
        /// The symbol of the time.
        time: Expr,
    },
}

/// What a generated function returns.
#[derive(Clone, Copy)]
pub enum Returns {
    /// One number.
    Number,
    /// An array of this many.
    Vector,
    /// Two arrays: the first this long, the second of what is left.
    Pair(usize),
    /// A square array, row by row; symmetric ones are computed from their upper triangle.
    Matrix { symmetric: bool },
}

/// A value to be computed: its variable, its name in comments, its expression.
pub type Value = (String, String, Expr);

/// Writes the functions of one formulation.
pub struct Writer<'a> {
    /// The model.
    pub model: &'a Model,
    /// The store of its terms.
    pub arena: &'a Arena,
    /// The equations.
    pub equations: &'a Equations,
    /// The variable of each symbol.
    pub variables: Variables,
    /// Whether operations are shared. Printed equations are not: they run with their own cancellations.
    pub shares: bool,
}

/// What a call of a program costs.
fn cost(program: &Program) -> Cost {
    let mut cost = Cost::default();
    statements(program, &mut cost);
    section("", &program.outputs, &mut cost);
    cost
}

/// A generated function.
pub struct Function {
    /// Its text.
    pub tokens: TokenStream,
    /// Its name.
    pub name: &'static str,
    /// What a call costs.
    pub cost: Cost,
}

impl Writer<'_> {
    /// One generated function: zeros are written as such, and the lower triangle of a symmetric matrix
    /// is its upper one.
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

    /// The same with steps of an elimination before the values.
    pub fn stepwise(
        &self,
        name: &'static str,
        about: &str,
        arguments: Arguments,
        returns: Returns,
        steps: &[Definition],
        values: &[Value],
    ) -> Function {
        // A step whose value is 0 or another symbol stands in the values as such.
        let value_of = |at: usize| match steps.iter().find(|step| step.symbol == values[at].2) {
            Some(step) if step.value == Expr::ZERO => Expr::ZERO,
            _ => values[at].2,
        };
        let steps = needed(self.arena, steps, &(0..values.len()).map(value_of).collect::<Vec<_>>());
        let is_step = |at: usize| steps.iter().any(|step| step.symbol == values[at].2);
        let side = values.len().isqrt();
        let mirrored = |at: usize| matches!(returns, Returns::Matrix { symmetric: true }) && at % side < at / side;
        let wanted = |at: usize| !mirrored(at) && !is_step(at) && value_of(at) != Expr::ZERO;
        let outputs: Vec<Output> = (0..values.len())
            .filter(|at| wanted(*at))
            .map(|at| {
                let (name, label, value) = values[at].clone();
                Output { name, label, value, stated: value }
            })
            .collect();
        let program = self.cheapest(&steps, &outputs);
        let mut computed = program.outputs.iter().map(|s| s.name.as_str());
        let name_of = |at: usize| match value_of(at) {
            _ if wanted(at) => computed.next().unwrap_or("zero"),
            Expr::ZERO => "zero",
            symbol => self.variables.of.get(&symbol).map_or("zero", String::as_str),
        };
        let names: Vec<&str> = (0..values.len()).map(name_of).collect();
        let mut cost = Cost::default();
        let head = statements(&program, &mut cost);
        let heading = match returns {
            Returns::Matrix { symmetric: true } => "Entries that are not zero; upper triangle.",
            Returns::Matrix { .. } => "Entries that are not zero.",
            _ => "Values.",
        };
        let body = section(heading, &program.outputs, &mut cost);
        let entry = |at: usize| {
            let at = if mirrored(at) { (at % side) * side + at / side } else { at };
            format_ident!("{}", names[at])
        };
        let has_zero = (0..values.len()).any(|at| value_of(at) == Expr::ZERO);
        let zero = if has_zero { quote!(let zero = S::int(0);) } else { TokenStream::new() };
        let count = Literal::usize_unsuffixed(values.len());
        let (kind, result) = match returns {
            Returns::Number => {
                let value = entry(0);
                (quote!(S), quote!(#value))
            }
            Returns::Vector => {
                let entries = (0..values.len()).map(entry);
                (quote!([S; #count]), quote!([#(#entries),*]))
            }
            Returns::Pair(first) => {
                let [one, two] = [first, values.len() - first].map(Literal::usize_unsuffixed);
                let (front, back) = ((0..first).map(entry), (first..values.len()).map(entry));
                (quote!(([S; #one], [S; #two])), quote!(([#(#front),*], [#(#back),*])))
            }
            Returns::Matrix { .. } => {
                let rows = (0..side).map(|i| {
                    let entries = (0..side).map(|j| entry(i * side + j));
                    quote!([#(#entries),*])
                });
                let order = Literal::usize_unsuffixed(side);
                (quote!([[S; #order]; #order]), quote!([#(#rows),*]))
            }
        };
        let (signature, unpack) = self.arguments(arguments, &program.inputs);
        let function = format_ident!("{name}");
        let (about, cost_line) = (format!(" {about}"), format!(" {cost}."));
        // What `System` dispatches is compiled again for the instructions of the processor, which reach only inlined code.
        let inline = if DISPATCHED.contains(&name) { quote!(#[inline(always)]) } else { TokenStream::new() };
        let tokens = quote! {
            #[doc = #about]
            #[doc = ""]
            #[doc = #cost_line]
            #[must_use]
            #inline
            pub fn #function<S: Scalar>(#signature) -> #kind {
                #unpack
                #zero
                #head
                #body
                #result
            }
        };
        Function { tokens, name, cost }
    }

    /// The program for these outputs that costs least: as it stands, or with common sub-sums and sub-products
    /// taken out of one reading of it or another.
    fn cheapest(&self, steps: &[Definition], outputs: &[Output]) -> Program {
        let mut best = program(self.arena, &self.variables, steps, steps, outputs);
        let mut least = cost(&best).weight();
        if !self.shares {
            return best;
        }
        let values: Vec<Expr> = outputs.iter().map(|o| o.value).collect();
        for reading in Reading::ALL {
            let mut arena = self.arena.clone();
            let shared = share(&mut arena, &mut Simplifier::default(), reading, steps, &values);
            let Some(shared) = shared else { continue };
            let rewritten = outputs.iter().zip(shared.values).map(|(o, value)| Output { value, ..o.clone() });
            let candidate = program(&arena, &self.variables, &shared.steps, steps, &rewritten.collect::<Vec<_>>());
            let weight = cost(&candidate).weight();
            if weight < least {
                (best, least) = (candidate, weight);
            }
        }
        best
    }

    /// The argument list and the statements that unpack what is used.
    fn arguments(&self, arguments: Arguments, inputs: &rustc_hash::FxHashSet<Expr>) -> (TokenStream, TokenStream) {
        let unpack_array = |symbols: &[Expr], argument: &str| {
            let patterns = symbols.iter().map(|s| {
                if inputs.contains(s) {
                    let name = format_ident!("{}", self.variables.of[s]);
                    quote!(#name)
                } else {
                    quote!(_)
                }
            });
            let used = symbols.iter().any(|s| inputs.contains(s));
            let argument_name = format_ident!("{}{argument}", if used { "" } else { "_" });
            let statement = if used { quote!(let [#(#patterns),*] = *#argument_name;) } else { TokenStream::new() };
            let count = Literal::usize_unsuffixed(symbols.len());
            (quote!(#argument_name: &[S; #count]), statement)
        };
        let names = fields(self.model);
        let used: Vec<_> =
            self.model.parameters.iter().zip(&names).filter(|(p, _)| inputs.contains(&p.symbol)).collect();
        let fields = used.iter().map(|(p, name)| {
            let (field, variable) = (format_ident!("{name}"), format_ident!("{}", self.variables.of[&p.symbol]));
            if field == variable { quote!(#field) } else { quote!(#field: #variable) }
        });
        let rest = if used.len() < self.model.parameters.len() { quote!(, ..) } else { TokenStream::new() };
        let (p, p_unpack) = if used.is_empty() {
            (format_ident!("_p"), TokenStream::new())
        } else {
            (format_ident!("p"), quote!(let Parameters { #(#fields),* #rest } = *p;))
        };
        let (q, q_unpack) = unpack_array(&self.equations.coordinates, "q");
        let variables_name = if self.equations.formulation == Formulation::Lagrange { "q_dot" } else { "u" };
        let (v, v_unpack) = unpack_array(&self.equations.variables, variables_name);
        let (u, u_unpack) = unpack_array(&self.model.u(), "u");
        let (a, a_unpack) = unpack_array(&self.equations.unknowns, "v_dot");
        let p = quote!(#p: &Parameters<S>);
        match arguments {
            Arguments::State => (quote!(#p, #q, #v), quote!(#p_unpack #q_unpack #v_unpack)),
            Arguments::Speeds => (quote!(#p, #q, #u), quote!(#p_unpack #q_unpack #u_unpack)),
            Arguments::Configuration => (quote!(#p, #q), quote!(#p_unpack #q_unpack)),
            Arguments::Shown { time } => {
                let name = self.variables.of.get(&time).filter(|_| inputs.contains(&time));
                let t = format_ident!("{}", name.map_or("_t", String::as_str));
                (quote!(#p, #t: S, #q, #v), quote!(#p_unpack #q_unpack #v_unpack))
            }
            Arguments::StateAndRates => (quote!(#p, #q, #v, #a), quote!(#p_unpack #q_unpack #v_unpack #a_unpack)),
        }
    }
}
