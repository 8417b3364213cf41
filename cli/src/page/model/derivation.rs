//! Section of the page about one formulation: its equations of motion, and separately its derivation stage by stage.

use super::laws::law;
use crate::page::content::Page;
use crate::page::markup::formula_mathml::{
    MathmlSide, aligned_mathml_equations, breakable_mathml, formula, formula_mathml_in_sentence, inline_mathml,
    is_short_formula_mathml, length, line_name_mathml, long_formulas_note, matrix_mathml, row_name_mathml,
    stage_title_mathml,
};
use crate::page::markup::html::{escape, foldable_part, folded_html, link, scrolling_box};
use crate::phrases::NAMED_TERMS_HEADING;
use std::fmt::Write;
use tripos_derive::algebra::term::steps::Definition;
use tripos_derive::algebra::text::definitions::definitions_shown;
use tripos_derive::algebra::text::display_tree::DisplayTree;
use tripos_derive::algebra::text::print::{latex, print_view};
use tripos_derive::algebra::{Arena, Expr};
use tripos_derive::mechanics::{DerivationInSteps, Equations, LineName, QuantityKind, Step};
use tripos_derive::{Formulation, Model};

/// Number of lines from which on a stage of a derivation is folded.
const MANY_LINES: usize = 14;
/// Number of characters of plain text above which a stage of a derivation is folded.
const LONG: usize = 900;
/// Candidates for the largest length of an entry that is written inside the matrix. The first candidate with which the
/// system fits the page is used. Longer entries are named M_ij and defined below the matrix.
const WIDE: [usize; 5] = [56, 48, 40, 34, 28];
/// Number of characters of plain text whose mathematics fits on a line of the page.
const PAGE: usize = 110;
/// Number of characters of all equations above which they are not repeated row by row and in LaTeX. It is about three
/// printed pages.
const TOO_LONG: usize = 8_000;

/// Returns the HTML section with the equations of one formulation. `result` is the derivation, or the reason why there
/// is none.
pub fn section(page: &Page, formulation: Formulation, result: &Result<DerivationInSteps, String>) -> String {
    let (name, title) = (formulation.name(), escape(formulation.title()));
    let content = match result {
        Ok(derivation) => {
            let named = definitions(&derivation.arena, &derivation.equations.definitions);
            let equations = show_equations(page, derivation);
            format!("{named}{equations}")
        }
        Err(reason) => format!("<p class=\"missing\"><strong>Not derived.</strong> {}.</p>\n", escape(reason)),
    };
    format!(
        "<section id=\"{name}\">\n<h3>{title}</h3>\n<p>{}</p>\n{content}</section>\n",
        principle(formulation, page.model)
    )
}

/// Returns the folded HTML of a formulation's derivation; empty if there is none. `shown` collects the stages that are
/// already shown, so that a repeated stage is folded.
pub fn steps(
    page: &Page,
    formulation: Formulation,
    result: &Result<DerivationInSteps, String>,
    shown: &mut Vec<String>,
) -> String {
    let Ok(derivation) = result else { return String::new() };
    let DerivationInSteps { arena, steps, .. } = derivation;
    let shown: String = steps.iter().map(|step| derivation_step_html(page.model, arena, step, shown)).collect();
    let mut values = steps.iter().flat_map(|step| step.lines.iter().map(|(_, value)| *value));
    let is_read = values.all(|e| length(arena, e).is_some());
    let rest = if is_read { String::new() } else { long_formulas_note(&derive_command(page, formulation)) };
    foldable_part(&derivation_anchor(formulation), &escape(formulation.title()), &(shown + &rest))
}

/// Returns the HTML id of a formulation's derivation on the page.
fn derivation_anchor(formulation: Formulation) -> String {
    format!("{}-steps", formulation.name())
}

/// Returns the command that prints all formulas of a formulation, however long they are.
fn derive_command(page: &Page, formulation: Formulation) -> String {
    format!("tripos derive {} --by {} --format json", page.file, formulation.name())
}

/// Returns the HTML of the definitions of all names in the formulas `shown`. Formulas that are too long for the page
/// are ignored.
pub fn named_terms(arena: &Arena, shown: &[Expr]) -> String {
    let printed: Vec<Expr> = shown.iter().copied().filter(|e| length(arena, *e).is_some()).collect();
    definitions(arena, &definitions_shown(arena, &printed))
}

/// Returns the folded HTML of definitions of named terms; empty for an empty list.
fn definitions(arena: &Arena, list: &[Definition]) -> String {
    if list.is_empty() {
        return String::new();
    }
    let line = |step: &Definition| (MathmlSide::of(arena, step.symbol), MathmlSide::of(arena, step.value));
    let pairs: Vec<_> = list.iter().map(line).collect();
    let content = scrolling_box(NAMED_TERMS_HEADING, &aligned_mathml_equations(&pairs));
    folded_html(&format!("{NAMED_TERMS_HEADING} <span class=\"quiet\">({} lines)</span>", pairs.len()), &content)
}

