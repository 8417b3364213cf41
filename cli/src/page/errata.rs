//! A published derivation against the derived one: what is wrong, entry by entry, and what that does to the motion.

use super::content::Page;
use super::html::{breakable, each, escape, folded, table};
use super::math::{Side, inline, value, widest, wrapped};
use super::motion;
use super::proof::witness;
use super::typeset::typeset;
use crate::words::entries;
use std::fmt::Write;
use tripos::study::Published;
use tripos_derive::algebra::Arena;
use tripos_derive::diff::{Finding, Judgement};

/// Verdicts in the order of the counts, with the words of a heading.
const VERDICTS: [(&str, &str); 5] = [
    ("equal", "Equal"),
    ("scaled", "Equal up to a factor"),
    ("different", "Different"),
    ("undecided", "Undecided"),
    ("stated", "Stated only"),
];

/// Entries that are seen at once.
const SEEN: usize = 3;
/// Visible characters of a printed term that fit beside its label.
const WIDEST: usize = 80;

/// The section.
pub fn section(page: &Page, published: &Published) -> String {
    let arena = &page.study.derivations.kinematics.arena;
    let difference = &published.difference;
    let mut out = format!(
        "<section id=\"errata\">\n<h2>Errata of the published derivation</h2>\n<p><strong>{}</strong>{}, transcribed as \
         printed: every entry is judged on its own against what is derived here, so an error counts where it is made.</p>\n",
        escape(&published.report.title),
        match published.report.reference.as_str() {
            "" => String::new(),
            reference => format!(" ({})", escape(reference)),
        }
    );
    out += &counts(&difference.findings);
    let wrong: Vec<&Finding> = difference.findings.iter().filter(|f| is_wrong(f)).collect();
    if wrong.is_empty() {
        out += "<p>Nothing is wrong.</p>\n";
    } else {
        let table = format!(
            "<table class=\"errata\">\n<caption>What is wrong</caption>\n<colgroup><col class=\"entry\"><col class=\"label\"><col></colgroup>\n<thead><tr><th scope=\"col\">Entry</th>\
             <th scope=\"col\" colspan=\"2\">Printed and derived</th></tr></thead>\n{}</table>\n",
            each(&wrong, |finding| entry(arena, finding))
        );
        let summary = format!("What is wrong <span class=\"quiet\">({})</span>", entries(wrong.len()));
        out += &if wrong.len() > SEEN { folded(&summary, &table) } else { table };
    }
    out += &scaled(arena, &difference.findings);
    out += &all(&difference.findings);
    out += &motion::consequences(page, published);
    out + "</section>\n"
}

fn is_wrong(finding: &Finding) -> bool {
    matches!(finding.judgement, Judgement::Different | Judgement::Undecided(_))
}

/// How many entries of each section have which verdict.
fn counts(findings: &[Finding]) -> String {
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

/// One erratum: the entry beside a line each for what is printed, what is derived, and so on.
fn entry(arena: &Arena, finding: &Finding) -> String {
    let mut lines = vec![("printed", printed(&finding.printed))];
    if let Some(derived) = finding.derived {
        // Of a row of a linear system: everything on one side.
        let zero =
            if finding.printed.contains(" = ") { inline("<mo form=\"infix\">=</mo><mn>0</mn>") } else { String::new() };
        lines.push(("derived", format!("{} {zero}", value(arena, derived))));
    }
    if let Some(difference) = finding.difference {
        lines.push(("printed − derived", value(arena, difference)));
    }
    if let Some(factor) = finding.factor {
        lines.push(("factor", value(arena, factor)));
    }
    // Where nothing is derived, a remark says what it is compared with.
    if let (Some(found), true) = (&finding.witness, finding.derived.is_some()) {
        lines.push(("for instance", witness(found, ["printed", "derived"])));
    }
    if let Judgement::Undecided(why) = &finding.judgement {
        lines.push(("undecided", escape(why)));
    }
    lines.extend(finding.remarks.iter().map(|remark| ("remark", escape(remark))));
    let head = format!(
        "<th scope=\"rowgroup\" rowspan=\"{}\"><code>{}</code><br><span class=\"quiet\">section {}</span></th>",
        lines.len(),
        breakable(&finding.id),
        escape(&finding.section),
    );
    let mut rows = String::new();
    for (at, (label, content)) in lines.iter().enumerate() {
        let head = if at == 0 { head.as_str() } else { "" };
        let _ = writeln!(rows, "<tr>{head}<td>{label}</td><td><div class=\"formula\">{content}</div></td></tr>");
    }
    format!("<tbody>\n{rows}</tbody>\n")
}

/// What is printed: typeset where it is a formula that fits.
fn printed(text: &str) -> String {
    match typeset(text) {
        Some(sides) if sides.iter().all(|side| widest(side) <= WIDEST) => {
            wrapped(&sides.into_iter().map(Side::Marks).collect::<Vec<_>>())
        }
        _ => format!("<code>{}</code>", escape(text)),
    }
}

/// Entries that are right but for a factor: of the row of a linear system.
fn scaled(arena: &Arena, findings: &[Finding]) -> String {
    let list: Vec<&Finding> = findings.iter().filter(|f| f.judgement == Judgement::Scaled).collect();
    if list.is_empty() {
        return String::new();
    }
    let item = |finding: &&Finding| {
        let by = finding.factor.map_or_else(|| escape(&finding.remarks.join("; ")), |factor| value(arena, factor));
        format!("<li><code>{}</code> by {by}</li>\n", breakable(&finding.id))
    };
    let items = format!("<ul class=\"entries\">\n{}</ul>\n", each(&list, item));
    folded(&format!("Equal up to a factor <span class=\"quiet\">({})</span>", entries(list.len())), &items)
}

fn all(findings: &[Finding]) -> String {
    let item = |finding: &Finding| {
        let word = finding.judgement.word();
        let word = if is_wrong(finding) { format!("<strong class=\"wrong\">{word}</strong>") } else { word.to_owned() };
        format!("<li><code>{}</code> {word}</li>\n", breakable(&finding.id))
    };
    let items = format!("<ul class=\"entries\">\n{}</ul>\n", each(findings, item));
    folded(&format!("All entries <span class=\"quiet\">({})</span>", findings.len()), &items)
}
