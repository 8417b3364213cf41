//! Section of the page that compares a published derivation with the derived equations: root mistakes, entries that
//! follow from them, and all verdicts.

use crate::page::content::Page;
use crate::page::markup::formula_mathml::{
    MathmlSide, breakable_mathml, formula_mathml_in_verdict, inline_mathml, widest,
};
use crate::page::markup::html::{breakable_id, escape, folded_html, join_html, table};
use crate::page::markup::typeset::{typeset, typeset_words};
use crate::page::model::derivation::named_terms;
use crate::page::model::proof::proof_witness_html;
use crate::page::print::entry_name::entry_name;
use crate::page::print::printed_motion;
use crate::phrases::entry_count_words;
use std::fmt::Write;
use tripos::studies::model_analysis::JudgedPublication;
use tripos_derive::algebra::Arena;
use tripos_derive::diff::{DependenceKind, DependentEntry, Difference, Finding, Judgement, RootMistake};

/// Verdicts in the order of the table of counts, each with the heading of its column.
const VERDICTS: [(&str, &str); 5] = [
    ("equal", "Equal"),
    ("scaled", "Equal up to a factor"),
    ("different", "Different"),
    ("undecided", "Undecided"),
    ("stated", "Stated only"),
];

/// Kinds of dependence on a root mistake, each with the words before the list of dependent entries.
const LINKS: [(DependenceKind, &str); 3] = [
    (DependenceKind::Repeated, "Repeated in"),
    (DependenceKind::Follows, "From it follow"),
    (DependenceKind::Contradicts, "It contradicts, directly or through others,"),
];

/// Largest number of visible characters of a printed term that is placed on a line with its label.
const WIDEST: usize = 80;

/// Returns the HTML section about the errata of a publication.
pub fn section(page: &Page, published: &JudgedPublication) -> String {
    let arena = &page.study.derivations.kinematics.arena;
    let difference = &published.difference;
    let mut out = format!(
        "<section id=\"errata\">\n<h2>Errata of the published derivation</h2>\n<p><strong>{}</strong>{}, transcribed as \
         printed: every entry is judged on its own against what is derived here, so an error counts where it is made.</p>\n",
        escape(published.publication.heading()),
        match published.publication.reference.as_str() {
            "" => String::new(),
            reference => format!(" ({})", escape(reference)),
        }
    );
    out += &verdict_counts_table(&difference.findings);
    if !difference.findings.iter().any(is_erratum) {
        out += "<p>Nothing is wrong.</p>\n";
    }
    out += &errata_root_mistakes(arena, difference);
    out += &undecided_errata(arena, &difference.findings);
    out += &scaled_errata(arena, &difference.findings);
    out += &errata_entry_list(&difference.findings);
    out += &printed_motion::motion_consequences(page, published);
    out += &named_terms(arena, &difference.shown_formulas());
    out + "</section>\n"
}

/// Returns the HTML id of a root mistake on the page. The index `root` counts from 0, the number in the id from 1.
pub fn anchor(root: usize) -> String {
    format!("mistake-{}", root + 1)
}

/// Returns the HTML of the root mistakes. The entries that follow from a mistake are folded under it.
fn errata_root_mistakes(arena: &Arena, difference: &Difference) -> String {
    let Difference { findings, roots, .. } = difference;
    if roots.is_empty() {
        return String::new();
    }
    let wrong = entry_count_words(difference.count("different"));
    let count =
        if roots.len() == 1 { "1 root mistake is".to_owned() } else { format!("{} root mistakes are", roots.len()) };
    let items: String = roots.iter().enumerate().map(|(at, root)| mistake(arena, findings, at, root)).collect();
    format!(
        "<h3 id=\"mistakes\">Root mistakes</h3>\n<p>{count} behind {wrong} that differ. An entry stands under another if it repeats its wrong value, or if the other's printed \
         value leads to exactly the printed entry. Numbers that contradict one another stand together. Any other wrong \
         entry is a root mistake of its own.</p>\n{items}"
    )
}

