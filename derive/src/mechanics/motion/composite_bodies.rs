//! Mass matrix of a tree of bodies by the composite-body method. A composite body consists of all bodies beyond a
//! joint, taken as a single rigid body.
//!
//! The tree has an edge for each rotation from frame to frame, and for each shift from point to point in a frame. A
//! composite body has a mass m, a first moment s and an inertia J about the point of its node, in the node's frame. A
//! unit motion of an edge gives the composite body beyond it a momentum. The momentum is expressed frame by frame up
//! to the root. The component of this momentum along the motion of another edge on the way is the matrix entry for
//! both edges.
//!
//! The work grows with the square of the depth (R. Featherstone, *Rigid Body Dynamics Algorithms* (2008), §6.2; M. W.
//! Walker & D. E. Orin, ASME J. Dyn. Sys. Meas. Control 104 (1982) 205–211).

use super::kinematics::{Kinematics, Velocities};
use super::placed_inertia::PlacedInertia;
use crate::algebra::term::calculus::Gradient;
use crate::algebra::{Arena, Expr, Rational};
use crate::geometry::{Components, Placement, Turn, TurnSense, cross_components, transposed};
use crate::geometry::{name_transported_components, rotate_and_name_components};
use crate::model::Model;

/// Components of the zero vector.
const NOTHING: Components = [Expr::ZERO; 3];

/// Step from a node to its child in the tree. Either the frame rotates, or the point shifts along the frame.
#[derive(Clone, PartialEq, Eq)]
enum Edge {
    /// Rotation of the frame by the given turn. The point stays.
    Turn(Turn),
    /// Shift of the point by the given components along the frame, m. The frame stays.
    Shift { by: Components },
}

/// Node of the tree: a frame with a point, and the sums over the bodies at and beyond it.
struct Node {
    /// Index of the parent node in the tree.
    parent: usize,
    /// Step from the parent to the node: a rotation or a shift.
    edge: Edge,
    /// Index of the node's frame in the model.
    frame: usize,
    /// Rates of the edge's motion: components of its angular velocity (rad/s), or of its shift (m/s).
    rates: Components,
    /// Masses of the bodies at or beyond the node, kg, as summands.
    mass: Vec<Expr>,
    /// Summands of the first moment Σ m r about the node's point, kg m, for each of its three components.
    moment: [Vec<Expr>; 3],
    /// Summands of the inertia Σ m (r² − r rᵀ) about the node's point, kg m², for each entry of its upper triangle,
    /// row by row.
    inertia: [Vec<Expr>; 6],
}

/// Composite body of a node: mass, first moment and inertia of all bodies at and beyond the node. They are about the
/// node's point and in the node's frame.
#[derive(Clone)]
struct Composite {
    /// Mass of the composite body, kg.
    mass: Expr,
    /// First moment Σ m r of the composite body about the node's point, kg m.
    moment: Components,
    /// Inertia Σ m (r² − r rᵀ) of the composite body about the node's point, kg m²: upper triangle, row
    /// by row.
    inertia: [Expr; 6],
}

/// Index of entry (i, j) of a symmetric 3 × 3 tensor in the array that holds its upper triangle, row by row.
fn composite_inertia_index(i: usize, j: usize) -> usize {
    let (i, j) = (i.min(j), i.max(j));
    i * (5 - i) / 2 + j
}

/// Momentum as (linear momentum, angular momentum about the point of a node), in the node's frame.
type Momentum = (Components, Components);

/// Motion at unit rate of the edge that leads to a node: a rotation about an axis, or a shift along an axis.
#[derive(Clone, Copy)]
struct Motion {
    /// Index of the node to which the moving edge leads.
    node: usize,
    /// Axis of the node's frame along or about which the edge moves: 0, 1 or 2.
    axis: usize,
}

/// Tree of nodes (a frame with a point) that leads from the ground to all bodies of a model.
struct CompositeTree {
    /// Nodes of the tree, parents first. The first node is the inertial frame at the origin.
    nodes: Vec<Node>,
}

impl Kinematics {
    /// Matrix ∂²T/∂x_i∂x_j of the kinetic energy by composite bodies, with a row for each motion variable x. `None`
    /// if the points to a body's mass centre do not follow the chain of its frames.
    pub(in crate::mechanics) fn composite_mass_matrix(
        &mut self,
        model: &Model,
        velocities: &Velocities,
        variables: &[Expr],
    ) -> Option<Vec<Vec<Expr>>> {
        let bodies: Option<Vec<PlacedInertia>> = model.bodies.iter().map(PlacedInertia::about_centre).collect();
        self.composite_mass_matrix_of(&bodies?, model, velocities, variables)
    }

