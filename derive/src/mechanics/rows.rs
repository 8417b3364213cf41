//! Result of a method of derivation: rows of a linear system, and the steps that lead to them. Names of rows and
//! steps are data, from which their text is made.

use super::quantity::{QuantityKind, VectorName};
use crate::algebra::Expr;
use crate::algebra::solve::quadratic_minimum::QuadraticForm;
use crate::model::Model;

/// Rows of the linear system matrix · unknowns = forcing that a method of derivation gives. The further fields of
/// [`super::Equations`] follow from the model.
pub struct Rows {
    /// Names of the rows. A row belongs to a speed, a coordinate, a constraint or a balance of a body.
    pub names: Vec<RowName>,
    /// Matrix of the system, with a column for each unknown, in parameters, q and v.
    pub matrix: Vec<Vec<Expr>>,
    /// Right-hand side of the system, one entry for each row; in parameters, q and v.
    pub forcing: Vec<Expr>,
    /// Multipliers of the rows that cancel the reactions and the multipliers of constraints: one list for each
    /// generalized speed, with one entry for each row. Empty if the system has none of these.
    pub projection: Vec<Vec<Expr>>,
    /// Map from the free accelerations to v̇. `None` unless motion constraints tie the motion variables.
    pub embedding: Option<AccelerationEmbedding>,
    /// Kinetic energy T of all bodies, J, as a term in q and the motion variables v.
    pub kinetic_energy: Expr,
    /// Inverse dynamics M v̇ − f: the generalized forces that the accelerations v̇ require in addition
    /// to the loads. `None` if the method does not derive them separately.
    pub required: Option<Vec<Expr>>,
    /// Function of the bodies' accelerations that is smallest at the actual v̇ (Gauss's principle). `None` unless
    /// accelerations have named subterms.
    pub gauss: Option<QuadraticForm>,
}

/// Linear map v̇ = W s + x from the accelerations s that motion constraints leave free to all
/// accelerations v̇.
#[derive(Clone, Debug)]
pub struct AccelerationEmbedding {
    /// Symbols of the free accelerations s: the rates of the generalized speeds.
    pub free: Vec<Expr>,
    /// Matrix W, with a row for each motion variable and a column for each free acceleration.
    pub matrix: Vec<Vec<Expr>>,
    /// Remaining acceleration x as a term in q and v, one entry for each motion variable.
    pub rest: Vec<Expr>,
}

/// Name of a row of equations of motion, as data. All indices count from 0.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum RowName {
    /// Row of the generalized speed with this index.
    Speed(usize),
    /// Row of the generalized coordinate with this index.
    Coordinate(usize),
    /// Row of the motion constraint with this index, differentiated by time.
    Constraint(usize),
    /// Row of a component of a body's force or moment balance.
    Balance(BalanceName),
    /// Row that states: all shared reactions together do no work along the speed with this index. A shared reaction
    /// does work by itself, but the powers of all of them cancel.
    Power(usize),
    /// Row that states: the shared reactions of a connection with its own law (such as a screw)
    /// together do no work along the rate of a coordinate.
    Law {
        /// Index of the body that the connection holds.
        body: usize,
        /// Index of the coordinate along whose rate the powers cancel.
        coordinate: usize,
    },
    /// Row of a motion variable of a scene's reduced equations, by the name of the variable.
    Along(String),
    /// Row of a published system of equations, by its index.
    Printed(usize),
}

/// Name of a component of a body's force balance (Newton) or moment balance (Euler). All indices
/// count from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct BalanceName {
    /// Index of the body in the model.
    pub body: usize,
    /// True for a balance of moments about the mass centre, false for a balance of forces.
    pub moments: bool,
    /// Index of the frame along whose axis the component is taken.
    pub frame: usize,
    /// Axis of the frame: 0, 1 or 2.
    pub axis: usize,
}

