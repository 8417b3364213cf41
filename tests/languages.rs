//! Equations in C, Python, MATLAB and CasADi compute what the Rust code from the same model computes.

mod composed;
mod identified;
mod mechanisms;
mod table;
mod truth;

use crate::left_out::is_left_out;
use crate::support::Random;
use crate::sympy;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::rc::Rc;
use tripos_codegen::languages::c::C;
use tripos_codegen::languages::casadi::CasADi;
use tripos_codegen::languages::matlab::Matlab;
use tripos_codegen::languages::python::Python;
use tripos_codegen::languages::{Dialect, Selection, emit_language_modules};
use tripos_codegen::plan::{ModulePlan, RegressorFunctions, module_name};
use tripos_derive::scene::{Scene, load_scene_with_inputs};
use tripos_derive::{Formulation, Model};
use tripos_models::MODELS;
use tripos_traits::{CompiledSystem, DoubleDouble, Real, Scalar};
use truth::{Stated, Truth};

type Dd = DoubleDouble;

/// Functions whose C and Rust are written from one plan, so that their values have the same bits.
const SAME_PLAN: [&str; 13] = [
    "mass_matrix",
    "forcing",
    "accelerations",
    "coordinate_rates",
    "kinetic_energy",
    "potential_energy",
    "power",
    "generalized_speeds",
    "generalized_speed_rates",
    "motion_variables",
    "divisors",
    "constraints",
    "constraint_slopes",
];

/// Number of random states at which each function is evaluated: in a thorough run those that `TRIPOS_LANGUAGES` gives.
fn states() -> usize {
    std::env::var("TRIPOS_LANGUAGES").ok().and_then(|count| count.parse().ok()).unwrap_or(12)
}

/// One set of equations: its compiled Rust, and the states at which it is asked.
#[derive(Clone)]
struct Asked {
    model: &'static str,
    system: &'static CompiledSystem,
    truth: Truth,
    /// Names of the functions that the emitted module has and Rust knows.
    functions: Vec<String>,
    states: Vec<State>,
}

/// Arguments of all functions: parameters, coordinates, motion variables, generalized speeds, unknowns.
#[derive(Clone)]
struct State {
    p: Vec<f64>,
    q: Vec<f64>,
    v: Vec<f64>,
    u: Vec<f64>,
    x: Vec<f64>,
}

impl State {
    fn random(system: &CompiledSystem, random: &mut Random) -> Self {
        let lengths = system.double.lengths();
        let unknowns = lengths.variables + lengths.reactions;
        let mut list = |count: usize, low: f64, high: f64| (0..count).map(|_| random.between(low, high)).collect();
        Self {
            p: list(lengths.parameters, 0.2, 3.0),
            q: list(lengths.coordinates, 0.1, 1.4),
            v: list(lengths.variables, -2.0, 2.0),
            u: list(lengths.speeds, -2.0, 2.0),
            x: list(unknowns, -3.0, 3.0),
        }
    }

    /// The state in 32 digits.
    fn extended(&self) -> [Vec<Dd>; 5] {
        self.plain().map(|list| list.into_iter().map(Dd::from).collect())
    }

    /// A state beside this one: each number is changed by a few units in its last place.
    fn neighbour(&self, random: &mut Random) -> Self {
        let mut change = |x: &f64| x * (1.0 + (4.0 * f64::EPSILON) * random.between(-1.0, 1.0));
        let [p, q, v, u, x] = self.plain().map(|list| list.iter().map(&mut change).collect());
        Self { p, q, v, u, x }
    }

    fn plain(&self) -> [Vec<f64>; 5] {
        [&self.p, &self.q, &self.v, &self.u, &self.x].map(Clone::clone)
    }
}

