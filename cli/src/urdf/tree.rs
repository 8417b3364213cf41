//! Tree of joints that the chains of all bodies share.

use super::chains::{Chain, FrameTurn, Places, ROUNDING, Step};
use nalgebra::{Matrix3, Vector3};
use tripos_robots::{Pose, axis_turn};

/// Motion by which a node moves relative to the node that carries it.
#[derive(Clone, Copy, Debug)]
pub enum NodeMotion {
    /// No motion: the ground.
    Ground,
    /// Displacement by `vector` for each unit of the coordinate, in the axes of the node.
    Slide {
        /// Index of the coordinate.
        coordinate: usize,
        /// Displacement for each unit of the coordinate.
        vector: Vector3<f64>,
    },
    /// Turn by slope · coordinate + constant about an axis of the node.
    Turn {
        /// Index of the coordinate.
        coordinate: usize,
        /// Axis of the turn, from 0.
        axis: usize,
        /// Angle for each unit of the coordinate.
        slope: f64,
        /// Angle where the coordinate is 0, rad.
        constant: f64,
    },
    /// Rotation by Euler parameters, the indices of their coordinates.
    EulerParameters([usize; 4]),
    /// Two displacements across an axis and a turn about it: a planar joint.
    Planar {
        /// Indices of the coordinates, that of the turn last.
        coordinates: [usize; 3],
        /// Axis of the turn, from 0. The displacements are along the two axes after it.
        axis: usize,
    },
    /// Three displacements and four Euler parameters, the indices of their coordinates: a free joint.
    Free([usize; 7]),
}

/// Node of the tree: axes that one joint moves.
#[derive(Clone, Debug)]
pub struct TreeNode {
    /// Index of the node before this one in the chains of bodies. The ground is before itself.
    before: usize,
    /// Index of the node that carries this one in the description. It is the node before, except after a joint with
    /// several coordinates.
    pub carrier: usize,
    /// Pose of the node's axes in those of the carrier before the motion.
    pub origin: Pose,
    /// Motion of the joint.
    pub motion: NodeMotion,
    /// Coordinate and vector of a slide, also after it was joined with a turn.
    slide: Option<(usize, Vector3<f64>)>,
    /// Index of the frame in whose group the node's axes are those of the first frame.
    pub group: usize,
    /// False for a node that was joined with the next one, as part of a joint with several coordinates.
    pub is_kept: bool,
}

/// Place on a node: the index of the node, and the position in its axes, m.
#[derive(Clone, Copy, Debug)]
pub struct NodePlace {
    /// Index of the node.
    pub node: usize,
    /// Position of the point in the axes of the node, m.
    pub position: Vector3<f64>,
}

/// Tree of joints. The first node is the ground.
pub struct Tree {
    /// Nodes; each stands after the one that carries it.
    pub nodes: Vec<TreeNode>,
    /// Numbers of chains that have a slide by a coordinate, by the coordinate. Slides that more chains have come first.
    sliding: Vec<usize>,
    /// Length of the longest constant displacement of the chains, m. Places near the origin of a node may differ by the
    /// rounding of such displacements.
    longest: f64,
}

