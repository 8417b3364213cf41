//! `tripos diff OLD NEW`: what a model edit changed in the equations of motion.

use super::entries;
use crate::failure::{Failure, print, print_json, status};
use crate::workspace::short_name;
use serde_json::{Value, json};
use std::fmt::Write;
use tripos_derive::Model;
use tripos_derive::algebra::compare::Verdict;
use tripos_derive::algebra::print::{text, whole_text};
use tripos_derive::algebra::{Arena, Expr};
use tripos_derive::diff::{Change, Derived, ModelDifference, diff_models};
use tripos_derive::mechanics::derive_all;
use tripos_derive::prove::prove;

/// Compares two models; exit status 1 if their equations differ.
pub fn diff(old: &Model, new: &Model, as_json: bool) -> Result<u8, Failure> {
    let mut before = derive_all(old).map_err(|error| old.diagnose(&error))?;
    let mut after = derive_all(new).map_err(|error| new.diagnose(&error))?;
    let (old_proof, new_proof) = (prove(old, &mut before), prove(new, &mut after));
    let difference = diff_models(
        &mut Derived { model: old, derivations: &mut before, proof: &old_proof },
        &mut Derived { model: new, derivations: &mut after, proof: &new_proof },
    );
    let arena = &after.kinematics.arena;
    if as_json {
        print_json(&json_of(old, new, arena, &difference))?;
    } else {
        print(&text_of(old, new, arena, &difference))?;
    }
    Ok(if difference.is_empty() { 0 } else { status::NO })
}

fn word(change: &Change) -> &'static str {
    match (&change.verdict, change.old) {
        (Some(Verdict::Undecided(_)), _) => "undecided",
        (Some(_), _) => "different",
        (None, None) => "added",
        (None, Some(_)) => "removed",
    }
}

fn json_of(old: &Model, new: &Model, arena: &Arena, difference: &ModelDifference) -> Value {
    let shown = |e: Option<Expr>| e.map(|e| whole_text(arena, e));
    let equations: Vec<Value> = difference
        .changes
        .iter()
        .map(|c| {
            json!({
                "id": c.name,
                "verdict": word(c),
                "old": shown(c.old),
                "new": shown(c.new),
                "difference": shown(c.difference),
            })
        })
        .collect();
    let lost = difference.formulations_lost.iter().map(|(f, why)| json!({ "formulation": f.name(), "why": why }));
    let lost: Vec<Value> = lost.collect();
    let gained: Vec<&str> = difference.formulations_gained.iter().map(|f| f.name()).collect();
    json!({
        "old": short_name(old),
        "new": short_name(new),
        "equations": equations,
        "formulations": { "lost": lost, "gained": gained },
        "integrals": { "lost": difference.integrals_lost, "gained": difference.integrals_gained },
        "summary": { "compared": difference.compared, "changed": difference.changes.len() },
    })
}

fn text_of(old: &Model, new: &Model, arena: &Arena, difference: &ModelDifference) -> String {
    let mut out = format!("{} -> {}\n", old.source.path.display(), new.source.path.display());
    if difference.is_empty() {
        let _ =
            writeln!(out, "the equations of motion are the same: {} compared by meaning", entries(difference.compared));
        return out;
    }
    for (formulation, why) in &difference.formulations_lost {
        let _ = writeln!(out, "\nno longer derived: {}\n  {why}", formulation.name());
    }
    for formulation in &difference.formulations_gained {
        let _ = writeln!(out, "\nnow derived: {}", formulation.name());
    }
    for change in &difference.changes {
        let _ = writeln!(out, "\n{}: {}", change.name, word(change));
        for (sign, value) in [("-", change.old), ("+", change.new), ("new - old =", change.difference)] {
            if let Some(value) = value {
                let _ = writeln!(out, "  {sign} {}", text(arena, value));
            }
        }
    }
    for (what, list) in
        [("no longer found conserved", &difference.integrals_lost), ("now conserved", &difference.integrals_gained)]
    {
        for name in list {
            let _ = writeln!(out, "\n{what}: {name}");
        }
    }
    let _ = writeln!(out, "\n{} of {} changed", difference.changes.len(), entries(difference.compared));
    out
}
