//! Command `tripos grade`: gives marks and feedback for submissions, based on their root mistakes.

use crate::arguments::{Grade as Request, MarksFormat};
use crate::files::judged_publication::JudgedPublication;
use crate::files::output_files;
use crate::files::workspace::{read_model, short_name};
use crate::page::markup::html::escape;
use crate::terminal::failure::{Failure, print, print_json, status};
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::{Path, PathBuf};
use tripos::Mechanism;
use tripos_derive::diagnostic::Source;
use tripos_derive::diff::grade::{FeedbackLevel, Grade, Mark, Outcome, Rubric, grade as graded};
use tripos_derive::plain_text::path_as_plain_text;

/// Largest size of a submission that is read, in bytes.
const LARGEST: u64 = 1_000_000;

/// Submission with its marks, or with the reason why it has none.
struct GradedSubmission {
    /// Name of the submission's file, without its extension.
    name: String,
    /// Marks of the submission; `Err` is the reason why there are none.
    grade: Result<Grade, String>,
}

/// Runs `tripos grade`: judges submissions and prints their marks. Returns the exit status, 1 if
/// any submission has a mistake or could not be read.
///
/// # Errors
/// `Failure` if the model, the rubric or a folder cannot be read, or a file cannot be written.
pub fn grade(request: &Request) -> Result<u8, Failure> {
    let model = read_model(&request.model)?;
    let rubric = match &request.rubric {
        Some(path) => Rubric::load(&Source::read(path)?)?,
        None => Rubric::default(),
    };
    let level = feedback_level(request, &rubric)?;
    let files = files(&request.submissions)?;
    let list: Vec<GradedSubmission> = files.iter().map(|file| submission(&model, &rubric, file)).collect();
    let format = if request.json { MarksFormat::Json } else { request.format };
    match format {
        MarksFormat::Text => print(&text_of(&list, level))?,
        MarksFormat::Json => print_json(&json!({
            "model": short_name(&model),
            "level": FeedbackLevel::ALL.iter().find(|(own, _)| *own == level).map(|(_, name)| name),
            "submissions": list.iter().map(|one| json_of(one, level)).collect::<Vec<_>>(),
        }))?,
        MarksFormat::Gradescope => {
            let [one] = list.as_slice() else {
                let help = "give one submission: Gradescope runs the grader once for each";
                return Err(Failure::request(format!("{} for `--format gradescope`", list.len()), help));
            };
            print(&format!("{:#}\n", gradescope(one, level)))?;
        }
    }
    if let Some(out) = &request.out {
        output_files::write_text_file(out, &grades_page(&model, &list))?;
    }
    let is_right = |one: &GradedSubmission| one.grade.as_ref().is_ok_and(|grade| grade.marks.iter().all(is_right));
    Ok(if list.iter().all(is_right) { 0 } else { status::NO })
}

/// True if the submission's entry is right.
fn is_right(mark: &Mark) -> bool {
    mark.outcome == Outcome::Right
}

/// Returns the level of detail of the feedback: the level of the command line, or else that of the rubric. `Err` if the
/// command line names an unknown level.
fn feedback_level(request: &Request, rubric: &Rubric) -> Result<FeedbackLevel, Failure> {
    let Some(name) = &request.level else { return Ok(rubric.level.unwrap_or_default()) };
    FeedbackLevel::feedback_level_by_name(name).ok_or_else(|| {
        let help = "give `hint`, `place` or `term`";
        Failure::request(
            format!("there is no level `{}`", tripos_derive::diagnostic::shortened_for_message(name)),
            help,
        )
    })
}

/// Lists the files of all submissions. For a folder, these are its TOML files, in alphabetical order.
///
/// # Errors
/// `Failure` if a folder cannot be read or has no submission.
fn files(given: &[PathBuf]) -> Result<Vec<PathBuf>, Failure> {
    let mut files = Vec::new();
    for path in given {
        if !path.is_dir() {
            files.push(path.clone());
            continue;
        }
        let failed = |error| {
            Failure::request(format!("{}: {error}", path_as_plain_text(path)), "give a folder that can be read")
        };
        let mut inside = Vec::new();
        for entry in std::fs::read_dir(path).map_err(failed)? {
            let file = entry.map_err(failed)?.path();
            if file.extension().is_some_and(|ending| ending == "toml") {
                inside.push(file);
            }
        }
        if inside.is_empty() {
            let what = format!("{} has no submission", path_as_plain_text(path));
            return Err(Failure::request(what, "a submission is a TOML file, as docs/publication.md describes it"));
        }
        inside.sort();
        files.extend(inside);
    }
    Ok(files)
}

