//! Digits that runs state, against digits that they have: the battery.
//!
//! Library scenes and random mechanisms, starts near singular surfaces and separatrices, every method, solve, form and
//! projection, tolerances of 1e-2 to 1e-13, spans of 1 s to 1 000 s. The truth is the whole model by Kane's
//! eliminated equations in 32 digits, by Taylor's method at two tolerances: what no digit is left of in 32
//! digits is left out, and counted.
//!
//! `TRIPOS_BATTERY=5000` makes that many runs.

mod problem;
mod truth;

use crate::spoilt::Random;
use problem::Problem;
use std::fmt::Write;
use tripos::{EquationsName, simulate};
use tripos_derive::scene::{AccelerationSolution, Integrator, ProjectionTarget};
use tripos_sim::Method;
use truth::Truth;

/// Number of runs, unless the environment gives another.
const RUNS: usize = 100;
/// Runs of one motion, which share its truth.
const EACH: usize = 10;
/// Digits claimed beyond the truth that are too many.
const TOO_MANY: f64 = 1.0;
/// Part of the runs that may claim too many.
const EXCEPTIONS: f64 = 1e-3;
/// Part of the warnings that may be raised for nothing.
const FALSE_ALARMS: f64 = 0.02;
/// Runs after which a large battery says how far it is.
const REPORTED: usize = 250;
/// Most digits that are told apart.
const MOST: f64 = 15.0;

/// Digits that a run stated, and digits that are true.
struct Outcome {
    run: String,
    method: String,
    stated: f64,
    right: f64,
    /// True if the run warned of too few digits.
    warned: bool,
    /// Fewest digits that were true at any instant.
    fewest: f64,
    asked: f64,
}

#[test]
fn no_run_states_digits_that_it_does_not_have() {
    let wanted = std::env::var("TRIPOS_BATTERY").map_or(RUNS, |text| text.parse().expect("a number"));
    let first = std::env::var("TRIPOS_BATTERY_FROM").map_or(0_u64, |text| text.parse().expect("a number"));
    let (mut list, mut unknown, mut refused, mut silent) = (Vec::new(), 0, 0, 0);
    for seed in first.. {
        if list.len() >= wanted {
            break;
        }
        let mut random = Random(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15).wrapping_add(15));
        let problem = Problem::new(&mut random);
        let Some(truth) = Truth::new(&problem) else {
            unknown += 1;
            continue;
        };
        for _ in 0..EACH {
            let mut scene = problem.scene.clone();
            let (by, name) = draw(&mut random, &mut scene.integration, &problem);
            let Ok(run) = simulate(&problem.mechanism, &scene, by.map(EquationsName::from).as_ref()) else {
                refused += 1;
                continue;
            };
            match compare(&run, &truth, &scene) {
                Some(outcome) => {
                    let outcome = Outcome { run: format!("{seed} {}: {name}", problem.name), ..outcome };
                    if claims_too_many(&outcome) || is_false(&outcome) {
                        eprint!("{}", in_lines(&[&outcome]));
                    }
                    list.push(outcome);
                    if list.len().is_multiple_of(REPORTED) {
                        eprintln!("{} runs", list.len());
                    }
                }
                None => silent += 1,
            }
        }
    }
    let table = table(&list);
    eprintln!(
        "{} runs; {unknown} motions unknown to 32 digits, {refused} runs refused, {silent} not assessed\n{table}",
        list.len()
    );
    let too_many: Vec<&Outcome> = list.iter().filter(|o| claims_too_many(o)).collect();
    let false_alarms: Vec<&Outcome> = list.iter().filter(|o| is_false(o)).collect();
    eprintln!("claimed too many:\n{}false alarms:\n{}", in_lines(&too_many), in_lines(&false_alarms));
    assert!(too_many.len() as f64 <= (EXCEPTIONS * list.len() as f64).ceil(), "{}", in_lines(&too_many));
    assert!(false_alarms.len() as f64 <= (FALSE_ALARMS * list.len() as f64).ceil(), "{}", in_lines(&false_alarms));
}

/// The runs that are not as wanted, a line each.
fn in_lines(list: &[&Outcome]) -> String {
    list.iter().fold(String::new(), |mut out, o| {
        let warned = if o.warned { ", warned" } else { "" };
        let (stated, right, fewest) = (o.stated, o.right, o.fewest);
        let _ = writeln!(out, "{}: stated {stated:.1}, right {right:.1} (fewest {fewest:.1}){warned}", o.run);
        out
    })
}

fn claims_too_many(o: &Outcome) -> bool {
    o.stated > o.right + TOO_MANY
}

/// True if a run warned although three digits are right everywhere, and the error is below 100 times its tolerance.
fn is_false(o: &Outcome) -> bool {
    o.warned && o.fewest >= 3.0 && 10_f64.powf(-o.fewest) < 100.0 * o.asked
}

