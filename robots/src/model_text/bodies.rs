//! Bodies, joints and named frames of a model file.

use super::{BodyNames, Coordinate, JointNames, NewParameter, Writer, value_of};
use crate::numbers::{number_text, without_rounding};
use crate::pose::{Pose, quaternion, turn_about, turn_to};
use crate::robot::{Body, Inertia, Joint, JointIndex, JointMotion};
use nalgebra::{Matrix3, Vector3};
use std::fmt::Write;

/// Names that a joint brings; `*` stands for its own.
pub(super) const JOINT_AFFIXES: &[&str] = &[
    "*",
    "q_*",
    "u_*",
    "q_*_1",
    "q_*_2",
    "q_*_3",
    "q_*_4",
    "q_*_5",
    "q_*_6",
    "q_*_7",
    "u_*_1",
    "u_*_2",
    "u_*_3",
    "u_*_4",
    "u_*_5",
    "u_*_6",
    "*_base",
    "*_base_turn1",
    "*_base_turn2",
    "*_damping",
    "*_friction",
    "*_spring",
    "*_min",
    "*_max",
];

/// Place of a joint on the body that carries it, and the body that it moves.
struct JointPlace<'t> {
    /// Name of the body that the joint moves.
    body: &'t str,
    /// Name of the body that carries the joint; `None` for the ground.
    carrier: Option<&'t str>,
    /// Pose of the moved body's axes at the joint, in the axes of the carrier, in the reference configuration.
    pose: Pose,
    /// Axis of the joint in the axes of the moved body, of length 1.
    axis: Vector3<f64>,
    /// Mass centre of the moved body from the joint; `None` if it is at the joint.
    centre: Option<Vector3<f64>>,
}

