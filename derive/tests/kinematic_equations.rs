//! Solving u = J q' + d for q' brings in no singularities of its own.

use std::path::Path;
use tripos_derive::algebra::text::print::print_text;
use tripos_derive::{Formulation, Model, derive, model};

fn singular_where(model: &Model) -> Vec<String> {
    model.kinematic_equations.divisors.iter().map(|d| print_text(&model.arena, *d)).collect()
}

/// Goal: a vehicle's natural start. Truth: Newton in body axes, m (dv/dt + ω × v) = 0, and the one
/// singularity of 3-2-1 angles, cos th = 0.
#[test]
fn a_body_in_body_axis_velocities_has_the_textbook_equations() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/models/free_body.toml");
    let model = Model::read(&path).unwrap();
    assert_eq!(singular_where(&model), ["cos(th)"]);
    let kane = derive(&model, Formulation::Kane).unwrap();
    let (arena, e) = (&kane.arena, &kane.equations);
    let rows: Vec<String> = (0..3)
        .map(|i| format!("{} | {}", print_text(arena, e.matrix[i][i]), print_text(arena, e.forcing[i])))
        .collect();
    assert_eq!(rows, ["m | m*(V*r - W*q)", "m | m*(W*p - U*r)", "m | m*(U*q - V*p)"]);
}

/// A top in body-fixed speeds: singular at sin q2 = 0 only, whatever q3; a length that divides is no place.
#[test]
fn divisors_are_determinants_without_lengths() {
    let text = r#"
        name = "Top"
        [parameters]
        l = { unit = "m", positive = true }
        m = { unit = "kg", positive = true }
        [coordinates]
        q1 = { unit = "rad" }
        q2 = { unit = "rad" }
        q3 = { unit = "rad" }
        [speeds]
        u1 = "l*(q1'*sin(q2)*sin(q3) + q2'*cos(q3))"
        u2 = "l*(q1'*sin(q2)*cos(q3) - q2'*sin(q3))"
        u3 = "q1'*cos(q2) + q3'"
        [inertial]
        frame = "N"
        origin = "O"
        [points]
        P = { from = "O", frame = "N", position = ["l*cos(q1)", "l*cos(q2)", "l*cos(q3)"] }
        [particles]
        one = { point = "P", mass = "m" }
    "#;
    let model = model::load(&tripos_derive::diagnostic::Source::from_text("top.toml", text)).unwrap();
    assert_eq!(singular_where(&model), ["sin(q2)"]);
}
