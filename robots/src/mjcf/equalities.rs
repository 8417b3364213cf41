//! `<equality>` of MJCF files: loops, and equations between joint coordinates.

use super::{NamedFrame, Reader};
use crate::pose::{Pose, quaternion_turn};
use crate::robot::{Coupling, JointIndex, Loop, LoopKind};
use crate::xml::{attribute_place, elements, place};
use roxmltree::Node;
use tripos_derive::diagnostic::nearest_name_advice;

impl<'a> Reader<'a, '_> {
    /// Reads `<equality>`.
    pub(super) fn read_equalities(&mut self, node: Node<'a, '_>) {
        for child in elements(node) {
            let element = self.defaults.element_as("equality", child, None, self.reading);
            let tag = child.tag_name().name();
            if element.text("active") == Some("false") {
                self.reading.omit(format!("`{tag}` that is not active"));
                continue;
            }
            match tag {
                "connect" => self.read_connection(child, LoopKind::Connect),
                "weld" => self.read_connection(child, LoopKind::Weld),
                "joint" => self.read_coupling(child),
                other => self.reading.omit(format!("equality `{other}`")),
            }
        }
    }

    /// Reads a connection of two bodies, or of two sites.
    fn read_connection(&mut self, node: Node<'a, '_>, kind: LoopKind) {
        let ends = if node.has_attribute("site1") || node.has_attribute("site2") {
            self.site_ends(node)
        } else {
            self.body_ends(node, kind)
        };
        let Some((first, second)) = ends else { return };
        if first.body == second.body {
            let message = "both ends of this connection are on the same body";
            self.reading.add(place(node), message, "name two different bodies");
            return;
        }
        let count = self.robot.loops.len() + 1;
        self.robot.loops.push(Loop {
            name: node.attribute("name").map_or_else(|| format!("loop{count}"), str::to_owned),
            kind,
            first: first.body,
            first_pose: first.pose,
            second: second.body,
            second_pose: second.pose,
            place: place(node),
        });
    }

    /// Ends of a connection of sites. `None` after recording a mistake.
    fn site_ends(&self, node: Node<'a, '_>) -> Option<(NamedFrame, NamedFrame)> {
        let end = |attribute: &str| {
            let name = node.attribute(attribute).unwrap_or_default();
            let site = self.sites.get(name).cloned();
            if site.is_none() {
                let advice = nearest_name_advice(name, self.sites.keys().copied());
                self.reading.add(attribute_place(node, attribute), format!("there is no site `{name}`"), advice);
            }
            site
        };
        let (first, second) = (end("site1"), end("site2"));
        Some((first?, second?))
    }

    /// Ends of a connection of bodies. The pose on the other body is that of the reference configuration. `None`
    /// after recording a mistake.
    fn body_ends(&self, node: Node<'a, '_>, kind: LoopKind) -> Option<(NamedFrame, NamedFrame)> {
        let element = self.defaults.element(node, None, self.reading);
        let body = |attribute: &str| -> Option<Option<usize>> {
            let Some(name) = node.attribute(attribute) else {
                if attribute == "body1" {
                    self.reading.add(place(node), "this connection names no body", "add `body1=\"…\"`");
                    return None;
                }
                return Some(None);
            };
            if name == "world" {
                return Some(None);
            }
            let found = self.bodies.get(name).copied();
            if found.is_none() {
                let advice = nearest_name_advice(name, self.bodies.keys().copied());
                self.reading.add(attribute_place(node, attribute), format!("there is no body `{name}`"), advice);
            }
            found.map(Some)
        };
        let (first, second) = (body("body1"), body("body2"));
        let (first, second) = (first?, second?);
        let on_ground =
            |body: Option<usize>| body.map_or_else(Pose::default, |body| self.reference_poses[body].clone());
        let relative = on_ground(first).inverse().compose(&on_ground(second));
        let anchor = element.vector("anchor", self.reading);
        let (first_pose, second_pose) = match kind {
            LoopKind::Connect => {
                let Some(anchor) = anchor else {
                    if element.text("anchor").is_none() {
                        self.reading.add(place(node), "this connection has no anchor", "add `anchor=\"…\"`");
                    }
                    return None;
                };
                let pose = Pose::at(anchor);
                let other = relative.inverse().compose(&pose);
                (pose, Pose::at(other.position))
            }
            LoopKind::Weld | LoopKind::Hinge(_) => {
                let at = Pose::at(anchor.unwrap_or_default());
                match element.fixed::<7>("relpose", self.reading) {
                    // The stated position is that of the second body's anchor in the axes of the first body.
                    Some([x, y, z, w, a, b, c]) if [w, a, b, c].iter().any(|part| *part != 0.0) => {
                        (Pose { position: [x, y, z].into(), rotation: quaternion_turn(w, a, b, c) }, at)
                    }
                    _ => (relative.compose(&at), at),
                }
            }
        };
        Some((NamedFrame { body: first, pose: first_pose }, NamedFrame { body: second, pose: second_pose }))
    }

    /// Reads an equation between two joint coordinates, q₁ − ref₁ = Σ cᵢ (q₂ − ref₂)ⁱ.
    fn read_coupling(&mut self, node: Node<'a, '_>) {
        let element = self.defaults.element(node, None, self.reading);
        let Some(follower) = self.named_joint(node, "joint1") else { return };
        let leader = self.named_joint_if_stated(node, "joint2");
        let Ok(leader) = leader else { return };
        if leader == Some(follower) {
            self.reading.add(place(node), "a joint is coupled with itself", "name two different joints");
            return;
        }
        let stated = element.numbers("polycoef", self.reading).unwrap_or_else(|| vec![0.0, 1.0]);
        let used = if leader.is_some() { 5 } else { 1 };
        let about_reference: Vec<f64> = stated.into_iter().take(used).collect();
        let reference = leader.map_or(0.0, |leader| self.robot.joint(leader).reference);
        let mut coefficients = shifted_polynomial(&about_reference, reference);
        if coefficients.is_empty() {
            coefficients.push(0.0);
        }
        coefficients[0] += self.robot.joint(follower).reference;
        self.robot.couplings.push(Coupling { follower, leader, coefficients });
    }

    /// Joint with one coordinate that an attribute names; `None` if the attribute is absent. Error after recording a
    /// mistake.
    fn named_joint_if_stated(&self, node: Node<'a, '_>, attribute: &str) -> Result<Option<JointIndex>, ()> {
        if !node.has_attribute(attribute) {
            return Ok(None);
        }
        self.named_joint(node, attribute).map(Some).ok_or(())
    }

    /// Joint with one coordinate that an attribute names. `None` after recording a mistake.
    pub(super) fn named_joint(&self, node: Node<'a, '_>, attribute: &str) -> Option<JointIndex> {
        let Some(name) = node.attribute(attribute) else {
            self.reading.add(place(node), format!("`{attribute}` is missing"), format!("add `{attribute}=\"…\"`"));
            return None;
        };
        let place = attribute_place(node, attribute);
        let Some(joint) = self.joints.get(name).copied() else {
            let advice = nearest_name_advice(name, self.joints.keys().copied());
            self.reading.add(place, format!("there is no joint `{name}`"), advice);
            return None;
        };
        if !self.robot.joint(joint).has_one_coordinate() {
            let message = format!("the joint `{name}` has several coordinates");
            self.reading.add(place, message, "name a hinge or a slide");
            return None;
        }
        Some(joint)
    }
}

/// Coefficients in powers of x of the polynomial Σ cᵢ (x − x₀)ⁱ.
fn shifted_polynomial(coefficients: &[f64], reference: f64) -> Vec<f64> {
    let mut shifted: Vec<f64> = Vec::new();
    // Horner's scheme: multiply by (x − x₀), and add the next coefficient.
    for coefficient in coefficients.iter().rev() {
        let mut next = vec![0.0; shifted.len() + 1];
        for (power, value) in shifted.iter().enumerate() {
            next[power + 1] += value;
            next[power] -= value * reference;
        }
        next[0] += coefficient;
        shifted = next;
    }
    while shifted.len() > 1 && shifted.last() == Some(&0.0) {
        shifted.pop();
    }
    shifted
}
