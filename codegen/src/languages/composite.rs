//! Functions of a module that call planned ones.

use tripos_derive::Equations;

/// Function that a dialect writes beside the planned ones, and that calls them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Composite {
    /// Solution of the linear system in numbers: the accelerations, then the reactions or multipliers.
    Unknowns,
    /// Reactions in numbers: the unknowns without the accelerations.
    Reactions,
    /// Projection of a state, or of a guess of a pose, onto the constraints.
    Project,
    /// Derivative of the state (q, v) as a function of time, state and parameters.
    StateDerivative,
    /// Matrix of the linear system of the state's derivative.
    StateMass,
    /// Right-hand side of the linear system of the state's derivative.
    StateForcing,
    /// Ordinary differential equation of the state.
    Ode,
    /// Semi-explicit differential-algebraic equation of the state and the unknowns.
    Dae,
}

impl Composite {
    /// Name of the function.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Unknowns => "unknowns",
            Self::Reactions => "reactions",
            Self::Project => "project",
            Self::StateDerivative => "state_derivative",
            Self::StateMass => "state_mass",
            Self::StateForcing => "state_forcing",
            Self::Ode => "ode",
            Self::Dae => "dae",
        }
    }

    /// Names of the planned functions that the function calls.
    #[must_use]
    pub const fn needs(self) -> &'static [&'static str] {
        match self {
            Self::Unknowns | Self::Reactions => &["mass_matrix", "forcing"],
            Self::Project => &["constraints", "constraint_slopes"],
            Self::StateDerivative | Self::Ode => &["derivative"],
            Self::StateMass => &["mass_matrix"],
            Self::StateForcing => &["forcing", "coordinate_rates"],
            Self::Dae => &["coordinate_rates", "residual"],
        }
    }

    /// True if the function makes sense for these equations. A mass matrix of the state has no place for reactions or
    /// multipliers, and only some formulations have reactions.
    #[must_use]
    pub fn suits(self, equations: &Equations) -> bool {
        let has_more = equations.unknowns.len() > equations.variables.len();
        match self {
            Self::StateMass | Self::StateForcing => !has_more,
            Self::Reactions => has_more && equations.formulation.carries_reactions(),
            Self::Unknowns | Self::Project | Self::StateDerivative | Self::Ode | Self::Dae => true,
        }
    }
}
