//! Rows of the page's tables, and facts, about a scene and each of its runs.

use super::reduced_run::ReducedRun;
use crate::page::{RunRow, SceneFact, SingularityDistances, Standing};
use tripos::{CorrectDigits, InvariantValues, Mechanism, Run, integration_method_words, state_names};
use tripos_derive::scene::Scene;
use tripos_sim::Stop;

/// Empty record of watched quantities, for a run without any.
pub static EMPTY_COURSE: InvariantValues = InvariantValues {
    t: Vec::new(),
    integrals: Vec::new(),
    determinant: Vec::new(),
    condition: Vec::new(),
    divisors: Vec::new(),
};

/// Returns the number, times and energy losses of a run's impacts in words; `None` if the run has no impacts.
pub fn impacts_words(run: &Run) -> Option<(&'static str, SceneFact)> {
    let list = run.impacts();
    let (first, last) = (list.first()?, list.last()?);
    let lost: f64 = list.iter().map(|impact| impact.loss).sum();
    let when = if list.len() == 1 {
        format!("1, at {} s", first.t)
    } else {
        format!("{}, from {} s to {} s", list.len(), first.t, last.t)
    };
    Some(("Impacts", SceneFact::Words(format!("{when}; they take {lost} J"))))
}

/// Returns the given data of a scene, each with a heading: parameters, start, span, integration and domain. Empty data
/// are left out.
pub fn scene_facts(model: &Mechanism, scene: &Scene) -> Vec<(&'static str, SceneFact)> {
    let values = |names: Vec<String>, values: &[f64]| names.into_iter().zip(values.iter().copied()).collect::<Vec<_>>();
    let parameters = values(model.parameters.iter().map(|p| p.name.clone()).collect(), &scene.parameters);
    let start = values(state_names(model), &[scene.q.as_slice(), &scene.u].concat());
    let domain = model.domain.iter().map(|c| c.text.clone()).collect::<Vec<_>>().join(", ");
    let numbers = [("Parameters", parameters), ("Start", start)];
    let numbers = numbers.into_iter().filter(|(_, list)| !list.is_empty());
    let words = [
        ("Span", format!("{} s to {} s", scene.span.0, scene.span.1)),
        ("Integration", integration_method_words(scene)),
        ("Domain", domain),
    ];
    let words = words.into_iter().filter(|(_, words)| !words.is_empty());
    let numbers = numbers.map(|(what, list)| (what, SceneFact::Values(list)));
    numbers.chain(words.map(|(what, words)| (what, SceneFact::Words(words)))).collect()
}

/// Returns the row for a run in the page's table of runs.
pub fn row(scene: &Scene, run: &Run, course: &InvariantValues, standing: Standing) -> RunRow {
    let solution = &run.solution;
    RunRow {
        title: run.by.title(),
        printed: run.by.printed_id().map(str::to_owned),
        method: scene.integration.method.name(),
        code: run.code.name().to_owned(),
        steps: solution.steps,
        rejected: solution.rejected,
        evaluations: solution.evaluations,
        t_end: solution.t_end,
        arrived: solution.stop == Stop::End,
        stop: run.why.clone(),
        digits: run
            .digits
            .as_ref()
            .and_then(CorrectDigits::digits_at_end_least)
            .filter(|_| standing != Standing::Wrong),
        standing,
        few_from: row_time_of_few_digits(run),
        energy_drift: run.energy_drift,
        warnings: run.warnings.clone(),
        changes: course.largest_changes(),
        nearest: SingularityDistances {
            determinant: row_value_range(&course.determinant),
            relative: course.least(&course.relative_determinant()),
            condition: course.least(&course.condition),
            divisors: course.divisors.iter().map(|values| course.least(values)).collect(),
        },
    }
}

/// Returns the time, s, from which on a run has fewer than three correct digits. `None` if it always has three, or if
/// digits were not assessed.
fn row_time_of_few_digits(run: &Run) -> Option<f64> {
    let digits = run.digits.as_ref()?;
    digits.first_with_few().map(|(instant, _)| digits.t[instant])
}

/// Returns the row for the run by the scene's reduced equations in the page's table of runs.
pub fn reduced_run_row(scene: &Scene, own: &ReducedRun, standing: Standing) -> RunRow {
    row(scene, &own.run, own.course.as_ref().unwrap_or(&EMPTY_COURSE), standing)
}

/// Returns the smallest and the largest value that is not NaN; `None` if there is none.
fn row_value_range(values: &[f64]) -> Option<(f64, f64)> {
    let numbers = || values.iter().copied().filter(|x| !x.is_nan());
    Some((numbers().min_by(f64::total_cmp)?, numbers().max_by(f64::total_cmp)?))
}
