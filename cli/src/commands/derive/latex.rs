//! A derivation in LaTeX: a document, or its sections for one: symbols, all that the text has, and what is conserved.
//!
//! Invariant: whatever a model is called, the result compiles with `amsmath` alone. Text is escaped, formulas break over lines at their signs, and no
//! matrix is wider than a page can hold: its entries are listed then. What is printed is read back by
//! [`tripos_derive::algebra::notation`] as the term that it was.

use crate::latex::{basis, escape};
use crate::words::NAMED;
use std::fmt::Write;
use tripos_derive::Model;
use tripos_derive::algebra::elimination::Elimination;
use tripos_derive::algebra::print::{latex, latex_lines, latex_name, latex_width, view_of};
use tripos_derive::algebra::steps::Definition;
use tripos_derive::algebra::view::View;
use tripos_derive::algebra::{Arena, Expr};
use tripos_derive::mechanics::{DerivationInSteps, LineName, MovingPlace, QuantityKind, Stage, Step, VectorName};
use tripos_derive::prove::Integral;

/// Characters of a formula's source after which it is not printed: nobody reads on.
const LONGEST: usize = 20_000;
/// Characters of a line's source after which it is not printed: TeX measures no line of that length.
const LONGEST_LINE: usize = 4_000;
/// The width of a line, in tenths of an em.
const LINE: usize = 380;
/// The width of matrices, which have a line for themselves, in tenths of an em.
const MATRIX: usize = 430;
/// Columns that a matrix has without asking for more.
const COLUMNS: usize = 10;

/// What is written.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Extent {
    /// A document that compiles as it is.
    Document,
    /// Its sections, for another document to `\\input`.
    Fragment,
}

/// A document, or the part of one, about a model, from its sections.
pub fn document(model: &Model, moving: &[MovingPlace], sections: &str, extent: Extent) -> String {
    let mut about = format!("{}.\n", escape(&model.count()));
    for place in moving {
        let _ = writeln!(about, "\n{}", escape(&place.text(model)));
    }
    about += &symbols(model);
    let title = escape(&model.title);
    match extent {
        Extent::Fragment => {
            format!(
                "% Needs \\usepackage{{amsmath}} and \\allowdisplaybreaks in the preamble.\n\\section*{{{title}}}\n{about}{sections}"
            )
        }
        Extent::Document => format!(
            "\\documentclass[a4paper]{{article}}\n\\usepackage[margin=25mm]{{geometry}}\n\\usepackage{{amsmath}}\n\\allowdisplaybreaks\n\
             \\begin{{document}}\n\\section*{{{title}}}\n{about}{sections}\n\\end{{document}}\n"
        ),
    }
}

/// What the symbols of a model mean, with their units.
fn symbols(model: &Model) -> String {
    let mut out = "\n\\section{Symbols}\n\\begin{description}\n\\setlength{\\itemsep}{0pt}\\setlength{\\parsep}{0pt}\n"
        .to_owned();
    let mut item = |name: &str, about: &str, unit: &str| {
        let unit = if unit == "1" { String::new() } else { raised(unit) };
        let parts: Vec<String> = [escape(about), unit].into_iter().filter(|part| !part.is_empty()).collect();
        let _ = writeln!(out, "\\item[\\({}\\)] {}", latex_name(name), parts.join(", "));
    };
    for parameter in &model.parameters {
        item(&parameter.name, &parameter.about, &parameter.unit.to_string());
    }
    for coordinate in &model.coordinates {
        item(&coordinate.name, &coordinate.about, &coordinate.unit.to_string());
    }
    for speed in &model.speeds {
        item(&speed.name, "generalized speed", &speed.unit.to_string());
    }
    for reaction in model.reactions.iter().filter(|reaction| reaction.is_stated) {
        item(&reaction.name, "reaction", "");
    }
    out + "\\end{description}\n"
}

/// A unit in text mode, its powers raised.
fn raised(unit: &str) -> String {
    let unit = unit.replace('*', " ");
    let mut parts = unit.split('^');
    let mut out = escape(parts.next().unwrap_or_default());
    for part in parts {
        let end = part.find(|c: char| !(c.is_ascii_digit() || c == '-')).unwrap_or(part.len());
        let _ = write!(out, "\\textsuperscript{{{}}}{}", escape(&part[..end]), escape(&part[end..]));
    }
    out
}

