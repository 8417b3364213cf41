//! Constraints, and the kinds of motion constraints.

use super::Unit;
use crate::algebra::Expr;

/// A holonomic constraint, solved for one configuration variable.
#[derive(Clone, Debug)]
pub struct Constraint {
    /// Its name in the file.
    pub name: String,
    /// The expression that is zero.
    pub equation: Expr,
    /// The configuration variable that it fixes.
    pub fixes: String,
    /// The value of that variable, in the generalized coordinates.
    pub value: Expr,
    /// The reaction that enforces it, if it is named.
    pub enforced_by: Option<usize>,
}

/// An equation φ(q) = 0 between coordinates that none of them can be solved from, such as that a loop is closed.
#[derive(Clone, Debug)]
pub struct Loop {
    /// Its name in the file.
    pub name: String,
    /// φ(q), which is zero.
    pub equation: Expr,
    /// Its unit, in SI.
    pub unit: Unit,
    /// True if the file states the constraint between one coordinate and time: it prescribes the coordinate, and closes
    /// nothing.
    pub prescribes: bool,
}

/// A component of the velocity at which the material of a body would slip.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Rolled {
    /// The body that rolls.
    pub body: usize,
    /// The body on which it does; none on the ground.
    pub against: Option<usize>,
    /// Point at which they touch.
    pub point: usize,
    /// The frame along whose axis the component is.
    pub frame: usize,
    /// The axis, from 0.
    pub axis: usize,
    /// True if the file states the frame; otherwise it may be another of the mechanism.
    pub is_stated: bool,
}

/// Kind of a motion constraint.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tie {
    /// An equation of the file between velocities.
    Stated,
    /// Rolling without slip: one component of the velocity at which the body would slip is zero.
    Rolling(Rolled),
    /// The time derivative of an equation between coordinates, by its place in [`super::Model::loops`].
    Loop(usize),
    /// Rate of time: t' = 1.
    Clock,
}

/// A motion constraint A(q) q̇ + a(q) = 0: what it permits cannot be said by coordinates alone, unless it can be
/// integrated.
#[derive(Clone, Debug)]
pub struct MotionConstraint {
    /// Its name.
    pub name: String,
    /// A(q) q̇ + a(q), which is zero.
    pub equation: Expr,
    /// a(q): where it is not zero, the constraint drives the mechanism, and its force works.
    pub drive: Expr,
    /// Its unit, in SI: that of a generalized speed.
    pub unit: Unit,
    /// The multiplier λ of Lagrange's equations: the constraint adds Aᵀλ to the generalized forces.
    pub multiplier: Expr,
    /// Kind of the constraint.
    pub tie: Tie,
    /// The reaction that enforces it, if it is named.
    pub enforced_by: Option<usize>,
}

/// A constraint that follows from others wherever the loops are closed, though not elsewhere.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DependentConstraint {
    /// Its name.
    pub name: String,
    /// Expression in q and q̇ that is zero, for a constraint between velocities. `None` for one between coordinates,
    /// which still closes its loop.
    pub equation: Option<Expr>,
    /// The constraints that it follows from.
    pub of: Vec<String>,
    /// Number of closed poses in which this was found, at the default values.
    pub poses: usize,
}

/// Rank of the constraints in the closed poses of one branch, in doubles, at the default values of the parameters.
#[derive(Clone, Debug, PartialEq)]
pub struct Branch {
    /// A closed pose, by which the branch is known: a value for each generalized coordinate.
    pub pose: Vec<f64>,
    /// Number of closed poses in which the rank was found.
    pub poses: usize,
    /// Constraints, those that follow from others among them.
    pub constraints: usize,
    /// Number of independent constraints.
    pub rank: usize,
    /// Smallest residual of an independent row of length 1, from which those before it were projected out.
    pub independent: f64,
    /// Largest such residual of a dependent row, if there is one.
    pub dependent: Option<f64>,
    /// Number of freedoms of another branch that random poses reached, if it has more, and a pose on that branch.
    pub larger: Option<(usize, Vec<f64>)>,
}
