//! `tripos emit --language js`: equations in JavaScript, run in Node.

use crate::left_out::is_left_out;
use crate::support::{root, stderr, tripos_in};
use serde_json::{Value, json};
use std::fmt::Write;
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use tripos::{Overrides, Scene};
use tripos_codegen::js::RUNNERS;
use tripos_codegen::js::emit::emit_javascript_modules;
use tripos_codegen::plan::module_name;
use tripos_derive::{Formulation, Model};
use tripos_models::MODELS;
use tripos_sim::{DORMAND_PRINCE_853, Dynamics};
use tripos_traits::{CompiledSystem, DoubleDouble, Real, Scalar, System};

/// True if Node is installed; if not, the test is counted as left out.
pub fn has_node() -> bool {
    let found = Command::new("node").arg("--version").output().is_ok_and(|output| output.status.success());
    !is_left_out("node", found, "there is no node")
}

/// A script of `tests/javascript` with an argument, given this text.
fn node(script: &str, argument: &Path, given: &str) -> Output {
    let script = root().join("tests/javascript").join(script);
    let mut node = Command::new("node");
    node.arg(script).arg(argument).stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = node.spawn().unwrap();
    child.stdin.take().unwrap().write_all(given.as_bytes()).unwrap();
    child.wait_with_output().unwrap()
}

/// Answers of emitted modules to questions, computed by Node.
pub fn answers(questions: &[Value]) -> Vec<Value> {
    let output = node("equations.mjs", Path::new("-"), &Value::from(questions).to_string());
    assert!(output.status.success(), "{}", stderr(&output));
    serde_json::from_slice(&output.stdout).unwrap()
}

fn emit(model: &Path, out: &Path, more: &[&str]) -> (i32, String, String) {
    let arguments = ["emit", model.to_str().unwrap(), "--out", out.to_str().unwrap(), "--language", "js"];
    tripos_in(&root(), &[&arguments, more].concat())
}

pub fn numbers(value: &Value) -> Vec<f64> {
    let number = |x: &Value| x.as_f64().or_else(|| x.as_str()?.parse().ok()).unwrap_or(f64::NAN);
    value.as_array().map_or_else(|| vec![number(value)], |list| list.iter().map(number).collect())
}

/// A state of a scene, moved by so much of its own size in a direction that the seed says.
pub fn moved(values: &[f64], seed: u32, by: f64) -> Vec<f64> {
    let step = |at: usize| (f64::from(seed) * 0.754_877_666 + at as f64 * 0.569_840_291).fract() - 0.5;
    values.iter().enumerate().map(|(at, x)| x + by * step(at)).collect()
}

/// Parameters, coordinates and motion variables at a state.
struct State {
    p: Vec<f64>,
    q: Vec<f64>,
    v: Vec<f64>,
}

/// States at the start of a library model's first scene, and about it: p, q and v of each.
fn states(name: &str, system: &dyn System<f64>) -> Vec<State> {
    let scenes = std::fs::read_dir(root().join("models").join(name).join("scenes")).unwrap();
    let mut paths: Vec<PathBuf> = scenes.map(|entry| entry.unwrap().path()).collect();
    paths.sort();
    let scene = paths.iter().find_map(|path| Scene::read(path).ok()).unwrap();
    let scene = scene.description();
    let state = |seed: u32| {
        let p: Vec<f64> =
            moved(&scene.parameters, seed, 0.0).iter().map(|x| x * (1.0 + 0.01 * f64::from(seed % 5))).collect();
        let (q, u) = (moved(&scene.q, seed, 0.4), moved(&scene.u, seed + 7, 1.5));
        let mut v = vec![0.0; system.lengths().variables];
        system.motion_variables(&p, &q, &u, &mut v);
        State { p, q, v }
    };
    (0..20).map(state).filter(|state| state.v.iter().all(|x| x.is_finite())).collect()
}

