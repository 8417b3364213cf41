//! Command `tripos plot`: draws quantities of runs as a figure, with its data in a CSV file.

use crate::arguments::Plot;
use crate::files::output_files::{refuse_overwriting_inputs, write_table_file};
use crate::files::scene_file::{SceneWithSetValues, read_scene_with};
use crate::picture::{self, PictureFormat};
use crate::plot::{Panel, Scale, Series, draw, figure_text_in_symbols};
use crate::terminal::failure::{Failure, Output, print_result, print_to_stderr, status, warn};
use crate::terminal::interruption;
use serde_json::json;
use std::path::{Path, PathBuf};
use tripos::equations_name::find_equations_or_first;
use tripos::{EquationsName, Error, Mechanism, Overrides, Run, WatchedInvariants, simulate};
use tripos_derive::model::TIME;
use tripos_derive::plain_text::path_as_plain_text;
use tripos_derive::scene::{ENERGIES, Scene, load_output};
use tripos_sim::Stop;

/// Value of the option `--what` that means all first integrals.
const INTEGRALS: &str = "integrals";
/// Largest number of panels that are placed in one column. More panels are placed in two columns.
const ONE_COLUMN: usize = 3;

/// Quantities that a figure shows, and the quantity on its horizontal axis.
struct PlotQuantities {
    /// Names of the quantities of each panel.
    panels: Vec<Vec<String>>,
    /// True if all first integrals are shown, too, each in its own panel.
    integrals: bool,
    /// Name of the quantity on the horizontal axis, such as the time.
    against: String,
}

/// Run of a scene whose quantities are drawn, with the label of its curves.
struct PlottedRun {
    /// Label of the run's curves in the legend.
    label: String,
    /// Run with the values of the quantities to draw.
    run: Run,
    /// Model of the mechanism in the scene.
    model: Mechanism,
    /// Scene that was run, with the quantities to draw as outputs.
    scene: Scene,
    /// Changes of the first integrals along the run; empty if they are not shown.
    integrals: Vec<IntegralChange>,
}

/// Change of a first integral along a run, since the start.
struct IntegralChange {
    /// Name of the first integral, such as the energy.
    name: String,
    /// Unit of the first integral, as text.
    unit: String,
    /// Absolute change since the start at each sample, in `unit`.
    changes: Vec<f64>,
}

/// Runs `tripos plot`: runs the scenes, draws the requested quantities, and writes the figure and its data. Returns the
/// exit status.
///
/// # Errors
/// [`Failure`] if a scene cannot be read or run, if a quantity is unknown, or if a file cannot be written.
pub fn plot(request: &Plot) -> Result<u8, Failure> {
    let wanted = PlotQuantities::new(request);
    let (out, kind) = figure_path(request)?;
    let dpi = picture::check_dpi(request.dpi)?;
    let ways = run_variants(request)?;
    interruption::listen_for_interruption();
    let mut curves = Vec::new();
    for path in &request.scenes {
        for (words, way) in &ways {
            let curve = PlottedRun::new(path, way, words, &wanted, request)?;
            refuse_overwriting_inputs(&curve.model, Some(&curve.scene), [out.as_path(), &plot_data_path(&out)])?;
            curves.push(curve);
        }
    }
    let panels = panels(&wanted, &curves)?;
    let columns = if panels.len() > ONE_COLUMN { 2 } else { 1 };
    let mut lines = Vec::new();
    if let Some(kind) = kind {
        let svg = draw(&panels, columns).map_err(|error| Failure::from(Error::Stopped(error.to_string())))?;
        picture::write_picture(&out, kind, &svg, dpi)?;
        lines.push(format!("figure   {}\n", path_as_plain_text(&out)));
    }
    let data = plot_data_path(&out);
    write_data(&data, &panels)?;
    lines.push(format!("data     {}\n", path_as_plain_text(&data)));
    let runs = curves.iter().map(|curve| {
        json!({
            "label": curve.label, "equations": curve.run.by.title(), "failure": curve.run.failure(),
            "notes": curve.run.notes, "warnings": curve.run.warnings,
        })
    });
    let value = json!({
        "figure": kind.is_some().then(|| path_as_plain_text(&out)), "data": path_as_plain_text(&data), "runs": runs.collect::<Vec<_>>(),
        "panels": panels.iter().map(|panel| figure_text_in_symbols(&panel.title)).collect::<Vec<_>>(),
    });
    print_result(Output::of_flag(request.json), &lines.concat(), &value)?;
    let interrupted = curves.iter().any(|curve| curve.run.solution.stop == Stop::Interrupted);
    Ok(match interrupted {
        true => status::INTERRUPTED,
        false if curves.iter().any(|curve| curve.run.failure().is_some()) => status::STOPPED,
        false => 0,
    })
}

