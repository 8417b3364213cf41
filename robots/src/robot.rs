//! A robot as a robot description states it: bodies in a tree, their joints, loops, couplings of joints and
//! actuators.
//!
//! Lengths are in m, angles in rad, masses in kg, as 64-bit numbers of the file. Poses and positions are those at the
//! *reference configuration*, in which each joint coordinate has its reference value.

use crate::pose::Pose;
use nalgebra::{Matrix3, Vector3};
use std::collections::BTreeMap;
use std::ops::Range;
use tripos_derive::plain_text::message_text;
use tripos_derive::plain_text::one_line;

/// A robot: bodies, loops, couplings and actuators, with a list of parts of the file that were left out.
#[derive(Debug)]
pub struct Robot {
    /// Name of the robot in the file.
    pub name: String,
    /// Acceleration of free fall in the axes of the ground, m/s².
    pub gravity: Vector3<f64>,
    /// Bodies; each stands after the body that carries it.
    pub bodies: Vec<Body>,
    /// Shapes fixed to the ground.
    pub ground_shapes: Vec<Shape>,
    /// Named frames on bodies and on the ground: those of bodies that were joined with them.
    pub markers: Vec<Marker>,
    /// Loops, each closed by one connection of two bodies.
    pub loops: Vec<Loop>,
    /// Equations between joint coordinates.
    pub couplings: Vec<Coupling>,
    /// Values of joint coordinates near which the loops are closed, rad or m. Other joints have their reference values
    /// there.
    pub assembly: BTreeMap<JointIndex, f64>,
    /// Byte range of these values in the loops file; `None` if it states none.
    pub assembly_place: Option<Range<usize>>,
    /// Motors and other actuators of joints.
    pub actuators: Vec<Actuator>,
    /// Parts of the file that have no meaning in a model of rigid bodies, or that were simplified.
    pub omissions: Vec<Omission>,
}

/// A part of the file that was left out or simplified.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Omission {
    /// Part of the file and the reason, as one line of text.
    pub text: String,
    /// Number of parts that were left out for this reason.
    pub count: usize,
}

/// A named frame that is fixed to a body or to the ground.
#[derive(Debug)]
pub struct Marker {
    /// Name of the frame.
    pub name: String,
    /// Index of the body; `None` for the ground.
    pub body: Option<usize>,
    /// Pose in the axes of the body.
    pub pose: Pose,
    /// True if a body with mass stood there.
    pub has_mass: bool,
}

/// A rigid body (a link), its place on the body that carries it, and its joints.
#[derive(Debug)]
pub struct Body {
    /// Name of the body in the file.
    pub name: String,
    /// Index of the body that carries this one; `None` for the ground.
    pub parent: Option<usize>,
    /// Pose of the body's axes in the axes of the body that carries it, at the reference configuration.
    pub pose: Pose,
    /// Joints between the body and the body that carries it, in the order in which they act. A body without joints is
    /// fixed.
    pub joints: Vec<Joint>,
    /// Mass and inertia; `None` for a body without mass.
    pub inertia: Option<Inertia>,
    /// Shapes that show the body.
    pub shapes: Vec<Shape>,
    /// Place of the body in the file, as a byte range.
    pub place: Range<usize>,
}

/// Mass properties of a rigid body.
#[derive(Clone, Debug)]
pub struct Inertia {
    /// Mass, kg.
    pub mass: f64,
    /// Mass centre in the axes of the body, m.
    pub centre: Vector3<f64>,
    /// Inertia tensor about the mass centre, in the axes of the body, kg m².
    pub tensor: Matrix3<f64>,
}

/// Motion that a joint permits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum JointMotion {
    /// A turn about the axis.
    Hinge,
    /// A displacement along the axis.
    Slide,
    /// Any turn about the joint's position.
    Ball,
    /// Displacements across the axis, and a turn about it.
    Planar,
    /// Any motion.
    Free,
}

