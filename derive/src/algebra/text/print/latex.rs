//! Printing of formulas in LaTeX, for math mode.

use super::print_view;
use super::printed_names::{GREEK, greek_index, is_word, split_name};
use crate::algebra::text::display_tree::DisplayTree;
use crate::algebra::{Arena, Expr};
use std::fmt::Write;

/// Prints an expression in LaTeX for math mode, cut after `BUDGET` nodes.
#[must_use]
pub fn latex(arena: &Arena, e: Expr) -> String {
    latex_of(&print_view(arena, e))
}

/// Prints a display tree in LaTeX for math mode.
#[must_use]
pub fn latex_of(view: &DisplayTree) -> String {
    let mut out = String::new();
    write_latex(view, &mut out);
    out
}

/// Prints a symbol's name in LaTeX. Examples: `q1'` is `\dot{q}_{1}`, `u_psi` is `u_{\psi}`,
/// `q_track` is `q_{\mathrm{track}}`.
#[must_use]
pub fn latex_name(name: &str) -> String {
    let (letters, subscript, primes) = split_name(name);
    let letters = match GREEK.iter().find(|(n, _)| *n == letters) {
        Some((greek, _)) => format!("\\{greek}"),
        None if letters.len() > 1 => format!("\\mathrm{{{}}}", letters.replace('_', "\\_")),
        None => letters.to_owned(),
    };
    let dotted = latex_dots(letters, primes);
    if subscript.is_empty() { dotted } else { format!("{dotted}_{{{}}}", latex_subscript(subscript)) }
}

/// Prints a subscript in LaTeX: a Greek letter with its index, a word in roman type, or indices.
fn latex_subscript(subscript: &str) -> String {
    let escaped = subscript.replace('_', "\\_");
    match greek_index(subscript) {
        Some(((greek, _), "")) => format!("\\{greek}"),
        Some(((greek, _), index)) => format!("\\{greek}_{{{index}}}"),
        None if is_word(subscript) => format!("\\mathrm{{{escaped}}}"),
        None => escaped,
    }
}

/// Prints a symbol's name in LaTeX as a word in roman type without a subscript; primes become dots.
fn latex_name_as_word(name: &str) -> String {
    let stem = name.trim_end_matches('\'');
    latex_dots(format!("\\mathrm{{{}}}", stem.replace('_', "\\_")), name.len() - stem.len())
}

/// Puts dots for time derivatives over a symbol in LaTeX: none, one, or two for any larger number.
fn latex_dots(letters: String, dots: usize) -> String {
    match dots {
        0 => letters,
        1 => format!("\\dot{{{letters}}}"),
        _ => format!("\\ddot{{{letters}}}"),
    }
}

/// Appends a formula in LaTeX to `out`.
pub(super) fn write_latex(view: &DisplayTree, out: &mut String) {
    match view {
        DisplayTree::Number(text) | DisplayTree::Shared(text) => out.push_str(text),
        DisplayTree::Name(name) => out.push_str(&latex_name(name)),
        DisplayTree::Word(name) => out.push_str(&latex_name_as_word(name)),
        DisplayTree::Pi => out.push_str("\\pi"),
        DisplayTree::Sum(terms) => {
            for (at, (negative, term)) in terms.iter().enumerate() {
                out.push_str(match (at, negative) {
                    (0, false) => "",
                    (0, true) => "-",
                    (_, false) => " + ",
                    (_, true) => " - ",
                });
                latex_factor(term, out);
            }
        }
        DisplayTree::Product(factors) => {
            for (at, factor) in factors.iter().enumerate() {
                if at > 0 {
                    out.push_str(" \\, ");
                }
                latex_factor(factor, out);
            }
        }
        DisplayTree::Fraction(above, below) => {
            out.push_str("\\frac{");
            write_latex(above, out);
            out.push_str("}{");
            write_latex(below, out);
            out.push('}');
        }
        DisplayTree::Power(base, n) => match &**base {
            DisplayTree::Call(name @ ("sin" | "cos" | "tan"), argument) => {
                let _ = write!(out, "\\{name}^{{{n}}} ");
                latex_argument(argument, out);
            }
            base => {
                if matches!(
                    base,
                    DisplayTree::Number(_) | DisplayTree::Pi | DisplayTree::Name(_) | DisplayTree::Word(_)
                ) {
                    write_latex(base, out);
                } else {
                    out.push_str("\\left(");
                    write_latex(base, out);
                    out.push_str("\\right)");
                }
                let _ = write!(out, "^{{{n}}}");
            }
        },
        DisplayTree::Call(name, argument) => {
            match *name {
                "asin" => out.push_str("\\arcsin "),
                "acos" => out.push_str("\\arccos "),
                "atan" => out.push_str("\\arctan "),
                "abs" | "sign" => {
                    let _ = write!(out, "\\operatorname{{{name}}} ");
                }
                _ => {
                    let _ = write!(out, "\\{name} ");
                }
            }
            latex_argument(argument, out);
        }
        DisplayTree::Root(argument) => {
            out.push_str("\\sqrt{");
            write_latex(argument, out);
            out.push('}');
        }
        DisplayTree::Cut => out.push_str("\\ldots"),
    }
}

/// Appends a factor of a product to `out`, in parentheses if it is a sum.
fn latex_factor(view: &DisplayTree, out: &mut String) {
    if view.is_loose() {
        out.push_str("\\left(");
        write_latex(view, out);
        out.push_str("\\right)");
    } else {
        write_latex(view, out);
    }
}

/// Appends the argument of a function to `out`, in parentheses unless it is a name.
fn latex_argument(view: &DisplayTree, out: &mut String) {
    if matches!(view, DisplayTree::Name(_) | DisplayTree::Word(_)) {
        write_latex(view, out);
    } else {
        out.push_str("\\left(");
        write_latex(view, out);
        out.push_str("\\right)");
    }
}
