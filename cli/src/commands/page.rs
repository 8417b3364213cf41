//! Command `tripos page`: derives a model, runs every scene by every formulation, and writes one HTML page.

mod claims;
mod motion_figure;
mod reduced_run;
mod rows;
mod run_figures;
mod sketch;
mod standings;
mod study_figures;

use crate::arguments::Page as Request;
use crate::files::output_files::{make_folder, refuse_overwriting_inputs, write_text_file};
use crate::files::scene_file::{scene_title, set_scene_values};
use crate::files::workspace::{
    current_folder, edited_workspace_model_warning, model_file, read_model, workspace_around,
};
use crate::page::{self, Page, RunRow, SceneSection, Standing};
use crate::plot::{Panel, styles};
use crate::run_panels::{self, RunCurves};
use crate::terminal::failure::{Failure, print_json, print_to_stderr, status, warn};
use crate::terminal::interruption;
use crate::terminal::interruption::counting_progress_bar;
use indicatif::ProgressBar;
use motion_figure::page_motion_figure;
use reduced_run::{ReducedRun, page_run_outputs};
use rows::{EMPTY_COURSE, impacts_words, reduced_run_row, row, scene_facts};
use run_figures::{RunFigureWriter, run_figure, run_figure_caption, run_figure_folder};
use serde_json::json;
use sketch::page_sketch;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use study_figures::StudyFigures;
use tripos::code::{Code, CodePreparation, runnable_code};
use tripos::equations_name::formulation_of_name;
use tripos::studies::model_analysis::{ModelAnalysis, PrintedSystem};
use tripos::trust::compared_quantities::ComparedQuantities;
use tripos::{Error, InvariantValues, Mechanism, Run, WatchedInvariants, run_code};
use tripos_codegen::model_folders::{is_same_model_file, scenes_in_model_folder};
use tripos_derive::diagnostic::{Diagnostic, Diagnostics, Source};
use tripos_derive::mechanics::{DerivationInSteps, EquationsOrigin, derive_in_steps};
use tripos_derive::plain_text::path_as_plain_text;
use tripos_derive::scene::{AccelerationSolution, FigureKind, Integrator, Scene, load, model_path_of_scene};
use tripos_derive::{Formulation, Model};
use tripos_sim::Method;

/// Largest number of steps in a run of printed equations. Runs of wrong equations can approach a state with ever
/// smaller steps and never reach it.
const MOST_PRINTED_STEPS: u64 = 10_000;

/// Runs `tripos page`: derives, proves and runs a model, and writes its page. Returns the exit status.
///
/// # Errors
/// `Failure` if a file has errors, if derived equations cannot run a scene, or if a file cannot be written. After an
/// interruption, or if scenes have errors, the page is written before the error is returned.
pub fn page(request: &Request) -> Result<u8, Failure> {
    let out = request.out.as_path();
    let also = request.also.iter().map(|name| formulation_of_name(name)).collect::<Result<Vec<_>, _>>()?;
    let argument = request.model.as_deref().map_or_else(default_page_model, |given| Ok(given.to_owned()))?;
    let mut model = read_model(&argument)?;
    // The page shows names of the model file next to formulas. The formulas must therefore use exactly these names.
    model.arena.clear_printed_names();
    if let Some(note) = edited_workspace_model_warning(&model) {
        warn(&note);
    }
    let (scenes, mut broken) = read_page_scenes(&model_file(&argument), &mut model)?;
    let (scenes, set) = set_page_scene_values(scenes, &mut model, &request.set.set)?;
    let page = out.join("index.html");
    refuse_overwriting_inputs(&model, None, [page.as_path()])?;
    for scene in &scenes {
        refuse_overwriting_inputs(&model, Some(scene), [page.as_path()])?;
    }
    interruption::listen_for_interruption();
    let bar = counting_progress_bar();
    let figures: usize = scenes.iter().map(|scene| scene.figures.len()).sum();
    let formulations: Vec<Formulation> = Formulation::STANDARD.into_iter().chain(also.iter().copied()).collect();
    bar.set_length((formulations.len() * (1 + scenes.len()) + figures) as u64 + 3);
    let derivations = derivations(&model, &formulations, &bar)?;
    bar.set_message("proving");
    let (study, broken_publication) = ModelAnalysis::new(&model, &also)?;
    broken.extend(broken_publication);
    bar.inc(1);
    let work = PageRuns::new(&model, &study, &derivations, set)?;
    let done = work.scenes(&scenes, out, &bar)?;
    let (there, all) = (done.sections.len(), scenes.len());
    let unfinished = (there < all).then(|| format!("the page was interrupted after {there} of {all} scenes"));
    bar.set_message("looking at the motion");
    let moving = page_motion_figure(&model, &scenes, &done.sections);
    bar.inc(1);
    let html = page::render_page(&Page {
        model: &model,
        derivations,
        study: &study,
        scenes: done.sections,
        sketch: page_sketch(&model, scenes.first()),
        moving,
        unfinished: unfinished.clone(),
        file: argument.display().to_string(),
    });
    make_folder(out)?;
    write_text_file(&page, &html)?;
    bar.finish_and_clear();
    for line in &done.doubts {
        warn(line);
    }
    if request.json {
        let value = json!({
            "files": [path_as_plain_text(&page)], "warnings": done.doubts, "unfinished": unfinished, "stopped": done.stopped,
        });
        print_json(&value)?;
    } else {
        print_to_stderr(&page.display().to_string());
    }
    if let Some(unfinished) = unfinished {
        return Err(Failure::Interrupted(format!("the page is partial: {unfinished}")));
    }
    if !broken.is_empty() {
        return Err(Error::Inputs(broken).into());
    }
    Ok(if done.stopped { status::STOPPED } else { 0 })
}