/// A joint between a body and the body that carries it.
#[derive(Debug)]
pub struct Joint {
    /// Name of the joint in the file.
    pub name: String,
    /// Motion that the joint permits.
    pub motion: JointMotion,
    /// Position of the joint in the axes of its body, m.
    pub position: Vector3<f64>,
    /// Axis of the joint in the axes of its body, of any length but zero.
    pub axis: Vector3<f64>,
    /// Value of the coordinate at the reference configuration, rad or m.
    pub reference: f64,
    /// Smallest and largest value of the coordinate, rad or m, infinite without a limit on one side; `None` without a
    /// limit.
    pub limits: Option<(f64, f64)>,
    /// Viscous damping, N m s or N s/m.
    pub damping: f64,
    /// Dry friction, N m or N.
    pub friction: f64,
    /// Stiffness of a spring in the joint, N m or N/m.
    pub stiffness: f64,
    /// Value of the coordinate at which the spring is relaxed, rad or m.
    pub spring_reference: f64,
    /// Pose of the moved body at the start, for a free joint.
    pub free_start: Pose,
    /// Inertia of the drive, added to the diagonal of the mass matrix, kg m² or kg.
    pub armature: f64,
    /// Place of the joint in the file, as a byte range.
    pub place: Range<usize>,
}

impl Joint {
    /// Creates a joint without limits, damping, spring and armature.
    pub fn new(name: String, motion: JointMotion, axis: Vector3<f64>, place: Range<usize>) -> Self {
        Self {
            name,
            motion,
            position: Vector3::zeros(),
            axis,
            reference: 0.0,
            limits: None,
            damping: 0.0,
            friction: 0.0,
            stiffness: 0.0,
            spring_reference: 0.0,
            armature: 0.0,
            free_start: Pose::default(),
            place,
        }
    }

    /// True if the joint has one coordinate: a hinge or a slide.
    pub fn has_one_coordinate(&self) -> bool {
        matches!(self.motion, JointMotion::Hinge | JointMotion::Slide)
    }
}

/// A joint of a robot: the index of its body, and its index among the joints of this body.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct JointIndex {
    /// Index of the body in [`Robot::bodies`].
    pub body: usize,
    /// Index of the joint in [`Body::joints`].
    pub joint: usize,
}

/// Part of the relative motion that a loop prevents.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LoopKind {
    /// Two points stay together.
    Connect,
    /// Two frames stay together.
    Weld,
    /// Two frames stay together but for a turn about one of their axes, with the index of this axis from 0.
    Hinge(usize),
}

/// A connection of two bodies that closes a loop.
#[derive(Debug)]
pub struct Loop {
    /// Name of the connection.
    pub name: String,
    /// Part of the relative motion that it prevents.
    pub kind: LoopKind,
    /// Index of the first body; `None` for the ground.
    pub first: Option<usize>,
    /// Pose of the connection in the axes of the first body.
    pub first_pose: Pose,
    /// Index of the second body; `None` for the ground.
    pub second: Option<usize>,
    /// Pose of the connection in the axes of the second body.
    pub second_pose: Pose,
    /// Byte range of the connection in the file that states it: the loops file, or else the description.
    pub place: Range<usize>,
}

/// An equation between joint coordinates, q_follower = Σ cᵢ q_leaderⁱ.
#[derive(Debug)]
pub struct Coupling {
    /// Joint whose coordinate follows.
    pub follower: JointIndex,
    /// Joint whose coordinate leads; `None` if the follower's coordinate is constant.
    pub leader: Option<JointIndex>,
    /// Coefficients c₀, c₁, … of the powers of the leader's coordinate.
    pub coefficients: Vec<f64>,
}

/// An actuator of one joint: its load is `gain` · input + `bias` + `position_gain` · q + `velocity_gain` · q'.
#[derive(Debug)]
pub struct Actuator {
    /// Name of the input.
    pub name: String,
    /// Joint on which the actuator acts.
    pub joint: JointIndex,
    /// Load for an input of 1, in the unit of the load by that of the input.
    pub gain: f64,
    /// Load for an input of 0 at rest with the coordinate at 0, N m or N.
    pub bias: f64,
    /// Load for each rad or m of the coordinate.
    pub position_gain: f64,
    /// Load for each rad/s or m/s of the rate.
    pub velocity_gain: f64,
    /// Quantity that the input sets.
    pub input: ActuatorInput,
}