/// Largest errors of a value that count as rounding: four times those of Rust, at the state or beside it, and what the
/// last places of the arguments make of the value.
fn bounds(truth: &Truth, name: &str, state: &State, exact_value: &[Dd], random: &mut Random) -> Vec<f64> {
    let largest = exact_value.iter().fold(0.0_f64, |most, x| most.max(x.abs().to_f64()));
    // An entry that cancels has the rounding of its neighbours. Slopes along parameters and entries of the Jacobian are
    // computed by other steps than in Rust, and cancel more.
    let share = if name.contains("jacobian") { 1e-8 } else { 8.0 * f64::EPSILON };
    let mut of_rust = vec![0.0_f64; exact_value.len()];
    let mut of_arguments = vec![0.0_f64; exact_value.len()];
    let mut states = vec![state.clone()];
    states.extend((0..3).map(|_| state.neighbour(random)));
    for state in states {
        let there = truth.exact(name, &state.extended()).expect("a function that exists");
        let own = truth.double(name, &state.plain());
        for at in 0..exact_value.len() {
            let error = own.as_ref().map_or(0.0, |own| (Dd::from(own[at]) - there[at]).abs().to_f64());
            of_rust[at] = of_rust[at].max(error);
            of_arguments[at] = of_arguments[at].max((there[at] - exact_value[at]).abs().to_f64());
        }
    }
    of_rust.iter().zip(&of_arguments).map(|(rust, moved)| 4.0 * rust + 32.0 * moved + share * largest).collect()
}

/// Emitted files of a model in a folder.
fn emitted(model: &str, dialect: &dyn Dialect, folder: &Path) -> PathBuf {
    let folder = folder.join(model);
    std::fs::create_dir_all(&folder).unwrap();
    let model = Model::read(&sympy::root().join("models").join(model).join("model.toml")).unwrap();
    let emitted = emit_language_modules(&model, dialect, Selection::default()).unwrap();
    for (name, text) in &emitted.emission.files {
        std::fs::write(folder.join(name), text).unwrap();
    }
    folder
}

