//! Formulas in lines that a page can hold: they break at their signs, also within parentheses, alike in every language.
//!
//! Invariant: the lines one after another are the formula, whatever they are broken at. Widths are estimates, in tenths of an em; what is one fraction, or one
//! root, is never broken.

use super::latex::write_latex;
use super::typst::write_typst;
use crate::algebra::view::View;

/// How a language writes what stands where lines break.
struct Marks {
    write: fn(&View, &mut String),
    /// Signs between terms, which a line may begin with.
    plus: &'static str,
    minus: &'static str,
    /// What stands between factors.
    times: &'static str,
    /// Parentheses around what is on one line, which have its height.
    whole: [&'static str; 2],
    /// Parentheses that need not be on one line, of one height.
    broken: [&'static str; 2],
    power: fn(i32) -> String,
}

const LATEX: Marks = Marks {
    write: write_latex,
    plus: "{} + ",
    minus: "{} - ",
    times: " \\, ",
    whole: ["\\left(", "\\right)"],
    broken: ["\\bigl(", "\\bigr)"],
    power: |n| format!("^{{{n}}}"),
};

/// Escaped parentheses are marks like any other: Typst lets no line break between those that it pairs.
const TYPST: Marks = Marks {
    write: write_typst,
    plus: " + ",
    minus: " - ",
    times: " thin ",
    whole: ["(", ")"],
    broken: ["\\( ", "\\)"],
    power: |n| format!("^{n}"),
};

/// A part of a formula that no line breaks.
struct Piece {
    text: String,
    width: usize,
    /// Whether a line may begin with it.
    breaks: bool,
}

/// The lines of a formula in LaTeX that are each about so wide, in tenths of an em.
#[must_use]
pub fn latex_lines(view: &View, widest: usize) -> Vec<String> {
    Breaking { marks: &LATEX, widest }.lines(view)
}

/// The lines of a formula in Typst that are each about so wide, in tenths of an em.
#[must_use]
pub fn typst_lines(view: &View, widest: usize) -> Vec<String> {
    Breaking { marks: &TYPST, widest }.lines(view)
}

/// A formula that is being broken.
struct Breaking {
    marks: &'static Marks,
    /// The width of a line, in tenths of an em.
    widest: usize,
}

impl Breaking {
    /// The lines.
    fn lines(&self, view: &View) -> Vec<String> {
        let mut pieces = Vec::new();
        self.flatten(view, &mut pieces);
        let (mut lines, mut width) = (vec![String::new()], 0);
        for piece in pieces {
            if piece.breaks && width > 0 && width + piece.width > self.widest {
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

    /// Appends a formula in pieces, whole if it fits.
    fn flatten(&self, view: &View, out: &mut Vec<Piece>) {
        let width = formula_width(view);
        if width <= self.widest { self.push(out, view, width) } else { self.split(view, out) }
    }

    /// Appends a formula in pieces.
    fn split(&self, view: &View, out: &mut Vec<Piece>) {
        match view {
            View::Sum(terms) => {
                for (at, (negative, term)) in terms.iter().enumerate() {
                    let sign = match (at, negative) {
                        (0, false) => "",
                        (0, true) => "-",
                        (_, false) => self.marks.plus,
                        (_, true) => self.marks.minus,
                    };
                    out.push(Piece { text: sign.to_owned(), width: 0, breaks: at > 0 });
                    let first = out.len();
                    self.factor(term, out);
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
                        out.push(Piece { text: self.marks.times.to_owned(), width: 2, breaks: false });
                    }
                    self.factor(one, out);
                }
            }
            // n a/b as (n/b) a.
            View::Fraction(above, below) if matches!(**above, View::Sum(_) | View::Product(_)) => {
                let (number, rest) = without_number(above);
                let first = View::Fraction(Box::new(View::Number(number)), below.clone());
                self.push(out, &first, formula_width(&first));
                out.push(Piece { text: self.marks.times.to_owned(), width: 2, breaks: false });
                self.factor(&rest, out);
            }
            View::Power(base, n) if matches!(**base, View::Sum(_) | View::Product(_)) => {
                self.enclosed(base, out);
                out.push(Piece { text: (self.marks.power)(*n), width: 4, breaks: false });
            }
            _ => self.push(out, view, formula_width(view)),
        }
    }

    /// Appends a factor: a sum that does not fit stands in parentheses that lines may break.
    fn factor(&self, view: &View, out: &mut Vec<Piece>) {
        let width = factor_width(view);
        if !view.is_loose() {
            return self.flatten(view, out);
        }
        if width > self.widest / 2 {
            return self.enclosed(view, out);
        }
        let [open, close] = self.marks.whole;
        let mut text = open.to_owned();
        (self.marks.write)(view, &mut text);
        text.push_str(close);
        out.push(Piece { text, width, breaks: false });
    }

    /// Appends a formula in parentheses of one size, term by term.
    fn enclosed(&self, view: &View, out: &mut Vec<Piece>) {
        let [open, close] = self.marks.broken;
        out.push(Piece { text: open.to_owned(), width: 5, breaks: false });
        self.split(view, out);
        out.push(Piece { text: close.to_owned(), width: 5, breaks: false });
    }

    fn push(&self, out: &mut Vec<Piece>, view: &View, width: usize) {
        let mut text = String::new();
        (self.marks.write)(view, &mut text);
        out.push(Piece { text, width, breaks: false });
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

/// About how wide a formula is, in tenths of an em.
#[must_use]
pub fn formula_width(view: &View) -> usize {
    match view {
        View::Number(text) | View::Shared(text) => 5 * text.len(),
        View::Name(name) => name_width(name),
        View::Pi => 6,
        View::Sum(terms) => terms.iter().map(|(_, term)| 15 + factor_width(term)).sum(),
        View::Product(factors) => factors.iter().map(|factor| 2 + factor_width(factor)).sum(),
        View::Fraction(above, below) => 3 + formula_width(above).max(formula_width(below)),
        View::Power(base, n) => 4 * n.to_string().len() + factor_width(base),
        View::Call(name, argument) => 5 * name.len() + 2 + argument_width(argument),
        View::Root(argument) => 9 + formula_width(argument),
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
    formula_width(view) + if view.is_loose() { 9 } else { 0 }
}

fn argument_width(view: &View) -> usize {
    formula_width(view) + if matches!(view, View::Name(_)) { 0 } else { 9 }
}
