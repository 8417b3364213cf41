//! One name, one meaning: what the command prints is evaluated from its text alone, and held against the equations.
//!
//! Method: formulas are read from the output of `derive`, `prove` and `check` as a stranger reads them, with no other
//! values than those of the model's own symbols at a random state. A name must be defined in the document that it
//! stands in, and must have one value in all documents about a model. The values are held against those of the derived
//! terms, which are evaluated through their names; and what is printed as conserved must be constant along the motion
//! that the printed equations give.

use crate::support::{answer, root};
use nalgebra::{DMatrix, DVector};
use serde_json::Value;
use std::collections::BTreeMap;
use std::path::Path;
use tripos_derive::algebra::text::parse::parse_primed;
use tripos_derive::algebra::value::tape::Tape;
use tripos_derive::algebra::{Arena, Expr, Rational};
use tripos_derive::diagnostic::Source;
use tripos_derive::mechanics::{derive, derive_all};
use tripos_derive::prove::prove;
use tripos_derive::{Formulation, Model};

/// Values of symbols, by name.
type Values = BTreeMap<String, f64>;

/// A generator of numbers that are the same on every machine (G. Marsaglia 2003, xorshift64*).
struct Chance(u64);

impl Chance {
    /// Between 0.2 and 1.2.
    fn draw(&mut self) -> f64 {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        let bits = self.0.wrapping_mul(0x2545_F491_4F6C_DD1D) >> 40;
        f64::from(u32::try_from(bits).unwrap()) / f64::from(1_u32 << 24) + 0.2
    }
}

/// A formula in the names of a document.
struct Formula {
    tape: Tape<f64>,
    symbols: Vec<String>,
}

impl Formula {
    fn read(text: &str) -> Self {
        let mut arena = Arena::new();
        let mut symbols: Vec<(String, Expr)> = Vec::new();
        let e = parse_primed(&mut arena, text, 2, &mut |arena, name| {
            let symbol = arena.symbol(name);
            if !symbols.iter().any(|(known, _)| known == name) {
                symbols.push((name.to_owned(), symbol));
            }
            Ok(symbol)
        });
        let e = e.unwrap_or_else(|error| panic!("{text}: {error:?}"));
        let (symbols, inputs): (Vec<String>, Vec<Expr>) = symbols.into_iter().unzip();
        Self { tape: Tape::new(&arena, &inputs, &[e]).unwrap(), symbols }
    }

    /// Its value; nothing if a name has none.
    fn value(&self, values: &Values) -> Option<f64> {
        let inputs: Option<Vec<f64>> = self.symbols.iter().map(|name| values.get(name).copied()).collect();
        Some(self.tape.evaluate(&inputs?)[0])
    }
}

fn is_close(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-7 * (1.0 + a.abs().max(b.abs())) || (!a.is_finite() && !b.is_finite())
}

/// Content of a document: definitions, and formulas with their quantities.
#[derive(Default)]
struct Document {
    what: String,
    definitions: Vec<(String, Formula)>,
}

impl Document {
    fn new(what: &str) -> Self {
        Self { what: what.to_owned(), ..Self::default() }
    }

    fn define(&mut self, name: &str, formula: &str) {
        self.definitions.push((name.to_owned(), Formula::read(formula)));
    }

    /// Pairs under a key, as a list of `name` and `value` or as an object.
    fn define_all(&mut self, list: &Value) {
        for entry in list.as_array().into_iter().flatten() {
            self.define(entry["name"].as_str().unwrap(), entry["value"].as_str().unwrap());
        }
        for (name, formula) in list.as_object().into_iter().flatten() {
            self.define(name, formula.as_str().unwrap());
        }
    }

    /// The values of all names; panics if one is not defined, or has two.
    fn names(&self, state: &Values) -> Values {
        let mut known = state.clone();
        let mut open: Vec<&(String, Formula)> = self.definitions.iter().collect();
        while !open.is_empty() {
            let before = open.len();
            open.retain(|(name, formula)| {
                let Some(value) = formula.value(&known) else { return true };
                if let Some(other) = known.insert(name.clone(), value) {
                    assert!(is_close(value, other), "{}: `{name}` is {other} and {value}", self.what);
                }
                false
            });
            let lacks = |(_, formula): &(String, Formula)| {
                formula.symbols.iter().find(|symbol| !known.contains_key(*symbol)).cloned().unwrap_or_default()
            };
            assert!(
                open.len() < before,
                "{}: `{}` needs `{}`, which is defined nowhere",
                self.what,
                open[0].0,
                lacks(open[0])
            );
        }
        known
    }

