//! Constraint types of a model: holonomic constraints, loops and motion constraints.

use super::Unit;
use crate::algebra::Expr;

/// Holonomic constraint that is solved for one configuration variable.
#[derive(Clone, Debug)]
pub struct Constraint {
    /// Name of the constraint in the model file.
    pub name: String,
    /// Left side less right side of the constraint's equation: the term that the constraint makes zero.
    pub equation: Expr,
    /// Name of the configuration variable that the constraint determines.
    pub fixes: String,
    /// Value of the variable that the constraint determines, as a term in the generalized coordinates.
    pub value: Expr,
    /// Index of the reaction that enforces the constraint; `None` if the model file states none.
    pub enforced_by: Option<usize>,
}

/// Velocity that a motion adds to a frame or a point: (index, three components). The components are in rad/s for a
/// frame and in m/s for a point.
pub type AddedVelocity = (usize, [Expr; 3]);

/// Motion that a closed joint would permit if only this joint were open. The coordinate that the joint's equation
/// determines moves at rate 1.
#[derive(Clone, Debug, Default)]
pub struct JointOpeningMotion {
    /// Frames that turn relative to their parents: (index, angular velocity along the axes of the
    /// frame).
    pub turns: Vec<AddedVelocity>,
    /// Points that move relative to their parents: (index, velocity along the axes in which the point
    /// is placed).
    pub moves: Vec<AddedVelocity>,
    /// Constraints that the motion would violate: (name, rate of the constraint's equation).
    pub breaks: Vec<(String, Expr)>,
}

/// Loop equation φ(q) = 0 between coordinates that cannot be solved for a coordinate, such as the closure of a
/// linkage.
#[derive(Clone, Debug)]
pub struct LoopEquation {
    /// Name of the loop equation in the model file.
    pub name: String,
    /// Left side φ(q) of the loop equation, which is zero.
    pub equation: Expr,
    /// SI unit of the left side φ(q) of the loop equation.
    pub unit: Unit,
    /// True if the equation, as the model file states it, prescribes a coordinate as a function of time. Such an
    /// equation closes no loop.
    pub prescribes: bool,
}

/// Orientation that a weld or a slider holds where it closes a loop. Three equations hold it, which also permit half a
/// turn from it.
#[derive(Clone, Debug)]
pub struct HeldOrientation {
    /// Name of the joint in the model file.
    pub joint: String,
    /// Sum of the cosines between equal axes of the two frames, as a term in parameters and coordinates. In a closed
    /// pose it is 3, or −1 if one frame is half a turn away from its orientation.
    pub cosines: Expr,
}

/// Component of the velocity at which a rolling body would slip at its contact. Rolling makes this component zero.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SlipComponent {
    /// Index of the contact in [`super::Contacts::rolling`].
    pub contact: usize,
    /// Index of the body that rolls.
    pub body: usize,
    /// Index of the body on which the rolling body rolls; `None` for the ground.
    pub against: Option<usize>,
    /// Index of the point at which the two bodies touch.
    pub point: usize,
    /// Index of the frame along whose axis the component is taken.
    pub frame: usize,
    /// Axis of the component: 0, 1 or 2.
    pub axis: usize,
    /// True if the model file states the frame. If false, the component may also be taken along the axes of another
    /// frame.
    pub is_stated: bool,
}

/// Kind of a motion constraint: stated, rolling, rate of a loop, or time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MotionConstraintKind {
    /// Equation between velocities that the model file states.
    Stated,
    /// Rolling without slip: one component of the velocity at which the body would slip is zero.
    Rolling(SlipComponent),
    /// Time derivative of a loop equation, with the index of the loop in [`super::Model::loops`].
    Loop(usize),
    /// Constraint t' = 1 on the rate of time, if time is a coordinate.
    Clock,
}

/// Motion constraint A(q) q̇ + a(q) = 0: it restricts velocities. Unless it is integrable, no equation between
/// coordinates alone can express it.
#[derive(Clone, Debug)]
pub struct MotionConstraint {
    /// Name of the motion constraint.
    pub name: String,
    /// Left side A(q) q̇ + a(q) of the constraint, which is zero.
    pub equation: Expr,
    /// Part a(q) of the constraint that does not depend on rates. If it is not zero, the constraint drives the
    /// mechanism and its force does work.
    pub drive: Expr,
    /// SI unit of the constraint's equation, such as m/s.
    pub unit: Unit,
    /// Symbol of the Lagrange multiplier λ: the constraint adds Aᵀλ to the generalized forces.
    pub multiplier: Expr,
    /// Kind of the constraint: stated, rolling, rate of a loop, or time.
    pub kind: MotionConstraintKind,
    /// Index of the reaction that enforces the constraint; `None` if the model file states none.
    pub enforced_by: Option<usize>,
}

/// Redundant constraint: in every pose in which the loops are closed, it follows from other constraints. In other
/// poses it does not.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RedundantConstraint {
    /// Name of the redundant constraint in the model file.
    pub name: String,
    /// Left side of a redundant constraint between velocities: the term in q and q̇ that is zero. `None` for a
    /// constraint between coordinates, whose loop equation remains in the model.
    pub equation: Option<Expr>,
    /// Names of the constraints from which the redundant constraint follows. Empty if its derivatives vanish in every
    /// closed pose, so that it restricts no velocity.
    pub of: Vec<String>,
    /// Number of closed poses in which the redundancy was found, at the default values of the parameters.
    pub poses: usize,
}

/// Assembly branch: a set of closed poses in which the constraints have the same rank. The poses are found in
/// doubles, at the default values of the parameters.
#[derive(Clone, Debug, PartialEq)]
pub struct AssemblyBranch {
    /// Pose with closed loops that identifies the branch: a value in SI units for each generalized
    /// coordinate.
    pub pose: Vec<f64>,
    /// Number of closed poses of the branch in which the rank was found.
    pub poses: usize,
    /// Number of constraints whose rank was found, redundant constraints included.
    pub constraints: usize,
    /// Rank of the constraints: the number of independent constraints.
    pub rank: usize,
    /// Smallest norm that an independent row keeps after the rows before it are projected out. Each row holds a
    /// constraint's derivatives, scaled to length 1.
    pub independent: f64,
    /// Largest norm that a redundant row keeps after the independent rows are projected out. Each row holds a
    /// constraint's derivatives, scaled to length 1. `None` if no row is redundant.
    pub dependent: Option<f64>,
    /// Another branch with more degrees of freedom: (number of degrees of freedom, pose on that branch). `None` if
    /// random poses reached no such branch.
    pub larger: Option<(usize, Vec<f64>)>,
}
