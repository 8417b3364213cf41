//! Section of the page with claims about the motions of its scenes, and the verdicts of rigorous runs.

use crate::page::content::{ClaimOutcome, ClaimRow, Page, SceneSection};
use crate::page::markup::html::{escape, link, number, rounded_number_html, table, words_html};
use crate::page::scenes::scene::scene_anchor;

/// Returns the HTML section with the claims about the motions of all scenes, and their verdicts. Empty if no scene has
/// a claim.
pub fn section(page: &Page) -> String {
    let scenes = page.scenes.iter().enumerate().filter(|(_, scene)| !scene.claims.is_empty());
    let tables: String = scenes.map(|(at, scene)| claims_table(scene, at)).collect();
    if tables.is_empty() {
        return tables;
    }
    format!(
        "<section id=\"claims\">\n<h2>Claims about the motions</h2>\n<p>A rigorous run encloses the exact motion of each \
         set of equations in boxes. No error of an integration can change its verdicts.</p>\n{tables}</section>\n"
    )
}

/// Returns the HTML table of the claims about the motion of the scene with the index `at`.
fn claims_table(scene: &SceneSection, at: usize) -> String {
    let quotes = scene.claims.iter().any(|claim| !claim.printed.is_empty());
    let columns: &[&str] =
        if quotes { &["In print", "Claim", "Equations", "Verdict"] } else { &["Claim", "Equations", "Verdict"] };
    let row = |claim: &ClaimRow| {
        let about = match claim.about.as_str() {
            "" => String::new(),
            about => format!("<br><span class=\"quiet\">{}</span>", words_html(about)),
        };
        let mut cells = vec![
            format!("<code>{}</code>{about}", escape(&claim.claim)),
            escape(&claim.equations),
            outcome_html(&claim.outcome),
        ];
        if quotes {
            let printed = claim.printed.as_str();
            cells.insert(0, if printed.is_empty() { "–".to_owned() } else { format!("“{}”", escape(printed)) });
        }
        cells
    };
    let rows: Vec<Vec<String>> = scene.claims.iter().map(row).collect();
    let title = if scene.title.is_empty() { &scene.file } else { &scene.title };
    let command = format!("<p>Again: <code>tripos simulate {} --rigorous</code>.</p>\n", escape(&scene.file));
    format!(
        "<h3>{}</h3>\n{}{command}",
        link(&scene_anchor(at), &escape(title)),
        table("At all instants", columns, &rows)
    )
}

/// Returns the HTML of a verdict on a claim.
fn outcome_html(outcome: &ClaimOutcome) -> String {
    let instant = |t: f64| number(&rounded_number_html(t, 4));
    match outcome {
        ClaimOutcome::Proved => "proved".to_owned(),
        ClaimOutcome::Refuted { by } => {
            format!("<strong class=\"wrong\">false</strong>, at an instant before {} s", instant(*by))
        }
        ClaimOutcome::Open { proved_to: Some(t) } => format!("proved up to {} s, then open", instant(*t)),
        ClaimOutcome::Open { proved_to: None } => "open".to_owned(),
        ClaimOutcome::NotJudged(why) => format!("not judged: {}", escape(why)),
    }
}
