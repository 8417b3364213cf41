//! Plain text of input files in messages and outputs. Functions find forbidden characters, and
//! print texts and numbers for people.
//!
//! The readers of files refuse control characters and characters that change the direction of
//! writing. So no output has to handle them. Text that does not pass a reader, such as a line with
//! a syntax error or the name of a folder, is converted by [`with_visible_characters`].
//!
//! This module does not quote text for Rust, HTML, LaTeX, CSV or JSON. Each writer of such a format
//! has its own escapes.

use std::borrow::Cow;
use std::cmp::Ordering;
use std::path::Path;

/// True if a character is forbidden in a line of text. Forbidden are control characters, marks that change the
/// direction of writing, line and paragraph separators, and invisible characters. An invisible character can make a
/// text read as another text.
#[must_use]
pub fn is_forbidden(c: char) -> bool {
    c.is_control()
        || matches!(c,
            '\u{00ad}' | '\u{200b}' | '\u{2060}'..='\u{2064}' | '\u{e0000}'..='\u{e007f}' | '\u{061c}' | '\u{200e}' | '\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2066}'..='\u{2069}' | '\u{feff}' | '\u{fff9}'..='\u{fffb}')
}

/// True if a character is white space in a text: line feed, carriage return, tab or space.
#[must_use]
pub fn is_blank(c: char) -> bool {
    matches!(c, '\n' | '\r' | '\t' | ' ')
}

/// Code point of a character in the notation of Unicode: `U+001B` for the escape character.
#[must_use]
pub fn code_point_text(c: char) -> String {
    format!("U+{:04X}", u32::from(c))
}

/// Puts a text on one line: each run of white space becomes one space. White space at both ends is
/// removed.
#[must_use]
pub fn one_line(text: &str) -> String {
    text.split(is_blank).filter(|word| !word.is_empty()).collect::<Vec<_>>().join(" ")
}

/// Replaces every forbidden character of a text by its escape, such as `\u{1b}`. Line feeds are
/// kept.
#[must_use]
pub fn with_visible_characters(text: &str) -> Cow<'_, str> {
    if text.chars().all(|c| c == '\n' || !is_forbidden(c)) {
        return Cow::Borrowed(text);
    }
    let written = |c: char| if c == '\n' || !is_forbidden(c) { c.to_string() } else { c.escape_unicode().to_string() };
    Cow::Owned(text.chars().map(written).collect())
}

/// Number of characters of the longest quotation that a message repeats in full.
const LONGEST_QUOTATION: usize = 200;
/// Number of characters that a message shows of a longer quotation.
const SHOWN_OF_QUOTATION: usize = 60;

/// Makes a message readable that quotes parts of a file between backticks. Forbidden characters become escapes; line
/// feeds are kept outside of quotations. A quotation of more than 200 characters is cut after 60. An empty quotation
/// becomes `""`.
///
/// ```
/// use tripos_derive::plain_text::message_text;
///
/// assert_eq!(message_text("unknown key `` in a scene file"), "unknown key `\"\"` in a scene file");
/// assert_eq!(message_text("unexpected `\u{202e}`"), "unexpected `\\u{202e}`");
/// ```
#[must_use]
pub fn message_text(text: &str) -> String {
    let visible = with_visible_characters(text);
    // Every second part stands between backticks. A backtick at the end closes nothing.
    let parts: Vec<&str> = visible.split('`').collect();
    let is_closed = parts.len() % 2 == 1;
    let quoted = |(at, part): (usize, &&str)| match part.char_indices().nth(SHOWN_OF_QUOTATION) {
        _ if at % 2 == 0 || !is_closed => (*part).to_owned(),
        Some((end, _)) if part.chars().count() > LONGEST_QUOTATION => format!("{}…", &part[..end]).replace('\n', "\\n"),
        _ if part.is_empty() => "\"\"".to_owned(),
        _ => part.replace('\n', "\\n"),
    };
    parts.iter().enumerate().map(quoted).collect::<Vec<_>>().join("`")
}

