//! Command `tripos stability`: studies the limits of a scene's runs, such as passages near singular places and the
//! growth of errors.

use crate::files::output_files::{make_folder, refuse_overwriting_inputs};
use crate::files::scene_file::SceneWithSetValues;
use crate::stability::{stability_conclusions, write_stability_results};
use crate::terminal::failure::{Failure, Output, print_result};
use crate::terminal::interruption;
use crate::terminal::interruption::{ProgressBarReporter, counting_progress_bar};
use serde_json::json;
use std::fmt::Write;
use std::path::{Path, PathBuf};
use tripos::studies::stability::{FindingTopic, StudyInputs, run_all_studies};
use tripos_derive::plain_text::path_as_plain_text;

/// Runs `tripos stability`: makes every study that applies to the scene, and writes numbers and
/// figures to the folder `out`. Returns the exit status.
///
/// # Errors
/// `Failure` if a study fails, a file cannot be written, or the user interrupts.
pub fn stability(
    SceneWithSetValues { model, scene, .. }: &SceneWithSetValues,
    quick: bool,
    out: &Path,
    output: Output,
) -> Result<u8, Failure> {
    let files = ["stability.csv", "passages.csv"].map(|name| out.join(name));
    refuse_overwriting_inputs(model, Some(scene), files.iter().map(PathBuf::as_path))?;
    make_folder(out)?;
    interruption::listen_for_interruption();
    let bar = counting_progress_bar();
    let findings = run_all_studies(&StudyInputs { model, scene, quick, progress: &ProgressBarReporter(&bar) })?;
    bar.finish_and_clear();
    if findings.unfinished.is_some() && findings.rows.is_empty() {
        return Err(Failure::Interrupted(String::new()));
    }
    write_stability_results(&findings, out)?;
    let scene_title = if scene.title.is_empty() { String::new() } else { format!(", {}", scene.title) };
    let mut text = format!("{}{scene_title}\n\n", model.title);
    let statements = stability_conclusions(model, &findings);
    for statement in &statements {
        let _ = writeln!(text, "- {statement}");
    }
    let _ = writeln!(text, "\n{} numbers in {}", findings.rows.len(), out.join("stability.csv").display());
    for (name, _) in &findings.figures {
        let _ = writeln!(text, "{}", out.join(name).display());
    }
    let figures = findings.figures.iter().map(|(name, _)| out.join(name));
    let files: Vec<String> = files
        .iter()
        .cloned()
        .chain(figures)
        .filter(|file| file.exists())
        .map(|file| path_as_plain_text(&file))
        .collect();
    let value = json!({
        "model": model.title, "scene": scene.title, "statements": statements, "numbers": findings.rows.len(),
        "unfinished": findings.unfinished.map(FindingTopic::name), "files": files,
    });
    print_result(output, &text, &value)?;
    if let Some(topic) = findings.unfinished {
        let what = format!("{} is partial: the study of {} was not finished", out.display(), topic.name());
        return Err(Failure::Interrupted(what));
    }
    Ok(0)
}