impl Writer<'_> {
    /// Writes a body with its joints. Joints before the last one move auxiliary bodies without mass. A body whose joint
    /// has an oblique axis has its axis 3 along it.
    pub(super) fn write_body(&mut self, at: usize, body: &Body) {
        let name =
            self.names.reserve(&body.name, &["*", "*_frame", "*_frame_turn1", "*_frame_turn2", "*_centre", "m_*"]);
        let mut carrier = body.parent.map(|parent| self.bodies[parent].body.clone());
        // Pose of the description's axes of the body in the model's axes of the joint's carrier.
        let mut outer = self.on_body(body.parent, &body.pose).2;
        let mut base = Pose::default();
        let mut point = String::new();
        for (number, joint) in body.joints.iter().enumerate() {
            let is_last = number + 1 == body.joints.len();
            let moved = if is_last {
                name.clone()
            } else {
                let part = self.names.reserve(&format!("{name}_{}", number + 1), &["*", "*_frame", "*_centre"]);
                self.sections.bodies.push(format!("{part} = {{ {MASSLESS} }}"));
                part
            };
            base = Pose { position: joint.position, rotation: model_axes(joint) };
            let own = body.inertia.as_ref().filter(|_| is_last);
            let place = JointPlace {
                body: &moved,
                carrier: carrier.as_deref(),
                pose: outer.compose(&base),
                axis: axis_along_axes(&(base.rotation.transpose() * joint.axis.normalize())),
                centre: own.map(|inertia| base.inverse().transform(&inertia.centre)),
            };
            point = self.write_joint(JointIndex { body: at, joint: number }, joint, place);
            outer = base.inverse();
            carrier = Some(moved);
        }
        let inertia = body.inertia.as_ref().map(|inertia| inertia.moved(&base.inverse()));
        let inertia = self.inertia_keys(&name, inertia.as_ref());
        self.sections.bodies.push(format!("{name} = {{ {inertia} }}"));
        self.bodies.push(BodyNames { frame: format!("{name}_frame"), body: name, point, base });
    }

    /// Mass and inertia of a body, as keys of its table.
    fn inertia_keys(&mut self, name: &str, inertia: Option<&Inertia>) -> String {
        let Some(inertia) = inertia else { return MASSLESS.to_owned() };
        let mass = if inertia.mass == 0.0 {
            "0".to_owned()
        } else {
            let value = number_text(inertia.mass);
            let about = format!("mass of {name}");
            self.sections
                .parameters
                .push(format!("m_{name} = {{ unit = \"kg\", value = {value}, positive = true, about = \"{about}\" }}"));
            format!("\"m_{name}\"")
        };
        let tensor = &inertia.tensor;
        let [xx, yy, zz, xy, yz, zx] = without_rounding(
            [tensor[(0, 0)], tensor[(1, 1)], tensor[(2, 2)], tensor[(0, 1)], tensor[(1, 2)], tensor[(2, 0)]],
            0.0,
        );
        let mut moment = |symbol: &str, value: f64, about: String| {
            let name = format!("{symbol}_{name}");
            value_of(&self.declare(NewParameter { name, unit: "kg*m^2", value, about, is_positive: true }))
        };
        // Equal moments share a parameter: the equations of a symmetric body are shorter.
        let first = moment("Ixx", xx, format!("moments of {name} about its mass centre"));
        let second = if yy - xx == 0.0 { first.clone() } else { moment("Iyy", yy, String::new()) };
        let third = if zz - xx == 0.0 {
            first.clone()
        } else if zz - yy == 0.0 {
            second.clone()
        } else {
            moment("Izz", zz, String::new())
        };
        let mut text = format!("mass = {mass}, inertia = {{ diagonal = [{first}, {second}, {third}]");
        if [xy, yz, zx].iter().any(|product| *product != 0.0) {
            let products = [("Ixy", xy), ("Iyz", yz), ("Izx", zx)].map(|(symbol, value)| {
                let about = format!("product of {name}, with its sign in the tensor");
                value_of(&self.parameter(format!("{symbol}_{name}"), "kg*m^2", value, about))
            });
            let _ = write!(text, ", products = [{}]", products.join(", "));
        }
        text + " }"
    }

    /// Writes a joint. Returns its name in the model.
    fn write_joint(&mut self, index: JointIndex, joint: &Joint, place: JointPlace<'_>) -> String {
        let JointPlace { body, carrier, mut pose, axis, centre } = place;
        let name = self.names.reserve(&joint.name, JOINT_AFFIXES);
        match joint.motion {
            JointMotion::Hinge => pose.rotation *= turn_about(&axis, -joint.reference),
            JointMotion::Slide => pose.position -= pose.rotation * axis * joint.reference,
            JointMotion::Ball | JointMotion::Planar | JointMotion::Free => {}
        }
        let (kind, has_axis) = match joint.motion {
            JointMotion::Hinge => ("pin", true),
            JointMotion::Slide => ("slider", true),
            JointMotion::Planar => ("planar", true),
            JointMotion::Ball => ("ball", false),
            JointMotion::Free => ("free", false),
        };
        let axis_key =
            if has_axis { format!("axis = {}", axis_text(&axis)) } else { "sequence = \"euler\"".to_owned() };
        let mut keys = vec![format!("kind = \"{kind}\""), axis_key, format!("body = \"{body}\"")];
        keys.extend(carrier.map(|carrier| format!("to = \"{carrier}\"")));
        let on = carrier.unwrap_or("the ground");
        let at = self.position("", &name, &pose.position, &format!("position of the joint {name} on {on}"));
        keys.extend(at.map(|at| format!("at = {at}")));
        keys.extend(self.turn(&name, &pose.rotation).map(|turn| format!("turned = {{ {turn} }}")));
        let centre = centre.and_then(|centre| {
            self.position("c", body, &centre, &format!("mass centre of {body} from the joint {name}"))
        });
        keys.extend(centre.map(|centre| format!("centre = {centre}")));
        self.sections.joints.push(format!("{name} = {{ {} }}", keys.join(", ")));
        if joint.has_one_coordinate() {
            let coordinate = format!("q_{name}");
            let start = match joint.limits {
                Some((lower, upper)) if joint.reference <= lower || joint.reference >= upper => {
                    match (lower.is_finite(), upper.is_finite()) {
                        (true, false) => lower + 1.0,
                        (false, true) => upper - 1.0,
                        _ => f64::midpoint(lower, upper),
                    }
                }
                _ => joint.reference,
            };
            let is_free = !self.robot.couplings.iter().any(|coupling| coupling.follower == index);
            let stated = self.robot.coupled_value(index).or_else(|| self.robot.assembly.get(&index).copied());
            let reference = stated.unwrap_or(joint.reference);
            self.coordinates.push(Coordinate { name: coordinate.clone(), start, reference, is_free });
            self.joints.push(JointNames {
                index,
                joint: name.clone(),
                coordinate,
                body: body.to_owned(),
                carrier: carrier.map(str::to_owned),
                frame: format!("{body}_frame"),
                axis: axis.iamax(),
                sense: axis[axis.iamax()],
            });
            return name;
        }
        let start = &joint.free_start;
        let values = match joint.motion {
            JointMotion::Planar => vec![0.0; 3],
            JointMotion::Free => [start.position.as_slice(), &quaternion(&start.rotation)].concat(),
            _ => vec![1.0, 0.0, 0.0, 0.0],
        };
        for (at, start) in values.into_iter().enumerate() {
            self.coordinates.push(Coordinate {
                name: format!("q_{name}_{}", at + 1),
                start,
                reference: start,
                is_free: true,
            });
        }
        if joint.motion == JointMotion::Ball {
            self.write_ball_damping(joint, &name, body, carrier);
        }
        name
    }

    /// Writes the frames of joined bodies without mass as points, with a frame if they are turned. A frame at the
    /// origin of the ground is left out.
    pub(super) fn write_markers(&mut self) {
        for marker in &self.robot.markers {
            let (frame, origin, pose) = self.on_body(marker.body, &marker.pose);
            let (frame, origin) = (frame.to_owned(), origin.to_owned());
            let position = pose.position;
            let is_turned = pose.rotation != Matrix3::identity();
            let is_ground = marker.body.is_none() && position == Vector3::zeros() && !is_turned;
            if marker.has_mass || is_ground {
                continue;
            }
            let name = self.names.reserve(&marker.name, &["*", "*_frame"]);
            let position = self.position("", &name, &position, &format!("position of {name}"));
            let position = position.unwrap_or_else(|| "[0, 0, 0]".to_owned());
            self.sections
                .points
                .push(format!("{name} = {{ from = \"{origin}\", frame = \"{frame}\", position = {position} }}"));
            if let Some(turn) = self.turn(&name, &pose.rotation) {
                self.sections.frames.push(format!("{name}_frame = {{ from = \"{frame}\", {turn} }}"));
            }
        }
    }
}

