//! The generated function `taylor`: one line for each series at order 0, and one for its coefficient of order k.

use super::recurrences::{Recurrences, Rule};
use super::text::Text;
use crate::function::{Function, Writer};
use crate::identifiers::fields;
use crate::program::{Output, program};
use crate::tokens::{Cost, section, statements};
use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};
use rustc_hash::FxHashSet;
use tripos_derive::algebra::Expr;

/// What the convolutions of an order are padded to a multiple of: `LANES` of `tripos_traits::series`.
const LANES: usize = 8;

/// How many convolutions there are room for.
#[must_use]
pub fn width(list: &Recurrences) -> usize {
    list.convolutions().next_multiple_of(LANES).max(LANES)
}

/// What the function uses.
#[must_use]
pub fn imports(list: &Recurrences) -> TokenStream {
    match list.convolutions() {
        0 => quote!(
            use tripos_traits::series::{Factors, SLACK, rows};
        ),
        n if n == width(list) => quote!(
            use tripos_traits::series::{Factors, SLACK, pair_sums, rows};
        ),
        _ => quote!(
            use tripos_traits::series::{Factors, SLACK, padded, pair_sums, rows};
        ),
    }
}

/// The function that computes the coefficients by these recurrences.
#[must_use]
pub fn taylor(writer: &Writer<'_>, list: &Recurrences) -> Function {
    let mut cost = Cost::default();
    let text = Text::new(writer, list);
    let constants = text.constants(&mut cost);
    let [start, orders] = [text.start(), text.orders()];
    let signature_p = text.parameters(writer);
    let states = Literal::usize_unsuffixed(list.states.len());
    let width = Literal::usize_unsuffixed(width(list));
    let (p, unpack_p) = signature_p;
    let unpack = text.unpack();
    let convolves = list.convolutions() > 0;
    let work = format_ident!("{}", if convolves { "history" } else { "_history" });
    let plural = |n: usize, what: &str| if n == 1 { format!("1 {what}") } else { format!("{n} {what}s") };
    let counts = format!(
        " {} and {} an order.",
        plural(list.convolutions(), "convolution"),
        plural(list.linear_operations(), "linear operation")
    );
    let tokens = quote! {
        #[doc = " Taylor coefficients of the motion in time: `series[order]` is the one of order k, from the state `series[0]`."]
        #[doc = ""]
        #[doc = #counts]
        pub fn taylor<S: Scalar>(#p: &Parameters<S>, series: &mut [[S; #states]], #work: &mut [Factors<S, #width>]) {
            #unpack_p
            #unpack
            #constants
            #start
            #orders
        }
    };
    Function { tokens, name: "taylor", cost }
}

impl Text<'_> {
    /// The weights, in terms of parameters and of states that do not change.
    fn constants(&self, cost: &mut Cost) -> TokenStream {
        let outputs: Vec<Output> = self
            .list
            .constants()
            .into_iter()
            .filter_map(|e| self.weights.get(&e).map(|name| (e, name)))
            .map(|(value, name)| Output { name: name.clone(), label: name.clone(), value, stated: value })
            .collect();
        // Their names are taken in `variables`; the program is to give them to them.
        let mut variables = self.variables.clone();
        variables.allocator.release(self.weights.values());
        let program = program(self.arena, &variables, &[], &[], &outputs);
        let shared = statements(&program, cost);
        let values = section("Constant in time.", &program.outputs, cost);
        quote!(#shared #values)
    }

    /// The parameter's name and the statement that unpacks what is used.
    fn parameters(&self, writer: &Writer<'_>) -> (TokenStream, TokenStream) {
        let inputs = self.inputs();
        let names = fields(writer.model);
        let all = &writer.model.parameters;
        let used: Vec<_> = all.iter().zip(&names).filter(|(p, _)| inputs.contains(&p.symbol)).collect();
        let fields = used.iter().map(|(p, name)| {
            let (field, variable) = (format_ident!("{name}"), format_ident!("{}", self.variables.of[&p.symbol]));
            if field == variable { quote!(#field) } else { quote!(#field: #variable) }
        });
        if used.is_empty() {
            return (quote!(_p), TokenStream::new());
        }
        let rest = if used.len() < all.len() { quote!(, ..) } else { TokenStream::new() };
        (quote!(p), quote!(let Parameters { #(#fields),* #rest } = *p;))
    }

    /// Symbols that weights and constants have.
    fn inputs(&self) -> FxHashSet<Expr> {
        self.arena.reachable(&self.list.constants()).into_iter().collect()
    }

    /// The state at order 0.
    fn unpack(&self) -> TokenStream {
        let inputs = self.inputs();
        let patterns = self.list.states.iter().enumerate().map(|(place, state)| {
            let series = self.list.series.iter().position(|s| s.rule == Rule::State(place));
            match series {
                Some(at) if self.needs_start(at) => self.first(at),
                None if inputs.contains(state) => {
                    let name = format_ident!("{}", self.variables.of[state]);
                    quote!(#name)
                }
                _ => quote!(_),
            }
        });
        quote!(let [#(#patterns),*] = series[0];)
    }
}