impl PlotQuantities {
    fn new(request: &Plot) -> Self {
        let names = |text: &String| split_plot_list(text).into_iter().map(str::to_owned).collect::<Vec<String>>();
        let (all, others): (Vec<_>, Vec<_>) = request.what.iter().map(names).partition(|list| list[..] == [INTEGRALS]);
        let against = request.against.clone().unwrap_or_else(|| TIME.to_owned());
        Self { panels: others, integrals: !all.is_empty(), against }
    }

    /// Returns the names of all quantities that the runs must output, without repetition.
    fn quantities(&self) -> Vec<String> {
        let mut list: Vec<String> = Vec::new();
        let against = Some(&self.against).filter(|against| *against != TIME);
        for name in self.panels.iter().flatten().chain(against) {
            if !list.contains(name) {
                list.push(name.clone());
            }
        }
        list
    }
}

/// Splits a text at its commas, except at commas inside parentheses or brackets.
fn split_plot_list(text: &str) -> Vec<&str> {
    let (mut list, mut depth, mut from) = (Vec::new(), 0_i32, 0);
    for (at, c) in text.char_indices() {
        match c {
            '(' | '[' => depth += 1,
            ')' | ']' => depth -= 1,
            ',' if depth == 0 => {
                list.push(text[from..at].trim());
                from = at + 1;
            }
            _ => {}
        }
    }
    list.push(text[from..].trim());
    list
}

/// Returns the path of the figure and its file format. The format is `None` if the file name ends in `.csv`, which
/// requests the data alone.
///
/// # Errors
/// [`Failure`] if the extension is that of no format.
fn figure_path(request: &Plot) -> Result<(PathBuf, Option<PictureFormat>), Failure> {
    let named = || request.scenes.first().and_then(|scene| scene.file_stem()).map(PathBuf::from).unwrap_or_default();
    let out = request.out.clone().unwrap_or_else(|| named().with_extension("svg"));
    let is_data_alone = out.extension().is_some_and(|extension| extension == "csv");
    let kind =
        if is_data_alone { None } else { Some(picture::picture_format(&out, ", or in .csv for the data alone")?) };
    Ok((out, kind))
}

/// Returns the path of the CSV file with the figure's data.
fn plot_data_path(out: &Path) -> PathBuf {
    out.with_extension("csv")
}

/// Returns the settings with which each scene is run, each with its description: first those of the options, then one
/// for each `--also`.
///
/// # Errors
/// [`Failure`] if an option is not understood.
fn run_variants(request: &Plot) -> Result<Vec<(String, Overrides)>, Failure> {
    let base = request.how.overrides()?;
    let mut list = vec![(String::new(), base.clone())];
    for also in &request.also {
        let mut way = base.clone();
        for part in split_plot_list(also) {
            let wrong = || {
                let what = format!("`{part}` is no way to run a scene");
                Failure::request(
                    what,
                    "write --also method=taylor,rtol=1e-9; by, method, solve, step, rtol and atol are known".to_owned(),
                )
            };
            let (key, value) = part.split_once('=').ok_or_else(wrong)?;
            let number = || value.trim().parse::<f64>().map(Some).map_err(|_| wrong());
            match key.trim() {
                "by" => way.by = Some(value.trim().into()),
                "method" => way.method = Some(value.trim().parse().map_err(Error::from)?),
                "solve" => way.solve = Some(value.trim().parse().map_err(Error::from)?),
                "step" => way.step = number()?,
                "rtol" => way.rtol = number()?,
                "atol" => way.atol = number()?,
                _ => return Err(wrong()),
            }
        }
        list.push((also.clone(), way));
    }
    Ok(list)
}

