//! `tripos report`: the main job. Derive, run every scene by every formulation, write one page.

mod measured;
mod own;

use crate::catalogue::{By, Code, Ready, code, model_file, read_model};
use crate::chart::compared::Compared;
use crate::commands::chart::progress;
use crate::failure::{Failure, say, status, warn};
use crate::figures::{self, Curve};
use crate::invariants::{Course, Watch};
use crate::page::{self, Figure, Nearest, Page, RunRow, SceneSection};
use crate::plot::{self, Panel};
use crate::run::{Run, how, run_code, state_names};
use crate::study::{Printed, Study};
use indicatif::ProgressBar;
use measured::Measured;
use own::{Own, shown};
use std::path::{Path, PathBuf};
use tripos_derive::diagnostic::{Diagnostic, Diagnostics, Source};
use tripos_derive::mechanics::{DerivationInSteps, derive_in_steps};
use tripos_derive::scene::{FigureKind, QUADRATURE, Scene, Solve, load, model_path};
use tripos_derive::{Formulation, Model};
use tripos_sim::Method;

/// Steps after which a run of printed equations is given up: such equations may creep to a place that they never reach.
const MOST_PRINTED_STEPS: u64 = 10_000;

/// Curves of printed systems in a figure; more cannot be told apart.
const MOST_PRINTED_CURVES: usize = 5;

/// Writes the page of a model.
pub fn report(argument: &Path, out: &Path) -> Result<u8, Failure> {
    let mut model = read_model(argument)?;
    let (scenes, mut broken) = scenes(&model_file(argument), &mut model)?;
    let bar = progress();
    let figures: usize = scenes.iter().map(|scene| scene.figures.len()).sum();
    bar.set_length((Formulation::ALL.len() * (1 + scenes.len()) + figures) as u64 + 2);
    let derivations = derivations(&model, &bar)?;
    bar.set_message("proving");
    let (study, broken_report) = Study::new(&model)?;
    broken.extend(broken_report);
    bar.inc(1);
    let mut derived = Vec::new();
    for (f, _) in derivations.iter().filter(|(_, result)| result.is_ok()) {
        let by = By::from(*f);
        let code = code(&model, &by, None, Ready::Solved)?;
        derived.push((by, code));
    }
    let work = Work {
        model: &model,
        study: &study,
        watch: Watch::new(&model, &study.derivations.kinematics.arena, &study.proof.integrals)?,
        derived,
        printed: study.printed(&model)?,
    };
    let (mut doubts, mut stopped) = (Vec::new(), false);
    let mut sections = Vec::new();
    for scene in &scenes {
        let runs = work.runs(scene, &bar)?;
        let own = runs.own.iter().map(|own| &own.run);
        for run in runs.derived.iter().map(|(run, _)| run).chain(own) {
            let place = format!("{} by {}", scene.source.path.display(), run.by.name);
            stopped |= run.failure().is_some();
            doubts.extend(run.objections().into_iter().map(|objection| format!("{place}: {objection}")));
        }
        let section = work.section(scene, runs, out, &bar)?;
        let path = scene.source.path.display();
        doubts.extend(section.not_drawn.iter().map(|why| format!("{path}: {why}")));
        sections.push(section);
    }
    let command = format!("tripos report {}", argument.display());
    let html = page::render(&Page { model: &model, derivations, study: &study, scenes: sections, command });
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

type Derivations = Vec<(Formulation, Result<DerivationInSteps, String>)>;

fn derivations(model: &Model, bar: &ProgressBar) -> Result<Derivations, Failure> {
    let mut list = Vec::new();
    for f in Formulation::ALL {
        bar.set_message(format!("deriving by {}", f.name()));
        match derive_in_steps(model, f) {
            Ok(derivation) => list.push((f, Ok(derivation))),
            Err(error) if error.is_unsupported() => list.push((f, Err(error.to_string()))),
            Err(error) => return Err(model.diagnose(&error).into()),
        }
        bar.inc(1);
    }
    Ok(list)
}

/// Equations that are ready to run, and what to look at.
struct Work<'a> {
    model: &'a Model,
    study: &'a Study,
    watch: Watch,
    derived: Vec<(By, Code)>,
    printed: Vec<Printed>,
}

/// The runs of a scene.
struct Runs {
    derived: Vec<(Run, Course)>,
    /// By the scene's own equations, or why there are none.
    own: Result<Own, String>,
    printed: Vec<(Run, Course)>,
    /// Printed systems that could not be run, and why.
    not_run: Vec<(String, String)>,
}

