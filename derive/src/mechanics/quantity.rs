//! Names of derived quantities in publication files, as data.

use crate::algebra::text::parse::{VelocityOf, velocity_name};
use crate::model::Model;
use std::fmt;

/// Kind of object to which a vector quantity belongs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Owner {
    /// A point of the model.
    Point,
    /// A frame of the model.
    Frame,
    /// A body or particle.
    Body,
    /// A rigid body, not a particle.
    RigidBody,
}

impl Owner {
    /// Word for the owner in a form such as `v(POINT) @ FRAME [COMPONENT]`.
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
    /// Position p of a point, from the origin, m.
    Position,
    /// Velocity v of a point in the inertial frame, m/s.
    Velocity,
    /// Acceleration a of a point in the inertial frame, m/s².
    Acceleration,
    /// Angular velocity ω of a frame in the inertial frame, rad/s.
    AngularVelocity,
    /// Angular acceleration α of a frame in the inertial frame, rad/s².
    AngularAcceleration,
    /// Angular momentum H = I · ω of a body about its mass centre, kg m²/s.
    AngularMomentum,
    /// Rate dH/dt of the angular momentum of a body in the inertial frame, N m.
    MomentumRate,
    /// Rate m a of the linear momentum of a body, N.
    LinearMomentumRate,
    /// Inertia force R* = −m a of a body, N.
    InertiaForce,
    /// Inertia torque T* = −dH/dt of a body, N m.
    InertiaTorque,
    /// Weight m g of a body, N.
    Weight,
    /// Sum of all forces on a body, N, weight and reactions included.
    Force,
    /// Moment of all loads on a body about its mass centre, N m, reactions included.
    Moment,
}

impl VectorName {
    /// All vectors in the order of the variants, each with its name in publication files.
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

    /// Kind of object to which the vector belongs.
    #[must_use]
    pub const fn owner(self) -> Owner {
        match self {
            Self::Position | Self::Velocity | Self::Acceleration => Owner::Point,
            Self::AngularVelocity | Self::AngularAcceleration => Owner::Frame,
            Self::LinearMomentumRate | Self::InertiaForce | Self::Weight | Self::Force => Owner::Body,
            Self::AngularMomentum | Self::MomentumRate | Self::InertiaTorque | Self::Moment => Owner::RigidBody,
        }
    }

    /// Letter or word for the vector in publication files.
    #[must_use]
    pub fn name(self) -> &'static str {
        Self::ALL[self as usize].1
    }

    /// Vector and its owner without a frame, in plain text: `v(P)`.
    #[must_use]
    pub fn text(self, model: &Model, of: usize) -> String {
        format!("{}({})", self.name(), self.owner_name(model, of))
    }

    /// Name of the point, frame or body at a position of the model's list.
    #[must_use]
    pub fn owner_name(self, model: &Model, of: usize) -> &str {
        match self.owner() {
            Owner::Point => &model.points[of].name,
            Owner::Frame => &model.frames[of].name,
            Owner::Body | Owner::RigidBody => &model.bodies[of].name,
        }
    }
}

/// Row of Kane's equations F + F* = 0, or M u̇ = f, or of Lagrange's equations E q̈ = A, d/dt ∂L/∂q̇ − ∂L/∂q = Q.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Row {
    /// Generalized active force F of a speed.
    ActiveForce,
    /// Generalized inertia force F* = −(M u̇ + …) of a speed.
    InertiaForce,
    /// Forcing f of Kane's equations.
    Forcing,
    /// Right-hand side A of Lagrange's equations.
    LagrangeForcing,
    /// Terms C q̇ in products of rates, of M q̈ + C q̇ + g = τ.
    VelocityTerms,
    /// Slope ∂V/∂q of the potential energy, g of M q̈ + C q̇ + g = τ.
    PotentialSlope,
    /// Generalized momentum ∂L/∂q̇, with no constraint put in.
    Momentum,
    /// Rate d/dt ∂L/∂q̇ of the generalized momentum along the motion, linear in q̈.
    MomentumRate,
    /// Slope ∂/∂t ∂L/∂q̇ of the generalized momentum in the time alone, with q and q̇ held.
    HeldMomentumRate,
    /// Slope ∂L/∂q of the Lagrangian, with q̇ held.
    LagrangianSlope,
}

