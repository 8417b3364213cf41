//! `tripos prove --certificate`: programs that share no code with Tripos accept true certificates and refuse others.

use crate::left_out::is_left_out;
use crate::support::{command, root, tripos_in};
use std::path::{Path, PathBuf};
use std::process::Command;

/// Runs a program of `tests/certificate` with Python. Returns whether it ended with status 0, and what it printed.
fn run_checker(program: &str, arguments: &[&str]) -> (bool, String) {
    let output = Command::new(python()).arg(root().join("tests/certificate").join(program)).args(arguments).output();
    let output = output.unwrap();
    let text = [output.stdout, output.stderr].concat();
    (output.status.success(), String::from_utf8_lossy(&text).into_owned())
}

/// The Python with which checkers run.
fn python() -> std::ffi::OsString {
    std::env::var_os("TRIPOS_PYTHON").filter(|p| !p.is_empty()).unwrap_or_else(|| "python3".into())
}

/// True if there is no Python 3.11; the test is then left out and counted.
fn is_without_python() -> bool {
    let found = Command::new(python()).args(["-c", "import tomllib"]).output().is_ok_and(|run| run.status.success());
    is_left_out("python", found, "certificates are checked by Python 3.11 or newer")
}

/// Writes the certificate of a model into a folder, and returns its path.
fn certificate(folder: &Path, model: &str) -> String {
    let path = folder.join(format!("{}.cert", model.replace('/', "_")));
    let output = command(&root(), &["prove", model, "--certificate"]).arg(&path).output().unwrap();
    assert!(output.status.success(), "{model}: {}", String::from_utf8_lossy(&output.stderr));
    path.to_str().unwrap().to_owned()
}

/// Lists the folders in a folder of the workspace that have a model.
fn models_in(folder: &str) -> Vec<String> {
    let entries = std::fs::read_dir(root().join(folder)).unwrap().map(|entry| entry.unwrap().path());
    let models = entries.filter(|path: &PathBuf| path.join("model.toml").is_file());
    let mut names: Vec<String> =
        models.map(|path| format!("{folder}/{}", path.file_name().unwrap().to_string_lossy())).collect();
    names.sort();
    names
}

/// Goal: the proofs of every model of the library and of the shelf can be checked without Tripos. Method: `check.py`
/// checks each certificate, bound to the model's file and to the output of `tripos derive --json`.
#[test]
fn all_certificates_are_accepted() {
    if is_without_python() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let models: Vec<String> = ["models", "publications"].into_iter().flat_map(models_in).collect();
    assert!(models.len() > 40, "{models:?}");
    for model in models {
        let certificate = certificate(folder.path(), &model);
        let derivation = folder.path().join("derivation.json");
        std::fs::write(&derivation, command(&root(), &["derive", &model, "--json"]).output().unwrap().stdout).unwrap();
        let place = root().join(&model);
        let files = [place.to_str().unwrap(), derivation.to_str().unwrap()];
        let (holds, text) = run_checker("check.py", &[&certificate, "--model", files[0], "--derivation", files[1]]);
        assert!(holds && text.contains("identities hold"), "{model}: {text}");
    }
}

/// Goal: no certificate with an error is accepted. Method: a forger changes formulas, multipliers, divisors, hashes,
/// primes, names and lines in the certificates of five models, and renews all hashes and primes.
#[test]
fn tampered_certificates_are_refused() {
    if is_without_python() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let models = ["disk", "knife_edge", "driven_pendulum", "heavy_top", "slider_crank"];
    let files: Vec<String> = models.iter().map(|name| certificate(folder.path(), &format!("models/{name}"))).collect();
    let arguments: Vec<&str> = std::iter::once("60").chain(files.iter().map(String::as_str)).collect();
    let (holds, text) = run_checker("tamper.py", &arguments);
    assert!(holds && text.contains("300 tampered certificates are refused, 0 accepted"), "{text}");
}

