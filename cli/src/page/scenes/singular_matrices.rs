//! Statements of the page about singular matrices: proofs about the determinants, and values along a scene's runs.
//!
//! Invariant: every sentence is computed. A proof holds in all configurations, but a statement about a run only in the
//! configurations that the run reached.

use crate::page::content::{Page, RunRow, SceneSection};
use crate::page::markup::formula_mathml::{MathmlSide, breakable_mathml, formula, inline_mathml, length};
use crate::page::markup::html::{escape, join_html, number, rounded_number_html, scrolling_box, table_head};
use crate::page::scenes::runs::run_name;
use crate::page::scenes::standing::{self, standing_row_class};
use std::fmt::Write;
use tripos_derive::algebra::{Arena, Expr};
use tripos_derive::prove::{DeterminantAtZero, Singularity};

/// Largest number of characters of a divisor, as plain text, in the head of a table. A longer divisor gets a name.
const SHORT: usize = 40;

/// Returns the HTML below the figure of determinants: the sentences that say where matrices of the
/// equations are singular, and the table of the extreme values of their divisors along runs.
pub fn singularity_statements(page: &Page, scene: &SceneSection) -> String {
    let divisors = divisors(page);
    let mut items = singular_divisor_definitions(page);
    items.extend(singular_matrix_proofs(page, &divisors));
    items.extend(condition_number_sentences(scene));
    items.extend(divisors.iter().enumerate().filter_map(|(at, divisor)| divisor_along_runs(scene, at, divisor)));
    let items = join_html(&items, |item| format!("<li><div class=\"formula\">{item}</div></li>\n"));
    format!("<ul>\n{items}</ul>\n{}", extremes_table(scene, &divisors))
}

/// Returns the MathML of the divisors of the kinematic equations. Divisors that are too long for the head of a table
/// are replaced with names.
fn divisors(page: &Page) -> Vec<String> {
    let (list, arena) = (&page.model.kinematic_equations.divisors, &page.model.arena);
    let typeset =
        |(at, e): (usize, &Expr)| if is_long(arena, *e) { singular_divisor_name(at) } else { formula(arena, *e) };
    list.iter().enumerate().map(typeset).collect()
}

/// True if a divisor is too long for the head of a table and gets a name.
fn is_long(arena: &Arena, e: Expr) -> bool {
    length(arena, e).is_none_or(|length| length > SHORT)
}

/// Returns the MathML name of a long divisor, d with a number. The index `at` counts from 0, the number from 1.
fn singular_divisor_name(at: usize) -> String {
    format!("<msub><mi>d</mi><mn>{}</mn></msub>", at + 1)
}

/// Returns the HTML of the definitions of the long divisors' names.
fn singular_divisor_definitions(page: &Page) -> Vec<String> {
    let (list, arena) = (&page.model.kinematic_equations.divisors, &page.model.arena);
    let definition = |(at, e): (usize, &Expr)| {
        let sides = [MathmlSide::Whole(singular_divisor_name(at)), MathmlSide::short(arena, *e)];
        breakable_mathml(&sides)
    };
    list.iter().enumerate().filter(|(_, e)| is_long(arena, **e)).map(definition).collect()
}

/// Returns the sets of equations whose determinant is known as a formula: their names as HTML, and the proved
/// statements about the determinant.
fn determinants<'a>(page: &'a Page<'_>) -> Vec<(String, &'a Singularity)> {
    let derived = page.study.singular.iter().map(|(f, s)| (escape(f.title()), s));
    let printed = page.study.published.iter().flat_map(|published| {
        let systems = published.difference.consequences.iter().zip(&published.singular);
        systems.filter_map(|(c, s)| Some((format!("<code>printed:{}</code>", escape(&c.system)), s.as_ref()?)))
    });
    derived.chain(printed).collect()
}

/// Returns the HTML of statements about determinants that hold in every configuration.
fn singular_matrix_proofs(page: &Page, divisors: &[String]) -> Vec<String> {
    let list = determinants(page);
    let named = |of: &dyn Fn(&Singularity) -> bool| {
        let names: Vec<&str> = list.iter().filter(|(_, s)| of(s)).map(|(name, _)| name.as_str()).collect();
        (!names.is_empty()).then(|| names.join(", "))
    };
    let mut items = Vec::new();
    if let Some(names) = named(&|s| s.never) {
        items.push(format!(
            "Proved: the determinant of the matrix is zero in no configuration, whatever the parameters, for: {names}."
        ));
    }
    for (divisor, e) in divisors.iter().zip(&page.model.kinematic_equations.divisors) {
        let zero = inline_mathml(&format!("<mrow>{divisor}<mo>=</mo><mn>0</mn></mrow>"));
        let place = |s: &Singularity| s.at.iter().find(|place| place.divisor == *e).copied();
        let there = |s: &Singularity| place(s).map(|place| place.determinant);
        if let Some(names) = named(&|s| there(s) == Some(DeterminantAtZero::Zero)) {
            items.push(format!("Proved: the determinant is zero wherever {zero}, for: {names}."));
        }
        if let Some(names) = named(&|s| !s.never && there(s) == Some(DeterminantAtZero::NotZero)) {
            items.push(format!("Proved: the determinant is not zero where {zero}, for: {names}."));
        }
        if let Some(names) = named(&|s| place(s).is_some_and(|place| place.entries_divide)) {
            items.push(format!(
                "Entries of the matrix divide by {}, for: {names}. Where that is small such a matrix can be ill-conditioned, \
                 whether or not its determinant is small too.",
                inline_mathml(divisor)
            ));
        }
    }
    let nothing = |s: &Singularity| s.determinant == Expr::ZERO;
    if let Some(names) = named(&nothing) {
        items.push(format!("The determinant of the matrix is zero everywhere, for: {names}."));
    }
    let known = |s: &Singularity| {
        nothing(s) || s.never || s.at.iter().any(|place| place.determinant != DeterminantAtZero::Open)
    };
    if let Some(names) = named(&|s| !known(s)) {
        items.push(format!("Nothing is proved of the zeros of the determinant for: {names}."));
    }
    items
}

