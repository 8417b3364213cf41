//! Regressors in all languages.

use super::run;
use crate::left_out::is_left_out;
use crate::support::Random;
use crate::sympy;
use std::fmt::Write as _;
use std::path::Path;
use std::process::Command;
use tripos_codegen::languages::c::C;
use tripos_codegen::languages::casadi::CasADi;
use tripos_codegen::languages::matlab::Matlab;
use tripos_codegen::languages::python::Python;
use tripos_codegen::languages::{Dialect, Selection, emit_language_modules};
use tripos_codegen::plan::RegressorFunctions;
use tripos_derive::{Formulation, Model};
use tripos_models::MODELS;
use tripos_traits::{DoubleDouble, Real, System};

/// Models of a quick run. The last two have closed loops and rolling.
const QUICK: [&str; 6] = ["pendulum", "furuta", "heavy_top", "cart_with_spring", "four_bar", "disk"];

/// State of a model with accelerations, and the forces that they need to 32 digits.
struct Moved {
    p: Vec<f64>,
    q: Vec<f64>,
    u: Vec<f64>,
    a: Vec<f64>,
    forces: Vec<f64>,
    largest: f64,
}

impl Moved {
    fn random(system: &dyn System<DoubleDouble>) -> Self {
        let (lengths, mut random) = (system.lengths(), Random(5));
        let mut list =
            |count: usize, low: f64, high: f64| -> Vec<f64> { (0..count).map(|_| random.between(low, high)).collect() };
        let n = lengths.variables;
        let (p, q) = (list(lengths.parameters, 0.2, 3.0), list(lengths.coordinates, 0.1, 1.4));
        let (u, a) = (list(n, -2.0, 2.0), list(n, -3.0, 3.0));
        let exact = |list: &[f64]| -> Vec<DoubleDouble> { list.iter().map(|x| DoubleDouble::from(*x)).collect() };
        let zero = DoubleDouble::from(0.0);
        let (mut matrix, mut right) = (vec![zero; n * n], vec![zero; n]);
        let [of_p, of_q, of_u, of_a] = [&p, &q, &u, &a].map(|list| exact(list));
        system.mass_matrix(&of_p, &of_q, &of_u, &mut matrix);
        system.forcing(&of_p, &of_q, &of_u, &mut right);
        let terms = |row: usize| (0..n).map(|column| matrix[row * n + column] * of_a[column]).collect::<Vec<_>>();
        let force = |row: usize| terms(row).into_iter().fold(zero - right[row], |sum, term| sum + term).to_f64();
        let sizes = (0..n).flat_map(&terms).chain(right.iter().copied()).map(|x| x.to_f64().abs());
        Self { largest: sizes.fold(1.0, f64::max), forces: (0..n).map(force).collect(), p, q, u, a }
    }

    /// Program in a language that prints the forces by the regressor, then by that of the base parameters if there is
    /// one.
    fn program(&self, language: &str, stem: &str, has_base: bool, counts: [usize; 2]) -> String {
        let list = |values: &[f64]| values.iter().map(|x| format!("{x:?}")).collect::<Vec<_>>();
        let given = [&self.p, &self.q, &self.u, &self.a].map(|values| list(values));
        let kinds: &[(&str, &str, usize)] = if has_base {
            &[("regressor", "inertial_parameters", 0), ("base_regressor", "base_parameters", 1)]
        } else {
            &[("regressor", "inertial_parameters", 0)]
        };
        let mut out = String::new();
        let n = self.u.len();
        match language {
            "c" => {
                let _ = write!(out, "#include \"{stem}.h\"\n#include <stdio.h>\nint main(void) {{\n  int i, k;\n");
                for (name, values) in ["p", "q", "u", "a"].iter().zip(&given) {
                    let values = if values.is_empty() { "0".to_owned() } else { values.join(", ") };
                    let _ = writeln!(out, "  static const double {name}[] = {{ {values} }};");
                }
                let most = counts.iter().max().unwrap() + 1;
                let _ = writeln!(out, "  static double table[{}], rest[{n}], values[{most}];", n * most);
                let _ = writeln!(out, "  {stem}_regressor_rest(p, q, u, a, rest);");
                for (table, values, at) in kinds {
                    let columns = counts[*at];
                    let _ = writeln!(
                        out,
                        "  {stem}_{table}(p, q, u, a, table); {stem}_{values}(p, values);\n  \
                         for (i = 0; i < {n}; i++) {{ double sum = rest[i]; for (k = 0; k < {columns}; k++) \
                         sum += table[i * {columns} + k] * values[k]; printf(\"%.17g\\n\", sum); }}"
                    );
                }
                out.push_str("  return 0;\n}\n");
            }
            "matlab" => {
                for (name, values) in ["p", "q", "u", "a"].iter().zip(&given) {
                    let _ = write!(out, "{name} = [{}]'; ", values.join(", "));
                }
                for (table, values, _) in kinds {
                    let _ = write!(
                        out,
                        "printf('%.17g\\n', {stem}_{table}(p, q, u, a) * {stem}_{values}(p) + {stem}_regressor_rest(p, q, u, a)); "
                    );
                }
            }
            _ => {
                let wrap = if language == "casadi" { "casadi.DM" } else { "numpy.array" };
                let _ = writeln!(out, "import casadi, numpy, {stem} as m");
                for (name, values) in ["p", "q", "u", "a"].iter().zip(&given) {
                    let _ = writeln!(out, "{name} = {wrap}([{}])", values.join(", "));
                }
                for (table, values, _) in kinds {
                    let _ = writeln!(
                        out,
                        "values = m.{table}(p, q, u, a) @ m.{values}(p) + m.regressor_rest(p, q, u, a)\n\
                         print(*(repr(float(x)) for x in numpy.array(values).reshape(-1)), sep='\\n')"
                    );
                }
            }
        }
        out
    }

