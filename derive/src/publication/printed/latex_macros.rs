//! Macros of a LaTeX file: reading of their definitions, and replacement in texts. All work is limited by constants.

use super::traced_text::{TracedError, TracedText};
use crate::diagnostic::shortened_for_message;
use rustc_hash::{FxHashMap, FxHashSet};
use std::ops::Range;

/// Largest number of macro calls that are replaced in one text.
const MAX_CALLS: usize = 10_000;
/// Largest number of bytes that macros may add to one text.
const MAX_ADDED: usize = 1_000_000;
/// Largest depth of nested macro calls.
const MAX_NESTING: usize = 100;
/// Largest number of macros in a chain of macros, the last of which begins an environment.
const MAX_ROUNDS: usize = 20;
/// Largest length of a group in braces, in bytes.
const LONGEST_GROUP: usize = 20_000;
/// Largest length, in characters, of a short text, such as the name of an environment or an
/// argument in brackets.
const NEAR: usize = 200;
/// Largest length of a macro's definition, in bytes.
const MAX_BODY: usize = 10_000;

/// Definition of a LaTeX macro: its text, its arguments, and its place.
#[derive(Clone, Debug)]
struct Macro {
    /// Byte position in the file from which on the definition is valid.
    from: usize,
    /// Text of the macro, with `#1`, `#2`, … for arguments. `None` if the macro is another name for a LaTeX command.
    body: Option<String>,
    /// Number of arguments that the macro takes, at most nine.
    arguments: usize,
    /// Default value of the optional first argument. If the macro is another name for a LaTeX command, the command.
    /// `None` if there is neither.
    usual: Option<String>,
    /// True if the form of the definition is not supported, as in `\def\a#1.{…}`.
    is_odd: bool,
}

/// Macros of a LaTeX file; the key is the name without the backslash. From its place on, a later definition replaces an
/// earlier one.
#[derive(Clone, Debug, Default)]
pub struct Macros {
    /// Definitions of each macro, in the order of the file.
    known: FxHashMap<String, Vec<Macro>>,
    /// True if the last definition of each macro is valid everywhere, not only after its place.
    everywhere: bool,
}

/// Name of the command whose backslash is at byte `at`: a run of letters, or a single character.
pub fn command_at(text: &str, at: usize) -> &str {
    let rest = &text[at + 1..];
    let letters = rest.find(|c: char| !(c.is_ascii_alphabetic() || c == '@')).unwrap_or(rest.len());
    let length = if letters > 0 { letters } else { rest.chars().next().map_or(0, char::len_utf8) };
    &rest[..length]
}

/// Text without comments, and without the parts hidden by `\iffalse … \fi` and by the environment
/// comment.
pub fn latex_without_comments(text: &str) -> TracedText {
    let mut out = TracedText::default();
    let end = text.find("\\end{document}").unwrap_or(text.len());
    let (mut at, mut from) = (0, 0);
    let keep = |out: &mut TracedText, range: Range<usize>| {
        let part = TracedText::text_at_place(&text[range.clone()], range.start);
        out.push_part(&part, 0..range.len());
    };
    while at < end {
        let hidden = match text.as_bytes()[at] {
            b'%' => Some(text[at..end].find('\n').map_or(end, |line| at + line + 1)),
            b'\\' => {
                let until = |mark: &str| text[at..end].find(mark).map_or(end, |found| at + found + mark.len());
                match command_at(text, at) {
                    "iffalse" => Some(until("\\fi")),
                    "begin" if text[at..].starts_with("\\begin{comment}") => Some(until("\\end{comment}")),
                    _ => {
                        // An escaped mark, such as \%, begins no comment.
                        at += 1 + text[at + 1..].chars().next().map_or(0, char::len_utf8);
                        continue;
                    }
                }
            }
            _ => None,
        };
        if let Some(next) = hidden {
            keep(&mut out, from..at);
            (at, from) = (next, next);
        } else {
            at += 1;
        }
    }
    keep(&mut out, from.min(end)..end);
    out
}

/// Byte after the closing brace of the group that opens at byte `open`; `None` if it does not close within 20 000
/// bytes.
pub fn group_end(text: &str, open: usize) -> Option<usize> {
    group_end_within(text, open, LONGEST_GROUP)
}

