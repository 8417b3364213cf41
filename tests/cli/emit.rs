//! `tripos emit`: the module of any model file, and what it leaves alone.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap().to_owned()
}

/// (exit status, standard output, standard error)
fn emit(model: &Path, out: &Path, more: &[&str]) -> (i32, String, String) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_tripos"));
    let command = command.arg("emit").arg(model).arg("--out").arg(out).args(more).current_dir(root());
    let Output { status, stdout, stderr } = command.output().unwrap();
    let text = |bytes| String::from_utf8(bytes).unwrap();
    (status.code().expect("ended by itself"), text(stdout), text(stderr))
}

fn files(folder: &Path) -> BTreeMap<String, String> {
    // The equations of scenes stand in a folder of their own.
    let entries = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap()).filter(|e| e.path().is_file());
    let text = |path: &Path| std::fs::read_to_string(path).unwrap();
    entries.map(|entry| (entry.file_name().into_string().unwrap(), text(&entry.path()))).collect()
}

/// A copy of a model of the library under another name, without its report.
fn pendulum(folder: &Path) -> PathBuf {
    let path = folder.join("swing.toml");
    std::fs::copy(root().join("models/pendulum/model.toml"), &path).unwrap();
    path
}

/// Goal: one text, whoever asks for it. Method: the module of each model of the library, its printed equations
/// included, against the committed one, file by file.
#[test]
fn a_module_is_what_regenerate_writes_but_for_its_origin() {
    let folder = tempfile::tempdir().unwrap();
    for name in ["disk", "pendulum"] {
        let out = folder.path().join(name);
        let (status, _, err) = emit(&root().join("models").join(name), &out, &[]);
        assert_eq!(status, 0, "{err}");
        let committed = files(&root().join("generated/src").join(name));
        let emitted = files(&out);
        assert_eq!(emitted.keys().collect::<Vec<_>>(), committed.keys().collect::<Vec<_>>());
        for (file, text) in &emitted {
            // A module for another crate has no scenes.
            let committed = committed[file].replace("#[rustfmt::skip]\npub mod scenes;\n", "");
            let committed = committed.replace("scenes: scenes::SCENES", "scenes: &[]");
            let committed = committed.replace("`models/", "`").replace("`tripos regenerate`", "`tripos emit`");
            assert_eq!(*text, committed, "{name}/{file}");
        }
    }
}

#[test]
fn only_the_formulations_asked_for_are_emitted_and_what_went_is_removed() {
    let folder = tempfile::tempdir().unwrap();
    let (model, out) = (pendulum(folder.path()), folder.path().join("swing"));
    let (status, said, err) = emit(&model, &out, &[]);
    assert!(status == 0 && err.contains("pub mod swing"), "{err}");
    assert_eq!(said, "written    kane.rs\nwritten    lagrange.rs\nwritten    mod.rs\nwritten    newton_euler.rs\n");
    let all = files(&out);
    assert!(all["kane.rs"].contains("Generated from `swing.toml`. Do not edit; run `tripos emit`."));

    std::fs::write(out.join("mine.rs"), "// Mine.\n").unwrap();
    let (status, said, _) = emit(&model, &out, &["--formulation", "kane"]);
    assert_eq!(status, 0);
    assert_eq!(said, "unchanged  kane.rs\nwritten    mod.rs\nremoved    lagrange.rs\nremoved    newton_euler.rs\n");
    let one = files(&out);
    assert_eq!(one.keys().collect::<Vec<_>>(), ["kane.rs", "mine.rs", "mod.rs"]);
    assert_eq!(one["kane.rs"], all["kane.rs"]);
    assert!(one["mod.rs"].contains("pub mod kane;") && !one["mod.rs"].contains("lagrange"), "{}", one["mod.rs"]);

    let (status, _, _) = emit(&model, &out, &["--formulation", "newton-euler", "--formulation", "lagrange"]);
    assert_eq!(status, 0);
    assert_eq!(files(&out).keys().collect::<Vec<_>>(), ["lagrange.rs", "mine.rs", "mod.rs", "newton_euler.rs"]);
}

