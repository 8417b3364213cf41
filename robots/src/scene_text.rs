//! Text of a first scene of a robot: at rest in its reference configuration.

use crate::model_text::Coordinate;
use crate::numbers::number_text;
use crate::robot::Robot;
use std::fmt::Write;

/// Writes a scene in which the robot is released at rest. Coordinates of robots with loops are guesses.
pub fn scene_text(robot: &Robot, coordinates: &[Coordinate]) -> String {
    let mut text =
        "# A run of ../model.toml. What every key means: docs/scene.md.\nschema = 1\ntitle = \"Released\"\n".to_owned();
    text += "about = \"The robot is released at rest. Its drives exert nothing: give them values under [inputs].\"\n";
    text += "span = [0, \"1 s\"]\n";
    let values = |text: &mut String| {
        for coordinate in coordinates {
            let _ = writeln!(text, "{} = {}", coordinate.name, number_text(coordinate.start));
        }
    };
    text += "\n[start]\n";
    if robot.loops.is_empty() {
        values(&mut text);
    }
    for coordinate in coordinates {
        let _ = writeln!(text, "\"{}'\" = 0", coordinate.name);
    }
    if !robot.loops.is_empty() {
        text += "\n# Tripos closes the loops from these values.\n[guess]\n";
        values(&mut text);
    }
    text += "\n[integration]\nrtol = 1e-9\natol = 1e-12\n\n[[figures]]\nkind = \"states\"\ncaption = \"Motion of the joints\"\n";
    text
}