    /// Program in a language that prints the forces by the equations in base parameters, M u̇ − f and inverse dynamics.
    fn base_program(&self, language: &str, stem: &str, parameters: usize) -> String {
        let list = |values: &[f64]| values.iter().map(|x| format!("{x:?}")).collect::<Vec<_>>();
        let mut own = list(&self.p);
        let count = own.len();
        own.resize(parameters, "0".to_owned());
        let given = [&own, &list(&self.q), &list(&self.u), &list(&self.a)].map(|values| values.join(", "));
        let named = || ["p", "q", "u", "a"].into_iter().zip(&given);
        let n = self.u.len();
        match language {
            "c" => {
                let arrays: Vec<String> =
                    named().map(|(name, values)| format!("  static double {name}[] = {{ {values} }};\n")).collect();
                let arrays = arrays.concat();
                format!(
                    "#include \"{stem}.h\"\n#include <stdio.h>\nint main(void) {{\n  int i, k;\n{arrays}  \
                     static double base[{parameters}], m[{0}], f[{n}], tau[{n}];\n  \
                     {stem}_base_parameters(p, base); for (k = {count}; k < {parameters}; k++) p[k] = base[k - {count}];\n  \
                     {stem}_mass_matrix(p, q, u, m); {stem}_forcing(p, q, u, f); {stem}_inverse_dynamics(p, q, u, a, tau);\n  \
                     for (i = 0; i < {n}; i++) {{ double sum = -f[i]; for (k = 0; k < {n}; k++) sum += m[i * {n} + k] * a[k]; \
                     printf(\"%.17g\\n\", sum); }}\n  for (i = 0; i < {n}; i++) printf(\"%.17g\\n\", tau[i]);\n  return 0;\n}}\n",
                    n * n
                )
            }
            "matlab" => {
                let arrays: Vec<String> = named().map(|(name, values)| format!("{name} = [{values}]'; ")).collect();
                let arrays = arrays.concat();
                format!(
                    "{arrays}p({}:end) = {stem}_base_parameters(p); \
                     printf('%.17g\\n', {stem}_mass_matrix(p, q, u) * a - {stem}_forcing(p, q, u)); \
                     printf('%.17g\\n', {stem}_inverse_dynamics(p, q, u, a));",
                    count + 1
                )
            }
            _ => {
                let wrap = if language == "casadi" { "casadi.DM" } else { "numpy.array" };
                let arrays = named()
                    .map(|(name, values)| {
                        let values = if language == "casadi" { values.clone() } else { format!("{values}, ") };
                        format!("{name} = {wrap}([{values}])\n")
                    })
                    .collect::<Vec<String>>()
                    .concat();
                format!(
                    "import casadi, numpy, {stem} as m\n{arrays}p[{count}:] = m.base_parameters(p)\n\
                     for forces in (m.mass_matrix(p, q, u) @ a - m.forcing(p, q, u), m.inverse_dynamics(p, q, u, a)):\n    \
                     print(*(repr(float(x)) for x in numpy.array(forces).reshape(-1)), sep='\\n')\n"
                )
            }
        }
    }