/// Writes a number for people with `digits` significant digits. It is a decimal fraction if its
/// absolute value is from 0.001 up to 100 000; otherwise it has a power of ten.
///
/// ```
/// use tripos_derive::plain_text::with_significant_digits;
///
/// assert_eq!(with_significant_digits(3.0321, 4), "3.032");
/// assert_eq!(with_significant_digits(-0.37899999999999995, 3), "-0.379");
/// assert_eq!(with_significant_digits(0.0000193, 2), "1.9e-5");
/// assert_eq!(with_significant_digits(0.0, 2), "0");
/// ```
#[must_use]
pub fn with_significant_digits(x: f64, digits: usize) -> String {
    let short = format!("{x:.*e}", digits.saturating_sub(1));
    match short.parse::<f64>() {
        Ok(value) if value == 0.0 || (1e-3..1e5).contains(&value.abs()) => value.to_string(),
        _ => short,
    }
}

/// Writes a number for people with the digits that are reliable at the absolute error `error`, at
/// most ten. If `error` is `None`, zero or negative, it has six digits.
///
/// ```
/// use tripos_derive::plain_text::with_reliable_digits;
///
/// assert_eq!(with_reliable_digits(0.45152364098573, Some(2e-5)), "0.45152");
/// assert_eq!(with_reliable_digits(5.927797845629991e-16, Some(2e-16)), "6e-16");
/// assert_eq!(with_reliable_digits(0.45152364098573, None), "0.451524");
/// ```
#[must_use]
pub fn with_reliable_digits(x: f64, error: Option<f64>) -> String {
    let Some(error) = error.filter(|error| *error > 0.0) else { return with_significant_digits(x, 6) };
    let (mut digits, mut reach) = (1, 10.0 * error);
    while digits < 10 && reach < x.abs() {
        reach *= 10.0;
        digits += 1;
    }
    with_significant_digits(x, digits)
}

/// Path as one line of text for a message. Line breaks and forbidden characters in file names are
/// written as escapes.
#[must_use]
pub fn path_as_plain_text(path: &Path) -> String {
    with_visible_characters(&path.display().to_string()).replace('\n', "\\u{a}")
}

/// Compares two texts for sorting, with runs of digits compared by value: `rod2` comes before
/// `rod10`.
#[must_use]
pub fn compare_with_numbers(a: &str, b: &str) -> Ordering {
    let (mut a, mut b) = (a, b);
    loop {
        let digits = |text: &str| text.find(|c: char| !c.is_ascii_digit()).unwrap_or(text.len());
        let (m, n) = (digits(a), digits(b));
        let order = if m > 0 && n > 0 {
            let (x, y) = (a[..m].trim_start_matches('0'), b[..n].trim_start_matches('0'));
            (x.len(), x).cmp(&(y.len(), y))
        } else {
            a[..m].cmp(&b[..n])
        };
        (a, b) = (&a[m..], &b[n..]);
        let (x, y) = (a.chars().next(), b.chars().next());
        let order = order.then(x.cmp(&y));
        let (Ordering::Equal, Some(c)) = (order, x) else { return order };
        (a, b) = (&a[c.len_utf8()..], &b[c.len_utf8()..]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_steers_a_terminal_or_turns_a_line_is_written_out() {
        assert_eq!(with_visible_characters("q\u{1b}[31m \u{202e}abc\u{9b}"), "q\\u{1b}[31m \\u{202e}abc\\u{9b}");
        assert_eq!(with_visible_characters("plain — θ̇ 🎢\nand a line"), "plain — θ̇ 🎢\nand a line");
        assert_eq!(one_line("  two\r\n\twords "), "two words");
        assert_eq!(message_text("`a\n` is\nno name"), "`a\\n` is\nno name");
        assert_eq!(message_text("unexpected ```"), "unexpected ```");
        let long = "x".repeat(201);
        assert_eq!(message_text(&format!("`{long}` is unknown")), format!("`{}…` is unknown", &long[..60]));
        assert_eq!(code_point_text('\u{1b}'), "U+001B");
        assert_eq!(path_as_plain_text(Path::new("a\nb\u{7}/é")), "a\\u{a}b\\u{7}/é");
    }

    #[test]
    fn names_are_in_the_order_of_their_numbers() {
        assert_eq!(compare_with_numbers("rod2", "rod10"), Ordering::Less);
        assert_eq!(compare_with_numbers("k1_10", "k2_1"), Ordering::Less);
        assert_eq!(compare_with_numbers("k1_10", "k1_9"), Ordering::Greater);
        assert_eq!(compare_with_numbers("rod", "rod1"), Ordering::Less);
        assert_eq!(compare_with_numbers("a", "b"), Ordering::Less);
        assert_eq!(compare_with_numbers("q", "q"), Ordering::Equal);
    }
}
