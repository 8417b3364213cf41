//! Formulas of a publication, typeset term by term as they are printed.
//!
//! Invariant: nothing is reordered, combined or cancelled, as it would be in an arena. A reader therefore recognizes
//! the printed formula. Text that is no formula is left as text.

use crate::page::markup::formula_mathml::inline_mathml;
use crate::page::markup::html::escape;
use tripos_derive::algebra::text::display_tree::DisplayTree;
use tripos_derive::algebra::text::print::mathml_of;

/// Largest depth of nested parentheses. A deeper formula is shown as text.
const DEEPEST: usize = 40;

/// Largest number of words of a formula that is recognized within a sentence.
const MOST_WORDS: usize = 24;

/// Names of functions that a formula may call, except `sqrt`.
const FUNCTIONS: [&str; 16] = [
    "sin", "cos", "tan", "sec", "csc", "cot", "exp", "log", "asin", "acos", "atan", "sinh", "cosh", "tanh", "abs",
    "sign",
];

/// Parses the sides of `left = right`, or a single formula. `None` if the text is not in the
/// language of model files.
pub fn typeset(text: &str) -> Option<Vec<DisplayTree>> {
    text.split(" = ").map(formula).collect()
}

/// Returns the HTML of a sentence with its formulas typeset. A formula is the longest sequence of words in the language
/// of model files that contains a digit, an operator or a prime.
pub fn typeset_words(text: &str) -> String {
    let words: Vec<&str> = text.split(' ').collect();
    let (mut at, mut out) = (0, Vec::new());
    while at < words.len() {
        // In `the term -a*b`, the sign belongs to the formula: a minus sign of a difference has a space on each side.
        let last = words.len().min(at + MOST_WORDS);
        let sign = (at + 1..last).find(|word| words[*word].len() > 1 && words[*word].starts_with('-'));
        let read = (at + 1..=sign.unwrap_or(last)).rev().find_map(|end| {
            let joined = words[at..end].join(" ");
            let content = joined.trim_end_matches([',', ';']);
            let is_marked = content.contains(|c: char| c.is_ascii_digit() || "*/^'".contains(c));
            let view = formula(content).filter(|_| is_marked)?;
            Some((end, format!("{}{}", inline_mathml(&mathml_of(&view)), &joined[content.len()..])))
        });
        let (end, html) = read.unwrap_or_else(|| (at + 1, escape(words[at])));
        out.push(html);
        at = end;
    }
    out.join(" ")
}

/// Parses a formula without changing its terms. `None` if the text is not in the language of model
/// files.
fn formula(text: &str) -> Option<DisplayTree> {
    let mut parser = Parser { rest: text.trim(), depth: 0 };
    let view = parser.sum()?;
    parser.rest.is_empty().then_some(view)
}

/// Parser of a formula that keeps the order of terms and factors.
struct Parser<'a> {
    /// Part of the formula's text that is not parsed yet.
    rest: &'a str,
    /// Depth of nested parentheses at the current place.
    depth: usize,
}

impl<'a> Parser<'a> {
    /// Skips `token` if it comes next. Returns true if it was skipped.
    fn take(&mut self, token: char) -> bool {
        let next = self.rest.strip_prefix(token);
        self.rest = next.unwrap_or(self.rest).trim_start();
        next.is_some()
    }

