//! Random formulas from the grammars of the notations.

use crate::campaign::Random;
use tripos_derive::algebra::text::notation::Notation;

/// Names of variables in the notations of programs and models.
const NAMES: [&str; 14] = ["q1", "q2", "u1", "x", "theta", "m", "l", "I_x", "omega", "g", "t", "m_1", "k", "alpha"];
/// Symbols of LaTeX formulas.
const SYMBOLS: [&str; 22] = [
    "q_1",
    "q_{2}",
    "\\dot{q}_1",
    "\\ddot{\\theta}",
    "\\theta",
    "x",
    "m",
    "l",
    "I_{xx}",
    "\\omega",
    "g",
    "m_{1}",
    "\\alpha",
    "\\mathbf{F}",
    "I^B",
    "F^*",
    "\\dot q_1",
    "\\mathrm{m}",
    "\\varphi_{12}",
    "a'",
    "\\bar{x}",
    "\\pi",
];
/// Functions of one argument in programs and models.
const FUNCTIONS: [&str; 12] =
    ["sin", "cos", "tan", "sqrt", "exp", "log", "abs", "sign", "asin", "acos", "atan", "tanh"];

/// A number as people write it.
fn number(random: &mut Random) -> String {
    match random.below(12) {
        0 => "0".to_owned(),
        1 => format!("{}", random.decimal(0.0, 20.0)),
        2 => format!("{}e{}", random.below(100), random.below(20)),
        3 => format!("{}e-{}", random.below(100), random.below(20)),
        4 => format!("{}.", random.below(30)),
        5 => format!(".{}", random.below(30)),
        _ => random.below(12).to_string(),
    }
}

/// A random formula in a notation, with at most `depth` levels of operations.
pub fn formula(notation: Notation, depth: usize, random: &mut Random) -> String {
    match notation {
        Notation::Latex => latex(depth, random),
        _ => program(notation, depth, random),
    }
}

/// A variable in the notation of a program or model.
fn variable(notation: Notation, random: &mut Random) -> String {
    let name = *random.one(&NAMES);
    match (notation, random.below(12)) {
        (Notation::Tripos, 0) => format!("{name}'"),
        (Notation::Tripos, 1) => format!("v(P) @ A [{}]", random.below(5)),
        (Notation::Tripos, 2) => format!("force(A on B) @ N [{}]", random.below(4)),
        (Notation::Matlab, 0) => format!("z({})", random.below(9)),
        (Notation::Matlab, 1) => format!("p.{name}"),
        (Notation::Python | Notation::C, 0) => format!("x[{}]", random.below(9)),
        (Notation::Python, 1) => format!("p['{name}']"),
        (Notation::Python, 2) => format!("Derivative({name}, t)"),
        (Notation::Python, 3) => format!("{name}.diff(t)"),
        (Notation::C, 1) => format!("p->{name}"),
        _ => name.to_owned(),
    }
}

/// A random formula in the notation of a program or model.
fn program(notation: Notation, depth: usize, random: &mut Random) -> String {
    if depth == 0 || random.chance(15) {
        return if random.chance(40) { number(random) } else { variable(notation, random) };
    }
    let mut inner = |less: usize| program(notation, depth - less.min(depth), random);
    let (a, b) = (inner(1), inner(1));
    let space = if random.chance(50) { " " } else { "" };
    match random.below(13) {
        0 | 1 => format!("{a}{space}+{space}{b}"),
        2 | 3 => format!("{a}{space}-{space}{b}"),
        4 | 5 => format!("{a}{space}*{space}{b}"),
        6 => format!("{a}{space}/{space}({b})"),
        7 => format!("({a})"),
        8 => format!("-{a}"),
        9 => {
            let power = ["2", "3", "-1", "-2", "0", "(1/2)", "0.5", "10"][random.below(8)];
            match notation {
                Notation::Python => format!("({a})**{power}"),
                Notation::C => format!("pow({a}, {power})"),
                _ => format!("({a})^{power}"),
            }
        }
        10 => {
            let module = match notation {
                Notation::Python => ["", "np.", "math.", "sp.", "ca."][random.below(5)],
                Notation::C => ["", "std::", "f"][random.below(3)],
                _ => "",
            };
            format!("{module}{}({a})", random.one(&FUNCTIONS))
        }
        11 => format!("{}({a},{space}{b})", random.one(&["min", "max", "atan2", "pow", "power", "hypot"])),
        _ => format!("({a}){space}*{space}({b})"),
    }
}

/// A random formula in LaTeX.
fn latex(depth: usize, random: &mut Random) -> String {
    if depth == 0 || random.chance(15) {
        return if random.chance(30) { number(random) } else { (*random.one(&SYMBOLS)).to_owned() };
    }
    let (a, b) = (latex(depth - 1, random), latex(depth - 1, random));
    match random.below(18) {
        0 | 1 => format!("{a} + {b}"),
        2 => format!("{a} - {b}"),
        3 | 4 => format!("{a} {b}"),
        5 => format!("{a} \\cdot {b}"),
        6 | 7 => format!("\\frac{{{a}}}{{{b}}}"),
        8 => format!("\\left({a}\\right)"),
        9 => format!("({a})^{{{}}}", ["2", "-1", "\\frac{1}{2}", "3"][random.below(4)]),
        10 => format!("\\{} {a}", random.one(&["sin", "cos", "tan", "ln", "exp", "arctan"])),
        11 => format!("\\{}\\left({a}\\right)", random.one(&["sin", "cos", "tan", "ln", "exp", "arctan"])),
        12 => format!("\\sqrt{{{a}}}"),
        13 => format!("\\{}^2 {a}", random.one(&["sin", "cos"])),
        14 => format!("-{a}"),
        15 => format!("\\left[{a}\\right]"),
        16 => format!("\\frac{{d}}{{dt}}\\left({a}\\right)"),
        _ => format!("{{{a}}}\\,{b}"),
    }
}
