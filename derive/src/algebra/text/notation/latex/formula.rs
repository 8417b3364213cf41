//! Translation of sums and products in LaTeX formulas: adjacent operands make a product.

use super::cursor::LatexCursor;
use super::tokens::Token;
use crate::algebra::text::notation::function_names::{function, function_name_of_latex, is_letter};
use crate::algebra::text::notation::latex_symbol::LatexSymbol;
use crate::algebra::text::notation::symbol_names::SymbolNames;
use crate::algebra::text::notation::translation::Translation;
use crate::algebra::text::notation::translation_errors::{translation_error, untranslatable_symbol_error};
use crate::algebra::text::parse::ParseError;
use std::ops::Range;

/// Largest number of tokens before and after a letter that are searched for the word around it.
const LONGEST_WORD: usize = 60;

/// State of translating a LaTeX formula, from left to right.
pub(super) struct Formula<'a, 's> {
    /// Position of the translation in the tokens of the LaTeX formula.
    pub(super) cursor: LatexCursor<'a>,
    /// Source of the model's names for LaTeX symbols.
    pub(super) spell: &'s mut dyn SymbolNames,
    /// Formula in the language of model files, as translated so far.
    pub(super) out: Translation,
}

/// State before an operand: the product sign that it needs depends on the token before it.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Before {
    /// No token, or an operator: the next operand needs no product sign.
    Nothing,
    /// An operand: the next operand multiplies it, and a product sign is added.
    Operand,
    /// An operand after a slash: it is unclear if the slash also divides by the next operand.
    Divisor,
}

/// Kind of vertical bars around an absolute value, which determines where it ends.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Bars {
    /// Bars written with `\left` and `\right`, which may be nested.
    Sized,
    /// Plain bars `|`: the next bar closes the absolute value.
    Plain,
}

impl Formula<'_, '_> {
    /// Translates the whole formula. Error if tokens are left over that belong to no sum.
    pub(super) fn whole(mut self) -> Result<Translation, ParseError> {
        self.sum()?;
        if self.cursor.peek().is_none() {
            return Ok(self.out);
        }
        let (span, what) = (self.cursor.here(), self.name_of_mark());
        let help = match self.cursor.peek() {
            Some(Token::Char('=')) => "a formula has no `=`: write the right side alone",
            Some(Token::Char(',')) => "only min, max and atan2 have several arguments",
            Some(Token::Char('^')) => "write one exponent, in braces",
            Some(Token::Char('_' | '\'')) => "subscripts and primes stand at symbols only",
            _ => "nothing is open that this could close",
        };
        Err(translation_error(span, format!("unexpected `{what}`"), help))
    }

    /// Text of the next token as the LaTeX formula writes it; empty at the end.
    fn name_of_mark(&self) -> String {
        match self.cursor.peek() {
            Some(Token::Number(text)) => text.clone(),
            Some(Token::Letter(c) | Token::Char(c)) => c.to_string(),
            Some(Token::Command(name)) => format!("\\{name}"),
            None => String::new(),
        }
    }

    /// Translates a sum of products. It ends before the first token that does not belong to it.
    pub(super) fn sum(&mut self) -> Result<(), ParseError> {
        self.cursor.enter()?;
        let (mut before, mut slash) = (Before::Nothing, false);
        while self.cursor.peek().is_some() {
            if let Some(sign) = self.operator() {
                if before == Before::Nothing && matches!(sign, "*" | "/") {
                    let message = format!("unexpected `{}`", self.name_of_mark());
                    return Err(translation_error(self.cursor.here(), message, "an operand is missing here"));
                }
                self.out.push(sign, self.cursor.here());
                self.cursor.at += 1;
                (before, slash) = (Before::Nothing, sign == "/");
                continue;
            }
            if !self.operand(before)? {
                break;
            }
            before = if slash { Before::Divisor } else { Before::Operand };
        }
        self.cursor.depth -= 1;
        Ok(())
    }

