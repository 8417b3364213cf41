//! Numbers with units in formulas, the short form of constraints, and expressions in scenes.

use crate::common::{BASE, edited, errors, read};
use tripos_derive::algebra::text::print::print_text;
use tripos_derive::diagnostic::Source;
use tripos_derive::mechanics::derive_all;
use tripos_derive::{Formulation, Model, scene};

/// M of Kane's equations, with the default values of all parameters put in.
fn matrix(model: &Model) -> Vec<String> {
    let mut derivations = derive_all(model).unwrap();
    let values: Vec<_> = model.parameters.iter().filter_map(|p| Some((p.symbol, p.value.clone()?))).collect();
    let arena = &mut derivations.kinematics.arena;
    let pairs: Vec<_> = values.into_iter().map(|(symbol, value)| (symbol, arena.number(value))).collect();
    let entries = derivations.get(Formulation::Kane).unwrap().matrix.concat();
    let arena = &mut derivations.kinematics.arena;
    let mut put = tripos_derive::algebra::term::calculus::Substitution::new(&pairs);
    let mut shown = |entry| {
        let entry = put.apply(arena, entry);
        print_text(arena, entry)
    };
    entries.into_iter().map(&mut shown).collect()
}

/// Goal: a number with a unit is the parameter with that value. Method: both ways to state a model.
#[test]
fn numbers_with_units_are_parameters() {
    let edits = [
        ("mass = \"m\" }", "mass = \"2000 g\" }"),
        ("\"-length\"", "\"-50 cm\""),
        ("[\"I\", 0, \"I\"]", "[\"0.1 kg*m^2\", 0, \"0.1 kg*m^2\"]"),
        ("\"-g\"", "\"-9.81 m/s^2\""),
    ];
    let stated = read(&edited(&edits, "")).unwrap();
    let names: Vec<&str> = stated.parameters.iter().map(|p| p.name.as_str()).collect();
    assert_eq!(names[4..], ["l_C", "I1", "I2", "m_cart", "a_gravity"], "{names:?}");
    let units: Vec<String> = stated.parameters[4..].iter().map(|p| p.unit.to_string()).collect();
    assert_eq!(units, ["m", "kg*m^2", "kg*m^2", "kg", "m/s^2"]);
    assert_eq!(matrix(&stated), matrix(&read(BASE).unwrap()));
}

/// A name that the file uses anywhere is not given to a number.
#[test]
fn the_name_of_a_number_is_free() {
    let text = edited(&[("mass = \"m\" }", "mass = \"2 kg\" }")], "[expressions]\nm_cart = \"2*m\"\n");
    let names: Vec<String> = read(&text).unwrap().parameters.into_iter().map(|p| p.name).collect();
    assert!(names.contains(&"m_cart1".to_owned()), "{names:?}");
}

#[test]
fn a_number_in_another_unit_is_refused() {
    let said = errors(&edited(&[("mass = \"m\" }", "mass = \"2 m\" }")], "")).to_string();
    assert!(said.contains("the mass of particle `cart` must be in kg, but `2 m` is in m"), "{said}");
    let said = errors(&edited(&[], "[inputs]\nF = { unit = \"N\", value = \"2 m\" }\n")).to_string();
    assert!(said.contains("must be in N, but `2 m` is in m"), "{said}");
}

#[test]
fn an_input_may_carry_its_unit() {
    let model = read(&edited(&[], "[inputs]\nF = { unit = \"N\", value = \"2 kN\" }\n")).unwrap();
    let value = model.parameters.iter().find(|p| p.name == "F").and_then(|p| p.value.clone());
    assert_eq!(value.map(|value| value.to_f64()), Some(2000.0));
}

#[test]
fn a_constraint_may_be_its_equation_alone() {
    let [short, long] = ["\"x = 3 cm\"", "{ equation = \"x = 3 cm\" }"].map(|value| {
        let drop_speed = [("u1 = \"x'\"\n", "")];
        read(&edited(&drop_speed, &format!("[constraints]\nfix = {value}\n"))).unwrap()
    });
    let values = |model: &Model| -> Vec<String> {
        model.constraints.iter().map(|c| format!("{} {}", c.name, print_text(&model.arena, c.value))).collect()
    };
    assert_eq!(values(&short), ["fix l1"]);
    assert_eq!(values(&short), values(&long));
}

/// Goal: expressions of the model are known in starts and outputs. Method: the expression and its formula.
#[test]
fn scenes_know_the_expressions_of_the_model() {
    let mut model = read(&edited(&[], "[expressions]\nhalf = \"length/2\"\nreach = \"x + length*sin(q)\"\n")).unwrap();
    let mut run = |x: &str, output: &str| {
        let source =
            format!("span = [0, 1]\noutputs = [\"{output}\"]\n[start]\nx = \"{x}\"\nq = 0.2\nu1 = 0\nu2 = 0\n");
        scene::load(&Source::from_text("scene.toml", &source), &mut model)
    };
    let scene = run("2*half", "reach").unwrap_or_else(|e| panic!("{e}"));
    assert!((scene.q[0] - 0.5).abs() < 1e-15);
    // An expression of coordinates has no value before the start is known.
    let said = run("reach", "reach").err().map(|e| e.to_string()).unwrap_or_default();
    assert!(said.contains("`reach` cannot stand in a value at the start"), "{said}");
}
