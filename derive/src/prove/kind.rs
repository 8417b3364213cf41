//! Kinds of first integrals, as data. Names in words are made from them, never the other way.

use crate::algebra::text::print::text;
use crate::algebra::{Arena, Expr, Node};
use crate::model::Model;

/// Conserved quantity of a first integral. Coordinates, bodies and axes are positions from 0; axes are of the inertial
/// frame unless another is named.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum IntegralKind {
    /// T + V, where no applied force works.
    Energy,
    /// T + V with the potential of the applied forces.
    EnergyOfForces,
    /// T + V less ∂T/∂t', where drives move the mechanism: Jacobi's integral, Σ q̇ ∂L/∂q̇ − L over the coordinates
    /// except time.
    Jacobi,
    /// The generalized momentum ∂L/∂q̇ of a coordinate.
    Coordinate(usize),
    /// The linear momentum of the whole along an axis.
    Linear(usize),
    /// The angular momentum of the whole about an axis through a point.
    Angular {
        /// The axis.
        axis: usize,
        /// The point.
        through: Pivot,
    },
    /// The linear momentum of one body along an axis.
    LinearOfBody {
        /// The body.
        body: usize,
        /// The axis.
        axis: usize,
    },
    /// The angular momentum of one body about an axis through its own mass centre.
    AngularOfBody {
        /// The body.
        body: usize,
        /// The axis.
        axis: usize,
    },
    /// The angular momentum of one rigid body about an axis of the frame that its inertia is stated in.
    Spin {
        /// The body.
        body: usize,
        /// The axis, of that frame.
        axis: usize,
    },
    /// The momentum of a symmetry q′ = ξ(q) that is none of these.
    Symmetry,
}

/// Point that an axis passes through.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Pivot {
    /// The mass centre of the whole.
    MassCentre,
    /// The origin of the inertial frame.
    Origin,
}

impl IntegralKind {
    /// True for T + V, with or without a potential of applied forces; false for momenta and Jacobi's integral.
    #[must_use]
    pub const fn is_energy(self) -> bool {
        matches!(self, Self::Energy | Self::EnergyOfForces)
    }

    /// Full description: a momentum with its definition, a symmetry with its components ξ, and the function of place
    /// that is added if it is not 0. The terms are in `arena`.
    #[must_use]
    pub fn words(self, model: &Model, arena: &Arena, xi: &[Expr], of_place: Expr) -> String {
        let (title, place) = (self.title(model), beside(arena, of_place));
        match self {
            Self::Coordinate(at) => {
                let coordinate = &model.coordinates[at].name;
                let defined = if place.is_empty() { String::new() } else { format!("{place}, where p_{coordinate}") };
                format!("{title}{defined} = ∂L/∂{coordinate}'")
            }
            Self::Symmetry => {
                let moved = model.coordinates.iter().zip(xi).filter(|(_, e)| **e != Expr::ZERO);
                let rates: Vec<String> = moved.map(|(c, e)| format!("{}' = {}", c.name, text(arena, *e))).collect();
                let comma = if place.is_empty() { "" } else { ", " };
                format!("{title} {}{comma}{place}", rates.join(", "))
            }
            _ => title + &place,
        }
    }

    /// Short name of the conserved quantity.
    #[must_use]
    pub fn title(self, model: &Model) -> String {
        let body = |at: usize| &model.bodies[at].name;
        match self {
            Self::Energy => "energy T + V".to_owned(),
            Self::EnergyOfForces => "energy T + V, the potential of the applied forces included".to_owned(),
            Self::Jacobi => "Jacobi's integral, the energy less what the drives give".to_owned(),
            Self::Coordinate(at) => format!("momentum p_{}", model.coordinates[at].name),
            Self::Linear(axis) => format!("linear momentum along {}", axis_name(model, 0, axis)),
            Self::Angular { axis, through } => {
                let through = match through {
                    Pivot::MassCentre => "the mass centre",
                    Pivot::Origin => &model.points[0].name,
                };
                format!("angular momentum about {} through {through}", axis_name(model, 0, axis))
            }
            Self::LinearOfBody { body: of, axis } => {
                format!("linear momentum of {} along {}", body(of), axis_name(model, 0, axis))
            }
            Self::AngularOfBody { body: of, axis } => {
                format!("angular momentum of {} about {} through its mass centre", body(of), axis_name(model, 0, axis))
            }
            Self::Spin { body: of, axis } => {
                let frame = model.bodies[of].rigid.as_ref().map_or(0, |(_, inertia)| inertia.frame);
                format!("angular momentum of {} about {}", body(of), axis_name(model, frame, axis))
            }
            Self::Symmetry => "momentum of the symmetry".to_owned(),
        }
    }

    /// The motion whose momentum it is: a shift, a rotation.
    #[must_use]
    pub fn motion(self, model: &Model) -> String {
        let body = |at: usize| &model.bodies[at].name;
        match self {
            Self::Energy | Self::EnergyOfForces | Self::Jacobi => "time".to_owned(),
            Self::Coordinate(at) => format!("a shift of {}", model.coordinates[at].name),
            Self::Linear(axis) => format!("a translation along {}", axis_name(model, 0, axis)),
            Self::Angular { axis, through } => {
                let through = match through {
                    Pivot::MassCentre => "the mass centre",
                    Pivot::Origin => &model.points[0].name,
                };
                format!("a rotation about {} through {through}", axis_name(model, 0, axis))
            }
            Self::LinearOfBody { body: of, axis } => {
                format!("a translation of {} along {}", body(of), axis_name(model, 0, axis))
            }
            Self::AngularOfBody { body: of, axis } => {
                format!("a rotation of {} about {} through its mass centre", body(of), axis_name(model, 0, axis))
            }
            Self::Spin { body: of, axis } => {
                let frame = model.bodies[of].rigid.as_ref().map_or(0, |(_, inertia)| inertia.frame);
                format!("a rotation of {} about {}", body(of), axis_name(model, frame, axis))
            }
            Self::Symmetry => "a motion along a symmetry".to_owned(),
        }
    }

    /// A short symbol for its value, such as `p_q3`, `P_n1` or `H_n3`; none if it has no customary one.
    pub(crate) fn symbol(self, model: &Model) -> Option<String> {
        match self {
            Self::Coordinate(at) => Some(format!("p_{}", model.coordinates[at].name)),
            Self::Linear(axis) => Some(format!("P_{}", axis_name(model, 0, axis))),
            Self::Angular { axis, .. } => Some(format!("H_{}", axis_name(model, 0, axis))),
            _ => None,
        }
    }
}

/// Text of the term that is added to a momentum, as in ` + c*x`; empty if it is 0.
pub(super) fn beside(arena: &Arena, of_place: Expr) -> String {
    let mut arena = arena.clone();
    let (content, rest) = arena.split_content(of_place);
    match arena.node(rest) {
        _ if of_place == Expr::ZERO => String::new(),
        Node::Sum(..) => format!(" + ({})", text(&arena, of_place)),
        _ if content.is_negative() => {
            let back = arena.neg(of_place);
            format!(" - {}", text(&arena, back))
        }
        _ => format!(" + {}", text(&arena, of_place)),
    }
}

/// `a1` for the first axis of frame A.
fn axis_name(model: &Model, frame: usize, axis: usize) -> String {
    format!("{}{}", model.frames[frame].name.to_lowercase(), axis + 1)
}
