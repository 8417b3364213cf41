//! What the studies of a singular surface say in words. Every figure in a sentence is one of their findings.

use crate::plot::pretty;
use tripos::stability::{Findings, Passed, Row};
use tripos_derive::algebra::print::text;
use tripos_derive::scene::Solve;
use tripos_derive::{Formulation, Model};
use tripos_sim::Method;

/// Errors this many times larger are another order of loss, not another rounding.
const CLEARLY: f64 = 3.0;
/// Passages nearer than this show what a singular surface does to rounding.
const NEAR: f64 = 0.05;

fn divisor(model: &Model) -> String {
    let first = model.kinematic_equations.divisors.first();
    first.map(|d| pretty(&text(&model.arena, *d))).unwrap_or_default()
}

/// `a, b and c`.
fn joined(list: &[String]) -> String {
    match list {
        [] => String::new(),
        [one] => one.clone(),
        [most @ .., last] => format!("{} and {last}", most.join(", ")),
    }
}

fn size(error: Option<f64>) -> String {
    error.map_or_else(|| "no end".to_owned(), |e| format!("{e:.0e}"))
}

/// What the heat map shows.
pub fn passages(model: &Model, findings: &Findings) -> String {
    let seen = format!(
        "Each column is a start that brings |{}| down to the size above it, each row a way to run it; a cell has the largest \
         error at the end, the darker the larger, or where and why the run stopped. Rows that name a variable integrate it \
         instead of the coordinate.",
        divisor(model)
    );
    [Some(seen), solves(&findings.passages)].into_iter().flatten().collect::<Vec<_>>().join(" ")
}

/// Errors by rung, widest first, of the runs of one kind.
fn errors(list: &[Passed], of: impl Fn(&Passed) -> bool) -> Vec<&Passed> {
    let mut runs: Vec<&Passed> = list.iter().filter(|p| p.method == Method::Dop853.name() && of(p)).collect();
    runs.sort_by(|a, b| b.least.total_cmp(&a.least));
    runs
}

/// How far down each solve arrives.
fn solves(list: &[Passed]) -> Option<String> {
    let mut parts = Vec::new();
    for solve in Solve::ALL {
        let mut names: Vec<&str> = Vec::new();
        for p in list.iter().filter(|p| p.solve == solve.name()) {
            if !names.contains(&p.formulation.as_str()) {
                names.push(&p.formulation);
            }
        }
        for name in names {
            let runs = errors(list, |p| p.solve == solve.name() && p.formulation == name && p.variable == "distance");
            let last = runs.iter().rev().find(|p| p.error.is_some())?;
            parts.push(format!("{name} {} {:.0e} ({})", solve.name(), last.least, size(last.error)));
        }
    }
    (!parts.is_empty())
        .then(|| format!("The narrowest that dop853 passes in the distance, and its error then: {}.", joined(&parts)))
}

/// How a scene's own equations pass, by each way that they were run.
pub fn own(list: &[Passed]) -> Option<String> {
    let own: Vec<&Passed> = list.iter().filter(|p| p.formulation == "reduced").collect();
    let mut methods: Vec<&str> = own.iter().map(|p| p.method).collect();
    methods.dedup();
    let parts: Vec<String> = methods
        .into_iter()
        .map(|method| {
            let runs = || own.iter().filter(|p| p.method == method);
            let passages: Vec<String> = runs().map(|p| size(p.error)).collect();
            let steps = runs().map(|p| p.steps).max().unwrap_or(0);
            format!("by {method} with errors of {}, in at most {steps} steps", joined(&passages))
        })
        .collect();
    let places: Vec<String> =
        own.iter().filter(|p| p.method == own[0].method).map(|p| format!("{:.0e}", p.least)).collect();
    (!parts.is_empty())
        .then(|| format!("The scene's own reduced equations pass at {} {}.", joined(&places), parts.join("; ")))
}

