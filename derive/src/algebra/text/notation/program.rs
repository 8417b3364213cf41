//! Translation of program text: formulas of Python (with the output of `SymPy`), MATLAB and C.

use super::calls::Calls;
use super::function_names::{constant, function, function_of_c, name_without_module};
use super::kind::Notation;
use super::quotient::refuse_whole_quotients;
use super::symbol_names::SymbolNames;
use super::translation::Translation;
use super::translation_errors::{character_at, translation_error, untranslatable_symbol_error};
use super::unicode;
use crate::algebra::text::parse::ParseError;
use std::ops::Range;

/// Largest number of characters after a variable's name in which the end of its index is searched.
const LONGEST_INDEX: usize = 40;

/// Translates a formula of a program into the language of model files; `spell` gives the names of
/// variables. Error if the formula is ambiguous or not understood.
pub(super) fn translate(
    text: &str,
    notation: Notation,
    spell: &mut dyn SymbolNames,
) -> Result<Translation, ParseError> {
    let program =
        Program { text, notation, at: 0, out: Translation::new(), calls: Calls::default(), power: vec![false], spell };
    program.whole()
}

/// State of translating a formula of a program, from left to right.
pub(super) struct Program<'a, 's> {
    /// Whole text of the formula, in a programming language.
    pub(super) text: &'a str,
    /// Programming language of the formula.
    pub(super) notation: Notation,
    /// Position of the next character, in bytes.
    pub(super) at: usize,
    /// Formula in the language of model files, as translated so far.
    pub(super) out: Translation,
    /// Parentheses and calls that are open at the present position.
    pub(super) calls: Calls,
    /// Flags of all open levels of parentheses: true while an exponent is being read at that level.
    /// The first entry is for the text outside of all parentheses.
    power: Vec<bool>,
    /// Source of the model's names for the program's variables.
    pub(super) spell: &'s mut dyn SymbolNames,
}

impl Program<'_, '_> {
    /// Translates the whole text of the formula. Error if it has more than one statement or cannot
    /// be translated.
    fn whole(mut self) -> Result<Translation, ParseError> {
        loop {
            self.skip();
            let Some(c) = self.text[self.at..].chars().next() else { break };
            match c {
                '0'..='9' => self.number(),
                '.' if self.rest(1).starts_with(|c: char| c.is_ascii_digit()) => self.number(),
                c if unicode::begins_unicode_name(c) => self.translate_name()?,
                ';' if matches!(self.notation, Notation::Matlab | Notation::C) => {
                    self.at += 1;
                    self.skip();
                    if self.at < self.text.len() {
                        let help = "give the right side of one assignment";
                        return Err(translation_error(self.at..self.text.len(), "more than one statement", help));
                    }
                }
                _ => self.operator(c)?,
            }
        }
        if self.notation == Notation::C {
            refuse_whole_quotients(&self.out)?;
        }
        Ok(self.out)
    }

    /// Rest of the text, beginning `from` bytes after the present position; empty at the end.
    pub(super) fn rest(&self, from: usize) -> &str {
        self.text.get(self.at + from..).unwrap_or_default()
    }

    /// Skips space, comments and line continuations.
    pub(super) fn skip(&mut self) {
        loop {
            let rest = self.rest(0);
            let space = rest.len() - rest.trim_start().len();
            let line = rest.find('\n').unwrap_or(rest.len());
            let length = match self.notation {
                _ if space > 0 => space,
                Notation::Matlab if rest.starts_with('%') || rest.starts_with("...") => line,
                Notation::Python if rest.starts_with('#') => line,
                Notation::C if rest.starts_with("//") => line,
                Notation::C if rest.starts_with("/*") => rest.find("*/").map_or(rest.len(), |end| end + 2),
                Notation::C | Notation::Python if rest.starts_with("\\\n") => 2,
                _ => return,
            };
            self.at += length;
        }
    }

    /// Translates a decimal number; a suffix of C such as `f` is dropped.
    fn number(&mut self) {
        let start = self.at;
        let bytes = self.text.as_bytes();
        let digits = |mut at: usize| {
            while bytes.get(at).is_some_and(|b| b.is_ascii_digit() || *b == b'.') {
                at += 1;
            }
            at
        };
        self.at = digits(start);
        if matches!(bytes.get(self.at), Some(b'e' | b'E')) {
            let sign = usize::from(matches!(bytes.get(self.at + 1), Some(b'+' | b'-')));
            let end = digits(self.at + 1 + sign);
            self.at = if end > self.at + 1 + sign { end } else { self.at };
        }
        let mut end = self.at;
        // In MATLAB, 2.*x is 2 .* x, and the dots of 2... continue the line: they are no part of
        // the number.
        if self.notation == Notation::Matlab {
            let after = self.rest(0).starts_with(['*', '/', '^']) && self.text[start..end].ends_with('.');
            let dots = self.text[start..end].find("...").map(|dots| start + dots);
            end = dots.unwrap_or(end - usize::from(after));
            self.at = end;
        }
        if self.notation == Notation::C && self.rest(0).starts_with(['f', 'F', 'l', 'L']) {
            self.at += 1;
        }
        self.out.push(&self.text[start..end], start..self.at);
    }

