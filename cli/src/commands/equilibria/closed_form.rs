//! Conditions of rest and of steady motion in closed form, as text and as JSON.

use crate::phrases::plural_form;
use serde_json::{Value, json};
use std::fmt::Write;
use tripos::studies::steady::{Conditions, Formula, NamedFormula, SolutionBranch, SteadyConditions};

/// Largest number of solutions of each kind of motion in the text. JSON lists all solutions.
const MOST_BRANCHES: usize = 6;
/// Largest number of characters of a formula in the text. JSON contains whole formulas.
const MOST_LETTERS: usize = 240;

/// Returns the conditions of rest and steady motion in closed form as text.
pub fn text(found: &SteadyConditions) -> String {
    let mut out = "in closed form\n".to_owned();
    for conditions in &found.list {
        let _ = writeln!(out, "{}", condition_heading(conditions));
        for velocity in conditions.along.iter().filter(|v| !v.is_rate) {
            let _ = writeln!(out, "    {}: the velocity along {}", velocity.name, velocity.along);
        }
        for equation in &conditions.equations {
            let _ = writeln!(out, "    {} = 0", shorten_formula(&equation.text));
        }
        if conditions.too_large > 0 {
            let count = conditions.too_large;
            let _ = writeln!(
                out,
                "    {count} more {}",
                plural_form(count, "equation that is too large", "equations that are too large")
            );
        }
        if !conditions.divided_by.is_empty() && conditions.too_large == 0 {
            let _ = writeln!(
                out,
                "  where the equations have a value: {}",
                closed_form_nonzero_text(&conditions.divided_by)
            );
        }
        for (at, branch) in conditions.branches.iter().enumerate().take(MOST_BRANCHES) {
            let _ = writeln!(out, "  {}. {}", at + 1, branch_text(branch));
        }
        if conditions.branches.len() > MOST_BRANCHES {
            let count = conditions.branches.len() - MOST_BRANCHES;
            let _ = writeln!(out, "  and {count} more {}: --json has all", plural_form(count, "solution", "solutions"));
        }
        let _ = match (conditions.complete, conditions.branches.is_empty()) {
            (true, true) if !conditions.equations.is_empty() => writeln!(out, "  no solution there"),
            (false, true) => writeln!(out, "  not solved: too large"),
            (false, false) => writeln!(out, "  there may be more solutions: the search ended before its end"),
            _ => Ok(()),
        };
    }
    out
}

/// Returns the heading of a set of conditions: rest, or steady motion along symmetries.
fn condition_heading(conditions: &Conditions) -> String {
    let names: Vec<&str> = conditions.along.iter().map(|v| v.name.as_str()).collect();
    let what = if conditions.rest {
        "rest".to_owned()
    } else {
        format!("steady motion at velocities {} along symmetries", names.join(", "))
    };
    if conditions.equations.is_empty() && conditions.too_large == 0 {
        return format!("  {what}: anywhere, nothing must vanish");
    }
    format!("  {what}, where")
}

/// Shortens a formula of more than 240 characters to its beginning, and adds its length.
fn shorten_formula(text: &str) -> String {
    let letters = text.chars().count();
    if letters <= MOST_LETTERS {
        return text.to_owned();
    }
    let begin: String = text.chars().take(MOST_LETTERS / 4).collect();
    format!("{begin}… ({letters} letters, whole in --json)")
}

/// Returns conditions `… != 0` as text, for formulas that are divisors.
fn closed_form_nonzero_text(list: &[Formula]) -> String {
    let list: Vec<String> = list.iter().map(|e| format!("{} != 0", shorten_formula(&e.text))).collect();
    list.join(", ")
}

/// Returns a solution of the conditions as text: the solved unknowns, inequalities, and the remaining equations.
fn branch_text(branch: &SolutionBranch) -> String {
    let equal = |told: &NamedFormula| format!("{} = {}", told.name.text, shorten_formula(&told.value.text));
    let mut parts: Vec<String> = branch.solved.iter().map(equal).collect();
    if parts.is_empty() {
        parts.push("what is not solved for".to_owned());
    }
    let mut out = parts.join(", ");
    let needs = branch.needs.iter().map(|need| shorten_formula(&need.text));
    let conditions: Vec<String> =
        needs.chain(branch.divided_by.iter().map(|e| format!("{} != 0", shorten_formula(&e.text)))).collect();
    if !conditions.is_empty() {
        let _ = write!(out, ", if {}", conditions.join(", "));
    }
    if !branch.left.is_empty() {
        let left: Vec<String> = branch.left.iter().map(|e| format!("{} = 0", shorten_formula(&e.text))).collect();
        let _ = write!(out, "; with {}, which is left", left.join(", "));
    }
    out
}

/// Returns the conditions of rest and steady motion in closed form as JSON.
pub fn json(found: &SteadyConditions) -> Value {
    found.list.iter().map(json_of).collect()
}

/// Returns one set of conditions as JSON.
fn json_of(conditions: &Conditions) -> Value {
    let along = conditions.along.iter().map(|v| json!({ "name": v.name, "along": v.along }));
    let branch = |branch: &SolutionBranch| {
        json!({
            "solved": closed_form_equations_json(&branch.solved), "needs": closed_form_formulas_json(&branch.needs),
            "divided_by": closed_form_formulas_json(&branch.divided_by), "left": closed_form_formulas_json(&branch.left),
        })
    };
    json!({
        "rest": conditions.rest,
        "along": along.collect::<Vec<_>>(),
        "speeds": closed_form_equations_json(&conditions.speeds),
        "unknowns": conditions.unknowns,
        "equations": closed_form_formulas_json(&conditions.equations),
        "too_large": conditions.too_large,
        "divided_by": closed_form_formulas_json(&conditions.divided_by),
        "branches": conditions.branches.iter().map(branch).collect::<Vec<_>>(),
        "complete": conditions.complete,
    })
}

/// Returns formulas as JSON, each as text and in LaTeX.
fn closed_form_formulas_json(list: &[Formula]) -> Vec<Value> {
    list.iter().map(|e| json!({ "formula": e.text, "latex": e.latex })).collect()
}

/// Returns named formulas as JSON, each with its name.
fn closed_form_equations_json(list: &[NamedFormula]) -> Vec<Value> {
    let told = |told: &NamedFormula| {
        json!({
            "name": told.name.text, "formula": told.value.text,
            "latex": format!("{} = {}", told.name.latex, told.value.latex),
        })
    };
    list.iter().map(told).collect()
}
