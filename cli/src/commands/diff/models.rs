//! Command `tripos diff OLD NEW`: shows how an edit of a model changes its equations, declarations and scenes.
//!
//! The text fits a screen: each changed entry is shown by its difference, on one line. `--json` contains the old value,
//! the new value and the difference of all entries.

use super::Comparison;
use crate::files::workspace::short_name;
use crate::glossary::{glossary_json, glossary_text};
use crate::phrases::{entry_count_words, shorten_formula};
use crate::terminal::failure::Failure;
use serde_json::{Value, json};
use std::fmt::Write;
use std::path::Path;
use tripos_codegen::model_folders::{scene_path_in_model_folder, scenes_in_model_folder};
use tripos_derive::Model;
use tripos_derive::algebra::meaning::compare::Verdict;
use tripos_derive::algebra::text::print::{print_text, print_whole_text};
use tripos_derive::algebra::{Arena, Expr};
use tripos_derive::diagnostic::{Diagnostics, Source};
use tripos_derive::diff::{
    Declaration, DeclaredProperty, DerivedModel, Edit, EntryChange, ModelDifference, Section, SettingChange,
    VariableChange, diff_models, diff_scenes,
};
use tripos_derive::mechanics::derive_all;
use tripos_derive::plain_text::path_as_plain_text;
use tripos_derive::prove::prove;

/// Largest number of lines of each kind in the text. Only the number of further lines is given.
const SHOWN: usize = 16;

/// Compares two models with their declarations and scenes. The models count as different if a change can affect a
/// number.
///
/// # Errors
/// `Failure` if a model cannot be derived, or a scene file cannot be read.
pub fn diff(old: &Model, new: &Model) -> Result<Comparison, Failure> {
    let (difference, arena) = compare_derivations(old, new, Scope::EquationsAndIntegrals)?;
    let scenes = diff_model_scenes(&old.source.path, &new.source.path)?;
    Ok(Comparison {
        is_clean: difference.is_empty() && scenes.is_empty(),
        text: text_of(old, new, &arena, &difference, &scenes),
        json: json_of(old, new, &arena, &difference, &scenes),
    })
}

/// Choice of the properties of two models that are compared.
#[derive(Clone, Copy, PartialEq)]
enum Scope {
    /// Compares declarations and equations of motion.
    Equations,
    /// Also compares first integrals, which needs a proof for each model.
    EquationsAndIntegrals,
}

/// Derives both models and compares them. The returned arena holds the terms of the difference.
/// `Err` if a model cannot be derived.
fn compare_derivations(old: &Model, new: &Model, scope: Scope) -> Result<(ModelDifference, Arena), Diagnostics> {
    let with_integrals = scope == Scope::EquationsAndIntegrals;
    let mut before = derive_all(old).map_err(|error| old.diagnose(&error))?;
    let mut after = derive_all(new).map_err(|error| new.diagnose(&error))?;
    let old_proof = with_integrals.then(|| prove(old, &mut before));
    let new_proof = with_integrals.then(|| prove(new, &mut after));
    let difference = diff_models(
        &mut DerivedModel { model: old, derivations: &mut before, proof: old_proof.as_ref() },
        &mut DerivedModel { model: new, derivations: &mut after, proof: new_proof.as_ref() },
    );
    difference.write_names(&mut after);
    Ok((difference, after.kinematics.arena))
}

/// Returns lines about the changes of the equations of motion between two models; `None` if the
/// equations are the same.
///
/// # Errors
/// [`Diagnostics`] if a model cannot be derived.
pub fn changed_equations(old: &Model, new: &Model) -> Result<Option<String>, Diagnostics> {
    let (difference, arena) = compare_derivations(old, new, Scope::Equations)?;
    let mut out = String::new();
    write_model_equations_diff(&mut out, &arena, &difference);
    Ok((!difference.has_same_equations()).then(|| out + &glossary_text(&arena, &formulas_in_text(&difference))))
}

