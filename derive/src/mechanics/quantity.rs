//! Names of derived quantities in publication files, as data.

use crate::algebra::text::parse::{VelocityOf, velocity_name};
use crate::model::Model;
use std::fmt;

/// Kind of the object that a vector quantity belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Owner {
    /// A point of the model.
    Point,
    /// A frame of the model.
    Frame,
    /// A body or particle.
    Body,
    /// A rigid body.
    RigidBody,
}

impl Owner {
    /// The word in a form such as `v(POINT) @ FRAME [COMPONENT]`.
    pub(crate) const fn placeholder(self) -> &'static str {
        match self {
            Self::Point => "POINT",
            Self::Frame => "FRAME",
            Self::Body | Self::RigidBody => "BODY",
        }
    }
}

/// A vector that the model determines.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum VectorName {
    /// p of a point, from the origin, m.
    Position,
    /// v of a point in the inertial frame, m/s.
    Velocity,
    /// a of a point in the inertial frame, m/s².
    Acceleration,
    /// ω of a frame in the inertial frame, rad/s.
    AngularVelocity,
    /// α of a frame in the inertial frame, rad/s².
    AngularAcceleration,
    /// H = I · ω of a body about its mass centre, kg m²/s.
    AngularMomentum,
    /// dH/dt in the inertial frame, N m.
    MomentumRate,
    /// m a: the rate of the linear momentum, N.
    LinearMomentumRate,
    /// R* = −m a, N.
    InertiaForce,
    /// T* = −dH/dt, N m.
    InertiaTorque,
    /// Weight m g, N.
    Weight,
    /// The sum of all forces on a body, weight and reactions included, N.
    Force,
    /// The moment of all loads on a body about its mass centre, reactions included, N m.
    Moment,
}

impl VectorName {
    /// All of them, with their names.
    pub(crate) const ALL: [(Self, &'static str); 13] = [
        (Self::Position, "p"),
        (Self::Velocity, "v"),
        (Self::Acceleration, "a"),
        (Self::AngularVelocity, "omega"),
        (Self::AngularAcceleration, "alpha"),
        (Self::AngularMomentum, "H"),
        (Self::MomentumRate, "Hdot"),
        (Self::LinearMomentumRate, "pdot"),
        (Self::InertiaForce, "Rstar"),
        (Self::InertiaTorque, "Tstar"),
        (Self::Weight, "weight"),
        (Self::Force, "force"),
        (Self::Moment, "moment"),
    ];

    /// Kind of the object that the vector belongs to.
    #[must_use]
    pub const fn owner(self) -> Owner {
        match self {
            Self::Position | Self::Velocity | Self::Acceleration => Owner::Point,
            Self::AngularVelocity | Self::AngularAcceleration => Owner::Frame,
            Self::LinearMomentumRate | Self::InertiaForce | Self::Weight | Self::Force => Owner::Body,
            Self::AngularMomentum | Self::MomentumRate | Self::InertiaTorque | Self::Moment => Owner::RigidBody,
        }
    }

    /// Its letter or word in publication files.
    #[must_use]
    pub fn name(self) -> &'static str {
        Self::ALL[self as usize].1
    }

    /// The vector without a frame, in plain text: `v(P)`.
    #[must_use]
    pub fn text(self, model: &Model, of: usize) -> String {
        format!("{}({})", self.name(), self.owner_name(model, of))
    }

    /// The name of the point, frame or body at a position of the model's list.
    #[must_use]
    pub fn owner_name(self, model: &Model, of: usize) -> &str {
        match self.owner() {
            Owner::Point => &model.points[of].name,
            Owner::Frame => &model.frames[of].name,
            Owner::Body | Owner::RigidBody => &model.bodies[of].name,
        }
    }
}

/// An entry of Kane's equations F + F* = 0, that is M u̇ = f, or of Lagrange's, E q̈ = A.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Row {
    /// F: the generalized active force of a speed.
    ActiveForce,
    /// F*: the generalized inertia force of a speed, −(M u̇ + …).
    InertiaForce,
    /// f: Kane's forcing.
    Forcing,
    /// A: Lagrange's right-hand side.
    LagrangeForcing,
}

impl Row {
    /// All of them, with their names.
    pub(crate) const ALL: [(Self, &'static str); 4] =
        [(Self::ActiveForce, "F"), (Self::InertiaForce, "Fstar"), (Self::Forcing, "f"), (Self::LagrangeForcing, "A")];
}

/// An energy, J.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Energy {
    /// Kinetic energy T.
    Kinetic,
    /// Σ ½ m v·v.
    Translation,
    /// Σ ½ ω·I·ω.
    Rotation,
    /// V, of gravity and of the applied loads that have a potential.
    Potential,
    /// Gravity's part of V, zero where the model puts its zero.
    Gravity,
    /// L = T − V.
    Lagrangian,
    /// Total energy T + V.
    Total,
}

impl Energy {
    /// True if the energy is defined up to an additive constant.
    #[must_use]
    pub const fn has_a_zero(self) -> bool {
        matches!(self, Self::Potential | Self::Gravity | Self::Lagrangian | Self::Total)
    }

