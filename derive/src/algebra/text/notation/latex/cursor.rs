//! Symbols of LaTeX: a letter with its accents, subscript, superscript and dots.

use super::tokens::{PlacedToken, Token, tokens};
use crate::algebra::text::notation::function_names::is_letter;
use crate::algebra::text::notation::latex_symbol::LatexSymbol;
use crate::algebra::text::notation::translation_errors::translation_error;
use crate::algebra::text::parse::{MAX_DEPTH, ParseError};
use std::ops::Range;

/// Reads a text that is a single LaTeX symbol; a superscript belongs to the symbol. `None` if the
/// text is anything else.
#[must_use]
pub fn read_symbol(text: &str) -> Option<LatexSymbol> {
    let list = tokens(text).ok()?;
    let mut cursor = LatexCursor { list: &list, at: 0, depth: 0, end: text.len() };
    let (symbol, _) = cursor.symbol(&|_| true).ok()??;
    (cursor.at == list.len()).then_some(symbol)
}

/// LaTeX commands for type faces that do not change the meaning of a letter.
const UPRIGHT: [&str; 9] =
    ["mathrm", "text", "textrm", "mathit", "textit", "mathnormal", "operatorname", "mathsf", "mbox"];
/// LaTeX commands for accents and type faces that make a letter into another symbol.
const ACCENTS: [&str; 15] = [
    "mathbf",
    "boldsymbol",
    "bm",
    "vec",
    "hat",
    "bar",
    "tilde",
    "mathcal",
    "mathbb",
    "overline",
    "underline",
    "widehat",
    "widetilde",
    "check",
    "breve",
];
/// LaTeX commands for time derivatives, each with the order of the derivative.
const DOTS: [(&str, usize); 3] = [("dot", 1), ("ddot", 2), ("dddot", 3)];

/// Highest order of a time derivative that may be written as a fraction.
const MOST_DOTS: usize = 3;

/// Position in the tokens of a LaTeX formula.
#[derive(Clone)]
pub(super) struct LatexCursor<'a> {
    /// All tokens of the LaTeX formula.
    pub(super) list: &'a [PlacedToken],
    /// Index of the next token.
    pub(super) at: usize,
    /// Number of groups and parentheses that are open.
    pub(super) depth: usize,
    /// Length of the formula's text, in bytes.
    pub(super) end: usize,
}

