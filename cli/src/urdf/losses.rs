//! Damping and dry friction of joints, recognised among the loads of a model.

use super::chains::{FrameTurn, Places};
use super::numbers::Numbers;
use super::tree::{NodeMotion, Tree};
use nalgebra::Vector3;
use tripos_derive::algebra::value::zero_test::{ZeroTest, zero_test};
use tripos_derive::algebra::{Expr, Function, Node, Rational};
use tripos_derive::geometry::{Frames, apply_tensor};

/// Relative difference up to which two directions count as one, as rounding of doubles.
const ROUNDING: f64 = 1e-11;

/// Loss of a joint.
#[derive(Clone, Copy, Debug)]
pub enum Loss {
    /// Viscous damping, N m s or N s/m.
    Damping(f64),
    /// Dry friction, N m or N, with the rate below which the model smooths it, rad/s or m/s.
    Friction(f64, f64),
}

/// Load between two nodes of the tree: a torque, or a force at a point.
pub struct NodeLoad {
    /// Index of the node on which the load acts.
    pub on: usize,
    /// Index of the node on which the opposite load acts.
    pub against: usize,
    /// True for a torque, false for a force.
    pub is_torque: bool,
    /// Index of the frame of the components.
    pub frame: usize,
    /// Components, N m or N.
    pub vector: [Expr; 3],
}

/// Joint along which a load may be a loss.
struct LossyJoint {
    /// Index of the node.
    node: usize,
    /// Symbol of the rate of its coordinate.
    rate: Expr,
    /// Angle or displacement of the joint for each unit of the coordinate.
    factor: f64,
    /// 1 if the load acts on the moved node, −1 if it acts on the carrier.
    sense: f64,
}

impl NodeLoad {
    /// Loss of a joint in the load, with the index of the joint's node. The last result is true if the load has further
    /// parts. `None` for a load without losses.
    pub fn loss(&self, places: &Places<'_>, tree: &Tree, numbers: &mut Numbers) -> Option<(usize, Loss, bool)> {
        let joint = self.joint(tree, numbers)?;
        let vector = self.vector.map(|component| numbers.without_speeds(component));
        if let Some(axis) = direction_in(places, tree, joint.node, self.frame)
            && let Some((coefficient, has_more)) =
                damping(numbers, &vector, joint.rate, &(axis * joint.sense * joint.factor))
        {
            return Some((joint.node, Loss::Damping(coefficient), has_more));
        }
        // In the axes of the joint, the direction of its axis is constant.
        let group = tree.nodes[joint.node].group;
        let rotation = Frames::new(&places.model.frames).rotation(&mut numbers.arena, self.frame, group);
        let vector = apply_tensor(&mut numbers.arena, &rotation, &vector);
        let axis = direction_in(places, tree, joint.node, group)? * joint.sense;
        friction(numbers, &vector, joint.rate, &axis, joint.factor).map(|loss| (joint.node, loss, false))
    }

    /// Joint between the two nodes of the load. `None` if no joint with one coordinate connects them, or if the load is
    /// of another kind than its motion.
    fn joint(&self, tree: &Tree, numbers: &Numbers) -> Option<LossyJoint> {
        let carries = |carrier: usize, node: usize| tree.nodes[node].carrier == carrier && node != carrier;
        let (node, sense) = if carries(self.against, self.on) {
            (self.on, 1.0)
        } else if carries(self.on, self.against) {
            (self.against, -1.0)
        } else {
            return None;
        };
        let (coordinate, factor) = match tree.nodes[node].motion {
            NodeMotion::Turn { coordinate, slope, .. } if self.is_torque => (coordinate, slope),
            NodeMotion::Slide { coordinate, vector } if !self.is_torque => (coordinate, vector.norm()),
            _ => return None,
        };
        Some(LossyJoint { node, rate: numbers.rates[coordinate], factor, sense })
    }
}

/// Coefficient c of a load −c · rate · axis. The second result is true if the load has further parts, none of which
/// contains the rate. `None` for other loads.
fn damping(numbers: &mut Numbers, vector: &[Expr; 3], rate: Expr, axis: &Vector3<f64>) -> Option<(f64, bool)> {
    let mut slopes = Vector3::zeros();
    let mut has_more = false;
    for (number, component) in slopes.iter_mut().zip(vector) {
        let slope = numbers.slope(*component, rate);
        *number = numbers.constant(slope)?;
        let damped = numbers.arena.mul(slope, rate);
        let rest = numbers.arena.sub(*component, damped);
        has_more |= zero_test(&numbers.arena, rest) != ZeroTest::Zero;
    }
    let coefficient = -slopes.dot(axis) / axis.norm_squared();
    let is_along = (slopes + axis * coefficient).norm() <= ROUNDING * slopes.norm();
    (coefficient > 0.0 && is_along).then_some((coefficient, has_more))
}