/// Quantity that the input of an actuator sets.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ActuatorInput {
    /// A torque or a force.
    Load,
    /// A value of the coordinate.
    Position,
    /// A rate of the coordinate.
    Velocity,
    /// A number without unit.
    Control,
}

/// A shape that shows a body.
#[derive(Clone, Debug)]
pub struct Shape {
    /// Geometry of the shape.
    pub solid: Solid,
    /// Pose of the shape in the axes of the body.
    pub pose: Pose,
    /// Name of the mesh whose bounds the shape has; `None` for other shapes.
    pub mesh: Option<String>,
}

/// Geometry of a shape, centred at its pose.
#[derive(Clone, Debug)]
pub enum Solid {
    /// A sphere with its radius, m.
    Sphere(f64),
    /// A cylinder along axis 3 with its radius and length, m.
    Cylinder(f64, f64),
    /// A cylinder along axis 3 that ends in half spheres, with its radius and the length of the cylinder, m.
    Capsule(f64, f64),
    /// A box with its edges along the axes, m.
    Block(Vector3<f64>),
    /// An ellipsoid with its semi-axes, m.
    Ellipsoid(Vector3<f64>),
    /// A plane at a right angle to axis 3.
    Plane,
}

impl Robot {
    /// Creates a robot without bodies. Free fall is along the axis −3 of the ground.
    pub fn new(name: &str, gravity: f64) -> Self {
        Self {
            name: name.to_owned(),
            gravity: Vector3::new(0.0, 0.0, -gravity),
            bodies: Vec::new(),
            ground_shapes: Vec::new(),
            markers: Vec::new(),
            loops: Vec::new(),
            couplings: Vec::new(),
            assembly: BTreeMap::new(),
            assembly_place: None,
            actuators: Vec::new(),
            omissions: Vec::new(),
        }
    }

    /// Value, rad or m, of a joint that follows another one, from the value of the leading joint in the assembled pose.
    /// `None` if the joint follows none. Couplings must not form a circle.
    pub fn coupled_value(&self, follower: JointIndex) -> Option<f64> {
        // Joints from the follower to the first one that leads.
        let mut chain = Vec::new();
        let mut at = Some(follower);
        while let Some(coupling) = at.and_then(|joint| self.couplings.iter().find(|one| one.follower == joint)) {
            chain.push(coupling);
            at = coupling.leader.filter(|_| chain.len() <= self.couplings.len());
        }
        let first = at.map(|joint| self.assembly.get(&joint).copied().unwrap_or(self.joint(joint).reference));
        let of = |coupling: &Coupling, leader: f64| {
            coupling.coefficients.iter().rev().fold(0.0, |sum, coefficient| sum * leader + coefficient)
        };
        let value = chain.iter().rev().fold(first.unwrap_or(0.0), |value, coupling| of(coupling, value));
        (!chain.is_empty()).then_some(value)
    }

    /// Joint with an index.
    pub fn joint(&self, index: JointIndex) -> &Joint {
        &self.bodies[index.body].joints[index.joint]
    }
}

impl Omission {
    /// Counts a part that was left out; parts with the same text are counted together.
    pub fn add(list: &mut Vec<Self>, text: &str) {
        Self::merge(list, Self { text: message_text(text), count: 1 });
    }

    /// Adds parts that were left out; parts with the same text are counted together.
    pub(crate) fn merge(list: &mut Vec<Self>, omission: Self) {
        match list.iter_mut().find(|known| known.text == omission.text) {
            Some(known) => known.count += omission.count,
            None => list.push(omission),
        }
    }
}

impl std::fmt::Display for Omission {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}", one_line(&self.text))?;
        if self.count > 1 { write!(f, " ({} times)", self.count) } else { Ok(()) }
    }
}
