//! Effect of the printed systems of equations on the motion: accelerations, determinants, first
//! integrals, and mutual agreement.

use crate::page::content::Page;
use crate::page::markup::formula_mathml::{formula_mathml_in_verdict, inline_mathml};
use crate::page::markup::html::{breakable_id, escape, foldable_part, folded_html, table};
use crate::page::model::proof::{proved_determinant_zeros, proved_integral_name, proved_integral_symbol};
use std::fmt::Write;
use tripos::studies::model_analysis::JudgedPublication;
use tripos_derive::algebra::meaning::compare::Verdict;
use tripos_derive::algebra::{Arena, Expr};
use tripos_derive::diff::{Consequences, Difference};
use tripos_derive::prove::Singularity;

/// Returns the HTML of the effects of the printed systems on the motion. Empty if no whole system is printed.
pub fn motion_consequences(page: &Page, published: &JudgedPublication) -> String {
    let list = &published.difference.consequences;
    if list.is_empty() {
        return String::new();
    }
    let mut out = String::from(
        "<h3 id=\"effects\">What the errors do to the motion</h3>\n<p>Each printed system, and each program, is solved for its \
         accelerations as it stands.</p>\n",
    );
    out += &printed_motions_overview(page, list);
    out += &printed_motions_agreement(&published.difference);
    let mut systems = String::new();
    for (system, singularity) in list.iter().zip(&published.singular) {
        let table = printed_system_table(page, system, singularity.as_ref());
        let first = published.first_equivalent_system(&system.system);
        systems += &if first == system.system {
            table
        } else {
            let (id, first) = (escape(&system.system), escape(first));
            folded_html(
                &format!("<code>{id}</code> <span class=\"quiet\">(the same motion as <code>{first}</code>)</span>"),
                &table,
            )
        };
    }
    out + &foldable_part("systems", "Determinants of each system, and rates of the first integrals", &systems)
}

/// Returns the HTML of a verdict in a table: the text `yes`, the text `no` in red, or "undecided".
fn printed_motion_verdict(verdict: &Verdict, yes: &str, no: &str) -> String {
    match verdict {
        Verdict::Equal(_) => yes.to_owned(),
        Verdict::Different(_) => format!("<strong class=\"wrong\">{no}</strong>"),
        Verdict::Undecided(_) => "undecided".to_owned(),
    }
}

/// Returns the HTML table with the verdicts on all printed systems, a row for each.
fn printed_motions_overview(page: &Page, list: &[Consequences]) -> String {
    let symbols: Vec<String> =
        (0..page.study.proof.integrals.len()).map(|at| inline_mathml(&proved_integral_symbol(at))).collect();
    let columns =
        ["Printed system", "Accelerations", "Determinant"].into_iter().chain(symbols.iter().map(String::as_str));
    let columns: Vec<&str> = columns.collect();
    let row = |system: &Consequences| {
        let determinant = system
            .determinant
            .as_ref()
            .map_or("–".to_owned(), |(.., v)| printed_motion_verdict(v, "as derived", "other"));
        let mut cells = vec![
            format!("<code>{}</code>", escape(&system.system)),
            printed_motion_verdict(&system.accelerations, "as derived", "other"),
            determinant,
        ];
        cells.extend(system.rates.iter().map(|rate| printed_motion_verdict(&rate.verdict, "kept", "broken")));
        cells.resize(columns.len(), "–".to_owned());
        cells
    };
    table("Printed systems at a glance", &columns, &list.iter().map(row).collect::<Vec<_>>())
}

