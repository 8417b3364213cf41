//! Command `tripos diff`: compares a model with a published derivation, or with an edited model.

mod certificate;
pub mod coordinates;
mod models;
mod root_mistakes;

pub use models::changed_equations;

use crate::commands::prove::{certificate_of_model, proof_verdict_word, proof_witness_json};
use crate::files::judged_publication::JudgedPublication;
use crate::files::output_files::{refuse_overwriting_inputs, write_text_file};
use crate::files::workspace::{model_file, read_model, short_name};
use crate::glossary::{glossary_json, glossary_text};
use crate::phrases::{entry_count_words, shorten_formula};
use crate::terminal::failure::{Failure, Output, print, print_json, print_result, print_to_stderr, status};
use serde_json::{Value, json};
use std::fmt::Write;
use std::path::{Path, PathBuf};
use tripos::Mechanism;
use tripos_derive::algebra::meaning::compare::Witness;
use tripos_derive::algebra::text::print::{print_text, print_whole_text};
use tripos_derive::algebra::{Arena, Expr};
use tripos_derive::diagnostic::Source;
use tripos_derive::diff::{Consequences, Difference, Finding, Judgement};
use tripos_derive::model::is_model;
use tripos_derive::plain_text::path_as_plain_text;

/// Result of a comparison of a model with one other file, as text and as JSON.
pub struct Comparison {
    /// True if the comparison found no difference.
    is_clean: bool,
    /// Report on the comparison as text, for the user.
    text: String,
    /// Report on the comparison as JSON, for other programs.
    json: Value,
}

/// Function that compares a model with another file: a publication or an edited model.
pub type Compare = fn(&Mechanism, &Path) -> Result<Comparison, Failure>;

/// Compares a model with each of the files `others` and prints the results. Returns the exit status, which is 1 if
/// anything differs. A file that cannot be compared does not stop the other comparisons. Its failure is printed, and
/// the highest exit status is returned.
///
/// # Errors
/// `Failure` if the model cannot be read, or if the only other file cannot be compared.
pub fn diff(model: &Path, others: &[PathBuf], compare: Compare, output: Output) -> Result<u8, Failure> {
    let model = read_model(model)?;
    if let [other] = others {
        let comparison = compare(&model, other)?;
        print_result(output, &comparison.text, &comparison.json)?;
        return Ok(if comparison.is_clean { 0 } else { status::NO });
    }
    let (mut code, mut list) = (0, Vec::new());
    for (at, other) in others.iter().enumerate() {
        let name = path_as_plain_text(other);
        let heading = format!("{}{name}\n", if at == 0 { "" } else { "\n" });
        let (lines, value) = match compare(&model, other) {
            Ok(Comparison { is_clean, text, json }) => {
                code = if is_clean { code } else { code.max(status::NO) };
                (heading + &text, json)
            }
            Err(failure) => {
                code = code.max(failure.status());
                if output == Output::Text {
                    print_to_stderr(&failure.to_string());
                }
                (format!("{heading}not compared: {}\n", failure.first_line()), failure.json())
            }
        };
        if output == Output::Text {
            print(&lines)?;
        }
        list.push(add_file_to_diff(value, &name));
    }
    if output == Output::Json {
        print_json(&json!({ "comparisons": list }))?;
    }
    Ok(code)
}

/// Adds the name of the compared file to a comparison in JSON.
fn add_file_to_diff(mut value: Value, file: &str) -> Value {
    value["file"] = json!(file);
    value
}

/// Compares a model with a publication file, or with a newer version of the model.
///
/// # Errors
/// `Failure` if a file cannot be read, or a model cannot be derived.
pub fn diff_with_file(model: &Mechanism, other: &Path) -> Result<Comparison, Failure> {
    let source = Source::read(&model_file(other))?;
    if is_model(&source) {
        return models::diff(model, &tripos_derive::model::load(&source)?);
    }
    Ok(verdicts(JudgedPublication::new(model, &source)?, None))
}

/// Compares a model with one publication, prints the verdicts, and writes a certificate of them to the file `path`.
/// Returns the exit status, which is 1 if an entry is different or undecided; the certificate is written then, too.
///
/// # Errors
/// `Failure` if a file cannot be read, if there is not exactly one publication, or if the model has no certificate.
pub fn diff_with_certificate(model: &Path, others: &[PathBuf], path: &Path, output: Output) -> Result<u8, Failure> {
    let [other] = others else {
        let help = "run the command once for each publication";
        return Err(Failure::request("a certificate is about one publication", help));
    };
    let model = read_model(model)?;
    let source = Source::read(&model_file(other))?;
    if is_model(&source) {
        let what = "--certificate is about a publication, and this file is a model";
        return Err(Failure::request(what, "name a publication file, or leave out --certificate"));
    }
    refuse_overwriting_inputs(&model, None, Some(path))?;
    certificate::refuse_overwriting_publication(&source, path)?;
    let Some(proof) = certificate_of_model(&model)? else {
        let what = "the formulations of the model are not proved equivalent, so that no verdict can be certified";
        return Err(Failure::request(what, "run `tripos prove` on the model to see which pair is not proved"));
    };
    let judged = JudgedPublication::new(&model, &source)?;
    write_text_file(path, &certificate::certificate_of_verdicts(&proof, &judged))?;
    let Comparison { is_clean, text, json } = verdicts(judged, None);
    print_result(output, &text, &json)?;
    Ok(if is_clean { 0 } else { status::NO })
}

