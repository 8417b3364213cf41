//! Text of the model file of a robot.

mod bodies;
mod loads;
mod loops;
mod shapes;

use crate::names::Names;
use crate::numbers::{angle_text, number_text, without_rounding};
use crate::pose::{Pose, yaw_pitch_roll};
use crate::robot::{JointIndex, Omission, Robot};
use nalgebra::{Matrix3, Vector3};
use std::fmt::Write;
use std::ops::Range;
use std::path::Path;
use tripos_derive::plain_text::{one_line, path_as_plain_text};

/// Text of a model file, with the coordinates that it declares.
pub struct ModelText {
    /// Text of the file.
    pub model: String,
    /// Coordinates in the order of the bodies.
    pub coordinates: Vec<Coordinate>,
    /// Lines of the file that close loops.
    pub loops: Vec<LoopLine>,
}

/// Line of a model file that closes a loop or states the pose in which loops are closed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LoopLine {
    /// Byte range of the line in the model file.
    pub line: Range<usize>,
    /// Byte range of the loop or the pose in the file that states it.
    pub place: Range<usize>,
}

/// A coordinate of a joint, as a scene starts with it.
pub struct Coordinate {
    /// Name of the coordinate in the model.
    pub name: String,
    /// Value in the reference configuration; rad, m or 1. If that value is not between the joint's limits, the middle
    /// of the limits, or 1 rad or 1 m from the only limit.
    pub start: f64,
    /// Value in the pose near which loops are closed; rad, m or 1.
    pub reference: f64,
    /// False if the coordinate follows another one.
    pub is_free: bool,
}

/// Names of a body in the model, with the axes and the origin in which the model states positions on it.
struct BodyNames {
    /// Name of the body.
    body: String,
    /// Name of the body's frame.
    frame: String,
    /// Name of the point at the last joint of the body.
    point: String,
    /// Pose, in the axes of the description, of the model's axes at this point.
    base: Pose,
}

/// Names of a joint with one coordinate.
#[derive(Clone)]
struct JointNames {
    /// Index of the joint.
    index: JointIndex,
    /// Name of the joint and of its point.
    joint: String,
    /// Name of the coordinate.
    coordinate: String,
    /// Name of the body that the joint moves; a joint before the last of its body moves an auxiliary body.
    body: String,
    /// Name of the body that carries the joint; `None` for the ground.
    carrier: Option<String>,
    /// Name of the moved body's frame.
    frame: String,
    /// Index of the frame's axis along which the joint's axis lies, from 0.
    axis: usize,
    /// Direction of the joint's axis along that axis: 1 or −1.
    sense: f64,
}

/// Sections of a model file while it is written, a line for each entry.
#[derive(Default)]
struct Sections {
    parameters: Vec<String>,
    inputs: Vec<String>,
    frames: Vec<String>,
    points: Vec<String>,
    bodies: Vec<String>,
    joints: Vec<String>,
    constraints: Vec<String>,
    assembly: Vec<String>,
    gravity: Vec<String>,
    forces: Vec<String>,
    torques: Vec<String>,
    friction: Vec<String>,
    potentials: Vec<String>,
    domain: Vec<String>,
    shapes: Vec<String>,
}

/// Writes a model file.
struct Writer<'a> {
    /// Robot that is written.
    robot: &'a Robot,
    /// Names in use.
    names: Names,
    /// Sections so far.
    sections: Sections,
    /// Names of the bodies so far.
    bodies: Vec<BodyNames>,
    /// Joints with one coordinate so far.
    joints: Vec<JointNames>,
    /// Coordinates so far.
    coordinates: Vec<Coordinate>,
    /// Simplifications made in writing.
    omissions: Vec<Omission>,
    /// Lines that close loops, each with the byte range of the loop in the file that states it.
    stated: Vec<(String, Range<usize>)>,
}