    /// Operator, in the language of model files, that the next token stands for. `None` if the
    /// token is not an operator.
    fn operator(&self) -> Option<&'static str> {
        match self.cursor.peek()? {
            Token::Char('+') => Some("+"),
            Token::Char('-') => Some("-"),
            Token::Char('*') => Some("*"),
            Token::Char('/') => Some("/"),
            Token::Command(name) => match name.as_str() {
                "cdot" | "times" | "ast" => Some("*"),
                "div" => Some("/"),
                _ => None,
            },
            _ => None,
        }
    }

    /// Translates an operand with its exponent, and writes a product sign before it if needed.
    /// False if no operand begins at the next token. Error if it is unclear which product or
    /// quotient is meant.
    fn operand(&mut self, before: Before) -> Result<bool, ParseError> {
        let place = self.cursor.here();
        match self.cursor.peek() {
            Some(Token::Number(_)) if before != Before::Nothing => {
                let help = "write a subscript in braces, as in q_{12}, and a product with \\cdot, as in 2 \\cdot 3";
                return Err(translation_error(place, "a number stands behind a factor", help));
            }
            None | Some(Token::Char(')' | ']' | '}' | ',' | '=' | '^' | '_' | '\'')) => return Ok(false),
            Some(Token::Command(name)) if matches!(name.as_str(), "rvert" | "}") => return Ok(false),
            _ => {}
        }
        match before {
            Before::Nothing => {}
            Before::Operand => self.out.push("*", place),
            Before::Divisor => {
                let help = "write \\frac{…}{…}, or put \\cdot in front of what the slash does not divide by";
                return Err(translation_error(place, "does the slash divide by this, too?", help));
            }
        }
        self.factor()?;
        self.power()?;
        Ok(true)
    }

    /// Character that closes the parenthesis that the next token opens: `(`, `[` or `\\{`. `None`
    /// if the token opens no parenthesis.
    pub(super) fn closing_character(&self) -> Option<char> {
        match self.cursor.peek()? {
            Token::Char('(') => Some(')'),
            Token::Char('[') => Some(']'),
            Token::Command(name) if name == "{" => Some('}'),
            _ => None,
        }
    }

    /// Translates one factor without its exponent.
    pub(super) fn factor(&mut self) -> Result<(), ParseError> {
        self.cursor.enter()?;
        self.one_factor()?;
        self.cursor.depth -= 1;
        Ok(())
    }

    /// Translates a number, a parenthesis, a fraction, a root, a function, a symbol or a group.
    fn one_factor(&mut self) -> Result<(), ParseError> {
        let first = self.cursor.at;
        let place = self.cursor.here();
        if let Some(end) = self.closing_character() {
            return self.translate_parentheses(end);
        }
        match self.cursor.peek() {
            Some(Token::Number(digits)) => {
                self.out.push(digits, place);
                self.cursor.at += 1;
                return Ok(());
            }
            Some(Token::Command(name)) => match name.as_str() {
                "lvert" | "vert" => {
                    return self.translate_absolute_value(if name == "lvert" { Bars::Sized } else { Bars::Plain });
                }
                "sqrt" => return self.root_function(),
                "frac" | "tfrac" | "dfrac" => return self.fraction(),
                name => {
                    if let Some(function) = function_name_of_latex(name) {
                        return self.function(function);
                    }
                }
            },
            Some(Token::Char('|')) => return self.translate_absolute_value(Bars::Plain),
            _ => {}
        }
        let before = self.cursor.clone();
        let spell = &mut *self.spell;
        if let Some((symbol, place)) = self.cursor.symbol(&|symbol| spell.knows(symbol))? {
            if let Some(function) =
                function(&symbol.base).filter(|_| symbol.without_dots() == symbol.base && symbol.base.len() > 1)
            {
                self.cursor = before;
                return self.roman_function(function);
            }
            self.skip_time_argument();
            return self.name(&symbol, place, first);
        }
        self.cursor = before;
        if self.cursor.takes('{') {
            return self.translate_group(&place);
        }
        Err(self.unexpected_token())
    }

    /// Creates the error for a token where an operand is expected, with advice.
    fn unexpected_token(&self) -> ParseError {
        let (place, what) = (self.cursor.here(), self.name_of_mark());
        match self.cursor.peek() {
            Some(Token::Command(name)) => {
                let help = match name.as_str() {
                    "partial" => {
                        "derivatives are by time, of symbols: \\dot{q}_1; name a partial derivative by its quantity"
                    }
                    "begin" | "end" => "give the formula alone, without its environment",
                    "sum" | "prod" | "int" => "write out what it stands for",
                    "label" | "tag" | "ref" => "leave out labels and numbers of equations",
                    "dots" | "ldots" | "cdots" => "write out what the dots stand for",
                    "pm" | "mp" => "give each sign an entry of its own",
                    name if is_letter(name) => "write an operand here",
                    _ => {
                        "known are symbols, \\frac, \\sqrt, \\cdot, \\left( \\right), \\dot and functions such as \\sin; \
                          a symbol of the paper's own is declared in [symbols]"
                    }
                };
                translation_error(place, format!("`\\{name}` is not known"), help)
            }
            None => translation_error(place, "the expression ends too early", "an operand is missing here"),
            _ => translation_error(place, format!("unexpected `{what}`"), "an operand is missing here"),
        }
    }

    /// Writes the name of a symbol to the translation. `first` is the index of the symbol's first
    /// token. Error if the symbol has no name in the model.
    pub(super) fn name(&mut self, symbol: &LatexSymbol, place: Range<usize>, first: usize) -> Result<(), ParseError> {
        if symbol.base == "\\pi" && symbol.without_dots() == "\\pi" && symbol.dots == 0 && !self.spell.knows(symbol) {
            self.out.push("pi", place);
            return Ok(());
        }
        let run = self.adjacent_word(first);
        let name = self
            .spell
            .name_of_latex_symbol(symbol, &run)
            .map_err(|why| untranslatable_symbol_error(place.clone(), why))?;
        self.out.push(&name, place);
        Ok(())
    }

    /// Skips the argument (t) of a function of time, as in \theta(t), if it comes next; does
    /// nothing otherwise.
    pub(super) fn skip_time_argument(&mut self) {
        let before = self.cursor.at;
        let is_time = self.cursor.takes('(') && self.cursor.peek() == Some(&Token::Letter('t'));
        self.cursor.at += 1;
        if !is_time || !self.cursor.takes(')') {
            self.cursor.at = before;
        }
    }

    /// Word of adjacent letters and digits around the token with the index `first`. The word is
    /// `den` for the three tokens d, e, n. Empty if there is only one letter.
    fn adjacent_word(&self, first: usize) -> String {
        let part = |at: usize| match &self.cursor.list[at].mark {
            Token::Letter(c) => Some(c.to_string()),
            Token::Number(digits) => Some(digits.clone()),
            _ => None,
        };
        let touches = |at: usize| self.cursor.list[at - 1].span.end == self.cursor.list[at].span.start;
        let mut start = first;
        while start > first.saturating_sub(LONGEST_WORD) && touches(start) && part(start - 1).is_some() {
            start -= 1;
        }
        let mut run = String::new();
        for at in start..self.cursor.list.len().min(first + LONGEST_WORD) {
            let Some(part) = part(at).filter(|_| at == start || touches(at)) else { break };
            run += &part;
        }
        if run.len() > 1 { run } else { String::new() }
    }

    /// Translates the exponent after a factor, if there is one. Error for a second exponent.
    fn power(&mut self) -> Result<(), ParseError> {
        let place = self.cursor.here();
        if !self.cursor.takes('^') {
            return Ok(());
        }
        self.out.push_all(&["^", "("], &place);
        self.argument("an exponent")?;
        self.out.push(")", place);
        if self.cursor.peek() == Some(&Token::Char('^')) {
            let help = "write one exponent, in braces; (x^{2})^{3} for a power of a power";
            return Err(translation_error(self.cursor.here(), "a second exponent", help));
        }
        Ok(())
    }

    /// Translates the argument of a command: a group in braces, or one factor without braces.
    /// `what` names the argument in error messages.
    pub(super) fn argument(&mut self, what: &str) -> Result<(), ParseError> {
        let place = self.cursor.here();
        if self.cursor.takes('{') {
            return self.translate_braces(&place);
        }
        match self.cursor.peek() {
            Some(Token::Number(digits)) if digits.len() > 1 => {
                let help = format!("write it in braces: `{{{digits}}}`");
                Err(translation_error(place, format!("is `{digits}` all of {what}?"), &help))
            }
            Some(Token::Number(_) | Token::Letter(_) | Token::Command(_)) => self.factor(),
            _ => Err(translation_error(place, format!("{what} is missing here"), "write it in braces")),
        }
    }

    /// Translates a group in braces after its opening brace, up to its closing brace. `open` is the
    /// byte range of the opening brace, for errors.
    fn translate_braces(&mut self, open: &Range<usize>) -> Result<(), ParseError> {
        self.sum()?;
        if self.cursor.takes('}') {
            return Ok(());
        }
        if self.cursor.peek().is_some() {
            let message = format!("unexpected `{}`", self.name_of_mark());
            return Err(translation_error(self.cursor.here(), message, "this group ends with `}`"));
        }
        Err(translation_error(open.clone(), "this `{` is never closed", "add `}`"))
    }

    /// Translates a group in braces that is a factor, after its opening brace, and writes it in
    /// parentheses. `open` is the byte range of the opening brace.
    fn translate_group(&mut self, open: &Range<usize>) -> Result<(), ParseError> {
        self.out.push("(", open.clone());
        self.translate_braces(open)?;
        self.out.push(")", open.clone());
        Ok(())
    }

    /// Translates a parenthesis with its content, beginning with its opening token. `end` is the
    /// character that closes it. Commas may separate several sums.
    pub(super) fn translate_parentheses(&mut self, end: char) -> Result<(), ParseError> {
        let open = self.cursor.here();
        self.cursor.at += 1;
        self.out.push("(", open.clone());
        self.sum()?;
        while self.cursor.peek() == Some(&Token::Char(',')) {
            self.out.push(",", self.cursor.here());
            self.cursor.at += 1;
            self.sum()?;
        }
        let close = self.cursor.here();
        let closed = if end == '}' {
            let closed = matches!(self.cursor.peek(), Some(Token::Command(name)) if name == "}");
            self.cursor.at += usize::from(closed);
            closed
        } else {
            self.cursor.takes(end)
        };
        if closed {
            self.out.push(")", close);
            return Ok(());
        }
        if self.cursor.peek().is_some() {
            let message = format!("unexpected `{}`", self.name_of_mark());
            return Err(translation_error(close, message, &format!("`{end}` is due here: it closes what is open")));
        }
        let message = "what is opened here is never closed";
        Err(translation_error(open, message, &format!("add `{end}`")))
    }

    /// Translates an absolute value |…|, beginning with its first bar.
    fn translate_absolute_value(&mut self, bars: Bars) -> Result<(), ParseError> {
        let open = self.cursor.here();
        self.cursor.at += 1;
        self.out.push_all(&["abs", "("], &open);
        let first = self.cursor.at;
        let end = self
            .closing_bar(first, bars)
            .ok_or_else(|| translation_error(open.clone(), "this bar is never closed", "write \\left| … \\right|"))?;
        // The tokens between the bars are a formula of their own.
        let list = &self.cursor.list[first..end];
        let limit = self.cursor.list[end].span.start;
        let inner = LatexCursor { list, at: 0, depth: self.cursor.depth, end: limit };
        let outer = std::mem::replace(&mut self.cursor, inner);
        self.sum()?;
        let rest = self.cursor.peek().is_some().then(|| (self.cursor.here(), self.name_of_mark()));
        self.cursor = outer;
        if let Some((place, what)) = rest {
            return Err(translation_error(
                place,
                format!("unexpected `{what}`"),
                "nothing is open that this could close",
            ));
        }
        self.cursor.at = end + 1;
        self.out.push(")", self.cursor.list[end].span.clone());
        Ok(())
    }

    /// Index of the token that closes an absolute value. It is the matching bar for \left and
    /// \right, and the next bar for plain bars. `None` if there is no closing bar.
    fn closing_bar(&self, first: usize, bars: Bars) -> Option<usize> {
        let is_left = bars == Bars::Sized;
        let mut open = 0_usize;
        for (at, placed) in self.cursor.list.iter().enumerate().skip(first) {
            match &placed.mark {
                Token::Command(name) if is_left && name == "lvert" => open += 1,
                Token::Command(name) if is_left && name == "rvert" => {
                    if open == 0 {
                        return Some(at);
                    }
                    open -= 1;
                }
                Token::Char('|') if !is_left => return Some(at),
                Token::Command(name) if !is_left && name == "vert" => return Some(at),
                _ => {}
            }
        }
        None
    }
}
