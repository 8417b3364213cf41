//! Quantities that a publication file can name, such as `v(P) @ B [1]`. Here they are data, not text.

use crate::algebra::text::parse::{VelocityOf, velocity_name};
use crate::model::Model;
use std::fmt;

/// Kind of model object to which a vector quantity belongs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum QuantityOwner {
    /// Vector belongs to a point of the model, such as a velocity.
    Point,
    /// Vector belongs to a frame of the model, such as an angular velocity.
    Frame,
    /// Vector belongs to a body or particle, such as a weight.
    Body,
    /// Vector belongs to a rigid body, not to a particle, such as an angular momentum.
    RigidBody,
}

impl QuantityOwner {
    /// Placeholder for the owner in the text of a form, such as `POINT` in `v(POINT) @ FRAME
    /// [COMPONENT]`.
    pub(crate) const fn placeholder(self) -> &'static str {
        match self {
            Self::Point => "POINT",
            Self::Frame => "FRAME",
            Self::Body | Self::RigidBody => "BODY",
        }
    }
}

/// Vector that the model determines, such as a velocity or a force.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum VectorName {
    /// Position p of a point from the origin, m.
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
    /// Rate dH/dt, in the inertial frame, of a body's angular momentum about its mass centre, N m.
    MomentumRate,
    /// Rate m a of the linear momentum of a body, N.
    LinearMomentumRate,
    /// Inertia force R* = −m a of a body, N.
    InertiaForce,
    /// Inertia torque T* = −dH/dt of a body, N m.
    InertiaTorque,
    /// Weight m g of a body, N.
    Weight,
    /// Sum of all forces on a body, N, including weight and reactions.
    Force,
    /// Moment of all loads on a body about its mass centre, N m, including reactions.
    Moment,
}

impl VectorName {
    /// All kinds of vectors in the order of the variants, each with its name in publication files.
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

    /// Kind of model object to which the vector belongs: point, frame or body.
    #[must_use]
    pub const fn owner(self) -> QuantityOwner {
        match self {
            Self::Position | Self::Velocity | Self::Acceleration => QuantityOwner::Point,
            Self::AngularVelocity | Self::AngularAcceleration => QuantityOwner::Frame,
            Self::LinearMomentumRate | Self::InertiaForce | Self::Weight | Self::Force => QuantityOwner::Body,
            Self::AngularMomentum | Self::MomentumRate | Self::InertiaTorque | Self::Moment => QuantityOwner::RigidBody,
        }
    }

    /// Letter or word for the vector in publication files, such as `v` or `Hdot`.
    #[must_use]
    pub fn name(self) -> &'static str {
        Self::ALL[self as usize].1
    }

    /// Text of the vector with its owner but without a frame, such as `v(P)`. `of` is the index of the
    /// owner.
    #[must_use]
    pub fn text(self, model: &Model, of: usize) -> String {
        format!("{}({})", self.name(), self.owner_name(model, of))
    }

    /// Name of the vector's owner: the point, frame or body with the index `of` in the model.
    #[must_use]
    pub fn owner_name(self, model: &Model, of: usize) -> &str {
        match self.owner() {
            QuantityOwner::Point => &model.points[of].name,
            QuantityOwner::Frame => &model.frames[of].name,
            QuantityOwner::Body | QuantityOwner::RigidBody => &model.bodies[of].name,
        }
    }
}

/// Kind of a column of the equations of motion. The column has a value for each row, that is, for each speed or
/// coordinate.
///
/// The equations are Kane's F + F* = 0 or M u̇ = f, and Lagrange's E q̈ = A or d/dt ∂L/∂q̇ − ∂L/∂q = Q.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum RowQuantity {
    /// Generalized active force F of a generalized speed.
    ActiveForce,
    /// Generalized inertia force F* = −(M u̇ + …) of a generalized speed.
    InertiaForce,
    /// Forcing f of Kane's equations M u̇ = f.
    Forcing,
    /// Right-hand side A of Lagrange's equations E q̈ = A.
    LagrangeForcing,
    /// Velocity terms C q̇ of M q̈ + C q̇ + g = τ, which are quadratic in the rates.
    VelocityTerms,
    /// Derivative ∂V/∂q of the potential energy, which is g in M q̈ + C q̇ + g = τ.
    PotentialSlope,
    /// Generalized momentum ∂L/∂q̇, with no constraint substituted in L.
    Momentum,
    /// Rate d/dt ∂L/∂q̇ of the generalized momentum along the motion, linear in q̈.
    MomentumRate,
    /// Partial derivative ∂/∂t ∂L/∂q̇ of the generalized momentum with respect to time alone. The coordinates q and
    /// rates q̇ are held constant.
    HeldMomentumRate,
    /// Partial derivative ∂L/∂q of the Lagrangian, with q̇ constant.
    LagrangianSlope,
}

impl RowQuantity {
    /// All kinds of rows in the order of the variants, each with its name in publication files.
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

    /// True if the column has a row for each coordinate. False if it has a row for each generalized speed.
    pub(crate) const fn is_of_coordinates(self) -> bool {
        !matches!(self, Self::ActiveForce | Self::InertiaForce | Self::Forcing)
    }
}

/// Kind of an energy of the whole model, in J.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum EnergyQuantity {
    /// Kinetic energy T of all bodies.
    Kinetic,
    /// Kinetic energy of translation of all bodies, Σ ½ m v·v.
    Translation,
    /// Kinetic energy of rotation of all bodies, Σ ½ ω·I·ω.
    Rotation,
    /// Potential energy V of gravity and of all applied loads that have a potential.
    Potential,
    /// Potential energy of gravity alone; zero at the configuration that the model states.
    Gravity,
    /// Lagrangian L = T − V, kinetic less potential energy.
    Lagrangian,
    /// Total energy T + V, kinetic and potential.
    Total,
}

