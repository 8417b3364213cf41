//! Checks of refusals: place, message and hint.

use crate::campaign::last_tried;
use std::ops::Range;
use tripos_derive::diagnostic::Diagnostics;
use tripos_derive::plain_text::is_forbidden;

/// Parts of messages that only a mistake of the program leaves there.
const DEBRIS: [&str; 16] = [
    "Some(", "None", "Err(", "Ok(", "Expr(", "::", "{}", "{:?}", "panicked", "unwrap", "RUST_", "  ", "\\\"", " ,",
    "\u{fffd}", "``",
];

/// Characters of the longest message or hint. A list of 40 known names is shorter.
const LONGEST: usize = 1500;

/// Panics with a defect: `kind` says what is wrong, and `detail` is the text that is wrong.
fn defect(kind: &str, detail: &str) -> ! {
    panic!("{kind} | {detail}")
}

/// Checks one text of a refusal. `input` is the text that was refused, parts of which the message may repeat.
pub fn check_text(role: &str, text: &str, input: &str) {
    if text.trim().is_empty() {
        defect(&format!("the {role} is empty"), text);
    }
    if let Some(c) = text.chars().find(|c| is_forbidden(*c)) {
        defect(&format!("the {role} has a forbidden character {c:?}"), text);
    }
    if text.chars().count() > LONGEST {
        defect(&format!("the {role} has more than {LONGEST} characters"), text);
    }
    let has_ticks = input.contains('`');
    if let Some(debris) = DEBRIS
        .iter()
        .filter(|debris| !(has_ticks && debris.contains('`')))
        .find(|debris| text.contains(**debris) && !input.contains(**debris))
    {
        defect(&format!("the {role} has debris {debris:?}"), text);
    }
}

/// Checks that a place lies inside a text.
pub fn check_place(place: &Range<usize>, text: &str, message: &str) {
    if place.start > place.end || place.end > text.len() {
        defect("a place outside the text", &format!("{place:?} of {}: {message}", text.len()));
    }
    if !text.is_char_boundary(place.start) || !text.is_char_boundary(place.end) {
        defect("a place inside a character", &format!("{place:?}: {message}"));
    }
}

/// Checks all errors of a file. Each has a message in one line, a hint, and a place inside its file; or it concerns the
/// file as a whole, which `is_of_file` permits for its message.
pub fn check_errors(errors: &Diagnostics, is_of_file: &dyn Fn(&str) -> bool) {
    if errors.list.is_empty() {
        defect("a refusal without a reason", "");
    }
    for error in &errors.list {
        // A message may quote another file than that of its place, such as a table.
        let text = &errors.file(error).text;
        let input = format!("{text}\n{}", last_tried());
        check_text("message", &error.message, &input);
        match &error.help {
            Some(help) => check_text("hint", help, &input),
            None => defect("a refusal without a hint", &error.message),
        }
        match &error.span {
            Some(place) => check_place(place, text, &error.message),
            None if is_of_file(&error.message) => {}
            None => defect("a refusal without a place", &error.message),
        }
        if let Some((place, label)) = &error.other {
            check_place(place, text, label);
            check_text("label", label, &input);
        }
    }
    let shown = errors.to_string();
    if let Some(c) = shown.chars().find(|c| *c != '\n' && is_forbidden(*c)) {
        defect(&format!("the shown refusal has a forbidden character {c:?}"), &shown);
    }
}
