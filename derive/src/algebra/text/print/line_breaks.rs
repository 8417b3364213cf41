//! Breaking of long formulas into lines that fit a page. Lines break at plus and minus signs, also
//! within parentheses, at the same places in LaTeX, Typst and `MathML`.
//!
//! Invariant: the joined lines are the whole formula. Widths are estimates, in tenths of an em. No
//! line breaks within a root or within the argument of a function.

use super::latex::write_latex;
use super::mathml::{mathml_sign_between_factors, write_mathml};
use super::typst::write_typst;
use crate::algebra::text::display_tree::DisplayTree;

/// Spelling, in one language, of the signs at which lines may break.
struct Marks {
    /// Function that appends a formula without line breaks.
    write: fn(&DisplayTree, &mut String),
    /// Minus sign at the beginning of a formula or of parentheses.
    negative: &'static str,
    /// Plus sign between terms; a line may begin with it.
    plus: &'static str,
    /// Minus sign between terms; a line may begin with it.
    minus: &'static str,
    /// Function that returns the sign before a factor, given that factor.
    times: fn(&DisplayTree) -> &'static str,
    /// Multiplication sign at the beginning of a line, if the line breaks between two factors.
    cross: &'static str,
    /// Opening and closing parenthesis around content on one line; their height is that of the
    /// content.
    whole: [&'static str; 2],
    /// Opening and closing parenthesis around content that may break over lines; their height is
    /// fixed.
    broken: [&'static str; 2],
    /// Function that writes an exponent after a base in parentheses.
    power: fn(i32) -> String,
    /// Division sign of a fraction that is broken over lines.
    slash: &'static str,
    /// True if a fraction with a wide numerator is written with a slash. False if such a fraction n
    /// a/b is written as (n/b) a, with a leading number n.
    slashes_numerators: bool,
}

/// Signs of LaTeX at which lines may break.
const LATEX: Marks = Marks {
    write: write_latex,
    negative: "-",
    plus: "{} + ",
    minus: "{} - ",
    times: |_| " \\, ",
    cross: "{} \\times ",
    whole: ["\\left(", "\\right)"],
    broken: ["\\bigl(", "\\bigr)"],
    power: |n| format!("^{{{n}}}"),
    slash: " / ",
    slashes_numerators: false,
};

/// Signs of Typst at which lines may break. Parentheses are escaped, because Typst breaks no line
/// between a pair of plain parentheses.
const TYPST: Marks = Marks {
    write: write_typst,
    negative: "-",
    plus: " + ",
    minus: " - ",
    times: |_| " thin ",
    cross: "times ",
    whole: ["(", ")"],
    broken: ["\\( ", "\\)"],
    power: |n| format!("^{n}"),
    slash: " \\/ ",
    slashes_numerators: false,
};

/// Signs of `MathML` at which lines may break. Each piece becomes a separate `math` element, so
/// parentheses do not stretch to the height of other pieces.
const MATHML: Marks = Marks {
    write: write_mathml,
    negative: "<mo form=\"prefix\">−</mo>",
    plus: "<mo form=\"infix\" lspace=\"0\">+</mo>",
    minus: "<mo form=\"infix\" lspace=\"0\">−</mo>",
    times: mathml_sign_between_factors,
    cross: "<mo>×</mo>",
    whole: ["<mrow><mo>(</mo>", "<mo>)</mo></mrow>"],
    broken: ["<mo form=\"prefix\" stretchy=\"false\">(</mo>", "<mo form=\"postfix\" stretchy=\"false\">)</mo>"],
    power: |n| format!("<msup><mrow></mrow><mn>{n}</mn></msup>"),
    slash: "<mo>/</mo>",
    slashes_numerators: true,
};

/// Part of a formula within which no line break is allowed.
struct Piece {
    /// Text of the piece in the language of the formula.
    text: String,
    /// Estimated width of the piece, in tenths of an em.
    width: usize,
    /// True if a new line may begin with this piece.
    breaks: bool,
    /// True if this piece is the sign between two factors. A line breaks at such a sign only if
    /// there is no other place to break.
    is_between: bool,
}

/// Breaks a formula into lines of LaTeX, each at most about `widest` tenths of an em wide.
#[must_use]
pub fn break_latex_lines(view: &DisplayTree, widest: usize) -> Vec<String> {
    Breaking { marks: &LATEX, widest }.lines(view)
}

/// Breaks a formula into lines of Typst, each at most about `widest` tenths of an em wide.
#[must_use]
pub fn break_typst_lines(view: &DisplayTree, widest: usize) -> Vec<String> {
    Breaking { marks: &TYPST, widest }.lines(view)
}

/// Writes a formula in presentation `MathML` as pieces, between which lines may break. A formula no
/// wider than `widest`, in tenths of an em, is a single piece.
#[must_use]
pub fn break_mathml_pieces(view: &DisplayTree, widest: usize) -> Vec<String> {
    let mut pieces = Vec::new();
    Breaking { marks: &MATHML, widest }.append_pieces(view, &mut pieces);
    let mut list: Vec<String> = Vec::new();
    for piece in pieces {
        match list.last_mut() {
            Some(last) if !piece.breaks => last.push_str(&piece.text),
            _ => list.push(piece.text),
        }
    }
    list
}

/// Settings for breaking a formula into lines: language and line width.
struct Breaking {
    /// Signs of the language at which lines may break.
    marks: &'static Marks,
    /// Largest width of a line, in tenths of an em.
    widest: usize,
}

impl Breaking {
    /// Breaks a formula into lines that are about as wide as `widest`.
    fn lines(&self, view: &DisplayTree) -> Vec<String> {
        let mut pieces = Vec::new();
        self.append_pieces(view, &mut pieces);
        // Pieces without a break between them stay on one line: their widths add up.
        let mut together: Vec<Vec<Piece>> = Vec::new();
        for piece in pieces {
            match together.last_mut() {
                Some(list) if !piece.breaks => list.push(piece),
                _ => together.push(vec![piece]),
            }
        }
        let (mut lines, mut filled) = (vec![String::new()], 0);
        for list in together {
            let width = list.iter().map(|piece| piece.width).sum::<usize>();
            if filled > 0 && filled + width > self.widest {
                lines.push(String::new());
                filled = 0;
            }
            let is_too_wide = width > self.widest;
            // Width from each piece to the next sign between factors, the piece included.
            let mut rest = vec![0; list.len() + 1];
            for at in (0..list.len()).rev() {
                let next = list.get(at + 1).is_some_and(|piece| !piece.is_between);
                rest[at] = list[at].width + if next { rest[at + 1] } else { 0 };
            }
            for (piece, wide) in list.into_iter().zip(rest) {
                let is_broken = is_too_wide && piece.is_between && filled + wide > self.widest;
                if is_broken {
                    lines.push(self.marks.cross.to_owned());
                    filled = 15;
                }
                filled += piece.width;
                if let Some(line) = lines.last_mut().filter(|_| !is_broken) {
                    line.push_str(&piece.text);
                }
            }
        }
        lines
    }

    /// Appends a formula to `out`: a single piece if it fits on a line, else several pieces.
    fn append_pieces(&self, view: &DisplayTree, out: &mut Vec<Piece>) {
        let width = formula_width(view);
        if width <= self.widest { self.push(out, view, width) } else { self.append_broken(view, out) }
    }

    /// Appends a formula to `out` in pieces, which break at its plus and minus signs.
    fn append_broken(&self, view: &DisplayTree, out: &mut Vec<Piece>) {
        match view {
            DisplayTree::Sum(terms) => {
                for (at, (negative, term)) in terms.iter().enumerate() {
                    let sign = match (at, negative) {
                        (0, false) => "",
                        (0, true) => self.marks.negative,
                        (_, false) => self.marks.plus,
                        (_, true) => self.marks.minus,
                    };
                    out.push(Piece { text: sign.to_owned(), width: 0, breaks: at > 0, is_between: false });
                    let first = out.len();
                    self.append_factor(term, out);
                    // A sign and the piece after it stay together.
                    if let [sign, next, ..] = &mut out[first - 1..] {
                        sign.width = 15 + next.width;
                        next.width = 0;
                        next.breaks = false;
                    }
                }
            }
            DisplayTree::Product(factors) => {
                for (at, one) in factors.iter().enumerate() {
                    if at > 0 {
                        out.push(Piece {
                            text: (self.marks.times)(one).to_owned(),
                            width: 2,
                            breaks: false,
                            is_between: true,
                        });
                    }
                    if self.is_slashed(one) {
                        self.append_in_parentheses(one, out);
                    } else {
                        self.append_factor(one, out);
                    }
                }
            }
            DisplayTree::Fraction(above, below) if self.is_slashed(view) => {
                self.append_factor(above, out);
                out.push(Piece { text: self.marks.slash.to_owned(), width: 5, breaks: false, is_between: false });
                match **below {
                    DisplayTree::Sum(_) | DisplayTree::Product(_) => self.append_in_parentheses(below, out),
                    _ => self.append_factor(below, out),
                }
            }
            // n a/b is written as (n/b) a.
            DisplayTree::Fraction(above, below)
                if !self.marks.slashes_numerators
                    && matches!(**above, DisplayTree::Sum(_) | DisplayTree::Product(_)) =>
            {
                let (number, rest) = break_off_leading_number(above);
                let first = DisplayTree::Fraction(Box::new(DisplayTree::Number(number)), below.clone());
                self.push(out, &first, formula_width(&first));
                out.push(Piece {
                    text: (self.marks.times)(&rest).to_owned(),
                    width: 2,
                    breaks: false,
                    is_between: true,
                });
                self.append_factor(&rest, out);
            }
            DisplayTree::Power(base, n) if matches!(**base, DisplayTree::Sum(_) | DisplayTree::Product(_)) => {
                self.append_in_parentheses(base, out);
                out.push(Piece { text: (self.marks.power)(*n), width: 4, breaks: false, is_between: false });
            }
            _ => self.push(out, view, formula_width(view)),
        }
    }

    /// True if the formula is a fraction that is written with a slash, because a line may break in
    /// its numerator or denominator. It then needs parentheses if another factor follows.
    fn is_slashed(&self, view: &DisplayTree) -> bool {
        let breaks = |part: &DisplayTree| formula_width(part) > self.widest && has_break_signs(part);
        let numerators = self.marks.slashes_numerators;
        matches!(view, DisplayTree::Fraction(above, below) if breaks(below) || numerators && breaks(above))
    }

    /// Appends a factor to `out`. A sum gets parentheses. In a sum wider than half a line, lines
    /// may break within the parentheses.
    fn append_factor(&self, view: &DisplayTree, out: &mut Vec<Piece>) {
        let width = factor_width(view);
        if !view.is_loose() {
            return self.append_pieces(view, out);
        }
        if width > self.widest / 2 {
            return self.append_in_parentheses(view, out);
        }
        let [open, close] = self.marks.whole;
        let mut text = open.to_owned();
        (self.marks.write)(view, &mut text);
        text.push_str(close);
        out.push(Piece { text, width, breaks: false, is_between: false });
    }

    /// Appends a formula to `out` in parentheses of fixed height, in pieces that break at its
    /// signs.
    fn append_in_parentheses(&self, view: &DisplayTree, out: &mut Vec<Piece>) {
        let [open, close] = self.marks.broken;
        out.push(Piece { text: open.to_owned(), width: 5, breaks: false, is_between: false });
        self.append_broken(view, out);
        out.push(Piece { text: close.to_owned(), width: 5, breaks: false, is_between: false });
    }

    /// Appends a formula to `out` as a single piece of the given width.
    fn push(&self, out: &mut Vec<Piece>, view: &DisplayTree, width: usize) {
        let mut text = String::new();
        (self.marks.write)(view, &mut text);
        out.push(Piece { text, width, breaks: false, is_between: false });
    }
}

/// True if the formula has a plus or minus sign at which a line may break.
fn has_break_signs(view: &DisplayTree) -> bool {
    match view {
        DisplayTree::Sum(terms) => terms.len() > 1 || terms.iter().any(|(_, term)| has_break_signs(term)),
        DisplayTree::Product(factors) => factors.iter().any(has_break_signs),
        DisplayTree::Power(base, _) => has_break_signs(base),
        DisplayTree::Fraction(above, below) => has_break_signs(above) || has_break_signs(below),
        _ => false,
    }
}

/// Splits a product into its leading number, `1` if it has none, and the remaining product.
fn break_off_leading_number(view: &DisplayTree) -> (String, DisplayTree) {
    match view {
        DisplayTree::Product(factors) => match factors.split_first() {
            Some((DisplayTree::Number(number), [one])) => (number.clone(), one.clone()),
            Some((DisplayTree::Number(number), rest)) => (number.clone(), DisplayTree::Product(rest.to_vec())),
            _ => ("1".to_owned(), view.clone()),
        },
        _ => ("1".to_owned(), view.clone()),
    }
}

/// Estimated width of a printed formula, in tenths of an em.
#[must_use]
pub fn formula_width(view: &DisplayTree) -> usize {
    match view {
        DisplayTree::Number(text) | DisplayTree::Shared(text) => 5 * text.len(),
        DisplayTree::Name(name) => name_width(name),
        DisplayTree::Word(name) => 6 * name.len(),
        DisplayTree::Pi => 6,
        DisplayTree::Sum(terms) => terms.iter().map(|(_, term)| 15 + factor_width(term)).sum(),
        DisplayTree::Product(factors) => factors.iter().map(|factor| 2 + factor_width(factor)).sum(),
        DisplayTree::Fraction(above, below) => 3 + formula_width(above).max(formula_width(below)),
        DisplayTree::Power(base, n) => 4 * n.to_string().len() + factor_width(base),
        DisplayTree::Call(name, argument) => 5 * name.len() + 2 + argument_width(argument),
        DisplayTree::Root(argument) => 9 + formula_width(argument),
        DisplayTree::Cut => 10,
    }
}

/// Estimated width of a symbol with its subscript, in tenths of an em.
fn name_width(name: &str) -> usize {
    let (letters, subscript, _) = super::printed_names::split_name(name);
    let letters =
        if super::printed_names::GREEK.iter().any(|(greek, _)| *greek == letters) { 6 } else { 6 * letters.len() };
    letters + 4 * subscript.len()
}

/// Estimated width of a formula as a factor, in tenths of an em, with the parentheses that a sum
/// needs.
fn factor_width(view: &DisplayTree) -> usize {
    formula_width(view) + if view.is_loose() { 9 } else { 0 }
}

/// Estimated width of a formula as the argument of a function, in tenths of an em. Arguments other
/// than names have parentheses, which are included.
fn argument_width(view: &DisplayTree) -> usize {
    formula_width(view) + if matches!(view, DisplayTree::Name(_) | DisplayTree::Word(_)) { 0 } else { 9 }
}

#[cfg(test)]
mod tests {
    use super::{break_latex_lines, break_mathml_pieces, break_typst_lines};
    use crate::algebra::Arena;
    use crate::algebra::text::display_tree::DisplayTree;
    use crate::algebra::text::parse::parse_free;
    use crate::algebra::text::print::{mathml_of, print_view};

    /// Visible text of `MathML`: without tags and without the invisible operator of function
    /// application.
    fn seen(mathml: &str) -> String {
        mathml.split('<').filter_map(|piece| Some(piece.split_once('>')?.1)).collect::<String>().replace('\u{2061}', "")
    }

    /// Visible text of each piece of a formula, and of the whole formula.
    fn pieces(formula: &str, widest: usize) -> (Vec<String>, String) {
        let mut arena = Arena::new();
        for name in ["m", "l", "q1", "q2", "u1", "u2"] {
            arena.symbol(name);
        }
        let e = parse_free(&mut arena, formula).unwrap();
        let view = print_view(&arena, e);
        (break_mathml_pieces(&view, widest).iter().map(|piece| seen(piece)).collect(), seen(&mathml_of(&view)))
    }

    /// A wide formula has places where a browser may break it, and the pieces are the whole
    /// formula. The expected number of pieces was counted by hand.
    #[test]
    fn pieces_of_a_formula_break_at_its_signs_and_are_the_formula() {
        let formula = "m*l*(sin(q1)*u1^2 - cos(q1)*(u1 + m*u2 + l*u2)) - u2";
        let (small, whole) = pieces(formula, 60);
        assert_eq!(small.len(), 5, "{small:?}");
        assert!(small.iter().skip(1).all(|piece| piece.starts_with(['+', '−'])), "{small:?}");
        assert_eq!(small.concat(), whole);
        let (one, whole) = pieces(formula, 1000);
        assert_eq!(one, [whole]);
    }

    /// A fraction on several lines keeps its meaning. Expected by hand: parentheses around each
    /// part to which a neighbouring factor could seem to belong.
    #[test]
    fn a_fraction_that_is_broken_has_a_slash() {
        let (_, sum) = pieces("m*u1 + m*u2 + l*u1", 1000);
        let (list, _) = pieces("(m*u1 + m*u2 + l*u1)/(l*q1)", 60);
        assert_eq!((list.len(), list.concat()), (3, format!("({sum})/(lq1)")));
        let (list, whole) = pieces("(u1 + u2)/l", 100);
        assert_eq!(list, [whole]);
        let (list, whole) = pieces("m*l*q1*q2*u1*u2/2", 30);
        assert_eq!(list, [whole], "nothing is won where no sign stands");
        let (list, _) = pieces("m*(m*u1 + m*u2 + l*u1)^2", 60);
        assert_eq!((list.len(), list.concat()), (3, format!("m({sum})2")));
    }

    /// A wide denominator breaks in LaTeX and Typst and remains the denominator. A factor after the
    /// fraction is outside of its parentheses.
    #[test]
    fn a_wide_denominator_has_a_slash_in_every_language() {
        let mut arena = Arena::new();
        for name in ["m", "l", "q1", "q2", "u1", "u2"] {
            arena.symbol(name);
        }
        let e = parse_free(&mut arena, "(m*u1 + m*u2 + l*u1)*sin(q1)/(l*q1 + l*q2 + m*q2)").unwrap();
        let view = print_view(&arena, e);
        let latex = break_latex_lines(&view, 80);
        assert!(latex.len() > 2, "{latex:?}");
        let below = "\\bigl(l \\, q_{1}{} + m \\, q_{2}{} + l \\, q_{2}\\bigr)";
        assert!(latex.concat().contains(&format!(" / {below}")), "{latex:?}");
        let typst = break_typst_lines(&view, 80);
        assert!(typst.concat().contains(" \\/ \\( l thin q_1"), "{typst:?}");
        let product = DisplayTree::Product(vec![view, DisplayTree::Name("u2".to_owned())]);
        let latex = break_latex_lines(&product, 80).concat();
        assert!(latex.ends_with(&format!("{below}\\bigr) \\, u_{{2}}")), "{latex}");
    }

    #[test]
    fn pieces_are_well_formed() {
        for formula in ["(m*u1 + m*u2 + l*u1)^2/(l*q1)", "-m*(u1 - u2*(u1 + m*u2))", "sqrt(m + l)*(u1 + u2) + 1/l"] {
            for widest in [20, 60, 200] {
                let mut arena = Arena::new();
                let e = parse_free(&mut arena, formula).unwrap();
                for piece in break_mathml_pieces(&print_view(&arena, e), widest) {
                    let tags: Vec<&str> =
                        piece.split('<').skip(1).map(|tag| tag.split(['>', ' ']).next().unwrap()).collect();
                    let (closing, all) = (tags.iter().filter(|tag| tag.starts_with('/')).count(), tags.len());
                    let empty = piece.matches("/>").count();
                    assert_eq!(2 * closing + empty, all, "{piece}");
                }
            }
        }
    }
}