/// All compiled equations of the library, with the functions that `has` finds in an emitted module.
fn asked(has: &dyn Fn(&'static str, &str, &str) -> bool) -> Vec<Asked> {
    let mut list = Vec::new();
    for model in MODELS {
        let stated = Stated::read(model.name);
        for system in model.systems.iter().filter(|system| !system.name.contains('@')) {
            let truth = Truth { system, stated: Rc::clone(&stated) };
            let mut random = Random(7);
            let states: Vec<State> = (0..states()).map(|_| State::random(system, &mut random)).collect();
            let first = states[0].extended();
            let known = |name: &&str| truth.exact(name, &first).is_some_and(|value| !value.is_empty());
            let functions = ModulePlan::FUNCTIONS.iter().copied().filter(|f| has(model.name, system.name, f));
            let functions = functions.filter(known).map(str::to_owned).collect();
            list.push(Asked { model: model.name, system, truth, functions, states });
        }
    }
    assert!(list.len() > 60, "the library has models in several formulations: {}", list.len());
    list
}

impl Asked {
    fn stem(&self) -> String {
        format!("{}_{}", self.model, module_name(self.system.name))
    }

    /// Bytes of the states, as the scripts read them.
    fn input(&self) -> Vec<u8> {
        let first = &self.states[0];
        let counts = [self.states.len(), first.p.len(), first.q.len(), first.v.len(), first.u.len(), first.x.len()];
        let mut bytes: Vec<u8> = counts.iter().flat_map(|count| (*count as u64).to_le_bytes()).collect();
        for state in &self.states {
            bytes.extend(state.plain().iter().flatten().flat_map(|x| x.to_le_bytes()));
        }
        bytes
    }

    /// Compares values with 32 digits; returns the lines that say which are wrong, and counts values.
    fn wrong(&self, bytes: &[u8], same_bits: bool, count: &mut usize) -> Vec<String> {
        let mut values = bytes.chunks_exact(8).map(|x| f64::from_le_bytes(x.try_into().unwrap()));
        let mut random = Random(11);
        let mut wrong = Vec::new();
        for name in &self.functions {
            for (at, state) in self.states.iter().enumerate() {
                let expected = self.truth.exact(name, &state.extended()).unwrap();
                let found: Vec<f64> = values.by_ref().take(expected.len()).collect();
                assert_eq!(found.len(), expected.len(), "{} {name}: too few values", self.stem());
                *count += found.len();
                let whole = |entry: usize| format!("{} {name}, state {at}, entry {entry}", self.stem());
                if same_bits && SAME_PLAN.contains(&name.as_str()) {
                    let own = self.truth.double(name, &state.plain()).unwrap();
                    let differs = |entry: &usize| {
                        found[*entry].to_bits() != own[*entry].to_bits()
                            && !(found[*entry].is_nan() && own[*entry].is_nan())
                    };
                    let entry = (0..own.len()).find(differs);
                    wrong.extend(entry.map(|e| format!("{}: {:e} is not Rust's {:e}", whole(e), found[e], own[e])));
                    continue;
                }
                let bounds = bounds(&self.truth, name, state, &expected, &mut random);
                let is_off = |entry: &usize| {
                    let error = (Dd::from(found[*entry]) - expected[*entry]).abs().to_f64();
                    let both_nothing = found[*entry].is_nan() && !expected[*entry].is_finite();
                    let is_within = error <= bounds[*entry];
                    !is_within && !both_nothing && expected[*entry].is_finite()
                };
                let entry = (0..expected.len()).find(is_off);
                wrong.extend(entry.map(|e| {
                    format!("{}: {:e}, not {:e}, within {:e}", whole(e), found[e], expected[e].to_f64(), bounds[e])
                }));
            }
        }
        assert_eq!(values.count(), 0, "{}: more values than asked", self.stem());
        wrong
    }
}

fn run(command: &mut Command) {
    let output = command.output().unwrap();
    let said = [output.stdout, output.stderr].concat();
    assert!(output.status.success(), "{command:?}: {}", String::from_utf8_lossy(&said));
}

fn report(language: &str, count: usize, wrong: &[String]) {
    println!("{language}: {count} values, {} wrong", wrong.len());
    assert!(count > 10_000 * states(), "{language}: only {count} values");
    // In a thorough run, a few of millions of random states lie so near to a singular pose that the states beside them
    // do not tell the rounding. An error of code is at every state.
    assert!(
        wrong.len() * 1_000_000 <= count,
        "{language}: {} wrong\n{}",
        wrong.len(),
        wrong[..wrong.len().min(20)].join("\n")
    );
}

/// Call of each function of a module in C, with the number of its values, for the programs below.
fn calls(asked: &Asked, header: &str) -> Vec<(String, usize)> {
    let stem = asked.stem();
    let lengths = asked.system.double.lengths();
    let call = |name: &String| {
        let start = header.find(&format!("{stem}_{name}(")).expect("a declared function");
        let list = &header[start..start + header[start..].find(';').unwrap()];
        let list = &list[list.find('(').unwrap() + 1..list.rfind(')').unwrap()];
        let names: Vec<&str> = list
            .split(',')
            .map(|argument| argument.split(|c: char| !(c.is_alphanumeric() || c == '_')).collect::<Vec<_>>())
            .map(|words| *words.iter().rfind(|w| w.starts_with(|c: char| c.is_ascii_alphabetic())).unwrap())
            .collect();
        let count = asked.truth.exact(name, &asked.states[0].extended()).unwrap().len();
        let first = match name.as_str() {
            "derivative" => lengths.coordinates,
            _ => count.saturating_sub(lengths.variables + lengths.reactions),
        };
        let argument = |n: &&str| match *n {
            "v_dot" => "x".to_owned(),
            "out_2" => format!("out + {first}"),
            "q_dot" => "v".to_owned(),
            // Only the conversion from generalized speeds takes these instead of the motion variables.
            "u" if *name != "motion_variables" => "v".to_owned(),
            other => other.to_owned(),
        };
        let arguments: Vec<String> = names.iter().map(argument).collect();
        let call = format!("{stem}_{name}({})", arguments.join(", "));
        (if names.contains(&"out") { call } else { format!("out[0] = {call}") }, count)
    };
    asked.functions.iter().map(call).collect()
}

/// C program that reads states and writes a file; `at(k)` chooses a state, and `body` writes.
fn program(stem: &str, body: &str) -> String {
    format!(
        "#include \"{stem}.h\"\n#include <stdio.h>\n#include <stdlib.h>\n#include <time.h>\n\
         static double *all, *p, *q, *v, *u, *x; static long long n[6];\n\
         static void at(long long k) {{ p = all + k * (n[1] + n[2] + n[3] + n[4] + n[5]); q = p + n[1]; v = q + n[2]; u = v + n[3]; \
         x = u + n[4]; }}\n\
         int main(int argc, char **argv) {{\n  long long k, states; double *out = calloc(1000000, 8); FILE *file = fopen(argv[1], \"rb\");\n  \
         if (argc < 3 || fread(n, 8, 6, file) != 6) return 1;\n  states = n[0]; k = states * (n[1] + n[2] + n[3] + n[4] + n[5]);\n  \
         all = malloc(8 * k);\n  if (fread(all, 8, k, file) != (size_t)k) return 1;\n  file = fopen(argv[2], \"wb\");\n{body}  \
         fclose(file);\n  (void)u; (void)x;\n  return 0;\n}}\n"
    )
}

/// C program that evaluates the functions of one module.
fn driver(asked: &Asked, header: &str) -> String {
    let line = |(call, count): (String, usize)| {
        format!("  for (k = 0; k < states; k++) {{ at(k); {call}; fwrite(out, 8, {count}, file); }}\n")
    };
    program(&asked.stem(), &calls(asked, header).into_iter().map(line).collect::<String>())
}

/// Goal: C computes what Rust computes, to the bit where both are written from one plan, and compiles without a
/// warning. Method: every function of every set of equations of the library at random states, by GCC without
/// contraction.
#[test]
fn c_has_the_bits_of_rust() {
    let found = Command::new("gcc").arg("--version").output().is_ok_and(|output| output.status.success());
    if is_left_out("gcc", found, "there is no gcc") {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let folders: BTreeMap<&str, PathBuf> =
        MODELS.iter().map(|model| (model.name, emitted(model.name, &C, folder.path()))).collect();
    let header = |model: &str, equations: &str| {
        let path = folders[model].join(format!("{model}_{}.h", module_name(equations)));
        std::fs::read_to_string(path).unwrap()
    };
    let has = |model: &'static str, equations: &str, function: &str| {
        header(model, equations).contains(&format!("{model}_{}_{function}(", module_name(equations)))
    };
    let (mut count, mut wrong) = (0, Vec::new());
    for asked in asked(&has) {
        let at = &folders[asked.model];
        let stem = asked.stem();
        std::fs::write(at.join("main.c"), driver(&asked, &header(asked.model, asked.system.name))).unwrap();
        std::fs::write(at.join("in"), asked.input()).unwrap();
        let strict = ["-std=c99", "-Wall", "-Wextra", "-Werror", "-pedantic", "-ffp-contract=off", "-O1"];
        run(Command::new("gcc").current_dir(at).args(strict).args(["-c", &format!("{stem}.c"), "-o", "own.o"]));
        run(Command::new("gcc").current_dir(at).args(["-std=c99", "-O1", "main.c", "own.o", "-lm", "-o", "main"]));
        run(Command::new(at.join("main")).current_dir(at).args(["in", "out"]));
        wrong.extend(asked.wrong(&std::fs::read(at.join("out")).unwrap(), !cfg!(target_feature = "fma"), &mut count));
    }
    report("C", count, &wrong);
}

/// Evaluates the library by a script of Python, and compares with 32 digits.
fn python(kind: &str, dialect: &dyn Dialect, ending: &str) {
    let requirements = sympy::root().join("tests/languages/requirements.txt");
    let python = sympy::python_with(&requirements, "import numpy, casadi, scipy, fmpy");
    let folder = tempfile::tempdir().unwrap();
    let folders: BTreeMap<&str, PathBuf> =
        MODELS.iter().map(|model| (model.name, emitted(model.name, dialect, folder.path()))).collect();
    let text = |model: &str, equations: &str| {
        let path = folders[model].join(format!("{model}_{}{ending}.py", module_name(equations)));
        std::fs::read_to_string(path).unwrap()
    };
    let has = |model: &'static str, equations: &str, function: &str| {
        text(model, equations).contains(&format!("def {function}("))
    };
    let (mut count, mut wrong) = (0, Vec::new());
    for asked in asked(&has) {
        let at = &folders[asked.model];
        std::fs::write(at.join("in"), asked.input()).unwrap();
        let script = sympy::root().join("tests/languages/evaluate.py");
        let module = format!("{}{ending}", asked.stem());
        let functions = asked.functions.join(",");
        run(Command::new(&python)
            .current_dir(at)
            .env("PYTHONPATH", ".")
            .env("PYTHONDONTWRITEBYTECODE", "1")
            .arg(script)
            .args([kind, &module, "in", "out", &functions]));
        wrong.extend(asked.wrong(&std::fs::read(at.join("out")).unwrap(), false, &mut count));
    }
    report(kind, count, &wrong);
}

