//! Text of a first scene of a robot: at rest in its reference configuration.

use crate::model_text::Coordinate;
use crate::numbers::number_text;
use crate::robot::Robot;
use std::fmt::Write;

/// Writes a scene in which the robot is released at rest. A robot with loops starts in the pose that the model states
/// under `[assembly]`.
pub fn scene_text(robot: &Robot, coordinates: &[Coordinate]) -> String {
    let mut text =
        "# A run of ../model.toml. What every key means: docs/scene.md.\nschema = 1\ntitle = \"Released\"\n".to_owned();
    text += "about = \"The robot is released at rest. Its drives exert nothing: give them values under [inputs].\"\n";
    text += "span = [0, \"1 s\"]\n";
    text += "\n[start]\n";
    // The loops are closed near the pose that the model states.
    for coordinate in coordinates.iter().filter(|coordinate| coordinate.is_free && robot.loops.is_empty()) {
        let _ = writeln!(text, "{} = {}", coordinate.name, number_text(coordinate.start));
    }
    for coordinate in coordinates.iter().filter(|coordinate| coordinate.is_free) {
        let _ = writeln!(text, "\"{}'\" = 0", coordinate.name);
    }
    text += "\n[integration]\nrtol = 1e-9\natol = 1e-12\n\n[[figures]]\nkind = \"states\"\ncaption = \"Motion of the joints\"\n";
    text
}
