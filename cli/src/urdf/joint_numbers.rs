//! Limits and losses of joints.

use super::builder::LinkBuilder;
use super::limits::coordinate_limits;
use super::losses::{Loss, NodeLoad};
use super::remarks::names;
use super::tree::NodePlace;
use tripos_derive::Model;

/// Limits and losses of all joints.
pub struct JointNumbers {
    /// Smallest and largest value of each coordinate, infinite without a limit.
    pub limits: Vec<(f64, f64)>,
    /// Losses, each with the index of its node.
    losses: Vec<(usize, Loss)>,
}

impl JointNumbers {
    /// Viscous damping and dry friction of a node's joint.
    pub fn damping_and_friction(&self, node: usize) -> (f64, f64) {
        let own = self.losses.iter().filter(|(at, _)| *at == node);
        own.fold((0.0, 0.0), |(damping, friction), (_, loss)| match loss {
            Loss::Damping(more) => (damping + more, friction),
            Loss::Friction(more, _) => (damping, friction + more),
        })
    }
}

impl LinkBuilder<'_> {
    /// Finds the limits and losses of all joints. Conditions and loads that are none of these are added to the remarks.
    pub(super) fn joint_numbers(&mut self, remarks: &mut Vec<String>) -> JointNumbers {
        let (limits, others) = coordinate_limits(self.model, &self.tree, &mut self.numbers);
        if !others.is_empty() {
            remarks.push(format!(
                "conditions {}: none is a constant bound of a joint with one coordinate, or they exclude one another",
                names(others.into_iter())
            ));
        }
        let (mut losses, mut left, mut parts) = (Vec::new(), Vec::new(), Vec::new());
        let mut smooth: Vec<(&str, f64)> = Vec::new();
        for (name, load) in node_loads(self.model, &self.centres) {
            match load.and_then(|load| load.loss(&self.places, &self.tree, &mut self.numbers)) {
                Some((node, loss, has_more)) => {
                    losses.push((node, loss));
                    if has_more {
                        parts.push(name);
                    }
                    if let Loss::Friction(_, rate) = loss {
                        smooth.push((name, rate));
                    }
                }
                None => left.push(name),
            }
        }
        if !left.is_empty() {
            let left = names(left.into_iter());
            remarks.push(format!(
                "loads {left}: none is damping or dry friction between a link and the link that carries it"
            ));
        }
        if !parts.is_empty() {
            remarks.push(format!("loads {}: only their damping is written", names(parts.into_iter())));
        }
        if let Some((_, rate)) = smooth.iter().max_by(|one, other| one.1.total_cmp(&other.1)) {
            let list = names(smooth.iter().map(|(name, _)| *name));
            remarks.push(format!(
                "smoothing of {list} below rates of {rate:.3e} rad/s or m/s: the friction of URDF is dry"
            ));
        }
        JointNumbers { limits, losses }
    }
}

/// Loads of the model between nodes, each with its name. `None` for a load on a frame without a body, and for a
/// force whose opposite acts at another point.
fn node_loads<'m>(model: &'m Model, centres: &[NodePlace]) -> Vec<(&'m str, Option<NodeLoad>)> {
    let node_of = |body: Option<usize>| body.map_or(0, |body| centres[body].node);
    let mut list: Vec<(&'m str, Option<NodeLoad>)> = Vec::new();
    for torque in &model.torques {
        let against = match torque.against {
            None => Some(0),
            Some((_, body)) => body.map(|body| node_of(Some(body))),
        };
        let load = torque.on.1.zip(against).map(|(on, against)| NodeLoad {
            on: node_of(Some(on)),
            against,
            is_torque: true,
            frame: torque.frame,
            vector: torque.vector,
        });
        list.push((&torque.name, load));
    }
    for force in &model.forces {
        let is_at_one_place = force.against.is_none_or(|against| against.point == force.on.point);
        let load = is_at_one_place.then(|| NodeLoad {
            on: node_of(Some(force.on.body)),
            against: node_of(force.against.map(|against| against.body)),
            is_torque: false,
            frame: force.frame,
            vector: force.vector,
        });
        list.push((&force.name, load));
    }
    list
}