/// Draws how a run is made.
fn draw(
    random: &mut Random,
    how: &mut tripos_derive::scene::Integration,
    problem: &Problem,
) -> (Option<&'static str>, String) {
    let forms = [None, None, None, Some("kane"), Some("lagrange"), Some("newton-euler")];
    let by = *random.one(&forms);
    let rtol = 10_f64.powf(-random.between(2.0, 13.0));
    how.rtol = rtol;
    how.atol = (rtol * random.one(&[1.0, 1e-2, 1e-3])).into();
    how.method = if random.chance(5) && by.is_none() {
        Integrator::Quadrature
    } else {
        Integrator::Steps(*random.one(&Method::ALL))
    };
    how.solve = (random.chance(20) && how.method != Integrator::Quadrature).then_some(AccelerationSolution::Numeric);
    how.step = None;
    if how.method == Method::Rk4.into() || (random.chance(8) && how.method != Integrator::Quadrature) {
        how.step = Some(10_f64.powf(-random.between(1.0, 3.5)));
    }
    how.project = (random.chance(10) && by.is_none() && how.solve.is_none() && how.method != Integrator::Quadrature)
        .then_some(ProjectionTarget::Energy);
    how.step_limit = 300_000;
    let words = format!(
        "{} by {by:?}, rtol {rtol:.1e}, atol {:.1e}, step {:?}, {:?}, {:?}, span {:.1}",
        how.method,
        how.atol.smallest(),
        how.step,
        how.solve,
        how.project,
        problem.scene.span.1
    );
    (by, words)
}

/// Compares the digits that a run stated with the true ones at its end; `None` if it states none of a known state.
fn compare(run: &tripos::Run, truth: &Truth, scene: &tripos_derive::scene::Scene) -> Option<Outcome> {
    let digits = run.digits.as_ref()?;
    let known: Vec<(usize, usize)> = run
        .names
        .iter()
        .enumerate()
        .filter_map(|(at, name)| Some((at, truth.names.iter().position(|known| known == name)?)))
        .collect();
    let how = &scene.integration;
    let matters =
        if how.step.is_none() && how.method != Integrator::Quadrature { how.atol.smallest() / how.rtol } else { 1e-3 };
    let mut fewest = f64::INFINITY;
    let mut end = None;
    for (instant, t) in digits.t.iter().enumerate() {
        let Some(state) = truth.at(*t) else { continue };
        let sample = run.solution.t.iter().position(|s| s.total_cmp(t).is_eq())?;
        let shown = &run.states[sample];
        let right = |by: &dyn Fn(usize) -> f64| {
            let of_value = known.iter().map(|(at, of)| {
                let error = (shown[*at] - state[*of]).abs() / by(*of);
                if error.is_nan() { 0.0 } else { (-error.log10()).clamp(0.0, MOST) }
            });
            of_value.fold(f64::INFINITY, f64::min)
        };
        let size = |of: usize| truth.size(of).max(matters);
        fewest = fewest.min(right(&size));
        let Some(stated) = digits.digits_at_end().filter(|_| instant + 1 == digits.t.len()) else { continue };
        let stated = known.iter().map(|(at, _)| stated[*at]).fold(MOST, f64::min);
        end = Some((stated, right(&|of| size(of).min(1.0) + state[of].abs())));
    }
    let (stated, right) = end?;
    Some(Outcome {
        run: String::new(),
        method: how.method.to_string(),
        stated,
        right,
        warned: digits.digits.iter().any(|list| known.iter().any(|(at, _)| list[*at] < 3.0)),
        fewest,
        asked: how.rtol,
    })
}

/// For each method how many runs there are, and how stated digits lie to true ones.
fn table(list: &[Outcome]) -> String {
    let mut out = "method      runs  beyond by 1  by 0.5  median  below by 1  by 2  warned  for nothing\n".to_owned();
    let mut methods: Vec<&str> = list.iter().map(|o| o.method.as_str()).collect();
    methods.sort_unstable();
    methods.dedup();
    for method in methods.into_iter().chain(["all"]) {
        let of: Vec<&Outcome> = list.iter().filter(|o| method == "all" || o.method == method).collect();
        let mut beyond: Vec<f64> = of.iter().map(|o| o.stated - o.right).collect();
        beyond.sort_by(f64::total_cmp);
        let count = |holds: &dyn Fn(f64) -> bool| beyond.iter().filter(|x| holds(**x)).count();
        let _ = writeln!(
            out,
            "{method:10} {:5} {:12} {:7} {:7.2} {:11} {:5} {:7} {:12}",
            of.len(),
            count(&|x| x > 1.0),
            count(&|x| x > 0.5),
            beyond.get(beyond.len() / 2).copied().unwrap_or(f64::NAN),
            count(&|x| x < -1.0),
            count(&|x| x < -2.0),
            of.iter().filter(|o| o.warned).count(),
            of.iter().filter(|o| is_false(o)).count()
        );
    }
    out
}
