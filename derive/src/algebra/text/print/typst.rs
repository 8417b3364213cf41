//! Printing of formulas in Typst, for math mode.

use super::printed_names::{GREEK, greek_index, split_name};
use crate::algebra::text::display_tree::DisplayTree;
use std::fmt::Write;

/// Prints a display tree in Typst for math mode.
#[must_use]
pub fn typst_of(view: &DisplayTree) -> String {
    let mut out = String::new();
    write_typst(view, &mut out);
    out
}

/// Prints a symbol's name in Typst: `q1'` as `dot(q)_1`.
#[must_use]
pub fn typst_name(name: &str) -> String {
    let (letters, subscript, primes) = split_name(name);
    let letters = if GREEK.iter().any(|(greek, _)| *greek == letters) {
        letters.to_owned()
    } else {
        typst_word_or_letter(letters)
    };
    let dotted = typst_dots(letters, primes);
    match (subscript, greek_index(subscript)) {
        ("", _) => dotted,
        (_, Some(((greek, _), ""))) => format!("{dotted}_{greek}"),
        (_, Some(((greek, _), index))) => format!("{dotted}_({greek}_{index})"),
        (digits, None) if digits.bytes().all(|b| b.is_ascii_digit()) => format!("{dotted}_{digits}"),
        (word, None) => format!("{dotted}_{}", typst_word_or_letter(word)),
    }
}

/// Prints a symbol's name in Typst as a word without a subscript; primes become dots.
fn typst_word(name: &str) -> String {
    let stem = name.trim_end_matches('\'');
    typst_dots(typst_word_or_letter(stem), name.len() - stem.len())
}

/// Puts dots for time derivatives over a symbol in Typst: none, one, or two for any larger number.
fn typst_dots(letters: String, dots: usize) -> String {
    match dots {
        0 => letters,
        1 => format!("dot({letters})"),
        _ => format!("dot.double({letters})"),
    }
}

/// Prints a letter or a word in Typst. A word is put in quotes, because Typst would read it as the
/// name of a function or variable.
fn typst_word_or_letter(word: &str) -> String {
    if word.len() == 1 { word.to_owned() } else { format!("\"{}\"", word.replace('\\', "\\\\").replace('"', "\\\"")) }
}

/// Appends a formula in Typst to `out`. Adjacent symbols are separated by spaces: Typst reads
/// `f(x)` as a call, and letters without spaces as a word.
pub(super) fn write_typst(view: &DisplayTree, out: &mut String) {
    match view {
        DisplayTree::Number(text) | DisplayTree::Shared(text) => out.push_str(text),
        DisplayTree::Name(name) => out.push_str(&typst_name(name)),
        DisplayTree::Word(name) => out.push_str(&typst_word(name)),
        DisplayTree::Pi => out.push_str("pi"),
        DisplayTree::Sum(terms) => {
            for (at, (negative, term)) in terms.iter().enumerate() {
                out.push_str(match (at, negative) {
                    (0, false) => "",
                    (0, true) => "-",
                    (_, false) => " + ",
                    (_, true) => " - ",
                });
                typst_part(term, |term| !term.is_loose(), out);
            }
        }
        DisplayTree::Product(factors) => {
            for (at, factor) in factors.iter().enumerate() {
                out.push_str(if at > 0 { " thin " } else { "" });
                typst_part(factor, |factor| !factor.is_loose(), out);
            }
        }
        DisplayTree::Fraction(above, below) => {
            out.push_str("frac(");
            write_typst(above, out);
            out.push_str(", ");
            write_typst(below, out);
            out.push(')');
        }
        DisplayTree::Power(base, n) => match &**base {
            DisplayTree::Call(name @ ("sin" | "cos" | "tan"), argument) => {
                let _ = write!(out, "{name}^{n} ");
                typst_part(argument, is_name, out);
            }
            base => {
                typst_part(base, is_atom, out);
                let _ = write!(out, "^{n}");
            }
        },
        DisplayTree::Call("abs", argument) => typst_call("abs", argument, out),
        DisplayTree::Call(name, argument) => {
            match *name {
                "asin" => out.push_str("arcsin "),
                "acos" => out.push_str("arccos "),
                "atan" => out.push_str("arctan "),
                "sign" => out.push_str("op(\"sign\") "),
                name => {
                    let _ = write!(out, "{name} ");
                }
            }
            typst_part(argument, is_name, out);
        }
        DisplayTree::Root(argument) => typst_call("sqrt", argument, out),
        DisplayTree::Cut => out.push_str("dots"),
    }
}

/// Appends a part of a formula to `out`. It gets parentheses unless the function `stands_alone`
/// returns true for it.
fn typst_part(view: &DisplayTree, stands_alone: fn(&DisplayTree) -> bool, out: &mut String) {
    if stands_alone(view) {
        write_typst(view, out);
    } else {
        out.push('(');
        write_typst(view, out);
        out.push(')');
    }
}

/// True if a formula is a name, which needs no parentheses as the argument of a function.
fn is_name(view: &DisplayTree) -> bool {
    matches!(view, DisplayTree::Name(_) | DisplayTree::Word(_))
}

/// True if a formula is a number or a name, which needs no parentheses as the base of a power.
fn is_atom(view: &DisplayTree) -> bool {
    is_name(view) || matches!(view, DisplayTree::Number(_) | DisplayTree::Pi)
}

/// Appends the call of a Typst function to `out`, such as `sqrt(x)`. The function draws a root sign
/// or bars around its argument.
fn typst_call(name: &str, argument: &DisplayTree, out: &mut String) {
    let _ = write!(out, "{name}(");
    write_typst(argument, out);
    out.push(')');
}
