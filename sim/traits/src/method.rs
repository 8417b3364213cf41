//! Methods of numerical integration by name, for scenes and for the simulator.
//!
//! The list is complete: a change that adds a method also adds the code that runs it.

/// Method of numerical integration, by which a run steps in time.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Method {
    /// Classical Runge–Kutta method of order 4, with a fixed step only. W. Kutta, Z. Math. Phys. 46
    /// (1901) 435–453.
    Rk4,
    /// Dormand–Prince 5(4) with the step control of `ode45`. Its coefficients are the constant
    /// `DORMAND_PRINCE_54` of the integrators.
    #[default]
    Ode45,
    /// Dormand–Prince 5(4) with the step control of Hairer's `dopri5`.
    Dopri5,
    /// Dormand–Prince 8(5,3) with the error estimate and the step control of Hairer's `dop853`. Its
    /// coefficients are the constant `DORMAND_PRINCE_853` of the integrators.
    Dop853,
    /// Gauss–Legendre collocation with three stages, of order 6. Implicit, so the right-hand side must
    /// provide its Jacobian. Conserves quadratic invariants and, with a fixed step, the energy in the
    /// long run. Events and output inside a step are far less exact than at its ends: of order 3.
    Gauss6,
    /// Radau IIA collocation with three stages, of order 5, with the error estimate and the step
    /// control of Hairer's `radau5`. Implicit, so the right-hand side must provide its Jacobian. A- and
    /// L-stable, for stiff equations. Events and output inside a step are less exact than at its ends:
    /// of order 3.
    Radau5,
    /// Taylor's method, whose order is chosen from the tolerance (or by the option `order`). The
    /// right-hand side must provide the Taylor coefficients of its solutions (`RightHandSide::taylor`).
    /// Steps are long and rarely rejected, and the solution inside a step is as exact as at its ends.
    Taylor,
}

impl Method {
    /// All methods, in the order in which every list shows them.
    pub const ALL: [Self; 7] =
        [Self::Rk4, Self::Ode45, Self::Dopri5, Self::Dop853, Self::Gauss6, Self::Radau5, Self::Taylor];

    /// Methods that need only the right-hand side and its Jacobian, but no Taylor coefficients.
    pub const WITHOUT_SERIES: [Self; 6] =
        [Self::Rk4, Self::Ode45, Self::Dopri5, Self::Dop853, Self::Gauss6, Self::Radau5];

    /// Name of the method on the command line, in files and in tables, such as `rk4`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Rk4 => "rk4",
            Self::Ode45 => "ode45",
            Self::Dopri5 => "dopri5",
            Self::Dop853 => "dop853",
            Self::Gauss6 => "gauss6",
            Self::Radau5 => "radau5",
            Self::Taylor => "taylor",
        }
    }

    /// Order of the solution at the end of a step; `None` for Taylor's method, whose order is chosen
    /// from the tolerance.
    #[must_use]
    pub const fn order(self) -> Option<u32> {
        match self {
            Self::Rk4 => Some(4),
            Self::Ode45 | Self::Dopri5 | Self::Radau5 => Some(5),
            Self::Dop853 => Some(8),
            Self::Gauss6 => Some(6),
            Self::Taylor => None,
        }
    }

    /// Order of the solution inside a step; `None` for Taylor's method, whose order is chosen from the
    /// tolerance.
    #[must_use]
    pub const fn dense_order(self) -> Option<u32> {
        match self {
            Self::Rk4 | Self::Gauss6 | Self::Radau5 => Some(3),
            Self::Ode45 | Self::Dopri5 => Some(4),
            Self::Dop853 => Some(7),
            Self::Taylor => None,
        }
    }

    /// True if the method estimates its error, and so can choose its step lengths.
    #[must_use]
    pub const fn is_adaptive(self) -> bool {
        !matches!(self, Self::Rk4)
    }

    /// True if the method is usually run with a fixed step length, even if it can choose its steps.
    #[must_use]
    pub const fn has_fixed_use(self) -> bool {
        matches!(self, Self::Rk4 | Self::Gauss6)
    }

    /// True if the method is implicit, so that it needs the Jacobian of the right-hand side.
    #[must_use]
    pub const fn needs_jacobian(self) -> bool {
        matches!(self, Self::Gauss6 | Self::Radau5)
    }

    /// True if the method needs the Taylor coefficients of the solutions.
    #[must_use]
    pub const fn needs_series(self) -> bool {
        matches!(self, Self::Taylor)
    }
}
