//! `tripos derive --format sympy`: a program that SymPy runs, and whose equations are those of JSON.

use crate::support::{root, tripos_in};
use crate::sympy::{is_left_out, python};
use expect_test::expect;
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::Path;
use std::process::Command;
use tripos_derive::algebra::term::steps::Definition;
use tripos_derive::algebra::text::parse::parse_primed;
use tripos_derive::algebra::value::tape::Tape;
use tripos_derive::algebra::{Arena, Expr};

fn derived(model: &str, format: &str) -> String {
    let (status, text, err) = tripos_in(&root(), &["derive", model, "--format", format]);
    assert_eq!(status, 0, "{err}");
    text
}

/// Python code that prints the program's numbers at given values of its symbols, by their names in the program.
const ASK: &str = r"

import json, sys

def numbers(formulation, values):
    known = evaluated(formulation, {globals()[name]: sp.Float(value) for name, value in values.items()})
    one = lambda e: float(sp.sympify(e).xreplace(known))
    matrix = formulation.mass_matrix
    return [one(e) for e in [
        *matrix, *formulation.forcing, formulation.kinetic_energy, formulation.potential_energy, formulation.power,
        *formulation.coordinate_rates, *[symbol for symbol, _ in formulation.accelerations],
    ]]

asked = json.load(open(sys.argv[1]))
print(json.dumps({name: numbers(globals()[name], values) for name, values in asked.items()}))
";

/// A number of a name, between 0.3 and 1.2, which makes no divisor of these models small.
fn number_of(name: &str) -> f64 {
    let hash = name.bytes().fold(2_166_136_261_u32, |hash, b| (hash ^ u32::from(b)).wrapping_mul(16_777_619));
    0.3 + 0.9 * f64::from(hash % 9973) / 9973.0
}

/// A formulation from JSON: a number for each symbol that is not defined in it, and the expected numbers of the
/// program.
fn of_json(formulation: &Value) -> (BTreeMap<String, f64>, Vec<f64>) {
    let mut arena = Arena::new();
    let read = |arena: &mut Arena, text: &Value| -> Expr {
        let text = text.as_str().unwrap();
        let read = parse_primed(arena, text, 2, &mut |arena, name| Ok(arena.symbol(name)));
        read.unwrap_or_else(|error| panic!("{text}: {error:?}"))
    };
    let list = |key: &str| formulation[key].as_array().unwrap().clone();
    let mut steps = Vec::new();
    let mut later: Vec<Expr> =
        list("accelerations").iter().map(|step| arena.symbol(step["name"].as_str().unwrap())).collect();
    for (at, step) in [list("named"), list("accelerations")].concat().iter().enumerate() {
        let value = read(&mut arena, &step["value"]);
        let symbol = arena.symbol(step["name"].as_str().unwrap());
        // Terms of the steps that show accelerations mention these before they are known.
        let is_late = at < list("named").len() && arena.reachable(&[value]).iter().any(|e| later.contains(e));
        if is_late {
            later.push(symbol);
        } else {
            steps.push(Definition { symbol, value });
        }
    }
    let mut outputs: Vec<Value> = list("mass_matrix").iter().flat_map(|row| row.as_array().unwrap().clone()).collect();
    outputs.extend(list("forcing"));
    outputs.extend(["kinetic_energy", "potential_energy", "power"].map(|key| formulation[key].clone()));
    outputs.extend(list("coordinate_rates"));
    let mut outputs: Vec<Expr> = outputs.iter().map(|text| read(&mut arena, text)).collect();
    let solved = list("accelerations").len();
    outputs.extend(steps[steps.len() - solved..].iter().map(|step| step.symbol));
    let all: Vec<Expr> = outputs.iter().copied().chain(steps.iter().map(|step| step.value)).collect();
    let is_defined = |e: &Expr| steps.iter().any(|step| step.symbol == *e);
    let given: Vec<Expr> =
        arena.reachable(&all).into_iter().filter(|e| arena.symbol_name(*e).is_some() && !is_defined(e)).collect();
    let names: Vec<String> = given.iter().map(|e| arena.symbol_name(*e).unwrap().to_owned()).collect();
    let numbers: Vec<f64> = names.iter().map(|name| number_of(name)).collect();
    let tape = Tape::stepwise(&arena, &given, &steps, &outputs).unwrap();
    (names.into_iter().zip(numbers.iter().copied()).collect(), tape.evaluate(&numbers))
}

/// Name, in the Python program, of a name of a model file.
fn variable(name: &str) -> String {
    let stem = name.trim_end_matches('\'');
    format!("{stem}{}", ["", "_dot", "_ddot"][name.len() - stem.len()])
}

