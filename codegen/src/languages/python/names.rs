//! Names of Python variables: reserved words and names that generated code cannot use.

use crate::plan::Language;

/// Rules for names of Python variables in generated code.
pub const LANGUAGE: Language = Language { is_name, in_scope: &IN_SCOPE, longest: usize::MAX };

/// Names that no variable may have: arguments, modules and working variables of generated functions.
const IN_SCOPE: [&str; 15] =
    ["p", "q", "u", "q_dot", "v_dot", "r", "t", "x", "xp", "shape", "first", "second", "numpy", "casadi", "_arrays"];

/// Reserved words of Python, and `print`.
const WORDS: [&str; 39] = [
    "False", "None", "True", "and", "as", "assert", "async", "await", "break", "case", "class", "continue", "def",
    "del", "elif", "else", "except", "finally", "for", "from", "global", "if", "import", "in", "is", "lambda", "match",
    "nonlocal", "not", "or", "pass", "raise", "return", "try", "type", "while", "with", "yield", "print",
];

/// True if a word may be the name of a Python variable in generated code: letters, digits and underscores, no
/// reserved word.
#[must_use]
pub fn is_name(word: &str) -> bool {
    word.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_')
        && word.chars().all(|c| c.is_ascii_alphanumeric() || c == '_')
        && !word.starts_with("__")
        && !WORDS.contains(&word)
}