    /// Reads a name with its modules and members, such as `p.m`. Returns it with its byte range.
    pub(super) fn word(&mut self) -> (String, Range<usize>) {
        let start = self.at;
        loop {
            let length = self.rest(0).find(|c: char| !unicode::is_inside_unicode_name(c));
            self.at += length.unwrap_or(self.rest(0).len());
            let begins = |skip: usize| self.rest(skip).starts_with(|c: char| c.is_ascii_alphabetic() || c == '_');
            let step = match self.rest(0) {
                rest if rest.starts_with(".diff(") => break,
                rest if rest.starts_with('.') && begins(1) => 1,
                rest if self.notation == Notation::C
                    && (rest.starts_with("::") || rest.starts_with("->"))
                    && begins(2) =>
                {
                    2
                }
                _ => break,
            };
            self.at += step;
        }
        (self.text[start..self.at].replace("->", "."), start..self.at)
    }

    /// Translates a name: a constant, a call, or a variable with its indices and derivatives. Error
    /// if the variable is unknown.
    fn translate_name(&mut self) -> Result<(), ParseError> {
        let (whole, place) = self.word();
        let word = name_without_module(&whole).to_owned();
        if let Some(tokens) = constant(&word, self.notation) {
            self.out.push_all(tokens, &place);
            return Ok(());
        }
        self.skip();
        if self.rest(0).starts_with('(') && self.call(&word, &place)? {
            return Ok(());
        }
        let name = self.read_indices(word);
        let name =
            self.spell.name_of_variable(&name).map_err(|why| untranslatable_symbol_error(place.start..self.at, why))?;
        let place = place.start..self.at;
        let name = self.read_derivative_suffix(name)?;
        self.out.push(&name, place);
        Ok(())
    }

    /// Reads the indices after a name: `z(6)` in MATLAB, `z[5]`, `x[2][0]` and `p['m']` elsewhere.
    /// Returns the name with its indices.
    fn read_indices(&mut self, mut word: String) -> String {
        let (open, close) = if self.notation == Notation::Matlab { ('(', ')') } else { ('[', ']') };
        loop {
            let near =
                self.rest(0).char_indices().nth(LONGEST_INDEX).map_or(self.rest(0), |(end, _)| &self.rest(0)[..end]);
            let inside =
                near.strip_prefix(open).and_then(|rest| rest.split_once(close)).map(|(inside, _)| inside.to_owned());
            let Some(inside) = inside else { return word };
            let index = inside.replace(' ', "").replace('"', "'");
            if !is_program_index(&index) {
                return word;
            }
            self.at += inside.len() + 2;
            word = format!("{word}{open}{index}{close}");
        }
    }

    /// Translates an operator, a parenthesis or a comma. Error for any other character, and for an
    /// operator with another meaning in the language.
    fn operator(&mut self, c: char) -> Result<(), ParseError> {
        let rest = self.rest(0);
        let matlab = self.notation == Notation::Matlab;
        let (token, length) = match c {
            '.' if matlab && rest[1..].starts_with(['*', '/', '^']) => (&rest[1..2], 2),
            '*' if rest.starts_with("**") && self.notation == Notation::Python => ("^", 2),
            '/' if rest.starts_with("//") => return Err(self.unexpected_character(c)),
            '^' if !matlab => return Err(self.unexpected_character(c)),
            '+' | '-' | '*' | '/' | '^' | '(' | ')' | ',' => (&rest[..1], 1),
            _ => match unicode::operator(c).filter(|token| token.len() == 1) {
                Some(token) => (token, c.len_utf8()),
                None => return Err(self.unexpected_character(c)),
            },
        };
        let token = token.to_owned();
        let place = self.at..self.at + length;
        if token == "^" {
            self.begin_power(&place)?;
        } else if matches!(token.as_str(), "+" | "-" | "*" | "/") && self.ends_operand() {
            self.leave_power();
        }
        self.at += length;
        match token.as_str() {
            "(" => {
                self.power.push(false);
                self.calls.open(&mut self.out, &["("], &place);
            }
            ")" if self.calls.is_open() => {
                self.power.pop();
                self.calls.close(&mut self.out, &place)?;
            }
            "," => {
                self.leave_power();
                self.calls.comma(&mut self.out, &place)?;
            }
            token => self.out.push(token, place),
        }
        Ok(())
    }

