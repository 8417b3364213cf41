//! Panels of a scene's figures, drawn from its runs: energy, states, outputs, first integrals,
//! nearness to singularity.

use crate::page::Standing;
use crate::plot::{Bounds, Panel, Scale, Series};
use std::fmt::Write;
use tripos::{ConservedQuantity, InvariantValues, Run, WatchedInvariants};
use tripos_derive::Model;
use tripos_derive::plain_text::with_significant_digits;
use tripos_derive::scene::{ENERGIES, Scene, SceneOutput};
use tripos_sim::Stop;

/// Curves of one run in the figures: the run, its watched quantities, and the style of the curves.
#[derive(Clone)]
pub struct RunCurves<'a> {
    /// Run of a scene that the curves show.
    pub run: &'a Run,
    /// Quantities watched along the run, such as first integrals and determinants.
    pub course: &'a InvariantValues,
    /// Style number that selects colour, dashes and marker; the same in every figure.
    pub style: usize,
    /// Label of the run in the legend of a figure.
    pub label: String,
    /// Standing (trustworthiness) of the run: right, loose, stopped, wrong or undecided.
    pub standing: &'a Standing,
}

impl<'a> RunCurves<'a> {
    /// Creates the curves of a run. If the run is by wrong printed equations, the label says so.
    pub fn new(run: &'a Run, course: &'a InvariantValues, style: usize, standing: &'a Standing) -> Self {
        let label = match run.by.printed_id() {
            Some(id) if *standing == Standing::Wrong => format!("printed {id} (wrong)"),
            Some(id) => format!("printed {id}"),
            None => run.by.title(),
        };
        Self { run, course, style, label, standing }
    }

    /// True if two runs show equal numbers, and both or neither are by wrong equations.
    fn shows_the_same(&self, other: &Self) -> bool {
        let (own, its) = (self.run, other.run);
        (*self.standing == Standing::Wrong) == (*other.standing == Standing::Wrong)
            && own.solution.t == its.solution.t
            && own.states == its.states
    }

    /// Returns the series of a quantity along the run, from its value at each sample.
    fn series(&self, values: impl IntoIterator<Item = f64>) -> Series {
        let points = self.run.solution.t.iter().copied().zip(values).collect();
        Series::curve(self.label.clone(), self.style, points)
    }

    /// Returns the series of the run's value with index `which`, with a band for its estimated error.
    fn with_band(&self, values: impl IntoIterator<Item = f64>, which: usize) -> Series {
        let mut series = self.series(values);
        if let (Some(digits), false) = (&self.run.digits, *self.standing == Standing::Wrong) {
            let mut points = series.points.iter();
            let errors = digits.t.iter().zip(&digits.errors).filter_map(|(t, errors)| {
                let (_, y) = points.find(|(at, _)| at.total_cmp(t).is_eq())?;
                Some(Bounds { x: *t, low: y - errors[which], high: y + errors[which] })
            });
            series.band = errors.collect();
        }
        series
    }
}

/// Merges curves with equal numbers into one curve, whose label contains all their names.
pub fn merge_equal_curves(curves: Vec<RunCurves>) -> Vec<RunCurves> {
    let mut list: Vec<RunCurves> = Vec::new();
    for curve in curves {
        match list.iter_mut().find(|known| known.shows_the_same(&curve)) {
            Some(known) => known.label = format!("{} = {}", known.label, curve.label),
            None => list.push(curve),
        }
    }
    list
}

/// Returns sentences about the runs in a figure: the shown, the wrong, the stopped and the loosely integrated runs.
pub fn run_figure_sentences(curves: &[RunCurves]) -> String {
    let names = |of: &dyn Fn(&Standing) -> bool| {
        let some = curves.iter().filter(|curve| of(curve.standing));
        some.map(|curve| curve.label.as_str()).collect::<Vec<_>>().join(", ")
    };
    let mut out = format!("Shown: {}.", names(&|standing| *standing != Standing::Wrong));
    let wrong = names(&|standing| *standing == Standing::Wrong);
    if !wrong.is_empty() {
        let _ = write!(out, " In red, since they do not give the derived accelerations: {wrong}.");
    }
    let stopped = names(&|standing| *standing == Standing::Stopped);
    if !stopped.is_empty() {
        let _ = write!(out, " Right, but stopped on the way: {stopped}.");
    }
    out + &loose_runs_sentence(curves) + band_sentence(curves)
}

/// Number of correct digits below which errors are visible in a figure.
const SEEN: f64 = 2.5;