/// Change of one scene between two models.
struct SceneChange {
    /// Path of the scene file relative to its model.
    name: String,
    /// Kind of the change: added, removed or changed.
    kind: SceneEdit,
}

/// Kind of the change of a scene between two models.
enum SceneEdit {
    /// Only the new model has the scene.
    Added,
    /// Only the old model has the scene.
    Removed,
    /// Both models have the scene, but these settings differ.
    Changed(Vec<SettingChange>),
}

/// Returns the changes between the scenes of two models. Empty if one of the models has no scenes, because a model file
/// outside its folder does not mean that its scenes were removed. `Err` if a scene file cannot be read.
fn diff_model_scenes(old: &Path, new: &Path) -> Result<Vec<SceneChange>, Diagnostics> {
    let (before, after) = (scenes_in_model_folder(old), scenes_in_model_folder(new));
    let mut list = Vec::new();
    if before.is_empty() || after.is_empty() {
        return Ok(list);
    }
    let find = |name: &str| before.iter().find(|path| scene_path_in_model_folder(old, path) == name);
    let names: Vec<String> = after.iter().map(|path| scene_path_in_model_folder(new, path)).collect();
    for (path, name) in after.iter().zip(&names) {
        let kind = match find(name) {
            None => SceneEdit::Added,
            Some(former) => SceneEdit::Changed(diff_scenes(&Source::read(former)?, &Source::read(path)?)?),
        };
        if !matches!(&kind, SceneEdit::Changed(settings) if settings.is_empty()) {
            list.push(SceneChange { name: name.clone(), kind });
        }
    }
    let gone = before.iter().map(|path| scene_path_in_model_folder(old, path)).filter(|name| !names.contains(name));
    list.extend(gone.map(|name| SceneChange { name, kind: SceneEdit::Removed }));
    Ok(list)
}

/// Returns the word for the change of an entry: `undecided`, `different`, `added` or `removed`.
fn change_word(change: &EntryChange) -> &'static str {
    match (&change.verdict, change.old) {
        (Some(Verdict::Undecided(_)), _) => "undecided",
        (Some(_), _) => "different",
        (None, None) => "added",
        (None, Some(_)) => "removed",
    }
}

/// Returns the comparison of two models as JSON.
fn json_of(old: &Model, new: &Model, arena: &Arena, difference: &ModelDifference, scenes: &[SceneChange]) -> Value {
    let shown = |e: Option<Expr>| e.map(|e| print_whole_text(arena, e));
    let equation = |c: &EntryChange| {
        json!({
            "id": c.name,
            "verdict": change_word(c),
            "old": shown(c.old),
            "new": shown(c.new),
            "difference": shown(c.difference),
        })
    };
    let lost = difference.formulations_lost.iter().map(|(f, why)| json!({ "formulation": f.name(), "why": why }));
    let lost: Vec<Value> = lost.collect();
    let gained: Vec<&str> = difference.formulations_gained.iter().map(|f| f.name()).collect();
    json!({
        "old": short_name(old),
        "new": short_name(new),
        "same": difference.is_empty() && scenes.is_empty(),
        "same_equations": difference.has_same_equations(),
        "variables": difference.variables.iter().map(variable_json).collect::<Vec<_>>(),
        "equations": difference.changes.iter().map(equation).collect::<Vec<_>>(),
        "declarations": difference.declarations.iter().map(declaration_json).collect::<Vec<_>>(),
        "scenes": scenes.iter().map(scene_json).collect::<Vec<_>>(),
        "formulations": { "lost": lost, "gained": gained },
        "integrals": { "lost": difference.integrals_lost, "gained": difference.integrals_gained },
        "names": glossary_json(arena, &difference.shown()),
        "summary": { "compared": difference.compared, "changed": difference.changes.len() },
    })
}

