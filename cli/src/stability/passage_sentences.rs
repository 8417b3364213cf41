//! Sentences about the stability studies of a scene near a singular place. Every number in a sentence is a result of
//! these studies.

use crate::plot::figure_text_in_symbols;
use tripos::studies::stability::{ConditioningFinding, Findings, PassageRun, PassageVariable};
use tripos_derive::algebra::solve::elimination::divisors;
use tripos_derive::algebra::text::print::print_text;
use tripos_derive::mechanics::EquationsOrigin;
use tripos_derive::scene::AccelerationSolution;
use tripos_derive::{Formulation, Model};
use tripos_sim::Method;

/// Ratio of two errors above which the larger counts as a further loss of digits, not only as different rounding.
const CLEAR_ERROR_RATIO: f64 = 3.0;
/// Largest value of the smallest divisor in a passage at which the singular place affects rounding.
const LARGEST_NEAR_DIVISOR: f64 = 0.05;

/// Returns the first divisor of the kinematic equations as text; empty without a divisor.
fn passage_divisor_text(model: &Model) -> String {
    let first = model.kinematic_equations.divisors.first();
    first.map(|d| figure_text_in_symbols(&print_text(&model.arena, *d))).unwrap_or_default()
}

/// Lists texts in the form of a sentence: `a, b and c`.
fn list_names(list: &[String]) -> String {
    match list {
        [] => String::new(),
        [one] => one.clone(),
        [most @ .., last] => format!("{} and {last}", most.join(", ")),
    }
}

/// Returns an error as text with one digit, or `no end` for a run that did not reach its end.
fn passage_error_text(error: Option<f64>) -> String {
    error.map_or_else(|| "no end".to_owned(), |e| format!("{e:.0e}"))
}

/// Returns the caption of the heat map of passages.
pub fn passages_caption(model: &Model, findings: &Findings) -> String {
    let seen = format!(
        "Each column is a start that brings |{}| down to the size above it, each row a way to run it; a cell has the largest \
         error at the end, the darker the larger, or where and why the run stopped. Rows that name a variable integrate it \
         instead of the coordinate.",
        passage_divisor_text(model)
    );
    [Some(seen), nearest_passages_sentence(&findings.passages)].into_iter().flatten().collect::<Vec<_>>().join(" ")
}

/// Returns the passages by DOP853 for which `of` is true, from the farthest to the nearest.
fn dop853_passages(list: &[PassageRun], of: impl Fn(&PassageRun) -> bool) -> Vec<&PassageRun> {
    let mut runs: Vec<&PassageRun> = list.iter().filter(|p| p.method == Method::Dop853.name() && of(p)).collect();
    runs.sort_by(|a, b| b.least.total_cmp(&a.least));
    runs
}

/// Returns a sentence about the nearest passages that the runs pass without failure, for each solve and set of
/// equations, with their errors. `None` if there is none.
fn nearest_passages_sentence(list: &[PassageRun]) -> Option<String> {
    let mut parts = Vec::new();
    for solve in AccelerationSolution::ALL {
        let mut all: Vec<&EquationsOrigin> = Vec::new();
        for p in list.iter().filter(|p| p.solve == solve.name()) {
            if !all.contains(&&p.by) {
                all.push(&p.by);
            }
        }
        for by in all {
            let of = |p: &PassageRun| p.solve == solve.name() && p.by == *by && p.variable == PassageVariable::Distance;
            let runs = dop853_passages(list, of);
            let last = runs.iter().rev().find(|p| p.error.is_some())?;
            parts.push(format!(
                "{} {} {:.0e} ({})",
                by.name(),
                solve.name(),
                last.least,
                passage_error_text(last.error)
            ));
        }
    }
    (!parts.is_empty()).then(|| {
        format!("The narrowest that dop853 passes in the distance, and its error then: {}.", list_names(&parts))
    })
}

/// Returns a sentence about the errors of a scene's reduced equations after the singular place, for each method. `None`
/// if the reduced equations were not run.
pub fn reduced_passages_sentence(list: &[PassageRun]) -> Option<String> {
    let own: Vec<&PassageRun> = list.iter().filter(|p| p.by.is_reduced()).collect();
    let mut methods: Vec<&str> = own.iter().map(|p| p.method).collect();
    methods.dedup();
    let parts: Vec<String> = methods
        .into_iter()
        .map(|method| {
            let runs = || own.iter().filter(|p| p.method == method);
            let passages: Vec<String> = runs().map(|p| passage_error_text(p.error)).collect();
            let steps = runs().map(|p| p.steps).max().unwrap_or(0);
            format!("by {method} with errors of {}, in at most {steps} steps", list_names(&passages))
        })
        .collect();
    let places: Vec<String> =
        own.iter().filter(|p| p.method == own[0].method).map(|p| format!("{:.0e}", p.least)).collect();
    (!parts.is_empty())
        .then(|| format!("The scene's reduced equations pass at {} {}.", list_names(&places), parts.join("; ")))
}

