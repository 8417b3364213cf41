//! Command `tripos chart`: measures speed against accuracy for every formulation, solve and method.

use crate::chart::{figure, files};
use crate::failure::{Failure, Output, print_either, say, warn};
use crate::follow::{self, Shows};
use crate::output::{folder, keep_inputs, text};
use crate::scene_file::VariedScene;
use indicatif::{ProgressBar, ProgressStyle};
use serde_json::json;
use std::path::{Path, PathBuf};
use tripos::studies::case::Printed;
use tripos::studies::chart::{Plan, session};
use tripos_derive::plain::path_in_line;

/// Measures the speed of a scene with all formulations, solves and methods, and writes tables and a
/// chart to the folder `out`. Returns the exit status. An interruption keeps partial tables and
/// gives an error.
pub fn chart(
    VariedScene { model, scene, .. }: &VariedScene,
    plan: &Plan,
    printed: Printed,
    out: &Path,
    output: Output,
) -> Result<u8, Failure> {
    let names = ["work_precision.csv", "times.csv", "drifts.csv", "work_precision.svg"].map(|name| out.join(name));
    keep_inputs(model, Some(scene), names.iter().map(PathBuf::as_path))?;
    folder(out)?;
    follow::listen();
    let bar = progress();
    let session = session::chart(model, scene, printed, plan, &Shows(&bar))?;
    bar.finish_and_clear();
    if let Some(cut) = &session.cut {
        say(cut);
    }
    for what in &session.left_out {
        warn(&format!("not charted: {what}"));
    }
    if follow::is_interrupted() && session.list.is_empty() {
        return Err(Failure::Interrupted(String::new()));
    }
    files::write(out, &session.list, &session.watch.integrals)?;
    let svg = figure::chart(&session.list, session.reference.uncertainty)?;
    text(&out.join("work_precision.svg"), &svg)?;
    let (compared, advice) = (session.compared.clone().unwrap_or_default(), files::advice(&session.list));
    let value = json!({
        "model": model.title, "until": session.until, "reference": session.reference.how,
        "uncertainty": session.reference.uncertainty, "compared": session.compared, "advice": advice,
        "not_charted": session.left_out, "files": names.iter().map(|name| path_in_line(name)).collect::<Vec<_>>(),
    });
    let compared = if compared.is_empty() { compared } else { compared + "\n" };
    let lines = format!(
        "{}\nreference at t = {} s: {}\n{compared}\n{}\n{}\n",
        model.title,
        session.until,
        session.reference.how,
        advice,
        out.join("work_precision.svg").display()
    );
    print_either(output, &lines, &value)?;
    if follow::is_interrupted() {
        let (count, place) = (session.list.len(), out.display());
        return Err(Failure::Interrupted(format!(
            "the tables in {place} are partial, {count} runs measured until then"
        )));
    }
    Ok(0)
}

/// Returns a progress bar with a count and a message.
pub fn progress() -> ProgressBar {
    let bar = ProgressBar::new(1);
    let style = ProgressStyle::with_template("{bar:30} {pos}/{len} {msg}");
    bar.set_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
    bar
}
