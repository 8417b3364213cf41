//! Linear system in the notation of Python, MATLAB or LaTeX.
//!
//! Numbers have all their digits in programs, and six digits in LaTeX. If parameters remain symbols, the matrices are
//! functions of them.

use super::{eigenvalue_text, linearised_mode_states, motion_kind_words, names};
use crate::arguments::Notation;
use std::fmt::Write;
use tripos::Mechanism;
use tripos::studies::steady::{SteadyLinearSystem, SymbolicEntry, SymbolicLinearForm, WideMatrix};
use tripos_derive::algebra::Arena;
use tripos_derive::algebra::text::parse::parse_free;
use tripos_derive::algebra::text::print::{latex, latex_of, python_of};

/// Matrices of a linear system, each entry as text in a notation.
struct Written {
    /// Entries of the matrices A, B, C and D, row by row.
    matrices: [Vec<Vec<String>>; 4],
    /// Numbers of columns of A, B, C and D. They are needed for matrices without rows.
    widths: [usize; 4],
    /// Names of the parameters that remain symbols; empty if the matrices are numbers.
    letters: Vec<String>,
}

/// Returns a linear system as text in a notation. `letters` are the matrices with symbolic parameters, if there are
/// any.
pub fn written(
    model: &Mechanism,
    found: &SteadyLinearSystem,
    letters: Option<&SymbolicLinearForm>,
    notation: Notation,
) -> String {
    let (states, system) = (names(found, &found.system.kept), &found.system);
    let widths = [states.len(), found.inputs.len(), states.len(), found.inputs.len()];
    let numbers = || [&system.a, &system.b, &system.c, &system.d].map(|wide| numeric_entries(wide, notation));
    let in_letters = |letters: &SymbolicLinearForm| [0, 1, 2, 3].map(|at| symbolic_entries(letters, at, notation));
    let named = letters.map_or_else(Vec::new, |letters| letters.names.clone());
    let matrices = letters.map_or_else(numbers, in_letters);
    let written = Written { matrices, widths, letters: named };
    match notation {
        Notation::Python => {
            written.python(&linear_system_comment(model, found, "#"), [&states, &found.inputs, &found.outputs])
        }
        Notation::Matlab => {
            written.matlab(&linear_system_comment(model, found, "%"), [&states, &found.inputs, &found.outputs])
        }
        Notation::Latex | Notation::Text => {
            written.latex(&linear_system_comment(model, found, "%"), [&states, &found.inputs, &found.outputs])
        }
    }
}

/// Returns the comment lines at the beginning: the state, and the eigenvalues with the states that take part in their
/// modes. `mark` begins a comment line.
fn linear_system_comment(model: &Mechanism, found: &SteadyLinearSystem, mark: &str) -> String {
    let mut out = format!("{mark} {}: near {}, in SI units\n", model.title, motion_kind_words(found));
    let at: Vec<String> = found.states().map(|(name, x)| format!("{name} = {x:?}")).collect();
    let _ = writeln!(out, "{mark} at {}", at.join(", "));
    for mode in found.modes.iter().filter(|mode| mode.value[1] >= 0.0) {
        let parts: Vec<String> =
            linearised_mode_states(found, mode).into_iter().take(4).map(|(name, _)| name).collect();
        let _ = writeln!(out, "{mark} eigenvalue {} 1/s: {}", eigenvalue_text(mode, 12), parts.join(", "));
    }
    out
}

/// Returns the entries of a numeric matrix as text.
fn numeric_entries(wide: &WideMatrix, notation: Notation) -> Vec<Vec<String>> {
    let number = |x: &f64| if notation == Notation::Latex { latex_number(*x) } else { format!("{x:?}") };
    wide.doubles().iter().map(|row| row.iter().map(number).collect()).collect()
}

/// Returns the entries of a matrix with symbolic parameters as text. The matrices A, B, C, D have the indices `at` from
/// 0 to 3.
fn symbolic_entries(letters: &SymbolicLinearForm, at: usize, notation: Notation) -> Vec<Vec<String>> {
    let letter = letters.names.first().map_or("", String::as_str);
    let entry = |e: &SymbolicEntry| match notation {
        Notation::Python => python_of(&e.view(letter, &|x| format!("{x:?}"))),
        Notation::Latex => latex_of(&e.view(letter, &latex_number)),
        Notation::Matlab | Notation::Text => e.text(letter),
    };
    letters.matrices[at].iter().map(|row| row.iter().map(entry).collect()).collect()
}

/// Returns a number in LaTeX with six significant digits, without trailing zeros. Very large and very small numbers get
/// a power of ten.
fn latex_number(x: f64) -> String {
    if x.abs() <= 0.0 {
        return "0".to_owned();
    }
    let text = format!("{x:.5e}");
    let (digits, power) = text.split_once('e').unwrap_or((&text, "0"));
    let power: i32 = power.parse().unwrap_or(0);
    if !(-4..6).contains(&power) {
        return format!("{} \\cdot 10^{{{power}}}", trim_zeros(digits));
    }
    let decimals = usize::try_from(5 - power).unwrap_or(0);
    trim_zeros(&format!("{x:.decimals$}"))
}