/// Report on the search for the coordinates of a publication, as text and as JSON.
struct CoordinateReport {
    text: String,
    json: Value,
}

/// Returns the verdicts on a publication as a comparison. It begins with the report on the publication's coordinates,
/// if there is one.
fn verdicts(judged: JudgedPublication, coordinates: Option<CoordinateReport>) -> Comparison {
    let JudgedPublication { model, publication, mut derivations, proof, difference } = judged;
    difference.write_names(&proof, &mut derivations);
    let arena = &derivations.kinematics.arena;
    let mut json = json_of(&model, arena, &difference);
    let mut text = text_of(&model, &publication.title, arena, &difference);
    if let Some(report) = coordinates {
        json["coordinates"] = report.json;
        text.insert_str(0, &report.text);
    }
    Comparison { is_clean: difference.is_clean(), text, json }
}

/// Returns, as JSON, the verdicts on all entries of a publication, their consequences and the root mistakes.
pub fn json_of(model: &Mechanism, arena: &Arena, difference: &Difference) -> Value {
    let shown = |e: Option<Expr>| e.map(|e| print_whole_text(arena, e));
    let equations: Vec<Value> = difference
        .findings
        .iter()
        .map(|f| {
            // A printed number is no term, so that only its value is known.
            let number = |x: fn(&Witness) -> f64| f.witness.as_ref().map(|w| x(w).to_string());
            let mut value = json!({
                "id": f.id,
                "section": f.section,
                "verdict": f.judgement.word(),
                "holds": diff_validity_domain(f),
                "up_to": f.up_to,
                "factor": shown(f.factor),
                "printed": f.printed,
                "derived": shown(f.derived).or_else(|| number(|w| w.right)),
                "difference": shown(f.difference).or_else(|| number(|w| w.difference)),
                "witness": f.witness.as_ref().map(proof_witness_json),
                "remarks": f.remarks,
            });
            if let Judgement::Undecided(why) = &f.judgement {
                value["why"] = json!(why);
            }
            value
        })
        .collect();
    let mut consequences = Vec::new();
    let mut systems = Vec::new();
    for system in &difference.consequences {
        for rate in &system.rates {
            consequences.push(json!({
                "system": system.system,
                "integral": rate.integral.name(model, arena),
                "rate": print_whole_text(arena, rate.rate),
                "conserved": rate.verdict.is_equal(),
            }));
        }
        systems.push(json!({
            "system": system.system,
            "accelerations": proof_verdict_word(&system.accelerations),
            "determinant": system.determinant.as_ref().map(|(printed, derived, verdict)| json!({
                "printed": print_whole_text(arena, *printed),
                "derived": print_whole_text(arena, *derived),
                "verdict": proof_verdict_word(verdict),
            })),
        }));
    }
    let agreements: Vec<Value> = difference
        .agreements
        .iter()
        .map(|a| json!({ "left": a.left, "right": a.right, "verdict": proof_verdict_word(&a.verdict) }))
        .collect();
    json!({
        "model": short_name(model),
        "equations": equations,
        "consequences": consequences,
        "systems": systems,
        "agreements": agreements,
        "roots": root_mistakes::json_of(difference),
        "names": glossary_json(arena, &difference.shown_formulas()),
        "summary": summary(difference),
    })
}

/// Returns the states in which a right entry holds: `everywhere`, on the constraints, or in the domain of the model.
/// `None` for an entry that is not right.
fn diff_validity_domain(finding: &Finding) -> Option<&'static str> {
    let is_right = matches!(finding.judgement, Judgement::Equal | Judgement::Scaled);
    is_right.then(|| finding.holds.words().unwrap_or("everywhere"))
}

/// Returns, as JSON, the number of entries with each verdict.
fn summary(difference: &Difference) -> Value {
    let words = ["equal", "scaled", "different", "undecided", "stated"];
    let mut counts: serde_json::Map<String, Value> =
        words.iter().map(|w| ((*w).to_owned(), json!(difference.count(w)))).collect();
    counts.insert("entries".to_owned(), json!(difference.findings.len()));
    Value::Object(counts)
}

