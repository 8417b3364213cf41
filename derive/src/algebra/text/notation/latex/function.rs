//! Translation of fractions, roots and functions in LaTeX formulas. It also finds the end of a
//! function's argument without parentheses.

use super::formula::Formula;
use super::tokens::Token;
use crate::algebra::text::notation::function_names::function;
use crate::algebra::text::notation::latex_symbol::LatexSymbol;
use crate::algebra::text::notation::translation_errors::translation_error;
use crate::algebra::text::parse::ParseError;
use std::ops::Range;

/// Kind of the last part of a function's argument without parentheses: it decides what may follow.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Argument {
    /// Numbers only, such as 2π, in the argument so far: a symbol may still follow.
    Number,
    /// A symbol, a root or a fraction in the argument so far: it ends the argument.
    Term,
}

impl Formula<'_, '_> {
    /// Translates a fraction, or a time derivative written as a fraction, beginning with the
    /// command \frac.
    pub(super) fn fraction(&mut self) -> Result<(), ParseError> {
        let place = self.cursor.here();
        let first = self.cursor.at;
        if self.derivative()? {
            return Ok(());
        }
        self.cursor.at = first + 1;
        self.out.push_all(&["(", "("], &place);
        // \frac12: the first digit is the numerator, the second the denominator.
        if let Some(Token::Number(digits)) = self.cursor.peek()
            && digits.len() == 2
            && digits.bytes().all(|b| b.is_ascii_digit())
        {
            let both = self.cursor.here();
            self.out.push(&digits[..1], both.clone());
            self.out.push_all(&[")", "/", "("], &place);
            self.out.push(&digits[1..], both);
            self.cursor.at += 1;
        } else {
            self.argument("the numerator")?;
            self.out.push_all(&[")", "/", "("], &place);
            self.argument("the denominator")?;
        }
        self.out.push_all(&[")", ")"], &place);
        Ok(())
    }

    /// Translates a time derivative such as \frac{d\theta}{dt} or \frac{d}{dt}(…), beginning with
    /// the command \frac. False if the fraction is not a time derivative.
    fn derivative(&mut self) -> Result<bool, ParseError> {
        let (first, place) = (self.cursor.at, self.cursor.here());
        self.cursor.at += 1;
        if !self.cursor.takes('{') || !self.cursor.takes_d() {
            return Ok(false);
        }
        let order = self.cursor.takes_order();
        let spell = &mut *self.spell;
        let of = match self.cursor.peek() {
            Some(Token::Char('}')) => None,
            _ => match self.cursor.symbol(&|symbol| spell.knows(symbol))? {
                Some((symbol, at)) => Some((symbol, at)),
                None => return Ok(false),
            },
        };
        self.skip_time_argument();
        let is_by_time = self.cursor.takes('}')
            && self.cursor.takes('{')
            && self.cursor.takes_d()
            && self.cursor.peek() == Some(&Token::Letter('t'));
        self.cursor.at += 1;
        let below = self.cursor.takes_order();
        if !is_by_time || !self.cursor.takes('}') || below != order || order == 0 {
            return Ok(false);
        }
        if let Some((mut symbol, at)) = of {
            symbol.dots += order;
            self.name(&symbol, at, first)?;
            return Ok(true);
        }
        for _ in 0..order {
            self.out.push_all(&["ddt", "("], &place);
        }
        self.factor()?;
        for _ in 0..order {
            self.out.push(")", place.clone());
        }
        Ok(true)
    }

    /// Translates a square root, beginning with the command \sqrt. Error for roots of other
    /// degrees.
    pub(super) fn root_function(&mut self) -> Result<(), ParseError> {
        let place = self.cursor.here();
        self.cursor.at += 1;
        if self.cursor.peek() == Some(&Token::Char('[')) {
            return Err(translation_error(self.cursor.here(), "only square roots are known", "write \\sqrt{…}"));
        }
        self.out.push_all(&["sqrt", "("], &place);
        self.argument("what the root is of")?;
        self.out.push(")", place);
        Ok(())
    }

    /// Translates the call of a function in roman type, such as \operatorname{sgn}(x), beginning
    /// with its command. `name` is the function's name in model files.
    pub(super) fn roman_function(&mut self, name: &str) -> Result<(), ParseError> {
        let first = self.cursor.at;
        self.cursor.symbol(&|_| false)?;
        let place = self.cursor.span_since(first);
        self.translate_call(name, &place)
    }

    /// Translates the call of a function that is a command, such as \sin x, beginning with the
    /// command. `name` is the function's name in model files.
    pub(super) fn function(&mut self, name: &str) -> Result<(), ParseError> {
        let place = self.cursor.here();
        self.cursor.at += 1;
        self.translate_call(name, &place)
    }

    /// Translates the exponent and the argument of a function, after the function itself. `name` is
    /// the function's name in model files, and `place` its byte range.
    fn translate_call(&mut self, name: &str, place: &Range<usize>) -> Result<(), ParseError> {
        let power = self.power_of_function()?;
        self.out.push(name, place.clone());
        if let Some(end) = self.closing_character() {
            self.translate_parentheses(end)?;
        } else {
            self.out.push("(", place.clone());
            if self.cursor.peek() == Some(&Token::Char('{')) {
                self.argument("an argument")?;
            } else {
                self.bare_argument(name, place)?;
            }
            self.out.push(")", place.clone());
        }
        if let Some((digits, at)) = power {
            self.out.push("^", at.clone());
            self.out.push(&digits, at);
        }
        Ok(())
    }

