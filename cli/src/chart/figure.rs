//! Figure of a speed chart: error against run time, with one panel for methods, one for formulations and one for
//! solves.

use super::sentences::{is_derived, is_whole};
use crate::plot::styles::{BY_QUADRATURE, FRONT, METHODS, MOST_PRINTED, NUMERIC, PRINTED, equations_style};
use crate::plot::{Figure, Panel, PlotError, Scale, Series, draw, draw_heat};
use crate::terminal::failure::Failure;
use tripos::studies::chart_case::MethodAtTolerance;
use tripos::studies::work_precision_chart::Measurement;
use tripos_derive::mechanics::EquationsOrigin;
use tripos_derive::scene::AccelerationSolution;
use tripos_sim::Method;
use tripos_sim::work_precision::work_precision_front;

/// Draws the speed chart as one `<svg>` element, with one panel for methods, one for formulations and one for solves.
/// `uncertainty` is the relative error of the reference solution.
///
/// # Errors
/// [`Failure::Output`] if the figure cannot be drawn.
pub fn draw_speed_chart(list: &[Measurement], uncertainty: f64) -> Result<String, Failure> {
    draw(&chart_panels(list, uncertainty), 3).map_err(|error| chart_figure_failure(&error))
}

/// Draws a figure of any kind, with panels or a heat map, as one `<svg>` element.
///
/// # Errors
/// [`Failure::Output`] if the figure cannot be drawn.
pub fn draw_figure_svg(figure: &Figure) -> Result<String, Failure> {
    let svg = match figure {
        Figure::Panels(panels, columns) => draw(panels, *columns),
        Figure::HeatMap(map) => draw_heat(map),
    };
    svg.map_err(|error| chart_figure_failure(&error))
}

/// Returns the failure for a figure that could not be drawn.
pub fn chart_figure_failure(error: &PlotError) -> Failure {
    Failure::Output("the figure".to_owned(), std::io::Error::other(error.to_string()))
}

/// Returns the panels of the speed chart: methods, formulations, solves. `uncertainty` is the
/// relative error of the reference solution.
pub fn chart_panels(list: &[Measurement], uncertainty: f64) -> Vec<Panel> {
    // The first formulation of the list and the best method represent all others.
    let Some(Measurement { by: first, solve: natural, .. }) = list.first() else { return Vec::new() };
    let best = Method::Dop853;
    let is_best = |m: &Measurement| m.way.method() == Some(best);
    let method = |m: &Measurement| {
        let at = m.way.method().and_then(|method| Method::ALL.into_iter().position(|other| other == method))?;
        (m.by == *first && m.solve == *natural).then(|| (m.way.name().to_owned(), METHODS + at))
    };
    let formulation = |m: &Measurement| match m.way {
        MethodAtTolerance::Quadrature => Some((format!("{}, {}", m.by.name(), m.way.name()), BY_QUADRATURE)),
        _ => (is_best(m) && m.solve == *natural).then(|| (m.by.name(), own_style(list, &m.by))),
    };
    // Runs with eliminated accelerations have the same curve names here as in the panel of formulations.
    let solve = |m: &Measurement| {
        let shown = is_best(m) && is_whole(m) && is_derived(m);
        let (name, style) = match m.solve {
            AccelerationSolution::Numeric => (m.solve.name().to_owned(), NUMERIC),
            AccelerationSolution::Eliminated => (m.by.name(), own_style(list, &m.by)),
        };
        shown.then_some((name, style))
    };
    let (first, natural, best) = (first.name(), natural.name(), best.name());
    vec![
        chart_panel(list, &format!("Which method: {first}, {natural}"), &method, uncertainty),
        chart_panel(list, &format!("Which formulation: {best}, {natural}"), &formulation, uncertainty),
        chart_panel(list, &format!("Which solve: {best}"), &solve, uncertainty),
    ]
}

/// Returns the style number of the curve for a set of equations. Each printed set of equations has
/// its own style.
fn own_style(list: &[Measurement], by: &EquationsOrigin) -> usize {
    let mut printed: Vec<&EquationsOrigin> = Vec::new();
    for m in list.iter().filter(|m| m.by.printed_id().is_some()) {
        if !printed.contains(&&m.by) {
            printed.push(&m.by);
        }
    }
    printed.iter().position(|other| *other == by).map_or_else(|| equations_style(by), |at| PRINTED + at % MOST_PRINTED)
}

/// Function from a measurement to its curve: name in the legend and style number. `None` if the
/// panel does not show the measurement.
type CurveOfMeasurement<'a> = &'a dyn Fn(&Measurement) -> Option<(String, usize)>;

/// Returns a panel of the speed chart. `group` assigns the measurements to curves; the Pareto front and a note are
/// added.
fn chart_panel(list: &[Measurement], title: &str, group: CurveOfMeasurement<'_>, uncertainty: f64) -> Panel {
    let shown: Vec<((String, usize), &Measurement)> = list.iter().filter_map(|m| Some((group(m)?, m))).collect();
    // Curves of the same name and style may belong to several sets of equations.
    let mut curves: Vec<(&(String, usize), &EquationsOrigin)> = Vec::new();
    for (name, m) in &shown {
        if !curves.contains(&(name, &m.by)) {
            curves.push((name, &m.by));
        }
    }
    let points: Vec<(f64, f64)> = shown.iter().map(|(_, m)| chart_point(m)).collect();
    let front: Vec<(f64, f64)> = work_precision_front(&points).into_iter().map(|at| points[at]).collect();
    // The points of the front are measurements, too. They get a bar without length, so that markers are drawn at these
    // points and not along the line.
    let spread = front.iter().map(|(x, _)| (*x, *x)).collect();
    let mut series =
        vec![Series { label: "Pareto front".to_owned(), style: FRONT, points: front, spread, band: Vec::new() }];
    for (name, by) in curves {
        let own: Vec<&Measurement> = shown.iter().filter(|(n, m)| n == name && m.by == *by).map(|(_, m)| *m).collect();
        series.push(Series {
            label: name.0.clone(),
            style: name.1,
            points: own.iter().map(|m| chart_point(m)).collect(),
            spread: own.iter().map(|m| (m.seconds.least, m.seconds.most)).collect(),
            band: Vec::new(),
        });
    }
    let note = format!("Bars: shortest to longest run. The reference is known to {uncertainty:.0e}.");
    Panel {
        title: title.to_owned(),
        x_label: "time of a run [s]".to_owned(),
        y_label: "error, largest |e| / (1 + |reference|)".to_owned(),
        scale: Scale::Logarithmic,
        x_scale: Scale::Logarithmic,
        series,
        note: Some(note),
    }
}

/// Returns the point of a measurement in the chart: (median run time in s, error). The error is NaN for a run that
/// ended early.
fn chart_point(m: &Measurement) -> (f64, f64) {
    (m.seconds.median, m.error.unwrap_or(f64::NAN))
}