impl Row {
    /// All rows in the order of the variants, each with its name in publication files.
    pub(crate) const ALL: [(Self, &'static str); 10] = [
        (Self::ActiveForce, "F"),
        (Self::InertiaForce, "Fstar"),
        (Self::Forcing, "f"),
        (Self::LagrangeForcing, "A"),
        (Self::VelocityTerms, "h"),
        (Self::PotentialSlope, "g"),
        (Self::Momentum, "dL_dqdot"),
        (Self::MomentumRate, "ddt_dL_dqdot"),
        (Self::HeldMomentumRate, "partial_t_dL_dqdot"),
        (Self::LagrangianSlope, "dL_dq"),
    ];

    /// True if the rows belong to coordinates, false if they belong to speeds.
    pub(crate) const fn is_of_coordinates(self) -> bool {
        !matches!(self, Self::ActiveForce | Self::InertiaForce | Self::Forcing)
    }
}

/// Kind of an energy, J.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Energy {
    /// Kinetic energy T.
    Kinetic,
    /// Kinetic energy of translation, Σ ½ m v·v.
    Translation,
    /// Kinetic energy of rotation, Σ ½ ω·I·ω.
    Rotation,
    /// Potential energy V of gravity and of the applied loads that have a potential.
    Potential,
    /// Potential energy of gravity alone, zero where the model puts its zero.
    Gravity,
    /// Lagrangian L = T − V.
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

    /// All energies in the order of the variants, each with its name in publication files.
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

/// Kind of a quantity, with its indices. Indices of points, frames, bodies, speeds, coordinates, rows and axes count
/// from 0.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum QuantityKind {
    /// Entry of the rotation matrix R with (components in `to`) = R · (components in `from`).
    Rotation {
        /// Index of the frame whose components are turned.
        from: usize,
        /// Index of the frame of the turned components.
        to: usize,
        /// Row and column of the entry.
        entry: (usize, usize),
    },
    /// Component of a vector along an axis of a frame.
    Component {
        /// Name of the vector.
        vector: VectorName,
        /// Index of the point, frame or body to which the vector belongs.
        of: usize,
        /// Index of the frame of the component.
        frame: usize,
        /// Axis of the component: 0, 1 or 2.
        axis: usize,
    },
    /// Component of the velocity, in the inertial frame, of a body's material at a point, m/s.
    MaterialVelocity {
        /// Index of the body.
        body: usize,
        /// Index of the point.
        point: usize,
        /// Index of the frame of the component.
        frame: usize,
        /// Axis of the component: 0, 1 or 2.
        axis: usize,
    },
    /// Component of a partial velocity, the derivative of a velocity along a speed.
    Partial {
        /// Kind of the vector: velocity or angular velocity.
        vector: VectorName,
        /// Index of the point or frame to which the velocity belongs.
        of: usize,
        /// Index of the frame of the component.
        frame: usize,
        /// Axis of the component: 0, 1 or 2.
        axis: usize,
        /// Index of the speed.
        speed: usize,
    },
    /// Entry of the central inertia of a body, kg m².
    Inertia {
        /// Index of the body.
        body: usize,
        /// Index of the frame of the components.
        frame: usize,
        /// Row and column of the entry.
        entry: (usize, usize),
    },
    /// Entry of a list with one row for each speed or coordinate, with the index of the row.
    Row(Row, usize),
    /// Entry of Kane's mass matrix M, at a row and column.
    MassMatrix(usize, usize),
    /// Entry of Lagrange's matrix E, at a row and column.
    LagrangeMatrix(usize, usize),
    /// Entry of the matrix C of C q̇ by Christoffel symbols, at a row and column.
    Christoffel(usize, usize),
    /// Rate of an entry of the mass matrix ∂²T/∂q̇∂q̇ along the motion, at a row and column.
    MassRate(usize, usize),
    /// Energy of the model.
    Energy(Energy),
    /// Generalized speed, by its definition.
    Speed(usize),
    /// Time derivative of a coordinate, in terms of the speeds.
    Rate(usize),
    /// Time derivative of a speed from the solved equations, in q and u.
    SpeedRate(usize),
    /// Second time derivative of a coordinate from the solved equations, in q and u.
    SecondRate(usize),
}

impl QuantityKind {
    /// Full name of the quantity, with numbers for components and rows. Two quantities are equal if and only if their
    /// names are.
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
            Self::Christoffel(i, j) => format!("C[{},{}]", i + 1, j + 1),
            Self::MassRate(i, j) => format!("Edot[{},{}]", i + 1, j + 1),
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
    /// Quantity of a model, with its canonical name.
    ///
    /// # Panics
    /// If an index is outside the model's lists.
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

    /// Canonical name of the quantity, such as `v(Cstar) @ B [1]`.
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