impl Work<'_> {
    /// Runs everything. Printed equations may fail as they like: that is shown, and nothing else comes of it.
    fn runs(&self, scene: &Scene, bar: &ProgressBar) -> Result<Runs, Failure> {
        let message = |by: &By| format!("running {} by {}", scene.source.path.display(), by.name);
        let own = Own::new(self.model, scene, &self.watch).map_err(|failure| failure.first_line());
        let mut runs = Runs { derived: Vec::new(), own, printed: Vec::new(), not_run: Vec::new() };
        // Quadrature and projection are of a scene's own equations alone.
        let mut stepped = scene.clone();
        stepped.integration.project = None;
        if stepped.integration.method == QUADRATURE {
            Method::Dop853.name().clone_into(&mut stepped.integration.method);
        }
        for (by, code) in &self.derived {
            bar.set_message(message(by));
            let own = match scene.integration.distance {
                None => None,
                distance => Some(crate::catalogue::code(self.model, by, distance, Ready::Solved)?),
            };
            let code = own.as_ref().unwrap_or(code);
            let run = run_code(self.model, &stepped, by, code, Some(&self.watch))?;
            let course = self.watch.along(scene, code, &run)?;
            runs.derived.push((run, course));
            bar.inc(1);
        }
        let mut limited = stepped.clone();
        limited.integration.step_limit = scene.integration.step_limit.min(MOST_PRINTED_STEPS);
        limited.integration.solve = Some(Solve::Numeric);
        limited.integration.distance = None;
        for (by, code) in &self.printed {
            bar.set_message(message(by));
            let why = match code {
                Ok(code) => match run_code(self.model, &limited, by, code, None) {
                    Ok(run) => {
                        let course = self.watch.along(scene, code, &run)?;
                        runs.printed.push((run, course));
                        continue;
                    }
                    Err(failure) => failure.first_line(),
                },
                Err(failure) => failure.first_line(),
            };
            runs.not_run.push((by.name.clone(), why));
        }
        Ok(runs)
    }

    /// The printed runs that are drawn: of those that are proved to move alike the first.
    fn drawn<'r>(&self, runs: &'r Runs) -> (Vec<Curve<'r>>, Option<String>) {
        let mut curves = curves(runs, |own| own.course.is_some());
        let Some(published) = &self.study.published else { return (curves, None) };
        let derived = curves.len();
        let (mut alike, mut left_out) = (Vec::new(), Vec::new());
        for (run, course) in &runs.printed {
            let id = run.by.name.trim_start_matches("printed:");
            let first = published.first_alike(id);
            let style = curves.len() - derived + figures::PRINTED;
            if first != id {
                alike.push(format!("{id} moves as {first}"));
            } else if style < figures::PRINTED + MOST_PRINTED_CURVES {
                curves.push(Curve { run, course, style });
            } else {
                left_out.push(id.to_owned());
            }
        }
        let mut notes = Vec::new();
        if !alike.is_empty() {
            notes.push(format!(
                "One curve stands for systems that are proved to give the same motion: {}.",
                alike.join(", ")
            ));
        }
        if !left_out.is_empty() {
            notes.push(format!("Not drawn: {}.", left_out.join(", ")));
        }
        (curves, (!notes.is_empty()).then(|| notes.join(" ")))
    }

    /// The panels of a figure of states: every state, or what the scene wants to see.
    fn states(&self, scene: &Scene, runs: &Runs) -> Vec<Panel> {
        let curves = curves(runs, |_| true);
        if !scene.states_outputs {
            return figures::states(self.model, &curves);
        }
        let compared = Compared::new(self.model, scene);
        let values: Vec<_> = curves
            .into_iter()
            .map(|curve| {
                let values = shown(&compared, curve.run);
                (curve, values)
            })
            .collect();
        figures::outputs(self.model, scene, &values)
    }

    fn section(&self, scene: &Scene, runs: Runs, out: &Path, bar: &ProgressBar) -> Result<SceneSection, Failure> {
        let mut measured = Measured::new(self.model, scene, out);
        let mut shown = Vec::new();
        for figure in &scene.figures {
            let (kind, caption) = (figure.kind, figure.caption.as_str());
            bar.set_message(format!("{} of {}", kind.name(), scene.source.path.display()));
            shown.extend(match kind {
                FigureKind::Energy => {
                    Some(drawing(caption, &[figures::energy(&curves(&runs, |own| own.has_energy))], 1)?)
                }
                FigureKind::States => Some(drawing(caption, &self.states(scene, &runs), 2)?),
                _ => measured.figure(kind, caption)?,
            });
            bar.inc(1);
        }
        let (curves, note) = self.drawn(&runs);
        let note = note.map(|note| format!(" {note}")).unwrap_or_default();
        let mut integrals = None;
        if !curves.is_empty() && !self.watch.integrals.is_empty() {
            let panels = figures::integrals(&self.watch, &curves);
            let caption = "First integrals: how far each is from its value at the start, on logarithmic scales. What lies \
                           at the lower edge does not change; what lies at the upper edge is beyond it.";
            integrals = Some(drawing(&format!("{caption}{note}"), &panels, panels.len().min(2))?);
        }
        let mut nearness = None;
        if !curves.is_empty() {
            let caption = "How near the matrix A of the accelerations comes to a singular one, and the kinematic equations \
                           to a division by zero, on logarithmic scales.";
            nearness = Some(drawing(&format!("{caption}{note}"), &figures::nearness(&self.watch, &curves), 2)?);
        }
        let own = runs.own.as_ref().ok();
        let mut rows: Vec<RunRow> = runs.derived.iter().map(|(run, course)| row(scene, run, course)).collect();
        rows.extend(own.map(|own| own_row(scene, own)));
        rows.extend(runs.printed.iter().map(|(run, course)| row(scene, run, course)));
        Ok(SceneSection {
            title: title(scene),
            about: scene.about.clone(),
            facts: facts(self.model, scene),
            runs: rows,
            not_run: runs.not_run,
            needs: runs.own.map(|own| own.needs),
            figures: shown,
            not_drawn: measured.not_drawn,
            advice: measured.advice,
            integrals,
            nearness,
        })
    }
}

