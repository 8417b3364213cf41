//! Random mechanisms in C, NumPy and CasADi: the same values, and identities between the functions.

use super::run;
use crate::left_out::is_left_out;
use crate::random_mechanisms::Mechanism;
use crate::support::Random;
use crate::sympy;
use std::path::{Path, PathBuf};
use std::process::Command;
use tripos_codegen::languages::c::C;
use tripos_codegen::languages::casadi::CasADi;
use tripos_codegen::languages::python::Python;
use tripos_codegen::languages::{Dialect, Selection, emit_language_modules};
use tripos_codegen::plan::RegressorFunctions;
use tripos_derive::Model;
use tripos_derive::diagnostic::Source;
use tripos_derive::model::load;

/// Longest C of one module that is compiled in a short run, in bytes.
const LONGEST: usize = 400_000;

/// True if the rate of the energy is not the power of the loads, because a stated motion works too.
fn has_given_motion(mechanism: &Mechanism) -> bool {
    mechanism.elements.iter().any(|element| element.starts_with("given") || *element == "moved base")
}

/// Writes the modules of a model in three languages, with the regressor of a tree; the longest text in C is returned.
fn write(model: &Model, folder: &Path) -> usize {
    let is_tree = model.loops.is_empty() && model.motion_constraints.is_empty();
    let dialects: [&dyn Dialect; 3] = [&C, &Python, &CasADi];
    let mut longest = 0;
    for dialect in dialects {
        let emit = |functions: &[String]| {
            emit_language_modules(
                model,
                dialect,
                Selection { formulations: &[], functions, scene: None, in_base_parameters: false },
            )
        };
        let mut emitted = emit(&[]).unwrap_or_else(|error| panic!("{error}\n{}", model.source.text));
        if is_tree {
            let all = emitted.functions.iter().chain(&RegressorFunctions::FUNCTIONS).map(|name| (*name).to_owned());
            // Base parameters without formulas have no functions.
            emitted = emit(&all.collect::<Vec<_>>()).unwrap_or(emitted);
        }
        for (name, text) in &emitted.emission.files {
            std::fs::write(folder.join(name), text).unwrap();
            longest = longest.max(name.strip_suffix(".c").map_or(0, |_| text.len()));
        }
    }
    longest
}

/// Goal: what is emitted is right for any mechanism. Method: random mechanisms with every kind of element. C is
/// compiled without a warning; C, NumPy and CasADi have the same values at a state on the constraints; the unknowns
/// solve the linear system, Jacobians are slopes, the power is the rate of the energy, and the regressor gives the
/// forces. A defect of the equations themselves would escape: other tests compare these.
#[test]
fn random_mechanisms_have_the_same_values_in_every_language() {
    let found = Command::new("gcc").arg("--version").output().is_ok_and(|output| output.status.success());
    if sympy::is_left_out("Python of random mechanisms") || is_left_out("gcc", found, "there is no gcc") {
        return;
    }
    let thorough = std::env::var_os("TRIPOS_LANGUAGES").is_some();
    let count = if thorough { 150 } else { 12 };
    let folder = tempfile::tempdir().unwrap();
    let mut folders: Vec<PathBuf> = Vec::new();
    for seed in 0..1000 {
        if folders.len() == count {
            break;
        }
        let mechanism = Mechanism::new(&mut Random(seed));
        let mut source = Source::from_text("mechanism", &mechanism.text);
        source.path = PathBuf::from(format!("m{seed}.toml"));
        // Constraints may follow from one another; such mechanisms are refused.
        let Ok(model) = load(&source) else { continue };
        let at = folder.path().join(format!("m{seed}"));
        std::fs::create_dir_all(&at).unwrap();
        if write(&model, &at) > LONGEST && !thorough {
            continue;
        }
        if has_given_motion(&mechanism) {
            std::fs::write(at.join("given"), "").unwrap();
        }
        let entries = std::fs::read_dir(&at).unwrap().map(|entry| entry.unwrap().path());
        for source in entries.filter(|path| path.extension().is_some_and(|end| end == "c")) {
            let strict = ["-std=c99", "-Wall", "-Wextra", "-Werror", "-pedantic", "-ffp-contract=off", "-O0"];
            let library = source.with_extension("so");
            run(Command::new("gcc")
                .args(strict)
                .args(["-fPIC", "-shared"])
                .arg(&source)
                .arg("-lm")
                .arg("-o")
                .arg(library));
        }
        folders.push(at);
    }
    assert_eq!(folders.len(), count, "too many mechanisms are refused");
    let python = sympy::python_with(
        &sympy::root().join("tests/languages/requirements.txt"),
        "import numpy, casadi, scipy, fmpy",
    );
    let script = sympy::root().join("tests/languages/mechanisms.py");
    run(Command::new(python).env("PYTHONDONTWRITEBYTECODE", "1").arg(script).args(&folders));
}
