//! What constraints tie.

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
    /// Whether the file states it between one coordinate and time: it tells the coordinate where to be, and closes nothing.
    pub prescribes: bool,
}

/// A component of the velocity at which the material of a body would slip.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Rolled {
    /// The body that rolls.
    pub body: usize,
    /// The body on which it does; none on the ground.
    pub against: Option<usize>,
    /// Where they touch.
    pub point: usize,
    /// The frame along whose axis the component is.
    pub frame: usize,
    /// The axis, from 0.
    pub axis: usize,
    /// Whether the file states the frame; else it may be another of the mechanism.
    pub is_stated: bool,
}

/// What a motion constraint states.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tie {
    /// An equation of the file between velocities.
    Stated,
    /// That a body rolls without slip: one component of the velocity at which it would slip.
    Rolling(Rolled),
    /// The time derivative of an equation between coordinates, by its place in [`super::Model::loops`].
    Loop(usize),
    /// That time goes on: t' = 1.
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
    /// What it states.
    pub tie: Tie,
    /// The reaction that enforces it, if it is named.
    pub enforced_by: Option<usize>,
}

/// A constraint that follows from others wherever the loops are closed, though not elsewhere.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DependentConstraint {
    /// Its name.
    pub name: String,
    /// What is zero, in q and q̇, of one between velocities; one between coordinates goes on to close its loop.
    pub equation: Option<Expr>,
    /// The constraints that it follows from.
    pub of: Vec<String>,
    /// In how many closed poses this was found, at the default values.
    pub poses: usize,
}

/// What was found where the loops of a mechanism are closed, in doubles, at the default values of its parameters.
#[derive(Clone, Debug, PartialEq)]
pub struct Branch {
    /// A closed pose, by which the branch is known: a value for each generalized coordinate.
    pub pose: Vec<f64>,
    /// In how many closed poses the rank was found.
    pub poses: usize,
    /// Constraints, those that follow from others among them.
    pub constraints: usize,
    /// How many of them are independent.
    pub rank: usize,
    /// The least that was left of an independent row of length 1 when those before it were taken out of it.
    pub independent: f64,
    /// The most that was left of a dependent one, if there is one.
    pub dependent: Option<f64>,
    /// The freedoms of another branch that random poses came to, if it has more, and a pose on that.
    pub larger: Option<(usize, Vec<f64>)>,
}
