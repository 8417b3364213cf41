//! Kinds of first integrals, as data, and their descriptions in words.

use crate::algebra::text::print::print_text;
use crate::algebra::{Arena, Expr, Node};
use crate::model::Model;

/// Kind of a first integral. Indices of coordinates, bodies and axes count from 0. Axes are those
/// of the inertial frame unless a variant names another frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum IntegralKind {
    /// Energy T + V of a model whose applied forces do no work.
    Energy,
    /// Energy T + V, where V includes the potential of the applied forces.
    EnergyOfForces,
    /// Jacobi's integral T + V − ∂T/∂t' of a mechanism that drives move, where t' is the rate of
    /// the time coordinate. It is Σ q̇ ∂L/∂q̇ − L over the coordinates except time.
    Jacobi,
    /// Generalized momentum ∂L/∂q̇ of the coordinate with this index.
    Coordinate(usize),
    /// Linear momentum of the whole system along the inertial axis with this index.
    Linear(usize),
    /// Angular momentum of the whole system about an inertial axis through a point.
    Angular {
        /// Axis of the inertial frame: 0, 1 or 2.
        axis: usize,
        /// Point through which the axis passes: the mass centre or the origin.
        through: Pivot,
    },
    /// Linear momentum of a single body along an inertial axis.
    LinearOfBody {
        /// Index of the body in the model.
        body: usize,
        /// Axis of the inertial frame: 0, 1 or 2.
        axis: usize,
    },
    /// Angular momentum of a single body about an inertial axis through its mass centre.
    AngularOfBody {
        /// Index of the body in the model.
        body: usize,
        /// Axis of the inertial frame: 0, 1 or 2.
        axis: usize,
    },
    /// Angular momentum of a single rigid body about an axis of the frame in which its inertia is
    /// stated.
    Spin {
        /// Index of the body in the model.
        body: usize,
        /// Axis of the frame in which the inertia is stated: 0, 1 or 2.
        axis: usize,
    },
    /// Momentum of a symmetry q′ = ξ(q) that none of the other kinds describes.
    Symmetry,
}

/// Point through which the axis of an angular momentum passes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Pivot {
    /// Mass centre of the whole system.
    MassCentre,
    /// Origin of the inertial frame.
    Origin,
}

impl IntegralKind {
    /// True for the energy T + V, with or without a potential of applied forces; false for momenta and
    /// Jacobi's integral.
    #[must_use]
    pub const fn is_energy(self) -> bool {
        matches!(self, Self::Energy | Self::EnergyOfForces)
    }

    /// Full description of an integral in words. A momentum is given with its definition, a
    /// symmetry with its components `xi`. If the function `of_place` of q is added to the momentum,
    /// it is given at the end. `arena` contains the terms.
    #[must_use]
    pub fn integral_description(self, model: &Model, arena: &Arena, xi: &[Expr], of_place: Expr) -> String {
        let (title, place) = (self.title(model), integral_addition_text(arena, of_place));
        match self {
            Self::Coordinate(at) => {
                let coordinate = &model.coordinates[at].name;
                let defined = if place.is_empty() { String::new() } else { format!("{place}, where p_{coordinate}") };
                format!("{title}{defined} = ∂L/∂{coordinate}'")
            }
            Self::Symmetry => {
                let moved = model.coordinates.iter().zip(xi).filter(|(_, e)| **e != Expr::ZERO);
                let rates: Vec<String> =
                    moved.map(|(c, e)| format!("{}' = {}", c.name, print_text(arena, *e))).collect();
                let comma = if place.is_empty() { "" } else { ", " };
                format!("{title} {}{comma}{place}", rates.join(", "))
            }
            _ => title + &place,
        }
    }