    /// The value of a formula of the document.
    fn value(&self, formula: &str, names: &Values) -> f64 {
        let formula = Formula::read(formula);
        let value = formula.value(names);
        value.unwrap_or_else(|| panic!("{}: {:?} are not all defined", self.what, formula.symbols))
    }
}

/// The values of terms of an arena at a state.
fn meaning(arena: &Arena, terms: &[Expr], state: &Values) -> Vec<f64> {
    let symbols = arena.reachable(terms).into_iter().filter(|e| arena.symbol_name(*e).is_some());
    let symbols: Vec<Expr> = symbols.collect();
    let inputs: Vec<f64> = symbols.iter().map(|e| state[arena.symbol_name(*e).unwrap()]).collect();
    Tape::new(arena, &symbols, terms).unwrap().evaluate(&inputs)
}

/// Values of every symbol of a model: coordinates and speeds as given, rates by the kinematic equations, the others
/// random.
fn state(model: &Model, chance: &mut Chance, q: &[f64], u: &[f64]) -> Values {
    let mut values = Values::new();
    for p in &model.parameters {
        values.insert(
            p.name.clone(),
            // Integrals may divide by what is zero by default, such as a motor's torque.
            p.value.as_ref().filter(|value| !value.is_zero()).map_or_else(|| chance.draw(), Rational::to_f64),
        );
    }
    values.extend(model.coordinates.iter().map(|c| c.name.clone()).zip(q.iter().copied()));
    values.extend(model.speeds.iter().map(|s| s.name.clone()).zip(u.iter().copied()));
    let rates = meaning(&model.arena, &model.kinematic_equations.rates, &values);
    values.extend(model.coordinates.iter().map(|c| format!("{}'", c.name)).zip(rates));
    let seconds = model.coordinates.iter().map(|c| format!("{}''", c.name));
    let others = seconds.chain(model.speeds.iter().map(|s| format!("{}'", s.name)));
    values.extend(others.map(|name| (name, chance.draw())));
    values
}

fn json_of(arguments: &[&str]) -> Value {
    let (status, out, err) = answer(arguments);
    assert!(status < 2, "{arguments:?}: {err}");
    serde_json::from_str(&out).unwrap()
}

/// One formulation as JSON.
struct Printed {
    document: Document,
    value: Value,
}

impl Printed {
    fn list(&self, key: &str, names: &Values) -> Vec<f64> {
        self.value[key].as_array().unwrap().iter().map(|e| self.document.value(e.as_str().unwrap(), names)).collect()
    }

    fn rows(&self, key: &str, names: &Values) -> Vec<Vec<f64>> {
        let row = |row: &Value| {
            let entries = row.as_array().unwrap().iter();
            entries.map(|e| self.document.value(e.as_str().unwrap(), names)).collect()
        };
        self.value[key].as_array().unwrap().iter().map(row).collect()
    }
}

/// The formulas of a formulation hold what the derived terms are worth.
fn held_against_equations(model: &Model, printed: &Printed, state: &Values) -> Values {
    let name = printed.value["formulation"].as_str().unwrap();
    let derivation = derive(model, Formulation::from_name(name).unwrap()).unwrap();
    let (arena, e) = (&derivation.arena, &derivation.equations);
    let names = printed.document.names(state);
    let same = |what: &str, printed: &[f64], terms: &[Expr]| {
        for (at, (a, b)) in printed.iter().zip(meaning(arena, terms, state)).enumerate() {
            assert!(is_close(*a, b), "{} {name} {what} {at}: printed {a}, derived {b}", model.title);
        }
    };
    for (printed, derived) in printed.rows("mass_matrix", &names).iter().zip(&e.matrix) {
        same("matrix", printed, derived);
    }
    same("forcing", &printed.list("forcing", &names), &e.forcing);
    same("rates", &printed.list("coordinate_rates", &names), &e.coordinate_rates);
    for (key, term) in
        [("kinetic_energy", e.kinetic_energy), ("potential_energy", e.potential_energy), ("power", e.power)]
    {
        same(key, &[printed.document.value(printed.value[key].as_str().unwrap(), &names)], &[term]);
    }
    names
}

/// A name has one value in all documents.
fn agree(all: &mut Values, document: &Document, names: &Values, state: &Values) {
    for (name, _) in document.definitions.iter().filter(|(name, _)| !state.contains_key(name)) {
        let value = names[name];
        let known = *all.entry(name.clone()).or_insert(value);
        assert!(is_close(value, known), "{}: `{name}` is {value}, and {known} in another document", document.what);
    }
}

