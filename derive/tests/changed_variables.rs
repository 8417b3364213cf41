//! Comparison of two models of one mechanism in other variables. The second model is the first, with one edit made by
//! hand, so the change of variables is known beforehand.

use crate::printed_forms::CART;
use tripos_derive::Model;
use tripos_derive::diagnostic::Source;
use tripos_derive::diff::{DerivedModel, ModelDifference, diff_models};
use tripos_derive::mechanics::derive_all;
use tripos_derive::model::load;

fn read(text: &str) -> Model {
    load(&Source::from_text("model.toml", text)).unwrap_or_else(|e| panic!("{e}"))
}

/// Comparison of the cart with an edit of it; every piece must be there.
fn edited(edits: &[(&str, &str)]) -> ModelDifference {
    let mut text = CART.to_owned();
    for (old, new) in edits {
        assert!(text.contains(old), "the model has no `{old}`");
        text = text.replace(old, new);
    }
    let (old, new) = (read(CART), read(&text));
    let (mut before, mut after) = (derive_all(&old).unwrap(), derive_all(&new).unwrap());
    diff_models(
        &mut DerivedModel { model: &old, derivations: &mut before, proof: None },
        &mut DerivedModel { model: &new, derivations: &mut after, proof: None },
    )
}

/// Old variables with their formulas in the new ones.
fn changes(edits: &[(&str, &str)]) -> Vec<String> {
    edited(edits).variables.iter().map(|v| format!("{} {} = {}", v.kind.noun(), v.old, v.new)).collect()
}

#[test]
fn renamed_parameters_and_coordinates_are_recognised() {
    assert_eq!(
        changes(&[("theta", "phi"), ("M = {", "m_c = {"), ("mass = \"M\"", "mass = \"m_c\"")]),
        ["parameter M = m_c", "coordinate theta = phi"]
    );
    // Two masses exchange their names: M of the old model is m of the new one.
    assert_eq!(
        changes(&[
            ("m = {", "b = {"),
            ("mass = \"m\"", "mass = \"b\""),
            ("M = {", "a = {"),
            ("mass = \"M\"", "mass = \"a\""),
        ]),
        ["parameter M = a", "parameter m = b"]
    );
}

#[test]
fn signs_and_zeros_of_coordinates_are_recognised() {
    assert_eq!(
        changes(&[("angle = \"theta\"", "angle = \"-theta\"")]),
        ["coordinate theta = -theta", "speed omega = -omega"]
    );
    assert_eq!(changes(&[("angle = \"theta\"", "angle = \"theta - pi/2\"")]), ["coordinate theta = theta - pi/2"]);
}

#[test]
fn redefined_speeds_are_recognised() {
    assert_eq!(changes(&[("omega = \"theta'\"", "omega = \"2*theta' + x'/l\"")]), ["speed omega = omega/2 - v/(2*l)"]);
}

/// Truth by hand: another mass, another gravity and another direction of the push make another motion.
#[test]
fn another_mechanism_is_not_the_same_in_other_variables() {
    for edit in [
        ("mass = \"M\"", "mass = \"2*M\""),
        ("acceleration = [0, \"-g\", 0]", "acceleration = [0, \"-2*g\", 0]"),
        ("vector = [\"F\", 0, 0]", "vector = [\"2*F\", 0, 0]"),
        ("\"J\", 0, \"J\"", "\"2*J\", 0, \"2*J\""),
    ] {
        let difference = edited(&[edit]);
        assert!(difference.variables.is_empty(), "{edit:?}: {:?}", difference.variables);
        assert!(!difference.changes.is_empty(), "{edit:?}");
    }
}
