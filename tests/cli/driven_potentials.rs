//! Potentials of places that a drive moves: the same numbers and proofs as for the forces that they stand for.

use crate::support::{answer, answer_in_json, root};
use serde_json::Value;

fn given(file: &str) -> String {
    root().join("tests/data/driven_potential").join(file).to_str().unwrap().to_owned()
}

/// The numbers of two answers are equal to rounding.
fn assert_alike(a: &Value, b: &Value, what: &str) {
    match (a, b) {
        (Value::Number(a), Value::Number(b)) => {
            let (a, b) = (a.as_f64().unwrap(), b.as_f64().unwrap());
            assert!((a - b).abs() < 1e-12 * (1.0 + a.abs()), "{what}: {a} against {b}");
        }
        (Value::Array(a), Value::Array(b)) => {
            assert_eq!(a.len(), b.len(), "{what}");
            a.iter().zip(b).for_each(|(a, b)| assert_alike(a, b, what));
        }
        (Value::Object(a), Value::Object(b)) => {
            for (name, value) in a {
                assert_alike(value, &b[name], &format!("{what}, {name}"));
            }
        }
        _ => assert_eq!(a, b, "{what}"),
    }
}

/// Goal: a potential acts on what a drive moves. Method: a rod whose angle is q + ω t, under the potential k p₂(P) and
/// under its force. With φ = q + ω t the rod is a pendulum, so that T + V is constant and the drive carries nothing.
#[test]
fn a_potential_in_a_driven_frame_is_its_force() {
    let state = given("st.toml");
    for by in ["kane", "lagrange", "newton-euler"] {
        let [potential, force] = ["model.toml", "force.toml"]
            .map(|file| answer_in_json(&["evaluate", &given(file), "--by", by, "--at", &state, "--json"]));
        for name in ["accelerations", "multipliers", "power", "kinetic_energy", "potential_energy"] {
            assert_alike(&potential[name], &force[name], &format!("{by}, {name}"));
        }
        assert!(potential["power"].as_f64().unwrap().abs() < 1e-12, "{by}: {}", potential["power"]);
    }
}

/// Goal: the equations of a driven mechanism with a potential are proved equal. Method: the rod, and a universal joint
/// with a driven angle and a spring on the other one, whose torque must not work along the drive.
#[test]
fn driven_mechanisms_with_potentials_are_proved() {
    for file in ["model.toml", "force.toml", "universal.toml", "universal_torque.toml"] {
        let (status, out, err) = answer(&["prove", &given(file)]);
        assert_eq!(status, 0, "{file}: {out}{err}");
        assert!(!out.contains("DIFFERENT") && !out.contains("undecided"), "{file}: {out}");
    }
    let state = given("universal_state.toml");
    let [potential, torque] = ["universal.toml", "universal_torque.toml"]
        .map(|file| answer_in_json(&["evaluate", &given(file), "--by", "kane", "--at", &state, "--json"]));
    assert_alike(&potential["accelerations"], &torque["accelerations"], "universal joint");
}
