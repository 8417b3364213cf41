//! Result of a method of derivation: rows, and the steps that lead to them. Names are data, from which their text is
//! made.

use super::quantity::{QuantityKind, VectorName};
use crate::algebra::Expr;
use crate::algebra::solve::least::Sum;
use crate::model::Model;

/// Rows of a linear system, as a method of derivation states them. The other fields of [`super::Equations`] follow from
/// the model.
pub struct Rows {
    /// Name of each row: the speed, coordinate, constraint or balance that it belongs to.
    pub names: Vec<RowName>,
    /// Matrix of the system, one column for each unknown; in parameters, q and v.
    pub matrix: Vec<Vec<Expr>>,
    /// Right-hand side of the system, one entry for each row; in parameters, q and v.
    pub forcing: Vec<Expr>,
    /// Multipliers of the rows, one list for each motion variable, which cancel the reactions; empty without reactions.
    pub projection: Vec<Vec<Expr>>,
    /// Map from the free accelerations to v̇; present if constraints tie the motion variables.
    pub embedding: Option<Embedding>,
    /// Kinetic energy T, in q and v.
    pub kinetic_energy: Expr,
    /// Forces M v̇ − f along the motion variables, beside the loads, that v̇ requires. `None` if the method has no form
    /// of its own for them.
    pub required: Option<Vec<Expr>>,
    /// Function of the bodies' accelerations that v̇ minimizes; present if the accelerations are named.
    pub gauss: Option<Sum>,
}

/// Map v̇ = W s + x from the accelerations s that constraints leave free to all accelerations v̇.
#[derive(Clone, Debug)]
pub struct Embedding {
    /// Symbols of the free accelerations s, the rates of the generalized speeds.
    pub free: Vec<Expr>,
    /// Matrix W, one row for each motion variable.
    pub matrix: Vec<Vec<Expr>>,
    /// Remaining acceleration x, in q and v, one entry for each motion variable.
    pub rest: Vec<Expr>,
}

/// Name of a row of equations of motion, as data. Indices count from 0.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum RowName {
    /// Row of a generalized speed.
    Speed(usize),
    /// Row of a generalized coordinate.
    Coordinate(usize),
    /// Row of a motion constraint, differentiated in time.
    Constraint(usize),
    /// Component of the balance of one body.
    Balance(BalanceName),
    /// Condition that the shared reactions together do no work along a speed.
    Power(usize),
    /// Condition that the shared reactions between a body and its holder together do no work along the rate of a
    /// coordinate, as the law of a screw says.
    Law {
        /// Index of the body.
        body: usize,
        /// Index of the coordinate.
        coordinate: usize,
    },
    /// Row of a motion variable of a scene's reduced equations, with the name of the variable.
    Along(String),
    /// Row of a published system, with its index.
    Printed(usize),
}

/// Component of Newton's or Euler's equation of one body. Indices count from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct BalanceName {
    /// Index of the body.
    pub body: usize,
    /// True for a balance of moments about the mass centre, false for a balance of forces.
    pub moments: bool,
    /// Index of the frame of the component.
    pub frame: usize,
    /// Axis of the component: 0, 1 or 2.
    pub axis: usize,
}

impl RowName {
    /// Name of the row in plain text: `u1`, `q1`, `disk force b1`.
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
            Self::Law { body, coordinate } => format!(
                "power of shared reactions on {} along {}'",
                model.bodies[*body].name, model.coordinates[*coordinate].name
            ),
            Self::Along(variable) => format!("along {variable}"),
            Self::Printed(at) => format!("row {}", at + 1),
        }
    }

    /// Name of a balance without its direction: `disk force`. For other rows, the whole name.
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

/// Step of a derivation, for display: named quantities and their values.
#[derive(Clone, Debug)]
pub struct Step {
    /// Stage of the derivation that the step shows.
    pub stage: Stage,
    /// Quantities of the step, each with its value.
    pub lines: Vec<(LineName, Expr)>,
}

/// Stage of a derivation, with its vector, frame or body. Indices count from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stage {
    /// Definitions of the speeds, and the rates of the coordinates.
    KinematicEquations,
    /// Components of a velocity, with its partial velocities.
    Velocities {
        /// Kind of the vector: velocity or angular velocity.
        vector: VectorName,
        /// Index of the point or frame to which the velocity belongs.
        of: usize,
        /// Index of the frame of the components.
        frame: usize,
    },
    /// Accelerations of a body.
    Accelerations(usize),
    /// The energies T and V.
    Energies,
    /// Kane's generalized active forces.
    ActiveForces,
    /// Lagrange's generalized forces.
    GeneralizedForces,
    /// Stage that one method alone has, with its heading.
    Titled(&'static str),
}

impl Stage {
    /// Heading of the stage, in plain text.
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
            Self::Titled(title) => title.to_owned(),
        }
    }
}

/// Quantity on the left-hand side of a line of a step. Indices count from 0.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum LineName {
    /// Quantity that publication files can also name.
    Quantity(QuantityKind),
    /// Generalized active force of a speed.
    ActiveForce(usize),
    /// Generalized force of a coordinate, without gravity.
    GeneralizedForce(usize),
    /// Scalar that one method alone has, by its symbol.
    Symbol(&'static str),
}

impl LineName {
    /// Name of the quantity in plain text: `v(P) @ B [1]`, `d v(P) @ B [1]/d u2`, `F[u1]`, `Q[q1]`.
    #[must_use]
    pub fn text(&self, model: &Model) -> String {
        match self {
            Self::Quantity(kind) => kind.name(model),
            Self::ActiveForce(at) => format!("F[{}]", model.speeds[*at].name),
            Self::GeneralizedForce(at) => format!("Q[{}]", model.coordinates[*at].name),
            Self::Symbol(symbol) => (*symbol).to_owned(),
        }
    }
}

/// First step of every derivation: definitions of the speeds and rates of the coordinates.
pub(super) fn kinematic_step(model: &Model) -> Step {
    let speeds = model.speeds.iter().enumerate().map(|(at, s)| (QuantityKind::Speed(at), s.definition));
    let rates = model.kinematic_equations.rates.iter().enumerate().map(|(at, e)| (QuantityKind::Rate(at), *e));
    let lines = speeds.chain(rates).map(|(kind, e)| (LineName::Quantity(kind), e)).collect();
    Step { stage: Stage::KinematicEquations, lines }
}

/// Components of a vector in a frame, one line for each.
pub(super) fn component_lines(
    vector: VectorName,
    of: usize,
    frame: usize,
    components: [Expr; 3],
) -> impl Iterator<Item = (LineName, Expr)> {
    let name = move |axis| LineName::Quantity(QuantityKind::Component { vector, of, frame, axis });
    components.into_iter().enumerate().map(move |(axis, e)| (name(axis), e))
}
