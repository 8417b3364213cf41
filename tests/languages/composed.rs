//! Functions that call planned ones: derivatives and mass matrices of the state, unknowns, reactions, ordinary and
//! differential-algebraic equations.

use super::{emitted, run};
use crate::left_out::is_left_out;
use crate::sympy;
use std::path::{Path, PathBuf};
use std::process::Command;
use tripos_codegen::languages::Dialect;
use tripos_codegen::languages::c::C;
use tripos_codegen::languages::casadi::CasADi;
use tripos_codegen::languages::matlab::Matlab;
use tripos_codegen::languages::python::Python;
use tripos_codegen::plan::module_name;
use tripos_models::MODELS;

/// Models of a quick run; a thorough one takes the whole library.
const QUICK: [&str; 3] = ["pendulum", "furuta", "four_bar"];

fn python() -> PathBuf {
    sympy::python_with(&sympy::root().join("tests/languages/requirements.txt"), "import numpy, casadi, scipy, fmpy")
}

/// Files of models of the library in one folder, and the stems of their modules.
fn library(dialect: &dyn Dialect, folder: &Path) -> Vec<String> {
    let mut stems = Vec::new();
    let all = std::env::var_os("TRIPOS_LANGUAGES").is_some();
    for model in MODELS.iter().filter(|model| all || QUICK.contains(&model.name)) {
        let own = emitted(model.name, dialect, folder);
        for file in std::fs::read_dir(&own).unwrap().map(Result::unwrap) {
            std::fs::copy(file.path(), folder.join(file.file_name())).unwrap();
        }
        let systems = model.systems.iter().filter(|system| !system.name.contains('@'));
        stems.extend(systems.map(|system| dialect.main_file(model.name, &module_name(system.name))));
    }
    stems
}

/// Output of a command that succeeds.
fn said(command: &mut Command) -> String {
    let output = command.output().unwrap();
    let all = [output.stdout.clone(), output.stderr].concat();
    assert!(output.status.success(), "{command:?}: {}", String::from_utf8_lossy(&all));
    String::from_utf8_lossy(&output.stdout).into_owned()
}

/// Goal: functions that call others pass on what these compute. Method: each against planned functions, for sets of
/// equations of the library at a random state, over NumPy and in CasADi.
#[test]
fn python_and_casadi_pass_on_what_their_functions_compute() {
    if sympy::is_left_out("composed functions in Python") {
        return;
    }
    let dialects: [(&dyn Dialect, &[&str]); 2] = [
        (&Python, &["state_derivative", "unknowns", "reactions"]),
        (&CasADi, &["ode", "dae", "unknowns", "reactions"]),
    ];
    for (dialect, functions) in dialects {
        let folder = tempfile::tempdir().unwrap();
        let modules = library(dialect, folder.path());
        let names = modules.iter().map(|file| file.trim_end_matches(".py"));
        let script = sympy::root().join("tests/languages/composed.py");
        let said =
            said(Command::new(python()).current_dir(folder.path()).env("PYTHONPATH", ".").arg(script).args(names));
        for function in functions {
            let line = said.lines().find_map(|line| line.strip_prefix(&format!("{function} ")));
            let count: usize = line.and_then(|count| count.parse().ok()).unwrap_or(0);
            assert!(count >= 3, "{function} of {count} modules: {said}");
        }
    }
}

#[test]
fn matlab_passes_on_what_its_functions_compute() {
    let found = Command::new("octave-cli").arg("--version").output().is_ok_and(|output| output.status.success());
    if is_left_out("octave", found, "there is no octave-cli") {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let modules = library(&Matlab, folder.path());
    let stems: Vec<&str> = modules.iter().map(|file| file.trim_end_matches("_parameters.m")).collect();
    let scripts = sympy::root().join("tests/languages");
    let call = format!("addpath('{}'); composed('{}')", scripts.display(), stems.join(","));
    let said = said(Command::new("octave-cli").current_dir(folder.path()).args(["--no-init-file", "--eval", &call]));
    let counts: Vec<usize> = said.split_whitespace().filter_map(|count| count.parse().ok()).collect();
    assert!(counts.len() == 4 && counts.iter().all(|count| *count >= 3), "{said}");
}

/// Goal: reactions are the forces that hold a mechanism. Method: the tension of a pendulum's rod, m g cos θ + m l ω²,
/// in C and Python.
#[test]
fn the_rod_of_a_pendulum_pulls_as_it_must() {
    let found = Command::new("gcc").arg("--version").output().is_ok_and(|output| output.status.success());
    if sympy::is_left_out("reactions of a pendulum") || is_left_out("gcc", found, "there is no gcc") {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let at = emitted("pendulum", &C, folder.path());
    emitted("pendulum", &Python, folder.path());
    let program = "#include \"pendulum_newton_euler.h\"\nint main(void) {\n\
        double p[] = {2, 0.7, 9.81}, q[] = {0.4}, u[] = {1.5}, r[PENDULUM_NEWTON_EULER_UNKNOWNS - 1];\n\
        return pendulum_newton_euler_reactions(p, q, u, r) || fabs(r[0] - (2*9.81*cos(0.4) + 2*0.7*2.25)) > 1e-12; }\n";
    std::fs::write(at.join("main.c"), program).unwrap();
    let strict = ["-std=c99", "-Wall", "-Wextra", "-Werror", "-pedantic", "-o", "main"];
    run(Command::new("gcc").current_dir(&at).args(strict).args(["main.c", "pendulum_newton_euler.c", "-lm"]));
    run(&mut Command::new(at.join("main")));
    let script = "import numpy, pendulum_newton_euler as m\n\
        assert m.UNKNOWNS[len(m.VARIABLES):][0] == 'rod', m.UNKNOWNS\n\
        q, u = numpy.array([[0.4, 0.0]]), numpy.array([[1.5, 0.0]])\n\
        rod = m.reactions([2, 0.7, 9.81], q, u)[0]\n\
        assert abs(rod - (2*9.81*numpy.cos(q[0]) + 2*0.7*u[0]**2)).max() < 1e-12, rod\n";
    run(Command::new(python()).current_dir(&at).args(["-c", script]));
}