/// Returns HTML sentences about the smallest reciprocal condition number among runs by derived equations, and among
/// runs by printed equations.
fn condition_number_sentences(scene: &SceneSection) -> Vec<String> {
    let worst = |printed: bool| {
        let runs = scene.runs.iter().filter(|run| run.printed.is_some() == printed);
        let list = runs.filter_map(|run| Some((run, run.nearest.condition?)));
        list.min_by(|a, b| a.1.0.total_cmp(&b.1.0))
    };
    let sentence = |what: &str, found: Option<(&RunRow, (f64, f64))>| {
        let (run, (condition, t)) = found?;
        let digits = (15.95 + condition.log10()).floor();
        let left = match digits {
            d if d >= 14.0 => "and the solution for the accelerations keeps nearly all digits".to_owned(),
            d if d >= 1.0 => format!("and the solution for the accelerations keeps about {d} of 16 digits"),
            _ => "and the solution for the accelerations keeps no digit".to_owned(),
        };
        Some(format!(
            "Among these runs of {what} equations the reciprocal condition number comes down to {} ({} at {} s), {left}.",
            number(&rounded_number_html(condition, 2)),
            run_name(run),
            number(&rounded_number_html(t, 4)),
        ))
    };
    [sentence("the derived", worst(false)), sentence("printed", worst(true))].into_iter().flatten().collect()
}

/// Returns the HTML sentence about the smallest absolute value of a divisor in the runs by derived equations. `None` if
/// no run has recorded it.
fn divisor_along_runs(scene: &SceneSection, at: usize, divisor: &str) -> Option<String> {
    let runs = scene.runs.iter().filter(|run| run.printed.is_none());
    let list = runs.filter_map(|run| Some((run, (*run.nearest.divisors.get(at)?)?)));
    let (run, (least, t)) = list.min_by(|a, b| a.1.0.total_cmp(&b.1.0))?;
    let size = inline_mathml(&format!("<mrow><mo form=\"prefix\">|</mo>{divisor}<mo form=\"postfix\">|</mo></mrow>"));
    Some(format!(
        "The kinematic equations divide by {}, whatever the matrix does: in the derived runs {size} comes down to {} ({} \
         at {} s), and rates of coordinates can grow with its inverse.",
        inline_mathml(divisor),
        number(&rounded_number_html(least, 2)),
        run_name(run),
        number(&rounded_number_html(t, 4)),
    ))
}

/// Returns the HTML table with the extremes of determinant, condition number and divisors in every
/// run.
fn extremes_table(scene: &SceneSection, divisors: &[String]) -> String {
    let mut columns = vec![
        "Equations".to_owned(),
        "det <i>A</i> from".to_owned(),
        "to".to_owned(),
        "least |det <i>A</i> / det <i>A</i>(t₀)|".to_owned(),
        "at [s]".to_owned(),
        "least 1 / cond <i>A</i>".to_owned(),
        "at [s]".to_owned(),
    ];
    for divisor in divisors {
        let size = format!("<mrow><mo form=\"prefix\">|</mo>{divisor}<mo form=\"postfix\">|</mo></mrow>");
        columns.push(format!("least {}", inline_mathml(&size)));
        columns.push("at [s]".to_owned());
    }
    let columns: Vec<&str> = columns.iter().map(String::as_str).collect();
    let mut rows = String::new();
    // Divisors and determinants were not recorded in runs that do not show every state.
    for run in scene.runs.iter().filter(|run| !run.nearest.divisors.is_empty() || run.nearest.determinant.is_some()) {
        let nearest = &run.nearest;
        let pair = |pair: Option<(f64, f64)>| match pair {
            Some((value, t)) => [number(&rounded_number_html(value, 3)), number(&rounded_number_html(t, 4))],
            None => ["–".to_owned(), "–".to_owned()],
        };
        let range = nearest.determinant.map_or(["–".to_owned(), "–".to_owned()], |(low, high)| {
            [low, high].map(|x| number(&rounded_number_html(x, 3)))
        });
        let pairs = [nearest.relative, nearest.condition].into_iter().chain(nearest.divisors.iter().copied());
        let cells: Vec<String> = range.into_iter().chain(pairs.flat_map(pair)).collect();
        let cells = join_html(&cells, |cell| format!("<td class=\"n\">{cell}</td>"));
        let _ = writeln!(
            rows,
            "<tr{}><th scope=\"row\">{}</th>{cells}</tr>",
            standing_row_class(run, ""),
            standing::run_name_with_standing(run)
        );
    }
    let table = format!(
        "<table class=\"runs extremes\">\n<caption>Extremes at the samples of the runs</caption>\n{}<tbody>\n{rows}</tbody>\n\
         </table>\n",
        table_head(&columns)
    );
    scrolling_box("Extremes of determinants and condition numbers", &table)
}