/// Returns the model for the page if the command line names none: `models/disk` of the workspace
/// around the current folder.
///
/// # Errors
/// `Failure` if the current folder is in no workspace.
fn default_page_model() -> Result<PathBuf, Failure> {
    let here = current_folder()?;
    let root = workspace_around(&here).ok_or_else(|| {
        let what = format!("no model is given, and `{}` is in no workspace that has one", path_as_plain_text(&here));
        let help = "give a model file, or a folder that holds `model.toml`, as in `tripos page FOLDER`".to_owned();
        Failure::request(what, help)
    })?;
    let model = root.join("models/disk");
    Ok(model.strip_prefix(&here).map_or_else(|_| model.clone(), Path::to_owned))
}

/// Reads the scenes of a model file. The second list has the errors of scenes that cannot be read.
fn read_page_scenes(model_file: &Path, model: &mut Model) -> Result<(Vec<Scene>, Vec<Diagnostics>), Failure> {
    let (mut scenes, mut broken) = (Vec::new(), Vec::new());
    for file in scenes_in_model_folder(model_file) {
        let scene = Source::read(&file).and_then(|source| {
            if !is_same_model_file(&model_path_of_scene(&source)?, model_file) {
                let message = format!("this scene is of another model than {}", path_as_plain_text(model_file));
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
        return Err(Error::Inputs(broken).into());
    }
    Ok((scenes, broken))
}

/// Sets values of the option `--set` in the scenes, and prints the changed values once. `Err` for an unknown name or a
/// value that a scene cannot have.
fn set_page_scene_values(
    scenes: Vec<Scene>,
    model: &mut Mechanism,
    set: &[String],
) -> Result<(Vec<Scene>, SetNumbers), Failure> {
    let (mut list, mut values) = (Vec::new(), Vec::new());
    for scene in scenes {
        let (scene, of_scene) = set_scene_values(scene, model, set)?;
        if list.is_empty() {
            for (name, value) in &of_scene {
                print_to_stderr(&format!("note: {name} = {value}, not the value of the scenes"));
            }
            values = of_scene;
        }
        list.push(scene);
    }
    Ok((list, values))
}

/// Numbers that the option `--set` replaces, as (name, value in SI units).
type SetNumbers = Vec<(String, f64)>;

/// Derivation of each formulation, or the reason why the model does not support it.
type Derivations = Vec<(Formulation, Result<DerivationInSteps, String>)>;

/// Derives the formulations of a model one after another. `Err` if a derivation fails although the model is supported.
fn derivations(model: &Mechanism, formulations: &[Formulation], bar: &ProgressBar) -> Result<Derivations, Failure> {
    let mut list = Vec::new();
    for f in formulations.iter().copied() {
        bar.set_message(format!("deriving by {}", f.name()));
        match derive_in_steps(model, f, None) {
            Ok(derivation) => list.push((f, Ok(derivation))),
            Err(error) if error.is_unsupported() => list.push((f, Err(error.to_string()))),
            Err(error) => return Err(model.diagnose(&error).into()),
        }
        bar.inc(1);
    }
    Ok(list)
}

/// Equations of a model prepared for runs, with the quantities that are watched along runs.
struct PageRuns<'a> {
    /// Model of the mechanism on the page.
    model: &'a Mechanism,
    /// Derivations, proofs and publication of the model.
    study: &'a ModelAnalysis,
    /// Quantities watched along runs, such as first integrals and determinants.
    watch: WatchedInvariants,
    /// Code of each derived set of equations.
    derived: Vec<(EquationsOrigin, Code)>,
    /// Code of each printed set of equations.
    printed: Vec<PrintedSystem>,
    /// Numbers that replace those of the scene files, as (name, value in SI units).
    set: SetNumbers,
}

/// Runs of one scene by all sets of equations.
struct SceneRuns {
    /// Runs by derived equations, each with its watched quantities.
    derived: Vec<(Run, InvariantValues)>,
    /// Run by the scene's reduced equations; `Err` is the reason why there is none.
    own: Result<ReducedRun, String>,
    /// Runs by printed equations, each with its watched quantities.
    printed: Vec<(Run, InvariantValues)>,
    /// Standing (trustworthiness) of each run, in the order derived, reduced, printed.
    standings: Vec<Standing>,
    /// Names of printed systems that could not be run, each with the reason.
    not_run: Vec<(String, String)>,
}

/// Results of all scenes that were finished, as sections of the page.
#[derive(Default)]
struct FinishedScenes {
    /// Section of the page for each finished scene.
    sections: Vec<SceneSection>,
    /// Doubts about the runs of the finished scenes, one per line.
    doubts: Vec<String>,
    /// True if a run of derived or reduced equations stopped before its end.
    stopped: bool,
}

impl<'a> PageRuns<'a> {
    /// Prepares the derived equations of a model for runs, and collects the printed equations.
    /// `Err` if derived equations cannot be prepared for runs.
    fn new(
        model: &'a Mechanism,
        study: &'a ModelAnalysis,
        derivations: &Derivations,
        set: SetNumbers,
    ) -> Result<Self, Failure> {
        let mut derived = Vec::new();
        for (f, _) in derivations.iter().filter(|(_, result)| result.is_ok()) {
            let by = EquationsOrigin::from(*f);
            let code = runnable_code(model, &by, None, CodePreparation::Solved)?;
            derived.push((by, code));
        }
        let watch = WatchedInvariants::new(model, &study.derivations.kinematics.arena, &study.proof.integrals)?;
        Ok(Self { model, study, watch, derived, printed: study.printed_systems(model), set })
    }

    /// Runs every scene and draws its figures. After an interruption, the unfinished scenes are
    /// left out.
    /// `Err` if a scene cannot be run by derived equations, or a file cannot be written.
    fn scenes(&self, scenes: &[Scene], out: &Path, bar: &ProgressBar) -> Result<FinishedScenes, Failure> {
        let mut done = FinishedScenes::default();
        for scene in scenes {
            let runs = self.runs(scene, bar);
            if interruption::is_interrupted() {
                // Interrupted runs are not shown, and are not written to tables.
                break;
            }
            let runs = runs?;
            let (mut doubts, mut stopped) = (Vec::new(), false);
            let own = runs.own.iter().map(|own| &own.run);
            for run in runs.derived.iter().map(|(run, _)| run).chain(own) {
                let place = format!("{} by {}", path_as_plain_text(&scene.source.path), run.by.name());
                stopped |= run.failure().is_some();
                doubts.extend(run.objections().into_iter().map(|objection| format!("{place}: {objection}")));
            }
            let section = self.section(scene, runs, out, bar);
            if interruption::is_interrupted() {
                break;
            }
            let section = section?;
            let path = path_as_plain_text(&scene.source.path);
            doubts.extend(section.not_drawn.iter().map(|why| format!("{path}: {why}")));
            done.sections.push(section);
            done.doubts.extend(doubts);
            done.stopped |= stopped;
        }
        Ok(done)
    }

    /// Runs a scene by all sets of equations. A failure of printed equations is recorded for the
    /// page and does not stop the command.
    /// `Err` if derived equations cannot run the scene.
    fn runs(&self, scene: &Scene, bar: &ProgressBar) -> Result<SceneRuns, Failure> {
        let message =
            |by: &EquationsOrigin| format!("running {} by {}", path_as_plain_text(&scene.source.path), by.name());
        let own = ReducedRun::new(self.model, scene, &self.watch).map_err(|failure| failure.first_line());
        let mut runs =
            SceneRuns { derived: Vec::new(), own, printed: Vec::new(), standings: Vec::new(), not_run: Vec::new() };
        // Quadrature and projection exist only for a scene's reduced equations.
        let mut stepped = scene.clone();
        stepped.integration.project = None;
        if stepped.integration.method == Integrator::Quadrature {
            stepped.integration.method = Method::Dop853.into();
        }
        for (by, code) in &self.derived {
            bar.set_message(message(by));
            let own = match scene.integration.distance {
                None => None,
                distance => Some(tripos::code::runnable_code(self.model, by, distance, CodePreparation::Solved)?),
            };
            let code = own.as_ref().unwrap_or(code);
            let run = run_code(self.model, &stepped, by, code, Some(&self.watch))?;
            let course = run.course(&self.watch, scene, code)?;
            runs.derived.push((run, course));
            bar.inc(1);
        }
        let mut limited = stepped.clone();
        limited.integration.step_limit = scene.integration.step_limit.min(MOST_PRINTED_STEPS);
        limited.integration.solve = Some(AccelerationSolution::Numeric);
        limited.integration.distance = None;
        for (by, code) in &self.printed {
            bar.set_message(message(by));
            let why = match code {
                Ok(code) => match run_code(self.model, &limited, by, code, None) {
                    Ok(run) => {
                        let course = run.course(&self.watch, scene, code)?;
                        runs.printed.push((run, course));
                        continue;
                    }
                    Err(failure) => failure.first_line(),
                },
                Err(failure) => failure.first_line(),
            };
            runs.not_run.push((by.name(), why));
        }
        let (derived, own) = (runs.derived.iter().map(|(run, _)| run), runs.own.iter().map(|own| &own.run));
        let all = derived.chain(own).chain(runs.printed.iter().map(|(run, _)| run));
        runs.standings = all.map(|run| standings::run_standing(self.study, scene, run)).collect();
        Ok(runs)
    }

    /// Returns the curves to draw, with a note on the printed equations. If several systems are proved to give the same
    /// motion, only the first is drawn. The note is `None` if every printed system has a curve.
    fn curves_to_draw<'r>(&self, runs: &'r SceneRuns) -> (Vec<RunCurves<'r>>, Option<String>) {
        let mut curves = derived_page_run_curves(runs, |own| own.course.is_some());
        let Some(published) = &self.study.published else { return (curves, None) };
        let (mut alike, mut left_out, mut drawn) = (Vec::new(), Vec::new(), [0; 2]);
        let before = runs.standings.len() - runs.printed.len();
        for ((run, course), standing) in runs.printed.iter().zip(&runs.standings[before..]) {
            let Some(id) = run.by.printed_id() else { continue };
            let wrong = *standing == Standing::Wrong;
            let (kind, first) =
                (if wrong { styles::WRONG } else { styles::PRINTED }, published.first_equivalent_system(id));
            let count = &mut drawn[usize::from(wrong)];
            if first != id {
                alike.push(format!("{id} moves as {first}"));
            } else if *count < styles::MOST_PRINTED && curves.len() < styles::MOST_CURVES {
                curves.push(RunCurves::new(run, course, kind + *count, standing));
                *count += 1;
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

    /// Returns the panels of the figure of states. They show every state, or the outputs that the scene lists. `Err` if
    /// the outputs of the scene cannot be compared.
    fn states(&self, scene: &Scene, runs: &SceneRuns) -> Result<Vec<Panel>, Failure> {
        let curves = run_panels::merge_equal_curves(derived_page_run_curves(runs, |_| true));
        if !scene.states_outputs {
            return Ok(run_panels::state_panels(self.model, &curves));
        }
        let compared = ComparedQuantities::new(self.model, scene)?;
        let values: Vec<_> = curves
            .into_iter()
            .map(|curve| {
                let values = page_run_outputs(&compared, curve.run);
                (curve, values)
            })
            .collect();
        Ok(run_panels::outputs(self.model, scene, &values))
    }

    /// Writes the section of the page for a scene: draws all its figures and fills the table of
    /// runs.
    /// `Err` if a figure cannot be drawn or a file cannot be written.
    fn section(&self, scene: &Scene, runs: SceneRuns, out: &Path, bar: &ProgressBar) -> Result<SceneSection, Failure> {
        let folder = run_figure_folder(self.model, scene);
        let mut measured = StudyFigures::new(self.model, scene, out, folder.clone());
        let mut drawn = RunFigureWriter { out, folder, names: BTreeMap::new() };
        let mut shown = Vec::new();
        for figure in &scene.figures {
            let (kind, caption) = (figure.kind, figure.caption.as_str());
            bar.set_message(format!("{} of {}", kind.name(), path_as_plain_text(&scene.source.path)));
            shown.extend(match kind {
                FigureKind::Energy => {
                    let curves = run_panels::merge_equal_curves(derived_page_run_curves(&runs, |own| {
                        !own.run.energies.is_empty()
                    }));
                    let caption = run_figure_caption(caption, &run_panels::run_figure_sentences(&curves));
                    Some(drawn.figure(kind.name(), &caption, &[run_panels::energy_panel(&curves)], 1)?)
                }
                FigureKind::States => {
                    let caption = run_figure_caption(
                        caption,
                        &run_panels::run_figure_sentences(&run_panels::merge_equal_curves(derived_page_run_curves(
                            &runs,
                            |_| true,
                        ))),
                    );
                    Some(drawn.figure(kind.name(), &caption, &self.states(scene, &runs)?, 2)?)
                }
                _ => measured.figure(kind, caption)?,
            });
            bar.inc(1);
        }
        let (curves, note) = self.curves_to_draw(&runs);
        let note = note.map(|note| format!(" {note}")).unwrap_or_default();
        let mut integrals = None;
        // Impacts change quantities that motion without impacts conserves.
        if !curves.is_empty() && !self.watch.integrals.is_empty() && scene.impacts.is_empty() {
            let curves = run_panels::merge_equal_curves(curves.clone());
            let panels = run_panels::integrals(&self.watch, &curves);
            let caption = "First integrals: how far each is from its value at the start, on logarithmic scales. What lies \
                           at the lower edge does not change; what lies at the upper edge is beyond it.";
            let said = run_panels::run_figure_sentences(&curves);
            integrals = Some(run_figure(&format!("{caption} {said}{note}"), &panels, panels.len().min(2))?);
        }
        let mut nearness = None;
        if !curves.is_empty() {
            let caption = "How near the matrix A of the accelerations comes to a singular one, and the kinematic equations \
                           to a division by zero, on logarithmic scales.";
            let said = run_panels::run_figure_sentences(&curves);
            nearness = Some(run_figure(
                &format!("{caption} {said}{note}"),
                &run_panels::singularity_panels(&self.watch, &curves),
                2,
            )?);
        }
        let mut facts = scene_facts(self.model, scene);
        facts.extend(runs.derived.first().and_then(|(run, _)| impacts_words(run)));
        let mut standings = runs.standings.iter().cloned();
        let mut next = || standings.next().unwrap_or(Standing::Right);
        let mut rows: Vec<RunRow> = runs.derived.iter().map(|(run, course)| row(scene, run, course, next())).collect();
        rows.extend(runs.own.iter().map(|own| reduced_run_row(scene, own, next())));
        rows.extend(runs.printed.iter().map(|(run, course)| row(scene, run, course, next())));
        Ok(SceneSection {
            file: path_as_plain_text(&scene.source.path),
            title: scene_title(scene),
            about: scene.about.clone(),
            facts,
            runs: rows,
            claims: claims::judged_claims(self.model, scene, &self.set),
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

/// Returns the curves of the runs by derived equations. The run by reduced equations is included if `shows` is true for
/// it.
fn derived_page_run_curves(runs: &SceneRuns, shows: impl Fn(&ReducedRun) -> bool) -> Vec<RunCurves<'_>> {
    let own =
        runs.own.iter().filter(|own| shows(own)).map(|own| (&own.run, own.course.as_ref().unwrap_or(&EMPTY_COURSE)));
    let derived = runs.derived.iter().map(|(run, course)| (run, course));
    let all = derived.chain(own).zip(&runs.standings);
    all.map(|((run, course), standing)| RunCurves::new(run, course, styles::equations_style(&run.by), standing))
        .collect()
}