    /// Mass matrix of bodies with the given inertias, with a row for each motion variable. `None` if the points to a
    /// body's reference point do not follow the chain of its frames.
    pub(in crate::mechanics) fn composite_mass_matrix_of(
        &mut self,
        bodies: &[PlacedInertia],
        model: &Model,
        velocities: &Velocities,
        variables: &[Expr],
    ) -> Option<Vec<Vec<Expr>>> {
        let mut tree = CompositeTree::new(self, bodies, model, velocities)?;
        let composites = tree.composites(&mut self.arena, model);
        let motions = tree.motions();
        let mut gradient = Gradient::new(variables);
        let slopes: Vec<_> = motions
            .iter()
            .map(|motion| gradient.apply(&mut self.arena, tree.nodes[motion.node].rates[motion.axis]))
            .collect();
        let n = variables.len();
        let mut terms = vec![vec![Vec::new(); n]; n];
        for (at, motion) in motions.iter().enumerate() {
            for (other, entry) in tree.composite_matrix_entries(&mut self.arena, model, &composites, &motions, *motion)
            {
                for (r, by_r) in slopes[at].iter() {
                    for (s, by_s) in slopes[other].iter() {
                        // A pair of a motion with itself counts once. A pair of two motions counts in both orders.
                        if other == at && r > s {
                            continue;
                        }
                        let term = self.arena.product(&[*by_r, *by_s, entry]);
                        let (i, j) = (*r.min(s), *r.max(s));
                        let twice = other != at && r == s;
                        terms[i][j].push((term, Rational::integer(if twice { 2 } else { 1 })));
                    }
                }
            }
        }
        let mut matrix = vec![vec![Expr::ZERO; n]; n];
        for i in 0..n {
            for j in i..n {
                let entry = self.arena.linear_combination(&terms[i][j]);
                matrix[i][j] = entry;
                matrix[j][i] = entry;
            }
        }
        Some(matrix)
    }
}

impl CompositeTree {
    /// Builds the tree of all bodies. `None` if the points to a body's reference point do not follow the chain of its
    /// frames.
    fn new(
        kinematics: &mut Kinematics,
        bodies: &[PlacedInertia],
        model: &Model,
        velocities: &Velocities,
    ) -> Option<Self> {
        let root = Node::new(0, Edge::Shift { by: NOTHING }, 0, NOTHING);
        let mut tree = Self { nodes: vec![root] };
        for body in bodies {
            let at = tree.add_path_of_body(kinematics, model, velocities, body)?;
            let node = &mut tree.nodes[at];
            node.mass.push(body.mass);
            for i in 0..3 {
                node.moment[i].push(body.moment[i]);
                for j in i..3 {
                    node.inertia[composite_inertia_index(i, j)].push(body.tensor[i][j]);
                }
            }
        }
        Some(tree)
    }

    /// Adds the path of a body to the tree. Returns the index of the node at the body's reference point, in the frame
    /// of its inertia. `None` if the points up to the reference point do not follow the chain of the body's frames.
    fn add_path_of_body(
        &mut self,
        kinematics: &mut Kinematics,
        model: &Model,
        velocities: &Velocities,
        body: &PlacedInertia,
    ) -> Option<usize> {
        let mut steps = Vec::new();
        let mut point = body.point;
        while let Some(Placement { parent: before, frame, components }) = model.points[point].position {
            steps.push((frame, components, point));
            point = before;
        }
        steps.reverse();
        let frames = &kinematics.frames;
        let own = body.frame.unwrap_or_else(|| {
            steps.iter().map(|(frame, ..)| *frame).max_by_key(|frame| frames.ancestors(*frame).len()).unwrap_or(0)
        });
        let path = frames.ancestors(own);
        if !steps.iter().all(|(frame, ..)| path.contains(frame)) {
            return None;
        }
        let mut at = 0;
        for frame in path.into_iter().rev() {
            if let Some(turn) = kinematics.frames.turn_from_parent(frame) {
                let rates = velocities.angular[frame].parts.iter().find(|(of, _)| *of == frame);
                let rates = rates.map_or(NOTHING, |(_, components)| *components);
                at = self.child(Node::new(at, Edge::Turn(turn.clone()), frame, rates));
            }
            for (_, by, point) in steps.iter().filter(|(of, ..)| *of == frame) {
                let rates = kinematics.point_rates_in_frame(model, *point, velocities);
                at = self.child(Node::new(at, Edge::Shift { by: *by }, frame, rates));
            }
        }
        Some(at)
    }

    /// Index of the node that has the same parent, frame and edge as `node`. Adds `node` if the tree has no such
    /// node.
    fn child(&mut self, node: Node) -> usize {
        let alike = |known: &Node| known.parent == node.parent && known.frame == node.frame && known.edge == node.edge;
        match self.nodes.iter().skip(1).position(alike) {
            Some(at) => at + 1,
            None => {
                self.nodes.push(node);
                self.nodes.len() - 1
            }
        }
    }