/// Writes the model file of a robot. `format` names the format of the description, `path` its file, and `loops` the
/// file of its loops.
/// Simplifications are added to the robot's omissions.
pub fn model_text(robot: &mut Robot, format: &str, path: &Path, loops: Option<&Path>) -> ModelText {
    let mut writer = Writer {
        robot,
        names: Names::new(),
        sections: Sections::default(),
        bodies: Vec::new(),
        joints: Vec::new(),
        coordinates: Vec::new(),
        omissions: Vec::new(),
        stated: Vec::new(),
    };
    writer.write_gravity();
    for (at, body) in writer.robot.bodies.iter().enumerate() {
        writer.write_body(at, body);
    }
    for names in writer.joints.clone() {
        writer.write_joint_loads(&names);
    }
    for actuator in &writer.robot.actuators {
        writer.write_actuator(actuator);
    }
    for one in &writer.robot.loops {
        writer.write_loop(one);
    }
    writer.write_couplings();
    writer.write_assembly();
    writer.write_markers();
    writer.write_shapes();
    let Writer { sections, coordinates, omissions, stated, .. } = writer;
    robot.omissions.extend(omissions);
    let file_name = |path: &Path| path.file_name().map_or_else(String::new, |name| path_as_plain_text(Path::new(name)));
    let name = file_name(path);
    let with_loops = loops.map_or_else(String::new, |loops| format!(" with the loops of {}", file_name(loops)));
    let mut model = format!(
        "# Made from {name} ({format}){with_loops} by `tripos new --from`. Every section and key: docs/model.md.\n"
    );
    for omission in &robot.omissions {
        let _ = writeln!(model, "# Left out: {omission}.");
    }
    let source = quoted(&format!("{format} file {name}{with_loops}"));
    let _ = writeln!(model, "schema = 1\nname = {}\nsource = {source}", quoted(&robot.name));
    sections.write(&mut model);
    let place_of = |line: &str| {
        let before = model.find(&format!("\n{line}\n"))? + 1;
        Some(before..before + line.len())
    };
    let loops =
        stated.into_iter().filter_map(|(line, place)| Some(LoopLine { line: place_of(&line)?, place })).collect();
    ModelText { model, coordinates, loops }
}

impl Sections {
    /// Appends the sections that have entries.
    fn write(&self, text: &mut String) {
        let inertial = vec!["frame = \"N\"\norigin = \"O\"".to_owned()];
        let sections = [
            ("parameters", &self.parameters),
            ("inputs", &self.inputs),
            ("inertial", &inertial),
            ("frames", &self.frames),
            ("points", &self.points),
            ("bodies", &self.bodies),
            ("joints", &self.joints),
            ("constraints", &self.constraints),
            ("assembly", &self.assembly),
            ("gravity", &self.gravity),
            ("forces", &self.forces),
            ("torques", &self.torques),
            ("friction", &self.friction),
            ("potentials", &self.potentials),
            ("domain", &self.domain),
            ("shapes", &self.shapes),
        ];
        for (name, lines) in sections.iter().filter(|(_, lines)| !lines.is_empty()) {
            let _ = write!(text, "\n[{name}]\n{}\n", lines.join("\n"));
        }
    }
}

/// A parameter to declare.
struct NewParameter<'t> {
    /// Name that is wanted.
    name: String,
    /// Unit of the parameter, of SI.
    unit: &'t str,
    /// Value in the unit.
    value: f64,
    /// Text for readers; may be empty.
    about: String,
    /// True if the parameter is positive in every variant of the robot: a mass or a moment of inertia.
    is_positive: bool,
}

