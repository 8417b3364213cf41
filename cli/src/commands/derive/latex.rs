//! A derivation in LaTeX: all that the text has, in sections, with what is conserved.
//!
//! Invariant: whatever a model is called, the result compiles with `amsmath` alone. Text is escaped, formulas break
//! over lines at their signs, and no matrix is wider than a page can hold: its entries are listed then.

use crate::words::NAMED;
use std::fmt::Write;
use tripos_derive::Model;
use tripos_derive::algebra::elimination::Elimination;
use tripos_derive::algebra::print::{latex, latex_name};
use tripos_derive::algebra::steps::Definition;
use tripos_derive::algebra::{Arena, Expr};
use tripos_derive::mechanics::{DerivationInSteps, LineName, MovingPlace, QuantityKind, Stage, Step, VectorName};
use tripos_derive::plain::called;
use tripos_derive::prove::Integral;

/// Characters of a formula's source after which it is not printed: nobody reads on, and TeX measures no line of that
/// length.
const LONGEST: usize = 6_000;
/// Characters of a row's source after which the entries of a matrix are listed.
const WIDEST: usize = 400;
/// Columns that a matrix has without asking for more.
const COLUMNS: usize = 10;

/// The head of the file: what it needs, and what it is of.
pub fn head(model: &Model, moving: &[MovingPlace]) -> String {
    let mut out = format!(
        "% Needs \\usepackage{{amsmath}} in the preamble.\n\\section*{{{}}}\n{}.\n",
        escape(&model.title),
        escape(&model.count())
    );
    for place in moving {
        let _ = writeln!(out, "\n{}", escape(&place.text(model)));
    }
    out
}

/// One formulation: steps, equations of motion, accelerations, energies, where the kinematic equations are singular.
pub fn formulation(model: &Model, derivation: &DerivationInSteps, solved: Option<&Elimination>) -> String {
    let DerivationInSteps { arena, equations: e, steps } = derivation;
    let mut out = format!("\n\\section{{{}}}\n", escape(e.formulation.title()));
    if !e.definitions.is_empty() {
        let _ = writeln!(out, "\n\\subsection{{{NAMED}}}\nEach by those before it.");
        for step in &e.definitions {
            definition(&mut out, arena, *step);
        }
    }
    for step in steps {
        self::step(&mut out, model, arena, step);
    }
    let _ = writeln!(
        out,
        "\n\\subsection{{Equations of motion}}\nOne row for each of {}.\n",
        escape(&e.row_names(model).join(", "))
    );
    let wide = |row: &Vec<Expr>| row.iter().map(|x| latex(arena, *x).len()).sum::<usize>() > WIDEST;
    let right_is_wide = e.forcing.iter().any(|x| latex(arena, *x).len() > WIDEST);
    if right_is_wide || e.matrix.iter().any(wide) {
        listed_system(&mut out, arena, derivation);
    } else {
        system(&mut out, arena, derivation);
    }
    if let Some(solved) = solved {
        out.push_str("\n\\subsection{Accelerations}\nEach by those before it.\n");
        for step in &solved.steps {
            definition(&mut out, arena, *step);
        }
    }
    out.push_str("\n\\subsection{Kinetic and potential energy}\n");
    equation(&mut out, "T", &latex(arena, e.kinetic_energy));
    equation(&mut out, "V", &latex(arena, e.potential_energy));
    if e.power != Expr::ZERO {
        equation(&mut out, "\\frac{\\mathrm{d}}{\\mathrm{d}t}(T + V)", &latex(arena, e.power));
    }
    if !e.divisors.is_empty() {
        out.push_str("\n\\subsection{Where the kinematic equations are singular}\n");
        for divisor in &e.divisors {
            equation(&mut out, &latex(arena, *divisor), "0");
        }
    }
    out
}

/// What is conserved.
pub fn integrals(model: &Model, arena: &Arena, list: &[Integral]) -> String {
    let mut out = "\n\\section{First integrals}\n".to_owned();
    if list.is_empty() {
        out.push_str("None found.\n");
    }
    for (at, integral) in list.iter().enumerate() {
        let _ = writeln!(out, "\n\\paragraph{{{}}}", escape(&integral.name(model, arena)));
        equation(&mut out, &format!("C_{{{}}}", at + 1), &latex(arena, integral.expression));
    }
    out
}

fn step(out: &mut String, model: &Model, arena: &Arena, step: &Step) {
    let title = match step.stage {
        Stage::Velocities { vector: name, of, frame } => {
            let (of, frame) = (vector(model, name, of), escape(&model.frames[frame].name));
            format!("Velocity and partial velocities: ${of}$, components in {frame}")
        }
        stage => escape(&stage.title(model)),
    };
    let _ = writeln!(out, "\n\\subsection{{{title}}}");
    for (name, value) in &step.lines {
        equation(out, &line_name(model, name), &latex(arena, *value));
    }
}