/// Returns the HTML of a formulation's principle, with its law as a formula if it has one.
fn principle(formulation: Formulation, model: &Model) -> String {
    let (principle, law) = (formulation.method().principle, law(formulation, model));
    if law.is_empty() { format!("{principle}.") } else { format!("{principle} {}.", inline_mathml(&law)) }
}

/// Returns the HTML of a stage of a derivation. The stage is folded if it is long, or if it is already in `shown`.
fn derivation_step_html(model: &Model, arena: &Arena, step: &Step, shown: &mut Vec<String>) -> String {
    if step.lines.is_empty() {
        return String::new();
    }
    let mut title = stage_title_mathml(model, step.stage);
    let pairs = step
        .lines
        .iter()
        .map(|(name, e)| (MathmlSide::Whole(line_name_mathml(model, name)), MathmlSide::of(arena, *e)));
    let mut content = scrolling_box(&step.stage.title(model), &aligned_mathml_equations(&pairs.collect::<Vec<_>>()));
    let is_partial = |name: &LineName| matches!(name, LineName::Quantity(QuantityKind::Partial { .. }));
    if step.lines.iter().any(|(name, _)| is_partial(name)) {
        content += "<p class=\"quiet\">Partial derivatives that are not listed are zero.</p>\n";
    }
    let size: usize = step.lines.iter().map(|(_, e)| length(arena, *e).unwrap_or(LONG)).sum();
    let repeated = shown.contains(&content);
    if repeated {
        title += " <span class=\"quiet\">(as above)</span>";
    } else {
        shown.push(content.clone());
    }
    if repeated || step.lines.len() > MANY_LINES || size > LONG {
        let count = step.lines.len();
        let count = if repeated { String::new() } else { format!(" <span class=\"quiet\">({count} lines)</span>") };
        folded_html(&format!("{title}{count}"), &content)
    } else {
        format!("<h4>{title}</h4>\n{content}")
    }
}

/// Returns the HTML of the linear system with remarks, followed by its entries, the equations row by row and in LaTeX,
/// and a link to the derivation.
fn show_equations(page: &Page, derivation: &DerivationInSteps) -> String {
    let DerivationInSteps { arena, equations, .. } = derivation;
    let (mut out, mut known, mut more) = (String::new(), Vec::new(), String::new());
    let (system, named) = derived_system_mathml(arena, equations);
    let math = format!("<math display=\"block\"><mrow>{system}</mrow></math>\n");
    out += &scrolling_box("System of equations in matrix form", &math);
    if !named.is_empty() {
        if equations.symmetric {
            known.push("The matrix is symmetric.".to_owned());
        }
        let entries = scrolling_box("Entries of the matrix and of the forcing", &aligned_mathml_equations(&named));
        more += &folded_html(&format!("Its entries <span class=\"quiet\">({})</span>", named.len()), &entries);
    }
    if !equations.divisors.is_empty() {
        let divisors: Vec<_> = equations.divisors.iter().map(|e| formula_mathml_in_sentence(arena, *e)).collect();
        known.push(format!(
            "The kinematic equations divide by {}: where one vanishes the generalized speeds do not determine the rates of the \
             coordinates.",
            divisors.join(", ")
        ));
    }
    let entries: Vec<Expr> = equations.matrix.iter().flatten().chain(&equations.forcing).copied().collect();
    match entries.iter().map(|e| length(arena, *e)).sum::<Option<usize>>() {
        Some(size) if size <= TOO_LONG => {
            more += &folded_html(
                "Row by row",
                &scrolling_box("Equations row by row", &row_by_row(page.model, arena, equations)),
            );
            let source = format!("<pre><code>{}</code></pre>\n", escape(&page_derivation_latex(arena, equations)));
            more += &folded_html("LaTeX source", &scrolling_box("LaTeX source", &source));
        }
        _ => {
            let command = escape(&format!("tripos derive {} --by {}", page.file, equations.formulation.name()));
            known.push(format!(
                "Too long to be repeated row by row; <code>{command}</code> prints it, with <code>--format latex</code> for a document."
            ));
        }
    }
    if !known.is_empty() {
        let _ = writeln!(out, "<p class=\"formula\">{}</p>", known.join(" "));
    }
    let is_read = entries.iter().all(|e| length(arena, *e).is_some());
    if !(is_read && equations.divisors.iter().all(|e| is_short_formula_mathml(arena, *e))) {
        out += &long_formulas_note(&derive_command(page, equations.formulation));
    }
    let steps = link(&derivation_anchor(equations.formulation), "How they are derived, step by step");
    out + &format!("<div class=\"side\">\n{more}<p>{steps}.</p>\n</div>\n")
}