    fn check(&self, printed: &str, times: usize, what: &str) {
        let values: Vec<f64> = printed.split_whitespace().map(|word| word.parse().unwrap()).collect();
        assert_eq!(values.len(), times * self.forces.len(), "{what}: {printed}");
        for (value, force) in values.iter().zip(self.forces.iter().cycle()) {
            assert!((value - force).abs() <= 1e-11 * self.largest, "{what}: {value} is not {force}");
        }
    }
}

/// Writes the regressor of a model in a dialect; returns its names of functions.
fn write(model: &Model, dialect: &dyn Dialect, folder: &Path) -> Vec<String> {
    let formulations = &[Formulation::Kane];
    let mut functions: Vec<String> = RegressorFunctions::FUNCTIONS.map(str::to_owned).to_vec();
    let emitted = emit_language_modules(
        model,
        dialect,
        Selection { formulations, functions: &functions, scene: None, in_base_parameters: false },
    );
    let emitted = emitted.or_else(|_| {
        functions.truncate(3);
        emit_language_modules(
            model,
            dialect,
            Selection { formulations, functions: &functions, scene: None, in_base_parameters: false },
        )
    });
    let emitted = emitted.unwrap_or_else(|error| panic!("{error}"));
    for (name, text) in &emitted.emission.files {
        std::fs::write(folder.join(name), text).unwrap();
    }
    functions
}

/// Goal: Y π + rest is the force that a motion needs, in every language. Method: products of the emitted functions at a
/// random state with random accelerations, against M u̇ − f of the compiled equations to 32 digits. Base parameters
/// give the same forces; at least half of the models have formulas for these.
#[test]
fn regressors_give_the_forces_that_motion_needs() {
    let has = |program: &str| Command::new(program).arg("--version").output().is_ok_and(|o| o.status.success());
    let has_python = !sympy::is_left_out("regressors in Python");
    let has_gcc = !is_left_out("gcc", has("gcc"), "there is no gcc");
    let has_octave = !is_left_out("octave", has("octave-cli"), "there is no octave-cli");
    let all = std::env::var_os("TRIPOS_LANGUAGES").is_some();
    let python = has_python.then(|| {
        sympy::python_with(&sympy::root().join("tests/languages/requirements.txt"), "import numpy, casadi, scipy, fmpy")
    });
    let (mut count, mut with_base) = (0, 0);
    for library in MODELS.iter().filter(|library| all || QUICK.contains(&library.name)) {
        let Some(kane) = library.systems.iter().find(|system| system.name == "kane") else { continue };
        let name = library.name;
        let model = Model::read(&sympy::root().join("models").join(name).join("model.toml")).unwrap();
        let moved = Moved::random(kane.extended);
        let folder = tempfile::tempdir().unwrap();
        let at = folder.path();
        let functions = write(&model, &C, at);
        let has_base = functions.len() > 3;
        let times = functions.len() / 2;
        count += 1;
        with_base += usize::from(has_base);
        let text = std::fs::read_to_string(at.join(format!("{name}_kane.h"))).unwrap();
        let length = |list: &str| {
            let start = text.find(&format!("_{list} = ")).map_or(0, |at| at + list.len() + 4);
            text[start..].chars().take_while(char::is_ascii_digit).collect::<String>().parse().unwrap_or(0)
        };
        let counts = ["INERTIAL_PARAMETERS", "BASE_PARAMETERS"].map(length);
        let said = |command: &mut Command| {
            let output = command.output().unwrap();
            assert!(output.status.success(), "{name}: {output:?}");
            String::from_utf8_lossy(&output.stdout).into_owned()
        };
        if has_gcc {
            std::fs::write(at.join("main.c"), moved.program("c", &format!("{name}_kane"), has_base, counts)).unwrap();
            let strict = ["-std=c99", "-Wall", "-Wextra", "-Werror", "-pedantic", "-o", "main", "main.c"];
            run(Command::new("gcc").current_dir(at).args(strict).args([&format!("{name}_kane.c"), "-lm"]));
            moved.check(&said(&mut Command::new(at.join("main"))), times, &format!("{name} in C"));
        }
        if let Some(python) = &python {
            write(&model, &Python, at);
            let program = moved.program("python", &format!("{name}_kane"), has_base, counts);
            let printed = said(Command::new(python).current_dir(at).args(["-c", &program]));
            moved.check(&printed, times, &format!("{name} in Python"));
            write(&model, &CasADi, at);
            let program = moved.program("casadi", &format!("{name}_kane_casadi"), has_base, counts);
            let printed = said(Command::new(python).current_dir(at).args(["-c", &program]));
            moved.check(&printed, times, &format!("{name} in CasADi"));
        }
        if has_octave {
            write(&model, &Matlab, at);
            let program = moved.program("matlab", &format!("{name}_kane"), has_base, counts);
            let printed = said(Command::new("octave-cli").current_dir(at).args(["--no-init-file", "--eval", &program]));
            moved.check(&printed, times, &format!("{name} in MATLAB"));
        }
    }
    assert!(count >= QUICK.len() && 2 * with_base >= count, "{with_base} of {count} models have base parameters");
}