/// Every formulation as JSON, what is proved of it and what `check` says; all documents agree.
fn documents(model: &Model, path: &str, state: &Values) -> (Vec<Printed>, Printed) {
    let mut all = Values::new();
    let derived = json_of(&["derive", path, "--format", "json"]);
    let mut formulations = Vec::new();
    for value in derived["formulations"].as_array().unwrap() {
        let mut document = Document::new(&format!("derive {path}, {}", value["formulation"]));
        document.define_all(&value["named"]);
        let printed = Printed { document, value: value.clone() };
        let names = held_against_equations(model, &printed, state);
        agree(&mut all, &printed.document, &names, state);
        for step in value["steps"].as_array().unwrap() {
            for line in step["lines"].as_array().unwrap() {
                printed.document.value(line["value"].as_str().unwrap(), &names);
            }
        }
        let mut solved = Document::new(&format!("{} accelerations", printed.document.what));
        solved.define_all(&value["named"]);
        for step in value["accelerations"].as_array().unwrap() {
            let name = step["name"].as_str().unwrap();
            if !state.contains_key(name) {
                solved.define(name, step["value"].as_str().unwrap());
            }
        }
        let names = solved.names(state);
        agree(&mut all, &solved, &names, state);
        formulations.push(printed);
    }
    let value = json_of(&["prove", path, "--json"]);
    let mut document = Document::new(&format!("prove {path}"));
    document.define_all(&value["names"]);
    let proved = Printed { document, value };
    let names = proved.document.names(state);
    agree(&mut all, &proved.document, &names, state);
    let value = json_of(&["check", path, "--json"]);
    let mut document = Document::new(&format!("check {path}"));
    document.define_all(&value["names"]);
    for note in value["notes"].as_array().unwrap() {
        if let Some(rate) = note.as_str().unwrap().strip_prefix("T + V changes at the rate ") {
            let names = document.names(state);
            let (power, printed) = (document.value(rate, &names), &formulations[0]);
            let expected =
                printed.document.value(printed.value["power"].as_str().unwrap(), &printed.document.names(state));
            assert!(is_close(power, expected), "{}: the power is {power} and {expected}", document.what);
        }
    }
    agree(&mut all, &document, &document.names(state), state);
    (formulations, proved)
}

/// d/dt of each printed integral along the motion of the printed equations by Kane, by differences, beside the size of
/// its slopes.
fn rates_of_integrals(
    model: &Model,
    kane: &Printed,
    proved: &Printed,
    chance: &mut Chance,
    q: &[f64],
    u: &[f64],
) -> Vec<(f64, f64)> {
    let at = state(model, chance, q, u);
    let names = kane.document.names(&at);
    let rows = kane.rows("mass_matrix", &names);
    let n = rows.len();
    let matrix = DMatrix::from_fn(n, n, |i, j| rows[i][j]);
    let forcing = DVector::from_vec(kane.list("forcing", &names));
    let accelerations = matrix.lu().solve(&forcing).expect("a regular matrix");
    let rates = kane.list("coordinate_rates", &names);
    let mut values = |step: f64| {
        let moved = |x: &[f64], v: &[f64]| x.iter().zip(v).map(|(x, v)| x + step * v).collect::<Vec<f64>>();
        let mut state = state(model, chance, &moved(q, &rates), &moved(u, accelerations.as_slice()));
        for p in &model.parameters {
            state.insert(p.name.clone(), at[&p.name]);
        }
        let names = proved.document.names(&state);
        let integrals = proved.value["integrals"].as_array().unwrap().iter();
        integrals.map(|i| proved.document.value(i["expression"].as_str().unwrap(), &names)).collect::<Vec<f64>>()
    };
    let h = 1e-4;
    let (before, after, here) = (values(-h), values(h), values(0.0));
    let size = 1.0 + accelerations.amax() + rates.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    before.iter().zip(after).zip(here).map(|((a, b), c)| ((b - a) / (2.0 * h), size * size * (1.0 + c.abs()))).collect()
}

fn model_of(path: &Path) -> Model {
    tripos_derive::model::load(&Source::read(path).unwrap()).unwrap()
}

/// All documents about a model, from their text alone.
fn check(path: &Path) {
    let model = model_of(path);
    let mut chance = Chance(20_261_126);
    let mut draw = |count: usize| (0..count).map(|_| chance.draw()).collect::<Vec<f64>>();
    let (q, u) = (draw(model.coordinates.len()), draw(model.speeds.len()));
    let at = state(&model, &mut chance, &q, &u);
    let (formulations, proved) = documents(&model, path.to_str().unwrap(), &at);
    // The integrals as they were found, evaluated through their names.
    let mut derivations = derive_all(&model).unwrap();
    let proof = prove(&model, &mut derivations);
    let names = proved.document.names(&at);
    for (printed, found) in proved.value["integrals"].as_array().unwrap().iter().zip(&proof.integrals) {
        let value = proved.document.value(printed["expression"].as_str().unwrap(), &names);
        let derived = meaning(&derivations.kinematics.arena, &[found.expression], &at)[0];
        assert!(is_close(value, derived), "{}: {} is printed {value}, and {derived}", model.title, printed["name"]);
    }
    if model.motion_constraints.is_empty() {
        let rates = rates_of_integrals(&model, &formulations[0], &proved, &mut chance, &q, &u);
        for (integral, (rate, size)) in proved.value["integrals"].as_array().unwrap().iter().zip(rates) {
            assert!(rate.abs() < 1e-5 * size, "{}: {} changes at the rate {rate}", model.title, integral["name"]);
        }
    }
}