/// The system M x = f as matrices.
fn system(out: &mut String, arena: &Arena, derivation: &DerivationInSteps) {
    let e = &derivation.equations;
    let row = |row: &Vec<Expr>| row.iter().map(|x| latex(arena, *x)).collect::<Vec<_>>().join(" & ");
    let column = |list: Vec<String>| format!("\\begin{{bmatrix}}\n{}\n\\end{{bmatrix}}", list.join(" \\\\\n"));
    if e.unknowns.len() > COLUMNS {
        let _ = writeln!(out, "\\setcounter{{MaxMatrixCols}}{{{}}}", e.unknowns.len());
    }
    let matrix = column(e.matrix.iter().map(row).collect());
    let unknowns = column(e.unknowns.iter().map(|x| symbol(arena, *x)).collect());
    let right = column(e.forcing.iter().map(|x| latex(arena, *x)).collect());
    let _ = writeln!(out, "\\[\n{matrix}\n{unknowns}\n=\n{right}\n\\]");
}

/// The entries of M and f that are not zero, one by one.
fn listed_system(out: &mut String, arena: &Arena, derivation: &DerivationInSteps) {
    let e = &derivation.equations;
    let unknowns: Vec<String> = e.unknowns.iter().map(|x| symbol(arena, *x)).collect();
    let _ = writeln!(
        out,
        "\\(M x = f\\) with \\(x = ({})\\); entries of \\(M\\) that are not listed are 0.",
        unknowns.join(", ")
    );
    for (i, row) in e.matrix.iter().enumerate() {
        for (j, entry) in row.iter().enumerate().filter(|(_, entry)| **entry != Expr::ZERO) {
            equation(out, &format!("M_{{{},{}}}", i + 1, j + 1), &latex(arena, *entry));
        }
    }
    for (i, entry) in e.forcing.iter().enumerate() {
        equation(out, &format!("f_{{{}}}", i + 1), &latex(arena, *entry));
    }
}

fn definition(out: &mut String, arena: &Arena, of: Definition) {
    equation(out, &symbol(arena, of.symbol), &latex(arena, of.value));
}

fn symbol(arena: &Arena, e: Expr) -> String {
    latex_name(arena.symbol_name(e).unwrap_or_default())
}

/// An equation in a paragraph of its own, so that it may break over lines.
fn equation(out: &mut String, left: &str, right: &str) {
    let right = if right.len() > LONGEST { "\\text{an expression too long to print here}" } else { right };
    let _ = writeln!(out, "\n\\noindent\\({left} = {right}\\)");
}

/// The name of a line of a derivation, for math mode.
fn line_name(model: &Model, name: &LineName) -> String {
    let force = |letter: &str, of: &str| format!("{letter}_{{{}}}", latex_name(of));
    match name {
        LineName::Quantity(QuantityKind::Component { vector: name, of, frame, axis }) => {
            format!("{} \\cdot {}", vector(model, *name, *of), basis(model, *frame, *axis))
        }
        LineName::Quantity(QuantityKind::Partial { vector: name, of, frame, axis, speed }) => format!(
            "\\frac{{\\partial {}}}{{\\partial {}}} \\cdot {}",
            vector(model, *name, *of),
            latex_name(&model.speeds[*speed].name),
            basis(model, *frame, *axis)
        ),
        LineName::Quantity(kind) => latex_name(&kind.name(model)),
        LineName::ActiveForce(at) => force("F", &model.speeds[*at].name),
        LineName::GeneralizedForce(at) => force("Q", &model.coordinates[*at].name),
    }
}

/// A vector of a point, frame or body in the inertial frame.
fn vector(model: &Model, name: VectorName, of: usize) -> String {
    let letter = match name {
        VectorName::AngularVelocity => "\\boldsymbol{\\omega}".to_owned(),
        VectorName::AngularAcceleration => "\\boldsymbol{\\alpha}".to_owned(),
        other => format!("\\mathbf{{{}}}", other.name()),
    };
    let inertial = latex_name(&model.frames[0].name);
    format!("{{}}^{{{inertial}}}{letter}^{{{}}}", latex_name(name.owner_name(model, of)))
}

/// Basis vector b₂ of frame B.
fn basis(model: &Model, frame: usize, axis: usize) -> String {
    format!("\\mathbf{{{}}}_{{{}}}", escape(&model.frames[frame].name.to_lowercase()), axis + 1)
}

/// Words for text mode: what TeX reads otherwise is written out, and what its fonts do not have is named.
fn escape(text: &str) -> String {
    let one = |c: char| match c {
        '\\' => "\\textbackslash{}".to_owned(),
        '~' => "\\textasciitilde{}".to_owned(),
        '^' => "\\textasciicircum{}".to_owned(),
        '{' | '}' | '$' | '&' | '#' | '_' | '%' => format!("\\{c}"),
        '<' | '>' | '|' => format!("\\ensuremath{{{c}}}").replace('|', "\\vert"),
        '∂' => "\\ensuremath{\\partial}".to_owned(),
        '–' => "--".to_owned(),
        '—' => "---".to_owned(),
        '’' => "'".to_owned(),
        ' '..='~' | '\u{c0}'..='\u{ff}' => c.to_string(),
        other => format!("[{}]", called(other)),
    };
    text.chars().map(one).collect()
}
