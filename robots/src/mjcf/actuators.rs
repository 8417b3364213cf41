//! `<actuator>` of MJCF files: actuators of joints as inputs of the model.

use super::Reader;
use crate::robot::{Actuator, ActuatorInput};
use crate::xml::{elements, has_nonzero_number};
use roxmltree::Node;

impl<'a> Reader<'a, '_> {
    /// Reads `<actuator>`. Actuators of tendons, sites and bodies, and those with a state of their own, are left out.
    pub(super) fn read_actuators(&mut self, node: Node<'a, '_>) {
        for child in elements(node) {
            let tag = child.tag_name().name();
            let name = child
                .attribute("name")
                .map_or_else(|| format!("drive{}", self.robot.actuators.len() + 1), str::to_owned);
            let attribute = if child.has_attribute("jointinparent") { "jointinparent" } else { "joint" };
            if !child.has_attribute(attribute) {
                self.reading.omit(format!("actuator `{tag}` that acts on no joint"));
                continue;
            }
            let Some(joint) = self.named_joint(child, attribute) else { continue };
            let element = self.defaults.element(child, None, self.reading);
            for (property, what) in [
                ("ctrlrange", "range of the input"),
                ("forcerange", "limit of the load"),
                ("timeconst", "time constant"),
                ("damping", "damping"),
                ("delay", "delay"),
            ] {
                if element.text(property).is_some_and(has_nonzero_number) {
                    self.reading.omit(format!("{what} of the actuator {name}"));
                }
            }
            let number = |name: &str, default: f64| element.number(name, self.reading).unwrap_or(default);
            let has_state = element.text("dyntype").is_some_and(|kind| kind != "none");
            let list = |name: &str| element.numbers(name, self.reading).unwrap_or_default();
            // Gain, bias, and the gains of length and rate.
            let law = match tag {
                "motor" => Some((1.0, 0.0, 0.0, 0.0, ActuatorInput::Load)),
                "position" => {
                    let stiffness = number("kp", 1.0);
                    if element.text("dampratio").is_some() {
                        self.reading.omit(format!("damping ratio of the actuator {name}"));
                    }
                    Some((stiffness, 0.0, -stiffness, -number("kv", 0.0), ActuatorInput::Position))
                }
                "velocity" => {
                    let damping = number("kv", 1.0);
                    Some((damping, 0.0, 0.0, -damping, ActuatorInput::Velocity))
                }
                "general" if !has_state => {
                    let gain = list("gainprm").first().copied().unwrap_or(1.0);
                    let has_bias = element.text("biastype") == Some("affine");
                    let bias = |at: usize| if has_bias { list("biasprm").get(at).copied().unwrap_or(0.0) } else { 0.0 };
                    let is_fixed = element.text("gaintype").is_none_or(|kind| kind == "fixed");
                    is_fixed.then(|| (gain, bias(0), bias(1), bias(2), ActuatorInput::Control))
                }
                _ => None,
            };
            let Some((gain, bias, position_gain, velocity_gain, input)) = law else {
                self.reading.omit(format!("actuator {name} (`{tag}`), which has no linear law of one joint"));
                continue;
            };
            let gear = list("gear").first().copied().unwrap_or(1.0);
            if let Some(armature) = element.number("armature", self.reading) {
                self.robot.bodies[joint.body].joints[joint.joint].armature += armature * gear * gear;
            }
            let is_plain = gear - 1.0 == 0.0 || input == ActuatorInput::Load;
            self.robot.actuators.push(Actuator {
                name,
                joint,
                gain: gain * gear,
                bias: bias * gear,
                position_gain: position_gain * gear * gear,
                velocity_gain: velocity_gain * gear * gear,
                input: if is_plain { input } else { ActuatorInput::Control },
            });
        }
    }
}