impl Writer<'_> {
    /// Declares a parameter unless its value is 0. Returns a formula: its name, or `0`.
    fn declare(&mut self, parameter: NewParameter<'_>) -> String {
        let NewParameter { name, unit, value, about, is_positive } = parameter;
        if value == 0.0 {
            return "0".to_owned();
        }
        let name = self.names.reserve(&name, &["*"]);
        let positive = if is_positive && value > 0.0 { ", positive = true" } else { "" };
        let about = if about.is_empty() { String::new() } else { format!(", about = {}", quoted(&about)) };
        let value = number_text(value);
        self.sections.parameters.push(format!("{name} = {{ unit = \"{unit}\", value = {value}{positive}{about} }}"));
        name
    }

    /// Declares a parameter of any sign unless its value is 0. Returns a formula: its name, or `0`.
    fn parameter(&mut self, name: String, unit: &str, value: f64, about: String) -> String {
        self.declare(NewParameter { name, unit, value, about, is_positive: false })
    }

    /// Declares the components of a position, m, as parameters such as `x_…`, `y_…` and `z_…`, with `prefix` before
    /// the axis. Returns a list for the file; `None` for the position 0.
    fn position(&mut self, prefix: &str, owner: &str, value: &Vector3<f64>, about: &str) -> Option<String> {
        let components = without_rounding([value.x, value.y, value.z], 0.0);
        if components.iter().all(|component| *component == 0.0) {
            return None;
        }
        let mut text = about.to_owned();
        let mut list = Vec::new();
        for (axis, component) in ["x", "y", "z"].into_iter().zip(components) {
            // The first parameter of the position has the text for all.
            let about = if component == 0.0 { String::new() } else { std::mem::take(&mut text) };
            list.push(value_of(&self.parameter(format!("{prefix}{axis}_{owner}"), "m", component, about)));
        }
        Some(format!("[{}]", list.join(", ")))
    }

    /// Turn as the keys `sequence` and `angles`, with a parameter for each angle that is no multiple of a twelfth of
    /// π. `None` for no turn.
    fn turn(&mut self, owner: &str, rotation: &Matrix3<f64>) -> Option<String> {
        let angles = without_rounding(yaw_pitch_roll(rotation), std::f64::consts::PI);
        let mut sequence = String::new();
        let mut list = Vec::new();
        for (axis, name, angle) in [(3, "yaw", angles[0]), (2, "pitch", angles[1]), (1, "roll", angles[2])] {
            if angle == 0.0 {
                continue;
            }
            let _ = write!(sequence, "{axis}");
            list.push(match angle_text(angle) {
                Some(multiple) => value_of(&multiple),
                None => {
                    let about = format!("turn of {owner} about axis {axis}");
                    value_of(&self.parameter(format!("{name}_{owner}"), "rad", angle, about))
                }
            });
        }
        (!list.is_empty()).then(|| format!("sequence = \"{sequence}\", angles = [{}]", list.join(", ")))
    }

    /// Frame and point of a body, and a pose on it in this frame, from this point. `None` stands for the ground.
    fn on_body(&self, body: Option<usize>, pose: &Pose) -> (&str, &str, Pose) {
        match body {
            Some(at) => {
                let BodyNames { frame, point, base, .. } = &self.bodies[at];
                (frame, point, base.inverse().compose(pose))
            }
            None => ("N", "O", pose.clone()),
        }
    }

    /// Names of a joint with one coordinate.
    fn names_of(&self, index: JointIndex) -> Option<JointNames> {
        self.joints.iter().find(|names| names.index == index).cloned()
    }

    /// Writes the acceleration of free fall.
    fn write_gravity(&mut self) {
        const ABOUT: &str = "acceleration of free fall";
        let gravity = self.robot.gravity;
        let along: Vec<usize> = (0..3).filter(|axis| gravity[*axis] != 0.0).collect();
        let components = match along[..] {
            [] => return,
            [axis] => {
                let value = number_text(gravity[axis].abs());
                self.sections
                    .parameters
                    .push(format!("g = {{ unit = \"m/s^2\", value = {value}, positive = true, about = \"{ABOUT}\" }}"));
                let sign = if gravity[axis] < 0.0 { "-" } else { "" };
                let mut components = [0; 3].map(|zero| zero.to_string());
                components[axis] = format!("\"{sign}g\"");
                components
            }
            _ => [0, 1, 2].map(|axis| {
                let name = format!("g{}", axis + 1);
                value_of(&self.parameter(name, "m/s^2", gravity[axis], ABOUT.to_owned()))
            }),
        };
        self.sections.gravity.push(format!("frame = \"N\"\nacceleration = [{}]", components.join(", ")));
    }
}

/// Formula as a value of the file: a number, or a quoted text.
fn value_of(formula: &str) -> String {
    if formula == "0" { formula.to_owned() } else { format!("\"{formula}\"") }
}

/// Text as a string of TOML, in one line.
fn quoted(text: &str) -> String {
    format!("\"{}\"", one_line(text).replace('\\', "\\\\").replace('"', "\\\""))
}
