//! An edited model takes effect on the very next `cargo run`, and the tests fail until it is committed.
//!
//! Works in a copy of the workspace with its own target folder, offline, on the crates that are already
//! here; nothing of this checkout is touched.

#![allow(clippy::float_cmp, reason = "the same equations give the same bits")]

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap().to_owned()
}

fn copy(from: &Path, to: &Path) {
    std::fs::create_dir_all(to).unwrap();
    for entry in std::fs::read_dir(from).unwrap() {
        let entry = entry.unwrap();
        let (path, name) = (entry.path(), entry.file_name());
        if name == "target" || name.to_string_lossy().starts_with(".git") {
            continue;
        }
        if path.is_dir() {
            copy(&path, &to.join(name));
        } else {
            std::fs::copy(&path, to.join(name)).unwrap();
        }
    }
}

struct Workspace(tempfile::TempDir);

impl Workspace {
    fn new() -> Self {
        let folder = tempfile::tempdir_in(root().join("target")).unwrap();
        copy(&root(), folder.path());
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

    fn cargo(&self, arguments: &[&str]) -> Output {
        Command::new(env!("CARGO"))
            .args(arguments)
            .current_dir(self.0.path())
            .env("CARGO_TARGET_DIR", root().join("target/edited"))
            // The same on every machine: no Python, so no reference is renewed.
            .env("TRIPOS_PYTHON", "/no/such/python")
            .env_remove("CARGO_MANIFEST_DIR")
            .output()
            .unwrap()
    }

    fn tripos(&self, arguments: &[&str]) -> Output {
        self.cargo(&[&["run", "--quiet", "--offline", "--"], arguments].concat())
    }

    fn final_lean(&self) -> f64 {
        let output = self.tripos(&["simulate", "models/disk/scenes/report.toml", "--json", "--rtol", "1e-9"]);
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let run: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
        assert_eq!(run["compiled"], true, "compiled code runs the edited text");
        run["state"]["q2"].as_f64().unwrap()
    }
}

#[test]
fn an_edited_model_runs_at_once_and_is_stale_until_regenerated() {
    let workspace = Workspace::new();
    let before = workspace.final_lean();

    // A ring instead of a disk: another inertia, another motion, on the next run.
    let (disk, ring) = ("[\"M*R^2/4\", \"M*R^2/4\", \"M*R^2/2\"]", "[\"M*R^2/2\", \"M*R^2/2\", \"M*R^2\"]");
    workspace.edit("models/disk/model.toml", disk, ring);
    let after = workspace.final_lean();
    assert!((after - before).abs() > 0.01, "the edit changed the motion: {before} and {after}");

    let check = workspace.tripos(&["regenerate", "--check"]);
    assert_eq!(check.status.code(), Some(1), "stale text is the answer \"no\"");
    let text = String::from_utf8(check.stdout).unwrap();
    assert!(text.contains("mass_matrix: M33") && text.contains("- M*R^2/2") && text.contains("+ M*R^2"), "{text}");

    let regenerate = workspace.tripos(&["regenerate"]);
    assert!(regenerate.status.success());
    let warning = String::from_utf8(regenerate.stderr).unwrap();
    assert!(warning.contains("was not renewed: `/no/such/python` cannot be run"), "{warning}");
    let check = workspace.tripos(&["regenerate", "--check"]);
    let text = String::from_utf8(check.stdout).unwrap();
    let stale = "\nstale    models/disk/reference.json: it is of another model text\n";
    assert!(text.starts_with("generated/ is fresh: ") && text.ends_with(stale), "SymPy has not seen them: {text}");
    assert_eq!(workspace.final_lean(), after, "the same equations, now committed");

    // A broken model breaks neither the build nor the other models.
    workspace.edit("models/chaotic_pendulum/model.toml", "omega = \"theta'\"", "omega = \"thetta'\"");
    assert_eq!(workspace.final_lean(), after);
    let broken = workspace.tripos(&["derive", "models/chaotic_pendulum"]);
    assert_eq!(broken.status.code(), Some(2));
    let message = String::from_utf8(broken.stderr).unwrap();
    assert!(message.contains("did you mean `theta'`?"), "{message}");

    // A new model folder is compiled in without another command.
    copy(&workspace.path("models/cart_pendulum_3"), &workspace.path("models/second_cart"));
    workspace.edit("models/second_cart/model.toml", "0.87", "0.88");
    let run = workspace.tripos(&["simulate", "models/second_cart/scenes/fall.toml", "--json"]);
    let run: serde_json::Value = serde_json::from_slice(&run.stdout).unwrap();
    assert_eq!(run["compiled"], true);

    // Names, angles and constants that a generator gets wrong first: compiled as interpreted.
    copy(&root().join("tests/data/awkward"), &workspace.path("models/awkward"));
    let scene = workspace.path("models/awkward/scenes/run.toml");
    let outside = tempfile::tempdir().unwrap();
    copy(&workspace.path("models/awkward"), outside.path());
    let text = std::fs::read_to_string(outside.path().join("model.toml")).unwrap();
    std::fs::write(outside.path().join("model.toml"), format!("# another text\n{text}")).unwrap();
    for by in ["kane", "lagrange"] {
        let run = |scene: &Path| {
            let output = workspace.tripos(&["simulate", scene.to_str().unwrap(), "--by", by, "--json"]);
            assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
            serde_json::from_slice::<serde_json::Value>(&output.stdout).unwrap()
        };
        let (compiled, interpreted) = (run(&scene), run(&outside.path().join("scenes/run.toml")));
        assert_eq!((&compiled["compiled"], &interpreted["compiled"]), (&true.into(), &false.into()));
        for (name, value) in compiled["state"].as_object().unwrap() {
            let difference = value.as_f64().unwrap() - interpreted["state"][name].as_f64().unwrap();
            assert!(difference.abs() < 1e-9, "{by}: {name} differs by {difference:e}");
        }
    }
}
