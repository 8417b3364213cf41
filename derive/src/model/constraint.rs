//! Constraints, and the kinds of motion constraints.

use super::Unit;
use crate::algebra::Expr;

/// A holonomic constraint, solved for one configuration variable.
#[derive(Clone, Debug)]
pub struct Constraint {
    /// Name of the constraint in the model file.
    pub name: String,
    /// Left side less right side of the constraint: the expression that is zero.
    pub equation: Expr,
    /// Name of the configuration variable that the constraint fixes.
    pub fixes: String,
    /// Value of the fixed variable, in the generalized coordinates.
    pub value: Expr,
    /// Index of the reaction that enforces the constraint; `None` if the model file names none.
    pub enforced_by: Option<usize>,
}

/// Index of a frame or a point, and the velocity that a motion adds there.
pub type AddedVelocity = (usize, [Expr; 3]);

/// Motion along a coordinate that the equation of a closed joint fixes, at rate 1, if that joint alone were open.
#[derive(Clone, Debug, Default)]
pub struct Opening {
    /// Frames that turn relative to their parents: index, and angular velocity along the axes of the frame.
    pub turns: Vec<AddedVelocity>,
    /// Points that move relative to their parents: index, and velocity along the axes in which the point is placed.
    pub moves: Vec<AddedVelocity>,
    /// Constraints that the motion would break: name, and rate of the equation.
    pub breaks: Vec<(String, Expr)>,
}

/// An equation φ(q) = 0 between coordinates, such as the closure of a loop, that cannot be solved for a coordinate.
#[derive(Clone, Debug)]
pub struct Loop {
    /// Name of the loop equation in the model file.
    pub name: String,
    /// Left side φ(q) of the loop equation, which is zero.
    pub equation: Expr,
    /// Unit of φ(q), in SI.
    pub unit: Unit,
    /// True if the model file states the constraint between one coordinate and time. It then prescribes the coordinate,
    /// and closes no loop.
    pub prescribes: bool,
}

/// A component of the velocity at which the material of a rolling body would slip.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Rolled {
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
    /// True if the model file states the frame. Otherwise the component may be taken along the axes of another frame.
    pub is_stated: bool,
}

/// Kind of a motion constraint.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MotionConstraintKind {
    /// An equation between velocities that the model file states.
    Stated,
    /// Rolling without slip: one component of the velocity at which the body would slip is zero.
    Rolling(Rolled),
    /// The time derivative of an equation between coordinates, with its index in [`super::Model::loops`].
    Loop(usize),
    /// The constraint on the rate of time: t' = 1.
    Clock,
}

/// A motion constraint A(q) q̇ + a(q) = 0. It restricts velocities; coordinates alone cannot state it, unless it can be
/// integrated.
#[derive(Clone, Debug)]
pub struct MotionConstraint {
    /// Name of the motion constraint.
    pub name: String,
    /// Expression A(q) q̇ + a(q), which is zero.
    pub equation: Expr,
    /// Term a(q) of the constraint. If it is not zero, the constraint drives the mechanism, and its force does work.
    pub drive: Expr,
    /// Unit of the equation, in SI: that of a generalized speed.
    pub unit: Unit,
    /// Multiplier λ of the constraint in Lagrange's equations: the constraint adds Aᵀλ to the generalized forces.
    pub multiplier: Expr,
    /// Kind of the constraint.
    pub kind: MotionConstraintKind,
    /// Index of the reaction that enforces the constraint; `None` if the model file names none.
    pub enforced_by: Option<usize>,
}

/// A constraint that follows from others wherever the loops are closed, though not elsewhere.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DependentConstraint {
    /// Name of the dependent constraint.
    pub name: String,
    /// Expression in q and q̇ that is zero, for a dependent constraint between velocities. `None` for one between
    /// coordinates, which still closes its loop.
    pub equation: Option<Expr>,
    /// Names of the constraints from which the dependent constraint follows.
    pub of: Vec<String>,
    /// Number of closed poses in which the dependence was found, at the default values.
    pub poses: usize,
}

/// Rank of the constraints in the closed poses of one branch, in doubles, at the default values of the parameters.
#[derive(Clone, Debug, PartialEq)]
pub struct Branch {
    /// A closed pose that identifies the branch: a value for each generalized coordinate.
    pub pose: Vec<f64>,
    /// Number of closed poses in which the rank was found.
    pub poses: usize,
    /// Number of constraints, including those that follow from others.
    pub constraints: usize,
    /// Number of independent constraints.
    pub rank: usize,
    /// Smallest residual of an independent row of length 1, after the rows before it were projected out.
    pub independent: f64,
    /// Largest residual of a dependent row of length 1, after independent rows were projected out; `None` if no row is
    /// dependent.
    pub dependent: Option<f64>,
    /// Freedoms of another branch that has more of them, and a pose on that branch; `None` if random poses reached no
    /// such branch.
    pub larger: Option<(usize, Vec<f64>)>,
}
