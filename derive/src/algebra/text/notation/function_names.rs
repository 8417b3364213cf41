//! Tables of names of functions and constants in LaTeX and in programs, with their names in model
//! files.

use super::kind::Notation;
use crate::algebra::text::parse::is_reserved_by_parser;

/// LaTeX commands that are functions, each with its name in model files.
const LATEX: [(&str, &str); 17] = [
    ("sin", "sin"),
    ("cos", "cos"),
    ("tan", "tan"),
    ("sec", "sec"),
    ("csc", "csc"),
    ("cot", "cot"),
    ("sinh", "sinh"),
    ("cosh", "cosh"),
    ("tanh", "tanh"),
    ("arcsin", "asin"),
    ("arccos", "acos"),
    ("arctan", "atan"),
    ("exp", "exp"),
    ("ln", "log"),
    ("log", "log"),
    ("min", "min"),
    ("max", "max"),
];

/// LaTeX commands that are letters: Greek letters and letter-like symbols.
const LETTERS: [&str; 43] = [
    "alpha",
    "beta",
    "gamma",
    "delta",
    "epsilon",
    "varepsilon",
    "zeta",
    "eta",
    "theta",
    "vartheta",
    "iota",
    "kappa",
    "varkappa",
    "lambda",
    "mu",
    "nu",
    "xi",
    "pi",
    "varpi",
    "rho",
    "varrho",
    "sigma",
    "varsigma",
    "tau",
    "upsilon",
    "phi",
    "varphi",
    "chi",
    "psi",
    "omega",
    "Gamma",
    "Delta",
    "Theta",
    "Lambda",
    "Xi",
    "Pi",
    "Sigma",
    "Upsilon",
    "Phi",
    "Psi",
    "Omega",
    "ell",
    "hbar",
];

/// Functions of programs that have another name in model files, as pairs (name in programs, name in
/// model files).
const RENAMED: [(&str, &str); 13] = [
    ("fabs", "abs"),
    ("Abs", "abs"),
    ("fmin", "min"),
    ("fmax", "max"),
    ("Min", "min"),
    ("Max", "max"),
    ("arcsin", "asin"),
    ("arccos", "acos"),
    ("arctan", "atan"),
    ("arctan2", "atan2"),
    ("ln", "log"),
    ("sgn", "sign"),
    ("minimum", "min"),
];

/// Modules and namespaces that may precede a function in programs, as in `np.sin`.
const MODULES: [&str; 15] =
    ["sp", "sympy", "sm", "np", "numpy", "math", "std", "me", "ca", "casadi", "cs", "jnp", "jax", "torch", "xp"];

/// Name in model files of the function that a LaTeX command stands for; `None` if the command is
/// not a function.
pub(super) fn function_name_of_latex(command: &str) -> Option<&'static str> {
    LATEX.iter().find(|(name, _)| *name == command).map(|(_, function)| *function)
}

/// True if a LaTeX command is a letter, such as `theta`.
pub(super) fn is_letter(command: &str) -> bool {
    LETTERS.contains(&command)
}

/// Name in model files of the function that a word stands for, in a program or in roman type of
/// LaTeX. `None` if the word is not a function.
pub(super) fn function(word: &str) -> Option<&str> {
    let renamed = RENAMED.iter().find(|(name, _)| *name == word).map_or(word, |(_, function)| *function);
    let is_function = is_reserved_by_parser(renamed) && renamed != "pi";
    (is_function || ["min", "max", "atan2"].contains(&renamed)).then_some(renamed)
}

/// Name in model files of a C function. The word may end in `f` or `l` for its precision, as in
/// `cosf`. `None` if the word is not a function.
pub(super) fn function_of_c(word: &str) -> Option<&str> {
    function(word).or_else(|| word.strip_suffix(['f', 'l']).and_then(function))
}

/// Removes a known module or namespace in front of a word: `np.sin` becomes `sin`.
pub(super) fn name_without_module(word: &str) -> &str {
    let split = word.split_once("::").or_else(|| word.split_once('.'));
    split.filter(|(module, _)| MODULES.contains(module)).map_or(word, |(_, name)| name)
}

/// Tokens, in the language of model files, for a constant of a program such as `M_PI_2`. `None` if
/// the word is not a constant.
pub(super) fn constant(word: &str, notation: Notation) -> Option<&'static [&'static str]> {
    match (word, notation) {
        ("pi", Notation::Python | Notation::Matlab) | ("M_PI", Notation::C) => Some(&["pi"]),
        ("M_PI_2", Notation::C) => Some(&["(", "pi", "/", "2", ")"]),
        ("M_PI_4", Notation::C) => Some(&["(", "pi", "/", "4", ")"]),
        _ => None,
    }
}
