//! Outcome of a scene in one or two sentences: the end of the runs by derived equations, and the result of the printed
//! equations.
//!
//! Invariant: every sentence is made from the values of runs. Only right equations are called loose. Printed equations
//! are called wrong if they do not give the derived accelerations, even if their run reaches its end.

use crate::page::content::{RunRow, SceneSection, Standing};
use crate::page::markup::html::{escape, list_names, number, rounded_number_html, words_html};
use crate::page::scenes::runs::{run_drift_html, run_name};
use crate::phrases::counted_noun;
use std::fmt::Write;
use tripos_derive::plain_text::with_significant_digits;

/// Largest number of printed runs that a sentence names. Of further runs, only the number is given.
const NAMED: usize = 4;

/// Grade of a run by derived equations, in the order of severity. The worst is last.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum RunOutcome {
    /// Arrived: the run reached its end with enough digits.
    Arrived,
    /// Ended: the run ended early, by its domain or an event.
    Ended,
    /// Loose: the equations are right, at tolerances that leave few digits.
    Loose,
    /// Stopped: the run could not continue.
    Stopped,
}

/// Returns the grade of a run: arrived, ended, loose or stopped.
fn outcome_of_run(run: &RunRow) -> RunOutcome {
    match run.standing {
        Standing::Stopped => RunOutcome::Stopped,
        Standing::Loose { .. } => RunOutcome::Loose,
        _ if !run.arrived => RunOutcome::Ended,
        _ => RunOutcome::Arrived,
    }
}

/// Returns the runs by derived equations, including the reduced equations.
fn derived_runs(scene: &SceneSection) -> Vec<&RunRow> {
    scene.runs.iter().filter(|run| run.printed.is_none()).collect()
}

/// Returns the worst grade among the runs by derived equations; `None` if there is no such run.
pub fn worst_outcome(scene: &SceneSection) -> Option<RunOutcome> {
    derived_runs(scene).into_iter().map(outcome_of_run).max()
}

/// Returns the HTML sentence about the outcome of the runs by derived equations.
pub fn derived_outcome(scene: &SceneSection) -> String {
    let runs = derived_runs(scene);
    let Some(worst) = worst_outcome(scene) else { return "No derived equations ran.".to_owned() };
    let some: Vec<&RunRow> = runs.iter().copied().filter(|run| outcome_of_run(run) == worst).collect();
    let run = some[0];
    let who = match (some.len(), runs.len()) {
        (1, 1) => "The derived run".to_owned(),
        (n, all) if n == all => format!("All {n} derived runs"),
        (n, all) => format!("{n} of {all} derived runs"),
    };
    let t = number(&rounded_number_html(run.t_end, 5));
    let s = |one: &'static str, many: &'static str| if some.len() == 1 { one } else { many };
    let why = words_html(run.stop.trim_end_matches('.'));
    match worst {
        RunOutcome::Stopped => format!("{who} {} at t = {t} s: {why}.", s("stops", "stop")),
        RunOutcome::Ended => format!("{who} {} at t = {t} s: {why}.", s("ends", "end")),
        RunOutcome::Loose => format!("{who} {} right but loose: {}.", s("is", "are"), loose_outcome_words(run)),
        RunOutcome::Arrived => format!("{who} {} t = {t} s{}.", s("reaches", "reach"), kept_accuracy_words(&some)),
    }
}

/// Returns the reason, in words, why a run is loose: the time from which on it has few digits, and its error. If these
/// are not known, its first warning.
fn loose_outcome_words(run: &RunRow) -> String {
    let Standing::Loose { how, error } = &run.standing else { return String::new() };
    let few =
        run.few_from.map(|t| format!("fewer than three digits from t = {} s on", number(&rounded_number_html(t, 4))));
    let error = error
        .as_ref()
        .ok()
        .map(|error| format!("an error of {} at the end", number(&with_significant_digits(*error, 2))));
    let left: Vec<String> = few.into_iter().chain(error).collect();
    match run.warnings.first() {
        Some(warning) if run.few_from.is_none() => {
            format!("{}; {}", words_html(how), words_html(warning.trim_end_matches('.')))
        }
        _ if left.is_empty() => format!("{}; what that leaves is not known", words_html(how)),
        _ => format!("{} leaves {}", words_html(how), list_names(&left)),
    }
}

/// Returns words for the digits and the energy that runs keep up to their ends.
fn kept_accuracy_words(runs: &[&RunRow]) -> String {
    let digits = runs.iter().filter_map(|run| run.digits).reduce(f64::min);
    let drift = runs.iter().filter_map(|run| run.energy_drift).reduce(f64::max);
    let digits = digits.map(|digits| format!(" with {digits:.0} digits or more"));
    let drift = drift.map(|drift| format!("total energy kept to {} J", run_drift_html(drift)));
    match (digits, drift) {
        (Some(digits), Some(drift)) => format!("{digits}, {drift}"),
        (Some(digits), None) => digits,
        (None, Some(drift)) => format!(", {drift}"),
        (None, None) => String::new(),
    }
}

/// Returns the HTML sentence about the outcome of the printed equations; `None` if no printed equations were run.
pub fn printed_outcome(scene: &SceneSection) -> Option<String> {
    let runs: Vec<&RunRow> = scene.runs.iter().filter(|run| run.printed.is_some()).collect();
    if runs.is_empty() {
        return None;
    }
    let wrong = runs.iter().filter(|run| run.standing == Standing::Wrong).count();
    let early: Vec<&RunRow> = runs.iter().copied().filter(|run| !run.arrived).collect();
    let of = |n: usize| if n == runs.len() { format!("all {n}") } else { format!("{n} of {}", runs.len()) };
    let mut out = match (wrong, runs.len()) {
        (0, 1) => "As printed, the one system is not wrong".to_owned(),
        (0, all) => format!("As printed, none of {} is wrong", counted_noun(all, "system")),
        (_, 1) => "As printed, the one system is wrong".to_owned(),
        (1, all) => format!("As printed, 1 of {} is wrong, however its run ends", counted_noun(all, "system")),
        _ => format!("As printed, {} systems are wrong, however their runs end", of(wrong)),
    };
    if !early.is_empty() {
        let one = |run: &&RunRow| format!("{} at {} s", run_name(run), number(&rounded_number_html(run.t_end, 3)));
        let mut list: Vec<String> = early.iter().take(NAMED).map(one).collect();
        if early.len() > NAMED {
            list.push(format!("{} more", early.len() - NAMED));
        }
        let ends = if early.len() == 1 { "ends" } else { "end" };
        let _ = write!(out, "; {} {ends} early: {}", of(early.len()), list_names(&list));
    }
    Some(out + "." + &worst_drift_outcome(&runs))
}

/// Returns the HTML sentence about the wrong printed run with the largest energy drift that reaches its end. Empty if
/// there is none.
fn worst_drift_outcome(runs: &[&RunRow]) -> String {
    let wrong = runs.iter().filter(|run| run.arrived && run.standing == Standing::Wrong);
    let known = wrong.filter_map(|run| Some((run, run.energy_drift.filter(|drift| drift.is_finite())?)));
    let Some((run, drift)) = known.max_by(|a, b| a.1.total_cmp(&b.1)) else { return String::new() };
    format!(" {} arrives, with total energy off by {} J.", run_name(run), run_drift_html(drift))
}

/// Returns the HTML of a scene's title in quotation marks.
pub fn title(scene: &SceneSection) -> String {
    format!("“{}”", escape(&scene.title))
}