    /// Reads the exponent between a function and its argument, as in \sin^2 x. Returns its digits
    /// and byte range; `None` if there is no exponent. Error if the exponent is not an unsigned
    /// integer.
    fn power_of_function(&mut self) -> Result<Option<(String, Range<usize>)>, ParseError> {
        let first = self.cursor.at;
        if !self.cursor.takes('^') {
            return Ok(None);
        }
        let braced = self.cursor.takes('{');
        let power = match self.cursor.peek() {
            Some(Token::Number(digits)) if braced || digits.len() == 1 => Some((digits.clone(), self.cursor.here())),
            _ => None,
        };
        self.cursor.at += 1;
        let closed = !braced || self.cursor.takes('}');
        match power.filter(|_| closed) {
            Some(power) => Ok(Some(power)),
            None => {
                while braced && !closed && self.cursor.peek().is_some() && !self.cursor.takes('}') {
                    self.cursor.at += 1;
                }
                let help = "write \\sin^{2} x for a power, \\arcsin x for an inverse, \\csc x or \\frac{1}{\\sin x} for a quotient";
                Err(translation_error(self.cursor.span_since(first), "the power of a function is a whole number", help))
            }
        }
    }

    /// Translates an argument without parentheses: numbers, then one symbol, root or fraction, then
    /// possibly the time t. Error if it is unclear where the argument ends.
    fn bare_argument(&mut self, name: &str, place: &Range<usize>) -> Result<(), ParseError> {
        let first = self.cursor.at;
        let is_number = |mark: Option<&Token>| matches!(mark, Some(Token::Number(_)));
        let is_pi = |mark: Option<&Token>| matches!(mark, Some(Token::Command(name)) if name == "pi");
        let (mut only_numbers, mut is_coordinate) = (true, false);
        loop {
            let mark = self.cursor.peek();
            let begins = matches!(mark, Some(Token::Number(_) | Token::Letter(_) | Token::Command(_)));
            if !begins {
                break;
            }
            if self.cursor.at > first {
                self.out.push("*", self.cursor.here());
            }
            let number = is_number(mark) || is_pi(mark);
            is_coordinate = self.begins_coordinate_in_argument();
            self.factor()?;
            only_numbers &= number;
            // \sin\omega t is sin(ω t): the time t directly after a constant belongs to the
            // argument.
            if !number && !is_coordinate && self.begins_time_in_argument() {
                self.out.push("*", self.cursor.here());
                self.factor()?;
                break;
            }
            if !number || is_number(self.cursor.peek()) {
                break;
            }
            // A symbol after a number belongs to the argument, as in \sin 2 q.
            let goes_on = matches!(self.cursor.peek(), Some(Token::Letter(_)));
            if !(goes_on || self.begins_symbol_in_argument()) {
                break;
            }
        }
        if self.cursor.at == first {
            let help = format!("write \\{name}(…)");
            return Err(translation_error(place.clone(), format!("`{name}` needs an argument"), &help));
        }
        // A parenthesis after a coordinate does not belong to the argument: \sin\theta(…) is (sin
        // θ)·(…).
        let ends = is_coordinate && matches!(self.cursor.peek(), Some(Token::Char('(' | '[')));
        let argument = if only_numbers { Argument::Number } else { Argument::Term };
        if ends { Ok(()) } else { self.end_of_argument(name, argument) }
    }

    /// True if the symbol of a generalized coordinate comes next.
    fn begins_coordinate_in_argument(&mut self) -> bool {
        let before = self.cursor.clone();
        let spell = &mut *self.spell;
        let found = self.cursor.symbol(&|symbol| spell.knows(symbol));
        self.cursor = before;
        matches!(found, Ok(Some((symbol, _))) if self.spell.is_coordinate(&symbol))
    }

    /// True if the time t comes next and no space is printed before it.
    fn begins_time_in_argument(&mut self) -> bool {
        if self.cursor.list.get(self.cursor.at).is_some_and(|next| next.apart) {
            return false;
        }
        let before = self.cursor.clone();
        let found = self.cursor.symbol(&|_| false);
        self.cursor = before;
        matches!(found, Ok(Some((symbol, _))) if symbol == LatexSymbol::plain("t"))
    }

    /// True if a symbol comes next that is not the name of a function.
    fn begins_symbol_in_argument(&mut self) -> bool {
        let before = self.cursor.clone();
        let found = self.cursor.symbol(&|_| false);
        self.cursor = before;
        matches!(found, Ok(Some((symbol, _))) if symbol.base.len() == 1 || function(&symbol.base).is_none())
    }

    /// True if a symbol with a dot or prime comes next. Such a rate is not part of a function's
    /// argument without parentheses.
    fn begins_rate_in_argument(&mut self) -> bool {
        let before = self.cursor.clone();
        let spell = &mut *self.spell;
        let found = self.cursor.symbol(&|symbol| spell.knows(symbol));
        self.cursor = before;
        matches!(found, Ok(Some((symbol, _))) if symbol.dots > 0)
    }

    /// Checks that the argument of a function without parentheses clearly ends before the next
    /// token. Error if the token may belong to the argument.
    fn end_of_argument(&mut self, name: &str, argument: Argument) -> Result<(), ParseError> {
        let only_numbers = argument == Argument::Number;
        let apart = self.cursor.list.get(self.cursor.at).is_some_and(|next| next.apart);
        let is_rate = !only_numbers && self.begins_rate_in_argument();
        let open = !is_rate
            && match self.cursor.peek() {
                Some(Token::Char('^' | '/') | Token::Number(_) | Token::Letter(_)) => true,
                Some(Token::Char('(' | '[' | '{')) => only_numbers || !apart,
                Some(Token::Command(_)) => self.begins_symbol_in_argument(),
                _ => false,
            };
        if open {
            let help = format!("write \\{name}(…) with its argument in parentheses");
            return Err(translation_error(
                self.cursor.here(),
                format!("the end of the argument of `{name}` is not clear here"),
                &help,
            ));
        }
        Ok(())
    }
}