#[test]
fn python_computes_what_rust_computes() {
    if sympy::is_left_out("Python over NumPy") {
        return;
    }
    python("numpy", &Python, "");
}

#[test]
fn casadi_computes_what_rust_computes() {
    if sympy::is_left_out("CasADi") {
        return;
    }
    python("casadi", &CasADi, "_casadi");
}

#[test]
fn matlab_computes_what_rust_computes() {
    let found = Command::new("octave-cli").arg("--version").output().is_ok_and(|output| output.status.success());
    if is_left_out("octave", found, "there is no octave-cli") {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let folders: BTreeMap<&str, PathBuf> =
        MODELS.iter().map(|model| (model.name, emitted(model.name, &Matlab, folder.path()))).collect();
    let stem = |model: &str, equations: &str| {
        let parameters = Matlab.main_file(model, &module_name(equations));
        parameters.trim_end_matches("_parameters.m").to_owned()
    };
    let has = |model: &'static str, equations: &str, function: &str| {
        folders[model].join(format!("{}_{function}.m", stem(model, equations))).is_file()
    };
    let (mut count, mut wrong) = (0, Vec::new());
    for asked in asked(&has) {
        let at = &folders[asked.model];
        std::fs::write(at.join("in"), asked.input()).unwrap();
        let call = format!(
            "addpath('{}'); evaluate('.', '{}', 'in', 'out', '{}')",
            sympy::root().join("tests/languages").display(),
            stem(asked.model, asked.system.name),
            asked.functions.join(",")
        );
        run(Command::new("octave-cli").current_dir(at).args(["--no-init-file", "--eval", &call]));
        wrong.extend(asked.wrong(&std::fs::read(at.join("out")).unwrap(), false, &mut count));
    }
    report("MATLAB", count, &wrong);
}

