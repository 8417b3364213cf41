//! Statements of the generated function `taylor`: coefficients of order 0, coefficients of order 1, and the loop over
//! higher orders.

use super::taylor_variables::TaylorWriter;
use crate::plan::LineComments;
use crate::rust::rust_text::comment;
use crate::taylor::{Operand, Rule};
use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};
use rustc_hash::FxHashMap;
use tripos_derive::algebra::{Expr, Function as Elementary};

/// Order of the coefficients that a generated statement computes.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Stage {
    /// Order 1, at which a convolution has no inner terms.
    One,
    /// Any order k greater than 1.
    Later,
}

/// Factors a and b of a convolution Σ a_j b_{k−j}, given by the indices of their series.
struct Factors {
    /// Index of the series a, the left factor of the convolution.
    left: usize,
    /// Index of the series b, the right factor of the convolution.
    right: usize,
    /// True if each product also has the factor j, as in Σ j a_j b_{k−j}.
    weighted: bool,
}

impl TaylorWriter<'_> {
    /// Returns the expression Σ weight · value + constant. Values that are computed late are added late, so that the
    /// sum waits less.
    fn linear_combination(
        &self,
        constant: Option<Expr>,
        terms: &[(Expr, usize)],
        value: impl Fn(usize) -> TokenStream,
    ) -> TokenStream {
        let mut sorted = terms.to_vec();
        sorted.sort_by_key(|(weight, x)| (self.plan.depths[*x], *weight == Expr::MINUS_ONE));
        let mut sum = constant.filter(|c| *c != Expr::ZERO).map(|c| self.weight_variable_or_number(c));
        for (weight, x) in sorted {
            let x = value(x);
            sum = Some(match (sum, weight) {
                (None, Expr::ONE) => x,
                (None, Expr::MINUS_ONE) => quote!(-#x),
                (None, _) => {
                    let weight = self.weight_variable_or_number(weight);
                    quote!(#weight * #x)
                }
                (Some(sum), Expr::ONE) => quote!(#sum + #x),
                (Some(sum), Expr::MINUS_ONE) => quote!(#sum - #x),
                (Some(sum), _) => {
                    let weight = self.weight_variable_or_number(weight);
                    quote!(#x.mul_add(#weight, #sum))
                }
            });
        }
        sum.unwrap_or_else(|| quote!(S::int(0)))
    }

    /// Returns the statements that compute all coefficients of order 0, and the reciprocals that
    /// higher orders need.
    pub(super) fn order_zero_statements(&self) -> TokenStream {
        let mut tokens = comment("Order 0.");
        let mut angles: Vec<usize> = Vec::new();
        for (at, s) in self.plan.list.series.iter().enumerate() {
            let z = self.order_zero_variable(at);
            let value = match &s.rule {
                Rule::State(_) => TokenStream::new(),
                Rule::Linear { constant, terms } => {
                    let sum = self.linear_combination(Some(*constant), terms, |x| self.order_zero_variable(x));
                    quote!(let #z = #sum;)
                }
                Rule::Product(x, y) => {
                    let (x, y) = (self.order_zero_variable(*x), self.order_zero_variable(*y));
                    quote!(let #z = #x * #y;)
                }
                Rule::Quotient(x, y) => {
                    let over = self.reciprocal_variable(*y);
                    match x {
                        Some(x) => {
                            let x = self.order_zero_variable(*x);
                            quote!(let #z = #x * #over;)
                        }
                        None => quote!(let #z = #over;),
                    }
                }
                Rule::Root(x) => {
                    let x = self.order_zero_variable(*x);
                    quote!(let #z = #x.sqrt();)
                }
                Rule::Forward { value: Elementary::Sin | Elementary::Cos, of, .. } => {
                    if angles.contains(of) {
                        TokenStream::new()
                    } else {
                        self.sine_cosine_statement(*of, &mut angles)
                    }
                }
                Rule::Forward { value, of, .. } | Rule::Backward { value, of, .. } => {
                    let x = self.order_zero_variable(*of);
                    let method = format_ident!("{}", if *value == Elementary::Log { "ln" } else { value.name() });
                    quote!(let #z = #x.#method();)
                }
            };
            tokens.extend(value);
            if let Some(name) = self.plan.over.get(&at) {
                let name = format_ident!("{name}");
                tokens.extend(quote!(let #name = S::int(1) / #z;));
            }
            if let Some(name) = self.plan.over_twice.get(&at) {
                let name = format_ident!("{name}");
                tokens.extend(quote!(let #name = S::int(1) / (#z + #z);));
            }
        }
        tokens
    }

    /// Returns the statement that computes the sine and cosine of an angle at order 0. The angle is added to the list
    /// `angles` of those that are already computed.
    fn sine_cosine_statement(&self, of: usize, angles: &mut Vec<usize>) -> TokenStream {
        angles.push(of);
        let place = |f: Elementary| {
            let found = self
                .plan
                .list
                .series
                .iter()
                .position(|s| matches!(s.rule, Rule::Forward { value, of: x, .. } if value == f && x == of));
            found.map_or_else(|| quote!(_), |at| self.order_zero_variable(at))
        };
        let (sine, cosine, angle) = (place(Elementary::Sin), place(Elementary::Cos), self.order_zero_variable(of));
        quote!(let (#sine, #cosine) = #angle.sin_cos();)
    }

    /// Returns the statements that compute order 1, and the loop over the higher orders.
    pub(super) fn higher_order_statements(&self) -> TokenStream {
        let list = self.plan.list;
        let mut rates = [TokenStream::new(), TokenStream::new(), TokenStream::new()];
        let mut states = TokenStream::new();
        for (&at, name) in statement_variables_by_series(&self.plan.rates) {
            let Rule::State(place) = list.series[at].rule else { continue };
            let (rate, z, z_1) =
                (format_ident!("{name}"), self.current_order_variable(at), self.order_one_variable(at));
            let (at_start, at_one, next) = match list.rates[place] {
                Operand::Constant(e) => (self.weight_variable_or_number(e), quote!(S::int(0)), quote!(S::int(0))),
                Operand::Scaled(weight, x) => {
                    let term = [(weight, x)];
                    let value = |of: &dyn Fn(usize) -> TokenStream| self.linear_combination(None, &term, of);
                    (
                        value(&|x| self.order_zero_variable(x)),
                        value(&|x| self.order_one_variable(x)),
                        value(&|x| self.current_order_variable(x)),
                    )
                }
            };
            rates[0].extend(quote!(let #z_1 = #at_start;));
            rates[1].extend(quote!(let mut #rate = #at_one;));
            rates[2].extend(quote!(#rate = #next;));
            states.extend(quote!(let #z = #rate * over_k;));
        }
        let row = |name: &dyn Fn(usize) -> TokenStream| {
            let entries = list.states.iter().enumerate().map(|(place, _)| {
                let found = list.series.iter().position(|s| s.rule == Rule::State(place));
                found.map_or_else(|| quote!(S::int(0)), name)
            });
            quote!([#(#entries),*])
        };
        let (row_1, row_k) = (row(&|at| self.order_one_variable(at)), row(&|at| self.current_order_variable(at)));
        let [rates_0, rates_1, rates_k] = rates;
        let one = (0..list.series.len()).map(|at| self.coefficient_statement(at, Stage::One));
        let later = (0..list.series.len()).map(|at| self.coefficient_statement(at, Stage::Later));
        let [ends, sums, history, kept] = self.convolution_history();
        let heading_1 = comment("Order 1: the rates, and what follows from them.");
        let heading_rates = comment("Rates at order k - 1.");
        let heading_k =
            comment("Order k, from lower orders: the states, over k since they are integrals, and what follows.");
        quote! {
            #heading_1
            #rates_0
            if series.len() > 1 {
                series[1] = #row_1;
            }
            #(#one)*
            #ends
            #heading_rates
            #rates_1
            for order in 2..series.len() {
                let over_k = S::ratio(1, order as i64);
                #heading_k
                #states
                series[order] = #row_k;
                if order + 1 == series.len() {
                    break;
                }
                #sums
                #(#later)*
                #rates_k
                #history
                #kept
            }
        }
    }

    /// Returns the factors of a series' convolution. `None` for a series without a convolution.
    fn factors(&self, at: usize) -> Option<Factors> {
        let (left, right, weighted) = match self.plan.list.series[at].rule {
            Rule::Product(x, y) => (x, y, false),
            Rule::Quotient(_, y) => (y, at, false),
            Rule::Root(_) => (at, at, false),
            Rule::Forward { of, slope, .. } => (of, slope, true),
            Rule::Backward { slope, .. } => (at, slope, true),
            Rule::State(_) | Rule::Linear { .. } => return None,
        };
        Some(Factors { left, right, weighted })
    }

    /// Returns four pieces of code for the convolutions. The first is the start before the loop. The other three
    /// belong to each order: they compute the sums, store the factors, and store coefficients for the next order.
    fn convolution_history(&self) -> [TokenStream; 4] {
        if self.plan.slots.is_empty() {
            return Default::default();
        }
        let mut counted = TokenStream::new();
        let mut factors: [Vec<TokenStream>; 2] = [Vec::new(), Vec::new()];
        let mut ends = Vec::new();
        let (mut before, mut after) = (TokenStream::new(), TokenStream::new());
        let mut read: Vec<usize> = Vec::new();
        let mut first: [Vec<TokenStream>; 2] = [Vec::new(), Vec::new()];
        for at in (0..self.plan.list.series.len()).filter(|at| self.plan.slots.contains_key(at)) {
            let Some(Factors { left, right, weighted }) = self.factors(at) else { continue };
            ends.push(self.odd_order_convolution(at));
            read.extend([left, right]);
            first[0].push(self.order_one_variable(left));
            first[1].push(self.order_one_variable(right));
            let (left, right) = (self.current_order_variable(left), self.current_order_variable(right));
            factors[0].push(if weighted { quote!(count * #left) } else { left });
            factors[1].push(right);
            if weighted && counted.is_empty() {
                counted = quote!(let count = S::int(order as i64););
                before.extend(quote!(let mut count_last = S::int(1);));
                after.extend(quote!(count_last = count;));
            }
        }
        read.sort_unstable();
        read.dedup();
        for at in read {
            let (last, one, now) =
                (self.previous_order_variable(at), self.order_one_variable(at), self.current_order_variable(at));
            before.extend(quote!(let mut #last = #one;));
            after.extend(quote!(#last = #now;));
        }
        let padding = self.plan.width() - self.plan.slots.len();
        let width = Literal::usize_unsuffixed(self.plan.width());
        let pad = |list: Vec<TokenStream>| {
            if padding == 0 { quote!([#(#list),*]) } else { quote!(padded([#(#list),*])) }
        };
        let [left, right] = factors.map(pad);
        let [left_1, right_1] = first.map(pad);
        let ends = pad(ends);
        let pair =
            comment("All convolutions of order k, and of order k + 1 but for the terms with coefficients of order k.");
        let added = comment("Those terms, which also have coefficients of order 1.");
        let kept = comment("Factors of the convolutions: left, right.");
        [
            quote! {
                if series.len() > 2 {
                    #kept
                    history[1] = [#left_1, #right_1];
                }
                #before
                let mut next = [S::int(0); #width];
            },
            quote! {
                #counted
                let sums = if order % 2 == 0 {
                    #pair
                    let pair = pair_sums(&history[..order]);
                    next = pair[1];
                    pair[0]
                } else {
                    #added
                    #ends
                };
            },
            quote!(#kept history[order] = [#left, #right];),
            quote!(#after),
        ]
    }

    /// Returns the convolution of a series at an odd order k. It is the prepared sum, plus the terms with
    /// coefficients of orders 1 and k − 1.
    fn odd_order_convolution(&self, at: usize) -> TokenStream {
        let Some(Factors { left, right, weighted }) = self.factors(at) else { return TokenStream::new() };
        let slot = Literal::usize_unsuffixed(self.plan.slots[&at]);
        let [left_1, right_1] = [left, right].map(|x| self.order_one_variable(x));
        let [left_last, right_last] = [left, right].map(|x| self.previous_order_variable(x));
        if left == right {
            return quote!((#left_1 + #left_1).mul_add(#left_last, next[#slot]));
        }
        let left_last = if weighted { quote!((count_last * #left_last)) } else { left_last };
        quote!(#left_1.mul_add(#right_last, #left_last.mul_add(#right_1, next[#slot])))
    }

    /// Returns the statement that computes the coefficient of a series, at order 1 or at a later order k.
    fn coefficient_statement(&self, at: usize, stage: Stage) -> TokenStream {
        let name =
            |x: usize| if stage == Stage::One { self.order_one_variable(x) } else { self.current_order_variable(x) };
        let z = name(at);
        let one = stage == Stage::One;
        let sum = self.plan.slots.get(&at).map(|slot| {
            let slot = Literal::usize_unsuffixed(*slot);
            quote!(sums[#slot])
        });
        let value = match &self.plan.list.series[at].rule {
            Rule::State(_) => return TokenStream::new(),
            Rule::Linear { terms, .. } => self.linear_combination(None, terms, name),
            Rule::Product(x, y) if x == y => {
                let (first, now) = (self.order_zero_variable(*x), name(*x));
                if one { quote!(#now * (#first + #first)) } else { quote!(#now.mul_add(#first + #first, #sum)) }
            }
            Rule::Product(x, y) => {
                let (early, late) = if self.plan.depths[*x] <= self.plan.depths[*y] { (x, y) } else { (y, x) };
                let (early_0, early_k) = (self.order_zero_variable(*early), name(*early));
                let (late_0, late_k) = (self.order_zero_variable(*late), name(*late));
                let rest = if one { quote!(#early_k * #late_0) } else { quote!(#early_k.mul_add(#late_0, #sum)) };
                quote!(#late_k.mul_add(#early_0, #rest))
            }
            Rule::Quotient(x, y) => {
                let (z_0, y_k, over) = (self.order_zero_variable(at), name(*y), self.reciprocal_variable(*y));
                let x_k = x.map(name);
                match (x_k, one) {
                    (Some(x_k), false) if x.is_some_and(|x| self.plan.depths[x] > self.plan.depths[*y]) => {
                        quote!(#x_k.mul_add(#over, -(#y_k.mul_add(#z_0, #sum) * #over)))
                    }
                    (Some(x_k), false) => quote!(#y_k.mul_add(-(#z_0 * #over), (#x_k - #sum) * #over)),
                    (None, false) => quote!(#y_k.mul_add(-(#z_0 * #over), -(#sum * #over))),
                    (Some(x_k), true) => quote!(#y_k.mul_add(-(#z_0 * #over), #x_k * #over)),
                    (None, true) => quote!(-#y_k * (#z_0 * #over)),
                }
            }
            Rule::Root(x) => {
                let (x_k, over) = (name(*x), self.over_twice_variable(at));
                if one { quote!(#x_k * #over) } else { quote!((#x_k - #sum) * #over) }
            }
            Rule::Forward { of, slope, negative, .. } => {
                let (x_k, w_0) = (name(*of), self.order_zero_variable(*slope));
                let sign = if *negative { quote!(-) } else { TokenStream::new() };
                if one { quote!(#sign #x_k * #w_0) } else { quote!(#sign #x_k.mul_add(#w_0, #sum * over_k)) }
            }
            Rule::Backward { of, slope, negative, .. } => {
                let (x_k, over) = (name(*of), self.reciprocal_variable(*slope));
                let x_k = if *negative { quote!(-#x_k) } else { x_k };
                if one { quote!(#x_k * #over) } else { quote!((#x_k - #sum * over_k) * #over) }
            }
        };
        let explained = !one && self.plan.explanation == LineComments::Formulas;
        let equation = if explained { comment(&self.plan.equation(at)) } else { TokenStream::new() };
        quote!(#equation let #z = #value;)
    }
}

/// Returns the entries of a map in ascending order of their keys.
fn statement_variables_by_series(map: &FxHashMap<usize, String>) -> Vec<(&usize, &String)> {
    let mut list: Vec<_> = map.iter().collect();
    list.sort();
    list
}
