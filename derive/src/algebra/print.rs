//! Expressions as people write them: text (which parses back to the same term), LaTeX and `MathML`.
//!
//! Printing for people stops at [`BUDGET`] nodes, since nobody reads further; [`whole_text`] is for programs.

use super::view::{View, view};
use super::{Arena, Expr};
use rustc_hash::FxHashMap;
use std::fmt::Write;

/// Nodes after which a print is cut short with the number of operations left unsaid.
pub const BUDGET: usize = 20_000;

/// Plain text in the language of model files.
#[must_use]
pub fn text(arena: &Arena, e: Expr) -> String {
    let mut out = String::new();
    write_text(&view_of(arena, e), &mut out);
    out
}

/// [`text`] for programs that read it on: cut only beyond two million nodes, where a shared term has grown out of hand.
#[must_use]
pub fn whole_text(arena: &Arena, e: Expr) -> String {
    let mut out = String::new();
    write_text(&view(arena, e, &FxHashMap::default(), 100 * BUDGET), &mut out);
    out
}

/// LaTeX, for math mode.
#[must_use]
pub fn latex(arena: &Arena, e: Expr) -> String {
    let mut out = String::new();
    write_latex(&view_of(arena, e), &mut out);
    out
}

/// Presentation `MathML`: one `mrow` element, to be put inside `math`.
#[must_use]
pub fn mathml(arena: &Arena, e: Expr) -> String {
    mathml_of(&view_of(arena, e))
}

/// [`mathml`] of marks that come from elsewhere.
#[must_use]
pub fn mathml_of(view: &View) -> String {
    let mut out = String::from("<mrow>");
    write_mathml(view, &mut out);
    out.push_str("</mrow>");
    out
}

fn view_of(arena: &Arena, e: Expr) -> View {
    view(arena, e, &FxHashMap::default(), BUDGET)
}

/// Whether a view must stand in parentheses as a factor.
fn is_loose(view: &View) -> bool {
    matches!(view, View::Sum(_))
}

fn parenthesized(view: &View, needed: bool, out: &mut String, write: fn(&View, &mut String)) {
    if needed {
        out.push('(');
    }
    write(view, out);
    if needed {
        out.push(')');
    }
}

fn write_text(view: &View, out: &mut String) {
    match view {
        View::Number(text) | View::Name(text) | View::Shared(text) => out.push_str(text),
        View::Pi => out.push_str("pi"),
        View::Sum(terms) => {
            for (at, (negative, term)) in terms.iter().enumerate() {
                out.push_str(match (at, negative) {
                    (0, false) => "",
                    (0, true) => "-",
                    (_, false) => " + ",
                    (_, true) => " - ",
                });
                parenthesized(term, is_loose(term), out, write_text);
            }
        }
        View::Product(factors) => {
            for (at, factor) in factors.iter().enumerate() {
                if at > 0 {
                    out.push('*');
                }
                parenthesized(factor, is_loose(factor) || matches!(factor, View::Fraction(..)), out, write_text);
            }
        }
        View::Fraction(above, below) => {
            parenthesized(above, is_loose(above), out, write_text);
            out.push('/');
            parenthesized(below, is_loose(below) || matches!(**below, View::Product(_)), out, write_text);
        }
        View::Power(base, n) => {
            let plain = matches!(**base, View::Name(_) | View::Call(..) | View::Root(_) | View::Number(_) | View::Pi);
            parenthesized(base, !plain, out, write_text);
            out.push('^');
            out.push_str(&n.to_string());
        }
        View::Call(name, argument) => {
            out.push_str(name);
            parenthesized(argument, true, out, write_text);
        }
        View::Root(argument) => {
            out.push_str("sqrt");
            parenthesized(argument, true, out, write_text);
        }
        View::Cut => out.push('…'),
    }
}

/// A name split into (letters, subscript, number of primes): `q12'` is (q, 12, 1), `m_p` (m, p, 0).
fn split_name(name: &str) -> (&str, &str, usize) {
    let stem = name.trim_end_matches('\'');
    let primes = name.len() - stem.len();
    if let Some((letters, subscript)) = stem.split_once('_')
        && !letters.is_empty()
        && !subscript.is_empty()
    {
        return (letters, subscript, primes);
    }
    // mA is m with the subscript A.
    if let Some(rest) = stem.get(1..)
        && stem.starts_with(|c: char| c.is_ascii_lowercase())
        && rest.starts_with(|c: char| c.is_ascii_uppercase())
    {
        return (&stem[..1], rest, primes);
    }
    let letters = stem.trim_end_matches(|c: char| c.is_ascii_digit());
    if letters.len() == 1 || letters.len() < stem.len() {
        return (letters, &stem[letters.len()..], primes);
    }
    // I_xx written as Ixx: a capital and what follows.
    if letters.len() <= 4 && letters.starts_with(|c: char| c.is_ascii_uppercase()) {
        return (&letters[..1], &letters[1..], primes);
    }
    (letters, "", primes)
}

