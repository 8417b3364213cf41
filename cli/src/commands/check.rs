//! Command `tripos check`: prints facts about a model that can be known before its equations are used.

use crate::files::workspace::{read_model, short_name};
use crate::phrases::{NAMED_TERMS_HEADING, shorten_formula};
use crate::terminal::failure::{Failure, Output, print, print_json};
use serde_json::{Map, Value, json};
use std::fmt::Write;
use std::path::Path;
use tripos::Mechanism;
use tripos_derive::check::{
    CheckedConstraint, ConstraintKind, EnergyEffect, LoadEffect, ModelCheck, RankLoss, check as check_model,
};
use tripos_derive::model::AssemblyBranch;

/// Runs `tripos check`: prints the freedoms, constraints and singularities of a model. Returns the exit status.
///
/// # Errors
/// `Failure` if the model cannot be read or checked, or the output cannot be printed.
pub fn check(model: &Path, output: Output) -> Result<u8, Failure> {
    let model = read_model(model)?;
    let found = check_model(&model).map_err(|error| model.diagnose(&error))?;
    if output == Output::Json {
        print_json(&check_json(&model, &found))?;
    } else {
        print(&check_text(&model, &found))?;
    }
    Ok(0)
}

/// Returns the word for a kind of constraint: `configuration` or `motion`.
fn checked_constraint_word(kind: ConstraintKind) -> &'static str {
    match kind {
        ConstraintKind::Configuration => "configuration",
        ConstraintKind::Motion => "motion",
    }
}

/// Returns the result of a check as JSON.
fn check_json(model: &Mechanism, found: &ModelCheck) -> Value {
    let constraint = |c: &CheckedConstraint| {
        json!({
            "name": c.name, "kind": checked_constraint_word(c.kind), "integrable": c.integrable, "integral": c.integral, "redundant": c.redundant,
        })
    };
    json!({
        "model": short_name(model),
        "coordinates": found.coordinates,
        "speeds": found.speeds,
        "constraints": found.constraints.iter().map(constraint).collect::<Vec<_>>(),
        "degrees_of_freedom": found.degrees_of_freedom,
        "configuration_freedom": found.configuration_freedom,
        "mobility_count": found.mobility_count,
        "branch": found.branch.as_ref().map(|branch| branch_of(model, branch)),
        "singular_where": found.singular_where,
        "singular_poses": found.rank_loss.as_ref().map(singular_poses_json),
        "indeterminate": found.indeterminate,
        "loads": found.loads.iter().map(load_effect_json).collect::<Vec<_>>(),
        "notes": found.notes,
        "names": found.names.iter().map(|(name, value)| (name.clone(), json!(value))).collect::<Map<_, _>>(),
    })
}

/// Returns an assembly branch as JSON: a pose on the branch, the number of independent constraints, and the bounds with
/// which this number was decided.
fn branch_of(model: &Mechanism, branch: &AssemblyBranch) -> Value {
    let names = model.coordinates.iter().map(|c| c.name.clone());
    let pose: Map<String, Value> = names.zip(branch.pose.iter().map(|x| json!(x))).collect();
    json!({
        "name": checked_branch_name(model, branch),
        "pose": pose,
        "kind": "numeric",
        "poses": branch.poses,
        "constraints": branch.constraints,
        "rank": branch.rank,
        "larger": branch.larger.as_ref().map(|(freedoms, pose)| json!({ "name": pose_text(model, pose), "freedoms": freedoms })),
        "bound": { "independent_above": branch.independent, "dependent_below": branch.dependent },
    })
}

/// Returns the name of an assembly branch, by a pose on it.
fn checked_branch_name(model: &Mechanism, branch: &AssemblyBranch) -> String {
    pose_text(model, &branch.pose)
}

/// Returns the words `through q1 = …` for a pose, with four decimals.
fn pose_text(model: &Mechanism, pose: &[f64]) -> String {
    let coordinates = model.coordinates.iter().zip(pose);
    let at: Vec<String> = coordinates.map(|(c, x)| format!("{} = {}", c.name, round_checked_coordinate(*x))).collect();
    format!("through {}", at.join(", "))
}

/// Rounds a number to four decimals. A negative zero becomes 0.
fn round_checked_coordinate(x: f64) -> f64 {
    (x * 1e4).round() / 1e4 + 0.0
}

/// Returns the poses in which the constraints lose rank as JSON.
fn singular_poses_json(loss: &RankLoss) -> Value {
    let pose =
        loss.pose.as_ref().map(|pose| pose.iter().map(|(name, x)| (name.clone(), json!(x))).collect::<Map<_, _>>());
    json!({
        "rank": loss.rank,
        "nowhere": loss.nowhere,
        "proof": loss.proof,
        "as_long_as_not_zero": loss.taken,
        "where_all_zero": loss.where_all_zero,
        "pose": pose,
        "rank_there": loss.rank_there,
        "sought_from": loss.sought,
    })
}

/// Returns the effect of a load on the energy as JSON.
fn load_effect_json(load: &LoadEffect) -> Value {
    let energy = match load.effect {
        EnergyEffect::Keeps => "keeps",
        EnergyEffect::Dissipates => "dissipates",
        EnergyEffect::Creates => "creates",
        EnergyEffect::Undecided => "undecided",
    };
    json!({ "name": load.load, "energy": energy, "why": load.why })
}

