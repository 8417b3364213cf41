//! Formulas as Python with `NumPy` under the name `np` reads them.

use super::parenthesized;
use crate::algebra::view::View;

pub(super) fn write_python(view: &View, out: &mut String) {
    match view {
        View::Number(text) | View::Name(text) | View::Shared(text) => out.push_str(text),
        View::Pi => out.push_str("np.pi"),
        View::Sum(terms) => {
            for (at, (negative, term)) in terms.iter().enumerate() {
                out.push_str(match (at, negative) {
                    (0, false) => "",
                    (0, true) => "-",
                    (_, false) => " + ",
                    (_, true) => " - ",
                });
                parenthesized(term, term.is_loose(), out, write_python);
            }
        }
        View::Product(factors) => {
            for (at, factor) in factors.iter().enumerate() {
                if at > 0 {
                    out.push('*');
                }
                parenthesized(factor, factor.is_loose() || matches!(factor, View::Fraction(..)), out, write_python);
            }
        }
        View::Fraction(above, below) => {
            parenthesized(above, above.is_loose(), out, write_python);
            out.push('/');
            parenthesized(
                below,
                !matches!(**below, View::Number(_) | View::Name(_) | View::Power(..)),
                out,
                write_python,
            );
        }
        View::Power(base, n) => {
            parenthesized(base, !matches!(**base, View::Number(_) | View::Name(_)), out, write_python);
            out.push_str("**");
            out.push_str(&n.to_string());
        }
        View::Call(name, argument) => call(python_name(name), argument, out),
        View::Root(argument) => call("sqrt", argument, out),
        View::Cut => out.push('…'),
    }
}

fn call(name: &str, argument: &View, out: &mut String) {
    out.push_str("np.");
    out.push_str(name);
    parenthesized(argument, true, out, write_python);
}

/// What `NumPy` calls a function.
fn python_name(name: &str) -> &str {
    match name {
        "asin" => "arcsin",
        "acos" => "arccos",
        "atan" => "arctan",
        other => other,
    }
}