/// Rates, speeds, energies and divisors of compiled equations.
fn compiled(system: &dyn System<f64>, State { p, q, v }: &State) -> Vec<(&'static str, Vec<f64>)> {
    let lengths = system.lengths();
    let (mut q_dot, mut v_dot) = (vec![0.0; lengths.coordinates], vec![0.0; lengths.variables]);
    system.derivative(p, q, v, &mut q_dot, &mut v_dot);
    let mut u = vec![0.0; lengths.speeds];
    system.generalized_speeds(p, q, v, &mut u);
    let mut divisors = vec![0.0; system.divisor_count()];
    system.divisors(p, q, v, &mut divisors);
    let (t, potential) = (system.kinetic_energy(p, q, v), system.potential_energy(p, q));
    let energies = [("t", vec![t]), ("potential", vec![potential])];
    [("q", q_dot), ("v", v_dot.clone()), ("accelerations", v_dot), ("u", u), ("divisors", divisors)]
        .into_iter()
        .chain(energies)
        .collect()
}

/// Rounding error of accelerations in doubles against 32 digits, relative to the largest acceleration.
fn lost(system: &CompiledSystem, State { p, q, v }: &State) -> f64 {
    let wide = |list: &[f64]| list.iter().map(|x| DoubleDouble::from_f64(*x)).collect::<Vec<_>>();
    let mut exact = (wide(q), wide(v));
    system.extended.derivative(&wide(p), &wide(q), &wide(v), &mut exact.0, &mut exact.1);
    let mut own = (q.clone(), v.clone());
    system.double.derivative(p, q, v, &mut own.0, &mut own.1);
    let scale = own.1.iter().fold(f64::MIN_POSITIVE, |m, x| m.max(x.abs()));
    own.1.iter().zip(&exact.1).map(|(a, b)| (a - b.to_f64()).abs() / scale).fold(0.0, f64::max)
}

