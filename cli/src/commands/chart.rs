//! `tripos chart`: speed against accuracy for every formulation, solve and method.

use crate::chart::{Plan, cases, figure, files, measure};
use crate::commands::simulate::read_scene;
use crate::failure::{Failure, print, say};
use crate::invariants::Watch;
use crate::reference::Reference;
use crate::run::{Balance, events, options, refused};
use crate::{catalogue::By, problem::Problem};
use indicatif::{ProgressBar, ProgressStyle};
use std::path::Path;
use tripos_derive::Model;
use tripos_derive::scene::Scene;
use tripos_sim::{Options, Output};

/// Measures, and writes the tables and the chart to `out`.
pub fn chart(path: &Path, quick: bool, printed: bool, out: &Path) -> Result<u8, Failure> {
    let (model, mut scene) = read_scene(path)?;
    files::folder(out)?;
    let bar = progress();
    bar.set_message("reference");
    let cases = cases(&model, &scene, printed)?;
    if let Some(t) = leaves(&model, &scene, &cases[0].by)? {
        let (from, to) = scene.span;
        scene.span.1 = from + (t - from) * 0.99;
        say(&format!(
            "the motion ends at t = {t} s of {to} s, where it leaves the domain or meets a terminal event: charted to t = {}",
            scene.span.1
        ));
    }
    let reference = Reference::new(&model, &scene, &[scene.span.1])?;
    let watch = Watch::of_model(&model)?;
    let list = measure(&model, &scene, &cases, &Plan::new(quick), &watch, &reference, &bar)?;
    bar.finish_and_clear();
    files::write(out, &list, &watch.integrals)?;
    let svg = figure::chart(&list, reference.uncertainty)?;
    files::text(&out.join("work_precision.svg"), &svg)?;
    print(&format!(
        "{}\nreference at t = {} s: {}\n\n{}\n{}\n",
        model.title,
        scene.span.1,
        reference.how,
        files::advice(&list),
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

/// When the motion leaves the domain of its equations, or meets a terminal event, before the end of its span.
fn leaves(model: &Model, scene: &Scene, by: &By) -> Result<Option<f64>, Failure> {
    let code = crate::catalogue::code(model, by, scene.integration.distance)?;
    let problem = Problem::new(model, scene, by, &code, None)?;
    let balance = Balance::new(model, scene, by)?;
    let mut events = events(&problem, &balance)?;
    let how = Options { output: Output::Ends, rtol: 1e-9, step: None, ..options(scene)? };
    let how = Options { method: tripos_sim::Method::Ode45, ..how };
    let solution = problem.integrate(&problem.start()?, &how, &mut events).map_err(|error| refused(scene, &error))?;
    let code = solution.stop.code();
    Ok((code.starts_with("event:") || code.starts_with("domain:")).then_some(solution.t_end))
}
