//! `tripos regenerate` and the references beside the models, with a Python that only pretends: what it would say is
//! given.

#![cfg(unix)]

use crate::support::root;
use std::path::PathBuf;
use std::process::{Command, Output};

/// A workspace with one model, and beside it a `python` that answers with the file `answer.json`.
struct Workspace(tempfile::TempDir);

impl Workspace {
    fn new() -> Self {
        let workspace = Self(tempfile::tempdir().unwrap());
        for folder in ["models/disk", "generated/src", "tests/sympy"] {
            std::fs::create_dir_all(workspace.path(folder)).unwrap();
        }
        let scripts = ["reference.py", "grammar.py", "mechanism.py", "model_file.py", "requirements.txt"];
        let scripts = scripts.map(|name| format!("tests/sympy/{name}"));
        for file in scripts.iter().map(String::as_str).chain(["models/disk/model.toml"]) {
            std::fs::copy(root().join(file), workspace.path(file)).unwrap();
        }
        workspace.python("case $1 in -c) echo 1.14.0;; *) cat answer.json;; esac");
        workspace.answer(&recorded());
        workspace
    }

    fn path(&self, file: &str) -> PathBuf {
        self.0.path().join(file)
    }

    /// Written by another process: a file that this one holds open, if only for a thread that is about to start a
    /// program, cannot be run.
    fn python(&self, script: &str) {
        let write = "printf '#!/bin/sh\\n%s\\n' \"$1\" > \"$2\" && chmod +x \"$2\"";
        let written = Command::new("sh").args(["-c", write, "sh", script]).arg(self.path("python")).status();
        assert!(written.unwrap().success());
    }

    fn answer(&self, text: &str) {
        std::fs::write(self.path("answer.json"), text).unwrap();
    }

    fn reference(&self) -> Option<String> {
        std::fs::read_to_string(self.path("models/disk/reference.json")).ok()
    }

    /// (exit status, standard output, standard error)
    fn regenerate(&self, arguments: &[&str]) -> (i32, String, String) {
        let Output { status, stdout, stderr } = Command::new(env!("CARGO_BIN_EXE_tripos"))
            .arg("regenerate")
            .args(arguments)
            .current_dir(self.0.path())
            .env("TRIPOS_PYTHON", self.path("python"))
            .output()
            .unwrap();
        let text = |bytes| String::from_utf8(bytes).unwrap();
        (status.code().expect("ended by itself"), text(stdout), text(stderr))
    }
}

fn recorded() -> String {
    std::fs::read_to_string(root().join("models/disk/reference.json")).unwrap()
}

#[test]
fn a_reference_that_agrees_is_recorded_once() {
    let workspace = Workspace::new();
    let (status, out, _) = workspace.regenerate(&["--check"]);
    assert!(status == 1 && out.contains("missing  models/disk/reference.json"), "{out}");
    let (status, out, err) = workspace.regenerate(&[]);
    assert!(status == 0 && out.ends_with(" entries; reference recorded\n"), "{out}{err}");
    assert_eq!(workspace.reference(), Some(recorded()), "byte by byte");
    let (status, out, _) = workspace.regenerate(&[]);
    assert!(status == 0 && out.contains("disk: SymPy agrees in ") && out.ends_with(" entries\n"), "{out}");
    assert_eq!(workspace.regenerate(&["--check"]).0, 0);
}

#[test]
fn a_disagreement_is_shown_and_not_recorded() {
    let workspace = Workspace::new();
    // The first matrix is Kane's.
    let (entry, changed) = ("\"matrix\": [\n   [\n    \"", "\"matrix\": [\n   [\n    \"-");
    assert!(recorded().contains(entry));
    workspace.answer(&recorded().replacen(entry, changed, 1));
    let (status, out, err) = workspace.regenerate(&[]);
    assert_eq!(status, 1, "{out}{err}");
    assert!(out.contains("disk: SymPy DISAGREES in 1 of "), "{out}");
    for part in [
        " entries; the reference is not recorded\n",
        "\n  kane matrix[1,1]\n",
        "\n    derived     ",
        "\n    SymPy       ",
        "\n    witness     ",
    ] {
        assert!(out.contains(part), "{part}: {out}");
    }
    assert_eq!(workspace.reference(), None);

    workspace.answer("{\"model\": \"disk\"}");
    let (status, out, _) = workspace.regenerate(&[]);
    assert!(status == 1 && out.contains("cannot be compared") && out.contains("`kane` must be an object"), "{out}");
}