    /// Skips the opening parenthesis of a call, and adds a level of parentheses.
    pub(super) fn enter_call(&mut self) {
        self.at += 1;
        self.power.push(false);
    }

    /// Marks the end of an exponent at the present level of parentheses.
    fn leave_power(&mut self) {
        if let Some(power) = self.power.last_mut() {
            *power = false;
        }
    }

    /// True if the last translated token ends an operand: it is not an operator, `(` or a comma.
    fn ends_operand(&self) -> bool {
        let last = self.out.tokens().next_back().map(|(token, _)| token);
        last.is_some_and(|token| !matches!(token, "+" | "-" | "*" | "/" | "^" | "(" | ","))
    }

    /// Marks the beginning of an exponent. Error in MATLAB for a power of a power: MATLAB reads
    /// a^b^c as (a^b)^c, other languages as a^(b^c).
    fn begin_power(&mut self, place: &Range<usize>) -> Result<(), ParseError> {
        let Some(power) = self.power.last_mut() else { return Ok(()) };
        if std::mem::replace(power, true) && self.notation == Notation::Matlab {
            let help = "MATLAB reads a^b^c as (a^b)^c: write the parentheses";
            return Err(translation_error(place.clone(), "a power of a power", help));
        }
        Ok(())
    }

    /// Creates the error for a character that a formula of the language cannot contain, with
    /// advice.
    fn unexpected_character(&self, c: char) -> ParseError {
        let (mut shown, mut span) = character_at(self.text, self.at);
        let help = match (self.notation, c) {
            (Notation::C, '^') => "in C this is no power: pow(x, 2)",
            (Notation::Python, '^') => "in Python this is no power: x**2",
            (Notation::Python, '/') => {
                (shown, span) = ("//".to_owned(), self.at..self.at + 2);
                "this divides down to a whole number: write `/`"
            }
            (Notation::Matlab, '\'') => {
                "in MATLAB this transposes: a rate has a name of its own, which [symbols] declares, as in q1d = \"q1'\""
            }
            (_, '\'') => "a rate has a name of its own, which [symbols] declares, as in q1d = \"q1'\"",
            (Notation::Matlab, '\\') => "write a quotient with `/`; a system of equations is a [[system]]",
            (_, '=') => "give the right side of an assignment alone",
            (_, '[' | ']' | '{' | '}') => "give each component an entry of its own",
            (_, '<' | '>' | '?' | '!' | '&' | '|' | '~') => "a formula has no conditions",
            _ => "allowed are numbers, names, + - * / ( ), powers and functions such as sin(q1)",
        };
        translation_error(span, format!("unexpected `{shown}`"), help)
    }

    /// Opens the call of the function `word`, whose parenthesis comes next. False if `word` is not
    /// a function. Error for C's `abs`, which rounds to an integer.
    fn call(&mut self, word: &str, place: &Range<usize>) -> Result<bool, ParseError> {
        if self.notation == Notation::C && word == "abs" {
            let help = "in C this rounds to a whole number: fabs(x)";
            return Err(translation_error(place.clone(), "unexpected `abs`", help));
        }
        if let Some(name) = self.derivative(word)? {
            self.out.push(&name, place.start..self.at);
            return Ok(true);
        }
        if self.calls.open_rewritten_call(&mut self.out, word, self.notation, place) {
            self.enter_call();
            return Ok(true);
        }
        let found = if self.notation == Notation::C { function_of_c(word) } else { function(word) };
        let Some(name) = found else { return Ok(false) };
        let name = name.to_owned();
        self.out.push(&name, place.clone());
        let open = self.at..self.at + 1;
        self.enter_call();
        self.calls.open(&mut self.out, &["("], &open);
        Ok(true)
    }
}

/// True if the text between brackets is an index: integers separated by commas, or a word in single
/// quotes.
pub(crate) fn is_program_index(text: &str) -> bool {
    let is_word = |text: &str| {
        let word = text.strip_prefix('\'').and_then(|rest| rest.strip_suffix('\''));
        word.is_some_and(|word| !word.is_empty() && word.chars().all(unicode::is_inside_unicode_name))
    };
    is_word(text) || text.split(',').all(|n| !n.is_empty() && n.bytes().all(|b| b.is_ascii_digit()))
}