/// Judges one submission. If this fails, the reason is stored instead of marks.
fn submission(model: &Mechanism, rubric: &Rubric, file: &Path) -> GradedSubmission {
    let name = file.file_stem().map_or_else(|| path_as_plain_text(file), |stem| stem.to_string_lossy().into_owned());
    GradedSubmission { name, grade: grade_submission(model, rubric, file).map_err(|failure| failure.to_string()) }
}

/// Judges one submission file and returns its marks.
///
/// # Errors
/// `Failure` if the file is too large, cannot be read, or is no publication of the model.
fn grade_submission(model: &Mechanism, rubric: &Rubric, file: &Path) -> Result<Grade, Failure> {
    if std::fs::metadata(file).is_ok_and(|about| about.len() > LARGEST) {
        let what = format!("{} has more than {LARGEST} bytes", path_as_plain_text(file));
        return Err(Failure::request(what, "a submission is a text of some pages"));
    }
    Ok(graded(&JudgedPublication::new(model, &Source::read(file)?)?.difference, rubric))
}

/// Returns points as text with at most two decimals, without trailing zeros.
fn points(x: f64) -> String {
    let text = format!("{x:.2}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// Returns a word for the outcome of an entry, and feedback on it at the level of detail `level`.
fn mark_words(mark: &Mark, level: FeedbackLevel) -> (&'static str, String) {
    match &mark.outcome {
        Outcome::Right => ("right", String::new()),
        Outcome::Mistake(feedback) => ("WRONG", feedback.words(level)),
        Outcome::Follows(from) => ("follows", format!("from {from}, which is wrong")),
        Outcome::Undecided(why) => ("look", format!("not decided: {why}")),
        Outcome::Lacking => ("LACKING", "the submission does not have it".to_owned()),
    }
}

/// Returns the marks of all submissions as text, and a list of who made which mistake.
fn text_of(list: &[GradedSubmission], level: FeedbackLevel) -> String {
    let mut out = String::new();
    for one in list {
        match &one.grade {
            Err(why) => {
                let _ = writeln!(out, "{}: not read\n{why}\n", one.name);
            }
            Ok(grade) => {
                let _ = writeln!(out, "{}: {} of {} points", one.name, points(grade.points), points(grade.of));
                for mark in &grade.marks {
                    let (outcome, feedback) = mark_words(mark, level);
                    let feedback = if feedback.is_empty() { feedback } else { format!(": {feedback}") };
                    let _ = writeln!(out, "  {outcome:8} {}{feedback}", mark.id);
                }
                out.push('\n');
            }
        }
    }
    if list.len() > 1 {
        out += "Who made which mistake\n";
        for ((id, term), names) in submissions_by_mistake(list) {
            let _ = writeln!(out, "  {id}: {term}\n    {}", names.join(", "));
        }
    }
    out
}

/// Groups the submissions by their mistakes. The key is the id of the wrong entry with the description of the mistake.
fn submissions_by_mistake(list: &[GradedSubmission]) -> BTreeMap<(&str, &str), Vec<&str>> {
    let mut found: BTreeMap<(&str, &str), Vec<&str>> = BTreeMap::new();
    for one in list {
        for mark in one.grade.iter().flat_map(|grade| &grade.marks) {
            if let Outcome::Mistake(feedback) = &mark.outcome {
                found.entry((&mark.id, &feedback.term)).or_default().push(&one.name);
            }
        }
    }
    found
}

/// Returns the marks of a submission as JSON.
fn json_of(one: &GradedSubmission, level: FeedbackLevel) -> Value {
    let grade = match &one.grade {
        Ok(grade) => grade,
        Err(why) => return json!({ "name": one.name, "error": why }),
    };
    let entries: Vec<Value> = grade
        .marks
        .iter()
        .map(|mark| {
            let (outcome, feedback) = mark_words(mark, level);
            let term = match &mark.outcome {
                Outcome::Mistake(feedback) => Some(feedback.term.as_str()),
                _ => None,
            };
            json!({
                "id": mark.id, "points": mark.points, "of": mark.of, "outcome": outcome.to_lowercase(),
                "feedback": feedback, "mistake": term,
            })
        })
        .collect();
    json!({ "name": one.name, "points": grade.points, "of": grade.of, "entries": entries })
}

/// Returns the marks of a submission in the format of Gradescope's `results.json`, with one test for each entry. A
/// student sees only the feedback.
fn gradescope(one: &GradedSubmission, level: FeedbackLevel) -> Value {
    let grade = match &one.grade {
        Ok(grade) => grade,
        Err(why) => return json!({ "score": 0, "output": why, "output_format": "text" }),
    };
    let tests: Vec<Value> = grade
        .marks
        .iter()
        .map(|mark| {
            let (outcome, feedback) = mark_words(mark, level);
            let status = if mark.points < mark.of { "failed" } else { "passed" };
            json!({
                "name": mark.id, "score": mark.points, "max_score": mark.of, "status": status,
                "output": if feedback.is_empty() { outcome.to_owned() } else { format!("{}: {feedback}", outcome.to_lowercase()) },
            })
        })
        .collect();
    json!({ "score": grade.points, "output_format": "text", "tests": tests })
}

/// Returns an HTML page about all submissions: marks, and who made which mistake.
fn grades_page(model: &Mechanism, list: &[GradedSubmission]) -> String {
    let title = format!(
        "{}: {} {}",
        escape(&model.title),
        list.len(),
        if list.len() == 1 { "submission" } else { "submissions" }
    );
    let mut out = format!(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" content=\"width=device-width\">\n\
         <meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'\">\n<title>{title}</title>\n\
         <style>body{{font:1rem/1.5 system-ui,sans-serif;max-width:60rem;margin:2rem auto;padding:0 1rem;color-scheme:light dark}}\
         table{{border-collapse:collapse;width:100%}}th,td{{text-align:left;padding:.3rem .6rem;border-bottom:1px solid #8886;vertical-align:top}}\
         td.n{{text-align:right;white-space:nowrap}}code{{font-size:.95em;overflow-wrap:anywhere}}</style>\n</head>\n<body>\n<h1>{title}</h1>\n"
    );
    out += "<h2>Who made which mistake</h2>\n<table>\n<tr><th>Entry</th><th>Mistake</th><th>Submissions</th></tr>\n";
    for ((id, term), names) in submissions_by_mistake(list) {
        let names: Vec<String> = names.into_iter().map(escape).collect();
        let _ = writeln!(
            out,
            "<tr><td>{}</td><td><code>{}</code></td><td>{}: {}</td></tr>",
            escape(id),
            escape(term),
            names.len(),
            names.join(", ")
        );
    }
    out += "</table>\n<h2>Marks</h2>\n<table>\n<tr><th>Submission</th><th>Points</th><th>Not right</th></tr>\n";
    for one in list {
        let (marks, remarks) = match &one.grade {
            Err(why) => ("not read".to_owned(), escape(why)),
            Ok(grade) => {
                let wrong = grade.marks.iter().filter(|mark| !is_right(mark)).map(|mark| {
                    let (outcome, feedback) = mark_words(mark, FeedbackLevel::Term);
                    format!("{} {}: <code>{}</code>", outcome.to_lowercase(), escape(&mark.id), escape(&feedback))
                });
                let list = wrong.collect::<Vec<_>>().join("<br>");
                (format!("{} of {}", points(grade.points), points(grade.of)), list)
            }
        };
        let _ = writeln!(out, "<tr><td>{}</td><td class=\"n\">{marks}</td><td>{remarks}</td></tr>", escape(&one.name));
    }
    out + "</table>\n</body>\n</html>\n"
}
