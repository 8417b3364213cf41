//! `tripos report`: the main job. Derive, run every scene by every formulation, write one page.

use crate::catalogue::{By, model_file, read_model};
use crate::failure::{Failure, say, status, warn};
use crate::page::{self, Figure, Page, RunRow, SceneSection};
use crate::plot::{self, Panel, Series};
use crate::run::{Run, run, state_names};
use indicatif::{ProgressBar, ProgressStyle};
use std::path::{Path, PathBuf};
use tripos_derive::diagnostic::{Diagnostic, Diagnostics, Source};
use tripos_derive::mechanics::Derivation;
use tripos_derive::scene::{FigureKind, Scene, load, model_path};
use tripos_derive::{Formulation, Model, derive};

/// Writes the page of a model.
pub fn report(argument: &Path, out: &Path) -> Result<u8, Failure> {
    let mut model = read_model(argument)?;
    let (scenes, broken) = scenes(&model_file(argument), &mut model)?;
    let bar = ProgressBar::new((Formulation::ALL.len() * (1 + scenes.len())) as u64 + 1);
    let style = ProgressStyle::with_template("{bar:30} {pos}/{len} {msg}");
    bar.set_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()));
    let derivations = derivations(&model, &bar)?;
    let supported: Vec<Formulation> =
        derivations.iter().filter(|(_, result)| result.is_ok()).map(|(f, _)| *f).collect();
    let (mut doubts, mut stopped) = (Vec::new(), false);
    let mut sections = Vec::new();
    for scene in &scenes {
        let mut runs = Vec::new();
        for f in &supported {
            bar.set_message(format!("running {} by {}", scene.source.path.display(), f.name()));
            let run = run(&model, scene, &(*f).into())?;
            let objections = run.objections();
            let place = format!("{} by {}", scene.source.path.display(), f.name());
            stopped |= run.solution.stop.is_failure();
            doubts.extend(objections.into_iter().map(|objection| format!("{place}: {objection}")));
            runs.push(run);
            bar.inc(1);
        }
        sections.push(section(&model, scene, &runs)?);
    }
    let command = format!("tripos report {}", argument.display());
    let html = page::render(&Page { model: &model, derivations, scenes: sections, command });
    let path = write(out, &html)?;
    bar.finish_and_clear();
    for line in &doubts {
        warn(line);
    }
    say(&path.display().to_string());
    if !broken.is_empty() {
        return Err(Failure::Inputs(broken));
    }
    Ok(if stopped { status::STOPPED } else { 0 })
}

/// The scenes beside a model file, by name; those with errors apart.
fn scenes(model_file: &Path, model: &mut Model) -> Result<(Vec<Scene>, Vec<Diagnostics>), Failure> {
    let folder = model_file.parent().unwrap_or(Path::new(".")).join("scenes");
    let mut files: Vec<PathBuf> = match std::fs::read_dir(&folder) {
        Ok(entries) => entries.filter_map(|e| e.ok().map(|e| e.path())).collect(),
        Err(_) => Vec::new(),
    };
    files.retain(|path| path.extension().is_some_and(|e| e == "toml"));
    // By stem, so that report.toml comes before report-10s.toml.
    files.sort_by_key(|path| path.file_stem().map(std::ffi::OsStr::to_owned));
    let (mut scenes, mut broken) = (Vec::new(), Vec::new());
    for file in files {
        let scene = Source::read(&file).and_then(|source| {
            if !same_file(&model_path(&source)?, model_file) {
                let message = format!("this scene is of another model than {}", model_file.display());
                let help = "move it to the scenes of its own model, or leave its `model` out";
                return Err(Diagnostics::new(source, vec![Diagnostic::of_file(message, help)]));
            }
            load(&source, model)
        });
        match scene {
            Ok(scene) => scenes.push(scene),
            Err(diagnostics) => broken.push(diagnostics),
        }
    }
    if scenes.is_empty() && !broken.is_empty() {
        return Err(Failure::Inputs(broken));
    }
    Ok((scenes, broken))
}

fn same_file(a: &Path, b: &Path) -> bool {
    match (a.canonicalize(), b.canonicalize()) {
        (Ok(a), Ok(b)) => a == b,
        _ => false,
    }
}

type Derivations = Vec<(Formulation, Result<Derivation, String>)>;

fn derivations(model: &Model, bar: &ProgressBar) -> Result<Derivations, Failure> {
    let mut list = Vec::new();
    for f in Formulation::ALL {
        bar.set_message(format!("deriving by {}", f.name()));
        match derive(model, f) {
            Ok(derivation) => list.push((f, Ok(derivation))),
            Err(error) if error.is_unsupported() => list.push((f, Err(error.to_string()))),
            Err(error) => return Err(model.diagnose(&error).into()),
        }
        bar.inc(1);
    }
    Ok(list)
}