/// Byte after the closing brace of the group that opens at byte `open`; `None` if it does not close within `limit`
/// bytes.
pub fn group_end_within(text: &str, open: usize, limit: usize) -> Option<usize> {
    let (mut depth, mut at) = (0_usize, open);
    let bytes = &text.as_bytes()[..text.len().min(open.saturating_add(limit))];
    while at < bytes.len() {
        match bytes[at] {
            b'\\' => at += 1,
            b'{' => depth += 1,
            b'}' => {
                depth = depth.checked_sub(1)?;
                if depth == 0 {
                    return Some(at + 1);
                }
            }
            _ => {}
        }
        at += 1;
    }
    None
}

/// Distance in bytes from `at` to the next character `mark`; `None` if it is not among the next 200
/// characters.
pub fn next_latex_mark_nearby(text: &str, at: usize, mark: char) -> Option<usize> {
    text[at..].char_indices().take(NEAR).find(|(_, c)| *c == mark).map(|(distance, _)| distance)
}

/// Position of the first character that is not a space, from byte `at` on. The length of the text if there is none.
fn skip_space(text: &str, at: usize) -> usize {
    text[at..].find(|c: char| !c.is_whitespace()).map_or(text.len(), |space| at + space)
}

/// Definition of a LaTeX macro that was found in a text, and the place where it ends.
struct Definition {
    /// Name of the defined macro, without the backslash.
    name: String,
    /// Definition to be stored under this name.
    made: Macro,
    /// Byte position in the text just after the definition.
    end: usize,
}

impl Macros {
    /// True if the file defines no macros.
    pub fn is_empty(&self) -> bool {
        self.known.is_empty()
    }

    /// Macros with the definitions that are valid at the end of their file, for use in another file.
    pub fn at_the_end(&self) -> Self {
        Self { everywhere: true, ..self.clone() }
    }

    /// Removes the definitions of macros from a text and stores them. Returns the remaining text.
    pub fn take_macro_definitions(&mut self, text: &TracedText) -> TracedText {
        let mut rest = TracedText::default();
        let (mut at, mut from) = (0, 0);
        while let Some(found) = text.text[at..].find('\\') {
            at += found;
            let name = command_at(&text.text, at);
            let Some(found) = self.definition(text, at, name) else {
                at += 1 + name.len().max(text.text[at + 1..].chars().next().map_or(0, char::len_utf8));
                continue;
            };
            rest.push_part(text, from..at);
            (at, from) = (found.end, found.end);
            let list = self.known.entry(found.name).or_default();
            if name != "providecommand" || list.is_empty() {
                list.push(found.made);
            }
        }
        rest.push_part(text, from..text.text.len());
        rest
    }

    /// Reads the definition that begins at byte `at` with the command `name`; `None` if no definition begins there.
    fn definition(&self, text: &TracedText, at: usize, name: &str) -> Option<Definition> {
        let place = text.place_of_part(at..at + 1);
        let text = text.text.as_str();
        let mut at = at + 1 + name.len();
        if !matches!(name, "newcommand" | "renewcommand" | "providecommand" | "DeclareMathOperator" | "def" | "let") {
            return None;
        }
        at += usize::from(text[at..].starts_with('*'));
        at = skip_space(text, at);
        let braced = text[at..].starts_with('{');
        at = skip_space(text, at + usize::from(braced));
        let called = text[at..].starts_with('\\').then(|| command_at(text, at).to_owned())?;
        at += 1 + called.len();
        if braced {
            at = skip_space(text, at);
            at += text[at..].starts_with('}').then_some(1)?;
        }
        let mut made = Macro { from: place.start, body: None, arguments: 0, usual: None, is_odd: false };
        if name == "let" {
            at = skip_space(text, at);
            at = skip_space(text, at + usize::from(text[at..].starts_with('=')));
            let other = text[at..].starts_with('\\').then(|| command_at(text, at))?;
            let same = self.macro_at_place(other, place.start).cloned();
            let definition = Macro { from: place.start, ..same.unwrap_or(Macro { body: None, ..made }) };
            // If a macro is another name for a LaTeX command, the command itself is stored as its value.
            let definition = match definition.body {
                None => Macro { body: None, usual: Some(other.to_owned()), ..definition },
                Some(_) => definition,
            };
            return Some(Definition { name: called, made: definition, end: at + 1 + other.len() });
        }
        if name == "def" {
            let open = at + next_latex_mark_nearby(text, at, '{')?;
            let pattern: String = text[at..open].chars().filter(|c| !c.is_whitespace()).collect();
            made.arguments = pattern.matches('#').count();
            let plain: Vec<String> = (1..=made.arguments).map(|k| format!("#{k}")).collect();
            made.is_odd = pattern != plain.concat() || made.arguments > 9;
            at = open;
        } else if name != "DeclareMathOperator" {
            at = skip_space(text, at);
            let mut optional = 0;
            while text[at..].starts_with('[') {
                let close = at + next_latex_mark_nearby(text, at, ']')?;
                let inside = text[at + 1..close].trim();
                match (optional, inside.parse::<usize>()) {
                    (0, Ok(count)) if count <= 9 => made.arguments = count,
                    (1, _) => made.usual = Some(inside.to_owned()),
                    _ => made.is_odd = true,
                }
                optional += 1;
                at = skip_space(text, close + 1);
            }
        }
        at = skip_space(text, at);
        let end = text[at..].starts_with('{').then(|| group_end(text, at))??;
        let body = &text[at + 1..end - 1];
        made.is_odd |= body.len() > MAX_BODY;
        made.body = Some(match name {
            "DeclareMathOperator" => format!("\\operatorname{{{body}}}"),
            _ => body.to_owned(),
        });
        Some(Definition { name: called, made, end })
    }

