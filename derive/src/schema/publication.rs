//! Schema of publication files, which state a printed derivation: their keys, with kinds of values and descriptions.

use super::Kind::{Either, Formula, List, Named, Table, Text, Whole, Word};
use super::{Key, Kind, VERSION, optional_key, required_key};

/// Value that is a list of formulas.
const FORMULAS: Kind = List(&Formula);
/// Value that is a matrix of formulas: a list of rows.
const MATRIX: Kind = List(&FORMULAS);
/// Key `id` of an entry: a name that is unique in the file.
const ID: Key = required_key("id", Text, "unique in the file, the equation number first, as in 2.11-a1");
/// Key `section` of an entry: its place in the publication.
const SECTION: Key = required_key("section", Text, "where it is printed");
/// Key `repaired` of an entry whose print is garbled: a remark on the print and its reading.
const REPAIRED: Key = optional_key("repaired", Text, "remark on garbled print, and on its reading here");
/// Key `note` of an entry: a remark.
const NOTE: Key = optional_key("note", Text, "a remark");
/// Formulations with which printed equations can be compared.
const FORMULATIONS: &[&str] = &["kane", "lagrange", "newton-euler"];
/// Required key `formulation` of an entry: the formulation with which the printed equations are compared.
const FORMULATION: Key = required_key("formulation", Word(FORMULATIONS), "what it is compared with");

/// Key `notation` of an entry: the language of its printed formulas.
const NOTATION: Key = optional_key(
    "notation",
    Word(&["tripos", "latex", "python", "sympy", "matlab", "c"]),
    "notation of the formulas; by default tripos, the language of model files",
);

/// Key `about` of an entry: the point near which its printed formulas hold.
const ABOUT: Key = optional_key(
    "about",
    Named(&Formula),
    "the point near which formulas hold, as { q1 = 0, u3 = \"w\" }; {} for everywhere",
);
/// Key `small` of an entry: the parameters in which its printed formulas are expanded.
const SMALL: Key = optional_key("small", List(&Text), "parameters near 0, up to the order, as [\"epsilon\"]");
/// Key `order` of an entry: the order of its expansion about a point.
const ORDER: Key = optional_key("order", Whole(1), "order in the deviations from that point; by default 1");

/// Key `file` of an entry: a LaTeX file or a program beside the publication file.
const FILE: Key =
    optional_key("file", Text, "a file beside this one: paper.tex, or a program such as model.m, model.py, model.c");
/// Key `part` of an entry: the part of the program from which it is taken.
const PART: Key = optional_key(
    "part",
    Text,
    "part of a program: a function, lines such as 12-40, or the NAME in `begin NAME` and `end NAME`",
);
/// Key `label` of an entry: the label of an equation in the LaTeX file.
const LABEL: Key = optional_key("label", Text, "label of an equation of the file, in place of `printed`");
/// Key `line` of an entry: the number of a line in an equation with several lines.
const LINE: Key = optional_key("line", Whole(1), "which equation of the label, from 1");

/// Builds the list of keys of an entry with formulas: the keys that all such entries accept, then the entry's own
/// keys.
macro_rules! of_formulas {
    ($($own:expr),* $(,)?) => {
        &[ID, SECTION, REPAIRED, NOTE, NOTATION, FILE, PART, ABOUT, SMALL, ORDER, $($own),*]
    };
}