/// Returns the HTML of sentences that name the printed systems with equal motions. Empty if no systems are compared.
fn printed_motions_agreement(difference: &Difference) -> String {
    let agreements = &difference.agreements;
    if agreements.is_empty() {
        return String::new();
    }
    let pairs = |of: fn(&Verdict) -> bool| {
        let pairs = agreements.iter().filter(|a| of(&a.verdict));
        pairs
            .map(|a| format!("<code>{}</code> and <code>{}</code>", escape(&a.left), escape(&a.right)))
            .collect::<Vec<_>>()
    };
    let same = pairs(Verdict::is_equal);
    let open = pairs(|v| matches!(v, Verdict::Undecided(_)));
    let mut sentences = vec!["Do they give the same motion as one another?".to_owned()];
    if same.len() == agreements.len() {
        sentences.push("Yes, all of them.".to_owned());
    } else if same.is_empty() {
        sentences.push("No two of them are proved to.".to_owned());
    } else {
        sentences.push(format!("These do: {}.", same.join("; ")));
    }
    if !open.is_empty() {
        sentences.push(format!("Undecided: {}.", open.join("; ")));
    }
    if same.len() + open.len() < agreements.len() {
        sentences.push("All other pairs differ.".to_owned());
    }
    format!("<p>{}</p>\n", sentences.join(" "))
}

/// Returns the HTML table about one printed system: accelerations, determinant, and rates of the first integrals.
fn printed_system_table(page: &Page, system: &Consequences, singularity: Option<&Singularity>) -> String {
    let arena = &page.study.derivations.kinematics.arena;
    let mut lines = vec![(
        "accelerations".to_owned(),
        printed_motion_verdict(&system.accelerations, "as derived", "not as derived"),
    )];
    if let Verdict::Undecided(why) = &system.accelerations {
        lines[0].1 = format!("undecided: {}", escape(why));
    }
    if let Some((printed, derived, verdict)) = &system.determinant {
        lines.extend(determinant(arena, *printed, *derived, verdict, singularity));
    }
    for (at, rate) in system.rates.iter().enumerate() {
        let name = format!(
            "{} <span class=\"quiet\">{}</span>",
            inline_mathml(&proved_integral_symbol(at)),
            proved_integral_name(page.model, arena, &rate.integral)
        );
        let content = match &rate.verdict {
            Verdict::Equal(_) => "kept".to_owned(),
            Verdict::Different(_) => format!(
                "<strong class=\"wrong\">broken</strong>: {} {}",
                inline_mathml(&format!("<mrow>{}<mo form=\"infix\">=</mo></mrow>", derivative(at))),
                formula_mathml_in_verdict(arena, rate.rate)
            ),
            Verdict::Undecided(why) => format!("undecided: {}", escape(why)),
        };
        lines.push((name, content));
    }
    let rows = lines.iter().fold(String::new(), |mut rows, (label, content)| {
        let _ =
            writeln!(rows, "<tr><th scope=\"row\">{label}</th><td><div class=\"formula\">{content}</div></td></tr>");
        rows
    });
    format!(
        "<table class=\"effects\">\n<caption><code>{}</code></caption>\n<colgroup><col class=\"name\"><col></colgroup>\n<tbody>\n{rows}</tbody>\n</table>\n",
        breakable_id(&system.system)
    )
}

/// Returns the MathML of the time derivative dI/dt of a first integral. `at` counts from 0.
fn derivative(at: usize) -> String {
    let d = "<mi mathvariant=\"normal\">d</mi>";
    format!("<mfrac><mrow>{d}{}</mrow><mrow>{d}<mi>t</mi></mrow></mfrac>", proved_integral_symbol(at))
}

/// Returns the table rows about the determinant of a printed system: its formula, the derived formula if it differs,
/// and its zeros.
fn determinant(
    arena: &Arena,
    printed: Expr,
    derived: Expr,
    verdict: &Verdict,
    singularity: Option<&Singularity>,
) -> Vec<(String, String)> {
    let mut lines = vec![("determinant".to_owned(), formula_mathml_in_verdict(arena, printed))];
    if !verdict.is_equal() {
        lines.push(("determinant, derived".to_owned(), formula_mathml_in_verdict(arena, derived)));
    }
    if let Some(singularity) = singularity {
        lines.push(("determinant is zero".to_owned(), proved_determinant_zeros(arena, singularity)));
    }
    lines
}