/// Writes the equations of a model in base parameters in a dialect.
fn write_in_base_parameters(model: &Model, dialect: &dyn Dialect, folder: &Path) {
    let selection = Selection { in_base_parameters: true, ..Selection::default() };
    let emitted = emit_language_modules(model, dialect, selection).unwrap_or_else(|error| panic!("{error}"));
    for (name, text) in &emitted.emission.files {
        std::fs::write(folder.join(name), text).unwrap();
    }
}

/// Goal: equations in base parameters give the force that a motion needs, in every language. Method: M u̇ − f and the
/// inverse dynamics of the emitted functions at a random state with random accelerations, against M u̇ − f of the
/// compiled equations in the parameters of the model to 32 digits.
#[test]
fn equations_in_base_parameters_give_the_forces_that_motion_needs() {
    let has = |program: &str| Command::new(program).arg("--version").output().is_ok_and(|o| o.status.success());
    let has_python = !sympy::is_left_out("equations in base parameters in Python");
    let has_gcc = !is_left_out("gcc", has("gcc"), "there is no gcc");
    let has_octave = !is_left_out("octave", has("octave-cli"), "there is no octave-cli");
    let all = std::env::var_os("TRIPOS_LANGUAGES").is_some();
    let python = has_python.then(|| {
        sympy::python_with(&sympy::root().join("tests/languages/requirements.txt"), "import numpy, casadi, scipy, fmpy")
    });
    let mut count = 0;
    for library in MODELS.iter().filter(|library| all || QUICK.contains(&library.name)) {
        let Some(kane) = library.systems.iter().find(|system| system.name == "kane") else { continue };
        let name = library.name;
        let model = Model::read(&sympy::root().join("models").join(name).join("model.toml")).unwrap();
        let moved = Moved::random(kane.extended);
        let folder = tempfile::tempdir().unwrap();
        let at = folder.path();
        write_in_base_parameters(&model, &C, at);
        count += 1;
        let stem = format!("{name}_base_kane");
        let text = std::fs::read_to_string(at.join(format!("{stem}.h"))).unwrap();
        let parameters = text.split("_PARAMETERS = ").nth(1).unwrap();
        let parameters: String = parameters.chars().take_while(char::is_ascii_digit).collect();
        let parameters: usize = parameters.parse().unwrap();
        let said = |command: &mut Command| {
            let output = command.output().unwrap();
            assert!(output.status.success(), "{name}: {output:?}");
            String::from_utf8_lossy(&output.stdout).into_owned()
        };
        if has_gcc {
            std::fs::write(at.join("main.c"), moved.base_program("c", &stem, parameters)).unwrap();
            let strict = ["-std=c99", "-Wall", "-Wextra", "-Werror", "-pedantic", "-o", "main", "main.c"];
            run(Command::new("gcc").current_dir(at).args(strict).args([&format!("{stem}.c"), "-lm"]));
            moved.check(&said(&mut Command::new(at.join("main"))), 2, &format!("{name} in C"));
        }
        if let Some(python) = &python {
            write_in_base_parameters(&model, &Python, at);
            let program = moved.base_program("python", &stem, parameters);
            moved.check(
                &said(Command::new(python).current_dir(at).args(["-c", &program])),
                2,
                &format!("{name} in Python"),
            );
            write_in_base_parameters(&model, &CasADi, at);
            let program = moved.base_program("casadi", &format!("{stem}_casadi"), parameters);
            moved.check(
                &said(Command::new(python).current_dir(at).args(["-c", &program])),
                2,
                &format!("{name} in CasADi"),
            );
        }
        if has_octave {
            write_in_base_parameters(&model, &Matlab, at);
            let program = moved.base_program("matlab", &stem, parameters);
            let mut command = Command::new("octave-cli");
            let printed = said(command.current_dir(at).args(["--no-init-file", "--eval", &program]));
            moved.check(&printed, 2, &format!("{name} in MATLAB"));
        }
    }
    assert!(count >= QUICK.len(), "{count} models have equations in base parameters");
}