impl EnergyQuantity {
    /// True if the energy contains V, so that it has an arbitrary additive constant. False for kinetic energies.
    #[must_use]
    pub const fn has_a_zero(self) -> bool {
        matches!(self, Self::Potential | Self::Gravity | Self::Lagrangian | Self::Total)
    }

    /// All kinds of energies in the order of the variants, each with its name in publication files.
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

/// Scalar quantity that the model determines, with its indices. All indices (points, frames,
/// bodies, speeds, coordinates, rows, axes) count from 0.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum QuantityKind {
    /// Entry of the rotation matrix R, where components along frame `to` = R · components along frame
    /// `from`.
    Rotation {
        /// Index of the frame `from`, whose components R multiplies.
        from: usize,
        /// Index of the frame `to`, whose components result.
        to: usize,
        /// Row and column of the entry of R.
        entry: (usize, usize),
    },
    /// Component of a vector along an axis of a frame.
    Component {
        /// Kind of the vector, such as a velocity or a force.
        vector: VectorName,
        /// Index of the point, frame or body to which the vector belongs.
        of: usize,
        /// Index of the frame along whose axis the component is taken.
        frame: usize,
        /// Axis of the frame: 0, 1 or 2.
        axis: usize,
    },
    /// Component of the velocity, in the inertial frame, of a body's material at a point, m/s.
    MaterialVelocity {
        /// Index of the body whose material moves.
        body: usize,
        /// Index of the point at which the material is.
        point: usize,
        /// Index of the frame along whose axis the component is taken.
        frame: usize,
        /// Axis of the frame: 0, 1 or 2.
        axis: usize,
    },
    /// Component of a partial velocity: the derivative of a velocity with respect to a generalized speed.
    Partial {
        /// Kind of the vector: velocity of a point, or angular velocity of a frame.
        vector: VectorName,
        /// Index of the point or frame to which the velocity belongs.
        of: usize,
        /// Index of the frame along whose axis the component is taken.
        frame: usize,
        /// Axis of the frame: 0, 1 or 2.
        axis: usize,
        /// Index of the generalized speed.
        speed: usize,
    },
    /// Entry of a body's inertia tensor about its mass centre, kg m².
    Inertia {
        /// Index of the body in the model.
        body: usize,
        /// Index of the frame along whose axes the tensor is written.
        frame: usize,
        /// Row and column of the entry of the tensor.
        entry: (usize, usize),
    },
    /// Entry of a column of the equations of motion, as (kind of the column, index of the row).
    Row(RowQuantity, usize),
    /// Entry of Kane's mass matrix M, at (row, column).
    MassMatrix(usize, usize),
    /// Entry of the matrix E of Lagrange's equations E q̈ = A, at (row, column).
    LagrangeMatrix(usize, usize),
    /// Entry of the matrix C in the velocity terms C q̇, at (row, column). C is chosen by Christoffel symbols.
    Christoffel(usize, usize),
    /// Time derivative of an entry of the mass matrix ∂²T/∂q̇∂q̇ along the motion, at (row, column).
    MassRate(usize, usize),
    /// Energy of the model, J.
    Energy(EnergyQuantity),
    /// Generalized speed with this index, as its definition in q and q̇.
    Speed(usize),
    /// Time derivative q̇ of the coordinate with this index, as a term in q and u.
    Rate(usize),
    /// Time derivative u̇ of the speed with this index from the solved equations, as a term in q and u.
    SpeedRate(usize),
    /// Second time derivative q̈ of the coordinate with this index from the solved equations, as a term
    /// in q and u.
    SecondRate(usize),
}

impl QuantityKind {
    /// Canonical name of the quantity, such as `v(Cstar) @ B [1]`. Two quantities are equal if and only
    /// if their names are equal.
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
            Self::Row(row, at) => format!("{}[{}]", RowQuantity::ALL[row as usize].1, at + 1),
            Self::MassMatrix(i, j) => format!("M[{},{}]", i + 1, j + 1),
            Self::LagrangeMatrix(i, j) => format!("E[{},{}]", i + 1, j + 1),
            Self::Christoffel(i, j) => format!("C[{},{}]", i + 1, j + 1),
            Self::MassRate(i, j) => format!("Edot[{},{}]", i + 1, j + 1),
            Self::Energy(energy) => EnergyQuantity::ALL[energy as usize].1.to_owned(),
            Self::Speed(at) => model.speeds[at].name.clone(),
            Self::Rate(at) => format!("{}'", model.coordinates[at].name),
            Self::SpeedRate(at) => format!("{}'", model.speeds[at].name),
            Self::SecondRate(at) => format!("{}''", model.coordinates[at].name),
        }
    }
}

/// Scalar quantity that the model determines, such as `v(Cstar) @ B [1]`. It displays as its
/// canonical name.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Quantity {
    kind: QuantityKind,
    name: String,
}

impl Quantity {
    /// Creates the quantity of a kind in a model, with its canonical name.
    ///
    /// # Panics
    /// Panics if an index is outside the model's lists.
    #[must_use]
    pub fn new(kind: QuantityKind, model: &Model) -> Self {
        let name = kind.name(model);
        Self { kind, name }
    }

    /// Kind of the quantity, such as a velocity component, with its indices.
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
