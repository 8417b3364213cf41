//! Unicode names and operators outside ASCII, as Julia, Python and people write them: `θ̇₁`,
//! `2·x²`.

use super::symbol_names::SymbolNames;
use super::translation::Translation;
use super::translation_errors::untranslatable_symbol_error;
use crate::algebra::text::parse::ParseError;
use crate::algebra::text::print::greek_name;

/// Operators and powers outside ASCII, each with its form in the language of model files.
const OPERATORS: [(char, &str); 8] =
    [('·', "*"), ('⋅', "*"), ('×', "*"), ('−', "-"), ('–', "-"), ('²', "^2"), ('³', "^3"), ('⁴', "^4")];

/// Translates a character outside ASCII that is an operator or power, such as `·` or `²`; `None`
/// for any other character.
pub(super) fn operator(c: char) -> Option<&'static str> {
    OPERATORS.iter().find(|(sign, _)| *sign == c).map(|(_, token)| *token)
}

/// True if a character may begin a name: a letter of any alphabet, or an underscore.
pub(super) fn begins_unicode_name(c: char) -> bool {
    c.is_ascii_alphabetic() || c == '_' || !c.is_ascii() && c.is_alphabetic()
}

/// True if a character may occur inside a name: letters, digits, subscript digits and dots above
/// letters.
pub(super) fn is_inside_unicode_name(c: char) -> bool {
    begins_unicode_name(c) || c.is_ascii_digit() || subscript(c).is_some() || dots(c) > 0
}

/// Digit that a subscript digit stands for; `None` for any other character.
fn subscript(c: char) -> Option<char> {
    let digit = u32::from(c).checked_sub(u32::from('₀')).filter(|digit| *digit < 10)?;
    char::from_digit(digit, 10)
}

/// Number of time derivatives that a combining accent stands for: 1 for a dot, 2 for two dots, else
/// 0.
fn dots(c: char) -> usize {
    match c {
        '\u{307}' => 1,
        '\u{308}' => 2,
        _ => 0,
    }
}

/// Possible names in model files of a name outside ASCII. For example, θ̇₁ may be `theta1'` or
/// `theta_1'`. Empty if a character has no ASCII form.
#[must_use]
pub fn ascii_names_of_unicode(name: &str) -> Vec<String> {
    let (mut plain, mut apart, mut primes) = (String::new(), String::new(), 0);
    for c in name.chars() {
        primes += dots(c);
        if dots(c) > 0 {
            continue;
        }
        if let Some(digit) = subscript(c) {
            if apart == plain {
                apart.push('_');
            }
            plain.push(digit);
            apart.push(digit);
        } else if c.is_ascii() {
            plain.push(c);
            apart.push(c);
        } else if let Some(letter) = greek_name(c) {
            plain += letter;
            apart += letter;
        } else {
            return Vec::new();
        }
    }
    let mut names = vec![plain, apart];
    names.dedup();
    names.iter().map(|name| format!("{name}{}", "'".repeat(primes))).collect()
}

/// Translates a formula of model files with names or operators outside ASCII into ASCII. Error for
/// a name that `spell` does not know.
pub(super) fn translate_unicode(text: &str, spell: &mut dyn SymbolNames) -> Result<Translation, ParseError> {
    let mut out = Translation::new();
    let mut at = 0;
    while let Some(c) = text[at..].chars().next() {
        let start = at;
        if begins_unicode_name(c) {
            at += text[at..].find(|c| !is_inside_unicode_name(c)).unwrap_or(text.len() - at);
            let word = &text[start..at];
            let primes = text[at..].bytes().take_while(|b| *b == b'\'').count();
            at += primes;
            let name = if word.is_ascii() {
                word.to_owned()
            } else {
                spell.name_of_variable(word).map_err(|why| untranslatable_symbol_error(start..at, why))?
            };
            out.push(&format!("{name}{}", "'".repeat(primes)), start..at);
        } else if c.is_ascii_digit() || c == '.' {
            // A number may have an exponent, such as 1.5e-3.
            let bytes = text.as_bytes();
            while bytes.get(at).is_some_and(|b| {
                b.is_ascii_digit() || *b == b'.' || matches!(b, b'e' | b'E') || {
                    matches!(b, b'+' | b'-') && at > start && matches!(bytes[at - 1], b'e' | b'E')
                }
            }) {
                at += 1;
            }
            out.push(&text[start..at], start..at);
        } else {
            at += c.len_utf8();
            if !c.is_whitespace() {
                out.push(operator(c).unwrap_or(&text[start..at]), start..at);
            }
        }
    }
    Ok(out)
}

#[cfg(test)]
mod tests {
    use super::ascii_names_of_unicode;

    #[test]
    fn greek_names_are_spelled_out() {
        assert_eq!(ascii_names_of_unicode("θ1dot"), ["theta1dot"]);
        assert_eq!(ascii_names_of_unicode("θ\u{307}₁"), ["theta1'", "theta_1'"]);
        assert_eq!(ascii_names_of_unicode("q\u{308}"), ["q''"]);
        assert!(ascii_names_of_unicode("ж").is_empty());
    }
}
