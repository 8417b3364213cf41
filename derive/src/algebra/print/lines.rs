//! LaTeX in lines that a page can hold: formulas break at their signs, also within parentheses.
//!
//! Invariant: the lines one after another are the formula, whatever they are broken at. Widths are estimates, in tenths of an em; what is one fraction, or one
//! root, is never broken.

use super::latex::write_latex;
use crate::algebra::view::View;

/// A part of a formula that no line breaks.
struct Piece {
    text: String,
    width: usize,
    /// Whether a line may begin with it.
    breaks: bool,
}

/// The lines of a formula that are each about so wide, in tenths of an em.
#[must_use]
pub fn latex_lines(view: &View, widest: usize) -> Vec<String> {
    let mut pieces = Vec::new();
    flatten(view, widest, &mut pieces);
    let (mut lines, mut width) = (vec![String::new()], 0);
    for piece in pieces {
        if piece.breaks && width > 0 && width + piece.width > widest {
            lines.push(String::new());
            width = 0;
        }
        width += piece.width;
        if let Some(line) = lines.last_mut() {
            line.push_str(&piece.text);
        }
    }
    lines
}

/// About how wide a formula is, in tenths of an em.
#[must_use]
pub fn latex_width(view: &View) -> usize {
    match view {
        View::Number(text) | View::Shared(text) => 5 * text.len(),
        View::Name(name) => name_width(name),
        View::Pi => 6,
        View::Sum(terms) => terms.iter().map(|(_, term)| 15 + factor_width(term)).sum(),
        View::Product(factors) => factors.iter().map(|factor| 2 + factor_width(factor)).sum(),
        View::Fraction(above, below) => 3 + latex_width(above).max(latex_width(below)),
        View::Power(base, n) => 4 * n.to_string().len() + factor_width(base),
        View::Call(name, argument) => 5 * name.len() + 2 + argument_width(argument),
        View::Root(argument) => 9 + latex_width(argument),
        View::Cut => 10,
    }
}

/// A letter or word with its subscript.
fn name_width(name: &str) -> usize {
    let (letters, subscript, _) = super::name::split_name(name);
    let letters = if super::name::GREEK.iter().any(|(greek, _)| *greek == letters) { 6 } else { 6 * letters.len() };
    letters + 4 * subscript.len()
}

fn factor_width(view: &View) -> usize {
    latex_width(view) + if view.is_loose() { 9 } else { 0 }
}

fn argument_width(view: &View) -> usize {
    latex_width(view) + if matches!(view, View::Name(_)) { 0 } else { 9 }
}

/// Appends a formula in pieces, whole if it fits.
fn flatten(view: &View, widest: usize, out: &mut Vec<Piece>) {
    let width = latex_width(view);
    if width <= widest { push(out, view, width) } else { split(view, widest, out) }
}

/// Appends a formula in pieces.
fn split(view: &View, widest: usize, out: &mut Vec<Piece>) {
    match view {
        View::Sum(terms) => {
            for (at, (negative, term)) in terms.iter().enumerate() {
                let sign = match (at, negative) {
                    (0, false) => "",
                    (0, true) => "-",
                    (_, false) => "{} + ",
                    (_, true) => "{} - ",
                };
                out.push(Piece { text: sign.to_owned(), width: 0, breaks: at > 0 });
                let first = out.len();
                factor(term, widest, out);
                // The sign goes with what it stands in front of.
                if let [sign, next, ..] = &mut out[first - 1..] {
                    sign.width = 15 + next.width;
                    next.width = 0;
                    next.breaks = false;
                }
            }
        }
        View::Product(factors) => {
            for (at, one) in factors.iter().enumerate() {
                if at > 0 {
                    out.push(Piece { text: " \\, ".to_owned(), width: 2, breaks: false });
                }
                factor(one, widest, out);
            }
        }
        // n a/b as (n/b) a.
        View::Fraction(above, below) if matches!(**above, View::Sum(_) | View::Product(_)) => {
            let (number, rest) = without_number(above);
            let first = View::Fraction(Box::new(View::Number(number)), below.clone());
            push(out, &first, latex_width(&first));
            out.push(Piece { text: " \\, ".to_owned(), width: 2, breaks: false });
            factor(&rest, widest, out);
        }
        View::Power(base, n) if matches!(**base, View::Sum(_) | View::Product(_)) => {
            enclosed(base, widest, out);
            out.push(Piece { text: format!("^{{{n}}}"), width: 4, breaks: false });
        }
        _ => push(out, view, latex_width(view)),
    }
}

/// The number in front of a product, 1 if there is none, and the rest.
fn without_number(view: &View) -> (String, View) {
    match view {
        View::Product(factors) => match factors.split_first() {
            Some((View::Number(number), [one])) => (number.clone(), one.clone()),
            Some((View::Number(number), rest)) => (number.clone(), View::Product(rest.to_vec())),
            _ => ("1".to_owned(), view.clone()),
        },
        _ => ("1".to_owned(), view.clone()),
    }
}

/// Appends a factor: a sum that does not fit stands in parentheses that lines may break.
fn factor(view: &View, widest: usize, out: &mut Vec<Piece>) {
    let width = factor_width(view);
    if !view.is_loose() {
        return flatten(view, widest, out);
    }
    if width > widest / 2 {
        return enclosed(view, widest, out);
    }
    let mut text = "\\left(".to_owned();
    write_latex(view, &mut text);
    text.push_str("\\right)");
    out.push(Piece { text, width, breaks: false });
}

/// Appends a formula in parentheses of one size, term by term.
fn enclosed(view: &View, widest: usize, out: &mut Vec<Piece>) {
    out.push(Piece { text: "\\bigl(".to_owned(), width: 5, breaks: false });
    split(view, widest, out);
    out.push(Piece { text: "\\bigr)".to_owned(), width: 5, breaks: false });
}

fn push(out: &mut Vec<Piece>, view: &View, width: usize) {
    let mut text = String::new();
    write_latex(view, &mut text);
    out.push(Piece { text, width, breaks: false });
}
