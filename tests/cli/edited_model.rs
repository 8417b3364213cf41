//! An edited model takes effect at once, interpreted, and is stale until it is regenerated.
//!
//! Works in a copy of what the command finds of a workspace; nothing of this checkout is touched, and nothing is built.

use crate::support::{copy, root, tripos_in};
use serde_json::Value;
use std::path::PathBuf;

/// `models` and `generated`, as a checkout has them.
struct Workspace(tempfile::TempDir);

impl Workspace {
    fn new() -> Self {
        let folder = tempfile::tempdir().unwrap();
        for part in ["models", "generated"] {
            copy(&root().join(part), &folder.path().join(part));
        }
        Self(folder)
    }

    fn path(&self, file: &str) -> PathBuf {
        self.0.path().join(file)
    }

    fn edit(&self, file: &str, from: &str, to: &str) {
        let text = std::fs::read_to_string(self.path(file)).unwrap();
        assert!(text.contains(from), "{file} has {from}");
        std::fs::write(self.path(file), text.replace(from, to)).unwrap();
    }

    fn tripos(&self, arguments: &[&str]) -> (i32, String, String) {
        tripos_in(self.0.path(), arguments)
    }

    /// The last lean of the report's run, whether compiled equations gave it, and what was said.
    fn final_lean(&self) -> (f64, bool, String) {
        let (status, out, err) =
            self.tripos(&["simulate", "models/disk/scenes/report.toml", "--json", "--rtol", "1e-9", "--by", "kane"]);
        assert_eq!(status, 0, "{err}");
        let run: Value = serde_json::from_str(&out).unwrap();
        (run["state"]["q2"].as_f64().unwrap(), run["compiled"].as_bool().unwrap(), err)
    }
}

#[test]
fn an_edited_model_runs_at_once_and_is_stale_until_regenerated() {
    let workspace = Workspace::new();
    let (before, compiled, said) = workspace.final_lean();
    assert!(compiled && said.is_empty(), "{said}");
    let (status, out, err) = workspace.tripos(&["regenerate", "--check", "disk"]);
    assert!(status == 0 && out == "generated/ is fresh: 1 model\n", "{out}{err}");

    // A ring instead of a disk: another inertia, another motion, on the next run.
    let (disk, ring) = ("[\"M*R^2/4\", \"M*R^2/4\", \"M*R^2/2\"]", "[\"M*R^2/2\", \"M*R^2/2\", \"M*R^2\"]");
    workspace.edit("models/disk/model.toml", disk, ring);
    let (after, compiled, said) = workspace.final_lean();
    assert!((after - before).abs() > 0.01, "the edit changed the motion: {before} and {after}");
    assert!(!compiled && said.contains("of another text") && said.contains("`tripos regenerate disk`"), "{said}");

    let (status, out, _) = workspace.tripos(&["regenerate", "--check", "models/disk"]);
    assert_eq!(status, 1, "stale text is the answer \"no\"");
    assert!(out.contains("  kane M[u3, u3']: new - old = M*R^2/2\n"), "{out}");

    let others = std::fs::read_to_string(workspace.path("generated/src/pendulum/kane.rs")).unwrap();
    // A copy has no script for SymPy: no reference is renewed, on any machine.
    let (status, _, said) = workspace.tripos(&["regenerate", "disk"]);
    assert!(
        status == 0 && (said.contains("of 1 model was not renewed: ") || said.contains("of disk was not")),
        "{said}"
    );
    assert_eq!(std::fs::read_to_string(workspace.path("generated/src/pendulum/kane.rs")).unwrap(), others);
    let (_, out, _) = workspace.tripos(&["regenerate", "--check", "disk"]);
    let stale = "stale    models/disk/reference.json: the file was made from another model text\n";
    assert_eq!(out, format!("generated/ is fresh: 1 model\n{stale}"), "SymPy has not seen them");
    let (again, compiled, _) = workspace.final_lean();
    assert!(!compiled && again.to_bits() == after.to_bits(), "compiled by the next build, not before");

    // A broken model breaks no other.
    workspace.edit("models/chaotic_pendulum/model.toml", "omega = \"theta'\"", "omega = \"thetta'\"");
    assert_eq!(workspace.final_lean().0.to_bits(), after.to_bits());
    let (status, _, err) = workspace.tripos(&["derive", "models/chaotic_pendulum"]);
    assert!(status == 2 && err.contains("did you mean `theta'`?"), "{err}");

    // A new model is generated like any other, and none that is not there.
    copy(&workspace.path("models/pendulum"), &workspace.path("models/second"));
    let (status, out, err) = workspace.tripos(&["regenerate", "second"]);
    assert!(status == 0 && out.contains("missing  second/kane.rs") && out.contains("changed  lib.rs"), "{out}{err}");
    let library = std::fs::read_to_string(workspace.path("generated/src/lib.rs")).unwrap();
    assert!(library.contains("pub mod second;") && library.contains("pub mod disk;"), "{library}");
    let (status, _, err) = workspace.tripos(&["regenerate", "secnd"]);
    assert!(
        status == 2 && err.contains("there is no model `secnd`") && err.contains("did you mean `second`?"),
        "{err}"
    );
}
