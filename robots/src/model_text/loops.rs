//! Joints that close loops, and equations between coordinates of a model file.

use super::bodies::JOINT_AFFIXES;
use super::{Coordinate, Writer};
use crate::numbers::number_text;
use crate::robot::{Coupling, JointIndex, JointMotion, Loop, LoopKind};

impl Writer<'_> {
    /// Writes a joint that closes a loop.
    pub(super) fn write_loop(&mut self, one: &Loop) {
        // The joint belongs to a body; the other end may be the ground.
        let (body, body_pose, carrier, carrier_pose) = match (one.second, one.first) {
            (Some(second), first) => (second, &one.second_pose, first, &one.first_pose),
            (None, Some(first)) => (first, &one.first_pose, None, &one.second_pose),
            (None, None) => return,
        };
        let name = self.names.reserve(&one.name, JOINT_AFFIXES);
        let kind = match one.kind {
            LoopKind::Connect => "ball",
            LoopKind::Weld => "weld",
            LoopKind::Hinge(_) => "pin",
        };
        let body_name = self.bodies[body].body.clone();
        let mut keys = vec![format!("kind = \"{kind}\"")];
        if let LoopKind::Hinge(axis) = one.kind {
            keys.push(format!("axis = {}", axis + 1));
        }
        keys.push(format!("body = \"{body_name}\""));
        let on = carrier.map_or_else(|| "the ground".to_owned(), |carrier| self.bodies[carrier].body.clone());
        keys.extend(carrier.map(|_| format!("to = \"{on}\"")));
        let (carrier_pose, body_pose) = (self.on_body(carrier, carrier_pose).2, self.on_body(Some(body), body_pose).2);
        let origin = || "[0, 0, 0]".to_owned();
        let at = self.position("", &name, &carrier_pose.position, &format!("position of {name} on {on}"));
        keys.push(format!("at = {}", at.unwrap_or_else(origin)));
        let about = format!("position of {name} on {body_name}");
        let body_at = self.position("", &format!("{name}_{body_name}"), &body_pose.position, &about);
        keys.push(format!("body_at = {}", body_at.unwrap_or_else(origin)));
        if one.kind != LoopKind::Connect {
            keys.extend(self.turn(&name, &carrier_pose.rotation).map(|turn| format!("turned = {{ {turn} }}")));
            let turn = self.turn(&format!("{name}_{body_name}"), &body_pose.rotation);
            keys.extend(turn.map(|turn| format!("body_turned = {{ {turn} }}")));
        }
        let line = format!("{name} = {{ {} }}", keys.join(", "));
        self.stated.push((line.clone(), one.place.clone()));
        self.sections.joints.push(line);
    }

    /// Writes the equations between coordinates.
    pub(super) fn write_couplings(&mut self) {
        for coupling in &self.robot.couplings {
            self.write_coupling(coupling);
        }
    }

    /// Writes an equation between coordinates, with a parameter for each coefficient that is not 1.
    fn write_coupling(&mut self, coupling: &Coupling) {
        let Some(names) = self.names_of(coupling.follower) else { return };
        let unit = self.coordinate_unit(coupling.follower);
        let leader = coupling.leader.and_then(|leader| Some((self.names_of(leader)?.coordinate, leader)));
        let leader_unit = leader.as_ref().map_or("1", |(_, index)| self.coordinate_unit(*index));
        let mut terms = Vec::new();
        for (power, coefficient) in coupling.coefficients.iter().enumerate().filter(|(_, value)| **value != 0.0) {
            let factor = match (&leader, power) {
                (_, 0) => None,
                (Some((leader, _)), 1) => Some(leader.clone()),
                (Some((leader, _)), power) => Some(format!("{leader}^{power}")),
                (None, _) => continue,
            };
            if power == 1
                && unit == leader_unit
                && coefficient - 1.0 == 0.0
                && let Some(factor) = factor
            {
                terms.push(factor);
                continue;
            }
            let coefficient_unit = match power {
                0 => unit.to_owned(),
                1 => format!("{unit}/{leader_unit}"),
                power => format!("{unit}/{leader_unit}^{power}"),
            };
            let about = format!("coefficient {power} of the coupling of {}", names.joint);
            let symbol = self.parameter(format!("a{power}_{}", names.joint), &coefficient_unit, *coefficient, about);
            terms.push(factor.map_or_else(|| symbol.clone(), |factor| format!("{symbol}*{factor}")));
        }
        let right = if terms.is_empty() { "0".to_owned() } else { terms.join(" + ") };
        let name = self.names.reserve(&format!("{}_follows", names.joint), &["*"]);
        self.sections.constraints.push(format!("{name} = \"{} = {right}\"", names.coordinate));
    }

    /// Writes the pose near which the loops of a robot are closed.
    pub(super) fn write_assembly(&mut self) {
        if self.robot.loops.is_empty() {
            return;
        }
        for Coordinate { name, reference, .. } in &self.coordinates {
            self.sections.assembly.push(format!("{name} = {}", number_text(*reference)));
        }
        // Without values of the file, its first loop stands for the pose in which the loops are closed.
        let place = self.robot.assembly_place.clone().or_else(|| Some(self.robot.loops.first()?.place.clone()));
        self.stated.extend(place.map(|place| ("[assembly]".to_owned(), place)));
    }

    /// Unit of the coordinate of a hinge or a slide.
    fn coordinate_unit(&self, index: JointIndex) -> &'static str {
        if self.robot.joint(index).motion == JointMotion::Hinge { "rad" } else { "m" }
    }
}