/// Returns a sentence for the case that Lagrange's equations, integrated in the coordinate, keep digits that
/// formulations in generalized speeds lose. The sentence gives the errors of both. `None` if the results do not show
/// this.
pub fn lagrange_passage_sentence(model: &Model, list: &[PassageRun]) -> Option<String> {
    let of = |formulation: Formulation, variable: PassageVariable| {
        let by = EquationsOrigin::from(formulation);
        dop853_passages(list, |p| {
            p.by == by && p.variable == variable && p.solve == AccelerationSolution::Eliminated.name()
        })
    };
    let lagrange = Formulation::Lagrange;
    let keeps = of(lagrange, PassageVariable::Coordinate);
    let loses = |runs: &[&PassageRun]| {
        let near: Vec<(&&PassageRun, &&PassageRun)> =
            keeps.iter().zip(runs).filter(|(a, _)| a.error.is_some() && a.least < LARGEST_NEAR_DIVISOR).collect();
        let lost = |(a, b): &(&&PassageRun, &&PassageRun)| {
            b.error.is_none_or(|e| a.error.is_some_and(|a| e >= CLEAR_ERROR_RATIO * a))
        };
        near.len() > 1 && near.iter().all(lost)
    };
    let losers: Vec<Formulation> = Formulation::ALL
        .into_iter()
        .filter(|f| !f.is_in_rates() && loses(&of(*f, PassageVariable::Coordinate)))
        .collect();
    let first = *losers.first()?;
    let places: Vec<String> = keeps.iter().map(|p| format!("{:.0e}", p.least)).collect();
    let row = |f: Formulation, variable| {
        list_names(&of(f, variable).iter().map(|p| passage_error_text(p.error)).collect::<Vec<_>>())
    };
    let names = list_names(&losers.iter().map(|f| f.name().to_owned()).collect::<Vec<_>>());
    let rate = singular_rate_equation(model).map_or_else(String::new, |rate| format!(", as {rate}"));
    Some(format!(
        "With eliminated accelerations and dop853 in the coordinate itself, the equations by {lagrange} keep digits that those by \
         {names} lose: at |{}| = {} the errors are {} by {lagrange}, {} by {first}. The equations by {lagrange} integrate q\u{307} \
         itself; the speeds of those by {names} give it only by a division{rate}. In the distance the errors by {first} are {}.",
        passage_divisor_text(model),
        list_names(&places),
        row(lagrange, PassageVariable::Coordinate),
        row(first, PassageVariable::Coordinate),
        row(first, PassageVariable::Distance),
        lagrange = lagrange.name(),
        first = first.name(),
    ))
}

/// Returns the equation of the first coordinate rate that contains the vanishing divisor. `None` if
/// there is none.
fn singular_rate_equation(model: &Model) -> Option<String> {
    let equations = &model.kinematic_equations;
    let divisor = *equations.divisors.first()?;
    let mut rates = model.coordinates.iter().zip(&equations.rates);
    let (coordinate, rate) = rates.find(|(_, rate)| divisors(&model.arena, &[**rate]).contains(&divisor))?;
    Some(figure_text_in_symbols(&format!("{}' = {}", coordinate.name, print_text(&model.arena, *rate))))
}

/// Returns the caption of the figure of errors and condition numbers along a passage.
pub fn passage_conditioning_caption(model: &Model, findings: &Findings) -> String {
    let divisor = passage_divisor_text(model);
    let mut list = vec![format!(
        "Along the narrowest passage: above, how far accelerations computed in doubles are from those computed with 32 digits at \
         the same state, by |{divisor}|, eliminated and by a numeric solve; below, the condition numbers of the matrices, as they stand and \
         with rows and columns scaled (equilibrated)."
    )];
    let mut places: Vec<f64> = Vec::new();
    for looked in &findings.looked {
        if places.iter().all(|place| place.total_cmp(&looked.divisor).is_ne()) {
            places.push(looked.divisor);
        }
    }
    // The sentences are about two places: the place halfway along the passage, and the nearest place.
    let middle = places.get(places.len() / 2).copied();
    let last = places.last().copied().filter(|_| places.len() / 2 + 1 < places.len());
    list.extend(
        [middle, last]
            .into_iter()
            .flatten()
            .filter_map(|place| conditioning_at_divisor_sentence(&findings.looked, place, &divisor)),
    );
    list.join(" ")
}

/// Returns a sentence about the errors and condition numbers at the value `place` of the divisor. `None` if there are
/// no results for this value.
fn conditioning_at_divisor_sentence(list: &[ConditioningFinding], place: f64, divisor: &str) -> Option<String> {
    let here = |solve: AccelerationSolution| {
        list.iter().filter(move |l| l.divisor.total_cmp(&place).is_eq() && l.solve == solve)
    };
    let eliminated = here(AccelerationSolution::Eliminated).map(|l| l.error).reduce(f64::max)?;
    let named = |of: fn(&ConditioningFinding) -> f64| {
        list_names(
            &here(AccelerationSolution::Numeric)
                .map(|l| format!("{:.0e} ({})", of(l), l.by.name()))
                .collect::<Vec<_>>(),
        )
    };
    let (errors, conditions) = (named(|l| l.error), named(|l| l.equilibrated));
    Some(format!(
        "At |{divisor}| = {place:.1e} the eliminated accelerations err by at most {eliminated:.0e} of the largest, the numeric \
         solves by {errors}; the equilibrated condition numbers there are {conditions}."
    ))
}