impl PlottedRun {
    /// Reads a scene, runs it with the settings `way`, and keeps the requested quantities. `words` describe the
    /// settings.
    ///
    /// # Errors
    /// [`Failure`] if the scene cannot be read or run, or if a quantity is unknown.
    fn new(
        path: &Path,
        way: &Overrides,
        words: &str,
        wanted: &PlotQuantities,
        request: &Plot,
    ) -> Result<Self, Failure> {
        let SceneWithSetValues { mut model, mut scene, .. } = read_scene_with(path, &request.set.set)?;
        let quantities = wanted.quantities();
        if !quantities.is_empty() {
            let own = std::mem::take(&mut scene.outputs);
            let named = |what: &String| own.iter().find(|output| output.name == *what).cloned();
            let outputs: Result<Vec<_>, _> =
                quantities.iter().map(|what| named(what).map_or_else(|| load_output(what, &mut model), Ok)).collect();
            scene.outputs = outputs?;
            scene.states_outputs = true;
        }
        way.apply_to_scene(&mut scene)?;
        // First integrals need the values of all coordinates and speeds.
        let by = match &way.by {
            None if wanted.integrals => Some(EquationsName::from(&find_equations_or_first(&model, None)?)),
            by => by.clone(),
        };
        interruption::show_progress_bar(scene.span);
        let run = simulate(&model, &scene, by.as_ref())?;
        interruption::hide_progress_bar();
        run.notes.iter().for_each(|note| print_to_stderr(&format!("note: {note}")));
        run.warnings.iter().for_each(|warning| warn(warning));
        if let Some(failure) = run.failure() {
            print_to_stderr(&failure);
        }
        let integrals = if wanted.integrals { integrals(&model, &scene, &run)? } else { Vec::new() };
        let named = if scene.title.is_empty() { path_as_plain_text(path) } else { scene.title.clone() };
        let label = match (request.scenes.len() > 1, words.is_empty()) {
            (false, true) => run.by.title(),
            (false, false) => words.to_owned(),
            (true, true) => named,
            (true, false) => format!("{named}, {words}"),
        };
        Ok(Self { label, run, model, scene, integrals })
    }

    /// Returns the values of a quantity along the run, with one value for each sample.
    ///
    /// # Errors
    /// `Error` if the run has no such quantity.
    fn values(&self, name: &str) -> Result<Vec<f64>, Error> {
        if name == TIME { Ok(self.run.solution.t.clone()) } else { self.run.column_of_quantity(name) }
    }

    /// Returns the axis label of a quantity: its name and unit.
    fn label_of(&self, name: &str) -> String {
        let output = self.scene.outputs.iter().find(|output| output.name == name);
        let unit = output.and_then(|output| self.model.unit_label(&self.model.arena, output.value));
        let unit = match unit {
            _ if name == TIME => "s".to_owned(),
            _ if ENERGIES.contains(&name) => "J".to_owned(),
            Some(unit) => unit,
            None => "SI".to_owned(),
        };
        format!("{name} [{unit}]")
    }
}

/// Returns the changes of all first integrals of a model along a run.
/// `Err` if the first integrals cannot be found.
fn integrals(model: &Mechanism, scene: &Scene, run: &Run) -> Result<Vec<IntegralChange>, Failure> {
    let watch = WatchedInvariants::of_model(model)?;
    // A state of the run contains coordinates and speeds first, then outputs.
    let count = model.coordinates.len() + model.speeds.len();
    let states: Vec<Vec<f64>> = run.states.iter().map(|state| state[..count].to_vec()).collect();
    let (values, _) = watch.invariants_along_states(&scene.parameters, &states);
    let changes = watch.integrals.iter().zip(values).map(|(integral, values)| {
        let first = values.first().copied().unwrap_or(f64::NAN);
        let changes = values.iter().map(|value| (value - first).abs()).collect();
        IntegralChange { name: integral.name.clone(), unit: integral.unit.clone(), changes }
    });
    Ok(changes.collect())
}

