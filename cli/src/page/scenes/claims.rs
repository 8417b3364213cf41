//! Claims about the motion of a scene on the page, with the verdicts of rigorous runs.

use crate::page::content::{ClaimOutcome, ClaimRow, SceneSection};
use crate::page::markup::html::{escape, number, rounded_number_html, table, words_html};

/// Returns the HTML of the claims about the motion of a scene, with their verdicts. Empty if the scene has none.
pub fn section(scene: &SceneSection) -> String {
    if scene.claims.is_empty() {
        return String::new();
    }
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
    format!(
        "<h4>What is proved about the motion</h4>\n<p>A rigorous run encloses the exact motion of each set of equations \
         in boxes. No error of an integration can change these verdicts; <code>tripos simulate {} --rigorous</code> \
         gives them too.</p>\n{}",
        escape(&scene.file),
        table("Claims at all instants of the scene", columns, &rows)
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
