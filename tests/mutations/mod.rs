//! Does the comparison see every error, and nothing but errors?
//!
//! The derived equations of a model are printed as a report file. Then they are spoiled, one place at a time, and none
//! of the mutants may be called equal; and they are rewritten by identities and row operations, and none of the
//! rewritings may be called different. What happens to be a right equation all the same, such as a row times two,
//! counts as such only if SymPy proves it.

mod equivalent;
mod judge;
mod multipliers;
mod mutants;
mod printed;
mod report;
mod rewritings;
mod tree;

use crate::support::Random;
use mutants::{Kind, Mutant, Place, choose};
use printed::Printed;
use report::{Judged, Report};
use rustc_hash::FxHashMap;
use std::fmt::Write;
use tree::text;
use tripos_derive::diff::Judgement;

/// Mutants of each kind and model that are made of quantities, and of rows of systems.
const MUTANTS: (usize, usize) = (30, 20);
/// Number of mutants of a model of which at most one may be right all the same.
const ONE_RIGHT_IN: usize = 20;
/// Rewritings of quantities for each model, and how often all its systems are rewritten.
const REWRITINGS: (usize, usize) = (100, 3);

#[test]
fn no_mutant_of_the_disk_is_called_equal() {
    no_mutant_is_called_equal("disk", 1);
}

#[test]
fn no_mutant_of_the_cart_pendulum_is_called_equal() {
    no_mutant_is_called_equal("cart_pendulum_3", 2);
}

#[test]
fn no_mutant_of_the_chaotic_pendulum_is_called_equal() {
    no_mutant_is_called_equal("chaotic_pendulum", 3);
}

#[test]
fn no_rewriting_of_the_disk_is_called_different() {
    no_rewriting_is_called_different("disk", 4);
}

#[test]
fn no_rewriting_of_the_cart_pendulum_is_called_different() {
    no_rewriting_is_called_different("cart_pendulum_3", 5);
}

#[test]
fn no_rewriting_of_the_chaotic_pendulum_is_called_different() {
    no_rewriting_is_called_different("chaotic_pendulum", 6);
}

/// Words about a row that was not changed.
const AS_DERIVED: &str = "as derived";

/// A mutant with the id under which it stands in the report.
struct Placed {
    id: String,
    mutant: Mutant,
}

fn no_mutant_is_called_equal(model: &str, seed: u64) {
    let mut printed = Printed::new(model);
    let mutants = choose(&printed, MUTANTS.0, MUTANTS.1, &mut Random(seed));
    let mut report = Report::default();
    let right = right_equations(&printed, &mut report);
    let (placed, right_rows) = place(&printed, &mutants, &mut report);
    let judged = report.judged(model);
    for id in right.iter().chain(&right_rows) {
        assert_eq!(judged.finding(id).judgement, Judgement::Equal, "{model}: {id}, which is printed as derived");
    }
    for kind in Kind::ALL {
        let count = placed.iter().filter(|one| one.mutant.kind == kind).count();
        println!("{model}: {count} mutants by {kind:?}");
        assert_eq!(count, MUTANTS.0 + MUTANTS.1, "{model}: mutants by {kind:?}");
    }
    let all = placed.len();
    let suspects: Vec<Placed> = placed.into_iter().filter(|one| !is_caught(&judged, &one.id)).collect();
    let not_caught = suspects.len();
    equivalent::confirm(model, &mut printed, &judged, suspects);
    println!("{model}: {not_caught} of {all} mutants are right all the same");
    assert!(not_caught * ONE_RIGHT_IN <= all, "{model}: {not_caught} of {all} mutants are right all the same");
}

/// True if a mutant is called different, with a state at which the values differ.
fn is_caught(judged: &Judged, id: &str) -> bool {
    let finding = judged.finding(id);
    let shown = finding.witness.as_ref().is_some_and(|w| w.left.to_bits() != w.right.to_bits());
    finding.judgement == Judgement::Different && shown
}

/// Adds every quantity as it is derived; the ids.
fn right_equations(printed: &Printed, report: &mut Report) -> Vec<String> {
    let add = |(at, (name, tree)): (usize, &(String, _))| {
        let id = format!("right-{at}");
        report.equation(&id, name, &text(tree));
        id
    };
    printed.equations.iter().enumerate().map(add).collect()
}

