//! What the page says of a scene and of each of its runs, in words and numbers.

use super::own::Own;
use crate::page::{Nearest, RunRow};
use tripos::Mechanism;
use tripos::invariants::Course;
use tripos::run::{Run, method_words, state_names};
use tripos_derive::scene::Scene;

/// The course of a run along which nothing was watched.
pub static UNWATCHED: Course = Course {
    t: Vec::new(),
    integrals: Vec::new(),
    determinant: Vec::new(),
    condition: Vec::new(),
    divisors: Vec::new(),
};

/// The title of a scene; without one, its file's name.
pub fn title(scene: &Scene) -> String {
    let stem = || scene.source.path.file_stem().map_or(String::new(), |stem| stem.to_string_lossy().into_owned());
    if scene.title.is_empty() { stem() } else { scene.title.clone() }
}

/// (what, value) of what is given: parameters, start, span, tolerances, domain.
pub fn facts(model: &Mechanism, scene: &Scene) -> Vec<(String, String)> {
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
        ("Integration".to_owned(), method_words(scene)),
        ("Domain".to_owned(), model.domain.iter().map(|c| c.text.clone()).collect::<Vec<_>>().join(", ")),
    ];
    facts.retain(|(_, value)| !value.is_empty());
    facts
}

/// The row of a run.
pub fn row(scene: &Scene, run: &Run, course: &Course) -> RunRow {
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
        stop: run.why.clone(),
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
pub fn own_row(scene: &Scene, own: &Own) -> RunRow {
    let row = row(scene, &own.run, own.course.as_ref().unwrap_or(&UNWATCHED));
    RunRow { energy_drift: row.energy_drift.filter(|_| own.has_energy), ..row }
}

/// The least and the greatest of some values.
fn range(values: &[f64]) -> Option<(f64, f64)> {
    let numbers = || values.iter().copied().filter(|x| !x.is_nan());
    Some((numbers().min_by(f64::total_cmp)?, numbers().max_by(f64::total_cmp)?))
}
