//! `tripos chart`: speed against accuracy for every formulation, solve and method.

use crate::chart::{Plan, figure, files, session};
use crate::commands::simulate::read_scene;
use crate::failure::{Failure, print, say, warn};
use indicatif::{ProgressBar, ProgressStyle};
use std::path::Path;

/// Measures, and writes the tables and the chart to `out`.
pub fn chart(path: &Path, quick: bool, printed: bool, out: &Path) -> Result<u8, Failure> {
    let (model, scene) = read_scene(path)?;
    files::folder(out)?;
    let bar = progress();
    let session = session::chart(&model, &scene, printed, &Plan::new(quick), &bar)?;
    bar.finish_and_clear();
    if let Some(cut) = &session.cut {
        say(cut);
    }
    for what in &session.left_out {
        warn(&format!("not charted: {what}"));
    }
    files::write(out, &session.list, &session.watch.integrals)?;
    let svg = figure::chart(&session.list, session.reference.uncertainty)?;
    files::text(&out.join("work_precision.svg"), &svg)?;
    let compared = session.compared.map_or_else(String::new, |said| format!("{said}\n"));
    print(&format!(
        "{}\nreference at t = {} s: {}\n{compared}\n{}\n{}\n",
        model.title,
        session.until,
        session.reference.how,
        files::advice(&session.list),
        out.join("work_precision.svg").display()
    ))?;
    Ok(0)
}

/// A bar with a count and what is being done.
pub fn progress() -> ProgressBar {
    let bar = ProgressBar::new(1);
    let style = ProgressStyle::with_template("{bar:30} {pos}/{len} {msg}");
    bar.set_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
    bar
}