/// Names that are words of some language, functions that generated code calls, or names of its variables.
const NAMES: [&str; 44] = [
    "int",
    "restrict",
    "double",
    "lambda",
    "def",
    "end",
    "function",
    "register",
    "NAN",
    "I",
    "J",
    "N",
    "out",
    "p",
    "x",
    "xp",
    "shape",
    "numpy",
    "casadi",
    "np",
    "size",
    "zeros",
    "sinh_",
    "tripos_sin",
    "M_PI",
    "linux",
    "far",
    "state",
    "first",
    "_a",
    "a__b",
    "__x",
    "None",
    "True",
    "volatile",
    "template",
    "typename",
    "import_",
    "match",
    "print",
    "matrix",
    "right",
    "work",
    "endfunction",
];

/// Texts that would be code if they left their comment or string.
const TEXTS: [&str; 13] = [
    "*/ system(\"touch HOSTILE\"); /*",
    "ends with a backslash \\",
    // Wherever a comment of this is broken, a line ends with a backslash.
    "\\ \\ \\ \\ \\ \\ \\ \\ \\ \\ \\ \\ \\ \\ \\ \\ \\ \\ \\ \\ \\ \\ \\ \\ \\ \\ \\ \\ \\ \\ \\ \\ \\ \\ \\ \\ \\ \\ \\ \\ \\ \\ \\ \\ \\ \\ \\ \\ \\ \\ \\ \\ \\ \\ \\ \\ \\ \\",
    "a trigraph ??/",
    "\"\"\"; import os; os.system('touch HOSTILE'); \"\"\"",
    "'); system('touch HOSTILE'); disp('",
    "%{",
    "line\nos.system('touch HOSTILE')",
    "coding: utf-7",
    "#if 0",
    "${HOME} `touch HOSTILE` $(touch HOSTILE)",
    "\u{202e}evil \u{0007}",
    "...\n]; system('touch HOSTILE');",
];