/// Goal: whatever the library's models are called and name, their documents can be used by who has nothing but them.
#[test]
fn printed_formulas_of_the_library_are_worth_what_is_derived() {
    let folders = std::fs::read_dir(root().join("models")).unwrap();
    let mut models: Vec<_> = folders.map(|entry| entry.unwrap().path().join("model.toml")).collect();
    models.sort();
    // What is derived of the bicycle and of loops in space is long: it is read once, by all formulations together.
    for model in models {
        check(&model);
    }
}

/// Goal: printed formulas have the derived values also in models with many equal names. Method: a chain of rods with
/// relative angles, absolute speeds and dampers, and gears in a housing on a ball joint.
#[test]
fn printed_formulas_of_models_with_many_names_are_worth_what_is_derived() {
    let folder = tempfile::tempdir().unwrap();
    for (name, text) in [("rods.toml", RODS), ("bevel.toml", BEVEL)] {
        let path = folder.path().join(name);
        std::fs::write(&path, text).unwrap();
        check(&path);
    }
}

const RODS: &str = r#"
name = "Rods with relative angles and absolute speeds"
counts.n = 6
parameters.g = { unit = "m/s^2", value = 9.81, positive = true }
parameters.c = { unit = "N*m*s", value = 0.05 }
parameters."m{i in 1..n}" = { unit = "kg", value = 0.7, positive = true }
parameters."l{i in 1..n}" = { unit = "m", value = 0.5, positive = true }
inertial = { frame = "N", origin = "O" }
gravity = { frame = "N", acceleration = [0, "-g", 0] }
[speeds]
u1 = "q1'"
u2 = "q1' + q2'"
u3 = "q1' + q2' + q3'"
u4 = "q1' + q2' + q3' + q4'"
u5 = "q1' + q2' + q3' + q4' + q5'"
u6 = "q1' + q2' + q3' + q4' + q5' + q6'"
[bodies."rod{i in 1..n}"]
mass = "m{i}"
inertia = "m{i}*l{i}^2/12"
[joints]
pin1 = { kind = "pin", body = "rod1", centre = [0, "-l1/2", 0], coordinates = ["q1"], speeds = [] }
"pin{i in 2..n}" = { kind = "pin", body = "rod{i}", to = "rod{i-1}", at = [0, "-l{i-1}", 0], centre = [0, "-l{i}/2", 0], coordinates = ["q{i}"], speeds = [] }
[torques]
d1 = { on = "rod1", frame = "N", vector = [0, 0, "-c*q1'"] }
"d{i in 2..n}" = { on = "rod{i}", against = "rod{i-1}", frame = "N", vector = [0, 0, "-c*q{i}'"] }
"#;

const BEVEL: &str = r#"
name = "Bevel gears in a housing on a ball joint"
[parameters]
Ih1 = "0.05 kg*m^2"
Ih2 = "0.06 kg*m^2"
Ih3 = "0.08 kg*m^2"
A1 = "0.004 kg*m^2"
B1 = "0.003 kg*m^2"
A2 = "0.02 kg*m^2"
B2 = "0.012 kg*m^2"
k = { unit = "1", value = 3 }
T0 = "0.2 N*m"
[inertial]
frame = "N"
origin = "O"
[bodies]
housing = { mass = 0, inertia = { diagonal = ["Ih1","Ih2","Ih3"] } }
fast = { mass = 0, inertia = { diagonal = ["A1","B1","B1"] } }
slow = { mass = 0, inertia = { diagonal = ["B2","A2","B2"] } }
[joints]
ball = { kind = "ball", sequence = "euler", body = "housing", coordinates = ["e0","e1","e2","e3"], speeds = ["w1","w2","w3"] }
j1 = { kind = "pin", axis = 1, body = "fast", to = "housing", coordinates = ["p1"], speeds = [] }
j2 = { kind = "pin", axis = 2, body = "slow", to = "housing", coordinates = ["p2"], speeds = ["u2"] }
[constraints]
gear = { equation = "p1 = k*p2" }
[torques.motor]
on = "fast"
against = "housing"
frame = "housing_frame"
vector = ["T0", 0, 0]
"#;