    /// Definition of a macro that is valid at byte `at` of the file, which is the last one before it. `None` if there
    /// is none.
    fn macro_at_place(&self, name: &str, at: usize) -> Option<&Macro> {
        let list = self.known.get(name)?;
        let end = if self.everywhere { list.len() } else { list.partition_point(|made| made.from <= at) };
        list.get(end.checked_sub(1)?)
    }

    /// Names of the macros whose text contains one of the given commands, directly or through other macros.
    pub fn with_commands(&self, commands: &[&str]) -> FxHashSet<String> {
        let mut found: FxHashSet<String> = FxHashSet::default();
        for _ in 0..MAX_ROUNDS {
            let before = found.len();
            let mut new = Vec::new();
            for (name, list) in &self.known {
                let calls = |body: &str| {
                    body.match_indices('\\').any(|(at, _)| {
                        let called = command_at(body, at);
                        commands.contains(&called) || found.contains(called)
                    })
                };
                if !found.contains(name) && list.iter().any(|made| made.body.as_deref().is_some_and(calls)) {
                    new.push(name.clone());
                }
            }
            found.extend(new);
            if found.len() == before {
                break;
            }
        }
        found
    }

    /// Replaces, in a text, the macros whose names are accepted by `wanted`. The error is a call that cannot be
    /// replaced.
    pub fn expand_macros(&self, text: &TracedText, wanted: &dyn Fn(&str) -> bool) -> Result<TracedText, TracedError> {
        let work = Expansion { macros: self, out: TracedText::default(), stack: Vec::new(), calls: 0, added: 0 };
        work.expand_text(text, wanted)
    }
}

/// State of the replacement of macros in a LaTeX text.
struct Expansion<'a> {
    /// Definitions of the macros that may be replaced.
    macros: &'a Macros,
    /// Output: the text written so far, with macros replaced.
    out: TracedText,
    /// Texts that are being read, the innermost last, each with the position of its next byte.
    stack: Vec<(TracedText, usize)>,
    /// Number of macro calls replaced so far, to limit the work.
    calls: usize,
    /// Number of bytes that macros have added so far, to limit the work.
    added: usize,
}