impl<'a> LatexCursor<'a> {
    /// Next token; `None` at the end.
    pub(super) fn peek(&self) -> Option<&'a Token> {
        self.list.get(self.at).map(|placed| &placed.mark)
    }

    /// Byte range of the next token; at the end, the empty range after the text.
    pub(super) fn here(&self) -> Range<usize> {
        self.list.get(self.at).map_or(self.end..self.end, |placed| placed.span.clone())
    }

    /// Byte range from the token with the index `first` to the last token that was read.
    pub(super) fn span_since(&self, first: usize) -> Range<usize> {
        let start = self.list.get(first).map_or(self.end, |placed| placed.span.start);
        let last = self.list[..self.at.min(self.list.len())].last().map_or(start, |placed| placed.span.end);
        start..last.max(start)
    }

    /// Skips the next token if it is the character `c`. Returns true if it was skipped.
    pub(super) fn takes(&mut self, c: char) -> bool {
        let found = self.peek() == Some(&Token::Char(c));
        self.at += usize::from(found);
        found
    }

    /// Skips the letter d of a derivative, in roman or italic type. Returns false, and skips
    /// nothing, if it does not come next.
    pub(super) fn takes_d(&mut self) -> bool {
        let before = self.at;
        let is_face = matches!(self.peek(), Some(Token::Command(name)) if UPRIGHT.contains(&name.as_str()));
        self.at += usize::from(is_face);
        let braced = is_face && self.takes('{');
        let found = self.peek() == Some(&Token::Letter('d'));
        self.at += usize::from(found);
        if found && (!braced || self.takes('}')) {
            return true;
        }
        self.at = before;
        false
    }

    /// Reads the order of a derivative, the exponent of d^2. It is 1 if no exponent comes next, and
    /// 0 if the exponent is not an order from 0 to 3.
    pub(super) fn takes_order(&mut self) -> usize {
        if !self.takes('^') {
            return 1;
        }
        let braced = self.takes('{');
        let order = match self.peek() {
            Some(Token::Number(digits)) => digits.parse().ok().filter(|order| *order <= MOST_DOTS).unwrap_or(0),
            _ => 0,
        };
        self.at += 1;
        if !braced || self.takes('}') { order } else { 0 }
    }

    /// Counts one more level of nesting. Error if the nesting is too deep.
    pub(super) fn enter(&mut self) -> Result<(), ParseError> {
        self.depth += 1;
        if self.depth > MAX_DEPTH {
            return Err(translation_error(
                self.here(),
                format!("nesting deeper than {MAX_DEPTH}"),
                "split the expression",
            ));
        }
        Ok(())
    }

    /// Reads a LaTeX symbol, and returns it with its byte range. `None` if no symbol begins at the
    /// next token. A superscript becomes a part of the symbol only if `knows` returns true for the
    /// symbol with it.
    pub(super) fn symbol(
        &mut self,
        knows: &dyn Fn(&LatexSymbol) -> bool,
    ) -> Result<Option<(LatexSymbol, Range<usize>)>, ParseError> {
        let first = self.at;
        self.enter()?;
        let base = self.read_base(knows)?;
        self.depth -= 1;
        let Some(mut symbol) = base else {
            self.at = first;
            return Ok(None);
        };
        loop {
            match self.peek() {
                Some(Token::Char('\'')) => {
                    self.at += 1;
                    symbol.dots += 1;
                }
                Some(Token::Char('_')) if symbol.subscript.is_empty() => {
                    self.at += 1;
                    symbol.subscript = self.read_script()?;
                }
                Some(Token::Char('^')) if symbol.mark.is_empty() => {
                    let before = self.at;
                    self.at += 1;
                    let text = self.read_script()?;
                    let primes = text.matches("\\prime").count();
                    let primes_only = primes > 0 && text.len() == primes * "\\prime".len();
                    let mut marked = LatexSymbol { mark: text, ..symbol.clone() };
                    // In I^B_{11} the subscript is read before `knows` is asked about the symbol.
                    if !primes_only && marked.subscript.is_empty() && self.takes('_') {
                        marked.subscript = self.read_script()?;
                    }
                    if primes_only {
                        symbol.dots += primes;
                    } else if knows(&marked) {
                        symbol = marked;
                    } else {
                        self.at = before;
                        break;
                    }
                }
                _ => break,
            }
        }
        Ok(Some((symbol, self.span_since(first))))
    }

    /// Reads the letter of a symbol, within any braces, accents and dots. `None` if no letter
    /// begins at the next token.
    fn read_base(&mut self, knows: &dyn Fn(&LatexSymbol) -> bool) -> Result<Option<LatexSymbol>, ParseError> {
        let Some(mark) = self.peek() else { return Ok(None) };
        self.at += 1;
        match mark {
            Token::Letter(c) => Ok(Some(LatexSymbol::plain(*c))),
            Token::Command(name) if is_letter(name) => Ok(Some(LatexSymbol::plain(format!("\\{name}")))),
            Token::Command(name) if UPRIGHT.contains(&name.as_str()) => {
                let word = self.read_script()?;
                Ok(Some(LatexSymbol::plain(word)))
            }
            Token::Command(name) if ACCENTS.contains(&name.as_str()) => {
                let inner = self.symbol(knows)?;
                let accented =
                    |(inner, _): (LatexSymbol, _)| LatexSymbol { base: format!("\\{name}{{{}}}", inner.base), ..inner };
                Ok(inner.map(accented))
            }
            Token::Command(name) => {
                let Some((_, dots)) = DOTS.iter().find(|(n, _)| n == name) else { return Ok(None) };
                let place = self.span_since(self.at - 1);
                let Some((inner, _)) = self.symbol_without_scripts(knows)? else {
                    let message = format!("`\\{name}` stands on no symbol");
                    return Err(translation_error(
                        place,
                        message,
                        "write the derivatives of single symbols: \\dot{q}_1 + \\dot{q}_2",
                    ));
                };
                Ok(Some(LatexSymbol { dots: inner.dots + dots, ..inner }))
            }
            Token::Char('{') => {
                let inner = self.symbol(knows)?;
                Ok(inner.filter(|_| self.takes('}')).map(|(symbol, _)| symbol))
            }
            _ => Ok(None),
        }
    }

    /// Reads the symbol below dots: a symbol in braces, or a single letter. `None` if no symbol
    /// comes next.
    fn symbol_without_scripts(
        &mut self,
        knows: &dyn Fn(&LatexSymbol) -> bool,
    ) -> Result<Option<(LatexSymbol, Range<usize>)>, ParseError> {
        self.enter()?;
        let (first, base) = (self.at, self.read_base(knows)?);
        self.depth -= 1;
        Ok(base.map(|symbol| (symbol, self.span_since(first))))
    }

    /// Reads a subscript or superscript as text, without braces, spaces and upright type faces.
    /// Error if the script is missing or ambiguous.
    fn read_script(&mut self) -> Result<String, ParseError> {
        let (mut text, mut open) = (String::new(), 0_usize);
        let first = self.at;
        loop {
            let Some(mark) = self.peek() else {
                let place = self.span_since(first.saturating_sub(1));
                return Err(translation_error(place, "this script never ends", "write it in braces, as in q_{12}"));
            };
            // Without braces, TeX takes only one digit as the subscript or superscript.
            if let (Token::Number(digits), 0) = (mark, open)
                && digits.len() > 1
            {
                let help = format!("write it in braces: `{{{digits}}}`; without them only {} is meant", &digits[..1]);
                return Err(translation_error(self.here(), format!("is `{digits}` all below or above?"), &help));
            }
            self.at += 1;
            match mark {
                Token::Char('{') => open += 1,
                Token::Char('}') if open == 0 => {
                    let help = "write it in braces, as in q_{12}";
                    return Err(translation_error(
                        self.span_since(self.at - 1),
                        "a script is missing in front of `}`",
                        help,
                    ));
                }
                Token::Char('}') => open -= 1,
                Token::Char(c) | Token::Letter(c) => text.push(*c),
                Token::Number(digits) => text.push_str(digits),
                Token::Command(name) if UPRIGHT.contains(&name.as_str()) => continue,
                Token::Command(name) if name == "_" => text.push('_'),
                Token::Command(name) => {
                    text.push('\\');
                    text.push_str(name);
                }
            }
            if open == 0 {
                return Ok(text);
            }
        }
    }
}
