//! A changed force is a changed line: what one more force on the disk does to the equations' files, and what is said of
//! it.

use crate::support::{copy, root, tripos_in};
use std::collections::HashMap;
use std::path::Path;

/// A copy of the disk, with everything that is generated of it.
fn workspace() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    for part in ["models/disk", "generated/src/disk"] {
        copy(&root().join(part), &folder.path().join(part));
    }
    std::fs::remove_file(folder.path().join("models/disk/reference.json")).unwrap();
    folder
}

/// Viscous drag along a1 on the material of the disk at the contact.
fn add_drag(folder: &Path) {
    let model = folder.join("models/disk/model.toml");
    let text = std::fs::read_to_string(&model).unwrap();
    let (parameter, force) = ("c = { unit = \"kg/s\", value = 0.1, about = \"viscous drag\" }\n", "-c*u4");
    let text = text.replace("\ng = { unit", &format!("\n{parameter}g = {{ unit"));
    let drag = format!("[forces.drag]\non = \"disk\"\nat = \"P\"\nframe = \"A\"\nvector = [\"{force}\", 0, 0]\n\n");
    std::fs::write(model, text.replace("[reactions.N]", &format!("{drag}[reactions.N]"))).unwrap();
}

/// The lines of all files of equations, and how often each stands there.
fn lines(folder: &Path) -> HashMap<String, i64> {
    let mut counts = HashMap::new();
    for entry in std::fs::read_dir(folder.join("generated/src/disk")).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_some_and(|extension| extension == "rs") {
            for line in std::fs::read_to_string(&path).unwrap().lines() {
                *counts.entry(format!("{}: {line}", path.display())).or_default() += 1;
            }
        }
    }
    counts
}

/// Goal: after an edit of a force its effect is reported. Method: one component of a force at the contact, which takes
/// energy, so that two formulations get a power, too; the lines that differ in the files of equations are counted, and
/// the words of `--check` about them stand here.
#[test]
fn one_more_force_is_a_few_lines_in_the_equations_and_in_what_is_said_of_them() {
    let folder = workspace();
    let before = lines(folder.path());
    add_drag(folder.path());
    let (status, said, err) = tripos_in(folder.path(), &["regenerate", "--check", "disk"]);
    assert_eq!(status, 1, "{err}");
    assert!(said.lines().count() <= 40, "{said}");
    for line in [
        "changed  disk/kane.rs\n",
        "missing  lib.rs\n",
        "disk: equations of motion: ",
        "  kane f[u2]: new - old = R*c*u4*cos(q1)*tan(q2)\n",
        "  kane f[u4]: new - old = -c*u4\n",
        "  lagrange f[q4]: new - old = -c*q4'\n",
        "and the code of these equations, 16 files under `code`\n",
    ] {
        assert!(said.contains(line), "{line}{said}");
    }

    assert_eq!(tripos_in(folder.path(), &["regenerate", "disk"]).0, 0);
    let after = lines(folder.path());
    let times = |counts: &HashMap<String, i64>, line: &str| counts.get(line).copied().unwrap_or(0);
    let removed: i64 = before.iter().map(|(line, count)| (count - times(&after, line)).max(0)).sum();
    let added: i64 = after.iter().map(|(line, count)| (count - times(&before, line)).max(0)).sum();
    assert!(added > 0 && removed + added <= 90, "{removed} lines removed, {added} added");
}

/// The drag works in a motion by printed equations, too, though these do not have it.
#[test]
fn printed_equations_state_the_power_of_what_acts_on_the_model() {
    let folder = workspace();
    add_drag(folder.path());
    let state = "[state]\nq1 = 0.1\nq2 = 0.2\nq3 = 0.3\nq4 = 0.4\nq5 = 0.5\nu1 = 1\nu2 = 2\nu3 = 3\nu4 = 4\nu5 = 5\n";
    std::fs::write(folder.path().join("state.toml"), state).unwrap();
    let power = |by: &str| {
        let (status, out, err) =
            tripos_in(folder.path(), &["evaluate", "models/disk", "--by", by, "--at", "state.toml", "--json"]);
        assert_eq!(status, 0, "{by}: {err}");
        serde_json::from_str::<serde_json::Value>(&out).unwrap()["power"].as_f64().unwrap()
    };
    // −c u4 (u4 + R cos q1 (u3 − u2 tan q2)), with c = 0.1 and R = 1.
    let exact = -0.1 * 4.0 * (4.0 + 0.1_f64.cos() * (3.0 - 2.0 * 0.2_f64.tan()));
    for by in ["kane", "lagrange", "newton-euler", "printed:kane-final", "printed:lagrange-final"] {
        assert!((power(by) - exact).abs() < 1e-12, "{by}: {} for {exact}", power(by));
    }
}
