//! `tripos regenerate`: the only writer of `generated/`.

use crate::catalogue::workspace_root;
use crate::failure::{Failure, print, status};
use std::fmt::Write;
use std::path::Path;
use tripos_codegen::workspace::{Difference, Freshness, freshness, write};

/// Says what differs; exit status 1 if anything does.
pub fn check() -> Result<u8, Failure> {
    let (found, committed) = look()?;
    print(&summary(&found, &committed))?;
    complain(&found)?;
    Ok(if found.differences.is_empty() { 0 } else { status::NO })
}

/// Writes what differs, and says what changed in the equations.
pub fn regenerate() -> Result<u8, Failure> {
    let (found, committed) = look()?;
    let text = summary(&found, &committed);
    write(&found, &committed).map_err(|error| Failure::Output(committed.display().to_string(), error))?;
    print(&text)?;
    complain(&found)?;
    Ok(0)
}

fn look() -> Result<(Freshness, std::path::PathBuf), Failure> {
    let root = workspace_root();
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

/// The equations that differ between two generated files, function by function.
fn equation_changes(old: &str, new: &str) -> String {
    let (old, new) = (equations(old), equations(new));
    let mut out = String::new();
    for (key, value) in &new {
        match old.iter().find(|(k, _)| k == key) {
            Some((_, before)) if before == value => {}
            Some((_, before)) => {
                let _ = writeln!(out, "    {key}\n      - {before}\n      + {value}");
            }
            None => {
                let _ = writeln!(out, "    {key}\n      + {value}");
            }
        }
    }
    for (key, before) in old.iter().filter(|(key, _)| !new.iter().any(|(k, _)| k == key)) {
        let _ = writeln!(out, "    {key}\n      - {before}");
    }
    if out.is_empty() { "    the equations are the same; only the text around them changed\n".to_owned() } else { out }
}

/// ("function: symbol", "value") for each equation that stands in a comment beside its line.
fn equations(text: &str) -> Vec<(String, String)> {
    let mut list: Vec<(String, String)> = Vec::new();
    let mut function = "";
    for line in text.lines() {
        if let Some(rest) = line.strip_prefix("pub fn ") {
            function = rest.split(['<', '(']).next().unwrap_or("");
        }
        let Some(comment) = line.trim_start().strip_prefix("// ") else { continue };
        if let (Some(continued), Some(last)) = (comment.strip_prefix("  "), list.last_mut()) {
            last.1.push(' ');
            last.1.push_str(continued);
        } else if let Some((symbol, value)) = comment.split_once(" = ") {
            list.push((format!("{function}: {symbol}"), value.to_owned()));
        }
    }
    list
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_changed_term_is_named_by_function_and_entry() {
        let old = "pub fn forcing<S>(\n    // f1 = -M*g\n    let f1 = 0;\n    // f2 = long\n    //   formula\n";
        let new = "pub fn forcing<S>(\n    // f1 = M*g\n    let f1 = 0;\n    // f2 = long\n    //   formula\n";
        assert_eq!(equation_changes(old, new), "    forcing: f1\n      - -M*g\n      + M*g\n");
        assert!(equation_changes(old, old).contains("the same"));
        assert_eq!(equations(old)[1].1, "long formula");
    }
}
