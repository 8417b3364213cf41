//! Names of JavaScript variables: reserved words and names that generated code cannot use.

use crate::plan::Language;

/// Rules for names of JavaScript variables: reserved words, and names that generated functions use
/// for other purposes.
pub const LANGUAGE: Language = Language { is_name, in_scope: &IN_SCOPE, longest: usize::MAX };

/// Names in the scope of generated function bodies, which no variable may have. Functions that are called need no
/// entry: their names contain a `$`, which no name of a model contains.
const IN_SCOPE: [&str; 14] =
    ["p", "q", "u", "q_dot", "v_dot", "r", "t", "out", "values", "Math", "NaN", "Infinity", "undefined", "globalThis"];

/// Reserved words of JavaScript in modules, which cannot name variables.
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

/// True if a word may be the name of a JavaScript variable in generated code: letters, digits and underscores, no
/// reserved word.
#[must_use]
pub fn is_name(word: &str) -> bool {
    let opens = |c: char| c.is_ascii_alphabetic() || c == '_';
    word.chars().next().is_some_and(opens)
        && word.chars().all(|c| c.is_ascii_alphanumeric() || c == '_')
        && !WORDS.contains(&word)
}
