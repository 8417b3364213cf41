//! Inertial parameters of a body, in which its kinetic energy and its weight are linear.

use crate::model::Unit;

/// Inertial parameter of a body, about a point of the body, in body-fixed axes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Inertial {
    /// Mass m, kg.
    Mass,
    /// Mass times the coordinate of the mass centre from the point, along an axis 0 to 2, kg m.
    FirstMoment(usize),
    /// Entry of the inertia tensor about the point, kg m². Off the diagonal it has the tensor's sign, −∫ x y dm.
    Inertia(usize, usize),
}

impl Inertial {
    /// Letters of the parameter before the name of a body: `m`, `mx`, `Ixy`.
    #[must_use]
    pub fn letters(self) -> String {
        let axis = |i: usize| ["x", "y", "z"][i];
        match self {
            Self::Mass => "m".to_owned(),
            Self::FirstMoment(i) => format!("m{}", axis(i)),
            Self::Inertia(i, j) => format!("I{}{}", axis(i.min(j)), axis(i.max(j))),
        }
    }

    /// Unit of the parameter: kg, kg m or kg m².
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
