//! Figures of a scene that need further runs: speed against accuracy, passages of singular places, and conditioning.
//!
//! Invariant: every point of these figures is in a table in the scene's folder.

use super::run_figures::run_figure_caption;
use crate::chart::sentences::{TARGETS, chart_caption, chart_recommendation, fastest};
use crate::chart::{chart_tables, figure};
use crate::files::output_files::make_folder as make;
use crate::page::{Advice, Figure, RecommendedRun};
use crate::stability::{passage_sentences, write_stability_tables};
use crate::terminal::failure::Failure;
use std::path::{Path, PathBuf};
use tripos::Mechanism;
use tripos::studies::chart_case::PrintedEquationsChoice;
use tripos::studies::stability::{Findings, StudyInputs, TopicStudy, conditioning, passages};
use tripos::studies::work_precision_chart::{ChartPlan, scene_chart};
use tripos_derive::scene::{FigureKind, Scene};

/// Measurements of a scene for its figures. Each is made when a figure first needs it.
pub struct StudyFigures<'a> {
    /// Model of the mechanism in the scene.
    model: &'a Mechanism,
    /// Scene whose runs are measured.
    scene: &'a Scene,
    /// Path of the page's folder.
    out: &'a Path,
    /// Folder of the scene's tables, relative to the folder of the page.
    folder: PathBuf,
    /// Results of the stability studies made so far.
    findings: Findings,
    /// Recommendation of a method from the speed chart; `None` if the chart was not measured.
    pub advice: Option<Advice>,
    /// Reasons why figures cannot be drawn for this scene, one sentence each.
    pub not_drawn: Vec<String>,
}

impl<'a> StudyFigures<'a> {
    /// Prepares the measurements of a scene; nothing is measured yet.
    pub fn new(model: &'a Mechanism, scene: &'a Scene, out: &'a Path, folder: PathBuf) -> Self {
        Self { model, scene, out, folder, findings: Findings::default(), advice: None, not_drawn: Vec::new() }
    }

    /// Measures and draws a figure. Its caption begins with `own`. `None` if the scene cannot have this figure; the
    /// reason is then in [`Self::not_drawn`].
    ///
    /// # Errors
    /// [`Failure::Output`] if the table of the figure cannot be written.
    pub fn figure(&mut self, kind: FigureKind, own: &str) -> Result<Option<Figure>, Failure> {
        let result = match kind {
            FigureKind::WorkPrecision => self.work_precision(),
            FigureKind::Passages => self.passages(),
            FigureKind::Conditioning => self.conditioning(),
            FigureKind::Energy | FigureKind::States => Ok(None),
        };
        match result {
            Ok(figure) => {
                Ok(figure.map(|figure| Figure { caption: run_figure_caption(own, &figure.caption), ..figure }))
            }
            Err(Failure::Output(path, error)) => Err(Failure::Output(path, error)),
            // A figure that fails does not end the writing of the page.
            Err(failure) => {
                let why = failure.to_string().trim_start_matches("error: ").replace('\n', "; ");
                self.not_drawn.push(format!("The figure `{}` cannot be drawn: {why}", kind.name()));
                Ok(None)
            }
        }
    }

    /// Makes the folder for a table. Returns the folder, and the link from the page to the table `name`. `Err` if the
    /// folder cannot be made.
    fn make_table_folder(&self, name: &str) -> Result<(PathBuf, String), Failure> {
        let folder = self.out.join(&self.folder);
        make(&folder)?;
        Ok((folder, format!("{}/{name}", self.folder.display())))
    }

    /// Measures speed against accuracy, and draws the speed chart. Always returns a figure. `Err` if the measurement
    /// fails or a table cannot be written.
    fn work_precision(&mut self) -> Result<Option<Figure>, Failure> {
        let session = scene_chart::chart_scene(
            self.model,
            self.scene,
            PrintedEquationsChoice::LeftOut,
            &ChartPlan::quick(),
            &(),
        )?;
        let (folder, link) = self.make_table_folder("work_precision.csv")?;
        chart_tables::write_chart_tables(&folder, &session.list, &session.watch.integrals)?;
        let choice = |target: f64| {
            let m = fastest(&session.list, target, |_| true)?;
            Some(RecommendedRun {
                equations: m.by.name(),
                solve: m.way.solve(m.solve),
                method: m.way.name(),
                tolerance: m.way.tolerance(),
                seconds: m.seconds.median,
                error: m.error?,
            })
        };
        let rows = TARGETS.into_iter().map(|target| (target, choice(target))).collect();
        self.advice = Some(Advice { lead: chart_recommendation(&session.list), rows });
        let cut = session.cut.map_or_else(String::new, |cut| format!(" Note: {cut}."));
        let compared = session.compared.map_or_else(String::new, |said| format!(" {said}"));
        let seen = chart_caption(&session.list, session.until);
        let caption = format!("{seen}{compared} The reference: {}.{cut}", session.reference.how);
        let svg = figure::draw_speed_chart(&session.list, session.reference.uncertainty)?;
        Ok(Some(Figure { caption, svg, remark: None, data: vec![link] }))
    }

    /// Runs the study of passages near singular places, and draws its figure. `None` if the motion
    /// has no such passage.
    /// `Err` if the study fails or a table cannot be written.
    fn passages(&mut self) -> Result<Option<Figure>, Failure> {
        let Some(svg) = self.draw_study(FigureKind::Passages, passages::study_passages)? else { return Ok(None) };
        let data = self.write_study_tables(&["passages.csv", "stability.csv"])?;
        let remark = passage_sentences::lagrange_passage_sentence(self.model, &self.findings.passages);
        Ok(Some(Figure { caption: passage_sentences::passages_caption(self.model, &self.findings), svg, remark, data }))
    }

    /// Runs the study of conditioning, and draws its figure. `None` if the motion does not come
    /// near a singular place.
    /// `Err` if the study fails or a table cannot be written.
    fn conditioning(&mut self) -> Result<Option<Figure>, Failure> {
        let Some(svg) = self.draw_study(FigureKind::Conditioning, conditioning::study_conditioning)? else {
            return Ok(None);
        };
        let data = self.write_study_tables(&["stability.csv"])?;
        Ok(Some(Figure {
            caption: passage_sentences::passage_conditioning_caption(self.model, &self.findings),
            svg,
            remark: None,
            data,
        }))
    }

    /// Writes the tables of all studies made so far. Returns the links to the tables with these names. `Err` if a table
    /// cannot be written.
    fn write_study_tables(&self, names: &[&str]) -> Result<Vec<String>, Failure> {
        let (folder, _) = self.make_table_folder("")?;
        write_stability_tables(&self.findings, &folder)?;
        names.iter().map(|name| Ok(self.make_table_folder(name)?.1)).collect()
    }

    /// Runs a study of stability and draws its figure. `None` if the motion does not come near a
    /// place where the kinematic equations divide by zero.
    /// `Err` if the study fails.
    fn draw_study(&mut self, kind: FigureKind, run: TopicStudy) -> Result<Option<String>, Failure> {
        let before = self.findings.figures.len();
        run(&StudyInputs { model: self.model, scene: self.scene, quick: true, progress: &() }, &mut self.findings)?;
        let svg = self.findings.figures.get(before).map(|(_, figure)| figure::draw_figure_svg(figure)).transpose()?;
        if svg.is_none() {
            let why = "the motion does not come near a place where the kinematic equations divide by zero";
            self.not_drawn.push(format!("The figure `{}` cannot be drawn: {why}", kind.name()));
        }
        Ok(svg)
    }
}
