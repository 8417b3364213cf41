//! Printing of expressions: as text, which parses back to the same term; in LaTeX, Typst and
//! `MathML`; and as Python source.
//!
//! A formula printed for people is cut after `BUDGET` nodes, since nobody reads further.
//! [`print_whole_text`] prints formulas for programs, a hundred times as long.

mod latex;
mod line_breaks;
mod long_parts;
mod mathml;
mod printed_names;
mod python;
mod typst;

pub use latex::{latex, latex_name, latex_of};
pub use line_breaks::{break_latex_lines, break_mathml_pieces, break_typst_lines, formula_width};
pub use long_parts::{length_up_to_names, long_parts, printed_length};
pub use mathml::{mathml, mathml_name, mathml_of};
pub(in crate::algebra::text) use printed_names::greek_name;
pub use printed_names::{name_parts, printed_name};
pub use python::{python_of, sympy_of};
pub use typst::{typst_name, typst_of};

use super::display_tree::{DisplayTree, SharedNames, display_tree};
use crate::algebra::{Arena, Expr};
use printed_names::name_printed_alike;
use rustc_hash::FxHashMap;

/// Number of nodes after which a printed expression is cut short.
pub const BUDGET: usize = 20_000;

/// Prints an expression as plain text in the language of model files, cut after `BUDGET` nodes.
#[must_use]
pub fn print_text(arena: &Arena, e: Expr) -> String {
    text_of(&display_tree(arena, e, &FxHashMap::default(), BUDGET))
}

/// Prints a display tree as plain text in the language of model files.
#[must_use]
pub fn text_of(view: &DisplayTree) -> String {
    let mut out = String::new();
    write_text(view, &mut out);
    out
}

/// Prints an expression as plain text for programs. It is cut only after two million nodes; terms
/// that are shared often can reach this size.
#[must_use]
pub fn print_whole_text(arena: &Arena, e: Expr) -> String {
    let mut out = String::new();
    write_text(&print_whole_view(arena, e, &FxHashMap::default()), &mut out);
    out
}

/// Builds the display tree of the term `e`, cut only after two million nodes. Other terms that are
/// in `shared` are shown by their names.
#[must_use]
pub fn print_whole_view(arena: &Arena, e: Expr, shared: &SharedNames) -> DisplayTree {
    display_tree(arena, e, shared, 100 * BUDGET)
}

/// Builds the display tree of a term, cut after `BUDGET` nodes. If a symbol with a subscript would
/// look like another symbol, it is printed as a word.
#[must_use]
pub fn print_view(arena: &Arena, e: Expr) -> DisplayTree {
    with_distinct_names(arena, display_tree(arena, e, &FxHashMap::default(), BUDGET))
}

/// Display tree of a symbol, by its printed name. The symbol is a whole word if another symbol
/// would look the same with its subscript.
#[must_use]
pub fn print_symbol_view(arena: &Arena, name: &str) -> DisplayTree {
    if arena.names.printed.contains_key(name.trim_end_matches('\'')) {
        return DisplayTree::Name(printed_name(arena, name));
    }
    let looks_like_another = name_printed_alike(name).is_some_and(|other| arena.find_symbol(&other).is_some());
    if looks_like_another { DisplayTree::Word(name.to_owned()) } else { DisplayTree::Name(name.to_owned()) }
}

/// Replaces the names in a display tree by printed names. Symbols that would look like other
/// symbols become words.
fn with_distinct_names(arena: &Arena, view: DisplayTree) -> DisplayTree {
    let boxed = |part: Box<DisplayTree>| Box::new(with_distinct_names(arena, *part));
    match view {
        DisplayTree::Name(name) => print_symbol_view(arena, &name),
        DisplayTree::Sum(terms) => {
            DisplayTree::Sum(terms.into_iter().map(|(sign, term)| (sign, with_distinct_names(arena, term))).collect())
        }
        DisplayTree::Product(factors) => {
            DisplayTree::Product(factors.into_iter().map(|factor| with_distinct_names(arena, factor)).collect())
        }
        DisplayTree::Fraction(above, below) => DisplayTree::Fraction(boxed(above), boxed(below)),
        DisplayTree::Power(base, n) => DisplayTree::Power(boxed(base), n),
        DisplayTree::Call(name, argument) => DisplayTree::Call(name, boxed(argument)),
        DisplayTree::Root(argument) => DisplayTree::Root(boxed(argument)),
        other => other,
    }
}

