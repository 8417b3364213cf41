//! `tripos check` on the command line.

use crate::support::{stdout, tripos};

/// Goal: what people and programs read. Method: the rolling disc of the library, both ways.
#[test]
fn a_model_is_checked_for_people_and_for_programs() {
    let text = stdout(&tripos(&["check", "models/rolling_disc"]));
    for line in [
        "degrees of freedom in velocity: 3",
        "freedom of configuration, what motions can reach: 5",
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
}