/// The runs of derived equations, that of the scene's own among them if it shows what is drawn.
fn curves(runs: &Runs, shows: impl Fn(&Own) -> bool) -> Vec<Curve<'_>> {
    let own = runs.own.iter().filter(|own| shows(own)).map(|own| (&own.run, own.course.as_ref().unwrap_or(&UNWATCHED)));
    let derived = runs.derived.iter().map(|(run, course)| (run, course));
    derived.chain(own).map(|(run, course)| Curve { run, course, style: figures::style(&run.by) }).collect()
}

/// The course of a run along which nothing was watched.
static UNWATCHED: Course = Course {
    t: Vec::new(),
    integrals: Vec::new(),
    determinant: Vec::new(),
    condition: Vec::new(),
    divisors: Vec::new(),
};

fn drawing(caption: &str, panels: &[Panel], columns: usize) -> Result<Figure, Failure> {
    let svg = plot::draw(panels, columns)
        .map_err(|error| Failure::Stopped(format!("the figure `{caption}` cannot be drawn: {error}")))?;
    Ok(Figure { caption: caption.to_owned(), svg, remark: None, data: Vec::new() })
}

/// The title of a scene; without one, its file's name.
fn title(scene: &Scene) -> String {
    let stem = || scene.source.path.file_stem().map_or(String::new(), |stem| stem.to_string_lossy().into_owned());
    if scene.title.is_empty() { stem() } else { scene.title.clone() }
}

fn facts(model: &Model, scene: &Scene) -> Vec<(String, String)> {
    let pairs = |names: Vec<String>, values: &[f64]| {
        let list = names.iter().zip(values).map(|(name, x)| format!("{name} = {x}"));
        list.collect::<Vec<_>>().join(", ")
    };
    let parameters = model.parameters.iter().map(|p| p.name.clone()).collect();
    let start = [scene.q.as_slice(), &scene.u].concat();
    let mut facts = vec![
        ("Parameters".to_owned(), pairs(parameters, &scene.parameters)),
        ("Start".to_owned(), pairs(state_names(model), &start)),
        ("Span".to_owned(), format!("{} s to {} s", scene.span.0, scene.span.1)),
        ("Integration".to_owned(), how(scene)),
        ("Domain".to_owned(), model.domain.iter().map(|c| c.text.clone()).collect::<Vec<_>>().join(", ")),
    ];
    facts.retain(|(_, value)| !value.is_empty());
    facts
}

fn row(scene: &Scene, run: &Run, course: &Course) -> RunRow {
    let solution = &run.solution;
    RunRow {
        title: run.by.title.clone(),
        printed: run.by.name.strip_prefix("printed:").map(str::to_owned),
        method: scene.integration.method.clone(),
        code: run.code.to_owned(),
        steps: solution.steps,
        rejected: solution.rejected,
        evaluations: solution.evaluations,
        t_end: solution.t_end,
        arrived: solution.stop.code() == "end",
        stop: solution.stop.to_string(),
        trusted: run.objections().is_empty(),
        energy_drift: run.energy_drift,
        warnings: run.warnings.clone(),
        changes: course.largest_changes(),
        nearest: Nearest {
            determinant: range(&course.determinant),
            relative: course.least(&course.relative_determinant()),
            condition: course.least(&course.condition),
            divisors: course.divisors.iter().map(|values| course.least(values)).collect(),
        },
    }
}

/// The row of the scene's own equations.
fn own_row(scene: &Scene, own: &Own) -> RunRow {
    let row = row(scene, &own.run, own.course.as_ref().unwrap_or(&UNWATCHED));
    RunRow { energy_drift: row.energy_drift.filter(|_| own.has_energy), ..row }
}

fn range(values: &[f64]) -> Option<(f64, f64)> {
    let numbers = || values.iter().copied().filter(|x| !x.is_nan());
    Some((numbers().min_by(f64::total_cmp)?, numbers().max_by(f64::total_cmp)?))
}

fn write(out: &Path, html: &str) -> Result<PathBuf, Failure> {
    let path = out.join("index.html");
    let failed = |error| Failure::Output(path.display().to_string(), error);
    std::fs::create_dir_all(out).map_err(failed)?;
    std::fs::write(&path, html).map_err(failed)?;
    Ok(path)
}
