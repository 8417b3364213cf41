//! Models that look odd and are right.

#![allow(clippy::needless_raw_string_hashes, reason = "expect-test writes them")]

use crate::common;

use common::{BASE, edited, read};
use tripos_derive::algebra::text::print::print_text;
use tripos_derive::{Formulation, derive};

fn accepted(model: &str) {
    let model = read(model).unwrap_or_else(|e| panic!("{e}"));
    for formulation in [Formulation::Kane, Formulation::Lagrange] {
        derive(&model, formulation).unwrap_or_else(|e| panic!("{}", model.diagnose(&e)));
    }
}

#[test]
fn words_of_rust_are_names_like_any_other() {
    let text = BASE.replace("mass = \"m\"", "mass = \"type\"");
    let text = text.replace("m = {", "type = {").replace("length", "fn").replace("\"I\"", "\"self\"");
    let text = text.replace("I = {", "self = {").replace("u1 =", "async =").replace("u2 =", "gen =");
    accepted(&text.replace("\nx = {", "\nmatch = {").replace("\"x'\"", "\"match'\"").replace("\"x\"", "\"match\""));
}

#[test]
fn names_of_generated_things_are_free() {
    for name in ["y", "dydt", "x0", "theta", "M", "f", "p", "S", "std", "e", "E1", "q_"] {
        accepted(
            &BASE
                .replace("\nx = {", &format!("\n{name} = {{"))
                .replace("\"x'\"", &format!("\"{name}'\""))
                .replace("\"x\"", &format!("\"{name}\"")),
        );
    }
}

#[test]
fn odd_angles_masses_and_inertias_are_accepted() {
    accepted(&edited(&[("angle = \"q\"", "angle = \"pi/2 - q\"")], ""));
    accepted(&edited(&[("angle = \"q\"", "angle = \"q + 10*pi/180\"")], ""));
    accepted(&edited(&[("[\"I\", 0, \"I\"]", "[\"I\", \"I\", \"2*I\"]")], ""));
    accepted(&edited(&[("[\"I\", 0, \"I\"]", "[\"I\", \"I\", \"I\"], products = [\"I/4\", \"-I/4\", 0]")], ""));
    accepted(&edited(&[("[\"I\", 0, \"I\"]", "[\"I + m*length^2\", 0, \"I + m*length^2\"], about_point = \"P\"")], ""));
    // The cart may be without mass: the rod still moves with it.
    accepted(&edited(&[("mass = \"m\"", "mass = 0")], ""));
    accepted(&edited(&[(", value = 2, positive = true", "")], ""));
}

#[test]
fn forms_of_the_text_do_not_matter() {
    accepted(&BASE.replace('\n', "\r\n"));
    accepted(&format!("\u{feff}{BASE}"));
    accepted(&BASE.replace("\"-length\"", "\"-\\u006cength\""));
    accepted(&BASE.replace("\"-length\"", "'''\n  -length\n'''"));
    accepted(&BASE.replace("Pendulum", "Pëndülüm 🎢"));
    accepted(&BASE.replace("x = { unit = \"m\" }", "x.unit = \"m\""));
    accepted(&BASE.replace("9.81", "9_8_1e-2"));
}

#[test]
fn a_torque_against_the_ground_leaves_newton_euler_possible() {
    let grounded = "[torques.T]\non = \"rod\"\nagainst = \"N\"\nframe = \"N\"\nvector = [0, 0, \"m*g*length\"]\n";
    let model = read(&edited(&[], grounded)).unwrap_or_else(|e| panic!("{e}"));
    assert!(model.torques[0].against.is_none());
}

#[test]
fn a_holonomic_constraint_takes_its_coordinate_out() {
    let constraint = "[constraints.slot]\nequation = \"x = length*sin(q)\"\n";
    let model = read(&edited(&[("u1 = \"x'\"\n", "")], constraint)).unwrap_or_else(|e| panic!("{e}"));
    assert!(
        model
            .counts_in_words()
            .starts_with("2 configuration variables, 1 holonomic constraint, 1 generalized coordinate")
    );
    let derivation = derive(&model, Formulation::Kane).unwrap_or_else(|e| panic!("{}", model.diagnose(&e)));
    assert_eq!(derivation.equations.matrix.len(), 1);
    assert!(!print_text(&derivation.arena, derivation.equations.matrix[0][0]).contains('x'));
}

/// The worked example of docs/model.md is a model, and says of itself what is so.
#[test]
fn the_example_of_the_manual_is_derived_three_ways() {
    let manual = include_str!("../../docs/model.md");
    let example = manual.split("```toml\n").nth(1).and_then(|rest| rest.split("```").next()).expect("an example");
    let model = read(example).unwrap_or_else(|e| panic!("{e}"));
    for formulation in Formulation::ALL {
        derive(&model, formulation).unwrap_or_else(|e| panic!("{}", model.diagnose(&e)));
    }
    let kane = derive(&model, Formulation::Kane).expect("as above");
    let entry = |row: usize, column: usize| print_text(&kane.arena, kane.equations.matrix[row][column]);
    expect_test::expect!["M + m; m*l*cos(theta)/2; m*l^2/3"]
        .assert_eq(&[entry(0, 0), entry(0, 1), entry(1, 1)].join("; "));
}