/// Spelling of operators and functions in a language that writes formulas on one line.
struct Spelling {
    /// Text of the constant π in the language.
    pi: &'static str,
    /// Operator of powers, such as `^`.
    power: &'static str,
    /// Name of a function in the language, given its name in model files.
    function: fn(&'static str) -> String,
    /// Function for the exact quotient of two integers, in a language whose `/` would round; `None`
    /// if `/` is exact enough.
    quotient: Option<&'static str>,
}

/// Spelling of operators and functions in model files.
const TEXT: Spelling = Spelling { pi: "pi", power: "^", function: str::to_owned, quotient: None };

/// Appends a display tree to `out` as text of model files.
fn write_text(view: &DisplayTree, out: &mut String) {
    write_line(view, &TEXT, out);
}

/// Appends a display tree to `out` on one line, in the given spelling, with parentheses where
/// needed.
fn write_line(view: &DisplayTree, spelling: &Spelling, out: &mut String) {
    let part = |view: &DisplayTree, needs_parentheses: bool, out: &mut String| {
        out.push_str(if needs_parentheses { "(" } else { "" });
        write_line(view, spelling, out);
        out.push_str(if needs_parentheses { ")" } else { "" });
    };
    match view {
        DisplayTree::Number(text) | DisplayTree::Name(text) | DisplayTree::Word(text) | DisplayTree::Shared(text) => {
            out.push_str(text);
        }
        DisplayTree::Pi => out.push_str(spelling.pi),
        DisplayTree::Sum(terms) => {
            for (at, (negative, term)) in terms.iter().enumerate() {
                out.push_str(match (at, negative) {
                    (0, false) => "",
                    (0, true) => "-",
                    (_, false) => " + ",
                    (_, true) => " - ",
                });
                part(term, term.is_loose(), out);
            }
        }
        DisplayTree::Product(factors) => {
            for (at, factor) in factors.iter().enumerate() {
                if at > 0 {
                    out.push('*');
                }
                part(factor, factor.is_loose() || matches!(factor, DisplayTree::Fraction(..)), out);
            }
        }
        DisplayTree::Fraction(above, below) => {
            if let (Some(quotient), DisplayTree::Number(above), DisplayTree::Number(below)) =
                (spelling.quotient, &**above, &**below)
            {
                out.extend([quotient, "(", above, ", ", below, ")"]);
                return;
            }
            part(above, above.is_loose(), out);
            out.push('/');
            part(below, below.is_loose() || matches!(**below, DisplayTree::Product(_)), out);
        }
        DisplayTree::Power(base, n) => {
            let plain = matches!(
                **base,
                DisplayTree::Name(_)
                    | DisplayTree::Word(_)
                    | DisplayTree::Shared(_)
                    | DisplayTree::Call(..)
                    | DisplayTree::Root(_)
                    | DisplayTree::Number(_)
                    | DisplayTree::Pi
            );
            part(base, !plain, out);
            out.push_str(spelling.power);
            out.push_str(&n.to_string());
        }
        DisplayTree::Call(name, argument) => {
            out.push_str(&(spelling.function)(name));
            part(argument, true, out);
        }
        DisplayTree::Root(argument) => {
            out.push_str(&(spelling.function)("sqrt"));
            part(argument, true, out);
        }
        DisplayTree::Cut => out.push('…'),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::text::parse::parse_free;

    fn sample() -> Arena {
        let mut arena = Arena::new();
        for name in ["M", "R", "g", "q1", "q2", "u1", "u2", "u3"] {
            arena.symbol(name);
        }
        arena
    }

    #[test]
    fn formulas_read_as_written_by_hand() {
        let mut arena = sample();
        for (input, expected) in [
            ("-R*u2*tan(q2) + u1*cos(q1)", "u1*cos(q1) - R*u2*tan(q2)"),
            ("M*R^2/4", "M*R^2/4"),
            ("u2/cos(q2)", "u2/cos(q2)"),
            ("3*u1*u3 - 2*tan(q2)*u1*u2", "3*u1*u3 - 2*u1*u2*tan(q2)"),
            ("(1 + 4*sin(q2)^2)/(2*R*(1 + M))", "(1 + 4*sin(q2)^2)/(2*R*(1 + M))"),
            ("-x", "-x"),
            ("1/2", "1/2"),
            ("cos(q2)/sin(q2)", "1/tan(q2)"),
        ] {
            let e = parse_free(&mut arena, input).unwrap();
            let printed = print_text(&arena, e);
            assert_eq!(parse_free(&mut arena, &printed).unwrap(), e, "{printed} parses back");
            assert_eq!(printed, expected);
        }
    }

    #[test]
    fn symbols_that_would_look_alike_are_told_apart() {
        let mut arena = Arena::new();
        let e = parse_free(&mut arena, "l1*l_1*m_p^2").unwrap();
        assert_eq!(latex(&arena, e), "l_{1} \\, \\mathrm{l\\_1} \\, m_{p}^{2}");
        assert!(mathml(&arena, e).contains("<mi>l_1</mi>"));
        assert_eq!(print_text(&arena, e), "l1*l_1*m_p^2");
    }

    #[test]
    fn latex_and_mathml_carry_dots_subscripts_and_fractions() {
        let mut arena = sample();
        let e = parse_free(&mut arena, "M*R^2*q1'*sin(q2)^2/4").unwrap();
        assert_eq!(latex(&arena, e), "\\frac{M \\, R^{2} \\, \\dot{q}_{1} \\, \\sin^{2} q_{2}}{4}");
        assert!(mathml(&arena, e).contains("<mover accent=\"true\"><mi>q</mi><mo>˙</mo></mover>"));
    }
}