/// Goal: equations have the same values in both languages. Method: every formulation of every library model at twenty
/// states about its start, compiled equations against Node: rates, energies, speeds and divisors. The bound, relative
/// to the largest of each at a state, is 1e-12, or ten times the rounding error of compiled accelerations against 32
/// digits, where rounding is divided by small pivots. Nine of ten values agree to 64 units in the last place.
#[test]
fn modules_give_what_compiled_equations_give() {
    if !has_node() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let (mut questions, mut expected) = (Vec::new(), Vec::new());
    for model in MODELS {
        let text = Model::read(&root().join("models").join(model.name).join("model.toml")).unwrap();
        let out = folder.path().join(model.name);
        std::fs::create_dir(&out).unwrap();
        for (file, text) in emit_javascript_modules(&text, &[]).unwrap().files {
            std::fs::write(out.join(file), text).unwrap();
        }
        for formulation in Formulation::ALL.map(Formulation::name) {
            let Some(system) = model.systems.iter().find(|system| system.name == formulation) else { continue };
            let states = states(model.name, system.double);
            assert!(states.len() > 10, "{} {formulation}", model.name);
            let file = out.join(format!("{}.mjs", formulation.replace('-', "_")));
            let asked = states.iter().map(|State { p, q, v }| json!({ "p": p, "q": q, "v": v }));
            questions.push(json!({ "module": file, "states": asked.collect::<Vec<_>>() }));
            expected.push((model.name, formulation, system, states));
        }
    }
    assert!(expected.len() > 60, "{} sets of equations", expected.len());
    let (mut all, mut loose, mut wrong) = (0, 0, String::new());
    for ((name, formulation, system, states), answer) in expected.iter().zip(answers(&questions)) {
        for (state, found) in states.iter().zip(answer.as_array().unwrap()) {
            let lost = 10.0 * lost(system, state);
            for (what, values) in compiled(system.double, state) {
                let found = numbers(&found[what]);
                let scale = values.iter().fold(f64::MIN_POSITIVE, |m, x| m.max(x.abs()));
                let off = found.iter().zip(&values).map(|(a, b)| (a - b).abs() / scale);
                let off = off.fold(0.0, |m: f64, x| if x.is_nan() { x } else { m.max(x) });
                (all, loose) = (all + 1, loose + usize::from(off.is_nan() || off > 64.0 * f64::EPSILON));
                if found.len() != values.len() || off.is_nan() || off > lost.max(1e-12) {
                    let _ = writeln!(wrong, "{name} {formulation} {what}: {off:e}: {found:?}, {values:?}");
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong}");
    assert!(10 * loose < all, "{loose} of {all} beyond 64 units in the last place");
}

/// Goal: equations that run as printed are solved right. Method: the printed systems of the disk at twenty states,
/// whose linear systems Node solves, against the pivoted solve of Rust; to 1e-9 of the largest, since their matrices
/// are ill-conditioned as printed.
#[test]
fn printed_equations_are_solved_as_in_rust() {
    if !has_node() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    assert_eq!(emit(&root().join("models/disk"), folder.path(), &[]).0, 0);
    let disk = MODELS.iter().find(|model| model.name == "disk").unwrap();
    let printed: Vec<_> = disk.systems.iter().filter(|system| !system.double.has_accelerations()).collect();
    assert!(printed.len() > 3, "{} printed systems", printed.len());
    let states: Vec<_> = printed.iter().map(|system| states("disk", system.double)).collect();
    let questions = printed.iter().zip(&states).map(|(system, states)| {
        let asked = states.iter().map(|State { p, q, v }| json!({ "p": p, "q": q, "v": v }));
        json!({ "module": folder.path().join(format!("{}.mjs", module_name(system.name))), "states": asked.collect::<Vec<_>>() })
    });
    let answers = answers(&questions.collect::<Vec<_>>());
    for ((system, states), answer) in printed.iter().zip(&states).zip(&answers) {
        for (State { p, q, v }, found) in states.iter().zip(answer.as_array().unwrap()) {
            let unknowns = Dynamics::new(system.double, p).unwrap().unknowns(q, v).unwrap().to_vec();
            let found = numbers(&found["accelerations"]);
            let scale = unknowns[..v.len()].iter().fold(1.0, |m: f64, x| m.max(x.abs()));
            let off = found.iter().zip(&unknowns).map(|(a, b)| (a - b).abs() / scale).fold(0.0, f64::max);
            assert!(found.len() == v.len() && off < 1e-9, "{}: {off:e} {found:?} {unknowns:?}", system.name);
        }
    }
}

/// Goal: the method in JavaScript is DOP853, and stops where it must. Method: `tests/javascript/method.mjs`, closed
/// forms.
#[test]
fn the_method_holds_against_closed_forms() {
    if !has_node() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let (code, said, error) = emit(&root().join("models/pendulum"), folder.path(), &["--formulation", "kane"]);
    assert_eq!(
        (code, said.as_str()),
        (0, "written    constraints.mjs\nwritten    dop853.mjs\nwritten    kane.mjs\nwritten    run.mjs\n"),
        "{error}"
    );
    assert!(error.contains("import * as model from './kane.mjs'"), "{error}");
    let output = node("method.mjs", folder.path(), "");
    assert!(output.status.success(), "{}", stderr(&output));
    assert_eq!(String::from_utf8_lossy(&output.stdout).matches(": held").count(), 7);
}

/// Goal: both languages have the same coefficients. Method: every published one, as the double that Rust has, is in the
/// text of the method in JavaScript.
#[test]
fn the_method_has_the_published_coefficients() {
    let (_, text) = RUNNERS.into_iter().find(|(name, _)| *name == "dop853").unwrap();
    let p = DORMAND_PRINCE_853;
    let rows = p.a.into_iter().chain(p.dense).chain([p.error5, p.error3]);
    for (stage, coefficient) in rows.flatten() {
        assert!(text.contains(&format!("[{stage}, {:?}]", coefficient.value)), "{stage}: {:?}", coefficient.value);
    }
}

/// Goal: a run of the disk is that of Rust. Method: one second from the report's start, by both at 1e-13, to 1e-9, and
/// ten of another to 1e-8; and where the disk lies flat, both end.
#[test]
fn a_run_of_the_disk_is_that_of_rust() {
    if !has_node() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    assert_eq!(emit(&root().join("models/disk"), folder.path(), &["--formulation", "kane"]).0, 0);
    let scenes = ["report", "lean", "flat-fall"];
    let runs = scenes.map(|name| {
        let scene = Scene::read(root().join(format!("models/disk/scenes/{name}.toml"))).unwrap().with_compiled_equations(MODELS);
        let until = if name == "report" { Some(1.0) } else { None };
        let by = Some("kane".into());
        let method = Some(tripos::Method::Dop853.into());
        let how = Overrides { by, method, rtol: Some(1e-13), atol: Some(1e-13), until, ..Overrides::default() };
        let run = scene.simulate(&how).unwrap();
        let start = scene.description();
        let asked = json!({ "p": start.parameters, "q": start.q, "u": start.u, "span": [start.span.0, until.unwrap_or(start.span.1)],
                            "rtol": 1e-13, "atol": 1e-13 });
        (run, json!({ "module": folder.path().join("kane.mjs"), "run": asked }))
    });
    let answers = answers(&runs.iter().map(|(_, asked)| asked.clone()).collect::<Vec<_>>());
    for ((name, (run, _)), answer) in scenes.iter().zip(&runs).zip(&answers) {
        let (t, y) = (answer["t"].as_f64().unwrap(), numbers(&answer["y"]));
        let apart = run.end.iter().zip(&y).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!((t - run.solution.t_end).abs() < 1e-9, "{name}: {answer} {}", run.ending);
        let bound = if y.len() == 10 && t > 1.0 { 1e-8 } else { 1e-9 };
        assert!(run.end.len() == y.len() && apart < bound, "{name}: {apart:e} {answer} {:?}", run.end);
    }
}

/// Goal: the examples of the documentation run. Method: the examples of docs/generated.md beside the modules of a
/// pendulum and of a four-bar linkage, with one more line that prints where they end: the pendulum of 1 m with the
/// energy that it had, and the linkage closed.
#[test]
fn examples_of_the_documentation_run() {
    if !has_node() {
        return;
    }
    let text = std::fs::read_to_string(root().join("docs/generated.md")).unwrap();
    let blocks: Vec<&str> = text.split("```js\n").skip(1).map(|rest| rest.split("```").next().unwrap()).collect();
    let cases = [
        ("pendulum", "[t.length, stop.kind, ...y[100]]"),
        ("four_bar", "[end.t, q[0], ...model.constraints(model.DEFAULTS, end.y.slice(0, 3), end.y.slice(3))]"),
    ];
    assert_eq!(blocks.len(), cases.len());
    let ends = blocks.iter().zip(cases).map(|(block, (model, told))| {
        let folder = tempfile::tempdir().unwrap();
        assert_eq!(emit(&root().join("models").join(model), folder.path(), &[]).0, 0);
        let file = folder.path().join("example.mjs");
        std::fs::write(&file, format!("{block}console.log(JSON.stringify({told}));\n")).unwrap();
        let output = Command::new("node").arg(&file).output().unwrap();
        assert!(output.status.success(), "{}", stderr(&output));
        serde_json::from_slice::<Value>(&output.stdout).unwrap()
    });
    let ends: Vec<Value> = ends.collect();
    assert_eq!((&ends[0][0], &ends[0][1]), (&json!(101), &json!("end")));
    let energy = |theta: f64, omega: f64| omega * omega / 2.0 - 9.81 * theta.cos();
    let [theta, omega] = [2, 3].map(|at| ends[0][at].as_f64().unwrap());
    assert!((energy(theta, omega) - energy(2.0, 0.0)).abs() < 1e-7, "{}", ends[0]);
    let linkage = numbers(&ends[1]);
    assert!(linkage[..2] == [3.0, 0.5] && linkage[2..].iter().all(|x| x.abs() < 1e-14), "{linkage:?}");
}

/// A model whose names all mean something in JavaScript, with words that would end a comment, a text or a script: a
/// mass on a damped spring, with `await` as its coordinate.
const HOSTILE: &str = r#"
name = '''*/ </script><script>alert(1)</script> ${x} ` " \'''
[parameters]
class = { unit = "kg", value = 2, positive = true, about = '''*/ alert(1) // <!-- --> </script>''' }
arguments = { unit = "N/m", value = 3 }
Math = { unit = "N*s/m", value = 0.5 }
p = { unit = "N", value = 0.25 }
NaN = { unit = "N/m^3", value = 1 }
[coordinates]
await = { unit = "m", about = '''</script> */''' }
[speeds]
yield = "await'"
[inertial]
frame = "eval"
origin = "let"
[points]
static = { from = "let", frame = "eval", position = ["await", 0, 0] }
[particles]
new = { point = "static", mass = "class" }
[forces.delete]
on = "new"
at = "static"
frame = "eval"
vector = ["p - arguments*await - Math*yield - NaN*await^3", 0, 0]
[domain]
undefined = "await + p/arguments > 0"
"#;

/// Goal: no text of a file becomes code, and no name is a word of the language. Method: accelerations of the model
/// above in closed form; and no module contains a text that could end a comment or an element `script`.
#[test]
fn hostile_names_and_texts_stay_what_they_are() {
    let folder = tempfile::tempdir().unwrap();
    let model = folder.path().join("model.toml");
    std::fs::write(&model, HOSTILE).unwrap();
    let out = folder.path().join("out");
    let (code, _, error) = emit(&model, &out, &[]);
    assert_eq!(code, 0, "{error}");
    for file in ["kane.mjs", "lagrange.mjs", "newton_euler.mjs"] {
        let text = std::fs::read_to_string(out.join(file)).unwrap();
        assert!(
            !text.contains("</") && !text.contains("<!") && !text.contains("-->") && !text.contains("<script"),
            "{text}"
        );
        let comments_hold = text
            .lines()
            .filter(|line| line.contains("alert"))
            .all(|line| line.starts_with("//") || line.starts_with("export const TITLE = \""));
        assert!(comments_hold, "{text}");
    }
    if !has_node() {
        return;
    }
    let (q, v) = (0.7, -0.3);
    let state = json!([{ "p": [2, 3, 0.5, 0.25, 1], "q": [q], "v": [v] }]);
    let files = ["kane.mjs", "lagrange.mjs", "newton_euler.mjs"]
        .map(|file| json!({ "module": out.join(file), "states": state }));
    for answer in answers(&files) {
        let expected = (0.25 - 3.0 * q - 0.5 * v - q * q * q) / 2.0;
        assert!((numbers(&answer[0]["v"])[0] - expected).abs() < 1e-15, "{answer}");
        assert!((numbers(&answer[0]["conditions"])[0] - q - 0.25 / 3.0).abs() < 1e-15, "{answer}");
        assert_eq!(answer[0]["names"][0], json!(["class", "arguments", "Math", "p", "NaN"]), "{answer}");
        assert!(answer[0]["names"][3].as_str().unwrap().starts_with("*/ </script>"), "{answer}");
    }
}

/// Goal: files of two languages stand side by side in one folder, and wrong requests are answered. Method: both in one
/// folder, each again; an unknown language.
#[test]
fn languages_leave_one_another_alone() {
    let folder = tempfile::tempdir().unwrap();
    let (model, out) = (root().join("models/pendulum"), folder.path().join("swing"));
    assert_eq!(tripos_in(&root(), &["emit", model.to_str().unwrap(), "--out", out.to_str().unwrap()]).0, 0);
    let (code, said, _) = emit(&model, &out, &[]);
    assert!(code == 0 && !said.contains("removed"), "{said}");
    let (code, said, _) = emit(&model, &out, &["--formulation", "lagrange"]);
    assert_eq!(
        (code, said.as_str()),
        (
            0,
            "unchanged  constraints.mjs\nunchanged  dop853.mjs\nunchanged  lagrange.mjs\nunchanged  run.mjs\nkept       kane.mjs\nkept       newton_euler.mjs\n"
        )
    );
    assert!(out.join("kane.rs").is_file());
    std::fs::write(out.join("kane.mjs"), "// Mine.\n").unwrap();
    let (code, _, error) = emit(&model, &out, &[]);
    assert!(code == 2 && error.contains("was not written by `tripos emit`"), "{error}");
    let arguments = ["emit", model.to_str().unwrap(), "--out", out.to_str().unwrap(), "--language", "javascript"];
    let (code, _, error) = tripos_in(&root(), &arguments);
    assert!(code == 2 && error.contains("equations are not written in `javascript`"), "{error}");
}