const GREEK: [(&str, &str); 29] = [
    ("alpha", "α"),
    ("beta", "β"),
    ("gamma", "γ"),
    ("delta", "δ"),
    ("epsilon", "ε"),
    ("zeta", "ζ"),
    ("eta", "η"),
    ("theta", "θ"),
    ("kappa", "κ"),
    ("lambda", "λ"),
    ("mu", "μ"),
    ("nu", "ν"),
    ("xi", "ξ"),
    ("rho", "ρ"),
    ("sigma", "σ"),
    ("tau", "τ"),
    ("phi", "φ"),
    ("chi", "χ"),
    ("psi", "ψ"),
    ("omega", "ω"),
    ("Gamma", "Γ"),
    ("Delta", "Δ"),
    ("Theta", "Θ"),
    ("Lambda", "Λ"),
    ("Xi", "Ξ"),
    ("Sigma", "Σ"),
    ("Phi", "Φ"),
    ("Psi", "Ψ"),
    ("Omega", "Ω"),
];

/// A symbol's name in LaTeX, `q1'` as `\dot{q}_{1}`.
#[must_use]
pub fn latex_name(name: &str) -> String {
    let (letters, subscript, primes) = split_name(name);
    let letters = match GREEK.iter().find(|(n, _)| *n == letters) {
        Some((greek, _)) => format!("\\{greek}"),
        None if letters.len() > 1 => format!("\\mathrm{{{}}}", letters.replace('_', "\\_")),
        None => letters.to_owned(),
    };
    let dotted = match primes {
        0 => letters,
        1 => format!("\\dot{{{letters}}}"),
        _ => format!("\\ddot{{{letters}}}"),
    };
    if subscript.is_empty() { dotted } else { format!("{dotted}_{{{}}}", subscript.replace('_', "\\_")) }
}

/// A symbol's name in `MathML`, with dots for time derivatives.
#[must_use]
pub fn mathml_name(name: &str) -> String {
    mathml_symbol(name, None)
}

/// A symbol and its power; subscript and exponent stand above each other.
fn mathml_symbol(name: &str, power: Option<i32>) -> String {
    let (letters, subscript, primes) = split_name(name);
    let letters = GREEK.iter().find(|(n, _)| *n == letters).map_or(letters, |(_, greek)| greek);
    let letters = format!("<mi>{letters}</mi>");
    let dotted = match primes {
        0 => letters,
        1 => format!("<mover accent=\"true\">{letters}<mo>˙</mo></mover>"),
        _ => format!("<mover accent=\"true\">{letters}<mo>¨</mo></mover>"),
    };
    let kind = if subscript.bytes().all(|b| b.is_ascii_digit()) { "mn" } else { "mi" };
    match (subscript.is_empty(), power) {
        (true, None) => dotted,
        (true, Some(n)) => format!("<msup>{dotted}<mn>{n}</mn></msup>"),
        (false, None) => format!("<msub>{dotted}<{kind}>{subscript}</{kind}></msub>"),
        (false, Some(n)) => format!("<msubsup>{dotted}<{kind}>{subscript}</{kind}><mn>{n}</mn></msubsup>"),
    }
}

