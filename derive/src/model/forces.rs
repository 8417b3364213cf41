//! Forces, torques and potentials of a model, and the reactions of its constraints.

use crate::algebra::Expr;

/// Place at which a force or reaction acts: the material of a body that is at a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Place {
    /// Index of the body on which the force or reaction acts.
    pub body: usize,
    /// Index of the point through which the force acts. The point may move through the body.
    pub point: usize,
}

/// An applied force, and its opposite on another body if there is one.
#[derive(Clone, Debug)]
pub struct Force {
    /// Name of the force in the model file.
    pub name: String,
    /// Place at which the force acts.
    pub on: Place,
    /// Place at which the opposite of the force acts; `None` if no opposite acts on a body.
    pub against: Option<Place>,
    /// Index of the frame of the force's components.
    pub frame: usize,
    /// Components of the force, N, in parameters, q, q̇, u and [`Model::velocities`](super::Model::velocities).
    pub vector: [Expr; 3],
    /// Index of the point at the other end of a spring or damper, on a body or the ground; `None` for other forces.
    pub end: Option<usize>,
    /// Potential energy of a spring in q, J: that of the force and its opposite without damping. `None` if no potential
    /// is known.
    pub energy: Option<Expr>,
    /// Coefficient c of a damper, in parameters, and rate ḋ of its length, in q and q̇. The damper takes the power c
    /// ḋ².
    pub damper: Option<[Expr; 2]>,
}

/// An applied torque, and its opposite on another frame if there is one.
#[derive(Clone, Debug)]
pub struct Torque {
    /// Name of the torque in the model file.
    pub name: String,
    /// Index of the frame that the torque turns, and index of the body of that frame if it has one.
    pub on: (usize, Option<usize>),
    /// Frame that the opposite torque turns, and its body if it has one; `None` if no opposite acts.
    pub against: Option<(usize, Option<usize>)>,
    /// Index of the frame of the torque's components.
    pub frame: usize,
    /// Components of the torque, N m, in parameters, q, q̇, u and [`Model::velocities`](super::Model::velocities).
    pub vector: [Expr; 3],
}

/// A potential energy as the model file gives it.
#[derive(Clone, Debug)]
pub struct Potential {
    /// Name of the potential in the model file.
    pub name: String,
    /// Energy V, J, in parameters, q and t. It adds −∂V/∂q to the generalized forces of the coordinates other than
    /// time.
    pub energy: Expr,
}

/// A force or torque between bodies that represents potentials in the Newton–Euler equations.
#[derive(Clone, Debug)]
pub struct Effort {
    /// Places or bodies on which the effort and its opposite act.
    pub kind: ReactionKind,
    /// Index of the frame of the effort's components.
    pub frame: usize,
    /// Components of the effort, N for a force or N m for a torque, in parameters and q.
    pub vector: [Expr; 3],
}

/// Places or bodies on which a reaction and its opposite act.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ReactionKind {
    /// A force at a place, and its opposite at another place if one is given.
    Force {
        /// Place at which the reaction force acts.
        on: Place,
        /// Place at which the opposite force acts; `None` on the ground.
        against: Option<Place>,
    },
    /// A torque on a body, and its opposite on another body if one is given.
    Torque {
        /// Index of the body that the reaction torque turns.
        on: usize,
        /// Index of the body that the opposite torque turns; `None` for the ground.
        against: Option<usize>,
    },
}

/// An unknown force or torque that a constraint exerts along a known direction.
#[derive(Clone, Debug)]
pub struct Reaction {
    /// Name of the reaction, of the model file or made for a reaction that was found.
    pub name: String,
    /// Symbol of the reaction's unknown size.
    pub symbol: Expr,
    /// Places or bodies on which the reaction and its opposite act.
    pub kind: ReactionKind,
    /// Index of the frame of the direction's components.
    pub frame: usize,
    /// Components of the direction along which positive values of the reaction act.
    pub direction: [Expr; 3],
    /// True if the model file names the reaction, false if it was found.
    pub is_stated: bool,
    /// True if the reaction does work by itself, while the powers of all such reactions along every speed add up to
    /// zero. Such reactions hold directions that lie along no axis of a frame.
    pub is_shared: bool,
    /// Index of the body whose connection to its holder has a law of its own, such as that of a screw: the shared
    /// reactions of this connection do no work together even in open loops. `None` if only all shared reactions
    /// together do no work.
    pub law: Option<usize>,
}

/// Reaction of an equation of a joint that closes a loop.
#[derive(Clone, Debug)]
pub struct JointReaction {
    /// Name of the joint.
    pub joint: String,
    /// Name of the joint's equation that the reaction enforces.
    pub equation: String,
    /// Reaction that the joint exerts.
    pub reaction: Reaction,
}