/// Returns the panels of the figure. Each panel has a curve for each run and each of its
/// quantities.
/// `Err` if a run lacks a quantity.
fn panels(wanted: &PlotQuantities, curves: &[PlottedRun]) -> Result<Vec<Panel>, Failure> {
    let Some(first) = curves.first() else { return Ok(Vec::new()) };
    let shown: Vec<Vec<String>> = match (wanted.panels.is_empty(), wanted.integrals) {
        (true, false) => first.scene.outputs.iter().map(|output| vec![output.name.clone()]).collect(),
        _ => wanted.panels.clone(),
    };
    let mut panels = Vec::new();
    for names in &shown {
        let mut series = Vec::new();
        for curve in curves {
            let x = curve.values(&wanted.against)?;
            for name in names {
                let points = x.iter().copied().zip(curve.values(name)?).collect();
                let label = match (names.len() > 1, curves.len() > 1) {
                    (true, true) => format!("{name}, {}", curve.label),
                    (_, false) => name.clone(),
                    (false, true) => curve.label.clone(),
                };
                series.push(Series::curve(label, series.len(), points));
            }
        }
        let labels: Vec<String> = names.iter().map(|name| first.label_of(name)).collect();
        panels.push(panel(
            &names.join(", "),
            &first.label_of(&wanted.against),
            labels.join(", "),
            Scale::Linear,
            series,
        ));
    }
    for (at, IntegralChange { name, unit, .. }) in first.integrals.iter().enumerate() {
        let of_curve = |(style, curve): (usize, &PlottedRun)| {
            let points = curve.run.solution.t.iter().copied().zip(curve.integrals[at].changes.iter().copied());
            let label = if curves.len() > 1 { &curve.label } else { name };
            Series::curve(label.clone(), style, points.skip(1).collect())
        };
        let with_it = curves.iter().filter(|curve| curve.integrals.len() > at);
        let series: Vec<Series> = with_it.enumerate().map(of_curve).collect();
        let is_kept = series.iter().flat_map(|series| &series.points).all(|(_, change)| *change <= 0.0);
        let mut shown = panel(name, "t [s]", format!("change of {name} [{unit}]"), Scale::Logarithmic, series);
        shown.note = is_kept.then(|| "does not change in any digit".to_owned());
        panels.push(shown);
    }
    Ok(panels)
}

/// Returns a panel whose horizontal axis is linear.
fn panel(title: &str, x_label: &str, y_label: String, scale: Scale, series: Vec<Series>) -> Panel {
    Panel {
        title: title.to_owned(),
        x_label: x_label.to_owned(),
        y_label,
        scale,
        x_scale: Scale::Linear,
        series,
        note: None,
    }
}

/// Writes every point of the figure to a CSV file: panel, curve, horizontal quantity and both
/// coordinates.
/// `Err` if the file cannot be written.
fn write_data(path: &Path, panels: &[Panel]) -> Result<(), Failure> {
    let rows = panels.iter().flat_map(|panel| {
        panel.series.iter().flat_map(move |series| {
            series.points.iter().map(move |(x, y)| {
                vec![
                    figure_text_in_symbols(&panel.title),
                    series.label.clone(),
                    panel.x_label.clone(),
                    x.to_string(),
                    y.to_string(),
                ]
            })
        })
    });
    write_table_file(path, &["panel", "curve", "against", "x", "y"], rows)
}

#[cfg(test)]
mod tests {
    use super::split_plot_list;

    #[test]
    fn lists_are_parted_at_their_own_commas() {
        assert_eq!(split_plot_list("q1, v(disk, P) @ A [1]"), ["q1", "v(disk, P) @ A [1]"]);
        assert_eq!(split_plot_list("total_energy"), ["total_energy"]);
    }
}