/// One formulation: steps, equations of motion, accelerations, energies, where the kinematic equations are singular.
pub fn formulation(model: &Model, derivation: &DerivationInSteps, solved: Option<&Elimination>) -> String {
    let DerivationInSteps { arena, equations: e, steps } = derivation;
    let mut out = format!("\n\\section{{{}}}\n", escape(e.formulation.title()));
    if !e.definitions.is_empty() {
        let _ = writeln!(out, "\n\\subsection{{{NAMED}}}\nEach by those before it.");
        definitions(&mut out, arena, &e.definitions);
    }
    for step in steps {
        self::step(&mut out, model, arena, step);
    }
    let _ = writeln!(
        out,
        "\n\\subsection{{Equations of motion}}\nOne row for each of {}.\n",
        escape(&e.row_names(model).join(", "))
    );
    system(&mut out, arena, derivation);
    if let Some(solved) = solved {
        out.push_str("\n\\subsection{Accelerations}\nEach by those before it.\n");
        definitions(&mut out, arena, &solved.steps);
    }
    out.push_str("\n\\subsection{Kinetic and potential energy}\n");
    let mut energies =
        vec![("T".to_owned(), view_of(arena, e.kinetic_energy)), ("V".to_owned(), view_of(arena, e.potential_energy))];
    if e.power != Expr::ZERO {
        energies.push(("\\frac{\\mathrm{d}}{\\mathrm{d}t}(T + V)".to_owned(), view_of(arena, e.power)));
    }
    equations(&mut out, &energies);
    if !e.divisors.is_empty() {
        out.push_str("\n\\subsection{Where the kinematic equations are singular}\n");
        equations(&mut out, &e.divisors.iter().map(|d| ("0".to_owned(), view_of(arena, *d))).collect::<Vec<_>>());
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
        equations(&mut out, &[(format!("C_{{{}}}", at + 1), view_of(arena, integral.expression))]);
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
    let lines = step.lines.iter().map(|(name, value)| (line_name(model, name), view_of(arena, *value)));
    equations(out, &lines.collect::<Vec<_>>());
}

/// The system M x = f, as far as matrices fit into a line; the entries of others one by one.
fn system(out: &mut String, arena: &Arena, derivation: &DerivationInSteps) {
    let e = &derivation.equations;
    let widest =
        |list: &mut dyn Iterator<Item = Expr>| list.map(|x| latex_width(&view_of(arena, x))).max().unwrap_or(0);
    let columns = (0..e.unknowns.len()).map(|j| 10 + widest(&mut e.matrix.iter().map(|row| row[j])));
    let matrix = columns.sum::<usize>() + 40;
    let all = matrix + widest(&mut e.unknowns.iter().copied()) + widest(&mut e.forcing.iter().copied()) + 40;
    if matrix <= MATRIX && e.unknowns.len() > COLUMNS {
        let _ = writeln!(out, "\\setcounter{{MaxMatrixCols}}{{{}}}", e.unknowns.len());
    }
    let row = |row: &Vec<Expr>| row.iter().map(|x| latex(arena, *x)).collect::<Vec<_>>().join(" & ");
    let column = |list: Vec<String>| format!("\\begin{{bmatrix}}\n{}\n\\end{{bmatrix}}", list.join(" \\\\\n"));
    let m = column(e.matrix.iter().map(row).collect());
    let unknowns: Vec<String> = e.unknowns.iter().map(|x| symbol(arena, *x)).collect();
    if all <= MATRIX {
        let (unknowns, right) = (column(unknowns), column(e.forcing.iter().map(|x| latex(arena, *x)).collect()));
        let _ = writeln!(out, "\\[\n{m}\n{unknowns}\n=\n{right}\n\\]");
        return;
    }
    let _ = writeln!(out, "\\(M x = f\\) with \\(x = ({})\\).", unknowns.join(", "));
    let right = e.forcing.iter().enumerate();
    let mut entries: Vec<(String, View)> =
        right.map(|(i, entry)| (format!("f_{{{}}}", i + 1), view_of(arena, *entry))).collect();
    if matrix <= MATRIX {
        let _ = writeln!(out, "\\[\nM = {m}\n\\]");
    } else {
        out.push_str("Entries of \\(M\\) that are not listed are 0.\n");
        entries.splice(0..0, entries_of_matrix(arena, &e.matrix));
    }
    equations(out, &entries);
}

/// The entries of M that are not zero.
fn entries_of_matrix(arena: &Arena, matrix: &[Vec<Expr>]) -> Vec<(String, View)> {
    let mut entries = Vec::new();
    for (i, row) in matrix.iter().enumerate() {
        for (j, entry) in row.iter().enumerate().filter(|(_, entry)| **entry != Expr::ZERO) {
            entries.push((format!("M_{{{},{}}}", i + 1, j + 1), view_of(arena, *entry)));
        }
    }
    entries
}

fn definitions(out: &mut String, arena: &Arena, list: &[Definition]) {
    let list = list.iter().map(|step| (symbol(arena, step.symbol), view_of(arena, step.value)));
    equations(out, &list.collect::<Vec<_>>());
}

fn symbol(arena: &Arena, e: Expr) -> String {
    latex_name(arena.symbol_name(e).unwrap_or_default())
}

/// Equations below one another, each in as many lines as it needs.
fn equations(out: &mut String, list: &[(String, View)]) {
    if list.is_empty() {
        return;
    }
    let rows = list.iter().map(|(left, right)| {
        let lines = latex_lines(right, LINE - left_width(left));
        let lengths = lines.iter().map(String::len);
        if lengths.clone().sum::<usize>() > LONGEST || lengths.max() > Some(LONGEST_LINE) {
            return format!("{left} &= \\text{{an expression too long to print here}}");
        }
        format!("{left} &= {}", lines.join(" \\\\\n  &\\qquad "))
    });
    let _ = writeln!(out, "\\begin{{align*}}\n{}\n\\end{{align*}}", rows.collect::<Vec<_>>().join(" \\\\\n"));
}

/// About how wide a left side is, and what goes on in front of the lines after the first.
fn left_width(left: &str) -> usize {
    let shown =
        left.replace("\\mathbf", "").replace("\\boldsymbol", "").replace("\\partial", "d").replace("\\frac", "");
    (4 * shown.chars().filter(char::is_ascii_alphanumeric).count()).min(120) + 40
}

/// The name of a line of a derivation, for math mode.
fn line_name(model: &Model, name: &LineName) -> String {
    let force = |letter: &str, of: &str| format!("{letter}_{{{}}}", latex_name(of));
    match name {
        LineName::Quantity(QuantityKind::Component { vector: name, of, frame, axis }) => {
            format!("{} \\cdot {}", vector(model, *name, *of), basis(&model.frames[*frame].name, *axis))
        }
        LineName::Quantity(QuantityKind::Partial { vector: name, of, frame, axis, speed }) => format!(
            "\\frac{{\\partial {}}}{{\\partial {}}} \\cdot {}",
            vector(model, *name, *of),
            latex_name(&model.speeds[*speed].name),
            basis(&model.frames[*frame].name, *axis)
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
