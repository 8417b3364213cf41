//! Names of MATLAB variables: reserved words and names that generated code cannot use.

use crate::plan::Language;

/// Rules for names of MATLAB and Octave variables in generated code. A name has at most 63 bytes.
pub const LANGUAGE: Language = Language { is_name, in_scope: &IN_SCOPE, longest: 63 };

/// Names that no variable may have: arguments, and functions that are called. A variable with the name of a function
/// would hide it.
const IN_SCOPE: [&str; 50] = [
    "p", "q", "u", "q_dot", "v_dot", "r", "t", "x", "out", "out_2", "N", "state", "pi", "NaN", "Inf", "i", "j", "e",
    "eps", "sin", "cos", "sqrt", "exp", "log", "asin", "acos", "atan", "sinh", "cosh", "tanh", "abs", "sign", "zeros",
    "size", "max", "assert", "reshape", "inf", "nan", "NA", "ans", "eye", "pinv", "norm", "blkdiag", "I", "J", "names",
    "units", "matrix",
];

/// Reserved words of MATLAB and Octave, which cannot name variables.
const WORDS: [&str; 51] = [
    "break",
    "case",
    "catch",
    "classdef",
    "continue",
    "do",
    "else",
    "elseif",
    "end",
    "end_try_catch",
    "end_unwind_protect",
    "endclassdef",
    "endenumeration",
    "endevents",
    "endfor",
    "endfunction",
    "endif",
    "endmethods",
    "endparfor",
    "endproperties",
    "endswitch",
    "endwhile",
    "enumeration",
    "events",
    "for",
    "function",
    "global",
    "if",
    "methods",
    "otherwise",
    "parfor",
    "persistent",
    "properties",
    "return",
    "spmd",
    "static",
    "switch",
    "try",
    "until",
    "unwind_protect",
    "unwind_protect_cleanup",
    "while",
    "arguments",
    "import",
    "endarguments",
    "endspmd",
    "function_handle",
    "true",
    "false",
    "varargin",
    "varargout",
];

/// True if a word may be the name of a MATLAB variable in generated code: letters, digits and underscores, with a
/// letter at the front.
#[must_use]
pub fn is_name(word: &str) -> bool {
    word.starts_with(|c: char| c.is_ascii_alphabetic())
        && word.chars().all(|c| c.is_ascii_alphanumeric() || c == '_')
        && word.len() <= 63
        && !WORDS.contains(&word)
}