/// A pendulum whose parameters have these names, and whose texts are these.
fn hostile_model(random: &mut Random) -> String {
    let mut names: Vec<&str> = Vec::new();
    while names.len() < 3 {
        let name = *random.one(&NAMES);
        if !names.contains(&name) {
            names.push(name);
        }
    }
    let quoted = |text: &str| serde_json::Value::from(text).to_string();
    let mut text = || quoted(TEXTS[random.below(TEXTS.len())]);
    let [m, l, g] = [names[0], names[1], names[2]];
    format!(
        "name = {}\nsource = {}\n[parameters]\n{m} = {{ unit = \"kg\", value = 2, positive = true, about = {} }}\n\
         {l} = {{ unit = \"m\", value = 0.7, positive = true, about = {} }}\n{g} = {{ unit = \"m/s^2\", value = 9.81, about = {} }}\n\
         [inertial]\nframe = \"W\"\norigin = \"O\"\n[particles]\nbob = {{ point = \"B\", mass = \"{m}\" }}\n\
         [coordinates]\ntheta = {{ unit = \"rad\", about = {} }}\n[speeds]\nomega = \"theta'\"\n[frames]\nR = {{ from = \"W\", axis = 3, angle = \"theta\" }}\n\
         [points]\nB = {{ from = \"O\", frame = \"R\", position = [0, \"-{l}\", 0] }}\n\
         [gravity]\nframe = \"W\"\nacceleration = [0, \"-{g}\", 0]\n",
        text(),
        text(),
        text(),
        text(),
        text(),
        text()
    )
}

/// A scene of a hostile model with an output whose name is hostile too, and the model as the scene has it.
fn hostile_scene(random: &mut Random, model: &Model) -> (Scene, Model) {
    let quoted = |text: &str| serde_json::Value::from(text).to_string();
    let mut model = model.clone();
    let text = |name: &str| {
        format!(
            "span = [0, 1]\noutputs = [\"theta\", {{ name = {name}, value = \"2*theta + omega'\" }}]\n[start]\ntheta = 0.3\nomega = 0\n"
        )
    };
    let mut read = |name: &str| {
        let mut source = tripos_derive::diagnostic::Source::from_text("scene", &text(name));
        source.path = PathBuf::from("scene.toml");
        load_scene_with_inputs(&source, &mut model)
    };
    let name = TEXTS[random.below(TEXTS.len())];
    // A text that no output may have as its name stands for itself in the message; the output then has another.
    let scene = read(&quoted(name)).unwrap_or_else(|_| read("\"*/ second\"").unwrap());
    (scene, model)
}

