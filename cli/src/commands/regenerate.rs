//! `tripos regenerate`: the only writer of `generated/` and of the references beside the models.

mod changes;
mod python;
mod reference;

use crate::catalogue::workspace_here;
use crate::failure::{Failure, print, status};
use changes::equation_changes;
use std::fmt::Write;
use std::path::{Path, PathBuf};
use tripos_codegen::workspace::{Difference, Freshness, freshness, write};

/// Says what differs; exit status 1 if anything does.
pub fn check() -> Result<u8, Failure> {
    let root = workspace_here()?;
    let (found, committed) = look(&root)?;
    print(&summary(&found, &committed))?;
    let references = reference::check(&root, &sound(&found));
    for line in &references {
        print(&format!("{line}\n"))?;
    }
    complain(&found)?;
    Ok(if found.differences.is_empty() && references.is_empty() { 0 } else { status::NO })
}

/// Writes what differs, and says what changed in the equations; then renews the references, exit status 1 if one disagrees.
pub fn regenerate() -> Result<u8, Failure> {
    let root = workspace_here()?;
    let (found, committed) = look(&root)?;
    let text = summary(&found, &committed);
    write(&found, &committed)?;
    print(&text)?;
    let answer = reference::renew(&root, &sound(&found))?;
    complain(&found)?;
    Ok(answer)
}

/// The models without errors.
fn sound(found: &Freshness) -> Vec<String> {
    let is_broken = |name: &String| found.generated.broken.iter().any(|(broken, _)| broken == name);
    found.generated.models.iter().filter(|name| !is_broken(name)).cloned().collect()
}

fn look(root: &Path) -> Result<(Freshness, PathBuf), Failure> {
    let committed = root.join("generated/src");
    let found = freshness(&root.join("models"), &committed).map_err(|error| {
        Failure::Request(
            format!("cannot read {}: {error}", root.join("models").display()),
            "run this in a checkout that has models/ and generated/".to_owned(),
        )
    })?;
    Ok((found, committed))
}

/// Broken models are an error of the whole command, after the others are done.
fn complain(found: &Freshness) -> Result<(), Failure> {
    if found.generated.broken.is_empty() {
        return Ok(());
    }
    Err(Failure::Inputs(found.generated.broken.iter().map(|(_, diagnostics)| diagnostics.clone()).collect()))
}

fn summary(found: &Freshness, committed: &Path) -> String {
    if found.differences.is_empty() {
        return format!("generated/ is fresh: {} models\n", found.generated.models.len());
    }
    let mut out = String::new();
    for difference in &found.differences {
        let _ = writeln!(out, "{difference}");
        if let Difference::Changed(file) = difference {
            let old = std::fs::read_to_string(committed.join(file)).unwrap_or_default();
            out.push_str(&equation_changes(&old, &found.generated.files[file]));
        }
    }
    out
}
