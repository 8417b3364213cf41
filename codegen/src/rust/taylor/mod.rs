//! Generated Rust function `taylor`, which computes the Taylor coefficients of a motion in time.

mod taylor_statements;
mod taylor_variables;

use super::names::rust_identifier;
use super::rust_function::{Parameters, section, signature, statements, unpack};
use crate::plan::{LineComments, TaylorPlan};
use proc_macro2::{Literal, TokenStream};
use quote::quote;
use taylor_variables::TaylorWriter;

/// Place of the text of the function `taylor`: the file that uses the function, or another file.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum TaylorText {
    /// The file itself contains the text.
    Here,
    /// Another file contains the text, and this file imports the function.
    Elsewhere,
}

/// Returns the `use` items that a file with the function `taylor` needs. If the function's text is in another file,
/// only the items for the file's `System` remain.
pub fn imports(plan: &TaylorPlan<'_>, text: TaylorText) -> TokenStream {
    match plan.list.convolutions() {
        _ if text == TaylorText::Elsewhere => quote!(
            use tripos_traits::series::{SLACK, rows};
        ),
        0 => quote!(
            use tripos_traits::series::{Factors, SLACK, rows};
        ),
        n if n == plan.width() => quote!(
            use tripos_traits::series::{Factors, SLACK, pair_sums, rows};
        ),
        _ => quote!(
            use tripos_traits::series::{Factors, SLACK, padded, pair_sums, rows};
        ),
    }
}

/// Returns the Rust function `taylor`. It receives the parameters in the struct `parameters`.
pub fn function(plan: &TaylorPlan<'_>, parameters: &Parameters) -> TokenStream {
    let (list, text) = (plan.list, TaylorWriter { plan });
    let (p, unpack_p) = (signature(&plan.parameters, parameters), unpack(&plan.parameters, parameters));
    let first = (0..list.states.len()).map(|place| rust_identifier(plan.start(place).as_deref().unwrap_or("_")));
    let read = plan.constants.names_read(0..usize::MAX);
    let shared = statements(&plan.constants.lines, &|name| read.contains(name), plan.explanation);
    let constants = section("Constant in time.", &plan.constants.outputs, LineComments::Formulas);
    let [start, orders] = [text.order_zero_statements(), text.higher_order_statements()];
    let [states, width] = [list.states.len(), plan.width()].map(Literal::usize_unsuffixed);
    let work = rust_identifier(if list.convolutions() > 0 { "history" } else { "_history" });
    let plural = |n: usize, what: &str| if n == 1 { format!("1 {what}") } else { format!("{n} {what}s") };
    let convolutions = plural(list.convolutions(), "convolution");
    let counts = format!(" {convolutions} and {} an order.", plural(list.linear_operations(), "linear operation"));
    quote! {
        #[doc = " Taylor coefficients of the motion in time: `series[order]` is the one of order k, from the state `series[0]`."]
        #[doc = ""]
        #[doc = #counts]
        #[inline(always)]
        pub fn taylor<S: Scalar>(#p, series: &mut [[S; #states]], #work: &mut [Factors<S, #width>]) {
            #unpack_p
            let [#(#first),*] = series[0];
            #shared
            #constants
            #start
            #orders
        }
    }
}
