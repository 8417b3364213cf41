//! Forces, torques and potentials of a model, and reactions of its constraints.

use crate::algebra::Expr;

/// Place at which a force or reaction acts: the material of a body that is at a point at the given instant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ForcePlace {
    /// Index of the body on which the force or reaction acts.
    pub body: usize,
    /// Index of the point through which the force acts. The point may move relative to the body.
    pub point: usize,
}

/// Applied force on a body, with its opposite on another body if there is one.
#[derive(Clone, Debug)]
pub struct Force {
    /// Name of the force in the model file.
    pub name: String,
    /// Place at which the force acts.
    pub on: ForcePlace,
    /// Place at which the opposite force acts; `None` if the opposite acts on no body.
    pub against: Option<ForcePlace>,
    /// Index of the frame in which the force's components are given.
    pub frame: usize,
    /// Components of the force, N, as terms in parameters, q, q̇, u and
    /// [`Model::velocities`](super::Model::velocities).
    pub vector: [Expr; 3],
    /// Index of the point at the other end of a spring or damper, on a body or the ground; `None` for other forces.
    pub end: Option<usize>,
    /// Potential energy of a spring, J, as a term in q. It belongs to the force and its opposite, damping excluded.
    /// `None` if no potential is known.
    pub energy: Option<Expr>,
    /// Damper as (c, ḋ); it takes the power c ḋ². The coefficient c, N s/m, is a term in parameters. The rate ḋ of
    /// the damper's length, m/s, is a term in q and q̇. `None` without damping.
    pub damper: Option<[Expr; 2]>,
}

/// Applied torque on a frame, with its opposite on another frame if there is one.
#[derive(Clone, Debug)]
pub struct Torque {
    /// Name of the torque in the model file.
    pub name: String,
    /// Index of the frame on which the torque acts, and index of the body of that frame. The body is `None` if the
    /// frame has none.
    pub on: (usize, Option<usize>),
    /// Index of the frame on which the opposite torque acts, and index of the body of that frame, `None` if it has
    /// none. `None` as a whole if no opposite torque acts.
    pub against: Option<(usize, Option<usize>)>,
    /// Index of the frame in which the torque's components are given.
    pub frame: usize,
    /// Components of the torque, N m, as terms in parameters, q, q̇, u and
    /// [`Model::velocities`](super::Model::velocities).
    pub vector: [Expr; 3],
}

/// Potential energy that the model file states.
#[derive(Clone, Debug)]
pub struct Potential {
    /// Name of the potential in the model file.
    pub name: String,
    /// Energy V, J, as a term in parameters, q and t. It adds −∂V/∂q to the generalized forces of the coordinates. Time
    /// gets the force −(∂V/∂t − `explicit_rate`), by which the potential acts on a drive that moves its places.
    pub energy: Expr,
    /// Derivative ∂V/∂t, W, of the formula in the file with the positions that it names held fixed. No force does the
    /// work of this part.
    pub explicit_rate: Expr,
}

/// Force or torque between bodies that replaces a potential in the Newton–Euler equations.
#[derive(Clone, Debug)]
pub struct PotentialForce {
    /// Places or bodies on which the force or torque and its opposite act.
    pub kind: ReactionKind,
    /// Index of the frame in which the force's or torque's components are given.
    pub frame: usize,
    /// Components of the force, N, or of the torque, N m, as terms in parameters and q.
    pub vector: [Expr; 3],
}

/// Places or bodies on which a reaction and its opposite act: a force at points, or a torque.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ReactionKind {
    /// Force at a place, with its opposite at another place or on the ground.
    Force {
        /// Place at which the reaction force acts.
        on: ForcePlace,
        /// Place at which the opposite force acts; `None` for the ground.
        against: Option<ForcePlace>,
    },
    /// Torque on a body, with its opposite on another body or the ground.
    Torque {
        /// Index of the body on which the reaction torque acts.
        on: usize,
        /// Index of the body on which the opposite torque acts; `None` for the ground.
        against: Option<usize>,
    },
}

/// Reaction: the unknown force or torque of a constraint along a known direction.
#[derive(Clone, Debug)]
pub struct Reaction {
    /// Name of the reaction, from the model file; generated for a reaction that was found automatically.
    pub name: String,
    /// Symbol of the reaction's unknown value, N or N m, positive along `direction`.
    pub symbol: Expr,
    /// Places or bodies on which the reaction and its opposite act.
    pub kind: ReactionKind,
    /// Index of the frame in which the direction's components are given.
    pub frame: usize,
    /// Components of the unit vector along which a positive reaction acts.
    pub direction: [Expr; 3],
    /// True if the model file states the reaction; false if it was found automatically.
    pub is_stated: bool,
    /// True if the reaction does work by itself, but the powers of all shared reactions together are zero for every
    /// speed. It occurs for directions that are along no axis of a frame.
    pub is_shared: bool,
    /// Index of the body whose connection has its own law, such as a screw. The shared reactions of that connection
    /// do no work together, even in open loops. `None` if only all shared reactions of the model together do no work.
    pub law: Option<usize>,
}

/// Reaction that enforces a single equation of a joint that closes a loop.
#[derive(Clone, Debug)]
pub struct JointReaction {
    /// Name of the joint in the model file.
    pub joint: String,
    /// Name of the joint's equation that the reaction enforces.
    pub equation: String,
    /// Reaction that the joint exerts along the equation's direction.
    pub reaction: Reaction,
}
