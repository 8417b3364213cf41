//! Splitting of LaTeX text into tokens: numbers, letters, commands and single characters. Tokens
//! that only add space or align are dropped.

use crate::algebra::text::notation::translation_errors::{character_at, translation_error};
use crate::algebra::text::notation::unicode::operator;
use crate::algebra::text::parse::ParseError;
use crate::algebra::text::print::greek_name;
use std::ops::Range;

/// Smallest unit of a LaTeX formula: a number, a letter, a command such as `\frac`, or another
/// character.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Token {
    /// Digits of a number, with or without a decimal point.
    Number(String),
    /// A single Latin letter.
    Letter(char),
    /// A LaTeX command, without its backslash.
    Command(String),
    /// Any other single character, such as `+` or a brace.
    Char(char),
}

/// Token of a LaTeX formula with its place in the text.
#[derive(Clone, Debug)]
pub(super) struct PlacedToken {
    /// The token: a number, letter, command or other character.
    pub(super) mark: Token,
    /// Place of the token in the text, as a byte range.
    pub(super) span: Range<usize>,
    /// True if the formula prints space before the token.
    pub(super) apart: bool,
}

/// LaTeX commands that only print space.
const SPACES: [&str; 8] = [",", ";", ":", " ", "quad", "qquad", "thinspace", "medspace"];
/// LaTeX commands that only change the appearance, and commands that begin or end a formula; they
/// are dropped.
const LOOKS: [&str; 24] = [
    "!",
    "\\",
    "displaystyle",
    "textstyle",
    "nonumber",
    "notag",
    "limits",
    "big",
    "Big",
    "bigg",
    "Bigg",
    "bigl",
    "Bigl",
    "biggl",
    "Biggl",
    "bigr",
    "Bigr",
    "biggr",
    "Biggr",
    "middle",
    "[",
    "]",
    "(",
    ")",
];

/// Splits a LaTeX text into tokens. Error for a character or command that cannot occur in a
/// formula.
pub(super) fn tokens(text: &str) -> Result<Vec<PlacedToken>, ParseError> {
    let (mut list, mut at, mut apart, mut side) = (Vec::new(), 0, false, None);
    while let Some(c) = text[at..].chars().next() {
        let start = at;
        at += c.len_utf8();
        let mark = match c {
            _ if c.is_whitespace() => continue,
            '~' => {
                apart = true;
                continue;
            }
            '&' | '$' => continue,
            '%' => {
                at = text[at..].find('\n').map_or(text.len(), |end| at + end);
                continue;
            }
            '\\' => {
                let name = command(text, at);
                at += name.len();
                if SPACES.contains(&name) {
                    apart = true;
                    continue;
                }
                if LOOKS.contains(&name) {
                    continue;
                }
                if let "left" | "right" = name {
                    side = Some(if name == "left" { "lvert" } else { "rvert" });
                    continue;
                }
                if name.is_empty() {
                    return Err(translation_error(start..at, "a command has no name", "remove the backslash"));
                }
                Token::Command(name.to_owned())
            }
            '0'..='9' | '.' => {
                at = start + number(&text[start..]);
                Token::Number(text[start..at].to_owned())
            }
            '|' if side.is_some() => Token::Command(side.unwrap_or_default().to_owned()),
            'a'..='z' | 'A'..='Z' => Token::Letter(c),
            _ if c.is_ascii() => Token::Char(c),
            _ if greek_name(c).is_some() => Token::Command(greek_name(c).unwrap_or_default().to_owned()),
            _ if matches!(operator(c), Some("*" | "-")) => {
                Token::Char(operator(c).and_then(|token| token.chars().next()).unwrap_or(c))
            }
            _ => {
                let (shown, span) = character_at(text, start);
                let message = format!("unexpected `{shown}`");
                return Err(translation_error(
                    span,
                    message,
                    "write it as LaTeX does: \\theta for a Greek letter, \\cdot for a product",
                ));
            }
        };
        side = None;
        list.push(PlacedToken { mark, span: start..at, apart });
        apart = false;
    }
    remove_final_punctuation(&mut list);
    Ok(remove_empty_groups(list))
}

/// Name of the command whose backslash is just before byte `at`: letters, or a single other
/// character.
fn command(text: &str, at: usize) -> &str {
    let rest = &text[at..];
    let letters = rest.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(rest.len());
    let length = if letters > 0 { letters } else { rest.chars().next().map_or(0, char::len_utf8) };
    &rest[..length]
}

/// Length, in bytes, of the decimal number at the start of a text.
fn number(text: &str) -> usize {
    let mut points = 0;
    let inside = |c: char| {
        points += usize::from(c == '.');
        !(c.is_ascii_digit() || (c == '.' && points < 2))
    };
    text.find(inside).unwrap_or(text.len())
}

/// Removes empty groups `{}` before a sign or product sign. They only change the printed space.
fn remove_empty_groups(list: Vec<PlacedToken>) -> Vec<PlacedToken> {
    let is = |at: usize, c: char| list.get(at).is_some_and(|placed| placed.mark == Token::Char(c));
    let is_product = |at: usize| match list.get(at).map(|placed| &placed.mark) {
        Some(Token::Command(name)) => ["cdot", "times", "ast"].contains(&name.as_str()),
        _ => false,
    };
    let is_sign = |at: usize| is(at, '+') || is(at, '-') || is_product(at);
    let is_support = |at: usize| is(at, '{') && is(at + 1, '}') && is_sign(at + 2);
    let dropped: Vec<bool> = (0..list.len()).map(|at| is_support(at) || (at > 0 && is_support(at - 1))).collect();
    list.into_iter().zip(dropped).filter(|(_, dropped)| !dropped).map(|(placed, _)| placed).collect()
}

/// Removes a comma, semicolon or full stop at the end of a formula: it belongs to the surrounding
/// sentence.
fn remove_final_punctuation(list: &mut Vec<PlacedToken>) {
    let Some(last) = list.last_mut() else { return };
    match &mut last.mark {
        Token::Char(',' | ';') => {
            list.pop();
        }
        Token::Number(digits) if digits == "." => {
            list.pop();
        }
        Token::Number(digits) if digits.ends_with('.') => {
            digits.pop();
        }
        _ => {}
    }
}
