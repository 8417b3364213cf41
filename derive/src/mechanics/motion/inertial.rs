//! The inertial parameters of a body: in these its kinetic energy and its weight are linear.

use crate::model::Unit;

/// An inertial parameter of a body, about a point of it, in axes fixed in it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Inertial {
    /// Mass m, kg.
    Mass,
    /// m times the place of the mass centre from the point, along an axis.
    FirstMoment(usize),
    /// An entry of the inertia tensor about the point; off the diagonal with its sign in the tensor, −∫ x y dm.
    Inertia(usize, usize),
}

impl Inertial {
    /// `m`, `mx`, `Ixy`: before the name of a body.
    #[must_use]
    pub fn letters(self) -> String {
        let axis = |i: usize| ["x", "y", "z"][i];
        match self {
            Self::Mass => "m".to_owned(),
            Self::FirstMoment(i) => format!("m{}", axis(i)),
            Self::Inertia(i, j) => format!("I{}{}", axis(i.min(j)), axis(i.max(j))),
        }
    }

    /// kg, kg m or kg m².
    #[must_use]
    pub fn unit(self) -> Unit {
        let lengths = match self {
            Self::Mass => 0,
            Self::FirstMoment(_) => 1,
            Self::Inertia(..) => 2,
        };
        Unit::new(lengths, 1, 0)
    }
}