    /// Skips the next characters for which `belongs` is true, and returns them.
    fn word(&mut self, belongs: impl Fn(char) -> bool) -> &'a str {
        let end = self.rest.find(|c| !belongs(c)).unwrap_or(self.rest.len());
        let (word, rest) = self.rest.split_at(end);
        self.rest = rest.trim_start();
        word
    }

    /// Parses a sum; `None` if the text is no formula or is nested too deeply.
    fn sum(&mut self) -> Option<DisplayTree> {
        self.depth += 1;
        if self.depth > DEEPEST {
            return None;
        }
        let mut terms = Vec::new();
        loop {
            // In `a + -b`, the first sign has no effect.
            let negative = self.take('-');
            terms.push((negative, self.product()?));
            if !self.take('+') && !self.rest.starts_with('-') {
                break;
            }
        }
        self.depth -= 1;
        Some(match terms.as_slice() {
            [(false, _)] => terms.remove(0).1,
            _ => DisplayTree::Sum(terms),
        })
    }

    /// Parses products and quotients from left to right; `None` if the text is no formula.
    fn product(&mut self) -> Option<DisplayTree> {
        let mut factors = vec![self.factor()?];
        loop {
            if self.take('*') {
                factors.push(self.factor()?);
            } else if self.take('/') {
                let above = one(factors);
                factors = vec![DisplayTree::Fraction(Box::new(above), Box::new(self.factor()?))];
            } else {
                return Some(one(factors));
            }
        }
    }

    /// Parses a factor: an atom with an optional sign and power. `None` if the text is no formula.
    fn factor(&mut self) -> Option<DisplayTree> {
        if self.take('-') {
            return Some(DisplayTree::Sum(vec![(true, self.factor()?)]));
        }
        let base = self.atom()?;
        if !self.take('^') {
            return Some(base);
        }
        let exponent = self.word(|c| c.is_ascii_digit()).parse().ok()?;
        Some(DisplayTree::Power(Box::new(base), exponent))
    }

    /// Parses a number, a name, a function call or a formula in parentheses. `None` if the text
    /// begins with none of these.
    fn atom(&mut self) -> Option<DisplayTree> {
        if self.take('(') {
            let inner = self.sum()?;
            return self.take(')').then_some(inner);
        }
        if self.rest.starts_with(|c: char| c.is_ascii_digit() || c == '.') {
            return Some(DisplayTree::Number(self.word(|c| c.is_ascii_digit() || c == '.').to_owned()));
        }
        let name = self.word(|c| c.is_ascii_alphanumeric() || c == '_' || c == '\'');
        if self.rest.starts_with('(') {
            let argument = Box::new(self.atom()?);
            return match FUNCTIONS.iter().find(|f| **f == name) {
                Some(f) => Some(DisplayTree::Call(f, argument)),
                None => (name == "sqrt").then_some(DisplayTree::Root(argument)),
            };
        }
        match name {
            "" => None,
            "pi" => Some(DisplayTree::Pi),
            _ => Some(DisplayTree::Name(name.to_owned())),
        }
    }
}

/// Returns the product of factors, or the factor itself if there is only one.
fn one(mut factors: Vec<DisplayTree>) -> DisplayTree {
    if factors.len() == 1 { factors.remove(0) } else { DisplayTree::Product(factors) }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns MathML without its tags, which is enough to check the order of the printed terms.
    fn plain(text: &str) -> String {
        let sides = typeset(text).unwrap_or_else(|| panic!("{text} is a formula"));
        let mathml = sides.iter().map(mathml_of).collect::<Vec<_>>().join("<mo>=</mo>");
        mathml.split('<').map(|piece| piece.split_once('>').map_or("", |(_, text)| text)).collect()
    }

    #[test]
    fn terms_and_factors_stay_where_they_are_printed() {
        assert_eq!(plain("u2*R - R*u2"), "u2R−Ru2");
        assert_eq!(plain("a - (b - c)*0.5"), "a−(b−c)·0.5");
        assert_eq!(plain("5*R*u1' + -4*c1*u5' = -3*u2 - 0"), "5Ru˙1−4c1u˙5=−3u2−0");
        assert_eq!(plain("c2*-s2 - -1"), "c2(−s2)−(−1)");
        assert_eq!(plain("tan(q2)^2/sqrt(x)"), "tan2\u{2061}q2x");
    }

    #[test]
    fn quotients_are_fractions_of_what_stands_before() {
        let fraction = mathml_of(&typeset("R^2/2*x").unwrap()[0]);
        assert!(fraction.contains("</mfrac><mspace") && fraction.ends_with("<mi>x</mi></mrow>"), "{fraction}");
    }

    #[test]
    fn formulas_in_a_sentence_are_typeset() {
        let html = typeset_words("the term -3*R*u2 should be 2*(u2 - 1), and <so>");
        assert!(html.starts_with("the term <math>") && html.ends_with("</math>, and &lt;so&gt;"), "{html}");
        assert_eq!(html.matches("<math>").count(), 2);
    }

    #[test]
    fn what_is_no_formula_is_left_as_text() {
        for text in ["", "v = v1 b1 + v2 b2", "f(x)", "2 ** 3", "x^y", "a < b", "(a", &"(".repeat(100)] {
            assert!(typeset(text).is_none(), "{text}");
        }
    }
}