#[test]
fn what_another_wrote_is_never_overwritten() {
    let folder = tempfile::tempdir().unwrap();
    let (model, out) = (pendulum(folder.path()), folder.path().join("swing"));
    // Text that mentions the header without having it, the committed equations, bytes that are no text, a folder.
    let mention = "//! Mine.\n\n/// Not //! Generated from `x`. Do not edit; run `tripos emit`.\nfn f() {}\n";
    let committed = std::fs::read(root().join("generated/src/pendulum/lagrange.rs")).unwrap();
    for text in [mention.as_bytes(), &committed, &[0xff, 0xfe]] {
        std::fs::create_dir_all(&out).unwrap();
        std::fs::write(out.join("lagrange.rs"), text).unwrap();
        let (status, said, err) = emit(&model, &out, &[]);
        assert!(status == 2 && said.is_empty(), "{said}");
        assert!(err.contains("lagrange.rs` is not a file that `tripos emit` wrote\nhelp: "), "{err}");
        assert_eq!(std::fs::read(out.join("lagrange.rs")).unwrap(), text);
        assert_eq!(std::fs::read_dir(&out).unwrap().count(), 1, "nothing is written if anything is refused");
    }
    std::fs::remove_file(out.join("lagrange.rs")).unwrap();
    std::fs::create_dir(out.join("lagrange.rs")).unwrap();
    assert_eq!(emit(&model, &out, &[]).0, 2);
}

#[test]
fn bad_requests_are_answered_with_what_to_do() {
    let folder = tempfile::tempdir().unwrap();
    let (model, out) = (pendulum(folder.path()), folder.path().join("swing"));
    let refused = |model: &Path, out: &Path, more: &[&str], part: &str| {
        let (status, said, err) = emit(model, out, more);
        assert!(status == 2 && said.is_empty() && err.contains("help: "), "{more:?}: {said}{err}");
        assert!(err.contains(part), "{part}: {err}");
    };
    refused(&model, &out, &["--formulation", "kan"], "did you mean `kane`?");
    refused(&model, &folder.path().join("a-b"), &[], "`a-b` cannot be a Rust module");
    refused(&model, Path::new("/"), &[], "has no name that a module could have");
    refused(&folder.path().join("none.toml"), &out, &[], "cannot read the file");
    refused(&model, &model.join("swing"), &[], "cannot write");
    let elbow = root().join("derive/tests/models/k06a.toml");
    refused(&elbow, &out, &["--formulation", "newton-euler"], "acts on a frame without a body");
    assert!(!out.exists(), "nothing was written");

    // Not asked for by name, what cannot be had is said and left out.
    let (status, said, err) = emit(&elbow, &out, &[]);
    assert_eq!((status, said.as_str()), (0, "written    kane.rs\nwritten    lagrange.rs\nwritten    mod.rs\n"));
    assert!(err.contains("not emitted: newton-euler is not possible: "), "{err}");
}

/// Goal: a module is Rust that compiles and gives the numbers of the command's own interpreter, in a crate that has
/// nothing but the traits. Method: the acceleration of the pendulum at 90°, which is −g/l.
#[test]
fn an_emitted_module_compiles_in_a_crate_of_its_own() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("src/swing");
    assert_eq!(emit(&pendulum(folder.path()), &out, &[]).0, 0);
    let traits = root().join("sim/traits");
    let manifest = format!(
        "[package]\nname = \"user\"\nversion = \"0.0.0\"\nedition = \"2024\"\n[workspace]\n[dependencies]\ntripos-traits = {{ path = '{}' }}\n",
        traits.display()
    );
    std::fs::write(folder.path().join("Cargo.toml"), manifest).unwrap();
    std::fs::copy(root().join("Cargo.lock"), folder.path().join("Cargo.lock")).unwrap();
    let main = "#[allow(non_snake_case)]\npub mod swing;\nfn main() {\n    let mut out = [0.0];\n    \
                let p: Vec<f64> = swing::PARAMETERS.iter().map(|name| if *name == \"l\" { 0.5 } else { 2.0 }).collect();\n    \
                let q = [std::f64::consts::FRAC_PI_2];\n    \
                tripos_traits::System::accelerations(&swing::kane::Kane, &p, &q, &[0.0], &mut out);\n    \
                println!(\"{}\", out[0]);\n}\n";
    std::fs::write(folder.path().join("src/main.rs"), main).unwrap();
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let mut run = Command::new(cargo);
    run.args(["run", "--quiet", "--offline"]).current_dir(folder.path());
    let done = run.env("CARGO_TARGET_DIR", folder.path().join("target")).output().unwrap();
    let err = String::from_utf8_lossy(&done.stderr).into_owned();
    assert!(done.status.success() && err.is_empty(), "no warnings either: {err}");
    assert_eq!(String::from_utf8_lossy(&done.stdout).trim(), "-4");
}