/// Keys of a body without mass.
const MASSLESS: &str = "mass = 0, inertia = { diagonal = [0, 0, 0] }";

/// Axes of the model for a body that a joint moves, as a rotation matrix in the axes of the description: axis 3 lies
/// along an oblique axis of the joint; other joints keep the axes of the description.
fn model_axes(joint: &Joint) -> Matrix3<f64> {
    let has_axis = matches!(joint.motion, JointMotion::Hinge | JointMotion::Slide | JointMotion::Planar);
    let along = joint.axis.iter().filter(|component| **component != 0.0).count();
    if has_axis && along > 1 { turn_to(&joint.axis) } else { Matrix3::identity() }
}

/// Axis that lies along a coordinate axis but for rounding, exactly along it.
fn axis_along_axes(axis: &Vector3<f64>) -> Vector3<f64> {
    let mut exact = Vector3::zeros();
    exact[axis.iamax()] = axis[axis.iamax()].signum();
    exact
}

/// Axis of a joint: 1, 2 or 3, or a vector against one of these axes.
fn axis_text(axis: &Vector3<f64>) -> String {
    let at = axis.iamax();
    if axis[at] > 0.0 {
        return (at + 1).to_string();
    }
    let mut components = ["0"; 3];
    components[at] = "-1";
    format!("[{}]", components.join(", "))
}
