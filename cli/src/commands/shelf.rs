//! Command `tripos shelf`: judges all publications of a folder, and writes a page about them.

mod motion;

use crate::files::judged_publication::JudgedPublication;
use crate::files::output_files;
use crate::files::workspace::{current_folder, read_model, workspace_around};
use crate::page::markup::html::escape;
use crate::phrases::{entry_count_words, shorten_formula};
use crate::terminal::failure::{Failure, Output, print_result, status};
use motion::{ShelvedMotion, motions};
use serde_json::{Value, json};
use std::fmt::Write;
use std::path::{Path, PathBuf};
use tripos_derive::diagnostic::Source;
use tripos_derive::plain_text::path_as_plain_text;

/// Publication in the judged folder, with its verdict or the reason why it has none.
struct ShelvedPublication {
    /// Name of the publication's folder.
    name: String,
    /// Verdict on the publication; `Err` is the reason why it could not be judged.
    verdict: Result<ShelfVerdict, String>,
}

/// Verdict on the equations that a publication prints, in the form in which the list of publications shows it.
struct ShelfVerdict {
    /// Title of the publication, for its heading in the list.
    title: String,
    /// Bibliographic reference of the publication.
    source: String,
    /// Number of the publication's entries that were judged.
    judged: usize,
    /// Number of entries whose verdict is undecided.
    undecided: usize,
    /// Root mistakes: the id of the wrong entry, a description of the mistake, and the number of entries that it makes
    /// wrong.
    mistakes: Vec<(String, String, usize)>,
    /// Pairs of a printed system and a first integral of the right motion that the system violates.
    broken: Vec<(String, String)>,
    /// Motions by wrong printed systems, compared with the right motion.
    motions: Vec<ShelvedMotion>,
}

impl ShelfVerdict {
    /// Creates the verdict from the judged entries of a publication.
    fn new(judged: &JudgedPublication, motions: Vec<ShelvedMotion>) -> Self {
        let JudgedPublication { model, publication, derivations, difference, .. } = judged;
        let mistake = |root: &tripos_derive::diff::RootMistake| {
            (difference.findings[root.finding].id.clone(), root.mistake.clone(), root.entries())
        };
        let broken = difference.consequences.iter().flat_map(|system| {
            let rates = system.rates.iter().filter(|rate| !rate.verdict.is_equal());
            rates.map(|rate| (system.system.clone(), rate.integral.name(model, &derivations.kinematics.arena)))
        });
        Self {
            title: publication.heading().to_owned(),
            source: publication.reference.clone(),
            judged: difference.findings.len() - difference.count("stated"),
            undecided: difference.count("undecided"),
            mistakes: difference.roots.iter().map(mistake).collect(),
            broken: broken.collect(),
            motions,
        }
    }

    /// True if the publication has no mistake and every entry is decided.
    fn is_right(&self) -> bool {
        self.mistakes.is_empty() && self.undecided == 0
    }

    /// Returns the verdict in words, such as "right" or "2 differences". A difference may be an intended approximation
    /// by the author.
    fn words(&self) -> String {
        match (self.mistakes.len(), self.undecided) {
            (0, 0) => "right".to_owned(),
            (0, _) => "not decided".to_owned(),
            (1, _) => "1 difference".to_owned(),
            (count, _) => format!("{count} differences"),
        }
    }
}

/// Runs `tripos shelf`: judges every folder with a model and a publication, and writes a page to `out`. Returns the
/// exit status, which is 1 if a publication cannot be judged or decided. Mistakes do not affect the exit status.
///
/// # Errors
/// `Failure` if there is no publication, if a folder cannot be read, or if a file cannot be written.
pub fn shelf(folder: Option<&Path>, out: Option<&Path>, output: Output) -> Result<u8, Failure> {
    let folder = folder.map_or_else(workspace_publications, |folder| Ok(folder.to_owned()))?;
    let volumes: Vec<ShelvedPublication> =
        publication_folders(&folder)?.iter().map(|folder| judge_publication(folder)).collect();
    print_result(output, &text_of(&volumes), &json_of(&volumes))?;
    if let Some(out) = out {
        output_files::write_text_file(out, &page(&volumes))?;
    }
    let is_judged = |volume: &ShelvedPublication| volume.verdict.as_ref().is_ok_and(|verdict| verdict.undecided == 0);
    Ok(if volumes.iter().all(is_judged) { 0 } else { status::NO })
}

/// Returns the folder `publications` of the workspace around the current folder.
///
/// # Errors
/// `Failure` if there is no such folder.
fn workspace_publications() -> Result<PathBuf, Failure> {
    let here = current_folder()?;
    let found = workspace_around(&here).map(|root| root.join("publications")).filter(|folder| folder.is_dir());
    found.ok_or_else(|| {
        Failure::request("there is no folder `publications` here", "give a folder with a folder for each publication")
    })
}

/// Lists the folders inside `shelf` that contain a model and a publication, in alphabetical order.
///
/// # Errors
/// `Failure` if the folder cannot be read or contains no publication.
fn publication_folders(shelf: &Path) -> Result<Vec<PathBuf>, Failure> {
    let failed =
        |error| Failure::request(format!("{}: {error}", path_as_plain_text(shelf)), "give a folder that can be read");
    let mut list = Vec::new();
    for entry in std::fs::read_dir(shelf).map_err(failed)? {
        let folder = entry.map_err(failed)?.path();
        if folder.join("model.toml").is_file() && folder.join("publication.toml").is_file() {
            list.push(folder);
        }
    }
    if list.is_empty() {
        let what = format!("{} has no folder with model.toml and publication.toml", path_as_plain_text(shelf));
        return Err(Failure::request(what, "docs/shelf.md describes a shelf"));
    }
    list.sort();
    Ok(list)
}