/// Removes trailing zeros from the decimals of a number.
fn trim_zeros(text: &str) -> String {
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text.to_owned() }
}

/// Names of the matrices of a linear system.
const NAMES: [&str; 4] = ["A", "B", "C", "D"];

impl Written {
    /// Returns the matrices as a Python program with NumPy.
    fn python(&self, head: &str, [states, inputs, outputs]: [&[String]; 3]) -> String {
        let list = |names: &[String]| names.iter().map(|name| format!("{name:?}")).collect::<Vec<_>>().join(", ");
        let mut out = format!("{head}import numpy as np\n\nstates = [{}]\n", list(states));
        let _ = writeln!(out, "inputs = [{}]\noutputs = [{}]", list(inputs), list(outputs));
        for (at, name) in NAMES.into_iter().enumerate() {
            let rows = &self.matrices[at];
            let value = if rows.is_empty() || self.widths[at] == 0 {
                format!("np.zeros(({}, {}))", rows.len(), self.widths[at])
            } else {
                let rows: Vec<String> = rows.iter().map(|row| format!("    [{}],\n", row.join(", "))).collect();
                format!("np.array([\n{}])", rows.concat())
            };
            let _ = if self.letters.is_empty() {
                writeln!(out, "\n{name} = {value}")
            } else {
                writeln!(out, "\ndef {name}({}):\n    return {value}", self.letters.join(", "))
            };
        }
        out
    }

    /// Returns the matrices as a MATLAB program.
    fn matlab(&self, head: &str, [states, inputs, outputs]: [&[String]; 3]) -> String {
        let list = |names: &[String]| names.iter().map(|name| format!("'{name}'")).collect::<Vec<_>>().join(", ");
        let mut out = format!("{head}states = {{{}}};\n", list(states));
        let _ = writeln!(out, "inputs = {{{}}};\noutputs = {{{}}};", list(inputs), list(outputs));
        let of = if self.letters.is_empty() { String::new() } else { format!("@({}) ", self.letters.join(", ")) };
        for (at, name) in NAMES.into_iter().enumerate() {
            let rows = &self.matrices[at];
            let value = if rows.is_empty() || self.widths[at] == 0 {
                format!("zeros({}, {})", rows.len(), self.widths[at])
            } else {
                format!("[{}]", rows.iter().map(|row| row.join(", ")).collect::<Vec<_>>().join("; ...\n     "))
            };
            let _ = writeln!(out, "{name} = {of}{value};");
        }
        if self.letters.is_empty() && !inputs.is_empty() && !outputs.is_empty() {
            out += "% with the Control System Toolbox:\n% sys = ss(A, B, C, D, 'StateName', states, 'InputName', inputs, 'OutputName', outputs);\n";
        }
        out
    }

    /// Returns the matrices in LaTeX with amsmath.
    fn latex(&self, head: &str, [states, inputs, outputs]: [&[String]; 3]) -> String {
        let column = |names: &[String]| {
            let names: Vec<String> = names.iter().map(|name| latex_notation_name(name)).collect();
            format!("\\begin{{pmatrix}} {} \\end{{pmatrix}}", names.join(" \\\\ "))
        };
        let mut out = head.to_owned();
        let _ = writeln!(out, "% six significant digits; needs amsmath");
        let mut symbols = vec![format!("x = {}", column(states))];
        if !inputs.is_empty() {
            symbols.push(format!("u = {}", column(inputs)));
        }
        if !outputs.is_empty() {
            symbols.push(format!("y = {}", column(outputs)));
        }
        let (by_inputs, through) = if inputs.is_empty() { ("", "") } else { (" + B u", " + D u") };
        let shown = if outputs.is_empty() { String::new() } else { format!(", \\qquad y = C x{through}") };
        let _ = writeln!(out, "\\[ \\dot x = A x{by_inputs}{shown} \\]\n\\[ {} \\]", symbols.join(", \\quad "));
        for (at, name) in NAMES.into_iter().enumerate() {
            let rows = &self.matrices[at];
            if rows.is_empty() || self.widths[at] == 0 {
                continue;
            }
            let rows: Vec<String> = rows.iter().map(|row| row.join(" & ")).collect();
            let most = self.widths[at];
            // Matrices of amsmath have up to ten columns unless a larger number is set.
            if most > 10 {
                let _ = writeln!(out, "\\setcounter{{MaxMatrixCols}}{{{most}}}");
            }
            let _ =
                writeln!(out, "\\[ {name} = \\begin{{pmatrix}}\n  {}\n\\end{{pmatrix}} \\]", rows.join(" \\\\\n  "));
        }
        out
    }
}

/// Returns the name of a state, or the formula of an output, in LaTeX.
fn latex_notation_name(name: &str) -> String {
    let mut arena = Arena::new();
    parse_free(&mut arena, name).map_or_else(|_| format!("\\text{{{name}}}"), |e| latex(&arena, e))
}