/// Returns the largest length of an entry that is written inside the matrix. It is chosen so that the system fits the
/// page.
fn longest_derived_entry(arena: &Arena, equations: &Equations) -> usize {
    let named = "M12".len();
    let width = |e: Expr, limit: usize| length(arena, e).filter(|n| *n <= limit).unwrap_or(named);
    let fits = |limit: &usize| {
        let column = |j: usize| equations.matrix.iter().map(|row| width(row[j], *limit)).max().unwrap_or(0);
        let matrix: usize = (0..equations.unknowns.len()).map(|j| column(j) + 2).sum();
        matrix + equations.forcing.iter().map(|e| width(*e, *limit)).max().unwrap_or(0) <= PAGE
    };
    // If the system fits with none of these lengths, it scrolls.
    WIDE.into_iter().find(fits).unwrap_or(WIDE[2])
}

/// Returns the MathML of the linear system matrix · unknowns = forcing. The second result lists, as (name, value), the
/// entries that are too long to be written in the system.
fn derived_system_mathml(arena: &Arena, equations: &Equations) -> (String, Vec<(MathmlSide, MathmlSide)>) {
    let wide = longest_derived_entry(arena, equations);
    let mut named = Vec::new();
    let mut entry = |e: Expr, name: String, is_repeated: bool| {
        if length(arena, e).is_some_and(|length| length <= wide) {
            return formula(arena, e);
        }
        if !is_repeated {
            named.push((MathmlSide::Whole(name.clone()), MathmlSide::of(arena, e)));
        }
        name
    };
    let mut rows = Vec::new();
    for (i, row) in equations.matrix.iter().enumerate() {
        let mut cells = Vec::new();
        for (j, e) in row.iter().enumerate() {
            let below = equations.symmetric && j < i;
            let (a, b) = if below { (j, i) } else { (i, j) };
            // Two indices need no comma if each has one digit.
            let comma = if equations.matrix.len() > 9 { "<mo separator=\"true\">,</mo>" } else { "" };
            let name = format!("<msub><mi>M</mi><mrow><mn>{}</mn>{comma}<mn>{}</mn></mrow></msub>", a + 1, b + 1);
            cells.push(entry(*e, name, below));
        }
        rows.push(cells);
    }
    let forcing = equations.forcing.iter().enumerate();
    let forcing: Vec<_> =
        forcing.map(|(i, e)| vec![entry(*e, format!("<msub><mi>f</mi><mn>{}</mn></msub>", i + 1), false)]).collect();
    let unknowns: Vec<_> = equations.unknowns.iter().map(|e| vec![formula(arena, *e)]).collect();
    (format!("{}{}<mo>=</mo>{}", matrix_mathml(&rows), matrix_mathml(&unknowns), matrix_mathml(&forcing)), named)
}

/// Returns the HTML of the equations row by row. Each row is a sum of terms that equals the forcing.
fn row_by_row(model: &Model, arena: &Arena, equations: &Equations) -> String {
    // Terms are joined in a copy of the arena, so that the original is not changed.
    let mut arena = arena.clone();
    let mut out = String::from("<table class=\"lines\">\n<tbody>\n");
    for ((row, name), forcing) in equations.matrix.iter().zip(&equations.rows).zip(&equations.forcing) {
        let terms = row.iter().zip(&equations.unknowns).filter(|(e, _)| **e != Expr::ZERO);
        let terms: Vec<Expr> = terms.map(|(e, x)| arena.mul(*e, *x)).collect();
        let sides = [MathmlSide::Marks(derived_row_sum(&arena, &terms)), MathmlSide::of(&arena, *forcing)];
        let _ = writeln!(
            out,
            "<tr><th scope=\"row\">{}</th><td class=\"wide\">{}</td></tr>",
            row_name_mathml(model, name),
            breakable_mathml(&sides)
        );
    }
    out + "</tbody>\n</table>\n"
}

/// Returns the formula of the sum of `terms`, in the given order.
fn derived_row_sum(arena: &Arena, terms: &[Expr]) -> DisplayTree {
    let terms = terms.iter().flat_map(|term| match print_view(arena, *term) {
        DisplayTree::Sum(terms) => terms,
        term => vec![(false, term)],
    });
    let mut terms: Vec<(bool, DisplayTree)> = terms.collect();
    match terms.as_slice() {
        [] => DisplayTree::Number("0".to_owned()),
        [(false, _)] => terms.remove(0).1,
        _ => DisplayTree::Sum(terms),
    }
}

/// Returns the LaTeX source of the linear system.
fn page_derivation_latex(arena: &Arena, equations: &Equations) -> String {
    let column = |list: &[Expr]| list.iter().map(|e| latex(arena, *e)).collect::<Vec<_>>().join(" \\\\\n  ");
    let rows = equations.matrix.iter();
    let rows = rows.map(|row| row.iter().map(|e| latex(arena, *e)).collect::<Vec<_>>().join(" & "));
    format!(
        "\\begin{{bmatrix}}\n  {}\n\\end{{bmatrix}}\n\\begin{{bmatrix}}\n  {}\n\\end{{bmatrix}}\n=\n\
         \\begin{{bmatrix}}\n  {}\n\\end{{bmatrix}}",
        rows.collect::<Vec<_>>().join(" \\\\\n  "),
        column(&equations.unknowns),
        column(&equations.forcing),
    )
}