    /// Composite bodies, one for each node, in the order of the nodes. Adds each node's sums to those
    /// of its parent.
    fn composites(&mut self, arena: &mut Arena, model: &Model) -> Vec<Composite> {
        let mut list =
            vec![Composite { mass: Expr::ZERO, moment: NOTHING, inertia: [Expr::ZERO; 6] }; self.nodes.len()];
        for at in (0..self.nodes.len()).rev() {
            let node = &self.nodes[at];
            let name = &model.frames[node.frame].name;
            let mut total = |terms: &[Expr], what: String| {
                let sum = arena.sum(terms);
                arena.name(sum, &what)
            };
            let mass = total(&node.mass, format!("m_{name}"));
            let moment = std::array::from_fn(|i| total(&node.moment[i], format!("s_{name}_{}", i + 1)));
            let inertia = std::array::from_fn(|k| {
                total(&node.inertia[k], format!("J_{name}_{}", ["11", "12", "13", "22", "23", "33"][k]))
            });
            list[at] = Composite { mass, moment, inertia };
            if at == 0 {
                break;
            }
            let (moment, inertia) = match &node.edge {
                Edge::Turn(turn) => {
                    let before = &model.frames[self.nodes[node.parent].frame].name;
                    let moment = rotate_and_name_components(
                        arena,
                        turn,
                        TurnSense::Back,
                        &moment,
                        &format!("s_{name}_in_{before}"),
                    );
                    (moment, rotated_composite_inertia(arena, turn, &inertia, &format!("J_{name}_in_{before}")))
                }
                Edge::Shift { by } => shifted_composite(arena, &list[at], by, name),
            };
            let before = node.parent;
            let parent = &mut self.nodes[before];
            parent.mass.push(mass);
            (0..3).for_each(|i| parent.moment[i].push(moment[i]));
            (0..6).for_each(|k| parent.inertia[k].push(inertia[k]));
        }
        list
    }

    /// Lists the unit motions of the tree: one for each axis of an edge whose rate is not zero.
    fn motions(&self) -> Vec<Motion> {
        let axes = |at: usize| {
            (0..3)
                .filter(move |axis| self.nodes[at].rates[*axis] != Expr::ZERO)
                .map(move |axis| Motion { node: at, axis })
        };
        (1..self.nodes.len()).flat_map(axes).collect()
    }

    /// Matrix entries between a unit motion and the motions on its way to the root, itself included. Each entry is
    /// (index of the second motion, momentum along it), and occurs once.
    fn composite_matrix_entries(
        &self,
        arena: &mut Arena,
        model: &Model,
        composites: &[Composite],
        motions: &[Motion],
        motion: Motion,
    ) -> Vec<(usize, Expr)> {
        let Motion { node: start, axis } = motion;
        let Composite { mass, moment, inertia } = &composites[start];
        let mut unit = NOTHING;
        unit[axis] = Expr::ONE;
        let (mut linear, mut angular): Momentum = match &self.nodes[start].edge {
            Edge::Turn(_) => (
                cross_components(arena, &unit, moment),
                std::array::from_fn(|i| inertia[composite_inertia_index(i, axis)]),
            ),
            Edge::Shift { .. } => (unit.map(|e| arena.mul(*mass, e)), cross_components(arena, moment, &unit)),
        };
        let mut list = Vec::new();
        let mut at = start;
        while at != 0 {
            let node = &self.nodes[at];
            let along = if matches!(node.edge, Edge::Turn(_)) { &angular } else { &linear };
            for (place, other) in motions.iter().enumerate().filter(|(_, other)| other.node == at) {
                if at != start || other.axis >= axis {
                    list.push((place, along[other.axis]));
                }
            }
            let name = &model.frames[node.frame].name;
            let of = &model.frames[self.nodes[start].frame].name;
            match &node.edge {
                Edge::Turn(turn) => {
                    linear =
                        rotate_and_name_components(arena, turn, TurnSense::Back, &linear, &format!("p_{of}_in_{name}"));
                    angular = rotate_and_name_components(
                        arena,
                        turn,
                        TurnSense::Back,
                        &angular,
                        &format!("h_{of}_in_{name}"),
                    );
                }
                Edge::Shift { by } => {
                    let about = cross_components(arena, by, &linear);
                    let sum = std::array::from_fn(|i| arena.add(angular[i], about[i]));
                    angular = name_transported_components(arena, sum, &format!("h_{of}_{name}"));
                }
            }
            at = node.parent;
        }
        list
    }
}

