//! Figures of steady motions followed along a number: eigenvalues over one number, and changes of
//! stability over two.

use crate::files::output_files::{refuse_overwriting_inputs, write_table_file};
use crate::picture::{self, PictureFormat};
use crate::plot::{Panel, Scale, Series, draw};
use crate::terminal::failure::{Failure, print_to_stderr};
use std::path::Path;
use tripos::studies::steady::{Continuation, ContinuationMap, CrossingKind};
use tripos::{Error, Mechanism};
use tripos_codegen::draft_file::draft_would_change;
use tripos_derive::plain_text::path_as_plain_text;

/// Refuses a figure whose file name has an unknown extension, and a figure that would overwrite an
/// input file.
///
/// # Errors
/// [`Failure`] that names the file and the reason.
pub fn check_equilibria_figure_path(out: &Path, model: &Mechanism, from: &Path) -> Result<(), Failure> {
    kind(out)?;
    let data = out.with_extension("csv");
    if [out, &data].iter().any(|place| draft_would_change(place, from)) {
        let what = format!(
            "the output `{}` would overwrite the input `{}`",
            path_as_plain_text(out),
            path_as_plain_text(from)
        );
        return Err(Failure::request(what, "give another file".to_owned()));
    }
    refuse_overwriting_inputs(model, None, [out, &data])
}

/// Returns the file format of the figure, by the extension of its file name.
/// `Err` for an unknown extension.
fn kind(out: &Path) -> Result<PictureFormat, Failure> {
    picture::picture_format(out, "; its data go beside it, in .csv")
}

/// Draws the real and imaginary parts of all eigenvalues, 1/s and rad/s, over a number, and writes
/// their data.
///
/// # Errors
/// [`Failure`] if a file cannot be written.
pub fn draw_eigenvalues(out: &Path, name: &str, course: &Continuation) -> Result<(), Failure> {
    let modes =
        || course.points.iter().flat_map(|point| point.about.modes.iter().map(|mode| (point.value, mode.value)));
    let growth: Vec<(f64, f64)> = modes().map(|(value, [re, _])| (value, re)).collect();
    let frequency: Vec<(f64, f64)> =
        modes().filter(|(_, [_, im])| *im > 0.0).map(|(value, [_, im])| (value, im)).collect();
    let panels = [
        panel(name, "Growth", "real part [1/s]", vec![separate_points("real part", 0, &growth)]),
        panel(name, "Frequency", "imaginary part [rad/s]", vec![separate_points("imaginary part", 1, &frequency)]),
    ];
    let rows = modes().map(|(value, [re, im])| [value, re, im].map(|x| x.to_string()).to_vec());
    write_equilibria_figure(out, &panels, &[name, "real", "imaginary"], rows)
}

/// Draws the map of stability changes. For each value of the second number, it shows the values of the first number at
/// which an eigenvalue crosses the imaginary axis.
///
/// # Errors
/// [`Failure`] if a file cannot be written.
pub fn draw_stability_map(out: &Path, [first, second]: [&str; 2], found: &ContinuationMap) -> Result<(), Failure> {
    let kinds = [
        (CrossingKind::Real, "a real eigenvalue passes 0"),
        (CrossingKind::Pair, "a pair passes the imaginary axis"),
        (CrossingKind::Fold, "it ends"),
    ];
    let courses = || found.rows.iter().filter_map(|(value, course)| Some((*value, course.as_ref().ok()?)));
    let crossings = || courses().flat_map(|(row, course)| course.crossings.iter().map(move |c| (c, row)));
    let mut series = Vec::new();
    for (style, (kind, label)) in kinds.into_iter().enumerate() {
        let points: Vec<(f64, f64)> =
            crossings().filter(|(c, _)| c.kind == kind).map(|(c, row)| (c.value, row)).collect();
        if !points.is_empty() {
            series.push(separate_points(label, style, &points));
        }
    }
    let unstable: Vec<(f64, f64)> = courses()
        .flat_map(|(row, course)| course.points.iter().map(move |point| (point, row)))
        .filter(|(point, _)| point.about.stability == tripos::studies::steady::Stability::Unstable)
        .map(|(point, row)| (point.value, row))
        .collect();
    if !unstable.is_empty() {
        series.insert(0, separate_points("unstable", UNSTABLE, &unstable));
    }
    let panels = [panel(first, "Where stability changes", second, series)];
    let rows = crossings()
        .map(|(c, row)| vec![row.to_string(), c.kind.name().to_owned(), c.value.to_string(), c.frequency.to_string()]);
    write_equilibria_figure(out, &panels, &[second, "kind", first, "frequency"], rows)
}

/// Number of the curve style for unstable motions, a pale colour.
const UNSTABLE: usize = 14;

/// Returns a series of separate points, without a line between them.
fn separate_points(label: &str, style: usize, points: &[(f64, f64)]) -> Series {
    let apart = points.iter().flat_map(|point| [*point, (f64::NAN, f64::NAN)]).collect();
    let mut series = Series::curve(label.to_owned(), style, apart);
    // A bar without length for each point: series with bars have a marker for each point.
    series.spread = points.iter().flat_map(|(x, _)| [(*x, *x), (f64::NAN, f64::NAN)]).collect();
    series
}

/// Returns a panel with linear axes. `x` and `y` are the labels of the axes.
fn panel(x: &str, title: &str, y: &str, series: Vec<Series>) -> Panel {
    Panel {
        title: title.to_owned(),
        x_label: x.to_owned(),
        y_label: y.to_owned(),
        scale: Scale::Linear,
        x_scale: Scale::Linear,
        series,
        note: None,
    }
}

/// Draws panels to a figure file and writes their data to a CSV file with the same name.
///
/// # Errors
/// [`Failure`] if a file cannot be written.
fn write_equilibria_figure(
    out: &Path,
    panels: &[Panel],
    header: &[&str],
    rows: impl IntoIterator<Item = Vec<String>>,
) -> Result<(), Failure> {
    let svg = draw(panels, 1).map_err(|error| Failure::from(Error::Stopped(error.to_string())))?;
    picture::write_picture(out, kind(out)?, &svg, picture::DPI)?;
    let data = out.with_extension("csv");
    write_table_file(&data, header, rows)?;
    print_to_stderr(&format!("figure   {}\ndata     {}", path_as_plain_text(out), path_as_plain_text(&data)));
    Ok(())
}
