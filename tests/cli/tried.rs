//! Models and publications with which testers found defects: each kind stays mended.

use crate::left_out::is_left_out;
use crate::support::{root, tripos_in};
use std::path::{Path, PathBuf};
use std::process::Command;

/// Model of the folder `tests/cli/tried`.
fn model(name: &str) -> PathBuf {
    root().join("tests/cli/tried").join(name).with_extension("toml")
}

/// Status, standard output and standard error of `tripos emit --language c` for these arguments.
fn emit_c(from: &Path, out: &Path, more: &[&str]) -> (i32, String, String) {
    let arguments = ["emit", from.to_str().unwrap(), "--language", "c", "--out", out.to_str().unwrap()];
    tripos_in(&root(), &[&arguments[..], more].concat())
}

/// Compiles all C of a folder without a warning.
fn compile(folder: &Path) {
    let sources = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let sources: Vec<PathBuf> = sources.filter(|path| path.extension().is_some_and(|end| end == "c")).collect();
    let strict = ["-std=c99", "-Wall", "-Wextra", "-Werror", "-pedantic", "-fsyntax-only"];
    let output = Command::new("gcc").args(strict).args(sources).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
}

fn has_gcc() -> bool {
    Command::new("gcc").arg("--version").output().is_ok_and(|output| output.status.success())
}

/// Goal: each variable is defined once, before it is read. Method: an input with a formula beside an output that is an
/// acceleration; an angle w t that is shared inside another; both as C.
#[test]
fn variables_of_emitted_code_are_defined_once_and_before_their_use() {
    if is_left_out("gcc", has_gcc(), "there is no gcc") {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let scene = folder.path().join("run.toml");
    let text = "span = [0, 3]\noutputs = [\"x\", { name = \"a_\", value = \"v'\" }]\n[inputs]\nF = \"3*sin(2*t) + x\"\n\
                [start]\nx = 0.1\nv = 0\n";
    std::fs::write(&scene, format!("model = \"{}\"\n{text}", model("pushed_mass").display())).unwrap();
    for (from, name) in [(scene, "outputs"), (model("driven_sled"), "slopes")] {
        let out = folder.path().join(name);
        let (status, _, err) = emit_c(&from, &out, &[]);
        assert_eq!(status, 0, "{err}");
        compile(&out);
    }
}

/// Goal: nothing that ends a run is lost without a word. Method: a block whose domain is a condition on a reaction.
#[test]
fn a_condition_on_a_reaction_is_named_where_no_function_checks_it() {
    let folder = tempfile::tempdir().unwrap();
    let block = model("pressed_block");
    let (status, _, err) = emit_c(&block, &folder.path().join("c"), &["--formulation", "kane"]);
    assert!(status == 0 && err.contains("`contact` is left out"), "{err}");
    let header = std::fs::read_to_string(folder.path().join("c/pressed_block_kane.h")).unwrap();
    let header = header.replace("\n// ", " ");
    assert!(header.contains("No function checks the condition contact (Nz > 0)"), "{header}");
    let scene = folder.path().join("run.toml");
    let text = "span = [0, 1]\noutputs = [\"x\"]\n[start]\nx = 0\nv = 0\n";
    std::fs::write(&scene, format!("model = \"{}\"\n{text}", block.display())).unwrap();
    let unit = folder.path().join("unit.fmu");
    let arguments = ["fmu", scene.to_str().unwrap(), "--out", unit.to_str().unwrap(), "--only-sources"];
    let (status, _, err) = tripos_in(&root(), &arguments);
    assert!(status == 0 && err.contains("`contact` is left out"), "{err}");
}

/// A scene goes to languages that have outputs; for the others one sentence says so.
#[test]
fn a_scene_is_refused_in_rust_in_one_sentence() {
    let folder = tempfile::tempdir().unwrap();
    let scene = root().join("models/furuta/scenes/swing.toml");
    let arguments = ["emit", scene.to_str().unwrap(), "--out", folder.path().to_str().unwrap()];
    let (status, _, err) = tripos_in(&root(), &arguments);
    assert!(status == 2 && err.matches("error").count() == 1 && err.contains("help: give the model file"), "{err}");
}

/// Status and text of the judgement of a publication.
fn judged(name: &str, publication: &str) -> (i32, String) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("publication.toml");
    std::fs::write(&path, format!("title = \"t\"\nsource = \"s\"\n{publication}")).unwrap();
    let model = model(name);
    let arguments = ["diff", model.to_str().unwrap(), path.to_str().unwrap()];
    let (status, text, err) = tripos_in(folder.path(), &arguments);
    (status, text + &err)
}

/// Goal: two mistakes in abbreviations are named, and never end the program. Method: a platform on a leg whose row
/// takes the wrong one of two abbreviations under a root.
#[test]
fn two_mistakes_through_abbreviations_are_judged() {
    let text = "[abbreviations]\nl1 = \"sqrt(x^2+y^2+a^2-2*a*(x*cos(phi)+y*sin(phi)))\"\nJ1x = \"(x-a*cos(phi))/l1\"\n\
                J1y = \"(y-a*sin(phi))/l1\"\nJ1p = \"a*(x*sin(phi)-y*cos(phi))/l1\"\n[[system]]\nid = \"eq\"\n\
                section = \"1\"\nformulation = \"lagrange\"\nequations = [\"m*y'' = J1x*f1 - m*g\"]\n";
    let (status, said) = judged("platform", text);
    assert!(status == 1 && said.contains("different"), "{said}");
    let (status, said) = judged("platform", &text.replace("J1x*f1 - m*g", "J1y*f1 - m*g"));
    assert!(status == 0, "{said}");
}

/// Goal: the equations of a text beside their constraints are right. Method: a pendulum in x and y by a multiplier,
/// with its constraint as the third row, as an equation of positions, of rates or of accelerations; then with a wrong
/// constraint.
#[test]
fn a_constraint_stands_among_the_equations_of_motion() {
    let system = |constraint: &str| {
        judged(
            "rod_pendulum",
            &format!(
                "[[system]]\nid = \"s\"\nsection = \"1\"\nformulation = \"lagrange\"\n\
                 equations = [\"m*x'' = -2*lambda_rod*x\", \"m*y'' = -m*g - 2*lambda_rod*y\", \"{constraint}\"]\n"
            ),
        )
    };
    for constraint in ["x^2 + y^2 = l^2", "x*x' + y*y' = 0", "x*x'' + y*y'' + x'^2 + y'^2 = 0"] {
        let (status, said) = system(constraint);
        assert!(status == 0 && !said.contains("does not determine"), "{constraint}: {said}");
    }
    // The last is an identity, which stands in the place of an equation of the mechanism.
    for constraint in ["x^2 + 2*y^2 = l^2", "x*x' - y*y' = 0", "m*g*(sin(x/l)^2 + cos(x/l)^2) = m*g"] {
        let (status, said) = system(constraint);
        assert!(status == 1 && said.contains("different"), "{constraint}: {said}");
    }
}