    /// Short name of the conserved quantity, such as `momentum p_q1`.
    #[must_use]
    pub fn title(self, model: &Model) -> String {
        let body = |at: usize| &model.bodies[at].name;
        match self {
            Self::Energy => "energy T + V".to_owned(),
            Self::EnergyOfForces => "energy T + V, the potential of the applied forces included".to_owned(),
            Self::Jacobi => "Jacobi's integral, the energy less what the drives give".to_owned(),
            Self::Coordinate(at) => format!("momentum p_{}", model.coordinates[at].name),
            Self::Linear(axis) => format!("linear momentum along {}", integral_axis_name(model, 0, axis)),
            Self::Angular { axis, through } => {
                let through = match through {
                    Pivot::MassCentre => "the mass centre",
                    Pivot::Origin => &model.points[0].name,
                };
                format!("angular momentum about {} through {through}", integral_axis_name(model, 0, axis))
            }
            Self::LinearOfBody { body: of, axis } => {
                format!("linear momentum of {} along {}", body(of), integral_axis_name(model, 0, axis))
            }
            Self::AngularOfBody { body: of, axis } => {
                format!(
                    "angular momentum of {} about {} through its mass centre",
                    body(of),
                    integral_axis_name(model, 0, axis)
                )
            }
            Self::Spin { body: of, axis } => {
                let frame = model.bodies[of].rigid.as_ref().map_or(0, |(_, inertia)| inertia.frame);
                format!("angular momentum of {} about {}", body(of), integral_axis_name(model, frame, axis))
            }
            Self::Symmetry => "momentum of the symmetry".to_owned(),
        }
    }

    /// Motion to which the conserved momentum belongs, in words, such as `a translation along n1`.
    #[must_use]
    pub fn motion(self, model: &Model) -> String {
        let body = |at: usize| &model.bodies[at].name;
        match self {
            Self::Energy | Self::EnergyOfForces | Self::Jacobi => "time".to_owned(),
            Self::Coordinate(at) => format!("a shift of {}", model.coordinates[at].name),
            Self::Linear(axis) => format!("a translation along {}", integral_axis_name(model, 0, axis)),
            Self::Angular { axis, through } => {
                let through = match through {
                    Pivot::MassCentre => "the mass centre",
                    Pivot::Origin => &model.points[0].name,
                };
                format!("a rotation about {} through {through}", integral_axis_name(model, 0, axis))
            }
            Self::LinearOfBody { body: of, axis } => {
                format!("a translation of {} along {}", body(of), integral_axis_name(model, 0, axis))
            }
            Self::AngularOfBody { body: of, axis } => {
                format!(
                    "a rotation of {} about {} through its mass centre",
                    body(of),
                    integral_axis_name(model, 0, axis)
                )
            }
            Self::Spin { body: of, axis } => {
                let frame = model.bodies[of].rigid.as_ref().map_or(0, |(_, inertia)| inertia.frame);
                format!("a rotation of {} about {}", body(of), integral_axis_name(model, frame, axis))
            }
            Self::Symmetry => "a motion along a symmetry".to_owned(),
        }
    }

    /// Short symbol for the value of the integral, such as `p_q3`, `P_n1` or `H_n3`. `None` if
    /// there is no customary symbol.
    pub(crate) fn symbol(self, model: &Model) -> Option<String> {
        match self {
            Self::Coordinate(at) => Some(format!("p_{}", model.coordinates[at].name)),
            Self::Linear(axis) => Some(format!("P_{}", integral_axis_name(model, 0, axis))),
            Self::Angular { axis, .. } => Some(format!("H_{}", integral_axis_name(model, 0, axis))),
            _ => None,
        }
    }
}

/// Text of a term that is added to a momentum, such as ` + c*x`; empty if the term is 0.
pub(super) fn integral_addition_text(arena: &Arena, of_place: Expr) -> String {
    let mut arena = arena.clone();
    let (content, rest) = arena.split_content(of_place);
    match arena.node(rest) {
        _ if of_place == Expr::ZERO => String::new(),
        Node::Sum(..) => format!(" + ({})", print_text(&arena, of_place)),
        _ if content.is_negative() => {
            let back = arena.neg(of_place);
            format!(" - {}", print_text(&arena, back))
        }
        _ => format!(" + {}", print_text(&arena, of_place)),
    }
}

/// Name of an axis of a frame, such as `a1` for axis 0 of frame A.
fn integral_axis_name(model: &Model, frame: usize, axis: usize) -> String {
    format!("{}{}", model.frames[frame].name.to_lowercase(), axis + 1)
}
