//! Words that no variable of JavaScript can have.

use crate::plan::Language;

/// JavaScript modules, with the names that generated functions use for other things.
pub const LANGUAGE: Language = Language { is_name, in_scope: &IN_SCOPE };

/// Names in scope of the bodies of generated functions. What they call beside them has a `$` in its name, which no
/// model has.
const IN_SCOPE: [&str; 14] =
    ["p", "q", "u", "q_dot", "v_dot", "r", "t", "out", "values", "Math", "NaN", "Infinity", "undefined", "globalThis"];

/// Words of the language, in modules, whose code is strict.
const WORDS: [&str; 49] = [
    "arguments",
    "async",
    "await",
    "break",
    "case",
    "catch",
    "class",
    "const",
    "continue",
    "debugger",
    "default",
    "delete",
    "do",
    "else",
    "enum",
    "eval",
    "export",
    "extends",
    "false",
    "finally",
    "for",
    "function",
    "if",
    "implements",
    "import",
    "in",
    "instanceof",
    "interface",
    "let",
    "new",
    "null",
    "package",
    "private",
    "protected",
    "public",
    "return",
    "static",
    "super",
    "switch",
    "this",
    "throw",
    "true",
    "try",
    "typeof",
    "var",
    "void",
    "while",
    "with",
    "yield",
];

/// True if a word of letters, digits and underscores may be the name of a variable.
#[must_use]
pub fn is_name(word: &str) -> bool {
    let opens = |c: char| c.is_ascii_alphabetic() || c == '_';
    word.chars().next().is_some_and(opens)
        && word.chars().all(|c| c.is_ascii_alphanumeric() || c == '_')
        && !WORDS.contains(&word)
}