impl Expansion<'_> {
    /// Reads a text to its end, and returns it with the wanted macros replaced. The error is a call that cannot be
    /// replaced.
    fn expand_text(mut self, text: &TracedText, wanted: &dyn Fn(&str) -> bool) -> Result<TracedText, TracedError> {
        self.stack.push((text.clone(), 0));
        while let Some((text, at)) = self.stack.last_mut() {
            let Some(c) = text.text[*at..].chars().next() else {
                self.stack.pop();
                self.end_word();
                continue;
            };
            if c != '\\' {
                self.out.push_part(text, *at..*at + c.len_utf8());
                *at += c.len_utf8();
                continue;
            }
            let name = command_at(&text.text, *at).to_owned();
            let range = *at..*at + 1 + name.len();
            *at = range.end;
            let place = text.place_of_part(range.clone());
            let made = self.macros.macro_at_place(&name, place.start).filter(|_| wanted(&name));
            let Some(made) = made else {
                let part = text.part_with_places(range.clone());
                self.out.push_part(&part, 0..range.len());
                continue;
            };
            self.expand_macro_call(&name, made.clone(), &place)?;
        }
        Ok(self.out)
    }

    /// Adds a space if the written text ends with a command, so that the first letter of the next text does not extend
    /// the command's name.
    fn end_word(&mut self) {
        let letters = self.out.text.trim_end_matches(|c: char| c.is_ascii_alphabetic());
        if letters.len() < self.out.text.len() && letters.ends_with('\\') {
            let place = self.out.place_of_part(self.out.text.len()..self.out.text.len());
            self.out.push_with_place(" ", &place);
        }
    }

    /// Replaces one call of a macro: reads its arguments, and puts the macro's text before the rest of the input. The
    /// error is a missing argument, an unsupported definition, or a text that gets too long.
    fn expand_macro_call(&mut self, name: &str, made: Macro, place: &Range<usize>) -> Result<(), TracedError> {
        let shown_name = shortened_for_message(name);
        let Some(body) = made.body else {
            self.out.push_with_place(&format!("\\{}", made.usual.unwrap_or_default()), place);
            self.end_word();
            return Ok(());
        };
        if made.is_odd {
            let message = format!("the macro `\\{shown_name}` has a form that is not read");
            return Err(TracedError::new(
                place.clone(),
                message,
                "define it by \\newcommand, with at most nine arguments",
            ));
        }
        self.calls += 1;
        let mut arguments = Vec::new();
        for at in 0..made.arguments {
            let usual = made.usual.as_ref().filter(|_| at == 0);
            let argument = match usual {
                Some(usual) => self.optional_macro_argument().unwrap_or_else(|| TracedText::from_place(usual, place)),
                None => self.next_macro_argument().ok_or_else(|| {
                    let message = format!("the macro `\\{shown_name}` needs its argument {}", at + 1);
                    TracedError::new(place.clone(), message, "write each argument in braces")
                })?,
            };
            arguments.push(argument);
        }
        let mut text = TracedText::default();
        let mut rest = body.as_str();
        while let Some(mark) = rest.find('#') {
            text.push_with_place(&rest[..mark], place);
            let number = rest[mark + 1..].chars().next().and_then(|c| c.to_digit(10)).unwrap_or(0) as usize;
            let Some(argument) = number.checked_sub(1).and_then(|at| arguments.get(at)) else {
                let message = format!("the macro `\\{shown_name}` names an argument that it does not have");
                return Err(TracedError::new(place.clone(), message, "name its arguments #1, #2, …"));
            };
            text.push_part(argument, 0..argument.text.len());
            rest = &rest[mark + 2..];
            if self.added + text.text.len() > MAX_ADDED {
                break;
            }
        }
        text.push_with_place(rest, place);
        self.added += text.text.len();
        self.stack.retain(|(text, at)| *at < text.text.len());
        if self.calls > MAX_CALLS || self.added > MAX_ADDED || self.stack.len() > MAX_NESTING {
            let message = format!("the macros make this text too long: `\\{shown_name}` may call itself");
            return Err(TracedError::new(place.clone(), message, "write the formula without this macro"));
        }
        self.end_word();
        self.stack.push((text, 0));
        Ok(())
    }

    /// Reads the next argument: a group without its braces, a command, or a single character. `None` if there is none.
    fn next_macro_argument(&mut self) -> Option<TracedText> {
        loop {
            let (text, at) = self.stack.last_mut()?;
            *at = skip_space(&text.text, *at);
            let rest = &text.text[*at..];
            let Some(c) = rest.chars().next() else {
                self.stack.pop();
                continue;
            };
            let (inside, end) = match c {
                '{' => {
                    let end = group_end(&text.text, *at)?;
                    (*at + 1..end - 1, end)
                }
                '}' => return None,
                '\\' => {
                    let end = *at + 1 + command_at(&text.text, *at).len();
                    (*at..end, end)
                }
                _ => (*at..*at + c.len_utf8(), *at + c.len_utf8()),
            };
            *at = end;
            return Some(text.part_with_places(inside));
        }
    }

    /// Reads an optional argument in brackets, without the brackets; `None` if there is none.
    fn optional_macro_argument(&mut self) -> Option<TracedText> {
        let (text, at) = self.stack.last_mut()?;
        let open = skip_space(&text.text, *at);
        let close = text.text[open..].starts_with('[').then(|| next_latex_mark_nearby(&text.text, open, ']'))??;
        *at = open + close + 1;
        Some(text.part_with_places(open + 1..open + close))
    }
}
