//! Inertial parameters of a body: mass, first moments, and inertia or second moments. The kinetic energy and the weight
//! of the body are linear in them.

use crate::model::Unit;

/// Inertial parameter of a body. First moments and inertia are about a reference point of the body, along body-fixed
/// axes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum InertialParameter {
    /// Mass m of the body, kg.
    Mass,
    /// First moment m x, kg m, along axis 0, 1 or 2: the mass times the component of the vector from the reference
    /// point to the mass centre.
    FirstMoment(usize),
    /// Entry (row, column) of the inertia tensor about the reference point, kg m². Off the diagonal it has the sign
    /// of the tensor, −∫ x y dm.
    Inertia(usize, usize),
    /// Second moment ∫ x² dm along axis 0, 1 or 2, kg m², where x is the component of the vector from the reference
    /// point. The moment of inertia about an axis is the sum of the second moments along the other two axes.
    SecondMoment(usize),
}

impl InertialParameter {
    /// Symbol of the parameter without the name of the body, such as `m`, `mx` or `Ixy`.
    #[must_use]
    pub fn parameter_symbol(self) -> String {
        let axis = |i: usize| ["x", "y", "z"][i];
        match self {
            Self::Mass => "m".to_owned(),
            Self::FirstMoment(i) => format!("m{}", axis(i)),
            Self::Inertia(i, j) => format!("I{}{}", axis(i.min(j)), axis(i.max(j))),
            Self::SecondMoment(i) => format!("S{}{}", axis(i), axis(i)),
        }
    }

    /// Unit of the inertial parameter: kg, kg m or kg m².
    #[must_use]
    pub fn unit(self) -> Unit {
        let lengths = match self {
            Self::Mass => 0,
            Self::FirstMoment(_) => 1,
            Self::Inertia(..) | Self::SecondMoment(_) => 2,
        };
        Unit::new(lengths, 1, 0)
    }
}