/// Goal: a certificate never replaces its model, and needs a proof of the standard formulations. Method: the model as
/// the output file, and a further formulation.
#[test]
fn a_certificate_replaces_no_model() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::copy(root().join("models/pendulum/model.toml"), folder.path().join("model.toml")).unwrap();
    let (status, out, err) = tripos_in(folder.path(), &["prove", "model.toml", "--certificate", "model.toml"]);
    assert!(status == 2 && err.contains("would overwrite the input"), "{status} {out} {err}");
    let words = ["prove", "model.toml", "--certificate", "c.json", "--also", "gibbs-appell"];
    let (status, _, err) = tripos_in(folder.path(), &words);
    assert!(status == 2 && err.contains("cannot be used with"), "{status} {err}");
}

/// Goal: the certified equations are those of the model, not only consistent. Method: `kinematics.py` derives Kane's
/// rows of every model of the library again, and refuses equations whose model has another mass, place or load.
#[test]
fn certified_equations_are_those_of_the_model() {
    if is_without_python() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let files: Vec<String> = models_in("models").iter().map(|model| certificate(folder.path(), model)).collect();
    let (holds, text) = run_checker("kinematics.py", &files.iter().map(String::as_str).collect::<Vec<_>>());
    assert!(holds, "{text}");
    assert!(text.matches("statements hold: kinetic energy, potential energy").count() >= 24, "{text}");
    let unknown: Vec<&str> = text.lines().filter(|line| line.contains("not checked")).collect();
    assert!(unknown.len() <= 3, "{unknown:?}");
    let chosen = ["cart_pendulum_3", "driven_pendulum", "heavy_top", "rolling_disc", "elastic_pendulum"];
    let names = chosen.map(|name| folder.path().join(format!("models_{name}.cert")).to_str().unwrap().to_owned());
    let arguments: Vec<&str> = ["models", "12"].into_iter().chain(names.iter().map(String::as_str)).collect();
    let (holds, text) = run_checker("tamper.py", &arguments);
    assert!(holds && text.contains("60 changed models are refused, 0 accepted"), "{text}");
}

/// Goal: short claims hold exactly, by a computer algebra system that parses and differentiates for itself. Method:
/// `check_sympy.py` on six models, one with time and one with a loop.
#[test]
fn sympy_proves_short_claims() {
    if crate::sympy::is_left_out("certificates") {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let names = ["disk", "knife_edge", "driven_pendulum", "four_bar", "satellite", "slider_crank"];
    let files = names.map(|name| certificate(folder.path(), &format!("models/{name}")));
    let program = root().join("tests/certificate/check_sympy.py");
    let output = Command::new(crate::sympy::python()).arg(program).args(&files).output().unwrap();
    let text = String::from_utf8_lossy(&output.stdout);
    assert!(output.status.success(), "{text}{}", String::from_utf8_lossy(&output.stderr));
    assert_eq!(text.matches("SymPy proves").count(), names.len(), "{text}");
    assert!(!text.contains("DOES NOT HOLD"), "{text}");
}

/// Goal: people read the lemmas that Coq checks. Method: the file of a pendulum for Coq; `.ci/full` runs Coq.
#[test]
fn lemmas_for_coq_are_written() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("pendulum.v");
    let words = ["prove", "models/pendulum", "--format", "coq", "--certificate"];
    let output = command(&root(), &words).arg(&path).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let text = std::fs::read_to_string(&path).unwrap();
    assert!(text.contains("8 lemmas; 0 identities are left out"), "{text}");
    assert_eq!(text.matches("Qed.").count(), 8, "{text}");
    assert!(!["Admitted", "Axiom", "admit"].iter().any(|word| text.contains(word)), "{text}");
    let (status, _, err) = tripos_in(&root(), &["prove", "models/pendulum", "--format", "coq"]);
    assert!(status == 2 && err.contains("--certificate"), "{status} {err}");
}