/// Runs the program of a model and compares all its numbers with those of JSON; how many.
fn compared(folder: &Path, model: &str, variable: &dyn Fn(&str) -> String) -> usize {
    let script = derived(model, "sympy") + ASK;
    let json: Value = serde_json::from_str(&derived(model, "json")).unwrap();
    let (mut asked, mut expected) = (serde_json::Map::new(), Vec::new());
    for formulation in json["formulations"].as_array().unwrap() {
        let name = formulation["formulation"].as_str().unwrap().replace('-', "_");
        let (values, numbers) = of_json(formulation);
        let values: serde_json::Map<String, Value> =
            values.into_iter().map(|(name, value)| (variable(&name), json!(value))).collect();
        asked.insert(name.clone(), values.into());
        expected.push((name, numbers));
    }
    let (program, values) = (folder.join("it.py"), folder.join("values.json"));
    std::fs::write(&program, script).unwrap();
    std::fs::write(&values, Value::from(asked).to_string()).unwrap();
    let output = Command::new(python()).arg(&program).arg(&values).output().unwrap();
    assert!(output.status.success(), "{model}: {}", String::from_utf8_lossy(&output.stderr));
    let found: Value = serde_json::from_slice(&output.stdout).unwrap();
    let mut count = 0;
    for (name, numbers) in expected {
        let found: Vec<f64> = found[&name].as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect();
        assert_eq!(found.len(), numbers.len(), "{model} {name}");
        let mut wrong = String::new();
        for (at, (found, number)) in found.iter().zip(&numbers).enumerate() {
            // Both round, SymPy in another order; what cancels is of the size of the largest terms, some hundreds here.
            if (found - number).abs() > 1e-9 * number.abs().max(1.0) {
                let _ = writeln!(wrong, "{model} {name} {at}: {found} is not {number}");
            }
        }
        assert!(wrong.is_empty(), "{wrong}");
        count += numbers.len();
    }
    count
}

/// Goal: the programs for SymPy contain the equations. Method: programs of models with loops, constraints, inputs and
/// time, run by SymPy, compared with the formulas of JSON evaluated here: M, f, energies, rates and all accelerations,
/// of each formulation, at numbers of no meaning.
#[test]
fn programs_define_the_equations_of_json() {
    if is_left_out("programs for SymPy") {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let mut count = 0;
    for model in
        ["disk", "pendulum", "cart_pendulum_3", "four_bar", "furuta", "governor", "driven_pendulum", "knife_edge"]
    {
        count += compared(folder.path(), &format!("models/{model}"), &variable);
    }
    assert!(count > 300, "{count}");
}

/// A tree whose terms have names: they are defined in order, and nothing is written out.
#[test]
fn programs_of_large_models_have_steps() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("model.toml");
    std::fs::write(&path, crate::arm::tree_text(5, |i| i / 2, |i| i == 3, crate::arm::Reactions::All)).unwrap();
    let script = derived(path.to_str().unwrap(), "sympy");
    assert!(script.lines().filter(|line| line.starts_with("    (")).count() > 150);
    assert!(script.lines().map(str::len).max().unwrap() < 5000);
    if !is_left_out("programs for SymPy") {
        compared(folder.path(), path.to_str().unwrap(), &variable);
    }
}

/// Goal: any names make a program. Method: parameters called as words of Python, as the module, and as a rate would be.
#[test]
fn names_of_python_are_told_from_symbols() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("model.toml");
    let model = crate::support::SLIDER
        .replace("parameters.m ", "parameters.lambda ")
        .replace("mass = \"m\"", "mass = \"lambda\"");
    let model = model.replace("parameters.k ", "parameters.x_dot ").replace("-k*x", "-x_dot*x");
    std::fs::write(&path, model).unwrap();
    let script = derived(path.to_str().unwrap(), "sympy");
    assert!(
        script.contains("lambda_ = sp.Symbol(\"lambda_\", positive=True)\nx_dot = sp.Symbol(\"x_dot\", real=True)"),
        "{script}"
    );
    if !is_left_out("programs for SymPy") {
        let variable = |name: &str| match name {
            "lambda" => "lambda_".to_owned(),
            "x'" => "x_dot_".to_owned(),
            name => variable(name),
        };
        compared(folder.path(), path.to_str().unwrap(), &variable);
    }
}

#[test]
fn a_pendulum_for_sympy() {
    let (_, script, _) = tripos_in(&root(), &["derive", "models/pendulum", "--by", "kane", "--format", "sympy"]);
    expect![[r#"
        # Pendulum: equations of motion, matrix * unknowns = forcing.
        # Of rates q1' is q1_dot, of q1'' q1_ddot. Terms that stand by a name are in `named`, each after those that it mentions.
        from types import SimpleNamespace

        import sympy as sp

        m = sp.Symbol("m", positive=True)
        l = sp.Symbol("l", positive=True)
        g = sp.Symbol("g", positive=True)
        theta = sp.Symbol("theta", real=True)
        omega = sp.Symbol("omega", real=True)
        omega_dot = sp.Symbol("omega_dot", real=True)

        # Kane's method: a row for each of omega.
        kane = SimpleNamespace()
        kane.named = []
        kane.unknowns = sp.Matrix([omega_dot])
        kane.mass_matrix = sp.Matrix([
            [m*l**2],
        ])
        kane.forcing = sp.Matrix([-m*l*g*sp.sin(theta)])
        kane.coordinates = sp.Matrix([theta])
        kane.coordinate_rates = sp.Matrix([omega])
        kane.kinetic_energy = sp.sympify(m*l**2*omega**2/2)
        kane.potential_energy = sp.sympify(m*l*g*(1 - sp.cos(theta)))
        kane.power = sp.sympify(0)
        kane.singular_where = []
        kane.accelerations = [
            (omega_dot, -g*sp.sin(theta)/l),
        ]


        def evaluated(formulation, values):
            """Values of all symbols: the inputs, named terms, accelerations, and named terms that contain accelerations."""
            values = dict(values)
            for symbol, value in formulation.named + formulation.accelerations + formulation.named:
                values[symbol] = sp.sympify(value).xreplace(values)
            return values
    "#]].assert_eq(&script);
}