/// Returns the verdicts on all entries of a publication as text. `title` is the publication's
/// title.
fn text_of(model: &Mechanism, title: &str, arena: &Arena, difference: &Difference) -> String {
    let mut out = format!("{title}\nagainst {}\n", model.title);
    let mut section = "";
    out += &root_mistakes::root_mistake_list(difference);
    for (at, finding) in difference.findings.iter().enumerate() {
        if finding.section != section {
            section = &finding.section;
            let _ = writeln!(out, "\nSection {section}");
        }
        write_finding(&mut out, arena, finding);
        if let Some(words) = root_mistakes::cause_of_entry(difference, at) {
            let _ = writeln!(out, "    root        {words}");
        }
    }
    for system in &difference.consequences {
        let _ = writeln!(out, "\nWhat {} makes of the motion", system.system);
        let verdict = match proof_verdict_word(&system.accelerations) {
            "equal" => "are the derived ones",
            "different" => "are not the derived ones",
            _ => "could not be compared",
        };
        let _ = writeln!(out, "  accelerations {verdict}");
        if let Some((printed, expected, verdict)) = &system.determinant {
            let relation = if verdict.is_equal() { "as derived" } else { "DIFFERENT" };
            let _ = writeln!(out, "  determinant {relation}: {}", shorten_formula(&print_text(arena, *printed)));
            if !verdict.is_equal() {
                let _ = writeln!(out, "    derived: {}", shorten_formula(&print_text(arena, *expected)));
            }
        }
        for rate in &system.rates {
            let integral = rate.integral.name(model, arena);
            if rate.verdict.is_equal() {
                let _ = writeln!(out, "  conserves {integral}");
            } else {
                let _ =
                    writeln!(out, "  BREAKS {integral}\n    d/dt = {}", shorten_formula(&print_text(arena, rate.rate)));
            }
        }
    }
    if !difference.agreements.is_empty() {
        out.push_str("\nDo the printed systems give the same motion?\n");
    }
    for a in &difference.agreements {
        let answer = match proof_verdict_word(&a.verdict) {
            "equal" => "yes",
            "different" => "no",
            _ => "undecided",
        };
        let _ = writeln!(out, "  {} and {}: {answer}", a.left, a.right);
    }
    out += &glossary_text(arena, &formulas_in_report(difference));
    let count = |word| difference.count(word);
    let _ = writeln!(
        out,
        "\n{}: {} equal, {} scaled, {} different, {} undecided, {} stated",
        entry_count_words(difference.findings.len()),
        count("equal"),
        count("scaled"),
        count("different"),
        count("undecided"),
        count("stated")
    );
    out
}

/// Lists the formulas in the text report, so that the names in them can be defined.
fn formulas_in_report(difference: &Difference) -> Vec<Expr> {
    let findings = difference.findings.iter().flat_map(|f| match f.judgement {
        Judgement::Scaled => f.factor.into_iter().collect(),
        Judgement::Different => f.shown_formulas().collect(),
        _ => Vec::new(),
    });
    findings.chain(difference.consequences.iter().flat_map(Consequences::shown_formulas)).collect()
}

/// Returns words for the permitted difference of an entry and for the states in which it holds. Empty if it holds
/// exactly and everywhere.
fn validity_text(finding: &Finding) -> String {
    let words: Vec<&str> = finding.up_to.into_iter().chain(finding.holds.words()).collect();
    if words.is_empty() { String::new() } else { format!("  {}", words.join(", ")) }
}

/// Writes the verdict on an entry. For a wrong entry, its printed form, its derived form, a state in which they differ
/// and remarks are added.
fn write_finding(out: &mut String, arena: &Arena, f: &Finding) {
    match &f.judgement {
        Judgement::Equal | Judgement::Stated => {
            let _ = writeln!(out, "  {:9} {}{}", f.judgement.word(), f.id, validity_text(f));
        }
        Judgement::Scaled => {
            let by = f.factor.map_or_else(|| f.remarks.join("; "), |factor| print_text(arena, factor));
            let _ = writeln!(out, "  scaled    {}  by {by}{}", f.id, validity_text(f));
        }
        Judgement::Undecided(why) => {
            let _ = writeln!(out, "  UNDECIDED {}: {why}", f.id);
        }
        Judgement::Different => {
            let _ = writeln!(out, "  DIFFERENT {}\n    printed     {}", f.id, f.printed);
            if let Some(derived) = f.derived {
                let _ = writeln!(out, "    derived     {}", print_text(arena, derived));
            }
            if let Some(difference) = f.difference {
                let _ = writeln!(out, "    difference  {}", print_text(arena, difference));
            }
            if let Some(factor) = f.factor {
                let _ = writeln!(out, "    factor      {}", print_text(arena, factor));
            }
            if let Some(w) = &f.witness {
                let at: Vec<String> = w.at.iter().map(|(name, x)| format!("{name} = {x}")).collect();
                let place = if at.is_empty() { String::new() } else { format!(" at {}", at.join(", ")) };
                let _ = writeln!(out, "    witness     {} against {}{place}", w.left, w.right);
            }
            for remark in &f.remarks {
                let _ = writeln!(out, "    {remark}");
            }
        }
    }
}
