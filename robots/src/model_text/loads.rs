//! Loads of joints in a model file: damping, dry friction, springs, armatures, limits and actuators.

use super::{JointNames, NewParameter, Writer, quoted, value_of};
use crate::robot::{Actuator, ActuatorInput, Joint, JointMotion, Omission};

/// Units of a joint's coordinate and load.
struct JointUnits {
    /// Unit of the coordinate.
    coordinate: &'static str,
    /// Unit of the load along it.
    load: &'static str,
}

impl JointUnits {
    /// Units of a hinge or a slide.
    fn of(joint: &Joint) -> Self {
        if joint.motion == JointMotion::Hinge {
            Self { coordinate: "rad", load: "N*m" }
        } else {
            Self { coordinate: "m", load: "N" }
        }
    }
}

impl Writer<'_> {
    /// Writes a load of one coordinate: a torque about the joint's axis, or a force along it, on the moved body
    /// against its carrier. `name` is the name of the entry, and `formula` the load's value.
    fn write_load(&mut self, joint: &Joint, names: &JointNames, name: &str, formula: &str) {
        let frame = &names.frame;
        let mut components = [0; 3].map(|zero| zero.to_string());
        components[names.axis] = match (names.sense < 0.0, formula.strip_prefix('-')) {
            (false, _) => format!("\"{formula}\""),
            (_, Some(positive)) if !formula.contains(" + ") => format!("\"{positive}\""),
            _ if formula.contains(" + ") => format!("\"-({formula})\""),
            _ => format!("\"-{formula}\""),
        };
        let against = names.against();
        let is_turn = joint.motion == JointMotion::Hinge;
        let (at, against_at) = match (is_turn, &names.carrier) {
            (true, _) => (String::new(), String::new()),
            (false, None) => (format!(", at = \"{}\"", names.joint), String::new()),
            (false, Some(_)) => (format!(", at = \"{}\"", names.joint), format!(", against_at = \"{}\"", names.joint)),
        };
        let (body, vector) = (&names.body, components.join(", "));
        let line = format!(
            "{name} = {{ on = \"{body}\"{at}{against}{against_at}, frame = \"{frame}\", vector = [{vector}] }}"
        );
        if is_turn { self.sections.torques.push(line) } else { self.sections.forces.push(line) }
    }

    /// Writes damping, dry friction, the spring, the armature and the limits of a joint.
    pub(super) fn write_joint_loads(&mut self, names: &JointNames) {
        let joint = self.robot.joint(names.index);
        let JointUnits { coordinate: unit, load } = JointUnits::of(joint);
        let (name, coordinate) = (&names.joint, &names.coordinate);
        if joint.damping != 0.0 {
            let about = format!("damping of the joint {name}");
            let damping = self.parameter(format!("c_{name}"), &format!("{load}*s/{unit}"), joint.damping, about);
            self.write_load(joint, names, &format!("{name}_damping"), &format!("-{damping}*{coordinate}'"));
        }
        if joint.friction != 0.0 {
            self.write_friction(joint, names);
        }
        if joint.stiffness != 0.0 {
            let about = format!("stiffness of the joint {name}");
            let stiffness = self.parameter(format!("k_{name}"), &format!("{load}/{unit}"), joint.stiffness, about);
            let about = format!("{coordinate} where the spring of the joint {name} is relaxed");
            let rest = self.parameter(format!("rest_{name}"), unit, joint.spring_reference, about);
            let stretch = if rest == "0" { coordinate.clone() } else { format!("({coordinate} - {rest})") };
            self.sections.potentials.push(format!("{name}_spring = \"{stiffness}*{stretch}^2/2\""));
        }
        if joint.armature != 0.0 {
            self.write_armature(joint, names);
        }
        if let Some((lower, upper)) = joint.limits {
            let ends = [("min", ">", lower), ("max", "<", upper)];
            for (end, relation, value) in ends.into_iter().filter(|(.., value)| value.is_finite()) {
                let bound = self.parameter(format!("{end}_{name}"), unit, value, String::new());
                self.sections.domain.push(format!("{name}_{end} = \"{coordinate} {relation} {bound}\""));
            }
        }
    }

    /// Writes the dry friction of a joint, smoothed below a rate that the description does not state.
    fn write_friction(&mut self, joint: &Joint, names: &JointNames) {
        let JointUnits { coordinate: unit, load } = JointUnits::of(joint);
        let name = &names.joint;
        let size =
            self.parameter(format!("f_{name}"), load, joint.friction, format!("dry friction of the joint {name}"));
        let about = "rate below which the dry friction is smoothed; the description states none".to_owned();
        let slow = self.parameter(format!("slow_{name}"), &format!("{unit}/s"), 0.01, about);
        let kind = if joint.motion == JointMotion::Hinge {
            format!("frame = \"{}\", axis = {}, torque = \"{size}\"", names.frame, names.axis + 1)
        } else {
            format!("at = \"{name}\", coefficient = 1, normal_force = \"{size}\"")
        };
        let (body, against) = (&names.body, names.against());
        self.sections
            .friction
            .push(format!("{name}_friction = {{ on = \"{body}\"{against}, {kind}, smoothing = \"{slow}\" }}"));
        let text = "the jump of dry friction at rest: the friction is smoothed below a rate of 0.01";
        Omission::add(&mut self.omissions, text);
    }

    /// Writes a rotor without mass on the ground that turns with the joint's coordinate: it adds the armature to the
    /// diagonal of the mass matrix. The rotor of a slide turns by the displacement over a lead of 1 m/rad.
    fn write_armature(&mut self, joint: &Joint, names: &JointNames) {
        let (name, coordinate) = (&names.joint, &names.coordinate);
        let rotor = self.names.reserve(&format!("{name}_rotor"), &["*", "*_frame"]);
        let is_turn = joint.motion == JointMotion::Hinge;
        let armature = self.declare(NewParameter {
            name: format!("J_{name}"),
            unit: if is_turn { "kg*m^2" } else { "kg" },
            value: joint.armature,
            about: format!("armature of the joint {name}"),
            is_positive: true,
        });
        let (angle, inertia) = if is_turn {
            (coordinate.clone(), armature)
        } else {
            let about = format!("travel of the joint {name} for each radian of its rotor");
            let lead = self.parameter(format!("lead_{name}"), "m/rad", 1.0, about);
            (format!("{coordinate}/{lead}"), format!("{armature}*{lead}^2"))
        };
        self.sections.frames.push(format!("{rotor}_frame = {{ from = \"N\", axis = 3, angle = \"{angle}\" }}"));
        let inertia = value_of(&inertia);
        self.sections
            .bodies
            .push(format!("{rotor} = {{ frame = \"{rotor}_frame\", centre = \"O\", mass = 0, inertia = {inertia} }}"));
    }

    /// Writes the damping of a ball joint: a torque against the angular velocity of the body relative to its carrier.
    pub(super) fn write_ball_damping(&mut self, joint: &Joint, name: &str, body: &str, carrier: Option<&str>) {
        if joint.damping == 0.0 {
            return;
        }
        let about = format!("damping of the joint {name}");
        let damping = self.parameter(format!("c_{name}"), "N*m*s/rad", joint.damping, about);
        let vector: Vec<String> = (1..=3).map(|axis| format!("\"-{damping}*u_{name}_{axis}\"")).collect();
        let against = carrier.map_or_else(String::new, |carrier| format!(", against = \"{carrier}\""));
        let vector = vector.join(", ");
        self.sections.torques.push(format!(
            "{name}_damping = {{ on = \"{body}\"{against}, frame = \"{body}_frame\", vector = [{vector}] }}"
        ));
    }

    /// Writes an actuator: its input and its load.
    pub(super) fn write_actuator(&mut self, actuator: &Actuator) {
        let joint = self.robot.joint(actuator.joint);
        let Some(names) = self.names_of(actuator.joint) else { return };
        let JointUnits { coordinate: unit, load } = JointUnits::of(joint);
        let (quantity, input_unit, gain_unit) = match actuator.input {
            ActuatorInput::Load => ("load", load.to_owned(), "1".to_owned()),
            ActuatorInput::Position => ("wanted position", unit.to_owned(), format!("{load}/{unit}")),
            ActuatorInput::Velocity => ("wanted rate", format!("{unit}/s"), format!("{load}*s/{unit}")),
            ActuatorInput::Control => ("control", "1".to_owned(), load.to_owned()),
        };
        let input = self.names.reserve(&actuator.name, &["*"]);
        let about = quoted(&format!("{quantity} of the drive of {}", names.joint));
        self.sections.inputs.push(format!("{input} = {{ unit = \"{input_unit}\", about = {about} }}"));
        let is_direct = actuator.input == ActuatorInput::Load && actuator.gain - 1.0 == 0.0;
        let mut terms = vec![if is_direct {
            input.clone()
        } else {
            let gain = self.parameter(format!("gain_{input}"), &gain_unit, actuator.gain, String::new());
            format!("{gain}*{input}")
        }];
        let coordinate = &names.coordinate;
        for (prefix, unit, value, factor) in [
            ("bias", load.to_owned(), actuator.bias, String::new()),
            ("kp", format!("{load}/{unit}"), actuator.position_gain, format!("*{coordinate}")),
            ("kv", format!("{load}*s/{unit}"), actuator.velocity_gain, format!("*{coordinate}'")),
        ] {
            if value != 0.0 {
                let gain = self.parameter(format!("{prefix}_{input}"), &unit, value, String::new());
                terms.push(format!("{gain}{factor}"));
            }
        }
        let name = self.names.reserve(&format!("{}_drive", names.joint), &["*"]);
        self.write_load(joint, &names, &name, &terms.join(" + "));
    }
}

impl JointNames {
    /// Key `against` of a load of the joint, with a comma before it; empty for a joint on the ground.
    fn against(&self) -> String {
        self.carrier.as_ref().map_or_else(String::new, |carrier| format!(", against = \"{carrier}\""))
    }
}