/// Keys of a publication file at its top level.
pub(crate) const KEYS: &[Key] = &[
    VERSION,
    optional_key("title", Text, "the title of the publication"),
    optional_key("source", Text, "where it is from"),
    optional_key(
        "file",
        Text,
        "file of the labels and parts in entries without a file; its macros hold for all formulas",
    ),
    optional_key("macros", Text, "definitions of macros, such as \\newcommand{\\w}{\\omega}"),
    NOTATION,
    ABOUT,
    SMALL,
    ORDER,
    optional_key("symbols", Named(&Text), "symbols of the text, each with its name in the model"),
    optional_key(
        "coordinates",
        Named(&Formula),
        "coordinates and speeds of the text, as formulas in those of the model",
    ),
    optional_key("abbreviations", Named(&Either(&[Formula, Table(DEFINED)])), "shorthand of the text"),
    optional_key("names", Named(&Text), "symbols of the text that stand for derived quantities"),
    optional_key("equation", List(&Table(EQUATION)), "printed values of named quantities"),
    optional_key("matrix", List(&Table(WHOLE_MATRIX)), "printed matrices and vectors as a whole"),
    optional_key("definition", List(&Table(DEFINITION)), "what nothing can contradict"),
    optional_key("system", List(&Table(SYSTEM)), "linear systems: matrix · unknowns = right"),
    optional_key("listing", List(&Table(LISTING)), "programs that compute the derivative of a state"),
    optional_key("initial", List(&Table(INITIAL)), "numbers: parameters, or values at the start"),
];

/// Keys of an abbreviation that an equation of the author's file defines.
const DEFINED: &[Key] = &[required_key("label", Text, "label of the equation of the file that defines it")];

/// Keys of an entry `equation`: a printed formula of a quantity, or an equation of motion.
const EQUATION: &[Key] = of_formulas![
    optional_key("quantity", Text, "derived quantity, such as v(P) @ A [1]; left out for an equation of motion"),
    optional_key("printed", Formula, "formula as printed, or the name of a variable of the program"),
    LABEL,
    LINE,
    optional_key("formulation", Word(FORMULATIONS), "formulation that an equation of motion is compared with"),
    optional_key("frame", Text, "the frame of the components of a Newton-Euler equation"),
];

/// Keys of an entry `matrix`: a matrix printed as a whole.
const WHOLE_MATRIX: &[Key] = of_formulas![
    required_key("quantity", Text, "matrix quantity without its indices, such as M or I(disk) @ B"),
    optional_key("printed", Text, "the whole matrix, as in [a, b; c, d]"),
    LABEL,
    LINE,
    optional_key("claims", List(&Text), "claims on C: christoffel, skew-symmetric"),
];

/// Keys of an entry `definition`, which is not compared with the derivation.
const DEFINITION: &[Key] = &[ID, SECTION, REPAIRED, NOTE, required_key("printed", Text, "as it is printed")];

/// Keys of an entry `system`: a printed linear system.
const SYSTEM: &[Key] = of_formulas![
    FORMULATION,
    optional_key("frame", Text, "the frame of the components of a Newton-Euler system"),
    optional_key("equations", FORMULAS, "rows of the system as equations, in place of unknowns, matrix and right"),
    optional_key("label", Text, "label of an environment of the file whose equations are the rows"),
    optional_key("labels", List(&Text), "labels of equations of the file that are the rows"),
    optional_key("unknowns", List(&Text), "what it is solved for"),
    optional_key("matrix", MATRIX, "its rows"),
    optional_key("right", FORMULAS, "the right-hand side"),
    optional_key("matrix_ids", Text, "ids of single entries, with {i} and {j}"),
    optional_key("right_ids", Text, "ids of single entries, with {i}"),
];

/// Keys of an entry `listing`: a program that computes the derivative of a state.
const LISTING: &[Key] = of_formulas![
    FORMULATION,
    required_key("state", List(&Text), "what is integrated"),
    required_key("derivative", FORMULAS, "its derivative as assigned"),
    optional_key("matrix", MATRIX, "E of dz = E \\ dz for the speeds"),
];

/// Keys of an entry `initial`: a printed number for a parameter or for a start.
const INITIAL: &[Key] = &[
    ID,
    SECTION,
    REPAIRED,
    NOTE,
    NOTATION,
    required_key("set", Text, "values of one set belong together"),
    required_key("quantity", Text, "a parameter, q1, q1' or u1"),
    required_key("printed", Formula, "as it is printed"),
];
