//! `tripos stability`: limits of runs of a scene, such as passages near singular places and growth of errors.

use crate::commands::chart::progress;
use crate::failure::{Failure, print};
use crate::follow::{self, Shows};
use crate::output::{folder, keep_inputs};
use crate::scene_file::VariedScene;
use crate::stability::{statements, write};
use std::fmt::Write;
use std::path::{Path, PathBuf};
use tripos::studies::stability::{Study, all};

/// Runs every study that applies to the scene, and writes its numbers and figures to `out`. Returns the exit status.
pub fn stability(VariedScene { model, scene, .. }: &VariedScene, quick: bool, out: &Path) -> Result<u8, Failure> {
    let files = ["stability.csv", "passages.csv"].map(|name| out.join(name));
    keep_inputs(model, Some(scene), files.iter().map(PathBuf::as_path))?;
    folder(out)?;
    follow::listen();
    let bar = progress();
    let findings = all(&Study { model, scene, quick, progress: &Shows(&bar) })?;
    bar.finish_and_clear();
    if findings.unfinished.is_some() && findings.rows.is_empty() {
        return Err(Failure::Interrupted(String::new()));
    }
    write(&findings, out)?;
    let scene_title = if scene.title.is_empty() { String::new() } else { format!(", {}", scene.title) };
    let mut text = format!("{}{scene_title}\n\n", model.title);
    for statement in statements(model, &findings) {
        let _ = writeln!(text, "- {statement}");
    }
    let _ = writeln!(text, "\n{} numbers in {}", findings.rows.len(), out.join("stability.csv").display());
    for (name, _) in &findings.figures {
        let _ = writeln!(text, "{}", out.join(name).display());
    }
    print(&text)?;
    if let Some(topic) = findings.unfinished {
        let what = format!("{} is partial: the study of {} was not finished", out.display(), topic.name());
        return Err(Failure::Interrupted(what));
    }
    Ok(0)
}
