//! `tripos check` on the command line.

use crate::support::{stdout, tripos};

/// Goal: what people and programs read. Method: the rolling disc of the library, both ways.
#[test]
fn a_model_is_checked_for_people_and_for_programs() {
    let text = stdout(&tripos(&["check", "models/rolling_disc"]));
    for line in [
        "degrees of freedom in velocity: 3",
        "reachable configurations: 5-dimensional",
        "(motion): not integrable: it restricts velocities alone",
        "(motion): follows from the others",
    ] {
        assert!(text.contains(line), "{text}");
    }
    let text = stdout(&tripos(&["check", "models/slider_crank"]));
    for line in
        ["wrist_1 (configuration): r*sin(q) + l*sin(q + p) is 0", "wrist_3 (configuration): follows from the others"]
    {
        assert!(text.contains(line), "{text}");
    }
    let json: serde_json::Value =
        serde_json::from_str(&stdout(&tripos(&["check", "models/four_bar", "--json"]))).unwrap();
    assert_eq!(json["degrees_of_freedom"], 1);
    assert_eq!(json["configuration_freedom"], 1);
    assert_eq!(json["constraints"][0]["kind"], "configuration");
    assert_eq!(json["singular_where"][0], "sin(q2 - q3)");
    // Where the speeds fail, and where the mechanism does.
    let poses = &json["singular_poses"];
    assert_eq!(
        (&poses["rank"], &poses["nowhere"], &poses["pose"]),
        (&2.into(), &false.into(), &serde_json::Value::Null)
    );
    assert_eq!(poses["where_all_zero"].as_array().unwrap().len(), 3);
    assert_eq!(json["branch"]["rank"], 2);
    assert_eq!(json["branch"]["kind"], "numeric");
    assert!(json["branch"]["name"].as_str().unwrap().starts_with("through q1 = "));
    assert_eq!(json["mobility_count"], 1);
}

#[test]
fn loads_that_can_create_energy_are_told() {
    let json: serde_json::Value =
        serde_json::from_str(&stdout(&tripos(&["check", "models/furuta", "--json"]))).unwrap();
    let energies: Vec<&str> = json["loads"].as_array().unwrap().iter().map(|l| l["energy"].as_str().unwrap()).collect();
    assert_eq!(energies, ["dissipates", "dissipates"]);
    assert_eq!(json["branch"], serde_json::Value::Null);
    assert_eq!(json["singular_poses"], serde_json::Value::Null);
    let text = stdout(&tripos(&["check", "models/puma560"]));
    assert!(text.contains("the model is too large to check its loads for created energy"), "{text}");
    let text = stdout(&tripos(&["check", "models/bricard"]));
    assert!(text.contains("coordinates less constraints, counted: 0"), "{text}");
    assert!(text.contains("rank 4 of 5 constraints, in "), "{text}");
}
