//! Mutants that are not called different: they must be right equations, and SymPy must say so.

use super::judge::judge;
use super::mutants::{Mutant, Place};
use super::printed::Printed;
use super::report::{Judged, Report};
use super::tree::text;
use super::{Placed, multipliers};
use std::fmt::Write;
use tripos_derive::algebra::Expr;
use tripos_derive::algebra::text::print::print_text;
use tripos_derive::diff::Judgement;

/// Has SymPy prove that each of these mutants is a right equation, and lists them.
pub fn confirm(model: &str, printed: &mut Printed, judged: &Judged, suspects: Vec<Placed>) {
    let positive = printed.positive();
    let mut wrong = String::new();
    for Placed { id, mutant } in suspects {
        let judgement = &judged.finding(&id).judgement;
        let shown = describe(model, printed, &id, &mutant);
        let Some(right) = right_side(printed, &mutant) else {
            let _ = writeln!(wrong, "called {judgement:?}, and no combination of rows: {shown}");
            continue;
        };
        let pairs: Vec<_> = right.formulas.into_iter().zip(mutant.mutated.clone()).collect();
        match judge(&pairs, &positive) {
            None => list(&format!("not known to be right, and called {}: {shown}", judgement.word())),
            Some(answers) if answers.iter().all(|answer| answer == "equal") => {
                assert_ne!(*judgement, Judgement::Different, "shown at no state: {shown}");
                if right.replaces_its_row {
                    list(&format!("right all the same, says SymPy, and called {}: {shown}", judgement.word()));
                } else {
                    assert_moves_otherwise(model, printed, &mutant, &shown);
                    list(&format!("what other rows say, says SymPy, and found in the motion: {shown}"));
                }
            }
            Some(answers) => {
                let _ = writeln!(wrong, "called {judgement:?}, SymPy says {answers:?}: {shown}");
            }
        }
    }
    assert!(wrong.is_empty(), "mutants that are not called different:\n{wrong}");
}

/// Not `eprintln`, whose text the test harness keeps to itself.
fn list(line: &str) {
    let _ = std::io::Write::write_all(&mut std::io::stderr(), line.as_bytes());
}

/// Formulas to which mutated ones must be equal if they are right.
struct Right {
    formulas: Vec<String>,
    /// In the place of the right row, the mutant leaves the system as good as it was.
    replaces_its_row: bool,
}

/// The right value of a quantity; for a row, Σ λ · (derived row) with the λ that explain its entries. SymPy alone
/// judges the result, so the source of λ does not matter.
fn right_side(printed: &mut Printed, mutant: &Mutant) -> Option<Right> {
    let Place::Row(system, row) = mutant.place else {
        return Some(Right { formulas: mutant.original.clone(), replaces_its_row: true });
    };
    let multipliers = multipliers::find(printed, system, &mutant.mutated)?;
    let arena = &printed.derivations.kinematics.arena;
    let column = |at: usize| {
        let parts = printed.systems[system].terms.iter().zip(&multipliers).filter(|(_, k)| **k != Expr::ZERO);
        let part =
            |(row, k): (&Vec<Expr>, &Expr)| format!("({})*({})", print_text(arena, *k), print_text(arena, row[at]));
        let parts: Vec<String> = parts.map(part).collect();
        if parts.is_empty() { "0".to_owned() } else { parts.join(" + ") }
    };
    let formulas = (0..mutant.mutated.len()).map(column).collect();
    Some(Right { formulas, replaces_its_row: multipliers[row] != Expr::ZERO })
}

/// A row that repeats others is right and yet spoils its system, which has one equation too few then.
fn assert_moves_otherwise(model: &str, printed: &Printed, mutant: &Mutant, shown: &str) {
    let Place::Row(at, row) = mutant.place else { return };
    let system = &printed.systems[at];
    let mut rows: Vec<Vec<String>> = system.rows.iter().map(|row| row.iter().map(text).collect()).collect();
    rows[row].clone_from(&mutant.mutated);
    let mut report = Report::default();
    report.system("whole", system, &rows);
    let consequences = report.judged(model).difference.consequences;
    assert_eq!(consequences.len(), 1, "{shown}");
    assert!(!consequences[0].accelerations.is_equal(), "{:?}: {shown}", consequences[0]);
}

fn describe(model: &str, printed: &Printed, id: &str, mutant: &Mutant) -> String {
    let of = match mutant.place {
        Place::Equation(at) => printed.equations[at].0.clone(),
        Place::Row(system, row) => format!("{} row {}", printed.systems[system].formulation.name(), row + 1),
    };
    let changed = mutant.original.iter().zip(&mutant.mutated).filter(|(a, b)| a != b);
    let changed: Vec<String> = changed.map(|(a, b)| format!("    {a}\n    became {b}\n")).collect();
    format!("{model}, {id}, {:?} of {of}:\n{}", mutant.kind, changed.concat())
}
