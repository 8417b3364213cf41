//! Syntax of JavaScript expressions and statements, in double precision.

use crate::syntax::{Syntax, assignment_statements};
use tripos_derive::plain_text::{one_line, with_visible_characters};

/// JavaScript as a language for formulas. A product and a sum are never fused into one operation.
pub struct JavaScript;

impl Syntax for JavaScript {
    fn comment_mark(&self) -> &'static str {
        "//"
    }

    fn escape_comment(&self, text: &str) -> String {
        with_visible_characters(&one_line(text)).replace('<', "< ").replace("<  ", "< ").replace("-->", "-- >")
    }

    fn not_a_number(&self) -> &'static str {
        "NaN"
    }

    fn pi(&self) -> &'static str {
        "Math.PI"
    }

    fn call(&self, name: &str, argument: &str) -> String {
        format!("Math.{name}({argument})")
    }

    /// Writes a power as `Math.pow`, because `-x ** 2` is a syntax error in JavaScript.
    fn power(&self, argument: &str, _operand: &str, exponent: i32) -> String {
        format!("Math.pow({argument}, {exponent})")
    }

    fn declare(&self, out: &mut String, indent: &str, list: &[(String, String)]) {
        self.statement(out, indent, &format!("const {};", assignment_statements(list, ", ")));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::syntax::formula;
    use tripos_derive::algebra::Arena;
    use tripos_derive::algebra::text::display_tree::{SharedNames, display_tree};
    use tripos_derive::algebra::text::parse::parse_primed;

    fn written(text: &str) -> String {
        let mut arena = Arena::default();
        let e = parse_primed(&mut arena, text, 0, &mut |arena, name| Ok(arena.symbol(name))).unwrap();
        formula(&JavaScript, &display_tree(&arena, e, &SharedNames::default(), usize::MAX))
    }

    /// Goal: the written expression has the value of the formula, by the precedence of the language. Method: formulas
    /// in which a missing parenthesis would change the value or be a syntax error.
    #[test]
    fn formulas_keep_their_meaning() {
        let forms = [
            ("-a^2 - b", "-b - a * a"),
            ("-(a + b)^4", "-Math.pow(a + b, 4)"),
            ("a/(b*c)", "a / (b * c)"),
            ("a/b^2", "a / (b * b)"),
            ("a/(b + c)", "a / (b + c)"),
            ("2*a/3", "0.6666666666666666 * a"),
            ("a*(b - c*(a - b))", "a * (b + c * (b - a))"),
            ("sqrt(a)*log(b)*sign(c)", "Math.sqrt(a) * Math.log(b) * Math.sign(c)"),
            ("a/10^400", "1e-400 * a"),
        ];
        for (formula, expected) in forms {
            assert_eq!(written(formula), expected, "{formula}");
        }
    }
}