/// Returns the sentence about shaded error bands. Empty if no band is wide enough to be visible.
fn band_sentence(curves: &[RunCurves]) -> &'static str {
    let right = curves.iter().filter(|curve| *curve.standing != Standing::Wrong);
    let mut fewest = right.filter_map(|curve| curve.run.digits.as_ref()?.fewest_of_all());
    let is_seen = fewest.any(|fewest| fewest.digits < SEEN);
    if is_seen { " Shaded: between which values the true ones lie, as far as a second run tells." } else { "" }
}

/// Returns the sentence about runs of right equations that were loosely integrated, with their errors. Empty if there
/// are none.
fn loose_runs_sentence(curves: &[RunCurves]) -> String {
    let mut how = "";
    let mut list = Vec::new();
    for curve in curves {
        if let Standing::Loose { how: words, error } = curve.standing {
            how = words;
            let error =
                error.as_ref().map_or_else(|_| "not known".to_owned(), |error| with_significant_digits(*error, 2));
            list.push(format!("{error} by {}", curve.label));
        }
    }
    if list.is_empty() {
        return String::new();
    }
    format!(
        " Right, but loose: {how} leaves an error at the end, the largest |e| / (1 + |exact|), of {}.",
        list.join(", ")
    )
}

/// Returns a note on the runs that ended early, with time and reason; `None` if there are none.
fn early_end_note(curves: &[RunCurves]) -> Option<String> {
    let early = curves.iter().map(|curve| curve.run).filter(|run| run.solution.stop != Stop::End);
    let notes: Vec<String> = early
        .map(|run| format!("{} ends at {:.4} s: {}", run.by.name(), run.solution.t_end, run.solution.stop.code()))
        .collect();
    (!notes.is_empty()).then(|| notes.join("; "))
}

/// Returns the panel of the total energy T + V, J, over time, on linear axes.
pub fn energy_panel(curves: &[RunCurves]) -> Panel {
    Panel {
        title: "Total energy".to_owned(),
        x_label: "t [s]".to_owned(),
        y_label: "T + V [J]".to_owned(),
        scale: Scale::Linear,
        x_scale: Scale::Linear,
        series: curves.iter().map(|curve| curve.series(curve.run.energies.iter().map(|(k, p)| k + p))).collect(),
        note: early_end_note(curves),
    }
}

/// Returns a panel for each of the scene's outputs, with a curve for each run. `curves` has the output values of each
/// run at each sample.
pub fn outputs(model: &Model, scene: &Scene, curves: &[(RunCurves, Vec<Vec<f64>>)]) -> Vec<Panel> {
    let unit = |output: &SceneOutput| match model.unit_label(&model.arena, output.value) {
        Some(unit) => unit,
        None if ENERGIES.contains(&output.name.as_str()) => "J".to_owned(),
        None => "SI".to_owned(),
    };
    let panel = |(at, output): (usize, &SceneOutput)| Panel {
        title: output.name.clone(),
        x_label: "t [s]".to_owned(),
        y_label: format!("{} [{}]", output.name, unit(output)),
        scale: Scale::Linear,
        x_scale: Scale::Linear,
        series: curves
            .iter()
            .map(|(curve, values)| {
                let values = values.iter().map(|sample| sample[at]);
                // Errors are known only for values that a run itself records. Runs by the whole equations record
                // states, not outputs.
                if curve.run.by.is_reduced() { curve.with_band(values, at) } else { curve.series(values) }
            })
            .filter(|series| series.points.iter().any(|(_, y)| y.is_finite()))
            .collect(),
        note: None,
    };
    scene.outputs.iter().enumerate().map(panel).collect()
}

/// Returns a panel for each coordinate and generalized speed, except a coordinate that is the time.
pub fn state_panels(model: &Model, curves: &[RunCurves]) -> Vec<Panel> {
    let coordinates = model.coordinates.iter().map(|c| (&c.name, c.symbol));
    let quantities = coordinates.chain(model.speeds.iter().map(|s| (&s.name, s.symbol)));
    let unit = |symbol| model.unit_label(&model.arena, symbol).unwrap_or_else(|| "SI".to_owned());
    let labels: Vec<String> = quantities.map(|(name, symbol)| format!("{name} [{}]", unit(symbol))).collect();
    let panel = |(at, label): (usize, &String)| Panel {
        title: label.split(' ').next().unwrap_or_default().to_owned(),
        x_label: "t [s]".to_owned(),
        y_label: label.clone(),
        scale: Scale::Linear,
        x_scale: Scale::Linear,
        series: curves
            .iter()
            .map(|curve| curve.with_band(curve.run.states.iter().map(|state| state[at]), at))
            .collect(),
        note: None,
    };
    labels.iter().enumerate().filter(|(at, _)| Some(*at) != model.time()).map(panel).collect()
}