/// Judges the publication in a folder. If this fails, the reason is stored instead of a verdict.
fn judge_publication(folder: &Path) -> ShelvedPublication {
    let name = folder.file_name().unwrap_or_default().to_string_lossy().into_owned();
    let judged = || -> Result<ShelfVerdict, Failure> {
        let model = read_model(folder)?;
        let judged = JudgedPublication::new(&model, &Source::read(&folder.join("publication.toml"))?)?;
        Ok(ShelfVerdict::new(&judged, motions(folder, &judged)?))
    };
    ShelvedPublication { name, verdict: judged().map_err(|failure| failure.to_string()) }
}

/// Returns the verdicts on all publications as text.
fn text_of(volumes: &[ShelvedPublication]) -> String {
    let mut out = String::new();
    for ShelvedPublication { name, verdict } in volumes {
        let verdict = match verdict {
            Ok(verdict) => verdict,
            Err(why) => {
                let _ = writeln!(out, "{name}: not judged\n{why}\n");
                continue;
            }
        };
        let _ =
            writeln!(out, "{name}: {} ({})\n  {}", verdict.words(), entry_count_words(verdict.judged), verdict.title);
        for (id, mistake, count) in &verdict.mistakes {
            let more =
                if *count > 1 { format!(", and {} more by it", entry_count_words(count - 1)) } else { String::new() };
            let _ = writeln!(out, "  {id}{more}: {}", shorten_formula(mistake));
        }
        for (system, integral) in &verdict.broken {
            let _ = writeln!(out, "  {system} breaks {integral}");
        }
        for motion in &verdict.motions {
            let _ = writeln!(out, "  {}", motion.words());
        }
    }
    let right = volumes.iter().filter(|v| v.verdict.as_ref().is_ok_and(ShelfVerdict::is_right)).count();
    let mistakes: usize = volumes.iter().filter_map(|v| v.verdict.as_ref().ok()).map(|v| v.mistakes.len()).sum();
    let _ = writeln!(out, "\n{} publications: {right} right, {mistakes} differences in the others", volumes.len());
    out
}

/// Returns the verdicts on all publications as JSON.
fn json_of(volumes: &[ShelvedPublication]) -> Value {
    let one = |ShelvedPublication { name, verdict }: &ShelvedPublication| match verdict {
        Err(why) => json!({ "name": name, "error": why }),
        Ok(v) => json!({
            "name": name,
            "title": v.title,
            "source": v.source,
            "verdict": v.words(),
            "entries": v.judged,
            "undecided": v.undecided,
            "mistakes": v.mistakes.iter()
                .map(|(id, mistake, count)| json!({ "id": id, "mistake": mistake, "entries": count })).collect::<Vec<_>>(),
            "breaks": v.broken.iter()
                .map(|(system, integral)| json!({ "system": system, "integral": integral })).collect::<Vec<_>>(),
            "motions": v.motions.iter().map(ShelvedMotion::json).collect::<Vec<_>>(),
        }),
    };
    json!({ "publications": volumes.iter().map(one).collect::<Vec<_>>() })
}

/// Returns an HTML page with one article for each publication.
fn page(volumes: &[ShelvedPublication]) -> String {
    let mut out = "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
                   <meta name=\"viewport\" content=\"width=device-width\">\n\
                   <meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'\">\n\
                   <title>Judged publications</title>\n\
                   <style>body{font:1rem/1.5 system-ui,sans-serif;max-width:65rem;margin:2rem auto;padding:0 1rem;color-scheme:light dark}\
                   article{border-top:1px solid #8886;padding:.5rem 0}h2{font-size:1.1rem;margin:.5rem 0}p{margin:.3rem 0}\
                   code{font-size:.95em;overflow-wrap:anywhere}.right{color:#2a7d2a}.wrong{color:#b3362b}\
                   @media(prefers-color-scheme:dark){.right{color:#7ccf7c}.wrong{color:#ff9b8f}}</style>\n</head>\n<body>\n\
                   <h1>Judged publications</h1>\n"
        .to_owned();
    for ShelvedPublication { name, verdict } in volumes {
        let verdict = match verdict {
            Ok(verdict) => verdict,
            Err(why) => {
                let (name, why) = (escape(name), escape(why));
                let _ = writeln!(out, "<article><h2>{name}</h2><p>not judged: <code>{why}</code></p></article>");
                continue;
            }
        };
        let look = if verdict.is_right() { "right" } else { "wrong" };
        let _ = writeln!(
            out,
            "<article id=\"{}\"><h2>{} <span class=\"{look}\">{}</span></h2>\n<p>{}</p>",
            escape(name),
            escape(&verdict.title),
            verdict.words(),
            escape(&verdict.source)
        );
        for (id, mistake, _) in &verdict.mistakes {
            let _ = writeln!(out, "<p>{}: <code>{}</code></p>", escape(id), escape(mistake));
        }
        for (system, integral) in &verdict.broken {
            let _ = writeln!(out, "<p>The motion of {} does not keep: {}</p>", escape(system), escape(integral));
        }
        for motion in &verdict.motions {
            let _ = writeln!(out, "<p>{}</p>", escape(&motion.words()));
        }
        out += "</article>\n";
    }
    out + "</body>\n</html>\n"
}