/// Whether Lagrange's equations keep digits in the coordinate itself that formulations in other speeds lose, and what
/// the distance makes of it; nothing where the findings do not show it.
pub fn coordinate(model: &Model, list: &[Passed]) -> Option<String> {
    let of = |name: &str, variable: &str| {
        errors(list, |p| p.formulation == name && p.variable == variable && p.solve == Solve::Eliminated.name())
    };
    let lagrange = Formulation::Lagrange.name();
    let keeps = of(lagrange, "coordinate");
    let loses = |runs: &[&Passed]| {
        let near: Vec<(&&Passed, &&Passed)> =
            keeps.iter().zip(runs).filter(|(a, _)| a.error.is_some() && a.least < NEAR).collect();
        let lost = |(a, b): &(&&Passed, &&Passed)| b.error.is_none_or(|e| a.error.is_some_and(|a| e >= CLEARLY * a));
        near.len() > 1 && near.iter().all(lost)
    };
    let losers: Vec<&str> = Formulation::ALL
        .into_iter()
        .map(Formulation::name)
        .filter(|name| *name != lagrange && loses(&of(name, "coordinate")))
        .collect();
    let first = losers.first()?;
    let places: Vec<String> = keeps.iter().map(|p| format!("{:.0e}", p.least)).collect();
    let row =
        |name: &str, variable: &str| joined(&of(name, variable).iter().map(|p| size(p.error)).collect::<Vec<_>>());
    let names = joined(&losers.iter().map(|name| (*name).to_owned()).collect::<Vec<_>>());
    let rate = rate(model).map_or_else(String::new, |rate| format!(", as {rate}"));
    Some(format!(
        "With eliminated accelerations and dop853 in the coordinate itself, the equations by {lagrange} keep digits that those by \
         {names} lose: at |{}| = {} the errors are {} by {lagrange}, {} by {first}. The equations by {lagrange} integrate q\u{307} \
         itself; the speeds of those by {names} give it only by a division{rate}. In the distance the errors by {first} are {}.",
        divisor(model),
        joined(&places),
        row(lagrange, "coordinate"),
        row(first, "coordinate"),
        row(first, "distance"),
    ))
}

/// The first rate of a coordinate that divides by what vanishes, as an equation.
fn rate(model: &Model) -> Option<String> {
    let equations = &model.kinematic_equations;
    let divisor = text(&model.arena, *equations.divisors.first()?);
    let rates = model.coordinates.iter().zip(&equations.rates);
    let texts = rates.map(|(c, rate)| (format!("{}'", c.name), text(&model.arena, *rate)));
    let (name, rate) = { texts }.find(|(_, rate)| rate.contains(&format!("/{divisor}")))?;
    Some(pretty(&format!("{name} = {rate}")))
}

/// What the figure of errors and condition numbers shows.
pub fn conditioning(model: &Model, findings: &Findings) -> String {
    let divisor = divisor(model);
    let mut list = vec![format!(
        "Along the narrowest passage: left, how far accelerations computed in doubles are from those computed with 32 digits at \
         the same state, by |{divisor}|; right, the condition numbers of the matrices, as they stand (plain) and with rows and \
         columns scaled (equilibrated)."
    )];
    let rows: Vec<&Row> = findings.rows.iter().filter(|r| r.check == "conditioning").collect();
    let mut places: Vec<&str> = Vec::new();
    for row in &rows {
        if !places.contains(&row.case.as_str()) {
            places.push(&row.case);
        }
    }
    // Half way in, and as near as it comes.
    let middle = places.get(places.len() / 2).copied();
    for place in [middle, places.last().copied().filter(|last| Some(*last) != middle)].into_iter().flatten() {
        list.extend(at(&rows, place, &divisor));
    }
    list.join(" ")
}

/// What was found at one place of a passage.
fn at(rows: &[&Row], place: &str, divisor: &str) -> Option<String> {
    let here = |quantity: &str, solve: Solve| -> Vec<(&str, f64)> {
        let found = rows.iter().filter(|r| r.case == place && r.quantity == quantity && r.solve == solve.name());
        found.filter_map(|r| Some((r.formulation.as_str(), r.value?))).collect()
    };
    let eliminated = here("acceleration error", Solve::Eliminated).iter().map(|e| e.1).reduce(f64::max)?;
    let named = |list: Vec<(&str, f64)>| {
        joined(&list.iter().map(|(name, value)| format!("{value:.0e} ({name})")).collect::<Vec<_>>())
    };
    let errors = named(here("acceleration error", Solve::Numeric));
    let conditions = named(here("equilibrated condition", Solve::Numeric));
    let place: f64 = place.parse().ok()?;
    Some(format!(
        "At |{divisor}| = {place:.1e} the eliminated accelerations err by at most {eliminated:.0e} of the largest, the numeric \
         solves by {errors}; the equilibrated condition numbers there are {conditions}."
    ))
}
