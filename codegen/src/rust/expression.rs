//! Formulas as Rust expressions of the scalar type `S`.

use super::names::rust_identifier;
use crate::plan::{is_fusible_product, order_sum_for_fusion};
use proc_macro2::TokenStream;
use quote::{format_ident, quote};
use tripos_derive::algebra::Rational;
use tripos_derive::algebra::text::display_tree::{DisplayTree, constant_and_factors, is_sum_free_formula};

/// Returns the Rust expression for a formula, generic over the scalar type `S`.
pub fn expression(view: &DisplayTree) -> TokenStream {
    match view {
        DisplayTree::Number(text) => number(text, "1"),
        DisplayTree::Name(name) | DisplayTree::Word(name) | DisplayTree::Shared(name) => rust_identifier(name),
        DisplayTree::Pi => quote!(S::pi()),
        DisplayTree::Sum(terms) => sum(terms).0,
        DisplayTree::Product(factors) => product(factors),
        DisplayTree::Fraction(above, below) => fraction(above, below),
        DisplayTree::Power(base, n) => power(base, *n),
        DisplayTree::Call(name, argument) => {
            let argument = method_receiver_expression(argument);
            let method = format_ident!("{}", if *name == "log" { "ln" } else { name });
            quote!(#argument.#method())
        }
        DisplayTree::Root(argument) => {
            let argument = method_receiver_expression(argument);
            quote!(#argument.sqrt())
        }
        DisplayTree::Cut => quote!(compile_error!("formula too large")),
    }
}

/// Returns the Rust expression for a rational number. The expression is exact if numerator and denominator fit into
/// 64 bits.
pub fn constant(value: &Rational) -> TokenStream {
    let magnitude = if value.is_negative() { value.neg() } else { value.clone() }.to_big();
    let magnitude = number(&magnitude.numer().to_string(), &magnitude.denom().to_string());
    if value.is_negative() { quote!(-#magnitude) } else { magnitude }
}

/// Returns the Rust expression for a quotient of whole numbers, as `S::int` or `S::ratio` if they
/// fit into 64 bits.
fn number(numerator: &str, denominator: &str) -> TokenStream {
    match (numerator.parse::<i64>(), denominator.parse::<i64>()) {
        (Ok(n), Ok(1)) => {
            let n = proc_macro2::Literal::i64_unsuffixed(n);
            quote!(S::int(#n))
        }
        (Ok(n), Ok(d)) => {
            let (n, d) = (proc_macro2::Literal::i64_unsuffixed(n), proc_macro2::Literal::i64_unsuffixed(d));
            quote!(S::ratio(#n, #d))
        }
        // The numbers have more than 64 bits.
        _ => long_number(numerator, denominator),
    }
}

/// Returns the Rust expression for a quotient of long whole numbers. It is the nearest double. If no normal double is
/// near, a power of ten is factored out. A number beyond the range of doubles becomes a compile error.
fn long_number(numerator: &str, denominator: &str) -> TokenStream {
    let value = Rational::parse_decimal(numerator).zip(Rational::parse_decimal(denominator));
    let value = value.and_then(|(n, d)| Some(n.mul(&d.reciprocal()?)));
    let Some(value) = value else { return quote!(compile_error!("not a number")) };
    let double = |x: f64| proc_macro2::Literal::f64_unsuffixed(x);
    let nearest = value.to_f64();
    if nearest.is_normal() {
        let nearest = double(nearest);
        return quote!(S::from_f64(#nearest));
    }
    // The difference of the numbers of digits is the size of the number in powers of ten, up to one.
    let size = digits(numerator) - digits(denominator);
    let ten = Rational::integer(10);
    let power = ten.pow(size).map(|power| value.mul(&power.reciprocal().unwrap_or(Rational::ONE)).to_f64());
    match power {
        Some(mantissa) if mantissa.is_finite() => {
            let (mantissa, size) = (double(mantissa), proc_macro2::Literal::i32_unsuffixed(size));
            quote!(S::from_f64(#mantissa) * S::int(10).powi(#size))
        }
        _ => quote!(compile_error!("a number beyond all scalars")),
    }
}

/// Returns the number of digits of a whole number, without its sign.
fn digits(text: &str) -> i32 {
    i32::try_from(text.trim_start_matches('-').len()).unwrap_or(i32::MAX)
}

/// Returns the Rust expression for a sum. The flag is true if the expression is one method call, which needs no
/// parentheses.
///
/// A product of names and numbers is fused with the terms before it by `mul_add`. A sum has at most one fused
/// product, and none if it contains another sum. Nested calls would be hard to read and gain little.
fn sum(terms: &[(bool, DisplayTree)]) -> (TokenStream, bool) {
    let order = order_sum_for_fusion(terms);
    let (mut tokens, mut call) = (TokenStream::new(), false);
    let mut fused = order.iter().any(|(_, term)| !is_sum_free_formula(term));
    for (at, (negative, term)) in order.into_iter().enumerate() {
        if at > 0 && !fused && is_fusible_product(term) {
            let (left, right) = mul_add_operands(term);
            let left = if *negative { quote!((- #left)) } else { left };
            tokens = quote!(#left.mul_add(#right, #tokens));
            (fused, call) = (true, true);
            continue;
        }
        call = false;
        let loose = matches!(term, DisplayTree::Sum(_));
        let term = expression(term);
        let term = if loose { quote!((#term)) } else { term };
        match (at, negative) {
            (0, false) => tokens.extend(term),
            (_, true) => tokens.extend(quote!(- #term)),
            (_, false) => tokens.extend(quote!(+ #term)),
        }
    }
    (tokens, call)
}

/// Splits a product of names and numbers into the receiver and the first argument of a `mul_add` call.
fn mul_add_operands(term: &DisplayTree) -> (TokenStream, TokenStream) {
    let factors = match term {
        DisplayTree::Product(factors) => factors.clone(),
        DisplayTree::Power(base, _) => vec![(**base).clone(); 2],
        other => vec![other.clone()],
    };
    // A number becomes the argument, not the receiver: `x.mul_add(S::int(4), y)`.
    let number = factors.iter().position(|f| matches!(f, DisplayTree::Number(_)));
    let right = number.unwrap_or(factors.len() - 1);
    let mut left = factors;
    let right = expression(&left.remove(right));
    let left = if left.len() == 1 { left.remove(0) } else { DisplayTree::Product(left) };
    (method_receiver_expression(&left), right)
}

/// Returns a formula as a factor of a product, in parentheses if it needs them.
fn factor(view: &DisplayTree) -> TokenStream {
    let (tokens, bound) = match view {
        DisplayTree::Sum(terms) => sum(terms),
        DisplayTree::Fraction(..) => (expression(view), false),
        _ => (expression(view), true),
    };
    if bound { tokens } else { quote!((#tokens)) }
}

/// Returns a formula as the receiver of a Rust method call, in parentheses if it needs them.
pub fn method_receiver_expression(view: &DisplayTree) -> TokenStream {
    let (tokens, bound) = match view {
        DisplayTree::Sum(terms) => sum(terms),
        DisplayTree::Name(_) | DisplayTree::Shared(_) | DisplayTree::Call(..) | DisplayTree::Root(_) => {
            (expression(view), true)
        }
        _ => (expression(view), false),
    };
    if bound { tokens } else { quote!((#tokens)) }
}

/// Returns the Rust expression for a product of formulas.
fn product(factors: &[DisplayTree]) -> TokenStream {
    join_products(&factors.iter().map(factor).collect::<Vec<_>>())
}

/// Joins Rust expressions by `*` into a product.
fn join_products(factors: &[TokenStream]) -> TokenStream {
    let mut tokens = TokenStream::new();
    for (at, factor) in factors.iter().enumerate() {
        if at > 0 {
            tokens.extend(quote!(*));
        }
        tokens.extend(factor.clone());
    }
    tokens
}

/// Returns the Rust expression for a quotient. The whole numbers in numerator and denominator are
/// merged into one exact constant.
fn fraction(above: &DisplayTree, below: &DisplayTree) -> TokenStream {
    let (n, above) = constant_and_factors(above);
    let (d, below) = constant_and_factors(below);
    let mut factors: Vec<TokenStream> = Vec::new();
    if n != "1" || d != "1" || above.is_empty() {
        factors.push(number(&n, &d));
    }
    factors.extend(above.iter().map(factor));
    let numerator = join_products(&factors);
    match below.as_slice() {
        [] => numerator,
        [one] => {
            let product = matches!(one, DisplayTree::Power(..));
            let one = factor(one);
            // A power may be written as a product, which needs parentheses in a denominator.
            if product { quote!(#numerator / (#one)) } else { quote!(#numerator / #one) }
        }
        many => {
            let many: Vec<TokenStream> = many.iter().map(factor).collect();
            let denominator = join_products(&many);
            quote!(#numerator / (#denominator))
        }
    }
}

/// Returns the Rust expression for a power. Squares and cubes of a variable become products; other
/// powers use `powi`.
fn power(base: &DisplayTree, n: i32) -> TokenStream {
    let plain = matches!(base, DisplayTree::Name(_) | DisplayTree::Shared(_));
    let tokens = method_receiver_expression(base);
    if plain && (2..=3).contains(&n) {
        return join_products(&vec![tokens; n.unsigned_abs() as usize]);
    }
    let n = proc_macro2::Literal::i32_unsuffixed(n);
    quote!(#tokens.powi(#n))
}