/// Smooth dry friction: a load −F s/√(s² + s₀²) along the axis, with the rate s = factor · rate of the joint. `None`
/// for other loads.
///
/// The square under the root is K rate² + rest, so that each component times the root over the rate is a constant.
/// Exact tests for zero prove it, also where the components contain other coordinates and rates that cancel.
fn friction(numbers: &mut Numbers, vector: &[Expr; 3], rate: Expr, axis: &Vector3<f64>, factor: f64) -> Option<Loss> {
    let square = numbers.arena.reachable(vector).into_iter().find_map(|part| match numbers.arena.node(part) {
        Node::Apply(Function::Sqrt, square) if numbers.arena.mentions(*square, rate) => Some(*square),
        _ => None,
    })?;
    let first = numbers.slope(square, rate);
    let second = numbers.slope(first, rate);
    let product = numbers.arena.mul(rate, second);
    let linear = numbers.arena.sub(first, product);
    let half = numbers.arena.mul(rate, first);
    let half = numbers.arena.scale(half, &Rational::fraction(1, 2)?);
    let rest = numbers.arena.sub(square, half);
    let root = numbers.arena.apply(Function::Sqrt, square);
    let mut constants = vec![second, rest];
    for component in vector {
        let product = numbers.arena.mul(*component, root);
        constants.push(numbers.arena.div(product, rate)?);
    }
    let all = numbers.coordinates.iter().chain(&numbers.rates).copied();
    let mentioned: Vec<Expr> =
        all.filter(|symbol| constants.iter().any(|term| numbers.arena.mentions(*term, *symbol))).collect();
    let mut vanishing = vec![linear];
    for term in &constants {
        vanishing.extend(mentioned.iter().map(|symbol| numbers.slope(*term, *symbol)));
    }
    if vanishing.into_iter().any(|term| zero_test(&numbers.arena, term) != ZeroTest::Zero) {
        return None;
    }
    // The terms are constant: any values of the symbols in them give their numbers.
    let state: Vec<(Expr, f64)> =
        mentioned.iter().enumerate().map(|(at, symbol)| (*symbol, 0.5 + 0.1 * at as f64)).collect();
    let mut values = Vec::new();
    for term in constants {
        values.push(numbers.value(term, &state)?);
    }
    let [second, rest, x, y, z] = values[..] else { return None };
    let (curvature, ratios) = (second / 2.0, Vector3::new(x, y, z));
    let size = -ratios.dot(axis) * factor.signum() / curvature.sqrt();
    let is_along = (ratios - axis * ratios.dot(axis)).norm() <= ROUNDING * ratios.norm();
    (size > 0.0 && rest > 0.0 && is_along).then(|| Loss::Friction(size, (rest / curvature).sqrt() * factor.abs()))
}

/// Direction of a node's axis in a frame, of length 1. `None` if the direction changes in this frame.
fn direction_in(places: &Places<'_>, tree: &Tree, node: usize, frame: usize) -> Option<Vector3<f64>> {
    let own = &tree.nodes[node];
    let wanted = places.frames[frame].group;
    let to_frame = places.frames[frame].in_group.transpose();
    let mut group = tree.nodes[own.carrier].group;
    let mut direction = match own.motion {
        NodeMotion::Turn { axis, .. } if own.group == wanted => return Some(to_frame * Vector3::ith(axis, 1.0)),
        NodeMotion::Turn { axis, .. } => own.origin.rotation * Vector3::ith(axis, 1.0),
        NodeMotion::Slide { vector, .. } => {
            group = own.group;
            vector.normalize()
        }
        _ => return None,
    };
    while group != wanted {
        let facts = &places.frames[group];
        let FrameTurn::About { axis, .. } = facts.turn else { return None };
        let along = Vector3::ith(axis, direction[axis]);
        if (direction - along).norm() > ROUNDING {
            return None;
        }
        direction = places.frames[facts.before].in_group * along;
        group = places.group_before(group)?;
    }
    Some(to_frame * direction)
}