/// Returns the change of a motion variable as JSON.
fn variable_json(change: &VariableChange) -> Value {
    json!({ "what": change.kind.noun(), "old": change.old, "new": change.new })
}

/// Returns the change of a declaration as JSON.
fn declaration_json(declaration: &Declaration) -> Value {
    let (what, name) = (declaration.section.noun(), &declaration.name);
    match &declaration.edit {
        Edit::Added => json!({ "what": what, "name": name, "edit": "added" }),
        Edit::Removed => json!({ "what": what, "name": name, "edit": "removed" }),
        Edit::Changed { property, old, new } => {
            let property = property.name();
            json!({ "what": what, "name": name, "edit": "changed", "property": property, "old": old, "new": new })
        }
    }
}

/// Returns the change of a scene as JSON.
fn scene_json(scene: &SceneChange) -> Value {
    let name = &scene.name;
    match &scene.kind {
        SceneEdit::Added => json!({ "scene": name, "edit": "added" }),
        SceneEdit::Removed => json!({ "scene": name, "edit": "removed" }),
        SceneEdit::Changed(settings) => {
            let of = |s: &SettingChange| json!({ "key": s.key, "old": s.old, "new": s.new });
            json!({ "scene": name, "edit": "changed", "settings": settings.iter().map(of).collect::<Vec<_>>() })
        }
    }
}

/// Returns the comparison of two models as text.
fn text_of(old: &Model, new: &Model, arena: &Arena, difference: &ModelDifference, scenes: &[SceneChange]) -> String {
    let mut out = format!("{} -> {}\n", path_as_plain_text(&old.source.path), path_as_plain_text(&new.source.path));
    write_model_equations_diff(&mut out, arena, difference);
    let renamed = !difference.variables.is_empty();
    for (what, names) in
        [("no longer found conserved", &difference.integrals_lost), ("now conserved", &difference.integrals_gained)]
    {
        if !names.is_empty() && !renamed {
            let _ = writeln!(out, "{what}:");
            write_model_diff_lines(&mut out, names);
        }
    }
    for line in declaration_lines(&difference.declarations) {
        let _ = writeln!(out, "{}", shorten_formula(&line));
    }
    if !scenes.is_empty() {
        out.push_str("scenes differ:\n");
        write_model_diff_lines(&mut out, &scenes.iter().map(scene_line).collect::<Vec<_>>());
    }
    if difference.declarations.is_empty() && scenes.is_empty() {
        out.push_str("defaults, units, domain, elements and scenes: the same\n");
    }
    out + &glossary_text(arena, &formulas_in_text(difference))
}

/// Writes lines about the changes of the equations of motion, at most 16 of each kind.
fn write_model_equations_diff(out: &mut String, arena: &Arena, difference: &ModelDifference) {
    let (count, compared) = (difference.changes.len(), entry_count_words(difference.compared));
    if difference.has_same_equations() {
        let _ = writeln!(out, "equations of motion: the same, {compared} compared by algebra");
    } else if !difference.variables.is_empty() {
        let _ = writeln!(
            out,
            "equations of motion: proved the same in other variables; {count} of {compared} read otherwise"
        );
        let line = |v: &VariableChange| format!("old {} {} is {}", v.kind.noun(), v.old, v.new);
        write_model_diff_lines(out, &difference.variables.iter().map(line).collect::<Vec<_>>());
        return;
    } else {
        let _ = writeln!(out, "equations of motion: {count} of {compared} changed");
    }
    for (formulation, why) in &difference.formulations_lost {
        let _ = writeln!(out, "  no longer derived: {}: {why}", formulation.name());
    }
    for formulation in &difference.formulations_gained {
        let _ = writeln!(out, "  now derived: {}", formulation.name());
    }
    write_model_diff_lines(
        out,
        &difference.changes.iter().map(|change| change_line(arena, change)).collect::<Vec<_>>(),
    );
}