/// Returns a panel of |I(t) − I(t₀)| for each first integral I, on a logarithmic vertical axis.
pub fn integrals(watch: &WatchedInvariants, curves: &[RunCurves]) -> Vec<Panel> {
    let panel = |(at, integral): (usize, &ConservedQuantity)| {
        let (least, most) = change_range(curves, at);
        let symbol = format!("I{}", at + 1);
        // The first sample is left out, since the other samples are compared with it.
        let series = |curve: &RunCurves| {
            let mut series = curve.series(clamp_values(curve.course.changes(at), least, most));
            series.points.drain(..series.points.len().min(1));
            series
        };
        Panel {
            title: format!("{symbol} : {}", integral.name),
            x_label: "t [s]".to_owned(),
            y_label: format!("| {symbol} − {symbol} (t₀) | [{}]", integral.unit),
            scale: Scale::Logarithmic,
            x_scale: Scale::Linear,
            series: curves.iter().map(series).collect(),
            note: None,
        }
    };
    watch.integrals.iter().enumerate().map(panel).collect()
}

/// Returns the smallest and largest change of a first integral that a figure can show. They follow from the integral's
/// size in the runs by derived equations: from below its rounding error to a million times the size. A diverging
/// printed run therefore does not hide the other runs.
fn change_range(curves: &[RunCurves], integral: usize) -> (f64, f64) {
    let largest = |of: &dyn Fn(&RunCurves) -> bool| {
        let values = curves.iter().filter(|curve| of(curve)).flat_map(|curve| &curve.course.integrals[integral]);
        values.filter(|x| x.is_finite()).fold(0.0, |largest: f64, x| largest.max(x.abs()))
    };
    let derived = largest(&|curve| curve.run.by.formulation().is_some() || curve.run.by.is_reduced());
    let size = if derived > 0.0 { derived } else { largest(&|_| true) };
    let decade = size.log10().floor();
    if decade.is_finite() { (10_f64.powf(decade - 17.0), 10_f64.powf(decade + 6.0)) } else { (1e-17, 1e6) }
}

/// Replaces values outside the range from `least` to `most` with the nearest end of the range. NaN is unchanged.
fn clamp_values(values: Vec<f64>, least: f64, most: f64) -> impl Iterator<Item = f64> {
    values.into_iter().map(move |x| {
        if x < least {
            least
        } else if x > most {
            most
        } else {
            x
        }
    })
}

/// Returns the panels of determinant, condition number and divisors along the runs, on logarithmic vertical axes. They
/// show how near a run is to singular places.
pub fn singularity_panels(watch: &WatchedInvariants, curves: &[RunCurves]) -> Vec<Panel> {
    let panel = |title: &str, y_label: String, series: Vec<Series>| Panel {
        title: title.to_owned(),
        x_label: "t [s]".to_owned(),
        y_label,
        scale: Scale::Logarithmic,
        x_scale: Scale::Linear,
        series,
        note: None,
    };
    let each = |values: &dyn Fn(&InvariantValues) -> Vec<f64>| -> Vec<Series> {
        let series = curves.iter().map(|curve| curve.series(clamp_values(values(curve.course), 1e-20, 1e20)));
        // The reduced equations of a scene have no matrix.
        series.filter(|series| !series.points.is_empty()).collect()
    };
    let mut panels = vec![
        panel("Determinant", "| det A / det A (t₀) |".to_owned(), each(&InvariantValues::relative_determinant)),
        panel("Condition", "1 / cond A , rows and columns scaled".to_owned(), each(&|course| course.condition.clone())),
    ];
    panels.extend(watch.divisors.iter().enumerate().map(|(at, divisor)| {
        let title = "Divisor of the kinematic equations";
        panel(title, format!("|{divisor}|"), each(&|course| course.divisors[at].clone()))
    }));
    panels
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_outside_stand_at_the_edges() {
        let values: Vec<f64> = clamp_values(vec![0.0, 0.5, 9.0, f64::INFINITY, f64::NAN], 0.1, 1.0).collect();
        assert_eq!(values[..4], [0.1, 0.5, 1.0, 1.0]);
        assert!(values[4].is_nan());
    }
}
