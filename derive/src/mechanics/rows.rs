//! Results of a method of derivation: rows, and the steps that they come from. Names are data; their text is made from
//! them.

use super::quantity::{QuantityKind, VectorName};
use crate::algebra::Expr;
use crate::algebra::solve::least::Sum;
use crate::model::Model;

/// The rows of a linear system, as a method of derivation states them. The rest of [`super::Equations`] follows from
/// the model.
pub struct Rows {
    /// Name of each row: the speed, coordinate, constraint or balance that it belongs to.
    pub names: Vec<RowName>,
    /// One row each, in the order of the unknowns; in parameters, q and v.
    pub matrix: Vec<Vec<Expr>>,
    /// One entry a row; in parameters, q and v.
    pub forcing: Vec<Expr>,
    /// Multipliers of the rows, one list for each motion variable, under which reactions cancel; empty without
    /// reactions.
    pub projection: Vec<Vec<Expr>>,
    /// Map from fewer, free accelerations to v̇, where constraints tie the motion variables.
    pub embedding: Option<Embedding>,
    /// T in q and v.
    pub kinetic_energy: Expr,
    /// Forces along the motion variables, beside the loads, that v̇ requires, M v̇ − f; `Some` if the method has its
    /// own form of it.
    pub required: Option<Vec<Expr>>,
    /// Function that v̇ minimizes, by the accelerations of the bodies, where these are named.
    pub gauss: Option<Sum>,
}

/// Map from the accelerations s that constraints leave free to all v̇: v̇ = W s + x.
#[derive(Clone, Debug)]
pub struct Embedding {
    /// s: the rates of the generalized speeds.
    pub free: Vec<Expr>,
    /// W, a row for each motion variable.
    pub matrix: Vec<Vec<Expr>>,
    /// x in q and v.
    pub rest: Vec<Expr>,
}

/// Name of a row of equations of motion, as data. Places are positions from 0.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum RowName {
    /// A generalized speed.
    Speed(usize),
    /// A generalized coordinate.
    Coordinate(usize),
    /// A motion constraint, differentiated.
    Constraint(usize),
    /// A component of the balance of one body.
    Balance(BalanceName),
    /// The condition that shared reactions do no work together along a speed.
    Power(usize),
    /// A motion variable of a scene's reduced equations, by its name.
    Along(String),
    /// A row of a published system, by its place.
    Printed(usize),
}

/// A component of Newton's or Euler's equation of one body. Places are positions from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct BalanceName {
    /// The body.
    pub body: usize,
    /// True for a balance of moments about the mass centre, false for one of forces.
    pub moments: bool,
    /// The frame of the component.
    pub frame: usize,
    /// The axis of the component: 0, 1 or 2.
    pub axis: usize,
}

impl RowName {
    /// The name in plain text: `u1`, `q1`, `disk force b1`.
    #[must_use]
    pub fn text(&self, model: &Model) -> String {
        match self {
            Self::Speed(at) => model.speeds[*at].name.clone(),
            Self::Coordinate(at) => model.coordinates[*at].name.clone(),
            Self::Constraint(at) => format!("constraint {}", model.motion_constraints[*at].name),
            Self::Balance(BalanceName { frame, axis, .. }) => {
                let frame = model.frames[*frame].name.to_lowercase();
                format!("{} {frame}{}", self.subject(model), axis + 1)
            }
            Self::Power(speed) => format!("power of shared reactions along {}", model.speeds[*speed].name),
            Self::Along(variable) => format!("along {variable}"),
            Self::Printed(at) => format!("row {}", at + 1),
        }
    }

    /// Name of the balance without the direction: `disk force`; for other rows the whole name.
    #[must_use]
    pub fn subject(&self, model: &Model) -> String {
        match self {
            Self::Balance(BalanceName { body, moments, .. }) => {
                format!("{} {}", model.bodies[*body].name, if *moments { "moment" } else { "force" })
            }
            _ => self.text(model),
        }
    }
}

/// A stage of a derivation, to be shown: named quantities and their values.
#[derive(Clone, Debug)]
pub struct Step {
    /// Stage of the derivation.
    pub stage: Stage,
    /// The quantities.
    pub lines: Vec<(LineName, Expr)>,
}

/// Stage of a derivation, with its vector, frame or body. Places are positions from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stage {
    /// The definitions of the speeds, and the rates of the coordinates.
    KinematicEquations,
    /// A velocity in components, with its partial velocities.
    Velocities {
        /// Velocity or angular velocity.
        vector: VectorName,
        /// The point or frame that it belongs to.
        of: usize,
        /// The frame of the components.
        frame: usize,
    },
    /// The accelerations of a body.
    Accelerations(usize),
    /// The energies T and V.
    Energies,
    /// Kane's generalized active forces.
    ActiveForces,
    /// Lagrange's generalized forces.
    GeneralizedForces,
}

impl Stage {
    /// The heading, in plain text.
    #[must_use]
    pub fn title(self, model: &Model) -> String {
        match self {
            Self::KinematicEquations => "Generalized speeds and kinematic equations".to_owned(),
            Self::Velocities { vector, of, frame } => {
                let frame = &model.frames[frame].name;
                format!("Velocity and partial velocities: {} @ {frame}", vector.text(model, of))
            }
            Self::Accelerations(body) => format!("Accelerations of {}", model.bodies[body].name),
            Self::Energies => "Energies".to_owned(),
            Self::ActiveForces => "Generalized active forces".to_owned(),
            Self::GeneralizedForces => "Generalized forces other than gravity".to_owned(),
        }
    }
}

/// Quantity on the left-hand side of a line of a step. Places are positions from 0.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum LineName {
    /// A quantity that publication files can name, too.
    Quantity(QuantityKind),
    /// The generalized active force of a speed.
    ActiveForce(usize),
    /// The generalized force of a coordinate, gravity left out.
    GeneralizedForce(usize),
}

impl LineName {
    /// The name in plain text: `v(P) @ B [1]`, `d v(P) @ B [1]/d u2`, `F[u1]`, `Q[q1]`.
    #[must_use]
    pub fn text(&self, model: &Model) -> String {
        match self {
            Self::Quantity(kind) => kind.name(model),
            Self::ActiveForce(at) => format!("F[{}]", model.speeds[*at].name),
            Self::GeneralizedForce(at) => format!("Q[{}]", model.coordinates[*at].name),
        }
    }
}

/// The definitions of the speeds and the rates of the coordinates, which every derivation begins with.
pub(super) fn kinematic_step(model: &Model) -> Step {
    let speeds = model.speeds.iter().enumerate().map(|(at, s)| (QuantityKind::Speed(at), s.definition));
    let rates = model.kinematic_equations.rates.iter().enumerate().map(|(at, e)| (QuantityKind::Rate(at), *e));
    let lines = speeds.chain(rates).map(|(kind, e)| (LineName::Quantity(kind), e)).collect();
    Step { stage: Stage::KinematicEquations, lines }
}

/// Components of a vector in a frame, a line each.
pub(super) fn component_lines(
    (vector, of, frame): (VectorName, usize, usize),
    components: [Expr; 3],
) -> impl Iterator<Item = (LineName, Expr)> {
    let name = move |axis| LineName::Quantity(QuantityKind::Component { vector, of, frame, axis });
    components.into_iter().enumerate().map(move |(axis, e)| (name(axis), e))
}
