//! The arrows of the design: who may know whom.

use std::path::{Path, PathBuf};

fn sources(folder: &str) -> Vec<(PathBuf, String)> {
    let mut files = Vec::new();
    let mut folders = vec![Path::new(env!("CARGO_MANIFEST_DIR")).join(folder)];
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|e| e == "rs") {
                let text = std::fs::read_to_string(&path).unwrap();
                files.push((path, text));
            }
        }
    }
    assert!(!files.is_empty(), "{folder} has sources");
    files
}

/// No file under `folder` mentions any of `words`.
fn knows_nothing_of(folder: &str, words: &[&str]) {
    for (path, text) in sources(folder) {
        for word in words {
            assert!(!text.contains(word), "{} mentions {word}", path.display());
        }
    }
}

#[test]
fn derive_depends_on_the_traits_alone() {
    knows_nothing_of("derive/src", &["tripos_codegen", "tripos_sim", "tripos_models", "tripos::"]);
}

/// What is proved, and what is zero, is never asked of rounded numbers, however many digits they have.
#[test]
fn no_verdict_reads_a_double_double() {
    for (path, text) in sources("derive/src") {
        let may = ["derive/src/scene", "derive/src/algebra/evaluate.rs", "derive/src/algebra/exact.rs"];
        let says = text.contains("DoubleDouble") && !may.iter().any(|place| path.to_string_lossy().contains(place));
        assert!(!says, "{} mentions DoubleDouble", path.display());
    }
}

#[test]
fn the_algebra_knows_no_mechanics() {
    knows_nothing_of("derive/src/algebra", &["crate::model", "crate::mechanics", "crate::scene"]);
}

#[test]
fn formulations_never_import_one_another() {
    let others = |own: &str| -> Vec<String> {
        ["kane", "lagrange", "newton_euler"].iter().filter(|m| **m != own).map(|m| format!("super::{m}")).collect()
    };
    for own in ["kane", "lagrange", "newton_euler"] {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("derive/src/mechanics/{own}.rs"));
        let text = std::fs::read_to_string(path).unwrap();
        for other in others(own) {
            assert!(!text.contains(&other), "{own} imports {other}");
        }
    }
}

#[test]
fn generated_code_knows_only_the_traits() {
    knows_nothing_of("generated/src", &["tripos_derive", "tripos_codegen", "tripos_sim::", "nalgebra", "std::"]);
}

#[test]
fn sim_knows_neither_models_nor_derivation() {
    knows_nothing_of("sim/src", &["tripos_derive", "tripos_codegen", "tripos_models", "tripos::", "model.toml"]);
    knows_nothing_of("sim/traits/src", &["tripos_derive", "tripos_codegen", "tripos_sim", "std::"]);
}

#[test]
fn the_library_knows_neither_generated_code_nor_the_command() {
    let command =
        ["tripos_models", "tripos_cli", "clap", "indicatif", "plotters", "println!", "eprintln!", "process::exit"];
    for (path, text) in sources("run/src") {
        let code: String = text.lines().filter(|line| !line.trim_start().starts_with("//")).collect();
        for word in command {
            assert!(!code.contains(word), "{} mentions {word}", path.display());
        }
    }
}

#[test]
fn codegen_knows_only_derive() {
    knows_nothing_of("codegen/src", &["tripos_sim", "tripos_models", "tripos::"]);
}

/// A plan is for any target, and the library that runs scenes needs none: what writes Rust is the command's alone.
#[test]
fn plans_know_no_language() {
    for folder in ["codegen/src/plan", "codegen/src/taylor"] {
        knows_nothing_of(
            folder,
            &["crate::rust", "proc_macro2", "quote::", "quote!", "syn::", "TokenStream", "prettyplease"],
        );
    }
    let arguments = ["tree", "--package", "tripos", "--edges", "normal", "--prefix", "none", "--offline"];
    let tree = std::process::Command::new(env!("CARGO")).args(arguments).output().unwrap();
    let tree = String::from_utf8(tree.stdout).unwrap();
    assert!(tree.contains("tripos-codegen"), "{tree}");
    assert!(!tree.contains("prettyplease") && !tree.contains("tempfile"), "{tree}");
}