/// Returns the HTML of one root mistake: its description, the entries that repeat it or follow from it, and an erratum
/// for each entry.
fn mistake(arena: &Arena, findings: &[Finding], at: usize, root: &RootMistake) -> String {
    let shown = std::iter::once((root.finding, None)).chain(root.followers.iter().map(|f| (f.finding, Some(f))));
    let rows: String = shown
        .map(|(finding, by)| entry(arena, &findings[finding], by.map(|f| erratum_cause_html(findings, f))))
        .collect();
    format!(
        "<details id=\"{}\">\n<summary>{}. {}: {} <span class=\"quiet\">({})</span></summary>\n{}{}</details>\n",
        anchor(at),
        at + 1,
        entry_name(&findings[root.finding].id),
        typeset_words(&root.mistake),
        entry_count_words(root.entries()),
        join_html(&LINKS, |(link, words)| linked_errata_sentence(findings, root, *link, words)),
        errata("Its entries", &rows),
    )
}

/// Returns the HTML of a sentence with the entries that depend on a root mistake in the way `link`. Empty if there are
/// none.
fn linked_errata_sentence(findings: &[Finding], root: &RootMistake, link: DependenceKind, words: &str) -> String {
    let ids: Vec<String> = root.followers_by_link(link).map(|f| entry_id_html(findings, f.finding)).collect();
    if ids.is_empty() { String::new() } else { format!("<p>{words} {}.</p>\n", ids.join(", ")) }
}

/// Returns the HTML of an entry's id.
fn entry_id_html(findings: &[Finding], at: usize) -> String {
    format!("<code>{}</code>", escape(&findings[at].id))
}

/// Returns the HTML of words that name the entries from which a wrong entry follows.
fn erratum_cause_html(findings: &[Finding], follower: &DependentEntry) -> String {
    let ids = |list: &[usize]| list.iter().map(|at| entry_id_html(findings, *at)).collect::<Vec<_>>().join(" and ");
    let words = match follower.link {
        DependenceKind::Repeated => "repeats",
        DependenceKind::Follows => "follows from",
        DependenceKind::Contradicts => "contradicts",
    };
    let also =
        if follower.also.is_empty() { String::new() } else { format!("; comes of {} as well", ids(&follower.also)) };
    format!("{words} {}{also}", ids(&follower.from))
}

/// Returns the HTML of the entries whose verdict is undecided; empty if there are none.
fn undecided_errata(arena: &Arena, findings: &[Finding]) -> String {
    let open: Vec<&Finding> = findings.iter().filter(|f| matches!(f.judgement, Judgement::Undecided(_))).collect();
    if open.is_empty() {
        return String::new();
    }
    errata("What is not decided", &join_html(&open, |finding| entry(arena, finding, None)))
}

/// Returns the HTML of a table of errata. `caption` and `rows` are HTML.
fn errata(caption: &str, rows: &str) -> String {
    format!(
        "<table class=\"errata\">\n<caption>{caption}</caption>\n<colgroup><col class=\"entry\"><col class=\"label\"><col></colgroup>\n<thead><tr><th scope=\"col\">Entry</th>\
         <th scope=\"col\" colspan=\"2\">Printed and derived</th></tr></thead>\n{rows}</table>\n"
    )
}

/// True if an entry differs from the derived form or is undecided.
fn is_erratum(finding: &Finding) -> bool {
    matches!(finding.judgement, Judgement::Different | Judgement::Undecided(_))
}

/// Returns the HTML table with the number of entries for each verdict and section.
fn verdict_counts_table(findings: &[Finding]) -> String {
    let mut sections: Vec<&str> = Vec::new();
    for finding in findings {
        if !sections.contains(&finding.section.as_str()) {
            sections.push(&finding.section);
        }
    }
    let row = |label: String, of: &dyn Fn(&Finding) -> bool| {
        let count = |word: &str| findings.iter().filter(|f| of(f) && f.judgement.word() == word).count();
        let number = |n: usize| if n == 0 { "–".to_owned() } else { n.to_string() };
        let total = findings.iter().filter(|f| of(f)).count();
        let counts = VERDICTS.iter().map(|(word, _)| number(count(word)));
        [label, total.to_string()].into_iter().chain(counts).collect::<Vec<_>>()
    };
    let mut rows: Vec<_> =
        sections.iter().map(|section| row(escape(section), &|f: &Finding| f.section == *section)).collect();
    rows.push(row("<strong>all</strong>".to_owned(), &|_: &Finding| true));
    let columns = [&["Section", "Entries"][..], &VERDICTS.map(|(_, heading)| heading)].concat();
    table("Verdicts", &columns, &rows).replacen("<table>", "<table class=\"counts\">", 1)
}