fn write_latex(view: &View, out: &mut String) {
    match view {
        View::Number(text) | View::Shared(text) => out.push_str(text),
        View::Name(name) => out.push_str(&latex_name(name)),
        View::Pi => out.push_str("\\pi"),
        View::Sum(terms) => {
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
        View::Product(factors) => {
            for (at, factor) in factors.iter().enumerate() {
                if at > 0 {
                    out.push_str(" \\, ");
                }
                latex_factor(factor, out);
            }
        }
        View::Fraction(above, below) => {
            out.push_str("\\frac{");
            write_latex(above, out);
            out.push_str("}{");
            write_latex(below, out);
            out.push('}');
        }
        View::Power(base, n) => match &**base {
            View::Call(name @ ("sin" | "cos" | "tan"), argument) => {
                let _ = write!(out, "\\{name}^{{{n}}} ");
                latex_argument(argument, out);
            }
            base => {
                if matches!(base, View::Number(_) | View::Pi | View::Name(_)) {
                    write_latex(base, out);
                } else {
                    out.push_str("\\left(");
                    write_latex(base, out);
                    out.push_str("\\right)");
                }
                let _ = write!(out, "^{{{n}}}");
            }
        },
        View::Call(name, argument) => {
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
        View::Root(argument) => {
            out.push_str("\\sqrt{");
            write_latex(argument, out);
            out.push('}');
        }
        View::Cut => out.push_str("\\ldots"),
    }
}

fn latex_factor(view: &View, out: &mut String) {
    if is_loose(view) {
        out.push_str("\\left(");
        write_latex(view, out);
        out.push_str("\\right)");
    } else {
        write_latex(view, out);
    }
}

fn latex_argument(view: &View, out: &mut String) {
    if matches!(view, View::Name(_)) {
        write_latex(view, out);
    } else {
        out.push_str("\\left(");
        write_latex(view, out);
        out.push_str("\\right)");
    }
}

fn write_mathml(view: &View, out: &mut String) {
    match view {
        View::Number(text) => {
            let _ = write!(out, "<mn>{text}</mn>");
        }
        View::Name(name) | View::Shared(name) => out.push_str(&mathml_name(name)),
        View::Pi => out.push_str("<mi>π</mi>"),
        View::Sum(terms) => {
            for (at, (negative, term)) in terms.iter().enumerate() {
                match (at, negative) {
                    (0, false) => {}
                    (_, true) => out.push_str("<mo>−</mo>"),
                    (_, false) => out.push_str("<mo>+</mo>"),
                }
                mathml_factor(term, out);
            }
        }
        View::Product(factors) => {
            for (at, factor) in factors.iter().enumerate() {
                if at > 0 {
                    let numbers = matches!((&factors[at - 1], factor), (_, View::Number(_)));
                    out.push_str(if numbers { "<mo>·</mo>" } else { "<mspace width=\"0.17em\"/>" });
                }
                mathml_factor(factor, out);
            }
        }
        View::Fraction(above, below) => {
            out.push_str("<mfrac><mrow>");
            write_mathml(above, out);
            out.push_str("</mrow><mrow>");
            write_mathml(below, out);
            out.push_str("</mrow></mfrac>");
        }
        View::Power(base, n) => match &**base {
            View::Call(name @ ("sin" | "cos" | "tan"), argument) => {
                let _ = write!(out, "<msup><mi>{name}</mi><mn>{n}</mn></msup><mo>&#8289;</mo>");
                mathml_argument(argument, out);
            }
            View::Name(name) => out.push_str(&mathml_symbol(name, Some(*n))),
            base => {
                out.push_str("<msup><mrow>");
                if matches!(base, View::Number(_) | View::Pi) {
                    write_mathml(base, out);
                } else {
                    mathml_parenthesized(base, out);
                }
                let _ = write!(out, "</mrow><mn>{n}</mn></msup>");
            }
        },
        View::Call(name, argument) => {
            let _ = write!(out, "<mi>{name}</mi><mo>&#8289;</mo>");
            mathml_argument(argument, out);
        }
        View::Root(argument) => {
            out.push_str("<msqrt>");
            write_mathml(argument, out);
            out.push_str("</msqrt>");
        }
        View::Cut => out.push_str("<mo>…</mo>"),
    }
}

fn mathml_factor(view: &View, out: &mut String) {
    if is_loose(view) {
        mathml_parenthesized(view, out);
    } else {
        write_mathml(view, out);
    }
}

fn mathml_argument(view: &View, out: &mut String) {
    if matches!(view, View::Name(_)) {
        write_mathml(view, out);
    } else {
        mathml_parenthesized(view, out);
    }
}

fn mathml_parenthesized(view: &View, out: &mut String) {
    out.push_str("<mrow><mo>(</mo>");
    write_mathml(view, out);
    out.push_str("<mo>)</mo></mrow>");
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::parse::parse_free;

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
            let printed = text(&arena, e);
            assert_eq!(parse_free(&mut arena, &printed).unwrap(), e, "{printed} parses back");
            assert_eq!(printed, expected);
        }
    }

    #[test]
    fn latex_and_mathml_carry_dots_subscripts_and_fractions() {
        let mut arena = sample();
        let e = parse_free(&mut arena, "M*R^2*q1'*sin(q2)^2/4").unwrap();
        assert_eq!(latex(&arena, e), "\\frac{M \\, R^{2} \\, \\dot{q}_{1} \\, \\sin^{2} q_{2}}{4}");
        assert!(mathml(&arena, e).contains("<mover accent=\"true\"><mi>q</mi><mo>˙</mo></mover>"));
    }
}