impl Tree {
    /// Creates the tree of the ground alone, for the given chains in a model with `count` coordinates.
    pub fn new<'c>(chains: impl Iterator<Item = &'c Chain>, count: usize) -> Self {
        let ground = TreeNode {
            before: 0,
            carrier: 0,
            origin: Pose::default(),
            motion: NodeMotion::Ground,
            group: 0,
            slide: None,
            is_kept: true,
        };
        let mut sliding = vec![0; count];
        let mut longest = 0.0_f64;
        for step in chains.flat_map(|chain| &chain.steps) {
            match step {
                Step::Slide(coordinate, _) => sliding[*coordinate] += 1,
                Step::Shift(shift) => longest = longest.max(shift.norm()),
                Step::Turn(_) => {}
            }
        }
        Self { nodes: vec![ground], sliding, longest }
    }

    /// Follows a chain from the ground, and adds the nodes that the tree does not have. Returns the place of the
    /// chain's end.
    pub fn add(&mut self, places: &Places<'_>, chain: &Chain) -> NodePlace {
        let (mut node, mut position) = (0, Vector3::zeros());
        for step in self.ordered_steps(chain) {
            (node, position) = match self.next(places, node, position, &step) {
                Some(next) => next,
                None => self.push(places, node, position, &step),
            };
        }
        NodePlace { node, position }
    }

    /// Place of a chain's end. `None` if the tree has no such node, or if the node was joined with another.
    pub fn find(&self, places: &Places<'_>, chain: &Chain) -> Option<NodePlace> {
        let (mut node, mut position) = (0, Vector3::zeros());
        for step in self.ordered_steps(chain) {
            (node, position) = self.next(places, node, position, &step)?;
        }
        self.nodes[node].is_kept.then_some(NodePlace { node, position })
    }

    /// Steps of a chain, with the slides of one group in the order of the tree. Slides in one direction after another
    /// give the same place in any order.
    fn ordered_steps(&self, chain: &Chain) -> Vec<Step> {
        let mut steps = chain.steps.clone();
        for slides in steps.chunk_by_mut(|one, other| matches!((one, other), (Step::Slide(..), Step::Slide(..)))) {
            slides.sort_by_key(|step| match step {
                Step::Slide(coordinate, _) => (usize::MAX - self.sliding[*coordinate], *coordinate),
                Step::Shift(_) | Step::Turn(_) => (0, 0),
            });
        }
        steps
    }

    /// Node and position after a step from a position on a node. `None` if the tree has no such node.
    fn next(
        &self,
        places: &Places<'_>,
        node: usize,
        position: Vector3<f64>,
        step: &Step,
    ) -> Option<(usize, Vector3<f64>)> {
        let mut after = (1..self.nodes.len()).filter(|at| self.nodes[*at].before == node);
        match step {
            Step::Shift(shift) => Some((node, position + shift)),
            Step::Slide(coordinate, vector) => {
                let is_same = |at: &usize| match self.nodes[*at].slide {
                    Some((own, along)) => own == *coordinate && (along - vector).norm() <= ROUNDING * vector.norm(),
                    None => false,
                };
                after.find(is_same).map(|at| (at, position))
            }
            Step::Turn(frame) => {
                let facts = &places.frames[*frame];
                let to_axes = places.frames[facts.before].in_group.transpose();
                after.filter(|at| self.nodes[*at].group == *frame).find_map(|at| {
                    let child = &self.nodes[at];
                    let difference = to_axes * (position - child.origin.position);
                    // Joints about one axis at two places along it are one joint.
                    let mut along = Vector3::zeros();
                    if let FrameTurn::About { axis, .. } = facts.turn {
                        along[axis] = difference[axis];
                    }
                    let size = self.longest + position.norm() + child.origin.position.norm();
                    ((difference - along).norm() <= ROUNDING * size).then_some((at, along))
                })
            }
        }
    }

    /// Adds the node that a step moves from a position on a node. Returns the node, and the position on it.
    fn push(&mut self, places: &Places<'_>, node: usize, position: Vector3<f64>, step: &Step) -> (usize, Vector3<f64>) {
        let (origin, motion, group, slide, rest) = match step {
            Step::Shift(shift) => return (node, position + shift),
            Step::Slide(coordinate, vector) => {
                let motion = NodeMotion::Slide { coordinate: *coordinate, vector: *vector };
                let slide = Some((*coordinate, *vector));
                (Pose::default(), motion, self.nodes[node].group, slide, position)
            }
            Step::Turn(frame) => {
                let facts = &places.frames[*frame];
                let motion = match facts.turn {
                    FrameTurn::About { axis, coordinate, slope, constant } => {
                        NodeMotion::Turn { coordinate, axis, slope, constant }
                    }
                    FrameTurn::EulerParameters(coordinates) => NodeMotion::EulerParameters(coordinates),
                    FrameTurn::Constant | FrameTurn::Other(_) => NodeMotion::Ground,
                };
                let rotation = places.frames[facts.before].in_group;
                (Pose { position, rotation }, motion, *frame, None, Vector3::zeros())
            }
        };
        self.nodes.push(TreeNode { before: node, carrier: node, origin, motion, group, slide, is_kept: true });
        (self.nodes.len() - 1, rest)
    }

    /// Joins displacements with the turn after them to planar and free joints. A node that carries a body, that carries
    /// several nodes, or whose coordinate another node follows stays. `is_taken` tells if a node carries a body.
    pub fn join(&mut self, is_taken: impl Fn(usize) -> bool) {
        for at in 1..self.nodes.len() {
            let slides = self.slides_before(at, &is_taken);
            let vectors: Vec<Vector3<f64>> = slides.iter().map(|(_, _, vector)| *vector).collect();
            let TreeNode { origin, motion, .. } = &self.nodes[at];
            // Place, in the order of the axes of the joint, of the slide along each axis.
            let order = |axes: &[usize]| -> Option<Vec<usize>> {
                let along = |axis: &usize| {
                    let wanted = origin.rotation.column(*axis);
                    vectors.iter().position(|vector| (vector - wanted).norm() <= ROUNDING)
                };
                (slides.len() == axes.len()).then(|| axes.iter().map(along).collect()).flatten()
            };
            let is_followed = |coordinate: usize| {
                let uses = self.nodes.iter().filter(|node| node.is_kept && node.coordinates().contains(&coordinate));
                uses.count() > 1
            };
            let joined = match *motion {
                NodeMotion::Turn { coordinate, axis, slope, constant }
                    if (slope - 1.0).abs() <= ROUNDING && constant == 0.0 && !is_followed(coordinate) =>
                {
                    let [first, second] = [(axis + 1) % 3, (axis + 2) % 3];
                    order(&[first, second]).map(|order| {
                        let coordinates = [slides[order[0]].1, slides[order[1]].1, coordinate];
                        NodeMotion::Planar { coordinates, axis }
                    })
                }
                NodeMotion::EulerParameters([e0, e1, e2, e3]) => order(&[0, 1, 2]).map(|order| {
                    let [x, y, z] = [0, 1, 2].map(|axis| slides[order[axis]].1);
                    NodeMotion::Free([x, y, z, e0, e1, e2, e3])
                }),
                _ => None,
            };
            let Some(motion) = joined else { continue };
            let first = slides.iter().map(|(node, ..)| *node).min().unwrap_or(at);
            self.nodes[at].carrier = self.nodes[first].carrier;
            self.nodes[at].motion = motion;
            for (node, ..) in slides {
                self.nodes[node].is_kept = false;
            }
        }
    }

    /// Slides directly before a node that may be joined with it, as (node, coordinate, vector).
    fn slides_before(&self, at: usize, is_taken: &impl Fn(usize) -> bool) -> Vec<(usize, usize, Vector3<f64>)> {
        let mut list = Vec::new();
        let mut node = self.nodes[at].before;
        while let NodeMotion::Slide { coordinate, vector } = self.nodes[node].motion {
            let children = self.nodes.iter().skip(1).filter(|child| child.before == node).count();
            let uses = self.nodes.iter().filter(|other| other.is_kept && other.coordinates().contains(&coordinate));
            if is_taken(node) || children > 1 || uses.count() > 1 {
                break;
            }
            list.push((node, coordinate, vector));
            node = self.nodes[node].before;
        }
        list
    }

    /// Node with the given coordinate as its own: slope 1 or −1. Of several, one without a constant angle is preferred.
    /// `None` if every node follows the coordinate with another factor.
    pub fn owner(&self, coordinate: usize) -> Option<usize> {
        let is_own = |node: &TreeNode| match node.motion {
            NodeMotion::Slide { vector, .. } => (vector.norm() - 1.0).abs() <= ROUNDING,
            NodeMotion::Turn { slope, .. } => (slope.abs() - 1.0).abs() <= ROUNDING,
            _ => true,
        };
        let kept = self.nodes.iter().enumerate().filter(|(_, node)| node.is_kept && is_own(node));
        let own = kept.filter(|(_, node)| node.coordinates().contains(&coordinate));
        own.min_by_key(|(at, node)| {
            let is_shifted = matches!(node.motion, NodeMotion::Turn { constant, .. } if constant != 0.0);
            let is_reversed = matches!(node.motion, NodeMotion::Turn { slope, .. } if slope < 0.0);
            (is_shifted, is_reversed, *at)
        })
        .map(|(at, _)| at)
    }

    /// Nodes from `node` to `from`, which carries it, without `from`. Empty if `from` does not carry it.
    pub fn nodes_between(&self, from: usize, node: usize) -> Vec<usize> {
        let mut list = Vec::new();
        let mut at = node;
        while at != from {
            if at == 0 {
                return Vec::new();
            }
            list.push(at);
            at = self.nodes[at].carrier;
        }
        list
    }
}

impl TreeNode {
    /// Indices of the coordinates of the node's joint.
    pub fn coordinates(&self) -> &[usize] {
        match &self.motion {
            NodeMotion::Ground => &[],
            NodeMotion::Slide { coordinate, .. } | NodeMotion::Turn { coordinate, .. } => {
                std::slice::from_ref(coordinate)
            }
            NodeMotion::EulerParameters(list) => list,
            NodeMotion::Planar { coordinates, .. } => coordinates,
            NodeMotion::Free(list) => list,
        }
    }

    /// Rotation by the constant part of the turn's angle.
    pub fn constant_turn(&self) -> Matrix3<f64> {
        match self.motion {
            NodeMotion::Turn { axis, constant, .. } => axis_turn(axis, constant),
            _ => Matrix3::identity(),
        }
    }
}

/// Axes whose axis 3 is the given axis of the old ones, as a rotation matrix: the axes keep their cyclic order.
pub fn axes_with_third(axis: usize) -> Matrix3<f64> {
    let unit = |axis: usize| Vector3::ith(axis % 3, 1.0);
    Matrix3::from_columns(&[unit(axis + 1), unit(axis + 2), unit(axis)])
}
