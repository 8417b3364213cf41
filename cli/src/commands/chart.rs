//! Command `tripos chart`: measures speed against accuracy for every formulation, solve and method.

use crate::chart::{chart_tables, figure};
use crate::files::output_files::{make_folder, refuse_overwriting_inputs, write_text_file};
use crate::files::scene_file::SceneWithSetValues;
use crate::terminal::failure::{Failure, Output, print_result, print_to_stderr, warn};
use crate::terminal::interruption;
use crate::terminal::interruption::{ProgressBarReporter, counting_progress_bar};
use serde_json::json;
use std::path::{Path, PathBuf};
use tripos::studies::chart_case::PrintedEquationsChoice;
use tripos::studies::work_precision_chart::{ChartPlan, scene_chart};
use tripos_derive::plain_text::path_as_plain_text;

/// Measures the speed of a scene with all formulations, solves and methods, and writes tables and a
/// chart to the folder `out`. Returns the exit status. An interruption keeps partial tables and
/// gives an error.
pub fn chart(
    SceneWithSetValues { model, scene, .. }: &SceneWithSetValues,
    plan: &ChartPlan,
    printed: PrintedEquationsChoice,
    out: &Path,
    output: Output,
) -> Result<u8, Failure> {
    let names = ["work_precision.csv", "times.csv", "drifts.csv", "work_precision.svg"].map(|name| out.join(name));
    refuse_overwriting_inputs(model, Some(scene), names.iter().map(PathBuf::as_path))?;
    make_folder(out)?;
    interruption::listen_for_interruption();
    let bar = counting_progress_bar();
    let session = scene_chart::chart_scene(model, scene, printed, plan, &ProgressBarReporter(&bar))?;
    bar.finish_and_clear();
    if let Some(cut) = &session.cut {
        print_to_stderr(cut);
    }
    for what in &session.left_out {
        warn(&format!("not charted: {what}"));
    }
    if interruption::is_interrupted() && session.list.is_empty() {
        return Err(Failure::Interrupted(String::new()));
    }
    chart_tables::write_chart_tables(out, &session.list, &session.watch.integrals)?;
    let svg = figure::draw_speed_chart(&session.list, session.reference.uncertainty)?;
    write_text_file(&out.join("work_precision.svg"), &svg)?;
    let (compared, advice) =
        (session.compared.clone().unwrap_or_default(), chart_tables::chart_advice_table(&session.list));
    let value = json!({
        "model": model.title, "until": session.until, "reference": session.reference.how,
        "uncertainty": session.reference.uncertainty, "compared": session.compared, "advice": advice,
        "not_charted": session.left_out, "files": names.iter().map(|name| path_as_plain_text(name)).collect::<Vec<_>>(),
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
    print_result(output, &lines, &value)?;
    if interruption::is_interrupted() {
        let (count, place) = (session.list.len(), out.display());
        return Err(Failure::Interrupted(format!(
            "the tables in {place} are partial, {count} runs measured until then"
        )));
    }
    Ok(0)
}