/// Returns the HTML of one erratum: the entry's id, its printed and derived form, the difference, a state in which they
/// differ, and remarks. `source` names the entries from which it follows.
fn entry(arena: &Arena, finding: &Finding, source: Option<String>) -> String {
    let mut lines = vec![("printed", erratum_text_html(&finding.printed))];
    if let Some(derived) = finding.derived {
        // A row of a linear system has all of its terms on one side.
        let zero = if finding.printed.contains(" = ") {
            inline_mathml("<mo form=\"infix\">=</mo><mn>0</mn>")
        } else {
            String::new()
        };
        lines.push(("derived", format!("{} {zero}", formula_mathml_in_verdict(arena, derived))));
    }
    if let Some(difference) = finding.difference {
        lines.push(("printed − derived", formula_mathml_in_verdict(arena, difference)));
    }
    if let Some(factor) = finding.factor {
        lines.push(("factor", formula_mathml_in_verdict(arena, factor)));
    }
    // If the finding has no derived form, a remark names the form that was compared, and no witness is shown.
    if let (Some(found), true) = (&finding.witness, finding.derived.is_some()) {
        lines.push(("for instance", proof_witness_html(found, ["printed", "derived"])));
    }
    if let Judgement::Undecided(why) = &finding.judgement {
        lines.push(("undecided", escape(why)));
    }
    lines.extend(finding.remarks.iter().map(|remark| ("remark", escape(remark))));
    lines.extend(source.map(|words| ("root", words)));
    let head = format!(
        "<th scope=\"rowgroup\" rowspan=\"{}\"><code>{}</code><br><span class=\"quiet\">section {}</span></th>",
        lines.len(),
        breakable_id(&finding.id),
        escape(&finding.section),
    );
    let mut rows = String::new();
    for (at, (label, content)) in lines.iter().enumerate() {
        let head = if at == 0 { head.as_str() } else { "" };
        let _ = writeln!(rows, "<tr>{head}<td>{label}</td><td><div class=\"formula\">{content}</div></td></tr>");
    }
    format!("<tbody>\n{rows}</tbody>\n")
}

/// Returns the HTML of a printed text. It is typeset if it is a formula that fits on a line, else it is shown as code.
fn erratum_text_html(text: &str) -> String {
    match typeset(text) {
        Some(sides) if sides.iter().all(|side| widest(side) <= WIDEST) => {
            breakable_mathml(&sides.into_iter().map(MathmlSide::Marks).collect::<Vec<_>>())
        }
        _ => format!("<code>{}</code>", escape(text)),
    }
}

/// Returns the HTML of the entries that are right up to a factor, which are in rows of linear systems.
fn scaled_errata(arena: &Arena, findings: &[Finding]) -> String {
    let list: Vec<&Finding> = findings.iter().filter(|f| f.judgement == Judgement::Scaled).collect();
    if list.is_empty() {
        return String::new();
    }
    let item = |finding: &&Finding| {
        let by = finding
            .factor
            .map_or_else(|| escape(&finding.remarks.join("; ")), |factor| formula_mathml_in_verdict(arena, factor));
        format!("<li><code>{}</code> by {by}{}</li>\n", breakable_id(&finding.id), erratum_validity_words(finding))
    };
    let items = format!("<ul class=\"entries\">\n{}</ul>\n", join_html(&list, item));
    folded_html(
        &format!("Equal up to a factor <span class=\"quiet\">({})</span>", entry_count_words(list.len())),
        &items,
    )
}

/// Returns words for the states in which an entry holds; empty if it holds everywhere.
fn erratum_validity_words(finding: &Finding) -> String {
    finding.holds.words().map_or_else(String::new, |words| format!(" {words}"))
}

/// Returns the folded HTML list of all entries with their verdicts.
fn errata_entry_list(findings: &[Finding]) -> String {
    let item = |finding: &Finding| {
        let word = finding.judgement.word();
        let word =
            if is_erratum(finding) { format!("<strong class=\"wrong\">{word}</strong>") } else { word.to_owned() };
        format!("<li><code>{}</code> {word}{}</li>\n", breakable_id(&finding.id), erratum_validity_words(finding))
    };
    let items = format!("<ul class=\"entries\">\n{}</ul>\n", join_html(findings, item));
    folded_html(&format!("All entries <span class=\"quiet\">({})</span>", findings.len()), &items)
}