    /// All of them, with their names.
    pub(crate) const ALL: [(Self, &'static str); 7] = [
        (Self::Kinetic, "T"),
        (Self::Translation, "T_translation"),
        (Self::Rotation, "T_rotation"),
        (Self::Potential, "V"),
        (Self::Gravity, "V_gravity"),
        (Self::Lagrangian, "L"),
        (Self::Total, "energy"),
    ];
}

/// Kind of a quantity, with its indices. Points, frames, bodies, speeds, coordinates, rows and axes are positions
/// from 0.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum QuantityKind {
    /// Entry (row, column) of R with (components in `to`) = R · (components in `from`).
    Rotation {
        /// The frame whose components are turned.
        from: usize,
        /// The frame of the result.
        to: usize,
        /// Row and column.
        entry: (usize, usize),
    },
    /// A component of a vector along an axis of a frame.
    Component {
        /// The vector.
        vector: VectorName,
        /// The point, frame or body that it belongs to.
        of: usize,
        /// The frame of the component.
        frame: usize,
        /// The axis.
        axis: usize,
    },
    /// A component of the velocity, in the inertial frame, of the material of a body that is at a point, m/s.
    MaterialVelocity {
        /// The body.
        body: usize,
        /// The point.
        point: usize,
        /// The frame of the component.
        frame: usize,
        /// The axis.
        axis: usize,
    },
    /// A component of a partial velocity: the derivative by a speed.
    Partial {
        /// Velocity or angular velocity.
        vector: VectorName,
        /// The point or frame that it belongs to.
        of: usize,
        /// The frame of the component.
        frame: usize,
        /// The axis.
        axis: usize,
        /// The speed.
        speed: usize,
    },
    /// An entry of the central inertia of a body, kg m².
    Inertia {
        /// The body.
        body: usize,
        /// The frame of the components.
        frame: usize,
        /// Row and column.
        entry: (usize, usize),
    },
    /// An entry of a list with one row for each speed or coordinate.
    Row(Row, usize),
    /// An entry of Kane's mass matrix M.
    MassMatrix(usize, usize),
    /// An entry of Lagrange's matrix E.
    LagrangeMatrix(usize, usize),
    /// An energy.
    Energy(Energy),
    /// A speed, by its definition.
    Speed(usize),
    /// The time derivative of a coordinate, in terms of the speeds.
    Rate(usize),
    /// The time derivative of a speed, solved for: in q and u.
    SpeedRate(usize),
    /// The second time derivative of a coordinate, solved for: in q and u.
    SecondRate(usize),
}

impl QuantityKind {
    /// The name in full, with numbers for components and rows: two quantities are the same iff their names are.
    #[must_use]
    pub fn name(&self, model: &Model) -> String {
        let component = |vector: VectorName, of: usize, frame: usize, axis: usize| {
            format!("{} @ {} [{}]", vector.text(model, of), model.frames[frame].name, axis + 1)
        };
        match *self {
            Self::Rotation { from, to, entry: (i, j) } => {
                format!("rotation({}, {}) [{},{}]", model.frames[from].name, model.frames[to].name, i + 1, j + 1)
            }
            Self::Component { vector, of, frame, axis } => component(vector, of, frame, axis),
            Self::MaterialVelocity { body, point, frame, axis } => {
                let [body, point, frame] =
                    [&model.bodies[body].name, &model.points[point].name, &model.frames[frame].name];
                velocity_name(&VelocityOf::Material(body, point), frame, axis)
            }
            Self::Partial { vector, of, frame, axis, speed } => {
                format!("d {}/d {}", component(vector, of, frame, axis), model.speeds[speed].name)
            }
            Self::Inertia { body, frame, entry: (i, j) } => {
                format!("I({}) @ {} [{},{}]", model.bodies[body].name, model.frames[frame].name, i + 1, j + 1)
            }
            Self::Row(row, at) => format!("{}[{}]", Row::ALL[row as usize].1, at + 1),
            Self::MassMatrix(i, j) => format!("M[{},{}]", i + 1, j + 1),
            Self::LagrangeMatrix(i, j) => format!("E[{},{}]", i + 1, j + 1),
            Self::Energy(energy) => Energy::ALL[energy as usize].1.to_owned(),
            Self::Speed(at) => model.speeds[at].name.clone(),
            Self::Rate(at) => format!("{}'", model.coordinates[at].name),
            Self::SpeedRate(at) => format!("{}'", model.speeds[at].name),
            Self::SecondRate(at) => format!("{}''", model.coordinates[at].name),
        }
    }
}

/// A quantity that the model determines, such as `v(Cstar) @ B [1]`. Displays as its canonical name.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Quantity {
    kind: QuantityKind,
    name: String,
}

impl Quantity {
    /// A quantity of a model.
    ///
    /// # Panics
    /// If a position is outside the model's lists.
    #[must_use]
    pub fn new(kind: QuantityKind, model: &Model) -> Self {
        let name = kind.name(model);
        Self { kind, name }
    }

    /// Kind of the quantity, with its indices.
    #[must_use]
    pub fn kind(&self) -> &QuantityKind {
        &self.kind
    }

    /// The canonical name.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }
}

impl fmt::Display for Quantity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.name)
    }
}