/// Adds the mutants, each with an id, and returns the ids of right rows that stand among them.
///
/// Every mutant of a row stands in its own place of a system, beside mutants of the other rows. One more row is right,
/// so that no system is a whole one, whose motion would be worked out.
fn place(printed: &Printed, mutants: &[Mutant], report: &mut Report) -> (Vec<Placed>, Vec<String>) {
    let mut placed = Vec::new();
    let mut of_row: FxHashMap<(usize, usize), Vec<&Mutant>> = FxHashMap::default();
    for (at, mutant) in mutants.iter().enumerate() {
        match mutant.place {
            Place::Equation(equation) => {
                let id = format!("mutant-{at}");
                report.equation(&id, &printed.equations[equation].0, &mutant.mutated[0]);
                placed.push(Placed { id, mutant: mutant.clone() });
            }
            Place::Row(system, row) => of_row.entry((system, row)).or_default().push(mutant),
        }
    }
    let mut right = Vec::new();
    for (at, system) in printed.systems.iter().enumerate() {
        let n = system.rows.len();
        let copies = (0..n).filter_map(|row| of_row.get(&(at, row)).map(Vec::len)).max().unwrap_or(0);
        for copy in 0..copies {
            let id = format!("{}-{copy}", system.formulation.name());
            let mut rows = Vec::new();
            for row in 0..n {
                let row_id = format!("{id}-row{}", row + 1);
                match of_row.get(&(at, row)).and_then(|list| list.get(copy)) {
                    Some(mutant) => {
                        rows.push(mutant.mutated.clone());
                        placed.push(Placed { id: row_id, mutant: (*mutant).clone() });
                    }
                    None => {
                        rows.push(system.rows[row].iter().map(text).collect());
                        right.push(row_id);
                    }
                }
            }
            rows.push(system.rows[n - 1].iter().map(text).collect());
            right.push(format!("{id}-row{}", n + 1));
            report.system(&id, system, &rows);
        }
    }
    (placed, right)
}

fn no_rewriting_is_called_different(model: &str, seed: u64) {
    let printed = Printed::new(model);
    let random = &mut Random(seed);
    let mut report = Report::default();
    let equations = rewritings::of_equations(&printed, REWRITINGS.0, random);
    assert_eq!(equations.len(), REWRITINGS.0, "{model}: rewritings of quantities");
    for (at, one) in equations.iter().enumerate() {
        report.equation(&format!("rewriting-{at}"), &printed.equations[one.equation].0, &one.rewritten);
    }
    let mut rows = Vec::new();
    for (system, copy) in printed.systems.iter().flat_map(|system| (0..REWRITINGS.1).map(move |copy| (system, copy))) {
        let id = format!("{}-{copy}", system.formulation.name());
        let mut list = rewritings::of_rows(&printed, system, random);
        let last = rewritings::Row { change: AS_DERIVED.to_owned(), entries: last_row(system) };
        list.push(last);
        let texts: Vec<Vec<String>> = list.iter().map(|row| row.entries.clone()).collect();
        report.system(&id, system, &texts);
        rows.extend(list.into_iter().enumerate().map(|(at, row)| (format!("{id}-row{}", at + 1), row)));
    }
    let judged = report.judged(model);
    let mut wrong = String::new();
    for (at, one) in equations.iter().enumerate() {
        let judgement = &judged.finding(&format!("rewriting-{at}")).judgement;
        if *judgement != Judgement::Equal {
            let quantity = &printed.equations[one.equation].0;
            let _ = writeln!(
                wrong,
                "rewriting-{at} of {quantity}, called {judgement:?}: {:?}\n    {}\n    became {}",
                one.rules, one.original, one.rewritten
            );
        }
    }
    for (id, row) in &rows {
        let judgement = &judged.finding(id).judgement;
        if !matches!(judgement, Judgement::Equal | Judgement::Scaled) {
            let _ = writeln!(wrong, "{id}, called {judgement:?}: {}\n    {:?}", row.change, row.entries);
        }
    }
    let changed = rows.iter().filter(|(_, row)| row.change != AS_DERIVED).count();
    println!("{model}: {} rewritings of quantities, {changed} of rows", equations.len());
    assert!(wrong.is_empty(), "{model}: rewritings that are not called equal:\n{wrong}");
}

fn last_row(system: &printed::System) -> Vec<String> {
    system.rows.last().map(|row| row.iter().map(text).collect()).expect("a system has rows")
}

/// Goal: rewriting rows, each on its own, changes no motion. Method: whole systems of the disk, rewritten.
#[test]
fn rewritten_systems_move_like_the_derived_ones() {
    let printed = Printed::new("disk");
    let random = &mut Random(7);
    let mut report = Report::default();
    for system in &printed.systems {
        let rows: Vec<_> = rewritings::of_rows(&printed, system, random).into_iter().map(|row| row.entries).collect();
        report.system(system.formulation.name(), system, &rows);
    }
    let consequences = report.judged("disk").difference.consequences;
    assert_eq!(consequences.len(), 3);
    for one in consequences {
        assert!(one.accelerations.is_equal(), "{}: {:?}", one.system, one.accelerations);
        assert!(one.rates.iter().all(|rate| rate.verdict.is_equal()), "{}: {:?}", one.system, one.rates);
    }
}