/// Without Python the equations are written all the same, and nothing is passed over in silence.
#[test]
fn what_is_not_renewed_is_said_and_found_by_check() {
    let workspace = Workspace::new();
    let not_renewed = |script: &str, why: &str| {
        workspace.python(script);
        let (status, out, err) = workspace.regenerate(&[]);
        assert_eq!(status, 0, "{out}{err}");
        assert!(err.contains("was not renewed: ") && err.contains(why), "{why}: {err}");
        assert_eq!(workspace.reference(), None);
    };
    not_renewed("echo \"ModuleNotFoundError: No module named 'sympy'\" >&2; exit 1", "No module named 'sympy'");
    not_renewed("echo 1.12", "has SymPy 1.12, not 1.14.0");
    not_renewed("case $1 in -c) echo 1.14.0;; *) echo 'not supported' >&2; exit 2;; esac", "not supported");
    std::fs::remove_file(workspace.path("python")).unwrap();
    let (status, _, err) = workspace.regenerate(&[]);
    assert!(
        status == 0 && err.contains("reference of 1 model was not renewed: ") && err.contains("cannot be run"),
        "{err}"
    );
    assert!(workspace.path("generated/src/disk/kane.rs").is_file(), "the equations are written");

    // A comment is another text: what was derived from the text before is no reference of it.
    std::fs::write(workspace.path("models/disk/reference.json"), recorded()).unwrap();
    assert_eq!(workspace.regenerate(&["--check"]).0, 0, "no Python is needed");
    let text = std::fs::read_to_string(workspace.path("models/disk/model.toml")).unwrap();
    std::fs::write(workspace.path("models/disk/model.toml"), format!("# A comment.\n{text}")).unwrap();
    let (status, out, _) = workspace.regenerate(&["--check"]);
    assert!(
        status == 1 && out.contains("stale    models/disk/reference.json: the file was made from another model text"),
        "{out}"
    );
    std::fs::write(workspace.path("models/disk/reference.json"), "[]").unwrap();
    let (status, out, _) = workspace.regenerate(&["--check"]);
    assert!(status == 1 && out.contains("broken   models/disk/reference.json: "), "{out}");
}

/// Goal: an edit is told by its effect on equations whose terms stand by names. Method: the governor, whose equations
/// are code alone, with the acceleration of free fall doubled, which changes V and every force and no mass; and a
/// comment, which changes nothing.
#[test]
fn changed_equations_in_named_terms_are_told() {
    let folder = tempfile::tempdir().unwrap();
    let path = |file: &str| folder.path().join(file);
    std::fs::create_dir_all(path("models/governor")).unwrap();
    std::fs::create_dir_all(path("generated/src")).unwrap();
    let text = std::fs::read_to_string(root().join("models/governor/model.toml")).unwrap();
    let regenerate = |arguments: &[&str]| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_tripos"));
        let output = command.arg("regenerate").args(arguments).current_dir(folder.path()).env("TRIPOS_PYTHON", "none");
        String::from_utf8(output.output().unwrap().stdout).unwrap()
    };
    std::fs::write(path("models/governor/model.toml"), &text).unwrap();
    regenerate(&["governor"]);
    let doubled = text.replace("\"-g\"", "\"-2*g\"");
    assert_ne!(doubled, text);
    std::fs::write(path("models/governor/model.toml"), doubled).unwrap();
    let said = regenerate(&["--check", "governor"]);
    assert!(said.contains("governor: equations of motion: ") && said.contains(" changed\n"), "{said}");
    assert!(said.contains("  V: new - old = ") && said.contains("  kane f[opening]: "), "{said}");
    assert!(!said.contains(" M[") && !said.contains("the same equations"), "{said}");
    std::fs::write(path("models/governor/model.toml"), format!("# A comment.\n{text}")).unwrap();
    let said = regenerate(&["--check", "governor"]);
    assert!(!said.contains("entries changed") && !said.contains("is not known"), "{said}");
}
