//! Measured table of languages, models and functions: errors, times, lines and times of compilers.

use super::{Asked, Dd, asked, calls, emitted, program, run};
use crate::sympy;
use crate::sympy::root;
use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::hint::black_box;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Instant;
use tripos_codegen::languages::Dialect;
use tripos_codegen::languages::c::C;
use tripos_codegen::languages::casadi::CasADi;
use tripos_codegen::languages::matlab::Matlab;
use tripos_codegen::languages::python::Python;
use tripos_codegen::plan::module_name;
use tripos_models::MODELS;
use tripos_traits::{Real, Scalar};

use super::truth::{is_one_function, length, procedure};

/// Page that holds the table.
const PAGE: &str = "docs/languages_table.md";

/// Figures of one function in one language.
#[derive(Clone, Copy, Default)]
struct Cell {
    /// Largest error of an entry beside the largest entry, over the states. `None` if it was not measured.
    error: Option<f64>,
    /// Seconds of a call for one state.
    seconds: Option<f64>,
}

/// Figures of one module.
struct Column {
    title: &'static str,
    lines: usize,
    /// Seconds until the functions can be called, and the work that they go into.
    ready: Option<(&'static str, f64)>,
    /// Figures by names of functions.
    cells: BTreeMap<String, Cell>,
}

/// Evaluated functions of one module.
struct Evaluation {
    /// Values of each function at each state, one after the other.
    values: Vec<f64>,
    /// Seconds until the functions can be called, and the work that they go into.
    ready: Option<(&'static str, f64)>,
    /// Seconds of each function for one state.
    seconds: Vec<f64>,
}

/// One language as the table measures it.
struct Language {
    title: &'static str,
    dialect: &'static dyn Dialect,
    /// Evaluates the functions of a module that stands in a folder, beside the file of states.
    evaluate: fn(&Asked, &Path) -> Evaluation,
}

const LANGUAGES: [Language; 4] = [
    Language { title: "C", dialect: &C, evaluate: by_c },
    Language { title: "NumPy", dialect: &Python, evaluate: |asked, at| by_python("numpy", "", asked, at) },
    Language { title: "Octave", dialect: &Matlab, evaluate: by_octave },
    Language { title: "CasADi", dialect: &CasADi, evaluate: |asked, at| by_python("casadi", "_casadi", asked, at) },
];

fn doubles(path: &Path) -> Vec<f64> {
    let bytes = std::fs::read(path).unwrap();
    bytes.chunks_exact(8).map(|x| f64::from_le_bytes(x.try_into().unwrap())).collect()
}

fn by_c(asked: &Asked, at: &Path) -> Evaluation {
    let stem = asked.stem();
    let header = std::fs::read_to_string(at.join(format!("{stem}.h"))).unwrap();
    let values = super::driver(asked, &header);
    let timed = |(call, _): (String, usize)| {
        format!(
            "  {{ double best = 1e9; int r; for (r = 0; r < 3; r++) {{ double begin = now(), passed; long long count = 0;\n  \
             do {{ for (k = 0; k < states; k++) {{ at(k); {call}; }} count += states; passed = now() - begin; }} \
             while (passed < 5e-3);\n  if (passed / count < best) best = passed / count; }} fwrite(&best, 8, 1, file); }}\n"
        )
    };
    let clock = "static double now(void) { struct timespec t; clock_gettime(CLOCK_MONOTONIC, &t); \
                 return t.tv_sec + 1e-9 * t.tv_nsec; }\n";
    let times = program(&stem, &calls(asked, &header).into_iter().map(timed).collect::<String>());
    let times = times.replacen("int main", &format!("{clock}int main"), 1);
    std::fs::write(at.join("values.c"), values).unwrap();
    std::fs::write(at.join("times.c"), format!("#define _POSIX_C_SOURCE 199309L\n{times}")).unwrap();
    let begin = Instant::now();
    run(Command::new("gcc").current_dir(at).args(["-std=c99", "-O2", "-c", &format!("{stem}.c"), "-o", "own.o"]));
    let compiled = begin.elapsed().as_secs_f64();
    for what in ["values", "times"] {
        let source = format!("{what}.c");
        run(Command::new("gcc").current_dir(at).args(["-std=c99", "-O1", &source, "own.o", "-lm", "-o", what]));
        run(Command::new(at.join(what)).current_dir(at).args(["in", &format!("{what}.out")]));
    }
    Evaluation {
        values: doubles(&at.join("values.out")),
        ready: Some(("compiled", compiled)),
        seconds: doubles(&at.join("times.out")),
    }
}

fn by_python(kind: &str, ending: &str, asked: &Asked, at: &Path) -> Evaluation {
    let python =
        sympy::python_with(&root().join("tests/languages/requirements.txt"), "import numpy, casadi, scipy, fmpy");
    run(Command::new(python)
        .current_dir(at)
        .env("PYTHONPATH", ".")
        .env("PYTHONDONTWRITEBYTECODE", "1")
        .arg(root().join("tests/languages/evaluate.py"))
        .args([kind, &format!("{}{ending}", asked.stem()), "in", "out", &asked.functions.join(","), "times"]));
    let times = doubles(&at.join("times"));
    Evaluation { values: doubles(&at.join("out")), ready: Some(("imported", times[0])), seconds: times[1..].to_vec() }
}

fn by_octave(asked: &Asked, at: &Path) -> Evaluation {
    let file = Matlab.main_file(asked.model, &module_name(asked.system.name));
    let call = format!(
        "addpath('{}'); evaluate('.', '{}', 'in', 'out', '{}', 'times')",
        root().join("tests/languages").display(),
        file.trim_end_matches("_parameters.m"),
        asked.functions.join(",")
    );
    run(Command::new("octave-cli").current_dir(at).args(["--no-init-file", "--eval", &call]));
    let seconds = doubles(&at.join("times"))[1..].to_vec();
    Evaluation { values: doubles(&at.join("out")), ready: None, seconds }
}

/// Functions of the equations that a module has in its language.
fn has(dialect: &dyn Dialect, folder: &Path, model: &str, equations: &str, function: &str) -> bool {
    let name = dialect.main_file(model, &module_name(equations));
    let text = || std::fs::read_to_string(folder.join(&name)).unwrap();
    match Path::new(&name).extension().and_then(|ending| ending.to_str()) {
        Some("py") => text().contains(&format!("def {function}(")),
        Some("m") => folder.join(name.replace("_parameters.m", &format!("_{function}.m"))).is_file(),
        _ => text().contains(&format!("{model}_{}_{function}(", module_name(equations))),
    }
}

/// Largest error beside the largest entry, over the states whose exact values are numbers.
fn error_of(values: &[Vec<f64>], exact: &[Vec<Dd>]) -> f64 {
    let mut most = 0.0_f64;
    for (values, exact) in values.iter().zip(exact) {
        let largest = exact.iter().fold(0.0_f64, |most, x| most.max(x.abs().to_f64()));
        if largest > 0.0 && largest.is_finite() {
            let error = values.iter().zip(exact).map(|(x, e)| (Dd::from(*x) - *e).abs().to_f64());
            most = error.fold(most, |most, error| most.max(error / largest));
        }
    }
    most
}

/// Figures of the compiled Rust.
fn by_rust(asked: &Asked, exact: &BTreeMap<String, Vec<Vec<Dd>>>) -> Column {
    let system = asked.system.double;
    let mut cells = BTreeMap::new();
    for name in &asked.functions {
        let values: Option<Vec<Vec<f64>>> =
            asked.states.iter().map(|state| asked.truth.double(name, &state.plain())).collect();
        let error = values.map(|values| error_of(&values, &exact[name]));
        let seconds = length(system, name).filter(|_| is_one_function(name)).map(|count| {
            let (mut out, fill) = (vec![0.0; count], procedure(name));
            let sample = |_| {
                let (begin, mut calls) = (Instant::now(), 0.0);
                while begin.elapsed().as_secs_f64() < 5e-3 {
                    for s in &asked.states {
                        fill(system, [&s.p, &s.q, &s.v, &s.u, &s.x].map(Vec::as_slice), &mut out);
                        black_box(&mut out);
                        calls += 1.0;
                    }
                }
                begin.elapsed().as_secs_f64() / calls
            };
            (0..3).map(sample).fold(f64::INFINITY, f64::min)
        });
        cells.insert(name.clone(), Cell { error, seconds });
    }
    let path = root()
        .join("generated/src")
        .join(asked.model)
        .join("code")
        .join(format!("{}.rs", module_name(asked.system.name)));
    let lines = std::fs::read_to_string(path).map_or(0, |text| text.lines().count());
    Column { title: "Rust", lines, ready: None, cells }
}

/// Figures of a language.
fn by_language(language: &Language, mut asked: Asked, exact: &BTreeMap<String, Vec<Vec<Dd>>>, folder: &Path) -> Column {
    let dialect = language.dialect;
    asked.functions.retain(|name| has(dialect, folder, asked.model, asked.system.name, name));
    std::fs::write(folder.join("in"), asked.input()).unwrap();
    let Evaluation { values, ready, seconds } = (language.evaluate)(&asked, folder);
    let mut values = values.into_iter();
    let mut cells = BTreeMap::new();
    for (name, seconds) in asked.functions.iter().zip(seconds) {
        let exact = &exact[name];
        let found: Vec<Vec<f64>> = exact.iter().map(|entry| values.by_ref().take(entry.len()).collect()).collect();
        cells.insert(name.clone(), Cell { error: Some(error_of(&found, exact)), seconds: Some(seconds) });
    }
    let main = dialect.main_file(asked.model, &module_name(asked.system.name));
    let stem = main.trim_end_matches("_parameters.m").trim_end_matches(".h").trim_end_matches(".py").to_owned();
    let of_module = |path: &PathBuf| {
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        let name = name.trim_end_matches(".h");
        name.starts_with(&stem) && [".c", ".py", ".m"].iter().any(|end| name.ends_with(end)) || name == stem
    };
    let files = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).filter(of_module);
    let lines = files.map(|path| std::fs::read_to_string(path).unwrap().lines().count()).sum();
    Column { title: language.title, lines, ready, cells }
}

/// Quotient with two digits.
fn quotient(x: f64) -> String {
    if x < 9.95 { format!("{x:.1}") } else { format!("{x:.0}") }
}

/// Seconds with two digits and the unit that suits.
fn duration(seconds: f64) -> String {
    let (unit, scale) = [("s", 1.0), ("ms", 1e3), ("µs", 1e6)]
        .into_iter()
        .find(|(_, scale)| seconds * scale >= 1.0)
        .unwrap_or(("ns", 1e9));
    format!("{} {unit}", quotient(seconds * scale))
}

/// Table of one set of equations.
fn table(asked: &Asked, columns: &[Column]) -> String {
    let mut text = format!("## {} ({})\n\n", asked.model, asked.system.name);
    let titles: Vec<&str> = columns.iter().map(|column| column.title).collect();
    let _ = writeln!(text, "| | {} |\n|---|{}", titles.join(" | "), "---|".repeat(titles.len()));
    let lines: Vec<String> = columns.iter().map(|column| column.lines.to_string()).collect();
    let _ = writeln!(text, "| lines | {} |", lines.join(" | "));
    let ready =
        |column: &Column| column.ready.map_or("–".to_owned(), |(word, s)| format!("{word} in {}", duration(s)));
    let _ = writeln!(text, "| ready | {} |", columns.iter().map(ready).collect::<Vec<_>>().join(" | "));
    for name in &asked.functions {
        let rust = columns[0].cells[name];
        let unit = rust.error.filter(|error| *error > 0.0);
        let cells = columns.iter().enumerate().map(|(at, column)| {
            let Some(cell) = column.cells.get(name) else { return "–".to_owned() };
            let error = cell.error.map(|error| match unit {
                Some(unit) if at > 0 => quotient(error / unit),
                _ if error == 0.0 => "0".to_owned(),
                _ => format!("{} ε", quotient(error / f64::EPSILON)),
            });
            let seconds = cell.seconds.map(|seconds| match rust.seconds {
                Some(unit) if at > 0 => format!("×{}", quotient(seconds / unit)),
                _ => duration(seconds),
            });
            let parts: Vec<String> = [error, seconds].into_iter().flatten().collect();
            if parts.is_empty() { "–".to_owned() } else { parts.join(", ") }
        });
        let _ = writeln!(text, "| `{name}` | {} |", cells.collect::<Vec<_>>().join(" | "));
    }
    text + "\n"
}

/// Goal: figures of every function in every language are measured, not remembered. Method: one set of equations of each
/// model of the library at random states; the page is written anew. It asserts nothing on times, and is run by hand.
#[test]
#[ignore = "measures for ten minutes and writes docs/languages_table.md"]
fn table_of_languages() {
    let folder = tempfile::tempdir().unwrap();
    let emitted = |language: &Language| -> BTreeMap<&str, PathBuf> {
        let folder = folder.path().join(language.title);
        MODELS.iter().map(|model| (model.name, emitted(model.name, language.dialect, &folder))).collect()
    };
    let folders: Vec<BTreeMap<&str, PathBuf>> = LANGUAGES.iter().map(emitted).collect();
    let in_some = |model: &'static str, equations: &str, function: &str| {
        let all = LANGUAGES.iter().zip(&folders);
        all.into_iter().any(|(language, at)| has(language.dialect, &at[model], model, equations, function))
    };
    let mut seen = Vec::new();
    let head = std::fs::read_to_string(root().join(PAGE)).unwrap();
    let mut text = head.split_inclusive('\n').take_while(|line| !line.starts_with("## ")).collect::<String>();
    for asked in asked(&in_some) {
        // The first set of equations of a model is that of Kane's method, if the model has it.
        if seen.contains(&asked.model) {
            continue;
        }
        seen.push(asked.model);
        let exact: BTreeMap<String, Vec<Vec<Dd>>> = asked
            .functions
            .iter()
            .map(|name| {
                let values = asked.states.iter().map(|state| asked.truth.exact(name, &state.extended()).unwrap());
                (name.clone(), values.collect())
            })
            .collect();
        let mut columns = vec![by_rust(&asked, &exact)];
        for (language, at) in LANGUAGES.iter().zip(&folders) {
            columns.push(by_language(language, asked.clone(), &exact, &at[asked.model]));
        }
        text += &table(&asked, &columns);
    }
    std::fs::write(root().join(PAGE), text.trim_end().to_owned() + "\n").unwrap();
}
