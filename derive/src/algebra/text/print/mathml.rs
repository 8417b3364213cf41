//! Printing of formulas in presentation `MathML`.

use super::print_view;
use super::printed_names::{GREEK, greek_index, split_name};
use crate::algebra::text::display_tree::DisplayTree;
use crate::algebra::{Arena, Expr};
use std::fmt::Write;

/// Prints an expression in presentation `MathML`, cut after `BUDGET` nodes: one `mrow` element,
/// to be put inside `math`.
#[must_use]
pub fn mathml(arena: &Arena, e: Expr) -> String {
    mathml_of(&print_view(arena, e))
}

/// Prints a display tree in presentation `MathML`: one `mrow` element, to be put inside `math`.
#[must_use]
pub fn mathml_of(view: &DisplayTree) -> String {
    let mut out = String::from("<mrow>");
    write_mathml(view, &mut out);
    out.push_str("</mrow>");
    out
}

/// Prints a symbol's name in `MathML`: with a subscript, and with dots for time derivatives.
#[must_use]
pub fn mathml_name(name: &str) -> String {
    mathml_symbol(name, None)
}

/// Prints a symbol in `MathML`. If it has an exponent, this is directly above the subscript.
fn mathml_symbol(name: &str, power: Option<i32>) -> String {
    let (letters, subscript, primes) = split_name(name);
    let letters = GREEK.iter().find(|(n, _)| *n == letters).map_or(letters, |(_, greek)| greek);
    let letters = format!("<mi>{letters}</mi>");
    let dotted = mathml_dots(letters, primes);
    let below = mathml_subscript(subscript);
    match (subscript.is_empty(), power) {
        (true, None) => dotted,
        (true, Some(n)) => format!("<msup>{dotted}<mn>{n}</mn></msup>"),
        (false, None) => format!("<msub>{dotted}{below}</msub>"),
        (false, Some(n)) => format!("<msubsup>{dotted}{below}<mn>{n}</mn></msubsup>"),
    }
}

/// Prints a subscript in `MathML`: a Greek letter with its index, a number, or letters.
fn mathml_subscript(subscript: &str) -> String {
    match greek_index(subscript) {
        Some(((_, greek), "")) => format!("<mi>{greek}</mi>"),
        Some(((_, greek), index)) => format!("<msub><mi>{greek}</mi><mn>{index}</mn></msub>"),
        None if subscript.bytes().all(|b| b.is_ascii_digit()) => format!("<mn>{subscript}</mn>"),
        None => format!("<mi>{subscript}</mi>"),
    }
}

/// Prints a symbol's name in `MathML` as a word without a subscript; primes become dots.
fn mathml_word(name: &str) -> String {
    let stem = name.trim_end_matches('\'');
    mathml_dots(format!("<mi>{stem}</mi>"), name.len() - stem.len())
}

/// Puts dots for time derivatives over a symbol in `MathML`: none, one, or two for any larger
/// number.
fn mathml_dots(letters: String, dots: usize) -> String {
    match dots {
        0 => letters,
        1 => format!("<mover accent=\"true\">{letters}<mo>˙</mo></mover>"),
        _ => format!("<mover accent=\"true\">{letters}<mo>¨</mo></mover>"),
    }
}

/// Appends a formula in `MathML` to `out`.
pub(super) fn write_mathml(view: &DisplayTree, out: &mut String) {
    match view {
        DisplayTree::Number(text) => {
            let _ = write!(out, "<mn>{text}</mn>");
        }
        DisplayTree::Name(name) | DisplayTree::Shared(name) => out.push_str(&mathml_name(name)),
        DisplayTree::Word(name) => out.push_str(&mathml_word(name)),
        DisplayTree::Pi => out.push_str("<mi>π</mi>"),
        DisplayTree::Sum(terms) => {
            for (at, (negative, term)) in terms.iter().enumerate() {
                match (at, negative) {
                    (0, false) => {}
                    (_, true) => out.push_str("<mo>−</mo>"),
                    (_, false) => out.push_str("<mo>+</mo>"),
                }
                mathml_factor(term, out);
            }
        }
        DisplayTree::Product(factors) => {
            for (at, factor) in factors.iter().enumerate() {
                if at > 0 {
                    out.push_str(mathml_sign_between_factors(factor));
                }
                mathml_factor(factor, out);
            }
        }
        DisplayTree::Fraction(above, below) => {
            out.push_str("<mfrac><mrow>");
            write_mathml(above, out);
            out.push_str("</mrow><mrow>");
            write_mathml(below, out);
            out.push_str("</mrow></mfrac>");
        }
        DisplayTree::Power(base, n) => match &**base {
            DisplayTree::Call(name @ ("sin" | "cos" | "tan"), argument) => {
                let _ = write!(out, "<msup><mi>{name}</mi><mn>{n}</mn></msup>");
                mathml_argument(argument, out);
            }
            DisplayTree::Name(name) => out.push_str(&mathml_symbol(name, Some(*n))),
            base => {
                out.push_str("<msup><mrow>");
                if matches!(base, DisplayTree::Number(_) | DisplayTree::Pi | DisplayTree::Word(_)) {
                    write_mathml(base, out);
                } else {
                    mathml_parenthesized(base, out);
                }
                let _ = write!(out, "</mrow><mn>{n}</mn></msup>");
            }
        },
        DisplayTree::Call(name, argument) => {
            let _ = write!(out, "<mi>{name}</mi>");
            mathml_argument(argument, out);
        }
        DisplayTree::Root(argument) => {
            out.push_str("<msqrt>");
            write_mathml(argument, out);
            out.push_str("</msqrt>");
        }
        DisplayTree::Cut => out.push_str("<mo>…</mo>"),
    }
}

/// Sign between two factors in `MathML`, given the second factor: a dot before a number, else a
/// thin space.
pub(super) fn mathml_sign_between_factors(factor: &DisplayTree) -> &'static str {
    if matches!(factor, DisplayTree::Number(_)) { "<mo>·</mo>" } else { "<mspace width=\"0.17em\"/>" }
}

/// Appends a factor of a product to `out`, in parentheses if it is a sum.
fn mathml_factor(view: &DisplayTree, out: &mut String) {
    if view.is_loose() {
        mathml_parenthesized(view, out);
    } else {
        write_mathml(view, out);
    }
}

/// Appends the argument of a function to `out`, after the invisible operator of function
/// application.
fn mathml_argument(view: &DisplayTree, out: &mut String) {
    if matches!(view, DisplayTree::Name(_) | DisplayTree::Word(_)) {
        // Browsers leave no space between a function and an argument without parentheses.
        out.push_str("<mo rspace=\"0.17em\">\u{2061}</mo>");
        write_mathml(view, out);
    } else {
        out.push_str("<mo>\u{2061}</mo>");
        mathml_parenthesized(view, out);
    }
}

/// Appends a formula in parentheses to `out`.
fn mathml_parenthesized(view: &DisplayTree, out: &mut String) {
    out.push_str("<mrow><mo>(</mo>");
    write_mathml(view, out);
    out.push_str("<mo>)</mo></mrow>");
}