impl Node {
    /// Creates a node at the end of an edge, without any mass yet.
    fn new(parent: usize, edge: Edge, frame: usize, rates: Components) -> Self {
        let (moment, inertia) = Default::default();
        Self { parent, edge, frame, rates, mass: Vec::new(), moment, inertia }
    }
}

/// First moment and inertia of a composite body about the parent's point, from which the node's point lies at r =
/// `by`. The first moment is s + m r. With w = 2 s + m r, the inertia is J + (r · w) 1 − ½ (r wᵀ + w rᵀ).
fn shifted_composite(arena: &mut Arena, composite: &Composite, by: &Components, name: &str) -> (Components, [Expr; 6]) {
    let Composite { mass, moment, inertia } = composite;
    let carried = by.map(|e| arena.mul(*mass, e));
    let carried = name_transported_components(arena, carried, &format!("mr_{name}"));
    let sum = std::array::from_fn(|i| arena.add(moment[i], carried[i]));
    let sum = name_transported_components(arena, sum, &format!("s_{name}"));
    let both = std::array::from_fn(|i| arena.add(moment[i], sum[i]));
    let both = name_transported_components(arena, both, &format!("w_{name}"));
    let half = Rational::fraction(1, 2).expect("not zero");
    let halves: Components = both.map(|e| arena.scale(e, &half));
    let along: Components = std::array::from_fn(|i| {
        let product = arena.mul(by[i], both[i]);
        arena.name(product, &format!("rw_{name}_{}", i + 1))
    });
    let mut result = *inertia;
    for i in 0..3 {
        for j in i..3 {
            let added = if i == j {
                arena.add(along[(i + 1) % 3], along[(i + 2) % 3])
            } else {
                let (ij, ji) = (arena.mul(by[i], halves[j]), arena.mul(halves[i], by[j]));
                let sum = arena.add(ij, ji);
                arena.neg(sum)
            };
            let entry = arena.add(inertia[composite_inertia_index(i, j)], added);
            result[composite_inertia_index(i, j)] = entry;
        }
    }
    (sum, result)
}

/// Rotates an inertia tensor back into the frame before a turn: R J Rᵀ, with a name for each entry. About a single
/// axis, let t = s (J_kk − J_jj) − 2 c J_jk. Then the entries are J_jj + s t, J_kk − s t and −c t − J_jk.
fn rotated_composite_inertia(arena: &mut Arena, turn: &Turn, tensor: &[Expr; 6], what: &str) -> [Expr; 6] {
    let Turn::About(axis, angle) = turn else {
        let half = [0, 1, 2].map(|i| {
            let column = std::array::from_fn(|j| tensor[composite_inertia_index(j, i)]);
            rotate_and_name_components(arena, turn, TurnSense::Back, &column, what)
        });
        let rows = transposed(&half).map(|row| rotate_and_name_components(arena, turn, TurnSense::Back, &row, what));
        return [(0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)].map(|(i, j)| rows[i][j]);
    };
    let (axis, angle) = (*axis, *angle);
    let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
    let (s, c) = (arena.sin(angle), arena.cos(angle));
    let row = [NOTHING[0], tensor[composite_inertia_index(axis, j)], tensor[composite_inertia_index(axis, k)]];
    // The entries in the row of the axis transform like the components of a vector.
    let mut beside = NOTHING;
    (beside[j], beside[k]) = (row[1], row[2]);
    let beside = rotate_and_name_components(arena, turn, TurnSense::Back, &beside, what);
    let difference = arena.sub(tensor[composite_inertia_index(k, k)], tensor[composite_inertia_index(j, j)]);
    let difference = arena.name(difference, &format!("{what}_{}{}", j + 1, k + 1));
    let (of_difference, of_product) = (arena.mul(s, difference), arena.mul(c, tensor[composite_inertia_index(j, k)]));
    let t = arena.linear_combination(&[(of_difference, Rational::ONE), (of_product, Rational::integer(-2))]);
    let t = arena.name(t, what);
    let (st, ct) = (arena.mul(s, t), arena.mul(c, t));
    let st = arena.name(st, what);
    let mut result = *tensor;
    result[composite_inertia_index(axis, j)] = beside[j];
    result[composite_inertia_index(axis, k)] = beside[k];
    result[composite_inertia_index(j, j)] = arena.add(tensor[composite_inertia_index(j, j)], st);
    result[composite_inertia_index(k, k)] = arena.sub(tensor[composite_inertia_index(k, k)], st);
    let sum = arena.add(ct, tensor[composite_inertia_index(j, k)]);
    result[composite_inertia_index(j, k)] = arena.neg(sum);
    let mut at = 0;
    result.map(|e| {
        at += 1;
        arena.name(e, &format!("{what}_{}", ["11", "12", "13", "22", "23", "33"][at - 1]))
    })
}
