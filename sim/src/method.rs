//! The methods by name.

use crate::control::Rules;
use crate::tolerance::Norm;

/// A method of integration.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Method {
    /// The classical Runge–Kutta method of order 4, with a fixed step only. W. Kutta, Z. Math. Phys. 46 (1901)
    /// 435–453.
    Rk4,
    /// Dormand–Prince 5(4) with the step control of `ode45`; see [`crate::DORMAND_PRINCE_54`].
    #[default]
    Ode45,
    /// Dormand–Prince 5(4) with the step control of Hairer's `dopri5`.
    Dopri5,
    /// Dormand–Prince 8(5,3) with the error estimate and the step control of Hairer's `dop853`; see
    /// [`crate::DORMAND_PRINCE_853`].
    Dop853,
    /// Gauss–Legendre collocation with three stages, of order 6: implicit, so that the right-hand side must bring its
    /// Jacobian; conserves quadratic invariants, and with a fixed step the energy in the long run. Events and output
    /// inside a step are far less exact than its ends: of order 3.
    Gauss6,
    /// Taylor's method, whose order follows from the tolerance; see [`Options::order`](crate::Options::order). The
    /// right-hand side must bring the Taylor coefficients of its solutions
    /// ([`RightHandSide::taylor`](crate::RightHandSide::taylor)). Steps are long and hardly ever rejected, and the
    /// solution inside them is as exact as at their ends.
    Taylor,
}

impl Method {
    /// All methods, in the order in which they are always listed.
    pub const ALL: [Self; 6] = [Self::Rk4, Self::Ode45, Self::Dopri5, Self::Dop853, Self::Gauss6, Self::Taylor];

    /// Those that ask for nothing but the right-hand side and its Jacobian.
    pub const WITHOUT_SERIES: [Self; 5] = [Self::Rk4, Self::Ode45, Self::Dopri5, Self::Dop853, Self::Gauss6];

    /// The name used on the command line, in files and in tables.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Rk4 => "rk4",
            Self::Ode45 => "ode45",
            Self::Dopri5 => "dopri5",
            Self::Dop853 => "dop853",
            Self::Gauss6 => "gauss6",
            Self::Taylor => "taylor",
        }
    }

    /// Order of the solution at the end of a step; nothing where it follows from the tolerance.
    #[must_use]
    pub const fn order(self) -> Option<u32> {
        match self {
            Self::Rk4 => Some(4),
            Self::Ode45 | Self::Dopri5 => Some(5),
            Self::Dop853 => Some(8),
            Self::Gauss6 => Some(6),
            Self::Taylor => None,
        }
    }

    /// Order of the solution inside a step; nothing where it follows from the tolerance.
    #[must_use]
    pub const fn dense_order(self) -> Option<u32> {
        match self {
            Self::Rk4 | Self::Gauss6 => Some(3),
            Self::Ode45 | Self::Dopri5 => Some(4),
            Self::Dop853 => Some(7),
            Self::Taylor => None,
        }
    }

    /// Whether the method estimates its error, and so can choose its steps.
    #[must_use]
    pub fn is_adaptive(self) -> bool {
        self.rules().is_some()
    }

    /// Whether fixed steps are what the method is usually run with.
    #[must_use]
    pub const fn has_fixed_use(self) -> bool {
        matches!(self, Self::Rk4 | Self::Gauss6)
    }

    /// Whether it is implicit, and needs the Jacobian of the right-hand side.
    #[must_use]
    pub const fn needs_jacobian(self) -> bool {
        matches!(self, Self::Gauss6)
    }

    /// Whether it needs the Taylor coefficients of the solutions.
    #[must_use]
    pub const fn needs_series(self) -> bool {
        matches!(self, Self::Taylor)
    }

    /// How step sizes follow from errors; `None` for a method that estimates no error.
    pub(crate) fn rules(self) -> Option<Rules> {
        match self {
            Self::Rk4 => None,
            Self::Ode45 => Some(Rules::Ode45 { order: 5 }),
            Self::Dopri5 => {
                let beta = 0.04;
                Some(Rules::Hairer { order: 5, exponent: 0.2 - 0.75 * beta, beta, shrink: 0.2, grow: 10.0 })
            }
            Self::Dop853 => Some(Rules::Hairer { order: 8, exponent: 0.125, beta: 0.0, shrink: 0.333, grow: 6.0 }),
            Self::Taylor => Some(Rules::Proposed),
            Self::Gauss6 => Some(Rules::Hairer { order: 6, exponent: 1.0 / 6.0, beta: 0.0, shrink: 0.2, grow: 4.0 }),
        }
    }

    pub(crate) fn norm(self) -> Norm {
        match self {
            Self::Ode45 | Self::Taylor => Norm::Largest,
            Self::Rk4 | Self::Dopri5 | Self::Dop853 | Self::Gauss6 => Norm::MeanSquare,
        }
    }
}