fn section(model: &Model, scene: &Scene, runs: &[Run]) -> Result<SceneSection, Failure> {
    let mut figures = Vec::new();
    for figure in &scene.figures {
        let (panels, columns) = match figure.kind {
            FigureKind::Energy => (vec![energy_panel(runs)], 1),
            FigureKind::States => (state_panels(model, runs), 2),
        };
        let svg = plot::draw(&panels, columns)
            .map_err(|error| Failure::Stopped(format!("the figure `{}` cannot be drawn: {error}", figure.caption)))?;
        figures.push(Figure { caption: figure.caption.clone(), svg });
    }
    Ok(SceneSection {
        title: scene.title.clone(),
        about: scene.about.clone(),
        facts: facts(model, scene),
        runs: runs.iter().map(|run| row(scene, run)).collect(),
        figures,
    })
}

fn facts(model: &Model, scene: &Scene) -> Vec<(String, String)> {
    let pairs = |names: Vec<String>, values: &[f64]| {
        let list = names.iter().zip(values).map(|(name, x)| format!("{name} = {x}"));
        list.collect::<Vec<_>>().join(", ")
    };
    let parameters = model.parameters.iter().map(|p| p.name.clone()).collect();
    let start = [scene.q.as_slice(), &scene.u].concat();
    vec![
        ("Parameters".to_owned(), pairs(parameters, &scene.parameters)),
        ("Start".to_owned(), pairs(state_names(model), &start)),
        ("Span".to_owned(), format!("{} s to {} s", scene.span.0, scene.span.1)),
        ("Integration".to_owned(), format!("{}, rtol {:e}, atol {:e}", scene.method, scene.rtol, scene.atol)),
        ("Domain".to_owned(), model.domain.iter().map(|c| c.text.clone()).collect::<Vec<_>>().join(", ")),
    ]
}

fn row(scene: &Scene, run: &Run) -> RunRow {
    let solution = &run.solution;
    RunRow {
        formulation: run.by.title.clone(),
        method: scene.method.clone(),
        code: run.code.to_owned(),
        steps: solution.steps,
        rejected: solution.rejected,
        evaluations: solution.evaluations,
        t_end: solution.t_end,
        stop: solution.stop.to_string(),
        trusted: run.objections().is_empty(),
        energy_drift: run.energy_drift,
        warnings: run.warnings.clone(),
    }
}

/// Formulations keep their colours, whichever a model supports.
fn style(by: &By) -> usize {
    Formulation::ALL.iter().position(|f| f.name() == by.name).unwrap_or(0)
}

fn note(runs: &[Run]) -> Option<String> {
    let early = runs.iter().filter(|run| run.solution.stop.code() != "end");
    let notes: Vec<String> = early
        .map(|run| format!("{} ends at {:.4} s: {}", run.by.name, run.solution.t_end, run.solution.stop.code()))
        .collect();
    (!notes.is_empty()).then(|| notes.join("; "))
}

fn energy_panel(runs: &[Run]) -> Panel {
    let series = runs
        .iter()
        .map(|run| Series {
            label: run.by.title.clone(),
            style: style(&run.by),
            points: run.solution.t.iter().zip(&run.energies).map(|(t, (k, p))| (*t, k + p)).collect(),
        })
        .collect();
    let note = note(runs);
    Panel {
        title: "Total energy".to_owned(),
        x_label: "t [s]".to_owned(),
        y_label: "T + V [J]".to_owned(),
        series,
        note,
    }
}

fn state_panels(model: &Model, runs: &[Run]) -> Vec<Panel> {
    // An angle's plain unit is shown as radians.
    let radians = |unit: String| match unit.as_str() {
        "1" => "rad".to_owned(),
        other => other.strip_prefix("1/").map_or(other.to_owned(), |rest| format!("rad/{rest}")),
    };
    let coordinates = model.coordinates.iter().map(|c| (&c.name, &c.unit));
    let quantities = coordinates.chain(model.speeds.iter().map(|s| (&s.name, &s.unit)));
    let labels: Vec<String> =
        quantities.map(|(name, unit)| format!("{name} [{}]", radians(unit.to_string()))).collect();
    let panel = |(at, label): (usize, &String)| Panel {
        title: label.split(' ').next().unwrap_or_default().to_owned(),
        x_label: "t [s]".to_owned(),
        y_label: label.clone(),
        series: runs
            .iter()
            .map(|run| Series {
                label: run.by.title.clone(),
                style: style(&run.by),
                points: run.solution.t.iter().zip(&run.states).map(|(t, state)| (*t, state[at])).collect(),
            })
            .collect(),
        note: None,
    };
    labels.iter().enumerate().map(panel).collect()
}

fn write(out: &Path, html: &str) -> Result<PathBuf, Failure> {
    let path = out.join("index.html");
    let failed = |error| Failure::Output(path.display().to_string(), error);
    std::fs::create_dir_all(out).map_err(failed)?;
    std::fs::write(&path, html).map_err(failed)?;
    Ok(path)
}