/// Lists the formulas of the changes that the text shows.
fn formulas_in_text(difference: &ModelDifference) -> Vec<Expr> {
    let count = if difference.variables.is_empty() { SHOWN } else { 0 };
    let changes = difference.changes.iter().take(count);
    changes.flat_map(|change| [change.old, change.new, change.difference]).flatten().collect()
}

/// Writes lines under a heading. If there are more than 16, it writes the first 16 and the number of the others.
fn write_model_diff_lines(out: &mut String, lines: &[String]) {
    for line in lines.iter().take(SHOWN) {
        let _ = writeln!(out, "  {}", shorten_formula(line));
    }
    if let Some(more @ 1..) = lines.len().checked_sub(SHOWN) {
        let _ = writeln!(out, "  … and {more} more, which `tripos diff OLD NEW --json` has");
    }
}

/// Returns the line about a changed entry. It shows the difference, or the old and new value if these are shorter.
fn change_line(arena: &Arena, change: &EntryChange) -> String {
    let (name, text) = (&change.name, |e| print_text(arena, e));
    match (change.old, change.new, change.difference) {
        (Some(old), Some(new), Some(difference)) => {
            let (values, difference) = (format!("{} -> {}", text(old), text(new)), text(difference));
            let is_undecided = if change_word(change) == "undecided" { " (undecided)" } else { "" };
            if values.len() < difference.len() {
                format!("{name}{is_undecided}: {values}")
            } else {
                format!("{name}{is_undecided}: new - old = {difference}")
            }
        }
        (_, Some(new), _) => format!("{name}: added, {}", text(new)),
        (Some(old), ..) => format!("{name}: removed, {}", text(old)),
        (None, None, _) => format!("{name}: {}", change_word(change)),
    }
}

/// Returns the lines about changed declarations, one for each kind, such as `defaults differ: R 1
/// -> 2; g 9.81 -> 1.62`.
fn declaration_lines(declarations: &[Declaration]) -> Vec<String> {
    let named = |d: &Declaration| format!("{} {}", d.section.noun(), d.name);
    let changed = |wanted: DeclaredProperty, of: fn(Section) -> bool| {
        let change = move |d: &Declaration| match &d.edit {
            Edit::Changed { property, old, new } if *property == wanted && of(d.section) => {
                Some(format!("{} {old} -> {new}", d.name))
            }
            _ => None,
        };
        declarations.iter().filter_map(change).collect::<Vec<_>>()
    };
    let alone = |edit: &Edit| declarations.iter().filter(|d| d.edit == *edit).map(named).collect::<Vec<_>>();
    let is_condition = |section| section == Section::Domain;
    let groups = [
        ("added", alone(&Edit::Added)),
        ("removed", alone(&Edit::Removed)),
        ("defaults differ", changed(DeclaredProperty::Default, |_| true)),
        ("units differ", changed(DeclaredProperty::Unit, |_| true)),
        ("stated to be positive differs", changed(DeclaredProperty::Positive, |_| true)),
        ("domain differs", changed(DeclaredProperty::Definition, is_condition)),
        ("defined otherwise", changed(DeclaredProperty::Definition, |section| section != Section::Domain)),
    ];
    let stated = groups.into_iter().filter(|(_, list)| !list.is_empty());
    stated.map(|(heading, list)| format!("{heading}: {}", list.join("; "))).collect()
}

/// Returns the line about a changed scene.
fn scene_line(scene: &SceneChange) -> String {
    let name = &scene.name;
    let value = |v: &Option<String>| v.clone().unwrap_or_else(|| "not stated".to_owned());
    match &scene.kind {
        SceneEdit::Added => format!("{name}: added"),
        SceneEdit::Removed => format!("{name}: removed"),
        SceneEdit::Changed(settings) => {
            let of = |s: &SettingChange| format!("{} {} -> {}", s.key, value(&s.old), value(&s.new));
            format!("{name}: {}", settings.iter().map(of).collect::<Vec<_>>().join("; "))
        }
    }
}