/// Returns the lines about singular poses, in which the constraints of the mechanism lose rank: a proof that there are
/// none, or such a pose.
fn singular_text(loss: &RankLoss) -> String {
    let taken: Vec<String> = loss.taken.iter().map(|e| shorten_formula(e)).collect();
    let taken = match taken.as_slice() {
        [] => String::new(),
        [one] => format!(", as long as {one} is not 0"),
        all => format!(", as long as none of {} is 0", all.join(", ")),
    };
    if loss.nowhere {
        let proof = loss.proof.join("; ");
        return format!(
            "\nThe mechanism itself is singular nowhere{taken}: its constraints keep their rank, since {proof}\n"
        );
    }
    let mut out = String::new();
    if let Some(formulas) = &loss.where_all_zero {
        let formulas: Vec<String> = formulas.iter().map(|e| shorten_formula(e)).collect();
        let all = if formulas.len() == 1 { "this is 0" } else { "all of these are 0" };
        let is = if loss.pose.is_some() { "is singular, whatever its speeds," } else { "can be singular only" };
        let _ = write!(out, "\nThe mechanism itself {is} where {all}{taken}: {}", formulas.join(", "));
    }
    match (&loss.pose, loss.rank_there) {
        (Some(pose), Some(rank)) => {
            let pose: Vec<String> =
                pose.iter().map(|(name, x)| format!("{name} = {}", round_checked_coordinate(*x))).collect();
            let _ = writeln!(
                out,
                "\nA singular pose of the mechanism, at the default values: {} (rank {rank} instead of {})",
                pose.join(", "),
                loss.rank
            );
        }
        _ if loss.sought > 0 => {
            let _ = writeln!(
                out,
                "\nNo singular pose of the mechanism was found from {} random ones, at the default values: no proof that there is none",
                loss.sought
            );
        }
        _ => out.push('\n'),
    }
    out
}

/// Returns the lines about loads that can create energy, or for which this is undecided. Empty if there are none.
fn loads_text(loads: &[LoadEffect]) -> String {
    let mut out = String::new();
    for load in loads {
        let what = match load.effect {
            EnergyEffect::Creates => "can create energy",
            EnergyEffect::Undecided => "may create energy: undecided",
            EnergyEffect::Keeps | EnergyEffect::Dissipates => continue,
        };
        let _ = writeln!(out, "load {}: {what}: {}", load.load, load.why);
    }
    if out.is_empty() { out } else { format!("\n{out}") }
}

/// Returns the result of a check as text.
fn check_text(model: &Mechanism, found: &ModelCheck) -> String {
    let mut out = format!("{}\n{}\n\n", model.title, model.counts_in_words());
    let freedom = found.configuration_freedom.map_or_else(|| "not decided".to_owned(), |n| format!("{n}-dimensional"));
    let _ = writeln!(out, "degrees of freedom in velocity: {}", found.degrees_of_freedom);
    let _ = writeln!(out, "reachable configurations: {freedom}");
    if !found.constraints.is_empty() {
        let _ = writeln!(out, "coordinates less constraints, counted: {}", found.mobility_count);
    }
    if let Some(branch) = &found.branch {
        let _ = writeln!(
            out,
            "assembly branch {}: rank {} of {} constraints, in {} closed poses, in doubles, at the default values",
            checked_branch_name(model, branch),
            branch.rank,
            branch.constraints,
            branch.poses
        );
        if let Some((freedoms, pose)) = &branch.larger {
            let _ = writeln!(
                out,
                "another branch of poses, {}, has {freedoms} freedoms; the results do not cover this branch",
                pose_text(model, pose)
            );
        }
    }
    if !found.constraints.is_empty() {
        out += "\nConstraints\n";
    }
    for constraint in &found.constraints {
        let what = match (constraint.redundant, constraint.integrable) {
            (true, _) => "follows from the others".to_owned(),
            (_, None) => "whether it is integrable was not decided".to_owned(),
            (_, Some(false)) => "not integrable: it restricts velocities alone".to_owned(),
            (_, Some(true)) => match (&constraint.integral, constraint.kind) {
                (None, _) => "integrable".to_owned(),
                (Some(e), ConstraintKind::Configuration) => format!("{} is 0", shorten_formula(e)),
                (Some(e), ConstraintKind::Motion) => format!("integrable: {} is constant", shorten_formula(e)),
            },
        };
        let _ = writeln!(out, "  {} ({}): {what}", constraint.name, checked_constraint_word(constraint.kind));
    }
    if !found.singular_where.is_empty() {
        let _ = writeln!(
            out,
            "\nThe chosen speeds do not determine the motion where one of these is 0: {}",
            found.singular_where.iter().map(|e| shorten_formula(e)).collect::<Vec<_>>().join(", ")
        );
    }
    out += &found.rank_loss.as_ref().map_or_else(String::new, singular_text);
    out += &loads_text(&found.loads);
    if !found.notes.is_empty() {
        out.push('\n');
    }
    for note in &found.notes {
        let _ = writeln!(out, "note: {note}");
    }
    if !found.names.is_empty() {
        let _ = writeln!(out, "\n{NAMED_TERMS_HEADING}, each line by those before it");
    }
    for (name, value) in &found.names {
        let _ = writeln!(out, "  {name} = {value}");
    }
    out
}