impl RowName {
    /// Name of the row in plain text, such as `u1`, `q1` or `disk force b1`.
    #[must_use]
    pub fn text(&self, model: &Model) -> String {
        match self {
            Self::Speed(at) => model.speeds[*at].name.clone(),
            Self::Coordinate(at) => model.coordinates[*at].name.clone(),
            Self::Constraint(at) => format!("constraint {}", model.motion_constraints[*at].name),
            Self::Balance(BalanceName { frame, axis, .. }) => {
                let frame = model.frames[*frame].name.to_lowercase();
                format!("{} {frame}{}", self.balance_name_without_axis(model), axis + 1)
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

    /// Name of a balance without its direction, such as `disk force`. For a row that is no balance, its whole name.
    #[must_use]
    pub fn balance_name_without_axis(&self, model: &Model) -> String {
        match self {
            Self::Balance(BalanceName { body, moments, .. }) => {
                format!("{} {}", model.bodies[*body].name, if *moments { "moment" } else { "force" })
            }
            _ => self.text(model),
        }
    }
}

/// Step of a derivation, for display: a list of named quantities with their values.
#[derive(Clone, Debug)]
pub struct Step {
    /// Stage of the derivation to which the step belongs; it gives the heading.
    pub stage: Stage,
    /// Quantities of the step in order, each with its value.
    pub lines: Vec<(LineName, Expr)>,
}

/// Stage of a derivation, such as the velocities of a body. All indices count from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stage {
    /// Definitions of the generalized speeds, and the rates q̇ in terms of the speeds.
    KinematicEquations,
    /// Components of a velocity, followed by its partial velocities.
    Velocities {
        /// Kind of the vector: velocity of a point, or angular velocity of a frame.
        vector: VectorName,
        /// Index of the point or frame to which the velocity belongs.
        of: usize,
        /// Index of the frame along whose axes the components are taken.
        frame: usize,
    },
    /// Acceleration of the mass centre and angular acceleration of the body with this index.
    Accelerations(usize),
    /// Kinetic energy T and potential energy V of the model.
    Energies,
    /// Generalized active forces F of Kane's method, for all speeds.
    ActiveForces,
    /// Generalized forces Q of Lagrange's method, without the forces whose potential is in V.
    GeneralizedForces,
    /// Stage that only one method of derivation has, by its heading.
    Titled(&'static str),
}

impl Stage {
    /// Heading of the stage in plain text, such as `Energies`.
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

/// Name of the quantity on the left-hand side of a line in a derivation step. All indices count
/// from 0.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum LineName {
    /// Quantity that publication files can also name, such as a velocity component.
    Quantity(QuantityKind),
    /// Generalized active force of the speed with this index.
    ActiveForce(usize),
    /// Generalized force of the coordinate with this index, without the forces whose potential is in V.
    GeneralizedForce(usize),
    /// Scalar that only one method of derivation has, by its symbol, such as `S`.
    Symbol(&'static str),
}

impl LineName {
    /// Name of the quantity in plain text, such as `v(P) @ B [1]`, `d v(P) @ B [1]/d u2`, `F[u1]` or
    /// `Q[q1]`.
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

/// First step of every derivation: definitions of the generalized speeds, and the rates q̇ of the
/// coordinates.
pub(super) fn kinematic_step(model: &Model) -> Step {
    let speeds = model.speeds.iter().enumerate().map(|(at, s)| (QuantityKind::Speed(at), s.definition));
    let rates = model.kinematic_equations.rates.iter().enumerate().map(|(at, e)| (QuantityKind::Rate(at), *e));
    let lines = speeds.chain(rates).map(|(kind, e)| (LineName::Quantity(kind), e)).collect();
    Step { stage: Stage::KinematicEquations, lines }
}

/// Lines of a derivation step for the three components of a vector along a frame, one line each.
pub(super) fn component_lines(
    vector: VectorName,
    of: usize,
    frame: usize,
    components: [Expr; 3],
) -> impl Iterator<Item = (LineName, Expr)> {
    let name = move |axis| LineName::Quantity(QuantityKind::Component { vector, of, frame, axis });
    components.into_iter().enumerate().map(move |(axis, e)| (name(axis), e))
}
