//! Compiled equations against accelerations that were computed independently.

use crate::support;

use serde_json::Value;
use support::{accelerations, system};

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect()
}

/// Goal: correct mathematics. Method: SymPy's Kane and a separate engine with 50 digits, see the data file.
/// 1e-12 max(1, |value|), the tolerance that the data state.
#[test]
fn accelerations_match_the_independent_references() {
    let data: Value = serde_json::from_str(include_str!("data/reference_cases.json")).unwrap();
    let mut compared = 0;
    for case in data["cases"].as_array().unwrap() {
        let name = case["model"].as_str().unwrap();
        let model = tripos_models::MODELS.iter().find(|m| m.name == name).unwrap();
        let order = parameter_names(name);
        let p: Vec<f64> = order.iter().map(|n| case["parameters"][n].as_f64().unwrap()).collect();
        // Printed equations are compiled too, and need not be right.
        // In a distance the coordinates are others.
        let derived = model.systems.iter().filter(|s| !s.name.starts_with("printed:") && !s.name.contains('@'));
        for compiled in derived {
            for state in case["states"].as_array().unwrap() {
                let (q, u) = (numbers(&state["q"]), numbers(&state["u"]));
                let found = accelerations(compiled.double, &p, &q, &u);
                for (a, b) in found.iter().zip(numbers(&state["udot"])) {
                    assert!(
                        (a - b).abs() <= 1e-12 * b.abs().max(1.0),
                        "{} {}: {a} is not {b}",
                        case["id"],
                        compiled.name
                    );
                }
                compared += 1;
            }
        }
    }
    assert_eq!(compared, 3 * 3 + 3 * 3 + 4 * 3, "K05, K07 and K19 by three formulations");
}

/// Energies too: T as it is, V in its differences, since each file chooses its own zero. The references have gravity's
/// potential; the constant force F on the cart at q0 has −F q0.
#[test]
fn energies_match_the_independent_references() {
    let data: Value = serde_json::from_str(include_str!("data/reference_cases.json")).unwrap();
    for case in data["cases"].as_array().unwrap() {
        let name = case["model"].as_str().unwrap();
        let kane = system(name, "kane");
        let p: Vec<f64> = parameter_names(name).iter().map(|n| case["parameters"][n].as_f64().unwrap()).collect();
        let mut zero = None;
        for state in case["states"].as_array().unwrap() {
            let (q, u) = (numbers(&state["q"]), numbers(&state["u"]));
            let t = state["kinetic_energy"].as_f64().unwrap();
            assert!((kane.kinetic_energy(&p, &q, &u) - t).abs() <= 1e-13 * t.max(1.0));
            let of_force = case["parameters"].get("F").map_or(0.0, |force| -force.as_f64().unwrap() * q[0]);
            let gravity = kane.potential_energy(&p, &q) - of_force;
            let offset = state["gravity_potential"].as_f64().unwrap() - gravity;
            let first = *zero.get_or_insert(offset);
            assert!((offset - first).abs() <= 1e-12 * first.abs().max(1.0), "{}: {offset} {first}", case["id"]);
        }
    }
}

fn parameter_names(model: &str) -> Vec<&'static str> {
    match model {
        "disk" => tripos_models::disk::PARAMETERS.to_vec(),
        "chaotic_pendulum" => tripos_models::chaotic_pendulum::PARAMETERS.to_vec(),
        "cart_pendulum_3" => tripos_models::cart_pendulum_3::PARAMETERS.to_vec(),
        other => panic!("no such model: {other}"),
    }
}
