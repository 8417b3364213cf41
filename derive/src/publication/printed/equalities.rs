//! Splitting of printed equations: into the sides of a chain of equal formulas, and into equations printed side by
//! side.

use crate::algebra::text::notation::Notation;
use std::ops::Range;

/// Byte ranges of the equations that a text prints side by side, as in `a = b, \quad c = d`. A text with a single
/// equation is one range. Commas and wide spaces separate equations, except inside groups and environments.
pub fn equations(text: &str, notation: Notation) -> Vec<Range<usize>> {
    let is_equation = |range: &Range<usize>| sides(text, range.clone(), notation).len() > 1;
    // A part that begins with a sign continues the formula before it.
    let goes_on = |range: &Range<usize>| {
        text[range.clone()].trim_start_matches([' ', '\n', '&', '{', '}']).starts_with(['+', '-', '='])
    };
    let mut parts: Vec<Range<usize>> = Vec::new();
    for part in equality_parts(text, 0..text.len(), notation, equality_separator) {
        match parts.last_mut() {
            Some(last) if !is_equation(last) || !is_equation(&part) || goes_on(&part) => last.end = part.end,
            _ => parts.push(part),
        }
    }
    parts
}

/// Byte ranges of the sides of an equation, or of a chain `a = b = c`. A formula without an equals sign is one range.
pub fn sides(text: &str, range: Range<usize>, notation: Notation) -> Vec<Range<usize>> {
    equality_parts(text, range, notation, |rest, _| usize::from(rest.starts_with('=')))
}

/// True if a printed equation has terms other than 0 on its right side.
pub fn has_right_side(text: &str) -> bool {
    text.find('=').is_some_and(|at| !text[at + 1..].trim().trim_start_matches('0').is_empty())
}

/// Length in bytes of the separator of equations with which a text begins; 0 if it begins with none.
fn equality_separator(rest: &str, notation: Notation) -> usize {
    let marks: &[&str] = if notation == Notation::Latex { &[",", ";", "\\qquad", "\\quad"] } else { &[",", ";"] };
    marks.iter().find(|mark| rest.starts_with(**mark)).map_or(0, |mark| mark.len())
}

/// Splits a range of a formula's text at the marks outside of all brackets and environments, and returns the byte
/// ranges of the parts. `mark` returns the length in bytes of the mark with which a text begins, such as an equals
/// sign, or 0 if it begins with none.
fn equality_parts(
    text: &str,
    range: Range<usize>,
    notation: Notation,
    mark: impl Fn(&str, Notation) -> usize,
) -> Vec<Range<usize>> {
    let (mut parts, mut depth, mut from, mut at) = (Vec::new(), 0_usize, range.start, range.start);
    while at < range.end {
        let rest = &text[at..range.end];
        let length = if depth == 0 { mark(rest, notation) } else { 0 };
        if length > 0 {
            parts.push(from..at);
            (from, at) = (at + length, at + length);
            continue;
        }
        let first = rest.chars().next().map_or(1, char::len_utf8);
        let is_command = notation == Notation::Latex && rest.starts_with('\\');
        let opens = rest.starts_with(['(', '[', '{']) || is_command && rest.starts_with("\\begin{");
        let closes = rest.starts_with([')', ']', '}']) || is_command && rest.starts_with("\\end{");
        match (opens, closes) {
            (true, _) => depth += 1,
            (_, true) => depth = depth.saturating_sub(1),
            _ => {}
        }
        // The name of a command, and a character after a backslash, are not marks.
        at += if is_command { first + rest[1..].chars().next().map_or(0, char::len_utf8) } else { first };
    }
    parts.push(from..range.end);
    parts
}

#[cfg(test)]
mod tests {
    use super::{equations, sides};
    use crate::algebra::text::notation::Notation;

    fn parts(text: &str, notation: Notation) -> Vec<Vec<String>> {
        let of = |range: &std::ops::Range<usize>| text[range.clone()].trim().to_owned();
        let list = equations(text, notation);
        list.into_iter().map(|part| sides(text, part, notation).iter().map(of).collect()).collect()
    }

    #[test]
    fn equations_side_by_side_and_chains_are_parted_outside_of_groups() {
        let latex = Notation::Latex;
        assert_eq!(parts(r"a = b, \qquad c = d = e.", latex), [vec!["a", "b,"], vec!["c", "d", "e."]]);
        assert_eq!(parts(r"x = \max(a, b) \quad (t > 0)", latex), [vec!["x", r"\max(a, b) \quad (t > 0)"]]);
        assert_eq!(
            parts(r"M = \begin{bmatrix} a, & b \end{bmatrix}, \quad h = m l", latex),
            [vec!["M", r"\begin{bmatrix} a, & b \end{bmatrix},"], vec!["h", "m l"]]
        );
        assert_eq!(parts(r"a + b \quad {} - c = d, e = f", latex), [vec![r"a + b \quad {} - c", "d"], vec!["e", "f"]]);
        assert_eq!(parts(r"a = b \quad = c", latex), [vec!["a", r"b \quad", "c"]]);
        assert_eq!(parts("a = f(x, y); b = [1, 2]", Notation::Python), [vec!["a", "f(x, y)"], vec!["b", "[1, 2]"]]);
        assert_eq!(parts("", latex), [vec![""]]);
        assert_eq!(parts("}é{\\", latex).len(), 1);
    }
}