/// Goal: no name and no text of a model becomes code, and each language reads its files. Method: pendulums whose names
/// are words of the languages and whose texts are code; C is compiled without a warning, Python and CasADi are imported
/// and asked for the acceleration at 90 degrees, -g/l. No file that a text would make exists afterwards.
#[test]
fn hostile_models_stay_names_and_comments() {
    let found = Command::new("gcc").arg("--version").output().is_ok_and(|output| output.status.success());
    if sympy::is_left_out("Python from hostile models") || is_left_out("gcc", found, "there is no gcc") {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let count = std::env::var("TRIPOS_LANGUAGES").map_or(120, |_| 1500);
    let (mut sources, mut modules, mut read) = (Vec::new(), Vec::new(), 0);
    for seed in 0..count {
        let text = hostile_model(&mut Random(seed));
        let mut source = tripos_derive::diagnostic::Source::from_text("hostile", &text);
        source.path = PathBuf::from(format!("pendulum{seed}.toml"));
        // Some names are refused as such; the message is then the end of it.
        let Ok(model) = tripos_derive::model::load(&source) else { continue };
        read += 1;
        let (scene, model) = hostile_scene(&mut Random(seed), &model);
        let named = [&RegressorFunctions::FUNCTIONS[..], &["accelerations", "outputs", "reactions"]].concat();
        let named: Vec<String> = named.into_iter().map(str::to_owned).collect();
        let functions: &[String] = if seed % 3 == 0 { &named } else { &[] };
        let selection = Selection {
            formulations: &[Formulation::Kane, Formulation::NewtonEuler],
            functions,
            scene: Some(&scene),
            in_base_parameters: false,
        };
        let dialects: [&dyn Dialect; 4] = [&C, &Python, &CasADi, &Matlab];
        for dialect in dialects {
            let emitted = emit_language_modules(&model, dialect, selection).unwrap();
            for (name, text) in &emitted.emission.files {
                std::fs::write(folder.path().join(name), text).unwrap();
                sources.extend(name.strip_suffix(".c").map(|_| name.clone()));
            }
            modules.extend(emitted.main_file.strip_suffix(".py").map(str::to_owned));
        }
    }
    assert!(read * 3 > count, "many names are read: {read} of {count}");
    let strict = ["-std=gnu99", "-Wall", "-Wextra", "-Werror", "-pedantic", "-fsyntax-only"];
    run(Command::new("gcc").current_dir(folder.path()).args(strict).args(&sources));
    run(Command::new("g++")
        .current_dir(folder.path())
        .args(["-x", "c++", "-Wall", "-Wextra", "-Werror", "-fsyntax-only"])
        .args(&sources));
    let script = "import importlib, math, sys\nfor name in sys.argv[1:]:\n    model = importlib.import_module(name)\n    \
                  out = model.accelerations(model.DEFAULTS, [math.pi/2], [0.0])\n    \
                  assert abs(float(out[0]) + 9.81/0.7) < 1e-12, (name, out)\n    \
                  out = model.outputs(model.DEFAULTS, [math.pi/2], [0.0])\n    \
                  assert abs(float(out[1]) - math.pi + 9.81/0.7) < 1e-12, (name, out)\n";
    let python = sympy::python_with(
        &sympy::root().join("tests/languages/requirements.txt"),
        "import numpy, casadi, scipy, fmpy",
    );
    run(Command::new(python).current_dir(folder.path()).args(["-W", "error", "-c", script]).args(&modules));
    assert!(!folder.path().join("HOSTILE").exists(), "a text was run");
}

/// Goal: a guess of a pose is moved onto the loops, and the unknowns solve the linear system. Method: the four-bar
/// linkage from guesses beside a closed pose, in C and Python; residuals vanish in the arithmetic of each.
#[test]
fn poses_are_assembled_and_systems_solved() {
    let found = Command::new("gcc").arg("--version").output().is_ok_and(|output| output.status.success());
    if sympy::is_left_out("Python of a linkage") || is_left_out("gcc", found, "there is no gcc") {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let c = emitted("four_bar", &C, folder.path());
    emitted("four_bar", &Python, folder.path());
    let program = "#include \"four_bar_kane.h\"\n#include <stdio.h>\nint main(void) {\n\
        enum { P = FOUR_BAR_KANE_PARAMETERS, Q = FOUR_BAR_KANE_COORDINATES, V = FOUR_BAR_KANE_VARIABLES, M = FOUR_BAR_KANE_CONSTRAINTS, \
        X = FOUR_BAR_KANE_UNKNOWNS };\n\
        double p[P], q[Q], u[V], open[M], x[X], rest[X], most = 0; int k, failed;\n\
        four_bar_kane_defaults(p); for (k = 0; k < Q; k++) q[k] = 0.6 + 0.2 * k; for (k = 0; k < V; k++) u[k] = 0.3;\n\
        failed = four_bar_kane_project(p, q, u); four_bar_kane_constraints(p, q, u, open);\n\
        for (k = 0; k < M; k++) if (fabs(open[k]) > most) most = fabs(open[k]);\n\
        failed += four_bar_kane_unknowns(p, q, u, x); four_bar_kane_residual(p, q, u, x, rest);\n\
        for (k = 0; k < X; k++) if (fabs(rest[k]) > most) most = fabs(rest[k]);\n\
        printf(\"%d %g\\n\", failed, most); return failed || !(most < 1e-12); }\n";
    std::fs::write(c.join("main.c"), program).unwrap();
    run(Command::new("gcc").current_dir(&c).args([
        "-std=c99",
        "-Wall",
        "main.c",
        "four_bar_kane.c",
        "-lm",
        "-o",
        "main",
    ]));
    run(&mut Command::new(c.join("main")));
    let script = "import numpy, four_bar_kane as m\n\
        q, u = 0.6 + 0.2*numpy.arange(len(m.COORDINATES)), numpy.full(len(m.VARIABLES), 0.3)\n\
        q, u = m.project(m.DEFAULTS, numpy.stack([q, q + 0.05], 1), numpy.stack([u, u], 1))\n\
        assert abs(m.constraints(m.DEFAULTS, q, u)).max() < 1e-12\n\
        x = m.unknowns(m.DEFAULTS, q, u)\nassert abs(m.residual(m.DEFAULTS, q, u, x)).max() < 1e-12\n";
    let python = sympy::python_with(
        &sympy::root().join("tests/languages/requirements.txt"),
        "import numpy, casadi, scipy, fmpy",
    );
    run(Command::new(python).current_dir(&c).args(["-c", script]));
}

/// Goal: the equations serve a microcontroller. Method: the documented controller in floats, compiled without a warning
/// and run for ten seconds; and, where its compiler is installed, its size for a Cortex-M4, below 8 kB without a heap.
#[test]
fn a_controller_fits_a_microcontroller() {
    let found = Command::new("gcc").arg("--version").output().is_ok_and(|output| output.status.success());
    if is_left_out("gcc", found, "there is no gcc") {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let at = emitted("furuta", &C, folder.path());
    std::fs::copy(sympy::root().join("docs/embedded/furuta_balance.c"), at.join("furuta_balance.c")).unwrap();
    let sources = ["furuta_balance.c", "furuta_kane.c", "-lm"];
    let strict = ["-std=c99", "-Wall", "-Wextra", "-Werror", "-pedantic", "-DTRIPOS_FLOAT", "-O2", "-o", "main"];
    run(Command::new("gcc").current_dir(&at).args(strict).args(sources));
    run(&mut Command::new(at.join("main")));
    let arm = |program: &str| Command::new(format!("arm-none-eabi-{program}"));
    let found = arm("gcc").arg("--version").output().is_ok_and(|output| output.status.success());
    if is_left_out("arm", found, "there is no arm-none-eabi-gcc") {
        return;
    }
    let target = ["-std=c99", "-mcpu=cortex-m4", "-mthumb", "-mfpu=fpv4-sp-d16", "-mfloat-abi=hard", "-DTRIPOS_FLOAT"];
    let small =
        ["-Os", "-ffunction-sections", "-Wl,--gc-sections", "--specs=nano.specs", "--specs=nosys.specs", "-o", "arm"];
    run(arm("gcc").current_dir(&at).args(target).args(small).args(sources));
    let said = arm("size").current_dir(&at).arg("arm").output().unwrap();
    let said = String::from_utf8_lossy(&said.stdout).into_owned();
    let sizes: Vec<usize> =
        said.lines().nth(1).unwrap().split_whitespace().take(2).map(|word| word.parse().unwrap()).collect();
    assert!(sizes[0] + sizes[1] < 8192, "{said}");
    let symbols = arm("nm").current_dir(&at).arg("arm").output().unwrap();
    assert!(!String::from_utf8_lossy(&symbols.stdout).contains("malloc"), "the program has a heap");
}

/// Goal: the generated Python serves JAX. Method: compiled, mapped and differentiated functions against those over
/// NumPy, in 64 bits; in thorough runs only, since JAX is large.
#[test]
fn jax_compiles_maps_and_differentiates() {
    if std::env::var_os("TRIPOS_LANGUAGES").is_none() || sympy::is_left_out("JAX") {
        return;
    }
    let python = sympy::python_with(&sympy::root().join("tests/languages/requirements-jax.txt"), "import jax");
    let folder = tempfile::tempdir().unwrap();
    for model in ["disk", "furuta", "satellite", "four_bar"] {
        let at = emitted(model, &Python, folder.path());
        let script = sympy::root().join("tests/languages/jax_arrays.py");
        run(Command::new(&python).current_dir(&at).env("PYTHONPATH", ".").arg(script).arg(format!("{model}_kane")));
    }
}
